#!/bin/sh
# manual.sh - write f77/README, the manual of the FORTRAN routines, from what
# stands before each of them in tess.f and hhpred.f.  `make manual' calls it.
version=`awk '/^      TESSED = / {
    printf "%d.%d", $3 / 10000, $3 / 100 % 100 }' f77/tess.f`
cat << TEXT
tess $version in FORTRAN 77: the manual
=================================

TEXT
cat << 'TEXT'
tess.f and hhpred.f are ANSI X3.9-1978 FORTRAN and need nothing else. They have
no COMMON, no I/O and no STOP, and keep nothing between calls. Copy both, and
compile them with your program:

    gfortran -O3 -frecursive mine.f tess.f hhpred.f

Does it work here? first.f reads points and counts tetrahedra. In the directory
above,

    gfortran -O3 -flto -frecursive -o first f77/first.f f77/tess.f f77/hhpred.f
    ./first < test/data/mirror.xyz

prints `980 points, 5 other lines: code 0, 4980 tetrahedra'. -frecursive (f2c:
-a) keeps local arrays on the stack, so that any number of threads may call;
without it one thread at a time may. -flto saves 4 to 14 % of the time.

    routine  what it does
    TESS     the tetrahedra of points, and their neighbours: a mesh
    TESSWK   recommended lengths of the workspace
    TESSRE   go on after a full array
    TESSLO   the tetrahedron that holds a place, and weights to interpolate
    TESSVA   linear interpolation at many places
    TESSHU   the hull triangles
    TESSCH   an exact proof of a mesh
    TESSIX   a search index, for TESSQU and TESSPA
    TESSQU   the tetrahedron that holds a place, without a mesh
    TESSPA   all tetrahedra that have one of certain vertices
    TESSBA   the circumsphere of a tetrahedron, rounded outwards
    TESSED   the version of the library
    HHFACE, HHSIDE, HHOPP, HHLCOO, HHWRAP
             facets in Householder floating point
    HHORIE, HHINSP
             exact signs: side of a plane, inside of a circumsphere

Arrays. P(3,N): point I is P(1,I), P(2,I), P(3,I). TET(4,*): tetrahedron T has
the points TET(1,T) ... TET(4,T), positively oriented. ADJ(K,T) is the
tetrahedron across the facet opposite to TET(K,T); 0 on the hull; -1 for a facet
still open, which only an unfinished mesh has. Counting is from 1. TET and ADJ
are the same on every machine, with every compiler, and, counted from 0, in C.

Are your points REAL? All coordinates, values, weights and RW are DOUBLE
PRECISION. A REAL array in their stead gives nonsense, and a FORTRAN 77 compiler
need not notice. Copy it first: P(K,I) = X(K,I). A Fortran 90 compiler checks
every call by tess.f90, below.

Lengths, for PARAMETER statements:

      PARAMETER (MAXTET = 8*N, LIW = 19*N + 1800, LRW = 4*N + 12)

LIW and LRW hold for every N; beyond 28000 points LIW = 11*N + 226000 is enough.
MAXTET holds where points fill a volume; for surfaces, curves and lines see
TESSWK. If it is too small INFO is 1, and TESSRE goes on with longer arrays, at
little cost. With integers of 4 bytes these arrays take 364 bytes a point, of
which TET and ADJ have 256.

INFO, the last argument: 0 done; 1 TET and ADJ are full, 2 the pool in IW is
full: what TET and ADJ hold is right, and TESSRE goes on with longer arrays; 3
all points are coplanar, 4 all are collinear, 5 there is at most one distinct
point: no tetrahedron; 6 the arithmetic cannot hold the coordinates; -k argument
k is invalid. Damaged TET and ADJ are no danger: every call ends, and stays
within the arrays. TESSLO and TESSVA, which do not know N, need numbers of
points in TET. A search index is trusted: see TESSIX.

Names. TESS and all external names that begin with TESS, TS or HH are the
library's, now and later: give your own routines and COMMON blocks others.

Versions. tess.f links with the hhpred.f of its own version alone, and of as
many limbs; TESSED tells the version.

Stack. By gfortran -O2 -frecursive on x86-64, with these parameters in both
files:

    parameters                usual points   any points
    as they are                      99 KB       127 KB
    TSLIST = 128                     46 KB        73 KB
    TSLIST = 64, HHLIM = 12          38 KB        38 KB

Leave HHLIM = 88, which holds coordinates of any magnitude. Less saves stack;
INFO is 6 when it is too little. For 12 change each HHLIM = 88 in both files,
and each HHL088 to HHL012, so that they do not link with others.

Floating point. Results are the same in all rounding modes. On ordinary
coordinates, 1E30 at most and with differences of at least 1E-30 of the largest,
no call sets a flag but inexact. With invalid, divide-by-zero and overflow
trapped each routine of tess.f runs through, whatever it is given, NaNs
included. The rounded routines HHFACE, HHSIDE, HHOPP, HHLCOO and HHWRAP overflow
where squares of coordinates do.

The whole of first.f, which reads lines `x y z' and counts those that are no
points. SAVE keeps a program's arrays off the stack.

TEXT
sed -n '/^      PROGRAM/,$p' f77/first.f
cat << 'TEXT'

The value at a place between the points of a lattice; it prints 14.5000:

      PROGRAM PLACE
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

A mesh in steps, its arrays in COMMON: while INFO is 1 TESSRE goes on, with more
room.

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

Fortran 90 and later. tess.f90 has interfaces of all routines:

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

f2c writes tess.c and hhpred.c, names that the C version's files have: give it
another directory,

    mkdir c && f2c -a -dc tess.f hhpred.f

C. A C program may call these routines, as ../test/examples/fortran.c does, and
a Fortran 2003 program the C version, as fortran.f90 there.

Recipes, routines to copy, are in ../test/examples: values on a grid (ONGRID, of
interp.f), smooth interpolation (SLOPES, BENT), natural neighbours (NATURA), the
nearest point (NEARPT), Voronoi cells (CELL), periodic boxes (PERIOD), points in
a plane (PLANAR). README there lists all, with their names in FORTRAN.

Sections, below, are those of C. Hazlewood, "Facet-Based Tetrahedralization
Software", TXSTATE-CS-TR-1995-1 (1995).

TEXT
for name in TESS TESSWK TESSRE TESSLO TESSVA TESSHU TESSCH TESSIX TESSQU TESSPA \
    TESSBA TESSED HHFACE HHSIDE HHOPP HHLCOO HHWRAP HHORIE HHINSP; do
    awk -v routine=$name '
        $1 == "C" && $2 == routine && $3 == "-" { text = 1; n = 0 }
        text == 1 && /^C     How: / { text = 2 }
        text == 1 && /^C/ { line[n++] = substr($0, 7) }
        text && !/^C/ { text = 3 }
        # a line that goes on belongs to the one before it
        text == 3 && /^     [^ ]/ && skip { next }
        { skip = 0 }
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
            # those of constants before them: a length of arguments is written
            # as the number that it is
            if (/^ *PARAMETER \([A-Z]* = [0-9]*\)$/) {
                sub(/^ *PARAMETER \(/, "")
                constant = "(" $1 ")"
                number = "(" $3
                next
            }
            if (/^ *(INTEGER|DOUBLE PRECISION|PARAMETER) /) {
                skip = 1
                next
            }
            text = 0
            print substr("----------------------------------------" \
                "----------------------------------------", 1, 76)
            while (constant != "" && (i = index(types, constant)) > 0)
                types = substr(types, 1, i - 1) number \
                    substr(types, i + length(constant))
            print head types "\n"
            while (n > 0 && line[n-1] == "") n--
            for (i = 0; i < n; i++) print line[i]
            print ""
            exit
        }' f77/tess.f f77/hhpred.f
done
