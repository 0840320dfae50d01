/* t_facet.c - tests of the facets of hhpred.c against exact integer arithmetic
 * (exact.c), on points made to be hard; t_pred.c has the signs.
 *
 *     t_facet [percent [seed]]   percent of the usual number of cases
 *
 * Covered: hh_facet's codes, normal and centre; the bounds that hhpred.h promises
 * for hh_side, hh_lcoord and hh_limits, and the ones derived below for hh_wrap;
 * the certificates made of these bounds (a side, an order of two L-coordinates)
 * must never be wrong, and must decide nearly all random points.  A failure
 * prints the points in full.
 *
 * Compiled with few limbs (-DHH_LIMBS=3, hhpred.c likewise), codes may differ
 * where the limbs do not suffice.
 * With -DTEST_ROUNDING (C99's fenv.h) all is done in four rounding modes.
 */
#include "lib/five.h"
#include "../lib/exact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static long percent = 100;

/* ---- Householder ---- */

/* The exact quantities of a facet p1 p2 p3 and a point z, in units of a power
 * of two: a = p2-p1, b = p3-p1, N = a x b, NN = N.N, u = |a|^2 (b x N) +
 * |b|^2 (N x a), so that c - p1 = u / (2 NN); w = z-p1, wn = w.N, so that
 * the distance is wn / |N|; power = |w|^2 NN - u.w, so that L = power /
 * (2 |N| wn). */
static struct {
    ex_num a[3], b[3], n[3], nn, u[3], w[3], ww, wn, power, nxa[3], wg, aa;
    int low;
} X;

static void exact_facet(int low)
{
    static ex_num t, s, bb, c[3];
    int k;

    X.low = low;
    for (k = 0; k < 3; k++) {
        ex_real(&t, P[0][k], low);
        ex_real(&s, P[1][k], low);
        ex_sub(&X.a[k], &s, &t);
        ex_real(&s, P[2][k], low);
        ex_sub(&X.b[k], &s, &t);
    }
    ex_cross(X.n, X.a, X.b);
    ex_dot(&X.nn, X.n, X.n);
    ex_dot(&X.aa, X.a, X.a);
    ex_dot(&bb, X.b, X.b);
    ex_cross(c, X.b, X.n);
    ex_cross(X.nxa, X.n, X.a);
    for (k = 0; k < 3; k++) {
        ex_mul(&t, &X.aa, &c[k]);
        ex_mul(&s, &bb, &X.nxa[k]);
        ex_add(&X.u[k], &t, &s);
    }
}

static void exact_point(const double *z)
{
    static ex_num t, s;
    int k;

    for (k = 0; k < 3; k++) {
        ex_real(&t, P[0][k], X.low);
        ex_real(&s, z[k], X.low);
        ex_sub(&X.w[k], &s, &t);
    }
    ex_dot(&X.ww, X.w, X.w);
    ex_dot(&X.wn, X.w, X.n);
    ex_dot(&X.wg, X.w, X.nxa);
    ex_mul(&X.power, &X.ww, &X.nn);
    ex_dot(&t, X.u, X.w);
    ex_sub(&X.power, &X.power, &t);
}

/* m 2^e */
static long double stretch(long double m, int e)
{
    for (; e > 500; e -= 500) m *= (long double)ldexp(1.0, 500);
    for (; e < -500; e += 500) m *= (long double)ldexp(1.0, -500);
    return m * (long double)ldexp(1.0, e);
}

/* The value of num / (den |square|^(1/2)) with a relative error of a few
 * LDBL_EPSILON; degree is that of the quotient in the unit of the points. */
static long double quotient(const ex_num *num, const ex_num *den,
                            const ex_num *square, int degree)
{
    long double m, d, q, r;
    int e, f, g;

    m = ex_value(num, &e);
    if (m == 0.0L) return m;
    d = ex_value(den, &f);
    q = ex_value(square, &g);
    if (g % 2) {
        q *= 2.0L;
        g -= 1;
    }
    r = (long double)sqrt((double)q);
    r = 0.5L * (r + q / r);
    return stretch(m / (d * r), e - f - g / 2 + degree * X.low);
}

/* the exact sign of x + s dx - num / (den |square|^(1/2)) */
static int beyond(double x, int s, double dx, const ex_num *num,
                  const ex_num *den, const ex_num *square, int degree)
{
    static ex_num t, d, n, a, b;
    int low = ex_low(x, ex_low(dx, degree * X.low)), o;

    ex_real(&t, x, low);
    ex_real(&d, s * dx, low);
    ex_add(&t, &t, &d);
    ex_copy(&n, num);
    ex_shift(&n, degree * X.low - low);
    n.sign *= den->sign;
    if (t.sign != n.sign) return t.sign > n.sign ? 1 : -1;
    /* t |den| sqrt(square) against n, of the same sign: their squares */
    ex_mul(&a, &t, den);
    ex_mul(&b, &a, &a);
    ex_mul(&a, &b, square);
    ex_mul(&b, &n, &n);
    o = ex_cmp(&a, &b);
    return t.sign * o;
}

/* The largest error of a class as a part of its bound. */
static double worst;

/* Whether |x - num / (den |square|^(1/2))| <= dx: by long double where that
 * can tell, else exactly. */
static int within(double x, double dx, const ex_num *num, const ex_num *den,
                  const ex_num *square, int degree)
{
    long double q = quotient(num, den, square, degree);
    long double error = (long double)x - q, size = q;

    if (error < 0.0L) error = -error;
    if (size < 0.0L) size = -size;
    if (error > worst * (long double)dx) worst = (double)(error / dx);
    if (error + 64.0L * LDBL_EPSILON * size <= (long double)dx) return 1;
    return beyond(x, 1, dx, num, den, square, degree) >= 0 &&
           beyond(x, -1, dx, num, den, square, degree) <= 0;
}

enum {
    FACET_RANDOM, NEEDLE, OBTUSE, SHORT, FACET_LATTICE, FACET_OFFSET,
    FACET_SCALED, FACET_MIXED, FACETS
};
static const char *const facet_names[FACETS] = {
    "random", "needles (p2 near p1)", "nearly collinear", "p3 near p2",
    "lattice", "offset up to 1e8", "scaled by up to 2^-400", "mixed exponents"
};

enum {
    POINT_RANDOM, NEAR_PLANE, FAR, NEAR_P1, NEAR_P2, NEAR_BALL, ON_LATTICE,
    POINTS
};

static double tenth(int k)
{
    double x = 1.0;

    for (; k > 0; k--) x *= 0.1;
    return x;
}

/* P[0..2]: a facet of the class; its length scale is returned. */
static double make_facet(int group, double p[5][3])
{
    double d, t, unit = 1.0;
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) p[i][k] = sym();
    d = tenth(1 + rnd_below(15));
    switch (group) {
    case NEEDLE:
        for (k = 0; k < 3; k++) p[1][k] = p[0][k] + d * sym();
        break;
    case OBTUSE:
        t = 3.0 * sym();
        for (k = 0; k < 3; k++)
            p[2][k] = p[0][k] + t * (p[1][k] - p[0][k]) + d * sym();
        break;
    case SHORT:
        for (k = 0; k < 3; k++) p[2][k] = p[1][k] + d * sym();
        break;
    case FACET_LATTICE:
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_below(4) - 1.5;
        break;
    case FACET_OFFSET:
        t = 1.0 / tenth(rnd_below(9));
        for (k = 0; k < 3; k++)
            if (rnd_below(3))
                for (i = 0; i < 3; i++) p[i][k] += t;
        break;
    case FACET_SCALED:
        unit = ldexp(1.0, -rnd_below(SCALE(401)));
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) p[i][k] *= unit;
        break;
    case FACET_MIXED:
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) p[i][k] = mixed(SCALE(60));
        break;
    default:
        break;
    }
    return unit;
}

/* A point for the facet p[0..2]; p[4] is the point made before. */
static void make_point(int group, double unit, double p[5][3])
{
    double s, t, d, f[HH_FACET_LEN], l, x[3], w[3];
    int k;

    s = 1.5 * rnd_unit();
    t = 1.5 * rnd_unit();
    d = tenth(rnd_below(17));
    for (k = 0; k < 3; k++) p[3][k] = p[0][k] + unit * sym();
    switch (group) {
    case NEAR_PLANE:
        for (k = 0; k < 3; k++)
            p[3][k] = p[0][k] + s * (p[1][k] - p[0][k]) +
                      t * (p[2][k] - p[0][k]) + unit * d * sym();
        break;
    case FAR:
        for (k = 0; k < 3; k++) p[3][k] = p[0][k] + unit * sym() / d;
        break;
    case NEAR_P1:
        for (k = 0; k < 3; k++) p[3][k] = p[0][k] + unit * d * sym();
        break;
    case NEAR_P2:
        for (k = 0; k < 3; k++) p[3][k] = p[1][k] + unit * d * sym();
        break;
    case NEAR_BALL:
        /* on the ball of the facet and the last point, or nearly: the second
         * meeting of the ball with a line through p1 */
        hh_setup(p[0], p[1], p[2], f);
        l = 0.0;
        if (hh_limits(f, p[4], &s, &t) == 1) l = 0.5 * s + 0.5 * t;
        for (k = 0; k < 3; k++) {
            x[k] = f[3 + k] + l * f[k];
            w[k] = sym();
        }
        t = 2.0 * (x[0] * w[0] + x[1] * w[1] + x[2] * w[2]) /
            (w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        for (k = 0; k < 3; k++) {
            p[3][k] = p[0][k] + t * w[k];
            if (rnd_below(2)) p[3][k] += unit * d * d * sym();
        }
        break;
    case ON_LATTICE:
        for (k = 0; k < 3; k++) p[3][k] = unit * (rnd_below(4) - 1.5);
        break;
    default:
        break;
    }
}

static double length(const double *a)
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* hh_facet: the code; |v| = 1 up to 56 eps (the paper's bound of the backward
 * error of Q e3); |c - p1| and each component of c - p1 right within dc; v
 * turned as promised, which the certificates of test_facets prove. */
static long facet_faults(const double *f, int code, int line)
{
    static ex_num den, one;
    double e, far, saved = worst;
    long faults = 0;
    int k;

    ex_int(&one, 1L);
    for (k = 0; k < HH_FACET_LEN; k++)
        if (!(f[k] <= DBL_MAX && f[k] >= -DBL_MAX)) faults++;
    if (code != line) {
#if HH_LIMBS < 88
        if (code == 1) faults++;
#else
        faults++;
#endif
    }
    for (k = 0; k < 3; k++) faults += f[6 + k] != P[0][k];
    /* too thin or too small for bounds: then nothing of the centre is left */
    if (f[9] == DBL_MAX)
        faults += f[3] != 0.0 || f[4] != 0.0 || f[5] != 0.0 ||
                  f[10] != DBL_MAX || f[11] != 0.0;
    if (line && code == 1) {
        for (k = 0; k < 6; k++) faults += f[k] != 0.0;
        faults += f[11] != 0.0 || f[9] != DBL_MAX || f[10] != DBL_MAX;
    }
    if (line || f[9] >= 1.0) return faults;
    e = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - 1.0;
    faults += fabs(e) > 56.0 * DBL_EPSILON;
    ex_copy(&den, &X.nn);
    ex_shift(&den, 1);
    far = 0.0;
    for (k = 0; k < 3; k++) {
        /* degree 5 over degree 4 */
        double q = (double)quotient(&X.u[k], &den, &one, 1);
        faults += !within(f[3 + k], f[10], &X.u[k], &den, &one, 1);
        far += (f[3 + k] - q) * (f[3 + k] - q);
    }
    /* the squares' roundings are far below dc, which is over 100 eps rho */
    faults += sqrt(far) > f[10] * (1.0 + 8.0 * DBL_EPSILON);
    faults += fabs(length(f + 3) - f[11]) > f[10];
    worst = saved;
    return faults;
}

/* hh_wrap's bound.  With v and g turned by at most E against the true ones
 * (the derivation in hhpred.c), numerator and denominator err by E |w|:
 * |c - C| <= E |w| (1 + |c|) / (|w.v| - E |w|) + 4 eps |c|.  No bound is
 * tested where the denominator is not certain. */
static long wrap_faults(const double *f, double size, int line)
{
    static ex_num den, num;
    double c = -1.0, c2, d, d2, side, gap, other, w[3], saved = worst;
    int code = hh_wrap(R[0], R[1], R[2], R[3], &c), code2, k;

#if HH_LIMBS < 88
    if (line && code != 1) return 0;
#endif
    if ((code == 1) != line || (code != 0 && c != 0.0)) return 1;
    if (line || f[9] >= 1.0) return 0;
    side = hh_side(f, R[3]);
    gap = fabs(side) - f[9] * size;
    if (gap <= 0.0) return 0;
    if (code != 0) return 1;
    d = f[9] * size * (1.0 + fabs(c)) / gap + 4.0 * DBL_EPSILON * fabs(c);
    ex_copy(&num, &X.wg);
    num.sign = -num.sign;
    ex_copy(&den, &X.wn);
    k = within(c, d, &num, &den, &X.aa, 0);
    worst = saved;
    if (!k) return 1;
    /* the order of two points on the positive side: the first one wrapped
     * has the other one behind it, det [a w z] > 0 */
    code2 = hh_wrap(R[0], R[1], R[2], R[4], &c2);
    other = hh_side(f, R[4]);
    for (k = 0; k < 3; k++) w[k] = P[4][k] - P[0][k];
    gap = other - f[9] * length(w);
    if (side <= 0.0 || gap <= 0.0) return 0;
    if (code2 != 0) return 1;
    d2 = f[9] * length(w) * (1.0 + fabs(c2)) / gap +
         4.0 * DBL_EPSILON * fabs(c2);
    if (c + d < c2 - d2)
        return ex_orient(P[0], P[1], P[3], P[4]) != 1;
    return 0;
}

static const char *fault;

static void require(int holds, const char *what)
{
    if (!holds) fault = what;
}

/* The public routines on the facet P[0..2] and the point P[3]. */
static void test_public(void)
{
    static ex_num den, one;
    double f[HH_FACET_LEN], w[3], e[3], size, side, gap, l, dl, r, s;
    int line, code, k, m, o = X.wn.sign;

    ex_int(&one, 1L);
    ex_copy(&den, &X.wn);
    ex_shift(&den, 1);
    line = X.nn.sign == 0;
    for (k = 0; k < HH_FACET_LEN; k++) f[k] = 7e77;
    code = hh_facet(R[0], R[1], R[2], f);
    require(facet_faults(f, code, line) == 0, "hh_facet");
    for (k = 0; k < 3; k++) w[k] = P[3][k] - P[0][k];
    size = length(w);
    /* below, the bounds are not promised */
    if (size > 0.0 && size < ldexp(1.0, -SCALE(450))) return;
    require(wrap_faults(f, size, line) == 0, "hh_wrap");
    side = hh_side(f, R[3]);
    l = hh_lcoord(f, R[3]);
    r = hh_side(f, R[4]);
    require(hh_opp(f, R[3], R[4]) ==
            ((side > 0.0 && r > 0.0) || (side < 0.0 && r < 0.0)), "hh_opp");
    if (side == 0.0) {
        r = size * size;
        s = 2.0 * (f[3] * w[0] + f[4] * w[1] + f[5] * w[2]);
        dl = 16.0 * DBL_EPSILON * (r + size * f[11]);
        require(l == DBL_MAX || l == -DBL_MAX, "hh_lcoord in the plane");
        require(!(r - s > dl) || l == DBL_MAX, "hh_lcoord outside");
        require(!(s - r > dl) || l == -DBL_MAX, "hh_lcoord inside");
    }
    if (line || f[9] >= 1.0) return;
    /* p2 and p3 lie in the plane: never certain off it */
    for (k = 1; k < 3; k++) {
        for (m = 0; m < 3; m++) e[m] = P[k][m] - P[0][m];
        require(fabs(hh_side(f, R[k])) <= f[9] * length(e),
                "hh_side of a vertex");
    }
    require(within(side, f[9] * size, &X.wn, &one, &X.nn, 1), "hh_side");
    gap = fabs(side) - f[9] * size;
    if (!(gap > 0.0)) return;
    require(o == (side > 0.0 ? 1 : -1), "sign of hh_side");
    dl = size * (DBL_EPSILON * (3.0 * size + 5.0 * f[11]) + f[10] +
                 fabs(l) * f[9]) / gap + 4.0 * DBL_EPSILON * fabs(l);
    require(within(l, dl, &X.power, &den, &X.nn, 1), "hh_lcoord");
}

/* What test_facets counts. */
static long sides, decided, pairs, ordered, limited, thin;

/* hh_setup, or with limbs hh_thin, and hh_limits, as tess uses them, on the facet
 * P[0..2] and the point P[3]: the side, the limits of the L-coordinate, and its
 * order against that of P[4], when *last says that lo[1], hi[1] limit it; what is
 * known of P[3] takes its place. */
static void test_limits(double *lo, double *hi, int *last, int limbs)
{
    static ex_num den;
    static tess_int order[3] = { 0, 1, 2 };
    double h[HH_FACET_LEN], x[9], longest = 0.0, edge, e[3];
    int side, base = 0, i, k;
    hh_set set;

    if (limbs) {
        /* the base opposite to the longest edge */
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 3; k++) {
                e[k] = P[(i + 1) % 3][k] - P[(i + 2) % 3][k];
                x[3 * i + k] = P[i][k];
            }
            edge = length(e);
            if (edge > longest) base = i;
            if (edge > longest) longest = edge;
        }
        set.x = x;
        set.p = R[0];
        set.order = order;
        set.exact3 = set.exact5 = -1.0;
        set.exponent = 0;
        hh_setup(P[base], P[(base + 1) % 3], P[(base + 2) % 3], h);
        if (X.nn.sign != 0) hh_thin(&set, order, base, h);
        thin += h[9] < 1e-10;
    } else
        hh_setup(P[0], P[1], P[2], h);
    side = hh_limits(h, P[3], lo, hi);
    if (X.wn.sign > 0) {
        ex_copy(&den, &X.wn);
        ex_shift(&den, 1);
        if (lo[0] > -DBL_MAX)
            require(beyond(lo[0], 1, 0.0, &X.power, &den, &X.nn, 1) <= 0,
                    "lower limit of L");
        if (hi[0] < DBL_MAX)
            require(beyond(hi[0], 1, 0.0, &X.power, &den, &X.nn, 1) >= 0,
                    "upper limit of L");
        limited += side == 0 && (lo[0] > -DBL_MAX || hi[0] < DBL_MAX);
    }
    sides++;
    decided += side != 0;
    require(side == 0 || side == X.wn.sign, "side by hh_limits");
    if (side == 1) {
        require(within(0.5 * lo[0] + 0.5 * hi[0], 0.5 * hi[0] - 0.5 * lo[0],
                       &X.power, &den, &X.nn, 1), "L by hh_limits");
        if (*last) {
            pairs++;
            if (hi[0] < lo[1]) {
                ordered++;
                require(ex_insphere(P[0], P[1], P[2], P[3], P[4]) == -1,
                        "order of L");
            }
            if (hi[1] < lo[0]) {
                ordered++;
                require(ex_insphere(P[0], P[1], P[2], P[4], P[3]) == -1,
                        "order of L");
            }
        }
        lo[1] = lo[0];
        hi[1] = hi[0];
    }
    *last = side == 1;
}

/* All that hhpred.h and hhpred.c promise of facets of a class. */
static void test_facets(int group, int limbs, long n)
{
    long faults = 0, i;
    double p[5][3], lo[2], hi[2], unit;
    int j, k, kind, last;
    char name[80];

    worst = 0.0;
    sides = decided = pairs = ordered = limited = thin = 0;
    for (i = 0; i < n; i++) {
        unit = make_facet(group, p);
        for (k = 0; k < 3; k++) p[4][k] = p[0][k] + unit * sym();
        last = 0;
        for (j = 0; j < 6; j++) {
            kind = group == FACET_RANDOM ? POINT_RANDOM : rnd_below(POINTS);
            make_point(kind, unit, p);
            settle(p);
            exact_facet(low_of(5));
            exact_point(P[3]);
            fault = NULL;
            if (!limbs) test_public();
            test_limits(lo, hi, &last, limbs);
            if (fault != NULL && faults++ < 3) {
                printf("# %s:\n", fault);
                show(5);
            }
            for (k = 0; k < 3; k++) p[4][k] = p[3][k];
        }
    }
    printf("# sides decided %ld of %ld, orders %ld of %ld, else limits "
           "%ld, worst error %.3g of its bound\n", decided, sides, ordered,
           pairs, limited, worst);
    if (group == FACET_RANDOM)
        faults += decided < sides - sides / 1000 ||
                  ordered < pairs - pairs / 1000;
    /* where nothing is decided, nothing is tested */
    faults += decided < sides / 10 || ordered < pairs / 10 || pairs == 0;
    /* an error bound that no case comes near to would be idle */
    faults += worst < 1e-4;
    if (limbs) faults += thin < sides / 4;
    sprintf(name, "facets%s: %s", limbs ? " by limbs" : "",
            facet_names[group]);
    test_result(name, faults);
}

/* hh_facet and hh_wrap over the whole range of double: codes, and no NaN in
 * f; and on exactly collinear points, moved by a last place. */
static void test_codes(long n)
{
    long faults = 0, lines = 0, i;
    double p[5][3], f[HH_FACET_LEN], c, t;
    int group, code, line, k, bad;

    for (i = 0; i < n; i++) {
        do group = rnd_below(CLASSES);
        while (group == SUBNORMAL && test_flushes());
        make(group, p);
        if (rnd_below(2)) {
            for (k = 0; k < 3; k++) {
                p[0][k] = dyadic(10);
                p[1][k] = dyadic(10);
            }
            t = 3.0 * dyadic(5);
            for (k = 0; k < 3; k++)
                p[2][k] = p[0][k] + t * (p[1][k] - p[0][k]);
            k = rnd_below(3);
            p[2][k] = nudge(p[2][k], rnd_below(3) - 1);
        }
        settle(p);
        line = ex_collinear(P[0], P[1], P[2]);
        lines += line;
        bad = 0;
        code = hh_facet(R[0], R[1], R[2], f);
        bad |= HH_LIMBS < 88 ? code == 1 && !line : code != line;
        code = hh_wrap(R[0], R[1], R[2], R[3], &c);
        bad |= HH_LIMBS < 88 ? code == 1 && !line : (code == 1) != line;
        bad |= code != 0 && c != 0.0;
        /* the circumcentre may be out of the range of double, no NaN */
        for (k = 0; k < HH_FACET_LEN; k++)
            if (!(f[k] <= 0.0 || f[k] >= 0.0)) bad = 1;
        for (k = 0; k < 3; k++) bad |= fabs(f[k]) > 2.0;
        if (bad && faults++ < 3) {
            printf("# %s: code %d, collinear %d:\n", names[group], code, line);
            printf("#");
            for (k = 0; k < HH_FACET_LEN; k++) printf(" %g", f[k]);
            printf("\n");
            show(4);
        }
    }
    faults += lines < n / 10;
    test_result("codes of hh_facet, hh_wrap", faults);
}

/* Values known by hand: the unit right-angled facet in the plane z = 0. */
static void test_known(void)
{
    static const tess_real o[3] = { 0, 0, 0 }, x[3] = { 1, 0, 0 };
    static const tess_real y[3] = { 0, 1, 0 }, z[3] = { 0, 0, 1 };
    static const tess_real q[3] = { 1, 1, 0 }, in[3] = { 0.5, 0.5, 0 };
    static const tess_real out[3] = { 2, 2, 0 }, low[3] = { 0, 0, -1 };
    static const tess_real two[3] = { 2, 0, 0 }, up[3] = { 0.5, 0.5, 1.5 };
    double f[HH_FACET_LEN], c = 7.0, tiny = 8.0 * DBL_EPSILON;
    tess_real flat[3] = { 0.5, 0, 0 }, near[3] = { 0.25, 0.25, 0 };
    double w[3];
    long faults = 0;

    faults += hh_facet(o, x, y, f) != 0;
    faults += fabs(f[0]) > tiny || fabs(f[1]) > tiny ||
              fabs(f[2] - 1.0) > tiny;
    faults += fabs(f[3] - 0.5) > tiny || fabs(f[4] - 0.5) > tiny ||
              fabs(f[5]) > tiny || fabs(f[11] - sqrt(0.5)) > tiny;
    faults += fabs(hh_side(f, z) - 1.0) > tiny;
    faults += fabs(hh_side(f, low) + 1.0) > tiny;
    faults += hh_opp(f, z, up) != 1 || hh_opp(f, z, low) != 0 ||
              hh_opp(f, low, low) != 1;
    /* the ball of o, x, y, z has its centre at 1/2, 1/2, 1/2; that of up, at
     * height l with 1/2 + l^2 = (3/2 - l)^2 */
    faults += fabs(hh_lcoord(f, z) - 0.5) > tiny;
    faults += fabs(hh_lcoord(f, up) - 1.75 / 3.0) > tiny;
    if (hh_side(f, in) == 0.0) faults += hh_lcoord(f, in) != -DBL_MAX;
    if (hh_side(f, out) == 0.0) faults += hh_lcoord(f, out) != DBL_MAX;
    /* about the edge o x from the facet's plane: y + z halfway round, z a
     * quarter: c is -cot of the angle */
    faults += hh_wrap(o, x, y, z, &c) != 0 || fabs(c) > tiny;
    faults += hh_wrap(o, x, y, up, &c) != 0 || fabs(c + 1.0 / 3.0) > tiny;
    c = 7.0;
    faults += hh_wrap(o, x, two, z, &c) != 1 || c != 0.0;
    c = 7.0;
    faults += hh_wrap(o, x, x, z, &c) != 1 || c != 0.0;
    c = 7.0;
    if (hh_side(f, q) == 0.0)
        faults += hh_wrap(o, x, y, q, &c) != 2 || c != 0.0;
    faults += hh_facet(o, x, two, f) != 1 || hh_facet(o, o, two, f) != 1 ||
              hh_facet(o, o, o, f) != 1;
    /* too thin for bounds, or a line where that is 0 */
    flat[1] = (tess_real)(0.25 * HH_LENGTH_MIN);
    f[10] = 0.0;
    faults += hh_facet(o, x, flat, f) != (flat[1] == 0);
    faults += f[9] != DBL_MAX || f[10] != DBL_MAX || f[3] != 0.0 ||
              f[4] != 0.0 || f[5] != 0.0 || f[11] != 0.0;
    faults += hh_orient(o, x, y, z) != 1 || hh_orient(o, y, x, z) != -1 ||
              hh_orient(o, x, y, q) != 0;
    faults += hh_insphere(o, x, y, z, in) != 1 ||
              hh_insphere(o, y, x, z, in) != 1 ||
              hh_insphere(o, x, y, z, q) != 0 ||
              hh_insphere(o, x, y, z, out) != -1 ||
              hh_insphere(o, x, y, q, z) != 0;
    /* doubles tell which vertices carry the foot, where there are no limbs for
     * near's last coordinate; its weights take these */
    near[2] = (tess_real)ldexp(1.0, -90);
    c = (double)near[2];
    faults += hh_foot(o, x, y, near, NULL) != 7;
    faults += hh_foot(o, x, y, near, w) != (hh_fits(c, 1.0) ? 7 : 0);
    test_result("values known by hand", faults);
}
static void all(void)
{
    int group;

    test_known();
    test_codes(20000 * percent / 100);
    for (group = 0; group < FACETS; group++)
        test_facets(group, 0, 5000 * percent / 100);
    for (group = 0; group < FACETS; group++)
        test_facets(group, 1, 2000 * percent / 100);
}

int main(int argc, char **argv)
{
    return five_main(argc, argv, all, &percent);
}
