#!/bin/sh
# values.sh - the time of build/tess from a file of points to a file of values,
# beside SciPy's LinearNDInterpolator on the same files.  Run from the top
# directory, after `make'; bench.sh does.  Prints a table in markdown.
#
# From the environment:
#   POINTS   random points in a cube, with one value each (100000)
#   SIDE     places of a grid along each side of their box (100)
#   REPEATS  runs of which the fastest counts (3)
#   PYTHON   one that has NumPy and SciPy (python3)
POINTS=${POINTS:-100000}
SIDE=${SIDE:-100}
REPEATS=${REPEATS:-3}
PYTHON=${PYTHON:-python3}
mkdir -p build/bench_values
cd build/bench_values || exit 1

awk -v n="$POINTS" 'BEGIN { srand(1); print "x,y,z,value"
    for (i = 0; i < n; i++) {
        x = rand(); y = rand(); z = rand()
        printf "%.9f,%.9f,%.9f,%.9f\n", x, y, z, sin(5 * x) * y + z * z } }' \
    >points.csv
cat >theirs.py <<'end'
import sys
import numpy as np
from scipy.interpolate import LinearNDInterpolator
p = np.loadtxt("points.csv", delimiter=",", skiprows=1)
low, high = p[:, :3].min(0), p[:, :3].max(0)
x, y, z = [np.linspace(a, b, int(sys.argv[1])) for a, b in zip(low, high)]
z, y, x = np.meshgrid(z, y, x, indexing="ij")
np.save(sys.argv[2], LinearNDInterpolator(p[:, :3], p[:, 3:])(x, y, z))
end

# fastest COMMAND...: seconds of the processor, the least of all runs
fastest() {
    round=0
    while [ $round -lt "$REPEATS" ]; do
        # the second line is of what the shell has started
        ("$@" >/dev/null 2>&1; times) |
            awk -F '[ms ]+' 'NR == 2 { print 60 * ($1 + $3) + $2 + $4 }'
        round=$((round + 1))
    done | sort -n | head -n 1
}

# tess METHOD SIDE FILE
tess() {
    fastest ../tess -q -method "$1" -grid "$2,$2,$2" -values "$3" points.csv
}

places=$((SIDE * SIDE * SIDE))
echo "Values at a grid of $places places in the box of $POINTS random points,"
echo "from CSV to .npy: seconds of the whole; of the same for one place; and"
echo "microseconds for each of the others"
echo
echo "| | whole | one place | each |"
echo "| --- | ---: | ---: | ---: |"
for method in linear smooth natural nearest; do
    whole=$(tess $method "$SIDE" $method.npy)
    one=$(tess $method 1 one.npy)
    echo "$whole $one" | awk -v name=$method -v n="$places" '{
        printf "| %s | %.2f | %.2f | %.2f |\n", name, $1, $2,
            ($1 - $2) / n * 1e6 }'
    [ $method = linear ] && linear=$whole
done
if ! $PYTHON -c 'import numpy, scipy' 2>/dev/null; then
    echo "values.sh: no numpy, scipy for $PYTHON: skipped" >&2
    exit 0
fi
whole=$(fastest "$PYTHON" theirs.py "$SIDE" scipy.npy)
one=$(fastest "$PYTHON" theirs.py 1 one.npy)
echo "$whole $one" | awk -v n="$places" '{
    printf "| SciPy, linear | %.2f | %.2f | %.2f |\n", $1, $2,
        ($1 - $2) / n * 1e6 }'
echo
echo "linear/SciPy: $(echo "$linear $whole" | awk '{ printf "%.2f", $1 / $2 }')"
