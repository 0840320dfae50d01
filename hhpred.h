/* hhpred.h - predicates for a handful of points in space.
 *
 * SPDX-License-Identifier: 0BSD
 * Copyright (c) 2026 the tess authors
 *
 * Permission to use, copy, modify, and/or distribute this software for any
 * purpose with or without fee is hereby granted.
 *
 * THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
 * REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY
 * AND FITNESS.  IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
 * INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
 * LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR
 * OTHER TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR
 * PERFORMANCE OF THIS SOFTWARE.
 *
 * Part of tess, Delaunay tetrahedralization after C. Hazlewood,
 * "Facet-Based Tetrahedralization Software" (1995), Section 3.
 *
 * Two kinds of routine:
 *   - Householder floating point: hh_facet, hh_side, hh_opp, hh_lcoord,
 *     hh_wrap.  Fast, backward stable, and rounded.  f[9..11] hold what is
 *     needed to bound the error (see hh_facet).
 *   - exact signs: hh_orient, hh_insphere.  Right for all finite doubles, in
 *     every rounding mode, with extended precision, contraction or
 *     reassociation.  Where they cannot be right they say so: for a subnormal
 *     coordinate on a processor that flushes subnormal numbers to zero, and on
 *     a processor that rounds to fewer bits than a double has.
 *
 * No routine allocates, reads, writes, keeps state between calls or stops
 * the program; all may be called from any number of threads.  On ordinary
 * coordinates none sets a floating-point flag but inexact, nor errno.  Whatever
 * the coordinates, hh_orient, hh_insphere, hh_wrap and hh_facet set neither
 * invalid, divide-by-zero nor overflow; but hh_facet sets overflow where a
 * result is beyond DBL_MAX.  hh_side and hh_opp may set them and give a NaN
 * above an eighth of the largest coordinate, hh_lcoord where squares overflow.
 *
 * A point is an array of 3 coordinates.  No argument but f and c is altered.
 */
#ifndef HHPRED_H
#define HHPRED_H

#include <float.h>
#include <limits.h>

/* The version of this file: TESS_VERSION of its tess.h. */
#define HH_VERSION 50000L

/* Stands before each public declaration: nothing, or what exports from a shared
 * library.  With gcc and clang -fvisibility=hidden and
 *     -DTESS_API='__attribute__((visibility("default")))'
 * for 64-bit Windows -DTESS_API='__declspec(dllexport)', and dllimport for the
 * library's callers. */
#ifndef TESS_API
#define TESS_API
#endif

/* The integer of all index arrays.  4*maxtet + 3 must not exceed its largest
 * value.  TESS_INT, the name of a signed type in one word, chooses another:
 * short, on a very small machine; long for more than 79 million points that
 * fill a volume, and where long has 4 bytes, as in 64-bit Windows, ptrdiff_t
 * with -include stddef.h.  Compile all files with the same: see below. */
#ifdef TESS_INT
#if TESS_INT + 0 /* an error here: TESS_INT must be one word; use a typedef */
#endif
typedef TESS_INT tess_int; /* unknown here: include its header before */
#elif INT_MAX >= 2147483647
typedef int tess_int;
#else
typedef long tess_int;
#endif

/* x as another type, without a warning in C++ either. */
#ifdef __cplusplus
#define TESS_TO(type, x) static_cast<type>(x)
#else
#define TESS_TO(type, x) ((type)(x))
#endif

typedef char tess_int_must_be_signed[TESS_TO(tess_int, -1) < 0 ? 1 : -1];

/* The largest.  (No macro names tess_int, which might be in a namespace.) */
#ifdef TESS_INT
#define TESS_INT_MOST \
    (((TESS_TO(TESS_INT, 1) << (sizeof(TESS_INT) * CHAR_BIT - 2)) - 1) * 2 + 1)
#elif INT_MAX >= 2147483647
#define TESS_INT_MOST INT_MAX
#else
#define TESS_INT_MOST LONG_MAX
#endif

/* The coordinates; all arithmetic is in double. */
#ifdef TESS_FLOAT
typedef float tess_real;
#else
typedef double tess_real;
#endif

/* Objects that do not belong together do not link: the linker finds a name
 * undefined.
 *   - A caller and a library of other types: types that are not the default
 *     ones end all external names, in the word that TESS_INT names, and in
 *     float for TESS_FLOAT: tess_long, tess__float.
 *   - tess.c and hhpred.c of other versions, limbs or types: the names that are
 *     tess's own, below, also end in HH_VERSION and HH_LIMBS.
 * Programs use the names of the manual all the same. */
#if defined(TESS_INT) || defined(TESS_FLOAT)
#define TESS_OTHER
#ifndef TESS_FLOAT
#define TESS_AS_2(name, type) name##_##type
#elif defined(TESS_INT)
#define TESS_AS_2(name, type) name##_##type##_float
#else
#define TESS_AS_2(name, type) name##_float
#endif
#define TESS_AS_1(name, type) TESS_AS_2(name, type)
#define TESS_AS(name) TESS_AS_1(name, TESS_INT)
#define hh_facet TESS_AS(hh_facet)
#define hh_side TESS_AS(hh_side)
#define hh_opp TESS_AS(hh_opp)
#define hh_lcoord TESS_AS(hh_lcoord)
#define hh_wrap TESS_AS(hh_wrap)
#define hh_orient TESS_AS(hh_orient)
#define hh_insphere TESS_AS(hh_insphere)
#else
#define TESS_AS(name) name
#endif

/* Exact numbers are arrays of at most HH_LIMBS limbs of HH_BITS bits each.
 * The default holds every finite double beside every other.  Where fewer do
 * not suffice hh_orient and hh_insphere return 2, and tess returns
 * TESS_RANGE.  Scratch on the stack: 44 doubles a limb, 31 KB for 88 limbs,
 * in a routine that is called only where 3 limbs do not suffice.  A number in
 * digits alone, as it is a part of names. */
#if DBL_MANT_DIG >= 53
#define HH_BITS 24
#else
#define HH_BITS 9
#endif
#ifndef HH_LIMBS
#if DBL_MANT_DIG >= 53
#define HH_LIMBS 88
#else
#define HH_LIMBS 32
#endif
#endif
#if HH_LIMBS < 3
#error HH_LIMBS is less than 3
#endif

#define HH_FACET_LEN 12
/* Where in it is what: see hh_facet. */
#define HH_NORMAL 0
#define HH_CENTRE 3
#define HH_BASE 6
#define HH_E 9
#define HH_DC 10
#define HH_RHO 11

/* The bounds of hh_facet hold if E is at most this. */
#define HH_E_MAX 0.5
/* For coordinates of absolute value at most 1 they hold if |w| and the
 * facet's edges are at least this: below it squares might underflow. */
#if DBL_MANT_DIG >= 53
#define HH_LENGTH_MIN 3.4395525670743494e-136 /* 2^-450 */
#else
#define HH_LENGTH_MIN 9.0949470e-13           /* 2^-40  */
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* hh_facet - Householder set-up of the facet p1, p2, p3 (Section 3.1, 3.2).
 *
 *   p1, p2, p3  (in)   the vertices
 *   f           (out)  HH_FACET_LEN doubles:
 *       f[0..2]   v, the unit normal, turned so that
 *                 det [p2-p1 p3-p1 v] > 0
 *       f[3..5]   c - p1, c the circumcentre of the facet
 *       f[6..8]   p1
 *       f[9]      E:   the side of z is certain if |v.w| > E |w|,
 *                 w = z - p1
 *       f[10]     dc:  bound of the error of c - p1
 *       f[11]     rho: |c - p1|
 *
 *   returns 0, or 1 when the points are exactly collinear or not all finite:
 *   then v, c - p1 and rho are zero, and E and dc are DBL_MAX, so that nothing
 *   is certain.
 *
 *   With g = |v.w| - E |w|, L the L-coordinate and rho, dc as above, the
 *   computed L is wrong by at most
 *       dL = |w| (eps (3 |w| + 5 rho) + dc + |L| E) / g + 4 eps |L|,
 *   eps = DBL_EPSILON; derived in hhpred.c.  These bounds hold as long as
 *   E <= 1/2 (HH_E_MAX), and |w| and the facet's edges stay between about
 *   2^-450 and 2^450; a circumcentre beyond DBL_MAX is infinite.
 */
TESS_API int hh_facet(const tess_real *p1, const tess_real *p2,
                      const tess_real *p3, double *f);

/* hh_side - the signed distance (z - p1).v of z from the facet's plane:
 * positive where p1, p2, p3 are seen counter-clockwise (Section 3.1). */
TESS_API double hh_side(const double *f, const tess_real *z);

/* hh_opp - the paper's opp test (Section 3.1): 1 when z1 and z2 are on the
 * same side of the facet's plane, by the computed signs, else 0 (0 too when
 * one of them is computed to lie in the plane). */
TESS_API int hh_opp(const double *f, const tess_real *z1, const tess_real *z2);

/* hh_lcoord - the L-coordinate of z (Section 3.2): the centre of the
 * sphere through p1, p2, p3, z is c + L v.  For z computed to lie in the plane:
 * DBL_MAX when it is outside the facet's circle or on it, else -DBL_MAX. */
TESS_API double hh_lcoord(const double *f, const tess_real *z);

/* hh_wrap - the gift-wrapping primitive about the edge p1 p2 of the facet
 * p1, p2, p3 (Section 3): *c = -(w.g) / (w.v), w = z - p1, v the facet's unit
 * normal, g the unit normal of the edge in the facet's plane, towards p3.
 * Of points on the positive side, the one of least c is wrapped first.
 *
 *   returns 0; 1 when p1, p2, p3 are exactly collinear or not all finite; 2
 *   when z is computed to lie in the plane, or so near to it that *c would
 *   overflow, or is not finite; *c is then 0.
 */
TESS_API int hh_wrap(const tess_real *p1, const tess_real *p2,
                     const tess_real *p3, const tess_real *z, double *c);

/* hh_orient - the exact sign of det [b-a c-a d-a]: 1, 0 or -1; 1 when d is
 * on the side of a, b, c from which they are seen counter-clockwise.  2 when
 * HH_LIMBS limbs do not suffice (never, with the default), for a NaN or an
 * infinity, or when the processor flushes a coordinate to zero or rounds to
 * fewer bits than a double has. */
TESS_API int hh_orient(const tess_real *a, const tess_real *b,
                       const tess_real *c, const tess_real *d);

/* hh_insphere - exact: 1 when e is inside the circumsphere of a, b, c, d,
 * whatever their orientation, -1 when it is outside, 0 when it is on it or a,
 * b, c, d are coplanar.  2 as from hh_orient. */
TESS_API int hh_insphere(const tess_real *a, const tess_real *b,
                         const tess_real *c, const tess_real *d,
                         const tess_real *e);

#ifdef __cplusplus
}
#endif

/* =====================================================================
 * ---- for tess: predicates on an indexed set of points ----
 * What follows is tess's own, and may change.
 * ===================================================================== */

#define HH_AS_2(name, version, limbs) name##_##version##_##limbs
#define HH_AS_1(name, version, limbs) HH_AS_2(name, version, limbs)
#define HH_AS(name) HH_AS_1(TESS_AS(name), HH_VERSION, HH_LIMBS)
#define hh_setup HH_AS(hh_setup)
#define hh_ratio HH_AS(hh_ratio)
#define hh_limits HH_AS(hh_limits)
#define hh_porient HH_AS(hh_porient)
#define hh_pinsphere HH_AS(hh_pinsphere)
#define hh_centre HH_AS(hh_centre)
#define hh_trial HH_AS(hh_trial)
#define hh_relative HH_AS(hh_relative)
#define hh_surface HH_AS(hh_surface)
#define hh_height HH_AS(hh_height)
#define hh_thin HH_AS(hh_thin)
#define hh_horient HH_AS(hh_horient)
#define hh_hinsphere HH_AS(hh_hinsphere)
#define hh_area HH_AS(hh_area)
#define hh_collinear HH_AS(hh_collinear)
#define hh_foot HH_AS(hh_foot)
#define hh_weigh HH_AS(hh_weigh)
#define hh_wider HH_AS(hh_wider)
#define hh_fits HH_AS(hh_fits)
#define hh_finite HH_AS(hh_finite)
#define hh_held HH_AS(hh_held)
#define hh_holds HH_AS(hh_holds)
#define hh_multiply HH_AS(hh_multiply)

/* The least normal number of the coordinates. */
#ifdef TESS_FLOAT
#define HH_REAL_MIN FLT_MIN
#else
#define HH_REAL_MIN DBL_MIN
#endif
/* How many limbs balls and thin facets have, at most 10; what needs more is not
 * made.  Correctness rests on the 10: see value_in_ball.  Scratch on the stack:
 * 36 doubles a limb. */
#if HH_LIMBS <= 6
#define HH_BALL_LIMBS HH_LIMBS
#elif DBL_MANT_DIG < 53
#define HH_BALL_LIMBS 6
#elif HH_LIMBS <= 10
#define HH_BALL_LIMBS HH_LIMBS
#else
#define HH_BALL_LIMBS 10
#endif
/* How many leading rows of a ball's numbers are kept: 5 rows decide a third of
 * the signs on a rotated grid, 6 decide 98 %, 7 decide 99 %. */
#define HH_BALL_ROWS 6
/* How many limbs a point has for hh_relative: the first is that of a coordinate
 * of 1, so they hold all that are above 2^-17 (2^-19 where a double has 24
 * bits). */
#define HH_SPHERE_LIMBS (DBL_MANT_DIG >= 53 ? 3 : 5)
/* How many limbs a point has for hh_height: at the pole of a unit sphere
 * sin(pi) cos(pi/2) takes them all. */
#define HH_HEIGHT_LIMBS 7

/* The sign of a tie in hh_pinsphere: this times 1 or -1. */
#define HH_TIE 3

/* hh_set - the points as tess keeps them.  Position i is place i in the sorted
 * order; duplicates are gone. */
typedef struct hh_set {
    const double *x;       /* 3 doubles a position: the coordinates times one
                            * power of two, of absolute value at most 1.  What
                            * underflows, gradually or to 0, is wrong by at most
                            * DBL_MIN, which absolute terms of bounds cover */
    const tess_real *p;    /* the caller's coordinates, which the exact
                            * arithmetic takes */
    const tess_int *order; /* position -> number in p */
    double exact3;         /* orientations whose permanent is at most this are
                            * computed without rounding, as all coordinates are
                            * small multiples of one power of two and none
                            * underflowed; -1: that is not known; -2: besides,
                            * some coordinate is so small that products of
                            * differences near it may underflow; such points are
                            * scaled anew */
    double exact5;         /* the same of insphere determinants, but for -2 */
    int exponent;          /* x = p 2^-exponent */
} hh_set;

/* hh_ball - a facet and the ball through it and a fourth point, by limbs: for a
 * point z, u = z - base, the side is N.u and the power D |u|^2 - C.u. */
typedef struct hh_ball {
    int n;              /* the number of limbs of u */
    int first_limb;     /* the limbs of u before this one are 0 for the facet
                         * and the fourth point */
    double top;         /* the weight of limb 0 of coordinates times factor */
    double factor;      /* what coordinates are multiplied by: RAISE or 1 */
    double max_abs;     /* the largest coordinate that the limbs hold */
    double base[3 * HH_BALL_LIMBS]; /* the limbs of the base, three coordinates
                                     * side by side */
    double power[4 * HH_BALL_ROWS]; /* the leading rows of C and D */
    double side[4 * HH_BALL_ROWS];  /* those of N; each fourth element is not
                                     * used */
    int e;              /* limb 0 weighs 2^e in scaled coordinates */
    int side_first;     /* the row of N that side begins with */
} hh_ball;

/* hh_sphere - a sphere or a plane by limbs, and what hh_relative keeps. */
typedef struct hh_sphere {
    double base[3 * HH_HEIGHT_LIMBS];         /* the limbs of a point on it */
    double twice_centre[3 * HH_HEIGHT_LIMBS]; /* the limbs of twice the centre,
                                               * seen from there; of a plane, of
                                               * minus the normal */
    double power[4];     /* of hh_relative: the powers of the facet's two other
                          * vertices, of power_best and of power_last */
    int plane;           /* 1: it is a plane */
    int n;               /* the number of limbs in use */
    int e;               /* 2^e is the weight of limb 0 */
    int ready;           /* of hh_relative: 1: it is set up; 0: not yet; -1: it
                          * cannot be had */
    tess_int power_best; /* the position that has power[2], or -1 */
    tess_int power_last; /* the position that has power[3], or -1 */
} hh_sphere;

/* The power |w|^2 - 2 c.w of a point w in the ball of centre c through 0. */
#define HH_POWER(w0, w1, w2, c)                                        \
    ((w0) * ((w0) - 2.0 * (c)[0]) + (w1) * ((w1) - 2.0 * (c)[1]) +     \
     (w2) * ((w2) - 2.0 * (c)[2]))

/* What they do is told in hhpred.c. */
#ifdef __cplusplus
extern "C" {
#endif

void hh_setup(const double *p1, const double *p2, const double *p3, double *f);
void hh_ratio(const double *f, const double *z, double least, double most,
              double *lo, double *hi);
int hh_limits(const double *f, const double *z, double *lo, double *hi);
int hh_porient(const hh_set *s, tess_int i, tess_int j, tess_int k, tess_int l);
int hh_pinsphere(const hh_set *s, const tess_int *v, tess_int a, tess_int b,
                 int rule);
int hh_centre(const hh_set *s, const tess_int *v, int base, tess_int z,
              double *c, hh_ball *t);
void hh_trial(const hh_set *s, const hh_ball *t, tess_int z, int *side,
              int *power);
int hh_relative(const hh_set *s, const tess_int *v, int base, const double *f,
                double l, tess_int a, tess_int z, hh_sphere *t);
int hh_surface(const hh_set *s, tess_int base, tess_int from, int plane,
               const double *c, hh_sphere *t);
double hh_height(const hh_set *s, const hh_sphere *t, tess_int z, double *err);
int hh_thin(const hh_set *s, const tess_int *v, int base, double *f);
int hh_horient(const tess_real *a, const tess_real *b, const tess_real *c,
               const tess_real *d);
int hh_hinsphere(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d, const tess_real *e);
int hh_area(int axis, const tess_real *a, const tess_real *b,
            const tess_real *c);
int hh_collinear(const tess_real *a, const tess_real *b, const tess_real *c);
int hh_foot(const tess_real *a, const tess_real *b, const tess_real *c,
            const tess_real *q, double *w);
int hh_weigh(const tess_real *p, const tess_int *v, const tess_real *q,
             double *w);
int hh_wider(double a, double b, double c, double d);
int hh_fits(double x, double most);
tess_int hh_finite(tess_int n, const tess_real *p);
int hh_held(const tess_real *p);
int hh_holds(tess_int n, const tess_real *p);
void hh_multiply(tess_int n, double *q, double f);

#ifdef __cplusplus
}
#endif

#endif
