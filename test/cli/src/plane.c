/* plane.c - points in a plane: their triangles, as the tetrahedra of space.
 *
 * Two more points, above and below the first one and equally far from it: as it
 * is midway between them no ball without a point in it has both, so the
 * tetrahedra are one of the two and the Delaunay triangles, exactly, as in the
 * recipe planar; and all that interpolates in space interpolates in the plane.
 * Places in the plane have no weight of the two; gradients that of the square
 * of the points' extent by their distance.  Natural neighbours are by areas in
 * the plane: volumes would be theirs only by the same square, and lose digits.
 */
#include <float.h>
#include <math.h>

#include "driver.h"

#define OFF 22 /* their distance: so large a power of two times the extent */

/* Points are in a plane if they are so near to it, in units of the rounding of
 * the largest coordinate; and in parts of the plane's narrower side. */
#define ROUNDINGS 32.0
#define THIN 1e-6

static double origin[3], along[2][3]; /* the plane */
static int axis[2] = {0, 1};          /* of it; -1 if it is askew to all */

/* apart - d = x - y; returns its length. */
static double apart(const double *x, const double *y, double *d)
{
    double sum = 0.0;
    int k;

    for (k = 0; k < 3; k++) {
        d[k] = x[k] - y[k];
        sum += d[k] * d[k];
    }
    return sqrt(sum);
}

void normal_to(const double *a, const double *b, double *c)
{
    int k;

    for (k = 0; k < 3; k++)
        c[k] = a[(k + 1) % 3] * b[(k + 2) % 3] -
               a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* farthest - the point whose distance, from the first point (pass 0), the line
 * along[0] through it (1) or the plane with the normal along[1] (2), is
 * largest; and that. */
static tess_int farthest(const mesh *m, double unit, int pass, double *most)
{
    double x[3], d[3], c[3], far;
    tess_int i, found = 0;
    int k;

    *most = 0.0;
    for (i = 0; i < m->in->n; i++) {
        for (k = 0; k < 3; k++) x[k] = (double)m->p[3 * i + k] * unit;
        far = apart(x, origin, d);
        if (pass == 1) {
            normal_to(along[0], d, c);
            for (k = 0; k < 3; k++) x[k] = 0.0;
            far = apart(c, x, d);
        } else if (pass == 2) {
            far = fabs(d[0] * along[1][0] + d[1] * along[1][1] +
                       d[2] * along[1][2]);
        }
        if (far <= *most) continue;
        *most = far;
        found = i;
    }
    return found;
}

int find_plane(const mesh *m)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    double largest = 0.0, unit, far[3], x[3], d[3], length;
    tess_int i;
    int j, k, power;

    if (m->in->axes == 2) return 1;
    for (i = 0; i < 3 * m->in->n; i++)
        if (fabs((double)m->p[i]) > largest) largest = fabs((double)m->p[i]);
    frexp(largest, &power);
    unit = ldexp(1.0, power < -1000 ? 1000 : -power);
    for (k = 0; k < 3; k++) origin[k] = (double)m->p[k] * unit;
    for (k = 0; k < 2; k++) {
        i = farthest(m, unit, k, far + k);
        if (far[k] <= (k == 0 ? 0.0 : 8.0 * DBL_EPSILON * far[0])) return 0;
        for (j = 0; j < 3; j++) x[j] = (double)m->p[3 * i + j] * unit;
        length = apart(x, origin, d);
        if (k == 1) {
            normal_to(along[0], d, x);
            length = apart(x, zero, d);
        }
        for (j = 0; j < 3; j++) along[k][j] = d[j] / length;
    }
    farthest(m, unit, 2, far + 2);
    if (m->ntet > 0 &&
        (far[2] > THIN * far[1] ||
         far[2] > ROUNDINGS * largest * unit *
                      (sizeof *m->p < sizeof(double) ? (double)FLT_EPSILON
                                                     : DBL_EPSILON)))
        return 0;
    axis[0] = -1;
    for (k = 0; k < 3; k++) {
        origin[k] = (double)m->p[k];
        if (fabs(along[1][k]) != 1.0) continue;
        axis[0] = k == 0;
        axis[1] = 2 - (k == 2);
    }
    for (k = 0; k < 3; k++) x[k] = along[1][k];
    normal_to(x, along[0], along[1]);
    return 1;
}

void to_plane(const tess_real *x, tess_real *foot)
{
    double at[2];
    int j, k;

    for (j = 0; j < 2; j++) {
        at[j] = axis[0] < 0 ? 0.0 : (double)x[axis[j]];
        for (k = 0; k < 3 && axis[0] < 0; k++)
            at[j] += along[j][k] * ((double)x[k] - origin[k]);
    }
    for (j = 0; j < 2; j++) foot[j] = (tess_real)at[j];
    foot[2] = 0;
}

int lay_flat(mesh *m, tess_int n, tess_real *p, int telling)
{
    const int narrow = sizeof *p < sizeof(double);
    double extent = 0.0, d, off;
    tess_int t, v[4], a[4];
    int code, apex, power, from, k;

    for (t = 0; t < 3 * n; t++) {
        d = fabs((double)p[t] - (double)p[t % 3]);
        if (d > extent) extent = d;
    }
    frexp(extent, &power);
    power += OFF;
    if (power > (narrow ? FLT_MAX_EXP : DBL_MAX_EXP) - 4)
        power = (narrow ? FLT_MAX_EXP : DBL_MAX_EXP) - 4;
    off = ldexp(1.0, power);
    for (k = 0; k < 6; k++) p[3 * n + k] = k % 3 < 2 ? p[k % 3] : 0;
    p[3 * n + 2] = (tess_real)off;
    p[3 * n + 5] = (tess_real)-off;
    code = tetrahedralize(m, n + 2, p, telling);
    m->p = p;
    m->flat = 1;
    for (t = 0; t < m->ntet; t++) {
        /* the far point last, so that what is computed from the first one, a
         * weight, has small differences; an even permutation */
        for (k = 0; k < 4; k++) {
            v[k] = m->tet[4 * t + k];
            a[k] = m->adj[4 * t + k];
        }
        for (apex = 0; v[apex] < n; apex++) continue;
        for (k = 0; k < 4; k++) {
            from = apex == 3 ? k
                   : k == 3  ? apex
                             : (apex + 1 + (apex == 1 ? k : 2 - k)) % 4;
            m->tet[4 * t + k] = v[from];
            m->adj[4 * t + k] = a[from];
        }
    }
    return code;
}

/* ---- natural neighbours ---- */

/* Linear weights are taken where areas are in doubt by this part of them. */
#define DOUBT 1e-8

/* centre - of the circle through a, b and the origin: c[0], c[1], from o; and
 * in c[2] what it is in doubt by. */
static void centre(const double *a, const double *b, const double *o, double *c)
{
    double s = a[0] * a[0] + a[1] * a[1], t = b[0] * b[0] + b[1] * b[1];
    double det = 2.0 * (a[0] * b[1] - a[1] * b[0]), size;

    c[0] = (s * b[1] - t * a[1]) / det;
    c[1] = (t * a[0] - s * b[0]) / det;
    size = fabs(c[0]) + fabs(c[1]);
    c[2] = 8.0 * DBL_EPSILON *
           (size * (1.0 + sqrt(s) * sqrt(t) / fabs(det)) + fabs(o[0]) +
            fabs(o[1]));
    c[0] += o[0];
    c[1] += o[1];
}

/* turn - the area of the parallelogram of a and b; *doubt grows. */
static double turn(const double *a, const double *b, double *doubt)
{
    *doubt += (fabs(a[0]) + fabs(a[1])) * b[2] +
              (fabs(b[0]) + fabs(b[1])) * a[2];
    return a[0] * b[1] - a[1] * b[0];
}

/* seen_from - x - q, of point i. */
static void seen_from(const tess_real *q, const tess_real *p, tess_int i,
                      double *x)
{
    int k;

    for (k = 0; k < 2; k++) x[k] = (double)p[3 * i + k] - (double)q[k];
}

/* around - the centre of the circle of the tetrahedron v's triangle. */
static void around(const tess_real *q, const tess_real *p, const tess_int *v,
                   double *c)
{
    double a[2], b[2], o[2];

    seen_from(p + 3 * v[0], p, v[1], a);
    seen_from(p + 3 * v[0], p, v[2], b);
    seen_from(q, p, v[0], o);
    centre(a, b, o, c);
}

/* (The triangles whose circles hold q are all seen from it, and their vertices
 * are its neighbours: a tree, walked depth first, has these in their order.
 * What q's cell takes from neighbour j's is a polygon: from the centre c of the
 * circle through q and neighbours j - 1 and j to the next such one, and back by
 * the centres o of the triangles at j.) */
int natural_flat(const tess_real *p, const tess_int *tet, const tess_int *adj,
                 const tess_real *q, tess_int t, tess_int most, tess_int *nn,
                 tess_int *nbr, double *weight, tess_int *iw, double *rw)
{
    static const double zero[2] = {0.0, 0.0};
    tess_int *at = iw, *from = at + most, *sides = from + most;
    tess_int depth = 0, j = 0;
    const tess_int *v;
    double *o = rw, a[2], b[2], c[3], first[3] = {0.0}, last[3] = {0.0};
    double doubt = 0.0, whole = 0.0;
    int k;

    *nn = 0;
    at[0] = t;
    from[0] = sides[0] = 0;
    around(q, p, tet + 4 * t, o);
    weight[0] = 0.0;
    while (depth >= 0) {
        if (sides[depth] == 3) {
            if (--depth >= 0) weight[j] += turn(o - 3, o, &doubt);
            o -= 3;
            continue;
        }
        v = tet + 4 * at[depth];
        k = (int)(from[depth] + sides[depth]++) % 3;
        t = adj[4 * at[depth] + k];
        if (t != TESS_NONE &&
            hh_insphere(p + 3 * tet[4 * t], p + 3 * tet[4 * t + 1],
                        p + 3 * tet[4 * t + 2], p + 3 * tet[4 * t + 3],
                        q) == 1) {
            if (depth + 1 == most) return TESS_POOL;
            for (k = 0; adj[4 * t + k] != at[depth];) k++;
            at[++depth] = t;
            from[depth] = (tess_int)k;
            sides[depth] = 1;
            o += 3;
            around(q, p, tet + 4 * t, o);
            weight[j] += turn(o, o - 3, &doubt);
            continue;
        }
        if (j == most) return TESS_POOL;
        nbr[j] = v[(k + 1) % 3];
        seen_from(q, p, nbr[j], a);
        seen_from(q, p, v[(k + 2) % 3], b);
        centre(a, b, zero, c);
        for (k = 0; k < 3 && j == 0; k++) first[k] = last[k] = c[k];
        weight[j] += turn(last, c, &doubt);
        weight[j] += turn(c, o, &doubt);
        weight[++j] = turn(o, c, &doubt);
        for (k = 0; k < 3; k++) last[k] = c[k];
    }
    weight[0] += weight[j] + turn(last, first, &doubt);
    for (t = 0; t < j; t++) whole += weight[t];
    for (t = 0; t < j; t++) weight[t] /= whole;
    if (doubt < DOUBT * fabs(whole)) *nn = j;
    return 0;
}
