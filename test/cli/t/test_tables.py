"""What is told of tables that may be misread."""
import random

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
