#!/bin/sh
# driver.sh - tests of build/tess: the files it reads and writes.
#
# Run from the top directory, after `make'.  Each file made here holds the same
# five points; what tess writes of them is compared with what is written here.
# Ends with `driver: N passed, M failed'.
CC=${CC:-cc}
PYTHON=${PYTHON:-python3}
TESS=`pwd`/build/tess
TOP=`pwd`
rm -rf build/driver
mkdir -p build/driver
cd build/driver || exit 1

# (to a file: behind a pipe no variable can be set)
pass() { echo "ok      $1" | tee -a results; }
fail() { echo "FAILED  $1" | tee -a results; }

# yes NAME COMMAND...: passed when it succeeds
yes() {
    name=$1
    shift
    if "$@"; then pass "$name"; else fail "$name"; fi
}

# The points, with one value, two, none; the last with a marker.
cat > none << END
5 3 0 0
0 0 0 0
1 1 0 0
2 0 1.5 0
3 0 0 -2
4 0.134 0.25 -0.5
END
awk 'NR == 1 { print "5 3 1 0" } NR > 1 { print $0, 10 * $1 }' none > one
awk 'NR == 1 { print "5 3 2 0" } NR > 1 { print $0, 10 * $1, 0.5 + $1 }' \
    none > two
awk 'NR == 1 { print "5 3 2 0" }
    NR > 1 { print NR - 2, NR - 1, $2, $3, $4, 10 * $1 }' none > wrong
awk 'NR == 1 { print "5 3 2 1" } NR > 1 { print $0, 10 * $1, 0.5 + $1, $1 % 2 }
    ' none > marked

cat > corners << END
6 3 0 0
0 0 0 0
1 1 0 0
2 0 1.5 0
3 0 0 0
4 0 0 -2
5 0.134 0.25 -0.5
END

# reads EXPECTED FILE [WORDS]: FILE (standard input when it is -) holds the
# points of EXPECTED; standard error says WORDS, or nothing.  OPTIONS are tess's.
OPTIONS=
reads() {
    cat > input
    [ "$2" = - ] || cp input "$2"
    rm -f out.node
    $TESS $OPTIONS -node out.node "$2" < input > said 2> words
    if [ $? -ne 0 ] || ! cmp -s "$1" out.node; then
        fail "$2 ($3): `cat words`"
    elif [ -n "$3" ] && ! grep -e "$3" words > /dev/null; then
        fail "$2: not said: $3"
    elif [ -z "$3" ] && [ -s words ]; then
        fail "$2: said: `cat words`"
    else
        pass "reads $2 $3"
    fi
}

# refuses FILE WORDS: exit code 2, and WORDS on standard error
refuses() {
    cat > "$1"
    rm -f out.node
    $TESS $OPTIONS -node out.node "$1" > said 2> words
    code=$?
    if [ $code -ne 2 ] || [ -f out.node ]; then
        fail "$1 ($2) is not refused: code $code"
    elif ! grep -e "$2" words > /dev/null; then
        fail "$1: not said: $2: `cat words`"
    else
        pass "refuses $1: $2"
    fi
}

# ---- lines ----

reads none plain.txt << END
# a comment
0 0 0

 1 0 0 # another
0	1.5	0
! Fortran's
0 0 -2
% Matlab's
  // C++'s
0.134 .25 -.5 ! behind a number
END
sed 's/$/\r/' plain.txt | reads none dos.txt
tr '\n' '\r' < plain.txt | reads none mac.txt
(printf '\357\273\277'; grep -v '^#' plain.txt) | reads none mark.txt
reads none - < plain.txt
reads none fortran.dat << END
 0.D0 0.D+00 0.0D0
 0.1D+01 0.00d0 0.
 0.0E+00 0.15D+1 0.0E0
 0. 0. -.2D1
 1.34D-01 2.5d-01 -5.0D-1
END
# an exponent of three digits leaves no room for its letter
printf '0 0 0\n1.5+100 0 0\n0 1 0\n0 0 1.25-101\n' > narrow.dat
$TESS -q -node out.node narrow.dat
yes "reads narrow.dat" test "`sed -n 3p out.node` `sed -n 5p out.node`" = \
    "1 1.5e+100 0 0 3 0 0 1.25e-101"

# ---- CSV ----

reads one plain.csv << END
0,0,0,0
1,0,0,10
0,1.5,0,20,
0,0,-2,30
0.134,0.25,-0.5,40
END
reads two header.csv << END
x,y,z,T (%),"wind, m/s"
0,0,0,0,0.5
1,0,0,10,1.5
0,1.5,0,20,2.5
0,0,-2,30,3.5
0.134,0.25,-0.5,40,4.5
END
sed 's/[^,]*$/"&"/' header.csv | reads two quoted.csv
tr , ';' < header.csv | reads two semicolon.csv
tr , '\t' < header.csv | sed 's/"//g' | reads two tabs.tsv
reads two pandas.csv "columns 4, 2, 5" << END
,Y [m],T,x,Z (m)
0,0,0.5,0,0
10,0,1.5,1,0
20,1.5,2.5,0,0
30,0,3.5,0,-2
40,0.25,4.5,0.134,-0.5
END
reads one paraview.csv << END
"T","Points:0","Points:1","Points:2"
0,0,0,0
10,1,0,0
20,0,1.5,0
30,0,0,-2
40,0.134,0.25,-0.5
END
reads none units.csv "x, y, z are the columns 2, 3, 4" << END
survey of the dam
station;east;north;height
;m;m;m
A1;0;0;0
A2;1;0;0
A3;0;1.5;0
A4;0;0;-2
A5;0.134;0.25;-0.5
END

# ---- a decimal comma is no separator ----

printf '0,13;0,84;0,5\n' | refuses semicolons.csv 'line 1: a decimal comma'
printf 'x;y;z\n1;2;3\n0,13;0,84;0,5\n' |
    refuses later.csv 'line 3: a decimal comma'
printf '0,13 0,84 0,5\n' | refuses blanks.txt 'a decimal comma'
printf '0,13\t0,84\t0,5\n' | refuses tabs.txt 'a decimal comma'
printf '0,13, 0,84, 0,5\n' | refuses both.txt 'a decimal comma'
printf '"0,13","0,84","0,5"\n' | refuses quotes.csv 'a decimal comma'
printf '1.234,5 2.345,6 3.456,7\n' | refuses thousands.txt 'a decimal comma'
printf '0,13,0,84,0,5\n1,13,0,84,0,5\n' > commas.csv
$TESS commas.csv > said 2> words
yes "commas alone: a warning" grep 'if commas are decimal' words > /dev/null

# ---- x, y, z elsewhere: -cols; a first column that numbers ----

reads wrong numbers.txt "column 1 is 1, 2, 3, ... and was taken for x" << END
1 0 0 0 0
2 1 0 0 10
3 0 1.5 0 20
4 0 0 -2 30
5 0.134 0.25 -0.5 40
END
awk 'NR == 1 { print "5 3 2 0" } NR > 1 { print $0, NR - 1, 10 * $1 }' none \
    > numbered
OPTIONS="-cols 2,3,4"
reads numbered chosen.txt < numbers.txt
cat > ocean.csv << END
time,Lat,lon,depth (m),temp,note
1,0,0,0,0,a
2,0,1,0,10,b
3,1.5,0,0,20,c
4,0,0,-2,30,d
5,0.25,0.134,-0.5,40,e
END
OPTIONS="-cols 3,2,4"
reads numbered columns.csv < ocean.csv
OPTIONS="-cols lon,lat,depth"
reads numbered names.csv < ocean.csv
OPTIONS="-cols lon,lat,depth,temp"
reads one values.csv < ocean.csv
OPTIONS="-cols 3,lat,4,5"
reads one both.csv < ocean.csv
OPTIONS=
reads one unnamed.csv "columns 1, 2, 3 (a, b, c); -cols chooses others" << END
a,b,c,value
0,0,0,0
1,0,0,10
0,1.5,0,20
0,0,-2,30
0.134,0.25,-0.5,40
END
# 1, 2, 3 that x is by name, or that has no values beside it, is none
printf 'x,y,z,T\n1,0,0,1\n2,3,0,1\n3,0,1,1\n4,4,4,1\n' > x.csv
$TESS x.csv > said 2> words
yes "x by name is no number" test ! -s words
OPTIONS="-cols lon,lat,height"
refuses high.csv 'line 2: -cols: no column height among 6$' < ocean.csv
OPTIONS="-cols lon,lat,depth"
refuses nameless.txt 'no column lon .*no line of names' < numbers.txt
OPTIONS="-cols 2,3,7"
refuses seventh.csv 'no column 7 among 6' < ocean.csv
OPTIONS="-cols 2,3,6"
refuses words.csv 'column 6 is not a number: a' < ocean.csv
OPTIONS="-cols 2,3,lat"
refuses twice.csv 'column lat twice' < ocean.csv
OPTIONS="-cols 2,3"
refuses two.csv '-cols needs three columns' < ocean.csv
OPTIONS="-cols 2,3,4"
refuses cols.node '-cols is for lines of numbers, not for .node' < none
OPTIONS=

# ---- numbers that are missing: -skip ----

cat > gaps.csv << END
x,y,z,T (%),"wind, m/s"
,9,9,9,9
0,0,0,0,0.5
9,9,9,,9
1,0,0,10,1.5
9,NA,9,9,9
9,9,nan,9,9
0,1.5,0,20,2.5
9,9,9,-,9
0,0,-2,30,3.5
9,9,9,"",9
0.134,0.25,-0.5,40,4.5
9,9,9,9,
9,9,9,9,N/A
END
refuses gaps1.csv 'line 4: .*-skip drops such lines' < gaps.csv
OPTIONS=-skip
reads two gaps2.csv "8 rows dropped .* the first in line 2" < gaps.csv
tr , ';' < gaps.csv | reads two gaps.txt "8 rows dropped"
sed 's/"wind, m.s"/u/' gaps.csv | tr , '\t' | reads two gaps.tsv "8 rows"
sed 1d gaps.csv | reads two bare.csv "8 rows dropped .* line 1"
sed '1d; s/,$/,NA/; s/^,/NA,/; s/,,/,NA,/; s/""/-/; s/,/ /g' gaps.csv |
    reads two blanks.txt "8 rows dropped"
reads two header.csv < header.csv
(echo 13; sed '1d' gaps.csv) | reads two counted.csv "8 rows"
reads none gaps.xyz "1 row dropped .* the first in line 5" << END
6
a comment
C 0 0 0
H 1 0 0
H 0 - 0
H 0 1.5 0
O 0 0 -2
Fe 0.134 0.25 -0.5
END
# a column without a number that is not asked for
sed '/^9/d; /^,/d; 1s/$/,note/; 2,$s/$/,/' gaps.csv > hollow.csv
refuses hollow1.csv 'drops all 5 rows; name the columns' < hollow.csv
OPTIONS="-skip -cols 1,2,3,4"
reads one hollow2.csv < hollow.csv
OPTIONS=

# ---- .xyz, counts, Qhull ----

reads none atoms.xyz "column 1 (C) is not a number" << END
5
a comment, 1,5 Angstrom
C 0 0 0
H 1 0 0
H 0 1.5 0
O 0 0 -2
Fe 0.134 0.25 -0.5
END
sed '2s/.*//' atoms.xyz | reads none blank.xyz "column 1 (C)"
sed '2s/.*/7/' atoms.xyz | reads none seven.xyz "column 1 (C)"
sed '2s/.*/step 1 2 3/' atoms.xyz | reads none step.xyz "column 1 (step)"
sed '2s/.*/X 1 2 3/' atoms.xyz | reads none row.xyz "column 1 (X)"
(cat atoms.xyz; cat atoms.xyz) |
    reads none frames.xyz "line 8: more than the 5 points announced"
# no element, and a comment that looks like a point, or is one
sed 's/^[A-Z][a-z]* //; 2s/.*/9 9 9/' atoms.xyz | reads none bare.xyz
(cat bare.xyz; cat bare.xyz) | reads none frames.txt "more than the 5 points"
sed 2d bare.xyz | reads none count.txt
sed '1s/.*/5 points/; 2s/.*//' bare.xyz | reads none points.txt
sed '1s/.*/3 rbox 5 D3 s/; 2s/.*/5/' bare.xyz | reads none qhull.txt
sed '1s/.*/5/; 2s/.*/3/' bare.xyz | reads none reversed.txt
sed '1s/.*/3 5/; 2d' bare.xyz | reads none oneline.txt
printf '3\n1\nH 0 0 0\nH 0 0 1\nO 1 0 0\n' > three.xyz
$TESS three.xyz > said 2> words
yes "an .xyz file of 3 atoms is none of Qhull's" grep '^points *3$' said \
    > /dev/null

# ---- OFF, PLY, OBJ, PDB, .node ----

reads none mesh.off << END
OFF
5 2 0
0 0 0
1 0 0
0 1.5 0
0 0 -2
0.134 0.25 -0.5
3 0 1 2
3 0 1 4
END
sed '1d; 2s/^/OFF /' mesh.off | reads none - 
reads two mesh.ply << END
ply
format ascii 1.0
comment made by hand
element vertex 5
property float T
property float x
property float y
property float z
property uchar red
element face 1
property list uchar int vertex_index
end_header
0 0 0 0 0.5
10 1 0 0 1.5
20 0 1.5 0 2.5
30 0 0 -2 3.5
40 0.134 0.25 -0.5 4.5
3 0 1 2
END
reads none mesh.obj "column 1 (v)" << END
# a surface
mtllib none
o thing
v 0 0 0
v 1 0 0
v 0 1.5 0
vn 1 1 1
v 0 0 -2
v 0.134 0.25 -0.5
f 1 2 3
END
reads one 1abc.pdb "the first model" << END
HEADER    A MOLECULE
REMARK   2 RESOLUTION.    1.90 ANGSTROMS.
MODEL        1
ATOM      1  N   LYS A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  CA  LYS A   1       1.000   0.000   0.000  1.00 10.00           C
ANISOU    2  CA  LYS A   1     1111   2222   3333      0      0      0       C
ATOM      3  C   LYS A   1       0.000   1.500   0.000  1.00 20.00           C
TER
HETATM    4 FE   HEM A 200       0.000   0.000  -2.000  1.00 30.00          FE
HETATM    5  O   HOH A 201       0.134   0.250  -0.500  0.50 40.00           O
ENDMDL
MODEL        2
ATOM      1  N   LYS A   1       9.000   0.000   0.000  1.00  0.00           N
ENDMDL
END
reads corners mesh.stl "column 1 (vertex)" << END
solid made by hand
 facet normal 0 0 1
  outer loop
   vertex 0 0 0
   vertex 1 0 0
   vertex 0 1.5 0
  endloop
 endfacet
 facet normal 1 0 0
  outer loop
   vertex 0.0E+00 0 0
   vertex 0 0 -2
   vertex 0.134 0.25 -0.5
  endloop
 endfacet
endsolid
END
for f in none one two marked; do
    reads $f $f.node < $f
done
awk 'NR > 1 { $1++ } { print }' marked > marked1
reads marked1 from1.node < marked1

# ---- what is no file of points ----

printf '' | refuses empty.txt empty
printf '\n# nothing\n' | refuses comment.txt empty
printf 'x,y,z\n' | refuses header.txt 'before the first point'
printf '0 3 0 0\n' | refuses empty.node 'no points'
printf '1 2\n3 4\n' | refuses plane.txt 'line 1: fewer than three numbers'
printf '1 2 3\n1 2\n' | refuses short.txt 'line 2: 2 columns, but line 1 has 3'
printf '1 2 3\n1 x 3\n' | refuses word.txt 'line 2: column 2 is not a number: x'
printf '1,2,3,4\n1,2,3,\n' | refuses missing.csv 'line 2: 3 columns'
printf '1,2,3,4,5\n1,2,3,,5\n' | refuses hole.csv 'line 2: column 4'
printf '9\n1 2 3\n4 5 6\n' | refuses few.txt 'ends after 2 of 9'
printf 'ply\nformat binary_little_endian 1.0\n' | refuses binary.ply binary
printf '2024-11 1 2 3\n2024-12 4 5\n' | refuses dates.txt 'line 2: 3 columns'
printf '1 2 nan\n' | refuses nan.txt 'line 1: point 0 .*not finite'
printf '1 2 3\n4 5 1D400\n' | refuses huge.txt 'line 2: point 1 .*not finite'
printf '\377\3761\000 \000' | refuses wide.txt UTF-16
gzip < none.node | refuses none.xyz.gz 'compressed by gzip'
gzip < none.node | refuses none.node 'compressed by gzip'
cp none none.node
printf 'PK\003\004...' | refuses table.xlsx 'a zip archive'
(printf '%-80s\002\000\000\000' solid; printf '%100s' '') |
    refuses part.stl 'binary STL'
(printf '%-80s\002\000\000\000' part; printf '%100s' '') |
    refuses part.STL 'binary STL; save it as ASCII'
printf '0\000' | refuses zero.dat 'is not text'
$TESS -node none.node none.node > said 2> words
yes "the input is not overwritten" test $? -eq 2
$TESS -node x -ele x none.node > said 2> words
yes "two outputs of one name" test $? -eq 2

# ---- what is written ----

# -o, `make run': a name for each input
$TESS -q -o base none.node
yes "-o: four files" test -s base.node -a -s base.ele -a -s base.neigh -a \
    -s base.vtk
(cd "$TOP" && for f in x.csv x.xyz; do
    cp build/driver/plain.csv build/driver/$f
    make run POINTS=build/driver/$f
done
make run POINTS=- < build/driver/plain.csv) > said 2>&1
yes "make run: names that do not collide" test -s ../x.csv.svg -a \
    -s ../x.xyz.svg -a -s ../stdin.svg
rm -f ../x.csv.* ../x.xyz.* ../stdin.*

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
$TESS -q -face flat.face flat
yes "-face of points in a plane: none" test "`cat flat.face`" = "0 0"

# VTK files, read by others: points, tetrahedra, values, in both forms
cat > read.py << END
import sys
def numbers(name):
    return [[float(x) for x in l.split()][1:] for l in open(name)
            if l[0] != '#'][1:]
if sys.argv[1] == 'meshio':
    import meshio
    def read(name):
        m = meshio.read(name)
        return (m.points, m.cells[0].data, [v.ravel() for v in
                m.point_data.values()], list(m.point_data))
else:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy as array
    def read(name):
        r = vtk.vtkUnstructuredGridReader()
        r.SetFileName(name)
        r.ReadAllScalarsOn()
        r.Update()
        m = r.GetOutput()
        d = m.GetPointData()
        all = range(d.GetNumberOfArrays())
        return (array(m.GetPoints().GetData()),
                array(m.GetCells().GetConnectivityArray()).reshape(-1, 4),
                [array(d.GetArray(i)) for i in all],
                [d.GetArrayName(i) for i in all])
node = numbers('v.node')
ele = numbers('v.ele')
base = min(min(e) for e in ele)
for name in sys.argv[2:]:
    p, t, v, names = read(name)
    assert [list(a) for a in p] == [r[:3] for r in node]
    assert [list(a) for a in t] == [[int(x - base) for x in r] for r in ele]
    assert [list(a) for a in zip(*v)] == [r[3:] for r in node], v
    assert names == ['value', 'value2', 'marker'], names
END
awk 'BEGIN { srand(1); print 60, 3, 2, 1
    for (i = 1; i <= 60; i++)
        print i, rand(), rand() * 1e-7, rand() * 1e9, rand() - 0.5, i, -i }' \
    > v0.node
$TESS -q -node v.node -ele v.ele -vtk v.vtk v0.node
$TESS -q -vtk vb.vtk -binary v0.node
yes "a .node file written is read again as it was" sh -c \
    "$TESS -q -node v2.node v.node && cmp v.node v2.node"
for reader in meshio vtk; do
    if $PYTHON -c "import $reader" 2> words; then
        yes "VTK, ASCII, read by $reader" $PYTHON read.py $reader v.vtk
        yes "VTK, binary, read by $reader" $PYTHON read.py $reader vb.vtk
    else
        echo "        skipped: VTK files: no $reader for $PYTHON"
    fi
done

# ---- pictures ----

$TESS -q -svg a.svg -view 20 70 v0.node && $TESS -q -svg b.svg v0.node
yes "-view" sh -c '! cmp -s a.svg b.svg'
$TESS -q -svg c.svg -view -68 28 v0.node
yes "-view, as if not given" cmp b.svg c.svg
yes "the name of a value" grep '>value<' b.svg > /dev/null
$TESS -q -svg c.svg none.node
yes "colours that are no value" grep 'coloured by distance' c.svg > /dev/null
for o in -O0 -O2; do
    $CC $o -I"$TOP" -o picture "$TOP"/test/program/picture.c \
        "$TOP"/test/program/draw.c \
        "$TOP"/tess.c "$TOP"/hhpred.c -lm
    ./picture "$TOP"/test/data/mirror.xyz m$o.svg s$o.svg c$o.svg > said
done
yes "pictures: the same bytes" sh -c 'cmp m-O0.svg m-O2.svg && cmp c-O0.svg c-O2.svg'

# ---- Voronoi cells: their volumes sum to the box's; faces by Euler ----

awk 'BEGIN { srand(7); for (i = 0; i < 500; i++) print rand(), rand(), rand()
    for (i = 0; i < 64; i++) print i % 4, int(i / 4) % 4, int(i / 16) }' > some
$TESS -q -cells cells.vtk some
yes "-cells: as many as points, and they fill the box" awk '
    /^CELLS/ { n = $2; cells = 1; next }
    /^CELL_TYPES/ { cells = 0; types = 1; next }
    /^CELL_DATA/ { types = 0 }
    cells { seen++; if (NF != $1 + 1) bad = 1
        at = 3; delete known; corners = points = 0
        for (f = 0; f < $2; f++) {
            corners += $at
            for (k = 1; k <= $at; k++)
                if (!($(at + k) in known)) { known[$(at + k)] = 1; points++ }
            at += $at + 1 }
        if (2 * (points + $2) != 4 + corners) bad = 1 }
    types && $1 != 42 { bad = 1 }
    /^SCALARS volume/ { getline; while ((getline v) > 0) sum += v }
    END { d = sum - 27; exit bad || seen != n || n != 564 ||
        d > 1e-11 || d < -1e-11 }' cells.vtk

# ---- many points ----

if (cd "$TOP" && make MAXPTS=10 CC="$CC") > said 2>&1; then
    awk 'BEGIN { for (i = 0; i < 11; i++) print i, i * i, i * i * i }' > many
    $TESS many > said 2> words
    yes "more points than there is room for" test $? -eq 1
    yes "what to do then" grep 'make MAXPTS=40' words > /dev/null
else
    fail "make MAXPTS=10: `tail -n 1 said`"
fi
if (cd "$TOP" && make MAXPTS=10000000 CC="$CC") > said 2>&1; then
    yes "make MAXPTS=10000000" $TESS -q -check many
else
    fail "make MAXPTS=10000000: `tail -n 1 said`"
fi
(cd "$TOP" && make CC="$CC") > said 2>&1

# after a second: a set that takes several
awk 'BEGIN { srand(2); c = cos(0.5); s = sin(0.5)
    for (i = 0; i < 60000; i++) {
        x = rand() - 0.5; y = rand() - 0.5; z = rand() - 0.5
        r = 1 / sqrt(x * x + y * y + z * z); x *= r; y *= r; z *= r
        printf "%.17g %.17g %.17g\n", x, y, z } }' > slow
$TESS slow > said 2> words
if awk '/^seconds/ { exit !($2 > 3) }' said; then
    yes "it says how far it is" grep 'tetrahedra after' words > /dev/null
else
    echo "        skipped: what it says after a second: too fast"
fi

# ---- make bench: a family that there is not, a small run ----

(cd "$TOP" && make bench FAMILY=nosuch CC="$CC" CFLAGS=-O0) > said 2> words
yes "make bench FAMILY=nosuch: an error" test $? -ne 0
yes "make bench FAMILY=nosuch: the families" grep -w globe words > /dev/null
(cd "$TOP" && make bench FAMILY=no/such CC="$CC" CFLAGS=-O0) > said 2> words
yes "make bench FAMILY=no/such: an error" test $? -ne 0
(cd "$TOP" && PEERS= REPEATS=1 SIZES="50 100" FAMILY=prism CFLAGS=-O0 \
    sh test/bench/bench.sh) > said 2> words
yes "make bench: a family's rows" test `grep -c '^| prism | [0-9]* | [0-9]* |' \
    said` -eq 2
yes "make bench: the load is said" grep '^Load average: [0-9.]* before, at most [0-9.]* ' \
    said > /dev/null

failed=`grep -c '^FAILED' results`
echo "driver: `grep -c '^ok' results` passed, $failed failed"
test $failed -eq 0
