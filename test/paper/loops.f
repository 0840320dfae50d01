C     loops.f - what the timings measure: set up once, then N
C     evaluations at the NZ points Z in turn, whose values V are
C     returned so that none can be left out.  P: the facet p1, p2, p3,
C     and p4.
C
C     The twin of loops.c.

C     LPHOUS - L-coordinates by HHPRED
      SUBROUTINE LPHOUS(N, P, NZ, Z, V)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), V(*)
      DOUBLE PRECISION HHLCOO
      DOUBLE PRECISION F(12)
      INTEGER I, J
      CALL HHFACE(P(1,1), P(1,2), P(1,3), F, J)
      J = 1
      DO 10 I = 1, N
        V(J) = HHLCOO(F, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      END

C     LPDETS - determinants by minors
      SUBROUTINE LPDETS(N, P, NZ, Z, V)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), V(*)
      DOUBLE PRECISION DTDET
      DOUBLE PRECISION M(5)
      INTEGER I, J
      CALL DTMINO(P, M)
      J = 1
      DO 10 I = 1, N
        V(J) = DTDET(M, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      END

C     LPBLAS - L-coordinates by BLAS
      SUBROUTINE LPBLAS(N, P, NZ, Z, V)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), V(*)
      DOUBLE PRECISION BLLCOO
      DOUBLE PRECISION F(9)
      INTEGER I, J
      CALL BLFACE(P(1,1), P(1,2), P(1,3), F, J)
      J = 1
      DO 10 I = 1, N
        V(J) = BLLCOO(F, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      END

C     LPCALL - the calls of that, of vectors of length 0
      SUBROUTINE LPCALL(N, P, NZ, Z, V)
      INTEGER N, NZ
      DOUBLE PRECISION P(3,4), Z(3,*), V(*)
      DOUBLE PRECISION BLCALL
      DOUBLE PRECISION F(9)
      INTEGER I, J
      CALL BLFACE(P(1,1), P(1,2), P(1,3), F, J)
      J = 1
      DO 10 I = 1, N
        V(J) = BLCALL(F, Z(1,J))
        J = J + 1
        IF (J .GT. NZ) J = 1
   10 CONTINUE
      END
