#@ -Eprecision=400
# set_upper_bound: c = HH_CENTRE + l v, dc = HH_DC + |l| E + A eps c1.
#
# The product is rounded once, by eps |l| 1.01, the sum once, by eps c1; HH_DC
# and E have 2 % of room, of which dc keeps 0.5 %.  E >= 260 eps.
E = $EPS$;
D = 1 - E;
K = $D^P+2$ / 1.005;
need_A = 1 / (1 - E) / K;
ofE = (1 / 1.02 + 1.01 / 260) / K;
ofdc = 1 / 1.02 / K;
{ need_A in ? /\ ofE <= 1 /\ ofdc <= 1 }
