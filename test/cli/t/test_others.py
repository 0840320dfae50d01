"""test_others.py - files read by build/tess and by other programs.

What others write, and files of each format by generate.py, valid and damaged:
where both read a file they must have the same points, values and box, bit for
bit, or in floats where the other one has them; where the other one alone refuses
a damaged file tess must have told something.  Beside programs that are small, or
modules, tests are skipped where they are not installed; beside large ones there
are none.
"""
import contextlib
import importlib
import importlib.util
import io
import itertools
import os
import pickle
import random
import re
import select
import shutil
import subprocess
import sys
import warnings

import pytest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import generate  # noqa: E402

np = pytest.importorskip('numpy')

warnings.simplefilter('ignore')
TESS, MANY = 'tess', False  # its path, and are all examples wanted?  By a fixture
PATIENCE = 30  # seconds that a reader has for a file, when it has begun, too


class Refused(Exception):
    pass


def tess(name, *options):
    """points, values, what is told; box's volume by -volumes"""
    p = subprocess.run([TESS, *options, '-node', '-', name],
                       stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                       stderr=subprocess.PIPE)
    said = p.stderr.decode(errors='replace')
    if p.returncode:
        raise Refused(said)
    rows = [line.split()[1:] for line in p.stdout.decode().split('\n')
            if line and line[0] != '#'][1:]
    a = np.array(rows, float)
    return a[:, :3], a[:, 3:], [s for s in said.split('\n')
                                if s.startswith('tess: ')]


def volume(name, *options):
    p = subprocess.run([TESS, '-periodic', '-volumes', os.devnull, *options,
                        name], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                       stderr=subprocess.STDOUT)
    found = re.search(rb"the box's is (\S+)", p.stdout)
    return float(found.group(1)) if found else None


def command(*words, **more):
    p = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                       stderr=subprocess.STDOUT, **more)
    if p.returncode:
        raise Refused(p.stdout.decode(errors='replace'))


# ---- what others read: points, or points and values ----

class Apart:
    """what one module or command reads, in a process of its own, which may crash,
    or never end"""

    def __init__(self, need):
        self.need, self.process = need, None

    def read(self, number, name):
        """by that one of READERS"""
        if self.process is None:
            self.process = subprocess.Popen(
                [sys.executable, __file__, self.need], stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        try:
            self.process.stdin.write(b'%d %s\n' % (number, os.path.abspath(
                name).encode()))
            self.process.stdin.flush()
            ready = select.select([self.process.stdout], [], [], PATIENCE)[0]
            result = pickle.load(self.process.stdout) if ready else None
        except (EOFError, OSError, pickle.UnpicklingError):
            result = None
            ready = None
        if not ready:
            self.end()
        if result is None or len(result) == 0:
            raise Refused()
        return result

    def end(self):
        if self.process:
            self.process.kill()
            self.process.wait()
            self.process.stdin.close()
            self.process.stdout.close()
        self.process = None


def serve(need):
    """the other end of that"""
    out = os.fdopen(os.dup(1), 'wb')
    nothing = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nothing, 1)
    load(need)
    for line in sys.stdin:
        number, _, name = line.strip().partition(' ')
        os.chdir(os.path.dirname(name))
        try:
            result = READERS[int(number)][3](os.path.basename(name))
        except (Exception, SystemExit):
            result = None
        pickle.dump(result, out)
        out.flush()


def by_numpy(name):
    a = np.load(name)
    return a[:, :3].astype(float), a[:, 3:].astype(float)


# of a LAS header and the records 0 to 10, by the tables of the American Society
# for Photogrammetry and Remote Sensing (1.4 R15): no other program that Debian
# has reads it
LAS_HEAD = np.dtype([
    ('signature', 'S4'), ('source', '<u2'), ('encoding', '<u2'), ('guid', 'V16'),
    ('major', 'u1'), ('minor', 'u1'), ('system', 'S32'), ('software', 'S32'),
    ('day', '<u2'), ('year', '<u2'), ('size', '<u2'), ('offset', '<u4'),
    ('vlrs', '<u4'), ('format', 'u1'), ('length', '<u2'), ('points', '<u4'),
    ('returns', '<u4', 5), ('scale', '<f8', 3), ('shift', '<f8', 3),
    ('bounds', '<f8', 6)])
LAS_MORE = np.dtype([('waveform', '<u8'), ('evlr', '<u8'), ('evlrs', '<u4'),
                     ('points', '<u8'), ('returns', '<u8', 15)])
LAS_OLD = [('flags', 'u1'), ('class', 'u1'), ('angle', 'i1'), ('user', 'u1'),
           ('source', '<u2')]
LAS_NEW = [('flags', 'u1'), ('flags2', 'u1'), ('class', 'u1'), ('user', 'u1'),
           ('angle', '<i2'), ('source', '<u2'), ('time', '<f8')]
LAS_TIME, LAS_RGB = [('time', '<f8')], [('rgb', '<u2', 3)]
LAS_WAVE = [('descriptor', 'u1'), ('data', '<u8'), ('packet', '<u4'),
            ('location', '<f4'), ('vector', '<f4', 3)]
LAS_RECORDS = [
    LAS_OLD, LAS_OLD + LAS_TIME, LAS_OLD + LAS_RGB,
    LAS_OLD + LAS_TIME + LAS_RGB, LAS_OLD + LAS_TIME + LAS_WAVE,
    LAS_OLD + LAS_TIME + LAS_RGB + LAS_WAVE, LAS_NEW, LAS_NEW + LAS_RGB,
    LAS_NEW + LAS_RGB + [('infrared', '<u2')], LAS_NEW + LAS_WAVE,
    LAS_NEW + LAS_RGB + [('infrared', '<u2')] + LAS_WAVE]


def by_fields(name):
    """LAS, by numpy's structured arrays"""
    data = open(name, 'rb').read()
    head = np.frombuffer(data, LAS_HEAD, 1)[0]
    if head['signature'] != b'LASF' or head['major'] != 1:
        raise Refused()
    n = int(head['points'])
    if head['minor'] >= 4:
        n = int(np.frombuffer(data, LAS_MORE, 1, 227)[0]['points'])
    record = [('xyz', '<i4', 3), ('intensity', '<u2')] + LAS_RECORDS[
        head['format']]
    more = int(head['length']) - np.dtype(record).itemsize
    rows = np.frombuffer(data, np.dtype(record + [('more', 'V%d' % more)] * (
        more != 0)), n, int(head['offset']))
    return rows['xyz'] * head['scale'] + head['shift'], \
        rows['intensity'][:, None].astype(float)


def by_meshio(form):
    def read(name):
        if form == 'tetgen':
            # (it wants tetrahedra)
            lines = [s.split() for s in open(name) if s.strip() and s[0] != '#']
            base = int(lines[1][0])
            with open(name[:-4] + 'ele', 'w') as file:
                file.write('1 4 0\n%d %d %d %d %d\n' % tuple(
                    base + k for k in (0, 0, 1, 2, 3)))
        return np.asarray(meshio.read(name, form).points, float)
    return read


def by_vtk(kind):
    def read(name):
        reader = getattr(vtk, 'vtk%sReader' % kind)()
        said = []
        reader.AddObserver('ErrorEvent', lambda *_: said.append(1))
        reader.SetFileName(name)
        if kind == 'STL':
            reader.MergingOff()
        reader.Update()
        points = reader.GetOutput().GetPoints()
        if said or points is None or points.GetNumberOfPoints() == 0:
            raise Refused()
        from vtk.util.numpy_support import vtk_to_numpy
        return vtk_to_numpy(points.GetData())
    return read


def by_stl(name):
    m = stl.mesh.Mesh.from_file(name, calculate_normals=False)
    return m.vectors.reshape(-1, 3)


def corner(name):
    """of a dump's box"""
    lines = open(name).read().split('\n')
    at = next(k for k, s in enumerate(lines) if s.startswith('ITEM: BOX'))
    rows = np.array([s.split() for s in lines[at + 1:at + 4]], float)
    xy, xz, yz = rows[:, 2] if rows.shape[1] > 2 else (0, 0, 0)
    return rows[:, 0] - [min(0, xy, xz, xy + xz), min(0, yz), 0]


def by_ase(form):
    def read(name):
        atoms = ase.io.read(name, 0, format=form)
        # (of scaled coordinates it leaves out the corner)
        if form == 'lammps-dump-text' and ' xs' in open(name).read():
            return atoms.positions + corner(name)
        return atoms.positions
    return read


def by_mdanalysis(form):
    def read(name):
        if form == 'LAMMPSDUMP':
            # (it has the box begin at 0; scaled ones it moves twice)
            times = 2 if ' xs' in open(name).read() else 1
            return MDAnalysis.coordinates.LAMMPS.DumpReader(
                name).ts.positions + times * corner(name)
        return MDAnalysis.Universe(name, format=form, topology_format=form
                                   ).atoms.positions
    return read


def by_gemmi(name):
    model = gemmi.read_pdb(name)[0]
    return np.array([a.pos.tolist() for c in model for s in c for a in s])


def by_pcl(name):
    """as PCL writes it anew, in text"""
    out = 'pcl.pcd'
    if os.path.exists(out):
        os.remove(out)
    command('pcl_convert_pcd_ascii_binary', name, out, '0')
    lines = open(out).read().split('\n')
    fields = next(s for s in lines if s.startswith('FIELDS')).split()[1:]
    at = [fields.index(c) for c in 'xyz']
    rows = lines[next(k for k, s in enumerate(lines) if s == 'DATA ascii') + 1:]
    return np.array([[row.split()[k] for k in at] for row in rows if row],
                    float)


def by_admesh(name):
    out = 'admesh.stl'
    if os.path.exists(out):
        os.remove(out)
    # (that it mends nothing)
    command('admesh', '--no-check', '--write-ascii-stl=' + out, name)
    return np.array(re.findall(r'vertex\s+(\S+)\s+(\S+)\s+(\S+)',
                               open(out).read()), float)


def by_assimp(name):
    out = 'assimp.obj'
    if os.path.exists(out):
        os.remove(out)
    command('assimp', 'export', name, out)
    return np.array([line.split()[1:4] for line in open(out)
                     if line.startswith('v ')], float)


# (program, module or command, format, reader, digits of what it has, of a set)
READERS = [
    ('numpy', 'numpy', 'npy', by_numpy, 'double', ''),
    ('fields in numpy', 'numpy', 'las', by_fields, 'double', ''),
    ('meshio', 'meshio', 'ply', by_meshio('ply'), 'double', ''),
    ('meshio', 'meshio', 'obj', by_meshio('obj'), 'double', ''),
    ('meshio', 'meshio', 'off', by_meshio('off'), 'double', ''),
    ('meshio', 'meshio', 'stl', by_meshio('stl'), 'double', 'set'),
    ('meshio', 'meshio', 'node', by_meshio('tetgen'), 'double', ''),
    ('VTK', 'vtk', 'ply', by_vtk('PLY'), 'float', ''),
    ('VTK', 'vtk', 'stl', by_vtk('STL'), 'float', ''),
    ('VTK', 'vtk', 'obj', by_vtk('OBJ'), 'float', 'used'),
    ('numpy-stl', 'stl', 'stl', by_stl, 'float', ''),
    ('admesh', '/admesh', 'stl', by_admesh, 'text', ''),
    ('assimp', '/assimp', 'ply', by_assimp, 'text', 'used'),
    ('assimp', '/assimp', 'off', by_assimp, 'text', 'used'),
    ('assimp', '/assimp', 'obj', by_assimp, 'text', 'used'),
    ('assimp', '/assimp', 'stl', by_assimp, 'text', 'set'),
    ('ase', 'ase', 'extended', by_ase('extxyz'), 'double', ''),
    ('ase', 'ase', 'pdb', by_ase('proteindatabank'), 'double', ''),
    ('ase', 'ase', 'dump', by_ase('lammps-dump-text'), 'sorted', ''),
    ('MDAnalysis', 'MDAnalysis', 'xyz', by_mdanalysis('XYZ'), 'float', ''),
    ('MDAnalysis', 'MDAnalysis', 'pdb', by_mdanalysis('PDB'), 'float', ''),
    ('MDAnalysis', 'MDAnalysis', 'dump', by_mdanalysis('LAMMPSDUMP'), 'text',
     ''),
    ('gemmi', 'gemmi', 'pdb', by_gemmi, 'double', ''),
    ('PCL', '/pcl_convert_pcd_ascii_binary', 'pcd', by_pcl, 'text', ''),
]


def equal(ours, theirs, way, of):
    """are these the same points, as far as the other program's numbers go?"""
    a, b = np.asarray(ours, float), np.asarray(theirs, float)
    if of:
        a, b = (np.unique(np.float32(x), axis=0) for x in (a, b))
        if of == 'used':
            # (points of no face it leaves out)
            rows = {tuple(x) for x in a}
            return len(b) > 0 and all(tuple(x) in rows for x in b)
    if a.shape != b.shape:
        return False
    if way == 'float':
        return np.array_equal(np.float32(a), np.float32(b), equal_nan=True)
    if way == 'text':
        return np.allclose(a, b, rtol=1e-5, atol=1e-6)
    if way == 'sorted':
        return np.allclose(a, b, rtol=0, atol=1e-14)
    return np.array_equal(a, b, equal_nan=True)


def files(form, many):
    """valid ones, then damaged ones: name, damage"""
    write = getattr(generate, form)
    r = random.Random('others ' + form)
    for k in range(2 * many):
        f = write(r)
        data, damage = f.bytes(), None
        while k >= many:
            damage = r.choice(generate.DAMAGES)
            data = damage[1](r, f)
            if data is not None and data != f.bytes():
                break
        name = '%s-%d.%s' % (form, k, 'xyz' if form == 'extended' else form)
        with open(name, 'wb') as file:
            file.write(data)
        yield name, damage


# What need not be there, as it is large
LARGE = ('MDAnalysis', '/assimp', '/lmp', '/pcl_convert_pcd_ascii_binary',
         '/Rscript', '/obabel')


def there(need):
    """is the module, or /command, installed?"""
    if need[0] == '/':
        return shutil.which(need[1:]) is not None
    return importlib.util.find_spec(need) is not None


def expected(programs):
    return [p for p in programs if there(p[1]) or p[1] not in LARGE]


def load(need):
    if need[0] == '/':
        return
    globals()[need] = importlib.import_module(need)
    if need == 'stl':
        importlib.import_module('stl.mesh')
    if need == 'ase':
        importlib.import_module('ase.io')
    if need == 'MDAnalysis':
        importlib.import_module('MDAnalysis.coordinates.LAMMPS')
    if need == 'vtk':
        vtk.vtkObject.GlobalWarningDisplayOff()


@pytest.fixture(scope='module')
def apart():
    """apart(need): the process of that, which all tests share"""
    running = {}
    yield lambda need: running.setdefault(need, Apart(need))
    for process in running.values():
        process.end()


@pytest.fixture(autouse=True)
def plain_files(program, tmp_path, monkeypatch, everything):
    """what others read, too"""
    monkeypatch.setattr(generate, 'plain', True)
    monkeypatch.setitem(globals(), 'TESS', program)
    monkeypatch.setitem(globals(), 'MANY', everything)


@pytest.mark.parametrize('reader', expected(READERS),
                         ids=lambda r: '%s %s' % (r[0], r[2]))
def test_both_read_the_same(reader, apart, everything):
    program, need, form, _, way, of = reader
    if not there(need):
        pytest.skip('beside %s, which is not installed' % program)
    same = 0
    for name, damage in files(form, 20 if everything else 5):
        kind = damage[0] if damage else 'valid'
        ours = theirs = None
        try:
            ours = tess(name)
        except Refused as e:
            assert damage, e
        try:
            theirs = apart(need).read(READERS.index(reader), name)
        except Refused:
            # (what it alone refuses is told)
            assert ours is None or not damage or ours[2], (name, kind)
        if ours is not None and theirs is not None:
            both = (ours[:2], theirs) if isinstance(theirs, tuple) else (
                ours[:1], (theirs,))
            alike = all(equal(a, b, way, of) for a, b in zip(*both))
            assert alike or (damage and ours[2]), (name, kind, ours, theirs)
            same += alike
    assert same > 0


# ---- what others write ----

def random_points(n=40, seed=3):
    return np.random.RandomState(seed).rand(n, 3) * 10 - 3


def check(name, points, values=None, box=None, options=(), way='double'):
    """what tess reads beside what was written"""
    p, v, said = tess(name, *options)
    assert equal(p, points, way, ''), (name, options, p[:5], points[:5])
    assert values is None or equal(v, values, way, ''), (name, options, v[:5])
    if box is not None:
        assert volume(name, *options) == pytest.approx(box, rel=1e-9)


def product(*lists):
    """of each list an element, of words each; all of them, or some"""
    return list(itertools.product(*(s.split() if isinstance(s, str) else s
                                    for s in lists)))[::1 if MANY else 3]


def numpy_writes():
    p = np.c_[random_points(), np.arange(40)]
    for kind, order, way in product('f4 f8 i1 i2 i4 i8 u1 u2 u4 u8', '< >', 'C F'):
        a = np.asarray(abs(p) if kind[0] == 'u' else p, order + kind, order=way)
        np.save('w.npy', a)
        check('w.npy', a[:, :3].astype(float), a[:, 3:].astype(float))


def savetxt_writes():
    """heads of names, in a comment or not, parted otherwise than the rows"""
    p = random_points()
    a = np.c_[p[:, 0] * 7, p]
    for head, comments, delimiter, fmt in product(
            ['T, X, Y, Z', 'T X Y Z', 'T;X;Y;Z', 'T\tX\tY\tZ',
             'made by hand\nT (K), x (m), y (m), z (m)'], ['# ', '% ', ''],
            [' ', ',', ';', '\t'], ['%.18e', '%.17g']):
        if comments or '\n' not in head:
            np.savetxt('w.txt', a, header=head, comments=comments,
                       delimiter=delimiter, fmt=fmt)
            check('w.txt', p, a[:, :1])


def r_writes():
    """tables with names of rows, which have no name, and without"""
    p = random_points()
    np.savetxt('a.txt', np.c_[p[:, 0] * 7, p], header='T x y z', comments='',
               fmt='%.17g')
    for order, names, how in product(
            ['', '[c(40:21, 1:20), c(3, 1, 4, 2)]'],
            ['', 'rownames(d) <- paste("row", 1:40);'],
            ['', 'sep = ",", ', 'sep = "\\t", quote = FALSE, ',
             'sep = ";", dec = ",", ', 'sep = ";", col.names = NA, ']):
        if names and 'FALSE' in how:
            continue
        command('Rscript', '-e', 'd <- read.table("a.txt", header = TRUE); %s options('
                'digits = 17); write.table(d%s, %sfile = "w.txt")' % (names, order, how))
        # (it writes 15 digits)
        check('w.txt', np.round(np.r_[p[39:19:-1], p[:20]] if order else p, 9),
              way='text', options=['-decimal', ','] if 'dec' in how else [])


def obabel_writes():
    p = np.round(random_points(), 3)
    with open('a.xyz', 'w') as f:
        f.write('40\n\n' + ''.join('C %.3f %.3f %.3f\n' % tuple(x) for x in p))
    command('obabel', 'a.xyz', '-O', 'w.pqr')
    check('w.pqr', p)


def pandas_writes():
    import csv
    p = random_points()
    d = pandas.DataFrame(np.c_[p, p[:, 0] * 7], columns=['x', 'y', 'z', 'T'])
    for sep, decimal, quoting, header, form, names in product(
            [',', ';', '\t', '|'], '. ,', [csv.QUOTE_MINIMAL, csv.QUOTE_ALL,
                                           csv.QUOTE_NONNUMERIC], [True, False],
            [None, '%.17g', '%.3e'], 'xyzT Tzyx'):
        if sep == decimal or not header and names != 'xyzT':
            continue
        d[list(names)].to_csv('w.csv', sep=sep, decimal=decimal, quoting=quoting,
                              header=header, index=False, float_format=form)
        b = pandas.read_csv('w.csv', sep=sep, decimal=decimal, header=0 if header else
                            None, float_precision='round_trip')
        b.columns = list(names)
        check('w.csv', b[list('xyz')].values, b[['T']].values,
              options=['-decimal', ','] if decimal == ',' else [])
    # what is missing, with an index, and names
    for mark in '', 'NA', 'nan', 'null', '-', '#N/A', 'N/A', 'None', '<NA>':
        q = d.copy()
        q.loc[3, 'T'] = q.loc[7, 'x'] = np.nan
        q.to_csv('w.csv', na_rep=mark)
        b = pandas.read_csv('w.csv', na_values=['-', 'None'],
                            float_precision='round_trip').dropna()
        check('w.csv', b[list('xyz')].values, b[['T']].values,
              options=['-skip', '-cols', 'x,y,z,T'])


def box_mesh():
    p = np.float32(random_points()).astype(float)
    faces = np.array([[k, k + 1, k + 2] for k in range(len(p) - 2)])
    return p, faces


def meshio_writes():
    p, faces = box_mesh()
    tets = np.array([[k, k + 1, k + 2, k + 3] for k in range(len(p) - 3)])
    for form, more in [('ply', {'binary': True}), ('ply', {'binary': False}),
                       ('stl', {'binary': True}), ('stl', {'binary': False}),
                       ('obj', {}), ('off', {}), ('tetgen', {})] + [
                           ('nastran', {'point_format': way})
                           for way in ('free', 'fixed-small', 'fixed-large')]:
        name = 'w.' + {'tetgen': 'node', 'nastran': 'bdf'}.get(form, form)
        # (it cannot write all numbers in a field)
        q = np.round(p, 4) if form == 'nastran' else p
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()):
            meshio.Mesh(q, [('tetra', tets) if form in ('tetgen', 'nastran') else (
                'triangle', faces)]).write(name, form, **more)
        check(name, p[faces].reshape(-1, 3) if form == 'stl' else q,
              way='text' if form == 'nastran' else 'double')


def vtk_writes():
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    p, faces = box_mesh()
    data, points, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetData(numpy_to_vtk(np.float32(p), 1))
    flat = np.c_[np.full(len(faces), 3), faces].astype(np.int64).ravel()
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(flat, 1))
    data.SetPoints(points)
    data.SetPolys(cells)
    for kind, way in ('PLY', 'Binary'), ('PLY', 'ASCII'), ('STL', 'Binary'), (
            'STL', 'ASCII'), ('OBJ', ''):
        writer, name = getattr(vtk, 'vtk%sWriter' % kind)(), 'w.' + kind.lower()
        writer.SetFileName(name)
        writer.SetInputData(data)
        if way:
            getattr(writer, 'SetFileTypeTo' + way)()
        writer.Write()
        check(name, p[faces].reshape(-1, 3) if kind == 'STL' else p,
              way='float' if way == 'Binary' else 'text')


def stl_writes():
    p, faces = box_mesh()
    m = stl.mesh.Mesh(np.zeros(len(faces), stl.mesh.Mesh.dtype))
    m.vectors[:] = p[faces]
    for mode, way in (stl.Mode.ASCII, 'text'), (stl.Mode.BINARY, 'float'):
        m.save('w.stl', mode=mode)
        check('w.stl', p[faces].reshape(-1, 3), way=way)


def admesh_writes():
    p, faces = box_mesh()
    with open('a.stl', 'w') as f:
        f.write('solid a\n' + ''.join(
            'facet normal 0 0 0\nouter loop\n' + ''.join(
                'vertex %.9g %.9g %.9g\n' % tuple(x) for x in t) +
            'endloop\nendfacet\n' for t in p[faces]) + 'endsolid a\n')
    for form, way in ('ascii', 'text'), ('binary', 'float'):
        command('admesh', '--no-check', '--write-%s-stl=w.stl' % form, 'a.stl')
        check('w.stl', p[faces].reshape(-1, 3), way=way)


def assimp_writes():
    p, faces = box_mesh()
    with open('a.obj', 'w') as f:
        f.write(''.join('v %.9g %.9g %.9g\n' % tuple(x) for x in p) + ''.join(
            'f %d %d %d\n' % tuple(t + 1) for t in faces))
    for form in 'ply', 'plyb', 'stl', 'stlb', 'obj':
        b = 'w.' + form[:3]
        command('assimp', 'export', 'a.obj', b, '-f' + form)
        q = tess(b)[0]
        near = [abs(p - x).sum(1).min() for x in q]
        assert len(q) >= len(p) - 2 and max(near) < 2e-5, (form, len(q), max(near))


def ase_writes():
    p = np.random.RandomState(1).rand(30, 3)
    for cell, pbc in product([[9, 10, 11], [[9, 0, 0], [2, 10, 0], [-1, 3, 11]]],
                             [True, [True, False, True]]):
        a = ase.Atoms('C30', scaled_positions=p, cell=cell, pbc=pbc)
        a.set_array('T', np.arange(30.) / 7)
        for name, form in ('w.xyz', 'extxyz'), ('w.pdb', 'proteindatabank'), (
                'p.xyz', 'xyz'):
            ase.io.write(name, a, format=form)
            b = ase.io.read(name, format=form)
            check(name, b.positions, b.get_array('T')[:, None] if form == 'extxyz' else
                  None, box=None if form == 'xyz' else b.get_volume())


def gemmi_writes():
    s = gemmi.Structure()
    s.name = 'none'
    s.cell = gemmi.UnitCell(30, 31, 32, 80, 95, 100)
    s.spacegroup_hm = 'P 1'
    model, chain = gemmi.Model('1'), gemmi.Chain('A')
    kept = []
    for k in range(60):
        residue = gemmi.Residue()
        residue.name, residue.seqid = 'ALA', gemmi.SeqId(str(k + 1))
        for j, place in enumerate(('\0',) if k % 5 else ('A', 'B')):
            atom = gemmi.Atom()
            atom.name, atom.element = 'CA', gemmi.Element('C')
            atom.pos = gemmi.Position(*np.round(random_points(1, k + 90 * j)[0], 3))
            atom.altloc, atom.occ, atom.b_iso = place, .5, k
            atom.serial = 99980 + k
            residue.add_atom(atom)
            if j == 0:
                kept.append(atom.pos.tolist())
        chain.add_residue(residue)
    model.add_chain(chain)
    s.add_model(model)
    name = 'w.pdb'
    s.write_pdb(name)
    check(name, np.array(kept), box=s.cell.volume)


LAMMPS = '''units lj
region box %s
create_box 1 box
create_atoms 1 random 40 12345 box
mass 1 1.0
pair_style zero 1.0
pair_coeff * *
comm_modify cutoff 2.0
velocity all create 1.0 4928
fix 1 all nve
dump 1 all custom 5 %s id type %s vx
dump_modify 1 format float %%.17g %s
thermo 100
run 10
'''


def lammps_writes():
    name = 'w.dump'
    block, prism = 'block -1 5 0 7 2 10', 'prism -1 5 0 7 2 10 1.5 -1 2'
    for (boundary, region), columns, sort in product(
            [('p p p', block), ('p p p', prism), ('p f p', block), ('s p p', block)],
            ['x y z', 'xu yu zu', 'xs ys zs'], ['', 'sort id']):
        if os.path.exists(name):
            os.remove(name)
        with open('in.lmp', 'w') as f:
            f.write('boundary ' + boundary + '\n' + LAMMPS % (
                region, name, columns, sort))
        command('lmp', '-in', 'in.lmp', '-log', 'none')
        lines = open(name).read().split('\n')
        rows = np.array([s.split() for s in lines[9:49]], float)
        p, b = rows[:, 2:5], np.array([s.split() for s in lines[5:8]], float)
        xy, xz, yz = b[:, 2] if region == prism else (0, 0, 0)
        low = np.array([min(0, xy, xz, xy + xz), min(0, yz), 0])
        high = np.array([max(0, xy, xz, xy + xz), max(0, yz), 0])
        size = b[:, 1] - b[:, 0] - high + low
        if columns == 'xs ys zs':
            m = np.diag(size)
            m[1, 0], m[2, 0], m[2, 1] = xy, xz, yz
            p = p @ m + b[:, 0] - low
        check(name, p, rows[:, [0, 1, 5]], way='sorted',
              box=np.prod(size) if boundary == 'p p p' else None)
        if there('ase'):
            load('ase')
            a = ase.io.read(name, 0, format='lammps-dump-text', order=False)
            b = a.positions
            if columns == 'xs ys zs':
                b = b + a.get_celldisp()[:].reshape(3)
            assert np.allclose(b, tess(name)[0], atol=1e-9)


def pcl_writes():
    p = np.float32(random_points()).astype(float)
    with open('a.pcd', 'w') as f:
        f.write('# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\n'
                'TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 40\nHEIGHT 1\n'
                'VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 40\nDATA ascii\n' + ''.join(
                    '%.9g %.9g %.9g %d\n' % (*x, k) for k, x in enumerate(p)))
    for form, way in ('0', 'text'), ('1', 'float'):
        command('pcl_convert_pcd_ascii_binary', 'a.pcd', 'w.pcd', form, *(['9'] * (
            form == '0')))
        check('w.pcd', p, np.arange(40.)[:, None], way=way)
        if shutil.which('pcl_pcd2ply'):
            command('pcl_pcd2ply', '-format', form, 'a.pcd', 'w.ply')
            check('w.ply', p, way=way)
    # compressed: refused, and the command that is said gives them
    command('pcl_convert_pcd_ascii_binary', 'a.pcd', 'w.pcd', '2')
    with pytest.raises(Refused) as refused:
        tess('w.pcd')
    said = str(refused.value).strip().split('not read: ')[-1].split()
    command(*[{'F': 'w.pcd', 'G': 'c.pcd'}.get(w, w) for w in said])
    check('c.pcd', p, way='text')


WRITERS = [('numpy', 'numpy', numpy_writes),
           ("numpy's savetxt", 'numpy', savetxt_writes),
           ('R', '/Rscript', r_writes), ('Open Babel', '/obabel', obabel_writes),
           ('pandas', 'pandas', pandas_writes),
           ('meshio', 'meshio', meshio_writes), ('VTK', 'vtk', vtk_writes),
           ('numpy-stl', 'stl', stl_writes),
           ('admesh', '/admesh', admesh_writes),
           ('assimp', '/assimp', assimp_writes), ('ase', 'ase', ase_writes),
           ('gemmi', 'gemmi', gemmi_writes), ('LAMMPS', '/lmp', lammps_writes),
           ('PCL', '/pcl_convert_pcd_ascii_binary', pcl_writes)]


@pytest.mark.parametrize('maker, need, writes', expected(WRITERS),
                         ids=[p[0] for p in expected(WRITERS)])
def test_what_others_write_is_read(maker, need, writes):
    if not there(need):
        pytest.skip('what %s writes: it is not installed' % maker)
    load(need)
    writes()


if __name__ == '__main__':
    serve(sys.argv[1])
