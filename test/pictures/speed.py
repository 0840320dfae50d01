"""speed.py BENCH PICTURE - a chart of the times and bytes in a file that
test/bench/bench.sh has written: tess beside CGAL, TetGen and Qhull, as far as
the file has them.  Needs matplotlib; make pictures calls it."""
import io
import sys
import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt

# families of test/lib/points.c as people call them, the size that is shown
SETS = [("uniform", "random points\nin a cube"), ("lattice", "a grid"),
        ("globe", "stations\non a globe"), ("gridrot", "a turned grid"),
        ("terrain", "a laser scan\nof terrain"),
        ("boreholes", "samples\nin boreholes")]
PROGRAMS = [("tess", "#f2711c"), ("CGAL", "#4f86e0"), ("TetGen", "#2fa084"),
            ("Qhull", "#9b7fd4")]
GREY = "#767c85"    # of equal contrast to white and to a dark page
HIGHEST = 3000.0    # longer bars are cut, and say so


def tables(name):
    """The tables in the file, each a list of dictionaries."""
    found, head = [], None
    for line in open(name):
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if not line.startswith("|"):
            head = None
        elif head is None:
            head = cells
            found.append([])
        elif not cells[0].startswith("---"):
            found[-1].append(dict(zip(head, cells)))
    return found


def number(row, program):
    """What the row says of a program; None if that is nothing; what was ended
    because it took too long, as > 60 s, is more than all, and a failure nan."""
    text = row.get(program, "")
    if text.startswith(">"):
        return float("inf")
    try:
        return float(text)
    except ValueError:
        return float("nan") if text else None


def largest(rows, family):
    """Of a family's rows what they say of programs, for its largest set."""
    rows = [r for r in rows if r.get("points") == family]
    most = max([int(r["n"]) for r in rows], default=0)
    found = {}
    for r in rows:
        for program, _ in PROGRAMS:
            if int(r["n"]) == most and number(r, program) is not None:
                found[program] = number(r, program)
    return found, most


def bars(axes, groups, highest, form):
    """Groups of bars, a dictionary each."""
    wide = 0.8 / len(PROGRAMS)
    for k, (program, colour) in enumerate(PROGRAMS):
        for i, group in enumerate(groups):
            if program not in group:
                continue
            x, y = i + (k - 1.5) * wide, group[program]
            text = form(y) + " \u2191" * (y > highest)
            if y == float("inf"):
                text = "too long \u2191"
            elif y != y:
                text, y = "fails", 0
            axes.bar(x, min(y, highest), 0.92 * wide, color=colour)
            axes.annotate(text, (x, min(y, highest)), (0, 3),
                          textcoords="offset points", ha="center", fontsize=8.5,
                          rotation=90 if len(groups) > 1 else 0, color=GREY)
    axes.set_xlim(-0.5, max(len(groups), 1) - 0.5)
    for side in "top", "right", "left":
        axes.spines[side].set_visible(False)
    axes.yaxis.set_visible(False)
    axes.tick_params(axis="x", length=0)


def main():
    plt.rcParams.update({
        "svg.fonttype": "none", "svg.hashsalt": "tess", "text.color": GREY,
        "axes.edgecolor": GREY, "xtick.color": GREY, "font.size": 10,
        "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans"]})
    found = tables(sys.argv[1])
    times = [r for t in found for r in t if "tetrahedra" in r and "tess" in r]
    bytes_ = [r for t in found for r in t if "tess, workspace alone" in r]
    sets = [(largest(times, family), name) for family, name in SETS]
    sets = [s for s in sets if s[0][0]]
    memory, _ = largest(bytes_, "uniform")
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(9.2, 3.2), width_ratios=[len(sets) or 1, 1])
    bars(left, [s[0][0] for s in sets], HIGHEST, "{:,.0f}".format)
    left.set_ylim(0, 1.36 * HIGHEST)
    left.set_xticks(range(len(sets)), [
        "%s\n%s" % (name, "{:,} points".format(n)) for (_, n), name in sets])
    left.set_title("nanoseconds per tetrahedron: less is better", loc="left",
                   fontsize=11)
    bars(right, [memory], max(memory.values(), default=1.0),
         "{:,.0f}".format)
    right.set_ylim(0, 1.36 * max(memory.values(), default=1.0))
    right.set_xticks([0], ["random points\nin a cube\n"])
    right.set_title("bytes per point", loc="left", fontsize=11)
    left.legend([plt.Rectangle((0, 0), 1, 1, color=c) for _, c in PROGRAMS],
                [p.replace("Qhull", "Qhull, scipy") for p, _ in PROGRAMS],
                loc="upper right", bbox_to_anchor=(1.02, 1.16),
                frameon=False, ncols=len(PROGRAMS), handlelength=1.2,
                columnspacing=1.2)
    figure.tight_layout()
    text = io.StringIO()
    figure.savefig(text, transparent=True, metadata={"Date": None})
    with open(sys.argv[2], "w") as file:
        print(" ".join(text.getvalue().split()), file=file)


main()
