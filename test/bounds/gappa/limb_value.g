#@ -Eprecision=200
# leading_value: right to C EPS of itself.
#
# Limbs r0, of at least 1 and at most CARRY, and r1, r2, r3 of at most BASE/2 +
# 1 as carry leaves them, integers (r0 < 0 is the mirror image); the limbs
# behind them, t units of r3, at most (BASE/2 + 1)/(BASE - 1), below 1/2 +
# 2/BASE.  A quotient by BASE is exact; each sum is rounded.
@fl = float<$FORMAT$, $MODE$>;
B = $BASE$;
S2 = r3 / B + r2;
s2 = fl(S2);
S1 = s2 / B + r1;
s1 = fl(S1);
S0 = s1 / B + r0;
s0 = fl(S0);
exact = r0 + (r1 + (r2 + (r3 + t) / B) / B) / B;
err = S0 - exact;
need_C = |(s0 - exact) / exact| / $EPS$;
{ @FIX(r0, 0) /\ @FIX(r1, 0) /\ @FIX(r2, 0) /\ @FIX(r3, 0)
  /\ r0 in [1, $CARRY$] /\ |r1| <= $=BASE / 2 + 1$ /\ |r2| <= $=BASE / 2 + 1$
  /\ |r3| <= $=BASE / 2 + 1$ /\ |t| <= $=1 / 2 + 2 / BASE$
  -> need_C in ? }
err -> ((s1 - S1) + ((s2 - S2) - t / B) / B) / B;
(s0 - exact) / exact -> (1 + (s0 - S0) / S0) * (1 + err / exact) - 1
  { S0 <> 0, exact <> 0 };
