/* five.c - see five.h. */
#include "five.h"
#include "../../lib/exact.h"

#include <math.h>
#include <stdio.h>

tess_real R[5][3];
double P[5][3];

void settle(double p[5][3])
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

void show(int n)
{
    int i;

    for (i = 0; i < n; i++)
        printf("#     %.17g %.17g %.17g\n", P[i][0], P[i][1], P[i][2]);
}

double nudge(double x, int k)
{
    int e;

    if (x == 0.0) return (tess_real)k * REAL_EPS;
    frexp(x, &e);
    return x + k * ldexp(REAL_EPS, e - 1);
}

double sym(void) { return 2.0 * rnd_unit() - 1.0; }

double dyadic(int bits)
{
    return ldexp(floor(ldexp(sym(), bits)), -bits);
}

double mixed(int span)
{
    return ldexp(sym(), rnd_below(2 * span + 1) - span);
}

/* the integer points of x^2 + y^2 + z^2 = 1025, at most 33 each */
static int sphere[2000][3], spheres;

void find_sphere(void)
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

const char *const names[CLASSES] = {
    "random", "lattice {0..3}", "integers below 2^20", "tenths",
    "coplanar but for a last place", "cospherical but for a last place",
    "normalized onto a sphere", "pairs 1e-13 apart", "offset 1e8",
    "scales 1e+-60 1e+-150 1e+-300", "mixed exponents, all the range",
    "subnormal", "extreme values", "a tiny cluster and a far point",
    "integers, coplanar but for 1", "integers, cospherical but for 1",
    "cospherical but for any bit", "corners of wide boxes but for a last place"
};

void make(int group, double p[5][3])
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
                if (j == 6 && !test_flushes())
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

int low_of(int n)
{
    int low = EX_NO_LOW, i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) low = ex_low(P[i][k], low);
    return low;
}

int five_main(int argc, char **argv, void (*all)(void), long *percent)
{
    static const char usage[] = "[percent [seed]]";
    long seed = 1;

    if (argc > 3) test_usage(argv[0], usage);
    if (argc > 1) *percent = test_number(argv[1], 1, argv, usage);
    if (argc > 2) seed = test_number(argv[2], 0, argv, usage);
    rnd_seed((unsigned long)seed);
    find_sphere();
    test_modes(all);
    return test_end();
}
