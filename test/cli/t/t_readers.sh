#!/bin/sh
# t_readers.sh - tests of build/tess: the files it reads, and refuses.
#
# Of each format what it allows, and damages, come from generate.py; that
# nothing in a file is unheard is contract.py's; what is said of it, word for
# word, is messages.py's; others.py has other programs write and read,
# refusals.py runs what refusals advise.  What is here says what files mean:
# each holds the same five points, and what tess writes of them is compared with
# what is written here.
# shellcheck disable=SC2034 # of common.sh
NAME=readers
. test/cli/t/common.sh

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
    refuses points.txt ':1: column 1: .1.234,5.: not a number (points between th'
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

reads one numbers.txt "column 1 (1, 2, 3, ...) numbers the rows" << END
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
(echo a,b,c,value; cat plain.csv) > unnamed
refuses unnamed.csv "column 4, value: 0$" < unnamed
OPTIONS="$(sed -n 's/.* as \(-cols\)/\1/p' words)"
reads one asked.csv < unnamed
OPTIONS=
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
yes "-query: where its coordinates are" grep 'level); -qcols chooses others$' \
    words > /dev/null
# names that are not the columns'
sed 's/,[^,]*$//; 1s/$/,T,u/' level.csv |
    reads none fewer.csv ':1: its names, which are not as many as columns, are'
# 1, 2, 3 that x is by name, or that has no values beside it, is none
printf 'x,y,z,T\n1,0,0,1\n2,3,0,1\n3,0,1,1\n4,4,4,1\n' > x.csv
$TESS x.csv > said 2> words
yes "x by name is no number" test ! -s words
OPTIONS="-cols lon,lat,height"
refuses high.csv ':2: -cols: no column "height" among 6, which line 1 names: ' < ocean.csv
OPTIONS="-cols lon,lat,depth"
refuses nameless.txt 'no column "lon" .*no line of names' < numbers.txt
OPTIONS="-cols 2,3,7"
refuses seventh.csv 'no column "7" among 6' < ocean.csv
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

# names in a comment, where -cols asks for them, in any order, all or some
awk 'NR == 1 { print "#east north height t" } NR > 1 { print $4, $2, $3, $5 }' \
    one > remarks.txt
for names in north,height,east,t north,height,east; do
    OPTIONS="-cols $names"
    reads one comment.txt ':1: names of columns, from a comment' < remarks.txt
done
OPTIONS="-cols north,height,depth"
refuses comment.txt 'no column "depth" among 4' < remarks.txt
OPTIONS=

# ---- names before places: heads parted otherwise, one name less ----

awk 'BEGIN { print "\"T\" \"x\" \"y\" \"z\"" }
    NR > 1 { print "\"" 9 - $1 "\"", $5, $2, $3, $4 }' one |
    reads one written.txt ':1: one name less than columns'
sed 's/"//g; s/ /,/g; 2,$s/^/h/' written.txt |
    reads one labels.csv ':1: one name less than columns'
awk 'NR > 1 { print $5, $2, $3, $4 }' one > swapped
for head in '# T, X, Y, Z' 'T, X, Y, Z' 'T;X;Y;Z' '% T       X       Y (m)     Z'; do
    (echo "$head"; cat swapped) > savetxt.txt
    case $head in
        [#%]*) reads one savetxt.txt ':1: names of columns, from a comment';;
        *) reads one savetxt.txt;;
    esac < savetxt.txt
done
(echo "sample, m east, m north, depth"; cat swapped) |
    reads one gsplus.dat 'columns 2, 3, 4 (m east, m north, depth)'
(echo T,EAST,NORTH,RL; tr ' ' , < swapped) > holes.csv
reads one holes.csv 'columns 2, 3, 4 (EAST, NORTH, RL)' < holes.csv
$TESS -by EAST -validate 2 holes.csv > said 2> words
yes "-by takes no coordinate away" grep 'columns 2, 3, 4 (EAST, NORTH, RL)' \
    words > /dev/null
(echo T,EAST,NORTH,FROM; tr ' ' , < swapped) |
    refuses from.csv 'which columns are x, y, z?  Its names do not say so'
(echo T,X,Y,Z; echo K,m,m,m; tr ' ' , < swapped) | reads one units2.csv

# ---- tables with heads, models ----

(printf 'a lake\n4\nT\nX\nY (m)\nZ\n'; cat swapped) | reads one lake.dat
(printf 'a lake\n5\n'; awk 'NR > 1 { print $2, $3, $4, $5 }' one) |
    reads one turned.txt
(printf 'VERSION 1\nBEGIN HEADER\nFLOAT,T\nX\nY\nZ\nEND HEADER\n'
cat swapped) | reads one petrel.txt
(printf '\n[Name]\nPlane\n\n[Data]\nT [ K ], X [ m ], Y [ m ], Z [ m ]\n'
sed 's/ /, /g' swapped; printf '\n[Lines]\n0, 1\n') |
    reads one post.csv 'its faces, lines or further places are left out: 1 line'
(printf '* Sea-Bird SBE\n# nquan = 4\n# nvalues = 5\n'
k=0
for name in t090C longitude latitude depSM; do
    echo "# name $k = $name: what it is"
    k=$((k + 1))
done
printf '# bad_flag = -9.990e-29\n# file_type = ascii\n*END*\n'
awk '{ printf "%11s%11s%11s%11s\n", $1, $2, $3, $4 }' swapped) |
    reads one cast.cnv 'columns 2, 3, 4 (longitude, latitude, depSM)'
(printf 'BOTTLE,2020\nCTDTMP,LONGITUDE,LATITUDE,CTDPRS\n,,,DBAR\n'
tr ' ' , < swapped; echo END_DATA) |
    reads one bottle.csv 'columns 2, 3, 4 (LONGITUDE, LATITUDE, CTDPRS)'
(printf '~V\n VERS. 2.0 :\n WRAP. NO :\n~W\n NULL. -999.25 :\n~C\n T. :\n'
printf ' X.M :\n Y.M :\n DEPT.M :\n~A\n'; cat swapped) |
    reads one well.las 'columns 2, 3, 4 (X, Y, DEPT)'
(printf 'Cruise\tStation\tType\tT\tLongitude\tLatitude\tDepth [m]\n'
awk '{ print "C\t1\tB\t" $1 "\t" $2 "\t" $3 "\t" $4 }' swapped) > odv.txt
OPTIONS="-cols Longitude,Latitude,Depth,T"
reads one odv.txt < odv.txt
OPTIONS=
(printf 'GOCAD VSet 1\nHEADER {\nname:a\n}\nPROPERTIES T\n'
awk 'NR > 1 { print "PVRTX", NR, $2, $3, $4, $5 }' one; echo END) |
    reads one set.vs
awk 'NR > 1 { printf "GRID    %8d        %8.3f%8.3f%8.3f\n", NR, $2, $3, $4 }' \
    none | reads none grid.bdf
awk 'NR > 1 { printf "GRID*   %16d%16d%16.3f%16.3f\n*       %16.3f\n", NR, 0, $2,
    $3, $4 }' none | reads none wide.bdf
awk 'NR > 1 { printf "GRID,%d,,%.3f,%.3f,%.3f\n", NR, $2, $3, $4 }' none |
    reads none free.bdf
(printf 'a box\n    5\n'; awk 'NR > 1 { for (k = 2; k < 5; k++)
    printf "%12.7f%s", $k, ++n % 6 ? "" : "\n" } END { print "" }' none) |
    reads none box.inpcrd
awk 'NR > 1 { print "ATOM", NR, "C LYS A", NR, $2, $3, $4, $5, $1 + 0.5 }' one |
    reads two free.pqr

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
for value in x "1," nan; do
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
for pbc in '"T T"' '"T T T T"' '"T FxT"' '"T X F"' '""'; do
    sed "2s/\$/ pbc=$pbc/" more.xyz |
        refuses ways.xyz ':2: pbc needs three of T and F'
done
for pbc in '"T T T"' '[True, True, True]' '"1 1 1"' T; do
    sed "2s/\$/ pbc=$pbc foo=0/" more.xyz > bulk.xyz
    yes "pbc=$pbc" $TESS -q -periodic -volumes v.csv bulk.xyz 2> words
done

# ---- plain lines are read at once, all others field by field: the same ----

awk 'BEGIN { srand(3)
    for (i = 0; i < 4000; i++)
        printf "%.17g,%.3f,-%ge-1,%d\n", rand() * 9, rand(), rand(), i
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
for word in 'OFF BINARY' 4OFF nOFF 'OFF binary'; do
    sed "1s/.*/$word/" mesh.off |
        refuses other.off "$word: not an OFF file of points in space"
done
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
# of names longer than any that is kept are 39 characters, and no other one is
for n in 39 40 41 300; do
    long=$(printf "%0${n}d" 0 | tr 0 q)
    sed "/^FIELDS/s/ T / $long /" cloud.pcd > long.pcd
    sed "s/float T/float $long/" mesh.ply > long.ply
    sed "1s/T (%)/$long/" header.csv > long.csv
    for f in long.pcd long.ply long.csv; do
        rm -f v.csv
        $TESS -q -volumes v.csv $f
        yes "$f: a name of $n characters" \
            grep '^x,y,z,[a-z,]*,q\{39\},[uwr"]' v.csv > /dev/null
    done
done
for key in FIELDS SIZE TYPE WIDTH HEIGHT POINTS DATA; do
    sed "/^$key/d" cloud.pcd | refuses keyless.pcd "where PCD has $key"
    sed "s/^$key.*/$key/" cloud.pcd |
        refuses wordless.pcd "$key \\(has no words\\|needs one word\\)"
done
for key in SIZE COUNT WIDTH HEIGHT POINTS; do
    sed "s/^\\($key\\) [0-9]*/\\1 1e1/" cloud.pcd |
        refuses number.pcd "$key: .1e1.: not a number"
done
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
        \$(wc -l < words) -eq 1 && grep -e 'z is .* in 2 rows.*: -nodata $far\$' \
        words" \
        > /dev/null
    $TESS -nodata $far far.txt > said 2> words
    yes "-nodata $far: of a coordinate" grep '^points *4$' said > /dev/null
done

# ---- known, but not read: by name, with what to do ----

while read -r text; do
    printf "${text%%/*}" | refuses known "is ${text#*/}"
done << 'END'
\102Zh91AY/compressed by bzip2, which is not read: bunzip2 -c
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
LAMMPS\n\n5 atoms\n1 atom types\n/LAMMPS's data
2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n/PTX
LASF....................................................................................................\200..../LAZ
END

# ---- what is no file of points ----

# of a row of another width, what may be behind it
printf '1\t2\t3\n1\t2\n' |
    refuses width.tsv ':2: 2 columns, but others have 3 (empty cells?  see -skip)$'
printf '1,2,3\n1,2\n' | refuses width.csv ':2: 2 columns, but others have 3$'
printf '1,2,3\n4\n' | refuses width.csv ':2: 1 column, .* (one separator in a'
(awk 'NR > 1 { print $2 ";" $3 ";" $4 }' none; echo '1;2 3;4') |
    refuses both.csv ':6: column 2: .2 3.: .* (two numbers in one cell: one sep'
(awk 'NR > 1 { print $2 ";" $3 ";" $4 }' none; echo '1;2 x;4') |
    refuses word.csv ':6: column 2: .2 x.: not a n'
yes "two words are no two numbers" sh -c '! grep "two numbers" words' > /dev/null
# cells like the bad one are counted to the end, and the last one is said
for n in 0 1 2 7; do
    (printf 'x,y,z\n1,2,3\n1,NA,3\n'
    k=0; while [ $k -lt $n ]; do echo "1,NA,$k"; k=$((k + 1)); done
    printf '1,2,3\n1,x,3\nNA,2,3\n1,2,3,4\n') > like.csv
    more="; so are $n more, to line $((n + 3))"
    [ $n = 0 ] && more=
    [ $n = 1 ] && more="; so is 1 more, to line 4"
    refuses likes.csv ":3: column 2, y: .NA.: not a number$more (-skip drops" \
        < like.csv
done
# ... but not beyond a count
printf '3\n1 2 NA\n1 2 3\n4 5 6\n7 8 NA\n' |
    refuses counted.txt ':2: column 3: .NA.: not a number (-skip'
# doubled quotes are one, in names, labels, and what comes back
printf '"x","y","z","a ""b"" c"\n0,0,0,1\n1,0,0,2\n0,1,0,3\n0,0,1,4\n' \
    > names.csv
$TESS -q -volumes v.csv names.csv
yes "doubled quotes in a name" grep '^x,y,z,.*,"a ""b"" c",' v.csv > /dev/null
printf 'x,y,z,n\n0,0,0,"a ""b"""\n1,0,0,"""c"\n0,1,0,"d"\n0,0,1,e"f\n' \
    > labels.csv
$TESS -q -volumes v.csv labels.csv
yes "doubled quotes in labels" test "$(sed '1d; s/.*[0-9],//' v.csv |
    tr '\n' ' ')" = '"a ""b""" """c" d "e""f" '

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
# ... of a pipe the size is not known, and all of it not at hand
(printf '%-80s\320\007\000\000' solid; head -c 99999 /dev/zero) |
    $TESS - > said 2> words
yes "binary STL from a pipe, a byte less" test $? -eq 2
yes "binary STL from a pipe: why" grep 'ends after 5997 of 6000 points' words \
    > /dev/null
printf 'few\000' | refuses few.dat 'is no text, nor a binary format that is known'
printf '0\000' | refuses zero.dat 'is no text'
$TESS -node none.node none.node > said 2> words
yes "the input is not overwritten" test $? -eq 2
$TESS -node x -ele x none.node > said 2> words
yes "two outputs of one name" test $? -eq 2

# ---- the contract, what formats allow, damaged files, other programs ----

if [ -n "$SHORT" ]; then
    ended readers
    exit
fi
# (many short runs: those without shared libraries are shorter)
# shellcheck disable=SC2046 # a list of files
$CC -static -o tess $(objects none) "$TOP"/build/tess.o "$TOP"/build/hhpred.o \
    -lm 2> words || cp "$TESS" tess
lines $PYTHON "$TOP"/test/cli/t/messages.py ./tess
lines $PYTHON "$TOP"/test/cli/t/contract.py ./tess
if $PYTHON -c 'import concurrent.futures' 2> told; then
    # (no index is beyond its array, none of what C leaves open; what is
    # allocated is not freed at the end)
    ASAN_OPTIONS=detect_leaks=0
    export ASAN_OPTIONS
    READERS='scan|cell|rows|names|doubts|voids|formats|tables|meshes|models|atoms|arrays'
    # shellcheck disable=SC2046 # lists of files
    $CC -O1 -fsanitize=address,undefined -fno-sanitize-recover=all -I"$TOP" \
        -o checked \
        $(echo "$READERS" | tr '|' '\n' | \
        sed "s,.*,$TOP/test/cli/src/read/&.c,") \
        $(objects "$READERS") "$TOP"/build/tess.o "$TOP"/build/hhpred.o -lm \
        2> words || cp tess checked
    lines $PYTHON "$TOP"/test/cli/t/generate.py ./checked
else
    skip "files that formats allow, and damaged ones: no $PYTHON"
fi
if $PYTHON -c 'import numpy' 2> told; then
    lines $PYTHON "$TOP"/test/cli/t/others.py "$TESS" 8
    sed -n 's/^        none: //p' numbers > lacking
    while read -r line; do skip "$line"; done < lacking
    # (hardly anything of it is this program's: -all)
    [ -z "${ALL:-}" ] || lines $PYTHON "$TOP"/test/cli/t/refusals.py "$TESS"
else
    skip "files beside other programs: no numpy for $PYTHON"
fi

ended readers
