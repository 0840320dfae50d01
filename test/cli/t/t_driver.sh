#!/bin/sh
# t_driver.sh - tests of build/tess: its command line, meshes and pictures that
# it writes, large sets.
# shellcheck disable=SC2034 # of common.sh
NAME=driver
. test/cli/t/common.sh

awk 'NR > 1 { print $2 "," $3 "," $4 "," $5 }' one > plain.csv
awk 'NR > 1 { print NR - 1, $2, $3, $4, $5 }' one > numbers.txt
awk 'NR == 1 { print "5 3 2 0" } NR > 1 { print $0, NR - 1, 10 * $1 }' none \
    > numbered
cp none none.node

# ---- what is written ----

# -o, `make run': a name for each input
$TESS -q -o base none.node
yes "-o: four files" test -s base.node -a -s base.ele -a -s base.neigh -a \
    -s base.vtk
(cd "$TOP" && for f in x.csv x.xyz; do
    cp build/driver/plain.csv build/driver/$f
    make run POINTS=build/driver/$f
done
make run POINTS=- < build/driver/plain.csv
make run POINTS=build/driver/numbers.txt \
    OPTIONS="-cols 2,3,4 -node build/driver/run.node") > said 2>&1
yes "make run OPTIONS=..." cmp numbered run.node
yes "make run: names that do not collide" test -s ../x.csv.svg -a \
    -s ../x.xyz.svg -a -s ../stdin.svg
(cd "$TOP" && make grid POINTS=build/driver/numbers.txt \
    OPTIONS="-cols 2,3,4,5") > said 2>&1
yes "make grid POINTS=..." test -s ../numbers.txt.grid.svg -a \
    "$(head -c 200 ../numbers.txt.grid.vtk | grep -a ORIGIN)" = "ORIGIN 0 0 -2"
rm -f ../x.csv.* ../x.xyz.* ../stdin.* ../numbers.txt.*

# ---- the command line ----

$TESS -h > help && $TESS --help | cmp - help
yes "--help is -h" test $? -eq 0
yes "-h names the options" sh -c 'for o in -cols -skip -nodata -decimal -scale \
    -box -periodic -cells -volumes -faces -alpha -clip -by -errors -q; do
    grep -e "^  $o " help || exit 1; done' > /dev/null
yes "--version: the library's" test "$($TESS --version)" = "tess $(sed -n \
    's/^#define TESS_VERSION \([0-9]*\)0\([0-9]\)00L/\1.\2/p' "$TOP"/tess.h)"
$TESS -none > said 2> words
yes "an unknown option" test $? -eq 2
$TESS -box > said 2> words
yes "an option without its argument" test $? -eq 2
yes "what it needs" grep -e '-box needs X0,X1,Y0,Y1,Z0,Z1' words > /dev/null

# the hull, as OBJ and as TetGen's .face: of a cube with a point in its middle
# twelve triangles on edges that are there in both directions, of the volume 1;
# numbers in .face as in .node
awk 'BEGIN { print 9, 3, 0, 0; print "1 .5 .5 .5"
    for (i = 0; i < 8; i++) print i + 2, i % 2, int(i / 2) % 2, int(i / 4)
    }' > cube.node
$TESS -q -face cube.obj cube.node && $TESS -q -face cube.face -node c.node \
    cube.node
yes "-face: OBJ" awk '
    $1 == "v" { p[++n] = $2 " " $3 " " $4 }
    $1 == "f" {
        for (k = 2; k <= 4; k++) edge[$k, $(k % 3 + 2)]++
        split(p[$2] " " p[$3] " " p[$4], a, " ")
        v += a[1] * (a[5] * a[9] - a[6] * a[8]) - a[2] * (a[4] * a[9] - \
            a[6] * a[7]) + a[3] * (a[4] * a[8] - a[5] * a[7])
        m++
    }
    END {
        for (e in edge) {
            split(e, a, SUBSEP)
            if (edge[e] != 1 || edge[a[2], a[1]] != 1) m = 0
        }
        exit !(n == 8 && m == 12 && v == 6)
    }' cube.obj
yes "-face: TetGen's, the same triangles" awk '
    FILENAME ~ /node/ { if (FNR > 1) p[$1] = $2 " " $3 " " $4; next }
    FILENAME ~ /obj/ && $1 == "v" { q[++n] = $2 " " $3 " " $4 }
    FILENAME ~ /obj/ && $1 == "f" { f[++m] = q[$2] q[$3] q[$4] }
    FILENAME ~ /face/ && FNR == 1 { bad = $1 != 12 || $2 != 0 }
    FILENAME ~ /face/ && FNR > 1 {
        if (p[$2] p[$3] p[$4] != f[++i] || $1 != i) bad = 1
    }
    END { exit bad || i != 12 || m != 12 }' c.node cube.obj cube.face
printf '0 0 0\n1 0 0\n0 1 0\n1 1 0\n' > flat
sed 's/$/ 1/' flat > flat.csv
$TESS -q -face flat.face flat
yes "-face of points in a plane: none" test "`cat flat.face`" = "0 0"

# no tetrahedron: no picture of any, all else
awk 'BEGIN { for (i = 0; i < 9; i++) print i, 2 * i, 3 * i }' > straight
printf '1 2 3\n1 2 3\n' > alone
for set in 'flat/lie in one plane' 'straight/lie on one line' \
    'alone/at most one distinct point' 'cube.node/-alpha leaves no'; do
    f=${set%%/*}
    option="-alpha 0.001"
    [ $f = cube.node ] || option=
    rm -f p.svg p.vtu p.ele
    $TESS -q -svg p.svg -mesh p.vtu -mesh p.ele $option $f > said 2> words
    yes "-svg of $f: no such file, all others, exit code 0" test $? -eq 0 -a \
        ! -f p.svg -a -s p.vtu -a "$(cat p.ele)" = "0 4 0"
    yes "-svg of $f: why" grep "p.svg: no picture of a mesh: .*${set#*/}" \
        words > /dev/null
    $TESS -svg p.svg -draw points $option $f > said 2> words
    yes "-svg of $f: -draw points" test $? -eq 0 -a -s p.svg
    yes "-svg of $f: as many dots as points" test "$(grep -o 'M[0-9]* [0-9]*l0' \
        p.svg | wc -l)" -eq "$(sed -n 's/^points *//p' said)"
done
(cd "$TOP" && make run POINTS=build/driver/flat) > said 2>&1
yes "make run: points in a plane" test $? -eq 0 -a -s ../flat.vtk
rm -f ../flat.*

# of a square's 4 points in the plane, two triangles
printf '0 0 1\n3 0 2\n0 3 3\n2 2 4\n' > square
awk '{ print $1, $2, NR % 2, $3 }' square > square3
$TESS -plane -grid 2,2 -values - square 2> words > said
yes "points in a plane: triangles, of no tetrahedron a word" sh -c \
    'grep "^triangles *2$" words && ! grep "tetrahedr\|volume\|facets" words' \
    > /dev/null
sed '1s/^/lon lat depth T\n/' square3 > lon.csv
$TESS -q -grid 2,2,1 -values v.csv lon.csv
yes "-values: the columns' names" test "$(head -n 1 v.csv)" = lon,lat,depth,T
$TESS -q -plane -cols lon,depth -grid 2,2 -values v.csv lon.csv
yes "-values: names in a plane" test "$(head -n 1 v.csv)" = lon,depth,lat,T
sed '$s/4$/1e999/' lon.csv > inf.csv
for method in smooth linear; do
    $TESS -method $method -grid 2,2,1 -values v.csv inf.csv > said 2> words
    yes "no number: what that means for -method $method" test "$(grep -c \
        'not finite.* by -method smooth all of the column' words)" -eq \
        "$(echo $method | grep -c smooth)"
done
$TESS -grid 2,2,1 -values v.csv flat.csv > said 2> words
yes "points of space in a plane: those, and why no tetrahedron" sh -c \
    'grep "^triangles *2$" said && grep "tetrahedron: .* one plane$" said' \
    > /dev/null

# names' endings; several files of one option; standard output
for wrong in '-vtk h.vtu' '-mesh h.obj' '-face h.msh' '-node h.txt' '-ele h.node' \
    '-neigh h.ele' '-cells h.csv' '-volumes h.vtk' '-faces h.obj' \
    '-svg h.png'; do
    $TESS "${wrong% *}" "${wrong#* }" cube.node > said 2> words
    yes "$wrong: refused" test $? -eq 2 -a ! -s said -a ! -f "${wrong#* }"
    yes "$wrong: which are known" grep -e "${wrong%.*}.*the name must end in \." \
        words > /dev/null
done
yes "-mesh: all of them" sh -c "$TESS -mesh h.ply 2>&1 | grep \
    'must end in .vtk, .vtu, .msh, .node, .ele or .neigh$'" > /dev/null
$TESS -q -vtk one.vtk -face one.obj -vtk two.VTK -face two.face cube.node
yes "an option twice: both are written" sh -c 'cmp one.vtk two.VTK &&
    cmp one.obj cube.obj && cmp two.face cube.face'
$TESS -q -ele cube.ele -neigh cube.neigh -svg cube.svg -cells ccube.vtk \
    -volumes cube.csv cube.node
for f in c.node cube.ele cube.neigh cube.face one.vtk cube.svg; do
    option=-${f#*.}
    $TESS "$option" - -check cube.node > said 2> words
    yes "$option -: standard output has that alone" cmp said "$f"
    yes "$option -: all else is on standard error" grep -w proven words > /dev/null
done
$TESS -cells - cube.node 2> words | cmp ccube.vtk -
yes "-cells -" test $? -eq 0
$TESS -volumes /dev/stdout cube.node 2> words | cmp cube.csv -
yes "-volumes /dev/stdout" test $? -eq 0
$TESS -node - -ele /dev/stdout cube.node > said 2> words
yes "two files on standard output" test $? -eq 2 -a ! -s said
yes "no file named -" test ! -f ./-

# what is there stays: a link, what it points to, the input by another name
echo kept > target.node
ln -s target.node link.node
ln -s nothing hanging.node
for link in link hanging; do
    $TESS -node $link.node cube.node > said 2> words
    yes "a $link as output" test $? -eq 2 -a -h $link.node -a ! -f nothing
    yes "a $link as output: why" grep 'is a symbolic link' words > /dev/null
done
yes "a link as output: its file" test "$(cat target.node)" = kept
for name in "`pwd`/cube.node" ../driver/cube.node; do
    $TESS -node "$name" cube.node > said 2> words
    yes "the input by another name" grep 'overwrite the input' words > /dev/null
done

# files for others, read by them: points, cells, values, NaN among them, names
cat > read.py << END
import importlib, sys
import numpy as np
reader = sys.argv[1]
tool = importlib.import_module(reader)
if reader == 'vtk':
    from vtk.util.numpy_support import vtk_to_numpy as array
def rows(name):
    lines = [l.split()[1:] for l in open(name) if l[0] != '#']
    return np.array(lines[1:], float)
def by_meshio(name):
    m = tool.read(name)
    sizes = {k: v[0] for k, v in m.cell_data.items() if k in size}
    values = {k: v.ravel() for k, v in m.point_data.items() if ':' not in k}
    return m.points, m.cells[0].data, values, sizes
def by_vtk(name):
    r = {'vtk': tool.vtkUnstructuredGridReader, 'obj': tool.vtkOBJReader,
         'vtu': tool.vtkXMLUnstructuredGridReader, 'ply': tool.vtkPLYReader,
         'stl': tool.vtkSTLReader}[name[-3:]]()
    r.SetFileName(name)
    if name.endswith('.vtk'): r.ReadAllScalarsOn()
    r.Update()
    m = r.GetOutput()
    flat = m.IsA('vtkPolyData')
    assert flat or set(array(m.GetCellTypesArray())) <= {5, 10}
    c = m.GetPolys() if flat else m.GetCells()
    columns = [{d.GetArrayName(i): array(d.GetArray(i))
                for i in range(d.GetNumberOfArrays())}
               for d in (m.GetPointData(), m.GetCellData())]
    return (array(m.GetPoints().GetData()), array(c.GetConnectivityArray())
            .reshape(m.GetNumberOfCells(), -1), *columns)
def by_gmsh(name):
    tool.initialize()
    tool.option.setNumber('General.Terminal', 0)
    tool.open(name)
    tags, x, _ = tool.model.mesh.getNodes()
    kinds, _, c = tool.model.mesh.getElements()
    assert list(tags) == list(range(1, len(tags) + 1)) and list(kinds) == [4]
    values = {}
    for view in tool.view.getTags():
        name = tool.option.getString('View[%d].Name' % len(values))
        kind, at, v = tool.view.getModelData(view, 0)[:3]
        assert kind == 'NodeData' and list(at) == list(tags)
        values[name] = np.ravel(v)
    tool.finalize()
    return x.reshape(-1, 3), c[0].reshape(-1, 4) - 1, values, {}
read = globals()['by_' + reader]
def same(a, b):
    a, b = np.asarray(a), np.asarray(b)
    # (these readers round)
    if float32: a, b = a.astype('f4'), b.astype('f4')
    return a.shape == b.shape and ((a == b) | (a != a) & (b != b)).all()
node, ele, face = (rows('v.' + kind) for kind in ('node', 'ele', 'face'))
first = int(ele.min())
titles = ['value', 'value2', 'marker']
size = {}
float32 = False
for name in sys.argv[2].split():
    p, c, v, sizes = read(name)
    if name[0] == 'v':
        assert same(p, node[:, :3]) and same(c, ele - first), name
        corners = node[ele.astype(int) - first]
        size = size or sizes
        assert list(sizes) == list(size) or reader == 'gmsh' or '.msh' in name
        assert all(same(sizes[k], size[k]) for k in sizes), name
    else:
        float32 = reader == 'vtk' and name[-3:] in ('ply', 'stl', 'obj')
        corners = node[face.astype(int) - first]
        assert same(np.asarray(p)[c], corners[:, :, :3]), name
        assert len(p) == len(np.unique(face))
    if name[-3:] not in ('obj', 'off', 'stl') and (name[-3:], reader) != (
            'ply', 'vtk'):
        assert list(v) == titles, (name, list(v))
        for k, t in enumerate(titles):
            assert same(np.asarray(v[t])[c], corners[:, :, 3 + k]), (name, t)
            assert '.' not in name or np.isnan(v['value']).any()
for name, titles in (('n.vtk', ['T (%)', '50%20 a', 'T (%)_3']),
                     ('n.vtu', ['T (%)', '50%20 a', 'T (%)_3']),
                     ('n.msh', ['T (%)', '50%20 a', 'T (%)_3'])):
    if name not in sys.argv[3].split(): continue
    v = read(name)[2]
    assert list(v) == titles, (name, list(v))
    assert [list(v[t]) for t in titles] == [[0, 3, 6, 9], [1, 4, 7, 10],
                                            [2, 5, 8, 11]]
END
awk 'BEGIN { srand(1); print 60, 3, 2, 1
    for (i = 1; i <= 60; i++)
        print i, rand(), rand() * 1e-7, rand() * 1e9, \
            i % 9 ? rand() - 0.5 : "nan", i, -i }' > v0.node
printf 'x,y,z,T (%%),50%%20 a,T (%%)\n0,0,0,0,1,2\n1,0,0,3,4,5\n0,1,0,6,7,8
0,0,1,9,10,11\n' > names.csv
$TESS -q -node v.node -ele v.ele -face v.face v0.node
meshes='v.vtk v.vtu v.msh'
for f in $meshes f.vtk f.vtu f.obj f.off f.ply f.stl; do
    case $f in v*) option=-mesh;; *) option=-face;; esac
    $TESS -q $option $f v0.node
done
for end in vtk vtu msh; do $TESS -q -mesh n.$end names.csv; done
yes "a .node file written is read again as it was" sh -c \
    "$TESS -q -node v2.node v.node && cmp v.node v2.node"
# by_others READER FILES FILES-WITH-NAMES
by_others() {
    if $PYTHON -c "import numpy, $1" > said 2>&1; then
        yes "$2, read by $1" $PYTHON read.py "$1" "$2" "$3" > said
    else
        skip "$2: no $1 for $PYTHON"
    fi
}
by_others meshio "$meshes f.vtk f.vtu f.obj f.off f.ply f.stl" 'n.vtu n.msh'
by_others vtk 'v.vtk v.vtu f.vtk f.vtu f.obj f.ply f.stl' 'n.vtk n.vtu'
by_others gmsh v.msh n.msh
printf 'x,y,z,T (\260C)\n0,0,0,1\n' > latin.csv
$TESS -q -mesh latin.msh -mesh latin.vtu latin.csv
yes "a name that is not UTF-8" sh -c \
    'grep "T (?C)" latin.msh && grep "T (&#176;C)" latin.vtu' > /dev/null
$TESS -q -mesh m.node -mesh m.ele -mesh m.neigh -neigh v.neigh v0.node
yes "-mesh: TetGen's" sh -c \
    'for e in node ele neigh; do cmp m.$e v.$e || exit; done'

# ---- pictures ----

$TESS -q -svg a.svg -view 20 70 v0.node && $TESS -q -svg b.svg v0.node
yes "-view" sh -c '! cmp -s a.svg b.svg'
$TESS -q -svg c.svg -view -68 28 v0.node
yes "-view, as if not given" cmp b.svg c.svg
yes "the name of a value" grep '>value<' b.svg > /dev/null
$TESS -q -svg c.svg none.node
yes "colours that are no value" grep 'coloured by distance' c.svg > /dev/null
(cd "$TOP"/test/recipes && $CC -O0 -I"$TOP" -o "$TOP"/build/driver/plainly \
    ../cli/src/*.c ../cli/src/*/*.c slopes.c natural.c derived.c cells.c \
    periodic.c iso.c ../lib/exact.c ../../build/tess.o ../../build/hhpred.o -lm)
for tess in "$TESS" ./plainly; do
    $tess -q -alpha 0.55 -svg m.svg -grid 40,1,30 -values s.svg \
        "$TOP"/test/data/mirror.xyz
    $tess -q -svg c.svg none.node
    cat m.svg s.svg c.svg > "pictured${tess##*/}"
done
yes "pictures: the same bytes without optimization" \
    cmp picturedtess picturedplainly
if $PYTHON -c 'import numpy' 2> words; then
    lines $PYTHON "$TOP"/test/cli/t/pictures.py $TESS
    lines $PYTHON "$TOP"/test/cli/t/shapes.py $TESS
else
    skip "pictures, read back, and alpha shapes: no numpy for $PYTHON"
fi
for wrong in '-draw all/choose points, whole, cut, field or apart' \
    '-size 900/a width and a height' '-size 99,200/a width and a height'; do
    OPTIONS="-svg no.svg ${wrong%/*}"
    refuses pictured "${wrong#*/}" < none.node
done
OPTIONS=
# those of the front page say what is so now
(cd "$TOP" && sh test/pictures/pictures.sh build/driver) > said 2>&1
for f in strip cube methods; do
    for g in "$TOP"/test/pictures/$f.svg $f.svg; do
        grep -o '>[^<>]*</text\|^rms.*' $g
    done > words
    yes "pictures: test/pictures/$f.svg says what is so" test \
        "$(head -n $(($(wc -l < words) / 2)) words)" = \
        "$(tail -n $(($(wc -l < words) / 2)) words)" -a -s $f.svg
done

# ---- -scale ----

# by powers of two, which alter no digit: the mesh of the stretched points, all
# that is written in the given ones
awk 'BEGIN { srand(4); print 300, 3, 0, 0
    for (i = 0; i < 300; i++)
        printf "%d %.17g %.17g %.17g\n", i, rand(), rand(), 128 * rand() }' \
    > thin.node
awk 'NR == 1 { print } NR > 1 { printf "%d %.17g %.17g %.17g\n", $1, $2, 2 * $3,
    $4 / 128 }' thin.node > even.node
$TESS -q -ele even.ele -neigh even.neigh even.node
$TESS -scale 1,2,.0078125 -check -ele a.ele -neigh a.neigh -node a.node -vtk \
    a.vtk -volumes a.csv -faces af.csv thin.node > said 2> words
yes "-scale: the mesh of stretched points" sh -c \
    'cmp even.ele a.ele && cmp even.neigh a.neigh && grep -w proven said' \
    > /dev/null
$TESS -q -node thin2.node -vtk thin.vtk -face thin.face thin.node
yes "-scale: their own coordinates" sh -c 'cmp thin2.node a.node &&
    head -c 7300 thin.vtk > v1 && head -c 7300 a.vtk | cmp v1 -'
yes "-scale: nothing else is said" test ! -s words
$TESS -q -scale 1,2,-.0078125 -ele b.ele -neigh b.neigh -node b.node -vtk b.vtk \
    -volumes b.csv -faces bf.csv thin.node
yes "-scale below 0: the same faces" cmp af.csv bf.csv
for f in ele neigh node vtk csv; do
    yes "-scale below 0: the same .$f" cmp a.$f b.$f
done
$TESS thin.node > said2 2> words
yes "-scale: the volume is not stretched" sh -c \
    'grep ^volume said > v1 && grep ^volume said2 | cmp - v1'
yes "-scale: cells, too: sides, vertices" awk '
    /^cells/ { bad = $7 - $11; n++ }
    END { exit !n || bad > 1e-12 || bad < -1e-12 }' said
yes "sides that differ: a warning" grep -e '-scale 1,1,0.008 ' words > /dev/null
for width in '49 0' '51 1'; do
    printf '0 0 0\n1 0 0\n0 1 0\n0 0 %s\n' ${width% *} > wide
    $TESS wide > said 2> words
    yes "the warning from 1:50 on" test "$(grep -c scale words)" = ${width#* }
done
$TESS -scale 1,1,1 wide > said 2> words
yes "no warning with -scale" test ! -s words
printf '0 0 0\n100 0 0\n0 1 0\n' > wide
$TESS wide > said 2> words
yes "no warning for a plane" test ! -s words
for scale in 1 1,1 0,1,1 1,1,0 1,1,1,1; do
    OPTIONS="-scale $scale"
    refuses scaled.txt '-scale needs three numbers' < even.node
done
OPTIONS="-scale 1,1,1e300"
printf '0 0 1e100\n1 0 0\n0 1 0\n1 1 1\n' |
    refuses beyond.txt '-scale: point 0 is beyond'
OPTIONS=

# ---- what cannot be written is refused at once; nothing is half written ----

mkdir -p there
for place in there nowhere/file; do
    echo no points | $TESS -q -ele $place > said 2> words
    yes "-ele $place: exit code 2, before anything is read" test $? -eq 2
    yes "-ele $place: why" grep "^tess: $place: " words > /dev/null
done
echo kept > kept.vtk
cp kept.vtk kept
(trap '' XFSZ; ulimit -f 8; $TESS -vtk kept.vtk -q thin.node) > said 2> words
yes "a disk that is full: exit code 2" test $? -eq 2
yes "a disk that is full: the old file, no part of the new one" sh -c \
    'cmp kept kept.vtk && ! ls *.part' > said 2>&1
$TESS -q -node device.node flat
yes "a device is written as it is" sh -c \
    "$TESS -q -node /dev/stdout flat | cmp - device.node"

# ---- many points ----

# arrays grow to what a file needs (on the moment curve any pair of edges makes a
# tetrahedron: (n - 2) (n - 3) / 2)
awk 'BEGIN { for (i = 0; i < 1000001; i++) print i, 0, 0 }' > many
$TESS many > said 2> words
yes "1,000,001 points" grep '^points *1000001$' said > /dev/null
awk 'BEGIN { for (i = 0; i < 500; i++) print i, i * i, i * i * i }' > moment
$TESS -check moment > said 2> words
yes "tetrahedra: 248 a point" sh -c 'grep "^tetrahedra *123753$" said &&
    grep proven said' > /dev/null
# shellcheck disable=SC3045 # where there is no -v it is skipped
if (ulimit -v 40000) 2> words; then
    (ulimit -v 40000; $TESS -q moment) > said 2> words
    yes "few points take little memory" test $? -eq 0
    (ulimit -v 40000; $TESS -q many) > said 2> words
    yes "not enough memory: exit code 2" test $? -eq 2
    yes "not enough memory: one line says so" test \
        "$(cut -c1-23 words)" = "tess: not enough memory"
else
    skip "not enough memory: no ulimit -v"
fi

# it says how far it is, once by its clock, here one that runs, there are two
# seconds
printf '#include <time.h>\ntime_t tick(time_t *t);\ntime_t tick(time_t *t)
{ static time_t now; (void)t; return ++now; }\n' > tick.c
# shellcheck disable=SC2046 # a list of files
$CC -Dtime=tick -I"$TOP" -o ticking tick.c "$TOP"/test/cli/src/driver.c \
    $(objects driver) "$TOP"/build/tess.o "$TOP"/build/hhpred.o -lm
awk 'BEGIN { srand(6); for (i = 0; i < 20000; i++) print rand(), rand(), rand(),
    i }' > long
OPTIONS="-volumes long.csv -grid 50,50,50 -values long.npy -method natural"
./ticking $OPTIONS -validate 5 long > said 2> words
yes "it says how far it is" sh -c "for part in reading values cells -validate
    do grep -e \"^tess: \$part: [1-9][0-9]* %, about [0-9]* s more\$\" words ||
    exit; done" > /dev/null
yes "it says how far the mesh is" \
    grep '^tess: [1-9][0-9]* tetrahedra after ' words > /dev/null
./ticking - < long > said 2> words
yes "it says how much it has read of a pipe" \
    grep '^tess: reading: [0-9]* MB$' words > /dev/null
./ticking -q $OPTIONS long > said 2> words
yes "-q: it says nothing but of places without a value" sh -c \
    'grep -v "^tess: of 125000 places [0-9]* have no value\$" words; test $? -eq 1'
# a clock that goes from one second to the next is no second
sed 's/++now/now = 1 + (now > 0)/' tick.c > once.c
# shellcheck disable=SC2046 # a list of files
$CC -Dtime=tick -I"$TOP" -o once once.c "$TOP"/test/cli/src/driver.c \
    $(objects driver) "$TOP"/build/tess.o "$TOP"/build/hhpred.o -lm
./once $OPTIONS long > said 2> words
yes "nothing in the first second" test "$(grep -c '^tess: [1-9][0-9]* tet' words)" \
    -eq 0
OPTIONS=

# ---- make bench: a family that there is not, a small run ----

(cd "$TOP" && make bench FAMILY=nosuch CC="$CC" CFLAGS=-O0) > said 2> words
yes "make bench FAMILY=nosuch: an error" test $? -ne 0
yes "make bench FAMILY=nosuch: the families" grep -w globe words > /dev/null
(cd "$TOP" && make bench FAMILY=no/such CC="$CC" CFLAGS=-O0) > said 2> words
yes "make bench FAMILY=no/such: an error" test $? -ne 0
(cd "$TOP" && PEERS="" REPEATS=1 SIZES="50 100" FAMILY=prism CFLAGS=-O0 \
    sh test/bench/bench.sh) > said 2> words
yes "make bench: a family's rows" test \
    "$(grep -c '^| prism | [0-9]* | [0-9]* |' said)" -eq 2
yes "make bench: the load is said" grep '^Load average: [0-9.]* before, at most [0-9.]* ' \
    said > /dev/null

ended driver
