# try_tess.py - tests of tess.py, beside SciPy.
#
#   make python
#   python3 test/examples/try_tess.py [FILE]
#
# FILE: what try_tessn.m has left, which is tested, too.
# Ends with `tess_py: N passed, M failed'.
import os
import pickle
import pydoc
import shutil
import subprocess
import sys
import tempfile
import threading

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.io import loadmat
from scipy.spatial import ConvexHull, Delaunay, Voronoi, cKDTree

import tess

counts = [0, 0]


def test(name, good):
    counts[not good] += 1
    print("ok      " + name if good else "FAILED  " + name, flush=True)


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
    """What slopes.c and bent say that they do, with SciPy's mesh."""
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
mesh = tess.delaunay(p)
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
     len(tess.delaunay(p.astype(np.float32).tolist()).tet) > 15000)
twice = tess.delaunay(np.vstack((p[:100], p[:100])))
test("delaunay: duplicates",
     bool(np.all(twice.same == np.arange(200) % 100)) and
     rows(twice.tet) == rows(Delaunay(p[:100]).simplices))
s = np.linspace(0, 1, 300)
o = 0 * s
lines = tess.delaunay(np.vstack((np.column_stack((s, o, o)),
                                 np.column_stack((o, s, o + 1)))))
test("delaunay: two lines, whose tetrahedra are more than 8 n",
     len(lines.tet) == 299 * 299)
mine = p.copy()
alone = tess.delaunay(mine)
mine[:] = 0
test("delaunay: the mesh keeps its points",
     np.array_equal(alone.points, p) and mine.flags.writeable)
refuses("to write a mesh", ValueError, "read-only",
        lambda: mesh.tet.__setitem__(0, 0))
again = pickle.loads(pickle.dumps(mesh))
test("delaunay: a mesh that was pickled", type(again) is tess.Mesh and
     all(np.array_equal(a, b) for a, b in zip(again, mesh)))
if os.path.exists("/proc/self/status"):
    done = subprocess.run([sys.executable, "-c", """
import numpy, tess
def peak(what):
    return next(int(line.split()[1]) for line in open("/proc/self/status")
                if line.startswith(what))
p = numpy.random.default_rng(1).random((400000, 3))
before = peak("VmRSS")
tess.delaunay(p)
print((peak("VmHWM") - before) * 1024 / len(p))"""], stdout=subprocess.PIPE,
                          cwd=os.path.dirname(os.path.abspath(__file__)))
    test("delaunay: at most 320 bytes a point", float(done.stdout) < 320)

# ---- locate ----

q = 1.4 * random.random((40, 50, 3)) - 0.2
found, w = tess.locate(mesh, q)
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
t, w = tess.locate(mesh, [9, 9, 9])
test("locate: one place", t.shape == () and t == -1 and w.shape == (4,))
for name, bad in ("a NaN", np.nan), ("an infinity", -np.inf):
    some = q[:5, 0].copy()
    some[2, 1] = bad
    t, w = tess.locate(mesh, some)
    test("locate: %s is nowhere" % name, t[2] == -1 and np.isnan(w[2]).all() and
         np.array_equal(np.delete(t, 2), np.delete(found[:5, 0], 2)))
none = np.empty((7, 0, 3))
test("locate: no places", tess.locate(mesh, none)[0].shape == (7, 0))

# ---- values ----

values = np.column_stack((np.sin(9 * p[:, 0]), p[:, 1] * p[:, 2]))
got = tess.interpolate(mesh, values, q)
want = LinearNDInterpolator(p, values)(q)
test("interpolate: SciPy's values, NaN at the same places",
     got.shape == (40, 50, 2) and near(got, want))
one = tess.interpolate(mesh, values[:, 0], q)
test("interpolate: one value a point", one.shape == (40, 50) and
     np.array_equal(one, got[..., 0], equal_nan=True))
deep = np.stack((values, 2 * values, -values), 2)
test("interpolate: an array a point", near(
    tess.interpolate(mesh, deep, q), LinearNDInterpolator(p, deep)(q)))
test("interpolate: outside", np.array_equal(
    tess.interpolate(mesh, values, q, outside=-5.0)[~inside],
    np.full((np.count_nonzero(~inside), 2), -5.0)))
corners = np.array([[i, j, l] for i in (0, 1) for j in (0, 1) for l in (0, 1)])
cube = np.vstack((corners, p))
for nearest in "nearest", None:
    test("interpolate: outside as on the hull, %s" % nearest, near(
        tess.interpolate(tess.delaunay(cube), cube @ (1, 2, 3), q,
                         outside=nearest), np.clip(q, 0, 1) @ (1, 2, 3)))
test("interpolate: an array that is not contiguous", np.array_equal(
    tess.interpolate(mesh, values[:, ::-1], q), got[..., ::-1],
    equal_nan=True))
# many places are equal, or in one plane, line, spot; 0 and -0
for name, many in (("equal ones", q[0, random.integers(0, 50, 999)]),
                   ("a plane", q * (1, 0, 1) + (0, .5, 0)),
                   ("a line", q * (0, 1, 0) + (.3, 0, .5)),
                   ("one spot", 0 * q + .5), ("a single one", q[:1, 0]),
                   ("zeros", random.choice([-0.0, 0.0], (99, 3)))):
    test("interpolate: " + name, near(
        tess.interpolate(mesh, values, many),
        LinearNDInterpolator(p, values)(many)))
for method in tess._METHODS:
    some = q[:9, 0].copy()
    some[3, 0] = np.nan
    f = tess.interpolate(mesh, values, some, method, outside=7)
    test("interpolate: %s, a NaN among the places" % method,
         np.argwhere(np.isnan(f)).tolist() == [[3, 0], [3, 1]])

f = tess.Interpolator(p, values)
theirs_f = LinearNDInterpolator(p, values)
x, y, z = q[..., :1, 0], q[:1, ..., 1], 0.5
test("Interpolator: as SciPy's, of points", near(f(q), theirs_f(q)))
test("Interpolator: of three arrays", near(f(x, y, z), theirs_f(x, y, z)))
test("Interpolator: one place", f([.5, .5, .5]).shape == (2,) and
     tess.Interpolator(mesh, values[:, 0])(.5, .5, .5).shape == ())

flat = q.reshape(-1, 3)
f = tess.interpolate(mesh, values, flat, "smooth")
want = np.column_stack([smooth(theirs, v, flat) for v in values.T])
test("smooth: by NumPy", near(f, want, 1e-9))
f = tess.interpolate(mesh, values, flat, "nearest", outside="nearest")
test("nearest: SciPy's cKDTree", np.array_equal(
    f, values[cKDTree(p).query(flat)[1]]))
few, some = p[:300], .35 + .3 * random.random((12, 3))
f = tess.Interpolator(few, values[:300], "natural")(some)
test("natural: by SciPy's Voronoi cells", near(
    f, np.array([natural(few, values[:300], x) for x in some]), 1e-9))
ball = random.normal(size=(400, 3))
ball /= np.sqrt(np.sum(ball**2, 1))[:, None]
ball = np.vstack((ball, 1.01 * ball[:9]))
f = tess.Interpolator(ball, ball @ (1, 2, 3), "natural")(.3 * some)
test("natural: hundreds of neighbours", near(f, .3 * some @ (1, 2, 3)))

# a calculation that other threads disturb would have other values
f = [tess.Interpolator(mesh, values, m) for m in tess._METHODS]
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

# ---- hull, volumes ----

fac = tess.hull(mesh)
convex = ConvexHull(p)
test("hull: SciPy's triangles", rows(fac) == rows(convex.simplices))
normal = np.cross(p[fac[:, 1]] - p[fac[:, 0]], p[fac[:, 2]] - p[fac[:, 0]])
test("hull: turned outwards", abs(np.sum(normal * p[fac[:, 0]]) / 6 -
                                  convex.volume) < 1e-12)
want = cells(few)
for scale in 1, 1e-95, 1e95:
    got = tess.volumes(tess.delaunay(np.vstack((few, few[:5])) * scale))
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
    refuses("points, " + name, kind, words, lambda: tess.delaunay(x))
    refuses("places, " + name, kind, words, lambda: tess.locate(mesh, x))
    refuses("places of an Interpolator, " + name, kind, words,
            lambda: tess.Interpolator(mesh, values)(x))
    if kind is TypeError:
        refuses("values, " + name, kind, words,
                lambda: tess.interpolate(mesh, x, q))
        refuses("x, y, z, " + name, kind, words,
                lambda: tess.Interpolator(mesh, values)(x[:, 0], 0, 0))
refuses("points in three dimensions", ValueError, "(2, 2, 3)",
        lambda: tess.delaunay(np.zeros((2, 2, 3))))
refuses("values that are not the points'", ValueError, "(2999, 2)",
        lambda: tess.interpolate(mesh, values[1:], q))
refuses("no values", ValueError, "(3000, 0)",
        lambda: tess.interpolate(mesh, values[:, :0], q))
refuses("another method", ValueError, "natural",
        lambda: tess.Interpolator(mesh, values, "cubic"))
refuses("another word for outside", ValueError, "nearest",
        lambda: tess.Interpolator(mesh, values, outside="far"))
refuses("another mesh", TypeError, "delaunay", lambda: tess.hull(theirs))
refuses("another mesh's neighbours", ValueError, "delaunay",
        lambda: tess.Mesh(p[:9], mesh.tet, mesh.adj, mesh.same[:9]))
for bad in np.nan, np.inf:
    some = p.copy()
    some[[1234, 2345], 1] = bad
    refuses("points, not finite: %s" % bad, ValueError,
            "point 1234 is not finite", lambda: tess.delaunay(some))
refuses("points in a plane", ValueError, "one plane",
        lambda: tess.delaunay(p * (1, 1, 0)))
refuses("points on a line", ValueError, "one line",
        lambda: tess.delaunay(p * (1, 0, 0)))
refuses("no points", ValueError, "at most one",
        lambda: tess.delaunay(np.empty((0, 3))))

text = pydoc.render_doc(tess)
test("help: all there is", all(name in text for name in tess.__all__) and
     "make python" in text)
test("help: what each is", all(
    getattr(tess, name).__doc__ for name in tess.__all__))

with tempfile.TemporaryDirectory() as top:
    folder = os.path.join(top, "test", "examples")
    os.makedirs(folder)
    os.mkdir(os.path.join(top, "build"))
    shutil.copy(tess.__file__, folder)

    def imported(name, words):
        done = subprocess.run([sys.executable, "-c", "import tess"], cwd=folder,
                              stderr=subprocess.PIPE, universal_newlines=True)
        last = (done.stderr.strip().split("\n") or [""])[-1]
        test("import: " + name, last == "" if words == "" else
             last.startswith("ImportError: tess: ") and words in last and
             "make python" in last)

    imported("no library", "is there")
    library = os.path.join(top, "build", "libtess.so")
    shutil.copy(tess._lib._name, library)
    imported("the library in build", "")
    shutil.move(library, folder)
    imported("the library beside it", "")
    with open(os.path.join(folder, "libtess.so"), "w") as file:
        file.write("no library")
    imported("a file that is no library", "libtess.so")
    other = next(m.__file__ for m in sys.modules.values() if
                 str(getattr(m, "__file__", "")).endswith((".so", ".pyd")))
    shutil.copy(other, os.path.join(folder, "libtess.so"))
    imported("another library", "libtess.so")

# ---- what Octave has computed ----

if len(sys.argv) > 1:
    theirs = loadmat(sys.argv[1])
    p, values, q = theirs["p"], theirs["v"], theirs["q"]
    mesh = Delaunay(p)
    test("tessn: SciPy's tetrahedra",
         rows(theirs["T"] - 1) == rows(mesh.simplices))
    outside = mesh.find_simplex(q) < 0
    nearest = values[cKDTree(p).query(q)[1]]
    nearest[outside] = np.nan
    for method, want, most in (
            ("linear", LinearNDInterpolator(mesh, values)(q), 1e-12),
            ("smooth", np.column_stack([smooth(mesh, v, q) for v in values.T]),
             1e-9), ("nearest", nearest, 0),
            ("natural", np.array([natural(p, values, x) for x in q[:9]]),
             1e-9)):
        test("tessinterp: %s, by SciPy" % method,
             near(theirs[method][:len(want)], want, most))

print("tess_py: %d passed, %d failed" % tuple(counts))
sys.exit(counts[1] > 0)
