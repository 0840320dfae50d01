/* periodic.c - the Delaunay tetrahedralization of a box that repeats itself: a
 * recipe to copy.
 *
 *   periodic  tetrahedra and neighbours, with the copies of the box that they
 *             are in (rounded, copies, ball, certified, facing)
 *   unpack    the copy of the box from its number
 *
 * try_periodic.c tests it; periodic.f is the same in FORTRAN 77.
 */
#include <float.h>
#include <math.h>

#include "recipes.h"

/* Copies of the box are numbered 1024 a + 32 b + c, a, b, c = -REACH ... REACH
 * box lengths along the axes: numbers add up as the copies do, and ascend in
 * an order that no translation alters. */
#define REACH 7

/* unpack - a, b, c of a copy. */
void unpack(tess_int number, int *copy)
{
    long rest = (long)number + 16 * (1024 + 32 + 1);

    copy[0] = (int)(rest / 1024 - 16);
    copy[1] = (int)(rest / 32 % 32 - 16);
    copy[2] = (int)(rest % 32 - 16);
}

/* rounded - to a multiple of unit. */
static double rounded(double x, double unit)
{
    double many = floor(fabs(x) / unit + 0.5);

    return (x < 0.0 ? -many : many) * unit;
}

/* copies - of all points that are less than margin from the box, ordered by
 * point, then by copy.  Points and lengths are rounded to multiples of a power
 * of two that is so large that the copies need no rounding. */
static int copies(tess_int n, const tess_real *p, const double *box,
                  double margin, tess_int maxcop, tess_int *ncop, tess_real *x,
                  tess_int *who, tess_int *copy, tess_int *mine)
{
    const int narrow = sizeof *x < sizeof(double);
    const double most = (narrow ? (double)FLT_MAX : DBL_MAX) / 64.0;
    const double least = narrow ? (double)FLT_MIN : DBL_MIN;
    double size = 0.0, unit, r[3], side[3];
    tess_int i;
    int first[3], last[3], a[3], k;

    for (k = 0; k < 6; k++)
        if (!(fabs(box[k]) < most)) return TESS_RANGE;
    for (k = 0; k < 3; k++) {
        unit = fabs(box[2 * k]) + (REACH + 1) * (box[2 * k + 1] - box[2 * k]);
        if (unit > size) size = unit;
    }
    frexp(size, &k);
    unit = ldexp(1.0, k - (narrow ? FLT_MANT_DIG : DBL_MANT_DIG));
    if (!(unit >= least)) return TESS_RANGE;
    for (k = 0; k < 3; k++)
        side[k] = rounded(box[2 * k + 1] - box[2 * k], unit);
    for (*ncop = i = 0; i < n; i++) {
        for (k = 0; k < 3; k++) {
            r[k] = (double)p[3 * i + k];
            if (!(r[k] >= box[2 * k] && r[k] <= box[2 * k + 1])) return -2;
            r[k] = rounded(r[k], unit);
            size = (r[k] - box[2 * k] + margin) / side[k];
            if (!(size < REACH + 1)) return PERIODIC_FEW;
            first[k] = -(int)floor(size);
            size = (box[2 * k + 1] + margin - r[k]) / side[k];
            if (!(size < REACH + 1)) return PERIODIC_FEW;
            last[k] = (int)floor(size);
        }
        for (a[0] = first[0]; a[0] <= last[0]; a[0]++)
            for (a[1] = first[1]; a[1] <= last[1]; a[1]++)
                for (a[2] = first[2]; a[2] <= last[2]; a[2]++) {
                    if (*ncop == maxcop) return TESS_MORE;
                    for (k = 0; k < 3; k++)
                        x[3 * *ncop + k] = (tess_real)(r[k] + a[k] * side[k]);
                    who[*ncop] = i;
                    copy[*ncop] = (tess_int)(1024 * a[0] + 32 * a[1] + a[2]);
                    mine[*ncop] = copy[*ncop] == 0;
                    ++*ncop;
                }
    }
    return 0;
}

/* ball - of the tetrahedron v: tess_ball's where that is so flat that 3 digits
 * of its centre are lost, else from its edges, which is ten times as fast; these
 * in units of a length, or products would be beyond doubles. */
static int ball(const tess_real *x, const tess_int *v, double unit, double *c)
{
    double e[3][3], f[3], square[3], det = 0.0, sum = 0.0;
    int a, b, i, k;

    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++)
            e[i][k] = ((double)x[3 * v[i + 1] + k] -
                       (double)x[3 * v[0] + k]) / unit;
        square[i] = e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2];
        c[i] = 0.0;
    }
    for (i = 0; i < 3; i++) {
        a = (i + 1) % 3;
        b = (i + 2) % 3;
        for (k = 0; k < 3; k++) {
            f[k] = e[a][(k + 1) % 3] * e[b][(k + 2) % 3] -
                   e[a][(k + 2) % 3] * e[b][(k + 1) % 3];
            c[k] += square[i] * f[k];
        }
        if (i == 0) det = e[0][0] * f[0] + e[0][1] * f[1] + e[0][2] * f[2];
    }
    if (!(det * det > 1e-6 * square[0] * square[1] * square[2]))
        return tess_ball(x, v, c);
    for (k = 0; k < 3; k++) {
        c[k] /= 2.0 * det;
        sum += c[k] * c[k];
        c[k] = c[k] * unit + (double)x[3 * v[0] + k];
    }
    c[3] = sqrt(sum) * unit;
    return 0;
}

/* certified - 1 if all copies that could be in a tetrahedron's ball are there;
 * a part in a thousand of the margin is for roundings. */
static int certified(const tess_real *x, tess_int ntet, const tess_int *tet,
                     const tess_int *adj, const double *box, double margin)
{
    double c[4];
    tess_int t;
    int k;

    for (t = 0; t < ntet; t++) {
        if (ball(x, tet + 4 * t, margin, c) != 0) return 0;
        for (k = 0; k < 3; k++)
            if (!(c[k] - c[3] > box[2 * k] - 0.999 * margin &&
                  c[k] + c[3] < box[2 * k + 1] + 0.999 * margin))
                return 0;
        for (k = 0; k < 4; k++)
            if (adj[4 * t + k] == TESS_NONE) return 0;
    }
    return 1;
}

/* facing - 1 if the facets f and g, 4 t + k for that opposite to vertex k of
 * tetrahedron t, are the same but for translation, by *shift from g's copy to
 * f's: if their points are, in the order of point and copy, which no
 * translation alters. */
static int facing(const tess_int *tet, const tess_int *move, tess_int f,
                  tess_int g, tess_int *shift)
{
    tess_int v[2][3], h[2], s;
    int i, j, k, m;

    h[0] = f;
    h[1] = g;
    for (m = 0; m < 2; m++) {
        for (j = 0, k = 0; k < 4; k++) {
            if (k == (int)(h[m] % 4)) continue;
            s = (tess_int)(h[m] / 4 * 4 + k);
            for (i = j++; i > 0 && (tet[v[m][i - 1]] > tet[s] ||
                                    (tet[v[m][i - 1]] == tet[s] &&
                                     move[v[m][i - 1]] > move[s])); i--)
                v[m][i] = v[m][i - 1];
            v[m][i] = s;
        }
    }
    *shift = move[v[0][0]] - move[v[1][0]];
    for (k = 0; k < 3; k++)
        if (tet[v[0][k]] != tet[v[1][k]] ||
            move[v[0][k]] - move[v[1][k]] != *shift)
            return 0;
    return 1;
}

/* periodic - the tetrahedra of the points and all their copies, one of each
 * that are copies of each other.
 *
 *   n, p     (in)   n >= 1 points in the box, its boundary included
 *   box      (in)   x0, x1, y0, y1, z0, z1, x0 < x1
 *   maxcop   (in)   copies that there is room for: 3 n if n is large, 343 for
 *                   one point
 *   ncop     (out)  copies made
 *   x        (out)  3*maxcop; workspace
 *   cw       (out)  3*maxcop; workspace
 *   maxtet   (in)   tetrahedra that there is room for: 10 n if n is large
 *   ntet     (out)  number of tetrahedra
 *   tet      (out)  4*maxtet: points, positively oriented
 *   move     (out)  4*maxtet: the copies of the box that they are in; that of
 *                   the first one, by number, is the box itself
 *   adj      (out)  4*maxtet: neighbours
 *   shift    (out)  4*maxtet: the copy that the neighbour is to be taken from,
 *                   move[4*t+k] + shift: so that it shares the facet
 *   liw, iw, lrw, rw   as in tess, for maxcop points
 *
 * returns 0; TESS_MORE, maxcop being too small, with ncop = maxcop, or maxtet;
 * TESS_POOL as tess; PERIODIC_FEW where so few points are in a box so long that
 * tetrahedra reach farther than REACH boxes; -1 for n < 1, -2 for a point that
 * is not in the box, or NaN; -3 for a box that is none; TESS_RANGE for one so
 * large that tess_real does not hold its copies, or so small that these would
 * have to be rounded; what tess_index and tess_part return.
 *
 * A margin about the box is filled with copies, and those tetrahedra computed
 * that have a point of the box itself.  Where a ball is within the margin no
 * copy that is not there can be in it: the tetrahedron is right.  If one is
 * not, the margin is made wider.  Kept are the tetrahedra whose first point is
 * in the box itself: one of each class.
 *
 * Of cospherical points the order decides, so the order must be the same in all
 * copies: by point, then by copy.  With copies put after the originals a sphere
 * of points in the box has another first point than its copy across the
 * boundary: both triangulate it, each in its way, and what they have in common
 * does not fit: lattices come out with volumes that are off by a tenth.  For
 * the same reason copies must not be rounded one by one.
 *
 * Cost: 1.7 times that of tess for 10,000 points, less for more: the margin is
 * about three points wide. */
int periodic(tess_int n, const tess_real *p, const double *box,
             tess_int maxcop, tess_int *ncop, tess_real *x, tess_int *cw,
             tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *move,
             tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
             tess_int lrw, double *rw)
{
    tess_int *who = cw, *copy = cw + maxcop, *head = copy + maxcop;
    tess_int f, g, *from, i, first, kept = 0, t, s = 0;
    double margin, length;
    int code, k;

    *ntet = 0;
    if (n < 1) return -1;
    /* (the box's volume could be too large or too small for a double) */
    margin = 3.0 * pow((double)n, -1.0 / 3.0);
    for (k = 0; k < 3; k++) {
        length = box[2 * k + 1] - box[2 * k];
        if (!(length > 0.0)) return -3;
        margin *= pow(length, 1.0 / 3.0);
    }
    for (;; margin *= 1.5) {
        code = copies(n, p, box, margin, maxcop, ncop, x, who, copy, head);
        if (code != 0) return code;
        code = tess_index(*ncop, x, liw, iw, lrw, rw);
        if (code >= TESS_PLANE && code <= TESS_POINT) continue;
        *ntet = 0;
        if (code == 0)
            code = tess_part(*ncop, x, head, maxtet, ntet, tet, adj, liw, iw,
                             lrw, rw);
        if (code != 0) {
            *ntet = 0;
            return code;
        }
        if (certified(x, *ntet, tet, adj, box, margin)) break;
    }
    for (t = 0; t < *ntet; t++) {
        for (first = tet[4 * t], k = 1; k < 4; k++)
            if (tet[4 * t + k] < first) first = tet[4 * t + k];
        if (copy[first] != 0) continue;
        for (k = 0; k < 4; k++) {
            i = tet[4 * t + k];
            tet[4 * kept + k] = who[i];
            move[4 * kept + k] = copy[i];
        }
        kept++;
    }
    *ntet = kept;
    /* facets that wait for their other side, in lists by the sum of their
     * points, linked in adj */
    for (i = 0; i < n; i++) head[i] = -1;
    for (f = 0; f < 4 * kept; f++) {
        for (i = 0, k = 0; k < 4; k++)
            if (k != (int)(f % 4))
                i = (tess_int)((i + tet[f / 4 * 4 + k]) % n);
        for (from = head + i; (g = *from) >= 0; from = adj + g)
            if (facing(tet, move, f, g, &s)) break;
        if (g < 0) {
            adj[f] = head[i];
            head[i] = f;
        } else {
            *from = adj[g];
            adj[f] = g / 4;
            adj[g] = f / 4;
            shift[f] = s;
            shift[g] = -s;
        }
    }
    return 0;
}
