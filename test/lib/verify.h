/* verify.h - whether a result of tess is the one that the rule of ties asks for,
 * by exact.c alone.
 *
 * verify - the first fault, in words, or NULL.  All is verified that makes a
 * result right: iw, the code, orientation, adj, the perturbed Delaunay property
 * across every facet, that every distinct point is a vertex, and that the hull is
 * closed, convex, a sphere and covered once.  Where the sets are small it is the
 * definition itself: no point is in the perturbed ball of a tetrahedron, or
 * outside of a triangle of the hull.
 *
 * verify_twins - iw alone.  verify_hull - the triangles that tess_hull gave. */
#ifndef VERIFY_H
#define VERIFY_H

#include "../../tess.h"

const char *verify(tess_int n, const tess_real *p, int code, tess_int ntet,
                   const tess_int *tet, const tess_int *adj,
                   const tess_int *iw);
const char *verify_twins(tess_int n, const tess_real *p, const tess_int *iw);
const char *verify_hull(tess_int ntet, const tess_int *tet,
                        const tess_int *adj, tess_int nfac,
                        const tess_int *fac);
/* The vertex at place i of facet k of tetrahedron v, seen counter-clockwise from
 * outside. */
tess_int verify_corner(const tess_int *v, int k, int i);

#endif
