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
#define CALLERS const tess_real *p, const tess_int *order
#define SET const double *x, CALLERS

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
tess_int tessed_(void);
tess_int hhorie_(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d);
tess_int hhinsp_(const tess_real *a, const tess_real *b, const tess_real *c,
                 const tess_real *d, const tess_real *e);
void hhfoot_(const tess_real *a, const tess_real *b, const tess_real *c,
             const tess_real *q, tess_int *want, double *w, tess_int *set);
tess_int hhfits_(double *x, double *most);
tess_int hharea_(tess_int *axis, const tess_real *a, const tess_real *b,
                 const tess_real *c);
void hhweig_(const tess_real *p, const tess_int *tet, tess_int *t,
             const tess_real *q, double *w, INFO);
tess_int hhwide_(double *a, double *b, double *c, double *d);
tess_int hhheld_(const tess_real *p);
tess_int hhhold_(tess_int *n, const tess_real *p);
void hhface_(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             double *f, INFO);
double hhside_(const double *f, const tess_real *z);
double hhlcoo_(const double *f, const tess_real *z);
void hhsetu_(const double *p1, const double *p2, const double *p3, double *f);
void hhlimi_(const double *f, const double *z, double *lo, double *hi,
             tess_int *side);
tess_int hhopp_(const double *f, const tess_real *z1, const tess_real *z2);
void hhwrap_(const tess_real *p1, const tess_real *p2, const tess_real *p3,
             const tess_real *z, double *c, INFO);
/* of sets: see hh_set */
tess_int hhpori_(SET, const double *t3, tess_int *i, tess_int *j, tess_int *k,
                 tess_int *l);
tess_int hhpins_(SET, const double *t3, const double *t5, const tess_int *v,
                 tess_int *a, tess_int *b, tess_int *rule);
void hhcent_(CALLERS, tess_int *e, const tess_int *v, tess_int *base,
             tess_int *z, double *c, double *t, tess_int *ok);
void hhtria_(CALLERS, const double *t, tess_int *z, tess_int *side,
             tess_int *power);
void hhsurf_(const double *x, tess_int *base, tess_int *from, tess_int *plane,
             const double *c, double *s, tess_int *ok);
void hhheig_(const double *x, const double *s, tess_int *z, double *h,
             double *err);
void hhrela_(const double *x, const double *t3, const tess_int *v,
             tess_int *base, const double *f, double *l, tess_int *a,
             tess_int *z, double *s, tess_int *sign);
void hhthin_(SET, tess_int *e, const tess_int *v, tess_int *base, double *f,
             tess_int *ok);

#ifdef __cplusplus
}
#endif

#undef POINTS
#undef MESH
#undef SPACE
#undef INFO
#undef CALLERS
#undef SET

#endif
