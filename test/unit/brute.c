/* brute.c - tess against the definition, on small sets full of ties.
 *
 *     brute [sets [seed]]      sets of each kind, default 800
 *     brute -one kind seed     one set, in full
 *
 * What verify.h asks for: of so few points that no point is in the perturbed
 * ball of any tetrahedron; and tess_check's verdict.  A failing set prints how to
 * see it again.
 */
#include "../proof/verify.h"
#include "../proof/exact.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST 12
#define MAXTET 400
#define LENGTH 20000
#ifdef TESS_FLOAT
#define REAL_STEP FLT_EPSILON
#else
#define REAL_STEP DBL_EPSILON
#endif

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

static const char *const kinds[] = {
    "points of {0,1}^3", "points of {0,1,2}^3", "cube and inner points",
    "octahedron and more", "integer sphere 9", "integer sphere 26",
    "plane grid and one point", "two or three layers", "two circles",
    "random", "random with duplicates", "lattice moved by a last place",
    "plane sets", "lines and points", "body-centred lattice",
    "tenths of a lattice, far away", "zeros of both signs", "two lines",
    "large integer spheres", "large integers in a plane",
    "a lattice sheared: volumes of 1", "cocircular in a hull face"
};
#define KINDS ((int)(sizeof kinds / sizeof kinds[0]))

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

/* Whether the set of that kind and seed passes. */
static int run(int kind, unsigned long seed, int full)
{
    const char *fault;
    tess_int liw, lrw, t, bad;
    int i;

    rnd_seed(seed);
    make(kind);
    if (full) {
        printf("%d points:\n", n);
        for (i = 0; i < n; i++)
            printf("%.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
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
        if (full || fault)
            printf("code %d, %ld tetrahedra\n", code, (long)ntet);
    }
    if (full)
        for (t = 0; t < ntet; t++)
            printf("%d: %d %d %d %d\n", (int)t, (int)tet[4 * t],
                   (int)tet[4 * t + 1], (int)tet[4 * t + 2],
                   (int)tet[4 * t + 3]);
    if (fault)
        printf("%s differs: brute -one %d %lu (%s)\n", fault, kind, seed,
               kinds[kind]);
    return fault == NULL;
}

int main(int argc, char **argv)
{
    static const char usage[] = "[sets [seed] | -one kind seed]";
    long sets = 800, seed = 1, i, faults, solid;
    int kind, one = argc == 4 && strcmp(argv[1], "-one") == 0;

    if (argc > 3 && !one) test_usage(argv[0], usage);
    if (argc > 1 + one) sets = test_number(argv[1 + one], !one, argv, usage);
    if (argc > 2 + one) seed = test_number(argv[2 + one], 0, argv, usage);
    if (one && sets >= KINDS) test_usage(argv[0], usage);
    if (one) return !run((int)sets, (unsigned long)seed, 1);
    for (kind = 0; kind < KINDS; kind++) {
        faults = solid = 0;
        for (i = 0; i < sets && faults < 5; i++) {
            faults += !run(kind, (unsigned long)(seed + i), 0);
            solid += code == TESS_OK;
        }
        printf("        of %ld sets %ld with tetrahedra\n", i, solid);
        /* a kind must not be all flat, but for lines and points */
        if (sets >= 100 && kind != 13) faults += solid < i / 10;
        test_result(kinds[kind], faults);
    }
    return test_end("brute");
}
