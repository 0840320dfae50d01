#@ -Eprecision=400
# orient_filter's C: |det - exact| <= C EPS perm, but for underflow.
#
# Counting: a term of the determinant is a product of three differences (3
# roundings), of two multiplications (2), and goes through one difference and
# two sums (3): the computed one is t (1+d1)...(1+d8), |d| <= EPS, where t is
# exact.  Contraction leaves out a factor; in another order of the sums a term
# goes through no more of them.  Likewise the permanent: as computed it is at
# least (1-EPS)^8 times the sum of |t|.  The product with it and the sum with
# DET_UNDERFLOW are rounded: 2 more.
#
# Gappa: (1+EPS)^8 - 1 <= C EPS (1-EPS)^10.
E = @EPS@;
U = 1 + E;
D = 1 - E;
U2 = U * U;
U4 = U2 * U2;
U8 = U4 * U4;
D2 = D * D;
D4 = D2 * D2;
D8 = D4 * D4;
need_C = (U8 - 1) / (E * D8 * D2);
{ need_C <= @C@ /\ need_C in ? }
