/* poisson.c - finite elements on points that fill a ball.
 *
 *   cc -O2 -I. -o poisson test/samples/poisson.c tess.c hhpred.c -lm
 *
 * Poisson's equation  -div grad u = f  in the unit ball,  u = 0 on the sphere,
 * with linear elements on the tetrahedra of tess, solved by conjugate
 * gradients without a matrix.  Solution: u = (1 - |x|^2) exp(z), so that
 * f = (5 + 4 z + |x|^2) exp(z).
 *
 * What tess gives, a finite element code takes as it is:
 *   orientation   all volumes are positive: gradients need no care for signs
 *   tess_hull     the hull triangles; their vertices carry u = 0
 *   adj           the other side of each facet; the jump of the gradient
 *                 there tells where to refine, and how large the error is
 *
 * Choose points with care.  A Delaunay tetrahedralization of random points, or
 * of a slightly disturbed cubic grid, has slivers: four points almost on one
 * circle, a volume of almost 0; with them the gradient is poor and conjugate
 * gradients slow.  A body-centred cubic grid has none: all its tetrahedra are
 * alike, with angles of 60 and 90 degrees, and nearly so when it is disturbed.
 * It stops short of the sphere, which has points of its own; some slivers
 * arise between the two, too few to matter (the column "poor").
 *
 * Checked: the boundary has the points on the sphere; the volumes add up to
 * what it encloses; linear functions come out as they are (the patch test);
 * the error, a root mean square, falls with the square of the spacing, that of
 * the gradient with the spacing; the estimate stays in step with it.
 */
#include <math.h>
#include <stdio.h>

#include "tess.h"

#define LEVELS 3
#define COARSE 0.25 /* edge of the grid's cubes on the first level */

#define MAXPTS 50000
#define MAXTET (7 * MAXPTS)
#define MAXIW TESS_LIW(MAXPTS)
#define MAXRW TESS_LRW(MAXPTS)
#define MAXFAC (MAXPTS)

static tess_real p[3 * MAXPTS];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[MAXIW];
static tess_int fac[3 * MAXFAC];
static double rw[MAXRW];
static tess_int n, ntet, nfac;

static char fixed[MAXPTS];                       /* on the boundary */
static double grad[12 * MAXTET], volume[MAXTET]; /* of the elements */
static double u[MAXPTS], load[MAXPTS], diagonal[MAXPTS];
static double residual[MAXPTS], step[MAXPTS], image[MAXPTS];

/* The facet opposite to vertex k, seen counter-clockwise from outside. */
static const int facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/* ---------------------------------------------------------------- points */

static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 8) / 16777216.0;
}

/* put - add a point; in multiples of 2^-24, for the same on every machine. */
static void put(const double *q)
{
    int k;

    if (n == MAXPTS) return;
    for (k = 0; k < 3; k++)
        p[3 * n + k] =
            (tess_real)(floor(q[k] * 16777216.0 + 0.5) / 16777216.0);
    n++;
}

/* points - a body-centred cubic grid of edge a, disturbed by up to 5 % of a,
 * in the ball; on the sphere a spiral of about the same spacing.  Returns how
 * many are inside. */
static tess_int points(double a)
{
    double q[3], r, angle, pi = 4.0 * atan(1.0);
    tess_int inside;
    int m = (int)(1.0 / a) + 1, i, j, k, c, h, many;

    n = 0;
    for (i = -m; i <= m; i++)
        for (j = -m; j <= m; j++)
            for (k = -m; k <= m; k++)
                for (c = 0; c < 2; c++) {
                    q[0] = a * (i + 0.5 * c);
                    q[1] = a * (j + 0.5 * c);
                    q[2] = a * (k + 0.5 * c);
                    for (h = 0; h < 3; h++)
                        q[h] += 0.1 * a * (random01() - 0.5);
                    r = q[0] * q[0] + q[1] * q[1] + q[2] * q[2];
                    if (r < (1.0 - 0.4 * a) * (1.0 - 0.4 * a)) put(q);
                }
    inside = n;
    many = (int)(4.0 * pi / (0.85 * a * a));
    for (i = 0; i < many; i++) {
        q[2] = 1.0 - (2.0 * i + 1.0) / many;
        r = sqrt(1.0 - q[2] * q[2]);
        angle = pi * (3.0 - sqrt(5.0)) * i;
        q[0] = r * cos(angle);
        q[1] = r * sin(angle);
        put(q);
    }
    return inside;
}

/* -------------------------------------------------------------- elements */

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static void edge(tess_int from, tess_int to, double *e)
{
    int k;

    for (k = 0; k < 3; k++)
        e[k] = (double)p[3 * to + k] - (double)p[3 * from + k];
}

/* elements - the volumes, and the gradients of the four weights: of a vertex's
 * weight, the cross product of two edges of the facet opposite to it over six
 * volumes. */
static void elements(void)
{
    const tess_int *v;
    double e[3][3], *g;
    tess_int t;
    int i, k;

    for (t = 0; t < ntet; t++) {
        v = tet + 4 * t;
        g = grad + 12 * t;
        for (i = 0; i < 3; i++) edge(v[0], v[i + 1], e[i]);
        for (i = 0; i < 3; i++)
            cross(e[(i + 1) % 3], e[(i + 2) % 3], g + 3 * (i + 1));
        volume[t] = dot(e[0], g + 3) / 6.0;
        for (k = 0; k < 3; k++) {
            for (i = 1; i < 4; i++) g[3 * i + k] /= 6.0 * volume[t];
            g[k] = -(g[3 + k] + g[6 + k] + g[9 + k]);
        }
    }
}

/* slope - the gradient of x, a value at each point, in element t. */
static void slope(const double *x, tess_int t, double *g)
{
    int i, k;

    for (k = 0; k < 3; k++) {
        g[k] = 0.0;
        for (i = 0; i < 4; i++)
            g[k] += x[tet[4 * t + i]] * grad[12 * t + 3 * i + k];
    }
}

/* multiply - y = the stiffness matrix times x. */
static void multiply(const double *x, double *y)
{
    double g[3];
    tess_int i, t;
    int k;

    for (i = 0; i < n; i++) y[i] = 0.0;
    for (t = 0; t < ntet; t++) {
        slope(x, t, g);
        for (k = 0; k < 4; k++)
            y[tet[4 * t + k]] += volume[t] * dot(g, grad + 12 * t + 3 * k);
    }
}

/* solve - u at the points that are not fixed, from u at those that are, and
 * load.  Returns the number of iterations; -1 when there are too many. */
static int solve(void)
{
    double rho = 0.0, old, first = 0.0, a;
    tess_int i, t;
    int k, turn;

    for (i = 0; i < n; i++) diagonal[i] = step[i] = 0.0;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++)
            diagonal[tet[4 * t + k]] += volume[t] *
                                        dot(grad + 12 * t + 3 * k,
                                            grad + 12 * t + 3 * k);
    for (i = 0; i < n; i++)
        if (!fixed[i]) u[i] = 0.0;
    multiply(u, image);
    for (i = 0; i < n; i++) residual[i] = fixed[i] ? 0.0 : load[i] - image[i];
    for (turn = 0; turn < 1000; turn++) {
        old = rho;
        rho = 0.0;
        for (i = 0; i < n; i++) rho += residual[i] * residual[i] / diagonal[i];
        if (turn == 0) first = rho;
        if (rho <= 1e-24 * first) return turn;
        for (i = 0; i < n; i++)
            step[i] = residual[i] / diagonal[i] +
                      (turn > 0 ? rho / old * step[i] : 0.0);
        multiply(step, image);
        a = 0.0;
        for (i = 0; i < n; i++) a += step[i] * image[i];
        a = rho / a;
        for (i = 0; i < n; i++) {
            if (fixed[i]) continue;
            u[i] += a * step[i];
            residual[i] -= a * image[i];
        }
    }
    return -1;
}

/* --------------------------------------------------------------- problem */

static double exact(const double *q)
{
    return (1.0 - dot(q, q)) * exp(q[2]);
}

static double source(const double *q)
{
    return (5.0 + 4.0 * q[2] + dot(q, q)) * exp(q[2]);
}

static void exact_slope(const double *q, double *g)
{
    g[0] = -2.0 * q[0] * exp(q[2]);
    g[1] = -2.0 * q[1] * exp(q[2]);
    g[2] = (1.0 - dot(q, q) - 2.0 * q[2]) * exp(q[2]);
}

static double plane(tess_int i)
{
    return 1.0 + 2.0 * (double)p[3 * i] - 3.0 * (double)p[3 * i + 1] +
           4.0 * (double)p[3 * i + 2];
}

/* node - w = the weights of quadrature point i = 0 ... 3 of an element, and q
 * = its place in element t.  All four with equal weights integrate quadratic
 * functions exactly. */
static void node(tess_int t, int i, double *w, double *q)
{
    double own = 0.5854101966249685, others = 0.1381966011250105;
    int j, k;

    for (k = 0; k < 3; k++) q[k] = 0.0;
    for (j = 0; j < 4; j++) {
        w[j] = i == j ? own : others;
        for (k = 0; k < 3; k++)
            q[k] += w[j] * (double)p[3 * tet[4 * t + j] + k];
    }
}

/* loads - the integrals of f times the weights of each point. */
static void loads(void)
{
    double w[4], q[3];
    tess_int i, t;
    int j, k;

    for (i = 0; i < n; i++) load[i] = 0.0;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            node(t, k, w, q);
            for (j = 0; j < 4; j++)
                load[tet[4 * t + j]] += volume[t] / 4.0 * w[j] * source(q);
        }
}

/* errors - of u in the mean and of its gradient, root mean square. */
static void errors(double *mean, double *slopes)
{
    double w[4], q[3], g[3], h[3], e, all = 0.0;
    tess_int t;
    int j, k;

    *mean = *slopes = 0.0;
    for (t = 0; t < ntet; t++) {
        slope(u, t, g);
        all += volume[t];
        for (k = 0; k < 4; k++) {
            node(t, k, w, q);
            e = -exact(q);
            for (j = 0; j < 4; j++) e += w[j] * u[tet[4 * t + j]];
            *mean += volume[t] / 4.0 * e * e;
            exact_slope(q, h);
            for (j = 0; j < 3; j++) h[j] -= g[j];
            *slopes += volume[t] / 4.0 * dot(h, h);
        }
    }
    *mean = sqrt(*mean / all);
    *slopes = sqrt(*slopes / all);
}

/* jumps - an estimate of the error of the gradient that does not know the
 * solution: from the jumps of the normal slope across all inner facets
 * (area times diameter times jump squared; Babuska, Kelly). */
static double jumps(void)
{
    double g[3], h[3], a[3], b[3], c[3], area, sum = 0.0, all = 0.0;
    const tess_int *v;
    tess_int t, s;
    int k;

    for (t = 0; t < ntet; t++) {
        all += volume[t];
        v = tet + 4 * t;
        slope(u, t, g);
        for (k = 0; k < 4; k++) {
            s = adj[4 * t + k];
            if (s < t) continue; /* the hull, or seen from the other side */
            slope(u, s, h);
            edge(v[facet[k][0]], v[facet[k][1]], a);
            edge(v[facet[k][0]], v[facet[k][2]], b);
            cross(a, b, c);
            area = sqrt(dot(c, c)) / 2.0;
            h[0] -= g[0];
            h[1] -= g[1];
            h[2] -= g[2];
            sum += dot(h, c) * dot(h, c) / (4.0 * area) * sqrt(area);
        }
    }
    return sqrt(sum / all);
}

/* poor - the elements that are nearly flat: three times the radius of the ball
 * inside over that of the ball about them, which is 1 for a regular
 * tetrahedron and 0.95 in the undisturbed grid, is below 0.1. */
static tess_int poor(void)
{
    double e[3][3], a[3], b[3], c[3], surface, inner, outer;
    const tess_int *v;
    tess_int many = 0, t;
    int i, k;

    for (t = 0; t < ntet; t++) {
        v = tet + 4 * t;
        surface = 0.0;
        for (k = 0; k < 4; k++) {
            edge(v[facet[k][0]], v[facet[k][1]], a);
            edge(v[facet[k][0]], v[facet[k][2]], b);
            cross(a, b, c);
            surface += sqrt(dot(c, c)) / 2.0;
        }
        for (i = 0; i < 3; i++) {
            edge(v[0], v[i + 1], e[i]);
            b[i] = 0.0;
        }
        for (i = 0; i < 3; i++) {
            cross(e[(i + 1) % 3], e[(i + 2) % 3], c);
            for (k = 0; k < 3; k++) b[k] += dot(e[i], e[i]) * c[k];
        }
        inner = 3.0 * volume[t] / surface;
        outer = sqrt(dot(b, b)) / (12.0 * volume[t]);
        if (3.0 * inner / outer < 0.1) many++;
    }
    return many;
}

/* boundary - fix the vertices of the hull.  Returns how many there are, and
 * *v, the volume that the triangles enclose. */
static tess_int boundary(double *v)
{
    double q[3][3], c[3];
    tess_int many = 0, i, j;
    int k, m;

    for (i = 0; i < n; i++) fixed[i] = 0;
    *v = 0.0;
    for (i = 0; i < nfac; i++) {
        for (k = 0; k < 3; k++) {
            j = fac[3 * i + k];
            if (!fixed[j]) many++;
            fixed[j] = 1;
            for (m = 0; m < 3; m++) q[k][m] = (double)p[3 * j + m];
        }
        cross(q[1], q[2], c);
        *v += dot(q[0], c) / 6.0;
    }
    return many;
}

/* patch - with a linear function on the boundary and no load, the largest
 * difference from that function. */
static double patch(void)
{
    double worst = 0.0;
    tess_int i;

    for (i = 0; i < n; i++) {
        load[i] = 0.0;
        u[i] = plane(i);
    }
    if (solve() < 0) return 1.0;
    for (i = 0; i < n; i++)
        if (fabs(u[i] - plane(i)) > worst) worst = fabs(u[i] - plane(i));
    return worst;
}

int main(void)
{
    double a = COARSE, mean, slopes, guess, order, enclosed, all;
    double old_mean = 0.0, old_slopes = 0.0;
    tess_int inside, i, liw, lrw;
    int level, code, bad = 0;

    printf("points  inside  elements  poor    error  order  of gradient  order"
           "  estimate\n");
    for (level = 0; level < LEVELS; level++, a /= 2.0) {
        inside = points(a);
        code = tess_size(n, MAXTET, &liw, &lrw);
        if (n == MAXPTS || code != 0 || liw > MAXIW || lrw > MAXRW) {
            printf("the arrays are too short\n");
            return 1;
        }
        code = tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
        if (code == TESS_OK)
            code = tess_hull(ntet, tet, adj, MAXFAC, &nfac, fac);
        if (code != TESS_OK) {
            printf("tess: code %d\n", code);
            return 1;
        }

        elements();
        all = 0.0;
        for (i = 0; i < ntet; i++) all += volume[i];
        if (boundary(&enclosed) != n - inside) bad |= 1;
        if (fabs(all - enclosed) > 1e-12) bad |= 2;
        if (patch() > 1e-9) bad |= 4;

        for (i = 0; i < n; i++) u[i] = 0.0;
        loads();
        if (solve() < 0) bad |= 4;
        errors(&mean, &slopes);
        guess = jumps();
        printf("%6ld  %6ld  %8ld  %4ld  %.5f", (long)n, (long)inside,
               (long)ntet, (long)poor(), mean);
        if (level > 0) {
            order = log(old_mean / mean) / log(2.0);
            printf("  %5.2f", order);
            if (order < 1.8 || order > 2.2) bad |= 8;
            order = log(old_slopes / slopes) / log(2.0);
            printf("      %.5f  %5.2f", slopes, order);
            if (order < 0.9 || order > 1.2) bad |= 8;
        } else
            printf("             %.5f       ", slopes);
        printf("   %.5f\n", guess);
        if (guess < 2.5 * slopes || guess > 3.5 * slopes) bad |= 16;
        old_mean = mean;
        old_slopes = slopes;
    }
    printf("the points of the sphere, and no others, on the boundary: %s\n"
           "elements fill what the boundary encloses:                 %s\n"
           "linear functions come out as they are:                    %s\n"
           "errors of second order, of the gradient of first:         %s\n"
           "the estimate from jumps stays in step with the error:     %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes", bad & 8 ? "NO" : "yes",
           bad & 16 ? "NO" : "yes");
    return bad != 0;
}
