# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# fortran.sh - the FORTRAN 77 half, and its parity with C.

# ---- the FORTRAN 77 half: ANSI X3.9-1978 and nothing more ----

# TSBLD, TESSIX and TESSQU cut their workspace up into arrays, and what a mesh
# and a search keep is handed over in parts; a query hands over one array twice,
# that nobody alters.  The standard allows to hand over an array element for an
# array, and to alter the arrays, as they are declared in their lengths and do
# not overlap; that they do not ftnchek cannot know.  So two of its warnings are
# off, and with them on it may complain of those calls alone.
F77="f77/tess.f f77/hhpred.f"
CHEK="ftnchek -f77=all -declare -sixchar"
CHEKS="$CHEK -array=no-dimensions -usage=no-arg-array-alias"

standard() {
    check "ftnchek: no line past column 72" \
        sh -c '! grep -n "^.\{73\}" f77/*.f test/*/*.f test/*/*/*.f'
    check "constants: those of the tables in the heads" sh test/twin/constants.sh
    check "literals: the same in both halves" sh test/twin/literals.sh
    check "arguments: in the order that the head of tess.f gives" \
        sh test/twin/order.sh
    group "ftnchek: " || return
    if ! command -v ftnchek > /dev/null; then
        skip "ftnchek: not installed"
        return
    fi
    $CHEKS $F77 > build/ftnchek.txt 2>&1
    cat build/ftnchek.txt >> $LOG
    check "ftnchek: both files read" test \
        "$(grep -c '^ 0 syntax errors detected' build/ftnchek.txt)" -eq 2
    check "ftnchek: no warning" sh -c '! grep -i warning build/ftnchek.txt'
    $CHEK $F77 > build/ftnchek.txt 2>&1
    egrep -i warning build/ftnchek.txt |
        egrep -v 'argument arrayness mismatch' | egrep -v \
        'Subprogram (HHPROD|HHRELA|TSAPEX|TSINDE|TSMCYS|TSMESH) argument usage' |
        egrep -v 'Subprogram (TSPICK|TSBBOX|TSEXIT|TSBLD) argument usage' |
        egrep -v 'Subprogram (TSQUER|TSINCT|TSTREE) argument usage' \
        > build/ftnwarn.txt
    empty "ftnchek: warnings of parts of arrays alone" build/ftnwarn.txt
    for f in test/twin/*.f test/recipes/*.f test/recipes/t/*.f \
        test/samples/*.f f77/first.f; do
        # shellcheck disable=SC2046 # lists of files
        case $f in
        */parts.f) $CHEKS -noextern $(linked $f);; # and OpenMP
        *) $CHEKS -library $F77 $(linked $f);;
        esac > build/ftnchek.txt 2>&1
        check "ftnchek: $f" sh -c '! grep -i warning build/ftnchek.txt'
    done
    # shellcheck disable=SC2046 # a list of files
    $CHEKS -library $F77 $(routines f '^      PROGRAM') > build/ftnchek.txt 2>&1
    check "ftnchek: the recipes together" sh -c \
        '! grep -i warning build/ftnchek.txt'
}

# The routines of both halves: the same, in one order, as the files have them.
twins() {
    for half in tess hhpred; do
        check "order of the routines: $half.c and f77/$half.f" \
            sh test/twin/names.sh -order $half
    done
    group "order of the routines: " || return
    if ! ctags --version 2> /dev/null | grep Universal > /dev/null; then
        skip "order of the routines: no universal-ctags"
        return
    fi
    for half in tess hhpred; do
        ctags -x -u --kinds-C=f --_xformat=%N $half.c > build/ctags.txt
        ctags -x -u --language-force=Fortran --kinds-Fortran=fs --_xformat=%N \
            f77/$half.f > build/ctags77.txt
        check "order of the routines: ctags sees those of $half.c" sh -c \
            "sh test/twin/names.sh -c $half.c | diff build/ctags.txt -"
        check "order of the routines: ctags sees those of f77/$half.f" sh -c \
            "sh test/twin/names.sh -f f77/$half.f | diff build/ctags77.txt -"
    done
}

# list_entries: names to build/list.txt, with their arguments to build/entries.txt;
# calls FILE: each name with its arguments, in small letters
calls() {
    awk '/^     [^ ]/ { text = text substr($0, 7); next }
        { print text; text = $0 }
        END { print text }' $1 | tr A-Z a-z | tr -d ' &' |
        sed -n 's/.*\(subroutine\|function\)\(\(tess\|hh\)[a-z]*(.*)\)$/\2/p'
}
list_entries() {
    # the public ones of hhpred.f, by hhpred.h's names cut to six characters
    sed '/---- for tess/,$d' hhpred.h |
        sed -n 's/^TESS_API [a-z_ ]* [*]*hh_\([a-z]*\)(.*/hh\1/p' | cut -c1-6 |
        sort > build/hh.txt
    for f in $F77; do calls $f; done | sort > build/heads.txt
    { grep '^tess' build/heads.txt
      while read name; do grep "^$name(" build/heads.txt; done < build/hh.txt
    } | sort > build/entries.txt
    sed 's/(.*//' build/entries.txt | sort > build/list.txt
}

# The entries: the heads in tess.f and hhpred.f, those of the module for
# Fortran 90, those that the manual describes, its list of them, and what
# hhpred.h and tess.h declare for callers.
entries() {
    list_entries
    check "entries: tess.f has those of tess.h" sh -c \
        "test \`grep -c '^tess' build/list.txt\` -eq \
        \`grep -c '^TESS_API [a-z]* tess[_a-z]*(' tess.h\`"
    check "entries: hhpred.f has those of hhpred.h" sh -c \
        "grep '^hh' build/list.txt | cmp - build/hh.txt && test -s build/hh.txt"
    # a line that ends in & goes on
    sed -e ':more' -e '/&$/{N;s/&\n *//;b more' -e '}' f77/tess.f90 |
        grep -v 'end \(function\|subroutine\)' > build/module.txt
    calls build/module.txt | sort > build/module2.txt
    check "entries: the module's are tess.f's, with the same arguments" \
        diff build/entries.txt build/module2.txt
    sed -n '/^    routine/,/^Arrays/s/^    \([A-Z ,]*\)  .*/\1/p
        /^    routine/,/^Arrays/s/^    \([A-Z, ]*\)$/\1/p' f77/README |
        tr -cs A-Z '\012' | tr A-Z a-z | grep . | sort > build/manual.txt
    check "entries: the manual's list" diff build/list.txt build/manual.txt
    sed -n 's/^      [A-Z ]*\(SUBROUTINE\|FUNCTION\) \([A-Z]*\)(.*/\2/p' \
        f77/README | tr A-Z a-z | sort > build/manual.txt
    check "entries: the manual's descriptions" diff build/list.txt build/manual.txt
    sed -n 's/^      [A-Z ]*\(SUBROUTINE\|FUNCTION\) \([A-Z0-9]*\).*/\2/p' \
        $F77 | tr A-Z a-z | sort | comm -23 - build/list.txt > build/own.txt
    tr -cs A-Z '\012' < f77/README | tr A-Z a-z | sort -u |
        comm -12 - build/own.txt > build/named.txt
    cat build/named.txt >> $LOG
    check "f77/README names no routine of the library's own" sh -c \
        'test -s build/own.txt && ! grep . build/named.txt'
    check "f77/README is what the sources say" sh -c \
        'sh test/twin/manual.sh | cmp - f77/README'
}

# ---- the same results as the C half ----

# few limbs: the same codes 2 and 6 as from C
fewlimbs() {
    for half in tess hhpred; do
        sed 's/HHLIM = 88/HHLIM = 3/;s/HHL088/HHL003/' f77/$half.f > build/few$half.f
        gfortran -frecursive -O1 -c -o build/f$half.o build/few$half.f || return
    done
}

# half COMPILE...: what compiles the half; it does when a test first asks for it,
# by compiled
half() {
    HALF=$*
    HALFS=
}
compiled() {
    [ -n "$HALFS" ] && return
    # (once in a run, as by `objects')
    kept=build/objects/$(echo "$HALF" | tr -cd 'a-zA-Z0-9=')
    rm -f build/ftess.o build/fhhpred.o
    if [ ! -f "$kept/made" ]; then
        echo "== FORTRAN 77: $HALF" >> $LOG
        $HALF >> $LOG 2>&1 || return
        mkdir -p "$kept"
        for o in ftess fhhpred; do
            cp build/$o.o "$kept/$o.$$" && mv "$kept/$o.$$" "$kept/$o.o" || return
        done
        : > "$kept/made"
    fi
    cp "$kept/ftess.o" "$kept/fhhpred.o" build || return
    HALFS=yes
}

# fortran NAME OPTIONS TESTS COMPILE...: the unit tests with the half in the
# place of the C half, by way of shim.c
fortran() {
    tag=$1
    options=$2
    echo "$3" | tr , '\012' > build/list
    shift 3
    half "$@"
    here=build/units/f77
    mkdir -p $here
    while read -r t; do
        wanted "FORTRAN 77, $tag: $t" || continue
        program=${t%% *}
        # shellcheck disable=SC2086 # lists of files
        if compiled && objects "$CC" "$(harness "$options")" $COMMON &&
            common=$OBJECTS && objects "$CC" "-O1 $options" \
            test/twin/shim.c test/unit/$program.c &&
            $LINKF -o $here/$program $OBJECTS $common build/ftess.o \
            build/fhhpred.o $LIBF $LIBS >> $LOG 2>&1; then
            subtest "FORTRAN 77, $tag: $t" $here/$t
        else
            fail "FORTRAN 77, $tag: $t: does not compile"
        fi
    done < build/list
}

# without [NAME...]: compile the half without these chapters of part II; all if
# none is named
without() {
    sh test/twin/core.sh "$@" > build/core.f || return
    gfortran -frecursive -std=f95 -O1 -c -o build/ftess.o build/core.f &&
        gfortran -frecursive -std=f95 -O1 -c -o build/fhhpred.o f77/hhpred.f
}

# text NAME: link parity.c with the half, by way of shim.c, and compare its text
# with that of the C half, which `parity' tests.
text() {
    wanted "parity: $1" || return
    if [ ! -f build/parity.txt ]; then
        objects "$CC" "$CFLAGS" $LIBRARY &&
            build parity "$CC" -O1 test/twin/parity.c $OBJECTS &&
            build/parity > build/parity.txt
    fi
    rm -f build/parityf
    if compiled && objects "$CC" -O1 test/twin/parity.c test/twin/shim.c &&
        $LINKF -o build/parityf $OBJECTS build/ftess.o build/fhhpred.o $LIBF \
            $LIBS >> $LOG 2>&1
    then
        build/parityf > build/parityf.txt
        check "parity: $1" diff build/parity.txt build/parityf.txt
    else
        fail "parity: $1: does not link"
    fi
}

# threads NAME: link the half with a program of several threads.
# Local arrays must be on the stack: -frecursive, f2c -a.
threads() {
    wanted "threads: $1" || return
    if ! have "$CC" -fopenmp; then
        skip "threads: $1: no OpenMP"
        return
    fi
    rm -f build/threads
    compiled
    objects "$CC" -O1 test/lib/points.c
    $CC $CFLAGS -fopenmp -c -o build/threads.o test/twin/threads.c
    $LINKF -fopenmp -o build/threads build/threads.o $OBJECTS \
        build/ftess.o build/fhhpred.o $LIBF $LIBS >> $LOG 2>&1
    subtest "threads: $1" env OMP_NUM_THREADS=4 build/threads
}

# FORTRAN programs that tell by their text whether all is well.
# programs NAME FLAGS: with the half
programs() {
    for f in $(grep -l '^      PROGRAM' test/twin/sizes.f test/recipes/t/*.f \
        test/samples/*.f); do
        case $f in */parts.f) continue;; esac # below
        wanted "$f, $1" || continue
        compiled
        rm -f build/program
        # shellcheck disable=SC2046 # a list of files
        gfortran -frecursive $2 -o build/program $(linked $f) build/ftess.o \
            build/fhhpred.o $LIBS >> $LOG 2>&1
        case $f in
        test/recipes/*)
            build/program > build/program.txt
            check "$f, $1" cmp "${f%f}out" build/program.txt;;
        *) subtest "$f, $1" build/program;;
        esac
    done
}

# onef NAME LIBRARIES COMPILE...: all recipes, and the half
onef() {
    name=$1
    wanted "recipes: one program, $name" || return
    compiled
    libraries=$2
    shift 2
    rm -rf build/recipesf
    mkdir build/recipesf
    { for f in $(routines f '^      PROGRAM'); do cat $f; done
      printf '      PROGRAM ALL\n      END\n'; } > build/recipesf/all.f
    check "recipes: one program, $name" sh -c "cd build/recipesf && $* &&
        $LINKF -o all all.o ../ftess.o ../fhhpred.o $libraries $LIBS && ./all"
}

# recipes77 NAME FLAGS CFLAGS: the tests in C of recipes, of those in FORTRAN:
# twin/recipes.c is linked
recipes77() {
    group "recipes in FORTRAN, $1: " || return
    compiled
    dir=build/recipes77
    rm -rf $dir
    mkdir -p $dir
    for r in cells derived interp iso natural periodic planar slopes surface; do
        gfortran -frecursive $2 -c -o $dir/f$r.o test/recipes/$r.f >> $LOG 2>&1
        # (what is const in C is so in none of these)
        gfortran $2 -fsyntax-only -fc-prototypes-external test/recipes/$r.f |
            sed -n '/ \*/s/\(int\|long\|double\) \*/const &/gp' |
            grep '_ (' >> $dir/recipes77.h
    done
    compile "$CC" "-O1 -I. -I$dir -Werror=incompatible-pointer-types $3" $dir \
        test/twin/recipes.c
    objects "$CC" "-O1${3:+ $3}" $LIBRARY test/lib/points.c test/lib/exact.c
    have "$CC" "$STRICT" && check "recipes in FORTRAN, $1: strict C89" \
        $CC $STRICT $3 -fsyntax-only -I. -I$dir test/twin/recipes.c
    mkdir -p $dir/unit $dir/recipes/t
    for t in unit/t_cells unit/t_natural recipes/t/t_cells \
        recipes/t/t_derived recipes/t/t_interp recipes/t/t_iso \
        recipes/t/t_periodic \
        recipes/t/t_planar recipes/t/t_slopes recipes/t/t_surface; do
        wanted "recipes in FORTRAN, $1: $t" || continue
        # (what is long is asked once, with subscripts checked)
        case $ALL$3$t in unit/* | *-*unit/*) continue;; esac
        fewer=
        [ -n "$ALL" ] || fewer=$(less_of $t)
        # shellcheck disable=SC2086 # flags
        $CC -O1 -DFORTRAN $3 $fewer -I. -c -o $dir/$t.o test/$t.c >> $LOG 2>&1 &&
            gfortran -o $dir/$t $dir/$t.o $dir/*.o $OBJECTS build/ftess.o \
                build/fhhpred.o $LIBS >> $LOG 2>&1
        case $t in
        unit/*) subtest "recipes in FORTRAN, $1: $t" $dir/$t $LESS;;
        *)
            (cd $dir && GFORTRAN_UNBUFFERED_ALL=y limited 300 ./$t $t.obj \
                $t.stl) > $dir/$t.txt 2>> $LOG
            check "recipes in FORTRAN, $1: $t" cmp test/$t.out $dir/$t.txt;;
        esac
    done
}

# small_stack COMMAND...: in the eight megabytes that are usual
small_stack() {
    # shellcheck disable=SC3045 # all shells that there are know -s
    (ulimit -s 8192; exec "$@")
}

# interface NAME FLAGS: the module for Fortran 90, and that with it wrong calls
# do not compile; f77/README's program
interface() {
    group "interfaces, $1" || group "f77/README's program, $1" || return
    compiled
    list_entries
    (cd build && gfortran -std=f95 -pedantic -Wall -Wextra -Werror $2 -c \
        -o module.o ../f77/tess.f90) >> $LOG 2>&1
    module="-cpp -Ibuild -Jbuild $2"
    if gfortran -std=f2018 -pedantic $module -o build/iface \
        test/bindings/fortran/t_iface.f90 build/ftess.o build/fhhpred.o $LIBS \
            >> $LOG 2>&1
    then
        subtest "interfaces, $1" build/iface
    else
        fail "interfaces, $1: do not compile"
    fi
    # each synopsis of the manual is FORTRAN and declares all arguments
    awk '/^-----/ { at = 1; next } at && /^$/ { print "      END"; at = 0 }
        at { print }' f77/README > build/synopses.f
    check "f77/README's synopses, $1" sh -c "gfortran -std=f95 -pedantic $2 \
        -fimplicit-none -fsyntax-only build/synopses.f &&
        test \$(grep -c '^      END' build/synopses.f) -eq \
        \$(wc -l < build/list.txt)"
    for wrong in $(sed -n 's/.* WRONG == \([0-9]*\)$/\1/p' \
        test/bindings/fortran/t_iface.f90); do
        check "interfaces, $1: wrong call $wrong" sh -c "! gfortran $module \
            -DWRONG=$wrong -c -o build/module.o \
                test/bindings/fortran/t_iface.f90"
    done
    awk '/^      PROGRAM PLACE/,/^      END$/' f77/README > build/grid.f
    rm -f build/grid
    gfortran $2 -o build/grid build/grid.f build/ftess.o build/fhhpred.o \
        $LIBS >> $LOG 2>&1
    check "f77/README's program, $1" test "$(build/grid)" = " 14.5000"
    # the other one takes slices of 1500; in one there are as many
    awk '/^      PROGRAM SLICES/,/^      END$/' f77/README > build/slices.f
    sed 's/ROOM = 1500/ROOM = MAXTET/' build/slices.f > build/whole.f
    for f in slices whole; do
        rm -f build/$f
        gfortran $2 -o build/$f build/$f.f build/ftess.o build/fhhpred.o \
            $LIBS >> $LOG 2>&1
        build/$f > build/$f.txt 2>> $LOG
    done
    check "f77/README's program of slices, $1" sh -c "
        awk '{ for (all = \$1; n < all - 1500;) print n += 1500, 1
            print all, \$5 }' build/whole.txt > build/slices1.txt &&
        grep 1500 build/slices1.txt &&
        awk '{ print \$1, \$5 }' build/slices.txt | cmp - build/slices1.txt"
    # where DOUBLE PRECISION has not 64 bits INFO says so; coordinates of all
    # bits
    sed 's/P(\([123]\),I) = .*/P(\1,I) = ABS(MOD(1D4*SIN(DBLE(\1*I)), 1D0))/
        s/ STOP .TESS.*/ WRITE (*, *) INFO/' build/grid.f > build/wide.f
    for wide in -fdefault-real-8 "-fdefault-real-8 -fdefault-double-8" \
        -freal-8-real-10; do
        [ -n "$ALL" ] || [ "$wide" = -fdefault-real-8 ] || break
        rm -f build/wide
        # shellcheck disable=SC2086
        gfortran $2 -frecursive $wide -o build/wide build/wide.f $F77 $LIBS \
            >> $LOG 2>&1
        case $wide in *double*) code=;; *) code=6;; esac
        check "f77/README's program, $1 $wide" test \
            "$(build/wide 2>> $LOG | sed -n 's/^ *\(6\) *$/\1/p')" = "$code"
    done
    # (its arrays are not on the stack)
    sed 's/(N = 1000)/(N = 200000)/' build/grid.f > build/large.f
    rm -f build/grid
    gfortran $2 -frecursive -o build/grid build/large.f build/ftess.o \
        build/fhhpred.o $LIBS >> $LOG 2>&1
    check "f77/README's program, $1, 200,000 points" \
        test "$(small_stack build/grid)" = " 14.5000"
}

# mixed: a C program that calls the FORTRAN half, and the reverse
mixed() {
    group "example: calls_" || group "example: tess_c" || return
    compiled
    check "example: calls_fortran.c" sh -c "$CC -O2 -c -o build/mixed.o \
        test/samples/calls_fortran.c &&
        gfortran -o build/mixed build/mixed.o build/ftess.o build/fhhpred.o &&
        build/mixed | cmp - test/samples/calls_fortran.out"
    # the names that the manual tells of
    check "example: calls_, f77/README's nm" sh -c "cp f77/first.f build/caller.f &&
        cd build &&
        test \"\$(`sed -n 's/^    \(gfortran -c caller.f .*\)/\1/p' f77/README` |
            tr -d ' ')\" = Utess_ &&
        test \"\$(gfortran -fno-underscoring -c caller.f && nm caller.o |
            grep tess | tr -d ' ')\" = Utess"
    objects "$CC" "$CFLAGS" $LIBRARY && cp $OBJECTS build
    module="-std=f2003 -Wall -Wextra -Jbuild test/bindings/fortran/tess_c.f90"
    check "example: calls_c.f90" sh -c "gfortran $module -o build/mixed \
        test/samples/calls_c.f90 build/tess.o build/hhpred.o $LIBS &&
        build/mixed | cmp - test/samples/calls_fortran.out"
    # all routines of the headers, with as many arguments
    for f in hhpred.h tess.h; do
        sed '/---- for tess/,$d' $f
    done | awk '/^TESS_API/ { text = "" } { text = text $0 }
        text ~ /^TESS_API.*;$/ {
            name = text
            sub(/\(.*/, "", name)
            sub(/.*[ *]/, "", name)
            many = text ~ /\(void\)/ ? 0 : gsub(/,/, "", text) + 1
            print name, many
            text = ""
        }' | sort > build/wanted.txt
    sed -e ':more' -e '/&$/{N;s/&\n *//;b more' -e '}' \
        test/bindings/fortran/tess_c.f90 | awk '/^    .* function .*bind\(c\)/ {
            name = text = $0
            sub(/\(([^(]*)\) *bind.*/, "", name)
            sub(/.* /, "", name)
            sub(/.* function [a-z_]*\(/, "", text)
            sub(/\).*/, "", text)
            many = text == "" ? 0 : gsub(/,/, "", text) + 1
            print name, many
        }' | sort > build/bound.txt
    check "example: tess_c.f90: all routines of the headers" sh -c \
        "test -s build/wanted.txt && diff build/wanted.txt build/bound.txt"
    if gfortran $module -o build/module test/bindings/fortran/t_module.f90 \
        build/tess.o build/hhpred.o $LIBS >> $LOG 2>&1; then
        subtest "example: tess_c.f90" build/module
    else
        fail "example: tess_c.f90: does not compile"
    fi
}

# parity.c writes the same text with both halves, compared byte by byte.  parity.txt
# has the sums of its sections, so that a machine without Fortran compares, too;
# of a section that differs the text is shown.  The sums are not believed: the
# first program proves each answer by exact.c.  (When the library's own figures
# change, as the lengths of the workspace: sh test/twin/sums.sh
# build/parity.txt > test/twin/parity.txt.)
parity() {
    group "parity: " || return
    objects "$CC" "$CFLAGS" $LIBRARY
    if build parity "$CC" "-O1 -DPROVE" test/twin/parity.c test/lib/exact.c \
        test/lib/prove.c test/lib/verify.c $OBJECTS; then
        build/parity > build/parity.txt 2> build/prove.txt
        cat build/prove.txt >> $LOG
        check "parity: proofs" grep '^prove: [0-9]* passed, 0 failed' \
            build/prove.txt
        check "parity: no code but the promised one" \
            sh -c 'test -s build/parity.txt && ! grep WRONG build/parity.txt'
        check "parity: the sums as stored" sh test/twin/sums.sh \
            build/parity.txt test/twin/parity.txt
        # (a line of one section changed: that section is shown, and no other)
        sed '/^= cube .* 9$/,/^= /s/^TESSHU  /TESSHU 1/' build/parity.txt \
            > build/parity1.txt
        check "parity: a line changed" sh -c '! sh test/twin/sums.sh \
            build/parity1.txt test/twin/parity.txt > build/sums.txt &&
            test "`grep "^= " build/sums.txt`" = "`grep "^= cube .* 9$" \
            build/parity.txt`" && grep "^TESSHU 1" build/sums.txt'
    else
        fail "parity: parity.c does not compile"
    fi
    [ -z "$ALL" ] && return
    # (what makes infinities and NaNs must not be compiled with -Ofast)
    $CC -O1 -c -o build/parity.o test/twin/parity.c
    for c in "$CC -O0" "$CC -Ofast -march=native" "clang -Ofast" "tcc"; do
        set -- $c
        cc=$1
        shift
        if have $cc "$*"; then
            build parity1 $cc "$*" build/parity.o $LIBRARY
            build/parity1 > build/parity1.txt
            check "parity: $c" diff build/parity.txt build/parity1.txt
        else
            skip "parity: $c"
        fi
    done
}

# fortran77: how the half is linked, 1 if gfortran is not there; a part begins so
fortran77() {
    LINKF=gfortran
    LIBF=
    HALFS=
    command -v gfortran > /dev/null && return
    skip "FORTRAN 77, $part: no gfortran"
    return 1
}

# The unit tests, subscripts checked, and, with -all, without part II.
half_checked() {
    fortran77 || return
    # (so many points have cylinders on several levels)
    fortran "gfortran -fcheck=all" "" "t_pred 20,t_facet 20,brute 50,t_tess -one \
ellipsoid 6000 1$(printf ",%s $LESS" $MESHES ${ALL:+t_part t_query})" \
        gfort build/f -O1 -fcheck=all
    text "gfortran -fcheck=all"
    [ -n "$ALL" ] || return
    fortran "without part II" "" "brute 100" without
    text "without part II"
}

# Recipes and programs.
half_recipes() {
    fortran77 || return
    half gfort build/f -O1 -fcheck=all
    programs "gfortran -fcheck=all" "-std=legacy -O1 -fcheck=all"
    onef gfortran "" "gfortran -frecursive -std=f95 -pedantic -Wall -Wextra \
        -Werror -Wno-compare-reals -Wno-do-subscript -c all.f"
    recipes77 "gfortran -fcheck=all" "-std=legacy -O1 -fcheck=all" ""
}

# Those who call it, and the manual's programs.
half_callers() {
    fortran77 || return
    half gfort build/f -O1 -fcheck=all
    interface "gfortran -fcheck=all"
    mixed
    f_program
}

half_flags() {
    fortran77 || return
    flagged77
    stacked77
}

# Other options.  (What the tests ask for with subscripts checked is not asked
# again.)
half_options() {
    fortran77 || return
    fortran "gfortran -O0" "" "brute 50" gfort build/f -O0
    text "gfortran -O0"
    fortran "gfortran -O3" "" "brute,t_tess -quick" gfort build/f -O3
    text "gfortran -O3"
    threads "gfortran -O3"
    half gfort build/f -Ofast -march=native
    text "gfortran -Ofast -march=native"
    # (a subscript may be right for the array that a caller has passed on)
    LIBF=-fsanitize=address
    half gfort build/f -O1 -fsanitize=address
    text "gfortran -fsanitize=address"
    LIBF=
    for omp in "" -fopenmp; do
        wanted "example: parts.f $omp" || continue
        rm -f build/partsf
        # shellcheck disable=SC2046 # a list of files
        gfortran -O2 -frecursive $omp -o build/partsf \
            $(linked test/samples/parts.f) $F77 >> $LOG 2>&1
        build/partsf > build/partsf.out 2>> $LOG
        check "example: parts.f $omp" cmp test/samples/parts.out \
            build/partsf.out
    done
}

half_chapters() {
    fortran77 || return
    for chapter in $(sh test/twin/core.sh -list); do
        half without $chapter
        text "without $chapter"
    done
}

# Integers of 8 bytes, few limbs.
half_types() {
    fortran77 || return
    fortran "INTEGER*8" -DTESS_INT=long "t_pred 10,t_facet 10,brute 50" \
        gfort build/f -O2 -fdefault-integer-8
    programs "INTEGER*8" "-std=legacy -O1 -fdefault-integer-8"
    recipes77 "INTEGER*8" "-std=legacy -O1 -fdefault-integer-8" -DTESS_INT=long
    interface "INTEGER*8" -fdefault-integer-8
    fortran "gfortran, 3 limbs" -DHH_LIMBS=3 \
        "t_pred 10,t_facet 10,brute 100,t_range" fewlimbs
}

half_f2c() {
    if ! command -v f2c > /dev/null; then
        skip "FORTRAN 77, through f2c: no f2c"
        return
    fi
    LINKF=$CC
    LIBF=-lf2c
    # (the same statements as gfortran's, where all else is asked)
    fortran "f2c" "" "t_pred 10,t_facet 10,brute 50,t_tess -quick" \
        viaf2c build/f
    text "f2c"
    threads "f2c"
    # the manual's command, where the C half is
    rm -rf build/beside
    mkdir build/beside
    cp $LIBRARY $F77 build/beside
    check "f77/README's f2c" sh -c "(cd build/beside &&
        `sed -n 's/^    \(mkdir c .*f2c .*\)/\1/p' f77/README`) &&
        cmp tess.c build/beside/tess.c && test -s build/beside/c/hhpred.c"
    onef f2c -lf2c "f2c -A -a -u all.f && $CC -O1 -c all.c"
}
