#!/bin/sh
# paper.sh - the experiments of the paper's Section 4, and what it says of
# errors and of cost, repeated: prints each table beside the paper's figures.
#
#     sh test/paper/paper.sh           all of it; also to build/paper/results.txt
#                                      (test/paper/results.txt is of one machine,
#                                      with remarks behind its tables)
#     sh test/paper/paper.sh -check    the facts of accuracy alone, no times:
#                                      prints TAP
#
# From the environment:
#   CC, CFLAGS  the C compiler (cc) and its options (-O3)
#   FC          gfortran or f2c: the one that is there; none: no Fortran
#   FFLAGS      options of gfortran (-O3)
#   BLAS        no: as if none were installed
#
# Two BLAS libraries may be installed, and the linker's default may be either
# under one name: each is linked by its file, found beside the C compiler's
# libraries where Debian keeps the alternatives, and looked up again in what
# the program is then bound to.

cd "$(dirname "$0")/../.." || exit 1
. test/tests.sh
CFLAGS=${CFLAGS:--O3}
FFLAGS=${FFLAGS:--O3}
HERE=test/paper
OUT=build/paper
mkdir -p $OUT || exit 1
LOG=$OUT/log
: >$LOG

die() {
    echo "paper.sh: $1; see $LOG" >&2
    tail -n 5 $LOG >&2
    exit 1
}

# cobj NAME FLAGS SOURCE: $OUT/NAME.o
cobj() {
    # shellcheck disable=SC2086
    $CC $CFLAGS $2 -c -o "$OUT/$1.o" "$3" >>$LOG 2>&1 || die "$3"
}

# fobj NAME SOURCE: $OUT/NAME.o
fobj() {
    if [ "$FC" = f2c ]; then
        # shellcheck disable=SC2086
        # shellcheck disable=SC2015
        f2c -A -a -d$OUT "$2" >>$LOG 2>&1 &&
            $CC $CFLAGS -w -c -o "$OUT/$1.o" \
                "$OUT/$(basename "$2" .f).c" >>$LOG 2>&1 || die "$2"
    else
        # shellcheck disable=SC2086
        $FC -std=legacy $FFLAGS -frecursive -c -o "$OUT/$1.o" "$2" \
            >>$LOG 2>&1 || die "$2"
    fi
}

# link NAME OBJECTS [LIBRARY]: $OUT/NAME
link() {
    objects=
    for o in $2; do objects="$objects $OUT/$o.o"; done
    library=
    [ -n "$3" ] && library="$3 -Wl,-rpath,$(dirname "$3")"
    # shellcheck disable=SC2086
    $LINK $CFLAGS -o "$OUT/$1" $objects $library $LIBS >>$LOG 2>&1 ||
        die "linking $1"
    # is it bound to the library that is meant?
    if [ -n "$3" ] && command -v ldd >/dev/null; then
        ldd "$OUT/$1" | awk '/blas/ {print $3}' >$OUT/bound
        [ "$(readlink -f "$(cat $OUT/bound)")" = "$(readlink -f "$3")" ] ||
            die "$1 is bound to $(cat $OUT/bound), not $3"
    fi
}

# ---- what there is ----

if [ -z "$FC" ]; then
    for FC in gfortran f2c none; do
        command -v $FC >/dev/null && break
    done
fi
LINK=$CC
LIBS=-lm
case $FC in
none) fortran="no Fortran compiler" ;;
f2c)
    fortran="f2c, then $CC $CFLAGS"
    LIBS="-lf2c -lm"
    ;;
*)
    fortran="$($FC --version 2>/dev/null | head -n 1), $FFLAGS"
    LINK=$FC
    ;;
esac

# The C compiler names the file if it is in its libraries' directories, else
# the bare name.
refblas=
openblas=
if [ "$BLAS" != no ]; then
    for name in libblas.so.3 libopenblas.so.0; do
        file=$($CC -print-file-name=$name 2>/dev/null)
        [ -f "$file" ] || continue
        at=$(cd "$(dirname "$file")" && pwd)
        for file in "$at/blas/$name" "$at"/openblas-*/"$name" "$at/$name"; do
            grep -q cblas_ddot "$file" 2>/dev/null || continue
            case $name in
            libopenblas*) openblas=${openblas:-$file} ;;
            *)
                # under this name it may be OpenBLAS in disguise
                grep -qi openblas "$file" || refblas=${refblas:-$file}
                ;;
            esac
        done
    done
fi
export OPENBLAS_NUM_THREADS=1

# ---- build ----

for name in tess hhpred; do cobj $name "" $name.c; done
cobj exact "" test/lib/exact.c
cobj points "" test/lib/points.c
for name in round acc backward; do cobj $name "" $HERE/$name.c; done
cobj plain -DPLAIN $HERE/round.c
cobj counted -DTESS_COUNT tess.c
cobj count "" $HERE/count.c
cobj figure4 "" $HERE/figure4.c
cobj blas "" $HERE/blas.c
cobj sblas -DSINGLE $HERE/blas.c
cobj accblas -DCBLAS $HERE/acc.c
cobj loops "" $HERE/loops.c
cobj bloops -DCBLAS $HERE/loops.c
LIBSF=$LIBS
LINKF=$LINK
LIBS=-lm
LINK=$CC
link acc "acc round hhpred exact"
link backward "backward round hhpred exact"
link count "count counted hhpred points exact"
link figure4 "figure4 tess hhpred"
[ -n "$refblas" ] &&
    link acc_ref "accblas sblas round hhpred exact" "$refblas"
[ -n "$openblas" ] &&
    link acc_open "accblas sblas round hhpred exact" "$openblas"
LINK=$LINKF
LIBS=$LIBSF
if [ "$FC" = none ]; then
    cobj time "" $HERE/time.c
    cobj btime -DCBLAS $HERE/time.c
    link time_own "time loops plain hhpred exact"
    all="btime bloops blas plain hhpred exact"
else
    for name in loops dets blas level1; do fobj f$name $HERE/$name.f; done
    for name in tess hhpred; do fobj f$name f77/$name.f; done
    cobj shim "" test/twin/shim.c
    cobj fbackward -DFORTRAN $HERE/backward.c
    cobj time -DFORTRAN $HERE/time.c
    cobj btime "-DCBLAS -DFORTRAN" $HERE/time.c
    link acc_f "acc round shim ftess fhhpred exact"
    link backward_f "fbackward round shim ftess fhhpred exact"
    link time_own \
        "time loops plain hhpred floops fdets fblas flevel1 fhhpred exact"
    all="btime bloops blas plain hhpred floops fdets fblas fhhpred exact"
fi
[ -n "$refblas" ] && link time_ref "$all" "$refblas"
[ -n "$openblas" ] && link time_open "$all" "$openblas"

# ---- the short form ----

if [ "$1" = -check ]; then
    begin paper
    subtest "accuracy" $OUT/acc -check
    subtest "errors" $OUT/backward -check 3000
    subtest "counts" $OUT/count -check
    subtest "Figure 4" $OUT/figure4 -check
    subtest "loops of the timings" $OUT/time_own -check
    [ -n "$refblas" ] && subtest "with reference BLAS" $OUT/time_ref -check
    [ -n "$openblas" ] && subtest "with OpenBLAS" $OUT/time_open -check
    [ -z "$refblas$openblas" ] && skip "BLAS: not installed"
    if [ "$FC" = none ]; then
        skip "no Fortran compiler"
    else
        subtest "accuracy, FORTRAN 77" $OUT/acc_f -check
        subtest "errors, FORTRAN 77" $OUT/backward_f -check 3000
        $OUT/acc >$OUT/acc.txt
        $OUT/acc_f >$OUT/acc_f.txt
        check "FORTRAN 77: acc prints something" test -s $OUT/acc.txt
        check "FORTRAN 77: acc prints the same" cmp $OUT/acc.txt $OUT/acc_f.txt
    fi
    ended
    exit
fi

# ---- the tables ----

$OUT/time_own >$OUT/time_own.txt
: >$OUT/time_ref.txt
: >$OUT/time_open.txt
[ -n "$refblas" ] && $OUT/time_ref >$OUT/time_ref.txt
[ -n "$openblas" ] && $OUT/time_open >$OUT/time_open.txt

# What the paper printed: trials, without BLAS, library BLAS, Fortran BLAS
cat >$OUT/paper1 <<'EOF'
10000 .2517753E-04 .4506951E-04 .7514621E-04
20000 .2530957E-04 .4506079E-04 .7512725E-04
30000 .2342186E-04 .4505925E-04 .7512100E-04
40000 .2423604E-04 .4506010E-04 .7511742E-04
50000 .2363036E-04 .4505702E-04 .7511496E-04
60000 .2439852E-04 .4505553E-04 .7511338E-04
70000 .2416601E-04 .4505539E-04 .751234E-04
80000 .2408908E-04 .4505610E-04 .751202E-04
90000 .2411615E-04 .4505655E-04 .751133E-04
100000 .2421591E-04 .4505658E-04 .7511085E-04
EOF
# trials, Householder, determinants
cat >$OUT/paper2 <<'EOF'
100 .2443675E-04 .2391187E-04
200 .2612430E-04 .2939204E-04
300 .2310050E-04 .2755631E-04
400 .2431148E-04 .2691151E-04
500 .2335035E-04 .2684309E-04
600 .2452692E-04 .2694426E-04
700 .2419856E-04 .2724844E-04
800 .2406637E-04 .2639701E-04
900 .2413915E-04 .2696446E-04
1000 .2430852E-04 .2656197E-04
10000 .2547753E-04 .2705126E-04
20000 .2530957E-04 .2686962E-04
30000 .2342186E-04 .2706156E-04
40000 .2423604E-04 .2579072E-04
50000 .2363036E-04 .2643391E-04
60000 .2439852E-04 .2699300E-04
70000 .2416601E-04 .2661089E-04
80000 .2408908E-04 .2642198E-04
90000 .2411615E-04 .2636195E-04
100000 .2421591E-04 .2639183E-04
EOF

# table NUMBER PAPER COLUMN...: a column is FILE:LOOP; the paper's own columns
# come first.  The ratios are of the means, to the paper's or our first column.
# The last line is the mean of what the calls alone take, or what the set-up
# takes, by the first row and the last.
table() {
    number=$1
    paper=$2
    shift 2
    awk -v number="$number" -v columns="$*" '
    FILENAME ~ /paper[12]$/ {
        order[++rows] = $1
        for (k = 2; k <= NF; k++) {
            printed[$1, k] = $k
            psum[k] += $k
        }
        pcols = NF
        next
    }
    $1 == number {
        name = FILENAME
        sub(/.*time_/, "", name)
        sub(/\.txt$/, "", name)
        time[$2, name ":" $3] = $4
        sum[name ":" $3] += $4
    }
    END {
        n = split(columns, column, " ")
        for (i = 1; i <= rows; i++) {
            line = sprintf("%8d ", order[i])
            for (k = 2; k <= pcols; k++)
                line = line sprintf(" %9.3e", printed[order[i], k])
            line = line "  "
            for (k = 1; k <= n; k++) {
                t = time[order[i], column[k]]
                line = line sprintf(" %13s",
                    t == "" ? "not installed" : sprintf("%.3e", t))
            }
            print line
        }
        line = "   ratio "
        for (k = 2; k <= pcols; k++)
            line = line sprintf(" %9.2f", psum[k] / psum[2])
        line = line "  "
        for (k = 1; k <= n; k++) {
            t = sum[column[k]]
            line = line sprintf(" %13s",
                t == "" ? "-" : sprintf("%.2f", t / sum[column[1]]))
        }
        print line
        line = number == 1 ? "   calls " : "  set-up "
        for (k = 2; k <= pcols; k++) line = line sprintf(" %9s", "")
        line = line "  "
        for (k = 1; k <= n; k++) {
            t = column[k]
            if (number == 1) {
                sub(/blas/, "calls", t)
                t = t == column[k] ? "" : sum[t] / rows
            } else
                t = order[1] * (time[order[1], t] - time[order[rows], t])
            line = line sprintf(" %13s", t + 0 == 0 ? "-" : sprintf("%.3e", t))
        }
        print line
    }' "$OUT/$paper" $OUT/time_own.txt $OUT/time_ref.txt $OUT/time_open.txt
}

machine=$(lscpu 2>/dev/null | sed -n 's/^Model name: *//p' | head -n 1)
# cc does not say what it is
compiler=$($CC --version 2>/dev/null | head -n 1)
case $compiler in
cc*) compiler=$(basename "$(readlink -f "$(command -v "$CC")")")${compiler#cc} ;;
esac
# short FILE: a library without its directories, but the last
short() {
    if [ -n "$1" ]; then
        echo "$(basename "$(dirname "$1")")/$(basename "$(readlink -f "$1")")"
    else
        echo "not installed"
    fi
}

{
cat <<EOF
Section 4 of C. Hazlewood, Facet-Based Tetrahedralization Software (1995),
repeated: what \`make paper' prints.

machine          $(uname -sm)${machine:+, $machine}
C                $compiler, $CFLAGS
FORTRAN 77       $fortran
reference BLAS   $(short "$refblas")
OpenBLAS         $(short "$openblas")${openblas:+, one thread}

The paper's machines were a node of an nCUBE 2E for the times, and for the
accuracy an Alpha under VMS.


1. BLAS timings

Seconds of CPU time for one evaluation of the L-coordinate, the set-up
amortized over the trials.  Ours are the least of 9 measurements, each of as
many runs as the clock wants; the evaluations go through 1000 points in turn,
and all values are stored.

                       the paper                                C
         Householder Householder Householder   Householder   Householder   Householder
             no       library     fortran           no         reference    OpenBLAS
  trials    blas        blas        blas           blas          CBLAS        CBLAS
EOF
table 1 paper1 own:C ref:C-blas open:C-blas
echo
if [ "$FC" = none ]; then
    echo "                                           FORTRAN 77: no Fortran compiler"
else
    cat <<'EOF'
                       the paper                            FORTRAN 77
         Householder Householder Householder   Householder   Householder   Householder   Householder
             no       library     fortran           no        own loops     reference    OpenBLAS
  trials    blas        blas        blas           blas        as BLAS        BLAS         BLAS
EOF
    table 1 paper1 own:F own:F-blas ref:F-blas open:F-blas
fi
cat <<'EOF'

ratio: to the first column.  calls: the same five calls (copy, axpy, three dot
products) of vectors of length 0.


2. Insphere timings

Seconds of CPU time for one evaluation, the set-up amortized over the trials:
of the L-coordinate; or of the determinant with the rows (x, y, z, x^2+y^2+z^2, 1)
by its five minors of the facet and the fourth point, which the set-up computes.

               the paper                       C                      FORTRAN 77
  trials Householder  determ.    Householder  determinants  Householder  determinants
EOF
if [ "$FC" = none ]; then
    table 2 paper2 own:C own:C-dets
    echo "                                             FORTRAN 77: no Fortran compiler"
else
    table 2 paper2 own:C own:C-dets own:F own:F-dets
fi
cat <<'EOF'

ratio: to the first column.  set-up: by the first row and the last.


3 and 4. Accuracy

An insphere problem: is the test point p5 inside the ball of p1, p2, p3, p4?
Householder: if its L-coordinate for the facet p1, p2, p3 is less than that of
p4.  Determinants: by the minors of p1 ... p4, and their true orientation.
Exact: hh_insphere, on the points as they are rounded; each of its answers is
compared with that of test/lib/exact.c, which shares no method with it.

32-bit arithmetic: each operation's result is stored to a volatile float before it
is used.  The operation itself is done in double; rounded twice, to 53 bits and
then to 24, a sum, product, quotient or root of floats is what float arithmetic
gives, since 53 >= 2 * 24 + 2.  64-bit: the same with double.

The problem, with coordinates below 2 and the origin on the ball:
    p1 = (1.5, 1.25, 1.75)  p2 = (-0.75, 1.5, 0.5)  p3 = (0.5, -1.25, 1)
    p4 = (0, 0, 0)          p5 = (0.5, 0.5, 0.5), times 10^-k in 3
The random problems have multiples of 2^-22 in [-2, 2); in 3, p4 = (0, 0, 0), too.
* marks a wrong answer.  "bound decides": how many the library decides by its
Householder arithmetic and the error bound alone; its exact predicates decide the
rest.

EOF
if [ "$FC" = none ]; then
    echo "FORTRAN 77: no Fortran compiler."
else
    $OUT/acc >$OUT/acc.txt
    $OUT/acc_f >$OUT/acc_f.txt
    if cmp -s $OUT/acc.txt $OUT/acc_f.txt; then
        echo "With the library in FORTRAN 77 the tables are the same, digit for digit."
    else
        echo "With the library in FORTRAN 77 the tables are OTHERS:"
        diff $OUT/acc.txt $OUT/acc_f.txt
    fi
fi
echo
$OUT/acc
cat <<EOF

  32-bit Householder with BLAS calls
    reference: $(if [ -n "$refblas" ]; then $OUT/acc_ref -blas; else echo "not installed"; fi)
    OpenBLAS:  $(if [ -n "$openblas" ]; then $OUT/acc_open -blas; else echo "not installed"; fi)


5. Backward error (Section 3.1)

The computed (z-p1).v is exactly
    sum_i [z_i (1+delta) - p_i (1+delta)] (Q (e3+h))_i.
Every rounding is measured, against arithmetic of 104 bits, and delta and h are
put together of them as in the paper; then this very sum is computed with them,
and is what the machine computed.  e0 is the unit roundoff, 2^-24 and 2^-53.

EOF
$OUT/backward
if [ "$FC" = none ]; then
    echo
    echo "FORTRAN 77: no Fortran compiler"
else
    echo
    $OUT/backward_f
fi
cat <<'EOF'


6. Cost (Section 2), counted

searches     for an apex, one for each tetrahedron and each facet of the hull but
             the first
evaluations  points tried in a search's ball, in lists or one by one, and nodes of
             the tree
L's          of these, points tried one by one, by an L-coordinate if need be
probes       entries of the hash table of open facets looked at, to find one or to
             enter it
open facets  the most there were at a time in that table; those of the star at
             work are kept apart
growth       the exponent of n, from the row above

In C; FORTRAN 77 gives the same arrays by the same searches, but has no counters.

EOF
$OUT/count
cat <<'EOF'


7. Cospherical points (Figure 4)

The corners of a cube, covered by the rule of Figure 4 taken word for word: how
many of their numberings give a wrong cover.  (5,040: all that are not one
another's by a turn or reflection that moves number 0.)

EOF
$OUT/figure4
} >$OUT/results.txt
cat $OUT/results.txt
