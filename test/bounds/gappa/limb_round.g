#@ -Eprecision=200
# round_limb: within 1/2 + W/BASE of q, |q| <= M CARRY.
#
# The sum with the offset is positive and below 2 CARRY, so it is wrong by less
# than one unit of its last place, W/BASE in any rounding mode; what is left of
# it behind the point is cut off.  (With more digits it is wrong by less.)  The
# remainder of an integer q BASE after it is an integer, too: it would be at
# most BASE/2 + W if the bound were attained, and is at most BASE/2 + 1.
@fl = float<$FORMAT$, $MODE$>;
q = fl(Q);
sum = q + ($CARRY$ + $H$);
s = fl(sum);
i = int<zr>(s);
r = i - $CARRY$;
off = r - q;
need_W_up = (off - 0.5) * $BASE$;
need_W_down = (-off - 0.5) * $BASE$;
need_H = 0.5;
{ |q| <= $=M * CARRY$ -> need_W_up in ? /\ need_W_down in ? /\ need_H in ? }
off -> (i - s + 0.5) + (s - sum) + ($H$ - 0.5);
