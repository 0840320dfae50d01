/* t_tess.c - tests of tess, tess_size and tess_hull on all families of points.c.
 *
 *     t_tess                    all tests
 *     t_tess -quick             fewer and smaller ones, for slow builds
 *     t_tess -brief             still smaller ones, for make check
 *     t_tess -sums [n]          a checksum of each family's result, to compare
 *                               builds with each other
 *     t_tess -one family n seed verify one set
 *
 * Covered:
 *   families   every family: codes, exact array lengths, guards around all
 *              arrays, points not altered, tess_check, verify.h; and numbers
 *              of tetrahedra that theory gives
 *   codes      what each routine returns and sets for bad and special input
 * A failure names its family, n and seed.
 */
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- families ---- */

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
    long n = quick > 1 ? 100 : quick ? 300 : 600, few = quick ? 300 : 600;
    long total;
    int i;

    for (i = 0; (family = points_name(i)) != NULL; i++) {
        faults = 0;
        one_family(family, affordable(family, n), 1);
        one_family(family, affordable(family, few) / 8 + 8, 2);
        done("family", family);
    }
    if (quick) return;
    /* larger ones, checked by tess_check alone */
    total = 0;
    for (i = 0; (family = points_name(i)) != NULL; i++) {
        result r;

        faults = 0;
        n = affordable(family, 6000);
        if (n < 1500) continue;
        current = &r;
        if (points(&r, family, n, 3)) {
            int keep = narrays;

            /* (that stopped and exact arrays give the same is seen above) */
            room(&r, 20 * r.n);
            run(&r);
            if (r.code == TESS_MORE || r.code == TESS_POOL) {
                release(keep);
                solve(&r);
            }
            require(r.code == TESS_OK, "a code");
            require(overrun() == 0, "an array is overrun");
            if (r.code == TESS_OK) {
                require(checked(&r) == 0, "tess_check");
                known(&r);
            }
        }
        current = NULL;
        release(0);
        total += faults;
    }
    test_result("families, up to 6000 points", total);
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
        printf("#     code %d instead of %d, ntet %ld\n", r.code, code,
               (long)r.ntet);
    require(untouched(r.iw, (size_t)liw * sizeof(tess_int)) &&
            untouched(r.rw, (size_t)lrw * sizeof(double)) &&
            overrun() == 0, what);
    release(keep);
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
    for (i = 0; i < 4 * good.ntet; i += quick ? 7 : 1)
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
            printf("#     code %d instead of %d\n", r.code, code);
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
        "[-quick | -brief | -sums [n] | -one family n seed]";

    if ((argc == 2 || argc == 3) && strcmp(argv[1], "-sums") == 0) {
        sums(argc == 3 ? test_number(argv[2], 1, argv, usage) : 1000);
        return faults > 0;
    }
    if (argc == 5 && strcmp(argv[1], "-one") == 0) {
        one_family(argv[2], test_number(argv[3], 1, argv, usage),
                   (unsigned long)test_number(argv[4], 0, argv, usage));
        test_result(argv[2], faults);
        return test_end();
    }
    if (argc == 2 && strcmp(argv[1], "-quick") == 0) quick = 1;
    else if (argc == 2 && strcmp(argv[1], "-brief") == 0) quick = 2;
    else if (argc > 1) test_usage(argv[0], usage);
    rnd_seed(1);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    test_flat();
    test_bad_arguments();
    test_size();
    test_hull();
    test_families();
    return test_end();
}
