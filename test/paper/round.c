/* round.c - arithmetic of 24 or 53 bits; see round.h. */
#include "round.h"

#include <math.h>

#ifdef PLAIN
/* as the compiler likes it: for the timings */
#define ra_add(a, b) ((a) + (b))
#define ra_sub(a, b) ((a) - (b))
#define ra_mul(a, b) ((a) * (b))
#define ra_div(a, b) ((a) / (b))
#define ra_root(a) sqrt(a)
#else
static int single;

void ra_bits(int bits) { single = bits == 24; }

double ra_keep(double x)
{
    volatile float s;
    volatile double d;

    if (single) {
        s = (float)x;
        return (double)s;
    }
    d = x;
    return d;
}

double ra_add(double a, double b) { return ra_keep(a + b); }

double ra_sub(double a, double b) { return ra_keep(a - b); }

double ra_mul(double a, double b) { return ra_keep(a * b); }

double ra_div(double a, double b) { return ra_keep(a / b); }

double ra_root(double a) { return ra_keep(sqrt(a)); }
#endif

double ra_dot(const double *a, const double *b)
{
    return ra_add(ra_add(ra_mul(a[0], b[0]), ra_mul(a[1], b[1])),
                  ra_mul(a[2], b[2]));
}

/* a - t b */
static double less(double a, double t, double b)
{
    return ra_sub(a, ra_mul(t, b));
}

/* A frame h: the reflectors I - b u u', u1 0-2, b1 3, u2 4-5, b2 6 (u2 acts
 * on rows 2, 3), r11 7, r12 8, r22 9, and the column of u2 10-11. */
#define FRAME 12

/* reflector - the norm r and b of the reflector that takes a vector of first
 * component first to a multiple of e1; 1 for a zero divide. */
static int reflector(double first, double norm, double *r, double *b)
{
    double t = ra_mul(norm, ra_add(norm, first > 0.0 ? first : -first));

    *r = first > 0.0 ? -norm : norm;
    *b = 0.0;
    if (t == 0.0) return 1;
    *b = ra_div(1.0, t);
    return 0;
}

/* house - the reflectors and R of [a b]; 1 for a zero divide. */
static int house(const double *a, const double *b, double *h)
{
    double t, q[3];
    int zero, k;

    zero = reflector(a[0], ra_root(ra_dot(a, a)), &h[7], &h[3]);
    h[0] = ra_sub(a[0], h[7]);
    h[1] = a[1];
    h[2] = a[2];
    t = ra_mul(h[3], ra_dot(h, b));
    for (k = 0; k < 3; k++) q[k] = less(b[k], t, h[k]);
    h[8] = q[0];
    h[10] = q[1];
    h[11] = q[2];
    t = ra_root(ra_add(ra_mul(q[1], q[1]), ra_mul(q[2], q[2])));
    if (reflector(q[1], t, &h[9], &h[6])) zero = 1;
    h[4] = ra_sub(q[1], h[9]);
    h[5] = q[2];
    return zero;
}

/* apply - z = Q1 Q2 (y1, y2, y3). */
static void apply(const double *h, double y1, double y2, double y3, double *z)
{
    double t, y[3];
    int k;

    t = ra_mul(h[6], ra_add(ra_mul(h[4], y2), ra_mul(h[5], y3)));
    y[0] = y1;
    y[1] = less(y2, t, h[4]);
    y[2] = less(y3, t, h[5]);
    t = ra_mul(h[3], ra_dot(h, y));
    for (k = 0; k < 3; k++) z[k] = less(y[k], t, h[k]);
}

int ra_facet(const double *p1, const double *p2, const double *p3, double *f)
{
    double a[3], b[3], h[FRAME], y1, y2;
    int zero, k;

    for (k = 0; k < 3; k++) {
        a[k] = ra_sub(p2[k], p1[k]);
        b[k] = ra_sub(p3[k], p1[k]);
        f[6 + k] = p1[k];
    }
    zero = house(a, b, h);
    apply(h, 0.0, 0.0, (h[7] < 0.0) == (h[9] < 0.0) ? 1.0 : -1.0, f);
    f[9] = h[10];
    f[10] = h[11];
    f[11] = h[7];
    f[12] = h[9];
    f[3] = f[4] = f[5] = 0.0;
    if (zero) return 1;
    y1 = ra_mul(0.5, h[7]);
    y2 = ra_mul(0.5, ra_add(h[9], ra_mul(ra_div(h[8], h[9]),
                                        ra_sub(h[8], h[7]))));
    apply(h, y1, y2, 0.0, f + 3);
    return 0;
}

double ra_side(const double *f, const double *z)
{
    double w[3];
    int k;

    for (k = 0; k < 3; k++) w[k] = ra_sub(z[k], f[6 + k]);
    return ra_dot(f, w);
}

int ra_lcoord(const double *f, const double *z, double *l)
{
    double w[3], side;
    int k;

    *l = 0.0;
    for (k = 0; k < 3; k++) w[k] = ra_sub(z[k], f[6 + k]);
    side = ra_dot(f, w);
    if (side == 0.0) return 1;
    *l = ra_div(ra_sub(ra_dot(w, w), ra_mul(2.0, ra_dot(f + 3, w))),
                ra_mul(2.0, side));
    return 0;
}

/* minor3 - the determinant of the columns i, j, k of the rows a, b, c */
static double minor3(const double *a, const double *b, const double *c, int i,
                     int j, int k)
{
    double x = ra_sub(ra_mul(b[j], c[k]), ra_mul(b[k], c[j]));
    double y = ra_sub(ra_mul(a[j], c[k]), ra_mul(a[k], c[j]));
    double z = ra_sub(ra_mul(a[j], b[k]), ra_mul(a[k], b[j]));

    return ra_add(ra_sub(ra_mul(a[i], x), ra_mul(b[i], y)), ra_mul(c[i], z));
}

void ra_minors(const double *a, const double *b, const double *c,
               const double *d, double *m)
{
    static const int column[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3},
                                     {0, 1, 2}};
    const double *p[4];
    double r[4][4], s, t;
    int i, k;

    p[0] = a;
    p[1] = b;
    p[2] = c;
    p[3] = d;
    for (i = 0; i < 4; i++) {
        for (k = 0; k < 3; k++) r[i][k] = p[i][k];
        r[i][3] = ra_dot(p[i], p[i]);
    }
    /* three columns and the ones */
    for (k = 0; k < 4; k++) {
        const int *j = column[k];

        s = ra_sub(minor3(r[0], r[1], r[2], j[0], j[1], j[2]),
                   minor3(r[0], r[1], r[3], j[0], j[1], j[2]));
        t = ra_sub(minor3(r[0], r[2], r[3], j[0], j[1], j[2]),
                   minor3(r[1], r[2], r[3], j[0], j[1], j[2]));
        m[k] = ra_add(s, t);
        if (k % 2 == 0) m[k] = -m[k];
    }
    /* no ones: by the last column */
    s = ra_sub(ra_mul(r[2][3], minor3(r[0], r[1], r[3], 0, 1, 2)),
               ra_mul(r[3][3], minor3(r[0], r[1], r[2], 0, 1, 2)));
    t = ra_sub(ra_mul(r[0][3], minor3(r[1], r[2], r[3], 0, 1, 2)),
               ra_mul(r[1][3], minor3(r[0], r[2], r[3], 0, 1, 2)));
    m[4] = ra_add(s, t);
}

double ra_det(const double *m, const double *z)
{
    return ra_add(ra_add(ra_dot(m, z), ra_mul(m[3], ra_dot(z, z))), m[4]);
}
