C     slopes.f - smooth, accurate interpolation of scattered data:
C     recipes to copy.
C
C       TRSLOP  gradients of a field at the points, from its values
C               there  (TRPLAS, TRMARK, TRFIT, TRDOTS)
C       TRBENT  the field at any place, from values and gradients
C               (TRDOTS)
C
C     TRBENT costs a query what linear interpolation does.  Its error is
C     of third order where linear interpolation's is of second: inside
C     the hull a fifth to a twentieth of it.  At the hull, where
C     tetrahedra are long and flat, no interpolation that looks at four
C     points alone is good.  Which interpolation is best where:
C     slopes.c.
C
C     slopes.c is the same in C.

C     ---- slopes ----

      DOUBLE PRECISION FUNCTION TRDOTS(A, B)
      DOUBLE PRECISION A(3), B(3)
      TRDOTS = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

C     TRFIT - X of (M + ADD I) X = R, M symmetric: XX, YY, ZZ, XY, XZ,
C     YZ.
      SUBROUTINE TRFIT(M, ADD, R, X)
      DOUBLE PRECISION M(6), ADD, R(3), X(3)
      DOUBLE PRECISION A, B, C, D, E, F, S
      A = M(1) + ADD
      B = M(4) / A
      C = M(5) / A
      D = M(2) + ADD - B*M(4)
      E = (M(6) - B*M(5)) / D
      F = M(3) + ADD - C*M(5) - E*(M(6) - B*M(5))
      S = R(2) - B*R(1)
      X(3) = (R(3) - C*R(1) - E*S) / F
      X(2) = S / D - E*X(3)
      X(1) = R(1) / A - B*X(2) - C*X(3)
      END

C     TRPLAS - G: the gradient of the linear field nearest to the values
C     of the points I with USED(I) .NE. 0, in the mean of squares.  By
C     coordinates U in parts of the box, the longest side first; then by
C     what is left of the second when it is told from the first one, and
C     of the third told from both.  So what is thin is seen as such, not
C     as a difference of squares.
C     What is thinner than THIN is flat: its points do not tell how a
C     field goes on across it, unless the field is linear.
C     NOISE: the values' rounding, as a part of them.
      SUBROUTINE TRPLAS(N, P, USED, VALUE, G)
      INTEGER N
      DOUBLE PRECISION P(3,*), USED(*), VALUE(*), G(3)
      DOUBLE PRECISION LOW(3), SIZE(3), MEAN(4), U(3), M(6), A(6), R(4)
      DOUBLE PRECISION X(3), T(3), D, B, C, E, COUNT, TOP, REST, THIN
      DOUBLE PRECISION NOISE, TRDOTS
      INTEGER I, BY(3), J, K, PASS
      PARAMETER (THIN = 1.0D-7, NOISE = 8.881784197001252D-16)
      B = 0.0D0
      C = 0.0D0
      E = 0.0D0
      COUNT = 0.0D0
      TOP = 0.0D0
      DO 10 K = 1, 3
         LOW(K) = 0.0D0
         SIZE(K) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, N
         IF (USED(I) .LE. 0.0D0) GO TO 30
         DO 20 K = 1, 3
            D = P(K,I)
            IF (COUNT .LE. 0.0D0 .OR. D .LT. LOW(K)) LOW(K) = D
            IF (COUNT .LE. 0.0D0 .OR. D .GT. SIZE(K)) SIZE(K) = D
   20    CONTINUE
         IF (ABS(VALUE(I)) .GT. TOP) TOP = ABS(VALUE(I))
         COUNT = COUNT + 1.0D0
   30 CONTINUE
      IF (TOP .LE. 0.0D0) TOP = 1.0D0
      DO 60 K = 1, 3
         SIZE(K) = SIZE(K) - LOW(K)
         BY(K) = K
         DO 40 J = K, 2, -1
            IF (.NOT. (SIZE(K) .GT. SIZE(BY(J-1)))) GO TO 50
            BY(J) = BY(J-1)
            BY(J-1) = K
   40    CONTINUE
   50    CONTINUE
   60 CONTINUE
      DO 70 K = 1, 4
         MEAN(K) = 0.0D0
   70 CONTINUE
      DO 140 PASS = 0, 2
         DO 80 K = 1, 6
            M(K) = 0.0D0
            R(MOD(K, 4)+1) = 0.0D0
   80    CONTINUE
         DO 110 I = 1, N
            IF (USED(I) .LE. 0.0D0) GO TO 110
            DO 90 K = 1, 3
               U(K) = (P(BY(K),I) - LOW(BY(K))) / SIZE(BY(K)) - MEAN(K)
   90       CONTINUE
            U(2) = U(2) - B*U(1)
            U(3) = U(3) - (C*U(1) + E*U(2))
            D = 1.0D0 / COUNT
            IF (PASS .GT. 0) D = VALUE(I) / TOP - MEAN(4)
            DO 100 K = 1, 3
               M(K) = M(K) + U(K)*U(K)
               R(K) = R(K) + U(K)*D
  100       CONTINUE
            M(4) = M(4) + U(1)*U(2)
            M(5) = M(5) + U(1)*U(3)
            M(6) = M(6) + U(2)*U(3)
            IF (PASS .EQ. 0) R(4) = R(4) + D*(VALUE(I) / TOP)
            IF (PASS .GT. 0) R(4) = R(4) + D*D
  110    CONTINUE
         IF (PASS .EQ. 0) THEN
            DO 120 K = 1, 4
               MEAN(K) = R(K)
  120       CONTINUE
         ELSE IF (PASS .EQ. 1) THEN
            B = M(4) / M(1)
            C = M(5) / M(1)
            E = (M(6) - B*M(5)) / (M(2) - B*M(4) + 1.0D-14*M(1))
         END IF
  140 CONTINUE
C     Each in units of its own, but for what is rounding.
      DO 150 K = 1, 3
         T(K) = 0.0D0
         IF (M(K) .GT. 1.0D-28*M(1)) T(K) = 1.0D0 / SQRT(M(K))
  150 CONTINUE
      DO 180 PASS = 0, 1
         DO 160 K = 1, 3
            IF (PASS .GT. 0 .AND. T(1)*SIZE(BY(K)) .LT.
     1          THIN*T(K)*SIZE(BY(1))) T(K) = 0.0D0
            U(K) = R(K)*T(K)
            A(K) = M(K)*T(K)*T(K)
  160    CONTINUE
         A(4) = M(4)*T(1)*T(2)
         A(5) = M(5)*T(1)*T(3)
         A(6) = M(6)*T(2)*T(3)
         CALL TRFIT(A, 1.0D-14, U, X)
         REST = R(4) - TRDOTS(U, X)
         IF (REST .LE. 1.0D-12*R(4)) GO TO 190
  180 CONTINUE
  190 CONTINUE
      D = NOISE*SQRT(COUNT)
      DO 200 K = 1, 3
         IF (ABS(X(K)) .LE. D) X(K) = 0.0D0
         X(K) = X(K)*T(K)
  200 CONTINUE
      X(2) = X(2) - E*X(3)
      X(1) = X(1) - (B*X(2) + C*X(3))
      DO 210 K = 1, 3
         X(K) = X(K) / SIZE(BY(K))
  210 CONTINUE
C     Where nothing is told the gradient is 0.
      M(1) = -B*SIZE(BY(2)) / SIZE(BY(1))
      M(2) = 1.0D0
      M(3) = 0.0D0
      M(4) = (E*B - C)*SIZE(BY(3)) / SIZE(BY(1))
      M(5) = -E*SIZE(BY(3)) / SIZE(BY(2))
      M(6) = 1.0D0
      D = 0.0D0
      IF (T(2) .LE. 0.0D0) D = TRDOTS(M(1), M(4)) / TRDOTS(M(1), M(1))
      DO 220 K = 1, 3
         M(K+3) = M(K+3) - D*M(K)
  220 CONTINUE
      DO 240 J = 2, 3
         IF (T(J) .GT. 0.0D0) GO TO 240
         D = TRDOTS(X, M(3*J-5)) / TRDOTS(M(3*J-5), M(3*J-5))
         DO 230 K = 1, 3
            X(K) = X(K) - D*M(3*J-6+K)
  230    CONTINUE
  240 CONTINUE
      DO 250 K = 1, 3
         G(BY(K)) = X(K)*TOP
  250 CONTINUE
      END

C     TRSLOP - gradients of a field at the points.
C
C       N, P, NTET, TET, ADJ  (in)  points and mesh, as from TESS
C       VALUE   (in)   (N): the field's values
C       ROUNDS  (in)   >= 0: 3 do; 15 for a field that is smooth at the
C                      spacing of the points
C       G       (out)  (3,N): G(K,I) is the derivative by coordinate K
C                      at point I.  A duplicate (IW(I) .NE. I) has no
C                      edges: the gradient of the field's best linear
C                      fit.  Copy that of IW(I)
C       WORK    (out)  (9,N)
C       INFO    (out)  0; -1 for N < 1, -3 for NTET < 1, -7 for
C                      ROUNDS < 0; 10 for a vertex that is out of range,
C                      13 for an unfinished mesh: G is then not set; 6
C                      where a gradient is no number, being too large
C                      or by a value that is none: the others are set
C
C     Cost: each pass, of which there are ROUNDS + 1, a fifth of the
C     time of TESS.
C
C     First, by least squares, the one gradient that suits all points
C     best; then at each point the one that suits its own edges,
C
C         M G = R,  M = sum of W E E',
C         R = sum of W (difference of values) E,
C
C     an edge E having the weight W = 1 / (E.E) for each tetrahedron at
C     it.  Where points are nearly in a plane, what M cannot tell is
C     taken from the first gradient, by 1D-4 of M's trace on its
C     diagonal.  A linear field comes out as it is, since nothing is
C     left to tell after the first gradient; so, too, in a flat set,
C     across which the first gradient of any other field is 0.
C
C     Along an edge of a quadratic field the difference is not either
C     end's gradient times the edge, but that of both ends' mean.  So
C     each round adds at all points at once
C
C         1.8 (M + D)^-1 sum of W (difference - (GA + GB).E / 2) E,
C
C     D the diagonal.  This cannot diverge: it is a step down the
C     gradient of
C
C         S = sum over edges of W (difference - (GA + GB).E / 2)**2,
C
C     of the quadratic form X'A X = sum of W (XA.E + XB.E)**2 / 2.  As
C     (s + t)**2 / 2 <= s**2 + t**2, X'A X <= X'M X: the eigenvalues of
C     (M + D)^-1 A are in [0, 1], those of the round, 1 minus 1.8 times
C     them, in [-0.8, 1].  S never grows, and no part of the error does.
C     That needs each edge's weight to be the same at both ends, and a
C     factor of at most 2; 1 takes twice as many rounds.
      SUBROUTINE TRSLOP(N, P, NTET, TET, ADJ, VALUE, ROUNDS, G, WORK,
     1                  INFO)
      INTEGER N, NTET, TET(4,*), ADJ(4,*), ROUNDS, INFO
      DOUBLE PRECISION P(3,*), VALUE(*), G(3,*), WORK(9,*)
      DOUBLE PRECISION E(3), X(3), SIZE, W, D, S, U, NOISE, TRDOTS
      INTEGER I, T, A, B, PASS, J, K, L
      PARAMETER (NOISE = 8.881784197001252D-16)
      INFO = 0
      IF (ROUNDS .LT. 0) INFO = -7
      IF (NTET .LT. 1) INFO = -3
      IF (N .LT. 1) INFO = -1
      IF (INFO .NE. 0) RETURN
      DO 20 T = 1, NTET
         DO 10 K = 1, 4
            INFO = 10
            IF (TET(K,T) .LT. 1 .OR. TET(K,T) .GT. N) RETURN
            INFO = 13
            IF (ADJ(K,T) .EQ. -1) RETURN
   10    CONTINUE
   20 CONTINUE
      INFO = 0
      CALL TRMARK(N, NTET, TET, WORK)
      CALL TRPLAS(N, P, WORK, VALUE, X)
C     Point I has R in WORK(1,I) to WORK(3,I), M in WORK(4,I) on.
      DO 50 I = 1, N
         DO 30 K = 1, 9
            WORK(K,I) = 0.0D0
   30    CONTINUE
         DO 40 K = 1, 3
            G(K,I) = X(K)
   40    CONTINUE
   50 CONTINUE
      DO 220 PASS = 0, ROUNDS
         DO 80 I = 1, N
            DO 70 K = 1, 3
               WORK(K,I) = 0.0D0
   70       CONTINUE
   80    CONTINUE
         DO 140 T = 1, NTET
            DO 130 J = 1, 3
               DO 120 L = J + 1, 4
                  A = TET(J,T)
                  B = TET(L,T)
                  DO 90 K = 1, 3
                     E(K) = P(K,B) - P(K,A)
   90             CONTINUE
                  SIZE = 1.0D0
                  W = TRDOTS(E, E)
                  IF (.NOT. (W .GT. 1.0D-280 .AND. W .LT. 1.0D280)) THEN
                     SIZE = MAX(ABS(E(1)), ABS(E(2)), ABS(E(3)))
                     DO 95 K = 1, 3
                        E(K) = E(K) / SIZE
   95                CONTINUE
                     W = TRDOTS(E, E)
                  END IF
                  W = 1.0D0 / W
                  S = TRDOTS(G(1,A), E)
                  U = TRDOTS(G(1,B), E)
                  IF (PASS .GT. 0) THEN
                     S = (S + U) / 2.0D0
                     U = S
                  END IF
                  D = (VALUE(B) - VALUE(A)) / SIZE
                  S = D - S
                  U = D - U
C                 Within the values' rounding nothing is left to tell.
                  D = NOISE*(ABS(VALUE(A)) + ABS(VALUE(B))) / SIZE
                  IF (ABS(S) .LE. D) S = 0.0D0
                  IF (ABS(U) .LE. D) U = 0.0D0
                  DO 100 K = 1, 3
                     WORK(K,A) = WORK(K,A) + W*S*E(K)
                     WORK(K,B) = WORK(K,B) + W*U*E(K)
  100             CONTINUE
                  IF (PASS .GT. 0) GO TO 120
                  DO 110 K = 1, 6
                     IF (K .LE. 3) D = W*E(K)*E(K)
                     IF (K .EQ. 4) D = W*E(1)*E(2)
                     IF (K .EQ. 5) D = W*E(1)*E(3)
                     IF (K .EQ. 6) D = W*E(2)*E(3)
                     WORK(K+3,A) = WORK(K+3,A) + D
                     WORK(K+3,B) = WORK(K+3,B) + D
  110             CONTINUE
  120          CONTINUE
  130       CONTINUE
  140    CONTINUE
         DO 210 I = 1, N
            D = WORK(4,I) + WORK(5,I) + WORK(6,I)
            IF (.NOT. (D .GT. 0.0D0)) GO TO 210
            CALL TRFIT(WORK(4,I), 1.0D-4*D, WORK(1,I), X)
            W = 1.0D0
            IF (PASS .GT. 0) W = 1.8D0
            DO 190 K = 1, 3
               G(K,I) = G(K,I) + W*X(K)
  190       CONTINUE
  210    CONTINUE
  220 CONTINUE
      DO 240 I = 1, N
         DO 230 K = 1, 3
            IF (.NOT. (ABS(G(K,I)) .LE. 1.797D308)) INFO = 6
  230    CONTINUE
  240 CONTINUE
      END

C     TRMARK - USED(I) = 1 for the points of tetrahedra, 0 for others.
      SUBROUTINE TRMARK(N, NTET, TET, USED)
      INTEGER N, NTET, TET(4,*)
      DOUBLE PRECISION USED(*)
      INTEGER I, K
      DO 10 I = 1, N
         USED(I) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NTET
         DO 20 K = 1, 4
            USED(TET(K,I)) = 1.0D0
   20    CONTINUE
   30 CONTINUE
      END

C     ---- bent ----

C     TRBENT - the field at a place Q.
C
C       P, NTET, TET, ADJ  (in)  points and mesh
C       VALUE   (in)      the field's values at the points
C       G       (in)      gradients there, as TRSLOP gives them
C       BEYOND  (in)      for Q outside the hull: 0.0 for the field at
C                         the hull's point nearest to Q; 1.0 to go on
C                         from there with the gradient; or what lies
C                         between
C       Q       (in)      the place: 3 coordinates
C       T       (in,out)  where the walk starts, and the tetrahedron, as
C                         in TESSLO
C       F       (out)     the field at Q
C       INFO    (out)     what TESSLO returns: 0 inside, 1 outside, else
C                         F is not set
C
C     Cost: that of TESSLO.
C
C     The weights' sum of F(K) + G(K).(Q - P(K)) / 2.  Continuous, the
C     data at the points, and exact for a quadratic field whose
C     gradients are: with h = Q - P(K) and H its second derivatives F(K)
C     is f - grad.h + h'H h / 2, G(K) is grad - H h, so that
C     F(K) + G(K).h / 2 = f - grad.h / 2, and the weights' sum of h is
C     0.
C
C     Near sharp bends of the field it may leave the range of the data.
C
C     Outside, with 1,000 to 27,000 points of a cube of edge 1 and two
C     fields: within 0.1 of it 1.0 has a third of the median error that
C     0.0 has, and no larger worst ones; at 0.2 to 0.4 half of it or
C     less, but of a hundred errors the largest is up to twice that of
C     0.0; 0.5 then is between in both.  0.0 cannot go beyond what is at
C     the hull.  The gradient is the points', from all edges at them; a
C     hull tetrahedron's own is useless, such a tetrahedron being flat.
      SUBROUTINE TRBENT(P, NTET, TET, ADJ, VALUE, G, BEYOND, Q, T, F,
     1                  INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, INFO
      DOUBLE PRECISION P(3,*), VALUE(*), G(3,*), BEYOND, Q(3), F
      DOUBLE PRECISION W(4), AT(3), H(3), TRDOTS
      INTEGER A, B, J, K
      CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      IF (INFO .NE. 0 .AND. INFO .NE. 1) RETURN
      A = TET(1,T)
      DO 20 K = 1, 3
         AT(K) = Q(K)
         IF (INFO .EQ. 0) GO TO 20
         AT(K) = P(K,A)
         DO 10 J = 2, 4
            AT(K) = AT(K) + W(J)*(P(K,TET(J,T)) - P(K,A))
   10    CONTINUE
   20 CONTINUE
      F = 0.0D0
      DO 40 J = 1, 4
         B = TET(J,T)
         DO 30 K = 1, 3
            H(K) = (AT(K) - P(K,B)) / 2.0D0 + BEYOND*(Q(K) - AT(K))
   30    CONTINUE
         F = F + W(J)*(VALUE(B) + TRDOTS(G(1,B), H))
   40 CONTINUE
      END
