"""test_values.py - values that build/tess interpolates: what is refused, and what
places are.  values.py, blocks.py and levels.py compare values with those of NumPy
and SciPy."""
import os
import random
import re
import resource
import shlex
import signal
import subprocess

import pytest

import common
from common import TOP

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
    "points": POINTS, "points.csv": POINTS,
    "bare": columns(POINTS, 0, 1, 2, between=","),
    "bare.csv": columns(POINTS, 0, 1, 2, between=","),
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
    for name, text in FILES.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "folder.npy").mkdir()
    (tmp_path / "taken.npy").write_text("")
    return tmp_path


GRID = "-grid %s -values v.npy points"
REFUSED = [
    ("linear, smooth, natural or nearest",
     "-grid 2,2,2 -method cubic -values v.npy points"),
    ("linear, smooth, natural or nearest",
     "-grid 2,2,2 -method '' -values v.npy points"),
    ("linear, smooth, natural or nearest", "-validate -method linear, points"),
    ("choose one -method",
     "-grid 2,2,2 -method linear,smooth -values v.npy points"),
    ("places are more", "-grid 100000,100000,1000 -values v.npy points"),
    ("FROM:TO/SIDE$",
     "-grid 0:1/.5,0:1/.5,0:1/.5 -step 1,1,1 -values v.npy points"),
    ("are no blocks of -1", "-grid 0:1/-1,0:1/.5,2 -values v.npy points"),
    ("whole numbers from 1", "-grid 0:1:1.5,2,2 -values v.npy points"),
    ("Y0 must be less", "-grid 2,1:0:2,2 -values v.npy points"),
    ("in space: -grid NX,NY", "-plane -grid 2,0:1:2,2 -values v.npy flat"),
    ("X0 must be less", "-grid 2,2,2,1,0,0,1,0,1 -values v.npy points"),
    ("Z0 must be less", "-grid 2,2,2,0,1,0,1,.5,.5 -values v.npy points"),
    ("X0 = -1.7e.308 .* choose less",
     "-values v.npy points -grid 3,2,2,-1.7e308,1.7e308,0,1,0,1"),
    ("Y1 = 1.7e.308 .* choose less",
     "-grid 2,2,2,0,1,-1.7e308,1.7e308,0,1 -values v.npy points"),
    ("Z0 = -1e.308 .* choose less", "-grid 2,2,2 -values v.npy far"),
    ("no values", "-grid 2,2,2 -values v.npy bare"),
    ("no values", "-validate bare"),
    ("needs -values", "-grid 2,2,2 points"),
    ("needs -values", "-query bare points"),
    ("needs places", "-values v.npy points"),
    ("choose one of them", "-grid 2,2,2 -query bare -values v.npy points"),
    ("Y0 must be less", "-grid 2,2,0,1,1,0 -values v.npy points"),
    ("-scale needs three numbers", "-scale 1,2 -validate points"),
    ("is for points in space", "-cols x,y -grid 2,2,2 -values v.npy points"),
    ("-cols: points in a plane .* add -grid.*or -validate; for points in",
     "-cols x,y points"),
    ("-plane: points in a plane .* add -grid.*or -validate$", "-plane points"),
    ("in space, not", "-alpha 1 -grid 2,2 -values v.npy points"),
    ("there are only 5 points", "-plane -validate four.node"),
    ("qcols: column 2 twice", "-query flat -qcols 1,2,2 -values v.npy points"),
    ("no values", "-plane -validate flat"),
    ("is for -query", "-qcols 1,2,3 -grid 2,2,2 -values v.npy points"),
    ("for -values or", "-method smooth points"),
    ("for -values or", "-outside 0 points"),
    ("for -values or", "-clip points"),
    ("-by is for -validate", "-by x points"),
    ("-errors is for -validate", "-errors e.csv points"),
    ("-by: no column \"hole\" among 4", "-validate -by hole points"),
    ("by: no column \"5\" among 4", "-validate -by 5 points"),
    (":3: column 4: empty", "-validate -by 4 hollow"),
    ("no column \"7\" among 6", "-validate -by 7 four.node"),
    ("all points are in one group", "-q -validate -by 5 single"),
    ("overwrite the input", "-validate -errors points.csv points.csv"),
    ("for -values F.csv$", "-digits 3 points"),
    ("for -values F.csv$", "-digits 3 -grid 2,2,2 -values v.npy points"),
    ("from 1 to 17", "-digits 0 -grid 2,2,2 -values v.csv points"),
    ("-outside: .far.: not a number",
     "-outside far -grid 2,2,2 -values v.npy points"),
    ("must end in .csv, .npy, .vtu, .vtk or .svg",
     "-grid 2,2,2 -values v.txt points"),
    ("is for a -grid", "-query bare -values v.vtk points"),
    ("is for a -grid", "-query bare -values v.svg points"),
    ("is of a slice", "-grid 2,2,2 -values v.svg points"),
    ("is of a slice", "-grid 1,2,1 -values v.svg points"),
    ("at most 2000 places", "-grid 1,2001,9 -values v.svg points"),
    ("No such file", "-grid 2,2,2 -values nowhere/v.npy points"),
    ("folder.npy: ", "-grid 2,2,2 -values folder.npy points"),
    ("name of two outputs", "-grid 2,2,2 -values v.npy -values ./v.npy points"),
    ("name of two outputs", "-grid 2,2,2 -values - -volumes - points"),
    ("for the table of -validate", "-grid 2,2,2 -values - -validate points"),
    ("would overwrite", "-query bare.csv -values bare.csv points"),
    ("overwrite the places", "-query bare -values v.npy -volumes bare points"),
    ("overwrite the places", "-query ./bare.csv -values bare.csv points"),
    ("overwrite the input", "-volumes ././points points"),
    ("No such file", "-query nowhere -values v.npy points"),
    ("empty: empty", "-query empty -values v.npy points"),
    (":2: column 2: .here.: not a number", "-query word -values v.npy points"),
    (":2: column 2: .nan.: not a number",
     "-query notfinite -values v.npy points"),
    ("qcols: no column \"w\"", "-query bare -qcols x,y,w -values v.npy points"),
    ("three columns", "-query bare -qcols x,y,z,T -values v.npy points"),
    ("both be standard input", "-query - -values v.npy"),
    ("both be standard input", "-query - -values v.npy -"),
    ("folds, from 2 on", "-validate 1 points"),
    ("only 200 points", "-validate 201 points"),
    ("knows the hull",
     "-outside nearest -alpha 1 -grid 2,2,2 -values v.npy points"),
    ("lie on one line", "-q -grid 2,2,2 -values v.npy line"),
    ("lie on one line", "-q -validate line"),
    ("lie on one line", "-q -plane -grid 2,2 -values v.npy line"),
    ("in one plane, where -alpha",
     "-q -alpha 1 -grid 2,2,2 -values v.npy plane"),
    ("no tetrahedron is left; choose more folds", "-q -validate 2 four"),
    ("no tetrahedron is left; choose smaller groups",
     "-q -validate 2 -by 5 holes"),
] + [
    ("whole numbers", GRID % g) for g in (
        "0,2,2", "2,-1,2", "2,2,2.5", "1e99,1,1", "99999999999,1,1", "0:1:1.5,2,2")
] + [
    ("needs NX,NY,NZ", GRID % g) for g in (
        "2", "2,2,2,0", "2,2,2,0,1", "2,2,2,0,1,0,1,0,1,0")
] + [
    ("two axes or three, each N, FROM:TO:N or FROM:TO/SIDE$", GRID % g) for g in (
        "2,2:3,2", "2,0:1:2,2,2", "2:3:2", "0:1:2,2,", "2,0:1,2", "0:1:2,,2")
] + [
    ('"[^"]*": not a number', GRID % g) for g in (
        "0:x:2,2,2", "2,0:1:2:3,2", "2,0/1:2,2", ":,2,2", "2,0::2,2")]


@pytest.mark.parametrize("words, options", REFUSED, ids=[
    "%s: %s" % (o, w) for w, o in REFUSED])
def test_refused(program, places, words, options):
    """exit code 2, one line on standard error that says words, nothing on standard
    output, and no file"""
    before = sorted(os.listdir())
    done = subprocess.run([program, *shlex.split(options)], input=POINTS, text=True,
                          capture_output=True, timeout=100)
    assert (done.returncode, done.stdout) == (2, "")
    assert re.fullmatch(".*(?:%s).*\n" % words, done.stderr)
    assert sorted(os.listdir()) == before


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


def limited(program, size, *options, memory=None):
    """with so many bytes of a file, and of memory"""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        if size:
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    return subprocess.run([program, "-q", *options], capture_output=True, text=True,
                          timeout=100, preexec_fn=limit)


def test_file_that_cannot_be_completed(program, places):
    """is not there; one that was stays as it was"""
    (places / "full.npy").write_text("old\n")
    done = limited(program, 51200, "-grid", "50,50,50", "-values", "full.npy", "points")
    assert done.returncode == 2 and "full.npy: write error" in done.stderr
    assert (places / "full.npy").read_text() == "old\n"
    assert not (places / "full.npy.part").exists()


@pytest.mark.parametrize("ending", ["csv", "npy", "vtk"])
def test_gigabytes_are_announced_and_a_full_disk_is_noticed_at_once(program, places,
                                                                    ending):
    name = "big." + ending
    done = limited(program, 51200, "-grid", "1000,1000,200", "-values", name, "points")
    assert done.returncode == 2 and not (places / name).exists()
    assert re.search("%s: about [1-9][0-9.]* GB will be written" % name, done.stderr)
    assert name + ": write error" in done.stderr


def test_ten_million_places_take_no_memory_of_their_own(program, places):
    done = limited(program, 0, "-grid", "250,200,200", "-values", "ten.npy", "points",
                   memory=20000 * 1024)
    assert done.returncode == 0, done.stderr
    assert (places / "ten.npy").stat().st_size == 80000128
    (places / "ten.npy").unlink()


def test_a_million_places_of_a_file_take_no_memory_and_are_as_their_parts(
        tess, program, places):
    chance = random.Random(4)
    lines = 1000 * ["%f %f %f\n" % (chance.random(), chance.random(),
                                    chance.random()) for k in range(1000)]
    (places / "some").write_text("".join(lines))
    done = limited(program, 0, "-query", "some", "-values", "some.npy", "points",
                   memory=32000 * 1024)
    assert done.returncode == 0, done.stderr
    whole = (places / "some.npy").read_bytes()
    # where the first line might be one, but for the number
    (places / "titled.xyz").write_text("1000000\n0 0 0\n" + "".join(lines))
    tess("-q", "-query", "titled.xyz", "-values", "titled.npy", "points")
    assert (places / "titled.npy").read_bytes() == whole
    parts = b""
    for k in range(0, 1000000, 100000):
        (places / "piece").write_text("".join(lines[k:k + 100000]))
        tess("-q", "-query", "piece", "-values", "part.npy", "points")
        parts += (places / "part.npy").read_bytes()[128:]
    assert whole[128:] == parts and len(parts) == 8000000
    for name in "some", "some.npy", "titled.xyz", "titled.npy":
        (places / name).unlink()


def test_places_from_standard_input_and_no_progress(tess, places):
    done = tess("-q", "-query", "-", "-values", "in.csv", "points",
                stdin=FILES["bare"].partition("\n")[2])
    assert done.err == ""
    assert len((places / "in.csv").read_text().splitlines()) == 201


def test_help_has_no_long_line(tess):
    lines = [s for s in tess("-h").out.splitlines() if s[:3] == "  -"]
    assert len(lines) > 30 and max(map(len, lines)) <= 78


def make_grid():
    return subprocess.run(["make", "grid"], cwd=TOP, capture_output=True).returncode


def test_make_grid():
    for name in "mirror.vtk", "mirror.svg":
        if (TOP / "build" / name).exists():
            (TOP / "build" / name).unlink()
    assert make_grid() == 0
    assert b"DIMENSIONS 200 200 20" in (TOP / "build/mirror.vtk").read_bytes()
    assert "</svg>" in (TOP / "build/mirror.svg").read_text()


# ---- beside NumPy and SciPy: scripts that print `ok ...' or `FAILED ...' ----

def test_values_are_scipy_s(program, tmp_path):
    """and those of recipes, beside build/tess"""
    pytest.importorskip("scipy")
    assert make_grid() == 0
    library = tmp_path / "recipes.so"
    done = subprocess.run([
        os.environ.get("CC", "cc"), "-O2", "-shared", "-fPIC", "-I.", "-o", library,
        "tess.c", "hhpred.c", "test/recipes/slopes.c", "-lm"], cwd=TOP)
    common.script("values.py", program, *[library] * (done.returncode == 0))


def test_block_models_are_scipy_s(program, tmp_path):
    pytest.importorskip("scipy")
    common.script("blocks.py", program)


def test_surfaces_of_equal_value_are_numpy_s(program, tmp_path):
    pytest.importorskip("scipy")
    common.script("levels.py", program, TOP / "test/data/mirror.xyz")


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
