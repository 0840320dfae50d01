#!/bin/sh
# t_outputs.sh - tests of what build/tess does to files: nothing to an input,
# and to an output nothing but to replace it by the whole new one.
#
# Run from the top directory, after `make'.  Each test is one of all options and
# endings of a file to write, and, of what files are, of two builds: that for
# POSIX systems, and that for others, which know names alone.  Ends with
# `outputs: N passed, M failed'.
# shellcheck disable=SC2034 # of common.sh
NAME=outputs
. test/cli/t/common.sh

# What is linked to the program's files instead of its own: calls that write are
# counted; AT=N: at that one the signal SIGNAL comes, COUNT=yes: how many there
# are; those behind an error may be few; there is room for ROOM bytes.
cat > meddle.c << 'END'
#define _XOPEN_SOURCE 600
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/statvfs.h>
#define FEW 2000
int program(int argc, char **argv);
int count_putc(int c, FILE *file);
int count_printf(FILE *file, const char *format, ...);
size_t count_fwrite(const void *a, size_t size, size_t n, FILE *file);
static long calls, late, at;
static int which;
static long given(const char *name)
{
    return getenv(name) ? atol(getenv(name)) : 0;
}
static void call(FILE *file)
{
    if (file == stdout || file == stderr) return;
    if (++calls == at) raise(which);
    if (ferror(file) && ++late > FEW) {
        fprintf(stderr, "goes on behind an error\n");
        exit(9);
    }
}
int count_putc(int c, FILE *file)
{
    call(file);
    return putc(c, file);
}
int count_printf(FILE *file, const char *format, ...)
{
    va_list list;
    int n;
    call(file);
    va_start(list, format);
    n = vfprintf(file, format, list);
    va_end(list);
    return n;
}
size_t count_fwrite(const void *a, size_t size, size_t n, FILE *file)
{
    call(file);
    return fwrite(a, size, n, file);
}
int room(const char *folder, struct room *v)
{
    (void)folder;
    memset(v, 0, sizeof *v);
    v->f_blocks = 1;
    v->f_frsize = 1000;
    v->f_bavail = (fsblkcnt_t)(getenv("ROOM") ? given("ROOM") / 1000 : 999999999);
    return 0;
}
int main(int argc, char **argv)
{
    int code;
    which = (int)given("SIGNAL");
    at = given("AT");
    /* (a shell's background processes ignore them) */
    signal(SIGINT, getenv("IGNORED") ? SIG_IGN : SIG_DFL);
    signal(SIGQUIT, SIG_DFL);
    code = program(argc, argv);
    if (getenv("COUNT")) fprintf(stderr, "%ld calls\n", calls);
    return code;
}
END
OBJECTS=$(objects 'driver|write|places|shapes|validate|draw|page|slice')
MEDDLE="-Dputc=count_putc -Dfprintf=count_printf -Dfwrite=count_fwrite
    -Dstatvfs=room"
# build NAME FLAGS
build() {
    # shellcheck disable=SC2086 # lists
    (cd "$TOP" && for f in write places shapes validate draw/draw draw/page \
        draw/slice driver; do
        $CC -O1 $2 $MEDDLE -Dmain=program -I. \
            -c -o "build/outputs/$1-${f##*/}.o" test/cli/src/$f.c || exit
    done && $CC -O1 -Dstatvfs=room -c -o build/outputs/$1.o \
        build/outputs/meddle.c && $CC -o build/outputs/$1 build/outputs/$1.o \
        build/outputs/$1-*.o $OBJECTS build/tess.o build/hhpred.o -lm)
}
yes "the build for POSIX systems" build posix ""
yes "the build for others" build plain "-U__unix__ -U__APPLE__"
[ -x posix ] && [ -x plain ] || ended outputs || exit

# The points, places, and all files that can be written of them (@ is a blank
# before what an option has besides)
awk 'BEGIN { srand(3); print "x,y,z,T,U"
    for (i = 0; i < 60; i++)
        print rand() "," rand() "," rand() "," i "," i * i }' > points
awk 'BEGIN { srand(5); for (i = 0; i < 9000; i++) print rand(), rand(), rand() }
    ' > places
cat > all << 'END'
-mesh vtk
-mesh vtu
-mesh msh
-mesh node
-mesh ele
-mesh neigh
-face face
-face obj
-face off
-face ply
-face stl
-face vtk
-face vtu
-iso@20,30 stl
-iso@20,30 obj
-iso@20 ply
-iso@20 vtk
-vtk vtk
-node node
-ele ele
-neigh neigh
-cells vtk
-volumes csv
-faces csv
-svg svg
-values csv -grid 9,9,1
-values npy -grid 9,9,1
-values vtu -grid 9,9,1
-values vtk -grid 9,9,1
-values svg -grid 9,9,1
-values csv -query places
-values npy -query places
-values vtu -query places
-errors csv -validate
END
# (each that there is: the options with F, and the endings of options.c)
sed -n 's/^ *{"\(-[a-z]*\)", "\(.* \)*F[.a-z]*", take_[ol].*/\1/p' \
    "$TOP/test/cli/src/options.c" | sort > there
cut -d' ' -f1 all | cut -d@ -f1 | sort -u | cmp - there
yes "all options that write a file" test $? -eq 0
sed -n '/^const form values_forms/,/^const form svg_forms/p' \
    "$TOP/test/cli/src/options.c" | grep -o '"\.[a-z]*"' | tr -d '".' |
    sort -u > there
cut -d' ' -f2 all | sort -u | cmp - there
yes "all endings" test $? -eq 0

# files: what there is
files() { cksum -- * d/* 2> /dev/null | egrep -v ' (said|told|before|after)$'; }
# refused WORDS COMMAND...: exit code 2, one line on standard error that says
# WORDS, nothing on standard output, and no file is another one
refused() {
    words=$1
    shift
    files > before
    "$@" > said 2> told
    code=$?
    files > after
    if [ $code -ne 2 ] || [ -s said ] || [ "$(wc -l < told)" -ne 1 ] ||
        ! grep -e "$words" told > /dev/null || ! cmp -s before after; then
        echo "        $*: code $code: $(cat told)$(diff before after)"
        return 1
    fi
}

# ---- an input ----

mkdir -p d
ln -s d sd 2> /dev/null
# over OPTION ENDING OPTIONS: as an output the input is refused, by whatever name
over() {
    option=$(echo "$1" | tr @ ' ')
    f=input.$2
    shift 2
    cp points $f && cp points d/$f && cp points out.$f.part || return
    for other in $f ./$f "$(pwd)/$f" d/../$f; do
        refused "^tess: $f: would overwrite the input$" \
            $TESS "$@" $option $f "$other" || return
        refused ": would overwrite the input$" \
            $TESS "$@" $option "$other" $f || return
    done
    refused "would overwrite the input, out.$f.part$" \
        $TESS "$@" $option out.$f out.$f.part || return
    refused "would overwrite the input, .*d/../out.$f.part$" \
        $TESS "$@" $option d/../out.$f out.$f.part
    code=$?
    rm -f $f d/$f out.$f.part
    return $code
}
# by links, and as what is open
linked() {
    option=$(echo "$1" | tr @ ' ')
    f=input.$2
    shift 2
    cp points $f && cp points d/$f && cp points out.$f.part &&
        ln -sf $f link && ln -sf $f link.$f || return
    refused "^tess: $f: would overwrite the input$" \
        $TESS "$@" $option $f link || return
    refused "^tess: sd/$f: would overwrite the input$" \
        $TESS "$@" $option sd/$f d/$f || return
    refused "^tess: link.$f: would overwrite the input$" \
        $TESS "$@" $option link.$f $f || return
    refused "^tess: $f: would overwrite the input$" \
        sh -c "$TESS $* $option $f < $f" || return
    refused "^tess: $f: would overwrite the input$" \
        sh -c "$TESS $* $option $f - < $f" || return
    refused "would overwrite the input, out.$f.part$" \
        sh -c "$TESS $* $option out.$f < out.$f.part" || return
    refused "standard output or error would overwrite the input$" \
        sh -c "$TESS $* $option - $f >> $f" || return
    refused "standard output or error would overwrite the input$" \
        sh -c "$TESS $* $option other.$f >> $f < $f" || return
    refused "standard output goes there, too" \
        sh -c "$TESS $* $option $f points >> $f" || return
    [ ! -d /dev/fd ] || refused "/dev/fd/4: is a symbolic link" \
        sh -c "$TESS $* $option /dev/fd/4 points 4>> $f" || return
    [ ! -d /dev/fd ] || refused "/dev/fd/0: would overwrite the input" \
        sh -c "$TESS $* $option /dev/fd/0 < $f" || return
    rm -f $f d/$f out.$f.part link link.$f
}
for TESS in ./posix ./plain; do
    while read -r option ending rest; do
        # shellcheck disable=SC2086 # words
        yes "$TESS $option F.$ending $rest: never over the input" \
            over $option $ending $rest
    done < all
done
TESS=./posix
if [ -h sd ]; then
    while read -r option ending rest; do
        # shellcheck disable=SC2086 # words
        yes "$option F.$ending $rest: nor by a link or what is open" \
            linked $option $ending $rest
    done < all
fi
# places
for TESS in ./posix ./plain; do
    for end in csv npy vtu; do
        cp places p.$end
        yes "$TESS -values p.$end: never over the places" refused \
            'would overwrite the places$' $TESS -query p.$end -values d/../p.$end \
            points
    done
done
TESS=./posix
yes "never over places that are open" refused 'would overwrite the places$' \
    sh -c "$TESS -query - -values p.csv points < p.csv"

# ---- two outputs ----

# twice OPTION ENDING OPTIONS
twice() {
    option=$(echo "$1" | tr @ ' ')
    f=out.$2
    shift 2
    for other in $f ./$f "$(pwd)/$f" d/../$f $3; do
        refused 'the name of two outputs$' \
            $TESS "$@" $option $f $option "$other" points || return
        refused 'the name of two outputs$' \
            $TESS "$@" $option "$other" $option $f points || return
        echo old > $f
        refused 'the name of two outputs$' \
            $TESS "$@" $option $f $option "$other" points || return
        rm $f
    done
    echo another > d/../$f.part
    refused "$f.part is there, of another run, perhaps: remove it" \
        $TESS "$@" $option $f points || return
    rm $f.part
}
for TESS in ./posix ./plain; do
    while read -r option ending rest; do
        # shellcheck disable=SC2086 # words
        yes "$TESS $option F.$ending $rest: not twice, nor over F.part" \
            twice $option $ending $rest
    done < all
    yes "$TESS: two options' outputs" refused 'the name of two outputs$' \
        $TESS -o d/o -node d/../d/o.node points
    yes "$TESS: standard output twice" refused 'the name of two outputs$' \
        $TESS -ele - -node - points
    $TESS -node /dev/null -ele /dev/null points > said 2> told
    yes "$TESS: /dev/null as often as you like" test $? -eq 0
done
if [ -h sd ]; then
    yes "two outputs by a link" refused 'the name of two outputs$' \
        ./posix -node d/o.node -mesh sd/o.node points
fi

# ---- stopped ----

# stopped CODE OPTION ENDING OPTIONS: as the signal SIGNAL comes, whenever it
# does, no file is another one
stopped() {
    right=$1
    option=$(echo "$2" | tr @ ' ')
    f=stopped.$3
    shift 3
    rm -f $f
    COUNT=yes $TESS -q "$@" $option $f points 2> told || return
    calls=$(sed -n 's/ calls$//p' told)
    [ "$calls" -gt 3 ] || return
    echo old > $f
    files > before
    for AT in 1 2 $((calls / 3)) $((2 * calls / 3)) "$calls"; do
        # shellcheck disable=SC3045 # where there is no -c there is a core
        (export AT SIGNAL; ulimit -c 0 2> told; exec $TESS -q "$@" $option $f points) \
            > said 2>&1
        code=$?
        files > after
        [ $code -eq $right ] && cmp before after && continue
        echo "call $AT of $calls: code $code, not $right: $(cat said)"
        return 1
    done
}
for TESS in ./posix ./plain; do
    SIGNAL=2
    while read -r option ending rest; do
        # shellcheck disable=SC2086 # words
        yes "$TESS $option F.$ending $rest: Ctrl-C leaves nothing" \
            stopped 130 $option $ending $rest
    done < all
    for SIGNAL in 1 3 13 15; do
        yes "$TESS: nor does signal $SIGNAL" \
            stopped $((128 + SIGNAL)) -mesh vtk
    done
    SIGNAL=2
    AT=99 IGNORED=yes $TESS -q -node ignored.node points
    yes "$TESS: a signal that is ignored" test $? -eq 0 -a -s ignored.node
done

# ---- a disk that is full ----

# full OPTION ENDING OPTIONS: then it ends at once, and nothing is there
full() {
    option=$(echo "$1" | tr @ ' ')
    f=full.$2
    shift 2
    echo old > $f
    (trap '' XFSZ; ulimit -f 1; exec $TESS -q "$@" $option $f large) > said 2> told
    code=$?
    if [ $code -ne 2 ] || [ "$(cat $f)" != old ] || [ -f $f.part ] ||
        ! grep "^tess: $f: \(write error$\|no room for a temporary\)" told; then
        echo "code $code: $(cat told)"
        return 1
    fi
    rm $f
    [ -c /dev/full ] || return 0
    $TESS -q "$@" $option /dev/full large > said 2> told
    code=$?
    grep '^tess: /dev/full: write error$' told && [ $code -eq 2 ] && return
    echo "/dev/full: code $code: $(cat told)"
    return 1
}
awk 'BEGIN { srand(4); print "x,y,z,T,U"
    for (i = 0; i < 3000; i++)
        print rand() "," rand() "," rand() "," i "," i * i }' > large
for TESS in ./posix ./plain; do
    while read -r option ending rest; do
        rest=$(echo "$rest" | sed 's/9,9,1/99,99,1/')
        # shellcheck disable=SC2086 # words
        yes "$TESS $option F.$ending $rest: a full disk ends it" \
            full $option $ending $rest
    done < all
done

# what cannot have its name stays, and is whole
./posix -q -node right.node points
for TESS in ./posix ./plain; do
    mkfifo fifo
    $TESS -q -node rename.node fifo > said 2> told &
    exec 4> fifo
    mkdir rename.node
    echo kept > rename.node/kept
    cat points >&4
    exec 4>&-
    wait $!
    yes "$TESS: a directory has come: exit code 2" test $? -eq 2
    yes "$TESS: a directory has come: all is in the other file" \
        cmp right.node rename.node.part
    yes "$TESS: a directory has come: so it says" grep \
        "^tess: rename.node: .*; all that was to be in it is in rename.node.part" \
        told > /dev/null
    rm -rf rename.node rename.node.part fifo
done
# a file has come, which is another one's, perhaps
TESS=./posix
mkfifo fifo
$TESS -q -node meets.node fifo > said 2> told &
exec 4> fifo
echo another > meets.node.part
cat points >&4
exec 4>&-
wait $!
yes "a partial file has come: exit code 2" test $? -eq 2
yes "a partial file has come: it stays" test "$(cat meets.node.part)" = another
rm -f meets.node.part fifo

# what is closed is no file
./posix -node right.node points > said
for closed in '>&-' '2>&-' '>&- 2>&-'; do
    rm -f closed.node
    sh -c "./posix -node closed.node points $closed" > said 2> told
    yes "closed, $closed: messages do not go into the file" \
        cmp right.node closed.node
done
sh -c './posix -q -node - points >&-' > said 2> told
yes "closed standard output: exit code 2" test $? -eq 2

# ---- sizes ----

# before it reads anything
for TESS in ./posix ./plain; do
    for n in 1291:17213481 3000:216000000 30000:216000000000; do
        n=$n,$n,$n
        side=${n%%:*}
        yes "$TESS -grid $side,$side,$side: refused, with its size" refused \
            "[^0-9]$(echo "$n" | sed 's/.*://')[0-9]* bytes .* a column" \
            $TESS -grid $side,$side,$side -values big.npy nowhere
    done
done
TESS=./posix
# sized BYTES OPTIONS...: so many, to the thousand, are what it needs; for less
# it is refused before there is a mesh, and no file is another one
sized() {
    bytes=$1
    shift
    ROOM=$((bytes + 999))
    export ROOM
    $TESS -q "$@" points > said 2> told || { cat told; return 1; }
    rm -f v*.*
    ROOM=$((bytes - 1000))
    refused "$bytes bytes .* do not fit where" $TESS "$@" points
    code=$?
    unset ROOM
    return $code
}
yes "sizes: NumPy's" sized 2000000 -grid 5,50,500 -values v.npy
yes "sizes: VTK's" sized 2000000 -grid 5,50,500 -values v.vtk
yes "sizes: two files" sized 4000000 -grid 5,50,500 -values v.vtk -values v.npy
yes "sizes: NumPy's, of places" sized 144000 -query places -values v.npy
# (columns of text have at least two bytes)
ROOM=900000
export ROOM
yes "sizes: CSV" refused "1250000 bytes .* do not fit where" \
    $TESS -grid 5,50,500 -values v.csv points
yes "sizes: a .vtu file" refused "[0-9]* bytes .* do not fit where" \
    $TESS -grid 5,50,500 -values v.vtu points
ROOM=1000
for f in '-mesh f.vtk' '-mesh f.vtu' '-face f.vtu' '-cells f.vtk'; do
    # shellcheck disable=SC2086 # words
    yes "sizes: $f" refused "f.vt[ku]: [1-9][0-9]* bytes .* do not fit where" \
        $TESS -q $f points
done
unset ROOM
# what is large is said before the mesh is there
awk 'BEGIN { for (i = 0; i < 3; i++) print 2 * i, i, 3 * i, 7 }' > line
$TESS -q -grid 1000,1000,999 -values v.npy line > said 2> told
yes "sizes: gigabytes are said before there is a mesh" test "$(sed -n \
    '1s/.*\(v.npy: about .* GB\).*/\1/p; 2s/.*\(lie on one line\).*/\1/p' told |
    tr '\n' ' ')" = "v.npy: about 8.0 GB lie on one line "

# ---- what is stretched ----

yes "-scale: a grid beyond the range of numbers" refused \
    'Z1 = 1e+300 is beyond the range' $TESS -scale 1,1,1e100 -grid \
    2,2,2,0,1,0,1,0,1e300 -values v.npy points
printf '0 0 0\n0 0 1e300\n' > far
yes "-scale: a place beyond the range of numbers" refused \
    'place 2 is beyond the range' $TESS -q -scale 1,1,1e100 -query far \
    -values v.npy points

# ---- names, as they come back ----

cat > names << 'END'
"#x",y,"z, m","T, ""in""","a;b",c|d,"!e","/f","it's",50%,g
0,0,0,1,2,3,4,5,6,7,8
1,0,0,1,2,3,4,5,6,7,8
0,1,0,1,2,3,4,5,6,7,8
0,0,1,1,2,3,4,5,6,7,9
END
for f in '-grid 2,2,2 -outside nearest -values' \
    '-query names -qcols 1,2,3 -values' -volumes; do
    # shellcheck disable=SC2086 # words
    $TESS -q -cols 1,2,3 $f names.csv names > said 2> told
    yes "$f F.csv: names with marks" grep -qF \
        ',"T, ""in""","a;b","c|d","!e","/f",it'"'s,50%,g" names.csv
    # shellcheck disable=SC2086 # words
    $TESS -q -cols 1,2,3 $f again.csv names.csv > said 2> told
    yes "$f F.csv: names with marks, read back" grep -qF \
        ',"T, ""in""","a;b","c|d","!e","/f",it'"'s,50%,g" again.csv
done
if $PYTHON -c 'import csv' 2> told; then
    cat > names.py << 'END'
import csv
a, b = (next(csv.reader(open(name, newline=''))) for name in ('names', 'v.csv'))
assert a == b, (a, b)
END
    $TESS -q -cols 1,2,3 -grid 2,2,2 -values v.csv names
    yes "names with marks, read by Python" $PYTHON names.py
else
    skip "names with marks, read by Python: no $PYTHON"
fi

ended outputs
