/* blas.c - the Householder predicates with BLAS calls; see blas.h.
 *
 * The BLAS is that of C (CBLAS), declared here so that no header need be
 * found.  The twin of blas.f. */
#include "blas.h"

#include <math.h>

#ifdef SINGLE
typedef float real;
#define BLAS(name) cblas_s##name
#define OURS(name) bs_##name
#else
typedef double real;
#define BLAS(name) cblas_d##name
#define OURS(name) bl_##name
#endif

extern real BLAS(dot)(int n, const real *x, int incx, const real *y, int incy);
extern real BLAS(nrm2)(int n, const real *x, int incx);
extern void BLAS(axpy)(int n, real a, const real *x, int incx, real *y,
                       int incy);
extern void BLAS(copy)(int n, const real *x, int incx, real *y, int incy);

/* minus - w = a - b */
static void minus(const real *a, const real *b, real *w)
{
    BLAS(copy)(3, a, 1, w, 1);
    BLAS(axpy)(3, (real)-1.0, b, 1, w, 1);
}

/* reflector - u and b of the reflector I - b u u' that takes x, n components,
 * to r e1; 1 for a zero divide. */
static int reflector(int n, const real *x, real *u, real *b, real *r)
{
    real norm = BLAS(nrm2)(n, x, 1), t;

    *r = x[0] > 0 ? -norm : norm;
    BLAS(copy)(n, x, 1, u, 1);
    u[0] -= *r;
    t = norm * (norm + (x[0] > 0 ? x[0] : -x[0]));
    *b = t == 0 ? 0 : (real)1.0 / t;
    return t == 0;
}

/* reflect - x turned by a reflector */
static void reflect(int n, const real *u, real b, real *x)
{
    BLAS(axpy)(n, -b * BLAS(dot)(n, u, 1, x, 1), u, 1, x, 1);
}

int OURS(facet)(const real *p1, const real *p2, const real *p3, real *f)
{
    real a[3], b[3], u1[3], u2[2], b1, b2, r11, r22;
    int zero;

    minus(p2, p1, a);
    minus(p3, p1, b);
    zero = reflector(3, a, u1, &b1, &r11);
    reflect(3, u1, b1, b);
    if (reflector(2, b + 1, u2, &b2, &r22)) zero = 1;
    f[0] = f[1] = f[5] = 0;
    f[2] = (real)((r11 < 0) == (r22 < 0) ? 1.0 : -1.0);
    reflect(2, u2, b2, f + 1);
    reflect(3, u1, b1, f);
    BLAS(copy)(3, p1, 1, f + 6, 1);
    if (zero) return 1;
    f[3] = (real)0.5 * r11;
    f[4] = (real)0.5 * (r22 + b[0] / r22 * (b[0] - r11));
    reflect(2, u2, b2, f + 4);
    reflect(3, u1, b1, f + 3);
    return 0;
}

real OURS(side)(const real *f, const real *z)
{
    real w[3];

    minus(z, f + 6, w);
    return BLAS(dot)(3, f, 1, w, 1);
}

real OURS(lcoord)(const real *f, const real *z)
{
    real w[3];

    minus(z, f + 6, w);
    return (BLAS(dot)(3, w, 1, w, 1) -
            (real)2.0 * BLAS(dot)(3, f + 3, 1, w, 1)) /
           ((real)2.0 * BLAS(dot)(3, f, 1, w, 1));
}

real OURS(calls)(const real *f, const real *z)
{
    real w[3];

    w[0] = z[0];
    BLAS(copy)(0, z, 1, w, 1);
    BLAS(axpy)(0, (real)-1.0, f + 6, 1, w, 1);
    return (BLAS(dot)(0, w, 1, w, 1) + BLAS(dot)(0, f + 3, 1, w, 1)) +
           (BLAS(dot)(0, f, 1, w, 1) + w[0]);
}
