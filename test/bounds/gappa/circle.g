# The sums of lemma H6 of lemmas.txt: hh_setup's circumcentre.  Names are those
# of the lemmas, each an upper bound; lengths are in units of the true radius.
# need_C and need_D are what dc = EPS rho (C s + D) needs: the same share of
# both, as s >= 1.  Other bounds rest on dc of at least 800 EPS
# rho, and 3 E rho.

E = $EPS$;
# as in facet.g
N3 = sqrt((1 + E) * (1 + E) * (1 + E)) * (1 + E) - 1;
U3 = (1 + N3) * (1 + E) - 1;
B3 = (1 + E) / ((1 - N3) * (1 - U3) * (1 - E)) - 1;
T3 = (1 + B3) * (1 + E) * (1 + U3) * (1 + E) * (1 + E) * (1 + E) - 1;
C3 = E + (1 + E) * 2 * ((1 + T3) * (1 + U3) * (1 + E) - 1);
N2 = (1 + E) * (1 + E) - 1;
U2 = (1 + N2) * (1 + E) - 1;
B2 = (1 + E) / ((1 - N2) * (1 - U2) * (1 - E)) - 1;
T2 = (1 + B2) * (1 + E) * (1 + U2) * (1 + E) * (1 + E) - 1;
C2 = E + (1 + E) * 2 * ((1 + T2) * (1 + U2) * (1 + E) - 1);
V = C2 + C3 * (1 + C2);
A1 = E / (1 - E);
B1 = (E + C3 * (1 + E)) / (1 - 64 * E);
S = (1 + N2) / ((1 - E) * (1 - E) * (1 - E) * (1 - E));
Tau = (B1 + A1) * S + A1;
# the greatest s
Smax = 1 / 2 / $A$ / E * (1 + 8 * E);

# (a) between the circumcentres of the facet as it was transformed and of the
# true one, along the three axes: D1, and D2 and Tau beside s
D1 = A1 * (2 * (1 + E) + 1);
D2 = (B1 * (2 * (1 + B1) + 1) + D1) * S;
Moved = sqrt(D2 * D2 + Tau * Tau);
Mmax = D1 + Moved * Smax;
# (b) y1 errs by N3; y2, beside s
W2 = ((1 + N2) * (1 + E) - 1) +
     ((1 + E) * (1 + E) * (1 + E) * (1 + E) * (1 + E) / (1 - N2) - 1) +
     N3 * (1 + 16 * E);
Wmax = N3 + W2 * Smax;
# (c) all that is beside s, and all else; 1 eps for underflow; the least that
# the computed radius can be
Beside = Moved + (1 + Mmax) * W2;
Else = D1 + (1 + Mmax) * N3 + V * (1 + Mmax) * (1 + Wmax) + E;
Least = (1 - Mmax - (1 + Mmax) * Wmax) * (1 - N2);
Needs = Beside / E / Least * (1 + 8 * E);
Needed = Needs + Else / E / Least * (1 + 8 * E);
Share = Needed / ($C$ + $D$);
Slope = Needs / (Share * $C$);
need_C = Share * $C$;
need_D = Share * $D$;

{ Mmax in [0, 0.5] /\ Slope in [0, 1] /\ need_C in ? /\ need_D in ?
  /\ ($C$ + $D$) / 800 >= 1 /\ $C$ / (3 * $A$) >= 1
  /\ ($C$ + $D$) / (3 * ($A$ + $B$)) >= 1 }
