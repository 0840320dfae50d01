"""test_properties.py - what holds of all files of generate.py, and of numbers and
tables that hypothesis makes.

Of what a format allows the points must come out, to the last digit, by any name
and through a pipe; what is damaged must be refused, in words of that kind of
damage, or told.  Numbers are those of a grammar, as Python reads them, wherever
numbers are read.
"""
import csv
import io
import itertools
import math
import random
import re

import pytest

pytest.importorskip("hypothesis")
from hypothesis import assume, example, given, settings  # noqa: E402
from hypothesis import strategies as st  # noqa: E402

import generate  # noqa: E402
from generate import DAMAGES, FORMATS, named  # noqa: E402
from samples import TABLE, csv_of, points_of  # noqa: E402

chances = st.randoms(use_true_random=False)
writers = st.sampled_from(FORMATS)
# of data without what they are for they alter nothing
OPTIONS = [(), ("-skip",), ("-below", "0.5"), ("-nodata", "12345.5,-1e30"), ("-q",),
           ("-check",)]
ENDINGS = "txt csv xyz off ply obj stl npy pdb pcd dump las node gslib bdf cnv ts"


def values_of(f):
    values = f.values if f.values is not None else [()] * len(f.points)
    return [tuple(p) + (v if isinstance(v, tuple) else (v,))
            for p, v in zip(f.points, values)]


def rows_of(node):
    return [tuple(map(float, line.split()[1:])) for line in node.split("\n")
            if line and line[0] != "#"][1:]


def read_file(read, f, data, *options, pipe=False, name=None):
    """with each line, or byte, in the account"""
    options += tuple(f.options) + ("-account", "-node", "NODE") + ("-",) * pipe
    done = read(name or "f." + f.ending, data, *options)
    assert done.code in (0, 2), (done, data)
    assert done.code or "-q" in options or "left out: all\n" in done.out, (
        done.out, data)
    return done


# ---- files of all formats ----

@pytest.mark.parametrize("write", FORMATS + [named], ids=lambda w: w.__name__)
def test_what_is_allowed_is_read(read, checked, everything, write):
    def one(k):
        # (under sanitizers all takes four times as long)
        tess = read if k % 3 and not everything else checked
        r = random.Random("%s %d" % (write.__name__, k))
        f, option, way = write(r), r.choice(OPTIONS) * (k % 2), r.randrange(5)
        # (some are read by their names, where others are plausible: that is told)
        name = "g." + r.choice(ENDINGS.split()) if way == 0 and write not in (
            generate.pqr, named) else None
        done = read_file(tess, f, f.bytes(), *option, name=name,
                         pipe=way == 1 and write is not generate.pqr)
        assert name and (done.code == 2 or "as the name" in done.words) or (
            done.code, rows_of(done.points)) == (0, values_of(f)), (
                done.words, name, f.bytes())
        assert done.code or ("nothing is such a number" in done.words) == (
            option[:1] == ("-nodata",))
        if f.names:
            made = tess("f." + f.ending, f.bytes(), "-q", "-volumes", "CELLS")
            assert [row[-1] for row in csv.reader(made.points.splitlines())][
                1:] == f.names, f.bytes()
    list(checked.pool.map(one, range(150 if everything else 12)))


# what may be said of any damage: in a first row it may look like a title
ANYWAY = "|is named as|ends after 4 of 5|a number among words"


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda d: d[0])
def test_damage_is_refused_or_told(read, checked, everything, damage):
    kind, harm, words = damage
    chance = random.Random(kind)

    def files():
        for write in chance.sample(FORMATS, len(FORMATS)) * (2 if everything else 1):
            for _ in range(99):
                f = write(chance)
                data = harm(chance, f)
                if data is not None:
                    # (without its name a damaged .node file may be lines of numbers)
                    yield f, data, chance.random() < .2 and write is not generate.node
                    break

    def one(case):
        k, (f, data, pipe) = case
        done = read_file(read if k % 3 and not everything else checked, f, data,
                         pipe=pipe)
        if done.code == 2:
            assert re.search(words + ANYWAY, done.words), (done.words, data)
            assert done.words.count("\n") < 6, (done.words, data)
        elif not re.search(words, done.words):
            assert data == f.bytes(), (done.words, data)

    assert list(checked.pool.map(one, enumerate(itertools.islice(
        files(), None if everything else 7))))


@given(writers, chances, st.data())
def test_cut_of_a_file_with_a_count_is_refused_or_told(read, write, r, data):
    f = write(r)
    assume(f.cut)
    content = f.bytes()
    done = read_file(read, f, content[:data.draw(st.integers(0, len(content) - 1))])
    if done.code == 0 and rows_of(done.points) != values_of(f):
        assert len(rows_of(done.points)) == len(f.points)
        assert "the last line has no end" in done.words


@given(writers, chances, st.data())
def test_byte_changed_is_read_by_no_index_beyond_its_array(checked, write, r, data):
    f = write(r)
    content = bytearray(f.bytes())
    for k in range(data.draw(st.integers(1, 3))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(
            st.integers(0, 255))
    read_file(checked, f, bytes(content))  # (which looks at code and account)


# ---- numbers: those of a grammar, as Python reads them, and no others ----

NUMBER = re.compile(r"[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:[eEdDqQ][+-]?\d+)?|"
                    r"(?:\d+\.\d*|\.\d+)[+-]\d{3})\Z", re.ASCII)
EXTREMES = ["1.7976931348623157e308", "-1.7976931348623157D+308", "5e-324",
            "2.2250738585072014e-308", "1.7976931348623157+308", "0.", ".0",
            "-0", "+.5", "0.1q-307", "1" + "0" * 300, "0." + "0" * 300 + "1",
            "9007199254740993", "1.5-001", "00012", "1e+0000000000001",
            "2." + 450 * "5", "-0", "-00.5", "0e0"]
# what is nearly FORTRAN's exponent of three digits, or C's hexadecimal number
NEARLY = ["1-101", "-7+001", "1.5-10", "1.5-1010", "1.5-101x", "1.5+101e2",
          "1.5e-101-101", "-0x10", "0X1p3", "00x1", "1.5--101", "1e", "1.5-1,1",
          "nan", "1.#qnan", "", "-", "--", "#1", "1e999", "<1", "<1x", "*", "1(", "f"]
NANS = "nan -nan +nan nan(ind) 1.#qnan -1.#ind".split()
numbers = st.from_regex(NUMBER, fullmatch=True)


@st.composite
def edited(draw):
    """one edit away from one"""
    s, i = draw(numbers), draw(st.integers(0, 9))
    return s[:i] + draw(st.sampled_from(["", *"0123456789+-.,eEdDxXnN_#*<(f"])) + \
        s[i + draw(st.integers(0, 1)):]


texts = numbers | edited() | st.text("0123456789+-.eEdDqQ_x", min_size=1, max_size=9)


def python(text):
    """the number, by another reader"""
    text = re.sub(r"(?<=[\d.])([+-]\d{3})$", r"e\1", re.sub(
        "[dDqQ]", "e", text)) if not re.search("[eE]", text) else text
    return float(text)


def is_number(text):
    return bool(NUMBER.match(text)) and math.isfinite(python(text))


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


@pytest.mark.parametrize("between, form, options", [
    (" ", "%s", ()), (",", "%s", ()), (",", '"%s"', ()), ("\t", " %s ", ()),
    (";", "%s", ("-decimal", ",")), (",", '"%s"', ("-decimal", ","))], ids=[
        "blanks", "commas", "commas, quotes", "tabs", "decimal commas",
        "decimal commas, quotes"])
def test_numbers_are_as_python_has_them(read, between, form, options):
    r = random.Random(7)
    words = EXTREMES + [a_number(r) for k in range(4000 - len(EXTREMES))]
    cells = words
    if options:  # (without a digit behind it there is no sign, nor FORTRAN's
        # exponent; what is longer than 400 characters is refused)
        cells = [re.sub(r"\.(?!\d)", "", s).replace(".", ",") for s in words]
        cells, words = zip(*((c, s) for c, s in zip(cells, words) if NUMBER.match(
            c.replace(",", ".")) and len(c) < 400))
    rows = [between.join(["%d" % (k // m % 10) for m in (4, 40, 400)] +
                         [form % s for s in cells[k:k + 4]]) + "\n"
            for k in range(0, len(cells) - 3, 4)]
    done = read("n.txt", "".join(rows), *options, "-node", "NODE")
    # (that the largest ones may stand for none)
    assert (done.code, re.sub(r"tess: .*: -nodata .*\n", "", done.words)) == (0, "")
    got = [float(x) for line in done.points.splitlines()[1:]
           for x in line.split()[4:]]
    assert len(rows) > 900
    assert got == [python(s) for s in words[:4 * len(rows)]]


@pytest.mark.parametrize("text", ["1" * 500 + "d0", "1" * 500 + ",5",
                                  '"1,' + "5" * 500 + '"'], ids=["d", ",", '"'])
def test_number_too_long_for_fortran_or_a_comma_is_refused(read, text):
    assert read("l.csv", "1;2;3\n4;5;%s\n" % text, "-decimal", ",").code == 2


def in_a_table(read, text, row):
    """it is read as Python has it, refused where it is, or, of what stands for no
    finite number, told"""
    rows = [r[:3] + [text if k == row else r[3]] for k, r in enumerate(TABLE)]
    done = read("e.csv", csv_of("xyzT", rows, ";"), "-node", "NODE")
    if is_number(text):
        assert done.code == 0
        assert float(done.points.splitlines()[row + 1].split()[4]) == python(text)
    elif NUMBER.match(text) or text.lower() in NANS:
        assert done.code == 0 and done.words
    else:
        assert done.code == 2 and done.words.startswith(
            'tess: F:%d: column 4, T: %s' % (row + 2, text and '"' + text[:40]))


@given(texts, st.integers(0, 4))
def test_cell_is_a_number_as_python_has_it_or_refused(read, text, row):
    in_a_table(read, text, row)


@pytest.mark.parametrize("text", NEARLY)
def test_cell_that_is_nearly_a_number_is_refused(read, text):
    in_a_table(read, text, 2)


# where numbers are read besides cells: an option's, or a head's
PLACES = {"-box": "0,4,0,4,-3,4", "-scale": "1,2,.5", "-alpha": "9", "-within": "2",
          "-view": "30 20", "-size": "200,300", "-range": "0,5", "-digits": "5",
          "-below": ".5", "-nodata": "-99,-98", "-outside": "7", "-step": "1,1,1",
          "-grid": "2,2,2,0,1,0,1,0,1", "Lattice": "9 0 0 0 9 0 0 0 9",
          "Origin": "0 0 0"}


@pytest.mark.parametrize("place", PLACES)
@settings(max_examples=settings.default.max_examples // 2)
@given(text=texts | st.sampled_from([s for s in NEARLY if s]), k=st.integers(0, 8))
def test_no_number_is_read_elsewhere_that_a_cell_may_not_have(read, place, text, k):
    # (these part numbers, or end them)
    assume(text and not set(text) & set(",(< ") and (
        place != "-scale" or not is_number(text) or python(text) != 0))
    between = " " if " " in PLACES[place] else ","
    parts = PLACES[place].split(between)
    parts[k % len(parts)] = text
    words, head = between.join(parts), ""
    if place[0] == "-":
        grid = {"-step": ["-grid", "0,1,0,1,0,1"], "-grid": []}.get(
            place, ["-grid", "2,2,2"])
        options = ["-values", "OUT", *grid, place, *words.split(" ")]
    else:
        head, options = '%s="%s"' % (place, words), ()
        if place == "Origin":
            head = 'Lattice="9 0 0 0 9 0 0 0 9" ' + head
    done = read("f.xyz", "5\n%s\n" % head + "".join(
        "%s %s %s %s\n" % tuple(r) for r in TABLE), *options)
    if is_number(text):
        assert not re.search('": not a number$|": not finite|needs (9|three) n',
                             done.words), done.words
    else:
        assert done.code == 2
        assert done.words.startswith('tess: %s: "%s": not ' % (place, text)) or \
            re.search("needs (9|three|3) numbers", done.words), done.words


def test_option_takes_no_more_numbers_than_it_has(read):
    for option in [w for w in PLACES if w[0] == "-" and w != "-nodata"]:
        done = read("f.txt", csv_of("xyzT", TABLE), "-values", "OUT", "-grid", "2,2,2",
                    option, ",".join(20 * ["1"]))
        assert (done.code, done.points) == (2, "") and option in done.words


# ---- tables ----

@given(st.permutations(range(5)), st.permutations("xyzT"), st.sampled_from(",;|\t"))
def test_rows_and_columns_in_any_order(read, rows, columns, between):
    done = read("o.csv", csv_of(columns, [[TABLE[k]["xyzT".index(c)] for c in columns]
                                          for k in rows], between), "-node", "NODE")
    assert done.code == 0
    # (where x, y, z are is told if they are elsewhere)
    where = [columns.index(c) for c in "xyz"]
    assert ("x, y, z are the columns %d, %d, %d (" % tuple(k + 1 for k in where)
            in done.words) == (where != list(range(where[0], where[0] + 3)))
    assert points_of(done.points) == sorted(
        tuple(float(x) for x in r[:3]) for r in TABLE)
    assert [float(line.split()[4]) for line in done.points.splitlines()[1:]] == [
        float(TABLE[k][3]) for k in rows]


@given(st.lists(st.text(st.characters(blacklist_categories=("Cc", "Cs", "Zl", "Zp",
                                                            "Zs")), max_size=12),
                min_size=5, max_size=5))
@example(['a "b""', '"""c', "", 'e"f', "#;|"])
def test_labels_come_back_as_python_wrote_them(read, labels):
    # (a first one that no rule takes for a number, an absent one, or a comment)
    labels = ["w" + s for s in labels]
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(
        [[*"xyz", "n"]] + [r[:3] + [s] for r, s in zip(TABLE, labels)])
    done = read("l.csv", out.getvalue(), "-volumes", "CELLS")
    assert done.code == 0
    assert [r[-1] for r in csv.reader(io.StringIO(done.points, newline=""))] == [
        "n"] + labels
