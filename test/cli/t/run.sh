#!/bin/sh
# run.sh [OPTION...] NAME... - test_NAME.py of each NAME, or all tests of
# build/tess without one, by pytest with these options, as -x or --basetemp=DIR;
# run from the top directory, after `make'.  Takes PYTHON, TESS, ALL and CC from
# the environment.
# It prints TAP.
PYTHON=${PYTHON:-python3}
PYTHONDONTWRITEBYTECODE=1
export PYTHONDONTWRITEBYTECODE
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

if ! $PYTHON -c 'import pytest' 2> "$base.none"; then
    echo "ok 1 - tests of build/tess # SKIP no pytest for $PYTHON"
    echo "1..1"
    exit
fi
$PYTHON -m pytest -p no:cacheprovider --basetemp="$base" --tap "$@"
