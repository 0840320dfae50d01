C     round.f - the paper's two insphere tests in arithmetic of 24 or 53
C     bits.
C
C     Every operation's result is stored to a REAL (24 bits, the paper's
C     32-bit arithmetic) or a DOUBLE PRECISION (53, its 64-bit
C     arithmetic) by a routine of another file, store.f, before it is
C     used.  So it is rounded there, on every machine: with or without
C     extended precision, contraction or vectors.  The operations
C     themselves are done in double precision or more: 53 bits are at
C     least 2 * 24 + 2, so that a sum, difference, product, quotient or
C     square root of REALs, rounded to double precision and then to
C     REAL, is what REAL arithmetic gives.  (Where double precision
C     arithmetic is done with more than 53 bits, the 64-bit arithmetic
C     is rounded twice; the 32-bit arithmetic never differs.)
C
C     The twin of round.c, routine by routine.

C     RABITS - the arithmetic from here on: 24 or 53 bits.
      SUBROUTINE RABITS(BITS)
      INTEGER BITS
      INTEGER SINGLE
      COMMON /RAMODE/ SINGLE
      SAVE /RAMODE/
      SINGLE = 0
      IF (BITS .EQ. 24) SINGLE = 1
      END

C     RAKEEP - X, rounded
      DOUBLE PRECISION FUNCTION RAKEEP(X)
      DOUBLE PRECISION X
      INTEGER SINGLE
      COMMON /RAMODE/ SINGLE
      SAVE /RAMODE/
      REAL S
      DOUBLE PRECISION D
      IF (SINGLE .EQ. 1) THEN
        CALL RASTOR(X, S)
        RAKEEP = DBLE(S)
      ELSE
        CALL RADSTO(X, D)
        RAKEEP = D
      END IF
      END

      DOUBLE PRECISION FUNCTION RAADD(A, B)
      DOUBLE PRECISION A, B
      DOUBLE PRECISION RAKEEP
      RAADD = RAKEEP(A + B)
      END

      DOUBLE PRECISION FUNCTION RASUB(A, B)
      DOUBLE PRECISION A, B
      DOUBLE PRECISION RAKEEP
      RASUB = RAKEEP(A - B)
      END

      DOUBLE PRECISION FUNCTION RAMUL(A, B)
      DOUBLE PRECISION A, B
      DOUBLE PRECISION RAKEEP
      RAMUL = RAKEEP(A*B)
      END

      DOUBLE PRECISION FUNCTION RADIV(A, B)
      DOUBLE PRECISION A, B
      DOUBLE PRECISION RAKEEP
      RADIV = RAKEEP(A/B)
      END

      DOUBLE PRECISION FUNCTION RAROOT(A)
      DOUBLE PRECISION A
      DOUBLE PRECISION RAKEEP
      RAROOT = RAKEEP(SQRT(A))
      END

      DOUBLE PRECISION FUNCTION RADOT(A, B)
      DOUBLE PRECISION A(3), B(3)
      DOUBLE PRECISION RAADD, RAMUL
      RADOT = RAADD(RAADD(RAMUL(A(1), B(1)), RAMUL(A(2), B(2))),
     $              RAMUL(A(3), B(3)))
      END

C     RALESS - A - T B
      DOUBLE PRECISION FUNCTION RALESS(A, T, B)
      DOUBLE PRECISION A, T, B
      DOUBLE PRECISION RASUB, RAMUL
      RALESS = RASUB(A, RAMUL(T, B))
      END

C     A frame H: the reflectors I - b u u', u1 1..3, b1 4, u2 5..6, b2 7
C     (u2 acts on rows 2, 3), r11 8, r12 9, r22 10, and the column of u2
C     11..12.

C     RAREFL - the norm R and B of the reflector that takes a vector of
C     first component FIRST to a multiple of e1; ZERO is 1 for a zero
C     divide.
      SUBROUTINE RAREFL(FIRST, NORM, R, B, ZERO)
      DOUBLE PRECISION FIRST, NORM, R, B
      INTEGER ZERO
      DOUBLE PRECISION RAADD, RAMUL, RADIV
      DOUBLE PRECISION T
      T = RAMUL(NORM, RAADD(NORM, ABS(FIRST)))
      R = NORM
      IF (FIRST .GT. 0.0D0) R = -NORM
      B = 0.0D0
      ZERO = 1
      IF (ABS(T) .LE. 0.0D0) RETURN
      B = RADIV(1.0D0, T)
      ZERO = 0
      END

C     RAHOUS - the reflectors and R of [A B]; ZERO is 1 for a zero
C     divide.
      SUBROUTINE RAHOUS(A, B, H, ZERO)
      DOUBLE PRECISION A(3), B(3), H(12)
      INTEGER ZERO
      DOUBLE PRECISION RAADD, RASUB, RAMUL, RAROOT, RADOT, RALESS
      DOUBLE PRECISION T, Q(3), R, D
      INTEGER Z1, Z2, K
      CALL RAREFL(A(1), RAROOT(RADOT(A, A)), R, D, Z1)
      H(8) = R
      H(4) = D
      H(1) = RASUB(A(1), H(8))
      H(2) = A(2)
      H(3) = A(3)
      T = RAMUL(H(4), RADOT(H, B))
      DO 10 K = 1, 3
        Q(K) = RALESS(B(K), T, H(K))
   10 CONTINUE
      H(9) = Q(1)
      H(11) = Q(2)
      H(12) = Q(3)
      T = RAROOT(RAADD(RAMUL(Q(2), Q(2)), RAMUL(Q(3), Q(3))))
      CALL RAREFL(Q(2), T, R, D, Z2)
      H(10) = R
      H(7) = D
      H(5) = RASUB(Q(2), H(10))
      H(6) = Q(3)
      ZERO = MAX(Z1, Z2)
      END

C     RAAPPL - Z = Q1 Q2 (Y1, Y2, Y3).
      SUBROUTINE RAAPPL(H, Y1, Y2, Y3, Z)
      DOUBLE PRECISION H(12), Y1, Y2, Y3, Z(3)
      DOUBLE PRECISION RAADD, RAMUL, RADOT, RALESS
      DOUBLE PRECISION T, Y(3)
      INTEGER K
      T = RAMUL(H(7), RAADD(RAMUL(H(5), Y2), RAMUL(H(6), Y3)))
      Y(1) = Y1
      Y(2) = RALESS(Y2, T, H(5))
      Y(3) = RALESS(Y3, T, H(6))
      T = RAMUL(H(4), RADOT(H, Y))
      DO 10 K = 1, 3
        Z(K) = RALESS(Y(K), T, H(K))
   10 CONTINUE
      END

C     RAFACE - Householder set-up of a facet, operation by operation
C     that of hhpred.f: F has the normal v 1..3, turned so that det
C     [p2-p1 p3-p1 v] > 0, c-p1 4..6, p1 7..9, and the column that the
C     second reflector is made of, 10..11, r11 and r22.  ZERO is 1 for a
C     zero divide, else 0.
      SUBROUTINE RAFACE(P1, P2, P3, F, ZERO)
      DOUBLE PRECISION P1(3), P2(3), P3(3), F(13)
      INTEGER ZERO
      DOUBLE PRECISION RAADD, RASUB, RAMUL, RADIV
      DOUBLE PRECISION A(3), B(3), H(12), V(3), Y1, Y2, TURN
      INTEGER K
      DO 10 K = 1, 3
        A(K) = RASUB(P2(K), P1(K))
        B(K) = RASUB(P3(K), P1(K))
        F(6+K) = P1(K)
   10 CONTINUE
      CALL RAHOUS(A, B, H, ZERO)
      TURN = 1.0D0
      IF (H(8) .LT. 0.0D0) TURN = -TURN
      IF (H(10) .LT. 0.0D0) TURN = -TURN
      CALL RAAPPL(H, 0.0D0, 0.0D0, TURN, V)
      DO 20 K = 1, 3
        F(K) = V(K)
        F(3+K) = 0.0D0
   20 CONTINUE
      F(10) = H(11)
      F(11) = H(12)
      F(12) = H(8)
      F(13) = H(10)
      IF (ZERO .EQ. 1) RETURN
      Y1 = RAMUL(0.5D0, H(8))
      Y2 = RAMUL(0.5D0, RAADD(H(10), RAMUL(RADIV(H(9), H(10)),
     $                                     RASUB(H(9), H(8)))))
      CALL RAAPPL(H, Y1, Y2, 0.0D0, V)
      DO 30 K = 1, 3
        F(3+K) = V(K)
   30 CONTINUE
      END

C     RASIDE - the distance of Z from the facet's plane.
      DOUBLE PRECISION FUNCTION RASIDE(F, Z)
      DOUBLE PRECISION F(13), Z(3)
      DOUBLE PRECISION RASUB, RADOT
      DOUBLE PRECISION W(3)
      INTEGER K
      DO 10 K = 1, 3
        W(K) = RASUB(Z(K), F(6+K))
   10 CONTINUE
      RASIDE = RADOT(F, W)
      END

C     RALCOO - the L-coordinate of Z, by the paper's formula; ZERO is 1
C     for a zero divide, else 0.
      SUBROUTINE RALCOO(F, Z, L, ZERO)
      DOUBLE PRECISION F(13), Z(3), L
      INTEGER ZERO
      DOUBLE PRECISION RASUB, RAMUL, RADIV, RADOT
      DOUBLE PRECISION W(3), SIDE
      INTEGER K
      L = 0.0D0
      ZERO = 1
      DO 10 K = 1, 3
        W(K) = RASUB(Z(K), F(6+K))
   10 CONTINUE
      SIDE = RADOT(F, W)
      IF (ABS(SIDE) .LE. 0.0D0) RETURN
      L = RADIV(RASUB(RADOT(W, W), RAMUL(2.0D0, RADOT(F(4), W))),
     $          RAMUL(2.0D0, SIDE))
      ZERO = 0
      END

C     RAMIN3 - the determinant of the columns I, J, K of the rows NA,
C     NB, NC of R
      DOUBLE PRECISION FUNCTION RAMIN3(R, NA, NB, NC, I, J, K)
      DOUBLE PRECISION R(4,4)
      INTEGER NA, NB, NC, I, J, K
      DOUBLE PRECISION RAADD, RASUB, RAMUL
      DOUBLE PRECISION X, Y, Z
      X = RASUB(RAMUL(R(NB,J), R(NC,K)), RAMUL(R(NB,K), R(NC,J)))
      Y = RASUB(RAMUL(R(NA,J), R(NC,K)), RAMUL(R(NA,K), R(NC,J)))
      Z = RASUB(RAMUL(R(NA,J), R(NB,K)), RAMUL(R(NA,K), R(NB,J)))
      RAMIN3 = RAADD(RASUB(RAMUL(R(NA,I), X), RAMUL(R(NB,I), Y)),
     $               RAMUL(R(NC,I), Z))
      END

C     RAMINO - the minors of the rows (x, y, z, x**2+y**2+z**2, 1) of
C     four points, the columns of P, set up once for RADET.
      SUBROUTINE RAMINO(P, M)
      DOUBLE PRECISION P(3,4), M(5)
      DOUBLE PRECISION RAADD, RASUB, RAMUL, RADOT, RAMIN3
      DOUBLE PRECISION R(4,4), S, T
      INTEGER COLUMN(3,4), I, K, J1, J2, J3
      DATA COLUMN /2, 3, 4, 1, 3, 4, 1, 2, 4, 1, 2, 3/
      DO 20 I = 1, 4
        DO 10 K = 1, 3
          R(I,K) = P(K,I)
   10   CONTINUE
        R(I,4) = RADOT(P(1,I), P(1,I))
   20 CONTINUE
C     three columns and the ones
      DO 30 K = 1, 4
        J1 = COLUMN(1,K)
        J2 = COLUMN(2,K)
        J3 = COLUMN(3,K)
        S = RASUB(RAMIN3(R, 1, 2, 3, J1, J2, J3),
     $            RAMIN3(R, 1, 2, 4, J1, J2, J3))
        T = RASUB(RAMIN3(R, 1, 3, 4, J1, J2, J3),
     $            RAMIN3(R, 2, 3, 4, J1, J2, J3))
        M(K) = RAADD(S, T)
        IF (MOD(K, 2) .EQ. 1) M(K) = -M(K)
   30 CONTINUE
C     no ones: by the last column
      S = RASUB(RAMUL(R(3,4), RAMIN3(R, 1, 2, 4, 1, 2, 3)),
     $          RAMUL(R(4,4), RAMIN3(R, 1, 2, 3, 1, 2, 3)))
      T = RASUB(RAMUL(R(1,4), RAMIN3(R, 2, 3, 4, 1, 2, 3)),
     $          RAMUL(R(2,4), RAMIN3(R, 1, 3, 4, 1, 2, 3)))
      M(5) = RAADD(S, T)
      END

C     RADET - the determinant whose first four rows have the minors M
C     and whose fifth row is that of Z.  It is positive for Z inside the
C     ball of a, b, c, d if det [b-a c-a d-a] > 0.
      DOUBLE PRECISION FUNCTION RADET(M, Z)
      DOUBLE PRECISION M(5), Z(3)
      DOUBLE PRECISION RAADD, RAMUL, RADOT
      RADET = RAADD(RAADD(RADOT(M, Z), RAMUL(M(4), RADOT(Z, Z))), M(5))
      END
