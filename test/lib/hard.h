/* hard.h - sets of points that are hard to get right: coordinates of any
 * exponent side by side, subnormals, ties, near-ties, duplicates.
 *
 * Reproducible: all is drawn from exact.c's rnd_*.  With TESS_FLOAT the
 * exponents are those of float; the coordinates are finite tess_reals.
 */
#ifndef HARD_H
#define HARD_H

/* One coordinate. */
double hard_value(void);
/* x moved by some last places of its own, down to subnormals */
double hard_nudge(double x, int places);
/* Few points, at most 11; returns how many. */
int hard_few(double (*p)[3]);
/* 60 ... most points: clusters of very different sizes, some of them far from
 * the origin in view of their size, boxes without width, or about as wide
 * as squares and cubes of coordinates begin to underflow. */
int hard_many(double (*p)[3], int most);
/* 12 ... most points near one to three planes and spheres, off them by nothing
 * or by 1e-16 to 1e-8, far from the origin or near to it, of any scale; some
 * somewhere else, some on others but for last places, in rows or clusters. */
int hard_near(double (*p)[3], int most);
/* 12 ... most points on the faces of a convex polyhedron, some of them inside,
 * as samplers write them: turned, of any size, rounded to 1 to 8 decimals or
 * not; some on others or but for last places. */
int hard_faces(double (*p)[3], int most);
/* 500 ... most points on 11 to 14 vertical lines, in order: all lines but the
 * last, which is far from the others, in a small part of space.  *line is how
 * many a line has. */
int hard_lines(double (*p)[3], int most, int *line);

#endif
