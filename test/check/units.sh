# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# units.sh - the programs of test/unit, in all builds.

# ---- the unit tests, with builds that decide what they do ----

# All rounding modes, where C99's fenv.h is to be had.
ROUND="-std=c99 -frounding-math -DTEST_ROUNDING -O2"
SANITIZE="-g1 -O1 -fsanitize=address,undefined -fno-sanitize-recover=all"

# arguments: what a program of test/unit does not take it refuses
arguments() {
    for t in "brute -quick" "brute 0" "brute 9 9 9" "brute -one 99 1" \
        "t_cells 9" "t_natural quick" "t_part quick" "t_part -quick 9" \
        "t_pred -quick" "t_facet 0" "t_pred 9x" "t_size -quick" "t_tess quick" \
        "t_tess -sums 0" "t_tess -one uniform" "t_index -quick"; do
        [ -x build/units/usual/${t%% *} ] ||
            unit usual "$CC" "$CFLAGS" ${t%% *} || return
        limited 60 build/units/usual/$t > build/usage 2>&1
        [ $? -eq 2 ] && grep '^usage: ' build/usage || return
    done
}

# worst NAME CC FLAGS STEPS: the worst cases of the bounds that are not
# straight-line, so many tries for each
worst() {
    wanted "worst: $1" || return 0
    fenv=
    have "$CC" "$ROUND" && fenv="-std=c99 -DTEST_ROUNDING"
    # shellcheck disable=SC2086 # a list of files
    if ! have "$2" "$3"; then
        skip "worst: $1"
    elif objects "$CC" -O1 test/lib/exact.c && exact=$OBJECTS &&
        objects "$2" "$3" hhpred.c &&
        build worst.d "$2" "$3 $fenv" test/bounds/worst.c $exact $OBJECTS
    then
        subtest "worst: $1" build/worst.d -steps $4
    else
        fail "worst: $1: does not compile"
    fi
}

# Programs as the library is used; with -all each in whole.
usual() {
    check "units: arguments that are refused" arguments
    if [ -z "$ALL" ]; then
        # (t_tess and t_part run with sanitizers)
        units usual "$CC" "$CFLAGS" "t_pred 20" "t_facet 20" "brute 200" \
            t_size "t_natural -brief" "t_cells -brief"
    else
        units usual "$CC" "$CFLAGS" t_pred t_facet brute t_resume t_check \
            t_locate t_range t_size t_natural t_cells
    fi
}
usual_large() { units usual "$CC" "$CFLAGS" t_tess t_part t_query; }

# Few limbs: code 2 or TESS_RANGE where they do not suffice.  (Lists of other
# capacities only look elsewhere first.)
limits() {
    units -DHH_LIMBS=3 "$CC" "-O1 -DHH_LIMBS=3" "t_pred 50" "t_facet 50" \
        "brute 100" t_range "t_part -quick" "t_query -quick"
    for t in $MESHES; do
        units -DTESS_LIST=48 "$CC" "-O1 -DTESS_LIST=48" "$t -quick"
    done
    units -DTESS_CORE "$CC" "-O1 -DTESS_CORE" "brute 100"
    for list in 48 128 252 4096; do
        units -DTESS_LIST=$list "$CC" "-O1 -DTESS_LIST=$list" "brute 60"
    done
}

# Builds that decide otherwise.
types() {
    if [ -z "$ALL" ]; then
        units -DHH_LIMBS=3 "$CC" "-O1 -DHH_LIMBS=3" "t_pred 10" "brute 100" \
            "t_facet 10"
        # (both types in one build)
        units "-DTESS_INT=short -DTESS_FLOAT" "$CC" \
            "-O1 -DTESS_INT=short -DTESS_FLOAT" "t_pred 10" "t_facet 10" \
            "brute 100" t_size
        return
    fi
    if have "$CC" "-include test/builds/machines/short.h"; then
        check "units: doubles of 24 bits, flushed" sh -c "$CC -O1 -include \
            test/builds/machines/short.h -o build/short \
            test/builds/machines/short.c $LIBRARY -lm && build/short"
    else
        skip "units: doubles of 24 bits, flushed"
    fi
    if have "$CC" -mfpmath=387; then
        units "a unit of 24 bits" "$CC" "-O1 -mfpmath=387 -DTEST_X87" t_range
    else
        skip "units: an x87 unit of 24 bits"
    fi
    units "-DTESS_INT=short -DTESS_LIST=48" "$CC" \
        "-O1 -DTESS_INT=short -DTESS_LIST=48" "brute 100" t_size
    units -DHH_LIMBS=6 "$CC" "-O1 -DHH_LIMBS=6" t_range
    units -DTESS_FLOAT "$CC" "-O1 -DTESS_FLOAT" "t_pred 50" "t_facet 50" \
        "brute 100" "t_part -quick" "t_query -quick"
    units -DTESS_INT=short "$CC" "-O1 -DTESS_INT=short" "brute 100" t_size
    units -DTESS_INT=long "$CC" "-O1 -DTESS_INT=long" "brute 100" t_size
    if have "$CC" "$ROUND"; then
        units "all rounding modes" "$CC" "$ROUND" "t_pred 10" "t_facet 10"
    else
        skip "all rounding modes"
    fi
    if have "$CC" -mfpmath=387; then
        units x87 "$CC" "-O2 -mfpmath=387" "t_pred 10" "t_facet 10"
    else
        skip "x87"
    fi
}

worsts() {
    if [ -z "$ALL" ]; then
        worst usual "$CC" -O1 1500
        return
    fi
    worst usual "$CC" "$CFLAGS" 8000
    worst x87 "$CC" "-O2 -mfpmath=387" 5000
    worst "$CC -Ofast -march=native" "$CC" "-Ofast -march=native" 5000
    worst "clang -ffp-contract=fast" clang \
        "-O2 -ffp-contract=fast -march=native" 5000
}

# An index serves in other builds and rounding modes than the one that made it.
# indexed NAME CC FLAGS: another build to make and to read them.
indexed() {
    if ! have "$2" "$3"; then
        skip "indices: $1"
        return
    fi
    made=$((made + 1))
    objects "$CC" "$rounding" test/unit/t_index.c test/lib/points.c \
        test/lib/exact.c
    reader=$OBJECTS
    # shellcheck disable=SC2086 # lists of files
    if objects "$2" "$3" $LIBRARY && build indexed/read$made "$CC" "$rounding" \
        $reader $OBJECTS && build/indexed/read$made write \
        build/indexed/$made; then
        echo "$1" > build/indexed/name$made
    else
        fail "indices: $1"
    fi
}

indices() {
    group "indices: " || return
    made=0
    rounding=-O1
    have "$CC" "$ROUND" && rounding=$ROUND
    rm -rf build/indexed
    mkdir build/indexed
    if [ -n "$ALL" ]; then
        indexed "$CC -O2" "$CC" -O2
    else
        indexed "$CC $CFLAGS" "$CC" "$CFLAGS"
    fi
    indexed "$CC -Ofast" "$CC" "-Ofast -march=native"
    if [ -n "$ALL" ]; then
        indexed "x87" "$CC" "-O2 -mfpmath=387"
        indexed "short lists" "$CC" "-O1 -DTESS_LIST=48"
        indexed "clang" clang "-O2 -ffp-contract=fast"
        indexed "lists of 128" "$CC" "-O2 -DTESS_LIST=128"
        indexed "10 limbs" "$CC" "-O2 -DHH_LIMBS=10"
    fi
    # each reads its own, and those of the next two
    by=0
    while [ $by -lt $made ]; do
        these=
        names=
        for k in 0 1 2; do
            these="$these build/indexed/$(((by + k) % made + 1))"
            names="$names $(cat build/indexed/name$(((by + k) % made + 1)));"
        done
        by=$((by + 1))
        # shellcheck disable=SC2086 # a list of files
        subtest "indices: of$names by the first" build/indexed/read$by $these
    done
}

# ---- floating-point flags, and the stack ----

# flags NAME LINK OBJECT...: t_flags with that half, with -all one build in whole
FENV="-std=gnu99 -DTEST_FLAGS -O1"
flags() {
    flagged=$1
    linker=$2
    shift 2
    less=$LESS
    [ "$ALL$flagged" = "yes$CC -O2" ] && less=
    # shellcheck disable=SC2086 # a list of files
    if $linker -o build/flags/t_flags $flagtest "$@" $LIBS >> $LOG 2>&1
    then
        # shellcheck disable=SC2086 # an option, or none
        subtest "flags: $flagged" build/flags/t_flags $less
    else
        fail "flags: $flagged: does not link"
    fi
}

# flagtest: what is linked to each half; 1 where it cannot be had
flagtest() {
    echo '#include <fenv.h>
int main(void) { return feenableexcept(FE_INVALID) == -1; }' > build/have.c
    mkdir -p build/flags
    # shellcheck disable=SC2086
    $CC $FENV -D_GNU_SOURCE -o build/have build/have.c -lm >> $LOG 2>&1 &&
        build/have && objects "$CC" "$FENV" test/unit/t_flags.c &&
        flagtest=$OBJECTS && objects "$CC" -O1 $COMMON &&
        flagtest="$flagtest $OBJECTS"
}

flagged() {
    group "flags: " || return
    if ! flagtest; then
        skip "flags: no fenv.h, or no traps"
        return
    fi
    if [ -z "$ALL" ]; then
        # shellcheck disable=SC2086 # a list of files
        if objects "$CC" "$CFLAGS" $LIBRARY; then
            flags "$CC $CFLAGS" "$CC" $OBJECTS
        else
            fail "flags: $CC $CFLAGS: does not compile"
        fi
        return
    fi
    # (clang has vectors at -O2, too)
    for c in "$CC -O2" "clang -O2" "$CC -O3"; do
        wanted "flags: $c" || continue
        if ! have "${c% *}" "${c##* }"; then
            skip "flags: $c"
        elif objects "${c% *}" "${c##* }" $LIBRARY; then
            flags "$c" "$CC" $OBJECTS
        else
            fail "flags: $c: does not compile"
        fi
    done
}

# trapping LEVEL: build/fLEVELtess.o, build/fLEVELhhpred.o, compiled once.  (What
# traps does not alter the code, and the figures for the stack are these.)
trapping() {
    [ -f build/f$1hhpred.o ] ||
        gfort build/f$1 $1 -ffpe-trap=invalid,zero,overflow >> $LOG 2>&1
}

# the FORTRAN half
flagged77() {
    group "flags: FORTRAN 77" || return
    if ! flagtest; then
        skip "flags: FORTRAN 77: no fenv.h, or no traps"
        return
    fi
    objects "$CC" -O1 test/twin/shim.c
    for o in -O2 -O3; do
        wanted "flags: FORTRAN 77, gfortran $o" || continue
        if trapping $o; then
            flags "FORTRAN 77, gfortran $o" gfortran $OBJECTS build/f${o}tess.o \
                build/f${o}hhpred.o
        else
            fail "flags: FORTRAN 77, gfortran $o: does not compile"
        fi
    done
}

# stacktest OPTIONS: t_stack by $CC, and whether this is the machine that the
# manuals' figures are for; 1 where it cannot be had
stacktest() {
    echo '#ifdef __clang__
#error
#endif
int main(void) { return !(__GNUC__ && __x86_64__); }' > build/have.c
    mkdir -p build/stack
    $CC -pthread -o build/have build/have.c >> $LOG 2>&1 && build/have &&
        objects "$CC" "-O2 -pthread -DTEST_STACK $1" test/unit/t_stack.c &&
        stacktest=$OBJECTS && objects "$CC" -O1 test/lib/points.c \
        test/lib/exact.c && stacktest="$stacktest $OBJECTS"
}

# stack NAME USUAL ANY COMPILER OBJECT...: the figures that a manual has, in KB
# of 1000 bytes, bound what is measured, and are not far above
stack() {
    name="stack: $1: $2 KB, $3 KB"
    usual=$2
    any=$3
    linker=$4
    shift 4
    # shellcheck disable=SC2086 # a list of files
    $linker -pthread -o build/stack/t_stack $stacktest "$@" $LIBS \
        >> $LOG 2>&1 && build/stack/t_stack > build/stack.txt
    cat build/stack.txt >> $LOG
    check "$name" awk -v usual="$usual" -v any="$any" '
        function fits(said, is) {
            return is <= 1000 * said && 1000 * said <= 1.08 * is + 1000
        }
        { print }
        $1 == "most" { good = fits(usual, $2) && fits(any, $3) }
        END { exit !good }' build/stack.txt
}

# stacks FILE: of the manual's table the figures, and what they are for
stacks() {
    sed -n 's/^[ *]*\([^ ].*[^ ]\)  *\([0-9]*\) KB  *\([0-9]*\) KB$/\2 \3 \1/p' $1
}

stacked() {
    group "stack: " || return
    stacks tess.h > build/stacks.txt
    check "stack: tess.h's figures" test "$(wc -l < build/stacks.txt)" -eq 3
    while read -r usual any options; do
        [ "$options" = none ] && options=
        if ! stacktest "$options"; then
            skip "stack: no gcc with threads on x86-64"
            return
        fi
        objects "$CC" "-O2${options:+ $options}" $LIBRARY
        # shellcheck disable=SC2086
        stack "$CC -O2 $options" $usual $any "$CC" $OBJECTS
    done < build/stacks.txt
}

stacked77() {
    group "stack: FORTRAN 77" || return
    stacks f77/README > build/stacks.txt
    check "stack: FORTRAN 77: the manual's figures" \
        test "$(wc -l < build/stacks.txt)" -eq 3
    while read -r usual any parameters; do
        case $parameters in *HHLIM*) options=-DHH_LIMBS=${parameters##* };;
        *) options=;; esac
        if ! stacktest "$options"; then
            skip "stack: FORTRAN 77: no gcc with threads on x86-64"
            return
        fi
        rm -f build/stack/*.o
        compile "$CC" "-O2 $options -DTEST_STACK" build/stack test/twin/shim.c
        echo "$parameters" | tr , '\012' |
            sed -n 's/^ *\([A-Z]*\) = \([0-9]*\)$/s,\1 = [0-9]*,\1 = \2,/p' \
            > build/stacks.sed
        if [ -s build/stacks.sed ]; then
            for half in tess hhpred; do
                sed -f build/stacks.sed f77/$half.f > build/stack/$half.f
                gfortran -frecursive -O2 -c -o build/stack/f$half.o \
                    build/stack/$half.f >> $LOG 2>&1
            done
        else
            trapping -O2 && cp build/f-O2tess.o build/f-O2hhpred.o build/stack
        fi
        stack "FORTRAN 77, gfortran -O2, $parameters" $usual $any gfortran \
            build/stack/*.o
    done < build/stacks.txt
}

sanitizers() {
    if have "$CC" "$SANITIZE"; then
        check "sanitizers: what is read behind an array is told" behind
        units sanitizers "$CC" "$SANITIZE" "brute 50"
        for t in $MESHES t_part t_query; do
            units sanitizers "$CC" "$SANITIZE" "$t $LESS"
        done
    else
        skip "sanitizers"
        for t in $MESHES t_part t_query; do
            units usual "$CC" "$CFLAGS" "$t $LESS"
        done
    fi
}

# behind: with what programs of tests share, as sanitizers have it, is a byte
# that is read behind an array told, and none in it?
behind() {
    cat > build/behind.c <<END
#include "test/unit/lib/guard.h"
int main(int argc, char **argv)
{
    return argv[0] == 0 || ((volatile char *)array(7))[5 + argc] == 0;
}
END
    # shellcheck disable=SC2086 # a list of files
    unit sanitizers "$CC" "$SANITIZE" brute &&
        guard=$(echo "$common" | tr ' ' '\012' | grep '/guard[.]o$') &&
        $CC $SANITIZE -I. -o build/behind build/behind.c $guard &&
        build/behind && ! build/behind more 2> build/behind.txt &&
        grep AddressSanitizer build/behind.txt
}

# ---- that every call ends ----

# ending NAME SUM LINK ARGUMENT OBJECT...: t_room with that half; into SUM the sum of
# all codes
ending() {
    name="room: $1"
    wanted "$name" || return
    into=$2
    linker=$3
    argument=$4
    shift 4
    # shellcheck disable=SC2086 # lists of files
    if $linker -o build/room/t_room $roomtest "$@" $LIBS >> $LOG 2>&1; then
        subtest "$name" build/room/t_room $argument
        sed -n 's/.* their sum is //p' "$SAID" > $into
    else
        fail "$name: does not link"
    fi
}

# (an option of gcc's and clang's, for every language)
COUNTED="-O1 -fsanitize-coverage=trace-pc"
rooms() {
    group "room: " || return
    rm -rf build/room
    mkdir -p build/room
    less=$LESS
    [ -n "$ALL" ] && less=32
    echo 'int twice(int n) { return 2 * n; }' > build/have.c
    # shellcheck disable=SC2086
    if ! $CC $COUNTED -c -o build/have.o build/have.c >> $LOG 2>&1; then
        skip "room: steps that are not counted"
        return
    fi
    # shellcheck disable=SC2086
    objects "$CC" -O1 test/unit/t_room.c $COMMON
    roomtest=$OBJECTS
    # shellcheck disable=SC2086
    objects "$CC" "$COUNTED" $LIBRARY
    ending C build/room/c "$CC" "$less" $OBJECTS
    if [ -n "$ALL" ]; then
        # shellcheck disable=SC2086
        objects "$CC" "$COUNTED -DTESS_PROVE" $LIBRARY
        ending proven build/room/proven "$CC" -prove $OBJECTS
    fi
    [ -n "$ALL" ] || return
    if ! command -v gfortran > /dev/null; then
        skip "room: no gfortran"
        return
    fi
    # shellcheck disable=SC2086
    gfort build/room/f $COUNTED >> $LOG 2>&1
    objects "$CC" -O1 test/twin/shim.c
    ending "FORTRAN 77" build/room/f gfortran "$less" $OBJECTS \
        build/room/ftess.o build/room/fhhpred.o
    [ ! -s build/room/c ] || [ ! -s build/room/f ] ||
        check "room: the same codes from C and FORTRAN" \
            cmp build/room/c build/room/f
}

# ---- the same arrays from every build ----
#
# The test itself and its points are compiled once, so that compilers'
# roundings in making the points do not count.

# same NAME CC FLAGS
same() {
    name="same result: $1"
    wanted "$name" || return
    if ! have "$2" "$3"; then
        skip "$name"
        return
    fi
    # (as C++ all of it: the objects of C cannot be linked to that)
    case $3 in
    *c++*) build sums1 "$2" "$3" test/unit/t_tess.c $COMMON $LIBRARY;;
    *) objects "$2" "$3" $LIBRARY && $2 $3 -o build/sums1 $sums $shares $OBJECTS \
        $LIBS >> $LOG 2>&1;;
    esac || {
        fail "$name: does not compile"
        return
    }
    build/sums1 -sums $few > build/sums1.txt 2>> $LOG
    check "$name" cmp build/sums.txt build/sums1.txt
}

builds() {
    group "same result: " || return
    few=
    [ -n "$ALL" ] || few=300
    unit usual "$CC" "$CFLAGS" t_tess
    # shellcheck disable=SC2086 # a number, or none
    build/units/usual/t_tess -sums $few > build/sums.txt
    check "same result: checksums" test -s build/sums.txt
    # shellcheck disable=SC2086 # a list of files
    objects "$CC" -O1 $COMMON
    shares=$OBJECTS
    objects "$CC" -O1 test/unit/t_tess.c
    sums=$OBJECTS
    same "$CC -Ofast -march=native" "$CC" "-Ofast -march=native"
    [ -z "$ALL" ] && return
    same "$CC -mfpmath=387" "$CC" "-O2 -mfpmath=387"
    # at this size a list's bounds are rounded in view of the points
    subtest "same result: t_tess, a narrow cluster" build/units/usual/t_tess -one lastplaces \
        1500 1
    # what only a processor that takes subnormal numbers for zero brings about
    for t in $MESHES; do
        objects "$CC" -O1 test/unit/$t.c
        sums=$OBJECTS
        objects "$CC" "-Ofast -march=native" $LIBRARY
        # shellcheck disable=SC2086 # lists of files
        build flushed "$CC" "-Ofast -march=native" $sums $shares $OBJECTS
        subtest "same result: $t, subnormal numbers flushed" build/flushed -quick
    done
    objects "$CC" -O1 test/unit/t_tess.c
    sums=$OBJECTS
    # (-O0: parity)
    same "$CC -O2" "$CC" "-O2"
    same "$CC -O3 -funroll-loops -ffp-contract=fast -march=native" "$CC" \
        "-O3 -funroll-loops -ffp-contract=fast -march=native"
    same "clang -Ofast" clang "-Ofast"
    same "tcc" tcc ""
    same "g++ -x c++ -O2" g++ "-x c++ -O2"
}

# ---- part II of tess.c: each chapter may be left out alone ----

# left MACRO...: the routines of tess.c that are left where these are defined:
# those of a chapter stand between `#ifndef MACRO' and an #endif
left() {
    awk -v macros=" $* " '
        /^#if/ { depth++ }
        /^#ifndef TESS_/ && index(macros, " " $2 " ") { out[depth] }
        /^#endif/ { delete out[depth--] }
        /^[a-z][a-z_ ]* [*]*[a-z_0-9]*\(/ {
            name = $0; sub(/\(.*/, "", name); sub(/.*[ *]/, "", name) }
        /;$/ { name = "" }
        /^{/ && name != "" {
            some = 0
            for (k in out) some = 1
            if (!some) print name
            name = ""
        }' tess.c | sort
}

# (without inlining all routines are to be seen)
WHOLE="-O1 -fno-inline"
chapters() {
    group "chapters: " || return
    have "$CC" "$WHOLE" || WHOLE=-O1
    few=300
    [ -n "$ALL" ] || few=150
    unit usual "$CC" "$CFLAGS" t_tess
    build/units/usual/t_tess -sums $few > build/sums.txt
    check "chapters: checksums" test -s build/sums.txt
    # shellcheck disable=SC2086 # a list of files
    objects "$CC" -O1 $COMMON test/unit/t_tess.c
    sums=$OBJECTS
    macros=$(sed -n 's/^#ifndef \(TESS_NO_[A-Z_]*\)$/\1/p' tess.c | sort -u)
    check "chapters: macros that leave one out" test "$(echo $macros | wc -w)" -ge 7
    [ -n "$ALL" ] || macros=
    for macro in TESS_CORE $macros; do
        wanted "chapters: -D$macro" || continue
        if have "$CC" "$STRICT"; then
            check "chapters: -D$macro: strict C89" $CC $STRICT -D$macro \
                -fsyntax-only tess.c
        fi
        if ! objects "$CC" "$WHOLE -D$macro" $LIBRARY ||
            ! $CC $WHOLE -o build/sums1 $sums $OBJECTS $LIBS >> $LOG 2>&1; then
            fail "chapters: -D$macro: does not compile"
            continue
        fi
        # (one that is left out may leave out others)
        # shellcheck disable=SC2046 # words
        left $($CC -D$macro -E -dM tess.c |
            sed -n 's/^#define \(TESS_CORE\|TESS_NO_[A-Z_]*\).*/\1/p') \
            > build/left.txt
        for object in $OBJECTS; do break; done
        if [ "$WHOLE" != -O1 ] && nm $object > build/nm.txt 2>> $LOG; then
            sed -n 's/^.* [tT] _*\([a-z]\)/\1/p' build/nm.txt | sort > build/have.txt
            check "chapters: -D$macro: its routines are left out, no others" \
                diff build/left.txt build/have.txt
        fi
        build/sums1 -sums $few > build/sums1.txt 2>> $LOG
        check "chapters: -D$macro: the same arrays" cmp build/sums.txt \
            build/sums1.txt
    done
}
