"""test_readers.py - what files mean to build/tess, and which it refuses.

Each file holds the same five points, and what tess writes of them is compared
with what is written here.  Of each format what it allows, and damages, come from
test_properties.py; what is said of files, word for word, is in messages.txt.
"""
import math
import re
import struct

import pytest

from samples import P

# ---- the points, and how cases are written ----

COLUMNS = {"x": [p[0] for p in P], "y": [p[1] for p in P],
           "z": [p[2] for p in P], "T": [0, 10, 20, 30, 40],
           "u": [0.5, 1.5, 2.5, 3.5, 4.5], "n": [1, 2, 3, 4, 5], "7": [7] * 5}


def table(columns, between=" ", head=""):
    """rows of these columns: one of COLUMNS, or a word that is in all rows"""
    return head + "".join(between.join(
        "%g" % COLUMNS[c][k] if c in COLUMNS else c for c in columns) + "\n"
        for k in range(5))


def node(values, marks=False, first=0):
    """as tess writes them in a .node file"""
    return "5 3 %d %d\n" % (len(values), marks) + "".join(
        "%d %s\n" % (k + first, line + " %d" % (k % 2) * marks)
        for k, line in enumerate(table("xyz" + values).splitlines()))


NONE, ONE, TWO, NUMBERED = map(node, ("", "T", "Tu", "nT"))
MARKED = node("Tu", True)
CORNERS = "6 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1.5 0\n3 0 0 0\n4 0 0 -2\n" \
    "5 0.134 0.25 -0.5\n"


def reads(points, name, text, words="", options=""):
    """tess reads the points of the text, in a file of this name (from standard
    input if it is -), and says words, or nothing.  In words ... is anything; behind
    = they are all that is said."""
    return points, name, text, words, options


def refuses(name, text, words, options=""):
    """tess ends with status 2, writes nothing, and says words"""
    return None, name, text, words, options


def shows(shown, name, text, words="", options=""):
    """this is what tess prints, and writes of the points' cells"""
    return (shown,), name, text, words, options


def says(words, text):
    return re.search("(?s)" + ".*".join(map(re.escape, words.split("..."))), text)


def comma(text):
    return text.replace(".", ",")


def each_line(text, first="", last=""):
    return "".join(first + line + last + "\n" for line in text.splitlines())


def without(text, *lines):
    """without these lines, from 1 on"""
    return "".join(line for k, line in enumerate(text.splitlines(True), 1)
                   if k not in lines)


def with_line(text, number, line):
    lines = text.splitlines(True)
    lines[number - 1] = line + "\n"
    return "".join(lines)


# ---- lines ----

PLAIN = """# a comment
0 0 0

 1 0 0 # another
0\t1.5\t0
! Fortran's
0 0 -2
% Matlab's
  // C++'s
0.134 .25 -.5 ! behind a number
"""
LINES = [
    reads(NONE, "plain.txt", PLAIN),
    reads(NONE, "-", PLAIN),
    reads(NONE, "fortran.dat", " 0.D0 0.D+00 0.0D0\n 0.1D+01 0.00d0 0.\n"
          " 0.0E+00 0.15D+1 0.0E0\n 0. 0. -.2D1\n 1.34D-01 2.5d-01 -5.0D-1\n"),
    # an exponent of three digits leaves no room for its letter
    reads("4 3 0 0\n0 0 0 0\n1 1.5e+100 0 0\n2 0 1 0\n3 0 0 1.25e-101\n",
          "narrow.dat", "0 0 0\n1.5+100 0 0\n0 1 0\n0 0 1.25-101\n",
          ":2: x is 1.5e+100, far from all others"),
]

# ---- CSV, and other tables ----

CSV = "0,0,0,0\n1,0,0,10\n0,1.5,0,20,\n0,0,-2,30\n0.134,0.25,-0.5,40\n"
HEADER = table("xyzTu", ",", 'x,y,z,T (%),"wind, m/s"\n')
UNITS = """survey of the dam
station;east;north;height
;m;m;m
A1;0;0;0
A2;1;0;0
A3;0;1.5;0
A4;0;0;-2
A5;0.134;0.25;-0.5
"""
TABLES = [
    reads(ONE, "plain.csv", CSV),
    reads(TWO, "header.csv", HEADER),
    reads(TWO, "quoted.csv", re.sub(r"(?m)([\d.]+)$", r'"\1"', HEADER)),
    reads(TWO, "semicolon.csv", HEADER.replace(",", ";")),
    reads(TWO, "tabs.tsv", HEADER.replace(", m", " m").replace('"', "").replace(
        ",", "\t")),
    reads(TWO, "pandas.csv", table("Tyuxz", ",", ",Y [m],T,x,Z (m)\n"),
          "columns 4, 2, 5"),
    reads(ONE, "paraview.csv", table(
        "Txyz", ",", '"T","Points:0","Points:1","Points:2"\n')),
    reads(NONE, "units.csv", UNITS, "x, y, z are the columns 2, 3, 4"),
    reads(NONE, "times.csv", table(["2024-01-31 10:30", *"xyz"], ","),
          "column 1 (2024-01-31 10:30) is not a number"),
    refuses("here.csv", "x,y,z\n1,here,3\n4,5,6\n",
            ':2: column 2, y: "here": not a number'),
]

# ---- a decimal comma is no separator: the cell is named ----

COMMA = " (a decimal comma?  -decimal , reads it)"
THIRTEEN = ': column 1: "0,13": not a number' + COMMA
DECIMAL = [
    refuses("semicolons.csv", "0,13;0,84;0,5\n", ":1" + THIRTEEN),
    refuses("later.csv", "x;y;z\n1;2;3\n0;0,84;0,5\n",
            ':3: column 2, y: "0,84": not a number' + COMMA),
    refuses("blanks.txt", "0,13 0,84 0,5\n", ":1" + THIRTEEN),
    refuses("tabs.txt", "0,13\t0,84\t0,5\n", ":1" + THIRTEEN),
    refuses("quotes.csv", '"0,13","0,84","0,5"\n', ":1" + THIRTEEN),
    refuses("points.txt", "1.234,5 2.345,6 3.456,7\n",
            ':1: column 1: "1.234,5": not a number (points between th'),
    refuses("asked.csv", "1,2,3,12.5 m\n", 'column 4: "12.5 m": not a number',
            "-cols 1,2,3,4"),
]

# -decimal ,: it is read, with something else between columns
PARTLY = comma(re.sub(r"-?\d*\.\d+", r'"\g<0>"', "0.0" + CSV[1:]))
GERMAN = comma(HEADER.replace(",", ";"))
DECIMAL += [
    reads(points, name, text, words, "-decimal ,") for points, name, text, words in (
        (ONE, "both.txt", re.sub(r"(\d)\.(\d)", r"\1,\2", CSV.replace(",", ", ")),
         ""),
        (ONE, "quotes.csv", comma(re.sub(r"[^,\n]+", r'"\g<0>"', CSV.replace(
            ",\n", "\n"))), ""),
        # in quotes where there is one, else whole numbers
        (ONE, "partly.csv", PARTLY, ""),
        ("6 3 1 0\n0 7 7 7 7\n" + re.sub(r"(?m)^\d", lambda m: "%d" % (
            int(m[0]) + 1), ONE[8:]), "whole.csv", "7,7,7,7\n" + PARTLY, ""),
        (TWO, "german.csv", GERMAN, ""),
        (TWO, "dates.csv", each_line(GERMAN, "31.12.2024;").replace(
            "31.12.2024", "date", 1), "column 1, date (31.12.2024) is not a "
            "number: skipped"),
        (ONE, "exponents.csv", "0;0;0;0\n10e-1;0;0;1E1\n0;1,5D0;0;20\n"
         "0;0;-,2e1;30\n,134;0,25;-,5;40\n", ""))]
POINTS = "not a number (with -decimal , numbers have no points)"
ALONE = "0,13,0,84,0,5\n1,13,0,84,0,5\n"
DECIMAL += [
    refuses("point.csv", "1;2;3\n1,5;2.5;3\n", ':2: column 2: "2.5": ' + POINTS,
            "-decimal ,"),
    refuses("grouped.csv", "1.234,5;2;3\n", ':1: column 1: "1.234,5": ' + POINTS,
            "-decimal ,"),
    refuses("alone.txt", ALONE, "column 1: ...commas between digits are decimal",
            "-decimal ,"),
    reads(ONE, "point2.csv", CSV, "", "-decimal ."),
]

# ---- x, y, z elsewhere: -cols; a first column that numbers ----

NUMBERS = table("nxyzT")
OCEAN = "time,Lat,lon,depth (m),temp,note\n" + "".join(
    "%s,%s\n" % line for line in zip(table("nyxzT", ",").splitlines(), "abcde"))
NAMELESS = "a,b,c,value\n" + CSV
REMARKS = table("zxyT", " ", "#east north height t\n")
COLS = [
    reads(ONE, "numbers.txt", NUMBERS, "column 1 (1, 2, 3, ...) numbers the rows"),
    reads(NUMBERED, "chosen.txt", NUMBERS, "", "-cols 2,3,4"),
    reads(NUMBERED, "columns.csv", OCEAN, "", "-cols 3,2,4"),
    reads(NUMBERED, "names.csv", OCEAN, "", "-cols lon,lat,depth"),
    reads(ONE, "values.csv", OCEAN, "", "-cols lon,lat,depth,temp"),
    reads(ONE, "both.csv", OCEAN, "", "-cols 3,lat,4,5"),
    refuses("unnamed.csv", NAMELESS, ": -cols says so, as -cols 1,2,3\n"),
    reads(ONE, "asked.csv", NAMELESS, "", "-cols 1,2,3"),
    # also where some have another name
    reads(NONE, "named.csv", table("xyz", ",", "x,y,v\n"), "columns 1, 2, 3 (x, y, "
          "v); -cols chooses others; if they are in a plane: -plane\n"),
    reads(NONE, "named.csv", table("xyz", ",", "x,q,z\n"),
          "columns 1, 2, 3 (x, q, z); -cols chooses others\n"),
    reads(NONE, "named.csv", table("xyz", ",", "q,y,z\n"),
          "columns 1, 2, 3 (q, y, z); -cols chooses others\n"),
    reads(ONE, "named.csv", table("xyzT", ",", "x,y,level,T\n"),
          "columns 1, 2, 3 (x, y, level); -cols chooses others\n"),
    # names that are not the columns'
    reads(NONE, "fewer.csv", table("xyz", ",", "x,y,level,T,u\n"),
          ":1: its names that do not match the columns in number are"),
    # 1, 2, 3 that x is by name, or that has no values beside it, is none
    reads("4 3 1 0\n0 1 0 0 1\n1 2 3 0 1\n2 3 0 1 1\n3 4 4 4 1\n", "x.csv",
          "x,y,z,T\n1,0,0,1\n2,3,0,1\n3,0,1,1\n4,4,4,1\n"),
    refuses("high.csv", OCEAN, ':2: -cols: no column "height" among 6, which '
            "line 1 names: ",
            "-cols lon,lat,height"),
    refuses("seventh.csv", OCEAN, 'no column "7" among 6', "-cols 2,3,7"),
    refuses("many.csv", ",".join("c%d" % k for k in range(60)) + "\n" + ",".join(
        60 * ["1"]) + "\n", ':2: -cols: no column "q" among 60, which line 1 names: '
            "c0, c1, ...c39, and 20 more\n", "-cols q,c1,c2"),
    refuses("twice.csv", OCEAN, "column lat twice", "-cols 2,3,lat"),
    refuses("two.csv", OCEAN, "-cols: points in a plane have no tetrahedra",
            "-cols 2,3"),
    reads(NONE, "cols.node", NONE, "", "-cols 2,3,4"),
    # names in any format
    reads(node("").replace("1 1 0 0", "1 0 0 1").replace("3 0 0 -2", "3 -2 0 0")
          .replace("0.134 0.25 -0.5", "-0.5 0.25 0.134"), "cols.node", NONE, "",
          "-cols z,y,x"),
    # names in a comment, where -cols asks for them, in any order, all or some
    reads(ONE, "comment.txt", REMARKS, ":1: names of columns, from a comment",
          "-cols north,height,east,t"),
    reads(ONE, "comment.txt", REMARKS, ":1: names of columns, from a comment",
          "-cols north,height,east"),
    refuses("comment.txt", REMARKS, 'no column "depth" among 4',
            "-cols north,height,depth"),
]

# names before places: heads parted otherwise, one name less
QUOTED = "".join('"%d" %s\n' % (9 - k, line) for k, line in enumerate(
    table("Txyz").splitlines()))
SWAPPED = table("Txyz")
COLS += [
    reads(ONE, "written.txt", '"T" "x" "y" "z"\n' + QUOTED,
          ":1: one name less than columns"),
    reads(ONE, "labels.csv", "T,x,y,z\n" + each_line(QUOTED.replace(
        '"', "").replace(" ", ","), "h"), ":1: one name less than columns"),
    reads(ONE, "savetxt.txt", "# T, X, Y, Z\n" + SWAPPED,
          ":1: names of columns, from a comment"),
    reads(ONE, "savetxt.txt", "% T       X       Y (m)     Z\n" + SWAPPED,
          ":1: names of columns, from a comment"),
    reads(ONE, "savetxt.txt", "T, X, Y, Z\n" + SWAPPED),
    reads(ONE, "savetxt.txt", "T;X;Y;Z\n" + SWAPPED),
    reads(ONE, "gsplus.dat", "sample, m east, m north, depth\n" + SWAPPED,
          "columns 2, 3, 4 (m east, m north, depth)"),
    reads(ONE, "holes.csv", table("Txyz", ",", "T,EAST,NORTH,RL\n"),
          "columns 2, 3, 4 (EAST, NORTH, RL)"),
    refuses("from.csv", table("Txyz", ",", "T,EAST,NORTH,FROM\n"),
            "which columns are x, y, z?  Its names do not say so"),
    # one name less: the rows' names must be there, or else it is asked, and nothing
    # is said of commas then
    refuses("less.txt", '"ab" "bc" "cd"\n1 2 3 4\n1 3 4 5\n1 9 3 7\n',
            "Its names and its columns differ in number"),
    reads("3 3 2 0\n0 0 13 0 84 5\n1 1 13 7 84 9\n2 1 11 7 8 9\n", "less.csv",
          "x,y,z,T,u\n1,0,13,0,84,5\n3,1,13,7,84,9\n2,1,11,7,8,9\n",
          "=tess: F:1: one name less than columns: the first column is the rows' names, "
          "as R writes them\n"),
    reads(ONE, "units2.csv", table("Txyz", ",", "T,X,Y,Z\nK,m,m,m\n")),
]

# ---- numbers that are missing: -skip, -nodata ----

GAPS = """x,y,z,T (%),"wind, m/s"
,9,9,9,9
0,0,0,0,0.5
9,9,9,,9
1,0,0,10,1.5
9,NA,9,9,9
9,9,nan,9,9
0,1.5,0,20,2.5
9,9,9,-,9
0,0,-2,30,3.5
9,9,9,"",9
0.134,0.25,-0.5,40,4.5
9,9,9,9,
9,9,9,9,N/A
"""
BLANKS = without(GAPS, 1)
for old, new in ((r"(?m),$", ",NA"), (r"(?m)^,", "NA,"), (",,", ",NA,"),
                 ('""', "-"), (",", " ")):
    BLANKS = re.sub(old, new, BLANKS)
# a column without a number that is not asked for
HOLLOW = re.sub(r"(?m)$(?<!\A)(?=\n)", ",", re.sub(r"(?m)^[9,].*\n", "", GAPS))
HOLLOW = HOLLOW.replace(",\n", ",note\n", 1)
MISSING = [
    refuses("gaps1.csv", GAPS, ":2: column 1...: empty (-skip"),
    refuses("gaps4.csv", without(GAPS, 2),
            ":3: column 4...: empty; so is 1 more, to line 10 (-skip"),
    refuses("gaps5.csv", without(GAPS, 2).replace("9,9,9,,9", "9,9,9,NA,9"),
            ":3: ...-skip drops such lines"),
    reads(TWO, "gaps2.csv", GAPS, "8 rows dropped ... the first in line 2", "-skip"),
    reads(TWO, "gaps.txt", GAPS.replace(",", ";"), "8 rows dropped", "-skip"),
    reads(TWO, "gaps.tsv", GAPS.replace('"wind, m/s"', "u").replace(",", "\t"),
          "8 rows", "-skip"),
    reads(TWO, "bare.csv", without(GAPS, 1), "8 rows dropped ... line 1", "-skip"),
    reads(TWO, "blanks.txt", BLANKS, "8 rows dropped", "-skip"),
    reads(TWO, "header.csv", HEADER, "", "-skip"),
    reads(TWO, "counted.csv", "13\n" + without(GAPS, 1), "8 rows", "-skip"),
    reads(NONE, "gaps.xyz", "6\na comment\nC 0 0 0\nH 1 0 0\nH 0 - 0\nH 0 1.5 0\n"
          "O 0 0 -2\nFe 0.134 0.25 -0.5\n",
          "1 row dropped ... the first in line 5", "-skip"),
    reads(TWO, "hollow1.csv", HOLLOW, "column 6, note (empty) is not a number: skip",
          "-skip"),
    reads(ONE, "hollow2.csv", HOLLOW, "", "-skip -cols 1,2,3,4"),
]

VOIDS = """x,y,z,T,u
0,0,0,0,0.5
9,9,9,-9999,1
1,0,0,10,1.5
9,9,9,7,-9999.00
0,1.5,0,20,2.5
9,9,9,-9.999E3,-9999
0,0,-2,30,3.5
0.134,0.25,-0.5,40,4.5
"""
VOIDS_NODE = "7 3 2 1\n" + "".join("%d %s\n" % (k, row[2:]) for k, row in enumerate(
    MARKED.splitlines()[1:3] + ["- 9 9 9 0 -9999 1"] + MARKED.splitlines()[3:] +
    ["- 9 9 9 -9999 0 1"]))
MISSING += [
    reads(TWO, "voids1.csv", VOIDS, "3 rows dropped ... the first in line 3; fewer if "
          "-cols X,Y,Z,VALUE asks for one", "-nodata -9999"),
    reads(TWO, "voids.txt", without(VOIDS, 1), "3 rows dropped ... line 2",
          "-nodata -9999"),
    reads(ONE, "voids2.csv", without(VOIDS, 5),
          "2 rows dropped ... the first in line 3\n",
          "-nodata -9999 -cols x,y,z,T"),
    reads(TWO, "voids3.csv", re.sub("(?m)^9.*-9999$", "9,9,9,7,5", re.sub(
        "(?m)^9.*1$", "9,9,9,-1,3", VOIDS)), "3 rows dropped",
        "-nodata -1,7,99,-9999"),
    reads(TWO, "voids4.csv", comma(VOIDS.replace(",", ";")), "3 rows dropped",
          "-nodata -9999 -decimal ,"),
    reads(ONE, "never.csv", CSV, "nothing is such a number", "-nodata -9999"),
    reads(ONE, "moved.csv", CSV.replace("1,0", "-9999,0", 1).replace(
        "0,1.5", "1,0,0,10\n0,1.5"),
        "1 row dropped ...1 by -nodata), the first in line 2", "-nodata -9999"),
    refuses("all.csv", CSV, "no points: -nodata drops all 5 rows",
            "-nodata 0,10,20,30,40"),
    reads(MARKED, "voids.node", VOIDS_NODE, "2 rows dropped ... the first in line 4; ",
          "-nodata -9999"),
]

# limits: -below
BELOW = "x,y,z,T\n0,0,0,0\n1,0,0,<20\n0,1.5,0,< 40\n0,0,-2,>30\n" \
    "0.134,0.25,-0.5,40\n"
MISSING += [
    refuses("limits.csv", BELOW,
            ':3: column 4, T: "<20": ...to line 5 (a limit; -below 0.5'),
    reads(ONE, "limits.csv", BELOW,
          "2 values below a limit are read as 0.5 times the limit\n", "-below 0.5"),
    refuses("limit.csv", BELOW.replace("1,0", "<1,0", 1),
            ':3: column 1, x: "<1": not a num', "-below 0.5"),
]

# ---- .xyz, counts, Qhull ----

ATOMS = "5\na comment, 1,5 Angstrom\nC 0 0 0\nH 1 0 0\nH 0 1.5 0\nO 0 0 -2\n" \
    "Fe 0.134 0.25 -0.5\n"
BARE = "5\n9 9 9\n" + table("xyz")
MORE = '5\nProperties=T:R:1:species:S:1:pos:R:3:u:R:1 Lattice="9 0 0 0 9 0 0 0 9' \
    '"\n 0 C 0 0 0 0.5\n10 H 1 0 0 1.5\n20 H 0 1.5 0 2.5\n30 O 0 0 -2 3.5\n' \
    "40 Fe 0.134 0.25 -0.5 4.5\n"
C = "column 1 (C) is not a number"
STEP = ":2: is a comment, as the name"
XYZ = [
    reads(NONE, "atoms.xyz", ATOMS, C),
    reads(NONE, "blank.xyz", with_line(ATOMS, 2, ""), C),
    reads(NONE, "seven.xyz", with_line(ATOMS, 2, "7"), C),
    reads(NONE, "step.xyz", with_line(ATOMS, 2, "step 1 2 3"), STEP),
    reads(NONE, "row.xyz", with_line(ATOMS, 2, "X 1 2 3"), STEP),
    reads(NONE, "frames.xyz", 2 * ATOMS,
          ":8: its further frames are left out: 7 lines"),
    # no element, and a comment that looks like a point, or is one
    reads(NONE, "bare.xyz", BARE, ":2: is a comment, as the name's .xyz says"),
    reads(NONE, "frames2.xyz", 2 * BARE, "further frames"),
    # (by any other name a count is one of all the lines)
    refuses("bare.txt", BARE, ":7: one more line of numbers than the 5 points"),
    reads(NONE, "count.txt", without(BARE, 2)),
    reads(NONE, "points.txt", "5 points\n\n" + table("xyz")),
    reads(NONE, "qhull.txt", "3 rbox 5 D3 s\n5\n" + table("xyz")),
    reads(NONE, "reversed.txt", "5\n3\n" + table("xyz")),
    reads(NONE, "oneline.txt", "3 5\n" + table("xyz")),
    # an .xyz file of 3 atoms is none of Qhull's
    reads("3 3 0 0\n0 0 0 0\n1 0 0 1\n2 1 0 0\n", "three.xyz",
          "3\n1\nH 0 0 0\nH 0 0 1\nO 1 0 0\n", "column 1 (H)"),
    # extended: which columns, and a box
    reads(TWO, "more.xyz", MORE, "column 2, species (C) is not a number"),
    reads(NONE, "lattice.xyz", '5\ntime=1 Lattice="9 0 0 0 9 0 0 0 9"\n' +
          without(ATOMS, 1, 2), C),
]

# ---- OFF, PLY, OBJ, STL, PDB, .node ----

OFF = "OFF\n5 2 0\n" + table("xyz") + "3 0 1 2\n3 0 1 4\n"
PLY = """ply
format ascii 1.0
comment made by hand
element vertex 5
property float T
property float x
property float y
property float z
property uchar red
element face 1
property list uchar int vertex_index
end_header
""" + table("Txyzu") + "3 0 1 2\n"
OBJ = "# a surface\nmtllib none\no thing\n" + table(["v", *"xyz"]).replace(
    "v 0 0 -2", "vn 1 1 1\nv 0 0 -2") + "f 1 2 3\n"
BARE_OBJ = "".join(line + "\n" for line in OBJ.splitlines()
                   if line[0] not in "fmo" and line[:2] != "vn")
PDB = """HEADER    A MOLECULE
REMARK   2 RESOLUTION.    1.90 ANGSTROMS.
MODEL        1
ATOM      1  N   LYS A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  LYS A   1       1.000   0.000   0.000  1.00 10.00           C
ANISOU    2  CA  LYS A   1     1111   2222   3333      0      0      0       C
ATOM      3  C   LYS A   1       0.000   1.500   0.000  1.00 20.00           C
TER
HETATM    4 FE   HEM A 200       0.000   0.000  -2.000  1.00 30.00          FE
HETATM    5  O   HOH A 201       0.134   0.250  -0.500  0.50 40.00           O
ENDMDL
MODEL        2
ATOM      1  N   LYS A   1       9.000   0.000   0.000  1.00  0.00           N
ENDMDL
"""
STL = """solid made by hand
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1 0 0
   vertex 0 1.5 0
  endloop
 endfacet
 facet normal 1 0 0
  outer loop
   vertex 0.0E+00 0 0
   vertex 0 0 -2
   vertex 0.134 0.25 -0.5
  endloop
 endfacet
endsolid
"""
# coordinates that touch, behind a chain and a number that do
TOUCHING = [(-100.125, -200.5, -300.134), (-199.5, -100.25, -150.75),
            (-150.125, -120.5, -999.875), (-120.134, -101.25, -101.5)]


def touching(behind):
    return "".join("ATOM  %5d  C   LYS A1%03d    %8.3f%8.3f%8.3f%s\n" % (
        k, k, *p, behind) for k, p in enumerate(TOUCHING))


def touched(values):
    return "4 3 %d 0\n" % len(values.split()) + "".join("%d %g %g %g %s\n" % (
        k, *p, values) for k, p in enumerate(TOUCHING))


FACES = "its faces are left out"
MESHES = [
    reads(touched("5"), "touch.pdb", touching("  1.00  5.00")),
    reads(touched("0.25 1.5"), "touch.pqr", touching("  0.2500 1.5000")),
    # words of PDB in a column are no PDB
    *(reads(NONE, "names.csv", "HEADER%sx%sy%sz\n" % (3 * (mark,)) + table(
        ["REMARK", *"xyz"], mark), "column 1, HEADER (REMARK) is not a number")
      for mark in ",;\t"),
    reads(NONE, "mesh.off", OFF, FACES),
    reads(NONE, "-", "OFF " + OFF[4:], FACES),
    reads(NONE, "bare.off", "OFF\n5 0 0\n" + table("xyz")),
    reads(TWO, "mesh.ply", PLY, FACES),
    reads(NONE, "mesh.obj", OBJ, FACES),
    reads(NONE, "bare.obj", BARE_OBJ),
    reads(NONE, "-", without(OBJ, 2, 3), FACES),
    reads(ONE, "1abc.pdb", PDB, "other models are left out: 2 lines"),
    reads(ONE, "1abc.ent", PDB, "other models"),
    reads(ONE, "2abc.pdb", with_line(PDB, 5, PDB.splitlines()[4] + "\n" +
                                     PDB.splitlines()[4].replace(" 0.000", " 9.000", 1)
                                     .replace("10.00", "99.99")),
          "1 row dropped ... the first in line 6", "-nodata 99.99"),
    reads(CORNERS, "mesh.stl", STL, FACES),
    reads(NONE, "none.node", NONE),
    reads(ONE, "one.node", ONE),
    reads(TWO, "two.node", TWO),
    reads(MARKED, "marked.node", MARKED),
    reads(node("Tu", True, 1), "from1.node", node("Tu", True, 1)),
    refuses("other.off", with_line(OFF, 1, "OFF binary"),
            "OFF binary: not an OFF file of points in space"),
    refuses("other.off", with_line(OFF, 1, "OFF BINARY"), "not an OFF file"),
    refuses("list.ply", PLY.replace("float x", "list int int x"),
            ":6: a list is not a property that points may have"),
    # an exponent without its letter
    reads(NONE, "exponent.bdf", "GRID,1,,0.,0.,0.\nGRID,2,,10.-1,0.,0.\n"
          "GRID,3,,0.,.15+1,0.\nGRID,4,,0.,0.,-20.-1\nGRID,5,,.134,2.5-1,-5.-1\n"),
] + [
    # a column may have the name that such a file begins with
    reads(node("7"), name, table("7xyz", mark, mark.join([word, *"xyz"]) + "\n"))
    for word in ("v", "o", "ply", "solid", "OFF", "CUTOFF", "HEADER", "MODEL ",
                 "data_a", '"v"', '"ply"')
    for mark in ",;\t " for name in ("named.csv", "-")
    # (in a PDB file blanks follow)
    if (word, mark) not in (("HEADER", " "), ("MODEL ", " "))]

# ---- PCD, LAMMPS dumps, LAS ----

PCD = """# .PCD v0.7 - Point Cloud Data file format
VERSION 0.7
FIELDS T x y z _ u
SIZE 4 4 4 4 1 8
TYPE F F F F U F
COUNT 1 1 1 1 2 1
WIDTH 5
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 5
DATA ascii
""" + table([*"Txyz", "9", "9", "u"])
DUMP = """ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
5
ITEM: BOX BOUNDS xy xz yz pp pp ff
-1 6 1
-2 4 0.5
-3 5 -0.25
ITEM: ATOMS T xs ys zs u
"""


def scaled():
    """in a tilted box: by the vectors (5.5 1 0.5; -0.25 ...), as LAMMPS says"""
    for (x, y, z), T, u in zip(P, COLUMNS["T"], COLUMNS["u"]):
        zs = (z + 3) / 8
        ys = (y + 1.75 + .25 * zs) / 5.75
        yield "%g %.17g %.17g %.17g %g\n" % (
            T, (x + 1 - ys - .5 * zs) / 5.5, ys, zs, u)


SCALED = DUMP + "".join(scaled())
CLOUDS = [
    reads(TWO, "cloud.pcd", PCD),
    refuses("packed.pcd", PCD.replace("ascii", "binary_compressed"),
            "pcl_convert_pcd_ascii_binary F G 0"),
    refuses("boxless.dump", without(SCALED, 5, 6, 7, 8),
            ":5: no BOX BOUNDS before"),
    reads(TWO, "frames.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\n"
          "ITEM: ATOMS x z y T u\n" + table("xzyTu") + SCALED,
          "its further frames are left out"),
]
for key in "FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT", "POINTS", "DATA":
    line = re.search("(?m)^%s.*\n" % key, PCD)[0]
    CLOUDS += [refuses("keyless.pcd", PCD.replace(line, ""),
                       "where PCD has " + key),
               refuses("wordless.pcd", PCD.replace(line, key + "\n"), key + (
                   " needs one word" if key in ("WIDTH", "HEIGHT", "POINTS", "DATA")
                   else " has no words"))]
for key in "SIZE", "COUNT", "WIDTH", "HEIGHT", "POINTS":
    CLOUDS.append(refuses("number.pcd", re.sub(r"(?m)^(%s) \d+" % key, r"\1 1e1", PCD),
                          key + ': "1e1": not a number'))

# ---- known, but not read: by name, with what to do ----

KNOWN = [refuses("known", text, "is %s" % says_so) for text, says_so in (
    ("BZh91AY&SY", "compressed by bzip2, which is not read: bunzip2 -c"),
    (b"\3757zXZ\0", "compressed by xz, which is not read: xz -dc"),
    (b"(\265\057\375", "compressed by zstd, which"),
    ("PK\3\4xx", "a zip archive, which is not read: unzip -p"),
    (b"\211HDF\r\n", "HDF5"),
    ("CDF\1", "netCDF"),
    ("II*\0", "TIFF, which is not read: gdal_translate"),
    ("DSAA\n1 2 3\n", "Surfer's grid"),
    ("SQLite format 3\0", "a GeoPackage"),
    ("$MeshFormat\n4.1 0 8\n", "Gmsh's"),
    ("*Heading\n", "Abaqus's"),
    ('<VTKFile type="x">\n', "VTK's"),
    ("version https://git-lfs.github.com/spec/v1\n", "a pointer of Git LFS"),
    ("data_x\n_cell 1\n", "CIF, which is not read: ase convert"),
    ("data_x\n_atom_site.id\n", "mmCIF, which is not read: gemmi convert"),
    ("a title\n1.0\n1 0 0\n0 1 0\n0 0 1\nNa Cl\n1 1\nDirect\n0 0 0\n", "POSCAR"),
    ("a title\n1\n    1WATER  OW1    1   0.126   1.624   1.679\n   1 1 1\n", "GRO"),
    ("LAMMPS\n\n5 atoms\n1 atom types\n", "LAMMPS's data"),
    ("2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n", "PTX"))]

KNOWN += [refuses("known", text.replace("\n", end), words)
          for _, _, text, words, _ in KNOWN if isinstance(text, str) and "\n" in text
          for end in ("\r\n", "\r")]

# ---- what is no file of points ----

SEMICOLONS = table("xyz", ";")
EMPTY = "empty (-skip drops"
NOT = [
    refuses("both.csv", SEMICOLONS + "1;2 3;4\n",
            ':6: column 2: "2 3": ... (two numbers in one cell: one sep'),
    # cells like the bad one are counted to the end, and the last one is said
    *(refuses("likes.csv", "x,y,z\n1,2,3\n1,NA,3\n" + "".join(
        "1,NA,%d\n" % k for k in range(n)) +
        "1,2,3\n1,x,3\nNA,2,3\n1,2,3,4\n", ':3: column 2, y: "NA": not a number' +
        more + " (-skip drops") for n, more in (
            (0, ""), (1, "; so is 1 more, to line 4"),
            (2, "; so are 2 more, to line 5"), (7, "; so are 7 more, to line 10"))),
    # ... but not beyond a count
    refuses("counted.txt", "3\n1 2 NA\n1 2 3\n4 5 6\n7 8 NA\n",
            ':2: column 3: "NA": not a number (-skip'),
    refuses("header.txt", "x,y,z\n", "before the first point"),
    refuses("lone.txt", "1.5\n3.5\n", ":1: fewer than two numbers",
            "-plane -validate"),
    refuses("glued.txt", "1 2 3\n1 2 5#x\n", "(a comment begins behind a blank)"),
    refuses("mixed.csv", "1,2,3,4\n1,5, 2,5\n",
            ':2: "1,5, 2,5": commas with and without a blank...' + COMMA[:-1]),
    refuses("quote.csv", 'x,"y,z\n0,0,0\n1,1,1\n', ":1: column 2: a quote that does"),
    refuses("nameless.txt", NUMBERS, 'no column "lon" ...no line of names',
            "-cols lon,lat,depth"),
    refuses("half.csv", "a,,c,d\n1,2,3,4\n", "a, (no name), c, d\n", "-cols q,c,d"),
    refuses("none.dat", "a lake\n3\nX\nY\nZ\nT\n" + table("xyzT"),
            "no numbers, where line 2 announces 3 names"),
    refuses("short.rst7", "a box\n    5\n" + 2 * (6 * "%12.7f" % (
        0, 0, 0, 1, 0, 0) + "\n"), "has room for"),
    refuses("-", "a box\n    5\n" + 2 * (6 * "%12.7f" % (0, 0, 0, 1, 0, 0) + "\n"),
            "ends after 4 of 5 points"),
    refuses("dates.txt", "2024-11 1 2 3\n2024-12 4 5\n", ":2: 3 columns"),
    refuses("tabbed.csv", "1,2,3\n\t1,2,4,5\n", ":2: 4 columns"),
    # the first row or another one
    *(refuses("empty.csv", text, ":%d: column %d...: %s" % (line, column, EMPTY))
      for line, column, text in (
          (2, 4, "1,2,3,4\n0,1,0,\n"), (1, 4, "0,1,0,\n1,2,3,4\n"),
          (2, 4, "x,y,z,T\n0,1,0,\n1,2,3,4\n"), (2, 4, "1,2,3,4,5\n1,2,3,,5\n"),
          (1, 3, "1,2,,4,5\n1,2,3,4,5\n"), (2, 2, "x,y,z,T\n1,,3,4\n1,2,3,4\n"),
          (1, 2, "1,,3\n1,2,3\n"), (1, 4, '1,2,3,""\n1,2,3,4\n'),
          (2, 2, "1\t2\t3\t4\n1\t\t3\t4\n"))),
    refuses("cols.csv", "x,y,z\n,2,3\n", ":2: column 1...: " + EMPTY,
            "-cols y,x,z"),
    reads("1 3 0 0\n0 0 1 0\n", "hollow4.csv", "x,y,z,T\n0,1,0,\n",
          "column 4, T (empty) is not a number: skip"),
    refuses("few.STL", "few\0", "no binary STL"),
    # ... of a pipe the size is not known, and all of it not at hand
    refuses("-", b"solid".ljust(80) + b"\320\7\0\0" + bytes(99999),
            "ends after 5997 of 6000 points"),
    # words and numbers in one column: either way round
    refuses("asked.csv", "a,1,2,3\n" + 3999 * "7,1,2,3\n",
            ':1: column 1: "a": not a number'),
    refuses("asked.csv", 3999 * "a,1,2,3\n" + "7,1,2,3\n",
            ':4000: column 1: "7": a number among words'),
]

# ---- a word in each row, in any column, with any separator ----

WORDS = [
    reads(ONE, "words.txt", table([*"xyzT"[:k], word, *"xyzT"[k:]], between),
          "column %d (%s) is not a number: skipped" % (k + 1, word))
    for word in ("A-1", "A 1", "2024-01-31T12:00:00Z") for k in range(5)
    for between in " ,;\t" if word + between != "A 1 "]

# ---- boxes, names, labels: what else is read ----


def crystal(*numbers, group="P 1"):
    """a PDB file of the first four atoms with such a cell, the last ones first"""
    atoms = PDB.splitlines(True)
    return "CRYST1%9.3f%9.3f%9.3f%7.2f%7.2f%7.2f %-11s\n" % (*numbers, group) + \
        "".join(atoms[8:10] + atoms[3:5])


def last(*words):
    """the last column of a CSV file"""
    return "...".join("," + w + "\n" for w in words)


def more(*keys):
    return with_line(MORE, 2, " ".join([MORE.splitlines()[1], *keys]))


BOX = "sum to %s; the box's is %s\n"
OUT = "tess: %d points are outside the box: taken where the box's copies bring " \
    "them into it\n"
SKEW = MORE.replace('"9 0', '"9 1')
LEVEL = table("xyzT", ",", "x,y,level,T\n")
FOUR = "0,0,0%s\n1,0,0%s\n0,1,0%s\n0,0,1%s\n"
OTHER = [
    shows("the box's is 729\n", "more.xyz", MORE, "..."),
    shows(BOX % (729, 729) + "..." + last(*"species C H H O Fe".split()), "turned.xyz",
          MORE.replace("9 0 0 0 9", "0 9 0 9 0").replace(
              '0 0 9"', '0 0 -9" Origin="-1 -2 7"'), "", "-periodic"),
    shows("the box's is 729\n", "nested.xyz", re.sub(
        "Lattice=.*", "Lattice=[[9,0,0],[0,9,0],[0,0,9]]", MORE), "..."),
    shows("", "skew.xyz", SKEW, "not a box along x, y, z"),
    shows(BOX % (729, 729), "skew.xyz", SKEW, "=" + OUT % 3, "-periodic"),
    refuses("flat.xyz", MORE.replace("9 0 0 0 9 0", "9 0 0 9 0 0"),
            "vectors are in a plane", "-periodic -volumes CELLS"),
    *(refuses("slab.xyz", more("pbc=" + pbc), "its pbc says",
              "-periodic -box 0,9,0,9,0,9 -volumes CELLS")
      for pbc in ('"T T F"', "[True, False, True]", '"1 0 1"', "F")),
    shows("", "slab.xyz", more('pbc="T T F"'), "..."),
    *(shows(BOX % (729, 729), "bulk.xyz", more("pbc=" + pbc, "foo=0"),
            "=" + OUT % 2, "-periodic")
      for pbc in ('"T T T"', "[True, True, True]", '"1 1 1"', "T")),
    shows(BOX % (336, 336), "cell.pdb", crystal(6, 7, 8, 90, 90, 90), "=" + OUT % 2,
          "-periodic"),
    # (it cuts no cells else)
    shows("the box's is 0.5\n..." + last(*"name FE O N CA".split()), "cell.pdb",
          crystal(6, 7, 8, 90, 90, 90), "..."),
    shows(BOX % (336, 336), "cell.pdb", crystal(6, 7, 8, 90, 90, 90,
                                                group="P 21 21 2"),
          "P 21 21 2", "-periodic"),
    refuses("cell.pdb", crystal(6, 7, 8, 10, 90, 120), "the angles are none",
            "-periodic -volumes CELLS"),
    refuses("cell.pdb", crystal(1, 1, 1, 90, 90, 90), "needs -box",
            "-periodic -volumes CELLS"),
    # of names longer than any that is kept are 39 characters
    *(shows("," + 39 * "q" + end, name, text.replace("@", n * "q"), "...")
      for n in (39, 40, 41, 300) for name, text, end in (
          ("long.pcd", PCD.replace("FIELDS T", "FIELDS @"), ","),
          ("long.ply", PLY.replace("float T", "float @"), ","),
          ("long.csv", HEADER.replace("T (%)", "@"), ',"wind'))),
    shows('x,y,z,...,"a ""b"" c",', "names.csv", '"x","y","z","a ""b"" c"\n' + FOUR % (
        ",1", ",2", ",3", ",4")),
    shows(last("n", '"a ""b"""', '"""c"', "d", '"e""f"'), "labels.csv", "x,y,z,n\n" +
          FOUR % (',"a ""b"""', ',"""c"', ',"d"', ',e"f')),
    # 0 so seldom is by chance
    *(shows("", "zeros.txt", "".join("%g %g %g\n" % (
        k % 5 + .5, k * k % 7 + .25, 0 if k in at else 100 + k * 7 % 40 / 4)
        for k in range(40)), told) for at, told in (((5, 17), ""), ((5, 17, 29), (
                "=tess: F:6: z is 0 in 3 rows, to line 30, far from all others; if that "
                "stands for a missing number: -nodata 0\n")))),
    # where the coordinates of places are, and whether groups take them away
    shows("", "level.csv", LEVEL, "level); -qcols chooses others\n",
          "-query F -values OUT F"),
    shows("", "holes.csv", "T,EAST,NORTH,RL\n" + "".join("%d,%d,%d,%d\n" % (
        k * k % 7, k % 3, k // 3 % 3, k // 9) for k in range(27)),
          "columns 2, 3, 4 (EAST, NORTH, RL)", "-by EAST -validate 3"),
]

# ---- binary numbers: the least and the largest of each type ----

TYPES = {"b": ("i1", "char", "I"), "B": ("u1", "uchar", "U"), "h": ("i2", "short", "I"),
         "H": ("u2", "ushort", "U"), "i": ("i4", "int", "I"), "I": ("u4", "uint", "U"),
         "q": ("i8", "", ""), "Q": ("u8", "", ""), "f": ("f4", "float", "F"),
         "d": ("f8", "double", "F")}


def array(kind, rows):
    """a .npy file of five rows of four"""
    return b"\x93NUMPY\1\0v\0" + (
        "{'descr': %s, 'fortran_order': False, 'shape': (5, 4), }" % kind).ljust(
            117).encode() + b"\n" + rows


def extremes():
    """.npy, PLY and PCD files of a value of each type, and what it is"""
    for code, (kind, ply, pcd) in TYPES.items():
        bits = min(8 * struct.calcsize(code), 49)
        T = [0, 1, 2 ** bits - 1, 2 ** bits - 2, 2 ** (bits - 1)] if code.isupper() \
            else [0, -1, 2 ** (bits - 1) - 1, -2 ** (bits - 1), 77]
        if code in "fd":
            T = [0.5, -1.5, 1048576.25, -0.0078125, 3]
        x = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (3, 4, 5)]
        points = "5 3 1 0\n" + "".join("%d %d %d %d %.16g\n" % (k, *p, t)
                                       for k, (p, t) in enumerate(zip(x, T)))
        for order in "<>":
            rows = b"".join(struct.pack(order + "4" + code, *p, t)
                            for p, t in zip(x, T))
            mixed = b"".join(struct.pack(order + "hfd" + code, *p, t)
                             for p, t in zip(x, T))
            yield reads(points, kind + ".npy", array("'%s%s'" % (order, kind), rows),
                        "...")
            if ply:
                yield reads(points, ply + ".ply", (
                    "ply\nformat binary_%s_endian 1.0\nelement vertex 5\nproperty short "
                    "x\nproperty float y\nproperty double z\nproperty %s T\nend_header\n"
                    % ("little" if order == "<" else "big", ply)).encode() + mixed,
                    "...")
            if pcd and order == "<":
                yield reads(points, kind + ".pcd", (
                    "VERSION .7\nFIELDS x y z T\nSIZE 2 4 8 %d\nTYPE I F F %s\nWIDTH 5\n"
                    "HEIGHT 1\nPOINTS 5\nDATA binary\n" % (
                        struct.calcsize(code), pcd)).encode() + mixed, "...")


EXTREMES = list(extremes())
GAP = EXTREMES[-5][2].replace(struct.pack("<d", -1.5), struct.pack("<d", math.nan))
EXTREMES += [
    reads("4 3 1 0\n0 0 0 0 0.5\n1 0 1 0 1048576.25\n2 0 0 1 -0.0078125\n3 3 4 5 3\n",
          "gap.npy", GAP, "1 row dropped", "-skip"),
    reads("5 3 1 0\n0 0 0.5 0 0\n1 0 -1.5 0 1\n2 1 1048576.25 0 0\n"
          "3 0 -0.0078125 1 0\n4 4 3 5 3\n", "cols.npy", EXTREMES[-5][2], "...",
          "-cols 2,4,3,1"),
    refuses("half.npy", array("'<f2'", bytes(40)), "numbers of the kind f2 are not"),
    refuses("fields.npy", array("[('x', '<f8')]", bytes(160)), "has rows of fields"),
    reads("5 3 1 0\n" + "".join("%d %d %d %d 1.152921504606847e+18\n" % (
        k, k, k * k, k ** 3) for k in range(5)), "large.npy", array("'<i8'", b"".join(
            struct.pack("<4q", k, k * k, k ** 3, 2 ** 60 + 1) for k in range(5))),
          "5 integers beyond 2^53 are rounded\n"),
]

CASES = {"lines": LINES, "tables": TABLES, "decimal commas": DECIMAL,
         "columns": COLS, "missing numbers": MISSING, "xyz": XYZ, "meshes": MESHES,
         "clouds": CLOUDS, "known": KNOWN, "not points": NOT, "words": WORDS,
         "other": OTHER, "binary": EXTREMES}


@pytest.mark.parametrize("points, name, text, words, options", [
    pytest.param(*case, id="%s: %s%s %s" % (
        kind, case[4] and case[4] + " ", case[1], case[3].strip()))
    for kind, cases in CASES.items() for case in cases])
def test_file(read, points, name, text, words, options):
    pipe = ["-"] * (name == "-")
    writes = ["-volumes", "CELLS"] * isinstance(points, tuple) or ["-node", "NODE"]
    done = read("f" if pipe else name, text, "-account", *options.split()[
        :-1 if options.endswith(" F") else None], *writes, *["F"] * options.endswith(
            " F"), *pipe)
    if points is None:
        assert (done.code, done.points) == (2, "")
    else:
        assert done.code == 0 and "left out: all\n" in done.out, done.words
        if isinstance(points, tuple):
            assert says(points[0], done.out + done.points)
        else:
            assert done.points == points
    assert says(words, done.words) if words[:1] not in "=" else \
        done.words == words[1:]


def test_cryst1_without_right_angles(read):
    done = read("cell.pdb", crystal(6, 7, 8, 90, 102.5, 90), "-periodic", "-volumes",
                "CELLS")
    for volume in re.search(BOX % (r"(\S+)", r"(\S+)"), done.out).groups():
        assert float(volume) == pytest.approx(
            336 * math.sin(math.radians(102.5)), rel=1e-12)


def test_dump_scaled_in_a_tilted_box(read):
    done = read("scaled.dump", SCALED, "-node", "NODE")
    got = [list(map(float, line.split())) for line in done.points.splitlines()[1:]]
    for line, wanted in zip(got, TWO.splitlines()[1:]):
        assert line == pytest.approx([float(x) for x in wanted.split()], abs=1e-14)
    assert len(got) == 5 and BOX % (253, 253) in read(
        "scaled.dump", SCALED, "-periodic", "-volumes", "CELLS").out


@pytest.mark.parametrize("text, told", [
    (ALONE, True), ("0,13,0,84,0,5,0,7\n1,13,0,84,0,5,0,9\n", True),
    ("0,13,0,84,0,5,1,2,3\n1,13,0,84,0,5,4,5,6\n", False)])
def test_commas_alone_are_told(read, text, told):
    assert ("if commas are decimal" in read("f", text).words) == told


# a number that repeats itself far from all others
@pytest.mark.parametrize("far", ["-3.4028235e+38", "-1e+20", "9.96921e+36",
                                 "-1.7976931e+308"])
def test_far_number_is_advised_to_be_no_data_and_nothing_else(read, far):
    text = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 4 %s\n2 3 %s\n" % (far, far)
    assert re.fullmatch(r".*z is .* in 2 rows.*: -nodata %s\n" % re.escape(far),
                        read("f", text).words)
    assert re.search("(?m)^points *4$", read("f", text, "-nodata", far).out)


@pytest.mark.parametrize("ending", ["vtk", "vtu", "msh"])
def test_mesh_that_tess_writes_but_does_not_read(tess, tmp_path, ending):
    tess("-q", "-mesh", "m." + ending, "-", stdin=CSV)
    done = tess("-node", "out.node", "m." + ending)
    assert done.code == 2 and not (tmp_path / "out.node").exists()
    assert says("is not read: numpy.savetxt...meshio.read", done.err)
