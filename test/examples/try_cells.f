C     try_cells.f - cells.f's cells against what they are by definition,
C     volumes that fill boxes, and alpha shapes by tetrahedra and by
C     triangles.
C
C         gfortran -O2 test/examples/try_cells.f
C           test/examples/cells.f test/examples/derived.f
C           f77/tess.f f77/hhpred.f
C
C     try_cells.c is the same in C; both write the same text.
      PROGRAM CELLST
      INTEGER BAD(5), I, SEED
      CHARACTER*48 TESTED(5)
      CHARACTER*3 ANSWER(0:1)
      DATA ANSWER /'yes', 'NO'/
      DATA TESTED /
     1   'cell: polyhedra, Voronoi''s, and fill the box:   ',
     2   'clipped: the same from both sides, fill the box:',
     3   'alpha: volumes by tetrahedra and triangles:     ',
     4   'sizes: coordinates of 1e-100 and 1e100:         ',
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
         BOX(2*K) = 0.9D0 + 0.1D0*K
         BOX(2*K-1) = -1.125D0
         IF (SET .EQ. 2) THEN
            BOX(2*K) = 7.0D0 / 16.0D0
            BOX(2*K-1) = -7.0D0 / 16.0D0
         END IF
   70 CONTINUE
      CALL MESH(M, NTET, BAD)
      END

C     MESH - of the points, and the tetrahedra at each.
      SUBROUTINE MESH(M, NTET, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER M, NTET, BAD
      INTEGER INFO
      CALL TESS(M, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .NE. 0) BAD = 1
      CALL STARS(M, NTET, TET, FIRST, LIST)
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER I, BOXED, NFACE, NVERT, INFO
      DOUBLE PRECISION V
      CALL CELL(P, TET, ADJ, FIRST, LIST, I, BOX, BOXED, MOST, NFACE,
     1          WHOSE, AREA, V, START, CORNER, NVERT, VERT, IWORK, WORK,
     2          INFO)
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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
               D = VERT((-J+1)/2,C) - BOX(-J)
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
     1          (VERT(K,A) .GE. BOX(2*K-1) - 1.0D-12 .AND.
     2           VERT(K,A) .LE. BOX(2*K) + 1.0D-12)) BAD = 1
   60    CONTINUE
   70 CONTINUE
      DO 90 K = 1, 3
         SUM(K) = 0.0D0
         DO 80 F = 1, NFACE
            J = WHOSE(F)
            D = 0.0D0
            IF (J .EQ. 1 - 2*K) D = -1.0D0
            IF (J .EQ. -2*K) D = 1.0D0
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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
         ALL = (BOX(2) - BOX(1))*(BOX(4) - BOX(3))*(BOX(6) - BOX(5))
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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
            DO 10 K = 1, 5, 2
               IF (PART .EQ. 3) BOX(K) = BOX(K) + 10.0D0
               IF (PART .EQ. 3) BOX(K+1) = BOX(K+1) + 20.0D0
   10       CONTINUE
            CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW,
     1                  ROW, OTHER, FACES, VOLUME, MOST, IWORK, WORK,
     2                  INFO)
            IF (INFO .NE. 0) BAD = 1
            ALL = (BOX(2) - BOX(1))*(BOX(4) - BOX(3))*(BOX(6) - BOX(5))
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
               L = 2*((K+1)/2)
               IF (.NOT. (ABS(SIDE(K)*(BOX(L) - BOX(L-1)) - ALL) .LE.
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
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

C     TSIZES - coordinates times powers of two: volumes and areas times
C     theirs; or, where these are beyond numbers, the code.
      SUBROUTINE TSIZES(SEED, BAD)
      INTEGER N, MAXTET, LIW, LRW, MAXROW, MOST
      PARAMETER (N = 343, MAXTET = 10*N, LIW = 19*N + 1800)
      PARAMETER (LRW = 4*N + 12, MAXROW = 40*N, MOST = 300)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MOST), VERT(3,3*MOST)
      DOUBLE PRECISION WORK(17*MOST), FACES(MAXROW), VOLUME(N), BOX(6)
      COMMON /REALS/ P, RW, AREA, VERT, WORK, FACES, VOLUME, BOX
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), FIRST(N+1)
      INTEGER LIST(4*MAXTET), WHOSE(MOST), START(MOST+1)
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION SCALE, A, V, W
      INTEGER M, NTET, I, J, K, NFACE, NVERT, INFO
      DO 50 J = 1, 2
         CALL MAKE(1, SEED, M, NTET, BAD)
         SCALE = 2.0D0**332
         IF (J .EQ. 2) SCALE = 1.0D0 / SCALE
         CALL ONE(8, 1, NFACE, NVERT, V, INFO)
         IF (INFO .NE. 0) BAD = 1
         A = AREA(2)
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
         IF (.NOT. (ABS(AREA(2) / SCALE / SCALE - A) .LE. 1.0D-14))
     1      BAD = 1
         CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, I, ROW,
     1               OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO)
         IF (INFO .NE. 0) BAD = 1
         W = 0.0D0
         DO 32 I = 1, M
            W = W + VOLUME(I) / SCALE / SCALE / SCALE
   32    CONTINUE
         V = (BOX(2) - BOX(1)) / SCALE*((BOX(4) - BOX(3)) / SCALE)*
     1       ((BOX(6) - BOX(5)) / SCALE)
         IF (.NOT. (ABS(W - V) .LE. 1.0D-12*V)) BAD = 1
         CALL ALPHA(P, NTET, TET, ADJ, 0.3D0*SCALE, 1, KEEP, 4*MAXTET,
     1              I, FAC, STACK, INFO)
         IF (INFO .NE. 0 .OR. I .LT. 4) BAD = 1
         SCALE = 2.0D0**30
         IF (J .EQ. 2) SCALE = 1.0D0 / SCALE
         DO 36 I = 1, M
            DO 34 K = 1, 3
               P(K,I) = P(K,I)*SCALE
   34       CONTINUE
   36    CONTINUE
         DO 38 K = 1, 6
            BOX(K) = BOX(K)*SCALE
   38    CONTINUE
         CALL MESH(M, NTET, BAD)
         CALL ONE(8, 1, NFACE, NVERT, W, INFO)
         IF (INFO .NE. 3) BAD = 1
         DO 40 K = 1, 5, 2
            BOX(K) = -1.0D300
            BOX(K+1) = 1.0D300
   40    CONTINUE
         CALL ONE(8, 1, NFACE, NVERT, W, INFO)
         IF (INFO .NE. 3) BAD = 1
   50 CONTINUE
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
      INTEGER CORNER(6*MOST), IWORK(33*MOST+1), ROW(N+1), OTHER(MAXROW)
      INTEGER FAC(3,4*MAXTET), HULL(3,4*MAXTET), STACK(MAXTET)
      INTEGER KEEP(MAXTET)
      COMMON /WHOLES/ TET, ADJ, IW, FIRST, LIST, WHOSE, START, CORNER,
     1                IWORK, ROW, OTHER, FAC, HULL, STACK, KEEP
      INTEGER SEED, BAD
      DOUBLE PRECISION V, SIDE
      INTEGER M, NTET, HELD, NEED, NROW, NFACE, NVERT, I, K, INFO(9)
      INTEGER WANT(9)
      SAVE WANT
      DATA WANT /1, 0, 1, 0, -13, 0, 14, 1, 13/
      CALL MAKE(1, SEED, M, NTET, BAD)
      CALL CELL(P, TET, ADJ, FIRST, LIST, 6, BOX, 1, 10, NEED, WHOSE,
     1          AREA, V, START, CORNER, NVERT, VERT, IWORK, WORK,
     2          INFO(1))
      IF (NEED .LE. MOST)
     1   CALL CELL(P, TET, ADJ, FIRST, LIST, 6, BOX, 1, NEED, NFACE,
     2             WHOSE, AREA, V, START, CORNER, NVERT, VERT, IWORK,
     3             WORK, INFO(2))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, 100, NROW, ROW,
     1            OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO(3))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, NROW, NEED, ROW,
     1            OTHER, FACES, VOLUME, MOST, IWORK, WORK, INFO(4))
      CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW, ROW,
     1            OTHER, FACES, VOLUME, 10, IWORK, WORK, INFO(5))
      DO 5 I = 1, 6
         SIDE = BOX(I)
         IF (MOD(I, 2) .EQ. 1) BOX(I) = BOX(I+1) + 1.0D0
         IF (MOD(I, 2) .EQ. 0) BOX(I) = BOX(I-1) - 1.0D0
         CALL ONE(6, 1, NFACE, NVERT, V, INFO(6))
         IF (INFO(6) .NE. -7) BAD = 1
         CALL CLIPPE(M, P, TET, ADJ, FIRST, LIST, BOX, MAXROW, NROW,
     1               ROW, OTHER, FACES, VOLUME, MOST, IWORK, WORK,
     2               INFO(6))
         INFO(6) = INFO(6) + 7
         IF (INFO(6) .NE. 0) BAD = 1
         BOX(I) = SIDE
    5 CONTINUE
      HELD = ADJ(2,3)
      ADJ(2,3) = NTET + 1
      CALL ALPHA(P, NTET, TET, ADJ, 1.0D0, 1, KEEP, 4*MAXTET, NEED, FAC,
     1           STACK, INFO(7))
      ADJ(2,3) = HELD
      CALL TESS(M, P, 200, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO(8))
      CALL ALPHA(P, NTET, TET, ADJ, 1.0D0, 1, KEEP, 4*MAXTET, NEED, FAC,
     1           STACK, INFO(9))
      DO 10 K = 1, 9
         IF (INFO(K) .NE. WANT(K)) BAD = 1
   10 CONTINUE
      CALL STARS(M, NTET, TET, FIRST, LIST)
      NEED = 0
      DO 20 I = 1, M
         K = I
         CALL ONE(K, 1, NFACE, NVERT, V, INFO(1))
         IF (INFO(1) .EQ. 13) NEED = NEED + 1
   20 CONTINUE
      IF (NEED .EQ. 0) BAD = 1
      END
