#!/bin/sh
# torture.sh - the hunt: torture.c with many builds of the library, and the
# fuzzers; run from the top directory.
#
#     sh test/fuzz/torture.sh [SECONDS [SEED]]  each build for its share of
#                                                the time by the clock, that of
#                                                compilers included; a short one
#                                                does not reach all builds, and
#                                                the seed tells which is first
#     sh test/fuzz/torture.sh -check            a few sets each: for check.sh
#
# The harness is compiled without optimizations that alter arithmetic, and so
# is each program linked: -Ofast at linking would flush subnormals from the
# start, which torture.c does itself around the calls.  Its comments say how many
# sets there were; the last one, as `torture: N sets, M faults', of all.
. test/tests.sh
begin torture
LIBS=-lm
DIR=build/torture.d
CHECK=
TIME=${1:-600}
if [ "$TIME" = -check ]; then
    CHECK=yes
    TIME=0
fi
SEED=${2:-$(date +%s)}
[ -n "$CHECK" ] && SEED=1
SETS=0
FAULTS=0
BUILDS=18 # with the fuzzer
START=$(date +%s)
TURN=0
FIRST=$((SEED % BUILDS))

mkdir -p $DIR
LOG=$DIR/log
: > $LOG
rm -f $DIR/sums.txt

# left: seconds
left() { echo $((START + TIME - $(date +%s))); }

# share PARTS: that of the time left, at least a second
share() {
    seconds=$(($(left) / $1))
    [ $seconds -gt 0 ] || seconds=1
    echo $seconds
}

# due NAME: is it this build's turn, and is there time?  (The builds are gone
# through twice: from the first one to the last, then those before it.)
due() {
    TURN=$((TURN + 1))
    if [ -z "$CHECK" ]; then
        case $ROUND in
        1) [ $TURN -gt $FIRST ] || return;;
        2) [ $TURN -le $FIRST ] || return;;
        esac
        BUILDS=$((BUILDS - 1))
        if [ "$(left)" -le 0 ]; then
            skip "$1: no time left"
            return 1
        fi
    fi
}

# harness TAG DEFINITIONS: its objects, H says which; compiled once
harness() {
    H=
    for c in fuzz/torture lib/hard lib/verify lib/exact unit/lib/damage \
        unit/lib/guard; do
        f=$(basename $c)
        o=$DIR/$1-$f.o
        H="$H $o"
        [ -f $o ] && [ -z "$(find test tess.h hhpred.h -newer $o -name '*.[ch]')" ] &&
            continue
        # C99's fenv.h where it is to be had
        { [ $f = torture ] && $CC -std=c99 -DTEST_ROUNDING -O1 $2 -c -o $o \
            test/$c.c; } >> $LOG 2>&1 ||
            $CC -O1 $2 -c -o $o test/$c.c >> $LOG 2>&1
    done
}

# in no more than the time that it may take
LIMIT=$((TIME + 200))
# tried NAME PROGRAM...: a test of a program that prints TAP; its sets are counted,
# and its faults
tried() {
    subtest "$@"
    sets=$(sed -n 's/^# \([0-9]*\) sets, .*/\1/p' "$SAID" | tail -n 1)
    bad=$(grep -c '^# fault: ' "$SAID")
    [ -z "$why" ] || [ "$bad" -gt 0 ] || bad=1
    SETS=$((SETS + ${sets:-0}))
    FAULTS=$((FAULTS + bad))
}

# run COMMAND...: its output to $DIR/out, the code in $code
run() {
    echo "== $*" >> $LOG
    limited $LIMIT "$@" > $DIR/out 2>&1
    code=$?
    cat $DIR/out >> $LOG
}

# hunt NAME OPTIONS: the harness $H linked with the library $L
hunt() {
    if ! $LINK -o $DIR/torture $H $L $LIBS >> $LOG 2>&1; then
        fail "$1: does not link"
        return
    fi
    # to see a fault again: the program of each build stays
    file=torture-$(echo "$1" | tr -cs 'a-zA-Z0-9=\n' _)
    mv $DIR/torture $DIR/$file
    if [ -n "$CHECK" ]; then
        few=40
        many=1
    else
        # (as much again is for compilers, results' sums and the last set)
        each=$(share $((2 * BUILDS + 2)))
        few="-time $(((2 * each + 2) / 3)) 1 $SEED"
        many="-time $(((each + 2) / 3)) 1 $SEED"
    fi
    # shellcheck disable=SC2086 # an option, or none; several words
    tried "$1" $DIR/$file $2 $few
    # shellcheck disable=SC2086
    tried "$1, many points" $DIR/$file $2 -many $many
    # with enough limbs all results are the same
    case "$1" in *limbs*|*float*) return;; esac
    [ -n "$CHECK" ] || [ "$(left)" -gt 0 ] || return
    run $DIR/$file $2 -sums $((4 + TIME / 20)) $SEED
    if [ ! -f $DIR/sums.txt ]; then
        mv $DIR/out $DIR/sums.txt
    elif cmp $DIR/out $DIR/sums.txt >> $LOG 2>&1; then
        pass "$1: -sums"
    else
        FAULTS=$((FAULTS + 1))
        fail "$1: -sums differ: $(diff $DIR/out $DIR/sums.txt | head -n 4)"
    fi
}

# c NAME CC FLAGS DEFINITIONS OPTIONS: the C library
c() {
    due "$1" || return
    if ! have $2 "$3"; then
        skip "$1"
        return
    fi
    L=
    for f in tess hhpred; do
        $2 $3 $4 -c -o $DIR/$f.o $f.c >> $LOG 2>&1 || { skip "$1: $f.c"; return; }
        L="$L $DIR/$f.o"
    done
    LINK=$CC
    harness "h$(echo "$4" | tr -cd 'a-zA-Z0-9')" "$4"
    hunt "$1" "$5"
}

# f NAME COMPILE...: the FORTRAN half, by way of shim.c
f() {
    due "$1" || return
    build=$1
    shift
    rm -f $DIR/tess.o $DIR/hhpred.o
    "$@" >> $LOG 2>&1
    $CC -O1 -c -o $DIR/shim.o test/twin/shim.c >> $LOG 2>&1
    L="$DIR/shim.o $DIR/tess.o $DIR/hhpred.o"
    harness h ""
    hunt "$build" ""
}

SAN="-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"

# fuzz NAME FILES...
fuzz() {
    due "$1" || return
    name=$1
    shift
    # truth and proofs take their time: they are left as they are
    harness h ""
    M="$DIR/h-hard.o $DIR/h-verify.o $DIR/h-exact.o"
    D="-DEXACT test/unit/lib/damage.c test/unit/lib/guard.c"
    if [ -z "$CHECK" ] && clang $SAN -fsanitize=fuzzer -o $DIR/$name \
        test/fuzz/$name.c $D tess.c hhpred.c $M $LIBS >> $LOG 2>&1; then
        mkdir -p $DIR/$name.corpus
        run $DIR/$name "-max_total_time=$(share $((BUILDS + 1)))" \
            -timeout=20 -max_len=300 -seed=$SEED -print_final_stats=1 \
            -artifact_prefix=$DIR/$name- $DIR/$name.corpus
        runs=$(sed -n 's/^Done \([0-9]*\) runs.*/\1/p' $DIR/out)
        if [ $code -eq 0 ]; then
            pass "$name, libFuzzer: ${runs:-0} sets"
        else
            FAULTS=$((FAULTS + 1))
            fail "$name, libFuzzer"
            egrep '^# |^SUMMARY|^==.*ERROR|Test unit written' $DIR/out > "$SAID"
            told "$SAID"
        fi
        SETS=$((SETS + ${runs:-0}))
        return
    fi
    [ -z "$CHECK" ] && skip "$name with libFuzzer"
    if have "$CC" "$SAN" && $CC $SAN -DSTANDALONE -o $DIR/$name \
        test/fuzz/$name.c $D tess.c hhpred.c $M $LIBS >> $LOG 2>&1; then
        sets=200
        [ -z "$CHECK" ] && sets=$((200 * $(share $((BUILDS + 1)))))
        tried "$name, sanitizers" $DIR/$name $sets $SEED
    else
        skip "$name, sanitizers"
    fi
}

[ -z "$CHECK" ] && echo "# torture: $TIME s, seed $SEED"

# all: each build
all() {
    TURN=0
    LIBS=-lm
    c "$CC -O2" $CC -O2 "" ""
    c "gcc -Ofast -march=native" gcc "-Ofast -march=native" "" ""
    c "clang -Ofast" clang -Ofast "" ""
    c "x87" $CC "-O2 -mfpmath=387" "" -x87
    c "short lists" $CC "-O1" -DTESS_LIST=48 ""
    c "3 limbs" $CC "-O1" -DHH_LIMBS=3 ""
    c "long" $CC "-O1" -DTESS_INT=long ""
    fuzz fuzz
    if command -v gfortran > /dev/null; then
        LINK=gfortran
        f "gfortran -Ofast" gfort $DIR/ -Ofast
    else
        skip "gfortran"
    fi
    if [ -z "$CHECK" ]; then
        c "clang -O2 -march=native" clang "-O2 -march=native" "" ""
        # without vectors, which would be SSE's: what that unit flushes an x87 unit
        # holds, and no test of one tells of the other
        c "x87 -Ofast" $CC "-Ofast -mfpmath=387 -fno-tree-vectorize" "" -x87
        c "6 limbs" $CC "-O2" -DHH_LIMBS=6 ""
        c "10 limbs" $CC "-Ofast" -DHH_LIMBS=10 ""
        c "float" $CC "-O2" -DTESS_FLOAT ""
        c "float -Ofast" $CC "-Ofast -march=native" -DTESS_FLOAT ""
        if command -v gfortran > /dev/null; then
            LINK=gfortran
            f "gfortran -O0" gfort $DIR/ -O0
            f "gfortran -fcheck=all" gfort $DIR/ -O1 -fcheck=all
        fi
        LINK=$CC
        if command -v f2c > /dev/null; then
            LIBS="-lf2c -lm"
            f "f2c" viaf2c $DIR/
        else
            skip "f2c"
        fi
    fi
}

for ROUND in 1 2; do
    all
    [ -z "$CHECK" ] || break
done

ended
code=$?
echo "# torture: $SETS sets, $FAULTS faults"
[ $code -eq 0 ] && [ $FAULTS -eq 0 ]
