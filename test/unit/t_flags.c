/* t_flags.c - floating-point flags, errno and traps.
 *
 *     t_flags
 *
 * Covered, for each routine of tess.h and hhpred.h:
 *   flags    on ordinary data, every family of coordinates of ordinary size, as
 *            it is and moved, and flat sets, no call sets a flag but inexact,
 *            nor errno
 *   traps    with invalid, divide-by-zero and overflow trapped each call runs
 *            through: on the same data; on hard data, from subnormal numbers to
 *            the largest; with bad arguments, NaNs and infinities; on damaged
 *            arrays
 *
 * Needs fenv.h and, for traps, glibc: -DTEST_FLAGS says that they are there.
 */
#ifdef TEST_FLAGS
#define _GNU_SOURCE
#include <fenv.h>
#include <setjmp.h>
#include <signal.h>
#endif
#include "../../tess.h"
#include "../proof/exact.h"
#include "../points.h"
#include "damage.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef TEST_FLAGS

static const char *const names[] = {
    "tess_size", "tess", "tess_resume", "tess_locate", "tess_values",
    "tess_hull", "tess_check", "tess_index", "tess_query", "tess_part",
    "tess_ball", "tess_edition", "hh_facet", "hh_side", "hh_opp", "hh_lcoord",
    "hh_wrap", "hh_orient", "hh_insphere"
};
enum routine {
    SIZE, MESH, RESUME, LOCATE, VALUES, HULL, CHECK, INDEX, QUERY, PART, BALL,
    EDITION, FACET, SIDE, OPP, LCOORD, WRAP, ORIENT, INSPHERE, ROUTINES
};

#define FLAGS (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW | FE_UNDERFLOW)
#define TRAPS (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW)
#define SHOWN 6
#ifdef TESS_FLOAT
#define REAL_MOST FLT_MAX
#define REAL_LEAST 1.401298464324817e-45
#else
#define REAL_MOST DBL_MAX
#define REAL_LEAST 4.940656458412465e-324
#endif

static long faults[ROUTINES];
static int trapped; /* traps, not flags */
static volatile int current;
static char now[200];
static sigjmp_buf back;

static void wrong(const char *what)
{
    if (faults[current]++ < SHOWN)
        printf("%s: %s (%s)\n", names[current], what, now);
}

static void before(int routine)
{
    current = routine;
    feclearexcept(FE_ALL_EXCEPT);
    errno = 0;
    if (trapped) feenableexcept(TRAPS);
}

static void after(void)
{
    int set = fetestexcept(FLAGS), number = errno;

    if (trapped) {
        fedisableexcept(TRAPS);
        return;
    }
    if (set & FE_INVALID) wrong("invalid");
    if (set & FE_DIVBYZERO) wrong("divide-by-zero");
    if (set & FE_OVERFLOW) wrong("overflow");
    if (set & FE_UNDERFLOW) wrong("underflow");
    if (number == EDOM) wrong("errno is EDOM");
    else if (number == ERANGE) wrong("errno is ERANGE");
    else if (number != 0) wrong("errno is set");
}

/* (What a trapped call leaves is anything.) */
#define CALL(routine, call)            \
    do {                               \
        before(routine);               \
        if (sigsetjmp(back, 1) == 0) { \
            (void)(call);              \
            after();                   \
        } else {                       \
            fedisableexcept(TRAPS);    \
            wrong("a trap");           \
        }                              \
    } while (0)

static void trap(int number)
{
    (void)number;
    siglongjmp(back, 1);
}

/* ---- a set of points, and all that is called for it ---- */

#define MOST 900
#define FEW 90
#define MAXTET (16 * MOST)
#define LIW (40 * MOST + 4000)
#define LRW (8 * MOST + 1000)
#define ASKED 30

static tess_int n;
static double x[3 * MOST];
static tess_real p[3 * MOST];
static tess_int ntet, tet[4 * MAXTET], adj[4 * MAXTET], iw[LIW];
static double rw[LRW];

/* a place: of a point, of the middle of an edge or a tetrahedron, anywhere in
 * the box or about it */
static void place(int kind, tess_real *q)
{
    tess_int i = rnd_below((int)n), j = rnd_below((int)n), m[4];
    double least, most, u;
    int k;

    for (k = 0; k < 4; k++)
        m[k] = ntet > 0 ? tet[4 * rnd_below((int)ntet) + k] : i;
    for (k = 0; k < 3; k++) {
        u = rnd_unit();
        switch (kind % 6) {
        case 0:
            q[k] = p[3 * i + k];
            break;
        case 1:
            q[k] = (tess_real)(0.5 * p[3 * i + k] + 0.5 * p[3 * j + k]);
            break;
        case 2:
            q[k] = (tess_real)(0.25 * p[3 * m[0] + k] + 0.25 * p[3 * m[1] + k] +
                               0.25 * p[3 * m[2] + k] + 0.25 * p[3 * m[3] + k]);
            break;
        default:
            least = most = p[k];
            for (i = 1; i < n; i++) {
                if (p[3 * i + k] < least) least = p[3 * i + k];
                if (p[3 * i + k] > most) most = p[3 * i + k];
            }
            if (kind % 6 == 5) u = 3.0 * u - 1.0;
            u = (1.0 - u) * least + u * most;
            q[k] = (tess_real)(u > REAL_MOST ? REAL_MOST : u < -REAL_MOST ? -REAL_MOST : u);
            break;
        }
    }
}

/* rounded: those too whose results are rounded, and may overflow where the
 * coordinates are about the largest or the points all but in a plane */
static void predicates(int rounded)
{
    static const tess_real *a, *b, *c, *d, *e;
    static double f[HH_FACET_LEN], l;
    static int i;

    for (i = 0; i < 30 && n > 0; i++) {
        a = p + 3 * rnd_below((int)n);
        b = p + 3 * rnd_below((int)n);
        c = p + 3 * rnd_below((int)n);
        d = p + 3 * rnd_below((int)n);
        e = p + 3 * rnd_below((int)n);
        CALL(ORIENT, hh_orient(a, b, c, d));
        CALL(INSPHERE, hh_insphere(a, b, c, d, e));
        if (!rounded) continue;
        CALL(FACET, hh_facet(a, b, c, f));
        CALL(SIDE, hh_side(f, d));
        CALL(OPP, hh_opp(f, d, e));
        CALL(LCOORD, hh_lcoord(f, d));
        CALL(WRAP, hh_wrap(a, b, c, d, &l));
    }
}

static void calls(int rounded)
{
    static tess_int fac[3 * 4 * MAXTET], mine[MOST], t[ASKED], copy[LIW];
    static tess_real q[3 * ASKED];
    static double value[2 * MOST], out[2 * ASKED], w[4], c[4];
    static tess_int liw, lrw, nfac, bad, at, v[4];
    static int i, code;

    liw = lrw = ntet = 0;
    code = -1;
    CALL(EDITION, tess_edition());
    CALL(SIZE, tess_size(n, MAXTET, &liw, &lrw));
    CALL(MESH, code = tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw));
    CALL(CHECK, tess_check(n, p, ntet, tet, adj, 2 * n, iw, &bad));
    predicates(rounded);
    if (code == TESS_OK) {
        for (i = 0; i < ASKED; i++) {
            place(i, q + 3 * i);
            at = i % 2 ? TESS_NONE : rnd_below((int)ntet);
            CALL(LOCATE, tess_locate(p, ntet, tet, adj, q + 3 * i, &at, w));
            t[i] = TESS_NONE;
            CALL(BALL, tess_ball(p, tet + 4 * rnd_below((int)ntet), c));
        }
        for (i = 0; i < 2 * n; i++) value[i] = i % 13;
        CALL(VALUES, tess_values(p, ntet, tet, adj, 2, value, ASKED, q, t, out));
        CALL(HULL, tess_hull(ntet, tet, adj, 4 * MAXTET, &nfac, fac));
        /* from half of it */
        at = ntet / 2;
        CALL(MESH, tess(n, p, at, &ntet, tet, adj, liw, iw, lrw, rw));
        CALL(RESUME, tess_resume(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw));
    }
    /* with all planes and spheres, and without; likewise cylinders */
    for (at = 0; at < 1 + (n <= FEW); at++) {
        if (at) liw = 2 * n + n / 12 + 7;
        if (at) lrw = 3 * n + n / 2 + 12;
        code = -1;
        CALL(INDEX, code = tess_index(n, p, liw, iw, lrw, rw));
        if (n == 0 || code < 0) continue;
        v[0] = TESS_NONE;
        for (i = 0; i < ASKED / (at ? 4 : 1); i++) {
            place(i, q);
            if (i % 3 == 0) v[0] = TESS_NONE;
            CALL(QUERY, tess_query(n, p, iw, rw, q, v, w));
        }
        if (at) continue;
        memcpy(copy, iw, sizeof copy);
        memset(mine, 0, sizeof mine);
        for (i = 0; i < n; i++) mine[i] = rnd_below(4) == 0;
        ntet = 0;
        CALL(PART, tess_part(n, p, mine, MAXTET, &ntet, tet, adj, LIW, copy,
                             lrw, rw));
    }
}

/* ---- the sets ---- */

static void round_off(long many)
{
    tess_int i;

    n = (tess_int)many;
    for (i = 0; i < 3 * n; i++) p[i] = (tess_real)x[i];
}


static int ordinary(const char *family)
{
    static const char *const not_so[] = { "tiny", "huge", "wide" };
    size_t i;

    for (i = 0; i < sizeof not_so / sizeof not_so[0]; i++)
        if (strcmp(family, not_so[i]) == 0) return 0;
    return 1;
}

static void family(const char *name, long many, int rounded)
{
    sprintf(now, "%s %ld", name, many);
    round_off(points_make(name, many, 1, x));
    rnd_seed(7);
    if (n > 0) calls(rounded);
}

static void families(int which)
{
    const char *name;
    int i;

    for (i = 0; (name = points_name(i)) != NULL; i++)
        if (ordinary(name) == which) {
            int wide = strcmp(name, "wide") == 0;

            family(name, wide ? 20 : FEW, !wide);
        }
}

/* flat and small sets */
static void flat(void)
{
    tess_int m;
    int kind, i, k;

    for (kind = 0; kind < 4; kind++)
        for (m = 0; m < 60; m += m < 9 ? 1 : 25) {
            sprintf(now, "%d points, kind %d", (int)m, kind);
            n = m;
            for (i = 0; i < m; i++)
                for (k = 0; k < 3; k++)
                    p[3 * i + k] = (tess_real)(kind == 0 ? 0.1 : kind == 1 ? 0.1 * i
                        : kind == 2 ? (k == 2 ? 3.0 : 0.1 * (i * (k + 2) % 7))
                        : 0.37 * i + 0.7 * (k + 1) * (i * i % 11));
            calls(1);
        }
}

static void ordinary_data(void)
{
    /* enough for planes, spheres and cylinders */
    static const char *const large[] = {
        "uniform", "rotcube", "globe", "uvsphere", "gridrot", "tilted15",
        "near8", "cubesurf", "spherefull", "pipes", "sheets",
        "test/data/mirror.xyz"
    };
    size_t i;

    families(1);
    flat();
    for (i = 0; i < sizeof large / sizeof large[0]; i++) family(large[i], MOST, 1);
}

/* ---- hard data ---- */

static tess_real number(int kind)
{
    static const int exponents[] = { -1074, -1060, -1022, -1021, -980, -700, -500,
        -450, -300, -60, 0, 60, 300, 450, 500, 700, 980, 1022, 1023 };
    double u = rnd_unit() * 2.0 - 1.0;
    int many = (int)(sizeof exponents / sizeof exponents[0]);

    switch (kind) {
    case 0: /* any exponents */
        u = ldexp(u, exponents[rnd_below(many)]);
        break;
    case 1: /* fill values */
        if (rnd_below(3) == 0) u = -REAL_MOST;
        break;
    case 2:
        if (rnd_below(3) == 0) u = rnd_below(2) ? -3.4028235e38 : -1e20;
        break;
    case 3: /* the largest */
        u = rnd_below(3) == 0 ? u * REAL_MOST : rnd_below(2) ? REAL_MOST : -REAL_MOST;
        break;
    case 4: /* the least */
        u = rnd_below(9) * REAL_LEAST;
        break;
    case 5:
        u = ldexp((double)rnd_below(3), 500) + (rnd_below(3) - 1) * 1e-200;
        break;
    case 6:
        u = rnd_below(4) ? ldexp((double)rnd_below(3), 1000) : ldexp(1.0, -100);
        break;
    case 7:
        u = 1.0 + rnd_below(3) * DBL_EPSILON + (rnd_below(2) ? 0.0 : 1e-300);
        break;
    case 8:
        u = ldexp(u, rnd_below(2000) - 1000);
        break;
    default:
        u = rnd_below(2) ? ldexp(u, 511) : ldexp(u, -540);
        break;
    }
    return (tess_real)(u > REAL_MOST ? REAL_MOST : u < -REAL_MOST ? -REAL_MOST : u);
}
#define KINDS 10

static void hard_data(void)
{
    int kind, i, k;

    families(0);
    for (kind = 0; kind < KINDS; kind++)
        for (k = 0; k < 6; k++) {
            sprintf(now, "hard, kind %d, set %d", kind, k);
            rnd_seed((unsigned long)(100 * kind + k));
            n = 4 + 2 * k;
            for (i = 0; i < 3 * n; i++)
                p[i] = k < 3 || i % 3 == 2 ? number(kind) : (tess_real)rnd_unit();
            calls(0);
        }
}

/* ---- bad arguments ---- */

static void one_bad(tess_real *at, tess_real what)
{
    static tess_int bad, many, v[4];
    static double c[4];
    tess_real kept = *at;
    int k;

    many = ntet;
    *at = what;
    CALL(CHECK, tess_check(n, p, many, tet, adj, 2 * n, iw, &bad));
    CALL(INDEX, tess_index(n, p, LIW, iw, LRW, rw));
    CALL(MESH, tess(n, p, MAXTET, &bad, tet, adj, LIW, iw, LRW, rw));
    CALL(RESUME, tess_resume(n, p, MAXTET, &many, tet, adj, LIW, iw, LRW, rw));
    for (k = 0; k < 4; k++) v[k] = k;
    CALL(BALL, tess_ball(p, v, c));
    *at = kept;
}

static void bad_arguments(void)
{
    static const tess_int lengths[] = { -1, 0, 1, 7, 100, 1600, TESS_INT_MOST };
    static double value[MOST], w[4], out[4];
    static tess_int copy[LIW], mine[MOST];
    /* made by no operation that sets a flag */
    double zero = 0.0, infinite = HUGE_VAL, none = infinite * zero;
    static tess_real odd[3], q[3];
    static tess_int liw, lrw, many, t, v[4], fac[3], nfac, bad;
    static int i, j, k;

    odd[0] = (tess_real)none;
    odd[1] = (tess_real)infinite;
    odd[2] = (tess_real)-infinite;
    many = 0;
    tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
    for (i = 0; i < 3; i++)
        for (j = 0; j < 4; j++)
            one_bad(p + (j < 3 ? j : 3 * (int)n - 1), odd[i]);
    for (i = 0; i < (int)(sizeof lengths / sizeof lengths[0]); i++) {
        t = lengths[i];
        CALL(SIZE, tess_size(t, MAXTET, &liw, &lrw));
        CALL(SIZE, tess_size(n, t, &liw, &lrw));
        if (t < MAXTET)
            CALL(MESH, tess(n, p, t, &many, tet, adj, LIW, iw, LRW, rw));
        if (t < LIW)
            CALL(MESH, tess(n, p, MAXTET, &many, tet, adj, t, iw, LRW, rw));
        if (t < LRW)
            CALL(MESH, tess(n, p, MAXTET, &many, tet, adj, LIW, iw, t, rw));
        if (t < LIW) CALL(INDEX, tess_index(n, p, t, iw, LRW, rw));
        if (t < LRW) CALL(INDEX, tess_index(n, p, LIW, iw, t, rw));
    }
    tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            for (j = 0; j < 3; j++) q[j] = p[j];
            q[k] = odd[i];
            t = TESS_NONE;
            CALL(LOCATE, tess_locate(p, ntet, tet, adj, q, &t, w));
            CALL(VALUES, tess_values(p, ntet, tet, adj, 1, value, 1, q, &t, out));
        }
    for (j = 0; j < 3; j++) q[j] = p[j];
    t = ntet;
    CALL(LOCATE, tess_locate(p, ntet, tet, adj, q, &t, w));
    CALL(LOCATE, tess_locate(p, 0, tet, adj, q, &t, w));
    CALL(VALUES, tess_values(p, ntet, tet, adj, -1, value, 1, q, &t, out));
    CALL(VALUES, tess_values(p, ntet, tet, adj, 1, value, -1, q, &t, out));
    CALL(VALUES, tess_values(p, ntet, tet, adj, 1, value, 1, q, &t, out));
    CALL(HULL, tess_hull(-1, tet, adj, 1, &nfac, fac));
    CALL(HULL, tess_hull(ntet, tet, adj, -1, &nfac, fac));
    CALL(HULL, tess_hull(ntet, tet, adj, 1, &nfac, fac));
    CALL(CHECK, tess_check(n, p, ntet, tet, adj, 0, iw, &bad));
    for (i = 0; i < 4; i++) v[i] = i == 2 ? -1 : i;
    CALL(BALL, tess_ball(p, v, w));
    /* an index, and what is none: nothing, noise, an index of other points */
    for (i = 0; i < 4; i++) {
        if (i < 2) {
            tess_index(n, p, LIW, iw, LRW, rw);
            if (i == 1) for (k = 0; k < 3 * n; k += 5) p[k] = odd[k % 3];
        } else {
            for (k = 0; k < LIW; k++) iw[k] = i == 2 ? 0 : (tess_int)rnd_below(90);
            for (k = 0; k < LRW; k++) rw[k] = i == 2 ? 0.0 : (double)odd[k % 3];
        }
        for (j = 0; j < 6; j++) {
            for (k = 0; k < 3; k++) q[k] = (tess_real)rnd_unit();
            if (j < 3) q[j] = odd[i % 3];
            if (i == 1 && j >= 3) break; /* (points that have changed) */
            for (k = 0; k < 4; k++) v[k] = j == 3 ? -1 : rnd_below((int)n + 2);
            CALL(QUERY, tess_query(n, p, iw, rw, q, v, w));
        }
        if (i == 1) {
            rnd_seed(7);
            round_off(points_make("uniform", FEW, 1, x));
            continue;
        }
        for (k = 0; k < n; k++) mine[k] = k % 5 == 0;
        memcpy(copy, iw, sizeof copy);
        many = 0;
        CALL(PART, tess_part(n, p, mine, MAXTET, &many, tet, adj, LIW, copy, LRW, rw));
        many = 0;
        CALL(PART, tess_part(n, p, mine, MAXTET, &many, tet, adj, 7, copy, LRW, rw));
        CALL(PART, tess_part(n, p, mine, -1, &many, tet, adj, LIW, copy, LRW, rw));
        many = -1;
        CALL(PART, tess_part(n, p, mine, MAXTET, &many, tet, adj, LIW, copy, LRW, rw));
    }
}

/* numbers of a result changed by chance */
static void damaged(void)
{
    static tess_int kept[LIW];

    tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
    memcpy(kept, iw, sizeof kept);
    CALL(RESUME, damage(n, p, ntet, tet, adj, kept, rnd_below));
}

static void bad_data(void)
{
    int i;

    sprintf(now, "bad arguments");
    round_off(points_make("uniform", FEW, 1, x));
    bad_arguments();
    for (i = 0; i < 30; i++) {
        sprintf(now, "damaged arrays %d", i);
        round_off(points_make(i % 2 ? "lattice" : "uniform", 30, 1 + (unsigned long)i, x));
        rnd_seed((unsigned long)i);
        damaged();
    }
}

static void results(const char *what)
{
    int i;

    for (i = 0; i < ROUTINES; i++) {
        sprintf(now, "%s: %s", what, names[i]);
        test_result(now, faults[i]);
        faults[i] = 0;
    }
}

int main(int argc, char **argv)
{
    if (argc > 1) test_usage(argv[0], "");
    ordinary_data();
    results("no flag");
    if (signal(SIGFPE, trap) == SIG_ERR) return 1;
    if (feenableexcept(FE_DIVBYZERO) == -1) {
        printf("        skipped: this processor does not trap\n");
        return test_end("t_flags");
    }
    fedisableexcept(TRAPS);
    trapped = 1;
    hard_data();
    results("traps, hard data");
    bad_data();
    results("traps, bad arguments");
    return test_end("t_flags");
}

#else

int main(int argc, char **argv)
{
    if (argc > 1) test_usage(argv[0], "");
    printf("        skipped: no fenv.h\n");
    return test_end("t_flags");
}

#endif
