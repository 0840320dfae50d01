#!/bin/sh
# sh test/mpi/bench.sh - what test/mpi/mesh.c costs beside one tess; make mpi
# first.  Writes test/results/mpi.txt, a table in Markdown, too.
#
#   SETS="uniform 1000000 2, uniform 1000000 8"   families, sizes, processes
SETS=${SETS:-"uniform 1000000 2, uniform 1000000 8, uniform 1000000 64,
    clusters 1000000 8, lattice 1000000 8, gridrot 200000 8, globe 200000 8"}
dir=build/mpi
mkdir -p $dir test/results

{
    echo "| points | n | processes | CPU of all / tess | rounds |" \
        "known beyond own | memory of the worst / one's share | sent: move |" \
        "halo | hashes | stars | neighbours |"
    echo "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |" \
        "---: | ---: | ---: |"
    echo "$SETS" | tr ',' '\n' | while read -r family n processes; do
        [ -n "$processes" ] || continue
        rm -f $dir/o.*
        build/same -write $dir/p.raw "$family" "$n" || exit 1
        if ! mpirun --oversubscribe --allow-run-as-root -np "$processes" \
            build/mesh -raw $dir/p.raw -o $dir/o >$dir/out 2>$dir/err \
            </dev/null || ! build/same $dir/o "$processes" $dir/p.raw \
            >>$dir/out; then
            echo "| $family | $n | $processes | FAILED |"
            continue
        fi
        awk -v family="$family" '
            { for (i = 2; i < NF; i += 2) f[$1 $i] = $(i + 1) }
            END {
                share = f["same:memory"] / f["mesh:processes"]
                printf "| %s | %d | %d | %.2f | %d | %.2f | %.2f |", family,
                    f["mesh:points"], f["mesh:processes"],
                    f["mesh:cpu"] / f["same:cpu"], f["mesh:rounds"],
                    f["mesh:known"], f["mesh:memory"] / share
                printf " %.1f | %.1f | %.1f | %.1f | %.1f |\n", f["mesh:move"],
                    f["mesh:halo"], f["mesh:hashes"], f["mesh:stars"],
                    f["mesh:sides"]
            }' $dir/out
    done
    rm -f $dir/o.* $dir/p.raw
    echo
    echo "CPU: seconds of all processes, files not counted, beside those of" \
        "tess; memory: the most a process had, beside that of tess over the" \
        "processes; sent: MB, all processes together."
} | tee test/results/mpi.txt
