C     hhpred.f - predicates for a handful of points in space.
C
C     SPDX-License-Identifier: 0BSD
C     Copyright (c) 2026 the tess authors
C
C     Permission to use, copy, modify, and/or distribute this software
C     for any purpose with or without fee is hereby granted.
C
C     THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL
C     WARRANTIES WITH REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED
C     WARRANTIES OF MERCHANTABILITY AND FITNESS. IN NO EVENT SHALL THE
C     AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT, INDIRECT, OR
C     CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
C     LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT,
C     NEGLIGENCE OR OTHER TORTIOUS ACTION, ARISING OUT OF OR IN
C     CONNECTION WITH THE USE OR PERFORMANCE OF THIS SOFTWARE.
C
C     Part of tess, Delaunay tetrahedralization after C. Hazlewood,
C     "Facet-Based Tetrahedralization Software" (1995), Section 3.
C
C     Two kinds of routine:
C       - Householder floating point: HHFACE, HHSIDE, HHOPP, HHLCOO,
C         HHWRAP.  Fast, backward stable, and rounded.  F(10..12) hold
C         what is needed to bound the error (see HHFACE).
C       - exact signs: HHORIE, HHINSP.  Right for all finite doubles,
C         in every rounding mode, with extended precision, contraction
C         or reassociation.  Where they cannot be right they say so: for
C         a subnormal coordinate on a processor that flushes subnormal
C         numbers to zero, and on a processor that rounds to fewer bits
C         than a double has.
C
C     No routine allocates, reads, writes, keeps state between calls or
C     stops the program.  With local arrays on the stack (gfortran
C     -frecursive, f2c -a) all may be called from any number of
C     threads; without, from one at a time.
C
C     A point is an array of 3 coordinates.  No argument but F, C is
C     altered by the routines that hh_ names below.
C
C     HOW THIS FILE IS LAID OUT.  A routine stands before those that
C     call it.  Part I of tess.f needs all but the last chapter, of
C     which it has HHTHIN alone.
C       exact numbers     integers kept in doubles, and what is computed
C                         of them
C       the arithmetic    what the processor makes of coordinates
C       exact signs       orientation and insphere, of points or of
C                         positions in a set: a filter in doubles, then
C                         exact numbers
C       the tie rule      which of cospherical points is the apex
C       Householder       the facet's normal and centre, the
C                         L-coordinate, with the bounds on their errors
C                         that searches rest on
C       balls by limbs    a ball, a sphere or a plane set up once, so
C                         that a few limbs of a point decide
C     Each routine says its name in hhpred.c, in brackets; those that
C     hh_ names have the same names, cut to six letters.
C
C     A reader of the paper starts at "Householder transformations":
C       Section 2, Figure 4    the rule for cospherical points: HHBRKT,
C                              HHPINS.  (The rest of Section 2 is
C                              tess.f.)
C       Section 3              P = Q R: HHHOUS, HHAPPQ; the
C                              gift-wrapping primitive: HHWRAP
C       Section 3.1            the normal, the opp test: HHSETU, HHFACE,
C                              HHSIDE, HHOPP
C       Section 3.2            the L-coordinate: HHSETU, HHLCOO
C     The paper's errors are backward; HHLIMI and HHRATI have forward
C     bounds, derived at the head of that chapter.
C
C     Only in C: keeps_value (part of hh_held), finite_facet (hh_finite
C     of an array here), all_zero (written out here), lesser_of (MIN
C     here), pack_five (its points are copied here), the macro HH_POWER,
C     |W|**2 - 2 C.W, written out here.
C     Only here: HHKIND (part of hh_finite and hh_held); HHV500,
C     HHL088 (the macro HH_AS): what TSSORT (tess.f) calls by these
C     names alone, so that tess.f does not link with a hhpred.f of
C     another version, here 5.0.0, or of other limbs.
C
C     Where C returns a code beside other results, the last argument
C     has it; a function alters no argument.  Axes, positions and
C     indices count from 1.  Where C passes pointers into one array, the
C     array comes first here, then what the pointers point to: columns
C     of an array of points.
C
C     Places and constants, the same in every routine that has them, for
C     doubles of 53 bits and integers of at least 32.  In each row: its
C     name, = its number, the field in C or the macro (- if there is
C     none), and what it is.  "Behind" means that the first element is
C     one place on.
C     F, a facet's Householder set-up, see HHFACE:
C       LF     = 12  HH_FACET_LEN  its length
C       FNORM  = 0   HH_NORMAL  behind it the normal
C       FCEN   = 3   HH_CENTRE  behind it the centre of the
C               circumcircle, seen from the base
C       FBASE  = 6   HH_BASE  behind it the base
C       FE     = 10  HH_E  E
C       FDC    = 11  HH_DC  dc
C       FRHO   = 12  HH_RHO  rho
C     Constants:
C       EPS    = 2.0D0**(-52) DBL_EPSILON  the spacing of the doubles
C               above 1
C       HUGE   = (2.0D0-2.0D0**(-52))*2.0D0**1023 DBL_MAX  the largest
C               double
C       NORMAL = 2.0D0**(-1022) DBL_MIN  the least normal double
C       UNSURE = 2   UNSURE  a sign that bounds, or too few limbs, leave
C               open
C       TIE    = 3   HH_TIE  the sign of a tie in HHPINS: this times 1
C               or -1
C       BITS   = 24  HH_BITS  bits of a limb
C       HHLIM  = 88  HH_LIMBS  exact numbers are arrays of at most HHLIM
C               limbs.  The default holds every finite double beside
C               every other.  Where fewer, 3 at least, do not suffice
C               HHORIE and HHINSP return 2.  Scratch: 44 doubles a limb,
C               31 KB for 88 limbs, in a routine that is called only
C               where 3 limbs do not suffice.  To choose another number
C               change each HHLIM and HHL088, here and in tess.f
C       BASE   = 2.0D0**24 BASE  the base of limbs, 2**BITS
C       RADIX  = 2.0D0**24 BASE  the same, where BASE is an argument
C       HHEMAX = 0.5D0 HH_E_MAX  the bounds of HHFACE hold if E is at
C               most this
C       LENMIN = 2.0D0**(-450) HH_LENGTH_MIN  for coordinates of
C               absolute value at most 1 they hold if |W| and the
C               facet's edges are at least this: below it squares might
C               underflow
C       PROBE  = 2.0D0**26 PROBE  (PROBE + 1)**2 needs 53 bits: see
C               HHFULL
C       DETUND = 2.0D0**(-1000) DET_UNDERFLOW  an absolute error no
C               smaller than what underflow, gradual or to zero, does to
C               a determinant of differences of at most 2
C       QUICKE = 96  QUICK_EXP  coordinates between 2**(-QUICKE), which
C               is
C       QUICKS = 2.0D0**(-96) QUICK_SCALE  and 1/QUICKS are scaled by
C               one multiplication

C     ------------------------------------------------------------------
C     Exact numbers.
C
C     A number is an array of limbs, most significant first, each an
C     integer kept in a double; limb I weighs BASE**(1-I) times what
C     limb 1 does.  Limbs of coordinates are balanced, |limb| <= BASE/2
C     and for limb 1 BASE/4, so those of a difference are at most BASE
C     and need no carry.  Every value formed stays below 2**53, so every
C     operation is exact: in any rounding mode, with extended precision,
C     contraction or reassociation.  (Expansions of doubles, as in J. R.
C     Shewchuk, Discrete Comput. Geom. 18, 1997, 305-363, rely on exact
C     rounding instead.)
C
C     Numbers that are worked on together lie side by side: limb I of
C     number K of W is at W (I-1) + K.  Limb 1 of a product weighs BASE
C     times the product of the two limbs 1.  31 products of limbs of at
C     most BASE fit one limb: 10 rows of 2 or 3 such products, or of 4
C     where one factor has been carried to at most BASE/2 + 1.  (Limbs 1
C     are no exception: they are at most BASE/2 for a minor, 3/4 BASE
C     for a 3 by 3 determinant or a square, as the coordinates' are at
C     most BASE/4.)
C
C     Kinds of product of HHPROD:
C       DOT    = 1   DOT
C       COFACT = 2   COFACTOR
C       CROSS  = 3   CROSS
C       SCALED = 4   SCALED
C       SQUARE = 5   SQUARES
C       PAIRED = 6   PAIRED
C     Constants:
C       CARRY  = 2.0D0**29 CARRY  2**(53-BITS), a bound on carries
C       ICARRY = 2**29 CARRY  the same as an integer
C       BELHAL = 0.5D0-2.0D0**(-54) BELOW_HALF  the largest double below
C               a half: see HHSPLI
C       DBLLIM = 4   DOUBLE_LIMBS  how many limbs hold the value of a
C               number to a double's precision
C       RAISE  = 2.0D0**600 RAISE  BASE**RAISEL:
C       RAISEL = 25  RAISE_LIMBS  exact numbers that are all below
C       RAISEB = 2.0D0**(-200) RAISE_BELOW  are first multiplied by
C               RAISE, so that no limb's weight underflows
C     ------------------------------------------------------------------

C     HHFREX (frexp) - for C's frexp, which Fortran 77 lacks: the
C     integer E with 2**(E-1) <= |X| < 2**E; 0 for X = 0.
C
C     Products with powers of two in the range of normal doubles are
C     exact, unlike a logarithm.  Strides of 2**16, 2**4 and 2 reach
C     ordinary magnitudes in a few steps; the bounds on E end the search
C     should X be no number.
      INTEGER FUNCTION HHFREX(X)
      DOUBLE PRECISION X
      DOUBLE PRECISION STEP, Y
      INTEGER E, LOGTWO, PASS
      E = 0
      Y = ABS(X)
      IF (Y .GT. 0.0D0) THEN
        STEP = 65536.0D0
        LOGTWO = 16
        DO 30 PASS = 1, 3
   10     IF (Y .GE. STEP .AND. E .LT. 2000) THEN
            Y = Y/STEP
            E = E + LOGTWO
            GO TO 10
          END IF
   20     IF (Y .LT. 1.0D0 .AND. E .GT. -2000) THEN
            Y = Y*STEP
            E = E - LOGTWO
            GO TO 20
          END IF
          STEP = 16.0D0
          IF (PASS .EQ. 2) STEP = 2.0D0
          LOGTWO = LOGTWO/4
   30   CONTINUE
        E = E + 1
      END IF
      HHFREX = E
      END

C     HHLDEX (ldexp) - for C's ldexp, which Fortran 77 lacks: X * 2**E,
C     |E| <= 2000, rounded at most once.
C
C     Squaring and multiplying powers of two is exact, unlike an
C     exponential.  A second factor is there only where the first alone
C     might be no normal double; it is so far from 1 then that a product
C     which underflows before it ends as zero anyway.  The branch keeps
C     an optimizer from joining the two.
      DOUBLE PRECISION FUNCTION HHLDEX(X, E)
      DOUBLE PRECISION X
      INTEGER E
      DOUBLE PRECISION FACTOR, POWER, Y
      INTEGER FAR, REST
      FAR = 0
      IF (E .GT. 1000) FAR = 1000
      IF (E .LT. -1000) FAR = -1000
      FACTOR = 1.0D0
      POWER = 2.0D0
      IF (E .LT. 0) POWER = 0.5D0
      REST = ABS(E - FAR)
   10 IF (MOD(REST, 2) .EQ. 1) FACTOR = FACTOR*POWER
      REST = REST/2
      IF (REST .GT. 0) THEN
        POWER = POWER*POWER
        GO TO 10
      END IF
      Y = X*FACTOR
      IF (FAR .GT. 0) Y = Y*2.0D0**1000
      IF (FAR .LT. 0) Y = Y*2.0D0**(-1000)
      HHLDEX = Y
      END

C     HHRNDL (round_limb) - returns an integer within 1/2 + 2 / BASE of
C     Q, |Q| <= 0.97 CARRY, at ties either: the offset makes Q positive,
C     and its rounding may take it across a half.
      DOUBLE PRECISION FUNCTION HHRNDL(Q)
      DOUBLE PRECISION Q
      INTEGER ICARRY
      PARAMETER (ICARRY = 2**29)
      HHRNDL = DBLE(INT(Q + (ICARRY + 0.5D0)) - ICARRY)
      END

C     HHZERO (set_zeros) - sets N numbers R to 0.
      SUBROUTINE HHZERO(N, R)
      INTEGER N
      DOUBLE PRECISION R(*)
      INTEGER I
      DO 10 I = 1, N
        R(I) = 0.0D0
   10 CONTINUE
      END

C     HHFROW (first_row) - returns the first of N rows of R, STEP apart,
C     whose first WIDE numbers are not all 0; N + 1 if there is none.
      INTEGER FUNCTION HHFROW(N, WIDE, STEP, R)
      INTEGER N, WIDE, STEP
      DOUBLE PRECISION R(*)
      INTEGER I, K
      DO 20 I = 1, N
        DO 10 K = STEP*(I - 1) + 1, STEP*(I - 1) + WIDE
          IF (ABS(R(K)) .GT. 0.0D0) GO TO 30
   10   CONTINUE
   20 CONTINUE
      I = N + 1
   30 HHFROW = I
      END

C     HHMULT - multiplies N coordinates Q by F.
      SUBROUTINE HHMULT(N, Q, F)
      INTEGER N
      DOUBLE PRECISION Q(*), F
      INTEGER I
      DO 10 I = 1, N
        Q(I) = Q(I)*F
   10 CONTINUE
      END

C     HHTOPW (top_weight) - multiplies NP points Q by the FACTOR that
C     keeps the weights of limbs from underflowing; MOST > 0 is their
C     largest absolute value.  TOP is the weight of limb 1 for which
C     MOST fills the limb.
      SUBROUTINE HHTOPW(NP, Q, MOST, FACTOR, TOP)
      INTEGER NP
      DOUBLE PRECISION Q(3,*), MOST, FACTOR, TOP
      INTEGER BITS
      DOUBLE PRECISION RAISE, RAISEB
      PARAMETER (BITS = 24, RAISE = 2.0D0**600, RAISEB = 2.0D0**(-200))
      DOUBLE PRECISION HHLDEX
      INTEGER HHFREX
      FACTOR = 1.0D0
      IF (MOST .LT. RAISEB) THEN
        FACTOR = RAISE
        CALL HHMULT(3*NP, Q, RAISE)
      END IF
      TOP = HHLDEX(1.0D0, HHFREX(MOST*FACTOR) + 2 - BITS)
      END

C     HHSPLI (split_limbs) - splits W numbers Q into N limbs each, side
C     by side.  Limb 1 has the weight TOP, a power of two, and |Q| <=
C     TOP BASE/4.  USED is the number of limbs in use, or N + 1 if N
C     limbs do not hold the numbers.
C
C     The remainder of a number after a limb has no bits below the
C     number's own, and is exact as long as it is no larger than the
C     number.  So a limb is 0 for a remainder of less than half its
C     weight: with BELHAL, the largest number below a half, in place of
C     a half no rounding makes 1 of the sum.  A number whose first
C     RAISEL limbs are 0 is far below TOP, and is taken up after these
C     limbs.
      SUBROUTINE HHSPLI(W, Q, TOP, N, LIMB, USED)
      INTEGER W, N, USED
      DOUBLE PRECISION Q(*), TOP, LIMB(*)
      INTEGER RAISEL
      DOUBLE PRECISION BASE, BELHAL, RAISE
      PARAMETER (BASE = 2.0D0**24, BELHAL = 0.5D0 - 2.0D0**(-54),
     $    RAISE = 2.0D0**600, RAISEL = 25)
      DOUBLE PRECISION C, FAR, LEAST, REST
      INTEGER I, K
      CALL HHZERO(W*N, LIMB)
      LEAST = TOP*(0.5D0/RAISE)
      USED = 1
      DO 30 K = 1, W
        FAR = Q(K)
        I = 0
   10   IF (ABS(FAR) .GT. 0.0D0 .AND. ABS(FAR) .LT. LEAST) THEN
          FAR = FAR*RAISE
          I = I + RAISEL
          GO TO 10
        END IF
        REST = FAR/TOP
   20   IF (ABS(REST) .GT. 0.0D0) THEN
          IF (I .GE. N) THEN
            USED = N + 1
            RETURN
          END IF
          C = DBLE(INT(REST + SIGN(BELHAL, REST)))
          LIMB(W*I+K) = C
          REST = (REST - C)*BASE
          I = I + 1
          GO TO 20
        END IF
        USED = MAX(USED, I)
   30 CONTINUE
      END

C     HHCARR (carry) - reduces the limbs of W numbers, STEP doubles
C     apart and below 2**53, to at most BASE/2, from the last one up.
C     Limb 1 keeps what is carried into it.
      SUBROUTINE HHCARR(N, W, STEP, R)
      INTEGER N, W, STEP
      DOUBLE PRECISION R(*)
      DOUBLE PRECISION BASE
      PARAMETER (BASE = 2.0D0**24)
      DOUBLE PRECISION HHRNDL, C
      INTEGER I, K
      DO 20 I = N - 1, 1, -1
        DO 10 K = STEP*I + 1, STEP*I + W
          C = HHRNDL(R(K)/BASE)
          R(K) = R(K) - C*BASE
          R(K-STEP) = R(K-STEP) + C
   10   CONTINUE
   20 CONTINUE
      END

C     HHSIGN (sign_of_limbs) - returns the sign of R, by Horner's rule
C     from the top; or, if R errs by up to ERR > 0 units of its last
C     limb, UNSURE where that could change it.  After a partial sum of
C     more than 2 CARRY + ERR units neither the rest, carried or not,
C     nor ERR can change the sign.  (The last sum may pass 2**53,
C     several times that, and be rounded; the rounding of a number that
C     large does not change its sign, and ends the loop.)
      INTEGER FUNCTION HHSIGN(N, ERR, R)
      INTEGER N
      DOUBLE PRECISION ERR, R(*)
      INTEGER UNSURE
      DOUBLE PRECISION BASE, CARRY
      PARAMETER (UNSURE = 2, BASE = 2.0D0**24, CARRY = 2.0D0**29)
      DOUBLE PRECISION S
      INTEGER I
      S = 0.0D0
      DO 10 I = 1, N
        IF (ABS(S) .GT. 2.0D0*CARRY + ERR) GO TO 20
        S = S*BASE + R(I)
   10 CONTINUE
   20 HHSIGN = 1
      IF (S .LT. 0.0D0) HHSIGN = -1
      IF (ABS(S) .LE. ERR) THEN
        HHSIGN = 0
        IF (ERR .GT. 0.0D0) HHSIGN = UNSURE
      END IF
      END

C     HHSPDI (split_differences) - splits the coordinates Q of NP
C     points, side by side, and subtracts the last point from all
C     others.  USED is the number of limbs in use, or N + 1 if N limbs
C     do not hold them.
      SUBROUTINE HHSPDI(NP, Q, TOP, N, X, USED)
      INTEGER NP, N, USED
      DOUBLE PRECISION Q(3,*), TOP, X(*)
      INTEGER AT, I, LAST, W
      W = 3*NP
      CALL HHSPLI(W, Q, TOP, N, X, USED)
      DO 20 I = 1, MIN(USED, N)
        LAST = W*I - 3
        DO 10 AT = W*(I - 1), LAST - 3, 3
          X(AT+1) = X(AT+1) - X(LAST+1)
          X(AT+2) = X(AT+2) - X(LAST+2)
          X(AT+3) = X(AT+3) - X(LAST+3)
   10   CONTINUE
   20 CONTINUE
      END

C     HHPROD (add_product) - adds a product of X and Y, of NX and NY
C     limbs, to the WIDE(KIND) numbers R, of N limbs; WX, WY and W
C     doubles lie between two limbs.  Rows behind the N-th are left out.
C     R is carried where 10 rows have been added, but not at the end.
C
C     The kinds of product of X and Y, for limbs I and J of theirs:
C       DOT     X.Y
C       COFACT  of four numbers each, X2 Y1 - X1 Y2 + X4 Y3 - X3 Y4
C       CROSS   the cross product
C       SCALED  the vector X times the number Y
C       SQUARE  of vectors A, B, C, D side by side, X = Y, the four
C               squares
C       PAIRED  with Y of two vectors, A and B times the first, C and D
C               times the second
      SUBROUTINE HHPROD(KIND, NX, WX, X, NY, WY, Y, N, W, R)
      INTEGER KIND, NX, WX, NY, WY, N, W
      DOUBLE PRECISION X(*), Y(*), R(*)
      INTEGER DOT, COFACT, CROSS, SCALED, SQUARE
      PARAMETER (DOT = 1, COFACT = 2, CROSS = 3, SCALED = 4, SQUARE = 5)
      DOUBLE PRECISION A, B, C, D
      INTEGER AT, I, J, K, LAST, P, ROWS, S, T, USED(6), WIDE(6)
      DATA USED /3, 4, 3, 3, 12, 12/
      DATA WIDE /1, 1, 3, 3, 4, 4/
C     Y's 1 2 3 4, or 1 1 2 2
      P = 0
      IF (KIND .EQ. SQUARE) P = 3
      ROWS = 0
      DO 80 I = 1, MIN(NX, N - 1)
        AT = WX*(I - 1)
        DO 10 K = AT + 1, AT + USED(KIND)
          IF (ABS(X(K)) .GT. 0.0D0) GO TO 20
   10   CONTINUE
        GO TO 80
   20   IF (ROWS .EQ. 10) THEN
          CALL HHCARR(N - I + 1, WIDE(KIND), W, R(W*(I-1)+1))
          ROWS = 0
        END IF
        ROWS = ROWS + 1
        A = X(AT+1)
        B = X(AT+2)
        C = X(AT+3)
        T = 0
        S = W*I
        LAST = MIN(NY, N - I)
        IF (KIND .EQ. DOT) THEN
          DO 30 J = 1, LAST
            R(S+1) = R(S+1) + (A*Y(T+1) + B*Y(T+2) + C*Y(T+3))
            S = S + W
            T = T + WY
   30     CONTINUE
        ELSE IF (KIND .EQ. COFACT) THEN
          D = X(AT+4)
          DO 40 J = 1, LAST
            R(S+1) = R(S+1) +
     $          (B*Y(T+1) - A*Y(T+2) + D*Y(T+3) - C*Y(T+4))
            S = S + W
            T = T + WY
   40     CONTINUE
        ELSE IF (KIND .EQ. CROSS) THEN
          DO 50 J = 1, LAST
            R(S+1) = R(S+1) + (B*Y(T+3) - C*Y(T+2))
            R(S+2) = R(S+2) + (C*Y(T+1) - A*Y(T+3))
            R(S+3) = R(S+3) + (A*Y(T+2) - B*Y(T+1))
            S = S + W
            T = T + WY
   50     CONTINUE
        ELSE IF (KIND .EQ. SCALED) THEN
          DO 60 J = 1, LAST
            R(S+1) = R(S+1) + A*Y(T+1)
            R(S+2) = R(S+2) + B*Y(T+1)
            R(S+3) = R(S+3) + C*Y(T+1)
            S = S + W
            T = T + WY
   60     CONTINUE
        ELSE
          DO 70 J = 1, LAST
            K = T + P
            R(S+1) = R(S+1) + (A*Y(T+1) + B*Y(T+2) + C*Y(T+3))
            R(S+2) = R(S+2) + (X(AT+4)*Y(K+1) + X(AT+5)*Y(K+2) +
     $                         X(AT+6)*Y(K+3))
            R(S+3) = R(S+3) + (X(AT+7)*Y(K+4) + X(AT+8)*Y(K+5) +
     $                         X(AT+9)*Y(K+6))
            K = K + P
            R(S+4) = R(S+4) + (X(AT+10)*Y(K+4) + X(AT+11)*Y(K+5) +
     $                         X(AT+12)*Y(K+6))
            S = S + W
            T = T + WY
   70     CONTINUE
        END IF
   80 CONTINUE
      END

C     The routines that OF of HHEVAL names, HHVOLU, HHISPH, HHFT and
C     HHWGH, evaluate points from the rows P - last, of N limbs, that
C     HHSPDI leaves in WORK, of which they may use 44N doubles.

C     HHVOLU (orient_by_limbs) - SGN is the orientation of points A, B,
C     C, D: minus the sign of the determinant of the rows A-D, B-D, C-D.
C     W is scratch.
      SUBROUTINE HHVOLU(N, WORK, W, SGN)
      INTEGER N, SGN
      DOUBLE PRECISION WORK(*), W(*)
      INTEGER DOT, CROSS
      PARAMETER (DOT = 1, CROSS = 3)
      INTEGER HHSIGN, D, M
      M = 12*N + 1
      D = 18*N + 1
      CALL HHZERO(9*N, WORK(M))
      CALL HHPROD(CROSS, N, 12, WORK, N, 12, WORK(4), 2*N, 3, WORK(M))
      CALL HHCARR(2*N, 3, 3, WORK(M))
      CALL HHPROD(DOT, N, 12, WORK(7), 2*N, 3, WORK(M), 3*N, 1, WORK(D))
      SGN = -HHSIGN(3*N, 0.0D0, WORK(D))
      W(1) = 0.0D0
      END

C     HHCOFA (cofactors) - computes the determinants of three of the
C     rows A-E, B-E, C-E, D-E, without B, A, D and C in turn: four
C     numbers, side by side, of 3N limbs, the last 12N of 39N doubles.
      SUBROUTINE HHCOFA(N, WORK)
      INTEGER N
      DOUBLE PRECISION WORK(*)
      INTEGER CROSS, PAIRED
      PARAMETER (CROSS = 3, PAIRED = 6)
      INTEGER D, M
      M = 15*N + 1
      D = 27*N + 1
      CALL HHZERO(24*N, WORK(M))
      CALL HHPROD(CROSS, N, 15, WORK(7), N, 15, WORK(10), 2*N, 6,
     $            WORK(M))
      CALL HHPROD(CROSS, N, 15, WORK, N, 15, WORK(4), 2*N, 6, WORK(M+3))
      CALL HHCARR(2*N, 6, 6, WORK(M))
      CALL HHPROD(PAIRED, N, 15, WORK, 2*N, 6, WORK(M), 3*N, 4, WORK(D))
      CALL HHCARR(3*N, 4, 4, WORK(D))
      END

C     HHISPH (insphere_by_limbs) - SGN is the sign of the determinant I
C     of HHFIL5.  W is scratch.
      SUBROUTINE HHISPH(N, WORK, W, SGN)
      INTEGER N, SGN
      DOUBLE PRECISION WORK(*), W(*)
      INTEGER COFACT, SQUARE
      PARAMETER (COFACT = 2, SQUARE = 5)
      INTEGER HHSIGN, D, L, T
      L = 15*N + 1
      D = 27*N + 1
      T = 39*N + 1
      CALL HHCOFA(N, WORK)
      CALL HHZERO(8*N, WORK(L))
      CALL HHZERO(5*N, WORK(T))
      CALL HHPROD(SQUARE, N, 15, WORK, N, 15, WORK, 2*N, 4, WORK(L))
      CALL HHCARR(2*N, 4, 4, WORK(L))
      CALL HHPROD(COFACT, 2*N, 4, WORK(L), 3*N, 4, WORK(D), 5*N, 1,
     $            WORK(T))
      SGN = HHSIGN(5*N, 0.0D0, WORK(T))
      W(1) = 0.0D0
      END

C     HHLEAD (leading_value) - VALUE is the value of a carried number of
C     N limbs, STEP apart from R(FIRST) on, in units of its first limb
C     that is not 0, limb AT.  Behind it comes at most half a unit and a
C     little, so VALUE is at least nearly one half: the rounding of the
C     last sum and that of the one before, of at most half a unit, count
C     for less than 2.1 EPS of it.
      SUBROUTINE HHLEAD(N, R, FIRST, STEP, VALUE, AT)
      INTEGER N, FIRST, STEP, AT
      DOUBLE PRECISION R(*), VALUE
      INTEGER DBLLIM
      DOUBLE PRECISION BASE
      PARAMETER (BASE = 2.0D0**24, DBLLIM = 4)
      INTEGER HHFROW, I
      AT = HHFROW(N - 1, 1, STEP, R(FIRST))
      VALUE = 0.0D0
      DO 10 I = MIN(AT + DBLLIM - 1, N), AT, -1
        VALUE = VALUE/BASE + R(FIRST+STEP*(I-1))
   10 CONTINUE
      END

C     HHNRML (normalize_weights) - divides the absolute values of N
C     numbers W, whose leading limbs are limbs AT, by their sum.  Each
C     weight is right to 12 EPS of itself, as the numbers are to 2.1
C     EPS, or underflows.  W is left alone if all are 0.
      SUBROUTINE HHNRML(N, AT, W)
      INTEGER N, AT(*)
      DOUBLE PRECISION W(*)
      INTEGER BITS
      PARAMETER (BITS = 24)
      DOUBLE PRECISION HHLDEX, SUM
      INTEGER K, TOP
      SUM = 0.0D0
      TOP = 32000
      DO 10 K = 1, N
        IF (ABS(W(K)) .GT. 0.0D0) TOP = MIN(TOP, AT(K))
   10 CONTINUE
      DO 20 K = 1, N
        IF (ABS(W(K)) .GT. 0.0D0) W(K) =
     $      ABS(HHLDEX(W(K), MAX((TOP - AT(K))*BITS, -2000)))
        SUM = SUM + W(K)
   20 CONTINUE
      DO 30 K = 1, N
        IF (SUM .GT. 0.0D0) W(K) = W(K)/SUM
   30 CONTINUE
      END

C     HHNFAC (nearest_face) - returns the face of a triangle whose
C     interior has the triangle's point nearest to Q: the sum of
C     2**(K-1) for its vertices K.  Side I leads from vertex I to the
C     next one; D(3*I-3+K) has the sign of the product of side I and Q -
C     vertex K, D(9+K) that of the weight of vertex K at the foot of the
C     perpendicular from Q.
      INTEGER FUNCTION HHNFAC(D)
      DOUBLE PRECISION D(12)
      INTEGER I, J, K
      DO 10 I = 1, 3
        K = MOD(I + 1, 3) + 1
        HHNFAC = 2**(I-1)
        IF (D(4*I-3) .LE. 0.0D0 .AND. D(3*K-3+I) .GE. 0.0D0) RETURN
   10 CONTINUE
      DO 20 I = 1, 3
        J = MOD(I, 3) + 1
        K = MOD(I + 1, 3) + 1
        HHNFAC = 2**(I-1) + 2**(J-1)
        IF (D(9+K) .LE. 0.0D0 .AND. D(4*I-3) .GE. 0.0D0 .AND.
     $      D(3*I-3+J) .LE. 0.0D0) RETURN
   20 CONTINUE
      HHNFAC = 7
      END

C     HHFT (foot_by_limbs) - SGN is minus HHNFAC's answer, and W the
C     weights of the vertices in that point: shares of areas or, on a
C     side, of products with it.  The rows U, V, W = B-A, C-A, Q-A of a
C     triangle A, B, C give the products of sides U, V-U, -V and offsets
C     W, W-U, W-V, and with sides S and offsets O
C         area K = (S(I).O(J)) (S(K).O(I)) - (S(I).O(I)) (S(K).O(J)),
C     I, J, K cyclic: component K of the cross product of the products
C     of S(K) and of S(I).
      SUBROUTINE HHFT(N, WORK, W, SGN)
      INTEGER N, SGN
      DOUBLE PRECISION WORK(*), W(*)
      INTEGER DOT, CROSS
      PARAMETER (DOT = 1, CROSS = 3)
      INTEGER HHNFAC
      DOUBLE PRECISION VALUE(12)
      INTEGER A, AT(12), D, FROM(3), I, K, L, PAIR(2,5), R, S, SET
      DATA PAIR /1, 7, 4, 7, 1, 1, 1, 4, 4, 4/
      D = 12*N + 1
      A = 30*N + 1
      CALL HHZERO(10*N, WORK(A))
      DO 10 K = 1, 5
        CALL HHPROD(DOT, N, 12, WORK(PAIR(1,K)), N, 12,
     $              WORK(PAIR(2,K)), 2*N, 5, WORK(A+K-1))
   10 CONTINUE
      CALL HHCARR(2*N, 5, 5, WORK(A))
      DO 30 I = 0, 2*N - 1
        R = D + 9*I
        S = A + 5*I
        WORK(R) = WORK(S)
        WORK(R+1) = WORK(S) - WORK(S+2)
        WORK(R+2) = WORK(S) - WORK(S+3)
        WORK(R+6) = -WORK(S+1)
        WORK(R+7) = WORK(S+3) - WORK(S+1)
        WORK(R+8) = WORK(S+4) - WORK(S+1)
        DO 20 K = R, R + 2
          WORK(K+3) = -WORK(K) - WORK(K+6)
   20   CONTINUE
   30 CONTINUE
      CALL HHCARR(2*N, 9, 9, WORK(D))
      DO 40 K = 1, 9
        CALL HHLEAD(2*N, WORK, D + K - 1, 9, VALUE(K), AT(K))
   40 CONTINUE
      DO 50 K = 1, 3
        CALL HHZERO(12*N, WORK(A))
        CALL HHPROD(CROSS, 2*N, 9, WORK(D+3*K-3), 2*N, 9,
     $              WORK(D+3*MOD(K,3)), 4*N, 3, WORK(A))
        CALL HHCARR(4*N, 3, 3, WORK(A))
        CALL HHLEAD(4*N, WORK, A + K - 1, 3, VALUE(9+K), AT(9+K))
   50 CONTINUE
      SET = HHNFAC(VALUE)
      SGN = -SET
      DO 60 K = 1, 3
        FROM(K) = 9 + K
        W(K) = DBLE(MOD(SET/2**(K-1), 2))
   60 CONTINUE
      IF (SET .EQ. 1 .OR. SET .EQ. 2 .OR. SET .EQ. 4) RETURN
      DO 70 K = 1, 3
        L = MOD(K, 3) + 1
        IF (W(MOD(K + 1, 3) + 1) .GT. 0.0D0) GO TO 70
        FROM(K) = 3*K - 3 + L
        FROM(L) = 4*K - 3
   70 CONTINUE
      DO 80 K = 1, 3
        W(K) = W(K)*VALUE(FROM(K))
        FROM(K) = AT(FROM(K))
   80 CONTINUE
      CALL HHNRML(3, FROM, W)
      END

C     HHWGH (weights_by_limbs) - computes the weights W of the point E
C     in the tetrahedron A, B, C, D that contains it: shares of the
C     volumes of the four tetrahedra in which E replaces a vertex.  SGN
C     is 0.
      SUBROUTINE HHWGH(N, WORK, W, SGN)
      INTEGER N, SGN
      DOUBLE PRECISION WORK(*), W(4)
      INTEGER AT(4), K, L
      CALL HHCOFA(N, WORK)
      DO 10 K = 1, 4
        L = K - 1 + 2*MOD(K, 2)
        CALL HHLEAD(3*N, WORK, 27*N + K, 4, W(L), AT(L))
   10 CONTINUE
      CALL HHNRML(4, AT, W)
      SGN = 0
      END

C     HHEVAL (evaluate) - evaluates NP points Q with NMAX limbs, by OF:
C     HHVOLU or HHFT, for 4 points; HHISPH or HHWGH, for 5.  SGN is
C     UNSURE if these limbs do not hold them.  WORK: 44 NMAX doubles.
C     Limbs 1 that are 0 in all rows are left out as long as the next
C     ones can serve as limbs 1.
      SUBROUTINE HHEVAL(NP, OF, Q, TOP, NMAX, WORK, W, SGN)
      INTEGER NP, NMAX, SGN
      DOUBLE PRECISION Q(3,*), TOP, WORK(*), W(*)
      EXTERNAL OF
      INTEGER UNSURE
      DOUBLE PRECISION BASE
      PARAMETER (UNSURE = 2, BASE = 2.0D0**24)
      INTEGER AT, K, N, WIDE
      WIDE = 3*NP
      CALL HHSPDI(NP, Q, TOP, NMAX, WORK, N)
      SGN = UNSURE
      IF (N .GT. NMAX) RETURN
      AT = 1
   10 IF (N .GT. 1) THEN
        DO 20 K = AT, AT + WIDE - 4
          IF (ABS(WORK(K)) .GT. 0.0D0 .OR.
     $        ABS(WORK(K+WIDE)) .GT. BASE/4.0D0) GO TO 30
   20   CONTINUE
        N = N - 1
        AT = AT + WIDE
        GO TO 10
      END IF
   30 CALL OF(N, WORK(AT), W, SGN)
      END

C     HHEVLG (evaluate_long) - does what HHEVAL does, with as many limbs
C     as it takes: a routine of its own for the sake of its scratch.
      SUBROUTINE HHEVLG(NP, OF, Q, TOP, W, SGN)
      INTEGER NP, SGN
      DOUBLE PRECISION Q(3,*), TOP, W(*)
      EXTERNAL OF
      INTEGER UNSURE, HHLIM
      PARAMETER (UNSURE = 2, HHLIM = 88)
      DOUBLE PRECISION WORK(44*HHLIM)
      INTEGER N
      N = MIN(10, HHLIM)
   10 IF (2*N .GT. HHLIM) N = HHLIM
      CALL HHEVAL(NP, OF, Q, TOP, N, WORK, W, SGN)
      N = 2*N
      IF (SGN .EQ. UNSURE .AND. N .LE. HHLIM) GO TO 10
      END

C     HHEVEX (evaluate_exactly) - evaluates NP points Q with 3 limbs,
C     which hold ordinary data (70 bits), or with HHEVLG; MOST is the
C     largest absolute value of Q, which it alters.  If all are 0, so
C     are an orientation and an insphere determinant; no triangle for
C     HHFT and no tetrahedron for HHWGH has all its vertices there.
      SUBROUTINE HHEVEX(NP, OF, Q, MOST, W, SGN)
      INTEGER NP, SGN
      DOUBLE PRECISION Q(3,*), MOST, W(*)
      EXTERNAL OF
      INTEGER UNSURE, HHLIM
      PARAMETER (UNSURE = 2, HHLIM = 88)
      DOUBLE PRECISION FACTOR, TOP, WORK(44*3)
      SGN = 0
      IF (MOST .LE. 0.0D0) RETURN
      CALL HHTOPW(NP, Q, MOST, FACTOR, TOP)
      CALL HHEVAL(NP, OF, Q, TOP, 3, WORK, W, SGN)
      IF (SGN .EQ. UNSURE .AND. HHLIM .GT. 3)
     $    CALL HHEVLG(NP, OF, Q, TOP, W, SGN)
      END

C     ------------------------------------------------------------------
C     The arithmetic: what numbers are, and what becomes of them here.
C     ------------------------------------------------------------------

C     HHV500 - the version; does nothing.
      SUBROUTINE HHV500
      RETURN
      END

C     HHL088 - the limbs; does nothing.
      SUBROUTINE HHL088
      RETURN
      END

C     HHKIND - returns 3 for a NaN, 2 for an infinity, 1 for a subnormal
C     number, -1 for a zero, 0 for all others; 4 where the compiler was
C     told to make DOUBLE PRECISION something else than 64 bits.
C
C     The test is by bits, seen as integers: a compiler that was told
C     that there are no NaNs may drop any comparison that looks for
C     them, and a processor may take subnormal numbers for zero.  The
C     least normal number has the exponent 1 and no other bits: that
C     tells which integer has the exponent, and where in it.  2**1023
C     has the greatest exponent of a finite number, 2046.  Where an
C     integer is as long as a double, the second one is that of the 0
C     behind it.
      INTEGER FUNCTION HHKIND(X)
      DOUBLE PRECISION X
      DOUBLE PRECISION NORMAL
      PARAMETER (NORMAL = 2.0D0**(-1022))
      DOUBLE PRECISION A(2), LEAST(2), MINUS(2), MOST(2)
      INTEGER I(4), ILEAST(4), IMINUS(4), IMOST(4), HIGH, SIZE
      EQUIVALENCE (A(1), I(1)), (LEAST(1), ILEAST(1))
      EQUIVALENCE (MINUS(1), IMINUS(1)), (MOST(1), IMOST(1))
      A(1) = X
      A(2) = 0.0D0
      LEAST(1) = NORMAL
      MINUS(1) = -NORMAL
      MOST(1) = 2.0D0**1023
      HIGH = 1
      IF (ILEAST(1) .EQ. 0) HIGH = 2
      HHKIND = 4
      IF (ILEAST(HIGH) .EQ. 0) RETURN
      IF (IMOST(HIGH)/ILEAST(HIGH) .NE. 2046) RETURN
      SIZE = I(HIGH)
C     without the sign
      IF (SIZE .LT. 0) SIZE = SIZE - (IMINUS(HIGH) - ILEAST(HIGH))
      HHKIND = 0
      IF (SIZE .LT. ILEAST(HIGH)) HHKIND = 1
      IF (SIZE .EQ. 0 .AND. I(3-HIGH) .EQ. 0) HHKIND = -1
      SIZE = SIZE - (IMOST(HIGH) + ILEAST(HIGH))
      IF (SIZE .GE. 0) HHKIND = 3
      IF (SIZE .EQ. 0 .AND. I(3-HIGH) .EQ. 0) HHKIND = 2
      END

C     HHFINI - returns how many of N points P, counted from the first,
C     have finite coordinates before one that has not: N if all have.
      INTEGER FUNCTION HHFINI(N, P)
      INTEGER N
      DOUBLE PRECISION P(3,*)
      INTEGER HHKIND, I, K, KIND
      DO 20 I = 1, N
        DO 10 K = 1, 3
          KIND = HHKIND(P(K,I))
          IF (KIND .EQ. 2 .OR. KIND .EQ. 3) GO TO 30
   10   CONTINUE
   20 CONTINUE
      I = N + 1
   30 HHFINI = I - 1
      END

C     HHFULL (full_precision) - returns 1 if arithmetic keeps all bits
C     of a double, or 0.  An x87 unit may have been set to fewer.
C     (PROBE + M)**2, M = 1 or 3, needs nearly all of them, and all
C     steps are exact if they are kept.  M is known only at run time, so
C     that a compiler cannot evaluate the test beforehand.
      INTEGER FUNCTION HHFULL(M)
      INTEGER M
      DOUBLE PRECISION PROBE
      PARAMETER (PROBE = 2.0D0**26)
      DOUBLE PRECISION A
      A = PROBE + DBLE(M)
      HHFULL = 0
      IF (ABS(A*A - PROBE*PROBE - 2.0D0*PROBE*DBLE(M) -
     $    DBLE(M*M)) .LE. 0.0D0) HHFULL = 1
      END

C     HHHELD - returns 1 if DOUBLE PRECISION has 64 bits, and the
C     arithmetic keeps the coordinates of the point P, or 0: they are
C     finite, and it takes none but 0 for 0.  A processor may have been
C     set to do that to subnormal operands, which no comparison can find
C     then, or to subnormal results.
      INTEGER FUNCTION HHHELD(P)
      DOUBLE PRECISION P(3)
      DOUBLE PRECISION A(2)
      INTEGER HHKIND, I(4), K, KIND, M
      EQUIVALENCE (A(1), I(1))
      HHHELD = 0
      DO 10 K = 1, 3
        KIND = HHKIND(P(K))
        IF (KIND .GT. 1) RETURN
        IF (KIND .EQ. 1) THEN
C         one of the products is that by 1; which one is known only at
C         run time, so that no compiler drops it
          A(1) = P(2)
          M = 2*MOD(I(1), 2)**2 + 1
          IF (HHKIND(P(K)*DBLE(M)) .EQ. -1) RETURN
          IF (HHKIND(P(K)*DBLE(4 - M)) .EQ. -1) RETURN
        END IF
   10 CONTINUE
      HHHELD = 1
      END

C     HHHOLD - returns 1 if the arithmetic is precise, and HHHELD is 1
C     for all N points P; or 0.
      INTEGER FUNCTION HHHOLD(N, P)
      INTEGER N
      DOUBLE PRECISION P(3,*)
      INTEGER HHHELD, HHFULL, I, M
      HHHOLD = 0
      M = 1 + 2*MOD(N, 2)
      IF (HHFULL(M) .EQ. 0) RETURN
      DO 10 I = 1, N
        IF (HHHELD(P(1,I)) .EQ. 0) RETURN
   10 CONTINUE
      HHHOLD = 1
      END

C     ------------------------------------------------------------------
C     Exact signs: a filter, then limbs.
C
C     A filter compares a determinant with a multiple of its permanent,
C     the same expression with absolute values, as in Shewchuk (1997),
C     but for every rounding mode.  The filters take coordinates of
C     absolute value at most 1, possibly with an absolute error where
C     tiny ones underflowed.  A term of the orientation determinant is a
C     product of 3 differences with at most 5 more roundings in it, one
C     of the insphere determinant a product of 5 differences with at
C     most 12: relative errors of at most 8 EPS and 17 EPS of the
C     permanent in any rounding mode and any order of evaluation.  The
C     filters allow 16 and 32; the roundings of the permanent itself and
C     of the bound are of second order, some 20 EPS of that.  Underflow,
C     and coordinates that underflowed, add less than DETUND: an error
C     of NORMAL in each difference and product, times differences of at
C     most 2 each.  With T >= 0 all coordinates are integer multiples of
C     some unit, none of them an underflowed one, and a permanent of at
C     most T (2**52 units) means that nothing was rounded at all.
C     ------------------------------------------------------------------

C     HHCERT (sign_if_certain) - returns the sign of DET if |DET|
C     exceeds its error or DET is exact, else UNSURE.
      INTEGER FUNCTION HHCERT(DET, PERM, FACTOR, T)
      DOUBLE PRECISION DET, PERM, FACTOR, T
      INTEGER UNSURE
      DOUBLE PRECISION EPS, DETUND
      PARAMETER (EPS = 2.0D0**(-52), UNSURE = 2,
     $    DETUND = 2.0D0**(-1000))
      DOUBLE PRECISION ERR
      ERR = FACTOR*EPS*PERM + DETUND
      IF (DET .GT. ERR) THEN
        HHCERT = 1
      ELSE IF (DET .LT. -ERR) THEN
        HHCERT = -1
      ELSE IF (PERM .LE. T) THEN
        HHCERT = 0
        IF (DET .GT. 0.0D0) HHCERT = 1
        IF (DET .LT. 0.0D0) HHCERT = -1
      ELSE
        HHCERT = UNSURE
      END IF
      END

C     HHFIL3 (orient_filter) - returns the sign of det [B-A C-A D-A], or
C     UNSURE, of points A, B, C, D of X.
      INTEGER FUNCTION HHFIL3(X, A, B, C, D, T)
      INTEGER A, B, C, D
      DOUBLE PRECISION X(3,*), T
      DOUBLE PRECISION BX, BXY, BXZ, BY, BYX, BYZ, BZ, BZX, BZY, CX, CY,
     $    CZ, DET, DX, DY, DZ, PERM
      INTEGER HHCERT
      BX = X(1,B) - X(1,A)
      BY = X(2,B) - X(2,A)
      BZ = X(3,B) - X(3,A)
      CX = X(1,C) - X(1,A)
      CY = X(2,C) - X(2,A)
      CZ = X(3,C) - X(3,A)
      DX = X(1,D) - X(1,A)
      DY = X(2,D) - X(2,A)
      DZ = X(3,D) - X(3,A)
      BYZ = BY*CZ
      BZY = BZ*CY
      BZX = BZ*CX
      BXZ = BX*CZ
      BXY = BX*CY
      BYX = BY*CX
      DET = DX*(BYZ - BZY) + DY*(BZX - BXZ) + DZ*(BXY - BYX)
      PERM = ABS(DX)*(ABS(BYZ) + ABS(BZY)) +
     $       ABS(DY)*(ABS(BZX) + ABS(BXZ)) +
     $       ABS(DZ)*(ABS(BXY) + ABS(BYX))
      HHFIL3 = HHCERT(DET, PERM, 16.0D0, T)
      END

C     HHFIL5 (insphere_filter) - returns the sign of I = det of the rows
C     (Q - E, |Q - E|**2), Q = A, B, C, D, or UNSURE, of points A, B, C,
C     D, E of X; if LIFT is 1, of the rows (Q - E, H), the four numbers
C     H right to 4 EPS of themselves, less than those squares suffer.  E
C     is inside the ball of A, B, C, D iff I and the determinant of the
C     rows A-D, B-D, C-D have one sign.
      INTEGER FUNCTION HHFIL5(X, A, B, C, D, E, LIFT, H, T)
      INTEGER A, B, C, D, E, LIFT
      DOUBLE PRECISION X(3,*), H(4), T
      DOUBLE PRECISION AB, AB1, AB2, AC, AC1, AC2, AX, AY, AZ, BC, BC1,
     $    BC2, BD, BD1, BD2, BX, BY, BZ, CD, CD1, CD2, CX, CY, CZ, DA,
     $    DA1, DA2, DET, DX, DY, DZ, LA, LB, LC, LD, PERM
      INTEGER HHCERT
      AX = X(1,A) - X(1,E)
      AY = X(2,A) - X(2,E)
      AZ = X(3,A) - X(3,E)
      BX = X(1,B) - X(1,E)
      BY = X(2,B) - X(2,E)
      BZ = X(3,B) - X(3,E)
      CX = X(1,C) - X(1,E)
      CY = X(2,C) - X(2,E)
      CZ = X(3,C) - X(3,E)
      DX = X(1,D) - X(1,E)
      DY = X(2,D) - X(2,E)
      DZ = X(3,D) - X(3,E)
      LA = AX*AX + AY*AY + AZ*AZ
      LB = BX*BX + BY*BY + BZ*BZ
      LC = CX*CX + CY*CY + CZ*CZ
      LD = DX*DX + DY*DY + DZ*DZ
      IF (LIFT .EQ. 1) THEN
        LA = H(1)
        LB = H(2)
        LC = H(3)
        LD = H(4)
      END IF
      AB1 = AX*BY
      AB2 = BX*AY
      BC1 = BX*CY
      BC2 = CX*BY
      CD1 = CX*DY
      CD2 = DX*CY
      DA1 = DX*AY
      DA2 = AX*DY
      AC1 = AX*CY
      AC2 = CX*AY
      BD1 = BX*DY
      BD2 = DX*BY
      AB = AB1 - AB2
      BC = BC1 - BC2
      CD = CD1 - CD2
      DA = DA1 - DA2
      AC = AC1 - AC2
      BD = BD1 - BD2
      DET = LB*(AZ*CD + CZ*DA + DZ*AC) - LA*(BZ*CD - CZ*BD + DZ*BC) +
     $      LD*(AZ*BC - BZ*AC + CZ*AB) - LC*(AZ*BD + BZ*DA + DZ*AB)

      AB = ABS(AB1) + ABS(AB2)
      BC = ABS(BC1) + ABS(BC2)
      CD = ABS(CD1) + ABS(CD2)
      DA = ABS(DA1) + ABS(DA2)
      AC = ABS(AC1) + ABS(AC2)
      BD = ABS(BD1) + ABS(BD2)
      AZ = ABS(AZ)
      BZ = ABS(BZ)
      CZ = ABS(CZ)
      DZ = ABS(DZ)
      PERM = ABS(LA)*(BZ*CD + CZ*BD + DZ*BC) +
     $       ABS(LB)*(AZ*CD + CZ*DA + DZ*AC) +
     $       ABS(LC)*(AZ*BD + BZ*DA + DZ*AB) +
     $       ABS(LD)*(AZ*BC + BZ*AC + CZ*AB)
      HHFIL5 = HHCERT(DET, PERM, 32.0D0, T)
      END

C     HHFILT (sign_filter) - returns the orientation of NP = 4 points Q,
C     or HHFIL5's answer for 5; or UNSURE.
      INTEGER FUNCTION HHFILT(NP, Q, T)
      INTEGER NP
      DOUBLE PRECISION Q(3,*), T
      INTEGER HHFIL3, HHFIL5
      IF (NP .EQ. 4) THEN
        HHFILT = HHFIL3(Q, 1, 2, 3, 4, T)
      ELSE
        HHFILT = HHFIL5(Q, 1, 2, 3, 4, 5, 0, Q, T)
      END IF
      END

C     HHNFFL (nearest_face_filter) - returns what HHFT does, minus
C     HHNFAC's answer, for S, the points B, C, Q, A of the triangle A,
C     B, C and Q, scaled; UNSURE if double precision does not decide all
C     signs.  Relative to the sum of its terms' absolute values, as in
C     HHFIL3, a product of side and offset errs by 5 EPS, an area by 12.
      INTEGER FUNCTION HHNFFL(S)
      DOUBLE PRECISION S(3,*)
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHCERT, HHNFAC
      DOUBLE PRECISION D(12), ERR, MOST(9), OFF(9), SIDE(9), SUM
      INTEGER I, J, K, L, VERTEX(4)
      DATA VERTEX /4, 1, 2, 4/
      HHNFFL = UNSURE
      DO 20 I = 1, 3
        DO 10 K = 1, 3
          SIDE(3*I-3+K) = S(K,VERTEX(I+1)) - S(K,VERTEX(I))
          OFF(3*I-3+K) = S(K,3) - S(K,VERTEX(I))
   10   CONTINUE
   20 CONTINUE
      DO 40 I = 1, 9
        J = (I - 1)/3
        L = MOD(I - 1, 3)
        D(I) = 0.0D0
        MOST(I) = 0.0D0
        DO 30 K = 1, 3
          SUM = SIDE(3*J+K)*OFF(3*L+K)
          D(I) = D(I) + SUM
          MOST(I) = MOST(I) + ABS(SUM)
   30   CONTINUE
        IF (L .NE. MOD(J + 2, 3)) THEN
          IF (HHCERT(D(I), MOST(I), 16.0D0, -1.0D0) .EQ. UNSURE) RETURN
        END IF
   40 CONTINUE
      DO 50 I = 1, 3
        J = MOD(I, 3) + 1
        K = MOD(I + 1, 3) + 1
        D(9+K) = D(3*I-3+J)*D(3*K-3+I) - D(4*I-3)*D(3*K-3+J)
        ERR = MOST(3*I-3+J)*MOST(3*K-3+I) + MOST(4*I-3)*MOST(3*K-3+J)
        IF (HHCERT(D(9+K), ERR, 64.0D0, -1.0D0) .EQ. UNSURE) RETURN
   50 CONTINUE
      HHNFFL = -HHNFAC(D)
      END

C     HHPACK (pack_points) - returns the largest absolute value of NP
C     points Q.  (C's pack_points copies them into one array, too.)
      DOUBLE PRECISION FUNCTION HHPACK(NP, Q)
      INTEGER NP
      DOUBLE PRECISION Q(3,*)
      INTEGER I
      HHPACK = 0.0D0
      DO 10 I = 1, NP
        HHPACK = MAX(HHPACK, ABS(Q(1,I)), ABS(Q(2,I)), ABS(Q(3,I)))
   10 CONTINUE
      END

C     HHSCAL (scale_to_unit) - sets Q = P 2**(-E), NP points, with E
C     such that MOST, the largest absolute value among them, becomes at
C     most 1, and not tiny.
      SUBROUTINE HHSCAL(NP, MOST, P, Q, E)
      INTEGER NP, E
      DOUBLE PRECISION MOST, P(3,*), Q(3,*)
      INTEGER QUICKE
      DOUBLE PRECISION QUICKS
      PARAMETER (QUICKE = 96, QUICKS = 2.0D0**(-96))
      DOUBLE PRECISION HHLDEX, F
      INTEGER HHFREX, I, K
      IF (MOST .GE. QUICKS .AND. MOST .LE. 1.0D0/QUICKS) THEN
        F = QUICKS
        E = QUICKE
        IF (MOST .LE. 1.0D0) THEN
          F = 1.0D0
          E = 0
        END IF
        DO 20 I = 1, NP
          DO 10 K = 1, 3
            Q(K,I) = F*P(K,I)
   10     CONTINUE
   20   CONTINUE
      ELSE
        E = HHFREX(MOST)
        DO 40 I = 1, NP
          DO 30 K = 1, 3
            Q(K,I) = HHLDEX(P(K,I), -E)
   30     CONTINUE
   40   CONTINUE
      END IF
      END

C     HHXANS (exact_answer) - SGN is what OF (see HHEVAL) finds for NP
C     points P, which HHHOLD or HHHELD has passed, and which it may
C     alter: by a filter, HHFILT if FILTER is 1, HHNFFL if it is 2,
C     none, as weights W are wanted, if it is 0; else by limbs; or
C     UNSURE, where the limbs do not hold the points.  W is scratch
C     where no weights are wanted.
      SUBROUTINE HHXANS(NP, OF, FILTER, P, W, SGN)
      INTEGER NP, FILTER, SGN
      DOUBLE PRECISION P(3,*), W(*)
      EXTERNAL OF
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHFILT, HHNFFL
      DOUBLE PRECISION HHPACK
      DOUBLE PRECISION MOST, S(3,5)
      INTEGER E
      MOST = HHPACK(NP, P)
      SGN = UNSURE
      IF (FILTER .GT. 0) THEN
        CALL HHSCAL(NP, MOST, P, S, E)
        IF (FILTER .EQ. 1) SGN = HHFILT(NP, S, -1.0D0)
        IF (FILTER .EQ. 2) SGN = HHNFFL(S)
        IF (SGN .NE. UNSURE) RETURN
      END IF
      CALL HHEVEX(NP, OF, P, MOST, W, SGN)
      END

C     HHHORI - returns HHORIE's answer for points that HHHOLD or HHHELD
C     has passed.
      INTEGER FUNCTION HHHORI(A, B, C, D)
      DOUBLE PRECISION A(3), B(3), C(3), D(3)
      EXTERNAL HHVOLU
      DOUBLE PRECISION ANY(4), P(3,4)
      INTEGER K, SGN
      DO 10 K = 1, 3
        P(K,1) = A(K)
        P(K,2) = B(K)
        P(K,3) = C(K)
        P(K,4) = D(K)
   10 CONTINUE
      CALL HHXANS(4, HHVOLU, 1, P, ANY, SGN)
      HHHORI = SGN
      END

C     HHHINS - returns HHINSP's answer for such points.
      INTEGER FUNCTION HHHINS(A, B, C, D, E)
      DOUBLE PRECISION A(3), B(3), C(3), D(3), E(3)
      EXTERNAL HHISPH
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      DOUBLE PRECISION ANY(4), P(3,5)
      INTEGER HHHORI, K, SGN, SIDE
      SIDE = HHHORI(A, B, C, D)
      HHHINS = SIDE
      IF (SIDE .EQ. 0 .OR. SIDE .EQ. UNSURE) RETURN
      DO 10 K = 1, 3
        P(K,1) = A(K)
        P(K,2) = B(K)
        P(K,3) = C(K)
        P(K,4) = D(K)
        P(K,5) = E(K)
   10 CONTINUE
      CALL HHXANS(5, HHISPH, 1, P, ANY, SGN)
      HHHINS = UNSURE
      IF (SGN .NE. UNSURE) HHHINS = -SIDE*SGN
      END

C     HHORIE - the exact sign of det [B-A C-A D-A]: 1, 0 or -1; 1 when D
C     is on the side of A, B, C from which they are seen
C     counter-clockwise.  2 when HHLIM limbs do not suffice (never, with
C     the default), for a NaN or an infinity, or when the processor
C     flushes a coordinate to zero or rounds to fewer bits than a double
C     has.
      INTEGER FUNCTION HHORIE(A, B, C, D)
      DOUBLE PRECISION A(3), B(3), C(3), D(3)
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHHORI, HHHELD, HHHOLD
      HHORIE = UNSURE
      IF (HHHOLD(1, A) + HHHELD(B) + HHHELD(C) + HHHELD(D) .EQ. 4)
     $    HHORIE = HHHORI(A, B, C, D)
      END

C     HHINSP - exact: 1 when E is inside the circumsphere of A, B, C, D,
C     whatever their orientation, -1 when it is outside, 0 when it is on
C     it or A, B, C, D are coplanar.  2 as from HHORIE.
      INTEGER FUNCTION HHINSP(A, B, C, D, E)
      DOUBLE PRECISION A(3), B(3), C(3), D(3), E(3)
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHHINS, HHHELD, HHHOLD
      HHINSP = UNSURE
      IF (HHHOLD(1, A) + HHHELD(B) + HHHELD(C) + HHHELD(D) + HHHELD(E)
     $    .EQ. 5) HHINSP = HHHINS(A, B, C, D, E)
      END

C     HHAREA - returns the exact sign of the area of A, B, C projected
C     along an AXIS 1, 2 or 3: of the orientation in the plane of the
C     two other coordinates, in cyclic order.  A, B, C are collinear iff
C     it is 0 along all three axes.
      INTEGER FUNCTION HHAREA(AXIS, A, B, C)
      INTEGER AXIS
      DOUBLE PRECISION A(3), B(3), C(3)
      EXTERNAL HHVOLU
      INTEGER UNSURE
      DOUBLE PRECISION EPS, RAISE, RAISEB
      PARAMETER (EPS = 2.0D0**(-52), UNSURE = 2, RAISE = 2.0D0**600,
     $    RAISEB = 2.0D0**(-200))
      INTEGER HHHOLD
      DOUBLE PRECISION HHPACK
      DOUBLE PRECISION AI, AK, ANY(4), BI, BK, CI, CK, DET, ERR, MOST,
     $    Q(3,4)
      INTEGER I, K, SGN
      I = MOD(AXIS, 3) + 1
      K = MOD(AXIS + 1, 3) + 1
C     halves, whose differences do not overflow
      AI = 0.5D0*A(I)
      AK = 0.5D0*A(K)
      BI = 0.5D0*B(I) - AI
      BK = 0.5D0*B(K) - AK
      CI = 0.5D0*C(I) - AI
      CK = 0.5D0*C(K) - AK
C     as in HHFIL3; underflow, gradual or to 0, puts a half, a
C     difference and a product off by NORMAL each, the first two times
C     less than 1/RAISEB: together by far less than 1/RAISE.  So no sign
C     is wrong, however small the coordinates are; where DET is small,
C     too, the limbs decide
      IF (MAX(ABS(BI), ABS(CK), ABS(BK), ABS(CI)) .LT. 1.0D0/RAISEB)
     $    THEN
        DET = BI*CK - BK*CI
        ERR = 8.0D0*EPS*(ABS(BI*CK) + ABS(BK*CI))
        HHAREA = 1
        IF (DET .GT. ERR + 1.0D0/RAISE) RETURN
        HHAREA = -1
        IF (DET .LT. -ERR - 1.0D0/RAISE) RETURN
      END IF
      HHAREA = UNSURE
      DO 10 K = 1, 3
        Q(K,1) = A(K)
        Q(K,2) = B(K)
        Q(K,3) = C(K)
        Q(K,4) = A(K)
   10 CONTINUE
      IF (HHHOLD(3, Q) .EQ. 0) RETURN
      MOST = HHPACK(3, Q)
C     the fourth point: off the plane, on the axis's positive side, and
C     held by the same limbs
      Q(AXIS,1) = 0.0D0
      Q(AXIS,2) = 0.0D0
      Q(AXIS,3) = 0.0D0
      Q(AXIS,4) = MOST
      CALL HHEVEX(4, HHVOLU, Q, MOST, ANY, SGN)
      HHAREA = SGN
      END

C     HHCOLL - returns 1 if A, B, C are exactly collinear, or 0.
      INTEGER FUNCTION HHCOLL(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      INTEGER HHAREA, AXIS
      HHCOLL = 0
      DO 10 AXIS = 1, 3
        IF (HHAREA(AXIS, A, B, C) .NE. 0) RETURN
   10 CONTINUE
      HHCOLL = 1
      END

C     HHFOOT - exact: SET is the vertices of a triangle A, B, C that
C     carry its point nearest to Q, as the sum of 1, 2, 4 for them, or 0
C     when the limbs do not hold it; HHHOLD or HHHELD has passed all
C     four.  W, if WANT is 1: their weights, none negative, right to
C     rounding however thin the triangle is, 0 for a vertex that does
C     not carry; else W is scratch.
      SUBROUTINE HHFOOT(A, B, C, Q, WANT, W, SET)
      DOUBLE PRECISION A(3), B(3), C(3), Q(3), W(3)
      INTEGER WANT, SET
      EXTERNAL HHFT
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      DOUBLE PRECISION P(3,4)
      INTEGER FILTER, K
      DO 10 K = 1, 3
        P(K,1) = B(K)
        P(K,2) = C(K)
        P(K,3) = Q(K)
        P(K,4) = A(K)
   10 CONTINUE
      FILTER = 2
      IF (WANT .EQ. 1) FILTER = 0
      CALL HHXANS(4, HHFT, FILTER, P, W, SET)
      SET = -SET
      IF (SET .EQ. -UNSURE) SET = 0
      END

C     HHWEIG - exact: computes the barycentric weights W of Q in
C     tetrahedron T of TET, of points P, which contains it: the sum of
C     W(K) (vertex K - Q) vanishes.  Each is right to 12 EPS of itself,
C     or underflows, however thin the tetrahedron is; none is negative,
C     and W(K) is 0 where Q is in the plane of the facet opposite to
C     vertex K.  INFO is 0, or UNSURE where the limbs do not hold the
C     points, which HHHOLD or HHHELD has passed.
      SUBROUTINE HHWEIG(P, TET, T, Q, W, INFO)
      DOUBLE PRECISION P(3,*), Q(3), W(4)
      INTEGER TET(4,*), T, INFO
      EXTERNAL HHWGH
      DOUBLE PRECISION X(3,5)
      INTEGER I, K
      DO 20 K = 1, 3
        DO 10 I = 1, 4
          X(K,I) = P(K,TET(I,T))
   10   CONTINUE
        X(K,5) = Q(K)
   20 CONTINUE
      CALL HHXANS(5, HHWGH, 0, X, W, INFO)
      END

C     HHWIDE - returns the exact sign of (A-B) - (C-D), for A >= B and C
C     >= D.  Double precision errs by 2 EPS of the sum of both
C     differences.  Where it does not tell, the orientation of four
C     points does: with M the largest of the numbers in absolute value,
C         det [(M,M,D)-(0,0,A)  (M,0,B)-(0,0,A)  (0,M,C)-(0,0,A)] =
C             M**2 ((A-B) - (C-D)).
      INTEGER FUNCTION HHWIDE(A, B, C, D)
      DOUBLE PRECISION A, B, C, D
      EXTERNAL HHVOLU
      DOUBLE PRECISION EPS, DETUND
      PARAMETER (EPS = 2.0D0**(-52), DETUND = 2.0D0**(-1000))
      DOUBLE PRECISION ANY(3), ERR, M, Q(3,4), X, Y
      INTEGER I, K, SGN
      X = 0.25D0*A - 0.25D0*B
      Y = 0.25D0*C - 0.25D0*D
      ERR = 4.0D0*EPS*(X + Y) + DETUND
      IF (X - Y .GT. ERR) THEN
        SGN = 1
      ELSE IF (Y - X .GT. ERR) THEN
        SGN = -1
      ELSE
        M = MAX(ABS(A), ABS(B), ABS(C), ABS(D))
        DO 20 I = 1, 4
          DO 10 K = 1, 3
            Q(K,I) = 0.0D0
   10     CONTINUE
   20   CONTINUE
        Q(3,1) = A
        Q(3,2) = D
        Q(3,3) = B
        Q(3,4) = C
        Q(1,2) = M
        Q(2,2) = M
        Q(1,3) = M
        Q(2,4) = M
        CALL HHEVEX(4, HHVOLU, Q, M, ANY, SGN)
      END IF
      HHWIDE = SGN
      END

C     HHFITS - returns 1 if HHLIM limbs hold X beside coordinates of
C     absolute value MOST > 0, or 0.
      INTEGER FUNCTION HHFITS(X, MOST)
      DOUBLE PRECISION X, MOST
      INTEGER HHLIM
      PARAMETER (HHLIM = 88)
      DOUBLE PRECISION FACTOR, LIMB(HHLIM), M, Q(3,1), TOP, Y(1)
      INTEGER USED
      M = MOST
      Q(1,1) = X
      Q(2,1) = 0.0D0
      Q(3,1) = 0.0D0
      CALL HHTOPW(1, Q, M, FACTOR, TOP)
      Y(1) = Q(1,1)
      CALL HHSPLI(1, Y, TOP, HHLIM, LIMB, USED)
      HHFITS = 0
      IF (USED .LE. HHLIM) HHFITS = 1
      END

C     HHOWNU (needs_own_unit) - returns 1 if position I of a set (see
C     HHPORI) is too far below the set's units for these to suit it and
C     points near it, or 0.
      INTEGER FUNCTION HHOWNU(X, T3, I)
      DOUBLE PRECISION X(3,*), T3
      INTEGER I
      DOUBLE PRECISION QUICKS
      PARAMETER (QUICKS = 2.0D0**(-96))
      HHOWNU = 0
      IF (T3 .GE. -1.0D0) RETURN
      IF (ABS(X(1,I)) + ABS(X(2,I)) + ABS(X(3,I)) .LE. QUICKS) HHOWNU =
     $    1
      END

C     HHBOXC (box_corners) - YES is 2 if NP points are in one plane
C     across an axis; 1 if they are corners of one box with faces along
C     the axes, that is, if no coordinate has more than two values: Q is
C     then their image when the box becomes the unit cube, which alters
C     no orientation.  Else it is 0.
      SUBROUTINE HHBOXC(NP, P, Q, YES)
      INTEGER NP, YES
      DOUBLE PRECISION P(3,*), Q(3,*)
      DOUBLE PRECISION HIGH, LOW
      INTEGER BOX, I, K
      YES = 2
      BOX = 1
      DO 30 K = 1, 3
        HIGH = P(K,1)
        LOW = P(K,1)
        DO 10 I = 2, NP
          HIGH = MAX(HIGH, P(K,I))
          LOW = MIN(LOW, P(K,I))
   10   CONTINUE
        IF (HIGH .LE. LOW) RETURN
        DO 20 I = 1, NP
          IF (LOW .LT. P(K,I) .AND. P(K,I) .LT. HIGH) BOX = 0
          Q(K,I) = 0.0D0
          IF (LOW .LT. P(K,I)) Q(K,I) = 1.0D0
   20   CONTINUE
   30 CONTINUE
      YES = BOX
      END

C     HHXPOS (exact_by_position) - returns the exact orientation of NP =
C     4 positions V of a set (see HHPORI), or the sign of I of 5, that a
C     filter leaves undecided, or that need a unit of their own: these
C     are filtered in it.
      INTEGER FUNCTION HHXPOS(X, P, ORD, T3, NP, V)
      DOUBLE PRECISION X(3,*), P(3,*), T3
      INTEGER ORD(*), NP, V(*)
      EXTERNAL HHISPH, HHVOLU
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHOWNU, HHFILT
      DOUBLE PRECISION HHPACK
      DOUBLE PRECISION ANY(4), MOST, Q(3,5), UNIT(3,5)
      INTEGER AXIS, E, M, N, SGN, YES
      M = NP
      DO 20 N = 1, M
        DO 10 AXIS = 1, 3
          Q(AXIS,N) = P(AXIS,ORD(V(N)))
   10   CONTINUE
   20 CONTINUE
      SGN = UNSURE
      IF (HHOWNU(X, T3, V(1)) .EQ. 1) THEN
        MOST = HHPACK(M, Q)
        CALL HHSCAL(M, MOST, Q, UNIT, E)
        IF (MOST .GT. 0.0D0) SGN = HHFILT(M, UNIT, -1.0D0)
      END IF
      IF (SGN .EQ. UNSURE) THEN
        CALL HHBOXC(M, Q, UNIT, YES)
        IF (YES .GT. 0) THEN
C         no filter tells that four points are in a plane, but most such
C         planes in data are across an axis; the corners of a box are on
C         one sphere
          SGN = 0
          IF (YES .EQ. 1 .AND. M .EQ. 4) SGN = HHFILT(4, UNIT, 64.0D0)
        ELSE
          MOST = HHPACK(M, Q)
          IF (M .EQ. 4) CALL HHEVEX(4, HHVOLU, Q, MOST, ANY, SGN)
          IF (M .EQ. 5) CALL HHEVEX(5, HHISPH, Q, MOST, ANY, SGN)
        END IF
      END IF
      HHXPOS = SGN
      END

C     HHPORI - returns the exact orientation, HHORIE's, of the positions
C     I, J, K, L of a set: the points as tess keeps them (hh_set in C).
C     Position I is place I in the sorted order; duplicates are gone.
C       X       3 doubles a position: the coordinates times one power of
C               two, of absolute value at most 1.  What underflows,
C               gradually or to 0, is wrong by at most NORMAL, which
C               absolute terms of bounds cover
C       P       the caller's coordinates, which the exact arithmetic
C               takes
C       ORD     position -> number in P
C       T3      orientations whose permanent is at most this are
C               computed without rounding, as all coordinates are small
C               multiples of one power of two and none underflowed; -1:
C               that is not known; -2: besides, some coordinate is so
C               small that products of differences near it may
C               underflow; such points are scaled anew
C       T5      the same of insphere determinants, but for -2
C       SE      X = P 2**(-SE)
      INTEGER FUNCTION HHPORI(X, P, ORD, T3, I, J, K, L)
      DOUBLE PRECISION X(3,*), P(3,*), T3
      INTEGER ORD(*), I, J, K, L
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHOWNU, HHXPOS, HHFIL3, SGN, V(4)
      SGN = UNSURE
      IF (HHOWNU(X, T3, I) .EQ. 0) SGN = HHFIL3(X, I, J, K, L, T3)
      IF (SGN .EQ. UNSURE) THEN
        V(1) = I
        V(2) = J
        V(3) = K
        V(4) = L
        SGN = HHXPOS(X, P, ORD, T3, 4, V)
      END IF
      HHPORI = SGN
      END

C     ------------------------------------------------------------------
C     The tie rule (Figure 4 of the paper made precise).
C
C     Each point x has the lifted height |x|**2; that of point number i
C     is lowered by e_i, e_1 >> e_2 >> ... > 0, so that no five points
C     are on one sphere and a tetrahedralization is the one whose lifted
C     tetrahedra are the lower facets of a convex polytope.  The point
C     of least number of a cospherical set is a vertex of all the set's
C     tetrahedra, and no tetrahedron is flat.  Every decision here is of
C     the same perturbed heights, whatever facet it is asked for: that
C     is what makes them agree.
C     ------------------------------------------------------------------

C     HHBRKT (break_tie) - returns the sign, never 0, of the perturbed
C     insphere determinant of HHFIL5, called D here, for five positions
C     V of a set (see HHPORI) with D = 0: that of the cofactor of the
C     greatest e_i that has one, -(-1)**k times the determinant of the
C     other four positions in their order, for the first k, in
C     increasing order of the points' numbers, for which it is not 0.
C     It is 1 for k = 4 and -1 for k = 5 when V(4) and V(5) are known to
C     be on the positive side of V(1), V(2), V(3): then POSITV is 1,
C     else 0.
      INTEGER FUNCTION HHBRKT(X, P, ORD, T3, V, POSITV)
      DOUBLE PRECISION X(3,*), P(3,*), T3
      INTEGER ORD(*), V(5), POSITV
      INTEGER HHPORI, LOWEST, N, NUMBER(5), R, REST(4), SGN, TRIES
      DO 10 N = 1, 5
        NUMBER(N) = ORD(V(N))
   10 CONTINUE
      SGN = 0
      DO 40 TRIES = 1, 5
        LOWEST = 1
        DO 20 N = 1, 5
          IF (NUMBER(N) .GT. 0 .AND. (NUMBER(LOWEST) .EQ. 0 .OR.
     $        NUMBER(N) .LT. NUMBER(LOWEST))) LOWEST = N
   20   CONTINUE
        IF (POSITV .EQ. 1 .AND. LOWEST .GE. 4) THEN
          SGN = 9 - 2*LOWEST
          GO TO 50
        END IF
C       done with
        NUMBER(LOWEST) = 0
        R = 0
        DO 30 N = 1, 5
          IF (N .NE. LOWEST) THEN
            R = R + 1
            REST(R) = V(N)
          END IF
   30   CONTINUE
C       the determinant of the rows A-D, B-D, C-D is minus HHORIE
        SGN = HHPORI(X, P, ORD, T3, REST(1), REST(2), REST(3), REST(4))
        IF (MOD(LOWEST, 2) .EQ. 1) SGN = -SGN
        IF (SGN .NE. 0) GO TO 50
   40 CONTINUE
   50 HHBRKT = SGN
      END

C     HHPINS - returns the sign of the determinant I of HHFIL5 for the
C     positions V(1..3), A, B of a set (see HHPORI): B is inside the
C     ball of V and A iff I times HHPORI of V, A is negative.  Where I
C     is 0, by RULE:
C       0   0
C       1   the sign, never 0, of the perturbed I
C       2   TIE times that; A and B are on the positive side of V: B
C           beats A as the apex of the facet V if the result is negative
C       3   the same, and I is taken to be 0, without a test
      INTEGER FUNCTION HHPINS(X, P, ORD, T3, T5, V, A, B, RULE)
      DOUBLE PRECISION X(3,*), P(3,*), T3, T5
      INTEGER ORD(*), V(*), A, B, RULE
      INTEGER UNSURE, TIE
      PARAMETER (UNSURE = 2, TIE = 3)
      INTEGER HHOWNU, HHXPOS, HHFIL5, HHBRKT, K, SGN, W(5)
      DO 10 K = 1, 3
        W(K) = V(K)
   10 CONTINUE
      W(4) = A
      W(5) = B
      SGN = 0
      IF (RULE .NE. 3) THEN
        SGN = UNSURE
        IF (HHOWNU(X, T3, V(1)) .EQ. 0)
     $      SGN = HHFIL5(X, V(1), V(2), V(3), A, B, 0, X, T5)
        IF (SGN .EQ. UNSURE) SGN = HHXPOS(X, P, ORD, T3, 5, W)
      END IF
      IF (SGN .EQ. 0 .AND. RULE .EQ. 1) THEN
        SGN = HHBRKT(X, P, ORD, T3, W, 0)
      ELSE IF (SGN .EQ. 0 .AND. RULE .GT. 1) THEN
        SGN = TIE*HHBRKT(X, P, ORD, T3, W, 1)
      END IF
      HHPINS = SGN
      END

C     ------------------------------------------------------------------
C     Householder transformations (Section 3).
C
C     P = [P2-P1 P3-P1] = Q R, Q = Q1 Q2, Qi = I - b_i u_i u_i'; R upper
C     triangular.  A reflector is kept as b and u with the scaling of u
C     left as it comes, b = 2/u'u.
C
C     The bounds are derived, for every rounding mode, in
C     test/bounds, lemmas.txt, H1 to H7.  In short, in units of
C     EPS:
C
C     Forward error of the side.  A reflector as computed alters a
C     vector by 42 of its length at most, beside the exact one of the
C     column that it was computed from.  So Q e3 errs by 77, and the
C     exact Q and the computed R are those of a second column that is
C     off by 43 |P3-P1|: its facet's normal is turned against the true
C     one by 43 |P3-P1| / |R22| and the error of the first column, less
C     than 45 s, as s = 1 + |R12/R22| is more than |P3-P1| / |R22|, one
C     over the sine of the facet's angle at P1.  The products with W add
C     4.  So the error is at most EPS (45 s + 82) |W|; E = EPS (170 s +
C     90) has room for all roundings of what is computed with it.
C
C     Forward error of L.  C - P1 = Q y.  The circumcentre of that facet
C     is off by EPS rho (140 s + 3), as |P2-P1| and |P3-P1| are at most
C     2 rho; y by EPS rho (12 s + 3), Q by 77; as long as E <= HHEMAX
C     rho as computed is more than half of rho, and the sum is at most
C     0.64 of dc = EPS rho (700 s + 100).  In L = (W.W - 2 (C-P1).W) /
C     (2 V.W) the numerator errs by at most |W| (EPS (6 |W| + 10 rho) +
C     2 dc), the denominator by 2 E |W|; a quotient a/b with errors da,
C     db errs by at most (da + |a/b| db) / (|b| - db), here with |b| -
C     db = 2 g, which halves the numerator's terms; plus 4 EPS |L| for
C     the last roundings, of the quotient (2) and, in HHLIMI, of its sum
C     with dL.
C
C     The array H holds the reflectors, u1 and b1, u2 and b2, and R.
C
C     H, the reflectors and R of a facet, see HHHOUS:
C       LQR    = 10  -  its length
C       QRU1   = 0   u1  behind it the first reflector,
C       QRB1   = 4   b1  and its b
C       QRU2   = 4   u2  behind it the second, which acts on rows 2, 3,
C       QRB2   = 7   b2  and its b
C       QRR11  = 8   r11  of R
C       QRR12  = 9   r12  of R
C       QRR22  = 10  r22  of R
C     ------------------------------------------------------------------

C     HHHOUS (householder) - computes the reflectors and R of [A B].  A
C     zero column leaves zeros.
      SUBROUTINE HHHOUS(A, B, H)
      INTEGER LQR
      PARAMETER (LQR = 10)
      DOUBLE PRECISION A(3), B(3), H(LQR)
      INTEGER QRU1, QRB1, QRU2, QRB2, QRR11, QRR12, QRR22
      DOUBLE PRECISION NORMAL
      PARAMETER (QRU1 = 0, QRB1 = 4, QRU2 = 4, QRB2 = 7, QRR11 = 8,
     $    QRR12 = 9, QRR22 = 10, NORMAL = 2.0D0**(-1022))
      DOUBLE PRECISION NORM, Q1, Q2, T
      NORM = SQRT(A(1)*A(1) + A(2)*A(2) + A(3)*A(3))
      H(QRR11) = NORM
      IF (A(1) .GT. 0.0D0) H(QRR11) = -NORM
      H(QRU1+1) = A(1) - H(QRR11)
      H(QRU1+2) = A(2)
      H(QRU1+3) = A(3)
      T = NORM*(NORM + ABS(A(1)))
      H(QRB1) = 0.0D0
      IF (T .GT. NORMAL) H(QRB1) = 1.0D0/T

      T = H(QRB1)*(H(QRU1+1)*B(1) + H(QRU1+2)*B(2) + H(QRU1+3)*B(3))
      H(QRR12) = B(1) - T*H(QRU1+1)
      Q1 = B(2) - T*H(QRU1+2)
      Q2 = B(3) - T*H(QRU1+3)
      NORM = SQRT(Q1*Q1 + Q2*Q2)
      H(QRR22) = NORM
      IF (Q1 .GT. 0.0D0) H(QRR22) = -NORM
      H(QRU2+1) = Q1 - H(QRR22)
      H(QRU2+2) = Q2
      T = NORM*(NORM + ABS(Q1))
      H(QRB2) = 0.0D0
      IF (T .GT. NORMAL) H(QRB2) = 1.0D0/T
      END

C     HHAPPQ (apply_q) - sets Z to Q1 Q2 (Y1, Y2, Y3).
      SUBROUTINE HHAPPQ(H, Y1, Y2, Y3, Z)
      INTEGER LQR
      PARAMETER (LQR = 10)
      DOUBLE PRECISION H(LQR), Y1, Y2, Y3, Z(3)
      INTEGER QRU1, QRB1, QRU2, QRB2
      PARAMETER (QRU1 = 0, QRB1 = 4, QRU2 = 4, QRB2 = 7)
      DOUBLE PRECISION T, T2, T3
      T = H(QRB2)*(H(QRU2+1)*Y2 + H(QRU2+2)*Y3)
      T2 = Y2 - T*H(QRU2+1)
      T3 = Y3 - T*H(QRU2+2)
      T = H(QRB1)*(H(QRU1+1)*Y1 + H(QRU1+2)*T2 + H(QRU1+3)*T3)
      Z(1) = Y1 - T*H(QRU1+1)
      Z(2) = T2 - T*H(QRU1+2)
      Z(3) = T3 - T*H(QRU1+3)
      END

C     HHSETU - does what HHFACE does for points of absolute value at
C     most 1, without the test for collinear points; F as there, but E
C     and dc are HUGE and the rest is finite when the facet is too thin
C     or too small for the bounds to hold.  s is bounded by 1 +
C     |R12/R22|.
      SUBROUTINE HHSETU(P1, P2, P3, F)
      INTEGER LF, LQR
      PARAMETER (LF = 12, LQR = 10)
      DOUBLE PRECISION P1(3), P2(3), P3(3), F(LF)
      INTEGER FNORM, FCEN, FBASE, FE, FDC, FRHO, QRR11, QRR12, QRR22
      DOUBLE PRECISION EPS, HUGE, LENMIN
      PARAMETER (FNORM = 0, FCEN = 3, FBASE = 6, FE = 10, FDC = 11,
     $    FRHO = 12, QRR11 = 8, QRR12 = 9, QRR22 = 10,
     $    EPS = 2.0D0**(-52), HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023,
     $    LENMIN = 2.0D0**(-450))
      DOUBLE PRECISION A(3), B(3), C(3), H(LQR), RATIO, SENSE, V(3),
     $    Y1, Y2
      INTEGER K, L
      DO 10 K = 1, 3
        A(K) = P2(K) - P1(K)
        B(K) = P3(K) - P1(K)
        F(FBASE+K) = P1(K)
   10 CONTINUE
      CALL HHHOUS(A, B, H)
C     det [P2-P1 P3-P1 V] = R11 R22 det Q, det Q = 1
      K = 1
      IF (H(QRR11) .LT. 0.0D0) K = 2
      L = 1
      IF (H(QRR22) .LT. 0.0D0) L = 2
      SENSE = DBLE(1 - 2*ABS(K - L))
      CALL HHAPPQ(H, 0.0D0, 0.0D0, SENSE, V)
      IF (ABS(H(QRR11)) .GT. LENMIN .AND. ABS(H(QRR22)) .GT. LENMIN)
     $    THEN
        RATIO = H(QRR12)/H(QRR22)
        Y1 = 0.5D0*H(QRR11)
        Y2 = 0.5D0*(H(QRR22) + RATIO*(H(QRR12) - H(QRR11)))
        CALL HHAPPQ(H, Y1, Y2, 0.0D0, C)
        F(FRHO) = SQRT(Y1*Y1 + Y2*Y2)
        RATIO = 1.0D0 + ABS(RATIO)
        F(FE) = EPS*(170.0D0*RATIO + 90.0D0)
        F(FDC) = EPS*F(FRHO)*(700.0D0*RATIO + 100.0D0)
      ELSE
        C(1) = 0.0D0
        C(2) = 0.0D0
        C(3) = 0.0D0
        F(FE) = HUGE
        F(FDC) = HUGE
        F(FRHO) = 0.0D0
      END IF
      DO 20 K = 1, 3
        F(FNORM+K) = V(K)
        F(FCEN+K) = C(K)
   20 CONTINUE
      END

C     HHRATI - computes limits of the L-coordinate of Z, whose side is
C     between LEAST >= 0 and MOST.  LO and HI are left as they are where
C     there is no limit.
C
C     L is a quotient of the power N = W.W - 2 (C-P1).W and twice the
C     side.  With p_k = w_k (w_k - 2 c_k), the error of w_k counts for
C     EPS (2 w_k**2 + 2 |c_k w_k|), the four roundings of p_k and of the
C     sum for 4 EPS (w_k**2 + 2 |c_k w_k|) in any rounding mode and
C     order, that of c for 2 |W| dc: together less than SIZE (EPS (8
C     SIZE + 12 rho) + 2 dc), SIZE >= LENMIN, where underflow does less
C     than that.  The last roundings, of a difference and a quotient,
C     are the caller's: LEAST and MOST have room for 4 EPS of
C     themselves.
      SUBROUTINE HHRATI(F, Z, LEAST, MOST, LO, HI)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION F(LF), Z(3), LEAST, MOST, LO, HI
      INTEGER FCEN, FBASE, FDC, FRHO
      DOUBLE PRECISION EPS
      PARAMETER (FCEN = 3, FBASE = 6, FDC = 11, FRHO = 12,
     $    EPS = 2.0D0**(-52))
      DOUBLE PRECISION ERR, POWER, SIZE, W1, W2, W3
      W1 = Z(1) - F(FBASE+1)
      W2 = Z(2) - F(FBASE+2)
      W3 = Z(3) - F(FBASE+3)
      SIZE = ABS(W1) + ABS(W2) + ABS(W3)
      POWER = W1*(W1 - 2.0D0*F(FCEN+1)) + W2*(W2 - 2.0D0*F(FCEN+2)) +
     $        W3*(W3 - 2.0D0*F(FCEN+3))
      ERR = SIZE*(EPS*(8.0D0*SIZE + 12.0D0*F(FRHO)) + 2.0D0*F(FDC))
      IF (POWER .GT. ERR) THEN
        LO = (POWER - ERR)/(2.0D0*MOST)
      ELSE IF (LEAST .GT. 0.0D0) THEN
        LO = (POWER - ERR)/(2.0D0*LEAST)
      END IF
      IF (POWER .LT. -ERR) THEN
        HI = (POWER + ERR)/(2.0D0*MOST)
      ELSE IF (LEAST .GT. 0.0D0) THEN
        HI = (POWER + ERR)/(2.0D0*LEAST)
      END IF
      END

C     HHLIMI - finds the SIDE of Z, and limits of its L-coordinate:
C     -HUGE, HUGE where there are none.  SIDE is 1 if Z is certainly on
C     the positive side and not too near the plane; -1 if it is
C     certainly on the negative side; 0 if neither is certain: then the
C     limits hold if Z is on the positive side.
C
C     |W|_1 stands for |W| in the bounds: it does not underflow.  A side
C     VW of more than twice its error leaves a gap of at least half of
C     it, which spares a division.  An uncertain side is at most VW +
C     ERR, if positive at all: a power that is certainly not 0 then
C     limits L on the side of 0.  VW + 2 ERR in its place leaves room
C     for the last roundings: ERR is at least 260 EPS SIZE, and |VW| at
C     most SIZE.
      SUBROUTINE HHLIMI(F, Z, LO, HI, SIDE)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION F(LF), Z(3), LO, HI
      INTEGER SIDE
      INTEGER FNORM, FCEN, FBASE, FE, FDC, FRHO
      DOUBLE PRECISION EPS, HUGE, HHEMAX, LENMIN
      PARAMETER (FNORM = 0, FCEN = 3, FBASE = 6, FE = 10, FDC = 11,
     $    FRHO = 12, EPS = 2.0D0**(-52),
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023, HHEMAX = 0.5D0,
     $    LENMIN = 2.0D0**(-450))
      DOUBLE PRECISION DL, ERR, HALF, L, SIZE, VW, W1, W2, W3
      W1 = Z(1) - F(FBASE+1)
      W2 = Z(2) - F(FBASE+2)
      W3 = Z(3) - F(FBASE+3)
      SIZE = ABS(W1) + ABS(W2) + ABS(W3)
      VW = F(FNORM+1)*W1 + F(FNORM+2)*W2 + F(FNORM+3)*W3
      SIDE = 0
      LO = -HUGE
      HI = HUGE
      IF (SIZE .LT. LENMIN .OR. F(FE) .GT. HHEMAX) RETURN
      ERR = F(FE)*SIZE
      IF (VW .GT. 2.0D0*ERR .AND. VW .GT. LENMIN) THEN
        HALF = 0.5D0/VW
        L = (W1*(W1 - 2.0D0*F(FCEN+1)) + W2*(W2 - 2.0D0*F(FCEN+2)) +
     $       W3*(W3 - 2.0D0*F(FCEN+3)))*HALF
        DL = SIZE*(EPS*(3.0D0*SIZE + 5.0D0*F(FRHO)) + F(FDC) +
     $             ABS(L)*F(FE))*(4.0D0*HALF) + 4.0D0*EPS*ABS(L)
        LO = L - DL
        HI = L + DL
        SIDE = 1
      ELSE IF (-VW .GT. ERR) THEN
        SIDE = -1
      ELSE
        CALL HHRATI(F, Z, 0.0D0, VW + 2.0D0*ERR, LO, HI)
      END IF
      END

C     HHFACE - Householder set-up of the facet P1, P2, P3 (Section 3.1,
C     3.2).
C
C       P1, P2, P3  (in)   the vertices
C       F           (out)  12 doubles:
C           F(1..3)   V, the unit normal, turned so that
C                     det [P2-P1 P3-P1 V] > 0
C           F(4..6)   C - P1, C the circumcentre of the facet
C           F(7..9)   P1
C           F(10)     E:   the side of Z is certain if |V.W| > E |W|,
C                     W = Z - P1
C           F(11)     dc:  bound of the error of C - P1
C           F(12)     rho: |C - P1|
C       INFO        (out)  0, or 1 when the points are exactly
C                          collinear or not all finite: then V, C - P1
C                          and rho are zero, and E and dc are HUGE, the
C                          largest number, so that nothing is certain.
C
C     With g = |V.W| - E |W|, L the L-coordinate and rho, dc as above,
C     the computed L is wrong by at most
C         dL = |W| (EPS (3 |W| + 5 rho) + dc + |L| E) / g + 4 EPS |L|,
C     EPS = 2**(-52); derived in hhpred.f.  These bounds hold as long as
C     E <= 1/2, and |W| and the facet's edges stay between about
C     2**(-450) and 2**450; a circumcentre beyond HUGE is infinite.
      SUBROUTINE HHFACE(P1, P2, P3, F, INFO)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION P1(3), P2(3), P3(3), F(LF)
      INTEGER INFO
      INTEGER FNORM, FCEN, FBASE, FE, FDC, FRHO
      DOUBLE PRECISION HUGE, HHEMAX
      PARAMETER (FNORM = 0, FCEN = 3, FBASE = 6, FE = 10, FDC = 11,
     $    FRHO = 12, HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023,
     $    HHEMAX = 0.5D0)
      DOUBLE PRECISION HHLDEX, HHPACK, MOST, P(3,3), Q1(3), Q2(3),
     $    Q3(3), S(3,3)
      INTEGER HHCOLL, HHFINI, E, K
      DO 10 K = 1, 3
        P(K,1) = P1(K)
        P(K,2) = P2(K)
        P(K,3) = P3(K)
   10 CONTINUE
      IF (HHFINI(3, P) .EQ. 3) THEN
        MOST = HHPACK(3, P)
        CALL HHSCAL(3, MOST, P, S, E)
        DO 20 K = 1, 3
          Q1(K) = S(K,1)
          Q2(K) = S(K,2)
          Q3(K) = S(K,3)
   20   CONTINUE
        CALL HHSETU(Q1, Q2, Q3, F)
        DO 30 K = 1, 3
          F(FBASE+K) = P1(K)
   30   CONTINUE
        INFO = 0
        IF (F(FE) .GT. HHEMAX) INFO = HHCOLL(P1, P2, P3)
        IF (INFO .EQ. 0) THEN
          DO 40 K = 1, 3
            F(FCEN+K) = HHLDEX(F(FCEN+K), E)
   40     CONTINUE
          F(FRHO) = HHLDEX(F(FRHO), E)
          IF (F(FDC) .LT. HUGE) F(FDC) = HHLDEX(F(FDC), E)
          RETURN
        END IF
      END IF
      INFO = 1
      DO 50 K = 1, 3
        F(FNORM+K) = 0.0D0
        F(FCEN+K) = 0.0D0
        F(FBASE+K) = P1(K)
   50 CONTINUE
      F(FE) = HUGE
      F(FDC) = HUGE
      F(FRHO) = 0.0D0
      END

C     HHSIDE - the signed distance (Z - P1).V of Z from the facet's
C     plane: positive where P1, P2, P3 are seen counter-clockwise
C     (Section 3.1).
      DOUBLE PRECISION FUNCTION HHSIDE(F, Z)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION F(LF), Z(3)
      INTEGER FNORM, FBASE
      PARAMETER (FNORM = 0, FBASE = 6)
      HHSIDE = F(FNORM+1)*(Z(1) - F(FBASE+1)) + F(FNORM+2)*
     $         (Z(2) - F(FBASE+2)) + F(FNORM+3)*(Z(3) - F(FBASE+3))
      END

C     HHOPP - the paper's opp test (Section 3.1): 1 when Z1 and Z2 are
C     on the same side of the facet's plane, by the computed signs, else
C     0 (0 too when one of them is computed to lie in the plane).
      INTEGER FUNCTION HHOPP(F, Z1, Z2)
      DOUBLE PRECISION F(*), Z1(3), Z2(3)
      DOUBLE PRECISION HHSIDE, SIDE1, SIDE2
      SIDE1 = HHSIDE(F, Z1)
      SIDE2 = HHSIDE(F, Z2)
      HHOPP = 0
      IF (SIDE1 .GT. 0.0D0 .AND. SIDE2 .GT. 0.0D0) HHOPP = 1
      IF (SIDE1 .LT. 0.0D0 .AND. SIDE2 .LT. 0.0D0) HHOPP = 1
      END

C     HHLCOO - the L-coordinate of Z (Section 3.2): the centre of the
C     sphere through P1, P2, P3, Z is C + L V.  For Z computed to lie in
C     the plane: HUGE when it is outside the facet's circle or on it,
C     else -HUGE.
      DOUBLE PRECISION FUNCTION HHLCOO(F, Z)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION F(LF), Z(3)
      INTEGER FNORM, FCEN, FBASE
      DOUBLE PRECISION HUGE
      PARAMETER (FNORM = 0, FCEN = 3, FBASE = 6,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      DOUBLE PRECISION POWER, SIDE, W1, W2, W3
      W1 = Z(1) - F(FBASE+1)
      W2 = Z(2) - F(FBASE+2)
      W3 = Z(3) - F(FBASE+3)
      SIDE = F(FNORM+1)*W1 + F(FNORM+2)*W2 + F(FNORM+3)*W3
      POWER = W1*(W1 - 2.0D0*F(FCEN+1)) + W2*(W2 - 2.0D0*F(FCEN+2)) +
     $        W3*(W3 - 2.0D0*F(FCEN+3))
      IF (ABS(SIDE) .LE. 0.0D0) THEN
        HHLCOO = -HUGE
        IF (POWER .GE. 0.0D0) HHLCOO = HUGE
      ELSE
        HHLCOO = POWER/(2.0D0*SIDE)
      END IF
      END

C     HHWRAP - the gift-wrapping primitive about the edge P1 P2 of the
C     facet P1, P2, P3 (Section 3): C = -(W.G) / (W.V), W = Z - P1, V
C     the facet's unit normal, G the unit normal of the edge in the
C     facet's plane, towards P3.  Of points on the positive side, the
C     one of least C is wrapped first.
C
C     INFO is 0; 1 when P1, P2, P3 are exactly collinear or not all
C     finite; 2 when Z is computed to lie in the plane, or so near to it
C     that C would overflow, or is not finite; C is then 0.
      SUBROUTINE HHWRAP(P1, P2, P3, Z, C, INFO)
      INTEGER LQR
      PARAMETER (LQR = 10)
      DOUBLE PRECISION P1(3), P2(3), P3(3), Z(3), C
      INTEGER INFO
      INTEGER QRR11, QRR22
      DOUBLE PRECISION HUGE
      PARAMETER (QRR11 = 8, QRR22 = 10,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      DOUBLE PRECISION HHPACK, A(3), B(3), G(3), H(LQR), MOST, P(3,4),
     $    S(3,4), SENSE, V(3), WG, WV
      INTEGER HHCOLL, HHFINI, E, K
      C = 0.0D0
      DO 10 K = 1, 3
        P(K,1) = P1(K)
        P(K,2) = P2(K)
        P(K,3) = P3(K)
        P(K,4) = Z(K)
   10 CONTINUE
      INFO = 1
      IF (HHFINI(3, P) .LT. 3) RETURN
      IF (HHCOLL(P1, P2, P3) .EQ. 1) RETURN
      INFO = 2
      IF (HHFINI(1, Z) .EQ. 0) RETURN
      MOST = HHPACK(4, P)
      CALL HHSCAL(4, MOST, P, S, E)
      DO 20 K = 1, 3
        A(K) = S(K,2) - S(K,1)
        B(K) = S(K,3) - S(K,1)
   20 CONTINUE
      CALL HHHOUS(A, B, H)
C     P3 - P1 has the component R22 along Q e2
      SENSE = 1.0D0
      IF (H(QRR22) .LT. 0.0D0) SENSE = -1.0D0
      CALL HHAPPQ(H, 0.0D0, SENSE, 0.0D0, G)
      IF (H(QRR11) .LT. 0.0D0) SENSE = -SENSE
      CALL HHAPPQ(H, 0.0D0, 0.0D0, SENSE, V)
      WG = 0.0D0
      WV = 0.0D0
      DO 30 K = 1, 3
        WG = WG + (S(K,4) - S(K,1))*G(K)
        WV = WV + (S(K,4) - S(K,1))*V(K)
   30 CONTINUE
C     (as |WV| <= 7 this does not overflow, and then C does not)
      IF (0.0625D0*HUGE*ABS(WV) .LE. ABS(WG)) RETURN
      C = (-WG)/WV
      INFO = 0
      END

C     ------------------------------------------------------------------
C     Balls by limbs.
C
C     A ball, a sphere or a plane is set up once.  What a point is to it
C     then takes a few limbs of the point, and a fraction of the time of
C     the exact signs; the result is exact or has a bound, or is UNSURE.
C
C     T, a facet and the ball through it and a fourth point, by limbs:
C     for a point Z, u = Z - base, the side is N.u and the power D
C     |u|**2 - C.u:
C       LBALL  = 85  -  its length
C       BN     = 1   n  the number of limbs of u
C       BFIRST = 2   first_limb  the limbs of u before this one are 0
C               for the facet and the fourth point
C       BTOP   = 3   top  the weight of limb 1 of coordinates times
C               T(BFACT)
C       BFACT  = 4   factor  what coordinates are multiplied by: RAISE
C               or 1
C       BMAXAB = 5   max_abs  the largest coordinate that the limbs hold
C       BBASE  = 5   base  behind it the limbs of the base, three
C               coordinates side by side
C       BPOWER = 35  power  behind it the leading rows of C and D
C       BSIDE  = 59  side  behind it those of N; each fourth element is
C               not used
C       BE     = 84  e  limb 1 weighs 2**T(BE) in scaled coordinates
C       BSIDEF = 85  side_first  the row of N that they begin with
C     S, a sphere or a plane by limbs, and what HHRELA keeps, 52
C     doubles:
C       SREADY = 1   ready  of HHRELA: 1: it is set up; 0: not yet; -1:
C               it cannot be had
C       SPOWER = 3   power  of HHRELA: behind it the powers of the
C               facet's two other vertices, and of the positions
C       SPBEST = 2   power_best  S(SPBEST) and
C       SPLAST = 3   power_last  S(SPLAST), or 0 for none
C       SPLANE = 8   plane  1: it is a plane
C       SN     = 9   n  the number of limbs in use
C       SE     = 10  e  2**S(SE) is the weight of limb 1
C       SBASE  = 10  base  behind it the limbs of a point on it
C       STWICE = 31  twice_centre  behind it the limbs of twice the
C               centre, seen from there; of a plane, of minus the normal
C     Constants:
C       CENEXP = 300 CENTRE_EXP_MAX  the exponent of a centre that is
C               too far for squares
C       BLIMBS = 10  HH_BALL_LIMBS  how many limbs balls and thin facets
C               have, at most 10; what needs more is not made.
C               Correctness rests on the 10: see HHVALB
C       BROWS  = 6   HH_BALL_ROWS  how many leading rows of a ball's
C               numbers are kept: 5 rows decide a third of the signs on
C               a rotated grid, 6 decide 98 %, 7 decide 99 %
C       SPHLIM = 3   HH_SPHERE_LIMBS  how many limbs a point has for
C               HHRELA: the first is that of a coordinate of 1, so they
C               hold all that are above 2**(-17)
C       HGTLIM = 7   HH_HEIGHT_LIMBS  how many limbs a point has for
C               HHHEIG: at the pole of a unit sphere sin(pi) cos(pi/2)
C               takes them all
C       TOP    = 4.0D0/2.0D0**24 -  of HHSPHF
C     ------------------------------------------------------------------

C     HHROWS (rows_of_ball) - computes the limbs X of the rows p - last
C     of 4 positions V of a set (see HHPORI), as HHSPDI leaves them.
C     Sets BTOP, BFACT, BE and BN of T.  OK is 0 if BLIMBS limbs do not
C     hold them, else 1.  Twice the largest coordinate fits, too.
      SUBROUTINE HHROWS(P, ORD, SE, V, X, T, OK)
      DOUBLE PRECISION P(3,*), X(*), T(*)
      INTEGER ORD(*), SE, V(4), OK
      INTEGER BN, BTOP, BFACT, BE, BITS, RAISEL, BLIMBS
      PARAMETER (BN = 1, BTOP = 3, BFACT = 4, BE = 84, BITS = 24,
     $    RAISEL = 25, BLIMBS = 10)
      DOUBLE PRECISION HHPACK, FACTOR, MOST, Q(3,4), TOP
      INTEGER HHFREX, E, I, K, N, USED
      DO 20 I = 1, 4
        DO 10 K = 1, 3
          Q(K,I) = P(K,ORD(V(I)))
   10   CONTINUE
   20 CONTINUE
      MOST = HHPACK(4, Q)
      CALL HHTOPW(4, Q, MOST, FACTOR, TOP)
      TOP = 2.0D0*TOP
      E = HHFREX(TOP) - 1 - SE
      IF (FACTOR .GT. 1.0D0) E = E - RAISEL*BITS
      N = 3
      CALL HHSPDI(4, Q, TOP, 3, X, USED)
      IF (USED .GT. 3) CALL HHSPDI(4, Q, TOP, BLIMBS, X, N)
      T(BTOP) = TOP
      T(BFACT) = FACTOR
      T(BE) = DBLE(E)
      T(BN) = DBLE(N)
      OK = 0
      IF (N .LE. BLIMBS) OK = 1
      END

C     HHCNTR (centre_by_limbs) - computes the centre of the ball of four
C     points of N limbs, seen from the last one: of the rows A, B, W of
C     X, without the common limb weights,
C         C = |A|**2 (B x W) + |B|**2 (W x A) + |W|**2 (A x B)
C     over twice D = W.(A x B).  C and D are 4 numbers of 4N limbs, in
C     C; MINOR begins with A x B, of 2N limbs, 4 doubles apart, of 8N.
C     (The three products of C need no carry between them: at most 10
C     rows of each are not carried, of one product of carried limbs.)
      SUBROUTINE HHCNTR(N, X, C, MINOR)
      INTEGER N
      DOUBLE PRECISION X(*), C(*), MINOR(*)
      INTEGER DOT, CROSS, SCALED
      PARAMETER (DOT = 1, CROSS = 3, SCALED = 4)
      INTEGER K
      CALL HHZERO(16*N, C)
      DO 10 K = 0, 2
        CALL HHZERO(8*N, MINOR)
        CALL HHPROD(CROSS, N, 12, X(3*MOD(K+1,3)+1), N, 12,
     $              X(3*MOD(K+2,3)+1), 2*N, 4, MINOR)
        CALL HHPROD(DOT, N, 12, X(3*K+1), N, 12, X(3*K+1), 2*N, 4,
     $              MINOR(4))
        CALL HHCARR(2*N, 4, 4, MINOR)
        CALL HHPROD(SCALED, 2*N, 4, MINOR, 2*N, 4, MINOR(4), 4*N, 4, C)
   10 CONTINUE
      CALL HHPROD(DOT, N, 12, X(7), 2*N, 4, MINOR, 3*N, 4, C(4))
      CALL HHCARR(4*N, 4, 4, C)
      END

C     HHLROW (leading_rows) - copies the BROWS leading rows of 4 numbers
C     C of M limbs, side by side, from the first limb on that is not 0
C     in all of the first WIDE numbers, to ROW, behind AT.  FIRST is
C     that limb.
      SUBROUTINE HHLROW(M, WIDE, C, ROW, AT, FIRST)
      INTEGER M, WIDE, AT, FIRST
      DOUBLE PRECISION C(*), ROW(*)
      INTEGER BROWS
      PARAMETER (BROWS = 6)
      INTEGER HHFROW, I, K
      FIRST = HHFROW(M, WIDE, 4, C)
      DO 10 K = 1, 4*BROWS
        I = 4*FIRST - 4 + K
        ROW(AT+K) = 0.0D0
        IF (I .LE. 4*M) ROW(AT+K) = C(I)
   10 CONTINUE
      END

C     HHCENT - computes the centre C, relative to the position V(BASE)
C     and scaled as X is, of the ball of the positions V(1..3) and Z of
C     a set (see HHPORI): wrong by at most 8 EPS |C|, as C and D (see
C     HHCNTR) are exact and their values err by 2.1 EPS, the division by
C     2.  OK is 0 where that is not to be had: the four in one plane,
C     too many limbs, or a centre that is too near or too far for
C     squares.  Else it is 1, and T is made ready for HHTRIA.  With Z =
C     V(BASE) only its facet is, and C is left alone.
      SUBROUTINE HHCENT(P, ORD, SE, V, BASE, Z, C, T, OK)
      DOUBLE PRECISION P(3,*), C(*), T(*)
      INTEGER ORD(*), SE, V(3), BASE, Z, OK
      INTEGER BN, BFIRST, BTOP, BFACT, BMAXAB, BBASE, BPOWER, BSIDE, BE,
     $    BSIDEF, BITS, CENEXP, BLIMBS
      DOUBLE PRECISION HUGE, RADIX, LENMIN
      PARAMETER (BN = 1, BFIRST = 2, BTOP = 3, BFACT = 4, BMAXAB = 5,
     $    BBASE = 5, BPOWER = 35, BSIDE = 59, BE = 84, BSIDEF = 85,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023, BITS = 24,
     $    RADIX = 2.0D0**24, LENMIN = 2.0D0**(-450), CENEXP = 300,
     $    BLIMBS = 10)
      DOUBLE PRECISION HHLDEX, CC(16*BLIMBS), MINOR(8*BLIMBS), VALUE,
     $    X(12*BLIMBS)
      INTEGER HHFROW, DAT, I, K, LAT, N, W(4)
      OK = 0
      W(1) = V(MOD(BASE,3)+1)
      W(2) = V(MOD(BASE+1,3)+1)
      W(3) = Z
      W(4) = V(BASE)
      CALL HHROWS(P, ORD, SE, W, X, T, I)
      IF (I .EQ. 0) RETURN
      N = INT(T(BN))
      T(BFIRST) = DBLE(HHFROW(N - 1, 9, 12, X))
      CALL HHCNTR(N, X, CC, MINOR)
C     multiply first: BTOP/BFACT alone may underflow, and be rounded up
C     from 0; the result, about the largest coordinate, does not
      T(BMAXAB) = HUGE
      IF (T(BTOP) .LT. HUGE/RADIX)
     $    T(BMAXAB) = T(BTOP)*(RADIX/4.0D0)/T(BFACT)
      DO 20 I = 1, N
        DO 10 K = 1, 3
          T(BBASE+3*(I-1)+K) = X(12*(I-1)+9+K)
   10   CONTINUE
   20 CONTINUE
      CALL HHLROW(2*N, 3, MINOR, T, BSIDE, LAT)
      T(BSIDEF) = DBLE(LAT)
      OK = 1
      IF (Z .EQ. V(BASE)) RETURN
      OK = 0
      CALL HHLROW(4*N, 4, CC, T, BPOWER, LAT)
      CALL HHLEAD(4*N, CC, 4, 4, VALUE, DAT)
      IF (ABS(VALUE) .LE. 0.0D0) RETURN
      DO 30 K = 1, 3
        CALL HHLEAD(4*N, CC, K, 4, C(K), LAT)
        C(K) = C(K)/(2.0D0*VALUE)
        IF (ABS(C(K)) .GT. 0.0D0) THEN
          LAT = INT(T(BE)) + (DAT + 1 - LAT)*BITS
          IF (LAT .GT. CENEXP) RETURN
          C(K) = HHLDEX(C(K), MAX(LAT, -2000))
        END IF
   30 CONTINUE
      IF (ABS(C(1)) + ABS(C(2)) + ABS(C(3)) .GT. LENMIN) OK = 1
      END

C     HHVALB (value_in_ball) - computes SUM, the leading limbs of the
C     height of the position Z above the plane of a ball's facet, if
C     PLANE is 1, else of its power in the ball, with u and |u|**2 in Y
C     as COFACT takes them.  OK is 0 if the ball's limbs do not hold
C     them, else 1.
C
C     What is lost are products of limbs that weigh less than the last
C     row of the sum: in the row behind it 3N products of at most
C     (BASE/2 + 1) BASE and 2N of (BASE/2 + 1)**2, with all that follow
C     less than CARRY units of the last row, for N <= 10.
      SUBROUTINE HHVALB(P, ORD, T, Z, PLANE, SUM, OK)
      DOUBLE PRECISION P(3,*), T(*), SUM(*)
      INTEGER ORD(*), Z, PLANE, OK
      INTEGER BN, BFIRST, BTOP, BFACT, BMAXAB, BBASE, BPOWER, BSIDE,
     $    DOT, COFACT, BLIMBS, BROWS
      PARAMETER (BN = 1, BFIRST = 2, BTOP = 3, BFACT = 4, BMAXAB = 5,
     $    BBASE = 5, BPOWER = 35, BSIDE = 59, DOT = 1, COFACT = 2,
     $    BLIMBS = 10, BROWS = 6)
      DOUBLE PRECISION Q(3), U(3*BLIMBS), Y(8*BLIMBS)
      INTEGER FIRST, I, N
      N = INT(T(BN))
      FIRST = INT(T(BFIRST))
      OK = 0
      DO 10 I = 1, 3
        Q(I) = P(I,ORD(Z))
        IF (ABS(Q(I)) .GT. T(BMAXAB)) RETURN
        Q(I) = Q(I)*T(BFACT)
   10 CONTINUE
      CALL HHSPLI(3, Q, T(BTOP), N, U, I)
      IF (I .GT. N) RETURN
      DO 20 I = 1, 3*N
        U(I) = U(I) - T(BBASE+I)
        IF (I .LT. 3*FIRST - 2 .AND. ABS(U(I)) .GT. 0.0D0) RETURN
   20 CONTINUE
      OK = 1
      CALL HHZERO(BROWS + 1, SUM)
      IF (PLANE .EQ. 1) THEN
        CALL HHPROD(DOT, BROWS, 4, T(BSIDE+1), N - FIRST + 1, 3,
     $              U(3*FIRST-2), BROWS + 1, 1, SUM)
      ELSE
        CALL HHZERO(8*N, Y)
        CALL HHPROD(DOT, N, 3, U, N, 3, U, 2*N, 4, Y(3))
        CALL HHCARR(2*N, 1, 4, Y(3))
        DO 30 I = 1, N
          Y(4*I-3) = -U(3*I-1)
          Y(4*I-2) = U(3*I-2)
          Y(4*I) = U(3*I)
   30   CONTINUE
        CALL HHPROD(COFACT, BROWS, 4, T(BPOWER+1), 2*N - FIRST + 1, 4,
     $              Y(4*FIRST-3), BROWS + 1, 1, SUM)
      END IF
      END

C     HHTRIA - decides by a few leading limbs, in a tenth of the time of
C     the exact signs, where these suffice.  Sets POWER to the sign of
C     the power of the position Z in the ball T of HHCENT (-1: inside;
C     the ball's fourth point must be on the positive side, as D > 0
C     then), and, unless Z is outside, SIDE to the side of Z for the
C     facet.  Only what is UNSURE is set.
      SUBROUTINE HHTRIA(P, ORD, T, Z, SIDE, POWER)
      DOUBLE PRECISION P(3,*), T(*)
      INTEGER ORD(*), Z, SIDE, POWER
      INTEGER UNSURE, BROWS
      DOUBLE PRECISION CARRY
      PARAMETER (UNSURE = 2, CARRY = 2.0D0**29, BROWS = 6)
      DOUBLE PRECISION SUM(BROWS+1)
      INTEGER HHSIGN, OK
      IF (POWER .EQ. UNSURE) THEN
        CALL HHVALB(P, ORD, T, Z, 0, SUM, OK)
        IF (OK .EQ. 1) POWER = HHSIGN(BROWS + 1, CARRY, SUM)
      END IF
      IF (SIDE .EQ. UNSURE .AND. POWER .NE. 1) THEN
        CALL HHVALB(P, ORD, T, Z, 1, SUM, OK)
        IF (OK .EQ. 1) SIDE = HHSIGN(BROWS + 1, CARRY, SUM)
      END IF
      END

C     HHSURF - sets S to the sphere of centre C, seen from the position
C     FROM of a set (see HHPORI), or, if PLANE is 1, to the plane of
C     normal C: through the position BASE.  OK is 0 if the centre is
C     farther than RADIX / 4, or limbs do not hold it; else it is 1.
      SUBROUTINE HHSURF(X, BASE, FROM, PLANE, C, S, OK)
      DOUBLE PRECISION X(3,*), C(*), S(*)
      INTEGER BASE, FROM, PLANE, OK
      INTEGER SPLANE, SN, SE, SBASE, STWICE, BITS, HGTLIM
      DOUBLE PRECISION RADIX
      PARAMETER (SPLANE = 8, SN = 9, SE = 10, SBASE = 10, STWICE = 31,
     $    BITS = 24, RADIX = 2.0D0**24, HGTLIM = 7)
      DOUBLE PRECISION HHLDEX, Q(9), Y(9*HGTLIM)
      INTEGER E, I, K, N
      E = 2 - BITS
      DO 20 K = 1, 3
        Q(K) = X(K,BASE)
        Q(3+K) = C(K)
        Q(6+K) = X(K,FROM)
   10   IF (HHLDEX(ABS(C(K)), -E) .GT. RADIX/4.0D0) THEN
          E = E + 1
          GO TO 10
        END IF
   20 CONTINUE
      CALL HHSPLI(9, Q, HHLDEX(1.0D0, E), HGTLIM, Y, N)
      DO 30 I = 1, 3*HGTLIM
        K = (I - 1)/3*9 + MOD(I - 1, 3) + 1
        S(SBASE+I) = Y(K)
        S(STWICE+I) = -Y(K+3)
        IF (PLANE .EQ. 0) S(STWICE+I) = 2.0D0*(Y(K+3) + Y(K+6) - Y(K))
   30 CONTINUE
      CALL HHCARR(HGTLIM, 3, 3, S(STWICE+1))
      S(SPLANE) = DBLE(PLANE)
      S(SN) = DBLE(N)
      S(SE) = DBLE(E)
      OK = 0
      IF (N .LE. HGTLIM .AND. E .LE. 0) OK = 1
      END

C     HHHEIG - H is the height of the position Z above a plane, or its
C     power in a sphere, S: u.(u - twice the centre), u seen from the
C     base, all of it by limbs.  ERR bounds the error: RADIX**2 if limbs
C     do not hold Z, as |Z| <= 1 and no centre is farther than RADIX.
C     (7 rows of products are 30.75 RADIX**2 at most: limbs are at most
C     RADIX and 3/2 RADIX, limbs 1 RADIX/2 and 2 RADIX.)  If H
C     underflows it loses at most NORMAL, the least normal double, less
C     than DETUND.
      SUBROUTINE HHHEIG(X, S, Z, H, ERR)
      DOUBLE PRECISION X(3,*), S(*), H, ERR
      INTEGER Z
      INTEGER SPLANE, SN, SE, SBASE, STWICE, DOT, BITS, HGTLIM
      DOUBLE PRECISION EPS, RADIX, DETUND
      PARAMETER (SPLANE = 8, SN = 9, SE = 10, SBASE = 10, STWICE = 31,
     $    DOT = 1, EPS = 2.0D0**(-52), BITS = 24, RADIX = 2.0D0**24,
     $    DETUND = 2.0D0**(-1000), HGTLIM = 7)
      DOUBLE PRECISION HHLDEX, SUM(2*HGTLIM), U(3*HGTLIM), Y(3*HGTLIM)
      INTEGER E, I, LAT, N
      E = INT(S(SE))
      H = 0.0D0
      ERR = RADIX*RADIX
      CALL HHSPLI(3, X(1,Z), HHLDEX(1.0D0, E), HGTLIM, U, N)
      IF (N .GT. HGTLIM) RETURN
      N = MAX(N, INT(S(SN)))
      DO 10 I = 1, 3*HGTLIM
        U(I) = U(I) - S(SBASE+I)
        Y(I) = -S(STWICE+I)
        IF (S(SPLANE) .LE. 0.0D0) Y(I) = U(I) - S(STWICE+I)
   10 CONTINUE
      CALL HHZERO(2*N, SUM)
      CALL HHPROD(DOT, N, 3, U, N, 3, Y, 2*N, 1, SUM)
      CALL HHCARR(2*N, 1, 1, SUM)
      CALL HHLEAD(2*N, SUM, 1, 1, H, LAT)
      H = HHLDEX(H, 2*E + (2 - LAT)*BITS)
      ERR = 8.0D0*EPS*ABS(H) + DETUND
      END

C     HHPWSP (power_in_sphere) - does what HHHEIG does for a sphere S of
C     HHSPHF, with SPHLIM limbs: with HHHEIG in its place rings take 1.1
C     times the instructions.  S(SPOWER+PLACE) is right to 4 EPS of
C     itself.  3 SPHLIM products of at most BASE and 3/2 BASE fit one
C     limb.  OK is 0, and S is left alone, if these limbs do not hold Z;
C     else it is 1.
      SUBROUTINE HHPWSP(X, S, Z, PLACE, OK)
      DOUBLE PRECISION X(3,*), S(*)
      INTEGER Z, PLACE, OK
      INTEGER SPOWER, SBASE, STWICE, BITS, SPHLIM
      DOUBLE PRECISION BASE
      PARAMETER (SPOWER = 3, SBASE = 10, STWICE = 31, BITS = 24,
     $    BASE = 2.0D0**24, SPHLIM = 3)
      DOUBLE PRECISION HHLDEX, H, SUM(2*SPHLIM), U(3*SPHLIM),
     $    Y(3*SPHLIM)
      INTEGER AT, I, K
      OK = 0
      CALL HHSPLI(3, X(1,Z), 4.0D0/BASE, SPHLIM, U, I)
      IF (I .GT. SPHLIM) RETURN
      OK = 1
      DO 10 I = 1, 3*SPHLIM
        U(I) = U(I) - S(SBASE+I)
        Y(I) = U(I) - S(STWICE+I)
   10 CONTINUE
      CALL HHZERO(2*SPHLIM, SUM)
      DO 30 I = 0, SPHLIM - 1
        DO 20 K = 0, SPHLIM - 1
          SUM(I+K+2) = SUM(I+K+2) + (U(3*I+1)*Y(3*K+1) +
     $                 U(3*I+2)*Y(3*K+2) + U(3*I+3)*Y(3*K+3))
   20   CONTINUE
   30 CONTINUE
      CALL HHCARR(2*SPHLIM, 1, 1, SUM)
      CALL HHLEAD(2*SPHLIM, SUM, 1, 1, H, AT)
      S(SPOWER+PLACE) = HHLDEX(H, 4 - AT*BITS)
      END

C     HHSPHF (sphere_of_facet) - sets S to a sphere through the base of
C     the facet V, of set-up F, about the centre of the ball of
C     L-coordinate L, rounded to multiples of 2**E, few enough for
C     HHRNDL.  OK is 0 if it is too large, or if limbs do not hold it or
C     V; else it is 1.
      SUBROUTINE HHSPHF(X, V, BASE, F, L, S, OK)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION X(3,*), F(LF), L, S(*)
      INTEGER V(3), BASE, OK
      INTEGER FNORM, FCEN, SPBEST, SPLAST, SBASE, STWICE, SPHLIM
      DOUBLE PRECISION TOP
      PARAMETER (FNORM = 0, FCEN = 3, SPBEST = 2, SPLAST = 3,
     $    SBASE = 10, STWICE = 31, SPHLIM = 3, TOP = 4.0D0/2.0D0**24)
      DOUBLE PRECISION HHLDEX, HHRNDL, C(3), MOST
      INTEGER HHFREX, E, K
      S(SPBEST) = 0.0D0
      S(SPLAST) = 0.0D0
      MOST = 0.0D0
      DO 10 K = 1, 3
        C(K) = F(FCEN+K) + L*F(FNORM+K)
        MOST = MAX(MOST, ABS(C(K)))
   10 CONTINUE
      OK = 0
      IF (MOST .GT. 0.5D0) RETURN
      E = HHFREX(MOST) - 28
      DO 20 K = 1, 3
        C(K) = HHLDEX(HHRNDL(HHLDEX(C(K), -E)), E + 1)
   20 CONTINUE
      CALL HHSPLI(3, X(1,V(BASE)), TOP, SPHLIM, S(SBASE+1), K)
      IF (K .GT. SPHLIM) RETURN
      CALL HHSPLI(3, C, TOP, SPHLIM, S(STWICE+1), K)
      IF (K .GT. SPHLIM) RETURN
      CALL HHPWSP(X, S, V(MOD(BASE,3)+1), 1, OK)
      IF (OK .EQ. 1) CALL HHPWSP(X, S, V(MOD(BASE+1,3)+1), 2, OK)
      END

C     HHRELA - SGN is what HHPINS decides for the positions V(1..3), A,
C     Z of a set (see HHPORI), 1 or -1, by their powers in one sphere
C     near all of them; or UNSURE.  F is the set-up of the facet V, from
C     V(BASE); the sphere in S is that of the L-coordinate L of a point
C     near which the others are expected, or, if S is ready, an earlier
C     one.
C
C     I does not change if an affine function of Q is subtracted from
C     |Q|**2.  So the powers of the points in any one sphere may take
C     the place of |Q|**2.  Where the points are near the sphere these
C     are small, but right to a few EPS all the same, so HHFIL5 loses no
C     digits to the points' being near it.  The base takes the place of
C     E: its power is 0.  Neither that nor a cyclic exchange of V
C     changes the sign.
      SUBROUTINE HHRELA(X, T3, V, BASE, F, L, A, Z, S, SGN)
      INTEGER LF
      PARAMETER (LF = 12)
      DOUBLE PRECISION X(3,*), T3, F(LF), L, S(*)
      INTEGER V(3), BASE, A, Z, SGN
      INTEGER FRHO, SREADY, SPOWER, SPBEST, SPLAST, UNSURE
      PARAMETER (FRHO = 12, SREADY = 1, SPOWER = 3, SPBEST = 2,
     $    SPLAST = 3, UNSURE = 2)
      INTEGER HHFIL5, OK
      SGN = UNSURE
      IF (INT(S(SREADY)) .EQ. 0) THEN
        IF (T3 .LT. -1.0D0 .OR. ABS(L) .GT. 1.0D3*F(FRHO)) RETURN
        SGN = HHFIL5(X, V(1), V(2), V(3), A, Z, 0, X, -1.0D0)
        IF (SGN .NE. UNSURE) RETURN
        CALL HHSPHF(X, V, BASE, F, L, S, OK)
        S(SREADY) = DBLE(2*OK - 1)
      END IF
      IF (S(SREADY) .LT. 0.0D0) RETURN
      IF (INT(S(SPLAST)) .EQ. A) THEN
        S(SPOWER+3) = S(SPOWER+4)
      ELSE IF (INT(S(SPBEST)) .NE. A) THEN
        CALL HHPWSP(X, S, A, 3, OK)
        IF (OK .EQ. 0) RETURN
      END IF
      S(SPBEST) = DBLE(A)
      CALL HHPWSP(X, S, Z, 4, OK)
      IF (OK .EQ. 0) RETURN
      S(SPLAST) = DBLE(Z)
      SGN = HHFIL5(X, V(MOD(BASE,3)+1), V(MOD(BASE+1,3)+1), A, Z,
     $             V(BASE), 1, S(SPOWER+1), -1.0D0)
      END

C     HHTHIN - computes the set-up F of a facet V that is too thin for
C     Householder's bounds, its normal by limbs, as good as that of any
C     other.  With the rows A and B from V(BASE) n = A x B is exact but
C     for 3 EPS of its length, and, after division by that, 11 EPS; so
C     the side of Z errs by less than 16 EPS |W|, from any base.
C         C - P1 = n x (|B|**2 A - |A|**2 B) / (2 |n|**2)
C     The vector in parentheses is |A| |B| |A-B| long.  If V(BASE) is
C     opposite to the longest edge, |A| + |B| <= 2 |A-B|: nothing
C     cancels, it errs by less than 20 EPS of itself, C - P1 by less
C     than 60 EPS rho; else the centre is not to be used.  E and dc are
C     those of the best facet in HHSETU, 260 EPS and 800 EPS rho, on
C     which other bounds rest.  OK is 1; or 0, and F left as it is,
C     where numbers might underflow.
      SUBROUTINE HHTHIN(X, P, ORD, SE, V, BASE, F, OK)
      INTEGER LF, LBALL
      PARAMETER (LF = 12, LBALL = 85)
      DOUBLE PRECISION X(3,*), P(3,*), F(LF)
      INTEGER ORD(*), SE, V(3), BASE, OK
      INTEGER FNORM, FCEN, FBASE, FE, FDC, FRHO, BSIDE, BE, BSIDEF,
     $    BITS, CENEXP, BROWS
      DOUBLE PRECISION EPS, LENMIN
      PARAMETER (FNORM = 0, FCEN = 3, FBASE = 6, FE = 10, FDC = 11,
     $    FRHO = 12, BSIDE = 59, BE = 84, BSIDEF = 85,
     $    EPS = 2.0D0**(-52), BITS = 24, LENMIN = 2.0D0**(-450),
     $    CENEXP = 300, BROWS = 6)
      DOUBLE PRECISION HHLDEX, A(3), AA, B(3), BB, D(3), NORM, T(LBALL)
      INTEGER E, I, J, K, P1, P2, P3
      P1 = V(BASE)
      P2 = V(MOD(BASE,3)+1)
      P3 = V(MOD(BASE+1,3)+1)
      CALL HHCENT(P, ORD, SE, V, BASE, P1, D, T, OK)
      IF (OK .EQ. 0) RETURN
      E = 2*INT(T(BE)) + (2 - INT(T(BSIDEF)))*BITS
      AA = 0.0D0
      BB = 0.0D0
      DO 10 K = 1, 3
        A(K) = X(K,P2) - X(K,P1)
        B(K) = X(K,P3) - X(K,P1)
        AA = AA + A(K)*A(K)
        BB = BB + B(K)*B(K)
   10 CONTINUE
      IF (E .LT. -CENEXP .OR. AA .LT. LENMIN .OR. BB .LT. LENMIN) OK = 0
      IF (OK .EQ. 0) RETURN
      NORM = 0.0D0
      DO 15 K = 1, 3
        CALL HHLEAD(BROWS, T, BSIDE + K, 4, F(FNORM+K), I)
        F(FNORM+K) = HHLDEX(F(FNORM+K), (1 - I)*BITS)
        NORM = NORM + F(FNORM+K)*F(FNORM+K)
   15 CONTINUE
      NORM = SQRT(NORM)
      DO 20 K = 1, 3
        F(FNORM+K) = F(FNORM+K)/NORM
        D(K) = BB*A(K) - AA*B(K)
        F(FBASE+K) = X(K,P1)
   20 CONTINUE
      NORM = 2.0D0*HHLDEX(NORM, E)
      DO 30 K = 1, 3
        I = MOD(K, 3) + 1
        J = 6 - I - K
        F(FCEN+K) = (F(FNORM+I)*D(J) - F(FNORM+J)*D(I))/NORM
   30 CONTINUE
      F(FRHO) = SQRT(F(FCEN+1)*F(FCEN+1) + F(FCEN+2)*F(FCEN+2) +
     $    F(FCEN+3)*F(FCEN+3))
      F(FE) = 260.0D0*EPS
      F(FDC) = 800.0D0*EPS*F(FRHO)
      END
