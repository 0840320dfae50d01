#!/bin/sh
# package.sh - the library as it gets into other programs: files of different
# versions, limbs or types do not link; a shared library shows the public names
# alone; make install; names that Windows' headers take; the licence in each
# file.  Run from the top directory; ALL=yes: of all types, and by
# -flto, too.
. test/tests.sh
ALL=${ALL:-}
begin package
B=build/package
rm -rf $B
mkdir -p $B
LOG=$B/log
: > $LOG
HERE=$(pwd)
LIBRARY="tess.c tess.h hhpred.c hhpred.h f77/tess.f f77/hhpred.f f77/tess.f90"

# ---- the version, in each place ----

version=$(sed -n 's/^#define TESS_VERSION \([0-9]*\)L$/\1/p' tess.h)
major=$((version / 10000))
minor=$((version / 100 % 100))
patch=$((version % 100))
# name a digit of a FORTRAN name: 10 is A
digit() { printf '%s' "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ" | cut -c$(($1 + 1)); }
vname=HHV$(digit $major)$(digit $minor)$(digit $patch)
{
    grep "^#define HH_VERSION ${version}L\$" hhpred.h > $LOG || echo hhpred.h
    grep "^#if TESS_VERSION != ${version}L\$" tess.c > $LOG || echo tess.c
    grep "^#if HH_VERSION != ${version}L\$" hhpred.c > $LOG || echo hhpred.c
    grep "^      TESSED = $version\$" f77/tess.f > $LOG || echo TESSED
    grep "^      CALL $vname\$" f77/tess.f > $LOG || echo "CALL $vname"
    grep "^      SUBROUTINE $vname\$" f77/hhpred.f > $LOG || echo "$vname"
    grep "here $major\.$minor\.$patch," f77/hhpred.f > $LOG || echo "its text"
    grep "soname,libtess\.so\.$major " Makefile > $LOG || echo soname
    grep "version = {$major\.$minor}" README.md > $LOG || echo README.md
} > $B/out
empty "the version $version: the same everywhere, but for" $B/out

# ---- the licence, as people copy single files ----

words() { tr -cs 'A-Za-z0-9.,()"/-' ' '; }
licence=$(sed 1,2d LICENSE | words | sed 's/^ //; s/ $//')
for f in $LIBRARY; do
    sed 's/^C     / /; s/^ \*/ /; s/^!/ /; s/^C$//' $f | words > $B/words
    grep -F "$licence" $B/words > /dev/null &&
        grep -F "SPDX-License-Identifier: 0BSD" $f > /dev/null || echo $f
done > $B/out
[ -n "$licence" ] || echo LICENSE >> $B/out
empty "the licence: in each file of the library, but for" $B/out

# ---- files that do not belong together ----

# The caller makes a mesh, and asks for an exact sign.
cat > $B/caller.c << 'END'
#include <stddef.h>
#include "tess.h"
int main(void)
{
    static const tess_real p[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    static tess_int tet[32], adj[32], iw[TESS_LIW(5)], ntet;
    static double rw[TESS_LRW(5)];

    return tess(5, p, 8, &ntet, tet, adj, TESS_LIW(5), iw, TESS_LRW(5), rw) ||
           hh_orient(p, p + 3, p + 6, p + 9) != 1 ||
           tess_edition() != TESS_VERSION;
}
END
# of another version: the next patch
another() { sed "s/${version}L/$((version + 1))L/"; }
mkdir -p $B/next
for f in tess.c tess.h hhpred.c hhpred.h; do another < $f > $B/next/$f; done

# made NUMBER DIRECTORY FLAGS...: objects tessN.o, hhpredN.o and callerN.o
made() {
    number=$1
    from=$2
    shift 2
    # shellcheck disable=SC2086
    for f in tess hhpred; do
        $CC "$@" -c -o $B/$f$number.o $from/$f.c >> $LOG 2>&1 || return
    done
    $CC "$@" -I$from -c -o $B/caller$number.o $B/caller.c >> $LOG 2>&1
}
numbers="1 2 3 4 5"
made 1 . && made 2 $B/next && made 3 . -DHH_LIMBS=12 &&
    made 4 . -DTESS_FLOAT && made 5 . -DTESS_INT=long
check "linking: five builds compile" test $? -eq 0
if [ -n "$ALL" ]; then
    numbers="1 2 3 4 5 6 7 8 9"
    made 6 . -DTESS_INT=long -DTESS_FLOAT &&
        made 7 . -include stddef.h -DTESS_INT=ptrdiff_t &&
        made 8 . -DTESS_INT=short && made 9 . -DTESS_INT=short -DTESS_FLOAT
    check "linking: four more builds compile" test $? -eq 0
fi
# linked OBJECT...: 0 if they link; else is it for want of a name?
linked() {
    rm -f $B/program
    $CC -o $B/program "$@" -lm > $B/told 2>&1 && return
    cat $B/told >> $LOG
    egrep -i 'undefined|unresolved' $B/told > /dev/null || return 2
    return 1
}
number=0
for build in "this version" "the next version" "12 limbs" float long \
    "long and float" ptrdiff_t short "short and float"; do
    number=$((number + 1))
    case $numbers in *$number*) ;; *) break;; esac
    linked $B/caller$number.o $B/tess$number.o $B/hhpred$number.o &&
        $B/program
    check "linking: $build: with its own files" test $? -eq 0
    nm $B/tess$number.o $B/hhpred$number.o 2>> $LOG |
        sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort > $B/names$number
    cut -c1-6 $B/names$number | tr A-Z a-z | sort | uniq -d > $B/out
    [ -s $B/names$number ] || echo none >> $B/out
    empty "linking: $build: names unique in six characters, but for" $B/out
    for other in $numbers; do
        [ $other = $number ] && continue
        linked $B/caller$number.o $B/tess$number.o $B/hhpred$other.o
        [ $? -eq 1 ] || echo "hhpred.o of build $other"
        # (limbs and version are no matter of a caller: shared libraries live
        # longer than a patch)
        case $number$other in 12 | 13 | 21 | 23 | 31 | 32) continue;; esac
        linked $B/caller$number.o $B/tess$other.o $B/hhpred$other.o
        [ $? -eq 1 ] || echo "the library of build $other"
        # both in one program
        [ $other -gt $number ] || comm -12 $B/names$number $B/names$other
    done > $B/out
    empty "linking: $build: with no others, but for" $B/out
done
# and sources do not compile
for f in tess.c tess.h hhpred.c hhpred.h; do
    rm -rf $B/mixed
    mkdir $B/mixed
    for g in tess.c tess.h hhpred.c hhpred.h; do cp $g $B/mixed; done
    cp $B/next/$f $B/mixed
    # hhpred.c knows nothing of tess.*
    case $f in hhpred.*) g=hhpred.c;; *) g=tess.c;; esac
    ! $CC -E $B/mixed/$g > $B/mixed.i 2> $B/told &&
        grep "of different versions" $B/told > /dev/null
    check "another version's $f among these does not compile" test $? -eq 0
done

# ---- the same in FORTRAN ----

if ! command -v gfortran > /dev/null; then
    skip "linking FORTRAN: no gfortran"
else
    # limbs, by the manual's way; the version's name
    mkdir -p $B/f12 $B/fnext $B/f88
    for f in tess hhpred; do
        cp f77/$f.f $B/f88
        sed 's/HHLIM = 88/HHLIM = 12/; s/HHL088/HHL012/' f77/$f.f \
            > $B/f12/$f.f
        sed "s/$vname/HHV9ZZ/; s/TESSED = $version/TESSED = 93535/" f77/$f.f \
            > $B/fnext/$f.f
    done
    cat > $B/caller.f << 'END_OF_FILE'
      PROGRAM CALLER
      DOUBLE PRECISION P(3,5), RW(32)
      INTEGER TET(4,8), ADJ(4,8), IW(1895), NTET, INFO, TESSED
      DATA P /3*0D0, 1D0, 3*0D0, 1D0, 3*0D0, 4*1D0/
      CALL TESS(5, P, 8, NTET, TET, ADJ, 1895, IW, 32, RW, INFO)
      IF (INFO .NE. 0 .OR. TESSED() .EQ. 0) STOP 'WRONG'
      PRINT *, 'RIGHT'
      END
END_OF_FILE
    for lto in "" -flto; do
        [ -z "$lto" ] || [ -n "$ALL" ] || break
        for d in f88 f12 fnext; do
            for f in tess hhpred; do
                # shellcheck disable=SC2086
                gfortran -O0 $lto -frecursive -c -o $B/$d/$f.o $B/$d/$f.f \
                    >> $LOG 2>&1
            done
        done
        for d in f88 f12 fnext; do
            for e in f88 f12 fnext; do
                # (at link time it takes long: one of each)
                case $lto$d$e in -flto*f88*) ;; -flto*) continue;; esac
                rm -f $B/program
                # shellcheck disable=SC2086
                gfortran -O0 $lto -o $B/program $B/caller.f $B/$d/tess.o \
                    $B/$e/hhpred.o > $B/told 2>&1
                code=$?
                if [ $d = $e ]; then
                    $B/program 2>&1 | grep RIGHT > /dev/null || echo "$d alone"
                    continue
                fi
                [ $code -ne 0 ] && grep -i 'undefined.*hh[vl]' $B/told \
                    >> $LOG || echo "$d with $e"
            done
        done > $B/out
        empty "linking FORTRAN $lto: versions and limbs with their own alone" \
            $B/out
    done
fi

# ---- into a package ----

# (pkg-config takes no path with a blank)
PLACE=$(mktemp -d) && ln -s "$HERE/$B" "$PLACE/b" || exit
trap 'rm -rf "${PLACE%/b}"' EXIT
PLACE=$PLACE/b

# installed WORD...: make install, quietly, with a build/ of its own, which the
# next one takes, too, unless `fresh' is called between
fresh() {
    rm -rf $B/desk
    mkdir $B/desk
    for f in Makefile tess.c tess.h hhpred.c hhpred.h; do
        ln -s "$HERE/$f" $B/desk
    done
}
installed() {
    (cd $B/desk && make -s "CC=$CC" CFLAGS=-O0 CPPFLAGS= LDFLAGS= DESTDIR= \
        "$@" install) >> $LOG 2>&1
}
fresh
installed "DESTDIR=$HERE/$B/stage" PREFIX=/opt/t LIBDIR=/opt/t/lib64
check "make install DESTDIR=" test $? -eq 0
# (-h, not -e: a link is a name, too)
(cd $B/stage && find . ! -type d | sort) > $B/files
sort > $B/wanted << END
./opt/t/include/tess.h
./opt/t/include/hhpred.h
./opt/t/lib64/libtess.a
./opt/t/lib64/libtess.so
./opt/t/lib64/libtess.so.$major
./opt/t/lib64/pkgconfig/tess.pc
END
diff $B/wanted $B/files > $B/out
empty "make install: these files, and no others" $B/out
check "make install: no trace of DESTDIR" sh -c \
    "! grep -r stage $B/stage/opt/t/lib64/pkgconfig"
installed "PREFIX=$PLACE/usr"
check "make install PREFIX=" test $? -eq 0

# the public names: what the headers declare, to tess's own
{ sed '/---- for tess/,$d' hhpred.h; cat tess.h; } |
    sed -n 's/^\(TESS_API \)*[a-z_]* [*]*\([a-z_]*\)(.*/\2/p' | sort \
    > $B/public
if nm -D --defined-only $B/usr/lib/libtess.so > $B/nm 2>> $LOG; then
    sed -n 's/^.* [A-Z] \([A-Za-z_0-9]*\)$/\1/p' $B/nm | sort |
        diff $B/public - > $B/out
    [ "$(wc -l < $B/public)" -gt 15 ] || echo "too few" >> $B/out
    empty "libtess.so shows the public names alone" $B/out
    check "libtess.so: its soname" sh -c "objdump -p $B/usr/lib/libtess.so |
        grep -x ' *SONAME *libtess.so.$major' > /dev/null"
else
    skip "libtess.so: no nm -D"
fi

# first.c, found by pkg-config alone, in a directory that has no sources
if ! command -v pkg-config > /dev/null; then
    skip "make install: no pkg-config"
else
    mkdir -p $B/elsewhere
    cp test/samples/first.c $B/elsewhere
    PKG_CONFIG_PATH=$PLACE/usr/lib/pkgconfig
    export PKG_CONFIG_PATH
    # first NAME COMMAND: a command that makes build/package/elsewhere/first
    first() {
        rm -f $B/elsewhere/first
        (cd $B/elsewhere && eval "$2") >> $LOG 2>&1
        LD_LIBRARY_PATH=$PLACE/usr/lib $B/elsewhere/first \
            < test/data/mirror.xyz > $B/out 2>&1
        check "first.c by pkg-config, $1" cmp -s $B/out test/samples/first.out
    }
    first shared "$CC -o first first.c \$(pkg-config --cflags --libs tess)"
    check "first.c by pkg-config, shared: it is" sh -c \
        "LD_LIBRARY_PATH=$PLACE/usr/lib ldd $B/elsewhere/first | grep 'libtess\.so\.$major => $PLACE' >> $LOG"
    first static "$CC -static -o first first.c \
        \$(pkg-config --static --cflags --libs tess)"
    if command -v g++ > /dev/null; then
        first "from C++" "g++ -x c++ -o first first.c \
            \$(pkg-config --cflags --libs tess)"
    else
        skip "first.c by pkg-config, from C++: no g++"
    fi
    check "tess.pc: the version" test "$(pkg-config --modversion tess)" = \
        "$major.$minor.$patch"
    # a library of other types tells its callers
    if [ -n "$ALL" ]; then
        fresh
        installed "PREFIX=$PLACE/usr" "CPPFLAGS=-DTESS_FLOAT -DTESS_INT=long"
        # shellcheck disable=SC2046 # several words
        $CC -o $B/program $B/caller.c $(pkg-config --cflags --libs tess) \
            >> $LOG 2>&1 && LD_LIBRARY_PATH=$PLACE/usr/lib $B/program
        check "a caller by pkg-config, of float and long" test $? -eq 0
    fi
fi

# ---- names that Windows' headers take as macros ----

# some of those, as short as ours; all of them where mingw is to be had
taken="IN OUT OPTIONAL FAR NEAR far near small hyper huge pascal cdecl interface
    PLANES CONST VOID ERROR DELETE IGNORE INFINITE NO_ERROR STRICT TRUE FALSE
    BOOL min max CREATE_NEW ALTERNATE WINDING TRANSPARENT OPAQUE RELATIVE
    ABSOLUTE grp1 rad1 cmb1 ico1 psh1 edt1 stc1 lst1 CALLBACK WINAPI DIFFERENCE
    ESCAPE FAILED SUCCEEDED THIS TEXT SEVERITY_ERROR UNALIGNED RC_INVOKED"
mingw=x86_64-w64-mingw32-gcc
echo '#include <windows.h>' > $B/windows.c
{
    echo "$taken" | tr -s ' ' '\n'
    $mingw -E -dM $B/windows.c 2>> $LOG |
        sed 's/^#define \([A-Za-z0-9_]*\).*/\1/'
} | grep . | sort -u > $B/taken
echo '#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <stddef.h>
#include <limits.h>
#include <float.h>
#include <math.h>
#include <assert.h>' > $B/standard.c
{
    $CC -E -dM $B/standard.c | sed 's/^#define \([A-Za-z0-9_]*\).*/\1/'
    echo "EXIT_SUCCESS EXIT_FAILURE NULL EOF" | tr ' ' '\n'
} | sort -u > $B/standard
recipes=$(echo test/recipes/*.c)
for f in tess.c tess.h hhpred.c hhpred.h test/recipes/recipes.h $recipes; do
    # without comments and texts
    $CC -fpreprocessed -dD -E -P $f 2>> $LOG | sed 's/"[^"]*"//g' |
        tr -cs 'A-Za-z0-9_' '\n' | sort -u | comm -12 - $B/taken |
        comm -23 - $B/standard | sed "s,^,$f: ,"
done > $B/out
empty "names of windows.h in library, headers and recipes" $B/out
$CC -fpreprocessed -dD -E -P tess.c 2> /dev/null | grep TESS_LIST > /dev/null
check "names of windows.h: the files are read" test $? -eq 0
if command -v $mingw > /dev/null; then
    # (precompiled: it is long)
    $mingw -x c-header -o $B/windows.c.gch $B/windows.c >> $LOG 2>&1
    for f in tess.c hhpred.c $recipes; do
        $mingw -Wall -Wextra -Werror -include $B/windows.c -I. -fsyntax-only $f \
            >> $LOG 2>&1 || echo $f
    done > $B/out
    empty "behind windows.h all compile, but for" $B/out
    # a long has 4 bytes there: lengths must be those of tess_int
    echo '#include "tess.h"
typedef char right[TESS_LIW(300000000) / 1000 > 3000000 &&
                   TESS_LRW(900000000) / 1000 > 3000000 ? 1 : -1];' > $B/wide.c
    check "64-bit Windows: lengths for 300 million points" $mingw -I. \
        -include stddef.h -DTESS_INT=ptrdiff_t -Werror -c -o $B/w.o $B/wide.c
else
    skip "behind windows.h: no $mingw"
fi

ended
