#!/bin/sh
# bench.sh - the time and memory of tess beside CGAL, TetGen and Qhull, and of
# its FORTRAN 77 half beside the C half.
#
# Everything is measured in one run on one machine, the programs by turns, so
# that the ratios hold where the nanoseconds do not.  Prints tables in
# markdown: times and memory of clouds; times of the data that people have, at
# fixed sizes; of those near planes, spheres and other surfaces, at three; counts;
# location; values; parts.  About ten minutes, without SIZES.
# A run of all families that comes to its end writes them to
# test/results/bench.txt, too, with the commit, the options and code.sh's sum; the
# README's figures are from there: `make check ONLY=rules' then tells what it
# should say.  Raw lines,
# as bench.c describes them, go to standard error and to build/bench.txt, each
# after its table's name and the number asked for.
#
# From the environment:
#   FAMILY    only these families of points.h, or files of points with a / in
#             the name
#   SIZES     all: large sets, too; or numbers of points, for all families
#   SCANS     files of points that the table of people's data shall have, too
#   PEERS     some of: f77 cgal tetgen qhull
#   REPEATS   runs of which the fastest counts (3)
#   SEED      of the random points (1)
#   LIMIT     seconds of the processor after which a run is cut (60)
#   CC, CFLAGS, CXX  compilers, and options for tess (-O3); peers have -O3
#   FC, FFLAGS       the same for the FORTRAN 77 half (gfortran, -O3 -flto)

cd "$(dirname "$0")/../.." || exit 1
PEERS=${PEERS-"f77 cgal tetgen qhull"}
REPEATS=${REPEATS:-3}
SEED=${SEED:-1}
LIMIT=${LIMIT:-60}
CFLAGS=${CFLAGS:--O3}
CXX=${CXX:-g++}
FC=${FC:-gfortran}
FFLAGS=${FFLAGS:--O3 -flto}
. test/tests.sh
mkdir -p build

# table, family, peers, numbers of points; those with + for SIZES=all.  What is
# in peers is in another table, too.
rows='
clouds uniform f77,cgal,tetgen,qhull 10000 100000 +1000000
clouds decimal3 f77,cgal,tetgen,qhull 10000 100000 +1000000
clouds clusters f77,cgal,tetgen,qhull 10000 100000 +1000000
clouds aniso f77,cgal,tetgen,qhull 10000 100000 +1000000
clouds lattice f77,cgal,tetgen,qhull 10000 100000 +1000000
people terrain f77,cgal 50000
people survey f77,cgal 20000
people horizons f77,cgal 20000
people layers f77,cgal 20000
people near6 f77,cgal 20000
people boreholes f77,cgal 20000
people tracks f77,cgal 8000
people pipes f77,cgal 20000
people torus f77,cgal 20000
people torus cgal 100000
people cylinderrnd cgal 100000
people crowd cgal 8000
people box6 f77,cgal 50000
people box6 cgal 200000
people plate3 cgal 100000
people bracket6 cgal 200000
people pillar6 f77,cgal 20000
people pillar12 f77,cgal 20000
people pillar64 f77,cgal 20000
people masts f77,cgal 20000
people towers f77,cgal 20000
people sites f77,cgal 20000
people ellipsoid f77,cgal 50000
data gridrot f77,cgal 1000 8000 27000 +64000 +216000
data gridcyl f77,cgal 1000 8000 27000 +125000
data extruded f77,cgal 2000 8000 30000 +100000
data globe f77,cgal 2000 8000 30000 +100000 +1000000
data latlonkm f77,cgal 1800 7200 +45000
data uvsphere f77,cgal 1800 7200 +45000
data stations f77,cgal 2000 8000 30000 +100000 +1000000
data shells f77,cgal 4000 10000 30000 +100000 +300000
data cavity f77,cgal 4000 10000 30000 +100000 +300000
data rotcube f77,cgal 2000 8000 30000 +100000 +300000
data rottetin f77,cgal 2000 8000 30000 +100000 +300000
data cubegrid f77,cgal 2000 8000 30000 +100000 +300000
data tilted15 f77,cgal 2000 8000 30000 +100000
data spherei f77,cgal 1000 2000 4000 +8000
data sheets f77,cgal 2000 8000 30000 +100000
data bumps f77,cgal 2000 8000 30000 +100000
data ellipsoid f77,cgal 2000 8000 30000 +100000
data terrain f77,cgal 2000 8000 30000 +100000
data wide f77,cgal 50 100 300
data fillglobe f77,cgal 2000 8000
data fillcurve f77,cgal 2000 8000
data fillcurve9 f77,cgal 2000 8000
peers terrain cgal,tetgen,qhull 50000
peers boreholes cgal,tetgen,qhull 20000
peers gridrot cgal,tetgen,qhull 27000
peers globe cgal,tetgen,qhull 30000'
for family in $SCANS; do
    rows="$rows
people $family f77,cgal $(grep -c . "$family")"
done
# shellcheck disable=SC2086
$CC $CFLAGS -o build/bench_tess test/bench/bench.c test/lib/points.c tess.c \
    hhpred.c -lm || exit 1
for family in $FAMILY $SCANS; do
    case $family in
    */*) [ -r "$family" ] && continue
        echo "bench: cannot read $family" >&2
        exit 2 ;;
    esac
    build/bench_tess -list | grep -x -e "$family" >/dev/null && continue
    echo "bench: no family $family; a file's name has a /, and these are" \
        "families:" >&2
    build/bench_tess -list | tr '\n' ' ' | fold -s -w 78 >&2
    echo >&2
    exit 2
done

if [ -n "$FAMILY" ]; then
    all=$rows
    rows=
    for family in $FAMILY; do
        row=$(echo "$all" | awk -v f="$family" '$2 == f')
        some="10000 100000"
        case $family in */*) some=$(grep -c . "$family") ;; esac
        rows="$rows
${row:-data $family f77,cgal $some}"
    done
fi

# shellcheck disable=SC2086
$CC $CFLAGS -DTESS_COUNT -o build/bench_count test/bench/bench.c \
    test/lib/points.c tess.c hhpred.c -lm || exit 1
$CC -O3 -c -o build/bench_points.o test/lib/points.c || exit 1

# peer NAME PROGRAM SOURCE HEADER COMPILER LIBRARIES
peer() {
    probe=build/bench_probe.${3##*.}
    echo "#include <$4>" >"$probe"
    if ! $5 -E "$probe" >/dev/null 2>&1; then
        echo "$1: not installed, skipped" >&2
        return
    fi
    if [ ! -f "build/bench_$2" ] || [ -n "$(find "test/bench/peers/$3" \
        test/bench/peers/peer.h test/lib/points.[ch] \
        -newer "build/bench_$2")" ]; then
        # shellcheck disable=SC2086
        if ! $5 -O3 -DNDEBUG -o "build/bench_$2" "test/bench/peers/$3" \
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
        ! $CC -O3 -DBENCH_F77 -c -o build/bench_f77.o test/bench/bench.c ||
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

# The load average of the last minute: before, and at most in between, when
# it is about 1 of this run's own.
load() { uptime | sed 's/.*averages*: *//; s/[, ].*//'; }
before=$(load)
load >build/bench_load.txt

# run TABLE FAMILY SIZE PROGRAM: one line of bench.txt.  What took 4 seconds is
# not run again; what was cut is taken for cut with more points, too.
run() {
    case $past in
    *" $4 $3 "*) return ;;
    *" $4 cut "*) line= ;;
    *)
        limited "$LIMIT" "build/bench_$4" "$2" "$3" 1 "$SEED" \
            >build/bench.out 2>/dev/null
        # the signal for too much time
        case $? in 137 | 152) past="$past $4 cut " ;; esac
        line=$(awk -v p="$4" '$1 == p' build/bench.out)
        [ -z "$line" ] || past="$past$(echo "$line" |
            awk '$5 >= 4 { print " " $1 " '"$3"' " }')"
        ;;
    esac
    if [ -z "$line" ]; then
        case $past in
        *" $4 cut "*) line="$4 $2 $3 0 0 0 0 0 cut" ;;
        *) line="$4 $2 $3 0 0 0 0 0 failed" ;;
        esac
        past="$past $4 $3 "
    fi
    echo "$1 $3 $line" | tee -a build/bench.txt >&2
}

: >build/bench.txt
: >build/bench_counts.txt
echo "$rows" | while read -r table family peers sizes; do
    [ -n "$table" ] || continue
    past=
    case $SIZES in
    all) sizes=$(echo "$sizes" | tr -d +) ;;
    "") sizes=${sizes%% +*} ;;
    *) sizes=$SIZES ;;
    esac
    for size in $sizes; do
        load >>build/bench_load.txt
        round=0
        while [ $round -lt "$REPEATS" ]; do
            for program in $programs; do
                case tess,$peers, in
                *"$program,"*) run "$table" "$family" "$size" "$program" ;;
                esac
            done
            round=$((round + 1))
        done
        case $table$past in
        peers* | *" tess cut "*) ;;
        *) build/bench_count "$family" "$size" 1 "$SEED" |
            grep '^count' >>build/bench_counts.txt ;;
        esac
    done
done
rm -f build/bench.out build/bench_probe.*

rm -f build/bench_whole
(
echo "Written by: make bench${SIZES:+ SIZES=\"$SIZES\"}"
commit=$(git rev-parse --short=12 HEAD 2>/dev/null || echo unknown)
git diff --quiet HEAD -- ./*.[ch] f77 2>/dev/null || commit="$commit, and changes"
echo "Commit: $commit; code $(sh test/bench/code.sh), by test/bench/code.sh"
echo "Machine: $(uname -sm), $(getconf _NPROCESSORS_ONLN 2>/dev/null)" \
    "processors,$(sed -n 's/^model name[^:]*:/ /p' /proc/cpuinfo 2>/dev/null |
        head -n 1 | tr -s ' ')"
for compiler in "$CC" "$FC" "$CXX"; do
    $compiler --version 2>/dev/null | head -n 1
done
echo "Options: $CFLAGS, FORTRAN $FFLAGS, peers -O3; the fastest of $REPEATS runs"
echo "Load average: $before before, at most" \
    "$(sort -n build/bench_load.txt | tail -n 1) while it ran (1 is its own)"
awk -v limit="$LIMIT" '
BEGIN {
    shown["tess"] = "tess"
    shown["f77"] = "FORTRAN"
    shown["cgal"] = "CGAL"
    shown["tetgen"] = "TetGen"
    shown["qhull"] = "Qhull"
    many = split("tess f77 cgal tetgen qhull", program, " ")
}
{
    key = $4 " " $2
    if (!(key in family)) {
        order[++rows] = key
        family[key] = $4
        table[key] = $1
        points[key] = $5
    }
    at = key " " $3
    has[$1 $3] = 1
    good[at] = $11 == "0"
    fault[at] = $11 == "cut" ? "> " limit " s" : \
        $11 ~ /^-?[0-9]+$/ ? "code " $11 : $11
    if (!(at in time) || $8 < time[at]) time[at] = $8
    work[at] = $9
    total[at] = $10
    if (good[at]) {
        # (where points lie on one sphere others have other ones)
        if ($3 == "tess") tetrahedra[key] = $6
        points[key] = $5
        if (!($1 $4 $3 in least)) least[$1 $4 $3] = key
        else if (least[$1 $4 $3] != key) grows[$1] = 1
    }
}
function ratio(a, b) {
    if (good[a] && good[b] && time[b] > 0)
        return sprintf(" %.2f |", time[a] / time[b])
    return " |"
}
# a set beside the smallest of its family
function growth(key, name,   first) {
    first = least[table[key] family[key] name]
    return first == "" || first == key ? " |" \
        : ratio(key " " name, first " " name)
}
function value(at, list, form) {
    return good[at] ? sprintf(form, list[at]) : fault[at]
}
function heading(head) {
    print head
    gsub("[^|]+", " ---: ", head)
    sub(" ---: ", " --- ", head)
    print head
}
function programs(which,   k, head) {
    for (k = 1; k <= many; k++)
        if (has[which program[k]]) head = head " " shown[program[k]] " |"
    return head
}
function times(which,   i, k, head) {
    head = "| points | n | tetrahedra |" programs(which)
    if (has[which "f77"]) head = head " FORTRAN/tess |"
    if (has[which "cgal"]) head = head " tess/CGAL |"
    if (grows[which]) {
        head = head " level |"
        if (has[which "cgal"]) head = head " CGAL: level |"
    }
    heading(head)
    for (i = 1; i <= rows; i++) {
        key = order[i]
        if (table[key] != which) continue
        name = family[key]
        sub(".*/", "", name)
        head = "| " name " | " points[key] " | " tetrahedra[key] " |"
        for (k = 1; k <= many; k++)
            if (has[which program[k]])
                head = head " " value(key " " program[k], time, "%.0f") " |"
        if (has[which "f77"]) head = head ratio(key " f77", key " tess")
        if (has[which "cgal"]) head = head ratio(key " tess", key " cgal")
        if (grows[which]) {
            head = head growth(key, "tess")
            if (has[which "cgal"]) head = head growth(key, "cgal")
        }
        print head
    }
}
# the rows that the README takes from here
function few(   i, k, at, head, first) {
    first = 1
    for (i = 1; i <= rows; i++) {
        key = order[i]
        name = family[key]
        sub(".*/", "", name)
        if (!index(" uniform:100000 lattice:97336 gridrot:27000 " \
            "globe:30000 rotcube:30000 terrain:50000 ellipsoid:50000 " \
            "box6:50000 pillar12:20000 boreholes:20000 tracks:8000 ", \
            " " name ":" points[key] " ")) continue
        if (first) {
            print "\nThe rows of the README\n"
            heading("| points | n | tetrahedra | tess | FORTRAN/tess |" \
                " tess/CGAL |")
            first = 0
        }
        at = key " tess"
        print "| " name " | " points[key] " | " tetrahedra[key] " | " \
            value(at, time, "%.0f") " |" ratio(key " f77", at) \
            ratio(at, key " cgal")
    }
}
# sets of those tables beside all
function peers(   i, k, head, first) {
    first = 1
    for (i = 1; i <= rows; i++) {
        key = order[i]
        if (table[key] == "clouds" || !(key " tetgen" in time) &&
            !(key " qhull" in time)) continue
        if (first) {
            print "\nSome of these beside all\n"
            heading("| points | n | tetrahedra | tess | CGAL | TetGen | Qhull |")
            first = 0
        }
        head = "| " family[key] " | " points[key] " | " tetrahedra[key] " |"
        for (k = 1; k <= many; k++)
            if (program[k] != "f77")
                head = head " " value(key " " program[k], time, "%.0f") " |"
        print head
    }
}
function memory(which,   i, k, head) {
    heading("| points | n | tess, workspace alone |" programs(which))
    for (i = 1; i <= rows; i++) {
        key = order[i]
        if (table[key] != which) continue
        head = "| " family[key] " | " points[key] " | " \
            value(key " tess", work, "%.0f") " |"
        for (k = 1; k <= many; k++)
            if (has[which program[k]])
                head = head " " value(key " " program[k], total, "%.0f") " |"
        print head
    }
}
END {
    if (has["cloudstess"]) {
        print "\nNanoseconds of CPU time per tetrahedron; level: those beside" \
            "\nthe ones of the smallest set\n"
        times("clouds")
        print "\nBytes per point, output included, points not\n"
        memory("clouds")
    }
    if (has["peopletess"]) {
        print "\nThe same times of data that people have: scans and surveys," \
            "\nlayers, lines of samples, sampled faces, prisms and masts," \
            "\nclosed surfaces\n"
        times("people")
    }
    if (has["datatess"]) {
        print "\nThe same times of data that lie near planes, spheres, other" \
            "\nsurfaces and curves, and of others that are hard\n"
        times("data")
    }
    peers()
    few()
}' build/bench.txt

# What does not depend on the machine's mood.
echo
echo "Counts, per tetrahedron: searches that end in a star's list, a block's,"
echo "the tree; nodes of the tree; leaves opened; points of lists and leaves"
echo "tested; candidates looked at one by one; exact comparisons; those, exact"
echo "sides and comparisons tried by a few limbs; and the most facets in the"
echo "pool"
echo
echo "| points | n | star | block | tree | nodes | leaves | listed |" \
    "candidates | exact | limbs | pool |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |" \
    "---: | ---: |"
awk '
function count(x, form) { printf " | " (none ? "-" : form), x }
{
    for (i = 4; i < NF; i += 2) c[$i] = $(i + 1)
    # of no tetrahedron
    none = c["facets"] !~ /[0-9]/
    sub(".*/", "", $2)
    printf "| %s | %d", $2, $3
    count(c["star"], "%.2f")
    count(c["block"], "%.2f")
    count(c["tree"], "%.2f")
    count(c["nodes"], "%.1f")
    count(c["leaves"], "%.1f")
    count(c["listed"], "%.0f")
    count(c["candidates"], "%.1f")
    count(c["exact"], "%.2f")
    count(c["exact"] + c["sides"] + c["trials"], "%.2f")
    printf " | %d |\n", c["pool"]
}' build/bench_counts.txt

# Location: queries in spatial order from the last answer, and from nowhere; in
# the mesh, and by tess_query without one.
[ -z "$FAMILY" ] || exit 0
# shellcheck disable=SC2086
$CC $CFLAGS -o build/bench_locate test/bench/locate.c test/lib/points.c tess.c \
    hhpred.c -lm || exit 1
locators=build/bench_locate
case $programs in
*cgal*)
    $CXX -O3 -DNDEBUG -o build/bench_cgalloc test/bench/peers/cgalloc.cpp \
        build/bench_points.o -lmpfr -lgmp &&
        locators="$locators build/bench_cgalloc"
    ;;
esac
echo
echo "Nanoseconds per located point, weights included (CGAL: without)"
echo
echo "| | points | n | share inside | in spatial order | from anywhere |"
echo "| --- | --- | ---: | ---: | ---: | ---: |"
sizes="10000 100000"
[ "$SIZES" = all ] && sizes="$sizes 1000000"
for size in $sizes; do
    for program in $locators; do
        $program uniform "$size" |
            awk '{ print "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " | " $6 " |" }'
    done
done

# From a file of points to a file of values.
if [ -x build/tess ]; then
    echo
    REPEATS=$REPEATS sh test/bench/values.sh
fi

# Parts, by POSIX threads where there are any.
# shellcheck disable=SC2086
$CC $CFLAGS -I. -DTHREADS -o build/bench_parts test/bench/parts.c \
    test/lib/points.c tess.c hhpred.c -lm -lpthread 2>/dev/null ||
    $CC $CFLAGS -I. -o build/bench_parts test/bench/parts.c test/lib/points.c \
        tess.c hhpred.c -lm || exit 1
echo
echo "Parts, joined, beside tess: tetrahedra computed; time one after another;"
echo "by the clock with a thread for each, measured where there are so many"
echo "processors, else computed from the pieces; of that what no thread makes"
echo "less: index and join"
echo
echo "| points | n | parts | tetrahedra | time | by the clock | | index | join |"
echo "| --- | ---: | ---: | ---: | ---: | ---: | --- | ---: | ---: |"
row() {
    build/bench_parts "$@" | awk '{
        $1 = "|"
        for (i = 2; i <= NF; i++) $i = $i " |"
        print
    }'
}
for size in $sizes; do
    [ "$size" = 10000 ] && continue
    row uniform "$size" "$REPEATS"
    for family in gridrot ellipsoid terrain globe rotcube; do
        row $family $((size / 5)) "$REPEATS" 8
    done
done
touch build/bench_whole
) >build/bench.md || exit 1
cat build/bench.md
case $SIZES in
"" | all)
    if [ -f build/bench_whole ]; then
        mkdir -p test/results
        cp build/bench.md test/results/bench.txt
    fi ;;
esac
