#!/bin/sh
# paper.sh - the experiments of the paper's Section 4, and what it says of
# errors and of cost, repeated: prints each table beside the paper's figures.
#
#     sh test/paper/paper.sh           all of it; also to test/paper/results.txt
#     sh test/paper/paper.sh -check    the facts of accuracy alone, no times:
#                                      ends with `paper: N passed, M failed'
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
CC=${CC:-cc}
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
        for file in "$at"/blas/$name "$at"/openblas-*/$name "$at"/$name; do
            [ -f "$file" ] || continue
            # which of the two it is, its symbols say
            if grep -q openblas_get_config "$file"; then
                openblas=${openblas:-$file}
            else
                refblas=${refblas:-$file}
            fi
        done
    done
fi
export OPENBLAS_NUM_THREADS=1

# ---- build ----

for name in tess hhpred; do cobj $name "" $name.c; done
cobj exact "" test/exact.c
cobj points "" test/points.c
for name in round acc backward; do cobj $name "" $HERE/$name.c; done
cobj plain -DPLAIN $HERE/round.c
cobj counted -DTESS_COUNT tess.c
cobj count "" $HERE/count.c
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
    for name in acc round store loops dets blas level1; do
        fobj f$name $HERE/$name.f
    done
    fobj fhhpred f77/hhpred.f
    cobj exinsp "" $HERE/exinsp.c
    cobj fbackward -DFORTRAN $HERE/backward.c
    cobj time -DFORTRAN $HERE/time.c
    cobj btime "-DCBLAS -DFORTRAN" $HERE/time.c
    link acc_f "facc fround fstore fhhpred exinsp exact"
    link backward_f "fbackward round fhhpred hhpred exact"
    link time_own \
        "time loops plain hhpred floops fdets fblas flevel1 fhhpred exact"
    all="btime bloops blas plain hhpred floops fdets fblas fhhpred exact"
fi
[ -n "$refblas" ] && link time_ref "$all" "$refblas"
[ -n "$openblas" ] && link time_open "$all" "$openblas"

# ---- the short form ----

if [ "$1" = -check ]; then
    passed=0
    failed=0
    # program NAME COMMAND...: its own tests
    program() {
        name=$1
        shift
        echo "== $name"
        "$@" >$OUT/out 2>&1
        code=$?
        cat $OUT/out
        # shellcheck disable=SC2046
        set -- $(sed -n '$s/^[a-z]*: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' $OUT/out)
        if [ $# -ne 2 ]; then
            echo "FAILED  $name: stopped with code $code"
            failed=$((failed + 1))
            return
        fi
        passed=$((passed + $1))
        failed=$((failed + $2))
    }
    program "accuracy" $OUT/acc -check
    program "errors" $OUT/backward -check 3000
    program "counts" $OUT/count -check
    program "loops of the timings" $OUT/time_own -check
    [ -n "$refblas" ] && program "with reference BLAS" $OUT/time_ref -check
    [ -n "$openblas" ] && program "with OpenBLAS" $OUT/time_open -check
    [ -z "$refblas$openblas" ] && echo "        BLAS: not installed"
    if [ "$FC" = none ]; then
        echo "        no Fortran compiler"
    else
        program "errors, FORTRAN 77" $OUT/backward_f -check 3000
        echo "== FORTRAN 77"
        $OUT/acc >$OUT/acc.txt
        $OUT/acc_f >$OUT/acc_f.txt
        if [ -s $OUT/acc.txt ] && cmp $OUT/acc.txt $OUT/acc_f.txt; then
            echo "ok      acc.f prints what acc.c does"
            passed=$((passed + 1))
        else
            echo "FAILED  acc.f does not print what acc.c does"
            failed=$((failed + 1))
        fi
    fi
    echo "paper: $passed passed, $failed failed"
    [ $failed -eq 0 ]
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

# table NUMBER PAPER HEAD COLUMN...: a column is FILE:LOOP; the paper's own
# columns come first.  The last line: the mean of each column over that of the
# paper's, or our, first one.
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
    }' "$OUT/$paper" $OUT/time_own.txt $OUT/time_ref.txt $OUT/time_open.txt
}

machine=$(lscpu 2>/dev/null | sed -n 's/^Model name: *//p' | head -n 1)
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
repeated: \`make paper'.

machine          $(uname -sm)${machine:+, $machine}
C                $($CC --version 2>/dev/null | head -n 1), $CFLAGS
FORTRAN 77       $fortran
reference BLAS   $(short "$refblas")
OpenBLAS         $(short "$openblas"), one thread

The paper's machines: one node of an nCUBE 2E for the times; an Alpha under VMS
for the accuracy.

1. BLAS timings

Seconds of CPU time for one evaluation of the L-coordinate, the set-up
amortized over the trials; the least of 9 measurements, each long enough for the
clock; 1000 points in turn, the sum of the values kept.

                      the paper                  C
          Householder Householder Householder  Householder   Householder   Householder
               no     library     fortran           no          CBLAS         CBLAS
  trials      blas      blas       blas           blas       reference      OpenBLAS
EOF
table 1 paper1 own:C ref:C-blas open:C-blas
echo
if [ "$FC" = none ]; then
    echo "FORTRAN 77: no Fortran compiler"
else
cat <<'EOF'
                      the paper                  FORTRAN 77
          Householder Householder Householder  Householder   Householder   Householder   Householder
               no     library     fortran           no      loops of our      BLAS          BLAS
  trials      blas      blas       blas           blas           own        reference      OpenBLAS
EOF
table 1 paper1 own:F own:F-blas ref:F-blas open:F-blas
fi
cat <<'EOF'

An evaluation makes five calls: copy, axpy, three dot products of three terms.
As in the paper, and for its reason: the calls cost more than what they do, so
that BLAS multiplies the cost.  The ratios are larger than the paper's since
a compiler now puts hh_lcoord's two dozen operations side by side, while a
call is as long as ever.  The order of library and Fortran is the other
way round: the paper's library was the machine's own; CBLAS in the reference
library is C calling the Fortran routine, two calls in the place of one.

2. Insphere timings

Seconds of CPU time for one evaluation: the L-coordinate; or the determinant,
by the five minors of the facet and a fourth point, which the set-up computes.

                the paper                      C                        FORTRAN 77
  trials  Householder  determ.    Householder  determinants
EOF
if [ "$FC" = none ]; then
    table 2 paper2 own:C own:C-dets
    echo "FORTRAN 77: no Fortran compiler"
else
    table 2 paper2 own:C own:C-dets own:F own:F-dets
fi
} >$OUT/results.txt
cat $OUT/results.txt
