C     level1.f - what blas.f calls of the BLAS, level 1, as plain loops:
C     Lawson, Hanson, Kincaid, Krogh, Basic linear algebra subprograms
C     for Fortran usage, ACM TOMS 5 (1979).  An increment below zero
C     starts at the other end.

      DOUBLE PRECISION FUNCTION DDOT(N, X, INCX, Y, INCY)
      INTEGER N, INCX, INCY
      DOUBLE PRECISION X(*), Y(*)
      DOUBLE PRECISION S
      INTEGER I, J, K
      S = 0.0D0
      J = 1 + MAX(0, (1 - N)*INCX)
      K = 1 + MAX(0, (1 - N)*INCY)
      DO 10 I = 1, N
        S = S + X(J)*Y(K)
        J = J + INCX
        K = K + INCY
   10 CONTINUE
      DDOT = S
      END

      SUBROUTINE DAXPY(N, A, X, INCX, Y, INCY)
      INTEGER N, INCX, INCY
      DOUBLE PRECISION A, X(*), Y(*)
      INTEGER I, J, K
      J = 1 + MAX(0, (1 - N)*INCX)
      K = 1 + MAX(0, (1 - N)*INCY)
      DO 10 I = 1, N
        Y(K) = Y(K) + A*X(J)
        J = J + INCX
        K = K + INCY
   10 CONTINUE
      END

      SUBROUTINE DCOPY(N, X, INCX, Y, INCY)
      INTEGER N, INCX, INCY
      DOUBLE PRECISION X(*), Y(*)
      INTEGER I, J, K
      J = 1 + MAX(0, (1 - N)*INCX)
      K = 1 + MAX(0, (1 - N)*INCY)
      DO 10 I = 1, N
        Y(K) = X(J)
        J = J + INCX
        K = K + INCY
   10 CONTINUE
      END

C     DNRM2 - the length of X, without overflow or underflow on the way
      DOUBLE PRECISION FUNCTION DNRM2(N, X, INCX)
      INTEGER N, INCX
      DOUBLE PRECISION X(*)
      DOUBLE PRECISION MOST, S, T
      INTEGER I, J
      MOST = 0.0D0
      J = 1 + MAX(0, (1 - N)*INCX)
      DO 10 I = 1, N
        MOST = MAX(MOST, ABS(X(J)))
        J = J + INCX
   10 CONTINUE
      DNRM2 = 0.0D0
      IF (MOST .LE. 0.0D0) RETURN
      S = 0.0D0
      J = 1 + MAX(0, (1 - N)*INCX)
      DO 20 I = 1, N
        T = X(J)/MOST
        S = S + T*T
        J = J + INCX
   20 CONTINUE
      DNRM2 = MOST*SQRT(S)
      END
