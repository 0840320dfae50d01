/* draw.h - a picture of tetrahedra, as an SVG file.
 *
 * Seen from afar (parallel projection), painted from back to front, lit from
 * the upper left.  Colours are bands of a value that is linear on each
 * tetrahedron, so their borders are exact contours.
 */
#ifndef DRAW_H
#define DRAW_H

#include <stdio.h>

#include "../../tess.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct draw_look {
    int width, height; /* pixels */
    double azimuth;    /* where the viewer is, in degrees: from x towards y, */
    double elevation;  /* and above the plane of x and y */
    double shrink;     /* each tetrahedron towards its centroid: 1 leaves it.
                        * Less shows an exploded view: to move tetrahedra
                        * apart and then zoom out is to shrink each of them */
    int cut;           /* 1: leave out the quarter that faces the viewer */
    const char *keep;  /* keep[t] = 0: leave out tetrahedron t; or 0 */
    const char *note;  /* a text below, in XML */
    const char *label; /* of the colour bar */
} draw_look;

/* draw_default - a look for points that one knows nothing about. */
void draw_default(draw_look *look);

/* draw_svg - draw a result of tess.
 *
 *   value   one a point, or 0: the colour is then the distance from the
 *           middle, and there is no colour bar
 *
 * returns 0, or 1 when there is not enough memory.  Errors in writing: see
 * ferror. */
int draw_svg(FILE *file, const draw_look *look, tess_int n,
             const tess_real *p, const double *value, tess_int ntet,
             const tess_int *tet, const tess_int *adj);

/* draw_slice - draw values at the places of a plane grid, in bands of colour.
 *
 *   across, up  its places: the first at the lower left, then to the right
 *   wide    width by height
 *   value   across * up; where NaN nothing is drawn
 */
void draw_slice(FILE *file, const draw_look *look, int across, int up,
                double wide, const double *value);

#ifdef __cplusplus
}
#endif

#endif
