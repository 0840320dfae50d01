#!/bin/sh
# constants.sh - have the constants of the FORTRAN half, PARAMETERs that each
# routine declares for itself, the same value in all of them?
#
#     sh test/fortran/constants.sh [TREE]    tess.f and hhpred.f in TREE, else
#                                            in f77
#
# OTHERS are those of two values, or of one that is written in two ways.
OTHERS="CARRY=2**29 CARRY=2.0D0**29 DEPTH=64 DEPTH=96 DIGITS=4 DIGITS=53
    DOWN=2.0D0**(-DOWNEX) DOWN=2.0D0**(-96) FAR=300 FAR=1.0E10
    HUGE=(2.0D0-EPS)*2.0D0**1023 HUGE=1.7976931348623157D308
    PAD=64.0D0*EPS PAD=64.0D0*2.0D0**(-52)"
# shellcheck disable=SC2086,SC2116 # a line
cat "${1:-f77}/tess.f" "${1:-f77}/hhpred.f" | awk -v others="$(echo $OTHERS)" '
    function ended(  part, k, n, name) {
        gsub(/ /, "", s)
        if (sub(/^PARAMETER\(/, "", s) && sub(/\)$/, "", s)) {
            n = split(s, part, ",")
            for (k = 1; k <= n; k++) {
                name = part[k]
                sub(/=.*/, "", name)
                many++
                if (part[k] in other) continue
                if (!(name in is)) is[name] = part[k]
                if (name in two || is[name] != part[k]) {
                    print "constants differ: " is[name], part[k]
                    bad = 1
                }
            }
        }
        s = ""
    }
    BEGIN {
        n = split(others, part, " ")
        for (k = 1; k <= n; k++) {
            other[part[k]]
            sub(/=.*/, "", part[k])
            two[part[k]]
        }
    }
    /^[^ ]/ { next }
    !/^     [^ ]/ { ended() }
    { s = s substr($0, 7) }
    END { ended(); exit bad || many < 500 }'
