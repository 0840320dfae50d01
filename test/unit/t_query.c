/* t_query.c - tests of tess_query and tess_ball, and of what an index keeps.
 *
 *     t_query          all tests
 *     t_query -quick   fewer and smaller ones, for slow builds
 *     t_query -brief   still fewer, for make check
 *
 * Covered:
 *   queries  tess_query and tess_locate answer alike: on points, midpoints,
 *            edges, facets, anywhere, from near and from nowhere; outside;
 *            from four points that are no tetrahedron of the mesh
 *   surfaces an index that knows planes and spheres: parts and queries from
 *            it, from a copy, from arrays that held another one before, after a
 *            part that found more; refused where the arrays are too short for
 *            what it has
 *   balls    no point outside of tess_ball's is inside the exact one
 */
#include "lib/whole.h"
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- queries ---- */

static long ranges;

/* tess_query of q from v, against tess_locate; 1 when q is inside. */
static int query(const whole *m, const double *at, tess_int *v)
{
    /* not const: shim.c counts them from 1, and back */
    static tess_int none[4] = { -1, -1, -1, -1 };
    static tess_int alone[4] = { 0, 1, 2, 3 };
    static const int out[4][3] = { {1,2,3}, {0,3,2}, {0,1,3}, {0,2,1} };
    tess_int t = TESS_NONE, j;
    tess_real q[3], p[12];
    double w[4], x[4], y, size;
    int code, want, i, k, beyond = 0;

    for (k = 0; k < 3; k++) q[k] = (tess_real)at[k];
    code = tess_query(m->n, m->p, m->iw, m->rw, q, v, w);
    want = tess_locate(m->p, m->ntet, m->tet, m->adj, q, &t, x);
    /* few limbs may do for one way and not for another */
    if (HH_LIMBS < 88 && (code == TESS_RANGE || want == TESS_RANGE)) {
        require(code == want || code == 1 || want == 1, "TESS_RANGE inside");
        v[0] = TESS_NONE;
        ranges++;
        return 0;
    }
    require(code == want, "the code of a query");
    j = number(m, v);
    require(j >= 0, "a query's tetrahedron is none of the mesh");
    if (j < 0) return 0;
    if (code == 0) require(number(m, m->tet + 4 * t) == j, "another one");
    if (code == 0) {
        /* its weights are those of the tetrahedron alone */
        for (k = 0; k < 12; k++) p[k] = m->p[3 * v[k / 3] + k % 3];
        t = 0;
        tess_locate(p, 1, alone, none, q, &t, x);
        require(memcmp(w, x, sizeof x) == 0, "the weights of a query");
    }
    if (code == 1) {
        /* those of the same vertices, in any tetrahedron that has them */
        for (i = 0, size = 0.0; i < 4; i++) {
            for (k = 0; k < 4 && m->tet[4 * t + k] != v[i];) k++;
            y = k < 4 ? x[k] : 0.0;
            size += y;
            require((w[i] > 0.0) == (y > 0.0) && w[i] >= 0.0,
                    "the vertices of a query outside");
            require(fabs(w[i] - y) <= 4.0 * DBL_EPSILON * y,
                    "the weights of a query outside");
        }
        require(fabs(size - 1.0) <= 4.0 * DBL_EPSILON,
                "not all vertices of a query outside");
        for (t = 0; number(m, m->tet + 4 * t) != j; t++)
            ;
        for (k = 0; k < 4; k++) {
            const tess_int *u = m->tet + 4 * t;

            beyond += m->adj[4 * t + k] == TESS_NONE &&
                      w[slot_of(v, u[k]) % 4] == 0.0 &&
                      hh_orient(m->p + 3 * u[out[k][0]],
                                m->p + 3 * u[out[k][1]],
                                m->p + 3 * u[out[k][2]], q) > 0;
        }
        require(beyond > 0, "outside, but not of a hull facet");
    }
    return code == 0;
}

static void test_queries(void)
{
    char name[80];
    double lo[3], hi[3], q[3], x[3];
    tess_int v[4], i, t;
    whole m;
    int f, k, turned, kind, inside;

    for (f = 0; points_name(f) != NULL; f++)
        for (turned = 0; turned < 2; turned++) {
            if (quick && turned != f % 2) continue;
            faults = 0;
            sprintf(name, "queries: %s%s", points_name(f),
                    turned ? ", turned" : "");
            now = name;
            if (!family(&m, points_name(f),
                        fewer(points_name(f), quick > 1 ? 40 : quick ? 60 : 150), 5,
                        turned))
                continue;
            inside = 0;
            ranges = 0;
            for (k = 0; k < 3; k++) {
                lo[k] = hi[k] = m.p[k];
                for (i = 0; i < m.n; i++) {
                    lo[k] = m.p[3 * i + k] < lo[k] ? m.p[3 * i + k] : lo[k];
                    hi[k] = m.p[3 * i + k] > hi[k] ? m.p[3 * i + k] : hi[k];
                }
            }
            for (i = 0; i < (quick > 1 ? 5 : quick ? 10 : 40); i++)
                for (kind = 1; kind <= 9; kind++) {
                    /* a point, or the mean of 2 ... 4 of a tetrahedron, or
                     * anywhere, half of it outside, or beyond a vertex, near
                     * or far */
                    t = (tess_int)rnd_below((int)m.ntet);
                    for (k = 0; k < 3; k++) {
                        const tess_int *u = m.tet + 4 * t;

                        q[k] = m.p[3 * u[0] + k];
                        if (kind == 2) q[k] = 0.5 * q[k] +
                                              0.5 * m.p[3 * u[1] + k];
                        if (kind == 3) q[k] = 0.25 * q[k] +
                                              0.75 * m.p[3 * u[3] + k];
                        if (kind == 4) q[k] = 0.25 * q[k] +
                                              0.5 * m.p[3 * u[1] + k] +
                                              0.25 * m.p[3 * u[2] + k];
                        if (kind == 5) q[k] = 0.25 * q[k] +
                                              0.25 * m.p[3 * u[1] + k] +
                                              0.25 * m.p[3 * u[2] + k] +
                                              0.25 * m.p[3 * u[3] + k];
                        if (kind > 5)
                            x[k] = lo[k] - 0.1 * (hi[k] - lo[k]) +
                                   1.2 * rnd_unit() * (hi[k] - lo[k]);
                        if (kind == 6 || kind == 7) q[k] = x[k];
                        if (kind > 7)
                            q[k] += (kind == 8 ? 0.1 : 1e6) *
                                    (x[k] - 0.5 * (lo[k] + hi[k]));
                    }
                    /* from nowhere, and from the last one */
                    if (i % 2 == 0 || i < 2) v[0] = TESS_NONE;
                    inside += query(&m, q, v);
                }
            require(inside + (HH_LIMBS < 88 ? ranges : 0) > i,
                    "the queries are all outside");
            drop(0);
            test_result(name, faults);
        }
    /* a long way, and back */
    faults = 0;
    now = "queries: from far";
    family(&m, "uniform", quick ? 500 : 20000, 5, 0);
    v[0] = TESS_NONE;
    for (i = 0; i < (quick ? 50 : 1000); i++) {
        for (k = 0; k < 3; k++) q[k] = rnd_unit() * 0.999 + 5e-4;
        query(&m, q, v);
        if (i % 10 > 5) v[0] = TESS_NONE;
    }
    drop(0);
    test_result(now, faults);
}

/* Starts that are no tetrahedra of the mesh, each with its own middle: any four
 * points; and three of a tetrahedron with the apex of a neighbour, whose ball
 * has hardly more than one point in it. */
static void test_astray(void)
{
    static const struct {
        const char *name;
        long n;
    } sets[] = {
        { "lattice", 343 }, { "uniform", 343 }, { "globe", 729 },
        { "rotcube", 729 }, { "near8", 729 }, { "terrain", 729 }
    };
    char name[80];
    tess_int v[4], t, next, *u;
    double w[4], q[3];
    whole m;
    size_t s;
    int i, k, j, sign, strays;

    for (s = 0; s < sizeof sets / sizeof sets[0]; s++) {
        faults = strays = 0;
        sprintf(name, "queries: from no tetrahedron of %s", sets[s].name);
        now = name;
        family(&m, sets[s].name, sets[s].n, 5, 0);
        for (i = 0; i < (quick ? 400 : 4000); i++) {
            t = (tess_int)rnd_below((int)m.ntet);
            u = m.tet + 4 * t;
            k = rnd_below(4);
            next = m.adj[4 * t + k];
            if (i % 2 > 0 && next == TESS_NONE) continue;
            for (j = 0; j < 4; j++)
                v[j] = i % 2 > 0 ? u[j] : (tess_int)rnd_below((int)m.n);
            for (j = 0; i % 2 > 0 && j < 4; j++)
                if (slot_of(u, m.tet[4 * next + j]) == 4)
                    v[(k + 1 + rnd_below(3)) % 4] = m.tet[4 * next + j];
            sign = hh_orient(m.p + 3 * v[0], m.p + 3 * v[1], m.p + 3 * v[2],
                             m.p + 3 * v[3]);
            if (sign == 2) continue; /* few limbs */
            if (sign < 0) {
                j = (int)v[0];
                v[0] = v[1];
                v[1] = (tess_int)j;
            }
            for (j = 0; j < 3; j++)
                for (q[j] = 0.0, k = 0; k < 4; k++)
                    q[j] += 0.25 * (double)m.p[3 * v[k] + j];
            if (sign == 0) {
                k = tess_query(m.n, m.p, m.iw, m.rw, m.p, v, w);
                require(k == -6 || (HH_LIMBS < 88 && k == TESS_RANGE),
                        "four points of a plane");
            } else {
                strays += number(&m, v) < 0;
                query(&m, q, v);
            }
        }
        require(strays > i / 4, "hardly any strays");
        drop(0);
        test_result(name, faults);
    }
}

/* ---- surfaces: planes and spheres that an index knows ---- */

#if defined(TESS_LIST) && TESS_LIST < 128
#define SOUGHT 0
#else
#define SOUGHT (sizeof(tess_real) == sizeof(double))
#endif

/* Where an index says how many there are: ahead of the tree's nodes in tess.c,
 * which counts points from 0, behind them in tess.f, which counts from 1. */
static tess_int counted(const whole *m, const tess_int *iw)
{
    tess_int tree = 2 * m->n + 5, leaves = 1, i = 0;

    while (leaves < (m->n + 47) / 48) leaves *= 2;
    while (i < iw[tree - 1] && iw[m->n + i] > 0) i++;
    return i < iw[tree - 1] ? tree : tree + 2 * leaves - 1;
}

static tess_int surfaces(const whole *m, const tess_int *iw)
{
    return iw[counted(m, iw)];
}

/* Queries by an index iw. */
static void ask(whole *m, tess_int *iw)
{
    tess_int *was = m->iw, v[4], a, b, i;
    double q[3];
    int k;

    m->iw = iw;
    v[0] = TESS_NONE;
    for (i = 0; i < 8; i++) {
        a = (tess_int)rnd_below((int)m->n);
        b = (tess_int)rnd_below((int)m->n);
        for (k = 0; k < 3; k++)
            q[k] = 0.5 * m->p[3 * a + k] + 0.5 * m->p[3 * b + k];
        query(m, q, v);
        if (i % 2) v[0] = TESS_NONE;
    }
    m->iw = was;
}

/* Two of many parts by an index iw, the second one stopped and taken up again,
 * and queries behind each; iw is of length liw. */
static void serve(whole *m, tess_int many, tess_int liw, tess_int *iw)
{
    tess_int *part = ints(m->n), *mine = ints(m->n), *tet, *adj, *t2, *a2;
    tess_int i, k, ntet, got;
    size_t length = 0;
    int mark = narrays, code;

    divide(m, 0, many, part);
    for (k = 0; k <= many / 3; k += many / 3 + (many < 3)) {
        for (i = 0; i < m->n; i++) mine[i] = part[i] == k;
        one_part(m, mine, liw, iw, &tet, &adj);
        length = length_of(narrays - 1);
        ask(m, iw);
        require(memcmp(iw, m->iw, (size_t)(2 * m->n) * sizeof *iw) == 0,
                "the index after a part");
    }
    ntet = (tess_int)(length / sizeof *tet / 4);
    t2 = ints(4 * ntet);
    a2 = ints(4 * ntet);
    got = 0;
    code = tess_part(m->n, m->p, mine, ntet / 2, &got, t2, a2, liw, iw, m->lrw,
                     m->rw);
    require(code == TESS_MORE && got == ntet / 2, "stopped");
    code = tess_part(m->n, m->p, mine, ntet, &got, t2, a2, liw, iw, m->lrw,
                     m->rw);
    require(code == TESS_OK && got == ntet && memcmp(t2, tet, length) == 0 &&
            memcmp(a2, adj, length) == 0, "a part taken up again");
    ask(m, iw);
    drop(mark);
}

/* An index of length liw of the same points, with an rw of its own, in k. */
static void reindex(const whole *m, tess_int liw, whole *k)
{
    *k = *m;
    k->liw = liw;
    k->iw = ints(liw);
    k->rw = (double *)array((size_t)m->lrw * sizeof(double));
    require(tess_index(m->n, m->p, liw, k->iw, m->lrw, k->rw) == 0,
            "an index of another length");
    require(memcmp(k->iw, m->iw, (size_t)(2 * m->n) * sizeof *k->iw) == 0,
            "its places");
}
static void test_surfaces(void)
{
    static const struct {
        const char *name;
        int turned;
    } sets[] = {
        { "globe", 0 }, { "rotcube", 0 }, { "rotcubein", 0 }, { "gridrot", 0 },
        { "extruded", 0 }, { "near8", 0 }, { "globe", 2 }, { "cubesurf", 1 }
    };
    char name[80];
    tess_int n = 729, all = 7 * n + 600, old = 2 * n + n / 12 + 7, lo, hi, i;
    /* tess.h's least of a part with surfaces */
    tess_int few = 5 * n + 18 * leaves(n) + 632;
    tess_int many = 5, most = (tess_int)(6 * n + 600 + TESS_LIW(n));
    tess_int liw = (tess_int)(6 * n + 600 + TESS_LIW(2 * n / many + 2)), *iw;
    whole other, m, k;
    size_t s;
    int mark, inner, more = 0;

    for (s = 0; s < sizeof sets / sizeof sets[0]; s++) {
        size_t next = (s + 1) % (sizeof sets / sizeof sets[0]);

        if (quick > 1 && s % 2) continue;
        faults = 0;
        sprintf(name, "surfaces: %s%s", sets[s].name,
                sets[s].turned == 2 ? ", twice" : "");
        now = name;
        if (!family(&other, sets[next].name, n, 4, sets[next].turned) ||
            !family(&m, sets[s].name, n, 3, sets[s].turned))
            continue;
        require(m.n == n && other.n == n, "other points");
        require(!SOUGHT || surfaces(&m, m.iw) > 0, "none in the index");
        mark = narrays;
        /* all of the index */
        ask(&m, begun(m.iw, all, all));
        iw = begun(m.iw, all, liw);
        serve(&m, many, liw, iw);
        drop(mark);
        /* arrays that held another index before */
        reindex(&m, liw, &k);
        require(tess_index(n, other.p, liw, k.iw, m.lrw, k.rw) == 0 &&
                tess_index(n, m.p, liw, k.iw, m.lrw, k.rw) == 0, "again");
        serve(&k, many, liw, k.iw);
        drop(mark);
        /* a number that cannot be */
        for (i = 0; i < 4; i++) {
            tess_int v[4], ntet = 0, *mine = begun(m.iw, n, n);
            double w[4];

            iw = begun(m.iw, all, liw);
            iw[counted(&m, iw)] = i ? 9 << (3 * i - 3) : -1;
            v[0] = TESS_NONE;
            require(tess_query(n, m.p, iw, m.rw, m.p, v, w) == -3 &&
                    tess_part(n, m.p, mine, 0, &ntet, mine, mine, liw, iw,
                              m.lrw, m.rw) == -9, "too many surfaces");
            drop(mark);
        }
        /* no room for them, or for cylinders */
        if (surfaces(&m, m.iw) > 0) {
            tess_int ntet = 0, *mine = begun(m.iw, n, n);

            for (i = few - 1; i <= few; i++)
                require(tess_part(n, m.p, mine, 0, &ntet, mine, mine, i,
                                  begun(m.iw, i, i), m.lrw, m.rw) ==
                            (i < few ? -8 : TESS_MORE),
                        "the least iw of a part");
            drop(mark);
        }
        /* a part of all points may find more, which stay in its index */
        iw = begun(m.iw, all, most);
        serve(&m, 1, most, iw);
        more += surfaces(&m, iw) > surfaces(&m, m.iw);
        require(surfaces(&m, iw) >= surfaces(&m, m.iw), "a part loses some");
        serve(&m, many, liw, iw);
        ask(&m, iw);
        drop(mark);
        /* an index without them, and the least length for one with some */
        reindex(&m, old, &k);
        require(surfaces(&m, k.iw) == 0, "surfaces in the least index");
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, old, liw));
        drop(mark);
        lo = old;
        hi = 7 * n + 600;
        reindex(&m, hi, &k);
        require(surfaces(&m, k.iw) == surfaces(&m, m.iw), "7 n + 600");
        while (SOUGHT && surfaces(&m, m.iw) > 0 && hi - lo > 1) {
            inner = narrays;
            reindex(&m, (tess_int)(lo + (hi - lo) / 2), &k);
            if (surfaces(&m, k.iw) > 0) hi = k.liw;
            else lo = k.liw;
            drop(inner);
        }
        drop(mark);
        reindex(&m, lo, &k);
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, lo < all ? lo : all, liw));
        reindex(&m, hi, &k);
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, hi, liw));
        drop(0);
        test_result(name, faults);
    }
    faults = 0;
    now = "surfaces: more than the index has";
#ifndef TESS_LIST
    require(!SOUGHT || HH_LIMBS < 88 || more > 0, "no part found any");
#endif
    test_result(now, faults);
}

/* ---- balls ---- */

/* |a - c|^2 against r^2, exactly. */
static int beyond(const double *a, const double *c, double r)
{
    static ex_num x, y, z, sum;
    int low = ex_low(r, EX_NO_LOW), k;

    for (k = 0; k < 3; k++) low = ex_low(c[k], ex_low(a[k], low));
    ex_int(&sum, 0);
    for (k = 0; k < 3; k++) {
        ex_real(&x, a[k], low);
        ex_real(&y, c[k], low);
        ex_sub(&x, &x, &y);
        ex_copy(&y, &x);
        ex_mul(&z, &x, &y);
        ex_add(&sum, &sum, &z);
    }
    ex_real(&x, r, low);
    ex_copy(&y, &x);
    ex_mul(&z, &x, &y);
    return ex_cmp(&sum, &z);
}

static void test_balls(void)
{
    static const tess_int v[4] = { 0, 1, 2, 3 };
    tess_real p[12];
    double a[12], c[4], z[3], u[3], off, thin, size;
    long i, finite = 0, tight = 0, tried = 0;
    int j, k, code, unit;

    faults = 0;
    now = "tess_ball";
    for (i = 0; i < (quick ? 300 : 2000); i++) {
        /* slivers, far off, in any unit */
        off = i % 3 == 0 ? 0.0 : ldexp(1.0, (int)(i % 31));
        thin = ldexp(1.0, -(int)(i % 47));
        unit = (int)(i % 5 - 2) * (sizeof(tess_real) < 8 ? 40 : 450);
        for (k = 0; k < 12; k++) {
            a[k] = k % 3 == 2 && k > 2 && i % 2 ? a[2] : rnd_unit();
            if (k == 11) a[k] = a[2] + thin * rnd_unit();
        }
        if (i % 7 == 0) /* about the origin */
            for (k = 3; k < 12; k++)
                a[k] = k % 3 == k / 3 - 1 ? a[k % 3] : -a[k % 3];
        for (k = 0; k < 12; k++) {
            p[k] = (tess_real)ldexp(a[k] + (i % 7 == 0 ? 0.0 : off), unit);
            a[k] = p[k];
        }
        code = tess_ball(p, v, c);
        require(code == TESS_OK, "its code");
        if (ex_orient(a, a + 3, a + 6, a + 9) == 0) {
            require(c[3] == DBL_MAX, "flat, with a ball");
            continue;
        }
        tried++;
        if (c[3] == DBL_MAX) continue;
        finite++;
        for (j = 0; j < 4; j++)
            require(beyond(a + 3 * j, c, c[3]) <= 0, "a vertex is outside");
        for (j = 0; j < 8; j++) {
            for (k = 0; k < 3; k++) u[k] = rnd_unit() - 0.5;
            size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
            for (k = 0; k < 3; k++)
                z[k] = c[k] + u[k] / size * c[3] * (1.0 + (j - 2) * 3e-16);
            if (beyond(z, c, c[3]) > 0)
                require(ex_insphere(a, a + 3, a + 6, a + 9, z) < 0,
                        "inside of the ball, but outside of tess_ball's");
            for (k = 0; k < 3; k++)
                z[k] = c[k] + u[k] / size * (c[3] - 1e-13 * (c[3] +
                       fabs(c[0]) + fabs(c[1]) + fabs(c[2])));
            if (beyond(z, c, c[3]) < 0)
                tight += ex_insphere(a, a + 3, a + 6, a + 9, z) > 0;
        }
    }
    if (HH_LIMBS > 10)
        require(finite == tried && tight == 8 * tried, "it is wide");
    test_result(now, faults);
}

int main(int argc, char **argv)
{
    quick = test_quick(argc, argv);
    rnd_seed(1);
    test_balls();
    test_queries();
    test_surfaces();
    test_astray();
    return test_end();
}
