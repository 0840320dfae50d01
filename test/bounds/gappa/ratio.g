#@ -Eprecision=400
# hh_ratio: the error of the power is at most
#     err = size (eps (A size + B rho) + D dc).
#
# N2 and N1 roundings count for the terms w[k]^2 and 2 c[k] w[k], whose sums are
# at most |w|_1^2 and 2 |c| |w|_1, |c| <= 1.01 rho; dc has 2 % of room, so the
# error of c counts for 2 |w| dc / 1.02.  err is at least (1-EPS)^P of what it
# stands for, as size is of |w|_1.
E = $EPS$;
U = 1 + E;
D = 1 - E;
need_A = ($U^N2$ - 1) / (E * $D^P$);
need_B = 2 * 1.01 * ($U^N1$ - 1) / (E * $D^P$);
need_D = 2 / 1.02 / $D^P$;
{ need_A in ? /\ need_B in ? /\ need_D in ? }
