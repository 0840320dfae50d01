"""Rows that are no points, and columns that are something else than they were
taken for, are told; what is like them, but sound, is not."""
import random
import re

import pytest


def cloud(chance, n=60, low=0., high=900.):
    return [[round(chance.uniform(low, high), 2) for _ in range(3)] +
            [round(chance.uniform(1, 9), 2)] for _ in range(n)]


def text(rows, names="", between=","):
    return "".join(between.join("%s" % x for x in row) + "\n" for row in (
        [names.split(",")] if names else []) + rows)


@pytest.fixture
def said(tess, tmp_path):
    """what is said of a file, after it has been read"""
    def said(content, *options):
        (tmp_path / "f.csv").write_text(content)
        done = tess("-q", *options, "f.csv")
        assert done.code == 0, done.err
        return done.err
    return said


# ---- rows of sums ----

SUMS = [["Total"], ["TOTAL:"], ["Sum", "Mean", "Min", "Max"], ["Average"],
        ["count", "mean", "std", "min", "25%", "50%", "75%", "max"]]


@pytest.mark.parametrize("words", SUMS, ids="-".join)
@pytest.mark.parametrize("where", ["head", "end"])
def test_rows_of_sums_are_told(said, words, where):
    for seed in range(4):
        chance = random.Random(seed)
        rows = [["A%d" % (k // 3)] + r for k, r in enumerate(cloud(chance))]
        sums = [[w] + r for w, r in zip(words, cloud(chance, len(words)))]
        rows = sums + rows if where == "head" else rows + sums
        line = 2 if where == "head" else 62
        words_of = "a row called \"%s\"" if len(words) == 1 else \
            "%d rows, the first one called \"%%s\"," % len(words)
        for by in range(2):  # the column of words may be the last one
            got = said(text([r[by:] + r[:by] for r in rows],
                            "x,y,z,T,hole" if by else "hole,x,y,z,T"),
                       *["-cols", "x,y,z,T"][:seed % 2 * 2])
            assert "f.csv:%d: %s" % (line, words_of % words[0]) in got


@pytest.mark.parametrize("labels", [
    ["Total", "Dissolved"], ["min", "max", "mean"], ["Sand", "Summer"], ["mean"],
    ["Maxwell", "Minnie", "Average Joe", "Count Basie"]], ids="-".join)
def test_words_that_are_classes_are_not(said, labels):
    for seed in range(10):
        chance = random.Random(seed)
        rows = [r + [chance.choice(labels)] for r in cloud(chance)]
        if seed % 2:
            rows.sort(key=lambda r: r[-1])
        assert "called" not in said(text(rows, "x,y,z,T,what"))


def test_a_sum_in_the_midst_is_not(said):
    rows = [["A%d" % k] + r for k, r in enumerate(cloud(random.Random(1)))]
    rows[30][0] = "Total"
    assert "called" not in said(text(rows, "hole,x,y,z,T"))


# ---- a line that numbers the columns ----

@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize("columns", [3, 4, 7])
def test_a_line_that_numbers_columns_is_told(said, columns, first):
    names = "x,y,z,a,b,c,d"[:2 * columns - 1]
    for seed in range(6):
        rows = [r[:3] + (columns - 3) * r[3:] for r in cloud(
            random.Random(seed), 60, *([0, 900], [-5, 10], [4e5, 5e5])[seed % 3])]
        head = [[first + k for k in range(columns)]]
        for name in names, "":
            got = said(text(head + rows, name))
            assert ("f.csv:%d: %d, %d, %d" % (1 + bool(name), first, first + 1,
                                             first + 2) in got)
            assert "number the columns" in got
        assert "number the columns" not in said(text(rows[:1] + head + rows[1:],
                                                     names))


def test_whole_numbers_that_go_on_are_points(said):
    for columns in 3, 4, 5, 7:
        rows = [[columns * k + j for j in range(columns)] for k in range(9)]
        assert "number the columns" not in said(text(rows, "x,y,z,a,b,c,d"[
            :2 * columns - 1]))
    grid = [[x, y, z] for x in (1, 2, 3) for y in (2, 3, 4) for z in (3, 4, 5)]
    assert "number the columns" not in said(text(grid, "x,y,z"))


# ---- dates ----

ORDERS = {"year, month, day": (0, 1, 2), "day, month, year": (2, 1, 0),
          "month, day, year": (1, 2, 0)}


@pytest.mark.parametrize("clock", [0, 2, 3])
@pytest.mark.parametrize("order", ORDERS)
def test_dates_are_told(said, order, clock):
    for seed in range(5):
        chance = random.Random(seed)
        year = chance.randrange(1900, 2030)
        rows = []
        for row in cloud(chance):
            date = [year + chance.randrange(3), chance.randrange(1, 13),
                    chance.randrange(1, 32)]
            time = [chance.randrange(24), chance.randrange(60),
                    chance.randrange(60)][:clock]
            rows.append([date[k] for k in ORDERS[order]] + time + row)
        behind = 4 + clock
        answer = "-cols %d,%d,%d\n" % (behind, behind + 1, behind + 2)
        got = said(text(rows))
        assert "the first point is %d, %d, %d, which may be a date; if so: %s" % (
            *rows[0][:3], answer) in got
        assert "date" not in said(text(rows), "-cols", answer[6:-1])
        # names decide
        names = ",".join(order.replace(" ", "").split(",") + ["h", "mi", "s"][
            :clock]) + ",x,y,z,T"
        assert "date" not in said(text(rows, names))


def test_dates_in_one_number_are_told(said):
    for seed in range(5):
        chance = random.Random(seed)
        rows = [["2019%02d%02d" % (chance.randrange(1, 13), chance.randrange(
            1, 29))] + r for r in cloud(chance)]
        assert "which may be a date; if so: -cols 2,3,4\n" in said(text(rows))


@pytest.mark.parametrize("low", [(1900, 1, 1), (2000, 3, 2), (0, 0, 0),
                                 (500, 1, 1), (2150, 5, 20)])
def test_grids_are_no_dates(said, low):
    for seed in range(5):
        chance = random.Random(seed)
        side = [chance.randrange(2, 9) for _ in range(3)]
        rows = [[low[0] + i, low[1] + j, low[2] + k, chance.random()]
                for i in range(side[0]) for j in range(side[1])
                for k in range(side[2])]
        assert "date" not in said(text(rows))


def test_places_in_metres_are_no_dates(said):
    for seed in range(20):
        chance = random.Random(seed)
        rows = [[chance.randrange(1900, 2100), chance.randrange(100),
                 chance.randrange(30), chance.random()] for _ in range(60)]
        assert "date" not in said(text(rows))
        rows = [[chance.randrange(18000000, 22000000), chance.randrange(100),
                 chance.randrange(30), chance.random()] for _ in range(60)]
        assert "date" not in said(text(rows))


# ---- points between thousands ----

@pytest.mark.parametrize("column", range(4))
def test_points_between_thousands_are_told(said, column):
    for seed in range(10):
        chance = random.Random(seed)
        rows = cloud(chance)
        for row in rows:
            n = chance.randrange(300, 3000)
            row[column] = "%d" % n if n < 1000 else "%d.%03d" % divmod(n, 1000)
        assert "if points separate thousands" in said(text(rows, "x,y,z,T"))


@pytest.mark.parametrize("form", ["%.3f", "%.0f", "%.3g", "%.4g", "%.5g", "%g",
                                  "%.2f", "%.6g"])
@pytest.mark.parametrize("high", [1, 9, 60, 1000, 5000, 1e6])
def test_other_numbers_are_not(said, form, high):
    for seed in range(5):
        chance = random.Random(seed)
        rows = [row[:3] + [form % chance.uniform(0, high)]
                for row in cloud(chance)]
        assert "thousands" not in said(text(rows, "x,y,z,T"))


def test_metres_and_their_eighths_are_not(said):
    for parts in 2, 4, 8, 10, 20:
        chance = random.Random(parts)
        rows = [row[:3] + [chance.randrange(2000) / parts]
                for row in cloud(chance)]
        assert "thousands" not in said(text(rows, "x,y,z,T"))


# ---- 0, 0 among longitudes and latitudes ----

LANDS = [(-10, 20, 45, 70), (-125, -66, 25, 49), (113, 153, -43, -11),
        (170, 180, -48, -34)]


@pytest.mark.parametrize("west, east, south, north", LANDS)
@pytest.mark.parametrize("many", [1, 2, 5])
def test_places_that_are_null_are_told(said, west, east, south, north, many):
    for seed in range(5):
        chance = random.Random(seed)
        rows = [[round(chance.uniform(west, east), 3), round(chance.uniform(
            south, north), 3), chance.randrange(1, 90), chance.random()]
            for _ in range(80)]
        assert "x, y are 0" not in said(text(rows, "lon,lat,depth,T"))
        lost = sorted(chance.sample(range(80), many))
        for k in lost:
            rows[k][:2] = 0, 0
        got = said(text(rows, "lon,lat,depth,T"))
        told = "f.csv:%d: x, y are 0" % (lost[0] + 2)
        told += " in %d rows, to line %d" % (many, lost[-1] + 2) if many > 1 \
            else ""
        assert told + ", far from all others; if that stands for a missing " \
            "number: -nodata 0\n" in got
        assert "x, y are 0" not in said(text(rows, "lon,lat,depth,T"), "-nodata",
                                        "0")


def test_places_on_the_equator_are_not(said):
    for seed in range(5):
        chance = random.Random(seed)
        grid = [[x, y, chance.randrange(1, 90)] for x in range(0, 30, 3)
                for y in range(0, 20, 2)]
        around = [[round(chance.uniform(-40, 30), 2), round(chance.uniform(
            -30, 20), 2), 5] for _ in range(50)] + [[0, 0, 9]]
        # a buoy there, and others along the equator
        buoys = [[x, 0, z] for x in (-35, -23, -10, 0) for z in range(1, 90, 7)]
        for rows in grid, around, buoys:
            assert "are 0" not in said(text(rows, "lon,lat,depth"))


def test_a_hole_at_the_origin_is_not(said):
    for seed in range(5):
        chance = random.Random(seed)
        rows = []
        for x, y in (0, 0), (120.5, 40.25), (131, 55.5), (118, 71):
            rows += [[x, y, -k - chance.random(), chance.random()]
                     for k in range(12)]
        assert "x, y are 0" not in said(text(rows, "x,y,z,T"))


# ---- longitudes on both sides of where they begin ----

@pytest.mark.parametrize("width", [.1, 5, 40, 80])
@pytest.mark.parametrize("seam", ["Greenwich", "the date line"])
def test_a_seam_is_told(said, seam, width):
    for seed in range(5):
        chance = random.Random(seed)
        rows = [[round(chance.uniform(-width / 2, width / 2), 3), round(
            chance.uniform(40, 60), 3), chance.randrange(1, 90)]
            for _ in range(60)]
        near = said(text(rows, "lon,lat,depth"))
        if seam == "Greenwich":
            larger = sum(r[0] < 0 for r in rows)
            rows = [[r[0] % 360] + r[1:] for r in rows]
        else:
            larger = sum(r[0] < 0 for r in rows)
            rows = [[r[0] + (180 if r[0] < 0 else -180)] + r[1:] for r in rows]
        got = said(text(rows, "lon,lat,depth"))
        assert "take 360 from the larger ones (%d)" % larger in got
        assert "take 360" not in near
        assert "take 360" not in said(text(rows, "x,y,z"))


def test_the_whole_globe_has_no_seam(said):
    for seed in range(5):
        for low in -180, 0:
            chance = random.Random(seed)
            rows = [[round(chance.uniform(low, low + 360), 3), round(
                chance.uniform(-60, 60), 3), 5] for _ in range(60)]
            assert "take 360" not in said(text(rows, "lon,lat,depth"))
        rows = [[chance.choice([-100, 0, 100]) + chance.random(), 40 +
                 chance.random(), 5] for _ in range(60)]
        assert "take 360" not in said(text(rows, "lon,lat,depth"))


# ---- duplicates, words ----

@pytest.mark.parametrize("others", [0, 1, 4])
def test_duplicates_with_other_values_are_counted(tess, tmp_path, others):
    rows = cloud(random.Random(others))
    twice = [list(r) for r in rows[:9]]
    for row in twice[:others]:
        row[3] += 1
    (tmp_path / "f.csv").write_text(text(rows + twice, "x,y,z,T"))
    told = ", %d with other values" % others if others else ""
    done = tess("-q", "f.csv")
    assert done.err == "tess: f.csv: 9 duplicates: points where another one " \
        "lies%s\n" % told
    assert "\nduplicates    9%s\n" % told in tess("f.csv").out
    done = tess("-grid", "2,2,2", "-values", "v.csv", "f.csv")
    assert ("%d of the points lie where another one does, with other values: the "
            "mean" % others in done.err) == (others > 0)


ALIKE = [["Sand", "sand"], ["Fine sand", "Finesand"], ["CLAY", "clay ", "Clay"],
         ["BH 1", "bh1"]]
OTHERS = [["Sand", "Sands"], ["Co", "CO"], ["A", "a"], ["BH1", "BH11"],
          ["Sand", "Silt", "Clay"]]


@pytest.mark.parametrize("words", ALIKE + OTHERS, ids="-".join)
def test_words_that_are_alike_are_told(said, words):
    alike = words in ALIKE
    for seed in range(3):
        rows = [r[:3] + ['"%s"' % words[k % len(words)]]
                for k, r in enumerate(cloud(random.Random(seed)))]
        random.Random(seed).shuffle(rows)
        content = text(rows, "x,y,z,rock")
        got = said(content, "-method", "nearest", "-grid", "2,2,2", "-values",
                   "v.csv")
        assert ("f.csv: rock: \"" in got and "as two words" in got) == alike
        got = said(text([r[:3] + [1] + r[3:] for r in rows], "x,y,z,T,rock"),
                   "-by", "rock", "-validate", "2")
        assert ("f.csv: rock: \"" in got and "as two words" in got) == alike
        assert "two words" not in said(content)


# ---- names ----

@pytest.mark.parametrize("between", [",", ";", "\t", " "])
@pytest.mark.parametrize("names", [
    "x,y,z,2019,2020", "[x],[y],[z],[Au]", "lon,lat,depth,0,10,20",
    "easting,northing,rl,1.5", "[easting],[northing],[rl]"])
def test_names_in_brackets_and_numbers(said, names, between):
    wide = names.count(",") - 2
    rows = [r[:3] + wide * r[3:] for r in cloud(random.Random(wide), 9, 1, 80)]
    head = names.split(",")
    got = said(text([head] + rows, between=between), "-node", "n.node")
    with open("n.node") as f:
        points = [s.split()[1:] for s in f.readlines()[1:] if s[0] != "#"]
    assert [[float(x) for x in p[:3]] for p in points] == [r[:3] for r in rows]
    # and they are names, by which columns are chosen
    got = said(text([head] + rows, between=between), "-cols", ",".join(
        h.strip("[]") for h in head[1::-1] + head[2:3]), "-node", "n.node")
    with open("n.node") as f:
        points = [s.split()[1:] for s in f.readlines()[1:] if s[0] != "#"]
    assert [[float(x) for x in p[:3]] for p in points] == [
        [r[1], r[0], r[2]] for r in rows]
    assert "left out" not in got


@pytest.mark.parametrize("bad", ["x", "abc", "two words", "n/a?"])
def test_a_word_in_the_first_row_is_no_name(tess, tmp_path, bad):
    for column in range(4):
        rows = cloud(random.Random(1), 9)
        rows[0][column] = bad
        for names in "", "x,y,z,T":
            (tmp_path / "f.csv").write_text(text(rows, names))
            done = tess("f.csv")
            assert done.code == 2 and '"%s": not a number' % bad in done.err


@pytest.mark.parametrize("names", [
    "HOLE,FROM,TO,AU", "HOLE,from_m,to_m,AU,CU,AG", "BHID,Depth_From,Depth_To,Au",
    "HoleID,SampFrom,SampTo,Au ppm,Cu pct"])
def test_intervals_have_no_coordinates(tess, tmp_path, names):
    wide = names.count(",")
    rows = [["A%d" % (k // 10), k % 10, k % 10 + 1] + (wide - 2) * [k * k % 7]
            for k in range(40)]
    (tmp_path / "f.csv").write_text(text(rows, names))
    done = tess("-q", "f.csv")
    assert done.code == 2 and "desurvey them first" in done.err
    for k, name in enumerate(names.split(",")):
        assert "column %d, %s: " % (k + 1, name) in done.err
    assert not re.search(r"-cols \d", done.err)
    # but beside coordinates, or by -cols, they are values
    (tmp_path / "f.csv").write_text(text(
        [r + p[:3] for r, p in zip(rows, cloud(random.Random(1), 40))],
        names + ",x,y,z"))
    assert tess("-q", "f.csv").code == 0
    assert tess("-q", "-cols", "2,3,4", "f.csv").code == 0


@pytest.mark.parametrize("group", [2, 3, 10])
def test_cells_that_were_merged(tess, tmp_path, group):
    rows = cloud(random.Random(1))
    for k, row in enumerate(rows):
        row.append("A%d" % (k // group) if k % group == 0 else "")
    (tmp_path / "f.csv").write_text(text(rows, "x,y,z,T,hole"))
    done = tess("-by", "hole", "-validate", "3", "f.csv")
    assert done.code == 2 and "merged cells?" in done.err
    assert "-skip" not in done.err
    rows[2][4] = rows[7][4] = ""
    for k, row in enumerate(rows):
        row[4] = "" if k in (2, 7) else "A"
    (tmp_path / "f.csv").write_text(text(rows, "x,y,z,T,hole"))
    done = tess("-by", "hole", "-validate", "3", "f.csv")
    assert done.code == 2 and "(-skip drops" in done.err


# ---- units below names ----

UNITS = {"m": 1, "km": 1000, "ft": .3048, "mm": .001}


@pytest.mark.parametrize("form", ["%s", "(%s)", "[%s]"])
@pytest.mark.parametrize("across", UNITS)
@pytest.mark.parametrize("up", UNITS)
def test_units_below_names(said, up, across, form):
    rows = cloud(random.Random(1), 9)
    units = [form % u for u in (across, across, up)]
    for last in [form % "ppm"], ["-"], [""], []:
        for option in [], ["-cols", "x,y,z,T"]:
            got = said(text([units + last] + rows, "x,y,z,T"), *option)
            assert ("are in %s, %s, %s, and the mesh takes them as the same: "
                    "-scale 1,1,%.6g makes them so" % (
                        across, across, up, UNITS[up] / UNITS[across])
                    in got) == (up != across), got


@pytest.mark.parametrize("second", ["m,km,rock,T", "a,b,c,d"])
def test_other_lines_below_names_are_no_units(said, second):
    rows = [second.split(",")] + cloud(random.Random(1), 9)
    assert "are in" not in said(text(rows, "x,y,z,T"))
