"""bytes.py [N [SEED]] - N=20000 files with bytes changed, read by build/tess.

Valid and damaged files of all formats, by cli/t/generate.py, are changed: bits
and bytes, numbers to huge ones, pieces lost, doubled, moved, from another format
put in, the end cut.  Each is read twice: by a build with -fsanitize=address,
undefined, and by one that has two seconds and as much memory as 40 MB and 100
times the file.  Both must end with code 0, 1 or 2 and the same words, and what is
read must be accounted for, byte by byte or line by line.  Run from the top
directory; takes CC from the environment.  A file that fails is kept in
build/mutants.  (The library, which does not read, is that of `make'.)
"""
import os
import random
import resource
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, 'test/cli/t')
import generate

BUILD = 'build/mutants'
SANITIZE = '-g -O1 -fsanitize=address,undefined -fno-sanitize-recover=all'
MEMORY, TIMES, SECONDS = 40e6, 100, 2
HUGE = [b'0', b'-1', b'2147483647', b'2147483648', b'4294967296', b'1e308',
        b'9007199254740993', b'99999999999999999999', b'nan', b'1e999', b'513']
OPTIONS = [[], [], [], ['-skip'], ['-nodata', '0'], ['-cols', '1,2,3'],
           ['-cols', 'x,y,z,T'], ['-decimal', ','], ['-below', '0.5'], ['-plane'],
           ['-validate', '-by', '1'], ['-periodic', '-volumes', '-'],
           ['-volumes', '-'], ['-cols', '3,1,2,4,4'], ['-skip', '-cols', '4,1,2']]


def build(name, flags):
    text = open('Makefile').read()
    first = text.index('\nPROGRAM = ')
    names = text[first:text.index('\n\n', first)].replace('\\\n', ' ').split()[2:]
    sources = ['build/tess.o', 'build/hhpred.o']
    for n in names:
        n = os.path.basename(n)[:-2] + '.c'
        for folder in ('test/cli/src', 'test/cli/src/read', 'test/cli/src/draw',
                       'test/recipes', 'test/lib'):
            if os.path.exists(os.path.join(folder, n)):
                sources.append(os.path.join(folder, n))
    out = os.path.join(BUILD, name)
    command = [os.environ.get('CC', 'cc')] + flags.split() + ['-I.', '-o', out]
    subprocess.run(command + sources + ['-lm'], check=True)
    return out


def piece(r, data, most=40):
    a = r.randrange(len(data))
    return a, min(len(data), a + 1 + r.randrange(most))


def change(r, data, other):
    """one change of the bytes"""
    way = r.randrange(11)
    if not data:
        return other
    a, b = piece(r, data)
    if way == 0:
        return data[:a] + bytes([data[a] ^ 1 << r.randrange(8)]) + data[a + 1:]
    if way == 1:
        return data[:a] + bytes([r.choice([0, 9, 10, 13, 26, 34, 35, 44, 45, 46,
                                           48, 57, 59, 92, 127, 128, 255])]) + \
            data[a + 1:]
    if way == 2:
        return data[:a] + data[b:]
    if way == 3:
        return data[:b] + data[a:b] * r.choice([1, 1, 2, 50]) + data[b:]
    if way == 4:
        c, d = piece(r, other, 200)
        return data[:a] + other[c:d] + data[b:]
    if way == 5:
        return data[:a]
    if way == 6:
        return data[:a] + other[r.randrange(len(other)):]
    if way in (7, 8):
        # a number that is there, to another one
        numbers = [m for m in generate.re.finditer(rb'[0-9]+', data)]
        if not numbers:
            return data
        m = r.choice(numbers[:12] if way == 7 else numbers)
        return data[:m.start()] + r.choice(HUGE) + data[m.end():]
    if way == 9:
        return data[:a] + bytes(r.randrange(256) for _ in range(b - a)) + data[b:]
    lines = data.split(b'\n')
    r.shuffle(lines)
    return b'\n'.join(lines)


def sample(r):
    for _ in range(50):
        f = r.choice(generate.FORMATS)(r)
        data = r.choice(generate.DAMAGES)[1](r, f) if r.random() < .3 else \
            f.bytes()
        if data:
            return f, data
    return f, f.bytes()


def limits(size):
    def set_():
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        most = int(MEMORY + TIMES * size)
        resource.setrlimit(resource.RLIMIT_AS, (most, most))
    return set_


def run(command, name, pipe, before=None):
    with open(name, 'rb') as file:
        p = subprocess.run(command, stdin=file if pipe else subprocess.DEVNULL,
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                           preexec_fn=before, timeout=100)
    said = [s for s in (p.stdout + p.stderr).decode(errors='replace').split('\n')
            if not s.startswith('seconds') and not s.startswith('workspace')]
    return p.returncode, '\n'.join(said)


def one(task):
    safe, plain, seed, k = task
    r = random.Random('%d %d' % (seed, k))
    f, data = sample(r)
    for _ in range(r.choice([1, 1, 1, 2, 4])):
        data = change(r, data, sample(r)[1])
    name = '%s/%d-%d.%s' % (BUILD, seed, k, r.choice(
        [f.ending, f.ending, f.ending, 'csv', 'xyz', 'node']))
    with open(name, 'wb') as file:
        file.write(data)
    pipe = r.random() < .2
    options = ['-account'] + list(f.options) + r.choice(OPTIONS)
    options += ['-' if pipe else name]
    if r.random() < .1:
        # (as places of points that are given)
        points = os.path.join(BUILD, 'points')
        options = ['-account', '-query', '-' if pipe else name, '-values', '-',
                   points]
    a = run([safe] + options, name, pipe)
    b = run([plain] + options, name, pipe, limits(len(data)))
    why = ''
    if a[0] not in (0, 1, 2):
        why = 'code %d: %s' % (a[0], a[1][-1500:])
    elif 'unexpected code' in a[1] or 'NOT ALL' in a[1]:
        why = a[1]
    elif a != b:
        why = 'with two seconds, and %.0f MB: code %d: %s; else %d: %s' % (
            (MEMORY + TIMES * len(data)) / 1e6, b[0], b[1], a[0], a[1])
    if why:
        return 'tess %s: %s' % (' '.join(options), why)
    os.remove(name)
    return ''


def main():
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 20000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    os.makedirs(BUILD, exist_ok=True)
    os.environ['ASAN_OPTIONS'] = 'detect_leaks=0'
    safe, plain = build('safe', SANITIZE), build('plain', '-O1')
    with open(os.path.join(BUILD, 'points'), 'w') as file:
        file.write('0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n')
    faults = 0
    with ThreadPoolExecutor(max_workers=2) as pool:
        for s in pool.map(one, ((safe, plain, seed, k) for k in range(n))):
            if s:
                faults += 1
                print('# ' + s, flush=True)
    print('%sok 1 - %d files, %d faults\n1..1' % ('not ' if faults else '', n, faults))
    sys.exit(faults > 0)


if __name__ == '__main__':
    main()
