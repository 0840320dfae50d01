/* slopes.c - smooth, accurate interpolation of scattered data: recipes to copy.
 *
 *   tr_slopes    gradients of a field at the points, from its values there
 *                (dot, fit, plane)
 *   tr_bent      the field at any place, from values and gradients  (dot)
 *
 * tr_bent costs a query what linear interpolation does.  Its error is of third
 * order where linear interpolation's is of second: inside the hull a fifth to
 * a twentieth of it.  At the hull, where tetrahedra are long and flat, no
 * interpolation that looks at four points alone is good.
 *
 * Which interpolation?
 *   - tr_bent for accuracy: continuous, and exact for quadratic fields where
 *     the slopes are.  `make errors' prints a table: with 8,000 random points
 *     and three rounds its rms error in Franke's field is 0.14 of linear's,
 *     0.25 with what is within 0.01 of the hull.  It may leave the data's
 *     range, by little: there at 8 of 39,378 places, by 0.011 of it at most.
 *     Outside the hull it gives the value at the hull's nearest point, or goes
 *     on along the points' slopes.
 *   - tess_values, linear, stays within the data.
 *   - tr_natural and tr_blend, of natural.c, are smooth, not more accurate than
 *     linear, and take fifty times as long.
 *   - tr_nearest, of derived.c, where values must not be mixed, as numbers of
 *     kinds.
 *   - The data tell: build/tess -validate -method linear,smooth,natural.
 * tr_many, of many.c, does all four at any number of places, in any order.
 *
 * slopes.f is the same in FORTRAN 77.
 */
#include <float.h>
#include <math.h>

#include "recipes.h"

/* ---- tr_slopes ---- */

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* fit - x of (M + add I) x = r, M symmetric: xx, yy, zz, xy, xz, yz. */
static void fit(const double *m, double add, const double *r, double *x)
{
    double a = m[0] + add, b = m[3] / a, c = m[4] / a;
    double d = m[1] + add - b * m[3], e = (m[5] - b * m[4]) / d;
    double f = m[2] + add - c * m[4] - e * (m[5] - b * m[4]);
    double s = r[1] - b * r[0];

    x[2] = (r[2] - c * r[0] - e * s) / f;
    x[1] = s / d - e * x[2];
    x[0] = r[0] / a - b * x[1] - c * x[2];
}

/* What is thinner than this is flat: its points do not tell how a field goes on
 * across it, unless the field is linear. */
#define THIN 1e-7

/* The values' rounding, as a part of them. */
#define NOISE (4.0 * DBL_EPSILON)

/* plane - g: the gradient of the linear field nearest to the values of the
 * points i with used[i] != 0, in the mean of squares.  By coordinates u in parts
 * of the box, the longest side first; then by what is left of the second when
 * it is told from the first one, and of the third told from both.  So what is
 * thin is seen as such, not as a difference of squares. */
static void plane(tess_int n, const tess_real *p, const double *used,
                  const double *value, double *g)
{
    double low[3], size[3], mean[4], u[3], m[6], a[6], r[4], x[3], t[3], d;
    double b = 0.0, c = 0.0, e = 0.0, count = 0.0, top = 0.0, rest;
    tess_int i;
    int by[3], j, k, pass;

    for (k = 0; k < 3; k++) low[k] = size[k] = 0.0;
    for (i = 0; i < n; i++) {
        if (used[i] == 0.0) continue;
        for (k = 0; k < 3; k++) {
            d = (double)p[3 * i + k];
            if (count == 0.0 || d < low[k]) low[k] = d;
            if (count == 0.0 || d > size[k]) size[k] = d;
        }
        if (fabs(value[i]) > top) top = fabs(value[i]);
        count += 1.0;
    }
    if (top == 0.0) top = 1.0;
    for (k = 0; k < 3; k++) {
        size[k] -= low[k];
        for (j = k; j > 0 && size[k] > size[by[j - 1]]; j--) by[j] = by[j - 1];
        by[j] = k;
    }
    for (k = 0; k < 4; k++) mean[k] = 0.0;
    for (pass = 0; pass < 3; pass++) {
        for (k = 0; k < 6; k++) m[k] = 0.0;
        for (k = 0; k < 4; k++) r[k] = 0.0;
        for (i = 0; i < n; i++) {
            if (used[i] == 0.0) continue;
            for (k = 0; k < 3; k++)
                u[k] = ((double)p[3 * i + by[k]] - low[by[k]]) / size[by[k]] -
                       mean[k];
            u[1] -= b * u[0];
            u[2] -= c * u[0] + e * u[1];
            d = pass > 0 ? value[i] / top - mean[3] : 1.0 / count;
            for (k = 0; k < 3; k++) {
                m[k] += u[k] * u[k];
                m[k + 3] += u[k == 2] * u[k == 0 ? 1 : 2];
                r[k] += u[k] * d;
            }
            r[3] += d * (pass > 0 ? d : value[i] / top);
        }
        for (k = 0; k < 4 && pass == 0; k++) mean[k] = r[k];
        if (pass != 1) continue;
        b = m[3] / m[0];
        c = m[4] / m[0];
        e = (m[5] - b * m[4]) / (m[1] - b * m[3] + 1e-14 * m[0]);
    }
    /* each in units of its own, but for what is rounding */
    for (k = 0; k < 3; k++)
        t[k] = m[k] > 1e-28 * m[0] ? 1.0 / sqrt(m[k]) : 0.0;
    for (pass = 0; pass < 2; pass++) {
        for (k = 0; k < 3; k++) {
            if (pass > 0 && t[0] * size[by[k]] < THIN * t[k] * size[by[0]])
                t[k] = 0.0;
            u[k] = r[k] * t[k];
        }
        for (k = 0; k < 3; k++) {
            a[k] = m[k] * t[k] * t[k];
            a[k + 3] = m[k + 3] * t[k == 2] * t[k == 0 ? 1 : 2];
        }
        fit(a, 1e-14, u, x);
        rest = r[3] - dot(u, x);
        if (rest <= 1e-12 * r[3]) break;
    }
    d = NOISE * sqrt(count);
    for (k = 0; k < 3; k++) x[k] *= fabs(x[k]) > d ? t[k] : 0.0;
    x[1] -= e * x[2];
    x[0] -= b * x[1] + c * x[2];
    for (k = 0; k < 3; k++) x[k] /= size[by[k]];
    /* where nothing is told the gradient is 0 */
    m[0] = -b * size[by[1]] / size[by[0]];
    m[1] = 1.0;
    m[2] = 0.0;
    m[3] = (e * b - c) * size[by[2]] / size[by[0]];
    m[4] = -e * size[by[2]] / size[by[1]];
    m[5] = 1.0;
    d = t[1] > 0.0 ? 0.0 : dot(m, m + 3) / dot(m, m);
    for (k = 0; k < 3; k++) m[k + 3] -= d * m[k];
    for (j = 1; j < 3; j++) {
        d = t[j] > 0.0 ? 0.0 : dot(x, m + 3 * j - 3) / dot(m + 3 * j - 3,
                                                           m + 3 * j - 3);
        for (k = 0; k < 3; k++) x[k] -= d * m[3 * j - 3 + k];
    }
    for (k = 0; k < 3; k++) g[by[k]] = x[k] * top;
}

/* tr_slopes - gradients of a field at the points.
 *
 *   n, p, ntet, tet, adj  (in)  points and mesh, as from tess
 *   value   (in)   n: the field's values
 *   rounds  (in)   >= 0: 3 do; 15 for a field that is smooth at the spacing
 *                  of the points
 *   g       (out)  3*n: g[3*i+k] is the derivative by coordinate k at point i.
 *                  A duplicate (iw[i] != i) has no edges: the gradient of the
 *                  field's best linear fit.  Copy that of iw[i]
 *   work    (out)  9*n doubles
 *
 * returns 0; -1 for n < 1, -3 for ntet < 1, -7 for rounds < 0; TESS_BAD_INDEX
 * for a vertex that is out of range, TESS_BAD_OPEN for an unfinished mesh: g is
 * then not set; TESS_RANGE where a gradient is no number, being too large or by
 * a value that is none: the others are set.
 * Cost: each pass, of which there are rounds + 1, a fifth of the time of tess.
 *
 * First, by least squares, the one gradient that suits all points best; then at
 * each point the one that suits its own edges,
 *
 *     M g = r,  M = sum of w e e',  r = sum of w (difference of values) e,
 *
 * an edge e having the weight w = 1 / (e.e) for each tetrahedron at it.  Where
 * points are nearly in a plane, what M cannot tell is taken from the first
 * gradient, by 1e-4 of M's trace on its diagonal.  A linear field comes out as
 * it is, since nothing is left to tell after the first gradient; so, too, in a
 * flat set, across which the first gradient of any other field is 0.
 *
 * Along an edge of a quadratic field the difference is not either end's
 * gradient times the edge, but that of both ends' mean.  So each round adds at
 * all points at once
 *
 *     1.8 (M + D)^-1 sum of w (difference - (g_a + g_b).e / 2) e,
 *
 * D the diagonal.  This cannot diverge: it is a step down the gradient of
 *
 *     S = sum over edges of w (difference - (g_a + g_b).e / 2)^2,
 *
 * of the quadratic form x'A x = sum of w (x_a.e + x_b.e)^2 / 2.  As
 * (s + t)^2 / 2 <= s^2 + t^2, x'A x <= x'M x: the eigenvalues of (M + D)^-1 A
 * are in [0, 1], those of the round, 1 minus 1.8 times them, in [-0.8, 1].  S
 * never grows, and no part of the error does.  That needs each edge's weight to
 * be the same at both ends, and a factor of at most 2; 1 takes twice as many
 * rounds. */
int tr_slopes(tess_int n, const tess_real *p, tess_int ntet,
              const tess_int *tet, const tess_int *adj, const double *value,
              int rounds, double *g, double *work)
{
    double *r = work, *m = work + 3 * n, e[3], x[3], size, w, d, s, u;
    tess_int i, t, a, b;
    int pass, j, k, l;

    if (n < 1) return -1;
    if (ntet < 1) return -3;
    if (rounds < 0) return -7;
    for (i = 0; i < 4 * ntet; i++) {
        if (tet[i] < 0 || tet[i] >= n) return TESS_BAD_INDEX;
        if (adj[i] == TESS_OPEN) return TESS_BAD_OPEN;
    }
    for (i = 0; i < 9 * n; i++) work[i] = 0.0;
    for (i = 0; i < 4 * ntet; i++) work[tet[i]] = 1.0;
    plane(n, p, work, value, x);
    for (i = 0; i < 3 * n; i++) g[i] = x[i % 3];
    for (pass = 0; pass <= rounds; pass++) {
        for (i = 0; i < 3 * n; i++) r[i] = 0.0;
        for (t = 0; t < ntet; t++)
            for (j = 0; j < 3; j++)
                for (l = j + 1; l < 4; l++) {
                    a = tet[4 * t + j];
                    b = tet[4 * t + l];
                    for (k = 0; k < 3; k++)
                        e[k] = (double)p[3 * b + k] - (double)p[3 * a + k];
                    size = 1.0;
                    w = dot(e, e);
                    if (!(w > 1e-280 && w < 1e280)) {
                        for (size = 0.0, k = 0; k < 3; k++)
                            if (fabs(e[k]) > size) size = fabs(e[k]);
                        for (k = 0; k < 3; k++) e[k] /= size;
                        w = dot(e, e);
                    }
                    w = 1.0 / w;
                    s = dot(g + 3 * a, e);
                    u = dot(g + 3 * b, e);
                    if (pass > 0) s = u = (s + u) / 2.0;
                    d = (value[b] - value[a]) / size;
                    s = d - s;
                    u = d - u;
                    /* within the values' rounding nothing is left to tell */
                    d = NOISE * (fabs(value[a]) + fabs(value[b])) / size;
                    if (fabs(s) <= d) s = 0.0;
                    if (fabs(u) <= d) u = 0.0;
                    for (k = 0; k < 3; k++) {
                        r[3 * a + k] += w * s * e[k];
                        r[3 * b + k] += w * u * e[k];
                    }
                    if (pass > 0) continue;
                    for (k = 0; k < 6; k++) {
                        d = w * (k < 3 ? e[k] * e[k]
                                       : e[k == 5] * e[k == 3 ? 1 : 2]);
                        m[6 * a + k] += d;
                        m[6 * b + k] += d;
                    }
                }
        for (i = 0; i < n; i++) {
            d = m[6 * i] + m[6 * i + 1] + m[6 * i + 2];
            if (!(d > 0.0)) continue;
            fit(m + 6 * i, 1e-4 * d, r + 3 * i, x);
            for (k = 0; k < 3; k++)
                g[3 * i + k] += (pass > 0 ? 1.8 : 1.0) * x[k];
        }
    }
    for (i = 0; i < 3 * n; i++)
        if (!(fabs(g[i]) <= DBL_MAX)) return TESS_RANGE;
    return 0;
}

/* ---- tr_bent ---- */

/* tr_bent - the field at a place q.
 *
 *   p, ntet, tet, adj  (in)  points and mesh
 *   value   (in)      the field's values at the points
 *   g       (in)      gradients there, as tr_slopes gives them
 *   beyond  (in)      for q outside the hull: 0.0 for the field at the hull's
 *                     point nearest to q; 1.0 to go on from there with the
 *                     gradient; or what lies between
 *   q       (in)      the place: 3 coordinates
 *   t       (in,out)  where the walk starts, and the tetrahedron, as in
 *                     tess_locate
 *   f       (out)     the field at q
 *
 * returns what tess_locate returns: 0 inside, 1 outside, else f is not set.
 * Cost: that of tess_locate.
 *
 * The weights' sum of f_k + g_k.(q - p_k) / 2.  Continuous, the data at the
 * points, and exact for a quadratic field whose gradients are: with h = q - p_k
 * and H its second derivatives f_k is f - grad.h + h'H h / 2, and g_k is
 * grad - H h, so that f_k + g_k.h / 2 = f - grad.h / 2, and the weights' sum of
 * h is 0.
 *
 * Near sharp bends of the field it may leave the range of the data.
 *
 * Outside, with 1,000 to 27,000 points of a cube of edge 1 and two fields:
 * within 0.1 of it 1.0 has a third of the median error that 0.0 has, and no
 * larger worst ones; at 0.2 to 0.4 half of it or less, but of a hundred errors
 * the largest is up to twice that of 0.0; 0.5 then is between in both.  0.0
 * cannot go beyond what is at the hull.  The gradient is the points', from all
 * edges at them; a hull tetrahedron's own is useless, such a tetrahedron being
 * flat. */
int tr_bent(const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, const double *value, const double *g,
            double beyond, const tess_real *q, tess_int *t, double *f)
{
    const tess_int *v;
    double w[4], at[3], h[3];
    int code = tess_locate(p, ntet, tet, adj, q, t, w), j, k;

    if (code != 0 && code != 1) return code;
    v = tet + 4 * *t;
    for (k = 0; k < 3; k++) {
        at[k] = (double)q[k];
        if (code == 0) continue;
        for (at[k] = (double)p[3 * v[0] + k], j = 1; j < 4; j++)
            at[k] += w[j] *
                     ((double)p[3 * v[j] + k] - (double)p[3 * v[0] + k]);
    }
    for (*f = 0.0, j = 0; j < 4; j++) {
        for (k = 0; k < 3; k++)
            h[k] = (at[k] - (double)p[3 * v[j] + k]) / 2.0 +
                   beyond * ((double)q[k] - at[k]);
        *f += w[j] * (value[v[j]] + dot(g + 3 * v[j], h));
    }
    return code;
}
