C     try_surface.f - surface.f's hull of points, written as OBJ and as
C     STL, and read again.
C
C         gfortran -O2 test/examples/try_surface.f
C           test/examples/surface.f f77/tess.f f77/hhpred.f
C
C     try_surface.c, which says more, is the same in C; both write the
C     same text.
      PROGRAM SURFAC
      INTEGER N, WITHIN, MAXTET, MAXFAC, LIW, LRW
      PARAMETER (N = 2000, WITHIN = 1000, MAXTET = 8*N, MAXFAC = 2*N)
      PARAMETER (LIW = 19*N + 1800, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), V(3,N), Q(3,3), C(3)
      DOUBLE PRECISION VOLUME, FILLED, READ1, READ2, LEAST, MOST, BALL
      DOUBLE PRECISION LOW, HIGH
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FAC(3,MAXFAC)
      INTEGER NUMBER(N), NEXT(3*MAXFAC), HEAD(N), TRI(3), BAD(6)
      INTEGER NTET, NFAC, INFO, EDGES, POINTS, F, I, K, T, FOUND
      CHARACTER*3 ANSWER(0:1)
      CHARACTER*80 LINE
      COMMON /LARGE/ P, RW, V, TET, ADJ, IW, FAC, NUMBER, NEXT, HEAD
      DATA BAD /0, 0, 0, 0, 0, 0/, ANSWER /'yes', 'NO'/
      CALL ELLIPS(N, P)
      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .EQ. 0)
     1   CALL TESSHU(NTET, TET, ADJ, MAXFAC, NFAC, FAC, INFO)
      IF (INFO .NE. 0) THEN
         WRITE (*, *) 'TESS: code ', INFO
         STOP
      END IF
      DO 10 I = 1, N
         NUMBER(I) = 0
         HEAD(I) = 0
   10 CONTINUE
      DO 30 F = 1, NFAC
         DO 20 K = 1, 3
            NUMBER(FAC(K,F)) = 1
   20    CONTINUE
   30 CONTINUE
      POINTS = 0
      DO 40 I = 1, N
         POINTS = POINTS + NUMBER(I)
         IF (NUMBER(I) .EQ. 1 .NEQV. I .LE. N - WITHIN) BAD(5) = 1
   40 CONTINUE
      EDGES = 3*NFAC/2
      CALL ENCLOS(P, NFAC, FAC, VOLUME)
      WRITE (*, 110) N, NTET, POINTS, EDGES, NFAC, VOLUME
C     Is every edge there once in either direction?  Those that begin at
C     a point are in a list, linked in NEXT: 3*(F-1) + K for side K.
      DO 60 F = 1, NFAC
         DO 50 K = 1, 3
            CALL SIDES(FAC, HEAD, NEXT, FAC(K,F),
     1                 FAC(MOD(K, 3)+1,F), FOUND)
            IF (FOUND .NE. 0) BAD(1) = 1
            I = FAC(K,F)
            NEXT(3*(F-1)+K) = HEAD(I)
            HEAD(I) = 3*(F-1) + K
   50    CONTINUE
   60 CONTINUE
      DO 70 F = 1, NFAC
         DO 65 K = 1, 3
            CALL SIDES(FAC, HEAD, NEXT, FAC(MOD(K, 3)+1,F), FAC(K,F),
     1                 FOUND)
            IF (FOUND .NE. 1) BAD(1) = 1
   65    CONTINUE
   70 CONTINUE
      IF (POINTS - EDGES + NFAC .NE. 2) BAD(2) = 1
      FILLED = 0.0D0
      DO 80 T = 1, NTET
         CALL CONE(P(1,TET(3,T)), P(1,TET(2,T)), P(1,TET(1,T)),
     1             P(1,TET(4,T)), FILLED)
   80 CONTINUE
      IF (ABS(VOLUME - FILLED) .GT. 1.0D-12*VOLUME) BAD(3) = 1
      CALL RANGE(P, NFAC, FAC, LEAST, MOST)
      BALL = 16.0D0/3.0D0*ATAN(1.0D0)*6.0D0
      LOW = BALL*LEAST**3
      HIGH = BALL*MOST**3
      WRITE (*, 120) LOW, HIGH
      IF (VOLUME .LT. LOW .OR. VOLUME .GT. HIGH .OR.
     1    HIGH .GT. BALL*(1.0D0 + 1.0D-5)) BAD(4) = 1
C     The files, read again.
      OPEN (10, STATUS='SCRATCH', FORM='FORMATTED')
      CALL PUTOBJ(10, N, P, NFAC, FAC, 9, NUMBER, INFO)
      IF (INFO .NE. 0) BAD(6) = 1
      REWIND 10
      READ1 = 0.0D0
      DO 90 I = 1, POINTS
         READ (10, 140) LINE(1:1), (V(K,I), K = 1, 3)
         IF (LINE(1:1) .NE. 'v') BAD(6) = 1
   90 CONTINUE
      DO 95 F = 1, NFAC
         READ (10, 150) LINE(1:1), TRI
         IF (LINE(1:1) .NE. 'f') BAD(6) = 1
         CALL CONE(V(1,TRI(1)), V(1,TRI(2)), V(1,TRI(3)), V(1,1),
     1             READ1)
   95 CONTINUE
      CLOSE (10)
      OPEN (10, STATUS='SCRATCH', FORM='FORMATTED')
      CALL PUTSTL(10, P, NFAC, FAC, 9, INFO)
      IF (INFO .NE. 0) BAD(6) = 1
      REWIND 10
      READ (10, '(A)') LINE
      READ2 = 0.0D0
      DO 100 F = 1, NFAC
         READ (10, 160) LINE(1:12), C
         IF (LINE(1:12) .NE. 'facet normal') BAD(6) = 1
         IF (ABS(C(1)**2 + C(2)**2 + C(3)**2 - 1.0D0) .GT. 1.0D-5)
     1      BAD(6) = 1
         READ (10, '(A)') LINE
         DO 98 I = 1, 3
            READ (10, 140) LINE(1:8), (Q(K,I), K = 1, 3)
            IF (LINE(1:8) .NE. '  vertex') BAD(6) = 1
   98    CONTINUE
         CALL CONE(Q(1,1), Q(1,2), Q(1,3), P(1,1), READ2)
         READ (10, '(A)') LINE
         READ (10, '(A)') LINE
  100 CONTINUE
      CLOSE (10)
      IF (ABS(READ1 - VOLUME) .GT. 1.0D-6*VOLUME) BAD(6) = 1
      IF (ABS(READ2 - VOLUME) .GT. 1.0D-6*VOLUME) BAD(6) = 1
      WRITE (*, 130) ANSWER(BAD(1)), ANSWER(BAD(2)), ANSWER(BAD(3)),
     1               ANSWER(BAD(6)), ANSWER(BAD(4)), ANSWER(BAD(5))
  110 FORMAT ('points             ', I4 /
     1        'tetrahedra         ', I5 /
     2        'surface            ', I4, ' vertices, ', I4,
     3        ' edges, ', I4, ' triangles' /
     4        'volume             ', F7.4)
  120 FORMAT ('ellipsoids         ', F7.4, ' inside, ', F7.4,
     1        ' outside')
  130 FORMAT ('the surface is closed:                        ', A /
     1        'Euler''s relation holds:                       ', A /
     2        'it encloses the volume of the tetrahedra:     ', A /
     3        'so do the files, read again:                  ', A /
     4        'it is between those of the two ellipsoids:    ', A /
     5        'its vertices are the points on the ellipsoid: ', A)
  140 FORMAT (A, 3(1X, E18.9))
  150 FORMAT (A, 3(1X, I10))
  160 FORMAT (A, 3(1X, E14.7))
      END

C     ELLIPS - a spiral on the unit sphere, and random points inside,
C     stretched; in multiples of 2**(-22), for the same on every
C     machine.
      SUBROUTINE ELLIPS(N, P)
      INTEGER N
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION Q(3), R, ANGLE, SEED, AXIS(3)
      INTEGER I, K, ON
      SAVE AXIS
      DATA AXIS /3.0D0, 2.0D0, 1.0D0/
      SEED = 1.0D0
      ON = N/2
      I = 0
   10 CONTINUE
      IF (I .LT. ON) THEN
         Q(3) = 1.0D0 - (2.0D0*I + 1.0D0) / DBLE(ON)
         R = SQRT(1.0D0 - Q(3)*Q(3))
         ANGLE = 4.0D0*ATAN(1.0D0)*(3.0D0 - SQRT(5.0D0))*I
         Q(1) = R*COS(ANGLE)
         Q(2) = R*SIN(ANGLE)
      ELSE
         DO 20 K = 1, 3
            SEED = MOD(SEED*1664525.0D0 + 1013904223.0D0, 2.0D0**32)
            Q(K) = 2.0D0*(AINT(SEED/256.0D0) / 2.0D0**24) - 1.0D0
   20    CONTINUE
         IF (.NOT. (Q(1)*Q(1) + Q(2)*Q(2) + Q(3)*Q(3) .LT. 0.9D0))
     1      GO TO 10
      END IF
      I = I + 1
      DO 30 K = 1, 3
         P(K,I) = ANINT(AXIS(K)*Q(K)*2.0D0**22) / 2.0D0**22
   30 CONTINUE
      IF (I .LT. N) GO TO 10
      END

C     SIDES - how many sides from A to B are in the lists.
      SUBROUTINE SIDES(FAC, HEAD, NEXT, A, B, FOUND)
      INTEGER FAC(3,*), HEAD(*), NEXT(*), A, B, FOUND
      INTEGER F, K, S
      FOUND = 0
      S = HEAD(A)
   10 CONTINUE
      IF (S .EQ. 0) RETURN
      F = (S-1)/3 + 1
      K = S - 3*(F-1)
      IF (FAC(MOD(K, 3)+1,F) .EQ. B) FOUND = FOUND + 1
      S = NEXT(S)
      GO TO 10
      END

C     CROSS - E = the cross product of two edges of the triangle A B C.
      SUBROUTINE CROSS(A, B, C, E)
      DOUBLE PRECISION A(3), B(3), C(3), E(3)
      INTEGER I, J, K
      DO 10 K = 1, 3
         I = MOD(K, 3) + 1
         J = MOD(K+1, 3) + 1
         E(K) = (B(I) - A(I))*(C(J) - A(J)) -
     1          (B(J) - A(J))*(C(I) - A(I))
   10 CONTINUE
      END

C     CONE - add the volume between the triangle A B C and the point O.
      SUBROUTINE CONE(A, B, C, O, SUM)
      DOUBLE PRECISION A(3), B(3), C(3), O(3), SUM
      DOUBLE PRECISION E(3)
      CALL CROSS(A, B, C, E)
      SUM = SUM + ((A(1) - O(1))*E(1) + (A(2) - O(2))*E(2) +
     1             (A(3) - O(3))*E(3)) / 6.0D0
      END

C     RANGE - the least distance of a triangle's plane from the middle,
C     and the largest of a point, where the ellipsoid is the unit
C     sphere.
      SUBROUTINE RANGE(P, NFAC, FAC, LEAST, MOST)
      DOUBLE PRECISION P(3,*), LEAST, MOST
      INTEGER NFAC, FAC(3,*)
      DOUBLE PRECISION Q(3,3), C(3)
      INTEGER F, I, K
      LEAST = 1.0D30
      MOST = 0.0D0
      DO 30 F = 1, NFAC
         DO 20 I = 1, 3
            DO 10 K = 1, 3
               Q(K,I) = P(K,FAC(I,F)) / DBLE(4 - K)
   10       CONTINUE
            MOST = MAX(MOST, SQRT(Q(1,I)**2 + Q(2,I)**2 + Q(3,I)**2))
   20    CONTINUE
         CALL CROSS(Q(1,1), Q(1,2), Q(1,3), C)
         LEAST = MIN(LEAST, (Q(1,1)*C(1) + Q(2,1)*C(2) + Q(3,1)*C(3)) /
     1                      SQRT(C(1)**2 + C(2)**2 + C(3)**2))
   30 CONTINUE
      END
