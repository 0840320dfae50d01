"""generate.py - files in all formats that build/tess reads, with what each format
allows, drawn by chance; and damages of them.

All hold the same five points, most with a value.  test_properties.py has them
read; so do bytes.py of test/fuzz, which changes their bytes, and
test_others.py, by other programs.
"""
import random
import re
import struct
from decimal import Decimal

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2), (.134, .25, -.5)]
VALUES = [0, 10, 20, 30, 40]

# In a text that is made here: before a cell of a coordinate, of a value, a
# count, a word that the format has; and behind it.
X, V, N, W, END = '\ue001', '\ue002', '\ue003', '\ue004', '\ue00f'
MARKED = re.compile('([%s])([^%s]*)%s' % (X + V + N + W, END, END))
FIVE = N + '5' + END


# Files that others read, too: numbers as C writes them, few comments
plain = False


class File:
    """What a writer makes: text, with marks, or data, which is bytes"""
    text = data = names = None
    options, points, values = (), POINTS, VALUES
    separator, decimal = ' ', '.'
    cut = False          # must a cut be noticed?  (a count)
    fixed = False        # are cells in fields of columns?
    # of data: where rows begin; a count's place and its bytes, 1 as text; the
    # place of a coordinate, and its type
    head, count, narrow = 0, None, None

    def __init__(self, ending, encode=str.encode, **more):
        self.ending, self.encode = ending, encode
        self.__dict__.update(more)

    def bytes(self, text=None):
        if self.text is None:
            return self.data
        return self.encode(MARKED.sub(r'\2', text or self.text))


# ---- numbers and lines ----

def pick(r, text):
    """text, in which <a|b|c> is one of these"""
    return re.sub('<([^<>]*)>', lambda m: r.choice(m[1].split('|')), text)


def word(text):
    return W + text + END


def digits(r, x, decimal='.'):
    """x, as a number may be written"""
    if plain:
        return r.choice(['%.15g', '%.6f', '%.9e']) % x
    way = r.randrange(12)
    power = r.randrange(-3, 4) if way in (4, 5, 6) else 0
    s = format(Decimal('%.15g' % abs(x)).scaleb(-power), 'f')
    if way == 0:
        s += '.' * ('.' not in s) + '0' * r.randrange(1, 5)
    elif way == 1 and s[:2] == '0.':
        s = s[1:]
    elif way == 2 and '.' not in s and decimal == '.':
        s += '.'
    elif way == 3:
        s = '00' + s
    s = s.replace('.', decimal)
    if power or way == 7:
        s += r.choice('eEdDqQ') + ('-' if power < 0 else r.choice(
            ['', '+'])) + r.choice(['%d', '%02d', '%03d']) % abs(power)
    elif way == 8 and '.' in s:
        s += '+000'
    return ('-' if x < 0 else '+' if r.random() < .1 else '') + s


def number(i, column):
    return VALUES[i] if column == 'T' else POINTS[i]['xyz'.index(column)]


def cells(r, i, columns='xyzT', decimal='.', form=None):
    """of the point i: x, y, z, its value T, or what else is in each row"""
    return [pick(r, c) if c not in 'xyzT' else (V if c == 'T' else X) + (
        form % number(i, c) if form else digits(r, number(i, c), decimal)) + END
        for c in columns]


def rows(r, columns='xyzT', between=' ', line='@', **how):
    """a line for each point: @ is its cells, {i} its number from 0 on, {n} from 1"""
    return ''.join(pick(r, line).format(i=i, n=i + 1).replace(
        '@', between.join(cells(r, i, columns, **how))) + '\n' for i in range(5))


def lines(r, comments='', blank=True, trim=True):
    """an encoder: line ends, a mark, and lines that mean nothing"""
    if plain:
        return str.encode
    end, mark = pick(r, '<\n|\n|\r\n|\r>'), r.choice([b'', b'', b'\xef\xbb\xbf'])
    last, seed = r.choice([b'', b'', b'', b'\x1a']), r.random()

    def encode(text):
        q, out = random.Random(seed), []
        for line in text.split('\n')[:-1]:
            if comments and q.random() < .1:
                out.append(q.choice(comments.split(' ')) + ' none, 1 2 3')
            if blank and q.random() < .1:
                out.append(q.choice(['', ' ', '\t']))
            if trim and q.random() < .2:
                line += q.choice([' ', '  '])
            if trim and q.random() < .2:
                line = q.choice([' ', '  ']) + line
            out.append(line)
        return mark + (end.join(out) + end).encode() + last
    return encode


def made(r, endings, text, comments='', blank=True, trim=True, **more):
    """a text whose lines may have such ends, and such lines between them"""
    return File(r.choice(endings.split()), encode=lines(r, comments, blank, trim),
                text=pick(r, text), **more)


def perhaps(r):
    """columns, with a value or none, and that"""
    return r.choice([('xyzT', VALUES), ('xyzT', VALUES), ('xyz', None)])


# ---- points alone, in lines ----

def table(r):
    separator = pick(r, '<,|;|\t| |   |, | ; >') if r.random() < .9 else '|'
    bare = separator.strip(' ') or ' '
    decimal = r.choice('...,') if bare != ',' else '.'
    columns = list('xyzT')
    if r.random() < .3:
        columns.append('<a|a#b|N1|%s>' % ('bc' if bare == ' ' else 'b c'))
    quote = '"%s"' if bare != ' ' and r.random() < .3 else '%s'
    head = ''
    if r.random() < .5:
        r.shuffle(columns)
        upper = r.random() < .3
        head = separator.join(quote % ('note' if c[0] == '<' else c.upper() if upper
                                       else c) for c in columns) + '\n'
    behind = bare if bare != ' ' and r.random() < .1 else ''
    text = head + ''.join(separator.join(
        quote % c for c in cells(r, i, columns, decimal)) + behind + '\n'
        for i in range(5))
    return made(r, 'csv txt dat', text, '# % ! //', separator=bare, decimal=decimal,
                options=['-decimal', ','] if decimal == ',' else [])


def counted(r):
    columns, values = perhaps(r)
    return made(r, 'txt', '<|3 rbox 5 D3\n|3\n>' + FIVE + '\n' + rows(r, columns),
                blank=False, values=values, cut=True)


def xyz(r):
    columns, values = perhaps(r)
    text = FIVE + '\n<|five atoms|step 1, 7 fs>\n' + rows(r, ['<C|H|O2>', *columns])
    if r.random() < .2:
        text += '5\nagain\n' + 5 * ('C' + len(columns) * ' 1' + '\n')
    return made(r, 'xyz xyz txt', text, blank=False, trim=False, cut=True,
                values=values)


def extended(r):
    names = r.choice([['species', 'pos', 'T'], ['pos', 'T']])
    if r.random() < .3:
        r.shuffle(names)
    kind = {'species': ('species:S:1', 'C'), 'pos': ('pos:R:3', 'xyz'),
            'T': ('T:R:1', 'T')}
    keys = ['Properties=' + ':'.join(kind[n][0] for n in names)]
    if r.random() < .7:
        keys += [pick(r, 'Lattice="<5 0 0 0 6 0 0 0 7|5.0 0.0 0.0 1.0 6.0 0.0 0.5 '
                         '0.5 7.0| 5 0 0  0 6 0  0 0 7 >"'),
                 pick(r, '<|pbc="T T F"|pbc="1 0 1"|pbc=[T, T, F]>'),
                 pick(r, '<||Origin="-1 -2 -3.5">')]
    keys.append(pick(r, '<|energy=-1.5>'))
    keys = [k for k in keys if k]
    r.shuffle(keys)
    return made(r, 'xyz', FIVE + '\n' + ' '.join(keys) + '\n' + rows(
        r, ''.join(kind[n][1] for n in names)), blank=False, trim=False, cut=True)


def node(r):
    base, marker = r.randrange(2), r.random() < .3
    columns, values = perhaps(r)
    return made(r, 'node node txt', '%s 3 %d %d\n' % (
        FIVE, columns == 'xyzT', marker) + rows(
            r, [*columns] + ['1'] * marker, line='{%s} @' % 'in'[base]), '#', cut=True,
        values=[(v,) * bool(values) + (1,) * marker for v in VALUES])


# ---- meshes ----

def off(r):
    kind = 'OFF' if plain else pick(r, '<OFF|OFF|COFF|NOFF|CNOFF>')
    more = ' 1 0 0' * (len(kind) - 3) + ' 1' * ('C' in kind)
    columns, values = perhaps(r) if kind == 'OFF' and not plain else ('xyz', None)
    faces = r.randrange(3) + plain
    head = '\n%s %d 0\n' if plain else pick(r, '<\n| |\n\n>%s<\n| >%d<\n| >0\n')
    text = word(kind) + head % (FIVE, faces) + rows(
        r, columns, line='@' + more) + '3 0 1 2\n' * faces
    return made(r, 'off off dat', text, '#', cut=True, values=values)


PLY = {'char': 'b', 'uchar': 'B', 'short': 'h', 'ushort': 'H', 'int': 'i',
       'uint': 'I', 'float': 'f', 'double': 'd', 'int8': 'b', 'uint8': 'B',
       'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I', 'float32': 'f',
       'float64': 'd'}


def packed(columns, order, types, head):
    """rows of these, and the place and type of y"""
    data, narrow = b'', None
    for i in range(5):
        for c in columns:
            if c == 'y' and i == 0:
                narrow = len(head) + len(data), order + 'd'
            data += b'abc' if c == '_' else struct.pack(order + types[c], number(i, c))
    return {'data': head + data, 'narrow': narrow, 'head': len(head)}


def ply(r):
    real, other = r.choice(['double', 'float64']), r.choice(list(PLY))
    columns, faces = list('xyzT'), 2 if plain else r.randrange(3)
    if not plain:
        r.shuffle(columns)
    form = pick(r, '<ascii|binary_little_endian|binary_big_endian>')
    head = 'ply\nformat %s 1.0\n' % form + pick(
        r, '<|comment of x and 1 2 3\nobj_info none\n>') + \
        'element vertex %s\n' % FIVE + ''.join(word('property') + ' %s %s\n' % (
            other if c == 'T' else real, c) for c in columns)
    if faces or r.random() < .3:
        head += pick(r, 'element face %d\nproperty list uchar <int|uint> '
                        'vertex_indices\n') % faces
    head += word('end_header') + '\n'
    if form == 'ascii':
        end = r.choice(['\n', '\r\n'])
        return File(pick(r, '<ply|ply|dat>'), cut=True, text=head + rows(
            r, columns) + '3 0 1 2\n' * faces,
            encode=lambda s: s.replace('\n', end).encode())
    order, head = '<' if 'little' in form else '>', MARKED.sub(r'\2', head).encode()
    f = File(pick(r, '<ply|ply|dat>'), cut=True, count=(head.index(b'vertex ') + 7, 1),
             **packed(columns, order, dict(x='d', y='d', z='d', T=PLY[other]), head))
    f.data += struct.pack(order + 'Biii', 3, 0, 1, 2) * faces
    return f


def obj(r):
    colours = ' .5 .5 1' if r.random() < .2 and not plain else ''
    faces = 'f 1 2 3\nf 3 4 5\n' if plain else pick(
        r, '<||f 1 2 3\n|f 1/1/1 2/2/2 3/3/3\n|f 1 2 \\\n 3 4\n|l 1 2\n|'
        's off\nusemtl m\nf 1//1 2//1 3//1\n>')
    return made(r, 'obj obj dat', '<|mtllib a.mtl\n|o a\ng b c\n>' + rows(
        r, 'xyz', line=word('v') + ' @' + colours + '<||||\nvn 0 0 1>') + faces, '#',
        trim=False, values=None)


CORNERS = [0, 1, 2, 0, 3, 4]


def stl(r):
    if r.random() < .5:
        order = '<' if r.random() < .8 or plain else '>'
        data = pick(r, '<solid by chance|binary|>').ljust(79).encode() + b'\0' + \
            struct.pack(order + 'I', 2)
        for t in 0, 3:
            data += struct.pack(order + '12fH', 0, 0, 1, *(
                x for k in CORNERS[t:t + 3] for x in POINTS[k]), r.randrange(65536))
        return File(pick(r, '<stl|stl|dat>'), data=data, values=None, cut=True,
                    points=[struct.unpack('3f', struct.pack('3f', *POINTS[k]))
                            for k in CORNERS],
                    head=84, narrow=(96, order + 'f'), count=(80, 4))
    case = str.upper if r.random() < .3 and not plain else str
    name, solids = pick(r, '<| a name>'), 1 if plain else r.randrange(1, 3)
    begin, end = case('solid') + name + '\n', word(case('endsolid')) + name + '\n'
    facets = [word(case('facet normal')) + ' 0 0 1\n' + word(case('outer loop')) + '\n' +
              ''.join(word(case('vertex')) + ' ' + ' '.join(cells(r, k, 'xyz')) + '\n'
                      for k in CORNERS[t:t + 3]) +
              word(case('endloop')) + '\n' + word(case('endfacet')) + '\n'
              for t in (0, 3)]
    return made(r, 'stl stl dat', begin + ((end + begin) * (solids - 1)).join(facets) +
                end, cut=True, points=[POINTS[k] for k in CORNERS], values=None)


# ---- arrays ----

def npy(r):
    kind = pick(r, '<f8|f8|f4|i1|i2|i4|i8|u1|u2>')
    order = r.choice('<>') if kind[1] != '1' else '|'
    code = {'f8': 'd', 'f4': 'f', 'i1': 'b', 'i2': 'h', 'i4': 'i', 'i8': 'q',
            'u1': 'B', 'u2': 'H'}[kind]
    pack = order.replace('|', '<') + code
    table = [p + (v,) for p, v in zip(POINTS, VALUES)]
    if kind[0] != 'f':
        table = [tuple(int(abs(x) * 2 if kind[0] == 'u' else x * 2) for x in row)
                 for row in table]
    table = [struct.unpack('=4' + code, struct.pack('=4' + code, *row))
             for row in table]
    turned = r.random() < .3
    text = "{'descr': '%s%s', 'fortran_order': %s, 'shape': (5, 4)%s}" % (
        order, kind, turned, r.choice(['', ', ']))
    version = r.randrange(1, 4)
    text += ' ' * ((-(10 if version == 1 else 12) - len(text) - 1) % 64) + '\n'
    head = b'\x93NUMPY' + bytes([version, 0]) + struct.pack(
        '<H' if version == 1 else '<I', len(text)) + text.encode()
    return File(pick(r, '<npy|npy|dat>'), cut=True, head=len(head), data=head + b''.join(
        struct.pack(pack, x) for row in (zip(*table) if turned else table)
        for x in row), points=[row[:3] for row in table],
        values=[row[3] for row in table], count=(head.index(b'(5') + 1, 1),
        narrow=(len(head), pack) if code in 'fd' else None)


def pcd(r):
    binary = r.random() < .5
    types = dict.fromkeys('xyz', 'F8d')
    types.update(T=pick(r, '<F4f|F8d|U1B|I2h|U4I|I4i>'), _='U1B')
    columns = list('xyzT')
    r.shuffle(columns)
    if binary and r.random() < .4:
        columns.insert(r.randrange(5), '_')

    def key(name, of):
        return ' '.join([name, *map(of, columns)]) + '\n'

    count = key('COUNT', lambda c: '3' if c == '_' else '1')
    text = pick(r, '<# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n|'
                'VERSION .7\n>') + key('FIELDS', str) + \
        key('SIZE', lambda c: types[c][1]) + key('TYPE', lambda c: types[c][0]) + \
        (count if '_' in columns or r.random() < .7 else '') + \
        pick(r, 'WIDTH 5\nHEIGHT 1\n<VIEWPOINT 0 0 0 1 0 0 0\n|>POINTS ') + FIVE + \
        '\nDATA ' + ('binary' if binary else 'ascii') + '\n'
    if not binary:
        return made(r, 'pcd pcd dat', text + rows(r, columns), trim=False, cut=True)
    head = MARKED.sub(r'\2', text).encode()
    return File(pick(r, '<pcd|pcd|dat>'), cut=True, count=(head.index(
        b'POINTS ') + 7, 1), **packed(columns, '<', {c: t[2] for c, t in types.items()},
                                      head))


LAS = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67]


def las(r):
    minor = r.randrange(5)
    form = r.randrange([2, 2, 4, 6, 11][minor])
    size = {4: 375, 3: 235}.get(minor, 227)
    between, stride = r.choice([0, 0, 60]), LAS[form] + r.choice([0, 0, 4])
    scale, plus = (.001, .001, .0005), (0., 10., -7.)
    head = bytearray(size + between)
    head[:4] = b'LASF'
    head[24:26] = 1, minor
    struct.pack_into('<HI', head, 94, size, size + between)
    struct.pack_into('<BHI', head, 104, form, stride, 5 * (
        minor < 4 or form < 6 and r.random() < .5))
    struct.pack_into('<6d', head, 131, *scale, *plus)
    for k in range(3):
        axis = [p[k] for p in POINTS]
        struct.pack_into('<2d', head, 179 + 16 * k, max(axis), min(axis))
    if minor == 4:
        struct.pack_into('<Q', head, 247, 5)
    whole = [[round((x - b) / a) for x, a, b in zip(p, scale, plus)] for p in POINTS]
    return File(pick(r, '<las|las|dat>'), cut=True, head=len(head), data=bytes(
        head) + b''.join(struct.pack('<3iH', *k, v).ljust(stride, b'\1')
                         for k, v in zip(whole, VALUES)),
        points=[tuple(a * n + b for n, a, b in zip(k, scale, plus)) for k in whole],
        count=(247, 8) if minor == 4 else (107, 4))


# ---- atoms ----

def pdb(r):
    # (an atom may end with its place: the value is 0)
    serial, short = r.choice([1, 99990]), r.random() < .3
    text = '<|HEADER    A PROTEIN\n|TITLE     NONE\nREMARK   1\n>' \
        '<|CRYST1   10.000   11.000   12.000  90.00  90.00  90.00 P 1\n>'
    atoms = ''
    for i in range(5):
        x, y, z, v = cells(r, i, 'xyz', form='%8.3f') + cells(r, i, 'T', form='%6.2f')
        atoms += '<ATOM  |HETATM>%5d < CA | N  |H1  > ALA A%4d    %s%s%s%s' \
            '<|||||\nANISOU%74s>\n' % (serial + i, i + 1, x, y, z, '' if short else
                                      '  1.00%s<|           C>' % v, '')
    if r.random() < .2:
        atoms = 'MODEL        1\n' + atoms + 'ENDMDL\nMODEL        2\nATOM      1  CA' \
            '  ALA A   1       9.000   9.000   9.000  1.00  9.00\nENDMDL\n'
    end = r.choice(['\n', '\r\n'])
    return File(pick(r, '<pdb|ent|dat>'), text=pick(r, text + atoms + '<TER\n|>END\n'),
                fixed=True, values=[0] * 5 if short else VALUES,
                encode=lambda s: s.replace('\n', end).encode())


def dump(r):
    kind, low, side = r.choice(['', 'u', 's']), (-4., -4., -4.), (8., 16., 8.)
    columns = ['id', 'type', 'x', 'y', 'z', 'T']
    r.shuffle(columns)
    # (of a tilted box the bounds are those of the box around it)
    tilted = r.random() < .6
    tilt = [r.choice([-3., -1.5, 0., .25, 2.]) * tilted for k in range(3)]
    xy, xz, yz = tilt
    around = [(min(0, xy, xz, xy + xz), max(0, xy, xz, xy + xz)),
              (min(0, yz), max(0, yz)), (0, 0)]
    text = pick(r, 'ITEM: TIMESTEP\n<7|9998>\nITEM: NUMBER OF ATOMS\n') + FIVE + \
        '\nITEM: BOX BOUNDS %s' % ('xy xz yz ' * tilted) + pick(
            r, '<pp|ff|ss> <pp|ff|ss> <pp|ff|ss>\n')
    for a, b, d, t in zip(low, side, around, tilt):
        text += r.choice(['%g %g', '%.16e %.16e']) % (a + d[0], a + b + d[1]) + (
            ' %g' % t if tilted else '') + '\n'
    text += word('ITEM: ATOMS') + ' %s\n' % ' '.join(
        c + kind if c in 'xyz' else c for c in columns)
    vectors, points = ((side[0], 0, 0), (xy, side[1], 0), (xz, yz, side[2])), []
    for i, p in enumerate(POINTS):
        if kind == 's':
            p = [float('%.15g' % ((x - a) / b)) for x, a, b in zip(p, low, side)]
            points.append(tuple(low[k] + sum(p[j] * vectors[j][k] for j in range(3))
                                for k in range(3)))
        own = {'id': str(i + 1), 'type': '1', 'T': cells(r, i, 'T')[0],
               **{c: X + digits(r, x) + END for c, x in zip('xyz', p)}}
        text += ' '.join(own[c] for c in columns) + '\n'
    if r.random() < .2:
        text += MARKED.sub(r'\2', text)
    end = r.choice(['\n', '\r\n'])
    return File(pick(r, '<dump|lammpstrj|dat>'), text=text, cut=True,
                points=points or POINTS,
                values=[tuple({'id': i + 1, 'type': 1, 'T': VALUES[i]}[n]
                              for n in columns if n not in 'xyz') for i in range(5)],
                encode=lambda s: s.replace('\n', end).encode())


def pqr(r):
    """x, y, z, charge and radius are the last words; or the first three are in
    PDB's columns"""
    free, behind = r.random() < .5, r.choice([
        ' %7.4f %6.4f', ' %8.4f %7.4f', '%12.4f%12.4f', '  %.8f   %.3f  C'])
    text = '<|REMARK   1 by hand\n>'
    for i in range(5):
        text += word('ATOM') + ' %d CA ALA <|A >%d ' % (i, i) + ' '.join(
            cells(r, i, 'xyz')) if free else word('ATOM  ') + \
            '%5d  C   ALA A%4d    ' % (i, i) + ''.join(
                cells(r, i, 'xyz', form='%8.3f'))
        text += behind % (VALUES[i], 1.5) + '\n'
    return made(r, 'pqr', text, trim=False, fixed=not free,
                values=[(v, 1.5) for v in VALUES])


def amber(r):
    """a restart"""
    x = [X + '%12.7f' % c + END for p in POINTS for c in p]
    velocities = ['%12.7f' % (c / 7) for p in POINTS for c in p]
    text = '<|a b|of 5 atoms>\n' + N + '    5' + END + '<|  0.1000000E+03>\n' + ''.join(
        ''.join(part[k:k + 6]) + '\n' for part in [x] + [velocities] * (
            r.random() < .3) for k in (0, 6, 12))
    if r.random() < .5:
        text += '%12.7f' * 3 % (9, 9, 9) + r.choice(
            ['', '%12.7f' * 3 % (90, 90, 90)]) + '\n'
    return made(r, 'rst7 inpcrd dat', text, blank=False, trim=False, values=None,
                fixed=True, cut=True)


def named(r):
    """many points, with names of many lengths: one may be as the one before,
    of a table it may be empty, and have quotes"""
    form, n, column = pick(r, '<csv|xyz|pdb>'), r.randrange(20, 60), r.randrange(4)
    longest = 4 if form == 'pdb' else r.choice([3, 8, 15])
    least = 0 if form == 'csv' else 1
    names, points, text = [], [], '%d\n\n' % n * (form == 'xyz')
    for i in range(n):
        # (a column of words has one at least)
        name = ''.join(r.choice('abcXYZ_') for k in range(
            r.randrange(least, longest + 1))) if i else r.choice(['', 'a'])
        if form == 'csv' and r.random() < .2:
            name += pick(r, '"< b||, c>')
        if i == 1 or (i == 0 and least):
            name = 'ab'
        names.append(names[-1] if i and r.random() < .3 else name)
        points.append(tuple(round(r.uniform(-99, 99), 3) for k in range(3)))
        name, own = names[-1], ['%.3f' % x for x in points[-1]]
        if form == 'csv':
            own.insert(column, '"%s"' % name.replace('"', '""'))
        text += ','.join(own) + '\n' if form == 'csv' else ' '.join(
            [name, *own]) + '\n' if form == 'xyz' else \
            'ATOM  %5d %-4s ALA A%4d    %8s%8s%8s\n' % (i + 1, name, i, *own)
    return File(form, text=text, points=points, names=names,
                values=[0] * n if form == 'pdb' else None)


# ---- tables, by their names, and by formats with heads ----

AXES = [('x', 'y', 'z'), ('X (m)', 'Y (m)', 'Z (m)'), ('East', 'North', 'RL'),
        ('lon', 'lat', 'depth'), ('x-coordinate', 'y-coordinate',
                                  'z-coordinate')]


def shuffled(r, axes=None):
    """columns in an order of chance, and their names"""
    columns = list('xyzT')
    r.shuffle(columns)
    names = dict(zip('xyzT', axes or r.choice(AXES) + ('T',)))
    return columns, [names[c] for c in columns]


def rownames(r):
    """as R's write.table"""
    separator = r.choice(' \t,;')
    decimal = r.choice('.,') if separator != ',' else '.'
    columns, names = shuffled(r)
    quote = '"%s"' if r.random() < .5 or any(' ' in n for n in names) else '%s'
    own = pick(r, '<1 2 3 4 5|7 3 12 4 9|a b2 c d e>').split()
    text = separator.join(quote % n for n in names) + '\n' + ''.join(
        separator.join([quote % own[i]] + cells(r, i, columns, decimal)) + '\n'
        for i in range(5))
    return made(r, 'txt csv dat', text, '#', separator=separator, decimal=decimal,
                options=['-decimal', ','] if decimal == ',' else [])


def savetxt(r):
    """names are parted otherwise than rows"""
    separator = r.choice(' \t;|')
    columns, names = shuffled(r)
    between = pick(r, '<, |,|;|\t|   %s>' % ('' if any(
        ' ' in n for n in names) else '| '))
    return made(r, 'txt csv dat', '<# |#|% |! ||>' + between.join(names) + '\n' + rows(
        r, columns, separator), blank=False, trim=between != '   ',
        separator=separator)


def rows_numbered(r):
    separator, first, gap = r.choice(' \t,;|'), r.choice([0, 1, 1001]), r.choice(
        [0, 0, 3])
    before = r.choice([[], ['P'], ['a7']])
    return made(r, 'txt csv dat', ''.join(separator.join(
        before + ['%d' % (first + i + gap * (i > 2))] + cells(r, i)) + '\n'
        for i in range(5)), '# % ! //', separator=separator)


def geoeas(r):
    columns, names = shuffled(r)
    return made(r, 'dat gslib out', '<a lake|5 holes of it|# of 3>\n'
                '<4| 4 10 20 30>\n' + '\n'.join(names) + '\n' + rows(r, columns),
                blank=False)


def titled(r):
    return made(r, 'txt dat', '<five of them|a b c d e|x y z T>\n' + FIVE + '\n' +
                rows(r), blank=False, cut=True)


def gocad(r):
    kind, head, faces = r.choice([('VSet', '', ''), (
        'TSurf', 'TFACE\n', 'TRGL 1 2 3\n'), ('PLine', 'ILINE\n', 'SEG 1 2\n')])
    columns, values = perhaps(r)
    return made(r, 'vs ts dat', 'GOCAD ' + kind + ' 1\nHEADER {\nname:a b\n'
                '*solid*color:1 0 0 1\n}\n<|GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME '
                'Default\nAXIS_NAME "X" "Y" "Z"\nZPOSITIVE Elevation\n'
                'END_ORIGINAL_COORDINATE_SYSTEM\n>' + (
                    'PROPERTIES T\n<|ESIZES 1\n>' if values else '') + head + rows(
                        r, columns, line=word('PVRTX' if values else 'VRTX') +
                        ' {n} @') + faces + 'END\n', '#', values=values)


def nastran(r):
    """in fields of 8 or 16 columns, or with commas"""
    wide = r.choice([0, 8, 16])
    text = '<|SOL 101\nCEND\nBEGIN BULK\n|$ by hand\n>'
    for i in range(5):
        form = '%' + str(wide) + ('.3f' if i == 4 else r.choice(['.3f', '.2E']))
        card = {0: word('GRID') + ',{i},<|0>,{0},{1},{2}',
                8: word('GRID') + '    {i:8}<        |       0>{0}{1}{2}',
                16: word('GRID*') + '   {i:16}<%16s|%16s>{0}{1}*\n*       {2}' % (
                    '', '0')}[wide]
        text += card.format(*cells(r, i, 'xyz', form=form if wide else None),
                            i=i + 11) + '\n'
    return made(r, 'bdf nas', text + '<|CTETRA  1       1       11      12      13'
                '      14\n>', '$', trim=False, values=None, fixed=wide > 0,
                separator=' ' if wide else ',')


def post(r):
    columns, names = shuffled(r)
    return made(r, 'csv txt', '<|\n>[Name]\nOutlet Plane\n\n<|[Spatial Fields]\nx, y, '
                'z\n\n>[Data]\n' + ', '.join(names) + '\n' + rows(r, columns, ', ') +
                '<|\n[Faces]\n0, 1, 2\n>', trim=False, separator=',')


def petrel(r):
    columns, names = shuffled(r)
    return made(r, 'txt dat', '<|# Petrel Points with attributes\n><|VERSION 1\n>'
                'BEGIN HEADER\n' + ''.join('<|FLOAT,>' * (n == 'T') + n + '\n'
                                           for n in names) +
                'END HEADER\n' + rows(r, columns), '#', trim=False)


def cnv(r):
    columns, names = shuffled(r, (
        'longitude: Longitude [deg]', 'latitude: Latitude [deg]',
        '<depSM: Depth [salt water, m]|prDM: Pressure, Digiquartz [db]>',
        't090C: T [C]'))
    return made(r, 'cnv txt', '* Sea-Bird SBE 9 Data File:\n** Ship: none\n# nquan = 4'
                '\n# nvalues = ' + FIVE + '\n' + ''.join(
                    '# name %d = %s\n' % n for n in enumerate(names)) +
                '# bad_flag = -9.990e-29\n# file_type = ascii\n*END*\n' + rows(
                    r, columns, '', form='%11.4f'), blank=False, trim=False, fixed=True,
                cut=True)


def bottles(r):
    columns, names = shuffled(r, ('LONGITUDE', 'LATITUDE', 'CTDPRS', 'CTDTMP'))
    return made(r, 'csv txt', 'BOTTLE,20200907XXXABC\nEXPOCODE,' + ','.join(names) +
                '\n,,,,\n' + rows(r, ['99XX_1', *columns], ',') + 'END_DATA\n', '#',
                trim=False, separator=',')


def odv(r):
    separator = r.choice('\t;,')
    return made(r, 'txt csv', separator.join(
        ['Cruise', 'Station', 'Type', 'Longitude [degrees_east]',
         'Latitude [degrees_north]', 'Depth [m]', 'T']) + '\n' + rows(
             r, ['C', 'A', 'B', *'xyzT'], separator), '//', trim=False,
        separator=separator)


def well(r):
    columns, names = shuffled(r)
    return made(r, 'las txt', '~Version\n VERS. <1.2|2.0> : \n WRAP. NO :\n~W\n NULL. '
                '<-999.25|-9999.00> :\n~Curve\n' + ''.join(
                    ' %s.<M||API> : a curve\n' % re.sub('[- (].*', '', n)
                    for n in names) + '<~A|~Ascii Log Data>\n' + rows(r, columns, '  '),
                '#', trim=False)


FORMATS = [table, counted, xyz, extended, node, off, ply, obj, stl, npy, pdb,
           pcd, dump, las, rownames, savetxt, rows_numbered, geoeas, titled,
           amber, gocad, nastran, post, petrel, cnv, bottles, odv, well, pqr]

# ---- damages ----

def a_mark(r, f, marks):
    return r.choice([m for m in MARKED.finditer(f.text) if m[1] in marks] or [None])


def cell(texts, marks=X):
    """texts in the place of a cell"""
    def damage(r, f):
        text = r.choice(texts)
        if f.decimal == ',':
            text = text.translate({44: '.', 46: ','})
        m = a_mark(r, f, r.choice(marks))
        if not m or f.separator in text or (text == '' and f.separator == ' ' and
                                            not f.fixed):
            return None
        if f.fixed:
            if not text.isascii() or len(text) > len(m[2]):
                return None
            text = text.rjust(len(m[2]))
        return f.text[:m.start()] + text + f.text[m.end():]
    return damage


def count_to(texts):
    def damage(r, f):
        m = a_mark(r, f, N)
        if not m or (f.ending == 'txt' and m.end() < f.text.index('\n')):
            return None  # (it may be a line of numbers)
        return f.text[:m.start()] + r.choice(texts) + f.text[m.end():]
    return damage


def packed_count(numbers):
    """a count in a binary file"""
    def damage(r, f):
        if f.text is not None or not f.count:
            return None
        (at, size), n = f.count, r.choice(numbers)
        order = f.narrow[1][0] if f.narrow else '<'
        return f.data[:at] + (b'%d' % n if size == 1 else struct.pack(
            order + {4: 'I', 8: 'Q'}[size], n % 256 ** size)) + f.data[at + size:]
    return damage


def packed_cell(x):
    def damage(r, f):
        if f.text is not None or not f.narrow:
            return None
        at, code = f.narrow
        new = struct.pack(code, x)
        return f.data[:at] + new + f.data[at + len(new):]
    return damage


def row_numbers(f):
    return [k for k, line in enumerate(f.text.split('\n')) if X in line]


def in_a_row(change):
    """a change of the lines and the number of one that is a row"""
    def damage(r, f):
        lines_, k = f.text.split('\n'), r.choice(row_numbers(f))
        return None if change(r, f, lines_, k) is False else '\n'.join(lines_)
    return damage


def lose_row(r, f, lines_, k):
    del lines_[k]
    return f.cut


def more_cell(r, f, lines_, k):
    lines_[k] = f.separator.join([lines_[k].rstrip(f.separator), '7', '8'])
    # (of a grid point of Nastran they are allowed)
    return not f.fixed and f.ending not in ('bdf', 'nas')


def cut_atom(r, f, lines_, k):
    # by the last digit of its place, which is in column 54
    lines_[k] = MARKED.sub(r'\2', lines_[k])[:53]
    return f.fixed and k != row_numbers(f)[0]


def junk(r, f, lines_, k):
    lines_.insert(k + 1, 'junk 1 2')
    return len(lines_) > 6


def other_separator(r, f, lines_, k):
    sep = f.separator
    lines_[k] = re.sub(r' *[%s] *' % sep if sep != ' ' else ' +', {
        ',': ';', ';': '|', '|': ';', '\t': ';', ' ': ','}[sep], lines_[k])
    return f.ending in ('csv', 'txt', 'dat') and not f.cut and not f.fixed and \
        not f.text.startswith('solid') and k != row_numbers(f)[0]


def in_a_cell(change, fixed=False):
    """what becomes of the text before a cell, its own, and that behind it"""
    def damage(r, f):
        m = a_mark(r, f, X)
        return None if f.fixed and not fixed else change(
            f, f.text[:m.start()], m[2], f.text[m.end():])
    return damage


def lose_cell(f, before, text, behind_):
    if behind_[0] == '"':
        before, behind_ = before[:-1], behind_[1:]
    if f.separator != ' ':
        behind_ = behind_.lstrip(' ')
    if behind_[0] == f.separator:
        behind_ = behind_[1:]
    elif behind_[0] == '\n' and f.separator in before:
        before = before[:before.rindex(f.separator)]
    return before + behind_


def misspell(r, f):
    m = a_mark(r, f, W)
    k = m and r.randrange(len(m[2]))
    s = m and m[2][:k] + m[2][k + 1:]
    # (a blank may be one of several)
    return None if m is None or s.endswith('OFF') or m[2][k] == ' ' else \
        f.text[:m.start()] + s + f.text[m.end():]


def cut_file(r, f):
    if f.text is None:
        return f.data[:r.randrange(f.head, len(f.data) - 1)]
    # before the last row ends
    at = len(f.bytes(f.text[:f.text.rindex(X)] + '\n'))
    return f.bytes()[:r.randrange(at // 2, at)] if f.cut and at > 1 else None


def behind(r, f):
    """something behind the end"""
    return f.data + b'\1\2\3' if f.text is None else \
        f.bytes() + b'junk 1 2\n' if f.cut else None


def utf16(r, f):
    return r.choice([b'\xff\xfe', b'']) + MARKED.sub(r'\2', f.text).encode('utf-16-le')


def damaged(of_data=False):
    """a damage of texts alone, or of data, too: bytes, or None if f has no such"""
    def wrap(change):
        def damage(r, f):
            if f.text is None and not of_data:
                return None
            new = change(r, f)
            return f.bytes(new) if isinstance(new, str) else new
        return damage
    return wrap


NOT = 'not a number'
WIDE = 'columns?, but|columns|' + NOT
# a kind of damage, words that the message has, what damages, is that of data?
DAMAGES = [(kind, damaged(bool(of_data))(change), words)
           for kind, words, change, *of_data in (
    ('an empty cell', 'empty|-skip|number|blank|' + WIDE, cell([''])),
    ('an absent number', '-skip', cell(
        'NA N/A #N/A null None - -- ? <NA> #DIV/0! #VALUE!'.split())),
    ('an absent number, as a coordinate NaN', '-skip', cell(
        'nan NaN -nan -nan(ind) NAN'.split())),
    ('an absent value', '-skip', cell('NA null - #N/A'.split(), V)),
    ('a value that is NaN', 'NaN', cell('nan -nan(ind) -NaN'.split(), V)),
    ('asterisks', "FORTRAN's field", cell('* **** ********'.split(), X + V)),
    ("Microsoft's NaN and infinity", 'NaN|-skip|infinite|not finite|' + NOT,
     cell('1.#QNAN -1.#IND 1.#INF'.split(), X + V)),
    # (a field of eight characters may not hold it)
    ('an infinite coordinate', 'not finite|"[-+]?Infinit?": not a number',
     cell('inf -inf Infinity +inf'.split())),
    ('an infinite value', 'infinite', cell('inf -Infinity 1e999'.split(), V)),
    ('beyond the range of numbers', 'not finite', cell(
        '1e999 -1e400 1E+00309'.split())),
    ('a limit', r'\(a limit', cell('<0.05 >100 <1e-3'.split(), X + V)),
    ('a word', NOT, cell('abc here O l0 x'.split(), X + V)),
    ('a minus of Unicode', 'U[+]2212', cell(['\u22121.5', '\u22122'], X + V)),
    ('a decimal comma', 'decimal|one separator|columns', cell(
        '0,84 -1,5 1,5e3'.split(), X + V)),
    ('thousands', 'thousands|decimal|points|' + WIDE, cell(
        ['1,234.5', '1,234,567'], X + V)),
    ('thousands by blanks', 'blanks between', cell(
        ['1\u00a0234', '1\u2009234.5', '1\u202f234'], X + V)),
    ("other languages' numbers", NOT, cell(
        '0x10 1_000 1e5e5 1.2.3 --5 +-5 1e 1e+ 5m 0b1 1.5f 1..5 .e5 1e5.5 '
        '12abc'.split(), X + V)),
    ('a unit', 'unit|' + NOT, cell(['5 m', '1.5 km'], X + V)),
    ('two numbers in a cell', 'two numbers|' + NOT, cell(['1 2', '0.5 -1'], X + V)),
    ('glued numbers', NOT, in_a_cell(lambda f, a, x, b: a + x + '-1.5' + b)),
    ('an atom that is cut', 'not an atom|no end|blank|has room|' + WIDE,
     in_a_row(cut_atom)),
    ('a NUL', 'NUL|not text|no text|UTF-16|no binary STL|where PCD has FIELDS',
     in_a_cell(lambda f, a, x, b: a + '\0' + x[1:] + b, True)),
    ('an open quote', 'quote|v has|where STL|ends after|not an atom|' + WIDE,
     in_a_cell(lambda f, a, x, b: a + '"' + x + b)),
    ('a cell less', 'numbers|not an atom|empty|ends after|blank|' + WIDE,
     in_a_cell(lose_cell)),
    ('two cells more', 'not 5|v has|numbers|not an atom|ends after|vertex and|left out|'
     + WIDE, in_a_row(more_cell)),
    ('a row less', 'ends after|has room|one more|where|cut|announce|numbered|' + WIDE,
     in_a_row(lose_row)),
    ('a count less', 'behind|one more|further|left out|columns|WIDTH',
     count_to(['4', '3'])),
    ('a count more', r'ends after|room for|WIDTH|has \d|' + WIDE, count_to(['6', '7'])),
    ('a count that is huge', 'room for|WIDTH|ends after|' + WIDE,
     count_to(['1000000000000', '99999999999999', '4294967301'])),
    ('a count that is none', '": not a number|not a number of|not a line of|'
     'titles are left out|lines behind the points announced|columns?, but',
     count_to('-1 nan 0x5 5.5 1e1 +5 9007199254740993 5a *'.split())),
    ('no points', 'no points|room|WIDTH|' + WIDE, count_to(['0'])),
    ('a misspelt word', 'where|unknown|line of|not a|known|fewer|column|begins as|'
     'no end|not read|no points|left out', misspell),
    ('another separator in a line', 'separator|unknown words|' + WIDE,
     in_a_row(other_separator)),
    ('a binary count less', 'behind|left out|size|not 84|announces|WIDTH|faces|no text',
     packed_count([4, 3]), 1),
    ('a binary count more', 'room for|size|not 84|announces|WIDTH|no text|ends after|'
     'head is not', packed_count([6, 2 ** 31 - 1]), 1),
    ('a NaN among coordinates', '-skip', packed_cell(float('nan')), 1),
    ('an infinity among coordinates', 'not finite', packed_cell(float('inf')), 1),
    ('a cut', 'ends|room for|cut|size|no end|column is|empty|where|not |fewer|'
     'no points|head|needs|number|' + WIDE, cut_file, 1),
    ('something behind', 'behind|left out|not 84|no text|size|where|unknown|' + WIDE,
     behind, 1),
    ('a line of junk', 'unknown|where|left out|ends after|one more|not an|' + WIDE,
     in_a_row(junk)),
    ('UTF-16', 'UTF-16|not text|no text', utf16))]
