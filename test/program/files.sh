#!/bin/sh
# files.sh - tests of build/tess: files that formats allow, damaged ones, and what
# other programs write and read.
#
# Run from the top directory, after `make'.  Ends with
# `files: N passed, M failed'.
. test/tests.sh
begin files
TOP=$(pwd)
rm -rf build/files
mkdir -p build/files
cd build/files || exit 1
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE

if $PYTHON -c 'import concurrent.futures' 2> told; then
    lines $PYTHON "$TOP"/test/program/generate.py "$TOP"/build/tess
else
    skip "files that formats allow, and damaged ones: no $PYTHON"
fi
if $PYTHON -c 'import numpy' 2> told; then
    lines $PYTHON "$TOP"/test/program/others.py "$TOP"/build/tess 20
    sed -n 's/^        none: //p' numbers > none
    while read -r line; do skip "$line"; done < none
else
    skip "files beside other programs: no numpy for $PYTHON"
fi

ended files
