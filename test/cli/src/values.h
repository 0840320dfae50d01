/* values.h - the values of a field at any places, by four methods (values.c);
 * and what errors they have, by cross-validation (validate.c). */
#ifndef VALUES_H
#define VALUES_H

#include "driver.h"

/* field - points with values, and their mesh. */
typedef struct field {
    const tess_real *p;
    tess_int n, ntet;
    const tess_int *tet, *adj;
    const char *keep;    /* where keep[t] = 0 counts as outside; or 0 */
    const double *value; /* columns a point, row by row */
    int columns;
    int flat; /* as of a mesh */
    double within; /* a place farther from all points has no value; 0: any */
} field;

/* The methods.  Smooth: by gradients at the points; natural: Sibson's natural
 * neighbours; nearest: of the points. */
#define LINEAR 0
#define SMOOTH 1
#define NATURAL 2
#define NEAREST 3
#define METHODS 4

#define ROUNDS 3 /* of slopes, for SMOOTH */

/* What a place outside is given. */
#define OUT_VALUE 0   /* a number that is given, or NaN               */
#define OUT_NEAREST 1 /* what the hull's point nearest to it is given */

extern const char *const method_name[METHODS];

/* values_begin - make ready to interpolate the field, which must stay as it
 * is.  number: for places outside, by OUT_VALUE.  Leaves the program when there
 * is not enough memory. */
void values_begin(const field *of, int method, int outside, double number);

/* values_at - the values at many places.
 *
 *   many, q  (in)      the places: 3 coordinates each, finite
 *   t        (in,out)  as in tess_values: where walks start; on return the
 *                      tetrahedra, -2 - t for a place outside
 *   out      (out)     columns a place
 */
void values_at(tess_int many, const tess_real *q, tess_int *t, double *out);

/* values_start - where the walk to place q may start: its tetrahedron, or one
 * near to it; found from another one, or from TESS_NONE. */
tess_int values_start(const tess_real *q, tess_int start);

/* values_end - give back the memory. */
void values_end(void);

/* cross_validate - deal the points to folds by chance, the same on every
 * machine; or, by -by, groups of them.  Leave out one fold after the other: the
 * mesh of the others predicts its values by each method.  Print a table of the
 * errors, and write them, by -errors.
 *
 *   m        the points, and arrays for the others' mesh: what m holds is lost
 *   same     same[i] is the point that stands for i; no other one counts
 *   value    columns a point
 *   asked    asked[k] != 0 for the methods k
 *   beyond   OUT_NEAREST: points outside the hull of the others count as well
 */
void cross_validate(mesh *m, const tess_int *same, const double *value,
                    long folds, const int *asked, int beyond);

#endif
