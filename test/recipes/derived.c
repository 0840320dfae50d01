/* derived.c - what can be had from tet and adj: recipes to copy.
 *
 * Each routine stands for itself: it needs p, tet and adj, the caller's arrays
 * for its result, and what is named with it.  Open facets of an unfinished
 * result count as hull.  Duplicates (iw[i] != i) are in no tetrahedron.
 *
 *   tr_edges     each edge once, and a tetrahedron that has it   (turn)
 *   tr_faces     each facet once, and the tetrahedra on both sides
 *   tr_stars     for each point the tetrahedra that have it, in compressed rows
 *   tr_nearest   the point of p nearest to another one        (tr_stars' rows)
 *   tr_measure   volume, circumcentre and circumradius of a tetrahedron
 *                (minus, dot, cross, shrink, circle, centre)
 *   tr_dual      area of each edge's dual face and volume of each point's cell
 *                in the Voronoi diagram          (turn, and tr_measure's six)
 *   tr_gradient  of a field linear on each tetrahedron    (minus, dot, cross)
 *
 * derived.f is the same in FORTRAN 77.
 */
#include <float.h>
#include <math.h>

#include "recipes.h"

/* ---- tr_edges ---- */

/* turn - about the edge a b, from tetrahedron *t across its facet opposite to
 * its vertex number *out, which is neither a nor b.  On return *t is the
 * neighbour, and *out where to go on; or *t < 0: the hull. */
static void turn(const tess_int *tet, const tess_int *adj, tess_int a,
                 tess_int b, tess_int *t, int *out)
{
    const tess_int *v = tet + 4 * *t;
    tess_int stays;
    int k = 0;

    while (k == *out || v[k] == a || v[k] == b) k++;
    stays = v[k];
    *t = adj[4 * *t + *out];
    if (*t < 0) return;
    for (*out = 0; tet[4 * *t + *out] != stays; ++*out) continue;
}

/* The edges of a tetrahedron i j k l: i to j, and k to l counter-clockwise
 * about it. */
static const int around[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                 {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};

/* tr_edges - each edge once: in the ring of tetrahedra about it the first one
 * tells of it.
 *
 *   ntet, tet, adj  (in)  a mesh, as from tess
 *   maxedg  (in)   edges that there is room for
 *   nedge   (out)  number of edges
 *   edge    (out)  2*maxedg: the two points of each
 *   at      (out)  maxedg: a tetrahedron that has it
 *
 * returns 0, or TESS_MORE: nedge is then the number needed.  n random points
 * have about 7.8 n edges.
 * Cost: each edge's ring, of about 5 tetrahedra, once for each of them. */
int tr_edges(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxedg, tess_int *nedge, tess_int *edge, tess_int *at)
{
    tess_int t, s, a, b;
    int e, side, out;

    *nedge = 0;
    for (t = 0; t < ntet; t++)
        for (e = 0; e < 6; e++) {
            a = tet[4 * t + around[e][0]];
            b = tet[4 * t + around[e][1]];
            /* to one side, and where that ends at the hull to the other */
            for (side = 2, s = -1; side < 4 && s < 0; side++) {
                s = t;
                out = around[e][side];
                do turn(tet, adj, a, b, &s, &out);
                while (s > t);
            }
            if (s >= 0 && s < t) continue;
            if (*nedge < maxedg) {
                edge[2 * *nedge] = a;
                edge[2 * *nedge + 1] = b;
                at[*nedge] = t;
            }
            ++*nedge;
        }
    return *nedge > maxedg ? TESS_MORE : 0;
}

/* ---- tr_faces ---- */

/* tr_faces - each facet once, with the tetrahedra that have it.
 *
 *   ntet, tet, adj  (in)  a mesh, as from tess
 *   maxfac  (in)   faces that there is room for; 4*ntet always suffice
 *   nface   (out)  number of faces
 *   face    (out)  3*maxfac: its vertices, counter-clockwise as seen from
 *                  outside of the first tetrahedron
 *   both    (out)  2*maxfac: the first tetrahedron and the other one, or
 *                  TESS_NONE on the hull
 *
 * returns 0, or TESS_MORE: nface is then the number needed.
 * Cost: one pass. */
int tr_faces(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxfac, tess_int *nface, tess_int *face, tess_int *both)
{
    static const int facet[4][3] = {
        {1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    tess_int t, u;
    int i, k;

    *nface = 0;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u >= 0 && u < t) continue;
            if (*nface < maxfac) {
                for (i = 0; i < 3; i++)
                    face[3 * *nface + i] = tet[4 * t + facet[k][i]];
                both[2 * *nface] = t;
                both[2 * *nface + 1] = u < 0 ? TESS_NONE : u;
            }
            ++*nface;
        }
    return *nface > maxfac ? TESS_MORE : 0;
}

/* ---- stars, nearest point ---- */

/* tr_stars - for each point the tetrahedra that have it.
 *
 *   n, ntet, tet  (in)  number of points, and a mesh of them
 *   first   (out)  n + 1: those of point i are list[first[i]] ...
 *                  list[first[i+1] - 1], in ascending order; none for a
 *                  duplicate
 *   list    (out)  4*ntet
 *
 * Cost: two passes. */
void tr_stars(tess_int n, tess_int ntet, const tess_int *tet, tess_int *first,
              tess_int *list)
{
    tess_int i;

    for (i = 0; i <= n; i++) first[i] = 0;
    for (i = 0; i < 4 * ntet; i++) first[tet[i]]++;
    for (i = 1; i <= n; i++) first[i] += first[i - 1];
    /* each row is filled from its end, and its end becomes its beginning */
    for (i = (tess_int)(4 * ntet - 1); i >= 0; i--)
        list[--first[tet[i]]] = i / 4;
}

/* tr_nearest - the point of p nearest to q.
 *
 *   p, tet       (in)  points and mesh
 *   first, list  (in)  as tr_stars gives them
 *   q            (in)  the place: 3 coordinates
 *   v            (in)  where to start: a point of some tetrahedron, best a
 *                      vertex of the one that tess_locate finds, or the last
 *                      answer
 *
 * returns the point.  From v it goes to ever nearer neighbours: in a Delaunay
 * tetrahedralization the point that has no nearer neighbour is the nearest.
 * Cost: the stars of the points on the way, about 24 tetrahedra each. */
tess_int tr_nearest(const tess_real *p, const tess_int *tet,
                    const tess_int *first, const tess_int *list,
                    const tess_real *q, tess_int v)
{
    double least = DBL_MAX, d, x;
    tess_int from, i, found = v, w;
    int j, k;

    do {
        from = found;
        for (i = first[from]; i < first[from + 1]; i++)
            for (k = 0; k < 4; k++) {
                w = tet[4 * list[i] + k];
                for (d = 0.0, j = 0; j < 3; j++) {
                    x = (double)p[3 * w + j] - (double)q[j];
                    d += x * x;
                }
                if (d >= least) continue;
                least = d;
                found = w;
            }
    } while (found != from);
    return found;
}

/* ---- measures ---- */

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

/* shrink - three vectors to a length of about 1: products of many of 1e100
 * or 1e-100 would be beyond doubles.  Returns the unit, a power of two. */
static double shrink(double e[3][3])
{
    double most = 0.0, unit;
    int k;

    for (k = 0; k < 9; k++)
        if (fabs(e[k / 3][k % 3]) > most) most = fabs(e[k / 3][k % 3]);
    frexp(most, &k);
    unit = ldexp(1.0, k);
    for (k = 0; k < 9; k++) e[k / 3][k % 3] /= unit;
    return unit;
}

/* circle - centre of the circle through 0, u, v. */
static void circle(const double *u, const double *v, double *middle)
{
    double normal[3], x[3], size;
    int k;

    cross(u, v, normal);
    size = 2.0 * dot(normal, normal);
    for (k = 0; k < 3; k++)
        x[k] = (dot(u, u) * v[k] - dot(v, v) * u[k]) / size;
    cross(x, normal, middle);
}

/* centre - of the ball through 0, u, v, w.  Of four points that are in one
 * plane but for rounding a ball's centre cannot be told; that of the circle
 * through three of them will do. */
static void centre(const double *u, const double *v, const double *w,
                   double *c)
{
    double vw[3], wu[3], uv[3], det;
    int k;

    cross(v, w, vw);
    cross(w, u, wu);
    cross(u, v, uv);
    det = dot(u, vw);
    if (det <= 1e-13 * sqrt(dot(u, u) * dot(v, v) * dot(w, w))) {
        circle(u, v, c);
        return;
    }
    for (k = 0; k < 3; k++)
        c[k] = (dot(u, u) * vw[k] + dot(v, v) * wu[k] + dot(w, w) * uv[k]) /
               (2.0 * det);
}

/* tr_measure - a tetrahedron's volume and circumsphere.
 *
 *   p, v     (in)   points, and the 4 vertices
 *   volume   (out)  positive in a mesh, but for rounding
 *   middle   (out)  3: the circumcentre; of vertices that are coplanar but for
 *                   rounding, that of the circle through three of them
 *   radius   (out)  its radius
 *
 * For a circumsphere that is right to rounding: tess_ball. */
void tr_measure(const tess_real *p, const tess_int *v, double *volume,
                double *middle, double *radius)
{
    double e[3][3], c[3], unit;
    int k;

    for (k = 0; k < 3; k++) minus(p + 3 * v[k + 1], p + 3 * v[0], e[k]);
    cross(e[1], e[2], c);
    *volume = dot(e[0], c) / 6.0;
    unit = shrink(e);
    centre(e[0], e[1], e[2], c);
    for (k = 0; k < 3; k++) middle[k] = (double)p[3 * v[0] + k] + c[k] * unit;
    *radius = sqrt(dot(c, c)) * unit;
}

/* ---- the Voronoi diagram ---- */

/* tr_dual - for finite volumes: what lies between the cells of two points, and
 * the cells.
 *
 *   n, p, tet, adj   (in)   points and mesh
 *   nedge, edge, at  (in)   as tr_edges gives them
 *   area    (out)  nedge: of the face between the cells of the edge's points
 *   cell    (out)  n: volumes
 *   outer   (out)  n: 1 for a point on the hull, whose cell has no end.  Its
 *                  volume is the part in its tetrahedra, and so are the areas
 *                  of edges on the hull: pieces count as negative where a
 *                  centre is beyond the hull, so that the volumes' sum is the
 *                  hull's in any case.  All others are exact but for rounding.
 *                  A volume at the hull may be huge or negative, as those of
 *                  102 of the 144 hull points of 30,000 random ones: if that
 *                  hurts take tr_clipped, of cells.c
 *
 * A tetrahedron's piece of the face: from the edge's middle to the centres of
 * the two facets at it, and from these to the tetrahedron's own.  A cell is
 * made of pyramids from its point to its faces.
 * Cost: each edge's ring once. */
void tr_dual(tess_int n, const tess_real *p, const tess_int *tet,
             const tess_int *adj, tess_int nedge, const tess_int *edge,
             const tess_int *at, double *area, double *cell, tess_int *outer)
{
    double e[3][3], c[3], f[2][3], x[3], length, unit;
    tess_int i, a, b, t;
    int j, k, side, out;

    for (i = 0; i < n; i++) {
        cell[i] = 0.0;
        outer[i] = 0;
    }
    for (i = 0; i < nedge; i++) {
        a = edge[2 * i];
        b = edge[2 * i + 1];
        minus(p + 3 * b, p + 3 * a, x);
        length = sqrt(dot(x, x));
        area[i] = 0.0;
        for (side = 2, t = -1; side < 4 && t < 0; side++) {
            t = at[i];
            for (j = 0; tet[4 * t + around[j][0]] != a ||
                        tet[4 * t + around[j][1]] != b;)
                j++;
            out = around[j][side];
            /* the first tetrahedron was on the first side already */
            if (side == 3) turn(tet, adj, a, b, &t, &out);
            while (t >= 0) {
                const tess_int *s = tet + 4 * t;

                /* the edge from s[j] = a to b, or from b to a */
                for (j = 0; (s[around[j][0]] != a || s[around[j][1]] != b) &&
                            (s[around[j][0]] != b || s[around[j][1]] != a);)
                    j++;
                k = s[around[j][0]] == b;
                minus(p + 3 * b, p + 3 * a, e[0]);
                minus(p + 3 * s[around[j][2 + k]], p + 3 * a, e[1]);
                minus(p + 3 * s[around[j][3 - k]], p + 3 * a, e[2]);
                unit = shrink(e);
                circle(e[0], e[1], f[0]);
                circle(e[0], e[2], f[1]);
                centre(e[0], e[1], e[2], c);
                for (k = 0; k < 3; k++) {
                    f[0][k] -= f[1][k];
                    c[k] -= e[0][k] / 2.0;
                }
                /* from a quadrangle's diagonals */
                cross(f[0], c, x);
                area[i] += dot(x, e[0]) / (2.0 * length / unit) * unit * unit;
                turn(tet, adj, a, b, &t, &out);
                if (t == at[i]) break;
            }
        }
        if (t < 0) outer[a] = outer[b] = 1;
        cell[a] += area[i] * length / 6.0;
        cell[b] += area[i] * length / 6.0;
    }
}

/* ---- gradients ---- */

/* tr_gradient - of a field that is linear on a tetrahedron.
 *
 *   p, v   (in)   points, and the 4 vertices
 *   value  (in)   value[i] is that of point i
 *   g      (out)  3: the derivatives by x, y, z.  In flat tetrahedra they are
 *                 often far steeper than the field: tr_slopes has better */
void tr_gradient(const tess_real *p, const tess_int *v, const double *value,
                 double *g)
{
    double e[3][3], c[3], det;
    int i, k;

    for (k = 0; k < 3; k++) {
        minus(p + 3 * v[k + 1], p + 3 * v[0], e[k]);
        g[k] = 0.0;
    }
    cross(e[1], e[2], c);
    det = dot(e[0], c);
    for (i = 0; i < 3; i++) {
        cross(e[(i + 1) % 3], e[(i + 2) % 3], c);
        for (k = 0; k < 3; k++)
            g[k] += (value[v[i + 1]] - value[v[0]]) * c[k] / det;
    }
}
