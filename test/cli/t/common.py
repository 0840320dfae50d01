"""common.py - what tests of build/tess share."""
import collections
import concurrent.futures
import itertools
import os
import pathlib
import re
import resource
import signal
import subprocess
import threading

# where pytest was started
TOP = pathlib.Path(os.getcwd())
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


def limited(program, *arguments, file=None, memory=None):
    """program, with so many bytes of a file, or of memory"""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        for which, size in (resource.RLIMIT_FSIZE, file), (resource.RLIMIT_AS, memory):
            if size:
                resource.setrlimit(which, (size, size))
    return subprocess.run([program, *arguments], capture_output=True, text=True,
                          timeout=100, preexec_fn=limit)


def build_tess(path, again, *flags, more=()):
    """The program once more, with these of its sources compiled by these flags, and
    with more files, each instead of its own one of that name"""
    makefile = (TOP / "Makefile").read_text().replace("\\\n", " ")
    names = re.search("(?m)^PROGRAM = (.*)", makefile)[1].split()
    folders = "test/cli/src", "test/cli/src/*", "test/recipes", "test/lib"
    others = {*again, *(pathlib.Path(p).stem for p in more)}
    return subprocess.run(
        [os.environ.get("CC", "cc"), *flags, "-I.", "-o", path, *more] +
        [p for f in folders for p in TOP.glob(f + "/*.c") if p.stem in again and
         "build/%s.o" % p.stem in names] +
        [n for n in names if os.path.basename(n)[:-2] not in others] +
        ["build/tess.o", "build/hhpred.o", "-lm"], cwd=TOP, capture_output=True)
