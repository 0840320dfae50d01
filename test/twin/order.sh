#!/bin/sh
# order.sh - do the routines of tess.f have their arguments in the one order that
# its head gives?  What the head names comes first, in its order.  The name of an
# array counts where it is one, N where it goes with points or with a length of
# workspace.
#
#     sh test/twin/order.sh [FILE]
awk '
    BEGIN { SCALARS = " N MASKED MAXTET ROOM NTET FOUND LIW LRW COUNT " }
    function ended(  k, n, arg, have, last, low, name) {
        if (match(s, /(SUBROUTINE|FUNCTION) [A-Z0-9]*/)) {
            head = s
            declared = ""
        } else if (s ~ /^(INTEGER|REAL|DOUBLE PRECISION) /)
            declared = declared "," s
        else if (s == "END" && head ~ /[(]/) {
            routines++
            name = head
            sub(/[(].*/, "", name)
            sub(/.* /, "", name)
            gsub(/.*[(]| |[)].*/, "", head)
            n = split(head, arg, ",")
            have = "," head ","
            last = 0
            for (k = 1; k <= n; k++) {
                low = at[arg[k]]
                if (arg[k] == "N" && have !~ /,(P|REP|TET|LIW),/) low = 0
                if (index(SCALARS, " " arg[k] " ") == 0 &&
                    declared !~ "[ ,]" arg[k] "[(]") low = 0
                if (low && low < last) {
                    print name ": " arg[k] " is too late"
                    bad = 1
                }
                last = low ? low : names + 1
            }
        }
        s = ""
    }
    /^C/ && /^C     one order:/ { table = 1 }
    table && /^C       [a-z]+ +[A-Z]/ {
        for (k = 3; k <= NF; k++) at[$k] = ++names
        next
    }
    names { table = 0 }
    /^C/ || /^$/ { next }
    !/^     [^ ]/ { ended() }
    {
        line = substr($0, 7)
        sub(/^ +/, "", line)
        s = s line
    }
    END {
        ended()
        exit bad || names < 30 || routines < 100
    }' "${1:-f77/tess.f}"
