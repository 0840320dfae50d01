"""Values at points, and between them."""
from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from ._mesh import (_NONE, Delaunay, Mesh, _coordinates, _fail, _lib, _long,
                    _many, _mesh, _numbers, delaunay)

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


def _missing(absent):
    """The warning's words on NaN, (n, k)."""
    n, k = absent.shape
    counts = absent.sum(0)
    if k == 1:
        return "%d of %d are NaN: their points are left out" % (counts[0], n)
    columns = np.flatnonzero(counts)
    told = ", ".join("column %d: %d" % (j, counts[j]) for j in columns[:9])
    return ("NaN in %d of %d columns of %d values: their points are left out "
            "of these (%s%s)" % (len(columns), k, n, told,
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
        its point out of its column, with a warning that counts.
    method : {'linear', 'smooth', 'natural', 'nearest'}, optional
        'linear' in each tetrahedron; 'smooth' by gradients at the points, the
        most accurate one where the field is smooth: it may leave the data's
        range; 'natural' by Sibson's natural neighbours; 'nearest' the nearest
        point's.
    fill_value : float, 'nearest' or None, optional
        The value outside the convex hull.  'nearest' or None: that of the
        hull's point nearest to the place, by method 'nearest' of the nearest
        point.
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
    values : ndarray of double, shape (npoints, k)
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
        For complex numbers, masked arrays, and what is no real numbers.

    Notes
    -----
    Columns that lack other values have meshes of their own: k columns with NaN
    at different points take k times the time and memory.

    A place on the hull is inside.  A place that is not finite has NaN.

    Examples
    --------
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> f = Interpolator(points, points @ (1, 2, 3), method="natural")
    >>> f(.5, [.4, .5], .5).round(9)
    array([2.8, 3. ])
    """

    def __init__(self, points: ArrayLike | Delaunay | Mesh, values: ArrayLike,
                 method: str = "linear",
                 fill_value: float | str | None = np.nan,
                 rescale: bool = False) -> None:
        if not isinstance(method, str) or method not in _METHODS:
            raise ValueError("tess89: method: one of %s, not %r"
                             % (", ".join(_METHODS), method))
        self._method, self._fill_value = method, fill_value
        self._near = fill_value is None or isinstance(fill_value, str)
        if isinstance(fill_value, str) and fill_value != "nearest":
            raise ValueError("tess89: fill_value: a number or 'nearest', not "
                             "%r" % fill_value)
        if not self._near:
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
        v = _numbers(values, "values")
        n = len(p)
        if v.shape[:1] != (n,) or v.size == 0:
            raise ValueError("tess89: values: the shape must be (%d, ...), one "
                             "row for each point, not %s" % (n, v.shape))
        self._shape = v.shape[1:]
        # a copy, lest the caller's changes count
        self.values = np.array(v.reshape(n, -1))
        if method == "smooth" and np.isinf(self.values).any():
            raise ValueError("tess89: values: row %d is infinite; NaN leaves a "
                             "point out" % np.argmax(np.isinf(self.values)
                                                     .any(1)))
        self._points = p
        self._groups = list(self._grouped())
        if self._mesh is not None:
            self._points = self._mesh.points

    def _grouped(self):
        absent = np.isnan(self.values)
        if absent.any():
            bad = ~np.isfinite(self._points).all(1)
            if bad.any():
                i = np.argmax(bad)
                raise ValueError("tess89: point %d is not finite: %s"
                                 % (i, self._points[i]))
            # (of what has called this class, or one made of it)
            warnings.warn("tess89: values: " + _missing(absent), stacklevel=3 +
                          (type(self).__init__ is not Interpolator.__init__))
            # (a copy, lest the caller's changes count)
            self._points = np.array(self._points)
        alike = {}
        for j in range(absent.shape[1]):
            alike.setdefault(np.packbits(absent[:, j]).tobytes(), []).append(j)
        for columns in alike.values():
            there = ~absent[:, columns[0]]
            if there.all():
                mesh = self.mesh
                values = self.values[:, columns]
            else:
                try:
                    mesh = delaunay(self._points[there])
                except ValueError as e:
                    raise ValueError("%s (of the %d that have a value in column"
                                     " %d)" % (e, there.sum(), columns[0])
                                     ) from None
                values = self.values[np.ix_(there, columns)]
            yield _Group(mesh, columns, np.array(values.T, order="C"),
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

    def __call__(self, *xi: Any) -> NDArray[np.float64]:
        """Values at places.

        Parameters
        ----------
        xi : array_like of float, shape (..., 3)
            The places; or three arrays x, y, z that broadcast; or a tuple of
            them, which is never read as three places.  Three numbers in a list
            are one place in an array of one.

        Returns
        -------
        ndarray of double, shape (...) or (..., ...)
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
                    out = np.empty((len(t), self.values.shape[1]))
                out[:, g.columns] = part
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
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> f = LinearNDInterpolator(points, points @ (1, 2, 3), fill_value=-1)
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
                ) -> NDArray[np.float64]:
    """Values at places, with a mesh at hand.

    Parameters
    ----------
    mesh : Mesh or Delaunay
    values : array_like of float, shape (n,) or (n, ...)
    places : array_like of float, shape (..., 3)
    method, fill_value
        As of Interpolator.

    Returns
    -------
    ndarray of double, shape (...) or (..., ...)
        What ``Interpolator(mesh, values, method, fill_value)`` gives.
    """
    q = _coordinates(places, "places")
    return Interpolator(_mesh(mesh), values, method,
                        fill_value)(q[..., 0], q[..., 1], q[..., 2])
