#@ -Eprecision=400
# marked_height: mark k has heights from lowest + k quanta to lowest + (k + 1)
# quanta, but for C EPS MARKS quanta.  M is MARKS.
#
# A mark is the integer part of (h - err - lowest) / quantum: h errs by err, 8
# eps of at most MARKS / 2 quanta (and DET_UNDERFLOW), which counts twice at the
# upper end; h - err is rounded by MARKS / 2 eps, the next difference by MARKS
# eps; the quotient by a power of two is exact.  So the height in the middle,
# which is exact, errs by half a quantum and C EPS MARKS: by less than one.
E = $EPS$;
need_C = (2 * 8 / 2 * (1 + 4 * E) + 1.5 * (1 + 4 * E));
{ need_C in ? /\ 0.5 + $C$ * E * $M$ <= 1 /\ $M$ * 4 <= 1b$DIGITS$ }
