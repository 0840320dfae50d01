/* t_resume.c - tests of workspaces of any length, and of tess_resume.
 *
 *     t_resume          all tests
 *     t_resume -quick   fewer and smaller ones, for slow builds
 *     t_resume -brief   still fewer, for make check
 *
 * Covered:
 *   workspace  the least lengths, and others, give the same arrays or
 *              TESS_POOL and a beginning of them that resumes
 *   resume     stopped at every tetrahedron, in one step or in many
 *   pool       what tess_size recommends suffices
 *   damage     tess_resume refuses arrays that no call has made, and writes
 *              nothing
 */
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/damage.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- workspace ---- */

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
        printf("# least liw %ld = %.2f n, lrw %ld = %.2f n\n",
               (long)liw, (double)liw / (double)whole.n, (long)lrw,
               (double)lrw / (double)whole.n);
        require(liw <= whole.liw && lrw <= whole.lrw,
                "tess_size is below the least lengths");
        step = (whole.liw - liw) / 9 + 1;
        for (; liw < whole.liw + 3 * step; liw += step)
            other_lengths(&whole, liw, liw % 2 ? lrw : whole.lrw + 7, &pools);
        printf("# pool full in %d of the runs\n", pools);
        /* its pool grows with n^2 */
        if (strcmp(family[i], "moment") == 0)
            require(pools > 0, "no run with a full pool");
        current = NULL;
        release(0);
        done("workspace of any length", family[i]);
    }
}

/* Between the least lengths and the recommended ones, for points so many that
 * there is room for marks of surfaces (in iw) and for cylinders (in rw). */
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
    size_t i, j, sets = sizeof set / sizeof set[0];
    int pools;

    if (quick) sets = quick > 1 ? 2 : sets - 1;
    for (i = 0; i < sets; i++) {
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
        printf("# %d times TESS_POOL\n", tries);
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
    if (r.code != code) printf("#     code %d instead of %d\n", r.code, code);
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

int main(int argc, char **argv)
{
    quick = test_quick(argc, argv);
    rnd_seed(1);
    test_workspace();
    test_room();
    test_resume();
    test_pool();
    test_damage();
    test_chance();
    return test_end();
}
