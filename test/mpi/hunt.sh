#!/bin/sh
# hunt.sh [SECONDS [SEED [SETS]]] - sets of points by chance, each by 2 to 8
# processes of test/mpi/mesh.c and by tess: do they give the same mesh?  make mpi
# first.
#
# Small sets, so that a process has few own points and most of its tetrahedra
# are shared: families of test/lib/points.h, random tubes, tori, grids with
# duplicates, two of these together, fewer points than processes.  The first
# line tells the seed; a set that fails is kept in build/mpi.hunt, and its
# command printed.  Returns 1 if any failed.
TIME=${1:-600}
SEED=${2:-$(date +%s)}
SETS=${3:-1000000}
. test/tests.sh
begin hunt
run="mpirun --oversubscribe --allow-run-as-root"
MPIEXEC_TIMEOUT=300
export MPIEXEC_TIMEOUT
dir=build/mpi.hunt
FAMILIES="uniform ball clusters decimal3 aniso lattice lattice01 latticeshuf
    jitlattice bcc fcc spherenorm spherejit spherei cavityi fccturn ellipsoid
    spiral cylinder cylinderrnd prism helix twolines planeone planespread
    paraboloid cubesurf rotcube duplicates pairs farpoint offset tiny huge wide
    gridrot gradedrot gridsph gridcyl extruded globe cap stations spherefull
    shells cavity rotcubein rottet cubegrid tilted9 tilted15 near6 near8 slanted
    cylinderrot torus sheets bumps thinshell terrain survey boreholes tracks
    pipes horizons layers latlon uvsphere"

mkdir -p $dir
echo "# hunt: seed $SEED"
# a line for each set: number, processes, points, what, and its numbers
awk -v seed="$SEED" -v families="$FAMILIES" '
    function below(n) { return int(n * rand()) }
    BEGIN {
        srand(seed)
        many = split(families, family, /[ \n]+/)
        for (i = 1; i <= 1000000; i++) {
            n = below(9) ? 4 + below(700) : 1 + below(12)
            kind = below(2) ? family[1 + below(many)] : "mixed"
            print i, 2 + below(7), n, kind, below(1000000)
        }
    }' > $dir/list

# a torus or tube, a grid with duplicates, or points of both
mixed() {
    awk -v n="$1" -v seed="$2" 'BEGIN {
        srand(seed)
        kind = int(4 * rand()); r = 0.05 + rand(); side = 2 + int(6 * rand())
        slope = rand() < 0.5 ? 0 : 0.1 + rand()
        for (i = 0; i < n; i++) {
            a = 6.283185307179586 * rand(); b = 6.283185307179586 * rand()
            k = kind < 3 ? kind : int(3 * rand())
            if (k == 0) { x = r * cos(a); y = r * sin(a); z = 3 * rand() }
            if (k == 1) {
                x = (1 + r * cos(b)) * cos(a); y = (1 + r * cos(b)) * sin(a)
                z = r * sin(b)
            }
            if (k == 2) {
                x = int(side * rand()); y = int(side * rand())
                z = int(side * rand())
            }
            printf "%.17g %.17g %.17g\n", x, y + slope * z, z - slope * x
        }
    }'
}

end=$(($(date +%s) + TIME))
while read -r number processes n what seed; do
    [ "$(date +%s)" -ge $end ] || [ "$number" -gt "$SETS" ] && break
    name=$what
    if [ $what = mixed ]; then
        mixed $n $seed > $dir/mixed
        name=$dir/mixed
    fi
    build/same -write $dir/p.raw $name $n > /dev/null 2>&1 || continue
    rm -f $dir/o.*
    limited 20 $run -np $processes build/mesh -raw $dir/p.raw -o $dir/o > $dir/out 2> $dir/err < /dev/null
    code=$?
    if [ $code -le 5 ] && [ $code -ne 1 ] && build/same $dir/o $processes \
        $dir/p.raw > $dir/same.out 2>&1; then
        pass "$what $n, $processes processes"
    elif [ $code -ge 3 ] && [ $code -le 5 ]; then
        pass "$what $n, $processes processes: code $code" # (check.sh tests these)
    else
        cp $dir/p.raw $dir/failed.$number.raw
        fail "$what $n, code $code: mpirun -np $processes build/mesh -raw \
$dir/failed.$number.raw -o $dir/o"
    fi
done < $dir/list
ended
