"""beside.py - what tests beside NumPy and SciPy share: points, fields, places;
files that are written and read."""
import collections
import csv

import pytest

np = pytest.importorskip("numpy")

METHODS = ["linear", "smooth", "natural", "nearest"]
BOX = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)


# ---- points, fields, places ----

def chance(seed):
    return np.random.default_rng(seed)


def flat(x):
    """a linear field"""
    return 7 + 2 * x[..., 0] - 3 * x[..., 1] + 0.5 * x[..., 2]


def bent(x):
    return np.sin(5 * x[..., 0]) * np.cos(4 * x[..., 1]) + x[..., -1] ** 2


def turn(seed):
    """an orthogonal matrix"""
    return np.linalg.qr(chance(seed).normal(size=(3, 3)))[0]


def grid(low, high, size):
    """A grid's places, by the rule that -h gives, as [z, y, x, axis]."""
    axis = [np.linspace(a, b, n) if n > 1 else np.array([(a + b) / 2])
            for a, b, n in zip(low, high, size)]
    return np.stack(np.meshgrid(*axis[::-1], indexing="ij")[::-1], -1)


def lattice(n):
    """n times n times n points, x fastest"""
    return grid((0, 0, 0), (n - 1,) * 3, (n,) * 3).reshape(-1, 3)


def listed(numbers):
    """as an option has them"""
    return ",".join(repr(float(x)) if x % 1 else "%d" % x for x in numbers)


def scipy():
    """its modules interpolate and spatial"""
    pytest.importorskip("scipy")
    import scipy.interpolate
    import scipy.spatial
    return scipy


def linear(points, values, places):
    """SciPy's; points: an array, or their Delaunay"""
    return scipy().interpolate.LinearNDInterpolator(points, values)(places)


def nearest(points, values, places):
    return values[scipy().spatial.cKDTree(points).query(places)[1]]


def beyond(points, places):
    """which places are outside the hull of the points, an array or their Delaunay"""
    return np.isnan(linear(points, np.zeros(len(getattr(points, "points", points))),
                           places))


def same(a, b, most=0.0):
    """Within most of each other, NaN at the same places."""
    a, b = np.asarray(a), np.asarray(b)
    assert a.shape == b.shape
    np.testing.assert_allclose(a, b, rtol=0, atol=most)


# ---- files ----

def save(name, *columns, names="x,y,z,T,U,V", between=","):
    """columns: arrays of one or more each; names: none, or at least so many"""
    rows = np.column_stack(columns)
    many = rows.shape[1]
    text = (between.join(["%.17g"] * many) + "\n") * len(rows) % tuple(
        rows.ravel().tolist())
    with open(name, "w") as f:
        f.write(names and ",".join(names.split(",")[:many]) + "\n")
        f.write(text)
    return name


def text(name):
    with open(name, encoding="utf-8") as f:
        return f.read()


def words(name):
    with open(name, newline="") as f:
        return list(csv.reader(f))


def load(name):
    """a CSV file's names, and its numbers, an array"""
    head, *rows = text(name).splitlines()
    return head.split(","), np.array([r.split(",") for r in rows], float)


def obj(name):
    """Points, triangles."""
    rows = [line.split() for line in text(name).splitlines()]
    return [np.array([w[1:] for w in rows if w[0] == what], kind).reshape(-1, 3) - first
            for what, kind, first in (("v", float, 0), ("f", int, 1))]


Data = collections.namedtuple("Data", "set points cells values sizes kinds")


def by_vtk(name):
    """What VTK reads in a file: the set; its points; its cells, or None if they
    have not all the same number of points; values of points and of cells, by
    their names; the cells' types."""
    vtk = pytest.importorskip("vtk")
    from vtk.util.numpy_support import vtk_to_numpy as array
    r = {"vtk": vtk.vtkDataSetReader, "vtu": vtk.vtkXMLUnstructuredGridReader,
         "obj": vtk.vtkOBJReader, "ply": vtk.vtkPLYReader,
         "stl": vtk.vtkSTLReader}[name[-3:]]()
    r.SetFileName(name)
    if name.endswith(".vtk"):
        r.ReadAllScalarsOn()
    r.Update()
    m = r.GetOutput()
    values, sizes = ({d.GetArrayName(i): array(d.GetArray(i))
                      for i in range(d.GetNumberOfArrays())}
                     for d in (m.GetPointData(), m.GetCellData()))
    if m.IsA("vtkImageData"):
        n = m.GetDimensions()
        at = np.stack(np.meshgrid(*map(np.arange, n[::-1]), indexing="ij")[::-1], -1)
        return Data(m, at.reshape(-1, 3) * m.GetSpacing() + m.GetOrigin(), None, values,
                    sizes, None)
    polygons = m.IsA("vtkPolyData")
    c = m.GetPolys() if polygons else m.GetCells()
    many = set(np.diff(array(c.GetOffsetsArray())))
    return Data(m, array(m.GetPoints().GetData()),
                array(c.GetConnectivityArray()).reshape(-1, *many)
                if len(many) == 1 else None, values, sizes,
                None if polygons else array(m.GetCellTypesArray()))
