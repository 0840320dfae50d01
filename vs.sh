# vs.sh "families" "sizes": ours, cgal, ratio
for f in $1; do for n in $2; do a=$(timeout 100 build/bs $f $n 2 | awk '{print $6}'); b=$(timeout 100 build/bench_cgal $f $n 2| awk '{print $6}'); echo "$f $n ours $a cgal $b ratio $(awk "BEGIN{print ($a+0)/($b+0.001)}")"; done; done
