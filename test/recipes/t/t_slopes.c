/* t_slopes.c - tests of slopes.c: what its header promises.  `t_slopes table'
 * writes a table of errors.  Linked with twin/recipes.c it tests slopes.f.
 *
 *   cc -O2 -I. -o t_slopes test/recipes/t/t_slopes.c \
 *       test/recipes/slopes.c tess.c hhpred.c -lm
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "../recipes.h"

#ifndef N
#define N 52850 /* -DN=8000: without the largest sets */
#endif
#define MAXTET (8 * N)
#define QUERIES 10000
#define SETS 5

static tess_real p[3 * N];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static double rw[TESS_LRW(N)], value[N], g[3 * N], old[3 * N], work[9 * N];
static tess_int n, ntet;
static long seed = 1;

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* random01 - a random number, 0 < x < 1: x := 16807 x mod 2^31 - 1. */
static double random01(void)
{
    seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
    if (seed < 0) seed += 2147483647;
    return (double)seed / 2147483647.0;
}

/* make - about m points: at random in the unit cube; a lattice, turned; at
 * random between two spheres, turned; clusters; a rough terrain, turned. */
static void make(int set, int m)
{
    double x[3], c[3] = {0.0, 0.0, 0.0}, r;
    int i, k, side = (int)(exp(log((double)m) / 3.0) + 0.5);

    n = set == 1 ? side * side * side : m;
    for (i = 0; i < n; i++) {
        do
            for (k = 0; k < 3; k++) x[k] = random01();
        while (set == 2 && !(dot(x, x) > 0.01 && dot(x, x) < 1.0));
        if (set == 1) {
            x[0] = (double)(i % side) / (double)side;
            x[1] = (double)(i / side % side) / (double)side;
            x[2] = (double)(i / side / side) / (double)side;
        }
        r = sqrt(dot(x, x));
        if (set == 2) r /= 0.9 + 0.1 * random01();
        for (k = 0; k < 3 && set == 2; k++) x[k] /= r;
        for (k = 0; k < 3 && set == 3; k++) {
            if (i % 50 == 0) c[k] = x[k];
            x[k] = c[k] + 0.1 * x[k] * x[k] * x[k];
        }
        if (set == 4) x[2] = 0.2 * sin(7.0 * x[0]) * x[1] + 0.01 * x[2];
        r = x[0];
        if (set == 1 || set == 2 || set == 4) {
            x[0] = 0.8 * r - 0.6 * x[1];
            x[1] = 0.6 * r + 0.8 * x[1];
            r = x[1];
            x[1] = 0.96 * r - 0.28 * x[2];
            x[2] = 0.28 * r + 0.96 * x[2];
        }
        for (k = 0; k < 3; k++) p[3 * i + k] = (tess_real)x[k];
    }
}

/* The fields: linear, quadratic, smooth; R. Franke's, as R. J. Renka gives it
 * in space. */
static double field(int which, const double *q)
{
    double x = q[0], y = q[1], z = q[2];

    if (which == 0) return 7.0 + 2.0 * x - 3.0 * y + 0.5 * z;
    if (which == 1) return x * x - 2.0 * y * y + z * z / 2.0 + x * y - y * z;
    if (which == 2) return sin(5.0 * x) * cos(4.0 * y) + sin(3.0 * z + x);
    x *= 9.0;
    y *= 9.0;
    z *= 9.0;
    return 0.75 * exp(-((x - 2.0) * (x - 2.0) + (y - 2.0) * (y - 2.0) +
                        (z - 2.0) * (z - 2.0)) / 4.0) +
           0.75 * exp(-(x + 1.0) * (x + 1.0) / 49.0 - (y + 1.0) / 10.0 -
                      (z + 1.0) / 10.0) +
           0.5 * exp(-((x - 7.0) * (x - 7.0) + (y - 3.0) * (y - 3.0) +
                       (z - 5.0) * (z - 5.0)) / 4.0) -
           0.2 * exp(-(x - 4.0) * (x - 4.0) - (y - 7.0) * (y - 7.0) -
                     (z - 5.0) * (z - 5.0));
}

static double place(tess_int i, int k)
{
    return (double)p[3 * i + k];
}

static void sample(int which)
{
    double q[3];
    tess_int i;
    int k;

    for (i = 0; i < n; i++) {
        for (k = 0; k < 3; k++) q[k] = place(i, k);
        value[i] = field(which, q);
    }
}

static int mesh(void)
{
    return tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw);
}

static int slope(int rounds)
{
    return tr_slopes(n, p, ntet, tet, adj, value, rounds, g, work);
}

/* compare - roots of the mean squares of the errors of linear interpolation
 * and of bent, at random in the points' box shrunk by margin at each side. */
static void compare(int which, double margin, double *linear, double *rms)
{
    static const double none[3 * N] = {0.0};
    double lo[3], hi[3], q[3], f[2], want, sum[2];
    tess_real at[3];
    tess_int i, t = TESS_NONE;
    int j, k, used = 0;

    sum[0] = sum[1] = 0.0;
    for (k = 0; k < 3; k++) {
        lo[k] = hi[k] = place(0, k);
        for (i = 1; i < n; i++) {
            if (place(i, k) < lo[k]) lo[k] = place(i, k);
            if (place(i, k) > hi[k]) hi[k] = place(i, k);
        }
    }
    for (j = 0; j < QUERIES; j++) {
        for (k = 0; k < 3; k++) {
            at[k] = (tess_real)(lo[k] + (hi[k] - lo[k]) *
                                (margin + (1.0 - 2.0 * margin) * random01()));
            q[k] = (double)at[k];
        }
        if (tr_bent(p, ntet, tet, adj, value, none, 0.0, at, &t, f) != 0 ||
            tr_bent(p, ntet, tet, adj, value, g, 0.0, at, &t, f + 1) != 0)
            continue;
        want = field(which, q);
        for (k = 0; k < 2; k++) sum[k] += (f[k] - want) * (f[k] - want);
        used++;
    }
    *linear = sqrt(sum[0] / used);
    *rms = sqrt(sum[1] / used);
}

/* A linear field comes out as it is: places to 1e-12, slopes to what the
 * values' rounding makes of them where points are 1e-4 apart. */
static int test_linear(void)
{
    double linear, rms;
    tess_int i;
    int set, bad = 0;

    for (set = 0; set < SETS; set++) {
        make(set, 1000);
        sample(0);
        bad |= mesh() != 0 || slope(3) != 0;
        compare(0, 0.0, &linear, &rms);
        bad |= !(rms <= 1e-12);
        for (i = 0; i < n; i++)
            bad |= iw[i] == i && !(fabs(g[3 * i] - 2.0) <= 1e-11 &&
                                   fabs(g[3 * i + 1] + 3.0) <= 1e-11 &&
                                   fabs(g[3 * i + 2] - 0.5) <= 1e-11);
    }
    return bad;
}

/* What the header promises of errors. */
static int test_errors(void)
{
    double linear, rms;
    int set, m, bad = 0;

    make(0, 8000);
    bad |= mesh();
    sample(1);
    bad |= slope(15);
    compare(1, 0.0, &linear, &rms);
    bad |= !(rms <= 0.03 * linear);
    sample(3);
    bad |= slope(3);
    compare(3, 0.01, &linear, &rms);
    bad |= !(rms <= 0.25 * linear);
    if (N >= 52850) {
        make(0, N);
        bad |= mesh();
        sample(2);
        bad |= slope(15);
        compare(2, 0.01, &linear, &rms);
        bad |= !(rms <= 0.07 * linear);
    }
    for (set = 0; set < SETS; set++)
        for (m = 500; m < N / 10; m *= 3) {
            make(set, m);
            bad |= mesh();
            sample(2);
            bad |= slope(3);
            compare(2, 0.0, &linear, &rms);
            bad |= !(rms <= linear);
            bad |= slope(15);
            compare(2, 0.0, &linear, &rms);
            bad |= !(rms <= linear);
        }
    return bad;
}

/* misfit - S of the header. */
static double misfit(void)
{
    double e[3], d, s, sum = 0.0;
    tess_int t, a, b;
    int j, k, l;

    for (t = 0; t < ntet; t++)
        for (j = 0; j < 3; j++)
            for (l = j + 1; l < 4; l++) {
                a = tet[4 * t + j];
                b = tet[4 * t + l];
                for (k = 0; k < 3; k++) e[k] = place(b, k) - place(a, k);
                s = (dot(g + 3 * a, e) + dot(g + 3 * b, e)) / 2.0;
                d = value[b] - value[a] - s;
                sum += d * d / dot(e, e);
            }
    return sum;
}

/* A round never makes S larger, whatever the field. */
static int test_rounds(void)
{
    double before, after;
    tess_int i;
    int set, rounds, bad = 0;

    for (set = 0; set < SETS; set++) {
        make(set, 300);
        bad |= mesh();
        for (i = 0; i < n; i++) value[i] = random01();
        bad |= slope(0);
        for (before = misfit(), rounds = 1; rounds < 100;
             rounds += 1 + rounds / 4) {
            bad |= slope(rounds);
            after = misfit();
            bad |= !(after <= before);
            before = after;
        }
    }
    return bad;
}

/* Places outside get the field of the hull's nearest point, or go on from
 * there; at a point the field is the data. */
static int test_places(void)
{
    tess_real q[3];
    tess_int i, t = TESS_NONE, v;
    double f[3], h[3], w[4], nearest;
    int j, k, l, bad = 0;

    make(0, 1000);
    bad |= mesh();
    sample(2);
    bad |= slope(3);
    for (i = 0; i < n; i++) {
        bad |= tr_bent(p, ntet, tet, adj, value, g, 1.0, p + 3 * i, &t, f) != 0;
        bad |= f[0] != value[i];
    }
    for (j = 0; j < 1000; j++) {
        for (k = 0; k < 3; k++) q[k] = (tess_real)(3.0 * random01() - 1.0);
        for (k = 0; k < 3; k++)
            l = tr_bent(p, ntet, tet, adj, value, g, k / 2.0, q, &t, f + k);
        bad |= l != tess_locate(p, ntet, tet, adj, q, &t, w);
        if (l == 0) {
            bad |= f[0] != f[1] || f[0] != f[2];
            continue;
        }
        /* the gradient's way beyond, and the hull's point by tess_locate */
        for (h[0] = h[1] = h[2] = 0.0, k = 0; k < 12; k++)
            h[k % 3] += w[k / 3] * place(tet[4 * t + k / 3], k % 3);
        for (nearest = f[2] - f[0], k = 0; k < 4; k++) {
            v = tet[4 * t + k];
            for (l = 0; l < 3; l++)
                nearest -= w[k] * g[3 * v + l] * ((double)q[l] - h[l]);
        }
        bad |= !(fabs(nearest) <= 1e-12);
        bad |= !(fabs(f[1] - (f[0] + f[2]) / 2.0) <= 1e-12);
    }
    return bad;
}

/* Coordinates times a power of two: the same field, to the last bit; so too
 * four points, whose gradient is that of a tetrahedron. */
static int test_sizes(void)
{
    static const tess_real corner[12] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0,
                                         0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
    double f[2], scale;
    tess_real q[3];
    tess_int i, t = TESS_NONE;
    int j, k, bad = 0;

    n = 4;
    for (k = 0; k < 12; k++) p[k] = corner[k];
    sample(0);
    bad |= mesh() != 0 || slope(3) != 0;
    for (i = 0; i < 4; i++)
        bad |= !(fabs(g[3 * i] - 2.0) + fabs(g[3 * i + 1] + 3.0) +
                     fabs(g[3 * i + 2] - 0.5) <= 1e-12);
    /* 2^166 is 9e49; its square and the inverse of that are doubles */
    if (sizeof(tess_real) < sizeof(double)) return bad;
    make(0, 500);
    sample(2);
    bad |= mesh() != 0 || slope(15) != 0;
    for (i = 0; i < 3 * n; i++) old[i] = g[i];
    for (k = 0; k < 3; k++) q[k] = (tess_real)(0.3 + 0.1 * k);
    bad |= tr_bent(p, ntet, tet, adj, value, g, 0.0, q, &t, f) != 0;
    for (j = -1; j < 2; j += 2) {
        scale = ldexp(1.0, 166 * j);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 3; k++) q[k] = (tess_real)((double)q[k] * scale);
        bad |= mesh() != 0 || slope(15) != 0;
        for (i = 0; i < 3 * n; i++)
            bad |= !(fabs(g[i] * scale - old[i]) <= 1e-12);
        bad |= tr_bent(p, ntet, tet, adj, value, g, 0.0, q, &t, f + 1) != 0;
        bad |= !(fabs(f[1] - f[0]) <= 1e-12);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] / scale);
        for (k = 0; k < 3; k++) q[k] = (tess_real)((double)q[k] / scale);
    }
    return bad;
}

/* Linear fields in sets that are flat, and in units of any size: each side of
 * the box has its part of the field.  A gradient that no double holds has a
 * code. */
static int test_flat(void)
{
    static const double box[8][3] = {
        {1.0, 1.0, 1e-3}, {1.0, 1.0, 1e-6}, {1.0, 1e-10, 1.0},
        {1.0, 1.0, 1e-15}, {1.0, 1.0, 1e-30}, {1e-160, 1.0, 1.0},
        {1e-160, 1e-160, 1e-160}, {1e150, 1e150, 1e150}};
    double low[3], c[3], x[3], w[4], sum, f, want;
    tess_real q[3];
    tess_int i, t;
    int set, turned, j, k, v, bad = 0;

    if (sizeof(tess_real) < sizeof(double)) return bad;
    for (set = 0; set < 16; set++) {
        turned = set % 2;
        make(turned || set % 4 ? 0 : 1, 343);
        for (i = 0; i < n; i++) {
            for (k = 0; k < 3; k++) x[k] = place(i, k) * box[set / 2][k];
            for (k = 0; k < 2 && turned; k++) {
                sum = x[k];
                x[k] = 0.8 * sum - 0.6 * x[k + 1];
                x[k + 1] = 0.6 * sum + 0.8 * x[k + 1];
            }
            for (k = 0; k < 3; k++) p[3 * i + k] = (tess_real)x[k];
        }
        bad |= mesh();
        for (k = 0; k < 3; k++) {
            low[k] = c[k] = place(0, k);
            for (i = 0; i < n; i++) {
                if (place(i, k) < low[k]) low[k] = place(i, k);
                if (place(i, k) > c[k]) c[k] = place(i, k);
            }
            c[k] = (k - 1.5) / (c[k] - low[k]);
        }
        for (i = 0; i < n; i++)
            for (value[i] = 7.0, k = 0; k < 3; k++)
                value[i] += c[k] * (place(i, k) - low[k]);
        bad |= slope(3) != 0;
        t = TESS_NONE;
        for (j = 0; j < 500; j++) {
            v = (int)(random01() * (double)ntet);
            for (sum = 0.0, k = 0; k < 4; k++) sum += w[k] = random01();
            for (want = 7.0, k = 0; k < 3; k++) {
                for (x[k] = 0.0, i = 0; i < 4; i++)
                    x[k] += w[i] / sum * place(tet[4 * v + i], k);
                q[k] = (tess_real)x[k];
                want += c[k] * ((double)q[k] - low[k]);
            }
            v = tr_bent(p, ntet, tet, adj, value, g, 0.0, q, &t, &f);
            bad |= (v != 0 && v != 1) || !(fabs(f - want) <= 1e-12);
        }
    }
    make(0, 300);
    for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * 1e-300);
    for (i = 0; i < n; i++) value[i] = 1e10 * (double)(i % 7);
    return bad | (mesh() != 0) | (slope(3) != TESS_RANGE);
}

/* Bad arguments, damaged and unfinished meshes get a code. */
static int test_codes(void)
{
    tess_int held, t = TESS_NONE;
    double f;
    int bad = 0;

    make(0, 500);
    sample(2);
    bad |= mesh();
    held = tet[77];
    tet[77] = n;
    bad |= slope(3) != TESS_BAD_INDEX;
    tet[77] = -1;
    bad |= slope(3) != TESS_BAD_INDEX;
    tet[77] = held;
    bad |= slope(-1) != -7;
    bad |= tr_slopes(0, p, ntet, tet, adj, value, 3, g, work) != -1;
    bad |= tr_slopes(n, p, 0, tet, adj, value, 3, g, work) != -3;
    bad |= tr_bent(p, 0, tet, adj, value, g, 0.0, p, &t, &f) != -2;
    bad |= tess(n, p, 200, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw) != TESS_MORE;
    bad |= slope(3) != TESS_BAD_OPEN;
    return bad;
}

/* table - errors and times, for people. */
static void table(FILE *to)
{
    static const char *const name[4] = {"linear", "quadratic", "smooth",
                                        "Franke's"};
    static const double margin[2] = {0.0, 0.01};
    static const int rounds[3] = {0, 3, 15};
    double linear, rms, seconds;
    clock_t begin;
    int m, which, r, j;

    fprintf(to, "Points at random in the unit cube; rms errors in the hull, "
                "and 0.01 inside the cube\n");
    for (m = 8000; m <= N; m += 44850) {
        make(0, m);
        begin = clock();
        if (mesh()) return;
        seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
        fprintf(to, "%d points, tess %.3f s\n", m, seconds);
        fprintf(to, "field      rounds  slopes/tess   linear    bent  ratio"
                    "   linear    bent  ratio\n");
        for (which = 1; which < 4; which++) {
            sample(which);
            for (r = 0; r < 3; r++) {
                begin = clock();
                if (slope(rounds[r])) return;
                fprintf(to, "%-9s  %6d  %11.2f", name[which], rounds[r],
                        (double)(clock() - begin) / CLOCKS_PER_SEC / seconds);
                for (j = 0; j < 2; j++) {
                    compare(which, margin[j], &linear, &rms);
                    fprintf(to, "  %.1e %.1e  %.3f", linear, rms,
                            rms / linear);
                }
                fprintf(to, "\n");
            }
        }
    }
}

int main(int argc, char **argv)
{
    static int (*const test[7])(void) = {test_linear, test_errors,
                                         test_rounds, test_places,
                                         test_sizes,  test_flat, test_codes};
    static const char *const name[7] = {
        "slopes: linear fields as they are:                ",
        "slopes: errors as promised; never above linear's: ",
        "slopes: no round makes the misfit larger:         ",
        "bent: the data at the points, and what is outside:",
        "bent: any size of coordinates, four points:       ",
        "slopes: linear fields in flat sets, in any units: ",
        "codes: bad arguments, damage, unfinished meshes:  "};
    clock_t begin;
    int k, one, bad = 0;

    if (argc > 1 && strcmp(argv[1], "table") == 0) {
        table(stdout);
        return 0;
    }
    for (k = 0; k < 7; k++) {
        begin = clock();
        one = test[k]();
        bad |= one;
        printf("%s  %s\n", name[k], one ? "NO" : "yes");
        fprintf(stderr, "%s  %.2f s\n", name[k],
                (double)(clock() - begin) / CLOCKS_PER_SEC);
    }
    return bad != 0;
}
