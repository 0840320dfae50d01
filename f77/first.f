C     first.f - the tetrahedra of a file's points.
C
C       gfortran -O3 -frecursive -o first f77/first.f f77/tess.f
C           f77/hhpred.f
C       ./first < test/data/mirror.xyz
C
C     A line is a point if it begins with three numbers, blanks between
C     them; others are counted.  SAVE keeps the arrays off the stack.
      PROGRAM FIRST
      INTEGER N, MAXN, MAXT, NTET, LIW, LRW, INFO, I, J, K, IO, OTHER
      PARAMETER (MAXN = 4000, MAXT = 8*MAXN)
      PARAMETER (LIW = 19*MAXN + 1800, LRW = 4*MAXN + 12)
      DOUBLE PRECISION P(3,MAXN+1), RW(LRW)
      INTEGER TET(4,MAXT), ADJ(4,MAXT), IW(LIW)
      CHARACTER LINE*1000, WORD*100
      SAVE
      DATA N, OTHER /0, 0/
C     the next line; of its words, from J on, three are read
   10 READ (*, '(A)', END=50) LINE
      J = 1
      DO 30 I = 1, 3
   20    K = INDEX(LINE(J:), ' ')
         IF (K .EQ. 1 .AND. J .LT. 1000) THEN
            J = J + 1
            GO TO 20
         END IF
         IF (K .LE. 1) GO TO 40
         WORD = LINE(J:J+K-1)
         READ (WORD, '(BN, F100.0)', IOSTAT=IO) P(I,N+1)
         IF (IO .NE. 0) GO TO 40
         J = MIN(J + K, 1000)
   30 CONTINUE
      N = N + 1
      IF (N .LE. MAXN) GO TO 10
      STOP 'more than MAXN points'
   40 OTHER = OTHER + 1
      GO TO 10
   50 CALL TESS(N, P, MAXT, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      WRITE (*,60) N, OTHER, INFO, NTET
   60 FORMAT (I8, ' points,', I8, ' other lines: code', I3, ',', I8,
     $        ' tetrahedra')
      END
