#!/bin/sh
# manual.sh - write f77/README, the manual of the FORTRAN routines, anew: its text
# as it is, with the version, then what stands before each routine in tess.f and
# hhpred.f.  `make manual' calls it.
version=`awk '/^      TESSED = / {
    printf "%d.%d", $3 / 10000, $3 / 100 % 100 }' f77/tess.f`
echo "tess $version in FORTRAN 77: the manual"
sed '1d;/^-----/,$d' f77/README
for name in TESS TESSWK TESSRE TESSLO TESSVA TESSHU TESSCH TESSIX TESSQU TESSPA \
    TESSBA TESSED HHFACE HHSIDE HHOPP HHLCOO HHWRAP HHORIE HHINSP; do
    awk -v routine=$name '
        $1 == "C" && $2 == routine && $3 == "-" { text = 1; n = 0 }
        text == 1 && /^C     How: / { text = 2 }
        text == 1 && /^C/ { line[n++] = substr($0, 7) }
        text && !/^C/ { text = 3 }
        # a line that goes on belongs to the one before it
        text == 3 && /^     [^ ]/ && skip { next }
        { skip = 0 }
        text == 3 && /^     [^ ]/ {
            if (types == "") head = head "\n" $0; else types = types "\n" $0
            next
        }
        text == 3 && /(SUBROUTINE|FUNCTION)/ {
            head = $0
            next
        }
        text == 3 {
            # declarations, as far as they are of arguments
            name = $0
            sub(/^ *(INTEGER|DOUBLE PRECISION|REAL) /, "", name)
            sub(/[^A-Z0-9].*/, "", name)
            if ($0 ~ /^ *(INTEGER|DOUBLE PRECISION|REAL) / &&
                head ~ "[ (,]" name "[,)]") {
                types = types "\n" $0
                next
            }
            # those of constants before them: a length of arguments is written
            # as the number that it is
            if (/^ *PARAMETER \([A-Z]* = [0-9]*\)$/) {
                sub(/^ *PARAMETER \(/, "")
                constant = "(" $1 ")"
                number = "(" $3
                next
            }
            if (/^ *(INTEGER|DOUBLE PRECISION|PARAMETER) /) {
                skip = 1
                next
            }
            text = 0
            print substr("----------------------------------------" \
                "----------------------------------------", 1, 76)
            while (constant != "" && (i = index(types, constant)) > 0)
                types = substr(types, 1, i - 1) number \
                    substr(types, i + length(constant))
            print head types "\n"
            while (n > 0 && line[n-1] == "") n--
            for (i = 0; i < n; i++) print line[i]
            print ""
            exit
        }' f77/tess.f f77/hhpred.f
done
