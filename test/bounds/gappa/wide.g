#@ -Eprecision=400
# ball_is_empty: filter_bound's WP roundings, |w|_1 and |v|, of at most 4 EPS
# more than 1, take from (hi - lo) (1 + R EPS).
E = $EPS$;
D = 1 - E;
need_R = ((1 + 4 * E) / $D^WP+6$ - 1) / E;
{ need_R in ? }
