/* loops.c - the loops of the timings; see loops.h. */
#include "loops.h"

#include "../../hhpred.h"
#include "blas.h"
#include "round.h"

void lp_house(const int *n, const double *p, const int *nz, const double *z,
              double *v)
{
    double f[HH_FACET_LEN];
    int i, j = 0;

    hh_facet(p, p + 3, p + 6, f);
    for (i = 0; i < *n; i++) {
        v[j] = hh_lcoord(f, z + 3 * j);
        if (++j == *nz) j = 0;
    }
}

void lp_dets(const int *n, const double *p, const int *nz, const double *z,
             double *v)
{
    double m[RA_MINORS];
    int i, j = 0;

    ra_minors(p, p + 3, p + 6, p + 9, m);
    for (i = 0; i < *n; i++) {
        v[j] = ra_det(m, z + 3 * j);
        if (++j == *nz) j = 0;
    }
}

#ifdef CBLAS
void lp_calls(const int *n, const double *p, const int *nz, const double *z,
              double *v)
{
    double f[9];
    int i, j = 0;

    bl_facet(p, p + 3, p + 6, f);
    for (i = 0; i < *n; i++) {
        v[j] = bl_calls(f, z + 3 * j);
        if (++j == *nz) j = 0;
    }
}

void lp_blas(const int *n, const double *p, const int *nz, const double *z,
             double *v)
{
    double f[9];
    int i, j = 0;

    bl_facet(p, p + 3, p + 6, f);
    for (i = 0; i < *n; i++) {
        v[j] = bl_lcoord(f, z + 3 * j);
        if (++j == *nz) j = 0;
    }
}
#endif
