C     sizes.f - the lengths that f77/README gives as constants, against
C     TESSWK: for all N to 100000, and further apart to 100 million.
      PROGRAM SIZES
      INTEGER N, LIW, LRW, LIWREC, LRWREC, INFO, BAD(3), STEP, I
      CHARACTER*12 WHAT(3)
      DATA BAD /3*0/
      DATA WHAT /'TESSWK works', 'LIW suffices', 'LRW suffices'/
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
      DO 30 I = 1, 3
        IF (BAD(I) .EQ. 0) WRITE (*, 40) I, WHAT(I)
        IF (BAD(I) .NE. 0) WRITE (*, 50) I, WHAT(I), BAD(I)
   30 CONTINUE
   40 FORMAT ('ok ', I1, ' - ', A)
   50 FORMAT ('not ok ', I1, ' - ', A, ': not for so many N:', I7)
      WRITE (*, 60)
   60 FORMAT ('1..3')
      END
