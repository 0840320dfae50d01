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


class Sample:
    """A file of the five points; of its kinds
        open    it has no count: what a cut between two lines leaves is sound
        ended   what ends it says so
        box     it has a box that repeats itself
        named   it has titles or labels, which -volumes alone shows
        packed  its rows are bytes
        fixed   its coordinates have three digits
    and, as expressions, what is before the coordinates of a row and between them,
    the count of its head, and what may be deaf: in groups, or a range of bytes."""

    def __init__(self, content, kinds="", deaf=(), before=b"", between=b" ",
                 count=None):
        self.content = content if isinstance(content, bytes) else content.encode()
        self.kinds, self.deaf, self.count = kinds.split(), deaf, count
        self.before, self.between = before, between


NUMBERED = rows(values=True).splitlines()
VIEWPOINT = [rb"VIEWPOINT( .*)\n", rb"#(.*)\n", rb"VERSION (.*)\n"]
# (deaf are titles of coordinates, but for what they are; numbers of points; what
# stands for no number, where no value has it)
FORMATS = {
    "rows.txt": Sample('"x" "y" "z" "T"\n' + "".join(
        '"%d" %s\n' % (i + 3, line) for i, line in enumerate(NUMBERED)),
        "open named", [rb'"(\d)" '], rb'"\d" '),
    "savetxt.txt": Sample("# T, X, Y, Z\n" + "".join(
        "%d %g %g %g\n" % (v, *p) for p, v in zip(P, V)), "open named", [rb"(X),"],
        rb"\d+ "),
    "ids.txt": Sample("".join("%d %s\n" % (1001 + i, line) for i, line in enumerate(
        NUMBERED)), "open", [rb"\n(1005) "], rb"\d+ "),
    "geoeas.dat": Sample("by hand\n4\nX\nY (m)\nZ\nT\n" + rows(values=True),
                         "open named", [rb"^(.*)\n", rb"\n(X)\n", rb"(\))\n"],
                         count=rb"\n(4)\n"),
    "turned.txt": Sample("by hand\n5\n" + rows(values=True), "", [rb"^(.*)\n"],
                         count=rb"\n(5)\n"),
    "restart.rst7": Sample(restart(), "box", [rb"^(.*)\n"], count=rb" (5)\n"),
    "set.ts": Sample(GOCAD + "".join("PVRTX %d %g %g %g %g\n" % (i + 1, *p, v)
                                     for i, (p, v) in enumerate(zip(P, V))) +
                     "TRGL 1 2 3\nEND\n", "ended named", [
                         rb"TSu(.*)\n", rb"HEADER \{\n(.*)\n", rb"ZPOSITIVE (.*)\n",
                         rb"VALUES -(.*)\n", rb"PVRTX (\d)", rb"TRGL( .*)\n"],
                     rb"PVRTX \d "),
    "short.bdf": Sample("$ by hand\n" + bulk("GRID    %8d        %8s%8s%8s") +
                        "CTETRA  1       1       1       2       3       4\n",
                        "open fixed", [rb"\$(.*)\n", rb"(CTETRA.*)\n",
                                       rb"GRID {4}(.{8})"], rb"GRID.{12} *", b" +"),
    "wide.bdf": Sample(bulk("GRID*   %16d                %16s%16s*\n*       %16s"),
                       "open fixed", [rb"GRID\* {3}(.{16})", rb"(\*)\n",
                                      rb"\n\*(.{7})"], rb"GRID.{36} *",
                       rb"\*?\n?\*? +"),
    "free.bdf": Sample("CEND\nBEGIN BULK\n" + bulk("GRID,%d,,%s,%s,%s") + "ENDDATA\n",
                       "open fixed", [rb"^(CEND\nBEGIN BULK)\n", rb"GRID,(\d)"],
                       rb"GRID,\d,,", b","),
    "post.csv": Sample(POST + rows(", ", values=True) + "\n[Faces]\n0, 1, 2\n",
                       "open named", [
                           rb"\[Name\]\n(.*)\n", rb"Fields\]\n(.*)\n",
                           rb"\[( m \])", rb"(X) \[", rb"(\[)Spatial",
                           rb"\[(Faces\]\n.*)\n"], between=b", "),
    "petrel.txt": Sample("# Petrel Points with attributes\nVERSION 1\nBEGIN HEADER\n"
                         "X\nY\nZ\nFLOAT,T\nEND HEADER\n" + rows(values=True),
                         "open named", [rb"^#((?s:.*)1)\nBEGIN", rb"\n(X)\n",
                                        rb"(FLOAT),"]),
    "well.las": Sample(WELL + "".join("%6.1f %g %g %g %g\n" % (i + 1, *p, v)
                                      for i, (p, v) in enumerate(zip(P, V))),
                       "open named", [
                           rb"~[VWCA](.*)\n", rb"#(.*)\n", rb"VERS\.( .*)\n",
                           rb"WRAP\.( ) {17}N((?s:.*?) )NULL", rb"NULL\.( ) +(-.*)\n",
                           rb" (?:INDEX|X|Y|TVD|GR)\.(.*)\n"], rb" *\d\.0 "),
    "cast.cnv": Sample(CNV + "".join("%11g%11g%11g%11g%11g\n" % (*p, v, 0)
                                     for p, v in zip(P, V)), "named", [
                                         rb"Sea-Bird(.*\n.*)\n", rb"# name \d( )",
                                         rb"name .*:(.*)\n", rb"bad_flag = -(.*)\n"],
                       rb" *", b" +", rb"nvalues = (5)"),
    "bottle.csv": Sample(BOTTLE + rows(",", "99XX1,", values=True) + "END_DATA\n",
                         "ended named", [rb"^BOTTLE,(.*)\n", rb"\n#(.*)\n",
                                         rb",,,(DBAR),(ITS-90)"], rb"99XX1,", b","),
    "odv.txt": Sample("// by hand\nCruise\tStation\tType\tLongitude [degrees_east]\t"
                      "Latitude [degrees_north]\tDepth [m]\tT\n" +
                      rows("\t", "A\ts\tB\t", values=True), "open named", [
                          rb"^/(/.*)\n", rb"\t(Station)\t(Type)\t",
                          rb"A\t(s)\t(B)\t"], rb"A\ts\tB\t", b"\t"),
    "atoms.pqr": Sample("REMARK by hand\n" + "".join(
        "ATOM  %5d  C   LYS  %4d    %8.3f%8.3f%8.3f %7.4f %6.4f\n" % (
            i + 1, i + 1, *p, v / 10, 1.5) for i, (p, v) in enumerate(zip(P, V))),
        "open named fixed", [rb"REMARK(.*)\n", rb"ATOM(.{8})", rb"ATOM.{10}(.{18})"],
        rb"ATOM .{25} *", b" +"),
    "lines.txt": Sample("# by hand\n" + rows(values=True), "open", [rb"#(.*)\n"]),
    "names.csv": Sample("x,y,z,T\n" + rows(",", values=True), "open named",
                        between=b","),
    "counted.txt": Sample("5\n" + rows(), count=rb"^(5)"),
    "atoms.xyz": Sample("5\na comment\n" + rows(first="C "), "named",
                        [rb"\n(a comment)\n"], rb"C ", count=rb"^(5)"),
    "more.xyz": Sample('5\nLattice="9 0 0 0 9 0 0 0 9" Properties=species:S:1:pos:R:3'
                       ':u:R:1 pbc="T F T" time=7\n' + rows(first="C ", values=True),
                       "box", [rb"(time=7)"], rb"C "),
    "node.node": Sample("5 3 1 0\n" + "".join(
        "%d %s\n" % line for line in enumerate(NUMBERED)), before=rb"\d ",
        count=rb"^(5)"),
    "mesh.off": Sample("OFF\n5 2 0\n" + rows() + "3 0 1 2\n3 0 1 4\n", "",
                       [rb"\n3( .*)", rb"5 2 (0)\n"], count=rb"\n(5) "),
    "mesh.ply": Sample(PLY % "ascii" + rows(values=True) + "3 0 1 2\n", "named", [
        rb"comment (.*)\n", rb"\n3( .*)\n$", rb"int (vertex_index)",
        rb"property list (uchar int) "], count=rb"vertex (5)"),
    "packed.ply": Sample((PLY % "binary_little_endian").encode() + packed("<4d") +
                         struct.pack("<B3i", 3, 0, 1, 2), "packed named", [
                             rb"comment (.*)\n", rb"int (vertex_index)",
                             rb"property list (uchar int) ", rb"element face (1)",
                             range(-13, 0)], count=rb"vertex (5)"),
    "mesh.obj": Sample("# by hand\no thing\n" + rows(first="v ") + "vn 0 0 1\n"
                       "f 1 2 3\n", "open", [rb"#(.*)\n", rb"\no( .*)\n",
                                             rb"vn( .*)\n", rb"\nf( .*)\n"], rb"v "),
    "mesh.stl": Sample(stl(), "", [rb"solid( .*)\n", rb"normal( .*)\n"],
                       rb" *vertex "),
    "packed.stl": Sample(b"by hand".ljust(80) + struct.pack("<I", 2) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *(x for p in CORNERS[k:k + 3] for x in p), 0)
        for k in (0, 3)), "packed", [range(0, 80), range(84, 96), range(132, 146),
                                     range(182, 184)]),
    "array.npy": Sample(npy(), "packed", count=rb"\((5),"),
    "atoms.pdb": Sample("HEADER    BY HAND\n" + atoms() + "END\n", "open named fixed", [
        rb"HEADER(.*)\n", rb"ATOM  (.{24})", rb"ATOM.{50}(  1.00)"], rb"ATOM .{25} *",
        b" +"),
    "cloud.pcd": Sample(PCD % "ascii" + rows(values=True), "named", VIEWPOINT,
                        count=rb"POINTS (5)"),
    "packed.pcd": Sample((PCD % "binary").encode() + packed("<4d"), "packed named",
                         VIEWPOINT, count=rb"POINTS (5)"),
    "dump.lammpstrj": Sample(
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\nITEM: BOX BOUNDS pp pp pp\n0 4\n"
        "0 4\n-3 4\nITEM: ATOMS id x y z\n" + "".join(
            "%d %s\n" % (i + 1, line) for i, line in enumerate(rows().splitlines())),
        "box", [rb"TIMESTEP\n(.*)\n"], rb"\d ", count=rb"ATOMS\n(5)"),
    "survey.las": Sample(las(), "packed", [
        range(4, 24), range(26, 96), range(100, 104), range(111, 131),
        range(179, 227)] + [range(227 + 20 * k + 14, 247 + 20 * k) for k in range(5)]),
}
SAMPLES = {name: f.content for name, f in FORMATS.items()}


def of_kind(kind):
    return {name for name, f in FORMATS.items() if kind in f.kinds}


def row_matches(name, content):
    """of each row, with its coordinates as groups"""
    f = FORMATS[name]
    form = b"%.3f" if "fixed" in f.kinds else b"%g"
    at = 0
    for p in CORNERS if name == "mesh.stl" else P:
        m = re.compile(
            b"(?m)^" + f.before + f.between.join(
                b"(%s)" % re.escape(form % x) for x in p)).search(content, at)
        at = m.end()
        yield m
