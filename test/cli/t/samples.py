# samples.py - a sample of each format that build/tess reads, for test_contract.py
# and test_messages.py: the same five points (STL's corners are six).
import re
import struct

P = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2), (0.134, 0.25, -0.5)]
V = [0, 10, 20, 30, 40]
CORNERS = [P[0], P[1], P[2], P[0], P[3], P[4]]
TABLE = [["%g" % x for x in (*p, v)] for p, v in zip(P, V)]


def csv_of(header, rows, between=","):
    return between.join(header) + "\n" + "".join(
        between.join(r) + "\n" for r in rows)


def points_of(node):
    """what is written in a .node file, sorted"""
    return sorted(tuple(float(x) for x in line.split()[1:4])
                  for line in node.splitlines()[1:]
                  if line[0].isdigit() and "," not in line)


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
# by the formats' definitions: R's write.table, numpy.savetxt's head, GeoEAS's
# and GSLIB's data files, Amber's restarts, GOCAD's ASCII objects, Nastran's bulk
# data in their three widths, CFX's exports, Petrel's points, the Canadian Well
# Logging Society's LAS 2.0, Sea-Bird's .cnv, CCHDO's and ODV's tables, PQR as
# PDB2PQR writes it.  (R 4.2, NumPy and meshio write what test_others.py reads.)
CNV = """* Sea-Bird SBE 9 Data File:
* FileName = CAST7.HEX
# nquan = 5
# nvalues = 5
# name 0 = longitude: Longitude [deg]
# name 1 = latitude: Latitude [deg]
# name 2 = depSM: Depth [salt water, m]
# name 3 = t090C: Temperature [ITS-90, deg C]
# name 4 = flag:  0.000e+00
# bad_flag = -9.990e-29
# file_type = ascii
*END*
"""
WELL = """~Version Information
 VERS.                 2.0 :   CWLS LOG ASCII STANDARD - VERSION 2.0
 WRAP.                  NO :   ONE LINE PER DEPTH STEP
~Well Information
# by hand
 STRT.M             1.0000 :
 NULL.           -999.2500 :
~Curve Information
 INDEX.    :
 X.M       : east
 Y.M       :
 TVD.M     :
 GR.API    :
~A  INDEX  X  Y  TVD  GR
"""
POST = """
[Name]
Outlet Plane

[Spatial Fields]
x, y, z

[Data]
X [ m ], Y [ m ], Z [ m ], Temperature [ K ]
"""
GOCAD = """GOCAD TSurf 1
HEADER {
name:thing
}
GOCAD_ORIGINAL_COORDINATE_SYSTEM
ZPOSITIVE Elevation
END_ORIGINAL_COORDINATE_SYSTEM
PROPERTIES T
NO_DATA_VALUES -99999
TFACE
"""
BOTTLE = """BOTTLE,20200907XXXABC
# by hand
EXPOCODE,LONGITUDE,LATITUDE,CTDPRS,CTDTMP
,,,DBAR,ITS-90
"""


def bulk(form, last=""):
    """a card for each point: number, x, y, z"""
    return "".join(form % (i + 1, *("%.3f" % x for x in p)) + last + "\n"
                   for i, p in enumerate(P))


def restart():
    x = ["%12.7f" % c for p in P for c in p]
    return "by hand\n%5d\n" % len(P) + "".join(
        "".join(x[k:k + 6]) + "\n" for k in range(0, 15, 6)) + \
        "%12.7f" * 6 % (9, 9, 9, 90, 90, 90) + "\n"


SAMPLES = {
    "rows.txt": '"x" "y" "z" "T"\n' + "".join(
        '"%d" %s\n' % (i + 3, line) for i, line in enumerate(
            rows(values=True).splitlines())),
    "savetxt.txt": "# T, X, Y, Z\n" + "".join(
        "%d %g %g %g\n" % (v, *p) for p, v in zip(P, V)),
    "ids.txt": "".join("%d %s\n" % (1001 + i, line) for i, line in enumerate(
        rows(values=True).splitlines())),
    "geoeas.dat": "by hand\n4\nX\nY (m)\nZ\nT\n" + rows(values=True),
    "turned.txt": "by hand\n5\n" + rows(values=True),
    "restart.rst7": restart(),
    "set.ts": GOCAD + "".join("PVRTX %d %g %g %g %g\n" % (i + 1, *p, v)
                              for i, (p, v) in enumerate(zip(P, V))) +
              "TRGL 1 2 3\nEND\n",
    "short.bdf": "$ by hand\n" + bulk("GRID    %8d        %8s%8s%8s") +
                 "CTETRA  1       1       1       2       3       4\n",
    "wide.bdf": bulk("GRID*   %16d                %16s%16s*\n*       %16s"),
    "free.bdf": "CEND\nBEGIN BULK\n" + bulk("GRID,%d,,%s,%s,%s") + "ENDDATA\n",
    "post.csv": POST + rows(", ", values=True) + "\n[Faces]\n0, 1, 2\n",
    "petrel.txt": "# Petrel Points with attributes\nVERSION 1\nBEGIN HEADER\n"
                  "X\nY\nZ\nFLOAT,T\nEND HEADER\n" + rows(values=True),
    "well.las": WELL + "".join("%6.1f %g %g %g %g\n" % (i + 1, *p, v)
                               for i, (p, v) in enumerate(zip(P, V))),
    "cast.cnv": CNV + "".join("%11g%11g%11g%11g%11g\n" % (*p, v, 0)
                              for p, v in zip(P, V)),
    "bottle.csv": BOTTLE + rows(",", "99XX1,", values=True) + "END_DATA\n",
    "odv.txt": "// by hand\nCruise\tStation\tType\tLongitude [degrees_east]\t"
               "Latitude [degrees_north]\tDepth [m]\tT\n" +
               rows("\t", "A\ts\tB\t", values=True),
    "atoms.pqr": "REMARK by hand\n" + "".join(
        "ATOM  %5d  C   LYS  %4d    %8.3f%8.3f%8.3f %7.4f %6.4f\n" % (
            i + 1, i + 1, *p, v / 10, 1.5) for i, (p, v) in enumerate(
                zip(P, V))),
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
          "atoms.pdb": rb"ATOM .{25} *", "dump.lammpstrj": rb"\d ",
          "rows.txt": rb'"\d" ', "savetxt.txt": rb"\d+ ", "ids.txt": rb"\d+ ",
          "set.ts": rb"PVRTX \d ", "short.bdf": rb"GRID.{12} *",
          "wide.bdf": rb"GRID.{36} *", "free.bdf": rb"GRID,\d,,",
          "well.las": rb" *\d\.0 ", "cast.cnv": rb" *", "bottle.csv": rb"99XX1,",
          "odv.txt": rb"A\ts\tB\t", "atoms.pqr": rb"ATOM .{25} *"}
BETWEEN = {"names.csv": b",", "atoms.pdb": b" +", "atoms.pqr": b" +",
           "short.bdf": b" +", "wide.bdf": rb"\*?\n?\*? +", "free.bdf": b",",
           "post.csv": b", ", "cast.cnv": b" +", "bottle.csv": b",",
           "odv.txt": b"\t"}
FIXED = {"atoms.pdb", "atoms.pqr", "short.bdf", "wide.bdf", "free.bdf"}


def row_matches(name, content):
    """of each row, with its coordinates as groups"""
    between = BETWEEN.get(name, b" ")
    form = b"%.3f" if name in FIXED else b"%g"
    at = 0
    for p in CORNERS if name == "mesh.stl" else P:
        m = re.compile(
            b"(?m)^" + BEFORE.get(name, b"") + between.join(
                b"(%s)" % re.escape(form % x) for x in p)).search(content, at)
        at = m.end()
        yield m
