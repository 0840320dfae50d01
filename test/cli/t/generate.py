"""generate.py - files in all formats that build/tess reads, with what each format
allows, drawn by chance; and damages of them.

All hold the same five points, most with a value.  test_generate.py has them
read; so do bytes.py of test/fuzz, which changes their bytes, and
test_others.py, by other programs.
"""
import random
import re
import struct

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1.5, 0), (0, 0, -2), (.134, .25, -.5)]
VALUES = [0, 10, 20, 30, 40]

# In a text that is made here: before a cell of a coordinate, of a value, a
# count, a word that the format has; and behind it.
X, V, N, W, END = '\ue001', '\ue002', '\ue003', '\ue004', '\ue00f'
MARKED = re.compile('([%s])([^%s]*)%s' % (X + V + N + W, END, END))


# Files that others read, too: numbers as C writes them, few comments
plain = False


class File:
    """What a writer makes: text, with marks, or bytes."""

    def __init__(self, ending, text=None, data=None, options=(), points=POINTS,
                 values=VALUES, encode=None, **more):
        self.ending, self.text, self.data = ending, text, data
        self.options, self.points, self.values = options, points, values
        self.encode = encode or (lambda s: s.encode())
        self.separator = more.get('separator', ' ')
        self.decimal = more.get('decimal', '.')
        self.cut = more.get('cut')        # must a cut be noticed?  (a count)
        self.fixed = more.get('fixed')    # a PDB file
        self.names = more.get('names')    # of the points, or None
        self.numbers = more.get('numbers', ())  # of data: places of counts
        self.head = more.get('head', 0)         # where its rows begin
        self.narrow = more.get('narrow')        # or (place, 'f' or 'd')

    def bytes(self, text=None):
        if self.text is None:
            return self.data
        return self.encode(MARKED.sub(r'\2', text or self.text))


# ---- numbers and lines ----

def digits(r, x, decimal='.'):
    """x, as a number may be written"""
    if plain:
        return r.choice(['%.15g', '%.6f', '%.9e']) % x
    s = '%.15g' % abs(x)
    mantissa, _, exponent = s.partition('e')
    exponent = int(exponent or 0)
    whole, _, part = mantissa.partition('.')
    way = r.randrange(12)
    if way == 0:
        part += '0' * r.randrange(1, 5)
    elif way == 1 and whole == '0' and part:
        whole = ''
    elif way == 2 and not part and decimal == '.':
        s = whole + '.'
    elif way == 3:
        whole = '00' + whole
    elif way in (4, 5, 6) and x != 0:
        move = r.randrange(-3, 4)
        number = (whole + part).lstrip('0')
        point = len(whole + part) - len(part) - (
            len(whole + part) - len(number)) - move
        number = number.ljust(max(point, 0), '0')
        if point < 1:
            number = '0' * (1 - point) + number
            point = 1
        whole, part = number[:point], number[point:]
        exponent += move
    s = whole + (decimal + part if part else
                 '.' if way == 2 and decimal == '.' else '')
    if exponent or way == 7:
        letter = r.choice('eEdDqQ')
        sign = '-' if exponent < 0 else r.choice(['', '+'])
        s += letter + sign + r.choice(['%d', '%02d', '%03d']) % abs(exponent)
    elif way == 8 and '.' in s:
        s += '+000'
    return ('-' if x < 0 else '+' if r.random() < .1 else '') + s


def x_cell(r, x, decimal='.'):
    return X + digits(r, x, decimal) + END


def v_cell(r, x, decimal='.'):
    return V + digits(r, x, decimal) + END


def lines(r, comments='', blank=True, trim=True):
    """an encoder: line ends, a mark, and lines that mean nothing"""
    if plain:
        return lambda text: text.encode()
    end = r.choice(['\n', '\n', '\r\n', '\r'])
    mark = r.choice([b'', b'', b'\xef\xbb\xbf'])
    last = r.choice([b'', b'', b'', b'\x1a'])
    seed = r.random()

    def encode(text):
        q = random.Random(seed)
        out = []
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


# ---- the formats ----

def table(r):
    separator = r.choice([',', ';', '|', '\t', ' ', '   ', ', ', ' ; '])
    bare = separator.strip(' ') or ' '
    decimal = r.choice(['.', '.', '.', ',']) if bare not in ',' else '.'
    head = r.random() < .5
    label = r.random() < .3
    columns = ['x', 'y', 'z', 'T'] + ['note'] * label
    if head:
        r.shuffle(columns)
    quote = bare != ' ' and r.random() < .3

    def cell(name, i):
        if name == 'note':
            return r.choice(['a', 'b c' if bare != ' ' else 'bc', 'a#b', 'N1'])
        x = VALUES[i] if name == 'T' else POINTS[i]['xyz'.index(name)]
        s = v_cell(r, x, decimal) if name == 'T' else x_cell(r, x, decimal)
        return '"%s"' % s if quote else s
    upper = r.random() < .3
    names = [n.upper() if upper and n != 'T' else n for n in columns]
    if quote:
        names = ['"%s"' % n for n in names]
    rows = [names] if head else []
    rows += [[cell(n, i) for n in columns] for i in range(5)]
    behind = bare if bare != ' ' and r.random() < .1 else ''
    text = ''.join(separator.join(row) + behind + '\n' for row in rows)
    options = ['-decimal', ','] if decimal == ',' else []
    return File(r.choice(['csv', 'txt', 'dat']), text, options=options,
                separator=bare, decimal=decimal, encode=lines(r, '# % ! //'))


def counted(r):
    value = r.random() < .7
    first = r.choice([N + '5' + END + '\n', '3 rbox 5 D3\n' + N + '5' + END +
                      '\n', '3\n' + N + '5' + END + '\n'])
    text = first + ''.join(
        ' '.join([x_cell(r, x) for x in POINTS[i]] +
                 [v_cell(r, VALUES[i])] * value) + '\n' for i in range(5))
    return File('txt', text, values=VALUES if value else None, cut=True,
                encode=lines(r, blank=False))


def xyz(r):
    value = r.random() < .7
    again = r.random() < .2
    text = N + '5' + END + '\n'
    text += r.choice(['', 'five atoms', 'step 1, 7 fs']) + '\n'
    text += ''.join(
        ' '.join([r.choice(['C', 'H', 'O2'])] +
                 [x_cell(r, x) for x in POINTS[i]] +
                 [v_cell(r, VALUES[i])] * value) + '\n' for i in range(5))
    if again:
        text += '5\nagain\n' + ''.join('C %d 1 2%s\n' % (i, ' 3' * value)
                                        for i in range(5))
    return File(r.choice(['xyz', 'xyz', 'txt']), text, cut=True,
                values=VALUES if value else None,
                encode=lines(r, blank=False, trim=False))


def extended(r):
    names = ['species', 'pos', 'T'] if r.random() < .7 else ['pos', 'T']
    if r.random() < .3:
        r.shuffle(names)
    kind = {'species': 'species:S:1', 'pos': 'pos:R:3', 'T': 'T:R:1'}
    keys = ['Properties=' + ':'.join(kind[n] for n in names)]
    if r.random() < .7:
        keys.append('Lattice="%s"' % r.choice(
            ['5 0 0 0 6 0 0 0 7', '5.0 0.0 0.0 1.0 6.0 0.0 0.5 0.5 7.0',
             ' 5 0 0  0 6 0  0 0 7 ']))
        if r.random() < .5:
            keys.append('pbc=' + r.choice(['"T T F"', '"1 0 1"', '[T, T, F]']))
        if r.random() < .3:
            keys.append('Origin="-1 -2 -3.5"')
    if r.random() < .5:
        keys.append('energy=-1.5')
    r.shuffle(keys)
    text = N + '5' + END + '\n' + ' '.join(keys) + '\n'
    for i in range(5):
        cells = {'species': ['C'], 'pos': [x_cell(r, x) for x in POINTS[i]],
                 'T': [v_cell(r, VALUES[i])]}
        text += ' '.join(sum((cells[n] for n in names), [])) + '\n'
    return File('xyz', text, cut=True, encode=lines(r, blank=False, trim=False))


def node(r):
    base = r.randrange(2)
    value, marker = r.random() < .7, r.random() < .3
    text = '%s 3 %d %d\n' % (N + '5' + END, value, marker)
    for i in range(5):
        text += ' '.join(['%d' % (i + base)] +
                         [x_cell(r, x) for x in POINTS[i]] +
                         [v_cell(r, VALUES[i])] * value + ['1'] * marker) + '\n'
    values = [tuple([VALUES[i]] * value + [1] * marker) for i in range(5)]
    return File(r.choice(['node', 'node', 'txt']), text, cut=True,
                values=values if value + marker else None,
                encode=lines(r, '#'))


def off(r):
    word = 'OFF' if plain else r.choice(['OFF', 'OFF', 'COFF', 'NOFF', 'CNOFF'])
    value = word == 'OFF' and r.random() < .5 and not plain
    more = ' 1 0 0' * (('N' in word) + ('C' in word)) + ' 1' * ('C' in word)
    faces = r.randrange(3)
    if plain:
        faces += 1
    text = W + word + END + ('\n' if plain else r.choice(['\n', ' ', '\n\n']))
    text += ('%s %d 0\n' if plain else r.choice(
        ['%s %d 0\n', '%s\n%d 0\n', '%s %d\n0\n'])) % (N + '5' + END, faces)
    for i in range(5):
        text += ' '.join(x_cell(r, x) for x in POINTS[i]) + more
        text += ' ' + v_cell(r, VALUES[i]) + '\n' if value else '\n'
    text += '3 0 1 2\n' * faces
    return File(r.choice(['off', 'off', 'dat']), text, cut=True,
                values=VALUES if value else None, encode=lines(r, '#'))


PLY = {'char': 'b', 'uchar': 'B', 'short': 'h', 'ushort': 'H', 'int': 'i',
       'uint': 'I', 'float': 'f', 'double': 'd', 'int8': 'b', 'uint8': 'B',
       'int16': 'h', 'uint16': 'H', 'int32': 'i', 'uint32': 'I', 'float32': 'f',
       'float64': 'd'}


def ply(r):
    real = r.choice(['double', 'float64'])
    other = r.choice(list(PLY))
    properties = [('x', real), ('y', real), ('z', real), ('T', other)]
    if not plain:
        r.shuffle(properties)
    faces = r.randrange(3)
    form = r.choice(['ascii', 'binary_little_endian', 'binary_big_endian'])
    head = 'ply\nformat %s 1.0\n' % form
    if r.random() < .5:
        head += 'comment of x and 1 2 3\nobj_info none\n'
    head += 'element vertex %s\n' % (N + '5' + END)
    head += ''.join('%s %s %s\n' % (W + 'property' + END, t, n)
                    for n, t in properties)
    if plain:
        faces = 2
    if faces or r.random() < .3:
        head += 'element face %d\nproperty list uchar %s vertex_indices\n' % (
            faces, r.choice(['int', 'uint']))
    head += W + 'end_header' + END + '\n'
    value = {'T': VALUES}
    if form == 'ascii':
        end = r.choice(['\n', '\r\n'])
        text = head
        for i in range(5):
            text += ' '.join(v_cell(r, VALUES[i]) if n == 'T' else
                             x_cell(r, POINTS[i]['xyz'.index(n)])
                             for n, t in properties) + '\n'
        text += '3 0 1 2\n' * faces
        return File(r.choice(['ply', 'ply', 'dat']), text, cut=True,
                    encode=lambda s: s.replace('\n', end).encode())
    order = '<' if 'little' in form else '>'
    head = MARKED.sub(r'\2', head).encode()
    data, narrow, at = head, None, 0
    for n, t in properties:
        if n == 'y':
            narrow = (len(head) + at, order + 'd')
        at += struct.calcsize(order + PLY[t])
    for i in range(5):
        for n, t in properties:
            x = VALUES[i] if n == 'T' else POINTS[i]['xyz'.index(n)]
            data += struct.pack(order + PLY[t], x)
    data += struct.pack(order + 'Biii', 3, 0, 1, 2) * faces
    return File(r.choice(['ply', 'ply', 'dat']), data=data, cut=True,
                head=len(head), narrow=narrow,
                numbers=[(head.index(b'vertex ') + 7, 1)])


def obj(r):
    colours = r.random() < .2 and not plain
    text = r.choice(['', 'mtllib a.mtl\n', 'o a\ng b c\n'])
    for i in range(5):
        text += ' '.join([W + 'v' + END] + [x_cell(r, x) for x in POINTS[i]])
        text += ' .5 .5 1\n' if colours else '\n'
        if r.random() < .2:
            text += 'vn 0 0 1\n'
    if plain:
        text += 'f 1 2 3\nf 3 4 5\n'
    elif r.random() < .6:
        text += r.choice(['f 1 2 3\n', 'f 1/1/1 2/2/2 3/3/3\n',
                          'f 1 2 \\\n 3 4\n', 'l 1 2\n',
                          's off\nusemtl m\nf 1//1 2//1 3//1\n'])
    return File(r.choice(['obj', 'obj', 'dat']), text, values=None,
                encode=lines(r, '#', trim=False))


CORNERS = [0, 1, 2, 0, 3, 4]


def stl(r):
    if r.random() < .5:
        order = '<' if r.random() < .8 or plain else '>'
        data = bytearray(r.choice([b'solid by chance', b'binary',
                                   b'']).ljust(80))
        data[79] = 0
        data += struct.pack(order + 'I', 2)
        for t in range(2):
            data += struct.pack(order + '3f', 0, 0, 1)
            for k in CORNERS[3 * t:3 * t + 3]:
                data += struct.pack(order + '3f', *POINTS[k])
            data += struct.pack(order + 'H', r.randrange(65536))
        single = [tuple(struct.unpack('f', struct.pack('f', x))[0]
                        for x in POINTS[k]) for k in CORNERS]
        return File(r.choice(['stl', 'stl', 'dat']), data=bytes(data),
                    points=single, values=None, cut=True, head=84,
                    narrow=(96, order + 'f'), numbers=[(80, 4)])
    word = (lambda s: s.upper()) if r.random() < .3 and not plain else (
        lambda s: s)
    name = r.choice(['', ' a name'])
    text, solids = '', 1 if plain else r.randrange(1, 3)
    for t in range(2):
        if t < solids:
            text += word('solid') + name + '\n'
        text += W + word('facet normal') + END + ' 0 0 1\n'
        text += W + word('outer loop') + END + '\n'
        for k in CORNERS[3 * t:3 * t + 3]:
            text += W + word('vertex') + END + ' ' + ' '.join(
                x_cell(r, x) for x in POINTS[k]) + '\n'
        text += W + word('endloop') + END + '\n'
        text += W + word('endfacet') + END + '\n'
        if t == 1 or solids == 2:
            text += W + word('endsolid') + END + name + '\n'
    return File(r.choice(['stl', 'stl', 'dat']), text, cut=True,
                points=[POINTS[k] for k in CORNERS], values=None,
                encode=lines(r))


def npy(r):
    kind = r.choice(['f8', 'f8', 'f4', 'i1', 'i2', 'i4', 'i8', 'u1', 'u2'])
    order = r.choice('<>') if kind[1] != '1' else '|'
    code = {'f8': 'd', 'f4': 'f', 'i1': 'b', 'i2': 'h', 'i4': 'i', 'i8': 'q',
            'u1': 'B', 'u2': 'H'}[kind]
    pack = (order if order != '|' else '<') + code
    rows = [p + (v,) for p, v in zip(POINTS, VALUES)]
    if kind[0] != 'f':
        rows = [tuple(int(abs(x) * 2) if kind[0] == 'u' else int(x * 2)
                      for x in row) for row in rows]
    rows = [struct.unpack('=4' + code, struct.pack('=4' + code, *row))
            for row in rows]
    turned = r.random() < .3
    flat = [x for c in zip(*rows) for x in c] if turned else \
        [x for row in rows for x in row]
    text = "{'descr': '%s%s', 'fortran_order': %s, 'shape': (5, 4)%s}" % (
        order, kind, turned, r.choice(['', ', ']))
    version = r.randrange(1, 4)
    size = 10 if version == 1 else 12
    text += ' ' * ((-size - len(text) - 1) % 64) + '\n'
    data = b'\x93NUMPY' + bytes([version, 0]) + struct.pack(
        '<H' if version == 1 else '<I', len(text)) + text.encode()
    shape = data.index(b'(5') + 1
    head = len(data)
    data += struct.pack(pack[0] + '20' + code, *flat)
    return File(r.choice(['npy', 'npy', 'dat']), data=data, cut=True, head=head,
                points=[row[:3] for row in rows],
                values=[row[3] for row in rows], numbers=[(shape, 1)],
                narrow=(head, pack) if code in 'fd' else None)


def pdb(r):
    text = r.choice(['', 'HEADER    A PROTEIN\n',
                     'TITLE     NONE\nREMARK   1\n'])
    if r.random() < .5:
        text += 'CRYST1   10.000   11.000   12.000  90.00  90.00  90.00 P 1\n'
    serial = r.choice([1, 99990])
    models = r.random() < .2
    # (an atom may end with its place: the value is 0)
    short = r.random() < .3
    if models:
        text += 'MODEL        1\n'
    for i in range(5):
        x, y, z = (X + '%8.3f' % v + END for v in POINTS[i])
        text += '%-6s%5d %-4s %3s %s%4d    %s%s%s' % (
            r.choice(['ATOM', 'HETATM']), serial + i,
            r.choice([' CA', ' N', 'H1']), 'ALA', 'A', i + 1, x, y, z)
        if not short:
            text += '%6.2f%s' % (1, V + '%6.2f' % VALUES[i] + END)
            text += r.choice(['', '           C'])
        text += '\n'
        if r.random() < .1:
            text += 'ANISOU%74s\n' % ''
    text += 'TER\n' * (r.random() < .5)
    if models:
        text += 'ENDMDL\nMODEL        2\n' + 'ATOM      1  CA  ALA A   1    ' \
            '   9.000   9.000   9.000  1.00  9.00\nENDMDL\n'
    text += 'END\n'
    end = r.choice(['\n', '\r\n'])
    return File(r.choice(['pdb', 'ent', 'dat']), text, fixed=True,
                values=[0] * 5 if short else VALUES,
                encode=lambda s: s.replace('\n', end).encode())


def pcd(r):
    packed = r.random() < .5
    types = {'x': ('F', 8, 'd'), 'y': ('F', 8, 'd'), 'z': ('F', 8, 'd'),
             'T': r.choice([('F', 4, 'f'), ('F', 8, 'd'), ('U', 1, 'B'),
                            ('I', 2, 'h'), ('U', 4, 'I'), ('I', 4, 'i')]),
             '_': ('U', 1, 'B')}
    fields = ['x', 'y', 'z', 'T']
    r.shuffle(fields)
    if packed and r.random() < .4:
        fields.insert(r.randrange(5), '_')
    count = {f: 3 if f == '_' else 1 for f in fields}
    text = r.choice(['# .PCD v0.7 - Point Cloud Data file format\n'
                     'VERSION 0.7\n', 'VERSION .7\n'])
    text += 'FIELDS %s\n' % ' '.join(fields)
    for name, k in ('SIZE', 1), ('TYPE', 0):
        text += '%s %s\n' % (name, ' '.join(str(types[f][k]) for f in fields))
    if '_' in fields or r.random() < .7:
        text += 'COUNT %s\n' % ' '.join(str(count[f]) for f in fields)
    text += 'WIDTH 5\nHEIGHT 1\n'
    if r.random() < .8:
        text += 'VIEWPOINT 0 0 0 1 0 0 0\n'
    text += 'POINTS %s\n' % (N + '5' + END)
    text += 'DATA ' + ('binary' if packed else 'ascii') + '\n'
    number = lambda f, i: VALUES[i] if f == 'T' else POINTS[i]['xyz'.index(f)]
    if not packed:
        for i in range(5):
            text += ' '.join(v_cell(r, number(f, i)) if f == 'T' else
                             x_cell(r, number(f, i)) for f in fields) + '\n'
        return File(r.choice(['pcd', 'pcd', 'dat']), text, cut=True,
                    encode=lines(r, trim=False))
    head = MARKED.sub(r'\2', text).encode()
    data, narrow, at = head, None, 0
    for f in fields:
        if f == 'y':
            narrow = (len(head) + at, '<d')
        at += types[f][1] * count[f]
    for i in range(5):
        for f in fields:
            data += b'abc' if f == '_' else struct.pack('<' + types[f][2],
                                                         number(f, i))
    return File(r.choice(['pcd', 'pcd', 'dat']), data=data, cut=True,
                head=len(head), narrow=narrow,
                numbers=[(head.index(b'POINTS ') + 7, 1)])


def dump(r):
    kind = r.choice(['', 'u', 's'])
    low, side = (-4., -4., -4.), (8., 16., 8.)
    columns = ['id', 'type', 'x', 'y', 'z', 'T']
    r.shuffle(columns)
    order = list(range(5))
    text = 'ITEM: TIMESTEP\n%d\nITEM: NUMBER OF ATOMS\n%s\n' % (
        r.randrange(9999), N + '5' + END)
    # (of a tilted box the bounds are those of the box around it)
    tilt = [r.choice([-3., -1.5, 0., .25, 2.]) for k in range(3)]
    tilted = r.random() < .6
    xy, xz, yz = tilt if tilted else (0, 0, 0)
    around = [(min(0, xy, xz, xy + xz), max(0, xy, xz, xy + xz)),
              (min(0, yz), max(0, yz)), (0, 0)]
    text += 'ITEM: BOX BOUNDS %s%s\n' % ('xy xz yz ' * tilted, ' '.join(
        r.choice(['pp', 'ff', 'ss']) for k in range(3)))
    text += ''.join((r.choice(['%g %g', '%.16e %.16e']) % (a + d[0], a + b + d[1])
                     ) + ' %g' * tilted % ((t,) if tilted else ()) + '\n'
                    for a, b, d, t in zip(low, side, around, tilt))
    vectors = (side[0], 0, 0), (xy, side[1], 0), (xz, yz, side[2])
    text += W + 'ITEM: ATOMS' + END + ' %s\n' % ' '.join(
        c + kind if c in 'xyz' else c for c in columns)
    points = []
    for i in order:
        p = [(x - a) / b if kind == 's' else x
             for x, a, b in zip(POINTS[i], low, side)]
        p = [float('%.15g' % x) for x in p]
        points.append(tuple(
            low[k] + p[0] * vectors[0][k] + p[1] * vectors[1][k] +
            p[2] * vectors[2][k] for k in range(3)) if kind == 's' else tuple(p))
        cells = {'id': str(i + 1), 'type': '1', 'T': v_cell(r, VALUES[i])}
        cells.update((c, x_cell(r, p[k])) for k, c in enumerate('xyz'))
        text += ' '.join(cells[c] for c in columns) + '\n'
    if r.random() < .2:
        text += MARKED.sub(r'\2', text)
    names = [c for c in columns if c not in 'xyz']
    values = [tuple({'id': i + 1, 'type': 1, 'T': VALUES[i]}[n] for n in names)
              for i in range(5)]
    end = r.choice(['\n', '\r\n'])
    return File(r.choice(['dump', 'lammpstrj', 'dat']), text, cut=True,
                points=points, values=values,
                encode=lambda s: s.replace('\n', end).encode())


LAS = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67]


def las(r):
    minor = r.randrange(5)
    form = r.choice([f for f in range(11) if f < [2, 2, 4, 6, 11][minor]])
    size = {4: 375, 3: 235}.get(minor, 227)
    between = r.choice([0, 0, 60])
    stride = LAS[form] + r.choice([0, 0, 4])
    scale, plus = (.001, .001, .0005), (0., 10., -7.)
    head = bytearray(size)
    head[:4] = b'LASF'
    head[24:26] = bytes([1, minor])
    struct.pack_into('<H', head, 94, size)
    struct.pack_into('<I', head, 96, size + between)
    head[104] = form
    struct.pack_into('<H', head, 105, stride)
    if minor < 4 or (form < 6 and r.random() < .5):
        struct.pack_into('<I', head, 107, 5)
    struct.pack_into('<3d', head, 131, *scale)
    struct.pack_into('<3d', head, 155, *plus)
    for k in range(3):
        all_ = [p[k] for p in POINTS]
        struct.pack_into('<2d', head, 179 + 16 * k, max(all_), min(all_))
    if minor == 4:
        struct.pack_into('<Q', head, 247, 5)
    data, points = bytes(head) + b'\0' * between, []
    for i in range(5):
        k = [round((x - b) / a) for x, a, b in zip(POINTS[i], scale, plus)]
        points.append(tuple(a * n + b for n, a, b in zip(k, scale, plus)))
        data += struct.pack('<3iH', *k, VALUES[i]).ljust(stride, b'\1')
    return File(r.choice(['las', 'las', 'dat']), data=data, points=points,
                cut=True, head=size + between,
                numbers=[(247, 8) if minor == 4 else (107, 4)])


def named(r):
    """many points, with names of many lengths: one may be as the one before,
    of a table it may be empty, and have quotes"""
    form = r.choice(['csv', 'xyz', 'pdb'])
    n = r.randrange(20, 60)
    longest = 4 if form == 'pdb' else r.choice([3, 8, 15])
    least = 0 if form == 'csv' else 1
    names, points, text = [], [], ''
    for i in range(n):
        # (a column of words has one at least)
        name = ''.join(r.choice('abcXYZ_') for k in range(
            r.randrange(least, longest + 1))) if i else r.choice(['', 'a'])
        if form == 'csv' and r.random() < .2:
            name += '"' + r.choice([' b', '', ', c'])
        if i == 1 or (i == 0 and least):
            name = 'ab'
        names.append(names[-1] if i and r.random() < .3 else name)
        points.append(tuple(round(r.uniform(-99, 99), 3) for k in range(3)))
    column = r.randrange(4)
    for i, (name, p) in enumerate(zip(names, points)):
        cells = ['%.3f' % x for x in p]
        if form == 'csv':
            cells.insert(column, '"%s"' % name.replace('"', '""'))
            text += ','.join(cells) + '\n'
        elif form == 'xyz':
            text += ' '.join([name] + cells) + '\n'
        else:
            text += 'ATOM  %5d %-4s ALA A%4d    %8s%8s%8s\n' % (
                i + 1, name, i % 9999, *cells)
    if form == 'xyz':
        text = '%d\n\n' % n + text
    return File(form, text, points=points, names=names,
                values=[0] * n if form == 'pdb' else None)


# tables, by their names, and by formats with heads

AXES = [('x', 'y', 'z'), ('X (m)', 'Y (m)', 'Z (m)'), ('East', 'North', 'RL'),
        ('lon', 'lat', 'depth'), ('x-coordinate', 'y-coordinate',
                                  'z-coordinate')]


def row_cells(r, order, i, decimal='.'):
    """of columns x, y, z, T, in that order"""
    return [v_cell(r, VALUES[i], decimal) if c == 3 else
            x_cell(r, POINTS[i][c], decimal) for c in order]


def shuffled(r):
    order = [0, 1, 2, 3]
    r.shuffle(order)
    names = r.choice(AXES) + ('T',)
    return order, [names[c] for c in order]


def rownames(r):
    """as R's write.table"""
    separator = r.choice([' ', '\t', ',', ';'])
    decimal = r.choice('.,') if separator != ',' else '.'
    order, names = shuffled(r)
    quoted = r.random() < .5 or any(' ' in n for n in names)
    quote = '"%s"' if quoted else '%s'
    rows = r.choice([['1', '2', '3', '4', '5'], ['7', '3', '12', '4', '9'],
                     ['a', 'b2', 'c', 'd', 'e']])
    text = separator.join(quote % n for n in names) + '\n'
    for i in range(5):
        text += separator.join([quote % rows[i]] + row_cells(
            r, order, i, decimal)) + '\n'
    return File(r.choice(['txt', 'csv', 'dat']), text, separator=separator,
                options=['-decimal', ','] if decimal == ',' else [],
                decimal=decimal, encode=lines(r, '#'))


def savetxt(r):
    """names are parted otherwise than rows"""
    separator = r.choice([' ', '\t', ';', '|'])
    order, names = shuffled(r)
    between = r.choice([', ', ',', ';', '\t', '   '] + [' '] * (
        not any(' ' in n for n in names)))
    text = r.choice(['# ', '#', '% ', '! ', '', '']) + between.join(names) + '\n'
    text += ''.join(separator.join(row_cells(r, order, i)) + '\n'
                    for i in range(5))
    return File(r.choice(['txt', 'csv', 'dat']), text, separator=separator,
                encode=lines(r, blank=False, trim=between != '   '))


def rows_numbered(r):
    separator = r.choice([' ', '\t', ',', ';', '|'])
    first = r.choice([0, 1, 1001])
    gap = r.choice([0, 0, 3])
    word = r.choice([[], ['P'], ['a7']])
    text = ''.join(separator.join(
        word + ['%d' % (first + i + gap * (i > 2))] + row_cells(
            r, [0, 1, 2, 3], i)) + '\n' for i in range(5))
    return File(r.choice(['txt', 'csv', 'dat']), text, separator=separator,
                encode=lines(r, '# % ! //'))


def geoeas(r):
    order, names = shuffled(r)
    text = r.choice(['a lake\n', '5 holes of it\n', '# of 3\n'])
    text += r.choice(['4\n', ' 4 10 20 30\n']) + ''.join(
        n + '\n' for n in names)
    text += ''.join(' '.join(row_cells(r, order, i)) + '\n' for i in range(5))
    return File(r.choice(['dat', 'gslib', 'out']), text,
                encode=lines(r, blank=False))


def titled(r):
    text = r.choice(['five of them', 'a b c d e', 'x y z T']) + '\n'
    text += N + '5' + END + '\n'
    text += ''.join(' '.join(row_cells(r, [0, 1, 2, 3], i)) + '\n'
                    for i in range(5))
    return File(r.choice(['txt', 'dat']), text, cut=True,
                encode=lines(r, blank=False))


def amber(r):
    """a restart"""
    text = r.choice(['', 'a b', 'of 5 atoms']) + '\n'
    text += N + '%5d' % 5 + END + r.choice(['', '  0.1000000E+03']) + '\n'
    x = [X + '%12.7f' % c + END for p in POINTS for c in p]
    velocities = ['%12.7f' % (c / 7) for p in POINTS for c in p]
    for part in [x] + [velocities] * (r.random() < .3):
        for k in range(0, 15, 6):
            text += ''.join(part[k:k + 6]) + '\n'
    if r.random() < .5:
        text += '%12.7f' * 3 % (9, 9, 9) + r.choice(
            ['', '%12.7f' * 3 % (90, 90, 90)]) + '\n'
    return File(r.choice(['rst7', 'inpcrd', 'dat']), text, values=None,
                fixed=True, cut=True, encode=lines(r, blank=False, trim=False))


def gocad(r):
    kind = r.choice(['VSet', 'TSurf', 'PLine'])
    value = r.random() < .7
    text = 'GOCAD %s 1\nHEADER {\nname:a b\n*solid*color:1 0 0 1\n}\n' % kind
    if r.random() < .5:
        text += 'GOCAD_ORIGINAL_COORDINATE_SYSTEM\nNAME Default\nAXIS_NAME "X" ' \
            '"Y" "Z"\nZPOSITIVE Elevation\nEND_ORIGINAL_COORDINATE_SYSTEM\n'
    if value:
        text += 'PROPERTIES T\n' + r.choice(['', 'ESIZES 1\n'])
    text += {'VSet': '', 'TSurf': 'TFACE\n', 'PLine': 'ILINE\n'}[kind]
    for i in range(5):
        text += ' '.join([W + ('PVRTX' if value else 'VRTX') + END,
                          '%d' % (i + 1)] + [x_cell(r, x) for x in POINTS[i]] +
                         [v_cell(r, VALUES[i])] * value) + '\n'
    text += {'VSet': '', 'TSurf': 'TRGL 1 2 3\n', 'PLine': 'SEG 1 2\n'}[kind]
    return File(r.choice(['vs', 'ts', 'dat']), text + 'END\n',
                values=VALUES if value else None, encode=lines(r, '#'))


def nastran(r):
    """in fields of 8 or 16 columns, or with commas"""
    wide = r.choice([0, 8, 16])
    text = r.choice(['', 'SOL 101\nCEND\nBEGIN BULK\n', '$ by hand\n'])
    for i in range(5):
        p = POINTS[i]
        if wide == 0:
            cells = [x_cell(r, x) for x in p]
            text += W + 'GRID' + END + ',%d,%s,%s\n' % (
                i + 11, r.choice(['', '0']), ','.join(cells))
            continue
        form = r.choice(['%*.3f', '%*.2E']) if wide == 16 or i < 4 else '%*.3f'
        form = '%*.3f' if i == 4 else form
        cells = [X + form % (wide, x) + END for x in p]
        if wide == 8:
            text += W + 'GRID' + END + '    %8d%8s%s\n' % (
                i + 11, r.choice(['', '0']), ''.join(cells))
        else:
            text += W + 'GRID*' + END + '   %16d%16s%s%s*\n*       %s\n' % (
                i + 11, r.choice(['', '0']), *cells)
    text += r.choice(['', 'CTETRA  1       1       11      12      13      14\n'])
    return File(r.choice(['bdf', 'nas']), text, values=None,
                fixed=wide > 0, separator=',' if wide == 0 else ' ',
                encode=lines(r, '$', trim=False))


def post(r):
    order, names = shuffled(r)
    text = r.choice(['', '\n']) + '[Name]\nOutlet Plane\n\n' + r.choice(
        ['', '[Spatial Fields]\nx, y, z\n\n']) + '[Data]\n'
    text += ', '.join(names) + '\n'
    text += ''.join(', '.join(row_cells(r, order, i)) + '\n' for i in range(5))
    text += r.choice(['', '\n[Faces]\n0, 1, 2\n'])
    return File(r.choice(['csv', 'txt']), text, separator=',',
                encode=lines(r, trim=False))


def petrel(r):
    order, names = shuffled(r)
    text = r.choice(['', '# Petrel Points with attributes\n']) + r.choice(
        ['', 'VERSION 1\n']) + 'BEGIN HEADER\n'
    text += ''.join((r.choice(['FLOAT,', '']) if n == 'T' else '') + n + '\n'
                    for n in names) + 'END HEADER\n'
    text += ''.join(' '.join(row_cells(r, order, i)) + '\n' for i in range(5))
    return File(r.choice(['txt', 'dat']), text, encode=lines(r, '#', trim=False))


def cnv(r):
    order = [0, 1, 2, 3]
    r.shuffle(order)
    names = ['longitude: Longitude [deg]', 'latitude: Latitude [deg]',
             r.choice(['depSM: Depth [salt water, m]',
                       'prDM: Pressure, Digiquartz [db]']), 't090C: T [C]']
    text = '* Sea-Bird SBE 9 Data File:\n** Ship: none\n# nquan = 4\n'
    text += '# nvalues = ' + N + '5' + END + '\n' + ''.join(
        '# name %d = %s\n' % (k, names[c]) for k, c in enumerate(order))
    text += '# bad_flag = -9.990e-29\n# file_type = ascii\n*END*\n'
    for i in range(5):
        text += ''.join((V + '%11.4f' % VALUES[i] + END) if c == 3 else
                        (X + '%11.4f' % POINTS[i][c] + END)
                        for c in order) + '\n'
    return File(r.choice(['cnv', 'txt']), text, fixed=True, cut=True,
                encode=lines(r, blank=False, trim=False))


def bottles(r):
    order = [0, 1, 2, 3]
    r.shuffle(order)
    names = ['LONGITUDE', 'LATITUDE', 'CTDPRS', 'CTDTMP']
    text = 'BOTTLE,20200907XXXABC\nEXPOCODE,' + ','.join(
        names[c] for c in order) + '\n' + ',' * 4 + '\n'
    text += ''.join(','.join(['99XX_1'] + row_cells(r, order, i)) + '\n'
                    for i in range(5)) + 'END_DATA\n'
    return File(r.choice(['csv', 'txt']), text, separator=',',
                encode=lines(r, '#', trim=False))


def odv(r):
    separator = r.choice(['\t', ';', ','])
    text = separator.join(['Cruise', 'Station', 'Type', 'Longitude [degrees_east]',
                           'Latitude [degrees_north]', 'Depth [m]', 'T']) + '\n'
    for i in range(5):
        text += separator.join(['C', 'A%d' % i, 'B'] + row_cells(
            r, [0, 1, 2, 3], i)) + '\n'
    return File(r.choice(['txt', 'csv']), text, separator=separator,
                encode=lines(r, '//', trim=False))


def well(r):
    order, names = shuffled(r)
    names = [re.sub(r'[- (].*', '', n) for n in names]
    text = '~Version\n VERS. %s : \n WRAP. NO :\n~W\n NULL. %s :\n~Curve\n' % (
        r.choice(['1.2', '2.0']), r.choice(['-999.25', '-9999.00']))
    text += ''.join(' %s.%s : a curve\n' % (n, r.choice(['M', '', 'API']))
                    for n in names) + r.choice(['~A\n', '~Ascii Log Data\n'])
    text += ''.join('  '.join(row_cells(r, order, i)) + '\n' for i in range(5))
    return File(r.choice(['las', 'txt']), text, encode=lines(r, '#', trim=False))


def pqr(r):
    """x, y, z, charge and radius are the last words; or the first three are in
    PDB's columns"""
    text = r.choice(['', 'REMARK   1 by hand\n'])
    free = r.random() < .5
    form = r.choice([' %7.4f %6.4f', ' %8.4f %7.4f', '%12.4f%12.4f',
                     '  %.8f   %.3f  C'])
    for i in range(5):
        behind = form % (VALUES[i], 1.5)
        if free:
            text += ' '.join([W + 'ATOM' + END, '%d' % i, 'CA', 'ALA'] + r.choice(
                [[], ['A']]) + ['%d' % i] + [x_cell(r, x) for x in POINTS[i]])
            text += behind + '\n'
        else:
            text += W + 'ATOM  ' + END + '%5d  C   ALA A%4d    ' % (i, i)
            text += ''.join(X + '%8.3f' % x + END for x in POINTS[i])
            text += behind + '\n'
    return File('pqr', text, fixed=not free, values=[(v, 1.5) for v in VALUES],
                encode=lines(r, trim=False))


FORMATS = [table, counted, xyz, extended, node, off, ply, obj, stl, npy, pdb,
           pcd, dump, las, rownames, savetxt, rows_numbered, geoeas, titled,
           amber, gocad, nastran, post, petrel, cnv, bottles, odv, well, pqr]

# ---- damages ----

def cell(kind, texts, words, where=X, value_words=None):
    """texts in the place of a cell"""
    def damage(r, f):
        if f.text is None:
            return None
        mark = r.choice([X, V]) if where == X + V else where
        cells = [m for m in MARKED.finditer(f.text) if m.group(1) == mark]
        if not cells:
            return None
        m = r.choice(cells)
        text = r.choice(texts)
        if f.decimal == ',':
            text = text.replace(',', ';').replace('.', ',').replace(';', '.')
        if f.separator in text and f.separator != ' ':
            return None
        if f.separator == ' ' and ' ' in text or (text == '' and (
                f.separator == ' ' and not f.fixed)):
            return None
        if f.fixed:
            if len(text.encode()) != len(text) or len(text) > len(m.group(2)):
                return None
            text = text.rjust(len(m.group(2)))
        return f.bytes(f.text[:m.start()] + text + f.text[m.end():])
    return kind, damage, words


def text_of(change, needs=None):
    """a change of the whole text"""
    def damage(r, f):
        if f.text is None or (needs and not needs(f)):
            return None
        text = change(r, f)
        return None if text is None else f.bytes(text)
    return damage


def a_mark(r, f, mark):
    cells = [m for m in MARKED.finditer(f.text) if m.group(1) == mark]
    return r.choice(cells) if cells else None


def count_to(texts):
    def damage(r, f):
        if f.text is None:
            return None
        m = a_mark(r, f, N)
        if m and f.ending == 'txt' and m.end() < f.text.index('\n'):
            return None  # (it may be a line of numbers)
        return m and f.bytes(f.text[:m.start()] + r.choice(texts) +
                             f.text[m.end():])
    return damage


def packed_count(numbers):
    """a count in a binary file"""
    def damage(r, f):
        if f.text is not None or not f.numbers:
            return None
        at, size = f.numbers[0]
        n = r.choice(numbers)
        if size == 1:
            return f.data[:at] + b'%d' % n + f.data[at + 1:]
        order = f.narrow[1][0] if f.narrow else '<'
        new = struct.pack(order + {4: 'I', 8: 'Q'}[size], n % 256 ** size)
        return f.data[:at] + new + f.data[at + size:]
    return damage


def packed_cell(numbers):
    def damage(r, f):
        if f.text is not None or not f.narrow:
            return None
        at, code = f.narrow
        new = struct.pack(code, r.choice(numbers))
        return f.data[:at] + new + f.data[at + len(new):]
    return damage


def row_lines(f):
    return [k for k, line in enumerate(f.text.split('\n')) if X in line]


def lose_row(r, f):
    rows = f.text.split('\n')
    del rows[r.choice(row_lines(f))]
    return '\n'.join(rows)


def lose_cell(r, f):
    m = a_mark(r, f, X)
    quote = f.text[m.end():m.end() + 1] == '"'
    a, b = m.start() - quote, m.end() + quote
    while f.separator != ' ' and f.text[b:b + 1] == ' ':
        b += 1
    if f.text[b:b + 1] == f.separator:
        b += 1
    elif f.text[b:b + 1] == '\n' and f.separator in f.text[:a]:
        a = f.text[:a].rindex(f.separator)
    return f.text[:a] + f.text[b:]


def more_cell(r, f):
    rows = f.text.split('\n')
    k = r.choice(row_lines(f))
    rows[k] = f.separator.join([rows[k].rstrip(f.separator), '7', '8'])
    return '\n'.join(rows)


def glue(r, f):
    m = a_mark(r, f, X)
    return f.text[:m.end() - 1] + '-1.5' + f.text[m.end() - 1:]


def cut_atom(r, f):
    rows = f.text.split('\n')
    k = r.choice(row_lines(f)[1:])
    # by the last digit of its place, which is in column 54
    rows[k] = MARKED.sub(r'\2', rows[k])[:53]
    return '\n'.join(rows)


def nul(r, f):
    m = a_mark(r, f, X)
    return f.text[:m.start()] + '\0' + f.text[m.start() + 1:]


def open_quote(r, f):
    m = a_mark(r, f, X)
    return f.text[:m.start()] + '"' + m.group(2) + f.text[m.end():]


def misspell(r, f):
    m = a_mark(r, f, W)
    if m is None:
        return None
    s = m.group(2)
    k = r.randrange(len(s))
    # (a blank may be one of several)
    if (s[:k] + s[k + 1:]).endswith('OFF') or s[k] == ' ':
        return None
    return f.text[:m.start()] + s[:k] + s[k + 1:] + f.text[m.end():]


def other_separator(r, f):
    rows = f.text.split('\n')
    k = row_lines(f)[r.randrange(1, 5)]
    new = {',': ';', ';': '|', '|': ';', '\t': ';', ' ': ','}[f.separator]
    rows[k] = re.sub(r' *[%s] *' % f.separator if f.separator != ' ' else ' +',
                     new, rows[k])
    return '\n'.join(rows)


def cut_file(r, f):
    data = f.bytes()
    if not f.cut:
        return None
    at = len(data) if f.text is not None else 0
    if f.text is not None:
        # before the last row ends
        last = f.text.rindex(END, 0, f.text.rindex(X) + 40)
        at = len(f.bytes(f.text[:f.text.rindex(X)] + '\n'))
        return data[:r.randrange(at // 2, at)] if at > 1 else None
    return data[:r.randrange(f.head, len(data) - 1)]


def behind(r, f):
    """something behind the end"""
    if f.text is None:
        return f.data + b'\1\2\3'
    if not f.cut:
        return None
    return f.encode(MARKED.sub(r'\2', f.text)) + b'junk 1 2\n'


def junk(r, f):
    if f.text is None or f.text.count('\n') < 6:
        return None
    rows = f.text.split('\n')
    rows.insert(r.choice(row_lines(f)) + 1, 'junk 1 2')
    return f.bytes('\n'.join(rows))


def utf16(r, f):
    if f.text is None:
        return None
    s = MARKED.sub(r'\2', f.text)
    return r.choice([b'\xff\xfe', b'']) + s.encode('utf-16-le')


table_alone = lambda f: f.ending in ('csv', 'txt', 'dat') and not f.cut and \
    not f.fixed and not f.text.startswith('solid')
counts = lambda f: f.cut

NOT = 'not a number'
DAMAGES = [
    cell('an empty cell', [''], 'empty|-skip|columns?, but|columns|number|blank'),
    cell('an absent number', ['NA', 'N/A', '#N/A', 'null', 'None', '-', '--',
                              '?', '<NA>', '#DIV/0!', '#VALUE!'], '-skip'),
    cell('an absent number, as a coordinate NaN',
         ['nan', 'NaN', '-nan', '-nan(ind)', 'NAN'], '-skip'),
    cell('an absent value', ['NA', 'null', '-', '#N/A'], '-skip', V),
    cell('a value that is NaN', ['nan', '-nan(ind)', '-NaN'], 'NaN', V),
    cell('asterisks', ['*', '****', '********'], "FORTRAN's field", X + V),
    cell("Microsoft's NaN and infinity", ['1.#QNAN', '-1.#IND', '1.#INF'],
         'NaN|-skip|infinite|not finite|' + NOT, X + V),
    # (a field of eight characters may not hold it)
    cell('an infinite coordinate', ['inf', '-inf', 'Infinity', '+inf'],
         'not finite|"[-+]?Infinit?": not a number'),
    cell('an infinite value', ['inf', '-Infinity', '1e999'],
         'infinite', V),
    cell('beyond the range of numbers', ['1e999', '-1e400', '1E+00309'],
         'not finite'),
    cell('a limit', ['<0.05', '>100', '<1e-3'], r'\(a limit', X + V),
    cell('a word', ['abc', 'here', 'O', 'l0', 'x'], NOT, X + V),
    cell('a minus of Unicode', ['\u22121.5', '\u22122'], 'U[+]2212', X + V),
    cell('a decimal comma', ['0,84', '-1,5', '1,5e3'],
         'decimal|one separator|columns', X + V),
    cell('thousands', ['1,234.5', '1,234,567'],
         'thousands|decimal|points|columns?, but|columns|' + NOT, X + V),
    cell('thousands by blanks', ['1\u00a0234', '1\u2009234.5', '1\u202f234'],
         'blanks between', X + V),
    cell('other languages\' numbers', ['0x10', '1_000', '1e5e5', '1.2.3', '--5',
                                       '+-5', '1e', '1e+', '5m', '0b1', '1.5f',
                                       '1..5', '.e5', '1e5.5', '12abc'],
         NOT, X + V),
    cell('a unit', ['5 m', '1.5 km'], 'unit|' + NOT, X + V),
    cell('two numbers in a cell', ['1 2', '0.5 -1'], 'two numbers|' + NOT,
         X + V),
    ('glued numbers', text_of(glue, lambda f: not f.fixed), NOT),
    ('an atom that is cut', text_of(cut_atom, lambda f: f.fixed),
     'not an atom|columns|no end|blank|has room|' + NOT),
    ('a NUL', text_of(nul), 'NUL|not text|no text|UTF-16|no binary STL|'
     'where PCD has FIELDS'),
    ('an open quote', text_of(open_quote, lambda f: not f.fixed),
     'quote|columns?, but|columns|v has|where STL|ends after|not an atom|' +
     NOT),
    ('a cell less', text_of(lose_cell, lambda f: not f.fixed),
     'columns?, but|columns|numbers|not an atom|empty|ends after|blank|' + NOT),
    # (of a grid point of Nastran they are allowed)
    ('two cells more', text_of(more_cell, lambda f: not f.fixed and
                               f.ending not in ('bdf', 'nas')),
     'columns?, but|columns|not 5|v has|numbers|not an atom|ends after|vertex and|'
     'left out'),
    ('a row less', text_of(lose_row, counts),
     'ends after|has room|one more|where|cut|announce|columns?, but|columns|'
     'numbered|' + NOT),
    ('a count less', count_to(['4', '3']),
     'behind|one more|further|left out|columns?, but|columns|WIDTH'),
    ('a count more', count_to(['6', '7']),
     'ends after|room for|WIDTH|has \\d|columns?, but|columns|' + NOT),
    ('a count that is huge', count_to(['1000000000000', '99999999999999',
                                       '4294967301']),
     'room for|WIDTH|ends after|columns?, but|columns|' + NOT),
    ('a count that is none', count_to(['-1', 'nan', '0x5', '5.5', '1e1', '+5',
                                       '9007199254740993', '5a', '*']),
     '": not a number|not a number of|not a line of|titles are left out|'
     'lines behind the points announced|columns?, but'),
    ('no points', count_to(['0']),
     'no points|room|WIDTH|columns?, but|columns|' + NOT),
    ('a misspelt word', text_of(misspell, lambda f: W in f.text),
     'where|unknown|line of|not a|known|fewer|column|begins as|no end|not read|no points|'
     'left out'),
    ('another separator in a line', text_of(other_separator, table_alone),
     'columns?, but|columns|separator|unknown words|' + NOT),
    ('a binary count less', packed_count([4, 3]),
     'behind|left out|size|not 84|announces|WIDTH|faces|no text'),
    ('a binary count more', packed_count([6, 2 ** 31 - 1]),
     'room for|size|not 84|announces|WIDTH|no text|ends after|head is not'),
    ('a NaN among coordinates', packed_cell([float('nan')]), '-skip'),
    ('an infinity among coordinates', packed_cell([float('inf')]),
     'not finite'),
    ('a cut', lambda r, f: cut_file(r, f),
     'ends|room for|cut|size|no end|number|columns?, but|columns|column is|'
     'empty|where|not |fewer|'
     'no points|head|needs'),
    ('something behind', behind,
     'behind|left out|not 84|no text|size|columns?, but|columns|where|'
     'unknown|' + NOT),
    ('a line of junk', junk,
     'columns?, but|columns|unknown|where|left out|ends after|one more|'
     'not an|' + NOT),
    ('UTF-16', utf16, 'UTF-16|not text|no text'),
]
