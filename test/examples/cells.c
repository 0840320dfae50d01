/* cells.c - Voronoi cells, clipped to a box, and alpha shapes: recipes to copy.
 *
 *   cc -O2 -I. -o cells test/examples/cells.c tess.c hhpred.c -lm
 *
 *   cell      the Voronoi cell of a point: a polyhedron, its vertices, faces
 *             and neighbours, its volume; clipped to a box  (stars, meet)
 *   clipped   for finite volumes: all cells' volumes, and the areas of their
 *             faces, clipped to a box                       (cell)
 *   alpha     the part of the mesh whose tetrahedra have small balls, and its
 *             boundary
 *
 * The main program tests them.  cells.f is the same in FORTRAN 77.  With
 * CELLS_ALONE defined, cell and alpha alone, for build/tess.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "tess.h"

/* ---- cell ---- */

/* stars - for each point the tetrahedra that have it, as in derived.c.
 *
 *   first   (out)  n + 1: those of point i are list[first[i]] ...
 *                  list[first[i+1] - 1]
 *   list    (out)  4*ntet
 *
 * returns 0, or TESS_BAD_INDEX. */
static int stars(tess_int n, tess_int ntet, const tess_int *tet,
                 tess_int *first, tess_int *list)
{
    tess_int i;

    for (i = 0; i < 4 * ntet; i++)
        if (tet[i] < 0 || tet[i] >= n) return TESS_BAD_INDEX;
    for (i = 0; i <= n; i++) first[i] = 0;
    for (i = 0; i < 4 * ntet; i++) first[tet[i]]++;
    for (i = 1; i <= n; i++) first[i] += first[i - 1];
    for (i = 4 * ntet - 1; i >= 0; i--) list[--first[tet[i]]] = i / 4;
    return 0;
}

static double most3(const double *a)
{
    double b = fabs(a[0]);

    if (fabs(a[1]) > b) b = fabs(a[1]);
    return fabs(a[2]) > b ? fabs(a[2]) : b;
}

/* meet - the common point x of three planes, normal.x = offset, of which it is
 * known that it lies between u and v, near the latter's share s.  The planes
 * give it to rounding of the offsets over their determinant, u and v to that of
 * their distance: the better one is taken. */
static void meet(const double *a, const double *b, const double *c,
                 const double *u, const double *v, double s, double *x)
{
    double bc[3], ca[3], ab[3], d[3], h[3], det;
    int k, l, m;

    for (k = 0; k < 3; k++) {
        l = (k + 1) % 3;
        m = (k + 2) % 3;
        bc[k] = b[l] * c[m] - b[m] * c[l];
        ca[k] = c[l] * a[m] - c[m] * a[l];
        ab[k] = a[l] * b[m] - a[m] * b[l];
        d[k] = v[k] - u[k];
        x[k] = u[k] + s * d[k];
    }
    h[0] = a[3];
    h[1] = b[3];
    h[2] = c[3];
    det = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    if (s > 0.0 && most3(h) < fabs(det) * most3(d))
        for (k = 0; k < 3; k++)
            x[k] = (h[0] * bc[k] + h[1] * ca[k] + h[2] * ab[k]) / det;
}

/* cell - the Voronoi cell of point i: what is nearer to it than to any other.
 *
 *   p, tet, adj, first, list  (in)  points, mesh, and stars of it
 *   i       (in)   the point
 *   box     (in)   lower x, y, z and upper x, y, z: the cell is clipped to
 *                  it.  box[0] > box[3]: not at all.  Need not hold the point
 *   most    (in)   faces that there is room for; 8 more than tetrahedra at i
 *                  suffice
 *   nface   (out)  number of faces
 *   whose   (out)  most: the neighbour across each, or -1 ... -6 for the box's
 *                  side at lower x, y, z, upper x, y, z
 *   area    (out)  most: of each face
 *   volume  (out)  of the cell
 *   start   (out)  most + 1: face f has the vertices corner[start[f]] ...
 *                  corner[start[f+1] - 1], seen counter-clockwise from outside
 *   corner  (out)  6*most
 *   nvert   (out)  number of vertices: circumcentres, and where the box cuts
 *   vert    (out)  9*most: vertex v is vert[3*v] ...; the first 3*nvert are set
 *   iwork   (out)  12*most tess_ints
 *   work    (out)  7*most doubles
 *
 * returns 0; TESS_MORE when most is too small: nface is then a number that
 * suffices; 2 for a cell that has no end, or none that rounding can tell, and
 * there is no box; TESS_BAD_OPEN at an open facet.  A duplicate has no
 * tetrahedra: its cell is that of iw[i], and nface = 0, volume = 0 here.
 * Cost: some 25 microseconds in a cloud; O(m^2) for m neighbours.
 *
 * The box, or one that is made larger until nothing is left of its sides, is
 * cut by the plane midway to each neighbour, the nearest first.  A vertex is
 * kept as the three planes a, b, c that meet there, counter-clockwise seen from
 * outside: its neighbour along the edge of a and b has b before a.  So what is
 * cut off is known by the vertices' signs alone, and the rest stays a closed
 * surface, whatever rounding does; new vertices are on edges between old ones.
 * Vertices that a plane passes within 1e-13 of their distance stay, so that a
 * plane that only touches the cell, as in a lattice, cuts nothing; at the end
 * vertices that agree to 1e-12 become one, and faces of fewer than three go.  A
 * vertex is known to rounding over the angles between its planes: where two
 * points are 1e-7 apart, others' faces end between them to 1e-9; what one cell
 * loses by that its neighbour gains. */
static int cell(const tess_real *p, const tess_int *tet, const tess_int *adj,
                const tess_int *first, const tess_int *list, tess_int i,
                const double *box, tess_int most, tess_int *nface,
                tess_int *whose, double *area, double *volume,
                tess_int *start, tess_int *corner, tess_int *nvert,
                double *vert, tess_int *iwork, double *work)
{
    tess_int *tri = iwork, *same = iwork + 9 * most, planes = 6, many = 8;
    tess_int j, t, u, v, a, b, c, old;
    double *plane = work, *d = work + 4 * most, e[3], x[3], r, s, limit;
    int open = !(box[0] <= box[3]), k, l, cut;

    *nface = *nvert = 0;
    *volume = 0.0;
    start[0] = 0;
    if (first[i + 1] == first[i]) return 0;
    if (most < first[i + 1] - first[i] + 8) {
        *nface = first[i + 1] - first[i] + 8;
        return TESS_MORE;
    }
    /* neighbours, by insertion; while here plane[4*a+3] is the distance */
    for (j = first[i]; j < first[i + 1]; j++) {
        t = list[j];
        for (k = 0; k < 4; k++) {
            v = tet[4 * t + k];
            if (v == i) continue;
            if (adj[4 * t + k] == TESS_OPEN) return TESS_BAD_OPEN;
            if (adj[4 * t + k] < 0 && open) return 2;
            for (a = 6; a < planes && whose[a] != v; a++) continue;
            if (a < planes) continue;
            for (l = 0; l < 3; l++)
                e[l] = (double)p[3 * v + l] - (double)p[3 * i + l];
            r = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
            for (a = planes++; a > 6 && plane[4 * a - 1] > r / 2.0; a--) {
                whose[a] = whose[a - 1];
                for (l = 0; l < 4; l++)
                    plane[4 * a + l] = plane[4 * a + l - 4];
            }
            whose[a] = v;
            for (l = 0; l < 3; l++) plane[4 * a + l] = e[l] / r;
            plane[4 * a + 3] = r / 2.0;
        }
    }
    limit = 4.0 * plane[4 * planes - 1];
again:
    many = 8;
    for (a = 0; a < 6; a++) {
        whose[a] = -1 - a;
        k = (int)(a % 3);
        for (l = 0; l < 3; l++) plane[4 * a + l] = 0.0;
        s = plane[4 * a + k] = a < 3 ? -1.0 : 1.0;
        plane[4 * a + 3] =
            open ? limit : s * (box[a] - (double)p[3 * i + k]);
    }
    for (v = 0; v < 8; v++) {
        for (cut = 0, k = 0; k < 3; k++) {
            a = k + (v >> k & 1 ? 3 : 0);
            vert[3 * v + k] = plane[4 * a + k] * plane[4 * a + 3];
            cut ^= a >= 3;
            tri[3 * v + k] = a;
        }
        if (cut) continue;
        tri[3 * v + 1] = tri[3 * v];
        tri[3 * v] = a = (v & 2 ? 4 : 1);
    }
    for (j = 6; j < planes && many > 0; j++) {
        const double *cutter = plane + 4 * j;

        for (cut = 0, v = 0; v < many; v++) {
            const double *y = vert + 3 * v;

            d[v] = y[0] * cutter[0] + y[1] * cutter[1] + y[2] * cutter[2] -
                   cutter[3];
            if (d[v] <= 1e-13 * most3(y))
                d[v] = d[v] < 0.0 ? d[v] : 0.0;
            else
                cut = 1;
        }
        if (!cut) continue;
        old = many;
        for (v = 0; v < old; v++)
            for (k = 0; d[v] > 0.0 && k < 3; k++) {
                a = tri[3 * v + k];
                b = tri[3 * v + (k + 1) % 3];
                for (u = 0; u < old; u++) {
                    for (l = 0; l < 3; l++)
                        if (tri[3 * u + l] == b &&
                            tri[3 * u + (l + 1) % 3] == a)
                            break;
                    if (l < 3) break;
                }
                if (u == old || d[u] > 0.0 || many >= 3 * most) continue;
                meet(plane + 4 * a, plane + 4 * b, cutter, vert + 3 * u,
                     vert + 3 * v, -d[u] / (d[v] - d[u]), vert + 3 * many);
                tri[3 * many] = a;
                tri[3 * many + 1] = b;
                tri[3 * many + 2] = j;
                d[many++] = 0.0;
            }
        for (u = v = 0; v < many; v++) {
            if (d[v] > 0.0) continue;
            for (k = 0; k < 3; k++) {
                vert[3 * u + k] = vert[3 * v + k];
                tri[3 * u + k] = tri[3 * v + k];
            }
            u++;
        }
        many = u;
    }
    for (v = 0; v < 3 * many && open; v++)
        if (tri[v] < 6) {
            if (limit > 1e20 * plane[4 * planes - 1]) return 2;
            limit *= 1e3;
            goto again;
        }
    /* equal vertices: same[v] is the number of v among those that remain */
    for (v = 0; v < many; v++) {
        for (u = 0; u < *nvert; u++) {
            for (k = 0; k < 3; k++) e[k] = vert[3 * v + k] - vert[3 * u + k];
            if (most3(e) <= 1e-12 * most3(vert + 3 * v)) break;
        }
        same[v] = u;
        if (u == *nvert) ++*nvert;
        for (k = 0; u <= v && u == *nvert - 1 && k < 3; k++)
            vert[3 * u + k] = vert[3 * v + k];
    }
    /* each face's vertices, in order */
    for (j = 0; j < planes; j++) {
        for (v = 0; v < 3 * many && tri[v] != j; v++) continue;
        if (v == 3 * many) continue;
        old = v;
        c = start[*nface];
        do {
            u = same[v / 3];
            if (c == start[*nface] || corner[c - 1] != u) corner[c++] = u;
            a = tri[v % 3 ? v - 1 : v + 2];
            for (u = 0; u < 3 * many; u++)
                if (tri[u] == j && tri[u % 3 < 2 ? u + 1 : u - 2] == a) break;
            v = u;
        } while (v != old && v < 3 * many && c < 6 * most);
        u = start[*nface];
        while (c > u && corner[c - 1] == corner[u]) c--;
        if (c - u < 3) continue;
        for (x[0] = x[1] = x[2] = 0.0; c > ++u + 1;)
            for (k = 0; k < 3; k++) {
                const double *y = vert + 3 * corner[start[*nface]];

                l = (k + 1) % 3;
                cut = (k + 2) % 3;
                x[k] += ((vert[3 * corner[u] + l] - y[l]) *
                             (vert[3 * corner[u + 1] + cut] - y[cut]) -
                         (vert[3 * corner[u] + cut] - y[cut]) *
                             (vert[3 * corner[u + 1] + l] - y[l])) /
                        2.0;
            }
        area[*nface] = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        *volume += area[*nface] * plane[4 * j + 3] / 3.0;
        whose[*nface] = whose[j];
        start[++*nface] = c;
    }
    for (v = 0; v < 3 * *nvert; v++) vert[v] += (double)p[3 * i + v % 3];
    return 0;
}

#ifndef CELLS_ALONE
/* ---- clipped ---- */

/* clipped - for finite volumes: the Voronoi cells of all points, clipped to a
 * box that they fill.
 *
 *   n, p, tet, adj, first, list  (in)  points, mesh, and stars of it
 *   box     (in)   lower x, y, z and upper x, y, z
 *   maxrow  (in)   faces that there is room for: 16 a point in a cloud
 *   nrow    (out)  number of faces, each of which comes from both sides; but
 *                  for code -13 a most that suffices
 *   row     (out)  n + 1: the faces of point i's cell are row[i] ...
 *                  row[i+1] - 1.  A duplicate has none
 *   other   (out)  maxrow: the point across each face, or -1 ... -6 for the
 *                  box's sides, as in cell
 *   area    (out)  maxrow: of each
 *   volume  (out)  n: of the cells
 *   most    (in)   the largest number of tetrahedra at a point, and 8
 *   iwork   (out)  20*most + 1 tess_ints
 *   work    (out)  17*most doubles
 *
 * returns 0; TESS_MORE when maxrow is too small: nrow is then the number
 * needed; -7 for a box that is none; -13 when most is too small; what cell
 * returns.
 *
 * All areas and volumes are at least 0, unlike those of `dual' at the hull, and
 * the volumes' sum is the box's.  The face of i and j is at right angles to
 * p_j - p_i and midway. */
static int clipped(tess_int n, const tess_real *p, const tess_int *tet,
                   const tess_int *adj, const tess_int *first,
                   const tess_int *list, const double *box, tess_int maxrow,
                   tess_int *nrow, tess_int *row, tess_int *other,
                   double *area, double *volume, tess_int most,
                   tess_int *iwork, double *work)
{
    tess_int i, j, nface, nvert;
    int code;

    *nrow = 0;
    if (!(box[0] <= box[3])) return -7;
    for (i = 0; i < n; i++) {
        row[i] = *nrow;
        code = cell(p, tet, adj, first, list, i, box, most, &nface, iwork,
                    work, volume + i, iwork + most, iwork + 2 * most + 1,
                    &nvert, work + most, iwork + 8 * most + 1,
                    work + 10 * most);
        if (code == TESS_MORE) *nrow = nface;
        if (code != 0) return code == TESS_MORE ? -13 : code;
        for (j = 0; j < nface; j++, ++*nrow)
            if (*nrow < maxrow) {
                other[*nrow] = iwork[j];
                area[*nrow] = work[j];
            }
    }
    row[n] = *nrow;
    return *nrow > maxrow ? TESS_MORE : 0;
}

#endif
/* ---- alpha ---- */

/* alpha - the alpha shape: what is left of the hull when all tetrahedra whose
 * ball has a radius larger than a given one are eaten, from outside inwards
 * (H. Edelsbrunner, E. P. Muecke, ACM Trans. Graphics 13, 1994).
 *
 *   p, ntet, tet, adj  (in)  points and mesh
 *   radius  (in)   DBL_MAX eats nothing
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
static int alpha(const tess_real *p, tess_int ntet, const tess_int *tet,
                 const tess_int *adj, double radius, int voids, char *keep,
                 tess_int maxfac, tess_int *nfac, tess_int *fac,
                 tess_int *stack)
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

/* ---- tests ---- */

#ifndef CELLS_ALONE

#define N 1000
#define MAXTET (10 * N)
#define MAXROW (40 * N)
#define MOST 300
#define SETS 6

static tess_real p[3 * N];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static double rw[TESS_LRW(N)];
static tess_int first[N + 1], list[4 * MAXTET], whose[MOST], start[MOST + 1];
static tess_int corner[6 * MOST], iwork[20 * MOST + 1], row[N + 1];
static tess_int other[MAXROW], fac[12 * MAXTET], hull[12 * MAXTET];
static tess_int stack[MAXTET], n, ntet, nface, nvert;
static double area[MOST], vert[9 * MOST], work[17 * MOST], faces[MAXROW];
static double volume[N], box[6];
static char keep[MAXTET];
static long seed = 1;

/* random01 - a random number, 0 < x < 1: x := 16807 x mod 2^31 - 1. */
static double random01(void)
{
    seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
    if (seed < 0) seed += 2147483647;
    return (double)seed / 2147483647.0;
}

/* make - points: at random; a lattice; the same turned; at random between two
 * spheres; pairs, duplicates among them; four.  In a box about them; that of
 * the lattice so that all cells are cubes. */
static int make(int set)
{
    double x[3], r;
    int i, k, turned = set == 2;

    n = set == 5 ? 4 : set == 1 || set == 2 ? 343 : 300;
    for (i = 0; i < n; i++) {
        do
            for (k = 0; k < 3; k++) x[k] = 2.0 * random01() - 1.0;
        while (set == 3 && !(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] > 0.01));
        r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        for (k = 0; k < 3 && set == 3; k++)
            x[k] *= (1.0 + 0.2 * random01()) / (r * 1.3);
        for (k = 0; k < 3 && set == 4 && i % 2; k++)
            x[k] = (double)p[3 * i - 3 + k] + (i % 4 == 3) * 1e-7 * x[k];
        if (set == 1 || set == 2) {
            x[0] = (double)(i % 7 - 3) / 8.0;
            x[1] = (double)(i / 7 % 7 - 3) / 8.0;
            x[2] = (double)(i / 49 - 3) / 8.0;
        }
        if (turned) {
            r = x[0];
            x[0] = 0.8 * r - 0.6 * x[1];
            x[1] = 0.6 * r + 0.8 * x[1];
            r = x[1];
            x[1] = 0.96 * r - 0.28 * x[2];
            x[2] = 0.28 * r + 0.96 * x[2];
        }
        for (k = 0; k < 3; k++) p[3 * i + k] = (tess_real)x[k];
    }
    for (k = 0; k < 3; k++) {
        box[3 + k] = set == 1 ? 7.0 / 16.0 : 1.0 + 0.1 * k;
        box[k] = set == 1 ? -7.0 / 16.0 : -1.125;
    }
    return tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw) != 0 ||
           stars(n, ntet, tet, first, list) != 0;
}

static int one(tess_int i, const double *clip, double *size)
{
    return cell(p, tet, adj, first, list, i, clip, MOST, &nface, whose, area,
                size, start, corner, &nvert, vert, iwork, work);
}

static double away(const double *x, tess_int i)
{
    double a = x[0] - (double)p[3 * i], b = x[1] - (double)p[3 * i + 1];
    double c = x[2] - (double)p[3 * i + 2];

    return sqrt(a * a + b * b + c * c);
}

/* A cell is a polyhedron: Euler's formula, each edge once in both directions;
 * its vertices are as far from the point as from those across their faces, no
 * point is nearer, and none is outside the box; the faces' normals times areas
 * sum to 0. */
static int sound(tess_int i, int boxed)
{
    double sum[3] = {0.0, 0.0, 0.0}, r, d;
    tess_int f, g, a, b, j, at;
    int k, back, bad = 0;

    bad |= 2 * (nvert + nface) != 4 + start[nface];
    for (f = 0; f < nface; f++)
        for (a = start[f]; a < start[f + 1]; a++) {
            at = corner[a];
            b = corner[a + 1 < start[f + 1] ? a + 1 : start[f]];
            for (back = 0, g = 0; g < nface; g++)
                for (j = start[g]; j < start[g + 1]; j++)
                    back += corner[j] == b &&
                            corner[j + 1 < start[g + 1] ? j + 1 : start[g]] ==
                                at;
            bad |= back != 1;
            r = away(vert + 3 * at, i);
            d = 0.0;
            j = whose[f];
            if (j >= 0)
                d = away(vert + 3 * at, j) - r;
            else if (boxed)
                d = vert[3 * at + (-1 - j) % 3] - box[-1 - j];
            else
                bad = 1;
            bad |= !(fabs(d) <= 1e-11);
        }
    for (a = 0; a < nvert; a++) {
        r = away(vert + 3 * a, i);
        for (j = 0; j < n; j++) bad |= !(away(vert + 3 * a, j) >= r - 1e-11);
        for (k = 0; k < 3 && boxed; k++)
            bad |= !(vert[3 * a + k] >= box[k] - 1e-12 &&
                     vert[3 * a + k] <= box[3 + k] + 1e-12);
    }
    for (f = 0; f < nface; f++) {
        j = whose[f];
        bad |= !(area[f] >= 0.0);
        for (k = 0; k < 3; k++) {
            if (j < 0)
                d = (-1 - j) % 3 == k ? (j > -4 ? -1.0 : 1.0) : 0.0;
            else
                d = ((double)p[3 * j + k] - (double)p[3 * i + k]) /
                    (r = sqrt(pow((double)p[3 * j] - (double)p[3 * i], 2.0) +
                              pow((double)p[3 * j + 1] -
                                      (double)p[3 * i + 1], 2.0) +
                              pow((double)p[3 * j + 2] -
                                      (double)p[3 * i + 2], 2.0)));
            sum[k] += area[f] * d;
        }
    }
    for (k = 0; k < 3; k++) bad |= !(fabs(sum[k]) <= 1e-11);
    return bad;
}

/* outer - has point i a facet on the hull? */
static int outer(tess_int i)
{
    tess_int j;
    int k, yes = 0;

    for (j = first[i]; j < first[i + 1]; j++)
        for (k = 0; k < 4; k++)
            yes |= tet[4 * list[j] + k] != i && adj[4 * list[j] + k] < 0;
    return yes;
}

/* All cells, with a box and without (on the turned lattice's sides there are
 * points that rounding has put inside by 1e-17); on the lattice cubes of 1/8,
 * of six faces and eight vertices; their volumes sum to the box's. */
static int test_cell(void)
{
    static const double none[6] = {1.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    double v, u, sum, all;
    tess_int i;
    int set, k, bad = 0;

    for (set = 0; set < SETS; set++) {
        bad |= make(set);
        for (all = 1.0, k = 0; k < 3; k++) all *= box[3 + k] - box[k];
        for (sum = 0.0, i = 0; i < n; i++) {
            bad |= one(i, box, &v) != 0;
            if (iw[i] != i) {
                bad |= nface != 0 || v != 0.0;
                continue;
            }
            bad |= sound(i, 1) || !(v > 0.0);
            sum += v;
            if (set == 1)
                bad |= nface != 6 || nvert != 8 ||
                       !(fabs(v - 1.0 / 512.0) <= 1e-15);
            k = one(i, none, &u);
            bad |= outer(i) ? k != 2 : k != 0 && set != 2;
            if (k != 0) continue;
            bad |= sound(i, 0) || !(u >= v - 1e-12);
            if (set == 1 || set == 2)
                bad |= nface != 6 || nvert != 8 ||
                       !(fabs(u - 1.0 / 512.0) <= 1e-13);
        }
        bad |= !(fabs(sum - all) <= 1e-12 * all);
    }
    return bad;
}

/* The cells fill the box, and boxes that hold a part of the points or none; a
 * face is as large from both sides; the box's sides are filled. */
static int test_clipped(void)
{
    double sum, all, side[6];
    tess_int i, j, k, l, nrow;
    int set, part, m, bad = 0;

    for (set = 0; set < SETS; set++)
        for (part = 0; part < 3; part++) {
            bad |= make(set);
            if (part == 1) box[0] = 0.1;
            if (part == 2)
                for (m = 0; m < 3; m++) box[m] += 10.0, box[3 + m] += 20.0;
            bad |= clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow,
                           row, other, faces, volume, MOST, iwork, work) != 0;
            for (all = 1.0, m = 0; m < 3; m++) all *= box[3 + m] - box[m];
            for (m = 0; m < 6; m++) side[m] = 0.0;
            for (sum = 0.0, i = 0; i < n; i++) {
                sum += volume[i];
                bad |= !(volume[i] >= 0.0);
                for (j = row[i]; j < row[i + 1]; j++) {
                    bad |= !(faces[j] >= 0.0);
                    if (other[j] < 0) {
                        side[-1 - other[j]] += faces[j];
                        continue;
                    }
                    k = other[j];
                    for (l = row[k]; l < row[k + 1] && other[l] != i;) l++;
                    bad |= !(fabs((l < row[k + 1] ? faces[l] : 0.0) -
                                  faces[j]) <=
                             (set == 4 ? 1e-8 : 1e-12) * all);
                }
            }
            bad |= !(fabs(sum - all) <= 1e-12 * all);
            for (m = 0; m < 6; m++)
                bad |= !(fabs(side[m] * (box[3 + m % 3] - box[m % 3]) - all) <=
                         1e-12 * all);
        }
    return bad;
}

static double det3(const tess_int *v, tess_int o)
{
    double e[3][3];
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            e[i][k] = (double)p[3 * v[i] + k] - (double)p[3 * o + k];
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/* shape - alpha's volume, by its tetrahedra; BAD when that by the triangles is
 * another one. */
static double shape(double radius, int voids, int *bad)
{
    double sum = 0.0, by = 0.0;
    tess_int nfac, t;

    *bad |= alpha(p, ntet, tet, adj, radius, voids, keep, 4 * MAXTET, &nfac,
                  fac, stack) != 0;
    for (t = 0; t < ntet; t++)
        if (keep[t]) sum += det3(tet + 4 * t + 1, tet[4 * t]) / 6.0;
    for (t = 0; t < nfac; t++) by += det3(fac + 3 * t, 0) / 6.0;
    *bad |= !(fabs(sum - by) <= 1e-12);
    return sum;
}

/* Volumes by tetrahedra and triangles agree for every radius, and grow with it;
 * DBL_MAX gives the hull.  A lattice of cubes of edge 1/8 without 3^3 points
 * inside and 3 of an edge: of a cube that lacks a corner 5/6 remain, of one
 * that lacks two half.  Inside 8 lack one and 24 two, of 64; at the edge 2 and
 * 2. */
static int test_alpha(void)
{
    double v, w, last[2], r;
    tess_int i, j, nhull, nfac;
    int set, k, inside, bad = 0;

    for (set = 0; set < SETS; set++) {
        bad |= make(set);
        last[0] = last[1] = 0.0;
        for (r = 0.01; r < 100.0; r *= 1.5) {
            for (k = 0; k < 2; k++) {
                v = shape(r, k, &bad);
                bad |= !(v >= last[k] - 1e-12);
                last[k] = v;
            }
            bad |= !(last[1] <= last[0] + 1e-12);
        }
        for (k = 0; k < 2; k++) {
            bad |= alpha(p, ntet, tet, adj, DBL_MAX, k, keep, 4 * MAXTET,
                         &nfac, fac, stack) != 0;
            bad |= tess_hull(ntet, tet, adj, 4 * MAXTET, &nhull, hull) != 0;
            bad |= nfac != nhull;
            for (i = 0; i < 3 * nfac && !bad; i++) bad |= fac[i] != hull[i];
        }
        bad |= alpha(p, ntet, tet, adj, DBL_MAX, 0, keep, 3, &nfac, fac,
                     stack) != TESS_MORE || nfac != nhull;
    }
    make(1);
    for (i = j = 0; i < n; i++) {
        for (inside = 1, k = 0; k < 3; k++)
            inside &= fabs((double)p[3 * i + k]) < 0.2;
        inside |= (double)p[3 * i + 1] > 0.3 && (double)p[3 * i + 2] > 0.3 &&
                  fabs((double)p[3 * i]) < 0.2;
        for (k = 0; k < 3 && !inside; k++) p[3 * j + k] = p[3 * i + k];
        j += !inside;
    }
    n = j;
    bad |= tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw) != 0;
    v = shape(0.11, 0, &bad);
    w = shape(0.11, 1, &bad);
    bad |= !(fabs(v - (216.0 - 4.0 / 3.0) / 512.0) <= 1e-13);
    bad |= !(fabs(w - (216.0 - 140.0 / 3.0) / 512.0) <= 1e-13);
    return bad;
}

/* Coordinates times powers of two: volumes times their cubes. */
static int test_sizes(void)
{
    double scale, v, w;
    tess_int i;
    int j, k, bad = 0;

    for (j = -1; j < 2 && sizeof(tess_real) == sizeof(double); j += 2) {
        bad |= make(0);
        scale = ldexp(1.0, 166 * j);
        bad |= one(7, box, &v) != 0;
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 6; k++) box[k] *= scale;
        bad |= tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw,
                    TESS_LRW(N), rw) != 0 ||
               stars(n, ntet, tet, first, list) != 0;
        bad |= one(7, box, &w) != 0 ||
               !(fabs(w / scale / scale / scale - v) <= 1e-14);
        bad |= alpha(p, ntet, tet, adj, 0.3 * scale, 1, keep, 4 * MAXTET, &i,
                     fac, stack) != 0 || i < 4;
    }
    return bad;
}

/* Arrays that are too short, damaged and unfinished meshes. */
static int test_codes(void)
{
    double v;
    tess_int held, need, nrow, i;
    int bad = make(0);

    bad |= cell(p, tet, adj, first, list, 5, box, 10, &need, whose, area, &v,
                start, corner, &nvert, vert, iwork, work) != TESS_MORE;
    bad |= need > MOST ||
           cell(p, tet, adj, first, list, 5, box, need, &nface, whose, area,
                &v, start, corner, &nvert, vert, iwork, work) != 0;
    bad |= clipped(n, p, tet, adj, first, list, box, 100, &nrow, row, other,
                   faces, volume, MOST, iwork, work) != TESS_MORE;
    bad |= nrow > MAXROW ||
           clipped(n, p, tet, adj, first, list, box, nrow, &need, row, other,
                   faces, volume, MOST, iwork, work) != 0;
    bad |= clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow, row, other,
                   faces, volume, 10, iwork, work) != -13;
    box[3] = box[0] - 1.0;
    bad |= clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow, row, other,
                   faces, volume, MOST, iwork, work) != -7;
    held = tet[9];
    tet[9] = n;
    bad |= stars(n, ntet, tet, first, list) != TESS_BAD_INDEX;
    tet[9] = held;
    held = adj[9];
    adj[9] = ntet;
    bad |= alpha(p, ntet, tet, adj, 1.0, 1, keep, 4 * MAXTET, &need, fac,
                 stack) != TESS_BAD_ADJ;
    adj[9] = held;
    bad |= tess(n, p, 200, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw) != TESS_MORE;
    bad |= alpha(p, ntet, tet, adj, 1.0, 1, keep, 4 * MAXTET, &need, fac,
                 stack) != TESS_BAD_OPEN;
    bad |= stars(n, ntet, tet, first, list) != 0;
    for (need = 0, i = 0; i < n; i++)
        need += one(i, box, &v) == TESS_BAD_OPEN;
    return bad | (need == 0);
}

int main(void)
{
    static int (*const test[5])(void) = {test_cell, test_clipped, test_alpha,
                                         test_sizes, test_codes};
    static const char *const name[5] = {
        "cell: polyhedra, Voronoi's, and fill the box:   ",
        "clipped: the same from both sides, fill the box:",
        "alpha: volumes by tetrahedra and triangles:     ",
        "sizes: coordinates of 1e-50 and 1e50:           ",
        "codes: short arrays, damage, unfinished meshes: "};
    clock_t begin;
    int k, wrong, bad = 0;

    for (k = 0; k < 5; k++) {
        begin = clock();
        wrong = test[k]();
        bad |= wrong;
        printf("%s  %s\n", name[k], wrong ? "NO" : "yes");
        fprintf(stderr, "%s  %.2f s\n", name[k],
                (double)(clock() - begin) / CLOCKS_PER_SEC);
    }
    return bad != 0;
}
#endif
