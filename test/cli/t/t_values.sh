#!/bin/sh
# t_values.sh - tests of what build/tess interpolates.
#
# Run from the top directory, after `make'.  values.py compares values with
# those of NumPy and SciPy, where $PYTHON (python3) has them; what is here is
# what is refused.  Ends with `values: N passed, M failed'.
# shellcheck disable=SC2034 # of common.sh
NAME=values
. test/cli/t/common.sh

# refuses WORDS OPTIONS...: exit code 2, one line on standard error that says
# WORDS, nothing on standard output, and no file
refuses() {
    words=$1
    shift
    ls > before
    $TESS "$@" < points > said 2> told
    code=$?
    ls > after
    if [ $code -ne 2 ] || [ -s said ] || [ "$(wc -l < told)" -ne 1 ]; then
        fail "not refused, or not in one line: $* (code $code): `cat told`"
    elif ! grep -e "$words" told > /dev/null; then
        fail "$*: not said: $words: `cat told`"
    elif ! cmp -s before after; then
        fail "$*: leaves a file"
    else
        pass "refuses $*"
    fi
}

awk 'BEGIN { srand(3); print "x,y,z,T"
    for (i = 0; i < 200; i++) print rand() "," rand() "," rand() "," i }' \
    > points
cut -d, -f1-3 points > bare
printf '0.5 0.5 0.5\n0.1 nan 0.2\n' > notfinite
printf '0.5 0.5 0.5\n0.1 here 0.2\n' > word
awk '{ print NR % 7, NR * NR % 11, 0, NR }' bare > plane
printf '5 3 2 0\n0 0 0 0 1 7\n1 1 0 0 2 7\n2 0 1 0 3 7\n3 0 0 1 4 7\n4 1 1 1 5 7
' > four.node
printf '0,0,0,a\n1,0,0,b\n0,1,0,\n0,0,1,c\n' > hollow
tail -n +2 four.node | cut -d' ' -f2- > single
awk '{ print $1, $2, $3, $4, NR % 2 }' single > holes
printf '0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n' > four
awk '{ print $1, 2 * $1, 3 * $1, $4 }' plane > line
cut -d, -f1,2 bare > flat
awk 'BEGIN { srand(5); print "x,y,z,T"
    for (i = 0; i < 60; i++)
        if (i < 8) print i % 2 "," int(i / 2) % 2 "," int(i / 4) "," i
        else print rand() "," rand() "," rand() "," i }' > unit
: > empty
: > said; : > told; : > before; : > after
mkdir folder.npy

refuses 'linear, smooth, natural or nearest' -grid 2,2,2 -method cubic \
    -values v.npy points
refuses 'linear, smooth, natural or nearest' -grid 2,2,2 -method '' \
    -values v.npy points
refuses 'linear, smooth, natural or nearest' -validate -method "linear," points
refuses 'choose one -method' -grid 2,2,2 -method linear,smooth -values v.npy \
    points
for grid in 0,2,2 2,-1,2 2,2,2.5 1e99,1,1 99999999999,1,1; do
    refuses 'whole numbers' -grid $grid -values v.npy points
done
refuses 'places are more' -grid 100000,100000,1000 -values v.npy points
for grid in 2 2,2,2,0 2,2,2,0,1 2,2,2,0,1,0,1,0,1,0; do
    refuses 'needs NX,NY,NZ' -grid "$grid" -values v.npy points
done
# ... an axis
for grid in 2,2:3,2 2,0:1:2,2,2 2:3:2 "0:1:2,2," 2,0:1,2 0:1:2,,2; do
    refuses 'two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$' -grid "$grid" \
        -values v.npy points
done
for grid in 0:x:2,2,2 2,0:1:2:3,2 2,0/1:2,2 :,2,2 2,0::2,2; do
    refuses '"[^"]*": not a number' -grid $grid -values v.npy points
done
refuses 'FROM:TO/SIDE$' -grid 0:1/.5,0:1/.5,0:1/.5 -step 1,1,1 -values v.npy points
refuses 'are no blocks of -1' -grid 0:1/-1,0:1/.5,2 -values v.npy points
refuses 'whole numbers from 1' -grid 0:1:1.5,2,2 -values v.npy points
refuses 'Y0 must be less' -grid 2,1:0:2,2 -values v.npy points
refuses 'in space: -grid NX,NY' -plane -grid 2,0:1:2,2 -values v.npy flat
# the same as counts and then ends, and as -step; each axis for itself
for pair in "0:1:3,-1:1:4,.5:.5:1 3,4,1,0,1,-1,1,.5,.5" \
    "0:1/.25,0:1/.5,-1:1/.5 0,1,0,1,-1,1%-step%.25,.5,.5" \
    "0:1:3,0:2:5 3,5,0,1,0,2" "0:1/.25,0:1/.5 0,1,0,1%-step%.25,.5" \
    "0:1:3,2,-1:1/.5 0:1:3,0:1:2,-1:1/.5" "2,0:1/.5,3 0:1:2,0:1/.5,0:1:3"; do
    # shellcheck disable=SC2046 # words
    $TESS -q -grid $(echo "${pair#* }" | tr % ' ') -values old.csv unit 2> words
    $TESS -q -grid "${pair% *}" -values new.csv unit 2> words
    yes "-grid ${pair% *}" cmp new.csv old.csv
done
refuses 'X0 must be less' -grid 2,2,2,1,0,0,1,0,1 -values v.npy points
refuses 'Z0 must be less' -grid 2,2,2,0,1,0,1,.5,.5 -values v.npy points
refuses 'X0 = -1.7e+308 .* choose less' -values v.npy points \
    -grid 3,2,2,-1.7e308,1.7e308,0,1,0,1
refuses "Y1 = 1.7e+308 .* choose less" -grid 2,2,2,0,1,-1.7e308,1.7e308,0,1 \
    -values v.npy points
printf '0 0 1e308 1\n1 0 0 2\n0 1 0 3\n0 0 -1e308 4\n' > far
refuses 'Z0 = -1e+308 .* choose less' -grid 2,2,2 -values v.npy far
refuses 'no values' -grid 2,2,2 -values v.npy bare
refuses 'no values' -validate bare
refuses 'needs -values' -grid 2,2,2 points
refuses 'needs -values' -query bare points
refuses 'needs places' -values v.npy points
refuses 'choose one of them' -grid 2,2,2 -query bare -values v.npy points
# in a plane
refuses 'Y0 must be less' -grid 2,2,0,1,1,0 -values v.npy points
refuses '-scale needs three numbers' -scale 1,2 -validate points
refuses 'is for points in space' -cols x,y -grid 2,2,2 -values v.npy points
refuses '-cols: points in a plane .* add -grid.*or -validate; for points in' \
    -cols x,y points
refuses '-plane: points in a plane .* add -grid.*or -validate$' -plane points
refuses 'in space, not' -alpha 1 -grid 2,2 -values v.npy points
refuses 'there are only 5 points' -plane -validate four.node
refuses 'qcols: column 2 twice' -query flat -qcols 1,2,2 -values v.npy points
refuses 'no values' -plane -validate flat
refuses 'is for -query' -qcols 1,2,3 -grid 2,2,2 -values v.npy points
refuses 'for -values or' -method smooth points
refuses 'for -values or' -outside 0 points
refuses 'for -values or' -clip points
refuses '-by is for -validate' -by x points
refuses '-errors is for -validate' -errors e.csv points
refuses '-by: no column "hole" among 4' -validate -by hole points
refuses 'by: no column "5" among 4' -validate -by 5 points
refuses ':3: column 4: empty' -validate -by 4 hollow
refuses 'no column "7" among 6' -validate -by 7 four.node
refuses 'all points are in one group' -q -validate -by 5 single
refuses 'overwrite the input' -validate -errors points.csv points.csv
refuses 'for -values F.csv$' -digits 3 points
refuses 'for -values F.csv$' -digits 3 -grid 2,2,2 -values v.npy points
refuses 'from 1 to 17' -digits 0 -grid 2,2,2 -values v.csv points
refuses '-outside: .far.: not a number' -outside far -grid 2,2,2 -values v.npy points
refuses 'must end in .csv, .npy, .vtu, .vtk or .svg' -grid 2,2,2 -values v.txt \
    points
refuses 'is for a -grid' -query bare -values v.vtk points
refuses 'is for a -grid' -query bare -values v.svg points
refuses 'is of a slice' -grid 2,2,2 -values v.svg points
refuses 'is of a slice' -grid 1,2,1 -values v.svg points
refuses 'at most 2000 places' -grid 1,2001,9 -values v.svg points
refuses 'No such file' -grid 2,2,2 -values nowhere/v.npy points
refuses 'folder.npy: ' -grid 2,2,2 -values folder.npy points
: > taken.npy
mkdir taken.npy.part
refuses 'taken.npy' -grid 2,2,2 -values taken.npy points
rmdir taken.npy.part
refuses 'name of two outputs' -grid 2,2,2 -values v.npy -values ./v.npy points
refuses 'name of two outputs' -grid 2,2,2 -values - -volumes - points
refuses 'for the table of -validate' -grid 2,2,2 -values - -validate points
refuses 'would overwrite' -query bare.csv -values bare.csv points
refuses 'overwrite the places' -query bare -values v.npy -volumes bare points
refuses 'overwrite the places' -query ./bare.csv -values bare.csv points
refuses 'overwrite the input' -volumes ././points points
refuses 'No such file' -query nowhere -values v.npy points
refuses 'empty: empty' -query empty -values v.npy points
refuses ':2: column 2: .here.: not a number' -query word -values v.npy points
refuses ':2: column 2: .nan.: not a number' -query notfinite -values v.npy points
refuses 'qcols: no column "w"' -query bare -qcols x,y,w -values v.npy points
refuses 'three columns' -query bare -qcols x,y,z,T -values v.npy points
refuses 'both be standard input' -query - -values v.npy
refuses 'both be standard input' -query - -values v.npy -
refuses 'folds, from 2 on' -validate 1 points
refuses 'only 200 points' -validate 201 points
refuses 'knows the hull' -outside nearest -alpha 1 -grid 2,2,2 -values v.npy \
    points
# found when the mesh is there
refuses 'lie on one line' -q -grid 2,2,2 -values v.npy line
refuses 'lie on one line' -q -validate line
refuses 'lie on one line' -q -plane -grid 2,2 -values v.npy line
refuses 'in one plane, where -alpha' -q -alpha 1 -grid 2,2,2 -values v.npy plane
refuses 'no tetrahedron is left; choose more folds' -q -validate 2 four
refuses 'no tetrahedron is left; choose smaller groups' -q -validate 2 -by 5 \
    holes

# a file that cannot be completed is not there; one that was stays as it was
if (trap '' XFSZ; ulimit -f 1000) 2> /dev/null; then
    echo old > full.npy
    (trap '' XFSZ; ulimit -f 100; exec $TESS -q -grid 50,50,50 -values full.npy \
        points) > said 2> told
    code=$?
    if [ $code -eq 2 ] && grep 'full.npy: write error' told > /dev/null &&
        [ "`cat full.npy`" = old ] && [ ! -f full.npy.part ]; then
        pass "a file that cannot be completed"
    else
        fail "a file that cannot be completed: code $code: `cat told`"
    fi
    # gigabytes are announced; and what cannot be written is noticed at once
    for end in csv npy vtk; do
        (trap '' XFSZ; ulimit -f 100; limited 60 $TESS -q -grid \
            1000,1000,200 -values big.$end points) > said 2> told
        code=$?
        if [ $code -eq 2 ] && [ ! -f big.$end ] && grep \
            "big.$end: about [1-9][0-9.]* GB will be written" told > /dev/null &&
            grep "big.$end: write error" told > /dev/null; then
            pass "gigabytes of .$end"
        else
            fail "gigabytes of .$end: code $code: $(cat told)"
        fi
    done
else
    skip "a file that cannot be completed: no ulimit -f"
fi

# ten million places take no memory of their own
# shellcheck disable=SC3045 # where there is no -v it is skipped
if (ulimit -v 20000) 2> told; then
    (ulimit -v 20000; exec $TESS -q -grid 250,200,200 -values ten.npy points \
        ) > said 2> told
    code=$?
    if [ $code -eq 0 ] && [ "$(wc -c < ten.npy)" -eq 80000128 ]; then
        pass "ten million places in 20 MB"
    else
        fail "ten million places in 20 MB: code $code: `cat told`"
    fi
    rm -f ten.npy
    # many of a file; where the first line might be one, but for the number
    awk 'BEGIN { srand(4); for (i = 0; i < 1000000; i++)
        print rand(), rand(), rand() }' > some
    (ulimit -v 32000; exec $TESS -q -query some -values some.npy points) \
        > said 2> told
    code=$?
    (echo 1000000; echo 0 0 0; cat some) > titled.xyz
    $TESS -q -query titled.xyz -values titled.npy points || code=1
    split -l 100000 some piece.
    for piece in piece.a?; do
        $TESS -q -query $piece -values part.npy points
        tail -c +129 part.npy
    done > pieces
    if [ $code -eq 0 ] && cmp -s some.npy titled.npy &&
        tail -c +129 some.npy | cmp -s - pieces; then
        pass "a million places of a file in 32 MB, as their parts"
    else
        fail "a million places of a file in 32 MB: code $code: `cat told`"
    fi
    rm -f some titled.xyz pieces piece.*
else
    skip "ten million places: no ulimit -v"
fi

# places from standard input; no progress where there is no terminal
tail -n +2 bare | $TESS -q -query - -values in.csv points 2> told
if [ "$(wc -l < in.csv)" -eq 201 ] && [ ! -s told ]; then
    pass "-query -: places from standard input"
else
    fail "-query -: `cat told`"
fi
if $TESS -h | awk '/^  -/ && length > 78 { bad = 1 } END { exit bad }'; then
    pass "-h: no long line"
else
    fail "-h: a long line"
fi

rm -f ../mirror.vtk ../mirror.svg
if (cd "$TOP" && make grid CC="$CC") > said 2>&1 &&
    grep 'DIMENSIONS 200 200 20' ../mirror.vtk > /dev/null &&
    grep '</svg>' ../mirror.svg > /dev/null; then
    pass "make grid"
else
    fail "make grid: `tail -n 1 said`"
fi

if $PYTHON -c 'import numpy, scipy' 2> told; then
    library=
    if $CC -O2 -shared -fPIC -I"$TOP" -o recipes.so \
        "$TOP"/tess.c "$TOP"/hhpred.c "$TOP"/test/recipes/slopes.c -lm 2> told
    then
        library=./recipes.so
    else
        skip "the recipes beside build/tess: no -shared -fPIC"
    fi
    lines $PYTHON "$TOP"/test/cli/t/values.py $TESS $library
    lines $PYTHON "$TOP"/test/cli/t/blocks.py $TESS
    lines $PYTHON "$TOP"/test/cli/t/levels.py $TESS "$TOP"/test/data/mirror.xyz
else
    skip "values beside SciPy: no numpy, scipy for $PYTHON"
fi

ended values
