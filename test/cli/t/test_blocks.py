"""test_blocks.py - block models by build/tess, from samples to blocks, and places of
a file with what else is there, beside NumPy and SciPy."""
import pytest

from beside import (BOX, by_vtk, chance, linear, listed, load, np, same, save, scipy,
                    words)

# ---- drill holes in UTM coordinates, as a geologist has them ----

random = chance(54)
COLLAR = random.random((40, 2)) * (900, 700) + (512345, 7654321)
LEAN = random.normal(size=(40, 3)) * (4, 4, .5) + (0, 0, -3)
P = np.round((np.column_stack((COLLAR, np.full(40, 300.)))[:, None] +
              np.arange(25)[None, :, None] * LEAN[:, None]).reshape(-1, 3), 3)
AU = np.round(np.exp(np.sin(P[:, 0] / 90) + P[:, 2] / 200), 4)
CU = np.round(np.cos(P[:, 1] / 120), 4)
ENDS = 512300, 513260, 7654300, 7655020, 220, 305
BLOCKS = ["-step", "20,30,10", "-grid", listed(ENDS)]


def centres(low, high, step):
    """Of blocks, as [z, y, x, axis]."""
    axis = [a + s * (np.arange(int(np.floor((b - a) / s + 0.5))) + 0.5)
            for a, b, s in zip(low, high, step)]
    return np.stack(np.meshgrid(*axis[::-1], indexing="ij")[::-1], -1)


Q = centres(ENDS[::2], ENDS[1::2], (20, 30, 10))


@pytest.fixture(scope="module")
def model():
    """What is linear at the blocks' centres, which of these are inside, and how far
    from a sample.  (SciPy errs where coordinates are large: as seen from their
    middle.)"""
    middle = P.mean(0)
    want = linear(P - middle, np.c_[AU, CU], Q - middle)
    return want, ~np.isnan(want[..., 0]), scipy().spatial.cKDTree(P).query(Q)[0]


@pytest.fixture
def holes(tmp_path):
    (tmp_path / "holes.csv").write_text("hole,x,y,z,au,cu\n" + "".join(
        "DH-%03d,%.3f,%.3f,%.3f,%.4f,%.4f\n" % (k // 25, *a, b, c)
        for k, (a, b, c) in enumerate(zip(P, AU, CU))))
    return "holes.csv"


def test_blocks_are_scipy_s(values, holes, model):
    """so many, where they are: names; the centres, x fastest; the values of .npy"""
    want, inside, _ = model
    got = values(holes, *BLOCKS, "-values", "b.csv")
    assert got.shape == (9, 24, 48, 2)
    same(got, want, 1e-9)
    assert 1000 < inside.sum() < inside.size - 1000
    assert "are 8.5 blocks of 10: 9 are made, to 310" in values.err
    assert "places        %d, without a value %d\n" % (
        inside.size, (~inside).sum()) in values.out
    names, rows = load("b.csv")
    assert names == ["x", "y", "z", "au", "cu"]
    same(rows, np.c_[Q.reshape(-1, 3), got.reshape(-1, 2)])


@pytest.mark.parametrize("D", [None, 15, 40, 1000])
def test_within_and_drop(run, values, holes, model, D):
    """those with a value, in their order; within: by the distances of samples"""
    _, inside, far = model
    got = values(holes, *BLOCKS)
    within = [] if D is None else ["-within", D]
    w = values(holes, *BLOCKS, *within)
    done = run(*BLOCKS, *within, "-drop", "-values", "d.csv", holes)
    keep = inside & (far <= (D or np.inf))
    same(w, np.where(keep[..., None], got, np.nan))
    same(load("d.csv")[1], np.c_[Q[keep], got[keep]])
    assert "without a value %d\n" % (~keep).sum() in done.out
    assert 0 < keep.sum() < inside.size - 1000 and (D == 1000 or D is None or
                                                    keep.sum() < inside.sum())
    assert (far <= (D or np.inf)).sum() > keep.sum()


@pytest.mark.parametrize("method", ["smooth", "natural", "nearest"])
def test_within_is_also_outside_of_the_hull(values, holes, model, method):
    _, inside, far = model
    options = ["-method", method, "-outside", "nearest", *BLOCKS]
    whole = values(holes, *options)
    assert not np.isnan(whole).any() and (~inside & (far <= 40)).sum() > 50
    same(values(holes, *options, "-within", 40),
         np.where((far <= 40)[..., None], whole, np.nan))


def test_within_and_a_value_outside(values, holes, model):
    """NaN far from all points, the value elsewhere"""
    want, inside, far = model
    got = values(holes, *BLOCKS)
    same(values(holes, "-outside", -1, *BLOCKS, "-within", 40), np.where(
        (far > 40)[..., None], np.nan, np.where(inside[..., None], got, -1)))


def test_within_is_a_length_of_what_is_stretched(values, holes):
    got = values(holes, "-scale", "1,1,5", "-outside", "nearest", *BLOCKS, "-within", 60)
    away = scipy().spatial.cKDTree(P * (1, 1, 5)).query(Q * (1, 1, 5))[0]
    assert (np.isnan(got[..., 0]) == (away > 60)).all() and 0 < (away > 60).sum() < Q.size


@pytest.fixture
def cube(tmp_path):
    return save("cube.csv", 8 * BOX, 8 * BOX[:, 0], names="x,y,z,v")


def test_within_is_not_farther(values, cube):
    at = [[3, 4, 0], [4, 4, 0], [3.0000000000000004, 4, 0]]
    assert list(np.isnan(values(cube, "-within", 5, at=at)[:, 0])) == [False, True, True]


def test_centres_of_blocks(run, cube):
    """X0 + (i + 1/2) SX, whatever X0 is; one block, a slice"""
    run("-q", "-step", ".1,.1,.1", "-grid", "0,.7,.1,.8,.35,.45", "-values", "s.csv",
        "-values", "s.svg", "-values", "s.vtk", cube)
    rows = load("s.csv")[1]
    assert len(rows) == 49
    same(rows[:, :3], centres((0, .1, .35), (.7, .8, .45), (.1, .1, .1)).reshape(-1, 3))
    data = by_vtk("s.vtk")
    same(data.points, rows[:, :3], 1e-15)
    assert data.set.GetSpacing() == (.1, .1, .1)
    same(data.values["v"], rows[:, 3])


def test_blocks_in_a_plane(values):
    name, middle = save("flat.csv", P[:, :2], AU, names="x,y,au"), P.mean(0)[:2]
    q = Q[0, ..., :2]
    want = linear(P[:, :2] - middle, AU, q - middle)
    want[scipy().spatial.cKDTree(P[:, :2]).query(q)[0] > 50] = np.nan
    same(values(name, "-cols", "x,y,au", "-step", "20,30", "-grid", listed(ENDS[:4]),
                "-within", 50)[..., 0], want, 1e-9)
    assert 0 < np.isnan(want).sum() < want.size


# ---- places of a file, with columns that come back as they are ----

CLOUD = chance(2).random((400, 3))
T = CLOUD @ (2, -3, .5)


def test_three_names_in_cols_are_a_plane_where_nothing_else_is_there(run):
    out = run("-q", "-validate", "-cols", "x,y,z", save("three.csv", CLOUD)).out
    assert out.splitlines()[1].split()[:2] == ["linear", "z"]


@pytest.mark.parametrize("separator, header, times, drop", [
    (*form, 1, drop) for form in ((",", True), (",", False), (";", True), ("\t", True))
    for drop in ([], ["-drop"])] + [(",", True, 280, ["-drop"]), pytest.param(
        ",", True, 280, [], marks=pytest.mark.long)])
def test_other_columns_come_back(run, tmp_path, separator, header, times, drop):
    """verbatim; 140000 places are so many that they are kept in a file"""
    q = np.round(chance(3).random((500, 3)) * 1.2 - .1, 6)
    rows, others = [], []
    for i, x in enumerate(q):
        text = ["007", "1.50", "1e3", "-0", "+2", "0x1F"][i % 6]
        note = ['a b', '', 'n/a', '"c, d"', 'x', '"say ""hi"""'][i % 6] \
            if separator == "," else "w%d" % i
        others.append("DH-%05d,%s,%s" % (i, text, note))
        rows.append(separator.join(["DH-%05d" % i, "%.6f" % x[0], text, "%.6f" % x[1],
                                    "%.6f" % x[2], note]) + "\n")
    head = separator.join(["id", "lon", "from", "lat", "depth", "note"]) + "\n"
    (tmp_path / "places").write_text(header * head + "".join(rows) * times)
    save("points.csv", CLOUD, T)
    run(*drop, "-query", "places", "-qcols", "2,4,5", "-values", "q.csv", "-values",
        "again.csv", "-values", "q.npy", "points.csv")
    text = (tmp_path / "q.csv").read_text()
    assert (tmp_path / "again.csv").read_text() == text
    want = linear(CLOUD, T, q)
    same(np.load("q.npy")[:, 0], np.tile(want, times), 1e-12)
    keep = ~np.isnan(want) | (not drop)
    assert 50 < np.isnan(want).sum() < 450
    names, _, body = text.partition("\n")
    assert names == "x,y,z,%s,T" % ("id,from,note" if header else
                                    "column1,column3,column6")
    once = body[:len(body) // times]
    assert once * times == body
    got = once.splitlines()
    assert [line.split(",", 3)[3].rpartition(",")[0] for line in got] == [
        o for o, k in zip(others, keep) if k]
    number = np.array([line.split(",")[:3] + [line.rpartition(",")[2]] for line in got],
                      float)
    same(number[:, :3], q[keep])
    same(number[:, 3], want[keep], 1e-12)


@pytest.mark.parametrize("given, options, there", [
    # places that -skip drops
    ("x,y,z,id\n.5,.5,.5,1.50\n.4,,.4,2.50\n.3,.3,.3,003\n", ["-skip", "-digits", 3],
     [["x", "y", "z", "id"], ["0.5", "0.5", "0.5", "1.50"], ["0.3", "0.3", "0.3", "003"]]),
    # a column that is empty here and there
    ("x,y,z,note\n" + "".join(".5,.%d,.5,%s\n" % (i + 3, n) for i, n in enumerate(
        ["", "a", "", "b", ""])), [],
     [["x", "y", "z", "note"]] + [["0.5", "0.%d" % (i + 3), "0.5", n] for i, n in enumerate(
         ["", "a", "", "b", ""])]),
    (".5 .5 .5\n.4 .4 .4\n", [], [["x", "y", "z"], ["0.5"] * 3, ["0.4"] * 3])], ids=[
        "-skip", "empty", "none"])
def test_other_columns_stay_beside_their_places(run, tmp_path, given, options, there):
    (tmp_path / "places.csv").write_text(given)
    run(*options, "-query", "places.csv", "-values", "q.csv", save("points.csv", CLOUD, T))
    rows = words("q.csv")
    assert [r[:-1] for r in rows] == there and rows[0][-1] == "T"
    for r in rows[1:]:
        assert float(r[-1]) == pytest.approx(np.dot((2, -3, .5), [float(a) for a in r[:3]]),
                                             abs=1e-3)


def test_points_other_columns_are_in_errors(run, tmp_path):
    """in front of the values"""
    p = np.vstack((CLOUD, CLOUD[:7]))
    (tmp_path / "groups.csv").write_text("x,y,z,T,hole,no\n" + "".join(
        "%.17g,%.17g,%.17g,%.9f,H %d,%03d\n" % (*a, a @ (2, -3, .5), i // 8, i)
        for i, a in enumerate(p)))
    run("-validate", 5, "-by", "hole", "-cols", "x,y,z,T", "-errors", "e.csv",
        "groups.csv")
    head, *rows = words("e.csv")
    assert head == ["x", "y", "z", "fold", "hole", "no", "T",
                    "linear-T (predicted minus measured)"]
    assert [r[4:6] for r in rows] == [["H %d" % (i // 8), "%03d" % i] for i in range(400)]
    same(np.array([r[6] for r in rows], float), T, 1e-8)
    assert len({(r[3], r[4]) for r in rows}) == 50
