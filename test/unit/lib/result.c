/* result.c - see result.h. */
#include "result.h"
#include "../../lib/exact.h"
#include "../../lib/verify.h"
#include "../../lib/points.h"
#include "guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int quick;
long faults;
const result *current;
const char *now;

void fail(const char *what)
{
    if (faults++ < SHOWN) {
        printf("# %s", what);
        if (current != NULL)
            printf(" (%s %ld %lu, %ld tetrahedra)", current->family,
                   (long)current->n, current->seed, (long)current->ntet);
        else if (now != NULL)
            printf(" (%s)", now);
        printf("\n");
    }
}

void require(int holds, const char *what)
{
    if (!holds) fail(what);
}

void done(const char *what, const char *family)
{
    char name[80];

    sprintf(name, "%s: %s", what, family);
    test_result(name, faults);
}

int points(result *r, const char *family, long n, unsigned long seed)
{
    double *p = (double *)malloc((size_t)(3 * n + 3) * sizeof(double));
    long i, m;

    if (p == NULL) exit(2);
    m = points_make(family, n, seed, p);
    r->family = family;
    r->seed = seed;
    r->n = (tess_int)m;
    r->ntet = 0;
    r->p = (tess_real *)array((size_t)(3 * m) * sizeof(tess_real));
    for (i = 0; i < 3 * m; i++) r->p[i] = (tess_real)p[i];
    free(p);
    return m > 0;
}

void room(result *r, tess_int maxtet)
{
    r->maxtet = maxtet;
    if (tess_size(r->n, maxtet, &r->liw, &r->lrw) != 0) fail("tess_size");
    r->tet = ints(4 * maxtet);
    r->adj = ints(4 * maxtet);
    r->iw = ints(r->liw);
    r->rw = (double *)array((size_t)r->lrw * sizeof(double));
}

void run(result *r)
{
    r->ntet = -7;
    r->code = tess(r->n, r->p, r->maxtet, &r->ntet, r->tet, r->adj, r->liw,
                   r->iw, r->lrw, r->rw);
}

void resume(result *r)
{
    r->code = tess_resume(r->n, r->p, r->maxtet, &r->ntet, r->tet, r->adj,
                          r->liw, r->iw, r->lrw, r->rw);
}

int same(const result *a, const result *b)
{
    size_t length = (size_t)(4 * a->ntet) * sizeof(tess_int);

    return a->ntet == b->ntet && memcmp(a->tet, b->tet, length) == 0 &&
           memcmp(a->adj, b->adj, length) == 0;
}

void grow(result *r, int keep, tess_int maxtet, tess_int liw)
{
    size_t length = (size_t)(4 * r->ntet) * sizeof(tess_int);
    tess_int *tet = (tess_int *)malloc(length + 1);
    tess_int *adj = (tess_int *)malloc(length + 1);

    if (tet == NULL || adj == NULL) exit(2);
    memcpy(tet, r->tet, length);
    memcpy(adj, r->adj, length);
    release(keep);
    room(r, maxtet);
    if (liw > r->liw) {
        r->liw = liw;
        r->iw = ints(liw);
    }
    memcpy(r->tet, tet, length);
    memcpy(r->adj, adj, length);
    free(tet);
    free(adj);
}

void solve(result *r)
{
    result first = *r;
    tess_int maxtet = (tess_int)(3 * r->n + 20);
    int tries = 0, keep = narrays;

    room(&first, maxtet);
    run(&first);
    while ((first.code == TESS_MORE || first.code == TESS_POOL) &&
           tries++ < 24) {
        if (first.code == TESS_MORE) {
            require(first.ntet == first.maxtet, "TESS_MORE, not full");
            grow(&first, keep, 2 * first.maxtet, first.liw);
        } else
            grow(&first, keep, first.maxtet, 2 * first.liw);
        resume(&first);
    }
    room(r, first.ntet);
    if (first.liw > r->liw) {
        r->liw = first.liw;
        r->iw = ints(r->liw);
    }
    run(r);
    require(r->code == first.code, "another code in exact arrays");
    if (r->code == TESS_OK)
        require(same(r, &first), "resumed and direct results differ");
    require(overrun() == 0, "an array is overrun");
}

const double *at(const result *r, tess_int i)
{
    /* exact.c takes doubles; four points at a time and one more */
    static double held[8][3];
    static int next;
    double *h = held[next++ % 8];
    int k;

    for (k = 0; k < 3; k++) h[k] = (double)r->p[3 * i + k];
    return h;
}

int orient(const result *r, tess_int a, tess_int b, tess_int c, tess_int d)
{
    return ex_orient(at(r, a), at(r, b), at(r, c), at(r, d));
}

/* ---- verification ---- */

int by_four(const void *a, const void *b)
{
    const tess_int *x = (const tess_int *)a, *y = (const tess_int *)b;
    int k = 0;

    while (k < 3 && x[k] == y[k]) k++;
    return x[k] < y[k] ? -1 : x[k] > y[k];
}

void facet(const result *r, tess_int t, int k, tess_int *v)
{
    int j;

    for (j = 0; j < 3; j++) v[j] = verify_corner(r->tet + 4 * t, k, j);
}

int slot_of(const tess_int *v, tess_int i)
{
    int k = 0;

    while (k < 4 && v[k] != i) k++;
    return k;
}

void twins(const result *r)
{
    const char *fault = verify_twins(r->n, r->p, r->iw);

    if (fault != NULL) fail(fault);
}

/* tess_hull's triangles. */
static void hull(const result *r)
{
    const char *fault;
    tess_int nfac, nfac2, *fac;
    int keep = narrays;

    require(tess_hull(r->ntet, r->tet, r->adj, 0, &nfac, NULL) ==
            (nfac > 0 ? TESS_MORE : TESS_OK), "tess_hull's code");
    fac = ints(3 * nfac);
    require(tess_hull(r->ntet, r->tet, r->adj, nfac, &nfac2, fac) == TESS_OK &&
            nfac2 == nfac && overrun() == 0, "tess_hull");
    fault = verify_hull(r->ntet, r->tet, r->adj, nfac, fac);
    if (fault != NULL) fail(fault);
    release(keep);
}

int checked(const result *r)
{
    int keep = narrays, code;
    tess_int *iw = ints(2 * r->n), bad = -7;

    code = tess_check(r->n, r->p, r->ntet, r->tet, r->adj, 2 * r->n, iw,
                      &bad);
    if (code == 0) require(bad == TESS_NONE, "tess_check sets bad");
    if (code > 0 && code != TESS_BAD_POINT && r->ntet > 0)
        require(bad >= TESS_NONE && bad < r->ntet, "tess_check's bad");
    require(overrun() == 0, "tess_check overruns an array");
    release(keep);
    return code;
}

void right(const result *r)
{
    const char *fault = verify(r->n, r->p, r->code, r->ntet, r->tet, r->adj,
                               r->iw);

    current = r;
    if (r->code != TESS_OK) {
        fail("a code");
        printf("#     code %d\n", r->code);
        return;
    }
    if (checked(r) != 0) fail("tess_check");
    if (fault != NULL) fail(fault);
    else hull(r);
}

long affordable(const char *family, long n)
{
    static const struct {
        const char *family;
        long most;
    } few[] = {
        { "wide", 50 }, { "moment", 120 }, { "helix", 120 },
        { "twolines", 120 }, { "spherenorm", 300 }, { "spiral", 300 },
        { "prism", 300 }, { "rotcube", 400 }, { "spherei", 1200 },
        { "grid11eps", 1200 }, { "cylinder", 1200 }, { "jitlattice", 5000 },
        { "lattice01", 5000 }, { "spherejit", 5000 }, { "pairs", 5000 },
        { "filloutlier", 300 }, { "fillcurve", 1200 }, { "fillglobe", 1200 }
    };
    size_t i;

    for (i = 0; i < sizeof few / sizeof few[0]; i++)
        if (strcmp(family, few[i].family) == 0 && n > few[i].most)
            return few[i].most;
    return n;
}

tess_int largest(void)
{
    tess_int half = (tess_int)((tess_int)1 << (8 * sizeof(tess_int) - 2));

    return (tess_int)(half - 1 + half);
}

tess_int least(const result *like, int which)
{
    tess_int lo = -1, hi = which ? like->lrw : like->liw, mid;
    int keep = narrays;

    while (hi - lo > 1) {
        result r = *like;

        mid = (tess_int)(lo + (hi - lo) / 2);
        if (which) r.lrw = mid;
        else r.liw = mid;
        r.iw = ints(r.liw > 0 ? r.liw : 0);
        r.rw = (double *)array((size_t)(r.lrw > 0 ? r.lrw : 0) *
                               sizeof(double));
        r.tet = ints(4 * r.maxtet);
        r.adj = ints(4 * r.maxtet);
        run(&r);
        require(overrun() == 0, "an array is overrun at the least length");
        if (r.code == (which ? -9 : -7)) lo = mid;
        else hi = mid;
        release(keep);
    }
    return hi;
}

double infinity(void)
{
    volatile double x = DBL_MAX;

    x *= 2.0;
    return x;
}

int beginning(const result *r, const result *whole)
{
    tess_int i;

    if (r->ntet > whole->ntet) return 0;
    for (i = 0; i < 4 * r->ntet; i++) {
        if (r->tet[i] != whole->tet[i]) return 0;
        if (r->adj[i] == TESS_OPEN) {
            /* closed later: by a later tetrahedron, or onto the hull */
            if (whole->adj[i] >= 0 && whole->adj[i] < r->ntet) return 0;
        } else if (r->adj[i] != whole->adj[i])
            return 0;
    }
    return 1;
}

void link_up(result *r)
{
    tess_int *f = (tess_int *)malloc((size_t)(16 * r->ntet + 1) * sizeof *f);
    tess_int i, v[3], x;
    int j, k;

    if (f == NULL) exit(2);
    for (i = 0; i < 4 * r->ntet; i++) {
        facet(r, i / 4, (int)(i % 4), v);
        for (j = 1; j < 3; j++)
            for (k = j; k > 0 && v[k - 1] > v[k]; k--) {
                x = v[k];
                v[k] = v[k - 1];
                v[k - 1] = x;
            }
        for (j = 0; j < 3; j++) f[4 * i + j] = v[j];
        f[4 * i + 3] = i;
        r->adj[i] = TESS_NONE;
    }
    qsort(f, (size_t)(4 * r->ntet), 4 * sizeof *f, by_four);
    for (i = 0; i + 1 < 4 * r->ntet; i++) {
        const tess_int *a = f + 4 * i;

        if (a[0] == a[4] && a[1] == a[5] && a[2] == a[6]) {
            r->adj[a[3]] = a[7] / 4;
            r->adj[a[7]] = a[3] / 4;
        }
    }
    free(f);
}

void given(result *r, const char *name, const double *p, tess_int n,
           const tess_int *tet, tess_int ntet)
{
    tess_int i;

    r->family = name;
    r->seed = 0;
    r->n = n;
    r->p = (tess_real *)array((size_t)(3 * n) * sizeof(tess_real));
    for (i = 0; i < 3 * n; i++) r->p[i] = (tess_real)p[i];
    room(r, ntet);
    r->ntet = ntet;
    for (i = 0; i < 4 * ntet; i++) r->tet[i] = tet[i];
    for (i = 0; i < ntet; i++)
        if (orient(r, tet[4 * i], tet[4 * i + 1], tet[4 * i + 2],
                   tet[4 * i + 3]) < 0) {
            r->tet[4 * i] = tet[4 * i + 1];
            r->tet[4 * i + 1] = tet[4 * i];
        }
    link_up(r);
}
