"""test_outputs.py - what build/tess does to files: nothing to an input, and to an
output nothing but to replace it by the whole new one.

Each test is one of all options and endings of a file to write, and, of what files
are, of two builds: that for POSIX systems, and that for others, which know names
alone.
"""
import csv
import os
import random
import re
import resource
import shlex
import signal
import subprocess
import threading

import pytest

from common import TOP, build_tess

# What is linked to the program's files instead of its own: calls that write are
# counted; AT=N: at that one the signal SIGNAL comes, COUNT=yes: how many there
# are; those behind an error may be few; there is room for ROOM bytes.
MEDDLE = """
#define _XOPEN_SOURCE 600
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>
#define FEW 2000
int program(int argc, char **argv);
int count_putc(int c, FILE *file);
int count_printf(FILE *file, const char *format, ...);
size_t count_fwrite(const void *a, size_t size, size_t n, FILE *file);
static long calls, late, at;
static int which;
static long given(const char *name)
{
    return getenv(name) ? atol(getenv(name)) : 0;
}
static void call(FILE *file)
{
    if (file == stdout || file == stderr) return;
    if (++calls == at) raise(which);
    if (ferror(file) && ++late > FEW) {
        fprintf(stderr, "goes on behind an error\\n");
        exit(9);
    }
}
int count_putc(int c, FILE *file)
{
    call(file);
    return putc(c, file);
}
int count_printf(FILE *file, const char *format, ...)
{
    va_list list;
    int n;
    call(file);
    va_start(list, format);
    n = vfprintf(file, format, list);
    va_end(list);
    return n;
}
size_t count_fwrite(const void *a, size_t size, size_t n, FILE *file)
{
    call(file);
    return fwrite(a, size, n, file);
}
int room(const char *folder, struct room *v)
{
    (void)folder;
    memset(v, 0, sizeof *v);
    v->f_blocks = 1;
    v->f_frsize = 1000;
    v->f_bavail = (fsblkcnt_t)(getenv("ROOM") ? given("ROOM") / 1000 : 999999999);
    return 0;
}
int main(int argc, char **argv)
{
    int code;
    which = (int)given("SIGNAL");
    at = given("AT");
    /* (a shell's background processes ignore them) */
    signal(SIGINT, getenv("IGNORED") ? SIG_IGN : SIG_DFL);
    signal(SIGQUIT, SIG_DFL);
    code = program(argc, argv);
    if (getenv("COUNT")) fprintf(stderr, "%ld calls\\n", calls);
    return code;
}
"""
COUNTED = "places shapes validate draw/draw draw/page draw/slice driver".split()
# all files that can be written (@ is a blank before what an option has besides)
ALL = """
-mesh vtk
-mesh vtu
-mesh msh
-mesh node
-mesh ele
-mesh neigh
-face face
-face obj
-face off
-face ply
-face stl
-face vtk
-face vtu
-iso@20,30 stl
-iso@20,30 obj
-iso@20 ply
-iso@20 vtk
-vtk vtk
-node node
-ele ele
-neigh neigh
-cells vtk
-volumes csv
-faces csv
-svg svg
-values csv -grid 9,9,1
-values npy -grid 9,9,1
-values vtu -grid 9,9,1
-values vtk -grid 9,9,1
-values svg -grid 9,9,1
-values csv -query places
-values npy -query places
-values vtu -query places
-errors csv -validate
"""
ALL = [line.split() for line in ALL.split("\n") if line]
SYSTEMS = {"posix": [], "plain": ["-U__unix__", "-U__APPLE__"]}
r = random.Random(3)
POINTS = "x,y,z,T,U\n" + "".join("%f,%f,%f,%d,%d\n" % (
    r.random(), r.random(), r.random(), k, k * k) for k in range(60))
PLACES = "".join("%f %f %f\n" % (r.random(), r.random(), r.random())
                 for k in range(9000))
LARGE = "x,y,z,T,U\n" + "".join("%f,%f,%f,%d,%d\n" % (
    r.random(), r.random(), r.random(), k, k * k) for k in range(3000))


@pytest.fixture(scope="session")
def systems(tmp_path_factory):
    """the program with MEDDLE, for these systems, between which write.c tells"""
    folder = tmp_path_factory.getbasetemp() / "systems"
    flags = ["-O0", "-Dputc=count_putc", "-Dfprintf=count_printf", "-I.",
             "-Dfwrite=count_fwrite", "-Dstatvfs=room", "-Dmain=program"]

    def compiled(name, where, *more):
        where.mkdir(exist_ok=True)
        made = where / (os.path.basename(name) + ".o")
        subprocess.run([os.environ.get("CC", "cc"), *flags, *more, "-c", "-o", made,
                        "test/cli/src/%s.c" % name], cwd=TOP, check=True)
        return made

    common = [compiled(name, folder) for name in COUNTED]
    (folder / "meddle.c").write_text(MEDDLE)
    for system, more in SYSTEMS.items():
        parts = [folder / "meddle.c", compiled("write", folder / (system + "-"), *more),
                 *common]
        # (without shared libraries, where it can be, it starts sooner)
        assert 0 in (build_tess(folder / system, (), "-O0", "-Dstatvfs=room", *static,
                                more=parts).returncode for static in (["-static"], []))
    return {system: str(folder / system) for system in SYSTEMS}


@pytest.fixture(params=SYSTEMS)
def program(request, systems):
    return systems[request.param]


@pytest.fixture
def posix(systems, tmp_path):
    return systems["posix"]


class Files:
    """The files of a directory, and what is run there."""

    def __init__(self, path):
        self.path = path

    def all(self):
        return {str(p): p.read_bytes() for p in [
            *self.path.iterdir(), *(self.path / "d").iterdir()] if p.is_file()}

    def run(self, *command, **more):
        """a command, or one of sh"""
        command = command if len(command) > 1 else ["sh", "-c", *command]
        environment = {k: str(more.pop(k)) for k in list(more) if k.isupper()}
        return subprocess.run(command, stdin=subprocess.DEVNULL, timeout=100,
                              capture_output=True, text=True,
                              env={**os.environ, **environment}, **more)

    def refused(self, words, *command, **more):
        """exit code 2, one line on standard error that says words, nothing on
        standard output, and no file is another one"""
        before = self.all()
        done = self.run(*command, **more)
        assert (done.returncode, done.stdout) == (2, ""), (command, done)
        assert re.fullmatch(".*%s.*\n" % words, done.stderr), (command, done)
        assert self.all() == before, command


@pytest.fixture
def files(tmp_path):
    (tmp_path / "d").mkdir()
    (tmp_path / "sd").symlink_to("d")
    for name, text in ("points", POINTS), ("places", PLACES), ("large", LARGE):
        (tmp_path / name).write_text(text)
    return Files(tmp_path)


@pytest.fixture
def some(everything, request):
    """some(list, n): all of it; without --all each n-th, by turns"""
    def some(ways, n):
        return ways if everything else ways[sum(request.node.name.encode()) % n::n]
    return some


def spelled(f):
    return f, "./" + f, os.path.abspath(f), "d/../" + f


each_output = pytest.mark.parametrize("option, ending, more", [
    pytest.param(o.split("@"), e, more, id=" ".join([o, "F." + e, *more]))
    for o, e, *more in ALL])


def test_all_options_that_write_a_file_are_here():
    text = (TOP / "test/cli/src/options.c").read_text()
    assert {o.split("@")[0] for o, *_ in ALL} == set(re.findall(
        r'(?m)^ *\{"(-[a-z]*)", "(?:.* )?F[.a-z]*", take_[ol]', text))


def test_all_endings_are_here():
    text = (TOP / "test/cli/src/options.c").read_text()
    text = text[text.index("const form values_forms"):text.index(
        "const form svg_forms")] + text[text.index("const form svg_forms"):].split(
            "\n\n")[0].splitlines()[0]
    assert {e for _, e, *_ in ALL} >= set(re.findall(r'"\.([a-z]*)"', text))


# ---- an input ----

def of_input(files, f):
    for name in f, "d/" + f, "out.%s.part" % f:
        (files.path / name).write_text(POINTS)


@each_output
def test_input_is_never_overwritten(program, files, some, option, ending, more):
    """by whatever name"""
    f = "input." + ending
    of_input(files, f)
    for other in some(spelled(f), 4):
        for words, names in (("^tess: %s: would overwrite the input" % f, (f, other)),
                             (": would overwrite the input", (other, f))):
            files.refused(words + "$", program, *more, *option, *names)
    files.refused("would overwrite the input, out.%s.part$" % f, program, *more,
                  *option, "out." + f, "out.%s.part" % f)
    files.refused("would overwrite the input, .*d/../out.%s.part$" % f, program,
                  *more, *option, "d/../out." + f, "out.%s.part" % f)


@each_output
def test_nor_by_a_link_or_what_is_open(posix, files, some, option, ending, more):
    f = "input." + ending
    of_input(files, f)
    (files.path / "link").symlink_to(f)
    (files.path / ("link." + f)).symlink_to(f)
    mine = "^tess: %s: would overwrite the input$" % f
    files.refused(mine, posix, *more, *option, f, "link")
    files.refused("^tess: sd/%s: would overwrite the input$" % f, posix, *more,
                  *option, "sd/" + f, "d/" + f)
    files.refused("^tess: link.%s: would overwrite the input$" % f, posix, *more,
                  *option, "link." + f, f)
    command = " ".join([shlex.quote(posix), *more, *option])
    streams = "standard output or error would overwrite the input$"
    for words, rest in some((
            (mine, "{f} < {f}"), (mine, "{f} - < {f}"),
            ("would overwrite the input, out.%s.part$" % f,
             "out.{f} < out.{f}.part"),
            (streams, "- {f} >> {f}"), (streams, "other.{f} >> {f} < {f}"),
            ("standard output goes there, too", "{f} points >> {f}"),
            ("/dev/fd/4: is a symbolic link", "/dev/fd/4 points 4>> {f}"),
            ("/dev/fd/0: would overwrite the input", "/dev/fd/0 < {f}")), 2):
        if "/dev/fd" not in rest or os.path.isdir("/dev/fd"):
            files.refused(words, command + " " + rest.format(f=f))


@pytest.mark.parametrize("ending", ["csv", "npy", "vtu"])
def test_places_are_never_overwritten(program, files, ending):
    (files.path / ("p." + ending)).write_text(PLACES)
    files.refused("would overwrite the places$", program, "-query", "p." + ending,
                  "-values", "d/../p." + ending, "points")


def test_places_that_are_open_are_never_overwritten(posix, files):
    (files.path / "p.csv").write_text(PLACES)
    files.refused("would overwrite the places$", shlex.quote(posix) +
                  " -query - -values p.csv points < p.csv")


# ---- two outputs ----

@each_output
def test_no_file_is_written_twice_nor_over_a_partial_one(
        program, files, some, option, ending, more):
    f = "out." + ending
    for other in some(spelled(f), 4):
        files.refused("the name of two outputs$", program, *more, *option, f,
                      *option, other, "points")
        files.refused("the name of two outputs$", program, *more, *option, other,
                      *option, f, "points")
        (files.path / f).write_text("old\n")
        files.refused("the name of two outputs$", program, *more, *option, f,
                      *option, other, "points")
        (files.path / f).unlink()
    (files.path / (f + ".part")).write_text("another\n")
    files.refused(f + ".part is there, of another run, perhaps: remove it", program,
                  *more, *option, f, "points")


def test_outputs_of_two_options_are_two(program, files):
    files.refused("the name of two outputs$", program, "-o", "d/o", "-node",
                  "d/../d/o.node", "points")
    files.refused("the name of two outputs$", program, "-ele", "-", "-node", "-",
                  "points")
    assert files.run(program, "-node", "/dev/null", "-ele", "/dev/null",
                     "points").returncode == 0


def test_two_outputs_by_a_link(posix, files):
    files.refused("the name of two outputs$", posix, "-node", "d/o.node", "-mesh",
                  "sd/o.node", "points")


# ---- stopped ----

@pytest.fixture
def no_core():
    limits = resource.getrlimit(resource.RLIMIT_CORE)
    resource.setrlimit(resource.RLIMIT_CORE, (0, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_CORE, limits)


def stopped(files, program, which, option, ending, more, everything):
    """as the signal comes, whenever it does, no file is another one"""
    command = program, "-q", *more, *option, "stopped." + ending, "points"
    done = files.run(*command, COUNT="yes")
    calls = int(re.search(r"(\d+) calls\n", done.stderr)[1])
    assert calls > 3
    (files.path / ("stopped." + ending)).write_text("old\n")
    before = files.all()
    for at in (1, 2, calls // 3, 2 * calls // 3, calls) if everything else (
            1, 2 * calls // 3, calls):
        done = files.run(*command, AT=at, SIGNAL=int(which))
        assert done.returncode == -which, (at, calls, done)
        assert files.all() == before, (at, calls)


@each_output
def test_ctrl_c_leaves_nothing(program, files, everything, option, ending, more):
    stopped(files, program, signal.SIGINT, option, ending, more, everything)


@pytest.mark.parametrize("which", [signal.SIGHUP, signal.SIGQUIT, signal.SIGPIPE,
                                   signal.SIGTERM], ids=lambda s: s.name)
def test_nor_does_another_signal(program, files, no_core, which):
    stopped(files, program, which, ["-mesh"], "vtk", [], True)


def test_signal_that_is_ignored(program, files):
    assert files.run(program, "-q", "-node", "ignored.node", "points", AT=99,
                     SIGNAL=2, IGNORED="yes").returncode == 0
    assert (files.path / "ignored.node").stat().st_size > 0


# ---- a disk that is full ----

@each_output
def test_full_disk_ends_it_at_once_and_leaves_nothing(program, files, option, ending,
                                                      more):
    more = [w.replace("9,9,1", "99,99,1") for w in more]
    f = "full." + ending
    (files.path / f).write_text("old\n")

    def small():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))

    done = files.run(program, "-q", *more, *option, f, "large", preexec_fn=small)
    assert done.returncode == 2
    assert re.search("(?m)^tess: %s: (write error$|no room for a temporary)" % f,
                     done.stderr)
    assert (files.path / f).read_text() == "old\n"
    assert not (files.path / (f + ".part")).exists()
    if os.path.exists("/dev/full"):
        done = files.run(program, "-q", *more, *option, "/dev/full", "large")
        assert done.returncode == 2
        assert "tess: /dev/full: write error\n" in done.stderr


def meanwhile(files, program, name, change):
    """tess -node NAME, during which a change is made"""
    os.mkfifo(files.path / "fifo")
    started = subprocess.Popen([program, "-q", "-node", name, "fifo"],
                               stderr=subprocess.PIPE, text=True)

    def write():
        with open(files.path / "fifo", "w") as f:  # (when tess has opened it)
            change()
            f.write(POINTS)

    writer = threading.Thread(target=write, daemon=True)
    writer.start()
    said = started.communicate(timeout=60)[1]
    writer.join(60)
    return started.returncode, said


def test_what_cannot_have_its_name_stays_and_is_whole(program, files):
    path = files.path / "rename.node"
    files.run(program, "-q", "-node", "right.node", "points")

    def a_directory():
        path.mkdir()
        (path / "kept").write_text("kept")

    code, said = meanwhile(files, program, "rename.node", a_directory)
    assert code == 2
    assert re.search("(?m)^tess: rename.node: .*; all that was to be in it is in "
                     "rename.node.part", said)
    assert (files.path / "rename.node.part").read_bytes() == (
        files.path / "right.node").read_bytes() != b""


def test_partial_file_that_has_come_stays(posix, files):
    path = files.path / "meets.node.part"
    code, said = meanwhile(files, posix, "meets.node",
                           lambda: path.write_text("another"))
    assert code == 2 and path.read_text() == "another"


@pytest.mark.parametrize("closed", [">&-", "2>&-", ">&- 2>&-"])
def test_what_is_closed_is_no_file(posix, files, closed):
    files.run(posix, "-node", "right.node", "points")
    files.run("%s -node closed.node points %s" % (shlex.quote(posix), closed))
    assert (files.path / "closed.node").read_bytes() == (
        files.path / "right.node").read_bytes() != b""


def test_closed_standard_output_is_an_error(posix, files):
    assert files.run(shlex.quote(posix) + " -q -node - points >&-").returncode == 2


# ---- sizes ----

@pytest.mark.parametrize("side, size", [(1291, 17213481), (3000, 216000000),
                                        (30000, 216000000000)])
def test_grid_that_is_too_large_is_refused_before_anything_is_read(
        program, files, side, size):
    files.refused("[^0-9]%d[0-9]* bytes .* a column" % size, program, "-grid",
                  "%d,%d,%d" % (side, side, side), "-values", "big.npy", "nowhere")


# so many bytes, to the thousand, are what it needs; for less it is refused before
# there is a mesh, and no file is another one
@pytest.mark.parametrize("size, options", [
    (2000000, "-grid 5,50,500 -values v.npy"),
    (2000000, "-grid 5,50,500 -values v.vtk"),
    (4000000, "-grid 5,50,500 -values v.vtk -values v.npy"),
    (144000, "-query places -values v.npy")])
def test_size_is_what_is_needed(posix, files, size, options):
    files.refused("%d bytes .* do not fit where" % size, posix, *options.split(),
                  "points", ROOM=size - 1000)
    assert files.run(posix, "-q", *options.split(), "points",
                     ROOM=size + 999).returncode == 0


@pytest.mark.parametrize("room, size, options", [
    # (columns of text have at least two bytes)
    (900000, "1250000", "-grid 5,50,500 -values v.csv"),
    (900000, "[0-9]*", "-grid 5,50,500 -values v.vtu"),
    *((1000, "f.vt[ku]: [1-9][0-9]*", o) for o in (
        "-mesh f.vtk", "-mesh f.vtu", "-face f.vtu", "-cells f.vtk"))])
def test_what_does_not_fit_is_refused(posix, files, room, size, options):
    files.refused(size + " bytes .* do not fit where", posix, "-q",
                  *options.split(), "points", ROOM=room)


def test_gigabytes_are_said_before_there_is_a_mesh(posix, files):
    (files.path / "line").write_text("".join("%d %d %d 7\n" % (2 * k, k, 3 * k)
                                             for k in range(3)))
    said = files.run(posix, "-q", "-grid", "1000,1000,999", "-values", "v.npy",
                     "line").stderr.splitlines()
    assert "v.npy: about 8.0 GB" in said[0] and "lie on one line" in said[1]


@pytest.mark.parametrize("words, options", [
    ("Z1 = 1e.300 is beyond the range",
     "-scale 1,1,1e100 -grid 2,2,2,0,1,0,1,0,1e300 -values v.npy points"),
    ("place 2 is beyond the range",
     "-q -scale 1,1,1e100 -query far -values v.npy points")])
def test_scale_beyond_the_range_of_numbers(posix, files, words, options):
    (files.path / "far").write_text("0 0 0\n0 0 1e300\n")
    files.refused(words, posix, *options.split())


# ---- names, as they come back ----

NAMES = '"#x",y,"z, m","T, ""in""","a;b",c|d,"!e","/f","it\'s",50%,g\n' + "".join(
    "%d,%d,%d,1,2,3,4,5,6,7,%d\n" % (*p, 8 + p[2]) for p in (
        (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)))


@pytest.mark.parametrize("options", [
    "-grid 2,2,2 -outside nearest -values", "-query names -qcols 1,2,3 -values",
    "-volumes"])
def test_names_with_marks_come_back(posix, files, tmp_path, options):
    (tmp_path / "names").write_text(NAMES)
    wanted = next(csv.reader(NAMES.splitlines()))[3:]
    given = "names"
    # (what -volumes writes has words of blanks: it is not read again)
    for made in ["names.csv", "again.csv"][:1 + (options != "-volumes")]:
        files.run(posix, "-q", "-cols", "1,2,3", *options.split(), made, given)
        text = (tmp_path / made).read_text()
        assert ',"T, ""in""","a;b","c|d","!e","/f",it\'s,50%,g' in text
        names = next(csv.reader(text.splitlines()))
        at = names.index(wanted[0])
        assert names[at:at + len(wanted)] == wanted
        given = made
