#!/bin/sh
# check.sh [-all] - the tests; run from the top directory.
# check.sh -unit NAME [ARGUMENTS] - a program of test/unit alone.
#
# Without -all what a change wants most: strict C89, the unit tests, brute
# force, both halves' parity, sanitizers, the examples and the program.  With
# -all more of each, all builds, machines and processes, and a beginning of the
# hunts.
# test/README says what is where.
#
# Takes from the environment, and builds into build/:
#   CC, CFLAGS      the compiler and its options
#   ONLY=WORD       only what has this word in its name; of a group of tests, as
#                   `recipes: ', in the group's
#   COMPLETE=yes    what is skipped has failed
#   PROCESSORS=1    all in turn; where there are two processors two halves run at
#                   the same time, the second one's output behind the first one's
# Ends with the line `N passed, N failed, N skipped'.  The programs' full output
# is in build/check.log.  What a machine lacks (compilers, sanitizers, Fortran)
# is skipped, and said.
. test/tests.sh
ALL=
[ "$1" = -all ] && ALL=yes
CFLAGS=${CFLAGS:--O2}
LIBS=-lm
LIBRARY="tess.c hhpred.c"
LOG=build/check.log
OUT=build/out.$$
PROCESSORS=${PROCESSORS:-$(getconf _NPROCESSORS_ONLN 2> /dev/null)}
# shellcheck disable=SC2034 # for the files of test/check
STRICT="-std=c89 -pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Werror"

begin check
: > $LOG

# wanted NAME: has it ONLY in it?
wanted() {
    case $1 in *"$ONLY"*) return 0;; esac
    return 1
}

# group NAME: may a test of this group be wanted, whose names begin so?
group() {
    wanted "$1" && return
    case $ONLY in *"$1"*) return 0;; esac
    return 1
}

# skipped NAME: what the machine lacks
skipped() {
    wanted "$1" || return 0
    if [ -z "$COMPLETE" ]; then skip "$1"; else fail "$1: skipped"; fi
}

# one NAME COMMAND...: a test that is passed when the command succeeds.
one() {
    wanted "$1" || return 0
    echo "== $*" >> $LOG
    yes "$@" >> $LOG 2>&1
}

# shown NAME COMMAND...: the same for one that writes what differs
shown() {
    wanted "$1" || return 0
    name=$1
    shift
    if "$@" > $OUT 2>&1; then
        pass "$name"
    else
        fail "$name: what differs:"
        head -n 60 $OUT
        cat $OUT >> $LOG
    fi
}

# many NAME PROGRAM...: a program that counts its own tests and ends with
# `program: N passed, N failed'; what it skips it says.
many() {
    wanted "$1" || return 0
    name=$1
    shift
    alone="(cd $(pwd) && $*)"
    echo "== $name: $*" >> $LOG
    started=$(date +%s)
    limited 300 "$@" > $OUT 2>&1
    code=$?
    cat $OUT >> $LOG
    echo "== $name: $(($(date +%s) - started)) s by the clock" >> $LOG
    tail -n 1 $OUT > $OUT.last
    sed -n 's/^        skipped: //p' $OUT > $OUT.skipped
    while read -r line; do skipped "$name: $line"; done < $OUT.skipped
    # shellcheck disable=SC2046 # two numbers
    set -- $(counted $OUT.last)
    if [ $# -ne 2 ]; then
        fail "$name: stopped with code $code; its last lines:"
        tail -n 8 $OUT | sed 's/^/        | /'
        echo "        run it alone: $alone"
        return
    fi
    [ "$2" -gt 0 ] || [ $code -eq 0 ] || set -- "$1" 1
    count "$1" "$2" 0
    if [ "$2" -eq 0 ]; then
        echo "ok      $name: $1"
    else
        echo "FAILED  $name: $2 of $(($1 + $2))"
        grep -v '^ok ' $OUT | grep -v '^        ' | head -n 30
        echo "        run it alone: $alone"
    fi
}

# build PROGRAM CC FLAGS FILES...: into build/PROGRAM
build() {
    out=$1
    cc=$2
    flags=$3
    shift 3
    echo "== $cc $flags -o build/$out $*" >> $LOG
    $cc $flags -o build/$out "$@" $LIBS >> $LOG 2>&1
}

# compile CC FLAGS DIRECTORY FILES...: objects in the directory
compile() {
    cc=$1
    flags=$2
    dir=$3
    shift 3
    mkdir -p $dir
    for f in "$@"; do
        echo "== $cc $flags -c $f" >> $LOG
        $cc $flags -c -o "$dir/$(basename $f .c).o" $f >> $LOG 2>&1 || return 1
    done
}

# objects CC FLAGS FILE...: $OBJECTS, each compiled with these flags once in a run.
# (With the flags in MADE `make' has compiled the library.)
MADE=${MADE:-}
rm -rf build/objects build/units
objects() {
    with="$1 $2"
    kept=build/objects/$(echo "$with" | tr -cd 'a-zA-Z0-9=')
    shift 2
    mkdir -p $kept
    OBJECTS=
    for source in "$@"; do
        object=$kept/$(basename $source .c).o
        if [ ! -f $object ]; then
            case " $LIBRARY " in
            *" $source "*)
                [ "$with" = "$MADE" ] && cp "build/${object##*/}" $object &&
                    OBJECTS="$OBJECTS $object" && continue;;
            esac
            echo "== $with -c $source" >> $LOG
            $with -I. -c -o $object $source >> $LOG 2>&1 || return 1
        fi
        OBJECTS="$OBJECTS $object"
    done
}

# harness FLAGS: those of points and proofs that are linked to a library with
# these.  (What does not alter types is not compiled again.)
harness() {
    case $1 in
    *-frounding-math*) echo "$1";;
    *) echo "-O1$(echo "$1" | tr ' ' '\012' |
        sed -n 's/^-DTESS_\(INT=\|FLOAT\)/ &/p' | tr -d '\012')";;
    esac
}

# unit NAME CC FLAGS PROGRAM: that program of test/unit and the library, compiled
# so, into $here
COMMON="test/lib/*.c $SHARED"
unit() {
    here=build/units/$(echo "$1" | tr -cd 'a-zA-Z0-9')
    mkdir -p $here
    # shellcheck disable=SC2086 # a list of files
    objects "$2" "$(harness "$3")" $COMMON || return
    common=$OBJECTS
    # (CFLAGS are for the library)
    flags=$3
    [ "$3" != "$CFLAGS" ] || flags=$(harness "$3")
    objects "$2" "$flags" test/unit/$4.c || return
    common="$OBJECTS $common"
    # shellcheck disable=SC2086
    objects "$2" "$3" $LIBRARY &&
        $2 $3 -o $here/$4 $common $OBJECTS $LIBS >> $LOG 2>&1
}

# usual PROGRAM: build/units/usual/PROGRAM; ONLY may have left it out
usual() { [ -x build/units/usual/$1 ] || unit usual "$CC" "$CFLAGS" $1; }

# units NAME CC FLAGS TEST...: each TEST is a program of test/unit and its
# arguments
units() {
    tag=$1
    compiler=$2
    options=$3
    shift 3
    for t in "$@"; do
        wanted "$t, $tag" || continue
        if unit "$tag" "$compiler" "$options" ${t%% *}; then
            many "$t, $tag" $here/$t
        else
            fail "$t, $tag: does not compile"
        fi
    done
}

# quick NAME CC FLAGS PROGRAMS: each of them with -quick
quick() {
    for program in $4; do units "$1" "$2" "$3" "$program -quick"; done
}

if [ "$1" = -unit ]; then
    shift
    program=$1
    if [ ! -f "test/unit/$1.c" ]; then
        echo "no test/unit/$1.c"
        exit 1
    fi
    if ! unit usual "$CC" "$CFLAGS" "$1"; then
        tail -n 20 $LOG
        exit 1
    fi
    shift
    exec $here/$program "$@"
fi

# itself: a program that stops or fails is shown, and how to run it; what is
# skipped, and whether that is a failure; ONLY
itself() {
    echo 'echo so far; exit 7' > build/stops
    echo 'echo "FAILED  a line"; echo "x: 1 passed, 1 failed"; exit 1' \
        > build/fails
    echo 'echo "        skipped: this"; echo "x: 2 passed, 0 failed"' \
        > build/skips
    # those NAMES: the programs, and the counts
    those() {
        begin itself
        for t in $1; do many $t sh build/$t; done
        counts
    }
    { (ONLY=; COMPLETE=; those "stops fails skips")
      (ONLY=kip; COMPLETE=yes; those "stops fails skips"); } > build/itself.txt
    for line in "FAILED  stops: stopped with code 7; its last lines:" \
        "        | so far" "        run it alone: (cd $(pwd) && sh build/stops)" \
        "FAILED  fails: 1 of 2" "FAILED  a line" \
        "        run it alone: (cd $(pwd) && sh build/fails)" \
        "        skipped: skips: this" "3 2 1" \
        "FAILED  skips: this: skipped" "2 1 0"; do
        one "itself: $line" grep -Fx "$line" build/itself.txt
    done
}

for file in builds/language check/units check/examples check/readme \
    check/fortran builds/machines; do
    # shellcheck disable=SC1090
    . test/$file.sh
done

# ---- two halves, neither of which needs what the other one's tests build ----

# parts NAME...: these functions in turn; the log says what each one took, in
# seconds of processors
parts() {
    for p in "$@"; do
        # (in a subshell they would be its own)
        times > $OUT.times
        $p
        times >> $OUT.times
        tr 'ms' '  ' < $OUT.times | awk -v part="$p" '
            { for (i = 1; i < NF; i += 2) t[++n] = 60 * $i + $(i + 1) }
            END { printf "== %s took %.1f s\n", part,
                t[5] + t[6] + t[7] + t[8] - t[1] - t[2] - t[3] - t[4] }' >> $LOG
    done
}
rules() { many "rules" env ALL="$ALL" sh test/rules.sh; }
packages() { many "packages" env CC="$CC" sh test/builds/package.sh; }
# build/tess, by subject
program() {
    for part in driver cells values; do
        many "the driver: $part" env CC="$CC" ALL="$ALL" \
            sh test/cli/t/t_$part.sh
    done
    for part in test/cli/t/test_*.py; do
        part=${part##*/test_}
        part=${part%.py}
        many "the driver: test_$part" env CC="$CC" ALL="$ALL" \
            sh test/cli/t/run.sh -lines $part
    done
}
# the certificates of the search, with builds of their own
certificates() { many "certify" env CC="$CC" sh test/fuzz/certify.sh -check; }
# the table of bounds, with proofs by Gappa
proven() { many "bounds" env CC="$CC" sh test/bounds/bounds.sh -check; }
# hard sets in hard circumstances, likewise
hard() { many "torture" env CC="$CC" sh test/fuzz/torture.sh -check; }
# the facts of the paper's Section 4
paper() {
    many "the paper's experiments" env CC="$CC" CFLAGS="$CFLAGS" \
        sh test/paper/paper.sh -check
}
# (two of about the same length: with -all the second one has more of its own)
first_half() {
    parts itself language symbols packages
    [ -n "$ALL" ] && parts tests builds chapters indices
    parts flagged stacked examples together readme tessn tess89 rules program
}

second_half() {
    [ -z "$ALL" ] && parts tests builds chapters indices
    parts sanitizers rooms standard twins entries parity halves
    [ -z "$ALL" ] && return
    parts machines hard paper peers processes certificates proven
}

if [ "$PROCESSORS" -gt 1 ] 2> /dev/null; then
    # links to the sources, and a build/ of its own, with what `make' has built
    HALF=build/half
    rm -rf $HALF
    mkdir -p $HALF/build
    cp build/tess build/tess.o build/hhpred.o $HALF/build
    for f in *; do
        [ "$f" = build ] || ln -s "../../$f" $HALF
    done
    (
        cd $HALF || exit
        begin second
        second_half
        counts > build/counts
    ) > $HALF/out 2>&1 &
    trap 'kill $! 2> /dev/null; exit 1' INT TERM
    # (a subshell: the times of `parts' are not those of the other half, too)
    (first_half)
    wait $!
    cat $HALF/out
    cat $HALF/$LOG >> $LOG
    if read -r passed failed missing < $HALF/build/counts; then
        count "$passed" "$failed" "$missing"
    else
        fail "the second half: stopped"
    fi
else
    first_half
    second_half
fi
rm -f $OUT*

counts > build/counts
read -r passed failed missing < build/counts
echo "$passed passed, $failed failed, $missing skipped"
if [ "$((passed + failed + missing))" -eq 0 ]; then
    echo "no test has '$ONLY' in its name"
    exit 1
fi
test "$failed" -eq 0
