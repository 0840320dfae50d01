#!/bin/sh
# prefix.sh - recipes take none of a program's names: what a linker sees of them
# begins with tr_, in FORTRAN with TR, and is unique in six characters; programs
# whose own names are the same but for that link with all recipes and, if ALL=yes,
# with each.  Run from the top directory.
. test/tests.sh
ALL=${ALL:-}
begin prefix
CC=${CC:-cc}
D=build/prefix
rm -rf $D

# externals OBJECT...: such names that are defined there, in lower case, without
# the underscores that compilers add
externals() {
    nm -g "$@" | awk 'NF == 3 && $2 != "U" { print $3 }' | tr A-Z a-z |
        sed 's/^_*//; s/_*$//' | sort
}

# own c|f NAMES: writes two programs, data and routines, of whose own these names
# are.  Each returns 0 if what it calls so is its own
own() {
    awk -v to="$D/$1/own" -v c="$1" '
        function data(text) { print text > (to "/data." c) }
        function code(text) { print text > (to "/routines." c) }
        { name[++n] = $1 }
        END {
            for (k = 1; k <= n && c == "c"; k++) {
                data("int " name[k] " = " k ";")
                code("int " name[k] "(void) { return " k "; }")
            }
            if (c == "c") {
                data("int main(void)\n{")
                code("int main(void)\n{")
                for (k = 1; k <= n; k++) {
                    data("if (" name[k] "++ != " k ") return 1;")
                    code("if (" name[k] "() != " k ") return 1;")
                }
                data("return 0;\n}")
                code("return 0;\n}")
                exit
            }
            data("      PROGRAM OWN")
            code("      PROGRAM OWN\n      INTEGER K")
            for (k = 1; k <= n; k++) {
                data("      INTEGER I" k "(90)")
                data("      COMMON /" name[k] "/ I" k)
            }
            for (k = 1; k <= n; k++) data("      I" k "(90) = " k)
            for (k = 1; k <= n; k++) {
                data("      IF (I" k "(90) .NE. " k ") STOP 1")
                code("      CALL " name[k] "(K)")
                code("      IF (K .NE. " k ") STOP 1")
            }
            data("      END")
            code("      END")
            for (k = 1; k <= n; k++) {
                code("      SUBROUTINE " name[k] "(K)\n      INTEGER K")
                code("      K = " k "\n      END")
            }
        }' "$2"
}

# links COMPILER PROGRAM OBJECT...: with recipes, and what they take from others;
# and runs
links() {
    cc=$1
    rm -f $D/linked
    shift
    # shellcheck disable=SC2086 # a compiler with its flags
    $cc -o $D/linked "$@" -lm > $D/words 2>&1 && $D/linked > $D/words 2>&1
}

# parted c|f PREFIX COMPILER: the objects of recipes are in $D/c or $D/f, the
# library's in lib there
parted() {
    at=$D/$1
    mkdir $at/own
    externals $at/*.o > $at/names
    externals $at/lib/*.o > $at/library
    grep -v "^$2[a-z]" $at/names > $at/wrong
    empty "names in $1 begin with $2" $at/wrong
    sort -u $at/names $at/library | cut -c1-6 | uniq -d > $at/wrong
    uniq -d $at/names >> $at/wrong
    empty "names in $1 are unique in six characters, with the library's" $at/wrong
    # what is behind the prefix, and the names in CHANGES from before there was one
    {
        sed "s/^$2//" $at/names
        awk -v c="$1" '$2 ~ /^tr_/ { print c == "c" ? $1 : tolower($3) }' \
            test/CHANGES
    } | grep . | sort -u | comm -23 - $at/library > $at/generic
    : > $at/wrong
    awk 'END { exit NR < 29 }' $at/generic || echo "too few names" > $at/wrong
    own $1 $at/generic
    ar rc $at/all.a $at/*.o $at/lib/*.o
    for program in data routines; do
        # shellcheck disable=SC2086 # a compiler with its flags
        $3 -c -o $at/own/$program.o $at/own/$program.$1 > $D/words 2>&1 ||
            echo "$program: does not compile" >> $at/wrong
        for o in $at/*.o; do
            [ -n "$ALL" ] || break
            links "$3" $at/own/$program.o $o $at/all.a ||
                echo "$program, ${o##*/}" >> $at/wrong
        done
        links "$3" $at/own/$program.o $at/*.o $at/lib/*.o ||
            echo "$program, all" >> $at/wrong
    done
    empty "names in $1: a program's own of such names link with recipes" $at/wrong
}

mkdir -p $D/c/lib $D/f/lib
for f in test/recipes/*.c; do
    $CC -I. -c -o $D/c/"$(basename "$f" .c)".o "$f"
done
for f in tess hhpred; do $CC -c -o $D/c/lib/$f.o $f.c; done
if nm $D/c/lib/tess.o > $D/words 2>&1; then
    parted c tr_ "$CC"
    if command -v gfortran > /dev/null; then
        for f in test/recipes/*.f; do
            gfortran -std=legacy -c -o $D/f/"$(basename "$f" .f)".o "$f"
        done
        for f in tess hhpred; do
            gfortran -std=legacy -c -o $D/f/lib/$f.o f77/$f.f
        done
        parted f tr "gfortran -std=legacy"
    else
        skip "names in FORTRAN: no gfortran"
    fi
else
    skip "names of recipes: no nm"
fi
ended
