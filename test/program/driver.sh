#!/bin/sh
# driver.sh - tests of build/tess: the files it reads and writes.
#
# Run from the top directory, after `make'.  Each file made here holds the same
# five points; what tess writes of them is compared with what is written here.
# Ends with `driver: N passed, M failed'.
. test/tests.sh
begin driver
TOP=$(pwd)
TESS=$TOP/build/tess
rm -rf build/driver
mkdir -p build/driver
cd build/driver || exit 1

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
sed '2,$s/[^,]*$/"&"/' header.csv | reads two quoted.csv
tr , ';' < header.csv | reads two semicolon.csv
sed 's/, m/ m/; s/"//g' header.csv | tr , '\t' | reads two tabs.tsv
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

# ---- a decimal comma is no separator: the cell is named ----

comma='a decimal comma?  -decimal , reads it'
printf '0,13;0,84;0,5\n' |
    refuses semicolons.csv ":1: column 1: .0,13.: not a number ($comma"
printf 'x;y;z\n1;2;3\n0;0,84;0,5\n' |
    refuses later.csv ":3: column 2, y: .0,84.: not a number ($comma"
printf '0,13 0,84 0,5\n' | refuses blanks.txt ":1: column 1: .0,13.: not a number ($comma"
printf '0,13\t0,84\t0,5\n' | refuses tabs.txt ":1: column 1: .0,13.: not a number ($comma"
printf '0,13, 0,84, 0,5\n' |
    refuses both.txt ":1: .0,13, 0,84.*with and without a blank behind ($comma"
printf '"0,13","0,84","0,5"\n' |
    refuses quotes.csv ":1: column 1: .0,13.: not a number ($comma"
printf '1.234,5 2.345,6 3.456,7\n' |
    refuses points.txt ":1: column 1: .1.234,5.: not a number ($comma"
printf '0,13,0,84,0,5\n1,13,0,84,0,5\n' > commas.csv
$TESS commas.csv > said 2> words
yes "commas alone: a warning" grep 'if commas are decimal' words > /dev/null
# what is no decimal comma is not called so
for row in '1,2,4,5 m/column 4, T: .5 m.: not a number (a unit' \
    '1,2,4,"1,000"/column 4, T: .1,000.: not a number (a comma between thou' \
    '1,2,"12,345,678",4/column 3, z: .12,345,678.: not a number (commas between thou' \
    '1,2,4,"1,234.5"/column 4, T: .1,234.5.: not a number (commas between t' \
    '1,2 m,3,4/column 2, y: .2 m.: not a number'; do
    printf 'x,y,z,T\n1,2,3,4\n%s\n' "${row%/*}" |
        refuses cell.csv ":3: ${row##*/}"
    yes "no word of decimals" sh -c '! grep "decimal comma" words' > /dev/null
done
printf '1,234.5 2,345.6 3,456.7\n' |
    refuses thousands.txt ':1: column 1: .1,234.5.: not a number (commas between thousands'
printf 'x,y,z\n5 m,6,7\n8,9,10\n' |
    refuses unit.csv ':2: column 1, x: .5 m.: not a number'
printf '5 m,6 m,7 m\n8 m,9 m,10 m\n' |
    refuses units.txt ':1: fewer than three numbers'
OPTIONS="-cols 1,2,3,4"
printf '1,2,3,12.5 m\n' | refuses asked.csv 'column 4: .12.5 m.: not a number'
OPTIONS=
awk 'NR > 1 { print "2024-01-31 10:30," $2 "," $3 "," $4 }' none |
    reads none times.csv 'column 1 (2024-01-31 10:30) is not a number'
printf 'x,y,z\n1,here,3\n4,5,6\n' |
    refuses here.csv ':2: column 2, y: .here.: not a number'

# ---- -decimal ,: it is read, with something else between columns ----

OPTIONS="-decimal ,"
sed 's/,/;/g; s/\./,/g' plain.csv | reads one semicolons.csv
sed 's/,/\t/g; s/\./,/g' plain.csv | reads one tabs.txt
sed 's/,/ /g; s/\./,/g' plain.csv | reads one blanks.txt
sed 's/,/, /g; s/\([0-9]\)\.\([0-9]\)/\1,\2/g' plain.csv | reads one both.txt
sed 's/,$//; s/[^,]*/"&"/g; s/\./,/g' plain.csv | reads one quotes.csv
# in quotes where there is one, else whole numbers
sed '1s/^0/0.0/; s/[-0-9]*\.[0-9]*/"&"/g; s/\./,/g' plain.csv |
    reads one partly.csv
(echo 7,7,7,7; cat partly.csv) > whole.csv
$TESS $OPTIONS -q -node out.node whole.csv
yes "commas outside quotes separate, in any line" test \
    "`sed -n 2p out.node`" = "0 7 7 7 7"
sed 's/\./,/g' semicolon.csv | reads two german.csv
sed 's/^/31.12.2024;/; 1s/.*;x/date;x/' german.csv |
    reads two dates.csv 'column 1 (31.12.2024) is not a number: skipped'
reads one exponents.csv << END
0;0;0;0
10e-1;0;0;1E1
0;1,5D0;0;20
0;0;-,2e1;30
,134;0,25;-,5;40
END
points='(with -decimal , numbers have no points)'
printf '1;2;3\n1,5;2.5;3\n' |
    refuses point.csv ":2: column 2: .2.5.: not a number $points"
printf '1.234,5;2;3\n' |
    refuses grouped.csv ":1: column 1: .1.234,5.: not a number $points"
refuses alone.txt 'column 1: .*commas between digits are decimal' < commas.csv
OPTIONS="-decimal ;"
refuses sign.csv '-decimal needs the sign' < commas.csv
OPTIONS="-decimal ."
reads one point2.csv < plain.csv
OPTIONS=

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
# also where some have another name
for names in x,y,v x,q,z q,y,z; do
    says="columns 1, 2, 3 ($(echo $names | sed 's/,/, /g')); -cols chooses others"
    [ $names = x,y,v ] && says="$says; if they are in a plane: -plane"
    awk -v n=$names 'NR == 1 { print n } NR > 1 { print $2 "," $3 "," $4 }' none |
        reads none named.csv "$says\$"
done
awk 'NR == 1 { print "x,y,level,T" } NR > 1 { print $2 "," $3 "," $4 "," $5 }' \
    one > level.csv
reads one named.csv 'columns 1, 2, 3 (x, y, level); -cols chooses others$' \
    < level.csv
$TESS -query level.csv -values v.csv level.csv > said 2> words
yes "-query: where its coordinates are" grep \
    'level); -qcols chooses others; if they are in a plane: -qcols X,Y$' words \
    > /dev/null
# names that are not the columns'
sed 's/,[^,]*$//; 1s/$/,T,u/' level.csv |
    reads none fewer.csv ':1: its names, which are not as many as columns, are'
# 1, 2, 3 that x is by name, or that has no values beside it, is none
printf 'x,y,z,T\n1,0,0,1\n2,3,0,1\n3,0,1,1\n4,4,4,1\n' > x.csv
$TESS x.csv > said 2> words
yes "x by name is no number" test ! -s words
OPTIONS="-cols lon,lat,height"
refuses high.csv ':2: -cols: no column height among 6$' < ocean.csv
OPTIONS="-cols lon,lat,depth"
refuses nameless.txt 'no column lon .*no line of names' < numbers.txt
OPTIONS="-cols 2,3,7"
refuses seventh.csv 'no column 7 among 6' < ocean.csv
OPTIONS="-cols 2,3,6"
refuses words.csv 'column 6, note: .a.: not a number' < ocean.csv
OPTIONS="-cols 2,3,lat"
refuses twice.csv 'column lat twice' < ocean.csv
OPTIONS="-cols 2,3"
refuses two.csv '-cols: points in a plane have no tetrahedra' < ocean.csv
OPTIONS="-cols 2,3,4"
reads none cols.node < none
OPTIONS="-cols z,y,x"
$TESS -q $OPTIONS -node out.node cols.node
yes "-cols: names in any format" test "`sed -n 6p out.node`" = "4 -0.5 0.25 0.134"
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
refuses gaps1.csv ':2: column 1.*: empty (-skip' < gaps.csv
sed 2d gaps.csv | refuses gaps4.csv ':3: column 4.*: empty; so is 1 more, to line 10 (-skip'
sed '2d; s/9,9,9,,9/9,9,9,NA,9/' gaps.csv |
    refuses gaps5.csv ':3: .*-skip drops such lines'
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
reads two hollow1.csv 'column 6 (empty) is not a number: skipped' < hollow.csv
OPTIONS="-skip -cols 1,2,3,4"
reads one hollow2.csv < hollow.csv
OPTIONS=

# ---- values that stand for a missing one: -nodata ----

cat > voids.csv << END
x,y,z,T,u
0,0,0,0,0.5
9,9,9,-9999,1
1,0,0,10,1.5
9,9,9,7,-9999.00
0,1.5,0,20,2.5
9,9,9,-9.999E3,-9999
0,0,-2,30,3.5
0.134,0.25,-0.5,40,4.5
END
fewer='fewer if -cols X,Y,Z,VALUE asks for one'
OPTIONS="-nodata -9999"
reads two voids1.csv "3 rows dropped .* the first in line 3; $fewer" < voids.csv
sed 1d voids.csv | reads two voids.txt '3 rows dropped .* line 2'
OPTIONS="-nodata -9999 -cols x,y,z,T"
sed 5d voids.csv | reads one voids2.csv '2 rows dropped .* the first in line 3$'
OPTIONS="-nodata -1,7,99,-9999"
sed 's/^9.*1$/9,9,9,-1,3/; s/^9.*-9999$/9,9,9,7,5/' voids.csv |
    reads two voids3.csv '3 rows dropped'
OPTIONS="-nodata -9999 -decimal ,"
sed 's/,/;/g; s/\./,/g' voids.csv | reads two voids4.csv '3 rows dropped'
OPTIONS="-nodata -9999"
reads one never.csv 'nothing is such a number' < plain.csv
(sed 's/^1/-9999/; 2q' plain.csv; sed 1d plain.csv) | reads one moved.csv \
    '1 row dropped .*1 by -nodata), the first in line 2'
OPTIONS="-nodata 0,10,20,30,40"
refuses all.csv 'no points: -nodata drops all 5 rows' < plain.csv
for value in x 1, nan; do
    OPTIONS="-nodata $value"
    refuses value.csv '-nodata: .*: not a number' < plain.csv
done
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
sed '2s/.*/step 1 2 3/' atoms.xyz | reads none step.xyz ":2: is a comment, as the name"
sed '2s/.*/X 1 2 3/' atoms.xyz | reads none row.xyz ":2: is a comment, as the name"
(cat atoms.xyz; cat atoms.xyz) |
    reads none frames.xyz ":8: its further frames are left out: 7 lines"
# no element, and a comment that looks like a point, or is one
sed 's/^[A-Z][a-z]* //; 2s/.*/9 9 9/' atoms.xyz |
    reads none bare.xyz ":2: is a comment, as the name's .xyz says"
(cat bare.xyz; cat bare.xyz) | reads none frames2.xyz "further frames"
# (by any other name a count is one of all the lines)
refuses bare.txt ":7: one more line of numbers than the 5 points" < bare.xyz
sed 2d bare.xyz | reads none count.txt
sed '1s/.*/5 points/; 2s/.*//' bare.xyz | reads none points.txt
sed '1s/.*/3 rbox 5 D3 s/; 2s/.*/5/' bare.xyz | reads none qhull.txt
sed '1s/.*/5/; 2s/.*/3/' bare.xyz | reads none reversed.txt
sed '1s/.*/3 5/; 2d' bare.xyz | reads none oneline.txt
printf '3\n1\nH 0 0 0\nH 0 0 1\nO 1 0 0\n' > three.xyz
$TESS three.xyz > said 2> words
yes "an .xyz file of 3 atoms is none of Qhull's" grep '^points *3$' said \
    > /dev/null

# extended .xyz: which columns, and a box
reads two more.xyz 'column 2 (C) is not a number' << END
5
Properties=T:R:1:species:S:1:pos:R:3:u:R:1 Lattice="9 0 0 0 9 0 0 0 9"
 0 C 0 0 0 0.5
10 H 1 0 0 1.5
20 H 0 1.5 0 2.5
30 O 0 0 -2 3.5
40 Fe 0.134 0.25 -0.5 4.5
END
sed '2s/Prop[^ ]*/time=1/; s/^ *[0-9]*0 \([A-Z]\)/\1/; s/ [0-9].5$//' more.xyz |
    reads none lattice.xyz 'column 1 (C) is not a number'
sed 's/9 0 0 0 9 0/9 0 0 0 nine/' more.xyz |
    refuses vectors.xyz ':2: Lattice needs 9 numbers'
sed 's/pos:R:3/pos:R/' more.xyz |
    refuses properties.xyz ':2: Properties are not as species:S:1:pos:R:3'
$TESS -volumes v.csv more.xyz > said 2> words
yes "Lattice: the box of the cells" grep "the box's is 729" said > /dev/null
sed 's/9 0 0 0 9/0 9 0 9 0/; s/0 0 9"/0 0 -9" Origin="-1 -2 7"/' more.xyz \
    > turned.xyz
$TESS -periodic -volumes v.csv turned.xyz > said 2> words
yes "Lattice: vectors along other axes, an origin" sh -c \
    "grep 'sum to 729; the box.s is 729' said && ! grep outside words" > /dev/null
yes "species go with the cells" test "$(sed 's/.*,//' v.csv | tr '\n' ' ')" = \
    "species C H H O Fe "
yes "species are not skipped" sh -c '! grep skipped words' > /dev/null
sed 's/Lattice=.*/Lattice=[[9,0,0],[0,9,0],[0,0,9]]/' more.xyz > nested.xyz
$TESS -volumes v.csv nested.xyz > said 2> words
yes "Lattice: in brackets" grep "the box's is 729" said > /dev/null
sed 's/Lattice="9 0/Lattice="9 1/' more.xyz > skew.xyz
$TESS -volumes v.csv skew.xyz > said 2> words
yes "Lattice: a skew one clips no cells" grep 'not a box along x, y, z' words \
    > /dev/null
$TESS -periodic -volumes v.csv skew.xyz > said 2> words
yes "Lattice: a skew one" grep "sum to 729; the box's is 729\$" said > /dev/null
sed 's/9 0 0 0 9 0/9 0 0 9 0 0/' more.xyz > none.xyz
$TESS -periodic none.xyz > said 2> words
yes "Lattice: vectors that span nothing" test $? -eq 2
yes "Lattice: why" grep 'vectors are in a plane' words > /dev/null

for pbc in '"T T F"' '[True, False, True]' '"1 0 1"' F; do
    sed "2s/\$/ pbc=$pbc/" more.xyz > slab.xyz
    rm -f v.csv
    $TESS -q -periodic -box 0,9,0,9,0,9 -volumes v.csv slab.xyz > said 2> words
    yes "pbc=$pbc: not as a box" test $? -eq 2 -a ! -f v.csv
    yes "pbc=$pbc: why" grep 'its pbc says' words > /dev/null
    yes "pbc=$pbc: a box as others are" $TESS -q -volumes v.csv slab.xyz 2> words
done
for pbc in '"T T T"' '[True, True, True]' '"1 1 1"' T; do
    sed "2s/\$/ pbc=$pbc foo=0/" more.xyz > bulk.xyz
    yes "pbc=$pbc" $TESS -q -periodic -volumes v.csv bulk.xyz 2> words
done

# ---- plain lines are read at once, all others field by field: the same ----

awk 'BEGIN { srand(3)
    for (i = 0; i < 4000; i++)
        printf "%.17g,%.3f,-%g,%d\n", rand() * 1e9, rand(), rand() * 1e-9, i
    }' > quick.csv
sed 's/$/ # slow/' quick.csv > slow.csv
$TESS -q -node slow.node slow.csv
for how in 's/x/x/' 's/,/, /g' 's/,/;/g' 's/,/ /g' 's/,/	/g' 's/$/\r/' \
    's/^/  /; s/$/  /' '5s/$/ # one/; 9s/$/,/' 's/,/ ,/' '$s/$/ # last/'; do
    sed "$how" quick.csv > asked.csv
    $TESS -q -node quick.node asked.csv
    yes "lines after $how" cmp slow.node quick.node
done
# words, too: of one column, of one that is not asked for, with tabs and blanks
for how in 's/,/,2024-01-31T12:00:00Z,/' 's/^/A-1,/' 's/$/,a b/' 's/^/A 1;/' \
    's/,/	/g; s/^/A1	/' 's/,/ /g; s/^/A1 /' 's/,/	/g; s/^/A 1	/'; do
    sed "$how; s/;/,/g" quick.csv > asked.csv
    $TESS -q -node quick.node asked.csv
    yes "lines after $how" cmp slow.node quick.node
done
# words and numbers in one column: either way round
sed '1s/^/a,/; 2,$s/^/7,/' quick.csv |
    refuses asked.csv ':1: column 1: .a.: not a number'
sed '1,3999s/^/a,/; 4000s/^/7,/' quick.csv |
    refuses asked.csv ':4000: column 1: .7.: a number among words'
sed 's/^/7,/' quick.csv > asked.csv
$TESS -q -cols 2,3,4,5 -node quick.node asked.csv
yes "lines with a number that is not asked for" cmp slow.node quick.node
printf '1,2,3,4\n1,5, 2,5\n' |
    refuses mixed.csv ":2: .1,5, 2,5.: commas with and without a blank.*($comma"
printf '1,2,3\n\t1,2,4,5\n' | refuses tabbed.csv ':2: 4 columns'
printf '1 2 3\n1 2 3 4\n' | refuses fourth.txt ':2: 4 columns'
printf '1 2 3\n1 2 3x\n' | refuses glued.txt ':2: column 3: .3x.: not a number'

# ---- OFF, PLY, OBJ, PDB, .node ----

reads none mesh.off "its faces are left out" << END
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
sed '1d; 2s/^/OFF /' mesh.off | reads none - "its faces are left out"
sed '2s/2/0/; 8,$d' mesh.off | reads none bare.off
reads two mesh.ply "its faces are left out" << END
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
reads none mesh.obj "its faces are left out" << END
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
reads one 1abc.pdb "other models are left out: 2 lines" << END
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
reads one 1abc.ent "other models" < 1abc.pdb
reads corners mesh.stl "its faces are left out" << END
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
yes "STL: nothing else is said" test "$(wc -l < words)" -eq 1
grep -v '^[fmo]' mesh.obj | grep -v vn | reads none bare.obj
# what tess writes, but does not read
for f in m.vtk m.vtu m.msh; do
    $TESS -q -mesh $f plain.csv
    refuses unread "is not read: numpy.savetxt.*meshio.read" < $f
done
sed '/^[mo]/d' mesh.obj | reads none - 'its faces are left out'
# a column may have the name that such a file begins with
awk 'NR == 1 { print "5 3 1 0" } NR > 1 { print $0, 7 }' none > seven
for word in v o ply solid OFF CUTOFF HEADER 'MODEL ' data_a '"v"' '"ply"'; do
    for mark in ',' ';' '\t' ' '; do
        # (in a PDB file blanks follow)
        case $mark$word in ' HEADER' | ' MODEL ') continue;; esac
        awk -v w="$word" 'NR == 1 { print w ";x;y;z" }
            NR > 1 { print "7;" $2 ";" $3 ";" $4 }' none | tr ';' "$mark" > named
        reads seven named.csv < named
        reads seven - < named
    done
done
# CRYST1: the box that repeats itself, no other
crystal() {
    printf 'CRYST1%9s%9s%9s%7s%7s%7s %-11s\n' "$@"
    grep HETATM 1abc.pdb
    sed -n '/ATOM/p; 6q' 1abc.pdb
}
crystal 6.000 7.000 8.000 90.00 90.00 90.00 'P 1' > cell.pdb
$TESS -periodic -volumes v.csv cell.pdb > said 2> words
yes "CRYST1: the periodic box" sh -c \
    'grep "sum to 336; the box.s is 336$" said && ! grep group words' \
    > /dev/null
$TESS -volumes v.csv cell.pdb > said 2> words
yes "CRYST1: cuts no cells" grep "the box's is 0.5\$" said > /dev/null
yes "PDB: the atoms' names" test "$(sed 's/.*,//' v.csv | tr '\n' ' ')" = \
    "name FE O N CA "
crystal 6.000 7.000 8.000 90.00 90.00 90.00 'P 21 21 2' > cell.pdb
$TESS -periodic -volumes v.csv cell.pdb > said 2> words
yes "CRYST1: a group of symmetries is said" grep 'P 21 21 2' words > /dev/null
crystal 6.000 7.000 8.000 90.00 102.50 90.00 'P 1' > cell.pdb
$TESS -periodic -volumes v.csv cell.pdb > said 2> words
yes "CRYST1: no right angles" $PYTHON -c 'import math
said = [l for l in open("said") if l.startswith("cells")][0].split()
whole = 336 * math.sin(math.radians(102.5))
assert abs(float(said[6][:-1]) / whole - 1) < 1e-12
assert abs(float(said[10]) / whole - 1) < 1e-12'
crystal 6.000 7.000 8.000 10.00 90.00 120.00 'P 1' > cell.pdb
$TESS -periodic cell.pdb > said 2> words
yes "CRYST1: angles of nothing" grep 'the angles are none' words > /dev/null
crystal 1.000 1.000 1.000 90.00 90.00 90.00 'P 1' > cell.pdb
$TESS -periodic -volumes v.csv cell.pdb > said 2> words
yes "CRYST1 of no crystal" grep 'needs -box' words > /dev/null
for f in none one two marked; do
    reads $f $f.node < $f
done
awk 'NR > 1 { $1++ } { print }' marked > marked1
reads marked1 from1.node < marked1
OPTIONS="-nodata -9999"
awk 'NR == 1 { print 7, 3, 2, 1; next }
    NR == 4 { print n++, 9, 9, 9, 0, -9999, 1 }
    { $1 = n++; print } END { print n, 9, 9, 9, -9999, 0, 1 }' marked > voids
reads marked voids.node '2 rows dropped .* the first in line 4; ' < voids
OPTIONS="-nodata 99.99"
sed '5p; 5s/ 0.000/ 9.000/; 5s/10.00/99.99/' 1abc.pdb |
    reads one 2abc.pdb '1 row dropped .* the first in line 6'
OPTIONS=

# ---- binary PLY, STL, .npy, by NumPy and meshio ----

cat > packed.py << END
import os, struct, subprocess, sys
import meshio
import numpy as np
random = np.random.default_rng(1)
p = random.random((50, 5)) * (1, 2, 3, 100, -7)
def tess(name, *options):
    done = subprocess.run([sys.argv[1], '-q', '-node', 'p.node', *options,
                           name], stderr=subprocess.PIPE, text=True)
    if done.returncode: return done.stderr
    return np.array([l.split()[1:] for l in open('p.node')][1:], float)
def same(a, b): return a.shape == b.shape and (a == b).all()
for kind in ('<f8 >f8 <f4 >f4 i1 u1 <i2 >i2 <u2 >u2 <i4 >i4 <u4 >u4 <i8 >i8'
             ' <u8 >u8').split():
    a = p.astype(kind) if 'f' in kind else random.integers(
        -99 * ('i' in kind), 99, p.shape).astype(kind)
    np.save('p.npy', a)
    assert same(tess('p.npy'), a.astype(float)), kind
with open('p.npy', 'wb') as f: np.lib.format.write_array(f, p, (2, 0))
assert same(tess('p.npy', '-cols', '3,1,2,5'), p[:, [2, 0, 1, 4]])
p[3:5, 3] = np.nan
np.save('p.npy', p)
assert same(tess('p.npy', '-skip'), np.delete(p, (3, 4), 0))
p = p[:, :3]
np.save('p.npy', np.asfortranarray(p))
assert same(tess('p.npy'), p)
rows = np.zeros(5, [('x', 'f8'), ('y', 'f8'), ('z', 'f8')])
for bad, why in ((p[:, 0], 'no array of two dim'), (p != 0, 'of the kind b1'),
                 (p.reshape(5, 10, 3), 'no array of two dim'),
                 (p + 1j, 'of the kind c16'), (p.astype('f2'), 'the kind f2'),
                 (rows, 'has rows of fields')):
    np.save('p.npy', bad)
    assert why in tess('p.npy'), why
np.save('p.npy', p)
for size, why in ((1000, 'announces 50 points, has room for 36 at most'),
                  (40, 'ends in its head'), (7, 'a version that is not known')):
    os.truncate('p.npy', size)
    assert why in tess('p.npy'), size
m = meshio.Mesh(p, [('triangle', random.integers(
    0, 50, (9, 3), 'i4'))])
corners = p[m.cells[0].data].reshape(-1, 3).astype('f4').astype(float)
meshio.write('p.stl', m, binary=True)
assert same(tess('p.stl'), corners)
meshio.write('p.ply', m, binary=True)
assert same(tess('p.ply'), p)
for order, of in ('<', 'little'), ('>', 'big'):
    names = 'x y z red k'.split()
    kinds = 'f8 f4 i2 u1 u4'.split()
    types = 'double float32 short uchar uint32'.split()
    a = np.zeros(50, [(n, order + k) for n, k in zip(names, kinds)])
    for k in range(5):
        a[names[k]] = random.integers(0, 2 ** 8, 50) - 99 * (k < 3)
    a['x'] += .1; a['k'] += 2 ** 32 - 300
    head = 'ply\nformat binary_%s_endian 1.0\nelement vertex 50\n' % of
    for both in zip(types, names): head += 'property %s %s\n' % both
    with open('p.ply', 'wb') as f:
        f.write((head + 'element face 1\nproperty list uchar int vertex_index\n'
                 'end_header\n').encode() + a.tobytes() + b'\3\n\n\n')
    assert same(tess('p.ply'), np.array(a.tolist()))
    with open('p.stl', 'wb') as f:
        f.write(b'solid'.ljust(80) + struct.pack(order + 'I', 9))
        for t in corners.reshape(9, 9):
            f.write(struct.pack(order + '12fH', 0, 0, 0, *t, 7))
    assert same(tess('p.stl'), corners)
END
if $PYTHON -c 'import meshio, numpy' 2> words; then
    yes "binary PLY, STL, .npy" $PYTHON packed.py $TESS
else
    skip "binary PLY, STL, .npy: no meshio, numpy for $PYTHON"
fi

# ---- PCD, LAMMPS dumps, LAS ----

reads two cloud.pcd << END
# .PCD v0.7 - Point Cloud Data file format
VERSION 0.7
FIELDS T x y z _ u
SIZE 4 4 4 4 1 8
TYPE F F F F U F
COUNT 1 1 1 1 2 1
WIDTH 5
HEIGHT 1
VIEWPOINT 0 0 0 1 0 0 0
POINTS 5
DATA ascii
0 0 0 0 9 9 0.5
10 1 0 0 9 9 1.5
20 0 1.5 0 9 9 2.5
30 0 0 -2 9 9 3.5
40 0.134 0.25 -0.5 9 9 4.5
END
sed 's/HEIGHT 1/HEIGHT 2/' cloud.pcd |
    refuses high.pcd 'announces 5 points, WIDTH times HEIGHT are 10'
sed '/^TYPE/s/U/X/' cloud.pcd | refuses type.pcd ':5: TYPE is I, U or F'
sed 's/DATA ascii/DATA binary_compressed/' cloud.pcd |
    refuses packed.pcd 'pcl_convert_pcd_ascii_binary F G 0'
sed '/^20/s/0 1.5/nan 1.5/' cloud.pcd |
    refuses nan.pcd ':14: column 2, x: .nan.: not a number'
cat > dump << END
ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
5
ITEM: BOX BOUNDS xy xz yz pp pp ff
-1 6 1
-2 4 0.5
-3 5 -0.25
ITEM: ATOMS T xs ys zs u
END
# scaled in a tilted box: by the vectors (5.5 1 0.5; -0.25 ...), as LAMMPS says
awk 'NR > 1 { zs = ($4 + 3) / 8; ys = ($3 + 1.75 + 0.25 * zs) / 5.75
    xs = ($2 + 1 - ys - 0.5 * zs) / 5.5
    printf "%g %.17g %.17g %.17g %g\n", $5, xs, ys, zs, $6 }' two > scaled
cat dump scaled > scaled.dump
$TESS -q -node out.node scaled.dump
yes "a LAMMPS dump, scaled, in a tilted box" awk 'NR == FNR { for (k = 2;
    k < 7; k++) a[FNR, k] = $k; next }
    { for (k = 2; k < 7; k++) { d = $k - a[FNR, k]
        if (FNR > 1 && (d > 1e-14 || d < -1e-14)) bad = 1 } }
    END { exit bad || FNR != 6 }' two out.node
$TESS -periodic -volumes v.csv scaled.dump > said 2> words
yes "a LAMMPS dump: its box, its ways" grep "sum to 253; the box's is 253\$" said \
    > /dev/null
sed 's/yz pp pp ff/yz pp pp/' scaled.dump |
    refuses ways.dump ':5: not three of pp, ff, ss, mm'
sed '5,8d' scaled.dump | refuses boxless.dump ':5: no BOX BOUNDS before'
(awk 'NR == 1 { print "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5"
    print "ITEM: ATOMS x z y T u" } NR > 1 { print $2, $4, $3, $5, $6 }' two
cat scaled.dump) | reads two frames.dump 'its further frames are left out'

printf 'LASF%40s' '' | refuses short.las 'the file ends in its head'

# ---- limits: -below ----

cat > below.csv << END
x,y,z,T
0,0,0,0
1,0,0,<20
0,1.5,0,< 40
0,0,-2,>30
0.134,0.25,-0.5,40
END
refuses limits.csv ':3: column 4, T: .<20.: .*to line 5 (a limit; -below 0.5' \
    < below.csv
OPTIONS="-below 0.5"
reads one limits.csv '2 values are 0.5 times the limit; 1 above one is the li' \
    < below.csv
sed 's/^1,/<1,/' below.csv | refuses limit.csv ':3: column 1, x: .<1.: not a num'
OPTIONS="-below 2"
refuses limits2.csv '-below needs a number from 0 to 1' < below.csv
OPTIONS=
# a number that repeats itself far from all others
for far in -3.4028235e+38 -1e+20 9.96921e+36 -1.7976931e+308; do
    printf '0 0 0\n1 0 0\n0 1 0\n0 0 1\n' > far.txt
    printf '3 4 %s\n2 3 %s\n' $far $far >> far.txt
    $TESS far.txt > said 2> words
    yes "$far, twice: -nodata is advised, nothing else" sh -c "test \
        \$(wc -l < words) -eq 1 && grep -e '2 times z .*: -nodata $far\$' words" \
        > /dev/null
    $TESS -nodata $far far.txt > said 2> words
    yes "-nodata $far: of a coordinate" grep '^points *4$' said > /dev/null
done

# ---- known, but not read: by name, with what to do ----

while read -r text; do
    printf "${text%%/*}" | refuses known "is ${text#*/}"
done << 'END'
\102ZhBZh91AY/compressed by bzip2, which is not read: bunzip2 -c
\3757zXZ\000/compressed by xz, which is not read: xz -dc
(\265\057\375/compressed by zstd, which
PK\003\004xx/a zip archive, which is not read: unzip -p
\320\317\021\340/a spreadsheet, which is not read: save the sheet
\211HDF\r\n/HDF5
CDF\001/netCDF
II*\000/TIFF, which is not read: gdal_translate
ncols 5\nnrows 5\n1 2 3\n/an ESRI grid
DSAA\n1 2 3\n/Surfer's grid
SQLite format 3\000/a GeoPackage
PAR1xxxx/parquet
# vtk DataFile Version 3.0\n/VTK's
<VTKFile type="x">\n/VTK's
$MeshFormat\n4.1 0 8\n/Gmsh's
*Heading\n/Abaqus's
ISO-10303-21;\n/STEP
<!doctype html>\n/a web page
version https:\057\057git-lfs.github.com\057spec\057v1\n/a pointer of Git LFS
%%PDF-1.4\n/PDF
{"a": 1}\n/JSON
data_x\n_cell 1\n/CIF, which is not read: ase convert
data_x\n_atom_site.id\n/mmCIF, which is not read: gemmi convert
a title\n1.0\n1 0 0\n0 1 0\n0 0 1\nNa Cl\n1 1\nDirect\n0 0 0\n/POSCAR
a title\n1\n    1WATER  OW1    1   0.126   1.624   1.679\n   1 1 1\n/GRO
LAMMPS\n\n5 atoms\n/LAMMPS's data
2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n/PTX
LASF....................................................................................................\200..../LAZ
END

# ---- the contract, over all formats ----

lines $PYTHON "$TOP"/test/program/contract.py $TESS

# ---- what is no file of points ----

printf '' | refuses empty.txt empty
printf '\n# nothing\n' | refuses comment.txt empty
printf 'x,y,z\n' | refuses header.txt 'before the first point'
printf '0 3 0 0\n' | refuses empty.node 'no points'
plane='fewer than three numbers; for points in a plane, x, y and values, see -pl'
printf '1 2\n3 4\n' | refuses plane.txt ":1: $plane"
printf 'x,y\n1,2\n3,4\n' | refuses plane.csv ":2: $plane"
OPTIONS="-plane -validate"
printf '1.5\n3.5\n' | refuses lone.txt ':1: fewer than two numbers'
OPTIONS=
printf '1 2 3\n1 2\n' | refuses short.txt ':2: 2 columns, but others have 3'
printf '1 2 3\n1 x 3\n' | refuses word.txt ':2: column 2: .x.: not a number'
printf '1,2,3,4\n1,2,3\n' | refuses missing.csv ':2: 3 columns'
empty='empty (-skip drops'
printf '1,2,3,4\n0,1,0,\n' | refuses last.csv ":2: column 4.*: $empty"
printf '0,1,0,\n1,2,3,4\n' | refuses first.csv ":1: column 4.*: $empty"
printf 'x,y,z,T\n0,1,0,\n1,2,3,4\n' |
    refuses named.csv ":2: column 4.*: $empty"
yes "an empty cell: nothing else is said" test "$(wc -l < words)" -eq 1
printf 'x,y,z,T\n0,1,0,\n' > hollow4.csv
$TESS hollow4.csv > said 2> words
yes "an empty column: it is skipped" grep '^points *1$' said > /dev/null
yes "an empty column: it is said" grep 'column 4 (empty) is not a number: skip' \
    words > /dev/null
printf '1,2,3,4,5\n1,2,3,,5\n' | refuses hole.csv ":2: column 4.*: $empty"
printf '1,2,,4,5\n1,2,3,4,5\n' | refuses top.csv ":1: column 3.*: $empty"
printf 'x,y,z,T\n1,,3,4\n1,2,3,4\n' | refuses y.csv ":2: column 2.*: $empty"
printf '1,,3\n1,2,3\n' | refuses two.csv ":1: column 2.*: $empty"
printf '1,2,3,""\n1,2,3,4\n' | refuses bare.csv ":1: column 4.*: $empty"
printf '1\t2\t3\t4\n1\t\t3\t4\n' | refuses cell.tsv ':2: .*-skip'
OPTIONS="-cols y,x,z"
printf 'x,y,z\n,2,3\n' | refuses cols.csv ":2: column 1.*: $empty"
OPTIONS=
printf '9\n1 2 3\n4 5 6\n' | refuses few.txt 'announces 9 points, has room for 3 at most'
big='format binary_big_endian 1.0\nelement vertex 9\nproperty'
for ply in 'format binary 1.0/2: not a format of PLY' "$big half x/4: not a" \
    "$big i1 x/4: not a prop" "$big list int int x/4: a list is not a prop"; do
    printf "ply\n${ply%/*}\n" | refuses binary.ply ":${ply#*/}"
done
printf '2024-11 1 2 3\n2024-12 4 5\n' | refuses dates.txt ':2: 3 columns'
printf '1 2 nan\n' | refuses nan.txt ':1: column 3: .nan.: not a number (-skip'
printf '1 2 3\n4 5 1D400\n' | refuses huge.txt ':2: column 3: .1D400.: not finite'
printf '\377\3761\000 \000' | refuses wide.txt UTF-16
gzip < none.node | refuses none.xyz.gz 'compressed by gzip'
gzip < none.node | refuses none.node 'compressed by gzip'
cp none none.node
printf 'PK\003\004...' | refuses table.xlsx 'a zip archive'
(printf '%-80s\002\000\000\000' solid; printf '%90s' '') |
    refuses part.stl 'no binary STL: its size is not 84 and 50 times'
printf 'few\000' | refuses few.STL 'no binary STL'
printf 'few\000' | refuses few.dat 'is no text, nor a binary format that is known'
printf '0\000' | refuses zero.dat 'is no text'
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
for o in -O0 -O2; do
    (cd "$TOP"/test/examples && $CC $o -I"$TOP" -o "$TOP/build/driver/tess$o" \
        ../program/*.c slopes.c natural.c derived.c cells.c periodic.c \
        ../proof/exact.c "$TOP"/tess.c "$TOP"/hhpred.c -lm)
    ./tess$o -q -alpha 0.5 -svg m$o.svg -grid 40,1,30 -values s$o.svg \
        "$TOP"/test/data/mirror.xyz
    ./tess$o -q -svg c$o.svg none.node
done
for f in m c s; do
    yes "pictures: the same bytes, $f" cmp $f-O0.svg $f-O2.svg
done
if $PYTHON -c 'import numpy' 2> words; then
    lines $PYTHON "$TOP"/test/program/pictures.py $TESS
    lines $PYTHON "$TOP"/test/program/shapes.py $TESS
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

# ---- sizes of tetrahedra, alpha shapes: by other formulas ----

cat > alpha.py << END
import struct, sys
def rows(name):
    r = [[float(x) for x in l.split()] for l in open(name) if l[0] != '#']
    return [a[1:] for a in r[1:]]
def cross(a, b):
    return [a[1]*b[2]-a[2]*b[1], a[2]*b[0]-a[0]*b[2], a[0]*b[1]-a[1]*b[0]]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def minus(a, b): return [x - y for x, y in zip(a, b)]
def block(name, title, n):
    head = 'SCALARS %s double 1\\nLOOKUP_TABLE default\\n' % title
    text = open(name, 'rb').read().split(head.encode())[1]
    return struct.unpack('>%dd' % n, text[:8 * n])
p = rows('v.node')
def sizes(t):
    a, b, c = [minus(p[v], p[t[0]]) for v in t[1:]]
    det = dot(a, cross(b, c))
    u = [(dot(a, a) * x + dot(b, b) * y + dot(c, c) * z) / (2 * det)
         for x, y, z in zip(cross(b, c), cross(c, a), cross(a, b))]
    return dot(u, u) ** .5, det / 6
radius = float(sys.argv[1])
whole = [[int(x) for x in r] for r in rows('v.ele')]
part = [[int(x) for x in r] for r in rows('a.ele')]
size = [sizes(t) for t in whole]
for name, ele in ('v.vtk', whole), ('a.vtk', part):
    n = len(ele)
    for t, r, v in zip(ele, block(name, 'circumradius', n),
                       block(name, 'volume', n)):
        assert abs(r - sizes(t)[0]) <= 1e-9 * r, (t, r)
        assert abs(v - sizes(t)[1]) <= 1e-12 * max(1, v / 1e-3), (t, v)
assert part == [t for t, s in zip(whole, size) if s[0] <= radius]
assert 0 < len(part) < len(whole)
neigh = [[int(x) for x in r] for r in rows('a.neigh')]
facets = {}
for t in part:
    for k in range(4): facets.setdefault(frozenset(t) - {t[k]}, []).append(t)
shell = [f for f in facets if len(facets[f]) == 1]
for t, u in zip(part, neigh):
    for k in range(4):
        both = facets[frozenset(t) - {t[k]}]
        assert u[k] < 0 if len(both) == 1 else part[u[k]] in both
        assert u[k] < 0 or part[u[k]] != t
face = [[int(x) for x in r] for r in rows('a.face')]
assert sorted(map(sorted, face)) == sorted(map(sorted, shell))
volume = sum(s[1] for s in size if s[0] <= radius)
out = sum(dot(p[a], cross(p[b], p[c])) / 6 for a, b, c in face)
assert abs(out - volume) <= 1e-12 * volume, (out, volume)
said = {l.split()[0]: l.split()[1] for l in open('said')}
assert int(said['tetrahedra']) == len(part)
assert int(said['facets']) == len(shell)
assert abs(float(said['volume']) - volume) <= 1e-8 * volume
END
awk 'BEGIN { srand(5); print 200, 3, 0, 0
    for (i = 0; i < 200; i++) print i, rand(), rand(), rand() }' > cloud.node
$TESS -q -node v.node -ele v.ele -vtk v.vtk cloud.node
for radius in 0.15 0.3; do
    $TESS -alpha $radius -ele a.ele -neigh a.neigh -vtk a.vtk -face a.face \
        -svg a.svg -cells ac.vtk cloud.node > said
    yes "-alpha $radius: tetrahedra, neighbours, facets, sizes, volume" \
        $PYTHON alpha.py $radius
done
$TESS -q -cells vc.vtk cloud.node
yes "-alpha: cells are those of all points" cmp vc.vtk ac.vtk
$TESS -alpha 0.001 -ele a.ele cloud.node > said 2> words
yes "-alpha: nothing left" sh -c \
    'test "`cat a.ele`" = "0 4 0" && grep "nothing is left" words' > /dev/null

# ---- Voronoi cells: their volumes sum to the box's; faces by Euler ----

awk 'BEGIN { srand(7); for (i = 0; i < 500; i++) print rand(), rand(), rand()
    for (i = 0; i < 64; i++) print i % 4, int(i / 4) % 4, int(i / 16) }' > some
# fills NAME N VOLUME: VTK reads N closed polyhedra in cells.vtk, of the volumes
# that it says, VOLUME in all
cat > fills.py << END
import sys, numpy, vtk
from vtk.util.numpy_support import vtk_to_numpy as array
r = vtk.vtkUnstructuredGridReader()
r.SetFileName('cells.vtk')
r.ReadAllScalarsOn()
r.Update()
m = r.GetOutput()
volume = array(m.GetCellData().GetArray('volume'))
whole = float(sys.argv[2])
n = m.GetNumberOfCells()
assert n == int(sys.argv[1])
assert list(array(m.GetCellData().GetArray('point'))) == list(range(n))
for i in range(n):
    c = m.GetCell(i)
    assert c.GetCellType() == 42
    sides, inside = set(), 0
    o = numpy.array(c.GetPoints().GetPoint(0))
    for f in range(c.GetNumberOfFaces()):
        p = array(c.GetFace(f).GetPoints().GetData()) - o
        k = c.GetFace(f).GetPointIds()
        k = [k.GetId(j) for j in range(k.GetNumberOfIds())]
        sides |= set(zip(k, k[1:] + k[:1]))
        inside += numpy.cross(p[1:-1], p[2:]).dot(p[0]).sum() / 6
    assert all((b, a) in sides for a, b in sides)
    # Euler
    assert 2 * (c.GetNumberOfPoints() + c.GetNumberOfFaces()) == len(sides) + 4
    assert abs(inside - volume[i]) <= 3e-14 * whole, (i, inside, volume[i])
assert abs(volume.sum() - whole) <= 1e-12 * whole
END
fills() {
    if $PYTHON -c "import numpy, vtk" 2> words; then
        yes "$1" $PYTHON fills.py "$2" "$3"
    else
        skip "$1: no numpy, vtk for $PYTHON"
    fi
}
$TESS -q -cells cells.vtk some
fills "-cells: as many as points, and they fill the box" 564 27
$TESS -q -cells cells.vtk -box -.5,3.5,0,3.25,0,3 some
fills "-cells -box: they fill that box" 564 39
$TESS -q -cells cells.vtk -periodic -box 0,4,0,4,0,4 some
fills "-cells -periodic: they fill the box" 564 64
# of any size: also where squares of areas are beyond doubles
$TESS -q -volumes some.csv some
for e in -100 -80 80 100; do
    awk '{ printf "%.17g %.17g %.17g\n", $1 * s, $2 * s, $3 * s }' s=1e$e some \
        > sized
    rm -f cells.vtk
    $TESS -q -cells cells.vtk -volumes sized.csv sized
    yes "-volumes: areas are right, 1e$e" awk -F, -v s=1e$((2 * e)) '
        FNR == 1 { next }
        NR == FNR { a[FNR] = $7 * s; next }
        !($7 > a[FNR] * (1 - 1e-9) && $7 < a[FNR] * (1 + 1e-9)) { bad = 1 }
        END { exit bad || FNR != 565 }' some.csv sized.csv
    fills "-cells: they fill the box, 1e$e" 564 27e$((3 * e))
    rm -f cells.vtk
    $TESS -q -cells cells.vtk -periodic -box 0,4e$e,0,4e$e,0,4e$e sized
    fills "-cells -periodic: they fill the box, 1e$e" 564 64e$((3 * e))
done
cat > voronoi.py << END
import sys, itertools, numpy
from scipy.spatial import Voronoi, ConvexHull
periodic = sys.argv[1] == 'periodic'
box = numpy.array([float(x) for x in sys.argv[2].split(',')]).reshape(3, 2)
scale = numpy.array([float(x) for x in sys.argv[3].split(',')])
rows = [l.split(',') for l in open('cells.csv').read().splitlines()]
assert rows.pop(0) == ['x', 'y', 'z', 'volume', 'faces', 'point', 'area',
                       'neighbours', 'value', 'cx', 'cy', 'cz', 'name']
assert [r.pop() for r in rows] == ['"a %d"' % i for i in range(len(rows))]
a = numpy.array([r[:7] + r[8:] for r in rows], float)
assert (a[:, 5] == range(len(a))).all()
assert (a[:, 7] == 5 * a[:, 5]).all()
p = a[:, :3]
assert (p == numpy.loadtxt('boxed')).all()
all, n = p, len(p)
who = numpy.arange(n)
for k in range(3):
    more = [all]
    name = [who]
    for side in 0, 1:
        other = all.copy()
        if periodic: other[:, k] += (2 * side - 1) * (box[k, 1] - box[k, 0])
        else: other[:, k] = 2 * box[k, side] - all[:, k]
        more.append(other)
        name.append(who if periodic else 0 * who - 1 - 2 * k - side)
    all = numpy.concatenate(more)
    who = numpy.concatenate(name)
v = Voronoi(all * scale)
vertices = v.vertices / scale
faces = numpy.zeros(n, int)
beside = [[] for i in range(n)]
def key(i, j, s):
    return (int(i), int(j)) + tuple(int(k) for k in numpy.rint(s))
wall = {}
for (i, j), corners in zip(v.ridge_points, v.ridge_vertices):
    for i, j in (i, j), (j, i):
        if i < n:
            faces[i] += 1
            beside[i].append(who[j])
            q = vertices[corners]
            normal = numpy.cross(q - q[0], numpy.roll(q, -1, 0) - q[0]) / 2
            size = numpy.linalg.norm(normal, axis=1)
            normal = normal.sum(0)
            normal *= numpy.sign(normal.dot(q[0] - p[i]))
            middle = (q + numpy.roll(q, -1, 0) + q[0]) / 3
            away = all[j] - p[who[j]] if periodic else numpy.zeros(3)
            wall[key(i, who[j], away)] = (normal,
                                          middle.T.dot(size) / size.sum())
f = numpy.loadtxt('faces.csv', delimiter=',', skiprows=1)
once = [key(r[0], r[1], r[9:]) for r in f]
again = [key(r[1], r[0], -r[9:]) for r in f if r[1] >= 0]
assert len(once) + len(again) == len(wall) and set(once + again) == set(wall)
for r, k in zip(f, once):
    normal, middle = wall[k]
    assert abs(r[2] * r[6:9] - normal).max() < 1e-12
    assert abs(r[2] * (r[3:6] - middle)).max() < 1e-12
    assert abs(numpy.linalg.norm(r[6:9]) - 1) < 1e-15
hull = [ConvexHull(vertices[v.regions[v.point_region[i]]]) for i in range(n)]
for h, centre in zip(hull, a[:, 8:]):
    q = h.points[h.simplices] - h.points.mean(0)
    size = abs(numpy.linalg.det(q))
    middle = (q.sum(1) / 4).T.dot(size) / size.sum() + h.points.mean(0)
    assert abs(centre - middle).max() < 1e-12, (centre, middle)
volume = [h.volume for h in hull]
area = numpy.array([h.area for h in hull])
assert abs(a[:, 6] / area - 1).max() < 1e-9, abs(a[:, 6] / area - 1).max()
for i in range(n):
    assert sorted(int(j) for j in rows[i][7].split()) == sorted(beside[i]), i
assert abs(a[:, 3] / volume - 1).max() < 1e-9, abs(a[:, 3] / volume - 1).max()
assert (a[:, 4] == faces).all()
whole = (box[:, 1] - box[:, 0]).prod()
said = [l for l in open('said') if l.startswith('cells')][0].split()
assert abs(float(said[6][:-1]) - whole) <= 1e-12 * whole, said
assert abs(float(said[10]) - whole) <= 1e-12 * whole, said
END
awk 'BEGIN { srand(8)
    for (i = 0; i < 150; i++) print rand(), 2 * rand(), 3 * rand() - 1 }' > boxed
if $PYTHON -c 'import scipy.spatial' 2> words; then
    awk '{ print $1, $2, $3, 5 * (NR - 1), "a " (NR - 1) }' OFS=, boxed \
        > valued.csv
    for kind in periodic clipped; do
        for scale in 1,1,1 2,1,0.25; do
            option=`echo -$kind | grep periodic`
            $TESS -volumes cells.csv -faces faces.csv $option -scale $scale \
                -box 0,1,0,2,-1,2 valued.csv > said
            yes "-volumes, -faces: as scipy has them: $kind, $scale" \
                $PYTHON voronoi.py $kind 0,1,0,2,-1,2 $scale
        done
    done
else
    skip "-volumes, -faces beside scipy's: no scipy for $PYTHON"
fi
awk '{ printf "%.17g %.17g %.17g\n", $1 + NR % 3 - 1, $2 - 2 * (NR % 2),
    $3 + 6 }' boxed > far
$TESS -volumes far.csv -periodic -box 0,1,0,2,-1,2 far > said 2> words
yes "-periodic: points outside the box are said" grep outside words > /dev/null
$TESS -q -volumes near.csv -periodic -box 0,1,0,2,-1,2 boxed
yes "-periodic: points outside the box have copies inside" awk -F, '
    NR == FNR { v[FNR] = $4; f[FNR] = $5; next }
    FNR > 1 && ($5 != f[FNR] || $4 - v[FNR] > 1e-12 || v[FNR] - $4 > 1e-12) {
        bad = 1 }
    END { exit bad || FNR != 151 }' near.csv far.csv
# duplicates have none; points in a plane have cells where the box repeats
(cat some; sed -n 5p some) > twin
$TESS -q -volumes twin.csv twin
yes "-volumes: a duplicate has no cell" sh -c \
    'tail -n 1 twin.csv | grep ",0,0,564,0,,nan,nan,nan$"' > /dev/null
$TESS -periodic -box 0,2,0,2,0,1 -volumes flat.csv flat > said 2> words
yes "-periodic: points in a plane" grep 'sum to 4; the box.s is 4$' said \
    > /dev/null
$TESS -box 0,1,0,1,0,1 boxed > said 2> words
yes "-box without cells" grep 'for -cells, -volumes, -faces and -per' words \
    > /dev/null
for o in "-validate 5" "-grid 3,3 -values no.csv"; do
    yes "-periodic $o" sh -c \
        "! $TESS -periodic -box 0,1,0,2,-1,2 $o boxed > said 2> words &&
        grep -e '-periodic' words > /dev/null"
done
# cells of any shape, along some vectors or all: cells and their mesh, values
# by all methods, beside scipy's of the copies about them
cat > repeat.py << END
import itertools, subprocess, sys, numpy
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import Voronoi, ConvexHull, cKDTree
def tess(*options):
    subprocess.run(sys.argv[1:2] + ['-q'] + list(options), check=True)
def read(name):
    return numpy.genfromtxt(name, delimiter=',', skip_header=1)
random = numpy.random.default_rng(3)
short = numpy.array([[2, 0, 0], [.9, 1.8, 0], [-.5, .6, 1.7]])
n = int(sys.argv[2])
ways = numpy.array([int(w) for w in sys.argv[3]])
origin = numpy.array([-1, .5, 3.])
p = random.random((n, 3)) @ short + origin
q = random.random((400, 3)) @ short + origin
value = random.random(n)
# the same lattice, by long vectors; points some of them away; upright ones
# where nothing repeats itself, so that the cells' sides stay the same
vectors = short.copy()
if ways.all():
    vectors[1] += 7 * vectors[0]
    vectors[2] -= 5 * vectors[1]
away = random.integers(-3, 4, (n, 3)) * ways @ short
with open('repeat.xyz', 'w') as f:
    f.write('%d\\nLattice="%s" Origin="%s" pbc="%s" Properties=pos:R:3:u:R:1\\n' %
            (n, ' '.join(map(repr, map(float, vectors.flat))),
             ' '.join(map(str, origin)), ' '.join('FT'[w] for w in ways)))
    numpy.savetxt(f, numpy.c_[p + away, value], fmt='%.17g')
numpy.savetxt('places', q + random.integers(-9, 9, (400, 3)) * ways @ short,
              fmt='%.17g')
tess('-periodic', '-volumes', 'v.csv', '-node', 'r.node', '-ele', 'r.ele',
     '-faces', 'f.csv', 'repeat.xyz')
shift = [s for s in itertools.product(range(-3, 4), repeat=3)
         if not ((1 - ways) * s).any()]
shift.sort(key=lambda s: numpy.abs(s).sum())
copies = (p + (numpy.array(shift) @ short)[:, None]).reshape(-1, 3)
mirrored = [copies]
for k in numpy.flatnonzero(1 - ways):
    normal = numpy.linalg.inv(vectors)[:, k]
    height = (copies - origin) @ normal
    for side in 0, 1:
        mirrored.append(copies - 2 * (height - side)[:, None] * normal /
                        (normal @ normal))
v = Voronoi(numpy.concatenate(mirrored))
cells = [ConvexHull(v.vertices[v.regions[v.point_region[i]]])
         for i in range(n)]
a = numpy.atleast_2d(numpy.genfromtxt('v.csv', delimiter=',', skip_header=1,
                                      usecols=(3, 6)))
for k, right in enumerate(([c.volume for c in cells], [c.area for c in cells])):
    assert abs(a[:, k] / right - 1).max() < 1e-9, abs(a[:, k] / right - 1).max()
whole = abs(numpy.linalg.det(short))
assert abs(a[:, 0].sum() / whole - 1) < 1e-12
# of faces, which come once, those of a cell close it, around its volume; the
# neighbour, a lattice vector away from where it is given, is beyond
closed = numpy.zeros((n, 4))
for row in numpy.loadtxt('f.csv', delimiter=',', skiprows=1):
    i, j = row[:2].astype(int)
    area, x, normal, s = row[2], row[3:6], row[6:9], row[9:]
    at = (p + away)[[i, max(j, 0)]]
    closed[i] += numpy.append(area * normal, area * normal.dot(x - at[0]) / 3)
    if j < 0:
        assert (s == 0).all() and not ways[(-1 - j) // 2]
        continue
    at[1] += s
    closed[j] += numpy.append(-area * normal, area * normal.dot(at[1] - x) / 3)
    count = s @ numpy.linalg.inv(short)
    assert abs(count - numpy.rint(count)).max() < 1e-12
    assert abs(numpy.cross(at[1] - at[0], normal)).max() < 1e-13
    assert abs(area * normal.dot(2 * x - at[0] - at[1])) < 1e-12
closed[:, 3] -= a[:, 0]
assert abs(closed).max() < 1e-12, abs(closed).max()
# the mesh: balls without points, as large as the cell
node = numpy.loadtxt('r.node', skiprows=1)[:, 1:4]
assert (node[:n] == p + away).all()
x = node[numpy.loadtxt('r.ele', skiprows=1, ndmin=2)[:, 1:5].astype(int)]
edge = x[:, 1:] - x[:, :1]
volume = numpy.linalg.det(edge) / 6
assert (volume > 0).all()
if ways.all(): assert abs(volume.sum() / whole - 1) < 1e-12, volume.sum()
if ways.all():
    middle = numpy.linalg.solve(edge, (edge ** 2).sum(2)[:, :, None] / 2)[:, :, 0]
    radius = numpy.sqrt((middle ** 2).sum(1))
    middle += x[:, 0] - origin
    middle -= numpy.floor(middle @ numpy.linalg.inv(short)) @ short
    near = cKDTree(copies).query(middle + origin)[0]
    assert abs(near / radius - 1).max() < 1e-9, abs(near / radius - 1).max()
# values
many = numpy.tile(value, len(shift))
numpy.savetxt('copies', numpy.c_[copies, many], fmt='%.17g')
numpy.savetxt('inside', q, fmt='%.17g')
for method in 'linear', 'natural', 'nearest', 'smooth':
    # (gradients depend on points many edges away)
    if method == 'smooth' and (n < 100 or not ways.all()): continue
    tess('-periodic', '-query', 'places', '-qcols', '1,2,3', '-values',
         'here.csv', '-method', method, 'repeat.xyz')
    here = read('here.csv')[:, 3]
    assert not numpy.isnan(here).any() or not ways.all()
    if method == 'linear':
        there = LinearNDInterpolator(copies, many)(q)
    elif method == 'nearest':
        there = many[cKDTree(copies).query(q)[1]]
        there[numpy.isnan(here)] = numpy.nan
    else:
        tess('-query', 'inside', '-qcols', '1,2,3', '-values', 'there.csv',
             '-method', method, '-cols', '1,2,3,4', 'copies')
        there = read('there.csv')[:, 3]
    assert (numpy.isnan(here) == numpy.isnan(there)).all()
    # (a gradient has 1e-4 of the one that suits all copies)
    limit = 1e-10 if method != 'smooth' else 1e-5
    worst = numpy.nanmax(abs(here - there))
    assert worst < limit, (method, worst)
tess('-periodic', '-grid', '5,6,7', '-values', 'grid.csv', 'repeat.xyz')
grid = read('grid.csv')[:, :3]
low = numpy.minimum(vectors, 0).sum(0) + origin
high = numpy.maximum(vectors, 0).sum(0) + origin
assert abs(grid.min(0) - low).max() < 1e-12 * abs(high - low).max()
assert abs(grid.max(0) - high).max() < 1e-12 * abs(high - low).max()
END
if $PYTHON -c 'import scipy.spatial' 2> words; then
    for n in 2 3 120; do
        for ways in 111 110 001; do
            [ $n$ways = 2001 ] || [ $n$ways = 2110 ] || [ $n$ways = 3001 ] ||
                yes "-periodic: $n points, ways $ways, beside scipy's" \
                    $PYTHON repeat.py "$TESS" $n $ways
        done
    done
else
    skip "-periodic beside scipy's: no scipy for $PYTHON"
fi
# lattices, of which all is a tie: primitive cells of 1 point
for v in '0 1 1 1 0 1 1 1 0:2' '-1 1 1 1 -1 1 1 1 -1:4' \
    '2 0 0 1 2 0 0 1 2:8' '3 0 0 0 3 0 0 0 3:27'; do
    printf '1\nLattice="%s" Properties=pos:R:3:u:R:1\n.3 .2 .1 7\n' \
        "${v%:*}" > f.xyz
    $TESS -periodic -check -volumes v.csv -grid 9,9,9 -values f.csv f.xyz > said
    yes "-periodic: the lattice $v" awk -F, -v whole="${v#*:}" '
        FNR == 1 { f++; next }
        f == 1 { off = $4 - whole }
        f == 2 { places++; off = $4 - 7 }
        off > 1e-12 || off < -1e-12 { bad = 1 }
        END { exit bad || places != 729 }' v.csv f.csv
    yes "-check: proven" grep proven said > /dev/null
done
# refusals
OPTIONS="-volumes no.csv"
refuses flat1 'no cells: the points do not span space' < flat
for box in 0,1,0,1,0 0,1,0,1,1,0 0,1,0,1,0,0; do
    OPTIONS="-volumes no.csv -box $box"
    refuses boxed1 '-box needs X0,X1,Y0,Y1,Z0,Z1' < boxed
done
OPTIONS="-volumes no.csv -periodic"
refuses boxed2 '-periodic needs -box X0,X1,Y0,Y1,Z0,Z1, or' < boxed
yes "-periodic without a box: before anything is computed" test ! -s said
printf '0 0 0\n' > lone
OPTIONS="-volumes no.csv -periodic -box 0,64,0,1,0,1"
refuses lone1 'so few points in so long a box' < lone
OPTIONS="-volumes no.csv"
for e in -110 110; do
    awk '{ print $1 e, $2 e, $3 e }' e=e$e some |
        refuses sized 'use other units'
done
OPTIONS="-volumes no.csv -periodic -box 0,4e-300,0,4e-300,0,4e-300"
awk '{ print $1 e, $2 e, $3 e }' e=e-300 some | refuses sized 'use other units'
# a build whose volumes are wrong by 1e-8
sed 's,  *volume += area.j.,& * 1.00000001,' "$TOP"/test/examples/cells.c \
    > wrong.c
# shellcheck disable=SC2046 # a list of files
(cd "$TOP" && $CC -O1 -I. -Itest/examples -c -o build/driver/wrong.o \
    build/driver/wrong.c && $CC -o build/driver/wrong build/driver/wrong.o \
    $(sed -n '/^PROGRAM = /,/[^\\]$/p' Makefile | tr ' ' '\n' |
        grep '\.o' | grep -v cells) build/tess.o \
    build/hhpred.o -lm)
RIGHT=$TESS
TESS=./wrong
OPTIONS="-volumes no.csv"
refuses boxed3 "volumes sum to .* but the box's is" < boxed
TESS=$RIGHT
OPTIONS=
yes "nothing of what is refused is written" test ! -f no.csv

# ---- what cannot be written is refused at once; nothing is half written ----

mkdir -p there
for place in there nowhere/file; do
    echo no points | $TESS -q -ele $place > said 2> words
    yes "-ele $place: exit code 2, before anything is read" test $? -eq 2
    yes "-ele $place: why" grep "^tess: $place: " words > /dev/null
done
echo kept > kept.vtk
cp kept.vtk kept
(trap '' XFSZ; ulimit -f 8; $TESS -vtk kept.vtk -q some) > said 2> words
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
awk 'BEGIN { for (i = 0; i < 900; i++) print i, i * i, i * i * i }' > moment
$TESS -check moment > said 2> words
yes "tetrahedra: 448 a point" sh -c 'grep "^tetrahedra *402753$" said &&
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
(cd "$TOP" && $CC -Dtime=tick -I. -o build/driver/ticking build/driver/tick.c \
    test/program/driver.c `sed -n '/^PROGRAM = /,/[^\\]$/p' Makefile |
        tr ' ' '\n' | grep '\.o' | grep -v driver` build/tess.o \
    build/hhpred.o -lm)
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
yes "-q: it says nothing" test ! -s words
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
