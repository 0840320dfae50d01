#@ -Eprecision=400
# hh_centre: a quotient of two numbers right to V EPS (leading_value), two
# roundings if it is by the reciprocal, scaled.  What underflows there is less
# than MIN, beside EPS times a centre of at least HH_LENGTH_MIN nothing.
E = $EPS$;
U = 1 + E;
need_C = ((1 + $V$ * E) * $U^2$ / (1 - $V$ * E) - 1) / E + $MIN$ / ($L$ * E);
need_C_dc = (((1 + $V$ * E) * $U^2$ / (1 - $V$ * E) - 1) / E + $MIN$ / ($L$ * E)) * 1.01;
{ need_C in ? /\ need_C_dc in ? }
