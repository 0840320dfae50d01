C     try_slopes.f - tests of slopes.f: what its header promises.
C     try_slopes.c is the same in C, and writes a table of errors, too;
C     both write the same text.
C
C         gfortran -O2 test/examples/try_slopes.f
C        1    test/examples/slopes.f f77/tess.f f77/hhpred.f
C
      PROGRAM SLOPET
      INTEGER N, LRW
      PARAMETER (N = 52850, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      INTEGER BAD(7), I, K
      CHARACTER*50 TESTED(7)
      CHARACTER*3 ANSWER(0:1)
      DATA ANSWER /'yes', 'NO'/
      DATA TESTED /
     1   'slopes: linear fields as they are:                ',
     2   'slopes: errors as promised; never above linear''s: ',
     3   'slopes: no round makes the misfit larger:         ',
     4   'bent: the data at the points, and what is outside:',
     5   'bent: any size of coordinates, four points:       ',
     6   'slopes: linear fields in flat sets, in any units: ',
     7   'codes: bad arguments, damage, unfinished meshes:  '/
      DO 10 I = 1, 7
         BAD(I) = 0
   10 CONTINUE
      DO 30 I = 1, N
         DO 20 K = 1, 3
            ZERO(K,I) = 0.0D0
   20    CONTINUE
   30 CONTINUE
      I = 1
      CALL TLINEA(I, BAD(1))
      CALL TERROR(I, BAD(2))
      CALL TROUND(I, BAD(3))
      CALL TPLACE(I, BAD(4))
      CALL TSIZES(I, BAD(5))
      CALL TFLAT(I, BAD(6))
      CALL TCODES(I, BAD(7))
      DO 40 I = 1, 7
         WRITE (*, 50) TESTED(I), ANSWER(BAD(I))
   40 CONTINUE
   50 FORMAT (A50, 2X, A)
      END

C     RANDOM - a random number, 0 < X < 1: SEED := 16807 SEED modulo
C     2**31 - 1.
      SUBROUTINE RANDOM(SEED, X)
      INTEGER SEED
      DOUBLE PRECISION X
      SEED = 16807*MOD(SEED, 127773) - 2836*(SEED / 127773)
      IF (SEED .LT. 0) SEED = SEED + 2147483647
      X = DBLE(SEED) / 2147483647.0D0
      END

C     MAKE - about M points: 1 at random in the unit cube; 2 a lattice,
C     turned; 3 at random between two spheres, turned; 4 clusters; 5 a
C     rough terrain, turned.
      SUBROUTINE MAKE(SET, M, SEED, N, P)
      INTEGER SET, M, SEED, N
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION X(3), C(3), R, SLPDOT
      INTEGER I, K, SIDE
      SIDE = INT(EXP(LOG(DBLE(M)) / 3.0D0) + 0.5D0)
      N = M
      IF (SET .EQ. 2) N = SIDE**3
      DO 60 I = 1, N
   10    CONTINUE
         DO 20 K = 1, 3
            CALL RANDOM(SEED, X(K))
   20    CONTINUE
         IF (SET .EQ. 3 .AND. .NOT. (SLPDOT(X, X) .GT. 0.01D0 .AND.
     1       SLPDOT(X, X) .LT. 1.0D0)) GO TO 10
         IF (SET .EQ. 2) THEN
            X(1) = DBLE(MOD(I-1, SIDE)) / DBLE(SIDE)
            X(2) = DBLE(MOD((I-1)/SIDE, SIDE)) / DBLE(SIDE)
            X(3) = DBLE((I-1)/SIDE/SIDE) / DBLE(SIDE)
         END IF
         IF (SET .EQ. 3) THEN
            CALL RANDOM(SEED, R)
            R = SQRT(SLPDOT(X, X)) / (0.9D0 + 0.1D0*R)
            DO 30 K = 1, 3
               X(K) = X(K) / R
   30       CONTINUE
         END IF
         IF (SET .EQ. 4) THEN
            DO 40 K = 1, 3
               IF (MOD(I-1, 50) .EQ. 0) C(K) = X(K)
               X(K) = C(K) + 0.1D0*X(K)**3
   40       CONTINUE
         END IF
         IF (SET .EQ. 5)
     1      X(3) = 0.2D0*SIN(7.0D0*X(1))*X(2) + 0.01D0*X(3)
         IF (SET .EQ. 2 .OR. SET .EQ. 3 .OR. SET .EQ. 5) THEN
            R = X(1)
            X(1) = 0.8D0*R - 0.6D0*X(2)
            X(2) = 0.6D0*R + 0.8D0*X(2)
            R = X(2)
            X(2) = 0.96D0*R - 0.28D0*X(3)
            X(3) = 0.28D0*R + 0.96D0*X(3)
         END IF
         DO 50 K = 1, 3
            P(K,I) = X(K)
   50    CONTINUE
   60 CONTINUE
      END

C     FIELD - the fields: 1 linear, 2 quadratic, 3 smooth; 4 R.
C     Franke's, as R. J. Renka gives it in space.
      DOUBLE PRECISION FUNCTION FIELD(WHICH, Q)
      INTEGER WHICH
      DOUBLE PRECISION Q(3)
      DOUBLE PRECISION X, Y, Z
      X = Q(1)
      Y = Q(2)
      Z = Q(3)
      IF (WHICH .EQ. 1) THEN
         FIELD = 7.0D0 + 2.0D0*X - 3.0D0*Y + 0.5D0*Z
      ELSE IF (WHICH .EQ. 2) THEN
         FIELD = X*X - 2.0D0*Y*Y + Z*Z/2.0D0 + X*Y - Y*Z
      ELSE IF (WHICH .EQ. 3) THEN
         FIELD = SIN(5.0D0*X)*COS(4.0D0*Y) + SIN(3.0D0*Z + X)
      ELSE
         X = 9.0D0*X
         Y = 9.0D0*Y
         Z = 9.0D0*Z
         FIELD = 0.75D0*EXP(-((X - 2.0D0)**2 + (Y - 2.0D0)**2 +
     1                        (Z - 2.0D0)**2) / 4.0D0) +
     2           0.75D0*EXP(-(X + 1.0D0)**2 / 49.0D0 -
     3                      (Y + 1.0D0) / 10.0D0 -
     4                      (Z + 1.0D0) / 10.0D0) +
     5           0.5D0*EXP(-((X - 7.0D0)**2 + (Y - 3.0D0)**2 +
     6                       (Z - 5.0D0)**2) / 4.0D0) -
     7           0.2D0*EXP(-(X - 4.0D0)**2 - (Y - 7.0D0)**2 -
     8                     (Z - 5.0D0)**2)
      END IF
      END

C     TRY - the tests' mesh of set SET, M points; field WHICH at them.
      SUBROUTINE TRY(SET, M, WHICH, SEED, NTET, K, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SET, M, WHICH, SEED, NTET, K, BAD
      DOUBLE PRECISION FIELD
      INTEGER I, INFO
      I = SET
      CALL MAKE(I, M, SEED, K, P)
      CALL TESS(K, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .NE. 0) BAD = 1
      DO 10 I = 1, K
         VALUE(I) = FIELD(WHICH, P(1,I))
   10 CONTINUE
      END

C     COMPAR - roots of the mean squares of the errors of linear
C     interpolation and of BENT, at random in the points' box shrunk by
C     MARGIN at each side; NONE: gradients of 0.
      SUBROUTINE COMPAR(N, P, NTET, TET, ADJ, VALUE, G, NONE, WHICH,
     1                  MARGIN, SEED, LINEAR, RMS)
      INTEGER N, NTET, TET(4,*), ADJ(4,*), WHICH, SEED
      DOUBLE PRECISION P(3,*), VALUE(*), G(3,*), NONE(3,*), MARGIN
      DOUBLE PRECISION LINEAR, RMS
      DOUBLE PRECISION LO(3), HI(3), Q(3), F, H, X, WANT, FIELD
      INTEGER I, J, K, T, USED, INFO, INFO2
      DO 20 K = 1, 3
         LO(K) = P(K,1)
         HI(K) = P(K,1)
         DO 10 I = 2, N
            LO(K) = MIN(LO(K), P(K,I))
            HI(K) = MAX(HI(K), P(K,I))
   10    CONTINUE
   20 CONTINUE
      LINEAR = 0.0D0
      RMS = 0.0D0
      T = 0
      USED = 0
      DO 40 J = 1, 10000
         DO 30 K = 1, 3
            CALL RANDOM(SEED, X)
            Q(K) = LO(K) + (HI(K) - LO(K))*
     1             (MARGIN + (1.0D0 - 2.0D0*MARGIN)*X)
   30    CONTINUE
         CALL BENT(P, NTET, TET, ADJ, VALUE, NONE, 0.0D0, Q, T, F, INFO)
         CALL BENT(P, NTET, TET, ADJ, VALUE, G, 0.0D0, Q, T, H, INFO2)
         IF (INFO .NE. 0 .OR. INFO2 .NE. 0) GO TO 40
         WANT = FIELD(WHICH, Q)
         LINEAR = LINEAR + (F - WANT)**2
         RMS = RMS + (H - WANT)**2
         USED = USED + 1
   40 CONTINUE
      LINEAR = SQRT(LINEAR / USED)
      RMS = SQRT(RMS / USED)
      END

C     TLINEA - a linear field comes out as it is: places to 1D-12,
C     slopes to what the values' rounding makes of them where points are
C     1D-4 apart.
      SUBROUTINE TLINEA(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION LINEAR, RMS
      INTEGER NTET, M, I, SET, INFO
      DO 20 SET = 1, 5
         CALL TRY(SET, 1000, 1, SEED, NTET, M, BAD)
         CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO)
         CALL COMPAR(M, P, NTET, TET, ADJ, VALUE, G, ZERO, 1, 0.0D0,
     1               SEED, LINEAR, RMS)
         IF (INFO .NE. 0 .OR. .NOT. (RMS .LE. 1.0D-12)) BAD = 1
         DO 10 I = 1, M
            IF (IW(I) .EQ. I .AND. .NOT.
     1          (ABS(G(1,I) - 2.0D0) .LE. 1.0D-11 .AND.
     2           ABS(G(2,I) + 3.0D0) .LE. 1.0D-11 .AND.
     3           ABS(G(3,I) - 0.5D0) .LE. 1.0D-11)) BAD = 1
   10    CONTINUE
   20 CONTINUE
      END

C     TERROR - what the header promises of errors.
      SUBROUTINE TERROR(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION LINEAR, RMS, MARGIN, MOST
      INTEGER NTET, M, SET, SIZE, J, WHICH, ROUNDS, INFO
C     Of linear interpolation's error at most 0.03, 0.25, 0.07.
      DO 10 J = 1, 3
         WHICH = 2
         SIZE = 8000
         ROUNDS = 15
         MARGIN = 0.01D0
         IF (J .EQ. 1) THEN
            MARGIN = 0.0D0
            MOST = 0.03D0
         ELSE IF (J .EQ. 2) THEN
            WHICH = 4
            ROUNDS = 3
            MOST = 0.25D0
         ELSE
            WHICH = 3
            SIZE = N
            MOST = 0.07D0
         END IF
         CALL TRY(1, SIZE, WHICH, SEED, NTET, M, BAD)
         CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, ROUNDS, G, WORK, INFO)
         CALL COMPAR(M, P, NTET, TET, ADJ, VALUE, G, ZERO, WHICH,
     1               MARGIN, SEED, LINEAR, RMS)
         IF (INFO .NE. 0 .OR. .NOT. (RMS .LE. MOST*LINEAR)) BAD = 1
   10 CONTINUE
      DO 40 SET = 1, 5
         DO 30 J = 0, 2
            CALL TRY(SET, 500*3**J, 3, SEED, NTET, M, BAD)
            DO 20 ROUNDS = 3, 15, 12
               CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, ROUNDS, G, WORK,
     1                     INFO)
               CALL COMPAR(M, P, NTET, TET, ADJ, VALUE, G, ZERO, 3,
     1                     0.0D0, SEED, LINEAR, RMS)
               IF (INFO .NE. 0 .OR. .NOT. (RMS .LE. LINEAR)) BAD = 1
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      END

C     MISFIT - S of SLOPES' header.
      SUBROUTINE MISFIT(P, NTET, TET, VALUE, G, SUM)
      INTEGER NTET, TET(4,*)
      DOUBLE PRECISION P(3,*), VALUE(*), G(3,*), SUM
      DOUBLE PRECISION E(3), D, S, SLPDOT
      INTEGER T, A, B, J, K, L
      SUM = 0.0D0
      DO 40 T = 1, NTET
         DO 30 J = 1, 3
            DO 20 L = J + 1, 4
               A = TET(J,T)
               B = TET(L,T)
               DO 10 K = 1, 3
                  E(K) = P(K,B) - P(K,A)
   10          CONTINUE
               S = (SLPDOT(G(1,A), E) + SLPDOT(G(1,B), E)) / 2.0D0
               D = VALUE(B) - VALUE(A) - S
               SUM = SUM + D*D / SLPDOT(E, E)
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      END

C     TROUND - a round never makes S larger, whatever the field.
      SUBROUTINE TROUND(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION BEFORE, AFTER
      INTEGER NTET, M, I, SET, ROUNDS, INFO
      DO 40 SET = 1, 5
         CALL TRY(SET, 300, 1, SEED, NTET, M, BAD)
         DO 10 I = 1, M
            CALL RANDOM(SEED, VALUE(I))
   10    CONTINUE
         ROUNDS = 0
         CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, ROUNDS, G, WORK, INFO)
         CALL MISFIT(P, NTET, TET, VALUE, G, BEFORE)
   20    CONTINUE
         ROUNDS = ROUNDS + 1 + ROUNDS / 4
         IF (ROUNDS .LT. 100) THEN
            CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, ROUNDS, G, WORK,
     1                  INFO)
            CALL MISFIT(P, NTET, TET, VALUE, G, AFTER)
            IF (INFO .NE. 0 .OR. .NOT. (AFTER .LE. BEFORE)) BAD = 1
            BEFORE = AFTER
            GO TO 20
         END IF
   40 CONTINUE
      END

C     TPLACE - places outside get the field of the hull's nearest point,
C     or go on from there; at a point the field is the data.
      SUBROUTINE TPLACE(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION Q(3), F(3), H(3), W(4), REST
      INTEGER NTET, M, I, J, K, L, T, INFO, INFO2
      CALL TRY(1, 1000, 3, SEED, NTET, M, BAD)
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO)
      IF (INFO .NE. 0) BAD = 1
      T = 0
      DO 10 I = 1, M
         CALL BENT(P, NTET, TET, ADJ, VALUE, G, 1.0D0, P(1,I), T, F(1),
     1             INFO)
         IF (INFO .NE. 0 .OR. F(1) .NE. VALUE(I)) BAD = 1
   10 CONTINUE
      DO 90 J = 1, 1000
         DO 20 K = 1, 3
            CALL RANDOM(SEED, Q(K))
            Q(K) = 3.0D0*Q(K) - 1.0D0
   20    CONTINUE
         DO 30 K = 1, 3
            CALL BENT(P, NTET, TET, ADJ, VALUE, G, DBLE(K-1) / 2.0D0, Q,
     1                T, F(K), INFO)
   30    CONTINUE
         CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO2)
         IF (INFO .NE. INFO2) BAD = 1
         IF (INFO .EQ. 0) THEN
            IF (F(1) .NE. F(2) .OR. F(1) .NE. F(3)) BAD = 1
            GO TO 90
         END IF
C        The gradient's way beyond, and the hull's point by TESSLO.
         DO 50 L = 1, 3
            H(L) = 0.0D0
            DO 40 K = 1, 4
               H(L) = H(L) + W(K)*P(L,TET(K,T))
   40       CONTINUE
   50    CONTINUE
         REST = F(3) - F(1)
         DO 70 K = 1, 4
            DO 60 L = 1, 3
               REST = REST - W(K)*G(L,TET(K,T))*(Q(L) - H(L))
   60       CONTINUE
   70    CONTINUE
         IF (.NOT. (ABS(REST) .LE. 1.0D-12)) BAD = 1
         IF (.NOT. (ABS(F(2) - (F(1) + F(3)) / 2.0D0) .LE. 1.0D-12))
     1      BAD = 1
   90 CONTINUE
      END

C     TSIZES - coordinates times a power of two: the same field; so too
C     four points, whose gradient is that of a tetrahedron.
      SUBROUTINE TSIZES(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION Q(3), F, H, SCALE, FIELD
      INTEGER NTET, M, I, J, K, T, INFO, INFO2
      DO 20 I = 1, 4
         DO 10 K = 1, 3
            P(K,I) = 0.0D0
            IF (I .EQ. K + 1) P(K,I) = 1.0D0
   10    CONTINUE
         VALUE(I) = FIELD(1, P(1,I))
   20 CONTINUE
      CALL TESS(4, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL SLOPES(4, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO2)
      IF (INFO .NE. 0 .OR. INFO2 .NE. 0) BAD = 1
      DO 30 I = 1, 4
         IF (.NOT. (ABS(G(1,I) - 2.0D0) + ABS(G(2,I) + 3.0D0) +
     1       ABS(G(3,I) - 0.5D0) .LE. 1.0D-12)) BAD = 1
   30 CONTINUE
C     2**166 is 9D49; its square and the inverse of that are doubles.
      CALL TRY(1, 500, 3, SEED, NTET, M, BAD)
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 15, G, WORK, INFO2)
      DO 50 I = 1, M
         DO 40 K = 1, 3
            OLD(K,I) = G(K,I)
   40    CONTINUE
   50 CONTINUE
      DO 60 K = 1, 3
         Q(K) = 0.2D0 + 0.1D0*K
   60 CONTINUE
      T = 0
      CALL BENT(P, NTET, TET, ADJ, VALUE, G, 0.0D0, Q, T, F, INFO)
      IF (INFO .NE. 0 .OR. INFO2 .NE. 0) BAD = 1
      DO 120 J = 1, 2
         SCALE = 2.0D0**166
         IF (J .EQ. 2) SCALE = 1.0D0 / SCALE**2
         DO 80 K = 1, 3
            Q(K) = Q(K)*SCALE
            DO 70 I = 1, M
               P(K,I) = P(K,I)*SCALE
   70       CONTINUE
   80    CONTINUE
         IF (J .EQ. 2) SCALE = 1.0D0 / 2.0D0**166
         CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
         CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 15, G, WORK, INFO2)
         IF (INFO .NE. 0 .OR. INFO2 .NE. 0) BAD = 1
         DO 100 I = 1, M
            DO 90 K = 1, 3
               IF (.NOT. (ABS(G(K,I)*SCALE - OLD(K,I)) .LE. 1.0D-12))
     1            BAD = 1
   90       CONTINUE
  100    CONTINUE
         CALL BENT(P, NTET, TET, ADJ, VALUE, G, 0.0D0, Q, T, H, INFO)
         IF (INFO .NE. 0 .OR. .NOT. (ABS(H - F) .LE. 1.0D-12)) BAD = 1
  120 CONTINUE
      END

C     TFLAT - linear fields in sets that are flat, and in units of any
C     size: each side of the box has its part of the field.  A gradient
C     that no double holds has a code.
      SUBROUTINE TFLAT(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION BOX(3,8), LOW(3), C(3), Q(3), W(4), SUM, F, WANT
      INTEGER NTET, M, SET, TURNED, T, I, J, K, V, INFO, INFO2
      SAVE BOX
      DATA BOX /1D0, 1D0, 1D-3, 1D0, 1D0, 1D-6, 1D0, 1D-10, 1D0,
     1   1D0, 1D0, 1D-15, 1D0, 1D0, 1D-30, 1D-160, 1D0, 1D0,
     2   1D-160, 1D-160, 1D-160, 1D150, 1D150, 1D150/
      DO 130 SET = 0, 15
         T = 0
         TURNED = MOD(SET, 2)
         I = 1
         IF (MOD(SET, 4) .EQ. 0) I = 2
         CALL MAKE(I, 343, SEED, M, P)
         DO 30 I = 1, M
            DO 10 K = 1, 3
               P(K,I) = P(K,I)*BOX(K,SET/2+1)
   10       CONTINUE
            DO 20 K = 1, 2*TURNED
               SUM = P(K,I)
               P(K,I) = 0.8D0*SUM - 0.6D0*P(K+1,I)
               P(K+1,I) = 0.6D0*SUM + 0.8D0*P(K+1,I)
   20       CONTINUE
   30    CONTINUE
         CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
         DO 50 K = 1, 3
            LOW(K) = P(K,1)
            C(K) = P(K,1)
            DO 40 I = 2, M
               LOW(K) = MIN(LOW(K), P(K,I))
               C(K) = MAX(C(K), P(K,I))
   40       CONTINUE
            C(K) = (K - 2.5D0) / (C(K) - LOW(K))
   50    CONTINUE
         DO 70 I = 1, M
            VALUE(I) = 7.0D0
            DO 60 K = 1, 3
               VALUE(I) = VALUE(I) + C(K)*(P(K,I) - LOW(K))
   60       CONTINUE
   70    CONTINUE
         CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO2)
         IF (INFO .NE. 0 .OR. INFO2 .NE. 0) BAD = 1
         DO 120 J = 1, 500
            CALL RANDOM(SEED, F)
            V = INT(F*NTET) + 1
            SUM = 0.0D0
            DO 80 K = 1, 4
               CALL RANDOM(SEED, W(K))
               SUM = SUM + W(K)
   80       CONTINUE
            WANT = 7.0D0
            DO 100 K = 1, 3
               Q(K) = 0.0D0
               DO 90 I = 1, 4
                  Q(K) = Q(K) + W(I) / SUM*P(K,TET(I,V))
   90          CONTINUE
               WANT = WANT + C(K)*(Q(K) - LOW(K))
  100       CONTINUE
            CALL BENT(P, NTET, TET, ADJ, VALUE, G, 0.0D0, Q, T, F, INFO)
            IF (INFO .NE. 0 .AND. INFO .NE. 1) BAD = 1
            IF (.NOT. (ABS(F - WANT) .LE. 1.0D-12)) BAD = 1
  120    CONTINUE
  130 CONTINUE
      CALL MAKE(1, 300, SEED, M, P)
      DO 150 I = 1, M
         DO 140 K = 1, 3
            P(K,I) = P(K,I)*1D-300
  140    CONTINUE
         VALUE(I) = 1D10*MOD(I - 1, 7)
  150 CONTINUE
      CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO2)
      IF (INFO .NE. 0 .OR. INFO2 .NE. 6) BAD = 1
      END

C     TCODES - bad arguments, damaged and unfinished meshes get a code.
      SUBROUTINE TCODES(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 52850, MAXTET = 8*N, LIW = 11*N + 226000)
      PARAMETER (LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), G(3,N), OLD(3,N)
      DOUBLE PRECISION WORK(9*N), ZERO(3,N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /FIELDS/ P, RW, VALUE, G, OLD, WORK, ZERO
      COMMON /MESHES/ TET, ADJ, IW
      INTEGER SEED, BAD
      DOUBLE PRECISION F
      INTEGER NTET, M, HELD, T, INFO(8), K, WANT(8)
      SAVE WANT
      DATA WANT /10, 10, -7, -1, -3, -2, 1, 13/
      CALL TRY(1, 500, 3, SEED, NTET, M, BAD)
      HELD = TET(2,20)
      TET(2,20) = M + 1
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO(1))
      TET(2,20) = 0
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO(2))
      TET(2,20) = HELD
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, -1, G, WORK, INFO(3))
      CALL SLOPES(0, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO(4))
      CALL SLOPES(M, P, 0, TET, ADJ, VALUE, 3, G, WORK, INFO(5))
      T = 0
      CALL BENT(P, 0, TET, ADJ, VALUE, G, 0.0D0, P(1,1), T, F,
     1          INFO(6))
      CALL TESS(M, P, 200, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO(7))
      CALL SLOPES(M, P, NTET, TET, ADJ, VALUE, 3, G, WORK, INFO(8))
      DO 10 K = 1, 8
         IF (INFO(K) .NE. WANT(K)) BAD = 1
   10 CONTINUE
      END
