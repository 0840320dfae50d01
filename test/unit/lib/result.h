/* result.h - what the tests of tess.c share: faults; points of a family, arrays
 * for their result between guards, and what is right of it. */
#ifndef RESULT_H
#define RESULT_H

#include "../../../tess.h"

typedef struct result {
    const char *family;
    unsigned long seed;
    tess_int n, maxtet, ntet, liw, lrw;
    tess_real *p;
    tess_int *tet, *adj, *iw;
    double *rw;
    int code;
} result;

/* quick: fewer and smaller tests.  The faults of a test, of which SHOWN are
 * described, and what they are about: a result, or a name. */
#define SHOWN 5
extern int quick;
extern long faults;
extern const result *current;
extern const char *now;

/* A fault; one unless it holds; the end of a test of a family. */
void fail(const char *what);
void require(int holds, const char *what);
void done(const char *what, const char *family);
/* The points of a family; 0 when there is none of that size. */
int points(result *r, const char *family, long n, unsigned long seed);
/* Arrays for so many tetrahedra, as tess_size says; tess; tess_resume. */
void room(result *r, tess_int maxtet);
void run(result *r);
void resume(result *r);
/* Have both the same tetrahedra, in the same order? */
int same(const result *a, const result *b);
/* Free the arrays made since there were keep of them, and go on in new ones
 * that hold the tetrahedra; iw and rw hold rubbish. */
void grow(result *r, int keep, tess_int maxtet, tess_int liw);
/* The whole result, in arrays that it fills exactly.  What it takes is found
 * by resuming, and the run with that room must give the same. */
void solve(result *r);
/* Point i in doubles; eight are held at a time. */
const double *at(const result *r, tess_int i);
int orient(const result *r, tess_int a, tess_int b, tess_int c, tess_int d);
/* The vertices of facet k of tetrahedron t, seen counter-clockwise from
 * outside. */
void facet(const result *r, tess_int t, int k, tess_int *v);
/* The place of vertex i among the four v, or 4. */
int slot_of(const tess_int *v, tess_int i);
/* Its iw says of each point the first one of its coordinates. */
void twins(const result *r);
/* What tess_check says. */
int checked(const result *r);
/* All of it; r is solved. */
void right(const result *r);
/* How many points of a family a test can afford: fewer where the result is
 * quadratic in n, where exact numbers are long, and where very many points
 * are so near to one sphere or plane that the search is slow. */
long affordable(const char *family, long n);
/* The largest tess_int. */
tess_int largest(void);
/* The least length of iw (rw: which = 1) that tess and tess_resume accept. */
tess_int least(const result *like, int which);
double infinity(void);
/* Is r a beginning of the whole: its tetrahedra, and adj but for facets that
 * are open yet? */
int beginning(const result *r, const result *whole);
/* For qsort: four vertices. */
int by_four(const void *a, const void *b);
/* adj from tet, by sorting the facets. */
void link_up(result *r);
/* A complex given by its points and tetrahedra, which are turned to be
 * positive. */
void given(result *r, const char *name, const double *p, tess_int n,
           const tess_int *tet, tess_int ntet);

#endif
