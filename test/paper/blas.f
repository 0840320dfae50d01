C     blas.f - the Householder predicates of Section 3 with BLAS calls,
C     as the paper tried them: the formulas of hhpred.f, every vector
C     operation a call of level 1.  The BLAS is a library's or level1.f.
C
C     The twin of blas.c, in DOUBLE PRECISION.

C     BLMINU - W = A - B
      SUBROUTINE BLMINU(A, B, W)
      DOUBLE PRECISION A(3), B(3), W(3)
      CALL DCOPY(3, A, 1, W, 1)
      CALL DAXPY(3, -1.0D0, B, 1, W, 1)
      END

C     BLREFR - U and B of the reflector I - B U U' that takes X, N
C     components, to R e1; ZERO is 1 for a zero divide.
      SUBROUTINE BLREFR(N, X, U, B, R, ZERO)
      INTEGER N, ZERO
      DOUBLE PRECISION X(N), U(N), B, R
      DOUBLE PRECISION DNRM2
      DOUBLE PRECISION NORM, T
      NORM = DNRM2(N, X, 1)
      R = NORM
      IF (X(1) .GT. 0.0D0) R = -NORM
      CALL DCOPY(N, X, 1, U, 1)
      U(1) = U(1) - R
      T = NORM*(NORM + ABS(X(1)))
      B = 0.0D0
      ZERO = 1
      IF (ABS(T) .LE. 0.0D0) RETURN
      B = 1.0D0/T
      ZERO = 0
      END

C     BLREFL - X turned by a reflector
      SUBROUTINE BLREFL(N, U, B, X)
      INTEGER N
      DOUBLE PRECISION U(N), B, X(N)
      DOUBLE PRECISION DDOT
      CALL DAXPY(N, -B*DDOT(N, U, 1, X, 1), U, 1, X, 1)
      END

C     BLFACE - F: v 1..3, c-p1 4..6, p1 7..9; ZERO is 1 for a zero
C     divide, else 0.
      SUBROUTINE BLFACE(P1, P2, P3, F, ZERO)
      DOUBLE PRECISION P1(3), P2(3), P3(3), F(9)
      INTEGER ZERO
      DOUBLE PRECISION A(3), B(3), U1(3), U2(2), B1, B2, R11, R22
      INTEGER Z2
      CALL BLMINU(P2, P1, A)
      CALL BLMINU(P3, P1, B)
      CALL BLREFR(3, A, U1, B1, R11, ZERO)
      CALL BLREFL(3, U1, B1, B)
      CALL BLREFR(2, B(2), U2, B2, R22, Z2)
      IF (Z2 .EQ. 1) ZERO = 1
      F(1) = 0.0D0
      F(2) = 0.0D0
      F(3) = 1.0D0
      IF (R11 .LT. 0.0D0) F(3) = -F(3)
      IF (R22 .LT. 0.0D0) F(3) = -F(3)
      F(6) = 0.0D0
      CALL BLREFL(2, U2, B2, F(2))
      CALL BLREFL(3, U1, B1, F)
      CALL DCOPY(3, P1, 1, F(7), 1)
      IF (ZERO .EQ. 1) RETURN
      F(4) = 0.5D0*R11
      F(5) = 0.5D0*(R22 + B(1)/R22*(B(1) - R11))
      CALL BLREFL(2, U2, B2, F(5))
      CALL BLREFL(3, U1, B1, F(4))
      END

C     BLSIDE - (Z-p1).v
      DOUBLE PRECISION FUNCTION BLSIDE(F, Z)
      DOUBLE PRECISION F(9), Z(3)
      DOUBLE PRECISION DDOT
      DOUBLE PRECISION W(3)
      CALL BLMINU(Z, F(7), W)
      BLSIDE = DDOT(3, F, 1, W, 1)
      END

C     BLLCOO - the L-coordinate of Z
      DOUBLE PRECISION FUNCTION BLLCOO(F, Z)
      DOUBLE PRECISION F(9), Z(3)
      DOUBLE PRECISION DDOT
      DOUBLE PRECISION W(3)
      CALL BLMINU(Z, F(7), W)
      BLLCOO = (DDOT(3, W, 1, W, 1) - 2.0D0*DDOT(3, F(4), 1, W, 1))/
     $         (2.0D0*DDOT(3, F, 1, W, 1))
      END

C     BLCALL - the calls that BLLCOO makes, with vectors of length 0:
C     what calling costs
      DOUBLE PRECISION FUNCTION BLCALL(F, Z)
      DOUBLE PRECISION F(9), Z(3)
      DOUBLE PRECISION DDOT
      DOUBLE PRECISION W(3)
      W(1) = Z(1)
      CALL DCOPY(0, Z, 1, W, 1)
      CALL DAXPY(0, -1.0D0, F(7), 1, W, 1)
      BLCALL = (DDOT(0, W, 1, W, 1) + DDOT(0, F(4), 1, W, 1)) +
     $         (DDOT(0, F, 1, W, 1) + W(1))
      END
