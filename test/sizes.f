C     sizes.f - the lengths that f77/README gives as constants, against
C     TESSWK: for all N to 100000, and further apart to 200 million.
      PROGRAM SIZES
      INTEGER N, K, LIW, LRW, LIWREC, LRWREC, INFO, GOOD, BAD, STEP
      GOOD = 0
      BAD = 0
      STEP = 1
      N = 0
   10 CONTINUE
      K = 1/(1 + N/40000)
      LIW = (8+8*K)*N + N/12 + 1720 + (1-K)*(320000 + N/3)
      LRW = 3*N + 6*(N/12 + 2)
      CALL TESSWK(N, 0, LIWREC, LRWREC, INFO)
      IF (INFO .EQ. 0 .AND. LIW .GE. LIWREC .AND. LRW .GE. LRWREC) THEN
         GOOD = GOOD + 1
      ELSE
         BAD = BAD + 1
      END IF
      IF (N .GE. 100000) STEP = N/1000
      N = N + STEP
      IF (N .LE. 200000000) GO TO 10
      WRITE (*, 20) GOOD, BAD
   20 FORMAT ('sizes: ', I6, ' passed, ', I1, ' failed')
      END
