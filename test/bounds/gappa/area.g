#@ -Eprecision=4000
# hh_area: what underflow does to numbers below 1/B, beside R = 1/RAISE: to
# halves, a difference, products and one more difference.  It is B times less
# than what is allowed.
U = 1 + $EPS$;
T = $MIN$;
d = 1 / $B$;
t = 3 * T * U;
product = d * t * U + d * t * U + t * t * U + T;
lost = (2 * product * U + T) * (1 + 16 * $EPS$);
need_B = $B$ * lost / $R$;
{ need_B in ? }
