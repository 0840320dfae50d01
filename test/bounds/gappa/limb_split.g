# split_limbs: BELOW_HALF = A - B EPS.
#
# A remainder of less than half its weight is at most BELOW_HALF, the largest
# double below a half: its sum with that is at most 1 - EPS/2, a double, so
# rounded to less than 1, in any mode, and the limb is 0.  (need_B is by how
# much BELOW_HALF must at least be below a half.)  A remainder of up to BASE/2 +
# 1/4 leaves one within 1/2 + 1/(4 BASE): BASE times that is within BASE/2 + 1/4
# again, and its limb at most BASE/2.  The first remainder is at most BASE/4.
@fl = float<$FORMAT$, $MODE$>;
h = $A$ - $B$ * $EPS$;
y = fl(Y);
t = fl(y + h);
need_B = ((t - 1) / $EPS$ + 2 * $B$);
x = fl(X);
s = fl(x + h);
i = int<zr>(s);
need_A = $A$;
{ x in [0, $=BASE / 2 + 1 / 4$] /\ y in [0, $=A - B * EPS$]
  -> need_B in ? /\ need_A in ? /\ t <= $=1 - EPS / 2$
  /\ |i - x| <= $=1 / 2 + 1 / 4 / BASE$ }
i - x -> (i - s + 0.5) + (s - (x + h)) + (h - 0.5);
