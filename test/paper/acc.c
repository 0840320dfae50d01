/* acc.c - acc [-check]: the accuracy experiments of the paper's Section 4.
 *
 * An insphere problem is five points: a facet p1, p2, p3, a point p4 that
 * makes it a ball, and the test point p5.  Householder: p5 is inside if its
 * L-coordinate is less than that of p4 (Theorem 1).  Determinants: by the
 * minors of p1 ... p4.  Both in arithmetic of 24 and 53 bits, rounded at
 * every operation (round.h).  Exact: hh_insphere, on the points as rounded to
 * 24 or 53 bits, proven at every step by exact.c.
 *
 * Without -check it prints two tables: one problem, as in the paper, and how
 * many of 1000 random problems each method gets wrong.  With -check it tests
 * what must hold whatever the machine.  With -blas, in a build with -DCBLAS,
 * it prints what Householder by BLAS calls in float does.
 *
 * Linked with twin/shim.c and f77/hhpred.f it prints the same.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "../../hhpred.h"
#include "../lib/exact.h"
#include "round.h"
#ifdef CBLAS
#include "blas.h"
#endif

#define MANY 1000

/* Answers: outside -1, on the ball 0, inside 1, and no answer. */
#define DIVIDE 2

/* The problem: the origin is on the ball, and every coordinate of p1 is
 * between 1 and 2. */
static const double one[5][3] = {
    {1.5, 1.25, 1.75}, {-0.75, 1.5, 0.5}, {0.5, -1.25, 1.0}, {0.0, 0.0, 0.0},
    {0.5, 0.5, 0.5}
};

static long faults[8];

static int signof(double x) { return x > 0.0 ? 1 : x < 0.0 ? -1 : 0; }

/* house - the answer by L-coordinates. */
static int house(double p[5][3])
{
    double f[RA_FACET_LEN], l4, l5;

    if (ra_facet(p[0], p[1], p[2], f)) return DIVIDE;
    if (ra_lcoord(f, p[3], &l4) || ra_lcoord(f, p[4], &l5)) return DIVIDE;
    return ra_side(f, p[4]) > 0.0 ? signof(l4 - l5) : signof(l5 - l4);
}

#ifdef CBLAS
/* The cases in 32 bits, those where BLAS makes no difference, and the powers
 * at which it first gives 0, or divides by 0, for the problem. */
static long cases, same;
static int zeroat, divat;

/* calls - the answer by L-coordinates with BLAS calls, in float. */
static int calls(double p[5][3])
{
    float s[5][3], f[9], l;
    int i, k;

    for (i = 0; i < 5; i++)
        for (k = 0; k < 3; k++) s[i][k] = (float)p[i][k];
    if (bs_facet(s[0], s[1], s[2], f)) return DIVIDE;
    if (bs_side(f, s[3]) == 0 || bs_side(f, s[4]) == 0) return DIVIDE;
    l = bs_lcoord(f, s[3]) - bs_lcoord(f, s[4]);
    return bs_side(f, s[4]) > 0 ? signof(l) : signof(-l);
}

static void compare(double p[5][3], int answer)
{
    cases++;
    same += calls(p) == answer;
}
#endif

/* dets - the answer by determinants, with the true orientation as a gift. */
static int dets(double p[5][3])
{
    double m[RA_MINORS];

    ra_minors(p[0], p[1], p[2], p[3], m);
    return signof(ra_det(m, p[4])) * hh_orient(p[0], p[1], p[2], p[3]);
}

/* within - the library's L-coordinate and the bound of its error that
 * hhpred.h states: the side of z if it is certain, else 0. */
static int within(const double *f, const double *z, double *l, double *dl)
{
    double w = 0.0, side = hh_side(f, z), gap;
    int k;

    for (k = 0; k < 3; k++) w += (z[k] - f[6 + k]) * (z[k] - f[6 + k]);
    w = sqrt(w) * (1.0 + 8.0 * DBL_EPSILON);
    gap = fabs(side) - f[9] * w;
    if (f[9] >= 1.0 || !(gap > 0.0)) return 0;
    *l = hh_lcoord(f, z);
    *dl = w * (DBL_EPSILON * (3.0 * w + 5.0 * f[11]) + f[10] +
               fabs(*l) * f[9]) / gap + 4.0 * DBL_EPSILON * fabs(*l);
    return signof(side);
}

/* certain - the answer that the library's bound proves, or 0. */
static int certain(double p[5][3])
{
    double f[HH_FACET_LEN], l4, l5, d4, d5;
    int side;

    if (hh_facet(p[0], p[1], p[2], f)) return 0;
    side = within(f, p[4], &l5, &d5);
    if (side == 0 || within(f, p[3], &l4, &d4) == 0) return 0;
    if (l5 + d5 < l4 - d4) return side;
    if (l4 + d4 < l5 - d5) return -side;
    return 0;
}

/* number - a random multiple of 2^-22 in [-2, 2): 24 bits. */
static double number(void)
{
    static double seed = 1.0;

    seed = fmod(16807.0 * seed, 2147483647.0);
    return floor(seed / 128.0) / 4194304.0 - 2.0;
}

/* make - a random problem with p4 and p5 on the facet's positive side, and
 * p4 the origin if origin. */
static void make(int origin, double p[5][3])
{
    double t;
    int i, k;

    do {
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = origin && i == 3 ? 0.0 : number();
        if (hh_orient(p[0], p[1], p[2], p[3]) < 0)
            for (k = 0; k < 3; k++) {
                t = p[0][k];
                p[0][k] = p[1][k];
                p[1][k] = t;
            }
    } while (hh_orient(p[0], p[1], p[2], p[3]) <= 0 ||
             hh_orient(p[0], p[1], p[2], p[4]) <= 0);
}

/* What the methods say of a problem. */
typedef struct answers {
    int house, dets, exact, proven, right;
} answers;

static answers ask(double p[5][3])
{
    answers a;

    a.house = house(p);
    a.dets = dets(p);
    a.exact = hh_insphere(p[0], p[1], p[2], p[3], p[4]);
    a.proven = certain(p);
    a.right = ex_insphere(p[0], p[1], p[2], p[3], p[4]);
    faults[0] += a.exact != a.right;
    faults[1] += a.proven != 0 && a.proven != a.right;
    return a;
}

static const char *word(int answer, int right)
{
    static const char *const name[4] = {"outside", "on", "inside", "0 divide"};
    static const char *const not[4] = {"outside*", "on*", "inside*",
                                       "0 divide"};

    return answer == right ? name[answer + 1] : not[answer + 1];
}

/* Counts over the random problems, by power. */
typedef struct counts {
    long zero, wrong, divide, dets, first, exact, sure, changed;
    double error;
} counts;

static void count(counts *c, const answers *a)
{
    if (a->house == DIVIDE) c->divide++;
    else if (a->house == 0 && a->right != 0) c->zero++;
    else if (a->house != a->right) c->wrong++;
    c->dets += a->dets != a->right;
    c->exact += a->exact != a->right;
    c->sure += a->proven != 0;
}

/* first - a line of what fails first at which power of ten; ten is 0 for
 * none. */
static void first(const char *name, int ten, const char *paper)
{
    if (ten == 0) printf("  %-46s none    %s\n", name, paper);
    else printf("  %-46s 1E%+03d   %s\n", name, ten, paper);
}

/* ---- the test point approaches the origin ---- */

/* shrink - p5 is d times 10^-ten. */
static void shrink(int bits, int ten, const double *d, double p[5][3])
{
    double x;
    int i, k;

    for (k = 0; k < 3; k++) {
        x = d[k];
        ra_bits(53);
        for (i = 0; i < ten; i++) x = ra_div(x, 10.0);
        ra_bits(bits);
        p[4][k] = ra_keep(x);
    }
}

#define POWERS1 20

static void approach(int bits, int print)
{
    static counts c[POWERS1 + 1];
    double p[5][3], d[3];
    answers a[POWERS1 + 1], b;
    int i, j, k, house1 = 0, dets1 = 0, exact1 = 0;

    memset(c, 0, sizeof c);
    memcpy(p, one, sizeof p);
    for (j = 1; j <= POWERS1; j++) {
        shrink(bits, j, one[4], p);
        a[j] = ask(p);
#ifdef CBLAS
        if (bits == 24 && zeroat == 0 && calls(p) == 0) zeroat = -j;
#endif
        if (house1 == 0 && a[j].house != a[j].right) house1 = -j;
        if (dets1 == 0 && a[j].dets != a[j].right) dets1 = -j;
        if (exact1 == 0 && a[j].exact != a[j].right) exact1 = -j;
        /* p5 - p1 rounds to -p1 as |p5| < half a last place of p1 */
        faults[2] += 0.5 * pow(10.0, -j) < ldexp(1.0, -bits) &&
                     a[j].house != 0;
        /* p4 is the origin: the last minor is exactly 0, and the rest is as
         * far from 0, beside its roundings, at any distance */
        faults[3] += a[j].dets != a[j].right;
        faults[4] += a[j].right != 1;
    }
    for (i = 0; i < MANY; i++) {
        make(1, p);
        for (k = 0; k < 3; k++) d[k] = 0.25 * p[4][k];
        for (j = 1; j <= POWERS1; j++) {
            shrink(bits, j, d, p);
            b = ask(p);
#ifdef CBLAS
            if (bits == 24) compare(p, b.house);
#endif
            count(&c[j], &b);
        }
    }
    if (!print) return;
    printf("\n %d-bit arithmetic\n\n", bits == 24 ? 32 : 64);
    printf("            the problem                       of %d random "
           "problems\n", MANY);
    printf("                                              Householder  "
           "determ.  exact  bound\n");
    printf("  distance  Householder determ.  exact         zero  wrong    "
           "wrong  wrong  decides\n");
    for (j = 1; j <= POWERS1; j++)
        printf("  1E-%02d     %-11s %-8s %-8s     %5ld %6ld %8ld %6ld %8ld\n",
               j, word(a[j].house, a[j].right), word(a[j].dets, a[j].right),
               word(a[j].exact, a[j].right), c[j].zero, c[j].wrong, c[j].dets,
               c[j].exact, c[j].sure);
    printf("\n  First failure, at the distance                 ours    "
           "paper\n");
    first("Householder: 0, the problem", house1, bits == 24 ? "1E-07" : "-");
    first("determinants: wrong, the problem", dets1, bits == 24 ? "none down to 1E-14" : "-");
    first("exact: wrong, the problem", exact1, "-");
}

/* ---- the points are moved away from the origin ---- */

/* translate - p is q moved along an axis by 10^ten, or not for 0. */
static void translate(int bits, int axis, int ten, double q[5][3],
                      double p[5][3])
{
    double move = 1.0;
    int i;

    for (i = 0; i < ten; i++) move *= 10.0;
    ra_bits(bits);
    memcpy(p, q, 15 * sizeof(double));
    if (ten > 0)
        for (i = 0; i < 5; i++) p[i][axis] = ra_add(q[i][axis], move);
}

/* error - the decimal logarithm of the relative error of the determinant of
 * q when it is moved: a translation does not alter a determinant. */
static double error(int bits, double q[5][3], double p[5][3])
{
    double m[RA_MINORS], x, y;

    ra_bits(53);
    ra_minors(q[0], q[1], q[2], q[3], m);
    x = ra_det(m, q[4]);
    ra_bits(bits);
    ra_minors(p[0], p[1], p[2], p[3], m);
    y = fabs((ra_det(m, p[4]) - x) / x);
    return log10(y > 1e-18 ? y : 1e-18);
}

#define POWERS2 17

static void move(int bits, int print)
{
    static counts c[POWERS2 + 1];
    double p[5][3], q[5][3];
    answers a[POWERS2 + 1], b;
    int i, j, n = bits == 24 ? 9 : POWERS2, flat, truth = 0;
    int divide1 = 0, dets1 = 0, exact1 = 0, moved1 = 0, median = 0, near1;
    int failed;
    long sum = 0, near = 0, along[3];

    near1 = bits == 24 ? 8 : 16;
    along[0] = along[1] = along[2] = 0;
    memset(c, 0, sizeof c);
    memcpy(q, one, sizeof q);
    for (j = 0; j <= n; j++) {
        translate(bits, 2, j, q, p);
        a[j] = ask(p);
#ifdef CBLAS
        if (bits == 24 && divat == 0 && calls(p) == DIVIDE) divat = j;
#endif
        if (divide1 == 0 && a[j].house == DIVIDE) divide1 = j;
        if (dets1 == 0 && a[j].dets != a[j].right) dets1 = j;
        if (exact1 == 0 && a[j].exact != a[j].right) exact1 = j;
        if (moved1 == 0 && a[j].right != a[0].right) moved1 = j;
    }
    for (i = 0; i < MANY; i++) {
        make(0, q);
        for (j = 0, failed = 0; j <= n; j++) {
            translate(bits, 2, j, q, p);
            b = ask(p);
#ifdef CBLAS
            if (bits == 24) compare(p, b.house);
#endif
            if (j == 0) truth = b.right;
            count(&c[j], &b);
            c[j].changed += b.right != truth;
            c[j].error += error(bits, q, p) / MANY;
            if (failed == 0 && b.dets != b.right) {
                c[j].first++;
                failed = 1;
            }
            /* coordinates below 2 vanish beside more than 2^(bits+1): all
             * points are in one plane z, no rounding disturbs the normal
             * (0, 0, 1) */
            flat = ldexp(1.0, bits + 1) < pow(10.0, j);
            faults[5] += flat && (b.house != DIVIDE || b.right != 0);
        }
        for (j = 0; j < 3; j++) {
            translate(bits, j, n, q, p);
            b = ask(p);
            along[j] += b.house == DIVIDE;
        }
        /* of less than 1, beside more than 2^bits */
        for (j = 0; j < 5; j++) q[j][2] *= 0.5;
        translate(bits, 2, near1, q, p);
        b = ask(p);
        near += b.house == DIVIDE;
    }
    faults[5] += near != MANY;
    for (j = 0; j <= n; j++) {
        /* with 10 bits left after the point */
        if (ldexp(1.0, bits - 10) > pow(10.0, j))
            faults[6] += c[j].wrong + c[j].divide > MANY / 100;
        if (median == 0 && (sum += c[j].first) >= MANY / 2) median = j;
    }
    /* the error grows like 10^(3 ten) 2^-bits: 1 after bits/10 powers */
    faults[7] += c[bits / 10 - 1].dets > 0 ||
                 c[bits / 10 + 2].dets < MANY / 4;
    if (!print) return;
    printf("\n %d-bit arithmetic\n\n", bits == 24 ? 32 : 64);
    printf("            the problem                       of %d random "
           "problems\n", MANY);
    printf("                                              Householder  "
           "determinants         exact  bound    changed by\n");
    printf("  moved     Householder determ.  exact        0 div wrong   "
           "wrong  first  error  wrong  decides  rounding\n");
    for (j = 0; j <= n; j++) {
        if (j == 0) printf("  0     ");
        else printf("  1E+%02d ", j);
        printf("    %-11s %-8s %-8s     %5ld %5ld %7ld %6ld %6.1f %6ld %8ld "
               "%9ld\n",
               word(a[j].house, a[j].right), word(a[j].dets, a[j].right),
               word(a[j].exact, a[j].right), c[j].divide, c[j].wrong,
               c[j].dets, c[j].first, c[j].error, c[j].exact, c[j].sure,
               c[j].changed);
    }
    printf("\n  First failure, moved by                        ours    "
           "paper\n");
    first("Householder: zero divide, the problem", divide1,
          bits == 24 ? "1E+08" : "1E+16");
    first("determinants: wrong, the problem", dets1,
          bits == 24 ? "1E+04" : "1E+06");
    first("determinants: wrong, half the random ones", median, "-");
    first("exact: wrong, the problem", exact1, "-");
    first("the problem is another one, as rounded", moved1, "-");
    printf("\n  Zero divides of the random problems, with z halved,"
           "       at 1E+%02d: %4ld\n", near1, near);
    for (i = 0; i < 3; i++)
        printf("                                      moved along %c, "
               "     at 1E+%02d: %4ld\n", "xyz"[i], n, along[i]);
}

int main(int argc, char **argv)
{
    int check = argc > 1 && strcmp(argv[1], "-check") == 0;

#ifdef CBLAS
    if (argc > 1 && strcmp(argv[1], "-blas") == 0) {
        approach(24, 0);
        move(24, 0);
        printf("0 at 1E%+03d, zero divide at 1E%+03d; the same answer as "
               "without BLAS\n    in %ld of %ld random problems\n", zeroat,
               divat, same, cases);
        return 0;
    }
#endif
    if (!check) printf(" 3. The test point approaches the origin\n");
    approach(24, !check);
    approach(53, !check);
    if (!check) printf("\n 4. The points are moved along z\n");
    move(24, !check);
    move(53, !check);
    if (!check) return 0;
    test_result("the exact sign is right at every step", faults[0]);
    test_result("what the bound decides is right", faults[1]);
    test_result("Householder: 0 below half a last place of p1", faults[2]);
    test_result("determinants: right at every distance", faults[3]);
    test_result("exact: inside at every distance", faults[4]);
    test_result("Householder: zero divide where all points are in one plane",
                faults[5]);
    test_result("Householder: right with 10 bits to spare", faults[6]);
    test_result("determinants: wrong where 10^(3k) is 2^bits", faults[7]);
    return test_end();
}
