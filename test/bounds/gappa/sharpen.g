#@ -Eprecision=400
# sharpen_by_height: the height and base_height go through H roundings, the
# terms of tilt.w through T.  err is at least (1-EPS)^P of what it stands for;
# what is in it of other errors has 0.5 % of room for that.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = E * $D^P$;
need_A = ($U^H$ - 1) / K;
need_G = ($U^T$ - 1) / K;
{ need_A in ? /\ need_G in ? /\ 1 / 1.005 <= 0.996 /\ $D^P$ >= 0.996 }
