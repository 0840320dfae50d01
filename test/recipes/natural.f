C     natural.f - natural neighbour interpolation in space: recipes to
C     copy.
C
C       TRNATU  Sibson's and Laplace's weights at any point  (TRWEIG,
C               TRMINN, TRDOTN, TRCRON, TRLOST, TRBELN, TRREFI, TRCENN,
C               TRSLOT, TRVERT, TRREGI, TRBESI, TRMEND, TRINSI, TRFACN)
C       TRBLEN  Sibson's smooth interpolant, from weights and gradients
C               (TRMINN, TRDOTN)
C
C     natural.c is the same in C; test/unit/t_natural.c tests both.

C     ---- weights ----

C     TRFACN - facet K of a tetrahedron, opposite to its vertex number
C     K: of its vertices number H, 1 to 3 or round again,
C     counter-clockwise as seen from outside.
      INTEGER FUNCTION TRFACN(H, K)
      INTEGER H, K
      INTEGER TABLE(3,4)
      SAVE TABLE
      DATA TABLE /2,3,4, 1,4,3, 1,2,4, 1,3,2/
      TRFACN = TABLE(MOD(H - 1, 3) + 1, K)
      END

      SUBROUTINE TRMINN(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      INTEGER K
      DO 10 K = 1, 3
         C(K) = A(K) - B(K)
   10 CONTINUE
      END

      DOUBLE PRECISION FUNCTION TRDOTN(A, B)
      DOUBLE PRECISION A(3), B(3)
      TRDOTN = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

      SUBROUTINE TRCRON(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      C(1) = A(2)*B(3) - A(3)*B(2)
      C(2) = A(3)*B(1) - A(1)*B(3)
      C(3) = A(1)*B(2) - A(2)*B(1)
      END

C     TRLOST - A + B - X, exactly, where X is the rounded sum.
      DOUBLE PRECISION FUNCTION TRLOST(A, B, X)
      DOUBLE PRECISION A, B, X
      DOUBLE PRECISION Z
      Z = X - A
      TRLOST = (A - (X - Z)) + (B - Z)
      END

C     TRBELN - A * B - X, exactly, where X is the rounded product
C     (T. J. Dekker, Numerische Mathematik 18, 1971).
      DOUBLE PRECISION FUNCTION TRBELN(A, B, X)
      DOUBLE PRECISION A, B, X
      DOUBLE PRECISION S, T, HIGH, TOP
      S = 134217729.0D0*A
      T = 134217729.0D0*B
      HIGH = S - (S - A)
      TOP = T - (T - B)
      TRBELN = ((HIGH*TOP - X) + HIGH*(B - TOP) + (A - HIGH)*TOP) +
     1         (A - HIGH)*(B - TOP)
      END

C     TRREFI - refine C, the centre as seen from vertex O: with E the
C     edges from there, what is left of E.(E - 2 C), in twice the
C     digits, is made 0.
      SUBROUTINE TRREFI(P, V, O, E, F, DET, C)
      DOUBLE PRECISION P(3,*), E(3,3), F(3,3), DET, C(3)
      INTEGER V(4), O
      DOUBLE PRECISION LEFT(3), A, B, G, S, T, U, X, TRLOST, TRBELN
      INTEGER I, K
      DO 20 I = 1, 3
         S = 0.0D0
         T = 0.0D0
         DO 10 K = 1, 3
            A = P(K,V(MOD(O+I-1, 4)+1))
            B = -P(K,V(O))
            G = E(K,I) - 2.0D0*C(K)
            X = E(K,I)*G
            U = S + X
            T = T + (TRBELN(E(K,I), G, X) +
     1               E(K,I)*TRLOST(E(K,I), -2.0D0*C(K), G) +
     2               (E(K,I) + G)*TRLOST(A, B, E(K,I)) +
     3               TRLOST(S, X, U))
            S = U
   10    CONTINUE
         LEFT(I) = S + T
   20 CONTINUE
      DO 30 K = 1, 3
         C(K) = C(K) + (LEFT(1)*F(K,1) + LEFT(2)*F(K,2) +
     1                  LEFT(3)*F(K,3)) / (2.0D0*DET)
   30 CONTINUE
      END

C     TRCENN - of the ball of the tetrahedron V, as seen from Q: C(1) to
C     C(3).  In C(4) the power of Q, negative inside.  IS is 1 if its
C     sign is sure.
C
C     Centres have lost three digits where the square of the volume by
C     the product of three squared edges is less than FLAT, and are
C     computed with twice the digits: below FLATER by TESSBA, which
C     takes 20 times as long.  Nothing but accuracy and speed rests on
C     it.
C
C     With E the edges from vertex O, L the product of their lengths, T
C     the sum, U half an epsilon and D = P(O) - Q: roundings of DET are
C     below 16 U L, of the numerators below 14 U L T; with R = L / DET,
C     which is 1 or more, those of the centre are below 28 U T R**2, and
C     those of the power below U |D| (7 |D| + 62 T R**2), if nothing
C     underflows.  SURE: 200 U; SMALL, LARGE: the range of squares in
C     which nothing that matters underflows.
      SUBROUTINE TRCENN(P, V, Q, C, IS)
      DOUBLE PRECISION P(3,*), Q(3), C(4)
      INTEGER V(4), IS
      DOUBLE PRECISION E(3,3), F(3,3), D(3), SQUARE(3), BALL(4), DET
      DOUBLE PRECISION S, R, ALL, LEAST, FLAT, FLATER, SURE, SMALL
      DOUBLE PRECISION LARGE, TRDOTN
      INTEGER I, K, O, INFO
      PARAMETER (FLAT = 1.0D-6, FLATER = 1.0D-10)
      PARAMETER (SURE = 2.220446049250313D-14)
      PARAMETER (SMALL = 1.0D-150, LARGE = 1.0D60)
      IS = 0
C     From the vertex next to Q: the power there is right to rounding.
      LEAST = 0.0D0
      O = 1
      DO 20 I = 1, 4
         CALL TRMINN(P(1,V(I)), Q, E(1,1))
         S = TRDOTN(E(1,1), E(1,1))
         IF (I .GT. 1 .AND. S .GE. LEAST) GO TO 20
         LEAST = S
         DO 10 K = 1, 3
            D(K) = E(K,1)
   10    CONTINUE
         O = I
   20 CONTINUE
      DO 30 I = 1, 3
         CALL TRMINN(P(1,V(MOD(O+I-1, 4)+1)), P(1,V(O)), E(1,I))
         SQUARE(I) = TRDOTN(E(1,I), E(1,I))
   30 CONTINUE
      CALL TRCRON(E(1,2), E(1,3), F(1,1))
      CALL TRCRON(E(1,3), E(1,1), F(1,2))
      CALL TRCRON(E(1,1), E(1,2), F(1,3))
      DET = TRDOTN(E(1,1), F(1,1))
      R = SQUARE(1)*SQUARE(2)*SQUARE(3)
      ALL = SQUARE(1) + SQUARE(2) + SQUARE(3)
      IF (DET*DET .GT. FLATER*R) THEN
         DO 40 K = 1, 3
            C(K) = (SQUARE(1)*F(K,1) + SQUARE(2)*F(K,2) +
     1              SQUARE(3)*F(K,3)) / (2.0D0*DET)
   40    CONTINUE
         IF (DET*DET .GT. FLAT*R) THEN
            IS = 1
         ELSE
            CALL TRREFI(P, V, O, E, F, DET, C(1))
         END IF
      ELSE
         CALL TESSBA(P, V, BALL, INFO)
         CALL TRMINN(BALL(1), P(1,V(O)), C(1))
      END IF
      C(4) = LEAST + 2.0D0*TRDOTN(D, C(1))
      DO 50 K = 1, 3
         C(K) = C(K) + D(K)
   50 CONTINUE
      IF (IS .EQ. 0) RETURN
      IS = 0
      IF (.NOT. (R .GT. SMALL .AND. LEAST .GT. SMALL .AND.
     1           LEAST + ALL .LT. LARGE)) RETURN
      R = R / (DET*DET)
      IF (ABS(C(4)) .GT. SURE*SQRT(LEAST*(LEAST + ALL*R*R))) IS = 1
      END

C     TRSLOT - in a table with open addressing the place of the number I
C     for which KEY(I) = K, or the empty one where it belongs.
      INTEGER FUNCTION TRSLOT(SIZE, TABLE, KEY, K)
      INTEGER SIZE, TABLE(*), KEY(*), K
      INTEGER I
      I = MOD(K, SIZE) + 1
   10 CONTINUE
      IF (TABLE(I) .GT. 0) THEN
         IF (KEY(TABLE(I)) .NE. K) THEN
            I = MOD(I, SIZE) + 1
            GO TO 10
         END IF
      END IF
      TRSLOT = I
      END

C     TRVERT - X, where Q's Voronoi cell ends on an edge of the diagram
C     without Q: the edge that crosses facet K of the tetrahedron V,
C     from its centre C, whose ball holds Q, to the centre N, whose ball
C     does not.  Along it Q's power is linear, negative at the one end
C     and not at the other, but for rounding: so what is divided is
C     never larger than what it is divided by, wherever Q is.  On the
C     hull, HULL = 1, the edge goes on along the facet's normal, and Q's
C     power grows by twice the distance from the facet's plane.
      SUBROUTINE TRVERT(P, V, K, HULL, N, Q, C, X)
      DOUBLE PRECISION P(3,*), N(4), Q(3), C(4), X(3)
      INTEGER V(4), K, HULL
      DOUBLE PRECISION A(3), B(3), WAY(3), POWER, RISE, S, T, TRDOTN
      INTEGER I, H, TRFACN
      POWER = MIN(C(4), 0.0D0)
      IF (HULL .EQ. 0) THEN
         RISE = MAX(N(4), 0.0D0) - POWER
         DO 5 H = 1, 3
            WAY(H) = N(H) - C(H)
    5    CONTINUE
      ELSE
C        The normal: at the vertex between the two shortest edges.
         T = 0.0D0
         DO 8 H = 1, 3
            WAY(H) = 0.0D0
    8    CONTINUE
         DO 10 H = 1, 3
            I = V(TRFACN(H, K))
            CALL TRMINN(P(1,V(TRFACN(H+1, K))), P(1,I), A)
            CALL TRMINN(P(1,V(TRFACN(H+2, K))), P(1,I), B)
            S = TRDOTN(A, A)*TRDOTN(B, B)
            IF (H .GT. 1 .AND. S .GE. T) GO TO 10
            T = S
            CALL TRCRON(A, B, WAY)
   10    CONTINUE
         CALL TRMINN(P(1,V(TRFACN(1, K))), Q, A)
         RISE = 2.0D0*TRDOTN(A, WAY)
      END IF
      S = 0.0D0
      IF (POWER .LT. 0.0D0) S = POWER / RISE
      DO 20 H = 1, 3
         X(H) = C(H)
         IF (POWER .LT. 0.0D0) X(H) = C(H) - S*WAY(H)
   20 CONTINUE
      END

C     TRREGI - the tetrahedra whose balls hold Q, breadth first from
C     LIST(1).
C
C       NLIST   (out)  their number, and LIST they are
C       SIDE    (out)  4 each: the number in LIST of the neighbour, or
C                      -B at facet B of the region's boundary, of
C                      2*NLIST + 2 at most
C       CORNER  (out)  4 each: the numbers in NBR of the vertices
C       C       (out)  4 each: as TRCENN gives them
C       X       (out)  3 for each facet of the boundary: as TRVERT gives
C                      it
C       NN      (out)  number of vertices, and NBR they are; at most
C                      NLIST + 3
C       TABLE   (out)  (SIZE,2)
C       INFO    (out)  0 or a code of TRNATU
      SUBROUTINE TRREGI(P, NTET, TET, ADJ, Q, MOST, NLIST, LIST, SIDE,
     1                  CORNER, C, X, NN, NBR, SIZE, TABLE, INFO)
      DOUBLE PRECISION P(3,*), Q(3), C(4,*), X(3,*)
      INTEGER NTET, TET(4,*), ADJ(4,*), MOST, NLIST, LIST(*), SIDE(4,*)
      INTEGER CORNER(4,*), NN, NBR(*), SIZE, TABLE(SIZE,2), INFO
      DOUBLE PRECISION N(4)
      INTEGER I, H, J, K, M, S, T, U, IN, NOUT, TRSLOT, HHINSP
      DO 10 I = 1, SIZE
         TABLE(I,1) = 0
         TABLE(I,2) = 0
   10 CONTINUE
      TABLE(TRSLOT(SIZE, TABLE, LIST, LIST(1)),1) = 1
      NLIST = 1
      NOUT = 0
      NN = 0
      DO 20 K = 1, 4
         I = TRSLOT(SIZE, TABLE(1,2), NBR, TET(K,LIST(1)))
         INFO = -4
         IF (TABLE(I,2) .GT. 0) RETURN
         NN = NN + 1
         NBR(NN) = TET(K,LIST(1))
         TABLE(I,2) = NN
         CORNER(K,1) = NN
C        (0: not yet known)
         SIDE(K,1) = 0
   20 CONTINUE
      CALL TRCENN(P, TET(1,LIST(1)), Q, C(1,1), IN)
      M = 1
   30 CONTINUE
      T = LIST(M)
      DO 100 K = 1, 4
         IF (SIDE(K,M) .NE. 0) GO TO 100
         U = ADJ(K,T)
         INFO = 13
         IF (U .EQ. -1) RETURN
         INFO = -4
         IF (U .LT. -1 .OR. U .GT. NTET) RETURN
         IF (U .EQ. 0) THEN
            NOUT = NOUT + 1
            CALL TRVERT(P, TET(1,T), K, 1, C(1,M), Q, C(1,M),
     1                  X(1,NOUT))
            SIDE(K,M) = -NOUT
            GO TO 100
         END IF
         DO 40 J = 1, 4
            IF (ADJ(J,U) .EQ. T) GO TO 50
   40    CONTINUE
         RETURN
   50    CONTINUE
         I = TRSLOT(SIZE, TABLE, LIST, U)
         S = TABLE(I,1)
         IF (S .GT. 0) THEN
            SIDE(K,M) = S
            SIDE(J,S) = M
            GO TO 100
         END IF
         CALL TRCENN(P, TET(1,U), Q, N, IN)
         IF (IN .EQ. 0) THEN
            IN = HHINSP(P(1,TET(1,U)), P(1,TET(2,U)), P(1,TET(3,U)),
     1                  P(1,TET(4,U)), Q)
         ELSE IF (N(4) .GE. 0.0D0) THEN
            IN = -1
         END IF
         INFO = 6
         IF (IN .GT. 1) RETURN
         IF (IN .LT. 1) THEN
            NOUT = NOUT + 1
            CALL TRVERT(P, TET(1,T), K, 0, N, Q, C(1,M), X(1,NOUT))
            SIDE(K,M) = -NOUT
            GO TO 100
         END IF
         INFO = 2
         IF (NLIST .EQ. MOST) RETURN
         NLIST = NLIST + 1
         S = NLIST
         LIST(S) = U
         TABLE(I,1) = S
         SIDE(K,M) = S
C        Its vertices are those of the facet, and number J.
         DO 90 I = 1, 4
            C(I,S) = N(I)
            SIDE(I,S) = 0
            IF (I .EQ. J) GO TO 90
            DO 60 H = 1, 4
               IF (TET(H,T) .EQ. TET(I,U)) GO TO 70
   60       CONTINUE
            INFO = -4
            RETURN
   70       CONTINUE
            CORNER(I,S) = CORNER(H,M)
   90    CONTINUE
         SIDE(J,S) = M
         I = TRSLOT(SIZE, TABLE(1,2), NBR, TET(J,U))
         IF (TABLE(I,2) .EQ. 0) THEN
            NN = NN + 1
            NBR(NN) = TET(J,U)
            TABLE(I,2) = NN
         END IF
         CORNER(J,S) = TABLE(I,2)
  100 CONTINUE
      M = M + 1
      IF (M .LE. NLIST) GO TO 30
      INFO = 0
      END

C     TRBESI - at an edge of a facet of the boundary the other facet:
C     about the edge from tetrahedron FIRST to the last one of the
C     region.  The edge is that without the vertices FACE, opposite to
C     the facet, and OTHER of FIRST.
      INTEGER FUNCTION TRBESI(NLIST, SIDE, CORNER, FIRST, FACE, OTHER)
      INTEGER NLIST, SIDE(4,*), CORNER(4,*), FIRST, FACE, OTHER
      INTEGER J, K, M, O, S, STAYS, STEPS
      M = FIRST
      O = OTHER
      STAYS = CORNER(FACE,M)
      DO 20 STEPS = 1, NLIST
         S = SIDE(O,M)
         IF (S .LT. 0) GO TO 30
         K = 4
         O = 4
         DO 10 J = 3, 1, -1
            IF (SIDE(J,S) .EQ. M) K = J
            IF (CORNER(J,S) .EQ. STAYS) O = J
   10    CONTINUE
         STAYS = CORNER(K,S)
         M = S
   20 CONTINUE
   30 CONTINUE
      TRBESI = 1
      IF (SIDE(O,M) .LT. 0) TRBESI = -SIDE(O,M)
      END

C     TRMEND - make Q the mean of the points by the weights W, to
C     rounding: each weight times 1 - B.(Y - M), where Y is the point as
C     seen from Q, M the mean of these and B what it takes.  BAD is 1
C     where a weight would be changed by more than half: it was nothing
C     but roundings.
      SUBROUTINE TRMEND(NN, Y, W, BAD)
      INTEGER NN, BAD
      DOUBLE PRECISION Y(3,*), W(*)
      DOUBLE PRECISION M(3), B(3), D(3), C(3,3), F(3), S, SIZE, TRDOTN
      INTEGER I, J, K, PASS
      DO 100 PASS = 1, 5
         SIZE = 0.0D0
         DO 20 K = 1, 3
            M(K) = 0.0D0
            DO 10 J = 1, 3
               C(J,K) = 0.0D0
   10       CONTINUE
   20    CONTINUE
         DO 40 I = 1, NN
            DO 30 K = 1, 3
               M(K) = M(K) + W(I)*Y(K,I)
               SIZE = SIZE + W(I)*ABS(Y(K,I))
   30       CONTINUE
   40    CONTINUE
         BAD = 0
         IF (ABS(M(1)) + ABS(M(2)) + ABS(M(3)) .LE. 1.0D-14*SIZE) RETURN
         BAD = 1
         DO 60 I = 1, NN
            DO 45 K = 1, 3
               D(K) = (Y(K,I) - M(K)) / SIZE
   45       CONTINUE
            DO 55 K = 1, 3
               DO 50 J = 1, 3
                  C(J,K) = C(J,K) + W(I)*D(K)*D(J)
   50          CONTINUE
   55       CONTINUE
   60    CONTINUE
         S = 1.0D-15*(C(1,1) + C(2,2) + C(3,3))
         DO 70 K = 1, 3
            C(K,K) = C(K,K) + S
   70    CONTINUE
         DO 80 K = 1, 3
            CALL TRCRON(C(1,MOD(K, 3)+1), C(1,MOD(K+1, 3)+1), F)
            B(K) = TRDOTN(F, M) / TRDOTN(F, C(1,K)) / SIZE
   80    CONTINUE
         DO 95 I = 1, NN
            DO 90 K = 1, 3
               D(K) = (Y(K,I) - M(K)) / SIZE
   90       CONTINUE
            S = TRDOTN(B, D)
            IF (.NOT. (ABS(S) .LE. 0.5D0)) RETURN
            W(I) = W(I) - W(I)*S
   95    CONTINUE
  100 CONTINUE
      END

C     TRINSI - IN is 1 if Q is surely inside of tetrahedron T, not on
C     its boundary.
      SUBROUTINE TRINSI(P, NTET, TET, Q, T, IN)
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER NTET, TET(4,*), T, IN
      INTEGER K, HHORIE
      IN = 0
      IF (T .LT. 1 .OR. T .GT. NTET) RETURN
      DO 10 K = 1, 3
         IF (.NOT. (ABS(Q(K) - Q(K)) .LE. 0.0D0)) RETURN
   10 CONTINUE
      IF (HHORIE(Q, P(1,TET(2,T)), P(1,TET(3,T)), P(1,TET(4,T))) .EQ. 1
     1    .AND. HHORIE(P(1,TET(1,T)), Q, P(1,TET(3,T)), P(1,TET(4,T)))
     2    .EQ. 1 .AND. HHORIE(P(1,TET(1,T)), P(1,TET(2,T)), Q,
     3                        P(1,TET(4,T))) .EQ. 1 .AND.
     4    HHORIE(P(1,TET(1,T)), P(1,TET(2,T)), P(1,TET(3,T)), Q) .EQ. 1)
     5   IN = 1
      END

C     TRNATU - Sibson's and Laplace's natural neighbour weights.
C
C       P, NTET, TET, ADJ  (in)  a result of TESS with NTET >= 1
C       Q       (in)      (3) the point
C       T       (in,out)  as in TESSLO: where to start; the one that
C                         holds Q
C       MOST    (in)      tetrahedra whose balls hold Q that there is
C                         room for, at least 1; 20 mostly do, seldom
C                         more than 60
C       NN      (out)     number of neighbours
C       NBR     (out)     (MOST+3): the neighbours, points
C       SIBSON, LAPLAC  (out)  (MOST+3) each: their weights, in the same
C                         order
C       IW      (out)     (13*MOST+14): workspace
C       RW      (out)     (13*MOST+15): workspace
C       INFO    (out)     0; 1 outside the hull; 2, MOST being too
C                         small: nothing else is lost; 13 where a facet
C                         that is open, in an unfinished result, has a
C                         part in the weights; -7 for MOST < 1; -2, -4,
C                         -5, -6 and 6 as from TESSLO.  NN is 0 but for
C                         0 and 1
C
C     The weights are at least 0, their sum is 1, and Q, or the hull's
C     nearest point to it, is the points' mean by them, all to rounding:
C     the sum of W(K)*VALUE(NBR(K)) interpolates, and reproduces linear
C     fields.
C     Sibson's: the volume that Q's Voronoi cell, if Q were a point,
C     would take from that of a point; smooth but at the points.
C     Laplace's: the area of the face between Q's cell and the other one
C     by the distance; smooth but on the spheres of the tetrahedra.
C
C     At a point its weight is 1.  Outside, both are those of the hull's
C     nearest point, linear on its facet.  Both turn into the linear
C     weights of T where roundings hide Q's cell, by degrees from 1D-8
C     of it on: near the hull, where Voronoi vertices are some 1D4 times
C     as far off as the neighbours; within roundings of a point; beside
C     points that are far off; in sets that are flat; and where
C     differences of coordinates are below 1D-90 or above 1D90.  So it
C     is where only vertices of T have weights.
C
C     Cost: 6 microseconds among random points.  Source: Sibson, "A
C     brief description of natural neighbour interpolation" (1981); for
C     Laplace's Belikov et al. (1997), Hiyoshi and Sugihara (2000).
C
C     The part of a point's cell that Q takes is bounded by parts of the
C     cell's faces, which lie half way to other points, and by the face
C     towards Q.  Its volume is the sum of pyramids with the point for
C     apex: areas times half the distances, less that of the face
C     towards Q.  The faces go from vertex to vertex: a segment (A, B)
C     of that between the points I and J has, with any point O of their
C     plane, the area |det(A - O, B - O, J - I)| / 2 |J - I|.  No
C     multiple of J - I that is added to O matters: O = I will do.
      SUBROUTINE TRNATU(P, NTET, TET, ADJ, Q, T, MOST, NN, NBR, SIBSON,
     1                  LAPLAC, IW, RW, INFO)
      DOUBLE PRECISION P(3,*), Q(3), SIBSON(*), LAPLAC(*), RW(*)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, MOST, NN, NBR(*), IW(*), INFO
      DOUBLE PRECISION W(4)
      INTEGER K, NLIST, IN
      NN = 0
      NLIST = 0
      INFO = -7
      IF (MOST .LT. 1) RETURN
C     Exact weights, which take as long as half of what follows, are
C     found only where they may be wanted.
      CALL TRINSI(P, NTET, TET, Q, T, IN)
      INFO = 0
      DO 5 K = 1, 4
         W(K) = 0.0D0
    5 CONTINUE
      IF (IN .EQ. 0) CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      IF (INFO .NE. 0 .AND. INFO .NE. 1) RETURN
      DO 10 K = 1, 4
         IF (INFO .EQ. 1 .AND. ADJ(K,T) .EQ. -1) INFO = 13
   10 CONTINUE
      IF (INFO .EQ. 13) RETURN
C     What holds Q has it in its ball, if Q is none of the points.
      IF (INFO .EQ. 0 .AND. MAX(W(1), W(2), W(3), W(4)) .LT. 1.0D0) THEN
         IW(1) = T
         CALL TRREGI(P, NTET, TET, ADJ, Q, MOST, NLIST, IW,
     1               IW(MOST+1), IW(5*MOST+1), RW, RW(4*MOST+1), NN,
     2               NBR, 2*MOST + 7, IW(9*MOST+1), INFO)
         IF (INFO .NE. 0) THEN
            NN = 0
            RETURN
         END IF
      END IF
      CALL TRWEIG(P, NTET, TET, ADJ, Q, T, NLIST, IW(MOST+1),
     1            IW(5*MOST+1), NN, NBR, SIBSON, LAPLAC, RW,
     2            RW(4*MOST+1), RW(10*MOST+7), IN, W)
      END

C     TRWEIG - the weights, from the region, which is empty where they
C     are to be linear; in part so where roundings are more than LIMIT
C     of Q's cell, and all from ten times as much on.  C: its balls; X:
C     Q's Voronoi vertices; Y: the neighbours as seen from Q; W: the
C     weights of T, which are not yet known if IN is 1.
      SUBROUTINE TRWEIG(P, NTET, TET, ADJ, Q, T, NLIST, SIDE, CORNER,
     1                  NN, NBR, SIBSON, LAPLAC, C, X, Y, IN, W)
      DOUBLE PRECISION P(3,*), Q(3), SIBSON(*), LAPLAC(*), C(4,*)
      DOUBLE PRECISION X(3,*), Y(3,*), W(4)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, NLIST, SIDE(4,*)
      INTEGER CORNER(4,*), NN, NBR(*), IN
      DOUBLE PRECISION B(3), E(3), F(3), G(3), N(3), WAY(3), S, OWN
      DOUBLE PRECISION LONGES, DOUBT, ALL(2), LIMIT, ROUND, TRDOTN
      INTEGER H, I, J, K, L, M, U, Z, BAD, BAD2, INFO, TRFACN, TRBESI
      PARAMETER (LIMIT = 1.0D-8, ROUND = 2.220446049250313D-16)
      LONGES = 0.0D0
      DOUBT = 0.0D0
      ALL(1) = 0.0D0
      ALL(2) = 0.0D0
      DO 10 I = 1, NN
         CALL TRMINN(P(1,NBR(I)), Q, Y(1,I))
         LONGES = MAX(LONGES, TRDOTN(Y(1,I), Y(1,I)))
         SIBSON(I) = 0.0D0
         LAPLAC(I) = 0.0D0
   10 CONTINUE
C     Each facet of the region, its three edges, and the face across
C     each: as seen from O, (A - O) x (B - O) is (A - O) x (B - A).
C     A is C(1,M).
      DO 80 M = 1, NLIST
         OWN = TRDOTN(C(1,M), C(1,M))
         DO 70 K = 1, 4
            U = SIDE(K,M)
            IF (U .GT. 0 .AND. U .LT. M) GO TO 70
            DO 20 L = 1, 3
               IF (U .LT. 0) THEN
                  B(L) = X(L,-U)
               ELSE
                  B(L) = C(L,U)
               END IF
               WAY(L) = B(L) - C(L,M)
   20       CONTINUE
            DOUBT = DOUBT + OWN + TRDOTN(B, B)
            J = CORNER(TRFACN(3, K),M)
            DO 60 H = 1, 3
               I = J
               J = CORNER(TRFACN(H, K),M)
               DO 30 L = 1, 3
                  E(L) = Y(L,J) - Y(L,I)
                  F(L) = C(L,M) - Y(L,I)
   30          CONTINUE
               CALL TRCRON(F, WAY, N)
               S = TRDOTN(N, E)
               IF (U .LT. 0 .AND. I .LT. J) THEN
C                 The face's edge on Q's cell, from B to X(1,Z).
                  Z = TRBESI(NLIST, SIDE, CORNER, M, K, TRFACN(H+1, K))
                  DO 40 L = 1, 3
                     F(L) = B(L) - Y(L,I)
                     G(L) = X(L,Z) - B(L)
   40             CONTINUE
                  CALL TRCRON(F, G, N)
                  S = S + TRDOTN(N, E)
                  CALL TRCRON(X(1,Z), B, N)
                  LAPLAC(I) = LAPLAC(I) + TRDOTN(N, Y(1,I))
                  LAPLAC(J) = LAPLAC(J) - TRDOTN(N, Y(1,J))
               END IF
               SIBSON(I) = SIBSON(I) + S
               SIBSON(J) = SIBSON(J) + S
   60       CONTINUE
   70    CONTINUE
   80 CONTINUE
      DO 90 I = 1, NN
         SIBSON(I) = SIBSON(I) - LAPLAC(I)
         LAPLAC(I) = LAPLAC(I) / TRDOTN(Y(1,I), Y(1,I))
         IF (SIBSON(I) .LT. 0.0D0) SIBSON(I) = 0.0D0
         IF (LAPLAC(I) .LT. 0.0D0) LAPLAC(I) = 0.0D0
         ALL(1) = ALL(1) + SIBSON(I)
         ALL(2) = ALL(2) + LAPLAC(I)
   90 CONTINUE
C     The part that is linear: all of it where there is nothing, or no
C     number.  Of W the vertices are the first four corners.
      S = 1.0D0
      IF (ALL(1) .GT. 0.0D0 .AND. ALL(2) .GT. 0.0D0 .AND.
     1    0.5D0*ALL(1) .LT. ALL(1) .AND. 0.5D0*ALL(2) .LT. ALL(2)) THEN
         DOUBT = ROUND*SQRT(LONGES)*DOUBT
         S = (DOUBT / ALL(1) / LIMIT - 1.0D0) / 9.0D0
      END IF
      BAD = 1
      BAD2 = 0
      IF (S .LT. 1.0D0) THEN
         DO 100 I = 1, NN
            SIBSON(I) = SIBSON(I) / ALL(1)
            LAPLAC(I) = LAPLAC(I) / ALL(2)
  100    CONTINUE
         CALL TRMEND(NN, Y, SIBSON, BAD)
         CALL TRMEND(NN, Y, LAPLAC, BAD2)
      END IF
      IF (IN .EQ. 1 .AND. (BAD + BAD2 .GT. 0 .OR. S .GT. 0.0D0))
     1   CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      IF (BAD + BAD2 .GT. 0) THEN
         NN = 4
         DO 110 K = 1, 4
            NBR(K) = TET(K,T)
            SIBSON(K) = W(K)
            LAPLAC(K) = W(K)
  110    CONTINUE
      ELSE IF (S .GT. 0.0D0) THEN
         DO 120 I = 1, NN
            SIBSON(I) = SIBSON(I) - S*SIBSON(I)
            LAPLAC(I) = LAPLAC(I) - S*LAPLAC(I)
  120    CONTINUE
         DO 130 K = 1, 4
            I = CORNER(K,1)
            SIBSON(I) = SIBSON(I) + S*W(K)
            LAPLAC(I) = LAPLAC(I) + S*W(K)
  130    CONTINUE
      END IF
      END

C     ---- interpolation ----

C     TRBLEN - Sibson's interpolant: it has the values and the gradients
C     that are given at the points, and no kinks.
C
C       NN, NBR, W  (in)  as TRNATU gives them; W Sibson's weights.
C                         Laplace's leave kinks on the spheres of the
C                         tetrahedra
C       VALUE   (in)   VALUE(I) is that of point I
C       G       (in)   G(K,I): gradient at point I
C
C       OUT     (out)  the value at the point of the weights, which is
C                      Q, or for Q outside the hull's nearest point
C
C     Fields A + B.X + C*|X|**2 are reproduced.
C     Cost: 15 square roots.  Source: Sibson (1981).
      SUBROUTINE TRBLEN(P, NN, NBR, W, VALUE, G, OUT)
      DOUBLE PRECISION P(3,*), W(*), VALUE(*), G(3,*), OUT
      INTEGER NN, NBR(*)
      DOUBLE PRECISION AT(3), D(3), R, PLANE, LINEAR, SLOPES, INVERS
      DOUBLE PRECISION FIRST, SECOND, TRDOTN
      INTEGER I, K
      LINEAR = 0.0D0
      SLOPES = 0.0D0
      INVERS = 0.0D0
      FIRST = 0.0D0
      SECOND = 0.0D0
      DO 10 K = 1, 3
         AT(K) = 0.0D0
   10 CONTINUE
      DO 30 I = 1, NN
         CALL TRMINN(P(1,NBR(I)), P(1,NBR(1)), D)
         DO 20 K = 1, 3
            AT(K) = AT(K) + W(I)*D(K)
   20    CONTINUE
   30 CONTINUE
      DO 50 I = 1, NN
         CALL TRMINN(P(1,NBR(1)), P(1,NBR(I)), D)
         DO 40 K = 1, 3
            D(K) = D(K) + AT(K)
   40    CONTINUE
         R = SQRT(TRDOTN(D, D))
         OUT = VALUE(NBR(I))
         IF (R .LE. 0.0D0) RETURN
         PLANE = VALUE(NBR(I)) + TRDOTN(G(1,NBR(I)), D)
         LINEAR = LINEAR + W(I)*VALUE(NBR(I))
         SLOPES = SLOPES + W(I) / R*PLANE
         INVERS = INVERS + W(I) / R
         FIRST = FIRST + W(I)*R
         SECOND = SECOND + W(I)*R*R
   50 CONTINUE
C     The weights of the two: FIRST / INVERS and SECOND.
      OUT = (FIRST*LINEAR + SECOND*SLOPES) / (FIRST + SECOND*INVERS)
      END
