# shellcheck shell=sh
# common.sh - what scripts of tests of build/tess share: each reads it, behind its
# NAME=..., by `. test/cli/t/common.sh', in the top directory, after `make'.
#
# They run in build/NAME, and end with `NAME: N passed, M failed'.  Of
# mutation.sh are TESS, the program, and SHORT, if other tests have been passed.
. test/tests.sh
begin "$NAME"
TOP=$(pwd)
TESS=${TESS:-$TOP/build/tess}
SHORT=${SHORT:-}
rm -rf "build/$NAME"
mkdir -p "build/$NAME"
cd "build/$NAME" || exit 1
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE

# objects NAMES: what build/tess is linked from, but for the library and the
# files NAMES, with | between them
objects() {
    sed -n '/^PROGRAM = /,/[^\\]$/p' "$TOP/Makefile" | tr ' ' '\n' |
        sed -n "s,^build/,$TOP/&,p" | grep -E -v "/($1)\.o"
}

# The same five points, with one value, two, none; the last with a marker.
cat > none << END
5 3 0 0
0 0 0 0
1 1 0 0
2 0 1.5 0
3 0 0 -2
4 0.134 0.25 -0.5
END
awk 'NR == 1 { print "5 3 1 0" } NR > 1 { print $0, 10 * $1 }' none > one
awk 'NR == 1 { print "5 3 2 0" } NR > 1 { print $0, 10 * $1, 0.5 + $1 }' \
    none > two
awk 'NR == 1 { print "5 3 2 1" } NR > 1 { print $0, 10 * $1, 0.5 + $1, $1 % 2 }
    ' none > marked

cat > corners << END
6 3 0 0
0 0 0 0
1 1 0 0
2 0 1.5 0
3 0 0 0
4 0 0 -2
5 0.134 0.25 -0.5
END

# reads EXPECTED FILE [WORDS]: FILE (standard input when it is -) holds the
# points of EXPECTED; standard error says WORDS, or nothing.  OPTIONS are tess's.
OPTIONS=
reads() {
    cat > input
    [ "$2" = - ] || cp input "$2"
    rm -f out.node
    $TESS $OPTIONS -account -node out.node "$2" < input > said 2> words
    if [ $? -ne 0 ] || ! cmp -s "$1" out.node ||
        ! grep 'left out: all$' said > unseen; then
        fail "$2 ($3): `cat words`"
    elif [ -n "$3" ] && ! grep -e "$3" words > /dev/null; then
        fail "$2: not said: $3"
    elif [ -z "$3" ] && [ -s words ]; then
        fail "$2: said: `cat words`"
    else
        pass "reads $2 $3"
    fi
}

# refuses FILE WORDS: exit code 2, and WORDS on standard error
refuses() {
    cat > "$1"
    rm -f out.node
    $TESS $OPTIONS -node out.node "$1" > said 2> words
    code=$?
    if [ $code -ne 2 ] || [ -f out.node ]; then
        fail "$1 ($2) is not refused: code $code"
    elif ! grep -e "$2" words > /dev/null; then
        fail "$1: not said: $2: `cat words`"
    else
        pass "refuses $1: $2"
    fi
}
