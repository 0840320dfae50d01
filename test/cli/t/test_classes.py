"""Values that are words: -method nearest gives the nearest point's."""
import csv
import random

import pytest

np = pytest.importorskip("numpy")
WORDS = ["granite, red", "schist", 'say "hi"', "Öl", "a#b", "1a", "x y", "N/S"]
OTHER = "-method nearest takes words as values"


def samples(seed, n, words=WORDS):
    """hole,x,y,z,rock,au: places that have one nearest point"""
    chance = random.Random(seed)
    return [["h%d" % (k % 7)] + [round(chance.uniform(0, 100), 3)
                                 for _ in range(3)] +
            [chance.choice(words), round(chance.random(), 3)]
            for k in range(n)]


def write(path, rows):
    with open(path, "w", newline="") as f:
        out = csv.writer(f, lineterminator="\n")
        out.writerow(["hole", "x", "y", "z", "rock", "au"])
        out.writerows(rows)


def read(path):
    with open(path, newline="") as f:
        return list(csv.DictReader(f))


def nearest(rows, place, among=None):
    at = [k for k in range(len(rows)) if among is None or among[k]]
    p = np.array([rows[k][1:4] for k in at])
    return at[int(np.argmin(((p - place) ** 2).sum(1)))]


@pytest.mark.parametrize("cols", [[], ["-cols", "x,y,z,rock"],
                                  ["-cols", "x,y,z,au,rock,hole"]])
def test_words_are_the_nearest_points(tess, tmp_path, cols):
    for seed in range(3):
        rows = samples(seed, 200)
        write("f.csv", rows)
        done = tess("-q", "-method", "nearest", *cols, "-grid", "5,4,3",
                    "-outside", "nearest", "-values", "o.csv", "f.csv")
        assert done.code == 0, done.err
        got = read("o.csv")
        assert len(got) == 60
        inside = 0
        for row in got:
            place = [float(row[k]) for k in "xyz"]
            # (outside the hull a place has the value of its foot there)
            if not all(20 < x < 80 for x in place):
                continue
            inside += 1
            want = rows[nearest(rows, place)]
            assert row["rock"] == want[4]
            if "au" in row:
                assert float(row["au"]) == want[5]
                assert row["hole"] == want[0]
        assert inside >= 6


def test_outside_there_is_no_word(tess, tmp_path):
    write("f.csv", samples(1, 50))
    for outside in [], ["-outside", "1"]:
        tess("-q", "-method", "nearest", *outside, "-grid", "-50:150:3,"
             "-50:150:3,-50:150:3", "-values", "o.csv", "f.csv")
        got = read("o.csv")
        assert [r["rock"] for r in got].count("") == 26
        assert [r["au"] for r in got].count("1" if outside else "nan") == 26


def test_numbers_of_words_are_told(tess, tmp_path):
    rows = samples(2, 60)
    write("f.csv", rows)
    done = tess("-q", "-method", "nearest", "-cols", "x,y,z,rock", "-grid",
                "4,4,4", "-outside", "nearest", "-values", "o.npy", "-values",
                "o.csv", "f.csv")
    told = {}
    for line in done.err.splitlines():
        assert line.startswith("tess: rock: ")
        number, _, word = line[12:].partition(" is ")
        told[int(number)] = word.rpartition(", where numbers are written")[0]
    assert sorted(told.values()) == sorted({r[4] for r in rows})
    assert [told[int(x)] for x in np.load("o.npy").ravel()] == [
        r["rock"] for r in read("o.csv")]
    done = tess("-q", "-method", "nearest", "-cols", "x,y,z,rock", "-grid",
                "4,4,4", "-values", "o.csv", "f.csv")
    assert "where numbers" not in done.err


@pytest.mark.parametrize("by", [[], ["-by", "hole"]])
def test_confusion(tess, tmp_path, by):
    rows = samples(3, 150)
    write("f.csv", rows)
    done = tess("-q", "-method", "nearest", "-cols", "x,y,z,rock,au",
                "-validate", "5", *by, "-outside", "nearest", "-errors",
                "e.csv", "f.csv")
    got = read("e.csv")
    fold = [r["fold"] for r in got]
    pairs = {}
    for k, (row, error) in enumerate(zip(rows, got)):
        assert error["rock"] == row[4]
        if by:
            assert all((fold[j] == fold[k]) for j in range(150)
                       if rows[j][0] == row[0])
        if all(20 < x < 80 for x in row[1:4]):
            best = rows[nearest(rows, row[1:4], [f != fold[k] for f in fold])]
            assert error["nearest-rock (predicted)"] == best[4]
            assert abs(float(error["nearest-au (predicted minus measured)"]) -
                       best[5] + row[5]) < 1e-12
        at = error["rock"], error["nearest-rock (predicted)"]
        pairs[at] = pairs.get(at, 0) + 1
    lines = done.out.splitlines()
    at = lines.index("rock, measured; predicted:")
    words = sorted({r[4] for r in rows}, key=[r[4] for r in rows].index)
    width = max([9] + [len(w.encode()) for w in words])
    assert lines[at + 1].split() == " ".join(words).split()
    for word, line in zip(words, lines[at + 2:]):
        line = line.encode()
        assert line[:width].decode() == word + " " * (width - len(
            word.encode()))
        assert list(map(int, line[width:].split())) == [
            pairs.get((word, other), 0) for other in words]
    right = sum(n for (a, b), n in pairs.items() if a == b)
    assert lines[at + 2 + len(words)] == \
        "rock: %d of 150 right (%.1f %%), %s outside" % (
            right, right / 1.5, lines[-1].split()[-2])
    # of numbers there is the table of errors, as ever
    assert lines[1].startswith("nearest  au ")


def test_many_words_have_no_table(tess, tmp_path):
    write("f.csv", samples(4, 400, ["w%d" % k for k in range(200)]))
    done = tess("-q", "-method", "nearest", "-cols", "x,y,z,rock", "-validate",
                "f.csv")
    assert "too many words for a table" in done.out
    assert "predicted" not in done.out


@pytest.mark.parametrize("method", [[], ["-method", "linear"],
                                    ["-method", "nearest,linear", "-validate"]])
def test_other_methods_say_so(tess, tmp_path, method):
    write("f.csv", samples(5, 50))
    use = method if "-validate" in method else method + [
        "-grid", "2,2,2", "-values", "o.csv"]
    done = tess("-q", *use, "f.csv")
    assert done.code == 0
    assert "tess: f.csv: column 5, rock (" in done.err
    assert done.err.count("is not a number: skipped; " + OTHER) == 2
    done = tess("-q", *use, "-cols", "x,y,z,rock", "f.csv")
    assert done.code == 2 and done.err.endswith(OTHER + "\n")


def test_places_that_are_the_same(tess, tmp_path):
    rows = samples(6, 50)
    rows.append(rows[3][:4] + ["another", .5])
    write("f.csv", rows)
    done = tess("-q", "-method", "nearest", "-cols", "x,y,z,rock", "-grid",
                "2,2,2", "-values", "o.csv", "f.csv")
    assert "tess: 1 word of points where another one lies is another word: " \
        "the first point's is taken\n" in done.err


def test_empty_words(tess, tmp_path):
    rows = samples(7, 50)
    rows[9][4] = ""
    write("f.csv", rows)
    use = ["-q", "-method", "nearest", "-grid", "2,2,2", "-values", "o.csv"]
    done = tess(*use, "f.csv")
    assert (done.code, done.err.count("column 5, rock: empty")) == (2, 1)
    done = tess(*use, "-skip", "f.csv")
    assert done.code == 0 and "1 row dropped (1 empty)" in done.err


def test_no_surface_of_words(tess, tmp_path):
    write("f.csv", samples(8, 50))
    done = tess("-method", "nearest", "-cols", "x,y,z,rock", "-grid", "2,2,2",
                "-values", "o.csv", "-iso", "1", "s.stl", "f.csv")
    assert done.code == 2 and "has words, of which -iso is no surface" in done.err


def test_in_a_plane(tess, tmp_path):
    rows = samples(9, 80)
    with open("f.csv", "w", newline="") as f:
        csv.writer(f).writerows([["x", "y", "rock"]] + [
            [r[1], r[2], r[4]] for r in rows])
    done = tess("-q", "-method", "nearest", "-cols", "x,y,rock", "-validate",
                "f.csv")
    assert done.code == 0 and "rock, measured; predicted:\n" in done.out
