#!/bin/sh
# check.sh [-all] - the tests; run from the top directory.
# check.sh [-all] -part NAME - a part of them alone: it prints TAP, for prove.
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
#                   `recipes: ', in the group's; or a part, by its name
#   COMPLETE=yes    what is skipped has failed
#   PROCESSORS=1    all in turn; else so many parts at the same time
# Prints a line for each program of tests, and for the tests of each part that
# are none: how many have been passed, and what they took, in seconds of a
# processor; below it those that have failed.  Then what a machine lacks
# (compilers, sanitizers, Fortran), which is skipped, and the last line `N
# passed, N failed, N skipped'.  All output is in build/check.log.
. test/tests.sh
ALL=
if [ "$1" = -all ]; then
    ALL=yes
    shift
fi
case $1 in
'' | -part | -unit) ;;
*)
    sed -n '2,/^# test\/README/s/^# \{0,1\}//p' test/check.sh
    exit 2
    ;;
esac
# of a program of tests that has quick forms the one that is run where it is not
# run in whole
# shellcheck disable=SC2034 # for the files of test/check
if [ -n "$ALL" ]; then LESS=-quick; else LESS=-brief; fi
CFLAGS=${CFLAGS:--O2}
LIBS=-lm
LIBRARY="tess.c hhpred.c"
LOG=build/check.log
# shellcheck disable=SC2034 # for the files of test/check
STRICT="-std=c89 -pedantic-errors -Wall -Wextra -Wshadow -Wconversion -Werror"
# (make has its options for those that it calls)
unset MAKEFLAGS MFLAGS MAKELEVEL

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

# place FLAGS: the directory for what is compiled so
place() { echo build/objects/"$(echo "$1" | tr -cd 'a-zA-Z0-9=')"; }

# objects CC FLAGS FILE...: $OBJECTS, each compiled with these flags once in a run:
# build/objects is one for all parts.
objects() {
    with="$1 $2"
    kept=$(place "$with")
    shift 2
    mkdir -p $kept
    OBJECTS=
    for source in "$@"; do
        object=$kept/$(basename $source .c).o
        if [ ! -f $object ]; then
            echo "== $with -c $source" >> $LOG
            $with -I. -c -o $object.$$ $source >> $LOG 2>&1 &&
                mv $object.$$ $object || return 1
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
    flags=$3
    # (CFLAGS are for the library)
    [ "$3" != "$CFLAGS" ] || flags=$(harness "$3")
    case $3 in
    *=address*)
        # (what is read beside an array is seen if that has its very length)
        common=$(echo " $common " | sed 's, [^ ]*/guard[.]o , ,')
        objects "$2" "$(harness "$3") -DEXACT" test/unit/lib/guard.c || return
        common="$common $OBJECTS"
        # (its own arithmetic a test is asked for in -all)
        [ -n "$ALL" ] || flags=$(echo "$3" | sed 's/,undefined//');;
    esac
    objects "$2" "$flags" test/unit/$4.c || return
    common="$OBJECTS $common"
    # shellcheck disable=SC2086
    objects "$2" "$3" $LIBRARY &&
        $2 $3 -o $here/$4 $common $OBJECTS $LIBS >> $LOG 2>&1
}

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
            subtest "$t, $tag" $here/$t
        else
            fail "$t, $tag: does not compile"
        fi
    done
}

if [ "$1" = -unit ]; then
    shift
    program=$1
    if [ ! -f "test/unit/$1.c" ]; then
        echo "no test/unit/$1.c"
        exit 1
    fi
    rm -rf build/objects build/units
    mkdir -p build
    : > $LOG
    if ! unit usual "$CC" "$CFLAGS" "$1"; then
        tail -n 20 $LOG
        exit 1
    fi
    shift
    exec $here/$program "$@"
fi

for file in builds/language check/units check/examples check/readme \
    check/fortran check/itself builds/machines; do
    # shellcheck disable=SC1090
    . test/$file.sh
done

# ---- the parts, none of which needs what another one builds ----

rules() { subtest "rules" env ALL="$ALL" sh test/rules.sh; }
packages() { subtest "packages" env CC="$CC" ALL="$ALL" sh test/builds/package.sh; }
# the certificates of the search, with builds of their own
certificates() {
    how=-quick
    [ -z "$ALL" ] || how=-check
    subtest "certify" env CC="$CC" sh test/fuzz/certify.sh $how
}
# the table of bounds, with proofs by Gappa
proven() { subtest "bounds" env CC="$CC" sh test/bounds/bounds.sh -check; }
# hard sets in hard circumstances, with builds of their own
hard() { subtest "torture" env CC="$CC" sh test/fuzz/torture.sh -check; }
# the facts of the paper's Section 4
paper() {
    subtest "the paper's experiments" env CC="$CC" CFLAGS="$CFLAGS" \
        sh test/paper/paper.sh -check
}
# make, and how it is run
tarball() { subtest "tarball" sh test/builds/tarball.sh; }
# build/tess, by subject: cli_NAME is test/cli/t/test_NAME.py
program() {
    subtest "the driver: $1" env CC="$CC" ALL="$ALL" sh test/cli/t/run.sh $1
}
PROGRAM=$(ls test/cli/t/test_*.py | sed 's,.*/test_\(.*\)\.py,cli_\1,')

# (what takes longest comes first)
MORE=
[ -z "$ALL" ] || MORE="usual_large limits machines processes certificates hard
    half_options peers half_f2c half_chapters half_types half_flags paper tarball
    proven stacked"
PARTS="$MORE sanitizers bindings $PROGRAM half_checked packages usual types
    flagged examples certificates half_recipes readme half_callers rooms builds
    language worsts indices chapters together prefixes rules parity standard
    symbols twins entries itself signals"

# report PART: what it has printed is in build/parts/PART.tap; a line for each
# program, one for all else, what has failed, and how to run it alone
report() {
    awk -v part=$1 -v complete="$COMPLETE" -v counts=build/parts/counts \
        -v skips=build/parts/skips -v alone="$(quoted "CC=$CC" \
        "CFLAGS=$CFLAGS" sh test/check.sh) ${ALL:+-all }-part $1" '
        # a line of the program, or of the part (at 0)
        function show(at, words) {
            if (++lines[at] <= 40) shown[at] = shown[at] "        " words "\n"
        }
        function flush(at, title, seconds) {
            if (failed[at])
                printf "FAILED  %s: %d of %d, %.0f s\n%s", title, failed[at],
                    failed[at] + passed[at], seconds, shown[at]
            else if (passed[at])
                printf "ok      %s: %d, %.0f s\n", title, passed[at], seconds
            good += passed[at]
            bad += failed[at]
            passed[at] = failed[at] = lines[at] = 0
            shown[at] = ""
        }
        {
            depth = 0
            for (text = $0; text ~ /^    /; depth++) text = substr(text, 5)
            at = depth > 0 || open[0]
        }
        ended && !(depth == 0 && text ~ /^# [r|]/) {
            flush(1, title, took)
            ended = 0
        }
        text ~ /^# Subtest: / {
            open[depth] = 1
            wrong[depth] = 0
            if (depth == 0) title = substr(text, 12)
            next
        }
        depth == 0 && text ~ /^# took [0-9.]* s$/ {
            if (open[0]) {
                took = substr(text, 8) + 0
                others += took
            } else all = substr(text, 8) + 0
            next
        }
        text ~ /^1\.\.[0-9]/ {
            if (depth == 0) plan = substr(text, 4) + 0
            next
        }
        text ~ /^(not )?ok( |$)/ {
            is_bad = text ~ /^not/
            if (depth == 0) n++
            closes = open[depth]
            open[depth] = 0
            showing = 0
            if (text ~ /^ok [0-9]+ # SKIP/ && !complete) {
                sub(/.*# SKIP */, "", text)
                print (at ? title ": " : "") text >> skips
                skipped++
                next
            }
            if (text ~ /^ok [0-9]+ # SKIP/) is_bad = 1
            # (of a program whose tests have failed not itself once more)
            if (!closes || is_bad && !wrong[depth])
                if (is_bad) failed[at]++
                else passed[at]++
            if (is_bad) {
                for (d = 0; d < depth; d++) wrong[d] = 1
                if (!closes || !wrong[depth]) show(at, text)
                showing = 1
            }
            if (closes && depth == 0) ended = 1
            next
        }
        text ~ /^#/ {
            if (showing && text !~ /^# took /) {
                sub(/^# /, "", text)
                show(at || ended, text)
            }
            next
        }
        # (of a program that is not TAP, below a test that has failed)
        depth == 0 { show(0, "| " text) }
        END {
            if (ended) flush(1, title, took)
            if (plan == "" || plan != n) {
                failed[0]++
                show(0, "stopped behind " n + 0 " tests")
                if (open[0]) show(0, "in " title)
            }
            if (failed[0]) show(0, "run it alone:" alone)
            flush(0, part, all > others ? all - others : 0)
            print good + 0, bad + 0, skipped + 0 >> counts
        }' build/parts/$1.tap
    {
        echo "== $1 took $(sed -n 's/^# took //p' build/parts/$1.tap | tail -n 1)"
        cat build/parts/$1/build/check.log
    } >> $LOG
}

# ---- a part alone ----

if [ "$1" = -part ]; then
    part=$2
    case " $(echo $PARTS) " in
    *" $part "*) ;;
    *)
        echo "Bail out! check.sh has no part $part"
        exit 1;;
    esac
    # links to the sources, and a build/ of its own, with what `make' has built
    [ -n "$POOL" ] || rm -rf build/parts build/objects
    mkdir -p build/objects build/parts/$part/build
    for file in * .[a-z]*; do
        case $file in
        build | .git) ;;
        *) ln -s "$(pwd)/$file" build/parts/$part;;
        esac
    done
    ln -s "$(pwd)/build/objects" build/parts/$part/build
    for file in build/tess build/*.o; do
        case $part$file in
        cli_* | readme* | *build/tess | *build/tess.o | *build/hhpred.o)
            [ ! -f "$file" ] || cp "$file" build/parts/$part/build;;
        esac
    done
    cd build/parts/$part || exit
    [ "$ONLY" != $part ] || ONLY=
    begin part.$part
    : > $LOG
    [ -f build/tess.o ] ||
        { objects "$CC" "$CFLAGS" $LIBRARY && cp $OBJECTS build; }
    case $part in
    cli_*) program ${part#cli_};;
    *) $part;;
    esac
    rm -f "$SAID"
    times > build/times
    tr ms '  ' < build/times | awk '{ s += 60 * $1 + $2 + 60 * $3 + $4 }
        END { printf "# took %.1f s\n", s }'
    ended
    exit
fi

# ---- all of them ----

# work: parts that nobody has begun, until there is none
work() {
    child=
    trap 'kill -s TERM -- "-$child" 2> /dev/null; exit 1' TERM
    for part in $PARTS; do
        mkdir build/parts/$part 2> /dev/null || continue
        # shellcheck disable=SC2086 # an option, or none
        POOL=yes $APART sh test/check.sh ${ALL:+-all} -part $part \
            < /dev/null > build/parts/$part.tap 2>&1 &
        child=$!
        wait $child
        until mkdir build/parts/speaks 2> /dev/null; do sleep 1; done
        report $part
        rmdir build/parts/speaks
    done
}

rm -rf build/parts build/objects build/units
mkdir -p build/parts build/objects
# (with the flags in MADE `make' has compiled the library, and recipes)
if [ "${MADE:-}" = "$CC $CFLAGS" ]; then
    mkdir -p "$(place "$MADE")"
    for source in $LIBRARY test/recipes/*.c; do
        object=build/$(basename "$source" .c).o
        [ ! -f "$object" ] || cp "$object" "$(place "$MADE")"
    done
fi
: > $LOG
: > build/parts/counts
: > build/parts/skips
APART=build/apart
$CC -o build/apart test/check/apart.c >> $LOG 2>&1 || APART=
export CC CFLAGS ONLY COMPLETE PYTHON
PROCESSORS=${PROCESSORS:-$(getconf _NPROCESSORS_ONLN 2> /dev/null)}
workers=
while :; do
    work &
    workers="$workers $!"
    [ "$PROCESSORS" -gt 1 ] 2> /dev/null || break
    PROCESSORS=$((PROCESSORS - 1))
done
trap 'kill $workers 2> /dev/null; exit 1' HUP INT TERM
# shellcheck disable=SC2086 # numbers
wait $workers
sed 's/^/        skipped: /' build/parts/skips
awk '{ p += $1; f += $2; s += $3 }
    END { printf "%d passed, %d failed, %d skipped\n", p, f, s
        if (p + f + s == 0) exit 2
        exit f > 0 }' build/parts/counts
code=$?
[ $code -ne 2 ] || echo "no test has '$ONLY' in its name"
test $code -eq 0
