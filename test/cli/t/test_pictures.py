"""test_pictures.py - the pictures of build/tess, read back and compared with what
NumPy computes."""
import re
import warnings
import xml.etree.ElementTree as xml

import pytest

from beside import BOX, chance, listed, load, np, save

SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
def draw(run):
    """draw(*arguments): the picture p.svg; draw.err, what is told"""
    def draw(*arguments):
        draw.err = run(*arguments, "-values" if "-grid" in arguments else "-svg",
                       "p.svg").err
        return xml.parse("p.svg").getroot()
    return draw


# ---- what is in a picture ----

def loops(path):
    """A path's outlines, an array of corners each."""
    found = []
    for command, numbers in re.findall(r"([MLl])([-\d. ]+)", path):
        xy = np.array([float(x) for x in re.findall(r"-?[\d.]+", numbers)])
        xy = xy.reshape(-1, 2)
        if command == "M":
            found.append(xy)
        else:
            if command == "l":
                xy = found[-1][-1] + np.cumsum(xy, 0)
            found[-1] = np.vstack((found[-1], xy))
    return found


def winding(outlines, at):
    """How often these go round each of the places."""
    turns = np.zeros(len(at), int)
    for a in outlines:
        b = np.roll(a, -1, 0)
        for (x0, y0), (x1, y1) in zip(a, b):
            if y0 == y1:
                continue
            side = (x1 - x0) * (at[:, 1] - y0) - (at[:, 0] - x0) * (y1 - y0)
            up = (y0 <= at[:, 1]) & (at[:, 1] < y1) & (side < 0)
            down = (y1 <= at[:, 1]) & (at[:, 1] < y0) & (side > 0)
            turns += up.astype(int) - down.astype(int)
    return turns


def groups(svg, name):
    return [g for g in svg.iter(SVG + "g") if g.get("class") == name]


def texts(svg):
    return [t.text for t in svg.iter(SVG + "text")]


def bands(svg):
    """the paths of a slice's bands"""
    return [p for p in svg.iter(SVG + "path")
            if len(p.get("fill", "")) == 7 and p.get("d")]


def drawn(svg):
    """of a mesh or its points: class and outline of each"""
    return [(path.get("class"), a) for path in svg.iter(SVG + "path")
            if path.get("class") for a in loops(path.get("d"))]


def bar(svg):
    return [t.text for g in groups(svg, "bar") for t in g.iter(SVG + "text")]


def axes(svg):
    """Of each axis its name, the texts at its ticks, where these are."""
    found = []
    for part in groups(svg, "axes")[0].iter():
        if part.tag == SVG + "path":
            found.append([None, [], np.array([a[0] for a in loops(part.get("d"))[1:]])])
        elif part.tag == SVG + "text":
            axis = found[-1]
            if len(axis[1]) < len(axis[2]):
                axis[1].append(part.text)
            else:
                axis[0] = part.text
    return found


def lines(svg):
    """Of each axis of a slice, the line from coordinates to the picture."""
    return [np.polyfit(np.array(words, float), at[:, k], 1)
            for k, (_, words, at) in enumerate(axes(svg))]


# ---- slices ----

RANDOM = chance(3).random((400, 3)) * (2, 1, 1)
CLOUD = np.vstack((BOX * (2, 1, 1), RANDOM))


def field(x, z):
    return np.sin(3 * x) * np.cos(2 * z) + 0.3 * x


@pytest.mark.parametrize("scale, many, options", [
    ((1, 1, 1), (41, 31), ""), ((1, 1, -1), (41, 31), ""), ((-1, 1, 1), (41, 31), ""),
    ((2, 1, -3), (41, 31), ""), ((1, 1, 1), (60, 40), "-method smooth")])
def test_slice(draw, scale, many, options):
    """Each place of the grid is in as many bands as its value says, where the axes
    say it is; lengths along these are as scale says."""
    save("box.csv", CLOUD, field(CLOUD[:, 0], CLOUD[:, 2]))
    svg = draw("-grid", "%d,1,%d" % many, "-values", "p.csv", "-scale", listed(scale),
               *options.split(), "box.csv")
    rows = load("p.csv")[1]
    value = rows[:, 3].reshape(many[1], many[0])
    place = lines(svg)
    for (a, b), (_, words, at), k, m in zip(place, axes(svg), (0, 2), (0, 1)):
        assert np.abs(a * np.array(words, float) + b - at[:, m]).max() <= 1
        assert len(words) >= 3 and np.sign(a) == (1, -1)[m] * np.sign(scale[k])
    wide = abs(place[1][0] / place[0][0])
    assert abs(wide * abs(scale[0] / scale[2]) - 1) <= 1e-2
    at = np.column_stack([a * rows[:, k] + b for (a, b), k in zip(place, (0, 2))])
    paths = [loops(p.get("d")) for p in bands(svg)]
    ticks = [float(t) for t in bar(svg) if re.fullmatch(r"[-\d.]+", t)]
    step = (ticks[1] - ticks[0]) / 5
    inside = sum((winding(p, at) != 0).astype(int) for p in paths).reshape(value.shape)
    least = step * np.floor(np.nanmin(value) / step + 1e-9)
    want = np.floor((value - least) / step) + 1
    # (but for places where a contour is near, and the rim, where outlines end)
    sure = np.abs((value - least) / step % 1 - 0.5) < 0.45
    sure[[0, -1]] = sure[:, [0, -1]] = False
    assert len(paths) > 9 and sure.sum() > 0.75 * value.size
    assert np.array_equal(inside[sure], want[sure])
    rim = np.vstack(paths[0])
    assert np.abs(rim.max(0) - at.max(0)).max() < 2
    assert np.abs(rim.min(0) - at.min(0)).max() < 2
    # corners of contours: where their level is between two places
    for k, path in enumerate(paths[1:], 1):
        i, j = [np.abs((np.vstack(path)[:, m] - b) / a - low) / (high - low) * (n - 1)
                for m, (a, b), low, high, n in
                zip((0, 1), place, rows[0, [0, 2]], rows[-1, [0, 2]], many)]
        x, y = np.round(i).astype(int), np.round(j).astype(int)
        across = np.abs(j - y) < np.abs(i - x)
        m = np.where(across, np.floor(i), x).astype(int).clip(0, many[0] - 1)
        n = np.where(across, y, np.floor(j)).astype(int).clip(0, many[1] - 1)
        a = value[n, m]
        b = value[(n + ~across).clip(0, many[1] - 1), (m + across).clip(0, many[0] - 1)]
        s = np.where(across, i - m, j - n)
        off = np.abs(a + s * (b - a) - least - k * step)
        inner = (i > .1) & (j > .1) & (i < many[0] - 1.1) & (j < many[1] - 1.1) & (
            np.abs(i - x) + np.abs(j - y) > 0.03)
        assert not (off > 0.012 * np.abs(b - a) + 1e-9)[inner].any()


def test_saddle(draw):
    """what is high, or low, is joined as the mean of four says"""
    save("saddle.csv", BOX, BOX[:, 0] == BOX[:, 2])
    svg = draw("-grid", "2,1,2", "saddle.csv")
    middle = np.array([[at[:, k].mean() for k, (_, _, at) in enumerate(axes(svg))]])
    joined = [winding(loops(p.get("d")), middle)[0] != 0 for p in svg.iter(SVG + "path")
              if len(p.get("fill", "")) == 7]
    assert joined == [True] * 13 + [False] * 12


@pytest.fixture
def ball(tmp_path):
    """a ball with a hollow"""
    x = chance(4).normal(size=(3000, 3))
    x /= np.linalg.norm(x, axis=1)[:, None]
    x *= np.cbrt(chance(5).random(3000) * 7 + 1)[:, None]
    return save("ball.csv", x, x[:, 0])


@pytest.mark.parametrize("options", ["", "-alpha 0.35", "-scale 1,1,-1 -alpha 0.35"])
def test_slice_ends_where_the_tetrahedra_do(draw, ball, options):
    svg = draw("-grid", "80,60,1", "-values", "p.csv", *options.split(), ball)
    rows = load("p.csv")[1]
    at = np.column_stack([a * rows[:, k] + b for k, (a, b) in enumerate(lines(svg))])
    outlines = loops([m for m in svg.iter(SVG + "mask")][0][0].get("d"))
    inside = winding(outlines, at)
    want = ~np.isnan(rows[:, 3])
    # (but for places at the rim)
    sure = ~np.any([winding(outlines, at + d) != inside
                    for d in ((2, 0), (-2, 0), (0, 2), (0, -2))], axis=0)
    assert set(inside[sure]) <= {0, 1, -1} and sure.sum() > 4500
    assert np.array_equal((inside != 0)[sure], want[sure])
    assert want.sum() > 1000 and (~want).sum() > 1000


def test_texts_of_a_slice(draw, ball):
    """a number outside is drawn as any other; one place is said with its unit"""
    svg = draw("-outside", "-3", "-grid", "80,60,1", ball)
    assert not list(svg.iter(SVG + "mask")) and {"-3", "-3.0"} & set(texts(svg))
    svg = draw("-unit", "K,m", "-title", "a<b & c", "-grid", "9,1,9,-1,1,.5,.5,-1,1", ball)
    assert {"a<b & c", "T, K", "x, m", "z, m"} <= set(texts(svg))
    assert any("y = 0.5 m; linear" in t for t in texts(svg))


def test_thin_slice_is_drawn_larger_and_it_is_said(draw):
    """but nothing otherwise than -scale says"""
    save("thin.csv", CLOUD * (1, 1, 1e-3), CLOUD[:, 0], names="lon,lat,depth,T")
    options = ["-cols", "lon,lat,depth,T", "-grid", "9,1,9", "thin.csv"]
    svg = draw("-scale", "1,1,1000", *options)
    assert {"lon", "depth"} <= set(texts(svg))
    assert not any("times" in t for t in texts(svg))
    svg = draw(*options)
    (a, _), (b, _) = lines(svg)
    times, = [float(t[1]) for t in (re.search("depth is drawn ([0-9]+) times", t)
                                    for t in texts(svg)) if t]
    assert abs(b / a / -times - 1) < 0.02


# ---- points and tetrahedra ----

FEW = chance(6).random((40, 3)) * (3, 2, 1)
PRODUCT = FEW[:, 0] * FEW[:, 1]


def rows_of(azimuth, elevation):
    a, e = np.radians(azimuth), np.radians(elevation)
    return np.array([[-np.sin(a), np.cos(a), 0],
                     [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)],
                     [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]])


VIEWS = pytest.mark.parametrize("azimuth, elevation, scale", [
    (-68, 28, (1, 1, 1)), (200, -35, (1, 1, 1)), (20, 60, (1, 2, -1)),
    (-68, 28, (-1, 1, -1))])


@VIEWS
def test_points_are_where_they_are_from_back_to_front(draw, azimuth, elevation, scale):
    """with colours and axes"""
    save("few.csv", FEW, PRODUCT)
    svg = draw("-draw", "points", "-view", azimuth, elevation, "-scale", listed(scale),
               "few.csv")
    turn = rows_of(azimuth, elevation) * scale
    dots = drawn(svg)
    order = np.argsort(FEW @ turn[2])
    at = np.array([a[0] for _, a in dots])
    seen = FEW[order] @ turn[:2].T * (1, -1)
    size = np.ptp(at, 0)[0] / np.ptp(seen, 0)[0]
    shift = (at - size * seen).mean(0)
    assert len(at) == 40 and np.abs(at - size * seen - shift).max() < 1.1
    value, band = PRODUCT[order], np.array([int(c[1:]) for c, _ in dots])
    used = sorted(set(band))
    assert len(used) > 9 and all(value[band == a].max() <= value[band == b].min()
                                 for a, b in zip(used, used[1:]))
    low, high = FEW.min(0), FEW.max(0)
    assert [title for title, _, _ in axes(svg)] == list("xyz")
    for k, (_, words, ticks) in enumerate(axes(svg)):
        # ticks are at one of the box's four edges along this axis
        fits = 0
        for m in range(4):
            x = np.where([m & 1, m & 1, m & 1], low, high)
            other = [j for j in range(3) if j != k][1]
            x[other] = (low, high)[m >> 1][other]
            x = np.tile(x, (len(words), 1))
            x[:, k] = np.array(words, float)
            want = x @ turn[:2].T * (1, -1) * size + shift
            fits += np.abs(want - ticks).max() < 2
        assert fits == 1 and len(words) > 0


@VIEWS
def test_facets_that_face_the_viewer_are_seen(draw, azimuth, elevation, scale):
    """of one tetrahedron, and no other"""
    four = FEW[:4]
    save("four", four, names="")
    svg = draw("-draw", "whole", "-view", azimuth, elevation, "-scale", listed(scale),
               "four")
    outlines = [a for _, a in drawn(svg)]
    turn = rows_of(azimuth, elevation)
    place = four @ (turn * scale)[:2].T * (1, -1)
    place -= place.min(0)
    place *= np.ptp(np.vstack(outlines), 0)[0] / place[:, 0].max()
    low, want = np.vstack(outlines).min(0), []
    for k in range(4):
        face = np.delete(four * scale, k, 0)
        normal = np.cross(face[1] - face[0], face[2] - face[0])
        outward = normal * np.sign(normal @ (face[0] - four[k] * scale))
        if outward @ turn[2] > 0:
            want.append([k])
    assert sorted([i for i in range(4) if np.abs(a - low - place[i]).max(1).min() > 2]
                  for a in outlines) == want


def test_bare_and_size(draw):
    svg = draw("-draw", "points", "-bare", "-size", "300,200", save("few.csv", FEW, PRODUCT))
    assert texts(svg) == [] and (svg.get("width"), svg.get("height")) == ("300", "200")
    assert not [g for g in svg.iter(SVG + "g") if g.get("class")]


def test_texts_of_latin_1_and_utf_8(draw, tmp_path):
    (tmp_path / "latin.csv").write_bytes(
        b"x,y,z,\xb0C\n" + b"".join(b"%f,%f,%f,1\n" % tuple(r) for r in FEW))
    svg = draw("-title", "\u00e9 \u2192", "latin.csv")
    assert {"\u00b0C", "\u00e9 \u2192"} <= set(texts(svg))


def test_field_has_no_edges(draw, ball):
    svg = draw("-draw", "field", ball)
    classes = {path.get("class", "")[:1] for path in svg.iter(SVG + "path")}
    assert classes <= set("abcde") | {""} and len(classes) > 3


# ---- values that are no numbers: not in the scale, and grey ----

def grey(svg):
    """Of what is drawn, is its colour a grey?"""
    style = "".join(t.text for t in svg.iter(SVG + "style"))
    greys = {c for names, colour in re.findall(
                 r"((?:\.[a-zA-Z]\d+,?)+)\{fill:#(\w{6})", style)
             if len({colour[k:k + 2] for k in (0, 2, 4)}) == 1
             for c in names.replace(".", "").split(",")}
    return [c in greys for c, _ in drawn(svg)]


HOLES = FEW[:, 0] + 40
HOLES[[3, 20, 30]] = np.nan, np.inf, -np.inf


@pytest.mark.parametrize("what", ["points", "whole", "cut", "field", "apart"])
def test_no_numbers(draw, what):
    """The scale is that of the others; what is grey has a hole for a corner, or is cut
    from what has; without any number there is no scale."""
    full = np.where(np.isfinite(HOLES), HOLES, FEW[:, 0].mean() + 40)
    whole = draw("-draw", what, save("whole.csv", FEW, full))
    svg = draw("-draw", what, save("holes.csv", FEW, HOLES))
    assert bar(svg) == bar(whole) and len(bar(whole)) > 3 and not any(grey(whole))
    assert sum(grey(svg)) == 3 if what == "points" else 0 < sum(grey(svg)) < len(grey(svg))
    assert bar(draw("-draw", what, save("none.csv", FEW, HOLES * np.nan))) == []


def test_no_number_at_a_corner(draw):
    save("four.csv", [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]],
         [0, 1, 2, 3, np.nan])
    assert grey(draw("-draw", "whole", "-view", 45, 80, "four.csv")) == [True, True]


def test_no_numbers_are_told_once_and_how_many(draw):
    """copies are not counted"""
    save("holes.csv", FEW, HOLES)
    draw("-periodic", "-box", "0,9,0,9,0,9", "holes.csv")
    assert "3 values of T are" in draw.err
    draw("holes.csv", "-svg", "p2.svg")
    assert draw.err.count("holes.csv: 3 values of T are no numbers: not in") == 1


# ---- scales: coordinates and values of many digits, or of few ----

@pytest.fixture(scope="module")
def outside():
    """outside(svg): the texts that are not within the picture, by Helvetica's
    metrics"""
    matplotlib = pytest.importorskip("matplotlib")
    try:
        from matplotlib._afm import AFM
    except ImportError:
        warnings.simplefilter("ignore", DeprecationWarning)
        from matplotlib.afm import AFM
    helvetica = []
    for name in "phvr8a", "phvb8a":
        with open("%s/fonts/afm/%s.afm" % (matplotlib.get_data_path(), name), "rb") as f:
            helvetica.append(AFM(f))

    def outside(svg):
        parent = {child: part for part in svg.iter() for child in part}
        picture = [10 * float(svg.get(k)) for k in ("width", "height")]
        found = []
        for t in svg.iter(SVG + "text"):
            size = float(t.get("font-size"))
            font = helvetica[parent[t].get("font-weight") == "bold"]
            length = font.string_width_height(t.text)[0] / 1000 * size
            before = {"middle": length / 2, "end": length}.get(t.get("text-anchor"), 0)
            x, y = float(t.get("x")), float(t.get("y"))
            box = np.array([[x - before, y - .75 * size],
                            [x - before + length, y + .22 * size]])
            turn = re.fullmatch(r"translate\(([\d.-]+) ([\d.-]+)\) rotate\(-90\)",
                                parent[t].get("transform", ""))
            if turn:
                box = np.array([[1, -1]]) * box[:, ::-1] + np.array(turn.groups(), float)
            if (box < 0).any() or (box > picture).any():
                found.append(t.text)
        return found
    return outside


def scales(svg):
    """Of each scale its name; the texts; the numbers, as the name says."""
    found = axes(svg)
    for g in groups(svg, "bar"):
        *words, name = [t.text for t in g.iter(SVG + "text")]
        y = [float(t.get("y")) for t in g.iter(SVG + "text")][:-1]
        found.append([name, words, np.column_stack((np.zeros(len(y)), y))])
    for s in found:
        s.append(np.array(s[1], float))
        base = re.fullmatch(r"(.*?) ([-+]) ([\d.e+-]+)(,.*)?", s[0])
        if base:
            s[3] = s[3] + float({"-": "", "+": "-"}[base[2]] + base[3])
            s[0] = base[1] + (base[4] or "")
    return found


def right(svg, names, low, high, rounding=0.0):
    """Each scale is so called, of two numbers at least that differ, in even steps, and
    they are between low and high, and short."""
    found = scales(svg)
    assert [s[0] for s in found] == names
    for (_, words, at, numbers), a, b in zip(found, low, high):
        step = np.diff(numbers)
        assert len(words) == len(set(words)) >= 2 and max(map(len, words)) <= 8
        assert (step > 0).all() and np.ptp(step) <= 1e-6 * step[0] + rounding
        assert a - .6 * step[0] <= numbers[0] and numbers[-1] <= b + .6 * step[0]
        # the ticks are as even as the numbers
        assert np.ptp(np.linalg.norm(np.diff(at, axis=0), axis=1)) <= 3


@pytest.mark.parametrize("origin, size, value", [
    ((512345, 7654321, 120), (950, 780, 300), (0, 3)),
    ((512345.25, 7654321.5, 120), (8, 6, 3), (290, 291)),
    ((212345, 7254321, 0), (4e5, 3e5, 2e5), (-5, 5)),
    ((-7654321, -2512345, -900), (700, 900, 800), (1234567.01, 1234567.02)),
    ((0, 0, 0), (2e-3, 1e-3, 1e-3), (1e-9, 2e-9)),
    ((1e20, -3e20, 5e20), (1e19, 2e19, 1e19), (1e30, 9e30)),
    ((-70.25, -33.5, 0), (.02, .03, .01), (0, 1e-3)),
    ((1e9, 2e9, 0), (1e-3, 1e-3, 2e-3), (1e6, 1e6 + 1e-6))], ids=[
        "UTM", "UTM, a few metres", "UTM, 400 km", "seven digits below 0", "millimetres",
        "a galaxy", "degrees", "13 digits"])
def test_scales(draw, outside, origin, size, value):
    p = np.array(origin) + chance(7).random((60, 3)) * size
    v = value[0] + (value[1] - value[0]) * chance(8).random(60)
    save("scale.csv", p, v, names="Easting,Northing,Level,Gold")
    ranges = np.append(p.min(0), v.min()), np.append(p.max(0), v.max())
    rounding = 4e-15 * max(abs(p).max(), abs(v).max())
    names = ["Easting, m", "Northing, m", "Level, m", "Gold, g/t"]
    options = ["-unit", "g/t,m", "-cols", "1,2,3,4", "scale.csv"]
    for more in (["-draw", "points"], ["-title", "A title of many words, " * 9, "-draw",
                                       "cut", "-view", 200, 35]):
        svg = draw(*more, *options)
        right(svg, names, *ranges, rounding)
        assert outside(svg) == []
    for k, many in enumerate(("1,9,7", "9,1,7", "9,7,1")):
        svg = draw("-grid", many, "-outside", "nearest", *options)
        two = [j for j in range(4) if j != k]
        right(svg, [names[j] for j in two], *(r[two] for r in ranges), rounding)
        assert outside(svg) == []
        # its place in full digits
        note, = [float(t[1]) for t in (re.match(
            "(?:Easting|Northing|Level) = (.*) m;", t) for t in texts(svg)) if t]
        assert abs(note - ranges[0][k] / 2 - ranges[1][k] / 2) <= 5e-15 * abs(ranges[1][k])
    save("scale.csv", p, v, names="Easting (UTM 51S),Northing (UTM 51S),"
         "Level above the sea,Gold by assay")
    for more in ([], ["-draw", "points", "-view", 110, 20], ["-grid", "9,7,1"],
                 ["-size", "500,400"]):
        svg = draw("-cols", "1,2,3,4", "-unit", "parts per million,metres", *more,
                   "scale.csv")
        assert outside(svg) == [] and len(texts(svg)) > 9


@pytest.mark.parametrize("constant", [5, 0, -7654321.5, 1e-12, 1e300])
def test_values_that_are_all_the_same(draw, constant):
    """one colour, with a scale"""
    save("same.csv", chance(7).random((60, 3)), np.full(60, constant))
    for options in ["-grid", "30,20,1", "-outside", "nearest"], ["-draw", "points"]:
        svg = draw(*options, "same.csv")
        _, words, _, numbers = scales(svg)[-1]
        assert len(set(words)) == len(words) >= 2 and numbers[0] < constant < numbers[-1]
        # (of a slice a path for each band, and all that are seen are of the
        # middle one, the others below)
        many = len({c[1:] for c, _ in drawn(svg)})
        assert (many, len({p.get("fill") for p in bands(svg)})) == (
            (1, 0) if options[0] == "-draw" else (0, 13))


def test_range(draw):
    """the same bar for several pictures, from end to end; what is beyond has the last
    colour"""
    save("few.csv", FEW, PRODUCT)
    bars = [bar(draw("-range", "-1,9", *options, "few.csv")) for options in (
        [], ["-draw", "points"], ["-grid", "9,9,1"],
        ["-grid", "9,9,1", "-method", "nearest"])]
    assert bars == [bars[0]] * 4 and [float(t) for t in bars[0][:-1]] == [0, 2, 4, 6, 8]
    band = [int(c[1:]) for c, _ in drawn(draw("-range", "1,2", "-draw", "points",
                                              "few.csv"))]
    assert band.count(min(band)) >= (PRODUCT < 1).sum() > 0
    assert band.count(max(band)) >= (PRODUCT > 2).sum() > 0
    assert len(set(band)) > 5
