C     spread.f - a mesh of points that no process holds whole, with MPI.
C
C       mpif77 -O2 -frecursive -o spread test/mpi/spread.f f77/tess.f
C           f77/hhpred.f
C       mpirun -np 4 spread
C
C     What spread.c does, where the steps are explained, in FORTRAN 77,
C     with four sets of points of its own: at random, in clusters, a
C     lattice, and a box mesh with steps that grow.  (But for the names
C     of MPI and the file with its constants, nothing here is beyond
C     FORTRAN 77.)
C
C     Each process owns a block of the points and computes the
C     tetrahedra at them from the points that it knows, at first its own
C     and those on the hulls of the other blocks.  It asks the processes
C     whose box a tetrahedron's ball meets for a point in the ball or on
C     the sphere, and computes again, until nobody gets a new point.
C     The points known are kept in the order of their numbers in the
C     whole, by which ties go.
C
C     COMMON /KNOWN/    what a process knows: N points, their NUMBERs in
C                       the whole, which are MINE; NTET tetrahedra at
C                       those; SENT(J,R), the round in which process R
C                       was sent point J of the whole, or -1
C     COMMON /MESSAG/   messages from and to all processes, their boxes
C     COMMON /WHOLE/    all points; of process 1 alone
      PROGRAM SPREAD
      INCLUDE 'mpif.h'
      INTEGER CODE, KIND, ME, RANKS
      LOGICAL GOOD, SAME
      CALL MPI_INIT(CODE)
      CALL MPI_COMM_RANK(MPI_COMM_WORLD, ME, CODE)
      CALL MPI_COMM_SIZE(MPI_COMM_WORLD, RANKS, CODE)
      ME = ME + 1
      GOOD = RANKS .LE. 4
      IF (.NOT. GOOD) CALL MPI_ABORT(MPI_COMM_WORLD, 2, CODE)
      DO 10 KIND = 1, 4
        CALL ONESET(KIND, ME, RANKS, SAME)
        GOOD = GOOD .AND. SAME
   10 CONTINUE
      IF (GOOD .AND. ME .EQ. 1) WRITE (*, '(A)') 'all are the mesh'
      CALL MPI_FINALIZE(CODE)
      END

C     ONESET - one set of points; SAME: it is the mesh, or ME is not 1.
      SUBROUTINE ONESET(KIND, ME, RANKS, SAME)
      INCLUDE 'mpif.h'
      INTEGER KIND, ME, RANKS
      LOGICAL SAME
      INTEGER MAXN, MAXTET, LIW, LRW
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION COUNTS(2), TOTAL(2)
      INTEGER ALL, CODE, FOUND, FRESH, ROUND
      CALL DEAL(KIND, ME, RANKS)
      COUNTS(1) = N
      CALL HULL(ME, RANKS)
      ROUND = 0
   10 ROUND = ROUND + 1
        NTET = 0
        CALL TESSIX(N, P, LIW, IW, LRW, RW, CODE)
        IF (CODE .EQ. 0) CALL TESSPA(N, P, MINE, MAXTET, NTET, TET,
     $      ADJ, LIW, IW, LRW, RW, CODE)
        IF (CODE .NE. 0) CALL MPI_ABORT(MPI_COMM_WORLD, 1, CODE)
        CALL ASK(ME, RANKS)
        CALL ANSWER(ROUND, RANKS)
        CALL LEARN(0, RANKS, FRESH)
        CALL MPI_ALLREDUCE(FRESH, ALL, 1, MPI_INTEGER, MPI_SUM,
     $      MPI_COMM_WORLD, CODE)
      IF (ALL .GT. 0) GO TO 10
      COUNTS(2) = N
      CALL MPI_REDUCE(COUNTS, TOTAL, 2, MPI_DOUBLE_PRECISION, MPI_SUM,
     $    0, MPI_COMM_WORLD, CODE)
      CALL COMPAR(ME, RANKS, INT(TOTAL(1)), FOUND, SAME)
      IF (ME .NE. 1) RETURN
      WRITE (*, 90) KIND, TOTAL(1), RANKS, ROUND,
     $    TOTAL(2)/TOTAL(1)/RANKS, FOUND
   90 FORMAT ('set ', I1, ': ', F5.0, ' points, ', I1, ' processes: ',
     $    I2, ' rounds, ', F4.2, ' of the points known, ', I5,
     $    ' tetrahedra')
      IF (.NOT. SAME) WRITE (*, '(A)') 'NOT THE MESH'
      END

C     MAKE - the points of a set.
      SUBROUTINE MAKE(KIND, N, P)
      INTEGER KIND, N
      DOUBLE PRECISION P(3,*)
      INTEGER I, K, SEED
      DOUBLE PRECISION X(3), STEP(10)
      N = 1000
      SEED = 1
      STEP(1) = 0.0D0
      DO 10 I = 2, 10
        STEP(I) = STEP(I-1) + 1.3D0**I
   10 CONTINUE
      DO 30 I = 1, N
        DO 20 K = 1, 3
          SEED = 16807*MOD(SEED, 127773) - 2836*(SEED/127773)
          IF (SEED .LE. 0) SEED = SEED + 2147483647
          X(K) = DBLE(SEED)/2147483648.0D0
          IF (KIND .EQ. 2) X(K) = X(K)/64 +
     $        DBLE(MOD((MOD(I, 8) + 1)*(3*K + 4), 17))/16
          IF (KIND .EQ. 3) X(K) = MOD((I - 1)/10**(K - 1), 10)
          IF (KIND .EQ. 4) X(K) = STEP(1 + MOD((I - 1)/10**(K - 1), 10))
          P(K,I) = X(K)
   20   CONTINUE
   30 CONTINUE
      END

C     PUT - put M doubles into the message to process R.
      SUBROUTINE PUT(R, X, M)
      INCLUDE 'mpif.h'
      INTEGER R, M
      DOUBLE PRECISION X(*)
      INTEGER ROOM
      PARAMETER (ROOM = 160000)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      INTEGER CODE, K
      IF (NOUT(R) + M .GT. ROOM) CALL MPI_ABORT(MPI_COMM_WORLD, 1, CODE)
      DO 10 K = 1, M
        OUT(NOUT(R)+K,R) = X(K)
   10 CONTINUE
      NOUT(R) = NOUT(R) + M
      END

C     GIVE - put the point at I of those known, and note that R has it.
      SUBROUTINE GIVE(R, I, ROUND)
      INTEGER R, I, ROUND
      INTEGER MAXN, MAXTET, LIW, LRW
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION X(4)
      IF (SENT(NUMBER(I),R) .NE. -1) RETURN
      SENT(NUMBER(I),R) = ROUND
      X(1) = NUMBER(I)
      X(2) = P(1,I)
      X(3) = P(2,I)
      X(4) = P(3,I)
      CALL PUT(R, X, 4)
      END

C     CHANGE - send all messages, receive those of the others.
      SUBROUTINE CHANGE(RANKS)
      INCLUDE 'mpif.h'
      INTEGER RANKS
      INTEGER ROOM
      PARAMETER (ROOM = 160000)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      INTEGER BEGIN(4), CODE, R
      DO 10 R = 1, RANKS
        BEGIN(R) = (R - 1)*ROOM
   10 CONTINUE
      CALL MPI_ALLTOALL(NOUT, 1, MPI_INTEGER, NIN, 1, MPI_INTEGER,
     $    MPI_COMM_WORLD, CODE)
      CALL MPI_ALLTOALLV(OUT, NOUT, BEGIN, MPI_DOUBLE_PRECISION, IN,
     $    NIN, BEGIN, MPI_DOUBLE_PRECISION, MPI_COMM_WORLD, CODE)
      DO 20 R = 1, RANKS
        NOUT(R) = 0
   20 CONTINUE
      END

C     LEARN - take the points that came into those known, each at its
C     number's place.
      SUBROUTINE LEARN(OWN, RANKS, FRESH)
      INTEGER OWN, RANKS, FRESH
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      INTEGER I, J, K, M, R
      FRESH = 0
      DO 60 R = 1, RANKS
        DO 50 M = 1, NIN(R), 4
          J = INT(IN(M,R))
          I = N
   10     IF (I .EQ. 0) GO TO 20
          IF (NUMBER(I) .EQ. J) GO TO 50
          IF (NUMBER(I) .LT. J) GO TO 20
          I = I - 1
          GO TO 10
   20     DO 30 K = N, I + 1, -1
            NUMBER(K+1) = NUMBER(K)
            MINE(K+1) = MINE(K)
            P(1,K+1) = P(1,K)
            P(2,K+1) = P(2,K)
            P(3,K+1) = P(3,K)
   30     CONTINUE
          NUMBER(I+1) = J
          MINE(I+1) = OWN
          DO 40 K = 1, 3
            P(K,I+1) = IN(M+K,R)
   40     CONTINUE
          N = N + 1
          FRESH = FRESH + 1
   50   CONTINUE
   60 CONTINUE
      END

C     DEAL - process 1 gives each process the points of a range of
C     the sorted order.
      SUBROUTINE DEAL(KIND, ME, RANKS)
      INTEGER KIND, ME, RANKS
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      DOUBLE PRECISION WHOLE
      COMMON /WHOLE/ WHOLE(3,MAXN)
      DOUBLE PRECISION X(4)
      INTEGER CODE, COUNT, FRESH, I, K, R
      N = 0
      DO 20 R = 1, 4
        NOUT(R) = 0
        DO 10 I = 1, MAXN
          SENT(I,R) = -1
   10   CONTINUE
   20 CONTINUE
      IF (ME .EQ. 1) THEN
        CALL MAKE(KIND, COUNT, WHOLE)
        CALL TESSIX(COUNT, WHOLE, LIW, IW, LRW, RW, CODE)
        DO 40 I = 1, COUNT
          X(1) = I
          DO 30 K = 1, 3
            X(K+1) = WHOLE(K,I)
   30     CONTINUE
          CALL PUT(1 + (IW(I) - 1)*RANKS/COUNT, X, 4)
   40   CONTINUE
      END IF
      CALL CHANGE(RANKS)
      CALL LEARN(1, RANKS, FRESH)
      END

C     HULL - boxes, and the vertices of the own points' hull; all own
C     points where they are in a plane.
      SUBROUTINE HULL(ME, RANKS)
      INCLUDE 'mpif.h'
      INTEGER ME, RANKS
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      DOUBLE PRECISION OWN(6)
      INTEGER CODE, FRESH, I, J, K, R, T
      LOGICAL OUTER(MAXN)
      DO 20 K = 1, 3
        OWN(K) = 1D300
        OWN(K+3) = -1D300
        DO 10 I = 1, N
          OWN(K) = MIN(OWN(K), P(K,I))
          OWN(K+3) = MAX(OWN(K+3), P(K,I))
   10   CONTINUE
   20 CONTINUE
      CALL MPI_ALLGATHER(OWN, 6, MPI_DOUBLE_PRECISION, BOX, 6,
     $    MPI_DOUBLE_PRECISION, MPI_COMM_WORLD, CODE)
      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, CODE)
      DO 30 I = 1, N
        OUTER(I) = CODE .NE. 0
   30 CONTINUE
      DO 60 T = 1, NTET
        DO 50 K = 1, 4
          IF (ADJ(K,T) .GT. 0) GO TO 50
          DO 40 J = 1, 4
            IF (J .NE. K) OUTER(TET(J,T)) = .TRUE.
   40     CONTINUE
   50   CONTINUE
   60 CONTINUE
      DO 80 I = 1, N
        DO 70 R = 1, RANKS
          IF (OUTER(I) .AND. R .NE. ME) CALL GIVE(R, I, 0)
   70   CONTINUE
   80 CONTINUE
      CALL CHANGE(RANKS)
      CALL LEARN(0, RANKS, FRESH)
      END

C     INBALL - is X in the ball C, which may be larger for the roundings
C     here?  (The radius may be the greatest double.)
      LOGICAL FUNCTION INBALL(C, X)
      DOUBLE PRECISION C(4), X(3)
      DOUBLE PRECISION DIST
      EXTERNAL DIST
      INBALL = SQRT(DIST(C, X))*(1.0D0 - 1D-12) .LE. C(4)
      END

C     DIST - the square of the distance of two points.
      DOUBLE PRECISION FUNCTION DIST(A, B)
      DOUBLE PRECISION A(3), B(3)
      DIST = (A(1) - B(1))**2 + (A(2) - B(2))**2 + (A(3) - B(3))**2
      END

C     ASK - the questions: four points, the own one first, and the ball.
      SUBROUTINE ASK(ME, RANKS)
      INCLUDE 'mpif.h'
      INTEGER ME, RANKS
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      DOUBLE PRECISION C(16), X(3)
      INTEGER CODE, I, J, K, OWN, R, T
      LOGICAL INBALL
      EXTERNAL INBALL
      DO 50 T = 1, NTET
        OWN = 0
   10   OWN = OWN + 1
        IF (MINE(TET(OWN,T)) .EQ. 0) GO TO 10
        DO 20 K = 0, 3
          I = TET(1+MOD(OWN-1+K,4),T)
          C(3*K+1) = P(1,I)
          C(3*K+2) = P(2,I)
          C(3*K+3) = P(3,I)
   20   CONTINUE
        CALL TESSBA(P, TET(1,T), C(13), CODE)
        IF (CODE .NE. 0) CALL MPI_ABORT(MPI_COMM_WORLD, 1, CODE)
        DO 40 R = 1, RANKS
          IF (R .EQ. ME .OR. BOX(1,R) .GT. BOX(4,R)) GO TO 40
          DO 30 J = 1, 3
            X(J) = MIN(MAX(C(12+J), BOX(J,R)), BOX(J+3,R))
   30     CONTINUE
          IF (INBALL(C(13), X)) CALL PUT(R, C, 16)
   40   CONTINUE
   50 CONTINUE
      CALL CHANGE(RANKS)
      END

C     ANSWER - the answers: of the points that the other one was not
C     sent in an earlier round the one nearest to its own vertex.
      SUBROUTINE ANSWER(ROUND, RANKS)
      INTEGER ROUND, RANKS
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      DOUBLE PRECISION BEST, D, DIST
      INTEGER HHINSP, I, M, NEAR, R
      LOGICAL INBALL
      EXTERNAL DIST, HHINSP, INBALL
      DO 30 R = 1, RANKS
        DO 20 M = 1, NIN(R), 16
          NEAR = 0
          BEST = 0.0D0
          DO 10 I = 1, N
            IF (MINE(I) .EQ. 0) GO TO 10
            IF (SENT(NUMBER(I),R) .NE. -1 .AND.
     $          SENT(NUMBER(I),R) .LT. ROUND) GO TO 10
            D = DIST(IN(M,R), P(1,I))
            IF (NEAR .GT. 0 .AND. D .GE. BEST) GO TO 10
            IF (.NOT. INBALL(IN(M+12,R), P(1,I))) GO TO 10
            IF (HHINSP(IN(M,R), IN(M+3,R), IN(M+6,R), IN(M+9,R),
     $          P(1,I)) .LT. 0) GO TO 10
            NEAR = I
            BEST = D
   10     CONTINUE
          IF (NEAR .GT. 0) CALL GIVE(R, NEAR, ROUND)
   20   CONTINUE
   30 CONTINUE
      CALL CHANGE(RANKS)
      END

C     ORDER - order the vertices of a tetrahedron but for the last two,
C     which tell the orientation.
      SUBROUTINE ORDER(V)
      INTEGER V(4)
      INTEGER I, K, SWAP
      LOGICAL ODD
      ODD = .FALSE.
      DO 20 I = 1, 3
        DO 10 K = 1, 3
          IF (V(K) .LT. V(K+1)) GO TO 10
          SWAP = V(K)
          V(K) = V(K+1)
          V(K+1) = SWAP
          ODD = .NOT. ODD
   10   CONTINUE
   20 CONTINUE
      IF (.NOT. ODD) RETURN
      SWAP = V(3)
      V(3) = V(4)
      V(4) = SWAP
      END

C     COMPAR - collect the tetrahedra at process 1, which compares: are
C     they, each once, the mesh?
      SUBROUTINE COMPAR(ME, RANKS, COUNT, FOUND, SAME)
      INTEGER ME, RANKS, COUNT, FOUND
      LOGICAL SAME
      INTEGER MAXN, MAXTET, LIW, LRW, ROOM
      PARAMETER (MAXN = 1000, MAXTET = 10*MAXN, LIW = 19*MAXN + 1800)
      PARAMETER (LRW = 4*MAXN + 12, ROOM = 160000)
      INTEGER N, NTET, NUMBER, MINE, TET, ADJ, IW, SENT
      DOUBLE PRECISION P, RW
      COMMON /KNOWN/ P(3,MAXN), RW(LRW), N, NTET, NUMBER(MAXN),
     $    MINE(MAXN), TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW),
     $    SENT(MAXN,4)
      DOUBLE PRECISION OUT, IN, BOX
      INTEGER NOUT, NIN
      COMMON /MESSAG/ OUT(ROOM,4), IN(ROOM,4), BOX(6,4), NOUT(4), NIN(4)
      DOUBLE PRECISION WHOLE
      COMMON /WHOLE/ WHOLE(3,MAXN)
      DOUBLE PRECISION X(4)
      INTEGER CODE, K, LEAST, M, R, T, V(4)
      DO 20 T = 1, NTET
        LEAST = MIN(TET(1,T), TET(2,T), TET(3,T), TET(4,T))
        DO 10 K = 1, 4
          X(K) = NUMBER(TET(K,T))
   10   CONTINUE
        IF (MINE(LEAST) .NE. 0) CALL PUT(1, X, 4)
   20 CONTINUE
      CALL CHANGE(RANKS)
      SAME = .TRUE.
      FOUND = 0
      IF (ME .NE. 1) RETURN
      CALL TESS(COUNT, WHOLE, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW,
     $    CODE)
      DO 30 T = 1, NTET
        CALL ORDER(TET(1,T))
   30 CONTINUE
      DO 80 R = 1, RANKS
        DO 70 M = 1, NIN(R), 4
          FOUND = FOUND + 1
          DO 40 K = 1, 4
            V(K) = INT(IN(M+K-1,R))
   40     CONTINUE
          CALL ORDER(V)
          DO 50 T = 1, NTET
            IF (TET(1,T) .EQ. V(1) .AND. TET(2,T) .EQ. V(2) .AND.
     $          TET(3,T) .EQ. V(3) .AND. TET(4,T) .EQ. V(4)) GO TO 60
   50     CONTINUE
          SAME = .FALSE.
          GO TO 70
C         none is found twice
   60     TET(1,T) = 0
   70   CONTINUE
   80 CONTINUE
      SAME = SAME .AND. CODE .EQ. 0 .AND. FOUND .EQ. NTET
      END
