#!/bin/sh
# readme.sh - tests of README.md: its programs and commands, exactly as printed,
# on the data that are there, and its table of times.
#
# Run from the top directory, after `make'.  Ends with `readme: N passed, M
# failed'.  CC and CFLAGS of the environment do not count: what is printed does.
DIR=build/readme
rm -rf $DIR
mkdir -p $DIR
for f in tess.c tess.h hhpred.c hhpred.h f77 test; do
    ln -s ../../$f $DIR
done

# yes NAME COMMAND...: passed when it succeeds
yes() {
    name=$1
    shift
    if "$@" > $DIR/said 2>&1; then
        echo "ok      $name"
    else
        echo "FAILED  $name"
        cat $DIR/said
    fi | tee -a $DIR/results
}

# printed LANGUAGE FILE: the block of that language into FILE, and the two
# commands below it into another; what these write is in $wrote
printed() {
    sed -n '/^```'$1'$/,/^```$/p' README.md | sed '/^```/d' > $DIR/$2
    awk -v first='```'$1 '
        $0 == first { at = 1 }
        at == 1 && $0 == "```" { at = 2; next }
        at == 2 && /^    / { print }
        at == 2 && /^[^ ]/ { exit }' README.md > $DIR/commands
    yes "$2: its two commands" test `wc -l < $DIR/commands` -eq 2
    wrote=`cd $DIR && sh -e commands 2> words`
    yes "$2: nothing on standard error" test ! -s $DIR/words
    set -- "$2" $wrote
    name=$1
    shift
    yes "$name: prints what the README says" grep -F "It prints \`$*\`" README.md
}

printed c first.c
count=`build/tess -check test/data/mirror.xyz | sed -n 's/^tetrahedra *//p'`
yes "first.c: what build/tess proves" test "$wrote" = "code 0, $count tetrahedra"
if command -v gfortran > /dev/null; then
    printed fortran first.f
    yes "first.f: what build/tess proves" \
        test "`echo $wrote`" = "0 $count"
else
    echo "        skipped: first.f: no gfortran"
fi

# The rows of times are what make bench has written.
sed -n '/^## How fast/,/^## Where/p' README.md | grep '^| [a-z].*[0-9]' |
    grep -v '@FIG@' > $DIR/times
while read -r row; do
    yes "times:`echo "$row" | cut -d '|' -f 2,3`" \
        grep -Fx "$row" test/results/bench.txt
done < $DIR/times

failed=`grep -c '^FAILED' $DIR/results`
echo "readme: `grep -c '^ok' $DIR/results` passed, $failed failed"
test $failed -eq 0
