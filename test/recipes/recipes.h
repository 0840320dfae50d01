/* recipes.h - prototypes of the recipes: C files of this name say what they do.
 * For the recipes and for programs that are linked from them; take of it what
 * you need.
 *
 * A name that is taken in your program, such as join: compile all files with
 * -Djoin=my_join.  With other types than the default ones (see hhpred.h) the
 * names are others, so that what is compiled differently does not link; they
 * are macros then, so include this file behind those of C++.
 */
#ifndef RECIPES_H
#define RECIPES_H

#include <stdio.h>

#include "tess.h"

#ifdef TESS_OTHER
#define slopes TESS_AS(slopes)
#define bent TESS_AS(bent)
#define natural TESS_AS(natural)
#define blend TESS_AS(blend)
#define edges TESS_AS(edges)
#define faces TESS_AS(faces)
#define stars TESS_AS(stars)
#define nearest TESS_AS(nearest)
#define measure TESS_AS(measure)
#define dual TESS_AS(dual)
#define gradient TESS_AS(gradient)
#define cell TESS_AS(cell)
#define clipped TESS_AS(clipped)
#define alpha TESS_AS(alpha)
#define ongrid TESS_AS(ongrid)
#define iso TESS_AS(iso)
#define keep TESS_AS(keep)
#define append TESS_AS(append)
#define join TESS_AS(join)
#define many TESS_AS(many)
#define means TESS_AS(means)
#define unpack TESS_AS(unpack)
#define triclinic TESS_AS(triclinic)
#define periodic TESS_AS(periodic)
#define reduce TESS_AS(reduce)
#define planar TESS_AS(planar)
#define enclosed TESS_AS(enclosed)
#define putobj TESS_AS(putobj)
#define putstl TESS_AS(putstl)
#endif

#ifdef __cplusplus
extern "C" {
#endif

int slopes(tess_int n, const tess_real *p, tess_int ntet, const tess_int *tet,
           const tess_int *adj, const double *value, int rounds, double *g,
           double *work);
int bent(const tess_real *p, tess_int ntet, const tess_int *tet,
         const tess_int *adj, const double *value, const double *g,
         double beyond, const tess_real *q, tess_int *t, double *f);
int natural(const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, const tess_real *q, tess_int *t,
            tess_int most, tess_int *nn, tess_int *nbr, double *sibson,
            double *laplace, tess_int *iw, double *rw);
double blend(const tess_real *p, tess_int nn, const tess_int *nbr,
             const double *w, const double *value, const double *g);
int edges(tess_int ntet, const tess_int *tet, const tess_int *adj,
          tess_int maxedg, tess_int *nedge, tess_int *edge, tess_int *at);
int faces(tess_int ntet, const tess_int *tet, const tess_int *adj,
          tess_int maxfac, tess_int *nface, tess_int *face, tess_int *both);
void stars(tess_int n, tess_int ntet, const tess_int *tet, tess_int *first,
           tess_int *list);
tess_int nearest(const tess_real *p, const tess_int *tet,
                 const tess_int *first, const tess_int *list,
                 const tess_real *q, tess_int v);
void measure(const tess_real *p, const tess_int *v, double *volume,
             double *middle, double *radius);
void dual(tess_int n, const tess_real *p, const tess_int *tet,
          const tess_int *adj, tess_int nedge, const tess_int *edge,
          const tess_int *at, double *area, double *cell, tess_int *outer);
void gradient(const tess_real *p, const tess_int *v, const double *value,
              double *g);

/* cells.c */
int cell(const tess_real *p, const tess_int *tet, const tess_int *adj,
         const tess_int *first, const tess_int *list, tess_int i,
         const double *box, tess_int most, tess_int *nface, tess_int *whose,
         double *area, double *volume, tess_int *start, tess_int *corner,
         tess_int *nvert, double *vert, tess_int *iwork, double *work);
int clipped(tess_int n, const tess_real *p, const tess_int *tet,
            const tess_int *adj, const tess_int *first, const tess_int *list,
            const double *box, tess_int maxrow, tess_int *nrow, tess_int *row,
            tess_int *other, double *area, double *volume, tess_int most,
            tess_int *iwork, double *work);
int alpha(const tess_real *p, tess_int ntet, const tess_int *tet,
          const tess_int *adj, double radius, int voids, char *keep,
          tess_int maxfac, tess_int *nfac, tess_int *fac, tess_int *stack);

/* interp.c */
int ongrid(const tess_real *p, tess_int ntet, const tess_int *tet,
           const tess_int *adj, tess_int nv, const double *value,
           const tess_int *size, const double *box, double outside,
           tess_int *t, tess_real *q, double *out);

/* iso.c */
int iso(const tess_real *p, tess_int ntet, const tess_int *tet,
        const tess_int *adj, const double *value, double level, int closed,
        tess_int maxpt, tess_int *npt, tess_real *x, tess_int *ends,
        tess_int maxtri, tess_int *ntri, tess_int *tri, tess_int *iwork);

/* join.c */
tess_int keep(tess_int ntet, const tess_int *tet, const tess_int *mine,
              tess_int *becomes);
void append(tess_int ntet, const tess_int *tet, const tess_int *adj,
            const tess_int *becomes, tess_int base, tess_int *all,
            tess_int *alladj);
int join(tess_int ntet, const tess_int *tet, tess_int *adj, tess_int lh,
         tess_int *h);

/* many.c */
#define MANY_LINEAR 0
#define MANY_SMOOTH 1
#define MANY_NATURAL 2
#define MANY_NEAREST 3
int many(tess_int n, const tess_real *p, tess_int ntet, const tess_int *tet,
         const tess_int *adj, int method, tess_int nv, const double *value,
         const double *g, const tess_int *first, const tess_int *list,
         tess_int nq, const tess_real *q, tess_int *t, double *w, double *out,
         tess_int most, tess_int *iw, double *rw);
void means(tess_int n, const tess_int *same, tess_int nv, double *value,
           double *times);

/* periodic.c */
#define PERIODIC_FEW 20 /* a code: tetrahedra reach too far */
void unpack(tess_int number, int *copy);
int triclinic(tess_int n, const tess_real *p, const double *cell,
              const tess_int *ways, tess_int maxcop, tess_int *ncop,
              tess_real *x, tess_int *cw, tess_int maxtet, tess_int *ntet,
              tess_int *tet, tess_int *move, tess_int *adj, tess_int *shift,
              tess_int liw, tess_int *iw, tess_int lrw, double *rw);
int periodic(tess_int n, const tess_real *p, const double *box,
             tess_int maxcop, tess_int *ncop, tess_real *x, tess_int *cw,
             tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *move,
             tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
             tess_int lrw, double *rw);
void reduce(double *cell, const tess_int *ways);

/* planar.c */
int planar(tess_int n, tess_real *p, tess_int maxtri, tess_int *ntri,
           tess_int *triangle, tess_int *beside, tess_int liw, tess_int *iw,
           tess_int lrw, double *rw);

/* surface.c */
double enclosed(const tess_real *p, tess_int nfac, const tess_int *fac);
int putobj(FILE *file, tess_int n, const tess_real *p, tess_int nfac,
           const tess_int *fac, int digits, tess_int *number);
int putstl(FILE *file, const tess_real *p, tess_int nfac, const tess_int *fac,
           int digits);

#ifdef __cplusplus
}
#endif

#endif
