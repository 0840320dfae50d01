#@ -Eprecision=400
# filter_bound: size (A dc + C EPS (size + B c1)) + allowance.
#
# The terms w[k]^2 and 2 c[k] w[k] of a power go through N2 and N1 roundings in
# offer_point (HH_POWER), X2 and X1 in excludes_box, L2 and L1 in offer_leaf;
# their sums are at most |w|_1^2 and 2 c1 |w|_1, and size, as computed,
# (1-EPS)^3 |w|_1 or more.  c is wrong by dc / 1.005 at most, which counts for 2
# |w| dc / 1.005. The bound is at least (1-EPS)^P of what it stands for, c1
# (1-EPS)^2.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = $D^P+6$;
need_A = 2 / (1.005 * K);
need_C_point = ($U^N2$ - 1) / (E * K);
need_C_box = ($U^X2$ - 1) / (E * K);
need_C_leaf = ($U^L2$ - 1) / (E * K);
need_B_point = 2 * ($U^N1$ - 1) / ($C$ * E * K);
need_B_box = 2 * ($U^X1$ - 1) / ($C$ * E * K);
need_B_leaf = 2 * ($U^L1$ - 1) / ($C$ * E * K);
{ need_A in ? /\ need_C_point in ? /\ need_C_box in ? /\ need_C_leaf in ?
  /\ need_B_point in ? /\ need_B_box in ? /\ need_B_leaf in ? }
