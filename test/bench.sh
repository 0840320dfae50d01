#!/bin/sh
# bench.sh - the time and memory of tess beside CGAL, TetGen and Qhull, and of
# its FORTRAN 77 half beside the C half.
#
# Everything is measured in one run on one machine, so that the ratios hold
# where the nanoseconds do not.  Prints two tables in markdown; raw lines, as
# bench.c describes them, go to standard error and to build/bench.txt.
#
# From the environment:
#   FAMILIES  families of points.h
#   SIZES     numbers of points, for all families.  Without it 10^4 and 10^5,
#             with BIG=1 10^6 too; but 2000 for moment, whose output is
#             quadratic, and spherei, and 10^4 for spherenorm
#   PEERS     some of: f77 cgal tetgen qhull
#   REPEATS   runs of which the fastest counts (3)
#   SEED      of the random points (1)
#   LIMIT     seconds before one program is given up (600)
#   CC, CFLAGS, CXX  compilers, and options for tess (-O3); peers have -O3
#   FC, FFLAGS       the same for the FORTRAN 77 half (gfortran, -O3)

cd "$(dirname "$0")/.." || exit 1
FAMILIES=${FAMILIES:-"uniform ball decimal3 twoscale clusters aniso planenoise
    lattice lattice01 spherei spherenorm moment"}
PEERS=${PEERS-"f77 cgal tetgen qhull"}
REPEATS=${REPEATS:-3}
SEED=${SEED:-1}
LIMIT=${LIMIT:-600}
CC=${CC:-cc}
CFLAGS=${CFLAGS:--O3}
CXX=${CXX:-g++}
FC=${FC:-gfortran}
FFLAGS=${FFLAGS:--O3}
mkdir -p build

# shellcheck disable=SC2086
$CC $CFLAGS -o build/bench test/bench.c test/points.c tess.c hhpred.c -lm ||
    exit 1
$CC -O3 -c -o build/bench_points.o test/points.c || exit 1

# peer NAME PROGRAM SOURCE HEADER COMPILER LIBRARIES
peer() {
    probe=build/bench_probe.${3##*.}
    echo "#include <$4>" >"$probe"
    if ! $5 -E "$probe" >/dev/null 2>&1; then
        echo "$1: not installed, skipped" >&2
        return
    fi
    if [ ! -f "build/bench_$2" ] || [ -n "$(find "test/peers/$3" \
        test/peers/peer.h test/points.[ch] -newer "build/bench_$2")" ]; then
        # shellcheck disable=SC2086
        if ! $5 -O3 -DNDEBUG -o "build/bench_$2" "test/peers/$3" \
            build/bench_points.o $6; then
            rm -f "build/bench_$2"
            echo "$1: does not build, skipped" >&2
            return
        fi
    fi
    programs="$programs $2"
}

# The FORTRAN 77 half has names of its own, so that the C half, for tess_size
# alone, may be linked, too.
f77() {
    # shellcheck disable=SC2086
    if ! $FC $FFLAGS -frecursive -c -o build/bench_ftess.o f77/tess.f ||
        ! $FC $FFLAGS -frecursive -c -o build/bench_fhhpred.o f77/hhpred.f ||
        ! $CC -O3 -DBENCH_F77 -c -o build/bench_f77.o test/bench.c ||
        ! $FC -o build/bench_f77 build/bench_f77.o build/bench_points.o \
            build/bench_ftess.o build/bench_fhhpred.o tess.c hhpred.c -lm; then
        echo "f77: does not build, skipped" >&2
        return
    fi
    programs="$programs f77"
}

programs=tess
for name in $PEERS; do
    case $name in
    f77) f77 ;;
    cgal) peer CGAL cgal cgal.cpp CGAL/version.h "$CXX" "-lmpfr -lgmp" ;;
    tetgen) peer TetGen tetgen tetgen.cpp tetgen.h "$CXX" -ltet ;;
    qhull) peer Qhull qhull qhull.c libqhull_r/libqhull_r.h "$CC" \
        "-lqhull_r -lm" ;;
    *) echo "$name: unknown peer, skipped" >&2 ;;
    esac
done

sizes() {
    if [ -n "$SIZES" ]; then
        echo "$SIZES"
    else
        case $1 in
        moment) echo 2000 ;;
        spherei) echo 2000 ;;
        spherenorm) echo 10000 ;;
        *) echo 10000 100000 ${BIG:+1000000} ;;
        esac
    fi
}

limit=
if command -v timeout >/dev/null; then
    limit="timeout $LIMIT"
fi

# The asked number stands first in each line of bench.txt: the real one may
# differ, and a program that dies prints none.
run() {
    program=build/bench
    [ "$1" = tess ] || program=build/bench_$1
    # shellcheck disable=SC2086
    $limit $program "$2" "$3" "$REPEATS" "$SEED" >build/bench.out 2>/dev/null
    status=$?
    line=$(grep "^$1 $2 " build/bench.out)
    if [ "$status" = 124 ] && [ -n "$limit" ]; then
        line="$1 $2 $3 0 0 0 0 0 timeout"
    elif [ -z "$line" ]; then
        line="$1 $2 $3 0 0 0 0 0 failed"
    fi
    echo "$3 $line" | tee -a build/bench.txt >&2
}

: >build/bench.txt
for family in $FAMILIES; do
    for size in $(sizes "$family"); do
        for program in $programs; do
            run "$program" "$family" "$size"
        done
    done
done
rm -f build/bench.out build/bench_probe.*

echo "$(uname -sm), $($CC --version 2>/dev/null | head -n 1), $CFLAGS;" \
    "the fastest of $REPEATS"
awk -v programs="$programs" '
BEGIN {
    shown["tess"] = "tess"
    shown["f77"] = "FORTRAN"
    shown["cgal"] = "CGAL"
    shown["tetgen"] = "TetGen"
    shown["qhull"] = "Qhull"
    many = split(programs, program, " ")
}
{
    key = $1 " " $3
    if (!(key in family)) {
        order[++rows] = key
        family[key] = $3
        points[key] = $4
    }
    at = key " " $2
    good[at] = $10 == "0"
    fault[at] = $10 ~ /^-?[0-9]+$/ ? "code " $10 : $10
    time[at] = $7
    work[at] = $8
    total[at] = $9
    if (good[at] && !(key in tetrahedra)) {
        tetrahedra[key] = $5
        points[key] = $4
    }
}
function ratio(a, b) {
    if (good[a] && good[b] && time[b] > 0)
        return sprintf(" %.2f |", time[a] / time[b])
    return " |"
}
function value(at, list, form) {
    return good[at] ? sprintf(form, list[at]) : fault[at]
}
END {
    print "\nNanoseconds of CPU time per tetrahedron\n"
    head = "| points | n | tetrahedra |"
    line = "| --- | ---: | ---: |"
    for (k = 1; k <= many; k++) {
        head = head " " shown[program[k]] " |"
        line = line " ---: |"
    }
    if (programs ~ /f77/) {
        head = head " FORTRAN/tess |"
        line = line " ---: |"
    }
    if (programs ~ /cgal/) {
        head = head " tess/CGAL |"
        line = line " ---: |"
    }
    print head "\n" line
    for (i = 1; i <= rows; i++) {
        key = order[i]
        head = "| " family[key] " | " points[key] " | " tetrahedra[key] " |"
        for (k = 1; k <= many; k++)
            head = head " " value(key " " program[k], time, "%.0f") " |"
        if (programs ~ /f77/) head = head ratio(key " f77", key " tess")
        if (programs ~ /cgal/) head = head ratio(key " tess", key " cgal")
        print head
    }
    print "\nBytes per point, output included, points not\n"
    head = "| points | n | tess, workspace alone |"
    line = "| --- | ---: | ---: |"
    for (k = 1; k <= many; k++) {
        head = head " " shown[program[k]] " |"
        line = line " ---: |"
    }
    print head "\n" line
    for (i = 1; i <= rows; i++) {
        key = order[i]
        head = "| " family[key] " | " points[key] " | " \
            value(key " tess", work, "%.0f") " |"
        for (k = 1; k <= many; k++)
            head = head " " value(key " " program[k], total, "%.0f") " |"
        print head
    }
}' build/bench.txt

# What does not depend on the machine's mood: counts per tetrahedron.
$CC $CFLAGS -DTESS_COUNT -o build/bench_count test/bench.c test/points.c \
    tess.c hhpred.c -lm || exit 1
echo
echo "Counts, per tetrahedron: searches that end in a star's list, a block's,"
echo "the tree; nodes of the tree; points of lists and leaves tested; candidates"
echo "looked at one by one; exact comparisons; and the most facets in the pool"
echo
echo "| points | n | star | block | tree | nodes | listed | candidates |" \
    "exact | pool |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"
for family in $FAMILIES; do
    [ "$family" = spherenorm ] && continue
    for size in $(sizes "$family"); do
        $limit build/bench_count "$family" "$size" 1 "$SEED" |
            awk '$1 == "count" {
                for (i = 4; i < NF; i += 2) c[$i] = $(i + 1)
                printf "| %s | %d | %.2f | %.2f | %.2f | %.1f | %.0f | %.1f", \
                    $2, $3, c["star"], c["block"], c["tree"], c["nodes"], \
                    c["listed"], c["candidates"]
                printf " | %.2f | %d |\n", c["exact"], c["pool"] }'
    done
done

# Location: queries in spatial order from the last answer, and from nowhere.
$CC $CFLAGS -o build/bench_locate test/locate.c test/points.c tess.c hhpred.c \
    -lm || exit 1
locators=build/bench_locate
case $programs in
*cgal*)
    $CXX -O3 -DNDEBUG -o build/bench_cgalloc test/peers/cgalloc.cpp \
        build/bench_points.o -lmpfr -lgmp &&
        locators="$locators build/bench_cgalloc"
    ;;
esac
echo
echo "Nanoseconds per located point, weights included (CGAL: without)"
echo
echo "| | points | n | share inside | in spatial order | from anywhere |"
echo "| --- | --- | ---: | ---: | ---: | ---: |"
for size in $(sizes uniform); do
    for program in $locators; do
        $program uniform "$size" |
            awk '{ print "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " | " $6 " |" }'
    done
done
