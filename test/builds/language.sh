# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# language.sh - strict C89, C++, and what the library asks for and shows.

# ---- the language: strict C89, no warnings; also as C++ ----

language() {
    if have "$CC" "$STRICT"; then
        check "strict C89: the tests" sh -c "for f in test/*/*.c test/*/*/*.c \
            test/*/*/*/*.c; do
            # mpi.h and mex.h are not C89; recipes77.h is not made yet; peers
            # have headers of their own, and a bare machine assembler
            case \$f in test/mpi/*|*_mex.c|*/twin/recipes.c|*/peers/*|*/bare/*)
                continue;;
            esac
            $CC $STRICT -fsyntax-only -I. \$f || exit 1; done"
        for d in -DTESS_FLOAT -DTESS_INT=long; do
            check "strict C89: build/tess $d" sh -c "for f in \
                test/cli/src/*.c test/cli/src/*/*.c; do
                $CC $STRICT $d -fsyntax-only -I. \$f || exit 1; done"
        done
        check "strict C89: the paper's programs, all of them" sh -c "cd test/paper
            for f in blas loops time acc backward round figure4; do
            $CC $STRICT -fsyntax-only -I. -DCBLAS -DFORTRAN -DSINGLE -DPLAIN \
            \$f.c || exit 1; done"
        for d in -O2 -DTESS_FLOAT -DTESS_INT=short -DTESS_INT=long \
            "-DHH_LIMBS=3 -DTESS_LIST=64" -DTESS_CORE; do
            for f in $LIBRARY; do
                # (what a compiler finds when it optimizes it finds in one)
                how="-O1 -c -o build/strict.o"
                [ "$d" = -O2 ] || how=-fsyntax-only
                check "strict C89: $f $d" $CC $STRICT -Wdouble-promotion $d \
                    $how $f
            done
        done
        check "strict C89: programs for small machines" sh -c "for f in \
            test/builds/machines/tiny.c test/samples/embedded.c \
            test/samples/sensor.c test/unit/t_size.c test/unit/t_pred.c \
            test/unit/t_facet.c test/unit/brute.c $(echo $COMMON); do
            $CC $STRICT -DTESS_INT=short -fsyntax-only -I. \$f || exit 1; done"
    else
        skip "strict C89: $CC does not take the flags"
    fi
    if have g++ "-x c++"; then
        for f in $LIBRARY; do
            check "C++: $f" g++ -x c++ -Wall -Wextra -Werror -fsyntax-only $f
        done
        # (`types' compiles the first two as well)
        for d in "" "-DTESS_INT=short -DTESS_FLOAT" -DTESS_INT=short \
            "-DTESS_INT=long -DTESS_FLOAT"; do
            [ "$ALL$d" != -DTESS_INT=short ] || break
            check "C++: the headers in a namespace $d" spaced "$d"
        done
    else
        skip "C++: no g++"
    fi
}

# spaced FLAGS: tess.h and recipes.h inside a namespace, their macros outside
spaced() {
    cat > build/spaced.c <<END
#include <stdio.h>
namespace a {
#include "tess.h"
#include "test/recipes/recipes.h"
}
static a::tess_int iw[TESS_LIW(5)], tet[32], adj[32], first[6], list[32], ntet;
static double rw[TESS_LRW(5L)];
static const a::tess_real p[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
int main()
{
    int code = a::tess(5, p, 8, &ntet, tet, adj, TESS_LIW(5), iw, TESS_LRW(5),
                       rw);
    a::tr_stars(5, ntet, tet, first, list);
    return code != 0 || ntet < 2 || ntet > TESS_INT_MOST ||
           first[5] != 4 * ntet;
}
END
    # shellcheck disable=SC2086
    g++ -x c++ -pedantic -Wall -Wextra -Wconversion -Wold-style-cast -Werror \
        $1 -I. -c -o build/spaced.o build/spaced.c || return
    rm -f build/spaced
    objects "$CC" "-O1${1:+ $1}" $LIBRARY test/recipes/derived.c &&
        $CC -o build/spaced build/spaced.o $OBJECTS $LIBS && build/spaced
}

# ---- the names: the library asks for nothing but the C89 maths functions and has
# no data that could be shared between threads.  (package.sh: it links with no
# caller that was compiled with other types) ----

# names: of the library's routines, to build/names.txt
names() {
    nm build/tess.o build/hhpred.o |
        sed -n 's/^.* T _*\([A-Za-z]\)/\1/p' | sort > build/names.txt
}

symbols() {
    objects "$CC" "$CFLAGS" $LIBRARY && cp $OBJECTS build
    if ! nm build/tess.o > build/nm.txt 2> /dev/null; then
        skip "symbols: no nm"
        return
    fi
    nm build/hhpred.o >> build/nm.txt
    # what is asked for, but the library's own names and what compilers add
    nm -u build/tess.o build/hhpred.o |
        sed -n 's/^.* \([A-Za-z_0-9]*\)$/\1/p' | sort -u |
        egrep -v '^_?(hh_|tess|sqrt|fabs|floor|ceil|frexp|ldexp|pow|memset)' |
        egrep -v '^_?(memcpy|__stack_chk|_?GLOBAL_OFFSET)' > build/asked.txt
    empty "asks for nothing but maths" build/asked.txt
    grep ' [bBdDcCgGsS] ' build/nm.txt > build/data.txt
    empty "has no data but constants" build/data.txt
    names
    check "unique in six characters" sh -c \
        "! cut -c1-6 build/names.txt | tr A-Z a-z | sort | uniq -d | grep ."
    [ -z "$ALL" ] && return
    for word in unsigned:signed "long long:one word" int_least64_t:header; do
        check "TESS_INT=${word%%:*} is refused" sh -c "! $CC -c -o build/have.o \
            '-DTESS_INT=${word%%:*}' hhpred.c 2> build/have.txt &&
            grep '${word##*:}' build/have.txt"
    done
}
