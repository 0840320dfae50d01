#@ -Eprecision=400
# rounded_height: C eps size spread.  Of a sphere N2 roundings of u^2, N1 of 2
# u c, and size spread >= |u|^2 + |u| |c|; of a plane N1 of u c, |c| <= 1.01.
E = $EPS$;
U = 1 + E;
D = 1 - E;
K = E * $D^P$;
need_C_square = ($U^N2$ - 1) / K;
need_C_centre = 2 * ($U^N1$ - 1) / K;
need_C_plane = 1.01 * ($U^N1$ - 1) / K;
{ need_C_square in ? /\ need_C_centre in ? /\ need_C_plane in ? }
