/* tess.h - Delaunay tetrahedralization of points in space.
 *
 * SPDX-License-Identifier: 0BSD
 * Copyright (c) 2026 the tess authors
 *
 * Permission to use, copy, modify, and/or distribute this software for any
 * purpose with or without fee is hereby granted.
 *
 * THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
 * REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY
 * AND FITNESS. IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
 * INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
 * LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR
 * OTHER TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR
 * PERFORMANCE OF THIS SOFTWARE.
 *
 * After C. Hazlewood, "Facet-Based Tetrahedralization Software" (1995).
 *
 * This file is the manual.  Arrays whose lengths are known when you compile:
 *
 *     #include "tess.h"
 *     #define N 1000
 *     static tess_real p[3 * N];
 *     static tess_int tet[32 * N], adj[32 * N], iw[TESS_LIW(N)];
 *     static double rw[TESS_LRW(N)];
 *
 *     tess_int mesh(tess_int n)
 *     {
 *         tess_int ntet;
 *         int code = tess(n, p, 8 * N, &ntet, tet, adj, TESS_LIW(N), iw,
 *                         TESS_LRW(N), rw);
 *         return code == TESS_OK ? ntet : 0;
 *     }
 *
 * Room for 8*N tetrahedra is enough where points fill a volume; tess_size says
 * what other points need.  Lengths that are known only at run time:
 *
 *     #include <stdlib.h>
 *     #include "tess.h"
 *     #define NO_MEMORY 100
 *
 *     int mesh(tess_int n, const tess_real *p, tess_int *ntet, tess_int **tet,
 *              tess_int **adj)
 *     {
 *         tess_int liw, lrw, room, *iw = NULL, *t, *a;
 *         double *rw = NULL;
 *         int code = tess_size(n, 0, &liw, &lrw);
 *
 *         *ntet = 0;
 *         *tet = *adj = NULL;
 *         if (code != TESS_OK) return code;
 *         iw = (tess_int *)malloc((size_t)liw * sizeof *iw);
 *         rw = (double *)malloc((size_t)lrw * sizeof *rw);
 *         room = (tess_int)(8 * n + 1);
 *         do {
 *             size_t bytes = (size_t)room * (4 * sizeof *t);
 *             if ((t = (tess_int *)realloc(*tet, bytes)) != NULL) *tet = t;
 *             if ((a = (tess_int *)realloc(*adj, bytes)) != NULL) *adj = a;
 *             code = iw && rw && t && a
 *                        ? tess_resume(n, p, room, ntet, *tet, *adj, liw, iw,
 *                                      lrw, rw)
 *                        : NO_MEMORY;
 *             room = (tess_int)(room + room / 4);
 *         } while (code == TESS_MORE);
 *         free(iw);
 *         free(rw);
 *         return code;
 *     }
 *
 * With *ntet = 0, tess_resume does what tess does; called again, it goes on
 * from where the arrays were full.  TESS_POOL, which asks for a longer iw, is
 * rare: see tess_size.  The caller frees *tet and *adj.
 *
 * Which routine do I need?
 *   a mesh of points                            tess
 *   lengths of arrays at run time               tess_size
 *   longer arrays after TESS_MORE, TESS_POOL    tess_resume
 *   the tetrahedron at a place, its weights     tess_locate
 *   values at many places                       tess_values
 *   the hull of a mesh, as triangles            tess_hull
 *   a proof that a mesh is right                tess_check
 *   a search index, for the next two            tess_index
 *   the tetrahedron at a place, without a mesh  tess_query
 *   a mesh in parts, by threads or processes    tess_part
 *   the circumsphere of a tetrahedron           tess_ball
 *   the version of the compiled library         tess_edition
 *   recipes: routines to copy                   test/recipes/README.md
 *
 * Arrays, the same in all routines:
 *   p      point i has the coordinates p[3*i], p[3*i+1], p[3*i+2]: any finite
 *          values, in any units.  Never altered.
 *   tet    tetrahedron t has the vertices tet[4*t] ... tet[4*t+3], indices
 *          of points, positively oriented: det [b-a c-a d-a] > 0.
 *   adj    adj[4*t+k] is the tetrahedron across the facet opposite to
 *          tet[4*t+k]; TESS_NONE on the hull; TESS_OPEN for a facet still
 *          open, which only an unfinished mesh has.
 * The mesh, tet and adj, is a function of the points and their order alone: the
 * same on every machine, with every compiler, in C and in FORTRAN.
 *
 * Memory: nothing but the caller's arrays and a bounded stack.  The stack, by
 * gcc -O2 on x86-64, with options that affect it (TESS_LIST below, HH_LIMBS in
 * hhpred.h):
 *
 *     options                          usual points    any points
 *     none                                   93 KB        121 KB
 *     -DTESS_LIST=128                        48 KB         76 KB
 *     -DTESS_LIST=64 -DHH_LIMBS=12           15 KB         15 KB
 *
 *   tet, adj   4*maxtet tess_int each; n random points have about 6.8 n
 *              tetrahedra (more: see tess_size)
 *   iw, rw     the lengths that tess_size gives, or TESS_LIW(n), TESS_LRW(n),
 *              which are up to 15 % more
 *
 * With integers of 4 bytes iw and rw take 142 bytes a point for 100 points, 103
 * for 10000, 73 for 1000000; with tetrahedra, 6.8 n of 32 bytes, 359, 320, 291.
 *
 * Types: tess_int, of all indices and lengths, is int (long where int has 16
 * bits); tess_real, of coordinates, is double.  To choose others compile all
 * files alike: with -DTESS_INT=long for more than 79 million points (64-bit
 * Windows: ptrdiff_t, see hhpred.h), -DTESS_INT=short on a very small machine,
 * -DTESS_FLOAT for coordinates in float.  Values, workspace and arithmetic stay
 * double.  Object files compiled with different types do not link.
 *
 * Names: tess and all external names that begin with tess_ or hh_ are reserved
 * for the library, now and in later versions; so are macros and types that
 * begin with TESS_, HH_, tess_ or hh_.  C++ compiles all four files.
 *
 * No routine allocates, reads, writes, keeps state between calls or stops
 * the program; all may be called from any number of threads at once.
 *
 * Damaged tet and adj are no danger: every call ends, and stays within the
 * arrays.  tess_locate and tess_values, which do not know n, need indices of
 * points in tet.  A search index is trusted: see tess_index.
 *
 * Floating point: codes, meshes and the tetrahedra that hold places are the
 * same in all rounding modes; weights and values are rounded last, and may
 * differ in their last bits.  On ordinary coordinates, 1e30 at most and with
 * differences of at least 1e-30 of the largest, no call sets a flag but
 * inexact, nor errno.  No call sets invalid, divide-by-zero or overflow, or is
 * stopped where they are trapped, whatever numbers it is given, NaNs and
 * infinities among them.  (Of flags, -ffast-math promises nothing.)
 */
#ifndef TESS_H
#define TESS_H

#include "hhpred.h"

#ifdef TESS_OTHER
/* Other types have other names: see hhpred.h. */
#define tess TESS_AS(tess_)
#define tess_size TESS_AS(tess_size)
#define tess_resume TESS_AS(tess_resume)
#define tess_locate TESS_AS(tess_locate)
#define tess_values TESS_AS(tess_values)
#define tess_hull TESS_AS(tess_hull)
#define tess_check TESS_AS(tess_check)
#define tess_index TESS_AS(tess_index)
#define tess_query TESS_AS(tess_query)
#define tess_part TESS_AS(tess_part)
#define tess_ball TESS_AS(tess_ball)
#define tess_edition TESS_AS(tess_edition)
#endif

/* 10000 * major + 100 * minor + patch; test/CHANGES says what is new.  Files of
 * different versions do not compile, or, as objects, link: see hhpred.h. */
#define TESS_VERSION 50000L
#if TESS_VERSION != HH_VERSION
#error tess.h and hhpred.h are of different versions
#endif

/* TESS_LIST: when tess.c is compiled, the capacity of the lists of points that
 * a search looks at first: a multiple of 4, 48 to 4096, 448 if not given.  It
 * affects speed and stack (about 145 bytes a point of it), never the mesh.
 * Below 128 the code for points near planes and spheres, on surfaces and on
 * curves is left out; use 48 or 64 on a small machine.
 *
 * TESS_CORE: leaves out all that only makes searches faster, part II of tess.c.
 * The mesh is the same, the code two thirds as long; random points take 1.5 to
 * 1.7 times as long, lattices 3.5, a globe of 2,000 points 100 times.
 *
 * TESS_NO_LISTS, TESS_NO_NEAR_LISTS, TESS_NO_HULL_PLANES, TESS_NO_SETS,
 * TESS_NO_CYLINDERS, TESS_NO_CAPS, TESS_NO_LIMBS, TESS_NO_SURFACES: each leaves
 * out one chapter of it, and what rests on that; what it costs is said there.
 * With all but TESS_NO_LIMBS the code is 3,000 bytes longer than with
 * TESS_CORE, and the globe takes 7 times as long. */

#define TESS_NONE (-1)
#define TESS_OPEN (-2)

/* Codes.  -k means that argument k is invalid. */
#define TESS_OK 0     /* done                                              */
#define TESS_MORE 1   /* tet and adj are full: tess_resume with longer ones */
#define TESS_POOL 2   /* the facet pool is full: the same, with a longer iw */
#define TESS_PLANE 3  /* all points are coplanar: no tetrahedron.  (For
                         triangles there is the recipe tr_planar)             */
#define TESS_LINE 4   /* all points are collinear                          */
#define TESS_POINT 5  /* at most one distinct point                        */
#define TESS_RANGE 6  /* the arithmetic cannot hold the coordinates         */
/* Faults that tess_check finds. */
#define TESS_BAD_INDEX 10  /* a vertex out of range, or twice in one       */
#define TESS_BAD_TWIN 11   /* a vertex that is a duplicate of another one  */
#define TESS_BAD_SIGN 12   /* coplanar vertices, or negatively oriented    */
#define TESS_BAD_OPEN 13   /* an open facet: the mesh is unfinished        */
#define TESS_BAD_ADJ 14    /* neighbour out of range, or not mutual        */
#define TESS_BAD_BALL 15   /* neighbour's apex inside the circumsphere     */
#define TESS_BAD_HULL 16   /* the hull is not closed, or not convex        */
#define TESS_BAD_COVER 17  /* the hull is covered more than once           */
#define TESS_BAD_POINT 18  /* a point is in no tetrahedron                 */

#ifdef __cplusplus
extern "C" {
#endif

/* tess - the Delaunay tetrahedralization of n points.
 *
 *   n       (in)   number of points, >= 0
 *   p       (in)   3*n coordinates
 *   maxtet  (in)   tetrahedra that tet and adj have room for, >= 0
 *   ntet    (out)  number of tetrahedra; for a NaN or infinity in p (code
 *                  -2) the index of the first point that has one
 *   tet     (out)  4*maxtet; the first 4*ntet are set
 *   adj     (out)  4*maxtet; the first 4*ntet are set
 *   liw     (in)   length of iw, at least 4*n + 2*L + 512, where L is the least
 *                  power of two with 48*L >= n: 4*n + n/12 + 514 always
 *                  suffices.  Give what tess_size says: a shorter one may fill
 *                  up (TESS_POOL), and has no room to note planes and spheres:
 *                  see Cost
 *   iw      (out)  workspace.  On return, for each code >= 0 but TESS_RANGE,
 *                  iw[i] is the least index of any point that has the
 *                  coordinates of point i (-0.0 equals 0.0): i, unless point i
 *                  is a duplicate.  A duplicate is never a vertex
 *   lrw     (in)   length of rw, at least 3*n + 12*L: 3*n + n/2 + 12 always
 *                  suffices
 *   rw      (out)  workspace
 *
 * returns TESS_OK; TESS_MORE or TESS_POOL (what tet and adj hold is right: go
 * on with tess_resume); TESS_PLANE, TESS_LINE, TESS_POINT or TESS_RANGE (ntet =
 * 0); or -k: -1 for n < 0, -2 for a NaN or infinity in p, -3 for a maxtet that
 * is negative or too large for tess_int, -7 and -9 for liw and lrw that are
 * too small.  After -k nothing is written but ntet.
 *
 * TESS_RANGE has three causes: the coordinates need more limbs than HH_LIMBS
 * (impossible with the default); a coordinate is subnormal, and the processor
 * flushes subnormal numbers to zero (as in programs linked with -Ofast); or the
 * processor rounds to fewer bits than a double has (an x87 unit set to 24).
 *
 * Cospherical points: of several valid meshes the order of the points selects
 * one (the pulling triangulation).  The vertices of a tetrahedron are never
 * coplanar; they may be almost so (slivers).
 * Cost: about linear in n for points that fill a volume or, but for rounding,
 * lie near up to eight planes and spheres.  More, for a linear number of
 * tetrahedra:
 *   - on smooth surfaces and between parallel sheets somewhat more; on tubes,
 *     tori and the two sides of a thin curved sheet about n^(3/2);
 *   - near planes that cross at a tiny angle, on a slanted line, between sheets
 *     1e-6 or 1e-8 apart beyond 20,000 points, almost n^2;
 *   - thousands of points exactly on one sphere, as integers can be, O(n^2):
 *     8,000 take seconds;
 *   - exponents hundreds apart, O(n^2): 300 points with random ones take
 *     seconds, 1,000 a minute; so do 2,000 of which many have a coordinate near
 *     DBL_MAX (-3.4e38 and the like, which mark missing numbers, cost little);
 *   - points near planes and spheres (faces of a turned box, globes, noisy
 *     terrain) with an iw shorter than tess_size says.
 * The method is that of Hazlewood (1995), Section 2.
 */
TESS_API int tess(tess_int n, const tess_real *p, tess_int maxtet,
                  tess_int *ntet, tess_int *tet, tess_int *adj, tess_int liw,
                  tess_int *iw, tess_int lrw, double *rw);

/* tess_size - recommended lengths of the workspace of tess.
 *
 *   n       (in)   number of points
 *   maxtet  (in)   tetrahedra that tet and adj have room for: checked, but the
 *                  lengths do not depend on it; 0 will do
 *   liw     (out)  length of iw, tess_ints
 *   lrw     (out)  length of rw, doubles
 *
 * The pool of open facets that liw includes suffices for all inputs except
 * those whose number of tetrahedra is quadratic in n and, beyond 28,000 points,
 * some where one vertex is in almost all tetrahedra (a plane grid and one
 * point).
 *
 * How large should maxtet be?  8 n is enough where the points fill a volume
 * (they have 6 to 6.8 n tetrahedra), for lattices (4.8 to 6 n), and near
 * planes, spheres and most smooth surfaces (2 to 7.2 n).  Random points on a
 * tube or a torus need more (9 to 20 n for 1,000 to 60,000 points), a helix or
 * two lines up to n^2 / 2.  A low guess costs little: after TESS_MORE
 * tess_resume takes as long as n tetrahedra of random points, plus a third of
 * the time that the existing ones took.
 *
 * returns 0; -1 for a bad n, -2 for a bad maxtet: negative, or so large that a
 * length, or 4*maxtet + 3, would exceed the largest tess_int.  The lengths are
 * then 0.
 */
TESS_API int tess_size(tess_int n, tess_int maxtet, tess_int *liw,
                       tess_int *lrw);

/* tess_resume - go on from an unfinished mesh.
 *
 * The arguments are those of tess, but ntet, tet, adj are (in, out): the first
 * *ntet tetrahedra that tess or tess_resume left of the same points, copied
 * into longer arrays if need be.  What iw and rw hold does not matter.  The
 * mesh is exactly that of one call with enough room.  With *ntet = 0 it is
 * tess; on a finished mesh it returns TESS_OK and changes nothing but iw, rw.
 *
 * The tetrahedra may be any of the mesh's, in any order, as the recipe tr_join
 * puts them together from parts: adj must name both neighbours of a facet
 * between two of them, and TESS_OPEN where one is missing.  Each open facet
 * that waits for its other side takes 4 tess_ints of iw.
 *
 * returns what tess returns; -4 for a bad *ntet; -5 and -6 for a fault in tet
 * and adj: an index out of range; a tetrahedron that has a duplicate for a
 * vertex, is not positively oriented, or has a neighbour's apex inside its
 * circumsphere; neighbours that do not share a facet; a facet that is open
 * twice.  After -k *ntet, tet and adj are unchanged.  Damage that one pass
 * cannot find gives a wrong mesh, but in bounded time and within the arrays.
 */
TESS_API int tess_resume(tess_int n, const tess_real *p, tess_int maxtet,
                         tess_int *ntet, tess_int *tet, tess_int *adj,
                         tess_int liw, tess_int *iw, tess_int lrw, double *rw);

/* tess_locate - the tetrahedron that holds a place.
 *
 *   p, ntet, tet, adj  (in)  a mesh of tess with ntet >= 1
 *   q    (in)      the place: 3 coordinates
 *   t    (in,out)  Set it to TESS_NONE at first, then leave it: on return it is
 *                  the tetrahedron that holds q, and a start for the next walk,
 *                  which is short if the next q is near.  For a q inside the
 *                  hull the answer does not depend on the start
 *   w    (out)     4 barycentric weights of q in it; they sum to one:
 *                  sum of w[k] * value[tet[4*t+k]] interpolates linearly
 *
 * returns 0 when q is inside the hull or on it; 1 when it is outside: w then
 * holds the weights of the point of the hull nearest to q, none negative, and t
 * is the tetrahedron of a hull triangle that has this point, so that the
 * interpolant is continuous in q; -2 for ntet < 1; -4 where the walk shows that
 * tet and adj are no finished mesh: it meets an open facet or a neighbour
 * that is out of range or does not match, or takes ntet steps; -5 for a NaN or
 * infinity in q, -6 for a t that is out of range; TESS_RANGE, w = 0, when the
 * arithmetic cannot hold the coordinates (see tess), or the walk meets a vertex
 * that has a NaN or an infinity.
 *
 * Inside, no weight is negative; a weight is 0 where q is in the plane of the
 * facet opposite to its vertex, and otherwise only in a sliver so thin that its
 * vertices are coplanar but for rounding.  The weights sum to 1, and sum of
 * w[k] p_k is q, to rounding, in slivers too.  Outside, the one to three
 * vertices that carry the nearest point are decided exactly, and each weight is
 * right to rounding.  Do not extrapolate by the gradient of t: tetrahedra at
 * the hull are often slivers, whose gradients are far steeper than the field's.
 * Cost: a walk of about ntet^(1/3) / 2 steps without a start, of a few from a
 * near one; a bad start costs no more than none.  For q outside, another walk
 * over the hull triangles.
 */
TESS_API int tess_locate(const tess_real *p, tess_int ntet, const tess_int *tet,
                         const tess_int *adj, const tess_real *q, tess_int *t,
                         double *w);

/* tess_values - linear interpolation at many places.
 *
 *   p, ntet, tet, adj  (in)  a mesh of tess with ntet >= 1
 *   nv     (in)      values per point, >= 0
 *   value  (in)      value[nv*i+j] is value j of point i; of duplicates the
 *                    first one's counts
 *   nq     (in)      number of places, >= 0
 *   q      (in)      3*nq coordinates
 *   t      (in,out)  nq: Set all to TESS_NONE at first: each walk then starts
 *                    from the previous answer, if that is near.  On return the
 *                    tetrahedra found: t[i] itself for a place inside the hull
 *                    or on it; for one outside -2 - k, where k is a
 *                    tetrahedron at the nearest hull triangle.  To interpolate
 *                    other values at the same places pass t back as it is: then
 *                    nothing is searched.  After a new mesh set it to TESS_NONE
 *                    again
 *   out    (out)     out[nv*i+j] is value j at place i; for a place outside the
 *                    hull, value j at the nearest point of the hull (see
 *                    tess_locate)
 *
 * The interpolant is continuous and, but for rounding, within the range of the
 * data.  If a vertex whose weight is not 0 has the value NaN, the result is
 * NaN; otherwise, if one is infinite, it is that infinity, or the negative one
 * if there are both.  For another value outside, say a NaN:
 *
 *     for (i = 0; i < nq; i++) t[i] = TESS_NONE;
 *     code = tess_values(p, ntet, tet, adj, 1, value, nq, q, t, out);
 *     for (i = 0; code == 1 && i < nq; i++)
 *         if (t[i] < TESS_NONE) out[i] = outside;
 *
 * Smoother and more accurate: the recipes tr_slopes and tr_bent.
 *
 * returns 0; 1 when a place is outside the hull; -2 for ntet < 1, -5 for nv <
 * 0, -7 for a bad nq, -8 for a NaN or infinity in q, -9 for a t that is out of
 * range: then nothing is written; -4 or TESS_RANGE as from tess_locate: then
 * the places before that one are done.
 * Cost: that of tess_locate: a few steps a place if successive places are
 * close to each other.  In random order each takes ten times as long: sort them
 * first, by the positions that tess_index(nq, q, ...) gives.
 */
TESS_API int tess_values(const tess_real *p, tess_int ntet, const tess_int *tet,
                         const tess_int *adj, tess_int nv, const double *value,
                         tess_int nq, const tess_real *q, tess_int *t,
                         double *out);

/* tess_hull - the hull triangles.
 *
 *   ntet, tet, adj  (in)  a mesh of tess
 *   maxfac  (in)   triangles that fac has room for
 *   nfac    (out)  number of triangles
 *   fac     (out)  3*maxfac: triangle i has the vertices fac[3*i], fac[3*i+1],
 *                  fac[3*i+2], seen counter-clockwise from outside, in the
 *                  order of the tetrahedra and their facets
 *
 * returns 0; TESS_MORE when fac is too small: nfac is then the number needed
 * and the first maxfac triangles are set; -1 for ntet < 0, -4 for maxfac < 0.
 */
TESS_API int tess_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
                       tess_int maxfac, tess_int *nfac, tess_int *fac);

/* tess_check - an exact proof that tet and adj are a Delaunay
 * tetrahedralization of p.
 *
 *   n, p, ntet, tet, adj  (in)  points and mesh
 *   liw     (in)   length of iw, at least 2*n
 *   iw      (out)  workspace
 *   bad     (out)  the tetrahedron at fault, or the point (TESS_BAD_POINT),
 *                  or TESS_NONE
 *
 * returns 0 when proven, or the first fault TESS_BAD_... found; TESS_RANGE
 * when the arithmetic cannot hold the coordinates (see tess).  Where points are
 * cospherical every valid mesh passes.  ntet = 0 passes when all points are
 * coplanar, else it is TESS_BAD_POINT.  -1 for a bad n, -2 for a NaN or
 * infinity in p, -3 for a bad ntet, -6 for liw < 2*n.
 * Cost: O(ntet + n log n).
 */
TESS_API int tess_check(tess_int n, const tess_real *p, tess_int ntet,
                        const tess_int *tet, const tess_int *adj, tess_int liw,
                        tess_int *iw, tess_int *bad);

/* tess_index - make a search index, for tess_query and tess_part.
 *
 *   n       (in)   number of points, >= 0
 *   p       (in)   3*n coordinates; tess_query and tess_part need them
 *                  unchanged
 *   liw     (in)   length of iw, as tess_size gives; 7*n + 600 suffices, too.
 *                  With less, down to 2*n + 2*L + 5 (see tess; 2*n + n/12 + 7
 *                  always suffices), the search index has no room for the
 *                  planes and spheres that many points are near, and there
 *                  tess_part and tess_query take longer
 *   iw      (out)  the search index.  For each code >= 0 but TESS_RANGE iw[i]
 *                  is the position, from 0 on, of point i in the sorted order
 *                  (a duplicate has its first's).  Points at close positions
 *                  are close in space
 *   lrw     (in)   length of rw, as tess_size gives; or less, down to what tess
 *                  needs: then parts of surfaces and curves take longer
 *   rw      (out)  the search index, too
 *
 * To copy a search index, copy the first 7*n + 600 elements of iw (all of them,
 * if there are fewer) and all of rw.  It serves in any rounding mode and in any
 * build with the same tess_int, tess_real and double.  tess and tess_resume in
 * the same arrays destroy it.
 * tess_query and tess_part reject arrays that never held a search index.  They do not notice one that is damaged, or points that
 * have changed since it was made: then they may not end.
 *
 * returns TESS_OK; TESS_PLANE, TESS_LINE, TESS_POINT or TESS_RANGE: there is no
 * mesh, and tess_query and tess_part return the same; -1 for a bad n, -2 for a
 * NaN or infinity in p, -3 and -5 for liw and lrw that are too small.
 * Cost: O(n log n), about a tenth of that of the mesh, a quarter near planes
 * and spheres.  With integers of 4 bytes iw and rw take 36 bytes a point at the
 * least, 56 with room for planes and spheres.
 */
TESS_API int tess_index(tess_int n, const tess_real *p, tess_int liw,
                        tess_int *iw, tess_int lrw, double *rw);

/* tess_query - the tetrahedron that holds a place, without a mesh.
 *
 *   n, p, iw, rw  (in)  points and their search index.  Threads may share them
 *   q    (in)      the place: 3 coordinates
 *   v    (in,out)  4 points.  On entry an earlier answer, where the walk
 *                  starts, or v[0] = TESS_NONE for anywhere.  On return the
 *                  vertices of the tetrahedron, positively oriented
 *   w    (out)     4 barycentric weights of q: sum of w[k] * value[v[k]]
 *
 * The answer is that of tess_locate in the mesh that tess gives.  Only the
 * order of the vertices may differ and, for q outside, which of the hull
 * triangles that have the nearest point is found.
 *
 * returns 0 or 1 as tess_locate does; what tess_index returned, if that was not
 * 0; -1 for a bad n, -3 where iw and rw hold no search index, -5 for a NaN or
 * infinity in q, -6 for a v that is no tetrahedron.  A v that is one, but not
 * of the mesh, such as an answer from another search index, does no harm.
 * Cost: a search for an apex for each tetrahedron that the walk crosses, and
 * for q outside for each that is passed while turning about an edge of the
 * hull.  One more search proves the answer if a start is given; without one
 * about 20 find a start.  A mesh is faster from some n/6 places on if they are
 * scattered, n/3 if each is close to the one before.  A globe of 20,000 points
 * takes 150 times as long from a search index that has no room for its sphere.
 */
TESS_API int tess_query(tess_int n, const tess_real *p, const tess_int *iw,
                        const double *rw, const tess_real *q, tess_int *v,
                        double *w);

/* tess_part - all tetrahedra of the mesh that have one of certain vertices.
 *
 *   n, p    (in)      the points of the search index
 *   mine    (in)      n marks: the tetrahedra wanted are those at each point i
 *                     with mine[i] != 0; a mark on a duplicate is one on the
 *                     first point with its coordinates
 *   maxtet, ntet, tet, adj   as in tess_resume: *ntet = 0, or the beginning of
 *                     the part
 *   liw     (in)      length of iw, at least what tess needs; if the search
 *                     index knows planes or spheres, at least 5*n + 18*L + 632:
 *                     6*n + 600 always suffices.  The rest becomes pool: 7*n +
 *                     600 + TESS_LIW(m) is enough for m points marked, unless
 *                     one has very many neighbours
 *   iw      (in,out)  the search index as tess_index left it, or a copy; what
 *                     is behind it is workspace.  On return a search index
 *                     again, which also knows the planes and spheres that the
 *                     part found
 *   lrw     (in)      length of rw, as for tess_index
 *   rw      (in)      the rest of the search index.  Threads may share it, each
 *                     with an iw of its own
 *
 * Each tetrahedron appears once.  A facet without a marked vertex stays
 * TESS_OPEN.  Parts are computed independently, yet agree on everything, also
 * where points are cospherical.  If each point is marked in exactly one part,
 * and from each part those tetrahedra are taken whose vertex of least index is
 * marked there, together they are the mesh.  The recipe tr_join makes them one
 * mesh.
 *
 * returns what tess_resume returns, but -3 for a NULL mine, -4 for maxtet, -5,
 * -6, -7 for *ntet, tet, adj, -8 and -10 for liw and lrw, -9 where iw and rw
 * hold no search index.
 */
TESS_API int tess_part(tess_int n, const tess_real *p, const tess_int *mine,
                       tess_int maxtet, tess_int *ntet, tess_int *tet,
                       tess_int *adj, tess_int liw, tess_int *iw, tess_int lrw,
                       const double *rw);

/* tess_ball - the circumsphere of a tetrahedron, rounded outwards.
 *
 *   p    (in)   the points
 *   v    (in)   4 of them
 *   c    (out)  the centre c[0] ... c[2], rounded, and the radius c[3], rounded
 *               up, so that the true circumsphere is inside: a point outside
 *               cannot alter a tetrahedron of these vertices.  The radius is
 *               DBL_MAX, all of space, where the vertices are coplanar or the
 *               circumsphere cannot be computed
 *
 * returns 0; -1 for a NaN or infinity in the points, -2 for a negative
 * index; TESS_RANGE, with the radius DBL_MAX (see tess).
 */
TESS_API int tess_ball(const tess_real *p, const tess_int *v, double *c);

/* tess_edition - TESS_VERSION of the compiled library: a program that is linked
 * with a shared one may compare it with its own. */
TESS_API long tess_edition(void);

#ifdef __cplusplus
}
#endif

/* TESS_LIW(n), TESS_LRW(n) - lengths of iw and rw for n points: constant
 * expressions, for arrays.  What tess_size gives or little more; with a
 * TESS_LIST below 128 up to a tenth less, which suffices, too.  n: an integer
 * of any type.  FORTRAN: see f77/README.
 *
 *   TESS_LIW   per point 4 for itself, 1/12 for the tree, 4 for the pool; plus
 *              TESS_LP for the pool, TESS_LS for points near planes or spheres
 *   TESS_LRW   per point TESS_LR for itself, 1/2 for the tree; plus TESS_LC for
 *              points on surfaces and curves */
#define TESS_LR 3
#define TESS_LRW(n)                                          \
    (TESS_LR * TESS_WIDE(n) + 6 * (TESS_WIDE(n) / 12 + 2) +  \
     TESS_LC(TESS_WIDE(n)))
#define TESS_LC(n) ((n) < TESS_SURFACES_FROM ? 0 : 16 * ((n) / 36 + 1))
#define TESS_LIW(n)                                                        \
    ((n) > TESS_INT_MOST / 11 || TESS_LI(TESS_WIDE(n)) > TESS_INT_MOST     \
         ? TESS_WIDE(TESS_INT_MOST)                                        \
         : TESS_LI(TESS_WIDE(n)))
/* n in the widest of its type, tess_int's and long */
#define TESS_WIDE(n) (1 ? (n) : 0L + TESS_INT_MOST)
#define TESS_LI(n) (8 * (n) + (n) / 12 + 514 + TESS_LP(n) + TESS_LS(n))
#define TESS_LS(n) ((n) < TESS_SURFACES_FROM ? 0 : (n) / 3 * 5 + 24)
#define TESS_LP(n)             \
    ((n) <= 8       ? 240      \
     : (n) <= 27    ? 540      \
     : (n) <= 64    ? 960      \
     : (n) <= 125   ? 1500     \
     : (n) <= 1000  ? 8 * (n) + 1204 \
     : (n) <= TESS_HUB / 8 ? 8 * (n) \
                           : TESS_HUB + (n) / 5 * 2)
/* With fewer points there are no reference surfaces and no cylinders. */
#define TESS_SURFACES_FROM 500
/* The pool's part beyond 4 n, up to 8 n: memory against TESS_POOL where one
 * vertex has a very large star. */
#define TESS_HUB 225000L

#endif
