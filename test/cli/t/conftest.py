"""conftest.py - what all tests of build/tess share: how it is run, what the
machine lacks, and TAP.

    pytest test/cli/t [--tess PROGRAM] [--all] [--tap]

--tess: the program, else $TESS or build/tess.  --all, or ALL in the environment:
more examples, and tests that take long.  --tap: `ok N - NAME' or `not ok N -
NAME' for each test, `# SKIP WHY', and a plan, as prove(1) reads them.
"""
import collections
import os
import re
import subprocess
import sys

import pytest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True
# (of small matrices, as NumPy has here, threads make more work)
os.environ["OPENBLAS_NUM_THREADS"] = "1"
os.environ.setdefault("HYPOTHESIS_STORAGE_DIRECTORY",
                      os.path.abspath("build/hypothesis"))

import common  # noqa: E402
from common import TOP  # noqa: E402

try:
    from hypothesis import HealthCheck, settings
except ImportError:
    pass
else:
    # the same examples everywhere; tests of programs have no time limit
    for profile, examples in ("few", 25), ("many", 100):
        settings.register_profile(
            profile, derandomize=True, database=None, deadline=None,
            max_examples=examples, suppress_health_check=list(HealthCheck))

Result = collections.namedtuple("Result", "code out err")


def pytest_addoption(parser):
    parser.addoption("--tess", default=os.environ.get("TESS"),
                     help="the program, else $TESS, else build/tess")
    parser.addoption("--all", action="store_true", default=bool(
        os.environ.get("ALL")), help="all examples, and tests that take long")
    parser.addoption("--tap", action="store_true", help="print TAP")


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    config.addinivalue_line("markers", "long: run by --all alone")
    if "hypothesis" in sys.modules:
        settings.load_profile("many" if config.getoption("all") else "few")
    if config.getoption("tap"):
        config.pluginmanager.unregister(name="terminalreporter")
        config.pluginmanager.register(Tap(), "tap")


def pytest_collection_modifyitems(config, items):
    if not config.getoption("all"):
        items[:] = [item for item in items if not item.get_closest_marker("long")]


class Tap:
    """Writes TAP in the place of pytest's own report."""
    tests = 0

    def line(self, good, name, why=""):
        self.tests += 1
        print("%sok %d - %s%s" % ("" if good else "not ", self.tests,
                                  name.replace("#", "\\#"), why), flush=True)

    def pytest_runtest_logreport(self, report):
        name = report.nodeid.rpartition("/")[2]
        if report.skipped:
            self.line(True, name, " # SKIP " + report.longrepr[2].partition(
                "Skipped: ")[2])
        elif report.failed or report.when == "call":
            self.line(report.passed, name)
            for text in report.longreprtext.splitlines() * report.failed:
                print("# " + text)

    def pytest_collectreport(self, report):
        if report.skipped or report.failed:
            report.when = "collect"
            self.pytest_runtest_logreport(report)

    def pytest_sessionfinish(self):
        print("1..%d" % self.tests)


@pytest.fixture(scope="session")
def program(pytestconfig):
    """The path of tess."""
    return os.path.abspath(pytestconfig.getoption("tess") or
                           TOP / "build" / "tess")


def linked(path, sources, *flags):
    """build/tess once more, with these of its sources compiled with these flags;
    None if it cannot be, or is not what is tested"""
    done = common.build_tess(path, sources, *flags)
    return str(path) if done.returncode == 0 else None


@pytest.fixture(scope="session")
def read(program, pytestconfig, tmp_path_factory):
    """read(name, content, *options) of common.py, by a program without shared
    libraries, which starts sooner."""
    folder = tmp_path_factory.getbasetemp() / "read"
    folder.mkdir()
    quick = None if pytestconfig.getoption("tess") else linked(
        folder / "tess", (), "-static")
    return common.Reader(quick or program, folder)


@pytest.fixture(scope="session")
def everything(pytestconfig):
    """Are all examples wanted, and what takes long?"""
    return pytestconfig.getoption("all")


@pytest.fixture
def tmp_path(request, tmp_path_factory):
    """A directory of the test's own, in which it runs.  (pytest's own fixture
    looks at all that there are to find its name.)"""
    number = request.session.stash.setdefault(NUMBER, [0])
    number[0] += 1
    path = tmp_path_factory.getbasetemp() / ("%d" % number[0])
    path.mkdir()
    before = os.getcwd()
    os.chdir(path)
    yield path
    os.chdir(before)


NUMBER = pytest.StashKey()


@pytest.fixture
def tess(program, tmp_path):
    """tess(*arguments, stdin=None) runs it in tmp_path and returns its exit code
    and what it writes, as text: .code, .out, .err.  stdin is text or bytes."""
    def run(*arguments, stdin=None, timeout=100):
        if isinstance(stdin, str):
            stdin = stdin.encode()
        done = subprocess.run(
            [program] + [str(a) for a in arguments], capture_output=True,
            timeout=timeout, **{"stdin": subprocess.DEVNULL} if stdin is None
            else {"input": stdin})
        return Result(done.returncode, *(
            s.decode(errors="surrogateescape") for s in (done.stdout,
                                                         done.stderr)))
    return run


@pytest.fixture
def run(tess):
    """run(*arguments): tess, which must not fail"""
    def run(*arguments):
        done = tess(*arguments)
        assert done.code == 0, done.err
        return done
    return run


@pytest.fixture
def refused(tess, tmp_path):
    """refused(words, *arguments): tess has exit code 2, one line on standard error that
    words fit, nothing on standard output, and no file"""
    def refused(words, *arguments, **more):
        before = sorted(tmp_path.iterdir())
        done = tess(*arguments, **more)
        assert (done.code, done.out) == (2, "")
        assert re.fullmatch(".*(?:%s).*\n" % words, done.err)
        assert sorted(tmp_path.iterdir()) == before
    return refused


@pytest.fixture
def values(run):
    """values(points, *options, at=places) is what tess interpolates, an array.
    points: the file's name, or columns for beside.save; places: such columns.
    values.out and values.err: what is printed."""
    from beside import np, save

    def values(points, *options, at=None):
        if not isinstance(points, str):
            points = save("points.csv", *points)
        if at is not None:
            options += "-query", save("at.csv", at)
        done = run(*options, "-values", "v.npy", points)
        values.out, values.err = done.out, done.err
        return np.load("v.npy")
    return values


@pytest.fixture(scope="session")
def checked(read, everything, pytestconfig, tmp_path_factory):
    """read, by a program that ends where an index is beyond its array, or with
    what C leaves open"""
    os.environ["ASAN_OPTIONS"] = "detect_leaks=0"
    folder = tmp_path_factory.getbasetemp() / "checked"
    folder.mkdir()
    # (by these, which look at each pointer, compilers take twice as long)
    less = [] if everything else [
        "-fno-sanitize=null,alignment,object-size,pointer-overflow"]
    built = None if pytestconfig.getoption("tess") else linked(
        folder / "tess", common.READERS, "-O0", "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all", *less)
    return common.Reader(built or read.program, folder)
