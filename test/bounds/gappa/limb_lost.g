#@ -Eprecision=400
# value_in_ball: products that weigh less than the last row.  n <= N limbs: in
# the row behind it at most 3 n products of (BASE/2 + 1) BASE, and 2 n of
# (BASE/2 + 1)^2; in each further row as many, which weigh 1/BASE of that.  C is
# CARRY.
B = $BASE$;
H = B / 2 + 1;
need_C = (3 * $N$ * H * B + 2 * $N$ * H * H) / B / (1 - 1 / B);
{ need_C in ? }
