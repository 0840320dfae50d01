#!/bin/sh
# t_cells.sh - tests of build/tess: alpha shapes, Voronoi cells, boxes that
# repeat themselves.
# shellcheck disable=SC2034 # of common.sh
NAME=cells
. test/cli/t/common.sh

# ---- sizes of tetrahedra, alpha shapes: by other formulas ----

cat > alpha.py << END
import struct, sys
def rows(name):
    r = [[float(x) for x in l.split()] for l in open(name) if l[0] != '#']
    return [a[1:] for a in r[1:]]
def cross(a, b):
    return [a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0]]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def minus(a, b): return [x - y for x, y in zip(a, b)]
def block(name, title, n):
    head = 'SCALARS %s double 1\\nLOOKUP_TABLE default\\n' % title
    text = open(name, 'rb').read().split(head.encode())[1]
    return struct.unpack('>%dd' % n, text[:8 * n])
p = rows('v.node')
def sizes(t):
    a, b, c = [minus(p[v], p[t[0]]) for v in t[1:]]
    det = dot(a, cross(b, c))
    u = [(dot(a, a) * x + dot(b, b) * y + dot(c, c) * z) / (2 * det)
         for x, y, z in zip(cross(b, c), cross(c, a), cross(a, b))]
    return dot(u, u) ** .5, det / 6
radius = float(sys.argv[1])
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
said = {l.split()[0]: l.split()[1] for l in open('said')}
assert int(said['tetrahedra']) == len(part)
assert int(said['boundary']) == len(shell)
assert abs(float(said['volume']) - volume) <= 1e-8 * volume
END
awk 'BEGIN { srand(5); print 200, 3, 0, 0
    for (i = 0; i < 200; i++) print i, rand(), rand(), rand() }' > cloud.node
$TESS -q -node v.node -ele v.ele -vtk v.vtk cloud.node
for radius in 0.15 0.3; do
    $TESS -alpha $radius -ele a.ele -neigh a.neigh -vtk a.vtk -face a.face \
        -svg a.svg -cells ac.vtk cloud.node > said
    yes "-alpha $radius: tetrahedra, neighbours, facets, sizes, volume" \
        $PYTHON alpha.py $radius
done
$TESS -q -cells vc.vtk cloud.node
yes "-alpha: cells are those of all points" cmp vc.vtk ac.vtk
$TESS -alpha 0.001 -ele a.ele cloud.node > said 2> words
yes "-alpha: nothing left" sh -c \
    'test "`cat a.ele`" = "0 4 0" && grep "nothing is left" words' > /dev/null

# ---- Voronoi cells: their volumes sum to the box's; faces by Euler ----

awk 'BEGIN { srand(7); for (i = 0; i < 500; i++) print rand(), rand(), rand()
    for (i = 0; i < 64; i++) print i % 4, int(i / 4) % 4, int(i / 16) }' > some
# fills NAME N VOLUME: VTK reads N closed polyhedra in cells.vtk, of the volumes
# that it says, VOLUME in all.  (All files in one process, at the end)
rm -f filled
fills() {
    mv cells.vtk "filled$2-$3.vtk"
    echo "filled$2-$3.vtk $2 $3 $1" >> filled
}
$TESS -q -cells cells.vtk some
fills "-cells: as many as points, and they fill the box" 564 27
$TESS -q -cells cells.vtk -box -.5,3.5,0,3.25,0,3 some
fills "-cells -box: they fill that box" 564 39
$TESS -q -cells cells.vtk -periodic -box 0,4,0,4,0,4 some
fills "-cells -periodic: they fill the box" 564 64
# of any size: also where squares of areas are beyond doubles
$TESS -q -volumes some.csv some
for e in -100 -80 80 100; do
    awk '{ printf "%.17g %.17g %.17g\n", $1 * s, $2 * s, $3 * s }' s=1e$e some \
        > sized
    rm -f cells.vtk
    $TESS -q -cells cells.vtk -volumes sized.csv sized
    yes "-volumes: areas are right, 1e$e" awk -F, -v s=1e$((2 * e)) '
        FNR == 1 { next }
        NR == FNR { a[FNR] = $7 * s; next }
        !($7 > a[FNR] * (1 - 1e-9) && $7 < a[FNR] * (1 + 1e-9)) { bad = 1 }
        END { exit bad || FNR != 565 }' some.csv sized.csv
    fills "-cells: they fill the box, 1e$e" 564 27e$((3 * e))
    rm -f cells.vtk
    $TESS -q -cells cells.vtk -periodic -box 0,4e$e,0,4e$e,0,4e$e sized
    fills "-cells -periodic: they fill the box, 1e$e" 564 64e$((3 * e))
done
cat > voronoi.py << END
import sys, itertools, numpy
from scipy.spatial import Voronoi, ConvexHull
periodic = sys.argv[1] == 'periodic'
box = numpy.array([float(x) for x in sys.argv[2].split(',')]).reshape(3, 2)
scale = numpy.array([float(x) for x in sys.argv[3].split(',')])
rows = [l.split(',') for l in open('cells.csv').read().splitlines()]
assert rows.pop(0) == ['x', 'y', 'z', 'volume', 'faces', 'point', 'area',
                       'neighbours', 'value', 'cx', 'cy', 'cz', 'name']
assert [r.pop() for r in rows] == ['"a %d"' % i for i in range(len(rows))]
a = numpy.array([r[:7] + r[8:] for r in rows], float)
assert (a[:, 5] == range(len(a))).all()
assert (a[:, 7] == 5 * a[:, 5]).all()
p = a[:, :3]
assert (p == numpy.loadtxt('boxed')).all()
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
v = Voronoi(all * scale)
vertices = v.vertices / scale
faces = numpy.zeros(n, int)
beside = [[] for i in range(n)]
def key(i, j, s):
    return (int(i), int(j)) + tuple(int(k) for k in numpy.rint(s))
wall = {}
for (i, j), corners in zip(v.ridge_points, v.ridge_vertices):
    for i, j in (i, j), (j, i):
        if i < n:
            faces[i] += 1
            beside[i].append(who[j])
            q = vertices[corners]
            normal = numpy.cross(q - q[0], numpy.roll(q, -1, 0) - q[0]) / 2
            size = numpy.linalg.norm(normal, axis=1)
            normal = normal.sum(0)
            normal *= numpy.sign(normal.dot(q[0] - p[i]))
            middle = (q + numpy.roll(q, -1, 0) + q[0]) / 3
            away = all[j] - p[who[j]] if periodic else numpy.zeros(3)
            wall[key(i, who[j], away)] = (normal,
                                          middle.T.dot(size) / size.sum())
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
said = [l for l in open('said') if l.startswith('cells')][0].split()
assert abs(float(said[6][:-1]) - whole) <= 1e-12 * whole, said
assert abs(float(said[10]) - whole) <= 1e-12 * whole, said
END
awk 'BEGIN { srand(8)
    for (i = 0; i < 150; i++) print rand(), 2 * rand(), 3 * rand() - 1 }' > boxed
if $PYTHON -c 'import scipy.spatial' 2> words; then
    awk '{ print $1, $2, $3, 5 * (NR - 1), "a " (NR - 1) }' OFS=, boxed \
        > valued.csv
    for kind in periodic clipped; do
        for scale in 1,1,1 2,1,0.25; do
            option=`echo -$kind | grep periodic`
            $TESS -volumes cells.csv -faces faces.csv $option -scale $scale \
                -box 0,1,0,2,-1,2 valued.csv > said
            yes "-volumes, -faces: as scipy has them: $kind, $scale" \
                $PYTHON voronoi.py $kind 0,1,0,2,-1,2 $scale
        done
    done
else
    skip "-volumes, -faces beside scipy's: no scipy for $PYTHON"
fi
awk '{ printf "%.17g %.17g %.17g\n", $1 + NR % 3 - 1, $2 - 2 * (NR % 2),
    $3 + 6 }' boxed > far
$TESS -volumes far.csv -periodic -box 0,1,0,2,-1,2 far > said 2> words
yes "-periodic: points outside the box are said" grep outside words > /dev/null
$TESS -q -volumes near.csv -periodic -box 0,1,0,2,-1,2 boxed
yes "-periodic: points outside the box have copies inside" awk -F, '
    NR == FNR { v[FNR] = $4; f[FNR] = $5; next }
    FNR > 1 && ($5 != f[FNR] || $4 - v[FNR] > 1e-12 || v[FNR] - $4 > 1e-12) {
        bad = 1 }
    END { exit bad || FNR != 151 }' near.csv far.csv
# duplicates have none; points in a plane have cells where the box repeats
(cat some; sed -n 5p some) > twin
$TESS -q -volumes twin.csv twin
yes "-volumes: a duplicate has no cell" sh -c \
    'tail -n 1 twin.csv | grep ",0,0,564,0,,nan,nan,nan$"' > /dev/null
printf '0 0 0\n1 0 0\n0 1 0\n1 1 0\n' > flat
$TESS -periodic -box 0,2,0,2,0,1 -volumes flat.csv flat > said 2> words
yes "-periodic: points in a plane" grep 'sum to 4; the box.s is 4$' said \
    > /dev/null
$TESS -box 0,1,0,1,0,1 boxed > said 2> words
yes "-box without cells" grep 'for -cells, -volumes, -faces and -per' words \
    > /dev/null
for o in "-validate 5" "-grid 3,3 -values no.csv"; do
    yes "-periodic $o" sh -c \
        "! $TESS -periodic -box 0,1,0,2,-1,2 $o boxed > said 2> words &&
        grep -e '-periodic' words > /dev/null"
done
# cells of any shape, along some vectors or all: cells and their mesh, values
# by all methods, beside scipy's of the copies about them
cat > repeat.py << END
import itertools, subprocess, sys, numpy
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import Voronoi, ConvexHull, cKDTree
def tess(*options):
    subprocess.run(sys.argv[1:2] + ['-q'] + list(options), check=True)
def read(name):
    return numpy.genfromtxt(name, delimiter=',', skip_header=1)
random = numpy.random.default_rng(3)
short = numpy.array([[2, 0, 0], [.9, 1.8, 0], [-.5, .6, 1.7]])
n = int(sys.argv[2])
ways = numpy.array([int(w) for w in sys.argv[3]])
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
    f.write('%d\\nLattice="%s" Origin="%s" pbc="%s" Properties=pos:R:3:u:R:1\\n' %
            (n, ' '.join(map(repr, map(float, vectors.flat))),
             ' '.join(map(str, origin)), ' '.join('FT'[w] for w in ways)))
    numpy.savetxt(f, numpy.c_[p + away, value], fmt='%.17g')
numpy.savetxt('places', q + random.integers(-9, 9, (400, 3)) * ways @ short,
              fmt='%.17g')
tess('-periodic', '-volumes', 'v.csv', '-node', 'r.node', '-ele', 'r.ele',
     '-faces', 'f.csv', 'repeat.xyz')
far = 2 if n > 100 else 3
shift = [s for s in itertools.product(range(-far, far + 1), repeat=3)
         if not ((1 - ways) * s).any()]
shift.sort(key=lambda s: numpy.abs(s).sum())
copies = (p + (numpy.array(shift) @ short)[:, None]).reshape(-1, 3)
mirrored = [copies]
for k in numpy.flatnonzero(1 - ways):
    normal = numpy.linalg.inv(vectors)[:, k]
    height = (copies - origin) @ normal
    for side in 0, 1:
        mirrored.append(copies - 2 * (height - side)[:, None] * normal /
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
    near = cKDTree(copies).query(middle + origin)[0]
    assert abs(near / radius - 1).max() < 1e-9, abs(near / radius - 1).max()
# values
many = numpy.tile(value, len(shift))
numpy.savetxt('copies', numpy.c_[copies, many], fmt='%.17g')
numpy.savetxt('inside', q, fmt='%.17g')
for method in 'linear', 'natural', 'nearest', 'smooth':
    # (gradients depend on points many edges away)
    if method == 'smooth' and (n < 100 or not ways.all()): continue
    tess('-periodic', '-query', 'places', '-qcols', '1,2,3', '-values',
         'here.csv', '-method', method, 'repeat.xyz')
    here = read('here.csv')[:, 3]
    assert not numpy.isnan(here).any() or not ways.all()
    if method == 'linear':
        there = LinearNDInterpolator(copies, many)(q)
    elif method == 'nearest':
        there = many[cKDTree(copies).query(q)[1]]
        there[numpy.isnan(here)] = numpy.nan
    else:
        tess('-query', 'inside', '-qcols', '1,2,3', '-values', 'there.csv',
             '-method', method, '-cols', '1,2,3,4', 'copies')
        there = read('there.csv')[:, 3]
    assert (numpy.isnan(here) == numpy.isnan(there)).all()
    # (a gradient has 1e-4 of the one that suits all copies)
    limit = 1e-10 if method != 'smooth' else 1e-5
    worst = numpy.nanmax(abs(here - there))
    assert worst < limit, (method, worst)
tess('-periodic', '-grid', '5,6,7', '-values', 'grid.csv', 'repeat.xyz')
grid = read('grid.csv')[:, :3]
low = numpy.minimum(vectors, 0).sum(0) + origin
high = numpy.maximum(vectors, 0).sum(0) + origin
assert abs(grid.min(0) - low).max() < 1e-12 * abs(high - low).max()
assert abs(grid.max(0) - high).max() < 1e-12 * abs(high - low).max()
END
if $PYTHON -c 'import scipy.spatial' 2> words; then
    for n in 2 3 120; do
        for ways in 111 110 001; do
            [ $n$ways = 2001 ] || [ $n$ways = 2110 ] || [ $n$ways = 3001 ] ||
                yes "-periodic: $n points, ways $ways, beside scipy's" \
                    $PYTHON repeat.py "$TESS" $n $ways
        done
    done
else
    skip "-periodic beside scipy's: no scipy for $PYTHON"
fi
# lattices, of which all is a tie: primitive cells of 1 point
for v in '0 1 1 1 0 1 1 1 0:2' '-1 1 1 1 -1 1 1 1 -1:4' \
    '2 0 0 1 2 0 0 1 2:8' '3 0 0 0 3 0 0 0 3:27'; do
    printf '1\nLattice="%s" Properties=pos:R:3:u:R:1\n.3 .2 .1 7\n' \
        "${v%:*}" > f.xyz
    $TESS -periodic -check -volumes v.csv -grid 9,9,9 -values f.csv f.xyz > said
    yes "-periodic: the lattice $v" awk -F, -v whole="${v#*:}" '
        FNR == 1 { f++; next }
        f == 1 { off = $4 - whole }
        f == 2 { places++; off = $4 - 7 }
        off > 1e-12 || off < -1e-12 { bad = 1 }
        END { exit bad || places != 729 }' v.csv f.csv
    yes "-check: proven" grep proven said > /dev/null
done
# refusals
OPTIONS="-volumes no.csv"
refuses flat1 'no cells: the points do not span space' < flat
for box in 0,1,0,1,0 0,1,0,1,1,0 0,1,0,1,0,0; do
    OPTIONS="-volumes no.csv -box $box"
    refuses boxed1 '-box needs X0,X1,Y0,Y1,Z0,Z1' < boxed
done
OPTIONS="-volumes no.csv -periodic"
refuses boxed2 '-periodic needs -box X0,X1,Y0,Y1,Z0,Z1, or' < boxed
yes "-periodic without a box: before anything is computed" test ! -s said
printf '0 0 0\n' > lone
OPTIONS="-volumes no.csv -periodic -box 0,64,0,1,0,1"
refuses lone1 'so few points in so long a box' < lone
OPTIONS="-volumes no.csv"
for e in -110 110; do
    awk '{ print $1 e, $2 e, $3 e }' e=e$e some |
        refuses sized 'use other units'
done
OPTIONS="-volumes no.csv -periodic -box 0,4e-300,0,4e-300,0,4e-300"
awk '{ print $1 e, $2 e, $3 e }' e=e-300 some | refuses sized 'use other units'
# a build whose volumes are wrong by 1e-8
sed 's,  *volume += area.j.,& * 1.00000001,' "$TOP"/test/recipes/cells.c \
    > wrong.c
# shellcheck disable=SC2046 # a list of files
$CC -O1 -I"$TOP" -I"$TOP"/test/recipes -o wrong wrong.c $(objects cells) \
    "$TOP"/build/tess.o "$TOP"/build/hhpred.o -lm
RIGHT=$TESS
TESS=./wrong
OPTIONS="-volumes no.csv"
refuses boxed3 "volumes sum to .* but the box's is" < boxed
TESS=$RIGHT
OPTIONS=
yes "nothing of what is refused is written" test ! -f no.csv

# ---- those files, by VTK ----

cat > fills.py << END
import numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy as array
def fills(name, many, whole):
    r = vtk.vtkUnstructuredGridReader()
    r.SetFileName(name)
    r.ReadAllScalarsOn()
    r.Update()
    m = r.GetOutput()
    volume = array(m.GetCellData().GetArray('volume'))
    n = m.GetNumberOfCells()
    assert n == many
    assert list(array(m.GetCellData().GetArray('point'))) == list(range(n))
    for i in range(n):
        c = m.GetCell(i)
        assert c.GetCellType() == 42
        sides, inside = set(), 0
        o = numpy.array(c.GetPoints().GetPoint(0))
        for f in range(c.GetNumberOfFaces()):
            p = array(c.GetFace(f).GetPoints().GetData()) - o
            k = c.GetFace(f).GetPointIds()
            k = [k.GetId(j) for j in range(k.GetNumberOfIds())]
            sides |= set(zip(k, k[1:] + k[:1]))
            inside += numpy.cross(p[1:-1], p[2:]).dot(p[0]).sum() / 6
        assert all((b, a) in sides for a, b in sides)
        # Euler
        assert 2 * (c.GetNumberOfPoints() + c.GetNumberOfFaces()) == \\
            len(sides) + 4
        assert abs(inside - volume[i]) <= 3e-14 * whole, (i, inside, volume[i])
    assert abs(volume.sum() - whole) <= 1e-12 * whole
for line in open('filled'):
    name, many, whole, test = line.rstrip().split(' ', 3)
    try:
        fills(name, int(many), float(whole))
        print('ok      ' + test)
    except Exception as why:
        print('FAILED  %s: %r' % (test, why))
END
if $PYTHON -c 'import numpy, vtk' 2> words; then
    lines $PYTHON fills.py
    yes "cells that VTK has read: all files" test \
        "$(wc -l < numbers)" -eq "$(wc -l < filled)"
else
    skip "cells, read by VTK: no numpy, vtk for $PYTHON"
fi

ended cells
