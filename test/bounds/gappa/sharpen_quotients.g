#@ -Eprecision=400
# sharpen_by_height: normal_height errs by E / 1.02 (1.01) and 3 roundings of at
# most 1.02, so by E + B EPS.  Of a plane's quotients the difference, the
# divisor, the quotient (2) and the product with 1 -+ R EPS are rounded, and 4
# EPS are the room that hh_ratio wants.  Of a sphere's the difference, the
# divisor (1, and one of E size, which has 2 % of room), the quotient (2), the
# product with R EPS and the difference.
E = $EPS$;
need_B = 3 * 1.02 * (1 + 9 * E);
need_R_plane = (1 + 1 + 2 + 1 + 4) * (1 + 99 * E);
need_R_sphere = (1 + 2 + 2 + 1 + 1) * (1 + 99 * E);
{ need_B in ? /\ need_R_plane in ? /\ need_R_sphere in ? /\ 1.01 / 1.02 <= 1 }
