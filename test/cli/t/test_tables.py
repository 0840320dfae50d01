"""What is told of tables that may be misread."""
import random
import re

import pytest


def lines(rows):
    return "".join(" ".join("%.10g" % x for x in row) + "\n" for row in rows)


# ---- columns without names that number holes, or rows ----

def holes(chance, numbers, decimals=2, cols=5):
    """number x y z value, hole after hole"""
    rows = []
    for number in numbers:
        x, y = (round(c + chance.uniform(0, 999), decimals)
                for c in (500000, 4000000))
        for k in range(chance.randrange(4, 9)):
            rows.append([number, x, y, round(99.5 - k * chance.random(),
                                             decimals), chance.random()][:cols])
    return rows


NUMBERS = {"from 1": list(range(1, 9)), "from 101": list(range(101, 109)),
           "any": [12, 7, 45, 101, 44, 3], "rising": [12, 17, 45, 101, 144]}


@pytest.mark.parametrize("cols", [4, 5])
@pytest.mark.parametrize("numbers", NUMBERS)
@pytest.mark.parametrize("way", ["upright", "whole", "bent", "mixed"])
def test_holes_are_told(tess, tmp_path, way, numbers, cols):
    if (way, numbers) == ("whole", "rising"):
        pytest.skip("as sections are")
    for seed in range(5):
        chance = random.Random(seed)
        rows = holes(chance, NUMBERS[numbers], 0 if way == "whole" else 2, cols)
        for row in rows:
            for k in (1, 2):
                row[k] += chance.random() * (way == "bent")
        if way == "mixed":
            chance.shuffle(rows)
        (tmp_path / "f.txt").write_text(lines(rows))
        done = tess("-q", "f.txt")
        assert "column 1 is %d, %d, %d, ... and was taken for x; if it " \
            "numbers holes or lines: -cols 2,3,4\n" % tuple(
                row[0] for row in rows[:3]) in done.err
        assert "numbers" not in tess("-q", "-cols", "2,3,4", "f.txt").err


@pytest.mark.parametrize("decimals", [0, 2])
def test_numbers_in_any_order_are_told(tess, tmp_path, decimals):
    for seed in range(5):
        chance = random.Random(seed)
        numbers = list(range(1, 41))
        chance.shuffle(numbers)
        (tmp_path / "f.txt").write_text(lines(
            [n] + [round(chance.uniform(0, 1000), decimals) for _ in range(4)]
            for n in numbers))
        done = tess("-q", "f.txt")
        assert "if it numbers the points: -cols 2,3,4\n" in done.err


def test_holes_of_places_are_told(tess, tmp_path):
    (tmp_path / "p.txt").write_text(lines(
        [x, y, z, x] for x in (0, 1e7) for y in (0, 1e7) for z in (0, 1e7)))
    (tmp_path / "f.txt").write_text(lines(holes(random.Random(1), range(1, 9))))
    done = tess("-q", "-query", "f.txt", "-values", "out.csv", "p.txt")
    assert "if it numbers holes or lines: -qcols 2,3,4\n" in done.err


GRIDS = {
    "whole": lambda i, j, k, c: (i, j, k),
    "parts": lambda i, j, k, c: (i, j * .25, k * .1),
    "last first": lambda i, j, k, c: (k, i * .25, j * .1),
    "sections": lambda i, j, k, c: (100 * i, c.random(), c.random()),
    "uneven sections": lambda i, j, k, c: (
        100 * i * i, c.randrange(99), c.randrange(99)),
    "at random": lambda i, j, k, c: (c.random(), c.random(), c.random()),
    "metres": lambda i, j, k, c: (c.randrange(999), c.randrange(999), k)}


@pytest.mark.parametrize("mixed", [False, True])
@pytest.mark.parametrize("grid", GRIDS)
def test_grids_are_not(tess, tmp_path, grid, mixed):
    if mixed and grid == "sections":
        pytest.skip("as holes are, in any order")
    for seed in range(5):
        chance = random.Random(seed)
        rows = [GRIDS[grid](i, j, k, chance) + (chance.random(),)
                for i in range(5) for j in range(4) for k in range(6)]
        if mixed:
            chance.shuffle(rows)
        (tmp_path / "f.txt").write_text(lines(rows))
        assert "numbers" not in tess("-q", "f.txt").err


# ---- the summary ----

def text(x):
    return "%.15g" % x


def expected(titles, columns):
    """what it says of three coordinates, and values"""
    said = []
    for k, (title, column) in enumerate(zip(titles, columns)):
        what = "xyz"[k] if k < 3 else "value"
        named = "" if title == what else title + ": "
        often = sorted((-column.count(x), x) for x in set(column))
        line = "%-13s %s%s to %s" % (what, named, text(min(column)),
                                     text(max(column)))
        if len(often) == 1:
            line = "%-13s %s%s in all rows" % (what, named, text(column[0]))
        elif len(often) > 2 and -often[0][0] > 2 and \
                often[0][0] < 2 * often[1][0]:
            line += "; %s in %d rows, no other number in more than %d" % (
                text(often[0][1]), -often[0][0], -often[1][0])
        said.append(line)
    extent = "extent        " + " x ".join(
        "%.6g" % (max(c) - min(c)) for c in columns[:3])
    return said[:3] + [extent] + said[3:]


def test_summary(tess, tmp_path):
    titles = ["east", "north", "z", "Au ppm", "T"]
    for seed in range(30):
        chance = random.Random(seed)
        columns = []
        for k in range(5):
            kind = chance.randrange(5)
            low = chance.choice([0, -5, 500000])
            columns.append([
                float(chance.randrange(low, low + 9)) if kind == 0 else
                low + 7. if kind == 1 else
                -99. if kind == 2 and chance.random() < .3 else
                round(low + chance.uniform(0, 9), 3) for _ in range(50)])
        (tmp_path / "f.csv").write_text(",".join(titles) + "\n" + "".join(
            ",".join(map(repr, row)) + "\n" for row in zip(*columns)))
        done = tess("f.csv")
        assert done.out.splitlines()[:7] == [
            "points        50, each with 2 values"] + expected(titles, columns)
        assert tess("-q", "f.csv").out == ""


def test_summary_of_many_columns(tess, tmp_path):
    (tmp_path / "f.txt").write_text("".join(
        " ".join(["%d" % (k * k * n % 7 + n) for k in range(3)] +
                 ["%d" % (k + n) for k in range(25)]) + "\n"
        for n in range(9)))
    done = tess("-cols", ",".join(str(k + 1) for k in range(28)), "f.txt")
    assert len(re.findall("^value  ", done.out, re.M)) == 20
    assert "\nvalues        5 more\n" in done.out


def test_summary_of_what_is_not_finite(tess, tmp_path):
    (tmp_path / "f.txt").write_text(
        "0 0 0 nan nan\n1 0 0 3 inf\n0 1 0 inf nan\n0 0 1 5 nan\n")
    done = tess("f.txt")
    assert "value         3 to 5; not finite in 2\n" in done.out
    assert "value         value2: no finite number\n" in done.out


# ---- columns that are not there ----

@pytest.mark.parametrize("option", ["-cols x,{},z", "-by {} -validate"])
@pytest.mark.parametrize("comments", [0, 1, 3])
@pytest.mark.parametrize("mark", ["", "# "])
def test_names_are_listed(tess, tmp_path, mark, comments, option):
    names = ["x", "y", "z", "grade"]
    (tmp_path / "f.csv").write_text(
        "# by hand, of holes\n" * comments + mark + ",".join(names) + "\n" +
        "0,0,1,2\n1,0,0,2\n0,1,0,2\n0,1,1,2\n")
    done = tess(*option.format("au").split(), "f.csv")
    assert done.code == 2
    assert done.err == 'tess: f.csv:%d: %s: no column "au" among 4, which ' \
        "line %d names: %s\n" % (comments + 2, option.split()[0],
                                 comments + 1, ", ".join(names))


# ---- units ----

UNITS = {"m": 1, "km": 1000, "ft": .3048, "mm": .001}


@pytest.mark.parametrize("form", ["{} ({})", "{} [{}]", "{}_{}"])
@pytest.mark.parametrize("names", [["X", "Y", "Z"],
                                   ["easting", "northing", "elevation"]])
@pytest.mark.parametrize("across", UNITS)
@pytest.mark.parametrize("up", UNITS)
def test_units_of_axes(tess, tmp_path, up, across, names, form):
    titles = [form.format(n, u) for n, u in zip(names, [across, across, up])]
    (tmp_path / "f.csv").write_text(",".join(titles) + ",T\n0,0,1,2\n"
                                    "1,0,0,2\n0,1,0,2\n0,1,1,2\n")
    done = tess("-q", "f.csv")
    scale = "%.6g" % (UNITS[up] / UNITS[across])
    assert done.code == 0
    assert ("are in %s, %s, %s, and the mesh takes them as the same: -scale "
            "1,1,%s makes them so" % (across, across, up, scale)
            in done.err) == (up != across)
    assert "are in" not in tess("-q", "-scale", "1,1," + scale, "f.csv").err


@pytest.mark.parametrize("unit", ["ppm", "g/t", "%", "degC", "wt%"])
def test_a_unit_is_of_the_name_before_it(tess, tmp_path, unit):
    rows = [[k * k % 7, k % 3, k, .5 + k, 9 - k] for k in range(9)]
    for first in 0, 1:
        (tmp_path / "f.txt").write_text("X Y Z T %s u\n" % unit + lines(
            ([k] if first else []) + row for k, row in enumerate(rows)))
        done = tess("f.txt")
        assert "value         T %s: 0.5 to 8.5\n" % unit in done.out, done
        assert "value         u: 1 to 9\n" in done.out
        assert ("rows' names" in done.err) == (first == 1)
        assert tess("-q", "-cols", "x,y,z,t", "f.txt").code == 0


@pytest.mark.parametrize("other", ["Altitude", "elevation", "RL", "depth"])
def test_two_heights(tess, tmp_path, other):
    (tmp_path / "f.csv").write_text("X,Y,%s,Z\n" % other + "0,0,1,2\n"
                                    "1,0,0,2\n0,1,0,2\n0,1,1,3\n")
    done = tess("-q", "f.csv")
    assert "f.csv: z is column 4, Z, though column 3, %s, might be, too" % \
        other in done.err
    assert "might" not in tess("-q", "-cols", "1,2,3,4", "f.csv").err


# ---- what a value is of, and where places are ----

def cloud(chance, n=40):
    return [[chance.uniform(0, 9) for _ in range(3)] + [chance.random()]
            for _ in range(n)]


@pytest.mark.parametrize("first", [0, 1, 1001])
def test_a_named_column_that_numbers_the_rows_is_told(tess, tmp_path, first):
    rows = cloud(random.Random(first))
    told = "column 1, nodenumber, numbers the rows, and is a value"
    for wrong in None, 7:
        text = "nodenumber,x,y,z,T\n"
        for k, row in enumerate(rows):
            text += "%d,%r,%r,%r,%r\n" % (first + k + (k == wrong), *row)
        (tmp_path / "f.csv").write_text(text)
        assert (told in tess("-q", "f.csv").err) == (wrong is None)
    assert "numbers" not in tess("-q", "-cols", "x,y,z,T", "f.csv").err


@pytest.mark.parametrize("lon, lat, told", [
    (10, 50, None), (-180, -90, None), (359.9, 89, None), (1026.9, 50, "lon"),
    (10, 5027.1, "lat"), (40, -119.5, "lat"), (-361, 0, "lon")])
def test_places_that_are_on_no_globe_are_told(tess, tmp_path, lon, lat, told):
    (tmp_path / "f.csv").write_text("lat,lon,depth,T\n" + "".join(
        "%r,%r,%d,%d\n" % (lat * (1 - k / 99), lon * (1 - k * k / 99), k % 3, k)
        for k in range(8)))
    done = tess("-q", "f.csv")
    for name in "lat", "lon":
        assert (name + " goes to" in done.err) == (name == told), done.err


@pytest.mark.parametrize("cell", ["2 W", "2 n", "10.5 E"])
def test_a_hemisphere_is_no_unit(tess, cell):
    done = tess("-q", "-", stdin="x,y,z\n1,%s,3\n" % cell)
    assert done.code == 2 and '"%s": not a number (a hemisphere?' % cell in done.err


def test_iso_says_of_which_value(tess, tmp_path):
    rows = cloud(random.Random(3))
    (tmp_path / "f.csv").write_text("x,y,z,from,au\n" + "".join(
        "%r,%r,%r,%d,%r\n" % (*r[:3], k % 7, r[3]) for k, r in enumerate(rows)))
    done = tess("-iso", "0.5", "s.stl", "f.csv")
    assert "level         0.5 of from: " in done.out
    assert "-iso: from is the first of 2 columns of values" in done.err
    done = tess("-iso", "0.5", "s.stl", "-cols", "x,y,z,au", "f.csv")
    assert "level         0.5 of au: " in done.out and "-iso" not in done.err


@pytest.mark.parametrize("ends", ["pp pp pp", "ff pp ff", "ff ff ff"])
def test_cells_in_a_box_that_repeats_itself(tess, tmp_path, ends):
    for far in 0, 1:
        rows = [r[:3] for r in cloud(random.Random(4))]
        if far:
            rows[7][0] = 27.5
        (tmp_path / "f.lammpstrj").write_text(
            "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n40\nITEM: BOX BOUNDS %s\n"
            "0 9\n0 9\n0 9\nITEM: ATOMS id x y z\n" % ends + "".join(
                "%d %r %r %r\n" % (k + 1, *row) for k, row in enumerate(rows)))
        done = tess("-q", "-volumes", "v.csv", "f.lammpstrj")
        assert ("its box repeats itself, but" in done.err) == ("p" in ends)
        assert ("1 point is outside the box, without a cell" in done.err) == far
        done = tess("-q", "-box", "0,9,0,9,0,9", "-volumes", "v.csv", "f.lammpstrj")
        assert "repeats" not in done.err
