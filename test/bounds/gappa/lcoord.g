#@ -Eprecision=400
# hh_facet's dL: L as computed is right to
#     |w| (eps (A |w| + B rho) + dc + |L| E) / g + C eps |L|,
# g = |v.w| - E |w|.  As in limits.g, but the side is at least g + (1 - 1/1.02)
# E |w|, more than g (1 + 5 eps), as E is at least 260 eps and g at most 1.01
# |w|; and dc, of at least 800 eps rho, has 2 % of room, which B shares.
E = $EPS$;
U = 1 + E;
r = 1 - 1 / 1.02;
more = 1 + r * 260 * E / 1.01;
need_A = ($U^N2$ - 1) / (2 * E * more);
need_B = 2 * 1.01 * ($U^N1$ - 1) / (2 * E * more) - 400 * r;
need_C = ($U^3$ - 1) / E;
{ need_A in ? /\ need_B in ? /\ need_C in ? }
