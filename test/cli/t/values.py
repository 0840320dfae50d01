# values.py - what build/tess interpolates, beside what NumPy and SciPy compute
# independently of it; test_values.py runs it.
#
#   python3 values.py TESS [LIBRARY]
#
# LIBRARY: of tess.c, hhpred.c and the recipes.
# In the current directory, where it leaves its files.  Prints `ok ...' or
# `FAILED ...' for each test.
import ctypes
import re
import sys

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import ConvexHull, Delaunay, Voronoi, cKDTree

import common
from common import near, test

METHODS = ["linear", "smooth", "natural", "nearest"]
random = np.random.default_rng(7)


def tess(*arguments):
    """The program's standard output."""
    done = common.tess(*arguments)
    tess.said = done.stderr
    return done.stdout


def save(name, p, *columns, names="x,y,z,T,U,V"):
    rows = np.column_stack((p,) + columns)
    np.savetxt(name, rows, fmt="%.17g", delimiter=",", comments="",
               header=",".join(names.split(",")[:rows.shape[1]]))


def linear(x):
    return 7 + 2 * x[..., 0] - 3 * x[..., 1] + 0.5 * x[..., 2]


def bent(x):
    return np.sin(5 * x[..., 0]) * np.cos(4 * x[..., 1]) + x[..., 2] ** 2


def places(low, high, size):
    """A grid's places, by the rule that -h gives, as [z, y, x, axis]."""
    axis = [np.linspace(low[k], high[k], size[k]) if size[k] > 1
            else np.array([(low[k] + high[k]) / 2]) for k in range(3)]
    z, y, x = np.meshgrid(axis[2], axis[1], axis[0], indexing="ij")
    return np.stack((x, y, z), -1)


# ---- places on the hull have values, however they are rounded; others not ----

for name, scale, shift in (("at the origin", 1, 0), ("tiny", 1e-200, 0),
                           ("huge", 1e200, 0), ("far", 100, (5e5, 5e6, -5))):
    turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
    p = np.vstack((random.random((50, 3)), places((0, 0, 0), (1, 1, 1),
                                                  (2, 2, 2)).reshape(-1, 3)))
    p = p @ turn * scale + np.array(shift)
    save("turned.csv", p, p[:, 0] / np.abs(p).max())
    hull = ConvexHull((p - p.mean(0)) / scale)
    a, b, c = (p[hull.simplices[:, k]] for k in range(3))
    on = np.vstack([a + u * (b - a) + v * (c - a) for u, v in
                    random.dirichlet((1, 1, 1), 40)[:, :2]] + [a, (a + b) / 2])
    n = np.vstack([hull.equations[:, :3]] * 42)
    away = on + n * 50 * np.finfo(float).eps * np.abs(p).max()
    bad = []
    for method in METHODS:
        if name in ("tiny", "huge") and method != "linear":
            continue
        tess("-q", "-method", method, "-query", save("on.csv", on) or "on.csv",
             "-values", "on.npy", "turned.csv")
        got = np.load("on.npy").ravel()
        tess("-q", "-method", method, "-query", save("away.csv", away) or
             "away.csv", "-values", "away.npy", "turned.csv")
        more = np.load("away.npy").ravel()
        if np.isnan(got).any() or not np.isnan(more).all() or \
                "have no value" not in tess.said:
            bad.append((method, np.isnan(got).sum(), np.isnan(more).sum(),
                        len(got)))
        if method == "linear" and \
                not near(got, on[:, 0] / np.abs(p).max(), 1e-9):
            bad.append(method)
    if bad:
        print("        ", bad)
    test("places on the hull have values: " + name, not bad)

# ---- a grid on the points' box: shape, order, values ----

p = random.random((2000, 3))
T, U = bent(p), linear(p)
save("points.csv", p, T, U)
tess("-q", "-grid", "23,11,17", "-values", "g.npy", "points.csv")
got = np.load("g.npy")
q = places(p.min(0), p.max(0), (23, 11, 17))
want = LinearNDInterpolator(p, np.column_stack((T, U)))(q)
test("-grid: shape and type", got.shape == (17, 11, 23, 2) and
     got.dtype == np.float64)
test("linear: LinearNDInterpolator's values, NaN at the same places",
     near(got, want, 1e-12) and 0 < np.isnan(got).sum() < got.size / 2)
raw = open("g.npy", "rb").read()
test(".npy: version 1.0, the numbers begin at a multiple of 64",
     raw[:8] == b"\x93NUMPY\x01\x00" and
     (10 + raw[8] + 256 * raw[9]) % 64 == 0 and
     len(raw) == 10 + raw[8] + 256 * raw[9] + 8 * got.size)

# the other forms of the same values
tess("-q", "-grid", "23,11,17", "-values", "g.csv", "points.csv")
rows = np.genfromtxt("g.csv", delimiter=",", skip_header=1)
test(".csv: the names", open("g.csv").readline() == "x,y,z,T,U\n")
test(".csv: the places, x fastest", near(rows[:, :3], q.reshape(-1, 3), 1e-15))
test(".csv: the values of .npy", near(rows[:, 3:], got.reshape(-1, 2), 0.0))
test(".csv: no NaN but `nan'", "-nan" not in open("g.csv").read())
tess("-q", "-grid", "23,11,17", "-digits", 4, "-values", "d.csv", "points.csv")
rounded = np.genfromtxt("d.csv", delimiter=",", skip_header=1)
test("-digits: values, and no coordinates",
     near(rounded[:, :3], rows[:, :3], 0.0) and
     near(rounded[:, 3:], np.array([["%.4g" % a for a in r]
                                    for r in rows[:, 3:]], float), 0.0))


def by_vtk(name):
    """What VTK reads in a file: its places, and the arrays by their names; and,
    of .vtu, the type and size of its cells."""
    xml = name.endswith(".vtu")
    reader = (vtk.vtkXMLUnstructuredGridReader if xml
              else vtk.vtkStructuredPointsReader)()
    reader.SetFileName(name)
    if not xml:
        reader.ReadAllScalarsOn()
    reader.Update()
    m = reader.GetOutput()
    by_vtk.cells = [
        (m.GetCellType(i), np.diff(np.reshape(m.GetCell(i).GetBounds(),
                                              (3, 2)))[:, 0])
        for i in range(m.GetNumberOfCells() if xml else 0)]
    d = m.GetPointData()
    return (np.array([m.GetPoint(i) for i in range(m.GetNumberOfPoints())]),
            {d.GetArrayName(k): vtk_to_numpy(d.GetArray(k))
             for k in range(d.GetNumberOfArrays())})


try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    tess("-q", "-grid", "23,11,17", "-values", "g.vtk", "points.csv")
    x, arrays = by_vtk("g.vtk")
    test(".vtk, read by VTK: the places", near(x, q.reshape(-1, 3), 1e-15))
    test(".vtk, read by VTK: the values of .npy, by column",
         list(arrays) == ["T", "U"] and
         near(arrays["T"], got[..., 0].ravel(), 0.0) and
         near(arrays["U"], got[..., 1].ravel(), 0.0))
    test(".vtk, read by VTK: LinearNDInterpolator's, NaN at the same places",
         near(np.column_stack(list(arrays.values())), want.reshape(-1, 2),
              1e-12))
    tess("-q", "-cols", "x,y,z,U", "-grid", "23,11,17", "-values", "u.vtk",
         "points.csv")
    test(".vtk, read by VTK: one column",
         near(by_vtk("u.vtk")[1]["U"], arrays["U"], 0.0))
    low, high = p.min(0), p.max(0)
    corner = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0],
                       [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
    try:
        import meshio
    except ImportError:
        meshio = None
        print("        skipped: .vtu of a grid, read by meshio: no meshio")
    for kind, size in ((12, (23, 11, 17)), (9, (9, 7, 1)), (9, (9, 1, 7)),
                       (9, (1, 9, 7)), (3, (1, 1, 5)), (3, (5, 1, 1)),
                       (1, (1, 1, 1))):
        tess("-q", "-grid", "%d,%d,%d" % size, "-values", "g.vtu", "-values",
             "v.npy", "points.csv")
        x, arrays = by_vtk("g.vtu")
        step = (high - low) / np.maximum(np.array(size) - 1, 1) * (
            np.array(size) > 1)
        test(".vtu, read by VTK: %s: places, values, cells" % (size,),
             near(x, places(low, high, size).reshape(-1, 3), 1e-15) and
             near(np.column_stack([arrays["T"], arrays["U"]]),
                  np.load("v.npy").reshape(-1, 2), 0.0) and
             len(by_vtk.cells) == np.prod(np.maximum(np.array(size) - 1, 1)) and
             all(k == kind and near(s, step, 1e-15) for k, s in by_vtk.cells))
        if not meshio:
            continue
        # corners in their order: once around, then above; along the axes
        # that the grid has
        m = meshio.read("g.vtu")
        cells = m.cells[0].data
        axes = [k for k in range(3) if size[k] > 1]
        around = np.zeros((2 ** len(axes), 3))
        around[:, axes] = corner[:2 ** len(axes), :len(axes)]
        test(".vtu, read by meshio: %s: cells, values" % (size,),
             len(m.cells) == 1 and len(cells) == len(by_vtk.cells) and
             m.cells[0].type == {12: "hexahedron", 9: "quad", 3: "line",
                                 1: "vertex"}[kind] and
             near(m.points[cells] - m.points[cells][:, :1],
                  np.tile(around * step, (len(cells), 1, 1)), 1e-15) and
             near(m.point_data["U"].ravel(), arrays["U"], 0.0))
    # (so many that they are kept in a file)
    for columns, many in ("x,y,z,T,U", 100), ("x,y,z,U", 140000):
        q = np.random.default_rng(8).random((many, 3)) * 1.2
        save("q.csv", q)
        tess("-q", "-cols", columns, "-query", "q.csv", "-values", "g.vtu",
             "-values", "v.npy", "points.csv")
        x, arrays = by_vtk("g.vtu")
        test(".vtu, read by VTK: places of a file, " + columns, near(x, q, 0.0)
             and list(arrays) == columns[6:].split(",") and
             near(np.column_stack(list(arrays.values())), np.load("v.npy"), 0.0)
             and [k for k, _ in by_vtk.cells] == [1] * many)
    # by `make grid'
    x, arrays = by_vtk(str(common.TOP / "build" / "mirror.vtk"))
    tess("-q", "-alpha", "0.55", "-method", "smooth", "-grid", "200,200,20",
         "-values", "mirror.npy", str(common.TOP / "test/data/mirror.xyz"))
    mirror = np.load("mirror.npy")
    a = np.loadtxt(str(common.TOP / "test/data/mirror.xyz"))[:, :3]
    test("make grid, read by VTK: the places", near(
        x, places(a.min(0), a.max(0), (200, 200, 20)).reshape(-1, 3), 1e-14))
    test("make grid, read by VTK: the values of .npy, NaN where it is hollow",
         near(arrays["temperature in degrees C"], mirror.ravel(), 0.0) and
         100000 < np.isnan(mirror).sum() < 700000)
except ImportError:
    print("        skipped: .vtk, read by VTK: no vtk")

# several files at once: as each alone; one of them standard output
tess("-q", "-grid", "23,11,17", "-values", "s.vtk", "-values", "s.csv",
     "-values", "s.npy", "points.csv")
tess("-q", "-grid", "23,11,17", "-values", "g.vtk", "points.csv")
test("-values F -values F: all are written", all(
    open("s." + end, "rb").read() == open("g." + end, "rb").read()
    for end in ("vtk", "csv", "npy")))
test("-values -: CSV, and nothing else",
     tess("-grid", "23,11,17", "-values", "-", "points.csv") ==
     open("g.csv").read() and "triangles" in tess.said)

# a picture as well, which leaves them as they are
tess("-q", "-alpha", ".2", "-grid", "20,30,1", "-values", "s.svg", "-values",
     "s.csv", "points.csv")
tess("-q", "-alpha", ".2", "-grid", "20,30,1", "-values", "g.csv", "points.csv")
test("-values F.svg -values F.csv: the same as alone",
     open("s.csv").read() == open("g.csv").read() and
     "nan" in open("g.csv").read())

# slices; one place is in the middle, or where it is said; long rows
for name, box, size in (
        ("one place", None, (1, 1, 1)), ("a slice", None, (9, 7, 1)),
        ("a box", (.2, .7, .3, .4, .1, .9), (5, 6, 7)),
        ("a slice of a box", (.2, .7, .3, .4, .6, .6), (5, 6, 1)),
        ("a line in z", (.2, .7, .3, .4, .1, .9), (1, 1, 3000)),
        ("a row of many", (.2, .7, .3, .4, .1, .9), (9000, 2, 1))):
    b = np.array(box or np.column_stack((p.min(0), p.max(0))).ravel())
    argument = ",".join(str(x) for x in size + (box or ()))
    tess("-q", "-grid", argument, "-values", "b.npy", "points.csv")
    w = LinearNDInterpolator(p, U)(places(b[::2], b[1::2], size))
    test("-grid: " + name, near(np.load("b.npy")[..., 1], w, 1e-12) and
         np.load("b.npy").shape[:3] == size[::-1])

# ---- places of a file ----

q = random.random((1500, 3)) * 1.2 - 0.1
order = np.lexsort((np.floor(9 * q[:, 0]), np.floor(9 * q[:, 1])))
flat = q * (1, 1, 0) + (0, 0, .5)
for name, these in (("in no order", q), ("in a plane", flat),
                    ("in a line", q * (1, 0, 0) + .5),
                    ("twice", np.vstack((q, q[::-1]))), ("sorted", q[order])):
    with open("places.csv", "w") as f:
        f.write("id,note,depth,lon,lat\n")
        for i, x in enumerate(these):
            f.write("%d,a,%.17g,%.17g,%.17g\n" % ((i, x[2]) + tuple(x[:2])))
    tess("-q", "-query", "places.csv", "-qcols", "lon,lat,depth", "-values",
         "q.npy", "points.csv")
    want = LinearNDInterpolator(p, np.column_stack((T, U)))(these)
    test("-query: " + name, near(np.load("q.npy"), want, 1e-12))
tess("-q", "-query", "places.csv", "-qcols", "4,5,3", "-values", "q.csv",
     "points.csv")
rows = np.genfromtxt("q.csv", delimiter=",", skip_header=1)
test("-query, .csv: the places as they were read", near(rows[:, :3], q[order],
                                                       0.0))
test("-query, .csv: the values of .npy, behind the file's other columns",
     near(rows[:, 5:], np.load("q.npy"), 0.0) and
     open("q.csv").readline() == "x,y,z,id,note,T,U\n")

# ---- points in a plane ----

f = random.random((2000, 2)) * (360, 180) - (180, 90)
V = np.sin(f[:, 0] / 20) * np.cos(f[:, 1] / 15)
W = 3 + 2 * f[:, 0] - f[:, 1] / 2
b = np.stack((f.min(0), f.max(0)))
save("flat.csv", f, V, W, names="lon,lat,temp,w")
save("three.csv", f, V, names="lon,lat,temp")
save("few.csv", f[:200], V[:200], names="lon,lat,temp")
x = np.stack(np.meshgrid(np.linspace(*b[:, 0], 40), np.linspace(*b[:, 1], 30)),
             -1)
want = LinearNDInterpolator(f, np.column_stack((V, W)))(x)
for name, options in (("-cols lon,lat,temp", ("-cols", "lon,lat,temp")),
                      ("-cols lon,lat", ("-cols", "lon,lat")),
                      ("no -cols", ())):
    n = 1 if "temp" in name else 2
    tess("-q", *options, "-grid", "40,30", "-values", "f.npy", "-values",
         "f.csv", "-values", "f.vtk", "-values", "f.svg", "flat.csv")
    got = np.load("f.npy")
    test("plane, %s: shape (NY,NX,columns), LinearNDInterpolator's" % name,
         got.shape == (30, 40, n) and near(got, want[..., :n], 1e-12))
rows = np.genfromtxt("f.csv", delimiter=",", skip_header=1)
test("plane, .csv: names, places, values",
     open("f.csv").readline() == "lon,lat,temp,w\n" and
     near(rows[:, :2], x.reshape(-1, 2), 1e-13) and
     near(rows[:, 2:], got.reshape(-1, 2), 0.0))
test("plane, .svg: x to the right, y upwards, nothing of z",
     ">lon<" in open("f.svg").read() and ">lat<" in open("f.svg").read() and
     "z = " not in open("f.svg").read())
try:
    at, arrays = by_vtk("f.vtk")
    test("plane, .vtk, read by VTK: the values of .npy",
         near(at[:, :2], x.reshape(-1, 2), 1e-12) and
         near(arrays["w"], got[..., 1].ravel(), 0.0))
except NameError:
    print("        skipped: plane, .vtk: no vtk")
tess("-q", "-cols", "lon,lat,temp", "-grid", "5,7,-20,20,-30,40", "-values",
     "f.npy", "flat.csv")
test("plane: -grid NX,NY,X0,X1,Y0,Y1", near(
    np.load("f.npy")[..., 0], LinearNDInterpolator(f, V)(
        *np.meshgrid(np.linspace(-20, 20, 5), np.linspace(-30, 40, 7))), 1e-12))
tess("-q", "-scale", "1,5", "-grid", "40,30", "-values", "f.npy", "flat.csv")
test("plane: -scale SX,SY", near(np.load("f.npy"), LinearNDInterpolator(
    f * (1, 5), np.column_stack((V, W)))(x * (1, 5)), 1e-12))


def by_voronoi(p, v, q):
    """Sibson's natural neighbours: what a cell takes of the others' areas."""
    def areas(points):
        voronoi = Voronoi(points)
        regions = [voronoi.regions[r] for r in voronoi.point_region]
        return np.array([0 if -1 in r else
                         ConvexHull(voronoi.vertices[r]).volume
                         for r in regions])

    size = np.abs(p).max()
    p = np.vstack((p, 60 * size * np.array([[1, 1], [1, -1], [-1, 1],
                                            [-1, -1]])))
    before, out = areas(p), []
    for place in q:
        after = areas(np.vstack((p, place)))
        taken = before - after[:-1]
        taken[np.abs(taken) < 1e-10 * size ** 2] = 0
        out.append(taken[:len(v)] @ v / after[-1])
    return np.array(out)


def by_slopes(p, v, q):
    """-method smooth, as the recipe tr_slopes says, but in the plane: a side of
    two triangles counts 4 times; two points far off it add to the diagonal
    alone."""
    mesh = Delaunay(p)
    # (the first point's value is that of the two)
    often = np.ones(len(p))
    often[0] = 3
    far = np.sqrt(often)[:, None]
    g = np.linalg.lstsq(far * np.column_stack((p, np.ones(len(p)))),
                        far[:, 0] * v, rcond=None)[0][:2]
    g = np.tile(g, (len(p), 1))
    sides = np.vstack([mesh.simplices[:, [k, k - 1]] for k in range(3)])
    a, c = np.vstack((sides, sides[:, ::-1])).T
    e = p[c] - p[a]
    w = 2 / (e ** 2).sum(1)
    m = np.zeros((len(p), 2, 2))
    np.add.at(m, a, w[:, None, None] * e[:, :, None] * e[:, None, :])
    size = np.trace(m, axis1=1, axis2=2) + 2 * np.bincount(
        mesh.simplices.ravel(), minlength=len(p))
    m += 1e-4 * size[:, None, None] * np.eye(2)
    for k in range(4):
        s = (g[a] * e).sum(1)
        if k > 0:
            s = (s + (g[c] * e).sum(1)) / 2
        r = np.zeros(p.shape)
        np.add.at(r, a, (w * (v[c] - v[a] - s))[:, None] * e)
        g = g + (1.8 if k else 1) * np.linalg.solve(m, r[:, :, None])[:, :, 0]
    t = mesh.find_simplex(q)
    u = np.einsum("ijk,ik->ij", mesh.transform[t, :2],
                  q - mesh.transform[t, 2])
    u = np.column_stack((u, 1 - u.sum(1)))
    i = mesh.simplices[t]
    return (u * (v[i] + ((q[:, None] - p[i]) * g[i]).sum(2) / 2)).sum(1)


x = random.random((1500, 2)) * (400, 200) - (200, 100)
save("lonlat.csv", x, names="lon,lat")
where = LinearNDInterpolator(f, np.column_stack((V, W)))(x)
out = np.isnan(where[:, 0])
inner = np.flatnonzero((np.abs(x) < (150, 70)).all(1))
for method in METHODS:
    tess("-q", "-cols", "lon,lat,temp,w", "-query", "lonlat.csv", "-method",
         method, "-values", "f.npy", "-values", "f.csv", "flat.csv")
    got = np.load("f.npy")
    test("plane, %s: NaN outside the hull" % method, out.sum() > 100 and
         bool(np.all(np.isnan(got).any(1) == out)))
    if method != "nearest":
        test("plane, %s: a linear field comes out as it is" % method,
             near(got[:, 1], where[:, 1], 1e-11))
    if method == "linear":
        test("plane, -query: LinearNDInterpolator's", near(got, where, 1e-12))
        test("plane, -query, .csv: two coordinates", near(
            np.genfromtxt("f.csv", delimiter=",", skip_header=1)[:, :2], x, 0.0))
    if method == "nearest":
        want = np.where(out, np.nan, V[cKDTree(f).query(x)[1]])
        test("plane, nearest: the k-d tree's", near(got[:, 0], want, 0.0))
    if method == "natural":
        want = by_voronoi(f, V, x[inner[:9]])
        test("plane, natural: areas of SciPy's Voronoi cells",
             near(got[inner[:9], 0], want, 1e-7))
    if method == "smooth":
        want = by_slopes(f, V, x[inner])
        test("plane, smooth: slopes in the plane, by NumPy",
             near(got[inner, 0], want, 1e-9))
    tess("-q", "-plane", "-query", "flat.csv", "-method", method, "-values",
         "f.npy", "flat.csv")
    test("plane, %s: the values at the points themselves" % method,
         near(np.load("f.npy"), np.column_stack((V, W)), 0.0))
# as a mesh in space of the same columns would not
tess("-cols", "lon,lat,temp", "-query", "lonlat.csv", "-values", "f.npy",
     "three.csv")
test("plane: places of two numbers a line, which is said",
     near(np.load("f.npy"), where[:, :1], 1e-12) and
     "in a plane" in tess.said)
for i, these in enumerate((f, np.vstack((f, f[::7])))):
    v = np.concatenate((V, V[::7] + 1))[:len(these)]
    mean = V + (np.arange(2000) % 7 == 0) * i / 2
    save("twins.csv", these, v, names="x,y,v")
    tess("-q", "-plane", "-outside", "nearest", "-query", "lonlat.csv",
         "-values", "f.npy", "twins.csv")
    got = np.load("f.npy")[:, 0]
    want = LinearNDInterpolator(f, mean)(x)
    test("plane: points at one place have their mean, %d" % i,
         near(np.where(out, np.nan, got), want, 1e-12) and
         not np.isnan(got).any())
# the hull's nearest point, by its sides
h = f[ConvexHull(f).vertices]
side = np.roll(h, -1, 0) - h
s = np.clip(((x[:, None] - h) * side).sum(2) / (side ** 2).sum(1), 0, 1)
foot = h + s[..., None] * side
foot = foot[np.arange(len(x)),
            ((foot - x[:, None]) ** 2).sum(2).argmin(1)][out]
tess("-q", "-plane", "-outside", "nearest", "-query", "lonlat.csv", "-values",
     "f.npy", "flat.csv")
test("plane, -outside nearest: the hull's nearest point",
     near(np.load("f.npy")[out, 1], 3 + 2 * foot[:, 0] - foot[:, 1] / 2, 1e-10))


def lines(table):
    return [line.split() for line in table.splitlines()
            if line.split()[0] in METHODS]


for options in (("-cols", "lon,lat,temp"), ("-plane",), ("-cols", "lon,lat")):
    table = lines(tess("-q", *options, "-validate", "-method",
                       ",".join(METHODS), "few.csv"))
    error = []
    for i in range(200):
        others = np.arange(200) != i
        error.append(LinearNDInterpolator(f[:200][others], V[:200][others])(
            f[i:i + 1])[0] - V[i])
    tess("-q", *options, "-validate", 200, "-errors", "e.csv", "few.csv")
    got = np.genfromtxt("e.csv", delimiter=",", skip_header=1)[:, -1]
    test("plane, -validate: each left out, LinearNDInterpolator's errors, %s" %
         options[0], len(table) == 4 and near(got, np.array(error), 1e-12))

# a plane of space: askew to the axes, and along each
for name, frame in (("askew", np.linalg.qr(random.random((3, 3)))[0][:2]),
                    ("z", np.eye(3)[:2]), ("y", np.eye(3)[::2]),
                    ("x", np.eye(3)[1:])):
    u, y = random.random((500, 2)), random.random((800, 2)) * 1.2 - .1
    save("tilted.csv", u @ frame + (3, 4, 5), bent(np.c_[u, u[:, :1]]))
    save("tilted.txt", y @ frame + (3, 4, 5))
    want = LinearNDInterpolator(u, bent(np.c_[u, u[:, :1]]))(y)
    for method in METHODS:
        tess("-query", "tilted.txt", "-method", method, "-values", "f.npy",
             "tilted.csv")
        got = np.load("f.npy")[:, 0]
        test("a plane in space, %s, %s" % (name, method),
             "lie in one plane" in tess.said and
             bool(np.all(np.isnan(got) == np.isnan(want))) and
             (method != "linear" or near(got, want, 1e-12)) and
             (method != "nearest" or near(got, np.where(
                 np.isnan(want), np.nan, bent(np.c_[u, u[:, :1]])[
                     cKDTree(u).query(y)[1]]), 0.0)))
# but one nearly so is none
save("nearly.csv", np.c_[u, 1e-9 * random.random(500)] + (0, 0, 1), u[:, 0])
tess("-q", "-grid", "9,9,1", "-values", "f.npy", "nearly.csv")
test("a thin layer is no plane", "lie in one plane" not in tess.said)

# ---- the methods ----

save("inside.csv", q)
where = LinearNDInterpolator(p, T)(q)
for method in METHODS:
    tess("-q", "-query", "inside.csv", "-method", method, "-values", "m.npy",
         "points.csv")
    got = np.load("m.npy")
    test(method + ": NaN outside the hull",
         bool(np.all(np.isnan(got[:, 0]) == np.isnan(where))))
    if method == "nearest":
        at = cKDTree(p).query(q)[1]
        nearest = np.column_stack((T[at], U[at]))
        nearest[np.isnan(where)] = np.nan
        test("nearest: the k-d tree's", near(got, nearest, 0.0))
    else:
        test(method + ": a linear field comes out as it is",
             near(got[:, 1], np.where(np.isnan(where), np.nan, linear(q)),
                  1e-12))
    # at the points, their values: exactly
    tess("-q", "-query", "points.csv", "-method", method, "-values", "m.npy",
         "points.csv")
    test(method + ": the values at the points themselves",
         near(np.load("m.npy"), np.column_stack((T, U)), 0.0))

# on a lattice, where all places lie on facets and edges
lattice = places((0, 0, 0), (4, 4, 4), (5, 5, 5)).reshape(-1, 3)
save("lattice.csv", lattice, linear(lattice))
for method in METHODS[:3]:
    tess("-q", "-grid", "9,9,9", "-method", method, "-values", "l.npy",
         "lattice.csv")
    test(method + ": a lattice, its hull included",
         near(np.load("l.npy")[..., 0],
              linear(places((0, 0, 0), (4, 4, 4), (9, 9, 9))), 1e-12))

# where double precision does not locate: units beyond its range, needles, and
# facets that places are in but for rounding
for method in METHODS:
    o = ["-q", "-query", "inside.csv", "-method", method, "-values"]
    tess(*o, "one.npy", "points.csv")
    one = np.load("one.npy")
    for power in -1000, -345, -340, 340, 1000:
        save("far.csv", p * 2.0 ** power, T, U)
        save("there.csv", q * 2.0 ** power)
        o[2] = "there.csv"
        tess(*o, "far.npy", "far.csv")
        test("%s: coordinates times 2^%d" % (method, power),
             near(np.load("far.npy"), one, 1e-12))
    for power in -1000, 1010:
        save("far.csv", p, np.ldexp(T, power), np.ldexp(U, power))
        o[2] = "inside.csv"
        tess(*o, "far.npy", "far.csv")
        test("%s: values times 2^%d" % (method, power),
             near(np.ldexp(np.load("far.npy"), -power), one, 1e-12))
thin = p * (1, 1e-6, 1e-12)
save("thin.csv", thin, linear(p))
tess("-q", "-grid", "21,21,21", "-values", "thin.npy", "thin.csv")
got = np.load("thin.npy")[..., 0]
at = linear(places(p.min(0), p.max(0), (21, 21, 21)))
test("linear: needles", near(got, np.where(np.isnan(got), np.nan, at), 1e-11)
     and np.isnan(got).sum() < 6000)
turn = np.linalg.qr(random.random((3, 3)))[0]
turned = lattice @ turn
save("turned.csv", turned, linear(lattice))
at = places((0, 0, 0), (4, 4, 4), (17, 17, 17)).reshape(-1, 3)
save("about.csv", at @ turn)
tess("-q", "-query", "about.csv", "-values", "about.npy", "-outside",
     "nearest", "turned.csv")
test("linear: places on a turned lattice's facets and edges",
     near(np.load("about.npy")[:, 0], linear(at), 1e-12))

# a quadratic field, inside
square = p[:, 0] ** 2 - 2 * p[:, 1] ** 2 + p[:, 2] ** 2 / 2 + p[:, 0] * p[:, 1]
save("square.csv", p, square)
q = places([.15] * 3, [.85] * 3, (20, 20, 20))
want = q[..., 0] ** 2 - 2 * q[..., 1] ** 2 + q[..., 2] ** 2 / 2 + \
    q[..., 0] * q[..., 1]
rms = {}
for method in METHODS:
    tess("-q", "-grid", "20,20,20,.15,.85,.15,.85,.15,.85", "-method", method,
         "-values", "s.npy", "square.csv")
    rms[method] = np.sqrt(np.mean((np.load("s.npy")[..., 0] - want) ** 2))
test("smooth: a quadratic field, to a seventh of linear's error",
     rms["smooth"] < rms["linear"] / 7)
test("natural, nearest: a quadratic field",
     rms["natural"] < 2 * rms["linear"] < rms["nearest"])


def recipes(p, f, q):
    """Smooth, by the recipes tr_slopes and tr_bent themselves; outside as the
    hull's nearest point."""
    lib = ctypes.CDLL(sys.argv[2])
    n, room = len(p), 8 * len(p)
    point = ctypes.c_void_p

    def a(x):
        return x.ctypes.data_as(point)
    tet, adj = np.empty(4 * room, np.intc), np.empty(4 * room, np.intc)
    iw, rw = np.empty(40 * n + 9999, np.intc), np.empty(8 * n + 9999)
    g, work, at = np.empty(3 * n), np.empty(9 * n), np.empty(1)
    ntet, t = ctypes.c_int(), ctypes.c_int(-1)
    assert lib.tess(n, a(p), room, ctypes.byref(ntet), a(tet), a(adj), len(iw),
                    a(iw), len(rw), a(rw)) == 0
    assert lib.tr_slopes(n, a(p), ntet, a(tet), a(adj), a(f), 3, a(g),
                         a(work)) == 0
    out = np.empty(len(q))
    for i, x in enumerate(q):
        lib.tr_bent(a(p), ntet, a(tet), a(adj), a(f), a(g),
                    ctypes.c_double(0), a(x), ctypes.byref(t), a(at))
        out[i] = at[0]
    return out


if len(sys.argv) > 2:
    q = random.random((3000, 3)) * 1.2 - 0.1
    save("both.csv", q)
    tess("-q", "-query", "both.csv", "-method", "smooth", "-outside", "nearest",
         "-values", "s.npy", "points.csv")
    test("smooth: as the recipes tr_slopes and tr_bent, inside and outside",
         near(np.load("s.npy")[:, 0], recipes(p, T, q), 1e-12))


def cell(x, i):
    """The volume of point i's Voronoi cell among x, or infinity."""
    v = Voronoi(x)
    corners = v.regions[v.point_region[i]]
    return np.inf if -1 in corners else ConvexHull(v.vertices[corners]).volume


# Sibson's weights by their definition: what q's cell takes from the others'
x = random.random((150, 3))
f = random.random(150)
save("few.csv", x, f)
q = np.array([.5, .5, .5]) + 0.2 * (random.random((6, 3)) - 0.5)
save("six.csv", q)
tess("-q", "-query", "six.csv", "-method", "natural", "-values", "n.npy",
     "few.csv")
for i, at in enumerate(q):
    with_q = np.vstack((x, at))
    v = Voronoi(with_q)
    others = [k for pair in v.ridge_points if 150 in pair for k in pair
              if k != 150]
    stolen = np.array([cell(x, k) - cell(with_q, k) for k in others])
    test("natural: what cells lose, place %d, %d neighbours" %
         (i, len(others)),
         abs(np.dot(stolen, f[others]) / cell(with_q, 150) -
             np.load("n.npy")[i, 0]) < 1e-9)

# ---- stretched points, alpha shapes ----

flat = p * (1, 1, 1000)
save("flat.csv", flat, linear(flat), T)
tess("-q", "-scale", "1,1,.001", "-grid", "23,11,17", "-values", "f.csv",
     "flat.csv")
rows = np.genfromtxt("f.csv", delimiter=",", skip_header=1)
at = places(flat.min(0), flat.max(0), (23, 11, 17))
test("-scale: the places are as given", near(rows[:, :3], at.reshape(-1, 3),
                                             1e-12))
want = LinearNDInterpolator(p, T)(at * (1, 1, .001)).ravel()
test("-scale: values of the stretched mesh", near(rows[:, 4], want, 1e-11))
test("-scale: a linear field", near(
    rows[:, 3], np.where(np.isnan(want), np.nan, linear(at).ravel()), 1e-10))
x = p[np.linalg.norm(p - .5, axis=1) > .3]
save("hollow.csv", x, linear(x))
tess("-q", "-alpha", ".12", "-grid", "21,21,21,.1,.9,.1,.9,.1,.9", "-values",
     "h.npy", "hollow.csv")
d = Delaunay(x)
v = x[d.simplices]
e = v[:, 1:] - v[:, :1]
radius = np.linalg.norm(np.linalg.solve(e, (e ** 2).sum(2)[..., None] / 2),
                        axis=(1, 2))
at = places([.1] * 3, [.9] * 3, (21, 21, 21))
t = d.find_simplex(at)
want = np.where((t >= 0) & (radius[t] <= .12), linear(at), np.nan)
test("-alpha: NaN in all tetrahedra of a larger circumradius",
     near(np.load("h.npy")[..., 0], want, 1e-12) and
     1000 < np.isnan(want).sum() < 4000)

# ---- outside ----

corners = places((0, 0, 0), (1, 1, 1), (2, 2, 2)).reshape(-1, 3)
x = np.vstack((corners, p))
save("cube.csv", x, linear(x))
q = random.random((800, 3)) * 3 - 1
save("around.csv", q)
clipped = np.clip(q, 0, 1)
out = np.any(clipped != q, axis=1)
for method in METHODS:
    tess("-q", "-query", "around.csv", "-method", method, "-outside", "nearest",
         "-values", "o.npy", "cube.csv")
    got = np.load("o.npy")[:, 0]
    want = linear(clipped)
    if method == "nearest":
        want = linear(x[cKDTree(x).query(q)[1]])
    test(method + ": -outside nearest", near(got, want, 1e-12))
    tess("-q", "-query", "around.csv", "-method", method, "-outside", -99.5,
         "-values", "o.npy", "cube.csv")
    test(method + ": -outside VALUE",
         bool(np.all((np.load("o.npy")[:, 0] == -99.5) == out)))

# a place on the hull is inside, and up to four last places of the largest
# coordinate beside it; one that is farther out is not
ulp = 2.0 ** -52
at = np.array([[1, .3, .6], [1 + ulp, .3, .6], [1 - ulp, .3, .6], [.2, 0, .7],
               [.2, -1e-300, .7], [.2, 1e-300, .7], [.5, .5, 1],
               [.5, .5, 1 + 3 * ulp], [0, 0, 0], [-1e-300, 0, 0], [1, 1, .5],
               [1, 1 + 3 * ulp, .5], [1 + 5 * ulp, .3, .6],
               [.2, -5 * ulp, .7], [.5, .5, 1 + 5 * ulp], [1, 1 + 5 * ulp, .5],
               [.2, -3 * ulp, .7]])
save("hull.csv", at)
for method in METHODS:
    tess("-q", "-query", "hull.csv", "-method", method, "-values", "h.npy",
         "cube.csv")
    test(method + ": inside or outside to the last bit",
         list(np.isnan(np.load("h.npy")[:, 0])) ==
         list(np.any(np.abs(np.clip(at, 0, 1) - at) > 4 * ulp, axis=1)))

# the same where the hull's tetrahedra are as flat as rounding leaves them: points
# of a slanted lattice next to one of its faces; all numbers are exact
slant = np.array([[1, 2, 1], [2, 1, 3], [1, 3, 2]])
tiny = 2.0 ** -49
flat = places((0, 0, 0), (3, 3, 3), (4, 4, 4)).reshape(-1, 3)
sunk = (flat[:, 2] == 0) & np.all((flat[:, :2] > 0) & (flat[:, :2] < 3), axis=1)
flat[sunk, 2] = tiny * random.integers(1, 3, sunk.sum())
save("sunk.csv", flat @ slant, linear(flat))
at = np.concatenate([places((.25, .25, z), (2.75, 2.75, z), (11, 11, 1))
                     .reshape(-1, 3) for z in (0, -tiny, tiny, -64 * tiny)])
save("face.csv", at @ slant)
for method in METHODS:
    tess("-q", "-query", "face.csv", "-method", method, "-values", "f.npy",
         "sunk.csv")
    test(method + ": inside or outside, where the hull is flat",
         list(np.isnan(np.load("f.npy")[:, 0])) == list(at[:, 2] < -tiny))

# ---- many columns, duplicates ----

many = np.array([linear(p) * k for k in range(40)]).T
np.savetxt("many.txt", np.column_stack((p, many)), fmt="%.17g")
for method in METHODS[:3]:
    tess("-q", "-grid", "15,15,15,.2,.8,.2,.8,.2,.8", "-method", method,
         "-values", "m.npy", "many.txt")
    at = linear(places([.2] * 3, [.8] * 3, (15, 15, 15)))
    test(method + ": 40 columns", near(
        np.load("m.npy"), at[..., None] * np.arange(40), 1e-11))
twice = np.vstack((p, p[:100], p[:50]))
f = np.concatenate((T, T[:100] + 3, T[:50] + 6))
save("twice.csv", twice, f)
tess("-grid", "5,5,5", "-values", "t.npy", "twice.csv")
test("duplicates: it is said", "150 of the points" in tess.said)
tess("-q", "-query", "twice.csv", "-values", "t.npy", "twice.csv")
got = np.load("t.npy")[:, 0]
means = np.concatenate((T[:50] + 3, T[50:100] + 1.5, T[100:]))
test("duplicates: the mean of their values", near(
    got, np.concatenate((means, means[:100], means[:50])), 1e-12))
save("twice.csv", twice, np.concatenate((T, T[:100], T[:50])))
tess("-grid", "5,5,5", "-values", "t.npy", "twice.csv")
test("duplicates with the same values: nothing to say",
     "duplicate" not in tess.said and "mean" not in tess.said)


# a value that is missing
hole = T.copy()
hole[70] = np.nan
save("hole.csv", p, hole, U)
for options in (("-query", "hole.csv", "-values", "h.npy"), ("-validate",)):
    done = common.run("-q", *options, "hole.csv")
    test("a NaN among the values: its line is named, " + options[0],
         done.returncode == 2 and
         done.stderr.splitlines()[-1].startswith(
             "tess: hole.csv, line 72: T is NaN: -skip "))
tess("-skip", "-query", "points.csv", "-values", "h.npy", "hole.csv")
keep = np.arange(2000) != 70
test("a NaN among the values: -skip drops it, and counts",
     re.search("1 row.* dropped", tess.said) is not None and
     near(np.load("h.npy")[keep], np.column_stack((T, U))[keep], 0.0) and
     near(np.load("h.npy")[~keep], LinearNDInterpolator(
         p[keep], np.column_stack((T, U))[keep])(p[~keep]), 1e-12))
tess("-cols", "x,y,z,U", "-query", "hole.csv", "-values", "h.npy", "hole.csv")
test("a NaN in a column that is not asked for",
     near(np.load("h.npy")[:, 0], U, 0.0))
save("hole.csv", p, np.where(keep, T, np.inf), U)
tess("-query", "hole.csv", "-values", "h.npy", "hole.csv")
test("an infinite value: it is said; the others come out as they are",
     "1 value is not finite" in tess.said and
     near(np.load("h.npy")[keep], np.column_stack((T, U))[keep], 0.0))


# a value that stands for a missing one
void = random.permutation(2000)[:70]
codes = T.copy()
codes[void] = -9999
save("codes.csv", p, codes)
q = random.random((500, 3))
save("inside.csv", q)
tess("-nodata", -9999, "-query", "inside.csv", "-values", "v.npy", "codes.csv")
rest = np.delete(np.arange(2000), void)
test("-nodata: as without these rows", near(
    np.load("v.npy")[:, 0], LinearNDInterpolator(p[rest], T[rest])(q), 1e-12))
test("-nodata: it is said", "70 rows dropped" in tess.said and
     "far from" not in tess.said)
for name, f, words in (
        ("frequent", codes, "70 values of T are -9999, far from"),
        ("nines", np.where(np.arange(2000) == 7, 999, 99 * T),
         "1 value of T is 999, far from"),
        ("huge", np.where(np.arange(2000) < 2, np.float32(1e20), T),
         "-nodata " + repr(float(np.float32(1e20)))),
        ("others", np.where(np.arange(2000) < 2, -50.1, T),
         "-nodata -50.1"),
        ("once", np.where(np.arange(2000) == 7, -50.1, T), ""),
        ("none", T, ""), ("one value", 0 * T, ""),
        ("two values", np.round(random.random(2000)), ""),
        ("its own tail", np.exp(5 * random.standard_normal(2000)), "")):
    save("far.csv", p, f)
    tess("-grid", "2,2,2", "-values", "v.npy", "far.csv")
    test("values far from all others are said: " + name,
         words in tess.said if words else "far from" not in tess.said)

# ---- cross-validation, by a direct leave-out ----

def table(*arguments):
    """What -validate prints; table.best and table.beyond, its last lines."""
    rows = tess("-q", *arguments).split("\n")
    names = rows[0].split()
    assert rows[0].split()[:2] == ["method", "column"], names
    found, table.best, table.beyond = {}, {}, {}
    for r in rows[1:]:
        w = r.split()
        if r.startswith("best by rms error: "):
            for choice in r[len("best by rms error: "):].split(", "):
                method, column = choice.split(" for ")
                table.best[column] = method
        elif r.startswith("beyond the data's range: none"):
            assert not table.beyond
        elif r.startswith("beyond the data's range: "):
            m = re.match(r".*: (\w+) for (.*): (\d+) of (\d+) values, (\S+) "
                         r"to (\S+); the data (\S+) to (\S+) \(see -clip\)$", r)
            table.beyond[m.group(1), m.group(2)] = [
                float(a) for a in m.groups()[2:]]
        elif w:
            assert w[0] in METHODS
            found[w[0], w[1]] = [float(a) for a in w[2:7]] + [
                [float(a) for a in w[7].split(",")]]
    return found


def judged(error, where, outside):
    i = np.argmax(np.abs(error))
    return [np.mean(error), np.mean(np.abs(error)),
            np.sqrt(np.mean(error ** 2)), error[i], outside, list(where[i])]


def alike(a, b):
    """To the six digits that are printed; a bias, to six of its terms'."""
    return all(abs(u - v) <= 2e-5 * max(abs(u), b[1] if k == 0 else 0)
               for k, (u, v) in enumerate(zip(a[:5], b[:5]))) and \
        near(np.array(a[5]), np.array(b[5]), 1e-8)


def by_chance(n, k):
    """The part of each of n points, by the generator of Park and Miller."""
    order, part, seed = list(range(n)), np.zeros(n, int), 1
    for i in range(n - 1, 0, -1):
        seed = seed * 16807 % (2 ** 31 - 1)
        j = seed % (i + 1)
        order[i], order[j] = order[j], order[i]
    part[order] = np.arange(n) % k
    return part


def predict(x, data, part, methods, *options):
    """What the other parts' points predict of each part, by method."""
    predicted = {m: np.full(data.shape, np.nan) for m in methods}
    for r in set(part):
        out = part == r
        for m in methods:
            if m == "linear":
                predicted[m][out] = LinearNDInterpolator(
                    x[~out], data[~out])(x[out])
            elif m == "nearest":
                predicted[m][out] = data[~out][
                    cKDTree(x[~out]).query(x[out])[1]]
            else:
                save("others.csv", x[~out], data[~out])
                save("out.csv", x[out])
                tess("-q", "-query", "out.csv", "-method", m, *options,
                     "-values", "o.npy", "others.csv")
                predicted[m][out] = np.load("o.npy")
    inside = ~np.isnan(LinearNDInterpolator(x, data[:, 0])(x))
    if "linear" in methods:
        inside = ~np.isnan(predicted["linear"][:, 0])
    return predicted, inside


BEHIND = " (predicted minus measured)"


def read_errors(name):
    head = open(name).readline().strip().split(",")
    return {h.strip('"'): c for h, c in zip(head, np.genfromtxt(
        name, delimiter=",", skip_header=1).T)}


x = random.random((200, 3))
f, g = bent(x), 100 * linear(x) ** 2
data = np.column_stack((f, g))
save("left.csv", x, f, g)
for k in 10, 7, 200:
    which = METHODS if k == 7 else ["linear", "nearest"]
    found = table("-validate", k, "-method", ",".join(which), "-errors",
                  "e.csv", "left.csv")
    errors = read_errors("e.csv")
    part = errors["fold"].astype(int) - 1
    sizes = np.bincount(part, minlength=k)
    test("-validate %d: parts of one size, but for one point" % k,
         len(sizes) == k and sizes.max() - sizes.min() <= (200 % k > 0))
    test("-validate %d: the parts are by chance, as everywhere" % k,
         list(part) == list(by_chance(200, k)))
    predicted, inside = predict(x, data, part, which)
    for m in which:
        for j, name in enumerate("TU"):
            error = (predicted[m] - data)[:, j]
            test("-validate %d: %s, %s" % (k, m, name), alike(
                found[m, name],
                judged(error[inside], x[inside], (~inside).sum())))
            test("-errors: those of %s, %s" % (m, name), near(
                errors[m + "-" + name + BEHIND], np.where(inside, error, np.nan),
                1e-11 * np.abs(data[:, j]).max()))
    test("-errors: places and values", near(np.column_stack(
        [errors[h] for h in "xyzTU"]), np.column_stack((x, data)), 0.0))
    test("-validate %d: the best" % k, table.best == {
        name: min(which, key=lambda m: np.mean(
            (predicted[m] - data)[inside, j] ** 2))
        for j, name in enumerate("TU")})

# a lattice, listed x fastest: its planes are not left out as such
lattice = places((0, 0, 0), (9, 9, 9), (10, 10, 10)).reshape(-1, 3)
h = np.sin(lattice[:, 0] / 2) + np.cos(lattice[:, 1] / 3) * lattice[:, 2]
save("lattice.csv", lattice, h)
found = table("-validate", 10, "-method", "linear,nearest", "-errors", "e.csv",
              "lattice.csv")
part = read_errors("e.csv")["fold"]
test("-validate: parts of a lattice are no planes",
     all(len(set(lattice[part == r, k])) > 5 for r in set(part)
         for k in range(3)))

# groups: boreholes, words and numbers, as GroupKFold deals them
holes, deep = 23, random.integers(8, 30, 23)
hole = np.repeat(np.arange(holes), deep)
x = np.column_stack((random.random((holes, 2))[hole] +
                     1e-3 * random.random((len(hole), 2)),
                     -np.concatenate([np.arange(n) / 30 for n in deep])))
f = bent(3 * x)
for words in True, False:
    label = ["%s %d" % ("bh" if k % 2 else "BH", k) if words else "%d" % (k + 5)
             for k in hole]
    with open("holes.csv", "w") as out:
        out.write("hole,x,y,z,T\n" if words else "x,y,z,T,hole\n")
        for i in random.permutation(len(hole)):
            row = "%.17g,%.17g,%.17g,%.17g" % (tuple(x[i]) + (f[i],))
            out.write("%s,%s\n" % ((label[i], row) if words
                                   else (row, label[i])))
    for k in 10, 4:
        found = table("-validate", k, "-by", "hole", "-method",
                      "linear,nearest", "-errors", "e.csv", "holes.csv")
        e = read_errors("e.csv")
        test("-by: the column is no value, but is there", list(e) == [
            "x", "y", "z", "fold", "hole", "T",
            "linear-T" + BEHIND, "nearest-T" + BEHIND])
        at = cKDTree(x).query(np.column_stack([e[h] for h in "xyz"]))[1]
        part = np.zeros(len(x), int)
        part[at] = e["fold"]
        test("-by: no group is in two parts, %d" % k,
             all(len(set(part[hole == i])) == 1 for i in range(holes)))
        filled = np.zeros(k, int)
        for n in sorted(deep)[::-1]:
            filled[np.argmin(filled)] += n
        test("-by: parts as large as GroupKFold's, %d" % k,
             sorted(np.bincount(part)[1:]) == sorted(filled))
        predicted, inside = predict(x, f[:, None], part, ["linear", "nearest"])
        for m in predicted:
            error = predicted[m][:, 0] - f
            test("-by: %s, %d" % (m, k), alike(found[m, "T"], judged(
                error[inside], x[inside], (~inside).sum())))
    test("-by: larger errors than without", found["linear", "T"][2] >
         1.5 * table("-validate", 4, "-cols", "x,y,z,T", "holes.csv")
         ["linear", "T"][2])
tess("-validate", 30, "-by", "hole", "-errors", "e.csv", "holes.csv")
test("-by: fewer groups than parts: each alone, it is said",
     "23 folds, each of one group" in tess.said and
     sorted(np.bincount(read_errors("e.csv")["fold"].astype(int))[1:]) ==
     sorted(deep))
tess("-validate", 4, "-by", "hole", "-alpha", 1, "-errors", "e.csv",
     "holes.csv")
test("-validate: -alpha does not matter, which is said",
     "-validate is of the whole hull" in tess.said)
open("bare.csv", "w").write("".join(list(open("holes.csv"))[1:]))
tess("-q", "-validate", 4, "-by", 5, "-errors", "b.csv", "bare.csv")
test("-by: a column by number, without names",
     list(open("b.csv"))[1:] == list(open("e.csv"))[1:])
with open("both.csv", "w") as out:
    for i, at in enumerate(x):
        out.write("%.17g,%.17g,%.17g,%.17g,%d\n" % (*at, f[i], hole[i]))
    out.write("%.17g,%.17g,%.17g,%.17g,%d\n" % (*x[0], f[0], hole[-1]))
tess("-validate", 4, "-by", 5, "-errors", "b.csv", "both.csv")
test("-by: a place of two groups is said, and counts once",
     "1 point is at a place of another group" in tess.said and
     len(list(open("b.csv"))) == 1 + len(x))

lines = list(open("holes.csv"))
with open("lost.csv", "w") as out:
    for i, line in enumerate(lines):
        out.write(line if i % 5 else re.sub(",[^,]*$", ",NA\n", line))
tess("-validate", 4, "-skip", "-by", 5, "-errors", "b.csv", "lost.csv")
test("-by, -skip: a row without a group is dropped",
     len(list(open("b.csv"))) == 1 + sum(i % 5 > 0 for i in range(len(lines))))

# values beyond the data's range; -clip holds them
x = random.random((600, 3))
f = np.exp(2 * random.standard_normal(600))
g = linear(x)
data = np.column_stack((f, g))
save("grades.csv", x, f, g)
found = table("-validate", 5, "-method", "smooth,linear", "grades.csv")
part = by_chance(600, 5)
predicted, inside = predict(x, data, part, ["linear", "smooth"])
s = predicted["smooth"][inside, 0]
many = ((s < f.min()) | (s > f.max())).sum()
want = [many, inside.sum(), s.min(), s.max(), f.min(), f.max()]
test("-validate: values beyond the data's range: smooth, log-normal",
     list(table.beyond) == [("smooth", "T")] and many > 20 and
     np.allclose(table.beyond["smooth", "T"], want, rtol=1e-5, atol=0))
clipped = s.copy()
for r in range(5):
    at = part[inside] == r
    clipped[at] = np.clip(s[at], f[part != r].min(), f[part != r].max())
found = table("-validate", 5, "-method", "smooth,linear", "-clip", "grades.csv")
test("-clip: no value of -validate is beyond", table.beyond == {})
test("-clip: the table of clipped values", alike(found["smooth", "T"], judged(
    clipped - f[inside], x[inside], (~inside).sum())))
save("inside.csv", random.random((3000, 3)))
for outside in [], ["-outside", "nearest"], ["-outside", -7]:
    o = ["-q", "-query", "inside.csv", "-method", "smooth", *outside]
    tess(*o, "-values", "s.npy", "grades.csv")
    tess(*o, "-clip", "-values", "c.npy", "grades.csv")
    s = np.load("s.npy")
    out = np.isnan(np.load("s.npy")) | (s == -7)
    test("-clip: values in the data's range, %s" % outside, near(
        np.load("c.npy"), np.where(out, s, np.clip(
            s, data.min(0), data.max(0))), 0.0) and s[~out].min() < f.min())

# units near the ends of the range of numbers: the errors of usual ones, scaled
x = random.random((200, 3)) - 0.5
f = bent(x)
save("one.csv", x, f)
one = table("-validate", "-method", ",".join(METHODS), "one.csv")
for there, by in ((0, 1022), (0, -1000), (1023, 0), (-1000, 0), (1000, 1000),
                  (-1000, -1000), (-1000, 1000)):
    save("far.csv", np.ldexp(x, there), np.ldexp(f, by))
    found = table("-validate", "-method", ",".join(METHODS), "far.csv")
    test("-validate: coordinates times 2^%d, values times 2^%d" % (there, by),
         all(alike([np.ldexp(a, -by) for a in found[k][:4]] + [found[k][4]] +
                   [[np.ldexp(a, -there) for a in found[k][5]]], one[k])
             for k in one))
save("far.csv", np.vstack((np.ldexp(x, 1020), np.ldexp(x[:9], -600))),
     np.concatenate((f, f[:9])))
done = common.run("-q", "-validate", "-method", "smooth", "far.csv")
test("-validate: what cannot be scaled is refused", done.returncode == 2 and
     "differ too much" in done.stderr and not done.stdout)
save("far.csv", x, np.where(random.random(200) < .5, -1.7e308, 1.7e308))
done = common.run("-q", "-validate", "-method", "smooth", "far.csv")
test("-validate: values beyond the range of numbers are none",
     done.returncode == 2 and not done.stdout and
     "divide the points' values by ten" in done.stderr)
x = random.random((200, 3))
f, g = bent(x), 100 * linear(x) ** 2
test("-validate: 10, if no number is given",
     table("-validate", "left.csv") == table("left.csv", "-validate", 10))
inside = table("-validate", "-outside", "nearest", "left.csv")["linear", "T"]
save("shell.csv", np.vstack((corners, x)),
     np.concatenate((linear(corners), linear(x))))
test("-validate, -outside nearest: points outside count, too",
     inside[1] > table("-validate", "left.csv")["linear", "T"][1])
save("twins.csv", np.repeat(x, 2, axis=0), np.repeat(f, 2))
twins = table("-validate", 200, "-method", "nearest", "twins.csv")
test("-validate: a duplicate does not predict its twin",
     twins["nearest", "T"][1] > 0.01)
tess("-validate", 400, "twins.csv")
test("-validate: fewer places than parts: it is said",
     "200 folds, each of one place" in tess.said)
save("hole.csv", x, np.where(np.arange(200) == 70, np.inf, f), g)
found = table("-validate", "hole.csv")
test("-validate: an infinite error is the worst one",
     not np.isfinite(found["linear", "T"][3]) and
     np.isfinite(found["linear", "U"][3]))
