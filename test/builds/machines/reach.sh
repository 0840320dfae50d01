#!/bin/sh
# reach.sh - on which machines and compilers tess gives the same arrays, and
# what it takes on small ones; writes test/results/reach.txt.
#
# Run from the top directory: make reach.  Toolchains are Debian's; the packages
# are named in .ci/run and below.  One that is missing is a row that says so.
#
#   gcc clang tcc pcc g++ gfortran flang-19 qemu-user qemu-system-arm simavr
#   gcc-{i686,m68k,alpha,powerpc64,arm,aarch64,riscv64}-linux-gnu{,hf} with
#   their libc; gcc-mingw-w64-x86-64 wine64 wine
#   gcc-arm-none-eabi libnewlib-arm-none-eabi gcc-avr avr-libc lld nodejs
. test/tests.sh
LIBRARY="tess.c hhpred.c"
B=build/reach
BAD=0
rm -rf $B
mkdir -p $B

there() { command -v "$1" > /dev/null; }
checksum() { cksum < "$1" | sed 's/ .*//'; }

# What all must write: the arrays of tiny.c's four sets, and of parity.c's many.
$CC -O0 -DTESS_FLOAT -o $B/tiny test/builds/machines/tiny.c $LIBRARY -lm &&
    $B/tiny > $B/tiny.txt
SUM=`checksum $B/tiny.txt`
$CC -O0 -o $B/parity test/twin/parity.c $LIBRARY -lm && $B/parity \
    > $B/parity.txt
PARITY=`checksum $B/parity.txt`
sh test/twin/sums.sh $B/parity.txt test/twin/parity.txt || BAD=1

# ran PROGRAM FILE: what it prints, lines ended as here
ran() {
    # (mingw's programs have another name)
    [ ! -f "$1.exe" ] || mv "$1.exe" "$1"
    # shellcheck disable=SC2086
    $run "$1" 2>> $B/log | tr -d '\r' > "$2"
}

# agree: is what has been run the same? Counts the compiler, but its
# architecture's prefix, and the architecture
: > $B/compilers
: > $B/architectures
agree() {
    if [ "$tiny" != $SUM ] || [ "$parity" != $PARITY ]; then
        BAD=1
        same="**another**"
        return
    fi
    same="the same"
    echo "$ARCHITECTURE" >> $B/architectures
    case $1 in
    *gcc | *g++) echo gcc;;
    *flang*) echo flang;;
    *) echo "$1";;
    esac >> $B/compilers
}

# row NAME RUNNER COMPILE...: a row of the table of machines
row() {
    name=$1
    run=$2
    shift 2
    if ! there "$1" || { [ -n "$run" ] && ! there "$run"; }; then
        echo "| $name | not to be had | | |"
        return
    fi
    case $run in qemu*) run="$run -L $SYSROOT";; esac
    rm -f $B/out*
    "$@" -DTESS_FLOAT -o $B/out test/builds/machines/tiny.c $LIBRARY -lm \
        2>> $B/log &&
        ran $B/out $B/out.txt
    tiny=`checksum $B/out.txt`
    # -Ofast makes no infinities and NaNs
    parity=test/twin/parity.c
    case "$*" in *-Ofast*)
        parity=$B/parity.o
        $1 -O1 -c -o $parity test/twin/parity.c;;
    esac
    "$@" -o $B/out2 $parity $LIBRARY -lm 2>> $B/log && ran $B/out2 $B/out2.txt
    parity=`checksum $B/out2.txt`
    agree "$1"
    echo "| $name | $tiny | $parity | $same |"
}

# frow NAME COMPILE...: the same of the FORTRAN half, by shim.c
frow() {
    name=$1
    shift
    if ! there "$1"; then
        echo "| $name | not to be had | | |"
        return
    fi
    rm -f $B/out*
    for f in parity shim; do $CC -O1 -c -o $B/$f.o test/twin/$f.c; done
    (cd $B && "$@" -o out2 parity.o shim.o ../../f77/tess.f \
        ../../f77/hhpred.f -lm) 2>> $B/log
    run=
    ran $B/out2 $B/out2.txt
    parity=`checksum $B/out2.txt`
    tiny=$SUM
    agree "$1"
    echo "| $name | | $parity | $same |"
}

machines() {
    echo "| compiler, machine | 4 small sets | `wc -l < $B/parity.txt |
        tr -d ' '` lines of results | |"
    echo "| --- | ---: | ---: | --- |"
    SYSROOT=
    ARCHITECTURE=x86-64
    for o in -O0 -O1 -O2 -O3 -Os "-Ofast -march=native"; do
            row "gcc $o, x86-64" "" gcc $o
    done
    row "clang -O2, x86-64" "" clang -O2
    row "clang -Ofast, x86-64" "" clang -Ofast
    row "tcc, x86-64" "" tcc
    row "pcc, x86-64" "" pcc
    row "g++ -O2, x86-64" "" g++ -x c++ -O2 -Wno-deprecated
    row "gcc -O2, x87 unit of x86-64" "" gcc -O2 -mfpmath=387
    frow "gfortran -O2, x86-64" gfortran -std=legacy -O2 -frecursive
    for c in flang flang-19 flang-new-19; do there $c && break; done
    frow "flang -O2, x86-64" $c -O2 -w
    # (a long has 4 bytes there; wine makes its directory first)
    WINEPREFIX=`pwd`/$B/wine WINEDEBUG=-all
    export WINEPREFIX WINEDEBUG
    mingw=x86_64-w64-mingw32-gcc
    there wine && wine hostname > /dev/null 2>&1
    row "gcc -O2, 64-bit Windows (mingw, wine)" wine $mingw -O2
    row "gcc -O2 -DTESS_INT=long, 64-bit Windows (mingw, wine)" wine $mingw \
        -O2 -DTESS_INT=long
    while read -r name triple qemu flags; do
        SYSROOT=/usr/$triple
        ARCHITECTURE=$qemu
            row "gcc $flags, `echo $name | sed 's/,/, /g; s/_/ /g'`" qemu-$qemu $triple-gcc $flags
    done << END
i686,x87_unit i686-linux-gnu i386 -O2
68k,80-bit_unit,big-endian m68k-linux-gnu m68k -O2
Alpha alpha-linux-gnu alpha -O2 -mieee
PowerPC_64,big-endian powerpc64-linux-gnu ppc64 -O2 -ffp-contract=fast
ARM arm-linux-gnueabihf arm -O2
ARM_64,FMA aarch64-linux-gnu aarch64 -O3 -ffp-contract=fast
RISC-V_64,FMA riscv64-linux-gnu riscv64 -O3 -ffp-contract=fast
END
    # (parity.c writes by stdio, which there is none of)
    tiny="not to be had" same=
    if there clang && there wasm-ld && there node; then
        # shellcheck disable=SC2086 # lists of flags, of files
        $WASM -DTESS_FLOAT -o $B/out.wasm test/builds/machines/tiny.c $LIBRARY \
            2>> $B/log &&
            node test/builds/machines/wasm/run.js $B/out.wasm > $B/out.txt \
                2>> $B/log
        tiny=`checksum $B/out.txt`
        parity=$PARITY
        ARCHITECTURE=wasm32
        agree clang
    fi
    echo "| clang -O2, WebAssembly (wasm32), no C library | $tiny | | $same |"
}

# ---- small machines ----

M0="arm-none-eabi-gcc -mthumb -mcpu=cortex-m0"
M4="arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16"
AVR="avr-gcc -std=gnu89 -mmcu=atmega1284p"
SMALL="-DTESS_FLOAT -DTESS_INT=short -DTESS_LIST=64 -DHH_LIMBS=6"
SMALLEST="-DTESS_FLOAT -DTESS_INT=short -DTESS_LIST=64 -DHH_LIMBS=3"

# bare MACHINE FILE FLAGS...: compile tiny.c for it, with the stack painted, and
# run it; its lines to FILE
bare() {
    machine=$1
    file=$2
    shift 2
    case $machine in
    avr)
        $AVR -DPAINT "$@" -o $B/bare test/builds/machines/tiny.c $LIBRARY -lm \
            2>> $B/log &&
            limited 200 simavr -m atmega1284p -f 16000000 $B/bare 2>&1 |
                sed -n 's/[^ -~]\[[0-9]*m//g; s/\.$//p' > $file;;
    *)
        case $machine in
        m0) cc=$M0 board=microbit size=0x4000;;
        m0large) cc=$M0 board=mps2-an385 size=0x40000;;
        m4) cc=$M4 board=mps2-an386 size=0x40000;;
        esac
        $cc -DPAINT "$@" -nostartfiles --specs=nano.specs \
            -T test/builds/machines/bare/cortex.ld \
            -Wl,--defsym=MEMORY_SIZE=$size -o $B/bare \
            test/builds/machines/tiny.c \
            test/builds/machines/bare/cortex.c $LIBRARY -lm 2>> $B/log &&
            limited 100 qemu-system-arm -M $board -nographic \
                -semihosting -kernel $B/bare > $file 2>&1;;
    esac
}

# small NAME MACHINE OPTIONS: a row of the table of small machines
small() {
    : > $B/bare.txt
    bare $2 $B/bare.txt -Os $3
    same="the same"
    sed '$d' $B/bare.txt | cmp -s - $B/tiny.txt || { same="**another**"; BAD=1; }
    options="\`$3\`"
    [ -n "$3" ] || options=none
    stack=`tail -n 1 $B/bare.txt | tr -d ' '`
    echo "| $1 | $options | `flash $2 "$3" call` | `flash $2 "$3" linked` | `flash $2 "$3" all` | `usage $2 "$3"` | $stack | $same |"
}

# flash MACHINE OPTIONS WHAT: bytes of code and constants of the library, in a
# program that calls tess and tess_locate, or all there is; without the C
# library's own, or `linked', with that
flash() {
    case $1 in
    avr) cc=$AVR size=avr-size;;
    m4) cc=$M4 size=arm-none-eabi-size;;
    *) cc=$M0 size=arm-none-eabi-size;;
    esac
    for f in tess hhpred; do
        $cc -Os $2 -ffunction-sections -c -o $B/$f.o $f.c 2>> $B/log
    done
    if [ $3 = all ]; then
        $size $B/tess.o $B/hhpred.o |
            awk 'NR > 1 { sum += $1 } END { print sum }'
        return
    fi
    with="-r -nostdlib"
    [ $3 = linked ] && with="-nostartfiles"
    $cc $with -Wl,--gc-sections -Wl,-e,"$(entry)" -Wl,-u,"$(entry)" \
        -Wl,-u,"$(locate)" -o $B/called.o $B/tess.o $B/hhpred.o -lm 2>> $B/log
    $size $B/called.o | awk 'NR > 1 { print $1 }'
}

# usage MACHINE OPTIONS: bytes of stack on the longest path of calls from tess, by
# the compiler's own figures; without the C library's
usage() {
    case $1 in
    avr)
        echo
        return;;
    m4) cc=$M4;;
    *) cc=$M0;;
    esac
    for f in tess hhpred; do
        $cc -Os $2 -fcallgraph-info=su -c -o $B/$f.o $f.c 2>> $B/log
    done
    awk -v entry="$(entry)" '
        function deep(f, list, k, n, d, most) {
            if (f in known) return known[f]
            n = split(callees[f], list, " ")
            most = 0
            for (k = 1; k <= n; k++) {
                d = deep(list[k])
                if (d > most) most = d
            }
            return known[f] = own[f] + most
        }
        { split($0, part, "\"") }
        /^node:/ && match($0, /[0-9]+ bytes/) {
            own[part[2]] = substr($0, RSTART, RLENGTH) + 0
        }
        /^edge:/ { callees[part[2]] = callees[part[2]] " " part[4] }
        END { print deep(entry) }' $B/tess.ci $B/hhpred.ci
}

# entry, locate: the names of tess and tess_locate in tess.o, which end in the
# build's types
entry() {
    nm $B/tess.o | sed -n 's/.* T \(tess\)$/\1/p; s/.* T \(tess__.*\)$/\1/p'
}
locate() {
    nm $B/tess.o | sed -n 's/.* T \(tess_locate.*\)$/\1/p'
}

machine_table() {
    echo "| machine | options | flash, tess and tess_locate | linked | flash, all | stack | painted | arrays |"
    echo "| --- | --- | ---: | ---: | ---: | ---: | ---: | --- |"
    if there arm-none-eabi-gcc && there qemu-system-arm; then
        small "Cortex-M4" m4 ""
        small "Cortex-M4" m4 "-DTESS_LIST=64"
        small "Cortex-M4" m4 "$SMALL"
        small "Cortex-M4" m4 "$SMALLEST"
        small "Cortex-M0" m0large ""
        small "Cortex-M0" m0 "$SMALL"
        small "Cortex-M0" m0 "$SMALLEST"
    else
        echo "| Cortex-M | not to be had | | | | | | |"
    fi
    if there avr-gcc && there simavr; then
        # (double is float, tess_int long; 3 limbs, of 9 bits here, do not do)
        small "AVR, ATmega1284P" avr "-DTESS_LIST=64 -DHH_LIMBS=6"
        small "AVR, ATmega1284P" avr \
            "-DTESS_INT=short -DTESS_LIST=64 -DHH_LIMBS=6"
    else
        echo "| AVR | not to be had | | | | | | |"
    fi
}

# instructions NAME COMPILER BOARD: a row of the table of instructions
instructions() {
    $2 -Os $SMALL -nostartfiles --specs=nano.specs \
        -T test/builds/machines/bare/cortex.ld \
        -Wl,--defsym=MEMORY_SIZE=0x40000 \
        -o $B/count test/builds/machines/count.c \
        test/builds/machines/bare/cortex.c $LIBRARY -lm 2>> $B/log &&
        limited 100 qemu-system-arm -M "$3" -nographic -semihosting \
            -icount shift=10,sleep=off -kernel $B/count > $B/count.txt 2>&1
    read -r loop mesh place index query found < $B/count.txt
    read -r _ _ _ _ _ counted < $B/counted.txt
    # the loop's 2000, and the few about it
    if [ -n "$found" ] && [ "$found" = "$counted" ] &&
        [ "$loop" -ge 2000 ] && [ "$loop" -lt 2040 ]; then
        echo "| $1 | $mesh | $place | $index | $query |"
    else
        echo "| $1 | **another** result | | | |"
    fi
}

count_table() {
    # shellcheck disable=SC2086
    $CC -O1 $SMALL -o $B/counted test/builds/machines/count.c $LIBRARY -lm &&
        $B/counted > $B/counted.txt
    echo "| sensors, machine | tess | tess_locate | tess_index | tess_query |"
    echo "| --- | ---: | ---: | ---: | ---: |"
    if there arm-none-eabi-gcc && there qemu-system-arm; then
        instructions "64, Cortex-M4" "$M4" mps2-an386
        instructions "64, Cortex-M0" "$M0" mps2-an385
    else
        echo "| Cortex-M | not to be had | | | |"
    fi
}

# ram: bytes of all arrays, p too, for 7 n tetrahedra, and without a mesh
ram() {
    echo "| n | double, int | float, int | float, short | AVR: long | AVR: short | no mesh: float, short | no mesh, AVR: short |"
    echo "| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
    for n in 50 100 200 500 1000; do
        printf '| %d ' $n
        for o in "" -DTESS_FLOAT "-DTESS_FLOAT -DTESS_INT=short" \
            "-DTESS_FLOAT -DRW=4" "-DTESS_FLOAT -DTESS_INT=short -DRW=4" \
            "-DTESS_FLOAT -DTESS_INT=short -DQUERY" \
            "-DTESS_FLOAT -DTESS_INT=short -DRW=4 -DQUERY"; do
            cat > $B/ram.c << END
#include <stdio.h>
#include "tess.h"
#ifndef RW
#define RW sizeof(double)
#endif
#ifdef QUERY /* as in sensor.c: what tess_index and tess_query need */
#define TETS 0
#define LIW (2 * $n + $n / 12 + 7)
#define LRW (3 * $n + $n / 2 + 12)
#else
#define TETS (7 * $n)
#define LIW TESS_LIW($n)
#define LRW TESS_LRW($n)
#endif
int main(void)
{
    printf("| %ld ", (long)(3 * $n * sizeof(tess_real) +
        (8 * TETS + LIW) * sizeof(tess_int) + LRW * RW));
    return 0;
}
END
            $CC $o -I. -o $B/ram $B/ram.c && $B/ram
        done
        echo "|"
    done
}

# limbs: the least HH_LIMBS for each kind of coordinates
limbs() {
    echo "| coordinates | HH_LIMBS |"
    echo "| --- | ---: |"
    all="3 4 5 6 8 10 12 16 24 32 48 64 88"
    for l in $all; do
        $CC -O1 -DHH_LIMBS=$l -o $B/limbs test/builds/machines/limbs.c \
            $LIBRARY -lm
        $B/limbs > $B/limbs.$l
    done
    sed 's/^[0-9]* //' $B/limbs.88 | while read -r kind; do
        for l in $all; do
            if grep "^0 $kind\$" $B/limbs.$l > /dev/null; then
                echo "| $kind | $l |"
                break
            fi
        done
    done
}

{
    echo "Written by: make reach"
    echo "Machine: `uname -sm`; the others are simulated"
    for c in gcc clang flang-new-19 wine qemu-m68k qemu-system-arm arm-none-eabi-gcc avr-gcc; do
        there $c && $c --version | head -n 1
    done
    echo
    echo "The same arrays everywhere: checksums, by cksum, of what programs write"
    echo
    machines > $B/machines.md
    cat $B/machines.md
    echo
    echo "These are `sort -u $B/compilers | wc -l | tr -d ' '` compilers" \
        "(`sort -u $B/compilers | paste -s -d ' ' -`)," \
        "`sort -u $B/architectures | wc -l | tr -d ' '` architectures" \
        "(`sort -u $B/architectures | paste -s -d ' ' -`)"
    cat << 'END'

Small machines: flash with -Os, of the library alone, in bytes; the stack on the
longest path of calls (gcc -fcallgraph-info), and what is painted and then no
longer so, the C library's included, in sets of 24 points of which one takes all
the limbs that there are; and whether `tet` and `adj` of four sets are those of all others
(Cortex by qemu-system-arm, AVR by simavr):

END
    machine_table
    cat << 'END'

`tess_check` and whatever else is not called is left out by
`-ffunction-sections` and the linker's `--gc-sections`: the first column of flash
against the last; linked: what they take of the C library and for doubles, too.
Memory for all arrays, in bytes: p, iw, rw, and tet and adj of
7 n tetrahedra; or without a mesh, for tess_index and tess_query alone, as in
test/samples/sensor.c:

END
    ram
    cat << END

Instructions (not cycles, of which each takes one or more) for 64 sensors, counted
by qemu-system-arm -icount, with -Os and
\`$SMALL\`: the mesh; a place,
in it or outside, found without a start, the mean of 100; and without a mesh the
index and such a place:

END
    count_table
    cat << 'END'

Limbs that suffice, by trial of 20 sets of 60 random points each:

END
    limbs
} > $B/reach.txt
[ $BAD = 0 ] && ! grep -F '**another**' $B/reach.txt > /dev/null &&
    mkdir -p test/results && cp $B/reach.txt test/results
code=$?
cat $B/reach.txt
[ $code = 0 ] ||
    echo "reach: not the same everywhere; test/results/reach.txt is as it was"
exit $code
