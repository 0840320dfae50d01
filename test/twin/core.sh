#!/bin/sh
# core.sh - write tess.f without chapters of its part II, as C's -DTESS_CORE and
# -DTESS_NO_... leave them out: with 0 in their PARAMETERs, of which the table of
# chapters has a row with that macro.
#
#     sh test/twin/core.sh [NAME...] > core.f    without these, or without all
#     sh test/twin/core.sh -list                 the PARAMETERs' names
chapters=`sed -n 's/^C       \([A-Z]*\) *= 1 *TESS_NO_.*/\1/p' f77/tess.f`
case $1 in
-list)
    echo $chapters
    exit;;
esac
awk -v names="${*:-$chapters}" '
    BEGIN { many = split(names, name, /[ \n]+/) }
    /^C/ { print; next }
    {
        line = $0
        for (k = 1; k <= many; k++)
            if (match(line, "[ (]" name[k] " = 1[,)]")) {
                line = substr(line, 1, RSTART + RLENGTH - 3) "0" \
                    substr(line, RSTART + RLENGTH - 1)
                done[k]
            }
        print line
    }
    END {
        for (k = 1; k <= many; k++) if (!(k in done)) bad = 1
        exit bad || many < 1
    }' f77/tess.f
