#!/bin/sh
# rules.sh - the rules of test/CONTRIBUTING.md that a machine can check; run
# from the top directory; ALL=yes: shellcheck, too.
. test/tests.sh
ALL=${ALL:-}
begin rules
B=build/rules
mkdir -p $B

# lacking FILE...: of the names in standard input those that are a word in none
# of the files
lacking() {
    cat "$@" | tr -cs 'A-Za-z0-9_' '\n' | sort -u > $B/words
    sort -u | comm -23 - $B/words > $B/out
}

# ---- a routine ----

sed -n 's/^TESS_API [a-z]* \(tess[_a-z]*\)(.*/\1/p' tess.h | sort > $B/public
sed -n 's/^[a-zA-Z_ ]* [*]*\(hh_[a-z]*\)(.*/\1/p' hhpred.h > $B/predicates
# the name in FORTRAN: six letters, but for two
six() { sed 's/_index$/ix/;s/_size$/wk/' | tr -d _ | cut -c1-6; }
test -s $B/public && test -s $B/predicates || echo nothing > $B/none
empty "tess.h and hhpred.h declare routines" $B/none
for h in tess hhpred; do
    list=public
    [ $h = tess ] || list=predicates
    sed -n "s/^#define \([a-z_]*\) .*_AS(.*/\1/p" $h.h > $B/second
    lacking $B/second < $B/$list
    empty "routines: a second name for other types, $h.h" $B/out
done
lacking test/twin/shim.c < $B/public
empty "routines: in shim.c" $B/out
six < $B/public | sed 's/$/_/' > $B/twins
lacking test/twin/f77.h < $B/twins
empty "routines: in f77.h" $B/out
lacking test/twin/parity.c < $B/public
empty "routines: called by parity.c" $B/out
# shellcheck disable=SC2046 # a list of files
lacking $(printf 'test/unit/%s.c ' $MESHES t_part t_query) < $B/public
empty "routines: tested by a program of test/unit" $B/out
{ cat $B/public
  sed '/---- for tess/,$d' hhpred.h | tr -cs a-z_ '\012' | grep '^hh_' |
      grep -Fx -f $B/predicates; } | lacking test/unit/t_flags.c
empty "routines: flags and traps tested by t_flags.c" $B/out
# what is declared ahead: hooks alone, which part II or III defines
for h in tess hhpred; do
    awk '/^\/[*] ---- / { chapter = $3 }
        / \* PART II:/ { behind = 1 }
        /^static [^=]*\(/ { text = $0; name = $0; sub(/\(.*/, "", name)
            sub(/.*[ *]/, "", name); if (behind) defined_[name] }
        text != "" && /;$/ { ahead[name] = chapter; delete defined_[name] }
        /[;{]$/ || /^{/ { text = "" }
        END { for (name in ahead) if (ahead[name] != "hooks:" ||
            !(name in defined_)) print name }' $h.c
done > $B/out
[ "$(grep -c '^static.*;$' tess.c)" -gt 9 ] || echo none > $B/out
empty "routines: ahead of part II hooks alone are declared" $B/out
# the head says how the file is to be read, and no more
sed '/\*\/$/q' tess.c | wc -l | awk '$1 > 180' > $B/out
empty "tess.c: a head of at most 180 lines" $B/out
# what mutation leaves out
for f in tess.c hhpred.c f77/tess.f f77/hhpred.f test/cli/src/*.c \
    test/cli/src/*/*.c; do
    sed "s/^ */${f##*/}: /; s/ *\$//" $f
done | sort -u > $B/lines
grep '^[a-z]*[.][cf]: ' test/fuzz/equivalents | sort -u |
    comm -23 - $B/lines > $B/out
empty "test/fuzz/equivalents: the lines are there" $B/out
# one order everywhere, that of tess.h
sed -n 's/^TESS_API [a-z]* \(tess[_a-z]*\)(.*/\1/p' tess.h > $B/order
six < $B/order | tr a-z A-Z > $B/order77
paste -d ' ' $B/order $B/order77 > $B/pairs
sed -n 's/^| `\(tess[_a-z]*\)` | `\([A-Z]*\)` | [a-z].*/\1 \2/p' README.md |
    diff $B/pairs - > $B/out
sed -n 's/^ [*]   [a-z].*  \(tess[a-z_]*\)$/\1/p' tess.h | diff $B/order - >> $B/out
sed -n 's/^    \(TESS[A-Z]*\)  .*/\1/p' f77/README | diff $B/order77 - >> $B/out
sed -n 's/^      [A-Z ]*\(NE\|ON\) \(TESS[A-Z]*\)(.*/\2/p' f77/README |
    diff $B/order77 - >> $B/out
empty "routines: README, lists and manuals, in the order of tess.h" $B/out

# ---- constants of the library's that a test needs ----

grep '^#define \(BLOCK_REACH\|STAR_REACH\) ' tess.c > $B/words
grep '^#define \(BLOCK_REACH\|STAR_REACH\) ' test/unit/brute.c | diff $B/words - > $B/out
[ "$(wc -l < $B/words)" -eq 2 ] || echo none > $B/out
empty "constants: brute.c's are tess.c's" $B/out

# ---- bounds ----

if command -v $PYTHON > /dev/null; then
    $PYTHON test/bounds/bounds.py -n > $B/words 2>&1
    grep '^wrong: ' $B/words > $B/out
    tail -n 1 $B/words | grep -q ' 0 wrong$' || echo none >> $B/out
    empty "bounds: the constants of bounds are the code's, all of them" $B/out
else
    skip "bounds: no python3"
fi

# ---- a recipe ----

E=test/recipes/README.md
: > $B/out
for f in test/recipes/*.[cf]; do
    name=`basename $f`
    grep "[[/]\`*$name\`*\](\|| \[\`${name%.*}\`\](" $E > /dev/null ||
        echo $name >> $B/out
done
empty "recipes: named in $E" $B/out
: > $B/out
: > $B/routines
# file and names of each row
sed -n 's,^| \(`[^|]*`\) |[^|]*| \[`\([a-z]*\)`\](\2\.c) | .*,\2 \1,p' \
    $E | tr -d '`,' |
    while read -r file names; do
        for name in $names; do
            echo $name >> $B/routines
            grep "^[a-z].* [*]*$name(" test/recipes/$file.c > /dev/null ||
                echo "$name, not in $file.c" >> $B/out
            grep -l '^int main' test/recipes/$file.c >> $B/out
        done
    done
test -s $B/routines || echo none > $B/out
empty "recipes: those of $E are where it says, and routines alone" $B/out
sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*/\1/p' test/recipes/recipes.h \
    > $B/prototypes
sed -n 's/^#define \([a-z_0-9]*\) TESS_AS(\1)$/\1/p' test/recipes/recipes.h \
    > $B/second
sort $B/prototypes > $B/sorted
sort $B/second | diff $B/sorted - > $B/out
empty "recipes: prototypes, and second names for other types" $B/out
# each row's FORTRAN names are subroutines of the file that ends in .f
sed -n 's,^| [^|]* | \([^|]*\) | \[`\([a-z]*\)`\].*,\2 \1,p' $E | tr -d '`,' |
    while read -r file names; do
        for name in $names; do
            grep " \(SUBROUTINE\|FUNCTION\) $name(" test/recipes/$file.f \
                > /dev/null 2>&1 || echo "$name, not in $file.f"
        done
        [ -n "$names" ] || [ ! -f test/recipes/$file.f ] || echo "$file.f"
    done > $B/out
empty "recipes: their names in FORTRAN" $B/out
# a name in FORTRAN: TR and four letters of that in C; of a helper, if another
# routine has these, three and the first of its file.  (FORTRAN alone has for
# tables and the C library's floor, and C alone rounds: the lists are here.)
for f in test/recipes/*.f; do
    r=$(basename $f .f)
    { sh test/twin/names.sh -c test/recipes/$r.c | grep -vx rounded
      case $r in
      derived) echo around;;
      natural) printf 'facet\nweights\n';;
      periodic) echo floor;;
      slopes) echo mark;;
      esac; } | sed "s/^/$r /"
done | awk '{ name = $2; public = sub(/^tr_/, "", name)
        n++; file[n] = $1; open[n] = public
        four[n] = substr(name, 1, 4); times[four[n]]++ }
    END { for (k = 1; k <= n; k++) {
        if (!open[k] && times[four[k]] > 1)
            four[k] = substr(four[k], 1, 3) substr(file[k], 1, 1)
        print file[k], toupper("tr" four[k]) } }' | sort > $B/names
for f in test/recipes/*.f; do
    sh test/twin/names.sh -f $f | sed "s/^/$(basename $f .f) /"
done | sort | diff $B/names - > $B/out
[ "$(wc -l < $B/names)" -gt 80 ] || echo none >> $B/out
empty "recipes: in FORTRAN named after C" $B/out
# a recipe's comment begins with its name and lists its arguments.  (region and
# cut are parts of natural and cells.)
sort -u $B/routines > $B/words
awk '/^\/\* [a-z_0-9]+ - / { name = $2 }
    /^ \* .*\((in|out|in,out)\)/ { if (name) print name; name = "" }
    /^}/ { name = "" }' test/recipes/*.c | sort -u |
    egrep -vx 'region|cut' | comm -23 - $B/words > $B/out
empty "recipes: a row" $B/out

# ---- a file format ----

sed -n 's/^    {".*", .*"\(\.[a-z.]*\)", .*read_.*/\1/p' \
    test/cli/src/read/formats.c |
    tr . '\n' | sed -n 's/./.&/p' |
    sort -u > $B/endings
: > $B/out
test -s $B/endings || echo none > $B/out
while read -r e; do
    grep -E "^[^#]*[' <|]${e#.}[' >|]" test/cli/t/generate.py > /dev/null ||
        echo $e
done < $B/endings >> $B/out
empty "formats: written by generate.py" $B/out

# ---- a family ----

sed -n '/^static const struct/,/^};/p' test/lib/points.c | tr '(' '\n' |
    sed -n 's/^"\([a-z0-9]*\)", .*/\1/p' | sort > $B/families
sed -n 's/^ \*   \([a-z0-9]*\*\{0,1\}\(, [a-z0-9]*\*\{0,1\}\)*\) .*/\1/p' \
    test/lib/points.h > $B/lines
test -s $B/families || echo none > $B/families
lacking $B/lines < $B/families
empty "families: a line in points.h" $B/out

# ---- what the READMEs name ----

grep -Eo "[a-z]+/[a-zA-Z0-9_./]+" test/README | grep -v NAME | sort -u > $B/names
: > $B/out
while read -r name; do
    ls -d test/${name%.}* ${name%.}* ./.${name%.}* > $B/words 2>> $B/unseen
    [ -s $B/words ] || echo $name
done < $B/names > $B/out
[ "$(wc -l < $B/names)" -gt 30 ] || echo none >> $B/out
empty "test/README: files that there are" $B/out
# each file is named in the README of its room, or of the room that this is in;
# in test/README each room.  (Tests are found by their names.)
for d in test/*/; do
    find $d -type f ! -path '*/__pycache__/*' > $B/words
    [ -s $B/words ] || continue
    grep -F "${d#test/}" test/README > /dev/null || echo $d
    ls $d/README* > $B/words 2>> $B/unseen || echo "$d: no README"
done > $B/out
empty "rooms: a README, and a line in test/README" $B/out
# (A package of Python has its own ways.)
find test/* \( -name __pycache__ -o -path test/bindings/python \) -prune -o \
    -type f -print > $B/names
while read -r name; do
    case $name in */README* | */t_* | *.out | test/bounds/*.txt | *.g) continue;; esac
    d=${name%/*}
    while [ ! -f $d/README.md ] && [ ! -f $d/README ]; do d=${d%/*}; done
    stem=${name##*/}
    grep -w -e "${stem%%.*}" $d/README* > $B/words || echo $name
done < $B/names > $B/out
empty "rooms: each file is named in its README" $B/out
# links: files that there are, or headings; and file names between backquotes
: > $B/out
: > $B/unseen
lacking_line() { sort -u | while read -r line; do grep -Fxq -- "$line" "$1" ||
    echo "$line"; done; }
for f in README.md test/*.md test/*/README.md test/*/*/README.md; do
    d=$(dirname $f)
    sed '/^```/,/^```$/d;/^    /d' $f > $B/text
    sed -n 's/^#* //p' $B/text | tr 'A-Z ' 'a-z-' | tr -d ',' > $B/headings
    grep -o '](#[a-z-]*)' $B/text | tr -d ']()#' | lacking_line $B/headings
    grep -o '][(][^#)][^)]*)' $B/text | tr -d ']()' | sort -u > $B/names
    cat $B/names >> $B/unseen
    while read -r name; do
        case $name in http*) ;; *) [ -e "$d/$name" ] || echo "$f: $name";; esac
    done < $B/names
    [ $f = README.md ] || grep -Eo '`[a-z0-9_/.]+[.](c|h|sh|py|f|f90|m|txt|cpp|rows|xyz|svg)`' \
        $B/text | tr -d '`' | sort -u | while read -r name; do
            ls $d/$name $d/*/$name test/$name test/*/$name test/*/*/$name \
                test/*/*/*/$name ./$name f77/$name > $B/words 2> $B/told
            [ -s $B/words ] || case $name in build/*) ;; *) echo "$f: $name";; esac
        done
done >> $B/out
[ "$(wc -l < $B/unseen)" -gt 100 ] || echo none >> $B/out
empty "READMEs: links to what there is" $B/out
# routines that are named there
grep -Eo '`[a-z]+_[a-z_]+`' test/CONTRIBUTING.md | tr -d '`' > $B/names
lacking tess.[ch] hhpred.[ch] test/cli/src/*.[ch] test/cli/src/*/*.[ch] < $B/names
[ "$(wc -l < $B/names)" -gt 5 ] || echo none >> $B/out
empty "CONTRIBUTING.md: routines that there are" $B/out
# one name for a thing: words that are out, of which a machine can tell
cat README.md test/recipes/README.md tess.h f77/README > $B/text
build/tess -h >> $B/text 2> $B/words
egrep -n -i -w "twins?|halves|entry|entries|triangulations?|balls?|tenfold|coincide" \
    $B/text | egrep -v 'On entry|tess_ball|TESSBA|pulling triangulation' > $B/out
empty "READMEs, manuals, -h: no word that has another name" $B/out
# the make targets that both name
grep -o 'make [a-z][a-z]*\(-all\)\{0,1\}[`) ]' README.md test/README |
    sed 's/.*make //;s/.$//' | sort -u > $B/names
sed -n 's/^\([a-z-]*\):.*/\1/p' Makefile | sort -u > $B/targets
comm -23 $B/names $B/targets | grep -vx 'takes' > $B/out
empty "READMEs: targets that there are" $B/out

# ---- the chart of times, which make pictures draws ----

if $PYTHON -c 'import matplotlib' 2> $B/words; then
    $PYTHON test/pictures/speed.py test/results/bench.txt $B/speed.svg
    for f in $B/speed.svg test/pictures/speed.svg; do
        grep -o '>[^<>]*</text' $f > $B/${f%%/*}.texts
    done
    diff $B/build.texts $B/test.texts > $B/out
    [ -s $B/test.texts ] || echo nothing > $B/out
    empty "pictures: speed.svg shows what test/results/bench.txt says" $B/out
else
    skip "pictures: speed.svg: no matplotlib for $PYTHON"
fi

# ---- the README's figures, of test/results ----

R=test/results
tr '\n' ' ' < README.md | tr -s ' ' > $B/joined
# figure WHAT PHRASE: the README says so; what it should say is told.  (Two blanks
# or no digit: no figure.)
figure() {
    case $2 in
    *"  "* | " "*) false;;
    *[0-9]*) grep -F -e "$2" $B/joined > /dev/null;;
    *) false;;
    esac || echo "$2" > $B/out
    empty "README.md, as test/results: $1" $B/out
    : > $B/out
}
: > $B/out
commas() { sed -e :a -e 's/\([0-9]\)\([0-9]\{3\}\)\($\|,\)/\1,\2\3/' -e ta; }

# cell TABLE ROW NUMBER COLUMN: in bench.txt's first table behind a line that
# begins so
cell() {
    awk -F ' *[|] *' -v table="$1" -v name="$2" -v n="$3" -v column="$4" '
        index($0, table) == 1 { at = 1 }
        at && !c { for (i = 2; i < NF; i++) if ($i == column) c = i }
        c && $2 == name && $3 == n { print $c; exit }' $R/bench.txt
}
# row TABLE: of its programs
row() {
    printf '|'
    for p in tess CGAL TetGen Qhull; do
        printf ' %s |' "$(cell "$1" uniform 100000 $p)"
    done
}
figure times "| nanoseconds per tetrahedron $(row 'Nanoseconds of CPU time')"
figure "time and memory" "100,000 random points takes $(
    awk -v n="$(cell 'Nanoseconds of CPU time' uniform 100000 tetrahedra)" \
        -v t="$(cell 'Nanoseconds of CPU time' uniform 100000 tess)" \
        -v m="$(cell 'Bytes per point' uniform 100000 tess)" \
        'BEGIN { printf "%.2f seconds on one processor and %.0f MB besides the points",
            n * t / 1e9, m / 10 }')."
figure memory "| bytes per point $(row 'Bytes per point')"
figure options "C is compiled with \`$(sed -n 's/^Options: \(.*\), FORTRAN .*/\1/p' \
    $R/bench.txt)\`, FORTRAN with \`$(sed -n \
    's/^Options: .*, FORTRAN \(.*\), peers .*/\1/p' $R/bench.txt)\`"
figure "CGAL is ahead" "up to $(awk -F ' *[|] *' '
    /^The same times of data that people have/ { at = 1 }
    at && /^[|] [a-z]*[.a-z]* [|] [0-9]/ && $9 > most { most = $9 } # tess/CGAL
    at && /^The same times of data that lie/ { printf "%.1f", most; exit }
    ' $R/bench.txt) times as fast"
figure threads "Two threads are $(awk -F ' *[|] *' '/^Parts, joined/ { at = 1 }
    at && $2 == "uniform" && $4 == 2 { printf "%.1f", 1 / $7; exit }' $R/bench.txt) times as fast"
figure machine "($(sed -n '/^Machine: /{s/.* processors, //;s/(R)//g
    s/ Processor$//;p;}' $R/bench.txt), gcc $(sed -n 's/^cc .* //p' $R/bench.txt))"
sed -n '/^## How fast/,/^## Limits/p' README.md | grep '^| [a-z].*[0-9]' \
    > $B/rows
test -s $B/rows || echo none > $B/out
lacking_line $R/bench.txt < $B/rows >> $B/out
empty "README.md, as test/results: rows of times" $B/out

# small KEY COLUMN DIVISOR FORMAT: of reach.txt's row that begins so
small() {
    awk -F ' *[|] *' -v key="$1" -v c="$2" -v by="$3" -v form="$4" '
        index($0, key) == 1 { printf form, $c / by; exit }' $R/reach.txt
}
M4='| Cortex-M4 | `-DTESS_FLOAT -DTESS_INT=short -DTESS_LIST=64 -DHH_LIMBS=6` |'
: > $B/out
figure machines "$(sed -n '/^These are /{s/^These are //;s/ ([^()]*)//g;s/, / on /;p;}' \
    $R/reach.txt)"
grep -F '**another**' $R/reach.txt > $B/out
empty "test/results/reach.txt: the same everywhere" $B/out
figure flash "from $(small "$M4" 4 1000 %.0f) KB of flash"
kb=$(small "$M4" 7 1000 %.0f)
figure "small machines" "$(echo "$M4" | sed 's/^| \([^|]*\) | \(.*\) |$/| \1, \2 |/') \
$kb KB | $kb KB | $(small '| 100 |' 5 1000 %.1f) KB | $(small "$M4" 4 1000 %.0f) KB |"
figure "without a mesh" "alone | | | $(small '| 100 |' 8 1000 %.1f) KB | |"
# (the stack is tess.h's, which check.sh measures)
sed -n 's/^ [*]  *\(none\|-D[^ ].*[^ ]\)  *\([0-9]*\) KB  *\([0-9]*\) KB$/\1 | \2 KB | \3 KB |/p' \
    tess.h | sed 's/^\(-[^|]*\) |/`\1` |/;s/^none /no options /' > $B/stacks
test -s $B/stacks || echo none > $B/stacks
while read -r line; do
    figure "stack" "| x86-64, $line $(small '| 100 |' 3 1000 %.1f) KB |"
done < $B/stacks
figure coverage "execute $(awk '$2 == "lines" { ran += $3; all += $5 }
    END { print ran, all }' $R/evidence.txt | tr ' ' '\n' | commas |
    paste -s -d : - | sed "s/:/ of the library's /") lines"
figure bounds "$(awk '/^certify: .* certificates$/ { printf "%.1f", $(NF-1) / 1e6 }
    ' $R/evidence.txt) million bounds"
figure sets "results for $(sed -n 's/^torture: \([0-9]*\) sets, 0 faults$/\1/p' \
    $R/evidence.txt | commas) hard point sets"
figure surveys "of $(sed -n 's/^Surveys, of \([0-9]*\),.*/\1/p' $R/utm.txt) random \
surveys of 100 points in a block 100 m wide, given to the centimetre, scipy's mesh was \
not Delaunay in $(sed -n 's/^| 100 | 0.01 | \([0-9]*\) | 0 |$/\1/p' $R/utm.txt)"

# ---- shell ----

# (with -all: it takes as long as all else here)
if [ -z "$ALL" ]; then
    :
elif command -v shellcheck > /dev/null; then
    shellcheck -S warning -f gcc test/*.sh test/*/*.sh test/*/*/*.sh > $B/out
    empty "shellcheck: no warning" $B/out
else
    skip "shellcheck: not installed"
fi

ended
