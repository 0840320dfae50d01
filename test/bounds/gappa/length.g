#@ -Eprecision=4000
# HH_LENGTH_MIN = M: what underflow does to a power, or a side, seen from a
# base.
#
# Coordinates are off by MIN, differences w and centres, too, and each product.
# hh_ratio's bound has room of 2 EPS size^2 and 1.8 EPS size rho, size >= M, a
# centre's coordinates are at most 1.01 rho.  What underflow does is no more
# than what it does to w of size M and centres of 0, and what the latter's
# product with errors of w adds: linear in the centre.
U = 1 + $EPS$;
T = $MIN$;
S = $M$;
t = T + 3 * T * U;
#size all = hhpred.c hh_ratio: power under T with w[012] = S + t; f\[.*\] = T
#size none = hhpred.c hh_ratio: power under 0 with w[012] = S; f\[.*\] = 0
#size more = hhpred.c hh_ratio: power under T with w[012] = S + t;
#     f\[.*\] = S + T
#size less = hhpred.c hh_ratio: power under 0 with w[012] = S; f\[.*\] = S
need_M = (all - none) / (2 * $EPS$ * S);
need_M_centre = (more - less) / (1.8 * $EPS$ * S);
{ need_M in ? /\ need_M_centre in ? }
