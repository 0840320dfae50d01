/* hard.c - sets of points that are hard to get right; see hard.h. */
#include "hard.h"
#include "exact.h"
#include "../../hhpred.h"

#include <math.h>

#ifdef TESS_FLOAT
#define MOST_EXP FLT_MAX_EXP
#define LEAST_EXP (FLT_MIN_EXP - FLT_MANT_DIG)
#define BITS FLT_MANT_DIG
#define LARGEST FLT_MAX
#define NORMAL FLT_MIN
#else
#define MOST_EXP DBL_MAX_EXP
#define LEAST_EXP (DBL_MIN_EXP - DBL_MANT_DIG)
#define BITS DBL_MANT_DIG
#define LARGEST DBL_MAX
#define NORMAL DBL_MIN
#endif

typedef double point[3];

/* lo ... hi */
static int draw(int lo, int hi)
{
    return lo + rnd_below(hi - lo + 1);
}

static double sign(void)
{
    return rnd_below(2) ? 1.0 : -1.0;
}

/* An exponent: any, or about where the square, the cube, the fifth power of
 * a coordinate or the library's own bounds underflow. */
static int exponent(void)
{
    static const int edge[] = {
        0, 24, 53, 60, 96, 200, 204, 215, 268, 341, 358, 450, 511, 537, 600, 900,
        1000, 1021, 1022, 1050, 1074
    };
    int e;

    if (rnd_below(3) == 0) return draw(LEAST_EXP, MOST_EXP - 1);
    e = edge[rnd_below((int)(sizeof edge / sizeof *edge))] + draw(-2, 2);
    if (rnd_below(4) > 0) e = -e;
    if (e >= MOST_EXP) e = MOST_EXP - 1;
    return e < LEAST_EXP ? LEAST_EXP : e;
}

double hard_nudge(double x, int places)
{
    int e, power = frexp(fabs(x), &e) == 0.5;

    /* below a power of two the places are half as wide */
    if (power && (x > 0.0) == (places < 0)) e--;
    if (x == 0.0 || e < LEAST_EXP + BITS) e = LEAST_EXP + BITS;
    return x + places * ldexp(1.0, e - BITS);
}

double hard_value(void)
{
    switch (rnd_below(15)) {
    case 0:
        return 0.0;
    case 1:
        return -0.0;
    case 2:
        return sign();
    case 3:
        return sign() * ldexp(draw(1, 15), LEAST_EXP);
    case 4:
        return sign() * ldexp(1.0 + rnd_unit(),
                              draw(LEAST_EXP, LEAST_EXP + BITS));
    case 5:
        return sign() * (rnd_below(2) ? hard_nudge(NORMAL, draw(-3, 3))
                                      : NORMAL * (0.3 + 0.7 * rnd_unit()));
    case 6:
        return sign() * (rnd_below(2) ? LARGEST
                                      : LARGEST * (1.0 - 0.25 * rnd_unit()));
    case 7:
        return sign() * ldexp(1.0, exponent());
    case 8:
        return draw(-5, 5);
    case 9:
        return 0.1 * draw(-9, 9);
    case 10:
        return hard_nudge(sign(), draw(-4, 4));
    case 11:
        return sign() * ldexp(1.0 + rnd_unit(), exponent());
    case 12:
        return sign() * ldexp(draw(1, 9), exponent());
    case 13: /* all binary digits one, or one and then zeros, but the last */
        return sign() * hard_nudge(ldexp(1.0, exponent()), draw(-9, 3));
    default:
        return sign() * rnd_unit();
    }
}

/* An exact rotation it is not: that is the point. */
static void rotate(point *p, int from, int to)
{
    double a = draw(1, 60) * 0.1, x;
    int i, k = rnd_below(3), l = (k + draw(1, 2)) % 3;

    for (i = from; i < to; i++) {
        x = p[i][k];
        p[i][k] = cos(a) * x - sin(a) * p[i][l];
        p[i][l] = sin(a) * x + cos(a) * p[i][l];
    }
}

/* a line or a plane: points a + i u + j v, rounded */
static void linear(point *p, int from, int to, int size, int plane)
{
    double a[3], u[3], v[3];
    int whole = rnd_below(3), i, j, k, l;

    for (k = 0; k < 3; k++) {
        a[k] = whole ? draw(-3, 3) : rnd_unit();
        u[k] = whole ? draw(-3, 3) : rnd_unit() - 0.5;
        v[k] = whole ? draw(-3, 3) : rnd_unit() - 0.5;
    }
    for (i = from; i < to; i++) {
        j = rnd_below(size);
        l = plane ? rnd_below(size) : 0;
        for (k = 0; k < 3; k++) p[i][k] = a[k] + j * u[k] + l * v[k];
    }
    if (rnd_below(2)) return;
    for (i = from; i < to; i++) {
        k = rnd_below(3);
        p[i][k] = hard_nudge(p[i][k], draw(-1, 1));
    }
}

/* Points from ... to-1; lattices of that size. */
static void shape(point *p, int from, int to, int size)
{
    double v[8], r, scale[3];
    int kind = rnd_below(17), m, i, k;
    long square, s;

    for (i = from; i < to; i++)
        for (k = 0; k < 3; k++) p[i][k] = rnd_below(size);
    switch (kind) {
    case 0: /* few values */
        m = draw(2, 6);
        for (i = 0; i < m; i++) v[i] = hard_value();
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++) p[i][k] = v[rnd_below(m)];
        break;
    case 1: /* lattice */
        break;
    case 2: /* lattice turned about two axes */
        rotate(p, from, to);
        rotate(p, from, to);
        break;
    case 3:
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++) p[i][k] *= 0.1;
        break;
    case 4: /* integer sphere */
        m = draw(2, 5);
        square = (long)m * m;
        if (rnd_below(2)) square = m == 2 ? 9 : m == 3 ? 14 : m == 4 ? 26 : 41;
        for (i = from; i < to; i++)
            do {
                s = 0;
                for (k = 0; k < 3; k++) {
                    m = draw(-6, 6);
                    p[i][k] = m;
                    s += (long)m * m;
                }
            } while (s != square);
        break;
    case 5: /* thin layers */
        r = rnd_below(2) ? 1e-13 : ldexp(1.0, exponent());
        for (i = from; i < to; i++)
            p[i][2] = rnd_below(2) + r * (rnd_below(2) ? draw(-2, 2)
                                                       : rnd_unit());
        break;
    case 6:
    case 7:
        i = (from + to) / 2;
        m = rnd_below(2);
        linear(p, from, i, 2 * size, m);
        linear(p, i, to, 2 * size, kind == 6 ? m : 1);
        break;
    case 8: /* some last places off a point that is not the origin */
        for (k = 0; k < 3; k++) v[k] = rnd_below(2) ? 1.0 : rnd_unit();
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = hard_nudge(v[k], (int)p[i][k]);
        break;
    case 9: /* any exponents */
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = sign() * ldexp(1.0, draw(LEAST_EXP, MOST_EXP - 1));
        break;
    case 10: /* large and small together */
        r = ldexp(1.0, exponent());
        for (i = from; i < to; i++)
            if (rnd_below(2))
                for (k = 0; k < 3; k++) p[i][k] *= r;
        break;
    case 11: /* axes of different units */
        for (k = 0; k < 3; k++) scale[k] = ldexp(1.0, exponent());
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++) p[i][k] *= scale[k];
        break;
    case 12: /* about a sphere, and its centre */
        for (i = from; i < to; i++) {
            do {
                r = 0.0;
                for (k = 0; k < 3; k++) {
                    p[i][k] = 2.0 * rnd_unit() - 1.0;
                    r += p[i][k] * p[i][k];
                }
            } while (r < 0.01);
            r = rnd_below(6) ? sqrt(r) : LARGEST;
            for (k = 0; k < 3; k++) p[i][k] /= r;
        }
        break;
    case 13:
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++) p[i][k] = rnd_unit();
        break;
    case 14: /* subnormals, and some that are not */
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++)
                if (rnd_below(8)) p[i][k] = ldexp(p[i][k], LEAST_EXP);
        break;
    case 15: /* as limbs, of exact numbers that begin at the largest, end */
        m = draw(-60, 0);
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++)
                p[i][k] = rnd_below(4)
                              ? sign() * hard_nudge(ldexp(1.0, m - HH_BITS *
                                                          rnd_below(3)),
                                                    draw(-7, 2))
                              : rnd_below(2) ? ldexp(0.75, m + HH_BITS - 1)
                                             : 0.0;
        break;
    default:
        for (i = from; i < to; i++)
            for (k = 0; k < 3; k++) p[i][k] = hard_value();
        break;
    }
}

/* All coordinates finite tess_reals. */
static void confine(point *p, int n)
{
    volatile tess_real rounded;
    int i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            /* a NaN, of infinity less infinity, fails the comparison */
            if (!(p[i][k] >= -LARGEST && p[i][k] <= LARGEST))
                p[i][k] = p[i][k] > 0.0 ? LARGEST : -LARGEST;
            rounded = (tess_real)p[i][k];
            p[i][k] = (double)rounded;
        }
}

/* Coordinate k times 2^e. */
static void stretch(point *p, int from, int to, int k, int e)
{
    int i;

    for (i = from; i < to; i++) p[i][k] = ldexp(p[i][k], e);
}

/* Numbers that stand for none in coordinates of some points: one or two, along
 * an axis or all, of points together or one by one. */
static void absent(point *p, int n)
{
    static const double none[] = {
        -3.4028234663852886e38, 9.969209968386869e36, -1e30, -1e20, 1e12, -9999.0
    };
    double x[2];
    int axis = draw(0, 3), one = draw(2, 12), together = rnd_below(2), i, k;

    for (i = 0; i < 2; i++)
        x[i] = rnd_below(6) ? none[rnd_below((int)(sizeof none / sizeof *none))]
                            : sign() * ldexp(1.0, exponent());
    for (i = 0; i < n; i++)
        for (k = 0; k < 3 && (!together || i % one == 0); k++)
            if ((axis == k || axis == 3) && (together || rnd_below(one) == 0))
                p[i][k] = x[rnd_below(2)];
}

static void change(point *p, int n)
{
    double x;
    int i, j, k, e;

    if (n == 0) return;
    if (rnd_below(5) == 0)
        for (j = draw(1, 3); j > 0; j--) {
            i = rnd_below(n);
            e = rnd_below(n);
            for (k = 0; k < 3; k++) p[i][k] = p[e][k];
        }
    if (rnd_below(4) == 0)
        for (i = 0; i < n; i++) {
            k = rnd_below(3);
            p[i][k] = hard_nudge(p[i][k], draw(-2, 2));
        }
    if (rnd_below(4) == 0)
        for (j = draw(1, 3); j > 0; j--)
            p[rnd_below(n)][rnd_below(3)] = hard_value();
    if (rnd_below(8) == 0) {
        for (k = 0; k < 3; k++) {
            x = hard_value();
            for (i = 0; i < n; i++) p[i][k] += x;
        }
    }
    if (rnd_below(4) == 0) {
        e = exponent();
        for (k = 0; k < 3; k++) stretch(p, 0, n, k, e);
    }
    if (rnd_below(6) == 0) stretch(p, 0, n, rnd_below(3), exponent());
    if (rnd_below(3) == 0) {
        j = rnd_below(3);
        k = rnd_below(3);
        for (i = 0; i < n; i++) {
            x = p[i][j];
            p[i][j] = -p[i][k];
            p[i][k] = x;
        }
    }
    if (rnd_below(6) == 0) absent(p, n);
    rnd_mix(p, n);
}

int hard_few(double (*p)[3])
{
    int r = rnd_below(20), n, size = draw(2, 4);

    /* the definition takes n^5 steps: a few larger sets are enough */
    n = r == 0 ? draw(0, 4) : r < 14 ? draw(4, 7) : r < 19 ? draw(7, 9)
                                                           : draw(10, 11);
    shape(p, 0, n, size);
    if (rnd_below(3) == 0) shape(p, n / 2, n, size);
    confine(p, n);
    change(p, n);
    confine(p, n);
    return n;
}

int hard_many(double (*p)[3], int most)
{
    double x[3];
    int n = draw(60, most), parts = draw(1, 4), part, from, to = 0, i, k, e;
    int size = 2;

    while (size * size * size < n) size++;
    for (part = 0; part < parts; part++) {
        from = to;
        to = part == parts - 1 ? n : from + rnd_below(n - from + 1);
        shape(p, from, to, size + draw(-1, 2));
        confine(p, n);
        e = rnd_below(3) ? exponent() : 0;
        for (k = 0; k < 3; k++) stretch(p, from, to, k, e);
        if (rnd_below(4) == 0) stretch(p, from, to, rnd_below(3), exponent());
        if (rnd_below(2)) {
            /* away from the origin by about its size, or by anything */
            for (k = 0; k < 3; k++)
                x[k] = rnd_below(2) ? ldexp(draw(-9, 9), e) : hard_value();
            if (rnd_below(2))
                for (i = from; i < to; i++)
                    for (k = 0; k < 3; k++) p[i][k] += x[k];
            else
                for (i = from; i < to; i++) p[i][0] += x[0];
        }
    }
    confine(p, n);
    change(p, n);
    confine(p, n);
    return n;
}

/* ---- near planes and spheres ---- */

/* Off by nothing, or by about 10^-16 ... 10^-8, of some points by more. */
static double off(int noise)
{
    if (rnd_below(24) == 0) noise = draw(1, 16);
    return noise == 0 ? 0.0 : (2.0 * rnd_unit() - 1.0) * pow(10.0, -noise);
}

/* Points about a plane or a sphere of size 1, through the origin or about it:
 * on rings, rows or a grid of that size, at random, in a small part of it. */
static void surface(point *p, int from, int to, int size, int noise)
{
    double x, y, r, part = rnd_below(4) ? 1.0 : 0.02;
    int round = rnd_below(2), kind = rnd_below(4), i;

    for (i = from; i < to; i++) {
        x = kind > 1 ? 2.0 * rnd_unit() - 1.0
                     : draw(-size, size) / (size + (round ? 0.5 : 0.0));
        y = kind > 2 ? 2.0 * rnd_unit() - 1.0
                     : draw(-size, size) / (double)size;
        x *= part;
        y *= part;
        r = 1.0 + off(noise);
        if (round) {
            p[i][0] = r * sqrt(1.0 - x * x) * cos(3.14159265358979 * y);
            p[i][1] = r * sqrt(1.0 - x * x) * sin(3.14159265358979 * y);
            p[i][2] = r * x;
        } else {
            p[i][0] = x;
            p[i][1] = y;
            p[i][2] = r - 1.0;
        }
    }
}

/* Integer points of a plane or a sphere: exact ties. */
static void whole(point *p, int from, int to, int size)
{
    static const int leg[][3] = {
        {0, 0, 15}, {0, 9, 12}, {2, 5, 14}, {2, 10, 11}, {5, 10, 10},
        {9, 12, 0}, {10, 2, 11}, {14, 5, 2}
    };
    int round = rnd_below(2), a = draw(-3, 3), b = draw(-3, 3), i, j, k;

    for (i = from; i < to; i++) {
        j = rnd_below((int)(sizeof leg / sizeof *leg));
        for (k = 0; k < 3; k++)
            p[i][k] = round ? sign() * leg[j][k] : draw(-size, size);
        if (!round) p[i][2] = a * p[i][0] + b * p[i][1];
    }
}

/* Points on others but for last places, alone, in rows between two of them, or
 * in a cluster about one. */
static void coincide(point *p, int n)
{
    int many = draw(1, n / 3 + 1), kind = rnd_below(3), i, j, l, k;
    int centre = rnd_below(n), end = rnd_below(n);
    double t;

    while (many-- > 0) {
        i = rnd_below(n);
        j = kind == 0 ? rnd_below(n) : centre;
        l = draw(0, 8);
        t = l / 8.0;
        for (k = 0; k < 3; k++) {
            p[i][k] = kind == 1 ? p[j][k] + t * (p[end][k] - p[j][k]) : p[j][k];
            p[i][k] = hard_nudge(p[i][k], kind == 2 ? draw(-5, 5)
                                                    : draw(-1, 1));
        }
    }
}

int hard_lines(double (*p)[3], int most, int *line)
{
    int lines = draw(11, 14), i;
    double x = 0.0, y = 0.0, z = 0.0, step = 0.0;

    *line = draw((500 + lines - 1) / lines, most / lines);
    for (i = 0; i < lines * *line; i++) {
        if (i % *line == 0) {
            x = 0.02 * rnd_unit() + (i / *line == lines - 1 ? 1.5 : 0.0);
            y = 0.02 * rnd_unit();
            z = 0.3 * rnd_unit();
            step = (0.5 + rnd_unit()) / *line;
        }
        p[i][0] = x;
        p[i][1] = y;
        p[i][2] = z + step * (i % *line);
    }
    return i;
}

int hard_faces(double (*p)[3], int most)
{
    double face[12][3], d[3], side, r, inside = rnd_below(3) ? 0.0 : 0.1;
    double power = pow(10.0, draw(1, 9)), size = pow(10.0, draw(-1, 2));
    int n = draw(12, most), faces = draw(6, 12), i, j, k;

    /* a box, or what other planes leave of it; the origin is inside */
    for (j = 0; j < faces; j++)
        for (k = 0; k < 3; k++)
            face[j][k] = j >= 6 ? 1.2 * (2.0 * rnd_unit() - 1.0)
                : j % 3 == k    ? (j < 3 ? 0.2 : -0.2) * draw(1, 9)
                                : 0.0;
    for (i = 0; i < n; i++) {
        r = 0.0;
        while (r < 1e-3) { /* how far to the first face in a direction */
            r = 0.0;
            for (k = 0; k < 3; k++) d[k] = 2.0 * rnd_unit() - 1.0;
            for (j = 0; j < faces; j++) {
                side = 0.0;
                for (k = 0; k < 3; k++) side += face[j][k] * d[k];
                if (side > r) r = side;
            }
        }
        if (rnd_unit() < inside) r /= rnd_unit();
        for (k = 0; k < 3; k++) p[i][k] = size * d[k] / r;
    }
    rotate(p, 0, n);
    rotate(p, 0, n);
    for (k = 0; k < 3; k++) {
        r = size * draw(-3, 3);
        for (i = 0; i < n; i++) p[i][k] += r;
        for (i = 0; i < n && power < 1e9; i++)
            p[i][k] = floor(power * p[i][k] + 0.5) / power;
    }
    confine(p, n);
    if (rnd_below(4) == 0) coincide(p, n);
    if (rnd_below(6) == 0) stretch(p, 0, n, rnd_below(3), draw(-30, 30));
    confine(p, n);
    rnd_mix(p, n);
    return n;
}

int hard_near(double (*p)[3], int most)
{
    int n = draw(12, rnd_below(2) && most > 48 ? 48 : most);
    int parts = draw(1, 3), noise = draw(0, 3), size = 2, part, from, to = 0;
    int all = rnd_below(2), exact = rnd_below(6) == 0, loose = n / draw(4, 20);
    int i, k, e;
    double x[3], r;

    while (size * size < n) size++;
    noise = noise == 0 ? 0 : noise == 1 ? 16 : noise == 2 ? 12 : 8;
    for (part = 0; part < parts; part++) {
        from = to;
        to = part == parts - 1 ? n - loose : from + (n - loose) / parts;
        if (exact) {
            whole(p, from, to, size);
            for (k = 0; k < 3; k++) {
                x[k] = draw(-size, size);
                for (i = from; i < to; i++) p[i][k] += x[k];
            }
            continue;
        }
        if (!all) noise = rnd_below(4) ? draw(8, 16) : 0;
        surface(p, from, to, size, noise);
        rotate(p, from, to);
        rotate(p, from, to);
        /* faces of one body, concentric shells, or anywhere */
        r = rnd_below(3) ? 1.0 : 0.1 + 2.0 * rnd_unit();
        for (k = 0; k < 3; k++) {
            x[k] = rnd_below(2) ? 0.0 : 2.0 * rnd_unit() - 1.0;
            for (i = from; i < to; i++) p[i][k] = r * p[i][k] + x[k];
        }
    }
    for (i = to; i < n; i++)
        for (k = 0; k < 3; k++) p[i][k] = 4.0 * rnd_unit() - 2.0;
    if (rnd_below(2)) {
        r = pow(10.0, draw(-1, 7));
        for (k = 0; k < 3; k++) {
            x[k] = exact ? floor(r * rnd_unit()) : r * rnd_unit();
            for (i = 0; i < n; i++) p[i][k] += x[k];
        }
    }
    confine(p, n);
    if (rnd_below(6) == 0) absent(p, n);
    if (rnd_below(3) == 0) coincide(p, n);
    if (rnd_below(3) == 0) {
        e = sizeof(tess_real) < sizeof(double) ? draw(-100, 100)
                                               : draw(-996, 970);
        for (k = 0; k < 3; k++) stretch(p, 0, n, k, e);
    }
    confine(p, n);
    rnd_mix(p, n);
    return n;
}
