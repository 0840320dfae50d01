#!/bin/sh
# certify.sh - certify.c with builds of tess.c that prove its certificates; run
# from the top directory.
#
#     sh test/fuzz/certify.sh [SECONDS [SEED [-faces]]]
#                                                each build for its share of
#                                                the time; with -faces on sets
#                                                of the faces of bodies alone
#     sh test/fuzz/certify.sh -check            a few sets each: for check.sh
#     sh test/fuzz/certify.sh -quick            fewer, with one build alone
#
# Every second build has low thresholds (lowered, in tests.sh).  The harness is
# compiled without optimizations that alter arithmetic.
. test/tests.sh
begin certify
DIR=build/certify.d
CHECK=
TIME=${1:-600}
case $TIME in -check | -quick) CHECK=$TIME;; esac
SEED=${2:-$(date +%s)}
SETS=$3
MANY=40 # sets of each build
[ -n "$CHECK" ] && SEED=60 # 86: a base that is complete, and all about it
[ "$CHECK" = -quick ] && SEED=86 && MANY=8
BUILDS=14 # about, for the shares

rm -rf $DIR
for tree in usual low; do
    mkdir -p $DIR/$tree/test/lib
    cp tess.c tess.h hhpred.h $DIR/$tree
    cp test/lib/watch.h $DIR/$tree/test/lib
done
lowered tess.c > $DIR/low/tess.c || fail "tess.c lacks a threshold of LOW"
[ -n "$CHECK" ] || LIMIT=$((TIME + 300))

# both NAME CC FLAGS DEFINITIONS: the library so compiled, in both trees
both() {
    if ! have "$2" "$3"; then
        skip "$1"
        return
    fi
    # (but for tess.c both trees are the same)
    rm -f $DIR/*.o
    $2 $3 $4 -DTESS_PROVE -c -o $DIR/hhpred.o hhpred.c
    for f in test/lib/hard.c test/lib/exact.c; do
        $CC -O1 $4 -c -o "$DIR/$(basename $f .c).o" $f
    done
    # C99's fenv.h where it is to be had
    $CC -std=c99 -DTEST_ROUNDING -O1 $4 -c -o $DIR/certify.o \
        test/fuzz/certify.c 2> /dev/null ||
        $CC -O1 $4 -c -o $DIR/certify.o test/fuzz/certify.c
    for tree in usual low; do
        t=$DIR/$tree
        rm -f $t/$1
        $2 $3 $4 -DTESS_PROVE -c -o $t/tess.o $t/tess.c
        $CC -O1 $4 -o $t/$1 $t/tess.o $DIR/*.o -lm
        if [ -n "$CHECK" ]; then
            subtest "$1, $tree" $t/$1 $MANY $SEED
        else
            # shellcheck disable=SC2086 # an option, or none
            subtest "$1, $tree" $t/$1 $SETS -time $((TIME / BUILDS + 1)) 1 $SEED
        fi
    done
}

if [ "$CHECK" = -quick ]; then
    both O1 "$CC" -O1 ""
    ended
    exit
fi
both O2 $CC -O2 ""
both float $CC -O2 -DTESS_FLOAT
both lists $CC -O1 -DTESS_LIST=48
both x87 $CC "-O2 -mfpmath=387" ""
both gcc_Ofast gcc "-Ofast -march=native" ""
if [ -z "$CHECK" ]; then
    both clang_Ofast clang -Ofast ""
    both limbs $CC -O2 -DHH_LIMBS=3
fi
ended
