# python.py - the C library from Python, by ctypes alone.
#
#   cc -O2 -shared -fPIC -o libtess.so tess.c hhpred.c -lm
#   python3 test/examples/python.py ./libtess.so
import ctypes
import sys

lib = ctypes.CDLL(sys.argv[1])
p = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.2, 0.3, 0.4]
n = len(p) // 3
maxtet, ntet = 8 * n, ctypes.c_int()
liw, lrw = ctypes.c_int(), ctypes.c_int()
lib.tess_size(n, maxtet, ctypes.byref(liw), ctypes.byref(lrw))
p = (ctypes.c_double * (3 * n))(*p)
tet, adj = (ctypes.c_int * (4 * maxtet))(), (ctypes.c_int * (4 * maxtet))()
iw, rw = (ctypes.c_int * liw.value)(), (ctypes.c_double * lrw.value)()
code = lib.tess(n, p, maxtet, ctypes.byref(ntet), tet, adj, liw, iw, lrw, rw)
print("code %d" % code)
for t in range(ntet.value):
    print(tet[4 * t:4 * t + 4], adj[4 * t:4 * t + 4])
