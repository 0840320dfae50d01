#!/bin/sh
# t_readers.sh - tests of build/tess: the files it reads, and refuses.
#
# Of each format what it allows, and damages, come from generate.py; that
# nothing in a file is unheard is contract.py's; what is said of it, word for
# word, is messages.py's; others.py has other programs write and read,
# refusals.py runs what refusals advise.
# shellcheck disable=SC2034 # of common.sh
NAME=readers
. test/cli/t/common.sh

# (many short runs: those without shared libraries are shorter)
# shellcheck disable=SC2046 # a list of files
$CC -static -o tess $(objects none) "$TOP"/build/tess.o "$TOP"/build/hhpred.o \
    -lm 2> words || cp "$TESS" tess
lines $PYTHON "$TOP"/test/cli/t/messages.py ./tess
lines $PYTHON "$TOP"/test/cli/t/contract.py ./tess
if $PYTHON -c 'import concurrent.futures' 2> told; then
    # (no index is beyond its array, none of what C leaves open; what is
    # allocated is not freed at the end)
    ASAN_OPTIONS=detect_leaks=0
    export ASAN_OPTIONS
    READERS='scan|cell|rows|names|doubts|formats|tables|meshes|models|atoms|arrays'
    # shellcheck disable=SC2046 # lists of files
    $CC -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -I"$TOP" \
        -o checked \
        $(echo "$READERS" | tr '|' '\n' | \
        sed "s,.*,$TOP/test/cli/src/read/&.c,") \
        $(objects "$READERS") "$TOP"/build/tess.o "$TOP"/build/hhpred.o -lm \
        2> words || cp tess checked
    lines $PYTHON "$TOP"/test/cli/t/generate.py ./checked
else
    skip "files that formats allow, and damaged ones: no $PYTHON"
fi
if $PYTHON -c 'import numpy' 2> told; then
    lines $PYTHON "$TOP"/test/cli/t/others.py "$TESS" 8
    sed -n 's/^        none: //p' numbers > lacking
    while read -r line; do skip "$line"; done < lacking
    # (hardly anything of it is this program's: -all)
    [ -z "${ALL:-}" ] || lines $PYTHON "$TOP"/test/cli/t/refusals.py "$TESS"
else
    skip "files beside other programs: no numpy for $PYTHON"
fi

ended readers
