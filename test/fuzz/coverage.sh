#!/bin/sh
# coverage.sh - which lines and branches of the library the tests in C run, by
# gcov; run from the top directory (make coverage).
#
#     sh test/fuzz/coverage.sh [-branches]  also lists the branches never taken
#
# Takes CC and GCOV from the environment.  Prints a table, and every line that
# no test has run.  Several builds count together: all limbs; few, as only
# those answer that they do not suffice; lists as short as they may be; and a
# program that sets the processor to take subnormal numbers for zero.
. test/tests.sh
GCOV=${GCOV:-gcov}
DIR=build/coverage

say() { echo "coverage.sh: $1" >&2; exit 1; }

command -v $GCOV > /dev/null || say "no $GCOV: nothing is measured"
rm -rf $DIR
mkdir -p $DIR
have "$CC" --coverage || say "$CC does not take --coverage: nothing is measured"

# ran PROGRAM ARGS...: where gcov's files are
ran() {
    program=./$1
    shift
    $program "$@" > out.txt 2>&1 || say "$program $* fails"
}

# measure NAME FLAGS LINK: the tests built with FLAGS and linked with LINK
measure() {
    mkdir -p $DIR/$1
    cp *.[ch] $DIR/$1
    mkdir -p $DIR/$1/test
    cp -r test/lib test/recipes test/twin test/unit $DIR/$1/test
    (
        cd $DIR/$1
        for f in tess hhpred; do
            $CC -O0 --coverage $2 -c $f.c || say "$f.c does not compile"
        done
        for f in test/lib/exact.c test/lib/points.c test/lib/verify.c $SHARED
        do
            $CC -O2 $2 -I. -c $f || say "$f does not compile"
        done
        ar rc shared.a ./[!th]*.o
        for f in unit/t_pred unit/t_facet unit/brute unit/t_part unit/t_query \
            twin/parity $(printf 'unit/%s ' $MESHES); do
            $CC -O2 $2 -I. -c test/$f.c || say "$f.c does not compile"
            f=${f#*/}
            $CC --coverage $3 -o $f $f.o tess.o hhpred.o shared.a -lm
        done
        case $1 in
        all)
            ran t_pred 20
            ran t_facet 20
            ran brute 100
            for t in $MESHES; do ran $t; done
            ran t_part -quick
            ran t_query -quick
            ran t_tess -one lastplaces 1500 1
            ran parity
            ;;
        few)
            ran t_pred 10
            ran t_facet 10
            ran brute 50
            ran t_range
            ran t_part -quick
            ran t_query -quick
            ;;
        lists)
            ran brute 50
            for t in $MESHES; do ran $t -quick; done
            ;;
        flush)
            ran t_pred 5
            ran t_facet 5
            for t in $MESHES; do ran $t -quick; done
            ;;
        esac
        $GCOV -b -c tess.c hhpred.c > gcov.txt 2>&1 || say "$GCOV fails"
    ) || exit 1
    BUILDS="$BUILDS $1"
}
mkdir -p build
cp tess.h hhpred.h tess.c $DIR
BUILDS=
measure all "" ""
measure few -DHH_LIMBS=3 ""
measure lists -DTESS_LIST=48 ""
measure flush "" -Ofast

# A line has run if it has in one of the builds.
for f in tess hhpred; do
    files=
    for b in $BUILDS; do files="$files $DIR/$b/$f.c.gcov"; done
    # shellcheck disable=SC2086
    awk -v file=$f.c -v branches="$1" '
        /^ *[-#=0-9*]+: *[0-9]+:/ {
            split($0, part, ":")
            at = part[2] + 0
            count = part[1]
            gsub(/ /, "", count)
            if (count != "-") {
                line[at] = 1
                if (count !~ /^[#=]/) ran[at] = 1
            }
            text[at] = substr($0, index($0, ":") + 1)
            if (at > last) last = at
        }
        /^branch / {
            key = at "," $2
            branch[key] = 1
            if ($3 == "taken" && $4 + 0 > 0) taken[key] = 1
            if ($2 > most[at]) most[at] = $2
        }
        END {
            for (i = 1; i <= last; i++) {
                if (!(i in line)) continue
                lines++
                if (i in ran) lran++
                else missed[++n] = text[i]
                for (k = 0; k <= most[i]; k++)
                    if ((i "," k) in branch) {
                        all++
                        if ((i "," k) in taken) took++
                        else never[++m] = "branch " k " of " text[i]
                    }
            }
            printf "%-9s lines %4d of %4d  %5.1f %%", file, lran, lines,
                100 * lran / lines
            printf "   branches %4d of %4d  %5.1f %%\n", took, all,
                100 * took / all
            for (i = 1; i <= n; i++) print "    not run:" missed[i]
            if (branches != "")
                for (i = 1; i <= m; i++) print "    not taken: " never[i]
        }' $files
done
