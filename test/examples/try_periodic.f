C     try_periodic.f - periodic.f's tetrahedra of several sets of
C     points, in boxes and other cells: facets are paired, Euler's
C     formula holds, volumes fill the cell.
C
C         gfortran -O2 test/examples/try_periodic.f
C           test/examples/periodic.f f77/tess.f f77/hhpred.f
C
C     try_periodic.c is the same in C; both write the same text.
      PROGRAM PERIO
      INTEGER MAXN, MAXCOP, MAXTET, LIW, LRW
      PARAMETER (MAXN = 512, MAXCOP = 16000, MAXTET = 24*MAXN)
      PARAMETER (LIW = 19*MAXCOP + 1800, LRW = 4*MAXCOP + 12)
      DOUBLE PRECISION P(3,MAXN), X(3,MAXCOP), RW(LRW), LOW(3)
      DOUBLE PRECISION CELL(3,4)
      INTEGER CW(MAXCOP,3), TET(4,MAXTET), MOVE(4,MAXTET)
      INTEGER ADJ(4,MAXTET), SHIFT(4,MAXTET), IW(LIW)
      INTEGER LIST(12*MAXTET,3), SEED, SET, N, I, K, NCOP, NTET, NEDGE
      INTEGER USED, INFO, GOOD, WANTED(9), WAYS(3), NFAC
      DOUBLE PRECISION BOX(2,3), SCALE
      CHARACTER*8 NAME(15)
      CHARACTER*3 ANSWER(0:1)
      COMMON /LARGE/ P, X, RW, CW, TET, MOVE, ADJ, SHIFT, IW, LIST
      DATA LOW /-1.0D0, 0.0D0, 2.0D0/
      DATA WANTED /20, -2, 1, -1, -3, -3, -3, 6, 6/
      DATA NAME /'random', 'lattice', 'clusters', 'one', 'three',
     1           'twice', 'huge', 'tiny', 'skew', 'sheared', 'fcc',
     2           'two', 'slab', 'sheet', 'rod'/
      DATA ANSWER /'NO', 'yes'/
      SEED = 1
      WRITE (*, 30)
      DO 20 SET = 1, 15
         CALL MAKE(SET, SEED, LOW, N, CELL, WAYS, P)
C        A power of two alters nothing else.
         SCALE = 1.0D0
         IF (SET .EQ. 7) SCALE = 2.0D0**400
         IF (SET .EQ. 8) SCALE = 0.5D0**400
         DO 8 K = 1, 3
            DO 4 I = 1, 4
               CELL(K,I) = CELL(K,I)*SCALE
    4       CONTINUE
            BOX(1,K) = CELL(K,4)
            BOX(2,K) = CELL(K,4) + CELL(K,K)
            DO 6 I = 1, N
               P(K,I) = P(K,I)*SCALE
    6       CONTINUE
    8    CONTINUE
         IF (SET .GT. 8) THEN
            CALL REDUCE(CELL, WAYS)
            CALL TRICLI(N, P, CELL, WAYS, MAXCOP, NCOP, X, CW, MAXTET,
     1                  NTET, TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW,
     2                  INFO)
         ELSE
            CALL PERIOD(N, P, BOX, MAXCOP, NCOP, X, CW, MAXTET, NTET,
     1                  TET, MOVE, ADJ, SHIFT, LIW, IW, LRW, RW, INFO)
         END IF
         IF (INFO .NE. 0) THEN
            WRITE (*, *) NAME(SET), ': code ', INFO
            STOP
         END IF
         CALL COUNTE(N, NTET, TET, MOVE, CW, LIST, 12*MAXTET, NEDGE)
         USED = N
         DO 10 I = 201, N
C           Duplicates have no edges.
            IF (SET .EQ. 6 .AND. CW(I,1) .EQ. 0) USED = USED - 1
   10    CONTINUE
         CALL PROVEN(N, P, NTET, TET, MOVE, ADJ, SHIFT, CELL, WAYS,
     1               NFAC, GOOD)
         USED = USED + NFAC/2 - NEDGE + NTET
         WRITE (*, 40) NAME(SET), N, NTET, NEDGE, USED, ANSWER(GOOD)
   20 CONTINUE
C     A long box, points outside and short arrays get their codes.
      GOOD = 1
      DO 24 K = 1, 3
         P(K,1) = LOW(K)
         BOX(1,K) = LOW(K)
         BOX(2,K) = LOW(K) + 1.0D0
   24 CONTINUE
      BOX(2,1) = LOW(1) + 64.0D0
      DO 26 I = 1, 9
         IF (I .EQ. 2) P(1,1) = LOW(1) - 1.0D0
         IF (I .EQ. 3) P(1,1) = LOW(1)
         IF (I .EQ. 3) BOX(2,1) = LOW(1) + 1.0D0
         IF (I .GT. 4 .AND. I .LT. 8) BOX(2,I-4) = BOX(1,I-4)
C        Boxes of 1D-300 or 1D308 about the point.
         DO 25 K = 1, 3
            IF (I .LT. 8) GO TO 25
            P(K,1) = 0.0D0
            BOX(1,K) = 0.0D0
            BOX(2,K) = 1.0D-300
            IF (I .EQ. 9) BOX(2,K) = 1.0D308
   25    CONTINUE
         NCOP = MAXCOP
         IF (I .EQ. 3) NCOP = 9
         N = 1
         IF (I .EQ. 4) N = 0
         CALL PERIOD(N, P, BOX, NCOP, K, X, CW, MAXTET, NTET, TET, MOVE,
     1               ADJ, SHIFT, LIW, IW, LRW, RW, INFO)
         IF (INFO .NE. WANTED(I)) GOOD = 0
         IF (I .GT. 4 .AND. I .LT. 8) BOX(2,I-4) = BOX(1,I-4) + 1.0D0
   26 CONTINUE
      WRITE (*, 50) ANSWER(GOOD)
   30 FORMAT ('set       points  tetrahedra  edges  Euler  proven')
   40 FORMAT (A8, 2X, I6, 2X, I10, 2X, I5, 2X, I5, 2X, A)
   50 FORMAT ('codes: ', A)
      END

C     RANDOM - a random number, 0 <= X < 1, of 20 bits.
      SUBROUTINE RANDOM(SEED, X)
      INTEGER SEED, HIGH
      DOUBLE PRECISION X
      SEED = MOD(SEED*3877 + 29573, 139968)
      HIGH = MOD(SEED, 1024)
      SEED = MOD(SEED*3877 + 29573, 139968)
      X = (DBLE(HIGH) + DBLE(MOD(SEED, 1024)) / 1024.0D0) / 1024.0D0
      END

C     MAKE - points of a set, in a cell with these ways.
      SUBROUTINE MAKE(SET, SEED, LOW, N, CELL, WAYS, P)
      INTEGER SET, SEED, N, WAYS(3)
      DOUBLE PRECISION LOW(3), CELL(3,4), P(3,*)
      DOUBLE PRECISION R(3)
      INTEGER I, J, K, NUMBER(15), SKEWED(3,3), CENTRE(3,3)
      SAVE NUMBER, SKEWED, CENTRE
      DATA NUMBER /500, 512, 300, 1, 3, 400, 300, 300, 300, 300, 1, 2,
     1             300, 2, 300/
C     In eighths: vectors of the skew cells, short ones.
      DATA SKEWED /8, 0, 0, 3, 7, 0, -2, 3, 9/
      DATA CENTRE /0, 4, 4, 4, 0, 4, 4, 4, 0/
      N = NUMBER(SET)
      DO 10 K = 1, 3
         DO 5 J = 1, 3
            CELL(J,K) = 0.0D0
            IF (J .EQ. K) CELL(J,K) = 1.0D0
            IF (SET .GT. 8) CELL(J,K) = DBLE(SKEWED(J,K)) / 8.0D0
            IF (SET .EQ. 11) CELL(J,K) = DBLE(CENTRE(J,K)) / 8.0D0
    5    CONTINUE
         CELL(K,4) = LOW(K)
         WAYS(K) = 1
         IF ((SET .EQ. 13 .OR. SET .EQ. 14) .AND. K .EQ. 3) WAYS(K) = 0
         IF (SET .EQ. 15 .AND. K .LT. 3) WAYS(K) = 0
   10 CONTINUE
      IF (SET .EQ. 1) CELL(1,1) = 2.0D0
      IF (SET .EQ. 1) CELL(2,2) = 1.5D0
C     The slab, and a sheet of two layers, have upright sides.
      IF (SET .EQ. 13 .OR. SET .EQ. 14) THEN
         CELL(1,3) = 0.0D0
         CELL(2,3) = 0.0D0
         CELL(3,3) = 1.0D0
      END IF
      DO 40 I = 1, N
         DO 20 K = 1, 3
            CALL RANDOM(SEED, R(K))
            IF (SET .EQ. 3) R(K) = 0.25D0*R(K) + 0.5D0*MOD(I - 1, 2)
C           A shuffled lattice of 8 a side: 257 and 512 have no factor
C           in common.
            J = MOD((I - 1)*257, 512)
            IF (SET .EQ. 2) R(K) = DBLE(MOD(J/8**(K-1), 8)) / 8.0D0
   20    CONTINUE
         IF ((SET .EQ. 13 .OR. SET .EQ. 14) .AND. I .LT. 3)
     1      R(3) = DBLE(I - 1)
         DO 30 K = 1, 3
            P(K,I) = LOW(K) + R(1)*CELL(K,1) + R(2)*CELL(K,2) +
     1               R(3)*CELL(K,3)
C           Duplicates: in the box, and across its boundary.
            IF (SET .EQ. 6 .AND. I .GT. 200) P(K,I) = P(K,I-200)
            IF (SET .EQ. 6 .AND. MOD(I - 1, 200) .LT. 20 .AND.
     1          K .EQ. 3) THEN
               P(K,I) = LOW(K)
               IF (I .LE. 200) P(K,I) = LOW(K) + 1.0D0
            END IF
   30    CONTINUE
   40 CONTINUE
C     The lattice stays the same, but has long vectors.
      IF (SET .NE. 10) RETURN
      DO 50 K = 1, 3
         CELL(K,2) = CELL(K,2) + 9.0D0*CELL(K,1)
         CELL(K,3) = CELL(K,3) - 5.0D0*CELL(K,2)
   50 CONTINUE
      END

C     PLACE - of a point's copy, moved; exact, as are the points and
C     vectors.
      SUBROUTINE PLACE(P, I, NUMBER, CELL, AT)
      DOUBLE PRECISION P(3,*), CELL(3,4), AT(3)
      INTEGER I, NUMBER
      INTEGER A(3), K
      CALL UNPACK(NUMBER, A)
      DO 10 K = 1, 3
         AT(K) = P(K,I) + A(1)*CELL(K,1) + A(2)*CELL(K,2) +
     1           A(3)*CELL(K,3)
   10 CONTINUE
      END

C     COUNTE - each edge once: in lists by one point, that begin in
C     HEAD.  That of points A, B and the copy of B when A is in the box.
      SUBROUTINE COUNTE(N, NTET, TET, MOVE, HEAD, LIST, MOST, NEDGE)
      INTEGER N, NTET, TET(4,*), MOVE(4,*), HEAD(*), MOST, LIST(MOST,3)
      INTEGER NEDGE
      INTEGER I, J, K, M, A, B, D
      DO 10 I = 1, N
         HEAD(I) = 0
   10 CONTINUE
      NEDGE = 0
      DO 50 I = 1, NTET
         DO 40 K = 1, 3
            DO 30 M = K + 1, 4
               A = TET(K,I)
               B = TET(M,I)
               D = MOVE(M,I) - MOVE(K,I)
               IF (A .GT. B .OR. (A .EQ. B .AND. D .LT. 0)) THEN
                  A = TET(M,I)
                  B = TET(K,I)
                  D = -D
               END IF
               J = HEAD(A)
   20          CONTINUE
               IF (J .GT. 0) THEN
                  IF (LIST(J,1) .EQ. B .AND. LIST(J,2) .EQ. D) GO TO 30
                  J = LIST(J,3)
                  GO TO 20
               END IF
               NEDGE = NEDGE + 1
               LIST(NEDGE,1) = B
               LIST(NEDGE,2) = D
               LIST(NEDGE,3) = HEAD(A)
               HEAD(A) = NEDGE
   30       CONTINUE
   40    CONTINUE
   50 CONTINUE
      END

      DOUBLE PRECISION FUNCTION DETERM(E)
      DOUBLE PRECISION E(3,3)
      DETERM = E(1,1)*(E(2,2)*E(3,3) - E(3,2)*E(2,3)) +
     1         E(2,1)*(E(3,2)*E(1,3) - E(1,2)*E(3,3)) +
     2         E(3,1)*(E(1,2)*E(2,3) - E(2,2)*E(1,3))
      END

C     OUTER - GOOD = 0 if a point, or a copy, is beyond facet K of the
C     tetrahedron V: unless the vectors are in its plane.
      SUBROUTINE OUTER(N, P, V, K, CELL, WAYS, GOOD)
      INTEGER N, K, WAYS(3), GOOD
      DOUBLE PRECISION P(3,*), V(3,*), CELL(3,4)
      DOUBLE PRECISION W(3,4)
      INTEGER I, J, L, HHORIE
      DO 20 J = 1, 4
         DO 10 L = 1, 3
            W(L,J) = V(L,J)
   10    CONTINUE
   20 CONTINUE
      DO 40 J = 1, 3
         DO 30 L = 1, 3
            W(L,K) = V(L,MOD(K, 4)+1) + CELL(L,J)
   30    CONTINUE
         IF (WAYS(J) .NE. 0 .AND.
     1       HHORIE(W(1,1), W(1,2), W(1,3), W(1,4)) .NE. 0) GOOD = 0
   40 CONTINUE
      DO 60 I = 1, N
         DO 50 L = 1, 3
            W(L,K) = P(L,I)
   50    CONTINUE
         IF (HHORIE(W(1,1), W(1,2), W(1,3), W(1,4)) .LT. 0) GOOD = 0
   60 CONTINUE
      END

C     PROVEN - GOOD = 1 if the facets are paired, or the hull's, of
C     which there are NFAC, all tetrahedra positively oriented and as
C     large as the cell together, and no neighbour's apex is in a ball.
      SUBROUTINE PROVEN(N, P, NTET, TET, MOVE, ADJ, SHIFT, CELL, WAYS,
     1                  NFAC, GOOD)
      INTEGER N, NTET, TET(4,*), MOVE(4,*), ADJ(4,*), SHIFT(4,*)
      INTEGER WAYS(3), NFAC, GOOD
      DOUBLE PRECISION P(3,*), CELL(3,4)
      DOUBLE PRECISION V(3,5), E(3,3), VOLUME, WHOLE, UNIT, DETERM
      INTEGER H, J, K, S, T, U, HHORIE, HHINSP
C     In units of a length.
      UNIT = ABS(CELL(1,3)) + ABS(CELL(2,3)) + ABS(CELL(3,3))
      DO 6 K = 1, 3
         DO 4 J = 1, 3
            E(J,K) = CELL(J,K) / UNIT
    4    CONTINUE
    6 CONTINUE
      WHOLE = DETERM(E)
      VOLUME = 0.0D0
      NFAC = 0
      GOOD = 1
      IF (NTET .LT. 1) GOOD = 0
      DO 80 T = 1, NTET
         DO 10 K = 1, 4
            CALL PLACE(P, TET(K,T), MOVE(K,T), CELL, V(1,K))
   10    CONTINUE
         IF (HHORIE(V(1,1), V(1,2), V(1,3), V(1,4)) .NE. 1) GOOD = 0
         DO 30 K = 1, 3
            DO 20 J = 1, 3
               E(J,K) = (V(J,K+1) - V(J,1)) / UNIT
   20       CONTINUE
   30    CONTINUE
         VOLUME = VOLUME + DETERM(E) / 6.0D0
         DO 70 K = 1, 4
            U = ADJ(K,T)
            IF (U .EQ. 0 .AND. MIN(WAYS(1), WAYS(2), WAYS(3)) .EQ. 0)
     1         THEN
               NFAC = NFAC + 1
               CALL OUTER(N, P, V, K, CELL, WAYS, GOOD)
               GO TO 70
            END IF
            IF (U .LT. 1 .OR. U .GT. NTET) THEN
               GOOD = 0
               RETURN
            END IF
C           The vertex of U that is not T's, and three that are.
            H = 0
            DO 60 J = 1, 4
               DO 50 S = 1, 4
                  IF (S .NE. K .AND. TET(S,T) .EQ. TET(J,U) .AND.
     1                MOVE(S,T) .EQ. MOVE(J,U) + SHIFT(K,T)) GO TO 60
   50          CONTINUE
               IF (H .GT. 0) GOOD = 0
               H = J
   60       CONTINUE
            IF (H .EQ. 0) THEN
               GOOD = 0
               RETURN
            END IF
            IF (ADJ(H,U) .NE. T .OR. SHIFT(H,U) .NE. -SHIFT(K,T))
     1         GOOD = 0
            CALL PLACE(P, TET(H,U), MOVE(H,U) + SHIFT(K,T), CELL,
     1                 V(1,5))
            IF (HHINSP(V(1,1), V(1,2), V(1,3), V(1,4), V(1,5)) .EQ. 1)
     1         GOOD = 0
   70    CONTINUE
   80 CONTINUE
C     (What a rod fills is not known.)
      IF (WAYS(1) .NE. 0 .AND.
     1    .NOT. (ABS(VOLUME - WHOLE) .LT. 1.0D-12*WHOLE)) GOOD = 0
      END
