/* tess_mex.c - what tessn.m and tessinterp.m call, for Octave and MATLAB.
 *
 *   [T, N] = tess_mex(P)            tetrahedra, 4 by m, of points, 3 by n, and
 *                                   their neighbours, 4 by m, 0 for none
 *   F = tess_mex(P, V, Q, METHOD)   values, nq by k, of V, n by k, at places Q,
 *                                   3 by nq, all finite, by TR_LINEAR or
 *                                   another; NaN outside the hull.
 *                                   Of duplicates the mean of V counts
 *
 * `make octave' builds it.  MATLAB, in the top directory:
 *   mex -I. test/bindings/octave/tess_mex.c test/recipes/many.c ...
 *       test/recipes/slopes.c test/recipes/natural.c ...
 *       test/recipes/derived.c tess.c hhpred.c
 */
#include "mex.h"

#include "../../recipes/recipes.h"

#define ROUNDS 3 /* of tr_slopes                                   */
#define MOST 60  /* tetrahedra about a natural neighbour, at first */

typedef struct mesh {
    const double *p;
    tess_int n, ntet, *tet, *adj, *same;
} mesh;

/* room - memory, which is given back when the call ends at the latest; what was
 * there before, if it is not 0, made longer. */
static void *room(void *before, double number, size_t each)
{
    size_t size = (size_t)number * each;
    void *x = 0;

    if (number < (double)((size_t)-1 / each))
        x = before ? mxRealloc(before, size) : mxMalloc(size > 0 ? size : 1);
    if (!x) mexErrMsgIdAndTxt("tess:memory", "not enough memory");
    return x;
}

static tess_int *integers(tess_int *before, double number)
{
    return (tess_int *)room(before, number, sizeof(tess_int));
}

static double *doubles(double number)
{
    return (double *)room(0, number, sizeof(double));
}

/* right - ends with a message, unless code is success. */
static void right(int code)
{
    if (code == TESS_PLANE || code == TESS_LINE || code == TESS_POINT)
        mexErrMsgIdAndTxt("tess:flat", "no tetrahedron: %s",
                          code == TESS_PLANE  ? "all points lie in one plane"
                          : code == TESS_LINE ? "all points lie on one line"
                                              : "at most one distinct point");
    if (code != 0) mexErrMsgIdAndTxt("tess:code", "code %d", code);
}

/* matrix - the numbers of an argument with so many rows, and its columns. */
static const double *matrix(const mxArray *x, tess_int rows, tess_int *columns)
{
    tess_int liw, lrw;

    if (!mxIsDouble(x) || mxIsComplex(x) || mxIsSparse(x) ||
        mxGetNumberOfDimensions(x) != 2 || mxGetM(x) != (size_t)rows)
        mexErrMsgIdAndTxt("tess:argument", "no full matrix of real "
                          "doubles with %ld rows", (long)rows);
    *columns = (tess_int)mxGetN(x);
    if (mxGetN(x) > (size_t)TESS_INT_MOST ||
        tess_size(*columns, 0, &liw, &lrw) != 0)
        mexErrMsgIdAndTxt("tess:argument", "too many for its integers");
    return mxGetPr(x);
}

/* build - the mesh of the points. */
static void build(mesh *m, const mxArray *points)
{
    tess_int limit = (TESS_INT_MOST - 3) / 4, maxtet, liw, lrw, *iw;
    double *rw, pool = 1.0;
    int code;

    m->p = matrix(points, 3, &m->n);
    m->tet = m->adj = iw = 0;
    m->ntet = 0;
    maxtet = m->n > limit / 8 - 8 ? limit : 8 * m->n + 64;
    for (;;) {
        right(tess_size(m->n, maxtet, &liw, &lrw));
        liw = pool * liw > TESS_INT_MOST ? TESS_INT_MOST
                                         : (tess_int)(pool * liw);
        m->tet = integers(m->tet, 4.0 * maxtet);
        m->adj = integers(m->adj, 4.0 * maxtet);
        iw = integers(iw, liw);
        rw = doubles(lrw);
        code = (m->ntet ? tess_resume : tess)(m->n, m->p, maxtet, &m->ntet,
                                              m->tet, m->adj, liw, iw, lrw, rw);
        mxFree(rw);
        if (code == TESS_MORE && maxtet < limit)
            maxtet = maxtet > limit / 2 ? limit : 2 * maxtet;
        else if (code == TESS_POOL && liw < TESS_INT_MOST)
            pool *= 2.0;
        else
            break;
    }
    if (code == -2)
        mexErrMsgIdAndTxt("tess:finite", "point %ld is not finite",
                          (long)m->ntet + 1);
    right(code);
    m->same = integers(iw, m->n);
}

/* interpolated - nq by nv values. */
static mxArray *interpolated(const mesh *m, const mxArray *values,
                             const mxArray *places, int method)
{
    tess_int nv, nq, most = MOST, liw, lrw, *t, *iw, *first = 0, *list = 0, i;
    const double *given = matrix(values, m->n, &nv);
    const double *q = matrix(places, 3, &nq);
    mxArray *result = mxCreateDoubleMatrix((size_t)nq, (size_t)nv, mxREAL);
    double *out = mxGetPr(result), *g = 0, *rw;
    size_t n = (size_t)m->n, all = (size_t)nq, j;
    double *v = doubles((double)m->n * nv);
    int code;

    for (j = 0; j < n * (size_t)nv; j++) v[j] = given[j];
    rw = doubles(m->n);
    tr_average(m->n, m->same, nv, v, rw);
    mxFree(rw);

    if (method == TR_SMOOTH) {
        g = doubles(3.0 * m->n * nv);
        rw = doubles(9.0 * m->n);
        for (j = 0; j < (size_t)nv; j++) {
            code = tr_slopes(m->n, m->p, m->ntet, m->tet, m->adj, v + n * j,
                             ROUNDS, g + 3 * n * j, rw);
            if (code == TESS_RANGE)
                mexErrMsgIdAndTxt("tess:range", "a value is infinite, or a "
                                  "gradient too large for a double");
            right(code);
        }
        mxFree(rw);
    }
    if (method == TR_NEAREST) {
        first = integers(0, m->n + 1.0);
        list = integers(0, 4.0 * m->ntet);
        tr_stars(m->n, m->ntet, m->tet, first, list);
    }
    (void)tess_size(nq, 0, &liw, &lrw);
    t = integers(0, nq);
    do {
        iw = integers(0, liw + 14.0 * most + 17.0);
        rw = doubles(lrw + 15.0 * most + 21.0);
        code = tr_many(m->n, m->p, m->ntet, m->tet, m->adj, method, nv, v, g,
                       first, list, nq, q, t, 0, out, most, iw, rw);
        most *= 2;
        mxFree(iw);
        mxFree(rw);
    } while (code == TESS_POOL);
    if (code != 1) right(code);
    for (i = 0; i < nq; i++)
        for (j = 0; j < (size_t)nv && t[i] < TESS_NONE; j++)
            out[all * j + (size_t)i] = mxGetNaN();
    return result;
}

void mexFunction(int nlhs, mxArray *plhs[], int nrhs, const mxArray *prhs[])
{
    mesh m;
    double *corner;
    tess_int i;
    int k;

    if (nrhs != 1 && nrhs != 4)
        mexErrMsgIdAndTxt("tess:argument", "tess_mex: see tessn, tessinterp");
    build(&m, prhs[0]);
    if (nrhs == 4) {
        plhs[0] = interpolated(&m, prhs[1], prhs[2], (int)mxGetScalar(prhs[3]));
        return;
    }
    for (k = 0; k == 0 || (k == 1 && nlhs > 1); k++) {
        plhs[k] = mxCreateDoubleMatrix(4, (size_t)m.ntet, mxREAL);
        corner = mxGetPr(plhs[k]);
        for (i = 0; i < 4 * m.ntet; i++)
            corner[i] = (k == 0 ? m.tet : m.adj)[i] + 1.0;
    }
}
