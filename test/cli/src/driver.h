/* driver.h - what the files of the command line program share.
 *
 *   options.c   the command line                   read.h    points
 *   driver.c    the arrays, the mesh, messages     write.c   files
 *   shapes.c    cells                              draw.c    pictures
 *   alpha.c     alpha shapes                       level.c   equal values
 *   values.c    interpolation                      places.c  where, into files
 *   validate.c  its errors                         plane.c   in a plane
 *   repeat.c    cells that repeat themselves       slice.c   of values there
 *   page.c      what pictures share            classes.c words as values
 */
#ifndef DRIVER_H
#define DRIVER_H

#include <stdio.h>

#include "../../../tess.h"

#define COLUMNS 512 /* most columns of a line                    */
#define VOIDS 16    /* most values of -nodata                    */
#define LEVELS 64   /* most levels of an -iso                    */
#define TITLE 40    /* characters of a column's name that matter */
#define LONGER 4.0   /* pictures stretch sides that the longest is so often; */
#define LONGEST 20.0 /* by -scale those that would hardly be seen           */

/* ---- what is read ---- */

typedef struct classes classes;

/* points - what a file holds. */
typedef struct points {
    const char *input;   /* the file's name */
    double room, values; /* points that p, values that value has room for */
    tess_real *p;
    double *value; /* columns of them a point, row by row */
    long *line;    /* of the file, for each point */
    tess_int n;
    int columns;              /* values a point */
    char name[COLUMNS][TITLE]; /* of the values */
    char axis[3][TITLE];       /* of the coordinates */
    classes *words[COLUMNS];  /* of a value that is a word, or 0 */
    int classed;              /* may values be words? */
    int marker;               /* 1: the last value is a .node file's marker */
    tess_int base;            /* number of the first point in files */
    int axes; /* coordinates, 3, or 2 in a plane; 0: what the file has */
    const char *cols; /* columns asked for, x, y, z first; 0: by the file */
    int skip;         /* drop rows from which numbers are missing */
    int decimal;      /* ',' where numbers have decimal commas */
    int voids;        /* values that stand for a missing one: so many, these */
    const double *nodata;
    int lattice;      /* has the file a box that may repeat itself? */
    double box[6];    /* that box, if along the axes: x from, to; y; z; */
    double cell[12];  /* any: its vectors, and a corner; */
    int ways[3];      /* and does it repeat itself along them? */
    int bare;         /* places, of which values do not matter: -qcols */
    double all;       /* so many; n of them at a time, by next_places, */
    FILE *scratch;    /* from a file of their own; or 0, and n are all */
    const char *by;   /* column that tells groups apart; 0: none */
    tess_int *group;  /* of each point, from 0 on; 0: none */
    int named;        /* keep the points' names, a column of words? */
    char labelled[TITLE]; /* the column's; "": there are none; they are */
    char *labels;         /* all here, */
    size_t *label;        /* each point's from there on */
    int surfaced;   /* keep the triangles of a surface? */
    double faces;   /* so many; their points, from 0 on; or 0: all in turn */
    tess_int *face;
    int doubted;    /* may some coordinates stand for none? */
    int copied;   /* keep the texts of columns that are nothing else? */
    char *others; /* their names, as CSV has them; 0: there are none. */
    FILE *texts;  /* Each point's, the same way, in a line */
} points;

/* What the lattice is: there is none; a box along the axes; any other. */
enum { NO_LATTICE, RIGHT, SKEW };

/* read_points - read the file into *a; leaves the program with a message when
 * it cannot.  name: 0 or "-" for standard input. */
void read_points(const char *name, points *a);

/* next_places - the next ones of bare points that have been read, or the first
 * ones, into a->p, a->n. */
void next_places(points *a, int first);

/* frequency - how often the numbers of a column are there: all that are finite;
 * how many of them are different; the one that is there most often, in so many
 * rows, and no other one in more than next; the least and the largest one. */
typedef struct frequency {
    long all, different, times, next;
    double most, low, high;
} frequency;

/* count_numbers - those of an axis, 0 to 2, or a value, from 3 on; but for so
 * many. */
void count_numbers(const points *of, int k, const double *but, int many,
                   frequency *found);

/* ---- what is made ---- */

/* mesh - the tetrahedralization.  It is of points that -scale stretches; all
 * that is written has the coordinates of in->p. */
typedef struct mesh {
    const points *in;
    double scale[3];    /* 1 if not given */
    const tess_real *p; /* in->p, times scale */
    tess_int ntet, *tet, *adj;
    tess_int maxtet;    /* tetrahedra that there is room for: tetrahedralize */
    int flat;           /* are p coordinates in a plane, by plane.c? */
    char *keep;         /* by -alpha: 0 for a tetrahedron that is left out; */
    tess_int kept;      /* 1 for so many; or 0, and ntet: all are in */
    tess_int liw, *iw;  /* its workspace; in iw which point stands for each, */
    tess_int lrw;       /* until keep_values and -check have used it */
    double *rw;
} mesh;

/* tetrahedralize - make the mesh of n points in m's arrays, which grow to what
 * it needs.  telling: say every second or so how far it is.  Returns the
 * code of tess that is left; leaves when there is not enough memory. */
int tetrahedralize(mesh *m, tess_int n, const tess_real *p, int telling);

/* tetrahedron_volume - in the coordinates given. */
double tetrahedron_volume(const mesh *m, tess_int t);

/* ---- what is asked for ---- */

/* output - a file to write. */
typedef struct output {
    const char *name;            /* "-": standard output */
    const struct form *all, *as; /* an option's forms; that of this file */
    char *partial; /* its name until it is complete; 0: it has no other one */
    int begun;     /* is that there? */
    FILE *file;    /* while it is open */
    double least;  /* bytes that are still to come, at least */
    int announced; /* has it been said that they are many? */
    const char *levels; /* of -iso */
} output;

/* form - of a file: what the ending of its name says.  A table of an option's
 * forms begins with the one for names that have none, and ends with 0. */
typedef struct form {
    const char *ending;
    void (*write)(const mesh *m, output *o); /* what -alpha leaves; 0 for what
                                              * needs the whole mesh */
} form;

extern const form values_forms[], errors_forms[], cells_forms[],
    volumes_forms[], faces_forms[], svg_forms[], face_forms[], iso_forms[];

/* next_output - the file behind o, or the first one if o = 0, in one of these
 * forms; in any if all = 0.  0 if there is none. */
output *next_output(const form *all, output *o);

/* choices - what the command line says; the table in options.c says of each
 * option where it goes.  Names of files are 0 if not given. */
typedef struct choices {
    const char *input, *cols;
    int skip, check, binary, quiet, periodic; /* (binary: so are all files) */
    int decimal; /* ',' or '.'; 0: not given */
    int limits;  /* is a value `<0.05' so many times its limit: */
    double below;
    int account; /* -account: of what is read, for tests */
    int voids;   /* numbers of nodata */
    double nodata[VOIDS];
    int plane;         /* have the points two coordinates? */
    int scaled, boxed; /* are these given?  (scaled: numbers of it) */
    int values, cells; /* -values; -cells, -volumes, -faces */
    int to_stdout;     /* is a file written to standard output? */
    double scale[3], box[6];
    double alpha;   /* largest circumradius that is kept; 0: any */
    int automatic;  /* is it the least one that leaves one piece? */
    double view[2]; /* azimuth and elevation; less than -360: not given */
    double pixels[2]; /* a picture's width and height; 0: not given */
    double range[2];  /* of its colours; the same twice: not given */
    const char *draw, *title, *unit;
    int bare; /* of a picture nothing but what is drawn */
    const char *query, *qcols, *grid, *method, *outside;
    double step[3], within; /* 0: not given; numbers of step: */
    int steps, drop;
    int digits;    /* 0: not given */
    long validate; /* folds; 0: not given */
    const char *by;
    int clip;
    int closed; /* by -iso-closed */
} choices;

extern choices chosen;

/* choose_options - read the command line into chosen; leaves the program with
 * a message when it cannot. */
void choose_options(int argc, char **argv);

/* space - room for so many things of that size, to be freed; leaves if there
 * is none.  more_space: for the array a, or 0, whose beginning is kept. */
void *space(double many, size_t size);
void *more_space(void *a, double many, size_t size);

/* list_numbers - the numbers in the text of that option, with commas between
 * them, written as in a file.  Returns how many, or -1 if they are more than
 * most; leaves for what is none. */
int list_numbers(const char *by, const char *text, int most, double *x);

/* ---- messages ---- */

/* fail - print a message on stderr, and leave: the usage, the input or an
 * output is bad. */
void fail(const char *format, ...);

/* too_small - the same: this build's integers do not suffice, or something
 * computed fails. */
void too_small(const char *format, ...);

/* warn - print a message on stderr: of the data, or of what was asked for, even
 * if the program is to be quiet. */
void warn(const char *format, ...);

/* tell - print what comes out, on stdout, or stderr if a file goes there;
 * unless the program is to be quiet. */
void tell(const char *format, ...);

/* say - tell on stderr what a long run is doing: when there are many points,
 * or the program has run for a second or two. */
void say(const char *format, ...);

/* progress - say on stderr how far is what takes longer than two seconds, later
 * ever more seldom.  total: 0 if not known, done then are bytes.  done = total:
 * it has ended. */
void progress(const char *what, double done, double total);

/* ---- files ---- */

/* ends_in - does the name, in small or capital letters? */
int ends_in(const char *name, const char *suffix);

/* same_file - are these one file?  Each is of a name, or, where that is 0, an
 * open one. */
int same_file(const char *a, FILE *as, const char *b, FILE *bs);

/* open_standard - input, output and error where they are closed: else the first
 * file that is opened would be the one that messages go to. */
void open_standard(void);

/* try_outputs - leave if a file cannot be written, or had better not: an input,
 * or what another one is to be. */
void try_outputs(void);

/* announce - about so many bytes will be written, at least so many; of very
 * many it is said.  Leaves if they do not fit.  announce_all: by the points
 * alone, before there is a mesh. */
void announce(output *o, double bytes, double least);
void announce_all(const points *in);

/* start - open a file to write, under another name, which finish changes: so
 * nothing half written is ever there, whatever ends the program.  bytes: about
 * so many. */
FILE *start(output *o, double bytes);
void finish(FILE *file, output *o);

/* check_written - leave if something could not be written; now and then, so
 * that a full disk ends a run at once. */
void check_written(FILE *file);

/* open_scratch - a temporary file of so many bytes, for what has that name;
 * leaves if it cannot be, as no_scratch does. */
FILE *open_scratch(const char *name, double bytes);
void no_scratch(const char *name);

/* real_text - x, which was a float if narrow, with as few digits as give it
 * back: all numbers of outputs are written so.  put_real: and the character
 * after; put_behind: behind a character, if that is not 0. */
#define REAL 32
void real_text(char *text, double x, int narrow);
void put_real(FILE *file, double x, int narrow, char after);
void put_behind(FILE *file, char before, double x);

/* put_point - the coordinates of a point. */
void put_point(FILE *file, const points *in, tess_int i, char between,
               char after);

/* start_vtk - as start: a legacy VTK file of such a DATASET; binary, for in one
 * that is text VTK reads no NaN.  most: the largest number of points or the
 * like, an int for VTK.
 * put_double, put_int - a number in it, the most significant byte first.
 * put_scalars - what is before one double a point or cell. */
FILE *start_vtk(output *o, const char *title, const char *kind, double most,
                double bytes);
void put_double(FILE *file, double x);
void put_int(FILE *file, double i);
void put_scalars(FILE *file, const char *name);

/* start_vtu - as start_vtk: a .vtu file of so many points, with in's columns of
 * values, and cells, with so many sizes each; what follows are the blocks, each
 * behind put_long of its bytes: points (whose put_long is done), corners,
 * put_types, values, sizes, end_vtu.
 * put_long - a number of eight bytes, the most significant one first. */
FILE *start_vtu(output *o, double n, double cells, int corners,
                const points *in, int sizes);
void put_long(FILE *file, double i);
void put_types(FILE *file, double cells, int corners, int type);
void end_vtu(FILE *file);

/* vtk_name - of a column of values, none twice; until the next one. */
const char *vtk_name(const points *in, int column);

/* put_title - a comma, and a column's name as CSV takes it. */
void put_title(FILE *file, const char *name);

/* put_axes - the names of so many coordinates, as CSV takes them. */
void put_axes(FILE *file, const points *in, int axes);

/* put_name - a column's name, or a word, as CSV takes it. */
void put_name(FILE *file, const char *s);

/* ---- values that are words (classes.c) ---- */

/* new_classes - of a column.  class_number - that of the word, from 0 on, in
 * the order in which they come.  class_name - the word, or "" if it is none.
 * class_count - so many. */
classes *new_classes(void);
double class_number(classes *c, const char *word, size_t length);
const char *class_name(const classes *c, double number);
long class_count(const classes *c);

/* ---- values (places.c) ---- */

/* no_number - a NaN without a sign. */
double no_number(void);

/* next_text - of a's others, those of the next point, as in CSV. */
const char *next_text(const points *a);

/* check_values - leave if the options of values do not fit together. */
void check_values(void);

/* read_places - the places of -query, into *places; leaves when that cannot
 * be.  check_points - leave if what is wanted of the points cannot be. */
void read_places(points *places);
void check_points(const points *in);

/* keep_values - what of the new mesh is needed later on, when iw and rw are
 * gone.  Returns that between whose points write_values' values are: of points
 * that lie in a plane, another one. */
const mesh *keep_values(const mesh *m);

void write_values(const mesh *m);

/* validate_values - print the table of -validate; the mesh is lost. */
void validate_values(mesh *m);

/* ---- points in a plane ---- */

/* find_plane - do all points lie in one plane, but for rounding, and not on one
 * line?  Then it is that of the next three. */
int find_plane(const mesh *m);

/* to_plane - the coordinates in the plane, and 0, of a place's foot there. */
void to_plane(const tess_real *x, tess_real *foot);

/* lay_flat - *m becomes the mesh of n points in the plane and of two points off
 * it, for which p has room; these have the numbers n and n + 1.  Returns as
 * tetrahedralize. */
int lay_flat(mesh *m, tess_int n, tess_real *p, int telling);

/* natural_flat - Sibson's weights in the plane.
 *
 *   p, tet, adj  (in)   that mesh
 *   q, t         (in)   a place, and a tetrahedron that holds it
 *   most         (in)   neighbours that there is room for
 *   nn, nbr      (out)  their number, most at most, and which points they are;
 *                       0 where rounding leaves no digits, as on a side of the
 *                       hull: the linear weights then are theirs
 *   weight       (out)  most + 1: their weights
 *   iw, rw       (out)  3*most integers, 3*most doubles
 *
 * returns 0, or TESS_POOL where most is too small. */
int natural_flat(const tess_real *p, const tess_int *tet, const tess_int *adj,
                 const tess_real *q, tess_int t, tess_int most, tess_int *nn,
                 tess_int *nbr, double *weight, tess_int *iw, double *rw);

/* ---- files of points and tetrahedra (write.c) ---- */

/* xml_text - a text of less than TEXT bytes as XML takes it, until the next
 * one: UTF-8, or if it is not that Latin-1. */
#define TEXT 600
const char *xml_text(const char *text);

/* begin_look - what the options say of all pictures. */
struct draw_look;
void begin_look(const points *in, struct draw_look *look);

/* write_... - a file of that format. */
void write_node(const mesh *m, output *o);
void write_ele(const mesh *m, output *o);
void write_face(const mesh *m, output *o);
void write_obj(const mesh *m, output *o);
void write_off(const mesh *m, output *o);
void write_ply(const mesh *m, output *o);
void write_stl(const mesh *m, output *o);
void write_msh(const mesh *m, output *o);
void write_vtk(const mesh *m, output *o);
void write_vtu(const mesh *m, output *o);
void write_svg(const mesh *m, output *o);

/* normal_to - c = a x b (plane.c). */
void normal_to(const double *a, const double *b, double *c);

/* ---- shapes ---- */

/* alpha_shape - 1 for the tetrahedra whose circumradius is not larger than
 * that, exactly, 0 for the others.  mark_alpha: as m->keep, m->kept. */
char *alpha_shape(const mesh *m, double radius);
void mark_alpha(mesh *m, double radius);

/* least_alpha - the least radius for which the tetrahedra are one piece, joined
 * by facets, and have all points. */
double least_alpha(const mesh *m);

/* check_levels - leave if there can be no surface of equal value, by -iso.
 * keep_levels - what of the new mesh is needed for it when iw is gone.
 * level_surface - that of a file: points, of which the level is the value, and
 * triangles, to be freed; says of each level what it is. */
void check_levels(const points *in);
void keep_levels(const mesh *m);
const points *level_surface(const mesh *m, const output *o, tess_int *many,
                            tess_int **tri);

/* tell_surface - if in is one: whether it is closed, and its volume. */
void tell_surface(const points *in);

/* drop_others - leave the tetrahedra of the alpha shape alone in m. */
void drop_others(mesh *m);

/* make_cells - the Voronoi cells: write what is asked for. */
void make_cells(const mesh *m);

/* ---- what repeats itself, by -periodic (repeat.c) ---- */

/* repeated - points and all their copies, as triclinic has them. */
typedef struct repeated {
    mesh of;         /* the points */
    double cell[12]; /* stretched, by -scale: short vectors, at right angles to
                      * those along which nothing repeats itself; a corner */
    double inverse[9]; /* the k-th part times x - corner: so many of its vector
                        * k is x away */
    tess_int ways[3], ntet, *tet, *move, *adj, *shift;
    tess_real *at;   /* the points, stretched, in the cell, */
    int *away;       /* to which so many of its vectors bring each */
    double volume;   /* the cell's, not stretched */
    int sides;       /* has it some where nothing repeats itself? */
    long beyond;     /* points beyond those */
} repeated;

const repeated *repetition(void);

/* check_box - leave if there is no box that can be repeated, but one is
 * needed. */
void check_box(const points *in);

/* cell_box - the box about the cell, not stretched; where that is flat, as
 * before. */
void cell_box(double *box);

/* repeat - as tetrahedralize: make *m, which has points, the mesh of them and
 * all their copies: of it one tetrahedron of each class, with what they need of
 * copies behind the points.  Where they do not share a facet as they are
 * written adj has no neighbour. */
int repeat(mesh *m, tess_int *duplicates);

/* repeat_around - the mesh of so many copies as a value in the cell depends on:
 * smooth: by gradients, too.
 * into_cell - move a stretched place into the cell. */
const mesh *repeat_around(int smooth);
void into_cell(tess_real *q);

#endif
