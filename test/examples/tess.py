# tess.py - tess for NumPy, by ctypes: a module to copy.
#
#   cc -O3 -shared -fPIC -o libtess.so tess.c hhpred.c -lm
#   PYTHONPATH=test/examples python3
#   >>> import numpy, tess
#   >>> p = numpy.random.rand(1000, 3)
#   >>> mesh = tess.delaunay(p)
#   >>> tess.interpolate(mesh, p[:, 0], [[.5, .5, .5], [2, 2, 2]])
#   array([0.5, nan])
#
# It looks for libtess.so where this file is, then where Python was started.
# The library must have been compiled without -DTESS_INT and -DTESS_FLOAT.
import ctypes
import os
from collections import namedtuple

import numpy as np

_here = os.path.join(os.path.dirname(os.path.abspath(__file__)), "libtess.so")
_lib = ctypes.CDLL(_here if os.path.exists(_here) else "./libtess.so")

_int = ctypes.c_int
_pint = ctypes.POINTER(ctypes.c_int)
_ints = np.ctypeslib.ndpointer(np.intc, flags="C_CONTIGUOUS")
_reals = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")
_tess = [_int, _reals, _int, _pint, _ints, _ints, _int, _ints, _int, _reals]

_lib.tess_size.argtypes = [_int, _int, _pint, _pint]
_lib.tess.argtypes = _tess
_lib.tess_resume.argtypes = _tess
_lib.tess_values.argtypes = [_reals, _int, _ints, _ints, _int, _reals, _int,
                             _reals, _ints, _reals]
_lib.tess_hull.argtypes = [_int, _ints, _ints, _int, _pint, _ints]

MORE, POOL, NONE = 1, 2, -1

# points (n, 3); tet and adj (m, 4): vertices of the tetrahedra, and the one
# across the facet opposite to each, -1 on the hull; same (n): i, or for a
# duplicate the point that stands for it
Mesh = namedtuple("Mesh", "points tet adj same")

_why = {-2: "a coordinate is not finite", 3: "all points lie in one plane",
        4: "all points lie on one line", 5: "at most one distinct point"}


def _fail(code):
    raise ValueError("tess: " + _why.get(code, "code %d" % code))


def _places(x):
    x = np.ascontiguousarray(x, dtype=np.float64)
    if x.ndim == 0 or x.shape[-1] != 3:
        raise ValueError("tess: places have three coordinates each")
    return x


def delaunay(points):
    """The Delaunay tetrahedralization of points (n, 3), as a Mesh."""
    p = _places(points).reshape(-1, 3)
    n, room, pool = len(p), 8 * len(p) + 64, 1
    tet = adj = np.empty((0, 4), np.intc)
    ntet, liw, lrw = _int(0), _int(), _int()
    while True:
        if _lib.tess_size(n, room, liw, lrw) < 0:
            raise ValueError("tess: too many points")
        more = np.empty((room - len(tet), 4), np.intc)
        tet, adj = np.concatenate((tet, more)), np.concatenate((adj, more))
        iw, rw = np.empty(pool * liw.value, np.intc), np.empty(lrw.value)
        code = _lib.tess_resume(n, p, room, ntet, tet, adj, len(iw), iw,
                                len(rw), rw)
        if code == MORE:
            room *= 2
        elif code == POOL:
            pool *= 2
        elif code == 0:
            m = ntet.value
            return Mesh(p, tet[:m].copy(), adj[:m].copy(), iw[:n].copy())
        else:
            _fail(code)


def _values(mesh, values, q):
    nv, nq = values.shape[1], q.size // 3
    t, out = np.full(nq, NONE, np.intc), np.empty((nq, nv))
    code = _lib.tess_values(mesh.points, len(mesh.tet), mesh.tet, mesh.adj, nv,
                            values, nq, q, t, out)
    if code != 0 and code != 1:
        _fail(-2 if code == -8 else code)
    return t, out


def locate(mesh, places):
    """The tetrahedron that holds each of the places (..., 3); -1 outside."""
    q = _places(places)
    t, _ = _values(mesh, np.empty((len(mesh.points), 0)), q)
    return np.maximum(t, NONE).reshape(q.shape[:-1])


def interpolate(mesh, values, places, outside=np.nan):
    """Values (n) or (n, k) of the points, linearly interpolated at places
    (..., 3): shape (...) or (..., k); outside the hull what outside says, or
    the value at the hull's nearest point if that is None."""
    values = np.ascontiguousarray(values, dtype=np.float64)
    if values.shape[:1] != (len(mesh.points),):
        raise ValueError("tess: not one value, or one row, for each point")
    q = _places(places)
    t, out = _values(mesh, values.reshape(len(values), -1), q)
    if outside is not None:
        out[t < 0] = outside
    return out.reshape(q.shape[:-1] + values.shape[1:])


def hull(mesh):
    """The hull's triangles (m, 3), counter-clockwise seen from outside."""
    fac = np.empty((np.count_nonzero(mesh.adj == NONE), 3), np.intc)
    nfac = _int()
    code = _lib.tess_hull(len(mesh.tet), mesh.tet, mesh.adj, len(fac), nfac,
                          fac)
    if code != 0:
        _fail(code)
    return fac
