#@ -Eprecision=400
# sharpen_by_height: the height and base_height go through H roundings, the terms
# of tilt.w through T.  err is at least (1-EPS)^P of what it stands for; what is in
# it of other errors has 1 % of room for that.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = E * $D^P$;
need_A = ($U^H$ - 1) / K;
need_B = ($U^T$ - 1) / K;
{ need_A in ? /\ need_B in ? /\ 1 / 1.01 <= 0.991 /\ $D^P$ >= 0.991 }
