#!/bin/sh
# check.sh - all tests; run from the top directory.
#
# Takes CC and CFLAGS from the environment, builds into build/, and ends with
# the line `N passed, N failed'.  The programs' full output is in
# build/check.log.  What a machine lacks (compilers, sanitizers, Fortran) is
# skipped, and said.  Where there are two processors two halves run at the same
# time, the second one's output behind the first one's; PROCESSORS=1: in turn.
CC=${CC:-cc}
CFLAGS=${CFLAGS:--O2}
LIBS=-lm
HARD="tess.c hhpred.c"
PASSED=0
FAILED=0
LOG=build/check.log
OUT=build/out.$$
PROCESSORS=${PROCESSORS:-`getconf _NPROCESSORS_ONLN 2> /dev/null`}

mkdir -p build
: > $LOG

pass() { PASSED=`expr $PASSED + 1`; echo "ok      $1"; }
fail() { FAILED=`expr $FAILED + 1`; echo "FAILED  $1"; }
skip() { echo "        skipped: $1"; }

# one NAME COMMAND...: a test that is passed when the command succeeds.
one() {
    name=$1
    shift
    echo "== $name: $*" >> $LOG
    if "$@" >> $LOG 2>&1; then pass "$name"; else fail "$name"; fi
}

# many NAME PROGRAM...: a program that counts its own tests and ends with
# `program: N passed, N failed'.
many() {
    name=$1
    shift
    echo "== $name: $*" >> $LOG
    # a program that never ends fails too
    (ulimit -t 300; exec "$@") > $OUT 2>&1
    code=$?
    cat $OUT >> $LOG
    last=`tail -n 1 $OUT`
    set -- `echo "$last" | sed -n 's/^[a-z_]*: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p'`
    if [ $# -ne 2 ]; then
        fail "$name: stopped with code $code"
        return
    fi
    PASSED=`expr $PASSED + $1`
    FAILED=`expr $FAILED + $2`
    if [ "$2" -eq 0 ] && [ $code -eq 0 ]; then
        echo "ok      $name: $1"
    else
        [ "$2" -eq 0 ] && FAILED=`expr $FAILED + 1`
        echo "FAILED  $name: $2 of `expr $1 + $2`"
        grep -v '^ok ' $OUT | grep -v '^        ' | head -n 30
    fi
}

# build PROGRAM CC FLAGS FILES...: into build/PROGRAM
build() {
    out=$1
    cc=$2
    flags=$3
    shift 3
    echo "== $cc $flags -o build/$out $*" >> $LOG
    $cc $flags -o build/$out "$@" $LIBS >> $LOG 2>&1
}

# have CC FLAGS: does this compiler take these flags, and its programs run?
have() {
    echo 'int main(void) { return 0; }' > build/have.c
    $1 $2 -o build/have build/have.c $LIBS > /dev/null 2>&1 && build/have
}

# readme LANGUAGE FILE: the program, and what is printed below it as commands,
# into build/readme
readme() {
    mkdir -p build/readme
    for f in tess.c tess.h hhpred.c hhpred.h f77 test; do
        [ -e build/readme/$f ] || ln -s ../../$f build/readme
    done
    sed -n '/^```'$1'$/,/^```$/p' README.md | sed '/^```/d' > build/readme/$2
    awk -v language=$1 '
        $0 == "```" language { at = 1 }
        at == 1 && $0 == "```" { at = 2; next }
        at == 2 && /^    / { print }
        at == 2 && /^[^ ]/ { exit }' README.md > build/readme/commands
}

# ---- the first half: the library in C, on this machine ----
#
# Neither half needs what the other one builds.

first_half() {

# ---- the language: strict C89, no warnings; also as C++ ----

STRICT="-std=c89 -pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Werror"
if have "$CC" "$STRICT"; then
    for f in tess.c hhpred.c test/*.c test/*/*.c; do
        case $f in test/mpi/*) continue;; esac # mpi.h itself has long long
        one "strict C89: $f" $CC $STRICT -O1 -I. -c -o build/strict.o $f
    done
    for f in blas loops time acc backward round; do
        one "strict C89: test/paper/$f.c, all of it" $CC $STRICT -O1 -I. \
            -DCBLAS -DFORTRAN -DSINGLE -DPLAIN -c -o build/strict.o \
            test/paper/$f.c
    done
    # arithmetic on short is of type int: -Wconversion complains of each
    for d in -DTESS_FLOAT "-DTESS_INT=short -Wno-conversion" \
        -DTESS_INT=long -DHH_LIMBS=3 -DTESS_FORTRAN; do
        for f in tess.c hhpred.c; do
            one "strict C89: $f $d" $CC $STRICT -O1 $d -c -o build/strict.o $f
        done
    done
else
    skip "strict C89: $CC does not take the flags"
fi
if have g++ "-x c++"; then
    for f in tess.c hhpred.c; do
        one "C++: $f" g++ -x c++ -Wall -Wextra -Werror -c -o build/strict.o $f
    done
else
    skip "C++: no g++"
fi

# ---- the library asks for nothing but the C89 maths functions, and has no
# data that could be shared between threads ----

$CC $CFLAGS -c -o build/tess.o tess.c
$CC $CFLAGS -c -o build/hhpred.o hhpred.c
if nm build/tess.o > build/nm.txt 2> /dev/null; then
    nm build/hhpred.o >> build/nm.txt
    # what is asked for, but the library's own names and what compilers add
    nm -u build/tess.o build/hhpred.o |
        sed -n 's/^.* \([A-Za-z_0-9]*\)$/\1/p' | sort -u |
        egrep -v '^_?(hh_|tess|sqrt|fabs|floor|ceil|frexp|ldexp|pow|memset|memcpy|__stack_chk|_?GLOBAL_OFFSET)' \
        > build/asked.txt
    one "asks for nothing but maths" test ! -s build/asked.txt
    cat build/asked.txt >> $LOG
    grep ' [bBdDcCgGsS] ' build/nm.txt > build/data.txt
    one "has no data but constants" test ! -s build/data.txt
    cat build/data.txt >> $LOG
else
    skip "symbols: no nm"
fi

# A caller compiled with other types is no link: none of the names is the same.
# mismatch OPTIONS
mismatch() {
    for f in tess hhpred; do
        $CC -O1 $1 -c -o build/other$f.o $f.c >> $LOG 2>&1
    done
    one "links with the same options: $1" \
        $CC $1 -I. -o build/other build/readme.c build/othertess.o \
        build/otherhhpred.o $LIBS
    one "no link with other options: $1" \
        sh -c "! $CC -I. -o build/other build/readme.c build/othertess.o \
        build/otherhhpred.o $LIBS"
    # (of a library of mixed files, either)
    one "no link of mixed files: $1" sh -c "! $CC $1 -I. -o build/other \
        build/readme.c build/othertess.o build/hhpred.o $LIBS"
    nm build/othertess.o build/otherhhpred.o |
        sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort > build/other.txt
    one "no name is the same: $1" sh -c \
        "test -s build/other.txt && ! comm -12 build/names.txt build/other.txt |
        grep ."
    one "unique in six characters: $1" sh -c \
        "! cut -c1-6 build/other.txt | tr A-Z a-z | sort | uniq -d | grep ."
}
sed -n '/^```c$/,/^```$/p' README.md | sed '/^```/d;s/double p/tess_real p/' |
    sed 's/sscanf.* == 3/n < 1/' > build/readme.c
if [ -s build/nm.txt ]; then
    sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' build/nm.txt | sort > build/names.txt
    one "unique in six characters" sh -c \
        "! cut -c1-6 build/names.txt | tr A-Z a-z | sort | uniq -d | grep ."
    for o in -DTESS_INT=long -DTESS_INT=short -DTESS_FLOAT \
        "-DTESS_FLOAT -DTESS_INT=short" "-DTESS_FLOAT -DTESS_INT=long" \
        "-DTESS_INT=ptrdiff_t -include stddef.h"; do
        mismatch "$o"
    done
    for f in tess hhpred; do
        $CC -O1 -DHH_LIMBS=6 -c -o build/other$f.o $f.c >> $LOG 2>&1
    done
    one "no link of mixed files: -DHH_LIMBS=6" sh -c "! $CC -I. \
        -o build/other build/readme.c build/othertess.o build/hhpred.o $LIBS"
fi

# ---- the tests proper ----

for f in test/proof/exact test/points test/unit/t_tess test/unit/t_part; do
    $CC $CFLAGS -c -o build/`basename $f`.o $f.c
done
TEST="build/exact.o build/points.o"

for t in t_pred brute t_tess t_part; do
    also=
    [ $t = brute ] && also=test/proof/define.c
    if build $t "$CC" "$CFLAGS" test/unit/$t.c $also $HARD $TEST; then
        many $t build/$t
    else
        fail "$t does not compile"
    fi
done

# Sizes, whatever the integer.
for d in "" -DTESS_INT=short -DTESS_INT=long; do
    if build t_size "$CC" "-O1 $d" test/unit/t_size.c $HARD; then
        many "t_size $d" build/t_size
        [ "$d" = "" ] && build/t_size -table > build/sizes.txt
    else
        fail "t_size $d does not compile"
    fi
done
one "the README's table of sizes" sh -c \
    "grep '^| [0-9]* | [0-9]* | [0-9]* | [0-9]* | [0-9]* |$' README.md |
    cmp - build/sizes.txt"

# Few limbs: code 2 or TESS_RANGE where they do not suffice, nothing wrong.
if build t_pred3 "$CC" "-O1 -DHH_LIMBS=3" test/unit/t_pred.c hhpred.c $TEST
then
    many "t_pred, 3 limbs" build/t_pred3 50
else
    fail "t_pred, 3 limbs, does not compile"
fi
if build brute3 "$CC" "-O1 -DHH_LIMBS=3" test/unit/brute.c test/proof/define.c $HARD $TEST; then
    many "brute, 3 limbs" build/brute3 100
else
    fail "brute, 3 limbs, does not compile"
fi
for n in 3 6; do
    if build t_tess3 "$CC" "-O1 -DHH_LIMBS=$n" test/unit/t_tess.c $HARD $TEST; then
        many "t_tess -range, $n limbs" build/t_tess3 -range
    else
        fail "t_tess, $n limbs, does not compile"
    fi
    [ $n = 3 ] || continue
    if build t_part3 "$CC" "-O1 -DHH_LIMBS=$n" test/unit/t_part.c $HARD $TEST; then
        many "t_part, $n limbs" build/t_part3 -quick
    else
        fail "t_part, $n limbs, does not compile"
    fi
done

# What only a processor that takes subnormal numbers for zero brings about.
if have "$CC" -Ofast && $CC -Ofast -o build/t_flush build/t_tess.o $HARD \
    $TEST $LIBS >> $LOG 2>&1; then
    many "t_tess, subnormal numbers flushed" build/t_flush -quick
else
    skip "t_tess, subnormal numbers flushed"
fi

# The margins of the search; tess.c is included in the test.
for d in "" -DTESS_LIST=64 -DTESS_FLOAT; do
    if build t_margin "$CC" "$CFLAGS $d" test/unit/t_margin.c test/hunts/hard.c hhpred.c \
        build/exact.o; then
        many "t_margin $d" build/t_margin
    else
        fail "t_margin $d does not compile"
    fi
done

# Coordinates of type float; indices of type short, long.
if build t_predf "$CC" "-O1 -DTESS_FLOAT" test/unit/t_pred.c hhpred.c $TEST
then
    many "t_pred, float" build/t_predf 50
else
    fail "t_pred, float, does not compile"
fi
if build t_partf "$CC" "-O1 -DTESS_FLOAT" test/unit/t_part.c $HARD $TEST; then
    many "t_part -DTESS_FLOAT" build/t_partf -quick
else
    fail "t_part -DTESS_FLOAT does not compile"
fi
for d in -DTESS_FLOAT -DTESS_INT=short -DTESS_INT=long; do
    if build brutef "$CC" "-O1 $d" test/unit/brute.c test/proof/define.c $HARD $TEST; then
        many "brute $d" build/brutef 100
    else
        fail "brute $d does not compile"
    fi
done

# Lists of other capacities only look elsewhere first.
if build brutel "$CC" "-O1 -DTESS_LIST=48" test/unit/brute.c test/proof/define.c $HARD $TEST; then
    many "brute -DTESS_LIST=48" build/brutel 100
else
    fail "brute -DTESS_LIST=48 does not compile"
fi
if build t_tessl "$CC" "-O1 -DTESS_LIST=48" test/unit/t_tess.c $HARD $TEST; then
    many "t_tess -DTESS_LIST=48" build/t_tessl -quick
else
    fail "t_tess -DTESS_LIST=48 does not compile"
fi

# All rounding modes, where C99's fenv.h is to be had.
ROUND="-std=c99 -frounding-math -DTEST_ROUNDING"
if build t_predr "$CC" "$ROUND -O2" test/unit/t_pred.c test/proof/exact.c hhpred.c; then
    many "t_pred, all rounding modes" build/t_predr 10
else
    skip "t_pred in all rounding modes"
fi

if build t_marginr "$CC" "$ROUND -O2 -I." test/unit/t_margin.c test/proof/exact.c \
    test/hunts/hard.c hhpred.c; then
    many "t_margin, all rounding modes" build/t_marginr 10
else
    skip "t_margin in all rounding modes"
fi

# The certificates of the search, with builds of its own.
many "certify" env CC="$CC" sh test/hunts/certify.sh -check

# Sanitizers.
SAN="-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"
if have "$CC" "$SAN"; then
    build brutes "$CC" "$SAN" test/unit/brute.c test/proof/define.c $HARD test/proof/exact.c
    many "brute, sanitizers" build/brutes 50
    build t_tesss "$CC" "$SAN" test/unit/t_tess.c $HARD test/proof/exact.c test/points.c
    many "t_tess, sanitizers" build/t_tesss -quick
    build t_parts "$CC" "$SAN" test/unit/t_part.c $HARD test/proof/exact.c test/points.c
    many "t_part, sanitizers" build/t_parts -quick
else
    skip "sanitizers"
fi

# ---- the same arrays from every build ----
#
# The test itself and its points are compiled once, so that compilers'
# roundings in making the points do not count.

# at this size a list's bounds are rounded in view of the points
many "t_tess, a narrow cluster" build/t_tess -one lastplaces 1500 1
build/t_tess -sums > build/sums.txt
one "checksums of `wc -l < build/sums.txt` results" test -s build/sums.txt

# same NAME CC FLAGS
same() {
    name="same result: $1"
    if ! have "$2" "$3"; then
        skip "$name"
        return
    fi
    if ! build sums1 "$2" "$3" $SUMS $HARD; then
        fail "$name: does not compile"
        return
    fi
    build/sums1 -sums > build/sums1.txt 2>> $LOG
    one "$name" cmp build/sums.txt build/sums1.txt
}

SUMS="build/t_tess.o $TEST"
same "$CC -O0" "$CC" "-O0"
same "$CC -O2" "$CC" "-O2"
same "$CC -Ofast -march=native" "$CC" "-Ofast -march=native"
same "$CC -O3 -funroll-loops -ffp-contract=fast -march=native" "$CC" \
    "-O3 -funroll-loops -ffp-contract=fast -march=native"
same "$CC -mfpmath=387" "$CC" "-O2 -mfpmath=387"
same "clang -O2" clang "-O2"
same "clang -Ofast" clang "-Ofast"
same "tcc" tcc ""

# As C++; the objects of C cannot be linked to it.
SUMS="test/unit/t_tess.c test/proof/exact.c test/points.c"
same "g++ -x c++ -O2" g++ "-x c++ -O2"

# ---- the examples: their own checks, and their output as stored ----

for example in interp poisson embedded surface parts stream sensor derived \
    planar; do
    also=
    [ $example = parts ] && also=-lpthread
    if build "$example" "$CC" "$CFLAGS -I." test/examples/$example.c tess.c hhpred.c $also; then
        (cd build && ./$example $example.obj $example.stl) > build/$example.out 2>> $LOG
        one "example: $example" test $? -eq 0
        one "example: $example, its output" \
            cmp test/examples/$example.out build/$example.out
    else
        fail "example: $example does not compile"
    fi
done

# ---- points spread over processes ----

if command -v mpicc > /dev/null &&
    mpirun --version 2> /dev/null | grep "Open MPI" > /dev/null; then
    # (mpi.h itself has long long)
    if build spread mpicc "$STRICT -Wno-long-long -O2 -I." test/mpi/spread.c \
        test/points.c $HARD; then
        for processes in 1 2 3 4; do
            one "MPI: $processes processes" mpirun --oversubscribe \
                --allow-run-as-root --timeout 300 -np $processes build/spread \
                uniform 1000 clusters 1000 lattice 1000 latticeshuf 512 \
                gradedrot 512 cubegrid 500
        done
    else
        fail "MPI: spread.c does not compile"
    fi
    if ! command -v mpif77 > /dev/null; then
        skip "MPI: no mpif77"
    elif build spreadf mpif77 "-O2 -frecursive" test/mpi/spread.f f77/tess.f \
        f77/hhpred.f; then
        for processes in 1 2 3 4; do
            one "MPI, FORTRAN 77: $processes processes" sh -c "mpirun \
                --oversubscribe --allow-run-as-root --timeout 300 \
                -np $processes build/spreadf > build/spreadf.txt
                cat build/spreadf.txt
                grep '^all are the mesh' build/spreadf.txt"
        done
    else
        fail "MPI: spread.f does not compile"
    fi
else
    skip "MPI: no Open MPI"
fi

# The README's C program and its commands, exactly as printed there, on the data
# that are there; what it says it prints is what the program build/tess proves.
readme c first.c
one "the README's C program: its commands" \
    test `wc -l < build/readme/commands` -eq 2
printed=`(cd build/readme && sh -e commands) 2>> $LOG`
one "the README's C program: prints what is said" \
    grep -F "It prints \`$printed\`" README.md
if [ -x build/tess ]; then
    count=`build/tess -check test/data/mirror.xyz | sed -n 's/^tetrahedra *//p'`
    one "the README's C program: what build/tess proves" \
        test "$printed" = "code 0, $count tetrahedra"
else
    skip "the README's C program: no build/tess to compare with"
fi
if command -v ${PYTHON:-python3} > /dev/null &&
    $CC -O2 -shared -fPIC -o build/readme/libtess.so $HARD $LIBS 2>> $LOG; then
    one "example: first.py" test "`cd build/readme &&
        ${PYTHON:-python3} test/examples/first.py`" = "$printed"
else
    skip "example: first.py: no python3, or no -shared"
fi

# The README's times are rows of what make bench has written.
sed -n '/^## How fast/,/^## Where/p' README.md | grep '^| [a-z].*[0-9]' |
    grep -v '@FIG@' > build/times.txt
while read -r row; do
    one "the README's times: `echo "$row" | cut -d '|' -f 2,3`" \
        grep -Fx "$row" test/results/bench.txt
done < build/times.txt

# ---- the command line program ----

many "the driver" env CC="$CC" sh test/program/driver.sh
}

# ---- the second half: torture, FORTRAN 77, other machines, the paper ----

second_half() {

# Hard sets in hard circumstances, with builds of its own: the hunt's start.
many "torture" env CC="$CC" sh test/hunts/torture.sh -check

# ---- the FORTRAN 77 half: ANSI X3.9-1978 and nothing more ----

# TSRUN, TESSIX and TESSQU cut their workspace up into arrays; a query hands
# over one array twice, that nobody alters.  The standard allows to hand over
# an array element for an array, and to alter the arrays, as they are declared
# in their lengths and do not overlap; that they do not ftnchek cannot know.
# So two of its warnings are off, and with them on it may complain of those
# calls alone.
F77="f77/tess.f f77/hhpred.f"
if command -v ftnchek > /dev/null; then
    CHEK="ftnchek -f77=all -declare -sixchar"
    $CHEK -array=no-dimensions -usage=no-arg-array-alias $F77 \
        > build/ftnchek.txt 2>&1
    cat build/ftnchek.txt >> $LOG
    one "ftnchek: both files read" test \
        `grep -c '^ 0 syntax errors detected' build/ftnchek.txt` -eq 2
    one "ftnchek: no warning" sh -c '! grep -i warning build/ftnchek.txt'
    $CHEK $F77 > build/ftnchek.txt 2>&1
    egrep -i warning build/ftnchek.txt | egrep -v \
        'Subprogram (TSMESH|TSINDE|TSQUER|TSAPEX|TSSETT|TSOPEN|TSECLD|TSOUTS) argument' \
        > build/ftnwarn.txt
    one "ftnchek: warnings of the workspace alone" test ! -s build/ftnwarn.txt
    cat build/ftnwarn.txt >> $LOG
    $CHEK -array=no-dimensions -usage=no-arg-array-alias $F77 test/fortran/parity.f \
        > build/ftnchek.txt 2>&1
    one "ftnchek: parity.f" sh -c '! grep -i warning build/ftnchek.txt'
    $CHEK -noextern -array=no-dimensions -usage=no-arg-array-alias \
        test/examples/parts.f > build/ftnchek.txt 2>&1
    one "ftnchek: parts.f" sh -c '! grep -i warning build/ftnchek.txt'
    for f in test/examples/derived.f test/fortran/sizes.f; do
        $CHEK -array=no-dimensions -usage=no-arg-array-alias -library \
            $F77 $f > build/ftnchek.txt 2>&1
        one "ftnchek: $f" sh -c '! grep -i warning build/ftnchek.txt'
    done
else
    skip "ftnchek: not installed"
fi
one "f77/README is what the sources say" sh -c \
    'sh test/fortran/manual.sh | cmp - f77/README'
one "FORTRAN 77: no line past column 72" \
    sh -c '! grep -n "^.\{73\}" f77/*.f test/*/*.f'

# The table of both names in the header of each file: all routines of C, and
# all of the file, in their order, but for those that only one half has.
# twins NAME ONLY-IN-C ONLY-IN-FORTRAN
twins() {
    sed -n '/The routines of/,/^C$/p' f77/$1.f | sed '/Only in C/,$d' |
        tr -cs 'a-zA-Z0-9_' '\012' |
        awk '/^[A-Z][A-Z0-9]+$/ && last ~ /^[a-z_0-9]+$/ {
            print last, $0 }
            { last = $0 }' > build/names.txt
    sed '/^.* What follows calls these/,/^$/d' $1.c |
        sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*[^;]$/\1/p' |
        egrep -v "^($2)$" > build/cnames.txt
    sed -n 's/^      [A-Z ]*\(FUNCTION\|SUBROUTINE\) \([A-Z0-9]*\).*/\2/p' \
        f77/$1.f | egrep -v "^($3)$" > build/fnames.txt
    awk '$1 !~ /^(frexp|ldexp)$/ { print $1 }' build/names.txt |
        diff build/cnames.txt - > build/diff.txt &&
        awk '{ print $2 }' build/names.txt | diff build/fnames.txt - \
            > build/diff.txt
    one "both names in the header of f77/$1.f" test $? -eq 0
    cat build/diff.txt >> $LOG
}
twins tess "point|coords|four|better|proven|barren|layout" \
    "TSPDIS|TSLINE|TSMESH|TSINDE|TSQUER|TSORIQ|TSORIP|TSFOOT"
twins hhpred "held|shift|least" "HHKIND"

# ---- the same results as the C half ----

# gfortran -std=f95 -pedantic knows of no extension of FORTRAN 77 that is not
# in Fortran 90; -fcheck=all stops at a subscript out of bounds.
GFORT="gfortran -frecursive -Wall -Wextra -Werror"
gfort() {
    $GFORT -std=f95 -pedantic "$@" -c -o build/ftess.o f77/tess.f &&
        $GFORT -std=f95 -pedantic "$@" -c -o build/fhhpred.o f77/hhpred.f &&
        $GFORT -std=legacy -O1 -fcheck=all -c -o build/fparity.o test/fortran/parity.f
}
viaf2c() {
    mkdir -p build/f2c &&
        f2c -A -a -u -dbuild/f2c $F77 test/fortran/parity.f > build/f2c.txt 2>&1 &&
        ! grep -i warning build/f2c.txt &&
        $CC -O2 -c -o build/ftess.o build/f2c/tess.c &&
        $CC -O2 -c -o build/fhhpred.o build/f2c/hhpred.c &&
        $CC -O2 -c -o build/fparity.o build/f2c/parity.c
}
# The C half compiled for Fortran; fparity.o stays what it is.
entries() {
    $CC $CFLAGS -DTESS_FORTRAN -c -o build/ftess.o tess.c &&
        $CC $CFLAGS -DTESS_FORTRAN -c -o build/fhhpred.o hhpred.c
}

# fortran NAME COMPILE...: compile the half, link it with the C half, compare
# arrays.  OTHER is what of the C half is needed besides tess.o.
fortran() {
    name=$1
    shift
    echo "== FORTRAN 77, $name" >> $LOG
    rm -f build/ftess.o build/fhhpred.o
    "$@" >> $LOG 2>&1
    if $LINKF -o build/t_f77 build/t_f77.o build/tess.o $OTHER \
        build/points.o build/ftess.o build/fhhpred.o $LIBS >> $LOG 2>&1
    then
        many "FORTRAN 77, $name" build/t_f77
    else
        fail "FORTRAN 77, $name: does not compile"
    fi
}

# text NAME: link the Fortran program with the half just compiled, and compare
# its text with the C program's.
text() {
    rm -f build/parityf
    if $LINKF -o build/parityf build/fparity.o build/ftess.o build/fhhpred.o \
        $LIBF $LIBS >> $LOG 2>&1
    then
        build/parityf > build/parityf.txt
        one "parity: $1" cmp build/parity.txt build/parityf.txt
    else
        fail "parity: $1: does not link"
    fi
}

# threads NAME: link the half just compiled with a program of several threads.
# Local arrays must be on the stack: -frecursive, f2c -a.
OMP_NUM_THREADS=4
export OMP_NUM_THREADS
threads() {
    [ -f build/threads.o ] || return
    rm -f build/threads
    $LINKF -fopenmp -o build/threads build/threads.o build/points.o \
        build/ftess.o build/fhhpred.o $LIBS >> $LOG 2>&1
    many "threads: $1" build/threads
}
rm -f build/threads.o
if have "$CC" -fopenmp; then
    $CC $CFLAGS -fopenmp -c -o build/threads.o test/fortran/threads.c
else
    skip "threads: no OpenMP"
fi

# The README's FORTRAN program and its commands, exactly as printed there.
fortran_readme() {
    readme fortran first.f
    one "the README's FORTRAN program: its commands" \
        test `wc -l < build/readme/commands` -eq 2
    set -- `(cd build/readme && sh -e commands) 2>> $LOG`
    one "the README's FORTRAN program: prints what is said" \
        grep -F "It prints \`$1 $2\`" README.md
    one "the README's FORTRAN program: as the C program" \
        grep -F "It prints \`code $1, $2 tetrahedra\`" README.md
}

# FORTRAN programs that tell by their text whether all is well.
# programs NAME FLAGS: with the half just compiled
programs() {
    for f in $F77PROGRAMS; do
        rm -f build/program
        gfortran $2 -o build/program $f build/ftess.o build/fhhpred.o $LIBS \
            >> $LOG 2>&1
        text=build/`basename $f .f`.txt
        case $f in
        test/examples/*)
            build/program > $text
            one "$f, $1" cmp `echo $f | sed 's/f$/out/'` $text;;
        *) many "$f, $1" build/program;;
        esac
    done
}
F77PROGRAMS="test/examples/derived.f test/fortran/sizes.f"

# interface NAME FLAGS: the module for Fortran 90, and that with it wrong calls
# do not compile; f77/README's program
interface() {
    (cd build && gfortran -std=f95 -pedantic -Wall -Wextra -Werror $2 -c \
        -o module.o ../f77/tess.f90) >> $LOG 2>&1
    module="-cpp -Ibuild -Jbuild $2"
    if gfortran -std=f2018 -pedantic $module -o build/iface test/fortran/iface.f90 \
        build/ftess.o build/fhhpred.o $LIBS >> $LOG 2>&1
    then
        many "interfaces, $1" build/iface
    else
        fail "interfaces, $1: do not compile"
    fi
    for wrong in 1 2 3 4; do
        one "interfaces, $1: wrong call $wrong" sh -c "! gfortran $module \
            -DWRONG=$wrong -c -o build/module.o test/fortran/iface.f90"
    done
    awk '/^      PROGRAM GRID/,/^      END$/' f77/README > build/grid.f
    rm -f build/grid
    gfortran $2 -o build/grid build/grid.f build/ftess.o build/fhhpred.o \
        $LIBS >> $LOG 2>&1
    one "f77/README's program, $1" test "`build/grid`" = " 14.5000"
}

# parity.c and parity.f write the same text; parity.txt is what they wrote
# when it was made, so that a machine without Fortran compares, too.  It is not
# believed: the first program proves each answer by exact.c, and knows the
# code of each bad argument and fault from the interface.  (When the library's
# own figures change, as the lengths of the workspace: cp build/parity.txt test/fortran.)
if build parity "$CC" "$CFLAGS -DPROVE" test/fortran/parity.c test/proof/prove.c $HARD \
    test/proof/exact.c; then
    build/parity > build/parity.txt 2> build/prove.txt
    cat build/prove.txt >> $LOG
    one "parity: proofs" grep '^prove: [0-9]* passed, 0 failed' build/prove.txt
    one "parity: no code but the promised one" \
        sh -c 'test -s build/parity.txt && ! grep WRONG build/parity.txt'
    one "parity: the text as stored" cmp test/fortran/parity.txt build/parity.txt
else
    fail "parity.c does not compile"
fi
# (what makes infinities and NaNs must not be compiled with -Ofast)
$CC $CFLAGS -c -o build/parity.o test/fortran/parity.c
for c in "$CC -O0" "$CC -Ofast -march=native" "clang -Ofast" "tcc"; do
    set -- $c
    cc=$1
    shift
    if have $cc "$*"; then
        build parity1 $cc "$*" build/parity.o $HARD
        build/parity1 > build/parity1.txt
        one "parity: $c" cmp test/fortran/parity.txt build/parity1.txt
    else
        skip "parity: $c"
    fi
done

$CC $CFLAGS -c -o build/tess.o tess.c
$CC $CFLAGS -c -o build/hhpred.o hhpred.c
$CC $CFLAGS -c -o build/t_f77.o test/fortran/t_f77.c
$CC $CFLAGS -c -o build/points.o test/points.c
LINKF=$CC
LIBF=
OTHER=
fortran "C with -DTESS_FORTRAN" entries
threads "C with -DTESS_FORTRAN"
OTHER=build/hhpred.o
if command -v gfortran > /dev/null; then
    LINKF=gfortran
    fortran "gfortran -O0" gfort -O0
    text "gfortran -O0"
    fortran "gfortran -fcheck=all" gfort -O1 -fcheck=all
    text "gfortran -fcheck=all"
    fortran "gfortran -O3" gfort -O3
    text "gfortran -O3"
    threads "gfortran -O3"
    programs "gfortran -O3" "-std=legacy -O1 -fcheck=all"
    interface "gfortran -O3"
    gfort -Ofast -march=native >> $LOG 2>&1
    text "gfortran -Ofast -march=native"
    entries
    text "gfortran and C with -DTESS_FORTRAN"
    # integers of 8 bytes, in both halves
    gfort -O2 -fdefault-integer-8 >> $LOG 2>&1
    programs "INTEGER*8" "-std=legacy -fdefault-integer-8"
    interface "INTEGER*8" -fdefault-integer-8
    for half in tess hhpred; do
        $CC $CFLAGS -DTESS_FORTRAN -DTESS_INT=long -c -o build/f$half.o $half.c
    done
    programs "INTEGER*8 and C" "-std=legacy -fdefault-integer-8"
    interface "INTEGER*8 and C" -fdefault-integer-8
    # few limbs: the same codes 2 and 6 as from C
    fewlimbs() {
        for half in tess hhpred; do
            sed 's/HHLIM = 88/HHLIM = 3/' f77/$half.f > build/few$half.f
            $GFORT -O1 -c -o build/f$half.o build/few$half.f || return 1
        done
        $CC $CFLAGS -DHH_LIMBS=3 -c -o build/tess.o tess.c
        $CC $CFLAGS -DHH_LIMBS=3 -c -o build/hhpred.o hhpred.c
        $CC $CFLAGS -DHH_LIMBS=3 -c -o build/t_f77.o test/fortran/t_f77.c
    }
    fortran "gfortran, 3 limbs" fewlimbs
    $CC $CFLAGS -c -o build/tess.o tess.c
    $CC $CFLAGS -c -o build/hhpred.o hhpred.c
    $CC $CFLAGS -c -o build/t_f77.o test/fortran/t_f77.c
    entries
    for omp in "" -fopenmp; do
        rm -f build/partsf
        gfortran -O2 -frecursive $omp -o build/partsf test/examples/parts.f \
            $F77 >> $LOG 2>&1
        build/partsf > build/partsf.out 2>> $LOG
        one "example: parts.f $omp" cmp test/examples/parts.out build/partsf.out
    done
    fortran_readme
else
    skip "the FORTRAN 77 half: no gfortran"
fi
if command -v f2c > /dev/null; then
    LINKF=$CC
    LIBF=-lf2c
    fortran "f2c" viaf2c
    text "f2c"
    threads "f2c"
    entries
    text "f2c and C with -DTESS_FORTRAN"
else
    skip "the FORTRAN 77 half through f2c: no f2c"
fi

# ---- the same results on other machines, simulated ----

# cross COMPILER EMULATOR MACHINE
cross() {
    name="same result: $3"
    if command -v $1 > /dev/null && command -v $2 > /dev/null; then
        if build cross $1 "-O2 -static" test/fortran/parity.c $HARD; then
            $2 build/cross > build/cross.txt 2>> $LOG
            one "$name" cmp test/fortran/parity.txt build/cross.txt
        else
            fail "$name: does not compile"
        fi
    else
        skip "$name: no $1 with $2"
    fi
}
cross powerpc64-linux-gnu-gcc qemu-ppc64 "big-endian (PowerPC)"
cross arm-linux-gnueabihf-gcc qemu-arm "32-bit ARM"
cross i686-linux-gnu-gcc qemu-i386 "x87"
cross m68k-linux-gnu-gcc qemu-m68k "big-endian with an 80-bit unit (68k)"

# int of 16 bits and double of 24, in 16 kilobytes of memory: once indices of 16
# bits and -Os, once of 32 bits and -O2.  (A difference may be the simulator's:
# simavr 1.6 takes an adiw or sbiw by 12 to 15, modulo 16, that is to be skipped
# for two words.)
name="same result: AVR"
if command -v avr-gcc > /dev/null && command -v simavr > /dev/null; then
    if build tiny "$CC" "-O2 -DTESS_FLOAT" test/machines/tiny.c $HARD &&
        build tiny.elf avr-gcc \
            "-std=gnu89 -mmcu=atmega1284p -Os -DTESS_INT=short -DTESS_LIST=64" \
            test/machines/tiny.c $HARD
    then
        build/tiny > build/tiny.txt
        (ulimit -t 100; exec simavr -m atmega1284p -f 16000000 \
            build/tiny.elf) 2>&1 |
            sed -n 's/[^ -~]\[[0-9]*m//g; s/\.$//p' > build/avr.txt
        one "$name" cmp build/tiny.txt build/avr.txt
        # each line begins with the code 0
        one "tiny: 4 sets" test `grep -c '^0 1 0' build/tiny.txt` -eq 4
    else
        fail "$name: does not compile"
    fi
    if build sensor.elf avr-gcc \
        "-std=gnu89 -mmcu=atmega1284p -O2 -DTESS_LIST=64 -I." \
        test/examples/sensor.c $HARD; then
        (ulimit -t 100; exec simavr -m atmega1284p -f 16000000 \
            build/sensor.elf) 2>&1 |
            sed -n 's/[^ -~]\[[0-9]*m//g; s/\.$//p' > build/avr.txt
        one "example: sensor, AVR" cmp test/examples/sensor.out build/avr.txt
    else
        fail "example: sensor, AVR: does not compile"
    fi
else
    skip "$name: no avr-gcc with simavr"
fi

# ---- the facts of the paper's Section 4 ----

many "the paper's experiments" env CC="$CC" CFLAGS="$CFLAGS" \
    sh test/paper/paper.sh -check
}

# ---- both ----

if [ "$PROCESSORS" -gt 1 ] 2> /dev/null; then
    # links to the sources, and a build/ of its own
    HALF=build/half
    rm -rf $HALF
    mkdir -p $HALF/build
    for f in *; do
        [ "$f" = build ] || ln -s "../../$f" $HALF
    done
    (
        cd $HALF || exit
        second_half
        echo $PASSED $FAILED > build/counts
    ) > $HALF/out 2>&1 &
    trap "kill $! 2> /dev/null; exit 1" INT TERM
    first_half
    wait $!
    cat $HALF/out
    cat $HALF/$LOG >> $LOG
    if read passed failed < $HALF/build/counts; then
        PASSED=`expr $PASSED + $passed`
        FAILED=`expr $FAILED + $failed`
    else
        fail "the second half: stopped"
    fi
else
    first_half
    second_half
fi
rm -f $OUT

echo "$PASSED passed, $FAILED failed"
test $FAILED -eq 0
