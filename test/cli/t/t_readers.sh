#!/bin/sh
# t_readers.sh - tests of build/tess: others.py has other programs write and read
# its files, refusals.py runs what refusals advise.
# shellcheck disable=SC2034 # of common.sh
NAME=readers
. test/cli/t/common.sh

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
