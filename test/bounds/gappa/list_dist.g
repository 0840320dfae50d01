#@ -Eprecision=400
# LIST_DIST_ERR, for doubles of 53 bits; F is FEPS.
#
# Two coordinates of at most 2 are off by 2 F each, and 8 EPS: a distance by
# root 3 times that.  Its square then has 5 roundings (a difference, squared, a
# product and two sums), so it 2.5; the bound has 1 when it becomes a float, 1
# of the sum and 0.5 of the square, and EPS: 5 F of a distance of at most
# 3.4642.  (Beyond that all points are within.)  What passes is within reach +
# (R + that) F: within 1.1 reach, as reach >= M.
F = 1b-23;
off = sqrt(3) * 2 * (2 * F + 8 * $EPS$) / F;
U = 1 + F;
far = 3.4642 * ($U^5$ - 1 + $EPS$) / F;
need_R = (off + far) * (1 + 9 * F);
need_M = ($R$ + need_R) * F / 0.1 * (1 + 9 * F);
{ need_R in ? /\ need_M in ? }
