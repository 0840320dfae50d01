#@ -Eprecision=400
# tess_ball: the centre is right to V eps of each coordinate, seen from a vertex
# (x), its sum with that vertex to one rounding, the radius, of BN roundings, to
# V eps more; size is |x|_1 + |sum|_1.  r + R eps size must exceed the true
# radius and the distance of the centres; its own BP roundings take from r, too,
# which is at most 1.01 |x|_1.  T is for what underflows, before and after the
# last scaling: DBL_MIN in each coordinate of the centre, and in the radius.
E = $EPS$;
U = 1 + E;
D = 1 - E;
sum = (1 + $V$ * E) * $U^BN$ - 1 + $V$ * E + 1.01 * ($U^BP$ - 1) + E;
need_R = sum / (E * $D^BP+3$);
need_T = (sqrt(3) + 1) * (1 + 9 * E);
{ need_R in ? /\ need_T in ? }
