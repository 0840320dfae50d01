#@ -Eprecision=400
# LEFT_LIST = L: norm2 is at least L^2 (1 - 2 FEPS).  With a + 2 dc <= M, in the
# list's units, off <= a and sum <= S: the coefficients d together are at most 2
# a (1 + 4 FEPS), so |d.x| <= 2.01 M L, and d[3] <= FEPS (128 + 16 S + 4 M^2) +
# 16 EPS (1 + M) M + M (4 + M) + M^2: the greater part of L^2 remains, and
# nothing is as large as 2^127.
F = 1b-23;
d3 = F * (128 + 16 * $S$ + 4 * $M$ * $M$) + 16 * $EPS$ * (1 + $M$) * $M$
  + $M$ * (4 + $M$) + $M$ * $M$;
left = $L$ * $L$ * (1 - 4 * F) - 2.01 * $M$ * $L$ * (1 + 4 * F)
  - d3 * (1 + 9 * F);
need_M = $L$ / 2.2;
need_L = 2.2 * $M$;
{ need_M in ? /\ need_L in ? /\ left / $L$ >= 1
  /\ 3 * $L$ * $L$ + 3 * $M$ * $L$ + d3 <= 1b127 }
