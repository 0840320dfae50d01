# python.py - tess89 beside SciPy: whether both say the same, and the times;
# tessn.m and tessinterp.m beside Octave's delaunayn and griddatan.
# From the top directory, after `make python octave':
#
#   PYTHONPATH=test/python python3 test/bench/python.py [POINTS [PLACES]]
#
# (20000 points, 100000 places.)  Prints tables in markdown.
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
import scipy
import scipy.interpolate
import scipy.spatial

import tess89

N = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
NQ = int(sys.argv[2]) if len(sys.argv) > 2 else 100000
random = np.random.default_rng(1)


def timed(call, *arguments):
    """What it returns, and milliseconds."""
    start = time.process_time()
    made = call(*arguments)
    return made, 1e3 * (time.process_time() - start)


def each(call, q):
    """What it returns for the places, and microseconds for each."""
    made, spent = timed(call, q)
    return made, 1e3 * spent / len(q)


def cube():
    return random.random((N, 3)), random.random((NQ, 3))


def lattice():
    side = round(N ** (1 / 3))
    grid = np.stack(np.meshgrid(*3 * [np.arange(side)], indexing="ij"), -1)
    # (SciPy looks at all its tetrahedra, some flat, for each place)
    few = NQ // 200
    return grid.reshape(-1, 3) / 10, random.random((few, 3)) * (side - 1) / 10


def boreholes():
    """Down from a survey's grid, in metres, to the centimetre; the places are
    a model's blocks."""
    deep = 50
    side = max(2, round((N / deep) ** 0.5))
    x, y = np.meshgrid(431000 + 25.0 * np.arange(side),
                       6771000 + 25.0 * np.arange(side))
    x, y = (c.ravel() + np.round(random.normal(0, 1, side * side), 2)
            for c in (x, y))
    p = np.column_stack([c.repeat(deep) for c in (x, y)] + [
        np.tile(340.25 - 2 * np.arange(deep), side * side)])
    # (no hole is straight)
    p = np.round(p + random.normal(0, .2, p.shape), 2)
    low, high = p.min(0), p.max(0)
    many = round(NQ ** (1 / 3))
    q = np.meshgrid(*[np.linspace(a, b, many) for a, b in zip(low, high)],
                    indexing="ij")
    return p, np.stack(q, -1).reshape(-1, 3)


def rows(x):
    return set(map(tuple, np.sort(x, axis=1).tolist()))


def beside(tri):
    sets = [frozenset(v) for v in tri.simplices.tolist()]
    return {s: {v: sets[u] if u >= 0 else None for v, u in zip(row, near)}
            for s, row, near in zip(sets, tri.simplices.tolist(),
                                    tri.neighbors.tolist())}


def corners(tri, t):
    x = np.full((len(t), 4), -1)
    x[t >= 0] = np.sort(tri.simplices[t[t >= 0]])
    return x


def same(yes, of=None):
    return ("yes" if yes == of else "%d of %d" % (yes, of)
            ) if of is not None else "yes" if yes else "no"


print("NumPy %s, SciPy %s, tess89 %s" % (np.__version__, scipy.__version__,
                                         tess89.__version__))
print()
print("""Time of the processor: milliseconds, or microseconds for each place.
Off: places within the hull, by tess89's exact signs, that have no value of a
linear field, or one that is wrong by more than 1e-9 of its range.""")
print()
print("| points | what | the same | tess89 | SciPy | SciPy/tess89 |")
print("| --- | --- | --- | ---: | ---: | ---: |")
for family in cube, lattice, boreholes:
    p, q = family()
    name = "%s, %d" % (family.__name__, len(p))

    def row(what, agree, mine, theirs, unit):
        print("| %s | %s | %s | %.2f %s | %.2f %s | %.1f |" % (
            name, what, agree, mine, unit, theirs, unit, theirs / mine),
            flush=True)

    a, mine = timed(tess89.Delaunay, p)
    b, theirs = timed(scipy.spatial.Delaunay, p)
    row("Delaunay: %d and %d simplices" % (a.nsimplex, b.nsimplex),
        same(len(rows(a.simplices) & rows(b.simplices)), a.nsimplex), mine,
        theirs, "ms")
    x, y = beside(a), beside(b)
    print("| %s | neighbors | %s | | | |" % (
        name, same(sum(y.get(s) == x[s] for s in x), len(x))))
    (_, mine), (_, theirs) = (timed(lambda t: t.convex_hull, t) for t in (a, b))
    row("convex_hull", same(rows(a.convex_hull) == rows(b.convex_hull)), mine,
        theirs, "ms")
    (s, mine), (t, theirs) = (each(k.find_simplex, q) for k in (a, b))
    inside = s >= 0
    row("find_simplex: %d places" % len(q), same(int(np.sum(np.all(
        corners(a, s) == corners(b, t), 1))), len(q)), mine, theirs, "us")
    # a linear field and another one, by coordinates that start at 0
    low, size = p.min(0), p.max(0) - p.min(0)
    values, want = (np.column_stack((x @ (1, 2, 3), np.sin(x @ (9, 8, 7))))
                    for x in ((p - low) / size, (q - low) / size))
    f, mine = each(tess89.LinearNDInterpolator(a, values), q)
    g, theirs = each(scipy.interpolate.LinearNDInterpolator(b, values), q)
    off = [int(np.sum(~(abs(x - want)[inside, 0] < 6e-9))) for x in (f, g)]
    row("LinearNDInterpolator: off %d and %d" % tuple(off), same(int(np.sum(
        np.all((abs(f - g) < 1e-11) | np.isnan(f) & np.isnan(g), 1))), len(q)),
        mine, theirs, "us")
    f, mine = each(tess89.Interpolator(a, values, "nearest", None), q)
    g, theirs = each(scipy.interpolate.NearestNDInterpolator(p, values), q)
    row("nearest", same(int(np.sum(np.all(f == g, 1))), len(q)), mine, theirs,
        "us")
    for method in "smooth", "natural":
        few = q[:len(q) // 10] if method == "natural" else q
        _, mine = each(tess89.Interpolator(a, values, method), few)
        print("| %s | %s: %d places | | %.2f us | | |" % (name, method,
                                                        len(few), mine))

if shutil.which("octave-cli"):
    with tempfile.NamedTemporaryFile("w", suffix=".m") as file:
        file.write("""addpath build
rand('twister', 1); p = rand(2000, 3); q = rand(1000, 3); v = p(:, 1);
start = cputime; for k = 1:9 a = tessn(p); end, t = (cputime - start) / 9;
start = cputime; b = delaunayn(p); u = cputime - start;
row = '| %s | %d | %.0f ms | %.0f ms | %.0f |\\n';
printf(row, '2000 points | tessn, delaunayn', isequal( ...
       sortrows(sort(a, 2)), sortrows(sort(b, 2))), 1e3 * t, 1e3 * u, u / t);
start = cputime;
for k = 1:9 a = tessinterp(p, v, q); end, t = (cputime - start) / 9;
start = cputime; b = griddatan(p, v, q); u = cputime - start;
printf(row, '1000 places | tessinterp, griddatan', ...
       all(abs(a - b) < 1e-12 | isnan(a) & isnan(b)), 1e3 * t, 1e3 * u, u / t);
""")
        file.flush()
        print()
        print("| | what | the same | tess | Octave | Octave/tess |")
        print("| --- | --- | --- | ---: | ---: | ---: |", flush=True)
        subprocess.run(["octave-cli", "--norc", "--no-history", file.name],
                       check=True)
