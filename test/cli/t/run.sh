#!/bin/sh
# run.sh [-lines] [OPTION...] NAME... - test_NAME.py of each NAME, or all tests of
# build/tess without one, by pytest with these options, as -x or --basetemp=DIR;
# run from the top directory, after `make'.  Takes PYTHON, TESS, ALL and CC from
# the environment.
#
# It prints TAP; with -lines what check.sh counts: `ok      TEST', `FAILED
# TEST', `        skipped: WHY', and `program: N passed, N failed'.
PYTHON=${PYTHON:-python3}
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
lines=
[ "$1" != -lines ] || { lines=yes; shift; }
# each set of files has its directory, so that sets can run at the same time
base=build/cli/tests
for name; do
    shift
    case $name in
    -*) set -- "$@" "$name";;
    *)
        set -- "$@" "test/cli/t/test_$name.py"
        base=$base+$name;;
    esac
done
mkdir -p build/cli
[ "$base" != build/cli/tests ] || set -- "$@" test/cli/t

tap() {
    if ! $PYTHON -c 'import pytest' 2> "$base.none"; then
        echo "ok 1 - tests of build/tess # SKIP no pytest for $PYTHON"
        echo "1..1"
        return
    fi
    $PYTHON -m pytest -p no:cacheprovider --basetemp="$base" --tap "$@"
}

if [ -z "$lines" ]; then
    tap "$@"
    exit
fi
tap "$@" 2>&1 | awk '
    / # SKIP / { sub(/.* # SKIP /, ""); print "        skipped: " $0; next }
    /^ok / { sub(/ok [0-9]* - /, ""); print "ok      " $0; passed++; next }
    /^not ok / { sub(/not ok [0-9]* - /, ""); print "FAILED  " $0; failed++
        next }
    /^1\.\./ { plan = 1; next }
    { print }
    END { if (!plan) { print "FAILED  pytest did not end"; failed++ }
        printf "program: %d passed, %d failed\n", passed, failed
        exit failed != 0 }'
