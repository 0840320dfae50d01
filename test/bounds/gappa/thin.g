#@ -Eprecision=400
# hh_thin, in eps.  n, exact but for V, is divided by its length, V and half of
# 3 roundings and 1, by 2: v errs by the sum.  The side: w, products and sums, 4
# more.  a, b are rounded once, aa, bb to 5, their products with b, a and the
# difference to 8 of |a| |b| (|a| + |b|), at most twice that length of the
# vector: 16.  n x d: both, and two roundings of a vector no longer than the
# root of 2 times |n| |d|; over twice the length of n.  A and B are at least
# what others rest on: the E and dc of the best facet in hh_setup.
E = $EPS$;
V = $V$;
v = V + (V + 3 / 2 + 1) + 2;
need_A_side = 1.02 * (v + 4) * (1 + 99 * E);
need_A_others = 260;
c = v + 16 + 2 * sqrt(2) + (V + 3 / 2 + 1) + 2;
need_B_centre = 1.02 * c * (1 + 99 * E);
need_B_others = 800;
{ need_A_side in ? /\ need_A_others in ? /\ need_B_centre in ?
  /\ need_B_others in ? }
