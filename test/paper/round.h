/* round.h - the paper's two insphere tests in arithmetic of 24 or 53 bits.
 *
 * Every operation's result is stored to a volatile float (24 bits, the
 * paper's 32-bit arithmetic) or a volatile double (53, its 64-bit
 * arithmetic) before it is used.  So it is rounded there, on every machine:
 * with or without extended precision, contraction or vectors.  The operations
 * themselves are done in double or more: 53 bits are at least 2 * 24 + 2, so
 * that a sum, difference, product, quotient or square root of floats, rounded
 * to double and then to float, is what float arithmetic gives.
 *
 * (Where double arithmetic is done with more than 53 bits, the 64-bit
 * arithmetic is rounded twice; the 32-bit arithmetic never differs.)
 *
 * Compiled with -DPLAIN it is ordinary arithmetic in double.
 */
#ifndef ROUND_H
#define ROUND_H

#define RA_FACET_LEN 13
#define RA_MINORS 5

/* The arithmetic from here on: 24 or 53 bits. */
void ra_bits(int bits);
/* x, rounded */
double ra_keep(double x);
double ra_add(double a, double b);
double ra_sub(double a, double b);
double ra_mul(double a, double b);
double ra_div(double a, double b);
double ra_root(double a);
double ra_dot(const double *a, const double *b);

/* Householder set-up of a facet, operation by operation that of hhpred.c: f
 * has the normal v 0-2, turned so that det [p2-p1 p3-p1 v] > 0, c-p1 3-5,
 * p1 6-8, and the column that the second reflector is made of, 9-10, r11 and
 * r22.  1 for a zero divide, else 0. */
int ra_facet(const double *p1, const double *p2, const double *p3, double *f);
/* The distance of z from the facet's plane. */
double ra_side(const double *f, const double *z);
/* The L-coordinate of z, by the paper's formula; 1 for a zero divide, else
 * 0. */
int ra_lcoord(const double *f, const double *z, double *l);

/* The minors of the rows (x, y, z, x^2+y^2+z^2, 1) of four points, set up
 * once; and the determinant whose fifth row is that of z, by these minors.  It
 * is positive for z inside the ball of a, b, c, d if det [b-a c-a d-a] > 0. */
void ra_minors(const double *a, const double *b, const double *c,
               const double *d, double *m);
double ra_det(const double *m, const double *z);

#endif
