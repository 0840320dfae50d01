#!/bin/sh
# constants.sh - have the constants of the FORTRAN half, PARAMETERs that each
# routine declares for itself, the same value in all of them?
#
#     sh test/fortran/constants.sh [TREE]    tess.f and hhpred.f in TREE, else
#                                            in f77
cat "${1:-f77}/tess.f" "${1:-f77}/hhpred.f" | awk '
    function ended(  part, k, n, name) {
        gsub(/ /, "", s)
        if (sub(/^PARAMETER\(/, "", s) && sub(/\)$/, "", s)) {
            n = split(s, part, ",")
            for (k = 1; k <= n; k++) {
                name = part[k]
                sub(/=.*/, "", name)
                many++
                if (!(name in is)) is[name] = part[k]
                if (is[name] != part[k]) {
                    print "constants differ: " is[name], part[k]
                    bad = 1
                }
            }
        }
        s = ""
    }
    /^[^ ]/ { next }
    !/^     [^ ]/ { ended() }
    { s = s substr($0, 7) }
    END { ended(); exit bad || many < 500 }'
