# shellcheck shell=sh
# tests.sh - what scripts of tests share: each reads it by `. test/tests.sh', in
# the top directory.  Takes CC and PYTHON from the environment.
CC=${CC:-cc}
PYTHON=${PYTHON:-python3}
# (of small matrices, as NumPy has here, threads make more work)
export OPENBLAS_NUM_THREADS=1
# what programs of test/unit share; those that test meshes
# shellcheck disable=SC2034 # for those that read this
SHARED="test/unit/lib/damage.c test/unit/lib/guard.c test/unit/lib/result.c
    test/unit/lib/whole.c test/unit/lib/five.c"
# shellcheck disable=SC2034
MESHES="t_tess t_resume t_check t_locate t_range"
# a compiler for WebAssembly, whose programs node runs, by
# builds/machines/wasm/run.js
# shellcheck disable=SC2034 # for those that read this
WASM="clang --target=wasm32 -O2 -ffreestanding -nostdlib \
    -Itest/builds/machines/wasm -Wl,--no-entry -Wl,--export=main \
    -Wl,--allow-undefined -Wl,-z,stack-size=1048576"

# begin NAME: count anew.  (In a file, as behind a pipe no variable can be set;
# to 3, as the output of what is tested goes elsewhere.)
begin() {
    mkdir -p build
    RESULTS=$(pwd)/build/results.$1
    : > "$RESULTS"
    exec 3>&1
}

# count PASSED FAILED SKIPPED
count() { echo "$*" >> "$RESULTS"; }
pass() { count 1 0 0; echo "ok      $1" >&3; }
fail() { count 0 1 0; echo "FAILED  $1" >&3; }
skip() { count 0 0 1; echo "        skipped: $1" >&3; }

# counts: how many passed, failed, were skipped
counts() {
    awk '{ p += $1; f += $2; s += $3 } END { print p + 0, f + 0, s + 0 }' \
        "$RESULTS"
}

# ended NAME: the last line of a script that others count
ended() {
    counts | {
        read -r passed failed _
        echo "$1: $passed passed, $failed failed"
        [ "$failed" -eq 0 ]
    }
}

# counted FILE: of such a line in a program's output the two numbers
counted() {
    sed -n 's/^[a-z_0-9]*: \([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' "$1"
}

# yes NAME COMMAND...: passed when it succeeds
yes() {
    name=$1
    shift
    if "$@"; then pass "$name"; else fail "$name"; fi
}

# lines COMMAND...: a program that prints `ok ...' or `FAILED ...' for each of its
# tests, and nothing on standard error
lines() {
    "$@" > numbers 2> told
    code=$?
    cat numbers
    count "$(grep -c '^ok' numbers)" "$(grep -c '^FAILED' numbers)" 0
    if [ $code -ne 0 ] || [ -s told ]; then
        fail "$*: code $code: $(tail -n 1 told)"
    fi
}

# have CC FLAGS: does this compiler take these flags, and its programs run?
have() {
    echo 'int main(void) { return 0; }' > build/have.c
    # shellcheck disable=SC2086
    $1 $2 -o build/have build/have.c -lm > /dev/null 2>&1 && build/have
}

# limited SECONDS COMMAND...: a program that never ends fails, too
limited() {
    # shellcheck disable=SC3045 # all shells that there are know -t
    (ulimit -t "$1"; shift; exec "$@")
}

# lowered FILE: tess.c with thresholds, LOW, such that few points bring about
# what else only many do; 1 if it lacks one
LOW="LEAF_POINTS=8 LIMB_BALL_AFTER=1 BALL_ERR_MAX=0.0 LIMB_NORMAL_E=1e-15
    SAMPLE_MIN=2 SAMPLE_LIMIT=0.02 SURFACE_POINTS_MIN=1 SLENDER_VOLUME=1e9
    BUDGET_REFILL=0.01 CLUMP_WIDTH=0.2 BIG_BALL=0.0 CAP_RADIUS=1e9 CAP_NODES=0
    CAP_LIMIT=0.0"
lowered() {
    # shellcheck disable=SC2086 # a line each
    printf '%s\n' $LOW | awk -F = 'NR == FNR { low[$1] = $2; n++; next }
        $1 ~ /^#define / { split($1, word, " ") }
        $1 ~ /^#define / && word[2] in low {
            $0 = "#define " word[2] " " low[word[2]]
            n--
        }
        { print }
        END { exit n != 0 }' - "$1"
}

# gfort PREFIX FLAGS: the FORTRAN half, objects PREFIXtess.o and PREFIXhhpred.o.
# -std=f95 -pedantic knows of no extension of FORTRAN 77 that is not in Fortran
# 90.
gfort() {
    prefix=$1
    shift
    for half in tess hhpred; do
        gfortran -frecursive -Wall -Wextra -Werror -std=f95 -pedantic "$@" -c \
            -o "$prefix$half.o" f77/$half.f || return 1
    done
}

# viaf2c PREFIX: the same by f2c
viaf2c() {
    mkdir -p build/f2c
    f2c -A -a -u -dbuild/f2c f77/tess.f f77/hhpred.f \
        > build/f2c.txt 2>&1 && ! grep -i warning build/f2c.txt || return
    for half in tess hhpred; do
        $CC -O2 -c -o "$1$half.o" "build/f2c/$half.c" || return
    done
}
