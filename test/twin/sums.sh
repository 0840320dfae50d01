#!/bin/sh
# sums.sh - the sections of a text that parity.c writes: the first
# line of each, how many lines it has, and their checksum.
#
#     sums.sh TEXT         writes them; so parity.txt is made
#     sums.sh TEXT SUMS    compares them with those of the file SUMS: a section
#                          of another sum is written whole, and the code is 1
#
# Run from the top directory.
D=build/sums.$$
mkdir -p $D
trap 'rm -rf $D' EXIT
awk -v d=$D 'NR == 1 || /^= / { close(f); f = d "/" sprintf("s%04d", NR) }
    { print > f }' "$1"
for f in $D/s*; do
    printf '%s %d %s\n' "$(head -n 1 $f | tr -s ' ')" "$(wc -l < $f)" \
        "$(cksum < $f | sed 's/ .*//')"
done > $D/all
if [ -z "$2" ]; then
    cat $D/all
    exit
fi
cmp -s $D/all "$2" && exit
for f in $D/s*; do
    read -r line <&3
    grep -Fxq "$line" "$2" || cat $f
done 3< $D/all
diff "$2" $D/all
