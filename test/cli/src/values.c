/* values.c - the values of a field at any places: see values.h.
 *
 * Places are located by a walk in double precision, wherever its bounds tell
 * that it is right; tess_locate does the rest.  The weights then are those of
 * tess_locate but for rounding.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../recipes/recipes.h"
#include "driver.h"
#include "values.h"

#define STEPS 40 /* of the walk: tess_locate knows better starts   */
#define MOST 60  /* tetrahedra about a natural neighbour, at first */
#define FAR 290  /* exponents of two that the recipes cannot do with */
#define ULPS 4.0 /* of the points' largest coordinate: so far outside a place
                  * on the hull may be, as it is rounded, and stretched */

const char *const method_name[METHODS] = {"linear", "smooth", "natural",
                                          "nearest"};

static const field *of;
static int method, outside;
static double number;

/* for all but linear: the points times unit, which is 1 but for coordinates
 * near the ends of the range, whose products would overflow or vanish */
static const tess_real *at;
static tess_real *scaled;
static double unit;

/* smooth: for each point and column the value, by much, and its gradient; is
 * each value of a column a number? */
static double *bundle, much[COLUMNS];
static int whole[COLUMNS];

/* -clip: each column's range */
static double low[COLUMNS], high[COLUMNS];

/* a place that is so near to the hull may be on it, but for its own rounding */
static double hair[3];

/* nearest, and where values end within a distance: the tetrahedra at each
 * point */
static tess_int *first, *list;

/* natural: room for so many tetrahedra */
static tess_int most, *neighbour, *iwork;
static double *sibson, *laplace, *work;

/* ---------------------------------------------------------------- memory */

/* no_room - what tr_natural had. */
static void no_room(void)
{
    free(neighbour);
    free(sibson);
    free(laplace);
    free(iwork);
    free(work);
    sibson = laplace = work = 0;
    neighbour = iwork = 0;
}

/* room - arrays for tr_natural. */
static void room(tess_int tetrahedra)
{
    no_room();
    most = tetrahedra;
    neighbour = (tess_int *)space((double)most + 3.0, sizeof *neighbour);
    sibson = (double *)space((double)most + 3.0, sizeof *sibson);
    laplace = (double *)space((double)most + 3.0, sizeof *laplace);
    iwork = (tess_int *)space(13.0 * (double)most + 14.0, sizeof *iwork);
    work = (double *)space(13.0 * (double)most + 15.0, sizeof *work);
}

void values_end(void)
{
    no_room();
    free(scaled);
    free(bundle);
    free(first);
    free(list);
    scaled = 0;
    bundle = 0;
    first = list = 0;
}

/* ------------------------------------------------------------------ walk */

/* The tetrahedron seen last, t.  a is its vertex 0; with h = q - a the volume
 * between q and the facet opposite to vertex k + 1 is the sum of h times n[k],
 * six times that is, and det that of the whole.  size and doubt are the same
 * sums of absolute values.  Roundings of such a sum are below 4 DBL_EPSILON
 * times the one of absolute values, and those of the volume at vertex 0, which
 * is what is left of det, below 6 times all four. */
static struct {
    tess_int t;
    double a[3], n[3][3], size[3][3], det, doubt;
} seen;

#define UNSURE (12.0 * DBL_EPSILON) /* twice that */
/* From a tetrahedron flatter than this weights are exact, by tess_locate. */
#define THIN 0.01
/* Volumes outside of this range might have lost digits, or overflow. */
#define LEAST 1e-250
#define LARGEST 1e250

static void look(tess_int t)
{
    const tess_int *v = of->tet + 4 * (size_t)t;
    const tess_real *a = of->p + 3 * (size_t)v[0], *x;
    const double *b, *c;
    double e[3][3], r, s;
    int i, k;

    seen.t = t;
    for (k = 0; k < 3; k++) seen.a[k] = (double)a[k];
    for (i = 0; i < 3; i++) {
        x = of->p + 3 * (size_t)v[i + 1];
        for (k = 0; k < 3; k++) e[i][k] = (double)x[k] - (double)a[k];
    }
    for (i = 0; i < 3; i++) {
        b = e[(i + 1) % 3];
        c = e[(i + 2) % 3];
        for (k = 0; k < 3; k++) {
            r = b[(k + 1) % 3] * c[(k + 2) % 3];
            s = b[(k + 2) % 3] * c[(k + 1) % 3];
            seen.n[i][k] = r - s;
            seen.size[i][k] = fabs(r) + fabs(s);
        }
    }
    seen.det = seen.doubt = 0.0;
    for (k = 0; k < 3; k++) {
        seen.det += e[0][k] * seen.n[0][k];
        seen.doubt += fabs(e[0][k]) * seen.size[0][k];
    }
}

/* within - is q on that side of the facet opposite to vertex k of tetrahedron
 * t, or in its plane?  Exact. */
static int within(const tess_real *q, tess_int t, int k)
{
    const tess_int *v = of->tet + 4 * (size_t)t;
    const tess_real *x[4];
    int i, side;

    for (i = 0; i < 4; i++) x[i] = i == k ? q : of->p + 3 * (size_t)v[i];
    side = hh_orient(x[0], x[1], x[2], x[3]);
    return side == 0 || side == 1;
}

/* hairs - how far each axis's roundings reach; by a plane that points are added
 * off, as of -plane, that one's have no part in it. */
static void hairs(void)
{
    double last = sizeof(tess_real) < sizeof(double) ? (double)FLT_EPSILON
                                                     : DBL_EPSILON, x;
    tess_int i;
    int k;

    for (k = 0; k < 3; k++) {
        hair[k] = 0.0;
        for (i = 0; i < of->n && (k < 2 || !of->flat); i++) {
            x = fabs((double)of->p[3 * (size_t)i + (size_t)k]);
            if (x > hair[k]) hair[k] = x;
        }
        hair[k] *= ULPS * last;
    }
}

/* reach - of roundings, along a direction that is not made one long. */
static double reach(const double *x)
{
    return fabs(x[0]) * hair[0] + fabs(x[1]) * hair[1] + fabs(x[2]) * hair[2];
}

/* beside_facet - may q, the volume w behind the plane of vertex k's facet, be
 * on it but for its own rounding, and the volume's, slack? */
static int beside_facet(int k, double w, double slack)
{
    double n[3];
    int i, j;

    for (j = 0; j < 3; j++) {
        n[j] = k == 0 ? 0.0 : seen.n[k - 1][j];
        for (i = 0; i < 3 && k == 0; i++) n[j] -= seen.n[i][j];
    }
    return -w <= reach(n) + slack;
}

/* on_hull - is q, which is outside, on the hull but for its own rounding?  The
 * hull's nearest point has the weights w; r, from there to q, is square to a
 * plane before which the hull lies, and q is |r| behind it. */
static int on_hull(const tess_real *q, tess_int t, const double *w)
{
    const tess_int *v = of->tet + 4 * (size_t)t;
    const tess_real *a = of->p + 3 * (size_t)v[0], *b;
    double r[3], longest = 0.0, sum = 0.0;
    int i, k;

    for (k = 0; k < 3; k++) r[k] = (double)q[k] - (double)a[k];
    for (i = 1; i < 4; i++) {
        b = of->p + 3 * (size_t)v[i];
        for (k = 0; k < 3 && w[i] != 0.0; k++)
            r[k] -= w[i] * ((double)b[k] - (double)a[k]);
    }
    for (k = 0; k < 3; k++)
        if (fabs(r[k]) > longest) longest = fabs(r[k]);
    /* (squares of what is not near 1 may overflow, or vanish) */
    for (k = 0; k < 3 && longest > 0.0; k++) {
        r[k] /= longest;
        sum += r[k] * r[k];
    }
    return longest * sum <= reach(r);
}

/* locate - the tetrahedron t that holds q, from a start, and q's weights w.
 * Returns 0, or 1 for a place outside; w and t are then set if what is outside
 * is asked of the hull's nearest point; or HAIR outside, on the hull but for
 * rounding, with w and t so. */
#define HAIR 2
static int locate(const tess_real *q, tess_int *t, double *w)
{
    double h[3], slack[4], sum;
    const tess_int *next;
    int steps, i, k, code, sure;

    for (steps = 0; steps < STEPS && *t != TESS_NONE; steps++) {
        if (*t != seen.t) look(*t);
        next = of->adj + 4 * (size_t)*t;
        for (k = 0; k < 3; k++) h[k] = (double)q[k] - seen.a[k];
        w[0] = seen.det;
        slack[0] = UNSURE * seen.doubt;
        for (i = 0; i < 3; i++) {
            w[i + 1] = h[0] * seen.n[i][0] + h[1] * seen.n[i][1] +
                       h[2] * seen.n[i][2];
            slack[i + 1] = UNSURE * (fabs(h[0]) * seen.size[i][0] +
                                     fabs(h[1]) * seen.size[i][1] +
                                     fabs(h[2]) * seen.size[i][2]);
            w[0] -= w[i + 1];
            slack[0] += slack[i + 1];
        }
        if (!(slack[0] < LARGEST)) break;
        for (k = 0; k < 4 && w[k] >= -slack[k] - LEAST; k++) continue;
        if (k < 4 && next[k] != TESS_NONE) {
            *t = next[k];
            continue;
        }
        if (k < 4 && outside == OUT_VALUE && !beside_facet(k, w[k], slack[k]))
            return 1;
        if (k < 4) break;
        sure = seen.det > THIN * seen.doubt && seen.det > LEAST;
        /* within rounding of a facet it is on it, unless it is behind it, where
         * a flat tetrahedron may end before q */
        for (sum = 0.0, k = 0; k < 4; k++) {
            if (w[k] <= slack[k]) {
                sure = sure && within(q, *t, k);
                w[k] = 0.0;
            }
            sum += w[k];
        }
        if (!sure) break;
        for (k = 0; k < 4; k++) w[k] /= sum;
        return 0;
    }
    code = tess_locate(of->p, of->ntet, of->tet, of->adj, q, t, w);
    if (code != 0 && code != 1)
        too_small("a place cannot be located: code %d of tess_locate", code);
    return code == 1 && on_hull(q, *t, w) ? HAIR : code;
}

/* --------------------------------------------------------------- methods */

/* recipe - leave when a recipe has failed. */
static void recipe(const char *name, int code)
{
    if (code != 0)
        too_small("-method %s fails: code %d of %s", method_name[method],
                  code, name);
}

/* factor - 1, or for numbers near the ends of the range the power of two that
 * brings the largest one near 1. */
static double factor(double largest)
{
    int power;

    frexp(largest, &power);
    if (power > -FAR && power < FAR) return 1.0;
    /* (with its reciprocal in the range) */
    return ldexp(1.0, power > 1000 ? -1000 : power < -1000 ? 1000 : -power);
}

/* scale_points - see unit; leave if that alters them. */
static void scale_points(void)
{
    size_t many = 3 * (size_t)of->n, i;
    double largest = 0.0;

    for (i = 0; i < many; i++)
        if (fabs((double)of->p[i]) > largest) largest = fabs((double)of->p[i]);
    at = of->p;
    unit = factor(largest);
    if (unit == 1.0) return;
    at = scaled = (tess_real *)space((double)many, sizeof *scaled);
    for (i = 0; i < many; i++) {
        scaled[i] = (tess_real)((double)of->p[i] * unit);
        if ((double)scaled[i] / unit != (double)of->p[i])
            fail("-method %s: the coordinates differ too much in magnitude; "
                 "choose linear",
                 method_name[method]);
    }
}

/* gradients - of each column, beside its values. */
static void gradients(void)
{
    double n = (double)of->n, *column, *g, *b, largest;
    tess_int i;
    int code, j, k;

    bundle = (double *)space(4.0 * n * (double)of->columns, sizeof *bundle);
    column = (double *)space(n, sizeof *column);
    g = (double *)space(3.0 * n, sizeof *g);
    work = (double *)space(9.0 * n, sizeof *work);
    for (j = 0; j < of->columns; j++) {
        for (whole[j] = 1, largest = 0.0, i = 0; i < of->n; i++) {
            column[i] = of->value[(size_t)of->columns * (size_t)i + (size_t)j];
            if (!(fabs(column[i]) <= DBL_MAX))
                whole[j] = 0;
            else if (fabs(column[i]) > largest)
                largest = fabs(column[i]);
        }
        much[j] = 1.0 / factor(largest);
        for (i = 0; i < of->n; i++) column[i] /= much[j];
        code = tr_slopes(of->n, at, of->ntet, of->tet, of->adj, column, ROUNDS,
                         g, work);
        if (code == TESS_RANGE && whole[j])
            fail("-method smooth: gradients are beyond the range of numbers; "
                 "choose another method");
        /* what is no number makes places near it so */
        if (code != TESS_RANGE) recipe("tr_slopes", code);
        for (i = 0; i < of->n; i++) {
            b = bundle + 4 * ((size_t)of->columns * (size_t)i + (size_t)j);
            b[0] = column[i];
            for (k = 0; k < 3; k++) b[k + 1] = g[3 * (size_t)i + (size_t)k];
        }
    }
    free(column);
    free(g);
    free(work);
    work = 0;
}

/* limits - of each column's values, which values are held within. */
static void limits(void)
{
    double x;
    tess_int i;
    int j;

    for (j = 0; j < of->columns; j++) {
        low[j] = DBL_MAX;
        high[j] = -DBL_MAX;
        for (i = 0; i < of->n; i++) {
            x = of->value[(size_t)of->columns * (size_t)i + (size_t)j];
            if (x < low[j] && x >= -DBL_MAX) low[j] = x;
            if (x > high[j] && x <= DBL_MAX) high[j] = x;
        }
    }
}

void values_begin(const field *what, int by, int beyond, double otherwise)
{
    of = what;
    method = by;
    outside = beyond;
    number = otherwise;
    seen.t = TESS_NONE;
    hairs();
    if (chosen.clip) limits();
    if (method != LINEAR || of->within > 0.0) scale_points();
    if (method == SMOOTH) gradients();
    if (method == NATURAL) room(MOST);
    if (method == NEAREST || of->within > 0.0) {
        first = (tess_int *)space((double)of->n + 1.0, sizeof *first);
        list = (tess_int *)space(4.0 * (double)of->ntet, sizeof *list);
        tr_stars(of->n, of->ntet, of->tet, first, list);
    }
}

/* mean - of the values of those points by weights whose sum is 1 and of which
 * none is negative: as roundings must not take it, either, it is not beyond the
 * values.  (0 times a NaN would be one.) */
static void mean(tess_int many, const tess_int *point, const double *w,
                 double *out)
{
    double v, sum, least, greatest;
    tess_int i;
    int j;

    for (j = 0; j < of->columns; j++) {
        sum = 0.0;
        least = DBL_MAX;
        greatest = -DBL_MAX;
        for (i = 0; i < many; i++) {
            if (w[i] == 0.0) continue;
            v = of->value[(size_t)of->columns * (size_t)point[i] + (size_t)j];
            sum += w[i] * v;
            if (v < least) least = v;
            if (v > greatest) greatest = v;
        }
        if (sum < least) sum = least;
        if (sum > greatest) sum = greatest;
        out[j] = sum;
    }
}

/* smooth - as the recipe tr_bent: the weights' sum of f_k + g_k.(x - p_k) / 2,
 * x the place, or the hull's point nearest to it. */
static void smooth(const tess_real *q, int beyond, const tess_int *v,
                   const double *w, double *out)
{
    const tess_real *a = at + 3 * (size_t)v[0], *b;
    const double *f;
    double x[3], h[3];
    int i, j, k;

    for (k = 0; k < 3; k++) {
        x[k] = beyond ? (double)a[k] : (double)q[k];
        for (i = 1; i < 4 && beyond; i++)
            x[k] += w[i] *
                    ((double)at[3 * (size_t)v[i] + (size_t)k] - (double)a[k]);
    }
    for (i = 0; i < 4; i++) {
        b = at + 3 * (size_t)v[i];
        f = bundle + 4 * (size_t)of->columns * (size_t)v[i];
        for (k = 0; k < 3; k++) h[k] = (x[k] - (double)b[k]) / 2.0;
        for (j = 0; j < of->columns; j++, f += 4)
            out[j] += w[i] * (f[0] + h[0] * f[1] + h[1] * f[2] + h[2] * f[3]);
    }
    for (j = 0; j < of->columns; j++) {
        out[j] *= much[j];
        if (whole[j] && !(fabs(out[j]) <= DBL_MAX))
            fail("-method smooth: a value is beyond the range of numbers; "
                 "divide the points' values by ten");
    }
}

/* sibsons - the sum by Sibson's weights; w are the linear ones. */
static void sibsons(const tess_real *q, tess_int t, const double *w,
                    double *out)
{
    tess_int many;
    int code;

    while ((code = of->flat
                       ? natural_flat(at, of->tet, of->adj, q, t, most, &many,
                                      neighbour, sibson, iwork, work)
                       : tr_natural(at, of->ntet, of->tet, of->adj, q, &t, most,
                                    &many, neighbour, sibson, laplace, iwork,
                                    work)) == TESS_POOL)
        room(2 * most);
    recipe("tr_natural", code);
    if (many == 0) mean(4, of->tet + 4 * (size_t)t, w, out);
    else mean(many, neighbour, sibson, out);
}

/* closest - the data point nearest to q: its values. */
static void closest(const tess_real *q, const tess_int *v, const double *w,
                    double *out)
{
    static const double all = 1.0;
    tess_int point;
    int k, best = 0;

    for (k = 1; k < 4; k++)
        if (w[k] > w[best]) best = k;
    point = tr_nearest(at, of->tet, first, list, q, v[best]);
    mean(1, &point, &all, out);
}

/* square - of the distance of q from point i. */
static double square(const tess_real *q, tess_int i)
{
    double d, sum = 0.0;
    int k;

    for (k = 0; k < 3; k++) {
        d = (double)q[k] - (double)at[3 * (size_t)i + (size_t)k];
        sum += d * d;
    }
    return sum;
}

/* distant - is q, near to vertices v, farther from all points than the field
 * goes? */
static int distant(const tess_real *q, const tess_int *v)
{
    double far = of->within * unit;
    int k, best = 0;

    for (k = 1; k < 4; k++)
        if (square(q, v[k]) < square(q, v[best])) best = k;
    far *= far;
    return square(q, v[best]) > far &&
           square(q, tr_nearest(at, of->tet, first, list, q, v[best])) > far;
}

tess_int values_start(const tess_real *q, tess_int start)
{
    double w[4];

    locate(q, &start, w);
    return start;
}

void values_at(tess_int many, const tess_real *q, tess_int *t, double *out)
{
    const tess_int *v;
    tess_int last = TESS_NONE, i;
    tess_real near[3]; /* q, times unit */
    double w[4];
    int beyond, lost, none, j, k;

    for (i = 0; i < many; i++, q += 3, out += of->columns) {
        if (t[i] != TESS_NONE) last = t[i] < 0 ? -2 - t[i] : t[i];
        beyond = locate(q, &last, w);
        if (beyond != 1 && of->keep && !of->keep[last]) beyond = 1;
        lost = beyond && beyond != HAIR;
        t[i] = lost ? -2 - last : last;
        v = of->tet + 4 * (size_t)last;
        for (k = 0; k < 3 && (method != LINEAR || of->within > 0.0); k++)
            near[k] = unit == 1.0 ? q[k] : (tess_real)((double)q[k] * unit);
        none = of->within > 0.0 && distant(near, v);
        for (j = 0; j < of->columns; j++)
            out[j] = none                         ? no_number()
                     : lost && outside == OUT_VALUE ? number
                                                    : 0.0;
        if (none || (lost && outside == OUT_VALUE)) continue;
        if (method == SMOOTH)
            smooth(near, beyond, v, w, out);
        else if (method == NATURAL && !beyond)
            sibsons(near, last, w, out);
        else if (method == NEAREST)
            closest(near, v, w, out);
        else
            mean(4, v, w, out);
        for (j = 0; j < of->columns && chosen.clip; j++) {
            if (out[j] < low[j]) out[j] = low[j];
            if (out[j] > high[j]) out[j] = high[j];
        }
    }
}
