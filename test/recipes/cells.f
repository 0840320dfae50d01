C     cells.f - Voronoi cells, clipped to a box, and alpha shapes:
C     recipes to copy.
C
C       TRCELL  the Voronoi cell of a point: a polyhedron, its vertices,
C               faces and neighbours, its volume; clipped to a box
C               (TRSTAR's rows; TRPROP, TRMOST, TRNORC, TRHEIG,
C               TRNEIG, TRBEGI, TRMEET, TRFLOC, TRDIVI, TRCUT, TRALON,
C               TRMEAC, TRNUMB, TROUTL, TRCLOS)
C       TRCLIP  for finite volumes: all cells' volumes, and the areas of
C               their faces, clipped to a box
C               (TRSTAR's rows; TRPROP, TRCELL)
C       TRALPH  the part of the mesh whose tetrahedra have small
C               circumspheres, and its boundary
C
C     TRSTAR is of derived.f.  t_cells.c tests them; cells.c is the
C     same in C.

C     ---- cell ----

C     TRPROP - 1 for a box, else 0.
      INTEGER FUNCTION TRPROP(BOX)
      DOUBLE PRECISION BOX(6)
      TRPROP = 0
      IF (BOX(1) .LE. BOX(2) .AND. BOX(3) .LE. BOX(4) .AND.
     1    BOX(5) .LE. BOX(6)) TRPROP = 1
      END

      DOUBLE PRECISION FUNCTION TRMOST(A)
      DOUBLE PRECISION A(3)
      TRMOST = MAX(ABS(A(1)), ABS(A(2)), ABS(A(3)))
      END

C     TRNORC - the length of A, whose square may be beyond numbers.
      DOUBLE PRECISION FUNCTION TRNORC(A)
      DOUBLE PRECISION A(3)
      DOUBLE PRECISION MOST, TRMOST
      MOST = TRMOST(A)
      TRNORC = MOST
      IF (MOST .GT. 0.0D0) TRNORC = MOST*
     1   SQRT((A(1)/MOST)**2 + (A(2)/MOST)**2 + (A(3)/MOST)**2)
      END

C     TRHEIG - the height of X over a plane, that is a unit normal and
C     an offset.
      DOUBLE PRECISION FUNCTION TRHEIG(PLANE, X)
      DOUBLE PRECISION PLANE(4), X(3)
      TRHEIG = X(1)*PLANE(1) + X(2)*PLANE(2) + X(3)*PLANE(3) - PLANE(4)
      END

C     TRNEIG - the planes midway from point I to its neighbours, the
C     nearest first, behind the box's six; with TRCELL's arguments and
C     codes.
      SUBROUTINE TRNEIG(P, TET, ADJ, FIRST, LIST, I, FREE, PLANES,
     1                  WHOSE, PLANE, INFO)
      INTEGER TET(4,*), ADJ(4,*), FIRST(*), LIST(*), I, FREE, PLANES
      INTEGER WHOSE(*), INFO
      DOUBLE PRECISION P(3,*), PLANE(4,*)
      DOUBLE PRECISION FAREST
      PARAMETER (FAREST = 1.0D290)
      DOUBLE PRECISION E(3), R, TRNORC
      INTEGER A, J, K, L, T, V
      PLANES = 6
      DO 70 J = FIRST(I), FIRST(I+1) - 1
         T = LIST(J)
         DO 60 K = 1, 4
            V = TET(K,T)
            IF (V .EQ. I) GO TO 60
            INFO = 13
            IF (ADJ(K,T) .EQ. -1) RETURN
            INFO = 2
            IF (ADJ(K,T) .LT. 1 .AND. FREE .EQ. 1) RETURN
            DO 10 A = 7, PLANES
               IF (WHOSE(A) .EQ. V) GO TO 60
   10       CONTINUE
            DO 20 L = 1, 3
               E(L) = P(L,V) - P(L,I)
   20       CONTINUE
            R = TRNORC(E)
            INFO = 3
            IF (.NOT. (R .GT. 0.0D0 .AND. R .LT. FAREST)) RETURN
            PLANES = PLANES + 1
            A = PLANES
   30       CONTINUE
            IF (A .GT. 7) THEN
               IF (PLANE(4,A-1) .GT. R / 2.0D0) THEN
                  WHOSE(A) = WHOSE(A-1)
                  DO 40 L = 1, 4
                     PLANE(L,A) = PLANE(L,A-1)
   40             CONTINUE
                  A = A - 1
                  GO TO 30
               END IF
            END IF
            WHOSE(A) = V
            DO 50 L = 1, 3
               PLANE(L,A) = E(L) / R
   50       CONTINUE
            PLANE(4,A) = R / 2.0D0
   60    CONTINUE
   70 CONTINUE
      INFO = 0
      END

C     TRBEGI - a box, by its sides' offsets outwards; as TRCUT describes
C     it.
      SUBROUTINE TRBEGI(SIDE, PLANE, VERT, TRI, NEXT)
      DOUBLE PRECISION SIDE(6), PLANE(4,*), VERT(3,*)
      INTEGER TRI(3,*), NEXT(3,*)
      INTEGER A, V, K, M, ODD, BIT(3)
      DO 20 K = 1, 3
         DO 10 A = 2*K - 1, 2*K
            PLANE(1,A) = 0.0D0
            PLANE(2,A) = 0.0D0
            PLANE(3,A) = 0.0D0
            PLANE(K,A) = DBLE(1 - 2*MOD(A, 2))
            PLANE(4,A) = SIDE(A)
   10    CONTINUE
   20 CONTINUE
C     The upper sides of corner V are the bits set in V - 1.  The order
C     X, Y, Z is counter-clockwise where their number is odd.
      DO 50 V = 1, 8
         ODD = 0
         DO 30 K = 1, 3
            BIT(K) = MOD((V - 1) / 2**(K - 1), 2)
            IF (BIT(K) .EQ. 1) ODD = 1 - ODD
   30    CONTINUE
         DO 40 K = 1, 3
            M = K
            IF (ODD .EQ. 0 .AND. K .LT. 3) M = 3 - K
            A = 2*M - 1 + BIT(M)
            VERT(M,V) = DBLE(2*BIT(M) - 1)*SIDE(A)
            TRI(K,V) = A
            NEXT(MOD(K, 3) + 1,V) = V + (1 - 2*BIT(M))*2**(M - 1)
   40    CONTINUE
   50 CONTINUE
      END

C     TRMEET - the point X where an edge crosses a plane, over which its
C     ends U and V are HU and HV high: PLANE1 and PLANE2 are the edge's
C     planes, PLANE3 is that one.
C
C     What lies between U and V is in the planes but for roundings of U
C     and V.  Newton's steps make them roundings of X, which may be much
C     smaller.  A step longer than those is not taken: where planes are
C     nearly parallel it would lead out of the polyhedron.
      SUBROUTINE TRMEET(PLANE1, PLANE2, PLANE3, U, V, HU, HV, X)
      DOUBLE PRECISION PLANE1(4), PLANE2(4), PLANE3(4), U(3), V(3)
      DOUBLE PRECISION HU, HV, X(3)
      DOUBLE PRECISION AT(4,3), N(3,3), Y(3), E(3), H(3), DET, S, SIZE
      DOUBLE PRECISION LEFT, TRMOST, TRHEIG
      INTEGER I, J, K, L, M, STEP
      S = 0.0D0
      IF (HV .GT. HU) S = HV / (HV - HU)
      IF (S .LT. 0.0D0) S = 0.0D0
      IF (S .GT. 1.0D0) S = 1.0D0
      SIZE = MAX(TRMOST(U), TRMOST(V))
C     From the nearer end.
      DO 10 K = 1, 3
         IF (TRMOST(U) .LT. SIZE) THEN
            X(K) = U(K) + (1.0D0 - S)*(V(K) - U(K))
         ELSE
            X(K) = V(K) + S*(U(K) - V(K))
         END IF
   10 CONTINUE
      DO 20 K = 1, 4
         AT(K,1) = PLANE1(K)
         AT(K,2) = PLANE2(K)
         AT(K,3) = PLANE3(K)
   20 CONTINUE
      DO 40 I = 1, 3
         J = MOD(I, 3) + 1
         DO 30 K = 1, 3
            L = MOD(K, 3) + 1
            M = MOD(K + 1, 3) + 1
            N(K,I) = AT(L,J)*AT(M,6-I-J) - AT(M,J)*AT(L,6-I-J)
   30    CONTINUE
         H(I) = TRHEIG(AT(1,I), X)
   40 CONTINUE
      DET = AT(1,1)*N(1,1) + AT(2,1)*N(2,1) + AT(3,1)*N(3,1)
      LEFT = TRMOST(H)
      DO 80 STEP = 1, 3
         IF (.NOT. (LEFT .GT. 2.0D-16*TRMOST(X))) RETURN
         DO 50 K = 1, 3
            E(K) = (H(1)*N(K,1) + H(2)*N(K,2) + H(3)*N(K,3)) / DET
            Y(K) = X(K) - E(K)
   50    CONTINUE
         DO 60 I = 1, 3
            H(I) = TRHEIG(AT(1,I), Y)
   60    CONTINUE
         IF (.NOT. (TRMOST(E) .LE. 1.0D-14*SIZE .AND.
     1       TRMOST(H) .LT. LEFT)) RETURN
         LEFT = TRMOST(H)
         DO 70 K = 1, 3
            X(K) = Y(K)
   70    CONTINUE
   80 CONTINUE
      END

C     TRFLOC - give V, and what its mark connects to it, another mark.
      SUBROUTINE TRFLOC(NEXT, V, TO, MARK, QUEUE)
      INTEGER NEXT(3,*), V, TO, MARK(*), QUEUE(*)
      INTEGER MANY, FROM, K, T, U
      FROM = MARK(V)
      MARK(V) = TO
      QUEUE(1) = V
      MANY = 1
   10 CONTINUE
      IF (MANY .EQ. 0) RETURN
      T = QUEUE(MANY)
      MANY = MANY - 1
      DO 20 K = 1, 3
         U = NEXT(K,T)
         IF (MARK(U) .NE. FROM) GO TO 20
         MARK(U) = TO
         MANY = MANY + 1
         QUEUE(MANY) = U
   20 CONTINUE
      GO TO 10
      END

C     TRDIVI - divide the vertices, of heights D over a plane: mark 3
C     for what it cuts off, 2 for what stays.  Those as near to it as a
C     part, BAND, of their distance stay; or go, where BAND is less than
C     0.  WRONG is the largest part by which one is on the wrong side.
C
C     A plane divides the vertices of a convex polyhedron into two
C     parts, each connected by edges.  So what is connected to the
C     lowest vertex stays, and of all others what is connected to the
C     highest one goes.
      SUBROUTINE TRDIVI(MANY, VERT, NEXT, D, BAND, MARK, QUEUE, WRONG)
      INTEGER MANY, NEXT(3,*), MARK(*), QUEUE(*)
      DOUBLE PRECISION VERT(3,*), D(*), BAND, WRONG
      DOUBLE PRECISION FAR, SIZE, TRMOST
      INTEGER LOW, HIGH, V
      LOW = 0
      HIGH = 0
      DO 10 V = 1, MANY
         IF (D(V) .GT. BAND*TRMOST(VERT(1,V))) THEN
            MARK(V) = 1
            IF (HIGH .EQ. 0) HIGH = V
            IF (D(V) .GT. D(HIGH)) HIGH = V
         ELSE
            MARK(V) = 0
            IF (LOW .EQ. 0) LOW = V
            IF (D(V) .LT. D(LOW)) LOW = V
         END IF
   10 CONTINUE
      IF (LOW .GT. 0) CALL TRFLOC(NEXT, LOW, 2, MARK, QUEUE)
      DO 20 V = 1, MANY
         IF (MARK(V) .EQ. 0) MARK(V) = 1
   20 CONTINUE
      IF (HIGH .GT. 0) CALL TRFLOC(NEXT, HIGH, 3, MARK, QUEUE)
      WRONG = 0.0D0
      DO 30 V = 1, MANY
         IF (MARK(V) .EQ. 1) MARK(V) = 2
         FAR = D(V)
         IF (MARK(V) .EQ. 3) FAR = -D(V)
         SIZE = TRMOST(VERT(1,V))
         IF (FAR .GT. WRONG*SIZE) WRONG = FAR / SIZE
   30 CONTINUE
      END

C     TRCUT - what a polyhedron has beyond a plane is taken away.
C
C       PLANE   (in)      (4,*): planes: a unit normal outwards and its
C                         offset
C       J       (in)      the one that cuts
C       MANY    (in,out)  number of vertices
C       VERT    (in,out)  (3,*): their coordinates
C       TRI     (in,out)  (3,*): the planes A, B, C that meet there,
C                         counter-clockwise seen from outside
C       NEXT    (in,out)  (3,*): where the edge of A and B leads, that
C                         of B and C, that of C and A
C       MARK, QUEUE, LAST, D   (out)  workspace
C       INFO    (out)     0, or 3 where roundings contradict each other
C
C     What is left always has the vertices, edges and faces of some
C     convex polyhedron, whatever roundings do: a plane has at most one
C     face, two faces have at most one edge in common, a face has at
C     least three, F faces have 2 F - 4 vertices; all walks end.
C     Vertices that the plane passes within 1D-13 of their distance
C     stay, unless they connect what must go.
      SUBROUTINE TRCUT(PLANE, J, MANY, VERT, TRI, NEXT, MARK, QUEUE,
     1                 LAST, D, INFO)
      INTEGER J, MANY, TRI(3,*), NEXT(3,*), MARK(*), QUEUE(*), LAST(*)
      INTEGER INFO
      DOUBLE PRECISION PLANE(4,*), VERT(3,*), D(*)
      DOUBLE PRECISION WRONG, TRHEIG
      INTEGER OLD, NOW, A, B, K, L, U, V
      OLD = MANY
      NOW = OLD
      DO 10 V = 1, OLD
         D(V) = TRHEIG(PLANE(1,J), VERT(1,V))
   10 CONTINUE
      CALL TRDIVI(OLD, VERT, NEXT, D, 1.0D-13, MARK, QUEUE, WRONG)
      IF (WRONG .GT. 2.0D-13)
     1   CALL TRDIVI(OLD, VERT, NEXT, D, -1.0D-13, MARK, QUEUE, WRONG)
      INFO = 3
      IF (WRONG .GT. 1.0D-12) RETURN
      INFO = 0
      DO 70 V = 1, OLD
         IF (MARK(V) .NE. 3) GO TO 70
         DO 60 K = 1, 3
            U = NEXT(K,V)
            IF (MARK(U) .EQ. 3) GO TO 60
            NOW = NOW + 1
            A = TRI(K,V)
            B = TRI(MOD(K, 3) + 1,V)
            TRI(1,NOW) = A
            TRI(2,NOW) = B
            TRI(3,NOW) = J
            CALL TRMEET(PLANE(1,A), PLANE(1,B), PLANE(1,J), VERT(1,U),
     1                  VERT(1,V), D(U), D(V), VERT(1,NOW))
            NEXT(1,NOW) = U
            DO 50 L = 1, 3
               IF (NEXT(L,U) .EQ. V) NEXT(L,U) = NOW
   50       CONTINUE
            LAST(A) = NOW
            MARK(NOW) = 2
   60    CONTINUE
   70 CONTINUE
      DO 80 V = OLD + 1, NOW
         U = LAST(TRI(2,V))
         NEXT(2,V) = U
         NEXT(3,U) = V
   80 CONTINUE
C     The others move up; QUEUE(V) is where to.
      MANY = 0
      DO 90 V = 1, NOW
         IF (MARK(V) .NE. 3) THEN
            MANY = MANY + 1
            QUEUE(V) = MANY
         END IF
   90 CONTINUE
      DO 110 V = 1, NOW
         IF (MARK(V) .EQ. 3) GO TO 110
         U = QUEUE(V)
         DO 100 K = 1, 3
            VERT(K,U) = VERT(K,V)
            TRI(K,U) = TRI(K,V)
            NEXT(K,U) = QUEUE(NEXT(K,V))
  100    CONTINUE
  110 CONTINUE
      END

C     TRALON - the vertex V, and the place K in TRI's column, that
C     follow on a face, counter-clockwise.
      SUBROUTINE TRALON(TRI, NEXT, V, K)
      INTEGER TRI(3,*), NEXT(3,*), V, K
      INTEGER J, U
      J = TRI(K,V)
      U = NEXT(MOD(K + 1, 3) + 1,V)
      V = U
      DO 10 K = 1, 2
         IF (TRI(K,V) .EQ. J) RETURN
   10 CONTINUE
      K = 3
      END

C     TRMEAC - the planes' areas, and the volume, computed in a unit;
C     LAST(J) is 3*(V-1) + K where TRI(K,V) is plane J, or 0 where it
C     has no face.
      SUBROUTINE TRMEAC(PLANES, PLANE, MANY, VERT, TRI, NEXT, UNIT,
     1                  LAST, AREA, VOLUME)
      INTEGER PLANES, MANY, TRI(3,*), NEXT(3,*), LAST(*)
      DOUBLE PRECISION PLANE(4,*), VERT(3,*), UNIT, AREA(*), VOLUME
      DOUBLE PRECISION X(3), INVERS
      INTEGER A, B, C, J, K, L, M, AT
      VOLUME = 0.0D0
      INVERS = 1.0D0 / UNIT
      DO 10 J = 1, PLANES
         LAST(J) = 0
   10 CONTINUE
      DO 30 A = 1, MANY
         DO 20 K = 1, 3
            LAST(TRI(K,A)) = 3*(A - 1) + K
   20    CONTINUE
   30 CONTINUE
      DO 70 J = 1, PLANES
         IF (LAST(J) .EQ. 0) GO TO 70
         X(1) = 0.0D0
         X(2) = 0.0D0
         X(3) = 0.0D0
         A = (LAST(J) - 1) / 3 + 1
         AT = LAST(J) - 3*(A - 1)
         C = A
         CALL TRALON(TRI, NEXT, C, AT)
   40    CONTINUE
         B = C
         CALL TRALON(TRI, NEXT, C, AT)
         IF (C .NE. A) THEN
            DO 50 K = 1, 3
               L = MOD(K, 3) + 1
               M = MOD(K + 1, 3) + 1
               X(K) = X(K) + (VERT(L,B) - VERT(L,A))*INVERS*
     1                       ((VERT(M,C) - VERT(M,A))*INVERS) -
     2                       (VERT(M,B) - VERT(M,A))*INVERS*
     3                       ((VERT(L,C) - VERT(L,A))*INVERS)
   50       CONTINUE
            GO TO 40
         END IF
         AREA(J) = SQRT(X(1)**2 + X(2)**2 + X(3)**2) / 2.0D0
         VOLUME = VOLUME + AREA(J)*(PLANE(4,J)*INVERS) / 3.0D0
         AREA(J) = AREA(J)*UNIT*UNIT
   70 CONTINUE
      VOLUME = MAX(VOLUME, 0.0D0)*UNIT*UNIT*UNIT
      END

C     TRNUMB - the vertices' numbers; those are one that edges connect
C     which are shorter than NEAR, times their distance.  COUNT is how
C     many there are.
      SUBROUTINE TRNUMB(MANY, VERT, NEXT, NEAR, SAME, QUEUE, COUNT)
      INTEGER MANY, NEXT(3,*), SAME(*), QUEUE(*), COUNT
      DOUBLE PRECISION VERT(3,*), NEAR
      DOUBLE PRECISION E(3), TRMOST
      INTEGER K, L, T, TOP, U, V
      COUNT = 0
      DO 10 V = 1, MANY
         SAME(V) = 0
   10 CONTINUE
      DO 50 V = 1, MANY
         IF (SAME(V) .GT. 0) GO TO 50
         COUNT = COUNT + 1
         SAME(V) = COUNT
         QUEUE(1) = V
         TOP = 1
   20    CONTINUE
         IF (TOP .EQ. 0) GO TO 50
         U = QUEUE(TOP)
         TOP = TOP - 1
         DO 40 K = 1, 3
            T = NEXT(K,U)
            IF (SAME(T) .GT. 0) GO TO 40
            DO 30 L = 1, 3
               E(L) = VERT(L,T) - VERT(L,U)
   30       CONTINUE
            IF (.NOT. (TRMOST(E) .LT. NEAR*TRMOST(VERT(1,U)))) GO TO 40
            SAME(T) = COUNT
            TOP = TOP + 1
            QUEUE(TOP) = T
   40    CONTINUE
         GO TO 20
   50 CONTINUE
      END

C     TROUTL - the faces, by their vertices' numbers, but for those of
C     fewer than three; ITS(F) is the plane of face F.  COUNT is how
C     many there are.
      SUBROUTINE TROUTL(PLANES, TRI, NEXT, LAST, SAME, START, CORNER,
     1                  ITS, COUNT)
      INTEGER PLANES, TRI(3,*), NEXT(3,*), LAST(*), SAME(*), START(*)
      INTEGER CORNER(*), ITS(*), COUNT
      INTEGER AT, B, C, J, U, V
      COUNT = 0
      DO 30 J = 1, PLANES
         IF (LAST(J) .EQ. 0) GO TO 30
         B = START(COUNT+1)
         C = B
         U = (LAST(J) - 1) / 3 + 1
         AT = LAST(J) - 3*(U - 1)
         V = U
   10    CONTINUE
         CORNER(C) = SAME(V)
         IF (C .EQ. B) THEN
            C = C + 1
         ELSE IF (CORNER(C-1) .NE. SAME(V)) THEN
            C = C + 1
         END IF
         CALL TRALON(TRI, NEXT, V, AT)
         IF (V .NE. U) GO TO 10
   20    CONTINUE
         IF (C - B .LT. 3) GO TO 30
         IF (CORNER(C-1) .EQ. CORNER(B)) THEN
            C = C - 1
            GO TO 20
         END IF
         COUNT = COUNT + 1
         ITS(COUNT) = J
         START(COUNT+1) = C
   30 CONTINUE
      END

C     TRCLOS - 1 if the faces are those of a polyhedron: Euler's formula
C     holds, no vertex is twice in a face, and no edge, in its
C     direction, in two faces.
      INTEGER FUNCTION TRCLOS(NVERT, NFACE, START, CORNER)
      INTEGER NVERT, NFACE, START(*), CORNER(*)
      INTEGER F, G, A, B, TO, TOO
      TRCLOS = 0
      IF (2*(NVERT + NFACE) .NE. 3 + START(NFACE+1)) RETURN
      DO 40 F = 1, NFACE
         DO 30 A = START(F), START(F+1) - 1
            TO = CORNER(START(F))
            IF (A + 1 .LT. START(F+1)) TO = CORNER(A+1)
            DO 20 G = 1, F
               DO 10 B = START(G), MIN(START(G+1), A) - 1
                  IF (CORNER(B) .NE. CORNER(A)) GO TO 10
                  TOO = CORNER(START(G))
                  IF (B + 1 .LT. START(G+1)) TOO = CORNER(B+1)
                  IF (G .EQ. F .OR. TO .EQ. TOO) RETURN
   10          CONTINUE
   20       CONTINUE
   30    CONTINUE
   40 CONTINUE
      TRCLOS = 1
      END

C     TRCELL - the Voronoi cell of point I: what is nearer to it than to
C     any other.
C
C       P, TET, ADJ, FIRST, LIST  (in)  points, mesh, and stars of it
C       I       (in)   the point
C       BOX     (in)   (6): X0, X1, Y0, Y1, Z0, Z1: the cell is clipped
C                      to what is between; need not hold the point
C       BOXED   (in)   0: the cell is not clipped, and BOX not looked at
C       MOST    (in)   faces that there is room for; 8 more than
C                      tetrahedra at I suffice
C       NFACE   (out)  number of faces
C       WHOSE   (out)  (MOST): the neighbour across each, or -1 ... -6
C                      for the box's side at X0, X1, Y0, Y1, Z0, Z1
C       AREA    (out)  (MOST): of each face
C       VOLUME  (out)  of the cell
C       START   (out)  (MOST+1): face F has the vertices
C                      CORNER(START(F)) ... CORNER(START(F+1) - 1), seen
C                      counter-clockwise from outside
C       CORNER  (out)  (6*MOST)
C       NVERT   (out)  number of vertices: circumcentres, and where the
C                      box cuts
C       VERT    (out)  (3,3*MOST): the first NVERT are set
C       IWORK   (out)  (25*MOST)
C       WORK    (out)  (7*MOST)
C       INFO    (out)  0; 1 when MOST is too small: NFACE is then a
C                      number that suffices; 2 where there is no box and
C                      the cell has no end, or one some 1D9 times as far
C                      away as neighbours, which rounding does not tell;
C                      3 where rounding leaves no polyhedron, where the
C                      cell's farthest vertex is less than 1D-102 or
C                      more than 1D102 away, so that a number does not
C                      hold the volume, or a neighbour or the box
C                      reaches farther than 1D290; 13 at an open facet;
C                      -7 for a box with X0 > X1, or a NaN
C
C     A duplicate has no tetrahedra: its cell is that of IW(I), and
C     NFACE = 0, VOLUME = 0 here.
C     Cost: some 25 microseconds among random points; O(M**2) for M
C     neighbours.
C
C     The box, or one that is made larger until nothing is left of its
C     sides, is cut by the plane midway to each neighbour, the nearest
C     first; the farthest first where roundings contradict each other in
C     that order.  All vertices of what is left are in their planes, and
C     beyond none, but for roundings of its size: so its volume is
C     right but for those times its surface, although a vertex is known
C     to those over the angles between its planes only: where two points
C     are 1D-7 apart, others' faces end between them to 1D-9.  A plane
C     that only touches the cell, as in a lattice, cuts nothing, and at
C     the end edges shorter than 1D-13 of their distance shrink to a
C     vertex, and faces of fewer than three go, unless the rest would be
C     no polyhedron.
      SUBROUTINE TRCELL(P, TET, ADJ, FIRST, LIST, I, BOX, BOXED, MOST,
     1                  NFACE, WHOSE, AREA, VOLUME, START, CORNER,
     2                  NVERT, VERT, IWORK, WORK, INFO)
      INTEGER TET(4,*), ADJ(4,*), FIRST(*), LIST(*), I, BOXED, MOST
      INTEGER NFACE, WHOSE(*), START(*), CORNER(*), NVERT, IWORK(*)
      INTEGER INFO
      DOUBLE PRECISION P(3,*), BOX(6), AREA(*), VOLUME, VERT(3,*)
      DOUBLE PRECISION WORK(*)
C     Coordinates less than FAREST can be added, and multiplied by
C     1D10.
      DOUBLE PRECISION FAREST
      PARAMETER (FAREST = 1.0D290)
      DOUBLE PRECISION SIDE(6), LIMIT, NEAR, FAR, UNIT, TRMOST
      INTEGER TRI, NEXT, SAME, QUEUE, LAST, D, PLANES, MANY, J, V, A
      INTEGER FREE, OUTER, ORDER, K, TRPROP, TRCLOS
      TRI = 1
      NEXT = 9*MOST + 1
      SAME = 18*MOST + 1
      QUEUE = 21*MOST + 1
      LAST = 24*MOST + 1
      D = 4*MOST + 1
      NFACE = 0
      NVERT = 0
      VOLUME = 0.0D0
      START(1) = 1
      FREE = 0
      IF (BOXED .EQ. 0) FREE = 1
      INFO = -7
      IF (FREE .EQ. 0) THEN
         IF (TRPROP(BOX) .EQ. 0) RETURN
      END IF
      INFO = 0
      IF (FIRST(I+1) .EQ. FIRST(I)) RETURN
      INFO = 1
      IF (MOST .LT. FIRST(I+1) - FIRST(I) + 8) THEN
         NFACE = FIRST(I+1) - FIRST(I) + 8
         RETURN
      END IF
      V = I
      CALL TRNEIG(P, TET, ADJ, FIRST, LIST, V, FREE, PLANES, WHOSE,
     1            WORK, INFO)
      IF (INFO .NE. 0) RETURN
      FAR = WORK(4*PLANES)
      LIMIT = 4.0D0*FAR
   10 CONTINUE
      DO 20 A = 1, 6
         WHOSE(A) = -A
         SIDE(A) = LIMIT
         IF (FREE .EQ. 1) GO TO 20
         SIDE(A) = BOX(A) - P((A + 1)/2,I)
         IF (MOD(A, 2) .EQ. 1) SIDE(A) = -SIDE(A)
         INFO = 3
         IF (.NOT. (ABS(SIDE(A)) .LT. FAREST)) RETURN
   20 CONTINUE
      INFO = 3
      DO 35 ORDER = 0, 1
         IF (INFO .EQ. 0) GO TO 35
         CALL TRBEGI(SIDE, WORK, VERT, IWORK(TRI), IWORK(NEXT))
         INFO = 0
         MANY = 8
         DO 30 J = 7, PLANES
            A = J
            IF (ORDER .EQ. 1) A = PLANES + 7 - J
            IF (MANY .GT. 0 .AND. INFO .EQ. 0) CALL TRCUT(WORK, A, MANY,
     1         VERT, IWORK(TRI), IWORK(NEXT), IWORK(SAME),
     2         IWORK(QUEUE), IWORK(LAST), WORK(D), INFO)
   30    CONTINUE
   35 CONTINUE
      IF (INFO .NE. 0) THEN
         IF (FREE .EQ. 1) INFO = 2
         RETURN
      END IF
      OUTER = 0
      IF (FREE .EQ. 1 .AND. MANY .EQ. 0) OUTER = 1
      DO 40 V = 1, 3*MANY
         IF (FREE .EQ. 1 .AND. IWORK(V) .LE. 6) OUTER = 1
   40 CONTINUE
      IF (OUTER .EQ. 1) THEN
         INFO = 2
         LIMIT = 16.0D0*LIMIT
         IF (LIMIT .GT. 1.0D10*FAR) RETURN
         GO TO 10
      END IF
      FAR = 0.0D0
      DO 45 V = 1, MANY
         FAR = MAX(FAR, TRMOST(VERT(1,V)))
   45 CONTINUE
      INFO = 3
      IF (FAR .GT. 0.0D0 .AND. .NOT. (FAR .GT. 1.0D-102 .AND.
     1    FAR .LT. 1.0D102)) RETURN
C     A power of two, which alters nothing else: small products are not
C     lost where subnormal numbers are flushed to 0.
      UNIT = 1.0D0
      IF (FAR .GT. 0.0D0) UNIT = 2.0D0**INT(LOG(FAR) / LOG(2.0D0))
      CALL TRMEAC(PLANES, WORK, MANY, VERT, IWORK(TRI), IWORK(NEXT),
     1            UNIT, IWORK(LAST), AREA, VOLUME)
      NEAR = 1.0D-13
   50 CONTINUE
      CALL TRNUMB(MANY, VERT, IWORK(NEXT), NEAR, IWORK(SAME),
     1            IWORK(QUEUE), NVERT)
      CALL TROUTL(PLANES, IWORK(TRI), IWORK(NEXT), IWORK(LAST),
     1            IWORK(SAME), START, CORNER, IWORK(QUEUE), NFACE)
      IF (NVERT .LT. MANY) THEN
         NEAR = 0.0D0
         IF (TRCLOS(NVERT, NFACE, START, CORNER) .EQ. 0) GO TO 50
      END IF
      DO 60 J = 1, NFACE
         A = IWORK(QUEUE+J-1)
         AREA(J) = AREA(A)
         WHOSE(J) = WHOSE(A)
   60 CONTINUE
      A = 1
      DO 80 V = 1, MANY
         IF (IWORK(SAME+V-1) .NE. A) GO TO 80
         DO 70 K = 1, 3
            VERT(K,A) = VERT(K,V) + P(K,I)
   70    CONTINUE
         A = A + 1
   80 CONTINUE
      INFO = 0
      END

C     ---- clipped ----

C     TRCLIP - for finite volumes: the Voronoi cells of all points,
C     clipped to a box that they fill.
C
C       N, P, TET, ADJ, FIRST, LIST  (in)  points, mesh, and stars of it
C       BOX     (in)   (6): X0, X1, Y0, Y1, Z0, Z1
C       MAXROW  (in)   faces that there is room for: 16 a point of
C                      random ones
C       NROW    (out)  number of faces, each of which comes from both
C                      sides; but for code -13 the least MOST that
C                      suffices
C       ROW     (out)  (N+1): the faces of point I's cell are ROW(I) ...
C                      ROW(I+1) - 1.  A duplicate has none
C       OTHER   (out)  (MAXROW): the point across each face, or
C                      -1 ... -6 for the box's sides, as in TRCELL
C       AREA    (out)  (MAXROW): of each
C       VOLUME  (out)  (N): of the cells
C       MOST    (in)   the largest number of tetrahedra at a point,
C                      plus 8
C       IWORK   (out)  (33*MOST+1)
C       WORK    (out)  (17*MOST)
C       INFO    (out)  0; 1 when MAXROW is too small: NROW is then the
C                      number needed; -13 when MOST is too small; what
C                      TRCELL returns
C
C     All areas and volumes are at least 0, unlike those of TRDUAL at
C     the hull, and the volumes' sum is the box's.  The face of I and J
C     is at right angles to P(J) - P(I) and midway.
      SUBROUTINE TRCLIP(N, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW,
     1                  ROW, OTHER, AREA, VOLUME, MOST, IWORK, WORK,
     2                  INFO)
      INTEGER N, TET(4,*), ADJ(4,*), FIRST(*), LIST(*), MAXROW, NROW
      INTEGER ROW(*), OTHER(*), MOST, IWORK(*), INFO
      DOUBLE PRECISION P(3,*), BOX(6), AREA(*), VOLUME(*), WORK(*)
      INTEGER I, J, NFACE, NVERT, TRPROP
      NROW = 0
      INFO = -7
      IF (TRPROP(BOX) .EQ. 0) RETURN
      ROW(1) = 1
      DO 20 I = 1, N
         CALL TRCELL(P, TET, ADJ, FIRST, LIST, I, BOX, 1, MOST, NFACE,
     1               IWORK(1), WORK(1), VOLUME(I), IWORK(MOST+1),
     2               IWORK(2*MOST+2), NVERT, WORK(MOST+1),
     3               IWORK(8*MOST+2), WORK(10*MOST+1), INFO)
         IF (INFO .EQ. 1) THEN
C           For the others, too, not only for this cell.
            NROW = NFACE
            DO 5 J = I, N
               NROW = MAX(NROW, FIRST(J+1) - FIRST(J) + 8)
    5       CONTINUE
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

C     TRALPH - the alpha shape: what is left of the hull when all
C     tetrahedra whose ball has a radius larger than a given one are
C     eaten, from outside inwards (H. Edelsbrunner, E. P. Muecke, ACM
C     Trans. Graphics 13, 1994).
C
C       P, NTET, TET, ADJ  (in)  points and mesh
C       RADIUS  (in)   the largest double precision number eats nothing.
C                      Compared with that of TESSBA, which is rounded
C                      outwards: a ball of exactly this radius may be
C                      eaten
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
      SUBROUTINE TRALPH(P, NTET, TET, ADJ, RADIUS, VOIDS, KEEP, MAXFAC,
     1                  NFAC, FAC, STACK, INFO)
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
