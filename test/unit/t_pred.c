/* t_pred.c - tests of the signs of hhpred.c against exact integer arithmetic
 * (exact.c), on points made to be hard; t_facet.c has the rest.
 *
 *     t_pred [percent [seed]]   percent of the usual number of cases
 *
 * Covered: the signs of hh_orient, hh_insphere, hh_area, hh_wider, hh_porient
 * and hh_pinsphere; hh_foot's face and weights, and hh_weigh's; the heights of
 * hh_height; what a processor's state alters.  A failure prints the points in
 * full.
 *
 * Compiled with few limbs (-DHH_LIMBS=3, hhpred.c likewise), the signs may be
 * 2 where the limbs do not suffice, and must be where they cannot.
 * With -DTEST_ROUNDING (C99's fenv.h) all is done in four rounding modes.
 */
#include "lib/five.h"
#include "../lib/exact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static long percent = 100;

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
        settle(p);
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
                printf("# hh_orient %d, permuted %d, exact %d; hh_insphere %d, "
                       "permuted %d, exact %d, exchanged %d, exact %d:\n",
                       o, t, h, v, m, s, v2, want);
                show(5);
            }
        }
    }
    printf("# orient -/0/+/2 %ld %ld %ld %ld, insphere %ld %ld %ld "
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
        settle(p);
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
                printf("# hh_porient %d, exact %d; hh_pinsphere %d, exact %d; "
                       "order %d %d %d %d %d, t5 %g:\n", j, o, k, s, index[0],
                       index[1], index[2], index[3], index[4], set.exact5);
                show(5);
            }
        }
    }
    printf("# ties %ld of %ld\n", ties, n);
    if (group == LATTICE || group == SPHERE) faults += ties < n / 20;
    sprintf(name, "hh_porient, hh_pinsphere: %s", names[group]);
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

/* hh_centre, hh_trial and hh_relative as tess calls them, on the ball of the first
 * four points and the last one: the trial's signs are the exact ones, or UNSURE,
 * and no power by the centre is beyond its error on the wrong side, that of a
 * point on the ball never.  hh_relative gets a sphere near that ball, or not so
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
        settle(p);
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
                printf("# hh_relative %d, exact %d:\n", sign, -o * s);
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
                    printf("# point %d: height %g, error %g, plane %d:\n", z,
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
                    printf("# point %d: side %d, %d, %d; inside %d, %d:\n", z,
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
                    printf("# point %d: power %g, error %g; inside %d:\n", z,
                           power, err, s);
                    show(5);
                }
        }
    }
    printf("# balls %ld, trials decided %ld, sides %ld, by a sphere %ld, "
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
        while (group == SUBNORMAL && test_flushes());
        make(group, p);
        if (rnd_below(3) == 0) {
            /* collinear, or nearly */
            x = dyadic(4);
            for (k = 0; k < 3; k++)
                p[2][k] = (1.0 - x) * p[0][k] + x * p[1][k];
        }
        settle(p);
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
                printf("# hh_flat axis %d: %d, exact %d\n", axis, got, want);
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
            printf("# hh_wider(%.17g, %.17g, %.17g, %.17g) = %d, exact %d\n",
                   s[0], s[1], s[2], s[3], got, want);
    }
    faults += zeros < n / 100;
    test_result("hh_area, hh_wider", faults);
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
        if (test_flushes() && e < 2 * MANT_DIG - MAX_EXP) e = 0;
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
            settle(p);
            if (ex_collinear(P[0], P[1], P[2])) continue;
            for (k = bad = 0; k < 12; k++)
                bad |= P[k / 3][k % 3] != 0.0 &&
                       fabs(P[k / 3][k % 3]) < DBL_MIN && test_flushes();
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
                printf("# hh_foot %d, with weights %d, exact %d; weights %g %g "
                       "%g, exact %g %g %g\n", got, weighed, want, w[0], w[1],
                       w[2], x[0], x[1], x[2]);
                show(4);
            }
        }
        printf("# vertices %ld %ld %ld, edges %ld %ld %ld, inside %ld, "
               "unsure %ld; error %.1f eps\n", seen[1], seen[2], seen[4],
               seen[3], seen[6], seen[5], seen[7], seen[0],
               most / DBL_EPSILON);
        for (k = 1; k < 8; k++) faults += seen[k] < n / 1000;
        sprintf(name, "hh_foot: %s", kinds[kind]);
        test_result(name, faults);
    }
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
        settle(p);
        low = low_of(5);
        for (k = 0; k < 15; k++)
            bad |= P[k / 3][k % 3] != 0.0 &&
                   fabs(P[k / 3][k % 3]) < DBL_MIN && test_flushes();
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
            printf("# hh_weigh %g %g %g %g, exact %g %g %g %g\n", w[0], w[1],
                   w[2], w[3], f[0], f[1], f[2], f[3]);
            show(5);
        }
    }
    printf("# inside %ld, on faces %ld, edges %ld, vertices %ld, unsure "
           "%ld; error %.1f eps\n", seen[0], seen[1], seen[2], seen[3], unsure,
           most / DBL_EPSILON);
    for (k = 0; k < 4; k++) faults += seen[k] < n / 1000;
    test_result("hh_weigh", faults);
}

#if HH_LIMBS < 88
/* hh_fits promises what the determinants need: when it says that the limbs
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
        if (most == 0.0 || (most < DBL_MIN && test_flushes())) continue;
        fits = 1;
        for (j = 0; j < 5; j++)
            for (k = 0; k < 3; k++)
                if (!hh_fits(P[j][k], most)) fits = 0;
        o = hh_orient(R[0], R[1], R[2], R[3]);
        v = hh_insphere(R[0], R[1], R[2], R[3], R[4]);
        f = hh_foot(R[0], R[1], R[2], R[3], NULL);
        if (fits) held++;
        else out++;
        if (fits && (o == 2 || v == 2 || f == 0) && faults++ < 3) {
            printf("# in range, but hh_orient %d, hh_insphere %d, hh_foot %d\n",
                   o, v, f);
            show(5);
        }
    }
    printf("# in range %ld, out of it %ld\n", held, out);
    faults += held < n / 20 || out < n / 20;
    test_result("hh_fits", faults);
}
#endif
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
            faults += !test_flushes() && !holds(n, p, 0x8040, 3);
            p[i] = 1;
        }
    }
    test_result("a processor's state is noticed", faults);
}

/* What takes a coordinate for zero, any of any point, must say so: hh_holds,
 * hh_held, which those who call hh_foot and hh_weigh ask, and signs, of all
 * magnitudes and of points in a plane. */
static void test_flushed(void)
{
    static const int at[15] = { 1, 2, 3, 5, 1, 2, 2, 6, 1, 1, 1, 9, 2, 3, 4 };
    tess_real p[15], s[15], flat[12];
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
            found[0] = hh_holds(5, p);
            found[1] = hh_held(s + i / 3 * 3);
            found[2] = hh_insphere(p, p + 3, p + 6, p + 9, p + 12);
            found[3] = hh_orient(s, s + 3, s + 6, s + 9);
            found[4] = hh_insphere(s, s + 3, s + 6, s + 9, s + 12);
            found[5] = hh_orient(flat, flat + 3, flat + 6, flat + 9);
            test_state(1, 0, 0);
            if (!flush && (HH_LIMBS < 88 || test_flushes())) continue;
            faults += (found[0] == 0) != flush;
            faults += (found[1] == 0) != flush;
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

    test_heights();
    if (test_state(0, 0, 2)) {
        test_state(1, 0, 0);
        test_holds();
        if (!BY_X87) test_flushed();
    }
    test_exact();
    for (group = 0; group < CLASSES; group++) {
        long n = 20000;

        if (group == SUBNORMAL && test_flushes()) {
            printf("# subnormal numbers are flushed to zero: their "
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
        if (group != SUBNORMAL || !test_flushes())
            test_balls(group, (group == MIXED || group == EXTREME ||
                               group == BOXES ? 200 : 3000) *
                                  percent / 100);
    test_flat(20000 * percent / 100);
    test_foot(10000 * percent / 100);
    test_weigh(20000 * percent / 100);
#if HH_LIMBS < 88
    test_range(20000 * percent / 100);
#endif
}

int main(int argc, char **argv)
{
    return five_main(argc, argv, all, &percent);
}
