#@ -Eprecision=400
# hh_limits: L is right to
#     dl = size (eps (A size + B rho) + dc + |l| E) (4 half) + C eps |l|.
#
# Let S be the side of w and N its power, s and p as computed, l' = p/(2 s):
#     |p - N| <= |w| (eps (N2 |w| + N1 2 rho) + 2 dc / 1.02) = da, as in ratio.g
#     |s - S| <= E |w| / 1.02 = db
#     |l' - N/(2 S)| = |p - N + 2 l' (S - s)| / (2 S)
#                   <= (da + 2 |l'| db) / (2 S)
# As s is greater than T E size, S is at least g s, g = 1 - 1/(1.02 T) and a
# little.  4 half is 2/s.  So the terms of dl must be those of da + 2 |l'| db
# over 4 g.  l is l' but for L roundings, and the sum or difference of l and dl
# has one more.  dl is at least (1-EPS)^P of what it stands for.
E = $EPS$;
U = 1 + E;
D = 1 - E;
g = 1 - 1 / (1.02 * $T$ * $D^4$);
K = $D^P$ * D;
need_A = ($U^N2$ - 1) / (4 * g * E * K);
need_B = 2 * 1.01 * ($U^N1$ - 1) / (4 * g * E * K);
dc = 2 / 1.02 / (4 * g * K);
lE = 2 / 1.02 / (4 * g * K * $D^L$);
need_C = ($U^L$ - 1 + E) / (E * K);
{ need_A in ? /\ need_B in ? /\ need_C in ? /\ dc <= 1 /\ lE <= 1 }
