/* calls_fortran.c - a C program that calls the FORTRAN version.
 *
 *   gfortran -O2 -frecursive -c f77/tess.f f77/hhpred.f
 *   cc -O2 -c test/samples/calls_fortran.c
 *   gfortran -o fortran fortran.o tess.o hhpred.o
 *
 * gfortran, f2c and most other compilers write the names in small letters with
 * an underscore behind; every argument is a pointer, INTEGER an int, and points
 * and tetrahedra count from 1.  For the reverse see calls_c.f90.
 *
 * The corners of a cube and its centre: 12 tetrahedra, and the value at a place
 * inside of the function 1 + x + 2 y + 3 z, which is linear.
 */
#include <stdio.h>

#define N 9
#define MAXTET (8 * N)
#define LIW (19 * N + 1800)
#define LRW (4 * N + 12)

void tess_(const int *n, const double *p, const int *maxtet, int *ntet,
           int *tet, int *adj, const int *liw, int *iw, const int *lrw,
           double *rw, int *info);
void tesslo_(const double *p, const int *ntet, const int *tet, const int *adj,
             const double *q, int *t, double *w, int *info);

static const double p[3 * N] = {
    0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1,
    0.5, 0.5, 0.5
};
static int tet[4 * MAXTET], adj[4 * MAXTET], iw[LIW];
static double rw[LRW];

int main(void)
{
    const int n = N, maxtet = MAXTET, liw = LIW, lrw = LRW;
    static const double q[3] = {0.25, 0.5, 0.625};
    double w[4], value = 0.0;
    int ntet, info, t = 0, k;

    tess_(&n, p, &maxtet, &ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    if (info != 0) return 1;
    tesslo_(p, &ntet, tet, adj, q, &t, w, &info);
    if (info != 0) return 1;
    for (k = 0; k < 4; k++) {
        const double *x = p + 3 * (tet[4 * (t - 1) + k] - 1);

        value += w[k] * (1.0 + x[0] + 2.0 * x[1] + 3.0 * x[2]);
    }
    printf("%d tetrahedra, value %.6f\n", ntet, value);
    return 0;
}
