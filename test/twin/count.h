/* count.h - for shim.c and recipes.c: arrays counted from 1 for a call of
 * FORTRAN, and from 0 after it. */
#include "../../tess.h"

static void count(const tess_int *a, tess_int n, tess_int by)
{
    tess_int i;

    for (i = 0; i < n; i++) ((tess_int *)a)[i] += by;
}

static void both(const tess_int *tet, const tess_int *adj, tess_int ntet,
                 tess_int by)
{
    count(tet, 4 * ntet, by);
    count(adj, 4 * ntet, by);
}
