#@ -Eprecision=4000
# What underflow does to a point's power, or to its side: coordinates, in the
# filter's centre, too, are off by MIN or less, and so is each operation's
# result.
U = 1 + $EPS$;
T = $MIN$;
#size all = tess.c offer_leaf: power[0] under T with x\[.\] = 1 + T;
#     s.hh.* = 1 + T; filter.c.* = 2 * $L$ + T
#size none = tess.c offer_leaf: power[0] under 0 with x\[.\] = 1;
#     s.hh.* = 1; filter.c.* = 2 * $L$
need_X = all - none;
#size sall = hhpred.c hh_limits: side under T with z\[.\] = 1 + T;
#     f\[.*\] = 1.01 + T
#size snone = hhpred.c hh_limits: side under 0 with z\[.\] = 1; f\[.*\] = 1.01
need_X_side = sall - snone;
{ need_X in ? /\ need_X_side in ? }
