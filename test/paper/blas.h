/* blas.h - the Householder predicates of Section 3 with BLAS calls, as the
 * paper tried them: the formulas of hhpred.c, every vector operation a call of
 * level 1.  blas.c compiled as it is gives bl_, in double; with -DSINGLE bs_,
 * in float.
 *
 * f: v 0-2, c-p1 3-5, p1 6-8; returns 1 for a zero divide, else 0.
 */
#ifndef BLAS_H
#define BLAS_H

int bl_facet(const double *p1, const double *p2, const double *p3, double *f);
int bs_facet(const float *p1, const float *p2, const float *p3, float *f);

/* (z-p1).v */
double bl_side(const double *f, const double *z);
float bs_side(const float *f, const float *z);

/* The L-coordinate of z. */
double bl_lcoord(const double *f, const double *z);
float bs_lcoord(const float *f, const float *z);

/* The calls that bl_lcoord makes, with vectors of length 0: what calling
 * costs. */
double bl_calls(const double *f, const double *z);
float bs_calls(const float *f, const float *z);

#endif
