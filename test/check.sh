#!/bin/sh
# check.sh [-all] - the tests; run from the top directory.
# check.sh -unit NAME [ARGUMENTS] - a program of test/unit alone.
#
# Without -all what a change wants most: strict C89, the unit tests, brute
# force, both halves' parity, sanitizers, the examples and the program.  With
# -all more of each, all builds, machines and processes, and a beginning of the
# hunts.
# test/README says what is where.
#
# Takes from the environment, and builds into build/:
#   CC, CFLAGS      the compiler and its options
#   ONLY=WORD       only what has this word in its name; of a group of tests, as
#                   `recipes: ', in the group's
#   COMPLETE=yes    what is skipped has failed
#   PROCESSORS=1    all in turn; where there are two processors two halves run at
#                   the same time, the second one's output behind the first one's
# Ends with the line `N passed, N failed, N skipped'.  The programs' full output
# is in build/check.log.  What a machine lacks (compilers, sanitizers, Fortran)
# is skipped, and said.
. test/tests.sh
ALL=
[ "$1" = -all ] && ALL=yes
CFLAGS=${CFLAGS:--O2}
LIBS=-lm
LIBRARY="tess.c hhpred.c"
LOG=build/check.log
OUT=build/out.$$
PROCESSORS=${PROCESSORS:-$(getconf _NPROCESSORS_ONLN 2> /dev/null)}
STRICT="-std=c89 -pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Werror"

begin check
: > $LOG

# wanted NAME: has it ONLY in it?
wanted() {
    case $1 in *"$ONLY"*) return 0;; esac
    return 1
}

# group NAME: may a test of this group be wanted, whose names begin so?
group() {
    wanted "$1" && return
    case $ONLY in *"$1"*) return 0;; esac
    return 1
}

# skipped NAME: what the machine lacks
skipped() {
    wanted "$1" || return 0
    if [ -z "$COMPLETE" ]; then skip "$1"; else fail "$1: skipped"; fi
}

# one NAME COMMAND...: a test that is passed when the command succeeds.
one() {
    wanted "$1" || return 0
    echo "== $*" >> $LOG
    yes "$@" >> $LOG 2>&1
}

# shown NAME COMMAND...: the same for one that writes what differs
shown() {
    wanted "$1" || return 0
    name=$1
    shift
    if "$@" > $OUT 2>&1; then
        pass "$name"
    else
        fail "$name: what differs:"
        head -n 60 $OUT
        cat $OUT >> $LOG
    fi
}

# many NAME PROGRAM...: a program that counts its own tests and ends with
# `program: N passed, N failed'; what it skips it says.
many() {
    wanted "$1" || return 0
    name=$1
    shift
    alone="(cd $(pwd) && $*)"
    echo "== $name: $*" >> $LOG
    limited 300 "$@" > $OUT 2>&1
    code=$?
    cat $OUT >> $LOG
    tail -n 1 $OUT > $OUT.last
    sed -n 's/^        skipped: //p' $OUT > $OUT.skipped
    while read -r line; do skipped "$name: $line"; done < $OUT.skipped
    # shellcheck disable=SC2046 # two numbers
    set -- $(counted $OUT.last)
    if [ $# -ne 2 ]; then
        fail "$name: stopped with code $code; its last lines:"
        tail -n 8 $OUT | sed 's/^/        | /'
        echo "        run it alone: $alone"
        return
    fi
    [ "$2" -gt 0 ] || [ $code -eq 0 ] || set -- "$1" 1
    count "$1" "$2" 0
    if [ "$2" -eq 0 ]; then
        echo "ok      $name: $1"
    else
        echo "FAILED  $name: $2 of $(($1 + $2))"
        grep -v '^ok ' $OUT | grep -v '^        ' | head -n 30
        echo "        run it alone: $alone"
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

# compile CC FLAGS DIRECTORY FILES...: objects in the directory
compile() {
    cc=$1
    flags=$2
    dir=$3
    shift 3
    mkdir -p $dir
    for f in "$@"; do
        echo "== $cc $flags -c $f" >> $LOG
        $cc $flags -c -o "$dir/$(basename $f .c).o" $f >> $LOG 2>&1 || return 1
    done
}

# unit NAME CC FLAGS PROGRAM: that program of test/unit and the library, all
# compiled so, into $here; the library once.  (With HARNESS the points and the
# proofs have these flags.)
HARNESS=
COMMON="test/points.c test/proof/*.c test/hunts/hard.c test/unit/damage.c
    test/unit/guard.c"
MADE=
unit() {
    here=build/units/$(echo "$1" | tr -cd 'a-zA-Z0-9')
    case $MADE in
    *" $here "*) ;;
    *)
        rm -rf $here
        compile "$2" "$3" $here $LIBRARY &&
            compile "$2" "${HARNESS:-$3}" $here $COMMON || return
        MADE="$MADE $here "
        ;;
    esac
    $2 $3 -I. -c -o $here/_$4.o test/unit/$4.c >> $LOG 2>&1 &&
        $2 $3 -o $here/$4 $here/_$4.o $here/[!_]*.o $LIBS >> $LOG 2>&1
}

# usual PROGRAM: build/units/usual/PROGRAM; ONLY may have left it out
usual() {
    case $MADE in *" build/units/usual "*)
        [ -x build/units/usual/$1 ] && return;;
    esac
    unit usual "$CC" "$CFLAGS" $1
}

# units NAME CC FLAGS TEST...: each TEST is a program of test/unit and its
# arguments
units() {
    tag=$1
    compiler=$2
    options=$3
    shift 3
    for t in "$@"; do
        wanted "$t, $tag" || continue
        if unit "$tag" "$compiler" "$options" ${t%% *}; then
            many "$t, $tag" $here/$t
        else
            fail "$t, $tag: does not compile"
        fi
    done
}

if [ "$1" = -unit ]; then
    shift
    program=$1
    if [ ! -f "test/unit/$1.c" ]; then
        echo "no test/unit/$1.c"
        exit 1
    fi
    if ! unit usual "$CC" "$CFLAGS" "$1"; then
        tail -n 20 $LOG
        exit 1
    fi
    shift
    exec $here/$program "$@"
fi

# itself: a program that stops or fails is shown, and how to run it; what is
# skipped, and whether that is a failure; ONLY
itself() {
    echo 'echo so far; exit 7' > build/stops
    echo 'echo "FAILED  a line"; echo "x: 1 passed, 1 failed"; exit 1' \
        > build/fails
    echo 'echo "        skipped: this"; echo "x: 2 passed, 0 failed"' \
        > build/skips
    # those NAMES: the programs, and the counts
    those() {
        begin itself
        for t in $1; do many $t sh build/$t; done
        counts
    }
    { (ONLY=; COMPLETE=; those "stops fails skips")
      (ONLY=kip; COMPLETE=yes; those "stops fails skips"); } > build/itself.txt
    for line in "FAILED  stops: stopped with code 7; its last lines:" \
        "        | so far" "        run it alone: (cd $(pwd) && sh build/stops)" \
        "FAILED  fails: 1 of 2" "FAILED  a line" \
        "        run it alone: (cd $(pwd) && sh build/fails)" \
        "        skipped: skips: this" "3 2 1" \
        "FAILED  skips: this: skipped" "2 1 0"; do
        one "itself: $line" grep -Fx "$line" build/itself.txt
    done
}

# ---- the language: strict C89, no warnings; also as C++ ----

language() {
    if have "$CC" "$STRICT"; then
        one "strict C89: the tests" sh -c "for f in test/*.c test/*/*.c; do
            # mpi.h and mex.h are not C89; recipes77.h is not made yet
            case \$f in test/mpi/*|*_mex.c|*/fortran/recipes.c) continue;; esac
            $CC $STRICT -fsyntax-only -I. \$f || exit 1; done"
        for d in -DTESS_FLOAT -DTESS_INT=long; do
            one "strict C89: build/tess $d" sh -c "for f in test/program/*.c; do
                $CC $STRICT $d -fsyntax-only -I. \$f || exit 1; done"
        done
        one "strict C89: the paper's programs, all of them" sh -c "cd test/paper
            for f in blas loops time acc backward round figure4; do
            $CC $STRICT -fsyntax-only -I. -DCBLAS -DFORTRAN -DSINGLE -DPLAIN \
            \$f.c || exit 1; done"
        for d in -O2 -DTESS_FLOAT -DTESS_INT=short -DTESS_INT=long \
            "-DHH_LIMBS=3 -DTESS_LIST=64"; do
            for f in $LIBRARY; do
                # (what a compiler finds when it optimizes it finds in one)
                how="-O1 -c -o build/strict.o"
                [ "$d" = -O2 ] || how=-fsyntax-only
                one "strict C89: $f $d" $CC $STRICT -Wdouble-promotion $d \
                    $how $f
            done
        done
        one "strict C89: programs for small machines" sh -c "for f in \
            test/machines/tiny.c test/examples/embedded.c \
            test/examples/sensor.c test/unit/t_size.c test/unit/t_pred.c \
            test/unit/brute.c $(echo $COMMON); do
            $CC $STRICT -DTESS_INT=short -fsyntax-only -I. \$f || exit 1; done"
    else
        skipped "strict C89: $CC does not take the flags"
    fi
    if have g++ "-x c++"; then
        for f in $LIBRARY; do
            one "C++: $f" g++ -x c++ -Wall -Wextra -Werror -c -o build/strict.o $f
        done
        for d in "" -DTESS_INT=short "-DTESS_INT=long -DTESS_FLOAT"; do
            one "C++: the headers in a namespace $d" spaced "$d"
        done
    else
        skipped "C++: no g++"
    fi
}

# spaced FLAGS: tess.h and recipes.h inside a namespace, their macros outside
spaced() {
    cat > build/spaced.c <<END
#include <stdio.h>
namespace a {
#include "tess.h"
#include "test/examples/recipes.h"
}
static a::tess_int iw[TESS_LIW(5)], tet[32], adj[32], first[6], list[32], ntet;
static double rw[TESS_LRW(5L)];
static const a::tess_real p[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
int main()
{
    int code = a::tess(5, p, 8, &ntet, tet, adj, TESS_LIW(5), iw, TESS_LRW(5),
                       rw);
    a::stars(5, ntet, tet, first, list);
    return code != 0 || ntet < 2 || ntet > TESS_INT_MOST ||
           first[5] != 4 * ntet;
}
END
    # shellcheck disable=SC2086
    g++ -x c++ -pedantic -Wall -Wextra -Wconversion -Wold-style-cast -Werror \
        $1 -I. -c -o build/spaced.o build/spaced.c || return
    rm -f build/spaced
    # shellcheck disable=SC2086
    $CC $1 -O1 -I. -c -o build/derived1.o test/examples/derived.c &&
        $CC $1 -O1 -o build/spaced build/spaced.o build/derived1.o $LIBRARY \
            $LIBS && build/spaced
}

# ---- the names: the library asks for nothing but the C89 maths functions, has
# no data that could be shared between threads, and links with no caller that
# was compiled with other types ----

# mismatch OPTIONS
mismatch() {
    group "linking, $1: " || return
    for f in tess hhpred; do
        $CC -O1 $1 -c -o build/other$f.o $f.c >> $LOG 2>&1
    done
    one "linking, $1: the same options" \
        $CC $1 -I. -o build/other build/caller.c build/othertess.o \
        build/otherhhpred.o $LIBS
    one "linking, $1: no other options" \
        sh -c "! $CC -I. -o build/other build/caller.c build/othertess.o \
        build/otherhhpred.o $LIBS"
    # (of a library of mixed files, either)
    one "linking, $1: no mixed files" sh -c "! $CC $1 -I. -o build/other \
        build/caller.c build/othertess.o build/hhpred.o $LIBS"
    nm build/othertess.o build/otherhhpred.o |
        sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort > build/other.txt
    one "linking, $1: no name is the same" sh -c \
        "test -s build/other.txt && ! comm -12 build/names.txt build/other.txt |
        grep ."
    one "linking, $1: unique in six characters" sh -c \
        "! cut -c1-6 build/other.txt | tr A-Z a-z | sort | uniq -d | grep ."
}

symbols() {
    compile "$CC" "$CFLAGS" build $LIBRARY
    if ! nm build/tess.o > build/nm.txt 2> /dev/null; then
        skipped "symbols: no nm"
        return
    fi
    nm build/hhpred.o >> build/nm.txt
    # what is asked for, but the library's own names and what compilers add
    nm -u build/tess.o build/hhpred.o |
        sed -n 's/^.* \([A-Za-z_0-9]*\)$/\1/p' | sort -u |
        egrep -v '^_?(hh_|tess|sqrt|fabs|floor|ceil|frexp|ldexp|pow|memset)' |
        egrep -v '^_?(memcpy|__stack_chk|_?GLOBAL_OFFSET)' > build/asked.txt
    one "asks for nothing but maths" test ! -s build/asked.txt
    cat build/asked.txt >> $LOG
    grep ' [bBdDcCgGsS] ' build/nm.txt > build/data.txt
    one "has no data but constants" test ! -s build/data.txt
    cat build/data.txt >> $LOG
    sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' build/nm.txt | sort > build/names.txt
    one "unique in six characters" sh -c \
        "! cut -c1-6 build/names.txt | tr A-Z a-z | sort | uniq -d | grep ."
    # (a caller with the types' names)
    fenced c | sed 's/double p/tess_real p/' > build/caller.c
    mismatch -DTESS_INT=long
    [ -z "$ALL" ] && return
    for o in -DTESS_INT=short -DTESS_FLOAT "-DTESS_FLOAT -DTESS_INT=short" \
        "-DTESS_FLOAT -DTESS_INT=long" \
        "-DTESS_INT=ptrdiff_t -include stddef.h"; do
        mismatch "$o"
    done
    for word in unsigned:signed "long long:one word" int_least64_t:header; do
        one "TESS_INT=${word%%:*} is refused" sh -c "! $CC -c -o build/have.o \
            '-DTESS_INT=${word%%:*}' hhpred.c 2> build/have.txt &&
            grep '${word##*:}' build/have.txt"
    done
    group "linking, -DHH_LIMBS=6: " || return
    for f in tess hhpred; do
        $CC -O1 -DHH_LIMBS=6 -c -o build/other$f.o $f.c >> $LOG 2>&1
    done
    one "linking, -DHH_LIMBS=6: no mixed files" sh -c "! $CC -I. \
        -o build/other build/caller.c build/othertess.o build/hhpred.o $LIBS"
}

# ---- the unit tests, with builds that decide what they do ----

# All rounding modes, where C99's fenv.h is to be had.
ROUND="-std=c99 -frounding-math -DTEST_ROUNDING -O2"
SANITIZE="-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"

# arguments: what a program of test/unit does not take it refuses
arguments() {
    for t in "brute -quick" "brute 0" "brute 9 9 9" "brute -one 99 1" \
        "t_cells 9" "t_natural quick" "t_part quick" "t_part -quick 9" \
        "t_pred -quick" "t_pred 0" "t_pred 9x" "t_size -quick" "t_tess quick" \
        "t_tess -sums 0" "t_tess -one uniform" "t_index -quick"; do
        usual "${t%% *}" || return
        limited 60 build/units/usual/$t > $OUT 2>&1
        [ $? -eq 2 ] && grep '^usage: ' $OUT || return
    done
}

tests() {
    one "units: arguments that are refused" arguments
    if have "$CC" "-include test/machines/short.h"; then
        one "units: doubles of 24 bits, flushed" sh -c "$CC -O1 -include \
            test/machines/short.h -o build/short test/machines/short.c \
            $LIBRARY -lm && build/short"
    else
        skipped "units: doubles of 24 bits, flushed"
    fi
    if [ -z "$ALL" ]; then
        # (t_tess and t_part run with sanitizers)
        units usual "$CC" "$CFLAGS" "t_pred 20" brute t_size t_natural t_cells
        many "certify" env CC="$CC" sh test/hunts/certify.sh -quick
        # few limbs: code 2 or TESS_RANGE where they do not suffice
        units -DHH_LIMBS=3 "$CC" "-O1 -DHH_LIMBS=3" "t_pred 10" "brute 100" \
            "t_tess -range"
        # lists of other capacities only look elsewhere first; -all has the two
        # one by one
        units "-DTESS_INT=short -DTESS_LIST=48" "$CC" \
            "-O1 -DTESS_INT=short -DTESS_LIST=48" "brute 100" t_size
        units -DTESS_FLOAT "$CC" "-O1 -DTESS_FLOAT" "t_pred 10" "brute 100"
        return
    fi
    units usual "$CC" "$CFLAGS" t_pred brute t_tess t_part t_size t_natural \
        t_cells
    units -DHH_LIMBS=3 "$CC" "-O1 -DHH_LIMBS=3" "t_pred 50" "brute 100" \
        "t_tess -range" "t_part -quick"
    units -DHH_LIMBS=6 "$CC" "-O1 -DHH_LIMBS=6" "t_tess -range"
    units -DTESS_LIST=48 "$CC" "-O1 -DTESS_LIST=48" "brute 100" "t_tess -quick"
    for list in 52 128 252 1024 4096; do
        units -DTESS_LIST=$list "$CC" "-O1 -DTESS_LIST=$list" "brute 60"
    done
    units -DTESS_FLOAT "$CC" "-O1 -DTESS_FLOAT" "t_pred 50" "brute 100" \
        "t_part -quick"
    units -DTESS_INT=short "$CC" "-O1 -DTESS_INT=short" "brute 100" t_size
    units "-DTESS_INT=short -DTESS_LIST=48" "$CC" \
        "-O1 -DTESS_INT=short -DTESS_LIST=48" "brute 100" t_size
    units -DTESS_INT=long "$CC" "-O1 -DTESS_INT=long" "brute 100" t_size
    if have "$CC" "$ROUND"; then
        units "all rounding modes" "$CC" "$ROUND" "t_pred 10"
    else
        skipped "all rounding modes"
    fi
    if have "$CC" -mfpmath=387; then
        units x87 "$CC" "-O2 -mfpmath=387" "t_pred 10"
    else
        skipped "x87"
    fi
}

# An index serves in other builds and rounding modes than the one that made it.
# indexed NAME CC FLAGS: another build to make and to read them.
indexed() {
    if ! have "$2" "$3"; then
        skipped "indices: $1"
        return
    fi
    made=$((made + 1))
    if compile "$2" "$3" build/indexed $LIBRARY && build indexed/read$made \
        "$CC" "$rounding" build/indexed/*.o test/unit/t_index.c test/points.c \
        test/proof/exact.c && build/indexed/read$made write \
        build/indexed/$made; then
        names="$names $1;"
    else
        fail "indices: $1"
    fi
}

indices() {
    group "indices: " || return
    made=0
    names=
    rounding="-O1 -I."
    have "$CC" "$ROUND" && rounding="$ROUND -I."
    rm -rf build/indexed
    indexed "$CC -O2" "$CC" -O2
    indexed "$CC -Ofast" "$CC" -Ofast
    indexed "x87" "$CC" "-O2 -mfpmath=387"
    indexed "short lists" "$CC" "-O1 -DTESS_LIST=48"
    if [ -n "$ALL" ]; then
        indexed "clang" clang "-O2 -ffp-contract=fast"
        indexed "lists of 128" "$CC" "-O2 -DTESS_LIST=128"
        indexed "10 limbs" "$CC" "-O2 -DHH_LIMBS=10"
    fi
    for i in build/indexed/read*; do
        many "indices: of$names by ${i##*read}" $i build/indexed/[0-9]*
    done
}

# ---- floating-point flags, and the stack ----

# flags NAME LINK OBJECT...: t_flags with that half, or a skipped test
FENV="-std=gnu99 -DTEST_FLAGS -O1 -I."
flags() {
    flagged=$1
    linker=$2
    shift 2
    if $linker -o build/flags/t_flags build/flags/test/*.o "$@" $LIBS >> $LOG 2>&1
    then
        many "flags: $flagged" build/flags/t_flags
    else
        fail "flags: $flagged: does not link"
    fi
}

# flagtest: what is linked to each half; 1 where it cannot be had
flagtest() {
    echo '#include <fenv.h>
int main(void) { return feenableexcept(FE_INVALID) == -1; }' > build/have.c
    $CC $FENV -D_GNU_SOURCE -o build/have build/have.c -lm >> $LOG 2>&1 &&
        build/have && compile "$CC" "$FENV" build/flags/test \
        test/unit/t_flags.c $COMMON
}

flagged() {
    group "flags: " || return
    if ! flagtest; then
        skipped "flags: no fenv.h, or no traps"
        return
    fi
    for c in "$CC -O2" "clang -O2" "$CC -O3" "clang -O3"; do
        case $c$ALL in *-O3) return;; esac
        wanted "flags: $c" || continue
        if ! have "${c% *}" "${c##* }"; then
            skipped "flags: $c"
        elif compile "${c% *}" "${c##* }" build/flags/c $LIBRARY; then
            flags "$c" "$CC" build/flags/c/*.o
        else
            fail "flags: $c: does not compile"
        fi
    done
}

# the FORTRAN half
flagged77() {
    group "flags: FORTRAN 77" || return
    if ! flagtest; then
        skipped "flags: FORTRAN 77: no fenv.h, or no traps"
        return
    fi
    compile "$CC" -O1 build/flags test/fortran/shim.c
    for o in -O2 -O3; do
        [ $o$ALL = -O3 ] && return
        wanted "flags: FORTRAN 77, gfortran $o" || continue
        if gfort build/flags/f $o -ffpe-trap=invalid,zero,overflow \
            >> $LOG 2>&1; then
            flags "FORTRAN 77, gfortran $o" gfortran build/flags/shim.o \
                build/flags/ftess.o build/flags/fhhpred.o
        else
            fail "flags: FORTRAN 77, gfortran $o: does not compile"
        fi
    done
}

# stacktest OPTIONS: t_stack by $CC, and whether this is the machine that the
# manuals' figures are for; 1 where it cannot be had
stacktest() {
    echo '#ifdef __clang__
#error
#endif
int main(void) { return !(__GNUC__ && __x86_64__); }' > build/have.c
    $CC -pthread -o build/have build/have.c >> $LOG 2>&1 && build/have &&
        compile "$CC" "-O2 -pthread -DTEST_STACK $1" build/stack/test \
        test/unit/t_stack.c test/points.c test/proof/exact.c
}

# stack NAME USUAL ANY COMPILER OBJECT...: the figures that a manual has, in KB
# of 1000 bytes, bound what is measured, and are not far above
stack() {
    name="stack: $1: $2 KB, $3 KB"
    usual=$2
    any=$3
    linker=$4
    shift 4
    $linker -pthread -o build/stack/t_stack build/stack/test/*.o "$@" $LIBS \
        >> $LOG 2>&1 && build/stack/t_stack > build/stack.txt
    cat build/stack.txt >> $LOG
    shown "$name" awk -v usual="$usual" -v any="$any" '
        function fits(said, is) {
            return is <= 1000 * said && 1000 * said <= 1.08 * is + 1000
        }
        { print }
        $1 == "most" { good = fits(usual, $2) && fits(any, $3) }
        END { exit !good }' build/stack.txt
}

# stacks FILE: of the manual's table the figures, and what they are for
stacks() {
    sed -n 's/^[ *]*\([^ ].*[^ ]\)  *\([0-9]*\) KB  *\([0-9]*\) KB$/\2 \3 \1/p' $1
}

stacked() {
    group "stack: " || return
    stacks tess.h > build/stacks.txt
    one "stack: tess.h's figures" test "$(wc -l < build/stacks.txt)" -eq 3
    while read -r usual any options; do
        # (of the others -all)
        [ -n "$ALL" ] || [ "$options" = none ] || continue
        [ "$options" = none ] && options=
        if ! stacktest "$options"; then
            skipped "stack: no gcc with threads on x86-64"
            return
        fi
        rm -f build/stack/*.o
        compile "$CC" "-O2 $options" build/stack $LIBRARY
        stack "$CC -O2 $options" $usual $any "$CC" build/stack/*.o
    done < build/stacks.txt
}

stacked77() {
    group "stack: FORTRAN 77" || return
    stacks f77/README > build/stacks.txt
    one "stack: FORTRAN 77: the manual's figures" \
        test "$(wc -l < build/stacks.txt)" -eq 3
    while read -r usual any parameters; do
        [ -n "$ALL" ] || [ "$parameters" = "as they are" ] || continue
        case $parameters in *HHLIM*) options=-DHH_LIMBS=${parameters##* };;
        *) options=;; esac
        if ! stacktest "$options"; then
            skipped "stack: FORTRAN 77: no gcc with threads on x86-64"
            return
        fi
        rm -f build/stack/*.o
        compile "$CC" "-O2 $options" build/stack test/fortran/shim.c
        echo "$parameters" | tr , '\012' |
            sed -n 's/^ *\([A-Z]*\) = \([0-9]*\)$/s,\1 = [0-9]*,\1 = \2,/p' \
            > build/stacks.sed
        for half in tess hhpred; do
            sed -f build/stacks.sed f77/$half.f > build/stack/$half.f
            gfortran -frecursive -O2 -c -o build/stack/f$half.o \
                build/stack/$half.f >> $LOG 2>&1
        done
        stack "FORTRAN 77, gfortran -O2, $parameters" $usual $any gfortran \
            build/stack/*.o
    done < build/stacks.txt
}

sanitizers() {
    if have "$CC" "$SANITIZE"; then
        HARNESS=-O2
        units sanitizers "$CC" "$SANITIZE" "brute 50" "t_tess -quick" \
            "t_part -quick"
        HARNESS=
    else
        skipped "sanitizers"
        units usual "$CC" "$CFLAGS" "t_tess -quick" "t_part -quick"
    fi
}

# ---- the same arrays from every build ----
#
# The test itself and its points are compiled once, so that compilers'
# roundings in making the points do not count.

# same NAME CC FLAGS
same() {
    name="same result: $1"
    wanted "$name" || return
    if ! have "$2" "$3"; then
        skipped "$name"
        return
    fi
    if ! build sums1 "$2" "$3" $SUMS $LIBRARY; then
        fail "$name: does not compile"
        return
    fi
    build/sums1 -sums > build/sums1.txt 2>> $LOG
    one "$name" cmp build/sums.txt build/sums1.txt
}

builds() {
    group "same result: " || return
    usual t_tess
    build/units/usual/t_tess -sums > build/sums.txt
    one "same result: checksums" test -s build/sums.txt
    SUMS=build/units/usual/_t_tess.o
    for f in $COMMON; do
        SUMS="$SUMS build/units/usual/$(basename $f .c).o"
    done
    same "$CC -Ofast -march=native" "$CC" "-Ofast -march=native"
    same "$CC -mfpmath=387" "$CC" "-O2 -mfpmath=387"
    [ -z "$ALL" ] && return
    # at this size a list's bounds are rounded in view of the points
    many "same result: t_tess, a narrow cluster" build/units/usual/t_tess -one lastplaces \
        1500 1
    # what only a processor that takes subnormal numbers for zero brings about
    many "same result: t_tess, subnormal numbers flushed" build/sums1 -quick
    same "$CC -O0" "$CC" "-O0"
    same "$CC -O2" "$CC" "-O2"
    same "$CC -O3 -funroll-loops -ffp-contract=fast -march=native" "$CC" \
        "-O3 -funroll-loops -ffp-contract=fast -march=native"
    same "clang -O2" clang "-O2"
    same "clang -Ofast" clang "-Ofast"
    same "tcc" tcc ""
    # as C++; the objects of C cannot be linked to it
    SUMS="test/unit/t_tess.c $COMMON"
    same "g++ -x c++ -O2" g++ "-x c++ -O2"
}

# ---- the examples: their own checks, and their output as stored ----

# linked FILE: the files of test/examples that a program of them is linked from,
# and libraries, as its first comment says; a recipe itself
linked() {
    case $1 in
    *.c) sed '/\*\/$/q' $1;;
    *) sed '/^[^C]/q' $1;;
    esac | tr ' ' '\012' | egrep '^test/examples/[a-z_]*[.][cf]$|^-l' |
        sort -ru | grep . || echo $1
}

examples() {
    for f in $(grep -l '^int main' test/examples/*.c); do
        example=$(basename $f .c)
        case $example in fortran) continue;; esac # with the FORTRAN half
        wanted "example: $example, its output" || continue
        # shellcheck disable=SC2046 # a list of files
        if build "$example" "$CC" "$CFLAGS -I." build/tess.o build/hhpred.o \
            $(linked $f); then
            (cd build && ./$example $example.obj $example.stl) \
                < test/data/mirror.xyz > build/$example.out 2>> $LOG
            one "example: $example, its code" test $? -eq 0
            one "example: $example, its output" \
                cmp test/examples/$example.out build/$example.out
        else
            fail "example: $example does not compile"
        fi
    done
    # the threads of OpenMP
    group "example: team -fopenmp, " || return
    if have "$CC" -fopenmp; then
        # shellcheck disable=SC2046 # a list of files
        build team "$CC" "$CFLAGS -fopenmp -I." $LIBRARY \
            $(linked test/examples/team.c)
        for threads in 1 2 4; do
            one "example: team -fopenmp, $threads threads" sh -c "
                OMP_NUM_THREADS=$threads build/team |
                    cmp - test/examples/team.out"
        done
    else
        skipped "example: team -fopenmp"
    fi
}

# The recipes: all of them, and nothing but routines, in one program.
# routines PROGRAM MAIN: those files of test/examples that have no main program
routines() {
    for f in test/examples/*.$1; do
        grep "$2" $f > /dev/null || echo $f
    done
}

together() {
    group "recipes: " || return
    recipes=$(routines c '^int main\|^void mexFunction')
    if ! have "$CC" "$STRICT -Wmissing-prototypes"; then
        skipped "recipes: $CC does not take the flags"
        return
    fi
    H=test/examples/recipes.h
    rm -rf build/recipes build/recipes1
    # the prototypes of recipes.h are those of the recipes, and all of them
    # shellcheck disable=SC2086
    compile "$CC" "$STRICT -Wmissing-prototypes -I." build/recipes $recipes
    one "recipes: strict C89, as recipes.h declares them" test $? -eq 0
    nm build/recipes/*.o > build/nm.txt
    grep ' [bBdDcCgGsS] ' build/nm.txt > build/data.txt
    cat build/data.txt >> $LOG
    one "recipes: no data but constants" test ! -s build/data.txt
    sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' build/nm.txt | sort > build/defined.txt
    cat build/defined.txt build/names.txt | cut -c1-6 | tr A-Z a-z | sort | uniq -d > build/six.txt
    cat build/six.txt >> $LOG
    one "recipes: unique in six characters" test ! -s build/six.txt
    for f in $recipes; do
        nm -u "build/recipes/$(basename $f .c).o" |
            sed -n 's/^.* U _*\([A-Za-z]\)/\1/p' | sort |
            comm -12 - build/defined.txt | while read -r name; do
                grep "^| .* | \[.*\](${f##*/}) | .* takes .*\`$name\`" \
                    test/examples/README \
                    >> $LOG || echo "$f: $name"
            done
    done > build/calls.txt
    cat build/calls.txt >> $LOG
    one "recipes: what each calls its row in examples/README has" \
        test ! -s build/calls.txt
    for d in -DTESS_INT=short -DTESS_INT=long -DTESS_FLOAT; do
        # shellcheck disable=SC2086
        one "recipes: strict C89 $d" compile "$CC" "$STRICT -Wdouble-promotion \
            -Wmissing-prototypes $d -I." build/recipes1 $recipes
        nm build/recipes1/*.o | sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort \
            > build/other.txt
        one "recipes: no name is the same: $d" sh -c "test -s build/other.txt &&
            ! comm -12 build/defined.txt build/other.txt | grep ."
    done
    # shellcheck disable=SC2086
    one "recipes: -Djoin=my_join" compile "$CC" "$STRICT -Djoin=my_join -I." \
        build/recipes1 $recipes
    one "recipes: my_join, no join" sh -c "nm build/recipes1/*.o |
        grep ' T _*my_join\$' && ! nm build/recipes1/*.o | grep ' T _*join\$'"
    { echo "#include \"$H\""
      echo 'typedef void (*routine)(void);'
      echo 'int main(void) { static const routine all[] = {'
      sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*/(routine)\1,/p' $H
      echo '0}; return all[0] == 0; }'; } > build/together.c
    one "recipes: one program" sh -c "$CC -I. -o build/together \
        build/together.c build/recipes/*.o build/tess.o build/hhpred.o $LIBS &&
        build/together"
    have g++ "-x c++" || return
    # shellcheck disable=SC2086
    one "recipes: C++" compile g++ "-x c++ -Wall -Wextra -Wconversion -Werror \
        -Wmissing-declarations -I." build/recipes $recipes
    one "recipes: one program in C++" sh -c "g++ -I. -o build/together \
        -x c++ build/together.c tess.c hhpred.c -x none build/recipes/*.o $LIBS &&
        build/together"
}

# The READMEs' programs and commands, exactly as printed there, in build/readme,
# where what they need is; what they say is printed is what build/tess proves.
desk() {
    mkdir -p build/readme
    for f in Makefile tess.c tess.h hhpred.c hhpred.h f77 test build; do
        [ -e build/readme/$f ] || ln -s ../../$f build/readme
    done
}

# fenced LANGUAGE: the README's program in it
fenced() { sed -n '/^```'$1'$/,/^```$/p' README.md | sed '/^```/d'; }

# commands WORD [FILE]: lines of four blanks with that word
commands() {
    sed '/^```/,/^```$/d' "${2:-README.md}" | grep '^    [^ ]' | grep "$1"
}

# runs WHAT COMMANDS: what they print is in $PRINTED.  (make has this compiler)
runs() {
    echo "$2" | sed "s|^ *make|make -s 'CC=$CC' 'CFLAGS=$CFLAGS'|" \
        > build/readme/commands
    PRINTED=$( (cd build/readme && grep -q . commands && sh -e commands) \
        2>> $LOG)
    one "the README's $1: its commands" test $? -eq 0
}

# said TEXT [FILE]: the README says that it is printed.  (As words: FORTRAN puts
# blanks before numbers.)
said() {
    file=${2:-README.md}
    # shellcheck disable=SC2086
    set -- $1
    tr '\n' ' ' < $file | grep -q -F -e "rints \`$*\`" -e "rints \`$*'"
}

# reads NAME PROGRAM: it counts lines that are no points, a heading, a number of
# points and another one's line; too many points are said
reads() {
    { echo x,y,z; sed 's/^#/3600/' test/data/mirror.xyz; echo "p 1 2 3"; } \
        > build/readme/others
    told $1 "3600 points, 7 other lines: code 0," $2 build/readme/others
    awk 'BEGIN { while (n++ < 4001) print n, n * n % 97, n * n % 89 }' \
        > build/readme/many
    told $1 "more than" $2 build/readme/many
    sed 1d build/readme/many > build/readme/most
    told $1 "4000 points, 0 other lines: code 0," $2 build/readme/most
}

# told NAME WORDS PROGRAM FILE: fed with the file the program prints these words
told() {
    words=$($3 < $4 2>&1 | tr -s ' \012' ' ')
    one "the README's $1: $2 ($(basename $4))" \
        sh -c 'echo "$1" | grep -F "$2"' sh "$words" "$2"
}

# outside: tess.h's lines on places outside the hull, in a program
outside() {
    {
        echo '#include "tess.h"'
        echo 'int main(void) {'
        echo '  static tess_real p[12] = {0,0,0, 1,0,0, 0,1,0, 0,0,1};'
        echo '  static tess_real q[9] = {0.25,0.25,0.25, 1,1,1, 0,0.5,0};'
        echo '  static double value[4] = {0,4,0,0}, out[3], rw[TESS_LRW(4)];'
        echo '  static tess_int tet[32], adj[32], iw[TESS_LIW(4)], t[3];'
        echo '  tess_int i, ntet, nq = 3;'
        echo '  double outside = -7.0;'
        echo '  int code = tess(4, p, 8, &ntet, tet, adj, TESS_LIW(4), iw,'
        echo '    TESS_LRW(4), rw);'
        sed -n 's/^ \* //;/^    for .* t\[i\] = TESS_NONE/,/^ \*$/p' tess.h |
            sed '/\*/d'
        echo '  return !(code == 1 && out[0] == 1.0 && out[1] == -7.0 &&'
        echo '    out[2] == 0.0); }'
    } > build/outside.c
    one "tess.h's lines on places outside" sh -c "$CC $1 -I. \
        -o build/outside build/outside.c build/tess.o build/hhpred.o $LIBS &&
        build/outside"
}

# meshes: tess.h's two programs, of lengths known when they are compiled and at
# run time: a lattice, and a curve that has more tetrahedra than the first guess
meshes() {
    sed 's/^ \* \{0,1\}//' tess.h > build/manual.txt
    {
        sed -n '/^    #include <stdlib.h>$/,/^    }$/s/^    //p' build/manual.txt
        cat << 'END'
static int proven(tess_int n, const tess_real *x, int code, tess_int least)
{
    static tess_int work[2000];
    tess_int ntet, *t, *a, bad;
    int wrong = mesh(n, x, &ntet, &t, &a) != code || ntet < least ||
                (code == 0 && tess_check(n, x, ntet, t, a, 2 * n, work, &bad));

    free(t);
    free(a);
    return wrong;
}
END
        sed -n '1,/^    }$/s/^    \([^ ].*\|  .*\)/\1/p' build/manual.txt |
            sed 's/ mesh(/ fixed(/'
        cat << 'END'
int main(void)
{
    int i, wrong;

    for (i = 0; i < 1000; i++) {
        p[3 * i] = (tess_real)(i % 10);
        p[3 * i + 1] = (tess_real)(i / 10 % 10);
        p[3 * i + 2] = (tess_real)(i / 100);
    }
    wrong = proven(1000, p, 0, fixed(1000)) || fixed(1000) < 5 * 729 ||
            proven(0, p, TESS_POINT, 0) || proven(8, p, TESS_LINE, 0);
    for (i = 0; i < 100; i++) {
        p[3 * i] = (tess_real)i;
        p[3 * i + 1] = (tess_real)(i * i);
        p[3 * i + 2] = (tess_real)(i * i * i);
    }
    return wrong || proven(100, p, 0, 98 * 97 / 2);
}
END
    } > build/meshes.c
    one "tess.h's programs" sh -c "$CC $1 -I. -o build/meshes build/meshes.c \
        build/tess.o build/hhpred.o $LIBS && ulimit -t 20 && build/meshes"
}

# c_programs: the README's first program, and first.c
c_programs() {
    strict=
    have "$CC" "$STRICT" && strict=$STRICT
    outside "$strict"
    meshes "$strict"
    group "the README's " || return
    desk
    fenced c > build/readme/cube.c
    runs cube.c "$(sed -n 's/^`\(cc [^`]*\)` prints .*/\1/p' README.md)"
    one "the README's cube.c: prints what is said" said "$PRINTED"
    runs first.c "$(commands first | grep -v gfortran)"
    one "the README's first.c: prints what is said" said "$PRINTED"
    reads first.c build/readme/first
}

# f_program: first.f, by the README's command; the README's lines of it.  (Its
# arrays are not on the stack.)
f_program() {
    group "the README's first.f: " || return
    desk
    fenced fortran > build/readme/call
    one "the README's first.f: its lines" sh -c "test -s build/readme/call &&
        ! grep -Fxvf f77/first.f build/readme/call"
    runs first.f "$(commands gfortran; commands "first <" f77/README)"
    one "the README's first.f: prints what is said" said "$PRINTED" f77/README
    one "the README's first.f: the manual's command" \
        test "$(commands "first\.f" f77/README)" = "$(commands gfortran)"
    reads first.f build/readme/first
    sed 's/MAXN = 4000/MAXN = 200000/' f77/first.f > build/large.f
    rm -f build/large
    gfortran -O3 -frecursive -o build/large build/large.f $F77 >> $LOG 2>&1
    awk 'BEGIN { for (srand(1); n++ < 200000;) print rand(), rand(), rand() }' \
        > build/readme/200000
    told first.f "200000 points, 0 other lines: code 0," \
        "small_stack build/large" build/readme/200000
}

# tries: what the README says to try, with a file of such columns
tries() {
    says=$(sed -n 's/.*rints `[^`]*: \(code [^`]*\)`.*/\1/p' README.md)
    if [ ! -x build/tess ]; then
        skipped "the README's commands: no build/tess"
        return
    fi
    count=$(build/tess -check test/data/mirror.xyz 2>> $LOG |
        sed -n 's/^tetrahedra *//p')
    one "the README's first.c: what build/tess proves" \
        test "$says" = "code 0, $count tetrahedra"
    one "the README's times: tess's tetrahedra" \
        grep "^| mirror.xyz | 3600 | $count |" test/results/bench.txt
    group "the README's commands" || return
    desk
    awk 'BEGIN { srand(1); print "lon,lat,depth,hole,t"
        while (n++ < 400) printf "%.3f,%.3f,%d,%d,%.2f\n", 10 + rand(),
            50 + rand(), 500 * rand(), n % 20, 20 * rand() }' \
        > build/readme/mine.csv
    awk 'BEGIN { print "hole,x,y,z,au"
        while (n++ < 16) for (k = 0; k < 25; k++) printf "DH%d,%d,%d,%d,%.2f\n",
            n, n % 4 * 150 + 20, int(n / 4) * 140 - 10, -4 * k, rand() }' \
        > build/readme/holes.csv
    rm -f build/readme/out.* build/readme/blocks.csv build/*.svg build/mirror.xyz.vtk build/mirror.vtk
    runs "commands to try" "$(commands 'make$\|make run\|make grid\|build/tess')"
    # what both of its lines say, of the mirror
    kept=$(echo "$PRINTED" |
        sed -n "s/^tetrahedra *\([0-9]*\) in the alpha shape, of $count\$/\1/p")
    one "the README's commands: the mirror's tetrahedra" sh -c "tr '\n' ' ' \
        < README.md | grep 'have $count tetrahedra;.* keeps the $kept of '"
    for f in mirror.xyz.svg mirror.xyz.vtk mirror.svg mirror.vtk mine.csv.svg \
        mine.csv.vtk readme/out.vtk; do
        one "the README's commands: $f" test -s build/$f
    done
    # the grid's places have values, those in the points' hull numbers
    one "the README's commands: values" \
        grep -a '^POINT_DATA 22500$' build/readme/out.vtk
    one "the README's commands: values in a table" awk -F , '
        NR > 1 && $5 == "nan" { out++ }
        NR > 1 && $5 >= 0 && $5 <= 20 { within++ }
        END { exit !(out && within && out + within == 22500) }' \
        build/readme/out.csv
    fenced text > build/readme/table
    echo "$PRINTED" > build/readme/printed
    one "the README's commands: the table of errors" sh -c "
        test -s build/readme/table &&
        ! grep -Fxvf build/readme/printed build/readme/table"
    # blocks of 10, 10, 5 from 0, 0, -100 on, not one without a value, no two
    # the same, and some left out
    one "the README's commands: a block model" awk -F , '
        NR == 1 { bad = $0 != "x,y,z,au"; next }
        ($1 - 5) % 10 || ($2 - 5) % 10 || ($3 + 97.5) % 5 || $1 < 0 ||
            $1 > 500 || $2 < 0 || $2 > 500 || $3 < -100 || $3 > 0 ||
            !($4 >= 0 && $4 <= 1) || seen[$1, $2, $3]++ { bad = 1 }
        END { exit bad || NR < 100 || NR > 49000 }' build/readme/blocks.csv
    # each command that is printed is one of those above, or below
    commands '' | grep -v 'make$\|make run\|make grid\|build/tess\|gfortran\|first' \
        > build/readme/untested
    one "the README's commands: each is tested" \
        test ! -s build/readme/untested
}

# pip: of $PYTHON, without a network; what NumPy it finds is not looked at
pip() {
    PIP_NO_INDEX=1 PIP_NO_DEPS=1 PIP_DISABLE_PIP_VERSION_CHECK=1 \
        PIP_ROOT_USER_ACTION=ignore CC="$CC" $PYTHON -m pip "$@"
}

# has_pip: can it build tess89?
has_pip() {
    $PYTHON -m pip --version >> $LOG 2>&1 && $PYTHON -c '
import setuptools
assert int(setuptools.__version__.split(".")[0]) > 60
try: import setuptools.command.bdist_wheel
except ImportError: import wheel' 2>> $LOG
}

# snakes: the README's program in Python, and first.py
snakes() {
    if ! wanted "example: first.py" && ! group "the README's Python"; then
        return
    elif ! command -v $PYTHON > /dev/null; then
        skipped "example: first.py: no python3"
        return
    elif ! $CC -shared -fPIC -o build/shared.so hhpred.c $LIBS 2>> $LOG; then
        skipped "example: first.py: no -shared -fPIC"
        return
    fi
    desk
    runs Python "$(grep -o '`make python`' README.md | tr -d '`')"
    one "example: first.py" test "$($PYTHON test/examples/first.py)" = "$says"
    if ! $PYTHON -c 'import numpy' 2>> $LOG; then
        skipped "the README's Python: no numpy for $PYTHON"
        return
    fi
    # where it is installed, or as make python leaves it
    path=test/python
    if has_pip; then
        rm -rf build/readme/python
        path=python
        grep -o '`pip install [^`]*`' README.md | tr -d '`' |
            sed "s|^pip |$PYTHON -m pip |" > build/readme/commands
        one "the README's Python: its commands" sh -c "cd build/readme &&
            test -s commands && CC='$CC' PIP_NO_INDEX=1 PIP_NO_DEPS=1 \
            PIP_ROOT_USER_ACTION=ignore PIP_TARGET=python sh -e commands"
    else
        skipped "the README's Python: no pip with setuptools for $PYTHON"
    fi
    fenced python > build/readme/mine.py
    place=$(sed -n 's/.* f(\[\(.*\)\]).*/\1/p' build/readme/mine.py)
    echo "$place" > build/readme/place
    # what it prints, as its comment says; and what build/tess gives there
    PRINTED=$(cd build/readme && PYTHONDONTWRITEBYTECODE=1 \
        PYTHONPATH=$path $PYTHON mine.py 2>> ../../$LOG)
    one "the README's Python: prints what is said" test -n "$PRINTED" -a \
        "$PRINTED" = "$(sed -n 's/^print.* # //p' build/readme/mine.py)"
    one "the README's Python: what build/tess gives" test "$PRINTED" = \
        "$count [$(build/tess -q -method smooth -query build/readme/place \
        -values - test/data/mirror.xyz | awk -F , '{ v = $4 }
            END { printf "%.3f", v }')]"
}

readme() {
    wanted "tess.h's sizes" && usual t_size
    one "tess.h's sizes" sh -c 'build/units/usual/t_size -bytes |
        grep . > build/bytes.txt && sed "s/^ \*//" tess.h | tr -s "\012 " "  " |
        grep -F "`cat build/bytes.txt`"'
    c_programs
    tries
    snakes
}

# ---- Octave's functions, which leave for NumPy's tests what they give, and
# the Python package ----

tessn() {
    left=
    rm -f build/tessn.mat
    if ! group "example: tessn" && ! group "Python: "; then
        return
    elif ! command -v mkoctfile > /dev/null || ! command -v octave-cli > /dev/null
    then
        skipped "example: tessn.m: no octave-cli with mkoctfile"
    elif make -s "CC=$CC" "CFLAGS=$CFLAGS" octave >> $LOG 2>&1; then
        many "example: tessn.m" octave-cli --norc --no-history \
            test/examples/try_tessn.m
        fenced octave > build/mine.m
        one "the README's Octave: prints what is said" test \
            "$(octave-cli --norc --no-history build/mine.m | tr -d ' \n')" = \
            "v=$(sed -n 's/.* % //p' build/mine.m)"
        [ ! -f build/tessn.mat ] || left=build/tessn.mat
        # (mex.h itself is not C89)
        mex=$(mkoctfile -p OCTINCLUDEDIR)
        one "example: tess_mex.c, strict C89" sh -c "$CC -E -I. -isystem $mex/octave \
            -isystem $mex test/examples/tess_mex.c > build/mex.i &&
            $CC $STRICT -fsyntax-only -x cpp-output build/mex.i"
    else
        fail "example: tessn.m: make octave"
    fi
}

# packed: tess89 is installed from an sdist where no checkout is, and from there
# comes what is tested; $path is where
packed() {
    P=build/python
    elsewhere=$(mktemp -d) || return
    rm -rf $P
    mkdir -p $P/from
    # (a copy, as setuptools leaves files beside what it builds)
    mkdir -p $P/test && cp tess.[ch] hhpred.[ch] LICENSE $P &&
        cp -R test/python test/examples $P/test
    rm -rf $P/test/python/build $P/test/python/*.egg-info \
        $P/test/python/tess89/_library.*
    one "Python: an sdist" sh -c "cd $P/test/python && $PYTHON -c '
import backend
print(backend.build_sdist(\"../../from\"))'"
    cp $P/from/*.tar.gz "$elsewhere" 2>> $LOG
    rm -rf $P/test $P/*.[ch] $P/LICENSE
    one "Python: pip wheel, of the sdist alone" pip wheel \
        -w "$elsewhere" "$elsewhere"/*.tar.gz
    # (of any Python; of this machine)
    one "Python: a wheel for this machine, below 1 MB" sh -c "cd $elsewhere &&
        ls -l tess89-*-py3-none-[!a]*.whl &&
        test \$(cat *-py3-none-[!a]*.whl | wc -c) -lt 1000000"
    one "Python: pip install" pip install --target $P/site "$elsewhere"/*.whl
    rm -rf "$elsewhere"
    path=$P/site
}

tess89() {
    if ! group "Python: "; then
        return
    elif ! $PYTHON -c 'import numpy, scipy' 2>> $LOG; then
        skipped "Python: tess89: no numpy, scipy for $PYTHON"
        return
    fi
    if $PYTHON -m mypy --version >> $LOG 2>&1; then
        one "Python: type hints, by mypy" $PYTHON -m mypy \
            --cache-dir build/mypy test/python/tess89
    else
        skipped "Python: no mypy for $PYTHON"
    fi
    path=
    if has_pip; then
        packed
    else
        skipped "Python: no pip with setuptools for $PYTHON"
    fi
    if [ ! -d "$path/tess89" ]; then
        path=test/python
        if ! make -s "CC=$CC" "CFLAGS=$CFLAGS" build/libtess.so >> $LOG 2>&1
        then
            skipped "Python: tess89: make python"
            return
        fi
    fi
    # shellcheck disable=SC2086
    many "Python: tess89" env PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$path \
        $PYTHON test/python/test_tess89.py $left
}

# ---- the recipes beside CGAL ----

peers() {
    group "beside CGAL: " || return
    if ! echo '#include <CGAL/natural_neighbor_coordinates_3.h>' |
        g++ -x c++ -E - > /dev/null 2>&1; then
        skipped "beside CGAL: not installed"
        return
    fi
    if build beside g++ "-O2 -frounding-math -I." \
        test/bench/peers/recipes.cpp build/tess.o build/hhpred.o \
        build/units/usual/points.o -lmpfr -lgmp; then
        many "beside CGAL: recipes" build/beside
    else
        fail "beside CGAL: recipes: does not compile"
    fi
    if build volumes g++ "-O1 -frounding-math" test/bench/peers/volumes.cpp \
        -lmpfr -lgmp; then
        awk 'BEGIN { for (srand(9); n++ < 900;)
            printf "%.17g %.17g %.17g\n", 2 * rand(), 2 * rand(), 2 * rand() }' \
            > build/cube
        build/tess -q -periodic -box 0,2,0,2,0,2 -volumes build/cube.csv \
            build/cube
        many "beside CGAL: build/tess -periodic -volumes" sh -c \
            'build/volumes 2 < build/cube.csv'
    else
        fail "beside CGAL: build/tess -periodic -volumes: does not compile"
    fi
}

# ---- points spread over processes ----

processes() {
    wanted MPI || return
    if ! command -v mpicc > /dev/null ||
        ! mpirun --version 2> /dev/null | grep "Open MPI" > /dev/null; then
        skipped "MPI: no Open MPI"
        return
    fi
    # (mpi.h itself has long long)
    mesh=
    for f in mesh split halo stars output mail; do
        mesh="$mesh test/mpi/$f.c"
    done
    # shellcheck disable=SC2086
    if build mesh mpicc "$STRICT -Wno-long-long -O2" $mesh test/points.c \
        $LIBRARY && build same "$CC" "$STRICT -O2" test/mpi/same.c \
        test/points.c $LIBRARY; then
        many "MPI" sh test/mpi/check.sh
    else
        fail "MPI: does not compile"
    fi
}

# ---- the FORTRAN 77 half: ANSI X3.9-1978 and nothing more ----

# TSBLD, TESSIX and TESSQU cut their workspace up into arrays, and what a mesh
# and a search keep is handed over in parts; a query hands over one array twice,
# that nobody alters.  The standard allows to hand over an array element for an
# array, and to alter the arrays, as they are declared in their lengths and do
# not overlap; that they do not ftnchek cannot know.  So two of its warnings are
# off, and with them on it may complain of those calls alone.
F77="f77/tess.f f77/hhpred.f"
CHEK="ftnchek -f77=all -declare -sixchar"
CHEKS="$CHEK -array=no-dimensions -usage=no-arg-array-alias"

standard() {
    one "ftnchek: no line past column 72" \
        sh -c '! grep -n "^.\{73\}" f77/*.f test/*/*.f'
    one "constants: those of the tables in the heads" sh test/fortran/constants.sh
    group "ftnchek: " || return
    if ! command -v ftnchek > /dev/null; then
        skipped "ftnchek: not installed"
        return
    fi
    $CHEKS $F77 > build/ftnchek.txt 2>&1
    cat build/ftnchek.txt >> $LOG
    one "ftnchek: both files read" test \
        "$(grep -c '^ 0 syntax errors detected' build/ftnchek.txt)" -eq 2
    one "ftnchek: no warning" sh -c '! grep -i warning build/ftnchek.txt'
    $CHEK $F77 > build/ftnchek.txt 2>&1
    egrep -i warning build/ftnchek.txt |
        egrep -v 'argument arrayness mismatch' | egrep -v \
        'Subprogram (HHPROD|TSSFFI|TSAPEX|TSINDE|TSMCYS|TSMESH) argument usage' |
        egrep -v 'Subprogram (TSPICK|TSBBOX|TSEXIT|TSBLD) argument usage' |
        egrep -v 'Subprogram (TSRECS|TSQUER|TSINCT|TSTHRO) argument usage' \
        > build/ftnwarn.txt
    one "ftnchek: warnings of parts of arrays alone" test ! -s build/ftnwarn.txt
    cat build/ftnwarn.txt >> $LOG
    for f in test/fortran/*.f test/examples/*.f f77/first.f; do
        # shellcheck disable=SC2046 # lists of files
        case $f in
        */parity.f) $CHEKS $F77 $f;; # it calls all entries
        */parts.f) $CHEKS -noextern $(linked $f);; # and OpenMP
        *) $CHEKS -library $F77 $(linked $f);;
        esac > build/ftnchek.txt 2>&1
        one "ftnchek: $f" sh -c '! grep -i warning build/ftnchek.txt'
    done
    # shellcheck disable=SC2046 # a list of files
    $CHEKS -library $F77 $(routines f '^      PROGRAM') > build/ftnchek.txt 2>&1
    one "ftnchek: the recipes together" sh -c \
        '! grep -i warning build/ftnchek.txt'
}

# The table of both names in the header of each file: all routines of C, and
# all of the file, in their order, but for those that only one half has.
# twins NAME ONLY-IN-C ONLY-IN-FORTRAN
twins() {
    sed -n '/The routines of/,/^C$/p' f77/$1.f | sed '/Only in C/,$d;s/^C//' |
        tr -cs 'a-zA-Z0-9_' '\012' |
        awk '/^[A-Z][A-Z0-9]+$/ && last ~ /^[a-z_0-9]+$/ {
            print last, $0 }
            { last = $0 }' > build/twins.txt
    sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*[^;]$/\1/p' $1.c |
        egrep -v "^($2)$" > build/cnames.txt
    sed -n 's/^      [A-Z ]*\(FUNCTION\|SUBROUTINE\) \([A-Z0-9]*\).*/\2/p' \
        f77/$1.f | egrep -v "^($3)$" > build/fnames.txt
    awk '$1 !~ /^(frexp|ldexp)$/ { print $1 }' build/twins.txt |
        diff build/cnames.txt - > build/diff.txt &&
        awk '{ print $2 }' build/twins.txt | diff build/fnames.txt - \
            > build/diff.txt
    one "both names in the header of f77/$1.f" test $? -eq 0
    cat build/diff.txt >> $LOG
}

# The entries: the heads in tess.f and hhpred.f, those of the module for
# Fortran 90, those that the manual describes, its list of them, and what
# hhpred.h and tess.h declare for callers.
entries() {
    # the public ones of hhpred.f, by hhpred.h's names cut to six characters
    sed '/---- for tess/,$d' hhpred.h |
        sed -n 's/^TESS_API [a-z_ ]* [*]*hh_\([a-z]*\)(.*/hh\1/p' | cut -c1-6 |
        sort > build/hh.txt
    # calls FILE: each name with its arguments, in small letters
    calls() {
        awk '/^     [^ ]/ { text = text substr($0, 7); next }
            { print text; text = $0 }
            END { print text }' $1 | tr A-Z a-z | tr -d ' &' |
            sed -n 's/.*\(subroutine\|function\)\(\(tess\|hh\)[a-z]*(.*)\)$/\2/p'
    }
    for f in $F77; do calls $f; done | sort > build/heads.txt
    { grep '^tess' build/heads.txt
      while read name; do grep "^$name(" build/heads.txt; done < build/hh.txt
    } | sort > build/entries.txt
    sed 's/(.*//' build/entries.txt | sort > build/list.txt
    one "entries: tess.f has those of tess.h" sh -c \
        "test \`grep -c '^tess' build/list.txt\` -eq \
        \`grep -c '^TESS_API [a-z]* tess[_a-z]*(' tess.h\`"
    one "entries: hhpred.f has those of hhpred.h" sh -c \
        "grep '^hh' build/list.txt | cmp - build/hh.txt && test -s build/hh.txt"
    # a line that ends in & goes on
    sed -e ':more' -e '/&$/{N;s/&\n *//;b more' -e '}' f77/tess.f90 |
        grep -v 'end \(function\|subroutine\)' > build/module.txt
    calls build/module.txt | sort > build/module2.txt
    one "entries: the module's are tess.f's, with the same arguments" \
        diff build/entries.txt build/module2.txt
    sed -n '/^    routine/,/^Arrays/s/^    \([A-Z ,]*\)  .*/\1/p
        /^    routine/,/^Arrays/s/^    \([A-Z, ]*\)$/\1/p' f77/README |
        tr -cs A-Z '\012' | tr A-Z a-z | grep . | sort > build/manual.txt
    one "entries: the manual's list" diff build/list.txt build/manual.txt
    sed -n 's/^      [A-Z ]*\(SUBROUTINE\|FUNCTION\) \([A-Z]*\)(.*/\2/p' \
        f77/README | tr A-Z a-z | sort > build/manual.txt
    one "entries: the manual's descriptions" diff build/list.txt build/manual.txt
    sed -n 's/^      [A-Z ]*\(SUBROUTINE\|FUNCTION\) \([A-Z0-9]*\).*/\2/p' \
        $F77 | tr A-Z a-z | sort | comm -23 - build/list.txt > build/own.txt
    tr -cs A-Z '\012' < f77/README | tr A-Z a-z | sort -u |
        comm -12 - build/own.txt > build/named.txt
    cat build/named.txt >> $LOG
    one "f77/README names no routine of the library's own" sh -c \
        'test -s build/own.txt && ! grep . build/named.txt'
    one "f77/README is what the sources say" sh -c \
        'sh test/fortran/manual.sh | cmp - f77/README'
}

# ---- the same results as the C half ----

# few limbs: the same codes 2 and 6 as from C
fewlimbs() {
    for half in tess hhpred; do
        sed 's/HHLIM = 88/HHLIM = 3/;s/HHL088/HHL003/' f77/$half.f > build/few$half.f
        gfortran -frecursive -O1 -c -o build/f$half.o build/few$half.f || return
    done
}

# half COMPILE...: what compiles the half; it does when a test first asks for it,
# by compiled
half() {
    HALF=$*
    HALFS=
}
compiled() {
    [ -n "$HALFS" ] && return
    echo "== FORTRAN 77: $HALF" >> $LOG
    rm -f build/ftess.o build/fhhpred.o
    $HALF >> $LOG 2>&1 || return
    HALFS=yes
}

# fortran NAME OPTIONS TESTS COMPILE...: the unit tests with the half in the
# place of the C half, by way of shim.c
fortran() {
    tag=$1
    options=$2
    echo "$3" | tr , '\012' > build/list
    shift 3
    half "$@"
    here=build/units/f77
    rm -rf $here
    while read -r t; do
        wanted "FORTRAN 77, $tag: $t" || continue
        program=${t%% *}
        if compiled && { [ -f $here/shim.o ] || compile "$CC" "-O1 $options" \
            $here $COMMON test/fortran/shim.c; } &&
            $CC -O1 $options -I. -c -o $here/_$program.o test/unit/$program.c \
            >> $LOG 2>&1 && $LINKF -o $here/$program $here/_$program.o \
            $here/[!_]*.o build/ftess.o build/fhhpred.o $LIBF $LIBS \
            >> $LOG 2>&1; then
            many "FORTRAN 77, $tag: $t" $here/$t
        else
            fail "FORTRAN 77, $tag: $t: does not compile"
        fi
    done < build/list
}

# text NAME: link the Fortran program with the half, and compare its text with
# the C program's, as parity has left it.
text() {
    wanted "parity: $1" || return
    rm -f build/parityf
    if compiled && $LINKF -o build/parityf build/fparity.o build/ftess.o build/fhhpred.o \
        $LIBF $LIBS >> $LOG 2>&1
    then
        build/parityf > build/parityf.txt
        shown "parity: $1" diff build/parity.txt build/parityf.txt
    else
        fail "parity: $1: does not link"
    fi
}

# threads NAME: link the half with a program of several threads.
# Local arrays must be on the stack: -frecursive, f2c -a.
OMP_NUM_THREADS=4
export OMP_NUM_THREADS
threads() {
    wanted "threads: $1" || return
    if ! have "$CC" -fopenmp; then
        skipped "threads: $1: no OpenMP"
        return
    fi
    rm -f build/threads
    compiled
    compile "$CC" -O1 build/units/f77 test/points.c
    $CC $CFLAGS -fopenmp -c -o build/threads.o test/fortran/threads.c
    $LINKF -fopenmp -o build/threads build/threads.o build/units/f77/points.o \
        build/ftess.o build/fhhpred.o $LIBF $LIBS >> $LOG 2>&1
    many "threads: $1" build/threads
}

# FORTRAN programs that tell by their text whether all is well.
# programs NAME FLAGS: with the half
programs() {
    for f in $(grep -l '^      PROGRAM' test/fortran/sizes.f test/examples/*.f)
    do
        case $f in */parts.f) continue;; esac # below
        wanted "$f, $1" || continue
        compiled
        rm -f build/program
        # shellcheck disable=SC2046 # a list of files
        gfortran -frecursive $2 -o build/program $(linked $f) build/ftess.o \
            build/fhhpred.o $LIBS >> $LOG 2>&1
        case $f in
        test/examples/*)
            build/program > build/program.txt
            one "$f, $1" cmp "${f%f}out" build/program.txt;;
        *) many "$f, $1" build/program;;
        esac
    done
}

# onef NAME LIBRARIES COMPILE...: all recipes, and the half
onef() {
    name=$1
    wanted "recipes: one program, $name" || return
    compiled
    libraries=$2
    shift 2
    rm -rf build/recipesf
    mkdir build/recipesf
    { for f in $(routines f '^      PROGRAM'); do cat $f; done
      printf '      PROGRAM ALL\n      END\n'; } > build/recipesf/all.f
    one "recipes: one program, $name" sh -c "cd build/recipesf && $* &&
        $LINKF -o all all.o ../ftess.o ../fhhpred.o $libraries $LIBS && ./all"
}

# recipes77 NAME FLAGS CFLAGS: the tests in C of recipes, of those in FORTRAN:
# fortran/recipes.c is linked
recipes77() {
    group "recipes in FORTRAN, $1: " || return
    compiled
    dir=build/recipes77
    less=-quick
    [ -n "$ALL" ] && [ -z "$3" ] && less=
    rm -rf $dir
    mkdir -p $dir
    for r in cells derived interp natural periodic planar slopes surface; do
        gfortran -frecursive $2 -c -o $dir/f$r.o test/examples/$r.f >> $LOG 2>&1
        # (what is const in C is so in none of these)
        gfortran $2 -fsyntax-only -fc-prototypes-external test/examples/$r.f |
            sed -n '/ \*/s/\(int\|long\|double\) \*/const &/gp' |
            grep '_ (' >> $dir/recipes77.h
    done
    compile "$CC" "-O1 -I. -I$dir -Werror=incompatible-pointer-types $3" $dir \
        $LIBRARY test/points.c test/proof/exact.c test/fortran/recipes.c
    have "$CC" "$STRICT" && one "recipes in FORTRAN, $1: strict C89" \
        $CC $STRICT $3 -fsyntax-only -I. -I$dir test/fortran/recipes.c
    for t in unit/t_cells unit/t_natural examples/try_cells \
        examples/try_derived examples/try_interp examples/try_periodic \
        examples/try_planar examples/try_slopes examples/try_surface; do
        f=test/$t.c
        t=${t#*/}
        wanted "recipes in FORTRAN, $1: $t" || continue
        $CC -O1 -DFORTRAN $3 -I. -c -o $dir/_$t.o $f >> $LOG 2>&1 &&
            gfortran -o $dir/$t $dir/_$t.o $dir/[!_]*.o build/ftess.o \
                build/fhhpred.o $LIBS >> $LOG 2>&1
        case $t in
        t_*) many "recipes in FORTRAN, $1: $t" $dir/$t $less;;
        *)
            (cd $dir && GFORTRAN_UNBUFFERED_ALL=y limited 300 ./$t $t.obj \
                $t.stl) > $dir/$t.txt 2>> $LOG
            one "recipes in FORTRAN, $1: $t" cmp test/examples/$t.out $dir/$t.txt;;
        esac
    done
}

# small_stack COMMAND...: in the eight megabytes that are usual
small_stack() {
    # shellcheck disable=SC3045 # all shells that there are know -s
    (ulimit -s 8192; exec "$@")
}

# interface NAME FLAGS: the module for Fortran 90, and that with it wrong calls
# do not compile; f77/README's program
interface() {
    group "interfaces, $1" || group "f77/README's program, $1" || return
    compiled
    (cd build && gfortran -std=f95 -pedantic -Wall -Wextra -Werror $2 -c \
        -o module.o ../f77/tess.f90) >> $LOG 2>&1
    module="-cpp -Ibuild -Jbuild $2"
    if gfortran -std=f2018 -pedantic $module -o build/iface \
        test/fortran/iface.f90 build/ftess.o build/fhhpred.o $LIBS >> $LOG 2>&1
    then
        many "interfaces, $1" build/iface
    else
        fail "interfaces, $1: do not compile"
    fi
    # each synopsis of the manual is FORTRAN and declares all arguments
    awk '/^-----/ { at = 1; next } at && /^$/ { print "      END"; at = 0 }
        at { print }' f77/README > build/synopses.f
    one "f77/README's synopses, $1" sh -c "gfortran -std=f95 -pedantic $2 \
        -fimplicit-none -fsyntax-only build/synopses.f &&
        test \$(grep -c '^      END' build/synopses.f) -eq \
        \$(wc -l < build/list.txt)"
    for wrong in $(sed -n 's/.* WRONG == \([0-9]*\)$/\1/p' \
        test/fortran/iface.f90); do
        one "interfaces, $1: wrong call $wrong" sh -c "! gfortran $module \
            -DWRONG=$wrong -c -o build/module.o test/fortran/iface.f90"
    done
    awk '/^      PROGRAM PLACE/,/^      END$/' f77/README > build/grid.f
    rm -f build/grid
    gfortran $2 -o build/grid build/grid.f build/ftess.o build/fhhpred.o \
        $LIBS >> $LOG 2>&1
    one "f77/README's program, $1" test "$(build/grid)" = " 14.5000"
    # the other one takes slices of 1500; in one there are as many
    awk '/^      PROGRAM SLICES/,/^      END$/' f77/README > build/slices.f
    sed 's/ROOM = 1500/ROOM = MAXTET/' build/slices.f > build/whole.f
    for f in slices whole; do
        rm -f build/$f
        gfortran $2 -o build/$f build/$f.f build/ftess.o build/fhhpred.o \
            $LIBS >> $LOG 2>&1
        build/$f > build/$f.txt 2>> $LOG
    done
    one "f77/README's program of slices, $1" sh -c "
        awk '{ for (all = \$1; n < all - 1500;) print n += 1500, 1
            print all, \$5 }' build/whole.txt > build/slices1.txt &&
        grep 1500 build/slices1.txt &&
        awk '{ print \$1, \$5 }' build/slices.txt | cmp - build/slices1.txt"
    # where DOUBLE PRECISION has not 64 bits INFO says so; coordinates of all
    # bits
    sed 's/P(\([123]\),I) = .*/P(\1,I) = ABS(MOD(1D4*SIN(DBLE(\1*I)), 1D0))/
        s/ STOP .TESS.*/ WRITE (*, *) INFO/' build/grid.f > build/wide.f
    for wide in "-fdefault-real-8 -fdefault-double-8" -fdefault-real-8 \
        -freal-8-real-10; do
        rm -f build/wide
        # shellcheck disable=SC2086
        gfortran $2 -frecursive $wide -o build/wide build/wide.f $F77 $LIBS \
            >> $LOG 2>&1
        case $wide in *double*) code=;; *) code=6;; esac
        one "f77/README's program, $1 $wide" test \
            "$(build/wide 2>> $LOG | sed -n 's/^ *\(6\) *$/\1/p')" = "$code"
    done
    # (its arrays are not on the stack)
    sed 's/(N = 1000)/(N = 200000)/' build/grid.f > build/large.f
    rm -f build/grid
    gfortran $2 -frecursive -o build/grid build/large.f build/ftess.o \
        build/fhhpred.o $LIBS >> $LOG 2>&1
    one "f77/README's program, $1, 200,000 points" \
        test "$(small_stack build/grid)" = " 14.5000"
}

# mixed: a C program that calls the FORTRAN half, and the reverse
mixed() {
    group "example: fortran" || group "example: tess_c" || return
    compiled
    one "example: fortran.c" sh -c "$CC -O2 -c -o build/mixed.o \
        test/examples/fortran.c &&
        gfortran -o build/mixed build/mixed.o build/ftess.o build/fhhpred.o &&
        build/mixed | cmp - test/examples/fortran.out"
    compile "$CC" "$CFLAGS" build $LIBRARY
    module="-std=f2003 -Wall -Wextra -Jbuild test/examples/tess_c.f90"
    one "example: fortran.f90" sh -c "gfortran $module -o build/mixed \
        test/examples/fortran.f90 build/tess.o build/hhpred.o $LIBS &&
        build/mixed | cmp - test/examples/fortran.out"
    # all routines of the headers, with as many arguments
    for f in hhpred.h tess.h; do
        sed '/---- for tess/,$d' $f
    done | awk '/^TESS_API/ { text = "" } { text = text $0 }
        text ~ /^TESS_API.*;$/ {
            name = text
            sub(/\(.*/, "", name)
            sub(/.*[ *]/, "", name)
            many = text ~ /\(void\)/ ? 0 : gsub(/,/, "", text) + 1
            print name, many
            text = ""
        }' | sort > build/wanted.txt
    sed -e ':more' -e '/&$/{N;s/&\n *//;b more' -e '}' \
        test/examples/tess_c.f90 | awk '/^    .* function .*bind\(c\)/ {
            name = text = $0
            sub(/\(([^(]*)\) *bind.*/, "", name)
            sub(/.* /, "", name)
            sub(/.* function [a-z_]*\(/, "", text)
            sub(/\).*/, "", text)
            many = text == "" ? 0 : gsub(/,/, "", text) + 1
            print name, many
        }' | sort > build/bound.txt
    one "example: tess_c.f90: all routines of the headers" sh -c \
        "test -s build/wanted.txt && diff build/wanted.txt build/bound.txt"
    if gfortran $module -o build/module test/fortran/module.f90 build/tess.o \
        build/hhpred.o $LIBS >> $LOG 2>&1; then
        many "example: tess_c.f90" build/module
    else
        fail "example: tess_c.f90: does not compile"
    fi
}

# parity.c and parity.f write the same text, compared byte by byte.  parity.txt
# has the sums of its sections, so that a machine without Fortran compares, too;
# of a section that differs the text is shown.  The sums are not believed: the
# first program proves each answer by exact.c, and knows the code of each bad
# argument and fault from the interface.  (When the library's own figures change,
# as the lengths of the workspace: sh test/fortran/sums.sh build/parity.txt >
# test/fortran/parity.txt.)
parity() {
    group "parity: " || return
    if build parity "$CC" "$CFLAGS -DPROVE" test/fortran/parity.c \
        test/proof/*.c $LIBRARY; then
        build/parity > build/parity.txt 2> build/prove.txt
        cat build/prove.txt >> $LOG
        one "parity: proofs" grep '^prove: [0-9]* passed, 0 failed' \
            build/prove.txt
        one "parity: no code but the promised one" \
            sh -c 'test -s build/parity.txt && ! grep WRONG build/parity.txt'
        shown "parity: the sums as stored" sh test/fortran/sums.sh \
            build/parity.txt test/fortran/parity.txt
        # (a line of one section changed: that section is shown, and no other)
        sed '/^= cube .* 9$/,/^= /s/^TESSHU  /TESSHU 1/' build/parity.txt \
            > build/parity1.txt
        one "parity: a line changed" sh -c '! sh test/fortran/sums.sh \
            build/parity1.txt test/fortran/parity.txt > build/sums.txt &&
            test "`grep "^= " build/sums.txt`" = "`grep "^= cube .* 9$" \
            build/parity.txt`" && grep "^TESSHU 1" build/sums.txt'
    else
        fail "parity: parity.c does not compile"
    fi
    # (what makes infinities and NaNs must not be compiled with -Ofast)
    $CC $CFLAGS -c -o build/parity.o test/fortran/parity.c
    [ -z "$ALL" ] && return
    for c in "$CC -O0" "$CC -Ofast -march=native" "clang -Ofast" "tcc"; do
        set -- $c
        cc=$1
        shift
        if have $cc "$*"; then
            build parity1 $cc "$*" build/parity.o $LIBRARY
            build/parity1 > build/parity1.txt
            shown "parity: $c" diff build/parity.txt build/parity1.txt
        else
            skipped "parity: $c"
        fi
    done
}

halves() {
    LINKF=gfortran
    LIBF=
    if ! command -v gfortran > /dev/null; then
        skipped "the FORTRAN 77 half and its examples: no gfortran"
    else
        # (values that must be the same are compared)
        group "parity: " && gfortran -std=legacy -frecursive -O1 -fcheck=all -Wall -Wextra -Werror \
            -Wno-compare-reals -Wno-do-subscript -c -o build/fparity.o \
            test/fortran/parity.f >> $LOG 2>&1
        # (so many points have cylinders on several levels)
        quick="t_pred 20,brute 50,t_tess -quick,t_tess -one ellipsoid 6000 1"
        quick="$quick,t_part -quick"
        fortran "gfortran -fcheck=all" "" "$quick" gfort build/f -O1 -fcheck=all
        text "gfortran -fcheck=all"
        programs "gfortran -fcheck=all" "-std=legacy -O1 -fcheck=all"
        onef gfortran "" "gfortran -frecursive -std=f95 -pedantic -Wall -Wextra \
            -Werror -Wno-compare-reals -Wno-do-subscript -c all.f"
        recipes77 "gfortran -fcheck=all" "-std=legacy -O1 -fcheck=all" ""
        interface "gfortran -fcheck=all"
        mixed
        f_program
        flagged77
        stacked77
    fi
    [ -z "$ALL" ] && return
    if command -v gfortran > /dev/null; then
        # (what the tests ask for with subscripts checked is not asked again)
        fortran "gfortran -O0" "" "brute 50" gfort build/f -O0
        text "gfortran -O0"
        fortran "gfortran -O3" "" "brute,t_tess -quick,t_part -quick" gfort build/f -O3
        text "gfortran -O3"
        threads "gfortran -O3"
        half gfort build/f -Ofast -march=native
        text "gfortran -Ofast -march=native"
        # (a subscript may be right for the array that a caller has passed on)
        LIBF=-fsanitize=address
        half gfort build/f -O1 -fsanitize=address
        text "gfortran -fsanitize=address"
        LIBF=
        # integers of 8 bytes
        fortran "INTEGER*8" -DTESS_INT=long "t_pred 10,brute 50" gfort build/f \
            -O2 -fdefault-integer-8
        programs "INTEGER*8" "-std=legacy -fdefault-integer-8"
        recipes77 "INTEGER*8" "-std=legacy -fdefault-integer-8" -DTESS_INT=long
        interface "INTEGER*8" -fdefault-integer-8
        fortran "gfortran, 3 limbs" -DHH_LIMBS=3 \
            "t_pred 10,brute 100,t_tess -range,t_part -quick" fewlimbs
        for omp in "" -fopenmp; do
            wanted "example: parts.f $omp" || continue
            rm -f build/partsf
            # shellcheck disable=SC2046 # a list of files
            gfortran -O2 -frecursive $omp -o build/partsf \
                $(linked test/examples/parts.f) $F77 >> $LOG 2>&1
            build/partsf > build/partsf.out 2>> $LOG
            one "example: parts.f $omp" cmp test/examples/parts.out \
                build/partsf.out
        done
    fi
    if command -v f2c > /dev/null; then
        LINKF=$CC
        LIBF=-lf2c
        fortran "f2c" "" "t_pred 20,brute 50,t_tess -quick" viaf2c build/f \
            test/fortran/parity.f
        text "f2c"
        threads "f2c"
        # the manual's command, where the C half is
        rm -rf build/beside
        mkdir build/beside
        cp $LIBRARY $F77 build/beside
        one "f77/README's f2c" sh -c "(cd build/beside &&
            `sed -n 's/^    \(mkdir c .*f2c .*\)/\1/p' f77/README`) &&
            cmp tess.c build/beside/tess.c && test -s build/beside/c/hhpred.c"
        onef f2c -lf2c "f2c -A -a -u all.f && $CC -O1 -c all.c"
    else
        skipped "the FORTRAN 77 half through f2c: no f2c"
    fi
}

# ---- the same results on other machines, simulated ----

# cross COMPILER EMULATOR MACHINE
cross() {
    name="same result: $3"
    wanted "$name" || return
    if command -v $1 > /dev/null && command -v $2 > /dev/null; then
        if build cross $1 "-O2 -static" test/fortran/parity.c $LIBRARY; then
            $2 build/cross > build/cross.txt 2>> $LOG
            shown "$name" diff build/parity.txt build/cross.txt
        else
            fail "$name: does not compile"
        fi
    else
        skipped "$name: no $1 with $2"
    fi
}

# avr NAME FLAGS FILE: compile for an ATmega1284P, and run; what it writes to
# build/avr.txt
avr() {
    wanted "$1" || return
    if ! build avr.elf avr-gcc "-std=gnu89 -mmcu=atmega1284p $2" $3 $LIBRARY
    then
        fail "$1: does not compile"
        return 1
    fi
    limited 100 simavr -m atmega1284p -f 16000000 build/avr.elf 2>&1 |
        sed -n 's/[^ -~]\[[0-9]*m//g; s/\.$//p' > build/avr.txt
}

machines() {
    cross powerpc64-linux-gnu-gcc qemu-ppc64 "big-endian (PowerPC)"
    cross arm-linux-gnueabihf-gcc qemu-arm "32-bit ARM"
    cross i686-linux-gnu-gcc qemu-i386 "x87"
    cross m68k-linux-gnu-gcc qemu-m68k "big-endian with an 80-bit unit (68k)"
    # WebAssembly, without a C library but for what run.js has
    if command -v wasm-ld > /dev/null && command -v node > /dev/null &&
        command -v clang > /dev/null; then
        for d in -DTESS_FLOAT ""; do
            # shellcheck disable=SC2086 # lists of flags, of files
            one "same result: wasm32 $d" sh -c "$CC -O2 $d -o build/tiny \
                test/machines/tiny.c $LIBRARY $LIBS &&
                build/tiny > build/tiny.txt &&
                $WASM $d -o build/tiny.wasm test/machines/tiny.c $LIBRARY &&
                node test/machines/wasm/run.js build/tiny.wasm |
                    cmp - build/tiny.txt"
        done
    else
        skipped "wasm32: no clang with wasm-ld (lld) and node"
    fi
    # int of 16 bits and double of 24, in 16 kilobytes of memory: once indices of
    # 16 bits and -Os, once of 32 bits and -O2.  (A difference may be the
    # simulator's: simavr 1.6 takes an adiw or sbiw by 12 to 15, modulo 16, that
    # is to be skipped for two words.)
    if ! command -v avr-gcc > /dev/null || ! command -v simavr > /dev/null; then
        skipped "AVR: no avr-gcc with simavr"
        return
    fi
    build tiny "$CC" "-O2 -DTESS_FLOAT" test/machines/tiny.c $LIBRARY &&
        build/tiny > build/tiny.txt
    # each line begins with the code 0
    one "same result: AVR: 4 sets" test \
        "$(grep -c '^0 1 0' build/tiny.txt)" -eq 4
    avr "same result: AVR" "-Os -DTESS_INT=short -DTESS_LIST=64" \
        test/machines/tiny.c &&
        one "same result: AVR" cmp build/tiny.txt build/avr.txt
    avr "example: sensor, AVR" "-O2 -DTESS_LIST=64 -ffunction-sections \
        -Wl,--gc-sections -I." test/examples/sensor.c &&
        one "example: sensor, AVR" cmp test/examples/sensor.out build/avr.txt
}

# ---- two halves, neither of which needs what the other one builds ----

# parts NAME...: these functions in turn; the log says what each one took, in
# seconds of processors
parts() {
    for p in "$@"; do
        # (in a subshell they would be its own)
        times > $OUT.times
        $p
        times >> $OUT.times
        tr 'ms' '  ' < $OUT.times | awk -v part="$p" '
            { for (i = 1; i < NF; i += 2) t[++n] = 60 * $i + $(i + 1) }
            END { printf "== %s took %.1f s\n", part,
                t[5] + t[6] + t[7] + t[8] - t[1] - t[2] - t[3] - t[4] }' >> $LOG
    done
}
rules() { many "rules" sh test/rules.sh; }
packages() { many "packages" env CC="$CC" sh test/package.sh; }
driver() { many "the driver" env CC="$CC" sh test/program/driver.sh; }
files() { many "the driver: files" env CC="$CC" sh test/program/files.sh; }
outputs() {
    many "the driver: outputs" env CC="$CC" sh test/program/outputs.sh
}
values() { many "the driver: values" env CC="$CC" sh test/program/values.sh; }
# the certificates of the search, with builds of their own
certificates() { many "certify" env CC="$CC" sh test/hunts/certify.sh -check; }
# hard sets in hard circumstances, likewise
hard() { many "torture" env CC="$CC" sh test/hunts/torture.sh -check; }
# the facts of the paper's Section 4
paper() {
    many "the paper's experiments" env CC="$CC" CFLAGS="$CFLAGS" \
        sh test/paper/paper.sh -check
}
all_twins() {
    twins tess "point" \
        "TSPDIS|TSLINE|TSONSP|TSWORK|TSMESH|TSINDE|TSQUER|TSORIQ|TSORIP|TSFOOT"
    twins hhpred \
        "points_held|all_zero|raise_coordinates|lesser_of|five_points" \
        "HHKIND|HHV500|HHL088"
}

first_half() {
    parts itself language symbols tests flagged stacked builds indices \
        examples together readme tessn tess89 rules packages driver files \
        outputs values
    [ -z "$ALL" ] && return
    parts peers processes certificates
}

second_half() {
    parts sanitizers standard all_twins entries parity halves
    [ -z "$ALL" ] && return
    parts machines hard paper
}

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
        begin second
        second_half
        counts > build/counts
    ) > $HALF/out 2>&1 &
    trap 'kill $! 2> /dev/null; exit 1' INT TERM
    first_half
    wait $!
    cat $HALF/out
    cat $HALF/$LOG >> $LOG
    if read -r passed failed missing < $HALF/build/counts; then
        count "$passed" "$failed" "$missing"
    else
        fail "the second half: stopped"
    fi
else
    first_half
    second_half
fi
rm -f $OUT*

counts > build/counts
read -r passed failed missing < build/counts
echo "$passed passed, $failed failed, $missing skipped"
if [ "$((passed + failed + missing))" -eq 0 ]; then
    echo "no test has '$ONLY' in its name"
    exit 1
fi
test "$failed" -eq 0
