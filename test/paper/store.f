C     store.f - the stores of round.f's arithmetic, in a file of their
C     own so that no compiler can do without them: a value that another
C     file's routine puts into a variable has that variable's length.

      SUBROUTINE RASTOR(X, S)
      DOUBLE PRECISION X
      REAL S
      S = REAL(X)
      END

      SUBROUTINE RADSTO(X, D)
      DOUBLE PRECISION X, D
      D = X
      END
