/* loops.c - the loops of the timings; see loops.h. */
#include "loops.h"

#include "../../hhpred.h"
#include "blas.h"
#include "round.h"

void lp_house(const int *n, const double *p, const int *nz, const double *z,
              double *sum)
{
    double f[HH_FACET_LEN], s = 0.0;
    int i, j = 0;

    hh_facet(p, p + 3, p + 6, f);
    for (i = 0; i < *n; i++) {
        s += hh_lcoord(f, z + 3 * j);
        if (++j == *nz) j = 0;
    }
    *sum = s;
}

void lp_dets(const int *n, const double *p, const int *nz, const double *z,
             double *sum)
{
    double m[RA_MINORS], s = 0.0;
    int i, j = 0;

    ra_minors(p, p + 3, p + 6, p + 9, m);
    for (i = 0; i < *n; i++) {
        s += ra_det(m, z + 3 * j);
        if (++j == *nz) j = 0;
    }
    *sum = s;
}

#ifdef CBLAS
void lp_blas(const int *n, const double *p, const int *nz, const double *z,
             double *sum)
{
    double f[9], s = 0.0;
    int i, j = 0;

    bl_facet(p, p + 3, p + 6, f);
    for (i = 0; i < *n; i++) {
        s += bl_lcoord(f, z + 3 * j);
        if (++j == *nz) j = 0;
    }
    *sum = s;
}
#endif
