#@ -Eprecision=400
# hh_limits: where the side is not certain it is at most side + T err, with room
# of 4 EPS of it for the last roundings of hh_ratio (a difference, and a
# quotient that may be by the reciprocal).  The side is at most side + E |w| /
# 1.02 and about |w|, err at least 260 EPS |w| but for 4 roundings; its sum with
# the side has one.
E = $EPS$;
D = 1 - E;
need_T = 1 / (1.02 * $D^4$) + (6 + 1.01) / (260 * $D^4$);
{ need_T in ? }
