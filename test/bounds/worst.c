/* worst.c - a search for the worst case of each bound that is not straight-
 * line, of the error over its bound, which must not exceed 1.
 *
 *     worst [-steps N] [-seed K] [NAME...]   N tries for each bound of these
 *                                            names (of all)
 *
 * Prints `NAME: worst ratio R', then as a test whether R is at most 1.
 *
 * A try is a set of points and numbers, drawn from classes that are hard in a
 * way of their own, or the last good one with something changed: the change
 * stays if the ratio is no less.  The routines of the library compute in one of
 * the four rounding modes (with -DTEST_ROUNDING and C99's fenv.h), the static
 * ones of tess.c as well, which is included.  What they should have computed
 * comes from the same doubles by numbers of 480 bits on exact.c's integers: the
 * bounds are some multiples of 2^-52.  The search is the same each time.
 */
#include "../../tess.c"
#include "../lib/exact.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef TEST_ROUNDING
#include <fenv.h>
#endif

/* ---- the judge's numbers: m 2^e, m of some KEEP digits ---- */

#define KEEP (480 / EX_DIGIT)

typedef struct real {
    ex_num m;
    int e;
} real;
typedef real vec[3];

static void shorten(real *r)
{
    int drop = r->m.len - KEEP, i;

    if (drop <= 0) return;
    for (i = 0; i < KEEP; i++) r->m.d[i] = r->m.d[i + drop];
    r->m.len = KEEP;
    r->e += drop * EX_DIGIT;
}

static void set(real *r, double x)
{
    r->e = ex_low(x, EX_NO_LOW);
    if (x == 0.0) r->e = 0;
    ex_real(&r->m, x, r->e);
}

static void copy(real *r, const real *a)
{
    ex_copy(&r->m, &a->m);
    r->e = a->e;
}

static int top(const real *a)
{
    return a->m.sign == 0 ? -99999 : a->e + ex_bits(&a->m);
}

/* r = a + s b, s = 1 or -1; r may be a or b */
static void sum(real *r, const real *a, int s, const real *b)
{
    static real x, y;
    int gap = top(a) - top(b);

    copy(&x, a);
    copy(&y, b);
    y.m.sign *= s;
    if (gap > 1000 || y.m.sign == 0) copy(r, &x);
    else if (gap < -1000 || x.m.sign == 0) copy(r, &y);
    else {
        if (x.e > y.e) ex_shift(&x.m, x.e - y.e), x.e = y.e;
        if (y.e > x.e) ex_shift(&y.m, y.e - x.e);
        ex_add(&r->m, &x.m, &y.m);
        r->e = x.e;
        shorten(r);
    }
}

static void add(real *r, const real *a, const real *b) { sum(r, a, 1, b); }
static void sub(real *r, const real *a, const real *b) { sum(r, a, -1, b); }

static void mul(real *r, const real *a, const real *b)
{
    static real x;

    ex_mul(&x.m, &a->m, &b->m);
    x.e = a->e + b->e;
    shorten(&x);
    copy(r, &x);
}

static void scale(real *r, const real *a, double x)
{
    static real y;

    set(&y, x);
    mul(r, a, &y);
}

/* The value: rounded, or a power of two that is as far off. */
static double value(const real *a)
{
    int e;
    double m = (double)ex_value(&a->m, &e);

    e += a->e;
    return ldexp(m, e > 1000 ? 1000 : e < -1000 ? -1000 : e);
}

/* r = 1 / a^(1/n), n = 1 or 2, a > 0: by Newton's method, which doubles the
 * digits, from 50 bits on. */
static void power_of(real *r, const real *a, int n)
{
    static real x, y, t, one;
    int e, i;
    double m;

    copy(&x, a);
    m = (double)ex_value(&x.m, &e);
    x.e = -e; /* now x is m */
    e += a->e;
    if (n == 2 && e % 2 != 0) {
        x.e++;
        m *= 2.0;
        e--;
    }
    set(&one, 1.0);
    set(&y, n == 1 ? 1.0 / m : 1.0 / sqrt(m));
    for (i = 0; i < 4; i++) {
        mul(&t, &y, &x);
        if (n == 2) mul(&t, &t, &y);
        sub(&t, &one, &t);
        t.e -= n - 1;
        mul(&t, &t, &y);
        add(&y, &y, &t);
    }
    copy(r, &y);
    r->e -= e / n;
}

static void over(real *r, const real *a, const real *b)
{
    static real x, y;
    int s = b->m.sign;

    copy(&x, b);
    x.m.sign = 1;
    power_of(&y, &x, 1);
    y.m.sign = s;
    mul(r, a, &y);
}

static void root(real *r, const real *a)
{
    static real x;

    if (a->m.sign <= 0) {
        set(r, 0.0);
        return;
    }
    power_of(&x, a, 2);
    mul(r, a, &x);
}

static void put(real *u, const double *a)
{
    int k;

    for (k = 0; k < 3; k++) set(&u[k], a[k]);
}

static void off(real *u, const real *a, const real *b)
{
    int k;

    for (k = 0; k < 3; k++) sub(&u[k], &a[k], &b[k]);
}

/* u = a + t b */
static void along(real *u, const real *a, const real *t, const real *b)
{
    static real x;
    int k;

    for (k = 0; k < 3; k++) {
        mul(&x, t, &b[k]);
        add(&u[k], &a[k], &x);
    }
}

static void inner(real *r, const real *a, const real *b)
{
    static real x, y;
    int k;

    mul(&y, &a[0], &b[0]);
    for (k = 1; k < 3; k++) {
        mul(&x, &a[k], &b[k]);
        add(&y, &y, &x);
    }
    copy(r, &y);
}

static void outer(real *u, const real *a, const real *b)
{
    static real x, y;
    int k, i, j;

    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = (k + 2) % 3;
        mul(&x, &a[i], &b[j]);
        mul(&y, &a[j], &b[i]);
        sub(&u[k], &x, &y);
    }
}

static void length(real *r, const real *a)
{
    static real x;

    inner(&x, a, a);
    root(r, &x);
}

/* |x| over a bound; a bound of 0 is not exceeded by 0. */
static double part(const real *x, double bound)
{
    static real y;

    if (x->m.sign == 0) return 0.0;
    set(&y, bound);
    if (y.m.sign <= 0) return 1e9;
    over(&y, x, &y);
    return fabs(value(&y));
}

/* ---- a try ---- */

#define POINTS 8
#define NUMBERS 6
static double P[POINTS][3]; /* the points: at most 1 */
static double X[NUMBERS];   /* numbers of (-1, 1) */
static int mode;

/* a try that is kept */
struct kept {
    double p[POINTS][3], x[NUMBERS], ratio;
    int mode;
};

static void keep(struct kept *k, double ratio)
{
    memcpy(k->p, P, sizeof P);
    memcpy(k->x, X, sizeof X);
    k->mode = mode;
    k->ratio = ratio;
}

static void take(const struct kept *k)
{
    memcpy(P, k->p, sizeof P);
    memcpy(X, k->x, sizeof X);
    mode = k->mode;
}

static mesher M;
static search S;
static candidate_list near_list;
static double box[6 * 8 + 12 * 4 + 32];
static tess_int marks[POINTS + 200], order[POINTS], first[8];
static double out[64]; /* what a routine computed */

static double sym(void) { return 2.0 * rnd_unit() - 1.0; }

static double tenth(int k)
{
    double x = 1.0;

    for (; k > 0; k--) x *= 0.1;
    return x;
}

/* Facets P[0..2] of all kinds, and another point P[3]. */
static void draw_facet(void)
{
    double d = tenth(rnd_below(9)), t = sym(), u = 0.0, small;
    int i, k, axis = rnd_below(3);

    for (i = 0; i < POINTS; i++)
        for (k = 0; k < 3; k++) P[i][k] = 0.9 * sym();
    for (k = 0; k < NUMBERS; k++) X[k] = sym();
    switch (rnd_below(11)) {
    case 1: /* a needle: the angle at P[0] is small */
        for (k = 0; k < 3; k++)
            P[2][k] = P[0][k] + t * (P[1][k] - P[0][k]) + d * sym();
        break;
    case 2: /* P[1] near P[0] */
        for (k = 0; k < 3; k++) P[1][k] = P[0][k] + d * sym();
        break;
    case 3: /* P[2] near P[1] */
        for (k = 0; k < 3; k++) P[2][k] = P[1][k] + d * sym();
        break;
    case 4: /* an edge along an axis, or nearly */
        for (k = 0; k < 3; k++)
            P[1][k] = P[0][k] + (k == axis ? sym() : rnd_below(2) * d * sym());
        break;
    case 5: /* its first coordinate 0, or nearly */
        P[1][0] = P[0][0] + rnd_below(2) * 1e-8 * d * sym();
        break;
    case 6: /* the right-angled and the equilateral one, turned a little */
        for (k = 0; k < 3; k++) {
            P[0][k] = 0.3 * sym();
            P[1][k] = P[0][k] + (k == axis ? 0.5 : d * sym());
            P[2][k] = P[0][k] + (k == (axis + 1) % 3   ? 0.5
                                 : t > 0.0 && k == axis ? 0.25
                                                        : d * sym());
        }
        break;
    case 7: /* coordinates of few bits */
        for (i = 0; i < 4; i++)
            for (k = 0; k < 3; k++) P[i][k] = 0.125 * (rnd_below(9) - 4);
        break;
    case 8: /* far from the origin beside its size */
        for (i = 1; i < 4; i++)
            for (k = 0; k < 3; k++) P[i][k] = P[0][k] + d * d * sym();
        break;
    case 9: /* all of it tiny */
        small = rnd_below(2) ? HH_LENGTH_MIN / d : sqrt(HH_LENGTH_MIN);
        for (i = 0; i < 4; i++)
            for (k = 0; k < 3; k++) P[i][k] *= small;
        break;
    default:
        break;
    }
    switch (rnd_below(5)) {
    case 1: /* near the plane */
        t = sym();
        u = sym();
        for (k = 0; k < 3; k++)
            P[3][k] = P[0][k] + t * (P[1][k] - P[0][k]) +
                      u * (P[2][k] - P[0][k]) + 1e-5 * d * sym();
        break;
    case 2: /* near the base */
        for (k = 0; k < 3; k++) P[3][k] = P[0][k] + d * sym();
        break;
    case 3: /* far from a small facet */
        for (i = 1; i < 3; i++)
            for (k = 0; k < 3; k++)
                P[i][k] = P[0][k] + d * (P[i][k] - P[0][k]);
        break;
    default:
        break;
    }
}

/* Another one: something of it is changed. */
static void change(void)
{
    double d = tenth(rnd_below(17)), u[3];
    int i = rnd_below(POINTS), j = rnd_below(POINTS), k = rnd_below(3);

    switch (rnd_below(9)) {
    case 0:
        P[i][k] *= 1.0 + d * sym();
        break;
    case 1:
        P[i][k] += d * sym();
        break;
    case 2: /* by last places */
        P[i][k] += (rnd_below(9) - 4) * DBL_EPSILON * P[i][k];
        break;
    case 3: /* a difference to another point */
        P[i][k] = P[j][k] + (rnd_below(3) == 0 ? 0.0 : 1.0 + d * sym()) *
                                (P[i][k] - P[j][k]);
        break;
    case 4: /* nearer to the base, or farther */
        for (k = 0; k < 3; k++)
            P[i][k] = P[0][k] + (1.0 + d * sym()) * (P[i][k] - P[0][k]);
        break;
    case 5:
        minus(P[(i + 1) % POINTS], P[0], u);
        for (k = 0; k < 3; k++) P[i][k] += d * sym() * u[k];
        break;
    case 6:
        for (k = 0; k < 3; k++) P[i][k] += d * sym();
        break;
    case 7:
        X[rnd_below(NUMBERS)] += d * sym();
        break;
    default:
        for (i = 0; i < POINTS; i++) P[i][k] += d * sym();
    }
    if (rnd_below(20) == 0) {
        mode = rnd_below(4);
        j = rnd_below(3);
        k = rnd_below(3);
        for (i = 0; i < POINTS; i++) {
            d = P[i][k];
            P[i][k] = P[i][j];
            P[i][j] = d;
        }
    }
}

static int admissible(void)
{
    int i, k;

    for (i = 0; i < POINTS; i++)
        for (k = 0; k < 3; k++)
            if (!(fabs(P[i][k]) <= 1.0)) return 0;
    for (k = 0; k < NUMBERS; k++)
        if (!(fabs(X[k]) <= 1.0)) return 0;
    return 1;
}

/* ---- the exact facet ---- */

static struct {
    vec a, b, w, n, c; /* edges, the point, the unit normal, the centre */
    real side, l, power, rho, size; /* of w: its side, L, power and length */
} E;

/* The facet base, p2, p3 and the point z; 0 if they have no such numbers. */
static int exact(const double *base, const double *p2, const double *p3,
                 const double *z)
{
    static vec o, x, y, cross;
    static real aa, bb, nn, t;
    int k;

    put(o, base);
    put(x, p2);
    off(E.a, x, o);
    put(x, p3);
    off(E.b, x, o);
    put(x, z);
    off(E.w, x, o);
    outer(cross, E.a, E.b);
    inner(&nn, cross, cross);
    if (nn.m.sign == 0) return 0;
    inner(&aa, E.a, E.a);
    inner(&bb, E.b, E.b);
    outer(x, E.b, cross);
    outer(y, cross, E.a);
    root(&t, &nn);
    scale(&nn, &nn, 2.0);
    for (k = 0; k < 3; k++) {
        over(&E.n[k], &cross[k], &t);
        mul(&x[k], &x[k], &aa);
        mul(&y[k], &y[k], &bb);
        add(&x[k], &x[k], &y[k]);
        over(&E.c[k], &x[k], &nn);
    }
    inner(&E.side, E.n, E.w);
    inner(&E.power, E.c, E.w);
    scale(&E.power, &E.power, -2.0);
    inner(&t, E.w, E.w);
    add(&E.power, &E.power, &t);
    root(&E.size, &t);
    length(&E.rho, E.c);
    if (E.side.m.sign != 0) {
        over(&E.l, &E.power, &E.side);
        scale(&E.l, &E.l, 0.5);
    }
    return 1;
}

/* The larger part of two limits, lo and hi, that x takes. */
static double between(const real *x, double lo, double hi)
{
    static real d, h, t;

    if (lo <= -DBL_MAX || hi >= DBL_MAX) return -1.0;
    set(&d, lo);
    set(&h, hi);
    add(&t, &d, &h);
    sub(&h, &h, &d);
    scale(&d, x, 2.0);
    sub(&d, &d, &t);
    d.m.sign = d.m.sign < 0 ? 1 : d.m.sign;
    if (d.m.sign == 0) return 0.0;
    if (h.m.sign <= 0) return 1e9;
    over(&d, &d, &h);
    return value(&d);
}

/* The same of a quotient whose divisor may hardly be known: of limits that are
 * of one sign and far apart take the least of x's part, 1/x's and its
 * logarithm's. */
static double quotient(const real *x, double lo, double hi)
{
    double is = between(x, lo, hi), q = value(x);

    if (is < 0.0 || is > 1.0) return is;
    if (lo / hi <= 0.0) return 0.0; /* the power's error, which `ratio' has */
    if (fabs(log(lo / hi)) < 0.5) return is;
    is = lesser(is, fabs(2.0 * log(q / lo) / log(hi / lo) - 1.0));
    return lesser(is, fabs(2.0 * (1.0 / q - 1.0 / lo) / (1.0 / hi - 1.0 / lo) -
                           1.0));
}

/* |u - x| of a vector that was computed */
static void miss(real *r, const double *x, const real *u)
{
    static vec d;

    put(d, x);
    off(d, d, u);
    length(r, d);
}

/* ---- the bounds: what is computed, and how much of the bound its error is; -1
 * where there is no bound ---- */

static void do_setup(void)
{
    hh_setup(P[0], P[1], P[2], out);
    out[20] = hh_side(out, P[3]);
}

static int has_setup(void)
{
    return out[HH_E] <= HH_E_MAX && exact(P[0], P[1], P[2], P[3]) &&
           value(&E.size) >= HH_LENGTH_MIN;
}

static double side(void)
{
    static real d;

    if (!has_setup()) return -1.0;
    set(&d, out[20]);
    sub(&d, &d, &E.side);
    over(&d, &d, &E.size);
    return part(&d, out[HH_E]);
}

static double normal(void)
{
    static real d;

    if (!has_setup()) return -1.0;
    miss(&d, out, E.n);
    return part(&d, out[HH_E]);
}

static double circumcentre(void)
{
    static real d;

    if (!has_setup()) return -1.0;
    miss(&d, out + HH_CENTRE, E.c);
    return part(&d, out[HH_DC]);
}

static double circumradius(void)
{
    static real d;

    if (!has_setup()) return -1.0;
    set(&d, out[HH_RHO]);
    sub(&d, &d, &E.rho);
    return part(&d, out[HH_DC]);
}

static void do_limits(void)
{
    hh_setup(P[0], P[1], P[2], out);
    out[20] = hh_limits(out, P[3], out + 21, out + 22);
}

static double limits(void)
{
    if (!has_setup() || out[20] == 0.0) return -1.0;
    if (E.side.m.sign != (int)out[20]) return 1e9;
    return out[20] > 0.0 ? between(&E.l, out[21], out[22]) : -1.0;
}

/* what hhpred.h says of hh_lcoord */
static void do_lcoord(void)
{
    (void)hh_facet(P[0], P[1], P[2], out);
    out[20] = hh_side(out, P[3]);
    out[21] = hh_lcoord(out, P[3]);
}

static double lcoord(void)
{
    static real d;
    double size, gap, l = out[21];

    if (!has_setup()) return -1.0;
    size = value(&E.size);
    gap = fabs(out[20]) - out[HH_E] * size;
    if (!(gap > 1e-12 * size)) return -1.0;
    set(&d, l);
    sub(&d, &d, &E.l);
    return part(&d, size *
                            (EPS * (3.0 * size + 5.0 * out[HH_RHO]) +
                             out[HH_DC] + fabs(l) * out[HH_E]) /
                            gap +
                        4.0 * EPS * fabs(l));
}

/* with a side of 1/2 the limits are those of the power */
static void do_ratio(void)
{
    hh_setup(P[0], P[1], P[2], out);
    hh_ratio(out, P[3], 0.5, 0.5, out + 21, out + 22);
}

static double ratio(void)
{
    return has_setup() ? between(&E.power, out[21], out[22]) : -1.0;
}

/* the points as a set, and the facet 0, 1, 2 */
static void begin(void)
{
    int k;

    memset(&M, 0, sizeof M);
    memset(&S, 0, sizeof S);
    for (k = 0; k < POINTS; k++) order[k] = (tess_int)k;
    for (k = 0; k < 8; k++) first[k] = NONE;
    M.x = P[0];
    M.points.x = P[0];
    M.points.p = P[0];
    M.points.order = order;
    M.points.exact3 = M.points.exact5 = -1.0;
    M.np = POINTS;
    M.leaves = 4;
    M.box = box;
    M.mark = marks;
    M.edge_from = first;
    for (k = 0; k < 3; k++) S.facet[k] = (tess_int)k;
    S.best = S.limbs.outside_ball = S.limbs.behind_facet = NONE;
    S.surface.number = NONE;
    S.filter.allowance = UNDERFLOW_ERR;
    S.lo = -DBL_MAX;
    S.hi = DBL_MAX;
}

/* The facet's vertex opposite to its longest edge. */
static int opposite(void)
{
    double u[3], d, most = 0.0;
    int k, base = 0;

    for (k = 0; k < 3; k++) {
        minus(P[(k + 1) % 3], P[(k + 2) % 3], u);
        d = dot(u, u);
        if (d > most) base = k;
        if (d > most) most = d;
    }
    return base;
}

static void do_thin(void)
{
    begin();
    S.base = opposite();
    out[20] = hh_thin(&M.points, S.facet, S.base, out);
    if (out[20] > 0.0) out[21] = hh_side(out, P[3]);
}

/* The comment's bounds: E and dc are far above them, if they are. */
static int has_thin(void)
{
    return out[20] > 0.0 &&
           exact(P[S.base], P[(S.base + 1) % 3], P[(S.base + 2) % 3], P[3]) &&
           value(&E.size) >= HH_LENGTH_MIN;
}

static double thin_side(void)
{
    static real d;

    if (!has_thin()) return -1.0;
    set(&d, out[21]);
    sub(&d, &d, &E.side);
    over(&d, &d, &E.size);
    return part(&d, lesser(16.0 * EPS, out[HH_E]));
}

static double thin_centre(void)
{
    static real d;

    if (!has_thin()) return -1.0;
    miss(&d, out + HH_CENTRE, E.c);
    over(&d, &d, &E.rho);
    return part(&d, lesser(60.0 * EPS, out[HH_DC] / out[HH_RHO]));
}

/* of any base its normal */
static void do_thin_any(void)
{
    begin();
    S.base = 0;
    out[20] = hh_thin(&M.points, S.facet, 0, out);
}

static double thin_normal(void)
{
    static real d;

    if (!has_thin()) return -1.0;
    miss(&d, out, E.n);
    return part(&d, 16.0 * EPS);
}

/* the centre by limbs, and what is made of it */
static void do_centre(void)
{
    begin();
    out[20] = hh_centre(&M.points, S.facet, 0, 3, out, &S.limbs.ball);
}

/* c - C of the ball through the four points, of each coordinate.  (One of 0 is
 * one of 1e-90 of the others to the judge, or less.) */
static double centre(void)
{
    static vec c;
    static real t;
    double most = 0.0, far, is;
    int k;

    if (out[20] < 1.0 || !exact(P[0], P[1], P[2], P[3])) return -1.0;
    along(c, E.c, &E.l, E.n);
    length(&t, c);
    far = value(&t);
    for (k = 0; k < 3; k++) {
        set(&t, out[k]);
        sub(&t, &t, &c[k]);
        is = part(&t, 8.0 * EPS * fabs(value(&c[k])) + 1e-90 * far);
        if (is > most) most = is;
    }
    return most;
}

static void do_upper(void)
{
    int k;

    begin();
    hh_setup(P[0], P[1], P[2], S.hh);
    for (k = 0; k < HH_FACET_LEN; k++) out[k] = S.hh[k];
    out[20] = X[0] / tenth((int)(10.0 * fabs(X[1])));
    set_upper_bound(&M, &S, out[20]);
}

static double upper(void)
{
    static real l, d;
    static vec c;

    if (!has_setup()) return -1.0;
    set(&l, out[20]);
    along(c, E.c, &l, E.n);
    miss(&d, S.filter.c, c);
    return part(&d, S.filter.dc);
}

static void do_ball(void)
{
    begin();
    hh_setup(P[0], P[1], P[2], S.hh);
    S.best = 3;
    ball_by_limbs(&M, &S);
}

static double ball(void)
{
    if (!S.by_limbs || S.hh[HH_E] > HH_E_MAX) return -1.0;
    if (!exact(P[0], P[1], P[2], P[3])) return 1e9;
    return between(&E.l, S.lo, S.hi);
}

/* ---- surfaces ----
 *
 * The facet 0, 1, 2 and the point 3 are moved near a plane or a sphere, which
 * is set up from a record.  With marks, which are the half of their bound off,
 * roundings hardly show. */

static int plane, with_marks;

/* the digits of x in a record, in its unit */
static void digits_of(double x, tess_int *digit)
{
    int i;

    for (i = 0; i < DIGITS; i++) {
        x *= DIGIT;
        digit[i] = (tess_int)x;
        x -= (double)digit[i];
    }
}

static void draw_surface(int of_plane)
{
    double c[3], r, t, noise = tenth(6 + rnd_below(9));
    int i, k;

    do draw_facet();
    while (!admissible());
    plane = of_plane;
    with_marks = 0;
    for (k = 0; k < 3; k++) P[4][k] = 0.5 * sym(); /* the origin */
    if (!plane) /* the centre's direction may be far */
        for (k = 0; k < 3; k++) P[5][k] = P[4][k] + 0.5 * sym();
    minus(P[5], P[4], c);
    r = sqrt(dot(c, c));
    for (i = 0; i < 4; i++) {
        double u[3];

        minus(P[i], plane ? P[4] : P[5], u);
        t = plane ? dot(u, c) / (r * r) : 1.0 - r / sqrt(dot(u, u));
        for (k = 0; k < 3; k++)
            P[i][k] -= t * (plane ? c[k] : u[k]) + noise * sym();
    }
    if (rnd_below(3) == 0) /* two vertices near each other */
        for (k = 0; k < 3; k++)
            P[1][k] = P[0][k] + (1e3 * noise + 1e-4) * (P[1][k] - P[0][k]);
}

static void draw_plane(void) { draw_surface(1); }
static void draw_sphere(void) { draw_surface(0); }

static void draw_marked(void)
{
    draw_surface(rnd_below(2));
    with_marks = 1;
}

/* The surface of the points: c is what its record holds. */
static int set_surface(void)
{
    double c[3], most = 0.0;
    ref_surface *r;
    int e = 0, i, k, code;

    begin();
    for (i = 0; i < POINTS + 200; i++) marks[i] = 0;
    r = surface_record(&M, 0);
    M.surfaces.known = 1;
    minus(P[5], P[4], c);
    if (plane) {
        most = sqrt(dot(c, c));
        for (k = 0; k < 3; k++) c[k] /= most;
    }
    most = 0.0;
    for (k = 0; k < 3; k++) most = larger(most, fabs(c[k]));
    if (!(most > 0.0 && most < 2.0)) return 0;
    frexp(most, &e);
    r->record[RECORD_POINT] = 4;
    r->record[RECORD_PLANE] = (tess_int)plane;
    r->record[RECORD_UNIT] = (tess_int)(EXPONENT + e);
    r->record[RECORD_QUANTUM] = EXPONENT;
    for (k = 0; k < 3; k++)
        digits_of(ldexp(c[k], -e), r->record + RECORD_DIGITS + DIGITS * k);
    if (!surface_from_record(&M, r)) return 0;
    most = 0.0;
    for (i = 0; i < 4; i++) {
        most = larger(most, fabs(hh_height(&M.points, &r->limbs, (tess_int)i,
                                           c)));
    }
    frexp(most * (4.0 / (double)MARKS) + UNDERFLOW_ERR, &e);
    if (X[4] > 0.5) e += (int)(40.0 * (X[4] - 0.5));
    r->record[RECORD_QUANTUM] = (tess_int)(EXPONENT + e);
    code = surface_from_record(&M, r);
    if (with_marks) { /* all of the points, or some */
        M.leaves = 1;
        (void)mark_leaf(&M, 0, 1);
        M.leaves = 4;
        for (i = 0; i < 4; i++)
            if (X[3] > 0.8 && i % 2 == 0) marks[i] = 0;
    }
    return code;
}

/* the exact heights of the vertices over the base's, and of the point */
static vec normal_of, over_base;
static real height_of[4];

static void exact_height(real *h, const double *z)
{
    static vec x, y, o;
    static real t;

    put(o, M.surfaces.surface[0].origin);
    put(x, z);
    off(x, x, o);
    put(normal_of, M.surfaces.surface[0].c);
    if (plane) {
        inner(h, x, normal_of);
        return;
    }
    off(y, x, normal_of);
    inner(h, y, y);
    inner(&t, normal_of, normal_of);
    sub(h, h, &t);
}

static void do_height(void)
{
    out[20] = set_surface();
    if (out[20] == 0.0) return;
    out[0] = hh_height(&M.points, &M.surfaces.surface[0].limbs, 3, out + 1);
    out[2] = rounded_height(&M, M.surfaces.surface, 3, out + 3);
    out[4] = marked_height(&M, 0, 3, out + 5);
}

static double height(void)
{
    static real d, t;

    if (out[20] == 0.0) return -1.0;
    exact_height(&d, P[3]);
    set(&t, out[0]);
    sub(&t, &t, &d);
    return part(&t, out[1]);
}

static double rough(void)
{
    static real d, t;

    if (out[20] == 0.0) return -1.0;
    exact_height(&d, P[3]);
    set(&t, out[2]);
    sub(&t, &t, &d);
    return part(&t, out[3]);
}

static double marked(void)
{
    static real d, t;

    if (out[20] == 0.0 || out[4] == 0.0) return -1.0;
    exact_height(&d, P[3]);
    set(&t, out[5]);
    sub(&t, &t, &d);
    return part(&t, M.surfaces.surface[0].quantum);
}

/* the facet with its surface, and what the surface says of the point */
static void do_tilt(void)
{
    int k;

    out[20] = set_surface();
    if (out[20] == 0.0) return;
    hh_setup(P[0], P[1], P[2], S.hh);
    choose_surface(&M, &S);
    if (S.surface.number == NONE) return;
    out[10] = -DBL_MAX;
    out[11] = DBL_MAX;
    k = hh_limits(S.hh, P[3], out + 12, out + 13);
    out[14] = k < 0 ? -1.0
                    : (double)sharpen_by_height(&M, &S, 3, k, out + 10,
                                                out + 11);
    out[15] = (double)k;
    /* a ball through the point, or nearly, if there is one */
    S.has_ball = X[5] > -0.9;
    S.hi = X[5] / tenth((int)(5.0 * fabs(X[0])));
    if (X[0] > 0.0 && k == 1 && fabs(out[12] + out[13]) < L_MAX)
        S.hi = 0.5 * (out[12] + out[13]) + 1e-14 * S.hi;
    set_surface_filter(&M, &S);
}

static vec tilt_of;

/* The exact facet, heights and tilt. */
static int has_tilt(void)
{
    static real aa, bb, ab, det, s, t, ha, hb;
    static vec zero;
    int i;

    if (out[20] == 0.0 || S.surface.number == NONE ||
        !exact(P[0], P[1], P[2], P[3]))
        return 0;
    for (i = 0; i < 4; i++) exact_height(&height_of[i], P[i]);
    inner(&aa, E.a, E.a);
    inner(&bb, E.b, E.b);
    inner(&ab, E.a, E.b);
    mul(&det, &aa, &bb);
    mul(&t, &ab, &ab);
    sub(&det, &det, &t);
    sub(&ha, &height_of[1], &height_of[0]);
    sub(&hb, &height_of[2], &height_of[0]);
    mul(&s, &ha, &bb);
    mul(&t, &hb, &ab);
    sub(&s, &s, &t);
    over(&s, &s, &det);
    for (i = 0; i < 3; i++) set(&zero[i], 0.0);
    along(tilt_of, zero, &s, E.a);
    mul(&s, &hb, &aa);
    mul(&t, &ha, &ab);
    sub(&s, &s, &t);
    over(&s, &s, &det);
    along(tilt_of, tilt_of, &s, E.b);
    return 1;
}

static double tilt(void)
{
    static real d;

    if (!has_tilt()) return -1.0;
    miss(&d, S.surface.tilt, tilt_of);
    return part(&d, S.surface.tilt_err);
}

/* the point of the axis from which L is counted: over_base */
static void exact_axis(void)
{
    static vec x;
    static real half;
    int k;

    for (k = 0; k < 3; k++) copy(&over_base[k], &E.c[k]);
    if (plane) return;
    put(x, P[0]);
    put(over_base, M.surfaces.surface[0].origin);
    off(over_base, over_base, x);
    put(x, M.surfaces.surface[0].c);
    set(&half, 1.0);
    along(over_base, over_base, &half, x); /* the sphere's centre */
    set(&half, 0.5);
    along(over_base, over_base, &half, tilt_of);
}

static double recentred(void)
{
    static real d;

    if (!has_tilt()) return -1.0;
    exact_axis();
    miss(&d, S.hh + HH_CENTRE, over_base);
    return part(&d, S.hh[HH_DC]);
}

/* N - 2 l side of the point, from the axis's point */
static void exact_power(real *r, const real *l)
{
    static real t;

    exact_axis();
    inner(r, over_base, E.w);
    scale(r, r, -2.0);
    inner(&t, E.w, E.w);
    add(r, r, &t);
    mul(&t, l, &E.side);
    scale(&t, &t, -2.0);
    add(r, r, &t);
}

static double sharpened(void)
{
    static real d, none;

    if (!has_tilt() || out[14] == 0.0) return -1.0;
    if (E.side.m.sign != (int)out[14]) return 1e9;
    if (out[14] < 0.0) return -1.0;
    set(&none, 0.0);
    exact_power(&d, &none);
    over(&d, &d, &E.side);
    scale(&d, &d, 0.5);
    return quotient(&d, out[10], out[11]);
}

/* A better point has N - 2 l side <= 0 and passes the filter: what the
 * left-hand side of the filter exceeds that by is its error. */
static double filtered(void)
{
    static real d, f, t, l;
    static vec c;
    const ball_filter *b = &S.surface.filter;
    double give = b->allowance;

    if (!has_tilt() || E.side.m.sign < 0) return -1.0;
    put(c, b->c);
    inner(&f, c, E.w);
    scale(&f, &f, -2.0);
    inner(&t, E.w, E.w);
    add(&f, &f, &t);
    set(&t, b->base_height);
    sub(&t, &height_of[3], &t);
    scale(&t, &t, b->weight);
    add(&f, &f, &t);
    set(&l, S.has_ball && fabs(S.hi) <= L_MAX ? S.hi : 0.5 * L_MAX);
    if (value(&l) < 1e50) {
        exact_power(&d, &l);
        set(&t, plane ? 0.0 : b->weight);
        set(&l, 1.0);
        add(&t, &t, &l); /* 1/q, but for the roundings of weight */
        give += 4.0 * EPS * fabs(b->weight * value(&d));
        mul(&d, &d, &t);
        sub(&f, &f, &d);
    }
    if (f.m.sign < 0) return 0.0;
    return value(&f) / (give + value(&E.size) * 2.0 * b->dc);
}

/* ---- cylinders ---- */

static void draw_cylinder(void)
{
    double t, d = tenth(rnd_below(12)), e = tenth(rnd_below(12)), u[3], v[3];
    int i, k;

    for (i = 0; i < POINTS; i++)
        for (k = 0; k < 3; k++) P[i][k] = 0.3 * sym();
    for (k = 0; k < NUMBERS; k++) X[k] = sym();
    for (k = 0; k < 3; k++) u[k] = 0.5 * sym(), v[k] = 0.5 * sym();
    for (i = 1; i < POINTS; i++)
        for (k = 0, t = sym(); k < 3; k++)
            P[i][k] = P[0][k] + t * u[k] + e * sym() * v[k] + d * e * sym();
    if (rnd_below(2))
        for (i = 0; i < POINTS; i++)
            for (k = 0; k < 3; k++) P[i][k] = 0.9 + 0.05 * P[i][k];
    X[0] *= rnd_below(2) * d;
    X[1] *= rnd_below(2) * e;
}

static void do_cylinder(void)
{
    double *b = box + 6;
    int i, k;

    begin();
    M.leaves = 1;
    for (k = 0; k < 3; k++) {
        b[k] = b[3 + k] = P[0][k];
        for (i = 1; i < POINTS; i++) {
            b[k] = lesser(b[k], P[i][k]);
            b[3 + k] = larger(b[3 + k], P[i][k]);
        }
    }
    (void)make_cylinder(&M, 1, out);
}

/* Along its axis and across it a point may miss by the pad, once it is taken
 * off. */
static double cylinder(void)
{
    static vec c, u, x;
    static real uu, s, t, r;
    double pad = 0.0, most = 0.0, is;
    int i, k;

    for (k = 0; k < 3; k++) {
        pad += 64.0 * EPS * (fabs(box[6 + k]) + fabs(box[9 + k]));
        set(&c[k], out[4 * k]);
        set(&u[k], out[12 + 4 * k]);
    }
    inner(&uu, u, u);
    root(&t, &uu);
    for (k = 0; k < 3; k++) over(&u[k], &u[k], &t);
    for (i = 0; i < POINTS; i++) {
        put(x, P[i]);
        off(x, x, c);
        inner(&s, x, u);
        inner(&r, x, x);
        mul(&t, &s, &s);
        sub(&r, &r, &t);
        root(&r, &r);
        s.m.sign = s.m.sign < 0 ? 1 : s.m.sign;
        set(&t, out[24]);
        sub(&s, &s, &t);
        is = 1.0 + value(&s) / pad;
        set(&t, out[28]);
        sub(&r, &r, &t);
        is = larger(is, 1.0 + value(&r) / pad);
        most = larger(most, is);
    }
    return most;
}

/* A cylinder of centre P[1], axis P[2] and sizes X[0], X[1], and a ball of
 * centre P[3] about the base P[0]: out[20] is the greatest allowance with which
 * it is excluded, that is, the least power in it but for the margin. */
static void do_excluded(void)
{
    double *c = box + 6 * 8, past[4], lo, hi, u, r;
    int i, k;

    begin();
    r = sqrt(dot(P[2], P[2]));
    for (i = 0; i < 4; i++) {
        for (k = 0; k < 3; k++) {
            c[4 * k + i] = P[1][k];
            c[12 + 4 * k + i] = P[2][k] / r;
        }
        c[24 + i] = fabs(X[0]) + HH_LENGTH_MIN;
        c[28 + i] = fabs(X[1]) + HH_LENGTH_MIN;
    }
    for (k = 0; k < 3; k++) {
        S.hh[HH_BASE + k] = P[0][k];
        S.filter.c[k] = (1.0 + 100.0 * X[4] * X[4]) * P[3][k];
    }
    S.filter.c1 = norm1(S.filter.c);
    hi = 1e6;
    lo = -hi;
    for (i = 0; i < 200; i++) {
        u = 0.5 * (lo + hi);
        if (u <= lo || u >= hi) break;
        S.filter.allowance = u;
        exclude_cylinders(&M, &S, 1, past);
        if (past[0] > 0.0) lo = u;
        else hi = u;
    }
    out[20] = lo;
}

static double excluded(void)
{
    static vec w, g, u, c, x;
    static real uu, a, gg, rho, t, h, r, low, two;
    const double *b = box + 6 * 8;
    double size = 2.0 * (b[24] + b[28]), margin;
    int k;

    if (out[20] <= -1e6) return -1.0;
    for (k = 0; k < 3; k++) {
        set(&w[k], b[4 * k]);
        set(&u[k], b[12 + 4 * k]);
        size += fabs(b[4 * k] - P[0][k]);
    }
    set(&two, 2.0);
    put(x, P[0]);
    off(w, w, x);
    put(c, S.filter.c);
    off(g, w, c);
    off(x, g, c);
    inner(&low, w, x);
    inner(&uu, u, u);
    inner(&gg, g, g);
    inner(&a, g, u);
    mul(&t, &a, &a);
    over(&t, &t, &uu);
    sub(&rho, &gg, &t);
    root(&rho, &rho);
    a.m.sign = a.m.sign < 0 ? 1 : a.m.sign;
    /* the least s^2 uu - 2 s a, s <= h */
    over(&t, &a, &uu);
    set(&h, b[24]);
    sub(&r, &t, &h);
    if (r.m.sign < 0) copy(&h, &t);
    mul(&t, &h, &uu);
    scale(&r, &a, -2.0);
    add(&t, &t, &r);
    mul(&t, &t, &h);
    add(&low, &low, &t);
    /* the least R^2 - 2 R rho, R <= r */
    set(&h, b[28]);
    sub(&r, &rho, &h);
    if (r.m.sign < 0) copy(&h, &rho);
    scale(&t, &rho, -2.0);
    add(&t, &t, &h);
    mul(&t, &t, &h);
    add(&low, &low, &t);
    margin = size * (128.0 * EPS * S.filter.c1 + 64.0 * EPS * size);
    set(&t, out[20]);
    sub(&t, &t, &low);
    return 1.0 + value(&t) / margin;
}

/* ---- near lists ----
 *
 * A facet with an upper bound of L, and the centre of a list: the least reach
 * with which the list holds the ball is to be no less than the distance of the
 * farthest point of the ball on the open side. */
static void draw_near(void)
{
    int k;

    draw_facet();
    hh_setup(P[0], P[1], P[2], out);
    X[5] *= tenth(rnd_below(12));
    /* the list's centre near the axis */
    for (k = 0; k < 3; k++)
        P[3][k] = P[0][k] + out[HH_CENTRE + k] + X[2] * out[k] + X[5] * sym();
}

static void do_near(void)
{
    double lo = 0.0, hi = 1e5, r;
    int i;

    begin();
    hh_setup(P[0], P[1], P[2], S.hh);
    for (i = 0; i < HH_FACET_LEN; i++) out[i] = S.hh[i];
    S.hi = X[0] / tenth((int)(4.0 * fabs(X[1])));
    near_list.n = 1;
    for (i = 0; i < 3; i++) near_list.centre[i] = P[3][i];
    for (i = 0; i < 200; i++) {
        r = 0.5 * (lo + hi);
        if (r <= lo || r >= hi) break;
        near_list.reach = r;
        if (ball_in_near_list(&S, &near_list)) hi = r;
        else lo = r;
    }
    out[20] = hi;
}

static double held(void)
{
    static vec u, c, x, y;
    static real l, r, d, t, s;
    double h, err, reach = out[20], size = 0.0, g = 0.0, give;
    int k;

    if (!has_setup() || reach >= 1e5) return -1.0;
    /* u: from the list's centre to the ball's */
    set(&l, S.hi);
    along(c, E.c, &l, E.n);
    off(u, c, E.w);
    length(&r, c);
    length(&d, u);
    /* the farthest point of the ball; on which side is it? */
    if (d.m.sign > 0) {
        over(&t, &r, &d);
        along(x, c, &t, u);
    } else
        copy(&x[0], &c[0]), copy(&x[1], &c[1]), copy(&x[2], &c[2]);
    inner(&s, x, E.n);
    if (s.m.sign >= 0 && d.m.sign > 0)
        add(&d, &d, &r);
    else { /* the farthest of the facet's circle */
        off(y, E.c, E.w);
        inner(&s, y, E.n);
        s.m.sign = -s.m.sign;
        along(y, y, &s, E.n);
        length(&t, y);
        add(&t, &t, &E.rho);
        mul(&t, &t, &t);
        mul(&s, &s, &s);
        add(&t, &t, &s);
        root(&d, &t);
    }
    for (k = 0; k < 3; k++) g += (P[3][k] - P[0][k]) * out[k];
    h = S.hi > 0.0 || g < S.hi ? S.hi : g;
    for (k = 0; k < 3; k++) size += fabs(out[HH_CENTRE + k] + h * out[k]);
    err = out[HH_DC] + fabs(h) * out[HH_E] + 4.0 * EPS * size;
    give = reach * (32.0 * err + ROUNDING * (1.0 + reach));
    mul(&d, &d, &d);
    set(&t, reach);
    mul(&t, &t, &t);
    sub(&d, &d, &t);
    return 1.0 + value(&d) / give;
}

static void draw_star(void)
{
    int i, k;

    draw_facet();
    for (i = 1; i < 3; i++)
        for (k = 0; k < 3; k++)
            P[i][k] = P[0][k] + 0.2 * (P[i][k] - P[0][k]);
    X[0] *= 0.1;
    X[1] = 0.0;
}

/* The ball of L = hi: the star list holds it from that reach on; its farthest
 * point from the base is opposite to that. */
static void do_star(void)
{
    double lo = 0.0, hi = 1e5, r;
    int i;

    do_upper();
    for (i = 0; i < 3; i++) {
        box[6 + i] = -1.0;
        box[9 + i] = 1.0;
    }
    for (i = 0; i < 200; i++) {
        r = 0.5 * (lo + hi);
        if (r <= lo || r >= hi) break;
        M.lists.star.reach = r;
        if (ball_in_star_list(&M, &S)) hi = r;
        else lo = r;
    }
    out[21] = hi;
}

static double starred(void)
{
    static vec c, x;
    static real l, t;
    int k;

    if (!has_setup() || out[21] >= 1e5) return -1.0;
    set(&l, out[20]);
    along(c, E.c, &l, E.n);
    set(&l, 2.0);
    put(x, P[0]);
    along(x, x, &l, c);
    for (k = 0; k < 3; k++)
        if (fabs(value(&x[k])) > 1.0) return -1.0;
    length(&t, c);
    scale(&t, &t, 2.0);
    set(&l, out[21]);
    sub(&t, &t, &l);
    return 1.0 + value(&t) / (ROUNDING * out[21] + 2.0 * S.filter.dc);
}

/* ---- the search ---- */

static const struct bound {
    const char *name;
    void (*draw)(void);
    void (*compute)(void);
    double (*judge)(void);
} bounds[] = {
    { "side", draw_facet, do_setup, side },
    { "normal", draw_facet, do_setup, normal },
    { "circumcentre", draw_facet, do_setup, circumcentre },
    { "circumradius", draw_facet, do_setup, circumradius },
    { "limits", draw_facet, do_limits, limits },
    { "lcoord", draw_facet, do_lcoord, lcoord },
    { "ratio", draw_facet, do_ratio, ratio },
    { "upper", draw_facet, do_upper, upper },
    { "thin_normal", draw_facet, do_thin_any, thin_normal },
    { "thin_side", draw_facet, do_thin, thin_side },
    { "thin_centre", draw_facet, do_thin, thin_centre },
    { "centre", draw_facet, do_centre, centre },
    { "ball", draw_facet, do_ball, ball },
    { "height_plane", draw_plane, do_height, height },
    { "height_sphere", draw_sphere, do_height, height },
    { "rough_plane", draw_plane, do_height, rough },
    { "rough_sphere", draw_sphere, do_height, rough },
    { "marked", draw_marked, do_height, marked },
    { "tilt_plane", draw_plane, do_tilt, tilt },
    { "tilt_sphere", draw_sphere, do_tilt, tilt },
    { "tilt_marked", draw_marked, do_tilt, tilt },
    { "recentred", draw_sphere, do_tilt, recentred },
    { "sharpened_plane", draw_plane, do_tilt, sharpened },
    { "sharpened_sphere", draw_sphere, do_tilt, sharpened },
    { "filtered_plane", draw_plane, do_tilt, filtered },
    { "filtered_sphere", draw_sphere, do_tilt, filtered },
    { "filtered_marked", draw_marked, do_tilt, filtered },
    { "cylinder", draw_cylinder, do_cylinder, cylinder },
    { "excluded", draw_cylinder, do_excluded, excluded },
    { "star_list", draw_star, do_star, starred },
    { "near_list", draw_near, do_near, held }
};
#define BOUNDS ((int)(sizeof bounds / sizeof bounds[0]))

/* the ratio of what P and X are */
static double try_it(const struct bound *b)
{
    void (*volatile compute)(void) = b->compute;
#ifdef TEST_ROUNDING
    static const int modes[4] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                  FE_TOWARDZERO };

    fesetround(modes[mode]);
#endif
    compute();
#ifdef TEST_ROUNDING
    fesetround(FE_TONEAREST);
#endif
    return b->judge();
}

static void show(double worst)
{
    int i;

    printf("# rounding mode %d, plane %d, ratio %.17g:\n", mode, plane,
           worst);
    for (i = 0; i < POINTS; i++)
        printf("# %.17g %.17g %.17g\n", P[i][0], P[i][1], P[i][2]);
    for (i = 0; i < NUMBERS; i++) printf("# %.17g\n", X[i]);
}

/* Climbs from one drawn case after another, or again from the worst: after
 * PATIENCE changes in vain it begins anew. */
#define PATIENCE 150
static void search_for(const struct bound *b, long steps)
{
    static struct kept last, worst;
    int vain = PATIENCE, bad = 0;
    long i, tried = 0;
    double r;

    worst.ratio = -1.0;
    for (i = 0; i < steps; i++) {
        if (vain >= PATIENCE) {
            vain = 0;
            last.ratio = -2.0;
            if (worst.ratio > 0.0 && rnd_below(3)) {
                take(&worst);
                keep(&last, worst.ratio);
            } else {
                b->draw();
                mode = rnd_below(4);
            }
        }
        if (last.ratio > -2.0) {
            do change();
            while (rnd_below(2));
        }
        r = admissible() ? try_it(b) : -2.0;
        tried += r > -1.0;
        if (r > 1.0 && bad++ == 0) show(r);
        if (r > worst.ratio) keep(&worst, r);
        if (r >= last.ratio && r > -2.0) {
            vain = r > last.ratio ? vain / 2 : vain + 1;
            keep(&last, r);
        } else if (last.ratio > -2.0) {
            take(&last);
            vain++;
        } else
            vain = PATIENCE;
    }
    printf("# %s: worst ratio %.3g\n", b->name, worst.ratio);
    /* what has no case is no test */
    test_result(b->name, worst.ratio > 1.0 || tried < steps / 50);
}

int main(int argc, char **argv)
{
    static const char usage[] = "[-steps N] [-seed K] [NAME...]";
    long steps = 4000, seed = 1, i;
    int done = 0, k;

    while (argc > 2 && argv[1][0] == '-') {
        if (strcmp(argv[1], "-steps") == 0)
            steps = test_number(argv[2], 50L, argv, usage);
        else if (strcmp(argv[1], "-seed") == 0)
            seed = test_number(argv[2], 0L, argv, usage);
        else
            test_usage("worst", usage);
        argc -= 2;
        argv += 2;
    }
    for (i = 0; i < BOUNDS; i++) {
        for (k = 1; k < argc && strcmp(argv[k], bounds[i].name) != 0; k++)
            ;
        if (argc > 1 && k == argc) continue;
        rnd_seed((unsigned long)seed);
        search_for(bounds + i, steps);
        done++;
    }
    if (done < argc - 1 || done == 0) test_usage("worst", usage);
    return test_end();
}
