#@ -Eprecision=400
# choose_cap: the ball that holds a cap has the centre c - u n, wrong by at most
# dc / 1.005, and its points have a power of at most 2 u (h - n.base).
#
# As n[k] = c[k] / r, |n| is at most 1.01, |n|_1 at most N = 1.74; coordinates
# are at most 1.  So u <= 1.01 |c| but for its roundings; c - u n has NU
# roundings of u n, NC of c; dc one of dc, three of what is added, c1 two.
#
# In eps: h, the greatest product of n and a point, is too small by ND N, and
# one N more as it is stored; n.base too large by ND N; their difference, with C
# eps added, which is at most 2 N and little more, loses S of itself, and with P
# in filter_bound.  What underflows is some DBL_MIN, times u, or less than dc has
# to spare, as c1 is no less than EPS/8: far below.
E = $EPS$;
U = 1 + E;
D = 1 - E;
N = 1.74;
nd = ($U^ND$ - 1) / E;
nu = ($U^NU$ - 1) / E;
nc = ($U^NC$ - 1) / E;
need_A_c = 1.005 * (nu * 1.01 * 1.01 * $U^ND$ + nc) / $D^6$;
need_A_dc = 1 / $D^4$;
need_C = (N * (2 * nd + $U^ND$) + (2 * N + 100 * E) * (1 - $D^S$ * $D^P$) / E)
    / ($D^S$ * $D^P$);
{ need_A_c in ? /\ need_A_dc in ? /\ need_C in ? }
