C     dets.f - the insphere determinant by minors: ra_minors and ra_det
C     of round.c in ordinary double precision, for the timings.

C     DTMIN3 - the determinant of the columns I, J, K of the rows NA,
C     NB, NC of R
      DOUBLE PRECISION FUNCTION DTMIN3(R, NA, NB, NC, I, J, K)
      DOUBLE PRECISION R(4,4)
      INTEGER NA, NB, NC, I, J, K
      DTMIN3 = R(NA,I)*(R(NB,J)*R(NC,K) - R(NB,K)*R(NC,J)) -
     $         R(NB,I)*(R(NA,J)*R(NC,K) - R(NA,K)*R(NC,J)) +
     $         R(NC,I)*(R(NA,J)*R(NB,K) - R(NA,K)*R(NB,J))
      END

C     DTMINO - the minors of the rows (x, y, z, x**2+y**2+z**2, 1) of
C     four points, the columns of P.
      SUBROUTINE DTMINO(P, M)
      DOUBLE PRECISION P(3,4), M(5)
      DOUBLE PRECISION DTMIN3
      DOUBLE PRECISION R(4,4)
      INTEGER COLUMN(3,4), I, K, J1, J2, J3
      DATA COLUMN /2, 3, 4, 1, 3, 4, 1, 2, 4, 1, 2, 3/
      DO 20 I = 1, 4
        DO 10 K = 1, 3
          R(I,K) = P(K,I)
   10   CONTINUE
        R(I,4) = P(1,I)**2 + P(2,I)**2 + P(3,I)**2
   20 CONTINUE
C     three columns and the ones
      DO 30 K = 1, 4
        J1 = COLUMN(1,K)
        J2 = COLUMN(2,K)
        J3 = COLUMN(3,K)
        M(K) = DTMIN3(R, 1, 2, 3, J1, J2, J3) -
     $         DTMIN3(R, 1, 2, 4, J1, J2, J3) +
     $         DTMIN3(R, 1, 3, 4, J1, J2, J3) -
     $         DTMIN3(R, 2, 3, 4, J1, J2, J3)
        IF (MOD(K, 2) .EQ. 1) M(K) = -M(K)
   30 CONTINUE
C     no ones: by the last column
      M(5) = R(3,4)*DTMIN3(R, 1, 2, 4, 1, 2, 3) -
     $       R(4,4)*DTMIN3(R, 1, 2, 3, 1, 2, 3) +
     $       R(1,4)*DTMIN3(R, 2, 3, 4, 1, 2, 3) -
     $       R(2,4)*DTMIN3(R, 1, 3, 4, 1, 2, 3)
      END

C     DTDET - the determinant whose first four rows have the minors M
C     and whose fifth row is that of Z.
      DOUBLE PRECISION FUNCTION DTDET(M, Z)
      DOUBLE PRECISION M(5), Z(3)
      DTDET = M(1)*Z(1) + M(2)*Z(2) + M(3)*Z(3) +
     $        M(4)*(Z(1)*Z(1) + Z(2)*Z(2) + Z(3)*Z(3)) + M(5)
      END
