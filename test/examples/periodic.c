/* periodic.c - the Delaunay tetrahedralization of a box that repeats itself: a
 * recipe to copy.
 *
 *   cc -O2 -I. -o periodic test/examples/periodic.c tess.c hhpred.c -lm
 *
 *   periodic  tetrahedra and neighbours, with the copies of the box that they
 *             are in (nearest, copies, ball, certified, facing)
 *   unpack    the copy of the box from its number
 *
 * The main program tests it: facets are paired, Euler's formula holds, volumes
 * fill the box.  periodic.f is the same in FORTRAN 77.  With PERIODIC_ALONE
 * defined there is no main program, for build/tess.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "tess.h"

/* Copies of the box are numbered 1024 a + 32 b + c, a, b, c = -REACH ... REACH
 * box lengths along the axes: numbers add up as the copies do, and ascend in
 * an order that no translation alters. */
#define REACH 7
#define PERIODIC_FEW 20 /* REACH is too short */

/* unpack - a, b, c of a copy. */
static void unpack(tess_int number, int *copy)
{
    long rest = (long)number + 16 * (1024 + 32 + 1);

    copy[0] = (int)(rest / 1024 - 16);
    copy[1] = (int)(rest / 32 % 32 - 16);
    copy[2] = (int)(rest % 32 - 16);
}

/* nearest - the multiple of unit. */
static double nearest(double x, double unit)
{
    double many = floor(fabs(x) / unit + 0.5);

    return (x < 0.0 ? -many : many) * unit;
}

/* copies - of all points that are less than margin from the box, ordered by
 * point, then by copy.  Points and lengths are rounded to multiples of a power
 * of two that is so large that the copies need no rounding. */
static int copies(tess_int n, const tess_real *p, const double *low,
                  const double *length, double margin, tess_int maxcop,
                  tess_int *ncop, tess_real *x, tess_int *who, tess_int *copy,
                  tess_int *mine)
{
    double size = 0.0, unit, r[3], side[3];
    tess_int i;
    int first[3], last[3], a[3], k;

    for (k = 0; k < 3; k++) {
        unit = fabs(low[k]) + (REACH + 1) * length[k];
        if (unit > size) size = unit;
    }
    frexp(size, &k);
    unit = ldexp(1.0, k - (sizeof *x > 4 ? DBL_MANT_DIG : FLT_MANT_DIG));
    for (k = 0; k < 3; k++) side[k] = nearest(length[k], unit);
    for (*ncop = i = 0; i < n; i++) {
        for (k = 0; k < 3; k++) {
            r[k] = (double)p[3 * i + k];
            if (!(r[k] >= low[k] && r[k] <= low[k] + length[k])) return -2;
            r[k] = nearest(r[k], unit);
            size = (r[k] - low[k] + margin) / side[k];
            if (!(size < REACH + 1)) return PERIODIC_FEW;
            first[k] = -(int)floor(size);
            size = (low[k] + length[k] + margin - r[k]) / side[k];
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
                    copy[*ncop] = 1024 * a[0] + 32 * a[1] + a[2];
                    mine[*ncop] = copy[*ncop] == 0;
                    ++*ncop;
                }
    }
    return 0;
}

/* ball - of the tetrahedron v: tess_ball's where that is so flat that 3 digits
 * of its centre are lost, else from its edges, which is ten times as fast. */
static int ball(const tess_real *x, const tess_int *v, double *c)
{
    double e[3][3], f[3], square[3], det = 0.0, sum = 0.0;
    int a, b, i, k;

    for (i = 0; i < 3; i++) {
        for (k = 0; k < 3; k++)
            e[i][k] = (double)x[3 * v[i + 1] + k] - (double)x[3 * v[0] + k];
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
        c[k] += (double)x[3 * v[0] + k];
    }
    c[3] = sqrt(sum);
    return 0;
}

/* certified - 1 if all copies that could be in a tetrahedron's ball are there;
 * a part in a thousand of the margin is for roundings. */
static int certified(const tess_real *x, tess_int ntet, const tess_int *tet,
                     const tess_int *adj, const double *low,
                     const double *length, double margin)
{
    double c[4];
    tess_int t;
    int k;

    for (t = 0; t < ntet; t++) {
        if (ball(x, tet + 4 * t, c) != 0) return 0;
        for (k = 0; k < 3; k++)
            if (!(c[k] - c[3] > low[k] - 0.999 * margin &&
                  c[k] + c[3] < low[k] + length[k] + 0.999 * margin))
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
            s = h[m] / 4 * 4 + k;
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
 *   low, length  (in)   the box: low[k] <= p[3*i+k] <= low[k] + length[k]
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
 * is not in the box, or NaN; what tess_index and tess_part return.
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
static int periodic(tess_int n, const tess_real *p, const double *low,
                    const double *length, tess_int maxcop, tess_int *ncop,
                    tess_real *x, tess_int *cw, tess_int maxtet,
                    tess_int *ntet, tess_int *tet, tess_int *move,
                    tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
                    tess_int lrw, double *rw)
{
    tess_int *who = cw, *copy = cw + maxcop, *head = copy + maxcop;
    tess_int f, g, *from, i, first, kept = 0, t, s = 0;
    double margin;
    int code, k;

    *ntet = 0;
    if (n < 1) return -1;
    /* (the box's volume could be too large or too small for a double) */
    margin = 3.0 * pow((double)n, -1.0 / 3.0);
    for (k = 0; k < 3; k++) margin *= pow(length[k], 1.0 / 3.0);
    for (;; margin *= 1.5) {
        code = copies(n, p, low, length, margin, maxcop, ncop, x, who, copy,
                      head);
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
        if (certified(x, *ntet, tet, adj, low, length, margin)) break;
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
            if (k != (int)(f % 4)) i = (i + tet[f / 4 * 4 + k]) % n;
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

#ifndef PERIODIC_ALONE
/* ---- tests ---- */

#define N 512
#define SETS 8
#define MAXCOP 16000
#define MAXTET (24 * N)

static tess_real p[3 * N], x[3 * MAXCOP];
static tess_int cw[3 * MAXCOP], tet[4 * MAXTET], move[4 * MAXTET];
static tess_int adj[4 * MAXTET], shift[4 * MAXTET], iw[TESS_LIW(MAXCOP)];
static double rw[TESS_LRW(MAXCOP)];
static const double low[3] = {-1.0, 0.0, 2.0};

/* random20 - a random number, 0 <= x < 1, of 20 bits. */
static double random20(void)
{
    static long seed = 1;
    long high;

    seed = (seed * 3877 + 29573) % 139968;
    high = seed % 1024;
    seed = (seed * 3877 + 29573) % 139968;
    return ((double)high + (double)(seed % 1024) / 1024.0) / 1024.0;
}

/* make - points of a set; its name. */
static const char *make(int set, tess_int *n, double *length)
{
    static const char *const name[SETS] = {"random", "lattice", "clusters",
                                           "one", "three", "twice", "huge",
                                           "tiny"};
    static const tess_int number[SETS] = {500, 512, 300, 1, 3, 400, 300, 300};
    tess_int i, j;
    int k;

    *n = number[set];
    for (k = 0; k < 3; k++) length[k] = set == 0 && k < 2 ? 2.0 - k / 2.0 : 1.0;
    for (i = 0; i < *n; i++)
        for (k = 0; k < 3; k++) {
            double r = random20();

            if (set == 2) r = 0.25 * r + 0.5 * (double)(i % 2);
            /* a shuffled lattice of 8 a side: 257 and 512 have no factor in
             * common */
            j = (tess_int)((long)i * 257 % 512);
            if (set == 1)
                r = (double)(k == 0 ? j % 8 : k == 1 ? j / 8 % 8 : j / 64) / 8;
            p[3 * i + k] = (tess_real)(low[k] + r * length[k]);
            /* duplicates: in the box, and across its boundary */
            if (set == 5 && i >= 200) p[3 * i + k] = p[3 * (i - 200) + k];
            if (set == 5 && i % 200 < 20 && k == 2)
                p[3 * i + k] = (tess_real)(low[k] + (i < 200 ? 1.0 : 0.0));
        }
    return name[set];
}

/* place - of a point's copy, moved; exact, as are the points and lengths. */
static void place(tess_int i, tess_int number, const double *length,
                  tess_real *at)
{
    int a[3], k;

    unpack(number, a);
    for (k = 0; k < 3; k++)
        at[k] = (tess_real)((double)p[3 * i + k] + a[k] * length[k]);
}

/* edges - how many, each once: in lists by one point, linked in cw.  That of
 * points a, b and the copy of b when a is in the box. */
static tess_int edges(tess_int n, tess_int ntet)
{
    static tess_int list[3][12 * MAXTET];
    tess_int i, j, a, b, d, count = 0;
    int k, m;

    for (i = 0; i < n; i++) cw[i] = -1;
    for (i = 0; i < 4 * ntet; i += 4)
        for (k = 0; k < 3; k++)
            for (m = k + 1; m < 4; m++) {
                a = tet[i + k];
                b = tet[i + m];
                d = move[i + m] - move[i + k];
                if (a > b || (a == b && d < 0)) {
                    a = tet[i + m];
                    b = tet[i + k];
                    d = -d;
                }
                for (j = cw[a]; j >= 0 && (list[0][j] != b || list[1][j] != d);)
                    j = list[2][j];
                if (j >= 0) continue;
                list[0][count] = b;
                list[1][count] = d;
                list[2][count] = cw[a];
                cw[a] = count++;
            }
    return count;
}

/* proven - 1 if the facets are paired, all tetrahedra positively oriented and
 * as large as the box together, and no neighbour's apex is in a ball. */
static int proven(tess_int ntet, const double *length)
{
    tess_real v[5][3];
    double e[3][3], volume = 0.0; /* in boxes */
    tess_int t, u, s;
    int h, k, j, good = ntet > 0;

    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 4; k++)
            place(tet[4 * t + k], move[4 * t + k], length, v[k]);
        if (hh_orient(v[0], v[1], v[2], v[3]) != 1) good = 0;
        for (k = 0; k < 3; k++)
            for (j = 0; j < 3; j++)
                e[k][j] = ((double)v[k + 1][j] - (double)v[0][j]) / length[j];
        volume += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                   e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                   e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6.0;
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u < 0 || u >= ntet) return 0;
            /* the vertex of u that is not t's, and three that are */
            h = -1;
            for (j = 0; j < 4; j++) {
                for (s = 0; s < 4; s++)
                    if (s != k && tet[4 * t + s] == tet[4 * u + j] &&
                        move[4 * t + s] ==
                            move[4 * u + j] + shift[4 * t + k]) break;
                if (s < 4) continue;
                if (h >= 0) good = 0;
                h = j;
            }
            if (h < 0) return 0;
            if (adj[4 * u + h] != t ||
                shift[4 * u + h] != -shift[4 * t + k]) good = 0;
            place(tet[4 * u + h], move[4 * u + h] + shift[4 * t + k], length,
                  v[4]);
            if (hh_insphere(v[0], v[1], v[2], v[3], v[4]) == 1) good = 0;
        }
    }
    return good && fabs(volume - 1.0) < 1e-12;
}

/* few - 1 if a long box, points outside and short arrays get their codes. */
static int few(tess_int liw, tess_int lrw)
{
    static const double length[3] = {64.0, 1.0, 1.0}, cube[3] = {1.0, 1.0, 1.0};
    tess_int ncop, ntet;
    int code[4], k;

    for (k = 0; k < 3; k++) p[k] = (tess_real)low[k];
    for (k = 0; k < 4; k++) {
        if (k == 1) p[0] = (tess_real)(low[0] - 1.0);
        if (k == 2) p[0] = (tess_real)low[0];
        code[k] = periodic(k == 3 ? 0 : 1, p, low, k == 2 ? cube : length,
                           k == 2 ? 9 : MAXCOP, &ncop, x, cw, MAXTET, &ntet,
                           tet, move, adj, shift, liw, iw, lrw, rw);
    }
    return code[0] == PERIODIC_FEW && code[1] == -2 && code[2] == TESS_MORE &&
           code[3] == -1;
}

int main(void)
{
    const char *name;
    double length[3], corner[3], scale;
    tess_int i, n, ncop, ntet, nedge, used;
    int set, code, good, k, bad = 0;

    printf("set       points  tetrahedra  edges  Euler  proven\n");
    for (set = 0; set < SETS; set++) {
        name = make(set, &n, length);
        /* a power of two alters nothing else */
        k = sizeof *p > 4 ? 400 : 100;
        scale = set < 6 ? 1.0 : ldexp(1.0, set == 6 ? k : -k);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 3; k++) {
            corner[k] = low[k] * scale;
            length[k] *= scale;
        }
        code = periodic(n, p, corner, length, MAXCOP, &ncop, x, cw, MAXTET, &ntet,
                        tet, move, adj, shift, TESS_LIW(MAXCOP), iw,
                        TESS_LRW(MAXCOP), rw);
        if (code != 0) {
            printf("%s: code %d\n", name, code);
            return 1;
        }
        nedge = edges(n, ntet);
        /* duplicates have no edges */
        for (used = n, i = 200; i < n && set == 5; i++) used -= cw[i] < 0;
        good = proven(ntet, length) && used - nedge + ntet == 0;
        bad |= !good;
        printf("%-8s  %6ld  %10ld  %5ld  %5ld  %s\n", name, (long)n,
               (long)ntet, (long)nedge, (long)(used - nedge + ntet),
               good ? "yes" : "NO");
    }
    printf("codes: %s\n",
           few(TESS_LIW(MAXCOP), TESS_LRW(MAXCOP)) ? "yes" : "NO");
    return bad;
}

#endif
