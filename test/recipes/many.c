/* many.c - a field at many places, in any order: recipes to copy.
 *
 *   tr_many     by tetrahedra, slopes, natural neighbours or the nearest point
 *               (sorted, terms)
 *   tr_average  of duplicates the mean of their values
 *
 * test/bindings/python and tess_mex.c, for NumPy, Octave and MATLAB, rest on
 * it.
 */
#include <stddef.h>

#include "recipes.h"

/* sorted - an order of the places in which successive ones are close: the
 * places iw[nq], iw[nq+1] ..., of equal ones the first, and then TESS_NONE.
 * iw[i] is where place i is in it.  Returns 0, or -13 for a NaN or infinity. */
static int sorted(tess_int nq, const tess_real *q, tess_int *iw, double *rw)
{
    tess_int *order = iw + nq, i;
    /* the least lengths: what planes the places are near is not asked */
    int code = tess_index(nq, q, (tess_int)(2 * nq + nq / 12 + 7), iw,
                          (tess_int)(3 * nq + nq / 2 + 12), rw);

    if (code < 0) return -13;
    for (i = 0; i < nq; i++) {
        order[i] = TESS_NONE;
        if (code == TESS_RANGE) iw[i] = i;
    }
    for (i = nq; i-- > 0;) order[iw[i]] = i;
    return 0;
}

/* terms - the *nn points that have a part in the value at x, and their weights.
 * iw, rw: as for tr_natural, and most + 3 doubles more.  Returns what
 * tess_locate or tr_natural return. */
static int terms(const tess_real *p, tess_int ntet, const tess_int *tet,
                 const tess_int *adj, int method, const tess_int *first,
                 const tess_int *list, const tess_real *x, tess_int *t,
                 tess_int most, tess_int *nn, tess_int *nbr, double *weight,
                 tess_int *iw, double *rw)
{
    int code, best = 0, k;

    if (method == TR_NATURAL)
        return tr_natural(p, ntet, tet, adj, x, t, most, nn, nbr, weight, rw,
                          iw, rw + most + 3);
    code = tess_locate(p, ntet, tet, adj, x, t, weight);
    if (code != 0 && code != 1) return code;
    for (k = 0; k < 4; k++) {
        nbr[k] = tet[4 * *t + k];
        if (weight[k] > weight[best]) best = k;
    }
    *nn = 4;
    if (method == TR_NEAREST) {
        nbr[0] = tr_nearest(p, tet, first, list, x, nbr[best]);
        weight[0] = 1.0;
        *nn = 1;
    }
    return code;
}

/* tr_many - a field at many places.
 *
 *   n, p, ntet, tet, adj  (in)  points and mesh, as from tess
 *   method  (in)   TR_LINEAR; TR_SMOOTH, by tr_bent; TR_NATURAL, by Sibson's
 *                  weights; TR_NEAREST, that of the nearest point
 *   nv      (in)   values a point, >= 0; >= 1 for TR_SMOOTH
 *   value   (in)   value[n*j+i] is value j of point i
 *   g       (in)   for TR_SMOOTH: g + 3*n*j are the gradients of value j, as
 *                  tr_slopes gives them
 *   first, list  (in)  for TR_NEAREST: as tr_stars gives them
 *   nq, q   (in)   number of places, and 3*nq coordinates
 *   t       (out)  nq: the tetrahedra found, -2 - t for a place outside the
 *                  hull, as from tess_values
 *   w       (out)  for TR_LINEAR: 4*nq weights, as from tess_locate; 0 where
 *                  they are not asked for
 *   out     (out)  out[nq*j+i] is value j at place i; outside the hull that of
 *                  the hull's nearest point, or for TR_NEAREST of the points'
 *   most    (in)   >= 1: for TR_NATURAL as in tr_natural, for others 1 will do
 *   iw, rw  (out)  workspace: what tess_size says for nq points and maxtet = 0,
 *                  and 14*most + 17 and 15*most + 21 more
 *
 * returns 0; 1 when a place is outside the hull; -3 for ntet < 1, -7 for a bad
 * nv, -12 for a bad nq, -13 for a NaN or infinity in q, -17 for most < 1: then
 * nothing is done; TESS_POOL when most is too small; what else tess_locate and
 * tr_natural return.
 *
 * A point of weight 0 has no part in a sum, even if its value is a NaN.
 * Cost: the places are sorted first, in a third of the time that the search
 * takes then.  Not sorted it may take ten times as long. */
int tr_many(tess_int n, const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, int method, tess_int nv, const double *value,
            const double *g, const tess_int *first, const tess_int *list,
            tess_int nq, const tess_real *q, tess_int *t, double *w,
            double *out, tess_int most, tess_int *iw, double *rw)
{
    tess_int *order = iw + nq, *nbr = order + nq, last = TESS_NONE, i, j, m, k;
    tess_int nn = 0;
    double *weight = rw, *f;
    size_t all = (size_t)n, places = (size_t)nq;
    int code = 0, outside = 0;

    if (ntet < 1) return -3;
    if (nv < (method == TR_SMOOTH)) return -7;
    if (nq < 0 || tess_size(nq, 0, &i, &j) != 0) return -12;
    if (most < 1) return -17;
    if (sorted(nq, q, iw, rw) != 0) return -13;
    for (m = 0; m < nq && order[m] != TESS_NONE; m++) {
        i = order[m];
        if (method != TR_SMOOTH)
            code = terms(p, ntet, tet, adj, method, first, list, q + 3 * i,
                         &last, most, &nn, nbr, weight, nbr + most + 3,
                         weight + most + 3);
        for (j = 0; j < nv && (code == 0 || code == 1); j++) {
            f = out + places * (size_t)j + i;
            if (method == TR_SMOOTH)
                code = tr_bent(p, ntet, tet, adj, value + all * (size_t)j,
                               g + 3 * all * (size_t)j, 0.0, q + 3 * i, &last,
                               f);
            else
                for (*f = 0.0, k = 0; k < nn; k++)
                    if (weight[k] != 0.0)
                        *f += weight[k] *
                              value[all * (size_t)j + (size_t)nbr[k]];
        }
        if (code != 0 && code != 1) return code;
        if (code == 1) outside = 1;
        t[i] = code == 1 ? -2 - last : last;
        for (k = 0; k < 4 && w && method == TR_LINEAR; k++)
            w[4 * i + k] = weight[k];
    }
    /* what was found for the first of equal places */
    for (i = 0; i < nq; i++) {
        m = order[iw[i]];
        t[i] = t[m];
        for (k = 0; k < 4 && w && method == TR_LINEAR; k++)
            w[4 * i + k] = w[4 * m + k];
        for (j = 0; j < nv; j++) {
            f = out + places * (size_t)j;
            f[i] = f[m];
        }
    }
    return outside;
}

/* tr_average - of points that coincide the mean of their values.
 *
 *   n, same  (in)     number of points, and for each the one that stands for it,
 *                     as tess leaves it in iw[0..n-1]
 *   nv       (in)     values a point
 *   value    (in,out) value[n*j+i] is value j of point i; all at one place
 *                     become the mean of them
 *   times    (out)    workspace, n
 *
 * A running mean, point by point, which equal values leave as they are. */
void tr_average(tess_int n, const tess_int *same, tess_int nv, double *value,
                double *times)
{
    tess_int i, j, r;
    double *v = value;

    for (j = 0; j < nv; j++, v += n) {
        for (i = 0; i < n; i++) {
            times[i] = 1.0;
            r = same[i];
            if (r == i) continue;
            times[r] += 1.0;
            v[r] += (v[i] - v[r]) / times[r];
        }
        for (i = 0; i < n; i++) v[i] = v[same[i]];
    }
}
