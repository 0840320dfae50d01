#@ -Eprecision=400
# A value whose terms go through N roundings, beside the sum of their absolute
# values, as computed with P roundings: the error is at most C EPS times that.
# A term is wrong by at most a factor of (1+EPS)^N, and the sum is at least
# (1-EPS)^P times what it stands for.
E = $EPS$;
U = 1 + E;
D = 1 - E;
need_C = ($U^N$ - 1) / (E * $D^P$);
{ need_C <= $C$ /\ need_C in ? }
