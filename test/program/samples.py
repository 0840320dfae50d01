# samples.py - a sample of each format that build/tess reads, for contract.py
# and messages.py: the same five points (STL's corners are six).
import re
import struct
import sys

TESS = sys.argv[1]
P = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2), (0.134, 0.25, -0.5)]
V = [0, 10, 20, 30, 40]
CORNERS = [P[0], P[1], P[2], P[0], P[3], P[4]]


def test(name, good):
    print(("ok      " if good else "FAILED  ") + name, flush=True)


def rows(between=" ", first="", last="", values=False):
    return "".join(first + between.join("%g" % x for x in p) +
                   (between + "%g" % v if values else "") + last + "\n"
                   for p, v in zip(P, V))


def atoms():
    line = "ATOM  %5d %-4s LYS A%4d    %8.3f%8.3f%8.3f%6.2f%6.2f\n"
    return "".join(line % (i + 1, " C", i + 1, *p, 1, v)
                   for i, (p, v) in enumerate(zip(P, V)))


def stl():
    text = "solid thing\n"
    for k in 0, 3:
        text += " facet normal 0 0 1\n  outer loop\n"
        for p in CORNERS[k:k + 3]:
            text += "   vertex %g %g %g\n" % p
        text += "  endloop\n endfacet\n"
    return text + "endsolid thing\n"


def npy():
    head = ("{'descr': '<f8', 'fortran_order': False, 'shape': (5, 4), }"
            .ljust(117) + "\n").encode()
    return (b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head +
            packed("<4d"))


def packed(form):
    return b"".join(struct.pack(form, *p, v) for p, v in zip(P, V))


def las():
    head = bytearray(227)
    head[0:4] = b"LASF"
    head[24:26] = 1, 2
    struct.pack_into("<HIIBHI", head, 94, 227, 227, 0, 0, 20, 5)
    struct.pack_into("<6d", head, 131, .001, .001, .001, 0, 0, 0)
    struct.pack_into("<6d", head, 179, 1, 0, 1.5, 0, 0, -2)
    return bytes(head) + b"".join(
        struct.pack("<3iH6x", *(round(1000 * x) for x in p), v)
        for p, v in zip(P, V))


PLY = """ply
format %s 1.0
comment by hand
element vertex 5
property double x
property double y
property double z
property double T
element face 1
property list uchar int vertex_index
end_header
"""
PCD = """# .PCD v0.7
VERSION 0.7
FIELDS x y z T
SIZE 8 8 8 8
TYPE F F F F
COUNT 1 1 1 1
WIDTH 5
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 5
DATA %s
"""
SAMPLES = {
    "lines.txt": "# by hand\n" + rows(values=True),
    "names.csv": "x,y,z,T\n" + rows(",", values=True),
    "counted.txt": "5\n" + rows(),
    "atoms.xyz": "5\na comment\n" + rows(first="C "),
    "more.xyz": '5\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3'
                ':u:R:1 pbc="T F T" time=7\n' + rows(first="C ", values=True),
    "node.node": "5 3 1 0\n" + "".join(
        "%d %g %g %g %g\n" % (i, *p, v) for i, (p, v) in enumerate(zip(P, V))),
    "mesh.off": "OFF\n5 2 0\n" + rows() + "3 0 1 2\n3 0 1 4\n",
    "mesh.ply": PLY % "ascii" + rows(values=True) + "3 0 1 2\n",
    "packed.ply": (PLY % "binary_little_endian").encode() + packed("<4d") +
                  struct.pack("<B3i", 3, 0, 1, 2),
    "mesh.obj": "# by hand\no thing\n" + rows(first="v ") + "vn 0 0 1\n"
                "f 1 2 3\n",
    "mesh.stl": stl(),
    "packed.stl": b"by hand".ljust(80) + struct.pack("<I", 2) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *(x for p in CORNERS[k:k + 3] for x in p),
                    0) for k in (0, 3)),
    "array.npy": npy(),
    "atoms.pdb": "HEADER    BY HAND\n" + atoms() + "END\n",
    "cloud.pcd": PCD % "ascii" + rows(values=True),
    "packed.pcd": (PCD % "binary").encode() + packed("<4d"),
    "dump.lammpstrj": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\n"
                      "ITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n-3 4\n"
                      "ITEM: ATOMS id x y z\n" + "".join(
                          "%d %g %g %g\n" % (i + 1, *p)
                          for i, p in enumerate(P)),
    "survey.las": las(),
}
SAMPLES = {k: v if isinstance(v, bytes) else v.encode()
           for k, v in SAMPLES.items()}

# what is before the coordinates in a row
BEFORE = {"atoms.xyz": rb"C ", "more.xyz": rb"C ", "node.node": rb"\d ",
          "mesh.obj": rb"v ", "mesh.stl": rb" *vertex ",
          "atoms.pdb": rb"ATOM .{25} *", "dump.lammpstrj": rb"\d "}


def row_matches(name, content):
    """of each row, with its coordinates as groups"""
    between = b"," if name == "names.csv" else \
        b" +" if name == "atoms.pdb" else b" "
    form = b"%.3f" if name == "atoms.pdb" else b"%g"
    at = 0
    for p in CORNERS if name == "mesh.stl" else P:
        m = re.compile(
            b"(?m)^" + BEFORE.get(name, b"") + between.join(
                b"(%s)" % re.escape(form % x) for x in p)).search(content, at)
        at = m.end()
        yield m
