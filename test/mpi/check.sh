#!/bin/sh
# sh test/mpi/check.sh - do the processes of test/mpi/mesh.c give the mesh that
# tess gives?  make mpi builds build/mesh and build/same.
# PYTHON=python3 with the modules numpy and vtk reads .vtu files back.
PYTHON=${PYTHON:-/usr/bin/python3}
. test/tests.sh
begin mpi
run="mpirun --oversubscribe --allow-run-as-root"
# who never ends, at work or asleep, has failed
MPIEXEC_TIMEOUT=300
export MPIEXEC_TIMEOUT
dir=build/mpi
mkdir -p $dir

# verdict NAME STATUS
verdict() { check "$1" test "$2" = 0; }

# mesh R CODE ARGUMENTS
mesh() {
    processes=$1
    code=$2
    shift 2
    rm -f $dir/o.*
    limited 20 $run -np "$processes" build/mesh -o $dir/o "$@" \
        >$dir/out 2>$dir/err </dev/null
    [ $? = "$code" ]
}

# points FAMILY N
points() {
    build/same -write $dir/p.raw "$1" "$2"
}

# compare NAME R CODE [OPTIONS]: of the points in p.raw
compare() {
    name=$1
    processes=$2
    code=$3
    shift 3
    mesh "$processes" "$code" -raw $dir/p.raw "$@" &&
        build/same $dir/o "$processes" $dir/p.raw >$dir/same.out 2>&1
    verdict "$name, $processes processes" $?
}

# What is in no family: a text file each, as test/lib/points.h has them.
awk 'BEGIN { for (i = 0; i < 1200; i++) print i % 12, int(i / 12) % 10, 5 }' \
    >$dir/plane
awk 'BEGIN { for (i = 0; i < 1200; i++) print i, 3 * i, -i }' >$dir/line
awk 'BEGIN { for (i = 0; i < 1200; i++) print 1, 2, 3 }' >$dir/equal
# each point of a lattice twice, so also where space is cut
awk 'BEGIN { for (i = 0; i < 2000; i++)
    print i % 10, int(i / 10) % 10, int(i / 100) % 10 }' >$dir/twice
# all points of a process before those of the next one, and of one place many
awk 'BEGIN { for (i = 0; i < 900; i++)
    print (i < 700 ? 0 : i * i % 89), (i < 700 ? 0 : i * 7 % 83),
        (i < 700 ? i % 2 : i * i % 97) }' >$dir/heap

# (3, and all others to 8: the hunt)
for processes in 1 2 5 8; do
    while read -r family n; do
        points "$family" "$n"
        compare "$family" "$processes" 0
    done <<END
uniform 4000
clusters 4000
lattice 3375
lattice01 2744
gridrot 2197
globe 1500
spherei 1500
planeone 1000
cubegrid 2000
duplicates 4000
$dir/twice 2000
$dir/heap 900
farpoint 1000
huge 1000
uniform 5
lattice 8
END
    points $dir/plane 1200
    compare "all in a plane" "$processes" 3
    points $dir/line 1200
    compare "all on a line" "$processes" 4
    points $dir/equal 1200
    compare "all equal" "$processes" 5
    : >$dir/p.raw
    compare "no points" "$processes" 5
done

# Tubes: stars of which no facet's vertex is computed again.  A tube, a
# paraboloid, sheets: stars not told of a point that others' change has brought.
while read -r family n processes; do
    points $family $n
    mesh $processes 0 -family $family $n &&
        build/same $dir/o $processes $dir/p.raw >$dir/same.out 2>&1
    verdict "$family $n, $processes processes" $?
done <<END
cylinderrnd 550 3
cylinderrnd 600 7
paraboloid 244 7
sheets 336 4
END
subtest "a hunt" sh test/mpi/hunt.sh 600 1 30

# From a few extreme points alone: all else by agreement.
for family in uniform clusters lattice gridrot globe; do
    points $family 2000
    compare "$family, blind" 5 0 -blind
done

# A file for each process, one of them empty.
build/same -write $dir/p.raw clusters 3000
build/same -write $dir/each.0 clusters 3000 0 2
: >$dir/each.1
build/same -write $dir/each.2 clusters 3000 1 2
mesh 3 0 -each $dir/each && build/same $dir/o 3 $dir/p.raw >$dir/same.out 2>&1
verdict "a file for each process" $?

# An error of one process ends all, with a message.
head -c 100 $dir/p.raw >$dir/short.raw
mesh 3 1 -raw $dir/short.raw
grep "three doubles" $dir/err >/dev/null
verdict "a file that ends amid a point" $?
mesh 3 1 -raw $dir/none.raw
grep "cannot read" $dir/err >/dev/null
verdict "no file" $?
{ head -c 48 $dir/p.raw && printf '\377\377\377\377\377\377\377\377' &&
    tail -c +57 $dir/p.raw; } >$dir/nan.raw
mesh 3 1 -raw $dir/nan.raw
grep "point 2 has a NaN" $dir/err >/dev/null
verdict "a NaN" $?

# No process has much more than its share, an eighth, of one run's memory.
for family in gridrot globe; do
    points $family 200000
    mesh 8 0 -raw $dir/p.raw &&
        build/same $dir/o 8 $dir/p.raw >>$dir/out 2>$dir/same.out &&
        awk '{ for (i = 2; i < NF; i += 2) f[$1 $i] = $(i + 1) }
            END { exit !(0 < f["mesh:memory"] &&
                f["mesh:memory"] < 1.5 / 8 * f["same:memory"]) }' $dir/out
    verdict "memory, $family" $?
done

mesh 3 1 -raw $dir/p.raw -vtu $dir/v -values $dir/short.raw
grep "as many doubles" $dir/err >/dev/null
verdict "values of other points" $?

# VTK finds in the .pvtu file and its pieces what the .tet files hold, and values,
# NaN among them.
if $PYTHON -c 'import numpy, vtk' 2>/dev/null; then
    points clusters 2000
    cat >$dir/vtu.py <<'END'
import sys
import numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy as array
folder, ranks = sys.argv[1], int(sys.argv[2])
points = numpy.fromfile(folder + "/p.raw").reshape(-1, 3)
value = points * numpy.where(numpy.arange(2000) % 7, 1, numpy.nan)[:, None]
if ranks == 0:
    value.tofile(folder + "/value.raw")
    sys.exit()
reader = vtk.vtkXMLPUnstructuredGridReader()
reader.SetFileName(folder + "/v.pvtu")
reader.Update()
m = reader.GetOutput()
index = array(m.GetPointData().GetArray("index"))
assert (array(m.GetPoints().GetData()) == points[index]).all()
for k, name in enumerate(["value", "value2", "value3"]):
    assert numpy.array_equal(array(m.GetPointData().GetArray(name)),
                             value[index, k], equal_nan=True)
tet = index[array(m.GetCells().GetConnectivityArray())].reshape(-1, 4)
assert (tet == numpy.concatenate(
    [numpy.fromfile(f"{folder}/o.{r}.tet", dtype="int64").reshape(-1, 4)
     for r in range(ranks)])).all() and len(tet) > 2000
END
    $PYTHON $dir/vtu.py $dir 0
    mesh 3 0 -raw $dir/p.raw -vtu $dir/v -values $dir/value.raw
    $PYTHON $dir/vtu.py $dir 3
    verdict "VTK reads .pvtu, .vtu" $?
else
    skip ".vtu files are not read back: no numpy, vtk for $PYTHON"
fi

ended
