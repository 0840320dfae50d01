# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# examples.sh - the examples and recipes; Octave, Python, CGAL, MPI.

# ---- the examples: their own checks, and their output as stored ----

# linked FILE: the files that a sample, or a recipe's test, is linked from, and
# libraries, as its first comment says; a recipe itself
linked() {
    case $1 in
    *.c) sed '/\*\/$/q' $1;;
    *) sed '/^[^C]/q' $1;;
    esac | tr ' ' '\012' | egrep \
        '^test/(recipes|samples)/[a-z_/]*[.][cf]$|^-l' |
        sort -ru | grep . || echo $1
}

# less_of FILE: the flags with which a sample or a test takes less, if it takes
# long, for all but -all
less_of() {
    case $1 in
    *stream*) echo -DN=100000L;;
    *t_slopes*) echo -DN=8000;;
    esac
}

examples() {
    for f in $(grep -l '^int main' test/samples/*.c test/recipes/t/*.c); do
        example=$(basename $f .c)
        case $example in calls_fortran) continue;; esac # with the FORTRAN half
        wanted "example: $example, its output" || continue
        fewer=
        [ -n "$ALL" ] || fewer=$(less_of $f)
        # recipes as they are used, and their tests as tests are
        recipes=$(linked $f | grep '^test/recipes/[a-z]*[.]c$')
        how=$CFLAGS
        case $f in test/recipes/*) how=$(harness "$CFLAGS");; esac
        # shellcheck disable=SC2046,SC2086 # lists of files, of flags
        if objects "$CC" "$CFLAGS" $recipes &&
            build "$example" "$CC" "$how -I. $fewer" build/tess.o \
            build/hhpred.o $f $OBJECTS $(linked $f | grep '^-l'); then
            (cd build && ./$example $example.obj $example.stl) \
                < test/data/mirror.xyz > build/$example.out 2>> $LOG
            check "example: $example, its code" test $? -eq 0
            [ "$fewer$example" = -DN=100000Lstream ] ||
                check "example: $example, its output" \
                cmp ${f%.c}.out build/$example.out
        else
            fail "example: $example does not compile"
        fi
    done
    # the threads of OpenMP
    group "example: team -fopenmp, " || return
    if have "$CC" -fopenmp; then
        # shellcheck disable=SC2046 # a list of files
        build team "$CC" "$CFLAGS -fopenmp -I." build/tess.o build/hhpred.o \
            $(linked test/samples/team.c)
        for threads in 1 2 4; do
            check "example: team -fopenmp, $threads threads" sh -c "
                OMP_NUM_THREADS=$threads build/team |
                    cmp - test/samples/team.out"
        done
    else
        skip "example: team -fopenmp"
    fi
}

# The recipes: all of them, and nothing but routines, in one program.
# routines PROGRAM MAIN: those files of test/recipes that have no main program
routines() {
    for f in test/recipes/*.$1; do
        grep "$2" $f > /dev/null || echo $f
    done
}

together() {
    group "recipes: " || return
    recipes=$(routines c '^int main')
    if ! have "$CC" "$STRICT -Wmissing-prototypes"; then
        skip "recipes: $CC does not take the flags"
        return
    fi
    H=test/recipes/recipes.h
    rm -rf build/recipes build/recipes1
    # the prototypes of recipes.h are those of the recipes, and all of them
    # shellcheck disable=SC2086
    compile "$CC" "$STRICT -Wmissing-prototypes -I." build/recipes $recipes
    check "recipes: strict C89, as recipes.h declares them" test $? -eq 0
    nm build/recipes/*.o > build/nm.txt
    grep ' [bBdDcCgGsS] ' build/nm.txt > build/data.txt
    empty "recipes: no data but constants" build/data.txt
    sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' build/nm.txt | sort > build/defined.txt
    for f in $recipes; do
        nm -u "build/recipes/$(basename $f .c).o" |
            sed -n 's/^.* U _*\([A-Za-z]\)/\1/p' | sort |
            comm -12 - build/defined.txt | while read -r name; do
                grep "^| .* | \[.*\](${f##*/}) | .* needs .*\`$name\`" \
                    test/recipes/README.md \
                    >> $LOG || echo "$f: $name"
            done
    done > build/calls.txt
    empty "recipes: what each calls its row in recipes/README.md has" \
        build/calls.txt
    for d in -DTESS_FLOAT -DTESS_INT=short -DTESS_INT=long; do
        [ -n "$ALL" ] || [ $d = -DTESS_FLOAT ] || break
        # shellcheck disable=SC2086
        check "recipes: strict C89 $d" compile "$CC" "$STRICT -Wdouble-promotion \
            -Wmissing-prototypes $d -I." build/recipes1 $recipes
        nm build/recipes1/*.o | sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort \
            > build/other.txt
        check "recipes: no name is the same: $d" sh -c "test -s build/other.txt &&
            ! comm -12 build/defined.txt build/other.txt | grep ."
        check "recipes: names begin with tr_: $d" sh -c \
            "! grep -v '^tr_' build/other.txt"
    done
    { echo "#include \"$H\""
      echo 'typedef void (*routine)(void);'
      echo 'int main(void) { static const routine all[] = {'
      sed -n 's/^[a-z][a-z_ ]* [*]*\([a-z_0-9]*\)(.*/(routine)\1,/p' $H
      echo '0}; return all[0] == 0; }'; } > build/together.c
    check "recipes: one program" sh -c "$CC -I. -o build/together \
        build/together.c build/recipes/*.o build/tess.o build/hhpred.o $LIBS &&
        build/together"
    have g++ "-x c++" || return
    # shellcheck disable=SC2086
    check "recipes: C++" compile g++ "-x c++ -Wall -Wextra -Wconversion -Werror \
        -Wmissing-declarations -I." build/recipes $recipes
    check "recipes: one program in C++" sh -c "g++ -I. -o build/together \
        -x c++ build/together.c tess.c hhpred.c -x none build/recipes/*.o $LIBS &&
        build/together"
}

# Their names: of each alone, and of all together.
prefixes() { subtest "recipes: names" env CC="$CC" ALL="$ALL" sh test/check/prefix.sh; }

# ---- Octave's functions, which leave for NumPy's tests what they give, and
# the Python package ----

tessn() {
    left=
    rm -f build/tessn.mat
    if ! group "example: tessn" && ! group "Python: "; then
        return
    elif ! command -v mkoctfile > /dev/null || ! command -v octave-cli > /dev/null
    then
        skip "example: tessn.m: no octave-cli with mkoctfile"
    elif make -s "CC=$CC" CFLAGS=-O1 octave >> $LOG 2>&1; then
        subtest "example: tessn.m" octave-cli --norc --no-history \
            test/bindings/octave/t_tessn.m
        fenced octave > build/mine.m
        check "the README's Octave: prints what is said" test \
            "$(octave-cli --norc --no-history build/mine.m | tr -d ' \n')" = \
            "v=$(sed -n 's/.* % //p' build/mine.m)"
        [ ! -f build/tessn.mat ] || left=build/tessn.mat
        # (mex.h itself is not C89)
        mex=$(mkoctfile -p OCTINCLUDEDIR)
        check "example: tess_mex.c, strict C89" sh -c "$CC -E -I. -isystem $mex/octave \
            -isystem $mex test/bindings/octave/tess_mex.c > build/mex.i &&
            $CC $STRICT -fsyntax-only -x cpp-output build/mex.i"
    else
        fail "example: tessn.m: make octave"
    fi
}

# packed: tess89 is installed from an sdist where no checkout is, and from there
# comes what is tested; $path is where
packed() {
    P=build/python
    elsewhere=$(mktemp -d) || return
    rm -rf $P
    mkdir -p $P/from
    # (a copy, as setuptools leaves files beside what it builds)
    mkdir -p $P/test/bindings && cp tess.[ch] hhpred.[ch] LICENSE $P &&
        cp -R test/recipes $P/test &&
        cp -R test/bindings/python $P/test/bindings
    rm -rf $P/test/bindings/python/build $P/test/bindings/python/*.egg-info \
        $P/test/bindings/python/tess89/_library.*
    check "Python: an sdist" sh -c "cd $P/test/bindings/python && $PYTHON -c '
import backend
print(backend.build_sdist(\"../../../from\"))'"
    cp $P/from/*.tar.gz "$elsewhere" 2>> $LOG
    quick_compiler cc1 "$CC" -O1
    rm -rf $P/test $P/*.[ch] $P/LICENSE
    check "Python: pip wheel, of the sdist alone" pip wheel \
        -w "$elsewhere" "$elsewhere"/*.tar.gz
    # (of any Python; of this machine)
    check "Python: a wheel for this machine, below 1 MB" sh -c "cd $elsewhere &&
        ls -l tess89-*-py3-none-[!a]*.whl &&
        test \$(cat *-py3-none-[!a]*.whl | wc -c) -lt 1000000"
    check "Python: pip install" pip install --target $P/site "$elsewhere"/*.whl
    rm -rf "$elsewhere"
    path=$P/site
}

bindings() {
    tessn
    tess89
}

tess89() {
    if ! group "Python: "; then
        return
    elif ! $PYTHON -c 'import numpy, scipy' 2>> $LOG; then
        skip "Python: tess89: no numpy, scipy for $PYTHON"
        return
    fi
    if [ -z "$ALL" ]; then
        :
    elif $PYTHON -m mypy --version >> $LOG 2>&1; then
        check "Python: type hints, by mypy" $PYTHON -m mypy \
            --cache-dir build/mypy test/bindings/python/tess89
    else
        skip "Python: no mypy for $PYTHON"
    fi
    path=
    if [ -z "$ALL" ]; then
        : # (pip is one of the README's commands)
    elif has_pip; then
        packed
    else
        skip "Python: no pip with setuptools for $PYTHON"
    fi
    if [ ! -d "$path/tess89" ]; then
        path=test/bindings/python
        if ! make -s "CC=$CC" CFLAGS=-O1 build/libtess.so >> $LOG 2>&1
        then
            skip "Python: tess89: make python"
            return
        fi
    fi
    # (Python looks beside the program first)
    mkdir -p build/python
    cp test/bindings/python/test_tess89.py test/bindings/python/tess.py \
        build/python
    # shellcheck disable=SC2086
    subtest "Python: tess89" env ALL="$ALL" PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$path \
        $PYTHON build/python/test_tess89.py $left
}

# ---- the recipes beside CGAL ----

peers() {
    group "beside CGAL: " || return
    if ! echo '#include <CGAL/natural_neighbor_coordinates_3.h>' |
        g++ -x c++ -E - > /dev/null 2>&1; then
        skip "beside CGAL: not installed"
        return
    fi
    # shellcheck disable=SC2086 # a list of files
    objects "$CC" "$CFLAGS" test/lib/points.c $LIBRARY
    if build cgal g++ "-O2 -frounding-math -I." \
        test/bench/peers/recipes.cpp $OBJECTS -lmpfr -lgmp; then
        subtest "beside CGAL: recipes" build/cgal
    else
        fail "beside CGAL: recipes: does not compile"
    fi
    if build volumes g++ "-O1 -frounding-math" test/bench/peers/volumes.cpp \
        -lmpfr -lgmp; then
        awk 'BEGIN { for (srand(9); n++ < 900;)
            printf "%.17g %.17g %.17g\n", 2 * rand(), 2 * rand(), 2 * rand() }' \
            > build/cube
        build/tess -q -periodic -box 0,2,0,2,0,2 -volumes build/cube.csv \
            build/cube
        subtest "beside CGAL: build/tess -periodic -volumes" sh -c \
            'build/volumes 2 < build/cube.csv'
    else
        fail "beside CGAL: build/tess -periodic -volumes: does not compile"
    fi
}

# ---- points spread over processes ----

processes() {
    wanted MPI || return
    if ! command -v mpicc > /dev/null ||
        ! mpirun --version 2> /dev/null | grep "Open MPI" > /dev/null; then
        skip "MPI: no Open MPI"
        return
    fi
    # (mpi.h itself has long long)
    mesh=
    for f in mesh split halo stars output mail; do
        mesh="$mesh test/mpi/$f.c"
    done
    # shellcheck disable=SC2086
    if build mesh mpicc "$STRICT -Wno-long-long -O2" $mesh test/lib/points.c \
        $LIBRARY && build same "$CC" "$STRICT -O2" test/mpi/same.c \
        test/lib/points.c $LIBRARY; then
        subtest "MPI" sh test/mpi/check.sh
    else
        fail "MPI: does not compile"
    fi
}
