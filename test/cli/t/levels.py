# levels.py - surfaces of equal value by build/tess -iso, beside VTK's contour
# filter on the same mesh; test_values.py runs it.
#
#   python3 levels.py TESS MIRROR
#
# MIRROR: the file of data/mirror.xyz.  In the current directory, where it
# leaves its files.  Prints `ok ...' or `FAILED ...' for each test.
import re
import sys
from collections import Counter

import numpy as np

import common
from common import run, test

try:
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy
except ImportError:
    vtk = None

random = np.random.default_rng(66)
MIRROR = sys.argv[2]


def tess(*arguments):
    return common.tess(*arguments).stdout


def write(name, head, table):
    with open(name, "w") as f:
        f.write(head + "\n")
        for row in table:
            f.write(",".join(repr(float(x)) for x in row) + "\n")


# ---- surfaces, as they are written ----

def obj(name):
    """Points, triangles."""
    p, t = [], []
    for line in open(name):
        word = line.split()
        if word[0] == "v":
            p.append([float(x) for x in word[1:]])
        else:
            t.append([int(x) - 1 for x in word[1:]])
    return np.array(p).reshape(-1, 3), np.array(t, int).reshape(-1, 3)


def ply(name):
    """Points, their values, triangles."""
    lines = open(name).read().split("\n")
    n = int([l for l in lines if l.startswith("element vertex")][0].split()[2])
    f = int([l for l in lines if l.startswith("element face")][0].split()[2])
    body = lines[lines.index("end_header") + 1:]
    p = np.array([l.split() for l in body[:n]], float)
    t = np.array([l.split() for l in body[n:n + f]], int)
    assert np.all(t[:, 0] == 3) and body[n + f:] == [""]
    return p[:, :3], p[:, 3:], t[:, 1:]


def stl(name):
    """Corners of triangles; their normals."""
    text = open(name).read()
    x = re.findall(r"vertex (\S+) (\S+) (\S+)", text)
    n = re.findall(r"facet normal (\S+) (\S+) (\S+)", text)
    return np.array(x, float).reshape(-1, 3, 3), np.array(n, float)


def vectors(c):
    """Of triangles of such corners: to where they face, of twice the area."""
    return np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])


def area(c):
    return np.linalg.norm(vectors(c), axis=1).sum() / 2


def volume(c):
    return np.einsum("ij,ij->", c[:, 0] - c[0, 0], vectors(c)) / 6


def ways(t):
    return Counter((int(a), int(b)) for r in t
                   for a, b in ((r[0], r[1]), (r[1], r[2]), (r[2], r[0])))


def sound(p, t):
    """No point twice or unused, no triangle without three points or twice."""
    return (len(np.unique(p, axis=0)) == len(p) and
            len(np.unique(t)) == len(p) and
            all(len(set(r)) == 3 for r in t.tolist()) and
            len(set(map(tuple, np.sort(t, axis=1).tolist()))) == len(t))


# ---- the mesh, and what of it is above a level ----

def mesh(name):
    """By VTK: the grid; points, tetrahedra, the first value."""
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(name)
    reader.ReadAllScalarsOn()
    reader.Update()
    g = reader.GetOutput()
    return (g, vtk_to_numpy(g.GetPoints().GetData()),
            vtk_to_numpy(g.GetCells().GetConnectivityArray()).reshape(-1, 4),
            vtk_to_numpy(g.GetPointData().GetArray(0)))


def part(f, level):
    """Of a tetrahedron: one above or below is cut off as a corner; of two
    above, an edge to one below is cut first."""
    up, down = [x for x in f if x >= level], [x for x in f if x < level]

    def corner(x, others):
        return np.prod([(x - level) / (x - y) for y in others])

    if not up or not down:
        return float(not down)
    if len(up) == 1:
        return corner(up[0], down)
    if len(down) == 1:
        return 1 - corner(down[0], up)
    s = (up[0] - level) / (up[0] - down[0])
    return (s * (1 - corner(down[1], up + [level])) +
            ((1 - s) * corner(up[1], down + [level]) if up[1] > level else 0))


def above(p, t, f, level):
    e = p[t[:, 1:]] - p[t[:, :1]]
    return sum(v * part(list(f[c]), level)
               for v, c in zip(np.linalg.det(e) / 6, t))


def contour(g, level):
    """The triangles of VTK's filter, in doubles."""
    g.GetPointData().SetActiveScalars(g.GetPointData().GetArrayName(0))
    filter = vtk.vtkContourFilter()
    filter.SetInputData(g)
    filter.SetOutputPointsPrecision(vtk.vtkAlgorithm.DOUBLE_PRECISION)
    filter.GenerateTrianglesOn()
    filter.ComputeNormalsOff()
    filter.SetNumberOfContours(1)
    filter.SetValue(0, level)
    filter.Update()
    out = filter.GetOutput()
    p = vtk_to_numpy(out.GetPoints().GetData())
    assert p.dtype == np.float64
    return p[vtk_to_numpy(out.GetPolys().GetConnectivityArray())
             .reshape(-1, 3)]


def said(text):
    """Of each level: triangles, area, volume and where that is, or None."""
    return [(int(t), float(a), float(v) if v else None, w)
            for t, a, v, w in re.findall(
                r"^level +\S+ of [^:]+: (\d+) triangles, area ([^ ;]+)"
                r"(?:; closed, volume (\S+) (\w+) it)?", text, re.M)]


def same(a, b, most):
    return abs(a - b) <= most * abs(b)


def beside_vtk(name, what, levels, ties=False, options=()):
    """The surfaces of a file of points; ties: values are levels."""
    listed = ",".join(str(l) for l in levels)
    tess(*options, "-mesh", "m.vtk", name)
    g, p, t, f = mesh("m.vtk")
    words = said(tess(*options, "-iso", listed, "a.obj", "-iso", listed,
                      "a.ply", "-iso", listed, "a.stl", "-iso", listed,
                      "a.vtk", name))
    points, triangles = obj("a.obj")
    corners = points[triangles]
    q, value, r = ply("a.ply")
    test(what + ": OBJ and PLY are the same, with the level",
         np.array_equal(q, points) and np.array_equal(r, triangles) and
         set(value[:, 0]) == set(levels))
    c, n = stl("a.stl")
    out = vectors(corners)
    size = np.linalg.norm(out, axis=1)
    test(what + ": so is STL, with normals",
         np.array_equal(c, corners) and
         np.all(np.einsum("ij,ij->i", n, out)[size > 1e-9] > 0))
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName("a.vtk")
    reader.Update()
    d = reader.GetOutput()
    x = vtk_to_numpy(d.GetPoints().GetData())
    test(what + ": and VTK", np.array_equal(
        x[vtk_to_numpy(d.GetCells().GetConnectivityArray()).reshape(-1, 3)],
        corners))
    for l, (many, size, _, _) in zip(levels, words):
        mine = value[triangles[:, 0], 0] == l
        theirs = area(contour(g, l))
        test("%s: the area of level %g is that of VTK's contour filter" %
             (what, l), same(area(corners[mine]), theirs, 1e-12) and
             many == mine.sum() and same(size, theirs, 1e-8))
    for l in levels:
        (_, size, inside, where), = said(tess(
            *options, "-iso-closed", "-iso", l, "b.obj", name))
        q, r = obj("b.obj")
        edge = ways(r)
        test("%s: closed at level %g: an edge twice, once a way" % (what, l),
             all(edge[b, a] == edge[a, b] for a, b in edge) and
             (ties or set(edge.values()) == {1}))
        test("%s: closed at level %g: no point, no triangle twice" % (what, l),
             sound(q, r))
        test("%s: closed at level %g: the volume above it" % (what, l),
             same(volume(q[r]), above(p, t, f, l), 1e-11) and
             same(inside, volume(q[r]), 1e-8) and where == "above" and
             same(size, area(q[r]), 1e-8))


n = 400
cloud = random.random((n, 3))
field = np.sin(5 * cloud[:, 0]) + cloud[:, 1] * np.cos(4 * cloud[:, 2])
write("cloud.csv", "x,y,z,v", np.c_[cloud, field])
i = np.arange(7 ** 3)
lattice = np.c_[i % 7, i // 7 % 7, i // 49].astype(float)
write("lattice.csv", "x,y,z,v", np.c_[lattice, lattice @ [1, 2, 3]])
if vtk:
    beside_vtk(MIRROR, "mirror", [10, 10.75, 11.5])
    beside_vtk("cloud.csv", "a cloud", [-0.3, 0.25, 1.1])
    beside_vtk("lattice.csv", "a lattice", [12.5])
    beside_vtk("lattice.csv", "a lattice, values at the level", [5, 13, 24],
               ties=True)
    beside_vtk("cloud.csv", "-scale", [0.25], options=("-scale", "1,3,0.5"))
    beside_vtk("cloud.csv", "-alpha", [0.25], ties=True,
               options=("-alpha", "0.13"))
else:
    print("        skipped: -iso beside VTK's contour filter: no vtk")

# ---- values next to the level: points that rounding makes one ----

tiny = lattice[:, 0] + (random.random(len(lattice)) - 0.5) * 1e-14
write("near.csv", "x,y,z,v", np.c_[lattice + 5, tiny])
for closed in [], ["-iso-closed"]:
    (many, size, inside, _), = said(tess(*closed, "-iso", "3", "a.obj",
                                         "near.csv"))
    p, t = obj("a.obj")
    edge = ways(t)
    test("values next to the level%s: no point, no triangle twice, the area" %
         (", closed" if closed else ""),
         sound(p, t) and many == len(t) and
         same(size, 144 if closed else 36, 1e-8) and
         same(area(p[t]), 144 if closed else 36, 1e-12) and
         (not closed or (same(inside, 108, 1e-8) and
                         all(edge[b, a] == edge[a, b] for a, b in edge))))

# ---- normals, volumes, values ----

tess("-iso", "13", "a.obj", "lattice.csv")
p, t = obj("a.obj")
test("normals point to where values are lower",
     np.all(vectors(p[t]) @ [1, 2, 3] < 0))
middle = np.linalg.norm(cloud - 0.5, axis=1)
write("low.csv", "x,y,z,v", np.c_[cloud, middle])
write("high.csv", "x,y,z,v", np.c_[cloud, -middle])
(_, _, low, where), = said(tess("-iso", "0.3", "a.obj", "low.csv"))
(_, _, high, there), = said(tess("-iso", "-0.3", "b.obj", "high.csv"))
test("a shell that does not meet the hull: what it encloses, above or below",
     where == "below" and there == "above" and same(low, high, 1e-8) and
     0.08 < low < 4 / 3 * np.pi * 0.3 ** 3)
write("two.csv", "x,y,z,v,w", np.c_[cloud, field, middle])
tess("-iso", "0.25", "a.obj", "two.csv", "-iso", "0.25", "c.ply")
tess("-iso", "0.25", "b.obj", "cloud.csv")
test("of two columns the first one", np.array_equal(obj("a.obj")[0],
                                                    obj("b.obj")[0]) and
     "property double v\nelement face" in open("c.ply").read())
write("twice.csv", "x,y,z,v", np.r_[np.c_[cloud, field - 0.5],
                                    np.c_[cloud, field + 0.5]])
done = run("-iso", "0.25", "a.obj", "twice.csv")
tess("-iso", "0.25", "b.obj", "cloud.csv")
p, t = obj("a.obj")
q, r = obj("b.obj")
test("of duplicates the mean, which is said",
     np.array_equal(t, r) and np.abs(p - q).max() < 1e-12 and
     "400 with another value: -iso takes their mean" in done.stderr)


# ---- what cannot be ----

def refuses(words, *arguments):
    done = run(*arguments)
    test("refuses " + " ".join(str(a) for a in arguments),
         done.returncode == 2 and done.stdout == "" and
         done.stderr.count("\n") == 1 and words in done.stderr)


write("bare.csv", "x,y,z", cloud)
write("nan.csv", "x,y,z,v", np.c_[cloud, np.r_[field[1:], np.nan]])
write("flat.csv", "x,y,z,v", np.c_[cloud[:, :2], 0 * field, field])
refuses("the name must end in .stl, .obj, .ply or .vtk", "-iso", "0", "a.off",
        "cloud.csv")
refuses("needs LEVEL[,LEVEL...] F", "-iso", "0")
refuses("not a number", "-iso", "high", "a.obj", "cloud.csv")
refuses("more than 64 levels", "-iso", ",".join(["1"] * 65), "a.obj",
        "cloud.csv")
refuses("-iso-closed is for -iso LEVEL F", "-iso-closed", "cloud.csv")
refuses("-iso is not for -periodic", "-iso", "0", "a.obj", "-periodic", "-box",
        "0,1,0,1,0,1", "cloud.csv")
refuses("the points have no values", "-iso", "0", "a.obj", "bare.csv")
refuses("-iso is for points in space", "-iso", "0", "a.obj", "-cols", "x,y",
        "-grid", "3,3", "-values", "v.csv", "cloud.csv")
done = run("-iso", "0", "a.obj", "nan.csv")
test("refuses a value that is NaN", done.returncode == 2 and
     "nan.csv, line 401: v is NaN: -skip drops" in done.stderr)
done = run("-q", "-iso", "7", "a.obj", "cloud.csv")
test("no such level: said, with the range", done.returncode == 0 and
     "-iso 7: there is no such surface; v is from " in done.stderr)
done = run("-q", "-iso", "0", "none.obj", "flat.csv")
test("no tetrahedra: said", done.returncode == 0 and
     "none.obj: no surface: all points lie in one plane" in done.stderr)
