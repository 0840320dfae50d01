#@ -Eprecision=400
# ball_in_star_list: margin = reach (1 - R eps) - A dc.
#
# With a and b as they are for c as computed, the ball is within reach if reach
# (reach - 2 a - 2 dc / 1.005) >= 2 b, or 2 |c| + 2 dc / 1.005 <= reach.  Of
# what is computed: margin <= (reach (1 - R eps) - A dc) (1 + eps)^SM; |c|, a by
# half of SQ roundings and one more; b by SB; each product and difference by
# one.
#   2 |c| <= margin (1 + eps)^(SQ/2 + 2): R must exceed SM + SQ/2 + 2.
#   margin (margin - 2 a) >= 2 b, all as computed, q = margin - 2 a >= 0:
#     reach >= margin (1 + (R - SM) eps)
#     reach - 2 a - 2 dc >= q + margin (R - SM - SQ/2 - 1) eps
#     reach (reach - 2 a - 2 dc) >= margin q (1 + (R - SM) eps)
#     2 b <= margin q (1 + (SB + 2) eps): R must exceed SM + SB + 2, and SM +
#       SQ/2 + 1
# (0.1 is for the terms of second order.)
E = $EPS$;
need_R_first = $SM$ + $SQ$ / 2 + 2 + 0.1;
need_R_second = $SM$ + $SB$ + 2 + 0.1;
need_R_third = $SM$ + $SQ$ / 2 + 1 + 0.1;
need_A = 2 / 1.005 * (1 + 9 * E);
{ need_R_first in ? /\ need_R_second in ? /\ need_R_third in ? /\ need_A in ? }
