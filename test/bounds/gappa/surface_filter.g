#@ -Eprecision=400
# set_surface_filter: near a plane a = -2 l / normal_height, the latter wrong by
# E 1.01 / 1.02 + 3 * 1.02 EPS, of at least 1/2, so a by twice that and 0.5 %;
# and by 2 roundings of the quotient, 3 of what is added and 1 of the sum.
#
# d = a tilt + 2 q c + b v: each term is rounded once, the sum 2 times, the
# quotient by q twice; and dd has 2 % of room for the errors of c and v, 0.8 %
# for that of tilt, of which 0.5 % remain (|v| <= 1.01).  Without a ball N, at
# most |w| (|w| + 2 rho 1.01), |w| <= 3.4642, counts as well.  dc is computed
# from dd by 3 roundings.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = $D^9$;
# 1 / (1 - x) <= 1.005 for x = 2 (S 1.01 / 1.02 + 4 E)
need_S = ((1 - 1 / 1.005) / 2 - 4 * E) * 1.02 / 1.01;
need_A = 2 * 1.005 * 1.01 / 1.02 / K;
need_Q = (2 * 1.005 * 3 * 1.02 + 6) / $A$ / K;
need_T = 2 / 1.02 * 1.005 / K;
need_D = 1.005 * ($U^5$ - 1) / E / K;
need_B = 3.4642 * 1.005 / K;
need_C = 2 * 1.01 * 1.005 / K;
{ need_S in ? /\ need_A in ? /\ need_Q in ? /\ need_T in ? /\ need_D in ?
  /\ need_B in ?
  /\ need_C in ? /\ 1 / 1.008 * 1.005 / K <= 1
  /\ 1.01 / 1.02 * 1.005 / K <= 1 }
