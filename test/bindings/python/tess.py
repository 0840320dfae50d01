"""The module tess89 under its name before version 5.0, which goes with 5.1.

    >>> import tess89            # pip install ./test/bindings/python

Interpolator and interpolate take `outside' for what is fill_value there, and
three numbers in a list are one place, with a value that is no array.
"""
import os
import sys
import warnings

import numpy as np

try:
    import tess89
except ImportError:
    sys.path.append(os.path.dirname(os.path.abspath(__file__)))
    import tess89
from tess89 import Mesh, delaunay, hull, locate, volumes

__all__ = ["Mesh", "delaunay", "locate", "Interpolator", "interpolate", "hull",
           "volumes"]

warnings.warn("tess: the module is tess89 now: `pip install "
              "./test/bindings/python' and `import tess89'; tess goes with "
              "version 5.1", FutureWarning,
              stacklevel=2)


class Interpolator(tess89.Interpolator):
    """Interpolator(points, values, method="linear", outside=nan): as
    tess89.Interpolator."""

    def __init__(self, points, values, method="linear", outside=np.nan):
        super().__init__(points, values, method, outside)

    def __call__(self, *places):
        if len(places) == 1:
            q = np.asarray(places[0])
            if q.shape[-1:] == (3,):
                places = q[..., 0], q[..., 1], q[..., 2]
        return super().__call__(*places)


def interpolate(mesh, values, places, method="linear", outside=np.nan):
    """As tess89.interpolate."""
    return tess89.interpolate(mesh, values, places, method, outside)
