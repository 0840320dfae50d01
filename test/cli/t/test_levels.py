"""test_levels.py - surfaces of equal value by build/tess -iso, beside VTK's contour
filter on the same mesh."""
import collections
import re

import pytest

from beside import by_vtk, chance, lattice, np, obj, save, text
from common import TOP

CLOUD = chance(66).random((400, 3))
FIELD = np.sin(5 * CLOUD[:, 0]) + CLOUD[:, 1] * np.cos(4 * CLOUD[:, 2])
MIDDLE = np.linalg.norm(CLOUD - 0.5, axis=1)
LATTICE = lattice(7)
SETS = {"mirror": (), "cloud": (CLOUD, FIELD), "lattice": (LATTICE, LATTICE @ [1, 2, 3])}


def given(name):
    return str(TOP / "test/data/mirror.xyz") if name == "mirror" else save(
        name + ".csv", *SETS[name], names="x,y,z,v")


# ---- surfaces, as they are written ----

def ply(name):
    """Points, their values, triangles."""
    lines = text(name).split("\n")
    n, f = (int(re.search(r"element %s (\d+)" % e, text(name))[1])
            for e in ("vertex", "face"))
    body = lines[lines.index("end_header") + 1:]
    p = np.array([line.split() for line in body[:n]], float)
    t = np.array([line.split() for line in body[n:n + f]], int)
    assert np.all(t[:, 0] == 3) and body[n + f:] == [""]
    return p[:, :3], p[:, 3:], t[:, 1:]


def stl(name):
    """Corners of triangles; their normals."""
    return [np.array(re.findall(word + r" (\S+) (\S+) (\S+)", text(name)), float).reshape(
        -1, *size) for word, size in (("vertex", (3, 3)), ("facet normal", (3,)))]


def vectors(c):
    """Of triangles of such corners: to where they face, of twice the area."""
    return np.cross(c[:, 1] - c[:, 0], c[:, 2] - c[:, 0])


def area(c):
    return np.linalg.norm(vectors(c), axis=1).sum() / 2


def volume(c):
    return np.einsum("ij,ij->", c[:, 0] - c[0, 0], vectors(c)) / 6


def ways(t):
    return collections.Counter((int(r[k]), int(r[k - 2])) for r in t for k in range(3))


def closed(t):
    """each edge as often one way as the other; how often that is"""
    edge = ways(t)
    assert edge and all(edge[b, a] == edge[a, b] for a, b in edge)
    return set(edge.values())


def sound(p, t):
    """No point twice or unused, no triangle without three points or twice."""
    assert len(np.unique(p, axis=0)) == len(p) == len(np.unique(t))
    assert all(len(set(r)) == 3 for r in t.tolist())
    assert len(set(map(tuple, np.sort(t, axis=1).tolist()))) == len(t)


def said(out):
    """Of each level: triangles, area, volume and where that is, or None."""
    return [(int(t), float(a), float(v) if v else None, w)
            for t, a, v, w in re.findall(
                r"^level +\S+ of [^:]+: (\d+) triangles, area ([^ ;]+)"
                r"(?:; closed, volume (\S+) (\w+) it)?", out, re.M)]


def close(a, b, most=1e-8):
    assert a == pytest.approx(b, rel=most, abs=0)


# ---- the mesh, and what of it is above a level ----

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


def above(mesh, level):
    f = list(mesh.values.values())[0]
    x = mesh.points[mesh.cells]
    return sum(v * part(list(f[c]), level) for v, c in zip(
        np.linalg.det(x[:, 1:] - x[:, :1]) / 6, mesh.cells))


def contour(mesh, level):
    """The triangles of VTK's filter, in doubles."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    g = mesh.set
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
    return p[vtk_to_numpy(out.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


@pytest.mark.parametrize("name, levels, options", [
    ("mirror", [10, 10.75, 11.5], ""), ("cloud", [-0.3, 0.25, 1.1], ""),
    ("lattice", [12.5], ""), ("lattice", [5, 13, 24], ""),  # (values are levels)
    ("cloud", [0.25], "-scale 1,3,0.5"), ("cloud", [0.25], "-alpha 0.13")])
def test_surfaces_are_those_of_vtk_s_contour_filter(run, name, levels, options):
    ties = name == "lattice" and 13 in levels or "-alpha" in options
    name, options = given(name), options.split()
    listed = ",".join(map(str, levels))
    words = said(run(*options, "-mesh", "m.vtk", *(
        w for end in ("obj", "ply", "stl", "vtk") for w in ("-iso", listed, "a." + end)),
        name).out)
    mesh = by_vtk("m.vtk")
    p, t = obj("a.obj")
    corners = p[t]
    # OBJ and PLY are the same, with the level; so is STL, with normals; and VTK
    q, value, r = ply("a.ply")
    assert (q == p).all() and (r == t).all() and set(value[:, 0]) == set(levels)
    c, n = stl("a.stl")
    out = vectors(corners)
    assert (c == corners).all()
    assert (np.einsum("ij,ij->i", n, out)[np.linalg.norm(out, axis=1) > 1e-9] > 0).all()
    data = by_vtk("a.vtk")
    assert (data.points[data.cells] == corners).all()
    assert words == 4 * words[:len(levels)] and len(words) == 4 * len(levels)
    for l, (many, size, _, _) in zip(levels, words):
        mine, theirs = value[t[:, 0], 0] == l, area(contour(mesh, l))
        close(area(corners[mine]), theirs, 1e-12)
        close(size, theirs)
        assert many == mine.sum()
        (_, size, inside, where), = said(run(*options, "-iso-closed", "-iso", l, "b.obj",
                                             name).out)
        q, r = obj("b.obj")
        assert closed(r) == {1} or ties
        sound(q, r)
        close(volume(q[r]), above(mesh, l), 1e-11)
        close(inside, volume(q[r]))
        close(size, area(q[r]))
        assert where == "above"


@pytest.mark.parametrize("option", [[], ["-iso-closed"]])
def test_values_next_to_the_level(run, option):
    """points that rounding makes one"""
    for seed in range(4):
        tiny = LATTICE[:, 0] + (chance(seed).random(343) - 0.5) * 1e-14
        save("near.csv", LATTICE + 5, tiny, names="x,y,z,v")
        (many, size, inside, _), = said(run(*option, "-iso", "3", "a.obj", "near.csv").out)
        p, t = obj("a.obj")
        sound(p, t)
        assert many == len(t)
        close(size, 144 if option else 36)
        close(area(p[t]), 144 if option else 36, 1e-12)
        if option:
            close(inside, 108)
            closed(t)


# ---- normals, volumes, values ----

def test_normals_point_to_where_values_are_lower(run):
    run("-iso", "13", "a.obj", given("lattice"))
    p, t = obj("a.obj")
    assert len(t) > 9 and (vectors(p[t]) @ [1, 2, 3] < 0).all()


def test_shell_that_does_not_meet_the_hull(run):
    """what it encloses, above or below"""
    (_, _, low, below), = said(run("-iso", "0.3", "a.obj", save(
        "low.csv", CLOUD, MIDDLE)).out)
    (_, _, high, above), = said(run("-iso", "-0.3", "b.obj", save(
        "high.csv", CLOUD, -MIDDLE)).out)
    assert (below, above) == ("below", "above")
    close(low, high)
    assert 0.08 < low < 4 / 3 * np.pi * 0.3 ** 3


def test_first_of_two_columns(run):
    save("two.csv", CLOUD, FIELD, MIDDLE, names="x,y,z,v,w")
    run("-iso", "0.25", "a.obj", "two.csv", "-iso", "0.25", "c.ply")
    run("-iso", "0.25", "b.obj", given("cloud"))
    assert (obj("a.obj")[0] == obj("b.obj")[0]).all()
    assert "property double v\nelement face" in text("c.ply")


def test_duplicates_have_the_mean(run):
    save("twice.csv", np.r_[CLOUD, CLOUD], np.r_[FIELD - 0.5, FIELD + 0.5])
    done = run("-iso", "0.25", "a.obj", "twice.csv")
    run("-iso", "0.25", "b.obj", given("cloud"))
    (p, t), (q, r) = obj("a.obj"), obj("b.obj")
    assert (t == r).all() and np.abs(p - q).max() < 1e-12
    assert "400 with another value: -iso takes their mean" in done.err


# ---- what cannot be ----

@pytest.mark.parametrize("words, options", [
    ("the name must end in .stl, .obj, .ply or .vtk", "-iso 0 a.off cloud.csv"),
    ("needs LEVEL[,LEVEL...] F", "-iso 0"), ("not a number", "-iso high a.obj cloud.csv"),
    ("more than 64 levels", "-iso %s a.obj cloud.csv" % ",".join(["1"] * 65)),
    ("-iso-closed is for -iso LEVEL F", "-iso-closed cloud.csv"),
    ("-iso is not for -periodic", "-iso 0 a.obj -periodic -box 0,1,0,1,0,1 cloud.csv"),
    ("the points have no values", "-iso 0 a.obj bare.csv"),
    ("-iso is for points in space",
     "-iso 0 a.obj -cols x,y -grid 3,3 -values v.csv cloud.csv")])
def test_refused(refused, words, options):
    given("cloud")
    save("bare.csv", CLOUD)
    refused(re.escape(words), *options.split())


def test_nan_is_refused(tess):
    save("nan.csv", CLOUD, np.r_[FIELD[1:], np.nan], names="x,y,z,v")
    done = tess("-iso", 0, "a.obj", "nan.csv")
    assert done.code == 2 and "nan.csv, line 401: v is NaN: -skip drops" in done.err


@pytest.mark.parametrize("level, words", [
    (7, "-iso 7: there is no such surface; v is from "),
    (0, "a.obj: no surface: all points lie in one plane")])
def test_no_surface_is_told(run, level, words):
    save("f.csv", CLOUD * ((1, 1, 1) if level else (1, 1, 0)), FIELD, names="x,y,z,v")
    assert words in run("-q", "-iso", level, "a.obj", "f.csv").err
