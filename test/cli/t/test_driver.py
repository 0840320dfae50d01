"""test_driver.py - build/tess's command line, the meshes that it writes, large
sets."""
import os
import random
import re
import subprocess

import pytest

import beside
from common import TOP, build_tess, limited
from samples import P

PLAIN = "".join("%g,%g,%g,%d\n" % (*p, 10 * k) for k, p in enumerate(P))
NODE = "5 3 0 0\n" + "".join("%d %g %g %g\n" % (k, *p) for k, p in enumerate(P))
NUMBERS = "".join("%d %g %g %g %d\n" % (k, *p, 10 * k - 10)
                  for k, p in enumerate(P, 1))
NUMBERED = "5 3 2 0\n" + "".join("%d %g %g %g %d %d\n" % (k, *p, k + 1, 10 * k)
                                 for k, p in enumerate(P))
CUBE = "9 3 0 0\n1 .5 .5 .5\n" + "".join("%d %d %d %d\n" % (
    k + 2, k % 2, k // 2 % 2, k // 4) for k in range(8))
FLAT = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"


@pytest.fixture
def given(tmp_path):
    """given(name=text, ...) writes files NAME, or by a dictionary"""
    def write(files=(), **more):
        for name, text in dict(files, **more).items():
            (tmp_path / name).write_text(text)
    return write


def make(*words, **more):
    return subprocess.run(["make", *words], cwd=TOP, capture_output=True, text=True,
                          **more)


def text(name):
    with open(name, encoding="latin-1") as f:
        return f.read()


def same(a, b):
    assert text(a) == text(b) != ""


# ---- what is written, make run ----

def test_o_is_four_files(tess, given):
    given({"none.node": NODE})
    tess("-q", "-o", "base", "none.node")
    for end in "node", "ele", "neigh", "vtk":
        assert os.path.getsize("base." + end) > 0


def test_make_run_and_grid(tmp_path, given):
    build, here = TOP / "build", os.path.relpath(tmp_path, TOP)
    given({"x.csv": PLAIN, "x.xyz": PLAIN, "numbers.txt": NUMBERS, "flat": FLAT})
    made = ["x.csv.svg", "x.xyz.svg", "stdin.svg", "flat.vtk", "numbers.txt.grid.svg"]
    for name in made:
        if (build / name).exists():
            (build / name).unlink()
    for name in "x.csv", "x.xyz", "flat":
        assert make("run", "POINTS=%s/%s" % (here, name)).returncode == 0
    make("run", "POINTS=-", input=PLAIN)
    make("run", "POINTS=%s/numbers.txt" % here,
         "OPTIONS=-cols 2,3,4 -node %s/run.node" % here)
    assert text("run.node") == NUMBERED
    make("grid", "POINTS=%s/numbers.txt" % here, "OPTIONS=-cols 2,3,4,5")
    # (names that do not collide)
    for name in made:
        assert (build / name).stat().st_size > 0, name
    assert b"ORIGIN 0 0 -2" in (build / "numbers.txt.grid.vtk").read_bytes()[:200]
    for path in build.iterdir():
        if re.match(r"(x\.csv|x\.xyz|stdin|flat|numbers\.txt)\.", path.name):
            path.unlink()


# ---- the command line ----

def test_help_names_the_options(tess):
    help_ = tess("-h").out
    assert help_ == tess("--help").out
    for option in "cols skip nodata decimal scale box periodic cells volumes faces " \
            "alpha clip by errors q".split():
        assert "\n  -%s " % option in help_


def test_version_is_the_library_s(tess):
    number = re.search(r"(?m)^#define TESS_VERSION (\d*)0(\d)00L",
                       text(TOP / "tess.h"))
    assert tess("--version").out == "tess %s.%s\n" % number.groups()


def test_unknown_option_and_one_without_its_argument(tess):
    assert tess("-none").code == 2
    done = tess("-box")
    assert done.code == 2 and "-box needs X0,X1,Y0,Y1,Z0,Z1" in done.err


# ---- the hull ----

def test_face_of_a_cube_is_twelve_triangles(tess, given):
    """as OBJ and as TetGen's .face, on edges that are there in both directions, of
    the volume 1; numbers in .face as in .node"""
    given({"cube.node": CUBE})
    tess("-q", "-face", "cube.obj", "cube.node")
    tess("-q", "-face", "cube.face", "-node", "c.node", "cube.node")
    lines = [line.split() for line in text("cube.obj").splitlines()]
    p = [tuple(float(x) for x in w[1:]) for w in lines if w[:1] == ["v"]]
    faces = [[int(k) - 1 for k in w[1:]] for w in lines if w[:1] == ["f"]]
    edges = [(f[k], f[(k + 1) % 3]) for f in faces for k in range(3)]
    assert len(p) == 8 and len(faces) == 12 and len(set(edges)) == 36
    assert all((b, a) in edges for a, b in edges)
    corners = [[p[k] for k in f] for f in faces]
    assert sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (
        b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        for a, b, c in corners) == 6
    node = {w[0]: tuple(float(x) for x in w[1:]) for w in (
        line.split() for line in text("c.node").splitlines()[1:])}
    head, *rows = [line.split() for line in text("cube.face").splitlines()
                   if line[0] != "#"]
    assert head == ["12", "0"] and [int(w[0]) for w in rows] == list(range(1, 13))
    assert [[node[k] for k in w[1:4]] for w in rows] == corners


def test_face_of_points_in_a_plane_is_none(tess):
    tess("-q", "-face", "flat.face", "-", stdin=FLAT)
    assert text("flat.face") == "0 0\n"


@pytest.mark.parametrize("points, option, why", [
    (FLAT, [], "lie in one plane"),
    ("".join("%d %d %d\n" % (k, 2 * k, 3 * k) for k in range(9)), [],
     "lie on one line"),
    ("1 2 3\n1 2 3\n", [], "at most one distinct point"),
    (CUBE, ["-alpha", "0.001"], "-alpha leaves no")], ids=[
        "flat", "straight", "alone", "-alpha"])
def test_no_tetrahedron_no_picture_of_any_all_else(tess, given, points, option, why):
    given(points=points)
    done = tess("-q", "-svg", "p.svg", "-mesh", "p.vtu", "-mesh", "p.ele", *option,
                "points")
    assert done.code == 0 and not os.path.exists("p.svg")
    assert os.path.getsize("p.vtu") > 0 and text("p.ele") == "0 4 0\n"
    assert re.search("p.svg: no picture of a mesh: .*" + why, done.err)
    done = tess("-svg", "p.svg", "-draw", "points", *option, "points")
    assert done.code == 0
    assert len(re.findall(r"M\d* \d*l0", text("p.svg"))) == int(
        re.search(r"(?m)^points *(\d+)", done.out)[1])


# ---- points in a plane ----

SQUARE = [(0, 0, 1), (3, 0, 2), (0, 3, 3), (2, 2, 4)]
LON = "lon lat depth T\n" + "".join("%d %d %d %d\n" % (x, y, k % 2, T)
                                    for k, (x, y, T) in enumerate(SQUARE, 1))


def test_points_in_a_plane_are_triangles(tess):
    done = tess("-plane", "-grid", "2,2", "-values", "-", "-", stdin="".join(
        "%d %d %d\n" % p for p in SQUARE))
    assert re.search("(?m)^triangles *2$", done.err)
    assert not re.search("tetrahedr|volume|facets", done.err)


def test_points_of_space_in_a_plane_are_those_and_why_no_tetrahedron(tess):
    done = tess("-grid", "2,2,1", "-values", "v.csv", "-",
                stdin=FLAT.replace("\n", " 1\n"))
    assert re.search("(?m)^triangles *2$", done.out)
    assert re.search("(?m)tetrahedron: .* one plane$", done.out)


@pytest.mark.parametrize("options, names", [
    ("-grid 2,2,1", "lon,lat,depth,T"),
    ("-plane -cols lon,depth -grid 2,2", "lon,depth,lat,T")])
def test_values_have_the_columns_names(tess, given, options, names):
    given({"lon.csv": LON})
    tess("-q", *options.split(), "-values", "v.csv", "lon.csv")
    assert text("v.csv").splitlines()[0] == names


@pytest.mark.parametrize("method", ["smooth", "linear"])
def test_infinite_value_is_told_with_what_it_means(tess, given, method):
    given({"inf.csv": LON.replace("0 4\n", "0 1e999\n")})
    done = tess("-method", method, "-grid", "2,2,1", "-values", "v.csv", "inf.csv")
    assert bool(re.search("not finite.* by -method smooth all of the column",
                          done.err)) == (method == "smooth")


# ---- names' endings; several files of one option; standard output ----

@pytest.mark.parametrize("option, name", [
    ("-vtk", "h.vtu"), ("-mesh", "h.obj"), ("-face", "h.msh"), ("-node", "h.txt"),
    ("-ele", "h.node"), ("-neigh", "h.ele"), ("-cells", "h.csv"),
    ("-volumes", "h.vtk"), ("-faces", "h.obj"), ("-svg", "h.png")])
def test_unknown_ending_is_refused_and_which_are_known(tess, option, name):
    done = tess(option, name, "-", stdin=CUBE)
    assert (done.code, done.out) == (2, "") and not os.path.exists(name)
    assert re.search(r"%s h.*the name must end in \." % option, done.err)


def test_mesh_ends_in_all_of_them(tess):
    assert "must end in .vtk, .vtu, .msh, .node, .ele or .neigh\n" in tess(
        "-mesh", "h.ply").err


def test_option_twice_is_both_files(tess, given):
    given({"cube.node": CUBE})
    tess("-q", "-vtk", "one.vtk", "-face", "one.obj", "-vtk", "two.VTK", "-face",
         "two.face", "cube.node")
    tess("-q", "-face", "cube.obj", "-face", "cube.face", "cube.node")
    same("one.vtk", "two.VTK")
    same("one.obj", "cube.obj")
    same("two.face", "cube.face")


@pytest.mark.parametrize("option, name", [
    ("-node", "c.node"), ("-ele", "c.ele"), ("-neigh", "c.neigh"),
    ("-face", "c.face"), ("-vtk", "c.vtk"), ("-svg", "c.svg"), ("-cells", "c.vtk"),
    ("-volumes", "c.csv")])
def test_standard_output_has_that_file_alone(program, tess, given, option, name):
    given({"cube.node": CUBE})
    tess("-q", option, name, "cube.node")
    for out in "-", "/dev/stdout":
        done = subprocess.run([program, option, out, "-check", "cube.node"],
                              capture_output=True)
        with open(name, "rb") as f:
            assert done.stdout == f.read() != b""
        assert b"proven" in done.stderr
    assert not os.path.exists("-")


def test_two_files_on_standard_output_are_refused(tess):
    done = tess("-node", "-", "-ele", "/dev/stdout", "-", stdin=CUBE)
    assert (done.code, done.out) == (2, "")


@pytest.mark.parametrize("target", ["target.node", "nothing"])
def test_link_as_output_stays(tess, tmp_path, given, target):
    given({"target.node": "kept\n", "cube.node": CUBE})
    (tmp_path / "link.node").symlink_to(target)
    done = tess("-node", "link.node", "cube.node")
    assert done.code == 2 and "is a symbolic link" in done.err
    assert (tmp_path / "link.node").is_symlink() and not os.path.exists("nothing")
    assert text("target.node") == "kept\n"


def test_input_by_another_name_is_not_overwritten(tess, tmp_path, given):
    given({"cube.node": CUBE})
    for name in tmp_path / "cube.node", "../%s/cube.node" % tmp_path.name:
        assert "overwrite the input" in tess("-node", name, "cube.node").err
    assert text("cube.node") == CUBE


# ---- files for others, read by them: points, cells, values, NaN among them ----

def rows(name):
    np = pytest.importorskip("numpy")
    return np.array([line.split()[1:] for line in open(name) if line[0] != "#"][1:],
                    float)


def by_meshio(name):
    m = pytest.importorskip("meshio").read(name)
    sizes = {k: v[0] for k, v in m.cell_data.items() if ":" not in k}
    values = {k: v.ravel() for k, v in m.point_data.items() if ":" not in k}
    return m.points, m.cells[0].data, values, sizes


def by_vtk(name):
    data = beside.by_vtk(name)
    assert data.kinds is None or set(data.kinds) <= {5, 10}
    return data.points, data.cells, data.values, data.sizes


def by_gmsh(name):
    gmsh = pytest.importorskip("gmsh")
    import numpy as np
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(name)
    tags, x, _ = gmsh.model.mesh.getNodes()
    kinds, _, c = gmsh.model.mesh.getElements()
    assert list(tags) == list(range(1, len(tags) + 1)) and list(kinds) == [4]
    values = {}
    for view in gmsh.view.getTags():
        name = gmsh.option.getString("View[%d].Name" % len(values))
        kind, at, v = gmsh.view.getModelData(view, 0)[:3]
        assert kind == "NodeData" and list(at) == list(tags)
        values[name] = np.ravel(v)
    gmsh.finalize()
    return x.reshape(-1, 3), c[0].reshape(-1, 4) - 1, values, {}


READERS = [("meshio", by_meshio, "mesh vtk vtu msh", "n.vtu n.msh"),
           ("meshio", by_meshio, "face vtk vtu obj off ply stl", ""),
           ("VTK", by_vtk, "mesh vtk vtu", "n.vtk n.vtu"),
           ("VTK", by_vtk, "face vtk vtu obj ply stl", ""),
           ("gmsh", by_gmsh, "mesh msh", "n.msh")]


@pytest.mark.parametrize("reader, by, option, ending", [
    (reader, by, files.split()[0], ending) for reader, by, files, _ in READERS
    for ending in files.split()[1:]])
def test_file_read_by_another(tess, given, reader, by, option, ending):
    np = pytest.importorskip("numpy")
    r = random.Random(1)
    given({"v0.node": "60 3 2 1\n" + "".join("%d %f %g %f %s %d %d\n" % (
        k, r.random(), r.random() * 1e-7, r.random() * 1e9,
        r.random() - .5 if k % 4 else "nan", k, -k) for k in range(1, 61))})
    name = "f." + ending
    tess("-q", "-node", "v.node", "-ele", "v.ele", "-face", "v.face", "-vtk",
         "v.vtk", "-" + option, name, "v0.node")
    node, ele, face = rows("v.node"), rows("v.ele"), rows("v.face")
    first = int(ele.min())

    def alike(a, b, short=False):
        a, b = np.asarray(a), np.asarray(b)
        if short:  # (these readers round)
            a, b = a.astype("f4"), b.astype("f4")
        return a.shape == b.shape and ((a == b) | (a != a) & (b != b)).all()

    p, c, values, sizes = by(name)
    if option == "mesh":
        assert alike(p, node[:, :3]) and alike(c, ele - first)
        corners = node[ele.astype(int) - first]
        if sizes:  # circumradius and volume, of the corners
            e = corners[:, 1:, :3] - corners[:, :1, :3]
            assert list(sizes) == ["circumradius", "volume"]
            assert np.allclose(np.ravel(sizes["volume"]), np.linalg.det(e) / 6, rtol=1e-6)
            assert (np.asarray(sizes["circumradius"]) > 0).all()
        assert sizes or reader == "gmsh" or ending == "msh"
    else:
        corners = node[face.astype(int) - first]
        short = reader == "VTK" and ending in ("ply", "stl", "obj")
        assert alike(np.asarray(p)[c], corners[:, :, :3], short)
        assert len(p) == len(np.unique(face))
    if ending not in ("obj", "off", "stl") and (ending, reader) != ("ply", "VTK"):
        titles = ["value", "value2", "marker"]
        assert list(values) == titles
        for k, title in enumerate(titles):
            assert alike(np.asarray(values[title])[c], corners[:, :, 3 + k],
                         reader == "VTK" and ending == "ply")
        assert np.isnan(values["value"]).any()


@pytest.mark.parametrize("by, name", [
    pytest.param(by, name, id="%s %s" % (reader, name))
    for reader, by, _, names in READERS for name in names.split()])
def test_names_of_values_read_by_another(tess, by, name):
    tess("-q", "-mesh", name, "-", stdin="x,y,z,T (%),50%20 a,T (%)\n0,0,0,0,1,2\n"
         "1,0,0,3,4,5\n0,1,0,6,7,8\n0,0,1,9,10,11\n")
    values = by(name)[2]
    assert {t: list(v) for t, v in values.items()} == {
        "T (%)": [0, 3, 6, 9], "50%20 a": [1, 4, 7, 10], "T (%)_3": [2, 5, 8, 11]}


def test_node_file_written_is_read_again_as_it_was(tess, given):
    given({"v0.node": NUMBERED})
    tess("-q", "-node", "v.node", "v0.node")
    tess("-q", "-node", "v2.node", "v.node")
    same("v.node", "v2.node")


def test_name_that_is_not_utf_8(tess, tmp_path):
    (tmp_path / "latin.csv").write_bytes(b"x,y,z,T (\xb0C)\n0,0,0,1\n")
    tess("-q", "-mesh", "latin.msh", "-mesh", "latin.vtu", "latin.csv")
    assert "T (?C)" in text("latin.msh") and "T (&#176;C)" in text("latin.vtu")


def test_mesh_of_tetgen_is_its_three_files(tess, given):
    given({"cube.node": CUBE})
    for end in "node", "ele", "neigh":
        tess("-q", "-mesh", "m." + end, "-" + end, "v." + end, "cube.node")
        same("m." + end, "v." + end)


# ---- pictures ----

def test_view(tess, given):
    given({"cube.node": CUBE})
    tess("-q", "-svg", "a.svg", "-view", "20", "70", "cube.node")
    tess("-q", "-svg", "b.svg", "cube.node")
    tess("-q", "-svg", "c.svg", "-view", "-68", "28", "cube.node")
    assert text("a.svg") != text("b.svg")
    same("b.svg", "c.svg")


def test_picture_names_its_value_or_says_that_colours_are_none(tess):
    tess("-q", "-svg", "b.svg", "-", stdin=NUMBERED)
    assert ">value<" in text("b.svg")
    tess("-q", "-svg", "c.svg", "-", stdin=NODE)
    assert "coloured by distance" in text("c.svg")


def test_pictures_are_the_same_bytes_without_optimization(program, everything,
                                                          tmp_path, given):
    given({"none.node": NODE})
    # (without --all what computes in pictures and reads numbers alone)
    again = {p.stem for p in TOP.glob("test/**/*.c")} if everything else set(
        "draw page slice places values derived cell".split())
    assert build_tess(tmp_path / "plainly", again, "-O0").returncode == 0
    made = []
    for tess in program, "./plainly":
        subprocess.run([tess, "-q", "-alpha", "0.55", "-svg", "m.svg", "-grid",
                        "40,1,30", "-values", "s.svg", TOP / "test/data/mirror.xyz"],
                       check=True)
        subprocess.run([tess, "-q", "-svg", "c.svg", "none.node"], check=True)
        made.append([text(f) for f in ("m.svg", "s.svg", "c.svg")])
    assert made[0] == made[1]


@pytest.mark.parametrize("options, why", [
    ("-draw all", "choose points, whole, cut, field or apart"),
    ("-size 900", "a width and a height"), ("-size 99,200", "a width and a height")])
def test_picture_that_is_refused(tess, options, why):
    done = tess("-svg", "no.svg", *options.split(), "-", stdin=NODE)
    assert done.code == 2 and why in done.err and not os.path.exists("no.svg")


def test_pictures_of_the_front_page_say_what_is_so_now(tmp_path):
    subprocess.run(["sh", "test/pictures/pictures.sh", os.path.relpath(tmp_path, TOP)],
                   cwd=TOP, capture_output=True)
    for name in "strip.svg", "methods.svg":
        now, stored = (re.findall(r"(?m)>[^<>]*</text|^rms.*", text(p)) for p in (
            name, TOP / "test" / "pictures" / name))
        assert now == stored and (tmp_path / name).stat().st_size > 999


# ---- -scale ----

def thin(times=(1, 1, 1)):
    """by powers of two, which alter no digit"""
    r = random.Random(4)
    return "300 3 0 0\n" + "".join("%d %.17g %.17g %.17g\n" % (
        k, r.random() * times[0], r.random() * times[1],
        128 * r.random() * times[2]) for k in range(300))


def test_scale_is_the_mesh_of_stretched_points_in_the_given_ones(tess, given):
    given({"thin.node": thin(), "even.node": thin((1, 2, 1 / 128))})
    tess("-q", "-ele", "even.ele", "-neigh", "even.neigh", "even.node")
    done = tess("-scale", "1,2,.0078125", "-check", "-ele", "a.ele", "-neigh",
                "a.neigh", "-node", "a.node", "-vtk", "a.vtk", "-volumes", "a.csv",
                "-faces", "af.csv", "thin.node")
    same("even.ele", "a.ele")
    same("even.neigh", "a.neigh")
    assert "proven" in done.out and done.err == ""
    plain = tess("-node", "thin2.node", "-vtk", "thin.vtk", "thin.node")
    same("thin2.node", "a.node")
    assert text("thin.vtk")[:7300] == text("a.vtk")[:7300]
    # sides that differ are told, and the volume is not stretched
    assert "-scale 1,1,0.008 " in plain.err
    assert re.search("(?m)^volume.*", done.out)[0] == re.search(
        "(?m)^volume.*", plain.out)[0]
    # cells, too
    total, box = re.search(r"(?m)^cells.* sum to (\S+); the box's is (\S+)$",
                           done.out).groups()
    assert abs(float(total) - float(box)) < 1e-12
    tess("-q", "-scale", "1,2,-.0078125", "-ele", "b.ele", "-neigh", "b.neigh",
         "-node", "b.node", "-vtk", "b.vtk", "-volumes", "b.csv", "-faces", "bf.csv",
         "thin.node")
    same("af.csv", "bf.csv")
    for end in "ele", "neigh", "node", "vtk", "csv":
        same("a." + end, "b." + end)


@pytest.mark.parametrize("points, option, told", [
    ("0 0 0\n1 0 0\n0 1 0\n0 0 49\n", [], False),
    ("0 0 0\n1 0 0\n0 1 0\n0 0 51\n", [], True),
    ("0 0 0\n1 0 0\n0 1 0\n0 0 51\n", ["-scale", "1,1,1"], False),
    ("0 0 0\n100 0 0\n0 1 0\n", [], False)], ids=["1:49", "1:51", "-scale", "plane"])
def test_sides_that_differ_are_told_from_1_to_50_on(tess, points, option, told):
    words = tess(*option, "-", stdin=points).err
    assert ("scale" in words) == told and (told or words == "")


@pytest.mark.parametrize("scale", ["1", "1,1", "0,1,1", "1,1,0", "1,1,1,1"])
def test_scale_needs_three_numbers(tess, scale):
    done = tess("-scale", scale, "-", stdin=FLAT)
    assert done.code == 2 and "-scale needs three numbers" in done.err


def test_scale_beyond_the_range_of_numbers(tess):
    done = tess("-scale", "1,1,1e300", "-", stdin="0 0 1e100\n1 0 0\n0 1 0\n1 1 1\n")
    assert done.code == 2 and "-scale: point 0 is beyond" in done.err


# ---- what cannot be written is refused at once ----

@pytest.mark.parametrize("place", ["there", "nowhere/file"])
def test_output_that_cannot_be_is_refused_before_anything_is_read(tess, tmp_path,
                                                                 place):
    (tmp_path / "there").mkdir()
    done = tess("-q", "-ele", place, "-", stdin="no points\n")
    assert done.code == 2
    assert re.search("(?m)^tess: %s: " % place, done.err)
    assert "no points" not in done.err


# ---- many points ----

# arrays grow to what a file needs (on the moment curve any pair of edges makes a
# tetrahedron: (n - 2) (n - 3) / 2)
MOMENT = "".join("%d %d %d\n" % (k, k * k, k ** 3) for k in range(500))


def test_many_points_and_little_memory(program, tess, given, everything):
    n, room = (1000001, 40000) if everything else (300001, 20000)
    given(many="".join("%d 0 0\n" % k for k in range(n)))
    assert re.search("(?m)^points *%d$" % n, tess("many").out)
    done = limited(program, "-q", "many", memory=room * 1024)
    assert done.returncode == 2
    assert re.fullmatch("tess: not enough memory.*\n", done.stderr)


def test_many_tetrahedra_a_point(program, tess, given):
    given(moment=MOMENT)
    done = tess("-check", "moment")
    assert re.search("(?m)^tetrahedra *123753$", done.out) and "proven" in done.out
    assert limited(program, "-q", "moment", memory=40000 * 1024).returncode == 0


# ---- it says how far it is, by its clock ----

TICK = "#include <time.h>\ntime_t tick(time_t *t);\ntime_t tick(time_t *t)\n" \
    "{ static time_t now; (void)t; return %s; }\n"
LONG = ["-volumes", "long.csv", "-grid", "30,30,30", "-values", "long.npy", "-method",
        "natural"]


@pytest.fixture
def clock(tmp_path, given):
    """clock(WORDS): the program with a clock that says so"""
    r = random.Random(6)
    lines = ["%f %f %f %d\n" % (r.random(), r.random(), r.random(), k)
             for k in range(20000)]
    given(long="".join(lines[:5000]), longer="".join(lines))

    def build(now):
        given({"tick.c": TICK % now})
        assert build_tess(tmp_path / "ticking", {"driver"}, "-Dtime=tick",
                          more=[tmp_path / "tick.c"]).returncode == 0
        return lambda *words, **more: subprocess.run(
            ["./ticking", *words], capture_output=True, text=True, **more).stderr
    return build


def test_it_says_how_far_it_is(clock):
    ticking = clock("++now")
    words = ticking("longer") + ticking(*LONG, "-validate", "5", "long")
    for part in "reading", "values", "cells", "-validate":
        assert re.search(r"(?m)^tess: %s: [1-9]\d* %%, about \d* s more$" % part, words)
    assert re.search(r"(?m)^tess: [1-9]\d* tetrahedra after ", words)
    with open("longer") as f:
        assert re.search(r"(?m)^tess: reading: \d* MB$", ticking("-", stdin=f))
    # -q: nothing but of places without a value
    words = ticking("-q", *LONG, "long")
    assert re.fullmatch(r"tess: of 27000 places \d* have no value\n", words)


def test_it_says_nothing_in_the_first_second(clock):
    """a clock that goes from one second to the next is no second"""
    assert not re.search(r"(?m)^tess: [1-9]\d* tet", clock("now = 1 + (now > 0)")(
        *LONG, "long"))


# ---- make bench: a family that there is not, a small run ----

def bench(family):
    return make("bench", "FAMILY=" + family, "CC=" + os.environ.get("CC", "cc"),
                "CFLAGS=-O0")


def test_make_bench_of_a_family_that_there_is_not():
    done = bench("nosuch")
    assert done.returncode != 0 and re.search(r"\bglobe\b", done.stderr)


@pytest.mark.long
def test_make_bench():
    assert bench("no/such").returncode != 0
    done = subprocess.run(["sh", "test/bench/bench.sh"], cwd=TOP, capture_output=True,
                          text=True, env=dict(os.environ, PEERS="", REPEATS="1",
                                              SIZES="50 100", FAMILY="prism",
                                              CFLAGS="-O0"))
    assert len(re.findall(r"(?m)^\| prism \| \d* \| \d* \|", done.stdout)) == 2
    assert re.search(r"(?m)^Load average: [\d.]* before, at most [\d.]* ", done.stdout)
