C     sizes.f - the lengths that f77/README gives as constants, against
C     TESSWK: for all N to 100000, and further apart to 100 million.
      PROGRAM SIZES
      INTEGER N, LIW, LRW, LIWREC, LRWREC, INFO, GOOD, BAD, STEP
      GOOD = 0
      BAD = 0
      STEP = 1
      N = 0
   10 CONTINUE
      LIW = 19*N + 1800
      IF (N .GE. 28000) LIW = 11*N + 226000
      LRW = 4*N + 12
      CALL TESSWK(N, 0, LIWREC, LRWREC, INFO)
      IF (INFO .EQ. 0 .AND. LIW .GE. LIWREC .AND. LRW .GE. LRWREC) THEN
         GOOD = GOOD + 1
      ELSE
         BAD = BAD + 1
      END IF
      IF (N .GE. 100000) STEP = N/1000
      N = N + STEP
      IF (N .LE. 100000000) GO TO 10
      WRITE (*, 20) GOOD, BAD
   20 FORMAT ('sizes: ', I6, ' passed, ', I1, ' failed')
      END
