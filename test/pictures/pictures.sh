#!/bin/sh
# pictures.sh - write the pictures of the front page by build/tess: points,
# their mesh and the field between them, strip.svg; four methods of interpolation,
# methods.svg; a grade shell, shell.svg.
# Run from the top directory: make pictures.  speed.py draws the times.  Nobody
# reads them line by line: each picture in one has a line.
#
#     pictures.sh [DIRECTORY]  where they go
HERE=${1:-test/pictures}
DIR=build/pictures
UNIT=$(printf '\302\260C,m') # degrees
mkdir -p $DIR

# ---- strip.svg ----

# draw FILE OPTIONS: a picture of standard input's points, all from one place
draw() {
    file=$DIR/$1
    shift
    build/tess -q -alpha 0.55 -view -71.25 36 -size 300,230 -unit "$UNIT" "$@" \
        -svg "$file" -
}
# lines PICTURE: standard input, with a line for each picture in it
lines() {
    { tr '\n' ' ' | sed 's/ *<svg/\
<svg/g' | sed 1d; echo; } > $HERE/$1
}
# (without its names, which are long)
MIRROR=$DIR/mirror
grep -v '^#' test/data/mirror.xyz > $MIRROR
draw points.svg -bare -draw points < $MIRROR
cut -d ' ' -f 1-3 $MIRROR | draw mesh.svg -bare
draw field.svg -bare -draw field < $MIRROR
draw whole.svg < $MIRROR

# panel LETTER X FILE TEXT: its classes begin with that letter
panel() {
    echo "<svg x=\"$2\" width=\"300\" height=\"230\" viewBox=\"0 0 3000 2300\">"
    sed "1d; \$d; s/\\.\\([A-Ea-ez][0-9]\\)/.$1\\1/g
        s/class=\"\\([A-Ea-ez][0-9]\\)/class=\"$1\\1/" "$DIR/$3"
    echo "</svg><text x=\"$(($2 + 150))\" y=\"252\">$4</text>"
}
# count WORD: how many of them the picture says it has
count() { sed -n "s/.*[ >]\\([0-9]*\\) $1.*/\\1/p" $DIR/whole.svg; }
{
    echo '<svg xmlns="http://www.w3.org/2000/svg" width="1000" height="262"'
    echo 'viewBox="0 0 1000 262" font-family="Helvetica,Arial,sans-serif"'
    echo 'font-size="17" text-anchor="middle" fill="#767c85">'
    panel p 0 points.svg "$(count points) points with values"
    panel m 310 mesh.svg "$(count tetrahedra) tetrahedra between them"
    panel f 620 field.svg "a value everywhere"
    # the colour bar of a picture that is not bare
    echo '<svg x="915" width="85" height="230" viewBox="1950 0 850 2300">'
    echo '<g text-anchor="start">'
    sed -n '/<g class="bar">/,/<\/g>/p' $DIR/whole.svg
    echo '</g></svg></svg>'
} | lines strip.svg

# ---- methods.svg: a plane through 500 random points of a cube ----

awk 'BEGIN { for (seed = 1; n < 500; n++) {
    for (k = 0; k < 3; k++) {
        seed = (1664525 * seed + 1013904223) % 4294967296
        x[k] = seed / 4294967296 }
    printf "%.9f %.9f %.9f %.9f\n", x[0], x[1], x[2],
        sin(7 * x[0]) * cos(6 * x[1]) + x[2] * x[2] } }' > $DIR/cloud
build/tess -q -validate -outside nearest -method nearest,linear,natural,smooth \
    $DIR/cloud > $DIR/errors
# slice METHOD FILE OPTIONS
slice() {
    method=$1
    file=$DIR/$2
    shift 2
    build/tess -q -outside nearest -method "$method" -range -.8,1.2 "$@" \
        -grid 161,161,1,.1,.9,.1,.9,.5,.5 -values "$file" $DIR/cloud
}
{
    echo '<svg xmlns="http://www.w3.org/2000/svg" width="1082" height="285"'
    echo 'viewBox="0 0 1082 285" font-family="Helvetica,Arial,sans-serif"'
    echo 'font-size="17" text-anchor="middle" fill="#767c85">'
    x=0
    for method in nearest linear natural smooth; do
        slice $method $method.svg -bare -size 240,240
        echo "<svg x=\"$x\" width=\"240\" height=\"240\""
        echo 'viewBox="0 0 2400 2400">'
        sed '1d; $d' $DIR/$method.svg
        echo "</svg><text x=\"$((x + 120))\" y=\"256\">$method</text>"
        echo "<text x=\"$((x + 120))\" y=\"277\" font-size=\"15\">"
        awk -v method=$method '$1 == method { printf "rms error %.2g", $5 }' \
            $DIR/errors
        echo '</text>'
        x=$((x + 253))
    done
    echo "<svg x=\"$x\" width=\"75\" height=\"240\""
    echo 'viewBox="2350 0 750 2400">'
    echo '<g text-anchor="start">'
    slice smooth whole.svg -size 340,240
    sed -n '/<g class="bar">/,/<\/g>/p' $DIR/whole.svg
    echo '</g></svg></svg>'
} | lines methods.svg

# ---- shell.svg: where the grade between drill holes is 1 ----

build/tess -q -cols east,north,rl,au -nodata -99 -below 0.5 -iso-closed \
    -iso 1 $DIR/shell.obj test/data/holes.csv
${PYTHON:-python3} test/pictures/shell.py test/data/holes.csv $DIR/shell.obj \
    $HERE/shell.svg
