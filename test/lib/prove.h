/* prove.h - proofs, by exact.c and verify.c, of the answers that parity.c writes.
 *
 * Nothing of the library is made use of.  What is wrong is said on standard
 * error; prove_end gives the program's exit code.  Without PROVE there are no
 * proofs, and parity.c needs nothing else of this folder.
 */
#ifndef PROVE_H
#define PROVE_H

#include "../../tess.h"

#ifdef PROVE

/* What tess gave. */
void prove_result(tess_int n, const double *p, int code, tess_int ntet,
                  const tess_int *tet, const tess_int *adj,
                  const tess_int *iw);
void prove_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
                tess_int nfac, const tess_int *fac);
/* What tess_locate gave; no adj: what tess_query gave. */
void prove_place(tess_int n, const double *p, const tess_int *tet,
                 const tess_int *adj, const double *q, tess_int t,
                 const double *w, int code);
/* What hh_orient and hh_insphere gave for v[0..3], v[0..4]. */
void prove_signs(const double *const *v, int orient, int insphere);
/* What hh_facet gave; then hh_side, hh_lcoord, hh_opp and hh_wrap. */
void prove_facet(const double *p1, const double *p2, const double *p3,
                 int code, const double *f);
void prove_house(const double *p1, const double *p2, const double *p3,
                 const double *z1, const double *z2, double side, double l,
                 int opp, int code, double c);
int prove_end(void);

#else

#define prove_result(n, p, code, ntet, tet, adj, iw) ((void)0)
#define prove_hull(ntet, tet, adj, nfac, fac) ((void)0)
#define prove_place(n, p, tet, adj, q, t, w, code) ((void)0)
#define prove_signs(v, orient, insphere) ((void)0)
#define prove_facet(p1, p2, p3, code, f) ((void)0)
#define prove_house(p1, p2, p3, z1, z2, side, l, opp, code, c) ((void)0)
#define prove_end() 0

#endif

#endif
