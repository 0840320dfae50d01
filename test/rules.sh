#!/bin/sh
# rules.sh - the rules of test/README that a machine can check; run from the top
# directory.  Ends with `rules: N passed, N failed'.
. test/tests.sh
begin rules
B=build/rules
mkdir -p $B

# told WHAT FILE: passed when the file is empty; it lists what is missing
told() {
    if [ -s $2 ]; then fail "$1: $(tr '\n' ' ' < $2)"; else pass "$1"; fi
}

# lacking FILE...: of the names in standard input those that are a word in none
# of the files
lacking() {
    cat "$@" | tr -cs 'A-Za-z0-9_' '\n' | sort -u > $B/words
    sort -u | comm -23 - $B/words > $B/out
}

# ---- an entry ----

sed -n 's/^int \(tess[_a-z]*\)(.*/\1/p' tess.h | sort > $B/entries
sed -n 's/^[a-z][a-z_ ]* [*]*\(hh_[a-z]*\)(.*/\1/p' hhpred.h > $B/predicates
# the name in FORTRAN: six letters, but for two
six() { sed 's/_index$/ix/;s/_size$/wk/' | tr -d _ | cut -c1-6; }
test -s $B/entries && test -s $B/predicates || echo nothing > $B/none
told "tess.h and hhpred.h declare entries" $B/none
for h in tess hhpred; do
    list=entries
    [ $h = tess ] || list=predicates
    sed -n "s/^#define \([a-z_]*\) .*TESS_AS(.*/\1/p" $h.h > $B/second
    lacking $B/second < $B/$list
    told "entries: a second name for other types, $h.h" $B/out
    sed '/\*\/$/q' $h.c > $B/head
    lacking $B/head < $B/$list
    told "entries: in the list at the head of $h.c" $B/out
done
lacking test/fortran/shim.c < $B/entries
told "entries: in shim.c" $B/out
six < $B/entries | sed 's/$/_/' > $B/twins
lacking test/fortran/f77.h < $B/twins
told "entries: in f77.h" $B/out
lacking test/fortran/parity.c < $B/entries
told "entries: called by parity.c" $B/out
six < $B/entries | tr a-z A-Z > $B/twins
lacking test/fortran/parity.f < $B/twins
told "entries: called by parity.f" $B/out
lacking test/unit/t_tess.c test/unit/t_part.c < $B/entries
told "entries: tested by t_tess.c or t_part.c" $B/out
sed -n 's/^| `\(tess[_a-z]*\)(.*| `\([A-Z]*\)` |.*/\1 \2/p' README.md > $B/rows
paste -d ' ' $B/entries $B/twins | sort > $B/pairs
sort $B/rows | diff $B/pairs - > $B/out
told "entries: a row of the README, with the twin" $B/out

# ---- a recipe ----

: > $B/out
for f in test/examples/*.*; do
    name=`basename $f`
    case $name in *.out | *.h | try_*) continue;; esac
    # its row, or its name
    grep "\`\(test/examples/\)*$name\`\||\ \`${name%.*}\` |" README.md \
        > /dev/null || echo $name >> $B/out
done
told "examples: named in the README" $B/out
: > $B/out
: > $B/routines
sed -n 's/^| \(`[^|]*`\) | `\([a-z]*\)` |.*/\2 \1/p' README.md | tr -d '`,' |
    while read -r file names; do
        for name in $names; do
            echo $name >> $B/routines
            grep "^[a-z].* [*]*$name(" test/examples/$file.c > /dev/null ||
                echo "$name, not in $file.c" >> $B/out
            grep -l '^int main' test/examples/$file.c >> $B/out
        done
    done
test -s $B/routines || echo none > $B/out
told "recipes: the README's are where it says, and routines alone" $B/out
# (each of them has a second name for other types)
sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*/\1/p' test/examples/recipes.h \
    > $B/prototypes
sed -n 's/^#define \([a-z_0-9]*\) TESS_AS(\1)$/\1/p' test/examples/recipes.h \
    > $B/second
sort $B/prototypes > $B/sorted
sort $B/second | diff $B/sorted - > $B/out
told "recipes: prototypes, and second names for other types" $B/out
# each file of routines alone is there, and each row says what it needs
for f in test/examples/*.c; do
    grep '^int main\|^void mexFunction' $f > /dev/null ||
        awk -F '|' -v name=" \`$(basename $f .c)\` " '$3 == name && $4 ~ /[a-z]/ {
            found = 1 } $3 == name && $4 !~ /[a-z]/ { bad = 1 }
            END { exit bad || !found }' README.md || echo $f
done > $B/out
told "recipes: a row of the README says what each needs" $B/out
# a recipe's comment begins with its name and lists its arguments.  (region and
# cut are parts of natural and cells.)
sort -u $B/routines > $B/words
awk '/^\/\* [a-z_0-9]+ - / { name = $2 }
    /^ \* .*\((in|out|in,out)\)/ { if (name) print name; name = "" }
    /^}/ { name = "" }' test/examples/*.c | sort -u |
    egrep -vx 'region|cut' | comm -23 - $B/words > $B/out
told "recipes: a row of the README" $B/out

# ---- a file format ----

sed -n 's/.*ends_in([^,]*, "\(\.[a-z]*\)").*/\1/p' test/program/read.c |
    sort -u > $B/endings
: > $B/out
test -s $B/endings || echo none > $B/out
while read -r e; do
    grep "^[^#]*[a-z0-9]\\$e" test/program/driver.sh > /dev/null || echo $e
done < $B/endings >> $B/out
told "formats: tested by driver.sh" $B/out

# ---- a family ----

sed -n '/^static const struct/,/^};/p' test/points.c | tr '{' '\n' |
    sed -n 's/^ *"\([a-z0-9]*\)", .*/\1/p' | sort > $B/families
sed -n 's/^ \*   \([a-z0-9]*\*\{0,1\}\(, [a-z0-9]*\*\{0,1\}\)*\) .*/\1/p' test/points.h > $B/lines
test -s $B/families || echo none > $B/families
lacking $B/lines < $B/families
told "families: a line in points.h" $B/out

# ---- what the READMEs name ----

egrep -o '(unit|hunts|program|proof|fortran|machines|bench|mpi|examples|results)/[a-zA-Z0-9_.]+' \
    test/README | grep -v NAME | sort -u > $B/names
: > $B/out
while read -r name; do
    ls -d test/${name%.}* > /dev/null 2>&1 || echo $name
done < $B/names > $B/out
told "test/README: files that there are" $B/out
egrep -o '(test|f77)/[a-zA-Z0-9_./]+[a-z0-9]' README.md | grep -v NAME | sort -u > $B/names
while read -r name; do
    [ -e $name ] || echo $name
done < $B/names > $B/out
told "README.md: files that there are" $B/out
# the make targets that both name
egrep -o 'make [a-z]+(-all)?' README.md test/README | sed 's/.*make //' |
    sort -u > $B/names
sed -n 's/^\([a-z-]*\):.*/\1/p' Makefile | sort -u > $B/targets
comm -23 $B/names $B/targets | grep -vx takes > $B/out
told "READMEs: targets that there are" $B/out

# ---- the chart of times, which make pictures draws ----

if $PYTHON -c 'import matplotlib' 2> $B/words; then
    $PYTHON test/pictures/speed.py test/results/bench.txt $B/speed.svg
    for f in $B/speed.svg test/pictures/speed.svg; do
        grep -o '>[^<>]*</text' $f > $B/${f%%/*}.texts
    done
    diff $B/build.texts $B/test.texts > $B/out
    [ -s $B/test.texts ] || echo nothing > $B/out
    told "pictures: speed.svg shows what test/results/bench.txt says" $B/out
else
    skip "pictures: speed.svg: no matplotlib for $PYTHON"
fi

# ---- shell ----

if command -v shellcheck > /dev/null; then
    shellcheck -S warning -f gcc test/*.sh test/*/*.sh > $B/out
    told "shellcheck: no warning" $B/out
else
    skip "shellcheck: not installed"
fi

ended rules
