#@ -Eprecision=400
# A centre is the value of C over twice that of D, times 2^at.  leading_value is
# at most CARRY and a half, and at least 0.49.  Three squares do not overflow.
# (The slack is that of 2^C, not of C.)
far = ($CARRY$ + 1) / (2 * 0.49) * 1b$C$;
need_C = $C$ * $L$ / (4 * far);
need_C_squares = $C$ * $MAX$ / (4 * far * far);
{ need_C in ? /\ need_C_squares in ? }
