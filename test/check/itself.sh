# shellcheck shell=sh
# shellcheck disable=SC2034,SC2154 # of check.sh, which reads this
# itself.sh - of check.sh: what it makes of programs' TAP, and that prove(1)
# thinks the same; how tests are run.

itself() {
    group "itself: " || return
    mkdir -p build/itself
    echo 'echo so far; exit 7' > build/itself/stops
    printf 'echo "%s"\n' "ok 1 - a" "not ok 2 - b" "# a line" 1..2 exit \
        > build/itself/fails
    echo 'echo "ok 1 # SKIP this"; echo "ok 2 - c"; echo 1..2' \
        > build/itself/skips
    echo 'echo "ok 1 - d"; echo 1..2' > build/itself/lacks
    echo 'echo "ok 1 - e"; echo 1..1; exit 3' > build/itself/code
    # nested: a program's own subtest that fails is counted once
    echo '. test/tests.sh; begin inner; pass f; subtest g sh build/itself/fails
        ended' > build/itself/nested
    # tried COMPLETE: the programs, as a part; what is said of them
    tried() {
        mkdir -p "build/parts/tried$1/build"
        : > "build/parts/tried$1/build/check.log"
        (
            COMPLETE=$1
            ONLY=
            LOG=build/itself/log
            begin tried
            for t in stops fails skips lacks code nested; do
                subtest $t sh build/itself/$t
            done
            pass own
            fail mine
            ended
        ) > "build/parts/tried$1.tap"
        COMPLETE=$1 LOG=build/itself/log report "tried$1"
    } > "build/itself/said$1"
    tried ""
    tried yes
    pwd=$(quoted "$(pwd)")
    while read -r file line; do
        check "itself: $line" grep -F "$line" "build/itself/$file"
    done << END
said FAILED  stops: 1 of 1
said stops: stopped with code 7 behind 0 tests
said run it alone: (cd$pwd && sh build/itself/stops)
said FAILED  fails: 1 of 2
said a line
said run it alone: (cd$pwd && sh build/itself/fails)
said ok      skips: 1,
said FAILED  lacks: 1 of 2
said FAILED  code: 1 of 2
said FAILED  nested: 1 of 3
said FAILED  tried: 1 of 2
said run it alone: CC=
saidyes FAILED  skips: 1 of 2
END
    check "itself: what is skipped" grep -x "skips: this" build/parts/skips
    printf '7 6 1\n7 7 0\n' > build/itself/counts
    check "itself: counts" diff build/itself/counts build/parts/counts
    # a test is one for prove, too
    if ! command -v prove > build/itself/prove; then
        skip "itself: no prove"
        return
    fi
    for t in skips:0 fails:1 stops:1 lacks:1 code:1 nested:1; do
        prove -e sh build/itself/${t%:*} > build/itself/prove 2>&1
        code=$?
        check "itself: prove on ${t%:*}" test $((code != 0)) -eq ${t#*:}
    done
    unit usual "$CC" "$CFLAGS" t_size
    check "itself: prove on a program of test/unit" \
        prove -e '' build/units/usual/t_size
    check "itself: prove on a part" \
        prove -e 'sh test/check.sh -part' symbols
}

# how a part is run: the same wherever make check is
signals() {
    for signal in HUP INT QUIT PIPE; do
        check "signals: $signal ends a program" sh -c "
            sh -c 'kill -s $signal \$\$; exit 0'; test \$? -gt 128"
    done
    check "signals: there is no terminal" sh -c '! (: < /dev/tty) 2>&1'
    check "signals: standard input is empty" sh -c 'read -r line; test $? -ne 0'
}
