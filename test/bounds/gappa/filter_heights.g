#@ -Eprecision=400
# The terms of heights in a surface filter's powers: weight h and weight
# base_height go through H roundings in offer_point, raise through X in
# excludes_box, where it has R before; weight is a / q, two roundings more, a
# itself one.  Marks, and the ends of their ranges, are exact.  h and
# base_height are at most -lowest, and |base_height|.  Near the bound, allowance
# is computed with P roundings, and goes through one more.
E = $EPS$;
U = 1 + E;
D = 1 - E;
need_C_point = ($U^H+3$ - 1) / (E * $D^P+1$);
need_C_box = ($U^X+R+3$ - 1) / (E * $D^P+1$);
{ need_C_point in ? /\ need_C_box in ? }
