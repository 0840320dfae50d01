# test_tess89.py - tests of tess89, beside SciPy; from the top directory:
#
#   make python
#   PYTHONPATH=test/bindings/python python3 \
#       test/bindings/python/test_tess89.py [FILE]
#
# FILE: what t_tessn.m has left, which is tested, too.
# Prints TAP.
import copy
import doctest
import os
import pickle
import pydoc
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import warnings

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.io import loadmat
from scipy.spatial import ConvexHull, Delaunay, Voronoi, cKDTree

import tess89
from tess89 import _mesh, _values

try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    vtk = None

counts = [0, 0]
# (SciPy's cells take long)
MANY = 12 if os.environ.get("ALL") else 4
# (what a shell runs in the background ignores it)
signal.signal(signal.SIGINT, signal.default_int_handler)


def test(name, good):
    counts[not good] += 1
    print("%s %d - %s" % ("ok" if good else "not ok", sum(counts), name),
          flush=True)


def refuses(name, kind, words, call):
    try:
        call()
    except Exception as e:
        test("refuses " + name, type(e) is kind and words in str(e))
    else:
        test("refuses " + name, False)


def rows(x):
    return set(map(tuple, np.sort(x, axis=1).tolist()))


def near(a, b, most=1e-12):
    """Within most of each other, NaN at the same places."""
    return np.shape(a) == np.shape(b) and np.allclose(a, b, 0, most,
                                                      equal_nan=True)


# ---- what is compared with ----

def cells(points):
    """The Voronoi cells' volumes; infinite for those without an end."""
    diagram = Voronoi(points)
    regions = [diagram.regions[r] for r in diagram.point_region]
    return np.array([np.inf if -1 in r
                     else ConvexHull(diagram.vertices[r]).volume
                     for r in regions])


def natural(points, values, q):
    """Sibson's: the weights are what q's cell takes of the others'."""
    before, after = cells(points), cells(np.vstack((points, q)))
    with np.errstate(invalid="ignore"):
        taken = before - after[:-1]
    taken[np.isnan(taken)] = 0
    assert abs(taken.sum() / after[-1] - 1) < 1e-9
    return taken @ values / after[-1]


def smooth(mesh, values, q, rounds=3):
    """What tr_slopes and tr_bent say that they do, with SciPy's mesh."""
    p, tet = mesh.points, mesh.simplices
    n = len(p)
    a = tet[:, [0, 0, 0, 1, 1, 2]].ravel()
    b = tet[:, [1, 2, 3, 2, 3, 3]].ravel()
    e = p[b] - p[a]
    w = 1 / np.sum(e * e, 1)
    fit = np.linalg.lstsq(np.column_stack((p, np.ones(n))), values, None)[0]
    g = np.tile(fit[:3], (n, 1))
    m = np.zeros((n, 3, 3))
    for end in a, b:
        np.add.at(m, end, w[:, None, None] * e[:, :, None] * e[:, None, :])
    m += 1e-4 * np.trace(m, axis1=1, axis2=2)[:, None, None] * np.eye(3)
    for k in range(rounds + 1):
        r = np.zeros((n, 3))
        for end, other in (a, b), (b, a):
            mean = g[end] if k == 0 else (g[end] + g[other]) / 2
            left = values[b] - values[a] - np.sum(mean * e, 1)
            np.add.at(r, end, (w * left)[:, None] * e)
        g += (1 if k == 0 else 1.8) * np.linalg.solve(m, r[..., None])[..., 0]
    t = mesh.find_simplex(q)
    v = tet[t]
    x = np.einsum("ijk,ik->ij", mesh.transform[t, :3], q - mesh.transform[t, 3])
    x = np.column_stack((x, 1 - x.sum(1)))
    f = np.sum(x * (values[v] + np.sum(g[v] * (q[:, None] - p[v]), 2) / 2), 1)
    return np.where(t < 0, np.nan, f)


# ---- the mesh ----

random = np.random.default_rng(3)
p = random.random((3000, 3))
mesh = tess89.delaunay(p)
theirs = Delaunay(p)
test("delaunay: SciPy's tetrahedra", rows(mesh.tet) == rows(theirs.simplices))
e = p[mesh.tet[:, 1:]] - p[mesh.tet[:, :1]]
test("delaunay: positively oriented", bool(np.all(np.linalg.det(e) > 0)))
k = np.argwhere(mesh.adj >= 0)
beside = mesh.adj[mesh.adj >= 0]
test("delaunay: neighbours share three vertices, the one opposite not", all(
    len(set(mesh.tet[t]) & set(mesh.tet[u])) == 3 and
    mesh.tet[t, i] not in mesh.tet[u] for (t, i), u in zip(k, beside)))
test("delaunay: no duplicates", bool(np.all(mesh.same == np.arange(3000))))
test("delaunay: from a list, in single precision",
     len(tess89.delaunay(p.astype(np.float32).tolist()).tet) > 15000)
twice = tess89.delaunay(np.vstack((p[:100], p[:100])))
test("delaunay: duplicates",
     bool(np.all(twice.same == np.arange(200) % 100)) and
     rows(twice.tet) == rows(Delaunay(p[:100]).simplices))
s = np.linspace(0, 1, 300)
o = 0 * s
lines = tess89.delaunay(np.vstack((np.column_stack((s, o, o)),
                                 np.column_stack((o, s, o + 1)))))
test("delaunay: two lines, whose tetrahedra are more than 8 n",
     len(lines.tet) == 299 * 299)
mine = p.copy()
alone = tess89.delaunay(mine)
mine[:] = 0
test("delaunay: the mesh keeps its points",
     np.array_equal(alone.points, p) and mine.flags.writeable)
refuses("to write a mesh", ValueError, "read-only",
        lambda: mesh.tet.__setitem__(0, 0))
again = pickle.loads(pickle.dumps(mesh))
test("delaunay: a mesh that was pickled", type(again) is tess89.Mesh and
     all(np.array_equal(a, b) for a, b in zip(again, mesh)))
if os.path.exists("/proc/self/status"):
    done = subprocess.run([sys.executable, "-c", """
import numpy, tess89
def peak(what):
    return next(int(line.split()[1]) for line in open("/proc/self/status")
                if line.startswith(what))
p = numpy.random.default_rng(1).random((400000, 3))
before = peak("VmRSS")
tess89.delaunay(p)
print((peak("VmHWM") - before) * 1024 / len(p))"""], stdout=subprocess.PIPE,
                          env=dict(os.environ, PYTHONPATH=os.path.dirname(
                              os.path.dirname(tess89.__file__))))
    test("delaunay: at most 320 bytes a point", float(done.stdout) < 320)

# ---- as scipy.spatial.Delaunay ----


def beside(tri):
    """For each tetrahedron's set of points the set of the neighbour opposite to
    each of them, or None."""
    sets = [frozenset(v) for v in tri.simplices.tolist()]
    return {s: {v: sets[u] if u >= 0 else None for v, u in zip(row, near)}
            for s, row, near in zip(sets, tri.simplices.tolist(),
                                    tri.neighbors.tolist())}


tri = tess89.Delaunay(p)
test("Delaunay: SciPy's neighbours, opposite to each vertex",
     beside(tri) == beside(theirs))
test("Delaunay: SciPy's hull",
     rows(tri.convex_hull) == rows(theirs.convex_hull))
first, near_to = tri.vertex_neighbor_vertices
first2, near_to2 = theirs.vertex_neighbor_vertices
test("Delaunay: SciPy's vertex_neighbor_vertices", len(first) == 3001 and
     first[-1] == len(near_to) and all(
         sorted(near_to[first[i]:first[i + 1]]) ==
         sorted(near_to2[first2[i]:first2[i + 1]]) for i in range(3000)))
test("Delaunay: vertex_to_simplex", all(
    i in tri.simplices[t] for i, t in enumerate(tri.vertex_to_simplex)))
test("Delaunay: SciPy's types and sizes", all(
    np.asarray(getattr(tri, name)).dtype == np.asarray(getattr(theirs,
                                                               name)).dtype and
    np.shape(getattr(tri, name)) == np.shape(getattr(theirs, name))
    for name in ("points", "simplices", "neighbors", "convex_hull", "coplanar",
                 "vertex_to_simplex", "min_bound", "max_bound", "npoints",
                 "nsimplex", "ndim")) and
    first.dtype == first2.dtype and near_to.dtype == near_to2.dtype and
    np.array_equal(tri.min_bound, theirs.min_bound) and
    np.array_equal(tri.max_bound, theirs.max_bound))
x = p[tri.simplices].mean(1)
w = np.einsum("ijk,ik->ij", tri.transform[:, :3], x - tri.transform[:, 3])
test("Delaunay: transform", tri.transform.shape == theirs.transform.shape and
     near(w, np.full((tri.nsimplex, 3), .25), 1e-6))
doubled = np.vstack((p[:200], p[50:90], p[:5]))
tri2, theirs2 = tess89.Delaunay(doubled), Delaunay(doubled)
at = tri2.coplanar
test("Delaunay: duplicates are coplanar, at their twins' tetrahedra",
     at[:, 0].tolist() == list(range(200, 245)) and
     at[:, 2].tolist() == list(range(50, 90)) + list(range(5)) and
     all(v in tri2.simplices[t] for _, t, v in at) and
     len(at) == len(theirs2.coplanar) and
     bool(np.all(tri2.vertex_to_simplex[200:] == -1)))


def twins(x):
    return rows(np.where(x >= 200, np.where(x < 240, x - 150, x - 240), x))


test("Delaunay: duplicates, SciPy's tetrahedra",
     twins(tri2.simplices) == twins(theirs2.simplices))
q = 1.4 * random.random((40, 50, 3)) - 0.2
for name, x in (("places in rows", q), ("one place", q[0, 0]),
                ("a list", q[0].tolist()), ("a tuple", tuple(q[0, 0])),
                ("none", np.empty((0, 3))), ("none in rows", q[:, :0]),
                ("NaN, infinities", np.array([[np.nan, 0, 0], [.5, np.inf, .5],
                                              [.5, .5, .5]]))):
    mine, want = tri.find_simplex(x), theirs.find_simplex(x)
    test("find_simplex: SciPy's, " + name, mine.dtype == want.dtype and
         mine.shape == want.shape and
         np.array_equal(mine < 0, want < 0) and np.array_equal(
             np.sort(tri.simplices[mine[mine >= 0]]),
             np.sort(theirs.simplices[want[want >= 0]])))
test("find_simplex: bruteforce", np.array_equal(
    tri.find_simplex(q, bruteforce=True), tri.find_simplex(q)))
for name in "furthest_site", "incremental", "qhull_options":
    refuses("Delaunay: " + name, ValueError, name,
            lambda: tess89.Delaunay(p, **{name: True}))
refuses("find_simplex: tol", ValueError, "tol",
        lambda: tri.find_simplex(q, tol=0.1))
refuses("find_simplex: two coordinates", ValueError, "xi",
        lambda: tri.find_simplex(q[..., :2]))
refuses("Delaunay: points in a plane", ValueError, "(3000, 2)",
        lambda: tess89.Delaunay(p[:, :2]))
again = pickle.loads(pickle.dumps(tri))
test("Delaunay: pickled", beside(again) == beside(tri) and
     np.array_equal(again.find_simplex(q), tri.find_simplex(q)))

# ---- by brute force, where roundings make SciPy wrong: boreholes with
# coordinates of seven digits, in centimetres ----


def det(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) -
            a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0]))


def exact(x):
    """Of what are whole centimetres: Python's integers."""
    return np.array([[round(100 * c) for c in row] for row in x.tolist()],
                    object)


def orient(a, b, c, d):
    return det((b - a).T, (c - a).T, (d - a).T)


def insphere(a, b, c, d, e):
    """> 0 where e is in the ball of a positive tetrahedron."""
    a, b, c, d = (x - e for x in (a, b, c, d))
    square = [sum((x * x).T) for x in (a, b, c, d)]
    a, b, c, d = a.T, b.T, c.T, d.T
    return (det(b, c, d) * square[0] - det(a, c, d) * square[1] +
            det(a, b, d) * square[2] - det(a, b, c) * square[3])


east, north = np.meshgrid(431200 + 25 * np.arange(5), 6771350 +
                          25 * np.arange(4))
holes = np.array([(x, y, 340.25 - 2 * k) for x, y in
                  zip(east.ravel(), north.ravel()) for k in range(8)])
holes[:, :2] += random.integers(-300, 300, (20, 2)).repeat(8, 0) / 100
tri2 = tess89.Delaunay(holes)
h = exact(holes)
v = h[tri2.simplices]
test("brute force: no tetrahedron is flat or turned", bool(
    np.all(orient(*v.swapaxes(0, 1)) > 0)))
test("brute force: no point in any ball", all(
    bool(np.all(insphere(*v.swapaxes(0, 1), x) <= 0)) for x in h))
# these are whole centimetres as integers, for doubles no less
x, y, z = np.meshgrid(431190 + 12.5 * np.arange(11), 6771340 +
                      12.5 * np.arange(9), 326.25 + 2 * np.arange(9),
                      indexing="ij")
blocks = np.stack((x, y, z), -1).reshape(-1, 3)
found = tri2.find_simplex(blocks)


def as_integers(x):
    """Doubles of at least 2 ** -10, times 2 ** 62."""
    return np.array([[int(c * 2.0 ** 62) for c in row] for row in x.tolist()],
                    object)


hf, bf = as_integers(holes), as_integers(blocks)
inside = found >= 0
v, x = hf[tri2.simplices[found[inside]]].swapaxes(0, 1), bf[inside]
test("brute force: the tetrahedra found hold the blocks", 99 < sum(inside) and
     all(bool(np.all(orient(*[x if j == k else v[j] for j in range(4)]) >= 0))
         for k in range(4)))
a, b, c = hf[tri2.convex_hull].swapaxes(0, 1)
test("brute force: what is not found is outside", 9 < sum(~inside) and all(
    bool(np.any(orient(a, b, c, x) > 0)) for x in bf[~inside]))

# ---- locate ----

q = 1.4 * random.random((40, 50, 3)) - 0.2
found, w = tess89.locate(mesh, q)
want = theirs.find_simplex(q)
test("locate: -1 where SciPy has it, shapes", found.shape == (40, 50) and
     w.shape == (40, 50, 4) and
     bool(np.all((found < 0) == (want < 0))) and 0 < (found < 0).sum() < 2000)
inside = found >= 0
test("locate: SciPy's tetrahedra",
     bool(np.all(np.sort(mesh.tet[found[inside]]) ==
                 np.sort(theirs.simplices[want[inside]]))))
x = np.einsum("ijk,ij->ik", p[mesh.tet[found[inside]]], w[inside])
test("locate: weights", near(x, q[inside], 1e-14) and bool(
    np.all(w[inside] >= 0)) and bool(np.all(np.isnan(w[~inside]))))
t, w = tess89.locate(mesh, [9, 9, 9])
test("locate: one place", t.shape == () and t == -1 and w.shape == (4,))
for name, bad in ("a NaN", np.nan), ("an infinity", -np.inf):
    some = q[:5, 0].copy()
    some[2, 1] = bad
    t, w = tess89.locate(mesh, some)
    test("locate: %s is nowhere" % name, t[2] == -1 and np.isnan(w[2]).all() and
         np.array_equal(np.delete(t, 2), np.delete(found[:5, 0], 2)))
none = np.empty((7, 0, 3))
test("locate: no places", tess89.locate(mesh, none)[0].shape == (7, 0))

# ---- values ----

values = np.column_stack((np.sin(9 * p[:, 0]), p[:, 1] * p[:, 2]))
got = tess89.interpolate(mesh, values, q)
want = LinearNDInterpolator(p, values)(q)
test("interpolate: SciPy's values, NaN at the same places",
     got.shape == (40, 50, 2) and near(got, want))
one = tess89.interpolate(mesh, values[:, 0], q)
test("interpolate: one value a point", one.shape == (40, 50) and
     np.array_equal(one, got[..., 0], equal_nan=True))
deep = np.stack((values, 2 * values, -values), 2)
test("interpolate: an array a point", near(
    tess89.interpolate(mesh, deep, q), LinearNDInterpolator(p, deep)(q)))
test("interpolate: outside", np.array_equal(
    tess89.interpolate(mesh, values, q, fill_value=-5.0)[~inside],
    np.full((np.count_nonzero(~inside), 2), -5.0)))
corners = np.array([[i, j, l] for i in (0, 1) for j in (0, 1) for l in (0, 1)])
cube = np.vstack((corners, p))
for nearest in "nearest", None:
    test("interpolate: outside as on the hull, %s" % nearest, near(
        tess89.interpolate(tess89.delaunay(cube), cube @ (1, 2, 3), q,
                         fill_value=nearest), np.clip(q, 0, 1) @ (1, 2, 3)))
test("interpolate: an array that is not contiguous", np.array_equal(
    tess89.interpolate(mesh, values[:, ::-1], q), got[..., ::-1],
    equal_nan=True))
# many places are equal, or in one plane, line, spot; 0 and -0
for name, many in (("equal ones", q[0, random.integers(0, 50, 999)]),
                   ("a plane", q * (1, 0, 1) + (0, .5, 0)),
                   ("a line", q * (0, 1, 0) + (.3, 0, .5)),
                   ("one spot", 0 * q + .5), ("a single one", q[:1, 0]),
                   ("zeros", random.choice([-0.0, 0.0], (99, 3)))):
    test("interpolate: " + name, near(
        tess89.interpolate(mesh, values, many),
        LinearNDInterpolator(p, values)(many)))
for method in _values._METHODS:
    some = q[:9, 0].copy()
    some[3, 0] = np.nan
    f = tess89.interpolate(mesh, values, some, method, fill_value=7)
    test("interpolate: %s, a NaN among the places" % method,
         np.argwhere(np.isnan(f)).tolist() == [[3, 0], [3, 1]])

f = tess89.Interpolator(p, values)
theirs_f = LinearNDInterpolator(p, values)
x, y, z = q[..., :1, 0], q[:1, ..., 1], 0.5
test("Interpolator: as SciPy's, of points", near(f(q), theirs_f(q)))
test("Interpolator: of three arrays", near(f(x, y, z), theirs_f(x, y, z)))
test("Interpolator: one place", f([.5, .5, .5]).shape == (1, 2) and
     tess89.Interpolator(mesh, values[:, 0])(.5, .5, .5).shape == ())

flat = q.reshape(-1, 3)
f = tess89.interpolate(mesh, values, flat, "smooth")
want = np.column_stack([smooth(theirs, v, flat) for v in values.T])
test("smooth: by NumPy", near(f, want, 1e-9))
f = tess89.interpolate(mesh, values, flat, "nearest", fill_value="nearest")
test("nearest: SciPy's cKDTree", np.array_equal(
    f, values[cKDTree(p).query(flat)[1]]))
few, some = p[:300], .35 + .3 * random.random((12, 3))
f = tess89.Interpolator(few, values[:300], "natural")(some)
test("natural: by SciPy's Voronoi cells", near(
    f[:MANY], np.array([natural(few, values[:300], x) for x in some[:MANY]]),
    1e-9))
ball = random.normal(size=(400, 3))
ball /= np.sqrt(np.sum(ball**2, 1))[:, None]
ball = np.vstack((ball, 1.01 * ball[:9]))
f = tess89.Interpolator(ball, ball @ (1, 2, 3), "natural")(.3 * some)
test("natural: hundreds of neighbours", near(f, .3 * some @ (1, 2, 3)))

# a calculation that other threads disturb would have other values
f = [tess89.Interpolator(mesh, values, m) for m in _values._METHODS]
want = [g(q) for g in f]
wrong = []


def work(g, want):
    for _ in range(3):
        if not np.array_equal(g(q), want, equal_nan=True):
            wrong.append(g.method)


threads = [threading.Thread(target=work, args=a) for a in zip(2 * f, 2 * want)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
test("eight threads", wrong == [])

# ---- as scipy.interpolate.LinearNDInterpolator ----


def alike(name, mine, want, most=1e-12):
    test(name, type(mine) is np.ndarray and mine.dtype == want.dtype and
         near(mine, want, most))


q = 1.4 * random.random((40, 50, 3)) - 0.2
three = q[0, :3] / 2 + .2
for columns, given in ("(n,)", values[:, 0]), ("(n, 2)", values):
    mine, want = (kind(p, given) for kind in (tess89.LinearNDInterpolator,
                                              LinearNDInterpolator))
    for name, x in (("f(q)", (q,)), ("f([x, y, z])", ([.5, .4, .3],)),
                    ("f of six numbers", ([.5, .4, .3, .2, .5, .5],)),
                    ("f((x, y, z)), one place", ((.5, .4, .3),)),
                    ("f((x, y, z)), three places", (tuple(three),)),
                    ("f((x, y, z)), tuples of three", ((
                        (.2, .3, .4), (.5, .6, .7), (.3, .5, .3)),)),
                    ("f((x, y, z)) that broadcast", ((q[:, :1, 0], q[0, :, 1],
                                                      .5),)),
                    ("f(x, y, z) that broadcast", (q[:, :1, 0], q[0, :, 1],
                                                   .5)),
                    ("f(x, y, z), numbers", (.5, .4, .3)),
                    ("f of three places", (three,)),
                    ("f of a list of three places", (three.tolist(),)),
                    ("f of none", (np.empty((0, 3)),))):
        alike("LinearNDInterpolator: SciPy's %s, values %s" % (name, columns),
              mine(*x), want(*x))
test("LinearNDInterpolator: a tuple of places is never three of them",
     not near(mine(tuple(three)), mine(three)))
for options in ({"fill_value": -3}, {"rescale": True},
                {"rescale": True, "fill_value": 2.5}):
    stretched = p * (1, 40, 1e-3)
    alike("LinearNDInterpolator: SciPy's, %s" % options,
          tess89.LinearNDInterpolator(stretched, values, **options)(
              q * (1, 40, 1e-3)),
          LinearNDInterpolator(stretched, values, **options)(
              q * (1, 40, 1e-3)), 1e-9)
alike("LinearNDInterpolator: of a Delaunay",
      tess89.LinearNDInterpolator(tri, values)(q), want(q))
alike("LinearNDInterpolator: points as a tuple",
      tess89.LinearNDInterpolator(tuple(p.T), values)(q), want(q))
alike("LinearNDInterpolator: fill_value by place",
      tess89.LinearNDInterpolator(p, values, -3)(q),
      LinearNDInterpolator(p, values, -3)(q))
test("LinearNDInterpolator: its mesh", mine.tri.simplices is
     mine.mesh.tet and rows(mine.tri.simplices) == rows(want.tri.simplices) and
     np.array_equal(mine.points, want.points) and
     np.array_equal(mine.values, want.values))
f = tess89.LinearNDInterpolator(p * (1, 40, 1e-3), values, rescale=True)
test("rescale: the mesh is of scaled points", near(
    np.ptp(f.tri.points, axis=0), np.ones(3)))
test("rescale: the far end of doubles is outside, NaN is none", near(f(
    [[1e308, 0, -1e308], [np.nan, 0, 0]]), np.full((2, 2), np.nan)) and near(
        tess89.LinearNDInterpolator(p * 1e-9, values[:, 0], 7, True)(
            [[1e308, 0, -1e308], [np.nan, 0, 0], [0, 0, np.inf]]),
        [7, np.nan, np.nan]))
refuses("rescale: points in a plane", ValueError, "one plane",
        lambda: tess89.Interpolator(p * (1, 1, 0), values, rescale=True))
for name, call in (("points", lambda: tess89.Interpolator(p + 1j, values)),
                   ("values", lambda: tess89.Interpolator(p, values + 1j)),
                   ("places", lambda: mine(q + 1j)),
                   ("places", lambda: mine(q[..., 0] + 1j, .5, .5)),
                   ("fill_value", lambda: tess89.LinearNDInterpolator(
                       p, values, 1j))):
    refuses("complex " + name, TypeError, name + ": complex", call)
for name, call in (("two arrays", lambda: mine(q[0], q[1])),
                   ("a tuple of two", lambda: mine((q[0], q[1]))),
                   ("four numbers", lambda: mine([1, 2, 3, 4])),
                   ("places of two coordinates", lambda: mine(q[..., :2])),
                   ("rescale with a mesh", lambda: tess89.Interpolator(
                       tri, values, rescale=True)),
                   ("a method that is no word", lambda: tess89.Interpolator(
                       p, values, ["linear"])),
                   ("rescale beyond doubles", lambda: tess89.Interpolator(
                       (p - .5) * 1.7e308 * 2, values, rescale=True))):
    refuses(name, ValueError, "tess89: ", call)

# ---- missing values ----


def warned(call):
    """What it returns, and the warnings, with the file that they blame."""
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        made = call()
    return made, [(str(w.message), w.filename) for w in said]


some = q.reshape(-1, 3)[:400]
holed = np.column_stack((values, values[:, 0], values[:, 1]))
gone = random.choice(3000, 700, replace=False)
holed[gone[:300], 1] = np.nan
holed[gone[300:], 3] = np.nan
for method in _values._METHODS:
    f, said = warned(lambda: tess89.Interpolator(p, holed, method))
    test("missing values: %s, a warning that counts" % method, len(said) == 1
         and "2 of 4 columns of 3000 values" in said[0][0] and
         "(column 1: 300, column 3: 400)" in said[0][0] and
         said[0][1] == __file__)
    want = np.column_stack([tess89.Interpolator(
        p[~np.isnan(c)], c[~np.isnan(c)], method)(some) for c in holed.T])
    # (which of the tetrahedra at a face is found is no matter but for rounding)
    test("missing values: %s, as if their points were not there" % method,
         near(f(some), want) and np.isfinite(want[:, 1]).sum() > 99)
    f, said = warned(lambda: tess89.interpolate(mesh, holed[:, 1], some,
                                                method))
    test("missing values: %s, with a mesh at hand" % method,
         near(f, want[:, 1]) and len(said) == 1 and
         "300 of 3000 are NaN" in said[0][0])
f, said = warned(lambda: tess89.LinearNDInterpolator(p, holed[:, 3]))
test("missing values: LinearNDInterpolator", near(f(some), tess89.Interpolator(
    p[~np.isnan(holed[:, 3])], holed[~np.isnan(holed[:, 3]), 3])(some)) and
    "400 of 3000" in said[0][0] and said[0][1] == __file__ and
    len(f.tri.points) == 3000)
_, said = warned(lambda: tess89.Interpolator(p, values, "smooth"))
test("missing values: no warning where there are none", said == [])
with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    refuses("no value at all in a column", ValueError, "column 1",
            lambda: tess89.Interpolator(p, values * (1, np.nan)))
    flat = np.where(p[:, 2:] < .5, np.nan, values)
    level = np.where(p[:, 2:] < .5, p, p * (1, 1, 0) + (0, 0, .5))
    refuses("values in one plane alone", ValueError, "1",
            lambda: tess89.Interpolator(level, flat))
    lost = p.copy()
    lost[[1234, 2345], 1] = np.nan
    nowhere = np.where(np.isnan(lost[:, 1:2]), np.nan, values)
    refuses("a point that is NaN, whose value is, too", ValueError,
            "points, row 1234: column 1: NaN",
            lambda: tess89.Interpolator(lost, nowhere))
huge = values.copy()
huge[77, 1] = -np.inf
refuses("an infinite value, smooth", ValueError, "row 77",
        lambda: tess89.Interpolator(p, huge, "smooth"))
refuses("gradients beyond doubles", ValueError, "gradient",
        lambda: tess89.Interpolator(p * 1e-200, values * 1e200, "smooth"))
test("an infinite value, nearest: its own place", np.array_equal(
    tess89.Interpolator(p, huge, "nearest")(p[77:78]), huge[77:78]))

# ---- points that coincide ----

order = random.permutation(600)
number = np.concatenate((np.arange(300), np.arange(200), np.arange(100)))[order]
copies = p[number]
given = random.random((600, 2))
mean = np.array([[c[number == i].mean() for c in given.T] for i in range(300)])
for method in _values._METHODS:
    want = tess89.Interpolator(p[:300], mean, method)(some)
    test("duplicates: the mean of values, " + method, near(
        tess89.Interpolator(copies, given, method)(some), want, 1e-11))
test("duplicates: equal values stay what they are", np.array_equal(
    tess89.Interpolator(copies, np.full(600, .1), "nearest", None)(some),
    np.full(400, .1)))
gappy = given.copy()
gappy[::7, 1] = np.nan
want = np.array([np.nanmean(gappy[number == i, 1])
                 if not np.isnan(gappy[number == i, 1]).all() else np.nan
                 for i in range(300)])
f, _ = warned(lambda: tess89.Interpolator(copies, gappy[:, 1]))
has = ~np.isnan(want)
test("duplicates: the mean of those that are there", near(
    f(some), tess89.Interpolator(p[:300][has], want[has])(some), 1e-11))
program = os.path.join("build", "tess")
if os.access(program, os.X_OK):
    with tempfile.TemporaryDirectory() as top:
        names = [os.path.join(top, x) for x in ("p.csv", "q.csv", "v.csv")]
        np.savetxt(names[0], np.hstack((copies, given)), "%.17g", ",")
        np.savetxt(names[1], some, "%.17g", ",")
        for method in _values._METHODS:
            subprocess.run([program, "-q", "-method", method, "-query",
                            names[1], "-values", names[2], names[0]],
                           check=True, stderr=subprocess.DEVNULL)
            theirs = np.genfromtxt(names[2], delimiter=",")[-400:, -2:]
            test("duplicates: as build/tess, " + method, near(
                tess89.Interpolator(copies, given, method)(some), theirs,
                1e-14 if method == "nearest" else 1e-11))

# ---- text ----

names = np.array(["granite", "clay", "sand", "silt", "peat"])
rock = names[random.integers(0, 5, (3000, 2))]
_, at = cKDTree(p).query(some)
out = Delaunay(p).find_simplex(some) < 0
assert out.sum() > 99 and (~out).sum() > 99
for what, given, none in (("str", rock, ""), ("bytes", np.char.encode(rock), ""),
                          ("objects", rock.astype(object), None)):
    f, said = warned(lambda: tess89.Interpolator(p, given, "nearest"))
    got = f(some)
    test("text: the nearest point's, " + what, said == [] and
         np.array_equal(got[~out], rock[at[~out]]) and
         got.dtype.kind == ("O" if what == "objects" else "U") and
         all(x is none or x == none and none == "" for x in got[out].flat))
    test("text: beyond the hull, too, " + what, np.array_equal(
        tess89.Interpolator(p, given, "nearest", "nearest")(some), rock[at]))
    test("text: other text outside, longer than all, " + what, all(
        tess89.Interpolator(mesh, given, "nearest", "no rock there")(
            some)[out].flat == np.full(2 * out.sum(), "no rock there")))
    test("text: places that are not finite, " + what, all(
        x is none or x == none for x in tess89.Interpolator(
            p, given, "nearest", "nowhere")([[.5, np.nan, .5]]).flat))
    test("text: interpolate", np.array_equal(
        tess89.interpolate(mesh, given[:, 0], some, "nearest"), got[:, 0]))
    for method in _values._METHODS[:3]:
        refuses("text, method %s, %s" % (method, what), TypeError,
                "method %r is for numbers; 'nearest' takes text" % method,
                lambda: tess89.Interpolator(p, given, method))
test("text: in Greek, of one value a point", tess89.Interpolator(
    p, np.char.replace(rock[:, 0], "clay", "\u03ac\u03c1").tolist(),
    "nearest")(p[rock[:, 0] == "clay"][:9]).tolist() == 9 * ["\u03ac\u03c1"])
for what, none in (("None", None), ("''", ""), ("NaN", np.nan)):
    holed = rock.astype(object)
    holed[gone[:300], 1] = none
    f, said = warned(lambda: tess89.Interpolator(p, holed, "nearest"))
    has = np.ones(3000, bool)
    has[gone[:300]] = False
    want = tess89.Interpolator(p[has], holed[has, 1], "nearest", "out")(some)
    got = f(some)
    test("text: %s leaves a point out" % what, len(said) == 1 and
         "column 1: 300" in said[0][0] and said[0][1] == __file__ and
         np.array_equal(got[want != "out", 1], want[want != "out"]) and
         (want != "out").sum() > 99 and got[want == "out", 1].tolist() ==
         [None] * (want == "out").sum())
f, said = warned(lambda: tess89.Interpolator(
    np.vstack((p, p[:20])), np.vstack((rock, np.roll(rock[:20], 1, 1))),
    "nearest"))
test("text: of points that coincide the first one's, and it is told",
     np.array_equal(f(p), rock) and len(said) == 1 and
     "%d points" % (rock[:20, 0] != rock[:20, 1]).sum() in said[0][0] and
     said[0][1] == __file__)
_, said = warned(lambda: tess89.Interpolator(
    np.vstack((p, p[:20])), np.vstack((rock, rock[:20])), "nearest"))
test("text: the same of points that coincide: no warning", said == [])
refuses("text and numbers", TypeError, "row 7 has 3",
        lambda: tess89.Interpolator(p, np.array(
            [3 if i == 7 else "a" for i in range(3000)], object), "nearest"))
refuses("a number outside of text", ValueError, "not 7",
        lambda: tess89.Interpolator(p, rock, "nearest", 7))

# ---- surfaces of equal value ----


def vectors(c):
    """Of triangles of such corners: to where they face, of twice the area."""
    return np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])


def area(c):
    return np.linalg.norm(vectors(c), axis=1).sum() / 2


def volume(c):
    return np.einsum("ij,ij", c[:, 0] - c[0, 0], vectors(c)) / 6


def edges(t):
    """Of each edge how many triangles have it, less those that have it the
    other way; and how many have it."""
    a, b = t.ravel(), np.roll(t, -1, 1).ravel()
    _, number = np.unique(np.sort(np.column_stack((a, b)), 1), axis=0,
                          return_inverse=True)
    number = number.ravel()
    return (np.bincount(number, np.where(a < b, 1, -1)), np.bincount(number))


def contour(points, tet, field, level):
    """The triangles of VTK's contour filter, in doubles."""
    grid = vtk.vtkUnstructuredGrid()
    place = vtk.vtkPoints()
    place.SetDataTypeToDouble()
    place.SetData(numpy_to_vtk(np.array(points), 1))
    grid.SetPoints(place)
    grid.Allocate(len(tet))
    for row in tet.tolist():
        grid.InsertNextCell(vtk.VTK_TETRA, 4, row)
    grid.GetPointData().SetScalars(numpy_to_vtk(np.array(field), 1))
    made = vtk.vtkContourFilter()
    made.SetInputData(grid)
    made.SetOutputPointsPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    made.GenerateTrianglesOn()
    made.ComputeNormalsOff()
    made.SetValue(0, level)
    made.Update()
    x = vtk_to_numpy(made.GetOutput().GetPoints().GetData())
    return x[vtk_to_numpy(made.GetOutput().GetPolys().GetConnectivityArray())
             .reshape(-1, 3)]


corner = np.indices((2, 2, 2)).reshape(3, -1).T
box = np.vstack((corner, random.random((700, 3))))
on = np.arange(8, 308), np.arange(300) % 3
box[on] = np.rint(box[on])
field = np.sin(5 * box[:, 0]) + box[:, 1] * np.cos(4 * box[:, 2])
tri = tess89.Delaunay(box)
f = tess89.LinearNDInterpolator(tri, field)
if not vtk:
    print("        skipped: tess89.iso beside VTK: no vtk")
for level in -.3, .25, 1.1:
    v, t = tess89.iso(box, field, level)
    if vtk:
        want = area(contour(tri.points, tri.simplices, field, level))
        test("iso: the area of level %g is that of VTK's contour filter" %
             level, want > .1 and abs(area(v[t]) - want) <= 1e-12 * want)
    test("iso: places of level %g" % level, len(v) > 99 and
         near(f(v), np.full(len(v), level)))
    for what, x in (("a Delaunay", tri), ("a Mesh", tri.mesh)):
        a, b = tess89.iso(x, field, level)
        test("iso: the same, with " + what,
             np.array_equal(a, v) and np.array_equal(b, t))
    a, b = tess89.iso(f, None, level)
    test("iso: the same, with an Interpolator",
         np.array_equal(a, v) and np.array_equal(b, t))
    turn, many = edges(t)
    test("iso: open along the hull at level %g" % level,
         np.any(turn != 0) and set(many) == {1, 2})
    v, t = tess89.iso(box, field, level, closed=True)
    turn, many = edges(t)
    test("iso: closed at level %g: an edge twice, once a way" % level,
         np.all(turn == 0) and np.all(many == 2) and
         np.array_equal(np.unique(t), np.arange(len(v))))
    below = tess89.iso(box, -field, -level, closed=True)
    test("iso: closed at level %g: above and below fill the box" % level,
         volume(v[t]) > 0 and
         abs(volume(v[t]) + volume(below[0][below[1]]) - 1) < 1e-12)
for closed in False, True:
    v, t = tess89.iso(box, 3 * box[:, 0] + 1, 2.2, closed)
    test("iso: a plane, closed: %s" % closed, abs(
        volume(v[t]) - .6 if closed else area(v[t]) - 1) < 1e-12 and
        (closed or np.all(np.abs(v[:, 0] - .4) < 1e-14) and
         np.all(vectors(v[t])[:, 0] <= 0)))
size = np.array([1, 1e4, 1e-3])
f = tess89.LinearNDInterpolator(box * size, field, rescale=True)
v, t = tess89.iso(f, None, .25)
test("iso: rescale, places in the units given", len(v) > 99 and
     near(f(v), np.full(len(v), .25), 1e-9) and np.ptp(v[:, 1]) > 5e3)
holed = field.copy()
holed[100:300] = np.nan
(v, t), said = warned(lambda: tess89.iso(box, holed, .25))
a, b = tess89.iso(np.delete(box, np.s_[100:300], 0), np.delete(
    field, np.s_[100:300]), .25)
test("iso: NaN leaves a point out, with a warning", np.array_equal(a, v) and
     np.array_equal(b, t) and len(said) == 1 and "200 of 708" in said[0][0] and
     said[0][1] == __file__)
v, t = tess89.iso(np.vstack((box, box)), np.concatenate((field - 1, field + 1)),
                  .25)
a, b = tess89.iso(box, field, .25)
test("iso: points that coincide have the mean of values",
     near(np.sort(v, 0), np.sort(a, 0)) and t.shape == b.shape)
for closed, many in (False, 0), (True, len(tri.convex_hull)):
    v, t = tess89.iso(box, field, -9, closed)
    test("iso: all above the level: nothing, or the hull", t.shape == (many, 3)
         and v.dtype == np.float64 and t.dtype == np.intc and
         (not closed or abs(volume(v[t]) - 1) < 1e-12))
    v, t = tess89.iso(box, field, 9, closed)
    test("iso: all below the level: nothing", v.shape == t.shape == (0, 3))
infinite = np.where(np.arange(708) == 77, np.inf, field)
for name, words, call in (
        ("infinite values", "row 77", lambda: tess89.iso(box, infinite, 0)),
        ("a level that is NaN", "level",
         lambda: tess89.iso(box, field, np.nan)),
        ("two levels", "level", lambda: tess89.iso(box, field, [0, 1])),
        ("two values a point", "one value a point",
         lambda: tess89.iso(box, box[:, :2], 0)),
        ("no values", "values", lambda: tess89.iso(box, None, 0)),
        ("an Interpolator and values", "values",
         lambda: tess89.iso(f, field, 0)),
        ("an Interpolator, smooth", "'linear', not of 'smooth'",
         lambda: tess89.iso(tess89.Interpolator(box, field, "smooth"), None,
                            0))):
    refuses("iso: " + name, ValueError, words, call)
refuses("iso: text", TypeError, "text",
        lambda: tess89.iso(box, names[np.arange(708) % 5], 0))

# ---- nothing crashes ----


def damages(x, most):
    """x with each kind of damage: of shape, type, size, and of one number."""
    yield None
    yield "abc"
    yield x[:-1]
    yield x.astype(complex)
    yield x.astype(object)
    yield np.ma.masked_array(x, np.zeros(x.shape, bool))[:0]
    yield x[..., None]
    yield x.ravel()[1:]
    yield [[1], [2, 3]]
    if x.dtype.kind == "i":
        yield x.astype(float)
        for shift in 2**32, -2**32, 2**31, 2**63:
            yield x.astype(object) + shift
        for kind, shift in ((np.int64, 2**32), (np.int64, -2**32),
                            (np.uint64, 2**63), (np.uint32, 2**31)):
            yield x.astype(kind) + np.array(shift, kind)
        other = np.array(x)
        other.flat[0] = -3
        yield other
        other = np.array(x)
        other.flat[-1] += 1 - 2 * (other.flat[-1] > 0)
        yield other
        yield np.arange(x.size, dtype=x.dtype).reshape(x.shape)
        yield np.roll(x, 1, 0)
        yield x.max() - x
    else:
        for bad in np.nan, np.inf, 9.0:
            other = np.array(x)
            other.flat[7] = bad
            yield other
        yield x * (1, 1, 0)
        yield -x
    for _ in range(25):
        other = np.array(x)
        i = random.integers(other.size)
        old = other.flat[i]
        while other.flat[i] == old:
            other.flat[i] = (random.integers(-2, most + 2)
                             if x.dtype.kind == "i" else random.random() * 9)
        yield other


def build(parts):
    """By each way that there is to make a Mesh."""
    yield lambda: tess89.Mesh(*parts)
    yield lambda: tess89.Mesh._make(parts)
    yield lambda: small._replace(**dict(zip(small._fields, parts)))
    yield lambda: pickle.loads(pickle.dumps(small)).__class__(*parts)


small = tess89.delaunay(np.vstack((p[:60], p[:3])))
most = {"points": 0, "tet": 63, "adj": len(small.tet), "same": 63}
for i, name in enumerate(small._fields):
    wrong = []
    for k, bad in enumerate(damages(small[i], most[name])):
        for way, make in enumerate(build(small[:i] + (bad,) + small[i + 1:])):
            try:
                make()
                wrong.append((k, way, "taken"))
            except ValueError as e:
                if "tess89" not in str(e):
                    wrong.append((k, way, e))
            except Exception as e:
                wrong.append((k, way, e))
    test("Mesh: damaged %s is a ValueError%s" % (name, wrong or ""),
         wrong == [])
for name, call in (("three arrays", lambda: tess89.Mesh._make(small[:3])),
                   ("another name", lambda: small._replace(tets=1)),
                   ("an unfinished mesh", lambda: small._replace(
                       tet=small.tet[:-1], adj=small.adj[:-1])),
                   ("another mesh", lambda: small._replace(
                       tet=mesh.tet, adj=mesh.adj)),
                   ("a writeable mesh", lambda: setattr(
                       small.tet.flags, "writeable", True))):
    refuses("Mesh: " + name, ValueError, "", call)
arrays = [np.array(x) for x in small]
taken = tess89.Mesh(*arrays)
for x in arrays:
    x[:] = 77
test("Mesh: arrays that are changed later", taken == small and
     taken._replace() == small and copy.deepcopy(small) == small and
     copy.copy(small) == small)
test("Mesh: == and != are answers", (small == small) is True and
     (small != small) is False and (small == mesh) is False and
     (small != mesh) is True and (small == 3) is False and
     (small == tuple(small)) is False and (small != None) is True and
     (small == tess89.delaunay(2 * small.points)) is False and
     (small != tess89.delaunay(2 * small.points)) is True and
     (small == tess89.delaunay(small.points)) is True)
test("Mesh: its tuple", [*small] == [small.points, small.tet, small.adj,
                                     small.same] and len(small) == 4)

f = tess89.Interpolator(mesh, values)
for name, thing, value in (("mesh", tri, small), ("points", tri, p[:5]),
                           ("simplices", tri, tri.simplices),
                           ("neighbors", tri, tri.neighbors),
                           ("method", f, "nearest"), ("mesh", f, small),
                           ("tri", f, tri)):
    refuses("%s: another %s" % (type(thing).__name__, name), AttributeError,
            name, lambda: setattr(thing, name, value))

# anything for anything: results, TypeError or ValueError
p30 = p[:30]
mesh30, tri30 = tess89.delaunay(p30), tess89.Delaunay(p30)
things = [
    None, 3, 2.5, "x", b"x", [], (), {}, [1, 2, 3], (1, 2, 3), [[1, 2], [3]],
    range(3), 2**70, [2**70] * 3, True, np.nan, np.inf, slice(3), len,
    np.zeros((), [("a", float)]), np.array("2020-01-01", "M8[D]"), p30,
    p30.astype(">f8"), p30.astype("f2"), np.asfortranarray(p30), p30[::-1],
    p30[:, ::-1], p30.T, p30[None], p30[:0], p30[:1], p30[:4], p30[:, :2],
    p30[:, 0], p30 * np.nan, p30 * 1e308, (p30 - .5) * 3e308, p30 * 1e-300,
    p30 * 5e-324, p30 * (1, 1, 0), p30 * (1, 0, 0), np.round(2 * p30),
    np.tile(p30[:5], (6, 1)), p30 + 0j, p30.astype(object), p30.astype(str),
    np.ma.masked_less(p30, .5), np.matrix(p30), p30.tolist(), tuple(p30),
    tuple(p30.T), np.where(p30 > .5, np.nan, p30), np.full(30, np.nan),
    np.where(p30[:, 0] > .9, np.inf, 1), np.arange(30) > 4,
    np.zeros((30, 0)), np.zeros((30, 2, 2)), mesh30, tri30, mesh30.tet,
    mesh30.adj, mesh30.same, tess89.Interpolator(tri30, p30), tess89.Mesh,
    *_values._METHODS]
calls = [getattr(tess89, name) for name in tess89.__all__] + [
    tess89.Mesh._make, tri30.find_simplex]
wrong, results = [], 0


def anything(call, arguments):
    global results
    try:
        made = call(*arguments)
    except (TypeError, ValueError):
        return None
    except Exception as e:
        wrong.append((call, arguments, e))
        return None
    results += 1
    return made


def some_of(x, least, most):
    return [x[i] for i in random.integers(0, len(x),
                                          random.integers(least, most))]


with np.errstate(all="ignore"), warnings.catch_warnings():
    warnings.simplefilter("ignore")
    for _ in range(6000):
        call, = some_of(calls, 1, 2)
        arguments = some_of(things, 1, 6)
        # (what is right is rare otherwise)
        if random.random() < .7:
            arguments[0] = some_of([mesh30, tri30, p30, 1e308 * p30,
                                    np.tile(p30[:5], (6, 1))], 1, 2)[0]
        if len(arguments) > 2 and random.random() < .7:
            arguments[2] = some_of(_values._METHODS, 1, 2)[0]
        made = anything(call, arguments)
        if isinstance(made, tess89.Interpolator):
            for _ in range(4):
                anything(made, some_of(things, 1, 4))
        if isinstance(made, tess89.Delaunay):
            for name in dir(made):
                getattr(made, name)
            anything(tess89.volumes, [made])
    for _ in range(300):
        anything(lambda *x: mesh30._replace(**dict(zip(mesh30._fields, x))),
                 some_of(things, 1, 5))
test("anything for anything: results or ValueError, TypeError%s"
     % (wrong[:1] or ""), wrong == [] and results > 300)

# ---- Ctrl-C, other threads ----


class watched:
    """A call of the library's, with what happens before it."""

    def __init__(self, name, before):
        self.name, self.before = name, before

    def __enter__(self):
        self.call, self.calls = getattr(_mesh._lib, self.name), 0
        setattr(_mesh._lib, self.name, self)
        return self

    def __call__(self, *arguments):
        self.calls += 1
        self.before(self.calls)
        return self.call(*arguments)

    def __exit__(self, *_):
        setattr(_mesh._lib, self.name, self.call)


def interrupt(calls):
    if calls == 2:
        os.kill(os.getpid(), signal.SIGINT)


def interrupted(call):
    try:
        call()
    except KeyboardInterrupt:
        return True
    return False


many = random.random((9 * _mesh._BLOCK[2], 3))
with watched("tr_many", interrupt) as calls:
    test("Ctrl-C: ends between blocks of places", interrupted(
        lambda: tess89.Interpolator(mesh, values, "natural")(many)) and
        calls.calls == 2)
for method, block in zip(_values._METHODS, _mesh._BLOCK):
    with watched("tr_many", lambda calls: None) as calls:
        got = tess89.interpolate(mesh, values, many, method)
    want = [tess89.interpolate(mesh, values, many[i:i + 999], method)
            for i in (0, len(many) - 999, block - 500)]
    # (one that wants more room is called again)
    test("blocks: %s, the values of smaller ones" % method, calls.calls >=
         -(-len(many) * 10 // (8 * block)) and near(got[:999], want[0]) and
         near(got[-999:], want[1]) and near(got[block - 500:block + 499],
                                            want[2][:len(got) - block + 500]))
leave, left = threading.Event(), threading.Event()


def stays(calls):
    os.kill(os.getpid(), signal.SIGINT)
    leave.wait(100)
    left.set()


for name, call in (("tess_resume", lambda: tess89.Delaunay(p)),
                   ("tr_slopes", lambda: tess89.Interpolator(mesh, values,
                                                             "smooth"))):
    leave.clear()
    left.clear()
    with watched(name, stays):
        heard = interrupted(call) and not left.is_set()
        leave.set()
        test("Ctrl-C: is heard while %s runs" % name, heard and left.wait(100))

size = threading.stack_size(1 << 16)
test("threads: their small stacks are not the library's",
     len(tess89.delaunay(p).tet) == len(mesh.tet) and
     threading.stack_size(size) == 1 << 16)
start = threading.Thread.start


def none(*_):
    raise RuntimeError("can't start new thread")


threading.Thread.start = none
with watched("tess_resume", lambda calls: None) as calls:
    test("threads: none can be had", tess89.delaunay(p) == mesh and
         calls.calls == 1)
threading.Thread.start = start

# no thread gives way to others but where it waits, or the library works
interval = sys.getswitchinterval()
sys.setswitchinterval(1000)
try:
    for name, call in (("tess_resume", lambda: tess89.delaunay(p)),
                       ("tr_many", lambda: tess89.interpolate(mesh, values,
                                                              q))):
        steps, counted = [0], []
        real = getattr(_mesh._lib, name)

        def noted(*arguments):
            before = steps[0]
            code = real(*arguments)
            counted.append(steps[0] - before)
            return code

        setattr(_mesh._lib, name, noted)
        worker = threading.Thread(target=call)
        worker.start()
        while worker.is_alive():
            steps[0] += 1
            time.sleep(0)
        setattr(_mesh._lib, name, real)
        test("other threads run while %s does" % name, max(counted) > 0)
finally:
    sys.setswitchinterval(interval)

# ---- hull, volumes ----

fac = tess89.hull(mesh)
convex = ConvexHull(p)
test("hull: SciPy's triangles", rows(fac) == rows(convex.simplices))
normal = np.cross(p[fac[:, 1]] - p[fac[:, 0]], p[fac[:, 2]] - p[fac[:, 0]])
test("hull: turned outwards", abs(np.sum(normal * p[fac[:, 0]]) / 6 -
                                  convex.volume) < 1e-12)
want = cells(few)
for scale in 1, 1e-95, 1e95:
    got = tess89.volumes(tess89.delaunay(np.vstack((few, few[:5])) * scale))
    test("volumes: SciPy's, of points in units of %g" % scale, bool(
        np.all(np.isinf(got[:300]) == np.isinf(want)) and np.all(got[300:] == 0)
        and np.allclose((got / scale / scale / scale)[:300], want, 1e-9, 0)))

# ---- what is refused, and how ----

mask = np.ma.masked_greater(p, 0.9)
for name, kind, words, x in (
        ("masked", TypeError, "masked", mask),
        ("complex", TypeError, "complex", p + 0j),
        ("text", TypeError, "real numbers", p.astype(str)),
        ("objects", TypeError, "real numbers", p.astype(object)),
        ("of two coordinates", ValueError, "(3000, 2)", p[:, :2])):
    refuses("points, " + name, kind, words, lambda: tess89.delaunay(x))
    refuses("places, " + name, kind, words, lambda: tess89.locate(mesh, x))
    refuses("places of an Interpolator, " + name, kind, words,
            lambda: tess89.Interpolator(mesh, values)(x))
    if kind is TypeError:
        refuses("values, " + name, kind, "numbers" if name == "text" else words,
                lambda: tess89.interpolate(mesh, x, q))
        refuses("x, y, z, " + name, kind, words,
                lambda: tess89.Interpolator(mesh, values)(x[:, 0], 0, 0))
refuses("points in three dimensions", ValueError, "(2, 2, 3)",
        lambda: tess89.delaunay(np.zeros((2, 2, 3))))
refuses("values that are not the points'", ValueError, "(2999, 2)",
        lambda: tess89.interpolate(mesh, values[1:], q))
refuses("no values", ValueError, "(3000, 0)",
        lambda: tess89.interpolate(mesh, values[:, :0], q))
refuses("another method", ValueError, "natural",
        lambda: tess89.Interpolator(mesh, values, "cubic"))
refuses("another word for outside", ValueError, "nearest",
        lambda: tess89.Interpolator(mesh, values, fill_value="far"))
refuses("another mesh", TypeError, "delaunay", lambda: tess89.hull(theirs))
refuses("another mesh's neighbours", ValueError, "delaunay",
        lambda: tess89.Mesh(p[:9], mesh.tet, mesh.adj, mesh.same[:9]))
for bad in np.nan, np.inf:
    some = p.copy()
    some[[1234, 2345], 1] = bad
    refuses("points, not finite: %s" % bad, ValueError,
            "points, row 1234: column 1: ", lambda: tess89.delaunay(some))
refuses("points in a plane", ValueError, "one plane",
        lambda: tess89.delaunay(p * (1, 1, 0)))
refuses("points on a line", ValueError, "one line",
        lambda: tess89.delaunay(p * (1, 0, 0)))
refuses("one point, twice", ValueError, "at most one",
        lambda: tess89.delaunay(np.ones((2, 3))))
refuses("no points", ValueError, "no points",
        lambda: tess89.delaunay(np.empty((0, 3))))


def said_of(call):
    """The message, without `tess89: '; numbers count from 1."""
    try:
        call()
    except ValueError as e:
        return re.sub(r"\b\d+", lambda m: str(int(m[0]) + 1),
                      str(e).replace("tess89: ", "", 1))


# the same faults in the same words as by build/tess
if os.access(program, os.X_OK):
    with tempfile.TemporaryDirectory() as top:
        def theirs_of(x, *options):
            name = os.path.join(top, "points.npy")
            np.save(name, x)
            done = subprocess.run([program, *options, "-mesh", os.path.join(
                top, "o.vtk"), name], stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT, universal_newlines=True)
            return done.stdout.replace(name, "points").replace(
                "tess: ", "").replace(" (-skip drops such lines)", "").replace(
                    "points: no points", "no points").split("\n")

        few = p[:20]
        holed = [np.where(np.arange(60).reshape(20, 3) == i, bad, few)
                 for i, bad in ((0, np.nan), (31, np.nan), (59, -np.inf),
                                (22, np.inf))]
        for name, x in [("in one plane", few * (1, 0, 1)),
                        ("on one line", few[:, :1] * (3, 0, 1)),
                        ("one, often", few[:1].repeat(9, 0)),
                        ("one", few[:1]), ("none", few[:0])] + [
                            ("not finite", x) for x in holed]:
            mine, all_theirs = said_of(lambda: tess89.delaunay(x)), theirs_of(x)
            test("messages: points, %s: as build/tess" % name,
                 mine in all_theirs)
        for word in "foo", "", "Linear":
            mine = said_of(lambda: tess89.Interpolator(few, few[:, 0], word))
            test("messages: method %r: as build/tess" % word, mine.replace(
                "method %r" % word, "-method " + word) in theirs_of(
                    np.column_stack((few, few)), "-method", word, "-query",
                    os.path.join(top, "points.npy"), "-values",
                    os.path.join(top, "v.csv")))

text = pydoc.render_doc(tess89)
test("help: all there is", all(name in text for name in tess89.__all__) and
     "scipy" in text)
test("help: what each is", all(
    getattr(tess89, name).__doc__ for name in tess89.__all__))
test("help: parameters, results, errors", all(
    part in getattr(tess89, name).__doc__
    for name in ("Delaunay", "Interpolator", "delaunay", "locate")
    for part in ("Parameters", "Raises", "array_like of float, shape")))
# (as they are typed: without the modules' own names)
for module in tess89, _mesh, _values:
    failed, tried = doctest.testmod(module, globs={})
    test("help: examples, " + module.__name__, failed == 0 and tried > 0)
test("help: an example of all there is", all(
    re.search(r"^ *(>>>|[.]{3}) .*\btess89\.%s\b" % ("delaunay" if name == "Mesh" else
                                           name),
              getattr(tess89, name).__doc__, re.M) for name in tess89.__all__))
held = np.column_stack((values, values))
held[:7, 3] = np.nan
with warnings.catch_warnings():
    warnings.simplefilter("ignore")
    for made, parts in (
            (mesh, ("3000 points", "%d tetrahedra" % len(mesh.tet))),
            (tess89.Delaunay(p), ("3000 points",
                                  "%d tetrahedra" % len(mesh.tet))),
            (tess89.Interpolator(p, values, "smooth"),
             ("3000 points", "(3000, 2)", "'smooth'", "outside nan")),
            (tess89.LinearNDInterpolator(p, values[:, 0], -1.5),
             ("3000 points", "(3000,)", "'linear'", "outside -1.5")),
            (tess89.Interpolator(p, held, "natural", None),
             ("(3000, 4)", "7 of them missing", "outside nearest")),
            (tess89.Interpolator(mesh, rock, "nearest", "none"),
             ("(3000, 2)", "5 classes", "'nearest'", "outside 'none'"))):
        kind = type(made).__name__
        test("repr: %s, in a line" % kind, repr(made).startswith(
            "<tess89.%s: " % kind) and all(x in repr(made) for x in parts) and
            len(repr(made)) < 110 and "\n" not in repr(made))
public = [getattr(tess89, name) for name in tess89.__all__]
public = [x for x in public if not isinstance(x, type)] + [
    f for x in public if isinstance(x, type)
    for name, f in vars(x).items() if callable(f) and
    (name in ("__init__", "__call__") or not name.startswith("_"))]
test("type hints: all that is public", len(public) > 9 and all(
    len(f.__annotations__) == f.__code__.co_argcount +
    (f.__code__.co_flags & 4 != 0) + (f.__code__.co_argcount == 0 or
                                      f.__code__.co_varnames[0] != "self")
    for f in public) and os.path.exists(
        os.path.join(os.path.dirname(tess89.__file__), "py.typed")))
if os.path.exists("tess.h"):
    with open("tess.h") as file:
        edition = int(re.search(r"TESS_VERSION (\d+)L", file.read()).group(1))
    # (before 5.0 the module was tess)
    test("version: that of tess.h", edition < 50000 or tess89.__version__ ==
         "%d.%d" % (edition // 10000, edition // 100 % 100))

with tempfile.TemporaryDirectory() as top:
    folder = os.path.join(top, "test", "bindings", "python", "tess89")
    build = os.path.join(top, "build")
    os.makedirs(folder)
    os.mkdir(build)
    source = os.path.dirname(tess89.__file__)
    for name in os.listdir(source):
        if name.endswith(".py"):
            shutil.copy(os.path.join(source, name), folder)

    def imported(name, words):
        done = subprocess.run([sys.executable, "-c", "import tess89"],
                              cwd=os.path.dirname(folder), env=dict(
                                  os.environ, PYTHONPATH=""),
                              stderr=subprocess.PIPE, universal_newlines=True)
        last = (done.stderr.strip().split("\n") or [""])[-1]
        test("import: " + name, last == "" if words == "" else
             last.startswith("ImportError: tess89: ") and words in last and
             "make python" in last)

    imported("no library", "is there")
    library = os.path.join(build, "libtess.so")
    shutil.copy(_mesh._lib._name, library)
    imported("a library in build of no checkout", "is there")
    with open(os.path.join(top, "tess.h"), "w"):
        pass
    imported("the library in build", "")
    shutil.move(library, os.path.join(folder, "_library.so"))
    imported("the library beside it", "")
    with open(os.path.join(folder, "_library.so"), "w") as file:
        file.write("no library")
    imported("a file that is no library", "_library.so")
    other = next(m.__file__ for m in sys.modules.values() if
                 str(getattr(m, "__file__", "")).endswith((".so", ".pyd")))
    shutil.copy(other, os.path.join(folder, "_library.so"))
    imported("another library", "_library.so")

# ---- the module's name of before ----

here = os.path.dirname(os.path.abspath(__file__))
if os.path.exists(os.path.join(here, "tess.py")):
    sys.path.append(here)
    tess, said = warned(lambda: __import__("tess"))
    test("tess: says that it is tess89 now", len(said) == 1 and
         "import tess89" in said[0][0] and tess.Mesh is tess89.Mesh)
    q = 1.4 * random.random((40, 3)) - 0.2
    f = tess.Interpolator(p, values, "linear", outside=-5)
    want = tess89.Interpolator(p, values, fill_value=-5)
    test("tess: Interpolator, interpolate, as before", all(
        np.array_equal(a, b) for a, b in (
            (f(q), want(q)), (f(q[0]), want(q[0])[0]),
            (f(*q.T), want(*q.T)), (f(*q[0]), want(*q[0])),
            (f(tuple(map(tuple, q[:3]))), want(q[:3])),
            (tess.interpolate(tess.delaunay(p), values, q, outside=-5),
             want(q)))) and f.mesh.tet.shape[1] == 4)
    test("tess: locate, hull, volumes", all(
        getattr(tess, name) is getattr(tess89, name)
        for name in ("delaunay", "locate", "hull", "volumes")))

# ---- what Octave has computed ----

if len(sys.argv) > 1:
    theirs = loadmat(sys.argv[1])
    p, values, q = theirs["p"], theirs["v"], theirs["q"]
    mesh = Delaunay(p)
    test("tessn: SciPy's tetrahedra",
         rows(theirs["T"] - 1) == rows(mesh.simplices))
    of_octave = tess89.Delaunay(p)
    test("tessn: tess89's arrays, counted from 1", np.array_equal(
        theirs["T"] - 1, of_octave.simplices) and np.array_equal(
            theirs["N"] - 1, of_octave.neighbors))
    outside = mesh.find_simplex(q) < 0
    nearest = values[cKDTree(p).query(q)[1]]
    nearest[outside] = np.nan
    for method, want, most in (
            ("linear", LinearNDInterpolator(mesh, values)(q), 1e-12),
            ("smooth", np.column_stack([smooth(mesh, v, q) for v in values.T]),
             1e-9), ("nearest", nearest, 0),
            ("natural", np.array([natural(p, values, x) for x in q[:9][:MANY]]),
             1e-9)):
        test("tessinterp: %s, by SciPy" % method,
             near(theirs[method][:len(want)], want, most))

print("1..%d" % sum(counts))
sys.exit(counts[1] > 0)
