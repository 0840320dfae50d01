/* loops.h - what the timings measure: set up once, then n evaluations at the
 * nz points z in turn, whose sum is returned so that none can be left out.
 *
 *   p  four points: the facet p1, p2, p3, and p4
 *
 * Arguments by reference, so that the loops of C and of FORTRAN 77 (their
 * names as gfortran and f2c decorate them) are called alike.  The twin of
 * loops.c is loops.f.
 */
#ifndef LOOPS_H
#define LOOPS_H

typedef void loop(const int *n, const double *p, const int *nz,
                  const double *z, double *sum);

/* L-coordinates by hhpred, determinants by minors, L-coordinates by BLAS */
extern loop lp_house, lp_dets, lp_blas, lphous_, lpdets_, lpblas_;

#endif
