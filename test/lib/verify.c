/* verify.c - see verify.h. */
#include "verify.h"
#include "exact.h"
#include "take.h"

#include <stdio.h>
#include <stdlib.h>

/* Points times tetrahedra up to which each is tested against each. */
#define SMALL 4000L

/* what is being verified */
static tess_int n, ntet;
static const tess_real *p;
static const tess_int *tet, *adj;

/* Point i, which exact.c takes in doubles. */
static const double *at(tess_int i)
{
    static double held[8][3];
    static int next;
    double *h = held[next++ % 8];
    int k;

    for (k = 0; k < 3; k++) h[k] = (double)p[3 * i + k];
    return h;
}

static int orient(tess_int a, tess_int b, tess_int c, tess_int d)
{
    return ex_orient(at(a), at(b), at(c), at(d));
}

tess_int verify_corner(const tess_int *v, int k, int i)
{
    static const int out[4][3] = {
        { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 }
    };

    return v[out[k][i]];
}

/* by coordinates, then by index */
static int by_place(const void *a, const void *b)
{
    tess_int i = *(const tess_int *)a, j = *(const tess_int *)b;
    int k;

    for (k = 0; k < 3; k++)
        if (p[3 * i + k] != p[3 * j + k])
            return p[3 * i + k] < p[3 * j + k] ? -1 : 1;
    return i < j ? -1 : i > j;
}

const char *verify_twins(tess_int many, const tess_real *points,
                         const tess_int *iw)
{
    tess_int *order = (tess_int *)take((double)many, sizeof *order), i, first = 0;
    const char *fault = NULL;
    const tess_real *x, *y;

    p = points;
    for (i = 0; i < many; i++) order[i] = i;
    qsort(order, (size_t)many, sizeof *order, by_place);
    for (i = 0; i < many; i++) {
        x = p + 3 * order[i];
        y = p + 3 * first;
        if (i == 0 || x[0] != y[0] || x[1] != y[1] || x[2] != y[2])
            first = order[i];
        if (iw[order[i]] != first)
            fault = "iw does not name the twin of least index";
    }
    free(order);
    return fault;
}

/* The code for the points. */
static int flatness(void)
{
    tess_int b, c, d;

    for (b = 0; b < n; b++)
        if (p[3 * b] != p[0] || p[3 * b + 1] != p[1] || p[3 * b + 2] != p[2])
            break;
    if (b >= n) return TESS_POINT;
    for (c = b + 1; c < n; c++)
        if (!ex_collinear(at(0), at(b), at(c))) break;
    if (c >= n) return TESS_LINE;
    for (d = c + 1; d < n; d++)
        if (orient(0, b, c, d) != 0) return TESS_OK;
    return TESS_PLANE;
}

/* Is point i inside the ball of tetrahedron v, the ties broken by the rule? */
static int inside(const tess_int *v, tess_int i)
{
    const double *q[5];
    int index[5], k, s;

    for (k = 0; k < 5; k++) {
        index[k] = (int)(k < 4 ? v[k] : i);
        q[k] = at((tess_int)index[k]);
    }
    s = ex_insphere(q[0], q[1], q[2], q[3], q[4]);
    /* for a positive tetrahedron a negative sign is inside */
    return s != 0 ? s > 0 : ex_perturbed(q, index) < 0;
}

/* Across facet k of tetrahedron t there is the one with the same three vertices
 * in the opposite order, its apex not inside the ball of t. */
static const char *across(tess_int t, int k)
{
    const tess_int *v = tet + 4 * t, *w;
    tess_int u = adj[4 * t + k];
    int i, j;

    if (u == TESS_NONE) return NULL;
    if (u < 0 || u >= ntet || u == t) return "adj out of range";
    w = tet + 4 * u;
    for (j = 0; j < 4; j++)
        if (adj[4 * u + j] == t) break;
    if (j == 4) return "adj is not mutual";
    for (i = 0; i < 3; i++)
        if (verify_corner(w, j, i) == verify_corner(v, k, 0)) break;
    if (i == 3 || verify_corner(w, j, (i + 1) % 3) != verify_corner(v, k, 2) ||
        verify_corner(w, j, (i + 2) % 3) != verify_corner(v, k, 1))
        return "neighbours do not share a facet";
    if (u > t && inside(v, w[j])) return "a neighbour's apex is inside the ball";
    return NULL;
}

/* The point q, which is inside of one tetrahedron, is in no other one.  So it
 * is in all of the hull: along a way to anywhere else the number alters at the
 * hull alone, as facets inside of it have a tetrahedron on either side. */
static const char *covered(void)
{
    double q[3];
    tess_int t, u;
    int j, k, least;

    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 3; k++)
            for (q[k] = 0.0, j = 0; j < 4; j++)
                q[k] += 0.25 * (double)p[3 * tet[4 * t + j] + k];
        for (u = -1; u < ntet; u++) {
            const tess_int *v = tet + 4 * (u < 0 ? t : u);

            if (u == t) continue;
            for (k = 0, least = 1; k < 4 && least >= 0; k++) {
                j = -ex_orient(at(verify_corner(v, k, 0)),
                               at(verify_corner(v, k, 1)),
                               at(verify_corner(v, k, 2)), q);
                if (j < least) least = j;
            }
            /* a mean of a sliver, rounded, may be outside of it */
            if (u < 0 && least < 1) break;
            if (u >= 0 && least >= 0) return "the hull is covered twice";
        }
        if (u == ntet) return NULL;
    }
    return NULL;
}

static int by_edge(const void *a, const void *b)
{
    const tess_int *x = (const tess_int *)a, *y = (const tess_int *)b;
    int k;

    for (k = 0; k < 3; k++)
        if (x[k] != y[k]) return x[k] < y[k] ? -1 : 1;
    return 0;
}

/* The hull: every edge in both directions, with the apexes of its two
 * triangles, convex there; 2V - 4 triangles. */
static const char *convex(void)
{
    tess_int *edge, m = 0, vertices = 0, i, x, y;
    char *seen = (char *)take((double)n, 1);
    const char *fault = NULL;
    int j, k;

    for (i = 0; i < n; i++) seen[i] = 0;
    for (i = 0; i < 4 * ntet; i++) if (adj[i] == TESS_NONE) m++;
    edge = (tess_int *)take(12.0 * (double)m, sizeof *edge);
    for (i = 0, m = 0; i < 4 * ntet; i++)
        for (j = 0; j < 3 && adj[i] == TESS_NONE; j++, m++) {
            k = (int)(i % 4);
            x = verify_corner(tet + i - k, k, j);
            y = verify_corner(tet + i - k, k, (j + 1) % 3);
            if (!seen[x]) vertices++;
            seen[x] = 1;
            edge[4 * m] = x < y ? x : y;
            edge[4 * m + 1] = x < y ? y : x;
            edge[4 * m + 2] = x > y;
            edge[4 * m + 3] = verify_corner(tet + i - k, k, (j + 2) % 3);
        }
    qsort(edge, (size_t)m, 4 * sizeof *edge, by_edge);
    if (m / 3 != 2 * vertices - 4) fault = "the hull has not 2V - 4 triangles";
    for (i = 0; i < m && fault == NULL; i += 2) {
        const tess_int *a = edge + 4 * i;

        if (i + 1 == m || a[0] != a[4] || a[1] != a[5] || a[2] != 0 ||
            a[6] != 1)
            fault = "the hull is not closed";
        /* the triangle a0 a1 a3 is seen counter-clockwise from outside */
        else if (orient(a[0], a[1], a[3], a[7]) > 0)
            fault = "the hull is not convex";
    }
    free(edge);
    free(seen);
    return fault;
}

/* No point in a ball, or outside of a facet of the hull. */
static const char *defined(const tess_int *iw)
{
    tess_int i, t;
    int k;

    for (t = 0; t < ntet; t++)
        for (i = 0; i < n; i++) {
            const tess_int *v = tet + 4 * t;

            if (iw[i] != i) continue;
            for (k = 0; k < 4; k++)
                if (adj[4 * t + k] == TESS_NONE &&
                    orient(verify_corner(v, k, 0), verify_corner(v, k, 1),
                           verify_corner(v, k, 2), i) > 0)
                    return "a point is outside of the hull";
            if (v[0] != i && v[1] != i && v[2] != i && v[3] != i &&
                inside(v, i))
                return "a point is in a ball";
        }
    return NULL;
}

const char *verify(tess_int many, const tess_real *points, int code,
                   tess_int number, const tess_int *vertices,
                   const tess_int *neighbours, const tess_int *iw)
{
    const char *fault = verify_twins(many, points, iw);
    char *seen;
    tess_int i;
    int k;

    n = many;
    p = points;
    ntet = number;
    tet = vertices;
    adj = neighbours;
    if (fault != NULL) return fault;
    if (code != flatness()) return "the code";
    if (code != TESS_OK)
        return ntet == 0 ? NULL : "tetrahedra of points that span no space";
    seen = (char *)take((double)n, 1);
    for (i = 0; i < n; i++) seen[i] = 0;
    for (i = 0; i < 4 * ntet && fault == NULL; i++)
        if (tet[i] < 0 || tet[i] >= n || iw[tet[i]] != tet[i])
            fault = "a vertex out of range, or a duplicate";
        else seen[tet[i]] = 1;
    for (i = 0; i < n && fault == NULL; i++)
        if (iw[i] == i && !seen[i]) fault = "not every point is a vertex";
    free(seen);
    for (i = 0; i < ntet && fault == NULL; i++)
        if (orient(tet[4 * i], tet[4 * i + 1], tet[4 * i + 2],
                   tet[4 * i + 3]) != 1)
            fault = "a tetrahedron is not positively oriented";
    for (i = 0; i < ntet; i++)
        for (k = 0; k < 4 && fault == NULL; k++) fault = across(i, k);
    if (fault == NULL) fault = convex();
    if (fault == NULL) fault = covered();
    if (fault == NULL && (long)n * (long)ntet <= SMALL) fault = defined(iw);
    return fault;
}

const char *verify_hull(tess_int number, const tess_int *vertices,
                        const tess_int *neighbours, tess_int nfac,
                        const tess_int *fac)
{
    tess_int i, m = 0;
    int j, k;

    for (i = 0; i < 4 * number; i++) {
        if (neighbours[i] != TESS_NONE) continue;
        if (m == nfac) return "too few triangles";
        k = (int)(i % 4);
        for (j = 0; j < 3; j++)
            if (fac[3 * m + j] != verify_corner(vertices + i - k, k, j))
                return "a triangle";
        m++;
    }
    return m == nfac ? NULL : "too many triangles";
}
