#@ -Eprecision=400
# normalize_weights: numbers right to V EPS (leading_value) over their sum, all
# positive: 3 sums, and a quotient, two roundings if it is by the reciprocal.
E = $EPS$;
U = 1 + E;
D = 1 - E;
need_C = ((1 + $V$ * E) * $U^N$ / ((1 - $V$ * E) * $D^P$) - 1) / E;
{ need_C in ? }
