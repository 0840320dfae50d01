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
TESS = 'tess'  # its path, by a fixture
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
def plain_files(program, tmp_path, monkeypatch):
    """what others read, too"""
    monkeypatch.setattr(generate, 'plain', True)
    monkeypatch.setitem(globals(), 'TESS', program)


@pytest.mark.parametrize('reader', expected(READERS),
                         ids=lambda r: '%s %s' % (r[0], r[2]))
def test_both_read_the_same(reader, apart, everything):
    program, need, form, _, way, of = reader
    if not there(need):
        pytest.skip('beside %s, which is not installed' % program)
    same = 0
    for name, damage in files(form, 20 if everything else 8):
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

def points_of(n=40, seed=3):
    q = np.random.RandomState(seed)
    return q.rand(n, 3) * 10 - 3


def check(what, name, points, values=None, box=None, options=(), way='double',
          of=''):
    """what tess reads beside what was written"""
    try:
        p, v, said = tess(name, *options)
    except Refused as e:
        return '%s: %s' % (name, e)
    if not equal(p, points, way, of):
        return '%s: other points:\n%s\n%s' % (name, p[:5], points[:5])
    if values is not None and not equal(v, values, way, of):
        return '%s: other values:\n%s\n%s' % (name, v[:5], values[:5])
    if box is not None:
        size = volume(name, *options)
        if size is None or abs(size - box) > 1e-9 * abs(box):
            return '%s: a box of %s, not %s' % (name, size, box)
    return ''


def numpy_writes():
    p = np.c_[points_of(), np.arange(40)]
    for kind in 'f4 f8 i1 i2 i4 i8 u1 u2 u4 u8'.split():
        for order in '<>':
            for way in 'CF':
                a = np.asarray(p if kind[0] != 'u' else abs(p), order + kind,
                               order=way)
                name = 'w.npy'
                np.save(name, a)
                yield check('', name, a[:, :3].astype(float), a[:, 3:].astype(
                    float))


def savetxt_writes():
    """heads of names, in a comment or not, parted otherwise than the rows"""
    p = points_of()
    a = np.c_[p[:, 0] * 7, p]
    name = 'w.txt'
    for head in 'T, X, Y, Z', 'T X Y Z', 'T;X;Y;Z', 'T\tX\tY\tZ', 'made by hand\n' \
            'T (K), x (m), y (m), z (m)':
        for comments in '# ', '% ', '':
            if '\n' in head and not comments:
                continue
            for delimiter in ' ', ',', ';', '\t':
                for fmt in '%.18e', '%.17g':
                    np.savetxt(name, a, header=head, comments=comments,
                               delimiter=delimiter, fmt=fmt)
                    yield check('', name, p, a[:, :1])


def r_writes():
    """tables with names of rows, which have no name, and without"""
    p = points_of()
    a, out = 'a.txt', 'w.txt'
    np.savetxt(a, np.c_[p[:, 0] * 7, p], header='T x y z', comments='',
               fmt='%.17g')
    for order in '', '[c(40:21, 1:20), c(3, 1, 4, 2)]':
        for rows in '', 'rownames(d) <- paste("row", 1:40);':
            for how in '', 'sep = ",", ', 'sep = "\\t", quote = FALSE, ', \
                    'sep = ";", dec = ",", ', 'sep = ";", col.names = NA, ':
                if rows and 'FALSE' in how:
                    continue
                command('Rscript', '-e', 'd <- read.table("%s", header = TRUE); '
                        '%s options(digits = 17); write.table(d%s, %sfile = "%s")'
                        % (a, rows, order, how, out))
                # (it writes 15 digits)
                q = np.r_[p[39:19:-1], p[:20]] if order else p
                yield check('', out, np.round(q, 9), way='text', options=[
                    '-decimal', ','] if 'dec' in how else [])


def obabel_writes():
    p = np.round(points_of(), 3)
    a, out = 'a.xyz', 'w.pqr'
    with open(a, 'w') as f:
        f.write('40\n\n' + ''.join('C %.3f %.3f %.3f\n' % tuple(x) for x in p))
    command('obabel', a, '-O', out)
    yield check('pqr', out, p)


def pandas_writes():
    import csv
    p = points_of()
    d = pandas.DataFrame(np.c_[p, p[:, 0] * 7], columns=['x', 'y', 'z', 'T'])
    name = 'w.csv'
    for sep in ',;\t|':
        for decimal in '.,':
            if sep == decimal:
                continue
            for quoting in (csv.QUOTE_MINIMAL, csv.QUOTE_ALL,
                            csv.QUOTE_NONNUMERIC):
                for header in True, False:
                    for form in None, '%.17g', '%.3e':
                        for names in 'xyzT', 'Tzyx':
                            if not header and names != 'xyzT':
                                continue
                            d[list(names)].to_csv(
                                name, sep=sep, decimal=decimal, quoting=quoting,
                                header=header, index=False, float_format=form)
                            b = pandas.read_csv(
                                name, sep=sep, decimal=decimal,
                                header=0 if header else None,
                                float_precision='round_trip')
                            b.columns = list(names)
                            yield check('', name, b[list('xyz')].values,
                                        b[['T']].values,
                                        options=['-decimal', ','] if
                                        decimal == ',' else [])
    # what is missing, with an index, and names
    for mark in '', 'NA', 'nan', 'null', '-', '#N/A', 'N/A', 'None', '<NA>':
        q = d.copy()
        q.loc[3, 'T'] = q.loc[7, 'x'] = np.nan
        q.to_csv(name, na_rep=mark)
        b = pandas.read_csv(name, na_values=['-', 'None'],
                            float_precision='round_trip').dropna()
        yield check('', name, b[list('xyz')].values, b[['T']].values,
                    options=['-skip', '-cols', 'x,y,z,T'])


def box_mesh():
    p = np.float32(points_of()).astype(float)
    faces = np.array([[k, k + 1, k + 2] for k in range(len(p) - 2)])
    return p, faces


def meshio_writes():
    p, faces = box_mesh()
    tets = np.array([[k, k + 1, k + 2, k + 3] for k in range(len(p) - 3)])
    for form, cells, more in (
            ('ply', ('triangle', faces), {'binary': True}),
            ('ply', ('triangle', faces), {'binary': False}),
            ('stl', ('triangle', faces), {'binary': True}),
            ('stl', ('triangle', faces), {'binary': False}),
            ('obj', ('triangle', faces), {}), ('off', ('triangle', faces), {}),
            ('tetgen', ('tetra', tets), {}),
            ('nastran', ('tetra', tets), {'point_format': 'free'}),
            ('nastran', ('tetra', tets), {'point_format': 'fixed-small'}),
            ('nastran', ('tetra', tets), {'point_format': 'fixed-large'})):
        name = 'w.' + {'tetgen': 'node', 'nastran': 'bdf'}.get(form, form)
        # (it cannot write all numbers in a field)
        q = np.round(p, 4) if form == 'nastran' else p
        with contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()):
            meshio.Mesh(q, [cells]).write(name, form, **more)
        yield check(form, name, p[faces].reshape(-1, 3) if form == 'stl' else q,
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
    for kind in 'PLY', 'STL', 'OBJ':
        for binary in (0, 1) if kind != 'OBJ' else (0,):
            writer = getattr(vtk, 'vtk%sWriter' % kind)()
            name = 'w.' + kind.lower()
            writer.SetFileName(name)
            writer.SetInputData(data)
            if kind != 'OBJ':
                (writer.SetFileTypeToBinary if binary else
                 writer.SetFileTypeToASCII)()
            writer.Write()
            yield check(kind, name, p[faces].reshape(-1, 3) if kind == 'STL'
                        else p, way='float' if binary else 'text')


def stl_writes():
    p, faces = box_mesh()
    m = stl.mesh.Mesh(np.zeros(len(faces), stl.mesh.Mesh.dtype))
    m.vectors[:] = p[faces]
    for mode in stl.Mode.ASCII, stl.Mode.BINARY:
        name = 'w.stl'
        m.save(name, mode=mode)
        yield check('stl', name, p[faces].reshape(-1, 3),
                    way='float' if mode == stl.Mode.BINARY else 'text')


def admesh_writes():
    p, faces = box_mesh()
    a, b = 'a.stl', 'w.stl'
    with open(a, 'w') as f:
        f.write('solid a\n')
        for t in p[faces]:
            f.write('facet normal 0 0 0\nouter loop\n')
            for x in t:
                f.write('vertex %.9g %.9g %.9g\n' % tuple(x))
            f.write('endloop\nendfacet\n')
        f.write('endsolid a\n')
    for way in 'ascii', 'binary':
        command('admesh', '--no-check', '--write-%s-stl=%s' % (way, b), a)
        yield check('stl', b, p[faces].reshape(-1, 3),
                    way='float' if way == 'binary' else 'text')


def assimp_writes():
    a = 'a.obj'
    p, faces = box_mesh()
    with open(a, 'w') as f:
        for x in p:
            f.write('v %.9g %.9g %.9g\n' % tuple(x))
        for t in faces:
            f.write('f %d %d %d\n' % tuple(t + 1))
    for form, ending in (('ply', 'ply'), ('plyb', 'ply'), ('stl', 'stl'),
                         ('stlb', 'stl'), ('obj', 'obj')):
        b = 'w.' + ending
        command('assimp', 'export', a, b, '-f' + form)
        way = np.round(p, 4)
        q = tess(b)[0]
        near = np.sort([abs(p - x).sum(1).min() for x in q])
        yield '' if len(q) >= len(p) - 2 and near[-1] < 2e-5 else \
            '%s: %d points, as far as %g' % (form, len(q), near[-1])


def ase_writes():
    p = np.random.RandomState(1).rand(30, 3)
    for cell in ([9, 10, 11], [[9, 0, 0], [2, 10, 0], [-1, 3, 11]]):
        for pbc in True, [True, False, True]:
            a = ase.Atoms('C30', scaled_positions=p, cell=cell, pbc=pbc)
            a.set_array('T', np.arange(30.) / 7)
            name = 'w.xyz'
            ase.io.write(name, a, format='extxyz')
            b = ase.io.read(name, format='extxyz')
            yield check('extxyz', name, b.positions, b.get_array('T')[:, None],
                        box=b.get_volume())
            name = 'w.pdb'
            ase.io.write(name, a, format='proteindatabank')
            b = ase.io.read(name, format='proteindatabank')
            yield check('pdb', name, b.positions, box=b.get_volume())
            name = 'p.xyz'
            ase.io.write(name, a, format='xyz')
            yield check('xyz', name, ase.io.read(name, format='xyz').positions)


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
            atom.pos = gemmi.Position(*np.round(points_of(1, k + 90 * j)[0], 3))
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
    yield check('pdb', name, np.array(kept), box=s.cell.volume)


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
    script, name = 'in.lmp', 'w.dump'
    for boundary in 'p p p', 'p f p', 's p p':
        for region, skewed in (('block -1 5 0 7 2 10', 0),
                               ('prism -1 5 0 7 2 10 1.5 -1 2', 1)):
            if skewed and boundary != 'p p p':
                continue
            for columns in 'x y z', 'xu yu zu', 'xs ys zs':
                for sort in '', 'sort id':
                    if os.path.exists(name):
                        os.remove(name)
                    with open(script, 'w') as f:
                        f.write('boundary ' + boundary + '\n' + LAMMPS % (
                            region, name, columns, sort))
                    command('lmp', '-in', script, '-log', 'none')
                    a = None
                    if there('ase'):
                        load('ase')
                        a = ase.io.read(name, 0, format='lammps-dump-text',
                                        order=False)
                    lines = open(name).read().split('\n')[9:49]
                    rows = np.array([s.split() for s in lines], float)
                    p = rows[:, 2:5]
                    head = open(name).read().split('\n')[5:8]
                    b = np.array([s.split() for s in head], float)
                    size = b[:, 1] - b[:, 0]
                    if skewed:
                        xy, xz, yz = b[:, 2]
                        low = [min(0, xy, xz, xy + xz), min(0, yz), 0]
                        high = [max(0, xy, xz, xy + xz), max(0, yz), 0]
                        size = size - np.array(high) + low
                    if columns == 'xs ys zs':
                        low = b[:, 0] - (low if skewed else 0)
                        m = np.diag(size)
                        if skewed:
                            m[1, 0], m[2, 0], m[2, 1] = xy, xz, yz
                        p = p @ m + low
                    yield check('dump', name, p, rows[:, [0, 1, 5]],
                                box=np.prod(size) if boundary == 'p p p' else
                                None, way='sorted')
                    if a is not None:
                        q = tess(name)[0]
                        b = a.positions
                        if columns == 'xs ys zs':
                            b = b + a.get_celldisp()[:].reshape(3)
                        yield '' if np.allclose(b, q, atol=1e-9) else \
                            'ase has other places of %s:\n%s\n%s' % (name, b, q)


def pcl_writes():
    p = np.float32(points_of()).astype(float)
    a, b = 'a.pcd', 'w.pcd'
    with open(a, 'w') as f:
        f.write('# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\n'
                'SIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n'
                'WIDTH 40\nHEIGHT 1\n'
                'VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 40\nDATA ascii\n')
        for k, x in enumerate(p):
            f.write('%.9g %.9g %.9g %d\n' % (*x, k))
    for form in '0', '1':
        command('pcl_convert_pcd_ascii_binary', a, b, form, *(['9'] * (
            form == '0')))
        yield check('pcd', b, p, np.arange(40.)[:, None],
                    way='float' if form == '1' else 'text')
    # compressed: refused, and the command that is said gives them
    command('pcl_convert_pcd_ascii_binary', a, b, '2')
    try:
        tess(b)
        yield 'compressed PCD is read'
    except Refused as e:
        said = str(e).strip().split('not read: ')[-1].split()
        c = 'c.pcd'
        command(*[{'F': b, 'G': c}.get(w, w) for w in said])
        yield check('pcd', c, p, way='text')
    if shutil.which('pcl_pcd2ply'):
        for form in '0', '1':
            c = 'w.ply'
            command('pcl_pcd2ply', '-format', form, a, c)
            yield check('ply', c, p, way='float' if form == '1' else 'text')


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
    results = list(writes())
    assert results and not any(results), [r for r in results if r][:4]


if __name__ == '__main__':
    serve(sys.argv[1])
