/* t_range.c - tests of where the arithmetic, or the limbs, do not suffice:
 * TESS_RANGE, and only there.  With few limbs (-DHH_LIMBS=3) what they hold is
 * right all the same; with all of them sets that need them.
 *
 *     t_range [-quick | -brief]
 *
 * With -mfpmath=387 -DTEST_X87 of where a processor's unit has not the precision
 * of a double, alone.
 */
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where hh_fits says that the limbs hold all coordinates the result is
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
                if (!hh_fits((double)r.p[j], most)) fits = 0;
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
    printf("# in range %d, out of it %d\n", held, out);
    faults = 0;
    require(HH_LIMBS < 88 ? held > 9 && out > 1 : out == 0,
            "families in and out of range");
    test_result("range", faults);
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
    int i, k, off = test_flushes();

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
        require(off ? !hh_held(p + 3) && !hh_held(p + 6) && !hh_held(p + 9)
                    : hh_foot(p + 3, p + 6, p + 9, p, NULL) == 7 &&
                          hh_foot(p + 3, p + 6, p + 9, p, w) == 7,
                "what is nearest among subnormal points");
        for (k = 0; k < 12; k++) p[k] = 0;
        p[3] = p[7] = 1;
        q[1] = 0;
        q[2] = -1;
        require(off ? !hh_held(q)
                    : hh_foot(p, p + 3, p + 6, q, NULL) == 3 &&
                          hh_foot(p, p + 3, p + 6, q, w) == 3,
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
    printf("# subnormal numbers are %s\n", off ? "flushed" : "kept");
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
    for (j = 0; j < 4; j += quick > 1 ? 3 : 1) {
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

#ifdef TEST_X87
/* Set the precision of the x87 unit: 0 of 24 bits, 2 of 53, 3 of 64. */
static void unit_to(unsigned precision)
{
    unsigned short word;

    __asm__ __volatile__("fnstcw %0" : "=m"(word));
    word = (unsigned short)((word & ~0x300u) | precision << 8);
    __asm__ __volatile__("fldcw %0" : : "m"(word));
}

/* A unit that rounds to less than a double: nothing is known, and said so. */
static void test_short_unit(void)
{
    static const tess_real p[15] = {
        0, 0, 0, 8, 0, 0, 0, 8, 0, 2, 2, 1, 2, 2, 3
    };
    tess_int t = TESS_NONE, iw[10], bad;
    double w[4];
    result r;

    faults = 0;
    points(&r, "uniform", 20, 3);
    solve(&r);
    current = &r;
    unit_to(2);
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, r.liw, r.iw, &bad) == 0,
            "53 bits suffice");
    unit_to(0);
    require(tess_check(5, p, 0, r.tet, r.adj, 10, iw, &bad) == TESS_RANGE,
            "tess_check, 24 bits");
    require(tess_locate(r.p, r.ntet, r.tet, r.adj, p, &t, w) == TESS_RANGE,
            "tess_locate, 24 bits");
    require(hh_orient(p, p + 3, p + 6, p + 9) == 2, "hh_orient, 24 bits");
    require(hh_insphere(p, p + 3, p + 6, p + 9, p + 12) == 2,
            "hh_insphere, 24 bits");
    require(hh_holds(4, p) == 0, "hh_holds, 24 bits");
    unit_to(3);
    room(&r, 100);
    unit_to(0);
    run(&r);
    require(r.code == TESS_RANGE && r.ntet == 0, "tess, 24 bits");
    unit_to(3);
    require(untouched(r.tet, 400 * sizeof(tess_int)), "tet is written");
    current = NULL;
    release(0);
    test_result("an x87 unit of 24 bits", faults);
}
#endif

int main(int argc, char **argv)
{
    quick = test_quick(argc, argv);
    rnd_seed(1);
#ifdef TEST_X87
    test_short_unit();
    return test_end();
#endif
#if HH_LIMBS < 88
    test_range();
#else
    test_narrow();
    test_thin();
    test_subnormal();
#endif
    test_limbs();
    return test_end();
}
