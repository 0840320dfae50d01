#!/bin/sh
# literals.sh - do the twins have the same floating-point numbers?  Compares,
# for each routine of both halves, how often each literal but 0 and 1 stands in
# it, and each constant of the tables in tess.f.  So a factor of an
# error bound that is another one in FORTRAN, where no build proves the bounds,
# does not pass.
#
#     sh test/twin/literals.sh [TREE]    the files of the library that are in
#                                           TREE in the place of those here
#
# ALONE are those that say the same in other words.
TREE=${1:-.}
B=build/literals
ALONE=" offer_point select_rank scale_points sphere_of_facet survey_regions \
ball_by_limbs "
mkdir -p $B
for f in tess.c hhpred.h hhpred.c f77/tess.f f77/hhpred.f; do
    name=${f##*/}
    cp "$f" "$B/$name"
    for g in "$TREE/$f" "$TREE/$name"; do
        [ ! -f "$g" ] || cp "$g" "$B/$name"
    done
done
for f in tess hhpred; do sh test/twin/names.sh $f $B; done > $B/twins.txt
cd $B || exit
# NAME FIELD of the table's constants; TWIN NAME of the routines
number='[-0-9]*[.D][-0-9.D*]*'
sed -n "s/^C       \([A-Z][A-Z0-9]*\)  *= $number \([A-Z][A-Z_0-9]*\) .*/\1 \2/p" \
    tess.f > constants.txt
echo 'EPS EPS
EPS DBL_EPSILON
FEPS FEPS' >> constants.txt
cat > words.awk <<'W'
# words(TEXT): the literals in it, and the words, one a line, to what is in hand
function words(text,  n, w, k, x) {
    gsub(/[^A-Za-z0-9_.+-]/, " ", text)
    gsub(/\.[A-Za-z]+\./, " ", text)
    # a sign is one of an exponent only
    while (match(text, /(^|[ +-])([0-9]+\.?[0-9]*|\.[0-9]+)[eEdD][+-][0-9]+/)) {
        x = substr(text, RSTART, RLENGTH)
        gsub(/[dD]/, "e", x)
        sub(/[eE]\+/, "e", x)
        sub(/[eE]-/, "eM", x)
        text = substr(text, 1, RSTART - 1) " " x " " substr(text, RSTART + RLENGTH)
    }
    gsub(/[+-]/, " ", text)
    n = split(text, w, " ")
    for (k = 1; k <= n; k++) word(w[k])
}
function word(x) {
    if (x ~ /^[0-9.]/) {
        if (x !~ /[.eEdD]/) return
        sub(/[fF]$/, "", x)
        gsub(/[dD]/, "e", x)
        sub(/M/, "-", x)
        if (x + 0 == 0 || x + 0 == 1) return
        print routine, sprintf("%.9g", x + 0)
    } else if (x in constant) print routine, constant[x]
    else if (x in macro) words(macro[x])
}
W
awk "$(cat words.awk)"'
    FILENAME == "constants.txt" { constant[$2] = $1; next }
    FNR == 1 { text = "" }
    { text = text $0 "\n" }
    FILENAME != "hhpred.h" && /^}/ { done() }
    FILENAME == "hhpred.h" && !/\\$/ { done() }
    function done(  m, name) {
        while (match(text, /\/\*([^*]|\*+[^*\/])*\*+\//))
            text = substr(text, 1, RSTART - 1) " " substr(text, RSTART + RLENGTH)
        # what only builds of the tests have
        while (match(text, /(HOLDS|COUNT)\([^;]*;/))
            text = substr(text, 1, RSTART - 1) ";" substr(text, RSTART + RLENGTH)
        if (match(text, /#define HH_[A-Z]+\(/)) {
            name = substr(text, RSTART + 8, RLENGTH - 9)
            macro[name] = substr(text, RSTART + RLENGTH)
        } else if (match(text, /(^|\n)[a-z][^#;{}]*\)\n{\n/)) {
            m = substr(text, RSTART, RLENGTH)
            text = substr(text, RSTART + RLENGTH)
            match(m, /[a-z_0-9]+\(/)
            routine = substr(m, RSTART, RLENGTH - 1)
            print routine, "-"
            words(text)
        }
        text = ""
    }' constants.txt hhpred.h tess.c hhpred.c | sort > c.txt
awk "$(cat words.awk)"'
    FILENAME == "constants.txt" { constant[$1] = $1; next }
    FILENAME == "twins.txt" { twin[$2] = $1; next }
    function ended() {
        if (match(s, /(SUBROUTINE|FUNCTION) +[A-Z0-9]+/)) {
            routine = substr(s, RSTART, RLENGTH)
            sub(/.* /, "", routine)
            routine = routine in twin ? twin[routine] : routine
            print routine, "-"
        } else if (s !~ /^ *(PARAMETER|INTEGER|REAL|DOUBLE PRECISION)/) words(s)
        s = ""
    }
    /^C/ || /^$/ { next }
    !/^     [^ ]/ { ended() }
    { s = s substr($0, 7, 66) }
    END { ended() }' constants.txt twins.txt tess.f hhpred.f | sort > f.txt
awk -v alone="$ALONE" '
    FILENAME == "c.txt" { c[$1 " " $2]++; all[$1 " " $2] }
    FILENAME == "f.txt" { f[$1 " " $2]++; all[$1 " " $2] }
    END {
        for (x in all) {
            split(x, w, " ")
            if (!((w[1] " -") in c) || !((w[1] " -") in f)) continue
            if (index(alone, " " w[1] " ")) continue
            n++
            if (c[x] == f[x]) continue
            print w[1] ": " w[2] " stands " c[x] + 0 " times in C, " \
                f[x] + 0 " in FORTRAN"
            bad = 1
        }
        exit bad || n < 300
    }' c.txt f.txt
