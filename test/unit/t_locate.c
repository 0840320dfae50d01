/* t_locate.c - tests of tess_locate and tess_values: places inside, outside, on
 * vertices, edges and facets, and their weights by exact ratios of volumes; the
 * points of the hull nearest to places outside; values of many places; ways that
 * cannot arrive.
 *
 *     t_locate          all tests
 *     t_locate -quick   fewer, for slow builds
 */
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- locate ---- */

/* The weights against exact ratios of volumes: 12 eps by hh_weigh, and what the
 * ratio is rounded. */
static void verify_weights(const result *r, tess_int t, const double *q,
                           const double *w, const int *side)
{
    static ex_num part, whole;
    const double *v[4], *u[4];
    double sum = 0.0, x;
    int low = EX_NO_LOW, i, j, k, e, f;

    for (k = 0; k < 4; k++) {
        v[k] = at(r, r->tet[4 * t + k]);
        for (j = 0; j < 3; j++) low = ex_low(v[k][j], ex_low(q[j], low));
    }
    ex_volume(&whole, low, v[0], v[1], v[2], v[3]);
    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) u[i] = i == k ? q : v[i];
        ex_volume(&part, low, u[0], u[1], u[2], u[3]);
        require(part.sign == side[k], "test of locate itself");
        x = (double)(ex_value(&part, &e) / ex_value(&whole, &f));
        x = ldexp(x, e - f);
        require(fabs(w[k] - x) <= 16.0 * DBL_EPSILON * x + DBL_MIN, "a weight");
        sum += w[k];
    }
    require(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON,
            "the weights do not sum to one");
}

/* Does one of the tetrahedra hold q, or its boundary? */
static int held_by_one(const result *r, const double *q)
{
    const double *v[4], *u[4];
    tess_int t;
    int i, j, k;

    for (t = 0; t < r->ntet; t++) {
        for (k = 0; k < 4; k++) v[k] = at(r, r->tet[4 * t + k]);
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 4; k++)
                if (v[k][i] <= q[i]) break;
            for (j = 0; j < 4; j++)
                if (v[j][i] >= q[i]) break;
            if (k == 4 || j == 4) break;
        }
        if (i < 3) continue;
        for (k = 0; k < 4; k++) {
            for (i = 0; i < 4; i++) u[i] = i == k ? q : v[i];
            if (ex_orient(u[0], u[1], u[2], u[3]) < 0) break;
        }
        if (k == 4) return 1;
    }
    return 0;
}

/* The points in doubles. */
static const double *doubles(const result *r)
{
    static double all[3 * 600];
    tess_int i;

    if (r->n > 600) exit(2);
    for (i = 0; i < 3 * r->n; i++) all[i] = (double)r->p[i];
    return all;
}

/* Is q outside of a facet of t that is of the hull, or open, and has all
 * vertices of the sum set of 2^k? */
static int outside(const result *r, tess_int t, int set, const double *q)
{
    const double *p = doubles(r);
    tess_int f[3];
    int k;

    for (k = 0; k < 4; k++) {
        facet(r, t, k, f);
        if (r->adj[4 * t + k] < 0 && (set >> k & 1) == 0 &&
            ex_orient(p + 3 * f[0], p + 3 * f[1], p + 3 * f[2], q) > 0)
            return 1;
    }
    return 0;
}

/* The weights of a place outside: those of the point nearest to q of the
 * hull. */
static void verify_outside(const result *r, tess_int t, const double *q,
                           const double *w)
{
    const double *p = doubles(r), *v[4];
    double x[4], sum = 0.0;
    int set = 0, k;

    for (k = 0; k < 4; k++) {
        v[k] = p + 3 * r->tet[4 * t + k];
        require(w[k] >= 0.0, "outside, a weight is negative");
        set += w[k] > 0.0 ? 1 << k : 0;
        sum += w[k];
    }
    require(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON,
            "outside, the weights do not sum to one");
    require(outside(r, t, set, q), "tess_locate: q is not outside of t's hull "
            "facet");
    require(ex_nearest(4, v, q, (long)r->n, p, x) == set && set > 0,
            "the vertices of the hull's nearest point");
    for (k = 0; k < 4; k++)
        require(fabs(w[k] - x[k]) <= 32.0 * DBL_EPSILON * x[k],
                "a weight of the hull's nearest point");
}

/* Locate q from there.  expected: 0 inside, 1 outside, -1 not known; the code
 * is returned.  In an unfinished result it may be -4, and what else it is, is
 * right all the same. */
static int locate(const result *r, const double *q, tess_int from,
                  int expected, int unfinished)
{
    tess_real z[3];
    double w[4], x[3];
    const double *v[4], *u[4];
    tess_int t = from;
    int code, i, k, side[4];

    for (k = 0; k < 3; k++) {
        /* volatile: a compiler was seen to optimize the rounding away */
        volatile tess_real rounded = (tess_real)q[k];

        z[k] = rounded;
        x[k] = (double)z[k];
    }
    code = tess_locate(r->p, r->ntet, r->tet, r->adj, z, &t, w);
    if (unfinished && code == -4) return code;
    if (t < 0 || t >= r->ntet || code < 0 || code > 1) {
        fail("tess_locate's t or code");
        return -1;
    }
    require(expected < 0 || code == expected, "tess_locate: in or out");
    if (code == 1) {
        verify_outside(r, t, x, w);
        return code;
    }
    for (k = 0; k < 4; k++) v[k] = at(r, r->tet[4 * t + k]);
    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) u[i] = i == k ? x : v[i];
        side[k] = ex_orient(u[0], u[1], u[2], u[3]);
    }
    require(side[0] >= 0 && side[1] >= 0 && side[2] >= 0 && side[3] >= 0,
            "tess_locate: q is not in t");
    verify_weights(r, t, x, w, side);
    from = t;
    t = rnd_below(4) ? (tess_int)rnd_below((int)r->ntet) : TESS_NONE;
    code = tess_locate(r->p, r->ntet, r->tet, r->adj, z, &t, w);
    require((code == 0 && t == from) || (unfinished && code == -4),
            "tess_locate from another start");
    return code;
}

/* Turn the points by odd angles and move them off the origin. */
static void turned(result *r)
{
    double size = 0.0, x, y, z;
    tess_int i;

    for (i = 0; i < 3 * r->n; i++)
        if (fabs((double)r->p[i]) > size) size = fabs((double)r->p[i]);
    for (i = 0; i < r->n; i++) {
        x = r->p[3 * i];
        y = 0.6 * x + 0.8 * r->p[3 * i + 1];
        x = 0.8 * x - 0.6 * r->p[3 * i + 1];
        z = r->p[3 * i + 2];
        r->p[3 * i] = (tess_real)(x + 3.1 * size);
        r->p[3 * i + 1] = (tess_real)(cos(0.4) * y - sin(0.4) * z + 1.7 * size);
        r->p[3 * i + 2] = (tess_real)(sin(0.4) * y + cos(0.4) * z - 0.3 * size);
    }
}

/* The hull's facets: 4 t + k for the one opposite to vertex k of t. */
static tess_int *hull_of(const result *r, tess_int *many)
{
    tess_int *hull = ints(4 * r->ntet), i;

    for (i = *many = 0; i < 4 * r->ntet; i++)
        if (r->adj[i] < 0) hull[(*many)++] = i;
    return hull;
}

#define OUTER 12

/* q outside, or nearly so, beside the facet i of the hull, of points whose box
 * has this size and middle. */
static void beside(const result *r, tess_int i, int kind, double size,
                   const double *middle, double *q)
{
    static const double far[4] = { 1e-12, 0.01, 1.0, 1e6 };
    /* a needle's computed normal may be 0 */
    double a[3][3], n[3], w[3], length = DBL_MIN, off;
    tess_int v[3];
    int j, k;

    facet(r, i / 4, (int)(i % 4), v);
    for (j = 0; j < 3; j++) memcpy(a[j], at(r, v[j]), sizeof a[j]);
    for (k = 0; k < 3; k++) {
        int l = (k + 1) % 3, m = (k + 2) % 3;

        n[k] = (a[1][l] - a[0][l]) * (a[2][m] - a[0][m]) -
               (a[1][m] - a[0][m]) * (a[2][l] - a[0][l]);
        if (fabs(n[k]) > length) length = fabs(n[k]);
    }
    off = far[kind / 3] * size;
    switch (kind % 3) {
    case 0:
        /* above a vertex, a place on an edge, or inside, by the normal: in
         * coordinates of few bits exactly */
        j = rnd_below(3);
        w[0] = w[1] = w[2] = 0.0;
        w[j] = 1.0;
        if (rnd_below(3)) {
            w[j] = 0.25 * (1 + rnd_below(3));
            w[(j + 1) % 3] = 1.0 - w[j];
        }
        if (rnd_below(3) == 0)
            for (k = 0; k < 3; k++) w[k] = k == j ? 0.5 : 0.25;
        break;
    case 1:
        /* in its plane, as far away */
        for (j = 0; j < 2; j++) w[j] = (rnd_unit() - 0.5) * 2.0 * off / size;
        if (rnd_below(2)) w[0] = floor(4.0 * w[0]);
        if (rnd_below(2)) w[1] = floor(4.0 * w[1]);
        w[2] = 1.0 - w[0] - w[1];
        off = 0.0;
        break;
    default:
        /* beyond an edge or a vertex, away from the middle */
        j = rnd_below(3);
        w[0] = w[1] = w[2] = 0.0;
        w[j] = rnd_below(2) ? 1.0 : rnd_unit();
        w[(j + 1) % 3] = 1.0 - w[j];
        length = size;
        for (k = 0; k < 3; k++)
            n[k] = w[0] * a[0][k] + w[1] * a[1][k] + w[2] * a[2][k] - middle[k];
        break;
    }
    for (k = 0; k < 3; k++)
        q[k] = w[0] * a[0][k] + w[1] * a[1][k] + w[2] * a[2][k] +
               off * (n[k] / length);
}

static void test_locate(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "clusters", "cubesurf", "planespread", "bcc",
        "spherenorm", "twolines", "aniso", "offset", "duplicates",
        "gridrot", "globe", "rotcube", "slanted", "rottet", "cubegrid", "prism",
        "moment", "ellipsoid", NULL
    };
    char name[64];
    result r;
    double q[3], lo[3], hi[3], middle[3], w[4], size;
    tess_int i, j, t, n, *hull, many, out;
    int f, k, m, code, turn, met[3];

    for (f = 0; family[f] != NULL; f++)
    for (turn = 0; turn < 2; turn++) {
        faults = 0;
        current = NULL;
        sprintf(name, "%s%s", family[f], turn ? ", turned" : "");
        points(&r, family[f], affordable(family[f], quick ? 100 : 250), 6);
        if (turn) turned(&r);
        solve(&r);
        current = &r;
        if (r.code != TESS_OK) {
            require(sizeof(tess_real) < sizeof(double), "a code");
            release(0);
            continue;
        }
        n = r.n;
        size = 0.0;
        for (k = 0; k < 3; k++) {
            lo[k] = hi[k] = (double)r.p[k];
            for (i = 0; i < n; i++) {
                if (r.p[3 * i + k] < lo[k]) lo[k] = (double)r.p[3 * i + k];
                if (r.p[3 * i + k] > hi[k]) hi[k] = (double)r.p[3 * i + k];
            }
            if (hi[k] - lo[k] > size) size = hi[k] - lo[k];
            middle[k] = 0.5 * (lo[k] + hi[k]);
        }
        hull = hull_of(&r, &many);
        out = 0;
        for (m = 0; m < (quick ? 10 : 40) * OUTER && faults < 5; m++) {
            t = rnd_below(2) ? TESS_NONE : (tess_int)rnd_below((int)r.ntet);
            beside(&r, hull[rnd_below((int)many)], m % OUTER, size, middle, q);
            out += locate(&r, q, t, -1, 0) == 1;
        }
        require(faults > 0 || 2 * out > m, "few places are outside");
        for (m = 0; m < (quick ? 100 : 1000) && faults < 5; m++) {
            int want = -1; /* 0 inside, 1 outside, -1 not known */

            t = m % 2 ? TESS_NONE : (tess_int)rnd_below((int)r.ntet);
            i = (tess_int)rnd_below((int)n);
            j = (tess_int)rnd_below((int)n);
            switch (m % 5) {
            case 0:
                /* a point of the box widened by a half */
                for (k = 0; k < 3; k++)
                    q[k] = lo[k] + (hi[k] - lo[k]) *
                           (1.5 * rnd_unit() - 0.25);
                for (k = 0; k < 3; k++)
                    if (q[k] < lo[k] || q[k] > hi[k]) want = 1;
                break;
            case 1:
                /* a point of the set */
                for (k = 0; k < 3; k++) q[k] = (double)r.p[3 * i + k];
                want = 0;
                break;
            case 2:
                /* halfway between two of them, rounded */
                for (k = 0; k < 3; k++)
                    q[k] = 0.5 * ((double)r.p[3 * i + k] +
                                  (double)r.p[3 * j + k]);
                break;
            case 3:
                /* far outside */
                for (k = 0; k < 3; k++)
                    q[k] = lo[k] + (hi[k] - lo[k]) *
                           (k == m / 5 % 3 ? 1000.0 : rnd_unit());
                want = 1;
                break;
            default:
                /* in the box's surface */
                for (k = 0; k < 3; k++)
                    q[k] = k == m / 5 % 3 ? lo[k]
                         : lo[k] + (hi[k] - lo[k]) * rnd_unit();
                break;
            }
            locate(&r, q, t, want, 0);
        }
        /* bad arguments leave nothing but the code */
        t = TESS_NONE;
        for (k = 0; k < 3; k++) {
            tess_real z[3];

            z[0] = r.p[0];
            z[1] = r.p[1];
            z[2] = r.p[2];
            require(tess_locate(r.p, 0, r.tet, r.adj, z, &t, w) == -2,
                    "tess_locate in nothing");
            t = r.ntet;
            require(tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w) == -6,
                    "tess_locate from t = ntet");
            t = -2;
            require(tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w) == -6,
                    "tess_locate from t = -2");
            t = TESS_NONE;
            z[k] = (tess_real)infinity();
            code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w);
            require(code == -5, "tess_locate of infinity");
            z[k] = (tess_real)(infinity() - infinity());
            code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &t, w);
            require(code == -5, "tess_locate of NaN");
        }
        current = NULL;
        release(0);
        done("locate", name);
    }
    /* an unfinished result: -4 where the walk meets an open facet */
    faults = met[0] = met[1] = met[2] = 0;
    points(&r, "uniform", 200, 3);
    solve(&r);
    t = r.ntet;
    release(1);
    for (i = 1; i < t; i += t / 10 + 1) {
        room(&r, i);
        run(&r);
        current = &r;
        for (m = 0; m < 300; m++) {
            for (k = 0; k < 3; k++) q[k] = (double)(float)rnd_unit();
            /* or a vertex, which is at the end of a tetrahedron's box */
            if (m % 3 == 0) {
                j = r.tet[rnd_below((int)(4 * i))];
                for (k = 0; k < 3; k++) q[k] = (double)r.p[3 * j + k];
            }
            /* a place outside of the hull, too */
            if (m % 7 == 0) q[m % 3] += 2.0;
            code = locate(&r, q,
                          m % 2 ? TESS_NONE : (tess_int)rnd_below((int)i),
                          -1, 1);
            met[code < 0 ? 2 : code]++;
            require(code != 0 || held_by_one(&r, q), "q is in none");
        }
        release(1);
    }
    require(met[0] > 100 && met[1] > 10 && met[2] > 100,
            "places in it, outside of the hull, behind open facets");
    current = NULL;
    release(0);
    test_result("tess_locate in an unfinished result", faults);
}

/* ---- many places ---- */

#define PLACES 60

/* tess_values against tess_locate one by one. */
static void one_values(const result *r, const tess_real *q, tess_int nv,
                       const tess_int *start)
{
    int keep = narrays, code, k, c, outer = 0;
    tess_int *t = ints(PLACES), *u = ints(PLACES), *one = ints(PLACES), i, j;
    double *value = (double *)array((size_t)(nv * r->n) * sizeof *value);
    double *out = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double *again = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double *alone = (double *)array((size_t)(nv * PLACES) * sizeof *out);
    double w[4], sum, size;
    int single[PLACES];

    for (i = 0; i < nv * r->n; i++) value[i] = 2.0 * rnd_unit() - 1.0;
    /* a constant, which no rounding may alter */
    for (i = 0; i < r->n && nv > 1; i++) value[nv * i] = 0.1;
    memcpy(t, start, PLACES * sizeof *t);
    code = tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, PLACES, q, t,
                       out);
    require(code == 0 || code == 1, "tess_values' code");
    memcpy(u, t, PLACES * sizeof *t);
    /* given back */
    require(tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, PLACES, q, u,
                        again) == code, "tess_values' code from its own t");
    /* one at a time */
    memcpy(one, start, PLACES * sizeof *one);
    for (i = 0; i < PLACES; i++) {
        if (i > 0 && one[i] == TESS_NONE) one[i] = one[i - 1];
        single[i] = tess_values(r->p, r->ntet, r->tet, r->adj, nv, value, 1,
                                q + 3 * i, one + i, alone + nv * i);
    }
    require(memcmp(one, t, PLACES * sizeof *t) == 0 &&
                memcmp(alone, out, (size_t)(nv * PLACES) * sizeof *out) == 0,
            "tess_values' t or values one at a time");
    for (i = 0; i < PLACES; i++) {
        tess_int s = i % 2 ? TESS_NONE : (tess_int)rnd_below((int)r->ntet);

        c = tess_locate(r->p, r->ntet, r->tet, r->adj, q + 3 * i, &s, w);
        if (c == 1) outer = 1;
        require(single[i] == c, "tess_values' code one at a time");
        if (c == 0) require(t[i] == s && u[i] == s, "tess_values' t");
        if (c == 1) {
            /* marked, so that each query's own code is known */
            t[i] = -2 - t[i];
            u[i] = -2 - u[i];
            require(t[i] >= 0 && t[i] < r->ntet && u[i] >= 0 &&
                    u[i] < r->ntet, "tess_values' mark of a place outside");
            if (t[i] < 0 || u[i] < 0) continue;
        }
        for (k = 0; k < 4 && c == 1; k++)
            require(w[k] == 0.0 ||
                    (slot_of(r->tet + 4 * t[i], r->tet[4 * s + k]) < 4 &&
                     slot_of(r->tet + 4 * u[i], r->tet[4 * s + k]) < 4),
                    "tess_values' t outside");
        for (j = 0; j < nv; j++) {
            for (k = 0, sum = size = 0.0; k < 4; k++) {
                double x = w[k] * value[nv * r->tet[4 * s + k] + j];

                sum += x;
                size += fabs(x);
            }
            require(fabs(out[nv * i + j] - sum) <= 16.0 * DBL_EPSILON * size &&
                    fabs(again[nv * i + j] - sum) <= 16.0 * DBL_EPSILON * size,
                    "tess_values' value");
            require(c == 1 || out[nv * i + j] == again[nv * i + j],
                    "tess_values from its own t");
            require(j > 0 || nv == 1 || out[nv * i] == 0.1,
                    "tess_values of a constant");
        }
    }
    require(code == outer, "tess_values' code");
    require(overrun() == 0, "tess_values: an array is overrun");
    release(keep);
}

static void values_code(const result *r, tess_int ntet, tess_int nv,
                        tess_int nq, const tess_real *q, const tess_int *start,
                        int want, const char *what)
{
    int keep = narrays;
    tess_int *t = ints(PLACES);
    double *value = (double *)array((size_t)(3 * r->n) * sizeof *value);
    double *out = (double *)array((size_t)(3 * PLACES) * sizeof *out);

    memset(value, 0, (size_t)(3 * r->n) * sizeof *value);
    memcpy(t, start, PLACES * sizeof *t);
    require(tess_values(r->p, ntet, r->tet, r->adj, nv, value, nq, q, t, out) ==
            want, what);
    require(memcmp(t, start, PLACES * sizeof *t) == 0 &&
            untouched(out, 3 * PLACES * sizeof *out),
            "tess_values: written all the same");
    release(keep);
}

static void test_values(void)
{
    static const char *const family[] = {
        "uniform", "cubesurf", "rotcube", "duplicates", "gridrot", "bcc", NULL
    };
    result r;
    tess_real q[3 * PLACES], held;
    tess_int start[PLACES], t[PLACES], i, u;
    double out[PLACES];
    int f, k, round, code;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        points(&r, family[f], 300, 4);
        if (f % 2) turned(&r);
        solve(&r);
        current = &r;
        for (round = 0; round < 9; round++) {
            for (i = 0; i < PLACES; i++) {
                const tess_int *v = r.tet + 4 * rnd_below((int)r.ntet);

                for (k = 0; k < 3; k++)
                    q[3 * i + k] = (tess_real)
                        (0.25 * r.p[3 * v[0] + k] + 0.25 * r.p[3 * v[1] + k] +
                         0.25 * r.p[3 * v[2] + k] + 0.25 * r.p[3 * v[3] + k]);
                /* in some rounds all are inside, or nearly so */
                if (round % 3 && i % 4 == round % 4)
                    q[3 * i] += (tess_real)(i % 8 ? 1e3 : -30.0);
                start[i] = rnd_below(2 + round) == 0
                         ? (tess_int)rnd_below((int)r.ntet) : TESS_NONE;
            }
            one_values(&r, q, round % 3 == 2 ? 3 : round / 3, start);
        }
        current = NULL;
        release(0);
        done("tess_values", family[f]);
    }
    faults = 0;
    points(&r, "uniform", 100, 4);
    solve(&r);
    current = &r;
    for (i = 0; i < PLACES; i++) {
        memcpy(q + 3 * i, r.p + 3 * i, 3 * sizeof *q);
        start[i] = i % 2 ? TESS_NONE : i;
    }
    values_code(&r, r.ntet, 1, 0, q, start, 0, "tess_values of none");
    values_code(&r, 0, 1, PLACES, q, start, -2, "tess_values in nothing");
    values_code(&r, -1, 1, PLACES, q, start, -2, "tess_values, ntet -1");
    values_code(&r, r.ntet, -1, PLACES, q, start, -5, "tess_values, nv -1");
    values_code(&r, r.ntet, 1, -1, q, start, -7, "tess_values, nq -1");
    values_code(&r, r.ntet, 1, largest() / 3 + 1, q, start, -7,
                "tess_values, nq too large");
    for (i = 0; i < 3 * PLACES; i += 3 * PLACES / 2 - 1)
        for (k = 0; k < 2; k++) {
            held = q[i];
            q[i] = (tess_real)(k ? infinity() : infinity() - infinity());
            values_code(&r, r.ntet, 1, PLACES, q, start, -8,
                        "tess_values of infinity or NaN");
            q[i] = held;
        }
    for (i = 0; i < PLACES; i += PLACES - 1)
        for (k = 0; k < 2; k++) {
            u = start[i];
            start[i] = k ? r.ntet : -2 - r.ntet;
            values_code(&r, r.ntet, 1, PLACES, q, start, -9,
                        "tess_values from no tetrahedron");
            start[i] = u;
        }
    /* the queries before the one that comes upon a neighbour out of range */
    for (i = 0; i < 4 * r.ntet; i++)
        if (r.adj[i] >= 0) r.adj[i] = r.ntet;
    for (i = 0; i < PLACES; i++) {
        t[i] = i < PLACES / 2 ? i : 0;
        out[i] = 7.0;
        for (k = 0; k < 3; k++)
            q[3 * i + k] = (tess_real)(0.25 * r.p[3 * r.tet[4 * i] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 1] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 2] + k] +
                                       0.25 * r.p[3 * r.tet[4 * i + 3] + k]);
    }
    {
        double *ones = (double *)array((size_t)r.n * sizeof *ones);

        for (i = 0; i < r.n; i++) ones[i] = 1.0;
        code = tess_values(r.p, r.ntet, r.tet, r.adj, 1, ones, PLACES, q, t,
                           out);
    }
    require(code == -4, "tess_values, a neighbour out of range");
    for (i = 0; i < PLACES; i++)
        require(i < PLACES / 2 ? t[i] == i && fabs(out[i] - 1.0) < 1e-14
                               : t[i] == 0 && out[i] == 7.0,
                "tess_values before and after -4");
    current = NULL;
    release(0);
    test_result("bad arguments of tess_values", faults);
}

/* ---- where a walk cannot arrive, and slivers ---- */

/* Ways in which a walk cannot arrive. */
static void test_lost(void)
{
    /* triangles about a middle one, turned so that from each the walk goes on
     * to the next, round and round; all joined to a point above.  The points
     * are not Delaunay. */
    static const double wheel[21] = {
        1, 0, 0, -0.5, 0.875, 0, -0.5, -0.875, 0, 9.375, -3.5, 0, -1.75, 9.875,
        0, -7.625, -6.375, 0, 0, 0, 5
    };
    static const double q[3] = { 0, 0, 1 };
    static const double bent[15] = {
        0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1
    };
    static const tess_int both[8] = { 0, 1, 2, 3, 1, 2, 3, 4 };
    static const double beyond[3] = { 0.5625, 0.53125, -0.5 };
    tess_int tet[32], adj[32], t, from, i;
    tess_real z[3];
    double w[4];
    result r;
    int k, code;

    faults = 0;
    tet[0] = 0;
    tet[1] = 1;
    tet[2] = 2;
    for (i = 0; i < 3; i++) {
        tess_int next = (i + 1) % 3, *a = tet + 4 * (1 + 2 * i), *b = a + 4;

        a[0] = next;
        a[1] = i;
        a[2] = 3 + i;
        b[0] = 3 + next;
        b[1] = next;
        b[2] = 3 + i;
    }
    for (i = 0; i < 7; i++) tet[4 * i + 3] = 6;
    given(&r, "a wheel", wheel, 7, tet, 7);
    current = &r;
    for (i = 0; i < 28; i++)
        require(r.tet[i] == tet[i], "the test's own wheel");
    require(locate(&r, q, 0, 0, 0) == 0, "a walk that need not begin");
    for (t = 1, k = 0; t < 7; t++) k += locate(&r, q, t, 0, 1) == -4;
    require(k > 0, "a walk that goes round");
    release(0);

    /* neighbours out of range where the walk comes */
    points(&r, "uniform", 100, 3);
    solve(&r);
    current = &r;
    for (k = 0; k < 2; k++) {
        r.tet = ints(4 * r.ntet);
        r.adj = ints(4 * r.ntet);
        run(&r);
        for (i = 0; i < 4 * r.ntet; i++)
            if (r.adj[i] != TESS_NONE)
                r.adj[i] = k ? r.ntet : TESS_OPEN - 1;
        for (i = 0; i < r.n; i++) {
            for (code = 0; code < 3; code++) z[code] = r.p[3 * i + code];
            for (t = 0; t < r.ntet; t += 17) {
                if (slot_of(r.tet + 4 * t, i) < 4) continue;
                from = t;
                code = tess_locate(r.p, r.ntet, r.tet, r.adj, z, &from, w);
                require(code == -4, "a neighbour out of range");
            }
        }
    }
    current = NULL;
    release(0);

    /* outside, neighbours that are out of range or do not match, where the way
     * to the nearest point turns about the edge 1 2 */
    for (k = 0; k < 4; k++)
        for (t = k < 3 ? TESS_NONE : 0; t < (k < 3 ? 2 : 1); t++) {
            given(&r, "two", bent, 5, both, 2);
            current = &r;
            locate(&r, beyond, t, 1, 0);
            /* (where the wrong neighbours are there is a right one) */
            for (i = 0; i < 32; i++) {
                tet[i] = r.tet[i / 4 == 4 ? i % 4 : 4 + i % 4];
                adj[i] = r.adj[i / 4 == 4 ? i % 4 : 4 + i % 4];
            }
            for (i = 16; i < 24; i++)
                if (adj[i] >= 0)
                    adj[i] = k == 0 ? 2 : k == 1 ? TESS_OPEN - 1 : i / 4 - 4;
            if (k == 3) {
                /* a facet with another vertex */
                memcpy(adj + 16, r.adj, 8 * sizeof *adj);
                tet[20 + slot_of(r.tet + 4, 2)] = 0;
            }
            for (i = 0; i < 3; i++) z[i] = (tess_real)beyond[i];
            from = t;
            code = tess_locate(r.p, 2, tet + 16, adj + 16, z, &from, w);
            require(code == -4, "outside, a neighbour out of range");
            current = NULL;
            release(0);
        }
    test_result("tess_locate where a walk cannot arrive", faults);
}

/* Weights in tetrahedra that are flat to rounding. */
static void test_slivers(void)
{
    result r;
    double p[12], c[3], w[4], x[3], sum;
    const double *v[4], *u[4];
    tess_real q[3];
    tess_int t;
    int set, m, i, k, e, code, side[4], held = 0, hits = 0;

    faults = 0;
    for (set = 0; set < 300; set++) {
        e = set % 3 == 0 ? 0 : rnd_below(1800) - 900;
        if (sizeof(tess_real) < sizeof(double)) e /= 10;
        do {
            c[0] = 2.0 * rnd_unit() - 0.5;
            c[1] = 2.0 * rnd_unit() - 0.5;
            c[2] = 1.0 - c[0] - c[1];
        } while (c[2] < -0.5 || c[2] > 1.5);
        for (i = 0; i < 9; i++) p[i] = ldexp(2.0 * rnd_unit() - 1.0, e);
        for (k = 0; k < 3; k++)
            p[9 + k] = c[0] * p[k] + c[1] * p[3 + k] + c[2] * p[6 + k];
        given(&r, "a sliver", p, 4, NULL, 0);
        release(1);
        current = &r;
        solve(&r);
        require(r.code == TESS_OK || r.code == TESS_PLANE, "a code");
        if (r.code != TESS_OK) {
            release(0);
            continue;
        }
        for (k = 0; k < 4; k++) v[k] = at(&r, r.tet[k]);
        for (m = 0; m < 40; m++) {
            for (i = 0, sum = 0.0; i < 4; i++) sum += w[i] = rnd_unit();
            if (m % 4 == 0) w[m / 4 % 4] *= -1.0;
            if (m % 4 == 1) w[m / 4 % 4] = w[(m / 4 + 1) % 4] = 0.0;
            for (k = 0; k < 3; k++) {
                volatile tess_real rounded =
                    (tess_real)((w[0] * v[0][k] + w[1] * v[1][k] +
                                 w[2] * v[2][k] + w[3] * v[3][k]) / sum);
                q[k] = rounded;
                x[k] = (double)q[k];
            }
            t = TESS_NONE;
            code = tess_locate(r.p, 1, r.tet, r.adj, q, &t, w);
            for (k = 0, held = 1; k < 4; k++) {
                for (i = 0; i < 4; i++) u[i] = i == k ? x : v[i];
                side[k] = ex_orient(u[0], u[1], u[2], u[3]);
                if (side[k] < 0) held = 0;
            }
            require(t == 0 && code == !held, "in a sliver or not");
            hits += held;
            if (!held) {
                if (code == 1) verify_outside(&r, 0, x, w);
                continue;
            }
            verify_weights(&r, 0, x, w, side);
        }
        current = NULL;
        release(0);
    }
    printf("# %d places inside\n", hits);
    require(hits > 100, "places inside of slivers");
    test_result("weights in slivers", faults);
}

int main(int argc, char **argv)
{
    quick = test_quick(argc, argv);
    rnd_seed(1);
    test_locate();
    test_values();
    test_lost();
    test_slivers();
    return test_end();
}
