"""shell.py HOLES SHELL PICTURE - draw a grade shell, an OBJ file of build/tess
-iso, among the drill holes of test/data/holes.csv.  make pictures calls it."""
import csv
import math
import sys

WIDTH, HEIGHT = 720, 330
TURN, TILT = math.radians(-28), math.radians(24)    # of the view
LIGHT = (-0.48, -0.58, 0.66)
COLOUR = (242, 113, 44)


def seen(point):
    """To the right, upwards, and towards the eye."""
    x, y, z = point
    x, y = (x * math.cos(TURN) - y * math.sin(TURN),
            x * math.sin(TURN) + y * math.cos(TURN))
    return (x, y * math.sin(TILT) + z * math.cos(TILT),
            z * math.sin(TILT) - y * math.cos(TILT))


def normal(a, b, c):
    """Of the triangle, of length 1."""
    u, v = [[q[k] - a[k] for k in range(3)] for q in (b, c)]
    n = [u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3)]
    return [x / math.hypot(*n) for x in n]


def shell(name):
    """The corners of an OBJ file's triangles."""
    points, triangles = [], []
    for line in open(name):
        word = line.split()
        if word[:1] == ["v"]:
            points.append([float(w) for w in word[1:4]])
        elif word[:1] == ["f"]:
            triangles.append([points[int(w) - 1] for w in word[1:4]])
    return triangles


def main():
    holes, surface, picture = sys.argv[1:]
    ends = {}
    for row in csv.DictReader(open(holes)):
        x, y, z = [float(row[name]) for name in ("EAST", "NORTH", "RL")]
        top, foot = ends.get((x, y), (z, z))
        ends[x, y] = max(top, z), min(foot, z)
    lines = [[seen((x, y, z)) for z in ends[x, y]] for x, y in ends]
    corners = [q for line in lines for q in line]
    left, low = [min(q[k] for q in corners) for k in (0, 1)]
    right, high = [max(q[k] for q in corners) for k in (0, 1)]
    scale = 0.96 * min(WIDTH / (right - left), HEIGHT / (high - low))

    def place(q):
        return "%.1f %.1f" % (WIDTH / 2 + scale * (q[0] - (left + right) / 2),
                              HEIGHT / 2 - scale * (q[1] - (low + high) / 2))

    # what faces the eye, the farthest first; the holes in front of the shell
    # are drawn, too, as it is no opaque body
    faces = []
    for triangle in shell(surface):
        corner = [seen(q) for q in triangle]
        if normal(*corner)[2] > 0:
            light = sum(n * s for n, s in zip(normal(*triangle), LIGHT))
            shade = 0.66 + 0.34 * max(-1, min(1, light))
            faces.append((sum(q[2] for q in corner), corner,
                          "#%02x%02x%02x" % tuple(round(shade * c) for c in COLOUR)))
    with open(picture, "w") as out:
        print('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" '
              'stroke-linejoin="round">' % (WIDTH, HEIGHT), file=out)
        for _, corner, colour in sorted(faces):
            print('<path d="M%sZ" fill="%s" stroke="%s" stroke-width=".4"/>' % (
                "L".join(place(q) for q in corner), colour, colour), file=out)
        print('<path d="%s" stroke="#767c85" stroke-width=".7"/>' % "".join(
            "M%sL%s" % (place(a), place(b)) for a, b in lines), file=out)
        print("</svg>", file=out)


main()
