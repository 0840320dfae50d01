C     parity.f - one set of inputs for the library, its answers as text.
C
C     The twin of parity.c, routine by routine: both make the same
C     points by integer arithmetic, make the same calls and write the
C     same text, counting from 1: small results in full, large ones as
C     checksums.  Each section begins with a line '= ...'; parity.txt
C     has their sums (sums.sh).  See check.sh for what is compared with
C     what.
C
C     Kinds of points:
C        1  general     pseudo-random multiples of 2**(-31)
C        2  lattice     integers, in order
C        3  shuffled    the same in another order
C        4  sphere      integers with X**2 + Y**2 + Z**2 = 2, or 941
C        5  moment      (T, T**2, T**3)
C        6  duplicates  many in one place; zeros of both signs
C        7  clusters    integers in four planes
C        8  plane + 1   a grid in a plane and one point off it
C        9  jitter      the lattice moved by up to 2**(-40)
C       10  wide        exponents from -300 to 300
C       11  plane       12  line        13  point
C       14  cube        its corners, its centre, centres of faces
C       15  last places integers times 2**(-50) beside (1,1,1)
      PROGRAM PARITY
      INTEGER MANY
      PARAMETER (MANY = 33)
      INTEGER I, KIND(MANY), N(MANY)
      DATA KIND /1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8,
     $    9, 9, 10, 10, 11, 11, 12, 12, 13, 13, 14, 14, 15, 15, 1/
      DATA N /4, 5, 11, 900, 12, 1000, 8, 729, 12, 552, 9, 60, 14, 300,
     $    14, 400, 10, 401, 12, 512, 8, 60, 9, 100, 5, 50, 3, 1, 9, 14,
     $    10, 500, 0/
      DO 10 I = 1, MANY
        CALL SOLVE(KIND(I), N(I))
   10 CONTINUE
      CALL WRTWO('= arguments', 0, 0)
      CALL BADARG
      CALL WRTWO('= faults', 0, 0)
      CALL FAULTS
      CALL WRTWO('= signs, facets', 0, 0)
      CALL SIGNS(1, 60)
      CALL SIGNS(2, 27)
      CALL SIGNS(4, 12)
      CALL SIGNS(10, 40)
      CALL FACETS(1, 20)
      CALL FACETS(2, 27)
      CALL INPLAN
      END

C     WRLINE - write a label and K numbers, at most 8.
      SUBROUTINE WRLINE(LABEL, K, A)
      CHARACTER*(*) LABEL
      INTEGER K, A(8)
      CHARACTER*16 FIELD
      INTEGER I
      FIELD = LABEL
      WRITE (*, 10) FIELD, (A(I), I = 1, K)
   10 FORMAT (A16, 8I9)
      END

C     WRTWO - write a label and two numbers.
      SUBROUTINE WRTWO(LABEL, I, J)
      CHARACTER*(*) LABEL
      INTEGER I, J
      INTEGER A(8)
      A(1) = I
      A(2) = J
      CALL WRLINE(LABEL, 2, A)
      END

C     CHKSUM - a checksum of K numbers from -2 to 5000000.
      INTEGER FUNCTION CHKSUM(K, A)
      INTEGER K, A(*)
      INTEGER I, S
      S = 1
      DO 10 I = 1, K
        S = MOD(S*1021 + A(I) + 2, 2097143)
   10 CONTINUE
      CHKSUM = S
      END

C     WRMANY - write a label and K numbers of an array: all of up to
C     200, eight a line; else their checksum.
      SUBROUTINE WRMANY(LABEL, K, A)
      CHARACTER*(*) LABEL
      INTEGER K, A(*)
      INTEGER CHKSUM
      INTEGER B(8), I, J
      IF (K .GT. 200) THEN
        CALL WRTWO(LABEL, K, CHKSUM(K, A))
        RETURN
      END IF
      J = 0
      DO 10 I = 1, K
        J = J + 1
        B(J) = A(I)
        IF (J .EQ. 8 .OR. I .EQ. K) THEN
          CALL WRLINE(LABEL, J, B)
          J = 0
        END IF
   10 CONTINUE
      END

C     DIFFER - how many entries of the K numbers A and B differ.
      INTEGER FUNCTION DIFFER(K, A, B)
      INTEGER K, A(*), B(*)
      INTEGER I
      DIFFER = 0
      DO 10 I = 1, K
        IF (A(I) .NE. B(I)) DIFFER = DIFFER + 1
   10 CONTINUE
      END

C     NEAR - the whole number nearest to 65536 X; 9999999 or minus that
C     for a large X.
      INTEGER FUNCTION NEAR(X)
      DOUBLE PRECISION X
      NEAR = 9999999
      IF (X .LT. 0.0D0) NEAR = -NEAR
      IF (ABS(X) .LT. 100.0D0) NEAR = NINT(65536.0D0*X)
      END

C     RANDOM - the next SEED, 1 ... 2**31 - 2 (Park and Miller's minimal
C     standard, by Schrage's method).
      SUBROUTINE RANDOM(SEED)
      INTEGER SEED
      SEED = 16807*MOD(SEED, 127773) - 2836*(SEED/127773)
      IF (SEED .LE. 0) SEED = SEED + 2147483647
      END

C     INCUBE - (X, Y, Z) is number I = 0, 1, ... of a cube of M**3.
      SUBROUTINE INCUBE(I, M, X)
      INTEGER I, M
      DOUBLE PRECISION X(3)
      X(1) = DBLE(MOD(I, M))
      X(2) = DBLE(MOD(I/M, M))
      X(3) = DBLE(I/(M*M))
      END

C     SPHERE - the points of kind 4.
      SUBROUTINE SPHERE(N, P)
      INTEGER N
      DOUBLE PRECISION P(3,*)
      INTEGER I, SQUARE, X, Y, Z
      SQUARE = 2
      IF (N .GT. 12) SQUARE = 941
      I = 0
      DO 30 X = -30, 30
        DO 20 Y = -30, 30
          DO 10 Z = -30, 30
            IF (X*X + Y*Y + Z*Z .EQ. SQUARE .AND. I .LT. N) THEN
              I = I + 1
              P(1,I) = DBLE(X)
              P(2,I) = DBLE(Y)
              P(3,I) = DBLE(Z)
            END IF
   10     CONTINUE
   20   CONTINUE
   30 CONTINUE
      END

C     MKPNTS - N points of a kind.
      SUBROUTINE MKPNTS(KIND, N, P)
      INTEGER KIND, N
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION POWER, TINY
      INTEGER I, J, K, M, SEED, U, V
      SEED = 1000*KIND + N + 1
      M = 1
   10 IF (M*M*M .LT. N) THEN
        M = M + 1
        GO TO 10
      END IF
      TINY = 1.0D0
      DO 20 J = 1, 40
        TINY = 0.5D0*TINY
   20 CONTINUE
      IF (KIND .EQ. 4) CALL SPHERE(N, P)
      DO 50 I = 1, N
        IF (KIND .EQ. 2 .OR. KIND .EQ. 9) CALL INCUBE(I - 1, M, P(1,I))
        IF (KIND .EQ. 3) CALL INCUBE(MOD(7*I, M*M*M), M, P(1,I))
        CALL RANDOM(SEED)
        U = MOD(SEED/1000, 16)
        CALL RANDOM(SEED)
        V = MOD(SEED/1000, 16)
        DO 40 K = 1, 3
          CALL RANDOM(SEED)
          IF (KIND .EQ. 1) P(K,I) = DBLE(SEED)/2147483648.0D0
          IF (KIND .EQ. 5) P(K,I) = DBLE(I**K)
          IF (KIND .EQ. 6) P(K,I) = -DBLE(MOD(SEED/1000, M - 1))
          IF (KIND .EQ. 6 .AND. V .GT. 7) P(K,I) = ABS(P(K,I))
          IF (KIND .EQ. 9) P(K,I) = P(K,I) +
     $        DBLE(MOD(SEED/1000, 3) - 1)*TINY
          IF (KIND .EQ. 10) THEN
            POWER = 2.0D0
            IF (MOD(SEED/1000, 2) .EQ. 1) POWER = 0.5D0
            P(K,I) = DBLE(SEED)
            DO 30 J = 1, MOD(SEED, 300)
              P(K,I) = P(K,I)*POWER
   30       CONTINUE
          END IF
          IF (KIND .EQ. 12) P(K,I) = DBLE(I*K)
          IF (KIND .EQ. 13) P(K,I) = DBLE(K)
          IF (KIND .EQ. 15) P(K,I) = 1.0D0 +
     $        DBLE(MOD(SEED/1000, 16))*TINY/1024.0D0
   40   CONTINUE
        IF (KIND .EQ. 7) THEN
          P(1,I) = DBLE(U)
          P(2,I) = DBLE(V)
          J = MOD(I, 4)
          IF (J .LE. 1) P(3,I) = DBLE(16*J)
          IF (J .EQ. 2) P(3,I) = DBLE(U + V)
          IF (J .EQ. 3) P(3,I) = DBLE(2*U - V)
        ELSE IF (KIND .EQ. 8) THEN
          P(1,I) = DBLE(MOD(I, 20))
          P(2,I) = DBLE(I/20)
          P(3,I) = 0.0D0
          IF (I .EQ. N) P(3,I) = 1.0D0
        ELSE IF (KIND .EQ. 11) THEN
          P(1,I) = DBLE(U)
          P(2,I) = DBLE(V)
          P(3,I) = DBLE(3*U - 2*V + 1)
        ELSE IF (KIND .EQ. 14) THEN
          IF (I .LE. 8) CALL INCUBE(I - 1, 2, P(1,I))
          IF (I .GT. 8) THEN
            P(1,I) = 0.5D0
            P(2,I) = 0.5D0
            P(3,I) = 0.5D0
            K = MOD(I, 3) + 1
            IF (I .GT. 9) P(K,I) = DBLE(MOD(I, 2))
          END IF
        END IF
   50 CONTINUE
      END

C     PIECES - the same result in steps: arrays too short, the least
C     workspace, and once more when all is done.
      SUBROUTINE PIECES(N, P, NTET, TET, ADJ, LIW, IW, LRW, RW)
      INTEGER N, NTET, TET(4,*), ADJ(4,*), LIW, IW(*), LRW
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER MAXTET
      PARAMETER (MAXTET = 12000)
      INTEGER CHKSUM, DIFFER
      INTEGER A(8), ADJ2(4,MAXTET), INFO, K, L, NT, STEP, TET2(4,MAXTET)
      STEP = NTET/3
      CALL TESS(N, P, STEP, NT, TET2, ADJ2, LIW, IW, LRW, RW, INFO)
   10 CALL WRTWO('in part', INFO, NT)
      CALL WRTWO('sums', CHKSUM(4*NT, TET2), CHKSUM(4*NT, ADJ2))
      IF (INFO .EQ. 1) THEN
        STEP = MIN(STEP + NTET/3 + 1, NTET)
        CALL TESSRE(N, P, STEP, NT, TET2, ADJ2, LIW, IW, LRW, RW, INFO)
        GO TO 10
      END IF
      CALL WRTWO('different', DIFFER(4*NTET, TET, TET2), DIFFER(4*NTET,
     $           ADJ, ADJ2))
C     the least lengths
      L = 4*N
   20 CALL TESS(N, P, 0, NT, TET2, ADJ2, L, IW, LRW, RW, INFO)
      IF (INFO .EQ. -7) THEN
        L = L + 1
        GO TO 20
      END IF
      CALL WRTWO('least LIW', INFO, L)
      K = 3*N
   30 CALL TESS(N, P, 0, NT, TET2, ADJ2, L, IW, K, RW, INFO)
      IF (INFO .EQ. -9) THEN
        K = K + 1
        GO TO 30
      END IF
      CALL WRTWO('least LRW', INFO, K)
      CALL TESS(N, P, NTET, NT, TET2, ADJ2, L, IW, K, RW, INFO)
      A(1) = INFO
      A(2) = NT
      A(3) = 0
   40 IF (INFO .EQ. 2) THEN
        L = L + L/4
        CALL TESSRE(N, P, NTET, NT, TET2, ADJ2, L, IW, K, RW, INFO)
        A(3) = A(3) + 1
        GO TO 40
      END IF
      A(4) = INFO
      A(5) = NT
      CALL WRLINE('short of LIW', 5, A)
      CALL TESSRE(N, P, NTET, NT, TET2, ADJ2, L, IW, K, RW, INFO)
      CALL WRTWO('once more', INFO, NT)
      CALL WRTWO('different', DIFFER(4*NTET, TET, TET2), DIFFER(4*NTET,
     $           ADJ, ADJ2))
      END

C     QUERY - a point for a query: of the set, halfway or in the middle
C     between some, or outside.
      SUBROUTINE QUERY(I, N, P, Q)
      INTEGER I, N
      DOUBLE PRECISION P(3,*), Q(3)
      DOUBLE PRECISION A, B, C, D
      INTEGER K
      DO 10 K = 1, 3
        A = P(K,MOD(5*I, N)+1)
        B = P(K,MOD(7*I, N)+1)
        C = P(K,MOD(11*I, N)+1)
        D = P(K,MOD(13*I, N)+1)
        Q(K) = A
        IF (MOD(I, 4) .EQ. 1) Q(K) = 0.5D0*A + 0.5D0*B
        IF (MOD(I, 4) .EQ. 2) Q(K) = (0.25D0*A + 0.25D0*B) +
     $      (0.25D0*C + 0.25D0*D)
        IF (MOD(I, 8) .EQ. 7) Q(K) = 2.0D0*A - B
   10 CONTINUE
      END

C     PLACES - location of points of the set, of points halfway and in
C     the middle between them, and outside.
      SUBROUTINE PLACES(KIND, N, P, NTET, TET, ADJ)
      INTEGER KIND, N, NTET, TET(4,*), ADJ(4,*)
      DOUBLE PRECISION P(3,*)
      INTEGER NEAR
      DOUBLE PRECISION Q(3), W(4)
      INTEGER I, INFO, J, K, T, WHERE(8)
      DO 30 J = 1, 16
        I = J
        CALL QUERY(I, N, P, Q)
C       sums that are rounded, and weights in slivers, may differ
        IF (KIND .EQ. 10 .AND. MOD(I, 4) .NE. 0) GO TO 30
        T = 0
        IF (I .GT. 8) T = MOD(17*I, NTET) + 1
        CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
        WHERE(1) = INFO
        WHERE(2) = T
        DO 20 K = 1, 4
          WHERE(2+K) = NEAR(W(K))
   20   CONTINUE
        IF (KIND .EQ. 9) CALL WRLINE('TESSLO', 2, WHERE)
        IF (KIND .NE. 9) CALL WRLINE('TESSLO', 6, WHERE)
   30 CONTINUE
      END

C     ALONE - stars and queries without the mesh.
      SUBROUTINE ALONE(KIND, N, P, WANT, NTET, TET, LIW, IW, LRW, RW)
      INTEGER KIND, N, WANT, NTET, TET(4,*), LIW, IW(*), LRW
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER NEAR
      INTEGER MOST, MAXTET
      PARAMETER (MOST = 1000, MAXTET = 12000)
      DOUBLE PRECISION C(4), Q(3), W(4)
      INTEGER A(8), ADJ2(4,MAXTET), ASKED, I, INFO, J, K, MINE(MOST), NT
      INTEGER TET2(4,MAXTET), V(4)
      CALL TESSIX(N, P, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSIX', INFO, WANT, N)
      CALL WRMANY('places', N, IW)
      DO 10 I = 1, N
        MINE(I) = 0
        IF (MOD(IW(I), 3) .EQ. 0) MINE(I) = 1
   10 CONTINUE
      ASKED = 0
      DO 20 I = 1, NTET
        IF (MINE(TET(1,I)) + MINE(TET(2,I)) + MINE(TET(3,I)) +
     $      MINE(TET(4,I)) .GT. 0) ASKED = ASKED + 1
   20 CONTINUE
      NT = 0
      CALL TESSPA(N, P, MINE, ASKED/2, NT, TET2, ADJ2, LIW, IW, LRW, RW,
     $            INFO)
      CALL WRTWO('TESSPA, half', INFO, NT)
      CALL TESSPA(N, P, MINE, MAXTET, NT, TET2, ADJ2, LIW, IW, LRW, RW,
     $            INFO)
      CALL TELL('TESSPA', NT, ASKED, INFO)
      CALL WRMANY('TET', 4*NT, TET2)
      CALL WRMANY('ADJ', 4*NT, ADJ2)
      CALL TESSRE(N, P, MAXTET, NT, TET2, ADJ2, LIW, IW, LRW, RW, INFO)
C     a facet without a vertex asked for may be open twice
      I = NTET
      IF (INFO .EQ. -6) I = ASKED
      CALL TELL('TESSRE of it', NT, I, INFO)
      CALL WRMANY('TET', 4*NT, TET2)
      CALL TESSIX(N, P, LIW, IW, LRW, RW, INFO)
      V(1) = 0
      IF (N .EQ. 0) RETURN
      DO 40 J = 1, 16
        I = J
        IF (KIND .EQ. 10 .AND. MOD(I, 4) .NE. 0) GO TO 40
        CALL QUERY(I, N, P, Q)
        IF (I .LT. 9) V(1) = 0
        CALL TESSQU(N, P, IW, RW, Q, V, W, INFO)
        IF (WANT .NE. 0) THEN
          CALL TELL('TESSQU', INFO, WANT, I)
          GO TO 40
        END IF
        CALL WRMANY('TESSQU', 4, V)
        A(1) = INFO
        DO 30 K = 1, 4
          A(1+K) = NEAR(W(K))
   30   CONTINUE
        IF (KIND .EQ. 9) CALL WRLINE('TESSQU', 1, A)
        IF (KIND .NE. 9) CALL WRLINE('TESSQU', 5, A)
   40 CONTINUE
      IF (KIND .EQ. 10) RETURN
      DO 60 I = 1, MIN(NTET, 8)
        CALL TESSBA(P, TET(1,I), C, INFO)
        A(1) = INFO
        DO 50 K = 1, 4
          A(1+K) = NEAR(C(K))
   50   CONTINUE
        CALL WRLINE('TESSBA', 5, A)
   60 CONTINUE
      END

C     BEYOND - queries outside, with the mesh and without: near, far,
C     far away and above a point.
      SUBROUTINE BEYOND(KIND, N, P, NTET, TET, ADJ, LIW, IW, LRW, RW)
      INTEGER KIND, N, NTET, TET(4,*), ADJ(4,*), LIW, IW(*), LRW
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER NEAR
      DOUBLE PRECISION C, D, Q(3), W(4)
      INTEGER A(8), I, INFO, INFO2, J, K, T, V(4)
      CALL TESSIX(N, P, LIW, IW, LRW, RW, INFO)
      V(1) = 0
      DO 40 J = 1, 12
        I = J
        DO 10 K = 1, 3
          C = P(K,MOD(5*I, N)+1)
          D = P(K,MOD(7*I, N)+1)
          IF (MOD(I, 4) .EQ. 0) Q(K) = 2.0D0*C - D
          IF (MOD(I, 4) .EQ. 1) Q(K) = 1024.0D0*(C - D)
          IF (MOD(I, 4) .EQ. 2) Q(K) = 1099511627776.0D0*(C - D)
C         differences of numbers that are wide apart are rounded
          IF (KIND .EQ. 10) Q(K) = 2.0D0*C
          IF (MOD(I, 4) .EQ. 3) Q(K) = C
          IF (MOD(I, 4) .EQ. 3 .AND. K .EQ. MOD(I, 3) + 1)
     $      Q(K) = 1000.0D0
   10   CONTINUE
        T = 0
        IF (I .GT. 6) T = MOD(17*I, NTET) + 1
        CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
        A(1) = INFO
        A(2) = T
        DO 20 K = 1, 4
          A(2+K) = NEAR(W(K))
   20   CONTINUE
        K = 6
        IF (KIND .EQ. 9 .AND. INFO .EQ. 0) K = 2
        CALL WRLINE('TESSLO', K, A)
        IF (I .LT. 7) V(1) = 0
        CALL TESSQU(N, P, IW, RW, Q, V, W, INFO2)
        DO 30 K = 1, 4
          A(K) = V(K)
          A(4+K) = NEAR(W(K))
   30   CONTINUE
        K = 8
        IF (KIND .EQ. 9 .AND. INFO .EQ. 0) K = 4
        CALL WRLINE('TESSQU', K, A)
        IF (INFO2 .NE. INFO) CALL WRTWO('WRONG', INFO2, INFO)
   40 CONTINUE
      END

C     VALUES - two values at places on a line that begins and ends
C     outside: in order, from what was found, in another order; one at
C     a time.
      SUBROUTINE VALUES(N, P, NTET, TET, ADJ)
      INTEGER N, NTET, TET(4,*), ADJ(4,*)
      DOUBLE PRECISION P(3,*)
      INTEGER CHKSUM, DIFFER, NEAR
      INTEGER MOST, NQ
      PARAMETER (MOST = 1000, NQ = 24)
      DOUBLE PRECISION C, D, OUT(2,NQ), Q(3,NQ), VALUE(2,MOST)
      DOUBLE PRECISION PAIR(2), W(4)
      INTEGER A(2*NQ), B(2*NQ), I, INFO, J, K, M, ROWS, T(NQ), T2(NQ)
      INTEGER CODE, INFO2, LAST
      DO 10 I = 1, N
        VALUE(1,I) = DBLE(MOD(I - 1, 17))
        VALUE(2,I) = P(1,I)
   10 CONTINUE
      DO 20 I = 1, NQ
        T(I) = 0
   20 CONTINUE
      DO 80 M = 1, 3
        DO 40 I = 1, NQ
          J = I - 1
          IF (M .EQ. 3) J = MOD(7*J, NQ)
          T2(I) = T(I)
          IF (M .EQ. 3) T2(I) = 0
          DO 30 K = 1, 3
            C = P(K,N/3+1)
            D = P(K,N)
            Q(K,I) = C + DBLE(J - 4)*(D - C)/16.0D0
   30     CONTINUE
   40   CONTINUE
        CALL TESSVA(P, NTET, TET, ADJ, 2, VALUE, NQ, Q, T2, OUT, INFO)
        DO 50 I = 1, NQ
          J = I - 1
          IF (M .EQ. 3) J = MOD(7*J, NQ)
          B(2*J+1) = NEAR(OUT(1,I))
          B(2*J+2) = NEAR(OUT(2,I))
   50   CONTINUE
        IF (M .EQ. 1) THEN
          CALL WRMANY('TESSVA', 2*NQ, B)
          DO 60 I = 1, 2*NQ
            A(I) = B(I)
   60     CONTINUE
          DO 70 I = 1, NQ
            T(I) = T2(I)
   70     CONTINUE
C         one at a time: each with its code, and as before
          DO 75 I = 1, NQ
            T2(I) = 0
            IF (I .GT. 1) T2(I) = T2(I-1)
            CALL TESSVA(P, NTET, TET, ADJ, 2, VALUE, 1, Q(1,I), T2(I),
     $                  PAIR, INFO2)
            LAST = ABS(T2(I))
            ROWS = 0
            IF (T2(I) .NE. T(I)) ROWS = 1
            IF (T2(I) .LT. 0 .AND. INFO2 .NE. 1) ROWS = 1
            IF (T2(I) .GT. 0 .AND. INFO2 .NE. 0) ROWS = 1
            IF (PAIR(1) .NE. OUT(1,I)) ROWS = 1
            IF (PAIR(2) .NE. OUT(2,I)) ROWS = 1
            CALL TESSLO(P, NTET, TET, ADJ, Q(1,I), LAST, W, CODE)
            IF (CODE .NE. INFO2 .OR. LAST .NE. ABS(T(I))) ROWS = 1
            IF (ROWS .GT. 0) CALL WRTWO('WRONG', I, INFO2)
   75     CONTINUE
        END IF
        CALL WRTWO('TESSVA', INFO, CHKSUM(NQ, T2))
        ROWS = DIFFER(2*NQ, A, B)
        IF (ROWS .GT. 0) CALL WRTWO('WRONG', ROWS, 0)
   80 CONTINUE
      END

C     SOLVE - N points of a kind, tetrahedralized.
      SUBROUTINE SOLVE(KIND, N)
      INTEGER KIND, N
      INTEGER MOST, MAXTET, LENGTH
      PARAMETER (MOST = 1000, MAXTET = 12000, LENGTH = 60000)
      DOUBLE PRECISION P(3,MOST), RW(8*MOST)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), FAC(3,MAXTET), IW(LENGTH)
      CHARACTER*13 NAME(15)
      INTEGER BAD, CODES(8), INFO, K, LIW, LRW, NFAC, NTET, T
      DATA NAME /'= general', '= lattice', '= shuffled', '= sphere',
     $    '= moment', '= duplicates', '= clusters', '= plane + 1',
     $    '= jitter', '= wide', '= plane', '= line', '= point',
     $    '= cube', '= last places'/
      CALL MKPNTS(KIND, N, P)
      CALL WRTWO(NAME(KIND), KIND, N)
      CALL TESSWK(N, MAXTET, LIW, LRW, INFO)
      CALL WRTWO('TESSWK', LIW, LRW)
      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL WRTWO('TESS', INFO, NTET)
      CALL WRMANY('stand for', N, IW)
      K = INFO
      CALL ALONE(KIND, N, P, K, NTET, TET, LENGTH, IW, LRW, RW)
      IF (K .NE. 0) RETURN
      IF (NTET .LE. 50) THEN
        DO 20 T = 1, NTET
          DO 10 K = 1, 4
            CODES(K) = TET(K,T)
            CODES(4+K) = ADJ(K,T)
   10     CONTINUE
          CALL WRLINE('tetrahedron', 8, CODES)
   20   CONTINUE
      ELSE
        CALL WRMANY('TET', 4*NTET, TET)
        CALL WRMANY('ADJ', 4*NTET, ADJ)
      END IF
      CALL TESSHU(NTET, TET, ADJ, MAXTET, NFAC, FAC, INFO)
      CALL WRTWO('TESSHU', INFO, NFAC)
      CALL WRMANY('FAC', 3*NFAC, FAC)
      CALL TESSCH(N, P, NTET, TET, ADJ, 2*N, IW, BAD, INFO)
      CALL WRTWO('TESSCH', INFO, BAD)
      CALL PIECES(N, P, NTET, TET, ADJ, LIW, IW, LRW, RW)
      CALL PLACES(KIND, N, P, NTET, TET, ADJ)
      CALL BEYOND(KIND, N, P, NTET, TET, ADJ, LENGTH, IW, LRW, RW)
C     sums that are rounded, and values in slivers, may differ
      IF (KIND .NE. 9 .AND. KIND .NE. 10)
     $  CALL VALUES(N, P, NTET, TET, ADJ)
      END

C     TELL - write a code beside the one that the interface promises.
      SUBROUTINE TELL(LABEL, INFO, WANTED, ALSO)
      CHARACTER*(*) LABEL
      INTEGER INFO, WANTED, ALSO
      INTEGER A(8)
      A(1) = INFO
      A(2) = ALSO
      CALL WRLINE(LABEL, 2, A)
      IF (INFO .NE. WANTED) CALL WRTWO('WRONG', INFO, WANTED)
      END

C     BADARG - arguments that are bad.
      SUBROUTINE BADARG
      INTEGER N, MAXTET, LIW, LRW, INTMAX, LARGE
      PARAMETER (N = 12, MAXTET = 200, LIW = 4000, LRW = 200)
      PARAMETER (INTMAX = 2147483647, LARGE = 536870911)
      DOUBLE PRECISION BIG, OUT(4), P(3,N), Q(3), RW(LRW), SAVE, W(4)
      DOUBLE PRECISION SEV(3,2)
      INTEGER ADJ(4,MAXTET), BAD, FAC(3,MAXTET), I, INFO, IW(LIW)
      INTEGER J, K, L, LEN1, LEN2, NFAC, NT, NTET, T, TET(4,MAXTET)
      INTEGER T2(2), TESSED, V(4), WANT(6), WANTVA(7)
      DATA WANT /-1, -5, -5, -6, -8, -10/
      DATA WANTVA /-2, -5, -7, -7, -8, -9, -9/
      CALL TESSWK(-1, 5, I, J, INFO)
      CALL TELL('TESSWK N < 0', INFO, -1, I + J)
      CALL TESSWK(INTMAX, 5, I, J, INFO)
      CALL TELL('TESSWK N large', INFO, -1, I + J)
      CALL TESSWK(5, -1, I, J, INFO)
      CALL TELL('TESSWK MAXT < 0', INFO, -2, I + J)
      CALL TESSWK(5, LARGE, I, J, INFO)
      CALL TELL('TESSWK MAXT most', INFO, 0, J)
      CALL TESSWK(5, LARGE + 1, I, J, INFO)
      CALL TELL('TESSWK MAXT more', INFO, -2, I + J)

      CALL MKPNTS(1, N, P)
      CALL TESS(-1, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESS N < 0', INFO, -1, NT)
      SAVE = P(2,7)
      BIG = 1.0D200
      DO 10 I = 1, 3
        IF (I .EQ. 1) P(2,7) = BIG*BIG
        IF (I .EQ. 2) P(2,7) = -(BIG*BIG)
        IF (I .EQ. 3) P(2,7) = P(2,7) - P(2,7)
        CALL TESS(N, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
        CALL TELL('TESS infinite', INFO, -2, NT)
        NT = 0
        CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
        CALL TELL('TESSRE infinite', INFO, -2, NT)
        CALL TESSCH(N, P, NT, TET, ADJ, LIW, IW, BAD, INFO)
        CALL TELL('TESSCH infinite', INFO, -2, BAD)
   10 CONTINUE
      P(2,7) = SAVE
      CALL TESS(N, P, -1, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESS MAXT < 0', INFO, -3, NT)
      CALL TESS(N, P, LARGE + 1, NT, TET, ADJ, LIW, IW, LRW, RW,
     $          INFO)
      CALL TELL('TESS MAXT large', INFO, -3, NT)
      CALL TESS(N, P, MAXTET, NT, TET, ADJ, 4*N, IW, LRW, RW, INFO)
      CALL TELL('TESS LIW', INFO, -7, NT)
      CALL TESS(N, P, MAXTET, NT, TET, ADJ, LIW, IW, 3*N, RW, INFO)
      CALL TELL('TESS LRW', INFO, -9, NT)
      CALL TESS(N, P, 0, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESS MAXT = 0', INFO, 1, NT)

      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESS', INFO, 0, NTET)
      NT = NTET
      CALL TESSRE(-1, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSRE N < 0', INFO, -1, NT)
      CALL TESSRE(N, P, -1, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSRE MAXT < 0', INFO, -3, NT)
      CALL TESSRE(N, P, NTET - 1, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSRE NTET more', INFO, -4, NT)
      NT = -1
      CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSRE NTET < 0', INFO, -4, NT)
      NT = NTET
      DO 20 I = 1, 4
        J = TET(3,2)
        K = ADJ(3,2)
        IF (I .EQ. 1) TET(3,2) = 0
        IF (I .EQ. 2) TET(3,2) = N + 1
        IF (I .EQ. 3) ADJ(3,2) = -2
        IF (I .EQ. 4) ADJ(3,2) = NTET + 1
        CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
        CALL TELL('TESSRE index', INFO, -5 - (I - 1)/2, NT)
        TET(3,2) = J
        ADJ(3,2) = K
   20 CONTINUE
      DO 30 K = 1, 3
        P(K,N) = P(K,1)
   30 CONTINUE
      CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSRE duplicate', INFO, -5, NT)
      CALL MKPNTS(1, N, P)
      CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, 4*N, IW, LRW, RW, INFO)
      CALL TELL('TESSRE LIW', INFO, -7, NT)
      CALL TESSRE(N, P, MAXTET, NT, TET, ADJ, LIW, IW, 3*N, RW, INFO)
      CALL TELL('TESSRE LRW', INFO, -9, NT)

      DO 40 K = 1, 3
        Q(K) = P(K,1)
   40 CONTINUE
      T = 0
      CALL TESSLO(P, 0, TET, ADJ, Q, T, W, INFO)
      CALL TELL('TESSLO NTET', INFO, -2, T)
      Q(2) = BIG*BIG
      CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      CALL TELL('TESSLO infinite', INFO, -5, T)
      Q(2) = 0.0D0
      T = -1
      CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      CALL TELL('TESSLO T < 0', INFO, -6, T)
      T = NTET + 1
      CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      CALL TELL('TESSLO T > NTET', INFO, -6, T)

      DO 50 K = 1, 3
        SEV(K,1) = 0.25D0
        SEV(K,2) = 0.25D0
   50 CONTINUE
      DO 60 I = 1, 7
        T2(1) = 0
        T2(2) = 0
        IF (I .EQ. 6) T2(2) = -NTET - 1
        IF (I .EQ. 7) T2(2) = NTET + 1
        SEV(2,2) = 0.25D0
        IF (I .EQ. 5) SEV(2,2) = BIG*BIG
        J = 2
        IF (I .EQ. 3) J = -1
        IF (I .EQ. 4) J = INTMAX
        K = NTET
        IF (I .EQ. 1) K = 0
        L = 2
        IF (I .EQ. 2) L = -1
        CALL TESSVA(P, K, TET, ADJ, L, SEV, J, SEV, T2, OUT, INFO)
        CALL TELL('TESSVA', INFO, WANTVA(I), T2(1))
   60 CONTINUE
      CALL TESSVA(P, NTET, TET, ADJ, 0, SEV, 2, SEV, T2, OUT, INFO)
      CALL TELL('TESSVA T > NTET', INFO, -9, T2(1))
      T2(2) = 0
      CALL TESSVA(P, NTET, TET, ADJ, 0, SEV, 0, SEV, T2, OUT, INFO)
      CALL TELL('TESSVA NQ = 0', INFO, 0, T2(1))
      CALL TESSVA(P, NTET, TET, ADJ, 0, SEV, 2, SEV, T2, OUT, INFO)
      CALL TELL('TESSVA NV = 0', INFO, 0, T2(1))
      CALL WRTWO('TESSVA NV = 0', T2(2), 0)

      CALL TESSHU(-1, TET, ADJ, MAXTET, NFAC, FAC, INFO)
      CALL TELL('TESSHU NTET', INFO, -1, NFAC)
      CALL TESSHU(NTET, TET, ADJ, -1, NFAC, FAC, INFO)
      CALL TELL('TESSHU MAXFAC', INFO, -4, NFAC)
      CALL TESSHU(NTET, TET, ADJ, 5, NFAC, FAC, INFO)
      CALL TELL('TESSHU more', INFO, 1, NFAC)
      CALL WRMANY('FAC', 15, FAC)
      CALL TESSHU(NTET, TET, ADJ, 0, NFAC, FAC, INFO)
      CALL TELL('TESSHU none', INFO, 1, NFAC)

      CALL TESSIX(-1, P, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSIX N < 0', INFO, -1, 0)
      CALL TESSIX(N, P, 2*N, IW, LRW, RW, INFO)
      CALL TELL('TESSIX LIW', INFO, -3, 0)
      CALL TESSIX(N, P, LIW, IW, 3*N, RW, INFO)
      CALL TELL('TESSIX LRW', INFO, -5, 0)
      CALL TESSIX(N, P, LIW, IW, LRW, RW, INFO)
      CALL TELL('TESSIX', INFO, 0, IW(4))
      V(1) = 0
      CALL TESSQU(-1, P, IW, RW, Q, V, W, INFO)
      CALL TELL('TESSQU N < 0', INFO, -1, 0)
      Q(2) = BIG*BIG
      CALL TESSQU(N, P, IW, RW, Q, V, W, INFO)
      CALL TELL('TESSQU infinite', INFO, -5, 0)
      Q(2) = 0.0D0
      DO 80 I = 1, 5
        DO 70 K = 1, 4
          V(K) = TET(K,2)
   70   CONTINUE
        IF (I .EQ. 1) V(1) = -1
        IF (I .EQ. 2) V(4) = N + 1
        IF (I .EQ. 3) V(3) = V(2)
        IF (I .EQ. 4) V(1) = TET(2,2)
        IF (I .EQ. 4) V(2) = TET(1,2)
        IF (I .EQ. 5) V(2) = 0
        CALL TESSQU(N, P, IW, RW, Q, V, W, INFO)
        CALL TELL('TESSQU V', INFO, -6, I)
   80 CONTINUE
      DO 90 I = 1, 6
        NT = 0
        IF (I .EQ. 3) NT = -1
        IF (I .EQ. 2 .OR. I .EQ. 4) NT = NTET
        K = N
        IF (I .EQ. 1) K = -1
        L = MAXTET
        IF (I .EQ. 2) L = NTET - 1
        LEN1 = LIW
        IF (I .EQ. 5) LEN1 = 4*N
        LEN2 = LRW
        IF (I .EQ. 6) LEN2 = 3*N
        J = TET(3,2)
        IF (I .EQ. 4) TET(3,2) = N + 1
        CALL TESSPA(K, P, FAC, L, NT, TET, ADJ, LEN1, IW, LEN2, RW,
     $              INFO)
        TET(3,2) = J
        CALL TELL('TESSPA', INFO, WANT(I), I)
   90 CONTINUE
      V(1) = 0
      CALL TESSBA(P, V, W, INFO)
      CALL TELL('TESSBA V', INFO, -2, 0)
      CALL TELL('TESSED', TESSED() - 50000, 0, 0)

      CALL TESSCH(-1, P, NTET, TET, ADJ, LIW, IW, BAD, INFO)
      CALL TELL('TESSCH N < 0', INFO, -1, BAD)
      CALL TESSCH(N, P, -1, TET, ADJ, LIW, IW, BAD, INFO)
      CALL TELL('TESSCH NTET < 0', INFO, -3, BAD)
      CALL TESSCH(N, P, NTET, TET, ADJ, 2*N - 1, IW, BAD, INFO)
      CALL TELL('TESSCH LIW', INFO, -6, BAD)
      END

C     CHECK - what TESSCH says of a result, and what it should.
      SUBROUTINE CHECK(LABEL, WANTED, N, P, NTET, TET, ADJ)
      CHARACTER*(*) LABEL
      INTEGER WANTED, N, NTET, TET(4,*), ADJ(4,*)
      DOUBLE PRECISION P(3,*)
      INTEGER LIW
      PARAMETER (LIW = 200)
      INTEGER BAD, INFO, IW(LIW)
      CALL TESSCH(N, P, NTET, TET, ADJ, LIW, IW, BAD, INFO)
      CALL TELL(LABEL, INFO, WANTED, BAD)
      END

C     FAULTS - wrong results, of each kind that TESSCH tells.
      SUBROUTINE FAULTS
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 20, MAXTET = 200, LIW = 4000, LRW = 200)
      DOUBLE PRECISION P(3,N), RW(LRW)
      INTEGER ADJ(4,MAXTET), I, INFO, IW(LIW), J, K, NT, NTET
      INTEGER RING(2,12), T, TET(4,MAXTET)
      DATA RING /5, 0, 4, 3, 3, 4, 0, 5, -3, 4, -4, 3, -5, 0, -4, -3,
     $    -3, -4, 0, -5, 3, -4, 4, -3/
      CALL MKPNTS(1, N, P)
      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      CALL CHECK('right', 0, N, P, NTET, TET, ADJ)
      I = TET(2,3)
      TET(2,3) = TET(1,3)
      CALL CHECK('vertex twice', 10, N, P, NTET, TET, ADJ)
      TET(2,3) = N + 1
      CALL CHECK('vertex N + 1', 10, N, P, NTET, TET, ADJ)
      TET(2,3) = 0
      CALL CHECK('vertex 0', 10, N, P, NTET, TET, ADJ)
      TET(2,3) = TET(3,3)
      TET(3,3) = I
      CALL CHECK('turned over', 12, N, P, NTET, TET, ADJ)
      TET(3,3) = TET(2,3)
      TET(2,3) = I
      I = ADJ(4,5)
      ADJ(4,5) = -1
      CALL CHECK('open', 13, N, P, NTET, TET, ADJ)
      ADJ(4,5) = NTET + 1
      CALL CHECK('ADJ > NTET', 14, N, P, NTET, TET, ADJ)
      ADJ(4,5) = MOD(I, NTET) + 1
      CALL CHECK('other ADJ', 14, N, P, NTET, TET, ADJ)
      ADJ(4,5) = I
C     longer in one direction: the same hull, other balls
      DO 10 I = 1, N
        P(3,I) = 8.0D0*P(3,I)
   10 CONTINUE
      CALL CHECK('stretched', 15, N, P, NTET, TET, ADJ)
      CALL MKPNTS(1, N, P)
C     open facets taken for the hull
      CALL TESS(N, P, NTET - 4, NT, TET, ADJ, LIW, IW, LRW, RW, INFO)
      DO 30 T = 1, NT
        DO 20 K = 1, 4
          ADJ(K,T) = MAX(ADJ(K,T), 0)
   20   CONTINUE
   30 CONTINUE
      CALL CHECK('not convex', 16, N, P, NT, TET, ADJ)
C     the last point inside, and in no tetrahedron
      DO 40 K = 1, 3
        P(K,N) = 0.25D0*P(K,TET(1,1)) + 0.25D0*P(K,TET(2,1)) +
     $      0.25D0*P(K,TET(3,1)) + 0.25D0*P(K,TET(4,1))
   40 CONTINUE
      CALL TESS(N - 1, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW,
     $          INFO)
      CALL CHECK('point missing', 18, N, P, NTET, TET, ADJ)
C     the last point a duplicate, and a vertex
      DO 50 K = 1, 3
        P(K,N) = P(K,TET(1,2))
   50 CONTINUE
      TET(1,2) = N
      CALL CHECK('duplicate', 11, N, P, NTET, TET, ADJ)
      CALL CHECK('no tetrahedron', 18, N, P, 0, TET, ADJ)
      CALL MKPNTS(11, N, P)
      CALL CHECK('none in a plane', 0, N, P, 0, TET, ADJ)
C     tetrahedra on one axis, twice about it: every other one of twelve
C     points of a circle, then the rest
      DO 60 I = 1, 12
        J = I - 1
        J = MOD(2*J + J/6, 12) + 1
        P(1,I) = DBLE(RING(1,J))
        P(2,I) = DBLE(RING(2,J))
        P(3,I) = 0.0D0
        TET(1,I) = 13
        TET(2,I) = 14
        TET(3,I) = I
        TET(4,I) = MOD(I, 12) + 1
        ADJ(1,I) = 0
        ADJ(2,I) = 0
        ADJ(3,I) = MOD(I, 12) + 1
        ADJ(4,I) = MOD(I + 10, 12) + 1
        P(MOD(I, 3)+1,13) = 0.0D0
        P(MOD(I, 3)+1,14) = 0.0D0
   60 CONTINUE
      P(3,13) = -5.0D0
      P(3,14) = 5.0D0
      CALL CHECK('twice around', 17, 14, P, 12, TET, ADJ)
      DO 70 I = 1, 12
        P(1,I) = DBLE(RING(1,I))
        P(2,I) = DBLE(RING(2,I))
   70 CONTINUE
      CALL CHECK('once around', 0, 14, P, 12, TET, ADJ)
      END

C     CHOOSE - five points near number I.
      SUBROUTINE CHOOSE(I, N, V)
      INTEGER I, N, V(5)
      INTEGER J, K
      DO 10 K = 1, 5
        J = K*K + 1
        V(K) = MOD(J*I + K, N) + 1
   10 CONTINUE
      END

C     SIGNS - of points near each other: the exact predicates.
      SUBROUTINE SIGNS(KIND, N)
      INTEGER KIND, N
      INTEGER MOST
      PARAMETER (MOST = 60)
      INTEGER CHKSUM, HHINSP, HHORIE
      DOUBLE PRECISION P(3,MOST)
      INTEGER I, S(MOST), U(MOST), V(5)
      CALL MKPNTS(KIND, N, P)
      DO 10 I = 1, N
        CALL CHOOSE(I, N, V)
        S(I) = HHORIE(P(1,V(1)), P(1,V(2)), P(1,V(3)), P(1,V(4)))
        U(I) = HHINSP(P(1,V(1)), P(1,V(2)), P(1,V(3)), P(1,V(4)),
     $                P(1,V(5)))
   10 CONTINUE
      CALL WRTWO('signs', CHKSUM(N, S), CHKSUM(N, U))
      CALL WRMANY('HHORIE', N, S)
      CALL WRMANY('HHINSP', N, U)
      END

C     HOUSES - the Householder predicates, rounded to multiples of
C     2**(-16), which no rounding in the last places alters.
      SUBROUTINE HOUSES(P1, P2, P3, Z1, Z2)
      DOUBLE PRECISION P1(3), P2(3), P3(3), Z1(3), Z2(3)
      INTEGER HHOPP, NEAR
      DOUBLE PRECISION HHLCOO, HHSIDE
      DOUBLE PRECISION C, F(12)
      INTEGER A(8), B(8), INFO, K
      CALL HHFACE(P1, P2, P3, F, INFO)
      A(1) = INFO
      DO 10 K = 1, 6
        A(1+K) = NEAR(F(K))
   10 CONTINUE
      A(8) = NEAR(F(12))
      CALL WRLINE('HHFACE', 8, A)
      B(1) = NEAR(HHSIDE(F, Z1))
      B(2) = NEAR(HHLCOO(F, Z1))
      B(3) = HHOPP(F, Z1, Z2)
      CALL HHWRAP(P1, P2, P3, Z1, C, INFO)
      B(4) = INFO
      B(5) = NEAR(C)
      CALL WRLINE('HHSIDE ...', 5, B)
      END

C     FACETS - facets of points of a kind, with two points that are not
C     in their planes: those would be there to rounding only.
      SUBROUTINE FACETS(KIND, N)
      INTEGER KIND, N
      INTEGER MOST
      PARAMETER (MOST = 60)
      INTEGER HHORIE
      DOUBLE PRECISION P(3,MOST)
      INTEGER I, V(5)
      CALL MKPNTS(KIND, N, P)
      DO 10 I = 1, N
        CALL CHOOSE(I, N, V)
        IF (HHORIE(P(1,V(1)), P(1,V(2)), P(1,V(3)), P(1,V(4)))*
     $      HHORIE(P(1,V(1)), P(1,V(2)), P(1,V(3)), P(1,V(5))) .NE. 0)
     $    CALL HOUSES(P(1,V(1)), P(1,V(2)), P(1,V(3)), P(1,V(4)),
     $                P(1,V(5)))
   10 CONTINUE
      END

C     INPLAN - points in a plane where nothing is rounded, and points on
C     a line.
      SUBROUTINE INPLAN
      DOUBLE PRECISION P(3,6)
      DATA P /0.0D0, 0.0D0, 0.0D0, 1.0D0, 0.0D0, 0.0D0, 0.0D0, 1.0D0,
     $    0.0D0, 0.25D0, 0.25D0, 0.0D0, 2.0D0, 2.0D0, 0.0D0, 3.0D0,
     $    0.0D0, 0.0D0/
      CALL HOUSES(P(1,1), P(1,2), P(1,3), P(1,4), P(1,5))
      CALL HOUSES(P(1,1), P(1,2), P(1,3), P(1,5), P(1,4))
      CALL HOUSES(P(1,1), P(1,2), P(1,6), P(1,4), P(1,5))
      CALL HOUSES(P(1,1), P(1,1), P(1,3), P(1,4), P(1,5))
      END
