#@ -Eprecision=400
# list_filter, for doubles of 53 bits; F is FEPS, E is EPS.
#
# With u the point, g the base, both from the list's origin, cu = 2 c and d = cu
# + 2 g, in the list's units, without errors a point of the true ball has
#     |u|^2 - d.u <= -k + 2 dc / 1.005 |u - g|, k = sum of g (g + cu).
# |u[i]| <= 2 max_abs[i] <= 2 (1.1 where g is 0), so |u|^2 <= 12, |u - g| <=
# 3.47 + off.  In single precision, in F: u, its square, d and d.u have
#     u^2: 2 of u, 1, and 2 + 3 of a sum of six in any order: 8, times 12
#     d.u: u, d, 1 and 3: 6, times |d[i] u[i]| <= 2 |d[i]| max_abs[i]: 12 sum
#     d[3]: 1 of k; what else is in it is too small by as much of itself
# In double precision, in E:
#     k: G roundings of |g| (|g| + |cu|), together at most off a
#     d: 2 of cu, 3 of 2 g, times |u| <= 2: 4 |cu| + 12 off
#     LIST_SHIFT: u is off by 4: 4 (|cu| + 2 off); d by 4 and 2 of itself
#     u: 2 of itself
# What is relative to d, or is not a multiple of it, is far below F: 4 F sum and
# F are more.  For off <= 1/2 there is F for 20 off, too; else 20 off <= C (1 +
# off) off.
F = 1b-23;
E = $EPS$;
U = 1 + F;
D = 1 - 8 * F;
need_A = (12 * ($U^8$ - 1) / F + (20 / 2 + 24 + 12 * 16) * E / F + 1) / D;
need_B = (2 * ($U^6$ - 1) / F + 1) / D;
need_K = 1 / D;
need_C_cu = 8 / D;
need_C_off = 20 / 1.5 / D;
need_C_k = ((1 + 2 * $G$ * E) * $G$) / D;
need_D = 2 / 1.005 / D;
need_S = 3.47 / D;
{ need_A in ? /\ need_B in ? /\ need_K in ? /\ need_C_cu in ? /\ need_C_off in ?
  /\ need_C_k in ? /\ need_D in ? /\ need_S in ? }
