#@ -Eprecision=400
# make_cylinder: pad = A eps M, M the sum of the absolute values of its box's
# coordinates, makes sure that each point x of the node is c + s u + p, |s| <=
# h, |p| <= r, p across u.
#
# u is a unit vector but for 4.55 eps: q over the root (2.5) of its square, a
# quotient by the reciprocal (2).  mid is any point, |mid|_1 <= 1.01 M.  In eps
# of M, all of y = x - mid, s = y.u, m = (lo + hi) / 2 at most 1.02 M:
#   y is wrong by 1.02; s by 3 * 1.02 more; p = y - s u by 2 * 1.02
#   c = mid + m u by 2 * 1.02 + (1.01 + 1.02) =: dc
# x - c - (s - m) u is y - s u - dc: its length is that of the computed p but
# for
#   1.02 + 2.04 + dc; sqrt(rr) is too small by 2.5 * 1.02, r by one rounding,
#   1.02.
# Its product with u, by which s must be moved to make it across u, is at most 4
# *
#   1.02 + 9.1 * 1.02 + dc; the half length loses 3 * 1.02.
E = $EPS$;
dc = 2 * 1.02 + 1.01 + 1.02;
need_A_r = (1.02 + 2.04 + dc + 2.5 * 1.02 + 1.02) * (1 + 100 * E);
need_A_h = (4 * 1.02 + 9.1 * 1.02 + dc + 3 * 1.02) * (1 + 100 * E);
{ need_A_r in ? /\ need_A_h in ? }
