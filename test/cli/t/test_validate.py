"""test_validate.py - cross-validation by build/tess, beside a direct leave-out."""
import re

import pytest

from beside import (METHODS, bent, chance, flat, lattice, linear, nearest, np, same,
                    save, scipy, words)

BEHIND = " (predicted minus measured)"
POINTS = chance(1).random((200, 3))
T, U = bent(POINTS), 100 * flat(POINTS) ** 2


@pytest.fixture
def table(run):
    """table(*arguments): what -validate prints by -q, by method and column, the numbers and
    where the worst is; table.best and table.beyond, its last lines; table.err"""
    def table(*arguments):
        done = run("-q", *arguments)
        table.err = done.err
        rows = done.out.splitlines()
        assert rows[0].split()[:2] == ["method", "column"]
        found, table.best, table.beyond = {}, {}, {}
        for r in rows[1:]:
            w = r.split()
            if r.startswith("best by rms error: "):
                for choice in r[len("best by rms error: "):].split(", "):
                    method, column = choice.split(" for ")
                    table.best[column] = method
            elif r.startswith("beyond the data's range: none"):
                assert not table.beyond
            elif r.startswith("beyond the data's range: "):
                m = re.match(r".*: (\w+) for (.*): (\d+) of (\d+) values, (\S+) "
                             r"to (\S+); the data (\S+) to (\S+) \(see -clip\)$", r)
                table.beyond[m[1], m[2]] = [float(a) for a in m.groups()[2:]]
            elif w:
                assert w[0] in METHODS
                found[w[0], w[1]] = [float(a) for a in w[2:7] + w[7].split(",")]
        return found
    return table


def errors(name):
    head, *rows = words(name)
    return {h: np.array(c) if h == "hole" and not c[0].isdigit() else
            np.array(c, float) for h, c in zip(head, zip(*rows))}


def judged(error, where, inside):
    """what the table has of these errors"""
    error, where = error[inside], where[inside]
    i = np.argmax(np.abs(error))
    return [np.mean(error), np.mean(np.abs(error)), np.sqrt(np.mean(error ** 2)),
            error[i], (~inside).sum(), *where[i]]


def alike(a, b):
    """To the six digits that are printed; a bias, to six of its terms'."""
    for k, (u, v) in enumerate(zip(a[:5], b[:5])):
        assert abs(u - v) <= 2e-5 * max(abs(u), b[1] if k == 0 else 0)
    same(a[5:], b[5:], 1e-8)


def by_chance(n, k):
    """The part of each of n points, by the generator of Park and Miller."""
    order, part, seed = list(range(n)), np.zeros(n, int), 1
    for i in range(n - 1, 0, -1):
        seed = seed * 16807 % (2 ** 31 - 1)
        j = seed % (i + 1)
        order[i], order[j] = order[j], order[i]
    part[order] = np.arange(n) % k
    return part


def predict(values, x, data, part, methods):
    """What the other parts' points predict of each part, by method; which are not
    outside."""
    predicted = {m: np.full(data.shape, np.nan) for m in methods}
    for r in set(part):
        out = part == r
        for m in methods:
            predicted[m][out] = {"linear": linear, "nearest": nearest}.get(
                m, lambda p, v, q: values((p, v), "-method", m, at=q))(
                    x[~out], data[~out], x[out])
    return predicted, ~np.isnan(predicted["linear"][:, 0])


@pytest.mark.parametrize("n, k, which", [
    (200, 10, ["linear", "nearest"]), (200, 7, METHODS), (100, 100, ["linear", "nearest"])])
def test_folds_are_left_out(table, values, n, k, which):
    x, data = POINTS[:n], np.c_[T, U][:n]
    save("left.csv", x, data)
    found = table("-validate", k, "-method", ",".join(which), "-errors", "e.csv",
                  "left.csv")
    e = errors("e.csv")
    part = e["fold"].astype(int) - 1
    # of one size, but for one point; by chance, as everywhere
    sizes = np.bincount(part, minlength=k)
    assert len(sizes) == k and sizes.max() - sizes.min() <= (n % k > 0)
    assert list(part) == list(by_chance(n, k))
    predicted, inside = predict(values, x, data, part, which)
    for m in which:
        for j, name in enumerate("TU"):
            error = (predicted[m] - data)[:, j]
            alike(found[m, name], judged(error, x, inside))
            same(e[m + "-" + name + BEHIND], np.where(inside, error, np.nan),
                 1e-11 * np.abs(data[:, j]).max())
    same(np.transpose([e[h] for h in "xyzTU"]), np.c_[x, data])
    assert table.best == {name: min(which, key=lambda m: np.mean(
        (predicted[m] - data)[inside, j] ** 2)) for j, name in enumerate("TU")}


def test_folds_of_a_lattice_are_no_planes(table):
    """(it is listed x fastest)"""
    p = lattice(10)
    save("lattice.csv", p, np.sin(p[:, 0] / 2) + np.cos(p[:, 1] / 3) * p[:, 2])
    table("-validate", 10, "-method", "linear,nearest", "-errors", "e.csv",
          "lattice.csv")
    part = errors("e.csv")["fold"]
    assert len(set(part)) == 10
    assert all(len(set(p[part == r, k])) > 5 for r in set(part) for k in range(3))


# ---- groups: boreholes, words and numbers, as GroupKFold deals them ----

DEEP = chance(2).integers(8, 30, 23)
HOLE = np.repeat(np.arange(23), DEEP)
HOLES = np.column_stack((
    chance(3).random((23, 2))[HOLE] + 1e-3 * chance(4).random((len(HOLE), 2)),
    -np.concatenate([np.arange(n) / 30 for n in DEEP])))
GRADE = bent(3 * HOLES)


@pytest.fixture(params=["words", "numbers"])
def holes(request, tmp_path):
    """a file of them, in no order"""
    named = request.param == "words"
    rows = ["hole,x,y,z,T\n" if named else "x,y,z,T,hole\n"]
    for i in chance(5).permutation(len(HOLE)):
        row = "%.17g,%.17g,%.17g,%.17g" % (*HOLES[i], GRADE[i])
        k = HOLE[i]
        rows.append("%s %d,%s\n" % ("bh" if k % 2 else "BH", k, row) if named else
                    "%s,%d\n" % (row, k + 5))
    (tmp_path / "holes.csv").write_text("".join(rows))
    return rows


def test_groups_are_left_out(table, values, holes):
    for k in 10, 4:
        found = table("-validate", k, "-by", "hole", "-method", "linear,nearest",
                      "-errors", "e.csv", "holes.csv")
        e = errors("e.csv")
        # the column is no value, but is there
        assert list(e) == ["x", "y", "z", "fold", "hole", "T", "linear-T" + BEHIND,
                           "nearest-T" + BEHIND]
        at = scipy().spatial.cKDTree(HOLES).query(np.transpose([e[h] for h in "xyz"]))[1]
        part = np.zeros(len(HOLE), int)
        part[at] = e["fold"]
        assert all(len(set(part[HOLE == i])) == 1 for i in range(23))
        # as large as GroupKFold's
        filled = np.zeros(k, int)
        for n in sorted(DEEP)[::-1]:
            filled[np.argmin(filled)] += n
        assert sorted(np.bincount(part)[1:]) == sorted(filled)
        predicted, inside = predict(values, HOLES, GRADE[:, None], part,
                                    ["linear", "nearest"])
        for m in predicted:
            alike(found[m, "T"], judged(predicted[m][:, 0] - GRADE, HOLES, inside))
    # larger errors than of parts by chance
    assert found["linear", "T"][2] > 1.5 * table(
        "-validate", 4, "-cols", "x,y,z,T", "holes.csv")["linear", "T"][2]


def test_fewer_groups_than_folds(table, holes):
    table("-validate", 30, "-by", "hole", "-errors", "e.csv", "holes.csv")
    assert "23 folds, each of one group" in table.err
    assert sorted(np.bincount(errors("e.csv")["fold"].astype(int))[1:]) == sorted(DEEP)


@pytest.mark.parametrize("holes", ["numbers"], indirect=True)
def test_groups_by_number(table, tmp_path, holes):
    """-alpha does not matter, which is said; a column without a name; a row without a
    group"""
    table("-validate", 4, "-by", "hole", "-alpha", 1, "-errors", "e.csv", "holes.csv")
    assert "-validate is of the whole hull" in table.err
    (tmp_path / "bare.csv").write_text("".join(holes[1:]))
    table("-validate", 4, "-by", 5, "-errors", "b.csv", "bare.csv")
    assert words("b.csv")[1:] == words("e.csv")[1:]
    (tmp_path / "lost.csv").write_text("".join(
        line if i % 5 else re.sub(",[^,]*$", ",NA\n", line)
        for i, line in enumerate(holes)))
    table("-validate", 4, "-skip", "-by", 5, "-errors", "b.csv", "lost.csv")
    assert len(words("b.csv")) == 1 + sum(i % 5 > 0 for i in range(len(holes)))


def test_place_of_two_groups_is_told_and_counts_once(table):
    rows = np.c_[HOLES, GRADE, HOLE]
    save("both.csv", np.vstack((rows, [*rows[0, :4], HOLE[-1]])), names="")
    table("-validate", 4, "-by", 5, "-errors", "b.csv", "both.csv")
    assert "1 point is at a place of another group" in table.err
    assert len(words("b.csv")) == 1 + len(HOLE)


# ---- values beyond the data's range; -clip holds them ----

@pytest.fixture(scope="module")
def grades():
    """log-normal ones, and their negatives"""
    x = chance(6).random((600, 3))
    f = np.exp(2 * chance(7).standard_normal(600))
    return x, np.c_[f, flat(x), -f]


def test_values_beyond_the_data_s_range(table, values, grades):
    x, data = grades
    save("grades.csv", x, data)
    options = "-validate", 5, "-method", "smooth,linear"
    table(*options, "grades.csv")
    part = by_chance(600, 5)
    predicted, inside = predict(values, x, data, part, ["linear", "smooth"])
    assert list(table.beyond) == [("smooth", "T"), ("smooth", "V")]
    beyond = table.beyond
    found = table(*options, "-clip", "grades.csv")
    assert table.beyond == {}
    for name, j in ("T", 0), ("V", 2):
        s, f = predicted["smooth"][:, j], data[:, j]
        many = ((s < f.min()) | (s > f.max()))[inside].sum()
        assert many > 20 and beyond["smooth", name] == pytest.approx(
            [many, inside.sum(), s[inside].min(), s[inside].max(), f.min(), f.max()],
            rel=1e-5)
        for r in range(5):
            s[part == r] = np.clip(s[part == r], f[part != r].min(), f[part != r].max())
        alike(found["smooth", name], judged(s - f, x, inside))


@pytest.mark.parametrize("outside", ["", "-outside nearest", "-outside -7"])
def test_clip(values, grades, outside):
    x, data = grades
    options = "-q", "-method", "smooth", *outside.split()
    q = chance(8).random((1500, 3))
    s = values((x, data), *options, at=q)
    out = np.isnan(s[:, 0]) | (s[:, 0] == -7)
    same(values((x, data), *options, "-clip", at=q),
         np.where(out[:, None], s, np.clip(s, data.min(0), data.max(0))))
    assert (s[~out] < data.min(0)).any() and (s[~out] > data.max(0)).any()
    assert out.any() == (outside != "-outside nearest")


# ---- units near the ends of the range of numbers ----

def test_errors_are_those_of_usual_units_scaled(table):
    x = POINTS - 0.5
    v = bent(x)
    options = "-validate", "-method", ",".join(METHODS)
    one = table(*options, save("one.csv", x, v))
    for there, by in ((0, 1022), (0, -1000), (1023, 0), (-1000, 0), (1000, 1000),
                      (-1000, -1000), (-1000, 1000)):
        found = table(*options, save("far.csv", np.ldexp(x, there), np.ldexp(v, by)))
        assert list(found) == list(one) and len(one) == 4
        for k in one:
            alike([*np.ldexp(found[k][:4], -by), found[k][4],
                   *np.ldexp(found[k][5:], -there)], one[k])


@pytest.mark.parametrize("told", ["differ too much", "divide the points' values by ten"])
def test_what_cannot_be_scaled_is_refused(tess, told):
    x = POINTS - 0.5
    if "differ" in told:
        save("far.csv", np.vstack((np.ldexp(x, 1020), np.ldexp(x[:9], -600))),
             np.append(T, T[:9]))
    else:
        save("far.csv", x, np.where(chance(9).random(200) < .5, -1.7e308, 1.7e308))
    done = tess("-q", "-validate", "-method", "smooth", "far.csv")
    assert (done.code, done.out) == (2, "") and told in done.err


# ---- duplicates, infinite values, places outside ----

def test_ten_folds_if_no_number_is_given(table):
    save("left.csv", POINTS, T, U)
    assert table("-validate", "left.csv") == table("left.csv", "-validate", 10)


def test_points_outside_count_by_outside_nearest(table):
    save("left.csv", POINTS, T, U)
    size = [table("-validate", *o, "left.csv")["linear", "T"][1] for o in (
        [], ["-outside", "nearest"])]
    assert size[1] > size[0]


def test_duplicate_does_not_predict_its_twin(table):
    save("twins.csv", np.repeat(POINTS, 2, axis=0), np.repeat(T, 2))
    assert table("-validate", 200, "-method", "nearest", "twins.csv")[
        "nearest", "T"][1] > 0.01
    table("-validate", 400, "twins.csv")
    assert "200 folds, each of one place" in table.err


def test_infinite_error_is_the_worst_one(table):
    save("hole.csv", POINTS, np.where(np.arange(200) == 70, np.inf, T), U)
    found = table("-validate", "hole.csv")
    assert not np.isfinite(found["linear", "T"][3])
    assert np.isfinite(found["linear", "U"][3])


# ---- in a plane ----

def test_points_in_a_plane_are_left_out(table):
    f = chance(10).random((100, 2)) * (360, 180) - (180, 90)
    v = np.sin(f[:, 0] / 20) * np.cos(f[:, 1] / 15)
    save("few.csv", f, v, names="lon,lat,temp")
    want = [linear(np.delete(f, i, 0), np.delete(v, i), f[i])[0] - v[i]
            for i in range(100)]
    for options in ["-cols", "lon,lat,temp"], ["-plane"], ["-cols", "lon,lat"]:
        assert [m for m, _ in table(*options, "-validate", "-method",
                                    ",".join(METHODS), "few.csv")] == METHODS
        table(*options, "-validate", 100, "-errors", "e.csv", "few.csv")
        same(list(errors("e.csv").values())[-1], want, 1e-12)


@pytest.mark.parametrize("names", ["EAST,NORTH,RL", "x,y,z", "lon,lat,depth", ""])
def test_places_have_the_names_of_the_file(table, tmp_path, names):
    rows = ["%d,%d,%d,%d" % (*p, sum(p)) for p in np.ndindex(3, 3, 3)]
    (tmp_path / "named.csv").write_text("\n".join(
        [names + ",T"] * bool(names) + rows) + "\n")
    table("-validate", 3, "-errors", "e.csv", "named.csv")
    with open("e.csv", encoding="ascii") as file:
        assert file.readline().split(",fold,")[0] == (names or "x,y,z")
