# try_tess.py - tests of tess.py, beside SciPy.
#
#   cc -O3 -shared -fPIC -o libtess.so tess.c hhpred.c -lm
#   python3 test/examples/try_tess.py
#
# Ends with `tess_py: N passed, M failed'.
import sys

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import ConvexHull, Delaunay

import tess

counts = [0, 0]


def test(name, good):
    counts[not good] += 1
    print("ok      " + name if good else "FAILED  " + name)


def refuses(name, words, call):
    try:
        call()
    except ValueError as e:
        test("refuses " + name, words in str(e))
    else:
        test("refuses " + name, False)


def rows(x):
    return set(map(tuple, np.sort(x, axis=1).tolist()))


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

q = 1.4 * random.random((40, 50, 3)) - 0.2
found = tess.locate(mesh, q)
want = theirs.find_simplex(q)
test("locate: -1 where SciPy has it, shape", found.shape == (40, 50) and
     bool(np.all((found < 0) == (want < 0))) and 0 < (found < 0).sum() < 2000)
inside = found >= 0
test("locate: SciPy's tetrahedra",
     bool(np.all(np.sort(mesh.tet[found[inside]]) ==
                 np.sort(theirs.simplices[want[inside]]))))
test("locate: one place", tess.locate(mesh, [9, 9, 9]) == -1)

values = np.column_stack((np.sin(9 * p[:, 0]), p[:, 1] * p[:, 2]))
got = tess.interpolate(mesh, values, q)
want = LinearNDInterpolator(p, values)(q)
test("interpolate: SciPy's values, NaN at the same places",
     got.shape == (40, 50, 2) and np.allclose(got, want, 0, 1e-12,
                                              equal_nan=True))
one = tess.interpolate(mesh, values[:, 0], q)
test("interpolate: one value a point", one.shape == (40, 50) and
     np.array_equal(one, got[..., 0], equal_nan=True))
test("interpolate: outside", np.array_equal(
    tess.interpolate(mesh, values, q, outside=-5.0)[~inside],
    np.full((np.count_nonzero(~inside), 2), -5.0)))
corners = np.array([[i, j, l] for i in (0, 1) for j in (0, 1) for l in (0, 1)])
cube = np.vstack((corners, p))
test("interpolate: outside as on the hull", np.allclose(
    tess.interpolate(tess.delaunay(cube), cube @ (1, 2, 3), q, outside=None),
    np.clip(q, 0, 1) @ (1, 2, 3), 0, 1e-12))
test("interpolate: an array that is not contiguous", np.array_equal(
    tess.interpolate(mesh, values[:, ::-1], q), got[..., ::-1],
    equal_nan=True))

fac = tess.hull(mesh)
convex = ConvexHull(p)
test("hull: SciPy's triangles", rows(fac) == rows(convex.simplices))
normal = np.cross(p[fac[:, 1]] - p[fac[:, 0]], p[fac[:, 2]] - p[fac[:, 0]])
test("hull: turned outwards", abs(np.sum(normal * p[fac[:, 0]]) / 6 -
                                  convex.volume) < 1e-12)

refuses("points in a plane", "one plane",
        lambda: tess.delaunay(p * (1, 1, 0)))
refuses("a NaN", "not finite", lambda: tess.delaunay([[0, 0, np.nan]] * 9))
refuses("a NaN among places", "not finite",
        lambda: tess.locate(mesh, [0, 0, np.nan]))
refuses("points of a plane", "three coordinates",
        lambda: tess.delaunay(p[:, :2]))
refuses("values that are not the points'", "for each point",
        lambda: tess.interpolate(mesh, values[1:], q))

print("tess_py: %d passed, %d failed" % tuple(counts))
sys.exit(counts[1] > 0)
