C     derived.f - what can be had from TET and ADJ: recipes to copy.
C
C         gfortran -O2 test/examples/derived.f f77/tess.f f77/hhpred.f
C
C     Each routine stands for itself: it needs P, TET and ADJ, the
C     caller's arrays for its result, and what is named with it.  Open
C     facets of an unfinished result count as hull.  Duplicates (IW(I)
C     .NE. I) are in no tetrahedron.
C
C       EDGES   each edge once, and a tetrahedron that has it  (TURN,
C               AROUND)
C       FACES   each facet once, and the tetrahedra on both sides
C       STARS   for each point the tetrahedra that have it, in rows
C       NEARPT  the point of P nearest to another one   (STARS' rows)
C       MEASUR  volume, circumcentre and circumradius of a tetrahedron
C               (MINUS, DOT, CROSS, CIRCLE, CENTRE)
C       DUAL    area of each edge's dual face and volume of each point's
C               cell in the Voronoi diagram  (TURN, AROUND, and MEASUR's
C               five)
C       GRADIE  of a field linear on a tetrahedron (MINUS, DOT, CROSS)
C
C     The main program tests them: against brute force, and by
C     identities that hold for any set of points.  derived.c is the same
C     in C; both write the same text.
      PROGRAM DERIVE
      INTEGER N, MAXTET, MAXEDG, MAXFAC, LIW, LRW
      PARAMETER (N = 343, MAXTET = 12*N, MAXEDG = 2*MAXTET)
      PARAMETER (MAXFAC = 4*MAXTET, LIW = 19*N + 1800, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MAXEDG), CELL(N), FLUX(3,N)
      DOUBLE PRECISION VALUE(N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), EDGE(2,MAXEDG)
      INTEGER AT(MAXEDG), FACE(3,MAXFAC), BOTH(2,MAXFAC)
      INTEGER HULL(3,MAXFAC), FIRST(N+1), LIST(4*MAXTET), OUTER(N)
      INTEGER SEEN(N,N), BAD(7), SET, M, NTET, NEDGE, NFACE, NHULL
      INTEGER CELLS, INFO, INFO1, INFO2, INFO3, I, SEED
      CHARACTER*7 NAME(3)
      CHARACTER*50 TESTED(7)
      CHARACTER*3 ANSWER(0:1)
      DATA NAME /'random', 'lattice', 'shell'/
      DATA ANSWER /'yes', 'NO'/
      DATA TESTED /
     1   'edges: those of brute force; Euler''s formula:     ',
     2   'faces: each once, of both tetrahedra:             ',
     3   'stars: all tetrahedra of each point:              ',
     4   'nearest: as brute force:                          ',
     5   'measure: volumes fill the hull, balls are empty:  ',
     6   'dual: cells are closed and fill the hull:         ',
     7   'gradient: of linear fields, and along edges:      '/
      SEED = 1
      DO 10 I = 1, 7
         BAD(I) = 0
   10 CONTINUE
      WRITE (*, 50)
      DO 30 SET = 1, 3
         CALL MAKE(SET, SEED, M, P)
         CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
         CALL TESSHU(NTET, TET, ADJ, MAXFAC, NHULL, HULL, INFO1)
         CALL EDGES(NTET, TET, ADJ, MAXEDG, NEDGE, EDGE, AT, INFO2)
         CALL FACES(NTET, TET, ADJ, MAXFAC, NFACE, FACE, BOTH, INFO3)
         IF (INFO + INFO1 + INFO2 + INFO3 .NE. 0) THEN
            WRITE (*, *) 'the arrays are too short', INFO
            STOP
         END IF
         CALL STARS(M, NTET, TET, FIRST, LIST)
         CALL DUAL(M, P, TET, ADJ, NEDGE, EDGE, AT, AREA, CELL, OUTER)
         CELLS = M
         DO 20 I = 1, M
            CELLS = CELLS - OUTER(I)
   20    CONTINUE
         WRITE (*, 60) NAME(SET), M, NTET, NEDGE, NFACE, NHULL, CELLS
         CALL TEDGES(N, M, NTET, TET, NEDGE, EDGE, AT, FIRST, NFACE,
     1               SEEN, BAD(1))
         CALL TFACES(NTET, TET, NFACE, FACE, BOTH, NHULL, BAD(2))
         CALL TSTARS(M, NTET, TET, FIRST, LIST, BAD(3))
         CALL TNEAR(M, P, TET, FIRST, LIST, SEED, BAD(4))
         CALL TMEASU(M, P, NTET, TET, NHULL, HULL, BAD(5))
         CALL TDUAL(M, P, SET, NEDGE, EDGE, AREA, CELL, OUTER, NHULL,
     1              HULL, FLUX, BAD(6))
         CALL TGRADI(M, P, NTET, TET, VALUE, SEED, BAD(7))
   30 CONTINUE
      DO 40 I = 1, 7
         WRITE (*, 70) TESTED(I), ANSWER(BAD(I))
   40 CONTINUE
   50 FORMAT ('set      points  tetrahedra  edges  faces  ',
     1        'hull facets  inner cells')
   60 FORMAT (A7, 2X, I6, 2X, I10, 2X, I5, 2X, I5, 2X, I11, 2X, I11)
   70 FORMAT (A50, A)
      END

C     ---- edges ----

C     TURN - about the edge A B, from tetrahedron T across its facet
C     opposite to its vertex number OUT, which is neither A nor B.  On
C     return T is the neighbour, and OUT where to go on; or T < 1: the
C     hull.
      SUBROUTINE TURN(TET, ADJ, A, B, T, OUT)
      INTEGER TET(4,*), ADJ(4,*), A, B, T, OUT
      INTEGER STAYS, K
      STAYS = 0
      DO 10 K = 1, 4
         IF (K .NE. OUT .AND. TET(K,T) .NE. A .AND. TET(K,T) .NE. B)
     1      STAYS = TET(K,T)
   10 CONTINUE
      T = ADJ(OUT,T)
      IF (T .LT. 1) RETURN
      DO 20 OUT = 1, 3
         IF (TET(OUT,T) .EQ. STAYS) RETURN
   20 CONTINUE
      OUT = 4
      END

C     AROUND - edge E, 1 to 6, of a tetrahedron: from its vertex number
C     I to J, and from K to L counter-clockwise about it.
      SUBROUTINE AROUND(E, I, J, K, L)
      INTEGER E, I, J, K, L
      INTEGER TABLE(4,6)
      SAVE TABLE
      DATA TABLE /1,2,3,4, 1,3,4,2, 1,4,2,3, 2,3,1,4, 2,4,3,1, 3,4,1,2/
      I = TABLE(1,E)
      J = TABLE(2,E)
      K = TABLE(3,E)
      L = TABLE(4,E)
      END

C     EDGES - each edge once: in the ring of tetrahedra about it the
C     first one tells of it.
C
C       MAXEDG  (in)   edges that there is room for
C       NEDGE   (out)  number of edges
C       EDGE    (out)  (2,MAXEDG): the two points of each
C       AT      (out)  (MAXEDG): a tetrahedron that has it
C       INFO    (out)  0, or 1: NEDGE is then the number needed
C
C     Workspace: none.  A cloud of N points has about 7.8 N edges.
      SUBROUTINE EDGES(NTET, TET, ADJ, MAXEDG, NEDGE, EDGE, AT, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), MAXEDG, NEDGE, EDGE(2,*), AT(*)
      INTEGER INFO
      INTEGER T, S, A, B, E, I, J, K, L, SIDE, OUT
      NEDGE = 0
      DO 40 T = 1, NTET
         DO 30 E = 1, 6
            CALL AROUND(E, I, J, K, L)
            A = TET(I,T)
            B = TET(J,T)
C           To one side, and where that ends at the hull to the other.
            DO 20 SIDE = 1, 2
               S = T
               OUT = K
               IF (SIDE .EQ. 2) OUT = L
   10          CONTINUE
               CALL TURN(TET, ADJ, A, B, S, OUT)
               IF (S .GT. T) GO TO 10
               IF (S .GE. 1 .AND. S .LT. T) GO TO 30
               IF (S .EQ. T) GO TO 25
   20       CONTINUE
   25       CONTINUE
            NEDGE = NEDGE + 1
            IF (NEDGE .LE. MAXEDG) THEN
               EDGE(1,NEDGE) = A
               EDGE(2,NEDGE) = B
               AT(NEDGE) = T
            END IF
   30    CONTINUE
   40 CONTINUE
      INFO = 0
      IF (NEDGE .GT. MAXEDG) INFO = 1
      END

C     ---- faces ----

C     FACES - each facet once, with the tetrahedra that have it.
C
C       MAXFAC  (in)   faces that there is room for; 4*NTET always
C                      suffice
C       NFACE   (out)  number of faces
C       FACE    (out)  (3,MAXFAC): its vertices, counter-clockwise as
C                      seen from outside of the first tetrahedron
C       BOTH    (out)  (2,MAXFAC): the first tetrahedron and the other
C                      one, or 0 on the hull
C       INFO    (out)  0, or 1: NFACE is then the number needed
      SUBROUTINE FACES(NTET, TET, ADJ, MAXFAC, NFACE, FACE, BOTH, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), MAXFAC, NFACE, FACE(3,*)
      INTEGER BOTH(2,*), INFO
      INTEGER T, U, I, K, FACET(3,4)
      SAVE FACET
      DATA FACET /2,3,4, 1,4,3, 1,2,4, 1,3,2/
      NFACE = 0
      DO 30 T = 1, NTET
         DO 20 K = 1, 4
            U = ADJ(K,T)
            IF (U .GE. 1 .AND. U .LT. T) GO TO 20
            NFACE = NFACE + 1
            IF (NFACE .GT. MAXFAC) GO TO 20
            DO 10 I = 1, 3
               FACE(I,NFACE) = TET(FACET(I,K),T)
   10       CONTINUE
            BOTH(1,NFACE) = T
            BOTH(2,NFACE) = MAX(U, 0)
   20    CONTINUE
   30 CONTINUE
      INFO = 0
      IF (NFACE .GT. MAXFAC) INFO = 1
      END

C     ---- stars, nearest point ----

C     STARS - for each point the tetrahedra that have it.
C
C       FIRST   (out)  (N+1): those of point I are LIST(FIRST(I)) ...
C                      LIST(FIRST(I+1) - 1), in ascending order; none
C                      for a duplicate
C       LIST    (out)  (4*NTET)
      SUBROUTINE STARS(N, NTET, TET, FIRST, LIST)
      INTEGER N, NTET, TET(4,*), FIRST(*), LIST(*)
      INTEGER I, K, T
      DO 10 I = 1, N + 1
         FIRST(I) = 0
   10 CONTINUE
      DO 30 T = 1, NTET
         DO 20 K = 1, 4
            FIRST(TET(K,T)) = FIRST(TET(K,T)) + 1
   20    CONTINUE
   30 CONTINUE
      FIRST(1) = FIRST(1) + 1
      DO 40 I = 2, N + 1
         FIRST(I) = FIRST(I) + FIRST(I-1)
   40 CONTINUE
C     Each row is filled from its end, which becomes its beginning.
      DO 60 T = NTET, 1, -1
         DO 50 K = 4, 1, -1
            I = TET(K,T)
            FIRST(I) = FIRST(I) - 1
            LIST(FIRST(I)) = T
   50    CONTINUE
   60 CONTINUE
      END

C     NEARPT - V becomes the point of P nearest to Q: from V, a point of
C     some tetrahedron, to ever nearer neighbours.  In a Delaunay
C     tetrahedralization the point that has no nearer neighbour is the
C     nearest.  A good V is a vertex of the tetrahedron that TESSLO
C     finds, or the last answer.
      SUBROUTINE NEARPT(P, TET, FIRST, LIST, Q, V)
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER TET(4,*), FIRST(*), LIST(*), V
      DOUBLE PRECISION LEAST, D, E(3), DOT
      INTEGER FROM, I, K, W
      CALL MINUS(P(1,V), Q, E)
      LEAST = DOT(E, E)
   10 CONTINUE
      FROM = V
      DO 30 I = FIRST(FROM), FIRST(FROM+1) - 1
         DO 20 K = 1, 4
            W = TET(K,LIST(I))
            CALL MINUS(P(1,W), Q, E)
            D = DOT(E, E)
            IF (D .LT. LEAST) THEN
               LEAST = D
               V = W
            END IF
   20    CONTINUE
   30 CONTINUE
      IF (V .NE. FROM) GO TO 10
      END

C     ---- measures ----

      SUBROUTINE MINUS(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      INTEGER K
      DO 10 K = 1, 3
         C(K) = A(K) - B(K)
   10 CONTINUE
      END

      DOUBLE PRECISION FUNCTION DOT(A, B)
      DOUBLE PRECISION A(3), B(3)
      DOT = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

      SUBROUTINE CROSS(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      C(1) = A(2)*B(3) - A(3)*B(2)
      C(2) = A(3)*B(1) - A(1)*B(3)
      C(3) = A(1)*B(2) - A(2)*B(1)
      END

C     CIRCLE - centre of the circle through 0, U, V.
      SUBROUTINE CIRCLE(U, V, C)
      DOUBLE PRECISION U(3), V(3), C(3)
      DOUBLE PRECISION NORMAL(3), X(3), DOT
      INTEGER K
      CALL CROSS(U, V, NORMAL)
      DO 10 K = 1, 3
         X(K) = (DOT(U, U)*V(K) - DOT(V, V)*U(K)) /
     1          (2.0D0*DOT(NORMAL, NORMAL))
   10 CONTINUE
      CALL CROSS(X, NORMAL, C)
      END

C     CENTRE - of the ball through 0, U, V, W.  Of four points that are
C     in one plane but for rounding a ball's centre cannot be told; that
C     of the circle through three of them will do.
      SUBROUTINE CENTRE(U, V, W, C)
      DOUBLE PRECISION U(3), V(3), W(3), C(3)
      DOUBLE PRECISION VW(3), WU(3), UV(3), DET, DOT
      INTEGER K
      CALL CROSS(V, W, VW)
      CALL CROSS(W, U, WU)
      CALL CROSS(U, V, UV)
      DET = DOT(U, VW)
      IF (DET .LE. 1.0D-13*SQRT(DOT(U, U)*DOT(V, V)*DOT(W, W))) THEN
         CALL CIRCLE(U, V, C)
         RETURN
      END IF
      DO 10 K = 1, 3
         C(K) = (DOT(U, U)*VW(K) + DOT(V, V)*WU(K) + DOT(W, W)*UV(K)) /
     1          (2.0D0*DET)
   10 CONTINUE
      END

C     MEASUR - the tetrahedron whose vertices are V: its volume, and the
C     centre and radius of its ball.
      SUBROUTINE MEASUR(P, V, VOLUME, MIDDLE, RADIUS)
      DOUBLE PRECISION P(3,*), VOLUME, MIDDLE(3), RADIUS
      INTEGER V(4)
      DOUBLE PRECISION E(3,3), C(3), DOT
      INTEGER K
      DO 10 K = 1, 3
         CALL MINUS(P(1,V(K+1)), P(1,V(1)), E(1,K))
   10 CONTINUE
      CALL CROSS(E(1,2), E(1,3), C)
      VOLUME = DOT(E(1,1), C) / 6.0D0
      CALL CENTRE(E(1,1), E(1,2), E(1,3), C)
      DO 20 K = 1, 3
         MIDDLE(K) = P(K,V(1)) + C(K)
   20 CONTINUE
      RADIUS = SQRT(DOT(C, C))
      END

C     ---- the Voronoi diagram ----

C     DUAL - for finite volumes: what lies between the cells of two
C     points, and the cells.
C
C       NEDGE, EDGE, AT  (in)   as EDGES gives them
C       AREA    (out)  (NEDGE): of the face between the cells of the
C                      edge's points
C       CELL    (out)  (N): volumes
C       OUTER   (out)  (N): 1 for a point on the hull, whose cell has no
C                      end.  Its volume is the part in its tetrahedra,
C                      and so are the areas of edges on the hull: pieces
C                      count as negative where a centre is beyond the
C                      hull, so that the volumes' sum is the hull's in
C                      any case.  All others are exact but for rounding
C
C     A tetrahedron's piece of the face: from the edge's middle to the
C     centres of the two facets at it, and from these to the
C     tetrahedron's own.  A cell is made of pyramids from its point to
C     its faces.
      SUBROUTINE DUAL(N, P, TET, ADJ, NEDGE, EDGE, AT, AREA, CELL,
     1                OUTER)
      INTEGER N, TET(4,*), ADJ(4,*), NEDGE, EDGE(2,*), AT(*), OUTER(*)
      DOUBLE PRECISION P(3,*), AREA(*), CELL(*)
      DOUBLE PRECISION U(3), V(3), W(3), C(3), F(3), G(3), X(3)
      DOUBLE PRECISION LENGTH, DOT
      INTEGER M, A, B, T, E, I, J, K, L, H, SIDE, OUT
      DO 10 M = 1, N
         CELL(M) = 0.0D0
         OUTER(M) = 0
   10 CONTINUE
      DO 90 M = 1, NEDGE
         A = EDGE(1,M)
         B = EDGE(2,M)
         CALL MINUS(P(1,B), P(1,A), U)
         LENGTH = SQRT(DOT(U, U))
         AREA(M) = 0.0D0
         DO 70 SIDE = 1, 2
            T = AT(M)
            DO 20 E = 1, 6
               CALL AROUND(E, I, J, K, L)
               IF (TET(I,T) .EQ. A .AND. TET(J,T) .EQ. B) GO TO 30
   20       CONTINUE
   30       CONTINUE
C           The first tetrahedron was on the first side already.
            OUT = K
            IF (SIDE .EQ. 2) THEN
               OUT = L
               CALL TURN(TET, ADJ, A, B, T, OUT)
            END IF
   40       CONTINUE
            IF (T .LT. 1) GO TO 70
C           The edge from A to B, or from B to A.
            DO 50 E = 1, 6
               CALL AROUND(E, I, J, K, L)
               IF (TET(I,T) .EQ. A .AND. TET(J,T) .EQ. B) GO TO 60
               IF (TET(I,T) .EQ. B .AND. TET(J,T) .EQ. A) THEN
                  H = K
                  K = L
                  L = H
                  GO TO 60
               END IF
   50       CONTINUE
   60       CONTINUE
            CALL MINUS(P(1,TET(K,T)), P(1,A), V)
            CALL MINUS(P(1,TET(L,T)), P(1,A), W)
            CALL CIRCLE(U, V, F)
            CALL CIRCLE(U, W, G)
            CALL CENTRE(U, V, W, C)
            DO 65 K = 1, 3
               F(K) = F(K) - G(K)
               C(K) = C(K) - U(K) / 2.0D0
   65       CONTINUE
C           From a quadrangle's diagonals.
            CALL CROSS(F, C, X)
            AREA(M) = AREA(M) + DOT(X, U) / (2.0D0*LENGTH)
            CALL TURN(TET, ADJ, A, B, T, OUT)
            IF (T .NE. AT(M)) GO TO 40
            GO TO 80
   70    CONTINUE
         OUTER(A) = 1
         OUTER(B) = 1
   80    CONTINUE
         CELL(A) = CELL(A) + AREA(M)*LENGTH / 6.0D0
         CELL(B) = CELL(B) + AREA(M)*LENGTH / 6.0D0
   90 CONTINUE
      END

C     ---- gradients ----

C     GRADIE - of the field that has the given values at the points and
C     is linear on the tetrahedron whose vertices are V.
      SUBROUTINE GRADIE(P, V, VALUE, G)
      DOUBLE PRECISION P(3,*), VALUE(*), G(3)
      INTEGER V(4)
      DOUBLE PRECISION E(3,3), C(3), DET, DOT
      INTEGER I, K
      DO 10 K = 1, 3
         CALL MINUS(P(1,V(K+1)), P(1,V(1)), E(1,K))
         G(K) = 0.0D0
   10 CONTINUE
      CALL CROSS(E(1,2), E(1,3), C)
      DET = DOT(E(1,1), C)
      DO 30 I = 1, 3
         CALL CROSS(E(1,MOD(I, 3)+1), E(1,MOD(I+1, 3)+1), C)
         DO 20 K = 1, 3
            G(K) = G(K) + (VALUE(V(I+1)) - VALUE(V(1)))*C(K) / DET
   20    CONTINUE
   30 CONTINUE
      END

C     ---- tests ----

C     RANDOM - a random number, 0 <= X < 1, of 26 bits.
      SUBROUTINE RANDOM(SEED, X)
      INTEGER SEED, HIGH
      DOUBLE PRECISION X
      SEED = MOD(SEED*3877 + 29573, 139968)
      HIGH = MOD(SEED, 8192)
      SEED = MOD(SEED*3877 + 29573, 139968)
      X = (DBLE(HIGH) + DBLE(MOD(SEED, 8192)) / 8192.0D0) / 8192.0D0
      END

C     MAKE - points: at random in a cube; on a lattice of 7 a side; at
C     random between two spheres.
      SUBROUTINE MAKE(SET, SEED, N, P)
      INTEGER SET, SEED, N
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION X(3), R, DOT
      INTEGER I, K
      N = 300
      IF (SET .EQ. 2) N = 343
      DO 40 I = 1, N
   10    CONTINUE
         DO 20 K = 1, 3
            CALL RANDOM(SEED, X(K))
            X(K) = 2.0D0*X(K) - 1.0D0
   20    CONTINUE
         IF (SET .EQ. 3 .AND. .NOT. (DOT(X, X) .GT. 0.01D0 .AND.
     1       DOT(X, X) .LT. 1.0D0)) GO TO 10
         R = 1.0D0
         IF (SET .EQ. 3) THEN
            CALL RANDOM(SEED, R)
            R = (0.8D0 + 0.2D0*R) / SQRT(DOT(X, X))
         END IF
         DO 30 K = 1, 3
            P(K,I) = X(K)*R
   30    CONTINUE
         IF (SET .EQ. 2) THEN
            P(1,I) = DBLE(MOD(I-1, 7)) / 8.0D0
            P(2,I) = DBLE(MOD((I-1)/7, 7)) / 8.0D0
            P(3,I) = DBLE((I-1)/49) / 8.0D0
         END IF
   40 CONTINUE
      END

C     HAS - BAD becomes 1 if tetrahedron T has not the vertex I.
      SUBROUTINE HAS(TET, T, I, BAD)
      INTEGER TET(4,*), T, I, BAD
      IF (TET(1,T) .NE. I .AND. TET(2,T) .NE. I .AND. TET(3,T) .NE. I
     1    .AND. TET(4,T) .NE. I) BAD = 1
      END

      SUBROUTINE TEDGES(MOST, N, NTET, TET, NEDGE, EDGE, AT, FIRST,
     1                  NFACE, SEEN, BAD)
      INTEGER MOST, N, NTET, TET(4,*), NEDGE, EDGE(2,*), AT(*), FIRST(*)
      INTEGER NFACE, SEEN(MOST,MOST), BAD
      INTEGER A, B, E, I, J, K, L, T, PAIRS, USED
      DO 20 A = 1, N
         DO 10 B = 1, N
            SEEN(A,B) = 0
   10    CONTINUE
   20 CONTINUE
      PAIRS = 0
      DO 40 T = 1, NTET
         DO 30 E = 1, 6
            CALL AROUND(E, I, J, K, L)
            A = TET(I,T)
            B = TET(J,T)
            IF (SEEN(A,B) .EQ. 0) PAIRS = PAIRS + 1
            SEEN(A,B) = 1
            SEEN(B,A) = 1
   30    CONTINUE
   40 CONTINUE
      IF (PAIRS .NE. NEDGE) BAD = 1
      DO 50 I = 1, NEDGE
         A = EDGE(1,I)
         B = EDGE(2,I)
         IF (SEEN(A,B) .NE. 1) BAD = 1
         SEEN(A,B) = 2
         SEEN(B,A) = 2
         CALL HAS(TET, AT(I), A, BAD)
         CALL HAS(TET, AT(I), B, BAD)
   50 CONTINUE
C     Euler: a ball.
      USED = 0
      DO 60 I = 1, N
         IF (FIRST(I+1) .GT. FIRST(I)) USED = USED + 1
   60 CONTINUE
      IF (USED - NEDGE + NFACE - NTET .NE. 1) BAD = 1
      END

      SUBROUTINE TFACES(NTET, TET, NFACE, FACE, BOTH, NHULL, BAD)
      INTEGER NTET, TET(4,*), NFACE, FACE(3,*), BOTH(2,*), NHULL, BAD
      INTEGER I, K, BOUND
      BOUND = 0
      DO 20 I = 1, NFACE
         DO 10 K = 1, 3
            CALL HAS(TET, BOTH(1,I), FACE(K,I), BAD)
            IF (BOTH(2,I) .GT. 0)
     1         CALL HAS(TET, BOTH(2,I), FACE(K,I), BAD)
   10    CONTINUE
         IF (BOTH(1,I) .EQ. BOTH(2,I)) BAD = 1
         IF (BOTH(2,I) .EQ. 0) BOUND = BOUND + 1
   20 CONTINUE
      IF (BOUND .NE. NHULL .OR. 2*NFACE .NE. 4*NTET + NHULL) BAD = 1
      END

      SUBROUTINE TSTARS(N, NTET, TET, FIRST, LIST, BAD)
      INTEGER N, NTET, TET(4,*), FIRST(*), LIST(*), BAD
      INTEGER I, J
      IF (FIRST(1) .NE. 1 .OR. FIRST(N+1) .NE. 4*NTET + 1) BAD = 1
      DO 20 I = 1, N
         DO 10 J = FIRST(I), FIRST(I+1) - 1
            CALL HAS(TET, LIST(J), I, BAD)
            IF (J .GT. FIRST(I)) THEN
               IF (LIST(J) .LE. LIST(J-1)) BAD = 1
            END IF
   10    CONTINUE
   20 CONTINUE
      END

      SUBROUTINE TNEAR(N, P, TET, FIRST, LIST, SEED, BAD)
      INTEGER N, TET(4,*), FIRST(*), LIST(*), SEED, BAD
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION Q(3), E(3), LEAST, DOT
      INTEGER I, J, K, V
      DO 30 J = 1, 1000
         DO 10 K = 1, 3
            CALL RANDOM(SEED, Q(K))
            Q(K) = 3.0D0*Q(K) - 1.0D0
   10    CONTINUE
         IF (MOD(J, 2) .EQ. 1) V = TET(1,1)
         CALL NEARPT(P, TET, FIRST, LIST, Q, V)
         CALL MINUS(P(1,V), Q, E)
         LEAST = (1.0D0 - 1.0D-14)*DOT(E, E)
         DO 20 I = 1, N
            CALL MINUS(P(1,I), Q, E)
            IF (DOT(E, E) .LT. LEAST) BAD = 1
   20    CONTINUE
   30 CONTINUE
      END

C     WHOLE - the volume of the hull, from its facets.
      DOUBLE PRECISION FUNCTION WHOLE(P, NHULL, HULL)
      DOUBLE PRECISION P(3,*)
      INTEGER NHULL, HULL(3,*)
      DOUBLE PRECISION A(3,3), D(3), DOT
      INTEGER I, J, K
      WHOLE = 0.0D0
      DO 30 I = 1, NHULL
         DO 20 J = 1, 3
            DO 10 K = 1, 3
               A(K,J) = P(K,HULL(J,I)) - P(K,1)
   10       CONTINUE
   20    CONTINUE
         CALL CROSS(A(1,2), A(1,3), D)
         WHOLE = WHOLE + DOT(A(1,1), D) / 6.0D0
   30 CONTINUE
      END

C     The centre of a tetrahedron of size 1 and volume V is known to
C     about eps / V**2 at worst: where that is too little nothing is
C     asked.
      SUBROUTINE TMEASU(N, P, NTET, TET, NHULL, HULL, BAD)
      INTEGER N, NTET, TET(4,*), NHULL, HULL(3,*), BAD
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION VOLUME, C(3), RADIUS, D(3), SUM, FAR, SLACK
      DOUBLE PRECISION DOT, WHOLE
      INTEGER T, I, OTHER
      SUM = 0.0D0
      DO 20 T = 1, NTET
         CALL MEASUR(P, TET(1,T), VOLUME, C, RADIUS)
         IF (.NOT. (VOLUME .GT. 0.0D0)) BAD = 1
         SUM = SUM + VOLUME
         SLACK = 1.0D-15*(1.0D0 + RADIUS) / VOLUME**2
C        No point is in the ball, the vertices are on it.
         DO 10 I = 1, N
            CALL MINUS(P(1,I), C, D)
            FAR = SQRT(DOT(D, D)) - RADIUS
            OTHER = 0
            CALL HAS(TET, T, I, OTHER)
            IF (FAR .LT. -SLACK) BAD = 1
            IF (OTHER .EQ. 0 .AND. FAR .GT. SLACK) BAD = 1
   10    CONTINUE
   20 CONTINUE
      IF (ABS(SUM - WHOLE(P, NHULL, HULL)) .GT. 1.0D-11) BAD = 1
      END

C     The cells fill the hull; the faces of a cell that has an end are
C     closed: the sum of their normals times areas is 0; on the lattice,
C     of spacing 1/8, a cell is a cube, and of the edges those along the
C     axes alone have a face.
      SUBROUTINE TDUAL(N, P, SET, NEDGE, EDGE, AREA, CELL, OUTER, NHULL,
     1                 HULL, FLUX, BAD)
      INTEGER N, SET, NEDGE, EDGE(2,*), OUTER(*), NHULL, HULL(3,*), BAD
      DOUBLE PRECISION P(3,*), AREA(*), CELL(*), FLUX(3,*)
      DOUBLE PRECISION SUM, E(3), LENGTH, WANT, ROUND, DOT, WHOLE
      INTEGER A, B, I, K, INNER
      ROUND = 1.0D-11
      DO 20 I = 1, N
         DO 10 K = 1, 3
            FLUX(K,I) = 0.0D0
   10    CONTINUE
   20 CONTINUE
      DO 40 I = 1, NEDGE
         A = EDGE(1,I)
         B = EDGE(2,I)
         CALL MINUS(P(1,B), P(1,A), E)
         LENGTH = SQRT(DOT(E, E))
         DO 30 K = 1, 3
            FLUX(K,A) = FLUX(K,A) + E(K)*AREA(I) / LENGTH
            FLUX(K,B) = FLUX(K,B) - E(K)*AREA(I) / LENGTH
   30    CONTINUE
         WANT = 1.0D0 / 64.0D0
         IF (LENGTH .GT. 0.13D0) WANT = 0.0D0
         IF (OUTER(A) .EQ. 0) THEN
            IF (SET .EQ. 2 .AND. ABS(AREA(I) - WANT) .GT. ROUND) BAD = 1
            IF (AREA(I) .LT. -ROUND) BAD = 1
         END IF
   40 CONTINUE
      SUM = 0.0D0
      INNER = 0
      DO 60 I = 1, N
         SUM = SUM + CELL(I)
         IF (OUTER(I) .EQ. 1) GO TO 60
         INNER = INNER + 1
         DO 50 K = 1, 3
            IF (ABS(FLUX(K,I)) .GT. ROUND) BAD = 1
   50    CONTINUE
         IF (.NOT. (CELL(I) .GT. 0.0D0)) BAD = 1
         IF (SET .EQ. 2 .AND. ABS(CELL(I) - 1.0D0/512.0D0) .GT. ROUND)
     1      BAD = 1
   60 CONTINUE
      DO 70 I = 1, NHULL
         IF (OUTER(HULL(1,I)) .EQ. 0) BAD = 1
   70 CONTINUE
      IF (SET .EQ. 2 .AND. INNER .NE. 125) BAD = 1
      IF (ABS(SUM - WHOLE(P, NHULL, HULL)) .GT. ROUND) BAD = 1
      END

C     A linear field's gradient comes out as it is; of any field, the
C     gradient times an edge is the difference along it.
      SUBROUTINE TGRADI(N, P, NTET, TET, VALUE, SEED, BAD)
      INTEGER N, NTET, TET(4,*), SEED, BAD
      DOUBLE PRECISION P(3,*), VALUE(*)
      DOUBLE PRECISION G(3), E(3), C(3), WANT(3), VOLUME, RADIUS, DOT
      INTEGER T, I, K
      SAVE WANT
      DATA WANT /2.0D0, -3.0D0, 0.5D0/
      DO 10 I = 1, N
         VALUE(I) = 7.0D0 + DOT(WANT, P(1,I))
   10 CONTINUE
      DO 30 T = 1, NTET
         CALL MEASUR(P, TET(1,T), VOLUME, C, RADIUS)
         CALL GRADIE(P, TET(1,T), VALUE, G)
         DO 20 K = 1, 3
            IF (ABS(G(K) - WANT(K)) .GT. 1.0D-14 / VOLUME) BAD = 1
   20    CONTINUE
   30 CONTINUE
      DO 40 I = 1, N
         CALL RANDOM(SEED, VALUE(I))
   40 CONTINUE
      DO 60 T = 1, NTET
         CALL MEASUR(P, TET(1,T), VOLUME, C, RADIUS)
         CALL GRADIE(P, TET(1,T), VALUE, G)
         DO 50 K = 2, 4
            CALL MINUS(P(1,TET(K,T)), P(1,TET(1,T)), E)
            IF (ABS(DOT(G, E) + VALUE(TET(1,T)) - VALUE(TET(K,T))) .GT.
     1          1.0D-14 / VOLUME) BAD = 1
   50    CONTINUE
   60 CONTINUE
      END
