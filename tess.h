/* tess.h - Delaunay tetrahedralization of points in space.
 *
 * After C. Hazlewood, "Facet-Based Tetrahedralization Software" (1995).
 *
 * Memory: nothing but the caller's arrays and a bounded stack (about 70 KB at
 * the default capacities; see TESS_LIST below and HH_LIMBS in hhpred.h).
 *
 *   tet, adj   4*maxtet tess_int each; a uniform cloud of n points has about
 *              6.8 n tetrahedra (more: see tess_size)
 *   iw, rw     the lengths that tess_size gives, or TESS_LIW(n), TESS_LRW(n)
 *
 * No routine allocates, reads, writes, keeps state between calls or stops
 * the program; all may be called from any number of threads at once.
 *
 * Arrays, the same in all routines:
 *   p      point i has the coordinates p[3*i], p[3*i+1], p[3*i+2]: any finite
 *          values, in any units.  Never altered.
 *   tet    tetrahedron t has the vertices tet[4*t] ... tet[4*t+3], indices
 *          of points, positively oriented: det [b-a c-a d-a] > 0.
 *   adj    adj[4*t+k] is the tetrahedron across the facet opposite to
 *          tet[4*t+k]; TESS_NONE on the hull; TESS_OPEN for a facet still
 *          open, which only an unfinished result has.
 *
 * tet and adj are a function of the points and their order alone: the same
 * on every machine, with every compiler, in C and in Fortran.
 */
#ifndef TESS_H
#define TESS_H

#include "hhpred.h"

/* TESS_FORTRAN, for Fortran alone: tess.c and hhpred.c compiled with it offer
 * TESS, TESSWK, HHFACE ... of f77/tess.f and f77/hhpred.f (see TESS_NAME in
 * hhpred.h), so that no CALL changes: arguments by reference, all that is
 * counted from 1, none 0, open -1, INFO last.  The functions declared here
 * then count from 1, too, and have names of their own, which no decoration of
 * TESS meets; a program may link tess.c compiled without it besides. */
#ifdef TESS_FORTRAN
#define tess fttess
#define tess_size ftsize
#define tess_resume ftresume
#define tess_locate ftlocate
#define tess_hull fthull
#define tess_check ftcheck
#define tess_index ftindex
#define tess_query ftquery
#define tess_part ftpart
#define tess_ball ftball
#define tess_values ftvalues
#elif defined(TESS_LETTER)
/* Other types have other names: see hhpred.h. */
#define tess TESS_AS(t, tess)
#define tess_size TESS_AS(t, size)
#define tess_resume TESS_AS(t, resume)
#define tess_locate TESS_AS(t, locate)
#define tess_hull TESS_AS(t, hull)
#define tess_check TESS_AS(t, check)
#define tess_index TESS_AS(t, index)
#define tess_query TESS_AS(t, query)
#define tess_part TESS_AS(t, part)
#define tess_ball TESS_AS(t, ball)
#define tess_values TESS_AS(t, values)
#endif

/* 10000 * major + 100 * minor version; the README says what has changed. */
#define TESS_VERSION 10200L

#define TESS_NONE (-1)
#define TESS_OPEN (-2)

/* Codes.  -k says that the k-th argument is bad. */
#define TESS_OK 0     /* done                                              */
#define TESS_MORE 1   /* tet and adj are full: tess_resume with longer ones */
#define TESS_POOL 2   /* the facet pool is full: the same, with a longer iw */
#define TESS_PLANE 3  /* all points in one plane: no tetrahedron           */
#define TESS_LINE 4   /* all points on one line                            */
#define TESS_POINT 5  /* at most one distinct point                        */
#define TESS_RANGE 6  /* the arithmetic cannot hold the coordinates         */
/* Faults that tess_check finds. */
#define TESS_BAD_INDEX 10  /* a vertex out of range, or twice in one       */
#define TESS_BAD_TWIN 11   /* a vertex that is a duplicate of another one  */
#define TESS_BAD_SIGN 12   /* flat or negatively oriented                  */
#define TESS_BAD_OPEN 13   /* an open facet: the result is unfinished      */
#define TESS_BAD_ADJ 14    /* neighbour out of range, or not mutual        */
#define TESS_BAD_BALL 15   /* the neighbour's apex is inside the ball      */
#define TESS_BAD_HULL 16   /* boundary not closed, or not convex           */
#define TESS_BAD_COVER 17  /* the hull is covered more than once           */
#define TESS_BAD_POINT 18  /* a point is in no tetrahedron                 */

/* TESS_LIW(n), TESS_LRW(n) - lengths of iw and rw for n points: constant
 * expressions, for arrays; never less than what tess_size gives, and little
 * more.  n: an integer of any type.  Fortran: see f77/README.
 *
 *   TESS_LIW   4 for the point, 1/12 for the tree, 4 and TESS_LP for the pool,
 *              TESS_LS for points that are near planes or spheres
 *   TESS_LRW   TESS_LR for the point, 1/2 for the tree */
#define TESS_LR 3
#define TESS_LRW(n) (TESS_LR * (long)(n) + 12 * ((long)(n) / 12 + 2))
#define TESS_LIW(n)                                                \
    ((n) > TESS_INT_MOST / 9 || TESS_LI((long)(n)) > TESS_INT_MOST \
         ? (long)TESS_INT_MOST                                     \
         : TESS_LI((long)(n)))
#define TESS_LI(n) (8 * (n) + (n) / 12 + 514 + TESS_LP(n) + TESS_LS(n))
#define TESS_LS(n) ((n) < 500 ? 0 : (n) / 4 * 7 + 24)
#define TESS_LP(n)             \
    ((n) <= 8       ? 240      \
     : (n) <= 27    ? 540      \
     : (n) <= 64    ? 960      \
     : (n) <= 125   ? 1500     \
     : (n) <= 1000  ? 8 * (n) + 1204 \
     : (n) <= 28125 ? 8 * (n)  \
                    : 225000 + (n) / 5 * 2)

#ifdef __cplusplus
extern "C" {
#endif

/* tess_size - recommended lengths of the workspace of tess.
 *
 *   n       (in)   number of points
 *   maxtet  (in)   tetrahedra that tet and adj have room for
 *   liw     (out)  length of iw, tess_ints
 *   lrw     (out)  length of rw, doubles
 *
 * The pool of open facets that liw includes suffices for all inputs but
 * those whose number of tetrahedra is quadratic in n.
 *
 * maxtet: clouds have 6 to 6.8 n tetrahedra, lattices 5 to 6 n, points on or
 * near a plane or a sphere 2 to 6 n: 8 n does.  Not for points on a tube or a
 * torus, at random (10 to 15 n, more for more points), nor for those on a
 * helix or two lines: up to n^2 / 2.  TESS_MORE then costs little: to resume
 * takes as long as n tetrahedra of a cloud do, and a third of the time that
 * those already there took.
 *
 * returns 0; -1 or -2 for an n or maxtet that is negative or so large that a
 * length, or 4*maxtet + 3, would exceed the largest tess_int: the lengths
 * are then 0.
 */
int tess_size(tess_int n, tess_int maxtet, tess_int *liw, tess_int *lrw);

/* tess - the Delaunay tetrahedralization of n points.
 *
 *   n       (in)   number of points, >= 0
 *   p       (in)   3*n coordinates
 *   maxtet  (in)   tetrahedra that tet and adj have room for, >= 0
 *   ntet    (out)  number of tetrahedra; for a NaN or infinity in p (code
 *                  -2) the index of the first point that has one
 *   tet     (out)  4*maxtet; the first 4*ntet are set
 *   adj     (out)  4*maxtet; the first 4*ntet are set
 *   liw     (in)   length of iw; what exceeds the minimum becomes pool, and
 *                  from what tess_size gives on, room for planes and spheres
 *   iw      (out)  workspace.  On return, for each code >= 0 but TESS_RANGE,
 *                  iw[i] is the point that stands for point i: i itself, or
 *                  for a duplicate the least index with the same coordinates
 *                  (-0.0 equals 0.0)
 *   lrw     (in)   length of rw
 *   rw      (out)  workspace
 *
 * returns TESS_OK, TESS_MORE or TESS_POOL (what tet and adj hold is right;
 * go on with tess_resume), TESS_PLANE, TESS_LINE, TESS_POINT or TESS_RANGE
 * (ntet = 0), or -k: n < 0 -1; NaN or infinity in p -2; maxtet negative or
 * too large for tess_int -3; liw, lrw below the minimum -7, -9.  After -k
 * nothing is written but ntet.
 *
 * TESS_RANGE: the coordinates need more limbs than HH_LIMBS (never, with the
 * default); one is subnormal, and the processor is set to take those for
 * zero (programs linked with -Ofast do so); or it is set to round to fewer
 * bits than a double has (an x87 unit at 24).
 *
 * Cospherical points: the triangulation is the pulling triangulation in the
 * order of the indices; no tetrahedron is flat.
 * Cost: about linear in n for points that fill a volume or, but for rounding,
 * lie near up to eight planes and spheres; somewhat more on other smooth
 * surfaces, up to n^(3/2) on tubes and between two near sheets; O(n^2) at worst
 * for a linear number of tetrahedra.  Section 2 of the paper.
 */
int tess(tess_int n, const tess_real *p, tess_int maxtet, tess_int *ntet,
         tess_int *tet, tess_int *adj, tess_int liw, tess_int *iw,
         tess_int lrw, double *rw);

/* tess_resume - go on from an unfinished result.
 *
 * The arguments of tess, but ntet, tet, adj are (in, out): the points and
 * the first *ntet tetrahedra that tess or tess_resume left, copied into
 * larger arrays if need be.  iw and rw need hold nothing.  Gives the very
 * arrays that one call with enough room would have given.  With *ntet = 0 it
 * is tess; on a finished result it returns TESS_OK and changes nothing but
 * iw, rw.
 *
 * Tetrahedra of the mesh from several results may be put one behind the other,
 * each once, in any order, their neighbours renumbered and those that are not
 * there open: what is open on both sides is closed, and what is missing
 * computed.  4 tess_ints of iw are taken for each facet that waits for its
 * other side.
 *
 * returns what tess returns, and -4 for a bad *ntet, -5 and -6 for what tet
 * and adj cannot hold: indices out of range; a tetrahedron that has a
 * duplicate for a vertex, is not positively oriented, or has a neighbour's
 * apex in its ball; neighbours that do not share a facet; two tetrahedra on
 * the same side of an open one.  After -k *ntet, tet and adj are unchanged.
 * Damage that one pass cannot find gives a wrong result, but in bounded time
 * and within the arrays.
 */
int tess_resume(tess_int n, const tess_real *p, tess_int maxtet,
                tess_int *ntet, tess_int *tet, tess_int *adj, tess_int liw,
                tess_int *iw, tess_int lrw, double *rw);

/* tess_locate - the tetrahedron that holds a point.
 *
 *   p, ntet, tet, adj  (in)  a result of tess with ntet >= 1
 *   q    (in)      the point: 3 coordinates
 *   t    (in,out)  On entry the tetrahedron where the walk starts, or
 *                  TESS_NONE for anywhere; for q inside it alters the speed
 *                  alone.  On return the one that holds q
 *   w    (out)     4 barycentric weights of q in it; they sum to one:
 *                  sum of w[k] * value[tet[4*t+k]] interpolates linearly
 *
 * returns 0 when q is inside or on the boundary; 1 when it is outside the
 * hull: w are then the weights of the hull's point nearest to q, none negative,
 * and t is the tetrahedron of a facet of the hull that has it: what w gives is
 * continuous in q.  -2 for ntet < 1, -4 for a neighbour that is out of range or
 * does not match, -5 for a NaN or infinity in q, -6 for a t that is out of
 * range; TESS_RANGE, w = 0, when the arithmetic cannot hold the coordinates
 * (see tess).
 *
 * Inside, the weights are at least 0, and 0 where q is in the plane of the
 * vertex's opposite facet (else only in a tetrahedron that is flat to
 * rounding); they sum to 1, and sum of w[k] p_k is q, to rounding, in slivers
 * too.  Outside, it is decided exactly which vertices, one to three, carry the
 * nearest point, and each weight is right to rounding.  To extrapolate instead,
 * add gradient.(q - sum of w[k] p_k), the gradient that of t (README).  An open
 * facet counts as hull; but an unfinished result is not convex: the point found
 * is nearest among those of the facets that are joined about it, and another
 * may be nearer.
 * Cost: a walk of about ntet^(1/3) / 2 steps from anywhere, a few from near; a
 * start that is far from q costs little more than none.  Outside, another walk
 * over the facets of the hull.
 */
int tess_locate(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, const tess_real *q, tess_int *t,
                double *w);

/* tess_values - linear interpolation at many points.
 *
 *   p, ntet, tet, adj  (in)  a result of tess with ntet >= 1
 *   nv     (in)      values a point, >= 0
 *   value  (in)      value[nv*i+j] is value j of point i
 *   nq     (in)      number of queries, >= 0
 *   q      (in)      3*nq coordinates
 *   t      (in,out)  nq: On entry tetrahedra where the walks start, each as in
 *                    tess_locate, or TESS_NONE: then it is the answer before,
 *                    if that is near.  On return the tetrahedra found: given
 *                    back for other values at these points, they spare the
 *                    search
 *   out    (out)     out[nv*i+j] is value j at query i
 *
 * returns 0; 1 when a query was outside the hull: its values are those at the
 * hull's nearest point (see tess_locate); -2 for ntet < 1, -5 for nv < 0, -7
 * for a bad nq, -8 for a NaN or infinity in q, -9 for a t that is out of range:
 * then nothing is written; -4 or TESS_RANGE as from tess_locate, with the
 * queries before done.
 * Cost: that of tess_locate, a few steps a query if the queries are in an order
 * in which neighbours follow each other.
 */
int tess_values(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, tess_int nv, const double *value,
                tess_int nq, const tess_real *q, tess_int *t, double *out);

/* tess_index - sort the points, for stars and queries without a mesh.
 *
 *   n       (in)   number of points, >= 0
 *   p       (in)   3*n coordinates; tess_query and tess_part need them as they
 *                  are now
 *   liw     (in)   length of iw; what tess_size recommends suffices, but for
 *                  tess_query alone 2*n + n/12 + 7 does, too
 *   iw      (out)  the index, in its first 2*n + n/12 + 7 places; for each code
 *                  >= 0 but TESS_RANGE iw[i] is the place of point i in the
 *                  sorted order, or of the point that stands for it: 0 ...
 *                  (from Fortran 1 ...).  Points of near places are near
 *                  each other
 *   lrw     (in)   length of rw, as tess_size says or 3*n + n/2 + 12
 *   rw      (out)  the index, too
 *
 * returns TESS_OK; TESS_PLANE, TESS_LINE, TESS_POINT or TESS_RANGE: there is no
 * mesh, and the calls below return that; -1 for a bad n, -2 for a NaN or
 * infinity in p, -3 and -5 for liw and lrw that are too small.
 * Cost: O(n log n), about a tenth of that of the mesh.
 */
int tess_index(tess_int n, const tess_real *p, tess_int liw, tess_int *iw,
               tess_int lrw, double *rw);

/* tess_query - the mesh's tetrahedron that holds a point, without the mesh.
 *
 *   n, p, iw, rw  (in)  points and their index.  Threads may share them
 *   q    (in)      the point: 3 coordinates
 *   v    (in,out)  4 points.  On entry a former answer, where the walk
 *                  starts, or v[0] = TESS_NONE for anywhere.  On return the
 *                  vertices of the tetrahedron, positively oriented
 *   w    (out)     4 barycentric weights of q: sum of w[k] * value[v[k]]
 *
 * The answer is that of tess_locate in the mesh that tess gives, but for the
 * order of the vertices, and, for q outside, which of the facets that have the
 * hull's nearest point is found.
 *
 * returns 0 or 1 as tess_locate does; what tess_index returned, if not 0; -1
 * for a bad n, -3 where iw and rw hold no index, -5 for a NaN or infinity in
 * q, -6 for a v of no tetrahedron.  (What is one, but none of the mesh, may
 * come back unchanged.)
 * Cost: a search for each tetrahedron that is crossed, from anywhere some 20
 * more, and for q outside one for each that is turned about.
 */
int tess_query(tess_int n, const tess_real *p, const tess_int *iw,
               const double *rw, const tess_real *q, tess_int *v, double *w);

/* tess_part - all tetrahedra of the mesh that have one of certain vertices.
 *
 *   n, p    (in)      the points of the index
 *   mine    (in)      n marks: asked for are the tetrahedra at each point i (or
 *                     the one that stands for it) with mine[i] != 0
 *   maxtet, ntet, tet, adj   as in tess_resume: *ntet = 0, or the beginning of
 *                     the result
 *   liw     (in)      length of iw, as in tess
 *   iw      (in,out)  the index as it came from tess_index, or a copy, and
 *                     behind it workspace.  On return iw is an index again
 *   lrw     (in)      length of rw
 *   rw      (in)      the rest of the index.  Threads may share it, each with
 *                     an iw of its own
 *
 * Each tetrahedron comes once.  A facet without a vertex asked for stays
 * TESS_OPEN.  Parts know nothing of each other and agree on everything, ties
 * included: take from each the tetrahedra whose vertex of least index is
 * asked for there, and if each point is asked for in one part, together they
 * are the mesh (see tess_resume for how to join them).
 *
 * returns what tess_resume returns, but -4 for maxtet, -5, -6, -7 for *ntet,
 * tet, adj, -8 and -10 for liw and lrw, -9 where iw and rw hold no index.
 */
int tess_part(tess_int n, const tess_real *p, const tess_int *mine,
              tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *adj,
              tess_int liw, tess_int *iw, tess_int lrw, const double *rw);

/* tess_ball - the ball of a tetrahedron.
 *
 *   p    (in)   the points
 *   v    (in)   4 of them
 *   c    (out)  the centre c[0] ... c[2], rounded, and the radius c[3], rounded
 *               outwards, so that the ball holds the true one: a point outside
 *               of it can do nothing to a tetrahedron of these vertices.
 *               DBL_MAX where there is no ball, all points being in one
 *               plane, or it cannot be computed: then all space
 *
 * returns 0, -1 for a NaN or infinity in the points, -2 for an index that is
 * out of range; TESS_RANGE, the radius DBL_MAX (see tess).
 */
int tess_ball(const tess_real *p, const tess_int *v, double *c);

/* tess_hull - the boundary triangles.
 *
 *   ntet, tet, adj  (in)  a result of tess
 *   maxfac  (in)   triangles that fac has room for
 *   nfac    (out)  number of triangles
 *   fac     (out)  3*maxfac: triangle i has the vertices fac[3*i], fac[3*i+1],
 *                  fac[3*i+2], seen counter-clockwise from outside, in the
 *                  order of the tetrahedra and their facets
 *
 * returns 0; TESS_MORE when fac is too small: nfac is then the number needed
 * and the first maxfac triangles are set; -1 for ntet < 0, -4 for maxfac < 0.
 */
int tess_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
              tess_int maxfac, tess_int *nfac, tess_int *fac);

/* tess_check - an exact proof that tet and adj are a Delaunay
 * tetrahedralization of p.
 *
 *   n, p, ntet, tet, adj  (in)  points and result
 *   liw     (in)   length of iw, at least 2*n
 *   iw      (out)  workspace
 *   bad     (out)  the tetrahedron at fault, or the point (TESS_BAD_POINT),
 *                  or TESS_NONE
 *
 * returns 0 when proven, or the first fault TESS_BAD_... found; TESS_RANGE
 * when the arithmetic cannot hold the coordinates (see tess).  Any valid
 * triangulation of cospherical points passes.  ntet = 0 passes when all points
 * lie in one plane, else it is TESS_BAD_POINT.  -1 for a bad n, -2 for a NaN or
 * infinity in p, -3 for a bad ntet, -6 for liw < 2*n.
 * Cost: O(ntet + n log n).
 */
int tess_check(tess_int n, const tess_real *p, tess_int ntet,
               const tess_int *tet, const tess_int *adj, tess_int liw,
               tess_int *iw, tess_int *bad);

#ifdef __cplusplus
}
#endif

#endif
