"""Values at points, and between them."""
from __future__ import annotations

import sys
import warnings
from typing import TYPE_CHECKING, Any, Tuple

import numpy as np

from ._mesh import (_MOST, _NONE, Delaunay, Mesh, _coordinates, _fail, _finite,
                    _int, _lib, _long, _many, _mesh, _numbers, delaunay)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_METHODS = ["linear", "smooth", "natural", "nearest"]
_ROUNDS = 3  # of slopes


def _places(given, what):
    """One argument, or three arrays, or a tuple of three, as scipy reads
    them."""
    if len(given) == 1:
        given = given[0]
    if not isinstance(given, tuple):
        x = _numbers(given, what)
        if x.ndim == 1 and x.size % 3 == 0:
            x = x.reshape(-1, 3)
        return _coordinates(x, what)
    if len(given) != 3:
        raise ValueError("tess89: %s: three coordinates are needed, x, y, z, "
                         "not %d" % (what, len(given)))
    return np.stack(np.broadcast_arrays(
        *[_numbers(x, what) for x in given]), -1)


def _spread(points):
    """The lengths of the points' box, 1 for 0."""
    with np.errstate(over="ignore"):
        size = points.max(0) - points.min(0)
    size[~(size > 0)] = 1.0
    if not np.isfinite(size).all():
        raise ValueError("tess89: rescale: a side of the points' box, or a "
                         "coordinate, is not finite")
    return size


def _lacks(x):
    """Is it no class, but what stands for none?"""
    return (x is None or isinstance(x, str) and x == "" or
            isinstance(x, float) and x != x or type(x).__name__ == "NAType")


def _classes(values):
    """Of text the classes, in order, and for each value the number of its own,
    NaN where there is none; None for what is no text."""
    if np.ma.isMaskedArray(values):
        return None
    x = np.asarray(values)
    if x.dtype.kind == "S":
        x = np.char.decode(x, "utf-8")
    if x.dtype.kind == "U":
        absent = np.asarray(x == "")
    elif x.dtype.kind == "O":
        text = np.array([isinstance(v, str) for v in x.flat], bool)
        if not text.any():
            return None
        absent = np.array([_lacks(v) for v in x.flat], bool)
        wrong = np.flatnonzero(~(text | absent))
        if wrong.size:
            raise TypeError("tess89: values: text, but row %d has %r, which is "
                            "neither text nor None" %
                            (wrong[0] * len(x) // x.size, x.flat[wrong[0]]))
        absent = absent.reshape(x.shape)
    else:
        return None
    names, number = np.unique(x[~absent], return_inverse=True)
    numbers = np.full(x.shape, np.nan)
    numbers[~absent] = number
    return x, names, numbers


class _Group:
    """Columns that lack the values of the same points, and a mesh of the
    others."""

    def __init__(self, mesh, columns, values, method):
        n, m = len(mesh.points), len(mesh.tet)
        self.mesh, self.columns, self.values = mesh, columns, values
        self.method = _METHODS.index(method)
        self.slopes = self.first = self.stars = None
        if np.any(mesh.same != np.arange(n)):
            _lib.tr_average(n, mesh.same, len(values), values, np.empty(n))
        if method == "smooth":
            self.slopes = np.empty((len(values), n, 3))
            work = np.empty(9 * n)
            for value, g in zip(values, self.slopes):
                code = _long(_lib.tr_slopes, n, mesh.points, m, mesh.tet,
                             mesh.adj, value, _ROUNDS, g, work)
                if code == 6:
                    raise ValueError("tess89: values: a gradient is too large "
                                     "for a double; give them in other units")
                if code != 0:
                    _fail(code)
        if method == "nearest":
            self.first = np.empty(n + 1, np.intc)
            self.stars = np.empty(4 * m, np.intc)
            _lib.tr_stars(n, m, mesh.tet, self.first, self.stars)


def _warn(words):
    """Of what has called this package."""
    frame, level = sys._getframe(1), 2
    while frame.f_back and frame.f_globals["__name__"].startswith("tess89."):
        frame, level = frame.f_back, level + 1
    warnings.warn("tess89: values: " + words, stacklevel=level)


def _missing(absent, none):
    """The warning's words on those that are none, (n, k)."""
    n, k = absent.shape
    counts = absent.sum(0)
    if k == 1:
        return "%d of %d are %s: their points are left out" % (counts[0], n,
                                                               none)
    columns = np.flatnonzero(counts)
    told = ", ".join("column %d: %d" % (j, counts[j]) for j in columns[:9])
    return ("%s in %d of %d columns of %d values: their points are left out "
            "of these (%s%s)" % (none, len(columns), k, n, told,
                                 ", ..." if len(columns) > 9 else ""))


class Interpolator:
    """Interpolator(points, values, method='linear', fill_value=nan, \
rescale=False)

    Interpolation of scattered data in space.

    Parameters
    ----------
    points : array_like of float, shape (npoints, 3), or Delaunay, or Mesh
        The points, all finite; or a tuple of three arrays x, y, z.  Of points
        that coincide the mean of the values counts.
    values : array_like of float, shape (npoints,) or (npoints, ...)
        A value, or an array of them, for each point.  One that is NaN leaves
        its point out of its column, with a warning that counts.  By method
        'nearest' also text, as the names of rocks: str, bytes in UTF-8, or
        objects that are str; '', None and NaN are none.
    method : {'linear', 'smooth', 'natural', 'nearest'}, optional
        'linear' in each tetrahedron; 'smooth' by gradients at the points, the
        most accurate one where the field is smooth: it may leave the data's
        range; 'natural' by Sibson's natural neighbours; 'nearest' the nearest
        point's.
    fill_value : float, 'nearest' or None, optional
        The value outside the convex hull.  'nearest' or None: that of the
        hull's point nearest to the place, by method 'nearest' of the nearest
        point.  Of text NaN is '', for objects None, and other text is taken.
    rescale : bool, optional
        Scale the points to a cube first: if the axes have different units.

    Attributes
    ----------
    tri : Delaunay
        The tetrahedra of all points (scaled ones, by rescale).
    mesh : Mesh
        The same.
    points : ndarray of double, shape (npoints, 3)
        Its points.
    values : ndarray of double or text, shape (npoints, k)
        The values as they were given.
    fill_value, method
        As they were given.

    Methods
    -------
    __call__(*xi)
        Values at places.

    Raises
    ------
    ValueError
        For points, values and places of other shapes; points that are not
        finite, with the row, or in one plane (also those that are left when
        others have no value); an unknown method; infinite values, by 'smooth'.
    TypeError
        For complex numbers, masked arrays, and what is no real numbers; for
        text, by another method than 'nearest'.

    Notes
    -----
    Columns that lack other values have meshes of their own: k columns with NaN
    at different points take k times the time and memory.

    A place on the hull is inside.  A place that is not finite has NaN, or what
    that is of text.  Of points that coincide the first one's text counts, and a
    warning tells how many have another.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> f = tess89.Interpolator(points, points @ (1, 2, 3), method="natural")
    >>> f
    <tess89.Interpolator: 1000 points, values (1000,), 'natural', outside nan>
    >>> f(.5, [.4, .5], .5).round(9)
    array([2.8, 3. ])
    >>> rock = np.where(points[:, 2] < .5, "granite", "clay")
    >>> f = tess89.Interpolator(points, rock, method="nearest")
    >>> f([[.5, .5, .2], [.5, .5, .8], [2, 2, 2]])
    array(['granite', 'clay', ''], dtype='<U7')
    """

    def __init__(self, points: ArrayLike | Delaunay | Mesh, values: ArrayLike,
                 method: str = "linear",
                 fill_value: float | str | None = np.nan,
                 rescale: bool = False) -> None:
        if not isinstance(method, str) or method not in _METHODS:
            raise ValueError("tess89: method %r: choose linear, smooth, "
                             "natural or nearest" % (method,))
        self._method, self._fill_value = method, fill_value
        text = _classes(values)
        self._near = fill_value is None or (isinstance(fill_value, str) and
                                            fill_value == "nearest")
        if text is not None:
            if method != "nearest":
                raise TypeError("tess89: values: text: method %r is for "
                                "numbers; 'nearest' takes text" % method)
            self._table = self._decoder(*text[:2])
            self._fill = float(len(text[1]))
        elif not self._near:
            if isinstance(fill_value, str):
                raise ValueError("tess89: fill_value: a number or 'nearest', "
                                 "not %r" % fill_value)
            self._fill = float(_numbers(fill_value, "fill_value"))
        self._mesh: Mesh | None = None
        self._tri: Delaunay | None = None
        self._size = None
        if isinstance(points, (Delaunay, Mesh)):
            if rescale:
                raise ValueError("tess89: rescale: not with a Delaunay or Mesh "
                                 "for the points")
            self._mesh = _mesh(points)
            p = self._mesh.points
        else:
            p = _places((points,), "points")
            if p.ndim != 2:
                raise ValueError("tess89: points: the shape must be (n, 3), "
                                 "not %s" % (p.shape,))
            if rescale and len(p) > 0 and np.isfinite(p).all():
                self._size = _spread(p)
                p = p / self._size
        v = _numbers(values if text is None else text[2], "values")
        n = len(p)
        if v.shape[:1] != (n,) or v.size == 0:
            raise ValueError("tess89: values: the shape must be (%d, ...), one "
                             "row for each point, not %s" % (n, v.shape))
        self._shape = v.shape[1:]
        # a copy, lest the caller's changes count
        self._numbers = np.array(v.reshape(n, -1))
        self.values: Any = self._numbers
        self._text = text is not None
        if text is not None:
            self.values = np.array(text[0].reshape(n, -1))
        if method == "smooth":
            self._bounded()
        self._points = p
        self._others = np.zeros(n, bool)
        self._groups = list(self._grouped())
        if self._others.any():
            _warn("%d points lie where another one does, and have other text: "
                  "the first one's counts" % self._others.sum())
        if self._mesh is not None:
            self._points = self._mesh.points

    def _decoder(self, given, names):
        """The classes, and behind them what stands outside, and for none."""
        none = None if given.dtype.kind == "O" else ""
        fill = self._fill_value
        if not isinstance(fill, str):
            if fill is not None and not np.isnan(fill):
                raise ValueError("tess89: fill_value: for text: text, NaN or "
                                 "'nearest', not %r" % fill)
            fill = none
        if none is None:
            return np.array(list(names) + [fill, none], object)
        return np.concatenate((names, [fill, none]))

    def _bounded(self):
        bad = np.isinf(self._numbers).any(1)
        if bad.any():
            raise ValueError("tess89: values: row %d is infinite; NaN leaves a "
                             "point out" % np.argmax(bad))

    def _grouped(self):
        absent = np.isnan(self._numbers)
        if absent.any():
            _finite(self._points)
            _warn(_missing(absent, "'' or None" if self._text else "NaN"))
            # (a copy, lest the caller's changes count)
            self._points = np.array(self._points)
        alike = {}
        for j in range(absent.shape[1]):
            alike.setdefault(np.packbits(absent[:, j]).tobytes(), []).append(j)
        for columns in alike.values():
            there = ~absent[:, columns[0]]
            if there.all():
                mesh = self.mesh
                numbers = self._numbers[:, columns]
            else:
                try:
                    mesh = delaunay(self._points[there])
                except ValueError as e:
                    raise ValueError("%s (of the %d that have a value in column"
                                     " %d)" % (e, there.sum(), columns[0])
                                     ) from None
                numbers = self._numbers[np.ix_(there, columns)]
            if self._text:
                first = numbers[mesh.same]
                self._others[np.flatnonzero(there)] |= np.any(
                    numbers != first, 1)
                numbers = first
            yield _Group(mesh, columns, np.array(numbers.T, order="C"),
                         self.method)

    @property
    def method(self) -> str:
        return self._method

    @property
    def fill_value(self) -> float | str | None:
        return self._fill_value

    @property
    def mesh(self) -> Mesh:
        if self._mesh is None:
            self._mesh = delaunay(self._points)
        return self._mesh

    @property
    def tri(self) -> Delaunay:
        if self._tri is None:
            self._tri = Delaunay._of(self.mesh)
        return self._tri

    @property
    def points(self) -> NDArray[np.float64]:
        return self._points

    def __repr__(self) -> str:
        shape = (len(self.values),) + self._shape
        text = ", %d classes" % (len(self._table) - 2) if self._text else ""
        absent = int(np.isnan(self._numbers).sum())
        return "<tess89.%s: %d points, values %s%s%s, %r, outside %s>" % (
            type(self).__name__, len(self.values), shape, text,
            ", %d of them missing" % absent if absent else "", self.method,
            "nearest" if self._near else repr(self.fill_value))

    def __call__(self, *xi: Any) -> NDArray[Any]:
        """Values at places.

        Parameters
        ----------
        xi : array_like of float, shape (..., 3)
            The places; or three arrays x, y, z that broadcast; or a tuple of
            them, which is never read as three places.  Three numbers in a list
            are one place in an array of one.

        Returns
        -------
        ndarray of double or text, shape (...) or (..., ...)
            The values' shape behind the places'.

        Raises
        ------
        TypeError, ValueError
            For what is no real numbers, or of another shape.
        """
        q = _places(xi, "places")
        if self._size is not None:
            # (a place that is too far off for a double is outside)
            most = np.finfo(np.float64).max
            with np.errstate(over="ignore"):
                q = np.where(np.isfinite(q),
                             np.clip(q / self._size, -most, most), q)
        out: Any = None
        for g in self._groups:
            t, _, part = _many(g.mesh, g.method, g.values, g.slopes, g.first,
                               g.stars, q, False)
            if not self._near:
                part[t < _NONE] = self._fill
            if len(self._groups) == 1:
                out = part
            else:
                if out is None:
                    out = np.empty((len(t), self._numbers.shape[1]))
                out[:, g.columns] = part
        if self._text:
            out = self._table[np.where(np.isnan(out), self._fill + 1,
                                       out).astype(np.intp)]
        return out.reshape(q.shape[:-1] + self._shape)


class LinearNDInterpolator(Interpolator):
    """LinearNDInterpolator(points, values, fill_value=nan, rescale=False)

    Interpolation linear in each tetrahedron, as
    scipy.interpolate.LinearNDInterpolator.

    Parameters
    ----------
    points : array_like of float, shape (npoints, 3), or Delaunay, or Mesh
        The points, all finite; or a tuple of three arrays x, y, z.  Of points
        that coincide the mean of the values counts.
    values : array_like of float, shape (npoints,) or (npoints, ...)
        A value, or an array of them, for each point.  One that is NaN leaves
        its point out of its column, with a warning that counts.
    fill_value : float, 'nearest' or None, optional
        The value outside the convex hull.  'nearest' or None: that of the
        hull's point nearest to the place.
    rescale : bool, optional
        Scale the points to a cube first: if the axes have different units.

    See Also
    --------
    Interpolator : other methods; attributes, errors, notes.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> f = tess89.LinearNDInterpolator(points, points @ (1, 2, 3),
    ...                                 fill_value=-1)
    >>> f([[.5, .5, .5], [2, 2, 2]]).round(9)
    array([ 3., -1.])
    """

    def __init__(self, points: ArrayLike | Delaunay | Mesh, values: ArrayLike,
                 fill_value: float | str | None = np.nan,
                 rescale: bool = False) -> None:
        super().__init__(points, values, "linear", fill_value, rescale)


def interpolate(mesh: Mesh | Delaunay, values: ArrayLike, places: ArrayLike,
                method: str = "linear",
                fill_value: float | str | None = np.nan
                ) -> NDArray[Any]:
    """Values at places, with a mesh at hand.

    Parameters
    ----------
    mesh : Mesh or Delaunay
    values : array_like of float, or text, shape (n,) or (n, ...)
    places : array_like of float, shape (..., 3)
    method, fill_value
        As of Interpolator.

    Returns
    -------
    ndarray of double or text, shape (...) or (..., ...)
        What ``Interpolator(mesh, values, method, fill_value)`` gives.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> mesh = tess89.delaunay(points)
    >>> for a in 1, 2:
    ...     print(tess89.interpolate(mesh, a * points[:, 0], [[.5, .5, .5]]))
    [0.5]
    [1.]
    """
    q = _coordinates(places, "places")
    return Interpolator(_mesh(mesh), values, method,
                        fill_value)(q[..., 0], q[..., 1], q[..., 2])


def iso(points: ArrayLike | Delaunay | Mesh | Interpolator,
        values: ArrayLike | None, level: float, closed: bool = False
        ) -> Tuple[NDArray[np.float64], NDArray[np.intc]]:
    """The surface where values, linear in each tetrahedron, are level.

    Parameters
    ----------
    points : array_like of float, shape (n, 3), or Delaunay, Mesh, Interpolator
        The points, as of Interpolator; or one of method 'linear', with the
        values that it has.
    values : array_like of float, shape (n,), or None
        A finite value for each point.  One that is NaN leaves its point out,
        with a warning that counts.  None with an Interpolator.
    level : float
        The value on the surface.
    closed : bool, optional
        Close the surface where it ends at the hull, by what of the hull has
        values above the level: then it bounds what is above.

    Returns
    -------
    vertices : ndarray of double, shape (k, 3)
        Points of the surface, each once for the edge of the tetrahedra that it
        is on.
    triangles : ndarray of int32, shape (m, 3)
        Numbers of vertices, counter-clockwise as seen from below the level:
        normals point from high values to low ones.  None where no value is
        reached.

    Raises
    ------
    ValueError
        As of Interpolator; for infinite values, a level that is not finite,
        several values a point, an Interpolator of another method.
    TypeError
        For what is no real numbers.

    Examples
    --------
    >>> import numpy as np, tess89
    >>> x = np.linspace(-1, 1, 21)
    >>> points = np.stack(np.meshgrid(x, x, x), -1).reshape(-1, 3)
    >>> v, t = tess89.iso(points, np.linalg.norm(points, axis=1), .8)
    >>> bool(abs(np.linalg.norm(v, axis=1) - .8).max() < .01)
    True
    >>> a, b, c = v[t].swapaxes(0, 1)
    >>> twice = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    >>> print("%.1f" % (twice.sum() / 2))
    8.0
    """
    if isinstance(points, Interpolator):
        f = points
        if values is not None:
            raise ValueError("tess89: values: None with an Interpolator, which "
                             "has values")
        if f.method != "linear":
            raise ValueError("tess89: iso: the surface is of method 'linear', "
                             "not of %r" % f.method)
    elif values is None:
        raise ValueError("tess89: values: None with an Interpolator alone")
    else:
        f = Interpolator(points, values)
    if f.values.shape[1] != 1:
        raise ValueError("tess89: iso: one value a point is needed, not of "
                         "shape %s" % (f._shape,))
    f._bounded()
    at = _numbers(level, "level")
    if at.ndim > 0 or not np.isfinite(at):
        raise ValueError("tess89: level: one finite number is needed, not %r"
                         % (level,))
    mesh, field = f._groups[0].mesh, f._groups[0].values
    npt, ntri, room, most = _int(), _int(), 0, 0
    while True:
        vertices, ends = np.empty((room, 3)), np.empty((room, 2), np.intc)
        triangles = np.empty((most, 3), np.intc)
        code = _lib.tr_iso(mesh.points, len(mesh.tet), mesh.tet, mesh.adj,
                           field, float(at), bool(closed), room, npt, vertices,
                           ends, most, ntri, triangles,
                           np.empty(2 * room + 1, np.intc))
        if code == 0:
            break
        if ntri.value > _MOST // 6:
            raise ValueError("tess89: iso: %d triangles are too many: 4-byte "
                             "integers cannot count their points" % ntri.value)
        room = min(2 * room if most else ntri.value // 2 + 1000,
                   3 * ntri.value)
        most = ntri.value
    vertices = np.array(vertices[:npt.value])
    if f._size is not None:
        vertices *= f._size
    return vertices, triangles
