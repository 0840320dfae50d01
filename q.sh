gcc -O3 -DTESS_COUNT -o build/bc test/bench.c test/points.c tess.c hhpred.c -lm && gcc -O3 -o build/bs test/bench.c test/points.c tess.c hhpred.c -lm
for f in $1; do for n in $2; do timeout 60 build/bc $f $n 1|tail -1 | cut -d' ' -f2-13,16-17,6-9,24-; timeout 60 build/bs $f $n 1;  done; done
