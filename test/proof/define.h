/* define.h - the Delaunay tetrahedralization of a few points, by its definition.
 *
 * Of all the quadruples of distinct points, those with no fifth point in
 * their ball, after the lifted heights are lowered by e_0 >> e_1 >> ... in
 * the order of the indices.  All in the exact integers of exact.c; ties are
 * left to ex_perturbed, which knows no rule for them.  Any finite coordinates.
 */
#ifndef DEFINE_H
#define DEFINE_H

#include "../../tess.h"

#define DEF_MOST 12 /* points */

/* What tess is expected to give. */
typedef struct truth {
    int n;
    int code;
    int twin[DEF_MOST];      /* the point that stands for each */
    int count;               /* tetrahedra */
    char is_tet[DEF_MOST][DEF_MOST][DEF_MOST][DEF_MOST]; /* i < j < k < l */
} truth;

void define(truth *d, int n, double (*p)[3]);

/* differs - what is wrong with a result, in words, or NULL: the code, iw, the
 * set of tetrahedra, their orientation, adj. */
const char *differs(const truth *d, double (*p)[3], int code, tess_int ntet,
                    const tess_int *tet, const tess_int *adj,
                    const tess_int *iw);

#endif
