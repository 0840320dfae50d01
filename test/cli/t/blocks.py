# blocks.py - block models by build/tess: from a CSV of samples to a CSV of
# blocks, beside what NumPy and SciPy compute independently; test_values.py runs
# it.
#
#   python3 blocks.py TESS
#
# In the current directory, where it leaves its files.  Prints `ok ...' or
# `FAILED ...' for each test.
import csv

import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import cKDTree

from common import near, run, tess, test

random = np.random.default_rng(54)


def refuses(words, *arguments):
    done = run(*arguments)
    test("refuses " + " ".join(str(a) for a in arguments),
         done.returncode == 2 and done.stdout == "" and
         done.stderr.count("\n") == 1 and words in done.stderr)


def rows(name):
    with open(name, newline="") as f:
        return list(csv.reader(f))


def centres(low, high, step):
    """Of blocks, as [z, y, x, axis]."""
    axis = [low[k] + step[k] * (np.arange(int(np.floor(
        (high[k] - low[k]) / step[k] + 0.5))) + 0.5) for k in range(3)]
    z, y, x = np.meshgrid(axis[2], axis[1], axis[0], indexing="ij")
    return np.stack((x, y, z), -1)


# ---- drill holes in UTM coordinates, as a geologist has them ----

collar = random.random((40, 2)) * (900, 700) + (512345, 7654321)
lean = random.normal(size=(40, 3)) * (4, 4, .5) + (0, 0, -3)
p = np.round((np.column_stack((collar, np.full(40, 300.)))[:, None] +
              np.arange(25)[None, :, None] * lean[:, None]).reshape(-1, 3), 3)
au = np.round(np.exp(np.sin(p[:, 0] / 90) + p[:, 2] / 200), 4)
cu = np.round(np.cos(p[:, 1] / 120), 4)
with open("holes.csv", "w") as f:
    f.write("hole,x,y,z,au,cu\n")
    for k, (a, b, c) in enumerate(zip(p, au, cu)):
        f.write("DH-%03d,%.3f,%.3f,%.3f,%.4f,%.4f\n" % ((k // 25,) + tuple(a) +
                                                       (b, c)))
low, high, step = (512300, 7654300, 220), (513260, 7655020, 305), (20, 30, 10)
q = centres(low, high, step)
ends = ",".join("%d,%d" % e for e in zip(low, high))
size = ",".join(map(str, step))
# (SciPy errs where coordinates are large: as seen from their middle)
middle = p.mean(0)
linear = LinearNDInterpolator(p - middle, np.column_stack((au, cu)))
want = linear(q - middle)
far = cKDTree(p).query(q)[0]

said = tess("-step", size, "-grid", ends, "-values", "b.csv", "-values",
            "b.npy", "holes.csv")
got = np.load("b.npy")
inside = ~np.isnan(want[..., 0])
test("blocks: so many, where they are, LinearNDInterpolator's values",
     got.shape == (9, 24, 48, 2) and near(got, want, 1e-9) and
     1000 < inside.sum() < inside.size - 1000)
test("blocks: it is said that 8.5 blocks are 9",
     "are 8.5 blocks of 10: 9 are made, to 310" in said.stderr)
test("blocks: it is said how many have no value",
     "places        %d, without a value %d\n" % (inside.size, (~inside).sum())
     in said.stdout)
table = rows("b.csv")
number = np.array(table[1:], float)
test("blocks, .csv: names; the centres, x fastest; the values of .npy",
     table[0] == ["x", "y", "z", "au", "cu"] and
     np.array_equal(number[:, :3], q.reshape(-1, 3)) and
     near(number[:, 3:], got.reshape(-1, 2), 0.0))
tess("-q", "-step", size, "-grid", ends, "-drop", "-values", "d.csv",
     "holes.csv")
number = np.array(rows("d.csv")[1:], float)
test("-drop: the others, in their order", near(number, np.column_stack(
    (q[inside], got[inside])), 0.0) and len(number) == inside.sum())
for D in 15, 40, 1000:
    said = tess("-step", size, "-grid", ends, "-within", D, "-drop", "-values",
                "d.csv", "-values", "w.npy", "holes.csv")
    keep = inside & (far <= D)
    number = np.array(rows("d.csv")[1:], float)
    test("-within %d: those of the other points' distances" % D,
         0 < keep.sum() < (far <= D).sum() and len(number) == keep.sum() and
         near(np.load("w.npy"), np.where(keep[..., None], got, np.nan), 0.0) and
         np.array_equal(number[:, :3], q[keep]) and
         "without a value %d\n" % (~keep).sum() in said.stdout)
for method in "smooth", "natural", "nearest":
    tess("-q", "-method", method, "-outside", "nearest", "-step", size, "-grid",
         ends, "-values", "a.npy", "holes.csv")
    tess("-q", "-method", method, "-outside", "nearest", "-step", size, "-grid",
         ends, "-within", 40, "-values", "w.npy", "holes.csv")
    a = np.load("a.npy")
    test("-within, -outside nearest, %s: within, and outside of the hull" %
         method, not np.isnan(a).any() and near(
             np.load("w.npy"), np.where((far <= 40)[..., None], a, np.nan), 0.0)
         and (~inside & (far <= 40)).sum() > 50)
tess("-q", "-outside", -1, "-step", size, "-grid", ends, "-within", 40,
     "-values", "w.npy", "holes.csv")
test("-within, -outside VALUE: NaN far from all points, the value elsewhere",
     near(np.load("w.npy"), np.where(
         (far > 40)[..., None], np.nan,
         np.where(inside[..., None], got, -1)), 0.0))
# by -scale lengths are of what is stretched
tess("-q", "-scale", "1,1,5", "-outside", "nearest", "-step", size, "-grid",
     ends, "-within", 60, "-values", "w.npy", "holes.csv")
stretch = (1, 1, 5)
away = cKDTree(p * stretch).query(q * stretch)[0]
test("-within, -scale: in the stretched coordinates", np.array_equal(
    np.isnan(np.load("w.npy")[..., 0]), away > 60))
# exactly D is not farther
np.savetxt("cube.csv", [[x, y, z, x] for x in (0, 8) for y in (0, 8)
                        for z in (0, 8)], "%g", ",", header="x,y,z,v",
           comments="")
open("three.csv", "w").write("x,y,z\n3,4,0\n4,4,0\n3.0000000000000004,4,0\n")
tess("-q", "-query", "three.csv", "-within", 5, "-values", "t.npy", "cube.csv")
test("-within: a distance of exactly D", np.array_equal(
    np.isnan(np.load("t.npy")[:, 0]), [False, True, True]))

# the centres are X0 + (i + 1/2) SX, whatever X0 is; one block, a slice
tess("-q", "-step", ".1,.1,.1", "-grid", "0,.7,.1,.8,.35,.45", "-values",
     "s.csv", "-values", "s.svg", "-values", "s.vtk", "cube.csv")
number = np.array(rows("s.csv")[1:], float)
test("blocks of 0.1: 7, 7, 1 of them", near(number[:, :3], centres(
    (0, .1, .35), (.7, .8, .45), (.1, .1, .1)).reshape(-1, 3), 0.0) and
    len(number) == 49)
try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkStructuredPointsReader()
    reader.SetFileName("s.vtk")
    reader.Update()
    m = reader.GetOutput()
    at = np.array([m.GetPoint(i) for i in range(m.GetNumberOfPoints())])
    test("blocks, .vtk, read by VTK: centres, sides, values",
         near(at, number[:, :3], 1e-15) and m.GetSpacing() == (.1, .1, .1) and
         near(vtk_to_numpy(m.GetPointData().GetArray("v")), number[:, 3], 0.0))
except ImportError:
    print("        skipped: blocks, .vtk, read by VTK: no vtk")

# in a plane
np.savetxt("flat.csv", np.column_stack((p[:, :2], au)), "%.4f", ",",
           header="x,y,au", comments="")
tess("-q", "-cols", "x,y,au", "-step", "20,30", "-grid",
     "512300,513260,7654300,7655020", "-within", 50, "-values", "f.npy",
     "flat.csv")
flat = LinearNDInterpolator(p[:, :2] - middle[:2], au)(q[0, ..., :2] -
                                                       middle[:2])
flat[cKDTree(p[:, :2]).query(q[0, ..., :2])[0] > 50] = np.nan
test("blocks in a plane: LinearNDInterpolator's, within a distance",
     near(np.load("f.npy")[..., 0], flat, 1e-9) and
     0 < np.isnan(flat).sum() < flat.size)

refuses("-grid X0,X1,Y0,Y1,Z0,Z1, where", "-step", size, "-query", "three.csv",
        "-values", "n.csv", "holes.csv")
refuses("says where the blocks begin and end", "-step", size, "-grid", "3,3,3",
        "-values", "n.csv", "holes.csv")
refuses("says where the blocks begin and end", "-step", size, "-grid",
        ends + ",0,1,2", "-values", "n.csv", "holes.csv")
refuses("are no blocks of", "-step", size, "-grid", "1,0,0,1,0,1", "-values",
        "n.csv", "holes.csv")
refuses("less than half a block", "-step", size, "-grid", "0,9,0,30,0,10",
        "-values", "n.csv", "holes.csv")
refuses("places are more than", "-step", "1e-3,1e-3,1e-3", "-grid", ends,
        "-values", "n.csv", "holes.csv")
for bad in "1", "1,2,3,4", "0,1,1", "1,-1,1":
    refuses("needs the sides of a block", "-step", bad, "-grid", ends,
            "-values", "n.csv", "holes.csv")
for bad in "0", "-1":
    refuses("needs a length", "-within", bad, "-grid", "2,2,2", "-values",
            "n.csv", "holes.csv")
refuses("-drop is for -values", "-drop", "holes.csv")
refuses("-within is for -values", "-within", 1, "holes.csv")
refuses("-drop is for -values F.csv", "-drop", "-grid", "2,2,2", "-values",
        "n.npy", "holes.csv")

# ---- three names in -cols are no plane where -by tells groups apart ----

with open("groups.csv", "w") as f:
    f.write("x,y,z,t\n")
    for k, a in enumerate(random.random((200, 3))):
        f.write("%.9f,%.9f,%.9f,%d\n" % (tuple(a) + (k % 9,)))
refuses("have no values", "-validate", "-by", "t", "-cols", "x,y,z",
        "groups.csv")
with open("three.csv", "w") as f:
    for line in rows("groups.csv"):
        f.write(",".join(line[:3]) + "\n")
said = tess("-q", "-validate", "-cols", "x,y,z", "three.csv").stdout
test("-validate, three names in -cols: a plane where nothing else is there",
     said.split("\n")[1].split()[:2] == ["linear", "z"])

# ---- places of a file, with columns that come back as they are ----

p = random.random((400, 3))
T = p @ (2, -3, .5)
np.savetxt("points.csv", np.column_stack((p, T)), "%.17g", ",",
           header="x,y,z,T", comments="")
linear = LinearNDInterpolator(p, T)


def places(many, separator=",", header=True):
    """A file; its other columns' texts; where the places are."""
    q = np.round(random.random((many, 3)) * 1.2 - .1, 6)
    text = [["007", "1.50", "1e3", "-0", "+2", "0x1F"][i % 6] for i in
            range(many)]
    note = [["a b", "", "n/a", '"c, d"', "x", '"say ""hi"""'][i % 6]
            if separator == "," else "w%d" % i for i in range(many)]
    head = separator.join(["id", "lon", "from", "lat", "depth", "note"])
    with open("places.csv", "w") as f:
        if header:
            f.write(head + "\n")
        for i in range(many):
            f.write(separator.join([
                "DH-%05d" % i, "%.6f" % q[i, 0], text[i], "%.6f" % q[i, 1],
                "%.6f" % q[i, 2], note[i]]) + "\n")
    with open("places.csv", newline="") as f:
        r = list(csv.reader(f, delimiter=separator))[header:]
    return q, [[a[0], a[2], a[5]] for a in r]


# (so many that places are kept in a file)
for many, separator, header in ((50, ",", True), (50, ",", False),
                                (50, ";", True), (50, "\t", True),
                                (140000, ",", True)):
    q, others = places(many, separator, header)
    want = linear(q)
    for drop in [], ["-drop"]:
        said = tess(*drop, "-query", "places.csv", "-qcols", "2,4,5", "-values",
                    "q.csv", "-values", "again.csv", "-values", "q.npy",
                    "points.csv")
        table = rows("q.csv")
        keep = ~np.isnan(want) if drop else np.ones(many, bool)
        number = np.array([r[:3] + r[6:] for r in table[1:]], float)
        test("-query, %d places, %r, %s names: other columns as they are %s" % (
            many, separator, "with" if header else "without", " ".join(drop)),
            table[0] == ["x", "y", "z"] + (
                ["id", "from", "note"] if header else
                ["column1", "column3", "column6"]) + ["T"] and
            [r[3:6] for r in table[1:]] == [o for o, k in zip(others, keep)
                                            if k] and
            near(number, np.column_stack((q, want))[keep], 1e-12) and
            np.array_equal(number[:, :3], q[keep]) and
            open("q.csv").read() == open("again.csv").read() and
            near(np.load("q.npy")[:, 0], want, 1e-12))
# verbatim in bytes, where nothing needs quotes; places that -skip drops
with open("places.csv", "w") as f:
    f.write("x,y,z,id\n.5,.5,.5,1.50\n.4,,.4,2.50\n.3,.3,.3,003\n")
tess("-skip", "-query", "places.csv", "-digits", 3, "-values", "q.csv",
     "points.csv")
test("-query -skip: the others' texts stay beside their places",
     [l.split(",")[:4] for l in open("q.csv").read().split("\n")[1:3]] ==
     [["0.5", "0.5", "0.5", "1.50"], ["0.3", "0.3", "0.3", "003"]] and
     len(rows("q.csv")) == 3)
note = ["", "a", "", "b", ""]
with open("places.csv", "w") as f:
    f.write("x,y,z,note\n")
    for i in range(5):
        f.write(".5,.%d,.5,%s\n" % (i + 3, note[i]))
tess("-query", "places.csv", "-values", "q.csv", "points.csv")
test("-query: another column that is empty here and there",
     [r[3:4] for r in rows("q.csv")[1:]] == [[n] for n in note] and
     all(len(r) == 5 for r in rows("q.csv")))
with open("places.csv", "w") as f:
    f.write(".5 .5 .5\n.4 .4 .4\n")
tess("-query", "places.csv", "-values", "q.csv", "points.csv")
test("-query: no other columns", rows("q.csv")[0] == ["x", "y", "z", "T"])

# -errors: those of the points
with open("groups.csv", "w") as f:
    f.write("x,y,z,T,hole,no\n")
    for i, a in enumerate(np.vstack((p, p[:7]))):
        f.write("%.17g,%.17g,%.17g,%.9f,H %d,%03d\n" % (tuple(a) + (
            a @ (2, -3, .5), i // 8, i)))
tess("-validate", 5, "-by", "hole", "-cols", "x,y,z,T", "-errors", "e.csv",
     "groups.csv")
table = rows("e.csv")
test("-errors: the points' other columns, in front of the values",
     table[0] == ["x", "y", "z", "fold", "hole", "no", "T",
                  "linear-T (predicted minus measured)"] and
     [r[4:6] for r in table[1:]] == [["H %d" % (i // 8), "%03d" % i]
                                     for i in range(400)] and
     near(np.array([r[6] for r in table[1:]], float), T, 1e-8) and
     len({(r[3], r[4]) for r in table[1:]}) == 50)
