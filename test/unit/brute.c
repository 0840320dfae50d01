/* brute.c - tess against the definition, on small sets full of ties.
 *
 *     brute [sets [seed]]      sets of each kind, default 800
 *     brute -one kind seed     one set, in full
 *
 * What verify.h asks for: of so few points that no point is in the perturbed
 * ball of any tetrahedron; and tess_check's verdict.  tess_query, from any four
 * points for a start: what it answers is a tetrahedron of the mesh, which holds
 * the place or is as near to it as tess_locate's; code -6 where the start is
 * none.  A failing set prints how to see it again.
 */
#include "../lib/verify.h"
#include "../lib/exact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 60 /* of the last kind; 12 of the others */
#define MAXTET 1000
#define LENGTH 20000
#ifdef TESS_FLOAT
#define REAL_STEP FLT_EPSILON
#else
#define REAL_STEP DBL_EPSILON
#endif
/* Exponents as far apart as the limbs and the coordinates allow. */
#ifdef TESS_FLOAT
#define LARGE 100
#define HUGE_ONE 120
#define TINY (-120)
#elif HH_LIMBS < 80
#define LARGE 20
#define HUGE_ONE 20
#define TINY (-20)
#else
#define LARGE 500
#define HUGE_ONE 1000
#define TINY (-664)
#endif
/* tess.c's: see opposite */
#define BLOCK_REACH 2.6
#define STAR_REACH 0.85

static int n;
static double p[MOST][3];

static int code;

static tess_int ntet, tet[4 * MAXTET], adj[4 * MAXTET], iw[LENGTH];
static double rw[LENGTH];
static tess_real point[3 * MOST];

/* ---- kinds of sets ---- */

static void set(int i, double x, double y, double z)
{
    p[i][0] = x;
    p[i][1] = y;
    p[i][2] = z;
}

/* n points of the integer lattice {0 .. size-1}^3 */
static void lattice(int size)
{
    int i;

    for (i = 0; i < n; i++)
        set(i, rnd_below(size), rnd_below(size), rnd_below(size));
}

/* n of the integer points with x^2 + y^2 + z^2 = square */
static void sphere(int square)
{
    int i, x, y, z;

    for (i = 0; i < n; i++) {
        do {
            x = rnd_below(11) - 5;
            y = rnd_below(11) - 5;
            z = rnd_below(11) - 5;
        } while (x * x + y * y + z * z != square);
        set(i, x, y, z);
    }
}

/* opposite - a point at 1 - 1e-9 of the diameter of an otherwise empty ball
 * through a vertex, four points on it; the ball is as large as the lists of the
 * vertex's star allow that they decide, by 1e-10.  What a list leaves out for
 * rounding's sake is then missed.  The points are few, so that one leaf holds
 * them, in the unit cube. */
static void opposite(void)
{
    double reach, diameter, s, centre[3];
    int i, k;

    n = 10;
    reach = BLOCK_REACH / sqrt(3.0) * 3.0 / (6.4 + n / (3.2 * 3.2));
    diameter = STAR_REACH * reach * sqrt(3.0) * (1.0 - 1e-10);
    for (k = 0; k < 3; k++) centre[k] = 0.48 + 0.04 * rnd_unit();
    for (i = 0; i < 4; i++) {
        do {
            set(i, 2.0 * rnd_unit() - 1.0, 2.0 * rnd_unit() - 1.0,
                2.0 * rnd_unit() - 1.0);
            s = p[i][0] * p[i][0] + p[i][1] * p[i][1] + p[i][2] * p[i][2];
        } while (s > 1.0 || s < 0.1);
        for (k = 0; k < 3; k++) p[i][k] *= 0.5 * diameter / sqrt(s);
    }
    for (k = 0; k < 3; k++) p[4][k] = -(1.0 - 2e-9) * p[0][k];
    for (i = 0; i < 5; i++)
        for (k = 0; k < 3; k++) p[i][k] += centre[k];
    for (i = 5; i < n; i++) /* corners */
        set(i, i == 5 || i == 9, i == 6 || i == 9, i == 7 || i == 9);
    rnd_mix(p, n);
    /* (in steps that a few limbs hold) */
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) p[i][k] = (p[i][k] + 1.0) - 1.0;
}

static const char *const kinds[] = {
    "points of {0,1}^3", "points of {0,1,2}^3", "cube and inner points",
    "octahedron and more", "integer sphere 9", "integer sphere 26",
    "plane grid and one point", "two or three layers", "two circles",
    "random", "random with duplicates", "lattice moved by a last place",
    "plane sets", "lines and points", "body-centred lattice",
    "tenths of a lattice, far away", "zeros of both signs", "two lines",
    "large integer spheres", "large integers in a plane",
    "a lattice sheared: volumes of 1", "cocircular in a hull face",
    "a large lattice moved by a tiny step", "a huge square, and a tiny height",
    "a point opposite a ball's vertex", "sixty points"
};
#define KINDS ((int)(sizeof kinds / sizeof kinds[0]))
#define SIXTY (KINDS - 1)

static void make(int kind)
{
    static const int circle[12][2] = {
        { 5, 0 }, { 4, 3 }, { 3, 4 }, { 0, 5 }, { -3, 4 }, { -4, 3 },
        { -5, 0 }, { -4, -3 }, { -3, -4 }, { 0, -5 }, { 3, -4 }, { 4, -3 }
    };
    /* volatile: a compiler was seen to optimize the rounding away */
    volatile tess_real rounded;
    int i, j, k, a, b;
    double x, u[3], v[3];

    n = 4 + rnd_below(6);
    switch (kind) {
    case 0:
        lattice(2);
        break;
    case 1:
        lattice(3);
        break;
    case 2:
        for (i = 0; i < 8; i++)
            set(i, 2 * (i & 1), 2 * (i >> 1 & 1), 2 * (i >> 2));
        n = 8 + rnd_below(2);
        set(8, rnd_below(3), rnd_below(3), 1);
        rnd_mix(p, n);
        break;
    case 3:
        n = 10;
        lattice(5);
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++) p[i][k] -= 2;
        for (i = 0; i < 6; i++)
            set(i, i == 0 ? 1 : -(i == 1), i == 2 ? 1 : -(i == 3),
                i == 4 ? 1 : -(i == 5));
        n = 6 + rnd_below(5);
        rnd_mix(p, n);
        break;
    case 4:
        sphere(9);
        break;
    case 5:
        n = 8 + rnd_below(3);
        sphere(26);
        break;
    case 6:
        n = 10;
        for (i = 0; i < 9; i++) set(i, i / 3, i % 3, 1);
        set(9, rnd_below(4), rnd_below(4), rnd_below(2) * 2);
        rnd_mix(p, n);
        n = 10 - rnd_below(4);
        break;
    case 7:
        n = 11;
        a = 2 + rnd_below(2);
        for (i = 0; i < n; i++)
            set(i, i % 2, i / 2 % 2, i / 4);
        for (i = 0; i < n; i++) p[i][rnd_below(3)] *= a - 1;
        rnd_mix(p, n);
        break;
    case 8:
        n = 10;
        for (i = 0; i < n; i++) {
            j = rnd_below(12);
            set(i, circle[j][0], circle[j][1], i % 2 * 5);
        }
        break;
    case 9:
    case 10:
        n = 6 + rnd_below(5);
        for (i = 0; i < n; i++)
            set(i, rnd_unit(), rnd_unit(), rnd_unit());
        if (kind == 10)
            for (i = 0; i < 3; i++) {
                a = rnd_below(n);
                b = rnd_below(n);
                for (k = 0; k < 3; k++) p[a][k] = p[b][k];
            }
        break;
    case 11:
        lattice(3);
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++)
                p[i][k] += 1.0 + (tess_real)(rnd_below(3) - 1) * REAL_STEP;
        break;
    case 12:
        /* the points of a plane x + a y + b z = 0, or off it by one */
        a = rnd_below(3);
        b = rnd_below(3);
        for (i = 0; i < n; i++) {
            j = rnd_below(4);
            k = rnd_below(4);
            set(i, -a * j - b * k, j, k);
        }
        if (rnd_below(3) == 0) p[rnd_below(n)][0] += 1.0;
        break;
    case 13:
        n = rnd_below(5);
        a = rnd_below(3);
        for (i = 0; i < n; i++) {
            j = rnd_below(3);
            set(i, 1.0 + a * j, 3 * j, 2.0 - j);
        }
        if (n > 0 && rnd_below(3) == 0) p[rnd_below(n)][2] += 1.0;
        break;
    case 14:
        lattice(2);
        for (i = 0; i < n; i++) {
            x = 0.5 * rnd_below(2);
            for (k = 0; k < 3; k++) p[i][k] += x;
        }
        break;
    case 15:
        lattice(4);
        x = 1000.0 * rnd_below(2);
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++) p[i][k] = x + 0.1 * p[i][k];
        break;
    case 16:
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++) {
                j = rnd_below(4);
                p[i][k] = j == 0 ? 0.0 : j == 1 ? -0.0 : j == 2 ? 1.0 : -1.0;
            }
        break;
    case 17:
        for (i = 0; i < n; i++) {
            if (i % 2) set(i, i, 0, 0);
            else set(i, 0, i, 1);
        }
        rnd_mix(p, n);
        break;
    case 18:
        /* as large as exact ties in double precision may be, and larger */
        n = 7 + rnd_below(3);
        sphere(26);
        a = 1 + rnd_below(2000);
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++) p[i][k] = a * (p[i][k] + 6.0);
        break;
    case 19:
        n = 8;
        for (k = 0; k < 3; k++) {
            u[k] = rnd_below(1 << 18);
            v[k] = rnd_below(1 << 18);
        }
        for (i = 0; i < n; i++) {
            a = rnd_below(4);
            b = rnd_below(4);
            for (k = 0; k < 3; k++)
                p[i][k] = a * u[k] + b * v[k];
        }
        p[rnd_below(n)][rnd_below(3)] += 1000.0;
        break;
    case 20:
        /* by consecutive Fibonacci numbers, whose products sum to just below
         * what doubles hold: each volume is what it was */
        lattice(3);
        for (i = 0; i < n; i++)
            set(i, 5702887.0 * p[i][0] + 9227465.0 * p[i][1],
                9227465.0 * p[i][0] + 14930352.0 * p[i][1], p[i][2]);
        break;
    case 22:
        lattice(3);
        for (i = 0; i < n; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = ldexp(p[i][k], LARGE) +
                          (rnd_below(3) - 1) * ldexp(1.0, TINY);
        break;
    case 23:
        for (i = 0; i < n; i++)
            set(i, ldexp(rnd_below(2), HUGE_ONE), ldexp(rnd_below(2), HUGE_ONE),
                rnd_below(3) > 0 ? 0.0 : ldexp(1.0, -100 > TINY ? -100 : TINY));
        break;
    case 24:
        opposite();
        break;
    case SIXTY:
        n = 60;
        if (rnd_below(3) == 0) lattice(5);
        else
            for (i = 0; i < n; i++)
                set(i, rnd_unit(), rnd_unit(), rnd_unit());
        break;
    default:
        /* the circle as a face, other points on one side of it */
        n = 9;
        b = rnd_below(12);
        for (i = 0; i < n; i++) {
            j = (b + i) % 12;
            if (i < 6) set(i, circle[j][0], circle[j][1], 0);
            else set(i, rnd_below(3) - 1, rnd_below(3) - 1, 1 + rnd_below(2));
        }
        rnd_mix(p, n);
        n -= rnd_below(3);
        break;
    }
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            rounded = (tess_real)p[i][k];
            point[3 * i + k] = rounded;
            p[i][k] = (double)rounded;
        }
}

/* ---- queries ---- */

/* Is v one of the mesh's tetrahedra, whose orientation is positive? */
static int inmesh(const tess_int *v)
{
    tess_int t;
    int i, k = 0;

    for (i = 0; i < 4; i++)
        if (v[i] < 0 || v[i] >= n) return 0;
    for (t = 0; t < ntet && k < 4; t++)
        for (k = 0; k < 4; k++) {
            for (i = 0; i < 4 && v[i] != tet[4 * t + k]; i++)
                ;
            if (i == 4) break;
        }
    return k == 4 && ex_orient(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) > 0;
}

/* Whether tess_query is right at q from the start v. */
static const char *query(const tess_real *q, const tess_int *start)
{
    const double *c[4];
    double w[4], x[3];
    tess_int v[4], t = TESS_NONE;
    int k, answer, expected = tess_locate(point, ntet, tet, adj, q, &t, w);

    for (k = 0; k < 4; k++) v[k] = start[k];
    answer = tess_query((tess_int)n, point, iw, rw, q, v, w);
    if (answer == -6)
        return start[0] != TESS_NONE && !inmesh(start) ? NULL
                   : "tess_query: -6 for a good start, or none";
    if (answer != expected) return "tess_query: another code";
    if (!inmesh(v)) return "tess_query: no tetrahedron of the mesh";
    for (k = 0; k < 3; k++) x[k] = (double)q[k];
    for (k = 0; k < 4; k++) c[k] = p[v[k]];
    for (k = 0; k < 4 && answer == 0; k++) {
        c[k] = x;
        if (ex_orient(c[0], c[1], c[2], c[3]) < 0)
            return "tess_query: not inside";
        c[k] = p[v[k]];
    }
    return NULL;
}

/* From starts of any kind to places of any kind. */
static const char *queries(void)
{
    static tess_real q[3];
    const char *fault = NULL;
    tess_int v[4];
    int i, k, a, b;

    if (tess_index((tess_int)n, point, LENGTH, iw, LENGTH, rw) != TESS_OK)
        return "tess_index";
    for (i = 0; i < 6 && fault == NULL; i++) {
        a = rnd_below(n);
        b = rnd_below(n);
        for (k = 0; k < 3; k++)
            q[k] = (tess_real)(i % 3 == 0 ? p[a][k]
                : i % 3 == 1 ? 0.5 * p[a][k] + 0.5 * p[b][k]
                : p[rnd_below(n)][k]);
        a = rnd_below((int)ntet);
        for (k = 0; k < 4; k++)
            v[k] = i == 0 ? tet[4 * a + k] : (tess_int)rnd_below(n);
        if (i == 1) v[0] = TESS_NONE;
        fault = query(q, v);
    }
    return fault;
}

/* Whether the set of that kind and seed passes. */
static int run(int kind, unsigned long seed, int full)
{
    const char *fault;
    tess_int liw, lrw, t, bad;
    int i;

    rnd_seed(seed);
    make(kind);
    if (full) {
        printf("# %d points:\n", n);
        for (i = 0; i < n; i++)
            printf("# %.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
    }
    if (tess_size((tess_int)n, MAXTET, &liw, &lrw) != 0 || liw > LENGTH ||
        lrw > LENGTH)
        fault = "tess_size";
    else {
        code = tess((tess_int)n, point, MAXTET, &ntet, tet, adj, liw, iw, lrw,
                    rw);
        fault = verify((tess_int)n, point, code, ntet, tet, adj, iw);
        if (fault == NULL &&
            tess_check((tess_int)n, point, ntet, tet, adj, (tess_int)(2 * n),
                       iw, &bad) != 0)
            fault = "tess_check";
        if (fault == NULL && code == TESS_OK &&
            (seed % 4 == 0 || kind == SIXTY))
            fault = queries();
        if (full || fault)
            printf("# code %d, %ld tetrahedra\n", code, (long)ntet);
    }
    if (full)
        for (t = 0; t < ntet; t++)
            printf("# %d: %d %d %d %d\n", (int)t, (int)tet[4 * t],
                   (int)tet[4 * t + 1], (int)tet[4 * t + 2],
                   (int)tet[4 * t + 3]);
    if (fault)
        printf("# %s differs: brute -one %d %lu (%s)\n", fault, kind, seed,
               kinds[kind]);
    return fault == NULL;
}

/* A start that once led to another tetrahedron that is not in the mesh. */
static int stranger(void)
{
    static const int set7[7][3] = {
        { 4, 1, 0 }, { 3, 8, 1 }, { 3, 2, 0 }, { 4, 8, 7 }, { 8, 4, 8 },
        { 6, 1, 5 }, { 0, 6, 0 }
    };
    static const tess_int start[4] = { 3, 2, 6, 4 };
    static const tess_real q[3] = { 4, 2, 1 };
    tess_int lrw = LENGTH;
    const char *fault;
    int i, k;

    n = 7;
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            p[i][k] = set7[i][k];
            point[3 * i + k] = (tess_real)set7[i][k];
        }
    code = tess((tess_int)n, point, MAXTET, &ntet, tet, adj, LENGTH, iw, lrw,
                rw);
    fault = verify((tess_int)n, point, code, ntet, tet, adj, iw);
    if (fault == NULL && tess_index((tess_int)n, point, LENGTH, iw, lrw, rw) != 0)
        fault = "tess_index";
    if (fault == NULL) fault = query(q, start);
    if (fault) printf("# %s\n", fault);
    return fault == NULL;
}

int main(int argc, char **argv)
{
    static const char usage[] = "[sets [seed] | -one kind seed]";
    long sets = 800, seed = 1, most, i, faults, solid;
    int kind, one = argc == 4 && strcmp(argv[1], "-one") == 0;

    if (argc > 3 && !one) test_usage(argv[0], usage);
    if (argc > 1 + one) sets = test_number(argv[1 + one], !one, argv, usage);
    if (argc > 2 + one) seed = test_number(argv[2 + one], 0, argv, usage);
    if (one && sets >= KINDS) test_usage(argv[0], usage);
    if (one) return !run((int)sets, (unsigned long)seed, 1);
    for (kind = 0; kind < KINDS; kind++) {
        faults = solid = 0;
        most = kind == SIXTY ? sets / 20 + 1 : sets;
        for (i = 0; i < most && faults < 5; i++) {
            faults += !run(kind, (unsigned long)(seed + i), 0);
            solid += code == TESS_OK;
        }
        printf("# of %ld sets %ld with tetrahedra\n", i, solid);
        /* a kind must not be all flat, but for lines and points */
        if (sets >= 100 && kind != 13) faults += solid < i / 10;
        test_result(kinds[kind], faults);
    }
    test_result("a start that is no tetrahedron", !stranger());
    return test_end();
}
