/* shim.c - the calls of tess.h that the tests make, by way of the FORTRAN half:
 * a test in C linked with f77/tess.f and f77/hhpred.f in the place of tess.c and
 * hhpred.c.
 *
 * Arrays that a call reads are counted from 1 before it, and all from 0 after
 * it: only numbers that the call is promised to read or to write, so that
 * words it must not touch stay what they are.  Not for several threads at once,
 * as arrays that the caller sees as constant are altered meanwhile. */
#include "count.h"
#include "f77.h"

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

int hh_foot(const tess_real *a, const tess_real *b, const tess_real *c,
            const tess_real *q, double *w)
{
    double any[3];
    tess_int want = w != 0, set;

    hhfoot_(a, b, c, q, &want, w ? w : any, &set);
    return (int)set;
}

int hh_range(double x, double most)
{
    return (int)hhrang_(&x, &most);
}

int hh_facet(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             double *f)
{
    tess_int info;

    hhface_(p1, p2, p3, f, &info);
    return (int)info;
}

double hh_side(const double *f, const tess_real *z)
{
    return hhside_(f, z);
}

double hh_lcoord(const double *f, const tess_real *z)
{
    return hhlcoo_(f, z);
}

void hh_setup(const double *p1, const double *p2, const double *p3, double *f)
{
    hhsetu_(p1, p2, p3, f);
}

int hh_limits(const double *f, const double *z, double *lo, double *hi)
{
    tess_int side;

    hhlimi_(f, z, lo, hi, &side);
    return (int)side;
}

int tess_size(tess_int n, tess_int maxtet, tess_int *liw, tess_int *lrw)
{
    tess_int info;

    tesswk_(&n, &maxtet, liw, lrw, &info);
    return (int)info;
}

/* What a call has left of old tetrahedra. */
static int after(tess_int info, tess_int old, tess_int ntet, tess_int *tet,
                 tess_int *adj)
{
    both(tet, adj, info < 0 || ntet < old ? old : ntet, -1);
    return (int)info;
}

int tess(tess_int n, const tess_real *p, tess_int maxtet, tess_int *ntet,
         tess_int *tet, tess_int *adj, tess_int liw, tess_int *iw,
         tess_int lrw, double *rw)
{
    tess_int info;

    tess_(&n, p, &maxtet, ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    if (info == -2) --*ntet;
    if (info >= 0 && info != TESS_RANGE) count(iw, n, -1);
    return after(info, 0, *ntet, tet, adj);
}

int tess_resume(tess_int n, const tess_real *p, tess_int maxtet,
                tess_int *ntet, tess_int *tet, tess_int *adj, tess_int liw,
                tess_int *iw, tess_int lrw, double *rw)
{
    tess_int info, old = *ntet < 0 || *ntet > maxtet ? 0 : *ntet;

    both(tet, adj, old, 1);
    tessre_(&n, p, &maxtet, ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    if (info >= 0 && info != TESS_RANGE) count(iw, n, -1);
    return after(info, old, *ntet, tet, adj);
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

int tess_values(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, tess_int nv, const double *value,
                tess_int nq, const tess_real *q, tess_int *t, double *out)
{
    tess_int info, m = ntet < 0 ? 0 : ntet;
    tess_int k = nq > TESS_INT_MOST / 3 ? 0 : nq;

    both(tet, adj, m, 1);
    count(t, k, 1);
    tessva_(p, &ntet, (tess_int *)tet, (tess_int *)adj, &nv, value, &nq, q, t,
            out, &info);
    count(t, k, -1);
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
    tess_int info, m = ntet < 0 || ntet > TESS_INT_MOST / 4 ? 0 : ntet;

    both(tet, adj, m, 1);
    tessch_(&n, p, &ntet, (tess_int *)tet, (tess_int *)adj, &liw, iw, bad,
            &info);
    --*bad;
    both(tet, adj, m, -1);
    return (int)info;
}

/* The points of an index, iw[0..n-1], for an n that one can have. */
static tess_int indexed(tess_int n)
{
    tess_int liw, lrw;

    return tess_size(n, 0, &liw, &lrw) == 0 ? n : 0;
}

int tess_index(tess_int n, const tess_real *p, tess_int liw, tess_int *iw,
               tess_int lrw, double *rw)
{
    tess_int info;

    tessix_(&n, p, &liw, iw, &lrw, rw, &info);
    if (info >= 0 && info != TESS_RANGE) count(iw, n, -1);
    return (int)info;
}

int tess_part(tess_int n, const tess_real *p, const tess_int *mine,
              tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *adj,
              tess_int liw, tess_int *iw, tess_int lrw, const double *rw)
{
    tess_int info, old = *ntet < 0 || *ntet > maxtet ? 0 : *ntet;
    tess_int m = liw < n ? 0 : indexed(n);

    both(tet, adj, old, 1);
    count(iw, m, 1);
    tesspa_(&n, p, mine, &maxtet, ntet, tet, adj, &liw, iw, &lrw, (double *)rw,
            &info);
    count(iw, m, -1);
    return after(info, old, *ntet, tet, adj);
}

int tess_query(tess_int n, const tess_real *p, const tess_int *iw,
               const double *rw, const tess_real *q, tess_int *v, double *w)
{
    tess_int info, m = indexed(n);

    count(iw, m, 1);
    count(v, 4, 1);
    tessqu_(&n, p, (tess_int *)iw, rw, q, v, w, &info);
    count(v, 4, -1);
    count(iw, m, -1);
    return (int)info;
}

int tess_ball(const tess_real *p, const tess_int *v, double *c)
{
    tess_int info, u[4];
    int k;

    for (k = 0; k < 4; k++) u[k] = v[k] + 1;
    tessba_(p, u, c, &info);
    return (int)info;
}
