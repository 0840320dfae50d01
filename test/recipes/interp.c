/* interp.c - values measured at scattered points, interpolated onto a grid: a
 * recipe to copy.
 *
 * Linear in each tetrahedron.  With M the largest second derivative of the
 * field in any direction, the error at q is at most  M/2 * sum of
 * w[k] |p_k - q|^2: it falls with the square of the spacing.  (Taylor about q;
 * the first derivatives drop out, as sum w[k] (p_k - q) = 0.)  No other
 * mesh of the points makes this bound smaller.
 *
 * Points much denser in one direction: stretch that direction, of p and of the
 * box.
 *
 * t_interp.c tests it; interp.f is the same in FORTRAN 77.
 */
#include "recipes.h"

/* tr_ongrid - values at the places of a grid.
 *
 *   p, ntet, tet, adj  (in)  a result of tess with ntet >= 1
 *   nv       (in)      values per point, >= 0
 *   value    (in)      value[nv*i+j] is value j of point i
 *   size     (in)      places along x, y, z, >= 1
 *   box      (in)      from x, to x; from y, to y; from z, to z: places are at
 *                      both ends; a single one is in the middle
 *   outside  (in)      the value outside the hull
 *   t        (out)     size[0]: workspace
 *   q        (out)     3*size[0]: workspace
 *   out      (out)     nv * size[0] * size[1] * size[2]: value j at place x, y,
 *                      z is out[nv * (x + size[0] * (y + size[1] * z)) + j]
 *
 * returns 0; 1 when a place is outside the hull; -2 for ntet < 1, -5 for nv < 0,
 * -7 for a bad size, -8 for a NaN or infinity in a place; -4 or TESS_RANGE as
 * from tess_locate.
 * Cost: that of tess_values; each row starts where the row before it did. */
int tr_ongrid(const tess_real *p, tess_int ntet, const tess_int *tet,
              const tess_int *adj, tess_int nv, const double *value,
              const tess_int *size, const double *box, double outside,
              tess_int *t, tess_real *q, double *out)
{
    tess_int at[3], plane = TESS_NONE, row, i, j;
    double along;
    int code, k, found = 0;

    if (size[0] < 1 || size[1] < 1 || size[2] < 1) return -7;
    if (nv < 0) return -5;
    for (at[2] = 0; at[2] < size[2]; at[2]++) {
        row = plane;
        for (at[1] = 0; at[1] < size[1]; at[1]++) {
            for (at[0] = 0; at[0] < size[0]; at[0]++) {
                t[at[0]] = TESS_NONE;
                for (k = 0; k < 3; k++) {
                    along = size[k] > 1
                                ? (double)at[k] / (double)(size[k] - 1)
                                : 0.5;
                    q[3 * at[0] + k] =
                        (tess_real)(box[2 * k] +
                                    along * (box[2 * k + 1] - box[2 * k]));
                }
            }
            t[0] = row;
            code = tess_values(p, ntet, tet, adj, nv, value, size[0], q, t, out);
            if (code != 0 && code != 1) return code;
            row = t[0];
            if (at[1] == 0) plane = row;
            if (code == 1) found = 1;
            for (i = 0; i < size[0]; i++, out += nv)
                for (j = 0; t[i] < TESS_NONE && j < nv; j++) out[j] = outside;
        }
    }
    return found;
}
