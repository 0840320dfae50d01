C     parts.f - a mesh in parts, by threads of OpenMP, that are joined.
C
C       gfortran -O2 -fopenmp -frecursive -o parts
C           test/examples/parts.f f77/tess.f f77/hhpred.f
C
C     The points are sorted once, by TESSIX.  Each thread takes a range
C     of places in the sorted order, so points that are near each other,
C     and has TESSPA compute all tetrahedra at them: RW is shared, IWS
C     its own copy of IW.  What it keeps are those whose vertex of least
C     number is its own; so each tetrahedron is kept by one thread.  One
C     behind the other, with neighbours renumbered, and open where
C     another thread has them, they are an unfinished result, of which
C     TESSRE matches the facets.  TESSCH proves it.
C
C     Without OpenMP the parts come one after the other.  parts.c is the
C     same in C with POSIX threads, and writes the same.
      PROGRAM PARTS
      INTEGER N, NPARTS, MAXTET, MOST, LIW, LRW
      PARAMETER (N = 20000, NPARTS = 4, MAXTET = 8*N, MOST = 5*N)
      PARAMETER (LIW = 40*N, LRW = 4*N)
      DOUBLE PRECISION P(3,N), RW(LRW), RW2(LRW)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW), MINE(N,NPARTS)
      INTEGER IWS(LIW,NPARTS), TETS(4,MOST,NPARTS)
      INTEGER ADJS(4,MOST,NPARTS), BECOME(MOST,NPARTS), NT(NPARTS)
      INTEGER KEPT(NPARTS), INFO(NPARTS)
      INTEGER BAD, CODE, I, K, NTET, OPEN, SEED, T
C     what is large stays where all threads see it
      COMMON /SHARED/ P, RW, RW2, TET, ADJ, IW, MINE, IWS, TETS, ADJS,
     $    BECOME
      SEED = 1
      DO 20 I = 1, N
        DO 10 K = 1, 3
          SEED = 16807*MOD(SEED, 127773) - 2836*(SEED/127773)
          IF (SEED .LE. 0) SEED = SEED + 2147483647
          P(K,I) = DBLE(SEED)/2147483648.0D0
   10   CONTINUE
   20 CONTINUE
      CALL TESSIX(N, P, LIW, IW, LRW, RW, CODE)
      WRITE (*, 90) N, CODE
   90 FORMAT (I5, ' points, tess_index: ', I1)
C$OMP PARALLEL DO
      DO 30 I = 1, NPARTS
        CALL COMPUT(I, NPARTS, N, P, IW, MINE(1,I), MOST, NT(I),
     $              TETS(1,1,I), ADJS(1,1,I), LIW, IWS(1,I), LRW, RW,
     $              BECOME(1,I), KEPT(I), INFO(I))
   30 CONTINUE
C$OMP END PARALLEL DO
      NTET = 0
      DO 40 I = 1, NPARTS
        WRITE (*, 91) I, INFO(I), NT(I), KEPT(I)
   91   FORMAT ('part ', I1, ': tess_part ', I1, ', ', I5,
     $          ' tetrahedra, ', I5, ' kept')
        CALL APPEND(NT(I), TETS(1,1,I), ADJS(1,1,I), BECOME(1,I),
     $              NTET, TET, ADJ)
        NTET = NTET + KEPT(I)
   40 CONTINUE
      OPEN = 0
      DO 60 T = 1, NTET
        DO 50 K = 1, 4
          IF (ADJ(K,T) .EQ. -1) OPEN = OPEN + 1
   50   CONTINUE
   60 CONTINUE
      WRITE (*, 92) NTET, OPEN
   92 FORMAT ('joined: ', I6, ' tetrahedra, ', I5, ' facets open')
      CALL TESSRE(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW2, CODE)
      WRITE (*, 93) CODE, NTET
   93 FORMAT ('tess_resume: ', I1, ', ', I6, ' tetrahedra')
      CALL TESSCH(N, P, NTET, TET, ADJ, LIW, IW, BAD, CODE)
      WRITE (*, 94) CODE
   94 FORMAT ('tess_check: ', I1)
      END

C     COMPUT - one thread's work: part I of NPARTS.
      SUBROUTINE COMPUT(I, NPARTS, N, P, IW, MINE, MOST, NT, TETS, ADJS,
     $                  LIW, IWS, LRW, RW, BECOME, KEPT, INFO)
      INTEGER I, NPARTS, N, IW(*), MINE(*), MOST, NT, TETS(4,*)
      INTEGER ADJS(4,*), LIW, IWS(*), LRW, BECOME(*), KEPT, INFO
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER J, LEAST, T
      DO 10 J = 1, N
        MINE(J) = 0
        IF (INT(DBLE(IW(J) - 1)*NPARTS/N) .EQ. I - 1) MINE(J) = 1
   10 CONTINUE
      DO 20 J = 1, LIW
        IWS(J) = IW(J)
   20 CONTINUE
      NT = 0
      CALL TESSPA(N, P, MINE, MOST, NT, TETS, ADJS, LIW, IWS, LRW, RW,
     $            INFO)
      KEPT = 0
      DO 30 T = 1, NT
        LEAST = MIN(TETS(1,T), TETS(2,T), TETS(3,T), TETS(4,T))
        BECOME(T) = 0
        IF (MINE(LEAST) .EQ. 1) THEN
          KEPT = KEPT + 1
          BECOME(T) = KEPT
        END IF
   30 CONTINUE
      END

C     APPEND - put behind the NTET tetrahedra there are what a part
C     keeps.
      SUBROUTINE APPEND(NT, TETS, ADJS, BECOME, NTET, TET, ADJ)
      INTEGER NT, TETS(4,*), ADJS(4,*), BECOME(*), NTET, TET(4,*)
      INTEGER ADJ(4,*)
      INTEGER K, T, U
      DO 20 T = 1, NT
        IF (BECOME(T) .EQ. 0) GO TO 20
        DO 10 K = 1, 4
          U = ADJS(K,T)
          IF (U .GT. 0) THEN
            U = BECOME(U)
            IF (U .GT. 0) THEN
              U = U + NTET
            ELSE
              U = -1
            END IF
          END IF
          TET(K,NTET+BECOME(T)) = TETS(K,T)
          ADJ(K,NTET+BECOME(T)) = U
   10   CONTINUE
   20 CONTINUE
      END
