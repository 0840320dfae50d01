#@ -Eprecision=4000
# What underflow does to the values that sign_if_certain is asked of.
#
# Each operation's result, and each coordinate, is off by MIN or less: gradual
# underflow, or flushing to zero, of operands or results.  A determinant as
# computed is a sum of products of exact terms and factors 1 + d, |d| <= EPS,
# and of terms that have some of these errors for factors.  The latter together
# are no larger than the size with them less the size without.  (So is what the
# permanent loses, EPS times which the bound loses.)
U = 1 + $EPS$;
T = $MIN$;
#size orient = hhpred.c orient_filter: det under T with [abcd]\[.\] = 1 + T
#size orient0 = hhpred.c orient_filter: det under 0 with [abcd]\[.\] = 1
need_D_orient = (orient - orient0) * (1 + 32 * $EPS$);
#size sphere = hhpred.c insphere_filter: det under T with [abcde]\[.\] = 1 + T
#size sphere0 = hhpred.c insphere_filter: det under 0 with [abcde]\[.\] = 1
need_D_sphere = (sphere - sphere0) * (1 + 64 * $EPS$);
#size dot = hhpred.c nearest_face_filter: dot[8] under T with s\[.*\] = 1 + T
#size dot0 = hhpred.c nearest_face_filter: dot[8] under 0 with s\[.*\] = 1
need_D_dot = (dot - dot0) * (1 + 32 * $EPS$);
#size area = hhpred.c nearest_face_filter: area[1] under T with s\[.*\] = 1 + T
#size area0 = hhpred.c nearest_face_filter: area[1] under 0 with s\[.*\] = 1
need_D_area = (area - area0) * (1 + 128 * $EPS$);
# hh_wider: four quarters, two differences and one more; of numbers of any size,
# but underflow is no greater for these
need_D_wider = (4 + 2 + 1 + 2) * T * U * U;
{ need_D_orient in ? /\ need_D_sphere in ? /\ need_D_dot in ? /\
  need_D_area in ? /\ need_D_wider in ? }
