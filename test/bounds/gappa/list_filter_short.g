#@ -Eprecision=400
# list_filter, where a double has the 24 bits of a float, and LIST_SHIFT is 0:
# as in list_filter.g, but in F = FEPS = EPS
#     u^2: 4 of u, which is rounded twice, 1, and 2 + 3: 10, times 12
#     d.u: 2 of u, 1 and 3, and the last one of d: 7, times 2 sum
#     d[3]: 3 of k in a sum of four, and what else is in it
#     k: G roundings, in off a; d: 1 of cu, 2 of 2 g: 2 |cu| + 8 off
F = 1b-23;
U = 1 + F;
D = 1 - 8 * F;
need_A = 12 * ($U^10$ - 1) / F / D;
need_B = 2 * ($U^7$ - 1) / F / D;
need_K = ($U^3$ - 1) / F / D;
need_C_cu = 2 / D;
need_C_off = 8 / D;
need_C_k = (1 + 2 * $G$ * F) * $G$ / D;
need_D = 2 / 1.005 / D;
need_S = 3.47 / D;
{ need_A in ? /\ need_B in ? /\ need_K in ? /\ need_C_cu in ? /\ need_C_off in ?
  /\ need_C_k in ? /\ need_D in ? /\ need_S in ? }
