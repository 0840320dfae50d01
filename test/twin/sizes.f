C     sizes.f - the lengths that f77/README gives as constants, against
C     TESSWK: for all N to 100000, and further apart to 100 million.
      PROGRAM SIZES
      INTEGER N, LIW, LRW, LIWREC, LRWREC, INFO, BAD(3), STEP, GOOD, I
      DATA BAD /3*0/
      STEP = 1
      N = 0
   10 CONTINUE
      LIW = 19*N + 1800
      IF (N .GE. 28000) LIW = 11*N + 226000
      LRW = 4*N + 12
      CALL TESSWK(N, 0, LIWREC, LRWREC, INFO)
      IF (INFO .NE. 0) BAD(1) = BAD(1) + 1
      IF (LIW .LT. LIWREC) BAD(2) = BAD(2) + 1
      IF (LRW .LT. LRWREC) BAD(3) = BAD(3) + 1
      IF (N .GE. 100000) STEP = N/1000
      N = N + STEP
      IF (N .LE. 100000000) GO TO 10
      WRITE (*, 20) BAD
   20 FORMAT (' for so many N TESSWK fails:', I7, ', LIW is short:',
     $    I7, ', LRW:', I7)
      GOOD = 0
      DO 30 I = 1, 3
        IF (BAD(I) .EQ. 0) GOOD = GOOD + 1
   30 CONTINUE
      WRITE (*, 40) GOOD, 3 - GOOD
   40 FORMAT ('sizes: ', I1, ' passed, ', I1, ' failed')
      END
