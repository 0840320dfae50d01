C     t_natural.f - natural.f's weights between two points of an
C     integer lattice, which have a closed form, and TRBLEN by the
C     gradient of |x|**2.  t_natural.c is the same in C, and both
C     write the same text.
C
C         gfortran -O2 test/recipes/t/t_natural.f
C        1    test/recipes/natural.f f77/tess.f f77/hhpred.f
C
      PROGRAM NATLAT
      INTEGER LIW, LRW
      PARAMETER (LIW = 1700, LRW = 665)
      DOUBLE PRECISION P(3,36), Q(3), RW(LRW), SIBSON(53), LAPLAC(53)
      DOUBLE PRECISION VALUE(36), G(3,36), OUT
      INTEGER TET(4,200), ADJ(4,200), IW(LIW), NBR(53), T, NN, NTET, I
      INTEGER K, INFO
      DATA Q /0.25D0, 0.0D0, 0.0D0/
      DO 20 I = 1, 36
         P(1,I) = MOD(I - 1, 4) - 1
         P(2,I) = MOD((I - 1) / 4, 3) - 1
         P(3,I) = MOD((I - 1) / 12, 3) - 1
         VALUE(I) = P(1,I)**2 + P(2,I)**2 + P(3,I)**2
         DO 10 K = 1, 3
            G(K,I) = 2.0D0*P(K,I)
   10    CONTINUE
   20 CONTINUE
      CALL TESS(36, P, 200, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .NE. 0) STOP
      T = 0
      CALL TRNATU(P, NTET, TET, ADJ, Q, T, 50, NN, NBR, SIBSON, LAPLAC,
     1            IW, RW, INFO)
      IF (INFO .NE. 0) STOP
      WRITE (*, 40)
      DO 30 I = 1, NN
         WRITE (*, 50) (INT(P(K,NBR(I))), K = 1, 3), SIBSON(I),
     1                 LAPLAC(I)
   30 CONTINUE
      CALL TRBLEN(P, NN, NBR, SIBSON, VALUE, G, OUT)
      WRITE (*, 60) OUT
   40 FORMAT ('   point  Sibson    Laplace')
   50 FORMAT (I2, I3, I3, F11.7, F10.7)
   60 FORMAT ('|x|^2 blended:', F10.7)
      END
