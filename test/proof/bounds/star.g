#@ -Eprecision=400
# ball_in_star_list: margin = reach (1 - R eps) - A dc.
#
# With a and b as they are for c as computed, the ball is within reach if reach
# (reach - 2 a - 2 dc / 1.01) >= 2 b, or 2 |c| + 2 dc / 1.01 <= reach.  Of what is
# computed: margin <= (reach (1 - R eps) - A dc) (1 + eps)^M; |c|, a by half of Q
# roundings and one more; b by B; each product and difference by one.
#   2 |c| <= margin (1 + eps)^(Q/2 + 2): R must exceed M + Q/2 + 2.
#   margin (margin - 2 a) >= 2 b, all as computed, q = margin - 2 a >= 0:
#     reach >= margin (1 + (R - M) eps)
#     reach - 2 a - 2 dc >= q + margin (R - M - Q/2 - 1) eps
#     reach (reach - 2 a - 2 dc) >= margin q (1 + (R - M) eps)
#     2 b <= margin q (1 + (B + 2) eps): R must exceed M + B + 2, and M + Q/2 + 1
# (0.1 is for the terms of second order.)
E = $EPS$;
need_R_first = $M$ + $Q$ / 2 + 2 + 0.1;
need_R_second = $M$ + $B$ + 2 + 0.1;
need_R_third = $M$ + $Q$ / 2 + 1 + 0.1;
need_A = 2 / 1.01 * (1 + 9 * E);
{ need_R_first in ? /\ need_R_second in ? /\ need_R_third in ? /\ need_A in ? }
