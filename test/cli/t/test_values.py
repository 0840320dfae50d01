"""test_values.py - values that build/tess interpolates, beside what NumPy and SciPy
compute independently; what is refused, and what places are."""
import collections
import random
import re
import shlex
import subprocess

import pytest

from beside import (BOX, METHODS, bent, beyond, by_vtk, chance, flat, grid, lattice,
                    linear, listed, load, nearest, np, same, save, scipy, text, turn)
from common import TOP, limited

r = random.Random(3)
POINTS = "x,y,z,T\n" + "".join("%f,%f,%f,%d\n" % (
    r.random(), r.random(), r.random(), k) for k in range(200))


def columns(text, *numbers, between=" "):
    return "".join(between.join(re.split("[ ,]", line)[k] for k in numbers) + "\n"
                   for line in text.splitlines())


FOUR = "5 3 2 0\n0 0 0 0 1 7\n1 1 0 0 2 7\n2 0 1 0 3 7\n3 0 0 1 4 7\n4 1 1 1 5 7\n"
SINGLE = columns(FOUR[8:], 1, 2, 3, 4, 5)
PLANE = "".join("%d %d 0 %d\n" % (k % 7, k * k % 11, k) for k in range(1, 202))
FILES = {
    "points": POINTS, "bare": columns(POINTS, 0, 1, 2, between=","),
    "flat": columns(POINTS, 0, 1, between=","),
    "notfinite": "0.5 0.5 0.5\n0.1 nan 0.2\n", "word": "0.5 0.5 0.5\n0.1 here 0.2\n",
    "plane": PLANE, "line": "".join("%d %d %d %d\n" % (k % 7, 2 * (k % 7), 3 * (k % 7), k)
                                    for k in range(1, 202)),
    "four.node": FOUR, "hollow": "0,0,0,a\n1,0,0,b\n0,1,0,\n0,0,1,c\n",
    "single": SINGLE, "holes": "".join(
        "%s %d\n" % (line[:-2], k % 2) for k, line in enumerate(
            SINGLE.splitlines(), 1)),
    "four": "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n",
    "far": "0 0 1e308 1\n1 0 0 2\n0 1 0 3\n0 0 -1e308 4\n",
    "unit": "x,y,z,T\n" + "".join("%d,%d,%d,%d\n" % (k % 2, k // 2 % 2, k // 4, k)
                                  for k in range(8)) + "".join(
        "%f,%f,%f,%d\n" % (r.random(), r.random(), r.random(), k)
        for k in range(8, 60)), "empty": ""}


@pytest.fixture
def places(tmp_path):
    """a directory with all these files, and one that is called as a file"""
    for name, lines in FILES.items():
        (tmp_path / name).write_text(lines)
    (tmp_path / "folder.npy").mkdir()
    (tmp_path / "taken.npy").write_text("")
    return tmp_path


# words :: options; G is -grid 2,2,2, V -values v.npy points
REFUSED = r"""
linear, smooth, natural or nearest :: G -method cubic V
linear, smooth, natural or nearest :: G -method '' V
linear, smooth, natural or nearest :: -validate -method linear, points
choose one -method :: G -method linear,smooth V
places are more :: -grid 100000,100000,1000 V
FROM:TO/SIDE$ :: -grid 0:1/.5,0:1/.5,0:1/.5 -step 1,1,1 V
are no blocks of -1 :: -grid 0:1/-1,0:1/.5,2 V
whole numbers from 1 :: -grid 0:1:1.5,2,2 V
Y0 must be less :: -grid 2,1:0:2,2 V
in space: -grid NX,NY :: -plane -grid 2,0:1:2,2 -values v.npy flat
X0 must be less :: -grid 2,2,2,1,0,0,1,0,1 V
Z0 must be less :: -grid 2,2,2,0,1,0,1,.5,.5 V
X0 = -1.7e.308 .* choose less :: V -grid 3,2,2,-1.7e308,1.7e308,0,1,0,1
Y1 = 1.7e.308 .* choose less :: -grid 2,2,2,0,1,-1.7e308,1.7e308,0,1 V
Z0 = -1e.308 .* choose less :: G -values v.npy far
no values :: G -values v.npy bare
no values :: -validate bare
needs -values :: G points
needs -values :: -query bare points
needs places :: V
choose one of them :: G -query bare V
Y0 must be less :: -grid 2,2,0,1,1,0 V
-scale needs three numbers :: -scale 1,2 -validate points
is for points in space :: -cols x,y G V
-cols: points in a plane .* add -grid.*or -validate; for points in :: -cols x,y points
-plane: points in a plane .* add -grid.*or -validate$ :: -plane points
in space, not :: -alpha 1 -grid 2,2 V
there are only 5 points :: -plane -validate four.node
qcols: column 2 twice :: -query flat -qcols 1,2,2 V
no values :: -plane -validate flat
is for -query :: -qcols 1,2,3 G V
for -values or :: -method smooth points
for -values or :: -outside 0 points
for -values or :: -clip points
-by is for -validate :: -by x points
-errors is for -validate :: -errors e.csv points
-by: no column "hole" among 4 :: -validate -by hole points
by: no column "5" among 4 :: -validate -by 5 points
:3: column 4: empty :: -validate -by 4 hollow
no column "7" among 6 :: -validate -by 7 four.node
all points are in one group :: -q -validate -by 5 single
for -values F.csv$ :: -digits 3 points
for -values F.csv$ :: -digits 3 G V
from 1 to 17 :: -digits 0 G -values v.csv points
-outside: .far.: not a number :: -outside far G V
must end in .csv, .npy, .vtu, .vtk or .svg :: G -values v.txt points
is for a -grid :: -query bare -values v.vtk points
is for a -grid :: -query bare -values v.svg points
is of a slice :: G -values v.svg points
is of a slice :: -grid 1,2,1 -values v.svg points
at most 2000 places :: -grid 1,2001,9 -values v.svg points
No such file :: G -values nowhere/v.npy points
folder.npy:  :: G -values folder.npy points
name of two outputs :: G -values v.npy -values ./v.npy points
name of two outputs :: G -values - -volumes - points
overwrite the input :: -volumes ././points points
overwrite the input :: -volumes points ./points
for the table of -validate :: G -values - -validate points
overwrite the places :: -query bare -values v.npy -volumes bare points
No such file :: -query nowhere V
empty: empty :: -query empty V
:2: column 2: .here.: not a number :: -query word V
:2: column 2: .nan.: not a number :: -query notfinite V
qcols: no column "w" :: -query bare -qcols x,y,w V
three columns :: -query bare -qcols x,y,z,T V
both be standard input :: -query - -values v.npy
both be standard input :: -query - -values v.npy -
folds, from 2 on :: -validate 1 points
only 200 points :: -validate 201 points
knows the hull :: -outside nearest -alpha 1 G V
lie on one line :: -q G -values v.npy line
lie on one line :: -q -validate line
lie on one line :: -q -plane -grid 2,2 -values v.npy line
in one plane, where -alpha :: -q -alpha 1 G -values v.npy plane
no tetrahedron is left; choose more folds :: -q -validate 2 four
no tetrahedron is left; choose smaller groups :: -q -validate 2 -by 5 holes
whole numbers :: -grid 0,2,2 V
whole numbers :: -grid 2,-1,2 V
whole numbers :: -grid 2,2,2.5 V
whole numbers :: -grid 1e99,1,1 V
whole numbers :: -grid 99999999999,1,1 V
whole numbers :: -grid 0:1:1.5,2,2 V
needs NX,NY,NZ :: -grid 2 V
needs NX,NY,NZ :: -grid 2,2,2,0 V
needs NX,NY,NZ :: -grid 2,2,2,0,1 V
needs NX,NY,NZ :: -grid 2,2,2,0,1,0,1,0,1,0 V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 2,2:3,2 V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 2,0:1:2,2,2 V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 2:3:2 V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 0:1:2,2, V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 2,0:1,2 V
two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$ :: -grid 0:1:2,,2 V
"[^"]*": not a number :: -grid 0:x:2,2,2 V
"[^"]*": not a number :: -grid 2,0:1:2:3,2 V
"[^"]*": not a number :: -grid 2,0/1:2,2 V
"[^"]*": not a number :: -grid :,2,2 V
"[^"]*": not a number :: -grid 2,0::2,2 V
-grid X0,X1,Y0,Y1,Z0,Z1, where :: -step 20,30,10 -query bare V
says where the blocks begin and end :: -step 20,30,10 -grid 3,3,3 V
says where the blocks begin and end :: -step 20,30,10 -grid 0,99,0,99,0,99,0,1,2 V
are no blocks of :: -step 20,30,10 -grid 1,0,0,1,0,1 V
less than half a block :: -step 20,30,10 -grid 0,9,0,30,0,10 V
places are more than :: -step 1e-3,1e-3,1e-3 -grid 0,960,0,720,0,85 V
needs the sides of a block :: -step 1 -grid 0,9,0,9,0,9 V
needs the sides of a block :: -step 1,2,3,4 -grid 0,9,0,9,0,9 V
needs the sides of a block :: -step 0,1,1 -grid 0,9,0,9,0,9 V
needs the sides of a block :: -step 1,-1,1 -grid 0,9,0,9,0,9 V
needs a length :: -within 0 G V
needs a length :: -within -1 G V
-drop is for -values :: -drop points
-within is for -values :: -within 1 points
-drop is for -values F.csv :: -drop G V
have no values :: -validate -by T -cols x,y,z points
"""
REFUSED = [line.split(" :: ") for line in REFUSED.split("\n") if line]


@pytest.mark.parametrize("words, options", REFUSED, ids=[
    "%s: %s" % (o, w) for w, o in REFUSED])
def test_refused(refused, places, words, options):
    for short, long in ("G", "-grid 2,2,2"), ("V", "-values v.npy points"):
        options = re.sub(r"\b%s\b" % short, long, options)
    refused(words, *shlex.split(options), stdin=POINTS)


def test_partial_file_is_a_directory(tess, places):
    (places / "taken.npy.part").mkdir()
    done = tess("-grid", "2,2,2", "-values", "taken.npy", "points")
    assert done.code == 2 and "taken.npy" in done.err
    assert (places / "taken.npy").read_text() == ""


# the same as counts and then ends, and as -step; each axis for itself
@pytest.mark.parametrize("axes, old", [
    ("0:1:3,-1:1:4,.5:.5:1", "3,4,1,0,1,-1,1,.5,.5"),
    ("0:1/.25,0:1/.5,-1:1/.5", "0,1,0,1,-1,1 -step .25,.5,.5"),
    ("0:1:3,0:2:5", "3,5,0,1,0,2"), ("0:1/.25,0:1/.5", "0,1,0,1 -step .25,.5"),
    ("0:1:3,2,-1:1/.5", "0:1:3,0:1:2,-1:1/.5"), ("2,0:1/.5,3", "0:1:2,0:1/.5,0:1:3")])
def test_axes_of_a_grid(tess, places, axes, old):
    assert tess("-q", "-grid", *old.split(), "-values", "old.csv", "unit").code == 0
    assert tess("-q", "-grid", axes, "-values", "new.csv", "unit").code == 0
    assert (places / "new.csv").read_text() == (places / "old.csv").read_text()


@pytest.mark.parametrize("ending", ["csv", "npy", "vtk"])
def test_gigabytes_are_announced_and_a_full_disk_is_noticed_at_once(program, places,
                                                                    ending):
    name = "big." + ending
    done = limited(program, "-q", "-grid", "1000,1000,200", "-values", name, "points",
                   file=51200)
    assert done.returncode == 2 and not (places / name).exists()
    assert re.search("%s: about [1-9][0-9.]* GB will be written" % name, done.stderr)
    assert name + ": write error" in done.stderr


def test_millions_of_places_take_no_memory_of_their_own(program, places, everything):
    size, room = ("250,200,200", 20000) if everything else ("100,100,200", 14000)
    done = limited(program, "-q", "-grid", size, "-values", "many.npy", "points",
                   memory=room * 1024)
    assert done.returncode == 0, done.stderr
    assert (places / "many.npy").stat().st_size == 128 + 8 * np.prod(
        [int(n) for n in size.split(",")])
    (places / "many.npy").unlink()


def test_many_places_of_a_file_take_no_memory_and_are_as_their_parts(
        tess, program, places, everything):
    chance = random.Random(4)
    lines = "".join("%f %f %f\n" % (chance.random(), chance.random(), chance.random())
                    for k in range(1000))
    times = 1000 if everything else 400
    (places / "some").write_text(times * lines)
    # where the first line might be one, but for the number
    (places / "titled.xyz").write_text("%d\n0 0 0\n" % (1000 * times) + times * lines)
    (places / "piece").write_text(100 * lines)
    done = limited(program, "-q", "-query", "some", "-values", "some.npy", "points",
                   memory=32000 * 1024)
    assert done.returncode == 0, done.stderr
    for name in "titled.xyz", "piece":
        tess("-q", "-query", name, "-values", name + ".npy", "points")
    whole = (places / "some.npy").read_bytes()
    assert (places / "titled.xyz.npy").read_bytes() == whole
    part = (places / "piece.npy").read_bytes()[128:]
    assert whole[128:] == part * (times // 100) and len(part) == 800000
    for name in "some", "some.npy", "titled.xyz", "titled.xyz.npy":
        (places / name).unlink()


def test_places_from_standard_input_and_no_progress(tess, places):
    done = tess("-q", "-query", "-", "-values", "in.csv", "points",
                stdin=FILES["bare"].partition("\n")[2])
    assert done.err == ""
    assert len((places / "in.csv").read_text().splitlines()) == 201


def test_help_has_no_long_line(tess):
    lines = [s for s in tess("-h").out.splitlines() if s[:3] == "  -"]
    assert len(lines) > 30 and max(map(len, lines)) <= 78


# ---- a grid on the points' box: shape, order, values ----

Cloud = collections.namedtuple("Cloud", "p T U TU mesh columns")
GRID = "23,11,17"  # (more than 4096 places)
SIZE = 23, 11, 17


@pytest.fixture(scope="module")
def cloud():
    p = chance(7).random((1000, 3))
    T, U = bent(p), flat(p)
    return Cloud(p, T, U, np.c_[T, U], scipy().spatial.Delaunay(p), (p, T, U))


ROW = np.arange(1000)


def where(cloud, size):
    return grid(cloud.p.min(0), cloud.p.max(0), size)


def test_npy_of_a_grid_is_scipy_s(values, cloud):
    """NaN at the same places; version 1.0, the numbers begin at a multiple of 64"""
    got = values(cloud.columns, "-grid", GRID)
    assert got.shape == (17, 11, 23, 2) and got.dtype == np.float64
    same(got, linear(cloud.mesh, cloud.TU, where(cloud, SIZE)), 1e-12)
    assert 0 < np.isnan(got).sum() < got.size / 2
    with open("v.npy", "rb") as f:
        raw = f.read()
    begin = 10 + raw[8] + 256 * raw[9]
    assert raw[:8] == b"\x93NUMPY\x01\x00" and begin % 64 == 0
    assert len(raw) == begin + 8 * got.size


def test_other_forms_have_the_same_values(run, values, cloud):
    got = values(cloud.columns, "-grid", GRID, "-values", "s.csv", "-values", "s.vtk")
    at = where(cloud, SIZE).reshape(-1, 3)
    names, rows = load("s.csv")
    assert names == ["x", "y", "z", "T", "U"]
    same(rows[:, :3], at, 1e-15)
    same(rows[:, 3:], got.reshape(-1, 2))
    given = text("s.csv")
    assert "-nan" not in given
    # as each alone; to standard output, and nothing else
    for end in "csv", "npy", "vtk":
        run("-q", "-grid", GRID, "-values", "g." + end, "points.csv")
        with open("g." + end, "rb") as f, open(
                ("v." if end == "npy" else "s.") + end, "rb") as g:
            assert f.read() == g.read() != b""
    done = run("-grid", GRID, "-values", "-", "points.csv")
    assert done.out == given and "triangles" in done.err
    # -digits is of values, and not of coordinates
    run("-q", "-grid", GRID, "-digits", 4, "-values", "d.csv", "points.csv")
    rounded = load("d.csv")[1]
    same(rounded[:, :3], rows[:, :3])
    same(rounded[:, 3:], np.array([["%.4g" % a for a in r] for r in rows[:, 3:]],
                                  float))


def test_picture_leaves_other_files_as_they_are(run, cloud):
    save("points.csv", *cloud.columns)
    made = []
    for more in [], ["-values", "s.svg"]:
        run("-q", "-alpha", ".2", "-grid", "20,30,1", *more, "-values", "s.csv",
            "points.csv")
        made.append(text("s.csv"))
    assert made[0] == made[1] and "nan" in made[0]


def test_vtk_of_a_grid_read_by_vtk(run, values, cloud):
    got = values(cloud.columns, "-grid", GRID, "-values", "g.vtk").reshape(-1, 2)
    data = by_vtk("g.vtk")
    same(data.points, where(cloud, SIZE).reshape(-1, 3), 1e-15)
    assert list(data.values) == ["T", "U"]
    same(np.transpose(list(data.values.values())), got)
    # one column
    run("-q", "-cols", "x,y,z,U", "-grid", GRID, "-values", "u.vtk", "points.csv")
    same(by_vtk("u.vtk").values["U"], got[:, 1])


@pytest.mark.parametrize("kind, size", [
    (12, SIZE), (9, (9, 7, 1)), (9, (9, 1, 7)), (9, (1, 9, 7)), (3, (1, 1, 5)),
    (3, (5, 1, 1)), (1, (1, 1, 1))])
def test_vtu_of_a_grid_read_by_others(values, cloud, kind, size):
    """corners in their order: once around, then above; along the axes that the
    grid has"""
    got = values(cloud.columns, "-grid", listed(size), "-values", "g.vtu").reshape(-1, 2)
    step = np.ptp(cloud.p, 0) / np.maximum(np.array(size) - 1, 1) * (np.array(size) > 1)
    axes = [k for k in range(3) if size[k] > 1]
    corner = np.zeros((2 ** len(axes), 3))
    corner[:, axes] = BOX[[0, 1, 3, 2, 4, 5, 7, 6]][:2 ** len(axes), :len(axes)]

    def check(points, cells, arrays):
        same(points, where(cloud, size).reshape(-1, 3), 1e-15)
        same(np.transpose([np.ravel(a) for a in arrays]), got)
        assert len(cells) == np.prod(np.maximum(np.array(size) - 1, 1))
        same(points[cells] - points[cells][:, :1],
             np.tile(corner * step, (len(cells), 1, 1)), 1e-15)

    data = by_vtk("g.vtu")
    check(data.points, data.cells, data.values.values())
    assert set(data.kinds) == {kind}
    meshio = pytest.importorskip("meshio")
    m = meshio.read("g.vtu")
    assert [c.type for c in m.cells] == [
        {12: "hexahedron", 9: "quad", 3: "line", 1: "vertex"}[kind]]
    check(m.points, m.cells[0].data, m.point_data.values())


# (so many that they are kept in a file)
@pytest.mark.parametrize("columns, many", [("x,y,z,T,U", 100), ("x,y,z,U", 140000)])
def test_vtu_of_places_read_by_vtk(values, cloud, columns, many):
    q = chance(8).random((many, 3)) * 1.2
    got = values(cloud.columns, "-cols", columns, "-values", "g.vtu", at=q)
    data = by_vtk("g.vtu")
    same(data.points, q)
    assert list(data.values) == columns[6:].split(",")
    same(np.transpose(list(data.values.values())), got)
    assert len(data.kinds) == many and set(data.kinds) == {1}


def test_make_grid(values):
    for name in "mirror.vtk", "mirror.svg":
        if (TOP / "build" / name).exists():
            (TOP / "build" / name).unlink()
    assert subprocess.run(["make", "grid"], cwd=TOP, capture_output=True).returncode == 0
    assert b"DIMENSIONS 200 200 20" in (TOP / "build/mirror.vtk").read_bytes()
    assert b"</svg>" in (TOP / "build/mirror.svg").read_bytes()
    name = str(TOP / "test/data/mirror.xyz")
    got = values(name, "-alpha", "0.55", "-method", "smooth", "-grid", "200,200,20")
    data, p = by_vtk(str(TOP / "build" / "mirror.vtk")), np.loadtxt(name)[:, :3]
    same(data.points, grid(p.min(0), p.max(0), (200, 200, 20)).reshape(-1, 3), 1e-14)
    same(data.values["temperature in degrees C"], got.ravel())
    assert 100000 < np.isnan(got).sum() < 700000


BOXED = .2, .7, .3, .4, .1, .9


@pytest.mark.parametrize("box, size", [
    ((), (1, 1, 1)), ((), (9, 7, 1)), (BOXED, (5, 6, 7)), (BOXED[:4] + (.6, .6), (5, 6, 1)),
    (BOXED, (1, 1, 3000)), (BOXED, (9000, 2, 1))], ids=[
        "one place", "slice", "box", "slice of a box", "line in z", "row of many"])
def test_places_of_a_grid(values, cloud, box, size):
    """one place is in the middle, or where it is said"""
    got = values(cloud.columns, "-grid", listed(size + box))
    b = np.array(box or np.c_[cloud.p.min(0), cloud.p.max(0)].ravel())
    assert got.shape == size[::-1] + (2,)
    same(got, linear(cloud.mesh, cloud.TU, grid(b[::2], b[1::2], size)), 1e-12)


# ---- places of a file ----

@pytest.mark.parametrize("order", ["none", "plane", "line", "twice", "sorted"])
def test_places_of_a_file(values, cloud, order):
    q = chance(9).random((1500, 3)) * 1.2 - 0.1
    q = {"none": q, "plane": q * (1, 1, 0) + (0, 0, .5), "line": q * (1, 0, 0) + .5,
         "twice": np.vstack((q, q[::-1])), "sorted": q[np.lexsort(
             (np.floor(9 * q[:, 0]), np.floor(9 * q[:, 1])))]}[order]
    with open("places.csv", "w") as f:
        f.write("id,note,depth,lon,lat\n" + "".join(
            "%d,a,%.17g,%.17g,%.17g\n" % (i, x[2], x[0], x[1])
            for i, x in enumerate(q)))
    want = linear(cloud.mesh, cloud.TU, q)
    same(values(cloud.columns, "-query", "places.csv", "-qcols", "lon,lat,depth"), want,
         1e-12)
    got = values("points.csv", "-query", "places.csv", "-qcols", "4,5,3", "-values",
                 "q.csv")
    with open("q.csv") as f:
        assert f.readline() == "x,y,z,id,note,T,U\n"
        rows = np.array([line.split(",") for line in f])
    same(rows[:, :3].astype(float), q)
    same(rows[:, 5:].astype(float), got)


# ---- points in a plane ----

Plane = collections.namedtuple("Plane", "f V VW columns x want out")


@pytest.fixture(scope="module")
def plane():
    """800 points, places for them, what is linear there, which are outside"""
    random = chance(10)
    f = random.random((800, 2)) * (360, 180) - (180, 90)
    V = np.sin(f[:, 0] / 20) * np.cos(f[:, 1] / 15)
    VW = np.c_[V, 3 + 2 * f[:, 0] - f[:, 1] / 2]
    x = random.random((1500, 2)) * (400, 200) - (200, 100)
    want = linear(f, VW, x)
    return Plane(f, V, VW, (f, VW), x, want, np.isnan(want[:, 0]))


def in_plane(columns, name="points.csv"):
    return save(name, *columns, names="lon,lat,temp,w")


@pytest.mark.parametrize("options", ["-cols lon,lat,temp", "-cols lon,lat", ""])
def test_grid_in_a_plane(values, plane, options):
    """in all forms; a picture has x to the right, y upwards, nothing of z"""
    name = in_plane(plane.columns)
    x = grid(plane.f.min(0), plane.f.max(0), (40, 30))
    n = 1 if "temp" in options else 2
    got = values(name, *options.split(), "-grid", "40,30", "-values", "f.csv", "-values",
                 "f.vtk", "-values", "f.svg")
    assert got.shape == (30, 40, n)
    same(got, linear(plane.f, plane.VW, x)[..., :n], 1e-12)
    names, rows = load("f.csv")
    assert names == ["lon", "lat", "temp", "w"][:2 + n]
    same(rows[:, :2], x.reshape(-1, 2), 1e-13)
    same(rows[:, 2:], got.reshape(-1, n))
    svg = text("f.svg")
    assert ">lon<" in svg and ">lat<" in svg and "z = " not in svg
    data = by_vtk("f.vtk")
    same(data.points[:, :2], x.reshape(-1, 2), 1e-12)
    same(data.values[names[-1]], got[..., -1].ravel())


def test_box_and_scale_in_a_plane(values, plane):
    name = in_plane(plane.columns)
    same(values(name, "-cols", "lon,lat,temp", "-grid", "5,7,-20,20,-30,40")[..., 0],
         linear(plane.f, plane.V, grid((-20, -30), (20, 40), (5, 7))), 1e-12)
    same(values(name, "-scale", "1,5", "-grid", "40,30"),
         linear(plane.f * (1, 5), plane.VW, grid(
             plane.f.min(0), plane.f.max(0), (40, 30)) * (1, 5)), 1e-12)


def voronoi(points):
    """Of each Voronoi cell the area or volume, NaN if it has no end; and of the last
    one the neighbours."""
    v = scipy().spatial.Voronoi(points)
    size = np.zeros(len(points))
    for pair, corners in zip(v.ridge_points, v.ridge_vertices):
        q = v.vertices[corners]
        side = np.linalg.norm(q[1] - q[0] if len(q[0]) == 2 else np.cross(
            q[1:-1] - q[0], q[2:] - q[0]).sum(0) / 2) if -1 not in corners else np.nan
        size[pair] += side * np.linalg.norm(points[pair[0]] - points[pair[1]]) / (
            2 * len(q[0]))
    last = len(points) - 1
    return size, [k for pair in v.ridge_points if last in pair for k in pair if k < last]


def sibson(points, data, places):
    """natural neighbours by their definition: what the place's cell takes from the
    others'"""
    before, found = voronoi(points)[0], []
    for x in places:
        after, beside = voronoi(np.vstack((points, x)))
        assert len(beside) > 3
        found.append((before - after[:-1])[beside] @ data[beside] / after[-1])
    return np.array(found)


def by_slopes(p, v, q):
    """-method smooth, as the recipe tr_slopes says; in a plane a side of two
    triangles counts 4 times, and two points far off it, which have the first one's
    value, add to the diagonal alone."""
    n, d = p.shape
    mesh, often = scipy().spatial.Delaunay(p), np.ones(n)
    often[0] += 2 * (d == 2)
    far = np.sqrt(often)[:, None]
    g = np.linalg.lstsq(far * np.c_[p, np.ones(n)], far[:, 0] * v, rcond=None)[0][:d]
    g = np.tile(g, (n, 1))
    sides = np.vstack([mesh.simplices[:, [k, j]] for k in range(d + 1) for j in range(k)])
    a, c = np.vstack((sides, sides[:, ::-1])).T
    e = p[c] - p[a]
    w = (4 - d) / (e ** 2).sum(1)
    m = np.zeros((n, d, d))
    np.add.at(m, a, w[:, None, None] * e[:, :, None] * e[:, None, :])
    size = np.trace(m, axis1=1, axis2=2) + 2 * (d == 2) * np.bincount(
        mesh.simplices.ravel(), minlength=n)
    m += 1e-4 * size[:, None, None] * np.eye(d)
    for k in range(4):
        s = (g[a] * e).sum(1)
        if k > 0:
            s = (s + (g[c] * e).sum(1)) / 2
        r = np.zeros(p.shape)
        np.add.at(r, a, (w * (v[c] - v[a] - s))[:, None] * e)
        g = g + (1.8 if k else 1) * np.linalg.solve(m, r[:, :, None])[:, :, 0]
    t = mesh.find_simplex(q)
    u = np.einsum("ijk,ik->ij", mesh.transform[t, :d], q - mesh.transform[t, d])
    u, i = np.c_[u, 1 - u.sum(1)], mesh.simplices[t]
    return (u * (v[i] + ((q[:, None] - p[i]) * g[i]).sum(2) / 2)).sum(1)


@pytest.mark.parametrize("method", METHODS)
def test_methods_in_a_plane(values, plane, method):
    name = in_plane(plane.columns)
    got = values(name, "-cols", "lon,lat,temp,w", "-method", method, "-values", "f.csv",
                 "-query", save("lonlat.csv", plane.x, names="lon,lat"))
    same(load("f.csv")[1], np.c_[plane.x, got])
    assert plane.out.sum() > 100
    inner = np.flatnonzero((np.abs(plane.x) < (150, 70)).all(1))
    if method == "nearest":
        same(got, np.where(plane.out[:, None], np.nan, nearest(
            plane.f, plane.VW, plane.x)))
    else:
        same(got[:, 1], plane.want[:, 1], 1e-11)
        assert (np.isnan(got[:, 0]) == plane.out).all()
    if method == "linear":
        same(got, plane.want, 1e-12)
    if method == "natural":
        same(got[inner[:9], 0], sibson(plane.f, plane.V, plane.x[inner[:9]]), 1e-9)
    if method == "smooth":
        same(got[inner, 0], by_slopes(plane.f, plane.V, plane.x[inner]), 1e-9)
    # at the points themselves
    same(values(name, "-plane", "-method", method, "-query", name), plane.VW)


def test_places_of_two_numbers_in_a_plane_are_told(values, plane):
    """as a mesh in space of the same columns would not be"""
    save("lonlat.csv", plane.x, names="lon,lat")
    same(values(in_plane((plane.f, plane.V)), "-cols", "lon,lat,temp", "-query",
                "lonlat.csv"), plane.want[:, :1], 1e-12)
    assert "in a plane" in values.err


@pytest.mark.parametrize("twins", [0, 1])
def test_points_of_one_place_in_a_plane_have_their_mean(values, plane, twins):
    f = np.vstack((plane.f, plane.f[::7][:twins * 999]))
    v = np.concatenate((plane.V, plane.V[::7] + 1))[:len(f)]
    save("lonlat.csv", plane.x, names="lon,lat")
    got = values(save("twins.csv", f, v, names="x,y,v"), "-plane", "-outside", "nearest",
                 "-query", "lonlat.csv")[:, 0]
    assert not np.isnan(got).any()
    want = linear(plane.f, plane.V + (np.arange(800) % 7 == 0) * twins / 2, plane.x)
    same(np.where(plane.out, np.nan, got), want, 1e-12)


def test_outside_in_a_plane_is_the_hull_s_nearest_point(values, plane):
    h = plane.f[scipy().spatial.ConvexHull(plane.f).vertices]
    side, x = np.roll(h, -1, 0) - h, plane.x
    s = np.clip(((x[:, None] - h) * side).sum(2) / (side ** 2).sum(1), 0, 1)
    foot = h + s[..., None] * side
    foot = foot[np.arange(len(x)), ((foot - x[:, None]) ** 2).sum(2).argmin(1)]
    got = values(in_plane(plane.columns), "-plane", "-outside", "nearest", "-query",
                 save("lonlat.csv", x, names="lon,lat"))[plane.out, 1]
    same(got, (3 + 2 * foot[:, 0] - foot[:, 1] / 2)[plane.out], 1e-10)


# a plane of space: askew to the axes, and along each
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("frame", ["askew", "z", "y", "x"])
def test_plane_in_space(values, frame, method):
    axes = {"askew": turn(11)[:2], "z": np.eye(3)[:2], "y": np.eye(3)[::2],
            "x": np.eye(3)[1:]}[frame]
    u, y = chance(12).random((500, 2)), chance(13).random((800, 2)) * 1.2 - .1
    v = bent(np.c_[u, u[:, :1]])
    got = values((u @ axes + (3, 4, 5), v), "-method", method,
                 at=y @ axes + (3, 4, 5))[:, 0]
    assert "lie in one plane" in values.err
    want = linear(u, v, y)
    assert (np.isnan(got) == np.isnan(want)).all()
    if method == "linear":
        same(got, want, 1e-12)
    if method == "nearest":
        same(got, np.where(np.isnan(want), np.nan, nearest(u, v, y)))


def test_thin_layer_is_no_plane(values):
    u = chance(12).random((500, 2))
    values((np.c_[u, 1e-9 * chance(14).random(500)] + (0, 0, 1), u[:, 0]), "-grid",
           "9,9,1")
    assert "lie in one plane" not in values.err


# ---- the methods ----

@pytest.mark.parametrize("method", METHODS)
def test_methods(values, cloud, method):
    """a linear field comes out as it is; NaN outside of the hull; at the points their
    values, exactly"""
    q = chance(15).random((800, 3)) * 1.2 - 0.1
    out = beyond(cloud.mesh, q)
    got = values(cloud.columns, "-method", method, at=q)
    assert 100 < out.sum() < 700 and (np.isnan(got[:, 0]) == out).all()
    if method == "nearest":
        same(got, np.where(out[:, None], np.nan, nearest(cloud.p, cloud.TU, q)))
    else:
        same(got[:, 1], np.where(out, np.nan, flat(q)), 1e-12)
    if method == "linear":
        same(got, linear(cloud.mesh, cloud.TU, q), 1e-12)
    if method == "smooth":
        same(got[~out, 0], by_slopes(cloud.p, cloud.T, q[~out]), 1e-12)
    same(values("points.csv", "-method", method, "-query", "points.csv"), cloud.TU)


@pytest.mark.parametrize("method", METHODS[:3])
def test_lattice_where_all_places_lie_on_facets_and_edges(values, method):
    p = lattice(5)
    same(values((p, flat(p)), "-method", method, "-grid", "9,9,9")[..., 0],
         flat(grid((0, 0, 0), (4, 4, 4), (9, 9, 9))), 1e-12)


@pytest.mark.parametrize("method", METHODS)
def test_units_beyond_the_range_of_numbers(values, method):
    """where double precision does not locate"""
    p, q = chance(16).random((300, 3)), chance(17).random((200, 3))
    v = np.c_[bent(p), flat(p)]
    one = values((p, v), "-method", method, at=q)
    for power in -1000, -345, -340, 340, 1000:
        same(values((p * 2.0 ** power, v), "-method", method, at=q * 2.0 ** power), one,
             1e-12)
    for power in -1000, 1010:
        same(np.ldexp(values((p, np.ldexp(v, power)), "-method", method, at=q), -power),
             one, 1e-12)


def test_needles(values, cloud):
    p = cloud.p
    got = values((p * (1, 1e-6, 1e-12), flat(p)), "-grid", "21,21,21")[..., 0]
    at = flat(where(cloud, (21, 21, 21)))
    same(got, np.where(np.isnan(got), np.nan, at), 1e-11)
    assert np.isnan(got).sum() < 6000


def test_turned_lattice_where_places_are_in_facets_but_for_rounding(values):
    p, at = lattice(5), grid((0, 0, 0), (4, 4, 4), (17, 17, 17)).reshape(-1, 3)
    same(values((p @ turn(18), flat(p)), "-outside", "nearest", at=at @ turn(18))[:, 0],
         flat(at), 1e-12)


def test_quadratic_field(values):
    """smooth has a seventh of linear's error"""
    def square(x):
        x, y, z = np.moveaxis(x, -1, 0)
        return x ** 2 - 2 * y ** 2 + z ** 2 / 2 + x * y

    p = chance(19).random((2000, 3))
    save("square.csv", p, square(p))
    want = square(grid([.15] * 3, [.85] * 3, (15, 15, 15)))
    linear, smooth, natural, nearest = [np.sqrt(np.mean((values(
        "square.csv", "-method", m, "-grid", "15,15,15,.15,.85,.15,.85,.15,.85"
        )[..., 0] - want) ** 2)) for m in METHODS]
    assert smooth < linear / 7 and natural < 2 * linear < nearest


def test_natural_is_sibson_s(values):
    p, v = chance(21).random((150, 3)), chance(22).random(150)
    q = .4 + 0.2 * chance(23).random((6, 3))
    same(values((p, v), "-method", "natural", at=q)[:, 0], sibson(p, v, q), 1e-9)


# ---- stretched points, alpha shapes ----

def test_scale_is_of_the_mesh_and_places_are_as_given(values, cloud):
    p = cloud.p * (1, 1, 1000)
    values((p, flat(p), cloud.T), "-scale", "1,1,.001", "-grid", GRID, "-values", "f.csv")
    at = grid(p.min(0), p.max(0), SIZE).reshape(-1, 3)
    rows = load("f.csv")[1]
    same(rows[:, :3], at, 1e-12)
    want = linear(cloud.mesh, cloud.T, at * (1, 1, .001))
    same(rows[:, 4], want, 1e-11)
    same(rows[:, 3], np.where(np.isnan(want), np.nan, flat(at)), 1e-10)


def test_alpha_is_nan_in_tetrahedra_of_a_larger_circumradius(values):
    p = chance(24).random((2000, 3))
    p = p[np.linalg.norm(p - .5, axis=1) > .3]
    d = scipy().spatial.Delaunay(p)
    v = p[d.simplices]
    e = v[:, 1:] - v[:, :1]
    radius = np.linalg.norm(np.linalg.solve(e, (e ** 2).sum(2)[..., None] / 2),
                            axis=(1, 2))
    at = grid([.1] * 3, [.9] * 3, (21, 21, 21))
    t = d.find_simplex(at)
    want = np.where((t >= 0) & (radius[t] <= .12), flat(at), np.nan)
    same(values((p, flat(p)), "-alpha", ".12", "-grid",
                "21,21,21,.1,.9,.1,.9,.1,.9")[..., 0], want, 1e-12)
    assert 1000 < np.isnan(want).sum() < 4000


# ---- outside ----

@pytest.fixture
def cube(cloud):
    """a cube with its corners, and points in it"""
    p = np.vstack((BOX, cloud.p))
    return p, np.c_[flat(p), bent(p)]


@pytest.mark.parametrize("method", METHODS)
def test_outside(values, cube, method):
    q = chance(25).random((800, 3)) * 3 - 1
    inside = np.clip(q, 0, 1)
    got = values(cube, "-method", method, "-outside", "nearest", at=q)
    if method == "nearest":
        same(got, nearest(*cube, q))
    else:  # (the value at the hull's nearest point)
        same(got[:, 0], flat(inside), 1e-12)
        same(got, values(cube, "-method", method, at=inside), 1e-12)
    got = values(cube, "-method", method, "-outside", -99.5, at=q)[:, 0]
    assert ((got == -99.5) == np.any(inside != q, axis=1)).all()


@pytest.mark.parametrize("method", METHODS)
def test_inside_or_outside_to_the_last_bit(values, cube, method):
    """A place on the hull is inside, and up to four last places of the largest
    coordinate beside it; one that is farther out is not."""
    ulp = 2.0 ** -52
    at = np.array([[1, .3, .6], [1 + ulp, .3, .6], [1 - ulp, .3, .6], [.2, 0, .7],
                   [.2, -1e-300, .7], [.2, 1e-300, .7], [.5, .5, 1],
                   [.5, .5, 1 + 3 * ulp], [0, 0, 0], [-1e-300, 0, 0], [1, 1, .5],
                   [1, 1 + 3 * ulp, .5], [1 + 5 * ulp, .3, .6], [.2, -5 * ulp, .7],
                   [.5, .5, 1 + 5 * ulp], [1, 1 + 5 * ulp, .5], [.2, -3 * ulp, .7]])
    got = values(cube, "-method", method, at=at)[:, 0]
    assert list(np.isnan(got)) == list(
        np.any(np.abs(np.clip(at, 0, 1) - at) > 4 * ulp, axis=1))


@pytest.mark.parametrize("method", METHODS)
def test_inside_or_outside_where_the_hull_is_flat(values, method):
    """where its tetrahedra are as flat as rounding leaves them: points of a slanted
    lattice next to one of its faces; all numbers are exact"""
    slant, tiny = np.array([[1, 2, 1], [2, 1, 3], [1, 3, 2]]), 2.0 ** -49
    p = lattice(4)
    sunk = (p[:, 2] == 0) & np.all((p[:, :2] > 0) & (p[:, :2] < 3), axis=1)
    p[sunk, 2] = tiny * chance(26).integers(1, 3, sunk.sum())
    at = np.concatenate([grid((.25, .25, z), (2.75, 2.75, z), (11, 11, 1))
                         .reshape(-1, 3) for z in (0, -tiny, tiny, -64 * tiny)])
    got = values((p @ slant, flat(p)), "-method", method, at=at @ slant)[:, 0]
    assert list(np.isnan(got)) == list(at[:, 2] < -tiny)


@pytest.mark.parametrize("scale, shift, methods", [
    (1, 0, METHODS), (1e-200, 0, METHODS[:1]), (1e200, 0, METHODS[:1]),
    (100, (5e5, 5e6, -5), METHODS)], ids=["at the origin", "tiny", "huge", "far"])
def test_places_on_the_hull_have_values_however_they_are_rounded(
        values, scale, shift, methods):
    """and others have not"""
    random = chance(27)
    p = np.vstack((random.random((50, 3)), BOX)) @ turn(28) * scale + np.array(shift)
    most = np.abs(p).max()
    save("turned.csv", p, p[:, 0] / most)
    hull = scipy().spatial.ConvexHull((p - p.mean(0)) / scale)
    a, b, c = (p[hull.simplices[:, k]] for k in range(3))
    on = np.vstack([a + u * (b - a) + v * (c - a) for u, v in
                    random.dirichlet((1, 1, 1), 40)[:, :2]] + [a, (a + b) / 2])
    away = on + np.vstack([hull.equations[:, :3]] * 42) * 50 * 2.0 ** -52 * most
    for method in methods:
        got = values("turned.csv", "-q", "-method", method, at=on)[:, 0]
        assert not np.isnan(got).any()
        if method == "linear":
            same(got, on[:, 0] / most, 1e-9)
        assert np.isnan(values("turned.csv", "-q", "-method", method, at=away)).all()
        assert "have no value" in values.err


# ---- many columns, duplicates, what is no number ----

@pytest.mark.parametrize("method", METHODS[:3])
def test_forty_columns(values, cloud, method):
    save("many.txt", cloud.p, cloud.U[:, None] * np.arange(40), names="", between=" ")
    at = flat(grid([.2] * 3, [.8] * 3, (15, 15, 15)))
    same(values("many.txt", "-method", method, "-grid", "15,15,15,.2,.8,.2,.8,.2,.8"),
         at[..., None] * np.arange(40), 1e-11)


def test_duplicates_have_the_mean_of_their_values(values, cloud):
    p, T = cloud.p, cloud.T
    twice = np.vstack((p, p[:100], p[:50]))
    got = values((twice, np.concatenate((T, T[:100] + 3, T[:50] + 6))), "-query",
                 "points.csv")[:, 0]
    assert "150 of the points" in values.err
    means = np.concatenate((T[:50] + 3, T[50:100] + 1.5, T[100:]))
    same(got, np.concatenate((means, means[:100], means[:50])), 1e-12)
    # of the same values there is nothing to say
    values((twice, np.concatenate((T, T[:100], T[:50]))), "-grid", "5,5,5")
    assert "duplicate" not in values.err and "mean" not in values.err


def test_nan_among_the_values(tess, values, cloud):
    """its line is named; -skip drops it, and counts; in a column that is not asked for
    it is not seen"""
    p, TU, keep = cloud.p, cloud.TU, ROW != 70
    save("hole.csv", p, np.where(keep, cloud.T, np.nan), cloud.U)
    for options in "-query hole.csv -values h.npy", "-validate":
        done = tess("-q", *options.split(), "hole.csv")
        assert done.code == 2 and done.err.splitlines()[-1].startswith(
            "tess: hole.csv, line 72: T is NaN: -skip ")
    got = values("hole.csv", "-skip", at=p)
    assert re.search("1 row.* dropped", values.err)
    same(got[keep], TU[keep])
    same(got[70:71], linear(p[keep], TU[keep], p[70:71]), 1e-12)
    same(values("hole.csv", "-cols", "x,y,z,U", at=p)[:, 0], cloud.U)


def test_infinite_value_is_told_and_others_are_as_they_are(values, cloud):
    keep = ROW != 70
    got = values((cloud.p, np.where(keep, cloud.T, np.inf), cloud.U), at=cloud.p)
    assert "1 value is not finite" in values.err
    same(got[keep], cloud.TU[keep])


def test_nodata_is_as_without_these_rows(values, cloud):
    void = chance(29).permutation(1000)[:70]
    codes = cloud.T.copy()
    codes[void] = -9999
    q = chance(30).random((500, 3))
    got = values((cloud.p, codes), "-nodata", -9999, at=q)[:, 0]
    assert "70 rows dropped" in values.err and "far from" not in values.err
    rest = np.delete(ROW, void)
    same(got, linear(cloud.p[rest], cloud.T[rest], q), 1e-12)


@pytest.mark.parametrize("told, column", [
    ("70 values of T are -9999, far from", lambda T: np.where(ROW % 14 == 0, -9999, T)[:980]),
    ("1 value of T is 999, far from", lambda T: np.where(ROW == 7, 999, 99 * T)),
    ("-nodata " + repr(float(np.float32(1e20))),
     lambda T: np.where(ROW < 2, np.float32(1e20), T)),
    ("-nodata -50.1", lambda T: np.where(ROW < 2, -50.1, T)),
    ("", lambda T: np.where(ROW == 7, -50.1, T)), ("", lambda T: T), ("", lambda T: 0 * T),
    ("", lambda T: np.round(chance(31).random(1000))),
    ("", lambda T: np.exp(5 * chance(32).standard_normal(1000)))], ids=[
        "frequent", "nines", "huge", "others", "once", "none", "one value", "two values",
        "its own tail"])
def test_values_far_from_all_others_are_told(values, cloud, told, column):
    v = column(cloud.T)
    values((cloud.p[:len(v)], v), "-grid", "2,2,2")
    assert told in values.err if told else "far from" not in values.err


@pytest.mark.parametrize("method", ["linear", "natural", "nearest"])
def test_no_value_is_beyond_the_data_by_a_rounding(tess, tmp_path, method):
    chance = random.Random(5)
    for value in 0.025, 0.1, 1e300, -7.3e-5:
        (tmp_path / "f.csv").write_text("x,y,z,v\n" + "".join(
            "%r,%r,%r,%r\n" % (*(chance.random() for _ in range(3)), value)
            for _ in range(60)))
        done = tess("-q", "-method", method, "-outside", "nearest",
                    "-grid", "9,9,9", "-values", "-", "f.csv")
        got = {float(line.split(",")[3]) for line in done.out.splitlines()[1:]}
        assert got == {value}
