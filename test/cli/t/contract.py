# contract.py - what build/tess promises of any file that it reads, over all
# formats; t_readers.sh runs it.
#
#   python3 contract.py TESS
#
# In the current directory, where it leaves its files.  Prints `ok ...' or
# `FAILED ...' for each test; of each format how many bytes are deaf.
#
# Nothing in a format's sample, of samples.py, may be changed, cut or added
# without a word, but for what DEAF lists: what the format says is no part of
# the points.
import concurrent.futures
import csv
import itertools
import math
import os
import random
import re
import struct
import subprocess
import threading

from samples import CORNERS, P, SAMPLES, TESS, V, row_matches, test

# What may be deaf: groups of expressions, or a range of bytes.
DEAF = {
    # (titles of coordinates, but for what they are; numbers of points; what
    # stands for no number, where no value has it)
    "rows.txt": [rb'"(\d)" '],
    "savetxt.txt": [rb"(X),"],
    "ids.txt": [rb"\n(1005) "],
    "geoeas.dat": [rb"^(.*)\n", rb"\n(X)\n", rb"(\))\n"],
    "turned.txt": [rb"^(.*)\n"],
    "restart.rst7": [rb"^(.*)\n"],
    "set.ts": [rb"TSu(.*)\n", rb"HEADER \{\n(.*)\n", rb"ZPOSITIVE (.*)\n",
               rb"VALUES -(.*)\n", rb"PVRTX (\d)", rb"TRGL( .*)\n"],
    "short.bdf": [rb"\$(.*)\n", rb"(CTETRA.*)\n", rb"GRID {4}(.{8})"],
    "wide.bdf": [rb"GRID\* {3}(.{16})", rb"(\*)\n", rb"\n\*(.{7})"],
    "free.bdf": [rb"^(CEND\nBEGIN BULK)\n", rb"GRID,(\d)"],
    "post.csv": [rb"\[Name\]\n(.*)\n", rb"Fields\]\n(.*)\n", rb"\[( m \])",
                 rb"(X) \[", rb"(\[)Spatial", rb"\[(Faces\]\n.*)\n"],
    "petrel.txt": [rb"^#((?s:.*)1)\nBEGIN", rb"\n(X)\n", rb"(FLOAT),"],
    "well.las": [rb"~[VWCA](.*)\n", rb"#(.*)\n", rb"VERS\.( .*)\n",
                 rb"WRAP\.( ) {17}N((?s:.*?) )NULL", rb"NULL\.( ) +(-.*)\n",
                 rb" (?:INDEX|X|Y|TVD|GR)\.(.*)\n"],
    "cast.cnv": [rb"Sea-Bird(.*\n.*)\n", rb"# name \d( )", rb"name .*:(.*)\n",
                 rb"bad_flag = -(.*)\n"],
    "bottle.csv": [rb"^BOTTLE,(.*)\n", rb"\n#(.*)\n", rb",,,(DBAR),(ITS-90)"],
    "odv.txt": [rb"^/(/.*)\n", rb"\t(Station)\t(Type)\t", rb"A\t(s)\t(B)\t"],
    "atoms.pqr": [rb"REMARK(.*)\n", rb"ATOM(.{8})", rb"ATOM.{10}(.{18})"],
    "lines.txt": [rb"#(.*)\n"],
    "atoms.xyz": [rb"\n(a comment)\n"],
    "more.xyz": [rb"(time=7)"],
    "mesh.off": [rb"\n3( .*)", rb"5 2 (0)\n"],
    "mesh.ply": [rb"comment (.*)\n", rb"\n3( .*)\n$", rb"int (vertex_index)",
                 rb"property list (uchar int) "],
    "packed.ply": [rb"comment (.*)\n", rb"int (vertex_index)",
                   rb"property list (uchar int) ", rb"element face (1)",
                   range(-13, 0)],
    "mesh.obj": [rb"#(.*)\n", rb"\no( .*)\n", rb"vn( .*)\n", rb"\nf( .*)\n"],
    "mesh.stl": [rb"solid( .*)\n", rb"normal( .*)\n"],
    "packed.stl": [range(0, 80), range(84, 96), range(132, 146),
                   range(182, 184)],
    "atoms.pdb": [rb"HEADER(.*)\n", rb"ATOM  (.{24})",
                  rb"ATOM.{50}(  1.00)"],
    "cloud.pcd": [rb"VIEWPOINT( .*)\n", rb"#(.*)\n", rb"VERSION (.*)\n"],
    "packed.pcd": [rb"VIEWPOINT( .*)\n", rb"#(.*)\n", rb"VERSION (.*)\n"],
    "dump.lammpstrj": [rb"TIMESTEP\n(.*)\n"],
    "survey.las": [range(4, 24), range(26, 96), range(100, 104), range(111, 131),
                   range(179, 227)] + [
        range(227 + 20 * k + 14, 247 + 20 * k) for k in range(5)],
}
# Formats that have no count: what a cut between two lines leaves is sound.
OPEN = {"lines.txt", "names.csv", "mesh.obj", "atoms.pdb", "rows.txt",
        "savetxt.txt", "ids.txt", "geoeas.dat", "short.bdf", "wide.bdf",
        "free.bdf", "post.csv", "petrel.txt", "well.las", "odv.txt",
        "atoms.pqr"}
ROWLESS = {"restart.rst7"}  # two points in a line
PACKED = {"packed.ply", "packed.stl", "array.npy", "packed.pcd", "survey.las"}

BOXED = {"more.xyz", "dump.lammpstrj", "restart.rst7"}  # these have a box that repeats itself
# and these what -volumes alone shows: titles, labels
NAMED = {"atoms.xyz", "atoms.pdb", "names.csv", "mesh.ply", "packed.ply",
         "cloud.pcd", "packed.pcd", "rows.txt", "savetxt.txt", "geoeas.dat",
         "set.ts", "post.csv", "petrel.txt", "well.las", "cast.cnv",
         "bottle.csv", "odv.txt", "atoms.pqr"}

place = threading.local()
number = iter(range(1000))


def run(name, content, *options, pipe=False, like=None):
    """The exit code, what is written, and messages without the folder's name;
    like: the sample whose box counts."""
    if not hasattr(place, "folder"):
        place.folder = "in%d" % next(number)
        os.makedirs(place.folder, exist_ok=True)
    path = os.path.join(place.folder, name)
    out = os.path.join(place.folder, "out.node")
    volumes = os.path.join(place.folder, "v.csv")
    if (like or name) in BOXED | NAMED:
        options += "-volumes", volumes
    for old in out, volumes:
        if os.path.exists(old):
            os.remove(old)
    if (like or name) in BOXED:
        options += "-periodic",
    with open(path, "wb") as f:
        f.write(content)
    with open(path, "rb") as f:
        done = subprocess.run(
            [TESS, "-account", *options, "-node", out, "-" if pipe else path],
            stdin=f if not pipe else None, input=content if pipe else None,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=20)
    points = b"".join(open(name, "rb").read() for name in (out, volumes)
                      if os.path.exists(name))
    # (how far the mesh is, on a machine that is slow enough to be told)
    words = re.sub(rb"tess: \d+ tetrahedra after .*\n", b"", done.stderr.replace(
        path.encode(), b"F").replace(b"standard input", b"F"))
    if done.returncode == 0 and b"left out: all\n" not in done.stdout and \
            "-q" not in options:
        test("the account of %s: %s" % (name, content[:400]), False)
    return done.returncode, points, words


pool = concurrent.futures.ThreadPoolExecutor(2)
whole = {name: run(name, content) for name, content in SAMPLES.items()}


def points_of(node):
    return sorted(tuple(float(x) for x in line.split()[1:4])
                  for line in node.decode().splitlines()[1:]
                  if line[0].isdigit() and "," not in line)


for name, (code, node, words) in whole.items():
    right = sorted(tuple(struct.unpack("<3f", struct.pack("<3f", *p)))
                   if name == "packed.stl" else p
                   for p in (CORNERS if ".stl" in name else P))
    # (copies of points go with those of a box that repeats itself)
    test("%s: its points" % name, code == 0 and (
        set(right) <= set(points_of(node)) if name in BOXED
        else right == points_of(node)))


def many(jobs):
    """The results of run for each of (name, content, options)."""
    return list(pool.map(lambda job: run(*job), jobs))


# ---- deafness: each byte changed ----

def changed(content, i, text):
    c = content[i]
    if text and chr(c).isdigit():
        c = (c - 48 + 1) % 10 + 48
    elif text:
        c = ord("y") if c == ord("x") else ord("x")
    else:
        c ^= 65
    return content[:i] + bytes([c]) + content[i + 1:]


def may_be_deaf(name):
    content, deaf = SAMPLES[name], set()
    for what in DEAF.get(name, []):
        if isinstance(what, range):
            deaf.update(i % len(content) for i in what)
        else:
            for m in re.finditer(what, content):
                for k in range(len(m.groups())):
                    deaf.update(range(*m.span(k + 1)))
    return deaf


for name, content in SAMPLES.items():
    head = len(content)
    if name in PACKED:
        head = {"packed.ply": content.find(b"end_header") + 11,
                "array.npy": 0, "packed.stl": 0, "survey.las": 0,
                "packed.pcd": content.find(b"DATA binary") + 12}[name]
    jobs = [(name, changed(content, i, i < head)) for i in range(len(content))]
    deaf = [i for i, r in enumerate(many(jobs)) if r == whole[name]]
    wrong = sorted(set(deaf) - may_be_deaf(name))
    if wrong:
        print("        %s: deaf at %s" % (name, [
            (i, content[max(0, i - 8):i + 8]) for i in wrong[:12]]))
    test("%s: of %d bytes %d are deaf, by its format; else none" %
         (name, len(content), len(deaf)), not wrong)

# ---- cuts: each prefix, and what is behind the end ----

for name, content in SAMPLES.items():
    results = many([(name, content[:n]) for n in range(len(content))])
    bad = []
    for n, (code, node, words) in enumerate(results):
        known = name in OPEN and content[n - 1:n] == b"\n"
        if code == 0 and not known and words == whole[name][2]:
            bad.append(n)
        if code == 0 and name not in OPEN and node != whole[name][1] and \
                content[n:n + 1].isspace() and content[n - 1:n] == b"\n":
            bad.append(n)
    if bad:
        print("        %s: unheard after %s" % (name, bad[:20]))
    test("%s: of %d cuts none is silent" % (name, len(content)), not bad)
    junk = many([(name, content + extra)
                 for extra in (b"junk 1 2\n", b"1 2\n", b"x\n")])
    test("%s: a line of junk at the end is heard" % name,
         all(r[:1] + r[2:] != whole[name][:1] + whole[name][2:]
             for r in junk))

# ---- neutral changes ----

def shortest(x):
    """The first one of 15, 16, 17 digits that gives x back"""
    return next(s for s in ("%.*g" % (n, x) for n in (15, 16, 17))
                if float(s) == x)


def nameless(words):
    return re.sub(rb"F:\d+", b"F", words)


for name, content in SAMPLES.items():
    if name in PACKED:
        continue
    changes = {
        "CR LF": content.replace(b"\n", b"\r\n"),
        "CR": content.replace(b"\n", b"\r"),
        "byte order mark": b"\xef\xbb\xbf" + content,
        "Ctrl-Z": content + b"\x1a",
        "blanks at ends of lines": content.replace(b"\n", b"  \n"),
    }
    if name in ("lines.txt", "names.csv"):
        changes["blank lines"] = content.replace(b"\n", b"\n\n")
        changes["wide cells"] = re.sub(rb"(?<=\n|,)(-?\d)", rb"   \1", content)
    if name == "mesh.stl":
        changes["capitals"] = content.upper()
        changes["no indentation"] = re.sub(rb"\n +", b"\n", content)
    if name == "names.csv":
        changes["capitals"] = content.replace(b"x,y,z", b"X,Y,Z")
        changes["quotes"] = re.sub(rb"([^,\n]+)", rb'"\1"', content)
    if name in ("node.node", "lines.txt"):
        changes["exponents"] = re.sub(rb" (-?\d+)(?=[ \n])", rb" \1.0D+00",
                                      content, 0)
        changes["exponents"] = changes["exponents"] if name != "node.node" \
            else content
    for what, other in changes.items():
        code, node, words = run(name, other)
        node = node.replace(b"X", b"x")
        good = code == 0 and points_of(node) == points_of(whole[name][1]) and \
            nameless(words) == nameless(whole[name][2])
        if not good:
            print("        ", code, words)
        test("%s: %s alter nothing" % (name, what), good)

# ---- -q: what is told of the data stays, all else goes ----

# (duplicates, which STL's corners are, are told by the summary without it)
for name, content in SAMPLES.items():
    code, node, words = run(name, content, "-q")
    words, doubled = re.subn(rb"tess: .*: 1 duplicates: .*\n", b"", words)
    test("%s: by -q the same is told of it" % name,
         (code, node, words) == whole[name] and
         doubled == name.endswith(".stl"))
twice = b"x,y,z,T\n" + b"".join(b"%d,%d,%d,%d\n" % (k, k * k % 5, k // 4, k) for
                                k in range(9)) + b"1,1,0,5\nNA,1,1,1\n9,9,-9999,3\n"
said = subprocess.run([TESS, "-q", "-skip", "-grid", "3,3,3", "-values", "q.csv",
                       "-"], input=twice, stdout=subprocess.PIPE,
                      stderr=subprocess.PIPE)
test("by -q duplicates, rows that are dropped, what stands for none are told",
     said.stdout == b"" and all(w in said.stderr for w in (
         b"1 duplicates", b"1 row dropped", b"z is -9999", b"mean of their")))

# ---- one meaning: under any name, through a pipe ----

endings = sorted({name[name.rfind("."):] for name in SAMPLES} - {".lammpstrj"})
for name, content in SAMPLES.items():
    results = [run("other" + e, content, like=name) for e in endings]
    # (PDB's last numbers, as those of PQR may be: by the name, and told)
    good = all(r[0] == 2 or r[1] == whole[name][1] or (
        (name, e) == ("atoms.pdb", ".pqr") and b"as the name's .pqr says" in r[2])
        for r, e in zip(results, endings))
    code, node, words = run(name, content, pipe=True)
    test("%s: the same under any name" % name, good)
    test("%s: the same through a pipe" % name,
         (code, node) == whole[name][:2])

# ---- what lies behind a count is no sample of what lies before it ----

for name in "counted.txt", "atoms.xyz", "more.xyz", "node.node", \
        "dump.lammpstrj":
    bad = []
    for junk in b"a b c d\n", b"1 2\n", b"x\n", b"; ; ;\n", b"-,-,-,-\n":
        code, node, words = run(name, SAMPLES[name] + 50 * junk)
        if (code, node) != whole[name][:2] or b": 50 lines" not in words:
            bad.append((junk, code, words))
    if bad:
        print("        ", bad[:3])
    test("%s: 50 lines behind the rows, of any kind, are left out" % name,
         not bad)

for name in sorted(PACKED - {"packed.stl"}):  # (its size is its count)
    code, node, words = run(name, SAMPLES[name] + bytes(200000))
    test("%s: 200,000 bytes behind the rows are left out" % name,
         (code, node) == whole[name][:2] and b": 200000 bytes" in words)

# ---- Ctrl-Z ends a file, where a block ends too: else it is of a cell ----

text = 10921 * b"1 2 3\n" + b"1 2  345\x1a\n"
assert len(text) == 65536
test("Ctrl-Z at a block's end: behind all, or in a cell", all(
    run("z.txt", text, pipe=pipe)[::2] == (0, b"") and
    run("z.txt", text + b"4 5 6\n", pipe=pipe)[2].startswith(
        b"tess: F:10922: column 3: ") for pipe in (False, True)))
text = 10921 * b"1 2 3\n" + b"# 345678\x1a\n"
test("Ctrl-Z at a block's end, in a comment: what follows is there", all(
    points_of(run("z.txt", text + b"4 5 6\n", pipe=pipe)[1])[-1:] == [
        (4, 5, 6)]
    for pipe in (False, True)))

# ---- UTF-16 without a mark: letters, and a NUL beside each ----

bad = []
for four in itertools.product("a\0\n", repeat=4):
    for n in range(2, 5):
        text = "".join(four)[:n]
        code, node, words = run("u.txt", text.encode() + b"\n" * (n == 4))
        wide = text in ("a\0a\0", "\0a\0a")
        if code != 2 or (b"is UTF-16" in words) != wide:
            bad.append((text, words))
if bad:
    print("        ", bad[:3])
test("UTF-16 without a mark, and what is nearly so", not bad)

# ---- order: a cell that is no number, in any row and column ----

cells = {"NA": 0, "nan": 0, "": 0, "*****": 0, "#N/A": 0, "<0.05": 2, "word": 2,
         "0x10": 2, "1_000": 2, "5 m": 2, "1.2.3": 2, "1e5e5": 2, "inf": 2,
         "\u22125": 2, "1\u00a0000": 2, "\"1,234.5\"": 2, "\"0,5\"": 2,
         "1.#INF": 2, "1.#QNAN": 0, "-": 0, "0-1.5": 2, "--5": 2}
table = [["%g" % x for x in p] + ["%g" % v] for p, v in zip(P, V)]
for cell, skipped in cells.items():
    jobs = []
    for column in range(4):
        for row in range(5):
            lines = [list(r) for r in table]
            lines[row][column] = cell
            text = ("x,y,z,T\n" + "".join(",".join(r) + "\n" for r in lines)
                    ).encode()
            jobs += [("o.csv", text), ("o.csv", text, "-skip")]
    results = many(jobs)
    plain, skip = results[::2], results[1::2]
    kept = 5 * (cell in ("nan", "1.#QNAN", "inf", "1.#INF"))  # values
    good = all(r[0] == 2 for r in plain[:15]) and all(
        r[0] == (0 if kept else 2) for r in plain[15:])
    # (the line is named, and so is the column)
    for k, r in enumerate(plain):
        if r[0] == 2:
            good = good and r[2].startswith(
                b"tess: F:%d: column %d, %c" % (k % 5 + 2, k // 5 + 1,
                                                b"xyzT"[k // 5]))
    test("%r: refused in each row and column alike, by line and name" % cell,
         good)
    test("%r: what -skip does is the same in each row and column" % cell,
         all(r[0] == skipped or (k >= 15 and kept) for k, r in enumerate(skip)))

# in any format: a word among the numbers of a row is refused there
def row_spans(name, content):
    """where each row's line begins and ends"""
    return [(content.rindex(b"\n", 0, m.start(1)) + 1 if
             b"\n" in content[:m.start(1)] else 0,
             content.index(b"\n", m.end()) + 1)
            for m in row_matches(name, content)]


for name, content in SAMPLES.items():
    if name in PACKED | ROWLESS:
        continue
    jobs, lines = [], []
    for m in row_matches(name, content):
        at, end = m.end(), content.index(b"\n", m.end())
        spans = [m.span(k) for k in (1, 2, 3)]
        if name in ("lines.txt", "more.xyz", "node.node", "mesh.ply",
                    "cloud.pcd"):
            spans.append((at + 1, end))
        for a, b in spans:
            jobs.append((name, content[:a] + b"word"[:b - a].ljust(b - a) +
                         content[b:]))
            lines.append(content.count(b"\n", 0, a) + 1)
    bad = [(r[2], n) for r, n in zip(many(jobs), lines) if r[0] != 2 or
           not re.match(rb"tess: F:%d: column \d" % n, r[2])]
    if name == "counted.txt":
        bad = bad[3:]  # (that looks like a comment behind the count)
    if bad:
        print("        ", bad[:3])
    test("%s: a word in a row is refused there" % name, not bad)

# the same texts among the numbers of options: refused, by option and text
numbered = {"-box": "0,4,0,4,-3,4", "-scale": "1,2,.5", "-alpha": "9",
            "-within": "2", "-view": "30 20", "-size": "200,300",
            "-range": "0,5", "-digits": "5", "-below": ".5",
            "-nodata": "-99,-98", "-outside": "7", "-step": "1,1,1",
            "-grid": "2,2,2,0,1,0,1,0,1"}
for option, numbers in numbered.items():
    between = " " if " " in numbers else ","
    parts, bad = numbers.split(between), []
    for cell in [*cells, "1e", "1 2", "1,5", "1e999", "5;", "0b1"]:
        if "," in cell and between == "," and len(parts) > 1:
            continue
        for k in range(len(parts) if cell in ("0x10", "nan", "1e") else 1):
            words = between.join([*parts[:k], "@", *parts[k + 1:]])
            words = [w.replace("@", cell) for w in words.split(" ")]
            grid = {"-step": ["-grid", "0,1,0,1,0,1"], "-grid": []}.get(
                option, ["-grid", "2,2,2"])
            code, node, words = run("names.csv", SAMPLES["names.csv"],
                                    "-values", "v.vtk", *grid, option, *words)
            if code != 2 or not words.startswith(
                    ('tess: %s: "%s": not ' % (option, cell)).encode()):
                bad.append((cell, words))
    if bad:
        print("        ", bad[:3])
    test("%s: no number is read that a file may not have" % option, not bad)
    code, node, words = run("names.csv", SAMPLES["names.csv"], "-values", "v.vtk",
                            *grid, option, ",".join(20 * ["1"]))
    test("%s: 20 numbers are too many" % option, code == 2 and words != b"")

# columns in any order, by their names
for order in "yxzT", "Tzyx", "zTxy":
    at = ["xyzT".index(c) for c in order]
    text = ",".join(order) + "\n" + "".join(
        ",".join(r[k] for k in at) + "\n" for r in table)
    code, node, words = run("o.csv", text.encode(), like="names.csv")
    test("columns %s: the same points and values" % order,
         (code, node) == whole["names.csv"][:2] and b"x, y, z are" in words)
for k in range(5):
    text = "x,y,z,T\n" + "".join(",".join(r) + "\n"
                                 for r in table[k:] + table[:k])
    code, node, words = run("o.csv", text.encode())
    test("rows from the %dth on: the same points" % k,
         code == 0 and points_of(node) == sorted(P) and words == b"")

# ---- numbers: those of a grammar, as Python reads them, and no others ----

NUMBER = re.compile(r"[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:[eEdDqQ][+-]?\d+)?|"
                    r"(?:\d+\.\d*|\.\d+)[+-]\d{3})$")
EXTREMES = ["1.7976931348623157e308", "-1.7976931348623157D+308", "5e-324",
            "2.2250738585072014e-308", "1.7976931348623157+308", "0.", ".0",
            "-0", "+.5", "0.1q-307", "1" + "0" * 300, "0." + "0" * 300 + "1",
            "9007199254740993", "1.5-001", "00012", "1e+0000000000001",
            "2." + 450 * "5", "-0", "-00.5", "0e0"]
# what is nearly FORTRAN's exponent of three digits, or C's hexadecimal number
NEARLY = ["1-101", "-7+001", "1.5-10", "1.5-1010", "1.5-101x", "1.5+101e2",
          "1.5e-101-101", "-0x10", "0X1p3", "00x1", "1.5--101"]


def python(text):
    """the number, by another reader"""
    text = re.sub(r"(?<=[\d.])([+-]\d{3})$", r"e\1", re.sub(
        "[dDqQ]", "e", text)) if not re.search("[eE]", text) else text
    return float(text)


def a_number(r):
    whole, part = ("".join(r.choice("0123456789")
                           for k in range(r.choice(some)))
                   for some in ((0, 1, 1, 2, 5, 17), (0, 0, 1, 2, 6, 17)))
    text = r.choice(["", "", "-", "+"]) + (whole or "0" * (not part))
    text += "." + part if part or r.random() < .2 else ""
    if r.random() < .4:
        text += r.choice("eEdDqQ") + r.choice(["", "+", "-"]) + \
            r.choice(["%d", "%02d", "%03d"]) % r.choice([0, 1, 5, 22, 99, 290])
    elif "." in text and r.random() < .2:
        text += r.choice("+-") + "%03d" % r.randrange(290)
    return text


chance = random.Random(7)
texts = EXTREMES + [a_number(chance) for k in range(4000 - len(EXTREMES))]
for what, between, form, options in (
        ("blanks", " ", "%s", ()), ("commas", ",", "%s", ()),
        ("commas, quotes", ",", '"%s"', ()), ("tabs", "\t", " %s ", ()),
        ("decimal commas", ";", "%s", ("-decimal", ",")),
        ("decimal commas, quotes", ",", '"%s"', ("-decimal", ","))):
    comma = "-decimal" in options
    cells = [re.sub(r"\.(?!\d)", "", s).replace(".", ",") if comma else s
             for s in texts]
    wanted = texts
    if comma:  # (without a digit behind it there is no sign, nor FORTRAN's
        # exponent; what is longer than 400 characters is refused)
        cells, wanted = zip(*((c, s) for c, s in zip(cells, texts) if NUMBER.match(
            c.replace(",", ".")) and len(c) < 400))
    lines = [between.join(["%d" % (k // m % 10) for m in (4, 40, 400)] +
                          [form % s for s in cells[k:k + 4]]) + "\n"
             for k in range(0, len(cells) - 3, 4)]
    code, node, words = run("n.txt", "".join(lines).encode(), *options)
    got = [float(x) for line in node.decode().splitlines()[1:]
           for x in line.split()[4:]]
    # (that the largest ones may stand for none)
    words = re.sub(rb"tess: .*: -nodata \S+\n", b"", words)
    want = [python(s) for s in wanted[:4 * len(lines)]]
    bad = [(c, a, b) for c, a, b in zip(cells, want, got) if a != b]
    if bad or code or words:
        print("        ", code, words[:300], bad[:5])
    test("%s: %d numbers, as Python has them" % (what, len(want)),
         code == 0 and words == b"" and len(got) == len(want) and not bad)

# one edit away: a number still, by the grammar, or refused, by line and column
NANS = "nan -nan +nan nan(ind) 1.#qnan -1.#ind".split()
jobs, model = [], []
for k in range(300 + len(NEARLY)):
    s = list(chance.choice(texts[12:]))
    i = chance.randrange(len(s) + 1)
    s[i:i + chance.randrange(2)] = chance.choice("0123456789+-.,eEdDxXnN_#*<(f")
    s = "".join(s) if k < 300 else NEARLY[k - 300]
    row = chance.randrange(5)
    lines = ["%g;%g;%g;%d" % (*p, v) for p, v in zip(P, V)]
    lines[row] = lines[row][:lines[row].rindex(";") + 1] + s
    jobs.append(("e.csv", ("x;y;z;T\n" + "\n".join(lines) + "\n").encode()))
    model.append((s, row))
bad = []
for (s, row), (code, node, words) in zip(model, many(jobs)):
    if NUMBER.match(s) and abs(python(s)) != float("inf"):
        values = [line.split()[4] for line in node.decode().splitlines()[1:]]
        good = code == 0 and float(values[row]) == python(s)
    elif NUMBER.match(s) or s.lower() in NANS:
        good = code == 0 and words != b""
    else:
        good = code == 2 and words.startswith(
            ('tess: F:%d: column 4, T: "%s' % (row + 2, s[:40])).encode())
    if not good:
        bad.append((s, code, words))
if bad:
    print("        ", bad[:5])
test("%d texts an edit from a number: numbers, or refused" % len(jobs), not bad)
long_ones = ["1" * 500 + "d0", "1" * 500 + ",5", '"1,' + "5" * 500 + '"']
test("numbers that are too long for FORTRAN's letters or a comma are refused",
     all(run("l.csv", ("1;2;3\n4;5;%s\n" % s).encode(), "-decimal", ",")[0] == 2
         for s in long_ones))

# ---- columns: what is told of them, in any order, named anywhere ----

table = [["%g" % x for x in p] + ["%g" % v, "%g" % (v * v)]
         for p, v in zip(P, V)]
for axes in "xyz", "xy":
    bad = []
    for order in itertools.permutations("xyzTu"):
        at = ["xyzTu".index(c) for c in order]
        text = ",".join(order) + "\n" + "".join(
            ",".join(r[k] for k in at) + "\n" for r in table)
        option = () if axes == "xyz" else (
            "-plane", "-grid", "2,2", "-values", "v.vtk")
        jobs = [("p.csv", text.encode(), *option)]
        code, node, words = run(*jobs[0])
        where = [order.index(c) for c in axes]
        usual = where == list(range(where[0], where[0] + len(axes)))
        said = "x, y%s are the columns %s (" % (
            ", z" * (axes == "xyz"), ", ".join("%d" % (k + 1) for k in where))
        if code or (b" are the columns" in words) == usual or (
                not usual and said.encode() not in words) or (
                axes == "xyz" and points_of(node) != sorted(P)):
            bad.append((order, words))
    if bad:
        print("        ", bad[:3])
    test("%s: which columns they are is told if they are not as usual" % axes,
         not bad)

# of two columns of one name the first one is the axis
bad = []
for order in "xyzxu", "xyzyu", "xyzzu", "xyzuX", "xyzYx", "xyzZZ":
    text = ",".join(order) + "\n" + "".join(",".join(r) + "\n" for r in table)
    code, node, words = run("t.csv", text.encode())
    twice = [k for k in range(5) if order.lower()[k] in order.lower()[:k]]
    if code or points_of(node) != sorted(P) or not any(
            ("column %d is called %s, too" % (k + 1, order[k])).encode() in words
            for k in twice):
        bad.append((order, words))
if bad:
    print("        ", bad[:3])
test("of two columns of one name the first one is the axis, and told", not bad)

# ---- names before places ----

# axes of one family, in any order among others, with units, marks, signs, in
# letters of any case; lines of names parted in any way; units in a second line;
# one name less, where the first column has the rows' names
FAMILIES = [("x", "y", "z"), ("easting", "northing", "elevation"),
            ("East", "North", "RL"), ("lon", "lat", "depth"),
            ("longitude", "latitude", "alt"), ("x", "y", "elev"),
            ("E", "N", "Z"), ("este", "norte", "cota")]
# what is called so is no axis
OTHERS = ["T", "from", "to", "au_ppm", "bottom depth", "x velocity", "Velocity[X]",
          "normal:0", "zone", "Latin", "eastern", "pH", "xy", "z-score", "units"]


def dressed(word):
    """the name, as people write it; and what it must be quoted for"""
    unit = chance.choice(["", "", " (m)", " [m]", "_m", " [ m ]", "(ft)"])
    if word in "xyz":
        mark = chance.choice(["", "", "", "coord", "coordinate", "utm", "mid",
                              "center", "Point"])
        sign = chance.choice(["-", "_", " ", ".", ""])
        word = chance.choice([mark + sign + word, word + sign + mark]) if mark \
            else word
    return chance.choice([str, str.upper, str.lower, str.title])(word) + unit


def table_of(names, columns, between):
    lines = [between.join("%g" % (c[k] if isinstance(c, list) else c)
                          for c in columns) for k in range(5)]
    return "".join(line + "\n" for line in lines)


numbers_ = [[p[k] for p in P] for k in range(3)]
bad, many_ = [], 0
for k in range(900):
    family = chance.choice(FAMILIES)
    others = chance.sample(OTHERS, chance.randrange(4))
    columns = list(zip([dressed(w) for w in family], numbers_)) + [
        (o, [7.5 + j * j for j in range(5)]) for o in others]
    # (of marks all have the same, or x, y, z may be taken from two tables)
    chance.shuffle(columns)
    names = [c[0] for c in columns]
    rows_between = chance.choice([" ", "\t", ",", ";", "|"])
    body = table_of(names, [c[1] for c in columns], rows_between)
    blanks = any(re.search(" ", n) for n in names)
    way = chance.choice([",", ", ", ";", "\t", "   ", " ", "rows"])
    if way == "rows":
        way = rows_between
    if way == " " and any(re.search(r" (?![(\[])|\[ ", n) for n in names):
        way = ","
    if way == "   " and any("  " in n for n in names):
        way = ","
    quoted = chance.random() < .2
    head = way.join('"%s"' % n if quoted else n for n in names)
    mark = chance.choice(["", "", "# ", "#", "% ", "! ", "//"])
    second = chance.random() < .2 and not mark
    units = way.join("m" if n != "T" else "K" for n in names) + "\n"
    fewer = not mark and not second and chance.random() < .2
    if fewer:
        body = "".join("%s%s%s\n" % (chance.choice(['"%d"', "%d", "r%d"][:2]) % (
            j * 7 % 10 + 1), rows_between, line) for j, line in enumerate(
                body.splitlines()))
    title = chance.choice(["", "", "# by hand\n"]) + chance.choice(
        ["", "", "survey\n"])
    text = title + mark + head + "\n" + units * second + body
    code, node, words = run("n.txt", text.encode())
    many_ += 1
    if code or points_of(node) != sorted(P) or (
            fewer and b"one name less" not in words) or (
            mark and b"names of columns, from a comment" not in words) or (
            family[0].lower() not in ("x",) and b" are the columns " not in words):
        bad.append((text, code, words))
if bad:
    print("".join("        %s\n" % (b,) for b in bad[:5]), end="")
test("axes by their names, of %d heads" % many_, not bad)

# names are there, but no three axes of one family, or more than one: read are
# three columns of numbers alone, and that is told; of more it is asked, with all
# columns, and -cols that answers it does
bad = []
for k in range(300):
    all_ = chance.choice(FAMILIES)
    family = list(all_)
    way = k % 3
    if way == 0:  # one is missing
        del family[chance.randrange(3)]
    elif way == 1:  # none
        family = []
    else:  # one more
        other = chance.choice([f for f in FAMILIES[1:5] if f[0] != family[0]])
        family += other if family[0] != "x" else ["from"] * 3
        if "from" in family:
            del family[chance.randrange(3)]
    names = family + chance.sample(OTHERS[:4], max(chance.randrange(3),
                                                   3 - len(family)))
    chance.shuffle(names)
    values = [[chance.randrange(50) / 8 for j in range(5)] for n in names]
    text = ", ".join(names) + "\n" + table_of(names, values, chance.choice(
        [",", " ", ";"]))
    by = chance.choice(names) if k % 5 == 0 else ""
    option = ("-by", by, "-validate", "2") if by and names.count(by) == 1 else ()
    code, node, words = run("n.txt", text.encode(), *option)
    left = len(names) - bool(option)
    if left == 3 and not option:
        # (those that are named are where they are)
        told = re.search(rb"x, y, z are the columns (\d, \d, \d) "
                         rb"\((.*?), (.*?), (.*?)\);", words)
        good = code == 0 and told is not None and (
            way != 1 or told[1] == b"1, 2, 3") and (way != 0 or all(
                told[j + 2].decode() == all_[j] for j in range(3)
                if all_[j] in names))
    else:
        good = code == 2 and (left < 4 or (all(
            b"column %d, %s: %g\n" % (j + 1, n.encode(), values[j][0]) in words
            for j, n in enumerate(names)) and
            b"which columns are x, y, z?" in words)) and node == b""
        answer = re.search(rb"as (-cols) (\d+,\d+,\d+)\n$", words)
        if good and answer:
            code, node, words = run("n.txt", text.encode(), "-cols",
                                    answer[2].decode())
            at = [int(n) - 1 for n in answer[2].split(b",")]
            good = code == 0 and points_of(node) == sorted(
                tuple(values[a][j] for a in at) for j in range(5))
        elif left > 3:
            good = False
    if not good:
        bad.append((way, text, option, code, words))
if bad:
    print("".join("        %s\n" % (b,) for b in bad[:5]), end="")
test("names that say not which are x, y, z: three numbers, or it is asked",
     not bad)

# ---- what numbers rows ----

bad = []
for k in range(200):
    first = chance.choice([0, 1, 1001, 77])
    ids = [first]
    while len(ids) < 9:
        ids.append(ids[-1] + (chance.choice([2, 3, 10]) if len(ids) % 4 == 3
                              else 1))
    points_ = [tuple(chance.randrange(99) / 4 for j in range(3)) for i in ids]
    between = chance.choice([" ", ",", ";", "\t"])
    before = chance.choice(["", "", "P", "node"])
    behind = chance.choice(["", "C"])
    value = chance.choice(["", "9.5"])
    way = k % 4
    if way == 1:  # twice, or not upwards: it is x
        ids[chance.randrange(1, 9)] = first
    elif way == 2:  # most steps are others
        ids = [first + 5 * j for j in range(9)]
    lines_ = [between.join(w for w in (
        before, str(i), behind, *("%g" % c for c in p), value) if w)
        for i, p in zip(ids, points_)]
    code, node, words = run("i.txt", ("\n".join(lines_) + "\n").encode())
    at = 1 + bool(before)
    want = sorted(points_) if way in (0, 3) else sorted(
        (i, *p[:2]) for i, p in zip(ids, points_))
    good = code == 0 and points_of(node) == want and (
        b"column %d (%d, %d, %d, ...) numbers the rows" % (at, *ids[:3])
        in words) == (way in (0, 3))
    x_too = re.search(rb"if that one is x: -cols (\S+)", words)
    if way in (0, 3) and good:
        code, node, words = run("i.txt", ("\n".join(lines_) + "\n").encode(),
                                "-cols", x_too[1].decode())
        good = code == 0 and points_of(node) == sorted(
            (i, *p[:2]) for i, p in zip(ids, points_))
    if not good:
        bad.append((way, lines_, code, words, want))
if bad:
    print("".join("        %s\n" % (b,) for b in bad[:3]), end="")
test("a column that numbers rows is no coordinate; -cols makes it one", not bad)

# ---- what is advised alters something ----

# numbers that stand for none, sides that differ, columns that number: of each
# option that is named with its argument the result is another one
bad, advised = [], {}
for k in range(600):
    side = [chance.choice([1, 10, 300, 7000, 1e6]) for j in range(3)]
    shift = [chance.choice([0, 0, 4e5, -600, 16]) for j in range(3)]
    rows_ = [[round(shift[j] + side[j] * chance.random(), 6) for j in range(3)] +
             [round(chance.random(), 3)] for i in range(12)]
    kind = chance.choice(["none", "end", "axis", "zeros", "values", "ids", "few"])
    mark = chance.choice([999, -9999, 1e30, -999.25, -99, 99999])
    where = chance.sample(range(12), 3)
    for i in where:
        if kind == "axis":
            rows_[i][k % 3] = mark
        if kind == "values":
            rows_[i][3] = mark
    if kind == "end":
        rows_ += [[mark] * 3 + [0.5]] * chance.randrange(1, 3)
    if kind == "zeros":
        rows_ += [[0, 0, 0, 0]] * chance.randrange(1, 4)
    if kind == "few":
        rows_ = rows_[:chance.randrange(2, 6)]
    if kind in ("ids", "few") and k % 2:
        rows_ = [[i + 1] + r for i, r in enumerate(rows_)]
    text = "".join(" ".join("%.15g" % x for x in r) + "\n" for r in rows_).encode()
    code, node, words = run("a.txt", text)
    for name, argument in re.findall(rb"(-scale|-nodata|-cols) ([-\d.,e+]+)\b",
                                     words):
        name, argument = name.decode(), argument.decode()
        if (name, argument) == ("-scale", "1,1,1"):
            continue  # (that leaves all as they are, as is said there)
        advised[name] = advised.get(name, 0) + 1
        code2, node2, words2 = run("a.txt", text, name, argument)
        if name == "-scale":
            good = any(float(x) != 1 for x in argument.split(","))
        else:
            good = node2 != node
        # (nor is the same said again)
        if code2 or not good or (name.encode() + b" " + argument.encode()) in \
                words2:
            bad.append((text, name, argument, code2, words2))
if bad:
    print("".join("        %s\n" % (b,) for b in bad[:3]), end="")
test("what is advised alters something: %s" % ", ".join(
    "%d times %s" % (n, o) for o, n in sorted(advised.items())),
    not bad and len(advised) == 3)

# in a comment, of any mark, first or behind others; or in no line that begins so
body = "".join(" ".join(r) + "\n" for r in table)
named = run("n.txt", ("T z u x y\n" + body).encode(), like="names.csv")
for mark in "# ", "#", "% ", "! ", "// ", "//", "#\t":
    for before in "", "# by hand\n", "! 1 2\n":
        code, node, words = run("n.txt", (
            before + mark + "T z u x y\n" + body).encode(), like="names.csv")
        test("names behind %r%s: those of a line" % (mark, before and
                                                     ", behind another comment"),
             (code, node) == named[:2] and
             b"names of columns, from a comment" in words)
code, node, words = run("n.txt", ("# to be done\n" + body).encode())
test("a comment that has no names names nothing",
     code == 0 and words == b"" and points_of(node) == sorted(P))

# of many columns one is no number in a row: how to leave it out is said
wide = ["x,y,z," + ",".join("c%d" % k for k in range(37))] + [
    ",".join(r[:3] + ["%d" % (7 * k) for k in range(37)]) for r in table]
wide[3] = wide[3].replace(",49,", ",NA,")
wide = "\n".join(wide + [""]).encode()
code, node, words = run("w.csv", wide, "-cols", "x,y,z")
test("-cols X,Y,Z: a cell of another column is refused, and the way out said",
     code == 2 and b":4: column 11, c7: " in words and
     b"-cols X,Y,Z,VALUE" in words)
code, node, words = run("w.csv", wide, "-cols", "x,y,z,c9")
test("-cols X,Y,Z,VALUE: other columns do not matter",
     code == 0 and words == b"" and points_of(node) == sorted(P))

# named nearly as a file of another format begins: it is none
source = open(os.path.join(os.path.dirname(os.path.abspath(__file__)),
                           "..", "src", "read", "formats.c")).read()
begins = [re.sub(r"\\\\(.)", r"\1", m) for m in re.findall(
    r'NOT_READ\("[^"]*", -?\w+,\s*"((?:[ !$&(-?A-Z^-}]|\\\\.)+)', source)]
bad = []
for word in begins:
    for title in word[:-1], word[:-1] + "_", "_" + word:
        if re.search("[,;|\"{[]|^[#!%/]|^$|^-?\\d", title) or len(title) < 2:
            continue
        text = title + ",x,y,z\n" + "".join(
            "%s,%s\n" % (r[3], ",".join(r[:3])) for r in table)
        code, node, words = run("f.csv", text.encode())
        if code or points_of(node) != sorted(P):
            bad.append((title, words))
if bad:
    print("        ", bad[:5])
test("%d columns named nearly as other formats begin" % len(begins),
     not bad and len(begins) > 30)

# behind a head of any length, of lines that are nearly like rows
bad = []
for line in "depth 5", "north:\t7.5 m", "5", "from 1 to 2", "a;b;c", "n,5":
    for n in 1, 2, 3, 5, 8, 13, 40:
        for between in " ", ",", ";", "\t":
            head = ["%s" % line] * n
            rows_ = [between.join(["A"] * (between == ",") + r) for r in table]
            code, node, words = run("h.txt", "\n".join(
                ["survey"] + head + rows_ + [""]).encode())
            if code == 2 and (line[0] in "5n" or (line[0] == "f" and n > 8)):
                continue  # (numbers may be rows)
            if (line, n) == ("5", 1) and code == 0 and words == b"":
                continue  # (it is their number)
            if code == 2 and line == "a;b;c" and between == ";" and \
                    b"not as many as columns" in words:
                continue  # (names of three columns of five)
            if code or points_of(node) != sorted(P) or (
                    sum(map(int, re.findall(rb"left out: (\d+) line", words))) !=
                    n + 1):
                bad.append((line, n, between, code, words))
if bad:
    print("        ", len(bad), bad[:6])
test("rows behind a head, of lines nearly like them", not bad)

# words where an axis is named, and a word whose quote is open
bad = []
for k in range(3):
    rows_ = [["a" if i == k else x for i, x in enumerate(r[:4])] for r in table]
    text = "x,y,z,T\n" + "".join(",".join(r) + "\n" for r in rows_)
    for option in (), ("-skip",), ("-by", "T", "-validate", "2"):
        code, node, words = run("w.csv", text.encode(), *option)
        if code != 2 or (b'F:2: column %d, %c: "a": not a number' % (
                k + 1, b"xyz"[k])) not in words:
            bad.append((k, option, code, words))
for row in range(5):
    text = "x,y,z,T,n\n" + "".join(",".join(r[:4]) + ',"a b%s\n' % (
        '"' * (i != row)) for i, r in enumerate(table))
    for option in (), ("-skip",), ("-by", "n", "-validate", "2"):
        code, node, words = run("q.csv", text.encode(), *option)
        if code != 2 or not words.startswith(b"tess: F:%d: column 5" % (row + 2)):
            bad.append((row, option, code, words))
if bad:
    print("        ", bad[:3])
test("words in an axis, and words whose quote is open, are refused", not bad)

# groups by words: as many folds as words, in their order; their texts come back
labels = ["b", 'a"1', "a#2", '"q ""1"""', "10", "9", "a b", "é"]
rows_ = ["%d,%d,%d,%d,%s" % (k % 5, k * k % 7, k // 3, k, labels[k * 5 % 8])
         for k in range(40)]
bad = []
for turn in 0, 1, 13:
    text = "x,y,z,T,g\n" + "\n".join(rows_[turn:] + rows_[:turn]) + "\n"
    errors = os.path.join("errors%d.csv" % turn)
    code, node, words = run("g.csv", text.encode(), "-by", "g", "-validate",
                            "8", "-errors", errors)
    made = list(csv.reader(open(errors, encoding="utf-8")))
    read = list(csv.reader(text.splitlines()))
    fold, group = made[0].index("fold"), made[0].index("g")
    if code or [r[group] for r in made] != [r[4] for r in read] or \
            len({(r[fold], r[group]) for r in made[1:]}) != 8 or \
            {r[fold] for r in made[1:]} != set("12345678"):
        bad.append((turn, words, made[:4]))
if bad:
    print("        ", bad)
test("-by: a fold for each word, in whatever order",
     not bad)

# columns of places that are words, or not asked for, come back as they are
chance = random.Random(11)
with open("points.txt", "wb") as f:
    f.write(SAMPLES["lines.txt"])
bad = []
for k in range(60):
    between, quotes = ",;\t|"[k % 4], chance.choice([
        csv.QUOTE_MINIMAL, csv.QUOTE_ALL, csv.QUOTE_NONNUMERIC])
    table_ = [["x", "y", "z"] + ["n" + "".join(chance.choice('a ",;|#é')
                                               for j in range(n)) + "."
                                 for n in (1, 3, 9)]]
    for row in range(5):
        table_.append([.25, .25, row] + ["w" + "".join(
            chance.choice('a1 ",;|#é.-') for j in range(chance.randrange(9))
            ) + "." for n in range(2)] + [row * 1.5])
    with open("back.csv", "w", newline="", encoding="utf-8") as f:
        csv.writer(f, delimiter=between, quoting=quotes,
                   lineterminator="\n").writerows(table_)
    out = subprocess.run(
        [TESS, "-q", "-outside", "nearest", "-query", "back.csv", "-qcols",
         "1,2,3", "-values", "-", "points.txt"], stdout=subprocess.PIPE,
        stderr=subprocess.PIPE)
    made = list(csv.reader(out.stdout.decode().splitlines()))
    if [r[3:6] for r in made] != [[str(c) for c in r[3:]] for r in table_]:
        bad.append((table_, made, out.stderr))
if bad:
    print("        ", bad[:2])
test("columns of places come back as Python wrote them", not bad)
with open("back.npy", "wb") as f:
    f.write(SAMPLES["array.npy"])
out = subprocess.run([TESS, "-q", "-query", "back.npy", "-qcols", "1,2,3",
                      "-values", "-", "points.txt"], stdout=subprocess.PIPE)
made = list(csv.reader(out.stdout.decode().splitlines()))
test("a column of an array that is no coordinate comes back",
     [r[3] for r in made] == ["column4"] + [shortest(v) for v in V])

# ---- numbers in what is written have as few digits as give them back ----

r = random.Random(7)
with open("short.csv", "w") as f:
    f.write("x,y,z,T,u\n")
    for k in range(60):
        f.write("%r,%.3f,%r,%r,%r\n" % (
            r.random(), r.random(), r.random() / 3, r.gauss(0, 1),
            float("%.2e" % r.gauss(0, 1e-200))))
for options in (
        ["-node", "s.node"], ["-mesh", "s.msh"], ["-face", "s.obj"],
        ["-face", "s.off"], ["-face", "s.ply"], ["-face", "s.stl"],
        ["-volumes", "s.csv"], ["-faces", "s.csv"],
        ["-validate", "5", "-errors", "s.csv"],
        ["-grid", "3,4,5", "-values", "s.csv"],
        ["-grid", "3,4,5", "-values", "s.vtk"],
        ["-query", "short.csv", "-values", "s.csv"]):
    subprocess.run([TESS, "-q"] + options + ["short.csv"], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(options[-1], "rb") as f:
        text = f.read()
    if options[-1] == "s.vtk":
        text = text[text.index(b"ORIGIN"):text.index(b"POINT_DATA")]
    words = [w for w in re.split(r"[\s,]+", text.decode().replace(" 1.0\n", ""))
             if re.fullmatch(r"-?[\d.]+(e[-+]\d+)?", w)]
    long = [w for w in words if w != str(shortest(float(w))) and "." in w]
    if long:
        print("        ", long[:5])
    test("%s: numbers are as short as give them back" % " ".join(options[-2:]),
         not long and len(words) > 5)

rows_ = [(k % 5, k * k % 7, k // 3, k, k * 5 % 8 / 4 - 1) for k in range(40)]
with open("groups.npy", "wb") as f:
    head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (40, 5), }"
    f.write(b"\x93NUMPY\1\0" + struct.pack("<H", 118) + head.ljust(117) + b"\n")
    f.write(b"".join(struct.pack("<5d", *r) for r in rows_))
subprocess.run([TESS, "-q", "-by", "5", "-validate", "8", "-errors",
                "groups.csv", "groups.npy"])
with open("groups.csv") as f:
    made = list(csv.DictReader(f))
test("-by a column of an array: a fold for each number",
     len({(r["fold"], r["column5"]) for r in made}) == 8 and
     [float(r["column5"]) for r in made] == [r[4] for r in rows_])

# ---- fewer rows: the same format, and all that there are ----

for name, content in SAMPLES.items():
    if name in PACKED | ROWLESS or name in ("mesh.stl", "dump.lammpstrj",
                                            "more.xyz"):
        continue
    starts = row_spans(name, content)
    bad = []
    for n in 1, 2, 3, 4:
        less = content[:starts[n][0]] + content[starts[4][1]:]
        if name == "ids.txt" and n < 4:
            continue  # (too few to see that they are numbered)
        for where in re.findall(rb"(?m)^5\b|vertex 5\b|WIDTH 5\b|POINTS 5\b|"
                                rb"nvalues = 5",
                                content[:starts[0][0]]):
            less = less.replace(where, where.replace(b"5", b"%d" % n), 1)
        for other in (name, "other.txt") if name != "atoms.xyz" else (name,):
            code, node, words = run(other, less, like="lines.txt")
            if code or points_of(node) != sorted(P[:n]):
                bad.append((n, other, words))
        code, node, words = run(name, less, pipe=True, like="lines.txt")
        if code or points_of(node) != sorted(P[:n]):
            bad.append((n, "pipe", words))
    if bad:
        print("        ", bad[:3])
    test("%s: 1 to 4 rows, by any name" % name, not bad)

# ---- one box that repeats itself, as each format writes it ----

# the sides along x, in the plane of x, y, and above it: all formats can say that
bad = []
inside = [(.5, .25, .5), (3, 1, 1), (2, 4, 2.5), (1, 3, 4), (4, 2, 3.25)]
for xy, xz, yz in (0, 0, 0), (1, 0, 0), (0, -2, 0), (0, 0, 1.5), (-1, 2, -1.5):
    a, b, c = (5, 0, 0), (xy, 6, 0), (xz, yz, 7)
    side = [math.sqrt(sum(x * x for x in v)) for v in (a, b, c)]
    angle = [math.degrees(math.acos(sum(x * y for x, y in zip(u, v)) / m / n))
             for u, v, m, n in ((b, c, *side[1:]), (a, c, side[0], side[2]),
                                (a, b, *side[:2]))]
    lines = "".join("%g %g %g\n" % p for p in inside)
    pdb = "CRYST1" + "%9.5f" * 3 % tuple(side) + "%7.3f" * 3 % tuple(angle)
    pdb += " P 1           1\n" + "".join(
        "ATOM  %5d  C   LYS A%4d    %8.3f%8.3f%8.3f\n" % (k, k, *p)
        for k, p in enumerate(inside))
    dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\nITEM: BOX BOUNDS "
    dump += "xy xz yz pp pp pp\n%g %g %g\n%g %g %g\n0 7 %g\n" % (
        min(0, xy, xz, xy + xz), 5 + max(0, xy, xz, xy + xz), xy, min(0, yz),
        6 + max(0, yz), xz, yz) + "ITEM: ATOMS x y z\n"
    lattice = 'Lattice="%s"' % " ".join("%g" % x for v in (a, b, c) for x in v)
    boxes = {"b.xyz": "5\n%s Properties=pos:R:3\n%s" % (lattice, lines),
             "b.pdb": pdb, "b.dump": dump + lines}
    if (xy, xz, yz) == (0, 0, 0):
        boxes["b.txt"] = lines
    volumes, said = {}, {}
    for name, content in boxes.items():
        code, node, words = run(
            name, content.encode(), "-periodic", "-volumes", "v.csv",
            *(("-box", "0,5,0,6,0,7") if name == "b.txt" else ()))
        with open("v.csv") as f:
            said[name] = words
            volumes[name] = [[float(r[k]) for k in ("volume", "area")]
                             for r in csv.DictReader(f)]
    near = 3e-5 if any((xy, xz, yz)) else 1e-12  # (digits of CRYST1)
    for name, got in volumes.items():
        if said[name] or len(got) != 5 or any(
                abs(x - y) > near * y for r, s in zip(got, volumes["b.xyz"])
                for x, y in zip(r, s)) or \
                abs(sum(r[0] for r in got) - 210) > 210 * near:
            bad.append((xy, xz, yz, name, said, got, volumes["b.xyz"]))
if bad:
    print("        ", bad[:2])
test("a box, upright or leaning: cells are the same in all formats", not bad)

# ---- a surface, in all that formats say about faces ----

corners = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2)]
faces = [(0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3)]
lines = "".join("%g %g %g\n" % p for p in corners)
surfaces = {
    "s.off": "OFF\n4 4 6\n" + lines + "".join("3 %d %d %d\n" % f
                                               for f in faces),
    "s.obj": "".join("v " + s + "\n" for s in lines.splitlines()) + "".join(
        s % tuple(k + 1 for k in f) for s, f in zip(
            ("f %d %d %d\n", "f %d/1 %d/2 %d/3\n", "f %d//1 %d//1 %d//1\n",
             "f %d/1/1 %d/2/1 %d/3/1\n"), faces)),
    "back.obj": "".join("v " + s + "\n" for s in lines.splitlines()) + "".join(
        "f %d %d %d\n" % tuple(k - 4 for k in f) for f in faces),
    "s.stl": "solid\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(
            "vertex %g %g %g\n" % corners[k] for k in f) +
        "endloop\nendfacet\n" for f in faces) + "endsolid\n"}
codes = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i",
         "uint": "I", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
         "int32": "i", "uint32": "I", "float": "f", "double": "d"}
whole_types = [t for t in codes if t not in ("float", "double")]
for k, (count, index) in enumerate(zip(whole_types, whole_types[5:] +
                                       whole_types[:5])):
    for form in "ascii", "binary_little_endian", "binary_big_endian":
        order = ">" if "big" in form else "<"
        packed_ = form != "ascii"
        extra = [("before", [("uchar", "float")[k % 2], "quality"]),
                 ("between", None), ("behind", ["short", "flag"])][k % 3]
        head = "ply\nformat %s 1.0\nelement vertex 4\n" % form + "".join(
            "property double %s\n" % c for c in "xyz")
        other = "element edge 2\nproperty int vertex1\nproperty list uchar " \
            "short more\n"
        listed = "property list %s %s vertex_ind%s\n" % (
            count, index, ("ices", "ex")[k % 2])
        one = "property %s %s\n" % tuple(extra[1]) if extra[1] else ""
        face = "element face 4\n" + (one if extra[0] == "before" else "") + \
            listed + (one if extra[0] == "behind" else "")
        head += other * (k % 4 == 1) + face + other * (k % 4 == 2)

        def put(kind, x):
            return struct.pack(order + codes[kind], x) if packed_ else \
                b"%d " % x

        end = b"" if packed_ else b"\n"
        edges = b"".join(put("int", e) + put("uchar", 2) + put("short", e) +
                         put("short", 1) + end for e in (0, 2))
        data = b"".join(b"".join(
            struct.pack(order + "d", x) if packed_ else b"%g " % x
            for x in p) + end for p in corners)
        data += edges * (k % 4 == 1)
        for f in faces:
            more = put(extra[1][0], 7) if extra[1] else b""
            data += (more if extra[0] == "before" else b"") + put(count, 3) + \
                b"".join(put(index, i) for i in f) + (
                    more if extra[0] == "behind" else b"") + end
        data += edges * (k % 4 == 2)
        surfaces["%s-%s-%s.ply" % (count, index, form)] = \
            (head + "end_header\n").encode() + data
surfaces["packed.stl"] = bytes(80) + struct.pack("<I", 4) + b"".join(
    struct.pack("<12fH", 0, 0, 0, *(x for k in f for x in corners[k]), 0)
    for f in faces)
bad = []
for name, content in surfaces.items():
    for lost in False, True:  # a corner that is another point: not closed
        content = content if isinstance(content, bytes) else content.encode()
        if lost:
            at = -3 if name == "packed.stl" else {
                "s.off": -2, "s.obj": -6, "back.obj": -2, "s.stl": 0}.get(name)
            if not at:
                continue
            content = content[:at] + b"\1" + content[at + 1:] \
                if name == "packed.stl" else content[:at] + (
                    b"2" if content[at:at + 1] != b"2" else b"1") + \
                content[at + 1:]
        with open(name, "wb") as f:
            f.write(content)
        said = subprocess.run([TESS, "-volumes", "v.csv", name],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT
                              ).stdout.decode()
        if lost == ("surface       4 triangles; closed; its volume is 0.5\n" in
                    said):
            bad.append((name, lost, said))
if bad:
    print("        ", bad[:3])
test("a surface: its triangles in %d files" % len(surfaces), not bad)
with open("hole.off", "w") as f:
    f.write("OFF\n5 4 6\n7 7 -99\n%s" % lines + "".join(
        "3 %d %d %d\n" % tuple(k + 1 for k in face) for face in faces))
said = [subprocess.run([TESS, "-volumes", "v.csv", *option, "hole.off"],
                       stdout=subprocess.PIPE,
                       stderr=subprocess.PIPE).stdout.decode()
        for option in ((), ("-nodata", "-99"))]
test("a surface: none where points are dropped",
     "closed; its volume is 0.5\n" in said[0] and "surface" not in said[1] and
     "points        4\n" in said[1])

# ---- counts: each number of each head ----

heads = {"counted.txt": rb"^(5)", "atoms.xyz": rb"^(5)", "node.node": rb"^(5)",
         "mesh.off": rb"\n(5) ", "mesh.ply": rb"vertex (5)",
         "packed.ply": rb"vertex (5)", "cloud.pcd": rb"POINTS (5)",
         "packed.pcd": rb"POINTS (5)", "array.npy": rb"\((5),",
         "dump.lammpstrj": rb"ATOMS\n(5)", "turned.txt": rb"\n(5)\n",
         "restart.rst7": rb" (5)\n", "cast.cnv": rb"nvalues = (5)",
         "geoeas.dat": rb"\n(4)\n"}
for name, where in heads.items():
    m = re.search(where, SAMPLES[name])
    for n in (b"0", b"4", b"6", b"1e12", b"1000000000000", b"nan", b"-5",
              b"2147483648", b"9007199254740993", b"99999999999999999999",
              b"", b"5x", b"0x5"):
        for pipe in (False, True) if n != m[1] else ():
            code, node, words = run(name, SAMPLES[name][:m.start(1)] + n +
                                    SAMPLES[name][m.end(1):], pipe=pipe)
            room = re.search(rb"has room for (\d+) at most", words)
            if n == b"1000000000000" and not pipe and ".pcd" not in name and \
                    ".npy" not in name and name != "geoeas.dat" and not (
                        room and int(room[1]) <= len(SAMPLES[name]) // 3):
                print("        ", words)
                test("%s: how many there may be is said" % name, False)
            if code == 2 or words != whole[name][2] or (n == b"" and
                    points_of(node) == points_of(whole[name][1])):
                continue
            print("        ", code, words)
            test("%s: a count %r is refused, or told" % (name, n), False)
    test("%s: wrong counts are refused, or told" % name, True)
