C     loops.f - what the timings measure: set up once, then N
C     evaluations at the NZ points Z in turn, whose SUM is returned so
C     that none can be left out.  P: the facet p1, p2, p3, and p4.
C
C     The twin of loops.c.

C     LPHOUS - L-coordinates by HHPRED
      SUBROUTINE LPHOUS(N, P, NZ, Z, SUM)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), SUM
      DOUBLE PRECISION HHLCOO
      DOUBLE PRECISION F(12), S
      INTEGER I, J
      CALL HHFACE(P(1,1), P(1,2), P(1,3), F, J)
      S = 0.0D0
      J = 1
      DO 10 I = 1, N
        S = S + HHLCOO(F, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      SUM = S
      END

C     LPDETS - determinants by minors
      SUBROUTINE LPDETS(N, P, NZ, Z, SUM)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), SUM
      DOUBLE PRECISION DTDET
      DOUBLE PRECISION M(5), S
      INTEGER I, J
      CALL DTMINO(P, M)
      S = 0.0D0
      J = 1
      DO 10 I = 1, N
        S = S + DTDET(M, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      SUM = S
      END

C     LPBLAS - L-coordinates by BLAS
      SUBROUTINE LPBLAS(N, P, NZ, Z, SUM)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), SUM
      DOUBLE PRECISION BLLCOO
      DOUBLE PRECISION F(9), S
      INTEGER I, J
      CALL BLFACE(P(1,1), P(1,2), P(1,3), F, J)
      S = 0.0D0
      J = 1
      DO 10 I = 1, N
        S = S + BLLCOO(F, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      SUM = S
      END
