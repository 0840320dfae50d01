#@ -Eprecision=400
# set_half_space: c = H2 L_MAX v, dc = L_MAX (H E + C eps), or with Z for E.
#
# A better point is on the open side: (v + dv).w > 0, |dv| <= E / 1.02.  So its
# power |w|^2 - 2 c.w is at most |w|^2 + L_MAX (E / 1.02 + 1.01 eps) |w|, as c
# is rounded once and |v| <= 1.01; |w|_1 is at most 6.  The filter grants 2 dc /
# 1.005 times |w|, as in filter.g, with dc computed by 3 roundings.
#
# Where the normal is not known, all points must pass: |2 c.w| <= L_MAX |v| |w|.
# v is a unit vector times two reflectors I - b u u', as computed: b = 1/t, t =
# n (n + |a|) > DBL_MIN, n the length of the column, a its first element, and
# |u|^2 = (|a| + n)^2 + r^2, r^2 the sum of the other squares.  If squares below
# DBL_MIN are flushed to zero n^2 lacks at most DBL_MIN for each but one: then b
# |u|^2 is at most 2 + 2 DBL_MIN / t, t >= n^2 >= DBL_MIN, in the first column,
# where two may be flushed, and 2 + DBL_MIN / t in the second: the reflectors
# are at most 3 and 2 long, and v, with roundings, 6.1.
E = $EPS$;
L = $L$;
D = 1 - E;
K = $D^3$ / 1.005;
need_H = 0.5 / 1.02 / K;
need_C = (6 / L + 1.01 * E) / (2 * E) / K;
need_Z = 6.1 * 1.01 / K;
{ need_H in ? /\ need_C in ? /\ need_Z in ? }
