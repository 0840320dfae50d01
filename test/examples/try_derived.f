C     try_derived.f - tests of derived.f: against brute force, and by
C     identities that hold for any set of points.  try_derived.c is the
C     same in C, and both write the same text.
C
C         gfortran -O2 test/examples/try_derived.f
C        1    test/examples/derived.f f77/tess.f f77/hhpred.f
C
      PROGRAM DERIVE
      INTEGER N, MAXTET, MAXEDG, MAXFAC, LIW, LRW
      PARAMETER (N = 343, MAXTET = 12*N, MAXEDG = 2*MAXTET)
      PARAMETER (MAXFAC = 4*MAXTET, LIW = 19*N + 1800, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), AREA(MAXEDG), CELL(N), FLUX(3,N)
      DOUBLE PRECISION VALUE(N), AREAS(MAXEDG), CELLV(N)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), EDGE(2,MAXEDG)
      INTEGER AT(MAXEDG), FACE(3,MAXFAC), BOTH(2,MAXFAC)
      INTEGER HULL(3,MAXFAC), FIRST(N+1), LIST(4*MAXTET), OUTER(N)
      INTEGER SEEN(N,N), BAD(8), SET, M, NTET, NEDGE, NFACE, NHULL
      INTEGER CELLS, INFO, INFO1, INFO2, INFO3, I, SEED
      CHARACTER*7 NAME(3)
      CHARACTER*50 TESTED(8)
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
     7   'gradient: of linear fields, and along edges:      ',
     8   'sizes: balls and cells of 1e-90 and 1e90:         '/
      SEED = 1
      DO 10 I = 1, 8
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
         CALL TSIZES(M, P, NTET, TET, ADJ, NEDGE, EDGE, AT, AREA, CELL,
     1               OUTER, AREAS, CELLV, BAD(8))
   30 CONTINUE
      DO 40 I = 1, 8
         WRITE (*, 70) TESTED(I), ANSWER(BAD(I))
   40 CONTINUE
   50 FORMAT ('set      points  tetrahedra  edges  faces  ',
     1        'hull facets  inner cells')
   60 FORMAT (A7, 2X, I6, 2X, I10, 2X, I5, 2X, I5, 2X, I11, 2X, I11)
   70 FORMAT (A50, A)
      END

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
      DOUBLE PRECISION X(3), R, DERDOT
      INTEGER I, K
      N = 300
      IF (SET .EQ. 2) N = 343
      DO 40 I = 1, N
   10    CONTINUE
         DO 20 K = 1, 3
            CALL RANDOM(SEED, X(K))
            X(K) = 2.0D0*X(K) - 1.0D0
   20    CONTINUE
         IF (SET .EQ. 3 .AND. .NOT. (DERDOT(X, X) .GT. 0.01D0 .AND.
     1       DERDOT(X, X) .LT. 1.0D0)) GO TO 10
         R = 1.0D0
         IF (SET .EQ. 3) THEN
            CALL RANDOM(SEED, R)
            R = (0.8D0 + 0.2D0*R) / SQRT(DERDOT(X, X))
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
            CALL DERARO(E, I, J, K, L)
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
      DOUBLE PRECISION Q(3), E(3), LEAST, DERDOT
      INTEGER I, J, K, V
      DO 30 J = 1, 1000
         DO 10 K = 1, 3
            CALL RANDOM(SEED, Q(K))
            Q(K) = 3.0D0*Q(K) - 1.0D0
   10    CONTINUE
         IF (MOD(J, 2) .EQ. 1) V = TET(1,1)
         CALL NEARPT(P, TET, FIRST, LIST, Q, V)
         CALL DERMIN(P(1,V), Q, E)
         LEAST = (1.0D0 - 1.0D-14)*DERDOT(E, E)
         DO 20 I = 1, N
            CALL DERMIN(P(1,I), Q, E)
            IF (DERDOT(E, E) .LT. LEAST) BAD = 1
   20    CONTINUE
   30 CONTINUE
      END

C     WHOLE - the volume of the hull, from its facets.
      DOUBLE PRECISION FUNCTION WHOLE(P, NHULL, HULL)
      DOUBLE PRECISION P(3,*)
      INTEGER NHULL, HULL(3,*)
      DOUBLE PRECISION A(3,3), D(3), DERDOT
      INTEGER I, J, K
      WHOLE = 0.0D0
      DO 30 I = 1, NHULL
         DO 20 J = 1, 3
            DO 10 K = 1, 3
               A(K,J) = P(K,HULL(J,I)) - P(K,1)
   10       CONTINUE
   20    CONTINUE
         CALL DERCRO(A(1,2), A(1,3), D)
         WHOLE = WHOLE + DERDOT(A(1,1), D) / 6.0D0
   30 CONTINUE
      END

C     The centre of a tetrahedron of size 1 and volume V is known to
C     about eps / V**2 at worst: where that is too little nothing is
C     asked.
      SUBROUTINE TMEASU(N, P, NTET, TET, NHULL, HULL, BAD)
      INTEGER N, NTET, TET(4,*), NHULL, HULL(3,*), BAD
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION VOLUME, C(3), RADIUS, D(3), SUM, FAR, SLACK
      DOUBLE PRECISION DERDOT, WHOLE
      INTEGER T, I, OTHER
      SUM = 0.0D0
      DO 20 T = 1, NTET
         CALL MEASUR(P, TET(1,T), VOLUME, C, RADIUS)
         IF (.NOT. (VOLUME .GT. 0.0D0)) BAD = 1
         SUM = SUM + VOLUME
         SLACK = 1.0D-15*(1.0D0 + RADIUS) / VOLUME**2
C        No point is in the ball, the vertices are on it.
         DO 10 I = 1, N
            CALL DERMIN(P(1,I), C, D)
            FAR = SQRT(DERDOT(D, D)) - RADIUS
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
      DOUBLE PRECISION SUM, E(3), LENGTH, WANT, ROUND, DERDOT, WHOLE
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
         CALL DERMIN(P(1,B), P(1,A), E)
         LENGTH = SQRT(DERDOT(E, E))
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
      DOUBLE PRECISION G(3), E(3), C(3), WANT(3), VOLUME, RADIUS, DERDOT
      INTEGER T, I, K
      SAVE WANT
      DATA WANT /2.0D0, -3.0D0, 0.5D0/
      DO 10 I = 1, N
         VALUE(I) = 7.0D0 + DERDOT(WANT, P(1,I))
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
            CALL DERMIN(P(1,TET(K,T)), P(1,TET(1,T)), E)
            IF (ABS(DERDOT(G, E) + VALUE(TET(1,T)) - VALUE(TET(K,T)))
     1          .GT. 1.0D-14 / VOLUME) BAD = 1
   50    CONTINUE
   60 CONTINUE
      END

C     TSIZES - points times a power of two have balls and cells times
C     it.
      SUBROUTINE TSIZES(N, P, NTET, TET, ADJ, NEDGE, EDGE, AT, AREA,
     1                  CELL, OUTER, AREAS, CELLV, BAD)
      INTEGER N, NTET, TET(4,*), ADJ(4,*), NEDGE, EDGE(2,*), AT(*)
      INTEGER OUTER(*), BAD
      DOUBLE PRECISION P(3,*), AREA(*), CELL(*), AREAS(*), CELLV(*)
      DOUBLE PRECISION VOLUME(2), C(3,2), RADIUS(2), SCALE, S
      INTEGER I, J, K, T
      DO 90 J = 1, 2
         SCALE = 2.0D0**300
         IF (J .EQ. 2) SCALE = 1.0D0 / SCALE
         DO 40 T = 1, NTET
            S = SCALE
            DO 20 K = 1, 2
               CALL MEASUR(P, TET(1,T), VOLUME(K), C(1,K), RADIUS(K))
               DO 10 I = 1, 4
                  P(1,TET(I,T)) = P(1,TET(I,T))*S
                  P(2,TET(I,T)) = P(2,TET(I,T))*S
                  P(3,TET(I,T)) = P(3,TET(I,T))*S
   10          CONTINUE
               S = 1.0D0 / SCALE
   20       CONTINUE
            IF (VOLUME(1) .NE. VOLUME(2) / SCALE / SCALE / SCALE)
     1         BAD = 1
            IF (RADIUS(1) .NE. RADIUS(2) / SCALE) BAD = 1
            DO 30 K = 1, 3
               IF (C(K,1) .NE. C(K,2) / SCALE) BAD = 1
   30       CONTINUE
   40    CONTINUE
         DO 50 I = 1, N
            P(1,I) = P(1,I)*SCALE
            P(2,I) = P(2,I)*SCALE
            P(3,I) = P(3,I)*SCALE
   50    CONTINUE
         CALL DUAL(N, P, TET, ADJ, NEDGE, EDGE, AT, AREAS, CELLV, OUTER)
         DO 60 I = 1, N
            P(1,I) = P(1,I) / SCALE
            P(2,I) = P(2,I) / SCALE
            P(3,I) = P(3,I) / SCALE
   60    CONTINUE
         DO 70 I = 1, NEDGE
            IF (AREAS(I) / SCALE / SCALE .NE. AREA(I)) BAD = 1
   70    CONTINUE
         DO 80 I = 1, N
            IF (CELLV(I) / SCALE / SCALE / SCALE .NE. CELL(I)) BAD = 1
   80    CONTINUE
   90 CONTINUE
      END
