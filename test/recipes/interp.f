C     interp.f - values measured at scattered points, interpolated onto
C     a grid: a recipe to copy.
C
C     Linear in each tetrahedron.  With M the largest second derivative
C     of the field in any direction, the error at Q is at most  M/2 *
C     sum of W(K) |P_K - Q|**2: it falls with the square of the spacing.
C     (Taylor about Q; the first derivatives drop out, as the sum of
C     W(K) (P_K - Q) is 0.)  No other mesh of the points makes
C     this bound smaller.
C
C     Points much denser in one direction: stretch that direction, of P
C     and of the box.
C
C     t_interp.c tests it; interp.c is the same in C.

C     TRONGR - values at the places of a grid.
C
C       P, NTET, TET, ADJ  (in)  a result of TESS with NTET >= 1
C       NV       (in)      values per point, >= 0
C       VALUE    (in)      (NV,*): VALUE(J,I) is value J of point I
C       SIZE     (in)      (3): places along x, y, z, >= 1
C       BOX      (in)      (6): from x, to x; from y, to y; from z, to
C                          z: places are at both ends; a single one is
C                          in the middle
C       OUTSID   (in)      the value outside the hull
C       T        (out)     (SIZE(1)): workspace
C       Q        (out)     (3,SIZE(1)): workspace
C       OUT      (out)     NV*SIZE(1)*SIZE(2)*SIZE(3): value J at place
C                          X, Y, Z, from 1 on, is OUT(NV*(X - 1 +
C                          SIZE(1)*(Y - 1 + SIZE(2)*(Z - 1))) + J)
C       INFO     (out)     0; 1 when a place is outside the hull; -2 for
C                          NTET < 1, -5 for NV < 0, -7 for a bad size,
C                          -8 for a NaN or infinity in a place; -4 or 6
C                          as from TESSLO
C
C     Cost: that of TESSVA; each row starts where the row before it did.
      SUBROUTINE TRONGR(P, NTET, TET, ADJ, NV, VALUE, SIZE, BOX, OUTSID,
     1                  T, Q, OUT, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), NV, SIZE(3), T(*), INFO
      DOUBLE PRECISION P(3,*), VALUE(*), BOX(2,3), OUTSID, Q(3,*)
      DOUBLE PRECISION OUT(*)
      DOUBLE PRECISION ALONG
      INTEGER AT(3), BASE, FOUND, I, J, K, PLANE, ROW, X, Y, Z
      INFO = -7
      IF (SIZE(1) .LT. 1 .OR. SIZE(2) .LT. 1 .OR. SIZE(3) .LT. 1) RETURN
      INFO = -5
      IF (NV .LT. 0) RETURN
      FOUND = 0
      PLANE = 0
      BASE = 1
      DO 60 Z = 1, SIZE(3)
         ROW = PLANE
         DO 50 Y = 1, SIZE(2)
            AT(2) = Y
            AT(3) = Z
            DO 20 X = 1, SIZE(1)
               AT(1) = X
               T(X) = 0
               DO 10 K = 1, 3
                  ALONG = 0.5D0
                  IF (SIZE(K) .GT. 1)
     1               ALONG = DBLE(AT(K) - 1) / DBLE(SIZE(K) - 1)
                  Q(K,X) = BOX(1,K) + ALONG*(BOX(2,K) - BOX(1,K))
   10          CONTINUE
   20       CONTINUE
            T(1) = ROW
            CALL TESSVA(P, NTET, TET, ADJ, NV, VALUE, SIZE(1), Q, T,
     1                  OUT(BASE), INFO)
            IF (INFO .NE. 0 .AND. INFO .NE. 1) RETURN
            ROW = T(1)
            IF (Y .EQ. 1) PLANE = ROW
            IF (INFO .EQ. 1) FOUND = 1
            DO 40 I = 1, SIZE(1)
               DO 30 J = 0, NV - 1
                  IF (T(I) .LT. 0) OUT(BASE+J) = OUTSID
   30          CONTINUE
               BASE = BASE + NV
   40       CONTINUE
   50    CONTINUE
   60 CONTINUE
      INFO = FOUND
      END
