C     iso.f - the surface where a field has a given value: a recipe to
C     copy.
C
C       TRISO  the triangles of one level   (TRKNOW, TRBELI, TRKEY,
C                                            TRPOIN, TRTRIA, TRBETW,
C                                            TRCROI, TRCAP)
C
C     The field is linear in each tetrahedron, and so a tetrahedron has
C     of the surface nothing, a triangle, or a flat quadrilateral, which
C     two triangles are: marching tetrahedra.  A point of the surface
C     lies on an edge of the mesh, or is a point of the mesh whose value
C     is the level; by that it is known, so that all triangles about it
C     share one point.
C
C     A value that equals the level counts as above it.  What then has
C     no area is left out: a triangle with a point twice; a facet all of
C     whose values are the level, unless it has a tetrahedron above it
C     on one side and one below it on the other.  So the surface is just
C     the boundary between what is above and what is below.  Triangles
C     are counter-clockwise as seen from below: normals point from high
C     values to low ones, outwards of what is above.
C
C     Every edge that is not on the hull has as many triangles in one
C     direction as in the other: one each, where no value equals the
C     level.  (Where values do, parts of the surface may touch along an
C     edge.)  Along the hull the surface is open; or it is closed by
C     what of the hull is above the level, and then encloses just that.
C
C     A tetrahedron with a value that is NaN or infinite counts as one
C     beyond the hull.  Where the level is within roundings of a value,
C     points of several edges may have the same coordinates; they are
C     different points all the same, and triangles of no area have their
C     place between them.
C
C     t_iso.c tests it; iso.c is the same in C.

C     TRKNOW - are all values of tetrahedron T finite, and is it one?
      INTEGER FUNCTION TRKNOW(TET, VALUE, T)
      INTEGER TET(4,*), T
      DOUBLE PRECISION VALUE(*)
      DOUBLE PRECISION F
      INTEGER K
      TRKNOW = 0
      IF (T .LE. 0) RETURN
      DO 10 K = 1, 4
         F = VALUE(TET(K,T))
         IF (.NOT. (F - F .EQ. 0.0D0)) RETURN
   10 CONTINUE
      TRKNOW = 1
      END

      INTEGER FUNCTION TRBELI(VALUE, LEVEL, V)
      DOUBLE PRECISION VALUE(*), LEVEL
      INTEGER V
      TRBELI = 0
      IF (VALUE(V) .LT. LEVEL) TRBELI = 1
      END

C     TRKEY - where the edge from U, above, to W, below, meets the
C     surface: its ends, the lesser one first; U twice, where that is a
C     point of the surface.  (Of the hull it is also a corner, U = W.)
      SUBROUTINE TRKEY(VALUE, LEVEL, U, W, KEY)
      DOUBLE PRECISION VALUE(*), LEVEL
      INTEGER U, W, KEY(2)
      KEY(1) = MIN(U, W)
      KEY(2) = MAX(U, W)
      IF (VALUE(U) .NE. LEVEL) RETURN
      KEY(1) = U
      KEY(2) = U
      END

C     TRPOIN - the number I of the point with that key, a new one's,
C     too; 0 when there is no room for that.
C
C     The table is searched from a place on that the key says: the
C     fraction of a sum of multiples of 2**-21, which is exact below
C     2**31, so that it is the same wherever it is computed.
C
C     From the end whose value is nearer, in halves: so that X is
C     between the ends, whatever the rounding, and no difference is
C     beyond DOUBLE PRECISION.
      SUBROUTINE TRPOIN(P, VALUE, LEVEL, S, X, ENDS, TABLE, KEY, I)
      DOUBLE PRECISION P(3,*), VALUE(*), LEVEL, X(3,*)
      INTEGER S(5), ENDS(2,*), TABLE(*), KEY(2), I
      DOUBLE PRECISION W, F, G, H
      INTEGER SIZE, AT, A, B, J
      A = KEY(1)
      B = KEY(2)
      SIZE = 2*S(1) + 1
      W = (DBLE(A)*1583093.0D0 + DBLE(B)*1195041.0D0) / 2097152.0D0
      AT = 1 + INT((W - AINT(W))*DBLE(SIZE))
   10 CONTINUE
      IF (TABLE(AT) .GT. 0) THEN
         I = TABLE(AT)
         IF (ENDS(1,I) .EQ. A .AND. ENDS(2,I) .EQ. B) RETURN
         AT = MOD(AT, SIZE) + 1
         GO TO 10
      END IF
      I = S(2) + 1
      IF (I .GT. S(1)) THEN
         S(5) = 1
         I = 0
         RETURN
      END IF
      S(2) = I
      TABLE(AT) = I
      ENDS(1,I) = A
      ENDS(2,I) = B
      W = 0.0D0
      IF (A .NE. B) THEN
         F = VALUE(A)
         G = VALUE(B)
         H = LEVEL
         IF (ABS(F) .GT. 1.0D300 .OR. ABS(G) .GT. 1.0D300) THEN
            F = F*0.5D0
            G = G*0.5D0
            H = H*0.5D0
         END IF
         W = (H - F) / (G - F)
         IF (W .GT. 0.5D0) THEN
            W = (H - G) / (F - G)
            A = KEY(2)
            B = KEY(1)
         END IF
      END IF
      DO 20 J = 1, 3
         F = 0.5D0*P(J,A)
         G = 0.5D0*P(J,B)
         X(J,I) = P(J,A) + 2.0D0*W*(G - F)
   20 CONTINUE
      END

C     TRTRIA - a triangle with these keys, if they are three.
      SUBROUTINE TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, A, B,
     1   C)
      DOUBLE PRECISION P(3,*), VALUE(*), LEVEL, X(3,*)
      INTEGER S(5), ENDS(2,*), TRI(3,*), TABLE(*), A(2), B(2), C(2)
      INTEGER F
      IF (A(1) .EQ. B(1) .AND. A(2) .EQ. B(2)) RETURN
      IF (B(1) .EQ. C(1) .AND. B(2) .EQ. C(2)) RETURN
      IF (C(1) .EQ. A(1) .AND. C(2) .EQ. A(2)) RETURN
      F = S(4) + 1
      IF (F .LE. S(3) .AND. S(5) .EQ. 0) THEN
         CALL TRPOIN(P, VALUE, LEVEL, S, X, ENDS, TABLE, A, TRI(1,F))
         CALL TRPOIN(P, VALUE, LEVEL, S, X, ENDS, TABLE, B, TRI(2,F))
         CALL TRPOIN(P, VALUE, LEVEL, S, X, ENDS, TABLE, C, TRI(3,F))
      END IF
      S(4) = F
      END

C     TRBETW - is what is beyond facet K of tetrahedron T, one whose
C     values are the level, above it?
      INTEGER FUNCTION TRBETW(TET, ADJ, VALUE, LEVEL, T, K)
      INTEGER TET(4,*), ADJ(4,*), T, K
      DOUBLE PRECISION VALUE(*), LEVEL
      INTEGER U, J
      INTEGER TRKNOW, TRBELI
      U = ADJ(K,T)
      TRBETW = 0
      IF (TRKNOW(TET, VALUE, U) .EQ. 0) RETURN
      DO 10 J = 1, 3
         IF (ADJ(J,U) .EQ. T) GO TO 20
   10 CONTINUE
      J = 4
   20 CONTINUE
      TRBETW = 1 - TRBELI(VALUE, LEVEL, TET(J,U))
      END

C     TRCROI - what tetrahedron T, known, has of the surface.
C
C     Its vertices I and ORDER(1,I) ... ORDER(3,I) are an even order of
C     them, whatever I, and so is that with the last three turned
C     around: seen from vertex I these three are clockwise.
      SUBROUTINE TRCROI(P, TET, ADJ, VALUE, LEVEL, T, S, X, ENDS, TRI,
     1   TABLE)
      DOUBLE PRECISION P(3,*), VALUE(*), LEVEL, X(3,*)
      INTEGER TET(4,*), ADJ(4,*), T, S(5), ENDS(2,*), TRI(3,*), TABLE(*)
      INTEGER A, B(3), Q(2,4), MANY, EQUAL, I, K, TURN, ORDER(3,4)
      INTEGER TRBELI, TRBETW
      SAVE ORDER
      DATA ORDER /2,3,4, 1,4,3, 4,1,2, 3,2,1/
      MANY = 0
      EQUAL = 0
      DO 10 K = 1, 4
         MANY = MANY + 1 - TRBELI(VALUE, LEVEL, TET(K,T))
         IF (VALUE(TET(K,T)) .EQ. LEVEL) EQUAL = EQUAL + 1
   10 CONTINUE
      IF (MANY .EQ. 0 .OR. MANY .EQ. 4) RETURN
C     The one that is alone on its side, or the first one of two above.
      I = 1
   20 CONTINUE
      IF (TRBELI(VALUE, LEVEL, TET(I,T)) .NE. MANY/3) THEN
         I = I + 1
         GO TO 20
      END IF
      A = TET(I,T)
      TURN = 0
   30 CONTINUE
      IF (MANY .EQ. 2) THEN
         IF (TRBELI(VALUE, LEVEL, TET(ORDER(TURN+1,I),T)) .NE. 0) THEN
            TURN = TURN + 1
            GO TO 30
         END IF
      END IF
      DO 40 K = 1, 3
         B(K) = TET(ORDER(MOD(K - 1 + TURN, 3) + 1,I),T)
   40 CONTINUE
      IF (MANY .EQ. 1) THEN
         DO 50 K = 1, 3
            CALL TRKEY(VALUE, LEVEL, A, B(K), Q(1,K))
   50    CONTINUE
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,2), Q(1,3))
      ELSE IF (MANY .EQ. 3) THEN
         IF (EQUAL .EQ. 3) THEN
            IF (TRBETW(TET, ADJ, VALUE, LEVEL, T, I) .EQ. 0) RETURN
         END IF
         DO 60 K = 1, 3
            CALL TRKEY(VALUE, LEVEL, B(K), A, Q(1,K))
   60    CONTINUE
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,3), Q(1,2))
      ELSE
         CALL TRKEY(VALUE, LEVEL, A, B(2), Q(1,1))
         CALL TRKEY(VALUE, LEVEL, A, B(3), Q(1,2))
         CALL TRKEY(VALUE, LEVEL, B(1), B(3), Q(1,3))
         CALL TRKEY(VALUE, LEVEL, B(1), B(2), Q(1,4))
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,2), Q(1,3))
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,3), Q(1,4))
      END IF
      END

C     TRCAP - what of facet K of tetrahedron T is above the level.
      SUBROUTINE TRCAP(P, TET, VALUE, LEVEL, T, K, S, X, ENDS, TRI,
     1   TABLE)
      DOUBLE PRECISION P(3,*), VALUE(*), LEVEL, X(3,*)
      INTEGER TET(4,*), T, K, S(5), ENDS(2,*), TRI(3,*), TABLE(*)
      INTEGER B(3), Q(2,4), MANY, EQUAL, I, TURN, ORDER(3,4)
      INTEGER TRBELI
      SAVE ORDER
      DATA ORDER /2,3,4, 1,4,3, 4,1,2, 3,2,1/
      MANY = 0
      EQUAL = 0
      DO 10 I = 1, 3
         B(I) = TET(ORDER(I,K),T)
         MANY = MANY + 1 - TRBELI(VALUE, LEVEL, B(I))
         IF (VALUE(B(I)) .EQ. LEVEL) EQUAL = EQUAL + 1
   10 CONTINUE
      IF (MANY .EQ. 0) RETURN
      IF (EQUAL .EQ. 3) THEN
         IF (TRBELI(VALUE, LEVEL, TET(K,T)) .NE. 0) RETURN
      END IF
C     The one that is alone on its side comes first.
      TURN = 0
   20 CONTINUE
      IF (MANY .LT. 3) THEN
         IF (TRBELI(VALUE, LEVEL, B(TURN+1)) .NE. MANY/2) THEN
            TURN = TURN + 1
            GO TO 20
         END IF
      END IF
      DO 30 I = 1, 3
         B(I) = TET(ORDER(MOD(I - 1 + TURN, 3) + 1,K),T)
   30 CONTINUE
      IF (MANY .EQ. 1) THEN
         CALL TRKEY(VALUE, LEVEL, B(1), B(1), Q(1,1))
         CALL TRKEY(VALUE, LEVEL, B(1), B(2), Q(1,2))
         CALL TRKEY(VALUE, LEVEL, B(1), B(3), Q(1,3))
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,2), Q(1,3))
      ELSE IF (MANY .EQ. 3) THEN
         DO 40 I = 1, 3
            CALL TRKEY(VALUE, LEVEL, B(I), B(I), Q(1,I))
   40    CONTINUE
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,2), Q(1,3))
      ELSE
         CALL TRKEY(VALUE, LEVEL, B(2), B(2), Q(1,1))
         CALL TRKEY(VALUE, LEVEL, B(3), B(3), Q(1,2))
         CALL TRKEY(VALUE, LEVEL, B(3), B(1), Q(1,3))
         CALL TRKEY(VALUE, LEVEL, B(2), B(1), Q(1,4))
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,2), Q(1,3))
         CALL TRTRIA(P, VALUE, LEVEL, S, X, ENDS, TRI, TABLE, Q(1,1),
     1      Q(1,3), Q(1,4))
      END IF
      END

C     TRISO - the surface where the field, linear in each tetrahedron,
C     is LEVEL.
C
C       P, NTET, TET, ADJ  (in)   a mesh of TESS, or a part of one
C       VALUE              (in)   a value for each point
C       LEVEL              (in)   that of the surface; NaN has none
C       CLOSED             (in)   1: with that part of the hull that is
C                                 above the level; 0: without
C       MAXPT              (in)   points that there is room for: 3 a
C                                 triangle are always enough; where the
C                                 surface is closed, 1
C       NPT, X             (out)  number of points; (3,MAXPT): their
C                                 coordinates
C       ENDS               (out)  (2,MAXPT): point I is between the
C                                 points ENDS(1,I) < ENDS(2,I) of the
C                                 mesh; or it is that one, where they
C                                 are the same
C       MAXTRI             (in)   triangles that there is room for
C       NTRI               (out)  number of triangles, even when there
C                                 is no room
C       TRI                (out)  (3,MAXTRI): triangle F has the points
C                                 TRI(1,F) ... TRI(3,F),
C                                 counter-clockwise as seen from below
C       IWORK                     2*MAXPT + 1
C       INFO               (out)  0; 1 when there is no room for
C                                 triangles, 2 for points: then NTRI
C                                 alone holds
C
C     The order of points and triangles is that of the tetrahedra.
      SUBROUTINE TRISO(P, NTET, TET, ADJ, VALUE, LEVEL, CLOSED, MAXPT,
     1   NPT, X, ENDS, MAXTRI, NTRI, TRI, IWORK, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), CLOSED, MAXPT, NPT, ENDS(2,*)
      INTEGER MAXTRI, NTRI, TRI(3,*), IWORK(*), INFO
      DOUBLE PRECISION P(3,*), VALUE(*), LEVEL, X(3,*)
      INTEGER S(5), T, K
      INTEGER TRKNOW
      S(1) = MAXPT
      S(2) = 0
      S(3) = MAXTRI
      S(4) = 0
      S(5) = 0
      DO 10 T = 1, 2*MAXPT + 1
         IWORK(T) = 0
   10 CONTINUE
      DO 30 T = 1, NTET
         IF (.NOT. (LEVEL - LEVEL .EQ. 0.0D0)) GO TO 30
         IF (TRKNOW(TET, VALUE, T) .EQ. 0) GO TO 30
         CALL TRCROI(P, TET, ADJ, VALUE, LEVEL, T, S, X, ENDS, TRI,
     1      IWORK)
         DO 20 K = 1, 4
            IF (CLOSED .EQ. 0) GO TO 20
            IF (TRKNOW(TET, VALUE, ADJ(K,T)) .NE. 0) GO TO 20
            CALL TRCAP(P, TET, VALUE, LEVEL, T, K, S, X, ENDS, TRI,
     1         IWORK)
   20    CONTINUE
   30 CONTINUE
      NPT = S(2)
      NTRI = S(4)
      INFO = 0
      IF (S(5) .NE. 0) INFO = 2
      IF (NTRI .GT. MAXTRI) INFO = 1
      END
