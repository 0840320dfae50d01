"""Delaunay tetrahedralization and interpolation in space, for NumPy.

    >>> import numpy, tess
    >>> points = numpy.random.rand(1000, 3)
    >>> mesh = tess.delaunay(points)
    >>> f = tess.Interpolator(mesh, points[:, 0])
    >>> f([[.5, .5, .5], [2, 2, 2]])
    array([0.5, nan])

delaunay      points -> Mesh: tetrahedra and their neighbours
locate        the tetrahedra at any places, and weights there
Interpolator  values at the points -> values at any places, by tetrahedra,
              smooth, by natural neighbours or the nearest point
interpolate   the same in one call, with a mesh at hand
hull          the convex hull's triangles
volumes       of the points' Voronoi cells

`make python' builds the library, build/libtess.so.  It is found beside this
file, or in build/ two folders above.

Arrays may be whatever numpy.asarray takes, of real numbers; masked arrays are
refused.  A place that is not finite is in no tetrahedron, and its value is NaN.
All is thread-safe, and other threads run while the library works.
"""
import ctypes
import os
from collections import namedtuple

import numpy as np

__all__ = ["Mesh", "delaunay", "locate", "Interpolator", "interpolate", "hull",
           "volumes"]

# i: an integer; o: one that is written; z, d: arrays of integers, of doubles,
# or None
_int = ctypes.c_int
_calls = {"tess_size": "iioo", "tess_resume": "idiozzizid",
          "tess_hull": "izzioz", "many": "idizziiddzzidzddizd",
          "slopes": "idizzdidd", "stars": "iizzz", "edges": "izziozz",
          "dual": "idzzizzddz"}


def _array(dtype):
    kind = np.ctypeslib.ndpointer(dtype, flags="C_CONTIGUOUS")

    class Pointer:
        @staticmethod
        def from_param(x):
            return None if x is None else kind.from_param(x)
    return Pointer


def _load():
    here = os.path.dirname(os.path.abspath(__file__))
    top = os.path.dirname(os.path.dirname(here))
    names = [os.path.join(folder, "libtess.so")
             for folder in (here, os.path.join(top, "build"))]
    name = next(filter(os.path.exists, names), None)
    build = "; `make python' in the folder of tess.c builds build/libtess.so"
    if name is None:
        raise ImportError("tess: neither %s nor %s is there" % tuple(names)
                          + build)
    kinds = {"i": _int, "o": ctypes.POINTER(_int), "z": _array(np.intc),
             "d": _array(np.float64)}
    try:
        library = ctypes.CDLL(name)
        for call, letters in _calls.items():
            getattr(library, call).argtypes = [kinds[x] for x in letters]
    except (OSError, AttributeError) as e:
        raise ImportError("tess: %s is not this version's library, or of other "
                          "types (%s)%s" % (name, e, build))
    library.stars.restype = None
    return library


_lib = _load()
_MORE, _POOL, _NONE, _MOST = 1, 2, -1, 2**31 - 1
_METHODS = ["linear", "smooth", "natural", "nearest"]
_ROUNDS = 3  # of slopes
_why = {3: "all points lie in one plane: there is no tetrahedron",
        4: "all points lie on one line: there is no tetrahedron",
        5: "at most one distinct point: there is no tetrahedron",
        6: "the processor takes the subnormal coordinates for zero"}


def _fail(code):
    raise ValueError("tess: " + _why.get(code, "code %d of the library" % code))


def _numbers(x, what):
    if np.ma.isMaskedArray(x):
        raise TypeError("tess: %s: a masked array; leave out what is masked "
                        "and give plain arrays" % what)
    x = np.asarray(x)
    if x.dtype.kind not in "biuf":
        raise TypeError("tess: %s: real numbers are needed, not %s"
                        % (what, x.dtype))
    return np.require(x, np.float64, "CA")


def _coordinates(x, what):
    x = _numbers(x, what)
    if x.shape[-1:] != (3,):
        raise ValueError("tess: %s: the shape must be (..., 3), not %s"
                         % (what, x.shape))
    return x


def _room(n, maxtet=0):
    liw, lrw = _int(), _int()
    if n > _MOST or _lib.tess_size(n, maxtet, liw, lrw) != 0:
        raise ValueError("tess: %d are too many: 4-byte integers cannot count "
                         "what they need" % n)
    return liw.value, lrw.value


class Mesh(namedtuple("Mesh", "points tet adj same")):
    """A Delaunay tetrahedralization, as delaunay returns it; arrays that
    cannot be written.

    points (n, 3)   the points, a copy of what was given
    tet (m, 4)      each tetrahedron's vertices, numbers of points; positively
                    oriented: det [b-a c-a d-a] > 0
    adj (m, 4)      the tetrahedron across the facet opposite to each vertex,
                    -1 on the hull
    same (n,)       for each point itself, or for a duplicate the first point
                    with the same coordinates, which stands for it
    """
    __slots__ = ()

    def __new__(cls, points, tet, adj, same):
        points = np.require(points, np.float64, "CA").view()
        tet, adj, same = (np.require(x, np.intc, "CA").view()
                          for x in (tet, adj, same))
        n, m = len(points), len(tet)
        if not (points.shape == (n, 3) and same.shape == (n,) and m > 0 and
                tet.shape == adj.shape == (m, 4) and
                0 <= tet.min() <= tet.max() < n and
                _NONE <= adj.min() <= adj.max() < m):
            raise ValueError("tess: no mesh: it is delaunay that makes one")
        for x in (points, tet, adj, same):
            x.flags.writeable = False
        return super().__new__(cls, points, tet, adj, same)


def _mesh(mesh):
    if not isinstance(mesh, Mesh):
        raise TypeError("tess: a Mesh is needed, as delaunay returns it, not %s"
                        % type(mesh).__name__)
    return mesh


def delaunay(points):
    """The Delaunay tetrahedralization of points (n, 3), as a Mesh.

    ValueError where a coordinate is not finite, or where all points lie in one
    plane.  About 6.8 tetrahedra a point, and 320 bytes while it works.
    """
    p = _coordinates(points, "points")
    if p.ndim != 2:
        raise ValueError("tess: points: the shape must be (n, 3), not %s"
                         % (p.shape,))
    n, ntet, code, pool = len(p), _int(0), _MORE, 1
    room = min(8 * n + 64, _MOST // 4)
    tet, adj = np.empty((room, 4), np.intc), np.empty((room, 4), np.intc)
    while True:
        liw, lrw = _room(n, room)
        liw = min(pool * liw, _MOST)
        iw, rw = np.empty(liw, np.intc), np.empty(lrw)
        code = _lib.tess_resume(n, p, room, ntet, tet, adj, liw, iw, lrw, rw)
        if code == _MORE and room < _MOST // 4:
            iw = rw = None
            room = min(2 * room, _MOST // 4)
            tet, adj = _longer(tet, room), _longer(adj, room)
        elif code == _POOL and liw < _MOST:
            pool *= 2
        else:
            break
    if code == -2:
        i = np.argmin(np.isfinite(p).all(1))
        raise ValueError("tess: point %d is not finite: %s" % (i, p[i]))
    if code != 0:
        _fail(code)
    same = iw[:n].copy()
    iw = rw = None
    for x in (tet, adj):
        x.resize((ntet.value, 4), refcheck=False)
    # a copy, lest the caller's changes make the mesh another points'
    return Mesh(p.copy(), tet, adj, same)


def _longer(x, room):
    longer = np.empty((room, 4), np.intc)
    longer[:len(x)] = x
    return longer


def _many(mesh, method, values, g, first, stars, places, weights):
    """What the recipe `many' gives for places (..., 3), one after the other;
    for those that are not finite no tetrahedron, -1, and NaN."""
    q = places.reshape(-1, 3)
    good = np.isfinite(q).all(1)
    some = not good.all()
    if some:
        q = q[good]
    nv, nq, most = len(values), len(q), 60
    t, out = np.empty(nq, np.intc), np.empty((nv, nq))
    w = np.empty((nq, 4)) if weights else None
    liw, lrw = _room(nq)
    while True:
        iw = np.empty(liw + 14 * most + 17, np.intc)
        rw = np.empty(lrw + 15 * most + 21)
        code = _lib.many(len(mesh.points), mesh.points, len(mesh.tet),
                         mesh.tet, mesh.adj, method, nv, values, g, first,
                         stars, nq, q, t, w, out, most, iw, rw)
        if code != _POOL:
            break
        most *= 2
    if code not in (0, 1):
        _fail(code)
    if some:
        every, t = t, np.full(len(good), _NONE, np.intc)
        t[good] = every
        every, out = out, np.full((nv, len(good)), np.nan)
        out[:, good] = every
        if weights:
            every, w = w, np.full((len(good), 4), np.nan)
            w[good] = every
    return t, w, out


def locate(mesh, places):
    """The tetrahedra that hold places (..., 3), and weights there: t, w.

    t (...)      numbers of tetrahedra, rows of mesh.tet; -1 outside the hull
    w (..., 4)   the barycentric weights, at least 0, of their four vertices;
                 NaN outside.  sum(w * values[mesh.tet[t]], -1) interpolates
    """
    q = _coordinates(places, "places")
    t, w, _ = _many(_mesh(mesh), 0, np.empty((0, len(mesh.points))), None, None,
                    None, q, True)
    t = np.maximum(t, _NONE)
    w[t < 0] = np.nan
    return t.reshape(q.shape[:-1]), w.reshape(q.shape[:-1] + (4,))


class Interpolator:
    """Interpolator(points, values, method="linear", outside=nan)

    points   (n, 3), or a Mesh of them
    values   (n,) or (n, ...): a value, or an array of them, for each point.  Of
             points that coincide that of the first one counts
    method   "linear"   in each tetrahedron
             "smooth"   by gradients at the points: the most accurate one where
                        the field is smooth; it may leave the data's range
             "natural"  by Sibson's natural neighbours
             "nearest"  the nearest point's
    outside  the value outside the hull; or "nearest", or None: that of the
             hull's point nearest to the place, by "nearest" of the nearest
             point

    It is called with places (..., 3), or with three arrays x, y, z that
    broadcast, and returns values (...) or (..., ...).
    """

    def __init__(self, points, values, method="linear", outside=np.nan):
        self.mesh = points if isinstance(points, Mesh) else delaunay(points)
        if method not in _METHODS:
            raise ValueError("tess: method: one of %s, not %r"
                             % (", ".join(_METHODS), method))
        n, m = len(self.mesh.points), len(self.mesh.tet)
        v = _numbers(values, "values")
        if v.shape[:1] != (n,) or v.size == 0:
            raise ValueError("tess: values: the shape must be (%d, ...), one "
                             "row for each point, not %s" % (n, v.shape))
        self.method, self._shape = method, v.shape[1:]
        self._near = outside is None or isinstance(outside, str)
        if isinstance(outside, str) and outside != "nearest":
            raise ValueError("tess: outside: a number or \"nearest\", not %r"
                             % outside)
        self._outside = 0.0 if self._near else float(outside)
        # by columns; a copy, lest the caller's changes count
        self._values = np.array(v.reshape(n, -1).T, order="C", copy=True)
        self._slopes = self._first = self._stars = None
        if method == "smooth":
            self._slopes = np.empty((len(self._values), n, 3))
            work = np.empty(9 * n)
            for value, g in zip(self._values, self._slopes):
                code = _lib.slopes(n, self.mesh.points, m, self.mesh.tet,
                                   self.mesh.adj, value, _ROUNDS, g, work)
                if code not in (0, 6):  # 6: values that are no numbers
                    _fail(code)
        if method == "nearest":
            self._first = np.empty(n + 1, np.intc)
            self._stars = np.empty(4 * m, np.intc)
            _lib.stars(n, m, self.mesh.tet, self._first, self._stars)

    def __call__(self, *places):
        if len(places) == 3:
            places = np.stack(np.broadcast_arrays(
                *[_numbers(x, "places") for x in places]), -1)
        elif len(places) == 1:
            places = _coordinates(places[0], "places")
        else:
            raise TypeError("tess: places (..., 3), or three arrays x, y, z")
        t, _, out = _many(self.mesh, _METHODS.index(self.method), self._values,
                          self._slopes, self._first, self._stars, places, False)
        if not self._near:
            out[:, t < _NONE] = self._outside
        return np.ascontiguousarray(out.T).reshape(places.shape[:-1] +
                                                   self._shape)


def interpolate(mesh, values, places, method="linear", outside=np.nan):
    """Values (n,) or (n, ...) of the mesh's points at places (..., 3):
    Interpolator(mesh, values, method, outside)(places)."""
    return Interpolator(_mesh(mesh), values, method, outside)(places)


def hull(mesh):
    """The hull's triangles (m, 3), numbers of points, counter-clockwise as seen
    from outside."""
    tet, adj = _mesh(mesh).tet, mesh.adj
    nfac = _int(0)
    fac = np.empty((0, 3), np.intc)
    while _lib.tess_hull(len(tet), tet, adj, len(fac), nfac, fac) == _MORE:
        fac = np.empty((nfac.value, 3), np.intc)
    return fac


def volumes(mesh):
    """The volumes (n,) of the points' Voronoi cells: what is nearer to a point
    than to all others.  Infinite for points on the hull, 0 for a duplicate."""
    n, tet, adj = len(_mesh(mesh).points), mesh.tet, mesh.adj
    # in units in which no square of a length overflows, or is lost
    p = mesh.points
    unit = int(np.frexp(np.max(p.max(0) / 2 - p.min(0) / 2))[1]) + 1
    p = np.ldexp(p, -unit)
    nedge, many = _int(0), 0
    edge, at = np.empty((0, 2), np.intc), np.empty(0, np.intc)
    while _lib.edges(len(tet), tet, adj, many, nedge, edge, at) == _MORE:
        many = nedge.value
        edge, at = np.empty((many, 2), np.intc), np.empty(many, np.intc)
    area, cell, outer = np.empty(many), np.empty(n), np.empty(n, np.intc)
    _lib.dual(n, p, tet, adj, many, edge, at, area, cell, outer)
    cell = np.ldexp(cell, 3 * unit)
    cell[outer != 0] = np.inf
    return cell
