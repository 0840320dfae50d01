#!/bin/sh
# tarball.sh - make and make check where and how others run them: from a tarball,
# in a path with a blank, with other makes and compilers, behind nohup; and that
# make compiles what a change concerns.  Run from the top directory.
#
# (Of make check the tests of how a test is run, and a program.)
. test/tests.sh
begin tarball
B=$(pwd)/build/tarball
chmod -R u+w "$B" 2> build/told
rm -rf "$B"
mkdir -p "$B/a path"
LOG=$B/log
OUTSIDE=$(mktemp -d) || exit
trap 'rm -rf "$OUTSIDE"' EXIT

# what git knows of, or all
(
    cd -P test/.. || exit
    { git ls-files 2> "$B/told" | grep . ||
        find . \( -name build -o -name .git \) -prune -o -type f -print; } |
        tar -cf "$B/tess.tar" -T -
)
cd "$B/a path" && tar -xf ../tess.tar
check "a tarball" test -f .ci/run -a -f tess.c -a ! -e .git

# passes NAME COMMAND...: the command ends with tests that are all passed
passes() {
    name=$1
    shift
    check "make check: $name" sh -c '"$@" > "$0" 2>&1 || { cat "$0"; exit 1; }
        tail -n 1 "$0" | grep -x "[1-9][0-9]* passed, 0 failed, 0 skipped" ||
        { cat "$0"; exit 1; }' "$B/out" "$@"
}
M="make CFLAGS=-O0"
passes "in a path with a blank, make -j8" env PROCESSORS=1 $M -j8 check ONLY=t_size
passes "nohup" nohup $M check ONLY=signals
passes "in a background that ignores interrupts, without standard input" sh -c "
    trap '' INT QUIT HUP; exec $M check ONLY=signals <&-"
check "make check: no such test" sh -c "! $M check ONLY=nosuchtest > '$B/out' &&
    grep \"^no test has 'nosuchtest' in its name\" '$B/out'"

# ---- what is compiled anew: that, of which a header is included ----

# (no header includes read.h)
anew() {
    grep -l '^#include ".*read[.]h"' test/cli/src/*.c test/cli/src/*/*.c |
        sed 's,.*/,,' | sort > "$B/wanted"
    sleep 1
    touch test/cli/src/read/read.h
    "$@" > "$B/out" 2>&1
    sed -n 's,.* -c .*/\([a-z]*[.]c\)$,\1,p' "$B/out" | sort |
        diff "$B/wanted" - && test -s "$B/wanted" && "$@" > "$B/out" 2>&1 &&
        ! grep ' -c ' "$B/out"
}
check "make: what includes a header is compiled anew" anew $M
if command -v bmake > "$B/told"; then
    check "bmake: all is as make has left it" sh -c "bmake CFLAGS=-O0 > '$B/out' &&
        ! grep ' -c ' '$B/out'"
    check "bmake: what includes a header is compiled anew" anew bmake CFLAGS=-O0
else
    skip "bmake: not installed"
fi
if command -v tcc > "$B/told"; then
    rm -rf build
    check "tcc" make CC=tcc CFLAGS=
    check "tcc: build/tess" build/tess -q -check test/data/mirror.xyz
    sleep 1
    touch test/cli/src/read/read.h
    check "tcc: what includes a header is compiled anew" sh -c "
        make CC=tcc CFLAGS= > '$B/out' && grep 'read/rows[.]c$' '$B/out'"
else
    skip "tcc: not installed"
fi

# ---- sources that may not be written, and all that is made elsewhere ----

rm -rf build
touch "$B/before"
chmod -R a-w .
passes "sources that are read-only, BUILD=" $M BUILD="$OUTSIDE/to" check \
    ONLY=signals
check "BUILD=: tess" "$OUTSIDE/to/tess" -q -check test/data/mirror.xyz
check "BUILD=: make run" $M BUILD="$OUTSIDE/to" run
# (root may write everywhere)
find . -newer "$B/before" ! -type d > "$B/out"
empty "BUILD=: nothing is written among the sources" "$B/out"
chmod -R u+w .
ended
