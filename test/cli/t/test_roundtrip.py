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


@pytest.mark.parametrize("kind", KINDS)
def test_node(tess, tmp_path, kind):
    for seed in range(5):
        rows = points(kind, seed)
        write("f.csv", ["x", "y", "z", "T", "u"], rows)
        for name, source in ("a.node", "f.csv"), ("b.node", "a.node"):
            done = tess("-q", "-node", name, source)
            assert done.code == 0, done.err
            assert same(node(name), rows)


@pytest.mark.parametrize("axes", [["x", "y", "z"], ["EAST", "NORTH", "RL"],
                                  ["lon", "lat", "depth (m)"],
                                  ["X (m)", "Y (m)", "Z (m)"]])
@pytest.mark.parametrize("kind", KINDS)
def test_values_in_csv(tess, tmp_path, kind, axes):
    for seed in range(5):
        rows = points(kind, seed)
        chance = random.Random(seed)
        titles = axes + chance.sample(TITLES, 2)
        write("f.csv", titles, rows)
        done = tess("-q", "-method", "nearest", "-outside", "nearest", "-cols",
                    "1,2,3,4,5", "-query", "f.csv", "-qcols", "1,2,3", "-values",
                    "v.csv", "f.csv")
        assert done.code == 0, done.err
        with open("v.csv", newline="", encoding="utf-8") as f:
            got = list(csv.reader(f))
        # (places' other columns come back before the values)
        assert got[0] == titles + titles[3:]
        assert same([[float(x) for x in row] for row in got[1:]],
                    [row + row[3:] for row in rows]) or duplicates(rows)
        done = tess("-q", "-node", "b.node", "v.csv")
        assert done.code == 0, done.err
        assert same(node("b.node"), [[float(x) for x in row]
                                     for row in got[1:]])


@pytest.mark.parametrize("kind", KINDS)
def test_values_in_npy(tess, tmp_path, kind):
    """values that are the points again"""
    rows = points(kind, 7)
    if duplicates(rows):
        pytest.skip("places twice")
    write("f.csv", ["x", "y", "z", "a", "b", "c"],
          [row[:3] + row[:3] for row in rows])
    tess("-q", "-method", "nearest", "-outside", "nearest", "-cols",
         "x,y,z,a,b,c", "-query", "f.csv", "-qcols", "1,2,3", "-values",
         "v.npy", "f.csv")
    assert tess("-q", "-node", "v.node", "v.npy").code == 0
    assert same(node("v.node"), [row[:3] for row in rows])


@pytest.mark.parametrize("kind", KINDS)
def test_volumes_and_errors(tess, tmp_path, kind):
    rows = points(kind, 8)
    write("f.csv", ["x", "y", "z", "T (°C)", "a, b"], rows)
    for option, columns in (["-volumes", "v.csv"], "x,y,z"), (
            ["-method", "nearest", "-validate", "-errors", "v.csv"],
            'x,y,z'):
        done = tess("-q", *option, "f.csv")
        if done.code != 0:
            assert kind in ("far", "near", "subnormal"), done.err
            continue
        assert tess("-q", "-cols", columns, "-node", "v.node", "v.csv").code == 0
        got = [row[:3] for row in node("v.node")]
        want = [row[:3] for row in rows]
        if "-errors" in option and duplicates(rows):
            assert {tuple(r) for r in got} == {tuple(r) for r in want}
        else:
            assert same(got, want)


def duplicates(rows):
    """(their values are a mean)"""
    return len({tuple(row[:3]) for row in rows}) < len(rows)


@pytest.mark.parametrize("title", TITLES)
def test_titles(tess, tmp_path, title):
    """-cols names them, before and behind"""
    rows = points("units", 3)
    write("f.csv", ["x", "y", "z", "other", title], rows)
    if "," in title:
        pytest.skip("-cols has commas between names")
    cols = "x,y,z," + title
    for name, source in ("v.csv", "f.csv"), ("w.csv", "v.csv"):
        done = tess("-q", "-method", "nearest", "-cols", cols, "-query",
                    "f.csv", "-qcols", "1,2,3", "-outside", "nearest",
                    "-values", "t.csv", source)
        assert done.code == 0, done.err
        with open("t.csv", newline="", encoding="utf-8") as f:
            got = list(csv.reader(f))
        assert got[0][-1] == title
        assert [float(row[-1]) for row in got[1:]] == [row[4] for row in rows]
        write(name, ["x", "y", "z", title], [row[:3] + row[4:] for row in rows])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("end", ["obj", "off", "ply", "stl"])
@pytest.mark.parametrize("binary", [[], ["-binary"]])
def test_faces(tess, tmp_path, kind, end, binary):
    for seed in range(3):
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
