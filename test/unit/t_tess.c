/* t_tess.c - tests of tess.c on all families of points.c.
 *
 *     t_tess                    all tests
 *     t_tess -quick             fewer and smaller ones, for slow builds
 *     t_tess -sums [n]          a checksum of each family's result, to compare
 *                               builds with each other
 *     t_tess -range             TESS_RANGE, for builds with few limbs
 *     t_tess -one family n seed verify one set
 *
 * Covered:
 *   families   every family: codes, exact array lengths, guards around all
 *              arrays, points not altered, tess_check, verify.h; and numbers
 *              of tetrahedra that theory gives
 *   codes      what each routine returns and sets for bad and special input
 *   workspace  the least lengths, and others, give the same arrays or
 *              TESS_POOL and a beginning of them that resumes
 *   resume     stopped at every tetrahedron, in one step or in many
 *   locate     the place of points inside, outside, and on vertices
 *   check      tess_check refuses what is wrong and accepts what is right
 * A failure names its family, n and seed.
 */
#include "../../tess.h"
#include "../proof/exact.h"
#include "../proof/verify.h"
#include "../points.h"
#include "damage.h"
#include "guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- results ---- */

typedef struct result {
    const char *family;
    unsigned long seed;
    tess_int n, maxtet, ntet, liw, lrw;
    tess_real *p;
    tess_int *tet, *adj, *iw;
    double *rw;
    int code;
} result;

/* Faults of one test that are described. */
#define SHOWN 5

static int quick;
static long faults;
static const result *current;

static void fail(const char *what)
{
    if (faults++ < SHOWN) {
        printf("%s", what);
        if (current != NULL)
            printf(" (%s %ld %lu, %ld tetrahedra)", current->family,
                   (long)current->n, current->seed, (long)current->ntet);
        printf("\n");
    }
}

static void require(int holds, const char *what)
{
    if (!holds) fail(what);
}

static void done(const char *what, const char *family)
{
    char name[80];

    sprintf(name, "%s: %s", what, family);
    test_result(name, faults);
}

/* The points of a family; 0 when there is none of that size. */
static int points(result *r, const char *family, long n, unsigned long seed)
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

static void room(result *r, tess_int maxtet)
{
    r->maxtet = maxtet;
    if (tess_size(r->n, maxtet, &r->liw, &r->lrw) != 0) fail("tess_size");
    r->tet = ints(4 * maxtet);
    r->adj = ints(4 * maxtet);
    r->iw = ints(r->liw);
    r->rw = (double *)array((size_t)r->lrw * sizeof(double));
}

static void run(result *r)
{
    r->ntet = -7;
    r->code = tess(r->n, r->p, r->maxtet, &r->ntet, r->tet, r->adj, r->liw,
                   r->iw, r->lrw, r->rw);
}

static void resume(result *r)
{
    r->code = tess_resume(r->n, r->p, r->maxtet, &r->ntet, r->tet, r->adj,
                          r->liw, r->iw, r->lrw, r->rw);
}

static int same(const result *a, const result *b)
{
    size_t length = (size_t)(4 * a->ntet) * sizeof(tess_int);

    return a->ntet == b->ntet && memcmp(a->tet, b->tet, length) == 0 &&
           memcmp(a->adj, b->adj, length) == 0;
}

/* Free the arrays made since there were keep of them, and go on in new ones
 * that hold the tetrahedra; iw and rw hold rubbish. */
static void grow(result *r, int keep, tess_int maxtet, tess_int liw)
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

/* The whole result, in arrays that it fills exactly.  What it takes is found
 * by resuming, and the run with that room must give the same. */
static void solve(result *r)
{
    result first = *r;
    tess_int maxtet = 3 * r->n + 20;
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

static const double *at(const result *r, tess_int i)
{
    /* exact.c takes doubles; four points at a time and one more */
    static double held[8][3];
    static int next;
    double *h = held[next++ % 8];
    int k;

    for (k = 0; k < 3; k++) h[k] = (double)r->p[3 * i + k];
    return h;
}

static int orient(const result *r, tess_int a, tess_int b, tess_int c,
                  tess_int d)
{
    return ex_orient(at(r, a), at(r, b), at(r, c), at(r, d));
}

/* ---- verification ---- */

static int by_four(const void *a, const void *b)
{
    const tess_int *x = (const tess_int *)a, *y = (const tess_int *)b;
    int k = 0;

    while (k < 3 && x[k] == y[k]) k++;
    return x[k] < y[k] ? -1 : x[k] > y[k];
}

/* The vertices of facet k of tetrahedron t, seen counter-clockwise from
 * outside. */
static void facet(const result *r, tess_int t, int k, tess_int *v)
{
    int j;

    for (j = 0; j < 3; j++) v[j] = verify_corner(r->tet + 4 * t, k, j);
}

/* The place of vertex v in tetrahedron t, or 4. */
static int slot_of(const result *r, tess_int t, tess_int v)
{
    int k;

    for (k = 0; k < 4; k++)
        if (r->tet[4 * t + k] == v) break;
    return k;
}

static void twins(const result *r)
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

static int checked(const result *r)
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

/* All of it; r is solved. */
static void right(const result *r)
{
    const char *fault = verify(r->n, r->p, r->code, r->ntet, r->tet, r->adj,
                               r->iw);

    current = r;
    if (r->code != TESS_OK) {
        fail("a code");
        printf("    code %d\n", r->code);
        return;
    }
    if (checked(r) != 0) fail("tess_check");
    if (fault != NULL) fail(fault);
    else hull(r);
}

/* ---- families ---- */

/* How many points of a family a test can afford: fewer where the result is
 * quadratic in n, where exact numbers are long, and where very many points
 * are so near to one sphere or plane that the search is slow. */
static long affordable(const char *family, long n)
{
    static const struct {
        const char *family;
        long most;
    } few[] = {
        { "wide", 50 }, { "moment", 120 }, { "helix", 120 },
        { "twolines", 120 }, { "spherenorm", 300 }, { "spiral", 300 },
        { "prism", 300 }, { "rotcube", 400 }, { "spherei", 1200 },
        { "grid11eps", 1200 }, { "cylinder", 1200 }, { "jitlattice", 5000 },
        { "lattice01", 5000 }, { "spherejit", 5000 }, { "pairs", 5000 }
    };
    size_t i;

    for (i = 0; i < sizeof few / sizeof few[0]; i++)
        if (strcmp(family, few[i].family) == 0 && n > few[i].most)
            return few[i].most;
    return n;
}

static tess_int all_at(const result *r, tess_int i)
{
    tess_int t, count = 0;
    int k;

    for (t = 0; t < r->ntet; t++)
        for (k = 0; k < 4; k++) count += r->tet[4 * t + k] == i;
    return count;
}

/* Numbers that theory gives. */
static void known(const result *r)
{
    tess_int n = r->n, nfac = 0, k, m, i, deg;

    for (i = 0; i < 4 * r->ntet; i++) nfac += r->adj[i] == TESS_NONE;
    if (strcmp(r->family, "lattice") == 0 ||
        strcmp(r->family, "latticeshuf") == 0) {
        /* each cube pulled at a vertex: its three opposite faces, of two
         * triangles each, joined to it: 6 tetrahedra of volume 1/6 */
        for (k = 1; k * k * k < n; k++)
            ;
        require(k * k * k == n && r->ntet == 6 * (k - 1) * (k - 1) * (k - 1),
                "a cubic lattice has not 6 (k-1)^3 tetrahedra");
    }
    if (strcmp(r->family, "moment") == 0)
        /* t > 0: the lifted points are in the order type of the cyclic
         * polytope C(n, 4), whose lower facets are the pairs of pairs of
         * neighbours */
        require(r->ntet == (n - 2) * (n - 3) / 2,
                "the moment curve has not (n-2)(n-3)/2 tetrahedra");
    if (strcmp(r->family, "twolines") == 0) {
        m = n / 2;
        require(r->ntet == (m - 1) * (n - m - 1),
                "two lines have not (m-1)(n-m-1) tetrahedra");
    }
    if (strcmp(r->family, "spherei") == 0) {
        /* one ball: all tetrahedra have the point 0, opposite to one of the
         * hull's triangles each */
        for (deg = 0, i = 0; i < 4 * r->ntet; i++)
            if (r->adj[i] == TESS_NONE && r->tet[i] != 0) {
                tess_int v[3];

                facet(r, i / 4, (int)(i % 4), v);
                deg += v[0] == 0 || v[1] == 0 || v[2] == 0;
            }
        require(all_at(r, 0) == r->ntet && r->ntet == nfac - deg,
                "points of one sphere are not pulled at the first");
    }
    if (strcmp(r->family, "planeone") == 0) {
        /* every point but the last in the plane z = 0: one tetrahedron on
         * each triangle, all points on the hull */
        for (m = 0, i = 0; i < n; i++) m += r->p[3 * i + 2] == 0;
        require(m == n - 1 && nfac == 2 * n - 4,
                "a plane grid and an apex");
        for (m = 0, i = 0; i < n; i++)
            if (r->p[3 * i + 2] != 0) m = all_at(r, i);
        require(m == r->ntet, "a plane grid's apex is not in all");
    }
}

static void one_family(const char *family, long n, unsigned long seed)
{
    result r;
    tess_real *copy;
    size_t length;

    current = NULL;
    if (!points(&r, family, n, seed)) {
        fail(family);
        return;
    }
    current = &r;
    length = (size_t)(3 * r.n) * sizeof *copy;
    copy = (tess_real *)malloc(length);
    if (copy == NULL) exit(2);
    memcpy(copy, r.p, length);
    solve(&r);
    right(&r);
    require(memcmp(copy, r.p, length) == 0, "the points were altered");
    free(copy);
    if (r.code == TESS_OK && faults == 0) known(&r);
    current = NULL;
    release(0);
}

static void test_families(void)
{
    const char *family;
    long n = quick ? 300 : 1200, total;
    int i;

    for (i = 0; (family = points_name(i)) != NULL; i++) {
        faults = 0;
        one_family(family, affordable(family, n), 1);
        one_family(family, affordable(family, n) / 8 + 8, 2);
        done("family", family);
    }
    if (quick) return;
    /* larger ones, checked by tess_check alone */
    total = 0;
    for (i = 0; (family = points_name(i)) != NULL; i++) {
        result r;

        faults = 0;
        n = affordable(family, 10000);
        if (n < 1500) continue;
        current = &r;
        if (points(&r, family, n, 3)) {
            solve(&r);
            require(r.code == TESS_OK, "a code");
            if (r.code == TESS_OK) {
                require(checked(&r) == 0, "tess_check");
                known(&r);
            }
        }
        current = NULL;
        release(0);
        total += faults;
    }
    test_result("families, up to 10000 points", total);
}

/* ---- codes ---- */

/* Arguments that are bad in one way; nothing but ntet may be written. */
static void bad_call(const result *good, int resuming, int code,
                     tess_int ntet_after, const char *what)
{
    result r = *good;
    int keep = narrays;
    tess_int liw = r.liw > 0 ? r.liw : 0, lrw = r.lrw > 0 ? r.lrw : 0;

    r.iw = ints(liw);
    r.rw = (double *)array((size_t)lrw * sizeof(double));
    if (resuming)
        resume(&r);
    else {
        r.tet = ints(4 * 8);
        r.adj = ints(4 * 8);
        run(&r);
        require(untouched(r.tet, 32 * sizeof(tess_int)) &&
                untouched(r.adj, 32 * sizeof(tess_int)), what);
    }
    require(r.code == code && r.ntet == ntet_after, what);
    if (r.code != code || r.ntet != ntet_after)
        printf("    code %d instead of %d, ntet %ld\n", r.code, code,
               (long)r.ntet);
    require(untouched(r.iw, (size_t)liw * sizeof(tess_int)) &&
            untouched(r.rw, (size_t)lrw * sizeof(double)) &&
            overrun() == 0, what);
    release(keep);
}

/* The largest tess_int. */
static tess_int largest(void)
{
    tess_int half = (tess_int)((tess_int)1 << (8 * sizeof(tess_int) - 2));

    return (tess_int)(half - 1 + half);
}

/* The least length of iw (rw: which = 1) that tess and tess_resume accept. */
static tess_int least(const result *like, int which)
{
    tess_int lo = -1, hi = which ? like->lrw : like->liw, mid;
    int keep = narrays;

    while (hi - lo > 1) {
        result r = *like;

        mid = lo + (hi - lo) / 2;
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

static double infinity(void)
{
    volatile double x = DBL_MAX;

    x *= 2.0;
    return x;
}

/* Bad arguments of tess and tess_resume. */
static void test_bad_arguments(void)
{
    result good, r;
    double bad[3];
    tess_int i, n;
    int k;

    faults = 0;
    current = NULL;
    points(&good, "uniform", 30, 5);
    solve(&good);
    current = &good;
    n = good.n;

    r = good;
    r.n = -1;
    bad_call(&r, 0, -1, 0, "tess with n < 0");
    bad_call(&r, 1, -1, good.ntet, "tess_resume with n < 0");
    r.n = largest() / 5 + 1;
    bad_call(&r, 0, -1, 0, "tess with n too large");
    bad_call(&r, 1, -1, good.ntet, "tess_resume with n too large");
    r = good;
    r.maxtet = -1;
    bad_call(&r, 0, -3, 0, "tess with maxtet < 0");
    bad_call(&r, 1, -3, good.ntet, "tess_resume with maxtet < 0");
    r.maxtet = (largest() - 3) / 4 + 1;
    bad_call(&r, 0, -3, 0, "tess with maxtet too large");
    bad_call(&r, 1, -3, good.ntet, "tess_resume with maxtet too large");
    r = good;
    for (k = 0; k < 2; k++) {
        r.liw = k ? least(&good, 0) - 1 : -1;
        bad_call(&r, 0, -7, 0, "tess with liw too small");
        bad_call(&r, 1, -7, good.ntet, "tess_resume with liw too small");
    }
    r = good;
    for (k = 0; k < 2; k++) {
        r.lrw = k ? least(&good, 1) - 1 : -1;
        bad_call(&r, 0, -9, 0, "tess with lrw too small");
        bad_call(&r, 1, -9, good.ntet, "tess_resume with lrw too small");
    }
    /* not a number, or infinite, in any place: the first point that has one */
    bad[0] = infinity();
    bad[1] = -infinity();
    bad[2] = bad[0] - bad[0];
    r = good;
    r.p = (tess_real *)array((size_t)(3 * n) * sizeof(tess_real));
    for (i = 0; i < 3 * n; i++)
        for (k = 0; k < 3; k++) {
            memcpy(r.p, good.p, (size_t)(3 * n) * sizeof(tess_real));
            r.p[i] = (tess_real)bad[k];
            if (i + 5 < 3 * n) r.p[i + 5] = (tess_real)bad[(k + 1) % 3];
            bad_call(&r, 0, -2, i / 3, "tess with NaN or infinity");
            bad_call(&r, 1, -2, good.ntet, "tess_resume with NaN");
        }
    /* what tess_resume finds in ntet, tet, adj */
    r = good;
    r.ntet = -1;
    bad_call(&r, 1, -4, -1, "tess_resume with ntet < 0");
    r.ntet = r.maxtet + 1;
    bad_call(&r, 1, -4, r.ntet, "tess_resume with ntet > maxtet");
    r = good;
    for (i = 0; i < 4 * good.ntet; i++)
        for (k = 0; k < 2; k++) {
            tess_int held = good.tet[i];

            good.tet[i] = k ? n : -1;
            bad_call(&r, 1, -5, good.ntet, "tess_resume with bad tet");
            good.tet[i] = held;
            held = good.adj[i];
            good.adj[i] = k ? good.ntet : TESS_OPEN - 1;
            bad_call(&r, 1, -6, good.ntet, "tess_resume with bad adj");
            good.adj[i] = held;
        }
    /* after all that it is still finished, and stays as it is */
    r = good;
    r.tet = ints(4 * good.ntet);
    r.adj = ints(4 * good.ntet);
    r.iw = ints(r.liw);
    memcpy(r.tet, good.tet, (size_t)(4 * good.ntet) * sizeof(tess_int));
    memcpy(r.adj, good.adj, (size_t)(4 * good.ntet) * sizeof(tess_int));
    resume(&r);
    require(r.code == TESS_OK && same(&r, &good), "resume of a whole result");
    twins(&r);
    current = NULL;
    release(0);
    test_result("bad arguments of tess, tess_resume", faults);
}

/* Points with no tetrahedron, and maxtet = 0: codes, ntet and iw, from tess
 * and from tess_resume with ntet = 0. */
static void flat(const double *p, tess_int n, int code, const char *name)
{
    result r;
    tess_int i;
    int k;

    r.family = name;
    r.seed = 0;
    r.n = n;
    r.p = (tess_real *)array((size_t)(3 * n) * sizeof(tess_real));
    for (i = 0; i < 3 * n; i++) r.p[i] = (tess_real)p[i];
    r.ntet = 0;
    current = &r;
    for (k = 0; k < 4; k++) {
        room(&r, k % 2 ? 10 : 0);
        if (k < 2) run(&r);
        else {
            r.ntet = 0;
            resume(&r);
        }
        require(r.code == code && r.ntet == 0, name);
        if (r.code != code)
            printf("    code %d instead of %d\n", r.code, code);
        else twins(&r);
        if (k == 1 && code != TESS_MORE)
            require(checked(&r) == 0, "tess_check of no tetrahedron");
        require(overrun() == 0, "an array is overrun");
        if (code == TESS_MORE) k++;
    }
    current = NULL;
    release(0);
}

static void test_flat(void)
{
    static double p[300];
    int i;

    faults = 0;
    flat(p, 0, TESS_POINT, "no point");
    flat(p, 1, TESS_POINT, "one point");
    flat(p, 2, TESS_POINT, "twice one point");
    flat(p, 100, TESS_POINT, "100 times one point");
    for (i = 0; i < 300; i += 6) p[i] = -0.0;
    flat(p, 100, TESS_POINT, "zeros of both signs");
    p[3] = 1.0;
    flat(p, 2, TESS_LINE, "two points");
    flat(p, 3, TESS_LINE, "two points and a duplicate");
    p[6] = 3.0;
    flat(p, 3, TESS_LINE, "three points of a line");
    p[7] = 1e-300;
    flat(p, 3, TESS_PLANE, "three points");
    for (i = 0; i < 300; i++) p[i] = (i / 3 - 50) * (i % 3 + 1);
    flat(p, 100, TESS_LINE, "100 points of a line");
    p[3 * 57 + 1] += 0.5;
    flat(p, 100, TESS_PLANE, "99 points of a line and one more");
    for (i = 0; i < 100; i++) {
        p[3 * i] = i % 10;
        p[3 * i + 1] = i / 10;
        p[3 * i + 2] = 2.0 * (i % 10) - 3.0 * (i / 10);
    }
    flat(p, 100, TESS_PLANE, "an oblique grid");
    p[3 * 99 + 2] -= 1e-9;
    flat(p, 100, TESS_MORE, "an oblique grid but for one point");
    for (i = 0; i < 100; i++) p[3 * i + 2] = 1e300;
    flat(p, 100, TESS_PLANE, "a grid at 1e300");
    for (i = 0; i < 9; i++) p[i] = i % 4 == 0 ? 1e-160 : 0.0;
    flat(p, 3, TESS_PLANE, "three tiny points");
    p[9] = p[10] = p[11] = 0.0;
    flat(p, 4, TESS_MORE, "four tiny points");
    test_result("points with no tetrahedron, maxtet = 0", faults);
}

static void test_size(void)
{
    tess_int most = largest(), liw, lrw, liw2, lrw2, lo, hi, n;

    faults = 0;
    current = NULL;
    liw = lrw = -7;
    require(tess_size(-1, 10, &liw, &lrw) == -1 && liw == 0 && lrw == 0,
            "tess_size with n < 0");
    liw = lrw = -7;
    require(tess_size(10, -1, &liw, &lrw) == -2 && liw == 0 && lrw == 0,
            "tess_size with maxtet < 0");
    liw = lrw = -7;
    require(tess_size(most, 10, &liw, &lrw) == -1 && liw == 0 && lrw == 0,
            "tess_size with n too large");
    liw = lrw = -7;
    require(tess_size(10, (most - 3) / 4 + 1, &liw, &lrw) == -2 && liw == 0 &&
            lrw == 0, "tess_size with maxtet too large");
    require(tess_size(10, (most - 3) / 4, &liw, &lrw) == 0 && liw > 0 &&
            lrw > 0, "tess_size with the largest maxtet");
    require(tess_size(0, 0, &liw, &lrw) == 0 && liw >= 0 && lrw >= 0,
            "tess_size with nothing");
    /* the largest n accepted: lengths grow up to it, none beyond is */
    lo = 10;
    hi = most;
    while (hi - lo > 1) {
        n = lo + (hi - lo) / 2;
        if (tess_size(n, 10, &liw, &lrw) == 0) lo = n;
        else hi = n;
    }
    require(tess_size(lo, 10, &liw, &lrw) == 0 && liw > lo && lrw > 0,
            "tess_size with the largest n");
    require(tess_size(lo / 2, 10, &liw2, &lrw2) == 0 && liw2 < liw &&
            lrw2 <= lrw, "tess_size does not grow with n");
    for (n = hi; n < most - n / 97 - 1; n += n / 97 + 1)
        require(tess_size(n, 10, &liw, &lrw) == -1 && liw == 0 && lrw == 0,
                "tess_size beyond the largest n");
    test_result("tess_size", faults);
}

static void test_hull(void)
{
    result r;
    tess_int nfac, need, *fac, whole[3000], i;

    faults = 0;
    current = NULL;
    points(&r, "uniform", 100, 7);
    solve(&r);
    current = &r;
    nfac = -7;
    require(tess_hull(-1, r.tet, r.adj, 10, &nfac, whole) == -1,
            "tess_hull with ntet < 0");
    nfac = -7;
    require(tess_hull(r.ntet, r.tet, r.adj, -1, &nfac, whole) == -4,
            "tess_hull with maxfac < 0");
    nfac = -7;
    require(tess_hull(0, r.tet, r.adj, 10, &nfac, whole) == 0 && nfac == 0,
            "tess_hull of nothing");
    require(tess_hull(r.ntet, r.tet, r.adj, 1000, &need, whole) == 0,
            "tess_hull");
    for (i = 0; i <= need; i++) {
        fac = ints(3 * i);
        nfac = -7;
        require(tess_hull(r.ntet, r.tet, r.adj, i, &nfac, fac) ==
                    (i < need ? TESS_MORE : TESS_OK) && nfac == need &&
                memcmp(fac, whole, (size_t)(3 * i) * sizeof *fac) == 0 &&
                overrun() == 0, "tess_hull with fac too small");
        if (narrays > 40) release(20);
    }
    current = NULL;
    release(0);
    test_result("codes of tess_hull", faults);
}

/* Where hh_range says that the limbs hold all coordinates the result is
 * right, else TESS_RANGE and nothing; with the default all are held. */
static void test_range(void)
{
    const char *family;
    result r;
    tess_int j;
    double most;
    int i, k, held = 0, out = 0, fits;

    for (i = 0; (family = points_name(i)) != NULL; i++)
        for (k = 0; k < 2; k++) {
            faults = 0;
            current = NULL;
            if (!points(&r, family, affordable(family, 200), 1)) continue;
            current = &r;
            if (k) {
                /* a point 2^-60 from the origin, but not with few limbs */
                r.p[3] = (tess_real)ldexp(1.0, -60);
                r.p[4] = r.p[5] = 0;
            }
            most = 0.0;
            for (j = 0; j < 3 * r.n; j++)
                if (fabs((double)r.p[j]) > most) most = fabs((double)r.p[j]);
            fits = 1;
            for (j = 0; j < 3 * r.n; j++)
                if (hh_range((double)r.p[j], most) != 0) fits = 0;
            if (fits) {
                held++;
                solve(&r);
                right(&r);
            } else {
                out++;
                room(&r, 100);
                run(&r);
                require(r.code == TESS_RANGE && r.ntet == 0,
                        "no TESS_RANGE from tess");
                require(untouched(r.tet, 400 * sizeof(tess_int)),
                        "TESS_RANGE, and tet is written");
                resume(&r);
                require(r.code == TESS_RANGE && r.ntet == 0,
                        "no TESS_RANGE from tess_resume");
                require(overrun() == 0, "an array is overrun");
            }
            current = NULL;
            release(0);
            done(k ? "range, with a tiny point" : "range", family);
        }
    printf("        in range %d, out of it %d\n", held, out);
    faults = 0;
    require(HH_LIMBS < 88 ? held > 9 && out > 1 : out == 0,
            "families in and out of range");
    test_result("range", faults);
}

/* ---- workspace ---- */

/* Is r a beginning of the whole: its tetrahedra, and adj but for facets that
 * are open yet? */
static int beginning(const result *r, const result *whole)
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

/* With other lengths the same arrays; or TESS_POOL, counted, and a beginning
 * of them that resumes. */
static void other_lengths(const result *whole, tess_int liw, tess_int lrw,
                          int *pools)
{
    result r = *whole;
    int keep = narrays;

    r.liw = liw;
    r.lrw = lrw;
    r.iw = ints(liw);
    r.rw = (double *)array((size_t)lrw * sizeof(double));
    r.tet = ints(4 * r.maxtet);
    r.adj = ints(4 * r.maxtet);
    run(&r);
    twins(&r);
    require(overrun() == 0, "an array is overrun");
    if (r.code == TESS_POOL) {
        ++*pools;
        require(beginning(&r, whole), "TESS_POOL, and another beginning");
        grow(&r, keep, r.maxtet, whole->liw);
        r.lrw = lrw;
        r.rw = (double *)array((size_t)lrw * sizeof(double));
        resume(&r);
    }
    require(r.code == TESS_OK && same(&r, whole),
            "another length of the workspace, another result");
    require(overrun() == 0, "an array is overrun");
    release(keep);
}

static void test_workspace(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "moment", "planeone", "duplicates", "spherei",
        "twolines", "clusters", "farpoint", "cubesurf", NULL
    };
    result whole;
    tess_int liw, lrw, step;
    int i, pools;

    for (i = 0; family[i] != NULL; i++) {
        faults = 0;
        pools = 0;
        current = NULL;
        points(&whole, family[i], quick ? 60 : 300, 4);
        solve(&whole);
        current = &whole;
        require(whole.code == TESS_OK, "a code");
        liw = least(&whole, 0);
        lrw = least(&whole, 1);
        printf("        least liw %ld = %.2f n, lrw %ld = %.2f n\n",
               (long)liw, (double)liw / (double)whole.n, (long)lrw,
               (double)lrw / (double)whole.n);
        require(liw <= whole.liw && lrw <= whole.lrw,
                "tess_size is below the least lengths");
        step = (whole.liw - liw) / 9 + 1;
        for (; liw < whole.liw + 3 * step; liw += step)
            other_lengths(&whole, liw, liw % 2 ? lrw : whole.lrw + 7, &pools);
        printf("        pool full in %d of the runs\n", pools);
        /* its pool grows with n^2 */
        if (strcmp(family[i], "moment") == 0)
            require(pools > 0, "no run with a full pool");
        current = NULL;
        release(0);
        done("workspace of any length", family[i]);
    }
}

/* Between the least lengths and the recommended ones, for points so many that
 * there is room for marks of supports (in iw) and for cylinders (in rw). */
static void test_room(void)
{
    static const struct {
        const char *family;
        long n;
        int slender; /* its cylinders are made, given the room */
    } set[] = {
        { "ellipsoid", 6000, 1 }, { "torus", 3000, 1 }, { "rottet", 3000, 0 },
        { "uniform", 6000, 0 }, { "tracks", 600, 1 }
    };
    result whole, none;
    tess_int liw[6], lrw[5], extra;
    size_t i, j;
    int pools;

    for (i = 0; i < sizeof set / sizeof set[0] - (quick ? 1 : 0); i++) {
        faults = 0;
        pools = 0;
        current = NULL;
        points(&whole, set[i].family, set[i].n / (quick ? 4 : 1), 6);
        solve(&whole);
        current = &whole;
        require(whole.code == TESS_OK, "a code");
        /* (that of no tetrahedra is soon found) */
        none = whole;
        none.maxtet = 0;
        liw[0] = least(&none, 0);
        liw[1] = liw[0] + 1;
        liw[2] = liw[0] + (whole.liw - liw[0]) / 2;
        liw[3] = whole.liw - 1;
        liw[4] = whole.liw;
        liw[5] = whole.liw + 100;
        lrw[0] = least(&none, 1);
        lrw[1] = lrw[0] + 1;
        lrw[2] = whole.lrw;
        lrw[3] = whole.lrw + 100;
        lrw[4] = whole.lrw - 1;
        extra = lrw[2] - lrw[0];
        if (extra > 0 && set[i].slender)
            require(!untouched(whole.rw + lrw[0],
                               (size_t)extra * sizeof(double)),
                    "no cylinders are made");
        for (j = 0; j < 6; j++)
            other_lengths(&whole, liw[j], whole.lrw, &pools);
        /* (short lists have no use for more than the least) */
        for (j = 0; j < (extra > 0 ? 5 : 4); j++)
            other_lengths(&whole, whole.liw, lrw[j], &pools);
        other_lengths(&whole, liw[0], lrw[0], &pools);
        require(pools >= 2, "no run with a full pool");
        current = NULL;
        release(0);
        done("workspace short of what is recommended", set[i].family);
    }
}

/* ---- resume ---- */

/* Stop at k tetrahedra and go on with room for step more at a time. */
static void stop(const result *whole, tess_int k, tess_int step)
{
    result r = *whole;
    int keep = narrays;

    r.ntet = 0;
    grow(&r, keep, k, whole->liw);
    run(&r);
    while (r.code == TESS_MORE && r.ntet < whole->ntet && faults == 0) {
        require(r.ntet == r.maxtet, "TESS_MORE, and not full");
        require(beginning(&r, whole), "a stopped run is no beginning");
        twins(&r);
        k = r.maxtet + step < whole->ntet ? r.maxtet + step : whole->ntet;
        grow(&r, keep, k, whole->liw);
        resume(&r);
        require(overrun() == 0, "an array is overrun");
    }
    require(r.code == TESS_OK && same(&r, whole),
            "a resumed run gives another result");
    release(keep);
}

static void test_resume(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "planeone", "twolines", "spherei", "moment",
        "duplicates", "paraboloid", "cubesurf", "bcc", "fcc", "cylinder",
        "grid11eps", "farpoint", "planespread", "pairs", NULL
    };
    result whole;
    tess_int k, most;
    long n;
    int i;

    for (i = 0; family[i] != NULL; i++) {
        faults = 0;
        for (n = 5; n <= (quick ? 12 : 60); n = n < 12 ? n + 1 : 2 * n + 6) {
            current = NULL;
            if (!points(&whole, family[i], n, (unsigned long)n)) {
                release(0);
                continue;
            }
            current = &whole;
            solve(&whole);
            if (whole.code == TESS_OK) {
                most = whole.ntet;
                for (k = 0; k <= most && faults == 0; k++)
                    stop(&whole, k, most);
                stop(&whole, 0, 1);
                stop(&whole, 1, 7);
            } else
                /* families of a fixed shape may be flat when small */
                require(whole.code >= TESS_PLANE && whole.code <= TESS_POINT,
                        "a code");
            current = NULL;
            release(0);
        }
        done("resume", family[i]);
    }
    /* a larger one, at some places, a chain of pools of the least length */
    faults = 0;
    points(&whole, "uniform", quick ? 200 : 3000, 9);
    solve(&whole);
    current = &whole;
    for (k = 1; k < whole.ntet; k += whole.ntet / 7 + 1)
        stop(&whole, k, whole.ntet / 3);
    {
        result r = whole;
        tess_int liw = least(&whole, 0);
        int tries = 0, keep = narrays;

        room(&r, whole.ntet);
        r.liw = liw;
        run(&r);
        while (r.code == TESS_POOL && tries++ < 200) {
            liw += liw / 64 + 1;
            require(beginning(&r, &whole), "TESS_POOL: no beginning");
            grow(&r, keep, r.maxtet, 0);
            /* the array is longer; what liw does not count is guarded too */
            r.liw = liw < r.liw ? liw : r.liw;
            r.iw = ints(r.liw);
            resume(&r);
            require(overrun() == 0, "an array is overrun");
        }
        printf("        %d times TESS_POOL\n", tries);
        require(r.code == TESS_OK && same(&r, &whole),
                "resumed after TESS_POOL, another result");
    }
    current = NULL;
    release(0);
    test_result("resumed at some places, pools that grow", faults);
}

/* ---- the pool that tess_size recommends ---- */

/* Points of one vertex, or few, with stars of almost all points: k hubs beside
 * a flat sheet, a cone, a circle, a lattice, a bowl or a sphere; n points. */
static void hubs(double *p, tess_int n, int shape, int k)
{
    double x, y, r;
    tess_int i;

    for (i = 0; i < n; i++, p += 3) {
        do {
            x = rnd_unit() - 0.5;
            y = rnd_unit() - 0.5;
            r = sqrt(x * x + y * y);
        } while (r < 1e-3 || r > 0.5);
        p[0] = x;
        p[1] = y;
        p[2] = 0.0;
        if (shape == 1) p[2] = r;
        if (shape == 2) p[0] /= r, p[1] /= r;
        if (shape == 3) p[0] = rnd_below(40), p[1] = rnd_below(40);
        if (shape == 4) p[2] = r * r;
        if (shape == 5) p[2] = (i % 2 == 0 ? 1 : -1) * sqrt(0.25 - r * r);
        if (i >= k) continue;
        p[2] = shape == 5 ? 0.0 : (i % 2 == 0 ? 1e9 : -2e9) * (double)(i + 1);
    }
}

static void test_pool(void)
{
    static const char *const shape[] = {"flat", "cone", "circle", "lattice",
                                        "bowl", "sphere"};
    double p[3 * 1500];
    result r;
    tess_int i, ntet;
    int kind, turn, keep;

    for (kind = 0; kind < 6; kind++) {
        faults = 0;
        for (turn = 0; turn < (quick ? 6 : 40); turn++) {
            r.n = 60 + rnd_below(turn % 4 == 3 ? 1440 : 400);
            hubs(p, r.n, kind, 1 + rnd_below(4));
            r.p = (tess_real *)array((size_t)(3 * r.n) * sizeof(tess_real));
            for (i = 0; i < 3 * r.n; i++) r.p[i] = (tess_real)p[i];
            r.family = shape[kind];
            r.seed = (unsigned long)turn;
            current = &r;
            keep = narrays;
            room(&r, 20 * r.n);
            run(&r);
            require(r.code == TESS_OK, "a hub: not TESS_OK");
            ntet = r.ntet;
            r.ntet = 0;
            grow(&r, keep, 1 + rnd_below((int)ntet), 0);
            run(&r);
            require(r.code == TESS_MORE || r.ntet == ntet, "a hub: no stop");
            grow(&r, keep, ntet, 0);
            resume(&r);
            require(r.code == TESS_OK && r.ntet == ntet,
                    "a hub, resumed: not TESS_OK");
            require(overrun() == 0, "an array is overrun");
            current = NULL;
            release(0);
        }
        done("the pool suffices", shape[kind]);
    }
}

/* ---- locate ---- */

/* The weights against exact ratios of volumes: 12 eps by hh_weigh, and what the
 * ratio is rounded. */
static void verify_weights(const result *r, tess_int t, const double *q,
                           const double *w, const int *side)
{
    static ex_num part, whole;
    const double *v[4], *u[4];
    double sum = 0.0, x;
    int low = EX_NO_LOW, i, j, k, e, f;

    for (k = 0; k < 4; k++) {
        v[k] = at(r, r->tet[4 * t + k]);
        for (j = 0; j < 3; j++) low = ex_low(v[k][j], ex_low(q[j], low));
    }
    ex_volume(&whole, low, v[0], v[1], v[2], v[3]);
    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) u[i] = i == k ? q : v[i];
        ex_volume(&part, low, u[0], u[1], u[2], u[3]);
        require(part.sign == side[k], "test of locate itself");
        x = (double)(ex_value(&part, &e) / ex_value(&whole, &f));
        x = ldexp(x, e - f);
        require(fabs(w[k] - x) <= 16.0 * DBL_EPSILON * x + DBL_MIN, "a weight");
        sum += w[k];
    }
    require(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON,
            "the weights do not sum to one");
}

/* Does one of the tetrahedra hold q, or its boundary? */
static int held_by_one(const result *r, const double *q)
{
    const double *v[4], *u[4];
    tess_int t;
    int i, j, k;

    for (t = 0; t < r->ntet; t++) {
        for (k = 0; k < 4; k++) v[k] = at(r, r->tet[4 * t + k]);
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 4; k++)
                if (v[k][i] <= q[i]) break;
            for (j = 0; j < 4; j++)
                if (v[j][i] >= q[i]) break;
            if (k == 4 || j == 4) break;
        }
        if (i < 3) continue;
        for (k = 0; k < 4; k++) {
            for (i = 0; i < 4; i++) u[i] = i == k ? q : v[i];
            if (ex_orient(u[0], u[1], u[2], u[3]) < 0) break;
        }
        if (k == 4) return 1;
    }
    return 0;
}

/* The points in doubles. */
static const double *doubles(const result *r)
{
    static double all[3 * 600];
    tess_int i;

    if (r->n > 600) exit(2);
    for (i = 0; i < 3 * r->n; i++) all[i] = (double)r->p[i];
    return all;
}

/* Is q outside of a facet of t that is of the hull, or open, and has all
 * vertices of the sum set of 2^k? */
static int outside(const result *r, tess_int t, int set, const double *q)
{
    const double *p = doubles(r);
    tess_int f[3];
    int k;

    for (k = 0; k < 4; k++) {
        facet(r, t, k, f);
        if (r->adj[4 * t + k] < 0 && (set >> k & 1) == 0 &&
            ex_orient(p + 3 * f[0], p + 3 * f[1], p + 3 * f[2], q) > 0)
            return 1;
    }
    return 0;
}

/* The weights of a place outside: those of the point nearest to q of the
 * hull. */
static void verify_outside(const result *r, tess_int t, const double *q,
                           const double *w)
{
    const double *p = doubles(r), *v[4];
    double x[4], sum = 0.0;
    int set = 0, k;

    for (k = 0; k < 4; k++) {
        v[k] = p + 3 * r->tet[4 * t + k];
        require(w[k] >= 0.0, "outside, a weight is negative");
        set += w[k] > 0.0 ? 1 << k : 0;
        sum += w[k];
    }
    require(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON,
            "outside, the weights do not sum to one");
    require(outside(r, t, set, q), "tess_locate: q is not outside of t's hull "
            "facet");
    require(ex_nearest(4, v, q, (long)r->n, p, x) == set && set > 0,
            "the vertices of the hull's nearest point");
    for (k = 0; k < 4; k++)
        require(fabs(w[k] - x[k]) <= 32.0 * DBL_EPSILON * x[k],
                "a weight of the hull's nearest point");
}

/* Locate q from there.  expected: 0 inside, 1 outside, -1 not known; the code
 * is returned.  In an unfinished result it may be -4, and what else it is, is
 * right all the same. */
static int locate(const result *r, const double *q, tess_int from,
                  int expected, int unfinished)
{
    tess_real z[3];
    double w[4], x[3];
    const double *v[4], *u[4];
    tess_int t = from;
    int code, i, k, side[4];

    for (k = 0; k < 3; k++) {
        /* volatile: a compiler was seen to optimize the rounding away */
        volatile tess_real rounded = (tess_real)q[k];

        z[k] = rounded;
        x[k] = (double)z[k];
    }
    code = tess_locate(r->p, r->ntet, r->tet, r->adj, z, &t, w);
    if (unfinished && code == -4) return code;
    if (t < 0 || t >= r->ntet || code < 0 || code > 1) {
        fail("tess_locate's t or code");
        return -1;
    }
    require(expected < 0 || code == expected, "tess_locate: in or out");
    if (code == 1) {
        verify_outside(r, t, x, w);
        return code;
    }
    for (k = 0; k < 4; k++) v[k] = at(r, r->tet[4 * t + k]);
    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) u[i] = i == k ? x : v[i];
        side[k] = ex_orient(u[0], u[1], u[2], u[3]);
    }
    require(side[0] >= 0 && side[1] >= 0 && side[2] >= 0 && side[3] >= 0,
            "tess_locate: q is not in t");
    verify_weights(r, t, x, w, side);
    from = t;
    t = rnd_below(4) ? (tess_int)rnd_below((int)r->ntet) : TESS_NONE;
    code = tess_locate(r->p, r->ntet, r->tet, r->adj, z, &t, w);
    require((code == 0 && t == from) || (unfinished && code == -4),
            "tess_locate from another start");
    return code;
}

/* Turn the points by odd angles and move them off the origin. */
static void turned(result *r)
{
    double size = 0.0, x, y, z;
    tess_int i;

    for (i = 0; i < 3 * r->n; i++)
        if (fabs((double)r->p[i]) > size) size = fabs((double)r->p[i]);
    for (i = 0; i < r->n; i++) {
        x = r->p[3 * i];
        y = 0.6 * x + 0.8 * r->p[3 * i + 1];
        x = 0.8 * x - 0.6 * r->p[3 * i + 1];
        z = r->p[3 * i + 2];
        r->p[3 * i] = (tess_real)(x + 3.1 * size);
        r->p[3 * i + 1] = (tess_real)(cos(0.4) * y - sin(0.4) * z + 1.7 * size);
        r->p[3 * i + 2] = (tess_real)(sin(0.4) * y + cos(0.4) * z - 0.3 * size);
    }
}

/* The hull's facets: 4 t + k for the one opposite to vertex k of t. */
static tess_int *hull_of(const result *r, tess_int *many)
{
    tess_int *hull = ints(4 * r->ntet), i;

    for (i = *many = 0; i < 4 * r->ntet; i++)
        if (r->adj[i] < 0) hull[(*many)++] = i;
    return hull;
}

#define OUTER 12

/* q outside, or nearly so, beside the facet i of the hull, of points whose box
 * has this size and middle. */
static void beside(const result *r, tess_int i, int kind, double size,
                   const double *middle, double *q)
{
    static const double far[4] = { 1e-12, 0.01, 1.0, 1e6 };
    /* a needle's computed normal may be 0 */
    double a[3][3], n[3], w[3], length = DBL_MIN, off;
    tess_int v[3];
    int j, k;

    facet(r, i / 4, (int)(i % 4), v);
    for (j = 0; j < 3; j++) memcpy(a[j], at(r, v[j]), sizeof a[j]);
    for (k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;

        n[k] = (a[1][l] - a[0][l]) * (a[2][m] - a[0][m]) -
               (a[1][m] - a[0][m]) * (a[2][l] - a[0][l]);
        if (fabs(n[k]) > length) length = fabs(n[k]);
    }
    off = far[kind / 3] * size;
    switch (kind % 3) {
    case 0:
        /* above a vertex, a place on an edge, or inside, by the normal: in
         * coordinates of few bits exactly */
        j = rnd_below(3);
        w[0] = w[1] = w[2] = 0.0;
        w[j] = 1.0;
        if (rnd_below(3)) {
            w[j] = 0.25 * (1 + rnd_below(3));
            w[(j + 1) % 3] = 1.0 - w[j];
        }
        if (rnd_below(3) == 0)
            for (k = 0; k < 3; k++) w[k] = k == j ? 0.5 : 0.25;
        break;
    case 1:
        /* in its plane, as far away */
        for (j = 0; j < 2; j++) w[j] = (rnd_unit() - 0.5) * 2.0 * off / size;
        if (rnd_below(2)) w[0] = floor(4.0 * w[0]);
        if (rnd_below(2)) w[1] = floor(4.0 * w[1]);
        w[2] = 1.0 - w[0] - w[1];
        off = 0.0;
        break;
    default:
        /* beyond an edge or a vertex, away from the middle */
        j = rnd_below(3);
        w[0] = w[1] = w[2] = 0.0;
        w[j] = rnd_below(2) ? 1.0 : rnd_unit();
        w[(j + 1) % 3] = 1.0 - w[j];
        length = size;
        for (k = 0; k < 3; k++)
            n[k] = w[0] * a[0][k] + w[1] * a[1][k] + w[2] * a[2][k] - middle[k];
        break;
    }
    for (k = 0; k < 3; k++)
        q[k] = w[0] * a[0][k] + w[1] * a[1][k] + w[2] * a[2][k] +
               off * (n[k] / length);
}

static void test_locate(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "clusters", "cubesurf", "planespread", "bcc",
        "spherenorm", "twolines", "aniso", "offset", "duplicates",
        "gridrot", "globe", "rotcube", "slanted", "rottet", "cubegrid", "prism",
        "moment", "ellipsoid", NULL
    };
    char name[64];
    result r;
    double q[3], lo[3], hi[3], middle[3], w[4], size;
    tess_int i, j, t, n, *hull, many, out;
    int f, k, m, code, turn, met[3];

    for (f = 0; family[f] != NULL; f++)
    for (turn = 0; turn < 2; turn++) {
        faults = 0;
        current = NULL;
        sprintf(name, "%s%s", family[f], turn ? ", turned" : "");
        points(&r, family[f], affordable(family[f], quick ? 100 : 250), 6);
        if (turn) turned(&r);
        solve(&r);
        current = &r;
        if (r.code != TESS_OK) {
            require(sizeof(tess_real) < sizeof(double), "a code");
            release(0);
            continue;
        }
        n = r.n;
        size = 0.0;
        for (k = 0; k < 3; k++) {
            lo[k] = hi[k] = (double)r.p[k];
            for (i = 0; i < n; i++) {
                if (r.p[3 * i + k] < lo[k]) lo[k] = (double)r.p[3 * i + k];
                if (r.p[3 * i + k] > hi[k]) hi[k] = (double)r.p[3 * i + k];
            }
            if (hi[k] - lo[k] > size) size = hi[k] - lo[k];
            middle[k] = 0.5 * (lo[k] + hi[k]);
        }
        hull = hull_of(&r, &many);
        out = 0;
        for (m = 0; m < (quick ? 10 : 40) * OUTER && faults < 5; m++) {
            t = rnd_below(2) ? TESS_NONE : (tess_int)rnd_below((int)r.ntet);
            beside(&r, hull[rnd_below((int)many)], m % OUTER, size, middle, q);
            out += locate(&r, q, t, -1, 0) == 1;
        }
        require(faults > 0 || 2 * out > m, "few places are outside");
        for (m = 0; m < (quick ? 100 : 1000) && faults < 5; m++) {
            int want = -1; /* 0 inside, 1 outside, -1 not known */

            t = m % 2 ? TESS_NONE : (tess_int)rnd_below((int)r.ntet);
            i = (tess_int)rnd_below((int)n);
            j = (tess_int)rnd_below((int)n);
            switch (m % 5) {
            case 0:
                /* a point of the box widened by a half */
                for (k = 0; k < 3; k++)
                    q[k] = lo[k] + (hi[k] - lo[k]) *
                           (1.5 * rnd_unit() - 0.25);
                for (k = 0; k < 3; k++)
                    if (q[k] < lo[k] || q[k] > hi[k]) want = 1;
                break;
            case 1:
                /* a point of the set */
                for (k = 0; k < 3; k++) q[k] = (double)r.p[3 * i + k];
                want = 0;
                break;
            case 2:
                /* halfway between two of them, rounded */
                for (k = 0; k < 3; k++)
                    q[k] = 0.5 * ((double)r.p[3 * i + k] +
                                  (double)r.p[3 * j + k]);
                break;
            case 3:
                /* far outside */
                for (k = 0; k < 3; k++)
                    q[k] = lo[k] + (hi[k] - lo[k]) *
                           (k == m / 5 % 3 ? 1000.0 : rnd_unit());
                want = 1;
                break;
            default:
                /* in the box's surface */
                for (k = 0; k < 3; k++)
                    q[k] = k == m / 5 % 3 ? lo[k]
                         : lo[k] + (hi[k] - lo[k]) * rnd_unit();
                break;
            }
            locate(&r, q, t, want, 0);
        }
        /* bad arguments leave nothing but the code */
        t = TESS_NONE;
        for (k = 0; k < 3; k++) {
            tess_real z[3];

            z[0] = r.p[0];
            z[1] = r.p[1];
            z[2] = r.p[2];
            require(tess_locate(r.p, 0, r.tet, r.adj, z, &t, w) == -2,
                    "tess_locate in nothing");
            t = r.ntet;
            require(tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w) == -6,
                    "tess_locate from t = ntet");
            t = -2;
            require(tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w) == -6,
                    "tess_locate from t = -2");
            t = TESS_NONE;
            z[k] = (tess_real)infinity();
            code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w);
            require(code == -5, "tess_locate of infinity");
            z[k] = (tess_real)(infinity() - infinity());
            code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w);
            require(code == -5, "tess_locate of NaN");
        }
        current = NULL;
        release(0);
        done("locate", name);
    }
    /* an unfinished result: -4 where the walk meets an open facet */
    faults = met[0] = met[1] = met[2] = 0;
    points(&r, "uniform", 200, 3);
    solve(&r);
    t = r.ntet;
    release(1);
    for (i = 1; i < t; i += t / 10 + 1) {
        room(&r, i);
        run(&r);
        current = &r;
        for (m = 0; m < 300; m++) {
            for (k = 0; k < 3; k++) q[k] = (double)(float)rnd_unit();
            /* or a vertex, which is at the end of a tetrahedron's box */
            if (m % 3 == 0) {
                j = r.tet[rnd_below((int)(4 * i))];
                for (k = 0; k < 3; k++) q[k] = (double)r.p[3 * j + k];
            }
            /* a place outside of the hull, too */
            if (m % 7 == 0) q[m % 3] += 2.0;
            code = locate(&r, q,
                          m % 2 ? TESS_NONE : (tess_int)rnd_below((int)i),
                          -1, 1);
            met[code < 0 ? 2 : code]++;
            require(code != 0 || held_by_one(&r, q), "q is in none");
        }
        release(1);
    }
    require(met[0] > 100 && met[1] > 10 && met[2] > 100,
            "places in it, outside of the hull, behind open facets");
    current = NULL;
    release(0);
    test_result("tess_locate in an unfinished result", faults);
}

/* ---- many places ---- */

#define PLACES 60

/* tess_values against tess_locate one by one. */
static void one_values(const result *r, const tess_real *q, tess_int nv,
                       const tess_int *start)
{
    int keep = narrays, code, k, c, outer = 0;
    tess_int *t = ints(PLACES), *u = ints(PLACES), *one = ints(PLACES), i, j;
    double *value = (double *)array((size_t)(nv * r->n) * sizeof *value);
    double *out = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double *again = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double *alone = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double w[4], sum, size;
    int single[PLACES];

    for (i = 0; i < nv * r->n; i++) value[i] = 2.0 * rnd_unit() - 1.0;
    /* a constant, which no rounding may alter */
    for (i = 0; i < r->n && nv > 1; i++) value[nv * i] = 0.1;
    memcpy(t, start, PLACES * sizeof *t);
    code = tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, PLACES, q, t,
                       out);
    require(code == 0 || code == 1, "tess_values' code");
    memcpy(u, t, PLACES * sizeof *t);
    /* given back */
    require(tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, PLACES, q, u,
                        again) == code, "tess_values' code from its own t");
    /* one at a time */
    memcpy(one, start, PLACES * sizeof *one);
    for (i = 0; i < PLACES; i++) {
        if (i > 0 && one[i] == TESS_NONE) one[i] = one[i - 1];
        single[i] = tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, 1,
                                q + 3 * i, one + i, alone + nv * i);
    }
    require(memcmp(one, t, PLACES * sizeof *t) == 0 &&
                memcmp(alone, out, (size_t)(nv * PLACES) * sizeof *out) == 0,
            "tess_values' t or values one at a time");
    for (i = 0; i < PLACES; i++) {
        tess_int s = i % 2 ? TESS_NONE : (tess_int)rnd_below((int)r->ntet);

        c = tess_locate(r->p, r->ntet, r->tet, r->adj, q + 3 * i, &s, w);
        if (c == 1) outer = 1;
        require(single[i] == c, "tess_values' code one at a time");
        if (c == 0) require(t[i] == s && u[i] == s, "tess_values' t");
        if (c == 1) {
            /* marked, so that each query's own code is known */
            t[i] = -2 - t[i];
            u[i] = -2 - u[i];
            require(t[i] >= 0 && t[i] < r->ntet && u[i] >= 0 &&
                    u[i] < r->ntet, "tess_values' mark of a place outside");
            if (t[i] < 0 || u[i] < 0) continue;
        }
        for (k = 0; k < 4 && c == 1; k++)
            require(w[k] == 0.0 ||
                    (slot_of(r, t[i], r->tet[4 * s + k]) < 4 &&
                     slot_of(r, u[i], r->tet[4 * s + k]) < 4),
                    "tess_values' t outside");
        for (j = 0; j < nv; j++) {
            for (k = 0, sum = size = 0.0; k < 4; k++) {
                double x = w[k] * value[nv * r->tet[4 * s + k] + j];

                sum += x;
                size += fabs(x);
            }
            require(fabs(out[nv * i + j] - sum) <= 16.0 * DBL_EPSILON * size &&
                    fabs(again[nv * i + j] - sum) <= 16.0 * DBL_EPSILON * size,
                    "tess_values' value");
            require(c == 1 || out[nv * i + j] == again[nv * i + j],
                    "tess_values from its own t");
            require(j > 0 || nv == 1 || out[nv * i] == 0.1,
                    "tess_values of a constant");
        }
    }
    require(code == outer, "tess_values' code");
    require(overrun() == 0, "tess_values: an array is overrun");
    release(keep);
}

static void values_code(const result *r, tess_int ntet, tess_int nv,
                        tess_int nq, const tess_real *q, const tess_int *start,
                        int want, const char *what)
{
    int keep = narrays;
    tess_int *t = ints(PLACES);
    double *value = (double *)array((size_t)(3 * r->n) * sizeof *value);
    double *out = (double *)array((size_t)(3 * PLACES) * sizeof *out);

    memset(value, 0, (size_t)(3 * r->n) * sizeof *value);
    memcpy(t, start, PLACES * sizeof *t);
    require(tess_values(r->p, ntet, r->tet, r->adj, nv, value, nq, q, t, out) ==
            want, what);
    require(memcmp(t, start, PLACES * sizeof *t) == 0 &&
            untouched(out, 3 * PLACES * sizeof *out),
            "tess_values: written all the same");
    release(keep);
}

static void test_values(void)
{
    static const char *const family[] = {
        "uniform", "cubesurf", "rotcube", "duplicates", "gridrot", "bcc", NULL
    };
    result r;
    tess_real q[3 * PLACES], held;
    tess_int start[PLACES], t[PLACES], i, u;
    double out[PLACES];
    int f, k, round, code;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        points(&r, family[f], 300, 4);
        if (f % 2) turned(&r);
        solve(&r);
        current = &r;
        for (round = 0; round < 9; round++) {
            for (i = 0; i < PLACES; i++) {
                const tess_int *v = r.tet + 4 * rnd_below((int)r.ntet);

                for (k = 0; k < 3; k++)
                    q[3 * i + k] = (tess_real)
                        (0.25 * r.p[3 * v[0] + k] + 0.25 * r.p[3 * v[1] + k] +
                         0.25 * r.p[3 * v[2] + k] + 0.25 * r.p[3 * v[3] + k]);
                /* in some rounds all are inside, or nearly so */
                if (round % 3 && i % 4 == round % 4)
                    q[3 * i] += (tess_real)(i % 8 ? 1e3 : -30.0);
                start[i] = rnd_below(2 + round) == 0
                         ? (tess_int)rnd_below((int)r.ntet) : TESS_NONE;
            }
            one_values(&r, q, round % 3 == 2 ? 3 : round / 3, start);
        }
        current = NULL;
        release(0);
        done("tess_values", family[f]);
    }
    faults = 0;
    points(&r, "uniform", 100, 4);
    solve(&r);
    current = &r;
    for (i = 0; i < PLACES; i++) {
        memcpy(q + 3 * i, r.p + 3 * i, 3 * sizeof *q);
        start[i] = i % 2 ? TESS_NONE : i;
    }
    values_code(&r, r.ntet, 1, 0, q, start, 0, "tess_values of none");
    values_code(&r, 0, 1, PLACES, q, start, -2, "tess_values in nothing");
    values_code(&r, -1, 1, PLACES, q, start, -2, "tess_values, ntet -1");
    values_code(&r, r.ntet, -1, PLACES, q, start, -5, "tess_values, nv -1");
    values_code(&r, r.ntet, 1, -1, q, start, -7, "tess_values, nq -1");
    values_code(&r, r.ntet, 1, largest() / 3 + 1, q, start, -7,
                "tess_values, nq too large");
    for (i = 0; i < 3 * PLACES; i += 3 * PLACES / 2 - 1)
        for (k = 0; k < 2; k++) {
            held = q[i];
            q[i] = (tess_real)(k ? infinity() : infinity() - infinity());
            values_code(&r, r.ntet, 1, PLACES, q, start, -8,
                        "tess_values of infinity or NaN");
            q[i] = held;
        }
    for (i = 0; i < PLACES; i += PLACES - 1)
        for (k = 0; k < 2; k++) {
            u = start[i];
            start[i] = k ? r.ntet : -2 - r.ntet;
            values_code(&r, r.ntet, 1, PLACES, q, start, -9,
                        "tess_values from no tetrahedron");
            start[i] = u;
        }
    /* the queries before the one that comes upon a neighbour out of range */
    for (i = 0; i < 4 * r.ntet; i++)
        if (r.adj[i] >= 0) r.adj[i] = r.ntet;
    for (i = 0; i < PLACES; i++) {
        t[i] = i < PLACES / 2 ? i : 0;
        out[i] = 7.0;
        for (k = 0; k < 3; k++)
            q[3 * i + k] = (tess_real)(0.25 * r.p[3 * r.tet[4 * i] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 1] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 2] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 3] + k]);
    }
    {
        double *ones = (double *)array((size_t)r.n * sizeof *ones);

        for (i = 0; i < r.n; i++) ones[i] = 1.0;
        code = tess_values(r.p, r.ntet, r.tet, r.adj, 1, ones, PLACES, q, t,
                           out);
    }
    require(code == -4, "tess_values, a neighbour out of range");
    for (i = 0; i < PLACES; i++)
        require(i < PLACES / 2 ? t[i] == i && fabs(out[i] - 1.0) < 1e-14
                               : t[i] == 0 && out[i] == 7.0,
                "tess_values before and after -4");
    current = NULL;
    release(0);
    test_result("bad arguments of tess_values", faults);
}

/* ---- check ---- */

/* adj from tet, by sorting the facets. */
static void link_up(result *r)
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

/* A complex given by its points and tetrahedra, which are turned to be
 * positive. */
static void given(result *r, const char *name, const double *p, tess_int n,
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

static void expect(const result *r, int code, const char *what)
{
    int found = checked(r);

    if (found != code) {
        fail(what);
        if (faults <= SHOWN)
            printf("    tess_check %d instead of %d\n", found, code);
    }
}

/* Every kind of fault by hand. */
static void test_faults(void)
{
    static const double five[15] = {
        0, 0, 0, 8, 0, 0, 0, 8, 0, 2, 2, 1, 2, 2, -1
    };
    static const tess_int two[8] = { 0, 1, 2, 3, 0, 2, 1, 4 };
    static const tess_int three[12] = { 3, 4, 0, 1, 3, 4, 1, 2, 3, 4, 2, 0 };
    static const double cube[27] = {
        0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1,
        1, 1, 1, 0.25, 0.5, 0.75
    };
    /* a regular tetrahedron and four corners, in two ways */
    static const tess_int cube1[20] = {
        0, 3, 6, 5, 1, 0, 5, 3, 2, 0, 3, 6, 4, 0, 6, 5, 7, 3, 5, 6
    };
    static const tess_int cube2[20] = {
        1, 2, 4, 7, 0, 1, 2, 4, 3, 2, 1, 7, 5, 1, 4, 7, 6, 4, 2, 7
    };
    static const double octa[18] = {
        1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1
    };
    static const double ring[12][2] = {
        { 5, 0 }, { 4, 3 }, { 3, 4 }, { 0, 5 }, { -3, 4 }, { -4, 3 },
        { -5, 0 }, { -4, -3 }, { -3, -4 }, { 0, -5 }, { 3, -4 }, { 4, -3 }
    };
    double p[15 * 3];
    tess_int tet[48], i;
    result r;
    int turn;

    faults = 0;
    given(&r, "five points, two tetrahedra", five, 5, two, 2);
    current = &r;
    expect(&r, TESS_BAD_BALL, "not Delaunay");
    given(&r, "five points, three tetrahedra", five, 5, three, 3);
    expect(&r, 0, "the right flip");
    r.ntet = 2;
    link_up(&r);
    expect(&r, TESS_BAD_HULL, "one of three missing");
    r.ntet = 1;
    link_up(&r);
    expect(&r, TESS_BAD_POINT, "one of three alone");
    r.ntet = 0;
    require(checked(&r) > 0, "no tetrahedron, though the points have some");
    release(0);

    /* cospherical points: any triangulation of them is right */
    for (turn = 0; turn < 2; turn++) {
        given(&r, "cube in five", cube, 8, turn ? cube2 : cube1, 5);
        current = &r;
        expect(&r, 0, "a cube in five");
        /* a point inside it that no tetrahedron has */
        given(&r, "cube with a point inside", cube, 9, r.tet, 5);
        expect(&r, TESS_BAD_POINT, "a missing point");
        {
            tess_int bad = -7, *iw = ints(18);

            tess_check(9, r.p, r.ntet, r.tet, r.adj, 18, iw, &bad);
            require(bad == 8, "bad is not the missing point");
        }
        release(0);
    }
    for (turn = 0; turn < 3; turn++) {
        /* four tetrahedra around a diagonal; points 2i, 2i+1 are opposite */
        tess_int d = 2 * turn, e = (d + 2) % 6, g = (d + 4) % 6;
        tess_int around[5];

        around[0] = around[4] = e;
        around[1] = g;
        around[2] = e + 1;
        around[3] = g + 1;
        for (i = 0; i < 4; i++) {
            tet[4 * i] = d;
            tet[4 * i + 1] = d + 1;
            tet[4 * i + 2] = around[i];
            tet[4 * i + 3] = around[i + 1];
        }
        given(&r, "octahedron", octa, 6, tet, 4);
        current = &r;
        expect(&r, 0, "an octahedron about any of its diagonals");
        release(0);
    }
    /* twelve points of a circle, taken every other one, twice around the axis
     * between two poles: a closed surface, convex at every edge, all points
     * on one ball, Euler's relation holds; but it winds twice */
    for (i = 0; i < 12; i++) {
        p[3 * i] = ring[(2 * i + i / 6) % 12][0];
        p[3 * i + 1] = ring[(2 * i + i / 6) % 12][1];
        p[3 * i + 2] = 0.0;
        tet[4 * i] = 12;
        tet[4 * i + 1] = 13;
        tet[4 * i + 2] = i;
        tet[4 * i + 3] = (i + 1) % 12;
    }
    for (i = 36; i < 42; i++) p[i] = 0.0;
    p[38] = -5.0;
    p[41] = 5.0;
    given(&r, "wound twice", p, 14, tet, 12);
    current = &r;
    require(orient(&r, 12, 13, 0, 1) == 1, "the test's own complex");
    expect(&r, TESS_BAD_COVER, "a complex wound twice");
    /* the same with O at the other pole, the greatest in its coordinate */
    for (i = 0; i < 12; i++) {
        tet[4 * i] = 13;
        tet[4 * i + 1] = 12;
        tet[4 * i + 2] = (i + 1) % 12;
        tet[4 * i + 3] = i;
    }
    given(&r, "wound twice", p, 14, tet, 12);
    expect(&r, TESS_BAD_COVER, "a complex wound twice, from above");
    /* once around, in order, is right */
    for (i = 0; i < 12; i++) {
        p[3 * i] = ring[i][0];
        p[3 * i + 1] = ring[i][1];
    }
    given(&r, "wound once", p, 14, tet, 12);
    expect(&r, 0, "a complex wound once");
    /* the same twice around with a point in the middle of the axis, which is
     * a vertex of all tetrahedra */
    {
        tess_int more[96];

        for (i = 0; i < 48; i++) {
            more[i] = tet[i] == 12 ? 14 : tet[i];
            more[48 + i] = tet[i] == 13 ? 14 : tet[i];
        }
        for (i = 0; i < 12; i++) {
            p[3 * i] = ring[(2 * i + i / 6) % 12][0];
            p[3 * i + 1] = ring[(2 * i + i / 6) % 12][1];
        }
        for (i = 42; i < 45; i++) p[i] = 0.0;
        given(&r, "wound twice about a point", p, 15, more, 24);
        expect(&r, TESS_BAD_COVER, "wound twice about a point");
        for (i = 0; i < 12; i++) {
            p[3 * i] = ring[i][0];
            p[3 * i + 1] = ring[i][1];
        }
        given(&r, "wound once about a point", p, 15, more, 24);
        expect(&r, 0, "wound once about a point");
    }
    /* the great icosahedron: twelve vertices of an icosahedron, joined in
     * threes that are not neighbours in it, and its centre */
    {
        static const double far = 1.6180339887498949;
        static double q[39];
        tess_int star[80], a, b, c, m = 0;

        for (i = 0; i < 12; i++) {
            q[3 * i + i / 4] = 0.0;
            q[3 * i + (i / 4 + 1) % 3] = i % 2 ? 1.0 : -1.0;
            q[3 * i + (i / 4 + 2) % 3] = i / 2 % 2 ? far : -far;
        }
        for (a = 0; a < 12; a++)
            for (b = a + 1; b < 12; b++)
                for (c = b + 1; c < 12; c++) {
                    const double *x = q + 3 * a, *y = q + 3 * b;
                    const double *z = q + 3 * c;
                    double xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
                    double yz = y[0] * z[0] + y[1] * z[1] + y[2] * z[2];
                    double zx = z[0] * x[0] + z[1] * x[1] + z[2] * x[2];

                    /* neighbours have far, opposite ones -3.6 */
                    if (xy < -3.0 || yz < -3.0 || zx < -3.0 || xy > 0.0 ||
                        yz > 0.0 || zx > 0.0 || m == 80)
                        continue;
                    /* positive as it is: the centre stays first */
                    star[m] = 12;
                    star[m + 1] = a;
                    if (ex_orient(q + 36, x, y, z) > 0) {
                        star[m + 2] = b;
                        star[m + 3] = c;
                    } else {
                        star[m + 2] = c;
                        star[m + 3] = b;
                    }
                    m += 4;
                }
        require(m == 80, "the test's own icosahedron");
        given(&r, "great icosahedron", q, 13, star, m / 4);
        expect(&r, TESS_BAD_COVER, "a great icosahedron");
    }
    /* the whole twice over, on the same points */
    {
        tess_int twice[96];

        for (i = 0; i < 96; i++) twice[i] = tet[i % 48];
        given(&r, "twice the same", p, 14, twice, 24);
        r.ntet = 12;
        link_up(&r);
        r.ntet = 24;
        for (i = 48; i < 96; i++) {
            r.tet[i] = r.tet[i - 48];
            r.adj[i] = r.adj[i - 48] < 0 ? TESS_NONE : r.adj[i - 48] + 12;
        }
        i = checked(&r);
        require(i == TESS_BAD_COVER || i == TESS_BAD_HULL,
                "all tetrahedra twice");
    }
    /* what condition 4 of tess_check alone refuses: two tetrahedra apart, each
     * a convex body; and five points of a circle, joined twice around the axis
     * in a star, with O in one of its tips, which is covered once */
    {
        static const double apart[24] = {
            0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1,
            5, 0, 0, 6, 0, 0, 5, 1, 0, 5, 0, 1
        };
        static const tess_int both[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
        static const int tip[5] = { 0, 5, 10, 2, 7 };

        given(&r, "two tetrahedra apart", apart, 8, both, 2);
        current = &r;
        expect(&r, TESS_BAD_HULL, "two tetrahedra apart");
        for (i = 0; i < 5; i++) {
            p[3 * i] = ring[tip[i]][0];
            p[3 * i + 1] = ring[tip[i]][1];
            p[3 * i + 2] = 0.0;
            tet[4 * i] = i;
            tet[4 * i + 1] = (i + 1) % 5;
            tet[4 * i + 2] = 5;
            tet[4 * i + 3] = 6;
        }
        for (i = 15; i < 21; i++) p[i] = 0.0;
        p[17] = -5.0;
        p[20] = 5.0;
        given(&r, "a star", p, 7, tet, 5);
        require(orient(&r, 0, 1, 5, 6) == 1, "the test's own star");
        expect(&r, TESS_BAD_HULL, "a star, O in a tip");
        /* with O in the middle, at a pole, it is covered twice */
        for (i = 0; i < 5; i++) {
            tet[4 * i] = 5;
            tet[4 * i + 1] = 6;
            tet[4 * i + 2] = i;
            tet[4 * i + 3] = (i + 1) % 5;
        }
        given(&r, "a star", p, 7, tet, 5);
        expect(&r, TESS_BAD_COVER, "a star, O in the middle");
    }
    /* flat */
    given(&r, "flat", cube, 8, two, 1);
    require(orient(&r, 0, 1, 2, 3) == 0, "the test's own points");
    expect(&r, TESS_BAD_SIGN, "a flat tetrahedron");
    current = NULL;
    release(0);
    test_result("tess_check: complexes by hand", faults);
}

/* Does verify find what is wrong with r?  Asked of every seventh. */
static int wrong(const result *r, tess_int i)
{
    return i % 7 != 0 || verify(r->n, r->p, TESS_OK, r->ntet, r->tet, r->adj,
                                r->iw) != NULL;
}

/* Every entry of right results changed in turn: what is wrong must be seen,
 * and said by its code where it is the only fault. */
static void test_mutations(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "duplicates", "cubesurf", "spherei", NULL
    };
    result r;
    tess_int i, j, k, held, other, bad, *iw;
    int f, code, b;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        current = NULL;
        points(&r, family[f], quick ? 14 : 30, 8);
        solve(&r);
        current = &r;
        require(r.code == TESS_OK && checked(&r) == 0, "a right result");
        iw = ints(2 * r.n);
        for (i = 0; i < 4 * r.ntet; i++) {
            /* vertices out of range, or twice */
            held = r.tet[i];
            for (k = 0; k < 4; k++) {
                r.tet[i] = k == 0 ? r.n : k == 1 ? -1
                         : r.tet[i - i % 4 + (i + k - 1) % 4];
                expect(&r, TESS_BAD_INDEX, "a bad vertex");
            }
            /* any other vertex */
            for (j = 0; j < r.n; j++) {
                if (j == held) continue;
                r.tet[i] = j;
                code = checked(&r);
                require(code > 0 && wrong(&r, i), "another vertex");
                if (r.iw[j] == held)
                    require(code == TESS_BAD_TWIN, "a duplicate");
            }
            r.tet[i] = held;
            /* any other neighbour */
            held = r.adj[i];
            for (j = -5; j < r.ntet + 3; j++) {
                if (j == held) continue;
                r.adj[i] = j;
                code = checked(&r);
                require(code > 0 && wrong(&r, i), "another neighbour");
                if (j == TESS_OPEN)
                    require(code == TESS_BAD_OPEN, "an open facet");
                if (j < TESS_OPEN || j >= r.ntet || j == i / 4)
                    require(code == TESS_BAD_ADJ, "adj out of range");
            }
            r.adj[i] = held;
            /* two vertices exchanged, with their neighbours */
            for (k = 0; k < 3; k++) {
                other = i - i % 4 + (i + 1 + k) % 4;
                for (b = 0; b < 2; b++) {
                    held = r.tet[i];
                    r.tet[i] = r.tet[other];
                    r.tet[other] = held;
                    held = r.adj[i];
                    r.adj[i] = r.adj[other];
                    r.adj[other] = held;
                    if (b == 0) {
                        bad = -7;
                        code = tess_check(r.n, r.p, r.ntet, r.tet, r.adj,
                                          2 * r.n, iw, &bad);
                        require(code == TESS_BAD_SIGN && bad == i / 4 &&
                                    wrong(&r, i),
                                "a tetrahedron turned inside out");
                    }
                }
                /* the neighbours alone */
                held = r.adj[i];
                if (held != r.adj[other]) {
                    r.adj[i] = r.adj[other];
                    r.adj[other] = held;
                    require(checked(&r) == TESS_BAD_ADJ && wrong(&r, i),
                            "adj exchanged");
                    r.adj[other] = r.adj[i];
                    r.adj[i] = held;
                }
            }
        }
        require(checked(&r) == 0, "the test's own result");
        /* one tetrahedron left out: the hull is not convex, or a point is
         * left out with it */
        for (i = 0; i < r.ntet; i++) {
            result s = r;
            int hull = 0, keep = narrays, b2;

            for (b2 = 0; b2 < 4; b2++) hull += r.adj[4 * i + b2] == TESS_NONE;
            s.tet = ints(4 * r.ntet);
            s.adj = ints(4 * r.ntet);
            for (j = k = 0; j < 4 * r.ntet; j++)
                if (j / 4 != i) s.tet[k++] = r.tet[j];
            s.ntet = r.ntet - 1;
            link_up(&s);
            code = checked(&s);
            require((hull >= 3 ? code > 0 : code == TESS_BAD_HULL) &&
                        wrong(&s, 0), "a tetrahedron left out");
            release(keep);
        }
        /* even permutations of vertices, another order of the tetrahedra */
        for (i = 0; i < r.ntet; i++) {
            held = r.tet[4 * i];
            r.tet[4 * i] = r.tet[4 * i + 1];
            r.tet[4 * i + 1] = r.tet[4 * i + 3];
            r.tet[4 * i + 3] = held;
            j = (tess_int)rnd_below((int)r.ntet);
            for (k = 0; k < 4; k++) {
                held = r.tet[4 * i + k];
                r.tet[4 * i + k] = r.tet[4 * j + k];
                r.tet[4 * j + k] = held;
            }
        }
        link_up(&r);
        expect(&r, 0, "tetrahedra in another order");
        current = NULL;
        release(0);
        done("changed results", family[f]);
    }
}

/* ---- damage that tess_resume finds ---- */

/* tess_resume refuses r, of ntet tetrahedra, with the code; tet and adj stay. */
static void refused(const result *like, int code, const char *what)
{
    result r = *like;
    size_t length = (size_t)(4 * r.maxtet) * sizeof(tess_int);
    int keep = narrays;

    r.iw = ints(r.liw);
    r.rw = (double *)array((size_t)r.lrw * sizeof(double));
    r.tet = ints(4 * r.maxtet);
    r.adj = ints(4 * r.maxtet);
    memcpy(r.tet, like->tet, length);
    memcpy(r.adj, like->adj, length);
    resume(&r);
    require(r.code == code && r.ntet == like->ntet, what);
    if (r.code != code) printf("    code %d instead of %d\n", r.code, code);
    require(memcmp(r.tet, like->tet, length) == 0 &&
            memcmp(r.adj, like->adj, length) == 0, "damage, and written");
    require(overrun() == 0, "an array is overrun");
    release(keep);
}

static void test_damage(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "duplicates", NULL
    };
    static const double five[15] = {
        0, 0, 0, 8, 0, 0, 0, 8, 0, 2, 2, 1, 2, 2, -1
    };
    static const tess_int two[8] = { 0, 1, 2, 3, 0, 2, 1, 4 };
    result whole, r;
    tess_int i, j, u, held, stop_at;
    int f, k;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        current = NULL;
        points(&whole, family[f], quick ? 16 : 40, 2);
        solve(&whole);
        /* unfinished in the middle, and whole: no pool, then none at a star */
        for (stop_at = whole.ntet / 2; stop_at <= whole.ntet;
             stop_at += whole.ntet - whole.ntet / 2) {
            r = whole;
            room(&r, stop_at);
            run(&r);
            current = &r;
            require(r.code == (stop_at < whole.ntet ? TESS_MORE : TESS_OK),
                    "a code");
            for (i = 0; i < 4 * r.ntet && faults == 0; i++) {
                u = r.adj[i];
                /* another point, even a duplicate of the right one */
                for (j = 0; j < r.n; j++)
                    if (whole.iw[j] != j && whole.iw[j] == r.tet[i]) {
                        held = r.tet[i];
                        r.tet[i] = j;
                        refused(&r, -5, "a duplicate for a vertex");
                        r.tet[i] = held;
                    }
                /* turned inside out */
                j = i - i % 4 + (i + 1) % 4;
                held = r.tet[i];
                r.tet[i] = r.tet[j];
                r.tet[j] = held;
                r.adj[i] = r.adj[j];
                r.adj[j] = u;
                /* one before it is first to see that they do not match */
                for (k = 0, held = -5; k < 4; k++)
                    if (r.adj[i - i % 4 + k] >= 0 &&
                        r.adj[i - i % 4 + k] < i / 4)
                        held = -6;
                refused(&r, (int)held, "a tetrahedron turned inside out");
                held = r.tet[j];
                r.tet[j] = r.tet[i];
                r.tet[i] = held;
                r.adj[j] = r.adj[i];
                r.adj[i] = u;
                if (u < 0) continue;
                /* one side only */
                for (held = TESS_OPEN; held <= TESS_NONE; held++) {
                    r.adj[i] = held;
                    refused(&r, -6, "matched on one side alone");
                }
                /* any other neighbour */
                for (held = 0; held < r.ntet; held += 7)
                    if (held != u) {
                        r.adj[i] = held;
                        refused(&r, -6, "not its neighbour");
                    }
                /* open on both sides, in the pool or in the link */
                for (k = 0; k < 4; k++)
                    if (r.adj[4 * u + k] == i / 4) break;
                require(k < 4, "adj is not mutual");
                r.adj[i] = r.adj[4 * u + k] = TESS_OPEN;
                refused(&r, -6, "open on both sides");
                r.adj[i] = u;
                r.adj[4 * u + k] = i / 4;
            }
            resume(&r);
            require(r.code == (stop_at < whole.ntet ? TESS_MORE : TESS_OK),
                    "the test's own result");
        }
        current = NULL;
        release(0);
        done("damage", family[f]);
    }
    faults = 0;
    given(&r, "five points, two tetrahedra", five, 5, two, 2);
    current = &r;
    refused(&r, -5, "a neighbour's apex in the ball");
    current = NULL;
    release(0);
    test_result("damage: not Delaunay", faults);
}

/* Results damaged by chance, and arrays that have failed. */
static void test_chance(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "duplicates", "spherei", "planeone", NULL
    };
    static const long size[] = { 4, 6, 15, 60 };
    static const double points_six[18] = {
        1, 3, 1, 3, 0, 1, 3, 1, 0, 1, 2, 0, 0, 0, 2, 0, 2, 2
    };
    static const tess_int six[12] = { 1, 5, 3, 0, 5, 1, 3, 4, 4, 3, 2, 1 };
    static const tess_int six_adj[12] = {
        1, 0, 2, -2, 2, -1, -2, -2, -2, -2, -2, 2
    };
    const char *what = NULL;
    tess_real p[18];
    result r;
    int f, i, k;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        for (k = 0; k < 4; k++) {
            if (!points(&r, family[f], size[k], 5)) continue;
            solve(&r);
            current = &r;
            for (i = 0; i < (quick ? 150 : 3000) && what == NULL; i++)
                what = damage(r.n, r.p, r.ntet, r.tet, r.adj, r.iw, rnd_below);
            if (what != NULL) fail(what);
            what = NULL;
            current = NULL;
            release(0);
        }
        done("damage by chance", family[f]);
    }
    for (i = 0; i < 18; i++) p[i] = (tess_real)points_six[i];
    for (i = 0; i < 400 && what == NULL; i++)
        what = damage_resume(6, p, 3, six, six_adj, rnd_below);
    test_result("damage: arrays that have failed", what != NULL);
}

/* Ways in which a walk cannot arrive. */
static void test_lost(void)
{
    /* triangles about a middle one, turned so that from each the walk goes on
     * to the next, round and round; all joined to a point above.  The points
     * are not Delaunay. */
    static const double wheel[21] = {
        1, 0, 0, -0.5, 0.875, 0, -0.5, -0.875, 0, 9.375, -3.5, 0, -1.75, 9.875,
        0, -7.625, -6.375, 0, 0, 0, 5
    };
    static const double q[3] = { 0, 0, 1 };
    static const double bent[15] = {
        0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1
    };
    static const tess_int both[8] = { 0, 1, 2, 3, 1, 2, 3, 4 };
    static const double beyond[3] = { 0.5625, 0.53125, -0.5 };
    tess_int tet[32], adj[32], t, from, i;
    tess_real z[3];
    double w[4];
    result r;
    int k, code;

    faults = 0;
    tet[0] = 0;
    tet[1] = 1;
    tet[2] = 2;
    for (i = 0; i < 3; i++) {
        tess_int next = (i + 1) % 3, *a = tet + 4 * (1 + 2 * i), *b = a + 4;

        a[0] = next;
        a[1] = i;
        a[2] = 3 + i;
        b[0] = 3 + next;
        b[1] = next;
        b[2] = 3 + i;
    }
    for (i = 0; i < 7; i++) tet[4 * i + 3] = 6;
    given(&r, "a wheel", wheel, 7, tet, 7);
    current = &r;
    for (i = 0; i < 28; i++)
        require(r.tet[i] == tet[i], "the test's own wheel");
    require(locate(&r, q, 0, 0, 0) == 0, "a walk that need not begin");
    for (t = 1, k = 0; t < 7; t++) k += locate(&r, q, t, 0, 1) == -4;
    require(k > 0, "a walk that goes round");
    release(0);

    /* neighbours out of range where the walk comes */
    points(&r, "uniform", 100, 3);
    solve(&r);
    current = &r;
    for (k = 0; k < 2; k++) {
        r.tet = ints(4 * r.ntet);
        r.adj = ints(4 * r.ntet);
        run(&r);
        for (i = 0; i < 4 * r.ntet; i++)
            if (r.adj[i] != TESS_NONE)
                r.adj[i] = k ? r.ntet : TESS_OPEN - 1;
        for (i = 0; i < r.n; i++) {
            for (code = 0; code < 3; code++) z[code] = r.p[3 * i + code];
            for (t = 0; t < r.ntet; t += 17) {
                if (slot_of(&r, t, i) < 4) continue;
                from = t;
                code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &from, w);
                require(code == -4, "a neighbour out of range");
            }
        }
    }
    current = NULL;
    release(0);

    /* outside, neighbours that are out of range or do not match, where the way
     * to the nearest point turns about the edge 1 2 */
    for (k = 0; k < 4; k++)
        for (t = k < 3 ? TESS_NONE : 0; t < (k < 3 ? 2 : 1); t++) {
            given(&r, "two", bent, 5, both, 2);
            current = &r;
            locate(&r, beyond, t, 1, 0);
            /* (where the wrong neighbours are there is a right one) */
            for (i = 0; i < 32; i++) {
                tet[i] = r.tet[i / 4 == 4 ? i % 4 : 4 + i % 4];
                adj[i] = r.adj[i / 4 == 4 ? i % 4 : 4 + i % 4];
            }
            for (i = 16; i < 24; i++)
                if (adj[i] >= 0)
                    adj[i] = k == 0 ? 2 : k == 1 ? TESS_OPEN - 1 : i / 4 - 4;
            if (k == 3) {
                /* a facet with another vertex */
                memcpy(adj + 16, r.adj, 8 * sizeof *adj);
                tet[20 + slot_of(&r, 1, 2)] = 0;
            }
            for (i = 0; i < 3; i++) z[i] = (tess_real)beyond[i];
            from = t;
            code = tess_locate(r.p, 2, tet + 16, adj + 16, z, &from, w);
            require(code == -4, "outside, a neighbour out of range");
            current = NULL;
            release(0);
        }
    test_result("tess_locate where a walk cannot arrive", faults);
}

/* ---- where the arithmetic, or the limbs, do not suffice ---- */

static int flushes(void)
{
    volatile double x = DBL_MIN;

    x *= 0.5;
    return x == 0.0;
}

/* A subnormal coordinate: TESS_RANGE where the processor takes it for zero,
 * else the right result.  (It is made when compiled, and only copied.) */
static void test_subnormal(void)
{
    static const tess_real sub[2] = {
        sizeof(tess_real) < sizeof(double) ? (tess_real)(FLT_MIN / 4)
                                           : (tess_real)(DBL_MIN / 4),
        sizeof(tess_real) < sizeof(double) ? (tess_real)(-FLT_MIN / 4)
                                           : (tess_real)(-DBL_MIN / 4)
    };
    static const double corner[12] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
    static const tess_int one[4] = { 0, 1, 2, 3 };
    tess_real p[12], q[3];
    double w[4];
    tess_int t, iw[10], bad;
    result r;
    int i, k, off = flushes();

    faults = 0;
    for (i = 0; i < 30; i++) {
        current = NULL;
        points(&r, "uniform", 20, 3);
        memcpy(r.p + 2 * i, sub + i % 2, sizeof *sub);
        current = &r;
        if (off) {
            room(&r, 100);
            run(&r);
            require(r.code == TESS_RANGE && r.ntet == 0, "flushed");
            require(untouched(r.tet, 400 * sizeof(tess_int)), "written");
            resume(&r);
            require(r.code == TESS_RANGE && r.ntet == 0, "flushed, resumed");
        } else {
            solve(&r);
            right(&r);
        }
        release(0);
    }
    current = NULL;
    given(&r, "a corner", corner, 4, one, 1);
    for (i = 0; i < 12; i++) {
        /* any coordinate that is zero, of a point or of the place */
        if (corner[i] != 0.0) continue;
        memcpy(p, r.p, sizeof p);
        for (k = 0; k < 3; k++) q[k] = 0;
        memcpy(p + i, sub, sizeof *sub);
        require(tess_check(4, p, 1, r.tet, r.adj, 8, iw, &bad) ==
                (off ? TESS_RANGE : TESS_OK), "tess_check, subnormal");
        /* all that matters is subnormal: 2 for each of the five places */
        for (k = 0; k < 12; k++) {
            p[k] = 0;
            if (corner[k] != 0.0) memcpy(p + k, sub, sizeof *sub);
        }
        require(hh_orient(p, p + 3, p + 6, p + 9) == (off ? 2 : 1) &&
                hh_insphere(p, p + 3, p + 6, p + 9, q) == (off ? 2 : 0),
                "signs of subnormal points");
        for (k = 3; k < 12; k += 4) {
            p[k] = 1;
            require(hh_orient(p, p + 3, p + 6, p + 9) ==
                    (k == 11 || !off ? 1 : 2), "one still subnormal");
        }
        memcpy(q, sub, sizeof *sub);
        memcpy(q + 1, sub, sizeof *sub);
        memcpy(q + 2, sub, sizeof *sub);
        require(hh_insphere(p, p + 3, p + 6, p + 9, q) == (off ? 2 : 1),
                "a subnormal point in a ball");
        for (k = 0; k < 12; k++) {
            p[k] = 0;
            if (corner[k] != 0.0) memcpy(p + k, sub, sizeof *sub);
        }
        require(hh_foot(p + 3, p + 6, p + 9, p, NULL) == (off ? 0 : 7) &&
                hh_foot(p + 3, p + 6, p + 9, p, w) == (off ? 0 : 7),
                "what is nearest among subnormal points");
        for (k = 0; k < 12; k++) p[k] = 0;
        p[3] = p[7] = 1;
        q[1] = 0;
        q[2] = -1;
        require(hh_foot(p, p + 3, p + 6, q, NULL) == (off ? 0 : 3) &&
                hh_foot(p, p + 3, p + 6, q, w) == (off ? 0 : 3),
                "a place that is nearly above a vertex");
        memcpy(q + 1, sub, sizeof *sub);
        memcpy(q + 2, sub, sizeof *sub);
        p[11] = 1;
        t = 0;
        for (k = 0; k < 4; k++) w[k] = 7.0;
        k = tess_locate(p, 1, r.tet, r.adj, q, &t, w);
        require(off ? k == TESS_RANGE && w[0] == 0.0 && w[1] == 0.0 &&
                          w[2] == 0.0 && w[3] == 0.0
                    : k == 0, "a subnormal place");
    }
    release(0);
    printf("        subnormal numbers are %s\n", off ? "flushed" : "kept");
    test_result("subnormal coordinates", faults);
}

/* tess_check of a complex that few limbs cannot decide on. */
static void beyond_limbs(const double *p, tess_int n, const tess_int *tet,
                         tess_int ntet, int code, const char *name)
{
    result r;
    int found;

    given(&r, name, p, n, tet, ntet);
    current = &r;
    found = checked(&r);
    require(found == (HH_LIMBS < 88 ? TESS_RANGE : code), name);
    current = NULL;
    release(0);
}

static void test_limbs(void)
{
    static const tess_int one[4] = { 0, 1, 2, 3 };
    static const tess_int across[8] = { 0, 1, 2, 3, 1, 2, 3, 4 };
    static const tess_int beside[8] = { 0, 1, 2, 4, 0, 2, 3, 4 };
    double corner[15] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0 };
    double roof[15] = { 0, -0.5, 0, 2, 0, 0, 0, 0.5, 0, -2, 0, 0, 0, 0, 1 };
    double tiny = ldexp(1.0, sizeof(tess_real) < sizeof(double) ? -120
                                                                : -1010);
    double w[4];
    tess_real q[3];
    tess_int t;
    result r;
    int i, code;

    faults = 0;
    for (i = -1; i <= 1; i += 2) {
        corner[14] = i * tiny;
        /* in the ball of the first four, or below their plane z = 0 */
        beyond_limbs(corner, 5, across, 2,
                     i > 0 ? TESS_BAD_BALL : TESS_BAD_HULL,
                     "a point just inside or outside of a ball");
        roof[11] = i * tiny;
        beyond_limbs(roof, 5, beside, 2, i > 0 ? 0 : TESS_BAD_HULL,
                     "an edge just convex or not");
        given(&r, "a corner", corner, 4, one, 1);
        current = &r;
        q[0] = q[1] = (tess_real)0.25;
        q[2] = (tess_real)(i * tiny);
        t = 0;
        for (code = 0; code < 4; code++) w[code] = 7.0;
        code = tess_locate(r.p, 1, r.tet, r.adj, q, &t, w);
        require(code == (HH_LIMBS < 88 ? TESS_RANGE : i < 0),
                "a place just inside or outside");
        require(HH_LIMBS >= 88 ||
                (w[0] == 0.0 && w[1] == 0.0 && w[2] == 0.0 && w[3] == 0.0),
                "TESS_RANGE, and weights");
        current = NULL;
        release(0);
    }
    /* what is nearest is certain, but not its weights */
    corner[0] = tiny;
    for (i = 0; i < 3; i++) {
        given(&r, "a corner", corner, 4, one, 1);
        current = &r;
        q[0] = (tess_real)(i == 0 ? 0.25 : i == 1 ? -1.0 : 0.5);
        q[1] = (tess_real)(i == 0 ? 0.25 : i == 1 ? 0.5 : -0.5);
        q[2] = (tess_real)-1.0;
        t = 0;
        for (code = 0; code < 4; code++) w[code] = 7.0;
        code = tess_locate(r.p, 1, r.tet, r.adj, q, &t, w);
        require(code == (HH_LIMBS < 88 ? TESS_RANGE : 1),
                "a place outside of a corner");
        for (code = 0; code < 4; code++)
            require(fabs(w[code] - (HH_LIMBS < 88 ? 0.0 :
                         i == 0 ? 0.25 + 0.25 * (code == 0) - 0.25 * (code == 3)
                                : 0.5 * (code == 0) + 0.5 * (code == 3 - i)))
                    <= 4.0 * DBL_EPSILON, "its weights");
        current = NULL;
        release(0);
    }
    corner[0] = 0.0;
    corner[9] = corner[10] = 0.25;
    corner[11] = tiny;
    beyond_limbs(corner, 4, one, 1, 0, "a tetrahedron almost flat");
    beyond_limbs(corner, 4, one, 0, TESS_BAD_POINT, "points almost flat");
    test_result("what few limbs cannot decide", faults);
}

/* A cluster so narrow beside the rest that its block has no list. */
static void test_narrow(void)
{
    static const int width[4] = { -420, -440, -460, -700 };
    double p[3 * 130];
    result r;
    int i, j, e;

    faults = 0;
    if (sizeof(tess_real) < sizeof(double)) return;
    for (j = 0; j < 4; j++) {
        for (i = 0; i < 390; i++) {
            e = i < 300 ? width[j] : 0;
            /* the cluster first in any direction: it has leaves of its own */
            p[i] = ldexp(rnd_unit() + (i < 300 ? -0.5 : 0.5), e);
        }
        given(&r, "a narrow cluster", p, 130, NULL, 0);
        release(1);
        solve(&r);
        right(&r);
        current = NULL;
        release(0);
    }
    test_result("a cluster too narrow for a list", faults);
}

/* A layer so thin that its list takes heights for 0, and the balls are large. */
static void test_thin(void)
{
    static double p[3 * 500];
    result r;
    int i, k, e;

    faults = 0;
    if (sizeof(tess_real) < sizeof(double)) return;
    for (e = 6; e <= 48; e += quick ? 6 : 3) {
        for (i = 0; i < 500; i++) {
            for (k = 0; k < 3; k++) p[3 * i + k] = rnd_unit();
            k = e / 3 % 3;
            p[3 * i + k] = 1.0 + ldexp(p[3 * i + k], -e);
        }
        given(&r, "a thin layer", p, 500, NULL, 0);
        release(1);
        solve(&r);
        right(&r);
        current = NULL;
        release(0);
    }
    test_result("a layer too thin for a list", faults);
}

/* Weights in tetrahedra that are flat to rounding. */
static void test_slivers(void)
{
    result r;
    double p[12], c[3], w[4], x[3], sum;
    const double *v[4], *u[4];
    tess_real q[3];
    tess_int t;
    int set, m, i, k, e, code, side[4], held = 0, hits = 0;

    faults = 0;
    for (set = 0; set < 300; set++) {
        e = set % 3 == 0 ? 0 : rnd_below(1800) - 900;
        if (sizeof(tess_real) < sizeof(double)) e /= 10;
        do {
            c[0] = 2.0 * rnd_unit() - 0.5;
            c[1] = 2.0 * rnd_unit() - 0.5;
            c[2] = 1.0 - c[0] - c[1];
        } while (c[2] < -0.5 || c[2] > 1.5);
        for (i = 0; i < 9; i++) p[i] = ldexp(2.0 * rnd_unit() - 1.0, e);
        for (k = 0; k < 3; k++)
            p[9 + k] = c[0] * p[k] + c[1] * p[3 + k] + c[2] * p[6 + k];
        given(&r, "a sliver", p, 4, NULL, 0);
        release(1);
        current = &r;
        solve(&r);
        require(r.code == TESS_OK || r.code == TESS_PLANE, "a code");
        if (r.code != TESS_OK) {
            release(0);
            continue;
        }
        for (k = 0; k < 4; k++) v[k] = at(&r, r.tet[k]);
        for (m = 0; m < 40; m++) {
            for (i = 0, sum = 0.0; i < 4; i++) sum += w[i] = rnd_unit();
            if (m % 4 == 0) w[m / 4 % 4] *= -1.0;
            if (m % 4 == 1) w[m / 4 % 4] = w[(m / 4 + 1) % 4] = 0.0;
            for (k = 0; k < 3; k++) {
                volatile tess_real rounded =
                    (tess_real)((w[0] * v[0][k] + w[1] * v[1][k] +
                                 w[2] * v[2][k] + w[3] * v[3][k]) / sum);
                q[k] = rounded;
                x[k] = (double)q[k];
            }
            t = TESS_NONE;
            code = tess_locate(r.p, 1, r.tet, r.adj, q, &t, w);
            for (k = 0, held = 1; k < 4; k++) {
                for (i = 0; i < 4; i++) u[i] = i == k ? x : v[i];
                side[k] = ex_orient(u[0], u[1], u[2], u[3]);
                if (side[k] < 0) held = 0;
            }
            require(t == 0 && code == !held, "in a sliver or not");
            hits += held;
            if (!held) {
                if (code == 1) verify_outside(&r, 0, x, w);
                continue;
            }
            verify_weights(&r, 0, x, w, side);
        }
        current = NULL;
        release(0);
    }
    printf("        %d places inside\n", hits);
    require(hits > 100, "places inside of slivers");
    test_result("weights in slivers", faults);
}

static void test_check_arguments(void)
{
    result r;
    tess_int iw[100], bad = -7;
    tess_real held;
    int i;

    faults = 0;
    current = NULL;
    points(&r, "uniform", 40, 2);
    solve(&r);
    current = &r;
    require(tess_check(-1, r.p, r.ntet, r.tet, r.adj, 100, iw, &bad) == -1,
            "tess_check with n < 0");
    require(tess_check(largest() / 3 + 1, r.p, r.ntet, r.tet, r.adj, 100, iw,
                       &bad) == -1, "tess_check with n too large");
    require(tess_check(r.n, r.p, (largest() - 3) / 4 + 1, r.tet, r.adj, 100,
                       iw, &bad) == -3, "tess_check with ntet too large");
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, r.n - 1, iw, &bad) ==
            -6, "tess_check with liw < n");
    require(tess_check(r.n, r.p, -1, r.tet, r.adj, 100, iw, &bad) == -3,
            "tess_check with ntet < 0");
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 79, iw, &bad) == -6,
            "tess_check with liw too small");
    for (i = 0; i < 120; i++) {
        held = r.p[i];
        r.p[i] = (tess_real)(i % 2 ? infinity() : infinity() - infinity());
        require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 80, iw, &bad) ==
                -2, "tess_check with NaN or infinity");
        r.p[i] = held;
    }
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 80, iw, &bad) == 0 &&
            bad == TESS_NONE, "tess_check");
    current = NULL;
    release(0);
    test_result("bad arguments of tess_check", faults);
}

/* ---- checksums ---- */

static unsigned long add(unsigned long sum, unsigned long value)
{
    int k;

    for (k = 0; k < 4; k++, value >>= 8)
        sum = ((sum ^ (value & 255UL)) * 16777619UL) & 0xffffffffUL;
    return sum;
}

static void sums(long n)
{
    const char *family;
    result r;
    unsigned long sum;
    tess_int t;
    int i, k;

    for (i = 0; (family = points_name(i)) != NULL; i++)
        for (k = 1; k <= 2; k++) {
            /* the number asked for, and a sixteenth of it */
            long m = affordable(family, k == 1 ? n : n / 16 + 8);

            if (!points(&r, family, m, (unsigned long)k)) continue;
            /* room for the quadratic ones, of which there are few points */
            room(&r, 64 * r.n);
            r.liw *= 4;
            r.iw = ints(r.liw);
            run(&r);
            sum = 2166136261UL;
            for (t = 0; t < 4 * r.ntet; t++) {
                sum = add(sum, (unsigned long)r.tet[t]);
                sum = add(sum, (unsigned long)r.adj[t] & 0xffffffffUL);
            }
            printf("%-12s n %6ld code %d ntet %7ld sum %08lx\n", family,
                   (long)r.n, r.code, (long)r.ntet, sum);
            release(0);
        }
}

int main(int argc, char **argv)
{
    static const char usage[] =
        "[-quick | -sums [n] | -range | -one family n seed]";

    if ((argc == 2 || argc == 3) && strcmp(argv[1], "-sums") == 0) {
        sums(argc == 3 ? test_number(argv[2], 1, argv, usage) : 1000);
        return faults > 0;
    }
    if (argc == 2 && strcmp(argv[1], "-range") == 0) {
        test_range();
        test_limbs();
        return test_end("t_tess");
    }
    if (argc == 5 && strcmp(argv[1], "-one") == 0) {
        one_family(argv[2], test_number(argv[3], 1, argv, usage),
                   (unsigned long)test_number(argv[4], 0, argv, usage));
        test_result(argv[2], faults);
        return test_end("t_tess");
    }
    quick = argc == 2 && strcmp(argv[1], "-quick") == 0;
    if (argc > 1 + quick) test_usage(argv[0], usage);
    rnd_seed(1);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    test_flat();
    test_bad_arguments();
    test_size();
    test_hull();
    test_families();
    test_workspace();
    test_room();
    test_resume();
    test_pool();
    test_damage();
    test_chance();
    test_check_arguments();
    test_faults();
    test_mutations();
    test_locate();
    test_values();
    test_lost();
    test_slivers();
    test_narrow();
    test_thin();
    test_limbs();
    test_subnormal();
    return test_end("t_tess");
}
