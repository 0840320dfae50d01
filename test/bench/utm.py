#!/usr/bin/env python3
"""utm.py - meshes of surveys in projected coordinates, by scipy and by tess.

A survey is 100 random points in a block at 500,000 m east and 5,000,000 m north,
rounded to the centimetre or the millimetre, as files of coordinates have them.
A mesh is counted as wrong if a tetrahedron is flat, or a neighbour's opposite
vertex is inside its circumsphere: by exact integers, in the units of rounding,
which all decisions of the mesh are invariant to.  (A mesh of several that ties
allow is right.)

    python3 test/bench/utm.py > test/results/utm.txt

from the top directory, after `make'.  Needs NumPy and scipy.
"""
import subprocess

import numpy
import scipy
from scipy.spatial import Delaunay

SURVEYS = 300
POINTS = 100
EAST, NORTH = 500000, 5000000


def determinant(rows):
    """Of square matrices in exact integers, by the first row."""
    if rows.shape[1] == 1:
        return rows[:, 0, 0]
    total = 0
    for k in range(rows.shape[1]):
        rest = numpy.delete(rows[:, 1:], k, axis=2)
        total = total + (-1) ** k * rows[:, 0, k] * determinant(rest)
    return total


def is_delaunay(points, tetrahedra):
    """Of integer points: no flat tetrahedron, no neighbour's apex in a ball."""
    corners = points.astype(object)[tetrahedra]
    volume = determinant(corners[:, 1:] - corners[:, :1])
    if any(v == 0 for v in volume):
        return False
    facets = {}
    for t, vertices in enumerate(tetrahedra):
        for vertex in vertices:
            facets.setdefault(frozenset(vertices) - {vertex}, []).append((t, vertex))
    pairs = [sides for sides in facets.values() if len(sides) == 2]
    t = [sides[0][0] for sides in pairs]
    apexes = points.astype(object)[[sides[1][1] for sides in pairs]]
    seen = corners[t] - apexes[:, None]
    lifted = numpy.concatenate([seen, (seen * seen).sum(2)[:, :, None]], 2)
    # the determinant has the sign of the volume where the apex is outside
    return all(determinant(lifted) * volume[t] >= 0)


def by_tess(coordinates):
    with open("build/utm.xyz", "w") as file:
        for row in coordinates:
            print(*["%.3f" % x for x in row], file=file)
    subprocess.run(["build/tess", "-q", "-o", "build/utm", "build/utm.xyz"],
                   check=True)
    first = numpy.loadtxt("build/utm.node", skiprows=1, dtype=int, usecols=0)[0]
    return numpy.loadtxt("build/utm.ele", skiprows=1, dtype=int)[:, 1:5] - first


def main():
    print("Written by: python3 test/bench/utm.py")
    print("scipy %s, NumPy %s" % (scipy.__version__, numpy.__version__))
    print()
    print("Surveys, of %d, whose mesh is not Delaunay, in exact arithmetic:" % SURVEYS)
    print()
    print("| width, m | rounded to, m | scipy | tess |")
    print("| ---: | ---: | ---: | ---: |")
    for width, digits in (100, 2), (100, 3), (1000, 2), (1000, 3):
        random = numpy.random.default_rng(width + digits)
        wrong = [0, 0]
        for _ in range(SURVEYS):
            low = numpy.array([EAST, NORTH, 0]) * 10**digits
            size = numpy.array([width, width, width / 5]) * 10**digits
            points = low + numpy.floor(random.uniform(0, size, (POINTS, 3)))
            points = points.astype(numpy.int64)
            coordinates = points / 10.0**digits
            wrong[0] += not is_delaunay(points, Delaunay(coordinates).simplices)
            wrong[1] += not is_delaunay(points, by_tess(coordinates))
        print("| %d | %g | %d | %d |" % (width, 10.0**-digits, *wrong))


main()
