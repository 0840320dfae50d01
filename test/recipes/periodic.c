/* periodic.c - the Delaunay tetrahedralization of a box, or any cell that three
 * vectors span, that repeats itself along all of them or some: recipes to
 * copy.
 *
 *   tr_periodic   tetrahedra and neighbours, with the copies of the box that
 *                 they are in (all that is here, but for tr_reduce)
 *   tr_triclinic  the same of a cell               (all, but for tr_reduce)
 *   tr_reduce     short vectors that span the same lattice             (dot3)
 *   tr_unpack     the copy of the box from its number
 *
 * t_periodic.c tests them; periodic.f is the same in FORTRAN 77.
 */
#include <float.h>
#include <math.h>

#include "recipes.h"

/* Copies of the cell are numbered 1024 a + 32 b + c, a, b, c = -REACH ... REACH
 * times its vectors: numbers add up as the copies do, and ascend in an order
 * that no translation alters. */
#define REACH 7

/* tr_unpack - a, b, c of a copy. */
void tr_unpack(tess_int number, int *copy)
{
    long rest = (long)number + 16 * (1024 + 32 + 1);

    copy[0] = (int)(rest / 1024 - 16);
    copy[1] = (int)(rest / 32 % 32 - 16);
    copy[2] = (int)(rest % 32 - 16);
}

static double dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* less - a, without its part along b, which may be 0. */
static void less(double *a, const double *b)
{
    double square = dot3(b, b), s = square > 0.0 ? dot3(a, b) / square : 0.0;
    int k;

    for (k = 0; k < 3; k++) a[k] -= s * b[k];
}

/* across - for each vector of the cell that it repeats itself along, of the
 * others 0: height, the distance of the planes between which all places are
 * less than one such vector apart, and g, at right angles to them, whose
 * product with a difference of places says how many vectors are between them.
 * Returns 0, or 1 for what is no cell, or one flatter than 1e-6. */
static int across(const double *cell, const tess_int *ways, double *g,
                  double *height)
{
    double u[3][3], b[3], size[3], most, s;
    int j, k;

    for (k = 0; k < 3; k++) {
        for (most = 0.0, j = 0; j < 3; j++)
            if (fabs(cell[3 * k + j]) > most) most = fabs(cell[3 * k + j]);
        if (ways[k] && !(most > 0.0)) return 1;
        for (j = 0; j < 3; j++)
            u[k][j] = ways[k] ? cell[3 * k + j] / most : 0.0;
        s = sqrt(dot3(u[k], u[k]));
        for (j = 0; j < 3 && ways[k]; j++) u[k][j] /= s;
        size[k] = most * s;
    }
    for (k = 0; k < 3; k++) {
        for (j = 0; j < 3; j++) {
            b[j] = u[(k + 2) % 3][j];
            g[3 * k + j] = u[k][j];
        }
        less(b, u[(k + 1) % 3]);
        less(g + 3 * k, u[(k + 1) % 3]);
        less(g + 3 * k, b);
        s = dot3(g + 3 * k, g + 3 * k);
        height[k] = 0.0;
        if (!ways[k]) continue;
        if (!(s > 1e-12)) return 1;
        for (j = 0; j < 3; j++) g[3 * k + j] /= s * size[k];
        height[k] = sqrt(s) * size[k];
    }
    return 0;
}

/* rounded - to a multiple of unit. */
static double rounded(double x, double unit)
{
    double many = floor(fabs(x) / unit + 0.5);

    return (x < 0.0 ? -many : many) * unit;
}

/* copies - of all points that are less than margin from the cell, ordered by
 * point, then by copy.  Points and vectors, side, are rounded to multiples of a
 * power of two, unit, that is so large that the copies need no rounding. */
static int copies(tess_int n, const tess_real *p, const double *cell,
                  const tess_int *ways, const double *g, const double *height,
                  double margin, tess_int maxcop, tess_int *ncop,
                  tess_real *x, tess_int *who, tess_int *copy, tess_int *mine,
                  double *side, double *unit)
{
    const int narrow = sizeof *x < sizeof(double);
    const double most = (narrow ? (double)FLT_MAX : DBL_MAX) / 64.0;
    const double least = narrow ? (double)FLT_MIN : DBL_MIN;
    double size = 0.0, sum, r[3], e[3], s, t;
    tess_int i;
    int first[3], last[3], a[3], k;

    for (k = 0; k < 3; k++) {
        for (sum = 0.0, i = 0; i < 3; i++)
            if (ways[i]) sum += fabs(cell[3 * i + k]);
        for (i = 0; i < n; i++) {
            r[0] = fabs((double)p[3 * i + k]);
            if (r[0] != r[0]) return -2;
            if (r[0] > size - (REACH + 2) * sum)
                size = r[0] + (REACH + 2) * sum;
        }
        if (!(fabs(cell[9 + k]) < most)) return TESS_RANGE;
    }
    if (!(size < most)) return TESS_RANGE;
    frexp(size, &k);
    *unit = ldexp(1.0, k - (narrow ? FLT_MANT_DIG : DBL_MANT_DIG));
    if (!(*unit >= least)) return TESS_RANGE;
    for (k = 0; k < 9; k++)
        side[k] = ways[k / 3] ? rounded(cell[k], *unit) : 0.0;
    for (*ncop = i = 0; i < n; i++) {
        for (k = 0; k < 3; k++) {
            r[k] = (double)p[3 * i + k];
            e[k] = r[k] - cell[9 + k];
            r[k] = rounded(r[k], *unit);
        }
        for (k = 0; k < 3; k++) {
            first[k] = last[k] = 0;
            if (!ways[k]) continue;
            s = dot3(g + 3 * k, e);
            t = margin / height[k];
            if (!(s + t < REACH + 1 && 1.0 - s + t < REACH + 1))
                return TR_FEW;
            first[k] = s + t > 0.0 ? -(int)floor(s + t) : 0;
            last[k] = s < 1.0 + t ? (int)floor(1.0 - s + t) : 0;
        }
        for (a[0] = first[0]; a[0] <= last[0]; a[0]++)
            for (a[1] = first[1]; a[1] <= last[1]; a[1]++)
                for (a[2] = first[2]; a[2] <= last[2]; a[2]++) {
                    if (*ncop == maxcop) return TESS_MORE;
                    for (k = 0; k < 3; k++)
                        x[3 * *ncop + k] = (tess_real)(
                            r[k] + a[0] * side[k] + a[1] * side[3 + k] +
                            a[2] * side[6 + k]);
                    who[*ncop] = i;
                    copy[*ncop] = (tess_int)(1024 * a[0] + 32 * a[1] + a[2]);
                    mine[*ncop] = copy[*ncop] == 0;
                    ++*ncop;
                }
    }
    return 0;
}

/* placed - at: point i, in copy `number' and as many as further says farther;
 * home[i] is where x has it.  Returns 0 where that is beyond REACH. */
static int placed(const tess_real *x, const tess_int *home, const double *side,
                  tess_int i, tess_int number, tess_int further, tess_real *at)
{
    int a[3], b[3], k;

    tr_unpack(number, a);
    tr_unpack(further, b);
    for (k = 0; k < 3; k++) {
        a[k] += b[k];
        if (a[k] < -REACH || a[k] > REACH) return 0;
    }
    for (k = 0; k < 3; k++)
        at[k] = (tess_real)((double)x[3 * home[i] + k] + a[0] * side[k] +
                            a[1] * side[3 + k] + a[2] * side[6 + k]);
    return 1;
}

/* corners - those of a tetrahedron; as placed. */
static int corners(const tess_real *x, const tess_int *home,
                   const double *side, const tess_int *tet,
                   const tess_int *move, tess_int t, tess_real (*v)[3])
{
    int k, all = 1;

    for (k = 0; k < 4; k++)
        all &= placed(x, home, side, tet[4 * t + k], move[4 * t + k], 0, v[k]);
    return all;
}

/* ending - 1 if facet k of those corners is one where the mesh ends: if its
 * plane stays the same by all vectors, and no point is beyond; none of x is,
 * known = 1 says. */
static int ending(tess_int n, const tess_real *x, const tess_int *home,
                  const double *side, const tess_int *ways,
                  tess_real (*v)[3], int k, int known)
{
    const tess_real *at[4];
    tess_real moved[3];
    tess_int i;
    int j, l;

    for (j = 0; j < 4; j++) at[j] = j == k ? moved : v[j];
    for (l = 0; l < 3; l++) {
        for (j = 0; j < 3; j++)
            moved[j] = (tess_real)((double)v[(k + 1) % 4][j] +
                                   side[3 * l + j]);
        if (ways[l] && hh_orient(at[0], at[1], at[2], at[3]) != 0) return 0;
    }
    for (i = 0; i < n && !known; i++) {
        at[k] = x + 3 * home[i];
        if (hh_orient(at[0], at[1], at[2], at[3]) < 0) return 0;
    }
    return 1;
}

/* facing - 1 if the facets f and g, 4 t + k for that opposite to vertex k of
 * tetrahedron t, are the same but for translation, by *shift from g's copy to
 * f's, seen from both sides: if their points are, in the order of point and
 * copy, which no translation alters. */
static int facing(const tess_int *tet, const tess_int *move, tess_int f,
                  tess_int g, tess_int *shift)
{
    tess_int v[2][3], h[2], s;
    int i, j, k, m, odd = 0;

    h[0] = f;
    h[1] = g;
    for (m = 0; m < 2; m++) {
        odd += (int)(h[m] % 4);
        for (j = 0, k = 0; k < 4; k++) {
            if (k == (int)(h[m] % 4)) continue;
            s = (tess_int)(h[m] / 4 * 4 + k);
            for (i = j++; i > 0 && (tet[v[m][i - 1]] > tet[s] ||
                                    (tet[v[m][i - 1]] == tet[s] &&
                                     move[v[m][i - 1]] > move[s])); i--) {
                v[m][i] = v[m][i - 1];
                odd++;
            }
            v[m][i] = s;
        }
    }
    *shift = move[v[0][0]] - move[v[1][0]];
    for (k = 0; k < 3; k++)
        if (tet[v[0][k]] != tet[v[1][k]] ||
            move[v[0][k]] - move[v[1][k]] != *shift)
            return 0;
    return odd % 2;
}

/* one - of each class of tetrahedra leaves one, whose first point is in the
 * cell itself: *ntet of them, in tet, move; shift is 1 at facets where the mesh
 * of x ends, or 0.  home[i] = iw[i] becomes where x has point i.  Returns 1 if
 * all points are there. */
static int one(tess_int n, tess_int ncop, const tess_int *who,
               const tess_int *copy, tess_int *seen, tess_int *ntet,
               tess_int *tet, tess_int *move, const tess_int *adj,
               tess_int *shift, tess_int *iw)
{
    tess_int first, i, kept = 0, t;
    int k;

    for (i = 0; i < n; i++) seen[i] = 0;
    for (t = 0; t < *ntet; t++) {
        for (first = tet[4 * t], k = 1; k < 4; k++)
            if (tet[4 * t + k] < first) first = tet[4 * t + k];
        if (copy[first] != 0) continue;
        for (k = 0; k < 4; k++) {
            shift[4 * kept + k] = adj[4 * t + k] == TESS_NONE;
            i = tet[4 * t + k];
            seen[who[i]] = 1;
            tet[4 * kept + k] = who[i];
            move[4 * kept + k] = copy[i];
        }
        kept++;
    }
    *ntet = kept;
    for (i = 0; i < ncop; i++) {
        if (copy[i] != 0) continue;
        if (iw[i] == i && !seen[who[i]]) return 0; /* (no duplicate) */
        iw[who[i]] = i;
    }
    return 1;
}

/* matched - 1 if each facet has a neighbour, whose other vertex is not in the
 * ball, or is one where the mesh ends.  head: n, workspace. */
static int matched(tess_int n, const tess_real *x, const tess_int *home,
                   tess_int *head, const double *side, const tess_int *ways,
                   tess_int ntet, const tess_int *tet, const tess_int *move,
                   tess_int *adj, tess_int *shift)
{
    tess_real v[4][3], at[3];
    tess_int f, g, *from, i, s = 0;
    int k;

    /* facets that wait for their other side, in lists by the sum of their
     * points, linked in adj */
    for (i = 0; i < n; i++) head[i] = -1;
    for (f = 0; f < 4 * ntet; f++) {
        if (f % 4 == 0 && !corners(x, home, side, tet, move, f / 4, v))
            return 0;
        for (i = 0, k = 0; k < 4; k++)
            if (k != (int)(f % 4))
                i = (tess_int)((i + tet[f / 4 * 4 + k]) % n);
        for (from = head + i; (g = *from) >= 0; from = adj + g)
            if (facing(tet, move, f, g, &s)) break;
        if (g < 0) {
            adj[f] = head[i];
            head[i] = f;
            continue;
        }
        *from = adj[g];
        adj[f] = g / 4;
        adj[g] = f / 4;
        shift[f] = s;
        shift[g] = -s;
        if (!placed(x, home, side, tet[g], move[g], s, at) ||
            hh_insphere(v[0], v[1], v[2], v[3], at) > 0)
            return 0;
    }
    for (i = 0; i < n; i++)
        for (f = head[i]; f >= 0; f = g) {
            g = adj[f];
            corners(x, home, side, tet, move, f / 4, v);
            if (!ending(n, x, home, side, ways, v, (int)(f % 4), shift[f] == 1))
                return 0;
            adj[f] = TESS_NONE;
            shift[f] = 0;
        }
    return 1;
}

/* holds - 0 where a place is outside of a tetrahedron, 1 on its boundary, 2
 * inside. */
static int holds(tess_real (*v)[3], const tess_real *at)
{
    int a, b, c, d;

    a = hh_orient(at, v[1], v[2], v[3]);
    b = hh_orient(v[0], at, v[2], v[3]);
    c = hh_orient(v[0], v[1], at, v[3]);
    d = hh_orient(v[0], v[1], v[2], at);
    if (a < 0 || b < 0 || c < 0 || d < 0) return 0;
    return a > 0 && b > 0 && c > 0 && d > 0 ? 2 : 1;
}

/* once - 1 if a place in a tetrahedron is in no other one, nor in a copy: so it
 * is everywhere, as each facet has two sides. */
static int once(const tess_real *x, const tess_int *home, const double *side,
                const tess_int *ways, const double *g, double unit,
                tess_int ntet, const tess_int *tet, const tess_int *move)
{
    tess_real v[4][3], at[3], q[3];
    double middle[3], e[3], low, high, s;
    tess_int t;
    int from[3], to[3], a[3], found = 0, j, k;

    for (t = 0; t < ntet; t++) {
        corners(x, home, side, tet, move, t, v);
        for (k = 0; k < 3; k++) {
            middle[k] = (double)v[0][k] / 4.0 + (double)v[1][k] / 4.0 +
                        (double)v[2][k] / 4.0 + (double)v[3][k] / 4.0;
            at[k] = (tess_real)rounded(middle[k], unit);
        }
        if (holds(v, at) == 2) break;
    }
    for (t = 0; t < ntet && found < 2; t++) {
        corners(x, home, side, tet, move, t, v);
        for (k = 0; k < 3; k++) {
            low = high = 0.0;
            for (j = 0; j < 4 && ways[k]; j++) {
                e[0] = (double)v[j][0] - (double)at[0];
                e[1] = (double)v[j][1] - (double)at[1];
                e[2] = (double)v[j][2] - (double)at[2];
                s = dot3(g + 3 * k, e);
                if (j == 0 || s < low) low = s;
                if (j == 0 || s > high) high = s;
            }
            from[k] = (int)ceil(low - 1e-3);
            to[k] = (int)floor(high + 1e-3);
            if (from[k] < -REACH - 2 || to[k] > REACH + 2) return 0;
        }
        for (a[0] = from[0]; a[0] <= to[0]; a[0]++)
            for (a[1] = from[1]; a[1] <= to[1]; a[1]++)
                for (a[2] = from[2]; a[2] <= to[2]; a[2]++) {
                    for (k = 0; k < 3; k++)
                        q[k] = (tess_real)((double)at[k] + a[0] * side[k] +
                                           a[1] * side[3 + k] +
                                           a[2] * side[6 + k]);
                    found += holds(v, q) != 0;
                }
    }
    return found == 1;
}

/* guess - a margin: about three points wide, if they fill the cell, or lie near
 * a plane, or line, that it repeats. */
static double guess(tess_int n, const tess_real *p, const double *cell,
                    const tess_int *ways, const double *g,
                    const double *height)
{
    double e[3], s[3], thick = 0.0, filled = 1.0, spread = 1.0, along = 0.0;
    tess_int i;
    int j, k;

    for (k = 0; k < 3; k++) along += ways[k] != 0;
    for (i = 1; i < n && along < 3.0; i++) {
        for (k = 0; k < 3; k++)
            e[k] = (double)p[3 * i + k] - (double)p[k];
        for (k = 0; k < 3; k++) s[k] = ways[k] ? dot3(g + 3 * k, e) : 0.0;
        for (k = 0; k < 3; k++) {
            for (j = 0; j < 3; j++) e[k] -= s[j] * cell[3 * j + k];
            if (fabs(e[k]) > thick) thick = fabs(e[k]);
        }
    }
    for (k = 0; k < 3; k++) {
        /* (a cell's volume could be too large or too small for a double) */
        filled *= pow(ways[k] ? height[k] : thick, 1.0 / 3.0);
        if (ways[k]) spread *= pow(height[k], 1.0 / along);
    }
    filled *= 3.0 * pow((double)n, -1.0 / 3.0);
    spread *= 3.0 * pow((double)n, -1.0 / along);
    return along < 3.0 && filled < spread ? spread : filled;
}

/* tr_triclinic - as tr_periodic, below, of a cell of any three vectors, that
 * repeats itself along all of them, or some.
 *
 *   n, p     (in)   n >= 1 points, in the cell or not far from it
 *   cell     (in)   12: three vectors, those that count not in one plane, and a
 *                   corner.  If they are skew tetrahedra reach across more of
 *                   them: tr_reduce them first
 *   ways     (in)   3: ways[k] != 0 where it repeats itself along vector k
 *   all others      as in tr_periodic
 *
 * returns what tr_periodic does; -2 for NaN; -3 for vectors that span no cell,
 * or one flatter than 1e-6, and where it is repeated nowhere; TR_FEW, too, for
 * points that are some cells away; TESS_PLANE, TESS_LINE where all copies are
 * in a plane, on a line.
 *
 * A margin about the cell is filled with copies, and those tetrahedra computed
 * that have a point of the cell itself.  Kept are those whose first point is in
 * the cell itself: one of each class.  They are right, whatever may be beyond
 * the margin, if each facet has a neighbour whose ball holds no point of it, or
 * is one where the mesh ends, all points are there, and a place is in one
 * tetrahedron only.  If not, the margin is made wider.
 *
 * Of cospherical points the order decides, so the order must be the same in all
 * copies: by point, then by copy.  With copies put after the originals a sphere
 * of points in the cell has another first point than its copy across the
 * boundary: both triangulate it, each in its way, and what they have in common
 * does not fit: lattices come out with volumes that are off by a tenth.  For
 * the same reason copies must not be rounded one by one. */
int tr_triclinic(tess_int n, const tess_real *p, const double *cell,
                 const tess_int *ways, tess_int maxcop, tess_int *ncop,
                 tess_real *x, tess_int *cw, tess_int maxtet, tess_int *ntet,
                 tess_int *tet, tess_int *move, tess_int *adj, tess_int *shift,
                 tess_int liw, tess_int *iw, tess_int lrw, double *rw)
{
    tess_int *who = cw, *copy = cw + maxcop, *head = copy + maxcop;
    double g[9], height[3], side[9], margin, unit;
    int code, k, wide;

    *ntet = 0;
    if (n < 1) return -1;
    if (!(ways[0] || ways[1] || ways[2]) || across(cell, ways, g, height))
        return -3;
    for (margin = guess(n, p, cell, ways, g, height);; margin *= 1.5) {
        code = copies(n, p, cell, ways, g, height, margin, maxcop, ncop, x,
                      who, copy, head, side, &unit);
        if (code != 0) return code;
        code = tess_index(*ncop, x, liw, iw, lrw, rw);
        *ntet = 0;
        if (code >= TESS_PLANE && code <= TESS_POINT) {
            for (wide = 1, k = 0; k < 3; k++) wide &= margin >= height[k];
            if (wide) return code;
            continue;
        }
        if (code == 0)
            code = tess_part(*ncop, x, head, maxtet, ntet, tet, adj, liw, iw,
                             lrw, rw);
        if (code != 0) {
            *ntet = 0;
            return code;
        }
        if (one(n, *ncop, who, copy, head, ntet, tet, move, adj, shift, iw) &&
            matched(n, x, iw, head, side, ways, *ntet, tet, move, adj, shift) &&
            once(x, iw, side, ways, g, unit, *ntet, tet, move))
            return 0;
    }
}

/* tr_periodic - the tetrahedra of the points and all their copies, one of each
 * that are copies of each other.
 *
 *   n, p     (in)   n >= 1 points in the box, its boundary included
 *   box      (in)   x0, x1, y0, y1, z0, z1, x0 < x1
 *   maxcop   (in)   copies that there is room for: 3 n if n is large, 343 for
 *                   one point
 *   ncop     (out)  copies made
 *   x        (out)  3*maxcop: points in the order of the copies; workspace
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
 * TESS_POOL as tess; TR_FEW where so few points are in a box so long that
 * tetrahedra reach farther than REACH boxes; -1 for n < 1, -2 for a point that
 * is not in the box, or NaN; -3 for a box that is none; TESS_RANGE for one so
 * large that tess_real does not hold its copies, or so small that these would
 * have to be rounded; what tess_index and tess_part return.
 * Cost: 1.7 times that of tess for 10,000 points, less for more: the margin is
 * about three points wide. */
int tr_periodic(tess_int n, const tess_real *p, const double *box,
                tess_int maxcop, tess_int *ncop, tess_real *x, tess_int *cw,
                tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *move,
                tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
                tess_int lrw, double *rw)
{
    double cell[12];
    tess_int ways[3], i;
    int k;

    *ntet = 0;
    for (k = 0; k < 12; k++) cell[k] = 0.0;
    for (k = 0; k < 3; k++) {
        cell[4 * k] = box[2 * k + 1] - box[2 * k];
        cell[9 + k] = box[2 * k];
        ways[k] = 1;
        if (n > 0 && !(cell[4 * k] > 0.0)) return -3;
    }
    for (i = 0; i < 3 * n; i++)
        if (!((double)p[i] >= box[2 * (i % 3)] &&
              (double)p[i] <= box[2 * (i % 3) + 1])) return -2;
    return tr_triclinic(n, p, cell, ways, maxcop, ncop, x, cw, maxtet, ntet,
                        tet, move, adj, shift, liw, iw, lrw, rw);
}

/* tr_reduce - make the vectors of a cell short, by adding others of them, until
 * no sum or difference is shorter: the lattice is the same.
 *
 *   cell  (in,out)  12, as in tr_triclinic; the corner stays
 *   ways  (in)      3: those with ways[k] = 0 stay, and are not added */
void tr_reduce(double *cell, const tess_int *ways)
{
    double most = 0.0, unit, w[3], c[3], square;
    int again = 1, combination, i, j, k, power;

    for (k = 0; k < 9; k++)
        if (ways[k / 3] && fabs(cell[k]) > most) most = fabs(cell[k]);
    if (!(most > 0.0 && most <= DBL_MAX)) return;
    frexp(most, &power);
    unit = ldexp(1.0, power - 1);
    for (k = 0; k < 9; k++) cell[k] /= unit;
    while (again) {
        again = 0;
        /* of vector k any multiple of one other is taken away, or both others
         * are added or taken away */
        for (combination = 0; combination < 18; combination++) {
            k = combination / 6;
            j = (k + 1 + combination % 2) % 3;
            i = 3 - k - j;
            if (!ways[k] || !ways[j]) continue;
            c[k] = 1.0;
            c[i] = (double)(combination % 6 / 2 - 1);
            c[j] = combination % 2 ? 1.0 : -1.0;
            square = dot3(cell + 3 * j, cell + 3 * j);
            if (c[i] == 0.0 && square > 0.0)
                c[j] = -floor(dot3(cell + 3 * k, cell + 3 * j) / square + 0.5);
            if (c[i] != 0.0 && !ways[i]) continue;
            for (power = 0; power < 3; power++)
                w[power] = c[0] * cell[power] + c[1] * cell[3 + power] +
                           c[2] * cell[6 + power];
            square = dot3(cell + 3 * k, cell + 3 * k);
            if (!(dot3(w, w) < (1.0 - 1e-9) * square)) continue;
            again = 1;
            for (power = 0; power < 3; power++) cell[3 * k + power] = w[power];
        }
    }
    for (k = 0; k < 9; k++) cell[k] *= unit;
}
