#!/bin/sh
# mutation.sh - do the tests notice?  Breaks the library in one place at a time
# (mutation.c), and runs tests that take a few seconds.
#
#     sh test/fuzz/mutation.sh [N [SEED [SKIP]]]
#         N changes of each half, 100, drawn by SEED, 1, without the first SKIP
#         drawn; HALVES=c or HALVES=f of C or of FORTRAN alone; HALVES=program
#         of what build/tess reads files by; CHECK=yes by what make check runs
#         alone, but for the examples and the program (what a change costs
#         searches is not looked at then if LOOKS=no); TESTS="brute parity"
#         by these tests alone, as for what -those asks the others of;
#         ONLY="^cell.* (negated|dropped)$" of those alone that this fits
#     sh test/fuzz/mutation.sh -those LIST
#         changes of which LIST has a line each, FILE K.  The last one is kept in
#         build/mutation/new
#     sh test/fuzz/mutation.sh -join REPORT...
#         what batches (by SKIP, or of one half) and -those have printed, as one
#         report; of a change that is in several the last one's verdict counts,
#         and those that equivalents has by now are left out
#
# A change that leaves the object code as it is, or does not compile, or is in
# test/fuzz/equivalents, is left out, and not counted in N nor in SKIP.  Caught
# is what fails a test, crashes, takes four times as long as the library does or
# more, makes searches look at a tenth more (bench/counts.sh), calls a routine
# more often than its twin does (twin/calls.sh), or alters a number in one
# routine alone (twin/constants.sh, literals.sh).  The tests' names:
#   few      t_pred and t_facet with 3 limbs
#   x87      t_pred and t_facet in an x87 unit
#   low      certify with low thresholds
#   limbs    brute with 3 limbs
#   range    t_range with 6 limbs
#   float    brute, t_pred and t_facet in single precision
#   short    brute with short indices and lists
#   unit     t_range in an x87 unit that is set to 24 bits
#   more     brute, as many sets as in make check
#   large    t_tess, so many points that cylinders are on several levels
#   asan     the tests of meshes, or parity and t_pred, with sanitizers
#   warned   compilers' warnings of what is not set, or not used
# Of a change that survives is said whether it alters what searches look at:
# "elsewhere" if so, "survived" if that is the same, too.
#
# Those of the second part of equivalents, which only cost a little, are left out,
# too.
#
# Run from the top directory; takes CC.  The last line is
# `mutation: N changes, C caught, E look elsewhere, S survived'; without SKIP,
# and of both halves, all is written to test/results/mutation.txt.  DIR, where it
# builds, lets two run beside each other.
. test/tests.sh
set -f
DIR=${DIR:-build/mutation}
HALVES=${HALVES:-c f}
CHECK=${CHECK:-}
LOOKS=${LOOKS:-yes}
ONLY=${ONLY:-.}
N=100
SEED=1
SKIP=0
LIMIT=40
LONG=60

say() { echo "mutation.sh: $1" >&2; exit 2; }

if [ "$1" = -join ]; then
    shift
    cat "$@" | grep '^Written by: ' | sort -u
    echo
    awk -v list=test/fuzz/equivalents '
        BEGIN {
            while ((getline < list) > 0) {
                sub(/^ */, "")
                if (last ~ /^[a-z]*\.[cf]: /) equal[last, $0]
                last = $0
            }
        }
        $1 ~ /^[a-z]*\.[cf]:[0-9]+$/ {
            key = $1 " " $2
            if (!(key in text)) all[++n] = key
            text[key] = $0
            open[key] = line[key] = ""
            next
        }
        /^        [a-z]*\.[cf]: / { sub(/^ */, ""); line[key] = $0; next }
        line[key] != "" && open[key] == "" && /^        / {
            sub(/^ */, "")
            open[key] = $0
        }
        function ends(half) {
            print half ": " many " changes, " caught " caught, " look \
                " look elsewhere, " many - caught - look " survived, " \
                left " equivalent"
            M += many
            C += caught
            L += look
            many = caught = look = left = 0
        }
        END {
            for (h = 1; h <= 2; h++) {
                half = substr("cf", h, 1)
                for (i = 1; i <= n; i++) {
                    key = all[i]
                    if (key !~ "[.]" half ":") continue
                    is = text[key]
                    sub(/^[^)]*\) /, "", is)
                    if (is !~ /^caught/ && (line[key], open[key]) in equal) {
                        left++
                        continue
                    }
                    many++
                    caught += is ~ /^caught/
                    look += is ~ /^elsewhere/
                    print text[key]
                    if (is !~ /^caught/)
                        print "        " line[key] "\n        " open[key]
                }
                ends(half)
            }
            print "mutation: " M " changes, " C " caught, " L \
                " look elsewhere, " M - C - L " survived"
        }' "$@"
    exit
fi

mkdir -p $DIR/new
[ "$HALVES" = program ] || {
    # (what programs share, and the programs)
    rm -rf $DIR/shared.a $DIR/limbs.o $DIR/float.o $DIR/short.o $DIR/unit.o
    for f in test/lib/exact.c test/lib/hard.c test/lib/points.c \
        test/lib/verify.c $SHARED; do
        o=$DIR/$(basename $f .c).o
        $CC -O2 -I. -c -o "$o" $f || say "$f does not compile"
        ar rc $DIR/shared.a "$o"
    done
    for f in fuzz/certify unit/brute unit/t_pred unit/t_facet unit/t_part \
        unit/t_query unit/t_cells unit/t_natural twin/parity twin/shim \
        $(printf 'unit/%s ' $MESHES); do
        $CC -O2 -I. -c -o "$DIR/$(basename $f).o" test/$f.c ||
            say "$f.c does not compile"
    done
    for f in t_pred t_facet; do
        $CC -O2 -I. -DHH_LIMBS=3 -c -o $DIR/few.$f.o test/unit/$f.c
        $CC -O2 -I. -mfpmath=387 -c -o $DIR/x87.$f.o test/unit/$f.c
    done
}
$CC -O2 -o $DIR/mutation test/fuzz/mutation.c \
    || say "mutation.c does not compile"

# take HALF: its files, its tests
take() {
    HALF=$1
    MORE=
    case $HALF in
    c)
        FILES="tess.c hhpred.c"
        TEST="literals brute parity t_pred t_facet few x87 calls certify low"
        TEST="$TEST $MESHES t_part t_query asan"
        [ -z "$CHECK" ] ||
            TEST="literals brute parity t_pred t_facet few warned certify low limbs
                range float short unit more $MESHES t_part t_query t_cells t_natural asan"
        ;;
    f)
        FILES="tess.f hhpred.f"
        TEST="constants literals brute parity t_pred t_facet large asan calls"
        [ -z "$CHECK" ] ||
            TEST="constants literals brute parity t_pred t_facet warned large"
        TEST="$TEST $MESHES t_part t_query";;
    program)
        FILES="scan.c cell.c rows.c names.c doubts.c voids.c formats.c
            tables.c meshes.c models.c atoms.c arrays.c"
        TEST="readers messages contract properties"
        MORE="-fsanitize=undefined -fno-sanitize-recover=all";;
    esac
    TEST=${TESTS:-$TEST}
}

# of FILE: the half that it belongs to, and where it is
of() {
    case $1 in
    tess.c | hhpred.c) echo c;;
    *.f) echo f;;
    *) echo program;;
    esac
}
path() {
    case $(of $1) in
    c) echo $1;;
    f) echo f77/$1;;
    program) echo test/cli/src/read/$1;;
    esac
}

# compile TREE: the objects of the half in TREE.  (What a check of bounds says
# must not tell the trees apart.)
compile() {
    for f in $FILES; do
        [ -f $1/$f.o ] || case $f in
        *.c) $CC -O1 $MORE -I. -Itest/cli/src/read -c -o $1/$f.o $1/$f;;
        *.f) (cd $1 && gfortran -w -frecursive -fcheck=all -O1 \
            -ffixed-line-length-none -c -o $f.o $f);;
        esac || return 1
    done
}

# other TREE TEST PROGRAMS FLAGS: those of test/unit, and the library, so compiled
other() {
    kept=$DIR/$2.o
    if [ ! -d $kept ]; then
        mkdir $kept
        # shellcheck disable=SC2046 # a list of files
        for f in test/lib/points.c test/lib/exact.c test/lib/verify.c \
            test/lib/hard.c $SHARED $(printf 'test/unit/%s.c ' $3); do
            $CC $4 -O1 -I. -c -o "$kept/$(basename $f .c).o" $f || return
        done
        # shellcheck disable=SC2046 # a list of files
        ar rc $kept/shared.a $(printf "$kept/%s.o " points exact verify hard \
            $(basename -s .c $SHARED))
    fi
    for f in tess hhpred; do
        $CC $4 -O1 -I. -c -o $1/$2.$f.o $1/$f.c || return
    done
    for f in $3; do
        $CC -o $1/$2.$f $kept/$f.o $1/$2.tess.o $1/$2.hhpred.o $kept/shared.a \
            -lm || return
    done
}

# reads TREE NAME FLAGS: build/tess with the readers in TREE, so compiled; its
# other files are those of `make'
reads() {
    readers=
    for f in $FILES; do
        o=$1/$2.$f.o
        cmp -s $1/$f $OLD/$f && o=$OLD/$2.$f.o
        [ -f $o ] || $CC $3 -O1 -I. -Itest/cli/src/read -c -o $o $1/$f || return
        readers="$readers $o"
    done
    # shellcheck disable=SC2046 # a list of files
    $CC $3 -o $1/$2 $readers $(sed -n '/^PROGRAM = /,/[^\\]$/p' Makefile |
        tr ' ' '\n' | grep '\.o' |
        grep -E -v "/($(echo $FILES | sed 's/\.c//g; s/ /|/g'))\.o") \
        build/tess.o build/hhpred.o -lm
}

# links TREE TEST: the test with the library in TREE
links() {
    case $HALF$2 in
    ?calls | ?more | ?warned | ?literals | fconstants) ;;
    programproperties) reads $1 checked "-fsanitize=address,undefined
        -fno-sanitize-recover=all";;
    program*) [ -f $1/tess ] || reads $1 tess "$MORE -static";;
    cfew | cx87)
        flag=-DHH_LIMBS=3
        [ $2 = few ] || flag=-mfpmath=387
        $CC -I. -O1 $flag -c -o $1/$2.o $1/hhpred.c &&
            for f in t_pred t_facet; do
                $CC -o $1/$2.$f $DIR/$2.$f.o $1/$2.o $DIR/shared.a -lm || return
            done;;
    ccertify) $CC -I. -O1 -DTESS_PROVE -o $1/$2 $DIR/$2.o $1/tess.c \
        $1/hhpred.c.o $DIR/shared.a -lm;;
    clow) lowered $1/tess.c > $1/low.c && $CC -I. -O2 -DTESS_PROVE -o $1/$2 \
        $DIR/certify.o $1/low.c $1/hhpred.c.o $DIR/shared.a -lm;;
    casan)
        set -- $1 $2 "$CC -I. -O1 -fsanitize=address,undefined
            -fno-sanitize-recover=all"
        $3 -c -o $1/asan1.o $1/tess.c && $3 -c -o $1/asan2.o $1/hhpred.c &&
            for f in $MESHES t_part t_query; do
                $3 -o $1/asan.$f test/unit/$f.c $1/asan1.o $1/asan2.o \
                    $DIR/shared.a -lm || return
            done;;
    fasan)
        set -- $1 $2 "gfortran -w -std=legacy -frecursive -O1 -fsanitize=address
            -ffixed-line-length-none"
        $3 -c -o $1/asan.o $1/hhpred.f &&
            $3 -o $1/$2 $DIR/parity.o $DIR/shim.o $1/tess.f $1/asan.o -lm &&
            $3 -o $1/pred $DIR/t_pred.o $DIR/shim.o $DIR/shared.a \
                $1/tess.f.o $1/asan.o -lm &&
            $3 -o $1/facet $DIR/t_facet.o $DIR/shim.o $DIR/shared.a \
                $1/tess.f.o $1/asan.o -lm;;
    climbs) other $1 $2 brute -DHH_LIMBS=3;;
    crange) other $1 $2 t_range -DHH_LIMBS=6;;
    cfloat) other $1 $2 "brute t_pred t_facet" -DTESS_FLOAT;;
    cunit) other $1 $2 t_range "-mfpmath=387 -DTEST_X87";;
    cshort) other $1 $2 brute "-DTESS_INT=short -DTESS_LIST=48";;
    flarge) links $1 t_tess && cp $1/t_tess $1/$2;;
    c*) $CC -o $1/$2 $DIR/$2.o $1/tess.c.o $1/hhpred.c.o $DIR/shared.a -lm;;
    f*) gfortran -o $1/$2 $DIR/$2.o $DIR/shim.o $1/tess.f.o $1/hhpred.f.o \
        $DIR/shared.a -lm;;
    esac
}

# warned TREE: 0 if the compiler finds nothing that is not set, or not used.
# (Not all warnings: a change may be written as nobody would write it.)
warned() {
    for f in $FILES; do
        case $f in
        *.c) $CC -O1 -Wuninitialized -Wmaybe-uninitialized -Wunused \
            -Wreturn-type -Werror -c -o $1/warned.o $1/$f;;
        *.f) gfortran -std=f95 -frecursive -fcheck=all -O1 -Wuninitialized \
            -Wmaybe-uninitialized -Wunused -Werror -ffixed-line-length-none -c \
            -o $1/warned.o $1/$f;;
        esac || return
    done
}

# runs SECONDS PROGRAM ARGUMENT...: a change may make it run for ever, fill
# memory, or print without end
runs() {
    # shellcheck disable=SC3045 # all shells that there are know -t
    (ulimit -t $1; ulimit -f 20000; ulimit -v 4000000 2> /dev/null
        shift; exec "$@")
}

# passes TREE TEST: 0 if so; the first test that fails ends the long programs
passes() {
    links $1 $2 2> /dev/null || return 1
    case $2 in
    brute) runs 10 $1/$2 60;;
    t_pred | t_facet) runs $LIMIT $1/$2 15;;
    few | x87) runs $LIMIT $1/$2.t_pred 5 && runs $LIMIT $1/$2.t_facet 5;;
    certify | low) runs $LIMIT $1/$2 40 60;;
    limbs) runs $LIMIT $1/$2.brute 100;;
    range) runs $LIMIT $1/$2.t_range;;
    float) runs $LIMIT $1/$2.brute 100 && runs $LIMIT $1/$2.t_pred 10 &&
        runs $LIMIT $1/$2.t_facet 10;;
    unit) runs $LIMIT $1/$2.t_range;;
    short) runs $LIMIT $1/$2.brute 100;;
    more) runs $LIMIT $1/brute;;
    warned) warned $1;;
    large) runs $LIMIT $1/$2 -one ellipsoid 6000 1;;
    constants | literals) sh test/twin/$2.sh $1;;
    readers | messages | contract | properties)
        # shellcheck disable=SC3045 # all shells that there are know -t
        (ulimit -t $LONG
            program=$1/tess
            [ $2 != properties ] || program=$1/checked
            [ $2 = properties ] || ulimit -v 4000000
            TESS="$(pwd)/$program" sh test/cli/t/run.sh -x \
                --basetemp="$1/files" $2);;
    calls) sh test/twin/calls.sh $1 && cp build/calls/all.txt $1/calls;;
    asan)
        case $HALF in
        c) for f in $MESHES t_part t_query; do limited $LONG $1/asan.$f -quick || return; done;;
        f) limited $LONG $1/$2 > $1/out &&
            sh test/twin/sums.sh $1/out test/twin/parity.txt &&
            limited $LIMIT $1/pred 5 && limited $LIMIT $1/facet 5;;
        esac;;
    t_cells | t_natural) runs $LIMIT $1/$2;;
    t_*) runs $LONG $1/$2 -quick | awk '{ last = $0 }
        /^not ok/ { exit }
        END { exit last !~ /^1\.\./ }';;
    parity) runs 10 $1/$2 > $1/out &&
        sh test/twin/sums.sh $1/out test/twin/parity.txt;;
    esac > /dev/null 2>&1
}

# fresh TREE: the half
fresh() {
    rm -rf $1
    mkdir -p $1
    for f in $FILES; do cp "$(path $f)" $1; done
    [ $HALF != c ] || cp tess.h hhpred.h $1
}

# looks TREE: 1 if searches look at more; what is counted in TREE/looks
looks() {
    [ $HALF != program ] || { : > $1/looks; return; }
    [ -f $1/calls ] || passes $1 calls || return
    [ $HALF != c ] || sh test/bench/counts.sh $1 || return
    cp $1/calls $1/looks
    [ $HALF != c ] || cat build/looks/all.txt >> $1/looks
}

for half in $HALVES; do
    take $half
    OLD=$DIR/old.$HALF
    fresh $OLD
    compile $OLD || say "the library does not compile"
    [ $LOOKS = no ] || looks $OLD || say "counts are up without a change"
    for f in $FILES; do
        $DIR/mutation "$(path $f)" | sed "s/^/$f /"
    done | grep -E "$ONLY" > $DIR/all.$HALF
done

NEW=$DIR/new
# change FILE K: make it; 1 when it does not compile, 2 when that is the same
change() {
    take "$(of $1)"
    OLD=$DIR/old.$HALF
    fresh $NEW
    $DIR/mutation "$(path $1)" $2 > $NEW/$1 || return 1
    for f in $FILES; do
        [ $f = $1 ] || cp $OLD/$f.o $NEW
    done
    compile $NEW 2> /dev/null || return 1
    cmp -s $NEW/$1.o $OLD/$1.o && return 2
    return 0
}

# entry FILE LINE K: as in equivalents.  A change that a line allows more than
# once has (2), (3) ... behind it.
entry() {
    echo "$1: $(sed -n "$2{s/^ *//;s/ *\$//;p;}" "$(path $1)")"
    awk -v f="$1" -v line="$2" -v k="$3" '$1 == f && $3 == line {
        what = $0
        for (i = 0; i < 3; i++) sub(/^[^ ]* /, "", what)
        n = ++seen[what]
        if ($2 == k) print what (n > 1 ? " (" n ")" : "")
    }' $DIR/all.$HALF
}

# equivalent FILE LINE K: is it said to be so?
equivalent() {
    entry "$1" "$2" "$3" > $DIR/entry
    awk 'NR == FNR { want[NR] = $0; next }
        { sub(/^ */, "") }
        $0 == want[1] { at = FNR }
        at && FNR == at + 1 && $0 == want[2] { found = 1; exit }
        END { exit !found }' $DIR/entry test/fuzz/equivalents
}

# verdict FILE: which test catches it, or what survives
verdict() {
    for t in $TEST; do
        case $1$t in tess.?t_pred | tess.?t_facet | tess.cfew | tess.cx87) continue;; esac
        case $1$t in hhpred.ccertify | hhpred.clow) continue;; esac
        if ! passes $NEW $t; then
            # (the library itself, once for each test that finds something)
            [ -f $OLD/passed.$t ] || { passes $OLD $t && : > $OLD/passed.$t; } ||
                say "$t fails without a change"
            echo "caught by $t"
            return
        fi
    done
    if [ $LOOKS = no ]; then
        echo survived
    elif ! looks $NEW > /dev/null 2>&1; then
        # (which make check does not run)
        if [ -z "$CHECK" ]; then echo caught by counts; else echo elsewhere; fi
    elif cmp -s $NEW/looks $OLD/looks; then
        echo survived
    else
        echo elsewhere
    fi
}

if [ "$1" = -those ]; then
    list=$2
    while read file place rest; do
        change $file $place
        code=$?
        case $code in
        1) answer="does not compile";;
        2) answer="the same object code";;
        *) answer=`verdict $file` || exit;;
        esac
        what=`$DIR/mutation "$(path $file)" | awk -v k=$place '$1 == k'`
        set -- $what
        printf '%s\n' "$file:$2 ($place) $answer: ${what#* * }"
        case $answer in
        survived | elsewhere) entry $file $2 $place | sed 's/^/        /';;
        esac
    done < $list
    exit
fi

[ -z "$1" ] || N=$1
[ -z "$2" ] || SEED=$2
[ -z "$3" ] || SKIP=$3

# hunt HALF: the changes drawn, a line each
hunt() {
    take $1
    $DIR/mutation -draw "$(wc -l < $DIR/all.$HALF)" $SEED > $DIR/draw.txt
    done=0
    caught=0
    elsewhere=0
    survived=0
    same=0
    broken=0
    equal=0
    skip=$SKIP
    while [ $done -lt $N ] && read k; do
        what=`sed -n ${k}p $DIR/all.$HALF`
        set -- $what
        file=$1
        place=$2
        line=$3
        shift 3
        change $file $place
        case $? in
        1) broken=`expr $broken + 1`; continue;;
        2) same=`expr $same + 1`; continue;;
        esac
        if equivalent $file $line $place; then
            equal=`expr $equal + 1`
            continue
        fi
        if [ $skip -gt 0 ]; then
            skip=`expr $skip - 1`
            continue
        fi
        answer=`verdict $file` || exit
        done=`expr $done + 1`
        case $answer in
        caught*) caught=`expr $caught + 1`;;
        elsewhere) elsewhere=`expr $elsewhere + 1`;;
        *) survived=`expr $survived + 1`;;
        esac
        printf '%s\n' "$file:$line ($place) $answer: ${what#* * * }"
        case $answer in
        caught*) ;;
        *) entry $file $line $place | sed 's/^/        /';;
        esac
    done < $DIR/draw.txt
    echo "        the same object code $same, does not compile $broken," \
        "equivalent $equal"
    echo "$HALF: $done changes, $caught caught," \
        "$elsewhere look elsewhere, $survived survived"
}
{
    echo "Written by:${CHECK:+ CHECK=yes} mutation.sh $N $SEED $SKIP," \
        "of: $HALVES"
    echo
    for half in $HALVES; do hunt $half; done
} | tee $DIR/report
awk '/^(c|f|program): / { n += $2; c += $4; e += $6; s += $9 }
    END { print "mutation: " n " changes, " c " caught, " e " look elsewhere, " \
        s " survived" }' $DIR/report | tee -a $DIR/report
[ $SKIP != 0 ] || [ "$HALVES" != "c f" ] ||
    cp $DIR/report test/results/mutation.txt
