"""Delaunay tetrahedralization and interpolation in space
======================================================

scipy's names and forms, for points in space alone: exact, and several times
as fast.

    >>> import numpy as np, tess89
    >>> points = np.random.default_rng(1).random((1000, 3))
    >>> f = tess89.LinearNDInterpolator(points, points[:, 0])
    >>> f([[.5, .5, .5], [2, 2, 2]])
    array([0.5, nan])

As in scipy.spatial and scipy.interpolate
-----------------------------------------
Delaunay              the tetrahedra of points, their neighbours, the hull
LinearNDInterpolator  values at points -> values anywhere, linear in each
                      tetrahedron

Besides
-------
Interpolator          the same by tetrahedra, smooth, by natural neighbours or
                      by the nearest point, which may have text
iso                   the surface where values are one level, of triangles
delaunay              points -> Mesh, a tuple of four arrays
locate                the tetrahedra at places, and weights there
interpolate           values at places, with a mesh at hand
hull                  the convex hull's triangles, turned outwards
volumes               of the points' Voronoi cells

Missing values, points that coincide
------------------------------------
A value that is NaN leaves its point out of its column, and a warning tells how
many there are.  Of points that coincide the mean of the values counts, of text
the first.  A point that is not finite is a ValueError with its row and column.
A place that is not finite is in no tetrahedron, and its value is NaN.

Arrays may be whatever numpy.asarray takes, of real numbers; masked arrays and
complex numbers are a TypeError.  All is thread-safe, and other threads run
while the library works.  Ctrl-C ends a call between blocks of places; what
makes a mesh, or gradients, ends by itself later, in the background.
"""
from ._mesh import Delaunay, Mesh, delaunay, hull, locate, volumes
from ._values import Interpolator, LinearNDInterpolator, interpolate, iso

__version__ = "5.0"
__all__ = ["Delaunay", "LinearNDInterpolator", "Interpolator", "Mesh",
           "delaunay", "locate", "interpolate", "iso", "hull", "volumes"]
