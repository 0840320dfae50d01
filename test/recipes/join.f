C     join.f - a mesh in parts, joined: recipes to copy.
C
C       TRKEEP, TRAPPE  what the parts keep, put together
C       TRJOIN          neighbours across the facets that are still
C                       open  (TRONSI)
C
C     For meshes by several threads; parts.f is a program that does it,
C     and join.c the same in C.
C
C       1. TESSIX sorts the points, in an IW of 7*N + 600 or what
C          TESSWK says.  RW is shared by all, the first 7*N + 600
C          numbers of IW are copied for each thread.
C       2. Each thread asks TESSPA for the points of a range of
C          positions (IW(I)), of about the same length, so for points
C          near each other.
C       3. TRKEEP tells which of its tetrahedra the part keeps, those
C          whose vertex of least number is asked for there: each
C          tetrahedron of the mesh is kept by one part.  TRAPPE puts
C          these behind those of the parts before; the threads may do it
C          at the same time.
C       4. TRJOIN closes the facets that are open.  No geometry: both
C          sides of a facet have the same vertices.
C
C     The result is the set of tetrahedra that TESS gives, in another
C     order, and passes TESSCH.  If a part is missing, TESSRE computes
C     it: let what was -1 in ADJ before TRJOIN and is 0 behind it be -1
C     again.
C
C     Workspace of TESSPA for M points asked for: LIW = 7*N + 600 +
C     19*M + 1800.  join.c says why, and when it is too little.

C     TRKEEP - which tetrahedra of a part are kept?
C       NT, TET  (in)   what TESSPA gave
C       MINE     (in)   as given to TESSPA, of points none of which is a
C                       duplicate or those with their duplicates in one
C                       part
C       BECOME   (out)  NT: the number among those kept, or -1
C       KEPT     (out)  how many
      SUBROUTINE TRKEEP(NT, TET, MINE, BECOME, KEPT)
      INTEGER NT, TET(4,*), MINE(*), BECOME(*), KEPT
      INTEGER LEAST, T
      KEPT = 0
      DO 10 T = 1, NT
        LEAST = MIN(TET(1,T), TET(2,T), TET(3,T), TET(4,T))
        BECOME(T) = -1
        IF (MINE(LEAST) .NE. 0) THEN
          KEPT = KEPT + 1
          BECOME(T) = KEPT
        END IF
   10 CONTINUE
      END

C     TRAPPE - put what a part keeps into the result.
C       NT, TET, ADJ  (in)      what TESSPA gave
C       BECOME        (in)      what TRKEEP gave
C       BASE          (in)      how many the parts before keep
C       ALL, ALLADJ   (in,out)  the result: TET and ADJ of those kept,
C                               behind BASE; neighbours that others keep
C                               are open, -1
      SUBROUTINE TRAPPE(NT, TET, ADJ, BECOME, BASE, ALL, ALLADJ)
      INTEGER NT, TET(4,*), ADJ(4,*), BECOME(*), BASE, ALL(4,*)
      INTEGER ALLADJ(4,*)
      INTEGER K, T, U
      DO 20 T = 1, NT
        IF (BECOME(T) .LT. 0) GO TO 20
        DO 10 K = 1, 4
          U = ADJ(K,T)
          IF (U .GT. 0) THEN
            U = BECOME(U)
            IF (U .GT. 0) U = U + BASE
          END IF
          ALL(K,BASE+BECOME(T)) = TET(K,T)
          ALLADJ(K,BASE+BECOME(T)) = U
   10   CONTINUE
   20 CONTINUE
      END

C     TRONSI - V = the vertices of facet K of tetrahedron T, in order;
C     SIDE = which side of it the tetrahedron is on, 0 or 1.
      SUBROUTINE TRONSI(TET, T, K, V, SIDE)
      INTEGER TET(4,*), T, K, V(3), SIDE
      INTEGER I, J, N, SWAP
      SIDE = MOD(K - 1, 2)
      N = 0
      DO 10 I = 1, 4
        IF (I .EQ. K) GO TO 10
        N = N + 1
        V(N) = TET(I,T)
   10 CONTINUE
      DO 20 I = 0, 2
        J = MOD(I, 2) + 1
        IF (V(J) .GT. V(J+1)) THEN
          SWAP = V(J)
          V(J) = V(J+1)
          V(J+1) = SWAP
          SIDE = 1 - SIDE
        END IF
   20 CONTINUE
      END

C     TRJOIN - close the facets that are open on both sides.  What is
C     open on one side alone is then on the hull.
C       NT, TET  (in)      all tetrahedra of the mesh, each once
C       ADJ      (in,out)  neighbours; -1 where they are sought
C       LH       (in)      length of H, more than there are open facets:
C                          TESS's workspace will do
C       H        (out)     a hash table of facets
C       INFO     (out)     0; 1 where more than one tetrahedron is on a
C                          side of a facet; -4 for an LH that is too
C                          small
C     Cost: two passes over ADJ, and a visit to the table for each open
C     facet.  (The remainders keep products below 2**31.)
      SUBROUTINE TRJOIN(NT, TET, ADJ, LH, H, INFO)
      INTEGER NT, TET(4,*), ADJ(4,*), LH, H(*), INFO
      INTEGER AT, I, K, OPEN, OTHER, SIDE, SIZE, T, U, UK, V(3), W(3)
      OPEN = 0
      DO 20 T = 1, NT
        DO 10 K = 1, 4
          IF (ADJ(K,T) .EQ. -1) OPEN = OPEN + 1
   10   CONTINUE
   20 CONTINUE
      INFO = -4
      IF (LH .LE. OPEN) RETURN
      SIZE = LH
      IF (OPEN .LT. LH/2) SIZE = 2*OPEN + 1
      DO 30 I = 1, SIZE
        H(I) = 0
   30 CONTINUE
      INFO = 1
      DO 60 T = 1, NT
        DO 50 K = 1, 4
          IF (ADJ(K,T) .NE. -1) GO TO 50
          CALL TRONSI(TET, T, K, V, SIDE)
          AT = MOD(V(1), 32771)*40503 + MOD(V(2), 32771)*20011
          AT = MOD(AT, SIZE)/2 + MOD(MOD(V(3), 32771)*30011, SIZE)/2 + 1
C         as long as there is another facet at AT
   40     IF (H(AT) .NE. 0) THEN
            U = (H(AT) - 1)/4 + 1
            UK = MOD(H(AT) - 1, 4) + 1
            CALL TRONSI(TET, U, UK, W, OTHER)
            IF (V(1) .NE. W(1) .OR. V(2) .NE. W(2) .OR.
     $          V(3) .NE. W(3)) THEN
              AT = AT - 1
              IF (AT .EQ. 0) AT = SIZE
              GO TO 40
            END IF
            IF (SIDE .EQ. OTHER .OR. ADJ(UK,U) .NE. -1) RETURN
            ADJ(UK,U) = T
            ADJ(K,T) = U
          ELSE
            H(AT) = 4*(T - 1) + K
          END IF
   50   CONTINUE
   60 CONTINUE
      DO 80 T = 1, NT
        DO 70 K = 1, 4
          IF (ADJ(K,T) .EQ. -1) ADJ(K,T) = 0
   70   CONTINUE
   80 CONTINUE
      INFO = 0
      END
