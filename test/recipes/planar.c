/* planar.c - Delaunay triangles of points in a plane, for which tess returns
 * TESS_PLANE: a recipe to copy.
 *
 * One more point, off the plane, whichever: the ball through it and a triangle
 * meets the plane in the triangle's circle, so the tetrahedra of all points are
 * that point and the Delaunay triangles, exactly.  The same holds for
 * triangles' neighbours, and the hull of the plane's points.
 *
 * The points are (x, y, 0).  Of points in a plane askew to the axes take the
 * coordinates in that plane first.
 */
#include "recipes.h"

/* tr_planar - the Delaunay triangles of n points (x, y, 0).
 *
 *   n         (in)      number of points, >= 0
 *   p         (in,out)  3*n coordinates, and room for 3 more, which are set
 *   maxtri    (in)      triangles that there is room for; 2*n suffices
 *   ntri      (out)     number of triangles; for code -2 the point that is
 *                       NaN, infinite or not in the plane z = 0
 *   triangle  (out)     4*maxtri: triangle t has the points triangle[3*t] ...
 *                       triangle[3*t+2], counter-clockwise
 *   beside    (out)     4*maxtri: beside[3*t+k] is the triangle across the side
 *                       opposite to triangle[3*t+k], or TESS_NONE
 *   liw, lrw  (in)      lengths of iw and rw: TESS_LIW(n + 1), TESS_LRW(n + 1)
 *   iw        (out)     iw[i], i < n: the point that stands for i, as in tess
 *   rw        (out)     workspace
 *
 * returns the code of tess for n + 1 points: TESS_PLANE when all are on one
 * line, TESS_LINE for one point; TESS_POINT for none.  TESS_MORE, TESS_POOL:
 * there are no triangles, *ntri is 0; begin again with more room.
 * Cost: that of tess, whose tetrahedra are in triangle and beside at first. */
int tr_planar(tess_int n, tess_real *p, tess_int maxtri, tess_int *ntri,
              tess_int *triangle, tess_int *beside, tess_int liw, tess_int *iw,
              tess_int lrw, double *rw)
{
    tess_int t, v[4], a[4];
    int code, apex, from, k;

    *ntri = 0;
    if (n < 0) return -1;
    if (n == 0) return TESS_POINT;
    for (t = 0; t < n; t++)
        if (p[3 * t + 2] < 0 || p[3 * t + 2] > 0) {
            *ntri = t;
            return -2;
        }
    p[3 * n] = p[0];
    p[3 * n + 1] = p[1];
    p[3 * n + 2] = 1;
    code = tess(n + 1, p, maxtri, ntri, triangle, beside, liw, iw, lrw, rw);
    if (code > 0) *ntri = 0;
    if (code != TESS_OK) return code;
    for (t = 0; t < *ntri; t++) {
        for (k = 0; k < 4; k++) {
            v[k] = triangle[4 * t + k];
            a[k] = beside[4 * t + k];
        }
        for (apex = 0; v[apex] != n; apex++) continue;
        for (k = 0; k < 3; k++) {
            /* the tetrahedron a b c d is as d sees a b c turn clockwise;
             * an odd place of the apex turns that round */
            from = (apex + 1 + (apex % 2 ? k : 2 - k)) % 4;
            triangle[3 * t + k] = v[from];
            beside[3 * t + k] = a[from];
        }
    }
    return TESS_OK;
}
