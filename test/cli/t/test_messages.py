"""test_messages.py - what build/tess says of the files that it reads, word for
word.

Of bad cells in tables with all separators, and in all formats, the message is
that of a model; all others are in messages.txt.  A text of the readers' sources
that has not been said, when all these tests have run, is a failure.
"""
import itertools
import os
import random
import re
import struct

import pytest

from common import READERS, Reader
from samples import SAMPLES, row_matches

HERE = os.path.dirname(os.path.abspath(__file__))


@pytest.fixture(scope="module")
def read(read, tmp_path_factory):
    """the same, which hears these tests alone"""
    folder = tmp_path_factory.getbasetemp() / "messages"
    folder.mkdir()
    return Reader(read.program, folder)


def says(read, name, content, wanted, *options):
    """wanted: the lines that must be said, the one with ! by exit status 2"""
    failed = bool(wanted) and wanted[-1][:2] == "! "
    done = read(name, content, *options)
    assert (done.code, done.words) == (2 if failed else 0, "".join(
        "tess: %s\n" % w[2 * (w[:2] == "! "):] for w in wanted)), (
            content[:400], options)


def all_say(read, jobs):
    """jobs: (name, content, *options), and what is wanted"""
    list(read.pool.map(lambda job: says(read, *job[0][:2], job[1], *job[0][2:]),
                       jobs))


# ---- cells: what they are, and what helps ----

SKIP = " (-skip drops such lines)"
STARS = " (a number that did not fit FORTRAN's field; -skip drops such lines)"
LIMIT = " (a limit; -below 0.5 reads half of it)"
ABOVE = " (a limit; -below 0.5 reads it as it is)"
COMMA = " (a decimal comma?  -decimal , reads it)"
THOUSAND = " (a comma between thousands must go; see also -decimal)"
THOUSANDS = " (commas between thousands must go)"
MINUS = " (the sign is U+2212: it must be -)"
GAPS = " (the blanks between digits must go)"
ONE = " (one separator in a file)"
TOUCH = " (two numbers that touch)"
GROUPS = " (points between thousands must go; see also -decimal)"
POINTS = " (with -decimal , numbers have no points)"
MANY = " (with -decimal , commas between digits are decimal)"
UNIT = " (a unit?  It must go)"
TWO = " (two numbers in one cell: one separator in a file)"
GLUED = " (a comment begins behind a blank)"
QUOTE = " (a quote that does not end with the cell, or not in the line)"

# of any decimal sign, and of each: kind, remedy, texts; @: not in quotes
CELLS = {
    "any": [
        ("EMPTY", SKIP, [""]),
        ("ABSENT", SKIP, "NA N/A #N/A #NA <NA> n/a null none None - -- . ? "
         "#VALUE! #REF! #DIV/0! #NUM! #NAME? #NULL!".split() + ["#N/A N/A"]),
        ("NAN", SKIP, "nan NaN -nan +nan nan(ind) -nan(ind) nan(snan) "
         "1.#QNAN -1.#QNAN 1.#IND -1.#IND 1.#SNAN".split()),
        ("STARS", STARS, ["*", "*****"]),
        ("INFINITE", "", "inf +inf -Inf infinity +infinity -infinity 1.#INF "
         "-1.#INF".split()),
        ("HUGE", "", ["1e999", "-2d400"]),
        ("TINY", "", ["1e-400", "-2d-400"]),
        ("BELOW", LIMIT, ["<5", "< 5", "<1e-3"]),
        ("ABOVE", ABOVE, [">100", "> 7"]),
        ("VOID", "", ["-41", "-41e0"]),
        ("NEAR", MINUS, ["\u22125", "\u22127e3"]),
        ("NEAR", GAPS, ["1\u00a0000", "12\u202f345", "-1\u2009000"]),
        ("NEAR", ONE, ["5,", "-7,", "5;"]),
        ("WORD", UNIT, ["5 m", "-12 kg/m3", "7 m 5"]),
        ("WORD", TWO, ["1 2", "-1 -2", "1  2 m"]),
        ("WORD", GLUED, ["5#x", "-5#"]),
        ("QUOTE", QUOTE, ['@"5"x', '@"5"6', '@"NA"NA']),
        ("WORD", "", "word 0x10 1_000 1e5e5 --5 5m 5% 1e 1e+ 2024-01-31 1-2 "
         "10:30 -/5 <x <> < <5x 5- NAN2 infinit e5 +- **5 5* \u2212 "
         "\u2212x x5".split() + ["5 ~7",
             "1\u00a0x", "\u00a05", "word of words", ",", ";", "-,",
             "so long a text that not all of it is shown"])],
    ".": [
        ("BELOW", LIMIT, ["<0.05"]),
        ("NEAR", COMMA, "0,84 ,5 -,5 ,123 -0,84 +12,5 1,5e-3 1234,567 0,123 "
         "12,34 12345,678 @1,234 @-1,234".split()),
        ("NEAR", GROUPS, ["1.234,5", "-12.345,25"]),
        ("NEAR", THOUSANDS, "1,234.5 12,345,678 -1,234,567.25".split()),
        ("NEAR", MINUS, ["\u22120.5"]),
        ("NEAR", GAPS, ["1\u00a0000.5"]),
        ("NEAR", ONE, ["1.,"]),
        ("NEAR", TOUCH, ["0-1.5", "1.5-2.25", "3+0.5", "1.5-.5"]),
        ("WORD", UNIT, ["5.5 m"]),
        ("WORD", GLUED, ["1.#INF0"]),
        ("WORD", "", "1.2.3 1,2,3 1,5m 0,5x 1.5-2 1.5-2.5x 1,2e3.5 "
         "0,000,000 0-1.5-2 1.5-2.5% 1,5e3x".split())],
    ",": [
        ("BELOW", LIMIT, ["<0,05"]),
        ("NEAR", POINTS, "0.84 -2.5 1.234,5 1.234.567 1.5e3".split()),
        ("NEAR", MANY, ["1,2,3", "-1,2,3,4"]),
        ("NEAR", MINUS, ["\u22120,5"]),
        ("NEAR", TOUCH, ["0-1,5", "1,5-2,25"]),
        ("WORD", UNIT, ["5,5 m"]),
        ("WORD", "", "1.2.3 <0.05 1.2. 0.1.2".split())],
}
IN_QUOTES = [("NEAR", THOUSAND, ["1,234", "-12,345"])]

# what separates, the decimal sign, are all cells in quotes?
DIALECTS = [(s, d, q) for s in (";", "\t", " ", "|") for d in ".,"
            for q in (False, True)] + [
    (",", ".", False), (",", ".", True), (",", ",", True), (", ", ",", False)]
KINDS = {"EMPTY": "empty", "INFINITE": "not finite", "HUGE": "not finite"}


def cells_of(separator, decimal, quoted):
    """(text, kind, remedy) of all texts that a cell may have there"""
    for kind, remedy, texts in CELLS["any"] + CELLS[decimal] + (
            IN_QUOTES if quoted and decimal == "." else []):
        for text in texts:
            if not quoted and (
                    re.search(r",(?!\d)", text) if separator == ", " else
                    separator in text or (separator == " " and not text)):
                continue
            # (between blanks, such commas may separate as well)
            if not ((quoted and text[:1] == "@") or (
                    separator == " " and re.search(
                        ",.*,|,$" if quoted else ",.*,", text))):
                yield text.lstrip("@"), kind, remedy


def written(text, quoted):
    return '"%s"' % text if quoted else text


def cell_message(line, column, name, cell, alike=(), values=False,
                 coordinate=True):
    """of a bad one; alike: the lines of those that are so, too"""
    text, kind, remedy = cell
    if kind in ("BELOW", "ABOVE") and coordinate:
        remedy = " (a limit)"
    text = text.encode()[text[:1] == '"':][:40].decode()  # (without the quote)
    return "! F:%d: column %d%s: %s%s%s%s%s" % (
        line, column + 1, name and ", " + name,
        '"%s": ' % text if text else "",
        KINDS.get(kind, "not a number"),
        "; so %s %d more, to line %d" % ("are" if len(alike) > 1 else "is",
                                         len(alike), alike[-1])
        if alike else "", remedy,
        "; -cols X,Y,Z,VALUE reads no other values" if values else "")


def several(many, what):
    return "%d %s%s" % (many, what, "s" * (many > 1))


def are(many):
    return "are" if many > 1 else "is"


def rows_message(rows, use, names, options):
    """What is said of rows, their lines and cells, of which those columns are
    x, y, z, values."""
    tally, first, drops = {}, {}, {}

    def bad(column, like, values=False):
        return [cell_message(
            line, column, names[column], cells[column],
            [r[0] for r in rows[at + 1:] if r[1][column][1] in like], values,
            column in use[:3])]

    dropping = ("EMPTY", "ABSENT", "NAN", "STARS") * ("-skip" in options) + \
        ("VOID",) * ("-nodata" in options)
    for at, (line, cells) in enumerate(rows):
        for column, cell in enumerate(cells):
            if cell[1] == "QUOTE":
                return bad(column, {"QUOTE"},
                           column in use[3:] and len(use) > 4)
        drop = [k for k in (cells[c][1] for c in use) if k in dropping]
        if drop:
            drops.setdefault("line", line)
            kind = "ABSENT" if drop[0] == "NAN" else drop[0]
            drops[kind] = drops.get(kind, 0) + 1
            continue
        for i, column in enumerate(use):
            kind = cells[column][1]
            if kind == "NUMBER":
                continue
            kept = {"TINY": "TINY", "VOID": "NUMBER"}
            if i > 2:
                kept.update(NAN="NAN", INFINITE="INFINITE", HUGE="INFINITE")
                if "-below" in options:
                    kept.update(BELOW="BELOW", ABOVE="ABOVE")
            if kind in kept:
                first.setdefault(kept[kind], line)
                tally[kept[kind]] = tally.get(kept[kind], 0) + 1
                continue
            for like in {"BELOW", "ABOVE"}, {"HUGE", "INFINITE"}, \
                    {"NAN", "ABSENT"} if i < 3 else {kind}, {kind}:
                if kind in like:
                    return bad(column, like, i > 2 and len(use) > 4)
    said = []
    if drops:
        many = [(drops.pop(kind), what) for kind, what in (
            ("EMPTY", "empty"), ("ABSENT", "NA or NaN"),
            ("STARS", "of asterisks"), ("VOID", "by -nodata")) if kind in drops]
        total = sum(n for n, what in many)
        said.append("F: %d row%s dropped (%s), the first in line %d%s" % (
            total, "s" * (total > 1), ", ".join("%d %s" % m for m in many),
            drops["line"], "; fewer if -cols X,Y,Z,VALUE asks for one "
            "column's values" if len(use) > 4 else ""))
    if "-nodata" in options and not any("-nodata" in s for s in said):
        said.append("F: -nodata: nothing is such a number")
    for kind, what, then in (("NAN", "NaN", SKIP[:-6] + "rows)"),
                             ("INFINITE", "infinite", "")):
        if kind in tally:
            said.append("F:%d: %s %s%s%s" % (
                first[kind], "a value is" if tally[kind] == 1 else
                "%d values are" % tally[kind], what,
                ", the first in this line" * (tally[kind] > 1), then))
    for kind, what, read_as in (("BELOW", "below", "0.5 times the limit"),
                                ("ABOVE", "above", "the limit")):
        if kind in tally:
            said.append("F: -below: %s %s a limit %s read as %s" % (
                several(tally[kind], "value"), what, are(tally[kind]), read_as))
    if "TINY" in tally:
        said.append("F: %s other than 0 %s too small for a double, and read as "
                    "0" % (several(tally["TINY"], "number"), are(tally["TINY"])))
    return said


NAMES = [("x", "y", "z", "T", "u"), ("x", "y", "z", "T (C)", "u [m/s]")]


def table(chance, dialect, cell, column):
    """A file with that cell, and others like it or not, and what is said; or
    None"""
    separator, decimal, quoted = dialect
    number = [("%d%s%d" % (chance.randrange(-50, 50), decimal, n), "NUMBER", "")
              for n in range(1, 36)]
    rows = [[number[5 * n + k] for k in range(5)] for n in range(7)]
    counted = chance.random() < .2
    row = chance.choice([0, 1, 3, 5, 6] if not counted else [2, 3])
    rows[row][column] = cell
    alike = [c for c in texts[dialect] if c[1] == cell[1]]
    for n in chance.sample(range(row + 1, 7), min(6 - row, chance.choice(
            [0, 0, 1, 2, 3]))):
        rows[n][column] = chance.choice(alike)
    if chance.random() < .5:
        rows[chance.randrange(row, 7)][chance.randrange(5)] = chance.choice(
            texts[dialect])
    # (of more than one cell with numbers in it the separator is in doubt)
    if sum(len(re.findall(r"[\d.]+(?=[ ,]|$)", c[0])) > 1 and c[1] == "WORD"
           for r in rows for c in r) > 1:
        return None
    names = 5 * [""] if counted or chance.random() < .4 else chance.choice(
        NAMES[:1] if separator == " " and not quoted else NAMES)
    use = chance.choice([[0, 1, 2], [0, 1, 2, 3], [2, 0, 1, 4],
                         [1, 0, 2, 4, 3]])
    options = ["-decimal", ","] if decimal == "," else []
    options += ["-scale", "1,1,1"]  # (else it may be advised)
    if use[0] or chance.random() < .5:
        options += ["-cols", ",".join(
            chance.choice([names[k] or str(k + 1), str(k + 1)]) for k in use)]
    else:
        use = use[:3]
    # (values are looked at as they are in the file)
    use[3:] = sorted(use[3:]) or [k for k in range(5) if k not in use]
    for option in ["-skip"], ["-below", "0.5"], ["-nodata", "-40,-41"]:
        options += option if chance.random() < .3 else []
    # (of a number that a column has too often -nodata may be advised)
    if "-nodata" not in options and any(
            sum(r[k][1] == "VOID" for r in rows) > 1 for k in range(5)):
        return None
    lines = ["5"] if counted else [separator.join(
        written(t, quoted) for t in names)] if names[0] else []
    placed = []
    for n, cells in enumerate(rows):
        if n > 2 and chance.random() < .2:
            lines.append(chance.choice(["", "# 1 2 3", "  // by hand", "! y"]))
        lines.append(separator.join(written(c[0], quoted) for c in cells))
        placed.append((len(lines), cells))
    said = rows_message(placed[:5] if counted else placed, use, names, options)
    if counted and not (said and said[-1][0] == "!"):
        return None
    return ("t.txt", ("\n".join(lines) + "\n").encode(), *options), said


texts = {d: list(cells_of(*d)) for d in DIALECTS}


@pytest.mark.parametrize("dialect", DIALECTS, ids=lambda d: "%r decimal %s%s" % (
    d[0], d[1], ", in quotes" * d[2]))
def test_cells_in_a_table(read, everything, dialect):
    chance = random.Random(repr(dialect))
    # (of each dialect every other text: all texts are in some)
    first = DIALECTS.index(dialect) % 2
    jobs = [table(chance, dialect, cell, column)
            for cell in texts[dialect][not everything and first::2 - everything]
            for column in chance.sample(range(5), 2 if everything else 1)]
    assert len(jobs) > 40
    all_say(read, [j for j in jobs if j])


# ---- numbers but for something: by expressions, any text of such letters ----

def like_numbers(decimal):
    """(expression, remedy), in the order that counts"""
    d = re.escape(decimal)
    e = r"(?:[eEdDqQ][+-]?\d+)"
    part = r"\d+(?:\.\d*)?|\.\d+" if decimal == "." else r"\d*,\d+|\d+"
    # (as much as there is, or none: FORTRAN's exponent has three digits)
    n = r"[+-]?(?:(?=[\d.,]*%s\d|\d+\.)(?:%s)(?![\d])[+-]\d{3}(?!\d)|" \
        r"(?:%s)(?!\d)(?:%s(?!\d)|(?![eEdDqQ])))(?![a-zA-Z])" % (
            d, part, part, e)
    sign = ",." [decimal == ","]
    by_three = r"[+-]?[1-9]\d{0,2}(?:%s\d{3})" % re.escape(sign)
    tail = e + "?$"
    if decimal == ".":
        commas = [
            (by_three + r"{2,}(?:\.\d+)?" + tail, THOUSANDS),
            (by_three + r"\.\d+" + tail, THOUSANDS),
            (r"[+-]?\d*\.[\d.]*,\d+" + tail, GROUPS),
            (by_three + tail, {False: COMMA, True: THOUSAND}),
            (r"[+-]?\d*,\d+" + tail, COMMA)]
    else:
        commas = [
            (by_three + r"{2,}(?:,[\d,]*\d)?" + tail, POINTS),
            (r"[+-]?[\d,]*\.(?:[\d,]*\d)" + tail, POINTS),
            (r"[+-]?\d*,[\d,]*\d" + tail, MANY)]
    return [(n + "$", None)] + commas + [
        (n + "[,;]$", ONE),
        (n + r"(?=[+-][\d,.]*%s)" % d + n + "$", TOUCH),
        (n + "#", GLUED), ("", "")]


@pytest.mark.parametrize("decimal", [".", ","])
@pytest.mark.parametrize("quoted", [False, True], ids=["bare", "in quotes"])
def test_texts_like_numbers(read, everything, decimal, quoted):
    chance = random.Random("%s %d" % (decimal, quoted))
    forms = [(re.compile(f), r) for f, r in like_numbers(decimal)]
    jobs = []
    for k in range(1500 if everything else 300):
        text = "".join(chance.choice("125,,..0-e+;#D0"[:15 if k % 2 else 7])
                       for n in range(chance.randrange(1, 10)))
        if k % 3:  # of parts
            text = "".join(
                "%s%0*d" % (chance.choice(mark), n, chance.randrange(10 ** n))
                for mark, n in [(["", "", "-"], chance.randrange(1, 5))] + [
                    (",,.", chance.choice([1, 3, 3, 3, 4]))
                    for j in range(chance.randrange(1, 4))] +
                [(["e", "D-", "-"], 1)] * (chance.random() < .1))
            text = text[chance.random() < .1:]
        remedy = next(r for f, r in forms if f.match(text))
        if remedy is None or re.match("[-.]+$|#", text) or \
                (not quoted and ";" in text):
            continue
        if isinstance(remedy, dict):
            remedy = remedy[quoted]
        rows = ["%d;%d;%d" % (n, n * n, 7 * n % 5) for n in range(5)]
        rows[3] = '"%s";1;2' % text if quoted else text + ";1;2"
        jobs.append((("t.txt", "\n".join(rows) + "\n",
                      *["-decimal", ","] * (decimal == ",")), [cell_message(
                          4, 0, "", (text, "WORD", remedy))]))
    assert len(jobs) > 150
    all_say(read, jobs)


# ---- the same in all formats ----

# of x: the column, from 0 on; the names of x, y, z, and of a value
COLUMNS = {"lines.txt": (0, "", "", "", ""), "names.csv": (0, *"xyzT"),
           "counted.txt": (0, "", "", ""), "atoms.xyz": (1, "", "", ""),
           "more.xyz": (1, *"xyzu"), "node.node": (1, *"xyz", "value"),
           "mesh.off": (0, *"xyz"), "mesh.ply": (0, *"xyzT"),
           "mesh.obj": (1, *"xyz"), "mesh.stl": (1, *"xyz"),
           "atoms.pdb": (1, *"xyz", "B"), "cloud.pcd": (0, *"xyzT"),
           "dump.lammpstrj": (1, *"xyz")}
SOME = [c for c in texts[" ", ".", False] if c[1] in (
    "ABSENT", "NAN", "STARS", "NEAR", "WORD", "BELOW") and len(c[0]) < 7 and
    c[0].isascii() and not re.search('[,"#]|^[/<]', c[0])]
EMPTY = "", "EMPTY", SKIP


def damaged(name, column, at, cells):
    """The sample with those cells in that row, and following ones; lines"""
    content = SAMPLES[name]
    spans, lines = [], []
    for m in row_matches(name, content):
        spans.append([m.span(k) for k in (1, 2, 3)] + [
            (m.end() + (6 if name == "atoms.pdb" else 1),
             content.index(b"\n", m.end()))])
        lines.append(content.count(b"\n", 0, m.end()) + 1)
    for n, cell in reversed(list(enumerate(cells, at))):
        a, b = spans[n][column]
        text = cell[0].encode()
        content = content[:a] + (text.rjust(b - a) if name == "atoms.pdb"
                                 else text) + content[b:]
    return content, lines


@pytest.mark.parametrize("name", COLUMNS)
def test_cells_in_a_format(read, name):
    chance, jobs = random.Random(name), []
    first, *names = COLUMNS[name]
    fixed = name == "atoms.pdb"
    for column, at in itertools.product(range(len(names)), (0, 2, 4)):
        for cell in chance.sample(SOME, 6) + [EMPTY] * (
                name == "names.csv" or (fixed and column < 3)):
            # (a word behind a count may be a comment's; -B- is narrow)
            if (at == 0 and name in ("atoms.xyz", "counted.txt")) or (
                    fixed and len(cell[0]) > 4) or (
                        column == 3 and cell[1] == "NAN"):
                continue
            cells = [cell] * (chance.randrange(1, 4) if at < 4 else 1)
            content, lines = damaged(name, column, at, cells)
            # (what is in fixed columns is not counted)
            alike = () if fixed else lines[at + 1:at + len(cells)]
            jobs.append(((name, content), [cell_message(
                lines[at], first + column, names[column], cell, alike, False,
                column < 3)]))
    assert len(jobs) > 20
    all_say(read, jobs)


# binary: the row, from 1 on
@pytest.mark.parametrize("name, at, stride, form", [
    ("packed.ply", SAMPLES["packed.ply"].index(b"end_header\n") + 11, 32, "<d"),
    ("array.npy", -160, 32, "<d"), ("packed.pcd", -160, 32, "<d"),
    ("packed.stl", 96, 12, "<f")], ids=["PLY", ".npy", "PCD", "STL"])
@pytest.mark.parametrize("x, what", [
    ("nan", "NaN: not a number (-skip drops such lines)"), ("inf", "not finite")])
def test_cells_in_a_binary_format(read, name, at, stride, form, x, what):
    for row, column in itertools.product((0, 2, 4), range(3)):
        content = bytearray(SAMPLES[name])
        struct.pack_into(form, content, at % len(content) + row * stride +
                         column * struct.calcsize(form) +
                         14 * (row // 3) * (name == "packed.stl"), float(x))
        says(read, name, bytes(content), ["! F, row %d: column %d%s: %s" % (
            row + 1, column + 1, "" if name == "array.npy" else
            ", " + "xyz"[column], what)])


# ---- all other messages: messages.txt; what the files there are made of ----

XYZ = "0 0 0\n1 0 0\n0 1 0\n2 2 1\n1 1 1.5\n"
ONES = "".join("%s %d\n" % (p, 2 * k) for k, p in enumerate(
    XYZ.splitlines()))

GROUPED = "x,y,z,T,hole\n" + "".join("%d,%d,%d,%d,%s\n" % (
    k % 3, k // 3 % 3, k // 9, k, "AABBC"[k % 5]) for k in range(27))


LIMITS = "".join("%d %d %d %s\n" % (
    k, k * k % 17, k * k * k % 11, ">100" if k % 5 == 1 else
    "<0.5" if k % 11 == 3 else k % 7 + 1) for k in range(20))
WORDY = "0 0 0 sand\n1 0 0 Sand\n0 1 0 CO\n2 2 1 Co\n1 1 1.5 ash\n"


def beside(left="", right="", body=XYZ):
    """what is before each row, %d its number, and behind"""
    return "".join((left % n if "%d" in left else left) + s + right + "\n"
                   for n, s in enumerate(body.splitlines(), 1))


def csv(*names, body=ONES):
    return ",".join(names) + "\n" + body.replace(" ", ",")


LABELLED = csv("hole", "x", "y", "z", "T", body=beside(
    "A%d ", "", ONES + "3 1 2 5\n"))


def pcd(body=XYZ, **keys):
    head = dict(VERSION=".7", FIELDS="x y z", SIZE="4 4 4", TYPE="F F F",
                COUNT="1 1 1", WIDTH="5", HEIGHT="1", VIEWPOINT="0 0 0 1 0 0 0",
                POINTS="5", DATA="ascii")
    head.update(keys)
    return "".join("%s %s\n" % k for k in head.items() if k[1] != "-") + body


def ply(*head, body=XYZ, vertex="property float x\nproperty float y\n"
        "property float z\n", form="format ascii 1.0\n"):
    return "ply\n" + form + "element vertex 5\n" + vertex + "".join(
        h + "\n" for h in head) + "end_header\n" + body


def dump(bounds="ITEM: BOX BOUNDS pp pp pp\n0 4\n0 4\n-3 4\n", axes="x y z",
         body=XYZ, number="ITEM: NUMBER OF ATOMS\n5\n", time="0"):
    return "ITEM: TIMESTEP\n%s\n%s%sITEM: ATOMS %s\n%s" % (time, number, bounds,
                                                           axes, body)


def xyz(line, body=XYZ):
    return "5\n%s\n%s" % (line, body)


def pdb(*records, at=1):
    lines = SAMPLES["atoms.pdb"].decode().splitlines()
    return "".join(s + "\n" for s in lines[:at] + list(records) + lines[at:])


ATOM = "ATOM      9  C  %sLYS A   9       7.000   7.000   %s"


def npy(descr="'<f8'", shape="(5, 4)", order="False", version=1, behind=b"",
        head="{'descr': %s, 'fortran_order': %s, 'shape': %s, }\n", form="<5d"):
    text = (head % (descr, order, shape) if "%s" in head else head).encode()
    return b"\x93NUMPY" + bytes([version, 0]) + struct.pack(
        "<H" if version == 1 else "<I", len(text)) + text + \
        SAMPLES["array.npy"][-160:] + behind


def las(at=None, form="<I", *values, behind=b""):
    content = bytearray(SAMPLES["survey.las"])
    if at is not None:
        struct.pack_into(form, content, at, *values)
    return bytes(content) + behind


def las14(few, many):
    content = las(25, "B", 4)
    return content[:96] + struct.pack("<I", 375) + content[100:107] + \
        struct.pack("<I", few) + content[111:227] + bytes(20) + \
        struct.pack("<Q", many) + bytes(120) + content[227:]


def text(name, *changes):
    """a sample, of whose parts that are there twice the second ones replace the
    first ones"""
    content = SAMPLES[name].decode()
    for old, new in zip(changes[::2], changes[1::2]):
        assert old in content, (name, old)
        content = content.replace(old, new)
    return content


SHORT = {"QUERY": "-query F -values OUT IN",
         "PLANE": "-plane -grid 2,2 -values OUT",
         "NEAREST": "-method nearest -grid 2,2,2 -values OUT"}


def cases():
    """of messages.txt: group, file, options, what is wanted"""
    group, files, said = "", [], True
    with open(os.path.join(HERE, "messages.txt"), encoding="utf-8") as f:
        lines = f.read().replace("\n        ", " ").splitlines()
    for line in lines:
        if line[:3] == "== ":
            group = line[3:]
        elif line[:4] == "    ":
            said = True
            for case in files:
                case[3].extend([line[4:]] * (line != "    silence"))
        elif line[:1] not in ("", "#"):
            if said:
                yield from files
                files, said = [], False
            code, _, options = line.partition(" :: ")
            files.append((group, code, options, []))
    yield from files


@pytest.mark.parametrize("code, options, wanted", [
    pytest.param(code, options, wanted, id="%s: %s%s" % (
        group, code, options and " :: " + options))
    for group, code, options, wanted in cases()])
def test_file_of_messages_txt(read, code, options, wanted):
    words = " ".join(SHORT.get(w, w) for w in options.split()).split()
    name = words.pop(0) if words and words[0][:2] == "f." else "f.txt"
    says(read, name, eval(code), wanted, *words)


# more places than are kept at once: in a file of their own
@pytest.mark.parametrize("many", [131072, 262145])
def test_many_places_have_their_values(tess, tmp_path, many):
    places = [(k % 4, k // 4 % 4, k // 16 % 4) for k in range(many)]
    (tmp_path / "points.txt").write_text(
        "-9 -9 -9 -54\n30 -9 -9 -15\n-9 30 -9 24\n-8 -8 30 66\n")
    (tmp_path / "many.txt").write_text("".join("%d %d %d\n" % p for p in places))
    done = tess("-q", "-query", "many.txt", "-values", "v.csv", "points.txt")
    assert (done.code, done.err) == (0, "")
    with open("v.csv") as f:
        got = [[float(x) for x in line.split(",")] for line in list(f)[1:]]
    assert len(got) == many
    for p, (x, y, z, v) in zip(places, got):
        # (the points' values are x + 2 y + 3 z)
        assert (x, y, z) == p and abs(v - (x + 2 * y + 3 * z)) < 1e-9


# ---- each text in the sources has been said ----

# what no test can have said
UNSAID = {
    "account       %.0f": "not a message: standard output, by -account",
    "a line of more than 64 MB": "so long a file",
    "a temporary file cannot be read": "a disk that fails",
    "no room for a temporary file": "a disk that is full",
    "more points than a tess_int of %d bytes can number; rebuild with a larger "
    "-DTESS_INT=...": "more points than memory holds",
}
SAYS = r"\b(?:fail|scan_fail|warn|too_small|scan_leave|scan_note|scan_rest)\("
TOKENS = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'|/\*.*?\*/|'
                    r"#[^\n]*", re.S)
LITERAL = re.compile(r'"(?:[^"\\]|\\.)*"(?:\s*"(?:[^"\\]|\\.)*")*')


def pattern(text):
    parts = re.split(r"%[-.*\d]*l?[sdgfc]", text)
    return ".*".join(map(re.escape, parts))[2 * (parts[0] == ""):]


def texts_of(file):
    """Of each text in a reader's source: the formats with which it may be said,
    and itself"""
    with open(os.path.join(HERE, "..", "src", "read", file + ".c")) as f:
        code = TOKENS.sub(lambda m: m[0] if m[0][0] == '"' else " ", f.read())
    texts = []

    def numbered(m):
        texts.append(re.sub(r"\\(.)", r"\1", re.sub(r'"\s*"|^"|"$', "", m[0])))
        return '"%d"' % (len(texts) - 1)

    code = LITERAL.sub(numbered, code)
    # (what lines are compared with)
    code = re.sub(r"\bbegins\([^()]*\)", "", code)
    code = re.sub(r"static const format formats.*?};", "", code, flags=re.S)
    for m in re.finditer(SAYS, code):
        end, depth = m.end(), 1
        while depth:
            depth += {"(": 1, ")": -1}.get(code[end], 0)
            end += 1
        # (not what is compared, nor a letter of a text)
        call = re.sub(r'\w+\([^()]*\)|"\d+"\[', "", code[m.end():end])
        said = [texts[int(t)] for t in re.findall(r'"(\d+)"', call)]
        formats = [t for t in said if "%" in t] or said
        for t in said:
            if t.strip():
                yield [t] if t in formats else formats, t
    # those that are handed on: of two words at least, but no list of words
    for t in (texts[int(t)] for t in re.findall(r'"(\d+)"', code)):
        if re.search(r"[a-z]{2}'?\w* [-\w]", t) and not re.match(r" \w", t):
            yield [t], t


def test_each_text_of_the_readers_is_said(read, request):
    """by the tests above, if all of them have run"""
    if len(read.heard) < 500:
        pytest.skip("each text of the readers: a part of the tests has run")
    heard = sorted(read.heard)
    with_it, unheard, unsaid = {}, [], set()
    for file in READERS:
        for formats, text in texts_of(file):
            for f in formats:
                if f not in with_it:
                    look = re.compile(pattern(f))
                    with_it[f] = [m[0] for m in map(look.search, heard) if m]
            part = re.compile(pattern(text))
            if any(part.search(line) for f in formats for line in with_it[f]):
                continue
            known = [t for t in UNSAID if t in text]
            unsaid.update(known)
            if not known:
                unheard.append((file + ".c", text))
    assert not unheard
    assert unsaid == set(UNSAID)
