/* backward.c - backward [-check] [facets]: the error analysis of the paper's
 * Section 3.1, measured.
 *
 * The paper: the computed (z-p1).v is exactly
 *     sum_i [z_i (1+delta) - p_i (1+delta)] (Q (e3+h))_i
 * with |delta| <= 4 e0 and ||h|| <= 56 c e0, c of order one, e0 the unit
 * roundoff.  Q = Q1 Q2 are the exact reflectors of what the arithmetic has at
 * hand: Q1 of the difference p2-p1 as rounded, Q2 of the second column as
 * computed.  Every single rounding is measured, and delta and h put together
 * of them as the paper does: the roundings of a difference go to delta, those
 * of a term of the dot product half to delta, half to h, those of v to h.
 * Then the statement itself is tested.
 *
 * Such a backward bound says nothing of the facet's true normal.  So there is
 * the error of v against that, and hhpred.h's forward bounds: the largest
 * error of hh_side, of c - p1, of hh_lcoord and hh_limits over its bound.
 *
 * The measure is arithmetic in pairs of doubles, of about 104 bits: two
 * doubles to a number, sums and products with their rounding errors found by
 * further operations (Knuth, Dekker).
 *
 * With -DFORTRAN, which is for f77/hhpred.f by way of twin/shim.c, these
 * alone.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../hhpred.h"
#include "../lib/exact.h"
#include "round.h"

/* ---- pairs of doubles ---- */

typedef struct pair {
    double h, l;
} pair;

/* the result of an operation, rounded to double on every machine */
static double keep(double x)
{
    volatile double d = x;

    return d;
}

static pair sum2(double a, double b)
{
    pair r;
    double t;

    r.h = keep(a + b);
    t = keep(r.h - a);
    r.l = keep(keep(a - keep(r.h - t)) + keep(b - t));
    return r;
}

static void halves(double a, double *h, double *l)
{
    double t = keep(134217729.0 * a);

    *h = keep(t - keep(t - a));
    *l = keep(a - *h);
}

static pair product2(double a, double b)
{
    pair r;
    double ah, al, bh, bl;

    halves(a, &ah, &al);
    halves(b, &bh, &bl);
    r.h = keep(a * b);
    r.l = keep(keep(keep(keep(keep(ah * bh) - r.h) + keep(ah * bl)) +
                    keep(al * bh)) + keep(al * bl));
    return r;
}

static pair of(double a)
{
    pair r;

    r.h = a;
    r.l = 0.0;
    return r;
}

static pair add(pair a, pair b)
{
    pair s = sum2(a.h, b.h), t = sum2(a.l, b.l);

    s = sum2(s.h, keep(s.l + t.h));
    return sum2(s.h, keep(s.l + t.l));
}

static pair neg(pair a)
{
    a.h = -a.h;
    a.l = -a.l;
    return a;
}

static pair sub(pair a, pair b) { return add(a, neg(b)); }

static pair mul(pair a, pair b)
{
    pair r = product2(a.h, b.h);

    return sum2(r.h, keep(r.l + keep(keep(a.h * b.l) + keep(a.l * b.h))));
}

static pair quot(pair a, pair b)
{
    pair q = of(keep(a.h / b.h)), r = sub(a, mul(q, b));

    q = add(q, of(keep(r.h / b.h)));
    r = sub(a, mul(q, b));
    return add(q, of(keep(r.h / b.h)));
}

static pair root(pair a)
{
    pair x = of(keep(sqrt(a.h))), r;

    if (x.h == 0.0) return x;
    r = sub(a, mul(x, x));
    return add(x, of(keep(r.h / keep(2.0 * x.h))));
}

static pair dot(const pair *a, const pair *b)
{
    return add(add(mul(a[0], b[0]), mul(a[1], b[1])), mul(a[2], b[2]));
}

static void cross(pair *r, const pair *a, const pair *b)
{
    int i, j, k;

    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = (k + 2) % 3;
        r[k] = sub(mul(a[i], b[j]), mul(a[j], b[i]));
    }
}

static void minus(pair *r, const double *a, const double *b)
{
    int k;

    for (k = 0; k < 3; k++) r[k] = sub(of(a[k]), of(b[k]));
}

static double length(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* ---- facets and points ---- */

enum { RANDOM, NEEDLE, OBTUSE, SHORT, LATTICE, OFFSET, FACETS };
static const char *const name[FACETS] = {
    "random", "needles, p2 near p1", "nearly collinear", "p3 near p2",
    "lattice", "far from the origin"
};
enum { ANYWHERE, NEAR_PLANE, FAR, NEAR_P1, POINTS };

static double sym(void) { return 2.0 * rnd_unit() - 1.0; }

static double power10(int k)
{
    double x = 1.0;

    for (; k > 0; k--) x *= 10.0;
    return x;
}

/* p[0..2]: a facet of the class, p[3] a point, of at most that many bits. */
static void make(int group, int kind, int bits, double p[4][3])
{
    double d, s, t;
    int i, k;

    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) p[i][k] = sym();
    d = 1.0 / power10(1 + rnd_below(bits == 24 ? 6 : 15));
    s = 3.0 * sym();
    t = power10(1 + rnd_below(bits == 24 ? 4 : 8));
    for (k = 0; k < 3; k++) {
        if (group == NEEDLE) p[1][k] = p[0][k] + d * sym();
        if (group == OBTUSE)
            p[2][k] = p[0][k] + s * (p[1][k] - p[0][k]) + d * sym();
        if (group == SHORT) p[2][k] = p[1][k] + d * sym();
        if (group == LATTICE)
            for (i = 0; i < 3; i++) p[i][k] = rnd_below(4);
        if (group == OFFSET && rnd_below(3) > 0)
            for (i = 0; i < 3; i++) p[i][k] += t;
    }
    d = 1.0 / power10(1 + rnd_below(bits == 24 ? 6 : 15));
    s = 1.5 * rnd_unit();
    t = 1.5 * rnd_unit();
    for (k = 0; k < 3; k++) {
        if (kind == ANYWHERE) p[3][k] = p[0][k] + sym();
        if (kind == NEAR_PLANE)
            p[3][k] = p[0][k] + s * (p[1][k] - p[0][k]) +
                      t * (p[2][k] - p[0][k]) + d * sym();
        if (kind == FAR) p[3][k] = p[0][k] + sym() / d;
        if (kind == NEAR_P1) p[3][k] = p[0][k] + d * sym();
    }
    ra_bits(bits);
    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) p[i][k] = ra_keep(p[i][k]);
}

/* ---- backward ---- */

/* In units of e0; and the largest gap in the statement, in units of e0 times
 * the sum of its terms' sizes. */
typedef struct largest {
    double delta, h, normal, gap;
    double side, centre, lcoord, limits;
    long facets, points, same;
} largest;

static void most(double *x, double y) { if (!(y <= *x)) *x = y; }

/* reflect - x turned by the reflector that takes a to a multiple of its first
 * axis, n components */
static void reflect(int n, const pair *a, pair *x)
{
    pair u[3], uu = of(0.0), ux = of(0.0), t;
    int k;

    for (k = 0; k < n; k++) uu = add(uu, mul(a[k], a[k]));
    for (k = 0; k < n; k++) u[k] = a[k];
    t = root(uu);
    u[0] = a[0].h > 0.0 ? add(a[0], t) : sub(a[0], t);
    uu = of(0.0);
    for (k = 0; k < n; k++) {
        uu = add(uu, mul(u[k], u[k]));
        ux = add(ux, mul(u[k], x[k]));
    }
    t = quot(add(ux, ux), uu);
    for (k = 0; k < n; k++) x[k] = sub(x[k], mul(t, u[k]));
}

/* the relative error of the computed value x of exact */
static double relative(double x, pair exact)
{
    if (exact.h == 0.0) return 0.0;
    return sub(of(x), exact).h / exact.h;
}

static void backward(int bits, double p[4][3], largest *m)
{
    double f[RA_FACET_LEN], w[3], term[3], u[3], theta[3], s, r, e0;
    double e[3], size = 0.0;
    pair a[3], q[2], x[3], n[3], b[3], sum = of(0.0), t;
    int k;

    ra_bits(bits);
    e0 = ldexp(1.0, -bits);
    if (ra_facet(p[0], p[1], p[2], f)) return;
    m->facets++;
    for (k = 0; k < 3; k++) {
        a[k] = of(ra_sub(p[1][k], p[0][k]));
        x[k] = of(0.0);
    }
    q[0] = of(f[9]);
    q[1] = of(f[10]);
    x[2] = of((f[11] < 0.0) == (f[12] < 0.0) ? 1.0 : -1.0);
    reflect(2, q, x + 1);
    reflect(3, a, x);

    /* the roundings of (z-p1).v */
    for (k = 0; k < 3; k++) {
        w[k] = ra_sub(p[3][k], p[0][k]);
        u[k] = relative(w[k], sub(of(p[3][k]), of(p[0][k])));
        term[k] = ra_mul(f[k], w[k]);
        theta[k] = relative(term[k], mul(of(f[k]), of(w[k])));
        size += fabs(term[k]);
    }
    s = ra_add(term[0], term[1]);
    r = relative(s, add(of(term[0]), of(term[1])));
    theta[0] += r;
    theta[1] += r;
    r = ra_add(s, term[2]);
    s = relative(r, add(of(s), of(term[2])));
    for (k = 0; k < 3; k++) {
        theta[k] = 0.5 * (theta[k] + s);
        most(&m->delta, fabs(u[k] + theta[k]) / e0);
        /* Q (e3 + h) = v (1 + theta) */
        t = add(of(f[k]), mul(of(f[k]), of(theta[k])));
        e[k] = sub(t, x[k]).h;
        t = mul(t, mul(sub(of(p[3][k]), of(p[0][k])),
                       add(of(1.0), of(u[k] + theta[k]))));
        sum = add(sum, t);
    }
    most(&m->h, length(e) / e0);
    if (size > 0.0)
        most(&m->gap, fabs(sub(sum, of(r)).h) / (size * e0));

    /* the true normal */
    minus(a, p[1], p[0]);
    minus(b, p[2], p[0]);
    cross(n, a, b);
    t = root(dot(n, n));
    if (t.h == 0.0) return;
    for (k = 0; k < 3; k++) e[k] = sub(of(f[k]), quot(n[k], t)).h;
    most(&m->normal, length(e) / e0);
}

/* ---- forward ---- */

static void forward(double p[4][3], largest *m)
{
    double f[HH_FACET_LEN], g[RA_FACET_LEN], v[3], w, l, dl, gap, lo, hi;
    double q[4][3], size = 0.0;
    pair a[3], b[3], d[3], n[3], c[3], u[3], nn, norm, aa, bb, wn, power, t;
    int i, k;

    if (hh_facet(p[0], p[1], p[2], f) || f[9] >= 1.0) return;
    ra_bits(53);
    ra_facet(p[0], p[1], p[2], g);
    m->facets++;
    m->same += f[0] == g[0] && f[1] == g[1] && f[2] == g[2];
    minus(a, p[1], p[0]);
    minus(b, p[2], p[0]);
    minus(d, p[3], p[0]);
    cross(n, a, b);
    nn = dot(n, n);
    norm = root(nn);
    aa = dot(a, a);
    bb = dot(b, b);
    cross(c, b, n);
    cross(u, n, a);
    /* 2 nn (c - p1) */
    for (k = 0; k < 3; k++)
        u[k] = add(mul(aa, c[k]), mul(bb, u[k]));
    for (k = 0; k < 3; k++)
        v[k] = sub(of(f[3 + k]), quot(u[k], add(nn, nn))).h;
    most(&m->centre, length(v) / f[10]);

    for (k = 0; k < 3; k++) v[k] = d[k].h;
    w = length(v) * (1.0 + 8.0 * DBL_EPSILON);
    if (w == 0.0) return;
    wn = dot(d, n);
    t = quot(wn, norm);
    l = hh_side(f, p[3]);
    most(&m->side, fabs(sub(of(l), t).h) / (f[9] * w));
    gap = fabs(l) - f[9] * w;
    power = sub(mul(dot(d, d), nn), dot(u, d));
    if (gap > 0.0) {
        t = quot(power, mul(norm, add(wn, wn)));
        l = hh_lcoord(f, p[3]);
        dl = w * (DBL_EPSILON * (3.0 * w + 5.0 * f[11]) + f[10] +
                  fabs(l) * f[9]) / gap + 4.0 * DBL_EPSILON * fabs(l);
        m->points++;
        most(&m->lcoord, fabs(sub(of(l), t).h) / dl);
    }

    /* hh_limits wants coordinates of at most 1 */
    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++)
            if (fabs(p[i][k]) > size) size = fabs(p[i][k]);
    frexp(size, &i);
    size = ldexp(1.0, -i);
    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) q[i][k] = size * p[i][k];
    hh_setup(q[0], q[1], q[2], f);
    if (hh_limits(f, q[3], &lo, &hi) == 1) {
        t = quot(power, mul(norm, add(wn, wn)));
        t.h *= size;
        t.l *= size;
        l = 0.5 * lo + 0.5 * hi;
        most(&m->limits, fabs(sub(of(l), t).h) / (0.5 * hi - 0.5 * lo));
    }
}

int main(int argc, char **argv)
{
    static largest m24[FACETS], m53[FACETS], fw[FACETS];
    double p[4][3];
    long n = 20000, i, same = 0, all = 0;
    int check = argc > 1 && strcmp(argv[1], "-check") == 0, group, kind;
    long bad[8];
#ifndef FORTRAN
    double d24 = 0.0, d53 = 0.0, h24 = 0.0, h53 = 0.0;
#endif

    if (argc > 1 + check) n = atol(argv[1 + check]);
    memset(bad, 0, sizeof bad);
    rnd_seed(1);
    for (group = 0; group < FACETS; group++) {
        for (i = 0; i < n; i++) {
            kind = group == RANDOM ? ANYWHERE : rnd_below(POINTS);
            make(group, kind, 24, p);
            backward(24, p, &m24[group]);
            make(group, kind, 53, p);
            backward(53, p, &m53[group]);
            forward(p, &fw[group]);
        }
        bad[0] += !(m24[group].delta <= 4.0) || !(m53[group].delta <= 4.0);
        bad[1] += !(m24[group].h <= 56.0) || !(m53[group].h <= 56.0);
        bad[2] += !(m24[group].gap <= 0.01) || !(m53[group].gap <= 0.01);
        bad[3] += !(fw[group].side < 1.0);
        bad[4] += !(fw[group].centre < 1.0);
        bad[5] += !(fw[group].lcoord < 1.0);
        bad[6] += !(fw[group].limits < 1.0);
        bad[7] += fw[group].points < n / 4 || m53[group].facets < n / 4;
        same += fw[group].same;
        all += fw[group].facets;
    }
    if (check) {
#ifndef FORTRAN
        test_result("delta is at most 4 e0", bad[0]);
        test_result("||h|| is at most 56 e0", bad[1]);
        test_result("with these delta and h the statement holds", bad[2]);
#endif
        test_result("the side's error is below its bound", bad[3]);
        test_result("the centre's error is below its bound", bad[4]);
        test_result("the L-coordinate's error is below its bound", bad[5]);
        test_result("L is within hh_limits", bad[6]);
        test_result("most facets count", bad[7]);
        return test_end();
    }
#ifndef FORTRAN
    printf("The largest of %ld facets a row, in units of e0\n\n", n);
    printf("                       32-bit arithmetic            "
           "64-bit arithmetic\n");
    printf("  facets               delta  ||h||  true normal    "
           "delta  ||h||  true normal\n");
    for (group = 0; group < FACETS; group++) {
        printf("  %-20s %5.2f %6.2f %12.3g %8.2f %6.2f %12.3g\n", name[group],
               m24[group].delta, m24[group].h, m24[group].normal,
               m53[group].delta, m53[group].h, m53[group].normal);
        most(&d24, m24[group].delta);
        most(&h24, m24[group].h);
        most(&d53, m53[group].delta);
        most(&h53, m53[group].h);
    }
    printf("  %-20s %5.2f %6.2f %12s %8.2f %6.2f\n", "largest", d24, h24, "",
           d53, h53);
    printf("  %-20s %5d %6s %12s %8d %6s\n\n", "paper's bound", 4, "56 c", "",
           4, "56 c");
    printf("The largest error over its bound, C\n\n");
#else
    printf("The largest error over its bound, FORTRAN 77\n\n");
#endif
    printf("  facets               (z-p1).v    c - p1   hh_lcoord hh_limits\n");
    for (group = 0; group < FACETS; group++)
        printf("  %-20s %8.2g %9.2g %10.2g %9.2g\n", name[group],
               fw[group].side, fw[group].centre, fw[group].lcoord,
               fw[group].limits);
    printf("\nThe library's normal is that of the arithmetic above, bit for "
           "bit, in %ld\nof %ld facets.\n", same, all);
    return 0;
}
