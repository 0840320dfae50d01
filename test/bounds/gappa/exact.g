# Determinants that are exact in doubles: permanents of at most 2^(DIGITS-C)
# units.
#
# All coordinates are integers, in some unit, and so are the results of all
# operations of a determinant or permanent.  Those below 2^DIGITS are exact:
# that is what Gappa proves, for each rounding mode.  Suppose that some
# operation of a determinant is not exact, on the way to it by factors that are
# not 0, and take the first such: its exact result is 2^DIGITS or more in
# absolute value.  The permanent has the same operation of absolute values,
# whose exact result is no smaller, so whose rounded one is at least 2^DIGITS,
# as that is a double; then it adds numbers that are not negative and multiplies
# by factors of at least 1, both rounded monotonely: it is at least 2^DIGITS, as
# computed.  So a smaller one means that what was rounded was multiplied by 0.
# (A sum that is contracted, reassociated or kept with more digits is exact,
# too.)
@fl = float<$FORMAT$, $MODE$>;
need_C = 1 + |fl(x) - x|;
{ @FIX(x, 0) /\ |x| <= $MOST$
  -> need_C in ? /\ 1b$DIGITS$ * 1b-$C$ <= $MOST$ }
