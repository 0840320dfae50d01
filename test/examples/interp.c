/* interp.c - values measured at scattered points, interpolated onto a grid.
 *
 *   cc -O2 -I. -o interp test/examples/interp.c tess.c hhpred.c -lm
 *
 * Temperatures in the blank of a telescope's mirror: a concave meniscus, 2.4 m
 * wide and 300 mm thick, with a hole.  The sensors sit in layers from front
 * to back, on rings, but irregularly.  tess makes tetrahedra of them; for
 * each point of a grid tess_locate finds the one that holds it and the weights
 * of its four vertices; the weighted mean of the four values is the result.
 * (Sensors much denser in one direction: stretch that direction for tess.)
 *
 * The true temperature is known here, so the error is, too.  Theory says:
 *   - With M the largest second derivative of the field in any direction,
 *     the error at q is at most  M/2 * sum of w[k] |p_k - q|^2.  (Taylor
 *     about q; the first derivatives drop out, as sum w[k] (p_k - q) = 0.)
 *     No other triangulation of the points makes this bound smaller.
 *   - So the error falls with the square of the spacing.
 *   - A linear field comes out as it is.
 * All three are checked.
 */
#include <math.h>
#include <stdio.h>

#include "tess.h"

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
#define GRID 0.06   /* step of the grid in x and y, m    */
#define LEAST 0.31  /* its radii: from the hole almost   */
#define MOST 1.16   /* to the rim, m                     */
#define DEPTHS 10   /* its levels between front and back */

#define ROUNDING 1e-12 /* of numbers of about 10 */

static tess_real p[3 * MAXPTS];
static double value[MAXPTS], linear[MAXPTS];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[MAXIW];
static double rw[MAXRW];

/* random01 - a random number, 0 <= x < 1. */
static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 8) / 16777216.0;
}

/* field - the temperature in degrees C: colder at the front, and more so the
 * nearer to it. */
static double field(const double *q)
{
    double r2 = q[0] * q[0] + q[1] * q[1];
    double above = CURVE - q[2];
    double depth = (sqrt(r2 + above * above) - CURVE) / THICK;

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
                value[n] = field(q);
                linear[n] = plane(q);
                n++;
            }
    return n;
}

/* interpolate - sum of weights times values. */
static double interpolate(const double *values, const tess_int *v,
                          const double *w)
{
    return w[0] * values[v[0]] + w[1] * values[v[1]] + w[2] * values[v[2]] +
           w[3] * values[v[3]];
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
    tess_int n, ntet, t, liw, lrw;
    double w[4], q[3], r, z, error, most, sum, old = 0.0, order;
    tess_real real[3];
    int level, fine, code, i, j, k, m, bad = 0;
    long points;

    printf("sensors  tetrahedra  grid points  largest error  root mean square"
           "  order\n");
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

        points = 0;
        most = sum = 0.0;
        t = TESS_NONE; /* where to look first: near the last point found */
        for (i = -20; i <= 20; i++)
            for (j = -20; j <= 20; j++)
                for (k = 0; k < DEPTHS; k++) {
                    /* the glass, but for what polygons of sensors leave
                     * outside at the rim */
                    q[0] = GRID * i;
                    q[1] = GRID * j;
                    r = q[0] * q[0] + q[1] * q[1];
                    if (r < LEAST * LEAST || r > MOST * MOST) continue;
                    z = CURVE + THICK * (k + 0.5) / DEPTHS;
                    q[2] = CURVE - sqrt(z * z - r);

                    for (m = 0; m < 3; m++) {
                        real[m] = (tess_real)q[m];
                        q[m] = (double)real[m];
                    }
                    code = tess_locate(p, ntet, tet, adj, real, &t, w);
                    if (code != 0) bad |= 1; /* outside of the sensors' hull */

                    error = interpolate(value, tet + 4 * t, w) - field(q);
                    if (fabs(error) > bound(q, tet + 4 * t, w) + ROUNDING)
                        bad |= 2;
                    if (fabs(error) > most) most = fabs(error);
                    sum += error * error;
                    error = interpolate(linear, tet + 4 * t, w) - plane(q);
                    if (fabs(error) > ROUNDING) bad |= 4;
                    points++;
                }
        sum = sqrt(sum / (double)points);
        printf("%7ld  %10ld  %11ld  %11.4f C  %14.5f C", (long)n, (long)ntet,
               points, most, sum);
        if (level > 0) {
            order = log(old / sum) / log(2.0);
            printf("  %5.2f", order);
            if (order < 1.8 || order > 2.2) bad |= 8;
        }
        printf("\n");
        old = sum;
    }
    printf("all grid points in the hull of the sensors: %s\n"
           "every error within the bound of theory:     %s\n"
           "a linear field interpolated, to rounding:   %s\n"
           "errors of second order in the spacing:      %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes", bad & 8 ? "NO" : "yes");
    return bad != 0;
}
