#@ -Eprecision=400
# hh_centre: a quotient of two numbers right to V EPS (leading_value), two
# roundings if it is by the reciprocal, scaled.  What underflows there is less
# than MIN, beside EPS times a centre of at least HH_LENGTH_MIN nothing.
# A is what the centre of a filter needs, which has 0.5 % of room.
E = $EPS$;
U = 1 + E;
need_C = ((1 + $V$ * E) * $U^2$ / (1 - $V$ * E) - 1) / E + $MIN$ / ($L$ * E);
need_A = need_C * 1.005;
{ need_C in ? /\ need_A in ? }
