/* loops.h - what the timings measure: set up once, then n evaluations at the
 * nz points z in turn, whose values v are returned so that none can be left
 * out.  (A sum would be a chain of additions that takes longer than what is
 * measured.)
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
                  const double *z, double *v);

/* L-coordinates by hhpred, determinants by minors, L-coordinates by BLAS, and
 * the calls that these make */
extern loop lp_house, lp_dets, lp_blas, lp_calls;
extern loop lphous_, lpdets_, lpblas_, lpcall_;

#endif
