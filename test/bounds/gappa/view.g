#@ -Eprecision=400
# excludes_by_view: the least u (u - 2 d) over a box errs, coordinate by
# coordinate, by C eps u (u + B (|c| + |p| + |x|)), u the largest |z - x|.
#
# In eps: d = c - p is wrong by V |c|, p by |p|, their difference by |d|, and
# that counts for 2 u; the box's ends by u, which counts for 2 (u + |d|), the
# slope there; N roundings follow, of u^2 and 2 u |d|; |d| <= |c| + |p|:
#     u (2 (V |c| + |p| + |d|) + 2 (u + |d|) + N (u + 2 |d|)).
# err is at least (1-EPS)^P of what it stands for.
E = $EPS$;
U = 1 + E;
D = 1 - E;
n = ($U^N$ - 1) / E;
K = $D^P$;
need_C = (2 + n) * (1 + 9 * E) / K;
need_B_c = (2 * $V$ + 4 + 2 * n) * (1 + 9 * E) / ($C$ * K);
need_B_p = (2 + 4 + 2 * n) * (1 + 9 * E) / ($C$ * K);
{ need_C in ? /\ need_B_c in ? /\ need_B_p in ? }
