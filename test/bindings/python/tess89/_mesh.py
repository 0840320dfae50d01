"""The library; meshes, and what can be had from them."""
from __future__ import annotations

import ctypes
import os
import threading
from typing import TYPE_CHECKING, Any, Dict, Iterable, NamedTuple, Tuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

# i: an integer; o: one that is written; r: a double; z, d: arrays of integers,
# of doubles, or None
_int = ctypes.c_int
_calls = {"tess_size": "iioo", "tess_resume": "idiozzizid",
          "tess_hull": "izzioz", "tess_check": "idizzizo",
          "tr_many": "idizziiddzzidzddizd", "tr_average": "izidd",
          "tr_slopes": "idizzdidd", "tr_stars": "iizzz",
          "tr_edges": "izziozz", "tr_dual": "idzzizzddz",
          "tr_iso": "dizzdriiodziozz"}


def _array(dtype):
    kind = np.ctypeslib.ndpointer(dtype, flags="C_CONTIGUOUS")

    class Pointer:
        @staticmethod
        def from_param(x):
            return None if x is None else kind.from_param(x)
    return Pointer


def _load():
    here = os.path.dirname(os.path.abspath(__file__))
    top = os.path.join(here, "..", "..", "..", "..")
    # as setup.py names it; in a checkout what `make python' builds
    names = [os.path.join(here, "_library" + end) for end in (".so", ".dll")]
    if os.path.exists(os.path.join(top, "tess.h")):
        names.append(os.path.join(os.path.normpath(top), "build",
                                  "libtess.so"))
    name = next(filter(os.path.exists, names), None)
    build = ("; `pip install ./test/bindings/python' in the folder of tess.c "
             "builds and installs all, `make python' build/libtess.so")
    if name is None:
        raise ImportError("tess89: none of %s is there" % ", ".join(names)
                          + build)
    kinds = {"i": _int, "o": ctypes.POINTER(_int), "r": ctypes.c_double,
             "z": _array(np.intc), "d": _array(np.float64)}
    try:
        library = ctypes.CDLL(name)
        for call, letters in _calls.items():
            getattr(library, call).argtypes = [kinds[x] for x in letters]
    except (OSError, AttributeError) as e:
        raise ImportError("tess89: %s is not this version's library, or of "
                          "other types (%s)%s" % (name, e, build))
    library.tr_stars.restype = library.tr_average.restype = None
    return library


_lib = _load()
_MORE, _POOL, _NONE, _MOST = 1, 2, -1, 2**31 - 1
# (in the words of build/tess)
_why = {3: "no tetrahedron: all points lie in one plane",
        4: "no tetrahedron: all points lie on one line",
        5: "no tetrahedron: at most one distinct point",
        6: "the processor takes the subnormal coordinates for zero"}


def _fail(code):
    raise ValueError("tess89: " + _why.get(code,
                                           "code %d of the library" % code))


def _long(call, n, *arguments):
    """What the library's call returns for n points, which may take long: in a
    thread, so that Ctrl-C is heard.  Then the call ends by itself, and its
    arrays are lost."""
    arguments = (n,) + arguments
    if (n < 1000 or  # some milliseconds
            threading.current_thread() is not threading.main_thread()):
        return call(*arguments)
    done, said = threading.Event(), []

    def work():
        try:
            said.append((call(*arguments), None))
        except BaseException as e:
            said.append((None, e))
        done.set()

    # (the library's stack is 125 KB, which is all that some systems give)
    size = threading.stack_size(1 << 20)
    try:
        threading.Thread(target=work, daemon=True).start()
    except RuntimeError:  # none can be had, as where Python ends
        return call(*arguments)
    finally:
        threading.stack_size(size)
    # (on Windows a wait without an end does not hear it)
    while not done.wait(None if os.name == "posix" else 0.1):
        continue
    code, failed = said[0]
    if failed is not None:
        raise failed
    return code


def _numbers(x, what):
    if np.ma.isMaskedArray(x):
        raise TypeError("tess89: %s: a masked array; give plain arrays, for "
                        "missing values NaN" % what)
    x = np.asarray(x)
    if x.dtype.kind == "c":
        raise TypeError("tess89: %s: complex numbers (%s) are not supported; "
                        "take the real and the imaginary parts as two columns"
                        % (what, x.dtype))
    if x.dtype.kind not in "biuf":
        raise TypeError("tess89: %s: real numbers are needed, not %s"
                        % (what, x.dtype))
    return np.require(x, np.float64, "CA")


def _coordinates(x, what):
    x = _numbers(x, what)
    if x.shape[-1:] != (3,):
        raise ValueError("tess89: %s: the shape must be (..., 3), not %s"
                         % (what, x.shape))
    return x


def _points(x):
    x = _coordinates(x, "points")
    if x.ndim != 2:
        raise ValueError("tess89: points: the shape must be (n, 3), not %s"
                         % (x.shape,))
    return x


def _finite(points):
    """Points, all of them finite; in the words of build/tess, but for numbers,
    which begin at 0."""
    good = np.isfinite(points)
    if not good.all():
        i, k = np.argwhere(~good)[0]
        raise ValueError("tess89: points, row %d: column %d: %s" %
                         (i, k, "NaN: not a number" if np.isnan(points[i, k])
                          else "not finite"))
    return points


def _room(n, maxtet=0):
    liw, lrw = _int(), _int()
    if n > _MOST or _lib.tess_size(n, maxtet, liw, lrw) != 0:
        raise ValueError("tess89: %d are too many: 4-byte integers cannot "
                         "count what they need" % n)
    return liw.value, lrw.value


def _indices(x, shape, low, high):
    """A copy as the library's integers, if it is of that shape and in
    range(low, high), or None."""
    try:
        x = np.asarray(x)
    except ValueError:
        return None
    if (x.shape != shape or x.dtype.kind not in "iu" or
            x.size > 0 and not low <= int(x.min()) <= int(x.max()) < high):
        return None
    return np.array(x, np.intc, order="C")


def _refused(why):
    return ValueError("tess89: no mesh (%s): it is delaunay that makes one"
                      % str(why).replace("tess89: ", ""))


class _Arrays(NamedTuple):
    points: NDArray[np.float64]
    tet: NDArray[np.intc]
    adj: NDArray[np.intc]
    same: NDArray[np.intc]


class Mesh(_Arrays):
    """A Delaunay tetrahedralization, as `delaunay` returns it.

    A tuple of four arrays that cannot be written.

    Attributes
    ----------
    points : ndarray of double, shape (n, 3)
        The points, a copy of what was given.
    tet : ndarray of int32, shape (m, 4)
        Each tetrahedron's vertices, numbers of points; positively oriented:
        det [b-a c-a d-a] > 0.
    adj : ndarray of int32, shape (m, 4)
        The tetrahedron across the facet opposite to each vertex, -1 on the
        hull.
    same : ndarray of int32, shape (n,)
        For each point itself, or for a duplicate the first point with the same
        coordinates, which stands for it.

    Raises
    ------
    ValueError
        Where arrays from elsewhere, as of `_replace` or a pickle, are not a
        Delaunay tetrahedralization of the points: each Mesh is proven, but
        what delaunay itself has made.

    Notes
    -----
    ``mesh == other`` is True where all four arrays are equal.

    Examples
    --------
    >>> import tess89
    >>> cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> mesh = tess89.delaunay(cube + cube)
    >>> mesh
    <tess89.Mesh: 16 points, 6 tetrahedra>
    >>> mesh.same
    array([0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7], dtype=int32)
    """
    __slots__ = ()

    def __new__(cls, points: ArrayLike, tet: ArrayLike, adj: ArrayLike,
                same: ArrayLike) -> Mesh:
        try:
            p = np.array(_points(points))
        except (TypeError, ValueError) as e:
            raise _refused(e) from None
        n = len(p)
        rows: Any = tet
        m = len(rows) if hasattr(rows, "__len__") else 0
        t = _indices(tet, (m, 4), 0, n)
        a = _indices(adj, (m, 4), _NONE, m)
        s = _indices(same, (n,), 0, n)
        if m == 0 or t is None or a is None or s is None:
            raise _refused("shapes, types or numbers out of range")
        liw, bad = max(_room(n, m)[0], 2 * n), _int()
        code = _long(_lib.tess_check, n, p, m, t, a, liw,
                     np.empty(liw, np.intc), bad)
        if code != 0:
            raise _refused("code %d of tess_check, at %d" % (code, bad.value))
        if not (np.array_equal(p[s], p) and
                np.array_equal(np.unique(s), np.unique(t))):
            raise _refused("same names other points")
        return cls._own(p, t, a, s)

    @classmethod
    def _own(cls, *arrays):
        for x in arrays:
            x.flags.writeable = False
        # (the views cannot be made writeable, as what they view is not)
        return tuple.__new__(cls, [x.view() for x in arrays])

    @classmethod
    def _make(cls, iterable: Iterable[Any]) -> Mesh:  # type: ignore[override]
        """A Mesh of four arrays."""
        arrays = tuple(iterable)
        if len(arrays) != 4:
            raise _refused("%d arrays, not four" % len(arrays))
        return cls(*arrays)

    def _replace(self, **arrays: Any) -> Mesh:
        """A Mesh with other arrays for some."""
        for name in arrays:
            if name not in self._fields:
                raise ValueError("tess89: a Mesh has no %r" % name)
        return type(self)(**dict(zip(self._fields, self), **arrays))

    __replace__ = _replace

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mesh) and all(
            np.array_equal(a, b) for a, b in zip(self, other))

    def __ne__(self, other: object) -> bool:
        return not self == other

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return "<tess89.Mesh: %d points, %d tetrahedra>" % (len(self.points),
                                                            len(self.tet))


def _mesh(mesh: Any) -> Mesh:
    if isinstance(mesh, Delaunay):
        return mesh.mesh
    if not isinstance(mesh, Mesh):
        raise TypeError("tess89: a Mesh is needed, as delaunay returns it, or "
                        "a Delaunay, not %s" % type(mesh).__name__)
    return mesh


def delaunay(points: ArrayLike) -> Mesh:
    """The Delaunay tetrahedralization of points, as a Mesh.

    Parameters
    ----------
    points : array_like of float, shape (n, 3)
        The points, all finite.

    Returns
    -------
    Mesh
        About 6.8 tetrahedra a point; 320 bytes a point while it works.

    Raises
    ------
    ValueError
        Where a coordinate is not finite, with its row; where all points lie in
        one plane; for another shape.
    TypeError
        For what is no real numbers.

    Examples
    --------
    >>> import tess89
    >>> mesh = tess89.delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    >>> mesh.adj
    array([[-1, -1, -1, -1]], dtype=int32)
    """
    # a copy, lest the caller's changes make the mesh another points'
    p = _finite(np.array(_points(points)))
    if len(p) == 0:
        raise ValueError("tess89: no points")
    n, ntet, code, pool = len(p), _int(0), _MORE, 1
    room = min(8 * n + 64, _MOST // 4)
    tet, adj = np.empty((room, 4), np.intc), np.empty((room, 4), np.intc)
    while True:
        liw, lrw = _room(n, room)
        liw = min(pool * liw, _MOST)
        iw, rw = np.empty(liw, np.intc), np.empty(lrw)
        code = _long(_lib.tess_resume, n, p, room, ntet, tet, adj, liw, iw, lrw,
                     rw)
        if code == _MORE and room < _MOST // 4:
            del iw, rw
            room = min(2 * room, _MOST // 4)
            tet, adj = _longer(tet, room), _longer(adj, room)
        elif code == _POOL and liw < _MOST:
            pool *= 2
        else:
            break
    if code != 0:
        _fail(code)
    same = iw[:n].copy()
    del iw, rw
    for x in (tet, adj):
        x.resize((ntet.value, 4), refcheck=False)
    return Mesh._own(p, tet, adj, same)


def _longer(x, room):
    longer = np.empty((room, 4), np.intc)
    longer[:len(x)] = x
    return longer


# places that are looked up between two looks for Ctrl-C, by method
_BLOCK = [1 << 17, 1 << 17, 1 << 12, 1 << 17]


def _many(mesh, method, values, g, first, stars, places, weights):
    """What the recipe tr_many gives for places (..., 3): tetrahedra (nq,),
    weights (nq, 4), values (nq, nv), one after the other; for those that are
    not finite no tetrahedron, -1, and NaN."""
    q = places.reshape(-1, 3)
    nv, nq, most = len(values), len(q), 60
    block = max(1, _BLOCK[method] * 8 // (8 + nv))
    t, out = np.empty(nq, np.intc), np.empty((nq, nv))
    w = np.empty((nq, 4)) if weights else None
    for i in range(0, nq, block):
        some = slice(i, min(i + block, nq))
        good = np.isfinite(q[some]).all(1)
        x = q[some][good]
        found, part = np.empty(len(x), np.intc), np.empty((nv, len(x)))
        weight = np.empty((len(x), 4)) if weights else None
        liw, lrw = _room(len(x))
        while True:
            iw = np.empty(liw + 14 * most + 17, np.intc)
            rw = np.empty(lrw + 15 * most + 21)
            code = _lib.tr_many(len(mesh.points), mesh.points, len(mesh.tet),
                                mesh.tet, mesh.adj, method, nv, values, g,
                                first, stars, len(x), x, found, weight, part,
                                most, iw, rw)
            if code != _POOL:
                break
            most *= 2
        if code not in (0, 1):
            _fail(code)
        for every, one, none in ((t, found, _NONE), (out, part.T, np.nan),
                                 (w, weight, np.nan)):
            if every is not None:
                every[some][good] = one
                every[some][~good] = none
    return t, w, out


def locate(mesh: Mesh | Delaunay,
           places: ArrayLike) -> Tuple[NDArray[np.intc], NDArray[np.float64]]:
    """The tetrahedra that hold places, and weights there.

    Parameters
    ----------
    mesh : Mesh or Delaunay
    places : array_like of float, shape (..., 3)

    Returns
    -------
    t : ndarray of int32, shape (...)
        Numbers of tetrahedra, rows of mesh.tet; -1 outside the hull, and for a
        place that is not finite.
    w : ndarray of double, shape (..., 4)
        The barycentric weights, at least 0, of their four vertices; NaN
        outside.  ``np.sum(w * values[mesh.tet[t]], -1)`` interpolates.

    Raises
    ------
    TypeError, ValueError
        For what is no mesh, no real numbers, of another shape.

    Examples
    --------
    >>> import tess89
    >>> mesh = tess89.delaunay([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]])
    >>> t, w = tess89.locate(mesh, [[1, 1, 1], [3, 3, 3]])
    >>> t
    array([ 0, -1], dtype=int32)
    >>> w
    array([[0.25, 0.25, 0.25, 0.25],
           [ nan,  nan,  nan,  nan]])
    """
    q = _coordinates(places, "places")
    made = _mesh(mesh)
    t, w, _ = _many(made, 0, np.empty((0, len(made.points))), None, None, None,
                    q, True)
    t = np.maximum(t, _NONE)
    w[t < 0] = np.nan
    return t.reshape(q.shape[:-1]), w.reshape(q.shape[:-1] + (4,))


def hull(mesh: Mesh | Delaunay) -> NDArray[np.intc]:
    """The triangles of the convex hull.

    Parameters
    ----------
    mesh : Mesh or Delaunay

    Returns
    -------
    ndarray of int32, shape (k, 3)
        Numbers of points, counter-clockwise as seen from outside.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> a, b, c = points[tess89.hull(tess89.delaunay(points))].swapaxes(0, 1)
    >>> print("%.2f" % (np.einsum("ij,ij", a, np.cross(b, c)) / 6))  # volume
    0.92
    """
    _, tet, adj, _ = _mesh(mesh)
    nfac = _int(0)
    fac = np.empty((0, 3), np.intc)
    while _lib.tess_hull(len(tet), tet, adj, len(fac), nfac, fac) == _MORE:
        fac = np.empty((nfac.value, 3), np.intc)
    return fac


def _edges(tet, adj):
    """Each edge once, and a tetrahedron at it."""
    nedge, many = _int(0), 0
    edge, at = np.empty((0, 2), np.intc), np.empty(0, np.intc)
    while _lib.tr_edges(len(tet), tet, adj, many, nedge, edge, at) == _MORE:
        many = nedge.value
        edge, at = np.empty((many, 2), np.intc), np.empty(many, np.intc)
    return edge, at


def volumes(mesh: Mesh | Delaunay) -> NDArray[np.float64]:
    """The volumes of the points' Voronoi cells: what is nearer to a point than
    to all others.

    Parameters
    ----------
    mesh : Mesh or Delaunay

    Returns
    -------
    ndarray of double, shape (n,)
        Infinite for points on the hull, 0 for a duplicate.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> points = np.indices((3, 3, 3)).reshape(3, -1).T
    >>> v = tess89.volumes(tess89.delaunay(points))
    >>> v[np.isfinite(v)]
    array([1.])
    """
    p, tet, adj, _ = _mesh(mesh)
    n = len(p)
    # in units in which no square of a length overflows, or is lost
    unit = int(np.frexp(np.max(p.max(0) / 2 - p.min(0) / 2))[1]) + 1
    p = np.ldexp(p, -unit)
    edge, at = _edges(tet, adj)
    area, cell = np.empty(len(edge)), np.empty(n)
    outer = np.empty(n, np.intc)
    _lib.tr_dual(n, p, tet, adj, len(edge), edge, at, area, cell, outer)
    cell = np.ldexp(cell, 3 * unit)
    cell[outer != 0] = np.inf
    return cell


class Delaunay:
    """Delaunay(points, furthest_site=False, incremental=False, \
qhull_options=None)

    Delaunay tetrahedralization in space, as scipy.spatial.Delaunay.

    Parameters
    ----------
    points : array_like of float, shape (npoints, 3)
        The points, all finite.
    furthest_site, incremental, qhull_options
        As scipy has them; what is not their default is a ValueError.

    Attributes
    ----------
    points : ndarray of double, shape (npoints, 3)
        The points.
    simplices : ndarray of int32, shape (nsimplex, 4)
        The points that form each tetrahedron, positively oriented.
    neighbors : ndarray of int32, shape (nsimplex, 4)
        The tetrahedra beside each.  The kth one is opposite to the kth vertex;
        -1 on the boundary.
    convex_hull : ndarray of int32, shape (nfaces, 3)
        The triangles of the convex hull, counter-clockwise from outside.
    coplanar : ndarray of int32, shape (ncoplanar, 3)
        Points that are in no tetrahedron: number of the point, of a tetrahedron
        at it and of the nearest vertex.  Here these are duplicates alone, and
        the vertex is the first point with the same coordinates.
    vertex_to_simplex : ndarray of int32, shape (npoints,)
        For each point a tetrahedron that it is a vertex of, -1 for a duplicate.
    vertex_neighbor_vertices : tuple of two ndarrays of int32
        ``(indptr, indices)``: the neighbours of point k are
        ``indices[indptr[k]:indptr[k+1]]``, in ascending order.
    transform : ndarray of double, shape (nsimplex, 4, 3)
        Of tetrahedron i the inverse of T, ``transform[i, :3]``, and the last
        vertex r, ``transform[i, 3]``: the barycentric coordinates c of x have
        ``T c = x - r``.  NaN where rounding hides the volume; `locate` has
        weights that are right there, too.
    min_bound, max_bound : ndarray of double, shape (3,)
        The least and the largest coordinates.
    npoints, nsimplex, ndim : int
    mesh : Mesh
        The same as a tuple, for locate, hull, volumes.

    Raises
    ------
    ValueError
        Where a coordinate is not finite, with its row; where all points lie in
        one plane; for points that are not in space.
    TypeError
        For what is no real numbers.

    Notes
    -----
    Exact: no tetrahedron is flat, and no point is left out by rounding, as
    happens with Qhull.  For a plane, or more than three dimensions, take
    scipy.spatial.Delaunay.

    Examples
    --------
    >>> import tess89
    >>> tri = tess89.Delaunay([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1],
    ...                        [2, 2, 2]])
    >>> tri
    <tess89.Delaunay: 5 points, 2 tetrahedra>
    >>> tri.find_simplex([[3, 3, 3]])
    array([-1], dtype=int32)
    """

    ndim = 3

    def __init__(self, points: ArrayLike, furthest_site: bool = False,
                 incremental: bool = False,
                 qhull_options: str | None = None) -> None:
        for name, given in (("furthest_site", furthest_site),
                            ("incremental", incremental),
                            ("qhull_options", qhull_options)):
            if given:
                raise ValueError("tess89: Delaunay: %s is not supported: "
                                 "scipy.spatial.Delaunay has it" % name)
        self._mesh = delaunay(points)
        self._kept: Dict[str, Any] = {}

    @classmethod
    def _of(cls, mesh):
        self = cls.__new__(cls)
        self._mesh, self._kept = mesh, {}
        return self

    def _once(self, name, make):
        if name not in self._kept:
            self._kept[name] = make()
        return self._kept[name]

    @property
    def mesh(self) -> Mesh:
        return self._mesh

    @property
    def points(self) -> NDArray[np.float64]:
        return self.mesh.points

    @property
    def simplices(self) -> NDArray[np.intc]:
        return self.mesh.tet

    @property
    def neighbors(self) -> NDArray[np.intc]:
        return self.mesh.adj

    @property
    def npoints(self) -> int:
        return len(self.mesh.points)

    @property
    def nsimplex(self) -> int:
        return len(self.mesh.tet)

    @property
    def min_bound(self) -> NDArray[np.float64]:
        return self.mesh.points.min(0)

    @property
    def max_bound(self) -> NDArray[np.float64]:
        return self.mesh.points.max(0)

    @property
    def convex_hull(self) -> NDArray[np.intc]:
        return self._once("convex_hull", lambda: hull(self.mesh))

    @property
    def vertex_to_simplex(self) -> NDArray[np.intc]:
        def make():
            at = np.full(self.npoints, _NONE, np.intc)
            at[self.mesh.tet] = np.arange(self.nsimplex,
                                          dtype=np.intc)[:, None]
            return at
        return self._once("vertex_to_simplex", make)

    @property
    def coplanar(self) -> NDArray[np.intc]:
        def make():
            same = self.mesh.same
            i = np.flatnonzero(same != np.arange(len(same)))
            vertex = same[i]
            return np.column_stack((i, self.vertex_to_simplex[vertex],
                                    vertex)).astype(np.intc)
        return self._once("coplanar", make)

    @property
    def vertex_neighbor_vertices(self) -> Tuple[NDArray[np.intc],
                                                NDArray[np.intc]]:
        def make():
            edge, _ = _edges(self.simplices, self.neighbors)
            a = np.concatenate((edge[:, 0], edge[:, 1]))
            b = np.concatenate((edge[:, 1], edge[:, 0]))
            indptr = np.zeros(self.npoints + 1, np.intc)
            np.cumsum(np.bincount(a, minlength=self.npoints), out=indptr[1:])
            return indptr, b[np.lexsort((b, a))]
        return self._once("vertex_neighbor_vertices", make)

    @property
    def transform(self) -> NDArray[np.float64]:
        def make():
            v = self.points[self.simplices]
            a, b, c = (v[:, k] - v[:, 3] for k in range(3))
            with np.errstate(all="ignore"):
                inverse = np.stack((np.cross(b, c), np.cross(c, a),
                                    np.cross(a, b)), 1)
                volume = np.sum(a * inverse[:, 0], 1)
                # (of the last vertex' edges it is negative)
                inverse /= np.where(volume < 0, volume, np.nan)[:, None, None]
            return np.concatenate((inverse, v[:, 3:]), 1)
        return self._once("transform", make)

    def find_simplex(self, xi: ArrayLike, bruteforce: bool = False,
                     tol: float | None = None) -> NDArray[np.intc]:
        """The tetrahedra that hold places.

        Parameters
        ----------
        xi : array_like of float, shape (..., 3)
            The places.
        bruteforce : bool, optional
            Of no effect: no place is missed.
        tol : None
            Places are located exactly: another tol is a ValueError.

        Returns
        -------
        ndarray of int32, shape (...)
            Numbers of tetrahedra, -1 outside; on a facet either one's.

        Raises
        ------
        TypeError, ValueError
            For what is no real numbers, or of another shape.
        """
        if tol is not None:
            raise ValueError("tess89: find_simplex: tol is not supported: "
                             "places are located exactly")
        q = _coordinates(xi, "xi")
        t, _, _ = _many(self.mesh, 0, np.empty((0, self.npoints)), None, None,
                        None, q, False)
        return np.maximum(t, _NONE).reshape(q.shape[:-1])

    def __repr__(self) -> str:
        return "<tess89.Delaunay: %d points, %d tetrahedra>" % (self.npoints,
                                                                self.nsimplex)
