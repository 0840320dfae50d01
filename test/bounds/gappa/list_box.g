#@ -Eprecision=4000
# LIST_BOX_MIN = X HH_LENGTH_MIN: a box's half width is at least that, a star
# list's reach M times as much: above HH_LENGTH_MIN.  Coordinates that
# underflowed are off by less than EPS/1024 in its units.
need_X = 1.01 / $M$;
need_X_off = 3 * $MIN$ / ($L$ * $EPS$ / 1024);
{ need_X in ? /\ need_X_off in ? }
