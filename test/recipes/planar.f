C     planar.f - Delaunay triangles of points in a plane, for which TESS
C     has INFO = 3: a recipe to copy.
C
C     One more point, off the plane, whichever: the ball through it and
C     a triangle meets the plane in the triangle's circle, so the
C     tetrahedra of all points are that point and the Delaunay
C     triangles, exactly.  The same holds for triangles' neighbours, and
C     the hull of the plane's points.
C
C     The points are (x, y, 0).  Of points in a plane askew to the axes
C     take the coordinates in that plane first.
C
C     t_planar.c tests it; planar.c is the same in C.

C     TRPLAN - the Delaunay triangles of N points (x, y, 0).
C
C       N         (in)      number of points, >= 0
C       P         (in,out)  (3,N+1): the points, and room for one more,
C                           which is set
C       MAXTRI    (in)      triangles that there is room for; 2*N
C                           suffices
C       NTRI      (out)     number of triangles; for INFO = -2 the point
C                           that is NaN, infinite or not in the plane
C                           z = 0
C       TRI       (out)     (4*MAXTRI): triangle T has the points
C                           TRI(3*T-2) ... TRI(3*T), counter-clockwise:
C                           as TRI(3,*) in a routine that it is given to
C       ADJ       (out)     (4*MAXTRI): ADJ(3*T-3+K) is the triangle
C                           across the side opposite to TRI(3*T-3+K), or
C                           0
C       LIW, LRW  (in)      lengths of IW and RW, as for TESS with N + 1
C                           points
C       IW        (out)     IW(I), I <= N: the point that stands for I,
C                           as in TESS
C       RW        (out)     workspace
C       INFO      (out)     that of TESS for N + 1 points: 3 when all
C                           are on one line, 4 for one point; 5 for
C                           none.  1, 2: there are no triangles, NTRI is
C                           0; begin again with more room
C
C     Cost: that of TESS, whose tetrahedra are in TRI and ADJ at first.
      SUBROUTINE TRPLAN(N, P, MAXTRI, NTRI, TRI, ADJ, LIW, IW, LRW, RW,
     $                  INFO)
      INTEGER N, MAXTRI, NTRI, TRI(*), ADJ(*), LIW, IW(*), LRW, INFO
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER A(4), APEX, FROM, K, T, V(4)
      NTRI = 0
      INFO = -1
      IF (N .LT. 0) RETURN
      INFO = 5
      IF (N .EQ. 0) RETURN
      DO 10 T = 1, N
         IF (P(3,T) .LT. 0.0D0 .OR. P(3,T) .GT. 0.0D0) THEN
            NTRI = T
            INFO = -2
            RETURN
         END IF
   10 CONTINUE
      P(1,N+1) = P(1,1)
      P(2,N+1) = P(2,1)
      P(3,N+1) = 1.0D0
      CALL TESS(N + 1, P, MAXTRI, NTRI, TRI, ADJ, LIW, IW, LRW, RW,
     $          INFO)
      IF (INFO .GT. 0) NTRI = 0
      IF (INFO .NE. 0) RETURN
      DO 40 T = 1, NTRI
         APEX = 0
         DO 20 K = 1, 4
            V(K) = TRI(4*T-4+K)
            A(K) = ADJ(4*T-4+K)
            IF (V(K) .EQ. N + 1) APEX = K
   20    CONTINUE
         DO 30 K = 1, 3
C           the tetrahedron A B C D is as D sees A B C turn clockwise;
C           an even place of the apex turns that round
            FROM = APEX + 3 - K
            IF (MOD(APEX, 2) .EQ. 0) FROM = APEX + K - 1
            FROM = MOD(FROM, 4) + 1
            TRI(3*T-3+K) = V(FROM)
            ADJ(3*T-3+K) = A(FROM)
   30    CONTINUE
   40 CONTINUE
      END
