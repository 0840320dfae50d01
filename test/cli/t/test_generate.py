"""test_generate.py - files of generate.py, read by build/tess under sanitizers:
of what a format allows the points must come out, to the last digit; what is
damaged must be refused, in words of that kind of damage, or the points are the
same and it is told.
"""
import csv
import random
import re

import pytest

import generate
from generate import DAMAGES, FORMATS, named

def values_of(f):
    values = f.values if f.values is not None else [()] * len(f.points)
    return [tuple(p) + (tuple(v) if isinstance(v, tuple) else (v,))
            for p, v in zip(f.points, values)]


def rows_of(node):
    return [tuple(map(float, line.split()[1:])) for line in node.split("\n")
            if line and line[0] != "#"][1:]


def read_file(read, f, data, *options, pipe=False, name=None):
    options += tuple(f.options) + ("-account", "-node", "NODE") + ("-",) * pipe
    done = read(name or "f." + f.ending, data, *options)
    assert done.code in (0, 2), (done, data)
    assert done.code or "-q" in options or "left out: all\n" in done.out, (
        done.out, data)
    return done


@pytest.mark.parametrize("write", FORMATS + [named], ids=lambda w: w.__name__)
def test_what_is_allowed_is_read(read, checked, everything, write):
    def one(k):
        # (under sanitizers all takes four times as long)
        tess = checked if k % 2 or everything else read
        r = random.Random("%s %d" % (write.__name__, k))
        f = write(r)
        done = read_file(tess, f, f.bytes(), pipe=r.random() < .2)
        assert done.code == 0, (done.words, f.bytes())
        assert rows_of(done.points) == values_of(f), f.bytes()
        if f.names:
            made = tess("f." + f.ending, f.bytes(), "-q", "-volumes", "CELLS")
            assert [row[-1] for row in csv.reader(made.points.splitlines())][
                1:] == f.names, f.bytes()
    list(checked.pool.map(one, range(150 if everything else 20)))


# what may be said of any damage: in a first row it may look like a title
ANYWAY = "|is named as|ends after 4 of 5|a number among words"


@pytest.mark.parametrize("damage", DAMAGES, ids=lambda d: d[0])
def test_damage_is_refused_or_told(checked, everything, damage):
    kind, harm, words = damage
    harmed = []

    def one(write, k):
        r = random.Random("%s %s %d" % (write.__name__, kind, k))
        f, data = None, None
        for _ in range(99):
            f = write(r)
            data = harm(r, f)
            if data is not None:
                break
        else:
            return
        harmed.append(write)
        # (without its name a damaged .node file may be lines of numbers)
        done = read_file(checked, f, data, pipe=r.random() < .2 and
                         write is not generate.node)
        if done.code == 2:
            assert re.search(words + ANYWAY, done.words), (done.words, data)
            assert done.words.count("\n") < 6, (done.words, data)
        elif not re.search(words, done.words):
            assert data == f.bytes(), (done.words, data)

    jobs = [(write, k) for write in FORMATS for k in range(2 if everything else 1)]
    list(checked.pool.map(lambda job: one(*job), jobs))
    assert harmed
