/* t_derived.c - tests of derived.c: against brute force, and by identities that
 * hold for any set of points.  Linked with twin/recipes.c it tests derived.f.
 *
 *   cc -O2 -I. -o t_derived test/recipes/t/t_derived.c \
 *       test/recipes/derived.c tess.c hhpred.c -lm
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "../recipes.h"

#define N 343
#define MAXTET (12 * N)
#define MAXEDG (2 * MAXTET)
#define MAXFAC (4 * MAXTET)
#define ROUNDING 1e-11 /* of coordinates of at most 1 */
#define QUERIES 1000

static tess_real p[3 * N];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static double rw[TESS_LRW(N)];
static tess_int edge[2 * MAXEDG], at[MAXEDG], face[3 * MAXFAC];
static tess_int both[2 * MAXFAC], hull[3 * MAXFAC];
static tess_int first[N + 1], list[4 * MAXTET], outer[N];
static double area[MAXEDG], region[N], flux[3 * N], value[N];
static char seen[N][N];
static tess_int n, ntet, nedge, nface, nhull;
static long seed = 1;

/* The edges of a tetrahedron: numbers of their vertices. */
static const int around[6][2] = {{0, 1}, {0, 2}, {0, 3},
                                 {1, 2}, {1, 3}, {2, 3}};

static void minus(const tess_real *a, const tess_real *b, double *c)
{
    int k;

    for (k = 0; k < 3; k++) c[k] = (double)a[k] - (double)b[k];
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* random01 - a random number, 0 <= x < 1, of 26 bits. */
static double random01(void)
{
    long high;

    seed = (seed * 3877 + 29573) % 139968;
    high = seed % 8192;
    seed = (seed * 3877 + 29573) % 139968;
    return ((double)high + (double)(seed % 8192) / 8192.0) / 8192.0;
}

/* make - points: at random in a cube; on a lattice of 7 a side; at random
 * between two spheres. */
static const char *make(int set)
{
    static const char *const name[3] = {"random", "lattice", "shell"};
    double x[3], r;
    tess_int i;
    int k;

    n = set == 1 ? 343 : 300;
    for (i = 0; i < n; i++) {
        do
            for (k = 0; k < 3; k++) x[k] = 2.0 * random01() - 1.0;
        while (set == 2 && !(dot(x, x) > 0.01 && dot(x, x) < 1.0));
        r = set == 2 ? (0.8 + 0.2 * random01()) / sqrt(dot(x, x)) : 1.0;
        for (k = 0; k < 3; k++) x[k] *= r;
        if (set == 1) {
            x[0] = (double)(i % 7) / 8.0;
            x[1] = (double)(i / 7 % 7) / 8.0;
            x[2] = (double)(i / 49) / 8.0;
        }
        for (k = 0; k < 3; k++) p[3 * i + k] = (tess_real)x[k];
    }
    return name[set];
}

/* Seven tests; each returns 1 when it fails. */

static int test_edges(void)
{
    tess_int i, t, pairs = 0, a, b, used = 0;
    int e, bad = 0;

    for (a = 0; a < n; a++)
        for (b = 0; b < n; b++) seen[a][b] = 0;
    for (t = 0; t < ntet; t++)
        for (e = 0; e < 6; e++) {
            a = tet[4 * t + around[e][0]];
            b = tet[4 * t + around[e][1]];
            if (!seen[a][b]) pairs++;
            seen[a][b] = seen[b][a] = 1;
        }
    bad |= pairs != nedge;
    for (i = 0; i < nedge; i++) {
        a = edge[2 * i];
        b = edge[2 * i + 1];
        if (seen[a][b] != 1) bad = 1; /* or told twice */
        seen[a][b] = seen[b][a] = 2;
        for (e = t = 0; e < 4; e++)
            t += tet[4 * at[i] + e] == a || tet[4 * at[i] + e] == b;
        if (t != 2) bad = 1;
    }
    /* Euler: a ball */
    for (i = 0; i < n; i++) used += first[i + 1] > first[i];
    return bad | (used - nedge + nface - ntet != 1);
}

static int has(tess_int t, tess_int i)
{
    const tess_int *v = tet + 4 * t;

    return v[0] == i || v[1] == i || v[2] == i || v[3] == i;
}

static int test_faces(void)
{
    tess_int i, boundary = 0;
    int k, bad = 0;

    for (i = 0; i < nface; i++) {
        for (k = 0; k < 3; k++)
            if (!has(both[2 * i], face[3 * i + k]) ||
                (both[2 * i + 1] >= 0 &&
                 !has(both[2 * i + 1], face[3 * i + k])))
                bad = 1;
        if (both[2 * i] == both[2 * i + 1]) bad = 1;
        boundary += both[2 * i + 1] < 0;
    }
    return bad || boundary != nhull || 2 * nface != 4 * ntet + nhull;
}

static int test_stars(void)
{
    tess_int i, j;
    int bad = first[0] != 0 || first[n] != 4 * ntet;

    for (i = 0; i < n; i++)
        for (j = first[i]; j < first[i + 1]; j++)
            if (!has(list[j], i) || (j > first[i] && list[j] <= list[j - 1]))
                bad = 1;
    return bad;
}

static double squared(const tess_real *q, tess_int i)
{
    double d[3];

    minus(p + 3 * i, q, d);
    return dot(d, d);
}

static int test_nearest(void)
{
    tess_real q[3];
    tess_int i, v = 0;
    int j, k, bad = 0;

    for (j = 0; j < QUERIES; j++) {
        for (k = 0; k < 3; k++) q[k] = (tess_real)(3.0 * random01() - 1.0);
        v = tr_nearest(p, tet, first, list, q, j % 2 ? v : tet[0]);
        for (i = 0; i < n; i++)
            if (squared(q, i) < (1.0 - 1e-14) * squared(q, v)) bad = 1;
    }
    return bad;
}

/* whole - the volume of the hull, from its facets. */
static double whole(void)
{
    double a[3], b[3], c[3], d[3], sum = 0.0;
    tess_int i;

    for (i = 0; i < nhull; i++) {
        minus(p + 3 * hull[3 * i], p, a);
        minus(p + 3 * hull[3 * i + 1], p, b);
        minus(p + 3 * hull[3 * i + 2], p, c);
        cross(b, c, d);
        sum += dot(a, d) / 6.0;
    }
    return sum;
}

/* The centre of a tetrahedron of size 1 and volume V is known to about
 * eps / V^2 at worst: where that is too little nothing is asked. */
static int test_measure(void)
{
    double volume, c[3], radius, d[3], sum = 0.0, far, slack;
    tess_int t, i;
    int k, bad = 0;

    for (t = 0; t < ntet; t++) {
        tr_measure(p, tet + 4 * t, &volume, c, &radius);
        if (!(volume > 0.0)) bad = 1;
        sum += volume;
        slack = 1e-15 * (1.0 + radius) / (volume * volume);
        /* no point is in the ball, the vertices are on it */
        for (i = 0; i < n; i++) {
            for (k = 0; k < 3; k++) d[k] = (double)p[3 * i + k] - c[k];
            far = sqrt(dot(d, d)) - radius;
            if (far < -slack || (has(t, i) && far > slack)) bad = 1;
        }
    }
    return bad || fabs(sum - whole()) > ROUNDING;
}

/* The cells fill the hull; the faces of a cell that has an end are closed: the
 * sum of their normals times areas is 0; on the lattice, of spacing 1/8, a
 * cell is a cube, and of the edges those along the axes alone have a face. */
static int test_dual(int lattice)
{
    double sum = 0.0, e[3], length, want;
    tess_int i, inner = 0;
    int k, bad = 0;

    for (i = 0; i < 3 * n; i++) flux[i] = 0.0;
    for (i = 0; i < nedge; i++) {
        minus(p + 3 * edge[2 * i + 1], p + 3 * edge[2 * i], e);
        length = sqrt(dot(e, e));
        for (k = 0; k < 3; k++) {
            flux[3 * edge[2 * i] + k] += e[k] * area[i] / length;
            flux[3 * edge[2 * i + 1] + k] -= e[k] * area[i] / length;
        }
        want = length > 0.13 ? 0.0 : 1.0 / 64.0;
        if (lattice && !outer[edge[2 * i]] &&
            fabs(area[i] - want) > ROUNDING)
            bad = 1;
        if (!outer[edge[2 * i]] && area[i] < -ROUNDING) bad = 1;
    }
    for (i = 0; i < n; i++) {
        sum += region[i];
        if (outer[i]) continue;
        inner++;
        for (k = 0; k < 3; k++)
            if (fabs(flux[3 * i + k]) > ROUNDING) bad = 1;
        if (!(region[i] > 0.0)) bad = 1;
        if (lattice && fabs(region[i] - 1.0 / 512.0) > ROUNDING) bad = 1;
    }
    for (i = 0; i < nhull; i++) bad |= !outer[hull[3 * i]];
    return bad || (lattice && inner != 125) || fabs(sum - whole()) > ROUNDING;
}

/* Points times a power of two have balls and cells times it. */
static int test_sizes(void)
{
    static double areas[MAXEDG], regions[N];
    double volume[2], c[2][3], radius[2], scale;
    tess_int t, i;
    int j, k, bad = 0;

    for (j = -1; j < 2 && sizeof(tess_real) == sizeof(double); j += 2) {
        scale = ldexp(1.0, 300 * j);
        for (t = 0; t < ntet; t++) {
            for (k = 0; k < 2; k++) {
                tr_measure(p, tet + 4 * t, volume + k, c[k], radius + k);
                for (i = 0; i < 12; i++)
                    p[3 * tet[4 * t + i / 3] + i % 3] *=
                        (tess_real)(k == 0 ? scale : 1.0 / scale);
            }
            bad |= !(volume[0] == volume[1] / scale / scale / scale) ||
                   !(radius[0] == radius[1] / scale);
            for (k = 0; k < 3; k++) bad |= !(c[0][k] == c[1][k] / scale);
        }
        for (i = 0; i < 3 * n; i++) p[i] *= (tess_real)scale;
        tr_dual(n, p, tet, adj, nedge, edge, at, areas, regions, outer);
        for (i = 0; i < 3 * n; i++) p[i] /= (tess_real)scale;
        for (i = 0; i < nedge; i++)
            bad |= !(areas[i] / scale / scale == area[i]);
        for (i = 0; i < n; i++)
            bad |= !(regions[i] / scale / scale / scale == region[i]);
    }
    return bad;
}

/* A linear field's gradient comes out as it is. */
static int test_gradient(void)
{
    static const double want[3] = {2.0, -3.0, 0.5};
    double g[3], e[3], c[3], volume, radius;
    tess_int t, i;
    int k, bad = 0;

    for (i = 0; i < n; i++)
        value[i] = 7.0 + want[0] * (double)p[3 * i] +
                   want[1] * (double)p[3 * i + 1] +
                   want[2] * (double)p[3 * i + 2];
    for (t = 0; t < ntet; t++) {
        tr_measure(p, tet + 4 * t, &volume, c, &radius);
        tr_gradient(p, tet + 4 * t, value, g);
        for (k = 0; k < 3; k++)
            if (fabs(g[k] - want[k]) > 1e-14 / volume) bad = 1;
    }
    /* any field: the gradient times an edge is the difference along it */
    for (i = 0; i < n; i++) value[i] = random01();
    for (t = 0; t < ntet; t++) {
        tr_measure(p, tet + 4 * t, &volume, c, &radius);
        tr_gradient(p, tet + 4 * t, value, g);
        for (k = 1; k < 4; k++) {
            minus(p + 3 * tet[4 * t + k], p + 3 * tet[4 * t], e);
            if (fabs(dot(g, e) + value[tet[4 * t]] - value[tet[4 * t + k]]) >
                1e-14 / volume)
                bad = 1;
        }
    }
    return bad;
}

int main(void)
{
    const char *name;
    tess_int i, cells;
    int set, code, bad = 0;

    printf("set      points  tetrahedra  edges  faces  hull facets  inner "
           "cells\n");
    for (set = 0; set < 3; set++) {
        name = make(set);
        code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw,
                    TESS_LRW(N), rw);
        if (code != TESS_OK ||
            tess_hull(ntet, tet, adj, MAXFAC, &nhull, hull) != 0 ||
            tr_edges(ntet, tet, adj, MAXEDG, &nedge, edge, at) != 0 ||
            tr_faces(ntet, tet, adj, MAXFAC, &nface, face, both) != 0) {
            printf("the arrays are too short: code %d\n", code);
            return 1;
        }
        tr_stars(n, ntet, tet, first, list);
        tr_dual(n, p, tet, adj, nedge, edge, at, area, region, outer);
        for (cells = n, i = 0; i < n; i++) cells -= outer[i];
        printf("%-7s  %6ld  %10ld  %5ld  %5ld  %11ld  %11ld\n", name, (long)n,
               (long)ntet, (long)nedge, (long)nface, (long)nhull,
               (long)cells);
        bad |= test_edges() | test_faces() << 1 | test_stars() << 2 |
               test_nearest() << 3 | test_measure() << 4 |
               test_dual(set == 1) << 5 | test_gradient() << 6 |
               test_sizes() << 7;
    }
    printf("edges: those of brute force; Euler's formula:     %s\n"
           "faces: each once, of both tetrahedra:             %s\n"
           "stars: all tetrahedra of each point:              %s\n"
           "nearest: as brute force:                          %s\n"
           "measure: volumes fill the hull, balls are empty:  %s\n"
           "dual: cells are closed and fill the hull:         %s\n"
           "gradient: of linear fields, and along edges:      %s\n"
           "sizes: balls and cells of 1e-90 and 1e90:         %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes", bad & 8 ? "NO" : "yes",
           bad & 16 ? "NO" : "yes", bad & 32 ? "NO" : "yes",
           bad & 64 ? "NO" : "yes", bad & 128 ? "NO" : "yes");
    return bad != 0;
}
