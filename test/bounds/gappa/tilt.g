# The sums of lemma S1 of lemmas.txt: choose_surface's tilt.  Each need_ is what
# suffices beside the other constants as they are.

E = $EPS$;
P2 = (1 + E) * (1 + E);
P5 = P2 * P2 * (1 + E);
# det beside n0 n1: the products of edges err by P5 - 1 of |a0|^2, |a1|^2, |a0
# a1|
Det = 2 * (P5 * P5 * P2 - 1);
# det is at least D eps n0 n1
Off = Det / ($D$ * E) * P5 * P5;
# n / det; the root, the product, the sums, h - tilt.a and the sums of err
# (0.8 % of room remain, for what tilt_err goes into)
need_F = P5 * P2 / (1 - Off) * P5 * P5 * P5 * (1.008 * 1.008);
need_D = Det / E * P5 * P5 / (1 - P5 * P5 * P5 * P5 * P2 / $F$);
# of size, 1-norm of both terms: out of the plane; along an edge
Size = P5 / (2 - P5);
Out = (1 + E) * P2 - 1;
need_B = Out / E * Size;
need_C = (Out + P2 * P2 - 1) / E * Size * P5;
# of heights: their difference, and twice the sum of errors
need_A = P2 * P5 / P2;

{ need_A in ? /\ need_B in ? /\ need_C in ? /\ need_D in ? /\ need_F in ? }
