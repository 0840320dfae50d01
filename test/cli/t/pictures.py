# pictures.py - the pictures of build/tess, read back and compared with what
# NumPy computes; test_driver.py runs it.
#
#   python3 pictures.py TESS
#
# In the current directory, where it leaves its files.  Prints `ok ...' or
# `FAILED ...' for each test.
import re
import warnings
import xml.etree.ElementTree as xml

import numpy as np

import common
from common import test

SVG = "{http://www.w3.org/2000/svg}"
random = np.random.default_rng(3)


def tess(*arguments):
    """The program's picture, p.svg."""
    common.tess("-q", *arguments)
    return xml.parse("p.svg").getroot()


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


def axes(svg):
    """Of each axis its name, the numbers at its ticks, where these are."""
    group = [g for g in svg.iter(SVG + "g") if g.get("class") == "axes"][0]
    found, texts = [], []
    for part in group.iter():
        if part.tag == SVG + "path":
            line = loops(part.get("d"))
            found.append([None, [], np.array([a[0] for a in line[1:]])])
        elif part.tag == SVG + "text":
            axis = found[-1]
            if len(axis[1]) < len(axis[2]):
                axis[1].append(float(part.text))
            else:
                axis[0] = part.text
    return [(name, np.array(numbers), at) for name, numbers, at in found]


def save(name, p, *columns, names="x,y,z,T"):
    rows = np.column_stack((p,) + columns)
    np.savetxt(name, rows, fmt="%.17g", delimiter=",", comments="",
               header=",".join(names.split(",")[:rows.shape[1]]))


def texts(svg):
    return [t.text for t in svg.iter(SVG + "text")]


# ---- slices ----

def field(x, z):
    return np.sin(3 * x) * np.cos(2 * z) + 0.3 * x


def slice_fits(options, many, scale):
    """Is each place of the grid in as many bands as its value says, where the
    axes say it is?  Are lengths along these as scale says?"""
    svg = tess("-grid", "%d,1,%d" % many, "-values", "p.svg", "-values",
               "p.csv", *options)
    rows = np.genfromtxt("p.csv", delimiter=",", skip_header=1)
    value = rows[:, 3].reshape(many[1], many[0])
    place = []
    for (name, numbers, at), k, m in zip(axes(svg), (0, 2), (0, 1)):
        # from coordinates to the picture: a line through the ticks
        a, b = np.polyfit(numbers, at[:, m], 1)
        if np.abs(a * numbers + b - at[:, m]).max() > 1.0 or len(numbers) < 3:
            return False
        if np.sign(a) != (1, -1)[m] * np.sign(scale[k]):
            return False
        place.append((a, b))
    wide = abs(place[1][0] / place[0][0])
    if abs(wide * abs(scale[0] / scale[2]) - 1) > 1e-2:
        return False
    at = np.column_stack([a * rows[:, k] + b
                          for (a, b), k in zip(place, (0, 2))])
    bands = [p for p in svg.iter(SVG + "path")
             if len(p.get("fill", "")) == 7 and p.get("d")]
    group = [g for g in svg.iter(SVG + "g") if g.get("class") == "bar"][0]
    ticks = np.array([float(t.text) for t in group.iter(SVG + "text")
                      if re.fullmatch(r"[-\d.]+", t.text)])
    step = (ticks[1] - ticks[0]) / 5
    inside = sum((winding(loops(p.get("d")), at) != 0).astype(int)
                 for p in bands).reshape(value.shape)
    seen = value[np.isfinite(value)]
    least = step * np.floor(seen.min() / step + 1e-9)
    want = np.floor((value - least) / step) + 1
    # (but for places where a contour is near, and the rim, where outlines end)
    sure = np.abs((value - least) / step % 1 - 0.5) < 0.45
    sure[[0, -1]] = sure[:, [0, -1]] = False
    rim = np.vstack(loops(bands[0].get("d")))
    # corners of contours: where their level is between two places
    for k, band in enumerate(bands[1:], 1):
        i, j = [np.abs((np.vstack(loops(band.get("d")))[:, m] - b) / a - low) /
                (high - low) * (n - 1) for m, (a, b), low, high, n in
                zip((0, 1), place, rows[0, [0, 2]], rows[-1, [0, 2]], many)]
        x, y = np.round(i).astype(int), np.round(j).astype(int)
        across = np.abs(j - y) < np.abs(i - x)
        m = np.where(across, np.floor(i), x).astype(int).clip(0, many[0] - 1)
        n = np.where(across, y, np.floor(j)).astype(int).clip(0, many[1] - 1)
        a = value[n, m]
        b = value[(n + ~across).clip(0, many[1] - 1),
                  (m + across).clip(0, many[0] - 1)]
        s = np.where(across, i - m, j - n)
        off = np.abs(a + s * (b - a) - least - k * step)
        inner = (i > .1) & (j > .1) & (i < many[0] - 1.1) & \
            (j < many[1] - 1.1) & (np.abs(i - x) + np.abs(j - y) > 0.03)
        if (off > 0.012 * np.abs(b - a) + 1e-9)[inner].any():
            return False
    return len(bands) > 9 and sure.sum() > 0.75 * value.size and \
        np.array_equal(inside[sure], want[sure]) and \
        np.abs(rim.max(0) - at.max(0)).max() < 2 and \
        np.abs(rim.min(0) - at.min(0)).max() < 2


p = random.random((400, 3)) * (2, 1, 1)
corners = np.array([[x, y, z] for x in (0, 2) for y in (0, 1) for z in (0, 1)])
p = np.vstack((corners, p))
save("box.csv", p, field(p[:, 0], p[:, 2]))
for scale in (1, 1, 1), (1, 1, -1), (-1, 1, 1), (2, 1, -3):
    test("slice: bands, axes, aspect, -scale %g,%g,%g" % scale, slice_fits(
        ["-scale", "%g,%g,%g" % scale, "box.csv"], (41, 31), scale))
test("slice: a method that is smooth", slice_fits(
    ["-method", "smooth", "box.csv"], (60, 40), (1, 1, 1)))

# a saddle: what is high, or low, is joined as the mean of four says
save("saddle.csv", corners, corners[:, 0] / 2 == corners[:, 2])
svg = tess("-grid", "2,1,2", "-values", "p.svg", "saddle.csv")
middle = np.array([[at[:, k].mean() for k, (_, _, at) in enumerate(axes(svg))]])
joined = [winding(loops(p.get("d")), middle)[0] != 0
          for p in svg.iter(SVG + "path") if len(p.get("fill", "")) == 7]
test("slice: a saddle", joined == [True] * 13 + [False] * 12)

# a ball with a hollow: what is drawn ends where the tetrahedra do
x = random.normal(size=(3000, 3))
x /= np.linalg.norm(x, axis=1)[:, None]
x *= np.cbrt(random.random(3000) * 7 + 1)[:, None]
save("ball.csv", x, x[:, 0])
for options in [], ["-alpha", "0.35"], ["-scale", "1,1,-1", "-alpha", "0.35"]:
    svg = tess("-grid", "80,60,1", "-values", "p.svg", "-values", "p.csv",
               *options, "ball.csv")
    rows = np.genfromtxt("p.csv", delimiter=",", skip_header=1)
    lines = [np.polyfit(n, at[:, k], 1)
             for k, (_, n, at) in enumerate(axes(svg))]
    at = np.column_stack([a * rows[:, k] + b for k, (a, b) in enumerate(lines)])
    mask = [m for m in svg.iter(SVG + "mask")][0]
    outlines = loops(mask[0].get("d"))
    inside = winding(outlines, at)
    want = ~np.isnan(rows[:, 3])
    # (but for places at the rim)
    near = [winding(outlines, at + d) != inside
            for d in ((2, 0), (-2, 0), (0, 2), (0, -2))]
    sure = ~np.any(near, axis=0)
    test("slice: where the tetrahedra end, %s" % " ".join(options),
         set(inside[sure]) <= {0, 1, -1} and sure.sum() > 4500 and
         np.array_equal((inside != 0)[sure], want[sure]) and
         want.sum() > 1000 and (~want).sum() > 1000)

# a number outside is drawn as any other; one place is said with its unit
svg = tess("-outside", "-3", "-grid", "80,60,1", "-values", "p.svg", "ball.csv")
test("slice: -outside VALUE", not list(svg.iter(SVG + "mask")) and
     {"-3", "-3.0"} & set(texts(svg)))
svg = tess("-unit", "K,m", "-title", "a<b & c", "-grid", "9,1,9,-1,1,.5,.5,-1,1",
           "-values", "p.svg", "ball.csv")
test("slice: -title, -unit, names of axes", {"a<b & c", "T, K", "x, m", "z, m"}
     <= set(texts(svg)) and any("y = 0.5 m; linear" in t for t in texts(svg)))
save("thin.csv", p * (1, 1, 1e-3), p[:, 0], names="lon,lat,depth,T")
svg = tess("-scale", "1,1,1000", "-cols", "lon,lat,depth,T", "-grid", "9,1,9",
           "-values", "p.svg", "thin.csv")
test("slice: the column's name, and nothing drawn otherwise than -scale says",
     {"lon", "depth"} <= set(texts(svg)) and
     not any("times" in t for t in texts(svg)))
svg = tess("-cols", "lon,lat,depth,T", "-grid", "9,1,9", "-values", "p.svg",
           "thin.csv")
(_, a, at), (_, b, bt) = axes(svg)
times = [re.search("depth is drawn ([0-9]+) times", t) for t in texts(svg)]
times = [float(t.group(1)) for t in times if t]
test("slice: a thin one is drawn larger, and it is said", len(times) == 1 and
     abs(np.polyfit(b, bt[:, 1], 1)[0] / np.polyfit(a, at[:, 0], 1)[0] /
         -times[0] - 1) < 0.02)

# ---- points and tetrahedra ----

def rows_of(azimuth, elevation):
    a, e = np.radians(azimuth), np.radians(elevation)
    return np.array([[-np.sin(a), np.cos(a), 0],
                     [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a),
                      np.cos(e)],
                     [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a),
                      np.sin(e)]])


few = random.random((40, 3)) * (3, 2, 1)
save("few.csv", few, few[:, 0] * few[:, 1])
for azimuth, elevation, scale in ((-68, 28, (1, 1, 1)), (200, -35, (1, 1, 1)),
                                  (20, 60, (1, 2, -1)), (-68, 28, (-1, 1, -1))):
    name = "-view %g %g -scale %g,%g,%g" % ((azimuth, elevation) + scale)
    options = ["-view", azimuth, elevation, "-scale", "%g,%g,%g" % scale,
               "few.csv", "-svg", "p.svg"]
    svg = tess("-draw", "points", *options)
    turn = rows_of(azimuth, elevation) * scale
    dots = [(a[0], int(path.get("class")[1:]))
            for path in svg.iter(SVG + "path") if path.get("class")
            for a in loops(path.get("d"))]
    order = np.argsort(few @ turn[2])
    at = np.array([d[0] for d in dots])
    seen = few[order] @ turn[:2].T * (1, -1)
    size = np.ptp(at, 0)[0] / np.ptp(seen, 0)[0]
    shift = (at - size * seen).mean(0)
    test("points: where they are, from back to front, " + name,
         len(at) == 40 and np.abs(at - size * seen - shift).max() < 1.1)
    value = (few[:, 0] * few[:, 1])[order]
    band = np.array([d[1] for d in dots])
    test("points: colours, " + name, all(
        value[band == k].max() <= value[band == k + 1].min()
        for k in range(band.max()) if (band == k).any() and
        (band == k + 1).any()) and len(set(band)) > 9)
    low, high = few.min(0), few.max(0)
    good = []
    for k, (title, numbers, ticks) in enumerate(axes(svg)):
        # ticks are at one of the box's four edges along this axis
        fits = []
        for m in range(4):
            x = np.where([m & 1, m & 1, m & 1], low, high)
            others = [j for j in range(3) if j != k]
            x[others[1]] = (low, high)[m >> 1][others[1]]
            x = np.tile(x, (len(numbers), 1))
            x[:, k] = numbers
            want = x @ turn[:2].T * (1, -1) * size + shift
            fits.append(np.abs(want - ticks).max() < 2)
        good.append(sum(fits) == 1 and title == "xyz"[k] and len(numbers) > 0)
    test("points: axes, " + name, good == [True] * 3)
    # one tetrahedron: the facets that face the viewer, and no other
    four = few[:4]
    np.savetxt("four", four, fmt="%.17g")
    svg = tess("-draw", "whole", "-view", azimuth, elevation, "-scale",
               "%g,%g,%g" % scale, "four", "-svg", "p.svg")
    drawn = [a for path in svg.iter(SVG + "path") if path.get("class")
             for a in loops(path.get("d"))]
    flat = four @ turn[:2].T * (1, -1)
    low = np.vstack(drawn).min(0)
    place = flat - flat.min(0)
    place *= np.ptp(np.vstack(drawn), 0)[0] / place[:, 0].max()
    want = []
    for k in range(4):
        face = np.delete(four * scale, k, 0)
        normal = np.cross(face[1] - face[0], face[2] - face[0])
        outward = normal * np.sign(normal @ (face[0] - four[k] * scale))
        if outward @ rows_of(azimuth, elevation)[2] > 0:
            want.append(k)
    got = [[i for i in range(4) if np.abs(a - low - place[i]).max(1).min() > 2]
           for a in drawn]
    test("tetrahedra: the facets that are seen, " + name,
         sorted(got) == [[k] for k in want])

svg = tess("-draw", "points", "-bare", "-size", "300,200", "few.csv", "-svg",
           "p.svg")
test("-bare, -size", texts(svg) == [] and svg.get("width") == "300" and
     svg.get("height") == "200" and not [
         g for g in svg.iter(SVG + "g") if g.get("class")])
open("latin.csv", "wb").write(
    b"x,y,z,\xb0C\n" + b"".join(b"%f,%f,%f,1\n" % tuple(r) for r in few))
svg = tess("-title", "\u00e9 \u2192", "latin.csv", "-svg", "p.svg")
test("texts: Latin-1 and UTF-8", {"\u00b0C", "\u00e9 \u2192"} <= set(texts(svg)))
svg = tess("-draw", "field", "ball.csv", "-svg", "p.svg")
classes = {path.get("class", "")[:1] for path in svg.iter(SVG + "path")}
test("-draw field: no edges", classes <= set("abcde") | {""} and
     len(classes) > 3)

# ---- values that are no numbers: not in the scale, and grey ----

def greys(svg):
    """Classes whose colour is a grey."""
    style = "".join(t.text for t in svg.iter(SVG + "style"))
    return {c for names, colour in re.findall(
                r"((?:\.[a-zA-Z]\d+,?)+)\{fill:#(\w{6})", style)
            if len({colour[k:k + 2] for k in (0, 2, 4)}) == 1
            for c in names.replace(".", "").split(",")}


def bar(svg):
    return [t.text for g in svg.iter(SVG + "g") if g.get("class") == "bar"
            for t in g.iter(SVG + "text")]


value = few[:, 0] + 40
holes = value.copy()
holes[3], holes[20], holes[30] = np.nan, np.inf, -np.inf
value[[3, 20, 30]] = value.mean()
save("whole.csv", few, value)
save("holes.csv", few, holes)
save("none.csv", few, few[:, 0] * np.nan)
for what in "points", "whole", "cut", "field", "apart":
    full = tess("-draw", what, "whole.csv", "-svg", "p.svg")
    svg = tess("-draw", what, "holes.csv", "-svg", "p.svg")
    test("no numbers: the scale, -draw " + what,
         bar(svg) == bar(full) and len(bar(full)) > 3 and not greys(full))
    # what is grey has a hole for a corner, or is cut from what has
    drawn = [(path.get("class") in greys(svg), a)
             for path in svg.iter(SVG + "path") if path.get("class")
             for a in loops(path.get("d"))]
    grey = sum(g for g, a in drawn)
    test("no numbers: grey, -draw " + what, grey == 3 if what == "points"
         else 0 < grey < len(drawn))
    svg = tess("-draw", what, "none.csv", "-svg", "p.svg")
    test("no numbers at all: no scale, -draw " + what, bar(svg) == [])
four = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
save("four.csv", four, [0, 1, 2, 3, np.nan])
svg = tess("-draw", "whole", "-view", 45, 80, "four.csv", "-svg", "p.svg")
drawn = [path.get("class") in greys(svg) for path in svg.iter(SVG + "path")
         if path.get("class") for a in loops(path.get("d"))]
test("no numbers: the facets at that corner", drawn == [True] * len(drawn) and
     len(drawn) == 2)
done = common.run("-periodic", "-box", "0,9,0,9,0,9", "holes.csv", "-svg",
                  "p.svg")
test("no numbers: copies are not counted", "3 values of T are" in done.stderr)
done = common.run("holes.csv", "-svg", "p.svg", "-svg", "p2.svg")
test("no numbers: said once, and how many",
     done.stderr.count("holes.csv: 3 values of T are no numbers: not in") == 1)

# ---- scales: coordinates and values of many digits, or of few ----

try:
    import matplotlib
    try:
        from matplotlib._afm import AFM
    except ImportError:
        warnings.simplefilter("ignore", DeprecationWarning)
        from matplotlib.afm import AFM
    helvetica = [AFM(open("%s/fonts/afm/%s.afm" % (
        matplotlib.get_data_path(), name), "rb")) for name in
        ("phvr8a", "phvb8a")]
except ImportError:
    helvetica = None
    print("        skipped: texts within the picture: no matplotlib")


def outside(svg):
    """The texts that are not within the picture, by Helvetica's metrics."""
    parent = {child: part for part in svg.iter() for child in part}
    wide, tall = [10 * float(svg.get(k)) for k in ("width", "height")]
    found = []
    for t in svg.iter(SVG + "text"):
        size = float(t.get("font-size"))
        font = helvetica[parent[t].get("font-weight") == "bold"]
        length = font.string_width_height(t.text)[0] / 1000 * size
        before = {"middle": length / 2, "end": length}.get(
            t.get("text-anchor"), 0)
        x, y = float(t.get("x")), float(t.get("y"))
        box = np.array([[x - before, y - .75 * size],
                        [x - before + length, y + .22 * size]])
        turn = re.fullmatch(r"translate\(([\d.-]+) ([\d.-]+)\) rotate\(-90\)",
                            parent[t].get("transform", ""))
        if turn:
            box = np.array([[1, -1]]) * box[:, ::-1] + [
                float(turn.group(1)), float(turn.group(2))]
        if (box < 0).any() or (box > (wide, tall)).any():
            found.append(t.text)
    return found


def scales(svg):
    """Of each scale its name; the texts; the numbers, as the name says."""
    group = [g for g in svg.iter(SVG + "g") if g.get("class") == "axes"][0]
    all_of = []
    for name, numbers, at in axes(svg):
        all_of.append([name, None, numbers, at])
    marks = [t.text for t in group.iter(SVG + "text")]
    for s in all_of:
        s[1], marks = marks[:len(s[2])], marks[len(s[2]) + 1:]
    for g in svg.iter(SVG + "g"):
        if g.get("class") != "bar":
            continue
        marks = [t.text for t in g.iter(SVG + "text")]
        y = [float(t.get("y")) for t in g.iter(SVG + "text")][:-1]
        all_of.append([marks[-1], marks[:-1],
                       np.array([float(t) for t in marks[:-1]]),
                       np.column_stack((np.zeros(len(y)), y))])
    for s in all_of:
        base = re.fullmatch(r"(.*?) ([-+]) ([\d.e+-]+)(,.*)?", s[0])
        if base:
            s[2] = s[2] + float({"-": "", "+": "-"}[base.group(2)] +
                                base.group(3))
            s[0] = base.group(1) + (base.group(4) or "")
    return all_of


def right(svg, names, low, high, rounding=0.0):
    """Is each scale so called, of two numbers at least that differ, in even
    steps, and are they between low and high, and short?"""
    found = scales(svg)
    if [s[0] for s in found] != names:
        return False
    for (name, words, numbers, at), a, b in zip(found, low, high):
        step = np.diff(numbers)
        if len(words) < 2 or len(set(words)) < len(words) or \
                max(map(len, words)) > 8 or not (step > 0).all() or \
                np.ptp(step) > 1e-6 * step[0] + rounding or \
                numbers[0] < a - .6 * step[0] or numbers[-1] > b + .6 * step[0]:
            return False
        # the ticks are as even as the numbers
        along = np.linalg.norm(np.diff(at, axis=0), axis=1)
        if np.ptp(along) > 3:
            return False
    return not helvetica or not outside(svg)


cloud = random.random((60, 3))
for what, origin, size, value in (
        ("UTM", (512345, 7654321, 120), (950, 780, 300), (0, 3)),
        ("UTM, a few metres", (512345.25, 7654321.5, 120), (8, 6, 3), (290, 291)),
        ("UTM, 400 km", (212345, 7254321, 0), (4e5, 3e5, 2e5), (-5, 5)),
        ("seven digits below 0", (-7654321, -2512345, -900), (700, 900, 800),
         (1234567.01, 1234567.02)),
        ("millimetres", (0, 0, 0), (2e-3, 1e-3, 1e-3), (1e-9, 2e-9)),
        ("a galaxy", (1e20, -3e20, 5e20), (1e19, 2e19, 1e19), (1e30, 9e30)),
        ("degrees", (-70.25, -33.5, 0), (.02, .03, .01), (0, 1e-3)),
        ("13 digits", (1e9, 2e9, 0), (1e-3, 1e-3, 2e-3), (1e6, 1e6 + 1e-6))):
    p = np.array(origin) + cloud * size
    v = value[0] + (value[1] - value[0]) * random.random(60)
    save("scale.csv", p, v, names="Easting,Northing,Level,Gold")
    low, high = p.min(0), p.max(0)
    rounding = 4e-15 * max(abs(p).max(), abs(v).max())
    names = ["Easting, m", "Northing, m", "Level, m"]
    options = ["-unit", "g/t,m", "-cols", "1,2,3,4", "scale.csv"]
    svg = tess("-draw", "points", "-svg", "p.svg", *options)
    test("scales, points: " + what, right(
        svg, names + ["Gold, g/t"], list(low) + [v.min()],
        list(high) + [v.max()], rounding))
    svg = tess("-title", "A title of many words, " * 9, "-draw", "cut", "-view",
               200, 35, "-svg", "p.svg", *options)
    test("scales, tetrahedra: " + what, right(
        svg, names + ["Gold, g/t"], list(low) + [v.min()],
        list(high) + [v.max()], rounding))
    for k, many in enumerate(("1,9,7", "9,1,7", "9,7,1")):
        svg = tess("-grid", many, "-outside", "nearest", "-values", "p.svg",
                   *options)
        two = [j for j in range(3) if j != k]
        test("scales, slice %s: %s" % (many, what), right(
            svg, [names[j] for j in two] + ["Gold, g/t"],
            list(low[two]) + [v.min()], list(high[two]) + [v.max()], rounding))
        note = [re.match("(Easting|Northing|Level) = (.*) m;", t)
                for t in texts(svg)]
        note = [t for t in note if t]
        test("slice: its place in full digits, %s: %s" % (many, what),
             len(note) == 1 and abs(float(note[0].group(2)) -
                                    low[k] / 2 - high[k] / 2) <=
             5e-15 * abs(high[k]))
    # long names
    long = "Easting (UTM 51S),Northing (UTM 51S),Level above the sea,Gold by assay"
    save("scale.csv", p, v, names=long)
    for options in (["-svg", "p.svg"], ["-draw", "points", "-view", 110, 20,
                     "-svg", "p.svg"], ["-grid", "9,7,1", "-values", "p.svg"],
                    ["-size", "500,400", "-svg", "p.svg"]):
        svg = tess("-cols", "1,2,3,4", "-unit", "parts per million,metres",
                   *options, "scale.csv")
        test("long names within the picture, %s: %s" % (options[0], what),
             not helvetica or outside(svg) == [])

# values that are all the same, or but for rounding: one colour, with a scale
for constant in 5, 0, -7654321.5, 1e-12, 1e300:
    save("same.csv", cloud, constant * np.ones(60))
    for options in (["-grid", "30,20,1", "-outside", "nearest", "-values",
                     "p.svg"], ["-draw", "points", "-svg", "p.svg"]):
        svg = tess(*options, "same.csv")
        s = scales(svg)[-1]
        used = {path.get("fill") for path in svg.iter(SVG + "path")
                if len(path.get("fill", "")) == 7 and path.get("d")}
        dots = {path.get("class")[1:] for path in svg.iter(SVG + "path")
                if path.get("class")}
        # (of a slice a path for each band, and all that are seen are of the
        # middle one, the others below)
        test("all values are %g, %s" % (constant, options[0]),
             len(s[1]) >= 2 and len(set(s[1])) == len(s[1]) and
             s[2][0] < constant < s[2][-1] and
             (len(dots) == 1 if options[0] == "-draw" else len(used) == 13))

# the same colours for several pictures
save("few.csv", few, few[:, 0] * few[:, 1])
bars = [bar(tess("-range", "-1,9", *options, "few.csv")) for options in
        (["-svg", "p.svg"], ["-draw", "points", "-svg", "p.svg"],
         ["-grid", "9,9,1", "-values", "p.svg"],
         ["-grid", "9,9,1", "-method", "nearest", "-values", "p.svg"])]
test("-range: the same bar, from end to end", bars == [bars[0]] * 4 and
     [float(t) for t in bars[0][:-1]] == [0, 2, 4, 6, 8])
svg = tess("-range", "1,2", "-draw", "points", "-svg", "p.svg", "few.csv")
band = [int(path.get("class")[1:]) for path in svg.iter(SVG + "path")
        if path.get("class") for a in loops(path.get("d"))]
product = few[:, 0] * few[:, 1]
test("-range: what is beyond has the last colour",
     band.count(min(band)) >= (product < 1).sum() > 0 and
     band.count(max(band)) >= (product > 2).sum() > 0 and
     len(set(band)) > 5)
