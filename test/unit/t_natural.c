/* t_natural.c - the recipes of test/recipes/natural.c, on points of all kinds:
 * identities that hold for any set of points, weights in closed form, fields
 * that are reproduced, and codes.  -quick: of a third of the kinds, -brief: of
 * a sixth; fewer queries where roundings hide cells.
 *
 * With -DFORTRAN linked with the routines of natural.f, f77/tess.f and
 * f77/hhpred.f: these are tested instead, and differ from those of C by
 * roundings alone. */
#include "../recipes/natural.c"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../lib/exact.h"
#include "../lib/points.h"

#define N 1000
#define MAXTET (40 * N)
#define MOST 4000
#define QUERIES 400
#define WORK (13 * MOST + 15)

static tess_real p[3 * N];
static tess_int n, ntet, tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static tess_int nn, nbr[MOST + 3], work[WORK];
static double rw[TESS_LRW(N)], real[WORK], value[N], g[3 * N];
static double weights[2][MOST + 3];
static int quick;

#ifdef FORTRAN
extern void trnatu_(double *p, tess_int *ntet, tess_int *tet, tess_int *adj,
                    double *q, tess_int *t, tess_int *most, tess_int *nn,
                    tess_int *nbr, double *sibson, double *laplac,
                    tess_int *iw, double *rw, tess_int *info);
extern void trblen_(double *p, tess_int *nn, tess_int *nbr, double *w,
                    double *value, double *g, double *out);

static tess_int tet1[4 * MAXTET], adj1[4 * MAXTET];

/* changed - the mesh has: FORTRAN's arrays, counted from 1. */
static void changed(void)
{
    tess_int i;

    for (i = 0; i < 4 * ntet; i++) {
        tet1[i] = tet[i] + 1;
        adj1[i] = adj[i] + 1;
    }
}

/* both - FORTRAN's weights, and whether C's are the same. */
static int both(tess_real *q, tess_int *t, tess_int most)
{
    static tess_int nbr1[MOST + 3];
    static double other[2][MOST + 3];
    tess_int i, k, code, info, start = *t + 1, nn1;

    code = tr_natural(p, ntet, tet, adj, q, t, most, &nn, nbr, other[0],
                      other[1], work, real);
    trnatu_(p, &ntet, tet1, adj1, q, &start, &most, &nn1, nbr1, weights[0],
            weights[1], work, real, &info);
    i = info == code && nn1 == nn && (nn == 0 || start == *t + 1);
    for (k = 0; k < nn && i; k++)
        i = nbr1[k] == nbr[k] + 1 && fabs(weights[0][k] - other[0][k]) < 1e-9 &&
            fabs(weights[1][k] - other[1][k]) < 1e-9;
    if (!i) test_that(0, "FORTRAN", "as C");
    return (int)info;
}

static double smooth(const double *w)
{
    static tess_int nbr1[MOST + 3];
    static double w1[MOST + 3];
    double out;
    tess_int i;

    for (i = 0; i < nn; i++) {
        nbr1[i] = nbr[i] + 1;
        w1[i] = w[i];
    }
    trblen_(p, &nn, nbr1, w1, value, g, &out);
    if (!(fabs(out - tr_blend(p, nn, nbr, w, value, g)) <= 1e-12 * fabs(out)))
        test_that(0, "FORTRAN", "blend as C's");
    return out;
}
#else
static void changed(void) { }

static int both(tess_real *q, tess_int *t, tess_int most)
{
    return tr_natural(p, ntet, tet, adj, q, t, most, &nn, nbr, weights[0],
                      weights[1], work, real);
}

static double smooth(const double *w)
{
    return tr_blend(p, nn, nbr, w, value, g);
}
#endif

/* meshed - of the points as they are. */
static int meshed(void)
{
    int code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                    rw);

    changed();
    return code;
}

/* mesh - of n points, turned about no axis in particular, moved and scaled. */
static int mesh(int turned, double scale)
{
    double x, y, z, u, v;
    tess_int i;

    for (i = 0; i < n; i++) {
        x = (double)p[3 * i];
        y = (double)p[3 * i + 1];
        z = (double)p[3 * i + 2];
        u = turned ? cos(0.7) * x - sin(0.7) * y + 1.0 : x;
        v = turned ? sin(0.7) * x + cos(0.7) * y : y;
        p[3 * i] = (tess_real)(scale * u);
        p[3 * i + 1] = (tess_real)(scale * (turned ? cos(0.4) * v -
                                            sin(0.4) * z + 2.0 : v));
        p[3 * i + 2] = (tess_real)(scale * (turned ? sin(0.4) * v +
                                            cos(0.4) * z + 3.0 : z));
    }
    return meshed();
}

/* weigh - are both weights at least 0, their sum 1, and q their mean to
 * within slack? */
static int weigh(const tess_real *q, double slack)
{
    double mean[3], sum;
    tess_int i;
    int k, m, good = nn > 0;

    for (m = 0; m < 2; m++) {
        sum = mean[0] = mean[1] = mean[2] = 0.0;
        for (i = 0; i < nn; i++) {
            if (!(weights[m][i] >= 0.0)) good = 0;
            sum += weights[m][i];
            for (k = 0; k < 3; k++)
                mean[k] += weights[m][i] *
                           ((double)p[3 * nbr[i] + k] - (double)q[k]);
        }
        if (!(fabs(sum - 1.0) < 1e-12)) good = 0;
        for (k = 0; k < 3; k++)
            if (!(fabs(mean[k]) <= slack)) good = 0;
    }
    return good;
}

/* Queries in tetrahedra, on their faces, edges and hardly inside them; on and
 * beside the hull; anywhere; at the points. */
static void family(const char *name, int turned)
{
    double b[4], sum, box = 0.0, w[4], x[3], m[4];
    tess_real q[3];
    tess_int i, j, t, u, v;
    int k, kind, code, good[6], face;

    n = (tess_int)points_make(name, N, 1, p);
    code = n > 0 ? mesh(turned, 1.0) : -1;
    test_that(code == 0, name, "mesh");
    if (code != 0) return;
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++)
            if (fabs((double)p[3 * i + k] - (double)p[k]) > box)
                box = fabs((double)p[3 * i + k] - (double)p[k]);
    for (k = 0; k < 4; k++) m[k] = rnd_unit();
    for (i = 0; i < n; i++) {
        value[i] = 0.0;
        for (k = 0; k < 3; k++) {
            x[k] = ((double)p[3 * i + k] - (double)p[k]) / box;
            value[i] += m[k] * x[k] + m[3] * x[k] * x[k];
            g[3 * i + k] = (m[k] + 2.0 * m[3] * x[k]) / box;
        }
    }
    for (k = 0; k < 6; k++) good[k] = 1;
    for (i = 0; i < QUERIES; i++) {
        kind = (int)(i % 4);
        u = (tess_int)(rnd_unit() * (double)ntet);
        face = (int)(rnd_unit() * 4.0);
        for (sum = 0.0, k = 0; k < 4; k++) {
            b[k] = kind == 3 ? 1.0 - 3.0 * rnd_unit() : rnd_unit();
            if (kind == 1 && (k != face || i % 3 == 0) && rnd_unit() < 0.5)
                b[k] *= i % 8 < 4 ? 0.0 : 1e-13;
        }
        if (kind == 2) { /* the next tetrahedron with a facet on the hull */
            while (adj[4 * u] >= 0 && adj[4 * u + 1] >= 0 &&
                   adj[4 * u + 2] >= 0 && adj[4 * u + 3] >= 0)
                u = (u + 1) % ntet;
            for (k = 0; adj[4 * u + k] >= 0; k++) continue;
            b[k] *= pow(10.0, -15.0 * rnd_unit()) * (i % 3 > 0 ? 1.0 : 0.0);
        }
        for (k = 0; k < 4; k++) sum += b[k];
        if (!(fabs(sum) > 1e-3)) continue;
        for (k = 0; k < 3; k++) {
            for (x[k] = 0.0, j = 0; j < 4; j++)
                x[k] += b[j] / sum * (double)p[3 * tet[4 * u + j] + k];
            q[k] = (tess_real)x[k];
        }
        t = i % 5 ? u : TESS_NONE;
        code = both(q, &t, MOST);
        v = TESS_NONE;
        if (tess_locate(p, ntet, tet, adj, q, &v, w) != code) good[0] = 0;
        if (code == 1) /* the hull's point nearest to it */
            for (k = 0; k < 3; k++) {
                x[k] = 0.0;
                for (j = 0; j < 4; j++)
                    x[k] += w[j] * (double)p[3 * tet[4 * v + j] + k];
                q[k] = (tess_real)x[k];
            }
        if (!weigh(q, 1e-12 * box)) good[1 + kind / 2] = 0;
        for (sum = 0.0, k = 0; k < 3; k++) {
            x[k] = ((double)q[k] - (double)p[k]) / box;
            sum += m[k] * x[k] + m[3] * x[k] * x[k];
        }
        for (k = 0; k < 2; k++)
            if (!(fabs(smooth(weights[k]) - sum) <
                  (kind < 2 && code == 0 ? 1e-9 : 1e-5)))
                good[3] = 0;
    }
    for (i = 0; i < n; i += 1 + n / QUERIES) {
        t = TESS_NONE;
        if (both(p + 3 * i, &t, MOST) != 0) good[4] = 0;
        for (j = 0; j < nn; j++)
            if (weights[0][j] != (nbr[j] == iw[i]) ||
                weights[1][j] != (nbr[j] == iw[i]))
                good[4] = 0;
        if (smooth(weights[0]) != value[iw[i]]) good[5] = 0;
    }
    test_that(good[0], name, "the codes of tess_locate");
    test_that(good[1], name, "inside");
    test_that(good[2], name, "at the hull, and beyond");
    test_that(good[3], name, "blend: a + b.x + c |x|^2");
    test_that(good[4], name, "weight 1 at the points");
    test_that(good[5], name, "blend at the points");
}

/* Sets where roundings hide cells: points in n[k] steps along axis k, at random
 * for none, times size[k]; the first ones moved away by up to 1e9; turned. */
static const struct {
    const char *name;
    int steps[3], away, turned;
    double size[3];
} hidden[] = {
    {"turned lattice", {7, 6, 4}, 0, 1, {0.1, 0.1, 0.1}},
    {"turned box", {7, 4, 4}, 0, 1, {1.0, 1.0, 1.0}},
    {"sphere", {0, 0, -1}, 0, 1, {1.0, 1.0, 1.0}},
    {"outliers", {0, 0, 0}, 2, 0, {1.0, 1.0, 1.0}},
    {"more outliers", {0, 0, 0}, 8, 1, {1.0, 1.0, 1.0}},
    {"an axis of 1e-160", {0, 0, 0}, 0, 0, {1.0, 1.0, 1e-160}},
    {"a lattice of 1e-160", {7, 7, 7}, 0, 0, {0.1, 0.1, 1e-160}},
    {"flat to rounding", {0, 0, 0}, 0, 1, {1.0, 1.0, 1e-16}},
    {"almost flat", {0, 0, 0}, 0, 1, {1.0, 1.0, 1e-5}},
    {"tiny", {0, 0, 0}, 0, 0, {1e-150, 1e-150, 1e-150}},
    {"huge", {0, 0, 0}, 0, 0, {1e150, 1e150, 1e150}}
};
#define HIDDEN (int)(sizeof hidden / sizeof hidden[0])

/* Queries within units in the last place of points, edges, facets, or in
 * tetrahedra, and at all distances from these: no weight is negative, their
 * sum is 1, and q is their mean.  Outliers lie on one side, z > 0: what their
 * weights could be is bounded by that. */
static void hide(int set)
{
    double x[3], b[4], sum, box = 0.0, step;
    tess_real q[3];
    tess_int i, t, v;
    int j, k, m, code, good = 1, near = 1;

    n = 343;
    for (k = 0; k < 3; k++)
        if (hidden[set].steps[0] > 0) n = k ? n * hidden[set].steps[k]
                                            : hidden[set].steps[0];
    for (i = 0; i < n; i++) {
        for (v = i, k = 0; k < 3; k++) {
            j = hidden[set].steps[k];
            x[k] = j > 0 ? (double)(v % j) : rnd_unit();
            if (j > 0) v /= j;
        }
        if (hidden[set].steps[2] < 0) {
            for (sum = 0.0, k = 0; k < 3; k++) {
                x[k] = 2.0 * x[k] - 1.0;
                sum += x[k] * x[k];
            }
            for (k = 0; k < 3; k++) x[k] /= sqrt(sum);
        }
        for (k = 0; k < 3 && i < hidden[set].away; k++)
            x[k] = (k == 2 ? x[k] + 0.1 : 2.0 * x[k] - 1.0) * 1e9;
        for (k = 0; k < 3; k++)
            p[3 * i + k] = (tess_real)(hidden[set].size[k] * x[k]);
    }
    code = mesh(hidden[set].turned, 1.0);
    test_that(code == 0, hidden[set].name, "mesh");
    if (code != 0) return;
    for (i = 0; i < 3 * n; i++)
        if (fabs((double)p[i] - (double)p[i % 3]) > box)
            box = fabs((double)p[i] - (double)p[i % 3]);
    for (i = 0; i < (quick ? 3 : 10) * QUERIES; i++) {
        t = (tess_int)(rnd_unit() * (double)ntet);
        for (sum = 0.0, k = 0; k <= i % 4; k++) sum += b[k] = rnd_unit();
        step = i % 8 < 4 ? 0.1 * pow(10.0, -16.0 * rnd_unit()) : 0.0;
        for (k = 0; k < 3; k++) {
            for (x[k] = 0.0, j = 0; j <= i % 4; j++)
                x[k] += b[j] / sum * (double)p[3 * tet[4 * t + j] + k];
            if (i % 4 == 0) x[k] = (double)p[3 * tet[4 * t] + k];
            x[k] += (rnd_unit() - 0.5) * step * hidden[set].size[k];
            x[k] *= 1.0 + DBL_EPSILON * (double)(int)(6.0 * rnd_unit() - 3.0);
            q[k] = (tess_real)x[k];
        }
        t = TESS_NONE;
        code = both(q, &t, MOST);
        if (code == 1) continue;
        if (code != 0 || !weigh(q, 1e-12 * box)) good = 0;
        for (k = 0; k < 3 && fabs(x[k]) < 5.0; k++) continue;
        for (j = 0; j < nn && k == 3; j++)
            for (m = 0; m < 2; m++)
                if (nbr[j] < hidden[set].away && weights[m][j] > 1e-7)
                    near = 0;
    }
    test_that(good, hidden[set].name, "sum 1, and q the mean");
    test_that(near, hidden[set].name, "no weight far away");
}

/* Between the points (0,0,0) and (1,0,0) of the integer lattice q's cell is
 * that of the prism |y|, |z| <= 1/2 from x = s/2 to (1 + s)/2, and on it
 * wedges of height s (x - s/2) up to x = 1/2, and likewise from the other
 * end; what they have in common is cut off by the plane towards (0,1,1). */
static void lattice(int turned, double scale)
{
    static const double s = 0.3125;
    double want[2][2][3], sum[2] = {0.0, 0.0}, r;
    tess_real saved[3];
    tess_int i, j, t = TESS_NONE;
    int end, far, m, good = 1;

    for (n = 36, i = 0; i < n; i++) {
        p[3 * i] = (tess_real)(i % 4 - 1);
        p[3 * i + 1] = (tess_real)(i / 4 % 3 - 1);
        p[3 * i + 2] = (tess_real)(i / 12 - 1);
    }
    p[3 * n] = (tess_real)s; /* q turns with them */
    p[3 * n + 1] = p[3 * n + 2] = 0;
    n++;
    mesh(turned, scale);
    n--;
    memcpy(saved, p + 3 * n, sizeof saved);
    test_that(meshed() == 0, "lattice", "mesh");
    test_that(both(saved, &t, MOST) == 0, "lattice", "code");
    for (end = 0; end < 2; end++) {
        r = end ? 1.0 - s : s;
        want[0][end][0] = (1.0 - r) / 2.0;
        want[0][end][1] = r * (1.0 - r) * (1.0 - r) / 8.0;
        want[0][end][2] = r * r * pow(1.0 - r, 3.0) / 48.0;
        want[1][end][0] = 1.0 / r;
        want[1][end][1] = (1.0 - r) / 2.0;
        want[1][end][2] = r * (1.0 - r) * (1.0 - r) / 8.0;
        for (m = 0; m < 2; m++)
            sum[m] += want[m][end][0] + 4.0 * want[m][end][1] +
                      4.0 * want[m][end][2];
    }
    for (j = 0; j < nn; j++) {
        i = nbr[j];
        end = (int)(i % 4) - 1;
        far = (i / 4 % 3 != 1) + (i / 12 != 1);
        for (m = 0; m < 2; m++) {
            r = end == 0 || end == 1 ? want[m][end][far] / sum[m] : 0.0;
            if (!(fabs(weights[m][j] - r) < 1e-13)) good = 0;
        }
    }
    test_that(good && nn >= 18, "lattice", "weights in closed form");
}

/* The kink of a field along a line through a point and off it: the sum of the
 * slopes outwards goes to 0 with the step; that of the linear one does not. */
static void kinks(void)
{
    double kink[3][2], step, d[3], sum, jump[3];
    tess_real q[3];
    tess_int i, j, t;
    int k, m, side, rounds = 0, good = 1;

    n = (tess_int)points_make("uniform", N, 1, p);
    test_that(mesh(0, 1.0) == 0, "uniform", "mesh");
    for (i = 0; i < n; i++) {
        value[i] = sin(9.0 * (double)p[3 * i]) + (double)p[3 * i + 1];
        for (k = 0; k < 3; k++) g[3 * i + k] = 0.0;
        g[3 * i] = 9.0 * cos(9.0 * (double)p[3 * i]);
        g[3 * i + 1] = 1.0;
    }
    for (m = 0; m < 3; m++) kink[m][0] = kink[m][1] = 0.0;
    for (i = 0; i < n; i++) {
        for (sum = 0.0, k = 0; k < 3; k++) {
            d[k] = rnd_unit() - 0.5;
            sum += fabs((double)p[3 * i + k] - 0.5) > 0.3;
        }
        if (sum > 0.0) continue;
        rounds++;
        for (m = 0; m < 2; m++) {
            step = m ? 1e-6 : 1e-3;
            jump[0] = jump[1] = -2.0 * value[i];
            for (side = -1; side < 2; side += 2) {
                for (k = 0; k < 3; k++)
                    q[k] = (tess_real)((double)p[3 * i + k] +
                                       side * step * d[k]);
                t = TESS_NONE;
                if (both(q, &t, MOST) != 0) good = 0;
                jump[0] += smooth(weights[0]);
                for (j = 0; j < nn; j++)
                    jump[1] += weights[0][j] * value[nbr[j]];
            }
            for (k = 0; k < 2; k++) kink[k][m] += fabs(jump[k]) / step;
        }
    }
    test_that(good && rounds > 50, "uniform", "codes of steps");
    test_that(kink[0][1] < 0.01 * kink[0][0], "uniform", "blend has no kinks");
    test_that(kink[1][1] > 0.5 * kink[1][0], "uniform", "linear ones have");
}

/* Too little room; open facets; damage; bad arguments; four points. */
static void codes(void)
{
    static tess_int kept[4 * MAXTET];
    tess_real q[3];
    tess_int i, t, whole, most;
    int k, code, good, seen;
    double w[4];

    n = (tess_int)points_make("uniform", N, 1, p);
    test_that(mesh(0, 1.0) == 0, "codes", "mesh");
    for (k = 0; k < 3; k++) q[k] = (tess_real)(0.45 + 0.02 * k);
    t = TESS_NONE;
    test_that(both(q, &t, MOST) == 0, "codes", "room");
    whole = nn;
    for (good = 1, most = 1; most < 200; most++) {
        code = both(q, &t, most);
        if (code == 0) break;
        if (code != TESS_POOL || nn != 0) good = 0;
    }
    test_that(good && code == 0 && nn == whole && most > 4, "codes",
              "TESS_POOL");
    test_that(both(q, &t, 0) == -7, "codes", "most");
    t = ntet;
    test_that(both(q, &t, MOST) == -6, "codes", "start");
    t = 0;
    q[1] = (tess_real)HUGE_VAL;
    test_that(both(q, &t, MOST) == -5, "codes", "infinity");
    memcpy(kept, adj, sizeof kept);
    for (good = 1, seen = 0, i = 0; i < 400; i++) {
        memcpy(adj, kept, sizeof kept);
        for (k = 0; k < 3; k++) q[k] = (tess_real)rnd_unit();
        t = TESS_NONE;
        if (tess_locate(p, ntet, tet, adj, q, &t, w) != 0) continue;
        k = (int)(rnd_unit() * 4.0);
        adj[4 * t + k] = i % 4 == 0 ? TESS_OPEN
                       : i % 4 == 1 ? ntet
                       : i % 4 == 2 ? -7
                                    : (tess_int)(rnd_unit() * (double)ntet);
        changed();
        code = both(q, &t, MOST);
        if (code != (i % 4 == 0 ? TESS_BAD_OPEN : -4)) good = 0;
        seen++;
    }
    test_that(good && seen > 100, "codes", "open facets and damage");
    /* an unfinished result, and damage anywhere: a code, weights or not, but
     * an end, and nothing out of bounds */
    for (i = 0; i < 400; i++) {
        memcpy(adj, kept, sizeof kept);
        for (k = 0; k < 40; k++)
            adj[(tess_int)(rnd_unit() * 4.0 * (double)ntet)] =
                (tess_int)(rnd_unit() * (double)ntet);
        changed();
        for (k = 0; k < 3; k++) q[k] = (tess_real)rnd_unit();
        t = TESS_NONE;
        both(q, &t, 100);
    }
    tess(n, p, ntet / 2, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N), rw);
    changed();
    for (good = 0, i = 0; i < 400; i++) {
        for (k = 0; k < 3; k++) q[k] = (tess_real)rnd_unit();
        t = TESS_NONE;
        code = both(q, &t, MOST);
        good += code == TESS_BAD_OPEN;
        if (code == 0 && !weigh(q, 1e-7)) good = -1000;
    }
    test_that(good > 10, "codes", "unfinished");
    n = 4;
    test_that(mesh(1, 1.0) == 0, "four points", "mesh");
    for (good = 1, i = 0; i < 100; i++) {
        for (w[3] = 1.0, k = 0; k < 3; k++)
            w[3] -= w[k] = rnd_unit() / 3.0;
        for (k = 0; k < 3; k++)
            q[k] = (tess_real)(w[0] * (double)p[3 * tet[0] + k] +
                               w[1] * (double)p[3 * tet[1] + k] +
                               w[2] * (double)p[3 * tet[2] + k] +
                               w[3] * (double)p[3 * tet[3] + k]);
        t = 0;
        if (both(q, &t, MOST) != 0 || !weigh(q, 1e-14)) good = 0;
    }
    test_that(good, "four points", "weights");
}

int main(int argc, char **argv)
{
    static const char *const families[] = {"uniform", "clusters", "lattice",
        "jitlattice", "bcc", "fcc", "lattice01", "spherenorm", "cylinder",
        "prism", "gridrot", "gradedrot", "gridsph", "gridcyl", "extruded",
        "globe", "stations", "shells", "rottetin", "cubesurf", "duplicates",
        "pairs", "twoscale", "decimal3", 0};
    int i;

    quick = test_quick(argc, argv);
    lattice(0, 1.0);
    lattice(1, 1.0);
    lattice(1, 1e50);
    lattice(1, 1e-50);
    kinks();
    codes();
    for (i = 0; i < HIDDEN; i++) hide(i);
    for (i = 0; families[i]; i++) {
        if (quick && i % (3 * quick)) continue;
        family(families[i], 0);
        family(families[i], 1);
    }
    return test_end();
}
