/* recipes.h - prototypes of the recipes: C files of this name say what they do.
 * For the recipes and for programs that are linked from them; take of it what
 * you need.
 *
 * All names begin with tr_, those of macros with TR_.  With other types than
 * the default ones (see hhpred.h) the routines' names are others, so that what
 * is compiled differently does not link; they are macros then, so include this
 * file behind those of C++.
 */
#ifndef TR_RECIPES_H
#define TR_RECIPES_H

#include <stdio.h>

#include "tess.h"

#ifdef TESS_OTHER
#define tr_slopes TESS_AS(tr_slopes)
#define tr_bent TESS_AS(tr_bent)
#define tr_natural TESS_AS(tr_natural)
#define tr_blend TESS_AS(tr_blend)
#define tr_edges TESS_AS(tr_edges)
#define tr_faces TESS_AS(tr_faces)
#define tr_stars TESS_AS(tr_stars)
#define tr_nearest TESS_AS(tr_nearest)
#define tr_measure TESS_AS(tr_measure)
#define tr_dual TESS_AS(tr_dual)
#define tr_gradient TESS_AS(tr_gradient)
#define tr_cell TESS_AS(tr_cell)
#define tr_clipped TESS_AS(tr_clipped)
#define tr_alpha TESS_AS(tr_alpha)
#define tr_ongrid TESS_AS(tr_ongrid)
#define tr_iso TESS_AS(tr_iso)
#define tr_keep TESS_AS(tr_keep)
#define tr_append TESS_AS(tr_append)
#define tr_join TESS_AS(tr_join)
#define tr_many TESS_AS(tr_many)
#define tr_average TESS_AS(tr_average)
#define tr_unpack TESS_AS(tr_unpack)
#define tr_triclinic TESS_AS(tr_triclinic)
#define tr_periodic TESS_AS(tr_periodic)
#define tr_reduce TESS_AS(tr_reduce)
#define tr_planar TESS_AS(tr_planar)
#define tr_enclosed TESS_AS(tr_enclosed)
#define tr_obj TESS_AS(tr_obj)
#define tr_stl TESS_AS(tr_stl)
#endif

#ifdef __cplusplus
extern "C" {
#endif

int tr_slopes(tess_int n, const tess_real *p, tess_int ntet,
              const tess_int *tet, const tess_int *adj, const double *value,
              int rounds, double *g, double *work);
int tr_bent(const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, const double *value, const double *g,
            double beyond, const tess_real *q, tess_int *t, double *f);
int tr_natural(const tess_real *p, tess_int ntet, const tess_int *tet,
               const tess_int *adj, const tess_real *q, tess_int *t,
               tess_int most, tess_int *nn, tess_int *nbr, double *sibson,
               double *laplace, tess_int *iw, double *rw);
double tr_blend(const tess_real *p, tess_int nn, const tess_int *nbr,
                const double *w, const double *value, const double *g);
int tr_edges(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxedg, tess_int *nedge, tess_int *edge, tess_int *at);
int tr_faces(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxfac, tess_int *nface, tess_int *face, tess_int *both);
void tr_stars(tess_int n, tess_int ntet, const tess_int *tet, tess_int *first,
              tess_int *list);
tess_int tr_nearest(const tess_real *p, const tess_int *tet,
                    const tess_int *first, const tess_int *list,
                    const tess_real *q, tess_int v);
void tr_measure(const tess_real *p, const tess_int *v, double *volume,
                double *middle, double *radius);
void tr_dual(tess_int n, const tess_real *p, const tess_int *tet,
             const tess_int *adj, tess_int nedge, const tess_int *edge,
             const tess_int *at, double *area, double *cell, tess_int *outer);
void tr_gradient(const tess_real *p, const tess_int *v, const double *value,
                 double *g);

/* cells.c */
int tr_cell(const tess_real *p, const tess_int *tet, const tess_int *adj,
            const tess_int *first, const tess_int *list, tess_int i,
            const double *box, tess_int most, tess_int *nface, tess_int *whose,
            double *area, double *volume, tess_int *start, tess_int *corner,
            tess_int *nvert, double *vert, tess_int *iwork, double *work);
int tr_clipped(tess_int n, const tess_real *p, const tess_int *tet,
               const tess_int *adj, const tess_int *first, const tess_int *list,
               const double *box, tess_int maxrow, tess_int *nrow,
               tess_int *row, tess_int *other, double *area, double *volume,
               tess_int most, tess_int *iwork, double *work);
int tr_alpha(const tess_real *p, tess_int ntet, const tess_int *tet,
             const tess_int *adj, double radius, int voids, char *keep,
             tess_int maxfac, tess_int *nfac, tess_int *fac, tess_int *stack);

/* interp.c */
int tr_ongrid(const tess_real *p, tess_int ntet, const tess_int *tet,
              const tess_int *adj, tess_int nv, const double *value,
              const tess_int *size, const double *box, double outside,
              tess_int *t, tess_real *q, double *out);

/* iso.c */
int tr_iso(const tess_real *p, tess_int ntet, const tess_int *tet,
           const tess_int *adj, const double *value, double level, int closed,
           tess_int maxpt, tess_int *npt, tess_real *x, tess_int *ends,
           tess_int maxtri, tess_int *ntri, tess_int *tri, tess_int *iwork);

/* join.c */
tess_int tr_keep(tess_int ntet, const tess_int *tet, const tess_int *mine,
                 tess_int *becomes);
void tr_append(tess_int ntet, const tess_int *tet, const tess_int *adj,
               const tess_int *becomes, tess_int base, tess_int *all,
               tess_int *alladj);
int tr_join(tess_int ntet, const tess_int *tet, tess_int *adj, tess_int lh,
            tess_int *h);

/* many.c */
#define TR_LINEAR 0
#define TR_SMOOTH 1
#define TR_NATURAL 2
#define TR_NEAREST 3
int tr_many(tess_int n, const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, int method, tess_int nv, const double *value,
            const double *g, const tess_int *first, const tess_int *list,
            tess_int nq, const tess_real *q, tess_int *t, double *w,
            double *out, tess_int most, tess_int *iw, double *rw);
void tr_average(tess_int n, const tess_int *same, tess_int nv, double *value,
                double *times);

/* periodic.c */
#define TR_FEW 20 /* a code: tetrahedra reach too far */
void tr_unpack(tess_int number, int *copy);
int tr_triclinic(tess_int n, const tess_real *p, const double *cell,
                 const tess_int *ways, tess_int maxcop, tess_int *ncop,
                 tess_real *x, tess_int *cw, tess_int maxtet, tess_int *ntet,
                 tess_int *tet, tess_int *move, tess_int *adj, tess_int *shift,
                 tess_int liw, tess_int *iw, tess_int lrw, double *rw);
int tr_periodic(tess_int n, const tess_real *p, const double *box,
                tess_int maxcop, tess_int *ncop, tess_real *x, tess_int *cw,
                tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *move,
                tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
                tess_int lrw, double *rw);
void tr_reduce(double *cell, const tess_int *ways);

/* planar.c */
int tr_planar(tess_int n, tess_real *p, tess_int maxtri, tess_int *ntri,
              tess_int *triangle, tess_int *beside, tess_int liw, tess_int *iw,
              tess_int lrw, double *rw);

/* surface.c */
double tr_enclosed(const tess_real *p, tess_int nfac, const tess_int *fac);
int tr_obj(FILE *file, tess_int n, const tess_real *p, tess_int nfac,
           const tess_int *fac, int digits, tess_int *number);
int tr_stl(FILE *file, const tess_real *p, tess_int nfac, const tess_int *fac,
           int digits);

#ifdef __cplusplus
}
#endif

#endif
