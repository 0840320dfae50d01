C     acc.f - the accuracy experiments of the paper's Section 4.
C
C     An insphere problem is five points, the columns of P: a facet p1,
C     p2, p3, a point p4 that makes it a ball, and the test point p5.
C     Householder: p5 is inside if its L-coordinate is less than that of
C     p4 (Theorem 1).  Determinants: by the minors of p1 ... p4.  Both
C     in arithmetic of 24 and 53 bits, rounded at every operation
C     (round.f).  Exact: HHINSP, on the points as rounded to 24 or 53
C     bits, compared at every step with EXINSP, exact.c's sign.
C
C     Answers: outside -1, on the ball 0, inside 1; 2 for a zero divide.
C
C     The twin of acc.c, whose tables it prints.
      PROGRAM ACC
      INTEGER SEED
      COMMON /RANDOM/ SEED
      SAVE /RANDOM/
      SEED = 1
      WRITE (*, 10)
   10 FORMAT(' 3. The test point approaches the origin')
      CALL APPROA(24)
      CALL APPROA(53)
      WRITE (*, 20)
   20 FORMAT(/' 4. The points are moved along z')
      CALL MOVE(24)
      CALL MOVE(53)
      END

C     ONE - the problem: the origin is on the ball, and every coordinate
C     of p1 is between 1 and 2.
      SUBROUTINE ONE(P)
      DOUBLE PRECISION P(3,5)
      DOUBLE PRECISION X(3,5)
      INTEGER I, K
      DATA X /1.5D0, 1.25D0, 1.75D0, -0.75D0, 1.5D0, 0.5D0,
     $        0.5D0, -1.25D0, 1.0D0, 0.0D0, 0.0D0, 0.0D0,
     $        0.5D0, 0.5D0, 0.5D0/
      DO 20 I = 1, 5
        DO 10 K = 1, 3
          P(K,I) = X(K,I)
   10   CONTINUE
   20 CONTINUE
      END

      INTEGER FUNCTION SIGNOF(X)
      DOUBLE PRECISION X
      SIGNOF = 0
      IF (X .GT. 0.0D0) SIGNOF = 1
      IF (X .LT. 0.0D0) SIGNOF = -1
      END

C     HOUSE - the answer by L-coordinates.
      INTEGER FUNCTION HOUSE(P)
      DOUBLE PRECISION P(3,5)
      INTEGER SIGNOF
      DOUBLE PRECISION RASIDE
      DOUBLE PRECISION F(13), L4, L5
      INTEGER ZERO
      HOUSE = 2
      CALL RAFACE(P(1,1), P(1,2), P(1,3), F, ZERO)
      IF (ZERO .EQ. 1) RETURN
      CALL RALCOO(F, P(1,4), L4, ZERO)
      IF (ZERO .EQ. 1) RETURN
      CALL RALCOO(F, P(1,5), L5, ZERO)
      IF (ZERO .EQ. 1) RETURN
      IF (RASIDE(F, P(1,5)) .GT. 0.0D0) THEN
        HOUSE = SIGNOF(L4 - L5)
      ELSE
        HOUSE = SIGNOF(L5 - L4)
      END IF
      END

C     DETS - the answer by determinants, with the true orientation as a
C     gift.
      INTEGER FUNCTION DETS(P)
      DOUBLE PRECISION P(3,5)
      INTEGER SIGNOF, HHORIE
      DOUBLE PRECISION RADET
      DOUBLE PRECISION M(5)
      CALL RAMINO(P, M)
      DETS = SIGNOF(RADET(M, P(1,5)))*
     $       HHORIE(P(1,1), P(1,2), P(1,3), P(1,4))
      END

C     WITHIN - the library's L-coordinate and the bound of its error
C     that hhpred.f states: SIDE is the side of Z if it is certain, else
C     0.
      SUBROUTINE WITHIN(F, Z, L, DL, SIDE)
      DOUBLE PRECISION F(12), Z(3), L, DL
      INTEGER SIDE
      INTEGER SIGNOF
      DOUBLE PRECISION HHSIDE, HHLCOO
      DOUBLE PRECISION EPS
      PARAMETER (EPS = 2.0D0**(-52))
      DOUBLE PRECISION W, VW, GAP
      INTEGER K
      W = 0.0D0
      VW = HHSIDE(F, Z)
      DO 10 K = 1, 3
        W = W + (Z(K) - F(6+K))*(Z(K) - F(6+K))
   10 CONTINUE
      W = SQRT(W)*(1.0D0 + 8.0D0*EPS)
      GAP = ABS(VW) - F(10)*W
      SIDE = 0
      IF (F(10) .GE. 1.0D0 .OR. .NOT. GAP .GT. 0.0D0) RETURN
      L = HHLCOO(F, Z)
      DL = W*(EPS*(3.0D0*W + 5.0D0*F(12)) + F(11) + ABS(L)*F(10))/GAP +
     $     4.0D0*EPS*ABS(L)
      SIDE = SIGNOF(VW)
      END

C     CERTAI - the answer that the library's bound proves, or 0.
      INTEGER FUNCTION CERTAI(P)
      DOUBLE PRECISION P(3,5)
      DOUBLE PRECISION F(12), L4, L5, D4, D5
      INTEGER INFO, SIDE4, SIDE5
      CERTAI = 0
      CALL HHFACE(P(1,1), P(1,2), P(1,3), F, INFO)
      IF (INFO .NE. 0) RETURN
      CALL WITHIN(F, P(1,5), L5, D5, SIDE5)
      IF (SIDE5 .EQ. 0) RETURN
      CALL WITHIN(F, P(1,4), L4, D4, SIDE4)
      IF (SIDE4 .EQ. 0) RETURN
      IF (L5 + D5 .LT. L4 - D4) CERTAI = SIDE5
      IF (L4 + D4 .LT. L5 - D5) CERTAI = -SIDE5
      END

C     NUMBER - a random multiple of 2**(-22) in [-2, 2): 24 bits.
      DOUBLE PRECISION FUNCTION NUMBER()
      INTEGER SEED
      COMMON /RANDOM/ SEED
      SAVE /RANDOM/
      SEED = INT(MOD(16807.0D0*DBLE(SEED), 2147483647.0D0))
      NUMBER = DBLE(SEED/128)/4194304.0D0 - 2.0D0
      END

C     MAKE - a random problem with p4 and p5 on the facet's positive
C     side, and p4 the origin if ORIGIN is 1.
      SUBROUTINE MAKE(ORIGIN, P)
      INTEGER ORIGIN
      DOUBLE PRECISION P(3,5)
      INTEGER HHORIE
      DOUBLE PRECISION NUMBER
      DOUBLE PRECISION T
      INTEGER I, K
   10 DO 30 I = 1, 5
        DO 20 K = 1, 3
          P(K,I) = 0.0D0
          IF (ORIGIN .EQ. 0 .OR. I .NE. 4) P(K,I) = NUMBER()
   20   CONTINUE
   30 CONTINUE
      IF (HHORIE(P(1,1), P(1,2), P(1,3), P(1,4)) .LT. 0) THEN
        DO 40 K = 1, 3
          T = P(K,1)
          P(K,1) = P(K,2)
          P(K,2) = T
   40   CONTINUE
      END IF
      IF (HHORIE(P(1,1), P(1,2), P(1,3), P(1,4)) .LE. 0) GO TO 10
      IF (HHORIE(P(1,1), P(1,2), P(1,3), P(1,5)) .LE. 0) GO TO 10
      END

C     ASK - what the methods say of a problem: A is Householder 1,
C     determinants 2, HHINSP 3, what the bound proves 4, and what is
C     right 5.
      SUBROUTINE ASK(P, A)
      DOUBLE PRECISION P(3,5)
      INTEGER A(5)
      INTEGER HOUSE, DETS, HHINSP, CERTAI, EXINSP
      A(1) = HOUSE(P)
      A(2) = DETS(P)
      A(3) = HHINSP(P(1,1), P(1,2), P(1,3), P(1,4), P(1,5))
      A(4) = CERTAI(P)
      A(5) = EXINSP(P(1,1), P(1,2), P(1,3), P(1,4), P(1,5))
      END

      SUBROUTINE WORD(ANSWER, RIGHT, W)
      INTEGER ANSWER, RIGHT
      CHARACTER*8 W
      CHARACTER*8 NAME(4), NOT(4)
      DATA NAME /'outside', 'on', 'inside', '0 divide'/
      DATA NOT /'outside*', 'on*', 'inside*', '0 divide'/
      IF (ANSWER .EQ. RIGHT) THEN
        W = NAME(ANSWER+2)
      ELSE
        W = NOT(ANSWER+2)
      END IF
      END

C     COUNT - count answers A at power J, in C: zeros 1, wrong 2, zero
C     divides 3, determinants wrong 4, the first time 5, exact wrong 6,
C     bound decides 7, changed 8.
      SUBROUTINE COUNT(C, J, A)
      INTEGER C(8,0:20), J, A(5)
      IF (A(1) .EQ. 2) THEN
        C(3,J) = C(3,J) + 1
      ELSE IF (A(1) .EQ. 0 .AND. A(5) .NE. 0) THEN
        C(1,J) = C(1,J) + 1
      ELSE IF (A(1) .NE. A(5)) THEN
        C(2,J) = C(2,J) + 1
      END IF
      IF (A(2) .NE. A(5)) C(4,J) = C(4,J) + 1
      IF (A(3) .NE. A(5)) C(6,J) = C(6,J) + 1
      IF (A(4) .NE. 0) C(7,J) = C(7,J) + 1
      END

      SUBROUTINE ZEROC(C)
      INTEGER C(8,0:20)
      INTEGER I, J
      DO 20 J = 0, 20
        DO 10 I = 1, 8
          C(I,J) = 0
   10   CONTINUE
   20 CONTINUE
      END

C     FIRST - a line of what fails first at which power of ten; TEN is 0
C     for none.
      SUBROUTINE FIRST(NAME, TEN, PAPER)
      CHARACTER*46 NAME
      INTEGER TEN
      CHARACTER*(*) PAPER
      IF (TEN .EQ. 0) THEN
        WRITE (*, 10) NAME, PAPER
      ELSE
        WRITE (*, 20) NAME, TEN, PAPER
      END IF
   10 FORMAT('  ', A, ' none    ', A)
   20 FORMAT('  ', A, ' 1E', SP, I3.2, '   ', A)
      END

C     ------------------------------------------------------------------
C     The test point approaches the origin.

C     SHRINK - p5 is D times 10**(-TEN).
      SUBROUTINE SHRINK(BITS, TEN, D, P)
      INTEGER BITS, TEN
      DOUBLE PRECISION D(3), P(3,5)
      DOUBLE PRECISION RAKEEP, RADIV
      DOUBLE PRECISION X
      INTEGER I, K
      DO 20 K = 1, 3
        X = D(K)
        CALL RABITS(53)
        DO 10 I = 1, TEN
          X = RADIV(X, 10.0D0)
   10   CONTINUE
        CALL RABITS(BITS)
        P(K,5) = RAKEEP(X)
   20 CONTINUE
      END

      SUBROUTINE APPROA(BITS)
      INTEGER BITS
      INTEGER MANY
      PARAMETER (MANY = 1000)
      DOUBLE PRECISION P(3,5), D(3)
      INTEGER C(8,0:20), A(5,20), B(5), I, J, K, HOUSE1, DETS1, EXACT1
      CHARACTER*8 W1, W2, W3
      CALL ZEROC(C)
      HOUSE1 = 0
      DETS1 = 0
      EXACT1 = 0
      CALL ONE(P)
      DO 10 K = 1, 3
        D(K) = P(K,5)
   10 CONTINUE
      DO 20 J = 1, 20
        CALL SHRINK(BITS, J, D, P)
        CALL ASK(P, A(1,J))
        IF (HOUSE1 .EQ. 0 .AND. A(1,J) .NE. A(5,J)) HOUSE1 = -J
        IF (DETS1 .EQ. 0 .AND. A(2,J) .NE. A(5,J)) DETS1 = -J
        IF (EXACT1 .EQ. 0 .AND. A(3,J) .NE. A(5,J)) EXACT1 = -J
   20 CONTINUE
      DO 50 I = 1, MANY
        CALL MAKE(1, P)
        DO 30 K = 1, 3
          D(K) = 0.25D0*P(K,5)
   30   CONTINUE
        DO 40 J = 1, 20
          CALL SHRINK(BITS, J, D, P)
          CALL ASK(P, B)
          CALL COUNT(C, J, B)
   40   CONTINUE
   50 CONTINUE
      IF (BITS .EQ. 24) WRITE (*, 60) 32, MANY
      IF (BITS .NE. 24) WRITE (*, 60) 64, MANY
   60 FORMAT(/' ', I2, '-bit arithmetic'//
     $       '            the problem                       of ', I4,
     $       ' random problems'/
     $       '                                              Househol',
     $       'der  determ.  exact  bound'/
     $       '  distance  Householder determ.  exact         zero  w',
     $       'rong    wrong  wrong  decides')
      DO 80 J = 1, 20
        CALL WORD(A(1,J), A(5,J), W1)
        CALL WORD(A(2,J), A(5,J), W2)
        CALL WORD(A(3,J), A(5,J), W3)
        WRITE (*, 70) J, W1, W2, W3, C(1,J), C(2,J), C(4,J), C(6,J),
     $                C(7,J)
   70   FORMAT('  1E-', I2.2, '     ', A8, '    ', A8, ' ', A8,
     $         '     ', I5, ' ', I6, ' ', I8, ' ', I6, ' ', I8)
   80 CONTINUE
      WRITE (*, 90)
   90 FORMAT(/'  First failure, at the distance                 ours ',
     $       '   paper')
      IF (BITS .EQ. 24) THEN
        CALL FIRST('Householder: 0, the problem                   ',
     $             HOUSE1, '1E-07')
        CALL FIRST('determinants: wrong, the problem              ',
     $             DETS1, 'none down to 1E-14')
      ELSE
        CALL FIRST('Householder: 0, the problem                   ',
     $             HOUSE1, '-')
        CALL FIRST('determinants: wrong, the problem              ',
     $             DETS1, '-')
      END IF
      CALL FIRST('exact: wrong, the problem                     ',
     $           EXACT1, '-')
      END

C     ------------------------------------------------------------------
C     The points are moved away from the origin.

C     TRANSL - P is Q moved along an axis by 10**TEN, or not for 0.
      SUBROUTINE TRANSL(BITS, AXIS, TEN, Q, P)
      INTEGER BITS, AXIS, TEN
      DOUBLE PRECISION Q(3,5), P(3,5)
      DOUBLE PRECISION RAADD
      DOUBLE PRECISION X
      INTEGER I, K
      X = 1.0D0
      DO 10 I = 1, TEN
        X = X*10.0D0
   10 CONTINUE
      CALL RABITS(BITS)
      DO 30 I = 1, 5
        DO 20 K = 1, 3
          P(K,I) = Q(K,I)
   20   CONTINUE
        IF (TEN .GT. 0) P(AXIS,I) = RAADD(Q(AXIS,I), X)
   30 CONTINUE
      END

C     ERROR - the decimal logarithm of the relative error of the
C     determinant of Q when it is moved: a translation does not alter a
C     determinant.
      DOUBLE PRECISION FUNCTION ERROR(BITS, Q, P)
      INTEGER BITS
      DOUBLE PRECISION Q(3,5), P(3,5)
      DOUBLE PRECISION RADET
      DOUBLE PRECISION M(5), X, Y
      CALL RABITS(53)
      CALL RAMINO(Q, M)
      X = RADET(M, Q(1,5))
      CALL RABITS(BITS)
      CALL RAMINO(P, M)
      Y = ABS((RADET(M, P(1,5)) - X)/X)
      ERROR = LOG10(MAX(Y, 1.0D-18))
      END

      SUBROUTINE MOVE(BITS)
      INTEGER BITS
      INTEGER MANY
      PARAMETER (MANY = 1000)
      DOUBLE PRECISION ERROR
      DOUBLE PRECISION P(3,5), Q(3,5), E(0:20)
      INTEGER C(8,0:20), A(5,0:20), B(5), I, J, N, TRUTH, FAILED
      INTEGER DIVID1, DETS1, EXACT1, MOVED1, MEDIAN, SUM, NEAR, NEAR1
      INTEGER ALONG(3)
      CHARACTER*8 W1, W2, W3
      CHARACTER*1 XYZ(3)
      DATA XYZ /'x', 'y', 'z'/
      CALL ZEROC(C)
      ALONG(1) = 0
      ALONG(2) = 0
      ALONG(3) = 0
      N = 17
      NEAR1 = 16
      IF (BITS .EQ. 24) N = 9
      IF (BITS .EQ. 24) NEAR1 = 8
      DIVID1 = 0
      DETS1 = 0
      EXACT1 = 0
      MOVED1 = 0
      NEAR = 0
      CALL ONE(Q)
      DO 10 J = 0, N
        E(J) = 0.0D0
        CALL TRANSL(BITS, 3, J, Q, P)
        CALL ASK(P, A(1,J))
        IF (DIVID1 .EQ. 0 .AND. A(1,J) .EQ. 2) DIVID1 = J
        IF (DETS1 .EQ. 0 .AND. A(2,J) .NE. A(5,J)) DETS1 = J
        IF (EXACT1 .EQ. 0 .AND. A(3,J) .NE. A(5,J)) EXACT1 = J
        IF (MOVED1 .EQ. 0 .AND. A(5,J) .NE. A(5,0)) MOVED1 = J
   10 CONTINUE
      DO 40 I = 1, MANY
        CALL MAKE(0, Q)
        FAILED = 0
        TRUTH = 0
        DO 20 J = 0, N
          CALL TRANSL(BITS, 3, J, Q, P)
          CALL ASK(P, B)
          IF (J .EQ. 0) TRUTH = B(5)
          CALL COUNT(C, J, B)
          IF (B(5) .NE. TRUTH) C(8,J) = C(8,J) + 1
          E(J) = E(J) + ERROR(BITS, Q, P)/DBLE(MANY)
          IF (FAILED .EQ. 0 .AND. B(2) .NE. B(5)) THEN
            C(5,J) = C(5,J) + 1
            FAILED = 1
          END IF
   20   CONTINUE
        DO 25 J = 1, 3
          CALL TRANSL(BITS, J, N, Q, P)
          CALL ASK(P, B)
          IF (B(1) .EQ. 2) ALONG(J) = ALONG(J) + 1
   25   CONTINUE
        DO 30 J = 1, 5
          Q(3,J) = Q(3,J)*0.5D0
   30   CONTINUE
        CALL TRANSL(BITS, 3, NEAR1, Q, P)
        CALL ASK(P, B)
        IF (B(1) .EQ. 2) NEAR = NEAR + 1
   40 CONTINUE
      MEDIAN = 0
      SUM = 0
      DO 50 J = 0, N
        SUM = SUM + C(5,J)
        IF (MEDIAN .EQ. 0 .AND. SUM .GE. MANY/2) MEDIAN = J
   50 CONTINUE
      IF (BITS .EQ. 24) WRITE (*, 60) 32, MANY
      IF (BITS .NE. 24) WRITE (*, 60) 64, MANY
   60 FORMAT(/' ', I2, '-bit arithmetic'//
     $       '            the problem                       of ', I4,
     $       ' random problems'/
     $       '                                              Househol',
     $       'der  determinants         exact  bound    changed by'/
     $       '  moved     Householder determ.  exact        0 div wr',
     $       'ong   wrong  first  error  wrong  decides  rounding')
      DO 80 J = 0, N
        CALL WORD(A(1,J), A(5,J), W1)
        CALL WORD(A(2,J), A(5,J), W2)
        CALL WORD(A(3,J), A(5,J), W3)
        IF (J .EQ. 0) WRITE (*, 65) W1, W2, W3, C(3,J), C(2,J),
     $    C(4,J), C(5,J), E(J), C(6,J), C(7,J), C(8,J)
        IF (J .GT. 0) WRITE (*, 70) J, W1, W2, W3, C(3,J), C(2,J),
     $    C(4,J), C(5,J), E(J), C(6,J), C(7,J), C(8,J)
   65   FORMAT('  0         ', A8, '    ', A8, ' ', A8,
     $         '     ', I5, ' ', I5, ' ', I7, ' ', I6, ' ', F6.1, ' ',
     $         I6, ' ', I8, ' ', I9)
   70   FORMAT('  1E+', I2.2, '     ', A8, '    ', A8, ' ', A8,
     $         '     ', I5, ' ', I5, ' ', I7, ' ', I6, ' ', F6.1, ' ',
     $         I6, ' ', I8, ' ', I9)
   80 CONTINUE
      WRITE (*, 90)
   90 FORMAT(/'  First failure, moved by                        ours ',
     $       '   paper')
      IF (BITS .EQ. 24) THEN
        CALL FIRST('Householder: zero divide, the problem         ',
     $             DIVID1, '1E+08')
        CALL FIRST('determinants: wrong, the problem              ',
     $             DETS1, '1E+04')
      ELSE
        CALL FIRST('Householder: zero divide, the problem         ',
     $             DIVID1, '1E+16')
        CALL FIRST('determinants: wrong, the problem              ',
     $             DETS1, '1E+06')
      END IF
      CALL FIRST('determinants: wrong, half the random ones     ',
     $           MEDIAN, '-')
      CALL FIRST('exact: wrong, the problem                     ',
     $           EXACT1, '-')
      CALL FIRST('the problem is another one, as rounded        ',
     $           MOVED1, '-')
      WRITE (*, 100) NEAR1, NEAR
  100 FORMAT(/'  Zero divides of the random problems, with z halved,',
     $       '       at 1E+', I2.2, ': ', I4)
      DO 120 I = 1, 3
        WRITE (*, 110) XYZ(I), N, ALONG(I)
  110   FORMAT('                                      moved along ', A1,
     $         ',      at 1E+', I2.2, ': ', I4)
  120 CONTINUE
      END
