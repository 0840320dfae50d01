/* shim.c - the calls of tess.h, and the exact signs, by way of their Fortran names, so that a test
 * in C can be linked with f77/tess.f and f77/hhpred.f, or with the C files
 * compiled with TESS_FORTRAN, in the place of tess.c and hhpred.c.
 *
 * Arrays that a call reads are counted from 1 before it, and all from 0 after
 * it: only numbers that the call is promised to read or to write, so that
 * words it must not touch stay what they are. */
#include "../../tess.h"

extern void tesswk_(tess_int *n, tess_int *maxtet, tess_int *liw,
                    tess_int *lrw, tess_int *info);
extern void tess_(tess_int *n, const tess_real *p, tess_int *maxtet,
                  tess_int *ntet, tess_int *tet, tess_int *adj, tess_int *liw,
                  tess_int *iw, tess_int *lrw, double *rw, tess_int *info);
extern void tessre_(tess_int *n, const tess_real *p, tess_int *maxtet,
                    tess_int *ntet, tess_int *tet, tess_int *adj,
                    tess_int *liw, tess_int *iw, tess_int *lrw, double *rw,
                    tess_int *info);
extern void tesslo_(const tess_real *p, tess_int *ntet, tess_int *tet,
                    tess_int *adj, const tess_real *q, tess_int *t, double *w,
                    tess_int *info);
extern void tesshu_(tess_int *ntet, tess_int *tet, tess_int *adj,
                    tess_int *maxfac, tess_int *nfac, tess_int *fac,
                    tess_int *info);
extern void tessch_(tess_int *n, const tess_real *p, tess_int *ntet,
                    tess_int *tet, tess_int *adj, tess_int *liw, tess_int *iw,
                    tess_int *bad, tess_int *info);
extern tess_int hhorie_(const tess_real *a, const tess_real *b,
                        const tess_real *c, const tess_real *d);
extern tess_int hhinsp_(const tess_real *a, const tess_real *b,
                        const tess_real *c, const tess_real *d,
                        const tess_real *e);

int hh_orient(const tess_real *a, const tess_real *b, const tess_real *c,
              const tess_real *d)
{
    return (int)hhorie_(a, b, c, d);
}

int hh_insphere(const tess_real *a, const tess_real *b, const tess_real *c,
                const tess_real *d, const tess_real *e)
{
    return (int)hhinsp_(a, b, c, d, e);
}

static void count(tess_int *a, tess_int n, tess_int by)
{
    tess_int i;

    for (i = 0; i < n; i++) a[i] += by;
}

/* tet and adj, which the caller sees as constant and will see unaltered */
static void both(const tess_int *tet, const tess_int *adj, tess_int ntet,
                 tess_int by)
{
    count((tess_int *)tet, 4 * ntet, by);
    count((tess_int *)adj, 4 * ntet, by);
}

int tess_size(tess_int n, tess_int maxtet, tess_int *liw, tess_int *lrw)
{
    tess_int info;

    tesswk_(&n, &maxtet, liw, lrw, &info);
    return (int)info;
}

/* What tess and tess_resume have left of old tetrahedra. */
static int after(tess_int info, tess_int n, tess_int old, tess_int *ntet,
                 tess_int *tet, tess_int *adj, tess_int *iw)
{
    if (info >= 0 && info != TESS_RANGE) count(iw, n, -1);
    both(tet, adj, info < 0 || *ntet < old ? old : *ntet, -1);
    return (int)info;
}

int tess(tess_int n, const tess_real *p, tess_int maxtet, tess_int *ntet,
         tess_int *tet, tess_int *adj, tess_int liw, tess_int *iw,
         tess_int lrw, double *rw)
{
    tess_int info;

    tess_(&n, p, &maxtet, ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    if (info == -2) --*ntet;
    return after(info, n, 0, ntet, tet, adj, iw);
}

int tess_resume(tess_int n, const tess_real *p, tess_int maxtet,
                tess_int *ntet, tess_int *tet, tess_int *adj, tess_int liw,
                tess_int *iw, tess_int lrw, double *rw)
{
    tess_int info, old = *ntet < 0 || *ntet > maxtet ? 0 : *ntet;

    both(tet, adj, old, 1);
    tessre_(&n, p, &maxtet, ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    return after(info, n, old, ntet, tet, adj, iw);
}

int tess_locate(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, const tess_real *q, tess_int *t,
                double *w)
{
    tess_int info, m = ntet < 0 ? 0 : ntet;

    both(tet, adj, m, 1);
    ++*t;
    tesslo_(p, &ntet, (tess_int *)tet, (tess_int *)adj, q, t, w, &info);
    --*t;
    both(tet, adj, m, -1);
    return (int)info;
}

int tess_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
              tess_int maxfac, tess_int *nfac, tess_int *fac)
{
    tess_int info, m = ntet < 0 ? 0 : ntet;

    both(tet, adj, m, 1);
    tesshu_(&ntet, (tess_int *)tet, (tess_int *)adj, &maxfac, nfac, fac, &info);
    both(tet, adj, m, -1);
    if (info >= 0) count(fac, 3 * (*nfac < maxfac ? *nfac : maxfac), -1);
    return (int)info;
}

int tess_check(tess_int n, const tess_real *p, tess_int ntet,
               const tess_int *tet, const tess_int *adj, tess_int liw,
               tess_int *iw, tess_int *bad)
{
    tess_int info, m = ntet < 0 ? 0 : ntet;

    both(tet, adj, m, 1);
    tessch_(&n, p, &ntet, (tess_int *)tet, (tess_int *)adj, &liw, iw, bad,
            &info);
    --*bad;
    both(tet, adj, m, -1);
    return (int)info;
}
