/* t_flags.c - floating-point flags, errno, traps and rounding modes.
 *
 *     t_flags          all tests
 *     t_flags -quick   fewer sets
 *     t_flags -brief   still fewer, for make check
 *
 * Covered, for each routine of tess.h and hhpred.h, in four rounding modes:
 *   ordinary  on ordinary data, every family of coordinates of ordinary size,
 *             as it is and moved, and flat sets, no call sets a flag but
 *             inexact, nor errno
 *   edges     on zeros, subnormal numbers, the largest, infinities and NaNs,
 *             one in each place, and several by chance, beside ordinary
 *             numbers: each call ends with a code or the result that the
 *             header states, and does not set invalid, divide-by-zero or
 *             overflow, unless the header says so
 *   hunt      nor on hard sets and families, drawn by chance
 *   bad       nor with bad arguments and on damaged arrays
 *   modes     what a rounding mode does not alter
 *   traps     with the three trapped each call runs through: edges, hard data,
 *             bad arguments, damaged arrays
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
#include "../lib/hard.h"
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/damage.h"

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

static const int modes[] = {
    FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO
};
static const char *const mode_names[] = {
    "to nearest", "upward", "downward", "toward zero"
};
static int mode;    /* of these, that of the calls */
static int watched; /* the flags that no call may set; errno with underflow */
static int raised;  /* the flags that the last call set */
static int trapped; /* traps, not flags */

static long faults[ROUTINES];
static volatile int current;
static char now[200];
static sigjmp_buf back;

static void wrong(const char *what)
{
    if (faults[current]++ < SHOWN)
        printf("# %s: %s (%s, %s)\n", names[current], what, now,
               mode_names[mode]);
}

static void expect(int routine, int good, const char *what)
{
    current = routine;
    if (!good) wrong(what);
}

static void before(int routine)
{
    current = routine;
    feclearexcept(FE_ALL_EXCEPT);
    errno = 0;
    if (trapped) feenableexcept(TRAPS);
    fesetround(modes[mode]);
}

static void after(void)
{
    int number = errno;

    raised = fetestexcept(FLAGS);
    fesetround(FE_TONEAREST);
    if (trapped) fedisableexcept(TRAPS);
    if (raised & watched & FE_INVALID) wrong("invalid");
    if (raised & watched & FE_DIVBYZERO) wrong("divide-by-zero");
    if (raised & watched & FE_OVERFLOW) wrong("overflow");
    if (raised & watched & FE_UNDERFLOW) wrong("underflow");
    if (!(watched & FE_UNDERFLOW)) return;
    if (number == EDOM) wrong("errno is EDOM");
    else if (number == ERANGE) wrong("errno is ERANGE");
    else if (number != 0) wrong("errno is set");
}

static void stopped(void)
{
    fedisableexcept(TRAPS);
    fesetround(FE_TONEAREST);
    wrong("a trap");
}

/* (What a trapped call leaves is anything.) */
#define CALL(routine, call)              \
    do {                                 \
        before(routine);                 \
        if (!trapped) {                  \
            (void)(call);                \
            after();                     \
        } else if (sigsetjmp(back, 1)) { \
            stopped();                   \
        } else {                         \
            (void)(call);                \
            after();                     \
        }                                \
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

static int asked = ASKED; /* so many places of each set */
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
        for (i = 0; i < asked; i++) {
            place(i, q + 3 * i);
            at = i % 2 ? TESS_NONE : rnd_below((int)ntet);
            CALL(LOCATE, tess_locate(p, ntet, tet, adj, q + 3 * i, &at, w));
            t[i] = TESS_NONE;
            CALL(BALL, tess_ball(p, tet + 4 * rnd_below((int)ntet), c));
        }
        for (i = 0; i < 2 * n; i++) value[i] = i % 13;
        CALL(VALUES, tess_values(p, ntet, tet, adj, 2, value, asked, q, t, out));
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
        for (i = 0; i < asked / (at ? 4 : 1); i++) {
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
    static const char *const not_so[] = {
        "tiny", "huge", "wide", "fillglobe", "fillcurve", "filloutlier"
    };
    size_t i;

    for (i = 0; i < sizeof not_so / sizeof not_so[0]; i++)
        if (strcmp(family, not_so[i]) == 0) return 0;
    return 1;
}

/* the next set's rounding mode */
static void turn(void)
{
    mode = (mode + 1) % 4;
}

static void family(const char *name, long many, int rounded)
{
    sprintf(now, "%s %ld", name, many);
    round_off(points_make(name, many, 1, x));
    rnd_seed(7);
    turn();
    if (n > 0) calls(rounded);
}

static void families(int which)
{
    const char *name;
    int i;

    for (i = 0; (name = points_name(i)) != NULL; i++)
        if (ordinary(name) == which) {
            int wide = strcmp(name, "wide") == 0;

            /* (squares of an outlier at 1e243 overflow) */
            family(name, wide ? 20 : FEW,
                   !wide && strcmp(name, "filloutlier") != 0);
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
            turn();
            for (i = 0; i < m; i++)
                for (k = 0; k < 3; k++)
                    p[3 * i + k] = (tess_real)(kind == 0 ? 0.1 : kind == 1 ? 0.1 * i
                        : kind == 2 ? (k == 2 ? 3.0 : 0.1 * (i * (k + 2) % 7))
                        : 0.37 * i + 0.7 * (k + 1) * (i * i % 11));
            calls(1);
        }
}

static void ordinary_data(int quick)
{
    /* enough for planes, spheres and cylinders */
    static const char *const large[] = {
        "globe", "tilted15", "test/data/mirror.xyz", "uniform", "rotcube",
        "uvsphere", "gridrot", "near8", "cubesurf", "spherefull", "pipes",
        "sheets"
    };
    int i;

    for (i = 0; i < (quick ? 1 : 2); i++) {
        families(1);
        flat();
        turn(); /* so that each set has another mode than before */
    }
    for (i = 0; i < (quick ? 3 : 12); i++) family(large[i], MOST, 1);
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
            turn();
            n = 4 + 2 * k;
            for (i = 0; i < 3 * n; i++)
                p[i] = k < 3 || i % 3 == 2 ? number(kind) : (tess_real)rnd_unit();
            calls(0);
        }
}

/* ---- edges ---- */

#define EDGES 11
#define FINITE 9 /* how many of them are */

static double edge[EDGES]; /* of coordinates and places */
static double edge_value[EDGES];
static double infinite, none; /* made by no operation that sets a flag */

static void set_edges(void)
{
    static const double real[] = {
#ifdef TESS_FLOAT
        0.0, -0.0, REAL_LEAST, 1e-38, 1e-19, 1.0, 1e19
#else
        0.0, -0.0, REAL_LEAST, 1e-300, 1e-150, 1.0, 1e150
#endif
    }, value[] = { 0.0, -0.0, 5e-324, 1e-300, 1e-150, 1.0, 1e150 };
    int i;

    for (i = 0; i < 7; i++) {
        edge[i] = real[i];
        edge_value[i] = value[i];
    }
    edge[7] = REAL_MOST;
    edge[8] = -REAL_MOST;
    edge_value[7] = DBL_MAX;
    edge_value[8] = -DBL_MAX;
    edge[9] = edge_value[9] = infinite;
    edge[10] = edge_value[10] = none;
}

static int all_finite(int many, const tess_real *q)
{
    int i;

    for (i = 0; i < 3 * many; i++)
        if (!isfinite(q[i])) return 0;
    return 1;
}

/* few limbs need not hold all */
#define RIGHT(code, range) \
    ((code) >= 0 && ((code) < (range) || (HH_LIMBS < 88 && (code) == (range))))

/* a result of a rounded routine that no double holds may set overflow; with
 * greater coordinates or centres than these, they may do so anyway */
#define PLAIN (0.125 * REAL_MOST)
#ifdef TESS_FLOAT
#define SQUARES REAL_MOST
#else
#define SQUARES 1e150
#endif

static int within(double most, int many, const double *y)
{
    int i;

    for (i = 0; i < many; i++)
        if (!(fabs(y[i]) <= most)) return 0;
    return 1;
}

/* what a rounded routine has set: nothing, or what its header allows */
static void rounded(int routine, int allowed, double result)
{
    if (allowed) return;
    if (result >= DBL_MAX) raised &= ~FE_OVERFLOW;
    expect(routine, (raised & TRAPS) == 0, "a flag");
}

/* the routines of hhpred.h, of five points */
static void edges_of_signs(const tess_real *q)
{
    static double f[HH_FACET_LEN], side, l, z[6];
    static int code, k, whole, known;

    whole = all_finite(4, q);
    CALL(ORIENT, code = hh_orient(q, q + 3, q + 6, q + 9));
    expect(ORIENT, whole ? code >= -1 && RIGHT(code + 1, 3) : code == 2,
           "its answer");
    CALL(INSPHERE, code = hh_insphere(q, q + 3, q + 6, q + 9, q + 12));
    expect(INSPHERE,
           all_finite(5, q) ? code >= -1 && RIGHT(code + 1, 3) : code == 2,
           "its answer");
    CALL(WRAP, code = hh_wrap(q, q + 3, q + 6, q + 9, &l));
    expect(WRAP, fabs(l) <= DBL_MAX && (code == 0 || l == 0.0), "its c");
    known = all_finite(3, q);
    expect(WRAP,
           known ? code >= 0 && code <= 2 && (whole || code > 0) : code == 1,
           "its code");
    if (trapped) return;
    watched = 0;
    CALL(FACET, code = hh_facet(q, q + 3, q + 6, f));
    for (k = 3, l = f[11]; k < 6; k++)
        if (fabs(f[k]) > l) l = fabs(f[k]);
    if (f[9] < DBL_MAX && f[10] > l) l = f[10];
    rounded(FACET, 0, l);
    if (!known) {
        for (k = 0; k < 6; k++) expect(FACET, f[k] == 0.0, "its f");
        expect(FACET, code == 1 && f[9] == DBL_MAX && f[10] == DBL_MAX &&
                          f[11] == 0.0, "its f");
    } else {
        for (k = 0; k < 3; k++) {
            expect(FACET, fabs(f[k]) <= 1.0 + 1e-9, "its normal");
            expect(FACET, f[k + 6] == (double)q[k], "its base");
        }
        expect(FACET, code == 0 || code == 1, "its code");
    }
    for (k = 0; k < 6; k++) z[k] = (double)q[9 + k];
    whole = within(PLAIN, 6, z) && within(PLAIN, 3, f + 6);
    CALL(SIDE, side = hh_side(f, q + 9));
    rounded(SIDE, !whole, 0.0);
    CALL(OPP, code = hh_opp(f, q + 9, q + 12));
    rounded(OPP, !whole, 0.0);
    expect(OPP, code == 0 || code == 1, "its answer");
    CALL(LCOORD, l = hh_lcoord(f, q + 9));
    rounded(LCOORD, !within(SQUARES, 3, z) || !within(SQUARES, 6, f + 3),
            fabs(l));
    watched = TRAPS;
}

/* the mean that tess_values promises: which of what kind.  (All weights are 0 in
 * a flat tetrahedron, which no result of tess has: one of altered points may.)
 */
static int right_mean(const double *w, const double *v, double mean)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    int k, nothing = 0;

    if (w[0] + w[1] + w[2] + w[3] == 0.0) return 1;
    for (k = 0; k < 4; k++)
        if (w[k] > 0.0) {
            if (isnan(v[k])) nothing = 1;
            else {
                if (v[k] < low) low = v[k];
                if (v[k] > high) high = v[k];
            }
        }
    if (nothing) return isnan(mean);
    if (isinf(low)) return mean == low;
    if (isinf(high)) return mean == high;
    return low <= mean && mean <= high;
}

/* places and values in a mesh of four or more points, of which some may have
 * been altered since */
static void edges_of_places(const tess_real *q, const double *value)
{
    static double w[4], v[4], out;
    static tess_int t, u;
    static int code, k, whole;

    t = TESS_NONE;
    CALL(LOCATE, code = tess_locate(p, ntet, tet, adj, q, &t, w));
    if (!all_finite(1, q)) {
        expect(LOCATE, code == -5, "its code");
        CALL(VALUES, code = tess_values(p, ntet, tet, adj, 1, value, 1, q, &t,
                                        &out));
        expect(VALUES, code == -8, "its code");
        return;
    }
    whole = all_finite((int)n, p);
    expect(LOCATE, code == 0 || code == 1 || code == -4 || code == TESS_RANGE,
           "its code");
    if (whole && HH_LIMBS >= 88)
        expect(LOCATE, code != TESS_RANGE, "out of range");
    for (k = 0; k < 4; k++)
        expect(LOCATE,
               w[k] >= 0.0 && w[k] <= 1.0 && (code < 2 || w[k] == 0.0),
               "its weights");
    if (code < 0 || code > 1) return;
    for (k = 0; k < 4; k++) {
        v[k] = value[tet[4 * t + k]];
        expect(LOCATE, w[k] == 0.0 || all_finite(1, p + 3 * tet[4 * t + k]),
               "a vertex that is none");
    }
    u = TESS_NONE;
    out = 0.25;
    CALL(VALUES,
         code = tess_values(p, ntet, tet, adj, 1, value, 1, q, &u, &out));
    expect(VALUES, code == 0 || code == 1, "its code");
    expect(VALUES, right_mean(w, v, out), "its mean");
}

#define SMALL 12

/* a number: ordinary, or one time of so many an edge */
static tess_real any(int one_of, int kinds)
{
    return (tess_real)(rnd_below(one_of) ? 2.0 * rnd_unit() - 1.0
                                         : edge[rnd_below(kinds)]);
}

static void ordinary_points(void)
{
    int i;

    n = SMALL;
    for (i = 0; i < 3 * n; i++) p[i] = (tess_real)rnd_unit();
}

/* the mesh of p, and its index, with stated results; 1 if there are both */
static int edges_of_points(void)
{
    static tess_int bad, at, v[4], mine[SMALL], copy[LIW];
    static double c[4];
    static int code, i, whole, mesh;

    for (at = 0; at < n && all_finite(1, p + 3 * at); at++)
        ;
    whole = at == n;
    ntet = 5;
    CALL(MESH, mesh = tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw));
    expect(MESH, whole ? RIGHT(mesh, TESS_RANGE) && mesh != TESS_MORE &&
                             mesh != TESS_POOL
                       : mesh == -2 && ntet == at, "its code");
    bad = 0;
    CALL(RESUME, code = tess_resume(n, p, MAXTET, whole ? &ntet : &bad, tet, adj,
                                    LIW, iw, LRW, rw));
    expect(RESUME, code == mesh, "its code");
    CALL(CHECK, code = tess_check(n, p, whole ? ntet : 0, tet, adj, 2 * n, iw,
                                  &bad));
    expect(CHECK, code == (!whole ? -2 : mesh == TESS_RANGE ? code : 0),
           "its code");
    for (i = 0; i < 4; i++) v[i] = rnd_below((int)n);
    for (i = 0, code = 1; i < 4; i++)
        if (!all_finite(1, p + 3 * v[i])) code = 0;
    if (code) {
        CALL(BALL, code = tess_ball(p, v, c));
        expect(BALL, RIGHT(code, TESS_RANGE), "its code");
        expect(BALL, within(DBL_MAX, 4, c) && c[3] > 0.0, "its ball");
    } else {
        CALL(BALL, code = tess_ball(p, v, c));
        expect(BALL, code == -1 && c[3] == DBL_MAX, "its code");
    }
    CALL(INDEX, code = tess_index(n, p, LIW, iw, LRW, rw));
    expect(INDEX, code == mesh, "its code");
    if (mesh != TESS_OK) return 0;
    CALL(HULL, code = tess_hull(ntet, tet, adj, 0, &bad, tet));
    expect(HULL, code == TESS_MORE, "its code");
    memcpy(copy, iw, sizeof copy);
    for (i = 0; i < n; i++) mine[i] = rnd_below(3) == 0;
    bad = 0;
    CALL(PART, code = tess_part(n, p, mine, MAXTET - ntet, &bad, tet + 4 * ntet,
                                adj + 4 * ntet, LIW, copy, LRW, rw));
    expect(PART, code == TESS_OK, "its code");
    return 1;
}

/* the query, of which tess_locate's answer is known to be code */
static void edge_query(const tess_real *q)
{
    static tess_int v[4];
    static double w[4];
    static int code, k;

    v[0] = TESS_NONE;
    CALL(QUERY, code = tess_query(n, p, iw, rw, q, v, w));
    expect(QUERY, all_finite(1, q) ? RIGHT(code, TESS_RANGE) &&
                                         (code < 2 || code == TESS_RANGE)
                                   : code == -5, "its code");
    for (k = 0; k < 4 && all_finite(1, q); k++)
        expect(QUERY, w[k] >= 0.0 && w[k] <= 1.0, "its weights");
}

/* One edge in each place, beside ordinary numbers. */
static void single_edges(void)
{
    static tess_real q[15], kept;
    static double value[SMALL];
    int i, j, k;

    for (j = 0; j < EDGES; j++) {
        sprintf(now, "%g alone", edge[j]);
        rnd_seed(1);
        turn();
        for (k = 0; k < 15; k++) q[k] = any(2, FINITE - 2);
        for (i = 0; i < 15; i++) {
            kept = q[i];
            q[i] = (tess_real)edge[j];
            edges_of_signs(q);
            q[i] = kept;
        }
        ordinary_points();
        for (i = 0; i < 3 * n; i += 5) {
            kept = p[i];
            p[i] = (tess_real)edge[j];
            if (edges_of_points()) edge_query(p + 3);
            p[i] = kept;
        }
        if (!edges_of_points()) expect(MESH, 0, "no mesh");
        for (i = 0; i < n; i++) value[i] = i;
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 3; k++) q[k] = (tess_real)0.5;
            q[i] = (tess_real)edge[j];
            edges_of_places(q, value);
            edge_query(q);
        }
        for (i = 0; i < n; i++) {
            value[i] = edge_value[j];
            for (k = 0; k < 3; k++) q[k] = (tess_real)(0.5 + 0.1 * k);
            edges_of_places(q, value);
            edges_of_places(p + 3 * i, value);
            edges_of_places(p + 3 * ((i + 1) % n), value);
            value[i] = i;
        }
        /* a mesh whose points have changed: of a result that is wrong */
        for (i = 0; i < 3 * n; i++) {
            kept = p[i];
            p[i] = (tess_real)edge[j];
            for (k = 0; k < 3; k++) q[k] = (tess_real)(0.5 + 0.1 * k);
            edges_of_places(q, value);
            for (k = 0; k < 3; k++) q[k] = 2 + k;
            edges_of_places(q, value);
            p[i] = kept;
        }
    }
}

/* Several by chance. */
static void many_edges(int sets)
{
    static tess_real q[15];
    static double value[SMALL];
    int set, kinds, i, k;

    for (set = 0; set < sets; set++) {
        sprintf(now, "edges, set %d", set);
        rnd_seed((unsigned long)set);
        turn();
        /* without NaNs and infinities, or with them, or all that are alike */
        kinds = set % 3 == 2 ? EDGES : FINITE;
        for (k = 0; k < 15; k++) q[k] = any(1 + set % 4, kinds);
        edges_of_signs(q);
        n = 4 + rnd_below(SMALL - 3);
        for (i = 0; i < 3 * n; i++) p[i] = any(1 + set % 5, kinds);
        if (set % 7 == 0)
            for (i = 0; i < 3 * n; i++) p[i] *= (tess_real)edge[3];
        if (!edges_of_points()) continue;
        for (i = 0; i < 6; i++) {
            for (k = 0; k < 3; k++) q[k] = any(1 + i % 3, i < 4 ? FINITE : EDGES);
            for (k = 0; k < n; k++)
                value[k] = rnd_below(3) ? edge_value[rnd_below(EDGES)] : k;
            edges_of_places(i == 2 ? p : q, value);
            edge_query(q);
        }
        for (i = 0; i < 3; i++) {
            p[rnd_below((int)(3 * n))] = any(1, EDGES);
            edges_of_places(q, value);
        }
    }
}

/* ---- sets by chance ---- */

static void hunt(int from, int sets, int most)
{
    static double hard[MOST][3];
    const char *name = "";
    int set, all, line;

    for (all = 0; points_name(all) != NULL; all++)
        ;
    for (set = from; set < from + sets; set++) {
        rnd_seed((unsigned long)set);
        turn();
        switch (set % 8) {
        case 0:
            name = "few";
            n = hard_few(hard);
            break;
        case 1:
        case 2:
        case 3:
        case 4:
            name = "many";
            n = hard_many(hard, most);
            break;
        case 5:
            name = "near";
            n = hard_near(hard, most);
            break;
        case 6:
            name = points_name(rnd_below(all));
            line = strcmp(name, "wide") == 0 ? 20 : 10 + rnd_below(most - 10);
            n = (tess_int)points_make(name, line, (unsigned long)set,
                                      hard[0]);
            break;
        default:
            if (most < MOST) continue;
            name = "lines";
            n = hard_lines(hard, MOST, &line);
        }
        sprintf(now, "%s, set %d", name, set);
        memcpy(x, hard, sizeof x);
        round_off((long)n);
        if (n > 0) calls(0);
    }
}

/* ---- what is the same in all rounding modes ---- */

#define PLACES 12

typedef struct answers {
    int code[6], locate[PLACES], query[PLACES];
    tess_int ntet, part, t[PLACES], v[4 * PLACES], inside[PLACES];
    double w[4 * PLACES], x[4 * PLACES];
    tess_int tet[4 * MAXTET], adj[4 * MAXTET], first[MOST], place[MOST];
    tess_int part_tet[4 * MAXTET], part_adj[4 * MAXTET];
} answers;

/* tess_query's vertices in order; outside those that count, as other hull
 * triangles may have them, too */
static void in_order(int code, tess_int *v, double *w)
{
    tess_int z;
    double y;
    int i, k;

    for (i = 0; i < 4; i++) {
        if (code == 1 && w[i] < DBL_MIN) {
            v[i] = TESS_NONE;
            w[i] = 0.0;
        }
        for (k = i; k > 0 && v[k - 1] > v[k]; k--) {
            z = v[k];
            v[k] = v[k - 1];
            v[k - 1] = z;
            y = w[k];
            w[k] = w[k - 1];
            w[k - 1] = y;
        }
    }
}

static void answer(const tess_real *q, answers *a)
{
    static tess_int mine[MOST], none4[4] = { -1, -1, -1, -1 }, at;
    static double value[MOST], out[PLACES];
    int i;

    memset(a, 0, sizeof *a);
    for (i = 0; i < n; i++) mine[i] = i % 3 == 0;
    CALL(MESH, a->code[0] = tess(n, p, MAXTET, &a->ntet, a->tet, a->adj, LIW, iw,
                                 LRW, rw));
    if (a->code[0] >= 0) memcpy(a->first, iw, (size_t)n * sizeof *iw);
    CALL(CHECK, a->code[1] = tess_check(n, p, a->ntet, a->tet, a->adj, LIW, iw,
                                        &at));
    CALL(INDEX, a->code[2] = tess_index(n, p, LIW, iw, LRW, rw));
    if (a->code[2] >= 0) memcpy(a->place, iw, (size_t)n * sizeof *iw);
    if (a->code[0] != TESS_OK) return;
    for (i = 0, at = TESS_NONE; i < PLACES; i++) {
        if (i % 3 == 0) at = TESS_NONE;
        CALL(LOCATE, a->locate[i] = tess_locate(p, a->ntet, a->tet, a->adj,
                                                q + 3 * i, &at, a->w + 4 * i));
        a->t[i] = at;
        memcpy(a->v + 4 * i, none4, sizeof none4);
        CALL(QUERY, a->query[i] = tess_query(n, p, iw, rw, q + 3 * i,
                                             a->v + 4 * i, a->x + 4 * i));
        in_order(a->query[i], a->v + 4 * i, a->x + 4 * i);
        a->inside[i] = TESS_NONE;
    }
    CALL(VALUES, a->code[3] = tess_values(p, a->ntet, a->tet, a->adj, 1, value,
                                          PLACES, q, a->inside, out));
    CALL(PART, a->code[4] = tess_part(n, p, mine, MAXTET, &a->part, a->part_tet,
                                      a->part_adj, LIW, iw, LRW, rw));
}

#define SAME(what) (memcmp(a->what, b->what, sizeof a->what) == 0)

/* each is right to 12 eps of itself in any mode, or underflows; so all are 0 or
 * none is, or all are below the least normal number */
static int alike(const double *w, const double *x)
{
    int i;

    for (i = 0; i < 4 * PLACES; i++)
        if (fabs(w[i] - x[i]) > 24.0 * DBL_EPSILON * w[i] &&
            !(w[i] <= DBL_MIN && x[i] <= DBL_MIN))
            return 0;
    return 1;
}

static void compare(const answers *a, const answers *b)
{
    expect(MESH, SAME(code) && a->ntet == b->ntet && SAME(tet) && SAME(adj) &&
                     SAME(first), "another result");
    expect(INDEX, SAME(place), "another order");
    expect(PART, a->part == b->part && SAME(part_tet) && SAME(part_adj),
           "another result");
    expect(LOCATE, SAME(locate) && SAME(t), "another tetrahedron");
    expect(LOCATE, alike(a->w, b->w), "other weights");
    expect(VALUES, SAME(inside), "another tetrahedron");
    expect(QUERY, SAME(query) && SAME(v), "another tetrahedron");
    expect(QUERY, alike(a->x, b->x), "other weights");
}

static void all_modes(int from, int sets, int most)
{
    static answers by[2];
    static double hard[MOST][3];
    static tess_real q[3 * PLACES];
    const char *name;
    int set, all, i;
    long differ = 0;

    for (all = 0; points_name(all) != NULL; all++)
        ;
    for (set = from; set < from + sets; set++) {
        rnd_seed((unsigned long)set);
        name = set % 4 == 0 ? "many" : set % 4 == 1 ? "near"
             : set % 4 == 2 ? "few" : points_name(rnd_below(all));
        n = set % 4 == 0 ? hard_many(hard, most)
          : set % 4 == 1 ? hard_near(hard, most)
          : set % 4 == 2 ? hard_few(hard)
          : (tess_int)points_make(name, strcmp(name, "wide") ? most : 20,
                                  (unsigned long)set, hard[0]);
        sprintf(now, "%s, set %d", name, set);
        memcpy(x, hard, sizeof x);
        round_off((long)n);
        if (n == 0) continue;
        ntet = 0;
        mode = 0;
        tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
        for (i = 0; i < PLACES; i++) place(i, q + 3 * i);
        for (mode = 0; mode < 4; mode++) {
            answer(q, by + (mode > 0));
            if (mode == 0) continue;
            compare(by, by + 1);
            differ += memcmp(by[0].w, by[1].w, sizeof by[0].w) != 0;
        }
        mode = 0;
    }
    expect(LOCATE, differ > 0, "weights that no rounding mode alters");
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
    int quick = test_quick(argc, argv);
    double zero = 0.0;

    infinite = HUGE_VAL;
    none = infinite * zero;
    set_edges();
    watched = FLAGS;
    ordinary_data(quick);
    results("ordinary");
    watched = TRAPS;
    single_edges();
    many_edges(quick > 1 ? 80 : quick ? 200 : 600);
    results("edges");
    hunt(0, quick > 1 ? 8 : quick ? 24 : 60, FEW);
    if (!quick) hunt(100000, 2, MOST);
    results("hunt");
    all_modes(0, quick ? 12 : 24, quick ? FEW : 300);
    results("modes");
    if (signal(SIGFPE, trap) == SIG_ERR) return 1;
    if (feenableexcept(FE_DIVBYZERO) == -1) {
        test_skip("this processor does not trap");
        return test_end();
    }
    fedisableexcept(TRAPS);
    trapped = 1;
    single_edges();
    many_edges(quick > 1 ? 40 : quick ? 100 : 300);
    results("traps, edges");
    hard_data();
    results("traps, hard data");
    bad_data();
    results("traps, bad arguments");
    return test_end();
}

#else

int main(int argc, char **argv)
{
    (void)test_quick(argc, argv);
    test_skip("no fenv.h");
    return test_end();
}

#endif
