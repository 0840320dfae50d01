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

# ---- TAP, the Test Anything Protocol: what every test prints ----
#
#     ok 1 - NAME, not ok 2 - NAME, ok 3 # SKIP WHY; 1..3 at the end
#     # what helps to see why
#
# and the same, indented, of a program that is run by it (a subtest).

# begin NAME: count anew.  (In a file, as behind a pipe no variable can be set;
# to 3, as the output of what is tested goes elsewhere.)
begin() {
    mkdir -p build
    RESULTS=$(pwd)/build/results.$1
    SAID=$RESULTS.said
    : > "$RESULTS"
    exec 3>&1
}

# result VERDICT TEXT: a line for a test
result() {
    echo "$1" >> "$RESULTS"
    printf '%s\n' "$1 $(($(wc -l < "$RESULTS"))) $2" | sed '2,$s/^/# /' >&3
}
pass() { result ok "- $1"; }
fail() { result "not ok" "- $1"; }
skip() { ! wanted "$1" || result ok "# SKIP $1"; }

# ended: the plan; 1 if a test has failed
ended() {
    echo "1..$(($(wc -l < "$RESULTS")))" >&3
    ! grep '^not' "$RESULTS" > "$SAID"
}

# told FILE: shown behind #
told() { head -n 60 "$1" | sed 's/^/# /' >&3; }

# wanted NAME: is this test asked for?  (check.sh has another one)
wanted() { :; }

# check NAME COMMAND...: a test that is passed when the command succeeds; else it
# shows what that prints
check() {
    wanted "$1" || return 0
    name=$1
    shift
    if "$@" > "$SAID" 2>&1; then
        pass "$name"
    else
        fail "$name"
        told "$SAID"
    fi
    { echo "== $name: $*"; cat "$SAID"; } >> "${LOG:-/dev/null}"
}

# empty NAME FILE: a test that is passed when the file is empty; it has what is
# wrong
empty() {
    wanted "$1" || return 0
    if [ -s "$2" ]; then
        fail "$1"
        told "$2"
    else
        pass "$1"
    fi
}

# quoted WORD...: as a shell reads them
quoted() {
    for word; do
        case $word in
        *[!a-zA-Z0-9_./=,:+-]* | '') printf " '%s'" "$word";;
        *) printf ' %s' "$word";;
        esac
    done
}

# subtest NAME PROGRAM...: a program that prints TAP: a test that is passed when
# all of its tests are, and all have been run, in LIMIT seconds of a processor, or
# 300.  Says what it took of them.
subtest() {
    wanted "$1" || return 0
    name=$1
    shift
    alone="(cd$(quoted "$(pwd)") &&$(quoted "$@"))"
    printf '# Subtest: %s\n' "$name" >&3
    # (a subshell: the times are of this program alone)
    (
        limited ${LIMIT:-300} "$@"
        code=$?
        times > "$RESULTS.times"
        exit $code
    ) > "$SAID" 2>&1
    code=$?
    sed 's/^/    /' "$SAID" >&3
    { echo "== $name: $*"; cat "$SAID"; } >> "${LOG:-/dev/null}"
    seconds=$(tr ms '  ' < "$RESULTS.times" |
        awk 'NR == 2 { printf "%.1f", 60 * $1 + $2 + 60 * $3 + $4 }')
    echo "# took $seconds s" >&3
    why=$(awk -v code=$code '/^ok/ { n++ } /^not ok/ { n++; bad++ }
        /^1\.\.[0-9]/ { plan = substr($1, 4) }
        END { if (plan == "" || plan + 0 != n || code && !bad)
                printf "stopped with code %d behind %d tests", code, n
            else if (bad) printf "%d of %d", bad, n }' "$SAID")
    if [ -z "$why" ]; then
        pass "$name"
    else
        fail "$name: $why"
        case $why in stopped*) tail -n 8 "$SAID" | sed 's/^/# | /' >&3;; esac
        echo "# run it alone: $alone" >&3
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
