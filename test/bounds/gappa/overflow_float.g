#@ -Eprecision=400
# NEAR_BALL_MAX: |w|_1 (|w|_1 + 2 |c|_1), |w|_1 <= 6, is at most half of
# FLT_MAX.
need_N = (1b127 / 6 - 6) / 2;
{ need_N in ? }
