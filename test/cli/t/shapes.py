# shapes.py - alpha shapes by build/tess, beside exact fractions and brute
# force; test_driver.py runs it.
#
#   python3 shapes.py TESS
#
# In the current directory, where it leaves its files.  Prints `ok ...' or
# `FAILED ...' for each test.
import re
from collections import Counter
from fractions import Fraction

import numpy as np

import common
from common import test

random = np.random.default_rng(54)


def tess(*arguments):
    return common.tess("-scale", "1,1,1", *arguments)


def rows(name):
    lines = [l.split() for l in open(name) if l[0] != "#"]
    return [[int(x) for x in l[1:]] for l in lines[1:]]


def square(p):
    """Of the circumradius of four points, exactly."""
    e = [[Fraction(float(p[i][k])) - Fraction(float(p[0][k]))
          for k in range(3)] for i in (1, 2, 3)]

    def cross(a, b):
        return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                a[0] * b[1] - a[1] * b[0]]

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))

    f = [cross(e[(i + 1) % 3], e[(i + 2) % 3]) for i in range(3)]
    det = dot(e[0], f[0])
    n = [sum(dot(e[i], e[i]) * f[i][k] for i in range(3)) for k in range(3)]
    return dot(n, n) / (4 * det * det)


def root(r):
    """The least double whose square is not less."""
    x = float(r) ** .5
    while Fraction(x) ** 2 >= r:
        x = np.nextafter(x, 0)
    while Fraction(x) ** 2 < r:
        x = np.nextafter(x, np.inf)
    return float(x)


def pieces(kept, neighbours):
    left, many = set(kept), 0
    while left:
        many += 1
        stack = [left.pop()]
        while stack:
            for u in neighbours[stack.pop()]:
                if u in left:
                    left.remove(u)
                    stack.append(u)
    return many


def manifold(face):
    """How many edges have more than two triangles, and how many points fans
    that share no edge."""
    edge = Counter(frozenset((f[k], f[(k + 1) % 3])) for f in face
                   for k in range(3))
    touch = 0
    for v in {v for f in face for v in f}:
        fan = [set(f) - {v} for f in face if v in f]
        parts = 0
        while fan:
            parts += 1
            seen = fan.pop()
            grown = True
            while grown:
                grown = False
                for f in fan[:]:
                    if f & seen:
                        seen |= f
                        fan.remove(f)
                        grown = True
        touch += parts > 1
    return sum(k > 2 for k in edge.values()), touch


exact = least = surface = True
warned = set()
for case in range(16):
    p = random.random(((30, 60)[case // 4 % 2], 3))
    if case % 4 == 1:
        p = np.round(p * 4) / 2  # of a lattice, with duplicates
    if case % 4 == 2:
        p = np.round(p * (1000, 1000, 50) + (512345, 7654321, 0), 3)
    if case % 4 == 3:
        p[::2] += 3
    np.savetxt("a.xyz", p, fmt="%.17g")
    tess("-q", "-ele", "v.ele", "-neigh", "v.neigh", "a.xyz")
    tet, neighbours = rows("v.ele"), rows("v.neigh")
    squares = [square([p[v] for v in t]) for t in tet]
    points = {v for t in tet for v in t}
    # the least double that is one piece with all points
    for want in sorted(set(map(root, squares))):
        kept = [i for i, r in enumerate(squares) if r <= Fraction(want) ** 2]
        if {v for i in kept for v in tet[i]} == points and \
                pieces(kept, neighbours) == 1:
            break
    said = tess("-alpha", "auto", "-ele", "a.ele", "-face", "a.face", "a.xyz")
    got = re.search(r"(?m)^alpha +(\S+), the least that leaves one piece", said.stdout)
    least &= got is not None and float(got.group(1)) == want and \
        rows("a.ele") == [tet[i] for i in kept]
    edges, touch = manifold(rows("a.face"))
    word = re.search(r"no manifold: more than two triangles meet at (\d+) edge"
                     r"s?, parts of it touch at (\d+) point", said.stderr)
    surface &= (edges, touch) == (tuple(map(int, word.groups())) if word
                                  else (0, 0))
    warned |= {(edges > 0, touch > 0)}
    # radii that are some tetrahedron's, the next double below, and others
    for r in random.choice(squares, 6):
        for R in root(r), np.nextafter(root(r), 0):
            tess("-q", "-alpha", repr(float(R)), "-ele", "a.ele", "a.xyz")
            exact &= rows("a.ele") == [t for t, s in zip(tet, squares)
                                       if s <= Fraction(float(R)) ** 2]
test("-alpha auto: the least number that leaves one piece with all points",
     least)
test("-alpha R: exactly those whose circumradius is not larger", exact)
test("-alpha: where the surface is no manifold",
     surface and {(False, False), (True, False)} <= warned)
# a ball of exactly the radius: sides 1, 2, 2 have the diagonal 3
for at in (0, 0, 0), (512345, 7654321, 1000), (1e9, 0, 0):
    box = np.array([[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 2)])
    np.savetxt("box.xyz", box + at, fmt="%.17g")
    whole = len(rows("v.ele")) if tess("-q", "-ele", "v.ele", "box.xyz") else 0
    kept = []
    for R in 1.5, np.nextafter(1.5, 0):
        tess("-q", "-alpha", repr(float(R)), "-ele", "a.ele", "box.xyz")
        kept.append(len(rows("a.ele")))
    test("-alpha 1.5: a ball of that radius at %g,%g,%g" % at,
         kept == [whole, 0] and whole > 4)
# two tetrahedra that share a corner alone
one = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 0, 1]])
np.savetxt("two.xyz", np.vstack((one, -one[1:])), fmt="%g")
said = tess("-alpha", .9, "-face", "a.face", "two.xyz")
test("-alpha: parts that touch at a point",
     "at 0 edges, parts of it touch at 1 point;" in said.stderr and
     manifold(rows("a.face")) == (0, 1))

# ---- what repeats itself ----

p = random.random((150, 3)) + (2, 0, 0)
np.savetxt("p.xyz", np.column_stack((p, p[:, 0])), fmt="%.17g")
periodic = ["-periodic", "-box", "2,3,0,1,0,1"]
tess("-q", *periodic, "-node", "v.node", "-ele", "v.ele", "p.xyz")
x = np.array([[float(a) for a in l.split()[1:4]] for l in open("v.node")][1:])
tet = rows("v.ele")
test("-periodic: the tetrahedra are once in a cell", abs(sum(
    np.linalg.det(x[t[1:]] - x[t[0]]) / 6 for t in tet) - 1) < 1e-12)
squares = [square(x[t]) for t in tet]
for R in .12, .15, .2:
    said = tess(*periodic, "-alpha", R, "-ele", "a.ele", "-grid", "12,12,12",
                "-values", "a.npy", "-svg", "a.svg", "p.xyz")
    kept = [t for t, s in zip(tet, squares) if s <= Fraction(R) ** 2]
    volume = sum(np.linalg.det(x[t[1:]] - x[t[0]]) / 6 for t in kept)
    svg = open("a.svg").read()
    test("-periodic -alpha %g: the cell's tetrahedra, each once; points once" % R,
         rows("a.ele") == kept and 0 < len(kept) < len(tet) and
         re.search(r"points +150,", said.stdout) is not None and
         ">150 points, %d tetrahedra" % len(kept) in svg and
         abs(float(re.search(r"volume +(\S+)", said.stdout).group(1)) -
             volume) < 1e-8)
    # the part of places with values is the volume's, about
    part = np.mean(~np.isnan(np.load("a.npy")))
    test("-periodic -alpha %g: values within the shape alone" % R,
         abs(part - volume) < .05)
svg = tess(*periodic, "-alpha", .15, "-draw", "points", "-svg", "a.svg", "p.xyz")
test("-periodic -alpha -draw points: each once",
     len(re.findall(r"M\d+ \d+l", "".join(
         re.findall(r'<path class="[a-e]\d+" d="([^"]*)"',
                    open("a.svg").read())))) == 150)
# one piece, by all its copies
said = tess(*periodic, "-alpha", "auto", "-ele", "a.ele", "p.xyz")
owner = np.array([int(np.argmin(np.abs((a - p + .5) % 1 - .5).sum(1)))
                  for a in x])
facets = {}
for i, t in enumerate(tet):
    for k in range(4):
        v = [t[j] for j in range(4) if j != k]
        # a facet's points, and where they are from the first of them
        v.sort(key=lambda u: owner[u])
        key = tuple(owner[u] for u in v) + tuple(np.round(
            np.concatenate([x[u] - x[v[0]] for u in v]), 6) + 0.0)
        facets.setdefault(key, []).append(i)
neighbours = {i: [] for i in range(len(tet))}
for both in facets.values():
    if len(both) == 2:
        neighbours[both[0]].append(both[1])
        neighbours[both[1]].append(both[0])
for want in sorted(map(root, squares)):
    kept = [i for i, s in enumerate(squares) if s <= Fraction(want) ** 2]
    if len({owner[v] for i in kept for v in tet[i]}) == 150 and \
            pieces(kept, neighbours) == 1:
        break
test("-periodic -alpha auto: one piece across the box's sides",
     all(len(both) == 2 for both in facets.values()) and
     float(re.search(r"alpha +(\S+),", said.stdout).group(1)) == want and
     rows("a.ele") == [tet[i] for i in kept])

# ---- surfaces that are read ----

def surface(name):
    done = common.run("-volumes", "v.csv", name)
    return (re.findall(r"^surface +(.*)$", done.stdout, re.M) + [None])[0]


def write_off(name, points, faces):
    with open(name, "w") as f:
        f.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
        for a in points:
            f.write("%.17g %.17g %.17g\n" % tuple(a))
        for v in faces:
            f.write(" ".join(map(str, [len(v)] + list(v))) + "\n")


cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 2) for x in (0, 3)])
square_faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5],
                [3, 2, 6, 7], [2, 0, 4, 6]]
write_off("box.off", cube, square_faces)
test("surface: a box of squares, OFF",
     surface("box.off") == "12 triangles; closed; its volume is 6")
write_off("open.off", cube, square_faces[:5])
test("surface: a box without a side", surface("open.off") ==
     "10 triangles; not closed: 4 edges have no neighbour there")
write_off("in.off", cube, [v[::-1] for v in square_faces])
test("surface: inside out", surface("in.off") == "12 triangles; closed; its "
     "volume is 6, and its triangles face inwards")
write_off("mixed.off", cube, square_faces[:5] + [square_faces[5][::-1]])
test("surface: a side inside out", surface("mixed.off") == "12 triangles; "
     "closed, but at 4 edges they face different ways: no volume")
write_off("bad.off", cube, square_faces[:5] + [[0, 1, 8]])
test("surface: a point that is not there", surface("bad.off") is None)
write_off("none.off", cube, [])
test("surface: none", surface("none.off") is None)
with open("box.obj", "w") as f:
    f.write("# a box\nmtllib a.mtl\n")
    for a in cube:
        f.write("v %g %g %g\n" % tuple(a))
    f.write("vt 0 0\nvn 0 0 1\n")
    for k, v in enumerate(square_faces):
        f.write("f " + " ".join(
            ["%d" % (i + 1), "%d/1" % (i + 1), "%d/1/1" % (i + 1),
             "%d//1" % (i + 1), "%d" % (i - 8), "%d//1" % (i - 8)][k]
            for i in v) + "\n")
test("surface: a box, OBJ, its corners in all forms",
     surface("box.obj") == "12 triangles; closed; its volume is 6")
try:
    import meshio
    from scipy.spatial import ConvexHull
    x = random.normal(size=(300, 3))
    x = x / np.linalg.norm(x, axis=1)[:, None] * (3, 2, 1) + (100, 200, 5)
    hull = ConvexHull(x)
    f = hull.simplices.copy()
    inward = np.einsum("ij,ij->i", np.cross(
        x[f[:, 1]] - x[f[:, 0]], x[f[:, 2]] - x[f[:, 0]]),
        x[f[:, 0]] - x.mean(0)) < 0
    f[inward] = f[inward][:, ::-1]
    for name, binary, most in (
            ("s.ply", False, 1e-12), ("b.ply", True, 1e-12),
            ("s.obj", None, 1e-12), ("s.off", None, 1e-12),
            ("s.stl", False, 1e-12), ("b.stl", True, 1e-6)):
        meshio.Mesh(x, [("triangle", f)]).write(
            name, **({} if binary is None else {"binary": binary}))
        said = surface(name)
        got = re.fullmatch(r"%d triangles; closed; its volume is (\S+)" % len(f),
                           said or "")
        test("surface, by meshio: %s%s" % (name, ", binary" * bool(binary)),
             got is not None and
             abs(float(got.group(1)) / hull.volume - 1) < most)
except ImportError:
    print("        skipped: surfaces, written by meshio: no meshio")
# what tess writes is closed, and encloses what it says
np.savetxt("c.xyz", random.random((200, 3)), fmt="%.17g")
for end in "off", "ply", "obj", "stl":
    said = tess("-face", "c." + end, "c.xyz").stdout
    volume = float(re.search(r"volume +(\S+)", said).group(1))
    got = re.search("; closed; its volume is (.*)", surface("c." + end) or "")
    test("surface: the hull that tess writes, " + end,
         got is not None and abs(float(got.group(1)) / volume - 1) < 1e-8)
