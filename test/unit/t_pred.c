/* t_pred.c - tests of hhpred.c: every routine of hhpred.h against exact
 * integer arithmetic (exact.c), on points made to be hard.
 *
 *     t_pred [percent [seed]]   percent of the usual number of cases
 *
 * Covered: the signs of hh_orient, hh_insphere, hh_flat, hh_wider, hh_pside
 * and hh_pball; hh_foot's face and weights, and hh_weigh's; the heights of
 * hh_height; hh_facet's codes, normal and centre; the bounds that hhpred.h
 * promises for hh_side, hh_lcoord and hh_limits, and the ones derived below
 * for hh_wrap; the certificates made of these bounds (a side, an order of two
 * L-coordinates) must never be wrong, and must decide nearly all random
 * points.  A failure prints the points in full.
 *
 * Compiled with few limbs (-DHH_LIMBS=3, hhpred.c likewise), the signs may be
 * 2 where the limbs do not suffice, and must be where they cannot.
 * With -DTEST_ROUNDING (C99's fenv.h) all is done in four rounding modes.
 */
#include "../../hhpred.h"
#include "../proof/exact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Where gcc computes by an x87 unit, it says 2. */
#ifdef __FLT_EVAL_METHOD__
#define BY_X87 (__FLT_EVAL_METHOD__ == 2)
#else
#define BY_X87 0
#endif

#ifdef TESS_FLOAT
#define REAL_EPS FLT_EPSILON
#define REAL_MAX FLT_MAX
#define MANT_DIG FLT_MANT_DIG
#define MAX_EXP FLT_MAX_EXP
#else
#define REAL_EPS DBL_EPSILON
#define REAL_MAX DBL_MAX
#define MANT_DIG DBL_MANT_DIG
#define MAX_EXP DBL_MAX_EXP
#endif
/* the exponents of the scales of about 1e60, 1e150, 1e300 in double */
#define SCALE(i) (MAX_EXP * (i) / 1024)

static long percent = 100;

/* ---- points ---- */

/* The five points of a case, as hhpred.c sees them and, the same values, as
 * exact.c does. */
static tess_real R[5][3];
static double P[5][3];

/* Whether subnormal numbers are flushed to zero (as -Ofast does). */
static int flushes(void)
{
    volatile double x = DBL_MIN;

    x *= 0.5;
    return x == 0.0;
}

static void incident_tet(double p[5][3])
{
    /* volatile: a compiler was seen to optimize the rounding away */
    volatile tess_real rounded;
    int i, k;

    for (i = 0; i < 5; i++)
        for (k = 0; k < 3; k++) {
            double x = p[i][k];

            if (x > REAL_MAX) x = REAL_MAX;
            if (x < -REAL_MAX) x = -REAL_MAX;
            rounded = (tess_real)x;
            R[i][k] = rounded;
            P[i][k] = (double)rounded;
        }
}

static void show(int n)
{
    int i;

    for (i = 0; i < n; i++)
        printf("    %.17g %.17g %.17g\n", P[i][0], P[i][1], P[i][2]);
}

/* x moved by k units in its last place (not across a power of two) */
static double nudge(double x, int k)
{
    int e;

    if (x == 0.0) return (tess_real)k * REAL_EPS;
    frexp(x, &e);
    return x + k * ldexp(REAL_EPS, e - 1);
}

static double sym(void) { return 2.0 * rnd_unit() - 1.0; }

/* a dyadic number in (-1, 1) with that many bits */
static double dyadic(int bits)
{
    return ldexp(floor(ldexp(sym(), bits)), -bits);
}

static double mixed(int span)
{
    return ldexp(sym(), rnd_below(2 * span + 1) - span);
}

/* the integer points of x^2 + y^2 + z^2 = 1025, at most 33 each */
static int sphere[2000][3], spheres;

static void find_sphere(void)
{
    int x, y, z;

    for (x = -33; x < 34; x++)
        for (y = -33; y < 34; y++)
            for (z = -33; z < 34; z++)
                if (x * x + y * y + z * z == 1025) {
                    sphere[spheres][0] = x;
                    sphere[spheres][1] = y;
                    sphere[spheres++][2] = z;
                }
}

enum {
    RANDOM, LATTICE, INTEGERS, TENTHS, PLANE, SPHERE, NORMED, PAIRS, OFFSET,
    SCALED, MIXED, SUBNORMAL, EXTREME, FARAPART, INTEGER_PLANE,
    INTEGER_SPHERE, LIMBS, BOXES, CLASSES
};
static const char *const names[CLASSES] = {
    "random", "lattice {0..3}", "integers below 2^20", "tenths",
    "coplanar but for a last place", "cospherical but for a last place",
    "normalized onto a sphere", "pairs 1e-13 apart", "offset 1e8",
    "scales 1e+-60 1e+-150 1e+-300", "mixed exponents, all the range",
    "subnormal", "extreme values", "a tiny cluster and a far point",
    "integers, coplanar but for 1", "integers, cospherical but for 1",
    "cospherical but for any bit", "corners of wide boxes but for a last place"
};

/* the points of a class, before duplicates */
static void make(int group, double p[5][3])
{
    static const int power[6] = { 200, -200, 500, -500, 1000, -1000 };
    static const double extreme[7] = { 0.0, 1.0, -1.0, 0.5, -0.5, 0.0, 0.0 };
    double v[3], t, s;
    int i, j, k, e;

    for (i = 0; i < 5; i++)
        for (k = 0; k < 3; k++) p[i][k] = rnd_unit();
    switch (group) {
    case LATTICE:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_below(4);
        break;
    case INTEGERS:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_below(1 << 20);
        break;
    case TENTHS:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] = 0.1 * rnd_below(12);
        break;
    case PLANE:
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) p[i][k] = dyadic(12);
        for (i = 3; i < 5; i++) {
            s = dyadic(5);
            t = dyadic(5);
            for (k = 0; k < 3; k++)
                p[i][k] = p[0][k] + s * (p[1][k] - p[0][k]) +
                          t * (p[2][k] - p[0][k]);
        }
        i = rnd_below(5);
        k = rnd_below(3);
        p[i][k] = nudge(p[i][k], rnd_below(3) - 1);
        break;
    case INTEGER_PLANE:
        e = 1 << (10 + rnd_below(9));
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_below(e);
        for (i = 3; i < 5; i++) {
            s = rnd_below(5) - 2;
            t = rnd_below(5) - 2;
            for (k = 0; k < 3; k++)
                p[i][k] = p[0][k] + s * (p[1][k] - p[0][k]) +
                          t * (p[2][k] - p[0][k]);
        }
        p[rnd_below(5)][rnd_below(3)] += rnd_below(3) - 1;
        break;
    case INTEGER_SPHERE:
        s = rnd_below(400) + 1;
        for (i = 0; i < 5; i++) {
            j = rnd_below(spheres);
            for (k = 0; k < 3; k++) p[i][k] = s * sphere[j][k];
        }
        p[rnd_below(5)][rnd_below(3)] += rnd_below(3) - 1;
        break;
    case LIMBS:
        /* full mantissas; the determinant may end in any row, or be 0 */
        s = floor(ldexp(1.0 + rnd_unit(), MANT_DIG - 8));
        for (i = 0; i < 5; i++) {
            j = rnd_below(spheres);
            for (k = 0; k < 3; k++) p[i][k] = s * sphere[j][k];
        }
        p[rnd_below(5)][rnd_below(3)] +=
            ldexp(rnd_below(3) - 1, rnd_below(MANT_DIG - 2));
        break;
    case BOXES:
        for (k = 0; k < 3; k++)
            v[k] = ldexp(1.0 + rnd_unit(), rnd_below(MAX_EXP) - MAX_EXP / 2);
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_below(2) ? v[k] : -v[k];
        i = rnd_below(5);
        k = rnd_below(3);
        p[i][k] = nudge(p[i][k], rnd_below(3) - 1);
        break;
    case SPHERE:
        for (k = 0; k < 3; k++) v[k] = rnd_below(2) ? 0.0 : rnd_below(1000);
        for (i = 0; i < 5; i++) {
            j = rnd_below(spheres);
            for (k = 0; k < 3; k++) p[i][k] = v[k] + sphere[j][k];
        }
        i = rnd_below(5);
        k = rnd_below(3);
        p[i][k] = nudge(p[i][k], rnd_below(3) - 1);
        break;
    case NORMED:
        for (i = 0; i < 5; i++) {
            for (k = 0; k < 3; k++) p[i][k] = sym();
            t = sqrt(p[i][0] * p[i][0] + p[i][1] * p[i][1] +
                     p[i][2] * p[i][2]);
            for (k = 0; k < 3; k++) p[i][k] /= t;
        }
        break;
    case PAIRS:
        for (i = 1; i < 5; i++)
            if (i == 1 || rnd_below(2)) {
                j = rnd_below(i);
                for (k = 0; k < 3; k++) p[i][k] = p[j][k] + 1e-13 * sym();
            }
        break;
    case OFFSET:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] += 1e8;
        break;
    case SCALED:
        make(rnd_below(OFFSET), p);
        e = SCALE(power[rnd_below(6)]);
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) p[i][k] = ldexp(p[i][k], e);
        break;
    case MIXED:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = rnd_below(8) ? mixed(MAX_EXP - 2) : 0.0;
        break;
    case SUBNORMAL:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = (rnd_below(5) - 2) * DBL_MIN * DBL_EPSILON;
        break;
    case EXTREME:
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) {
                j = rnd_below(7);
                p[i][k] = extreme[j] * REAL_MAX;
                if (j == 5) p[i][k] = REAL_EPS;
                if (j == 6 && !flushes())
                    p[i][k] = -DBL_MIN * DBL_EPSILON;
            }
        break;
    case FARAPART:
        e = SCALE(power[rnd_below(6)]);
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++)
                if (i != 2) p[i][k] = ldexp(p[i][k], e);
        break;
    default:
        break;
    }
}

/* ---- exact signs ---- */

/* exact.c itself: sums, products and shifts on numbers known otherwise, its
 * determinants against machine integers, its tie rule against itself. */
static void test_exact(void)
{
    static ex_num a, b, s, d, l, r, t;
    long faults = 0, x[5][4], det, u;
    double p[5][3];
    const double *q[5];
    int index[5], i, j, k, m, turn, e;

    for (turn = 0; turn < 20000; turn++) {
        /* (a + b) (a - b) = a a - b b, of random lengths and signs */
        ex_int(&a, (long)rnd_bits() % 100000L - 50000L);
        ex_int(&b, (long)rnd_bits() % 100000L - 50000L);
        for (i = rnd_below(8); i > 0; i--) {
            ex_int(&t, (long)(rnd_bits() >> 2));
            ex_mul(&r, &a, &t);
            ex_add(&a, &r, &t);
        }
        ex_shift(&b, rnd_below(100));
        ex_add(&s, &a, &b);
        ex_sub(&d, &a, &b);
        ex_mul(&l, &s, &d);
        ex_mul(&r, &a, &a);
        ex_mul(&t, &b, &b);
        ex_sub(&r, &r, &t);
        faults += ex_cmp(&l, &r) != 0;
        /* a number in doubles: x 2^e and y 2^-e, sum in units of y */
        u = (long)(rnd_bits() >> 2);
        e = rnd_below(200);
        ex_real(&a, ldexp((double)u, e), -e);
        ex_real(&b, ldexp(-3.0, -e), -e);
        ex_add(&s, &a, &b);
        ex_int(&r, u);
        ex_shift(&r, 2 * e);
        ex_int(&t, 3L);
        ex_sub(&r, &r, &t);
        faults += ex_cmp(&s, &r) != 0;
        if (u) faults += ex_low((double)(2 * u + 1) / 1024.0, 0) != -10;
        /* determinants of small integers, products below 2^31; the rows
         * relative to the last point */
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) {
                x[i][k] = rnd_below(9);
                p[i][k] = (double)x[i][k];
            }
        for (i = 0; i < 4; i++)
            for (x[i][3] = k = 0; k < 3; k++) {
                x[i][k] -= x[4][k];
                x[i][3] += x[i][k] * x[i][k];
            }
        det = 0;
        for (i = 0; i < 4; i++)
            for (j = 0; j < 4; j++)
                for (k = 0; k < 4; k++)
                    for (m = 0; m < 4; m++) {
                        if (i == j || i == k || i == m || j == k || j == m ||
                            k == m)
                            continue;
                        e = (i > j) + (i > k) + (i > m) + (j > k) + (j > m) +
                            (k > m);
                        u = x[0][i] * x[1][j] * x[2][k] * x[3][m];
                        det += e % 2 ? -u : u;
                    }
        for (i = 0; i < 5; i++) {
            q[i] = p[i];
            index[i] = i;
        }
        u = (long)((p[1][0] - p[0][0]) *
                       ((p[2][1] - p[0][1]) * (p[3][2] - p[0][2]) -
                        (p[2][2] - p[0][2]) * (p[3][1] - p[0][1])) -
                   (p[1][1] - p[0][1]) *
                       ((p[2][0] - p[0][0]) * (p[3][2] - p[0][2]) -
                        (p[2][2] - p[0][2]) * (p[3][0] - p[0][0])) +
                   (p[1][2] - p[0][2]) *
                       ((p[2][0] - p[0][0]) * (p[3][1] - p[0][1]) -
                        (p[2][1] - p[0][1]) * (p[3][0] - p[0][0])));
        i = u > 0 ? 1 : -(u < 0);
        j = det > 0 ? 1 : -(det < 0);
        faults += ex_orient(p[0], p[1], p[2], p[3]) != i;
        faults += ex_insphere(p[0], p[1], p[2], p[3], p[4]) != -i * j;
        /* no tie: the perturbation changes nothing; and exchanging two
         * points changes the sign */
        k = ex_perturbed(q, index);
        if (det != 0) faults += k != j;
        q[1] = p[3];
        q[3] = p[1];
        index[1] = 3;
        index[3] = 1;
        faults += ex_perturbed(q, index) != -k;
    }
    test_result("exact.c against identities and machine integers", faults);
}

/* hh_orient and hh_insphere on a class: the exact sign, or 2 where limbs are
 * few; even permutations keep an orientation and odd ones turn it; the ball
 * does not depend on the order of its points; d and e exchanged. */
static void test_signs(int group, long n)
{
    long faults = 0, count[4] = { 0, 0, 0, 0 }, ball[4] = { 0, 0, 0, 0 };
    long i;
    double p[5][3];
    int o, s, h, v, v2, a[4], k, m, t, parity, want, flat;

    for (i = 0; i < n; i++) {
        make(group, p);
        if (rnd_below(16) == 0) {
            /* duplicates among the five */
            a[0] = rnd_below(5);
            a[1] = rnd_below(5);
            for (k = 0; k < 3; k++) p[a[0]][k] = p[a[1]][k];
        }
        incident_tet(p);
        h = ex_orient(P[0], P[1], P[2], P[3]);
        s = ex_insphere(P[0], P[1], P[2], P[3], P[4]);
        o = hh_orient(R[0], R[1], R[2], R[3]);
        v = hh_insphere(R[0], R[1], R[2], R[3], R[4]);
        for (k = 0; k < 4; k++) a[k] = k;
        parity = 1;
        for (k = 3; k > 0; k--) {
            m = rnd_below(k + 1);
            if (m != k) parity = -parity;
            t = a[k];
            a[k] = a[m];
            a[m] = t;
        }
        t = hh_orient(R[a[0]], R[a[1]], R[a[2]], R[a[3]]);
        m = hh_insphere(R[a[0]], R[a[1]], R[a[2]], R[a[3]], R[4]);
        v2 = hh_insphere(R[0], R[1], R[2], R[4], R[3]);
        /* I, the determinant of the five points, changes sign when two are
         * exchanged, and in = -I orient */
        want = -s * h * ex_orient(P[0], P[1], P[2], P[4]);
        flat = h == 0;
        count[o == 2 ? 3 : o + 1]++;
        ball[v == 2 ? 3 : v + 1]++;
        k = 0;
#if HH_LIMBS < 88
        if (o == 2) { h = o; k |= 1; }
        if (t == 2) t = parity * h;
        if (v == 2) s = v;
        if (m == 2) m = s;
        if (s == 2 && m != 2) m = s;
        if (v2 == 2) v2 = want;
        if (k) t = parity * h;
#endif
        if (o != h || t != parity * h || v != s || m != s ||
            (!flat && v2 != want)) {
            if (faults++ < 3) {
                printf("hh_orient %d, permuted %d, exact %d; hh_insphere %d, "
                       "permuted %d, exact %d, exchanged %d, exact %d:\n",
                       o, t, h, v, m, s, v2, want);
                show(5);
            }
        }
    }
    printf("        orient -/0/+/2 %ld %ld %ld %ld, insphere %ld %ld %ld "
           "%ld\n", count[0], count[1], count[2], count[3], ball[0], ball[1],
           ball[2], ball[3]);
    /* the class must bring forth the signs that it is made for */
    if (group == LATTICE || group == PLANE || group == INTEGER_PLANE)
        faults += count[0] < n / 20 || count[1] < n / 20 || count[2] < n / 20;
    if (group == LATTICE || group == SPHERE || group == INTEGER_SPHERE ||
        group == LIMBS)
        faults += ball[0] < n / 20 || ball[1] < n / 20 || ball[2] < n / 20;
    /* integers of at most 20 bits and points of one scale suit 3 limbs */
    if (group == LATTICE || group == INTEGERS || group == TENTHS)
        faults += count[3] + ball[3] > 0;
#if HH_LIMBS >= 88
    faults += count[3] + ball[3] > 0;
#elif !defined(TESS_FLOAT)
    if (group == FARAPART || group == MIXED) faults += count[3] == 0;
#endif
    test_result(names[group], faults);
}

/* The indexed predicates as tess calls them: scaled coordinates x, a random
 * order of the points; the tie rule against actual perturbations; integer
 * mode, t3 and t5 set to what the unit of the coordinates allows; and x too
 * small to tell anything. */
static void test_indexed(int group, long n)
{
    static tess_real caller[15];
    long faults = 0, ties = 0, i;
    double p[5][3], x[15], most;
    const double *q[5];
    tess_int order[5];
    static const tess_int facet[3] = { 0, 1, 2 };
    int index[5], e, j, k, o, s, r, b;
    char name[80];
    hh_set set;

    for (i = 0; i < n; i++) {
        make(group, p);
        incident_tet(p);
        for (j = 0; j < 5; j++) order[j] = (tess_int)j;
        for (j = 4; j > 0; j--) {
            tess_int t = order[j];
            k = rnd_below(j + 1);
            order[j] = order[k];
            order[k] = t;
        }
        most = 0.0;
        for (j = 0; j < 15; j++) {
            caller[j] = R[j / 3][j % 3];
            if (fabs(P[j / 3][j % 3]) > most) most = fabs(P[j / 3][j % 3]);
        }
        if (most == 0.0) continue;
        frexp(most, &e);
        set.exact3 = set.exact5 = -1.0;
        if (i % 4 == 2) { /* as beside a point far away */
            e += 97 + rnd_below(900);
            set.exact3 = -2.0;
        }
        for (j = 0; j < 15; j++)
            x[j] = ldexp((double)caller[3 * order[j / 3] + j % 3], -e);
        for (j = 0; j < 5; j++) {
            q[j] = P[order[j]];
            index[j] = (int)order[j];
        }
        set.x = x;
        set.p = caller;
        set.order = order;
        if ((group == LATTICE || group == INTEGERS ||
             group == INTEGER_PLANE || group == INTEGER_SPHERE) && i % 2) {
            /* the unit of the coordinates is 1, that of x is 2^-e */
            set.exact3 = ldexp(1.0, DBL_MANT_DIG - 1 - 3 * e);
            set.exact5 = ldexp(1.0, DBL_MANT_DIG - 1 - 5 * e);
        }
        o = ex_orient(q[0], q[1], q[2], q[3]);
        s = ex_perturbed(q, index);
        ties += o != 0 && ex_insphere(q[0], q[1], q[2], q[3], q[4]) == 0;
        j = hh_porient(&set, 0, 1, 2, 3);
        k = hh_pinsphere(&set, facet, 3, 4, 1);
#if HH_LIMBS < 88
        if (j == 2) j = o;
        if (k == 2) k = s;
#endif
        r = hh_pinsphere(&set, facet, 3, 4, 0);
        b = s;
        if (o > 0 && hh_porient(&set, 0, 1, 2, 4) > 0)
            b = hh_pinsphere(&set, facet, 3, 4, 2);
#if HH_LIMBS < 88
        if (r == 2) r = s;
        if (b == 2) b = s;
#else
        if (b != s && (b != HH_TIE * s || r != 0)) faults++;
        if (s != 0 && b == HH_TIE * s &&
            hh_pinsphere(&set, facet, 3, 4, 3) != b)
            faults++;
#endif
        if (r != 0 ? r != s : o != 0 && ex_insphere(q[0], q[1], q[2], q[3],
                                                    q[4]) != 0)
            faults++;
        if (o != j || s != k) {
            if (faults++ < 3) {
                printf("hh_pside %d, exact %d; hh_pball %d, exact %d; "
                       "order %d %d %d %d %d, t5 %g:\n", j, o, k, s, index[0],
                       index[1], index[2], index[3], index[4], set.exact5);
                show(5);
            }
        }
    }
    printf("        ties %ld of %ld\n", ties, n);
    if (group == LATTICE || group == SPHERE) faults += ties < n / 20;
    sprintf(name, "hh_pside, hh_pball: %s", names[group]);
    test_result(name, faults);
}

/* 1 if h is within err of the height of point z: over the plane across c through
 * point b, or its power in the sphere about c, seen from point a, through b. */
static int height_right(const double *x, int b, int a, int z, int plane,
                        const double *c, double h, double err)
{
    static ex_num p[3], q[3], t, r, s;
    int low = EX_NO_LOW, k, units;

    for (k = 0; k < 15; k++) low = ex_low(x[k], low);
    for (k = 0; k < 3; k++) low = ex_low(c[k], low);
    for (k = 0; k < 3; k++) {
        ex_real(p + k, x[3 * z + k], low);
        ex_real(&t, x[3 * b + k], low);
        ex_sub(p + k, p + k, &t);
        ex_real(q + k, c[k], low);
        if (plane) continue;
        ex_real(&r, x[3 * a + k], low);
        ex_sub(&r, &t, &r);
        ex_sub(&r, &r, q + k);
        ex_add(&r, &r, &r);
        ex_add(q + k, p + k, &r);
    }
    ex_dot(&r, p, q);
    units = ex_low(h, ex_low(err, 2 * low));
    ex_shift(&r, 2 * low - units);
    ex_real(&s, h, units);
    ex_sub(&r, &r, &s);
    r.sign = r.sign < 0 ? 1 : r.sign;
    ex_real(&t, err, units);
    return ex_cmp(&r, &t) <= 0;
}

/* hh_centre, hh_trial and hh_lifts as tess calls them, on the ball of the first
 * four points and the last one: the trial's signs are the exact ones, or UNSURE,
 * and no power by the centre is beyond its error on the wrong side, that of a
 * point on the ball never.  hh_lifts gets a sphere near that ball, or not so
 * near; hh_height that ball with its centre rounded, and a plane, and all its
 * heights are within their errors. */
static void test_balls(int group, long n)
{
    static tess_real caller[15];
    long faults = 0, made = 0, tried = 0, sided = 0, lifted = 0, held = 0, i;
    double p[5][3], x[15], c[3], at[3], most, size, sum, power, err, w;
    double f[HH_FACET_LEN];
    tess_int order[5], v[3], a, b;
    int base, e, j, k, o, s, side, sign, alone, none, z;
    char name[80];
    hh_set set;
    hh_ball ball;
    hh_sphere about;

    for (i = 0; i < n; i++) {
        make(group, p);
        if (group == SUBNORMAL && rnd_below(2)) {
            /* the last one is larger than the facet's limbs hold */
            for (j = 0; j < 15; j++)
                p[j / 3][j % 3] = ldexp((rnd_below(4096) - 2048) * DBL_MIN *
                                            DBL_EPSILON,
                                        j < 12 ? 0 : rnd_below(20));
        } else if (rnd_below(2)) {
            /* small beside where they are: their leading limbs agree */
            most = 0.0;
            for (j = 0; j < 15; j++)
                if (fabs(p[j / 3][j % 3]) > most) most = fabs(p[j / 3][j % 3]);
            frexp(most, &e);
            e = -e - rnd_below(45);
            for (k = 0; k < 3; k++) at[k] = sym();
            for (j = 0; j < 15; j++)
                p[j / 3][j % 3] = at[j % 3] + ldexp(p[j / 3][j % 3], e);
        }
        incident_tet(p);
        o = ex_orient(P[0], P[1], P[2], P[3]);
        most = 0.0;
        for (j = 0; j < 15; j++) {
            caller[j] = R[j / 3][j % 3];
            if (fabs(P[j / 3][j % 3]) > most) most = fabs(P[j / 3][j % 3]);
        }
        if (most == 0.0 || o == 0) continue;
        frexp(most, &e);
        for (j = 0; j < 15; j++) x[j] = ldexp((double)caller[j], -e);
        for (j = 0; j < 5; j++) order[j] = (tess_int)j;
        set.x = x;
        set.p = caller;
        set.order = order;
        set.exact3 = set.exact5 = -1.0;
        set.exponent = e;
        base = rnd_below(3);
        v[0] = o > 0 ? 0 : 1;
        v[1] = o > 0 ? 1 : 0;
        v[2] = 2;
        if (!hh_centre(&set, v, base, 3, c, &ball)) continue;
        made++;
        sum = fabs(c[0]) + fabs(c[1]) + fabs(c[2]);
        hh_setup(x + 3 * v[base], x + 3 * v[(base + 1) % 3],
                 x + 3 * v[(base + 2) % 3], f);
        w = c[0] * f[0] + c[1] * f[1] + c[2] * f[2];
        if (rnd_below(2)) w += ldexp(sym() * f[11], -rnd_below(60));
        about.ready = 0;
        for (j = 0; j < 4 && f[9] <= HH_E_MAX; j++) {
            a = j % 2 ? 4 : 3;
            b = (tess_int)(7 - a);
            sign = hh_relative(&set, v, base, f, w, a, b, &about);
            o = ex_orient(P[v[0]], P[v[1]], P[v[2]], P[a]);
            s = ex_insphere(P[v[0]], P[v[1]], P[v[2]], P[a], P[b]);
            lifted += about.ready == 1 && sign != 2;
            if (sign != 2 && o != 0 && sign != -o * s && faults++ < 3) {
                printf("hh_lifts %d, exact %d:\n", sign, -o * s);
                show(5);
            }
        }
        for (j = 0; j < 2; j++) {
            a = (tess_int)rnd_below(5);
            if (!hh_surface(&set, a, v[base], j, j == 0 ? c : f, &about))
                continue;
            for (z = 0; z < 5; z++) {
                power = hh_height(&set, &about, (tess_int)z, &err);
                held += err < 1e-3;
                if (height_right(x, (int)a, (int)v[base], z, j,
                                 j == 0 ? c : f, power, err))
                    continue;
                if (faults++ < 3) {
                    printf("point %d: height %g, error %g, plane %d:\n", z,
                           power, err, j);
                    show(5);
                }
            }
        }
        for (z = 0; z < 5; z++) {
            o = ex_orient(P[v[0]], P[v[1]], P[v[2]], P[z]);
            s = ex_insphere(P[0], P[1], P[2], P[3], P[z]);
            side = sign = 2;
            hh_trial(&set, &ball, (tess_int)z, &side, &sign);
            if (z == 4) tried += sign != 2 || side == -1;
            /* without a power, the side in any case, and the same */
            alone = 2;
            none = -1;
            hh_trial(&set, &ball, (tess_int)z, &alone, &none);
            if (z == 4) sided += alone != 2;
            if ((alone != 2 && alone != o) || (sign != 2 && sign != -s) ||
                sign == 0 || none != -1 || side != (sign == 1 ? 2 : alone))
                if (faults++ < 3) {
                    printf("point %d: side %d, %d, %d; inside %d, %d:\n", z,
                           side, alone, o, -sign, s);
                    show(5);
                }
            power = size = 0.0;
            for (k = 0; k < 3; k++) {
                w = x[3 * z + k] - x[3 * v[base] + k];
                power += w * (w - 2.0 * c[k]);
                size += fabs(w);
            }
            if (size < ldexp(1.0, -SCALE(400))) continue;
            err = size * DBL_EPSILON * (16.0 * sum + 8.0 * (size + 2.0 * sum));
            if ((power > err && s != -1) || (power < -err && s != 1))
                if (faults++ < 3) {
                    printf("point %d: power %g, error %g; inside %d:\n", z,
                           power, err, s);
                    show(5);
                }
        }
    }
    printf("        balls %ld, trials decided %ld, sides %ld, by a sphere %ld, "
           "heights %ld\n", made, tried, sided, lifted, held);
    if (group == RANDOM)
        faults += made < n / 2 || tried < made - 1 - made / 100 ||
                  sided < made - 1 - made / 100;
    if (group == SPHERE) faults += held < 9 * made || tried < made / 2;
#ifndef TESS_FLOAT /* the filter decides these in double */
    if (group == SPHERE) faults += lifted < made / 4;
#endif
    sprintf(name, "balls by limbs: %s", names[group]);
    test_result(name, faults);
}

/* hh_flat: the sign of the projected area; hh_wider: the sign of a difference
 * of differences; on all classes. */
static void test_flat(long n)
{
    static ex_num a, b, c, d, r, t;
    long faults = 0, zeros = 0, i;
    double p[5][3], s[4], x;
    int group, axis, j, k, l, low, want, got;

    for (i = 0; i < n; i++) {
        /* differences of extreme values may overflow, and be cut off at the
         * largest number in some rounding modes */
        do group = rnd_below(3) ? rnd_below(CLASSES) : EXTREME;
        while (group == SUBNORMAL && flushes());
        make(group, p);
        if (rnd_below(3) == 0) {
            /* collinear, or nearly */
            x = dyadic(4);
            for (k = 0; k < 3; k++)
                p[2][k] = (1.0 - x) * p[0][k] + x * p[1][k];
        }
        incident_tet(p);
        for (axis = 0; axis < 3; axis++) {
            j = (axis + 1) % 3;
            k = (axis + 2) % 3;
            low = EX_NO_LOW;
            for (l = 0; l < 3; l++)
                low = ex_low(P[l][j], ex_low(P[l][k], low));
            want = 0;
            if (low != EX_NO_LOW) {
                ex_real(&t, P[0][j], low);
                ex_real(&a, P[1][j], low);
                ex_sub(&a, &a, &t);
                ex_real(&b, P[2][j], low);
                ex_sub(&b, &b, &t);
                ex_real(&t, P[0][k], low);
                ex_real(&c, P[1][k], low);
                ex_sub(&c, &c, &t);
                ex_real(&d, P[2][k], low);
                ex_sub(&d, &d, &t);
                ex_mul(&r, &a, &d);
                ex_mul(&t, &b, &c);
                want = ex_cmp(&r, &t);
            }
            got = hh_area(axis, R[0], R[1], R[2]);
            zeros += want == 0;
#if HH_LIMBS < 88
            if (got == 2) got = want;
#endif
            if (got != want && faults++ < 3) {
                printf("hh_flat axis %d: %d, exact %d\n", axis, got, want);
                show(3);
            }
        }
        for (k = 0; k < 4; k++) s[k] = P[k][0];
        if (rnd_below(2)) s[2] = s[0];
        if (rnd_below(4) == 0) s[3] = s[1];
        if (rnd_below(4) == 0) s[3] = nudge(s[1], rnd_below(3) - 1);
        if (fabs(s[3]) > REAL_MAX) continue;
        if (s[0] < s[1]) { x = s[0]; s[0] = s[1]; s[1] = x; }
        if (s[2] < s[3]) { x = s[2]; s[2] = s[3]; s[3] = x; }
        low = EX_NO_LOW;
        for (k = 0; k < 4; k++) low = ex_low(s[k], low);
        want = 0;
        if (low != EX_NO_LOW) {
            ex_real(&r, s[0], low);
            ex_real(&t, s[1], low);
            ex_sub(&a, &r, &t);
            ex_real(&r, s[2], low);
            ex_real(&t, s[3], low);
            ex_sub(&b, &r, &t);
            want = ex_cmp(&a, &b);
        }
        got = hh_wider(s[0], s[1], s[2], s[3]);
#if HH_LIMBS < 88
        if (got == 2) got = want;
#endif
        if (got != want && faults++ < 3)
            printf("hh_wider(%.17g, %.17g, %.17g, %.17g) = %d, exact %d\n",
                   s[0], s[1], s[2], s[3], got, want);
    }
    faults += zeros < n / 100;
    test_result("hh_flat, hh_wider", faults);
}

/* ---- the nearest point of a triangle ---- */

enum { AS_IT_IS, OVER, ACROSS, THIN, RIGHT, KINDS };

/* A triangle p[0..2] and q = p[3] in a special place. */
static void make_foot(int kind, double p[5][3])
{
    double d[3], n[3], u[3], r, s, t;
    int e, i, j, k, bits = 2 + rnd_below(5);

    make(kind == AS_IT_IS || rnd_below(3) == 0 ? rnd_below(CLASSES) : LATTICE,
         p);
    if (kind == AS_IT_IS) return;
    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) p[i][k] = rnd_below(1 << bits);
    if (kind == RIGHT) {
        /* a right angle, legs along two axes */
        j = rnd_below(3);
        for (i = 1; i < 3; i++)
            for (k = 0; k < 3; k++)
                if (k != (j + i) % 3) p[i][k] = p[0][k];
    }
    i = rnd_below(3);
    j = (i + 1 + rnd_below(2)) % 3;
    if (kind == THIN) {
        t = 0.125 * rnd_below(17) - 0.5;
        s = ldexp(1.0, -rnd_below(MANT_DIG - 8));
        for (k = 0; k < 3; k++) {
            e = 3 - i - j;
            p[e][k] = p[i][k] + t * (p[j][k] - p[i][k]) +
                      s * (rnd_below(3) - 1);
            p[3][k] = p[i][k] + t * (p[j][k] - p[i][k]) +
                      ldexp(rnd_below(9) - 4, -rnd_below(8));
        }
    }
    for (k = 0; k < 3; k++) {
        d[k] = p[j][k] - p[i][k];
        u[k] = p[3 - i - j][k] - p[i][k];
        n[k] = rnd_below(9) - 4;
    }
    if (kind == OVER) {
        /* over a vertex, a place on an edge, its line or the facet, or there */
        t = 0.25 * (rnd_below(9) - 2);
        r = rnd_below(3) ? 0.0 : 0.25;
        s = ldexp(rnd_below(3) - 1, -bits);
        for (k = 0; k < 3; k++)
            p[3][k] = p[i][k] + t * d[k] + r * u[k] +
                      s * (d[(k + 1) % 3] * u[(k + 2) % 3] -
                           d[(k + 2) % 3] * u[(k + 1) % 3]);
    }
    if (kind == ACROSS) /* in the plane through a vertex across an edge */
        for (k = 0; k < 3; k++)
            p[3][k] = p[i][k] + d[(k + 1) % 3] * n[(k + 2) % 3] -
                      d[(k + 2) % 3] * n[(k + 1) % 3];
    if (rnd_below(4) == 0) {
        i = rnd_below(4);
        k = rnd_below(3);
        p[i][k] = nudge(p[i][k], rnd_below(3) - 1);
    }
    if (rnd_below(3) == 0) {
        e = rnd_below(2 * MAX_EXP - 60) - MAX_EXP + 30;
        if (flushes() && e < 2 * MANT_DIG - MAX_EXP) e = 0;
        for (i = 0; i < 4; i++)
            for (k = 0; k < 3; k++) p[i][k] = ldexp(p[i][k], e);
    }
}

/* hh_foot: the vertices and their weights. */
static void test_foot(long n)
{
    static const char *const kinds[KINDS] = {
        "any", "over an edge", "across an edge", "needles", "right angles"
    };
    char name[80];
    double p[5][3], w[3], x[3], sum, most;
    const double *v[3];
    long faults, i, seen[8];
    int kind, k, want, got, weighed, bad;

    for (k = 0; k < 3; k++) v[k] = P[k];
    for (kind = 0; kind < KINDS; kind++) {
        faults = 0;
        most = 0.0;
        for (k = 0; k < 8; k++) seen[k] = 0;
        for (i = 0; i < (kind == AS_IT_IS ? n / 4 : n); i++) {
            make_foot(kind, p);
            incident_tet(p);
            if (ex_collinear(P[0], P[1], P[2])) continue;
            for (k = bad = 0; k < 12; k++)
                bad |= P[k / 3][k % 3] != 0.0 &&
                       fabs(P[k / 3][k % 3]) < DBL_MIN && flushes();
            if (bad) continue;
            want = ex_nearest(3, v, P[3], 3, P[0], x);
            got = hh_foot(R[0], R[1], R[2], R[3], NULL);
            for (k = 0; k < 3; k++) w[k] = 7.0;
            weighed = hh_foot(R[0], R[1], R[2], R[3], w);
#if HH_LIMBS < 88
            if (got == 0 || weighed == 0) {
                seen[0]++;
                if (got == 0) got = want;
                if (weighed == 0) continue;
            }
#endif
            seen[want]++;
            bad = want == 0 || got != want || weighed != want;
            for (k = 0, sum = 0.0; k < 3; k++) {
                if ((want >> k & 1) == 0 && w[k] != 0.0) bad = 1;
                if (!(fabs(w[k] - x[k]) <= 18.0 * DBL_EPSILON * x[k] + DBL_MIN))
                    bad = 1;
                if (x[k] > DBL_MIN && fabs(w[k] / x[k] - 1.0) > most)
                    most = fabs(w[k] / x[k] - 1.0);
                if (!(w[k] >= 0.0)) bad = 1;
                sum += w[k];
            }
            if (!(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON)) bad = 1;
            if (bad && faults++ < 3) {
                printf("hh_foot %d, with weights %d, exact %d; weights %g %g "
                       "%g, exact %g %g %g\n", got, weighed, want, w[0], w[1],
                       w[2], x[0], x[1], x[2]);
                show(4);
            }
        }
        printf("        vertices %ld %ld %ld, edges %ld %ld %ld, inside %ld, "
               "unsure %ld; error %.1f eps\n", seen[1], seen[2], seen[4],
               seen[3], seen[6], seen[5], seen[7], seen[0],
               most / DBL_EPSILON);
        for (k = 1; k < 8; k++) faults += seen[k] < n / 1000;
        sprintf(name, "hh_foot: %s", kinds[kind]);
        test_result(name, faults);
    }
}

static int low_of(int n)
{
    int low = EX_NO_LOW, i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) low = ex_low(P[i][k], low);
    return low;
}

/* hh_weigh: the weights in a tetrahedron against exact ratios of volumes, of
 * places in it, on its faces and edges and at its vertices, and of slivers. */
static void test_weigh(long n)
{
    static ex_num part, whole;
    double p[5][3], w[4], f[4], x, sum, most = 0.0;
    const double *v[4];
    tess_int order[4] = { 0, 1, 2, 3 };
    long faults = 0, unsure = 0, i, seen[5];
    int group, bits, low, j, k, e, m, zero, bad, side[4];

    for (k = 0; k < 5; k++) seen[k] = 0;
    for (i = 0; i < n; i++) {
        group = rnd_below(CLASSES);
        make(group, p);
        if (rnd_below(3)) {
            /* a mean of the vertices, exact where they are small integers */
            if (rnd_below(2)) make(LATTICE, p);
            bits = 1 + rnd_below(2);
            for (j = 0; j < 4; j++) f[j] = 0.0;
            for (j = 0; j < 1 << bits; j++) f[rnd_below(4)] += 1.0;
            e = rnd_below(4);
            for (k = 0; k < 3; k++) {
                if (rnd_below(4) == 0) /* nearly flat */
                    p[e][k] = p[(e + 1) % 4][k] +
                              (p[(e + 2) % 4][k] - p[(e + 3) % 4][k]);
                p[4][k] = 0.0;
                for (j = 0; j < 4; j++)
                    p[4][k] += f[j] * ldexp(p[j][k], -bits);
            }
        }
        if (rnd_below(8) == 0) p[rnd_below(4)][rnd_below(3)] *= 1e-20;
        /* sums of extreme values may overflow */
        for (k = bad = 0; k < 15; k++)
            bad |= !(fabs(p[k / 3][k % 3]) <= REAL_MAX);
        if (bad) continue;
        incident_tet(p);
        low = low_of(5);
        for (k = 0; k < 15; k++)
            bad |= P[k / 3][k % 3] != 0.0 &&
                   fabs(P[k / 3][k % 3]) < DBL_MIN && flushes();
        if (bad || low == EX_NO_LOW) continue;
        ex_volume(&whole, low, P[0], P[1], P[2], P[3]);
        for (k = zero = 0; k < 4; k++) {
            for (j = 0; j < 4; j++) v[j] = P[j == k ? 4 : j];
            ex_volume(&part, low, v[0], v[1], v[2], v[3]);
            side[k] = part.sign;
            zero += part.sign == 0;
            bad |= part.sign == -whole.sign;
            f[k] = whole.sign == 0 ? 0.0 :
                (double)(ex_value(&part, &e) / ex_value(&whole, &m));
            f[k] = ldexp(f[k], e - m);
            w[k] = 7.0;
        }
        if (bad || whole.sign == 0) continue;
        seen[zero]++;
        k = hh_weigh(R[0], order, R[4], w);
#if HH_LIMBS < 88
        unsure += k == 2;
        if (k == 2) continue;
#endif
        bad = k != 0;
        for (k = 0, sum = 0.0; k < 4; k++) {
            if (!(w[k] >= 0.0) || (side[k] == 0 && w[k] != 0.0)) bad = 1;
            if (!(fabs(w[k] - f[k]) <= 14.0 * DBL_EPSILON * f[k] + DBL_MIN))
                bad = 1;
            x = f[k] > DBL_MIN ? fabs(w[k] / f[k] - 1.0) : 0.0;
            if (x > most) most = x;
            sum += w[k];
        }
        if (!(fabs(sum - 1.0) <= 4.0 * DBL_EPSILON)) bad = 1;
        if (bad && faults++ < 3) {
            printf("hh_weigh %g %g %g %g, exact %g %g %g %g\n", w[0], w[1],
                   w[2], w[3], f[0], f[1], f[2], f[3]);
            show(5);
        }
    }
    printf("        inside %ld, on faces %ld, edges %ld, vertices %ld, unsure "
           "%ld; error %.1f eps\n", seen[0], seen[1], seen[2], seen[3], unsure,
           most / DBL_EPSILON);
    for (k = 0; k < 4; k++) faults += seen[k] < n / 1000;
    test_result("hh_weigh", faults);
}

#if HH_LIMBS < 88
/* hh_range promises what the determinants need: when it says that the limbs
 * hold a coordinate beside another one, no sign is 2. */
static void test_range(long n)
{
    long faults = 0, held = 0, out = 0, i;
    double p[5][3], most;
    int j, k, fits, o, v, f;

    for (i = 0; i < n; i++) {
        do make(rnd_below(CLASSES), p);
        while (0);
        settle(p);
        most = 0.0;
        for (j = 0; j < 15; j++)
            if (fabs(P[j / 3][j % 3]) > most) most = fabs(P[j / 3][j % 3]);
        if (most == 0.0 || (most < DBL_MIN && flushes())) continue;
        fits = 1;
        for (j = 0; j < 5; j++)
            for (k = 0; k < 3; k++)
                if (hh_range(P[j][k], most) != 0) fits = 0;
        o = hh_orient(R[0], R[1], R[2], R[3]);
        v = hh_insphere(R[0], R[1], R[2], R[3], R[4]);
        f = hh_foot(R[0], R[1], R[2], R[3], NULL);
        if (fits) held++;
        else out++;
        if (fits && (o == 2 || v == 2 || f == 0) && faults++ < 3) {
            printf("in range, but hh_orient %d, hh_insphere %d, hh_foot %d\n",
                   o, v, f);
            show(5);
        }
    }
    printf("        in range %ld, out of it %ld\n", held, out);
    faults += held < n / 20 || out < n / 20;
    test_result("hh_range", faults);
}
#endif

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
            incident_tet(p);
            exact_facet(low_of(5));
            exact_point(P[3]);
            fault = NULL;
            if (!limbs) test_public();
            test_limits(lo, hi, &last, limbs);
            if (fault != NULL && faults++ < 3) {
                printf("%s:\n", fault);
                show(5);
            }
            for (k = 0; k < 3; k++) p[4][k] = p[3][k];
        }
    }
    printf("        sides decided %ld of %ld, orders %ld of %ld, else limits "
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
        while (group == SUBNORMAL && flushes());
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
        incident_tet(p);
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
            printf("%s: code %d, collinear %d:\n", names[group], code, line);
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
    faults += hh_foot(o, x, y, near, w) != (hh_range(c, 1.0) == 0 ? 7 : 0);
    test_result("values known by hand", faults);
}

/* hh_height of one of two points, ever nearer, above a plane and a sphere
 * through the other.  At the pole of a globe sin(pi) cos(pi/2), of 53 bits from
 * 2^-107 on, is a coordinate: that must be held, and any error known. */
static void test_heights(void)
{
    static const double c[3] = { 1.0, 0.0, 0.0 };
    static const tess_int order[2] = { 0, 1 };
    double x[15], h, err = 0.0;
    long faults = 0;
    tess_int base;
    int e, plane, k;
    tess_real p[6];
    hh_set set;
    hh_sphere about;

    for (k = 0; k < 6; k++) p[k] = 0;
    for (k = 0; k < 15; k++) x[k] = 0.0;
    set.x = x;
    set.p = p;
    set.order = order;
    set.exact3 = set.exact5 = -1.0;
    set.exponent = 0;
    for (e = 1; e < 300 && e < -DBL_MIN_EXP; e++)
        for (k = 0; k < 4; k++) {
            plane = k / 2;
            base = (tess_int)(k % 2);
            x[3] = ldexp(2.0 - DBL_EPSILON, -e);
            err = 1.0;
            if (hh_surface(&set, base, 0, plane, c, &about)) {
                h = hh_height(&set, &about, (tess_int)(1 - base), &err);
                faults += !height_right(x, (int)base, 0, (int)(1 - base), plane,
                                        c, h, err);
            }
            faults += DBL_MANT_DIG >= 53 && e <= 107 && err > 1e-3;
        }
    test_result("hh_height, ever nearer", faults);
}

/* hh_holds of n points p in a state: see test_state. */
static int holds(int n, const tess_real *p, unsigned bits,
                 unsigned precision)
{
    int k;

    test_state(0, bits, precision);
    k = hh_holds((tess_int)n, p);
    test_state(1, 0, 0);
    return k;
}

/* Arithmetic that is not a double's must be noticed, at any place. */
static void test_holds(void)
{
    tess_real p[9];
    long faults = 0;
    int i, n;

    for (n = 0; n <= 3; n++) {
        for (i = 0; i < 9; i++) p[i] = 1;
        faults += !holds(n, p, 0, 2) || holds(n, p, 0, 0) == BY_X87;
        for (i = 0; i < 9 && !BY_X87; i++) {
            p[i] = (tess_real)(3.0 * DBL_MIN / 8.0);
#ifdef TESS_FLOAT
            p[i] = (tess_real)(3.0 * FLT_MIN / 8.0);
#else
            faults += holds(n, p, 0x8000, 3) != (i >= 3 * n);
#endif
            faults += holds(n, p, 0x40, 3) != (i >= 3 * n);
            p[i] = 0;
            faults += !flushes() && !holds(n, p, 0x8040, 3);
            p[i] = 1;
        }
    }
    test_result("a processor's state is noticed", faults);
}

/* What takes a coordinate for zero, any of any point, must say so: hh_foot with
 * weights and hh_weigh always, signs and hh_foot without where all are small,
 * and signs of points in a plane. */
static void test_flushed(void)
{
    static const int at[15] = { 1, 2, 3, 5, 1, 2, 2, 6, 1, 1, 1, 9, 2, 3, 4 };
    static const tess_int v[4] = { 0, 1, 2, 3 };
    tess_real p[15], s[15], flat[12];
    double w[4];
    long faults = 0;
    int found[6], flush, i, k;

    for (i = 0; i < 15; i++)
        for (flush = 0; flush < 2; flush++) {
            for (k = 0; k < 15; k++) {
                p[k] = (tess_real)at[k];
                s[k] = (tess_real)ldexp((double)at[k], -100);
                if (k < 12) flat[k] = k % 3 == 2 ? 0 : p[k];
            }
            p[i] = (tess_real)(3.0 * DBL_MIN / 8.0);
#ifdef TESS_FLOAT
            p[i] = (tess_real)(3.0 * FLT_MIN / 8.0);
#endif
            s[i] = p[i];
            if (i < 12) flat[i] = p[i];
            test_state(0, flush ? 0x40 : 0, 3);
            found[0] = hh_foot(p, p + 3, p + 6, p + 9, w);
            found[1] = hh_foot(s, s + 3, s + 6, s + 9, NULL);
            found[2] = hh_weigh(p, v, p + 12, w);
            found[3] = hh_orient(s, s + 3, s + 6, s + 9);
            found[4] = hh_insphere(s, s + 3, s + 6, s + 9, s + 12);
            found[5] = hh_orient(flat, flat + 3, flat + 6, flat + 9);
            test_state(1, 0, 0);
            if (!flush && (HH_LIMBS < 88 || flushes())) continue;
            faults += i < 12 && (found[0] == 0) != flush;
            faults += i < 12 && (found[1] == 0) != flush;
            faults += (found[2] == 2) != flush;
            faults += i < 12 && (found[3] == 2) != flush;
            faults += (found[4] == 2) != flush;
            faults += i < 12 && (found[5] == 2) != flush;
        }
    test_result("a coordinate taken for zero is noticed", faults);
}

static void all(void)
{
    int group;

    test_known();
    test_heights();
    if (test_state(0, 0, 2)) {
        test_state(1, 0, 0);
        test_holds();
        if (!BY_X87) test_flushed();
    }
    test_exact();
    for (group = 0; group < CLASSES; group++) {
        long n = 20000;

        if (group == SUBNORMAL && flushes()) {
            printf("        subnormal numbers are flushed to zero: their "
                   "class is skipped\n");
            continue;
        }
        /* these take numbers of thousands of bits */
        if (group == MIXED || group == EXTREME || group == BOXES) n = 500;
        if (group == FARAPART) n = 2000;
        test_signs(group, n * percent / 100);
    }
    test_indexed(LATTICE, 20000 * percent / 100);
    test_indexed(INTEGERS, 5000 * percent / 100);
    test_indexed(INTEGER_PLANE, 20000 * percent / 100);
    test_indexed(INTEGER_SPHERE, 20000 * percent / 100);
    test_indexed(SPHERE, 20000 * percent / 100);
    test_indexed(LIMBS, 20000 * percent / 100);
    test_indexed(NORMED, 5000 * percent / 100);
    test_indexed(PLANE, 5000 * percent / 100);
    for (group = 0; group < CLASSES; group++)
        if (group != SUBNORMAL || !flushes())
            test_balls(group, (group == MIXED || group == EXTREME ||
                               group == BOXES ? 200 : 3000) *
                                  percent / 100);
    test_flat(20000 * percent / 100);
    test_foot(10000 * percent / 100);
    test_weigh(20000 * percent / 100);
#if HH_LIMBS < 88
    test_range(20000 * percent / 100);
#endif
    test_codes(20000 * percent / 100);
    for (group = 0; group < FACETS; group++)
        test_facets(group, 0, 5000 * percent / 100);
    for (group = 0; group < FACETS; group++)
        test_facets(group, 1, 2000 * percent / 100);
}

int main(int argc, char **argv)
{
    static const char usage[] = "[percent [seed]]";
    long seed = 1;

    if (argc > 3) test_usage(argv[0], usage);
    if (argc > 1) percent = test_number(argv[1], 1, argv, usage);
    if (argc > 2) seed = test_number(argv[2], 0, argv, usage);
    rnd_seed((unsigned long)seed);
    find_sphere();
    test_modes(all);
    return test_end("t_pred");
}
