/* planar.c - Delaunay triangles of points in a plane: flat input, for which
 * tess returns TESS_PLANE.
 *
 *   cc -O2 -I. -o planar test/examples/planar.c tess.c hhpred.c -lm
 *
 * One more point, off the plane, whichever: the ball through it and a triangle
 * meets the plane in the triangle's circle, so the tetrahedra of all points are
 * that point and the Delaunay triangles, exactly.  The same holds for
 * triangles' neighbours, and the hull of the plane's points.
 *
 * The points must be in one plane exactly, as (x, y, 0) are.  Points that are
 * in a plane askew to the axes but for rounding: take their coordinates in
 * that plane first.
 *
 * Two sets, one of them full of cocircular points, are checked against brute
 * force: no point is inside of a triangle's circle, in whole numbers.
 */
#include <stdio.h>

#include "tess.h"

#define N 400
#define MAXTRI (2 * N) /* Euler: 2 n - 2 - points on the hull */

static tess_real p[3 * (N + 1)];
static tess_int tet[4 * MAXTRI], adj[4 * MAXTRI], iw[TESS_LIW(N + 1)];
static double rw[TESS_LRW(N + 1)];
static tess_int triangle[3 * MAXTRI], beside[3 * MAXTRI];

/* planar - the Delaunay triangles of n points (x, y, 0), counter-clockwise; p
 * has room for one point more.
 *
 *   ntri      (out)  number of triangles
 *   triangle  (out)  3 points each
 *   beside    (out)  beside[3*t+k] is the triangle across the side opposite to
 *                    triangle[3*t+k], or TESS_NONE
 *
 * returns the code of tess: TESS_PLANE when all are on one line. */
static int planar(tess_int n, tess_int *ntri)
{
    tess_int t;
    int code, apex, k;

    p[3 * n] = p[0];
    p[3 * n + 1] = p[1];
    p[3 * n + 2] = 1;
    code = tess(n + 1, p, MAXTRI, ntri, tet, adj, TESS_LIW(N + 1), iw,
                TESS_LRW(N + 1), rw);
    if (code != TESS_OK) return code;
    for (t = 0; t < *ntri; t++) {
        for (apex = 0; tet[4 * t + apex] != n; apex++) continue;
        for (k = 0; k < 3; k++) {
            /* the tetrahedron a b c d is as d sees a b c turn clockwise;
             * an odd place of the apex turns that round */
            int from = (apex + 1 + (apex % 2 ? k : 2 - k)) % 4;

            triangle[3 * t + k] = tet[4 * t + from];
            beside[3 * t + k] = adj[4 * t + from];
        }
    }
    return 0;
}

/* ---- checks, on whole coordinates below 1000: all is exact ---- */

/* turn - twice the area of a b c: positive counter-clockwise. */
static double turn(tess_int a, tess_int b, tess_int c)
{
    const tess_real *u = p + 3 * a, *v = p + 3 * b, *w = p + 3 * c;

    return ((double)v[0] - (double)u[0]) * ((double)w[1] - (double)u[1]) -
           ((double)v[1] - (double)u[1]) * ((double)w[0] - (double)u[0]);
}

/* inside - positive when d is inside of the circle of a b c. */
static double inside(tess_int a, tess_int b, tess_int c, tess_int d)
{
    double x[3], y[3], sum = 0.0;
    tess_int v[3];
    int i, j, k;

    v[0] = a;
    v[1] = b;
    v[2] = c;
    for (i = 0; i < 3; i++) {
        x[i] = (double)p[3 * v[i]] - (double)p[3 * d];
        y[i] = (double)p[3 * v[i] + 1] - (double)p[3 * d + 1];
    }
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        k = (i + 2) % 3;
        sum += (x[i] * x[i] + y[i] * y[i]) * (x[j] * y[k] - x[k] * y[j]);
    }
    return sum;
}

/* check - the triangles fill the hull, given twice its area, their circles
 * are empty, and neighbours are mutual.  Returns 1 for a fault. */
static int check(tess_int n, tess_int ntri, double area)
{
    const tess_int *v;
    tess_int i, t, u;
    int j, k, bad = 0;

    for (t = 0; t < ntri; t++) {
        v = triangle + 3 * t;
        if (!(turn(v[0], v[1], v[2]) > 0.0)) bad = 1;
        area -= turn(v[0], v[1], v[2]);
        for (i = 0; i < n; i++)
            if (inside(v[0], v[1], v[2], i) > 0.0) bad = 1;
        for (k = 0; k < 3; k++) {
            u = beside[3 * t + k];
            if (u == TESS_NONE) continue;
            for (j = 0; j < 3 && beside[3 * u + j] != t; j++) continue;
            /* the side, seen from the other triangle, runs backwards */
            if (j == 3 ||
                triangle[3 * u + (j + 1) % 3] != v[(k + 2) % 3] ||
                triangle[3 * u + (j + 2) % 3] != v[(k + 1) % 3])
                bad = 1;
        }
    }
    return bad || area > 0.0 || area < 0.0;
}

int main(void)
{
    unsigned long seed = 1;
    tess_int n = 0, ntri;
    int i, k, bad;

    /* the corners of a square, and points in it */
    for (i = 0; i < N; i++) {
        for (k = 0; k < 2; k++) {
            seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
            p[3 * i + k] = (tess_real)((seed >> 16) % 1000);
            if (i < 4) p[3 * i + k] = (tess_real)(i >> k & 1 ? 999 : 0);
        }
        p[3 * i + 2] = 0;
    }
    n = N;
    bad = planar(n, &ntri) != 0 || check(n, ntri, 2.0 * 999.0 * 999.0);
    printf("random: %ld points, %ld triangles: %s\n", (long)n, (long)ntri,
           bad ? "WRONG" : "right");

    /* a grid: four points on each circle; 2 triangles a square */
    for (i = 0; i < N; i++) {
        p[3 * i] = (tess_real)(i % 20);
        p[3 * i + 1] = (tess_real)(i / 20);
        p[3 * i + 2] = 0;
    }
    bad |= planar(n, &ntri) != 0 || check(n, ntri, 2.0 * 19.0 * 19.0) ||
           ntri != 2 * 19 * 19;
    printf("grid:   %ld points, %ld triangles: %s\n", (long)n, (long)ntri,
           bad ? "WRONG" : "right");

    /* on a line */
    for (i = 0; i < N; i++) p[3 * i + 1] = 0;
    k = planar(n, &ntri);
    printf("line:   code %d, %ld triangles\n", k, (long)ntri);
    return bad || k != TESS_PLANE;
}
