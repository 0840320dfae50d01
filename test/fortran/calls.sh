#!/bin/sh
# calls.sh - are the twins called as often?  Counts, by gcov, the calls of each
# routine of both halves while parity.c and parity.f ask for the same; a routine
# called more often than its twin is one that searches or decides more than it
# need.
#
#     sh test/fortran/calls.sh [TREE]    the files of the library that are in
#                                        TREE in the place of those here
#
# Twins that are one call in one half and several in the other, or written out
# there, are not compared.  What is called, and how often, is in
# build/calls/all.txt.  Takes CC (gcc's, for gcov); run from the top directory.
. test/tests.sh
GCOV=${GCOV:-gcov}
DIR=build/calls
ALONE="dot disjoint hh_holds leafcount marked place precise"
rm -rf $DIR
mkdir -p $DIR
cp tess.[ch] hhpred.[ch] f77/*.f $DIR
[ -z "$1" ] || for f in tess.c hhpred.c tess.f hhpred.f; do
    [ ! -f "$1/$f" ] || cp "$1/$f" $DIR
done
$CC -I. -c -o $DIR/parity.c.o test/fortran/parity.c &&
    gfortran -std=legacy -frecursive -c -o $DIR/parity.f.o \
        test/fortran/parity.f || exit
cd $DIR || exit

# half LANGUAGE COMPILER FLAGS: a line FILE ROUTINE CALLS for each routine
half() {
    language=$1
    shift
    for f in tess hhpred; do
        "$@" -O0 -ffp-contract=off --coverage -c -o $f.o $f.$language || return
    done
    $1 --coverage -o parity parity.$language.o tess.o hhpred.o -lm &&
        limited 60 ./parity > parity.txt || return
    for f in tess hhpred; do
        $GCOV -b -o $f.o $f.$language > /dev/null || return
        awk -v f=$f '$1 == "function" && $3 == "called" {
            sub(/(_|_10)$/, "", $2) # hh_centre_10: see HH_LIMBS
            print f, toupper($2), $4 }' $f.$language.gcov
    done > $language.txt
    rm -f ./*.gcda
}
half c "$CC" && half f gfortran -w -frecursive -ffixed-line-length-none || exit
for f in tess hhpred; do
    sed -n '/The routines of/,/^C$/p' $f.f | sed '/Only in C/,$d' |
        tr -cs 'a-zA-Z0-9_' '\012' | awk -v f=$f '
        /^[A-Z][A-Z0-9]+$/ && last ~ /^[a-z_0-9]+$/ { print f, last, $0 }
        { last = $0 }'
done > twins.txt
awk -v alone=" $ALONE " '
    FILENAME != "twins.txt" { calls[FILENAME, $1, $2] = $3; next }
    {
        c = calls["c.txt", $1, toupper($2)]
        f = calls["f.txt", $1, $3]
        print $2, c + 0, $3, f + 0 > "all.txt"
        if (c == "" || f == "" || index(alone, " " $2 " ")) next
        n++
        least = c < f ? c : f
        if (c + f - 2 * least > 0.03 * least + 2) {
            print "calls differ: " $2, c, $3, f
            bad = 1
        }
    }
    END { exit bad || n < 180 }' c.txt f.txt twins.txt
