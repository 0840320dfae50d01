"""Numbers that stand for none are told, with a -nodata that drops them; numbers
that are there often by their nature are not."""
import math
import random
import re

import pytest

TOP = __file__.rpartition("/test/cli/")[0]


def table(rows, names="x,y,z,T"):
    return "".join(s + "\n" for s in [names] + [
        ",".join("%g" % x for x in row) for row in rows])


def advice(said):
    """the numbers of each -nodata that is proposed"""
    return [m.split(",") for m in re.findall(r"-nodata (\S+?)(?: \(|\n)", said)]


def survey(seed, n, mark, column, low, high, share):
    """Points at random, of which some have that number in the column; the lines
    of these."""
    chance = random.Random(seed)
    box = [(0, 100), (0, 100), (0, 50), (1, 9)]
    box[column] = low, high
    rows = [[round(chance.uniform(*b), 2) for b in box] for _ in range(n)]
    marked = sorted(chance.sample(range(n), max(1, round(share * n))))
    for i in marked:
        rows[i][column] = mark
    return rows, [i + 2 for i in marked]


# the mark, the others' range, the share of rows
MARKS = [(-99, 10, 1010, .1), (-9999, 10, 25010, .1), (-9999, 10, 25010, .005),
         (-999, 0, 5e6, .05), (-1, 5, 400, .1), (-5, 1, 1e4, .1),
         (999, 0, 2000, .1), (999, -2000, 2000, .1), (-999.25, 0, 1500, .05),
         (-32768, 0, 1e5, .02), (1e30, 0, 5, .05), (9999, 20, 21, .3)]
OF_Z = [(0, 5, 40, .1), (0, 120, 180, .2), (0, -20, 40, .1),
           (-1, -20, 40, .1), (0, -900, -20, .15)]


@pytest.mark.parametrize("column", range(4))
@pytest.mark.parametrize("mark,low,high,share", MARKS + OF_Z)
def test_told(tess, tmp_path, mark, low, high, share, column):
    if column != 2 and (mark, low, high, share) in OF_Z:
        pytest.skip("other columns than z may be 0 for many reasons")
    for seed in range(5):
        rows, lines = survey(seed, 200, mark, column, low, high, share)
        (tmp_path / "f.csv").write_text(table(rows))
        # (-1 may be near to a number by chance)
        done = tess("-q", "f.csv")
        if done.err.count("-nodata") == 0 and mark in (0, -1) and low < 0:
            assert 2 * seed < 5, "not told"
            continue
        assert advice(done.err) == [["%g" % mark]], done.err
        many = len(lines)
        if column == 3:
            assert "%d value%s of T %s %g," % (
                many, "s" * (many > 1), "are" if many > 1 else "is",
                mark) in done.err
        else:
            assert "f.csv:%d: %s is %g" % (lines[0], "xyz"[column],
                                           mark) in done.err
        done = tess("-q", "-nodata", "%g" % mark, "f.csv")
        assert re.match(r"tess: f.csv: %d rows? dropped .*\n" % many,
                        done.err), done.err
        assert "stand" not in done.err


@pytest.mark.parametrize("mark", [-1, -9, -5, -99, -1.5])
@pytest.mark.parametrize("low, high, decimals", [(0, 9, 2), (1, 9, 1), (300, 999, 0),
                                                 (20, 25, 1), (1, 1e4, 0)])
def test_three_values_below_0(tess, tmp_path, mark, low, high, decimals):
    """are told: whole ones among others that are not, or beyond a gap"""
    if low + mark < 0 and (decimals == 0 or mark % 1):
        pytest.skip("near to the others, and as they are")
    for seed in range(5):
        rows, lines = survey(seed, 200, mark, 3, low, high, .015)
        for i, row in enumerate(rows):
            if i + 2 not in lines:
                row[3] = round(row[3], decimals)
        (tmp_path / "f.csv").write_text(table(rows))
        done = tess("-q", "f.csv")
        assert len(lines) == 3 and advice(done.err) == [["%g" % mark]], done.err


def test_several_at_once(tess, tmp_path):
    rows, lines = survey(1, 200, -99, 2, 10, 1010, .1)
    more = [i for i in range(0, 200, 13)]
    for i in more:
        rows[i][3] = -9999 if i % 2 else 1e30
    rows[5][2] = -999
    (tmp_path / "f.csv").write_text(table(rows))
    done = tess("-q", "f.csv")
    *each, last = advice(done.err)
    assert sorted(sum(each, [])) == sorted(last) == sorted(
        ["-99", "-999", "-9999", "1e+30"])
    dropped = len(set(lines) | {i + 2 for i in more} | {7})
    assert "(it drops %d of 200 rows)" % dropped in done.err
    # as one list, and one by one
    for words in (["-nodata", ",".join(last)],
                  sum((["-nodata", x] for x in last), [])):
        done = tess("-q", *words, "f.csv")
        assert done.err.startswith("tess: f.csv: %d rows dropped" % dropped)
        assert "stand" not in done.err


def test_nodata_takes_no_more_than_it_holds(tess, tmp_path):
    (tmp_path / "f.csv").write_text(table(survey(1, 9, 1, 0, 2, 3, .1)[0]))
    words = sum((["-nodata", "-%d,-%d" % (k, k + 20)] for k in range(9)), [])
    assert tess("-q", *words[:16], "f.csv").code == 0
    done = tess("-q", *words, "f.csv")
    assert (done.code, done.err) == (2, "tess: -nodata: more than 16 numbers\n")


# ---- what must not be told ----

def grid(chance):
    return [(i, j, k, chance.random()) for i in range(-1, 6) for j in range(6)
            for k in range(5)]


def layers(chance):
    return [(chance.random(), chance.random(), z, chance.random())
            for z in (-1, 0, 2, 5) for _ in range(50)]


def sea(chance):
    """land, and the sea, which is 0"""
    places = [(chance.uniform(0, 100), chance.uniform(0, 100))
              for _ in range(300)]
    return [(x, y, max(0, round(30 * math.sin(x / 20) + 20 * math.cos(
        y / 15), 2)), x + 1) for x, y in places]


def hemisphere(chance):
    rows = []
    for k in range(300):
        v = [chance.gauss(0, 1) for _ in range(3)]
        r = math.sqrt(sum(x * x for x in v))
        a, q = chance.uniform(0, 7), math.sqrt(chance.random())
        rows.append((q * math.cos(a), q * math.sin(a), 0, k + 1) if k % 3 == 0
                    else (v[0] / r, v[1] / r, abs(v[2]) / r, k + 1))
    return rows


def collars(chance):
    """holes that are not upright, from 0 down"""
    rows = []
    for _ in range(12):
        x, y, z = chance.uniform(0, 999), chance.uniform(0, 999), 0
        for k in range(12):
            rows.append((x, y, z, chance.uniform(1, 9)))
            x, y = x + chance.random(), y + chance.random()
            z = round(z - 1 - chance.random(), 2)
    return rows


def casts(chance):
    """depths from 0 on, at places that are the same"""
    rows = []
    for _ in range(20):
        x, y, z = chance.uniform(0, 9), chance.uniform(0, 9), 0
        for k in range(10):
            rows.append((x, y, z, chance.uniform(1, 9)))
            z = round(z + chance.uniform(1, 90), 2)
    return rows


def plate(chance):
    return [(chance.random(), chance.random(), 0 if k % 2 else
             chance.uniform(.2, .3), k) for k in range(200)]


def box(chance):
    rows = []
    for k in range(300):
        row = [chance.random() for _ in range(3)] + [k + 1]
        row[k % 3] = k // 3 % 2
        rows.append(row)
    return rows


def rain(chance):
    return [(chance.random(), chance.random(), chance.random(),
             0 if k % 2 else chance.random()) for k in range(200)]


def degrees(chance):
    return [(chance.random(), chance.random(), chance.random(),
             round(chance.gauss(9, 4), 1)) for k in range(200)]


def frost(chance):
    """whole degrees, three of them below 0"""
    return [(chance.random(), chance.random(), chance.random(),
             -1 if k < 3 else chance.randrange(20)) for k in range(200)]


def halves(chance):
    return [(chance.random(), chance.random(), chance.random(),
             -1 if k < 3 else chance.randrange(40) / 2) for k in range(200)]


def noise(chance):
    """groups, and what is in none"""
    return [(chance.random(), chance.random(), chance.random(),
             -1 if k < 3 else chance.randrange(3)) for k in range(200)]


def classes(chance):
    return [(chance.random(), chance.random(), chance.random(),
             chance.choice([-1, 0, 1, 2])) for k in range(200)]


def counts(chance):
    """whole numbers, all of them, 999 and 9999 too"""
    return [(chance.random(), chance.random(), chance.random(),
             k) for k in range(11000)]


def few(chance):
    """the corners of a box, and more"""
    return [(x, y, z, x + y + 5) for x in (-1, 1) for y in (-1, 1)
            for z in (-1, 1)] + [(.5, .25, 0, 7), (0, 0, 0, 8)]


@pytest.mark.parametrize("points", [
    grid, layers, sea, hemisphere, collars, casts, plate, box, rain, degrees,
    frost, halves, noise, classes, counts, few])
def test_not_told(tess, tmp_path, points):
    for seed in range(20 if points is not counts else 1):
        (tmp_path / "f.csv").write_text(table(points(random.Random(seed))))
        done = tess("-q", "f.csv")
        assert "stand" not in done.err, (seed, done.err)


@pytest.mark.parametrize("limit", [">100", "<9999", "<-99", ">-9999"])
def test_limits_are_not_told(tess, tmp_path, limit):
    for seed in range(5):
        rows, lines = survey(seed, 200, 7, 3, 1, 9, .1)
        content = table(rows).splitlines(True)
        for line in lines:
            content[line - 1] = content[line - 1].rpartition(",")[0] + ",%s\n"
        text = "".join(content)
        (tmp_path / "f.csv").write_text(text.replace("%s", limit))
        assert "stand" not in tess("-q", "-below", "1", "f.csv").err
        # (the same number, where it is no limit, is told)
        (tmp_path / "f.csv").write_text(text.replace("%s", limit[1:]))
        assert advice(tess("-q", "f.csv").err) == [[limit[1:]]]


@pytest.mark.parametrize("order", ["1,2,3,4", "2,3,1,4", "3,1,2,4"])
def test_data_is_not_doubted(tess, order):
    done = tess("-q", "-cols", order, TOP + "/test/data/mirror.xyz")
    assert done.code == 0 and "stand" not in done.err
