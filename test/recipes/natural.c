/* natural.c - natural neighbour interpolation in space: recipes to copy.
 *
 *   tr_natural   Sibson's and Laplace's weights at any point  (minus, dot,
 *                cross, lost, below, refine, centre, slot, vertex, region,
 *                beside, mend, inside, facet)
 *   tr_blend     Sibson's smooth interpolant, from weights and gradients
 *                (minus, dot)
 *
 * natural.f is the same in FORTRAN 77; test/unit/t_natural.c tests both.
 */
#include <float.h>
#include <math.h>

#include "recipes.h"

/* ---- weights ---- */

/* Centres have lost three digits where the square of the volume by the product
 * of three squared edges is less than FLAT, and are computed with twice the
 * digits: below FLATTER by tess_ball, which takes 20 times as long.  Nothing but
 * accuracy and speed rests on it. */
#define FLAT 1e-6
#define FLATTER 1e-10

/* By centre's bound: 200 u, and the range of squares in which nothing that
 * matters underflows. */
#define SURE (100.0 * DBL_EPSILON)
#define SMALL 1e-150
#define LARGE 1e60

/* Weights are blended with linear ones where roundings are more than this part
 * of q's cell, and are linear from ten times as much on. */
#define DOUBT 1e-8

/* The facets of a tetrahedron, counter-clockwise as seen from outside. */
static const int facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

static void minus(const tess_real *a, const tess_real *b, double *c)
{
    int k;

    for (k = 0; k < 3; k++) c[k] = (double)a[k] - (double)b[k];
}

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

/* lost - a + b - x, exactly, where x is the rounded sum. */
static double lost(double a, double b, double x)
{
    double z = x - a;

    return (a - (x - z)) + (b - z);
}

/* below - a * b - x, exactly, where x is the rounded product (T. J. Dekker,
 * Numerische Mathematik 18, 1971). */
static double below(double a, double b, double x)
{
    double s = 134217729.0 * a, t = 134217729.0 * b;
    double high = s - (s - a), top = t - (t - b);

    return ((high * top - x) + high * (b - top) + (a - high) * top) +
           (a - high) * (b - top);
}

/* refine - c, the centre as seen from vertex o: with e the edges from there,
 * what is left of e.(e - 2 c), in twice the digits, is made 0. */
static void refine(const tess_real *p, const tess_int *v, int o,
                   const double e[3][3], const double f[3][3], double det,
                   double *c)
{
    double left[3], a, b, g, s, t, x;
    int i, k;

    for (i = 0; i < 3; i++) {
        for (s = t = 0.0, k = 0; k < 3; k++) {
            a = (double)p[3 * v[(o + i + 1) & 3] + k];
            b = -(double)p[3 * v[o] + k];
            g = e[i][k] - 2.0 * c[k];
            x = e[i][k] * g;
            t += below(e[i][k], g, x) +
                 e[i][k] * lost(e[i][k], -2.0 * c[k], g) +
                 (e[i][k] + g) * lost(a, b, e[i][k]) + lost(s, x, s + x);
            s += x;
        }
        left[i] = s + t;
    }
    for (k = 0; k < 3; k++)
        c[k] += (left[0] * f[0][k] + left[1] * f[1][k] + left[2] * f[2][k]) /
                (2.0 * det);
}

/* centre - of the ball of the tetrahedron v, as seen from q: c[0] to c[2].  In
 * c[3] the power of q, negative inside.  Returns 1 if its sign is sure.
 *
 * With e the edges from vertex o, L the product of their lengths, T the sum, u
 * half an epsilon and d = p_o - q: roundings of det are below 16 u L, of the
 * numerators below 14 u L T; with r = L / det, which is 1 or more, those of the
 * centre are below 28 u T r^2, and those of the power below
 * u |d| (7 |d| + 62 T r^2), if nothing underflows. */
static int centre(const tess_real *p, const tess_int *v, const tess_real *q,
                  double *c)
{
    double e[3][3], f[3][3], d[3] = {0.0, 0.0, 0.0}, square[3], ball[4];
    double det, s, r, all, least = 0.0;
    int i, k, o = 0, sure = 0;

    /* from the vertex next to q: the power there is right to rounding */
    for (i = 0; i < 4; i++) {
        minus(p + 3 * v[i], q, e[0]);
        s = dot(e[0], e[0]);
        if (i > 0 && s >= least) continue;
        least = s;
        for (k = 0; k < 3; k++) d[k] = e[0][k];
        o = i;
    }
    for (i = 0; i < 3; i++) {
        minus(p + 3 * v[(o + i + 1) & 3], p + 3 * v[o], e[i]);
        square[i] = dot(e[i], e[i]);
    }
    cross(e[1], e[2], f[0]);
    cross(e[2], e[0], f[1]);
    cross(e[0], e[1], f[2]);
    det = dot(e[0], f[0]);
    r = square[0] * square[1] * square[2];
    all = square[0] + square[1] + square[2];
    if (det * det > FLATTER * r) {
        for (k = 0; k < 3; k++)
            c[k] = (square[0] * f[0][k] + square[1] * f[1][k] +
                    square[2] * f[2][k]) / (2.0 * det);
        sure = det * det > FLAT * r;
        if (!sure)
            refine(p, v, o, (const double(*)[3])e, (const double(*)[3])f, det,
                   c);
    } else {
        tess_ball(p, v, ball);
        for (k = 0; k < 3; k++) c[k] = ball[k] - (double)p[3 * v[o] + k];
    }
    c[3] = least + 2.0 * dot(d, c);
    for (k = 0; k < 3; k++) c[k] += d[k];
    if (!sure || !(r > SMALL && least > SMALL && least + all < LARGE))
        return 0;
    r /= det * det;
    return fabs(c[3]) > SURE * sqrt(least * (least + all * r * r));
}

/* slot - in a table with open addressing the place of the number i for which
 * key[i] = k, or the empty one where it belongs. */
static tess_int slot(tess_int size, const tess_int *table, const tess_int *key,
                     tess_int k)
{
    tess_int i = k % size;

    while (table[i] >= 0 && key[table[i]] != k) i = (tess_int)((i + 1) % size);
    return i;
}

/* vertex - x, where q's Voronoi cell ends on an edge of the diagram without q:
 * the edge that crosses facet k of the tetrahedron v, from its centre c, whose
 * ball holds q, to the centre n, whose ball does not.  Along it q's power is
 * linear, negative at the one end and not at the other, but for rounding: so
 * what is divided is never larger than what it is divided by, wherever q is.
 * On the hull, n = 0, the edge goes on along the facet's normal, and q's power
 * grows by twice the distance from the facet's plane. */
static void vertex(const tess_real *p, const tess_int *v, int k,
                   const double *n, const tess_real *q, const double *c,
                   double *x)
{
    double power = c[3] < 0.0 ? c[3] : 0.0, rise, s, t = DBL_MAX;
    double a[3], b[3], way[3] = {0.0, 0.0, 0.0};
    tess_int i;
    int h;

    if (n) {
        rise = (n[3] > 0.0 ? n[3] : 0.0) - power;
        for (k = 0; k < 3; k++) way[k] = n[k] - c[k];
    } else {
        /* the normal: at the vertex between the two shortest edges */
        for (h = 0; h < 3; h++) {
            i = v[facet[k][h]];
            minus(p + 3 * v[facet[k][(h + 1) % 3]], p + 3 * i, a);
            minus(p + 3 * v[facet[k][(h + 2) % 3]], p + 3 * i, b);
            s = dot(a, a) * dot(b, b);
            if (s >= t) continue;
            t = s;
            cross(a, b, way);
        }
        minus(p + 3 * v[facet[k][0]], q, a);
        rise = 2.0 * dot(a, way);
    }
    s = power < 0.0 ? power / rise : 0.0;
    for (k = 0; k < 3; k++) x[k] = c[k] - (power < 0.0 ? s * way[k] : 0.0);
}

/* region - the tetrahedra whose balls hold q, breadth first from list[0].
 *
 *   nlist   (out)  their number, and list they are
 *   side    (out)  4 each: the number in list of the neighbour, or -1 - b at
 *                  facet b of the region's boundary, of 2 nlist + 2 at most
 *   corner  (out)  4 each: the numbers in nbr of the vertices
 *   c       (out)  4 each: as centre gives them
 *   x       (out)  3 for each facet of the boundary: as vertex gives it
 *   nn      (out)  number of vertices, and nbr they are; at most nlist + 3
 *   table   (out)  2*size
 *
 * returns 0 or a code of tr_natural. */
static int region(const tess_real *p, tess_int ntet, const tess_int *tet,
                  const tess_int *adj, const tess_real *q, tess_int most,
                  tess_int *nlist, tess_int *list, tess_int *side,
                  tess_int *corner, double *c, double *x, tess_int *nn,
                  tess_int *nbr, tess_int size, tess_int *table)
{
    const tess_int *v, *w;
    double n[4];
    tess_int i, m, s, u, nout = 0;
    int in, h, j, k;

    for (i = 0; i < 2 * size; i++) table[i] = -1;
    table[list[0] % size] = 0;
    *nlist = 1;
    for (k = 0; k < 4; k++) {
        i = size + slot(size, table + size, nbr, tet[4 * list[0] + k]);
        if (table[i] >= 0) return -4;
        nbr[*nn] = tet[4 * list[0] + k];
        corner[k] = table[i] = (*nn)++;
        side[k] = most;
    }
    centre(p, tet + 4 * list[0], q, c);
    for (m = 0; m < *nlist; m++)
        for (k = 0; k < 4; k++) {
            /* (most: not yet known) */
            if (side[4 * m + k] < most) continue;
            u = adj[4 * list[m] + k];
            if (u == TESS_OPEN) return TESS_BAD_OPEN;
            if (u < TESS_OPEN || u >= ntet) return -4;
            v = tet + 4 * list[m];
            if (u < 0) {
                vertex(p, v, k, 0, q, c + 4 * m, x + 3 * nout);
                side[4 * m + k] = -1 - nout++;
                continue;
            }
            for (j = 0; j < 4 && adj[4 * u + j] != list[m]; j++) continue;
            if (j == 4) return -4;
            i = slot(size, table, list, u);
            s = table[i];
            if (s >= 0) {
                side[4 * m + k] = s;
                side[4 * s + j] = m;
                continue;
            }
            w = tet + 4 * u;
            in = centre(p, w, q, n)
                     ? n[3] < 0.0
                     : hh_insphere(p + 3 * w[0], p + 3 * w[1], p + 3 * w[2],
                                   p + 3 * w[3], q);
            if (in > 1) return TESS_RANGE;
            if (in < 1) {
                vertex(p, v, k, n, q, c + 4 * m, x + 3 * nout);
                side[4 * m + k] = -1 - nout++;
                continue;
            }
            if (*nlist == most) return TESS_POOL;
            s = (*nlist)++;
            list[s] = u;
            table[i] = s;
            side[4 * m + k] = s;
            /* its vertices are those of the facet, and w[j] */
            for (i = 0; i < 4; i++) {
                c[4 * s + i] = n[i];
                side[4 * s + i] = i == j ? m : most;
                if (i == j) continue;
                for (h = 0; h < 4 && v[h] != w[i]; h++) continue;
                if (h == 4) return -4;
                corner[4 * s + i] = corner[4 * m + h];
            }
            i = size + slot(size, table + size, nbr, w[j]);
            if (table[i] < 0) {
                nbr[*nn] = w[j];
                table[i] = (*nn)++;
            }
            corner[4 * s + j] = table[i];
        }
    return 0;
}

/* beside - at an edge of a facet of the boundary the other facet: about the
 * edge from m to the last tetrahedron of the region.  The edge is that without
 * the vertices k, opposite to the facet, and o of m. */
static tess_int beside(tess_int nlist, const tess_int *side,
                       const tess_int *corner, tess_int m, int k, int o)
{
    tess_int s, stays = corner[4 * m + k], steps;

    for (steps = 0; side[4 * m + o] >= 0 && steps < nlist; steps++) {
        s = side[4 * m + o];
        for (k = 0; k < 3 && side[4 * s + k] != m; k++) continue;
        for (o = 0; o < 3 && corner[4 * s + o] != stays; o++) continue;
        stays = corner[4 * s + k];
        m = s;
    }
    return side[4 * m + o] < 0 ? -1 - side[4 * m + o] : 0;
}

/* mend - make q the mean of the points by the weights w, to rounding: each
 * weight times 1 - b.(y - m), where y is the point as seen from q, m the mean
 * of these and b what it takes.  Returns 1 where a weight would be changed by
 * more than half: it was nothing but roundings. */
static int mend(tess_int nn, const double *y, double *w)
{
    double m[3], b[3], d[3], c[3][3], f[3], s, size;
    tess_int i;
    int j, k, pass;

    for (pass = 0; pass < 5; pass++) {
        size = m[0] = m[1] = m[2] = 0.0;
        for (i = 0; i < nn; i++)
            for (k = 0; k < 3; k++) {
                m[k] += w[i] * y[3 * i + k];
                size += w[i] * fabs(y[3 * i + k]);
            }
        if (fabs(m[0]) + fabs(m[1]) + fabs(m[2]) <= 1e-14 * size) return 0;
        for (j = 0; j < 9; j++) c[j / 3][j % 3] = 0.0;
        for (i = 0; i < nn; i++) {
            for (k = 0; k < 3; k++) d[k] = (y[3 * i + k] - m[k]) / size;
            for (j = 0; j < 9; j++)
                c[j / 3][j % 3] += w[i] * d[j / 3] * d[j % 3];
        }
        s = 1e-15 * (c[0][0] + c[1][1] + c[2][2]);
        for (k = 0; k < 3; k++) c[k][k] += s;
        for (k = 0; k < 3; k++) {
            cross(c[(k + 1) % 3], c[(k + 2) % 3], f);
            b[k] = dot(f, m) / dot(f, c[k]) / size;
        }
        for (i = 0; i < nn; i++) {
            for (k = 0; k < 3; k++) d[k] = (y[3 * i + k] - m[k]) / size;
            s = dot(b, d);
            if (!(fabs(s) <= 0.5)) return 1;
            w[i] -= w[i] * s;
        }
    }
    return 1;
}

/* inside - 1 if q is surely inside of tetrahedron t, not on its boundary. */
static int inside(const tess_real *p, tess_int ntet, const tess_int *tet,
                  const tess_real *q, tess_int t)
{
    const tess_real *x[4], *a;
    int k, in = t >= 0 && t < ntet;

    for (k = 0; k < 3 && in; k++) in = q[k] - q[k] == 0;
    for (k = 0; k < 4 && in; k++) x[k] = p + 3 * tet[4 * t + k];
    for (k = 0; k < 4 && in; k++) {
        a = x[k];
        x[k] = q;
        in = hh_orient(x[0], x[1], x[2], x[3]) == 1;
        x[k] = a;
    }
    return in;
}

/* tr_natural - Sibson's and Laplace's natural neighbour weights.
 *
 *   p, ntet, tet, adj  (in)  a result of tess with ntet >= 1
 *   q       (in)      the point: 3 coordinates
 *   t       (in,out)  as in tess_locate: where to start; the one that holds q
 *   most    (in)      tetrahedra whose balls hold q that there is room for, at
 *                     least 1; among random points 20 do, seldom more than 60
 *   nn      (out)     number of neighbours
 *   nbr     (out)     most + 3: the neighbours, points
 *   sibson, laplace  (out)  most + 3 each: their weights, in the same order
 *   iw      (out)     workspace, 13*most + 14
 *   rw      (out)     workspace, 13*most + 15
 *
 * The weights are at least 0, their sum is 1, and q, or the hull's nearest
 * point to it, is the points' mean by them, all to rounding: sum of w[k] *
 * value[nbr[k]] interpolates, and reproduces linear fields.  Sibson's: the
 * volume that q's Voronoi cell, if q were a point, would take from that of a
 * point; smooth but at the points.  Laplace's: the area of the face between q's
 * cell and the other one by the distance; smooth but on the spheres of the
 * tetrahedra.
 *
 * At a point its weight is 1.  Outside, both are those of the hull's nearest
 * point, linear on its facet.  Both turn into the linear weights of t where
 * roundings hide q's cell, by degrees from 1e-8 of it on: near the hull, where
 * Voronoi vertices are some 1e4 times as far off as the neighbours; within
 * roundings of a point; beside points that are far off; in sets that are flat;
 * and where differences of coordinates are below 1e-90 or above 1e90.  So it is
 * where only vertices of t have weights.
 *
 * returns 0; 1 outside the hull; TESS_POOL, most being too small: nothing else
 * is lost; TESS_BAD_OPEN where a facet that is open, in an unfinished result,
 * has a part in the weights; -7 for most < 1; -2, -4, -5, -6, TESS_RANGE as
 * from tess_locate.  nn is 0 but for 0 and 1.
 * Cost: 6 microseconds among random points; less than 0.37 of what CGAL takes
 * for Sibson's weights alone.
 * Source: Sibson, "A brief description of natural neighbour interpolation"
 * (1981); for Laplace's Belikov et al. (1997), Hiyoshi and Sugihara (2000).
 *
 * The part of a point's cell that q takes is bounded by parts of the cell's
 * faces, which lie half way to other points, and by the face towards q.  Its
 * volume is the sum of pyramids with the point for apex: areas times half the
 * distances, less that of the face towards q.  The faces go from vertex to
 * vertex: a segment (a, b) of that between the points i and j has, with any
 * point o of their plane, the area |det(a - o, b - o, j - i)| / 2 |j - i|.  No
 * multiple of j - i that is added to o matters: o = i will do. */
int tr_natural(const tess_real *p, tess_int ntet, const tess_int *tet,
               const tess_int *adj, const tess_real *q, tess_int *t,
               tess_int most, tess_int *nn, tess_int *nbr, double *sibson,
               double *laplace, tess_int *iw, double *rw)
{
    tess_int *list = iw, *side = list + most, *corner = side + 4 * most;
    double *c = rw, *x = c + 4 * most, *y = x + 6 * most + 6, *a, *b, *z;
    const double *from, *to;
    double w[4], e[3], f[3], g[3], n[3], way[3], s, own, longest = 0.0;
    double doubt = 0.0, all[2] = {0.0, 0.0};
    tess_int nlist = 0, i, j, m, u;
    int code, known, h, k, l;

    *nn = 0;
    if (most < 1) return -7;
    /* exact weights, which take as long as half of what follows, are found only
     * where they may be wanted */
    known = !inside(p, ntet, tet, q, *t);
    code = known ? tess_locate(p, ntet, tet, adj, q, t, w) : 0;
    if (code != 0 && code != 1) return code;
    for (k = 0; k < 4; k++)
        if (code == 1 && adj[4 * *t + k] == TESS_OPEN) return TESS_BAD_OPEN;
    /* what holds q has it in its ball, if q is none of the points */
    if (code == 0 && (!known || (w[0] < 1.0 && w[1] < 1.0 && w[2] < 1.0 &&
                                 w[3] < 1.0))) {
        list[0] = *t;
        code = region(p, ntet, tet, adj, q, most, &nlist, list, side, corner, c,
                      x, nn, nbr, (tess_int)(2 * most + 7), corner + 4 * most);
        if (code != 0) {
            *nn = 0;
            return code;
        }
    }
    for (i = 0; i < *nn; i++) {
        minus(p + 3 * nbr[i], q, y + 3 * i);
        s = dot(y + 3 * i, y + 3 * i);
        if (s > longest) longest = s;
        sibson[i] = laplace[i] = 0.0;
    }
    /* each facet of the region, its three edges, and the face across each: as
     * seen from o, (a - o) x (b - o) is (a - o) x (b - a) */
    for (m = 0; m < nlist; m++) {
        a = c + 4 * m;
        own = dot(a, a);
        for (k = 0; k < 4; k++) {
            u = side[4 * m + k];
            if (u >= 0 && u < m) continue;
            b = u < 0 ? x - 3 * (u + 1) : c + 4 * u;
            doubt += own + dot(b, b);
            for (l = 0; l < 3; l++) way[l] = b[l] - a[l];
            j = corner[4 * m + facet[k][2]];
            to = y + 3 * j;
            for (h = 0; h < 3; h++) {
                i = j;
                from = to;
                j = corner[4 * m + facet[k][h]];
                to = y + 3 * j;
                for (l = 0; l < 3; l++) {
                    e[l] = to[l] - from[l];
                    f[l] = a[l] - from[l];
                }
                cross(f, way, n);
                s = dot(n, e);
                if (u < 0 && i < j) {
                    /* the face's edge on q's cell, from b to z */
                    z = x + 3 * beside(nlist, side, corner, m, k,
                                       facet[k][(h + 1) % 3]);
                    for (l = 0; l < 3; l++) {
                        f[l] = b[l] - from[l];
                        g[l] = z[l] - b[l];
                    }
                    cross(f, g, n);
                    s += dot(n, e);
                    cross(z, b, n);
                    laplace[i] += dot(n, from);
                    laplace[j] -= dot(n, to);
                }
                sibson[i] += s;
                sibson[j] += s;
            }
        }
    }
    for (i = 0; i < *nn; i++) {
        sibson[i] -= laplace[i];
        laplace[i] /= dot(y + 3 * i, y + 3 * i);
        if (sibson[i] < 0.0) sibson[i] = 0.0;
        if (laplace[i] < 0.0) laplace[i] = 0.0;
        all[0] += sibson[i];
        all[1] += laplace[i];
    }
    /* the part that is linear: all of it where there is nothing, or no number.
     * Of w the vertices are the first four corners */
    s = 1.0;
    if (all[0] > 0.0 && all[1] > 0.0 && all[0] <= DBL_MAX &&
        all[1] <= DBL_MAX) {
        doubt *= DBL_EPSILON * sqrt(longest);
        s = (doubt / all[0] / DOUBT - 1.0) / 9.0;
    }
    for (i = 0; i < *nn && s < 1.0; i++) {
        sibson[i] /= all[0];
        laplace[i] /= all[1];
    }
    s = s < 1.0 && mend(*nn, y, sibson) == 0 && mend(*nn, y, laplace) == 0
            ? s : 1.0;
    if (s > 0.0 && !known) tess_locate(p, ntet, tet, adj, q, t, w);
    if (s == 1.0) {
        for (*nn = 4, k = 0; k < 4; k++) {
            nbr[k] = tet[4 * *t + k];
            sibson[k] = laplace[k] = w[k];
        }
    } else if (s > 0.0) {
        for (i = 0; i < *nn; i++) {
            sibson[i] -= s * sibson[i];
            laplace[i] -= s * laplace[i];
        }
        for (k = 0; k < 4; k++) {
            sibson[corner[k]] += s * w[k];
            laplace[corner[k]] += s * w[k];
        }
    }
    return code;
}

/* ---- interpolation ---- */

/* tr_blend - Sibson's interpolant: it has the values and the gradients that are
 * given at the points, and no kinks.
 *
 *   nn, nbr, w  (in)  as tr_natural gives them; w Sibson's weights.  Laplace's
 *                     leave kinks on the spheres of the tetrahedra
 *   value   (in)   value[i] is that of point i
 *   g       (in)   g[3*i+k]: gradient at point i
 *
 * returns the value at the point of the weights, which is q, or for q outside
 * the hull's nearest point.  Fields a + b.x + c |x|^2 are reproduced.
 * Cost: 15 square roots.  Source: Sibson (1981). */
double tr_blend(const tess_real *p, tess_int nn, const tess_int *nbr,
                const double *w, const double *value, const double *g)
{
    double at[3] = {0.0, 0.0, 0.0}, d[3], r, plane;
    double linear = 0.0, slopes = 0.0, inverse = 0.0, first = 0.0, second = 0.0;
    tess_int i;
    int k;

    for (i = 0; i < nn; i++) {
        minus(p + 3 * nbr[i], p + 3 * nbr[0], d);
        for (k = 0; k < 3; k++) at[k] += w[i] * d[k];
    }
    for (i = 0; i < nn; i++) {
        minus(p + 3 * nbr[0], p + 3 * nbr[i], d);
        for (k = 0; k < 3; k++) d[k] += at[k];
        r = sqrt(dot(d, d));
        if (r == 0.0) return value[nbr[i]];
        plane = value[nbr[i]] + dot(g + 3 * nbr[i], d);
        linear += w[i] * value[nbr[i]];
        slopes += w[i] / r * plane;
        inverse += w[i] / r;
        first += w[i] * r;
        second += w[i] * r * r;
    }
    /* the weights of the two: first / inverse and second */
    return (first * linear + second * slopes) / (first + second * inverse);
}
