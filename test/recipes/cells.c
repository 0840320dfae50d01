/* cells.c - Voronoi cells, clipped to a box, and alpha shapes: recipes to copy.
 *
 *   tr_cell      the Voronoi cell of a point: a polyhedron, its vertices, faces
 *                and neighbours, its volume; clipped to a box
 *                (tr_stars' rows; proper, most3, norm, height, neighbours,
 *                begin, meet, flood, divide, cut, along, measured, numbered,
 *                outlined, closed)
 *   tr_clipped   for finite volumes: all cells' volumes, and the areas of their
 *                faces, clipped to a box      (tr_stars' rows; proper, tr_cell)
 *   tr_alpha     the part of the mesh whose tetrahedra have small
 *                circumspheres, and its boundary
 *
 * tr_stars is of derived.c.  t_cells.c tests them; cells.f is the same in
 * FORTRAN 77.
 */
#include <math.h>
#include <stddef.h>

#include "recipes.h"

/* ---- tr_cell ---- */

/* Coordinates less than this can be added, and multiplied by 1e10. */
#define FARTHEST 1e290

/* proper - 1 for a box. */
static int proper(const double *box)
{
    return box[0] <= box[1] && box[2] <= box[3] && box[4] <= box[5];
}

static double most3(const double *a)
{
    double b = fabs(a[0]);

    if (fabs(a[1]) > b) b = fabs(a[1]);
    return fabs(a[2]) > b ? fabs(a[2]) : b;
}

/* norm - the length of a, whose square may be beyond doubles. */
static double norm(const double *a)
{
    double most = most3(a), x, y, z;

    if (!(most > 0.0)) return most;
    x = a[0] / most;
    y = a[1] / most;
    z = a[2] / most;
    return most * sqrt(x * x + y * y + z * z);
}

/* height - of x over a plane, that is a unit normal and an offset. */
static double height(const double *plane, const double *x)
{
    return x[0] * plane[0] + x[1] * plane[1] + x[2] * plane[2] - plane[3];
}

/* neighbours - the planes midway from point i to its neighbours, the nearest
 * first, behind the box's six; with tr_cell's arguments and codes. */
static int neighbours(const tess_real *p, const tess_int *tet,
                      const tess_int *adj, const tess_int *first,
                      const tess_int *list, tess_int i, int open,
                      tess_int *planes, tess_int *whose, double *plane)
{
    tess_int a, j, t, v;
    double e[3], r;
    int k, l;

    *planes = 6;
    for (j = first[i]; j < first[i + 1]; j++) {
        t = list[j];
        for (k = 0; k < 4; k++) {
            v = tet[4 * t + k];
            if (v == i) continue;
            if (adj[4 * t + k] == TESS_OPEN) return TESS_BAD_OPEN;
            if (adj[4 * t + k] < 0 && open) return 2;
            for (a = 6; a < *planes && whose[a] != v; a++) continue;
            if (a < *planes) continue;
            for (l = 0; l < 3; l++)
                e[l] = (double)p[3 * v + l] - (double)p[3 * i + l];
            r = norm(e);
            if (!(r > 0.0 && r < FARTHEST)) return 3;
            for (a = *planes; a > 6 && plane[4 * a - 1] > r / 2.0; a--) {
                whose[a] = whose[a - 1];
                for (l = 0; l < 4; l++)
                    plane[4 * a + l] = plane[4 * a + l - 4];
            }
            ++*planes;
            whose[a] = v;
            for (l = 0; l < 3; l++) plane[4 * a + l] = e[l] / r;
            plane[4 * a + 3] = r / 2.0;
        }
    }
    return 0;
}

/* begin - a box, by its sides' offsets outwards; as cut describes it. */
static void begin(const double *side, double *plane, double *vert,
                  tess_int *tri, tess_int *next)
{
    tess_int a, v, bit;
    int k, m, odd;

    for (a = 0; a < 6; a++) {
        for (k = 0; k < 3; k++) plane[4 * a + k] = 0.0;
        plane[4 * a + a / 2] = a % 2 ? 1.0 : -1.0;
        plane[4 * a + 3] = side[a];
    }
    /* The upper sides of corner v are the bits set in it.  The order x, y, z is
     * counter-clockwise where their number is odd. */
    for (v = 0; v < 8; v++) {
        odd = (int)((v + v / 2 + v / 4) % 2);
        for (k = 0; k < 3; k++) {
            m = odd || k == 2 ? k : 1 - k;
            bit = (tess_int)(1 << m);
            a = (tess_int)(2 * m + (v / bit) % 2);
            vert[3 * v + m] = a % 2 ? side[a] : -side[a];
            tri[3 * v + k] = a;
            next[3 * v + (k + 1) % 3] = (tess_int)(a % 2 ? v - bit : v + bit);
        }
    }
}

/* meet - the point x where an edge crosses a plane, over which its ends u and v
 * are hu and hv high: at[0] and at[1] are the edge's planes, at[2] is that one.
 *
 * What lies between u and v is in the planes but for roundings of u and v.
 * Newton's steps make them roundings of x, which may be much smaller.  A step
 * longer than those is not taken: where planes are nearly parallel it would
 * lead out of the polyhedron. */
static void meet(const double *const *at, const double *u, const double *v,
                 double hu, double hv, double *x)
{
    double n[3][3], y[3], e[3], h[3], det, s, size, left;
    int i, k, l, m, step;

    s = hv > hu ? hv / (hv - hu) : 0.0;
    if (s < 0.0) s = 0.0;
    if (s > 1.0) s = 1.0;
    size = most3(u) > most3(v) ? most3(u) : most3(v);
    for (k = 0; k < 3; k++) /* from the nearer end */
        x[k] = most3(u) < size ? u[k] + (1.0 - s) * (v[k] - u[k])
                               : v[k] + s * (u[k] - v[k]);
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++) {
            l = (k + 1) % 3;
            m = (k + 2) % 3;
            n[i][k] = at[(i + 1) % 3][l] * at[(i + 2) % 3][m] -
                      at[(i + 1) % 3][m] * at[(i + 2) % 3][l];
        }
        h[i] = height(at[i], x);
    }
    det = at[0][0] * n[0][0] + at[0][1] * n[0][1] + at[0][2] * n[0][2];
    left = most3(h);
    for (step = 0; step < 3 && left > 2e-16 * most3(x); step++) {
        for (k = 0; k < 3; k++) {
            e[k] = (h[0] * n[0][k] + h[1] * n[1][k] + h[2] * n[2][k]) / det;
            y[k] = x[k] - e[k];
        }
        for (i = 0; i < 3; i++) h[i] = height(at[i], y);
        if (!(most3(e) <= 1e-14 * size && most3(h) < left)) return;
        left = most3(h);
        for (k = 0; k < 3; k++) x[k] = y[k];
    }
}

/* flood - give v, and what its mark connects to it, another mark. */
static void flood(const tess_int *next, tess_int v, tess_int to,
                  tess_int *mark, tess_int *queue)
{
    tess_int many = 1, from = mark[v], u;
    int k;

    queue[0] = v;
    mark[v] = to;
    while (many > 0)
        for (v = queue[--many], k = 0; k < 3; k++) {
            u = next[3 * v + k];
            if (mark[u] != from) continue;
            mark[u] = to;
            queue[many++] = u;
        }
}

/* divide - the vertices, of heights d over a plane: mark 3 for what it cuts
 * off, 2 for what stays.  Those as near to it as a part, band, of their
 * distance stay; or go, where band is less than 0.  Returns the largest part by
 * which one is on the wrong side.
 *
 * A plane divides the vertices of a convex polyhedron into two parts, each
 * connected by edges.  So what is connected to the lowest vertex stays, and of
 * all others what is connected to the highest one goes. */
static double divide(tess_int many, const double *vert, const tess_int *next,
                     const double *d, double band, tess_int *mark,
                     tess_int *queue)
{
    tess_int low = -1, high = -1, v;
    double reach, size, wrong = 0.0;

    for (v = 0; v < many; v++) {
        mark[v] = d[v] > band * most3(vert + 3 * v);
        if (mark[v] == 0 && (low < 0 || d[v] < d[low])) low = v;
        if (mark[v] == 1 && (high < 0 || d[v] > d[high])) high = v;
    }
    if (low >= 0) flood(next, low, 2, mark, queue);
    for (v = 0; v < many; v++)
        if (mark[v] == 0) mark[v] = 1;
    if (high >= 0) flood(next, high, 3, mark, queue);
    for (v = 0; v < many; v++) {
        if (mark[v] == 1) mark[v] = 2;
        reach = mark[v] == 3 ? -d[v] : d[v];
        size = most3(vert + 3 * v);
        if (reach > wrong * size) wrong = reach / size;
    }
    return wrong;
}

/* cut - what a polyhedron has beyond a plane is taken away.
 *
 *   plane   (in)      planes, 4 each: a unit normal outwards and its offset
 *   j       (in)      the one that cuts
 *   many    (in,out)  number of vertices
 *   vert    (in,out)  their coordinates
 *   tri     (in,out)  3 a vertex: the planes a, b, c that meet there, counter-
 *                     clockwise seen from outside
 *   next    (in,out)  3 a vertex: where the edge of a and b leads, that of b
 *                     and c, that of c and a
 *   mark, queue, last, d   (out)  workspace
 *
 * returns 0, or 3 where roundings contradict each other.
 *
 * What is left always has the vertices, edges and faces of some convex
 * polyhedron, whatever roundings do: a plane has at most one face, two faces
 * have at most one edge in common, a face has at least three, f faces have
 * 2 f - 4 vertices; all walks end.  Vertices that the plane passes within 1e-13
 * of their distance stay, unless they connect what must go. */
static int cut(const double *plane, tess_int j, tess_int *many, double *vert,
               tess_int *tri, tess_int *next, tess_int *mark, tess_int *queue,
               tess_int *last, double *d)
{
    tess_int old = *many, now = old, u, v;
    const double *at[3];
    double wrong;
    int k, l;

    for (v = 0; v < old; v++) d[v] = height(plane + 4 * j, vert + 3 * v);
    wrong = divide(old, vert, next, d, 1e-13, mark, queue);
    if (wrong > 2e-13) wrong = divide(old, vert, next, d, -1e-13, mark, queue);
    if (wrong > 1e-12) return 3;
    for (v = 0; v < old; v++)
        for (k = 0; mark[v] == 3 && k < 3; k++) {
            u = next[3 * v + k];
            if (mark[u] == 3) continue;
            tri[3 * now] = tri[3 * v + k];
            tri[3 * now + 1] = tri[3 * v + (k + 1) % 3];
            tri[3 * now + 2] = j;
            for (l = 0; l < 3; l++) at[l] = plane + 4 * tri[3 * now + l];
            meet(at, vert + 3 * u, vert + 3 * v, d[u], d[v], vert + 3 * now);
            next[3 * now] = u;
            for (l = 0; next[3 * u + l] != v;) l++;
            next[3 * u + l] = now;
            last[tri[3 * now]] = now;
            mark[now++] = 2;
        }
    for (v = old; v < now; v++) {
        u = last[tri[3 * v + 1]];
        next[3 * v + 1] = u;
        next[3 * u + 2] = v;
    }
    /* the others move up; queue[v] is where to */
    for (*many = v = 0; v < now; v++)
        if (mark[v] != 3) queue[v] = (*many)++;
    for (v = 0; v < now; v++) {
        if (mark[v] == 3) continue;
        u = queue[v];
        for (k = 0; k < 3; k++) {
            vert[3 * u + k] = vert[3 * v + k];
            tri[3 * u + k] = tri[3 * v + k];
            next[3 * u + k] = queue[next[3 * v + k]];
        }
    }
    return 0;
}

/* along - the place in tri of a face's next vertex, counter-clockwise. */
static tess_int along(const tess_int *tri, const tess_int *next, tess_int at)
{
    tess_int to = 3 * next[at % 3 > 0 ? at - 1 : at + 2];

    while (tri[to] != tri[at]) to++;
    return to;
}

/* measured - the planes' areas, and the volume, computed in a unit; last[j] is
 * a place of plane j in tri, or -1 where it has no face. */
static double measured(tess_int planes, const double *plane, tess_int many,
                       const double *vert, const tess_int *tri,
                       const tess_int *next, double unit, tess_int *last,
                       double *area)
{
    double x[3], volume = 0.0, inverse = 1.0 / unit;
    tess_int j, v, w;
    const double *a, *b, *c;
    int k, l, m;

    for (j = 0; j < planes; j++) last[j] = -1;
    for (v = 0; v < 3 * many; v++) last[tri[v]] = v;
    for (j = 0; j < planes; j++) {
        if (last[j] < 0) continue;
        for (k = 0; k < 3; k++) x[k] = 0.0;
        a = vert + last[j] / 3 * 3;
        v = along(tri, next, last[j]);
        while ((w = along(tri, next, v)) != last[j]) {
            b = vert + v / 3 * 3;
            c = vert + w / 3 * 3;
            for (k = 0; k < 3; k++) {
                l = (k + 1) % 3;
                m = (k + 2) % 3;
                x[k] += (b[l] - a[l]) * inverse * ((c[m] - a[m]) * inverse) -
                        (b[m] - a[m]) * inverse * ((c[l] - a[l]) * inverse);
            }
            v = w;
        }
        area[j] = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) / 2.0;
        volume += area[j] * (plane[4 * j + 3] * inverse) / 3.0;
        area[j] *= unit * unit;
    }
    return volume > 0.0 ? volume * unit * unit * unit : 0.0;
}

/* numbered - the vertices' numbers; those are one that edges connect which are
 * shorter than within, times their distance.  Returns how many there are. */
static tess_int numbered(tess_int many, const double *vert,
                         const tess_int *next, double within, tess_int *same,
                         tess_int *queue)
{
    tess_int count = 0, top, t, u, v;
    double e[3];
    int k, l;

    for (v = 0; v < many; v++) same[v] = -1;
    for (v = 0; v < many; v++) {
        if (same[v] >= 0) continue;
        same[v] = count;
        queue[0] = v;
        for (top = 1; top > 0;)
            for (u = queue[--top], k = 0; k < 3; k++) {
                t = next[3 * u + k];
                if (same[t] >= 0) continue;
                for (l = 0; l < 3; l++)
                    e[l] = vert[3 * t + l] - vert[3 * u + l];
                if (!(most3(e) < within * most3(vert + 3 * u))) continue;
                same[t] = count;
                queue[top++] = t;
            }
        count++;
    }
    return count;
}

/* outlined - the faces, by their vertices' numbers, but for those of fewer than
 * three; its[f] is the plane of face f.  Returns how many there are. */
static tess_int outlined(tess_int planes, const tess_int *tri,
                         const tess_int *next, const tess_int *last,
                         const tess_int *same, tess_int *start,
                         tess_int *corner, tess_int *its)
{
    tess_int count = 0, c, j, v;

    for (j = 0; j < planes; j++) {
        if (last[j] < 0) continue;
        c = start[count];
        v = last[j];
        do {
            if (c == start[count] || corner[c - 1] != same[v / 3])
                corner[c++] = same[v / 3];
            v = along(tri, next, v);
        } while (v != last[j]);
        while (c > start[count] && corner[c - 1] == corner[start[count]]) c--;
        if (c - start[count] < 3) continue;
        its[count++] = j;
        start[count] = c;
    }
    return count;
}

/* closed - 1 if the faces are those of a polyhedron: Euler's formula holds, no
 * vertex is twice in a face, and no edge, in its direction, in two faces. */
static int closed(tess_int nvert, tess_int nface, const tess_int *start,
                  const tess_int *corner)
{
    tess_int f, g, a, b, to;

    if (2 * (nvert + nface) != 4 + start[nface]) return 0;
    for (f = 0; f < nface; f++)
        for (a = start[f]; a < start[f + 1]; a++) {
            to = corner[a + 1 < start[f + 1] ? a + 1 : start[f]];
            for (g = 0; g <= f; g++)
                for (b = start[g]; b < start[g + 1] && b < a; b++)
                    if (corner[b] == corner[a] &&
                        (g == f || to == corner[b + 1 < start[g + 1]
                                                    ? b + 1 : start[g]]))
                        return 0;
        }
    return 1;
}

/* tr_cell - the Voronoi cell of point i: what is nearer to it than to any
 * other.
 *
 *   p, tet, adj, first, list  (in)  points, mesh, and stars of it
 *   i       (in)   the point
 *   box     (in)   x0, x1, y0, y1, z0, z1: the cell is clipped to what is
 *                  between; need not hold the point.  A null pointer: not
 *                  clipped
 *   most    (in)   faces that there is room for; 8 more than tetrahedra at i
 *                  suffice
 *   nface   (out)  number of faces
 *   whose   (out)  most: the neighbour across each, or -1 ... -6 for the box's
 *                  side at x0, x1, y0, y1, z0, z1
 *   area    (out)  most: of each face
 *   volume  (out)  of the cell
 *   start   (out)  most + 1: face f has the vertices corner[start[f]] ...
 *                  corner[start[f+1] - 1], seen counter-clockwise from outside
 *   corner  (out)  6*most
 *   nvert   (out)  number of vertices: circumcentres, and where the box cuts
 *   vert    (out)  9*most: vertex v is vert[3*v] ...; the first 3*nvert are set
 *   iwork   (out)  25*most tess_ints
 *   work    (out)  7*most doubles
 *
 * returns 0; TESS_MORE when most is too small: nface is then a number that
 * suffices; 2 where there is no box and the cell has no end, or one some 1e9
 * times as far away as neighbours, which rounding does not tell; 3 where
 * rounding leaves no polyhedron, where the cell's farthest vertex is less than
 * 1e-102 or more than 1e102 away, so that a double does not hold the volume, or
 * a neighbour or the box reaches farther than 1e290; TESS_BAD_OPEN at an open
 * facet; -7 for a box with x0 > x1, or a NaN.  A duplicate has no tetrahedra:
 * its cell is that of iw[i], and nface = 0, volume = 0 here.
 * Cost: some 25 microseconds among random points; O(m^2) for m neighbours.
 *
 * The box, or one that is made larger until nothing is left of its sides, is
 * cut by the plane midway to each neighbour, the nearest first; the farthest
 * first where roundings contradict each other in that order.  All vertices of
 * what is left are in their planes, and beyond none, but for roundings
 * of its size: so its volume is right but for those times its surface, although
 * a vertex is known to those over the angles between its planes only: where two
 * points are 1e-7 apart, others' faces end between them to 1e-9.  A plane that
 * only touches the cell, as in a lattice, cuts nothing, and at the end edges
 * shorter than 1e-13 of their distance shrink to a vertex, and faces of fewer
 * than three go, unless the rest would be no polyhedron. */
int tr_cell(const tess_real *p, const tess_int *tet, const tess_int *adj,
            const tess_int *first, const tess_int *list, tess_int i,
            const double *box, tess_int most, tess_int *nface, tess_int *whose,
            double *area, double *volume, tess_int *start, tess_int *corner,
            tess_int *nvert, double *vert, tess_int *iwork, double *work)
{
    tess_int *tri = iwork, *next = iwork + 9 * most, *same = iwork + 18 * most;
    tess_int *queue = iwork + 21 * most, *last = iwork + 24 * most;
    tess_int planes, many, j, v, a;
    double *plane = work, *d = work + 4 * most, side[6], limit, within;
    double reach = 0.0;
    int open = box == NULL, outer, order, code, k;

    *nface = *nvert = 0;
    *volume = 0.0;
    start[0] = 0;
    if (!open && !proper(box)) return -7;
    if (first[i + 1] == first[i]) return 0;
    if (most < first[i + 1] - first[i] + 8) {
        *nface = (tess_int)(first[i + 1] - first[i] + 8);
        return TESS_MORE;
    }
    code = neighbours(p, tet, adj, first, list, i, open, &planes, whose, plane);
    if (code != 0) return code;
    limit = 4.0 * plane[4 * planes - 1];
    do {
        for (a = 0; a < 6; a++) {
            whose[a] = (tess_int)(-1 - a);
            side[a] = limit;
            if (open) continue;
            side[a] = box[a] - (double)p[3 * i + a / 2];
            if (a % 2 == 0) side[a] = -side[a];
            if (!(fabs(side[a]) < FARTHEST)) return 3;
        }
        for (code = 3, order = 0; order < 2 && code != 0; order++) {
            begin(side, plane, vert, tri, next);
            code = 0;
            for (many = 8, j = 6; j < planes && many > 0 && code == 0; j++)
                code = cut(plane, (tess_int)(order == 0 ? j : planes + 5 - j),
                           &many, vert, tri, next, same, queue, last, d);
        }
        if (code != 0) return open ? 2 : code;
        outer = open && many == 0;
        for (v = 0; v < 3 * many && open; v++) outer |= tri[v] < 6;
        limit *= 16.0;
        if (outer && limit > 1e10 * plane[4 * planes - 1]) return 2;
    } while (outer);
    for (v = 0; v < many; v++)
        if (most3(vert + 3 * v) > reach) reach = most3(vert + 3 * v);
    if (reach > 0.0 && !(reach > 1e-102 && reach < 1e102)) return 3;
    /* a power of two, which alters nothing else: small products are not lost
     * where subnormal numbers are flushed to 0 */
    frexp(reach, &k);
    *volume = measured(planes, plane, many, vert, tri, next, ldexp(1.0, k),
                       last, area);
    for (within = 1e-13;; within = 0.0) {
        *nvert = numbered(many, vert, next, within, same, queue);
        *nface = outlined(planes, tri, next, last, same, start, corner, queue);
        if (*nvert == many || closed(*nvert, *nface, start, corner)) break;
    }
    for (j = 0; j < *nface; j++) {
        area[j] = area[queue[j]];
        whose[j] = whose[queue[j]];
    }
    for (a = v = 0; v < many; v++) {
        if (same[v] != a) continue;
        for (k = 0; k < 3; k++)
            vert[3 * a + k] = vert[3 * v + k] + (double)p[3 * i + k];
        a++;
    }
    return 0;
}

/* ---- tr_clipped ---- */

/* tr_clipped - for finite volumes: the Voronoi cells of all points, clipped to
 * a box that they fill.
 *
 *   n, p, tet, adj, first, list  (in)  points, mesh, and stars of it
 *   box     (in)   x0, x1, y0, y1, z0, z1
 *   maxrow  (in)   faces that there is room for: 16 a point of random ones
 *   nrow    (out)  number of faces, each of which comes from both sides; but
 *                  for code -13 the least most that suffices
 *   row     (out)  n + 1: the faces of point i's cell are row[i] ...
 *                  row[i+1] - 1.  A duplicate has none
 *   other   (out)  maxrow: the point across each face, or -1 ... -6 for the
 *                  box's sides, as in tr_cell
 *   area    (out)  maxrow: of each
 *   volume  (out)  n: of the cells
 *   most    (in)   the largest number of tetrahedra at a point, plus 8
 *   iwork   (out)  33*most + 1 tess_ints
 *   work    (out)  17*most doubles
 *
 * returns 0; TESS_MORE when maxrow is too small: nrow is then the number
 * needed; -13 when most is too small; what tr_cell returns.
 *
 * All areas and volumes are at least 0, unlike those of tr_dual at the hull,
 * and the volumes' sum is the box's.  The face of i and j is at right angles to
 * p_j - p_i and midway. */
int tr_clipped(tess_int n, const tess_real *p, const tess_int *tet,
               const tess_int *adj, const tess_int *first, const tess_int *list,
               const double *box, tess_int maxrow, tess_int *nrow,
               tess_int *row, tess_int *other, double *area, double *volume,
               tess_int most, tess_int *iwork, double *work)
{
    tess_int i, j, nface, nvert;
    int code;

    *nrow = 0;
    if (box == NULL || !proper(box)) return -7;
    for (i = 0; i < n; i++) {
        row[i] = *nrow;
        code = tr_cell(p, tet, adj, first, list, i, box, most, &nface, iwork,
                       work, volume + i, iwork + most, iwork + 2 * most + 1,
                       &nvert, work + most, iwork + 8 * most + 1,
                       work + 10 * most);
        if (code == TESS_MORE) {
            /* for the others, too, not only for this cell */
            for (*nrow = nface; i < n; i++)
                if (first[i + 1] - first[i] > *nrow - 8)
                    *nrow = (tess_int)(first[i + 1] - first[i] + 8);
            return -13;
        }
        if (code != 0) return code;
        for (j = 0; j < nface; j++, ++*nrow)
            if (*nrow < maxrow) {
                other[*nrow] = iwork[j];
                area[*nrow] = work[j];
            }
    }
    row[n] = *nrow;
    return *nrow > maxrow ? TESS_MORE : 0;
}

/* ---- tr_alpha ---- */

/* tr_alpha - the alpha shape: what is left of the hull when all tetrahedra
 * whose ball has a radius larger than a given one are eaten, from outside
 * inwards (H. Edelsbrunner, E. P. Muecke, ACM Trans. Graphics 13, 1994).
 *
 *   p, ntet, tet, adj  (in)  points and mesh
 *   radius  (in)   DBL_MAX eats nothing.  Compared with that of tess_ball,
 *                  which is rounded outwards: a ball of exactly this radius may
 *                  be eaten
 *   voids   (in)   0: voids that are closed stay full; 1: they are eaten, too
 *   keep    (out)  ntet: 1 for the tetrahedra that are left, 0 for others
 *   maxfac  (in)   triangles that there is room for
 *   nfac    (out)  number of triangles of the boundary
 *   fac     (out)  3*maxfac: each seen counter-clockwise from outside, in the
 *                  order of tess_hull
 *   stack   (out)  ntet tess_ints
 *
 * returns 0; TESS_MORE: nfac is then the number needed, and keep is set;
 * TESS_BAD_ADJ for a neighbour that is out of range, TESS_BAD_OPEN for an
 * unfinished mesh; what tess_ball returns.  Cost: O(ntet). */
int tr_alpha(const tess_real *p, tess_int ntet, const tess_int *tet,
             const tess_int *adj, double radius, int voids, char *keep,
             tess_int maxfac, tess_int *nfac, tess_int *fac, tess_int *stack)
{
    static const int facet[4][3] = {
        {1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    tess_int t, u, top = 0;
    double c[4];
    int i, k, code;

    *nfac = 0;
    /* 2: large, not reached yet */
    for (t = 0; t < ntet; t++) {
        code = tess_ball(p, tet + 4 * t, c);
        if (code != 0) return code;
        keep[t] = (char)(c[3] > radius ? 2 : 1);
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u == TESS_OPEN) return TESS_BAD_OPEN;
            if (u < TESS_NONE || u >= ntet) return TESS_BAD_ADJ;
            if (keep[t] < 2 || (u >= 0 && !voids)) continue;
            keep[t] = 0;
            stack[top++] = t;
        }
    }
    while (top > 0)
        for (t = stack[--top], k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u < 0 || keep[u] != 2) continue;
            keep[u] = 0;
            stack[top++] = u;
        }
    for (t = 0; t < ntet; t++) {
        if (keep[t] == 2) keep[t] = 1;
        for (k = 0; k < 4 && keep[t]; k++) {
            u = adj[4 * t + k];
            if (u >= 0 && keep[u]) continue;
            for (i = 0; i < 3 && *nfac < maxfac; i++)
                fac[3 * *nfac + i] = tet[4 * t + facet[k][i]];
            ++*nfac;
        }
    }
    return *nfac > maxfac ? TESS_MORE : 0;
}
