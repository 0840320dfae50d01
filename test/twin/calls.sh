#!/bin/sh
# calls.sh - are the twins called as often?  Counts, by gcov, the calls of each
# routine of both halves while they do the same: what parity.c asks
# for, and t_tess of some families; of FORTRAN by way of shim.c.  A routine called more
# often than its twin belongs to a half that searches or decides more than it
# need.
#
#     sh test/twin/calls.sh [TREE]    the files of the library that are in
#                                        TREE in the place of those here
#
# Twins that are one call in one half and several in the other, or written out
# there, are not compared.  How often each is called is in build/calls/all.txt.
# Takes CC (gcc's, for gcov); run from the top directory.
. test/tests.sh
GCOV=${GCOV:-gcov}
DIR=build/calls
ALONE="bad_argument boxes_disjoint connect_edges cube_root dot drop_stages
full_precision hh_finite hh_holds lay_out leaf_count marked_height open_index
place_in_four prepare_points rounded_height set_zeros start_stages
surface_record workspace_lengths write_header"
MARGIN=${MARGIN:-0}
FAMILIES=${FAMILIES:-latlon ellipsoid rotcube near6 hub crowd tracks uvsphere
    sheets16 gradedrot}
rm -rf $DIR
mkdir -p $DIR
cp tess.[ch] hhpred.[ch] f77/*.f $DIR
[ -z "$1" ] || for f in tess.c hhpred.c tess.f hhpred.f; do
    [ ! -f "$1/$f" ] || cp "$1/$f" $DIR
done
for f in twin/parity twin/shim unit/t_tess unit/lib/result unit/lib/guard \
    lib/points lib/exact lib/verify; do
    $CC -I. -c -o "$DIR/$(basename $f).o" test/$f.c || exit
done
for f in tess hhpred; do
    sh test/twin/names.sh $f $DIR | sed "s/^/$f /"
done > $DIR/twins.txt
cd $DIR || exit
TESTS="t_tess.o result.o guard.o points.o exact.o verify.o"

# ran LANGUAGE SET PROGRAM ARGUMENT...: lines SET LANGUAGE FILE ROUTINE CALLS
ran() {
    language=$1
    set=$2
    shift 2
    limited 60 "$@" > out || return
    for f in tess hhpred; do
        $GCOV -b -o $f.o $f.$language > /dev/null || return
        awk -v s="$set $language $f" '$1 == "function" && $3 == "called" {
            sub(/(_[0-9]+L_[0-9]+|_)$/, "", $2) # see HH_AS
            print s, toupper($2), $4 }' $f.$language.gcov
    done >> calls.txt
    rm -f ./*.gcda
}
# half LANGUAGE SHIM COMPILER FLAGS
half() {
    language=$1
    shim=$2
    shift 2
    for f in tess hhpred; do
        "$@" -O0 -ffp-contract=off --coverage -c -o $f.o $f.$language || return
    done
    $1 --coverage -o parity parity.o $shim tess.o hhpred.o -lm &&
        $1 --coverage -o t_tess $TESTS $shim tess.o hhpred.o -lm &&
        ran $language parity ./parity || return
    for family in $FAMILIES; do
        ran $language $family ./t_tess -one $family 600 1 || return
    done
}
half c "" "$CC" && half f shim.o gfortran -w -frecursive \
    -ffixed-line-length-none || exit
# shellcheck disable=SC2086 # a line
awk -v alone=" $(echo $ALONE) " -v margin="$MARGIN" '
    FILENAME == "calls.txt" { calls[$1, $2, $3, $4] = $5; sets[$1]; next }
    {
        for (s in sets) {
            c = calls[s, "c", $1, toupper($2)]
            f = calls[s, "f", $1, $3]
            print s, $2, c + 0, $3, f + 0 > "all.txt"
            if (c == "" || f == "" || index(alone, " " $2 " ")) continue
            n++
            least = c < f ? c : f
            if (c + f - 2 * least > margin * least) {
                print "calls differ: " s, $2, c, $3, f
                bad = 1
            }
        }
    }
    END { exit bad || n < 800 }' calls.txt twins.txt
