"""test_cells.py - alpha shapes, Voronoi cells, boxes that repeat themselves, by
build/tess, beside other formulas, SciPy and VTK."""
import csv
import itertools
import os
import random
import re
import struct
import subprocess

import pytest

from common import TOP, build_tess

FLAT = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n"
r = random.Random(7)
SOME = [(r.random(), r.random(), r.random()) for k in range(500)] + [
    (k % 4, k // 4 % 4, k // 16) for k in range(64)]
BOXED = [(r.random(), 2 * r.random(), 3 * r.random() - 1) for k in range(150)]
BOX = "0,1,0,2,-1,2"


def lines(points, times=1.0):
    return "".join("%.17g %.17g %.17g\n" % tuple(x * times for x in p)
                   for p in points)


def cells(path, *columns):
    """of a file of -volumes"""
    with open(path) as f:
        return [[float(row[c]) for c in columns] for row in csv.DictReader(f)]


# ---- sizes of tetrahedra, alpha shapes: by other formulas ----

def rows(name):
    with open(name) as f:
        return [[float(x) for x in l.split()[1:]] for l in f if l[0] != '#'][1:]


def cross(a, b):
    return [a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0]]


def dot(a, b): return sum(x * y for x, y in zip(a, b))


def minus(a, b): return [x - y for x, y in zip(a, b)]


def block(name, title, n):
    head = 'SCALARS %s double 1\nLOOKUP_TABLE default\n' % title
    text = open(name, 'rb').read().split(head.encode())[1]
    return struct.unpack('>%dd' % n, text[:8 * n])


CLOUD = "200 3 0 0\n" + "".join("%d %f %f %f\n" % (
    k, r.random(), r.random(), r.random()) for k in range(200))


@pytest.mark.parametrize("radius", [0.15, 0.3])
def test_alpha_tetrahedra_neighbours_facets_sizes_volume(tess, tmp_path, radius):
    (tmp_path / "cloud.node").write_text(CLOUD)
    tess("-q", "-node", "v.node", "-ele", "v.ele", "-vtk", "v.vtk", "-cells",
         "vc.vtk", "cloud.node")
    done = tess("-alpha", radius, "-ele", "a.ele", "-neigh", "a.neigh", "-vtk",
                "a.vtk", "-face", "a.face", "-svg", "a.svg", "-cells", "ac.vtk",
                "cloud.node")
    # (cells are those of all points)
    assert (tmp_path / "vc.vtk").read_bytes() == (tmp_path / "ac.vtk").read_bytes()
    p = rows('v.node')
    def sizes(t):
        a, b, c = [minus(p[v], p[t[0]]) for v in t[1:]]
        det = dot(a, cross(b, c))
        u = [(dot(a, a) * x + dot(b, b) * y + dot(c, c) * z) / (2 * det)
             for x, y, z in zip(cross(b, c), cross(c, a), cross(a, b))]
        return dot(u, u) ** .5, det / 6
    whole = [[int(x) for x in r] for r in rows('v.ele')]
    part = [[int(x) for x in r] for r in rows('a.ele')]
    size = [sizes(t) for t in whole]
    for name, ele in ('v.vtk', whole), ('a.vtk', part):
        n = len(ele)
        for t, r, v in zip(ele, block(name, 'circumradius', n),
                           block(name, 'volume', n)):
            assert abs(r - sizes(t)[0]) <= 1e-9 * r, (t, r)
            assert abs(v - sizes(t)[1]) <= 1e-12 * max(1, v / 1e-3), (t, v)
    assert part == [t for t, s in zip(whole, size) if s[0] <= radius]
    assert 0 < len(part) < len(whole)
    neigh = [[int(x) for x in r] for r in rows('a.neigh')]
    facets = {}
    for t in part:
        for k in range(4): facets.setdefault(frozenset(t) - {t[k]}, []).append(t)
    shell = [f for f in facets if len(facets[f]) == 1]
    for t, u in zip(part, neigh):
        for k in range(4):
            both = facets[frozenset(t) - {t[k]}]
            assert u[k] < 0 if len(both) == 1 else part[u[k]] in both
            assert u[k] < 0 or part[u[k]] != t
    face = [[int(x) for x in r] for r in rows('a.face')]
    assert sorted(map(sorted, face)) == sorted(map(sorted, shell))
    volume = sum(s[1] for s in size if s[0] <= radius)
    out = sum(dot(p[a], cross(p[b], p[c])) / 6 for a, b, c in face)
    assert abs(out - volume) <= 1e-12 * volume, (out, volume)
    said = {w[0]: w[1] for w in map(str.split, done.out.splitlines()) if w}
    assert int(said['tetrahedra']) == len(part)
    assert int(said['boundary']) == len(shell)
    assert abs(float(said['volume']) - volume) <= 1e-8 * volume


def test_alpha_leaves_nothing(tess, tmp_path):
    done = tess("-alpha", "0.001", "-ele", "a.ele", "-", stdin=CLOUD)
    assert (tmp_path / "a.ele").read_text() == "0 4 0\n"
    assert "nothing is left" in done.err


# ---- Voronoi cells: their volumes sum to the box's; faces by Euler ----

def fills(name, many, whole):
    """VTK reads so many closed polyhedra, of the volumes that it says, the whole in
    all"""
    pytest.importorskip("vtk")
    import numpy
    from beside import by_vtk
    m, points, _, _, sizes, kinds = by_vtk(name)
    volume, n = sizes["volume"], m.GetNumberOfCells()
    assert n == many and set(kinds) == {42} and list(sizes["point"]) == list(range(n))
    for i in range(n):
        c = m.GetCell(i)
        sides, triangles = set(), []
        for f in range(c.GetNumberOfFaces()):
            k = c.GetFace(f).GetPointIds()
            k = [k.GetId(j) for j in range(k.GetNumberOfIds())]
            sides |= set(zip(k, k[1:] + k[:1]))
            triangles += [(k[0], *pair) for pair in zip(k[1:], k[2:])]
        p = points[triangles] - points[triangles[0][0]]
        inside = numpy.linalg.det(p / numpy.cbrt(whole)).sum() * whole / 6
        assert all((b, a) in sides for a, b in sides)
        # Euler
        assert 2 * (c.GetNumberOfPoints() + c.GetNumberOfFaces()) == \
            len(sides) + 4
        assert abs(inside - volume[i]) <= 3e-14 * whole, (i, inside, volume[i])
    assert abs(volume.sum() - whole) <= 1e-12 * whole


# of any size: also where squares of areas are beyond doubles
SIZED = pytest.mark.parametrize("e, points", [(0, SOME)] + [
    (e, SOME[300:]) for e in (-100, -80, 80, 100)], ids=["0", "-100", "-80", "80", "100"])


@SIZED
def test_cells_fill_their_box(tess, tmp_path, e, points):
    (tmp_path / "some").write_text(lines(points))
    (tmp_path / "sized").write_text(lines(points, float("1e%d" % e)))
    tess("-q", "-volumes", "some.csv", "some")
    tess("-q", "-cells", "cells.vtk", "-volumes", "sized.csv", "sized")
    whole = [a[0] * 10.0 ** (2 * e) for a in cells("some.csv", "area")]
    assert [a[0] for a in cells("sized.csv", "area")] == pytest.approx(whole, rel=1e-9)
    assert len(whole) == len(points)
    fills("cells.vtk", len(points), float("27e%d" % (3 * e)))


@SIZED
def test_cells_fill_a_box_that_repeats_itself(tess, tmp_path, e, points):
    (tmp_path / "sized").write_text(lines(points, float("1e%d" % e)))
    tess("-q", "-cells", "cells.vtk", "-periodic", "-box", ",".join(
        3 * ["0,4e%d" % e]), "sized")
    fills("cells.vtk", len(points), float("64e%d" % (3 * e)))


def test_cells_fill_a_box_that_is_given(tess):
    tess("-q", "-cells", "cells.vtk", "-box", "-.5,3.5,0,3.25,0,3", "-",
         stdin=lines(SOME))
    fills("cells.vtk", 564, 39)


@pytest.mark.parametrize("kind", ["periodic", "clipped"])
@pytest.mark.parametrize("scale", ["1,1,1", "2,1,0.25"])
def test_volumes_and_faces_are_scipy_s(tess, tmp_path, kind, scale):
    numpy = pytest.importorskip("numpy")
    pytest.importorskip("scipy")
    from scipy.spatial import ConvexHull, Voronoi
    periodic = kind == "periodic"
    (tmp_path / "valued.csv").write_text("".join("%r,%r,%r,%d,a %d\n" % (
        *p, 5 * k, k) for k, p in enumerate(BOXED)))
    done = tess("-volumes", "cells.csv", "-faces", "faces.csv",
                *["-periodic"] * periodic, "-scale", scale, "-box", BOX, "valued.csv")
    box = numpy.array([float(x) for x in BOX.split(',')]).reshape(3, 2)
    scale = numpy.array([float(x) for x in scale.split(',')])
    rows = [l.split(',') for l in open('cells.csv').read().splitlines()]
    assert rows.pop(0) == ['x', 'y', 'z', 'volume', 'faces', 'point', 'area',
                           'neighbours', 'value', 'cx', 'cy', 'cz', 'name']
    assert [r.pop() for r in rows] == ['"a %d"' % i for i in range(len(rows))]
    a = numpy.array([r[:7] + r[8:] for r in rows], float)
    assert (a[:, 5] == range(len(a))).all()
    assert (a[:, 7] == 5 * a[:, 5]).all()
    p = a[:, :3]
    assert (p == numpy.array(BOXED)).all()
    all, n = p, len(p)
    who = numpy.arange(n)
    for k in range(3):
        more = [all]
        name = [who]
        for side in 0, 1:
            other = all.copy()
            if periodic: other[:, k] += (2 * side - 1) * (box[k, 1] - box[k, 0])
            else: other[:, k] = 2 * box[k, side] - all[:, k]
            more.append(other)
            name.append(who if periodic else 0 * who - 1 - 2 * k - side)
        all = numpy.concatenate(more)
        who = numpy.concatenate(name)
    # (those that are far away have no part in the cells)
    far = 3 * (scale * numpy.ptp(box, 1)).prod() ** (1 / 3) / n ** (1 / 3)
    near = (abs(all - box.mean(1)) * scale < scale * numpy.ptp(box, 1) / 2 + far).all(1)
    all, who = all[near], who[near]
    v = Voronoi(all * scale)
    vertices = v.vertices / scale
    faces = numpy.zeros(n, int)
    beside = [[] for i in range(n)]
    def key(i, j, s):
        return (int(i), int(j)) + tuple(int(k) for k in numpy.rint(s))
    wall = {}
    for (i, j), corners in zip(v.ridge_points, v.ridge_vertices):
        if min(i, j) >= n:
            continue
        q = vertices[corners]
        normal = numpy.cross(q[1:-1] - q[0], q[2:] - q[0]) / 2
        size = numpy.linalg.norm(normal, axis=1)
        normal = normal.sum(0)
        middle = (q[1:-1] + q[2:] + q[0]).T.dot(size) / size.sum() / 3
        for i, j in (i, j), (j, i):
            if i < n:
                faces[i] += 1
                beside[i].append(who[j])
                away = all[j] - p[who[j]] if periodic else numpy.zeros(3)
                out = normal * numpy.sign(normal.dot(q[0] - p[i]))
                wall[key(i, who[j], away)] = out, middle
    f = numpy.loadtxt('faces.csv', delimiter=',', skiprows=1)
    once = [key(r[0], r[1], r[9:]) for r in f]
    again = [key(r[1], r[0], -r[9:]) for r in f if r[1] >= 0]
    assert len(once) + len(again) == len(wall) and set(once + again) == set(wall)
    for r, k in zip(f, once):
        normal, middle = wall[k]
        assert abs(r[2] * r[6:9] - normal).max() < 1e-12
        assert abs(r[2] * (r[3:6] - middle)).max() < 1e-12
        assert abs(numpy.linalg.norm(r[6:9]) - 1) < 1e-15
    hull = [ConvexHull(vertices[v.regions[v.point_region[i]]]) for i in range(n)]
    for h, centre in zip(hull, a[:, 8:]):
        q = h.points[h.simplices] - h.points.mean(0)
        size = abs(numpy.linalg.det(q))
        middle = (q.sum(1) / 4).T.dot(size) / size.sum() + h.points.mean(0)
        assert abs(centre - middle).max() < 1e-12, (centre, middle)
    volume = [h.volume for h in hull]
    area = numpy.array([h.area for h in hull])
    assert abs(a[:, 6] / area - 1).max() < 1e-9, abs(a[:, 6] / area - 1).max()
    for i in range(n):
        assert sorted(int(j) for j in rows[i][7].split()) == sorted(beside[i]), i
    assert abs(a[:, 3] / volume - 1).max() < 1e-9, abs(a[:, 3] / volume - 1).max()
    assert (a[:, 4] == faces).all()
    whole = (box[:, 1] - box[:, 0]).prod()
    said = [l for l in done.out.splitlines() if l.startswith('cells')][0].split()
    assert abs(float(said[6][:-1]) - whole) <= 1e-12 * whole, said
    assert abs(float(said[10]) - whole) <= 1e-12 * whole, said


def test_points_outside_a_periodic_box_have_copies_inside(tess, tmp_path):
    (tmp_path / "far").write_text(lines(
        (x + k % 3 - 1, y - 2 * (k % 2), z + 6) for k, (x, y, z) in enumerate(BOXED)))
    (tmp_path / "boxed").write_text(lines(BOXED))
    assert "outside" in tess("-volumes", "far.csv", "-periodic", "-box", BOX,
                             "far").err
    tess("-q", "-volumes", "near.csv", "-periodic", "-box", BOX, "boxed")
    near, far = (cells(f, "volume", "faces") for f in ("near.csv", "far.csv"))
    assert len(near) == len(far) == 150
    for a, b in zip(near, far):
        assert abs(a[0] - b[0]) <= 1e-12 and a[1] == b[1]


def test_duplicate_has_no_cell(tess, tmp_path):
    tess("-q", "-volumes", "twin.csv", "-", stdin=lines(SOME + SOME[4:5]))
    assert (tmp_path / "twin.csv").read_text().endswith(",0,0,564,0,,nan,nan,nan\n")


def test_points_in_a_plane_have_cells_where_the_box_repeats(tess):
    assert "sum to 4; the box's is 4\n" in tess(
        "-periodic", "-box", "0,2,0,2,0,1", "-volumes", "flat.csv", "-",
        stdin=FLAT).out


def test_box_without_cells_is_told(tess):
    assert "for -cells, -volumes, -faces and -per" in tess(
        "-box", "0,1,0,1,0,1", "-", stdin=lines(BOXED)).err


@pytest.mark.parametrize("option", ["-validate 5", "-grid 3,3 -values no.csv"])
def test_periodic_is_not_for_these(tess, option):
    done = tess("-periodic", "-box", BOX, *option.split(), "-", stdin=lines(BOXED))
    assert done.code != 0 and "-periodic" in done.err


# ---- cells of any shape, along some vectors or all ----

def read_values(name):
    import numpy
    return numpy.genfromtxt(name, delimiter=',', skip_header=1)


@pytest.mark.parametrize("n, ways", [(2, "111"), (3, "111"), (3, "110"), (120, "111"),
                                     (120, "110"), (120, "001")])
def test_what_repeats_itself_is_scipy_s_of_its_copies(tess, tmp_path, n, ways):
    """cells and their mesh, values by all methods"""
    numpy = pytest.importorskip("numpy")
    pytest.importorskip("scipy")
    from scipy.interpolate import LinearNDInterpolator
    from scipy.spatial import ConvexHull, Voronoi, cKDTree
    random = numpy.random.default_rng(3)
    short = numpy.array([[2, 0, 0], [.9, 1.8, 0], [-.5, .6, 1.7]])
    ways = numpy.array([int(w) for w in ways])
    origin = numpy.array([-1, .5, 3.])
    p = random.random((n, 3)) @ short + origin
    q = random.random((400, 3)) @ short + origin
    value = random.random(n)
    # the same lattice, by long vectors; points some of them away; upright ones
    # where nothing repeats itself, so that the cells' sides stay the same
    vectors = short.copy()
    if ways.all():
        vectors[1] += 7 * vectors[0]
        vectors[2] -= 5 * vectors[1]
    away = random.integers(-3, 4, (n, 3)) * ways @ short
    with open('repeat.xyz', 'w') as f:
        f.write('%d\nLattice="%s" Origin="%s" pbc="%s" Properties=pos:R:3:u:R:1\n' %
                (n, ' '.join(map(repr, map(float, vectors.flat))),
                 ' '.join(map(str, origin)), ' '.join('FT'[w] for w in ways)))
        numpy.savetxt(f, numpy.c_[p + away, value], fmt='%.17g')
    numpy.savetxt('places', q + random.integers(-9, 9, (400, 3)) * ways @ short,
                  fmt='%.17g')
    tess('-q', '-periodic', '-volumes', 'v.csv', '-node', 'r.node', '-ele', 'r.ele',
         '-faces', 'f.csv', 'repeat.xyz')
    far = 2 if n > 100 else 3
    shift = [s for s in itertools.product(range(-far, far + 1), repeat=3)
             if not ((1 - ways) * s).any()]
    shift.sort(key=lambda s: numpy.abs(s).max())
    copies = (p + (numpy.array(shift) @ short)[:, None]).reshape(-1, 3)
    # (of many points the next copies alone have a part in cells)
    near = copies[:n * sum(max(map(abs, s)) < (2 if n > 100 else 4) for s in shift)]
    mirrored = [near]
    for k in numpy.flatnonzero(1 - ways):
        normal = numpy.linalg.inv(vectors)[:, k]
        height = (near - origin) @ normal
        for side in 0, 1:
            mirrored.append(near - 2 * (height - side)[:, None] * normal /
                            (normal @ normal))
    v = Voronoi(numpy.concatenate(mirrored))
    cells = [ConvexHull(v.vertices[v.regions[v.point_region[i]]])
             for i in range(n)]
    a = numpy.atleast_2d(numpy.genfromtxt('v.csv', delimiter=',', skip_header=1,
                                          usecols=(3, 6)))
    for k, right in enumerate(([c.volume for c in cells], [c.area for c in cells])):
        assert abs(a[:, k] / right - 1).max() < 1e-9, abs(a[:, k] / right - 1).max()
    whole = abs(numpy.linalg.det(short))
    assert abs(a[:, 0].sum() / whole - 1) < 1e-12
    # of faces, which come once, those of a cell close it, around its volume; the
    # neighbour, a lattice vector away from where it is given, is beyond
    closed = numpy.zeros((n, 4))
    for row in numpy.loadtxt('f.csv', delimiter=',', skiprows=1):
        i, j = row[:2].astype(int)
        area, x, normal, s = row[2], row[3:6], row[6:9], row[9:]
        at = (p + away)[[i, max(j, 0)]]
        closed[i] += numpy.append(area * normal, area * normal.dot(x - at[0]) / 3)
        if j < 0:
            assert (s == 0).all() and not ways[(-1 - j) // 2]
            continue
        at[1] += s
        closed[j] += numpy.append(-area * normal, area * normal.dot(at[1] - x) / 3)
        count = s @ numpy.linalg.inv(short)
        assert abs(count - numpy.rint(count)).max() < 1e-12
        assert abs(numpy.cross(at[1] - at[0], normal)).max() < 1e-13
        assert abs(area * normal.dot(2 * x - at[0] - at[1])) < 1e-12
    closed[:, 3] -= a[:, 0]
    assert abs(closed).max() < 1e-12, abs(closed).max()
    # the mesh: balls without points, as large as the cell
    node = numpy.loadtxt('r.node', skiprows=1)[:, 1:4]
    assert (node[:n] == p + away).all()
    x = node[numpy.loadtxt('r.ele', skiprows=1, ndmin=2)[:, 1:5].astype(int)]
    edge = x[:, 1:] - x[:, :1]
    volume = numpy.linalg.det(edge) / 6
    assert (volume > 0).all()
    if ways.all(): assert abs(volume.sum() / whole - 1) < 1e-12, volume.sum()
    if ways.all():
        middle = numpy.linalg.solve(edge, (edge ** 2).sum(2)[:, :, None] / 2)[:, :, 0]
        radius = numpy.sqrt((middle ** 2).sum(1))
        middle += x[:, 0] - origin
        middle -= numpy.floor(middle @ numpy.linalg.inv(short)) @ short
        away = cKDTree(copies).query(middle + origin)[0]
        assert abs(away / radius - 1).max() < 1e-9, abs(away / radius - 1).max()
    # values
    many = numpy.tile(value, len(shift))
    numpy.savetxt('copies', numpy.c_[copies, many], fmt='%.17g')
    numpy.savetxt('inside', q, fmt='%.17g')
    for method in 'linear', 'natural', 'nearest', 'smooth':
        # (gradients depend on points many edges away)
        if method == 'smooth' and (n < 100 or not ways.all()): continue
        tess('-q', '-periodic', '-query', 'places', '-qcols', '1,2,3', '-values',
             'here.csv', '-method', method, 'repeat.xyz')
        here = read_values('here.csv')[:, 3]
        assert not numpy.isnan(here).any() or not ways.all()
        if method == 'linear':
            some = near if ways.all() else copies
            there = LinearNDInterpolator(some, many[:len(some)])(q)
        elif method == 'nearest':
            there = many[cKDTree(copies).query(q)[1]]
            there[numpy.isnan(here)] = numpy.nan
        else:
            tess('-q', '-query', 'inside', '-qcols', '1,2,3', '-values', 'there.csv',
                 '-method', method, '-cols', '1,2,3,4', 'copies')
            there = read_values('there.csv')[:, 3]
        assert (numpy.isnan(here) == numpy.isnan(there)).all()
        # (a gradient has 1e-4 of the one that suits all copies)
        limit = 1e-10 if method != 'smooth' else 1e-5
        worst = numpy.nanmax(abs(here - there))
        assert worst < limit, (method, worst)
    tess('-q', '-periodic', '-grid', '5,6,7', '-values', 'grid.csv', 'repeat.xyz')
    grid = read_values('grid.csv')[:, :3]
    low = numpy.minimum(vectors, 0).sum(0) + origin
    high = numpy.maximum(vectors, 0).sum(0) + origin
    assert abs(grid.min(0) - low).max() < 1e-12 * abs(high - low).max()
    assert abs(grid.max(0) - high).max() < 1e-12 * abs(high - low).max()


# lattices, of which all is a tie: primitive cells of 1 point
@pytest.mark.parametrize("vectors, whole", [
    ("0 1 1 1 0 1 1 1 0", 2), ("-1 1 1 1 -1 1 1 1 -1", 4), ("2 0 0 1 2 0 0 1 2", 8),
    ("3 0 0 0 3 0 0 0 3", 27)])
def test_lattice_of_one_point(tess, tmp_path, vectors, whole):
    (tmp_path / "f.xyz").write_text(
        '1\nLattice="%s" Properties=pos:R:3:u:R:1\n.3 .2 .1 7\n' % vectors)
    done = tess("-periodic", "-check", "-volumes", "v.csv", "-grid", "9,9,9",
                "-values", "f.csv", "f.xyz")
    assert "proven" in done.out
    assert cells("v.csv", "volume") == [[pytest.approx(whole, abs=1e-12)]]
    values = cells("f.csv", "u")
    assert len(values) == 729
    assert max(abs(v[0] - 7) for v in values) < 1e-12


# ---- what is refused ----

@pytest.mark.parametrize("text, options, words", [
    (FLAT, "", "no cells: the points do not span space"),
    (lines(BOXED), "-box 0,1,0,1,0", "-box needs X0,X1,Y0,Y1,Z0,Z1"),
    (lines(BOXED), "-box 0,1,0,1,1,0", "-box needs X0,X1,Y0,Y1,Z0,Z1"),
    (lines(BOXED), "-box 0,1,0,1,0,0", "-box needs X0,X1,Y0,Y1,Z0,Z1"),
    (lines(BOXED), "-periodic", "-periodic needs -box X0,X1,Y0,Y1,Z0,Z1, or"),
    ("0 0 0\n", "-periodic -box 0,64,0,1,0,1", "so few points in so long a box"),
    (lines(SOME, 1e-110), "", "use other units"),
    (lines(SOME, 1e110), "", "use other units"),
    (lines(SOME, 1e-300), "-periodic -box 0,4e-300,0,4e-300,0,4e-300",
     "use other units")], ids=[
         "flat", "five numbers", "upside down", "no height", "no box", "long",
         "small", "large", "smaller"])
def test_cells_are_refused(tess, text, options, words):
    done = tess("-volumes", "no.csv", *options.split(), "-", stdin=text)
    assert done.code == 2 and words in done.err and not os.path.exists("no.csv")
    # (before anything is computed)
    assert "needs" not in words or done.out == ""


def test_volumes_that_are_wrong_are_noticed(tmp_path):
    """by a build in which they are so by 1e-8"""
    code, n = re.subn(r"  *volume \+= area.j.*?(?=;)", r"\g<0> * 1.00000001",
                      (TOP / "test/recipes/cells.c").read_text())
    assert n > 0
    (tmp_path / "cells.c").write_text(code)
    (tmp_path / "boxed").write_text(lines(BOXED))
    assert build_tess(tmp_path / "wrong", (), "-O1", "-Itest/recipes",
                      more=[tmp_path / "cells.c"]).returncode == 0
    done = subprocess.run(["./wrong", "-volumes", "no.csv", "boxed"], text=True,
                          capture_output=True)
    assert done.returncode == 2 and not os.path.exists("no.csv")
    assert re.search("volumes sum to .* but the box's is", done.stderr)
