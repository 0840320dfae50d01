"""common.py - what tests of build/tess share."""
import collections
import concurrent.futures
import itertools
import os
import pathlib
import re
import subprocess
import sys
import threading

try:
    import numpy as np
except ImportError:
    pass

TESS = sys.argv[1] if len(sys.argv) > 1 else ""

# where pytest was started; its scripts run elsewhere
TOP = pathlib.Path(os.environ.setdefault("TESS_TOP", os.getcwd()))
# test/cli/src/read
READERS = ("scan cell rows names doubts voids formats tables meshes models "
           "atoms arrays").split()
Read = collections.namedtuple("Read", "code points words out")


class Reader:
    """read(name, content, *options) has tess read a file of this name, in a
    directory of the thread's own: .code, the exit code; .points, what it wrote to
    the options' NODE and CELLS; .words, messages, with F for the file and D for
    the directory; .out, standard output.

    Of options F is the file, which else is the last one; - standard input, ! no
    name, GONE a file that there is not, DIR the directory, IN four points with
    values, OUT a CSV file."""

    def __init__(self, program, folder):
        self.program, self.folder = program, str(folder)
        self.number = itertools.count()
        self.thread = threading.local()
        self.pool = concurrent.futures.ThreadPoolExecutor(2)
        self.heard = set()
        with open(os.path.join(self.folder, "points.txt"), "w") as f:
            f.write("-9 -9 -9 -54\n30 -9 -9 -15\n-9 30 -9 24\n-8 -8 30 66\n")

    def place(self):
        if not hasattr(self.thread, "folder"):
            self.thread.folder = os.path.join(self.folder, "in%d" % next(
                self.number))
            os.mkdir(self.thread.folder)
        return self.thread.folder

    def __call__(self, name, content, *options):
        folder = self.place()
        path = os.path.join(folder, name)
        where = {"F": path, "GONE": path + "gone", "DIR": folder, "!": None,
                 "OUT": path + ".csv", "IN": self.folder + "/points.txt",
                 "NODE": folder + "/out.node", "CELLS": folder + "/cells.csv"}
        words = [where.get(o, o) for o in options]
        if not {"F", "-", "!", "GONE", "DIR"} & set(options):
            words.append(path)
        with open(path, "wb") as f:
            f.write(content if isinstance(content, bytes) else content.encode())
        with open(path, "rb") as f:
            done = subprocess.run(
                [self.program] + [w for w in words if w is not None], stdin=f,
                capture_output=True, timeout=60)
        # (how far it is, on a machine that is slow enough to be told)
        said = re.sub(r"(?m)^tess: (\d+ tetrahedra after|.*: \d+ (%, about|MB$)).*\n",
                      "", done.stderr.decode(errors="surrogateescape"))
        said = said.replace(path, "F").replace(folder, "D")
        self.heard.update(said.splitlines())
        points = ""
        for out in [o for o in ("NODE", "CELLS") if o in options]:
            if os.path.exists(where[out]):
                with open(where[out], encoding="utf-8",
                          errors="surrogateescape") as f:
                    points += f.read()
                os.remove(where[out])
        return Read(done.returncode, points, said, done.stdout.decode(
            errors="surrogateescape"))

    def many(self, jobs):
        """the results of these (name, content, *options)"""
        return list(self.pool.map(lambda job: self(*job), jobs))


def script(name, *arguments):
    """A script of this directory, which prints `ok ...' or `FAILED ...' for each
    of its tests, and nothing on standard error."""
    done = subprocess.run(
        [sys.executable, os.path.join(os.path.dirname(__file__), name)] +
        [str(a) for a in arguments], capture_output=True, text=True)
    lines = done.stdout.splitlines()
    bad = [s for s in lines if s[:2] != "ok"]
    assert (done.returncode, done.stderr, bad) == (0, "", [])
    assert len(lines) > 5


def test(name, good):  # (of scripts)
    print("ok      " + name if good else "FAILED  " + name, flush=True)


def run(*arguments):
    return subprocess.run([TESS] + [str(a) for a in arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          universal_newlines=True, timeout=200)


def tess(*arguments):
    """What it said, if it did not fail."""
    done = run(*arguments)
    if done.returncode != 0:
        print("FAILED  tess %s: %s" % (arguments, done.stderr))
        sys.exit(1)
    return done


def near(a, b, most):
    """Within most of each other, NaN at the same places."""
    return a.shape == b.shape and bool(
        np.all(np.isnan(a) == np.isnan(b)) and
        np.all(np.abs(a - b)[~np.isnan(a)] <= most))
