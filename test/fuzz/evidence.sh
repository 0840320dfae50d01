#!/bin/sh
# evidence.sh - what the tests cover, and ten minutes of each hunt; writes
# test/results/evidence.txt, whose figures the README has.
#
# Run from the top directory: make evidence, 40 minutes; TIME=600 seconds of
# each hunt, SEED=1.  PARTS="coverage certify torture" are run; a part that is
# left out is as when it was run last.  With a fault the file stays as it was.
CC=${CC:-cc}
TIME=${1:-600}
SEED=${2:-1}
B=build/evidence
mkdir -p $B

for part in ${PARTS:-coverage certify torture}; do
    case $part in
    coverage) sh test/fuzz/coverage.sh > $B/coverage || exit;;
    *)
        echo "$TIME seconds" > $B/$part.time
        sh "test/fuzz/$part.sh" "$TIME" "$SEED" > "$B/$part";;
    esac
done
{
    echo "Written by: make evidence"
    echo "Code: $(sh test/bench/code.sh), by test/bench/code.sh"
    echo "Machine: $(uname -sm), $(getconf _NPROCESSORS_ONLN) processors"
    $CC --version | head -n 1
    echo
    echo "Lines and branches that the tests in C run, all builds together:"
    echo
    cat $B/coverage
    echo
    echo "Bounds that the search relies on, each proven by exact integers where it"
    echo "is used, in sets made to be hard, for $(cat $B/certify.time):"
    echo
    awk '/ sets, .* certificates$/ {
            builds++
            for (i = 2; i <= NF; i++) {
                if ($i == "sets,") sets += $(i - 1)
                if ($i == "certificates") bounds += $(i - 1)
            }
        }
        END { printf "certify: %d builds, %.0f sets, %.0f certificates\n", builds,
            sets, bounds }
        /^ok/ { passed++ }
        /^not ok/ { failed++ }
        END { printf "certify: %d passed, %d failed\n", passed, failed }
        ' $B/certify
    echo
    echo "Results of the C and the FORTRAN half in many builds, each proven by"
    echo "test/lib/verify.c, and fuzzers with sanitizers, for $(cat $B/torture.time):"
    echo
    sed -n 's/^# \(torture: .* faults\)$/\1/p' $B/torture
} > $B/evidence.txt
cat $B/evidence.txt
if ! grep '^certify: .*, 0 failed$' $B/evidence.txt > $B/ended ||
    ! grep '^torture: .*, 0 faults$' $B/evidence.txt > $B/ended; then
    cat $B/certify $B/torture
    echo "evidence: a fault; test/results/evidence.txt is as it was"
    exit 1
fi
cp $B/evidence.txt test/results
