#@ -Eprecision=400
# exclude_cylinders: the sum errs by at most
#     size (T dc + A eps c1 + C eps size), size >= |w|_1 + 2 (h + r),
# and rho, with B eps |g|^2 added, is not too small.
#
# A point is z = w + s u + p, |s| <= h, |p| <= r, p across u (make_cylinder sees
# to that).  Let W be |w|, S = W + 2 h + 2 r, A0 = 1.02 (W + |c|) >= a; |u|^2 is
# 1 but for 9.1 eps.  In eps, of the power of z:
#   w, as it stands in the code: NWW W^2 + 2 NWC W |c|
#   s^2 |u|^2 + 2 s g.u >= t (t - 2 a) - 2 h da - 9.1 h^2, a wrong by da = 1.01
#     (AW W + AC |c|); and NT t^2 + 2 NT t a for its roundings, t <= h
#   |p|^2 + 2 p.g >= the least of |p|^2 - 2 |p| rho', rho' the length of w - c,
#     w as computed, across u; the difference counts for 2 r W; rr for NR r^2
#   c by dc / 1.005, which counts for 2 |z| <= 2 S
# Each coefficient is at most that of C (W + 2 h + 2 r)^2 + A |c| (W + 2 h + 2
# r).  What is subtracted is at least (1-EPS)^P of that.
#
# rho as computed, in eps of |g'|^2, g' = w - c, w as computed: gg is too small
# by 5; a^2 too large by 2 * 4 1.02 + 1, and 9.1 for |u|^2; the sum loses 3; and
# 1 as the product with B eps is rounded.  past > 0 only if sum^2 > 4 rr rho:
# where both products are rounded they are so monotonely; where one is
# contracted, the other one's rounding counts for 1, and where it underflows, it
# loses no more than the least number that past, rounded as well, can be.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = $D^P$;
ww = ($U^NWW$ - 1) / E;
wc = ($U^NWC$ - 1) / E;
aw = 1.01 * ($U^AW$ - 1) / E;
ac = 1.01 * ($U^AC$ - 1) / E;
nt = ($U^NT$ - 1) / E;
nr = ($U^NR+1$ - 1) / E;
need_C_ww = ww / K;
need_C_hw = (2 * aw + 2 * 1.02 * nt) / 4 / K;
need_C_hh = (9.1 + nt) / 4 / K;
need_C_rr = nr / 4 / K;
need_C_rw = 2 / 4 / K;
need_A_wc = 2 * wc / K;
need_A_hc = (2 * ac + 2 * 1.02 * nt) / 2 / K;
need_T = 2 / 1.005 / K;
need_B = (5 + 2 * 4 * 1.02 + 1 + 9.1 + 3 + 1 + 1) * (1 + 100 * E);
{ need_C_ww in ? /\ need_C_hw in ? /\ need_C_hh in ? /\ need_C_rr in ?
  /\ need_C_rw in ? /\ need_A_wc in ? /\ need_A_hc in ? /\ need_T in ?
  /\ need_B in ? }
