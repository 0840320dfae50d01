#@ -Eprecision=4000
# L_MAX: nothing overflows.  Largest are the products in exclude_cylinders, of
# balls with c up to 2 L_MAX, and of half-spaces, with dc up to 5 L_MAX.  (The
# slack is that of a product; MAX is half of what overflows.)
U = 1 + $EPS$;
E = $EPS$;
c1 = 6 * $L$ * U;
size = 20;
g = 2 + 2 * $L$;
gg = 3 * g * g;
rr = 4;
sum = 3 * (2 * (g + 2 * $L$)) + 2 * (2 + 6 * g) + rr
  + size * (2 * 5 * $L$ + 128 * E * c1 + 64 * E * size) + $L$;
need_L = $L$ * $MAX$ / (sum * sum * U + 4 * rr * gg * 1.01);
{ need_L in ? }
