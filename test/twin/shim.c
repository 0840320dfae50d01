/* shim.c - the calls of tess.h and hhpred.h that the tests make, by way of the
 * FORTRAN half: a test in C linked with f77/tess.f and f77/hhpred.f in place of
 * tess.c and hhpred.c.
 *
 * Arrays that a call reads are counted from 1 before it, and all from 0 after
 * it: only numbers that the call is promised to read or to write, so that
 * words it must not touch stay what they are.  Not for several threads at once,
 * as arrays that the caller sees as constant are altered meanwhile. */
#include "count.h"
#include "f77.h"

#include <string.h>

#ifndef TEST_STACK
/* Foul the stack that the call is about to use: with what is no number and no
 * index, with what is huge, and with small indices, in turn.  So a call that
 * reads what it has not written, or beyond its arrays, fails. */
#define FOULED 30000 /* integers: what any call uses */
#define FEW 2500     /* for what is called most */

static void *(*volatile copy)(void *, const void *, size_t) = memcpy;

static void foul(const int *with)
{
    int stack[FOULED];

    copy(stack, with, sizeof stack);
}

static void foulfew(const int *with)
{
    int stack[FEW];

    copy(stack, with, sizeof stack);
}

static void scribble(int all)
{
    static void (*volatile deep[2])(const int *) = { foulfew, foul };
    static int with[3][FOULED], next;
    int i;

    if (with[0][0] == 0)
        for (i = 0; i < FOULED; i++) {
            with[0][i] = -1;
            with[1][i] = 0x7f7f7f7f;
            with[2][i] = i % 7 + 1;
        }
    deep[all](with[next]);
    next = (next + 1) % 3;
}
#else
#define scribble(all) /* its use of the stack is measured */
#endif

int hh_orient(const tess_real *a, const tess_real *b, const tess_real *c,
              const tess_real *d)
{
    scribble(0);
    return (int)hhorie_(a, b, c, d);
}

int hh_insphere(const tess_real *a, const tess_real *b, const tess_real *c,
                const tess_real *d, const tess_real *e)
{
    scribble(0);
    return (int)hhinsp_(a, b, c, d, e);
}

int hh_foot(const tess_real *a, const tess_real *b, const tess_real *c,
            const tess_real *q, double *w)
{
    double any[3];
    tess_int want = w != 0, set;

    scribble(0);
    hhfoot_(a, b, c, q, &want, w ? w : any, &set);
    return (int)set;
}

int hh_fits(double x, double most)
{
    scribble(0);
    return (int)hhfits_(&x, &most);
}

int hh_facet(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             double *f)
{
    tess_int info;

    scribble(0);
    hhface_(p1, p2, p3, f, &info);
    return (int)info;
}

double hh_side(const double *f, const tess_real *z)
{
    scribble(0);
    return hhside_(f, z);
}

double hh_lcoord(const double *f, const tess_real *z)
{
    scribble(0);
    return hhlcoo_(f, z);
}

void hh_setup(const double *p1, const double *p2, const double *p3, double *f)
{
    scribble(0);
    hhsetu_(p1, p2, p3, f);
}

int hh_limits(const double *f, const double *z, double *lo, double *hi)
{
    tess_int side;

    scribble(0);
    hhlimi_(f, z, lo, hi, &side);
    return (int)side;
}

int hh_opp(const double *f, const tess_real *z1, const tess_real *z2)
{
    scribble(0);
    return (int)hhopp_(f, z1, z2);
}

int hh_wrap(const tess_real *p1, const tess_real *p2, const tess_real *p3,
            const tess_real *z, double *c)
{
    tess_int info;

    scribble(0);
    hhwrap_(p1, p2, p3, z, c, &info);
    return (int)info;
}

int hh_area(int axis, const tess_real *a, const tess_real *b,
            const tess_real *c)
{
    tess_int k = axis + 1;

    scribble(0);
    return (int)hharea_(&k, a, b, c);
}

int hh_weigh(const tess_real *p, const tess_int *v, const tess_real *q,
             double *w)
{
    tess_int info, one = 1, u[4];
    int k;

    for (k = 0; k < 4; k++) u[k] = v[k] + 1;
    scribble(0);
    hhweig_(p, u, &one, q, w, &info);
    return (int)info;
}

int hh_wider(double a, double b, double c, double d)
{
    scribble(0);
    return (int)hhwide_(&a, &b, &c, &d);
}

int hh_held(const tess_real *p)
{
    scribble(0);
    return (int)hhheld_(p);
}

int hh_holds(tess_int n, const tess_real *p)
{
    scribble(0);
    return (int)hhhold_(&n, p);
}

/* ---- sets: those of t_pred, of at most 5 points ----
 *
 * The ball and the sphere that a call makes are kept here, for the calls that
 * get them: one of each at a time. */
static double ball[85], sphere[52];
static tess_int places[5], facet[3];

static const tess_int *order(const hh_set *s, tess_int n)
{
    tess_int i;

    for (i = 0; i < n; i++) places[i] = s->order[i] + 1;
    return places;
}

static const tess_int *vertices(const tess_int *v)
{
    int i;

    for (i = 0; i < 3; i++) facet[i] = v[i] + 1;
    return facet;
}

int hh_porient(const hh_set *s, tess_int i, tess_int j, tess_int k, tess_int l)
{
    ++i;
    ++j;
    ++k;
    ++l;
    scribble(0);
    return (int)hhpori_(s->x, s->p, order(s, 5), &s->exact3, &i, &j, &k, &l);
}

int hh_pinsphere(const hh_set *s, const tess_int *v, tess_int a, tess_int b,
             int rule)
{
    tess_int r = rule;

    ++a;
    ++b;
    scribble(0);
    return (int)hhpins_(s->x, s->p, order(s, 5), &s->exact3, &s->exact5,
                        vertices(v), &a, &b, &r);
}

int hh_centre(const hh_set *s, const tess_int *v, int base, tess_int z,
              double *c, hh_ball *t)
{
    tess_int e = s->exponent, from = base + 1, ok;

    (void)t;
    ++z;
    scribble(0);
    hhcent_(s->p, order(s, 5), &e, vertices(v), &from, &z, c, ball, &ok);
    return (int)ok;
}

void hh_trial(const hh_set *s, const hh_ball *t, tess_int z, int *side,
              int *power)
{
    tess_int a = *side, b = *power;

    (void)t;
    ++z;
    scribble(0);
    hhtria_(s->p, order(s, 5), ball, &z, &a, &b);
    *side = (int)a;
    *power = (int)b;
}

int hh_relative(const hh_set *s, const tess_int *v, int base, const double *f,
             double l, tess_int a, tess_int z, hh_sphere *t)
{
    tess_int from = base + 1, sign;

    ++a;
    ++z;
    sphere[0] = t->ready;
    scribble(0);
    hhrela_(s->x, &s->exact3, vertices(v), &from, f, &l, &a, &z, sphere, &sign);
    t->ready = (int)sphere[0];
    return (int)sign;
}

int hh_surface(const hh_set *s, tess_int base, tess_int from, int plane,
             const double *c, hh_sphere *t)
{
    tess_int flat = plane, ok;

    (void)t;
    ++base;
    ++from;
    scribble(0);
    hhsurf_(s->x, &base, &from, &flat, c, sphere, &ok);
    return (int)ok;
}

double hh_height(const hh_set *s, const hh_sphere *t, tess_int z, double *err)
{
    double h;

    (void)t;
    ++z;
    scribble(0);
    hhheig_(s->x, sphere, &z, &h, err);
    return h;
}

int hh_thin(const hh_set *s, const tess_int *v, int base, double *f)
{
    tess_int e = s->exponent, from = base + 1, ok;

    scribble(0);
    hhthin_(s->x, s->p, order(s, 3), &e, vertices(v), &from, f, &ok);
    return (int)ok;
}

/* ---- tess.h ---- */

int tess_size(tess_int n, tess_int maxtet, tess_int *liw, tess_int *lrw)
{
    tess_int info;

    scribble(1);
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

    scribble(1);
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
    scribble(1);
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
    scribble(1);
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
    scribble(1);
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
    scribble(1);
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
    scribble(1);
    tessch_(&n, p, &ntet, (tess_int *)tet, (tess_int *)adj, &liw, iw, bad,
            &info);
    --*bad;
    both(tet, adj, m, -1);
    return (int)info;
}

/* The points of an index, iw[0..n-1]: none for an n that is a bad argument. */
static tess_int indexed(tess_int n)
{
    return n < 0 || n > TESS_INT_MOST / 32 ? 0 : n;
}

int tess_index(tess_int n, const tess_real *p, tess_int liw, tess_int *iw,
               tess_int lrw, double *rw)
{
    tess_int info;

    scribble(1);
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

    if (!mine) return -3; /* which FORTRAN cannot say */
    both(tet, adj, old, 1);
    count(iw, m, 1);
    scribble(1);
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
    scribble(1);
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
    scribble(1);
    tessba_(p, u, c, &info);
    return (int)info;
}

long tess_edition(void)
{
    scribble(1);
    return (long)tessed_();
}
