#!/bin/sh
# constants.sh - are the places and constants of the FORTRAN half, PARAMETERs
# that each routine declares for itself, those of the tables in the comments of
# tess.f and hhpred.f?  A row of a table is
#     C       NAME   = NUMBER FIELD text        or
#     C       NAME   array FIELD text
# where FIELD is the field of a structure in C, perhaps behind the structure that
# it is in, a macro, or - if there is none.
# Checked are:
#   - each PARAMETER of a routine has a row, with the same number, and each row
#     a PARAMETER somewhere; both files have one number for a name
#   - each field of C's structures has a row, and each FIELD is one, or a name
#     of the C half
#   - the places in an array, whose row of its length, LNAME, comes first in the
#     table, or behind a line `In NAME:', do not overlap, and are not beyond it
#   - these arrays have no bare number for a subscript
#
#     sh test/twin/constants.sh [TREE]    files of the library that are in
#                                            TREE in the place of those here
TREE=${1:-.}
B=build/constants
mkdir -p $B
for f in tess.c tess.h hhpred.c hhpred.h f77/tess.f f77/hhpred.f; do
    name=${f##*/}
    cp "$f" "$B/$name"
    for g in "$TREE/$f" "$TREE/$name"; do
        [ ! -f "$g" ] || cp "$g" "$B/$name"
    done
done
# the fields of C's structures, and after them all its words; not those of what
# FORTRAN hands over as arguments
cat $B/tess.c $B/hhpred.h $B/hhpred.c | awk '
    { text = text "\n" $0 }
    END {
        while (match(text, /\/\*([^*]|\*+[^*\/])*\*+\//))
            text = substr(text, 1, RSTART - 1) " " \
                substr(text, RSTART + RLENGTH)
        n = split(text, part, /typedef struct /)
        for (k = 2; k <= n; k++) {
            name = part[k]
            sub(/[^a-z_0-9].*/, "", name)
            body = part[k]
            sub(/^[^{]*{/, "", body)
            sub("\n} " name ";.*", "", body)
            gsub(/\[[^]]*\]/, "", body)
            gsub(/\n#[^\n]*/, "", body)
            # (a chapter'"'"'s own structure in mesher or search)
            gsub(/struct *{/, "", body)
            gsub(/} *[a-z]+ *;/, "", body)
            gsub(/[{}]/, " ; ", body)
            m = split(body, line, /;/)
            for (i = 1; i <= m; i++) {
                gsub(/[*\n]/, " ", line[i])
                sub(/^ *(const )?(struct )?[a-z_]+ /, "", line[i])
                gsub(/[ ]/, "", line[i])
                l = split(line[i], field, /,/)
                for (j = 1; j <= l; j++)
                    if (field[j] ~ /^[a-z]/ && name != "ws_lengths")
                        print field[j], name
            }
        }
    }' | grep -Ev '^(points|lengths) mesher$' > $B/fields.txt
cat $B/*.c $B/*.h | tr -cs 'A-Za-z0-9_' '\012' | sort -u > $B/words.txt
for half in tess hhpred; do
    awk '
    BEGIN { ARRAYS = "[^A-Z0-9](R?CTL|HNT|[IJ]Q|[FG]Q|LSI?D|HEADER|RECORD)" }
    function wrong(what) { print FILENAME ": " what; bad = 1 }
    function ended(  part, k, n, name) {
        gsub(/ /, "", s)
        if (sub(/^PARAMETER\(/, "", s) && sub(/\)$/, "", s)) {
            n = split(s, part, ",")
            for (k = 1; k <= n; k++) {
                name = part[k]
                sub(/=.*/, "", name)
                many++
                used[name]
                if (!(name in is)) wrong(part[k] ", but no row")
                else if (name "=" is[name] != part[k])
                    wrong(part[k] ", but " is[name] " in the table")
            }
        } else if (s !~ /^(INTEGER|DOUBLEPRECISION|REAL)[A-Z]/ &&
            match(" " s, ARRAYS "\\([0-9]+[,)]"))
            wrong("bare subscript: " substr(s, RSTART, RLENGTH - 1))
        s = ""
    }
    # the places FROM ... TO of the array in hand are those of NAME
    function place(name, from, to,  k) {
        for (k = from; k <= to; k++) {
            if (k > is[array] + 0) wrong(name " is beyond " array)
            if ((array, k) in taken) wrong(name " overlaps " taken[array, k])
            taken[array, k] = name
        }
    }
    # a row once all its lines are read
    function row(  name, from, n, w, k) {
        if (text == "") return
        n = split(text, w, " ")
        name = w[1]
        text = ""
        k = w[2] == "array" ? 3 : 4
        sub(/.*\./, "", w[k])
        if (w[2] == "array") { told[w[3]]; return }
        if (name in is && is[name] != w[3]) wrong(name " has two rows")
        is[name] = w[3]
        if (w[4] != "-") told[w[4]]
        if (w[5] == "its" && w[6] ~ /^length/)
            array = name
        else if (array) {
            last = ""
            for (k = 5; k < n; k++)
                if (w[k + 1] ~ /^long/) {
                    last = w[k] in is ? is[w[k]] : w[k]
                    used[w[k]]
                }
            if (w[5] == "behind")
                place(name, w[3] + 1, w[3] + (last ? last : 1))
            else place(name, w[3], w[3] + (last ? last : 1) - 1)
        }
    }
    # the rows first
    FNR == 1 { pass++; row(); array = "" }
    pass == 1 && /^C       [A-Z][A-Z0-9]* +(=|array) / {
        row()
        text = $0
        sub(/^C */, "", text)
        next
    }
    /^C               [^ ]/ && text != "" { text = text substr($0, 16); next }
    pass == 1 {
        row()
        array = /^C     In [A-Z]+:$/ ? "L" substr($2 $3, 3, length($3) - 1) : ""
        next
    }
    /^C/ || /^$/ { next }
    !/^     [^ ]/ { ended() }
    { s = s substr($0, 7) }
    END {
        ended()
        for (name in is) if (!(name in used)) wrong(name " is in no routine")
        for (name in told) print "field", name
        for (name in is) print "number", name, is[name]
        exit bad || many < 100
    }' $B/$half.f $B/$half.f > $B/$half.txt || bad=1
    grep ': ' $B/$half.txt
done
# one number for a name in both; the fields and macros, in either
cat $B/tess.txt $B/hhpred.txt | grep -v : | sort -u |
    awk -v fields=$B/fields.txt -v words=$B/words.txt '
    function wrong(what) { print "tables: " what; bad = 1 }
    $1 == "field" { told[$2] }
    $1 == "number" {
        if ($2 in is) wrong($2 " is two numbers")
        is[$2]
    }
    END {
        while ((getline < words) > 0) word[$1]
        while ((getline < fields) > 0) field[$1] = field[$1] " " $2
        for (name in told) {
            if (name ~ /^[a-z]/ && !(name in field))
                wrong(name " is no field in C")
            if (name ~ /^[A-Z]/ && !(name in word) && name !~ /^(DBL|FLT)_/)
                wrong(name " is not in C")
        }
        for (name in field)
            if (!(name in told)) wrong("no row for" field[name] "." name)
        exit bad
    }' || bad=1
exit "${bad:-0}"
