/* exact.h - exact integer arithmetic, random numbers and the count of passed
 * and failed tests.
 *
 * Numbers are a sign and a magnitude in base 2^16, or 2^32 where a product of
 * two such digits fits.  The arithmetic shares no method with hhpred.c (which
 * keeps integers in doubles), so that a fault would have to be made twice to go
 * unseen.
 *
 * A number of EX_DIGITS digits holds a determinant of degree 5 in
 * differences of any two finite doubles: 5 * 2099 bits and a few.  What
 * exceeds that stops the program.
 */
#ifndef EXACT_H
#define EXACT_H

#include <limits.h>

#if ULONG_MAX / 0xffffffffUL > 0xffffffffUL
#define EX_DIGIT 32
#else
#define EX_DIGIT 16
#endif
#define EX_DIGITS (11520 / EX_DIGIT)

typedef struct ex_num {
    int sign;                   /* -1, 0, 1 */
    int len;                    /* digits in use, the last one not 0 */
    unsigned long d[EX_DIGITS]; /* least significant first */
} ex_num;

void ex_copy(ex_num *r, const ex_num *a);
void ex_int(ex_num *r, long v);
/* r may be a or b in the sum and the difference, not in the product. */
void ex_add(ex_num *r, const ex_num *a, const ex_num *b);
void ex_sub(ex_num *r, const ex_num *a, const ex_num *b);
void ex_mul(ex_num *r, const ex_num *a, const ex_num *b);
/* r times 2^bits, bits >= 0 */
void ex_shift(ex_num *r, int bits);
/* number of bits of the magnitude */
int ex_bits(const ex_num *a);
/* the sign of a - b */
int ex_cmp(const ex_num *a, const ex_num *b);

/* The exponent of the lowest bit of x, or low if that is less. */
int ex_low(double x, int low);
#define EX_NO_LOW 9999
/* r = x / 2^low, an integer when low <= ex_low(x, low). */
void ex_real(ex_num *r, double x, int low);
/* a = m * 2^*e with 0.5 <= |m| < 1 rounded to a long double, or m = 0. */
long double ex_value(const ex_num *a, int *e);

/* r = a . b and r = a x b, three components each */
void ex_dot(ex_num *r, const ex_num *a, const ex_num *b);
void ex_cross(ex_num *r, const ex_num *a, const ex_num *b);

/* det [b-a c-a d-a] in units of 2^(3 low) */
void ex_volume(ex_num *r, int low, const double *a, const double *b,
               const double *c, const double *d);

/* The signs that hh_orient and hh_insphere promise. */
int ex_orient(const double *a, const double *b, const double *c,
              const double *d);
int ex_insphere(const double *a, const double *b, const double *c,
                const double *d, const double *e);
/* The sign of the insphere determinant of the five points p (positive for
 * p[4] inside the ball of the others when det [p0-p3 p1-p3 p2-p3] > 0) after
 * the lifted height |p|^2 of point k is lowered by e_i, i = index[k], with
 * e_0 >> e_1 >> ... > 0.  The e_i are put in as actual numbers, powers of two
 * far enough apart: no rule for ties is made use of.  (Where the range of the
 * coordinates makes those longer than EX_DIGITS, a tie has the sign of the sum's
 * largest term.)  0 only when the five points are coplanar. */
int ex_perturbed(const double *const *p, const int *index);
/* The face of the triangle or tetrahedron v, of m = 3 or 4 vertices in general
 * position, whose interior has the point nearest to q of the convex hull of n
 * points p, those of v among them: the sum of 2^k for its vertices v[k], at
 * most three of them, or 0 if there is none.  w: the m weights of that point.
 * For each face the foot of the perpendicular on its plane or line is tried: if
 * that is inside of the face, and no point is ahead of it on the way to q, it
 * is the one. */
int ex_nearest(int m, const double *const *v, const double *q, long n,
               const double *p, double *w);
/* 1 when a, b, c lie on one line */
int ex_collinear(const double *a, const double *b, const double *c);

/* Reproducible random numbers: rnd_bits gives 32 bits, rnd_unit a value in
 * [0, 1) with 53 bits, rnd_below one of 0 ... n-1; rnd_mix puts n points into
 * random order. */
void rnd_seed(unsigned long seed);
unsigned long rnd_bits(void);
double rnd_unit(void);
int rnd_below(int n);
void rnd_mix(double (*p)[3], int n);

/* test_modes - call all; with -DTEST_ROUNDING, and C99's fenv.h, in each of the
 * four rounding modes. */
void test_modes(void (*all)(void));

/* test_state - what a processor can be set to: bits of an SSE unit's state are
 * set, 0x40 to take subnormal operands for zero, 0x8000 subnormal results, and
 * an x87 unit's precision is 0 (24 bits), 2 (53) or 3 (64); with back, all is
 * what it was before.  0 on other machines. */
int test_state(int back, unsigned bits, unsigned precision);
/* test_flushes - are subnormal numbers flushed to zero (as -Ofast has it)? */
int test_flushes(void);

/* test_result - count and print one test of that name, passed if it had no
 * fault, as a line of TAP (the Test Anything Protocol), whose other lines begin
 * with #; test_that - if it is good, and the name has two parts; test_skip - one
 * that cannot be had, and why.  test_end - print how many there were; the exit
 * code of the program. */
void test_result(const char *name, long faults);
void test_that(int good, const char *of, const char *what);
void test_skip(const char *why);
int test_end(void);

/* test_usage - say which arguments the program takes, and leave with code 2.
 * test_quick - for a program that takes none (0), -quick (1), or -brief (2),
 * which is quicker still.
 * test_number - a whole number from least on; or the same, for text is none. */
void test_usage(const char *program, const char *arguments);
int test_quick(int argc, char **argv);
long test_number(const char *text, long least, char **argv,
                 const char *arguments);

#endif
