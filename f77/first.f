C     first.f - the tetrahedra of a file's points.
C
C       gfortran -O3 -frecursive -o first f77/first.f f77/tess.f
C           f77/hhpred.f
C       ./first < test/data/mirror.xyz
C
C     A line is a point if it begins with three numbers; others are
C     counted.  SAVE keeps the arrays off the stack.
      PROGRAM FIRST
      INTEGER N, MAXN, MAXT, NTET, LIW, LRW, INFO, I, IO, OTHER
      PARAMETER (MAXN = 4000, MAXT = 8*MAXN)
      PARAMETER (LIW = 19*MAXN + 1800, LRW = 4*MAXN + 12)
      DOUBLE PRECISION P(3,MAXN+1), RW(LRW)
      INTEGER TET(4,MAXT), ADJ(4,MAXT), IW(LIW)
      CHARACTER*1000 LINE
      SAVE
      DATA N, OTHER /0, 0/
   10 READ (*, '(A)', END=20) LINE
      READ (LINE, *, IOSTAT=IO) (P(I,N+1), I = 1, 3)
      IF (IO .NE. 0) OTHER = OTHER + 1
      IF (IO .EQ. 0) N = N + 1
      IF (N .LE. MAXN) GO TO 10
      STOP 'more than MAXN points'
   20 CALL TESS(N, P, MAXT, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      WRITE (*,30) N, OTHER, INFO, NTET
   30 FORMAT (I8, ' points,', I8, ' other lines: code', I3, ',', I8,
     $        ' tetrahedra')
      END
