#!/bin/sh
# names.sh - the routines of both halves, as the files have them: each routine of
# FORTRAN says its name in C in brackets, `TSLEAF (leaf_of) - ...'; those of
# tess.h and hhpred.h have the same names, cut to six letters.
#
#     sh test/twin/names.sh [-c|-f] FILE    the routines of a file of C or of
#                                              FORTRAN, in its order
#     sh test/twin/names.sh HALF [TREE]     of tess or hhpred, a line for each
#                                              routine that both have: its names
#                                              in C and in FORTRAN, in FORTRAN's
#                                              order; the files may be in TREE
#     sh test/twin/names.sh -order HALF [TREE]
#                                              is the order the same, and is said
#                                              of all others, in FORTRAN's file
#                                              behind `Only in C:' and `Only
#                                              here:', that one half has them?
#                                              Says what is not

# c FILE: a definition's name stands before the brace in the first column, a
# prototype ends in a semicolon
c() {
    awk '/^[a-z][a-z_ ]* [*]*[a-z_0-9]*\(/ {
            name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name) }
        /;$/ { name = "" }
        /^{/ && name != "" { print name; name = "" }' "$1"
}
f() {
    sed -n 's/^      [A-Z ]*\(FUNCTION\|SUBROUTINE\) \([A-Z0-9]*\).*/\2/p' "$1"
}
case $1 in
-c | -f)
    ${1#-} "$2"
    exit;;
esac
order=
[ "$1" != -order ] || { order=yes; shift; }
half=$1
tree=${2:-.}
[ -f "$tree/$half.c" ] || tree=.
fortran=$tree/f77/$half.f
[ -f "$fortran" ] || fortran=$tree/$half.f
{ c "$tree/$half.c" | sed 's/^/c /'
  f "$fortran" | sed 's/^/f /'
  # the names that comments say
  sed -n 's/^C     \([A-Z0-9]*\) (\([a-z_0-9]*\)) - .*/said \1 \2/p' "$fortran"
  # those that only one half has
  sed 's/^C//' "$fortran" | awk '/Only in C: / { only = "onlyc" }
    only != "" {
        n = split($0, w, /[^A-Za-z0-9_]+/)
        for (k = 1; k <= n; k++) {
            if (w[k] == "Only" && w[k + 1] == "here") only = "onlyf"
            print only, w[k]
        }
    }
    /^ *$/ { only = "" }'
} | awk -v order="$order" -v half="$half" '
    function wrong(what) { print half ": " what; bad = 1 }
    # the FORTRAN name of a public routine
    function six(name) {
        sub(/^tess_index$/, "tess_ix", name)
        sub(/^tess_size$/, "tess_wk", name)
        gsub(/_/, "", name)
        return toupper(substr(name, 1, 6))
    }
    $1 == "c" { c[++nc] = $2; inc[$2] = nc; if ($2 ~ /^(tess|hh_)/) short[six($2)] = $2 }
    $1 == "f" { f[++nf] = $2 }
    $1 == "said" { said[$2] = $3 }
    $1 == "onlyc" { onlyc[$2] }
    $1 == "onlyf" { onlyf[$2] }
    END {
        for (k = 1; k <= nf; k++) {
            name = f[k] in said ? said[f[k]] : short[f[k]]
            if (name ~ /^(frexp|ldexp)$/) continue # of the C library
            if (name == "") {
                if (!(f[k] in onlyf)) wrong(f[k] " does not say its name in C")
                continue
            }
            if (!(name in inc)) {
                wrong(f[k] " is " name ", which there is not in C")
                continue
            }
            has[name]
            if (!order) print name, f[k]
            else if (inc[name] < last) wrong(name " is elsewhere than " f[k])
            last = inc[name]
            pairs++
        }
        for (k = 1; k <= nc; k++)
            if (!(c[k] in has) && !(c[k] in onlyc))
                wrong(c[k] " has no twin, and it is not said")
        if (order) exit bad || pairs < 50
    }'
