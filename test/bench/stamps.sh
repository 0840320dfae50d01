#!/bin/sh
# stamps.sh - tells which of test/results were measured with other code than this,
# by the sums of code.sh that they carry; 1 if there is one.  A change of a line
# does not wait for hours of measurements: `make check' only tells; `make
# release' asks for them.  Run from the top directory.
code=$(sh test/bench/code.sh)
old=0
# of FILE START COMMAND: has its line that begins so that sum?
of() {
    grep "^$2.*$code, " "test/results/$1" > /dev/null && return
    echo "warning: test/results/$1 is of other code than this ($code): $3"
    old=1
}
of bench.txt "Commit: .*; code " "make bench"
of evidence.txt "Code: " "make evidence"
exit $old
