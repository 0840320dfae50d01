"""test_readers.py - what files mean to build/tess, and which it refuses.

Each file holds the same five points, and what tess writes of them is compared
with what is written here.  Of each format what it allows, and damages, come from
test_generate.py; what is said of files, word for word, is in messages.txt.
"""
import gzip
import math
import random
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
    input if it is -), and says words, or nothing.  In words ... is anything."""
    return points, name, text, words, options


def refuses(name, text, words, options=""):
    """tess ends with status 2, writes nothing, and says words"""
    return None, name, text, words, options


def says(words, text):
    return re.search(".*".join(map(re.escape, words.split("..."))), text)


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
    reads(NONE, "dos.txt", PLAIN.replace("\n", "\r\n")),
    reads(NONE, "mac.txt", PLAIN.replace("\n", "\r")),
    reads(NONE, "mark.txt", "\ufeff" + without(PLAIN, 1)),
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
    refuses("both.txt", "0,13, 0,84, 0,5\n",
            ':1: "0,13, 0,84...with and without a blank behind' + COMMA[:-1]),
    refuses("quotes.csv", '"0,13","0,84","0,5"\n', ":1" + THIRTEEN),
    refuses("points.txt", "1.234,5 2.345,6 3.456,7\n",
            ':1: column 1: "1.234,5": not a number (points between th'),
    refuses("thousands.txt", "1,234.5 2,345.6 3,456.7\n",
            ':1: column 1: "1,234.5": not a number (commas between thousands'),
    refuses("unit.csv", "x,y,z\n5 m,6,7\n8,9,10\n",
            ':2: column 1, x: "5 m": not a number'),
    refuses("units.txt", "5 m,6 m,7 m\n8 m,9 m,10 m\n",
            ":1: fewer than three numbers"),
    refuses("asked.csv", "1,2,3,12.5 m\n", 'column 4: "12.5 m": not a number',
            "-cols 1,2,3,4"),
] + [
    # what is no decimal comma is not called so
    refuses("cell.csv", "x,y,z,T\n1,2,3,4\n%s\n" % row, ":3: " + words)
    for row, words in (
        ("1,2,4,5 m", 'column 4, T: "5 m": not a number (a unit?  It must go)\n'),
        ('1,2,4,"1,000"', 'column 4, T: "1,000": not a number (a comma between '
         "thousands must go; see also -decimal)\n"),
        ('1,2,"12,345,678",4', 'column 3, z: "12,345,678": not a number (commas '
         "between thousands must go)\n"),
        ('1,2,4,"1,234.5"', 'column 4, T: "1,234.5": not a number (commas '
         "between thousands must go)\n"),
        ("1,2 m,3,4", 'column 2, y: "2 m": not a number (a unit?  It must go)\n'))]

# -decimal ,: it is read, with something else between columns
PARTLY = comma(re.sub(r"-?\d*\.\d+", r'"\g<0>"', "0.0" + CSV[1:]))
GERMAN = comma(HEADER.replace(",", ";"))
DECIMAL += [
    reads(points, name, text, words, "-decimal ,") for points, name, text, words in (
        (ONE, "semicolons.csv", comma(CSV.replace(",", ";")), ""),
        (ONE, "tabs.txt", comma(CSV.replace(",", "\t")), ""),
        (ONE, "blanks.txt", comma(CSV.replace(",", " ")), ""),
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
    refuses("sign.csv", ALONE, "-decimal needs the sign", "-decimal ;"),
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
    refuses("unnamed.csv", NAMELESS, "column 4, value: 0\n"),
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
    refuses("nameless.txt", NUMBERS, 'no column "lon" ...no line of names',
            "-cols lon,lat,depth"),
    refuses("seventh.csv", OCEAN, 'no column "7" among 6', "-cols 2,3,7"),
    refuses("words.csv", OCEAN, 'column 6, note: "a": not a number', "-cols 2,3,6"),
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
    reads(ONE, "units2.csv", table("Txyz", ",", "T,X,Y,Z\nK,m,m,m\n")),
]

# ---- tables with heads, models ----

CNV = "* Sea-Bird SBE\n# nquan = 4\n# nvalues = 5\n" + "".join(
    "# name %d = %s: what it is\n" % n for n in enumerate(
        ["t090C", "longitude", "latitude", "depSM"])) + \
    "# bad_flag = -9.990e-29\n# file_type = ascii\n*END*\n"
WELL = "~V\n VERS. 2.0 :\n WRAP. NO :\n~W\n NULL. -999.25 :\n~C\n T. :\n" \
    " X.M :\n Y.M :\n DEPT.M :\n~A\n"
HEADS = [
    reads(ONE, "lake.dat", "a lake\n4\nT\nX\nY (m)\nZ\n" + SWAPPED),
    reads(ONE, "turned.txt", "a lake\n5\n" + table("xyzT")),
    reads(ONE, "petrel.txt", "VERSION 1\nBEGIN HEADER\nFLOAT,T\nX\nY\nZ\n"
          "END HEADER\n" + SWAPPED),
    reads(ONE, "post.csv", "\n[Name]\nPlane\n\n[Data]\nT [ K ], X [ m ], Y [ m ], "
          "Z [ m ]\n" + table("Txyz", ", ") + "\n[Lines]\n0, 1\n",
          "its faces, lines or further places are left out: 1 line"),
    reads(ONE, "cast.cnv", CNV + "".join("%11g%11g%11g%11g\n" % row for row in zip(
        *(COLUMNS[c] for c in "Txyz"))),
        "columns 2, 3, 4 (longitude, latitude, depSM)"),
    reads(ONE, "bottle.csv", "BOTTLE,2020\nCTDTMP,LONGITUDE,LATITUDE,CTDPRS\n"
          ",,,DBAR\n" + table("Txyz", ",") + "END_DATA\n",
          "columns 2, 3, 4 (LONGITUDE, LATITUDE, CTDPRS)"),
    reads(ONE, "well.las", WELL + SWAPPED, "columns 2, 3, 4 (X, Y, DEPT)"),
    reads(ONE, "odv.txt", "Cruise\tStation\tType\tT\tLongitude\tLatitude\t"
          "Depth [m]\n" + table(["C", "1", "B", *"Txyz"], "\t"), "",
          "-cols Longitude,Latitude,Depth,T"),
    reads(ONE, "set.vs", "GOCAD VSet 1\nHEADER {\nname:a\n}\nPROPERTIES T\n" +
          table(["PVRTX", *"nxyzT"]) + "END\n"),
    reads(NONE, "grid.bdf", "".join("GRID    %8d        %8.3f%8.3f%8.3f\n" % (
        k, *p) for k, p in enumerate(P, 1))),
    reads(NONE, "wide.bdf", "".join(
        "GRID*   %16d%16d%16.3f%16.3f\n*       %16.3f\n" % (k, 0, *p)
        for k, p in enumerate(P, 1))),
    reads(NONE, "free.bdf", "".join("GRID,%d,,%.3f,%.3f,%.3f\n" % (k, *p)
                                    for k, p in enumerate(P, 1))),
    reads(NONE, "box.inpcrd", "a box\n    5\n" + "".join(
        "%12.7f" % c + "\n" * (k % 6 == 0)
        for k, c in enumerate((c for p in P for c in p), 1)) + "\n"),
    reads(TWO, "free.pqr", table(["ATOM", "n", "C", "LYS", "A", *"nxyzTu"])),
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
    refuses("value.csv", CSV, "-nodata: ...: not a number", "-nodata x"),
    refuses("value.csv", CSV, "-nodata: ...: not a number", "-nodata 1,"),
    refuses("value.csv", CSV, "-nodata: ...: not a number", "-nodata nan"),
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
    refuses("limits2.csv", BELOW, "-below needs a number from 0 to 1", "-below 2"),
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
    refuses("vectors.xyz", MORE.replace("9 0 0 0 9 0", "9 0 0 0 nine"),
            ":2: Lattice needs 9 numbers"),
    refuses("properties.xyz", MORE.replace("pos:R:3", "pos:R"),
            ":2: Properties are not as species:S:1:pos:R:3"),
] + [
    refuses("ways.xyz", with_line(MORE, 2, MORE.splitlines()[1] + " pbc=" + pbc),
            ":2: pbc needs three of T and F")
    for pbc in ('"T T"', '"T T T T"', '"T FxT"', '"T X F"', '""')]

# ---- plain lines are read at once, all others field by field: the same ----

FIELDS = [
    refuses("mixed.csv", "1,2,3,4\n1,5, 2,5\n",
            ':2: "1,5, 2,5": commas with and without a blank...' + COMMA[:-1]),
    refuses("tabbed.csv", "1,2,3\n\t1,2,4,5\n", ":2: 4 columns"),
    refuses("fourth.txt", "1 2 3\n1 2 3 4\n", ":2: 4 columns"),
    refuses("glued.txt", "1 2 3\n1 2 3x\n", ':2: column 3: "3x": not a number'),
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
FACES = "its faces are left out"
MESHES = [
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
] + [
    refuses("other.off", with_line(OFF, 1, word),
            word + ": not an OFF file of points in space")
    for word in ("OFF BINARY", "4OFF", "nOFF", "OFF binary")
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
    refuses("high.pcd", PCD.replace("HEIGHT 1", "HEIGHT 2"),
            "announces 5 points, WIDTH times HEIGHT are 10"),
    refuses("type.pcd", PCD.replace("F U F", "F X F"), ":5: TYPE is I, U or F"),
    refuses("packed.pcd", PCD.replace("ascii", "binary_compressed"),
            "pcl_convert_pcd_ascii_binary F G 0"),
    refuses("nan.pcd", PCD.replace("20 0 1.5", "20 nan 1.5"),
            ':14: column 2, x: "nan": not a number'),
    refuses("ways.dump", SCALED.replace("pp pp ff", "pp pp"),
            ":5: not three of pp, ff, ss, mm"),
    refuses("boxless.dump", without(SCALED, 5, 6, 7, 8),
            ":5: no BOX BOUNDS before"),
    reads(TWO, "frames.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\n"
          "ITEM: ATOMS x z y T u\n" + table("xzyTu") + SCALED,
          "its further frames are left out"),
    refuses("short.las", "LASF" + 40 * " ", "the file ends in its head"),
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
    (b"\320\317\021\340", "a spreadsheet, which is not read: save the sheet"),
    (b"\211HDF\r\n", "HDF5"),
    ("CDF\1", "netCDF"),
    ("II*\0", "TIFF, which is not read: gdal_translate"),
    ("ncols 5\nnrows 5\n1 2 3\n", "an ESRI grid"),
    ("DSAA\n1 2 3\n", "Surfer's grid"),
    ("SQLite format 3\0", "a GeoPackage"),
    ("PAR1xxxx", "parquet"),
    ("# vtk DataFile Version 3.0\n", "VTK's"),
    ('<VTKFile type="x">\n', "VTK's"),
    ("$MeshFormat\n4.1 0 8\n", "Gmsh's"),
    ("*Heading\n", "Abaqus's"),
    ("ISO-10303-21;\n", "STEP"),
    ("<!doctype html>\n", "a web page"),
    ("version https://git-lfs.github.com/spec/v1\n", "a pointer of Git LFS"),
    ("%PDF-1.4\n", "PDF"),
    ('{"a": 1}\n', "JSON"),
    ("data_x\n_cell 1\n", "CIF, which is not read: ase convert"),
    ("data_x\n_atom_site.id\n", "mmCIF, which is not read: gemmi convert"),
    ("a title\n1.0\n1 0 0\n0 1 0\n0 0 1\nNa Cl\n1 1\nDirect\n0 0 0\n", "POSCAR"),
    ("a title\n1\n    1WATER  OW1    1   0.126   1.624   1.679\n   1 1 1\n", "GRO"),
    ("LAMMPS\n\n5 atoms\n1 atom types\n", "LAMMPS's data"),
    ("2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n", "PTX"),
    (b"LASF" + 100 * b"." + b"\200....", "LAZ"))]

# ---- what is no file of points ----

SEMICOLONS = table("xyz", ";")
EMPTY = "empty (-skip drops"
PLANE = "fewer than three numbers; for points in a plane, x, y and values, see -pl"
BIG = "format binary_big_endian 1.0\nelement vertex 9\nproperty "
NOT = [
    # of a row of another width, what may be behind it
    refuses("width.tsv", "1\t2\t3\n1\t2\n",
            ":2: 2 columns, but others have 3 (empty cells?  see -skip)\n"),
    refuses("width.csv", "1,2,3\n1,2\n", ":2: 2 columns, but others have 3\n"),
    refuses("width.csv", "1,2,3\n4\n", ":2: 1 column, ... (one separator in a"),
    refuses("both.csv", SEMICOLONS + "1;2 3;4\n",
            ':6: column 2: "2 3": ... (two numbers in one cell: one sep'),
    refuses("word.csv", SEMICOLONS + "1;2 x;4\n",
            ':6: column 2: "2 x": not a number (a unit?  It must go)\n'),
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
    refuses("empty.txt", "", "empty"),
    refuses("comment.txt", "\n# nothing\n", "empty"),
    refuses("header.txt", "x,y,z\n", "before the first point"),
    refuses("empty.node", "0 3 0 0\n", "no points"),
    refuses("plane.txt", "1 2\n3 4\n", ":1: " + PLANE),
    refuses("plane.csv", "x,y\n1,2\n3,4\n", ":2: " + PLANE),
    refuses("lone.txt", "1.5\n3.5\n", ":1: fewer than two numbers",
            "-plane -validate"),
    refuses("short.txt", "1 2 3\n1 2\n", ":2: 2 columns, but others have 3"),
    refuses("word.txt", "1 2 3\n1 x 3\n", ':2: column 2: "x": not a number'),
    refuses("missing.csv", "1,2,3,4\n1,2,3\n", ":2: 3 columns"),
    refuses("last.csv", "1,2,3,4\n0,1,0,\n", ":2: column 4...: " + EMPTY),
    refuses("first.csv", "0,1,0,\n1,2,3,4\n", ":1: column 4...: " + EMPTY),
    refuses("named.csv", "x,y,z,T\n0,1,0,\n1,2,3,4\n",
            ":2: column 4, T: empty (-skip drops such lines)\n"),
    reads("1 3 0 0\n0 0 1 0\n", "hollow4.csv", "x,y,z,T\n0,1,0,\n",
          "column 4, T (empty) is not a number: skip"),
    refuses("hole.csv", "1,2,3,4,5\n1,2,3,,5\n", ":2: column 4...: " + EMPTY),
    refuses("top.csv", "1,2,,4,5\n1,2,3,4,5\n", ":1: column 3...: " + EMPTY),
    refuses("y.csv", "x,y,z,T\n1,,3,4\n1,2,3,4\n", ":2: column 2...: " + EMPTY),
    refuses("two.csv", "1,,3\n1,2,3\n", ":1: column 2...: " + EMPTY),
    refuses("bare.csv", '1,2,3,""\n1,2,3,4\n', ":1: column 4...: " + EMPTY),
    refuses("cell.tsv", "1\t2\t3\t4\n1\t\t3\t4\n", ":2: ...-skip"),
    refuses("cols.csv", "x,y,z\n,2,3\n", ":2: column 1...: " + EMPTY,
            "-cols y,x,z"),
    refuses("few.txt", "9\n1 2 3\n4 5 6\n",
            "announces 9 points, has room for 3 at most"),
    refuses("binary.ply", "ply\nformat binary 1.0\n", ":2: not a format of PLY"),
    refuses("binary.ply", "ply\n%shalf x\n" % BIG, ":4: not a"),
    refuses("binary.ply", "ply\n%si1 x\n" % BIG, ":4: not a prop"),
    refuses("binary.ply", "ply\n%slist int int x\n" % BIG, ":4: a list is not a prop"),
    refuses("dates.txt", "2024-11 1 2 3\n2024-12 4 5\n", ":2: 3 columns"),
    refuses("nan.txt", "1 2 nan\n", ':1: column 3: "nan": not a number (-skip'),
    refuses("huge.txt", "1 2 3\n4 5 1D400\n", ':2: column 3: "1D400": not finite'),
    refuses("wide.txt", b"\377\3761\0 \0", "UTF-16"),
    refuses("none.xyz.gz", gzip.compress(NONE.encode()), "compressed by gzip"),
    refuses("none.node", gzip.compress(NONE.encode()), "compressed by gzip"),
    refuses("table.xlsx", "PK\3\4...", "a zip archive"),
    refuses("part.stl", b"solid".ljust(80) + b"\2\0\0\0" + 90 * b" ",
            "no binary STL: its size is not 84 and 50 times"),
    refuses("few.STL", "few\0", "no binary STL"),
    refuses("few.dat", "few\0", "is no text, nor a binary format that is known"),
    refuses("zero.dat", "0\0", "is no text"),
    # ... of a pipe the size is not known, and all of it not at hand
    refuses("-", b"solid".ljust(80) + b"\320\7\0\0" + bytes(99999),
            "ends after 5997 of 6000 points"),
    # words and numbers in one column: either way round
    refuses("asked.csv", "a,1,2,3\n" + 3999 * "7,1,2,3\n",
            ':1: column 1: "a": not a number'),
    refuses("asked.csv", 3999 * "a,1,2,3\n" + "7,1,2,3\n",
            ':4000: column 1: "7": a number among words'),
]

CASES = {"lines": LINES, "tables": TABLES, "decimal commas": DECIMAL,
         "columns": COLS, "heads": HEADS, "missing numbers": MISSING, "xyz": XYZ,
         "fields": FIELDS, "meshes": MESHES, "clouds": CLOUDS, "known": KNOWN,
         "not points": NOT}


@pytest.mark.parametrize("points, name, text, words, options", [
    pytest.param(*case, id="%s: %s%s %s" % (
        kind, case[4] and case[4] + " ", case[1], case[3].strip()))
    for kind, cases in CASES.items() for case in cases])
def test_file(tess, tmp_path, points, name, text, words, options):
    data = text if isinstance(text, bytes) else text.encode()
    if name != "-":
        (tmp_path / name).write_bytes(data)
    out = tmp_path / "out of it.node"
    done = tess(*options.split(), "-account", "-node", out, name,
                stdin=data if name == "-" else None)
    if points is None:
        assert done.code == 2 and not out.exists()
    else:
        assert done.code == 0, done.err
        assert out.read_text() == points
        assert "left out: all\n" in done.out
    assert says(words, done.err) if words else done.err == ""


# ---- what else is read of a file: boxes, labels, names ----

def labels(path):
    """the last column of a CSV file, with its name"""
    return [line.rpartition(",")[2] for line in path.read_text().splitlines()]


@pytest.fixture
def cells(tess, tmp_path):
    """cells(name, text, *options) has tess write the points' cells to v.csv"""
    def run(name, text, *options):
        (tmp_path / name).write_text(text)
        return tess(*options, "-volumes", "v.csv", name)
    return run


def test_lattice_is_the_box_of_the_cells(cells):
    assert "the box's is 729\n" in cells("more.xyz", MORE).out


def test_lattice_along_other_axes_with_an_origin(cells, tmp_path):
    done = cells("turned.xyz", MORE.replace("9 0 0 0 9", "0 9 0 9 0").replace(
        '0 0 9"', '0 0 -9" Origin="-1 -2 7"'), "-periodic")
    assert "sum to 729; the box's is 729\n" in done.out
    assert "outside" not in done.err and "skipped" not in done.err
    assert labels(tmp_path / "v.csv") == "species C H H O Fe".split()


def test_lattice_in_brackets(cells):
    assert "the box's is 729\n" in cells("nested.xyz", re.sub(
        "Lattice=.*", "Lattice=[[9,0,0],[0,9,0],[0,0,9]]", MORE)).out


def test_skew_lattice(cells):
    skew = MORE.replace('"9 0', '"9 1')
    assert "not a box along x, y, z" in cells("skew.xyz", skew).err
    assert "sum to 729; the box's is 729\n" in cells("skew.xyz", skew,
                                                     "-periodic").out


def test_lattice_of_vectors_in_a_plane_is_refused(cells):
    done = cells("flat.xyz", MORE.replace("9 0 0 0 9 0", "9 0 0 9 0 0"),
                 "-periodic")
    assert done.code == 2 and "vectors are in a plane" in done.err


@pytest.mark.parametrize("pbc", ['"T T F"', "[True, False, True]", '"1 0 1"', "F"])
def test_pbc_in_some_ways_alone_is_no_box_that_repeats_itself(cells, tmp_path, pbc):
    text = with_line(MORE, 2, MORE.splitlines()[1] + " pbc=" + pbc)
    done = cells("slab.xyz", text, "-q", "-periodic", "-box", "0,9,0,9,0,9")
    assert done.code == 2 and "its pbc says" in done.err
    assert not (tmp_path / "v.csv").exists()
    assert cells("slab.xyz", text, "-q").code == 0


@pytest.mark.parametrize("pbc", ['"T T T"', "[True, True, True]", '"1 1 1"', "T"])
def test_pbc_in_all_ways_is_a_box_that_repeats_itself(cells, pbc):
    assert cells("bulk.xyz", with_line(MORE, 2, "%s pbc=%s foo=0" % (
        MORE.splitlines()[1], pbc)), "-q", "-periodic").code == 0


def crystal(*numbers, group="P 1"):
    """a PDB file of the first four atoms with such a cell, the last ones first"""
    lines = PDB.splitlines(True)
    return "CRYST1%9.3f%9.3f%9.3f%7.2f%7.2f%7.2f %-11s\n" % (*numbers, group) + \
        "".join(lines[8:10] + lines[3:5])


def test_cryst1_is_the_box_that_repeats_itself(cells):
    done = cells("cell.pdb", crystal(6, 7, 8, 90, 90, 90), "-periodic")
    assert "sum to 336; the box's is 336\n" in done.out
    assert "group" not in done.err


def test_cryst1_cuts_no_cells_else(cells, tmp_path):
    assert "the box's is 0.5\n" in cells(
        "cell.pdb", crystal(6, 7, 8, 90, 90, 90)).out
    assert labels(tmp_path / "v.csv") == "name FE O N CA".split()


def test_cryst1_a_group_of_symmetries_is_told(cells):
    assert "P 21 21 2" in cells("cell.pdb", crystal(
        6, 7, 8, 90, 90, 90, group="P 21 21 2"), "-periodic").err


def test_cryst1_without_right_angles(cells):
    done = cells("cell.pdb", crystal(6, 7, 8, 90, 102.5, 90), "-periodic")
    volumes = re.search(r"sum to (\S+); the box's is (\S+)\n", done.out)
    for volume in volumes.groups():
        assert float(volume) == pytest.approx(
            336 * math.sin(math.radians(102.5)), rel=1e-12)


def test_cryst1_with_angles_of_nothing_is_refused(cells):
    assert "the angles are none" in cells("cell.pdb", crystal(
        6, 7, 8, 10, 90, 120), "-periodic").err


def test_cryst1_of_no_crystal_is_no_box(cells):
    assert "needs -box" in cells("cell.pdb", crystal(1, 1, 1, 90, 90, 90),
                                 "-periodic").err


def test_dump_scaled_in_a_tilted_box(cells, tess, tmp_path):
    (tmp_path / "scaled.dump").write_text(SCALED)
    tess("-q", "-node", "out.node", "scaled.dump")
    got = (tmp_path / "out.node").read_text().splitlines()
    assert len(got) == 6
    for line, wanted in zip(got[1:], TWO.splitlines()[1:]):
        assert [float(x) for x in line.split()] == pytest.approx(
            [float(x) for x in wanted.split()], abs=1e-14)
    assert "sum to 253; the box's is 253\n" in cells("scaled.dump", SCALED,
                                                     "-periodic").out


# of names longer than any that is kept are 39 characters, and no other one is
@pytest.mark.parametrize("n", [39, 40, 41, 300])
@pytest.mark.parametrize("name, text", [
    ("long.pcd", PCD.replace("FIELDS T", "FIELDS @")),
    ("long.ply", PLY.replace("float T", "float @")),
    ("long.csv", HEADER.replace("T (%)", "@"))])
def test_long_name_is_cut(cells, tmp_path, name, text, n):
    cells(name, text.replace("@", n * "q"), "-q")
    assert re.match(r'x,y,z,[a-z,]*,q{39},[uwr"]', (tmp_path / "v.csv").read_text())


def test_doubled_quotes_in_a_name(cells, tmp_path):
    cells("names.csv", '"x","y","z","a ""b"" c"\n0,0,0,1\n1,0,0,2\n0,1,0,3\n'
          "0,0,1,4\n", "-q")
    assert re.match('x,y,z,.*,"a ""b"" c",', (tmp_path / "v.csv").read_text())


def test_doubled_quotes_in_labels(cells, tmp_path):
    cells("labels.csv", 'x,y,z,n\n0,0,0,"a ""b"""\n1,0,0,"""c"\n0,1,0,"d"\n'
          '0,0,1,e"f\n', "-q")
    assert labels(tmp_path / "v.csv")[1:] == ['"a ""b"""', '"""c"', "d", '"e""f"']


def test_query_says_where_its_coordinates_are(tess, tmp_path):
    (tmp_path / "level.csv").write_text(table("xyzT", ",", "x,y,level,T\n"))
    done = tess("-query", "level.csv", "-values", "v.csv", "level.csv")
    assert "level); -qcols chooses others\n" in done.err


def test_by_takes_no_coordinate_away(tess):
    assert "columns 2, 3, 4 (EAST, NORTH, RL)" in tess(
        "-by", "EAST", "-validate", "2", "-",
        stdin=table("Txyz", ",", "T,EAST,NORTH,RL\n")).err


def test_input_is_not_overwritten(tess, tmp_path):
    (tmp_path / "none.node").write_text(NONE)
    assert tess("-node", "none.node", "none.node").code == 2
    assert (tmp_path / "none.node").read_text() == NONE


def test_two_outputs_of_one_name_are_refused(tess, tmp_path):
    assert tess("-node", "x", "-ele", "x", "-", stdin=NONE).code == 2
    assert not (tmp_path / "x").exists()


def test_commas_alone_are_told(tess):
    assert "if commas are decimal" in tess("-", stdin=ALONE).err


# a number that repeats itself far from all others
@pytest.mark.parametrize("far", ["-3.4028235e+38", "-1e+20", "9.96921e+36",
                                 "-1.7976931e+308"])
def test_far_number_is_advised_to_be_no_data_and_nothing_else(tess, far):
    text = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 4 %s\n2 3 %s\n" % (far, far)
    assert re.fullmatch(r".*z is .* in 2 rows.*: -nodata %s\n" % re.escape(far),
                        tess("-", stdin=text).err)
    assert re.search("(?m)^points *4$", tess("-nodata", far, "-", stdin=text).out)


@pytest.mark.parametrize("ending", ["vtk", "vtu", "msh"])
def test_mesh_that_tess_writes_but_does_not_read(tess, tmp_path, ending):
    tess("-q", "-mesh", "m." + ending, "-", stdin=CSV)
    done = tess("-node", "out.node", "m." + ending)
    assert done.code == 2 and not (tmp_path / "out.node").exists()
    assert says("is not read: numpy.savetxt...meshio.read", done.err)


# ---- plain lines are read at once, all others field by field: the same ----

def quick():
    r = random.Random(3)
    return "".join("%.17g,%.3f,-%.6fe-1,%d\n" % (9 * r.random(), r.random(),
                                               r.random(), k) for k in range(4000))


@pytest.mark.parametrize("change", [
    lambda s: s, lambda s: s.replace(",", ", "), lambda s: s.replace(",", ";"),
    lambda s: s.replace(",", " "), lambda s: s.replace(",", "\t"),
    lambda s: s.replace("\n", "\r\n"), lambda s: each_line(s, "  ", "  "),
    lambda s: with_line(with_line(s, 5, s.splitlines()[4] + " # one"), 9,
                        s.splitlines()[8] + ","),
    lambda s: re.sub("(?m)^(.*?),", r"\1 ,", s), lambda s: s[:-1] + " # last\n",
    # words, too: of one column, of one that is not asked for
    lambda s: re.sub("(?m)^(.*?),", r"\1,2024-01-31T12:00:00Z,", s),
    lambda s: each_line(s, "A-1,"), lambda s: each_line(s, "", ",a b"),
    lambda s: each_line(s, "A 1,"), lambda s: each_line(s.replace(",", "\t"), "A1\t"),
    lambda s: each_line(s.replace(",", " "), "A1 "),
    lambda s: each_line(s.replace(",", "\t"), "A 1\t")], ids=[
        "as they are", "blanks behind commas", "semicolons", "blanks", "tabs",
        "CR LF", "blanks around", "a comment, a comma too many", "blanks before commas",
        "a comment at the end", "a date", "a word first", "words last",
        "words first", "tabs and a word", "blanks and a word", "tabs and words"])
def test_lines_are_the_same_quick_or_slow(tess, tmp_path, change):
    text = quick()
    tess("-q", "-node", "slow.node", "-", stdin=each_line(text, "", " # slow"))
    tess("-q", "-node", "quick.node", "-", stdin=change(text))
    got = (tmp_path / "quick.node").read_text().splitlines()
    assert got == (tmp_path / "slow.node").read_text().splitlines()
    # (nor is it wrong in both)
    assert len(got) == 4001
    for line, wanted in zip(got[1:], text.splitlines()):
        assert [float(x) for x in line.split()[1:]] == [
            float(x) for x in wanted.split(",")]


def test_lines_with_a_number_that_is_not_asked_for(tess, tmp_path):
    text = quick()
    tess("-q", "-cols", "2,3,4,5", "-node", "out.node", "-",
         stdin=each_line(text, "7,"))
    tess("-q", "-node", "slow.node", "-", stdin=text)
    assert (tmp_path / "out.node").read_text() == (
        tmp_path / "slow.node").read_text()


# ---- binary PLY, STL, .npy, by NumPy and meshio ----

@pytest.fixture
def binary(tess, tmp_path):
    """binary(name, *options): what tess reads there, as an array, or says"""
    np = pytest.importorskip("numpy")

    def read(name, *options):
        done = tess("-q", "-node", "p.node", *options, name)
        if done.code:
            return done.err
        return np.array([line.split()[1:] for line in (
            tmp_path / "p.node").read_text().splitlines()][1:], float)
    return read


def numbers():
    import numpy as np
    return np.random.default_rng(1).random((50, 5)) * (1, 2, 3, 100, -7)


def same(a, b):
    return a.shape == b.shape and (a == b).all()


@pytest.mark.parametrize("kind", "<f8 >f8 <f4 >f4 i1 u1 <i2 >i2 <u2 >u2 <i4 >i4 <u4 "
                         ">u4 <i8 >i8 <u8 >u8".split())
def test_npy_of_each_kind(binary, kind):
    import numpy as np
    random = np.random.default_rng(2)
    a = numbers().astype(kind) if "f" in kind else random.integers(
        -99 * ("i" in kind), 99, (50, 5)).astype(kind)
    np.save("p.npy", a)
    assert same(binary("p.npy"), a.astype(float))


def test_npy_version_two_columns_orders_and_gaps(binary):
    import numpy as np
    p = numbers()
    with open("p.npy", "wb") as f:
        np.lib.format.write_array(f, p, (2, 0))
    assert same(binary("p.npy", "-cols", "3,1,2,5"), p[:, [2, 0, 1, 4]])
    p[3:5, 3] = np.nan
    np.save("p.npy", p)
    assert same(binary("p.npy", "-skip"), np.delete(p, (3, 4), 0))
    np.save("p.npy", np.asfortranarray(p[:, :3]))
    assert same(binary("p.npy"), p[:, :3])


@pytest.mark.parametrize("change, why", [
    (lambda p: p[:, 0], "no array of two dim"),
    (lambda p: p != 0, "of the kind b1"),
    (lambda p: p.reshape(5, 10, 3), "no array of two dim"),
    (lambda p: p + 1j, "of the kind c16"),
    (lambda p: p.astype("f2"), "the kind f2"),
    (lambda p: p[:, 0].astype([("x", "f8")]), "has rows of fields")])
def test_npy_that_is_no_table_of_numbers(binary, change, why):
    import numpy as np
    np.save("p.npy", change(numbers()[:, :3]))
    assert why in binary("p.npy")


@pytest.mark.parametrize("size, why", [
    (1000, "announces 50 points, has room for 36 at most"),
    (40, "ends in its head"), (7, "a version that is not known")])
def test_npy_that_is_cut(binary, tmp_path, size, why):
    import numpy as np
    np.save("p.npy", np.asfortranarray(numbers()[:, :3]))
    (tmp_path / "p.npy").write_bytes((tmp_path / "p.npy").read_bytes()[:size])
    assert why in binary("p.npy")


def test_stl_and_ply_of_meshio(binary):
    import numpy as np
    meshio = pytest.importorskip("meshio")
    p = numbers()[:, :3]
    m = meshio.Mesh(p, [("triangle", np.random.default_rng(3).integers(
        0, 50, (9, 3), "i4"))])
    meshio.write("p.stl", m, binary=True)
    assert same(binary("p.stl"), p[m.cells[0].data].reshape(-1, 3).astype(
        "f4").astype(float))
    meshio.write("p.ply", m, binary=True)
    assert same(binary("p.ply"), p)


@pytest.mark.parametrize("order, of", [("<", "little"), (">", "big")])
def test_ply_and_stl_in_both_orders_of_bytes(binary, tmp_path, order, of):
    import numpy as np
    random = np.random.default_rng(4)
    names = "x y z red k".split()
    kinds = "f8 f4 i2 u1 u4".split()
    a = np.zeros(50, [(n, order + k) for n, k in zip(names, kinds)])
    for k, name in enumerate(names):
        a[name] = random.integers(0, 2 ** 8, 50) - 99 * (k < 3)
    a["x"] += .1
    a["k"] += 2 ** 32 - 300
    head = "ply\nformat binary_%s_endian 1.0\nelement vertex 50\n" % of + "".join(
        "property %s %s\n" % both for both in zip(
            "double float32 short uchar uint32".split(), names)) + \
        "element face 1\nproperty list uchar int vertex_index\nend_header\n"
    (tmp_path / "p.ply").write_bytes(head.encode() + a.tobytes() + b"\3\n\n\n")
    assert same(binary("p.ply"), np.array(a.tolist()))
    corners = random.random((9, 9)).astype("f4")
    (tmp_path / "p.stl").write_bytes(
        b"solid".ljust(80) + struct.pack(order + "I", 9) + b"".join(
            struct.pack(order + "12fH", 0, 0, 0, *t, 7) for t in corners))
    assert same(binary("p.stl"), corners.reshape(-1, 3).astype(float))
