#@ -Eprecision=400
# What fits one limb: sums of K products of limbs of at most BASE, below
# 2^DIGITS, and, over BASE, what round_limb takes.  Between two calls of carry
# there are at most R rows of T products, what carry left (BASE/2 + 1), and what
# it carries in (CARRY).  With four products, or three times the rows, in
# foot_by_limbs and centre_by_limbs, one factor has been carried or both.
B = $BASE$;
need_K = ($R$ * $T$ * B * B + B / 2 + 1 + $CARRY$) / (B * B);
need_K_four = ($R$ * 4 * (B / 2 + 1) * B + B / 2 + 1 + $CARRY$) / (B * B);
need_K_three = (3 * $R$ * (B / 2 + 1) * (B / 2 + 1) + B) / (B * B);
{ need_K in ? /\ need_K_four in ? /\ need_K_three in ?
  /\ $K$ * B * B <= 1b$DIGITS$ /\ $K$ * B <= $=0.97 * CARRY$ }
