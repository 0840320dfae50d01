#!/bin/sh
# counts.sh - what searches look at, beside what they looked at before
#
#     sh test/bench/counts.sh [TREE]   fails where a count of the library in
#                                      TREE, else here, is more than a tenth
#                                      above that of test/results/counts.txt
#     sh test/bench/counts.sh -write   writes that file
#
# Its limits are close, to notice what makes some searches slower; those of
# .ci/stricter hold for sets of all sizes.  Which searches end in which list is
# no cost, and not compared.  Takes CC; run from the top directory.
. test/tests.sh
USUAL=test/results/counts.txt
NEW=build/looks
mkdir -p $NEW
[ "$1" = -write ] || TREE=$1

for source in "${TREE:-.}/tess" "${TREE:-.}/hhpred" test/bench/bench \
    test/bench/parts test/lib/points; do
    $CC -O1 -DTESS_COUNT -I. -c -o "$NEW/$(basename "$source").o" "$source.c" ||
        exit
done
for name in bench parts; do
    $CC -o $NEW/$name $NEW/$name.o $NEW/points.o $NEW/tess.o $NEW/hhpred.o \
        -lm || exit
done

# each: the lines of the counts
each() {
    for set in uniform,20000 lattice,8000 lattice01,1728 latticeshuf,8000 \
        fccturn,4000 cavityi,700 spherei,1000 aniso,5000 clusters,5000 \
        planenoise,5000 planespread,2000 gridrot,1000 gradedrot,1000 \
        gridsph,1000 gridcyl,1000 extruded,2000 spherefull,4000 spherejit,2000 \
        cubesurf,2000 cubegrid,2000 globe,2000 cap,2000 stations,2000 \
        shells,4000 cavity,4000 rotcube,2000 rotcubein,2000 rottet,2000 \
        rottetin,2000 near6,4000 near8,4000 tilted9,2000 tilted15,2000 \
        ellipsoid,4000 bumps,2000 sheets,2000 terrain,2000 survey,2000 \
        horizons,2000 layers,2000 pipes,2000 torus,3000 tracks,2000 \
        boreholes,2000 latlon,1800 latlonkm,1800 latlonm,1800 uvsphere,1800 \
        uvkm,1800 uvm,1800 rings,2000 hub,1000 hubrot,1000 sheets16,2000 \
        sheet16rot,2000 crowd,2000 crowd3,2000 pillar12,3000 masts,3000 \
        towers,3000 sites,3000 box6,20000 plate3,8000 plate6,20000 \
        plate17,4000 bracket6,20000 bar6,2000 bearing6,4000; do
        limited 20 $NEW/bench "${set%,*}" "${set#*,}" 1
    done
    for family in uniform gridrot ellipsoid terrain globe rotcube; do
        limited 20 $NEW/parts $family 2000
    done
}
each 2> /dev/null | grep -v '^tess' > $NEW/all.txt
if [ "$1" = -write ]; then
    cp $NEW/all.txt $USUAL
    exit
fi
awk 'NR == FNR {
        for (i = 4; i < NF; i += 2) now[$1, $2, $3, $i] = $(i + 1)
        next
    }
    {
        for (i = 4; i < NF; i += 2)
            if ($i != "star" && $i != "block" && (!(($1, $2, $3, $i) in now) ||
                now[$1, $2, $3, $i] > 1.1 * $(i + 1) + 0.002)) {
                print "counts are up: " $1, $2, $3, $i, now[$1, $2, $3, $i] + 0,
                    "was", $(i + 1)
                bad = 1
            }
    }
    END { exit bad || FNR < 60 }' $NEW/all.txt $USUAL
