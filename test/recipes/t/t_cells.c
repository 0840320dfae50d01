/* t_cells.c - cells.c's cells against what they are by definition, volumes
 * that fill boxes, and alpha shapes by tetrahedra and by triangles.
 *
 *   cc -O2 -I. -o t_cells test/recipes/t/t_cells.c test/recipes/cells.c \
 *       test/recipes/derived.c tess.c hhpred.c -lm
 *
 * Linked with twin/recipes.c it tests cells.f.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <time.h>

#include "../recipes.h"

#define N 1000
#define MAXTET (10 * N)
#define MAXROW (40 * N)
#define MOST 300
#define SETS 6

static tess_real p[3 * N];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static double rw[TESS_LRW(N)];
static tess_int first[N + 1], list[4 * MAXTET], whose[MOST], start[MOST + 1];
static tess_int corner[6 * MOST], iwork[33 * MOST + 1], row[N + 1];
static tess_int other[MAXROW], fac[12 * MAXTET], hull[12 * MAXTET];
static tess_int stack[MAXTET], n, ntet, nface, nvert;
static double area[MOST], vert[9 * MOST], work[17 * MOST], size[MAXROW];
static double volume[N], box[6];
static char left[MAXTET];
static long seed = 1;

/* mesh - of the points, and the tetrahedra at each. */
static int mesh(void)
{
    int code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw,
                    TESS_LRW(N), rw);

    if (code == 0) tr_stars(n, ntet, tet, first, list);
    return code;
}

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
        box[2 * k + 1] = set == 1 ? 7.0 / 16.0 : 1.0 + 0.1 * k;
        box[2 * k] = set == 1 ? -7.0 / 16.0 : -1.125;
    }
    return mesh();
}

static int one(tess_int i, const double *clip, double *v)
{
    return tr_cell(p, tet, adj, first, list, i, clip, MOST, &nface, whose, area,
                   v, start, corner, &nvert, vert, iwork, work);
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
                d = vert[3 * at + (-1 - j) / 2] - box[-1 - j];
            else
                bad = 1;
            bad |= !(fabs(d) <= 1e-11);
        }
    for (a = 0; a < nvert; a++) {
        r = away(vert + 3 * a, i);
        for (j = 0; j < n; j++) bad |= !(away(vert + 3 * a, j) >= r - 1e-11);
        for (k = 0; k < 3 && boxed; k++)
            bad |= !(vert[3 * a + k] >= box[2 * k] - 1e-12 &&
                     vert[3 * a + k] <= box[2 * k + 1] + 1e-12);
    }
    for (f = 0; f < nface; f++) {
        j = whose[f];
        bad |= !(area[f] >= 0.0);
        for (k = 0; k < 3; k++) {
            if (j < 0)
                d = (-1 - j) / 2 == k ? (j % 2 ? -1.0 : 1.0) : 0.0;
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
    double v, u, sum, all;
    tess_int i;
    int set, k, bad = 0;

    for (set = 0; set < SETS; set++) {
        bad |= make(set);
        for (all = 1.0, k = 0; k < 6; k += 2) all *= box[k + 1] - box[k];
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
            k = one(i, NULL, &u);
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
                for (m = 0; m < 6; m++) box[m] += m % 2 ? 20.0 : 10.0;
            bad |= tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow,
                              row, other, size, volume, MOST, iwork, work) != 0;
            for (all = 1.0, m = 0; m < 6; m += 2) all *= box[m + 1] - box[m];
            for (m = 0; m < 6; m++) side[m] = 0.0;
            for (sum = 0.0, i = 0; i < n; i++) {
                sum += volume[i];
                bad |= !(volume[i] >= 0.0);
                for (j = row[i]; j < row[i + 1]; j++) {
                    bad |= !(size[j] >= 0.0);
                    if (other[j] < 0) {
                        side[-1 - other[j]] += size[j];
                        continue;
                    }
                    k = other[j];
                    for (l = row[k]; l < row[k + 1] && other[l] != i;) l++;
                    bad |= !(fabs((l < row[k + 1] ? size[l] : 0.0) -
                                  size[j]) <=
                             (set == 4 ? 1e-8 : 1e-12) * all);
                }
            }
            bad |= !(fabs(sum - all) <= 1e-12 * all);
            for (m = 0; m < 6; m++)
                bad |= !(fabs(side[m] * (box[m / 2 * 2 + 1] -
                                         box[m / 2 * 2]) - all) <= 1e-12 * all);
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

    *bad |= tr_alpha(p, ntet, tet, adj, radius, voids, left, 4 * MAXTET, &nfac,
                     fac, stack) != 0;
    for (t = 0; t < ntet; t++)
        if (left[t]) sum += det3(tet + 4 * t + 1, tet[4 * t]) / 6.0;
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
            bad |= tr_alpha(p, ntet, tet, adj, DBL_MAX, k, left, 4 * MAXTET,
                            &nfac, fac, stack) != 0;
            bad |= tess_hull(ntet, tet, adj, 4 * MAXTET, &nhull, hull) != 0;
            bad |= nfac != nhull;
            for (i = 0; i < 3 * nfac && !bad; i++) bad |= fac[i] != hull[i];
        }
        bad |= tr_alpha(p, ntet, tet, adj, DBL_MAX, 0, left, 3, &nfac, fac,
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
    bad |= mesh();
    v = shape(0.11, 0, &bad);
    w = shape(0.11, 1, &bad);
    bad |= !(fabs(v - (216.0 - 4.0 / 3.0) / 512.0) <= 1e-13);
    bad |= !(fabs(w - (216.0 - 140.0 / 3.0) / 512.0) <= 1e-13);
    return bad;
}

/* Coordinates times powers of two: volumes and areas times theirs; or, where
 * these are beyond doubles, the code. */
static int test_sizes(void)
{
    double scale, one_area, v, w;
    tess_int i;
    int j, k, bad = 0;

    for (j = -1; j < 2 && sizeof(tess_real) == sizeof(double); j += 2) {
        bad |= make(0);
        scale = ldexp(1.0, 332 * j);
        bad |= one(7, box, &v) != 0;
        one_area = area[1];
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 6; k++) box[k] *= scale;
        bad |= mesh();
        bad |= one(7, box, &w) != 0 ||
               !(fabs(w / scale / scale / scale - v) <= 1e-14) ||
               !(fabs(area[1] / scale / scale - one_area) <= 1e-14);
        bad |= tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &i, row,
                          other, size, volume, MOST, iwork, work) != 0;
        for (w = 0.0, i = 0; i < n; i++)
            w += volume[i] / scale / scale / scale;
        for (v = 1.0, k = 0; k < 6; k += 2) v *= (box[k + 1] - box[k]) / scale;
        bad |= !(fabs(w - v) <= 1e-12 * v);
        bad |= tr_alpha(p, ntet, tet, adj, 0.3 * scale, 1, left, 4 * MAXTET, &i,
                        fac, stack) != 0 || i < 4;
        scale = ldexp(1.0, 30 * j);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 6; k++) box[k] *= scale;
        bad |= mesh() || one(7, box, &w) != 3;
        for (k = 0; k < 6; k++) box[k] = k % 2 ? 1e300 : -1e300;
        bad |= one(7, box, &w) != 3;
    }
    return bad;
}

/* Arrays that are too short, damaged and unfinished meshes. */
static int test_codes(void)
{
    double v;
    tess_int held, need, nrow, i;
    int bad = make(0);

    bad |= tr_cell(p, tet, adj, first, list, 5, box, 10, &need, whose, area, &v,
                   start, corner, &nvert, vert, iwork, work) != TESS_MORE;
    bad |= need > MOST ||
           tr_cell(p, tet, adj, first, list, 5, box, need, &nface, whose, area,
                   &v, start, corner, &nvert, vert, iwork, work) != 0;
    bad |= tr_clipped(n, p, tet, adj, first, list, box, 100, &nrow, row, other,
                      size, volume, MOST, iwork, work) != TESS_MORE;
    bad |= nrow > MAXROW ||
           tr_clipped(n, p, tet, adj, first, list, box, nrow, &need, row, other,
                      size, volume, MOST, iwork, work) != 0;
    bad |= tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow, row,
                      other, size, volume, 10, iwork, work) != -13;
    bad |= nrow > MOST ||
           tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &need, row,
                      other, size, volume, nrow, iwork, work) != 0;
    bad |= tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &need, row,
                      other, size, volume, (tess_int)(nrow - 1), iwork,
                      work) != -13 ||
           need != nrow;
    for (i = 0; i < 6; i++) {
        v = box[i];
        box[i] = i % 2 ? box[i - 1] - 1.0 : box[i + 1] + 1.0;
        bad |= one(5, box, volume) != -7 ||
               tr_clipped(n, p, tet, adj, first, list, box, MAXROW, &nrow, row,
                          other, size, volume, MOST, iwork, work) != -7;
        box[i] = v;
    }
    held = adj[9];
    adj[9] = ntet;
    bad |= tr_alpha(p, ntet, tet, adj, 1.0, 1, left, 4 * MAXTET, &need, fac,
                    stack) != TESS_BAD_ADJ;
    adj[9] = held;
    bad |= tess(n, p, 200, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw) != TESS_MORE;
    bad |= tr_alpha(p, ntet, tet, adj, 1.0, 1, left, 4 * MAXTET, &need, fac,
                    stack) != TESS_BAD_OPEN;
    tr_stars(n, ntet, tet, first, list);
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
        "sizes: coordinates of 1e-100 and 1e100:         ",
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
