#@ -Eprecision=4000
# What underflow does to orient_filter's determinant: each operation's result,
# and each coordinate, is off by @MIN@ or less.  The determinant as computed is
# a sum of products of exact terms and factors 1 + d, |d| <= EPS, and of terms
# that have some of these errors for factors.  The latter together are no
# larger than the size with them less the size without.
U = 1 + @EPS@;
T = @MIN@;
#size all = hhpred.c orient_filter: det under T with [abcd]\[.\] = 1 + T
#size none = hhpred.c orient_filter: det under 0 with [abcd]\[.\] = 1
need_D = all - none;
{ need_D <= @D@ /\ need_D in ? }
