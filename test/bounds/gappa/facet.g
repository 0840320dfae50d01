# The sums of lemmas H1 to H5 of lemmas.txt: hh_setup's normal, and a side.
# Names are those of the lemmas, each an upper bound; need_A and need_B are what
# E = EPS (A s + B) needs.  Other bounds rest on E of at least 260 EPS.

E = $EPS$;
# H1: the reflector of three coordinates, and what it makes of a vector
N3 = sqrt((1 + E) * (1 + E) * (1 + E)) * (1 + E) - 1;
U3 = (1 + N3) * (1 + E) - 1;
B3 = (1 + E) / ((1 - N3) * (1 - U3) * (1 - E)) - 1;
T3 = (1 + B3) * (1 + E) * (1 + U3) * (1 + E) * (1 + E) * (1 + E) - 1;
C3 = E + (1 + E) * 2 * ((1 + T3) * (1 + U3) * (1 + E) - 1);
# the one of two
N2 = (1 + E) * (1 + E) - 1;
U2 = (1 + N2) * (1 + E) - 1;
B2 = (1 + E) / ((1 - N2) * (1 - U2) * (1 - E)) - 1;
T2 = (1 + B2) * (1 + E) * (1 + U2) * (1 + E) * (1 + E) - 1;
C2 = E + (1 + E) * 2 * ((1 + T2) * (1 + U2) * (1 + E) - 1);
V = C2 + C3 * (1 + C2);
# H2: the two edges
A1 = E / (1 - E);
B1 = (E + C3 * (1 + E)) / (1 - 64 * E);
Bover = B1 / E;
# H3: the exact s over the computed one
S = (1 + N2) / ((1 - E) * (1 - E) * (1 - E) * (1 - E));
# H4: the angle between the normals, its sine over s eps; the chord over the
# sine, as s eps is at most HH_E_MAX / A
Tau = ((B1 + A1) * S + A1) / E;
Sine = Tau * (1 / 2 / $A$) * (1 + 8 * E);
K = sqrt(2 / (1 + sqrt(1 - Sine * Sine)));
# H5: the side; 1 for underflow, 8 E for the roundings of E |w|
D = V + ((1 + E) * (1 + E) * (1 + E) * (1 + E) - 1) * (1 + V);
need_A = K * Tau * (1 + 8 * E);
need_B = (D / E + 1) * (1 + 8 * E);

{ Bover in [0, 60] /\ Sine in [0, 0.5] /\ need_A in ? /\ need_B in ?
  /\ ($A$ + $B$) / 260 >= 1 }
