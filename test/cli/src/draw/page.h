/* page.h - what draw.c's and slice.c's pictures share: a picture at work, its
 * paths, colours, and what is around it. */
#ifndef PAGE_H
#define PAGE_H

#include "draw.h"

#ifdef __cplusplus
extern "C" {
#endif

#define DEGREE 0.017453292519943295

/* A corner of a polygon: x to the right, y up, z to the viewer, value. */
enum { X, Y, Z, V, DIM };

typedef struct drawing {
    FILE *file;
    const draw_look *look;
    double *q;            /* DIM a point: what a corner has */
    const tess_int *tet, *adj;
    tess_int n, ntet;
    const char *keep;
    int plain;            /* no values */
    double turn[3][3];    /* from coordinates to X, Y, Z: rows; */
    int height;           /* of the picture */
    double most, middle[3], side[3], /* what is done to them before; */
        factor[3], hand;  /* -1: that makes left hands of right ones */
    double left, top;     /* of what is drawn, in the units of q */
    double unit;          /* tenths of a pixel a unit of q */
    double shift[2];      /* tenths of a pixel */
    double low, step;     /* band k: low + k * step ... */
    int bands, lost; /* is there a value that is no number?  Band bands */
    int letter, band;     /* style of the path that is being written; of its */
    int corners;          /* outline so many, the last one here, and the line */
    long at[2], line[2];  /* that leads there, not yet written */
    double plane[2][DIM]; /* the cut leaves out where both are positive */
} drawing;

/* page_begin - a drawing of these tetrahedra, with nothing in it yet.
 * page_end - the colour bar, whose bands are those of the picture, and the
 * file's end. */
void page_begin(drawing *d, FILE *file, const draw_look *look, tess_int ntet,
                const tess_int *tet, const tess_int *adj, const char *keep);
void page_end(const drawing *d);

/* page_corner - of an outline, in tenths of pixels, of which whole ones are
 * written: as SVG path data, the first corner absolute, the others relative to
 * the one before.  Corners that fall together, or into a line, are left out. */
void page_corner(drawing *d, double x, double y);

/* page_close - close the outline, and begin another one. */
void page_close(drawing *d);

/* page_across, page_down - where in the picture: tenths of pixels. */
double page_across(const drawing *d, double x);
double page_down(const drawing *d, double y);

/* page_bands - choose the bands, of values from low to high, with round
 * borders. */
void page_bands(drawing *d, double low, double high);

/* page_place - choose the unit and place of a drawing of that width and
 * height. */
void page_place(drawing *d, double width, double height);

/* page_share - band k among all, 0 ... 1; less where there are no values, more
 * for no number. */
double page_share(const drawing *d, int k);

/* page_hex - write colour x, 0 ... 1, in that shade. */
void page_hex(FILE *file, double x, double shade);

/* page_head - the start of the file: title and note. */
void page_head(const drawing *d);

/* page_axes - begin the group of the axes; page_axis - from a point of the
 * picture to another one, for numbers from low to high, with ticks and texts in
 * the direction out. */
void page_axes(const drawing *d);
void page_axis(const drawing *d, const double *from, const double *to,
               double low, double high, const double *out, const char *name);

/* of draw.c: is tetrahedron t there, and not left out?  The facet opposite to
 * vertex k, counter-clockwise from outside. */
int draw_kept(const drawing *d, tess_int t);
extern const int draw_facet[4][3];

#ifdef __cplusplus
}
#endif

#endif
