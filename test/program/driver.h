/* driver.h - what the two files of the command line program share. */
#ifndef DRIVER_H
#define DRIVER_H

#include "../../tess.h"

#define NAME 1024   /* longest file name made from -o            */
#define COLUMNS 512 /* most columns of a line                    */
#define TITLE 40    /* characters of a column's name that matter */

/* points - what a file holds.  The arrays are the driver's. */
typedef struct points {
    const char *input; /* the file's name */
    long room, values; /* points that p, values that value has room for */
    tess_real *p;
    double *value; /* columns of them a point, row by row */
    long *line;    /* of the file, for each point */
    tess_int n;
    int columns;              /* values a point */
    char name[COLUMNS][TITLE]; /* of the values */
    int marker;               /* 1: the last value is a .node file's marker */
    tess_int base;            /* number of the first point in files */
    const char *cols; /* columns asked for, x, y, z first; 0: by the file */
    int skip;         /* drop rows from which numbers are missing */
} points;

/* read_points - read the file into *a; leaves the program with a message when
 * it cannot.  name: 0 or "-" for standard input. */
void read_points(const char *name, points *a);

/* fail - print a message on stderr, and leave: the usage, the input or an
 * output is bad. */
void fail(const char *format, ...);

/* too_small - the same: this build's arrays do not suffice. */
void too_small(const char *format, ...);

/* warn - print a message on stderr, unless the program is to be quiet. */
void warn(const char *format, ...);

/* say - tell on stderr what a long run is doing: when there are many points,
 * or the program has run for a second or two. */
void say(const char *format, ...);

#endif
