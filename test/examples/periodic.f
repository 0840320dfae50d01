C     periodic.f - the Delaunay tetrahedralization of a box that repeats
C     itself: a recipe to copy.
C
C       PERIOD  tetrahedra and neighbours, with the copies of the box
C               that they are in (PECOPI, PEBALL, PECERT, PEFACI)
C       UNPACK  the copy of the box from its number
C
C     try_periodic.f tests it; periodic.c is the same in C.

C     UNPACK - copies of the box are numbered 1024*A + 32*B + C; A, B, C
C     = -REACH ... REACH box lengths along the axes: numbers add up as
C     the copies do, and ascend in an order that no translation alters.
      SUBROUTINE UNPACK(NUMBER, COPY)
      INTEGER NUMBER, COPY(3)
      INTEGER REST
      REST = NUMBER + 16*(1024 + 32 + 1)
      COPY(1) = REST/1024 - 16
      COPY(2) = MOD(REST/32, 32) - 16
      COPY(3) = MOD(REST, 32) - 16
      END

C     PECOPI - of all points that are less than MARGIN from the box,
C     ordered by point, then by copy.  Points and lengths are rounded to
C     multiples of a power of two, UNIT, that is so large that the
C     copies need no rounding.
      SUBROUTINE PECOPI(N, P, BOX, MARGIN, MAXCOP, NCOP, X, WHO, COPY,
     1                  MINE, INFO)
      INTEGER N, MAXCOP, NCOP, WHO(*), COPY(*), MINE(*), INFO
      DOUBLE PRECISION P(3,*), BOX(2,3), MARGIN, X(3,*)
      DOUBLE PRECISION SIZE, UNIT, R(3), SIDE(3)
      INTEGER I, K, FIRST(3), LAST(3), A, B, C, REACH
      DOUBLE PRECISION LEAST, MOST
      PARAMETER (REACH = 7, LEAST = 2.0D0**(-970))
      PARAMETER (MOST = 2.0D0**1018)
      INFO = 6
      SIZE = 0.0D0
      DO 10 K = 1, 3
         IF (.NOT. (ABS(BOX(1,K)) .LT. MOST .AND.
     1       ABS(BOX(2,K)) .LT. MOST)) RETURN
         SIZE = MAX(SIZE,
     1              ABS(BOX(1,K)) + (REACH + 1)*(BOX(2,K) - BOX(1,K)))
   10 CONTINUE
      IF (.NOT. (SIZE .GE. LEAST)) RETURN
C     2**(K-1) <= SIZE < 2**K: the logarithm may be wrong by one.
      K = INT(LOG(SIZE) / LOG(2.0D0) + 1075.0D0) - 1074
      IF (2.0D0**K .LE. SIZE) K = K + 1
      IF (2.0D0**(K-1) .GT. SIZE) K = K - 1
      UNIT = 2.0D0**(K-53)
      DO 20 K = 1, 3
         SIDE(K) = ANINT((BOX(2,K) - BOX(1,K)) / UNIT)*UNIT
   20 CONTINUE
      NCOP = 0
      DO 80 I = 1, N
         DO 30 K = 1, 3
            R(K) = P(K,I)
            INFO = -2
            IF (.NOT. (R(K) .GE. BOX(1,K) .AND. R(K) .LE. BOX(2,K)))
     1         RETURN
            R(K) = ANINT(R(K) / UNIT)*UNIT
            INFO = 20
            SIZE = (R(K) - BOX(1,K) + MARGIN) / SIDE(K)
            IF (.NOT. (SIZE .LT. REACH + 1)) RETURN
            FIRST(K) = -INT(SIZE)
            SIZE = (BOX(2,K) + MARGIN - R(K)) / SIDE(K)
            IF (.NOT. (SIZE .LT. REACH + 1)) RETURN
            LAST(K) = INT(SIZE)
   30    CONTINUE
         DO 70 A = FIRST(1), LAST(1)
            DO 60 B = FIRST(2), LAST(2)
               DO 50 C = FIRST(3), LAST(3)
                  INFO = 1
                  IF (NCOP .EQ. MAXCOP) RETURN
                  NCOP = NCOP + 1
                  X(1,NCOP) = R(1) + A*SIDE(1)
                  X(2,NCOP) = R(2) + B*SIDE(2)
                  X(3,NCOP) = R(3) + C*SIDE(3)
                  WHO(NCOP) = I
                  COPY(NCOP) = 1024*A + 32*B + C
                  MINE(NCOP) = 0
                  IF (COPY(NCOP) .EQ. 0) MINE(NCOP) = 1
   50          CONTINUE
   60       CONTINUE
   70    CONTINUE
   80 CONTINUE
      INFO = 0
      END

C     PEBALL - of the tetrahedron V: TESSBA's where it is so flat that
C     three digits of its centre are lost, else from its edges, which is
C     ten times as fast; these in units of a length, or products would
C     be beyond numbers.
      SUBROUTINE PEBALL(X, V, UNIT, C, INFO)
      DOUBLE PRECISION X(3,*), UNIT, C(4)
      INTEGER V(4), INFO
      DOUBLE PRECISION E(3,3), F(3), SQUARE(3), DET
      INTEGER A, B, I, K
      DO 20 I = 1, 3
         DO 10 K = 1, 3
            E(K,I) = (X(K,V(I+1)) - X(K,V(1))) / UNIT
   10    CONTINUE
         SQUARE(I) = E(1,I)**2 + E(2,I)**2 + E(3,I)**2
         C(I) = 0.0D0
   20 CONTINUE
      DET = 0.0D0
      DO 40 I = 1, 3
         A = MOD(I, 3) + 1
         B = MOD(I + 1, 3) + 1
         DO 30 K = 1, 3
            F(K) = E(MOD(K, 3)+1,A)*E(MOD(K+1, 3)+1,B) -
     1             E(MOD(K+1, 3)+1,A)*E(MOD(K, 3)+1,B)
            C(K) = C(K) + SQUARE(I)*F(K)
   30    CONTINUE
         IF (I .EQ. 1) DET = E(1,1)*F(1) + E(2,1)*F(2) + E(3,1)*F(3)
   40 CONTINUE
      IF (.NOT. (DET*DET .GT. 1.0D-6*SQUARE(1)*SQUARE(2)*SQUARE(3)))
     1   THEN
         CALL TESSBA(X, V, C, INFO)
         RETURN
      END IF
      INFO = 0
      C(4) = 0.0D0
      DO 50 K = 1, 3
         C(K) = C(K) / (2.0D0*DET)
         C(4) = C(4) + C(K)**2
         C(K) = C(K)*UNIT + X(K,V(1))
   50 CONTINUE
      C(4) = SQRT(C(4))*UNIT
      END

C     PECERT - GOOD = 1 if all copies that could be in a tetrahedron's
C     ball are there; a part in a thousand of the margin is for
C     roundings.
      SUBROUTINE PECERT(X, NTET, TET, ADJ, BOX, MARGIN, GOOD)
      DOUBLE PRECISION X(3,*), BOX(2,3), MARGIN
      INTEGER NTET, TET(4,*), ADJ(4,*), GOOD
      DOUBLE PRECISION C(4)
      INTEGER K, T, INFO
      GOOD = 0
      DO 20 T = 1, NTET
         CALL PEBALL(X, TET(1,T), MARGIN, C, INFO)
         IF (INFO .NE. 0) RETURN
         DO 10 K = 1, 3
            IF (.NOT. (C(K) - C(4) .GT. BOX(1,K) - 0.999D0*MARGIN .AND.
     1          C(K) + C(4) .LT. BOX(2,K) + 0.999D0*MARGIN)) RETURN
   10    CONTINUE
         IF (ADJ(1,T) .EQ. 0 .OR. ADJ(2,T) .EQ. 0 .OR. ADJ(3,T) .EQ. 0
     1       .OR. ADJ(4,T) .EQ. 0) RETURN
   20 CONTINUE
      GOOD = 1
      END

C     PEFACI - YES = 1 if facet K of tetrahedron T and facet L of U are
C     the same but for translation, by SHIFT from the copy of U to that
C     of T: if their points are, in the order of point and copy, which
C     no translation alters.
      SUBROUTINE PEFACI(TET, MOVE, T, K, U, L, SHIFT, YES)
      INTEGER TET(4,*), MOVE(4,*), T, K, U, L, SHIFT, YES
      INTEGER V(3,2), C(3,2), A, B, H, I, J, M, S
      DO 40 M = 1, 2
         S = T
         IF (M .EQ. 2) S = U
         DO 5 J = 1, 3
            V(J,M) = 0
            C(J,M) = 0
    5    CONTINUE
         J = 0
         DO 30 H = 1, 4
            IF (M .EQ. 1 .AND. H .EQ. K) GO TO 30
            IF (M .EQ. 2 .AND. H .EQ. L) GO TO 30
            A = TET(H,S)
            B = MOVE(H,S)
            J = J + 1
            I = J
   10       CONTINUE
            IF (I .EQ. 1) GO TO 20
            IF (V(I-1,M) .LT. A .OR. (V(I-1,M) .EQ. A .AND.
     1          C(I-1,M) .LT. B)) GO TO 20
            V(I,M) = V(I-1,M)
            C(I,M) = C(I-1,M)
            I = I - 1
            GO TO 10
   20       CONTINUE
            V(I,M) = A
            C(I,M) = B
   30    CONTINUE
   40 CONTINUE
      YES = 0
      SHIFT = C(1,1) - C(1,2)
      DO 50 H = 1, 3
         IF (V(H,1) .NE. V(H,2) .OR. C(H,1) - C(H,2) .NE. SHIFT) RETURN
   50 CONTINUE
      YES = 1
      END

C     PERIOD - the tetrahedra of the points and all their copies, one of
C     each that are copies of each other.
C
C       N, P     (in)   N >= 1 points in the box, its boundary included
C       BOX      (in)   (6): X0, X1, Y0, Y1, Z0, Z1, X0 < X1
C       MAXCOP   (in)   copies that there is room for: 3*N if N is
C                       large, 343 for one point
C       NCOP     (out)  copies made
C       X        (out)  (3,MAXCOP): workspace
C       CW       (out)  (MAXCOP,3): workspace
C       MAXTET   (in)   tetrahedra that there is room for: 10*N if N is
C                       large
C       NTET     (out)  number of tetrahedra
C       TET      (out)  (4,MAXTET): points, positively oriented
C       MOVE     (out)  (4,MAXTET): the copies of the box that they are
C                       in; that of the first one, by number, is the box
C                       itself
C       ADJ      (out)  (4,MAXTET): neighbours
C       SHIFT    (out)  (4,MAXTET): the copy that the neighbour is to be
C                       taken from, MOVE(K,T) + SHIFT: so that it shares
C                       the facet
C       LIW, IW, LRW, RW   as in TESS, for MAXCOP points
C       INFO     (out)  0; 1, MAXCOP being too small, with NCOP =
C                       MAXCOP, or MAXTET; 2 as TESS; 20 where so few
C                       points are in a box so long that tetrahedra
C                       reach farther than REACH boxes; -1 for N < 1, -2
C                       for a point that is not in the box, or NaN; -3
C                       for a box that is none; 6 for one so large that
C                       its copies are beyond numbers, or so small that
C                       these would have to be rounded; what TESSIX and
C                       TESSPA return
C
C     A margin about the box is filled with copies, and those tetrahedra
C     computed that have a point of the box itself.  Where a ball is
C     within the margin no copy that is not there can be in it: the
C     tetrahedron is right.  If one is not, the margin is made wider.
C     Kept are the tetrahedra whose first point is in the box itself:
C     one of each class.
C
C     Of cospherical points the order decides, so the order must be the
C     same in all copies: by point, then by copy.  With copies put after
C     the originals a sphere of points in the box has another first
C     point than its copy across the boundary: both triangulate it, each
C     in its way, and what they have in common does not fit: lattices
C     come out with volumes that are off by a tenth.  For the same
C     reason copies must not be rounded one by one.
C
C     Cost: 1.7 times that of TESS for 10,000 points, less for more: the
C     margin is about three points wide.
      SUBROUTINE PERIOD(N, P, BOX, MAXCOP, NCOP, X, CW, MAXTET, NTET,
     1                  TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW, INFO)
      INTEGER N, MAXCOP, NCOP, CW(MAXCOP,3), MAXTET, NTET, TET(4,*)
      INTEGER MOVE(4,*), ADJ(4,*), SHIFT(4,*), LIW, IW(*), LRW, INFO
      DOUBLE PRECISION P(3,*), BOX(2,3), X(3,*), RW(*)
      DOUBLE PRECISION MARGIN
      INTEGER F, G, I, K, L, T, U, S, FROM, KEPT, GOOD
      NTET = 0
      INFO = -1
      IF (N .LT. 1) RETURN
C     (The box's volume could be too large or too small for a double.)
      MARGIN = 3.0D0*DBLE(N)**(-1.0D0 / 3.0D0)
      DO 5 K = 1, 3
         INFO = -3
         IF (.NOT. (BOX(1,K) .LT. BOX(2,K))) RETURN
         MARGIN = MARGIN*(BOX(2,K) - BOX(1,K))**(1.0D0 / 3.0D0)
    5 CONTINUE
   10 CONTINUE
      CALL PECOPI(N, P, BOX, MARGIN, MAXCOP, NCOP, X, CW, CW(1,2),
     1            CW(1,3), INFO)
      IF (INFO .NE. 0) RETURN
      CALL TESSIX(NCOP, X, LIW, IW, LRW, RW, INFO)
      NTET = 0
      GOOD = 0
      IF (INFO .LT. 3 .OR. INFO .GT. 5) THEN
         IF (INFO .EQ. 0) CALL TESSPA(NCOP, X, CW(1,3), MAXTET, NTET,
     1                                TET, ADJ, LIW, IW, LRW, RW, INFO)
         IF (INFO .NE. 0) THEN
            NTET = 0
            RETURN
         END IF
         CALL PECERT(X, NTET, TET, ADJ, BOX, MARGIN, GOOD)
      END IF
      IF (GOOD .EQ. 0) THEN
         MARGIN = 1.5D0*MARGIN
         GO TO 10
      END IF
      KEPT = 0
      DO 30 T = 1, NTET
         I = MIN(TET(1,T), TET(2,T), TET(3,T), TET(4,T))
         IF (CW(I,2) .NE. 0) GO TO 30
         KEPT = KEPT + 1
         DO 20 K = 1, 4
            I = TET(K,T)
            TET(K,KEPT) = CW(I,1)
            MOVE(K,KEPT) = CW(I,2)
   20    CONTINUE
   30 CONTINUE
      NTET = KEPT
C     Facets that wait for their other side, in lists by the sum of
C     their points, linked in ADJ: 4*(T-1) + K for facet K of T.
      DO 40 I = 1, N
         CW(I,3) = 0
   40 CONTINUE
      DO 80 T = 1, NTET
         DO 70 K = 1, 4
            F = 4*(T-1) + K
            I = 0
            DO 50 L = 1, 4
               IF (L .NE. K) I = MOD(I + TET(L,T) - 1, N)
   50       CONTINUE
            I = I + 1
            FROM = 0
            G = CW(I,3)
   60       CONTINUE
            IF (G .EQ. 0) THEN
               ADJ(K,T) = CW(I,3)
               CW(I,3) = F
               GO TO 70
            END IF
            U = (G-1)/4 + 1
            L = G - 4*(U-1)
            CALL PEFACI(TET, MOVE, T, K, U, L, S, GOOD)
            IF (GOOD .EQ. 0) THEN
               FROM = G
               G = ADJ(L,U)
               GO TO 60
            END IF
            IF (FROM .EQ. 0) THEN
               CW(I,3) = ADJ(L,U)
            ELSE
               ADJ(MOD(FROM-1, 4)+1,(FROM-1)/4+1) = ADJ(L,U)
            END IF
            ADJ(K,T) = U
            ADJ(L,U) = T
            SHIFT(K,T) = S
            SHIFT(L,U) = -S
   70    CONTINUE
   80 CONTINUE
      INFO = 0
      END
