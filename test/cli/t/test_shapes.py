"""test_shapes.py - alpha shapes by build/tess, beside exact fractions and brute force;
surfaces that it reads."""
import collections
import re
from fractions import Fraction

import pytest

from beside import BOX, chance, np, save, scipy, text


def rows(name):
    with open(name) as f:
        lines = [line.split() for line in f if line[0] != "#"]
    return [[int(x) for x in line[1:]] for line in lines[1:]]


def square(p):
    """Of the circumradius of four points, exactly."""
    p = np.array([[Fraction(float(x)) for x in q] for q in p])
    e = p[1:] - p[0]
    f = [np.cross(e[k - 2], e[k - 1]) for k in range(3)]
    n = sum(a @ a * b for a, b in zip(e, f))
    return n @ n / (2 * e[0] @ f[0]) ** 2


def root(r):
    """The least double whose square is not less."""
    x = float(r) ** .5
    while Fraction(x) ** 2 >= r:
        x = np.nextafter(x, 0)
    while Fraction(x) ** 2 < r:
        x = np.nextafter(x, np.inf)
    return float(x)


def least(squares, corners, neighbours):
    """The least number that leaves one piece with all points; what it leaves."""
    piece, pieces, points = {}, 0, set()

    def find(i):
        while piece[i] != i:
            i = piece[i]
        return i

    groups = collections.defaultdict(list)
    for i, r in enumerate(squares):
        groups[root(r)].append(i)
    for radius in sorted(groups):
        for i in groups[radius]:
            piece[i] = i
            pieces += 1
            points.update(corners[i])
            for u in neighbours[i]:
                if u in piece and find(u) != find(i):
                    piece[find(u)] = find(i)
                    pieces -= 1
        if pieces == 1 and points == set().union(*map(set, corners)):
            return radius, sorted(piece)
    assert False


def manifold(face):
    """How many edges have more than two triangles, and how many points fans
    that share no edge."""
    edge = collections.Counter(frozenset((f[k], f[(k + 1) % 3])) for f in face
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


@pytest.fixture
def shape(run):
    """run, where nothing is told of sides that differ"""
    return lambda *words: run("-scale", "1,1,1", *words)


def alpha(said):
    """the number of -alpha auto"""
    return float(re.search(r"(?m)^alpha +(\S+), the least that leaves one piece",
                           said.out)[1])


def test_alpha_is_exact(shape, everything):
    """-alpha R: exactly those whose circumradius is not larger; -alpha auto: the least
    number that leaves one piece with all points; where the surface is no manifold"""
    random, warned = chance(1), set()
    for case in range(24 if everything else 8):
        p = random.random(((30, 60)[case // 4 % 2], 3))
        if case % 4 == 1:
            p = np.round(p * 4) / 2  # of a lattice, with duplicates
        if case % 4 == 2:
            p = np.round(p * (1000, 1000, 50) + (512345, 7654321, 0), 3)
        if case % 4 == 3:
            p[::2] += 3
        save("a.xyz", p, names="", between=" ")
        shape("-q", "-ele", "v.ele", "-neigh", "v.neigh", "a.xyz")
        tet = rows("v.ele")
        squares = [square(p[t]) for t in tet]
        want, kept = least(squares, tet, rows("v.neigh"))
        said = shape("-alpha", "auto", "-ele", "a.ele", "-face", "a.face", "a.xyz")
        assert alpha(said) == want and rows("a.ele") == [tet[i] for i in kept], case
        edges, touch = manifold(rows("a.face"))
        word = re.search(r"no manifold: more than two triangles meet at (\d+) edge"
                         r"s?, parts of it touch at (\d+) point", said.err)
        assert (edges, touch) == (tuple(map(int, word.groups())) if word else (0, 0))
        warned |= {(edges > 0, touch > 0)}
        # radii that are some tetrahedron's, the next double below, and others
        for r in random.choice(squares, 6):
            for R in root(r), np.nextafter(root(r), 0):
                shape("-q", "-alpha", repr(float(R)), "-ele", "a.ele", "a.xyz")
                assert rows("a.ele") == [t for t, s in zip(tet, squares)
                                         if s <= Fraction(float(R)) ** 2], (case, R)
    assert {(False, False), (True, False)} <= warned


@pytest.mark.parametrize("at", [(0, 0, 0), (512345, 7654321, 1000), (1e9, 0, 0)])
def test_ball_of_exactly_the_radius(shape, at):
    """sides 1, 2, 2 have the diagonal 3"""
    save("box.xyz", BOX * (1, 2, 2) + at, names="", between=" ")
    kept = []
    for more in [], ["-alpha", "1.5"], ["-alpha", repr(float(np.nextafter(1.5, 0)))]:
        shape("-q", *more, "-ele", "a.ele", "box.xyz")
        kept.append(len(rows("a.ele")))
    assert kept[0] > 4 and kept == [kept[0], kept[0], 0]


def test_parts_that_touch_at_a_point(shape):
    """two tetrahedra that share a corner alone"""
    one = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 0, 1]])
    save("two.xyz", np.vstack((one, -one[1:])), names="", between=" ")
    said = shape("-alpha", .9, "-face", "a.face", "two.xyz")
    assert "at 0 edges, parts of it touch at 1 point;" in said.err
    assert manifold(rows("a.face")) == (0, 1)


# ---- what repeats itself ----

PERIODIC = "-periodic", "-box", "2,3,0,1,0,1"
P = chance(1).random((150, 3)) + (2, 0, 0)


@pytest.fixture
def repeated(shape):
    """a mesh that repeats itself: its points, tetrahedra, and circumradii squared"""
    save("p.xyz", P, P[:, 0], names="", between=" ")
    shape("-q", *PERIODIC, "-node", "v.node", "-ele", "v.ele", "p.xyz")
    with open("v.node") as f:
        x = np.array([line.split()[1:4] for line in f][1:], float)
    tet = rows("v.ele")
    return x, tet, [square(x[t]) for t in tet]


def sizes(x, tet):
    return [np.linalg.det(x[t[1:]] - x[t[0]]) / 6 for t in tet]


def test_alpha_of_what_repeats_itself(shape, repeated):
    """the cell's tetrahedra, each once; points once; values within the shape alone"""
    x, tet, squares = repeated
    assert abs(sum(sizes(x, tet)) - 1) < 1e-12
    for R in .12, .15, .2:
        said = shape(*PERIODIC, "-alpha", R, "-ele", "a.ele", "-grid", "12,12,12",
                     "-values", "a.npy", "-svg", "a.svg", "p.xyz")
        kept = [t for t, s in zip(tet, squares) if s <= Fraction(R) ** 2]
        volume = sum(sizes(x, kept))
        assert rows("a.ele") == kept and 0 < len(kept) < len(tet)
        assert re.search(r"points +150,", said.out)
        assert ">150 points, %d tetrahedra" % len(kept) in text("a.svg")
        assert abs(float(re.search(r"volume +(\S+)", said.out)[1]) - volume) < 1e-8
        # the part of places with values is the volume's, about
        assert abs(np.mean(~np.isnan(np.load("a.npy"))) - volume) < .05
    shape(*PERIODIC, "-alpha", .15, "-draw", "points", "-svg", "a.svg", "p.xyz")
    dots = re.findall(r'<path class="[a-e]\d+" d="([^"]*)"', text("a.svg"))
    assert len(re.findall(r"M\d+ \d+l", "".join(dots))) == 150


def test_alpha_auto_is_one_piece_across_the_box_s_sides(shape, repeated):
    """by all its copies"""
    x, tet, squares = repeated
    said = shape(*PERIODIC, "-alpha", "auto", "-ele", "a.ele", "p.xyz")
    owner = np.array([int(np.argmin(np.abs((a - P + .5) % 1 - .5).sum(1))) for a in x])
    facets = collections.defaultdict(list)
    for i, t in enumerate(tet):
        for k in range(4):
            # a facet's points, and where they are from the first of them
            v = sorted(t[:k] + t[k + 1:], key=lambda u: owner[u])
            facets[tuple(owner[v]) + tuple(np.round(
                np.concatenate(x[v] - x[v[0]]), 6) + 0.0)].append(i)
    assert all(len(both) == 2 for both in facets.values())
    neighbours = collections.defaultdict(list)
    for i, k in facets.values():
        neighbours[i].append(k)
        neighbours[k].append(i)
    want, kept = least(squares, [owner[t] for t in tet], neighbours)
    assert alpha(said) == want and rows("a.ele") == [tet[i] for i in kept]


# ---- surfaces that are read ----

@pytest.fixture
def surface(tess):
    """surface(name): what is told of it, or None"""
    return lambda name: (re.findall(r"^surface +(.*)$", tess("-volumes", "v.csv", name).out,
                                    re.M) + [None])[0]


CUBE = BOX * (3, 2, 1)
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]]


@pytest.mark.parametrize("told, faces", [
    ("12 triangles; closed; its volume is 6", SIDES),
    ("10 triangles; not closed: 4 edges have no neighbour there", SIDES[:5]),
    ("12 triangles; closed; its volume is 6, and its triangles face inwards",
     [v[::-1] for v in SIDES]),
    ("12 triangles; closed, but at 4 edges they face different ways: no volume",
     SIDES[:5] + [SIDES[5][::-1]]),
    (None, SIDES[:5] + [[0, 1, 8]]), (None, [])], ids=[
        "box", "open", "inside out", "a side inside out", "a point that is not there",
        "none"])
def test_surface_of_a_box(surface, tmp_path, told, faces):
    (tmp_path / "box.off").write_text("OFF\n%d %d 0\n" % (8, len(faces)) + "".join(
        "%g %g %g\n" % tuple(a) for a in CUBE) + "".join(
            " ".join(map(str, [len(v)] + v)) + "\n" for v in faces))
    assert surface("box.off") == told


def test_surface_whose_corners_have_all_forms(surface, tmp_path):
    forms = [lambda i: "%d" % (i + 1), lambda i: "%d/1" % (i + 1),
             lambda i: "%d/1/1" % (i + 1), lambda i: "%d//1" % (i + 1),
             lambda i: "%d" % (i - 8), lambda i: "%d//1" % (i - 8)]
    (tmp_path / "box.obj").write_text(
        "# a box\nmtllib a.mtl\n" + "".join("v %g %g %g\n" % tuple(a) for a in CUBE) +
        "vt 0 0\nvn 0 0 1\n" + "".join("f " + " ".join(map(form, v)) + "\n"
                                       for form, v in zip(forms, SIDES)))
    assert surface("box.obj") == "12 triangles; closed; its volume is 6"


@pytest.mark.parametrize("ending, binary, most", [
    ("ply", False, 1e-12), ("ply", True, 1e-12), ("obj", None, 1e-12),
    ("off", None, 1e-12), ("stl", False, 1e-12), ("stl", True, 1e-6)])
def test_surface_by_meshio(surface, ending, binary, most):
    meshio = pytest.importorskip("meshio")
    x = chance(2).normal(size=(300, 3))
    x = x / np.linalg.norm(x, axis=1)[:, None] * (3, 2, 1) + (100, 200, 5)
    hull = scipy().spatial.ConvexHull(x)
    f = hull.simplices.copy()
    inward = np.einsum("ij,ij->i", np.cross(
        x[f[:, 1]] - x[f[:, 0]], x[f[:, 2]] - x[f[:, 0]]), x[f[:, 0]] - x.mean(0)) < 0
    f[inward] = f[inward][:, ::-1]
    meshio.Mesh(x, [("triangle", f)]).write(
        "s." + ending, **({} if binary is None else {"binary": binary}))
    got = re.fullmatch(r"%d triangles; closed; its volume is (\S+)" % len(f),
                       surface("s." + ending) or "")
    assert abs(float(got[1]) / hull.volume - 1) < most


@pytest.mark.parametrize("ending", ["off", "ply", "obj", "stl"])
def test_hull_that_is_written_is_closed_and_has_its_volume(run, surface, ending):
    save("c.xyz", chance(3).random((200, 3)), names="", between=" ")
    volume = float(re.search(r"volume +(\S+)", run("-face", "c." + ending, "c.xyz").out)[1])
    got = re.search("; closed; its volume is (.*)", surface("c." + ending) or "")
    assert abs(float(got[1]) / volume - 1) < 1e-8
