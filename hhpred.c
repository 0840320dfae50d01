/* hhpred.c - predicates for a handful of points in space; see hhpred.h.
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
 * HOW THIS FILE IS LAID OUT.  A routine stands before those that call it; no
 * declaration is ahead.  Part I of tess.c needs all but the last chapter, of
 * which it has hh_thin alone.
 *   exact numbers     integers kept in doubles, and what is computed of them
 *   the arithmetic    what the processor makes of coordinates
 *   exact signs       orientation and insphere, of points or of positions in a
 *                     set: a filter in doubles, then exact numbers
 *   the tie rule      which of cospherical points is the apex
 *   Householder       the facet's normal and centre, the L-coordinate, with the
 *                     bounds on their errors that searches rest on
 *   balls by limbs    a ball, a sphere or a plane set up once, so that a few
 *                     limbs of a point decide
 *
 * A reader of the paper, C. Hazlewood, "Facet-Based Tetrahedralization
 * Software" (1995), starts at "Householder transformations":
 *   Section 2, Figure 4    the rule for cospherical points: break_tie,
 *                          hh_pinsphere.  (The rest of Section 2 is tess.c.)
 *   Section 3              P = Q R: householder, apply_q; the gift-wrapping
 *                          primitive: hh_wrap
 *   Section 3.1            the normal, the opp test: hh_setup, hh_facet,
 *                          hh_side, hh_opp
 *   Section 3.2            the L-coordinate: hh_setup, hh_lcoord
 * The paper's errors are backward; hh_limits and hh_ratio have forward bounds,
 * derived at the head of that chapter.
 */
#include "hhpred.h"
#if HH_VERSION != 50000L
#error hhpred.c and hhpred.h are of different versions
#endif
#include <math.h>
#include <stddef.h>
/* An integer of at least 32 bits. */
#if INT_MAX >= 2147483647
typedef int whole;
#else
typedef long whole;
#endif
#define UNSURE 2 /* a sign that bounds, or too few limbs, leave open */
/* Constants that correctness rests on, for doubles of 53 bits and of 24:
 *   BASE            the base of limbs, 2^HH_BITS
 *   CARRY           2^(DBL_MANT_DIG - HH_BITS), a bound on carries
 *   PROBE           2^h, 2h + 1 <= DBL_MANT_DIG: see full_precision
 *   DET_UNDERFLOW   an absolute error no smaller than what underflow, gradual
 *                   or to zero, does to a determinant of differences of at most
 *                   2
 *   RAISE           BASE^RAISE_LIMBS: exact numbers that are all below
 *                   RAISE_BELOW are first multiplied by it, so that no limb's
 *                   weight underflows
 *   QUICK_SCALE     2^-QUICK_EXP: coordinates between it and 1/QUICK_SCALE are
 *                   scaled by one multiplication
 *   CENTRE_EXP_MAX  the exponent of a centre that is too far for squares
 * RAISE and QUICK_SCALE must be exact powers of two: products of integers are,
 * where a decimal constant might be kept with more digits than a double has. */
#define POWER5 (BASE * BASE * BASE * BASE * BASE)
#if DBL_MANT_DIG >= 53
#define BASE 16777216.0
#define CARRY 536870912.0
#define PROBE 67108864.0
#define DET_UNDERFLOW 9.3326361850321888e-302 /* 2^-1000 */
#define RAISE (POWER5 * POWER5 * POWER5 * POWER5 * POWER5)
#define RAISE_LIMBS 25
#define RAISE_BELOW 6.2230152778611417e-61    /* 2^-200 */
#define QUICK_SCALE (1.0 / (BASE * BASE * BASE * BASE))
#define QUICK_EXP 96
#define CENTRE_EXP_MAX 300
#else
#define BASE 512.0
#define CARRY 32768.0
#define PROBE 2048.0
#define DET_UNDERFLOW 8.0779357e-28           /* 2^-90 */
#define RAISE (POWER5 * BASE * BASE)
#define RAISE_LIMBS 7
#define RAISE_BELOW 9.5367432e-7              /* 2^-20 */
#define QUICK_SCALE (1.0 / (BASE * BASE))
#define QUICK_EXP 18
#define CENTRE_EXP_MAX 30
#endif

/* ---------------------------------------------------------------------
 * Exact numbers.
 *
 * A number is an array of limbs, most significant first, each an integer
 * kept in a double; limb i weighs BASE^-i times what limb 0 does.  Limbs of
 * coordinates are balanced, |limb| <= BASE/2 and for limb 0 BASE/4, so those
 * of a difference are at most BASE and need no carry.  Every value formed
 * stays below 2^DBL_MANT_DIG, so every operation is exact: in any rounding
 * mode, with extended precision, contraction or reassociation.  (Expansions of
 * doubles, as in J. R. Shewchuk, Discrete Comput. Geom. 18, 1997, 305-363, rely
 * on exact rounding instead.)
 *
 * Numbers that are worked on together lie side by side: limb i of number k of
 * w is at w i + k.  Limb 0 of a product weighs BASE times the product of the
 * two limbs 0.  31 products of limbs of at most BASE fit one limb: 10 rows of 2
 * or 3 such products, or of 4 where one factor has been carried to at most
 * BASE/2 + 1.  (Limbs 0 are no exception: they are at most BASE/2 for a minor,
 * 3/4 BASE for a 3 by 3 determinant or a square, as the coordinates' are at
 * most BASE/4.)
 * --------------------------------------------------------------------- */

/* The largest double below a half: see split_limbs. */
#define BELOW_HALF (0.5 - 0.25 * DBL_EPSILON)
/* How many limbs hold the value of a number to a double's precision. */
#define DOUBLE_LIMBS (DBL_MANT_DIG / HH_BITS + 2)

/* round_limb - returns an integer within 1/2 + 2 / BASE of q, |q| <= 0.97
 * CARRY, at ties either: the offset makes q positive, and its rounding may take
 * it across a half. */
static double round_limb(double q)
{
    return (double)((whole)(q + (CARRY + 0.5)) - (whole)CARRY);
}

/* set_zeros - sets n numbers r to 0. */
static void set_zeros(int n, double *r)
{
    int i;

    for (i = 0; i < n; i++) r[i] = 0.0;
}

/* all_zero - returns 1 if all n numbers r are 0. */
static int all_zero(int n, const double *r)
{
    while (n > 0 && r[n - 1] == 0.0) n--;
    return n == 0;
}

/* first_row - returns the first of n rows of r, step apart, whose first wide
 * numbers are not all 0; n if there is none. */
static int first_row(int n, int wide, int step, const double *r)
{
    int i = 0;

    while (i < n && all_zero(wide, r + step * i)) i++;
    return i;
}

/* hh_multiply - multiplies n coordinates q by f, one at a time (volatile), in
 * the arithmetic that hh_holds has tested: a compiler may use another one for
 * vectors. */
void hh_multiply(tess_int n, double *q, double f)
{
    volatile double factor = f;
    tess_int i;

    for (i = 0; i < n; i++) q[i] *= factor;
}

/* top_weight - multiplies n coordinates q by the *factor that keeps the weights
 * of limbs from underflowing; most > 0 is their largest absolute value.
 * Returns the weight of limb 0 for which most fills the limb. */
static double top_weight(int n, double *q, double most, double *factor)
{
    int e;

    *factor = most < RAISE_BELOW ? RAISE : 1.0;
    if (most < RAISE_BELOW) hh_multiply((tess_int)n, q, RAISE);
    frexp(most * *factor, &e);
    return ldexp(1.0, e + 2 - HH_BITS);
}

/* split_limbs - splits w numbers q into n limbs each, side by side.  Limb 0 has
 * the weight top, a power of two, and |q| <= top BASE/4.  Returns the number of
 * limbs in use, or n + 1 if n limbs do not hold the numbers.
 *
 * The remainder of a number after a limb has no bits below the number's own,
 * and is exact as long as it is no larger than the number.  So a limb is 0 for
 * a remainder of less than half its weight: with BELOW_HALF, the largest number
 * below a half, in place of a half no rounding makes 1 of the sum.  A number
 * whose first RAISE_LIMBS limbs are 0 is far below top, and is taken up after
 * these limbs. */
static int split_limbs(int w, const double *q, double top, int n, double *limb)
{
    double least = top * (0.5 / RAISE), x, rest, c;
    int used = 1, i, k;

    set_zeros(w * n, limb);
    for (k = 0; k < w; k++, limb++) {
        x = q[k];
        for (i = 0; x != 0.0 && fabs(x) < least; i += RAISE_LIMBS)
            hh_multiply(1, &x, RAISE);
        for (rest = x / top; rest != 0.0; i++) {
            if (i >= n) return n + 1;
            c = (double)(whole)(rest + (rest < 0.0 ? -BELOW_HALF : BELOW_HALF));
            limb[w * i] = c;
            rest = (rest - c) * BASE;
        }
        if (i > used) used = i;
    }
    return used;
}

/* carry - reduces the limbs of w numbers, step doubles apart and below
 * 2^DBL_MANT_DIG, to at most BASE/2, from the last one up.  Limb 0 keeps what
 * is carried into it. */
static void carry(int n, int w, int step, double *r)
{
    double c;
    int i, k;

    for (i = n - 1, r += step * i; i > 0; i--, r -= step)
        for (k = 0; k < w; k++) {
            c = round_limb(r[k] / BASE);
            r[k] -= c * BASE;
            r[k - step] += c;
        }
}

/* sign_of_limbs - returns the sign of r, by Horner's rule from the top; or, if
 * r errs by up to err > 0 units of its last limb, UNSURE where that could
 * change it.  After a partial sum of more than 2 CARRY + err units neither the
 * rest, carried or not, nor err can change the sign.  (The last sum may pass
 * 2^DBL_MANT_DIG, several times that, and be rounded; the rounding of a number
 * that large does not change its sign, and ends the loop.) */
static int sign_of_limbs(int n, double err, const double *r)
{
    double s = 0.0;
    int i;

    for (i = 0; i < n && fabs(s) <= 2.0 * CARRY + err; i++) s = s * BASE + r[i];
    if (fabs(s) <= err) return err > 0.0 ? UNSURE : 0;
    return s > 0.0 ? 1 : -1;
}

/* split_differences - splits the 3 np coordinates q of np points, side by side,
 * and subtracts the last point from all others.  Returns the number of limbs in
 * use, or n + 1 if n limbs do not hold them. */
static int split_differences(int np, const double *q, double top, int n,
                             double *x)
{
    const double *last;
    int w = 3 * np, used = split_limbs(w, q, top, n, x), i;

    for (i = 0; i < used && i < n; i++, x += 3)
        for (last = x + w - 3; x < last; x += 3) {
            x[0] -= last[0];
            x[1] -= last[1];
            x[2] -= last[2];
        }
    return used;
}

/* lesser_of - returns the smaller of i and k. */
static int lesser_of(int i, int k)
{
    return i < k ? i : k;
}

/* The kinds of product of x and y, for limbs i and j of theirs:
 *   DOT       x.y
 *   COFACTOR  of four numbers each, x1 y0 - x0 y1 + x3 y2 - x2 y3
 *   CROSS     the cross product
 *   SCALED    the vector x times the number y
 *   SQUARES   of vectors a, b, c, d side by side, x = y, the four squares
 *   PAIRED    with y of two vectors, a and b times the first, c and d times the
 *             second */
enum { DOT, COFACTOR, CROSS, SCALED, SQUARES, PAIRED };

/* add_product - adds a product of x and y, of nx and ny limbs, to the
 * wide[kind] numbers r, of n limbs; wx, wy and w doubles lie between two
 * limbs.  Rows behind the n-th are left out.  r is carried where 10 rows have
 * been added, but not at the end. */
static void add_product(int kind, int nx, int wx, const double *x, int ny,
                        int wy, const double *y, int n, int w, double *r)
{
    static const int used[6] = {3, 4, 3, 3, 12, 12};
    static const int wide[6] = {1, 1, 3, 3, 4, 4};
    const int p = kind == SQUARES ? 3 : 0; /* y's 0 1 2 3, or 0 0 1 1 */
    const double *t, *end;
    double a, b, c, d, *s;
    int rows = 0;

    for (; nx > 0 && n > 1; nx--, n--, x += wx, r += w) {
        a = x[0], b = x[1], c = x[2];
        if (a == 0.0 && b == 0.0 && c == 0.0 && all_zero(used[kind], x))
            continue;
        if (rows++ == 10) {
            carry(n, wide[kind], w, r);
            rows = 1;
        }
        t = y;
        end = y + wy * lesser_of(ny, n - 1);
        s = r + w;
        switch (kind) {
        case DOT:
            for (; t < end; t += wy, s += w)
                s[0] += a * t[0] + b * t[1] + c * t[2];
            break;
        case COFACTOR:
            d = x[3];
            for (; t < end; t += wy, s += w)
                s[0] += b * t[0] - a * t[1] + d * t[2] - c * t[3];
            break;
        case CROSS:
            for (; t < end; t += wy, s += w) {
                s[0] += b * t[2] - c * t[1];
                s[1] += c * t[0] - a * t[2];
                s[2] += a * t[1] - b * t[0];
            }
            break;
        case SCALED:
            for (; t < end; t += wy, s += w) {
                s[0] += a * t[0];
                s[1] += b * t[0];
                s[2] += c * t[0];
            }
            break;
        default:
            for (; t < end; t += wy, s += w) {
                s[0] += a * t[0] + b * t[1] + c * t[2];
                s[1] += x[3] * t[p] + x[4] * t[p + 1] + x[5] * t[p + 2];
                s[2] += x[6] * t[p + 3] + x[7] * t[p + 4] + x[8] * t[p + 5];
                s[3] += x[9] * t[2 * p + 3] + x[10] * t[2 * p + 4] +
                        x[11] * t[2 * p + 5];
            }
        }
    }
}

/* The next routines, whose names end in _by_limbs, evaluate points from the
 * rows p - last, of n limbs, that split_differences leaves in work, of which
 * they may use 44n doubles. */

/* orient_by_limbs - returns the orientation of points a, b, c, d: minus the
 * sign of the determinant of the rows a-d, b-d, c-d. */
static int orient_by_limbs(int n, double *work, double *w)
{
    double *minor = work + 12 * n, *det = minor + 6 * n;

    (void)w;
    set_zeros(9 * n, minor);
    add_product(CROSS, n, 12, work, n, 12, work + 3, 2 * n, 3, minor);
    carry(2 * n, 3, 3, minor);
    add_product(DOT, n, 12, work + 6, 2 * n, 3, minor, 3 * n, 1, det);
    return -sign_of_limbs(3 * n, 0.0, det);
}

/* cofactors - computes the determinants of three of the rows a-e, b-e, c-e,
 * d-e, without b, a, d and c in turn: four numbers, side by side, of 3n limbs,
 * the last 12n of 39n doubles. */
static void cofactors(int n, double *work)
{
    double *minor = work + 15 * n, *det = minor + 12 * n;

    set_zeros(24 * n, minor);
    add_product(CROSS, n, 15, work + 6, n, 15, work + 9, 2 * n, 6, minor);
    add_product(CROSS, n, 15, work, n, 15, work + 3, 2 * n, 6, minor + 3);
    carry(2 * n, 6, 6, minor);
    add_product(PAIRED, n, 15, work, 2 * n, 6, minor, 3 * n, 4, det);
    carry(3 * n, 4, 4, det);
}

/* insphere_by_limbs - returns the sign of the determinant I of insphere_filter.
 */
static int insphere_by_limbs(int n, double *work, double *w)
{
    double *lift = work + 15 * n, *det = lift + 12 * n, *sum = det + 12 * n;

    (void)w;
    cofactors(n, work);
    set_zeros(8 * n, lift);
    set_zeros(5 * n, sum);
    add_product(SQUARES, n, 15, work, n, 15, work, 2 * n, 4, lift);
    carry(2 * n, 4, 4, lift);
    add_product(COFACTOR, 2 * n, 4, lift, 3 * n, 4, det, 5 * n, 1, sum);
    return sign_of_limbs(5 * n, 0.0, sum);
}

/* leading_value - returns the value of a carried number in units of its first
 * limb that is not 0, limb *at.  Behind it comes at most half a unit and a
 * little, so the value is at least nearly one half: the rounding of the last
 * sum and that of the one before, of at most half a unit, count for less than
 * 2.1 eps of it. */
static double leading_value(int n, const double *r, int step, int *at)
{
    double sum = 0.0;
    int i = first_row(n - 1, 1, step, r);
    int last = lesser_of(i + DOUBLE_LIMBS, n);

    *at = i;
    while (--last >= i) sum = sum / BASE + r[step * last];
    return sum;
}

/* normalize_weights - divides the absolute values of n numbers w, whose leading
 * limbs are limbs at, by their sum.  Each weight is right to 12 eps of itself,
 * as the numbers are to 2.1 eps, or underflows.  w is left alone if all are 0.
 */
static void normalize_weights(int n, const int *at, double *w)
{
    double sum = 0.0;
    int top = INT_MAX, k;

    for (k = 0; k < n; k++)
        if (w[k] != 0.0) top = lesser_of(top, at[k]);
    for (k = 0; k < n; k++) {
        if (w[k] != 0.0) w[k] = fabs(ldexp(w[k], (top - at[k]) * HH_BITS));
        sum += w[k];
    }
    for (k = 0; k < n && sum > 0.0; k++) w[k] /= sum;
}

/* nearest_face - returns the face of a triangle whose interior has the
 * triangle's point nearest to q: the sum of 2^k for its vertices k.  Side i
 * leads from vertex i to the next one; dot[3i+k] has the sign of the product of
 * side i and q - vertex k, area[k] that of the weight of vertex k at the foot
 * of the perpendicular from q. */
static int nearest_face(const double *dot, const double *area)
{
    int i, j, k;

    for (i = 0; i < 3; i++) {
        k = (i + 2) % 3;
        if (dot[4 * i] <= 0.0 && dot[3 * k + i] >= 0.0) return 1 << i;
    }
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        k = (i + 2) % 3;
        if (area[k] <= 0.0 && dot[4 * i] >= 0.0 && dot[3 * i + j] <= 0.0)
            return (1 << i) + (1 << j);
    }
    return 7;
}

/* foot_by_limbs - returns minus nearest_face's answer, and the weights w of the
 * vertices in that point: shares of areas or, on a side, of products with it.
 * The rows u, v, w = b-a, c-a, q-a of a triangle a, b, c give the products
 * dot[3i+k] of sides u, v-u, -v and offsets w, w-u, w-v, and with sides s and
 * offsets o
 *     area[k] = (s_i.o_j) (s_k.o_i) - (s_i.o_i) (s_k.o_j), i, j, k cyclic:
 * component k of the cross product of the products of s_k and of s_i. */
static int foot_by_limbs(int n, double *work, double *w)
{
    static const int pair[5][2] = {{0, 6}, {3, 6}, {0, 0}, {0, 3}, {3, 3}};
    double *dot = work + 12 * n, *area = dot + 18 * n, *r, value[12];
    const double *s;
    int at[12], from[3], i, k, l, set;

    set_zeros(10 * n, area);
    for (k = 0; k < 5; k++)
        add_product(DOT, n, 12, work + pair[k][0], n, 12, work + pair[k][1],
                    2 * n, 5, area + k);
    carry(2 * n, 5, 5, area);
    for (i = 0, r = dot, s = area; i < 2 * n; i++, r += 9, s += 5) {
        r[0] = s[0];
        r[1] = s[0] - s[2];
        r[2] = s[0] - s[3];
        r[6] = -s[1];
        r[7] = s[3] - s[1];
        r[8] = s[4] - s[1];
        for (k = 0; k < 3; k++) r[3 + k] = -r[k] - r[6 + k];
    }
    carry(2 * n, 9, 9, dot);
    for (k = 0; k < 9; k++) value[k] = leading_value(2 * n, dot + k, 9, at + k);
    for (k = 0; k < 3; k++) {
        set_zeros(12 * n, area);
        add_product(CROSS, 2 * n, 9, dot + 3 * k, 2 * n, 9,
                    dot + 3 * ((k + 1) % 3), 4 * n, 3, area);
        carry(4 * n, 3, 3, area);
        value[9 + k] = leading_value(4 * n, area + k, 3, at + 9 + k);
    }
    set = nearest_face(value, value + 9);
    for (k = 0; k < 3; k++) {
        from[k] = 9 + k;
        w[k] = (double)(set >> k & 1);
    }
    if (set == 1 || set == 2 || set == 4) return -set;
    for (k = 0; k < 3; k++) {
        l = (k + 1) % 3;
        if (w[(k + 2) % 3] > 0.0) continue;
        from[k] = 3 * k + l;
        from[l] = 4 * k;
    }
    for (k = 0; k < 3; k++) {
        w[k] *= value[from[k]];
        from[k] = at[from[k]];
    }
    normalize_weights(3, from, w);
    return -set;
}

/* weights_by_limbs - computes the weights w of the point e in the tetrahedron
 * a, b, c, d that contains it: shares of the volumes of the four tetrahedra in
 * which e replaces a vertex.  Returns 0. */
static int weights_by_limbs(int n, double *work, double *w)
{
    int at[4], k;

    cofactors(n, work);
    for (k = 0; k < 4; k++)
        w[k ^ 1] = leading_value(3 * n, work + 27 * n + k, 4, at + (k ^ 1));
    normalize_weights(4, at, w);
    return 0;
}

/* orient_by_limbs or foot_by_limbs, for 4 points; insphere_by_limbs or
 * weights_by_limbs, for 5. */
typedef int limb_method(int n, double *work, double *w);

/* evaluate - evaluates np points q with n limbs; returns UNSURE if these do not
 * hold them.  work: 44n doubles.  Limbs 0 that are 0 in all rows are left out
 * as long as the next ones can serve as limbs 0. */
static int evaluate(int np, limb_method *of, const double *q, double top, int n,
                    double *work, double *w)
{
    int wide = 3 * np, used = split_differences(np, q, top, n, work), k;

    if (used > n) return UNSURE;
    for (; used > 1; used--, work += wide) {
        for (k = 0; k < wide - 3 && work[k] == 0.0 &&
                    fabs(work[wide + k]) <= BASE / 4.0;)
            k++;
        if (k < wide - 3) break;
    }
    return of(used, work, w);
}

/* evaluate_long - does what evaluate does, with as many limbs as it takes: a
 * routine of its own for the sake of its scratch. */
static int evaluate_long(int np, limb_method *of, const double *q, double top,
                         double *w)
{
    double work[44 * HH_LIMBS];
    int sign = UNSURE, n;

    for (n = HH_BALL_LIMBS; sign == UNSURE && n <= HH_LIMBS; n *= 2) {
        if (2 * n > HH_LIMBS) n = HH_LIMBS;
        sign = evaluate(np, of, q, top, n, work, w);
    }
    return sign;
}

/* evaluate_exactly - evaluates np points q with 3 limbs, which hold ordinary
 * data (70 bits), or with evaluate_long; most is the largest absolute value of
 * q, which it alters.  If all are 0, so are an orientation and an insphere
 * determinant; no triangle for foot_by_limbs and no tetrahedron for
 * weights_by_limbs has all its vertices there. */
static int evaluate_exactly(int np, limb_method *of, double *q, double most,
                            double *w)
{
    double work[44 * 3], factor, top;
    int sign;

    if (most == 0.0) return 0;
    top = top_weight(3 * np, q, most, &factor);
    sign = evaluate(np, of, q, top, 3, work, w);
    return sign == UNSURE && HH_LIMBS > 3 ? evaluate_long(np, of, q, top, w)
                                          : sign;
}

/* ---------------------------------------------------------------------
 * The arithmetic: what numbers are, and what becomes of them here.
 * --------------------------------------------------------------------- */

/* hh_finite - returns how many of n points p, counted from the first, have
 * finite coordinates before one that has not: n if all have.
 *
 * The test is by bits: a compiler that was told that there are no NaNs may drop
 * any comparison that looks for them.  The least normal number, 2^e, has the
 * exponent 1; 2^(1-e) has the greatest exponent of a finite number, all ones
 * but the last bit.  Neither has other bits.  So an infinity or a NaN has all
 * bits of the two together, and no finite number has.  The bytes are checked
 * from the last one down, as the last one decides on most machines. */
tess_int hh_finite(tess_int n, const tess_real *p)
{
    const tess_real least = (tess_real)HH_REAL_MIN;
    const tess_real most = (tess_real)(2 / least);
    const unsigned char *a = (const unsigned char *)&least;
    const unsigned char *b = (const unsigned char *)&most;
    const unsigned char *c = (const unsigned char *)p;
    const int size = (int)sizeof(tess_real);
    tess_int i;
    int k;

    for (i = 0; i < 3 * n; i++, c += size) {
        k = size;
        while (k > 0 && (~c[k - 1] & (a[k - 1] | b[k - 1])) == 0) k--;
        if (k == 0) return i / 3;
    }
    return n;
}

/* full_precision - returns 1 if arithmetic keeps all bits of a double.  An x87
 * unit may have been set to fewer.  (PROBE + m)^2, m = 1 or 3, needs nearly all
 * of them, and all steps are exact if they are kept.  m is known only at run
 * time, so that a compiler cannot evaluate the test beforehand. */
static int full_precision(int m)
{
    volatile double a = PROBE + m;

    return a * a - PROBE * PROBE - 2.0 * PROBE * m == (double)(m * m);
}

/* keeps_value - returns 1 if x is 0, or finite and the arithmetic does not take
 * it for 0.  A processor may have been set to do that to subnormal operands,
 * which no comparison can find then, or to subnormal results.  The operand's
 * bits tell: a zero has none but the sign's.  (volatile: when a number compares
 * equal to 0, a compiler must not take its bits to be those of 0.0.)  ldexp is
 * tested, too: with arithmetic in an x87 unit the mathematical library may
 * compute elsewhere, and take for 0 what the unit does not.  e is 1 or 3. */
static int keeps_value(const tess_real *x, int e)
{
    const tess_real plus = 1, minus = -1;
    const unsigned char *a = (const unsigned char *)&plus;
    const unsigned char *b = (const unsigned char *)&minus;
    const unsigned char *c = (const unsigned char *)x;
    volatile tess_real value = *x;
    volatile double one = 1.0, once;
    int k;

    if (value != value || fabs((double)value) > DBL_MAX) return 0;
    if (value != 0) {
        once = one * (double)value;
        return once != 0.0 && ldexp((double)value, e) != 0.0;
    }
    for (k = 0; k < (int)sizeof(tess_real); k++)
        if (c[k] & ~(a[k] ^ b[k])) return 0;
    return 1;
}

/* hh_held - returns 1 if the arithmetic keeps the coordinates of the point p.
 * Of all comparisons with a NaN only that for equality sets no flag, so it
 * comes first. */
int hh_held(const tess_real *p)
{
    double x;
    int k;

    for (k = 0; k < 3; k++) {
        x = fabs((double)p[k]);
        if ((x != x || x < DBL_MIN || x > DBL_MAX) &&
            !keeps_value(p + k, p[0] == p[1] ? 1 : 3))
            return 0;
    }
    return 1;
}

/* hh_holds - returns 1 if the arithmetic is precise, and hh_held is 1 for all n
 * points p. */
int hh_holds(tess_int n, const tess_real *p)
{
    tess_int i = 0;

    if (!full_precision(n % 2 == 0 ? 1 : 3)) return 0;
    while (i < n && hh_held(p + 3 * i)) i++;
    return i == n;
}

/* ---------------------------------------------------------------------
 * Exact signs: a filter, then limbs.
 *
 * A filter compares a determinant with a multiple of its permanent, the same
 * expression with absolute values, as in Shewchuk (1997), but for every
 * rounding mode.  The filters take coordinates of absolute value at most 1,
 * possibly with an absolute error where tiny ones underflowed.  A term of the
 * orientation determinant is a product of 3 differences with at most 5 more
 * roundings in it, one of the insphere determinant a product of 5 differences
 * with at most 12: relative errors of at most 8 eps and 17 eps of the permanent
 * in any rounding mode and any order of evaluation.  The filters allow 16 and
 * 32; the roundings of the permanent itself and of the bound are of second
 * order, some 20 eps of that.  Underflow, and coordinates that underflowed, add
 * less than DET_UNDERFLOW: an error of DBL_MIN in each difference and product,
 * times differences of at most 2 each.
 * With t >= 0 all coordinates are integer multiples of some unit, none of them
 * an underflowed one, and a permanent of at most t (2^(DBL_MANT_DIG-1) units)
 * means that nothing was rounded at all.
 * --------------------------------------------------------------------- */

/* sign_if_certain - returns the sign of det if |det| exceeds its error or det
 * is exact, else UNSURE. */
static int sign_if_certain(double det, double perm, double factor, double t)
{
    double err = factor * DBL_EPSILON * perm + DET_UNDERFLOW;

    if (det > err) return 1;
    if (det < -err) return -1;
    if (perm <= t) return det > 0.0 ? 1 : det < 0.0 ? -1 : 0;
    return UNSURE;
}

/* orient_filter - returns the sign of det [b-a c-a d-a], or UNSURE. */
static int orient_filter(const double *a, const double *b, const double *c,
                         const double *d, double t)
{
    double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
    double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
    double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
    double byz = by * cz, bzy = bz * cy, bzx = bz * cx, bxz = bx * cz;
    double bxy = bx * cy, byx = by * cx;
    double det = dx * (byz - bzy) + dy * (bzx - bxz) + dz * (bxy - byx);
    double perm = fabs(dx) * (fabs(byz) + fabs(bzy)) +
                  fabs(dy) * (fabs(bzx) + fabs(bxz)) +
                  fabs(dz) * (fabs(bxy) + fabs(byx));

    return sign_if_certain(det, perm, 16.0, t);
}

/* insphere_filter - returns the sign of I = det of the rows (q - e, |q - e|^2),
 * q = a, b, c, d, or UNSURE; with h, of the rows (q - e, h), the four numbers h
 * right to 4 eps of themselves, less than those squares suffer.  e is inside
 * the ball of a, b, c, d iff I and the determinant of the rows a-d, b-d, c-d
 * have one sign. */
static int insphere_filter(const double *a, const double *b, const double *c,
                           const double *d, const double *e, const double *h,
                           double t)
{
    double ax = a[0] - e[0], ay = a[1] - e[1], az = a[2] - e[2];
    double bx = b[0] - e[0], by = b[1] - e[1], bz = b[2] - e[2];
    double cx = c[0] - e[0], cy = c[1] - e[1], cz = c[2] - e[2];
    double dx = d[0] - e[0], dy = d[1] - e[1], dz = d[2] - e[2];
    double la = h != NULL ? h[0] : ax * ax + ay * ay + az * az;
    double lb = h != NULL ? h[1] : bx * bx + by * by + bz * bz;
    double lc = h != NULL ? h[2] : cx * cx + cy * cy + cz * cz;
    double ld = h != NULL ? h[3] : dx * dx + dy * dy + dz * dz;
    double ab1 = ax * by, ab2 = bx * ay, bc1 = bx * cy, bc2 = cx * by;
    double cd1 = cx * dy, cd2 = dx * cy, da1 = dx * ay, da2 = ax * dy;
    double ac1 = ax * cy, ac2 = cx * ay, bd1 = bx * dy, bd2 = dx * by;
    double ab = ab1 - ab2, bc = bc1 - bc2, cd = cd1 - cd2, da = da1 - da2;
    double ac = ac1 - ac2, bd = bd1 - bd2;
    double det = lb * (az * cd + cz * da + dz * ac) -
                 la * (bz * cd - cz * bd + dz * bc) +
                 ld * (az * bc - bz * ac + cz * ab) -
                 lc * (az * bd + bz * da + dz * ab);
    double perm;

    ab = fabs(ab1) + fabs(ab2);
    bc = fabs(bc1) + fabs(bc2);
    cd = fabs(cd1) + fabs(cd2);
    da = fabs(da1) + fabs(da2);
    ac = fabs(ac1) + fabs(ac2);
    bd = fabs(bd1) + fabs(bd2);
    az = fabs(az);
    bz = fabs(bz);
    cz = fabs(cz);
    dz = fabs(dz);
    perm = fabs(la) * (bz * cd + cz * bd + dz * bc) +
           fabs(lb) * (az * cd + cz * da + dz * ac) +
           fabs(lc) * (az * bd + bz * da + dz * ab) +
           fabs(ld) * (az * bc + bz * ac + cz * ab);
    return sign_if_certain(det, perm, 32.0, t);
}

/* sign_filter - returns the orientation of np = 4 points q, or
 * insphere_filter's answer for 5; or UNSURE. */
static int sign_filter(int np, const double *q, double t)
{
    return np == 4 ? orient_filter(q, q + 3, q + 6, q + 9, t)
                   : insphere_filter(q, q + 3, q + 6, q + 9, q + 12, NULL, t);
}

/* nearest_face_filter - returns what foot_by_limbs does, minus nearest_face's
 * answer, for s, the points b, c, q, a of the triangle a, b, c and q, scaled;
 * UNSURE if double precision does not decide all signs.  Relative to the sum of
 * its terms' absolute values, as in orient_filter, a product of side and offset
 * errs by 5 eps, an area by 12. */
static int nearest_face_filter(const double *s)
{
    static const int vertex[4] = {3, 0, 1, 3};
    double side[9], off[9], dot[9], most[9], area[3], sum, err;
    int i, j, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            side[3 * i + k] = s[3 * vertex[i + 1] + k] - s[3 * vertex[i] + k];
            off[3 * i + k] = s[6 + k] - s[3 * vertex[i] + k];
        }
    for (i = 0; i < 9; i++) {
        dot[i] = most[i] = 0.0;
        for (k = 0; k < 3; k++) {
            sum = side[i - i % 3 + k] * off[3 * (i % 3) + k];
            dot[i] += sum;
            most[i] += fabs(sum);
        }
        if (i % 3 != (i / 3 + 2) % 3 &&
            sign_if_certain(dot[i], most[i], 16.0, -1.0) == UNSURE)
            return UNSURE;
    }
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        k = (i + 2) % 3;
        area[k] = dot[3 * i + j] * dot[3 * k + i] - dot[4 * i] * dot[3 * k + j];
        err = most[3 * i + j] * most[3 * k + i] + most[4 * i] * most[3 * k + j];
        if (sign_if_certain(area[k], err, 64.0, -1.0) == UNSURE)
            return UNSURE;
    }
    return -nearest_face(dot, area);
}

/* pack_points - sets q to the coordinates of np points p.  Returns the largest
 * absolute value. */
static double pack_points(int np, const tess_real *const *p, double *q)
{
    double most = 0.0;
    int i, k;

    for (i = 0; i < np; i++)
        for (k = 0; k < 3; k++) {
            *q = (double)p[i][k];
            most = fabs(*q) > most ? fabs(*q) : most;
            q++;
        }
    return most;
}

/* pack_five - sets p to the points a, b, c, d, e, and q to the coordinates of
 * the first np; the others are any.  Returns what pack_points does. */
static double pack_five(int np, const tess_real *a, const tess_real *b,
                        const tess_real *c, const tess_real *d,
                        const tess_real *e, const tess_real **p, double *q)
{
    p[0] = a;
    p[1] = b;
    p[2] = c;
    p[3] = d;
    p[4] = e;
    return pack_points(np, p, q);
}

/* scale_to_unit - sets s = q 2^-e, n coordinates, with e such that most, the
 * largest absolute value among them, becomes at most 1, and not tiny.  Returns
 * e. */
static int scale_to_unit(int n, double most, const double *q, double *s)
{
    double f = most <= 1.0 ? 1.0 : QUICK_SCALE;
    int e = most <= 1.0 ? 0 : QUICK_EXP, k;

    if (most >= QUICK_SCALE && most <= 1.0 / QUICK_SCALE)
        for (k = 0; k < n; k++) s[k] = f * q[k];
    else {
        frexp(most, &e);
        for (k = 0; k < n; k++) s[k] = ldexp(q[k], -e);
    }
    return e;
}

/* exact_answer - returns what of finds for the first np of the points a, b, c,
 * d, e, which hh_holds or hh_held has passed: by a filter, if no weights w are
 * wanted, else by limbs; or UNSURE, where the limbs do not hold the points. */
static int exact_answer(int np, limb_method *of, const tess_real *a,
                        const tess_real *b, const tess_real *c,
                        const tess_real *d, const tess_real *e, double *w)
{
    const tess_real *p[5];
    double q[15], s[15], any[3], most = pack_five(np, a, b, c, d, e, p, q);
    int answer = UNSURE;

    if (w == NULL) {
        scale_to_unit(3 * np, most, q, s);
        answer = of == foot_by_limbs ? nearest_face_filter(s)
                                     : sign_filter(np, s, -1.0);
    }
    if (answer == UNSURE)
        answer = evaluate_exactly(np, of, q, most, w != NULL ? w : any);
    return answer;
}

/* hh_horient - returns hh_orient's answer for points that hh_holds or hh_held
 * has passed. */
int hh_horient(const tess_real *a, const tess_real *b, const tess_real *c,
               const tess_real *d)
{
    return exact_answer(4, orient_by_limbs, a, b, c, d, d, NULL);
}

/* hh_hinsphere - returns hh_insphere's answer for such points. */
int hh_hinsphere(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d, const tess_real *e)
{
    int side = hh_horient(a, b, c, d), sign;

    if (side == 0 || side == UNSURE) return side;
    sign = exact_answer(5, insphere_by_limbs, a, b, c, d, e, NULL);
    return sign == UNSURE ? UNSURE : -side * sign;
}

int hh_orient(const tess_real *a, const tess_real *b, const tess_real *c,
              const tess_real *d)
{
    return hh_holds(1, a) && hh_held(b) && hh_held(c) && hh_held(d)
               ? hh_horient(a, b, c, d)
               : UNSURE;
}

int hh_insphere(const tess_real *a, const tess_real *b, const tess_real *c,
                const tess_real *d, const tess_real *e)
{
    return hh_holds(1, a) && hh_held(b) && hh_held(c) && hh_held(d) &&
                   hh_held(e)
               ? hh_hinsphere(a, b, c, d, e)
               : UNSURE;
}

/* hh_area - returns the exact sign of the area of a, b, c projected along an
 * axis 0, 1 or 2: of the orientation in the plane of the two other coordinates,
 * in cyclic order.  a, b, c are collinear iff it is 0 along all three axes. */
int hh_area(int axis, const tess_real *a, const tess_real *b,
            const tess_real *c)
{
    const tess_real *p[5];
    double q[12], most;
    int i = axis == 2 ? 0 : axis + 1, k = axis == 0 ? 2 : axis - 1;
    /* halves, whose differences do not overflow */
    double ai = 0.5 * (double)a[i], bi = 0.5 * (double)b[i] - ai;
    double ak = 0.5 * (double)a[k], bk = 0.5 * (double)b[k] - ak;
    double ci = 0.5 * (double)c[i] - ai, ck = 0.5 * (double)c[k] - ak;
    double det, err;

    /* as in orient_filter; underflow, gradual or to 0, puts a half, a
     * difference and a product off by DBL_MIN each, the first two times less
     * than 1/RAISE_BELOW: together by far less than 1/RAISE.  So no sign is
     * wrong, however small the coordinates are; where det is small, too, the
     * limbs decide */
    if (fabs(bi) < 1.0 / RAISE_BELOW && fabs(ck) < 1.0 / RAISE_BELOW &&
        fabs(bk) < 1.0 / RAISE_BELOW && fabs(ci) < 1.0 / RAISE_BELOW) {
        det = bi * ck - bk * ci;
        err = 8.0 * DBL_EPSILON * (fabs(bi * ck) + fabs(bk * ci));
        if (det > err + 1.0 / RAISE) return 1;
        if (det < -err - 1.0 / RAISE) return -1;
    }
    most = pack_five(3, a, b, c, c, c, p, q);
    if (!hh_holds(1, a) || !hh_held(b) || !hh_held(c)) return UNSURE;
    /* the fourth point: off the plane, on the axis's positive side, and held by
     * the same limbs */
    for (k = 0; k < 3; k++) q[9 + k] = q[k];
    q[axis] = q[3 + axis] = q[6 + axis] = 0.0;
    q[9 + axis] = most;
    return evaluate_exactly(4, orient_by_limbs, q, most, NULL);
}

/* hh_collinear - returns 1 if a, b, c are exactly collinear. */
int hh_collinear(const tess_real *a, const tess_real *b, const tess_real *c)
{
    return hh_area(0, a, b, c) == 0 && hh_area(1, a, b, c) == 0 &&
           hh_area(2, a, b, c) == 0;
}

/* hh_foot - exact: returns the vertices of a triangle a, b, c that carry its
 * point nearest to q, as the sum of 1, 2, 4 for them, or 0 when the limbs do
 * not hold it; hh_holds or hh_held has passed all four.  w, if not NULL: their
 * weights, none negative, right to rounding however thin the triangle is, 0 for
 * a vertex that does not carry. */
int hh_foot(const tess_real *a, const tess_real *b, const tess_real *c,
            const tess_real *q, double *w)
{
    int set = exact_answer(4, foot_by_limbs, b, c, q, a, a, w);

    return set == UNSURE ? 0 : -set;
}

/* hh_weigh - exact: computes the barycentric weights w of q in the tetrahedron
 * v of points p, which contains it: the sum of w[k] (vertex k - q) vanishes.
 * Each is right to 12 eps of itself, or underflows, however thin the
 * tetrahedron is; none is negative, and w[k] is 0 where q is in the plane of
 * the facet opposite to vertex k.  Returns 0, or UNSURE where the limbs do not
 * hold the points, which hh_holds or hh_held has passed. */
int hh_weigh(const tess_real *p, const tess_int *v, const tess_real *q,
             double *w)
{
    return exact_answer(5, weights_by_limbs, p + 3 * (size_t)v[0],
                        p + 3 * (size_t)v[1], p + 3 * (size_t)v[2],
                        p + 3 * (size_t)v[3], q, w);
}

/* hh_wider - returns the exact sign of (a-b) - (c-d), for a >= b and c >= d.
 * Double precision errs by 2 eps of the sum of both differences.  Where it does
 * not tell, the orientation of four points does: with m the largest of the
 * numbers in absolute value,
 *     det [(m,m,d)-(0,0,a)  (m,0,b)-(0,0,a)  (0,m,c)-(0,0,a)] =
 *         m^2 ((a-b) - (c-d)). */
int hh_wider(double a, double b, double c, double d)
{
    double x = 0.25 * a - 0.25 * b, y = 0.25 * c - 0.25 * d, m = 0.0, q[12];
    double err = 4.0 * DBL_EPSILON * (x + y) + DET_UNDERFLOW;
    int k;

    if (x - y > err) return 1;
    if (y - x > err) return -1;
    set_zeros(12, q);
    q[2] = a;
    q[5] = d;
    q[8] = b;
    q[11] = c;
    for (k = 2; k < 12; k += 3) m = fabs(q[k]) > m ? fabs(q[k]) : m;
    q[3] = q[4] = q[6] = q[10] = m;
    return evaluate_exactly(4, orient_by_limbs, q, m, NULL);
}

/* hh_fits - returns 1 if HH_LIMBS limbs hold x beside coordinates of absolute
 * value most > 0. */
int hh_fits(double x, double most)
{
    double limb[HH_LIMBS], factor, top = top_weight(1, &x, most, &factor);

    return split_limbs(1, &x, top, HH_LIMBS, limb) <= HH_LIMBS;
}

/* needs_own_unit - returns 1 if position i of the set s is too far below the
 * set's units for these to suit it and points near it. */
static int needs_own_unit(const hh_set *s, tess_int i)
{
    const double *x = s->x + 3 * i;

    return s->exact3 < -1.0 &&
           fabs(x[0]) + fabs(x[1]) + fabs(x[2]) <= QUICK_SCALE;
}

/* box_corners - returns 2 if np points are in one plane across an axis; 1 if
 * they are corners of one box with faces along the axes, that is, if no
 * coordinate has more than two values: q is then their image when the box
 * becomes the unit cube, which alters no orientation.  Else it returns 0. */
static int box_corners(int np, const tess_real *const *p, double *q)
{
    tess_real other;
    int i, k, box = 1;

    for (k = 0; k < 3; k++) {
        other = p[0][k];
        for (i = 1; i < np; i++)
            if (p[i][k] != p[0][k]) {
                if (other == p[0][k]) other = p[i][k];
                if (p[i][k] != other) box = 0;
            }
        if (other == p[0][k]) return 2;
        for (i = 0; i < np; i++)
            q[3 * i + k] = (p[i][k] == p[0][k]) == (other < p[0][k]);
    }
    return box;
}

/* exact_by_position - returns the exact orientation of np = 4 positions v of
 * the set s, or the sign of I of 5, that a filter leaves undecided, or that
 * need a unit of their own: these are filtered in it. */
static int exact_by_position(const hh_set *s, int np, const tess_int *v)
{
    const tess_real *p[5];
    double q[15], most;
    int n = 0, sign = UNSURE;

    do p[n] = s->p + 3 * s->order[v[n]];
    while (++n < np);
    if (needs_own_unit(s, v[0])) {
        most = pack_points(np, p, q);
        scale_to_unit(3 * np, most, q, q);
        if (most > 0.0) sign = sign_filter(np, q, -1.0);
        if (sign != UNSURE) return sign;
    }
    /* no filter tells that four points are in a plane, but most such planes in
     * data are across an axis; the corners of a box are on one sphere */
    n = box_corners(np, p, q);
    if (n > 0) return n == 2 || np == 5 ? 0 : sign_filter(4, q, 64.0);
    return evaluate_exactly(np, np == 4 ? orient_by_limbs : insphere_by_limbs,
                            q, pack_points(np, p, q), NULL);
}

/* hh_porient - returns the exact orientation, hh_orient's, of the positions i,
 * j, k, l of the set s. */
int hh_porient(const hh_set *s, tess_int i, tess_int j, tess_int k, tess_int l)
{
    tess_int v[4];
    int sign = UNSURE;

    if (!needs_own_unit(s, i))
        sign = orient_filter(s->x + 3 * i, s->x + 3 * j, s->x + 3 * k,
                             s->x + 3 * l, s->exact3);
    if (sign != UNSURE) return sign;
    v[0] = i;
    v[1] = j;
    v[2] = k;
    v[3] = l;
    return exact_by_position(s, 4, v);
}

/* ---------------------------------------------------------------------
 * The tie rule (Figure 4 of the paper made precise).
 *
 * Each point x has the lifted height |x|^2; that of point number i is lowered
 * by e_i, e_0 >> e_1 >> ... > 0, so that no five points are on one sphere and
 * a tetrahedralization is the one whose lifted tetrahedra are the lower facets
 * of a convex polytope.  The point of least number of a cospherical set is a
 * vertex of all the set's tetrahedra, and no tetrahedron is flat.  Every
 * decision here is of the same perturbed heights, whatever facet it is asked
 * for: that is what makes them agree.
 * --------------------------------------------------------------------- */

/* break_tie - returns the sign, never 0, of the perturbed insphere determinant
 * I of insphere_filter for five positions v of the set s with I = 0: that of
 * the cofactor of the greatest e_i that has one, (-1)^k times the determinant
 * of the other four positions in their order, for the first k, in increasing
 * order of the points' numbers, for which it is not 0.  It is 1 for k = 3 and
 * -1 for k = 4 when v[3] and v[4] are known to be on the positive side of v[0],
 * v[1], v[2]. */
static int break_tie(const hh_set *s, const tess_int *v, int positive)
{
    tess_int number[5], rest[4];
    int sign = 0, tries, lowest, n, r;

    for (n = 0; n < 5; n++) number[n] = s->order[v[n]];
    for (tries = 0; tries < 5 && sign == 0; tries++) {
        lowest = 0;
        for (n = 0; n < 5; n++)
            if (number[n] >= 0 &&
                (number[lowest] < 0 || number[n] < number[lowest]))
                lowest = n;
        if (positive && lowest >= 3) return lowest == 3 ? 1 : -1;
        number[lowest] = -1; /* done with */
        for (n = r = 0; n < 5; n++)
            if (n != lowest) rest[r++] = v[n];
        /* the determinant of the rows a-d, b-d, c-d is minus hh_orient */
        sign = hh_porient(s, rest[0], rest[1], rest[2], rest[3]);
        if (lowest % 2 == 0) sign = -sign;
    }
    return sign;
}

/* hh_pinsphere - returns the sign of the determinant I of insphere_filter for
 * the positions v[0..2], a, b of the set s: b is inside the ball of v and a iff
 * I times hh_porient(v, a) is negative.  Where I is 0, by rule:
 *   0   0
 *   1   the sign, never 0, of the perturbed I
 *   2   HH_TIE times that; a and b are on the positive side of v: b beats a as
 *       the apex of the facet v if the result is negative
 *   3   the same, and I is taken to be 0, without a test */
int hh_pinsphere(const hh_set *s, const tess_int *v, tess_int a, tess_int b,
                 int rule)
{
    const double *x = s->x;
    tess_int w[5];
    int sign = rule == 3 ? 0 : UNSURE, k;

    for (k = 0; k < 5; k++) w[k] = k < 3 ? v[k] : k == 3 ? a : b;
    if (rule != 3 && !needs_own_unit(s, v[0]))
        sign = insphere_filter(x + 3 * v[0], x + 3 * v[1], x + 3 * v[2],
                               x + 3 * a, x + 3 * b, NULL, s->exact5);
    if (sign == UNSURE) sign = exact_by_position(s, 5, w);
    if (sign != 0 || rule == 0) return sign;
    return rule > 1 ? HH_TIE * break_tie(s, w, 1) : break_tie(s, w, 0);
}

/* ---------------------------------------------------------------------
 * Householder transformations (Section 3).
 *
 * P = [p2-p1 p3-p1] = Q R, Q = Q1 Q2, Qi = I - b_i u_i u_i'; R upper
 * triangular.  A reflector is kept as b and u with the scaling of u left as
 * it comes, b = 2/u'u.
 *
 * The bounds are derived, for every rounding mode, in test/bounds,
 * lemmas.txt, H1 to H7.  In short, in units of eps:
 *
 * Forward error of the side.  A reflector as computed alters a vector by 42 of
 * its length at most, beside the exact one of the column that it was computed
 * from.  So Q e3 errs by 77, and the exact Q and the computed R are those of a
 * second column that is off by 43 |p3-p1|: its facet's normal is turned against
 * the true one by 43 |p3-p1| / |r22| and the error of the first column, less
 * than 45 s, as s = 1 + |r12/r22| is more than |p3-p1| / |r22|, one over the
 * sine of the facet's angle at p1.  The products with w add 4.  So the error is
 * at most eps (45 s + 82) |w|; E = eps (170 s + 90) has room for all roundings
 * of what is computed with it.
 *
 * Forward error of L.  c - p1 = Q y.  The circumcentre of that facet is off by
 * eps rho (140 s + 3), as |p2-p1| and |p3-p1| are at most 2 rho; y by eps rho
 * (12 s + 3), Q by 77; as long as E <= HH_E_MAX rho as computed is more than
 * half of rho, and the sum is at most 0.64 of dc = eps rho (700 s + 100).  In L
 * = (w.w - 2 (c-p1).w) / (2 v.w) the numerator errs by at most |w| (eps (6 |w|
 * + 10 rho) + 2 dc), the denominator by 2 E |w|; a quotient a/b with errors da,
 * db errs by at most (da + |a/b| db) / (|b| - db), here with |b| - db = 2 g,
 * which halves the numerator's terms; plus 4 eps |L| for the last roundings, of
 * the quotient (2) and, in hh_limits, of its sum with dL.
 * --------------------------------------------------------------------- */

typedef struct qr_factors {
    double u1[3], b1, u2[2], b2; /* the reflectors; u2 acts on rows 2, 3 */
    double r11, r12, r22;
} qr_factors;

/* householder - computes the reflectors and R of [a b].  A zero column leaves
 * zeros. */
static void householder(const double *a, const double *b, qr_factors *h)
{
    double norm, t, q1, q2;

    norm = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    h->r11 = a[0] > 0.0 ? -norm : norm;
    h->u1[0] = a[0] - h->r11;
    h->u1[1] = a[1];
    h->u1[2] = a[2];
    t = norm * (norm + fabs(a[0]));
    h->b1 = t > DBL_MIN ? 1.0 / t : 0.0;

    t = h->b1 * (h->u1[0] * b[0] + h->u1[1] * b[1] + h->u1[2] * b[2]);
    h->r12 = b[0] - t * h->u1[0];
    q1 = b[1] - t * h->u1[1];
    q2 = b[2] - t * h->u1[2];
    norm = sqrt(q1 * q1 + q2 * q2);
    h->r22 = q1 > 0.0 ? -norm : norm;
    h->u2[0] = q1 - h->r22;
    h->u2[1] = q2;
    t = norm * (norm + fabs(q1));
    h->b2 = t > DBL_MIN ? 1.0 / t : 0.0;
}

/* apply_q - sets z to Q1 Q2 (y1, y2, y3). */
static void apply_q(const qr_factors *h, double y1, double y2, double y3,
                    double *z)
{
    double t = h->b2 * (h->u2[0] * y2 + h->u2[1] * y3);

    y2 -= t * h->u2[0];
    y3 -= t * h->u2[1];
    t = h->b1 * (h->u1[0] * y1 + h->u1[1] * y2 + h->u1[2] * y3);
    z[0] = y1 - t * h->u1[0];
    z[1] = y2 - t * h->u1[1];
    z[2] = y3 - t * h->u1[2];
}

/* hh_setup - does what hh_facet does for points of absolute value at most 1, in
 * double and without the test for collinear points; f as there, but E and dc
 * are DBL_MAX and the rest is finite when the facet is too thin or too small
 * for the bounds to hold.  s is bounded by 1 + |r12/r22|. */
void hh_setup(const double *p1, const double *p2, const double *p3, double *f)
{
    double a[3], b[3], ratio, y1, y2;
    qr_factors h;
    int k;

    for (k = 0; k < 3; k++) {
        a[k] = p2[k] - p1[k];
        b[k] = p3[k] - p1[k];
        f[HH_BASE + k] = p1[k];
    }
    householder(a, b, &h);
    /* det [p2-p1 p3-p1 v] = r11 r22 det Q, det Q = 1 */
    apply_q(&h, 0.0, 0.0, (double)(1 - 2 * ((h.r11 < 0.0) != (h.r22 < 0.0))),
            f);
    if (fabs(h.r11) > HH_LENGTH_MIN && fabs(h.r22) > HH_LENGTH_MIN) {
        ratio = h.r12 / h.r22;
        y1 = 0.5 * h.r11;
        y2 = 0.5 * (h.r22 + ratio * (h.r12 - h.r11));
        apply_q(&h, y1, y2, 0.0, f + HH_CENTRE);
        f[HH_RHO] = sqrt(y1 * y1 + y2 * y2);
        ratio = 1.0 + fabs(ratio);
        f[HH_E] = DBL_EPSILON * (170.0 * ratio + 90.0);
        f[HH_DC] = DBL_EPSILON * f[HH_RHO] * (700.0 * ratio + 100.0);
    } else {
        f[HH_CENTRE] = f[HH_CENTRE + 1] = f[HH_CENTRE + 2] = f[HH_RHO] = 0.0;
        f[HH_E] = f[HH_DC] = DBL_MAX;
    }
}

/* hh_ratio - computes limits of the L-coordinate of z, whose side is between
 * least >= 0 and most.  *lo and *hi are left as they are where there is no
 * limit.
 *
 * L is a quotient of the power N = w.w - 2 (c-p1).w and twice the side.  With
 * p_k = w_k (w_k - 2 c_k), the error of w_k counts for eps (2 w_k^2 + 2 |c_k
 * w_k|), the four roundings of p_k and of the sum for 4 eps (w_k^2 + 2 |c_k
 * w_k|) in any rounding mode and order, that of c for 2 |w| dc: together less
 * than size (eps (8 size + 12 rho) + 2 dc), size >= HH_LENGTH_MIN, where
 * underflow does less than that.  The last roundings, of a difference and a
 * quotient, are the caller's: least and most have room for 4 eps of
 * themselves. */
void hh_ratio(const double *f, const double *z, double least, double most,
              double *lo, double *hi)
{
    double w0 = z[0] - f[HH_BASE], w1 = z[1] - f[HH_BASE + 1],
           w2 = z[2] - f[HH_BASE + 2];
    double size = fabs(w0) + fabs(w1) + fabs(w2);
    double power = HH_POWER(w0, w1, w2, f + HH_CENTRE);
    double err =
        size * (DBL_EPSILON * (8.0 * size + 12.0 * f[HH_RHO]) + 2.0 * f[HH_DC]);

    if (power > err)
        *lo = (power - err) / (2.0 * most);
    else if (least > 0.0)
        *lo = (power - err) / (2.0 * least);
    if (power < -err)
        *hi = (power + err) / (2.0 * most);
    else if (least > 0.0)
        *hi = (power + err) / (2.0 * least);
}

/* hh_limits - finds the side of z, and limits of its L-coordinate: -DBL_MAX,
 * DBL_MAX where there are none.  Returns 1 if z is certainly on the positive
 * side and not too near the plane; -1 if it is certainly on the negative side;
 * 0 if neither is certain: then the limits hold if z is on the positive side.
 *
 * |w|_1 stands for |w| in the bounds: it does not underflow.  A side of more
 * than twice its error leaves a gap of at least half of it, which spares a
 * division.  An uncertain side is at most side + err, if positive at all: a
 * power that is certainly not 0 then limits L on the side of 0.  side + 2 err
 * in its place leaves room for the last roundings: err is at least 260 eps
 * size, and |side| at most size. */
int hh_limits(const double *f, const double *z, double *lo, double *hi)
{
    double w0 = z[0] - f[HH_BASE], w1 = z[1] - f[HH_BASE + 1],
           w2 = z[2] - f[HH_BASE + 2];
    double size = fabs(w0) + fabs(w1) + fabs(w2), half, l, dl;
    double side = f[0] * w0 + f[1] * w1 + f[2] * w2, err;

    *lo = -DBL_MAX;
    *hi = DBL_MAX;
    if (size < HH_LENGTH_MIN || f[HH_E] > HH_E_MAX) return 0;
    err = f[HH_E] * size;
    if (side > 2.0 * err && side > HH_LENGTH_MIN) {
        half = 0.5 / side;
        l = HH_POWER(w0, w1, w2, f + HH_CENTRE) * half;
        dl = size *
                 (DBL_EPSILON * (3.0 * size + 5.0 * f[HH_RHO]) + f[HH_DC] +
                  fabs(l) * f[HH_E]) *
                 (4.0 * half) +
             4.0 * DBL_EPSILON * fabs(l);
        *lo = l - dl;
        *hi = l + dl;
        return 1;
    }
    if (-side > err) return -1;
    hh_ratio(f, z, 0.0, side + 2.0 * err, lo, hi);
    return 0;
}

/* finite_facet - returns 1 if the coordinates of p1, p2, p3 are finite. */
static int finite_facet(const tess_real *p1, const tess_real *p2,
                        const tess_real *p3)
{
    return hh_finite(1, p1) == 1 && hh_finite(1, p2) == 1 &&
           hh_finite(1, p3) == 1;
}

int hh_facet(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             double *f)
{
    const tess_real *p[5];
    double q[9], s[9];
    int e, k;

    if (finite_facet(p1, p2, p3)) {
        e = scale_to_unit(9, pack_five(3, p1, p2, p3, p3, p3, p, q), q, s);
        hh_setup(s, s + 3, s + 6, f);
        for (k = 0; k < 3; k++) f[HH_BASE + k] = (double)p1[k];
        if (f[HH_E] <= HH_E_MAX || !hh_collinear(p1, p2, p3)) {
            for (k = 0; k < 3; k++)
                f[HH_CENTRE + k] = ldexp(f[HH_CENTRE + k], e);
            f[HH_RHO] = ldexp(f[HH_RHO], e);
            if (f[HH_DC] < DBL_MAX) f[HH_DC] = ldexp(f[HH_DC], e);
            return 0;
        }
    }
    for (k = 0; k < 3; k++) {
        f[k] = f[HH_CENTRE + k] = 0.0;
        f[HH_BASE + k] = (double)p1[k];
    }
    f[HH_E] = f[HH_DC] = DBL_MAX;
    f[HH_RHO] = 0.0;
    return 1;
}

double hh_side(const double *f, const tess_real *z)
{
    return f[0] * ((double)z[0] - f[HH_BASE]) +
           f[1] * ((double)z[1] - f[HH_BASE + 1]) +
           f[2] * ((double)z[2] - f[HH_BASE + 2]);
}

int hh_opp(const double *f, const tess_real *z1, const tess_real *z2)
{
    double side1 = hh_side(f, z1), side2 = hh_side(f, z2);

    return (side1 > 0.0 && side2 > 0.0) || (side1 < 0.0 && side2 < 0.0);
}

double hh_lcoord(const double *f, const tess_real *z)
{
    double w0 = (double)z[0] - f[HH_BASE], w1 = (double)z[1] - f[HH_BASE + 1];
    double w2 = (double)z[2] - f[HH_BASE + 2];
    double side = f[0] * w0 + f[1] * w1 + f[2] * w2;
    double power = HH_POWER(w0, w1, w2, f + HH_CENTRE);

    if (side != 0.0) return power / (2.0 * side);
    return power >= 0.0 ? DBL_MAX : -DBL_MAX;
}

int hh_wrap(const tess_real *p1, const tess_real *p2, const tess_real *p3,
            const tess_real *z, double *c)
{
    const tess_real *p[5];
    double q[12], s[12], a[3], b[3], g[3], v[3], wg, wv, sense;
    qr_factors h;
    int k;

    *c = 0.0;
    if (!finite_facet(p1, p2, p3) || hh_collinear(p1, p2, p3)) return 1;
    if (hh_finite(1, z) < 1) return 2;
    scale_to_unit(12, pack_five(4, p1, p2, p3, z, z, p, q), q, s);
    for (k = 0; k < 3; k++) {
        a[k] = s[3 + k] - s[k];
        b[k] = s[6 + k] - s[k];
    }
    householder(a, b, &h);
    /* p3 - p1 has the component r22 along Q e2 */
    sense = h.r22 < 0.0 ? -1.0 : 1.0;
    apply_q(&h, 0.0, sense, 0.0, g);
    apply_q(&h, 0.0, 0.0, h.r11 < 0.0 ? -sense : sense, v);
    wg = wv = 0.0;
    for (k = 0; k < 3; k++) {
        wg += (s[9 + k] - s[k]) * g[k];
        wv += (s[9 + k] - s[k]) * v[k];
    }
    /* (as |wv| <= 7 this does not overflow, and then c does not) */
    if (0.0625 * DBL_MAX * fabs(wv) <= fabs(wg)) return 2;
    *c = -wg / wv;
    return 0;
}

/* ---------------------------------------------------------------------
 * Balls by limbs.
 *
 * A ball, a sphere or a plane is set up once.  What a point is to it then takes
 * a few limbs of the point, and a fraction of the time of the exact signs; the
 * result is exact or has a bound, or is UNSURE.
 * --------------------------------------------------------------------- */

/* rows_of_ball - computes the limbs of the rows p - last of 4 positions v of
 * the set s, as split_differences leaves them.  Sets top, factor, e and n of t.
 * Returns 0 if HH_BALL_LIMBS limbs do not hold them.  Twice the largest
 * coordinate fits, too. */
static int rows_of_ball(const hh_set *s, const tess_int *v, double *x,
                        hh_ball *t)
{
    const tess_real *p[4];
    double q[12], most;
    int i;

    for (i = 0; i < 4; i++) p[i] = s->p + 3 * s->order[v[i]];
    most = pack_points(4, p, q);
    t->top = 2.0 * top_weight(12, q, most, &t->factor);
    frexp(t->top, &t->e);
    t->e -= 1 + s->exponent + (most < RAISE_BELOW ? RAISE_LIMBS * HH_BITS : 0);
    t->n = 3;
    if (split_differences(4, q, t->top, 3, x) > 3)
        t->n = split_differences(4, q, t->top, HH_BALL_LIMBS, x);
    return t->n <= HH_BALL_LIMBS;
}

/* centre_by_limbs - computes the centre of the ball of four points of n limbs,
 * seen from the last one: of the rows a, b, w of x, without the common limb
 * weights,
 *     C = |a|^2 (b x w) + |b|^2 (w x a) + |w|^2 (a x b)
 * over twice D = w.(a x b).  work: 24n doubles; C and D, 4 numbers of 4n limbs,
 * are at the beginning of it, then a x b, of 2n limbs, 4 doubles apart.  (The
 * three products of C need no carry between them: at most 10 rows of each are
 * not carried, of one product of carried limbs.) */
static void centre_by_limbs(int n, const double *x, double *work)
{
    double *minor = work + 16 * n, *lift = minor + 3;
    int k;

    set_zeros(16 * n, work);
    for (k = 0; k < 9; k += 3) {
        set_zeros(8 * n, minor);
        add_product(CROSS, n, 12, x + (k + 3) % 9, n, 12, x + (k + 6) % 9,
                    2 * n, 4, minor);
        add_product(DOT, n, 12, x + k, n, 12, x + k, 2 * n, 4, lift);
        carry(2 * n, 4, 4, minor);
        add_product(SCALED, 2 * n, 4, minor, 2 * n, 4, lift, 4 * n, 4, work);
    }
    add_product(DOT, n, 12, x + 6, 2 * n, 4, minor, 3 * n, 4, work + 3);
    carry(4 * n, 4, 4, work);
}

/* leading_rows - copies the HH_BALL_ROWS leading rows of 4 numbers c of m
 * limbs, side by side, from the first limb on that is not 0 in all of the first
 * wide numbers.  Returns that limb. */
static int leading_rows(int m, int wide, const double *c, double *row)
{
    int first = first_row(m, wide, 4, c), i;

    for (i = 4 * first; i < 4 * (first + HH_BALL_ROWS); i++)
        *row++ = i < 4 * m ? c[i] : 0.0;
    return first;
}

/* hh_centre - computes the centre c, relative to the position v[base] and
 * scaled as s->x is, of the ball of the positions v[0..2] and z of the set s:
 * wrong by at most 8 eps |c|, as C and D (see centre_by_limbs) are exact and
 * their values err by 2.1 eps, the division by 2.  Returns 0 where that is not
 * to be had: the four in one plane, too many limbs, or a centre that is too
 * near or too far for squares.  Else t is made ready for hh_trial.  With z =
 * v[base] only its facet is, and c is left alone. */
int hh_centre(const hh_set *s, const tess_int *v, int base, tess_int z,
              double *c, hh_ball *t)
{
    double x[12 * HH_BALL_LIMBS], work[24 * HH_BALL_LIMBS], d;
    tess_int w[4];
    int i, k, n, at, dat;

    w[0] = v[(base + 1) % 3];
    w[1] = v[(base + 2) % 3];
    w[2] = z;
    w[3] = v[base];
    if (!rows_of_ball(s, w, x, t)) return 0;
    n = t->n;
    t->first_limb = first_row(n - 1, 9, 12, x);
    centre_by_limbs(n, x, work);
    /* multiply first: top/factor alone may underflow, and be rounded up from 0;
     * the result, about the largest coordinate, does not */
    t->max_abs = t->top < DBL_MAX / BASE ? t->top * (BASE / 4.0) / t->factor
                                         : DBL_MAX;
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) t->base[3 * i + k] = x[12 * i + 9 + k];
    t->side_first = leading_rows(2 * n, 3, work + 16 * n, t->side);
    if (z == v[base]) return 1;
    (void)leading_rows(4 * n, 4, work, t->power);
    d = 2.0 * leading_value(4 * n, work + 3, 4, &dat);
    if (d == 0.0) return 0;
    for (k = 0; k < 3; k++) {
        c[k] = leading_value(4 * n, work + k, 4, &at) / d;
        if (c[k] == 0.0) continue;
        at = t->e + (dat + 1 - at) * HH_BITS;
        if (at > CENTRE_EXP_MAX) return 0;
        c[k] = ldexp(c[k], at);
    }
    return fabs(c[0]) + fabs(c[1]) + fabs(c[2]) > HH_LENGTH_MIN;
}

/* value_in_ball - computes sum, the leading limbs of the height of the position
 * z above the plane of a ball's facet, if plane is 1, else of its power in the
 * ball, with u and |u|^2 in y as COFACTOR takes them.  Returns 0 if the ball's
 * limbs do not hold them.
 *
 * What is lost are products of limbs that weigh less than the last row of the
 * sum: in the row behind it 3n products of at most (BASE/2 + 1) BASE and 2n of
 * (BASE/2 + 1)^2, with all that follow less than CARRY units of the last row,
 * for n <= 10. */
static int value_in_ball(const hh_set *s, const hh_ball *t, tess_int z,
                         int plane, double *sum)
{
    const tess_real *p = s->p + 3 * s->order[z];
    double q[3], u[3 * HH_BALL_LIMBS], y[8 * HH_BALL_LIMBS];
    int n = t->n, first = t->first_limb, i;

    for (i = 0; i < 3; i++) {
        if (fabs((double)p[i]) > t->max_abs) return 0;
        q[i] = t->factor == 1.0 ? (double)p[i] : (double)p[i] * t->factor;
    }
    if (split_limbs(3, q, t->top, n, u) > n) return 0;
    for (i = 0; i < 3 * n; i++) {
        u[i] -= t->base[i];
        if (i < 3 * first && u[i] != 0.0) return 0;
    }
    set_zeros(HH_BALL_ROWS + 1, sum);
    if (plane)
        add_product(DOT, HH_BALL_ROWS, 4, t->side, n - first, 3, u + 3 * first,
                    HH_BALL_ROWS + 1, 1, sum);
    else {
        set_zeros(8 * n, y);
        add_product(DOT, n, 3, u, n, 3, u, 2 * n, 4, y + 2);
        carry(2 * n, 1, 4, y + 2);
        for (i = 0; i < n; i++) {
            y[4 * i] = -u[3 * i + 1];
            y[4 * i + 1] = u[3 * i];
            y[4 * i + 3] = u[3 * i + 2];
        }
        add_product(COFACTOR, HH_BALL_ROWS, 4, t->power, 2 * n - first, 4,
                    y + 4 * first, HH_BALL_ROWS + 1, 1, sum);
    }
    return 1;
}

/* hh_trial - decides by a few leading limbs, in a tenth of the time of the
 * exact signs, where these suffice.  Sets *power to the sign of the power of
 * the position z in the ball of hh_centre (-1: inside; the ball's fourth point
 * must be on the positive side, as D > 0 then), and, unless z is outside, *side
 * to the side of z for the facet.  Only what is UNSURE is set. */
void hh_trial(const hh_set *s, const hh_ball *t, tess_int z, int *side,
              int *power)
{
    double sum[HH_BALL_ROWS + 1];

    if (*power == UNSURE && value_in_ball(s, t, z, 0, sum))
        *power = sign_of_limbs(HH_BALL_ROWS + 1, CARRY, sum);
    if (*side == UNSURE && *power != 1 && value_in_ball(s, t, z, 1, sum))
        *side = sign_of_limbs(HH_BALL_ROWS + 1, CARRY, sum);
}

/* hh_surface - sets t to the sphere of centre c, seen from the position from of
 * the set s, or, if plane is 1, to the plane of normal c: through the position
 * base.  Returns 0 if the centre is farther than BASE / 4, or limbs do not hold
 * it. */
int hh_surface(const hh_set *s, tess_int base, tess_int from, int plane,
               const double *c, hh_sphere *t)
{
    double q[9], x[9 * HH_HEIGHT_LIMBS];
    int i, k;

    t->plane = plane;
    t->e = 2 - HH_BITS;
    for (k = 0; k < 3; k++) {
        q[k] = s->x[3 * base + k];
        q[3 + k] = c[k];
        q[6 + k] = s->x[3 * from + k];
        while (ldexp(fabs(c[k]), -t->e) > BASE / 4.0) t->e++;
    }
    t->n = split_limbs(9, q, ldexp(1.0, t->e), HH_HEIGHT_LIMBS, x);
    for (i = 0; i < 3 * HH_HEIGHT_LIMBS; i++) {
        k = i / 3 * 9 + i % 3;
        t->base[i] = x[k];
        t->twice_centre[i] =
            plane ? -x[k + 3] : 2.0 * (x[k + 3] + x[k + 6] - x[k]);
    }
    carry(HH_HEIGHT_LIMBS, 3, 3, t->twice_centre);
    return t->n <= HH_HEIGHT_LIMBS && t->e <= 0;
}

/* hh_height - returns the height of the position z above a plane, or its power
 * in a sphere: u.(u - twice_centre), u seen from the base, all of it by limbs.
 * *err bounds the error: BASE^2 if limbs do not hold z, as |z| <= 1 and no
 * centre is farther than BASE.  (7 rows of products are 30.75 BASE^2 at most:
 * limbs are at most BASE and 3/2 BASE, limbs 0 BASE/2 and 2 BASE.)  If h
 * underflows it loses at most DBL_MIN, less than DET_UNDERFLOW. */
double hh_height(const hh_set *s, const hh_sphere *t, tess_int z, double *err)
{
    double u[3 * HH_HEIGHT_LIMBS], y[3 * HH_HEIGHT_LIMBS],
        sum[2 * HH_HEIGHT_LIMBS], h;
    int n = split_limbs(3, s->x + 3 * z, ldexp(1.0, t->e), HH_HEIGHT_LIMBS, u),
        i, at;

    *err = BASE * BASE;
    if (n > HH_HEIGHT_LIMBS) return 0.0;
    if (n < t->n) n = t->n;
    for (i = 0; i < 3 * HH_HEIGHT_LIMBS; i++) {
        u[i] -= t->base[i];
        y[i] = (t->plane ? 0.0 : u[i]) - t->twice_centre[i];
    }
    set_zeros(2 * n, sum);
    add_product(DOT, n, 3, u, n, 3, y, 2 * n, 1, sum);
    carry(2 * n, 1, 1, sum);
    h = leading_value(2 * n, sum, 1, &at);
    h = ldexp(h, 2 * t->e + (1 - at) * HH_BITS);
    *err = 8.0 * DBL_EPSILON * fabs(h) + DET_UNDERFLOW;
    return h;
}

/* power_in_sphere - does what hh_height does for a sphere of sphere_of_facet,
 * with HH_SPHERE_LIMBS limbs: with hh_height in its place rings take 1.1 times
 * the instructions.  *h is right to 4 eps of itself.  3 HH_SPHERE_LIMBS
 * products of at most BASE and 3/2 BASE fit one limb.  Returns 0, and leaves *h
 * alone, if these limbs do not hold z. */
static int power_in_sphere(const hh_set *s, const hh_sphere *t, tess_int z,
                           double *h)
{
    double u[3 * HH_SPHERE_LIMBS], y[3 * HH_SPHERE_LIMBS],
        sum[2 * HH_SPHERE_LIMBS];
    int i, k, at;

    if (split_limbs(3, s->x + 3 * z, 4.0 / BASE, HH_SPHERE_LIMBS, u) >
        HH_SPHERE_LIMBS)
        return 0;
    for (i = 0; i < 3 * HH_SPHERE_LIMBS; i++) {
        u[i] -= t->base[i];
        y[i] = u[i] - t->twice_centre[i];
    }
    set_zeros(2 * HH_SPHERE_LIMBS, sum);
    for (i = 0; i < HH_SPHERE_LIMBS; i++)
        for (k = 0; k < HH_SPHERE_LIMBS; k++)
            sum[i + k + 1] += u[3 * i] * y[3 * k] +
                              u[3 * i + 1] * y[3 * k + 1] +
                              u[3 * i + 2] * y[3 * k + 2];
    carry(2 * HH_SPHERE_LIMBS, 1, 1, sum);
    *h = leading_value(2 * HH_SPHERE_LIMBS, sum, 1, &at);
    *h = ldexp(*h, 4 - (at + 1) * HH_BITS);
    return 1;
}

/* sphere_of_facet - sets t to a sphere through the base of the facet v, of
 * set-up f, about the centre of the ball of L-coordinate l, rounded to
 * multiples of 2^e, few enough for round_limb.  Returns 0 if it is too large,
 * or if limbs do not hold it or v. */
static int sphere_of_facet(const hh_set *s, const tess_int *v, int base,
                           const double *f, double l, hh_sphere *t)
{
    double c[3], most = 0.0;
    int k, e;

    t->power_best = t->power_last = -1;
    for (k = 0; k < 3; k++) {
        c[k] = f[HH_CENTRE + k] + l * f[k];
        if (fabs(c[k]) > most) most = fabs(c[k]);
    }
    if (most > 0.5) return 0;
    frexp(most, &e);
    e += HH_BITS + 1 - DBL_MANT_DIG;
    for (k = 0; k < 3; k++) c[k] = ldexp(round_limb(ldexp(c[k], -e)), e + 1);
    return split_limbs(3, s->x + 3 * v[base], 4.0 / BASE, HH_SPHERE_LIMBS,
                       t->base) <= HH_SPHERE_LIMBS &&
           split_limbs(3, c, 4.0 / BASE, HH_SPHERE_LIMBS, t->twice_centre) <=
               HH_SPHERE_LIMBS &&
           power_in_sphere(s, t, v[(base + 1) % 3], t->power) &&
           power_in_sphere(s, t, v[(base + 2) % 3], t->power + 1);
}

/* hh_relative - decides what hh_pinsphere does for the positions v[0..2], a, z
 * of the set s, 1 or -1, by their powers in one sphere near all of them; or
 * returns UNSURE.  f is the set-up of the facet v, from v[base]; the sphere in
 * t is that of the L-coordinate l of a point near which the others are
 * expected, or, if t is ready, an earlier one.
 *
 * I does not change if an affine function of q is subtracted from |q|^2.  So
 * the powers of the points in any one sphere may take the place of |q|^2.
 * Where the points are near the sphere these are small, but right to a few eps
 * all the same, so insphere_filter loses no digits to the points' being near
 * it.  The base takes the place of e: its power is 0.  Neither that nor a
 * cyclic exchange of v changes the sign. */
int hh_relative(const hh_set *s, const tess_int *v, int base, const double *f,
                double l, tess_int a, tess_int z, hh_sphere *t)
{
    const double *x = s->x;
    int sign;

    if (t->ready == 0) {
        if (s->exact3 < -1.0 || fabs(l) > 1e3 * f[HH_RHO]) return UNSURE;
        sign = insphere_filter(x + 3 * v[0], x + 3 * v[1], x + 3 * v[2],
                               x + 3 * a, x + 3 * z, NULL, -1.0);
        if (sign != UNSURE) return sign;
        t->ready = sphere_of_facet(s, v, base, f, l, t) ? 1 : -1;
    }
    if (t->ready < 0) return UNSURE;
    if (t->power_last == a)
        t->power[2] = t->power[3];
    else if (t->power_best != a && !power_in_sphere(s, t, a, t->power + 2))
        return UNSURE;
    t->power_best = a;
    if (!power_in_sphere(s, t, z, t->power + 3)) return UNSURE;
    t->power_last = z;
    return insphere_filter(x + 3 * v[(base + 1) % 3], x + 3 * v[(base + 2) % 3],
                           x + 3 * a, x + 3 * z, x + 3 * v[base], t->power,
                           -1.0);
}

/* hh_thin - computes the set-up f of a facet v that is too thin for
 * Householder's bounds, its normal by limbs, as good as that of any other.
 * With the rows a and b from v[base] n = a x b is exact but for 3 eps of its
 * length, and, after division by that, 11 eps; so the side of z errs by less
 * than 16 eps |w|, from any base.
 *     c - p1 = n x (|b|^2 a - |a|^2 b) / (2 |n|^2)
 * The vector in parentheses is |a| |b| |a-b| long.  If v[base] is opposite to
 * the longest edge, |a| + |b| <= 2 |a-b|: nothing cancels, it errs by less than
 * 20 eps of itself, c - p1 by less than 60 eps rho; else the centre is not to
 * be used.  E and dc are those of the best facet in hh_setup, 260 eps and
 * 800 eps rho, on which other bounds rest.  Returns 1; or 0, and leaves f as it
 * is, where numbers might underflow. */
int hh_thin(const hh_set *s, const tess_int *v, int base, double *f)
{
    const double *p1 = s->x + 3 * v[base];
    const double *p2 = s->x + 3 * v[(base + 1) % 3];
    const double *p3 = s->x + 3 * v[(base + 2) % 3];
    double d[3], a, b, norm, aa = 0.0, bb = 0.0;
    hh_ball t;
    int i, j, k, e;

    if (!hh_centre(s, v, base, v[base], d, &t)) return 0;
    e = 2 * t.e + (1 - t.side_first) * HH_BITS;
    for (k = 0; k < 3; k++) {
        a = p2[k] - p1[k];
        b = p3[k] - p1[k];
        aa += a * a;
        bb += b * b;
    }
    if (e < -CENTRE_EXP_MAX || aa < HH_LENGTH_MIN || bb < HH_LENGTH_MIN)
        return 0;
    norm = 0.0;
    for (k = 0; k < 3; k++) {
        f[k] = leading_value(HH_BALL_ROWS, t.side + k, 4, &i);
        f[k] = ldexp(f[k], -i * HH_BITS);
        norm += f[k] * f[k];
    }
    norm = sqrt(norm);
    for (k = 0; k < 3; k++) {
        f[k] /= norm;
        d[k] = bb * (p2[k] - p1[k]) - aa * (p3[k] - p1[k]);
        f[HH_BASE + k] = p1[k];
    }
    norm = 2.0 * ldexp(norm, e);
    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = 3 - i - k;
        f[HH_CENTRE + k] = (f[i] * d[j] - f[j] * d[i]) / norm;
    }
    f[HH_RHO] =
        sqrt(f[HH_CENTRE] * f[HH_CENTRE] + f[HH_CENTRE + 1] * f[HH_CENTRE + 1] +
             f[HH_CENTRE + 2] * f[HH_CENTRE + 2]);
    f[HH_E] = 260.0 * DBL_EPSILON;
    f[HH_DC] = 800.0 * DBL_EPSILON * f[HH_RHO];
    return 1;
}
