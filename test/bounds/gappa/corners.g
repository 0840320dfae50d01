# The permanent of an orientation of corners of the unit cube: six products of
# three differences of at most 1.
need_C = 6;
{ need_C in ? /\ $C$ <= 1b22 }
