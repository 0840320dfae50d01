/* points.c - families of test points; see points.h. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "points.h"

#define PI 3.14159265358979323846

/* ---- random numbers ---- */

#define MASK 0xffffffffUL

/* Counter mode: a hash of seed + 1, seed + 2, ... */
static unsigned long bits(unsigned long *state)
{
    unsigned long z;

    *state = (*state + 0x9e3779b9UL) & MASK;
    z = *state;
    z = ((z ^ (z >> 16)) * 0x85ebca6bUL) & MASK;
    z = ((z ^ (z >> 13)) * 0xc2b2ae35UL) & MASK;
    return z ^ (z >> 16);
}

/* All 53 bits in [0,1); nothing here is rounded. */
static double unit(unsigned long *state)
{
    double high = (double)(bits(state) >> 5);

    return (high * 67108864.0 + (double)(bits(state) >> 6))
        / 9007199254740992.0;
}

static long below(unsigned long *state, long m)
{
    return (long)(bits(state) % (unsigned long)m);
}

/* A product that no compiler merges with an addition. */
static double product(double a, double b)
{
    volatile double c = a * b;

    return c;
}

/* A quotient rounded to double, which no compiler takes for a product. */
static double quotient(double a, double b)
{
    volatile double c = b;

    c = a / c;
    return c;
}

static void put(double *p, double x, double y, double z)
{
    p[0] = x;
    p[1] = y;
    p[2] = z;
}

static void shuffle(unsigned long *state, long n, double *p)
{
    long i, j, k;
    double swap;

    for (i = n - 1; i > 0; i--) {
        j = below(state, i + 1);
        for (k = 0; k < 3; k++) {
            swap = p[3 * i + k];
            p[3 * i + k] = p[3 * j + k];
            p[3 * j + k] = swap;
        }
    }
}

static void scale(long n, double *p, double x, double y, double z)
{
    long i;

    for (i = 0; i < n; i++)
        put(p + 3 * i, p[3 * i] * x, p[3 * i + 1] * y, p[3 * i + 2] * z);
}

static void shift(long n, double *p, double x, double y, double z)
{
    long i;

    for (i = 0; i < n; i++)
        put(p + 3 * i, p[3 * i] + x, p[3 * i + 1] + y, p[3 * i + 2] + z);
}

/* Turn points by 0.7 about the z axis, then by 0.4 about the x axis; and move
 * them off the origin. */
static void turn(long n, double *p)
{
    double c = cos(0.7), s = sin(0.7), d = cos(0.4), t = sin(0.4), x, y, z;
    long i;

    for (i = 0; i < n; i++) {
        x = product(c, p[3 * i]) - product(s, p[3 * i + 1]);
        y = product(s, p[3 * i]) + product(c, p[3 * i + 1]);
        z = p[3 * i + 2];
        put(p + 3 * i, x, product(d, y) - product(t, z),
            product(t, y) + product(d, z));
    }
    shift(n, p, 1.0, 2.0, 3.0);
}

/* The largest k with k^power <= n, power 2 or 3. */
static long root(long n, int power)
{
    long k = 0;

    while (power == 2 ? k + 1 <= n / (k + 1)
                      : k + 1 <= n / (k + 1) / (k + 1))
        k++;
    return k;
}

/* ---- volumes ---- */

static long uniform(long n, unsigned long *state, double *p)
{
    long i;

    for (i = 0; i < 3 * n; i++)
        p[i] = unit(state);
    return n;
}

static long ball(long n, unsigned long *state, double *p)
{
    long i, k;

    for (i = 0; i < n; i++)
        do
            for (k = 0; k < 3; k++)
                p[3 * i + k] = 2 * unit(state) - 1;
        while (p[3 * i] * p[3 * i] + p[3 * i + 1] * p[3 * i + 1]
                   + p[3 * i + 2] * p[3 * i + 2] > 1);
    return n;
}

/* The sum of twelve uniform numbers is near enough to a gaussian one, and is
 * the same everywhere, which logarithms are not. */
static long clusters(long n, unsigned long *state, double *p)
{
    double centre[3 * 50], sum;
    long i;
    int k;

    uniform(50, state, centre);
    for (i = 0; i < 3 * n; i++) {
        sum = -6 * 4294967296.0;
        for (k = 0; k < 12; k++)
            sum += (double)bits(state);
        p[i] = centre[i % 150] + sum / 64 / 4294967296.0;
    }
    return n;
}

static long decimal3(long n, unsigned long *state, double *p)
{
    long edge, i;

    edge = root(10 * n, 3) + 1;
    for (i = 0; i < 3 * n; i++)
        p[i] = quotient((double)below(state, 1000 * edge), 1000.0);
    return n;
}

static long twoscale(long n, unsigned long *state, double *p)
{
    long i;

    uniform(n, state, p);
    for (i = 0; i < 3 * n; i++)
        if (i / 3 % 2 == 1)
            p[i] = 0.5 + (p[i] - 0.5) / 1024;
    return n;
}

/* Flat: so high. */
static long flat(long n, unsigned long *state, double high, double *p)
{
    uniform(n, state, p);
    scale(n, p, 1.0, 1.0, high);
    return n;
}

/* ---- lattices ---- */

/* Copies of a cubic lattice of edge k, displaced by halves. */
static long cubic(long n, long copies, const double *half, double *p)
{
    long c, i, k, x, y, z;

    k = root(n / copies, 3);
    i = 0;
    for (x = 0; x < k; x++)
        for (y = 0; y < k; y++)
            for (z = 0; z < k; z++)
                for (c = 0; c < copies; c++, i++)
                    put(p + 3 * i, (double)x + half[3 * c],
                        (double)y + half[3 * c + 1],
                        (double)z + half[3 * c + 2]);
    return i;
}

static const double halves[18] = {
    0.0, 0.0, 0.0,  0.5, 0.5, 0.5,
    0.0, 0.0, 0.0,  0.5, 0.5, 0.0,  0.5, 0.0, 0.5,  0.0, 0.5, 0.5
};

static long lattice(long n, unsigned long *state, double *p)
{
    (void)state;
    return cubic(n, 1, halves, p);
}

static long bcc(long n, unsigned long *state, double *p)
{
    (void)state;
    return cubic(n, 2, halves, p);
}

static long fcc(long n, unsigned long *state, double *p)
{
    (void)state;
    return cubic(n, 4, halves + 6, p);
}

static long lattice01(long n, unsigned long *state, double *p)
{
    n = lattice(n, state, p);
    scale(n, p, 0.1, 0.1, 0.1);
    return n;
}

static long latticeshuf(long n, unsigned long *state, double *p)
{
    n = lattice(n, state, p);
    shuffle(state, n, p);
    return n;
}

static long jitlattice(long n, unsigned long *state, double *p)
{
    long i;

    n = lattice(n, state, p);
    for (i = 0; i < 3 * n; i++)
        p[i] += (double)(bits(state) >> 16) / 562949953421312.0;
    return n;
}

static long grid11eps(long n, unsigned long *state, double *p)
{
    long i, k;

    n = lattice(n, state, p);
    k = root(n, 3);
    for (i = 0; k > 1 && i < 3 * n; i++) {
        p[i] = quotient(p[i], (double)(k - 1));
        if (below(state, 10) == 0)
            p[i] += 1.0 / 4503599627370496.0;
    }
    return n;
}

/* Places of a lattice of 17^3 points that are 2^-50 apart, four last places,
 * beside (1,1,1), drawn at random; and the origin, so that nothing can be
 * subtracted first. */
static long lastplaces(long n, unsigned long *state, double *p)
{
    long i, k;

    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++)
            p[3 * i + k] = i == 0 ? 0.0
                : 1.0 + (double)below(state, 17) / 1125899906842624.0;
    return n;
}

/* ---- surfaces ---- */

/* A random direction in the first dim coordinates.  The integers are small
 * enough for the sum of squares to be exact. */
static void direction(unsigned long *state, int dim, double *p)
{
    double square;
    int k;

    do {
        square = 0;
        for (k = 0; k < dim; k++) {
            p[k] = (double)(bits(state) >> 8) - 8388607.5;
            square += p[k] * p[k];
        }
    } while (square > 8388608.0 * 8388608.0);
    square = sqrt(square);
    for (k = 0; k < dim; k++)
        p[k] /= square;
}

static long spherenorm(long n, unsigned long *state, double *p)
{
    long i;

    for (i = 0; i < n; i++)
        direction(state, 3, p + 3 * i);
    return n;
}

/* Directions times a radius that is wrong by up to jitter. */
static long jitter(long n, unsigned long *state, double most, double *p)
{
    double radius;
    long i;

    for (i = 0; i < n; i++) {
        direction(state, 3, p + 3 * i);
        radius = 1 + product(most, 2 * unit(state) - 1);
        scale(1L, p + 3 * i, radius, radius, radius);
    }
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

static long ellipsoid(long n, unsigned long *state, double *p)
{
    spherenorm(n, state, p);
    scale(n, p, 1.0, 0.7, 0.4);
    return n;
}

/* How many integer points the sphere of integer radius r has (Hurwitz):
 * 6 times the product, over the odd primes q with q^a the power in r, of
 * s(a) - s(a-1) for q = 1 and s(a) + s(a-1) for q = 3 modulo 4, where
 * s(a) = 1 + q + ... + q^a. */
static double on_sphere(long r)
{
    double count = 6, s, before;
    long q;

    while (r > 0 && r % 2 == 0)
        r /= 2;
    for (q = 3; r > 1; q += 2) {
        if (q * q > r)
            q = r;
        before = 0;
        s = 1;
        while (r % q == 0) {
            r /= q;
            before = s;
            s = s * (double)q + 1;
        }
        if (before > 0)
            count *= q % 4 == 1 ? s - before : s + before;
    }
    return count;
}

/* The points that differ from (x, y, z) by signs and rotation of the
 * coordinates. */
static long signs(double x, double y, double z, double *p)
{
    double c[5];
    long i = 0;
    int k, m;

    put(c, x, y, z);
    c[3] = x;
    c[4] = y;
    for (k = 0; k < 3; k++)
        for (m = 0; m < 8; m++) {
            if (((m & 1) && c[k] == 0) || ((m & 2) && c[k + 1] == 0)
                || ((m & 4) && c[k + 2] == 0))
                continue;
            put(p + 3 * i, m & 1 ? -c[k] : c[k],
                m & 2 ? -c[k + 1] : c[k + 1], m & 4 ? -c[k + 2] : c[k + 2]);
            i++;
        }
    return i;
}

/* Squares are kept in double, where they are exact and cannot overflow. */
static long spherei(long n, unsigned long *state, double *p)
{
    double count, most = 0, square, x, y, z, s;
    long i, r, radius = 0;

    /* an odd r has 6 r points or more; an even one those of its half */
    for (r = 1; r <= n / 6; r += 2) {
        count = on_sphere(r);
        if (count <= (double)n && count > most) {
            most = count;
            radius = r;
        }
    }
    i = 0;
    square = (double)radius * (double)radius;
    for (x = 0; radius > 0 && 3 * x * x < square; x++) {
        z = (double)radius;
        for (y = x; y <= z; y++) {
            s = square - x * x - y * y;
            while (z > y && z * z > s)
                z--;
            if (z * z == s) {
                i += signs(x, y, z, p + 3 * i);
                if (x < y && y < z)
                    i += signs(y, x, z, p + 3 * i);
            }
        }
    }
    shuffle(state, i, p);
    return i;
}

/* Integer points turned by three times a matrix of thirds, and moved: those on
 * one sphere are again, exactly, but on no axis. */
static void thirds(long n, double *p)
{
    double x, y, z;
    long i;

    for (i = 0; i < n; i++) {
        x = p[3 * i];
        y = p[3 * i + 1];
        z = p[3 * i + 2];
        put(p + 3 * i, 2 * x - y + 2 * z + 1000, 2 * x + 2 * y - z - 200,
            2 * y + 2 * z - x + 30);
    }
}

/* All integer points from a sphere with many of them, of square, to a
 * little beyond; how many, or with p those. */
static long shell(long square, double *p)
{
    double x, y, z, r = 0, s;
    long i = 0;

    while (r * r < (double)square)
        r++;
    r++;
    for (x = -r; x <= r; x++)
        for (y = -r; y <= r; y++)
            for (z = -r; z <= r; z++) {
                s = x * x + y * y + z * z;
                if (s < (double)square || s > r * r)
                    continue;
                if (p)
                    put(p + 3 * i, x, y, z);
                i++;
            }
    return i;
}

static long cavityi(long n, unsigned long *state, double *p)
{
    static const long square[] = {161, 89, 41, 17, 9, 5, 1};
    size_t k = 0;
    long count;

    while (k + 1 < sizeof square / sizeof square[0] && shell(square[k], 0) > n)
        k++;
    if (shell(square[k], 0) > n)
        return 0;
    count = shell(square[k], p);
    shuffle(state, count, p);
    thirds(count, p);
    return count;
}

static long fccturn(long n, unsigned long *state, double *p)
{
    n = fcc(n, state, p);
    scale(n, p, 2, 2, 2);
    shuffle(state, n, p);
    thirds(n, p);
    return n;
}

static long spiral(long n, unsigned long *state, double *p)
{
    double angle, radius, z;
    long i;

    (void)state;
    for (i = 0; i < n; i++) {
        z = (double)(2 * i + 1 - n) / (double)n;
        radius = sqrt(1 - product(z, z));
        angle = PI * (3 - sqrt(5.0)) * (double)i;
        put(p + 3 * i, radius * cos(angle), radius * sin(angle), z);
    }
    return n;
}

static long cylinder(long n, unsigned long *state, double *p)
{
    double angle;
    long i, k, m;

    (void)state;
    k = root(n, 2);
    m = k > 0 ? n / k : 0;
    for (i = 0; i < k * m; i++) {
        angle = 2 * PI * (double)(i % k) / (double)k;
        put(p + 3 * i, cos(angle), sin(angle),
            6 * (double)(i / k) / (double)m);
    }
    return k * m;
}

static long cylinderrnd(long n, unsigned long *state, double *p)
{
    long i;

    for (i = 0; i < n; i++) {
        direction(state, 2, p + 3 * i);
        p[3 * i + 2] = 6 * unit(state);
    }
    return n;
}

static long prism(long n, unsigned long *state, double *p)
{
    double angle;
    long i;

    (void)state;
    n -= n % 2;
    for (i = 0; i < n; i++) {
        angle = 2 * PI * (double)(i / 2) / (double)(n / 2);
        put(p + 3 * i, cos(angle), sin(angle), (double)(i % 2));
    }
    return n;
}

static long cubesurf(long n, unsigned long *state, double *p)
{
    long face, i;

    uniform(n, state, p);
    for (i = 0; i < n; i++) {
        face = below(state, 6);
        p[3 * i + face / 2] = (double)(face % 2);
    }
    return n;
}

/* The rotation is that of the quaternion 1, 2, 3, 4. */
static long rotcube(long n, unsigned long *state, double *p)
{
    static const double turn[9] = {
        -20, 4, 22,  20, -10, 20,  10, 28, 4
    };
    double q[3];
    long i;
    int k;

    cubesurf(n, state, p);
    for (i = 0; i < n; i++) {
        for (k = 0; k < 3; k++)
            q[k] = product(turn[3 * k] / 30, p[3 * i])
                + product(turn[3 * k + 1] / 30, p[3 * i + 1])
                + product(turn[3 * k + 2] / 30, p[3 * i + 2]);
        put(p + 3 * i, q[0], q[1], q[2]);
    }
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

static long paraboloid(long n, unsigned long *state, double *p)
{
    double x, y;
    long i, k;

    (void)state;
    k = root(n, 2);
    for (i = 0; i < k * k; i++) {
        x = (double)(i % k - k / 2);
        y = (double)(i / k - k / 2);
        put(p + 3 * i, x, y, x * x + y * y);
    }
    return k * k;
}

static long planeone(long n, unsigned long *state, double *p)
{
    long i, k;

    (void)state;
    k = root(n - 1, 2);
    for (i = 0; i < k * k; i++)
        put(p + 3 * i, (double)(i % k), (double)(i / k), 0.0);
    put(p + 3 * i, (double)(k / 2), (double)(k / 2), 1.0);
    return k * k + 1;
}

static long planespread(long n, unsigned long *state, double *p)
{
    flat(n, state, 0.0, p);
    p[3 * n - 1] = 1;
    return n;
}

#include "measured.h"

/* ---- curves ---- */

static long helix(long n, unsigned long *state, double *p)
{
    double t;
    long i;

    (void)state;
    for (i = 0; i < n; i++) {
        t = 40 * PI * (double)i / (double)n;
        put(p + 3 * i, cos(t), sin(t), t);
    }
    return n;
}

static long moment(long n, unsigned long *state, double *p)
{
    double t, top = 1;
    long i;

    (void)state;
    while (top < (double)n)
        top *= 2;
    for (i = 0; i < n; i++) {
        t = (double)(i + 1) / top;
        put(p + 3 * i, t, t * t, t * t * t);
    }
    return n;
}

static long twolines(long n, unsigned long *state, double *p)
{
    long i;
    double x;

    (void)state;
    for (i = 0; i < n; i++) {
        x = (double)(i / 2 - n / 4);
        if (i % 2 == 0)
            put(p + 3 * i, x, 0.0, 0.0);
        else
            put(p + 3 * i, 0.0, x, 1.0);
    }
    return n;
}

/* ---- coincidences and extremes ---- */

static long duplicates(long n, unsigned long *state, double *p)
{
    const double *q;
    long distinct, i;

    distinct = (n + 2) / 3;
    uniform(distinct, state, p);
    for (i = distinct; i < n; i++) {
        q = p + 3 * below(state, distinct);
        put(p + 3 * i, q[0], q[1], q[2]);
    }
    shuffle(state, n, p);
    return n;
}

static long pairs(long n, unsigned long *state, double *p)
{
    const double step = 1.0 / 8796093022208.0;
    long i;

    uniform(n, state, p);
    for (i = 0; i + 1 < n; i += 2)
        put(p + 3 * i + 3, p[3 * i] + step, p[3 * i + 1] - step,
            p[3 * i + 2] + step);
    return n;
}

static long farpoint(long n, unsigned long *state, double *p)
{
    uniform(n, state, p);
    put(p + 3 * (n - 1), 1e9, 1e9, 1e9);
    return n;
}

static long offset(long n, unsigned long *state, double *p)
{
    long i;

    for (i = 0; i < 3 * n; i++)
        p[i] = 1e8 + (double)bits(state) / 4294967296.0;
    return n;
}

static long wide(long n, unsigned long *state, double *p)
{
    long exponent, i;

    uniform(n, state, p);
    for (i = 0; i < 3 * n; i++) {
        exponent = below(state, 2001) - 1000;
        p[i] = ldexp(0.5 + p[i] / 2, (int)exponent + 1);
        if (below(state, 2) == 1)
            p[i] = -p[i];
    }
    return n;
}

/* A cube, its edge a power of two. */
static long sized(long n, unsigned long *state, double power, double *p)
{
    double edge = ldexp(1.0, (int)power);

    uniform(n, state, p);
    scale(n, p, edge, edge, edge);
    return n;
}

/* On the unit sphere, at distances of some 2^-k, k = 0 ... 39, from so many
 * spots. */
static long crowded(long n, unsigned long *state, double spots, double *p)
{
    static const double spot[3][3] = {
        { 0.48, 0.6, 0.64 }, { -0.6, 0.64, -0.48 }, { 0.64, -0.48, -0.6 }
    };
    double far, length, *q = p;
    long i;
    int k;

    for (i = 0; i < n; i++, q += 3) {
        direction(state, 3, q);
        far = ldexp(0.5 + unit(state) / 2, -(int)below(state, 40));
        length = 0;
        for (k = 0; k < 3; k++) {
            q[k] = spot[i % (long)spots][k] + far * q[k];
            length += q[k] * q[k];
        }
        length = sqrt(length);
        for (k = 0; k < 3; k++) q[k] /= length;
    }
    return n;
}

/* ---- the table ---- */

#define FAMILY(name, make) { name, 0, make, 0, 0.0 }
#define TURNED(name, make) { name, 1, make, 0, 0.0 }
#define BY(name, by, how) { name, 0, 0, by, how }
#define TURNED_BY(name, by, how) { name, 1, 0, by, how }

static const struct {
    const char *name;
    int turned; /* at last */
    long (*make)(long n, unsigned long *state, double *p);
    long (*by)(long n, unsigned long *state, double how, double *p);
    double how; /* or so, by that */
} family_table[] = {
    FAMILY("uniform", uniform), FAMILY("ball", ball),
    FAMILY("clusters", clusters), FAMILY("decimal3", decimal3),
    FAMILY("twoscale", twoscale), BY("aniso", flat, 1.0 / 1024),
    BY("planenoise", flat, 1.0 / 1048576), FAMILY("lattice", lattice),
    FAMILY("lattice01", lattice01), FAMILY("latticeshuf", latticeshuf),
    FAMILY("jitlattice", jitlattice), FAMILY("grid11eps", grid11eps),
    FAMILY("lastplaces", lastplaces), FAMILY("bcc", bcc), FAMILY("fcc", fcc),
    FAMILY("spherenorm", spherenorm), BY("spherejit", jitter, 1e-6),
    FAMILY("spherei", spherei), FAMILY("cavityi", cavityi),
    FAMILY("fccturn", fccturn), TURNED("ellipsoid", ellipsoid),
    FAMILY("spiral", spiral), FAMILY("cylinder", cylinder),
    TURNED("cylinderrnd", cylinderrnd), FAMILY("prism", prism),
    FAMILY("helix", helix), FAMILY("moment", moment),
    FAMILY("twolines", twolines), FAMILY("planeone", planeone),
    FAMILY("planespread", planespread), FAMILY("paraboloid", paraboloid),
    FAMILY("cubesurf", cubesurf), FAMILY("rotcube", rotcube),
    FAMILY("duplicates", duplicates), FAMILY("pairs", pairs),
    FAMILY("farpoint", farpoint), FAMILY("offset", offset),
    BY("tiny", sized, -200), BY("huge", sized, 200), FAMILY("wide", wide),
    TURNED("gridrot", lattice01), TURNED("gradedrot", gradedrot),
    TURNED("gridsph", gridsph), TURNED("gridcyl", gridcyl),
    TURNED("extruded", extruded), FAMILY("globe", globe), TURNED("cap", cap),
    TURNED("stations", stations), FAMILY("spherefull", spherefull),
    FAMILY("shells", shells), FAMILY("cavity", cavity),
    BY("spherejit4", jitter, 1e-4), TURNED("rotcubein", rotcubein),
    TURNED_BY("rottet", tetrahedral, 0), TURNED("rottetin", rottetin),
    FAMILY("cubegrid", cubegrid), BY("tilted9", tilted, 1e-9),
    BY("tilted15", tilted, 1e-15), TURNED_BY("near6", layered, 1e-6),
    TURNED_BY("near8", layered, 1e-8), FAMILY("slanted", slanted),
    TURNED("cylinderrot", cylinder), TURNED("torus", torus),
    TURNED("sheets", sheets), TURNED_BY("bumps", wavy, 0),
    TURNED_BY("thinshell", wavy, 0.01), TURNED("terrain", terrain),
    TURNED("survey", survey), TURNED("boreholes", boreholes),
    TURNED("tracks", tracks), TURNED("pipes", pipes),
    TURNED("horizons", horizons), TURNED("layers", layers),
    BY("latlon", latitudes, 1), BY("latlonkm", latitudes, 6371),
    BY("latlonm", latitudes, 6378137), BY("uvsphere", uvsphere, 1),
    BY("uvkm", uvsphere, 6371), BY("uvm", uvsphere, 6378137),
    TURNED("rings", rings), FAMILY("hub", hub), TURNED("hubrot", hub),
    FAMILY("sheets16", sheets16), TURNED("sheet16rot", sheets16),
    BY("crowd", crowded, 1), BY("crowd3", crowded, 3),
    BY("pillar6", pillar, 6), BY("pillar12", pillar, 12),
    BY("pillar64", pillar, 64), BY("pillar6turn", pillarturn, 6),
    BY("pillar12turn", pillarturn, 12), BY("masts", masts, 200),
    BY("maststurn", maststurn, 200), FAMILY("towers", towers),
    FAMILY("towersturn", towersturn), FAMILY("sites", sites),
    FAMILY("sitesturn", sitesturn), BY("fillglobe", fillglobe, 1e30),
    BY("fillcurve", fillcurve, 1e30), BY("fillcurve9", fillcurve, -9999),
    BY("filloutlier", filloutlier, 1e30),
    BY("box6", box, 6), BY("plate3", plate, 3), BY("plate6", plate, 6),
    BY("plate17", plate, 17), BY("bracket6", bracket, 6), BY("bar6", bar, 6),
    BY("bearing6", bearing, 6)
};

#define FAMILIES ((int)(sizeof family_table / sizeof family_table[0]))

const char *points_name(int i)
{
    return i >= 0 && i < FAMILIES ? family_table[i].name : 0;
}

/* The first n points of a file. */
static long from_file(const char *name, long n, double *p)
{
    FILE *file = fopen(name, "r");
    char line[400];
    long i = 0;

    if (!file) return 0;
    while (i < n && fgets(line, sizeof line, file))
        if (sscanf(line, "%lf %lf %lf", p + 3 * i, p + 3 * i + 1,
                   p + 3 * i + 2) == 3)
            i++;
    fclose(file);
    return i;
}

long points_make(const char *family, long n, unsigned long seed, double *p)
{
    unsigned long state;
    int i;

    if (strchr(family, '/')) return from_file(family, n, p);
    /* seeds that lie close together must not give shifted sequences */
    state = seed & MASK;
    state = (bits(&state) * 0x2c1b3c6dUL + seed) & MASK;
    for (i = 0; n > 0 && i < FAMILIES; i++)
        if (strcmp(family, family_table[i].name) == 0) {
            n = family_table[i].make
                    ? family_table[i].make(n, &state, p)
                    : family_table[i].by(n, &state, family_table[i].how, p);
            if (family_table[i].turned) turn(n, p);
            return n;
        }
    return 0;
}
