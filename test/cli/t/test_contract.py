"""test_contract.py - what build/tess promises of any file that it reads, over all
formats: nothing in a format's sample, of samples.py, may be changed, cut or added
without a word, but for what is listed there as no part of the points; and what
means the same is read as the same.
"""
import csv
import itertools
import math
import random
import re
import struct

import pytest

from samples import (CORNERS, FORMATS, P, SAMPLES, TABLE, V, csv_of, of_kind, points_of,
                     row_matches)

OPEN, ENDED, PACKED, BOXED, NAMED = map(
    of_kind, ("open", "ended", "packed", "box", "named"))
ROWLESS = {"restart.rst7"}  # two points in a line
NAMES = list(SAMPLES)
each_format = pytest.mark.parametrize("name", NAMES)
TABLE5 = [r + ["%g" % (v * v)] for r, v in zip(TABLE, V)]


@pytest.fixture(scope="session")
def run(read):
    """run(name, content, *options): exit code, what is written, messages; by a
    pipe, and like the sample whose box counts, or its titles"""
    def run(name, content, *options, pipe=False, like=None):
        like = like or name
        options = ("-account", *options, "-node", "NODE")
        options += ("-volumes", "CELLS") * (like in BOXED | NAMED)
        options += ("-periodic",) * (like in BOXED) + ("-",) * pipe
        r = read(name, content, *options)
        assert r.code or "-q" in options or "left out: all\n" in r.out, \
            "the account of " + name
        return r.code, r.points, r.words.replace("standard input", "F")

    def whole(name):
        if name not in found:
            found[name] = run(name, SAMPLES[name])
        return found[name]

    found = {}
    run.whole = whole
    run.many = lambda jobs: list(read.pool.map(lambda job: run(*job), jobs))
    return run


@pytest.fixture
def some(everything):
    """some(list, n): every nth of it, or all; from the kth on"""
    return lambda items, n, k=0: items if everything else items[k % n::n]


@each_format
def test_sample_is_the_points(run, name):
    code, node, words = run.whole(name)
    right = sorted(tuple(struct.unpack("<3f", struct.pack("<3f", *p)))
                   if name == "packed.stl" else p
                   for p in (CORNERS if ".stl" in name else P))
    assert code == 0
    # (copies of points go with those of a box that repeats itself)
    assert set(right) <= set(points_of(node)) if name in BOXED else \
        right == points_of(node)


# ---- deafness, cuts, junk ----

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
    for what in FORMATS[name].deaf:
        if isinstance(what, range):
            deaf.update(i % len(content) for i in what)
        else:
            for m in re.finditer(what, content):
                for k in range(len(m.groups())):
                    deaf.update(range(*m.span(k + 1)))
    return deaf


@each_format
def test_each_byte_changed_is_heard(run, some, name):
    content = SAMPLES[name]
    head = {"packed.ply": content.find(b"end_header") + 11, "array.npy": 0,
            "packed.stl": 0, "survey.las": 0, "packed.pcd": content.find(
                b"DATA binary") + 12}.get(name, len(content))
    places = some(sorted(set(range(len(content))) - may_be_deaf(name)), 11)
    results = run.many([(name, changed(content, i, i < head)) for i in places])
    deaf = [content[max(0, i - 8):i + 8] for i, r in zip(places, results)
            if r == run.whole(name)]
    assert not deaf


@each_format
def test_each_cut_is_heard(run, some, name):
    content = SAMPLES[name]
    places = some(range(len(content)), 11)
    code, whole, words = run.whole(name)
    silent, lost = [], []
    for n, r in zip(places, run.many([(name, content[:n]) for n in places])):
        if r[0] == 0 and r[2] == words and not (
                name in OPEN and content[n - 1:n] == b"\n"):
            silent.append(content[:n][-20:])
        # (a count: a file that lacks a row is refused; END, which is there
        # else, is told; copies of points go with those of a periodic box)
        if r[0] == 0 and name not in OPEN | ENDED | BOXED and len(
                points_of(r[1])) != len(points_of(whole)):
            lost.append(content[:n][-20:])
    assert not silent and not lost


@each_format
def test_junk_at_the_end_is_heard(run, name):
    for junk in b"junk 1 2\n", b"1 2\n", b"x\n":
        assert run(name, SAMPLES[name] + junk)[::2] != run.whole(name)[::2]


# ---- what means the same ----

def neutral(name):
    content = SAMPLES[name]
    yield "CR LF", content.replace(b"\n", b"\r\n")
    yield "CR", content.replace(b"\n", b"\r")
    yield "byte order mark", b"\xef\xbb\xbf" + content
    yield "Ctrl-Z", content + b"\x1a"
    yield "blanks at ends of lines", content.replace(b"\n", b"  \n")
    if name in ("lines.txt", "names.csv"):
        yield "blank lines", content.replace(b"\n", b"\n\n")
        yield "wide cells", re.sub(rb"(?<=\n|,)(-?\d)", rb"   \1", content)
    if name == "mesh.stl":
        yield "capitals", content.upper()
        yield "no indentation", re.sub(rb"\n +", b"\n", content)
    if name == "names.csv":
        yield "capitals", content.replace(b"x,y,z", b"X,Y,Z")
        yield "quotes", re.sub(rb"([^,\n]+)", rb'"\1"', content)
    if name in ("lines.txt", "node.node", "mesh.off", "mesh.obj", "cloud.pcd"):
        for m in reversed(list(row_matches(name, content))):
            content = content[:m.start(1)] + re.sub(
                rb"(?<=[ ])(-?\d+)(?= )", rb"\1.0D+00", b" %s " % content[
                    m.start(1):m.end(3)]).strip() + content[m.end(3):]
        yield "exponents", content


@pytest.mark.parametrize("name, content", [
    pytest.param(name, content, id="%s: %s" % (name, what))
    for name in NAMES if name not in PACKED for what, content in neutral(name)])
def test_neutral_change_alters_nothing(run, name, content):
    assert content != SAMPLES[name]
    code, node, words = run(name, content)
    _, whole, said = run.whole(name)
    assert (code, points_of(node)) == (0, points_of(whole))
    assert re.sub(r"F:\d+", "F", words) == re.sub(r"F:\d+", "F", said)


@each_format
def test_by_q_the_same_is_told_of_the_data(run, name):
    code, node, words = run(name, SAMPLES[name], "-q")
    # (duplicates, which STL's corners are, are told by the summary without it)
    words, doubled = re.subn("tess: .*: 1 duplicate: .*\n", "", words)
    assert (code, node, words) == run.whole(name)
    assert doubled == name.endswith(".stl")


def test_by_q_duplicates_and_dropped_rows_are_told(tess):
    done = tess("-q", "-skip", "-grid", "3,3,3", "-values", "q.csv", "-",
                stdin="x,y,z,T\n" + "".join("%d,%d,%d,%d\n" % (
                    k, k * k % 5, k // 4, k) for k in range(9)) +
                "1,1,0,5\nNA,1,1,1\n9,9,-9999,3\n")
    assert done.out == ""
    for words in "1 duplicate:", "1 row dropped", "z is -9999", "mean of their":
        assert words in done.err


ENDINGS = sorted({name[name.rfind("."):] for name in SAMPLES} - {".lammpstrj"})


@each_format
def test_the_same_under_any_name_and_through_a_pipe(run, some, name):
    _, whole, _ = run.whole(name)
    for ending in some(ENDINGS, 5, NAMES.index(name)):
        code, node, words = run("other" + ending, SAMPLES[name], like=name)
        # (PDB's last numbers, as those of PQR may be: by the name, and told)
        assert code == 2 or node == whole or (
            (name, ending) == ("atoms.pdb", ".pqr") and
            "as the name's .pqr says" in words), ending
    code, node, words = run(name, SAMPLES[name], pipe=True)
    assert (code, node) == (0, whole)


@pytest.mark.parametrize("name", ["counted.txt", "atoms.xyz", "more.xyz",
                                  "node.node", "dump.lammpstrj"])
def test_lines_behind_a_count_are_no_sample_of_those_before(run, name):
    for junk in b"a b c d\n", b"1 2\n", b"x\n", b"; ; ;\n", b"-,-,-,-\n":
        code, node, words = run(name, SAMPLES[name] + 50 * junk)
        assert (code, node) == run.whole(name)[:2] and ": 50 lines" in words


@pytest.mark.parametrize("name", sorted(PACKED - {"packed.stl"}))
def test_bytes_behind_the_rows_are_left_out(run, name):
    code, node, words = run(name, SAMPLES[name] + bytes(200000))
    assert (code, node) == run.whole(name)[:2] and ": 200000 bytes" in words


@pytest.mark.parametrize("pipe", [False, True])
def test_ctrl_z_ends_a_file_where_a_block_ends_too(run, pipe):
    text = 10921 * b"1 2 3\n" + b"1 2  345\x1a\n"
    assert len(text) == 65536
    assert run("z.txt", text, pipe=pipe)[::2] == (0, "")
    # (else it is of a cell, or of a comment)
    assert run("z.txt", text + b"4 5 6\n", pipe=pipe)[2].startswith(
        "tess: F:10922: column 3: ")
    text = 10921 * b"1 2 3\n" + b"# 345678\x1a\n"
    assert points_of(run("z.txt", text + b"4 5 6\n", pipe=pipe)[1])[-1] == (4, 5, 6)


def test_utf_16_without_a_mark_is_letters_and_a_nul_beside_each(run, some):
    utf = ["a\0a\0", "\0a\0a"]
    for text in utf + some([
            "".join(w) for n in (2, 3, 4) for w in itertools.product("a\0\n", repeat=n)
            if "".join(w) not in utf], 5):
        code, node, words = run("u.txt", text.encode() + b"\n" * (len(text) == 4))
        assert code == 2 and ("is UTF-16" in words) == (text in utf), repr(text)


# ---- order: no role is decided by one row ----

# a cell that is no number, and the exit code by -skip
CELLS = {"NA": 0, "nan": 0, "": 0, "*****": 0, "#N/A": 0, "<0.05": 2, "word": 2,
         "0x10": 2, "1_000": 2, "5 m": 2, "1.2.3": 2, "1e5e5": 2, "inf": 2,
         "\u22125": 2, "1\u00a0000": 2, "\"1,234.5\"": 2, "\"0,5\"": 2,
         "1.#INF": 2, "1.#QNAN": 0, "-": 0, "0-1.5": 2, "--5": 2}


@pytest.mark.parametrize("cell", CELLS)
def test_cell_that_is_no_number_in_any_row_and_column(run, some, cell):
    # (of values, NaN and infinity are kept)
    kept = cell in ("nan", "1.#QNAN", "inf", "1.#INF")
    for column, row in some(list(itertools.product(range(4), range(5))), 3):
        rows = [list(r) for r in TABLE]
        rows[row][column] = cell
        text = csv_of("xyzT", rows)
        code, node, words = run("o.csv", text)
        if column == 3 and kept:
            assert code == 0
        else:  # the line is named, and so is the column
            assert code == 2 and words.startswith("tess: F:%d: column %d, %s" % (
                row + 2, column + 1, "xyzT"[column]))
        code, node, words = run("o.csv", text, "-skip")
        assert code == CELLS[cell] or (column == 3 and kept)


def row_spans(name, content):
    """where each row's line begins and ends"""
    return [(content.rfind(b"\n", 0, m.start(1)) + 1,
             content.index(b"\n", m.end()) + 1)
            for m in row_matches(name, content)]


@pytest.mark.parametrize("name", [n for n in NAMES if n not in PACKED | ROWLESS])
def test_word_in_a_row_is_refused_there(run, some, name):
    content, jobs, lines = SAMPLES[name], [], []
    for row, m in enumerate(row_matches(name, content)):
        spans = [m.span(k) for k in (1, 2, 3)]
        if name in ("lines.txt", "more.xyz", "node.node", "mesh.ply", "cloud.pcd"):
            spans.append((m.end() + 1, content.index(b"\n", m.end())))
        if (name, row) == ("counted.txt", 0):
            continue  # (that looks like a comment behind the count)
        for a, b in spans:
            jobs.append((name, content[:a] + b"word"[:b - a].ljust(b - a) +
                         content[b:]))
            lines.append(content.count(b"\n", 0, a) + 1)
    for line, (code, node, words) in zip(some(lines, 4), run.many(some(jobs, 4))):
        assert code == 2 and re.match(r"tess: F:%d: column \d" % line, words)


# ---- columns: what is told of them, in any order, named anywhere ----

@pytest.mark.parametrize("axes", ["xyz", "xy"])
def test_which_columns_they_are_is_told_if_not_as_usual(run, some, axes):
    for order in some(list(itertools.permutations("xyzTu")), 7):
        rows = [[r["xyzTu".index(c)] for c in order] for r in TABLE5]
        code, node, words = run("p.csv", csv_of(order, rows), *(
            () if axes == "xyz" else ("-plane", "-grid", "2,2", "-values", "OUT")))
        where = [order.index(c) for c in axes]
        said = "x, y%s are the columns %s (" % (
            ", z" * (axes == "xyz"), ", ".join("%d" % (k + 1) for k in where))
        assert code == 0
        if where == list(range(where[0], where[0] + len(axes))):
            assert " are the columns" not in words
        else:
            assert said in words
        assert axes == "xy" or points_of(node) == sorted(P)


@pytest.mark.parametrize("order", ["xyzxu", "xyzyu", "xyzzu", "xyzuX", "xyzYx",
                                   "xyzZZ"])
def test_of_two_columns_of_one_name_the_first_is_the_axis_and_told(run, order):
    code, node, words = run("t.csv", csv_of(order, TABLE5))
    assert (code, points_of(node)) == (0, sorted(P))
    assert any("column %d is called %s, too" % (k + 1, order[k]) in words
               for k in range(5) if order.lower()[k] in order.lower()[:k])


# ---- names before places ----

# axes of one family, in any order among others, with units, marks, signs, in
# letters of any case; lines of names parted in any way; units in a second line;
# one name less, where the first column has the rows' names
FAMILIES = [("x", "y", "z"), ("easting", "northing", "elevation"),
            ("East", "North", "RL"), ("lon", "lat", "depth"),
            ("longitude", "latitude", "alt"), ("x", "y", "elev"),
            ("E", "N", "Z"), ("este", "norte", "cota")]
# what is called so is no axis
OTHERS = ["T", "from", "au_ppm", "bottom depth", "to", "x velocity", "Velocity[X]",
          "normal:0", "zone", "Latin", "eastern", "pH", "xy", "z-score", "units"]


def dressed(chance, word):
    """the name, as people write it"""
    unit = chance.choice(["", "", " (m)", " [m]", "_m", " [ m ]", "(ft)"])
    if word in "xyz":
        mark = chance.choice(["", "", "", "coord", "coordinate", "utm", "mid",
                              "center", "Point"])
        sign = chance.choice(["-", "_", " ", ".", ""])
        word = chance.choice([mark + sign + word, word + sign + mark]) if mark \
            else word
    return chance.choice([str, str.upper, str.lower, str.title])(word) + unit


def lines_of(columns, between):
    return [between.join("%g" % c[k] for c in columns) for k in range(5)]


def ended(lines):
    return "".join(line + "\n" for line in lines)


def test_axes_by_their_names(run, some):
    chance = random.Random(7)
    for k in some(range(900), 9):
        family = chance.choice(FAMILIES)
        columns = [(dressed(chance, w), [p[j] for p in P])
                   for j, w in enumerate(family)] + [
            (o, [7.5 + j * j for j in range(5)])
            for o in chance.sample(OTHERS, chance.randrange(4))]
        chance.shuffle(columns)
        names = [c[0] for c in columns]
        between = chance.choice([" ", "\t", ",", ";", "|"])
        body = lines_of([c[1] for c in columns], between)
        way = chance.choice([",", ", ", ";", "\t", "   ", " ", between])
        if (way == " " and any(re.search(r" (?![(\[])|\[ ", n) for n in names)) or (
                way == "   " and any("  " in n for n in names)):
            way = ","
        quoted = chance.random() < .2
        head = way.join('"%s"' % n if quoted else n for n in names)
        mark = chance.choice(["", "", "# ", "#", "% ", "! ", "//"])
        second = chance.random() < .2 and not mark
        units = way.join("m" if n != "T" else "K" for n in names) + "\n"
        fewer = not mark and not second and chance.random() < .2
        if fewer:
            body = ["%s%s%s" % (chance.choice(['"%d"', "%d"]) % (j * 7 % 10 + 1),
                                between, line) for j, line in enumerate(body)]
        text = chance.choice(["", "", "# by hand\n"]) + chance.choice(
            ["", "", "survey\n"]) + mark + head + "\n" + units * second + ended(body)
        code, node, words = run("n.txt", text)
        assert (code, points_of(node)) == (0, sorted(P)), text
        assert not fewer or "one name less" in words, text
        assert not mark or "names of columns, from a comment" in words, text
        assert family[0] == "x" or " are the columns " in words, text


@pytest.mark.parametrize("way", ["one is missing", "none is there", "one is twice"])
def test_names_that_say_not_which_are_x_y_z(run, some, way):
    """Read are three columns of numbers alone, and that is told; of more it is
    asked, with all columns, and -cols that answers it does."""
    chance = random.Random(way)
    for k in some(range(100), 4):
        whole = chance.choice(FAMILIES)
        family = list(whole)
        if way == "one is missing":
            del family[chance.randrange(3)]
        elif way == "none is there":
            family = []
        else:
            other = chance.choice([f for f in FAMILIES[1:5] if f[0] != family[0]])
            family += other if family[0] != "x" else ["from"] * 3
            if "from" in family:
                del family[chance.randrange(3)]
        names = family + chance.sample(OTHERS[:4], max(chance.randrange(3),
                                                       3 - len(family)))
        chance.shuffle(names)
        values = [[chance.randrange(50) / 8 for j in range(5)] for n in names]
        text = ", ".join(names) + "\n" + ended(lines_of(values, chance.choice(
            [",", " ", ";"])))
        by = chance.choice(names) if k % 5 == 0 else ""
        option = ("-by", by, "-validate", "2") if by and names.count(by) == 1 \
            else ()
        code, node, words = run("n.txt", text, *option)
        left = len(names) - bool(option)
        if left == 3 and not option:  # those that are named are where they are
            told = re.search(r"x, y, z are the columns (\d, \d, \d) "
                             r"\((.*?), (.*?), (.*?)\);", words)
            assert code == 0 and told, text
            assert way != "none is there" or told[1] == "1, 2, 3", text
            assert way != "one is missing" or all(
                told[j + 2] == whole[j] for j in range(3) if whole[j] in names), text
            continue
        assert code == 2 and node == "", text
        if left > 3:
            assert "which columns are x, y, z?" in words, text
            for j, n in enumerate(names):
                assert "column %d, %s: %g\n" % (j + 1, n, values[j][0]) in words
        answer = re.search(r"as -cols (\d+,\d+,\d+)\n$", words)
        assert answer or left < 4, text
        if answer:
            code, node, words = run("n.txt", text, "-cols", answer[1])
            at = [int(n) - 1 for n in answer[1].split(",")]
            assert (code, points_of(node)) == (0, sorted(
                tuple(values[a][j] for a in at) for j in range(5))), text


@pytest.mark.parametrize("way", ["numbered", "one of them is twice", "most steps are 5",
                                 "numbered from"])
def test_column_that_numbers_rows_is_no_coordinate(run, some, way):
    chance = random.Random(way)
    for k in some(range(50), 3):
        first = chance.choice([0, 1, 1001, 77])
        ids = [first]
        while len(ids) < 9:
            ids.append(ids[-1] + (chance.choice([2, 3, 10]) if len(ids) % 4 == 3
                                  else 1))
        points = [tuple(chance.randrange(99) / 4 for j in range(3)) for i in ids]
        between = chance.choice([" ", ",", ";", "\t"])
        before = chance.choice(["", "", "P", "node"])
        behind, value = chance.choice(["", "C"]), chance.choice(["", "9.5"])
        if way == "one of them is twice":  # or not upwards: it is x
            ids[chance.randrange(1, 9)] = first
        elif way == "most steps are 5":
            ids = [first + 5 * j for j in range(9)]
        text = ended(between.join(w for w in (
            before, str(i), behind, *("%g" % c for c in p), value) if w)
            for i, p in zip(ids, points))
        code, node, words = run("i.txt", text)
        as_x = sorted((i, *p[:2]) for i, p in zip(ids, points))
        told = "column %d (%d, %d, %d, ...) numbers the rows" % (
            1 + bool(before), *ids[:3])
        if way[:8] != "numbered":
            assert (code, points_of(node)) == (0, as_x), text
            assert told not in words
            continue
        assert (code, points_of(node)) == (0, sorted(points)), text
        assert told in words
        # -cols makes it one
        answer = re.search(r"if that one is x: -cols (\S+)", words)
        code, node, words = run("i.txt", text, "-cols", answer[1])
        assert (code, points_of(node)) == (0, as_x), text


# numbers that stand for none, sides that differ, columns that number: of each
# option that is named with its argument the result is another one
@pytest.mark.parametrize("kind, advised", [
    ("none", "-scale"), ("end", "-nodata"), ("axis", "-nodata"), ("zeros", "-nodata"),
    ("values", "-nodata"), ("ids", "-cols"), ("few", "-cols")])
def test_what_is_advised_alters_something(run, some, kind, advised):
    chance, times = random.Random(kind), 0
    for k in some(range(86), 3):
        side = [chance.choice([1, 10, 300, 7000, 1e6]) for j in range(3)]
        shift = [chance.choice([0, 0, 4e5, -600, 16]) for j in range(3)]
        rows = [[round(shift[j] + side[j] * chance.random(), 6) for j in range(3)] +
                [round(chance.random(), 3)] for i in range(12)]
        mark = chance.choice([999, -9999, 1e30, -999.25, -99, 99999])
        for i in chance.sample(range(12), 3):
            if kind in ("axis", "values"):
                rows[i][k % 3 if kind == "axis" else 3] = mark
        if kind == "end":
            rows += [[mark] * 3 + [0.5]] * chance.randrange(1, 3)
        if kind == "zeros":
            rows += [[0, 0, 0, 0]] * chance.randrange(1, 4)
        if kind == "few":
            rows = rows[:chance.randrange(2, 6)]
        if kind in ("ids", "few") and k % 4:
            rows = [[i + 1] + r for i, r in enumerate(rows)]
        text = ended(" ".join("%.15g" % x for x in r) for r in rows)
        code, node, words = run("a.txt", text)
        for name, argument in re.findall(r"(-scale|-nodata|-cols) ([-\d.,e+]+)\b",
                                         words):
            if (name, argument) == ("-scale", "1,1,1"):
                continue  # (that leaves all as they are, as is said there)
            times += name == advised
            code2, node2, words2 = run("a.txt", text, name, argument)
            assert code2 == 0, (text, words)
            if name == "-scale":
                assert any(float(x) != 1 for x in argument.split(",")), text
            else:
                assert node2 != node, (text, words)
            # (nor is the same said again)
            assert name + " " + argument not in words2, text
    assert times > 3


BODY = ended(" ".join(r) for r in TABLE5)


def test_names_in_a_comment_are_those_of_a_line(run):
    named = run("n.txt", "T z u x y\n" + BODY, like="names.csv")
    for mark in "# ", "#", "% ", "! ", "// ", "//", "#\t":
        for before in "", "# by hand\n", "! 1 2\n":
            code, node, words = run("n.txt", before + mark + "T z u x y\n" + BODY,
                                    like="names.csv")
            assert code == 0 and (code, node) == named[:2]
            assert "names of columns, from a comment" in words


def test_comment_that_has_no_names_names_nothing(run):
    code, node, words = run("n.txt", "# to be done\n" + BODY)
    assert (code, points_of(node), words) == (0, sorted(P), "")


def test_cols_with_a_value_makes_other_columns_not_matter(run):
    wide = [r[:3] + ["%d" % (7 * k) for k in range(37)] for r in TABLE]
    wide[2][10] = "NA"
    text = csv_of([*"xyz"] + ["c%d" % k for k in range(37)], wide)
    code, node, words = run("w.csv", text, "-cols", "x,y,z")
    assert code == 2 and ":4: column 11, c7: " in words
    assert "-cols X,Y,Z,VALUE" in words
    code, node, words = run("w.csv", text, "-cols", "x,y,z,c9")
    assert (code, points_of(node), words) == (0, sorted(P), "")


def begins():
    """the words by which files that are not read are known"""
    with open(__file__.replace("t/test_contract.py", "src/read/formats.c")) as f:
        words = re.findall(r'NOT_READ\("[^"]*", -?\w+,\s*'
                           r'"((?:[ !$&(-?A-Z^-}]|\\\\.)+)', f.read())
    for word in words:
        word = re.sub(r"\\\\(.)", r"\1", word)
        for title in word[:-1], word[:-1] + "_", "_" + word:
            if not re.search("[,;|\"{[]|^[#!%/]|^-?\\d", title) and len(title) > 1:
                yield title


def test_column_named_nearly_as_other_formats_begin(run, some):
    titles = list(begins())
    for title in some(titles, 4):
        code, node, words = run("f.csv", csv_of([title, *"xyz"], [
            [r[3], *r[:3]] for r in TABLE]))
        assert (code, points_of(node)) == (0, sorted(P)), title
    assert len(titles) > 60


# behind a head of any length, of lines that are nearly like rows
@pytest.mark.parametrize("line", ["depth 5", "north:\t7.5 m", "5", "from 1 to 2",
                                  "a;b;c", "n,5"])
def test_rows_behind_a_head_of_lines_nearly_like_them(run, some, line):
    read = 0
    for n, between in some(list(itertools.product((1, 2, 3, 5, 8, 13, 40), " ,;\t")), 3):
        rows = [between.join(["A"] * (between == ",") + r) for r in TABLE5]
        code, node, words = run("h.txt", ended(["survey"] + [line] * n + rows))
        if code == 2 and (line[0] in "5n" or (line[0] == "f" and n > 8)):
            continue  # (numbers may be rows)
        if (line, n) == ("5", 1) and code == 0 and words == "":
            continue  # (it is their number)
        if code == 2 and line == "a;b;c" and between == ";" and \
                "columns differ in number" in words:
            continue  # (names of three columns of five)
        assert (code, points_of(node)) == (0, sorted(P)), (n, between, words)
        assert sum(map(int, re.findall(r"left out: (\d+) line", words))) == n + 1
        read += 1
    assert read > 0 or line == "5"


@pytest.mark.parametrize("option", [(), ("-skip",), ("-by", "T", "-validate", "2")],
                         ids=" ".join)
def test_words_in_an_axis_and_an_open_quote_are_refused(run, option):
    for k in range(3):
        rows = [["a" if i == k else x for i, x in enumerate(r)] for r in TABLE]
        code, node, words = run("w.csv", csv_of("xyzT", rows), *option)
        assert code == 2
        assert 'F:2: column %d, %s: "a": not a number' % (k + 1, "xyz"[k]) in words
    for row in range(5):
        text = csv_of("xyzTn", [r + ['"a b' + '"' * (i != row)]
                                for i, r in enumerate(TABLE)])
        code, node, words = run("q.csv", text, *["n" if w == "T" else w
                                                 for w in option])
        assert code == 2 and words.startswith("tess: F:%d: column 5" % (row + 2))


# ---- groups, and columns that come back ----

def rows_of(path):
    with open(path, newline="", encoding="utf-8") as f:
        return list(csv.reader(f))


@pytest.mark.parametrize("turn", [0, 1, 13])
def test_by_words_is_a_fold_for_each_in_whatever_order(tess, tmp_path, turn):
    labels = ["b", 'a"1', "a#2", '"q ""1"""', "10", "9", "a b", "é"]
    rows = ["%d,%d,%d,%d,%s" % (k % 5, k * k % 7, k // 3, k, labels[k * 5 % 8])
            for k in range(40)]
    text = "x,y,z,T,g\n" + ended(rows[turn:] + rows[:turn])
    assert tess("-by", "g", "-validate", "8", "-errors", "e.csv", "-",
                stdin=text).code == 0
    made, given = rows_of("e.csv"), list(csv.reader(text.splitlines()))
    fold, group = made[0].index("fold"), made[0].index("g")
    assert [r[group] for r in made] == [r[4] for r in given]
    assert len({(r[fold], r[group]) for r in made[1:]}) == 8
    assert {r[fold] for r in made[1:]} == set("12345678")


def test_by_a_column_of_an_array_is_a_fold_for_each_number(tess, tmp_path):
    rows = [(k % 5, k * k % 7, k // 3, k, k * 5 % 8 / 4 - 1) for k in range(40)]
    head = b"{'descr': '<f8', 'fortran_order': False, 'shape': (40, 5), }"
    (tmp_path / "g.npy").write_bytes(
        b"\x93NUMPY\1\0" + struct.pack("<H", 118) + head.ljust(117) + b"\n" +
        b"".join(struct.pack("<5d", *r) for r in rows))
    tess("-q", "-by", "5", "-validate", "8", "-errors", "g.csv", "g.npy")
    with open("g.csv") as f:
        made = list(csv.DictReader(f))
    assert len({(r["fold"], r["column5"]) for r in made}) == 8
    assert [float(r["column5"]) for r in made] == [r[4] for r in rows]


def test_columns_of_places_come_back_as_python_wrote_them(tess, tmp_path, some):
    chance = random.Random(11)
    (tmp_path / "points.txt").write_bytes(SAMPLES["lines.txt"])
    for k in some(range(60), 3):
        rows = [["x", "y", "z"] + ["n" + "".join(
            chance.choice('a ",;|#é') for j in range(n)) + "." for n in (1, 3, 9)]]
        for row in range(5):
            rows.append([.25, .25, row] + ["w" + "".join(
                chance.choice('a1 ",;|#é.-') for j in range(chance.randrange(9))
                ) + "." for n in range(2)] + [row * 1.5])
        with open("back.csv", "w", newline="", encoding="utf-8") as f:
            csv.writer(f, delimiter=",;\t|"[k % 4], quoting=chance.choice([
                csv.QUOTE_MINIMAL, csv.QUOTE_ALL, csv.QUOTE_NONNUMERIC]),
                lineterminator="\n").writerows(rows)
        done = tess("-q", "-outside", "nearest", "-query", "back.csv", "-qcols",
                    "1,2,3", "-values", "-", "points.txt")
        assert [r[3:6] for r in csv.reader(done.out.splitlines())] == [
            [str(c) for c in r[3:]] for r in rows]


def shortest(x):
    """The first one of 15, 16, 17 digits that gives x back"""
    return next(s for s in ("%.*g" % (n, x) for n in (15, 16, 17))
                if float(s) == x)


def test_column_of_an_array_that_is_no_coordinate_comes_back(tess, tmp_path):
    (tmp_path / "points.txt").write_bytes(SAMPLES["lines.txt"])
    (tmp_path / "back.npy").write_bytes(SAMPLES["array.npy"])
    done = tess("-q", "-query", "back.npy", "-qcols", "1,2,3", "-values", "-",
                "points.txt")
    assert [r[3] for r in csv.reader(done.out.splitlines())] == ["column4"] + [
        shortest(v) for v in V]


@pytest.mark.parametrize("options", [
    "-node s.node", "-mesh s.msh", "-face s.obj", "-face s.off", "-face s.ply",
    "-face s.stl", "-volumes s.csv", "-faces s.csv", "-validate 5 -errors s.csv",
    "-grid 3,4,5 -values s.csv", "-grid 3,4,5 -values s.vtk",
    "-query short.csv -values s.csv"])
def test_numbers_written_are_as_short_as_give_them_back(tess, tmp_path, options):
    r = random.Random(7)
    (tmp_path / "short.csv").write_text("x,y,z,T,u\n" + "".join(
        "%r,%.3f,%r,%r,%r\n" % (
            r.random(), r.random(), r.random() / 3, r.gauss(0, 1),
            float("%.2e" % r.gauss(0, 1e-200))) for k in range(60)))
    assert tess("-q", *options.split(), "short.csv").code == 0
    text = (tmp_path / options.split()[-1]).read_bytes()
    if options.endswith("vtk"):
        text = text[text.index(b"ORIGIN"):text.index(b"POINT_DATA")]
    words = [w for w in re.split(r"[\s,]+", text.decode().replace(" 1.0\n", ""))
             if re.fullmatch(r"-?[\d.]+(e[-+]\d+)?", w)]
    assert len(words) > 5
    assert [w for w in words if w != str(shortest(float(w))) and "." in w] == []


# ---- fewer rows: the same format, and all that there are ----

@pytest.mark.parametrize("name", [
    n for n in NAMES if n not in PACKED | ROWLESS | {
        "mesh.stl", "dump.lammpstrj", "more.xyz"}])
def test_fewer_rows_by_any_name(run, some, name):
    content = SAMPLES[name]
    starts = row_spans(name, content)
    # (of fewer it cannot be seen that they are numbered)
    for n in (4,) if name == "ids.txt" else some((1, 2, 3, 4), 3):
        less = content[:starts[n][0]] + content[starts[4][1]:]
        for where in re.findall(rb"(?m)^5\b|vertex 5\b|WIDTH 5\b|POINTS 5\b|"
                                rb"nvalues = 5", content[:starts[0][0]]):
            less = less.replace(where, where.replace(b"5", b"%d" % n), 1)
        for other, pipe in ((name, False), ("other.txt", False), (name, True)):
            if (name, other) != ("atoms.xyz", "other.txt"):
                code, node, words = run(other, less, pipe=pipe, like="lines.txt")
                assert (code, points_of(node)) == (0, sorted(P[:n])), words


# ---- one box that repeats itself, as each format writes it ----

# the sides along x, in the plane of x, y, and above it: all formats can say that
@pytest.mark.parametrize("xy, xz, yz", [(0, 0, 0), (1, 0, 0), (0, -2, 0),
                                        (0, 0, 1.5), (-1, 2, -1.5)])
def test_box_has_the_same_cells_in_all_formats(read, xy, xz, yz):
    inside = [(.5, .25, .5), (3, 1, 1), (2, 4, 2.5), (1, 3, 4), (4, 2, 3.25)]
    a, b, c = (5, 0, 0), (xy, 6, 0), (xz, yz, 7)
    side = [math.sqrt(sum(x * x for x in v)) for v in (a, b, c)]
    angle = [math.degrees(math.acos(sum(x * y for x, y in zip(u, v)) / m / n))
             for u, v, m, n in ((b, c, *side[1:]), (a, c, side[0], side[2]),
                                (a, b, *side[:2]))]
    lines = ended("%g %g %g" % p for p in inside)
    boxes = {
        "b.xyz": '5\nLattice="%s" Properties=pos:R:3\n' % " ".join(
            "%g" % x for v in (a, b, c) for x in v) + lines,
        "b.pdb": "CRYST1" + "%9.5f" * 3 % tuple(side) + "%7.3f" * 3 % tuple(
            angle) + " P 1           1\n" + "".join(
                "ATOM  %5d  C   LYS A%4d    %8.3f%8.3f%8.3f\n" % (k, k, *p)
                for k, p in enumerate(inside)),
        "b.dump": "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\nITEM: BOX BOUNDS "
        "xy xz yz pp pp pp\n%g %g %g\n%g %g %g\n0 7 %g\n" % (
            min(0, xy, xz, xy + xz), 5 + max(0, xy, xz, xy + xz), xy, min(0, yz),
            6 + max(0, yz), xz, yz) + "ITEM: ATOMS x y z\n" + lines}
    if not any((xy, xz, yz)):
        boxes["b.txt"] = lines
    near = 3e-5 if any((xy, xz, yz)) else 1e-12  # (digits of CRYST1)
    first = None
    for name, content in boxes.items():
        r = read(name, content, "-periodic", "-volumes", "CELLS",
                 *["-box", "0,5,0,6,0,7"] * (name == "b.txt"))
        assert r.words == ""
        cells = [float(row[k]) for row in csv.DictReader(r.points.splitlines())
                 for k in ("volume", "area")]
        first = first or cells
        assert len(cells) == 10 and cells == pytest.approx(first, rel=near)
        assert sum(cells[::2]) == pytest.approx(210, rel=near)


# ---- a surface, in all that formats say about faces ----

TETRAHEDRON = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2)]
FACES = [(0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3)]
CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i",
         "uint": "I", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
         "int32": "i", "uint32": "I", "float": "f", "double": "d"}
WHOLE = [t for t in CODES if t not in ("float", "double")]


def a_ply(k, count, index, form):
    """with a property before the list, behind it or none, and edges"""
    order = ">" if "big" in form else "<"
    packed = form != "ascii"
    more = [("before", ("uchar", "float")[k % 2], "quality"), ("", "", ""),
            ("behind", "short", "flag")][k % 3]
    edge = "element edge 2\nproperty int vertex1\nproperty list uchar short more\n"
    one = "property %s %s\n" % more[1:] if more[0] else ""
    face = "element face 4\n" + one * (more[0] == "before") + \
        "property list %s %s vertex_ind%s\n" % (count, index, (
            "ices", "ex")[k % 2]) + one * (more[0] == "behind")
    head = "ply\nformat %s 1.0\nelement vertex 4\n" % form + "".join(
        "property double %s\n" % c for c in "xyz") + \
        edge * (k % 4 == 1) + face + edge * (k % 4 == 2) + "end_header\n"

    def put(kind, x):
        return struct.pack(order + CODES[kind], x) if packed else b"%g " % x

    end = b"" if packed else b"\n"
    edges = b"".join(put("int", e) + put("uchar", 2) + put("short", e) +
                     put("short", 1) + end for e in (0, 2))
    data = b"".join(b"".join(put("double", x) for x in p) + end
                    for p in TETRAHEDRON) + edges * (k % 4 == 1)
    for f in FACES:
        extra = put(more[1], 7) if more[0] else b""
        data += extra * (more[0] == "before") + put(count, 3) + b"".join(
            put(index, i) for i in f) + extra * (more[0] == "behind") + end
    return head.encode() + data + edges * (k % 4 == 2)


def surfaces():
    """name, content, and where a digit may be another one, so that a corner is
    another point; 0: nowhere"""
    lines = ["%g %g %g\n" % p for p in TETRAHEDRON]
    vertices = "".join("v " + s for s in lines)
    yield "s.off", "OFF\n4 4 6\n" + "".join(lines) + ended(
        "3 %d %d %d" % f for f in FACES), -2
    yield "s.obj", vertices + "".join(
        s % tuple(k + 1 for k in f) for s, f in zip(
            ("f %d %d %d\n", "f %d/1 %d/2 %d/3\n", "f %d//1 %d//1 %d//1\n",
             "f %d/1/1 %d/2/1 %d/3/1\n"), FACES)), -6
    yield "back.obj", vertices + ended(
        "f %d %d %d" % tuple(k - 4 for k in f) for f in FACES), -2
    yield "s.stl", "solid\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(
            "vertex %g %g %g\n" % TETRAHEDRON[k] for k in f) +
        "endloop\nendfacet\n" for f in FACES) + "endsolid\n", 0
    yield "packed.stl", bytes(80) + struct.pack("<I", 4) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for k in f for x in TETRAHEDRON[k]), 0)
        for f in FACES), -3
    for k, (count, index) in enumerate(zip(WHOLE, WHOLE[5:] + WHOLE[:5])):
        for form in "ascii", "binary_little_endian", "binary_big_endian":
            yield "%s-%s-%s.ply" % (count, index, form), a_ply(
                k, count, index, form), 0


@pytest.mark.parametrize("name, content, at", [
    pytest.param(*s, id=s[0]) for s in surfaces()])
def test_surface_of_faces_is_closed(read, name, content, at):
    content = content if isinstance(content, bytes) else content.encode()
    closed = "surface       4 triangles; closed; its volume is 0.5\n"
    assert closed in read(name, content, "-volumes", "CELLS").out
    if at:  # a corner that is another point: not closed
        other = b"\1" if name == "packed.stl" else \
            b"1" if content[at:at + 1] == b"2" else b"2"
        content = content[:at] + other + content[len(content) + at + 1:]
        assert closed not in read(name, content, "-volumes", "CELLS").out


def test_no_surface_where_points_are_dropped(read):
    text = "OFF\n5 4 6\n7 7 -99\n" + ended(
        "%g %g %g" % p for p in TETRAHEDRON) + ended(
            "3 %d %d %d" % tuple(k + 1 for k in f) for f in FACES)
    assert "closed; its volume is 0.5\n" in read(
        "hole.off", text, "-volumes", "CELLS").out
    out = read("hole.off", text, "-volumes", "CELLS", "-nodata", "-99").out
    assert "surface" not in out and "points        4\n" in out


# ---- counts: each number of each head ----

@pytest.mark.parametrize("name", [n for n, f in FORMATS.items() if f.count])
def test_wrong_count_is_refused_or_told(run, some, name):
    m = re.search(FORMATS[name].count, SAMPLES[name])
    for n, pipe in some([(n, pipe) for n in (
            "0", "4", "6", "1e12", "1000000000000", "nan", "-5", "2147483648",
            "9007199254740993", "99999999999999999999", "", "5x", "0x5")
            for pipe in (False, True) if n.encode() != m[1]], 3):
        content = SAMPLES[name][:m.start(1)] + n.encode() + SAMPLES[name][m.end(1):]
        code, node, words = run(name, content, pipe=pipe)
        if n == "1000000000000" and not pipe and ".pcd" not in name and \
                ".npy" not in name and name != "geoeas.dat":
            room = re.search(r"has room for (\d+) at most", words)
            assert room and int(room[1]) <= len(SAMPLES[name]) // 3
        assert code == 2 or words != run.whole(name)[2] or (
            n == "" and points_of(node) == points_of(run.whole(name)[1]))
