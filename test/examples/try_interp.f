C     try_interp.f - interp.f's grid of values, in the blank of a
C     telescope's mirror.
C
C         gfortran -O2 test/examples/try_interp.f
C           test/examples/interp.f f77/tess.f f77/hhpred.f
C
C     try_interp.c, which says more, is the same in C; both write the
C     same text.
      PROGRAM INTERP
      INTEGER FINEST, MAXPTS, MAXTET, LIW, LRW, NX, NY, NZ
      PARAMETER (FINEST = 4)
      PARAMETER (MAXPTS = (6*FINEST+1)*(2*FINEST+1)*32*FINEST)
      PARAMETER (MAXTET = 8*MAXPTS, LIW = 19*MAXPTS + 1800)
      PARAMETER (LRW = 4*MAXPTS + 12, NX = 41, NY = 39, NZ = 24)
      DOUBLE PRECISION OUTSID, ROUND, BEND
      PARAMETER (OUTSID = -99.0D0, ROUND = 1.0D-12)
C     M: the square of 1 - depth has the second derivative 2/THICK**2
C     across the layers, and less along them; R2 has 2 in x and y.
      PARAMETER (BEND = 3.0D0/0.3D0**2 + 0.8D0/1.2D0**2)
      DOUBLE PRECISION P(3,MAXPTS), VALUE(2,MAXPTS), RW(LRW)
      DOUBLE PRECISION OUT(2,NX*NY*NZ), ROW(3,NX), BOX(2,3), W(4), Q(3)
      DOUBLE PRECISION R, DEPTH, ERROR, BOUND, MOST, SUM, OLD, ORDER
      DOUBLE PRECISION DEPTHO, FIELD, PLANE
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), START(NX), AT(3)
      INTEGER SIZE(3), SINGLE(3), NONE(3), BAD(4), N, NTET, T, INFO
      INTEGER LEVEL, FINE, I, J, K, AX, AY, AZ, F, PTS, BEYOND
      CHARACTER*3 ANSWER(0:1)
      COMMON /LARGE/ P, VALUE, RW, OUT, TET, ADJ, IW
      DATA SIZE /NX, NY, NZ/, SINGLE /1, 1, 1/, NONE /NX, 0, NZ/
      DATA BOX /-1.2D0, 1.2D0, -1.2D0, 1.2D0, -0.31D0, 0.08D0/
      DATA BAD /0, 0, 0, 0/, ANSWER /'yes', 'NO'/, OLD /0.0D0/
      WRITE (*, 80)
      DO 60 LEVEL = 0, 2
         FINE = 2**LEVEL
         CALL SENSOR(FINE, N, P, VALUE)
         CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
         IF (INFO .NE. 0) THEN
            WRITE (*, *) 'TESS: code ', INFO
            STOP
         END IF
         CALL ONGRID(P, NTET, TET, ADJ, 2, VALUE, SIZE, BOX, OUTSID,
     1               START, ROW, OUT, INFO)
         IF (INFO .NE. 1) BAD(1) = 1
         PTS = 0
         BEYOND = 0
         MOST = 0.0D0
         SUM = 0.0D0
         F = 0
         T = 0
         DO 50 AZ = 0, NZ - 1
            DO 40 AY = 0, NY - 1
               DO 30 AX = 0, NX - 1
                  F = F + 1
                  AT(1) = AX
                  AT(2) = AY
                  AT(3) = AZ
                  DO 10 K = 1, 3
                     Q(K) = DBLE(AT(K)) / DBLE(SIZE(K) - 1)
                     Q(K) = BOX(1,K) + Q(K)*(BOX(2,K) - BOX(1,K))
   10             CONTINUE
                  R = SQRT(Q(1)*Q(1) + Q(2)*Q(2))
                  DEPTH = DEPTHO(Q)
                  IF (R .GT. 1.2D0 + 1.0D-5 .OR.
     1                DEPTH .GT. 1.0D0 + 1.0D-5) THEN
                     IF (OUT(1,F) .GT. OUTSID .OR.
     1                   OUT(2,F) .GT. OUTSID) BAD(1) = 1
                     BEYOND = BEYOND + 1
                  END IF
C                 The glass, but for what polygons of sensors leave
C                 outside.
                  IF (R .LT. 0.31D0 .OR. R .GT. 1.16D0 .OR.
     1                DEPTH .LT. 0.03D0 .OR. DEPTH .GT. 0.97D0) GO TO 30
                  CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
C                 Outside of the sensors' hull.
                  IF (INFO .NE. 0) BAD(1) = 1
                  BOUND = 0.0D0
                  DO 20 I = 1, 4
                     J = TET(I,T)
                     BOUND = BOUND + W(I)*((P(1,J) - Q(1))**2 +
     1                       (P(2,J) - Q(2))**2 + (P(3,J) - Q(3))**2)
   20             CONTINUE
                  ERROR = ABS(OUT(1,F) - FIELD(Q))
                  IF (.NOT. (ERROR .LE. BEND/2.0D0*BOUND + ROUND))
     1               BAD(2) = 1
                  MOST = MAX(MOST, ERROR)
                  SUM = SUM + ERROR*ERROR
                  IF (.NOT. (ABS(OUT(2,F) - PLANE(Q)) .LE. ROUND))
     1               BAD(3) = 1
                  PTS = PTS + 1
   30          CONTINUE
   40       CONTINUE
   50    CONTINUE
         SUM = SQRT(SUM / DBLE(PTS))
         IF (LEVEL .EQ. 0) THEN
            WRITE (*, 90) N, NTET, PTS, BEYOND, MOST, SUM
         ELSE
            ORDER = LOG(OLD / SUM) / LOG(2.0D0)
            WRITE (*, 90) N, NTET, PTS, BEYOND, MOST, SUM, ORDER
            IF (ORDER .LT. 1.8D0 .OR. ORDER .GT. 2.2D0) BAD(4) = 1
         END IF
         OLD = SUM
   60 CONTINUE
C     One place is in the middle.
      CALL ONGRID(P, NTET, TET, ADJ, 2, VALUE, SINGLE, BOX, OUTSID,
     1            START, ROW, OUT, INFO)
      IF (INFO .NE. 0) BAD(3) = 1
      IF (.NOT. (ABS(OUT(2,1) - (1.0D0 - 4.0D0*0.115D0)) .LE. ROUND))
     1   BAD(3) = 1
      CALL ONGRID(P, NTET, TET, ADJ, 2, VALUE, NONE, BOX, OUTSID, START,
     1            ROW, OUT, INFO)
      IF (INFO .NE. -7) BAD(3) = 1
      WRITE (*, 100) (ANSWER(BAD(I)), I = 1, 4)
   80 FORMAT ('sensors  tetrahedra  in the glass  outside  largest ',
     1        'error  root mean square  order')
   90 FORMAT (I7, 2X, I10, 2X, I12, 2X, I7, 2X, F11.4, ' C', 2X, F14.5,
     1        ' C', :, 2X, F5.2)
  100 FORMAT ('inside and outside of the hull where it is: ', A /
     1        'every error within the bound of theory:     ', A /
     2        'a linear field interpolated, to rounding:   ', A /
     3        'errors of second order in the spacing:      ', A)
      END

C     RANDOM - a random number, 0 <= X < 1.  SEED: a whole number below
C     2**32; products are exact.
      SUBROUTINE RANDOM(SEED, X)
      DOUBLE PRECISION SEED, X
      SEED = MOD(SEED*1664525.0D0 + 1013904223.0D0, 2.0D0**32)
      X = AINT(SEED/256.0D0) / 2.0D0**24
      END

C     DEPTHO - 0 at the front, 1 at the back.
      DOUBLE PRECISION FUNCTION DEPTHO(Q)
      DOUBLE PRECISION Q(3)
      DOUBLE PRECISION ABOVE
      ABOVE = 11.0D0 - Q(3)
      DEPTHO = (SQRT(Q(1)*Q(1) + Q(2)*Q(2) + ABOVE*ABOVE) - 11.0D0)
     1         / 0.3D0
      END

C     FIELD - the temperature in degrees C: colder at the front, and
C     more so the nearer to it.
      DOUBLE PRECISION FUNCTION FIELD(Q)
      DOUBLE PRECISION Q(3)
      DOUBLE PRECISION DEPTH, DEPTHO
      DEPTH = DEPTHO(Q)
      FIELD = 11.0D0 - 1.5D0*(1.0D0 - DEPTH)*(1.0D0 - DEPTH) +
     1        0.2D0*Q(1)/1.2D0 +
     2        0.4D0*(Q(1)*Q(1) + Q(2)*Q(2))/(1.2D0*1.2D0)
      END

      DOUBLE PRECISION FUNCTION PLANE(Q)
      DOUBLE PRECISION Q(3)
      PLANE = 1.0D0 + 2.0D0*Q(1) - 3.0D0*Q(2) + 4.0D0*Q(3)
      END

C     SENSOR - put sensors into the blank, FINE times as close as on the
C     first level, and read them; N of them.
      SUBROUTINE SENSOR(FINE, N, P, VALUE)
      INTEGER FINE, N
      DOUBLE PRECISION P(3,*), VALUE(2,*)
      DOUBLE PRECISION SEED, TURN, R, A, DEPTH, X, SPHERE, FIELD, PLANE
      INTEGER I, J, K, M, RINGS, LAYERS, ANGLES
      SAVE SEED
      DATA SEED /1.0D0/
      TURN = 8.0D0*ATAN(1.0D0)
      RINGS = 6*FINE
      LAYERS = 2*FINE
      ANGLES = 32*FINE
      N = 0
      DO 40 I = 0, RINGS
         DO 30 J = 0, LAYERS
            DO 20 K = 0, ANGLES - 1
               N = N + 1
               R = DBLE(I)
               IF (I .GT. 0 .AND. I .LT. RINGS) THEN
                  CALL RANDOM(SEED, X)
                  R = R + 0.6D0*(X - 0.5D0)
               END IF
               DEPTH = DBLE(J)
               IF (J .GT. 0 .AND. J .LT. LAYERS) THEN
                  CALL RANDOM(SEED, X)
                  DEPTH = DEPTH + 0.6D0*(X - 0.5D0)
               END IF
               CALL RANDOM(SEED, X)
               A = TURN*(DBLE(K) + 0.6D0*(X - 0.5D0)) / DBLE(ANGLES)
               R = 0.3D0 + (1.2D0 - 0.3D0)*R / DBLE(RINGS)
               SPHERE = 11.0D0 + 0.3D0*(DEPTH / DBLE(LAYERS))
               P(1,N) = R*COS(A)
               P(2,N) = R*SIN(A)
               P(3,N) = 11.0D0 - SQRT(SPHERE*SPHERE - R*R)
C              In whole micrometres.
               DO 10 M = 1, 3
                  P(M,N) = ANINT(P(M,N)*1.0D6) / 1.0D6
   10          CONTINUE
               VALUE(1,N) = FIELD(P(1,N))
               VALUE(2,N) = PLANE(P(1,N))
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      END
