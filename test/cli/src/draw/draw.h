/* draw.h - pictures of tetrahedra, of points, and of values in a plane, as SVG
 * files, with axes.
 *
 * Tetrahedra are seen from afar (parallel projection), painted from back to
 * front, lit from the upper left.  Colours are bands of a value that is linear
 * on each tetrahedron, so their borders are exact contours.  There is no
 * background, and what is written is grey: so it does on a white page and on a
 * dark one.
 */
#ifndef DRAW_H
#define DRAW_H

#include <stdio.h>

#include "../../../../tess.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is drawn: points alone; all tetrahedra; without the quarter that faces
 * the viewer; that without the tetrahedra's edges; each shrunk towards its
 * centroid, which is an exploded view: to move tetrahedra apart and then zoom
 * out. */
enum { DRAW_POINTS, DRAW_WHOLE, DRAW_CUT, DRAW_FIELD, DRAW_APART };

/* Texts are as they are read: UTF-8, else taken for Latin-1. */
typedef struct draw_look {
    int width, height; /* pixels; a height of 0: as much as is needed */
    int what;          /* DRAW_... */
    double azimuth;    /* where the viewer is, in degrees: from x towards y, */
    double elevation;  /* and above the plane of x and y */
    double scale[3];   /* coordinates are drawn times that; below 0 an axis is
                        * drawn backwards, as depth is */
    int bare;          /* 1: no axes, colour bar, and texts */
    const char *title, *note; /* above, below; these and label may be 0 */
    const char *name[3];      /* of the axes */
    const char *label;        /* of the colour bar, */
    double range[2];          /* and its ends; the same twice: the values' */
} draw_look;

/* draw_default - a look for points that one knows nothing about. */
void draw_default(draw_look *look);

/* draw_even - stretch, by look->scale, sides of these lengths that would be
 * drawn shorter than the longest over most, and add to the text note that they
 * are.  A length of 0 is none. */
void draw_even(draw_look *look, const double *length, double most, char *note);

/* draw_svg - draw a result of tess.
 *
 *   value   one a point, of at most 1e300, or a NaN, which is grey; or 0:
 *           there is then no colour bar; what is moved apart has the distance
 *           from the middle for a colour, all else one
 *   keep    keep[t] = 0: leave out tetrahedron t; or 0
 *
 * returns 0, or 1 when there is not enough memory.  Errors in writing: see
 * ferror. */
int draw_svg(FILE *file, const draw_look *look, tess_int n,
             const tess_real *p, const double *value, tess_int ntet,
             const tess_int *tet, const tess_int *adj, const char *keep);

/* draw_slice - draw values at the places of a plane grid, in bands of colour,
 * whose borders are contours, linear between neighbouring places.
 *
 *   axis    which of x, y, z goes to the right, up, and to the viewer
 *   many    places to the right, and up: at least 2
 *   box     the grid's x, from and to; y; z: the plane's place, twice
 *   value   many[0] * many[1], along axis[0] first; where NaN nothing is drawn
 *   range   the least and the most of them that matter; the reverse if none
 *   ntet... nothing is drawn outside of these tetrahedra; or ntet = 0
 *
 * returns as draw_svg. */
int draw_slice(FILE *file, const draw_look *look, const int *axis,
               const int *many, const double *box, const double *value,
               const double *range, const tess_real *p, tess_int ntet,
               const tess_int *tet, const tess_int *adj, const char *keep);

#ifdef __cplusplus
}
#endif

#endif
