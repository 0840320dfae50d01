/* whole.h - what the tests of indices, parts and queries share: a set of points,
 * its mesh and its index. */
#ifndef WHOLE_H
#define WHOLE_H

#include "result.h"

typedef struct whole {
    tess_int n, ntet, liw, lrw, hull;
    tess_real *p;
    tess_int *tet, *adj, *rep; /* as tess gave them */
    tess_int *set;             /* the tetrahedra as a sorted set */
    tess_int *first, *at;      /* at point i: at[first[i] ...], of set */
    tess_int *iw;              /* the index */
    double *rw;
    int code;
} whole;

/* Free the arrays made since there were so many of them. */
void drop(int many);
/* n elements, in a new array. */
tess_int *copy(const tess_int *a, tess_int n);
/* A new array of that length that begins as an index does. */
tess_int *begun(const tess_int *a, tess_int used, tess_int length);
/* The tetrahedra as a sorted set. */
tess_int *as_set(tess_int ntet, const tess_int *tet);
/* The number in the set of the tetrahedron v, or -1. */
tess_int number(const whole *m, const tess_int *v);
/* adj is mutual across facets of the same vertices; returns the number of
 * facets on the hull. */
tess_int linked(tess_int ntet, const tess_int *tet, const tess_int *adj);
/* The mesh and the index of m->n points m->p. */
void complete(whole *m);
/* The points of a family, or, if turned is 1, the same turned and moved, or, if
 * it is 2, half of them, each twice; 0 for none. */
int family(whole *m, const char *name, long n, unsigned long seed,
           int turned);
/* Fewer points where the result is quadratic in n, where exact numbers are
 * long, and where very many points are near one sphere or plane. */
long fewer(const char *name, long n);
/* part[i] = the one of many parts that point i is in. */
void divide(const whole *m, int kind, tess_int many, tess_int *part);
/* One part, its arrays of the length that is needed, but for an iw of length
 * liw, or 0 for m's; all must be right. */
tess_int one_part(const whole *m, const tess_int *mine, tess_int liw,
                  tess_int *iw, tess_int **tet, tess_int **adj);

#endif
