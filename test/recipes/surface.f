C     surface.f - the convex hull of points as a surface: recipes to
C     copy.
C
C       TRENCL  the volume within                          (TRNORS)
C       TROBJ   write it as Wavefront OBJ
C       TRSTL   write it as STL (ASCII)                    (TRNORS)
C
C     Programs for drawing and for printing in three dimensions read
C     both.  The triangles are those of TESSHU, or of any other closed
C     surface, as the recipe TRALPH gives: counter-clockwise as seen
C     from outside.
C
C     t_surface.c tests them; surface.c is the same in C.

C     TRNORS - C = the cross product of two edges of triangle V:
C     outwards, of twice its area.
      SUBROUTINE TRNORS(P, V, C)
      DOUBLE PRECISION P(3,*), C(3)
      INTEGER V(3)
      DOUBLE PRECISION A(3), B(3)
      INTEGER K
      DO 10 K = 1, 3
         A(K) = P(K,V(2)) - P(K,V(1))
         B(K) = P(K,V(3)) - P(K,V(1))
   10 CONTINUE
      C(1) = A(2)*B(3) - A(3)*B(2)
      C(2) = A(3)*B(1) - A(1)*B(3)
      C(3) = A(1)*B(2) - A(2)*B(1)
      END

C     TRENCL - the volume within a closed surface: the sum of those
C     between each triangle and a point.
C
C       P     (in)  the points
C       NFAC  (in)  number of triangles
C       FAC   (in)  (3,NFAC): FAC(1,F) ... FAC(3,F) are the points of
C                   triangle F
C       SUM   (out) the volume
      SUBROUTINE TRENCL(P, NFAC, FAC, SUM)
      DOUBLE PRECISION P(3,*), SUM
      INTEGER NFAC, FAC(3,*)
      DOUBLE PRECISION C(3)
      INTEGER F, K
      SUM = 0.0D0
      DO 20 F = 1, NFAC
         CALL TRNORS(P, FAC(1,F), C)
         DO 10 K = 1, 3
            SUM = SUM + C(K)*(P(K,FAC(1,F)) - P(K,FAC(1,1)))
   10    CONTINUE
   20 CONTINUE
      SUM = SUM / 6.0D0
      END

C     TROBJ - write the triangles, and the points that they have, as
C     OBJ.
C
C       FILE       (in)   the unit where to, open for formatted lines
C       N, P       (in)   points
C       NFAC, FAC  (in)   as for TRENCL
C       DIGITS     (in)   of coordinates, 1 ... 17: 17 keep a number as
C                         it is
C       NUMBER     (out)  (N): the point's number in the file, from 1
C                         on; 0 for one that no triangle has
C       INFO       (out)  0; 1 when the file could not be written; -6
C                         for bad DIGITS
      SUBROUTINE TROBJ(FILE, N, P, NFAC, FAC, DIGITS, NUMBER, INFO)
      INTEGER FILE, N, NFAC, FAC(3,*), DIGITS, NUMBER(*), INFO
      DOUBLE PRECISION P(3,*)
      INTEGER F, I, K, MANY
      CHARACTER FORM*30
      INFO = -6
      IF (DIGITS .LT. 1 .OR. DIGITS .GT. 17) RETURN
      INFO = 1
      WRITE (FORM, 60) DIGITS + 9, DIGITS - 1
      DO 10 I = 1, N
         NUMBER(I) = 0
   10 CONTINUE
      DO 30 F = 1, NFAC
         DO 20 K = 1, 3
            NUMBER(FAC(K,F)) = 1
   20    CONTINUE
   30 CONTINUE
      MANY = 0
      DO 40 I = 1, N
         IF (NUMBER(I) .EQ. 0) GO TO 40
         MANY = MANY + 1
         NUMBER(I) = MANY
         WRITE (FILE, FORM, ERR=80) 'v', P(1,I), P(2,I), P(3,I)
   40 CONTINUE
      DO 50 F = 1, NFAC
         WRITE (FILE, 70, ERR=80) (NUMBER(FAC(K,F)), K = 1, 3)
   50 CONTINUE
      INFO = 0
   60 FORMAT ('(A, 1P, 3(1X, E', I2.2, '.', I2.2, 'E3))')
   70 FORMAT ('f', 3(1X, I10))
   80 CONTINUE
      END

C     TRSTL - write the triangles as STL.
C
C       FILE, P, NFAC, FAC, DIGITS  (in)  as for TROBJ
C       INFO  (out)  0; 1 when the file could not be written; -5 for bad
C                    DIGITS
      SUBROUTINE TRSTL(FILE, P, NFAC, FAC, DIGITS, INFO)
      INTEGER FILE, NFAC, FAC(3,*), DIGITS, INFO
      DOUBLE PRECISION P(3,*)
      DOUBLE PRECISION C(3), SIZE
      INTEGER F, I, K
      CHARACTER FORM*30
      INFO = -5
      IF (DIGITS .LT. 1 .OR. DIGITS .GT. 17) RETURN
      INFO = 1
      WRITE (FORM, 40) DIGITS + 9, DIGITS - 1
      WRITE (FILE, 50, ERR=80) 'solid hull'
      DO 30 F = 1, NFAC
         CALL TRNORS(P, FAC(1,F), C)
         SIZE = SQRT(C(1)*C(1) + C(2)*C(2) + C(3)*C(3))
         IF (.NOT. (SIZE .GT. 0.0D0)) SIZE = 1.0D0
         DO 10 K = 1, 3
            C(K) = C(K) / SIZE
   10    CONTINUE
         WRITE (FILE, 60, ERR=80) C
         DO 20 I = 1, 3
            WRITE (FILE, FORM, ERR=80) '  vertex',
     1         (P(K,FAC(I,F)), K = 1, 3)
   20    CONTINUE
         WRITE (FILE, 50, ERR=80) ' endloop'
         WRITE (FILE, 50, ERR=80) 'endfacet'
   30 CONTINUE
      WRITE (FILE, 50, ERR=80) 'endsolid hull'
      INFO = 0
   40 FORMAT ('(A, 1P, 3(1X, E', I2.2, '.', I2.2, 'E3))')
   50 FORMAT (A)
   60 FORMAT ('facet normal', 1P, 3(1X, E14.6E3) / ' outer loop')
   80 CONTINUE
      END
