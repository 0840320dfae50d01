/* five.h - what the tests of hhpred.c share: classes of five points that are made
 * to be hard. */
#ifndef FIVE_H
#define FIVE_H

#include "../../../hhpred.h"

/* Where gcc computes by an x87 unit, it says 2. */
#ifdef __FLT_EVAL_METHOD__
#define BY_X87 (__FLT_EVAL_METHOD__ == 2)
#else
#define BY_X87 0
#endif

#ifdef TESS_FLOAT
#define REAL_EPS FLT_EPSILON
#define REAL_MAX FLT_MAX
#define MANT_DIG FLT_MANT_DIG
#define MAX_EXP FLT_MAX_EXP
#else
#define REAL_EPS DBL_EPSILON
#define REAL_MAX DBL_MAX
#define MANT_DIG DBL_MANT_DIG
#define MAX_EXP DBL_MAX_EXP
#endif
/* the exponents of the scales of about 1e60, 1e150, 1e300 in double */
#define SCALE(i) (MAX_EXP * (i) / 1024)

/* The classes, and their names. */
enum {
    RANDOM, LATTICE, INTEGERS, TENTHS, PLANE, SPHERE, NORMED, PAIRS, OFFSET,
    SCALED, MIXED, SUBNORMAL, EXTREME, FARAPART, INTEGER_PLANE,
    INTEGER_SPHERE, LIMBS, BOXES, CLASSES
};
extern const char *const names[CLASSES];

/* The five points of a case, as hhpred.c sees them and, the same values, as
 * exact.c does. */
extern tess_real R[5][3];
extern double P[5][3];

/* R and P from p, rounded; print n of them. */
void settle(double p[5][3]);
void show(int n);
/* x moved by k units in its last place (not across a power of two) */
double nudge(double x, int k);
/* a number in (-1, 1) */
double sym(void);
/* a dyadic number in (-1, 1) with that many bits */
double dyadic(int bits);
/* one of any exponent in that span */
double mixed(int span);
/* what the classes of cospherical integers need */
void find_sphere(void);
/* the points of a class, before duplicates */
void make(int group, double p[5][3]);
/* the exponent of the unit of n of them */
int low_of(int n);
/* main of such a test: all its tests, by take.h; *percent of the cases, and the
 * seed, are its arguments */
int five_main(int argc, char **argv, void (*all)(void), long *percent);

#endif
