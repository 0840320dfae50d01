#@ -Eprecision=400
# ball_by_limbs: l = v.u, u = c (near a sphere, less another centre), is L to
# err = E size + B eps c1 (+ dc of that centre), size = |u|_1.
#
# v is wrong by E / 1.02, |v| <= 1.01; c by W eps c1; the products and their sum
# go through N roundings (near a sphere N + 1, with the difference); the
# difference or sum of l and err is rounded by eps |l|.  err has P roundings,
# and E >= 260 eps.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = $D^P+2$;
need_B = (1.01 * ($W$ + ($U^N$ - 1) / E) + 1.01) / K;
ofE = (1 / 1.02 + (1.01 * ($U^N+1$ - 1) / E + 1.01) / 260) / K;
{ need_B in ? /\ ofE <= 1 /\ 1 / 1.02 / K <= 1 }
