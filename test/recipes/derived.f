C     derived.f - what can be had from TET and ADJ: recipes to copy.
C
C     Each routine stands for itself: it needs P, TET and ADJ, the
C     caller's arrays for its result, and what is named with it.  Open
C     facets of an unfinished result count as hull.  Duplicates (IW(I)
C     .NE. I) are in no tetrahedron.
C
C       TREDGE  each edge once, and a tetrahedron that has it  (TRTURN,
C               TRAROU)
C       TRFACE  each facet once, and the tetrahedra on both sides
C       TRSTAR  for each point the tetrahedra that have it, in rows
C       TRNEAR  the point of P nearest to another one  (TRSTAR's rows)
C       TRMEAS  volume, circumcentre and circumradius of a tetrahedron
C               (TRMIND, TRDOTD, TRCROD, TRSHRI, TRCIRC, TRCEND)
C       TRDUAL  area of each edge's dual face and volume of each point's
C               cell in the Voronoi diagram  (TRTURN, TRAROU, and
C               TRMEAS's six)
C       TRGRAD  of a field linear on a tetrahedron  (TRMIND, TRDOTD,
C               TRCROD)
C
C     derived.c is the same in C.

C     ---- edges ----

C     TRTURN - about the edge A B, from tetrahedron T across its facet
C     opposite to its vertex number OUT, which is neither A nor B.  On
C     return T is the neighbour, and OUT where to go on; or T < 1: the
C     hull.
      SUBROUTINE TRTURN(TET, ADJ, A, B, T, OUT)
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

C     TRAROU - edge E, 1 to 6, of a tetrahedron: from its vertex number
C     I to J, and from K to L counter-clockwise about it.
      SUBROUTINE TRAROU(E, I, J, K, L)
      INTEGER E, I, J, K, L
      INTEGER TABLE(4,6)
      SAVE TABLE
      DATA TABLE /1,2,3,4, 1,3,4,2, 1,4,2,3, 2,3,1,4, 2,4,3,1, 3,4,1,2/
      I = TABLE(1,E)
      J = TABLE(2,E)
      K = TABLE(3,E)
      L = TABLE(4,E)
      END

C     TREDGE - each edge once: in the ring of tetrahedra about it the
C     first one tells of it.
C
C       NTET, TET, ADJ  (in)  a mesh, as from TESS
C       MAXEDG  (in)   edges that there is room for
C       NEDGE   (out)  number of edges
C       EDGE    (out)  (2,MAXEDG): the two points of each
C       AT      (out)  (MAXEDG): a tetrahedron that has it
C       INFO    (out)  0, or 1: NEDGE is then the number needed
C
C     N random points have about 7.8 N edges.
C     Cost: each edge's ring, of about 5 tetrahedra, once for each of
C     them.
      SUBROUTINE TREDGE(NTET, TET, ADJ, MAXEDG, NEDGE, EDGE, AT, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), MAXEDG, NEDGE, EDGE(2,*), AT(*)
      INTEGER INFO
      INTEGER T, S, A, B, E, I, J, K, L, SIDE, OUT
      NEDGE = 0
      DO 40 T = 1, NTET
         DO 30 E = 1, 6
            CALL TRAROU(E, I, J, K, L)
            A = TET(I,T)
            B = TET(J,T)
C           To one side, and where that ends at the hull to the other.
            DO 20 SIDE = 1, 2
               S = T
               OUT = K
               IF (SIDE .EQ. 2) OUT = L
   10          CONTINUE
               CALL TRTURN(TET, ADJ, A, B, S, OUT)
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

C     TRFACE - each facet once, with the tetrahedra that have it.
C
C       NTET, TET, ADJ  (in)  a mesh, as from TESS
C       MAXFAC  (in)   faces that there is room for; 4*NTET always
C                      suffice
C       NFACE   (out)  number of faces
C       FACE    (out)  (3,MAXFAC): its vertices, counter-clockwise as
C                      seen from outside of the first tetrahedron
C       BOTH    (out)  (2,MAXFAC): the first tetrahedron and the other
C                      one, or 0 on the hull
C       INFO    (out)  0, or 1: NFACE is then the number needed
C
C     Cost: one pass.
      SUBROUTINE TRFACE(NTET, TET, ADJ, MAXFAC, NFACE, FACE, BOTH, INFO)
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

C     TRSTAR - for each point the tetrahedra that have it.
C
C       N, NTET, TET  (in)  number of points, and a mesh of them
C       FIRST   (out)  (N+1): those of point I are LIST(FIRST(I)) ...
C                      LIST(FIRST(I+1) - 1), in ascending order; none
C                      for a duplicate
C       LIST    (out)  (4*NTET)
C
C     Cost: two passes.
      SUBROUTINE TRSTAR(N, NTET, TET, FIRST, LIST)
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

C     TRNEAR - the point of P nearest to Q.
C
C       P, TET       (in)      points and mesh
C       FIRST, LIST  (in)      as TRSTAR gives them
C       Q            (in)      (3) the place
C       V            (in,out)  where to start: a point of some
C                              tetrahedron, best a vertex of the one
C                              that TESSLO finds, or the last answer;
C                              the nearest
C
C     It goes to ever nearer neighbours: in a Delaunay
C     tetrahedralization the point that has no nearer neighbour is the
C     nearest.
C     Cost: the stars of the points on the way, about 24 tetrahedra
C     each.
      SUBROUTINE TRNEAR(P, TET, FIRST, LIST, Q, V)
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER TET(4,*), FIRST(*), LIST(*), V
      DOUBLE PRECISION LEAST, D, E(3), TRDOTD
      INTEGER FROM, I, K, W
      CALL TRMIND(P(1,V), Q, E)
      LEAST = TRDOTD(E, E)
   10 CONTINUE
      FROM = V
      DO 30 I = FIRST(FROM), FIRST(FROM+1) - 1
         DO 20 K = 1, 4
            W = TET(K,LIST(I))
            CALL TRMIND(P(1,W), Q, E)
            D = TRDOTD(E, E)
            IF (D .LT. LEAST) THEN
               LEAST = D
               V = W
            END IF
   20    CONTINUE
   30 CONTINUE
      IF (V .NE. FROM) GO TO 10
      END

C     ---- measures ----

      SUBROUTINE TRMIND(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      INTEGER K
      DO 10 K = 1, 3
         C(K) = A(K) - B(K)
   10 CONTINUE
      END

      DOUBLE PRECISION FUNCTION TRDOTD(A, B)
      DOUBLE PRECISION A(3), B(3)
      TRDOTD = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

      SUBROUTINE TRCROD(A, B, C)
      DOUBLE PRECISION A(3), B(3), C(3)
      C(1) = A(2)*B(3) - A(3)*B(2)
      C(2) = A(3)*B(1) - A(1)*B(3)
      C(3) = A(1)*B(2) - A(2)*B(1)
      END

C     TRSHRI - three vectors, to a length of about 1: products of many
C     of 1D100 or 1D-100 would be beyond numbers.  UNIT is a power of
C     two.
      SUBROUTINE TRSHRI(E, UNIT)
      DOUBLE PRECISION E(3,3), UNIT
      DOUBLE PRECISION MOST
      INTEGER I, K
      MOST = 0.0D0
      DO 20 I = 1, 3
         DO 10 K = 1, 3
            MOST = MAX(MOST, ABS(E(K,I)))
   10    CONTINUE
   20 CONTINUE
      UNIT = 1.0D0
      IF (MOST .GT. 0.0D0) UNIT = 2.0D0**INT(LOG(MOST) / LOG(2.0D0))
      DO 40 I = 1, 3
         DO 30 K = 1, 3
            E(K,I) = E(K,I) / UNIT
   30    CONTINUE
   40 CONTINUE
      END

C     TRCIRC - centre of the circle through 0, U, V.
      SUBROUTINE TRCIRC(U, V, C)
      DOUBLE PRECISION U(3), V(3), C(3)
      DOUBLE PRECISION NORMAL(3), X(3), TRDOTD
      INTEGER K
      CALL TRCROD(U, V, NORMAL)
      DO 10 K = 1, 3
         X(K) = (TRDOTD(U, U)*V(K) - TRDOTD(V, V)*U(K)) /
     1          (2.0D0*TRDOTD(NORMAL, NORMAL))
   10 CONTINUE
      CALL TRCROD(X, NORMAL, C)
      END

C     TRCEND - of the ball through 0, U, V, W.  Of four points that are
C     in one plane but for rounding a ball's centre cannot be told; that
C     of the circle through three of them will do.
      SUBROUTINE TRCEND(U, V, W, C)
      DOUBLE PRECISION U(3), V(3), W(3), C(3)
      DOUBLE PRECISION VW(3), WU(3), UV(3), UU, VV, WW, DET, TRDOTD
      INTEGER K
      CALL TRCROD(V, W, VW)
      CALL TRCROD(W, U, WU)
      CALL TRCROD(U, V, UV)
      DET = TRDOTD(U, VW)
      UU = TRDOTD(U, U)
      VV = TRDOTD(V, V)
      WW = TRDOTD(W, W)
      IF (DET .LE. 1.0D-13*SQRT(UU*VV*WW)) THEN
         CALL TRCIRC(U, V, C)
         RETURN
      END IF
      DO 10 K = 1, 3
         C(K) = (UU*VW(K) + VV*WU(K) + WW*UV(K)) / (2.0D0*DET)
   10 CONTINUE
      END

C     TRMEAS - a tetrahedron's volume and circumsphere.
C
C       P, V    (in)   points, and (4) the vertices
C       VOLUME  (out)  positive in a mesh, but for rounding
C       MIDDLE  (out)  (3) the circumcentre; of vertices that are
C                      coplanar but for rounding, that of the circle
C                      through three of them
C       RADIUS  (out)  its radius
C
C     For a circumsphere that is right to rounding: TESSBA.
      SUBROUTINE TRMEAS(P, V, VOLUME, MIDDLE, RADIUS)
      DOUBLE PRECISION P(3,*), VOLUME, MIDDLE(3), RADIUS
      INTEGER V(4)
      DOUBLE PRECISION E(3,3), C(3), UNIT, TRDOTD
      INTEGER K
      DO 10 K = 1, 3
         CALL TRMIND(P(1,V(K+1)), P(1,V(1)), E(1,K))
   10 CONTINUE
      CALL TRCROD(E(1,2), E(1,3), C)
      VOLUME = TRDOTD(E(1,1), C) / 6.0D0
      CALL TRSHRI(E, UNIT)
      CALL TRCEND(E(1,1), E(1,2), E(1,3), C)
      DO 20 K = 1, 3
         MIDDLE(K) = P(K,V(1)) + C(K)*UNIT
   20 CONTINUE
      RADIUS = SQRT(TRDOTD(C, C))*UNIT
      END

C     ---- the Voronoi diagram ----

C     TRDUAL - for finite volumes: what lies between the cells of two
C     points, and the cells.
C
C       N, P, TET, ADJ   (in)   points and mesh
C       NEDGE, EDGE, AT  (in)   as TREDGE gives them
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
C     Cost: each edge's ring once.
      SUBROUTINE TRDUAL(N, P, TET, ADJ, NEDGE, EDGE, AT, AREA, CELL,
     1                  OUTER)
      INTEGER N, TET(4,*), ADJ(4,*), NEDGE, EDGE(2,*), AT(*), OUTER(*)
      DOUBLE PRECISION P(3,*), AREA(*), CELL(*)
      DOUBLE PRECISION U(3,3), C(3), F(3), G(3), X(3), LENGTH, UNIT
      DOUBLE PRECISION TRDOTD
      INTEGER M, A, B, T, E, I, J, K, L, H, SIDE, OUT
      DO 10 M = 1, N
         CELL(M) = 0.0D0
         OUTER(M) = 0
   10 CONTINUE
      DO 90 M = 1, NEDGE
         A = EDGE(1,M)
         B = EDGE(2,M)
         CALL TRMIND(P(1,B), P(1,A), X)
         LENGTH = SQRT(TRDOTD(X, X))
         AREA(M) = 0.0D0
         DO 70 SIDE = 1, 2
            T = AT(M)
            DO 20 E = 1, 6
               CALL TRAROU(E, I, J, K, L)
               IF (TET(I,T) .EQ. A .AND. TET(J,T) .EQ. B) GO TO 30
   20       CONTINUE
   30       CONTINUE
C           The first tetrahedron was on the first side already.
            OUT = K
            IF (SIDE .EQ. 2) THEN
               OUT = L
               CALL TRTURN(TET, ADJ, A, B, T, OUT)
            END IF
   40       CONTINUE
            IF (T .LT. 1) GO TO 70
C           The edge from A to B, or from B to A.
            DO 50 E = 1, 6
               CALL TRAROU(E, I, J, K, L)
               IF (TET(I,T) .EQ. A .AND. TET(J,T) .EQ. B) GO TO 60
               IF (TET(I,T) .EQ. B .AND. TET(J,T) .EQ. A) THEN
                  H = K
                  K = L
                  L = H
                  GO TO 60
               END IF
   50       CONTINUE
   60       CONTINUE
            CALL TRMIND(P(1,B), P(1,A), U(1,1))
            CALL TRMIND(P(1,TET(K,T)), P(1,A), U(1,2))
            CALL TRMIND(P(1,TET(L,T)), P(1,A), U(1,3))
            CALL TRSHRI(U, UNIT)
            CALL TRCIRC(U(1,1), U(1,2), F)
            CALL TRCIRC(U(1,1), U(1,3), G)
            CALL TRCEND(U(1,1), U(1,2), U(1,3), C)
            DO 65 K = 1, 3
               F(K) = F(K) - G(K)
               C(K) = C(K) - U(K,1) / 2.0D0
   65       CONTINUE
C           From a quadrangle's diagonals.
            CALL TRCROD(F, C, X)
            AREA(M) = AREA(M) +
     1         TRDOTD(X, U(1,1)) / (2.0D0*LENGTH/UNIT)*UNIT*UNIT
            CALL TRTURN(TET, ADJ, A, B, T, OUT)
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

C     TRGRAD - of a field that is linear on a tetrahedron.
C
C       P, V   (in)   points, and (4) the vertices
C       VALUE  (in)   VALUE(I) is that of point I
C       G      (out)  (3) the derivatives by X, Y, Z.  In flat
C                     tetrahedra they are often far steeper than the
C                     field: TRSLOP has better ones
      SUBROUTINE TRGRAD(P, V, VALUE, G)
      DOUBLE PRECISION P(3,*), VALUE(*), G(3)
      INTEGER V(4)
      DOUBLE PRECISION E(3,3), C(3), DET, TRDOTD
      INTEGER I, K
      DO 10 K = 1, 3
         CALL TRMIND(P(1,V(K+1)), P(1,V(1)), E(1,K))
         G(K) = 0.0D0
   10 CONTINUE
      CALL TRCROD(E(1,2), E(1,3), C)
      DET = TRDOTD(E(1,1), C)
      DO 30 I = 1, 3
         CALL TRCROD(E(1,MOD(I, 3)+1), E(1,MOD(I+1, 3)+1), C)
         DO 20 K = 1, 3
            G(K) = G(K) + (VALUE(V(I+1)) - VALUE(V(1)))*C(K) / DET
   20    CONTINUE
   30 CONTINUE
      END
