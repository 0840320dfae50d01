C     parts.f - a mesh by threads of OpenMP.
C
C       gfortran -O2 -fopenmp -frecursive -o parts
C           test/samples/parts.f test/recipes/join.f
C           f77/tess.f f77/hhpred.f
C
C     The points are sorted once, by TESSIX.  Each thread takes a range
C     of places in the sorted order, and has TESSPA compute all
C     tetrahedra at these points: RW is shared, IWS its own copy of IW.
C     The parts are joined by join.f, which says how, without geometry.
C     TESSCH proves the result.
C
C     Without OpenMP the parts come one after the other.  parts.c is the
C     same in C with POSIX threads, and writes the same.
      PROGRAM PARTS
      INTEGER N, NPARTS, MAXTET, MOST, FIXED, LIW, LRW
      PARAMETER (N = 20000, NPARTS = 4, MAXTET = 8*N, MOST = 5*N)
      PARAMETER (FIXED = 7*N + 600)
      PARAMETER (LIW = FIXED + 30*(N/NPARTS + 1), LRW = 4*N)
      DOUBLE PRECISION P(3,N), RW(LRW)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(MAXTET), MINE(N,NPARTS)
      INTEGER IWS(LIW,NPARTS), TETS(4,MOST,NPARTS)
      INTEGER ADJS(4,MOST,NPARTS), BECOME(MOST,NPARTS), NT(NPARTS)
      INTEGER KEPT(NPARTS), BASE(NPARTS), INFO(NPARTS)
      INTEGER BAD, CODE, I, K, NTET, OPEN, SEED, T
C     what is large stays where all threads see it
      COMMON /SHARED/ P, RW, TET, ADJ, IW, MINE, IWS, TETS, ADJS, BECOME
      SEED = 1
      DO 20 I = 1, N
        DO 10 K = 1, 3
          SEED = 16807*MOD(SEED, 127773) - 2836*(SEED/127773)
          IF (SEED .LE. 0) SEED = SEED + 2147483647
          P(K,I) = DBLE(SEED)/2147483648.0D0
   10   CONTINUE
   20 CONTINUE
      CALL TESSIX(N, P, MAXTET, IW, LRW, RW, CODE)
      WRITE (*, 90) N, CODE
   90 FORMAT (I5, ' points, tess_index: ', I1)
C$OMP PARALLEL DO
      DO 30 I = 1, NPARTS
        CALL COMPUT(I, NPARTS, N, P, FIXED, IW, MINE(1,I), MOST, NT(I),
     $              TETS(1,1,I), ADJS(1,1,I), LIW, IWS(1,I), LRW, RW,
     $              INFO(I))
        CALL TRKEEP(NT(I), TETS(1,1,I), MINE(1,I), BECOME(1,I), KEPT(I))
   30 CONTINUE
C$OMP END PARALLEL DO
      NTET = 0
      DO 40 I = 1, NPARTS
        WRITE (*, 91) I, INFO(I), NT(I), KEPT(I)
   91   FORMAT ('part ', I1, ': tess_part ', I1, ', ', I5,
     $          ' tetrahedra, ', I5, ' kept')
        BASE(I) = NTET
        NTET = NTET + KEPT(I)
   40 CONTINUE
      IF (NTET .GT. MAXTET) STOP
C$OMP PARALLEL DO
      DO 50 I = 1, NPARTS
        CALL TRAPPE(NT(I), TETS(1,1,I), ADJS(1,1,I), BECOME(1,I),
     $              BASE(I), TET, ADJ)
   50 CONTINUE
C$OMP END PARALLEL DO
      OPEN = 0
      DO 70 T = 1, NTET
        DO 60 K = 1, 4
          IF (ADJ(K,T) .EQ. -1) OPEN = OPEN + 1
   60   CONTINUE
   70 CONTINUE
      WRITE (*, 92) NTET, OPEN
   92 FORMAT ('together: ', I6, ' tetrahedra, ', I5, ' facets open')
      CALL TRJOIN(NTET, TET, ADJ, MAXTET, IW, CODE)
      WRITE (*, 93) CODE
   93 FORMAT ('join: ', I1)
      CALL TESSCH(N, P, NTET, TET, ADJ, MAXTET, IW, BAD, CODE)
      WRITE (*, 94) CODE
   94 FORMAT ('tess_check: ', I1)
      END

C     COMPUT - one thread's work: part I of NPARTS.
      SUBROUTINE COMPUT(I, NPARTS, N, P, FIXED, IW, MINE, MOST, NT,
     $                  TETS, ADJS, LIW, IWS, LRW, RW, INFO)
      INTEGER I, NPARTS, N, FIXED, IW(*), MINE(*), MOST, NT, TETS(4,*)
      INTEGER ADJS(4,*), LIW, IWS(*), LRW, INFO
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER J
      DO 10 J = 1, N
        MINE(J) = 0
        IF (INT(DBLE(IW(J) - 1)*NPARTS/N) .EQ. I - 1) MINE(J) = 1
   10 CONTINUE
      DO 20 J = 1, FIXED
        IWS(J) = IW(J)
   20 CONTINUE
      NT = 0
      CALL TESSPA(N, P, MINE, MOST, NT, TETS, ADJS, LIW, IWS, LRW, RW,
     $            INFO)
      END
