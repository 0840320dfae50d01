/* read.h - what the files that read points share.
 *
 *   scan.c     a file's bytes and lines      cell.c    numbers, a line's cells
 *   rows.c     columns' roles, rows, points  names.c   columns' names
 *   doubts.c   what numbers rows             voids.c   what stands for none
 *   formats.c  which format it is            tables.c  tables with heads
 *   meshes.c   OFF, PLY, OBJ, STL, .node     models.c  GOCAD, Nastran
 *   atoms.c    .xyz, PDB, PQR, Amber, LAMMPS dumps
 *   arrays.c   .npy, PCD, LAS
 *
 * Each line of a file is a row, of the head, blank or a comment, left out, or
 * dropped; or it is an error.  There is no static data but constant tables.
 */
#ifndef READ_H
#define READ_H

#include "../driver.h"

#define KINDS 12      /* of what a file leaves out: no format has as many */
#define LIMITS_KEPT 32 /* values that are kept as they stand for a limit */
#define SAMPLE 16384  /* bytes by which lines are judged */
#define WHOLE 9007199254740992.0 /* up to here integers are exact */

/* ---- scan.c ---- */

/* scan - one file: its bytes and its lines. */
typedef struct scan {
    const char *name;    /* as messages have it */
    FILE *file;
    double size, passed; /* bytes, -1 if not known; those before block */
    char *block, *at, *end; /* in memory; not yet taken; '\0' stands at end */
    size_t room;         /* of block */
    int ended;           /* there is nothing behind end */
    int rough;           /* there may be CR or NUL in block */
    int binary;          /* number counts rows, head and left are of bytes */
    int joins;           /* a line that ends in \ goes on in the next one */
    char *line, *stop;   /* the line, in block; '\0' stands at stop, */
    char held;           /* in place of this */
    long number;         /* of the line, from 1 on */
    int open;            /* has the last line no end? */
    size_t mark;         /* where scan_again goes back to; block stays, */
    long marked;         /* and that line's number */
    int pinned;
    struct {
        const char *what;
        double many;
        long first;
        int lines; /* are these whole lines?  Else parts of rows */
    } left[KINDS + 1]; /* the last one stays empty */
    double rows, head, blank, dropped; /* with left: all there is */
} scan;

/* scan_open - begin to read; name 0: standard input. */
void scan_open(scan *s, const char *name);

/* scan_line - the next line, as it is; 0 at the end. */
int scan_line(scan *s);

/* scan_take - the next n bytes, in block; 0 if there are fewer. */
char *scan_take(scan *s, size_t n);

/* scan_passed - bytes that have been taken. */
double scan_passed(const scan *s);

/* in_sample - does the next line begin in the sample? */
int in_sample(const scan *s);

/* scan_room - leave if the file has no room for so many rows of so many bytes
 * at least. */
void scan_room(const scan *s, double rows, double bytes);

/* scan_pin - let scan_again come back to here; scan_go: no more. */
void scan_pin(scan *s);
void scan_again(scan *s);
void scan_go(scan *s);

/* scan_leave - the line is left out: told at the end, by kind.  scan_note: so
 * are so many of something, a part of a row.  scan_rest: all that follows. */
void scan_leave(scan *s, const char *what);
void scan_note(scan *s, const char *what, double many, int lines);
void scan_rest(scan *s, const char *what);

/* scan_end - tell what is to be told, and close. */
void scan_end(scan *s);

/* scan_fail - leave, with the line. */
void scan_fail(const scan *s, const char *format, ...);

/* ---- cell.c ---- */

/* What a cell may be.  NEAR: a number but for a comma, a sign or the like. */
enum { NUMBER, NEAR, EMPTY, ABSENT, STARS, INFINITE, BELOW, WORD };

typedef struct cell {
    char *text, *end; /* as in the file, without quotes */
    int kind, quoted; /* (2: but not as a whole) */
    double x; /* of NUMBER, INFINITE; BELOW: the limit; ABSENT: NaN, or 0 */
} cell;

/* SHOWN, TITLED - of a cell, for "%.*s": not more than a line can show, a title
 * hold with a number behind. */
#define PART(c, n) \
    (int)((c)->end - (c)->text < (n) ? (c)->end - (c)->text : (n)), (c)->text
#define SHOWN(c) PART(c, 40)
#define TITLED(c) PART(c, TITLE - 5)

/* dialect - what separates cells: ; | , a tab, or blanks, ' '. */
typedef struct dialect {
    char separator, decimal;
    int apart; /* both are commas: decimal ones are in quotes */
} dialect;

typedef struct reader reader;

/* number - the end of the number at s, and *x, if x is not 0; s if there is
 * none. */
char *number(char *s, char decimal, double *x);

/* whole - are these digits alone, of a number up to 2^53? */
int whole(const char *s, const char *end, double *n);
int cell_whole(const cell *c, double *n);

/* numbers - exactly so many, with blanks, commas, brackets between, up to end.
 * Returns 0 if they are not. */
int numbers(char *s, const char *end, int want, double *x);

/* stored - the number of so many bytes there; type: f, i, u.  big: is the most
 * significant one the first? */
double stored(const char *at, char type, int bytes, int big);

/* cell_kind - of a cell that is no NUMBER.  remedy: what to do about it, in
 * brackets, or "". */
void cell_kind(cell *c, char decimal);
const char *remedy(const cell *c, char decimal);

/* cut - the line's cells, at most COLUMNS + 1; returns how many. */
int cut(reader *r);

/* unquote - let one quote stand for two, in a quoted cell that is not cut
 * again; its new end. */
char *unquote(char *s, const char *end);

/* cut_fixed - what is in columns from ... last, counted from 1; EMPTY if
 * blank. */
void cut_fixed(const scan *s, int from, int last, cell *c);

/* comment - is the line one, or blank? */
int comment(const scan *s);

/* next_line - the next one that is neither; 0 at the end.  next_cells: cut; 0,
 * too, where ends_rows: by the format the line ends the rows. */
int next_line(scan *s);
int next_cells(reader *r);
int ends_rows(const reader *r);

/* cell_is - is the text this, in letters of any case? */
int cell_is(const cell *c, const char *text);

/* sum_word - which of the words is it that rows are called by that sum up
 * others, as Total?  -1: none. */
int sum_word(const cell *c);

/* listed - is s ... end among the list's words?  Before each is a blank, after
 * it that character; what is behind that is returned, or 0. */
const char *listed(const char *list, const char *s, const char *end, char by);

/* ---- rows.c ---- */

/* What a column is: 0, 1, 2 a coordinate; a value; words; not used; empty. */
enum { VALUE = 3, LABEL, UNUSED, HOLLOW };

typedef struct column {
    char title[TITLE];
    char shown[24];     /* of words, the first one */
    int role;
    char type;          /* of binary ones: as stored has it */
    int bytes;
    double at;          /* behind so many of the row's */
    double times, plus; /* what is stored, times this, plus that; 0: as it is */
    int apart;          /* is it no axis, whatever it is called? */
    int lacks;          /* does a number stand for none, this one: */
    double lacking;
    double last;        /* the number that there was last */
    int classed;        /* is it a value of words? */
    int unit;           /* 1 + names.c's number of it; 0: it is not known */
} column;

/* What is counted of rows: those that are dropped for a cell that is EMPTY,
 * ABSENT, STARS, or by -nodata, and all; and values. */
enum { VOID = WORD + 1, DROPPED, NANS, INFINITES, LIMITS, ABOVE, TINY, ROUNDED,
       TALLIES };

/* reader - what a format's head says, for the rows behind it. */
struct reader {
    scan s;
    points *to;
    dialect d;
    double want;     /* rows that the head announces; -1: to the end */
    int form;        /* LINES, FIXED, PACKED */
    int big;         /* PACKED: as stored has it */
    double stride;   /* bytes from a row to the next one in a record; */
    double record;   /* bytes of this, 0: it is a row, */
    double per;      /* rows in it */
    double share;    /* of the file, a row's: bytes, or 1 line */
    const char *begins; /* the word that rows begin with, among lines; or 0 */
    int keeps;       /* a column that -nodata leaves alone, or -1 */
    int named;       /* are x, y, z known by their titles alone? */
    int table;       /* is it a table, neither atoms nor a mesh? */
    const char *nowhere; /* what the file is if it has no axes, or 0 */
    const char *ends;    /* what a line begins with that ends the rows, or 0; */
    int over;            /* it was there */
    int wide;        /* if not 0, cells that touch are so wide */
    int fills;       /* is an empty cell as the one above, in ODV's columns? */
    int scaled;      /* are coordinates parts of the cell's vectors? */
    int numbered;    /* does column 1 number the rows, from 0 or 1 on? */
    int waits;       /* is the line cut, but not yet taken? */
    double looked, most; /* lines of the sample: seen, to be seen at most */
    int columns;
    column column[COLUMNS];
    int cells, more; /* of the line; does a separator end it?  Behind that is
                      * one cell more, an EMPTY one */
    int torn;        /* so many cells end with one whose quote is open; or 0 */
    int skims;       /* does a cell's kind suffice, without x? */
    cell cell[COLUMNS + 3];
    const char *row; /* PACKED: this one; so many are behind it in its record */
    double left;
    /* by take_columns: */
    int axes, by;
    int uses, use[COLUMNS];   /* columns: coordinates, then values */
    int words, word[COLUMNS]; /* those that must have no numbers */
    double x[COLUMNS];
    double many[TALLIES];
    double limit[LIMITS_KEPT]; /* values that stand for a limit, the first */
    int limits;                /* ones; so many */
    long first[TALLIES];      /* in these lines */
    char remark[400];         /* the last comment before a count, or ""; */
    long remarked;            /* its line */
    /* names.c: where names are from; are they one less than columns (in that
     * line), or not as many?  The comment that has them, or may have */
    int taken, shifted, astray;
    long fewer, noted, maybe;
    long titled; /* the line that names columns; 0: it is none, or several */
    /* the axes' family, or -1; a column that is called as one is, or -1; are
     * others called so that they might be the axes? */
    int family, twin, rivals;
    /* doubts.c: the column that numbers rows, or -1; has column 1 whole
     * numbers, each but once?  May x number them?  Rows so far, steps of 1,
     * the last number, the first ones */
    int number, unique, counting;
    double numbered_rows, ones, last_number, numbers[3];
    /* the columns of words; rows that they call sums: all, those at the head,
     * the last ones; which words that are, a bit each; are some there twice?
     * Does the first row number the columns, from this on? */
    int labels, label[COLUMNS], sums_twice, counts;
    double sums, first_sums, last_sums, counts_from;
    unsigned long sums_had;
    char sums_shown[24]; /* the first one's word */
    double face_room;         /* of to->face; corners of the face: */
    tess_int fan[2];          /* the first one, the last one */
    tess_int spilled;         /* places that are in the file of their own */
    size_t labelled, labels_room; /* of to->labels */
};

enum { LINES, FIXED, PACKED };

/* axes_option - that names columns. */
const char *axes_option(const reader *r);

/* is_titled - is the title this name, its unit left out, in letters of any case
 * if fold? */
int is_titled(const char *title, const char *name, size_t length, int fold);

/* add_column - one more, a VALUE, so called.  title_of - a cell, for that. */
column *add_column(reader *r, const char *title);
void title_of(const cell *c, char *title);

/* add_packed - one more, of that type, behind the last one.  add_axes: three,
 * x, y, z. */
column *add_packed(reader *r, const char *title, char type, int bytes);
void add_axes(reader *r, char type, int bytes);

/* take_columns - their roles: by -cols, -by, by titles, else as they come. */
void take_columns(reader *r);

/* take_row - the cells: kept, or dropped. */
void take_row(reader *r);

/* take_all - the columns' roles, want rows or all; what follows is left out as
 * what behind says, if that is not 0. */
void take_all(reader *r, const char *behind);

/* take_lines - rows of lines whose columns are not known: a sample of them
 * tells.  take_table: they are, but which have numbers is not. */
void take_lines(reader *r);
void take_table(reader *r);

/* take_lacking - the cell of column k is ABSENT, if its number stands for none
 * there. */
void take_lacking(reader *r, int k);

/* sample_again - go behind so many lines of the sample.  sampled - the next
 * one, of as many as r says, cut; 0 at the end. */
void sample_again(reader *r, double lines);
int sampled(reader *r);

/* bad_cell - leave for the cell of column k. */
void bad_cell(reader *r, int k);

/* end_rows - the points are complete. */
void end_rows(reader *r);

/* lattice - the box that these vectors span from the origin. */
void lattice(points *to, const double v[9], const double *origin);

/* ---- names.c ---- */

/* Where names are from: comments that may be no names, others, lines; each and
 * how many axes they name. */
enum { PERHAPS_NAMES = 1, COMMENT = 10, LINE_OF_NAMES = 20 };

/* is_axis - is a column so called axis k, whatever the other ones are? */
int is_axis(const char *title, int k);

/* is_unit - is the word that of a unit? */
int is_unit(const char *s, const char *end);

/* choose_axes - the columns that their names say are the axes, of one family;
 * SEVERAL: so do others. */
enum { NONE, FIT, SEVERAL };
int choose_axes(reader *r, int *at);

/* place_axes - the axes by names, or by place where there are no names, or as
 * many columns of numbers as axes; leaves if neither says. */
void place_axes(reader *r, int *at);

/* name_cells - cut the text into so many cells, names, as rows are, or by
 * whatever does it; *way.  Returns 0 if nothing does, else 1 and how many axes
 * they name. */
int name_cells(reader *r, char *text, int want, int *way);

/* names_axes - are all axes among the line's cells, before any number? */
int names_axes(reader *r);

/* comment_names, head_names - the line is a comment, or one of the head, the
 * last one if last: its names, if there are any. */
void comment_names(reader *r, char *text, long line);
void head_names(reader *r, int last);

/* is_globe - are x, y longitudes and latitudes? */
int is_globe(const reader *r);

/* tell_columns - what columns were taken for, where that might be misread. */
void tell_columns(reader *r);

/* ---- doubts.c ---- */

/* find_numbers - does a column number the rows of the sample, behind its head?
 * check_numbers: the row's cell must go on with that.  count_x: x is one more.
 * tell_numbers: what was found.  doubt_row: is the row no point, as one of
 * sums?  tell_rows: such rows; and numbers whose points part thousands. */
void find_numbers(reader *r, double head);
void check_numbers(reader *r);
void count_x(reader *r, double x);
void tell_numbers(reader *r);
void doubt_row(reader *r);
void tell_rows(const reader *r);

/* tell_alike - words of the column so called, all different, that may be meant
 * to be the same: they differ in capitals or blanks alone.  It sorts them. */
void tell_alike(const points *to, const char *title, const char **word,
                size_t many);

/* ---- voids.c ---- */

/* number_of - an axis of the point, from 0 on, or a value, from 3 on. */
double number_of(const points *to, int k, tess_int i);

/* doubt_points - tell which numbers may stand for none. */
void doubt_points(reader *r);

/* ---- formats.c, tables.c, meshes.c, models.c, atoms.c, arrays.c ---- */

/* take_corner - the next one, number k, of a face: point i.  Faces are made
 * triangles. */
void take_corner(reader *r, double i, int k);

/* first_cells - the cells of the first line that is neither blank nor begins
 * with #, with blanks between them; their number. */
int first_cells(reader *r);

/* is_... - looks at the sample.  is_unknown: has it a NUL, as text has not? */
int is_unknown(reader *r), is_pdb(reader *r), is_node(reader *r),
    is_off(reader *r), is_obj(reader *r), is_packed_stl(reader *r),
    is_pqr(reader *r), is_amber(reader *r), is_nastran(reader *r),
    is_geoeas(reader *r), is_petrel(reader *r), is_odv(reader *r);

void read_pdb(reader *r), read_pqr(reader *r), read_amber(reader *r),
    read_dump(reader *r), read_node(reader *r), read_off(reader *r),
    read_ply(reader *r), read_obj(reader *r), read_stl(reader *r),
    read_packed_stl(reader *r), read_npy(reader *r), read_pcd(reader *r),
    read_las(reader *r), read_gocad(reader *r), read_nastran(reader *r),
    read_geoeas(reader *r), read_petrel(reader *r), read_post(reader *r),
    read_cnv(reader *r), read_odv(reader *r), read_bottles(reader *r),
    read_well(reader *r);

/* extended - is the line that of an extended .xyz file?  Then its box is taken,
 * and its columns, if it has them. */
int extended(reader *r);

/* need_line - scan_line, where the file must not end.  need_cells: next_cells,
 * of the head. */
void need_line(reader *r);
int need_cells(reader *r);

#endif
