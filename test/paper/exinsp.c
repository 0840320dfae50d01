/* exinsp.c - the exact sign of exact.c, for FORTRAN 77: EXINSP(A, B, C, D, E),
 * an INTEGER function. */
#include "../proof/exact.h"

int exinsp_(const double *a, const double *b, const double *c,
            const double *d, const double *e);

int exinsp_(const double *a, const double *b, const double *c,
            const double *d, const double *e)
{
    return ex_insphere(a, b, c, d, e);
}
