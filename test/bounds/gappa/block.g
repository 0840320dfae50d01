#@ -Eprecision=400
# ball_in_block: r = |c| (1 + R eps) + A dc covers |c| + 2 dc / 1.005, the
# roundings of r (CP of |c|), and those of the two sides of the comparison:
# where these are not ordered as they are when exact, they differ by less than
# 2.1 eps (|c| + r).
E = $EPS$;
D = 1 - E;
K = $D^CP$;
need_R = ((1 + 2.1 * 2.01 * E) / K - 1) / E * (1 + E);
need_A = (2 / 1.005 + 2.1 * 2.1 * E) / $D^2$;
{ need_R in ? /\ need_A in ? }
