#@ -Eprecision=400
# sign_of_limbs: behind a partial sum come limbs of at most 2^DIGITS, CARRY
# BASE: beside it CARRY + CARRY/BASE + ..., below CARRY / (1 - 1/BASE); and err
# units of the last limb, no more than err of this one.  A further sum, of at
# most (A CARRY + err) BASE + 2^DIGITS, err <= CARRY, is below 4 2^DIGITS:
# rounded by 4 units, it keeps its sign and is far above what ends the loop.
need_A = 1 / (1 - 1 / $BASE$);
{ need_A in ? /\ ($A$ * $CARRY$ + $CARRY$) * $BASE$ + 1b$DIGITS$ <= 4b$DIGITS$ }
