/* prove.c - proofs of the answers that parity.c writes; see prove.h. */
#ifndef PROVE
#define PROVE
#endif
#include "prove.h"
#include "exact.h"
#include "verify.h"
#include <math.h>
#include <stdio.h>

static long faults, proofs;

static void require(int holds, const char *what)
{
    proofs++;
    if (holds) return;
    faults++;
    if (faults <= 20) fprintf(stderr, "prove: wrong: %s\n", what);
}

static void nothing(const char *fault)
{
    require(fault == NULL, fault);
}

void prove_result(tess_int n, const double *p, int code, tess_int ntet,
                  const tess_int *tet, const tess_int *adj,
                  const tess_int *iw)
{
    nothing(verify(n, p, code, ntet, tet, adj, iw));
}

void prove_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
                tess_int nfac, const tess_int *fac)
{
    nothing(verify_hull(ntet, tet, adj, nfac, fac));
}

void prove_place(tess_int n, const double *p, const tess_int *tet,
                 const tess_int *adj, const double *q, tess_int t,
                 const double *w, int code)
{
    const tess_int *v = tet + 4 * t;
    const double *c[4];
    double miss, size = 0.0, x[4];
    int k, i, s, out = 0;

    for (k = 0; k < 4; k++) {
        c[k] = p + 3 * v[k];
        s = -ex_orient(p + 3 * verify_corner(v, k, 0),
                       p + 3 * verify_corner(v, k, 1),
                       p + 3 * verify_corner(v, k, 2), q);
        if (s < 0 && w[k] == 0.0 && (!adj || adj[4 * t + k] == TESS_NONE))
            out = 1;
        if (code != TESS_OK) continue;
        require(s >= 0, "t does not hold q");
        require(w[k] * s >= 0.0 && (w[k] == 0.0 || s != 0),
                "the sign of a weight");
    }
    require(code == out, "inside or outside");
    require(fabs(w[0] + w[1] + w[2] + w[3] - 1.0) <= 1e-14,
            "the sum of the weights");
    if (code != TESS_OK) {
        require(ex_nearest(4, c, q, (long)n, p, x) > 0,
                "the hull's nearest point");
        for (k = 0; k < 4; k++)
            require(fabs(w[k] - x[k]) <= 32.0 * DBL_EPSILON * x[k],
                    "the weights of the nearest point");
        return;
    }
    for (i = 0; i < 3; i++)
        for (k = 0; k < 4; k++)
            if (fabs(p[3 * v[k] + i]) > size) size = fabs(p[3 * v[k] + i]);
    for (i = 0; i < 3; i++) {
        miss = -q[i];
        for (k = 0; k < 4; k++) miss += w[k] * p[3 * v[k] + i];
        require(fabs(miss) <= 1e-14 * size, "what the weights interpolate");
    }
}

void prove_signs(const double *const *v, int orient, int insphere)
{
    require(orient == ex_orient(v[0], v[1], v[2], v[3]), "hh_orient");
    require(insphere == ex_insphere(v[0], v[1], v[2], v[3], v[4]),
            "hh_insphere");
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Are a and b the same but for rounding, beside numbers of this size? */
static int about(double a, double b, double size)
{
    return fabs(a - b) <= 1e-9 * (size + fabs(a) + fabs(b));
}

/* The edges and the unit normal of a facet. */
static void normal(const double *p1, const double *p2, const double *p3,
                   double *a, double *b, double *v)
{
    double length;
    int k;

    for (k = 0; k < 3; k++) {
        a[k] = p2[k] - p1[k];
        b[k] = p3[k] - p1[k];
    }
    for (k = 0; k < 3; k++)
        v[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    length = sqrt(dot(v, v));
    for (k = 0; k < 3; k++) v[k] /= length;
}

void prove_facet(const double *p1, const double *p2, const double *p3,
                 int code, const double *f)
{
    double a[3], b[3], v[3];
    int k, line = ex_collinear(p1, p2, p3);

    require(code == line, "hh_facet's code");
    if (line) {
        for (k = 0; k < 6; k++) require(f[k] == 0.0, "hh_facet of a line");
        return;
    }
    normal(p1, p2, p3, a, b, v);
    for (k = 0; k < 3; k++) require(about(f[k], v[k], 1.0), "the normal");
    /* the centre: in the plane, as far from p1 as from p2 and p3 */
    require(about(dot(f + 3, v), 0.0, f[11]), "the centre");
    require(about(2.0 * dot(f + 3, a), dot(a, a), 0.0), "the centre");
    require(about(2.0 * dot(f + 3, b), dot(b, b), 0.0), "the centre");
    require(about(f[11], sqrt(dot(f + 3, f + 3)), 0.0), "rho");
}

void prove_house(const double *p1, const double *p2, const double *p3,
                 const double *z1, const double *z2, double side, double l,
                 int opp, int code, double c)
{
    double a[3], b[3], g[3], v[3], w[3], x[3];
    int k, s = ex_orient(p1, p2, p3, z1);

    if (ex_collinear(p1, p2, p3)) {
        require(side == 0.0 && opp == 0 && code == 1 && c == 0.0,
                "hh_side, hh_opp, hh_wrap of a line");
        return;
    }
    normal(p1, p2, p3, a, b, v);
    for (k = 0; k < 3; k++) w[k] = z1[k] - p1[k];
    require(about(side, dot(w, v), 1.0), "hh_side");
    require(opp == (s * ex_orient(p1, p2, p3, z2) > 0), "hh_opp");
    require(code == (s == 0 ? 2 : 0), "hh_wrap's code");
    if (s == 0) {
        /* inside the circle of p1, p2, p3 when inside any ball through them;
         * take that of the point above p1 by 1 */
        for (k = 0; k < 3; k++) x[k] = p1[k] + v[k];
        require(l == (ex_insphere(p1, p2, p3, x, z1) > 0 ? -DBL_MAX : DBL_MAX),
                "hh_lcoord in the plane");
        return;
    }
    /* the centre c + l v is as far from p1 as from p2, p3, z1, and so on the
     * axis: l is the one number with |c + l v|^2 = |c + l v - w|^2 */
    for (k = 0; k < 3; k++)
        x[k] = b[k] - dot(a, b) / dot(a, a) * a[k];
    for (k = 0; k < 3; k++) g[k] = x[k] / sqrt(dot(x, x));
    {
        /* c = a/2 + m g with 2 c.b = b.b */
        double m = (dot(b, b) - dot(a, b)) / (2.0 * dot(g, b));

        for (k = 0; k < 3; k++) x[k] = 0.5 * a[k] + m * g[k] + l * v[k];
    }
    require(about(2.0 * dot(x, w), dot(w, w), fabs(dot(x, x))), "hh_lcoord");
    require(about(c, -dot(w, g) / dot(w, v), 1.0), "hh_wrap");
}

int prove_end(void)
{
    fprintf(stderr, "prove: %ld passed, %ld failed\n", proofs - faults, faults);
    return faults != 0;
}
