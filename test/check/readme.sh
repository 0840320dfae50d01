# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# readme.sh - the READMEs' programs and commands.

# The READMEs' programs and commands, exactly as printed there, in build/readme,
# where what they need is; what they say is printed is what build/tess proves.
desk() {
    mkdir -p build/readme
    for f in Makefile tess.c tess.h hhpred.c hhpred.h f77 test build; do
        [ -e build/readme/$f ] || ln -s ../../$f build/readme
    done
    # (that a command compiles what it says does not depend on -O3)
    quick_compiler cc "$CC" "-O0 -fno-lto"
    quick_compiler gfortran gfortran "-O0 -fno-lto"
}

# quick_compiler NAME CC FLAGS: build/bin/NAME, that compiler with FLAGS last.  (By
# its path: build/bin comes first where it is used.)
quick_compiler() {
    mkdir -p build/bin
    words=
    case $2 in *" "*) words=${2#* };; esac
    printf '#!/bin/sh\nexec %s %s "$@" %s\n' "$(command -v ${2%% *})" \
        "$words" "$3" > build/bin/$1
    chmod +x build/bin/$1
}

# fenced LANGUAGE: the README's program in it
fenced() { sed -n '/^```'$1'$/,/^```$/p' README.md | sed '/^```/d'; }

# commands WORD [FILE]: lines of four blanks with that word
commands() {
    sed '/^```/,/^```$/d' "${2:-README.md}" | grep '^    [^ ]' | grep "$1"
}

# runs WHAT COMMANDS: what they print is in $PRINTED.  (make has this compiler)
runs() {
    echo "$2" | sed "s|^ *make python|make -s 'CC=$CC' CFLAGS=-O1 python|
        s|^ *make\( [^-]\|\$\)|make -s 'CC=$CC' 'CFLAGS=$CFLAGS'\1|" \
        > build/readme/commands
    PRINTED=$( (cd build/readme && grep -q . commands &&
        PATH=$(pwd)/../bin:$PATH sh -e commands) 2>> $LOG)
    check "the README's $1: its commands" test $? -eq 0
}

# said TEXT [FILE]: the README says that it is printed.  (As words: FORTRAN puts
# blanks before numbers.)
said() {
    file=${2:-README.md}
    # shellcheck disable=SC2086
    set -- $1
    tr '\n' ' ' < $file | grep -q -F -e "rints \`$*\`" -e "rints \`$*'"
}

# reads NAME PROGRAM: it counts lines that are no points, a heading, a number of
# points and another one's line; too many points are said
reads() {
    { echo x,y,z; sed 's/^#/980/' test/data/mirror.xyz; echo "p 1 2 3"; } \
        > build/readme/others
    prints $1 "980 points, 7 other lines: code 0," $2 build/readme/others
    awk 'BEGIN { while (n++ < 4001) print n, n * n % 97, n * n % 89 }' \
        > build/readme/many
    prints $1 "more than" $2 build/readme/many
    sed 1d build/readme/many > build/readme/most
    prints $1 "4000 points, 0 other lines: code 0," $2 build/readme/most
}

# prints NAME WORDS PROGRAM FILE: fed with the file the program prints these words
prints() {
    words=$($3 < $4 2>&1 | tr -s ' \012' ' ')
    check "the README's $1: $2 ($(basename $4))" \
        sh -c 'echo "$1" | grep -F "$2"' sh "$words" "$2"
}

# outside: tess.h's lines on places outside the hull, in a program
outside() {
    {
        echo '#include "tess.h"'
        echo 'int main(void) {'
        echo '  static tess_real p[12] = {0,0,0, 1,0,0, 0,1,0, 0,0,1};'
        echo '  static tess_real q[9] = {0.25,0.25,0.25, 1,1,1, 0,0.5,0};'
        echo '  static double value[4] = {0,4,0,0}, out[3], rw[TESS_LRW(4)];'
        echo '  static tess_int tet[32], adj[32], iw[TESS_LIW(4)], t[3];'
        echo '  tess_int i, ntet, nq = 3;'
        echo '  double outside = -7.0;'
        echo '  int code = tess(4, p, 8, &ntet, tet, adj, TESS_LIW(4), iw,'
        echo '    TESS_LRW(4), rw);'
        sed -n 's/^ \* //;/^    for .* t\[i\] = TESS_NONE/,/^ \*$/p' tess.h |
            sed '/\*/d'
        echo '  return !(code == 1 && out[0] == 1.0 && out[1] == -7.0 &&'
        echo '    out[2] == 0.0); }'
    } > build/outside.c
    check "tess.h's lines on places outside" sh -c "$CC $1 -I. \
        -o build/outside build/outside.c build/tess.o build/hhpred.o $LIBS &&
        build/outside"
}

# meshes: tess.h's two programs, of lengths known when they are compiled and at
# run time: a lattice, and a curve that has more tetrahedra than the first guess
meshes() {
    sed 's/^ \* \{0,1\}//' tess.h > build/manual.txt
    {
        sed -n '/^    #include <stdlib.h>$/,/^    }$/s/^    //p' build/manual.txt
        cat << 'END'
static int proven(tess_int n, const tess_real *x, int code, tess_int least)
{
    static tess_int work[2000];
    tess_int ntet, *t, *a, bad;
    int wrong = mesh(n, x, &ntet, &t, &a) != code || ntet < least ||
                (code == 0 && tess_check(n, x, ntet, t, a, 2 * n, work, &bad));

    free(t);
    free(a);
    return wrong;
}
END
        sed -n '1,/^    }$/s/^    \([^ ].*\|  .*\)/\1/p' build/manual.txt |
            sed 's/ mesh(/ fixed(/'
        cat << 'END'
int main(void)
{
    int i, wrong;

    for (i = 0; i < 1000; i++) {
        p[3 * i] = (tess_real)(i % 10);
        p[3 * i + 1] = (tess_real)(i / 10 % 10);
        p[3 * i + 2] = (tess_real)(i / 100);
    }
    wrong = proven(1000, p, 0, fixed(1000)) || fixed(1000) < 5 * 729 ||
            proven(0, p, TESS_POINT, 0) || proven(8, p, TESS_LINE, 0);
    for (i = 0; i < 100; i++) {
        p[3 * i] = (tess_real)i;
        p[3 * i + 1] = (tess_real)(i * i);
        p[3 * i + 2] = (tess_real)(i * i * i);
    }
    return wrong || proven(100, p, 0, 98 * 97 / 2);
}
END
    } > build/meshes.c
    check "tess.h's programs" sh -c "$CC $1 -I. -o build/meshes build/meshes.c \
        build/tess.o build/hhpred.o $LIBS && ulimit -t 20 && build/meshes"
}

# c_programs: the README's first program, and first.c
c_programs() {
    strict=
    have "$CC" "$STRICT" && strict=$STRICT
    outside "$strict"
    meshes "$strict"
    group "the README's " || return
    desk
    fenced c > build/readme/cube.c
    runs cube.c "$(sed -n 's/.* after `\(cc [^`]*\)`.*/\1/p' README.md)"
    check "the README's cube.c: prints what is said" said "$PRINTED"
    runs first.c "$(commands first | grep -v gfortran)"
    check "the README's first.c: prints what is said" said "$PRINTED"
    reads first.c build/readme/first
}

# f_program: the README's program in FORTRAN; first.f, by the manual's command.
# (Its arrays are not on the stack.)
f_program() {
    group "the README's first.f: " || return
    desk
    fenced fortran > build/readme/cube.f
    runs cube.f "$(commands cube; echo ./cube)"
    check "the README's cube.f: prints what is said" said "$PRINTED"
    runs first.f "$(commands "first\.f\|first <" f77/README)"
    check "the README's first.f: prints what is said" said "$PRINTED" f77/README
    reads first.f build/readme/first
    sed 's/MAXN = 4000/MAXN = 200000/' f77/first.f > build/large.f
    rm -f build/large
    compiled
    gfortran -O1 -frecursive -o build/large build/large.f build/ftess.o \
        build/fhhpred.o >> $LOG 2>&1
    awk 'BEGIN { for (srand(1); n++ < 200000;) print rand(), rand(), rand() }' \
        > build/readme/200000
    prints first.f "200000 points, 0 other lines: code 0," \
        "small_stack build/large" build/readme/200000
}

# tries: what the README says to try, with a file of such columns
tries() {
    says=$(sed -n 's/.*rints `[^`]*: \(code [^`]*\)`.*/\1/p' README.md)
    if [ ! -x build/tess ]; then
        skip "the README's commands: no build/tess"
        return
    fi
    count=$(build/tess -check test/data/mirror.xyz 2>> $LOG |
        sed -n 's/^tetrahedra *//p')
    check "the README's first.c: what build/tess proves" \
        test "$says" = "code 0, $count tetrahedra"
    group "the README's commands" || return
    desk
    awk 'BEGIN { srand(1); print "lon,lat,depth,hole,t"
        while (n++ < 400) printf "%.3f,%.3f,%d,%d,%.2f\n", 10 + rand(),
            50 + rand(), 500 * rand(), n % 20, 20 * rand() }' \
        > build/readme/mine.csv
    rm -f build/readme/out.* build/readme/shell.stl build/readme/blocks.csv \
        build/readme/rocks.csv build/*.svg build/mirror.xyz.vtk build/mirror.vtk
    runs "commands to try" \
        "$(commands '^    make *\(#.*\)\{0,1\}$\|make run\|make grid\|build/tess')"
    # what both of its lines say, of the mirror
    kept=$(echo "$PRINTED" |
        sed -n "s/^tetrahedra *\([0-9]*\) in the alpha shape, of $count\$/\1/p")
    check "the README's commands: the mirror's tetrahedra" sh -c "tr '\n' ' ' \
        < README.md | grep 'of all $count tetrahedra .*, the $kept tetrahedra of '"
    for f in mirror.xyz.svg mirror.xyz.vtk mirror.svg mirror.vtk mine.csv.svg \
        mine.csv.vtk readme/out.vtk; do
        check "the README's commands: $f" test -s build/$f
    done
    check "the README's commands: a shell" sh -c "tail -n 1 \
        build/readme/shell.stl | grep '^endsolid'"
    # the grid's places have values, those in the points' hull numbers
    check "the README's commands: values" \
        grep -a '^POINT_DATA 22500$' build/readme/out.vtk
    check "the README's commands: values in a table" awk -F , '
        NR > 1 && $5 == "nan" { out++ }
        NR > 1 && $5 >= 0 && $5 <= 20 { within++ }
        END { exit !(out && within && out + within == 22500) }' \
        build/readme/out.csv
    fenced text > build/readme/table
    echo "$PRINTED" > build/readme/printed
    check "the README's commands: the shell is closed" grep \
        '^level  *1 of AU: .*; closed, volume .* above it$' build/readme/printed
    check "the README's commands: the table of errors" sh -c "
        test -s build/readme/table &&
        ! grep -Fxvf build/readme/printed build/readme/table"
    # blocks of 20, 20, 10 from a corner on, not one without a value or beyond
    # the data's range by more than a rounding, no two the same, some left out
    check "the README's commands: a block model" awk -F , '
        NR == 1 { bad = $0 != "EAST,NORTH,RL,AU"; next }
        ($1 - 452010) % 20 || ($2 - 6781010) % 20 || ($3 - 25) % 10 ||
            $1 < 452000 || $1 > 452560 || $2 < 6781000 || $2 > 6781380 ||
            $3 < 20 || $3 > 310 || !($4 > 0.025 - 1e-16 && $4 <= 6) ||
            seen[$1, $2, $3]++ { bad = 1 }
        END { exit bad || NR < 1000 || NR > 28 * 19 * 29 }' build/readme/blocks.csv
    one_of='^[0-9]*,[0-9]*,[0-9]*,\(SAPROLITE\|LIMESTONE\|GRANITE\|SKARN\)$'
    check "the README's commands: a model of rocks" sh -c "
        head -n 1 build/readme/rocks.csv | grep -x EAST,NORTH,RL,LITH &&
        ! sed 1d build/readme/rocks.csv | grep -v '$one_of' &&
        test \$(sed 1d build/readme/rocks.csv | cut -d , -f 4 | sort -u |
            wc -l) -eq 4"
    # each command that is printed is one of those above, or below
    commands '' | grep -v -e '^    make *\(#.*\)\{0,1\}$' \
        -e 'make run\|make grid\|build/tess\|cube\|first' > build/readme/untested
    check "the README's commands: each is tested" \
        test ! -s build/readme/untested
}

# pip: of $PYTHON, without a network; what NumPy it finds is not looked at
pip() {
    PIP_NO_INDEX=1 PIP_NO_DEPS=1 PIP_DISABLE_PIP_VERSION_CHECK=1 \
        PIP_ROOT_USER_ACTION=ignore CC=cc1 PATH="$(pwd)/build/bin:$PATH" \
        $PYTHON -m pip "$@"
}

# has_pip: can it build tess89?
has_pip() {
    $PYTHON -m pip --version >> $LOG 2>&1 && $PYTHON -c '
import setuptools
assert int(setuptools.__version__.split(".")[0]) > 60
try: import setuptools.command.bdist_wheel
except ImportError: import wheel' 2>> $LOG
}

# snakes: the README's program in Python, and first.py
snakes() {
    if ! wanted "example: first.py" && ! group "the README's Python"; then
        return
    elif ! command -v $PYTHON > /dev/null; then
        skip "example: first.py: no python3"
        return
    elif ! $CC -shared -fPIC -o build/shared.so hhpred.c $LIBS 2>> $LOG; then
        skip "example: first.py: no -shared -fPIC"
        return
    fi
    desk
    runs Python "$(grep -o '`make python`' README.md | tr -d '`')"
    check "example: first.py" test "$($PYTHON test/samples/first.py)" = "$says"
    if ! $PYTHON -c 'import numpy' 2>> $LOG; then
        skip "the README's Python: no numpy for $PYTHON"
        return
    fi
    # where it is installed, or as make python leaves it
    path=test/bindings/python
    if has_pip; then
        rm -rf build/readme/python
        path=python
        grep -o '`pip install [^`]*`' README.md | tr -d '`' |
            sed "s|^pip |$PYTHON -m pip |" > build/readme/commands
        check "the README's Python: its commands" sh -c "cd build/readme &&
            test -s commands && PATH='$(pwd)/build/bin':$PATH CC=cc PIP_NO_INDEX=1 PIP_NO_DEPS=1 \
            PIP_ROOT_USER_ACTION=ignore PIP_TARGET=python sh -e commands"
    else
        skip "the README's Python: no pip with setuptools for $PYTHON"
    fi
    fenced python > build/readme/mine.py
    place=$(sed -n 's/.* f(\[\(.*\)\]).*/\1/p' build/readme/mine.py)
    echo "$place" > build/readme/place
    # what it prints, as its comment says; and what build/tess gives there
    PRINTED=$(cd build/readme && PYTHONDONTWRITEBYTECODE=1 \
        PYTHONPATH=$path $PYTHON mine.py 2>> ../../$LOG)
    check "the README's Python: prints what is said" test -n "$PRINTED" -a \
        "$PRINTED" = "$(sed -n 's/^print.* # //p' build/readme/mine.py)"
    check "the README's Python: what build/tess gives" test "$PRINTED" = \
        "$count [$(build/tess -q -method smooth -query build/readme/place \
        -values - test/data/mirror.xyz | awk -F , '{ v = $4 }
            END { printf "%.3f", v }')]"
}

readme() {
    wanted "tess.h's sizes" && unit usual "$CC" "$CFLAGS" t_size
    check "tess.h's sizes" sh -c 'build/units/usual/t_size -bytes |
        grep . > build/bytes.txt && sed "s/^ \*//" tess.h | tr -s "\012 " "  " |
        grep -F "`cat build/bytes.txt`"'
    c_programs
    tries
    snakes
}
