C     periodic.f - the Delaunay tetrahedralization of a box, or any cell
C     that three vectors span, that repeats itself, along all of them or
C     some: recipes to copy.
C
C       TRPERI  tetrahedra and neighbours, with the copies of the box
C               that they are in (all that is here, but for TRREDU)
C       TRTRIC  the same of a cell                  (all but for TRREDU)
C       TRREDU  short vectors that span the same lattice  (TRDOT3)
C       TRUNPA  the copy of the box from its number
C
C     t_periodic.c tests them; periodic.c is the same in C.

C     TRUNPA - copies of the box are numbered 1024*A + 32*B + C; A, B, C
C     = -REACH ... REACH box lengths along the axes: numbers add up as
C     the copies do, and ascend in an order that no translation alters.
      SUBROUTINE TRUNPA(NUMBER, COPY)
      INTEGER NUMBER, COPY(3)
      INTEGER REST
      REST = NUMBER + 16*(1024 + 32 + 1)
      COPY(1) = REST/1024 - 16
      COPY(2) = MOD(REST/32, 32) - 16
      COPY(3) = MOD(REST, 32) - 16
      END

      DOUBLE PRECISION FUNCTION TRDOT3(A, B)
      DOUBLE PRECISION A(3), B(3)
      TRDOT3 = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

C     TRFLOP - the largest integer that is not larger than X.
      INTEGER FUNCTION TRFLOP(X)
      DOUBLE PRECISION X
      TRFLOP = INT(X)
      IF (DBLE(TRFLOP) .GT. X) TRFLOP = TRFLOP - 1
      END

C     TRLESS - A, without its part along B, which may be 0.
      SUBROUTINE TRLESS(A, B)
      DOUBLE PRECISION A(3), B(3)
      DOUBLE PRECISION TRDOT3, S
      INTEGER K
      S = TRDOT3(B, B)
      IF (S .GT. 0.0D0) S = TRDOT3(A, B) / S
      DO 10 K = 1, 3
         A(K) = A(K) - S*B(K)
   10 CONTINUE
      END

C     TRACRO - for each vector of the cell that it repeats itself along,
C     of the others 0: HEIGHT, the distance of the planes between which
C     all places are less than one such vector apart, and G, at right
C     angles to them, whose product with a difference of places says how
C     many vectors there are between them.  INFO is 0, or 1 for what is
C     no cell, or one flatter than 1D-6.
      SUBROUTINE TRACRO(CELL, WAYS, G, HEIGHT, INFO)
      DOUBLE PRECISION CELL(3,4), G(3,3), HEIGHT(3)
      INTEGER WAYS(3), INFO
      DOUBLE PRECISION U(3,3), B(3), SIZE(3), MOST, S, TRDOT3
      INTEGER J, K
      INFO = 1
      DO 30 K = 1, 3
         MOST = MAX(ABS(CELL(1,K)), ABS(CELL(2,K)), ABS(CELL(3,K)))
         IF (WAYS(K) .NE. 0 .AND. .NOT. (MOST .GT. 0.0D0)) RETURN
         DO 10 J = 1, 3
            U(J,K) = 0.0D0
            IF (WAYS(K) .NE. 0) U(J,K) = CELL(J,K) / MOST
   10    CONTINUE
         S = SQRT(TRDOT3(U(1,K), U(1,K)))
         DO 20 J = 1, 3
            IF (WAYS(K) .NE. 0) U(J,K) = U(J,K) / S
   20    CONTINUE
         SIZE(K) = MOST*S
   30 CONTINUE
      DO 60 K = 1, 3
         DO 40 J = 1, 3
            B(J) = U(J,MOD(K+1, 3)+1)
            G(J,K) = U(J,K)
   40    CONTINUE
         CALL TRLESS(B, U(1,MOD(K, 3)+1))
         CALL TRLESS(G(1,K), U(1,MOD(K, 3)+1))
         CALL TRLESS(G(1,K), B)
         S = TRDOT3(G(1,K), G(1,K))
         HEIGHT(K) = 0.0D0
         IF (WAYS(K) .EQ. 0) GO TO 60
         IF (.NOT. (S .GT. 1.0D-12)) RETURN
         DO 50 J = 1, 3
            G(J,K) = G(J,K) / (S*SIZE(K))
   50    CONTINUE
         HEIGHT(K) = SQRT(S)*SIZE(K)
   60 CONTINUE
      INFO = 0
      END

C     TRCOPI - of all points that are less than MARGIN from the cell,
C     ordered by point, then by copy.  Points and vectors, SIDE, are
C     rounded to multiples of a power of two, UNIT, that is so large
C     that the copies need no rounding.
      SUBROUTINE TRCOPI(N, P, CELL, WAYS, G, HEIGHT, MARGIN, MAXCOP,
     1                  NCOP, X, WHO, COPY, MINE, SIDE, UNIT, INFO)
      INTEGER N, WAYS(3), MAXCOP, NCOP, WHO(*), COPY(*), MINE(*), INFO
      DOUBLE PRECISION P(3,*), CELL(3,4), G(3,3), HEIGHT(3), MARGIN
      DOUBLE PRECISION X(3,*), SIDE(3,3), UNIT
      DOUBLE PRECISION SIZE, SUM, R(3), E(3), S, T, TRDOT3
      INTEGER I, K, FIRST(3), LAST(3), A, B, C, TRFLOP, REACH
      DOUBLE PRECISION LEAST, MOST
      PARAMETER (REACH = 7, LEAST = 2.0D0**(-970))
      PARAMETER (MOST = 2.0D0**1018)
      SIZE = 0.0D0
      DO 30 K = 1, 3
         SUM = 0.0D0
         DO 10 I = 1, 3
            IF (WAYS(I) .NE. 0) SUM = SUM + ABS(CELL(K,I))
   10    CONTINUE
         INFO = -2
         DO 20 I = 1, N
            R(1) = ABS(P(K,I))
            IF (R(1) .NE. R(1)) RETURN
            SIZE = MAX(SIZE, R(1) + (REACH + 2)*SUM)
   20    CONTINUE
         INFO = 6
         IF (.NOT. (ABS(CELL(K,4)) .LT. MOST)) RETURN
   30 CONTINUE
      IF (.NOT. (SIZE .LT. MOST .AND. SIZE .GE. LEAST)) RETURN
C     2**(K-1) <= SIZE < 2**K: the logarithm may be wrong by one.
      K = INT(LOG(SIZE) / LOG(2.0D0) + 1075.0D0) - 1074
      IF (2.0D0**K .LE. SIZE) K = K + 1
      IF (2.0D0**(K-1) .GT. SIZE) K = K - 1
      UNIT = 2.0D0**(K-53)
      DO 50 I = 1, 3
         DO 40 K = 1, 3
            SIDE(K,I) = 0.0D0
            IF (WAYS(I) .NE. 0) SIDE(K,I) = ANINT(CELL(K,I)/UNIT)*UNIT
   40    CONTINUE
   50 CONTINUE
      NCOP = 0
      DO 120 I = 1, N
         DO 60 K = 1, 3
            E(K) = P(K,I) - CELL(K,4)
            R(K) = ANINT(P(K,I)/UNIT)*UNIT
   60    CONTINUE
         DO 70 K = 1, 3
            FIRST(K) = 0
            LAST(K) = 0
            IF (WAYS(K) .EQ. 0) GO TO 70
            S = TRDOT3(G(1,K), E)
            T = MARGIN / HEIGHT(K)
            INFO = 20
            IF (.NOT. (S + T .LT. REACH + 1 .AND.
     1          1.0D0 - S + T .LT. REACH + 1)) RETURN
            IF (S + T .GT. 0.0D0) FIRST(K) = -TRFLOP(S + T)
            IF (S .LT. 1.0D0 + T) LAST(K) = TRFLOP(1.0D0 - S + T)
   70    CONTINUE
         DO 110 A = FIRST(1), LAST(1)
            DO 100 B = FIRST(2), LAST(2)
               DO 90 C = FIRST(3), LAST(3)
                  INFO = 1
                  IF (NCOP .EQ. MAXCOP) RETURN
                  NCOP = NCOP + 1
                  DO 80 K = 1, 3
                     X(K,NCOP) = R(K) + A*SIDE(K,1) + B*SIDE(K,2) +
     1                           C*SIDE(K,3)
   80             CONTINUE
                  WHO(NCOP) = I
                  COPY(NCOP) = 1024*A + 32*B + C
                  MINE(NCOP) = 0
                  IF (COPY(NCOP) .EQ. 0) MINE(NCOP) = 1
   90          CONTINUE
  100       CONTINUE
  110    CONTINUE
  120 CONTINUE
      INFO = 0
      END

C     TRPLAC - AT: point I, in copy NUMBER and as many as FURTHR says
C     farther; HOME(I) is where X has it.  GOOD = 0 where that is beyond
C     REACH; unchanged else.
      SUBROUTINE TRPLAC(X, HOME, SIDE, I, NUMBER, FURTHR, AT, GOOD)
      DOUBLE PRECISION X(3,*), SIDE(3,3), AT(3)
      INTEGER HOME(*), I, NUMBER, FURTHR, GOOD
      INTEGER A(3), B(3), K, REACH
      PARAMETER (REACH = 7)
      CALL TRUNPA(NUMBER, A)
      CALL TRUNPA(FURTHR, B)
      DO 10 K = 1, 3
         A(K) = A(K) + B(K)
         IF (ABS(A(K)) .GT. REACH) GOOD = 0
   10 CONTINUE
      DO 20 K = 1, 3
         AT(K) = X(K,HOME(I)) + A(1)*SIDE(K,1) + A(2)*SIDE(K,2) +
     1           A(3)*SIDE(K,3)
   20 CONTINUE
      END

C     TRCORN - those of a tetrahedron; as TRPLAC.
      SUBROUTINE TRCORN(X, HOME, SIDE, TET, MOVE, T, V, GOOD)
      DOUBLE PRECISION X(3,*), SIDE(3,3), V(3,4)
      INTEGER HOME(*), TET(4,*), MOVE(4,*), T, GOOD
      INTEGER K
      DO 10 K = 1, 4
         CALL TRPLAC(X, HOME, SIDE, TET(K,T), MOVE(K,T), 0, V(1,K),
     1               GOOD)
   10 CONTINUE
      END

C     TRENDI - GOOD = 0 unless facet K of those corners is one where the
C     mesh ends: unless its plane stays the same by all vectors, and no
C     point is beyond; none of X is, KNOWN = 1 says.
      SUBROUTINE TRENDI(N, X, HOME, SIDE, WAYS, V, K, KNOWN, GOOD)
      INTEGER N, HOME(*), WAYS(3), K, KNOWN, GOOD
      DOUBLE PRECISION X(3,*), SIDE(3,3), V(3,4)
      DOUBLE PRECISION AT(3,4)
      INTEGER I, J, L, HHORIE
      DO 20 J = 1, 4
         DO 10 L = 1, 3
            AT(L,J) = V(L,J)
   10    CONTINUE
   20 CONTINUE
      DO 40 L = 1, 3
         DO 30 J = 1, 3
            AT(J,K) = V(J,MOD(K, 4)+1) + SIDE(J,L)
   30    CONTINUE
         IF (WAYS(L) .EQ. 0) GO TO 40
         IF (HHORIE(AT(1,1), AT(1,2), AT(1,3), AT(1,4)) .NE. 0) GOOD = 0
   40 CONTINUE
      IF (KNOWN .EQ. 1) RETURN
      DO 60 I = 1, N
         DO 50 J = 1, 3
            AT(J,K) = X(J,HOME(I))
   50    CONTINUE
         IF (GOOD .EQ. 0) RETURN
         IF (HHORIE(AT(1,1), AT(1,2), AT(1,3), AT(1,4)) .LT. 0) GOOD = 0
   60 CONTINUE
      END

C     TRFACI - YES = 1 if facet K of tetrahedron T and facet L of U are
C     the same but for translation, by SHIFT from the copy of U to that
C     of T, seen from both sides: if their points are, in the order of
C     point and copy, which no translation alters.
      SUBROUTINE TRFACI(TET, MOVE, T, K, U, L, SHIFT, YES)
      INTEGER TET(4,*), MOVE(4,*), T, K, U, L, SHIFT, YES
      INTEGER V(3,2), C(3,2), A, B, H, I, J, M, ODD, S
      ODD = K + L
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
            ODD = ODD + 1
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
      YES = MOD(ODD, 2)
      END

C     TRONE - of each class of tetrahedra leaves one, whose first point
C     is in the cell itself: NTET of them, in TET, MOVE; SHIFT is 1 at
C     facets where the mesh of X ends, or 0.  HOME(I) = IW(I) becomes
C     where X has point I.  GOOD = 1 if all points are there.
      SUBROUTINE TRONE(N, NCOP, WHO, COPY, SEEN, NTET, TET, MOVE, ADJ,
     1                 SHIFT, IW, GOOD)
      INTEGER N, NCOP, WHO(*), COPY(*), SEEN(*), NTET, TET(4,*)
      INTEGER MOVE(4,*), ADJ(4,*), SHIFT(4,*), IW(*), GOOD
      INTEGER I, K, KEPT, T
      DO 10 I = 1, N
         SEEN(I) = 0
   10 CONTINUE
      KEPT = 0
      DO 30 T = 1, NTET
         I = MIN(TET(1,T), TET(2,T), TET(3,T), TET(4,T))
         IF (COPY(I) .NE. 0) GO TO 30
         KEPT = KEPT + 1
         DO 20 K = 1, 4
            SHIFT(K,KEPT) = 0
            IF (ADJ(K,T) .EQ. 0) SHIFT(K,KEPT) = 1
            I = TET(K,T)
            SEEN(WHO(I)) = 1
            TET(K,KEPT) = WHO(I)
            MOVE(K,KEPT) = COPY(I)
   20    CONTINUE
   30 CONTINUE
      NTET = KEPT
      GOOD = 1
      DO 40 I = 1, NCOP
         IF (COPY(I) .NE. 0) GO TO 40
C        (No duplicate.)
         IF (IW(I) .EQ. I .AND. SEEN(WHO(I)) .EQ. 0) GOOD = 0
         IW(WHO(I)) = I
   40 CONTINUE
      END

C     TRMATC - GOOD = 0 unless each facet has a neighbour, whose other
C     vertex is not in the ball, or is one where the mesh ends.  HEAD:
C     (N), workspace.
      SUBROUTINE TRMATC(N, X, HOME, HEAD, SIDE, WAYS, NTET, TET, MOVE,
     1                  ADJ, SHIFT, GOOD)
      INTEGER N, HOME(*), HEAD(*), WAYS(3), NTET, TET(4,*), MOVE(4,*)
      INTEGER ADJ(4,*), SHIFT(4,*), GOOD
      DOUBLE PRECISION X(3,*), SIDE(3,3)
      DOUBLE PRECISION V(3,4), AT(3)
      INTEGER F, FROM, G, I, K, L, S, T, U, YES, HHINSP
C     Facets that wait for their other side, in lists by the sum of
C     their points, linked in ADJ: 4*(T-1) + K for facet K of T.
      DO 10 I = 1, N
         HEAD(I) = 0
   10 CONTINUE
      DO 50 T = 1, NTET
         CALL TRCORN(X, HOME, SIDE, TET, MOVE, T, V, GOOD)
         IF (GOOD .EQ. 0) RETURN
         DO 40 K = 1, 4
            F = 4*(T-1) + K
            I = 0
            DO 20 L = 1, 4
               IF (L .NE. K) I = MOD(I + TET(L,T) - 1, N)
   20       CONTINUE
            I = I + 1
            FROM = 0
            G = HEAD(I)
   30       CONTINUE
            IF (G .EQ. 0) THEN
               ADJ(K,T) = HEAD(I)
               HEAD(I) = F
               GO TO 40
            END IF
            U = (G-1)/4 + 1
            L = G - 4*(U-1)
            CALL TRFACI(TET, MOVE, T, K, U, L, S, YES)
            IF (YES .EQ. 0) THEN
               FROM = G
               G = ADJ(L,U)
               GO TO 30
            END IF
            IF (FROM .EQ. 0) THEN
               HEAD(I) = ADJ(L,U)
            ELSE
               ADJ(MOD(FROM-1, 4)+1,(FROM-1)/4+1) = ADJ(L,U)
            END IF
            ADJ(K,T) = U
            ADJ(L,U) = T
            SHIFT(K,T) = S
            SHIFT(L,U) = -S
            CALL TRPLAC(X, HOME, SIDE, TET(L,U), MOVE(L,U), S, AT, GOOD)
            IF (GOOD .EQ. 0) RETURN
            IF (HHINSP(V(1,1), V(1,2), V(1,3), V(1,4), AT) .GT. 0)
     1         GOOD = 0
            IF (GOOD .EQ. 0) RETURN
   40    CONTINUE
   50 CONTINUE
      DO 70 I = 1, N
         F = HEAD(I)
   60    CONTINUE
         IF (F .EQ. 0) GO TO 70
         T = (F-1)/4 + 1
         K = F - 4*(T-1)
         F = ADJ(K,T)
         CALL TRCORN(X, HOME, SIDE, TET, MOVE, T, V, GOOD)
         CALL TRENDI(N, X, HOME, SIDE, WAYS, V, K, SHIFT(K,T), GOOD)
         IF (GOOD .EQ. 0) RETURN
         ADJ(K,T) = 0
         SHIFT(K,T) = 0
         GO TO 60
   70 CONTINUE
      END

C     TRHOLD - 0 where a place is outside of a tetrahedron, 1 on its
C     boundary, 2 inside.
      INTEGER FUNCTION TRHOLD(V, AT)
      DOUBLE PRECISION V(3,4), AT(3)
      INTEGER A, B, C, D, HHORIE
      A = HHORIE(AT, V(1,2), V(1,3), V(1,4))
      B = HHORIE(V(1,1), AT, V(1,3), V(1,4))
      C = HHORIE(V(1,1), V(1,2), AT, V(1,4))
      D = HHORIE(V(1,1), V(1,2), V(1,3), AT)
      TRHOLD = 1
      IF (MIN(A, B, C, D) .GT. 0) TRHOLD = 2
      IF (MIN(A, B, C, D) .LT. 0) TRHOLD = 0
      END

C     TRONCE - GOOD = 0 unless a place in a tetrahedron is in no other
C     one, nor in a copy: so it is everywhere, as each facet has two
C     sides.
      SUBROUTINE TRONCE(X, HOME, SIDE, WAYS, G, UNIT, NTET, TET, MOVE,
     1                  GOOD)
      INTEGER HOME(*), WAYS(3), NTET, TET(4,*), MOVE(4,*), GOOD
      DOUBLE PRECISION X(3,*), SIDE(3,3), G(3,3), UNIT
      DOUBLE PRECISION V(3,4), AT(3), Q(3), E(3), LOW, HIGH, S, TRDOT3
      INTEGER T, FOUND, FROM(3), TO(3), A, B, C, J, K
      INTEGER TRFLOP, TRHOLD, REACH
      PARAMETER (REACH = 7)
      DO 20 T = 1, NTET
         CALL TRCORN(X, HOME, SIDE, TET, MOVE, T, V, GOOD)
         DO 10 K = 1, 3
            S = V(K,1)/4.0D0 + V(K,2)/4.0D0 + V(K,3)/4.0D0 +
     1          V(K,4)/4.0D0
            AT(K) = ANINT(S/UNIT)*UNIT
   10    CONTINUE
         IF (TRHOLD(V, AT) .EQ. 2) GO TO 30
   20 CONTINUE
   30 CONTINUE
      FOUND = 0
      DO 100 T = 1, NTET
         CALL TRCORN(X, HOME, SIDE, TET, MOVE, T, V, GOOD)
         DO 60 K = 1, 3
            LOW = 0.0D0
            HIGH = 0.0D0
            DO 50 J = 1, 4
               IF (WAYS(K) .EQ. 0) GO TO 50
               E(1) = V(1,J) - AT(1)
               E(2) = V(2,J) - AT(2)
               E(3) = V(3,J) - AT(3)
               S = TRDOT3(G(1,K), E)
               IF (J .EQ. 1 .OR. S .LT. LOW) LOW = S
               IF (J .EQ. 1 .OR. S .GT. HIGH) HIGH = S
   50       CONTINUE
            FROM(K) = -TRFLOP(1.0D-3 - LOW)
            TO(K) = TRFLOP(HIGH + 1.0D-3)
            IF (FROM(K) .LT. -REACH - 2 .OR. TO(K) .GT. REACH + 2)
     1         GOOD = 0
   60    CONTINUE
         IF (GOOD .EQ. 0) RETURN
         DO 90 A = FROM(1), TO(1)
            DO 80 B = FROM(2), TO(2)
               DO 75 C = FROM(3), TO(3)
                  DO 70 K = 1, 3
                     Q(K) = AT(K) + A*SIDE(K,1) + B*SIDE(K,2) +
     1                      C*SIDE(K,3)
   70             CONTINUE
                  IF (TRHOLD(V, Q) .NE. 0) FOUND = FOUND + 1
   75          CONTINUE
   80       CONTINUE
   90    CONTINUE
  100 CONTINUE
      IF (FOUND .NE. 1) GOOD = 0
      END

C     TRGUES - a margin: about three points wide, if they fill the cell,
C     or lie near a plane, or line, that it repeats.
      SUBROUTINE TRGUES(N, P, CELL, WAYS, G, HEIGHT, MARGIN)
      INTEGER N, WAYS(3)
      DOUBLE PRECISION P(3,*), CELL(3,4), G(3,3), HEIGHT(3), MARGIN
      DOUBLE PRECISION E(3), S(3), THICK, WIDE, ALONG, TRDOT3
      INTEGER I, J, K
      THICK = 0.0D0
      ALONG = 0.0D0
      DO 10 K = 1, 3
         IF (WAYS(K) .NE. 0) ALONG = ALONG + 1.0D0
   10 CONTINUE
      DO 60 I = 2, N
         IF (ALONG .EQ. 3.0D0) GO TO 60
         DO 20 K = 1, 3
            E(K) = P(K,I) - P(K,1)
   20    CONTINUE
         DO 30 K = 1, 3
            S(K) = 0.0D0
            IF (WAYS(K) .NE. 0) S(K) = TRDOT3(G(1,K), E)
   30    CONTINUE
         DO 50 K = 1, 3
            DO 40 J = 1, 3
               E(K) = E(K) - S(J)*CELL(K,J)
   40       CONTINUE
            THICK = MAX(THICK, ABS(E(K)))
   50    CONTINUE
   60 CONTINUE
C     (A cell's volume could be too large or too small for a double.)
      MARGIN = 3.0D0*DBLE(N)**(-1.0D0/3.0D0)
      WIDE = 3.0D0*DBLE(N)**(-1.0D0/ALONG)
      DO 70 K = 1, 3
         IF (WAYS(K) .NE. 0) THEN
            MARGIN = MARGIN*HEIGHT(K)**(1.0D0/3.0D0)
            WIDE = WIDE*HEIGHT(K)**(1.0D0/ALONG)
         ELSE
            MARGIN = MARGIN*THICK**(1.0D0/3.0D0)
         END IF
   70 CONTINUE
      IF (ALONG .LT. 3.0D0) MARGIN = MAX(MARGIN, WIDE)
      END

C     TRTRIC - as TRPERI, below, of a cell of any three vectors, that
C     repeats itself along all of them, or some.
C
C       N, P     (in)   N >= 1 points, in the cell or not far from it
C       CELL     (in)   (3,4): three vectors, those that count not in
C                       one plane, and a corner.  If they are skew
C                       tetrahedra reach across more of them: TRREDU
C                       them first
C       WAYS     (in)   (3): WAYS(K) <> 0 where it repeats itself along
C                       vector K
C       all others      as in TRPERI
C       INFO     (out)  as of TRPERI; -2 for NaN; -3 for vectors that
C                       span no cell, or one flatter than 1D-6, and
C                       where it is repeated nowhere; 20, too, for
C                       points that are some cells away; 3, 4 where all
C                       copies are in a plane, on a line
C
C     A margin about the cell is filled with copies, and those
C     tetrahedra computed that have a point of the cell itself.  Kept
C     are those whose first point is in the cell itself: one of each
C     class.  They are right, whatever may be beyond the margin, if each
C     facet has a neighbour whose ball holds no point of it, or is one
C     where the mesh ends, all points are there, and a place is in one
C     tetrahedron only.  If not, the margin is made wider.
C
C     Of cospherical points the order decides, so the order must be the
C     same in all copies: by point, then by copy.  With copies put after
C     the originals a sphere of points in the cell has another first
C     point than its copy across the boundary: both triangulate it, each
C     in its way, and what they have in common does not fit: lattices
C     come out with volumes that are off by a tenth.  For the same
C     reason copies must not be rounded one by one.
      SUBROUTINE TRTRIC(N, P, CELL, WAYS, MAXCOP, NCOP, X, CW, MAXTET,
     1                  NTET, TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW,
     2                  INFO)
      INTEGER N, WAYS(3), MAXCOP, NCOP, CW(MAXCOP,3), MAXTET, NTET
      INTEGER TET(4,*), MOVE(4,*), ADJ(4,*), SHIFT(4,*), LIW, IW(*), LRW
      INTEGER INFO
      DOUBLE PRECISION P(3,*), CELL(3,4), X(3,*), RW(*)
      DOUBLE PRECISION G(3,3), HEIGHT(3), SIDE(3,3), MARGIN, UNIT
      INTEGER GOOD
      NTET = 0
      INFO = -1
      IF (N .LT. 1) RETURN
      INFO = -3
      IF (WAYS(1) .EQ. 0 .AND. WAYS(2) .EQ. 0 .AND. WAYS(3) .EQ. 0)
     1   RETURN
      CALL TRACRO(CELL, WAYS, G, HEIGHT, GOOD)
      IF (GOOD .NE. 0) RETURN
      CALL TRGUES(N, P, CELL, WAYS, G, HEIGHT, MARGIN)
   10 CONTINUE
      CALL TRCOPI(N, P, CELL, WAYS, G, HEIGHT, MARGIN, MAXCOP, NCOP, X,
     1            CW, CW(1,2), CW(1,3), SIDE, UNIT, INFO)
      IF (INFO .NE. 0) RETURN
      CALL TESSIX(NCOP, X, LIW, IW, LRW, RW, INFO)
      NTET = 0
      GOOD = 0
      IF (INFO .GE. 3 .AND. INFO .LE. 5) THEN
         IF (MARGIN .GE. MAX(HEIGHT(1), HEIGHT(2), HEIGHT(3))) RETURN
      ELSE
         IF (INFO .EQ. 0) CALL TESSPA(NCOP, X, CW(1,3), MAXTET, NTET,
     1                                TET, ADJ, LIW, IW, LRW, RW, INFO)
         IF (INFO .NE. 0) THEN
            NTET = 0
            RETURN
         END IF
         CALL TRONE(N, NCOP, CW, CW(1,2), CW(1,3), NTET, TET, MOVE, ADJ,
     1              SHIFT, IW, GOOD)
         IF (GOOD .NE. 0) CALL TRMATC(N, X, IW, CW(1,3), SIDE, WAYS,
     1                                NTET, TET, MOVE, ADJ, SHIFT, GOOD)
         IF (GOOD .NE. 0) CALL TRONCE(X, IW, SIDE, WAYS, G, UNIT, NTET,
     1                                TET, MOVE, GOOD)
      END IF
      MARGIN = 1.5D0*MARGIN
      IF (GOOD .EQ. 0) GO TO 10
      INFO = 0
      END

C     TRPERI - the tetrahedra of the points and all their copies, one of
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
C     Cost: 1.7 times that of TESS for 10,000 points, less for more: the
C     margin is about three points wide.
      SUBROUTINE TRPERI(N, P, BOX, MAXCOP, NCOP, X, CW, MAXTET, NTET,
     1                  TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW, INFO)
      INTEGER N, MAXCOP, NCOP, CW(MAXCOP,3), MAXTET, NTET, TET(4,*)
      INTEGER MOVE(4,*), ADJ(4,*), SHIFT(4,*), LIW, IW(*), LRW, INFO
      DOUBLE PRECISION P(3,*), BOX(2,3), X(3,*), RW(*)
      DOUBLE PRECISION CELL(3,4)
      INTEGER WAYS(3), I, J, K
      NTET = 0
      DO 20 K = 1, 3
         DO 10 J = 1, 3
            CELL(J,K) = 0.0D0
   10    CONTINUE
         CELL(K,K) = BOX(2,K) - BOX(1,K)
         CELL(K,4) = BOX(1,K)
         WAYS(K) = 1
         INFO = -3
         IF (N .GT. 0 .AND. .NOT. (CELL(K,K) .GT. 0.0D0)) RETURN
   20 CONTINUE
      INFO = -2
      DO 40 I = 1, N
         DO 30 K = 1, 3
            IF (.NOT. (P(K,I) .GE. BOX(1,K) .AND. P(K,I) .LE. BOX(2,K)))
     1         RETURN
   30    CONTINUE
   40 CONTINUE
      CALL TRTRIC(N, P, CELL, WAYS, MAXCOP, NCOP, X, CW, MAXTET, NTET,
     1            TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW, INFO)
      END

C     TRREDU - make the vectors of a cell short, by adding others of
C     them, until no sum or difference is shorter: the lattice is the
C     same.
C
C       CELL  (in,out)  (3,4), as in TRTRIC; the corner stays
C       WAYS  (in)      (3): those with WAYS(K) = 0 stay, and are not
C                       added
      SUBROUTINE TRREDU(CELL, WAYS)
      DOUBLE PRECISION CELL(3,4)
      INTEGER WAYS(3)
      DOUBLE PRECISION UNIT, W(3), C(3), SQUARE, TRDOT3
      INTEGER AGAIN, H, I, J, K, L
      UNIT = 0.0D0
      DO 10 K = 1, 3
         IF (WAYS(K) .NE. 0) UNIT = MAX(UNIT, ABS(CELL(1,K)),
     1       ABS(CELL(2,K)), ABS(CELL(3,K)))
   10 CONTINUE
      IF (.NOT. (UNIT .GT. 2.0D0**(-1000) .AND. UNIT .LT. 2.0D0**1000))
     1   RETURN
      UNIT = 2.0D0**NINT(LOG(UNIT) / LOG(2.0D0))
      DO 30 K = 1, 3
         DO 20 L = 1, 3
            CELL(L,K) = CELL(L,K) / UNIT
   20    CONTINUE
   30 CONTINUE
   40 CONTINUE
      AGAIN = 0
C     Of vector K any multiple of one other is taken away, or both
C     others are added or taken away.
      DO 70 H = 0, 17
         K = H/6 + 1
         J = MOD(K + MOD(H, 2), 3) + 1
         I = 6 - K - J
         IF (WAYS(K) .EQ. 0 .OR. WAYS(J) .EQ. 0) GO TO 70
         C(K) = 1.0D0
         C(I) = DBLE(MOD(H, 6)/2 - 1)
         C(J) = -1.0D0
         IF (MOD(H, 2) .EQ. 1) C(J) = 1.0D0
         SQUARE = TRDOT3(CELL(1,J), CELL(1,J))
         IF (C(I) .EQ. 0.0D0 .AND. SQUARE .GT. 0.0D0)
     1      C(J) = -ANINT(TRDOT3(CELL(1,K), CELL(1,J)) / SQUARE)
         IF (C(I) .NE. 0.0D0 .AND. WAYS(I) .EQ. 0) GO TO 70
         DO 50 L = 1, 3
            W(L) = C(1)*CELL(L,1) + C(2)*CELL(L,2) + C(3)*CELL(L,3)
   50    CONTINUE
         SQUARE = TRDOT3(CELL(1,K), CELL(1,K))
         IF (.NOT. (TRDOT3(W, W) .LT. (1.0D0 - 1.0D-9)*SQUARE)) GO TO 70
         AGAIN = 1
         DO 60 L = 1, 3
            CELL(L,K) = W(L)
   60    CONTINUE
   70 CONTINUE
      IF (AGAIN .NE. 0) GO TO 40
      DO 90 K = 1, 3
         DO 80 L = 1, 3
            CELL(L,K) = CELL(L,K)*UNIT
   80    CONTINUE
   90 CONTINUE
      END
