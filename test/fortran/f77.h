/* f77.h - the entries of f77/tess.f, and of f77/hhpred.f what tests want, for
 * callers in C: gfortran and f2c add an underscore to a name, and hand over
 * every argument by reference.  Arrays count from 1. */
#ifndef F77_H
#define F77_H

#include "../../tess.h"

#ifdef __cplusplus
extern "C" {
#endif

#define POINTS tess_int *n, const tess_real *p
#define MESH tess_int *ntet, tess_int *tet, tess_int *adj
#define SPACE tess_int *liw, tess_int *iw, tess_int *lrw, double *rw
#define INFO tess_int *info

void tesswk_(tess_int *n, tess_int *maxtet, tess_int *liw, tess_int *lrw, INFO);
void tess_(POINTS, tess_int *maxtet, MESH, SPACE, INFO);
void tessre_(POINTS, tess_int *maxtet, MESH, SPACE, INFO);
void tesslo_(const tess_real *p, MESH, const tess_real *q, tess_int *t,
             double *w, INFO);
void tessva_(const tess_real *p, MESH, tess_int *nv, const double *value,
             tess_int *nq, const tess_real *q, tess_int *t, double *out, INFO);
void tesshu_(MESH, tess_int *maxfac, tess_int *nfac, tess_int *fac, INFO);
void tessch_(POINTS, MESH, tess_int *liw, tess_int *iw, tess_int *bad, INFO);
void tessix_(POINTS, SPACE, INFO);
void tesspa_(POINTS, const tess_int *mine, tess_int *maxtet, MESH, SPACE, INFO);
void tessqu_(POINTS, tess_int *iw, const double *rw, const tess_real *q,
             tess_int *v, double *w, INFO);
void tessba_(const tess_real *p, tess_int *v, double *c, INFO);
tess_int hhorie_(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d);
tess_int hhinsp_(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d, const tess_real *e);
void hhfoot_(const tess_real *a, const tess_real *b, const tess_real *c,
             const tess_real *q, tess_int *want, double *w, tess_int *set);
tess_int hhrang_(double *x, double *most);
void hhface_(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             double *f, INFO);
double hhside_(const double *f, const tess_real *z);
double hhlcoo_(const double *f, const tess_real *z);
void hhsetu_(const double *p1, const double *p2, const double *p3, double *f);
void hhlimi_(const double *f, const double *z, double *lo, double *hi,
             tess_int *side);

#ifdef __cplusplus
}
#endif

#undef POINTS
#undef MESH
#undef SPACE
#undef INFO

#endif
