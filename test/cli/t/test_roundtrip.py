"""The program reads what it writes: points, values, names, bit for bit."""
import csv
import random
import struct

import pytest

KINDS = {
    "units": lambda c: c.uniform(-1, 1),
    "whole": lambda c: float(c.randrange(-99, 99)),
    "far": lambda c: c.uniform(-1, 1) * 1e300,
    "near": lambda c: c.uniform(-1, 1) * 1e-300,
    "subnormal": lambda c: c.randrange(-10**6, 10**6) * 5e-324,
    "UTM": lambda c: round(5e6 + c.uniform(0, 1000), 3),
    "zeros": lambda c: c.choice([0.0, -0.0, 1.0, -1.0, c.uniform(-1, 1)]),
    "any power": lambda c: c.choice([-1, 1]) * c.uniform(1, 2) * 2.0 **
    c.randrange(-60, 60)}
TITLES = ["Au, ppm", 'the "grade"', "T (°C)", "u [m/s]", "a b  c", "日本", "z2#",
          "#n", "'s", "1st", "50 %", "%", "a;b|c", "Au ppm", "NA", "-", "x y z",
          "value", "depth of it", "µg/m³"]


def bits(x):
    return struct.pack("<d", x)


def points(kind, seed, n=40):
    chance = random.Random(seed)
    return [[KINDS[kind](chance) for _ in range(5)] for _ in range(n)]


def write(name, titles, rows):
    with open(name, "w", newline="", encoding="utf-8") as f:
        out = csv.writer(f, quoting=csv.QUOTE_NONNUMERIC, lineterminator="\n")
        out.writerow(titles)
        out.writerows(rows)


def node(name):
    """a .node file's points and values, without their markers"""
    with open(name) as f:
        lines = [line.split() for line in f if line[0] != "#"]
    n, _, values, _ = map(int, lines[0])
    return [[float(x) for x in line[1:4 + values]] for line in lines[1:n + 1]]


def same(a, b):
    return [[bits(x) for x in row] for row in a] == [
        [bits(x) for x in row] for row in b]


def duplicates(rows):
    """(their values are a mean)"""
    return len({tuple(row[:3]) for row in rows}) < len(rows)


@pytest.fixture
def some_seeds(everything):
    return range(5 if everything else 2)


@pytest.fixture
def good(tess, tmp_path):
    """good(...) has tess do that without failing"""
    def run(*arguments):
        done = tess("-q", *arguments)
        assert done.code == 0, done.err
    return run


def at_the_points(good, cols, name, source="f.csv"):
    """the values of source at the points of f.csv"""
    good("-method", "nearest", "-outside", "nearest", "-cols", cols, "-query", "f.csv",
         "-qcols", "1,2,3", "-values", name, source)
    if name.endswith(".csv"):
        with open(name, newline="", encoding="utf-8") as f:
            titles, *rows = csv.reader(f)
        return titles, [[float(x) for x in row] for row in rows]


@pytest.mark.parametrize("kind", KINDS)
def test_node(good, some_seeds, kind):
    for seed in some_seeds:
        rows = points(kind, seed)
        write("f.csv", ["x", "y", "z", "T", "u"], rows)
        for name, source in ("a.node", "f.csv"), ("b.node", "a.node"):
            good("-node", name, source)
            assert same(node(name), rows)


@pytest.mark.parametrize("axes", ["x y z", "EAST NORTH RL", "lon lat depth_(m)",
                                  "X_(m) Y_(m) Z_(m)"])
@pytest.mark.parametrize("kind", KINDS)
def test_values_in_csv(good, some_seeds, kind, axes):
    for seed in some_seeds:
        rows = points(kind, seed)
        titles = [w.replace("_", " ") for w in axes.split()] + random.Random(
            seed).sample(TITLES, 2)
        write("f.csv", titles, rows)
        got = at_the_points(good, "1,2,3,4,5", "v.csv")
        # (places' other columns come back before the values)
        assert got[0] == titles + titles[3:]
        assert same(got[1], [row + row[3:] for row in rows]) or duplicates(rows)
        good("-node", "b.node", "v.csv")
        assert same(node("b.node"), got[1])


@pytest.mark.parametrize("kind", KINDS)
def test_values_in_npy(good, kind):
    """values that are the points again"""
    rows = points(kind, 7)
    if duplicates(rows):
        pytest.skip("places twice")
    write("f.csv", ["x", "y", "z", "a", "b", "c"], [row[:3] * 2 for row in rows])
    at_the_points(good, "x,y,z,a,b,c", "v.npy")
    good("-node", "v.node", "v.npy")
    assert same(node("v.node"), [row[:3] for row in rows])


@pytest.mark.parametrize("kind", KINDS)
def test_volumes_and_errors(tess, good, kind):
    rows = points(kind, 8)
    write("f.csv", ["x", "y", "z", "T (°C)", "a, b"], rows)
    for option in ["-volumes"], ["-method", "nearest", "-validate", "-errors"]:
        done = tess("-q", *option, "v.csv", "f.csv")
        if done.code != 0:
            assert kind in ("far", "near", "subnormal"), done.err
            continue
        good("-cols", "x,y,z", "-node", "v.node", "v.csv")
        got, want = [row[:3] for row in node("v.node")], [row[:3] for row in rows]
        if "-errors" in option and duplicates(rows):
            assert {tuple(r) for r in got} == {tuple(r) for r in want}
        else:
            assert same(got, want)


@pytest.mark.parametrize("title", [t for t in TITLES if "," not in t])
def test_titles(good, title):
    """-cols names them, before and behind"""
    rows = points("units", 3)
    write("f.csv", ["x", "y", "z", "other", title], rows)
    for name, source in ("v.csv", "f.csv"), ("w.csv", "v.csv"):
        titles, got = at_the_points(good, "x,y,z," + title, "t.csv", source)
        assert titles[-1] == title
        assert [row[-1] for row in got] == [row[4] for row in rows]
        write(name, ["x", "y", "z", title], [row[:3] + row[4:] for row in rows])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("end", ["obj", "off", "ply", "stl"])
@pytest.mark.parametrize("binary", [[], ["-binary"]])
def test_faces(tess, some_seeds, kind, end, binary):
    for seed in some_seeds:
        rows = [row[:3] for row in points(kind, seed)]
        write("f.csv", ["x", "y", "z"], rows)
        done = tess("-q", *binary, "-face", "h." + end, "f.csv")
        if done.code == 2 and "beyond" in done.err:
            continue
        assert done.code == 0, done.err
        with open("h." + end, "rb") as f:
            text = f.read()
        if b"nan" in text or b"inf" in text.lower():
            pytest.fail("numbers that are none")
        done = tess("-q", "-node", "h.node", "h." + end)
        assert done.code == 0, done.err
        got = {tuple(map(bits, row)) for row in node("h.node")}
        narrow = end == "stl" and text[:5] != b"solid"
        there = {tuple(bits(struct.unpack("f", struct.pack("f", x))[0] if narrow
                            else x) for x in row) for row in rows}
        # (which of zeros of either sign is written is as good as the other)
        assert got <= there
        tess("-q", "-face", "a.obj", "f.csv")
        with open("a.obj") as f:
            corners = sum(line[:2] == "v " for line in f)
        assert len(got) == corners or kind in ("zeros", "whole")
