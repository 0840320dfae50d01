#!/bin/sh
# bounds.sh - the table of bounds, with all of its checks; run from the top
# directory.
#
#     sh test/bounds/bounds.sh          prints a line for each constant:
#                                             the row, its name and value, what
#                                             is needed, how many times that it
#                                             is, and by what
#     sh test/bounds/bounds.sh -check   for check.sh: and plants changes
#                                             that must be noticed
#
# Gappa must be installed.  What it was given is in build/bounds.
. test/tests.sh
begin bounds
DIR=build/bounds
HERE=test/bounds
rm -rf $DIR
mkdir -p $DIR
if ! command -v gappa > /dev/null; then
    skip "Gappa is not installed"
    ended
    [ "$1" = -check ]
    exit
fi

# the search, in all rounding modes where C99's fenv.h is to be had
FILES="$HERE/worst.c test/lib/exact.c hhpred.c -lm"
# shellcheck disable=SC2086 # a list of files
$CC -std=c99 -O2 -frounding-math -DTEST_ROUNDING -I. -o $DIR/worst $FILES \
    2> $DIR/told || $CC -O1 -I. -o $DIR/worst $FILES || {
    echo "Bail out! worst.c does not compile"
    exit 1
}

# table TREE ARGUMENTS: the table in this tree, of the sources there
table() {
    tree=$1
    shift
    "$PYTHON" "$tree/$HERE/bounds.py" -s "$tree" "$@"
}

if [ "$1" != -check ]; then
    table . -w $DIR/worst -k $DIR
    exit
fi
table . -w $DIR/worst -k $DIR > $DIR/out
check "each constant has a row, is derived and suffices" test $? -eq 0
{ tail -n 1 $DIR/out
  grep -e '^wrong: ' -e UNCHECKED -e "NOT ENOUGH" $DIR/out; } > $DIR/words
told $DIR/words

# planted NAME FILE EXPRESSION WORDS ROW...: sed's expression changes the file,
# and then the table tells that these words
planted() {
    name=$1
    file=$2
    expression=$3
    words=$4
    shift 4
    rm -rf $DIR/planted
    mkdir -p $DIR/planted/test
    cp tess.[ch] hhpred.[ch] $DIR/planted
    cp -r $HERE $DIR/planted/test
    sed "$expression" "$file" > "$DIR/planted/$file"
    ! cmp -s "$file" "$DIR/planted/$file" &&
        ! table $DIR/planted "$@" > $DIR/out2 2>&1 &&
        grep -q "$words" $DIR/out2
    check "planted: $name" test $? -eq 0
}

planted "another constant" hhpred.c 's/perm, 16[.]0, t/perm, 15.0, t/' \
    "orient_filter: C is 15.0 in the code" -n
planted "another exponent" tess.c 's/\(UNDERFLOW_ERR\) 1e-200/\1 1e-230/' \
    "UNDERFLOW_ERR: X is" -n
planted "another constant in a comment" hhpred.c \
    's/right to 12 eps of itself/right to 9 eps of itself/' \
    "normalize_weights: C is 9.0 in the code" -n
planted "a bound that is new" tess.c \
    's/if (side < 1) s->limbs.behind_facet = z;/if (hi < 3.0 * EPS) return;/' \
    "no row: tess.c note_comparison" -n
planted "an error that counts twice" tess.c \
    's/, dc = s->filter.dc;/, dc = 2.0 * s->filter.dc;/' \
    "no row: tess.c record_set" -n
planted "a small number" tess.c 's/if (margin <= 0.0)/if (margin <= 1e-14)/' \
    "no row: tess.c ball_in_star_list" -n
planted "a rounding more" hhpred.h 's/((w0) \* ((w0)/(0.9 * (w0) * ((w0)/' \
    "hh_ratio: B is 12, needed" hh_ratio
# of the table: constants that do not suffice
for change in "orient_filter:C = 16:C = 7" "filter_bound:C = 8:C = 6" \
    "hh_limits:B = 5:B = 4.9" "setup_E:B = 90:B = 80" "tilt:B = 8:B = 3" \
    "LIST_DIST_ERR:R = 32:R = 31" "near_list:C = 32:C = 8" \
    "choose_cap:A = 8:A = 3" "choose_cap:C = 64:C = 40"; do
    row=${change%%:*}
    from=${change#*:}
    to=${from#*:}
    from=${from%:*}
    file=$(grep -l "^row: $row\$" $HERE/*.rows)
    planted "$row's $to" "$file" \
        "/^row: $row\$/,/^\$/s/^constant: $from\$/constant: $to/" \
        "$row: .* needed" "$row"
done
ended
