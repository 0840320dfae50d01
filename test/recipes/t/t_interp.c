/* t_interp.c - interp.c's grid of values, in the blank of a telescope's mirror.
 *
 *   cc -O2 -I. -o t_interp test/recipes/t/t_interp.c \
 *       test/recipes/interp.c tess.c hhpred.c -lm
 *
 * A concave meniscus, 2.4 m wide and 300 mm thick, with a hole.  The sensors
 * sit in layers from front to back, on rings, but irregularly.  The true
 * temperature is known here, so the error is, too.  Checked at each place in
 * the glass: the error is within the bound that interp.c names, and falls with
 * the square of the spacing; a linear field comes out as it is; and at those
 * outside the hull, that they are said to be.
 *
 * Linked with twin/recipes.c it tests interp.f.
 */
#include <math.h>
#include <stdio.h>

#include "../recipes.h"

#define LEVELS 3
#define FINEST 4 /* spacings of the sensors: 1/1, 1/2, 1/4 */
#define RINGS (6 * (FINEST) + 1)
#define LAYERS (2 * (FINEST) + 1)
#define ANGLES (32 * (FINEST))

/* 8 tetrahedra a point suffice for points that fill a volume.  tess tells by
 * a code if they do not. */
#define MAXPTS (RINGS * LAYERS * ANGLES)
#define MAXTET (8 * MAXPTS)
#define MAXIW TESS_LIW(MAXPTS)
#define MAXRW TESS_LRW(MAXPTS)

#define INNER 0.30  /* radius of the hole, m             */
#define OUTER 1.20  /* radius of the rim, m              */
#define CURVE 11.0  /* radius of the front, a sphere     */
#define THICK 0.30  /* thickness, m                      */
#define LEAST 0.31  /* radii that are looked at, m: from */
#define MOST 1.16   /* the hole almost to the rim        */
#define NX 41       /* places of the grid                */
#define NY 39
#define NZ 24
#define OUTSIDE (-99.0)

#define ROUNDING 1e-12 /* of numbers of about 10 */

static tess_real p[3 * MAXPTS];
static double value[2 * MAXPTS]; /* the field, a linear one */
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[MAXIW];
static double rw[MAXRW], out[2 * NX * NY * NZ];
static const tess_int size[3] = {NX, NY, NZ};
static const tess_int single[3] = {1, 1, 1}, none[3] = {NX, 0, NZ};
static const double box[6] = {-OUTER, OUTER, -OUTER, OUTER, -0.31, 0.08};
static tess_int start[NX];
static tess_real row[3 * NX];

/* random01 - a random number, 0 <= x < 1. */
static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 8) / 16777216.0;
}

/* depth_of - 0 at the front, 1 at the back. */
static double depth_of(const double *q)
{
    double above = CURVE - q[2];

    return (sqrt(q[0] * q[0] + q[1] * q[1] + above * above) - CURVE) / THICK;
}

/* field - the temperature in degrees C: colder at the front, and more so the
 * nearer to it. */
static double field(const double *q)
{
    double r2 = q[0] * q[0] + q[1] * q[1], depth = depth_of(q);

    return 11.0 - 1.5 * (1.0 - depth) * (1.0 - depth) + 0.2 * q[0] / OUTER +
           0.4 * r2 / (OUTER * OUTER);
}

/* M: the square of 1 - depth has the second derivative 2 / THICK^2 across the
 * layers, and less along them; r2 has 2 in x and y. */
static const double bend = 3.0 / (THICK * THICK) + 0.8 / (OUTER * OUTER);

static double plane(const double *q)
{
    return 1.0 + 2.0 * q[0] - 3.0 * q[1] + 4.0 * q[2];
}

/* place - q = the point at radius r, angle a and depth 0 ... 1 in the glass;
 * in whole micrometres, for the same points on every machine. */
static void place(double r, double a, double depth, double *q)
{
    double sphere = CURVE + THICK * depth;
    int k;

    q[0] = r * cos(a);
    q[1] = r * sin(a);
    q[2] = CURVE - sqrt(sphere * sphere - r * r);
    for (k = 0; k < 3; k++) q[k] = floor(q[k] * 1e6 + 0.5) / 1e6;
}

/* sensors - put them into the blank, fine times as close as on the first
 * level, and read them.  Returns how many. */
static tess_int sensors(int fine)
{
    double turn = 8.0 * atan(1.0), r, a, depth, q[3];
    int rings = 6 * fine, layers = 2 * fine, angles = 32 * fine, i, j, k, m;
    tess_int n = 0;

    for (i = 0; i <= rings; i++)
        for (j = 0; j <= layers; j++)
            for (k = 0; k < angles; k++) {
                r = i;
                if (i > 0 && i < rings) r += 0.6 * (random01() - 0.5);
                depth = j;
                if (j > 0 && j < layers) depth += 0.6 * (random01() - 0.5);
                a = k + 0.6 * (random01() - 0.5);
                place(INNER + (OUTER - INNER) * r / rings, turn * a / angles,
                      depth / layers, q);
                for (m = 0; m < 3; m++) {
                    p[3 * n + m] = (tess_real)q[m];
                    q[m] = (double)p[3 * n + m];
                }
                value[2 * n] = field(q);
                value[2 * n + 1] = plane(q);
                n++;
            }
    return n;
}

/* bound - what the error at q cannot exceed. */
static double bound(const double *q, const tess_int *v, const double *w)
{
    double sum = 0.0, d;
    int i, k;

    for (i = 0; i < 4; i++)
        for (k = 0; k < 3; k++) {
            d = (double)p[3 * v[i] + k] - q[k];
            sum += w[i] * d * d;
        }
    return bend / 2.0 * sum;
}

int main(void)
{
    tess_int n, ntet, t, liw, lrw, at[3];
    double w[4], q[3], r, depth, error, most, sum, old = 0.0, order;
    const double *f;
    tess_real real[3];
    int level, fine, code, k, bad = 0;
    long points, outside;

    printf("sensors  tetrahedra  in the glass  outside  largest error  "
           "root mean square  order\n");
    for (level = 0, fine = 1; level < LEVELS; level++, fine *= 2) {
        n = sensors(fine);
        code = tess_size(n, MAXTET, &liw, &lrw);
        if (code != 0 || liw > MAXIW || lrw > MAXRW) {
            printf("the arrays are too short\n");
            return 1;
        }
        code = tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
        if (code != TESS_OK) {
            printf("tess: code %d\n", code);
            return 1;
        }
        if (tr_ongrid(p, ntet, tet, adj, 2, value, size, box, OUTSIDE, start,
                      row, out) != 1)
            bad |= 1;

        points = outside = 0;
        most = sum = 0.0;
        f = out;
        t = TESS_NONE;
        for (at[2] = 0; at[2] < NZ; at[2]++)
            for (at[1] = 0; at[1] < NY; at[1]++)
                for (at[0] = 0; at[0] < NX; at[0]++, f += 2) {
                    for (k = 0; k < 3; k++) {
                        q[k] = (double)at[k] / (double)(size[k] - 1);
                        q[k] = box[2 * k] + q[k] * (box[2 * k + 1] - box[2 * k]);
                        real[k] = (tess_real)q[k];
                        q[k] = (double)real[k];
                    }
                    r = sqrt(q[0] * q[0] + q[1] * q[1]);
                    depth = depth_of(q);
                    if (r > OUTER + 1e-5 || depth > 1.0 + 1e-5) {
                        if (f[0] > OUTSIDE || f[1] > OUTSIDE) bad |= 1;
                        outside++;
                    }
                    /* the glass, but for what polygons of sensors leave
                     * outside */
                    if (r < LEAST || r > MOST || depth < 0.03 || depth > 0.97)
                        continue;
                    code = tess_locate(p, ntet, tet, adj, real, &t, w);
                    if (code != 0) bad |= 1; /* outside of the sensors' hull */
                    error = f[0] - field(q);
                    if (!(fabs(error) <= bound(q, tet + 4 * t, w) + ROUNDING))
                        bad |= 2;
                    if (fabs(error) > most) most = fabs(error);
                    sum += error * error;
                    if (!(fabs(f[1] - plane(q)) <= ROUNDING)) bad |= 4;
                    points++;
                }
        sum = sqrt(sum / (double)points);
        printf("%7ld  %10ld  %12ld  %7ld  %11.4f C  %14.5f C", (long)n,
               (long)ntet, points, outside, most, sum);
        if (level > 0) {
            order = log(old / sum) / log(2.0);
            printf("  %5.2f", order);
            if (order < 1.8 || order > 2.2) bad |= 8;
        }
        printf("\n");
        old = sum;
    }
    /* one place is in the middle */
    if (tr_ongrid(p, ntet, tet, adj, 2, value, single, box, OUTSIDE, start, row,
                  out) != 0 ||
        !(fabs(out[1] - (1.0 - 4.0 * 0.115)) <= ROUNDING) ||
        tr_ongrid(p, ntet, tet, adj, 2, value, none, box, OUTSIDE, start, row,
                  out) != -7)
        bad |= 4;
    printf("inside and outside of the hull where it is: %s\n"
           "every error within the bound of theory:     %s\n"
           "a linear field interpolated, to rounding:   %s\n"
           "errors of second order in the spacing:      %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes", bad & 8 ? "NO" : "yes");
    return bad != 0;
}
