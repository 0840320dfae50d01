"""test_properties.py - what holds of files that hypothesis makes: of all formats
of generate.py, with options that alter nothing, by any name, cut anywhere; of
texts that are numbers, or nearly so, wherever numbers are read; of tables with
any labels."""
import csv
import io
import math

import pytest

pytest.importorskip("hypothesis")
from hypothesis import assume, given  # noqa: E402
from hypothesis import strategies as st  # noqa: E402

import generate  # noqa: E402
from test_contract import NUMBER, TABLE, csv_of, points_of, python  # noqa: E402
from test_generate import read_file, rows_of, values_of  # noqa: E402

chances = st.randoms(use_true_random=False)
writers = st.sampled_from(generate.FORMATS)
# of data without what they are for they alter nothing
options = st.lists(st.sampled_from([
    ("-skip",), ("-below", "0.5"), ("-nodata", "12345.5,-1e30"), ("-q",),
    ("-check",)]), max_size=3, unique=True)


@given(writers, chances, options, st.booleans())
def test_options_without_what_they_are_for_alter_no_points(read, write, r, options,
                                                           pipe):
    f = write(r)
    assume(not pipe or write is not generate.pqr)  # (its name tells it)
    done = read_file(read, f, f.bytes(), *(w for o in options for w in o),
                     pipe=pipe)
    assert done.code == 0 and rows_of(done.points) == values_of(f)
    assert ("nothing is such a number" in done.words) == (
        ("-nodata", "12345.5,-1e30") in options)


@given(writers, chances, st.sampled_from(
    "txt csv xyz off ply obj stl npy pdb pcd dump las node gslib bdf cnv ts".split()))
def test_another_name_refuses_or_alters_nothing(read, write, r, ending):
    f = write(r)
    # (these are read by their names, where others are plausible, and that is told)
    assume("pqr" not in (f.ending, ending))
    done = read_file(read, f, f.bytes(), name="g." + ending)
    assert done.code == 2 or rows_of(done.points) == values_of(f) or \
        "as the name" in done.words


@given(writers, chances, st.data())
def test_cut_of_a_file_with_a_count_is_refused_or_told(read, write, r, data):
    f = write(r)
    assume(f.cut)
    content = f.bytes()
    n = data.draw(st.integers(0, len(content) - 1))
    done = read_file(read, f, content[:n])
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


# ---- numbers ----

nearly = st.text("0123456789+-.eEdDqQ_x", min_size=1, max_size=9)
numbers = st.from_regex(NUMBER, fullmatch=True).filter(
    lambda s: s.isascii() and s[-1] != "\n") | nearly


def is_number(text):
    return bool(NUMBER.match(text)) and math.isfinite(python(text))


@given(numbers, st.integers(0, 4))
def test_cell_is_a_number_as_python_has_it_or_refused(read, text, row):
    rows = [r[:3] + [text if k == row else r[3]] for k, r in enumerate(TABLE)]
    done = read("e.csv", csv_of("xyzT", rows, ";"), "-node", "NODE")
    if is_number(text):
        assert done.code == 0
        assert float(done.points.splitlines()[row + 1].split()[4]) == python(text)
    elif NUMBER.match(text):  # (beyond the largest one)
        assert done.code == 0 and "infinite" in done.words
    elif set(text) <= set("-"):  # (one or two stand for none)
        assert done.code == 2
    else:
        assert done.code == 2
        assert 'F:%d: column 4, T: "%s": not' % (row + 2, text[:40]) in done.words


# where numbers are read besides cells: an option's, or a head's
PLACES = {
    "-within": lambda s: (("-within", s, "-grid", "2,2,2", "-values", "OUT"), ""),
    "-nodata": lambda s: (("-nodata", s), ""),
    "-below": lambda s: (("-below", s), ""),
    "-scale": lambda s: (("-scale", "1,%s,1" % s), ""),
    "-outside": lambda s: (("-outside", s, "-grid", "2,2,2", "-values", "OUT"), ""),
    "Lattice": lambda s: ((), 'Lattice="9 0 0 0 9 0 0 0 %s"' % s),
    "Origin": lambda s: ((), 'Lattice="9 0 0 0 9 0 0 0 9" Origin="0 %s 0"' % s),
}


@pytest.mark.parametrize("place", PLACES)
@given(text=numbers)
def test_no_number_is_read_elsewhere_that_a_cell_may_not_have(read, place, text):
    assume(place != "-scale" or not is_number(text) or python(text) != 0)
    options, head = PLACES[place](text)
    done = read("f.xyz", "5\n%s\n" % head + "".join(
        "%s %s %s %s\n" % tuple(r) for r in TABLE), *options)
    refused = "not a number" in done.words or "not finite" in done.words or \
        "needs 9 numbers" in done.words or "needs three numbers" in done.words or \
        "needs 3 numbers" in done.words
    assert refused != is_number(text), done.words


# ---- tables ----

@given(st.permutations(range(5)), st.permutations("xyzT"), st.sampled_from(",;|\t"))
def test_rows_and_columns_in_any_order(read, rows, columns, between):
    done = read("o.csv", csv_of(columns, [[TABLE[k]["xyzT".index(c)] for c in columns]
                                          for k in rows], between), "-node", "NODE")
    assert done.code == 0
    assert points_of(done.points) == sorted(
        tuple(float(x) for x in r[:3]) for r in TABLE)
    assert [float(line.split()[4]) for line in done.points.splitlines()[1:]] == [
        float(TABLE[k][3]) for k in rows]


@given(st.lists(st.text(st.characters(blacklist_categories=("Cc", "Cs", "Zl", "Zp",
                                                            "Zs")), max_size=12),
                min_size=5, max_size=5))
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
