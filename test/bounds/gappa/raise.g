#@ -Eprecision=4000
# top_weight gives limb 0 the weight 2^(e + 2) / BASE of numbers below 2^e, of
# at least 2^(e - 1): 4 / BASE of the largest, or more.  R is 1/RAISE.
need_B = $MIN$ / ($R$ / 2 * 4 / $BASE$);
{ need_B in ? }
