#!/bin/sh
# code.sh - a checksum of the library's code: both halves without comments,
# white space, the lines that carry the version, and the header that hunts alone
# include.  bench.sh and evidence.sh write it into their results, so that
# stamps.sh can tell when these are of other code.  Run from the top directory.
{
    # (no text and no character of the files has a comment's signs)
    awk '{
        line = $0
        code = ""
        while (line != "") {
            if (comment) {
                if (!(at = index(line, "*/"))) break
                line = substr(line, at + 2)
                comment = 0
            } else {
                if (!(at = index(line, "/*"))) { code = code line; break }
                code = code substr(line, 1, at - 1)
                line = substr(line, at + 2)
                comment = 1
            }
        }
        print code
    }' hhpred.h tess.h hhpred.c tess.c
    grep -hv '^[C*!]' f77/hhpred.f f77/tess.f
} | egrep -v '(TESS|HH)_VERSION|TESSED =|HHV[0-9A-Z]{3}$|^#include "test/' | tr -d ' \t\n' |
    cksum | sed 's/ .*//'
