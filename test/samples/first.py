# first.py - tess from Python, by ctypes: the points of a file.
#
#   make python
#   python3 test/samples/first.py
from ctypes import CDLL, byref, c_double, c_int

tess = CDLL("build/libtess.so")
rows = [r.split() for r in open("test/data/mirror.xyz") if r[0] != "#"]
n, maxtet = len(rows), 8 * len(rows)
p = (c_double * (3 * n))(*[float(x) for r in rows for x in r[:3]])
liw, lrw, ntet = c_int(), c_int(), c_int()
tess.tess_size(n, maxtet, byref(liw), byref(lrw))
iw, rw = (c_int * liw.value)(), (c_double * lrw.value)()
tet, adj = (c_int * (4 * maxtet))(), (c_int * (4 * maxtet))()
code = tess.tess(n, p, maxtet, byref(ntet), tet, adj, liw, iw, lrw, rw)
print("code %d, %d tetrahedra" % (code, ntet.value))
