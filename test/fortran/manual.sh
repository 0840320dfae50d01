#!/bin/sh
# manual.sh - write f77/README, the manual of the FORTRAN entries, from what
# stands before each of them in tess.f and hhpred.f.  `make manual' calls it.
cat << 'TEXT'
tess in FORTRAN 77: the manual
==============================

tess.f and hhpred.f are ANSI X3.9-1978 FORTRAN and need nothing else. Compile
both with your program:

    gfortran -O3 -frecursive mine.f tess.f hhpred.f

-frecursive (f2c: -a) keeps local arrays on the stack; without it only one
thread at a time may call. That is, by gfortran -O2 on x86-64, with the parameters
of both files changed as it says,

    parameters                usual points   any points
    as they are                      99 KB       127 KB
    TSLIST = 128                     46 KB        73 KB
    TSLIST = 64, HHLIM = 12          38 KB        38 KB

f2c writes tess.c and hhpred.c, which are the names of
the C half's files: give it another directory,

    mkdir c && f2c -a -dc tess.f hhpred.f

    entry    what it does
    TESSWK   recommended lengths of the workspace
    TESS     the tetrahedralization
    TESSRE   go on after a full array
    TESSLO   the tetrahedron that holds a point, and weights to interpolate
    TESSVA   linear interpolation at many points
    TESSHU   the boundary triangles
    TESSCH   an exact proof of a result
    TESSIX   the points sorted, for stars and queries without a mesh
    TESSQU   the tetrahedron that holds a point, without a mesh
    TESSPA   all tetrahedra that have one of certain vertices
    TESSBA   the ball of a tetrahedron
    TESSED   the version of the library
    HHFACE, HHSIDE, HHOPP, HHLCOO, HHWRAP
             facets in Householder floating point
    HHORIE, HHINSP
             exact signs: side of a plane, inside of a ball

Names. All external names that begin with TS or HH, and those that begin with
TESS, are the library's, now and later: give your own routines and COMMON blocks
others.

Versions. tess.f links with the hhpred.f of its own version alone, and of as
many limbs; TESSED tells the version.

Floating point. Results are the same in all rounding modes. On ordinary
coordinates, 1E30 at most and with differences of at least 1E-30 of the largest,
no call sets a flag but inexact. With invalid, divide-by-zero and overflow
trapped each call of tess.f runs through, whatever it is given, NaNs included;
the rounded routines HHFACE, HHSIDE, HHOPP, HHLCOO and HHWRAP overflow where
squares of coordinates do.

Arrays. All coordinates, weights and workspace RW are DOUBLE PRECISION; a REAL
array gives nonsense, and a FORTRAN 77 compiler need not notice (see tess.f90
below). P(3,N): point I is P(1,I), P(2,I), P(3,I). TET(4,*):
tetrahedron T has the points TET(1,T) ... TET(4,T), positively oriented.
ADJ(K,T) is the tetrahedron across the facet opposite to TET(K,T), 0 on the
hull, -1 for a facet still open in an unfinished result. Counting is from 1.

Lengths, for PARAMETER statements; they hold for every N and are never less than
what TESSWK gives (beyond 28000 points LIW = 11*N + 226000 suffices):

      PARAMETER (MAXTET = 8*N, LIW = 19*N + 1800, LRW = 4*N + 12)

INFO, the last argument: 0 done; 1 TET and ADJ are full, 2 the pool in IW is
full: what TET and ADJ hold is right, and TESSRE goes on with longer arrays;
3, 4, 5 all points lie in one plane, on one line, in one place: there is no
tetrahedron; 6 the arithmetic cannot hold the coordinates; -k argument k is
invalid. Whatever TET and ADJ hold, damaged or not, a call ends and stays within
the arrays; TESSLO and TESSVA, which do not know N, need points in TET.

A program that reads lines `x y z' and counts those that are no points:

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

In the directory above:

    gfortran -O3 -flto -frecursive -o first first.f f77/tess.f f77/hhpred.f
    ./first < test/data/mirror.xyz

It prints `3600 points, 5 other lines: code 0, 19298 tetrahedra'. SAVE keeps the
program's arrays off the stack.

A program that asks for a value between the points:

      PROGRAM GRID
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 1000)
      PARAMETER (MAXTET = 8*N, LIW = 19*N + 1800, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW), VALUE(N), Q(3), W(4), V
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      INTEGER NTET, INFO, I, K, T
C     large arrays, not on the stack
      SAVE
C     a lattice, and at each of its points 1 + X + 2 Y + 3 Z
      DO 10 I = 1, N
         P(1,I) = MOD(I-1, 10)
         P(2,I) = MOD((I-1)/10, 10)
         P(3,I) = (I-1)/100
         VALUE(I) = 1.0D0 + P(1,I) + 2.0D0*P(2,I) + 3.0D0*P(3,I)
   10 CONTINUE
      CALL TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .NE. 0) STOP 'TESS'
      Q(1) = 4.25D0
      Q(2) = 3.5D0
      Q(3) = 0.75D0
      T = 0
      CALL TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      IF (INFO .NE. 0) STOP 'outside'
      V = 0.0D0
      DO 20 K = 1, 4
         V = V + W(K)*VALUE(TET(K,T))
   20 CONTINUE
      WRITE (*, '(F8.4)') V
      END

A program whose arrays are in COMMON, and that says how far it is: with room for
some tetrahedra more TESSRE goes on, as often as INFO is 1.

      PROGRAM SLICES
      INTEGER N, MAXTET, LIW, LRW
      PARAMETER (N = 1000)
      PARAMETER (MAXTET = 8*N, LIW = 19*N + 1800, LRW = 4*N + 12)
      DOUBLE PRECISION P(3,N), RW(LRW)
      INTEGER TET(4,MAXTET), ADJ(4,MAXTET), IW(LIW)
      COMMON /MESH/ P, RW, TET, ADJ, IW
      INTEGER NTET, INFO, I, ROOM
C     a lattice
      DO 10 I = 1, N
         P(1,I) = MOD(I-1, 10)
         P(2,I) = MOD((I-1)/10, 10)
         P(3,I) = (I-1)/100
   10 CONTINUE
      ROOM = 1500
      CALL TESS(N, P, ROOM, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
   20 CONTINUE
      WRITE (*, '(I8, A, I2)') NTET, ' tetrahedra: INFO =', INFO
      IF (INFO .EQ. 1 .AND. ROOM .LT. MAXTET) THEN
         ROOM = MIN(ROOM + 1500, MAXTET)
         CALL TESSRE(N, P, ROOM, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
         GO TO 20
      END IF
      END

Fortran 90 and later. tess.f90 has interfaces of all entries:

    gfortran -c tess.f90        then, in each caller:    use tess_interface

With them the compiler finds arguments of wrong type, kind, rank or number.
tess.f and hhpred.f stay as they are.

Integers of 8 bytes. Compile all files with gfortran -fdefault-integer-8
(ifort -i8), and every INTEGER here has 8 bytes; nothing else changes. Limits
stay those of 4 bytes: 4*MAXTET + 3 is at most 2147483647. If the caller alone
is compiled so, INFO and NTET may look right, but TET and ADJ hold numbers
beyond 2**32, two indices in each; the other way round INFO is negative.

REAL of 8 bytes. gfortran -fdefault-real-8 makes DOUBLE PRECISION 16 bytes long:
add -fdefault-double-8, or INFO is 6.

Warnings. With -std=f2018 gfortran calls labelled DO and EQUIVALENCE
obsolescent, which they are; nothing is wrong. Without -std, or with
-std=legacy, there are no warnings.

Fewer limbs. HHLIM = 88 in both files holds coordinates of any magnitude; see
HH_LIMBS in ../hhpred.h. For 12 change each HHLIM = 88 in both, and each HHL088
to HHL012, so that they do not link with others.

C. A C program may call these entries, and a Fortran 2003 program the C half:
../test/examples/fortran.c and fortran.f90.

TEXT
for entry in TESSWK TESS TESSRE `sed -n 's/^C     \(TESS[A-Z]*\) - .*/\1/p' \
    f77/tess.f | grep -v 'TESS$\|TESSWK\|TESSRE'` HHFACE HHSIDE HHOPP HHLCOO \
    HHWRAP HHORIE HHINSP; do
    awk -v entry=$entry '
        $1 == "C" && $2 == entry && $3 == "-" { text = 1; n = 0 }
        text == 1 && /^C     How: / { text = 2 }
        text == 1 && /^C/ { line[n++] = substr($0, 7) }
        text && !/^C/ { text = 3 }
        # a line that goes on belongs to the one before it
        text == 3 && /^     [^ ]/ {
            if (types == "") head = head "\n" $0; else types = types "\n" $0
            next
        }
        text == 3 && /(SUBROUTINE|FUNCTION)/ {
            head = $0
            next
        }
        text == 3 {
            # declarations, as far as they are of arguments
            name = $0
            sub(/^ *(INTEGER|DOUBLE PRECISION|REAL) /, "", name)
            sub(/[^A-Z0-9].*/, "", name)
            if ($0 ~ /^ *(INTEGER|DOUBLE PRECISION|REAL) / &&
                head ~ "[ (,]" name "[,)]") {
                types = types "\n" $0
                next
            }
            text = 0
            print substr("----------------------------------------" \
                "----------------------------------------", 1, 76)
            print head types "\n"
            while (n > 0 && line[n-1] == "") n--
            for (i = 0; i < n; i++) print line[i]
            print ""
            exit
        }' f77/tess.f f77/hhpred.f
done
