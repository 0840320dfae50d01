C     cells.f - Voronoi cells, clipped to a box, and alpha shapes:
C     recipes to copy.
C
C         gfortran -O2 test/examples/cells.f f77/tess.f f77/hhpred.f
C
C       CELL    the Voronoi cell of a point: a polyhedron, its vertices,
C               faces and neighbours, its volume; clipped to a box
C               (STARS, MOST3, MEET)
C       CLIPPE  for finite volumes: all cells' volumes, and the areas of
C               their faces, clipped to a box  (CELL)
C       ALPHA   the part of the mesh whose tetrahedra have small balls,
C               and its boundary
C
C     The main program tests them.  cells.c is the same in C; both write
C     the same text.
      PROGRAM CELLST
      INTEGER BAD(5), I, SEED
      CHARACTER*48 TESTED(5)
      CHARACTER*3 ANSWER(0:1)
      DATA ANSWER /'yes', 'NO'/
      DATA TESTED /
     1   'cell: polyhedra, Voronoi''s, and fill the box:   ',
     2   'clipped: the same from both sides, fill the box:',
     3   'alpha: volumes by tetrahedra and triangles:     ',
     4   'sizes: coordinates of 1e-50 and 1e50:           ',
     5   'codes: short arrays, damage, unfinished meshes: '/
      DO 10 I = 1, 5
         BAD(I) = 0
   10 CONTINUE
      SEED = 1
      CALL TCELL(SEED, BAD(1))
      CALL TCLIPP(SEED, BAD(2))
      CALL TALPHA(SEED, BAD(3))
      CALL TSIZES(SEED, BAD(4))
      CALL TCODES(SEED, BAD(5))
      DO 20 I = 1, 5
         WRITE (*, 30) TESTED(I), ANSWER(BAD(I))
   20 CONTINUE
   30 FORMAT (A48, 2X, A)
      END

C     ---- cell ----

C     STARS - for each point the tetrahedra that have it, as in
C     derived.f.
C
C       FIRST   (out)  (N+1): those of point I are LIST(FIRST(I)) ...
C                      LIST(FIRST(I+1) - 1)
C       LIST    (out)  (4*NTET)
C       INFO    (out)  0, or 10: a vertex out of range
      SUBROUTINE STARS(N, NTET, TET, FIRST, LIST, INFO)
      INTEGER N, NTET, TET(4,*), FIRST(*), LIST(*), INFO
      INTEGER I, K, T
      INFO = 10
      DO 20 T = 1, NTET
         DO 10 K = 1, 4
            IF (TET(K,T) .LT. 1 .OR. TET(K,T) .GT. N) RETURN
   10    CONTINUE
   20 CONTINUE
      INFO = 0
      DO 30 I = 1, N + 1
         FIRST(I) = 0
   30 CONTINUE
      DO 50 T = 1, NTET
         DO 40 K = 1, 4
            FIRST(TET(K,T)) = FIRST(TET(K,T)) + 1
   40    CONTINUE
   50 CONTINUE
      FIRST(1) = FIRST(1) + 1
      DO 60 I = 2, N + 1
         FIRST(I) = FIRST(I) + FIRST(I-1)
   60 CONTINUE
      DO 80 T = NTET, 1, -1
         DO 70 K = 4, 1, -1
            I = TET(K,T)
            FIRST(I) = FIRST(I) - 1
            LIST(FIRST(I)) = T
   70    CONTINUE
   80 CONTINUE
      END

      DOUBLE PRECISION FUNCTION MOST3(A)
      DOUBLE PRECISION A(3)
      MOST3 = MAX(ABS(A(1)), ABS(A(2)), ABS(A(3)))
      END

C     MEET - the common point X of three planes, normal.X = offset, of
C     which it is known that it lies between U and V, near the latter's
C     share S.  The planes give it to rounding of the offsets over their
C     determinant, U and V to that of their distance: the better one is
C     taken.
      SUBROUTINE MEET(A, B, C, U, V, S, X)
      DOUBLE PRECISION A(4), B(4), C(4), U(3), V(3), S, X(3)
      DOUBLE PRECISION BC(3), CA(3), AB(3), D(3), H(3), DET, MOST3
      INTEGER K, L, M
      DO 10 K = 1, 3
         L = MOD(K, 3) + 1
         M = MOD(K + 1, 3) + 1
         BC(K) = B(L)*C(M) - B(M)*C(L)
         CA(K) = C(L)*A(M) - C(M)*A(L)
         AB(K) = A(L)*B(M) - A(M)*B(L)
         D(K) = V(K) - U(K)
         X(K) = U(K) + S*D(K)
   10 CONTINUE
      H(1) = A(4)
      H(2) = B(4)
      H(3) = C(4)
      DET = A(1)*BC(1) + A(2)*BC(2) + A(3)*BC(3)
      IF (S .GT. 0.0D0 .AND. MOST3(H) .LT. ABS(DET)*MOST3(D)) THEN
         DO 20 K = 1, 3
            X(K) = (H(1)*BC(K) + H(2)*CA(K) + H(3)*AB(K)) / DET
   20    CONTINUE
      END IF
      END

C     CELL - the Voronoi cell of point I: what is nearer to it than to
C     any other.
C
C       P, TET, ADJ, FIRST, LIST  (in)  points, mesh, and stars of it
C       I       (in)   the point
C       BOX     (in)   lower X, Y, Z and upper X, Y, Z: the cell is
C                      clipped to it.  BOX(1) > BOX(4): not at all.
C                      Need not hold the point
C       MOST    (in)   faces that there is room for; 8 more than
C                      tetrahedra at I suffice
C       NFACE   (out)  number of faces
C       WHOSE   (out)  (MOST): the neighbour across each, or -1 ... -6
C                      for the box's side at lower X, Y, Z, upper X, Y,
C                      Z
C       AREA    (out)  (MOST): of each face
C       VOLUME  (out)  of the cell
C       START   (out)  (MOST+1): face F has the vertices
C                      CORNER(START(F)) ... CORNER(START(F+1) - 1), seen
C                      counter-clockwise from outside
C       CORNER  (out)  (6*MOST)
C       NVERT   (out)  number of vertices: circumcentres, and where the
C                      box cuts
C       VERT    (out)  (3,3*MOST): the first NVERT are set
C       IWORK   (out)  (4,3*MOST)
C       WORK    (out)  (7,MOST)
C       INFO    (out)  0; 1 when MOST is too small: NFACE is then a
C                      number that suffices; 2 for a cell that has no
C                      end, or none that rounding can tell, and there is
C                      no box; 13 at an open facet
C
C     A duplicate has no tetrahedra: its cell is that of IW(I), and
C     NFACE = 0, VOLUME = 0 here.
C     Cost: some 25 microseconds in a cloud; O(M**2) for M neighbours.
C
C     The box, or one that is made larger until nothing is left of its
C     sides, is cut by the plane midway to each neighbour, the nearest
C     first.  A vertex is kept as the three planes A, B, C that meet
C     there, counter-clockwise seen from outside: its neighbour along
C     the edge of A and B has B before A.  So what is cut off is known
C     by the vertices' signs alone, and the rest stays a closed surface,
C     whatever rounding does; new vertices are on edges between old
C     ones.  Vertices that a plane passes within 1D-13 of their distance
C     stay, so that a plane that only touches the cell, as in a lattice,
C     cuts nothing; at the end vertices that agree to 1D-12 become one,
C     and faces of fewer than three go.  A vertex is known to rounding
C     over the angles between its planes: where two points are 1D-7
C     apart, others' faces end between them to 1D-9; what one cell loses
C     by that its neighbour gains.
C
C     In IWORK a vertex's planes, and its number among those that
C     remain; in WORK the planes, and three vertices' heights over one.
      SUBROUTINE CELL(P, TET, ADJ, FIRST, LIST, I, BOX, MOST, NFACE,
     1                WHOSE, AREA, VOLUME, START, CORNER, NVERT, VERT,
     2                IWORK, WORK, INFO)
      INTEGER TET(4,*), ADJ(4,*), FIRST(*), LIST(*), I, MOST, NFACE
      INTEGER WHOSE(*), START(*), CORNER(*), NVERT, IWORK(4,*), INFO
      DOUBLE PRECISION P(3,*), BOX(6), AREA(*), VOLUME, VERT(3,*)
      DOUBLE PRECISION WORK(7,*)
      DOUBLE PRECISION E(3), X(3), R, S, H, HU, HV, LIMIT, MOST3
      INTEGER PLANES, MANY, J, T, U, V, A, B, C, OLD, FREE, K, L, M, CUT
      NFACE = 0
      NVERT = 0
      VOLUME = 0.0D0
      START(1) = 1
      INFO = 0
      IF (FIRST(I+1) .EQ. FIRST(I)) RETURN
      INFO = 1
      IF (MOST .LT. FIRST(I+1) - FIRST(I) + 8) THEN
         NFACE = FIRST(I+1) - FIRST(I) + 8
         RETURN
      END IF
      FREE = 0
      IF (.NOT. (BOX(1) .LE. BOX(4))) FREE = 1
C     Neighbours, by insertion.
      PLANES = 6
      DO 80 J = FIRST(I), FIRST(I+1) - 1
         T = LIST(J)
         DO 70 K = 1, 4
            V = TET(K,T)
            IF (V .EQ. I) GO TO 70
            INFO = 13
            IF (ADJ(K,T) .EQ. -1) RETURN
            INFO = 2
            IF (ADJ(K,T) .LT. 1 .AND. FREE .EQ. 1) RETURN
            DO 10 A = 7, PLANES
               IF (WHOSE(A) .EQ. V) GO TO 70
   10       CONTINUE
            DO 20 L = 1, 3
               E(L) = P(L,V) - P(L,I)
   20       CONTINUE
            R = SQRT(E(1)**2 + E(2)**2 + E(3)**2)
            PLANES = PLANES + 1
            A = PLANES
   30       CONTINUE
            IF (A .GT. 7) THEN
               IF (WORK(4,A-1) .GT. R / 2.0D0) THEN
                  WHOSE(A) = WHOSE(A-1)
                  DO 40 L = 1, 4
                     WORK(L,A) = WORK(L,A-1)
   40             CONTINUE
                  A = A - 1
                  GO TO 30
               END IF
            END IF
            WHOSE(A) = V
            DO 50 L = 1, 3
               WORK(L,A) = E(L) / R
   50       CONTINUE
            WORK(4,A) = R / 2.0D0
   70    CONTINUE
   80 CONTINUE
      LIMIT = 4.0D0*WORK(4,PLANES)
C     Again, where the box was too small.
   90 CONTINUE
      MANY = 8
      DO 110 A = 1, 6
         WHOSE(A) = -A
         K = MOD(A - 1, 3) + 1
         DO 100 L = 1, 3
            WORK(L,A) = 0.0D0
  100    CONTINUE
         S = 1.0D0
         IF (A .LE. 3) S = -1.0D0
         WORK(K,A) = S
         WORK(4,A) = LIMIT
         IF (FREE .EQ. 0) WORK(4,A) = S*(BOX(A) - P(K,I))
  110 CONTINUE
      DO 130 V = 1, 8
         CUT = 0
         DO 120 K = 1, 3
            A = K
            IF (MOD((V - 1) / 2**(K-1), 2) .EQ. 1) A = K + 3
            VERT(K,V) = WORK(K,A)*WORK(4,A)
            IF (A .GT. 3) CUT = 1 - CUT
            IWORK(K,V) = A
  120    CONTINUE
         IF (CUT .EQ. 0) THEN
            A = IWORK(1,V)
            IWORK(1,V) = IWORK(2,V)
            IWORK(2,V) = A
         END IF
  130 CONTINUE
      DO 220 J = 7, PLANES
         CUT = 0
         DO 140 V = 1, MANY
            H = VERT(1,V)*WORK(1,J) + VERT(2,V)*WORK(2,J) +
     1          VERT(3,V)*WORK(3,J) - WORK(4,J)
            IF (H .LE. 1.0D-13*MOST3(VERT(1,V))) THEN
               H = MIN(H, 0.0D0)
            ELSE
               CUT = 1
            END IF
            WORK(MOD(V-1, 3) + 5,(V-1) / 3 + 1) = H
  140    CONTINUE
         IF (CUT .EQ. 0) GO TO 220
         OLD = MANY
         DO 190 V = 1, OLD
            HV = WORK(MOD(V-1, 3) + 5,(V-1) / 3 + 1)
            IF (.NOT. (HV .GT. 0.0D0)) GO TO 190
            DO 180 K = 1, 3
               A = IWORK(K,V)
               B = IWORK(MOD(K, 3) + 1,V)
               DO 160 U = 1, OLD
                  DO 150 L = 1, 3
                     IF (IWORK(L,U) .EQ. B .AND.
     1                   IWORK(MOD(L, 3) + 1,U) .EQ. A) GO TO 170
  150             CONTINUE
  160          CONTINUE
               GO TO 180
  170          CONTINUE
               HU = WORK(MOD(U-1, 3) + 5,(U-1) / 3 + 1)
               IF (HU .GT. 0.0D0 .OR. MANY .GE. 3*MOST) GO TO 180
               MANY = MANY + 1
               CALL MEET(WORK(1,A), WORK(1,B), WORK(1,J), VERT(1,U),
     1                   VERT(1,V), -HU / (HV - HU), VERT(1,MANY))
               IWORK(1,MANY) = A
               IWORK(2,MANY) = B
               IWORK(3,MANY) = J
               WORK(MOD(MANY-1, 3) + 5,(MANY-1) / 3 + 1) = 0.0D0
  180       CONTINUE
  190    CONTINUE
         U = 0
         DO 210 V = 1, MANY
            HV = WORK(MOD(V-1, 3) + 5,(V-1) / 3 + 1)
            IF (HV .GT. 0.0D0) GO TO 210
            U = U + 1
            DO 200 K = 1, 3
               VERT(K,U) = VERT(K,V)
               IWORK(K,U) = IWORK(K,V)
  200       CONTINUE
  210    CONTINUE
         MANY = U
  220 CONTINUE
      IF (FREE .EQ. 1) THEN
         DO 240 V = 1, MANY
            DO 230 K = 1, 3
               IF (IWORK(K,V) .LE. 6) THEN
                  INFO = 2
                  IF (LIMIT .GT. 1.0D20*WORK(4,PLANES)) RETURN
                  LIMIT = 1.0D3*LIMIT
                  GO TO 90
               END IF
  230       CONTINUE
  240    CONTINUE
      END IF
      INFO = 0
C     Equal vertices.
      DO 280 V = 1, MANY
         DO 260 U = 1, NVERT
            DO 250 K = 1, 3
               E(K) = VERT(K,V) - VERT(K,U)
  250       CONTINUE
            IF (MOST3(E) .LE. 1.0D-12*MOST3(VERT(1,V))) GO TO 275
  260    CONTINUE
         NVERT = NVERT + 1
         U = NVERT
         DO 270 K = 1, 3
            VERT(K,U) = VERT(K,V)
  270    CONTINUE
  275    CONTINUE
         IWORK(4,V) = U
  280 CONTINUE
C     Each face's vertices, in order.
      DO 400 J = 1, PLANES
         DO 300 V = 1, MANY
            DO 290 K = 1, 3
               IF (IWORK(K,V) .EQ. J) GO TO 310
  290       CONTINUE
  300    CONTINUE
         GO TO 400
  310    CONTINUE
         OLD = V
         C = START(NFACE+1)
  320    CONTINUE
         U = IWORK(4,V)
         CUT = 1
         IF (C .GT. START(NFACE+1)) THEN
            IF (CORNER(C-1) .EQ. U) CUT = 0
         END IF
         IF (CUT .EQ. 1) THEN
            CORNER(C) = U
            C = C + 1
         END IF
         A = IWORK(MOD(K + 1, 3) + 1,V)
         DO 340 V = 1, MANY
            DO 330 K = 1, 3
               IF (IWORK(K,V) .EQ. J .AND.
     1             IWORK(MOD(K, 3) + 1,V) .EQ. A) GO TO 350
  330       CONTINUE
  340    CONTINUE
         V = OLD
  350    CONTINUE
         IF (V .NE. OLD .AND. C .LE. 6*MOST) GO TO 320
         B = START(NFACE+1)
  360    CONTINUE
         IF (C .GT. B) THEN
            IF (CORNER(C-1) .EQ. CORNER(B)) THEN
               C = C - 1
               GO TO 360
            END IF
         END IF
         IF (C - B .LT. 3) GO TO 400
         A = CORNER(B)
         X(1) = 0.0D0
         X(2) = 0.0D0
         X(3) = 0.0D0
         DO 390 T = B + 1, C - 2
            U = CORNER(T)
            V = CORNER(T+1)
            DO 380 K = 1, 3
               L = MOD(K, 3) + 1
               M = MOD(K + 1, 3) + 1
               X(K) = X(K) +
     1            ((VERT(L,U) - VERT(L,A))*(VERT(M,V) - VERT(M,A)) -
     2             (VERT(M,U) - VERT(M,A))*(VERT(L,V) - VERT(L,A))) /
     3            2.0D0
  380       CONTINUE
  390    CONTINUE
         NFACE = NFACE + 1
         AREA(NFACE) = SQRT(X(1)**2 + X(2)**2 + X(3)**2)
         VOLUME = VOLUME + AREA(NFACE)*WORK(4,J) / 3.0D0
         WHOSE(NFACE) = WHOSE(J)
         START(NFACE+1) = C
  400 CONTINUE
      DO 420 V = 1, NVERT
         DO 410 K = 1, 3
            VERT(K,V) = VERT(K,V) + P(K,I)
  410    CONTINUE
  420 CONTINUE
      END

C     ---- clipped ----

C     CLIPPE - for finite volumes: the Voronoi cells of all points,
C     clipped to a box that they fill.
C
C       N, P, TET, ADJ, FIRST, LIST  (in)  points, mesh, and stars of it
C       BOX     (in)   lower X, Y, Z and upper X, Y, Z
C       MAXROW  (in)   faces that there is room for: 16 a point in a
C                      cloud
C       NROW    (out)  number of faces, each of which comes from both
C                      sides; but for code -13 a MOST that suffices
C       ROW     (out)  (N+1): the faces of point I's cell are ROW(I) ...
C                      ROW(I+1) - 1.  A duplicate has none
C       OTHER   (out)  (MAXROW): the point across each face, or
C                      -1 ... -6 for the box's sides, as in CELL
C       AREA    (out)  (MAXROW): of each
C       VOLUME  (out)  (N): of the cells
C       MOST    (in)   the largest number of tetrahedra at a point, and
C                      8
C       IWORK   (out)  (20*MOST+1)
C       WORK    (out)  (17*MOST)
C       INFO    (out)  0; 1 when MAXROW is too small: NROW is then the
C                      number needed; -7 for a box that is none; -13
C                      when MOST is too small; what CELL returns
C
C     All areas and volumes are at least 0, unlike those of DUAL at the
C     hull, and the volumes' sum is the box's.  The face of I and J is
C     at right angles to P(J) - P(I) and midway.
      SUBROUTINE CLIPPE(N, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW,
     1                  ROW, OTHER, AREA, VOLUME, MOST, IWORK, WORK,
     2                  INFO)
      INTEGER N, TET(4,*), ADJ(4,*), FIRST(*), LIST(*), MAXROW, NROW
      INTEGER ROW(*), OTHER(*), MOST, IWORK(*), INFO
      DOUBLE PRECISION P(3,*), BOX(6), AREA(*), VOLUME(*), WORK(*)
      INTEGER I, J, NFACE, NVERT
      NROW = 0
      INFO = -7
      IF (.NOT. (BOX(1) .LE. BOX(4))) RETURN
      ROW(1) = 1
      DO 20 I = 1, N
         CALL CELL(P, TET, ADJ, FIRST, LIST, I, BOX, MOST, NFACE,
     1             IWORK(1), WORK(1), VOLUME(I), IWORK(MOST+1),
     2             IWORK(2*MOST+2), NVERT, WORK(MOST+1),
     3             IWORK(8*MOST+2), WORK(10*MOST+1), INFO)
         IF (INFO .EQ. 1) THEN
            NROW = NFACE
            INFO = -13
         END IF
         IF (INFO .NE. 0) RETURN
         DO 10 J = 1, NFACE
            NROW = NROW + 1
            IF (NROW .LE. MAXROW) THEN
               OTHER(NROW) = IWORK(J)
               AREA(NROW) = WORK(J)
            END IF
   10    CONTINUE
         ROW(I+1) = NROW + 1
   20 CONTINUE
      IF (NROW .GT. MAXROW) INFO = 1
      END

C     ---- alpha ----

C     ALPHA - the alpha shape: what is left of the hull when all
C     tetrahedra whose ball has a radius larger than a given one are
C     eaten, from outside inwards (H. Edelsbrunner, E. P. Muecke, ACM
C     Trans. Graphics 13, 1994).
C
C       P, NTET, TET, ADJ  (in)  points and mesh
C       RADIUS  (in)   the largest double precision number eats nothing
C       VOIDS   (in)   0: voids that are closed stay full; 1: they are
C                      eaten, too
C       KEEP    (out)  (NTET): 1 for the tetrahedra that are left, 0 for
C                      others
C       MAXFAC  (in)   triangles that there is room for
C       NFAC    (out)  number of triangles of the boundary
C       FAC     (out)  (3,MAXFAC): each seen counter-clockwise from
C                      outside, in the order of TESSHU
C       STACK   (out)  (NTET)
C       INFO    (out)  0; 1: NFAC is then the number needed, and KEEP is
C                      set; 14 for a neighbour that is out of range, 13
C                      for an unfinished mesh; what TESSBA returns
C
C     Cost: O(NTET).
      SUBROUTINE ALPHA(P, NTET, TET, ADJ, RADIUS, VOIDS, KEEP, MAXFAC,
     1                 NFAC, FAC, STACK, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), VOIDS, KEEP(*), MAXFAC, NFAC
      INTEGER FAC(3,*), STACK(*), INFO
      DOUBLE PRECISION P(3,*), RADIUS
      DOUBLE PRECISION C(4)
      INTEGER T, U, TOP, I, K, FACET(3,4)
      SAVE FACET
      DATA FACET /2,3,4, 1,4,3, 1,2,4, 1,3,2/
      NFAC = 0
      TOP = 0
C     2: large, not reached yet.
      DO 20 T = 1, NTET
         CALL TESSBA(P, TET(1,T), C, INFO)
         IF (INFO .NE. 0) RETURN
         KEEP(T) = 1
         IF (C(4) .GT. RADIUS) KEEP(T) = 2
         DO 10 K = 1, 4
            U = ADJ(K,T)
            INFO = 13
            IF (U .EQ. -1) RETURN
            INFO = 14
            IF (U .LT. 0 .OR. U .GT. NTET) RETURN
            IF (KEEP(T) .LT. 2 .OR. (U .GE. 1 .AND. VOIDS .EQ. 0))
     1         GO TO 10
            KEEP(T) = 0
            TOP = TOP + 1
            STACK(TOP) = T
   10    CONTINUE
   20 CONTINUE
   30 CONTINUE
      IF (TOP .GT. 0) THEN
         T = STACK(TOP)
         TOP = TOP - 1
         DO 40 K = 1, 4
            U = ADJ(K,T)
            IF (U .LT. 1) GO TO 40
            IF (KEEP(U) .NE. 2) GO TO 40
            KEEP(U) = 0
            TOP = TOP + 1
            STACK(TOP) = U
   40    CONTINUE
         GO TO 30
      END IF
      DO 70 T = 1, NTET
         IF (KEEP(T) .EQ. 2) KEEP(T) = 1
   70 CONTINUE
      DO 100 T = 1, NTET
         IF (KEEP(T) .EQ. 0) GO TO 100
         DO 90 K = 1, 4
            U = ADJ(K,T)
            IF (U .GE. 1) THEN
               IF (KEEP(U) .EQ. 1) GO TO 90
            END IF
            NFAC = NFAC + 1
            IF (NFAC .GT. MAXFAC) GO TO 90
            DO 80 I = 1, 3
               FAC(I,NFAC) = TET(FACET(I,K),T)
   80       CONTINUE
   90    CONTINUE
  100 CONTINUE
      INFO = 0
      IF (NFAC .GT. MAXFAC) INFO = 1
      END

C     ---- tests ----

C     RANDOM - a random number, 0 < X < 1: SEED := 16807 SEED modulo
C     2**31 - 1.
      SUBROUTINE RANDOM(SEED, X)
      INTEGER SEED
      DOUBLE PRECISION X
      SEED = 16807*MOD(SEED, 127773) - 2836*(SEED / 127773)
      IF (SEED .LT. 0) SEED = SEED + 2147483647
      X = DBLE(SEED) / 2147483647.0D0
      END

C     MAKE - points: 1 at random; 2 a lattice; 3 the same turned; 4 at
C     random between two spheres; 5 pairs, duplicates among them; 6
C     four.  In a box about them; that of the lattice so that all cells
C     are cubes.
      SUBROUTINE MAKE(SET, SEED, M, NTET, BAD)
      INTEGER N, LRW, MAXROW, MOST
      PARAMETER (N = 343, LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER SET, SEED, M, NTET, BAD
      DOUBLE PRECISION X(3), R
      INTEGER I, K
      M = 300
      IF (SET .EQ. 2 .OR. SET .EQ. 3) M = 343
      IF (SET .EQ. 6) M = 4
      DO 60 I = 1, M
   10    CONTINUE
         DO 20 K = 1, 3
            CALL RANDOM(SEED, R)
            X(K) = 2.0D0*R - 1.0D0
   20    CONTINUE
         R = SQRT(X(1)**2 + X(2)**2 + X(3)**2)
         IF (SET .EQ. 4) THEN
            IF (.NOT. (R .GT. 0.1D0)) GO TO 10
            DO 30 K = 1, 3
               CALL RANDOM(SEED, VOLUME(1))
               X(K) = X(K)*(1.0D0 + 0.2D0*VOLUME(1)) / (R*1.3D0)
   30       CONTINUE
         END IF
         IF (SET .EQ. 5 .AND. MOD(I, 2) .EQ. 0) THEN
            DO 40 K = 1, 3
               IF (MOD(I, 4) .EQ. 0) X(K) = P(K,I-1) + 1.0D-7*X(K)
               IF (MOD(I, 4) .NE. 0) X(K) = P(K,I-1)
   40       CONTINUE
         END IF
         IF (SET .EQ. 2 .OR. SET .EQ. 3) THEN
            X(1) = DBLE(MOD(I-1, 7) - 3) / 8.0D0
            X(2) = DBLE(MOD((I-1) / 7, 7) - 3) / 8.0D0
            X(3) = DBLE((I-1) / 49 - 3) / 8.0D0
         END IF
         IF (SET .EQ. 3) THEN
            R = X(1)
            X(1) = 0.8D0*R - 0.6D0*X(2)
            X(2) = 0.6D0*R + 0.8D0*X(2)
            R = X(2)
            X(2) = 0.96D0*R - 0.28D0*X(3)
            X(3) = 0.28D0*R + 0.96D0*X(3)
         END IF
         DO 50 K = 1, 3
            P(K,I) = X(K)
   50    CONTINUE
   60 CONTINUE
      DO 70 K = 1, 3
         BOX(K+3) = 0.9D0 + 0.1D0*K
         BOX(K) = -1.125D0
         IF (SET .EQ. 2) THEN
            BOX(K+3) = 7.0D0 / 16.0D0
            BOX(K) = -7.0D0 / 16.0D0
         END IF
   70 CONTINUE
      CALL MESH(M, NTET, BAD)
      END

C     MESH - and its stars.
      SUBROUTINE MESH(M, NTET, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER M, NTET, BAD
      INTEGER INFO
      CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .NE. 0) BAD = 1
      CALL STARS(M, NTET, TET, FIRST, LIST, INFO)
      IF (INFO .NE. 0) BAD = 1
      END

C     ONE - the cell of point I; BOXED = 0: without the box.
      SUBROUTINE ONE(I, BOXED, NFACE, NVERT, V, INFO)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER I, BOXED, NFACE, NVERT, INFO
      DOUBLE PRECISION V
      DOUBLE PRECISION CLIP(6)
      INTEGER K
      DO 10 K = 1, 6
         CLIP(K) = BOX(K)
   10 CONTINUE
      IF (BOXED .EQ. 0) CLIP(1) = CLIP(4) + 1.0D0
      CALL CELL(P, TET, ADJ, FIRST, LIST, I, CLIP, MOST, NFACE, WHOSE,
     1          AREA, V, START, CORNER, NVERT, VERT, IWORK, WORK, INFO)
      END

      DOUBLE PRECISION FUNCTION AWAY(X, Y)
      DOUBLE PRECISION X(3), Y(3)
      AWAY = SQRT((X(1)-Y(1))**2 + (X(2)-Y(2))**2 + (X(3)-Y(3))**2)
      END

C     SOUND - a cell is a polyhedron: Euler's formula, each edge once in
C     both directions; its vertices are as far from the point as from
C     those across their faces, no point is nearer, and none is outside
C     the box; the faces' normals times areas sum to 0.
      SUBROUTINE SOUND(M, I, BOXED, NFACE, NVERT, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER M, I, BOXED, NFACE, NVERT, BAD
      DOUBLE PRECISION SUM(3), R, D, AWAY
      INTEGER F, G, A, B, C, J, K, BACK
      IF (2*(NVERT + NFACE) .NE. 4 + START(NFACE+1) - 1) BAD = 1
      DO 40 F = 1, NFACE
         DO 30 A = START(F), START(F+1) - 1
            B = CORNER(START(F))
            IF (A + 1 .LT. START(F+1)) B = CORNER(A+1)
            BACK = 0
            DO 20 G = 1, NFACE
               DO 10 J = START(G), START(G+1) - 1
                  C = CORNER(START(G))
                  IF (J + 1 .LT. START(G+1)) C = CORNER(J+1)
                  IF (CORNER(J) .EQ. B .AND. C .EQ. CORNER(A))
     1               BACK = BACK + 1
   10          CONTINUE
   20       CONTINUE
            IF (BACK .NE. 1) BAD = 1
            J = WHOSE(F)
            C = CORNER(A)
            IF (J .GE. 1) THEN
               D = AWAY(VERT(1,C), P(1,J)) - AWAY(VERT(1,C), P(1,I))
            ELSE
               D = VERT(MOD(-J-1, 3) + 1,C) - BOX(-J)
               IF (BOXED .EQ. 0) BAD = 1
            END IF
            IF (.NOT. (ABS(D) .LE. 1.0D-11)) BAD = 1
   30    CONTINUE
   40 CONTINUE
      DO 70 A = 1, NVERT
         R = AWAY(VERT(1,A), P(1,I)) - 1.0D-11
         DO 50 J = 1, M
            IF (.NOT. (AWAY(VERT(1,A), P(1,J)) .GE. R)) BAD = 1
   50    CONTINUE
         DO 60 K = 1, 3
            IF (BOXED .EQ. 1 .AND. .NOT.
     1          (VERT(K,A) .GE. BOX(K) - 1.0D-12 .AND.
     2           VERT(K,A) .LE. BOX(K+3) + 1.0D-12)) BAD = 1
   60    CONTINUE
   70 CONTINUE
      DO 90 K = 1, 3
         SUM(K) = 0.0D0
         DO 80 F = 1, NFACE
            J = WHOSE(F)
            D = 0.0D0
            IF (J .EQ. -K) D = -1.0D0
            IF (J .EQ. -K-3) D = 1.0D0
            IF (J .GE. 1) D = (P(K,J) - P(K,I)) / AWAY(P(1,J), P(1,I))
            SUM(K) = SUM(K) + AREA(F)*D
            IF (.NOT. (AREA(F) .GE. 0.0D0)) BAD = 1
   80    CONTINUE
         IF (.NOT. (ABS(SUM(K)) .LE. 1.0D-11)) BAD = 1
   90 CONTINUE
      END

C     OUTER - has point I a facet on the hull?
      INTEGER FUNCTION OUTER(I)
      INTEGER N, MAXTET, LIW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (MAXROW = 40*N, MOST = 300)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER I
      INTEGER J, K
      OUTER = 0
      DO 20 J = FIRST(I), FIRST(I+1) - 1
         DO 10 K = 1, 4
            IF (TET(K,LIST(J)) .NE. I .AND. ADJ(K,LIST(J)) .LT. 1)
     1         OUTER = 1
   10    CONTINUE
   20 CONTINUE
      END

C     TCELL - all cells, with a box and without (on the turned lattice's
C     sides there are points that rounding has put inside by 1D-17); on
C     the lattice cubes of 1/8, of six faces and eight vertices; their
C     volumes sum to the box's.
      SUBROUTINE TCELL(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION V, U, SUM, ALL
      INTEGER SET, M, NTET, I, K, NFACE, NVERT, INFO, OUTER
      DO 30 SET = 1, 6
         I = SET
         CALL MAKE(I, SEED, M, NTET, BAD)
         ALL = (BOX(4) - BOX(1))*(BOX(5) - BOX(2))*(BOX(6) - BOX(3))
         SUM = 0.0D0
         DO 20 I = 1, M
            K = I
            CALL ONE(K, 1, NFACE, NVERT, V, INFO)
            IF (INFO .NE. 0) BAD = 1
            IF (IW(I) .NE. I) THEN
               IF (NFACE .NE. 0 .OR. V .NE. 0.0D0) BAD = 1
               GO TO 20
            END IF
            CALL SOUND(M, K, 1, NFACE, NVERT, BAD)
            IF (.NOT. (V .GT. 0.0D0)) BAD = 1
            SUM = SUM + V
            IF (SET .EQ. 2 .AND. (NFACE .NE. 6 .OR. NVERT .NE. 8 .OR.
     1          .NOT. (ABS(V - 1.0D0/512.0D0) .LE. 1.0D-15))) BAD = 1
            CALL ONE(K, 0, NFACE, NVERT, U, INFO)
            IF (OUTER(K) .EQ. 1) THEN
               IF (INFO .NE. 2) BAD = 1
            ELSE IF (INFO .NE. 0 .AND. SET .NE. 3) THEN
               BAD = 1
            END IF
            IF (INFO .NE. 0) GO TO 20
            CALL SOUND(M, K, 0, NFACE, NVERT, BAD)
            IF (.NOT. (U .GE. V - 1.0D-12)) BAD = 1
            IF ((SET .EQ. 2 .OR. SET .EQ. 3) .AND. (NFACE .NE. 6 .OR.
     1          NVERT .NE. 8 .OR.
     2          .NOT. (ABS(U - 1.0D0/512.0D0) .LE. 1.0D-13))) BAD = 1
   20    CONTINUE
         IF (.NOT. (ABS(SUM - ALL) .LE. 1.0D-12*ALL)) BAD = 1
   30 CONTINUE
      END

C     TCLIPP - the cells fill the box, and boxes that hold a part of the
C     points or none; a face is as large from both sides; the box's
C     sides are filled.
      SUBROUTINE TCLIPP(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION SUM, ALL, SIDE(6), R, SLACK
      INTEGER SET, PART, M, NTET, I, J, K, L, NROW, INFO
      DO 70 SET = 1, 6
         DO 60 PART = 1, 3
            I = SET
            CALL MAKE(I, SEED, M, NTET, BAD)
            IF (PART .EQ. 2) BOX(1) = 0.1D0
            DO 10 K = 1, 3
               IF (PART .EQ. 3) BOX(K) = BOX(K) + 10.0D0
               IF (PART .EQ. 3) BOX(K+3) = BOX(K+3) + 20.0D0
   10       CONTINUE
            CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW,
     1                  ROW, OTHER, FACES, VOLUME, MOST, IWORK, WORK,
     2                  INFO)
            IF (INFO .NE. 0) BAD = 1
            ALL = (BOX(4) - BOX(1))*(BOX(5) - BOX(2))*(BOX(6) - BOX(3))
            SLACK = 1.0D-12*ALL
            IF (SET .EQ. 5) SLACK = 1.0D-8*ALL
            DO 20 K = 1, 6
               SIDE(K) = 0.0D0
   20       CONTINUE
            SUM = 0.0D0
            DO 50 I = 1, M
               SUM = SUM + VOLUME(I)
               IF (.NOT. (VOLUME(I) .GE. 0.0D0)) BAD = 1
               DO 40 J = ROW(I), ROW(I+1) - 1
                  IF (.NOT. (FACES(J) .GE. 0.0D0)) BAD = 1
                  K = OTHER(J)
                  IF (K .LT. 0) THEN
                     SIDE(-K) = SIDE(-K) + FACES(J)
                     GO TO 40
                  END IF
                  R = 0.0D0
                  DO 30 L = ROW(K), ROW(K+1) - 1
                     IF (OTHER(L) .EQ. I) R = FACES(L)
   30             CONTINUE
                  IF (.NOT. (ABS(R - FACES(J)) .LE. SLACK)) BAD = 1
   40          CONTINUE
   50       CONTINUE
            IF (.NOT. (ABS(SUM - ALL) .LE. 1.0D-12*ALL)) BAD = 1
            DO 55 K = 1, 6
               L = MOD(K-1, 3) + 1
               IF (.NOT. (ABS(SIDE(K)*(BOX(L+3) - BOX(L)) - ALL) .LE.
     1                    1.0D-12*ALL)) BAD = 1
   55       CONTINUE
   60    CONTINUE
   70 CONTINUE
      END

C     DET3 - six times the volume of A B C O.
      DOUBLE PRECISION FUNCTION DET3(A, B, C, O)
      DOUBLE PRECISION A(3), B(3), C(3), O(3)
      DOUBLE PRECISION E(3,3)
      INTEGER K
      DO 10 K = 1, 3
         E(K,1) = A(K) - O(K)
         E(K,2) = B(K) - O(K)
         E(K,3) = C(K) - O(K)
   10 CONTINUE
      DET3 = E(1,1)*(E(2,2)*E(3,3) - E(3,2)*E(2,3)) -
     1       E(2,1)*(E(1,2)*E(3,3) - E(3,2)*E(1,3)) +
     2       E(3,1)*(E(1,2)*E(2,3) - E(2,2)*E(1,3))
      END

C     SHAPE - ALPHA's volume V, by its tetrahedra; BAD when that by the
C     triangles is another one.
      SUBROUTINE SHAPE(NTET, RADIUS, VOIDS, V, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER NTET, VOIDS, BAD
      DOUBLE PRECISION RADIUS, V
      DOUBLE PRECISION BY, DET3
      INTEGER NFAC, T, INFO
      CALL ALPHA(P, NTET, TET, ADJ, RADIUS, VOIDS, KEEP, 4*MAXTET, NFAC,
     1           FAC, STACK, INFO)
      IF (INFO .NE. 0) BAD = 1
      V = 0.0D0
      DO 10 T = 1, NTET
         IF (KEEP(T) .EQ. 1)
     1      V = V + DET3(P(1,TET(2,T)), P(1,TET(3,T)), P(1,TET(4,T)),
     2                   P(1,TET(1,T))) / 6.0D0
   10 CONTINUE
      BY = 0.0D0
      DO 20 T = 1, NFAC
         BY = BY + DET3(P(1,FAC(1,T)), P(1,FAC(2,T)), P(1,FAC(3,T)),
     1                  P(1,1)) / 6.0D0
   20 CONTINUE
      IF (.NOT. (ABS(V - BY) .LE. 1.0D-12)) BAD = 1
      END

C     TALPHA - volumes by tetrahedra and triangles agree for every
C     radius, and grow with it; the largest gives the hull.  A lattice
C     of cubes of edge 1/8 without 3**3 points inside and 3 of an edge:
C     of a cube that lacks a corner 5/6 remain, of one that lacks two
C     half.  Inside 8 lack one and 24 two, of 64; at the edge 2 and 2.
      SUBROUTINE TALPHA(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION V, W, LAST(2), R
      INTEGER SET, M, NTET, I, J, K, NHULL, NFAC, INFO, INSIDE
      DO 60 SET = 1, 6
         I = SET
         CALL MAKE(I, SEED, M, NTET, BAD)
         LAST(1) = 0.0D0
         LAST(2) = 0.0D0
         R = 0.01D0
   10    CONTINUE
         DO 20 K = 1, 2
            CALL SHAPE(NTET, R, K - 1, V, BAD)
            IF (.NOT. (V .GE. LAST(K) - 1.0D-12)) BAD = 1
            LAST(K) = V
   20    CONTINUE
         IF (.NOT. (LAST(2) .LE. LAST(1) + 1.0D-12)) BAD = 1
         R = 1.5D0*R
         IF (R .LT. 100.0D0) GO TO 10
         R = (2.0D0 - 2.0D0**(-52))*2.0D0**1023
         CALL TESSHU(NTET, TET, ADJ, 4*MAXTET, NHULL, HULL, INFO)
         DO 50 K = 0, 1
            CALL ALPHA(P, NTET, TET, ADJ, R, K, KEEP, 4*MAXTET, NFAC,
     1                 FAC, STACK, INFO)
            IF (INFO .NE. 0 .OR. NFAC .NE. NHULL) BAD = 1
            DO 40 I = 1, NHULL
               DO 30 J = 1, 3
                  IF (FAC(J,I) .NE. HULL(J,I)) BAD = 1
   30          CONTINUE
   40       CONTINUE
   50    CONTINUE
         CALL ALPHA(P, NTET, TET, ADJ, R, 0, KEEP, 3, NFAC, FAC, STACK,
     1              INFO)
         IF (INFO .NE. 1 .OR. NFAC .NE. NHULL) BAD = 1
   60 CONTINUE
      CALL MAKE(2, SEED, M, NTET, BAD)
      J = 0
      DO 80 I = 1, M
         INSIDE = 0
         IF (ABS(P(1,I)) .LT. 0.2D0 .AND. ABS(P(2,I)) .LT. 0.2D0 .AND.
     1       ABS(P(3,I)) .LT. 0.2D0) INSIDE = 1
         IF (P(2,I) .GT. 0.3D0 .AND. P(3,I) .GT. 0.3D0 .AND.
     1       ABS(P(1,I)) .LT. 0.2D0) INSIDE = 1
         IF (INSIDE .EQ. 1) GO TO 80
         J = J + 1
         DO 70 K = 1, 3
            P(K,J) = P(K,I)
   70    CONTINUE
   80 CONTINUE
      CALL MESH(J, NTET, BAD)
      CALL SHAPE(NTET, 0.11D0, 0, V, BAD)
      CALL SHAPE(NTET, 0.11D0, 1, W, BAD)
      IF (.NOT. (ABS(V - (216.0D0 - 4.0D0/3.0D0) / 512.0D0) .LE.
     1           1.0D-13)) BAD = 1
      IF (.NOT. (ABS(W - (216.0D0 - 140.0D0/3.0D0) / 512.0D0) .LE.
     1           1.0D-13)) BAD = 1
      END

C     TSIZES - coordinates times powers of two: volumes times their
C     cubes.
      SUBROUTINE TSIZES(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION SCALE, V, W
      INTEGER M, NTET, I, J, K, NFACE, NVERT, INFO
      DO 40 J = 1, 2
         CALL MAKE(1, SEED, M, NTET, BAD)
         SCALE = 2.0D0**166
         IF (J .EQ. 2) SCALE = 1.0D0 / SCALE
         CALL ONE(8, 1, NFACE, NVERT, V, INFO)
         IF (INFO .NE. 0) BAD = 1
         DO 20 I = 1, M
            DO 10 K = 1, 3
               P(K,I) = P(K,I)*SCALE
   10       CONTINUE
   20    CONTINUE
         DO 30 K = 1, 6
            BOX(K) = BOX(K)*SCALE
   30    CONTINUE
         CALL MESH(M, NTET, BAD)
         CALL ONE(8, 1, NFACE, NVERT, W, INFO)
         IF (INFO .NE. 0 .OR. .NOT.
     1       (ABS(W / SCALE / SCALE / SCALE - V) .LE. 1.0D-14)) BAD = 1
         CALL ALPHA(P, NTET, TET, ADJ, 0.3D0*SCALE, 1, KEEP, 4*MAXTET,
     1              I, FAC, STACK, INFO)
         IF (INFO .NE. 0 .OR. I .LT. 4) BAD = 1
   40 CONTINUE
      END

C     TCODES - arrays that are too short, damaged and unfinished meshes.
      SUBROUTINE TCODES(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(20*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION V
      INTEGER M, NTET, HELD, NEED, NROW, NFACE, NVERT, I, K, INFO(10)
      INTEGER WANT(10)
      SAVE WANT
      DATA WANT /1, 0, 1, 0, -13, -7, 10, 14, 1, 13/
      CALL MAKE(1, SEED, M, NTET, BAD)
      CALL CELL(P, TET, ADJ, FIRST, LIST, 6, BOX, 10, NEED, WHOSE, AREA,
     1          V, START, CORNER, NVERT, VERT, IWORK, WORK, INFO(1))
      IF (NEED .LE. MOST)
     1   CALL CELL(P, TET, ADJ, FIRST, LIST, 6, BOX, NEED, NFACE, WHOSE,
     2             AREA, V, START, CORNER, NVERT, VERT, IWORK, WORK,
     3             INFO(2))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, 100, NROW, ROW,
     1            OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO(3))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, NROW, NEED, ROW,
     1            OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO(4))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW, ROW,
     1            OTHER, FACES, VOLUME, 10, IWORK, WORK, INFO(5))
      BOX(4) = BOX(1) - 1.0D0
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW, ROW,
     1            OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO(6))
      HELD = TET(2,3)
      TET(2,3) = M + 1
      CALL STARS(M, NTET, TET, FIRST, LIST, INFO(7))
      TET(2,3) = HELD
      HELD = ADJ(2,3)
      ADJ(2,3) = NTET + 1
      CALL ALPHA(P, NTET, TET, ADJ, 1.0D0, 1, KEEP, 4*MAXTET, NEED, FAC,
     1           STACK, INFO(8))
      ADJ(2,3) = HELD
      CALL TESS(M, P, 200, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO(9))
      CALL ALPHA(P, NTET, TET, ADJ, 1.0D0, 1, KEEP, 4*MAXTET, NEED, FAC,
     1           STACK, INFO(10))
      DO 10 K = 1, 10
         IF (INFO(K) .NE. WANT(K)) BAD = 1
   10 CONTINUE
      CALL STARS(M, NTET, TET, FIRST, LIST, INFO(1))
      NEED = 0
      DO 20 I = 1, M
         K = I
         CALL ONE(K, 1, NFACE, NVERT, V, INFO(1))
         IF (INFO(1) .EQ. 13) NEED = NEED + 1
   20 CONTINUE
      IF (NEED .EQ. 0) BAD = 1
      END
