#!/bin/sh
# core.sh - write tess.f without its stages, as C's -DTESS_CORE leaves them out.
# Of the routines between the headings "Stages" and "Sorting." only the heads and
# declarations are left.  A function returns 0, and a last argument OK or Z is 0:
# a stage may always do nothing, and says so.  TSDROP stays: it sets what says
# that there are no lists.
#
#     sh test/fortran/core.sh [FILE] > core.f
awk '
    /^C     Stages$/ { stages = 1 }
    /^C     Sorting[.]$/ { stages = 0 }
    !stages || /^C/ { print; next }
    /^      [A-Z ]*(SUBROUTINE|FUNCTION) / {
        match($0, /(SUBROUTINE|FUNCTION) [A-Z0-9]+/)
        name = substr($0, RSTART, RLENGTH)
        sub(/.* /, "", name)
        answer = /FUNCTION/ ? name : ""
        last = ""
        head = whole = 1
        if (name != "TSDROP") { whole = 0; left++ }
    }
    whole { print; next }
    head && /[)] *$/ {
        last = $0
        gsub(/.*[ ,(]|[)] *$/, "", last)
    }
    head {
        head = $0 !~ /[)] *$/
        specified = 1
        print
        next
    }
    !/^     [^ ]/ && !/^      (INTEGER|REAL|DOUBLE PRECISION|PARAMETER)[ (]/ {
        specified = 0
    }
    specified { print }
    $0 == "      END" {
        if (answer == "" && last ~ /^(OK|Z)$/) answer = last
        if (answer != "") print "      " answer " = 0"
        print
    }
    END { exit left < 40 }' "${1:-f77/tess.f}"
