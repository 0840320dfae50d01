/* write.c - the files that build/tess writes.
 *
 * Each is written under another name, which it changes for its own when it is
 * complete.
 */
#if defined(__unix__) || defined(__APPLE__)
#define _XOPEN_SOURCE 600
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>
#define POSIX
#endif

#include "draw/draw.h"
#include "driver.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#define FEW 200     /* tetrahedra that are drawn apart                 */
#define MUCH 1e9    /* bytes: from there on it is said                 */
#define WIDTH 18.0  /* bytes of a number in a text, about              */
#define SHORTER 0.1 /* of them, at least so many are really there      */
#define CLOUD 6.8   /* tetrahedra of a point that others surround      */
#define CELL 1500.0 /* bytes of a point's cell, and of its faces' rows */

/* ---- files ---- */

int ends_in(const char *name, const char *suffix)
{
    size_t a = strlen(name), b = strlen(suffix);

    if (a < b) return 0;
    for (name += a - b; *suffix && tolower((unsigned char)*name) == *suffix;)
        name++, suffix++;
    return !*suffix;
}

int same_file(const char *a, FILE *as, const char *b, FILE *bs)
{
#ifdef POSIX
    struct stat s, t;
#else
    FILE *file, *other;
    int c = EOF, some = 0;
#endif

    for (; a && strncmp(a, "./", 2) == 0; a += 2) continue;
    for (; b && strncmp(b, "./", 2) == 0; b += 2) continue;
    if (a && b && strcmp(a, b) == 0) return 1;
#ifdef POSIX
    return (a ? stat(a, &s) : fstat(fileno(as), &s)) == 0 &&
           (b ? stat(b, &t) : fstat(fileno(bs), &t)) == 0 &&
           s.st_dev == t.st_dev && s.st_ino == t.st_ino && S_ISREG(s.st_mode);
#else
    /* (files of the same bytes may be one) */
    (void)as;
    (void)bs;
    file = a ? fopen(a, "rb") : 0;
    other = file && b ? fopen(b, "rb") : 0;
    while (other && (c = getc(file)) == getc(other) && c != EOF) some = 1;
    if (file) fclose(file);
    if (other) fclose(other);
    return some && c == EOF;
#endif
}

/* taken - is there anything of that name? */
static int taken(const char *name)
{
#ifdef POSIX
    struct stat s;

    return lstat(name, &s) == 0;
#else
    FILE *file = fopen(name, "rb");

    if (file) fclose(file);
    return file != 0;
#endif
}

/* direct - standard output, devices, pipes: they are written as they are. */
static int direct(const char *name)
{
#ifdef POSIX
    struct stat s;

    if (stat(name, &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode))
        return 1;
#else
    if (strncmp(name, "/dev/", 5) == 0) return 1;
#endif
    return strcmp(name, "-") == 0;
}

static int is_link(const char *name)
{
#ifdef POSIX
    struct stat s;

    return lstat(name, &s) == 0 && S_ISLNK(s.st_mode);
#else
    (void)name;
    return 0;
#endif
}

void open_standard(void)
{
#ifdef POSIX
    struct stat s;
    int k;

    /* (so that reading and writing fail) */
    for (k = 0; k < 3; k++)
        if (fstat(k, &s) != 0 &&
            open("/dev/null", k == 0 ? O_WRONLY : O_RDONLY) != k)
            exit(2);
#endif
}

/* ---- what is not complete goes, whatever ends the program ---- */

static volatile sig_atomic_t stopped; /* by this signal; 0: not yet */
static int unfinished;                /* partial files that there are */

static void discard(void)
{
    output *o = 0;

    while ((o = next_output(0, o)) != 0) {
        if (!o->begun) continue;
        if (o->file) fclose(o->file);
        remove(o->partial);
        o->begun = 0;
    }
}

/* on_stop - then the signal does what it does to a program that does not catch
 * it.  (Where a handler may not remove files check_written does so.) */
static void on_stop(int which)
{
#ifdef POSIX
    output *o = 0;

    while ((o = next_output(0, o)) != 0)
        if (o->begun) unlink(o->partial);
    signal(which, SIG_DFL);
    raise(which);
#else
    stopped = which;
#endif
}

/* on_signals - but for those that are ignored. */
static void on_signals(void (*handler)(int))
{
    static const int all[] = {
#ifdef SIGHUP
        SIGHUP,
#endif
#ifdef SIGQUIT
        SIGQUIT,
#endif
#ifdef SIGPIPE
        SIGPIPE,
#endif
#ifdef SIGXCPU
        SIGXCPU,
#endif
#ifdef SIGXFSZ
        SIGXFSZ,
#endif
        SIGINT, SIGTERM};
    size_t k;

    for (k = 0; k < sizeof all / sizeof all[0]; k++)
        if (signal(all[k], handler) == SIG_IGN) signal(all[k], SIG_IGN);
}

void check_written(FILE *file)
{
    output *o = 0;
    int which = (int)stopped;

    if (which) {
        discard();
        signal(which, SIG_DFL);
        raise(which);
    }
    if (!ferror(file)) return;
    while ((o = next_output(0, o)) != 0 && o->file != file) continue;
    fail("%s: write error", o ? o->name : "standard output");
}

/* make_partial - a new file; one that is there stays. */
static FILE *make_partial(output *o)
{
    static int begun;
#ifdef POSIX
    int number;
#endif

    if (!begun++) atexit(discard);
    if (taken(o->partial)) {
        /* (is it another output's?  Then it goes with it) */
        discard();
        fail(taken(o->partial) ? "%s: %s is there, of another run, perhaps: "
                                 "remove it, or choose another name"
                               : "%s: the name of two outputs",
             o->name, o->partial);
    }
    if (unfinished++ == 0) on_signals(on_stop);
#ifdef POSIX
    number = open(o->partial, O_WRONLY | O_CREAT | O_EXCL, 0666);
    o->begun = number >= 0;
    return number < 0 ? 0 : fdopen(number, "wb");
#else
    o->file = fopen(o->partial, "wb");
    o->begun = o->file != 0;
    return o->file;
#endif
}

/* open_output - to write. */
static void open_output(output *o)
{
    if (strcmp(o->name, "-") == 0)
        o->file = stdout;
    else
        o->file = o->partial ? make_partial(o) : fopen(o->name, "wb");
    if (!o->file) fail("%s: %s", o->name, strerror(errno));
}

/* end_output - the partial file has gone, or has its name. */
static void end_output(output *o)
{
    o->file = 0;
    o->begun = 0;
    if (o->partial && --unfinished == 0) on_signals(SIG_DFL);
}

/* read_from - what is read from the file of that name, or from the open one: 0
 * if nothing is. */
static const char *read_from(const char *name, FILE *file)
{
    static const char *const what[] = {"input", "places"};
    const char *input;
    int k;

    for (k = 0; k < (chosen.query ? 2 : 1); k++) {
        input = k == 0 ? chosen.input : chosen.query;
        if (input && strcmp(input, "-") == 0) input = 0;
        if (same_file(name, file, input, stdin)) return what[k];
    }
    return 0;
}

static void try_output(output *o)
{
    const char *what = read_from(o->name, stdout);
    FILE *file;

    if (what) fail("%s: would overwrite the %s", o->name, what);
    if (direct(o->name)) return;
    if (is_link(o->name))
        fail("%s: is a symbolic link, which stays as it is: name the file that "
             "it points to", o->name);
    if (same_file(o->name, 0, 0, stdout))
        fail("%s: standard output goes there, too", o->name);
    if (taken(o->name)) {
        /* (a directory, or protected) */
        file = fopen(o->name, "r+b");
        if (!file) fail("%s: cannot be written over", o->name);
        fclose(file);
    }
    o->partial = (char *)space((double)strlen(o->name) + 6.0, 1);
    strcat(strcpy(o->partial, o->name), ".part");
    what = read_from(o->partial, 0);
    if (what) fail("%s: would overwrite the %s, %s", o->name, what, o->partial);
    open_output(o);
}

void try_outputs(void)
{
    const char *what = read_from(0, stdout);
    output *o, *other;

    if (!what) what = read_from(0, stderr);
    if (what) fail("standard output or error would overwrite the %s", what);
    for (o = 0; (o = next_output(0, o)) != 0;) {
        for (other = 0; (other = next_output(0, other)) != o;)
            if (strcmp(o->name, other->name) == 0 && direct(o->name) &&
                strncmp(o->name, "/dev/", 5) != 0)
                fail("%s: the name of two outputs", o->name);
        if (strcmp(o->name, "-") == 0) {
            chosen.to_stdout = 1;
            if (chosen.validate)
                fail("standard output is for the table of -validate");
        } else {
            try_output(o);
        }
    }
    /* (only now: the second name of one file has met the first one's) */
    for (o = 0; (o = next_output(0, o)) != 0;) {
        if (!o->begun) continue;
        fclose(o->file);
        remove(o->partial);
        end_output(o);
    }
}

/* ---- sizes ---- */

#ifdef POSIX
/* vacant - bytes on the disk of that folder, whose number is *disk; -1 if they
 * are not known. */
static double vacant(const char *folder, dev_t *disk)
{
    struct statvfs v;
    struct stat s;

    if (stat(folder, &s) != 0 || statvfs(folder, &v) != 0 || v.f_blocks == 0)
        return -1.0;
    *disk = s.st_dev;
    return (double)v.f_bavail * (double)v.f_frsize;
}

/* folder_of - that of the file of that name; to be freed. */
static char *folder_of(const char *name)
{
    const char *slash = strrchr(name, '/');
    size_t length = slash ? (size_t)(slash - name) + 1 : 1;
    char *folder = (char *)space((double)length + 1.0, 1);

    memcpy(folder, slash ? name : ".", length);
    folder[length] = '\0';
    return folder;
}

/* vacant_for - leave if the least bytes of the outputs on this one's disk are
 * more than it has. */
static void vacant_for(const output *o)
{
    dev_t disk, other;
    char *folder = folder_of(o->name);
    double room = vacant(folder, &disk), bytes = 0.0;
    output *all = 0;

    free(folder);
    while (room >= 0.0 && (all = next_output(0, all)) != 0) {
        if (!all->partial || all->least <= 0.0) continue;
        folder = folder_of(all->name);
        if (vacant(folder, &other) >= 0.0 && other == disk)
            bytes += all->least;
        free(folder);
    }
    if (room >= 0.0 && bytes > room)
        fail("%s: %.0f bytes (%.1f GB) do not fit where %.1f GB are free",
             o->name, bytes, bytes / 1e9, room / 1e9);
}
#endif

void announce(output *o, double bytes, double least)
{
    o->least = least;
#ifdef POSIX
    if (o->partial && least > 0.0) vacant_for(o);
#endif
    /* (even by -q: it is too late when the disk is full) */
    if (bytes > MUCH && !o->announced)
        fprintf(stderr, "tess: %s: about %.1f GB will be written\n", o->name,
                bytes / 1e9);
    o->announced |= bytes > MUCH;
}

void announce_all(const points *in)
{
    double c = (double)in->columns, each;
    output *o;

    for (o = 0; (o = next_output(0, o)) != 0;) {
        if (o->all == values_forms || o->all == errors_forms ||
            o->all == face_forms || o->all == iso_forms ||
            o->all == svg_forms)
            continue;
        if (!o->as->write)
            each = o->all == volumes_forms ? 210.0 + 20.0 * c : CELL;
        else if (o->as->write == write_vtk || o->as->write == write_vtu)
            each = 8.0 * (3.0 + c) + 40.0 * CLOUD;
        else
            each = WIDTH * (4.0 + c + 2.0 * CLOUD);
        announce(o, each * (double)in->n, 0.0);
    }
}

FILE *open_scratch(const char *name, double bytes)
{
    FILE *file;
#if defined(POSIX) && defined(P_tmpdir)
    dev_t disk;
    double room = vacant(P_tmpdir, &disk);

    if (room >= 0.0 && bytes > room)
        fail("%s: %.0f bytes (%.1f GB) of a temporary file do not fit in %s, "
             "where %.1f GB are free",
             name, bytes, bytes / 1e9, P_tmpdir, room / 1e9);
#else
    (void)bytes;
#endif
    file = tmpfile();
    if (!file) no_scratch(name);
    return file;
}

void no_scratch(const char *name)
{
#ifdef P_tmpdir
    fail("%s: no room for a temporary file in %s", name, P_tmpdir);
#else
    fail("%s: no room for a temporary file", name);
#endif
}

/* ---- from the beginning to the end ---- */

FILE *start(output *o, double bytes)
{
    if (bytes * SHORTER > o->least) announce(o, bytes, bytes * SHORTER);
    say("writing %s ...", o->name);
    open_output(o);
    return o->file;
}

void finish(FILE *file, output *o)
{
    fflush(file);
    check_written(file);
    o->file = 0;
    if (file != stdout && fclose(file)) fail("%s: write error", o->name);
    if (o->partial && rename(o->partial, o->name) != 0) {
        o->begun = 0;
#ifndef POSIX
        /* (where rename replaces no file, it has to go before) */
        if (remove(o->name) != 0 || rename(o->partial, o->name) != 0)
#endif
            fail("%s: %s; all that was to be in it is in %s", o->name,
                 strerror(errno), o->partial);
    }
    end_output(o);
    o->least = 0.0;
    tell("written       %s\n", o->name);
}

void real_text(char *text, double x, int narrow)
{
    double back;
    int digits = narrow ? FLT_DIG : DBL_DIG, most = digits + 3;

    do {
        sprintf(text, "%.*g", digits, x);
        back = strtod(text, (char **)0);
        if (narrow) back = (double)(float)back;
    } while (back != x && digits++ < most);
}

void put_real(FILE *file, double x, int narrow, char after)
{
    char text[REAL];

    check_written(file);
    real_text(text, x, narrow);
    fprintf(file, "%s%c", text, after);
}

void put_behind(FILE *file, char before, double x)
{
    char text[REAL];

    if (before) putc(before, file);
    real_text(text, x, 0);
    fputs(text, file);
}

void put_point(FILE *file, const points *in, tess_int i, char between,
               char after)
{
    int narrow = sizeof(tess_real) < sizeof(double);
    const tess_real *p = in->p + 3 * i;

    put_real(file, (double)p[0], narrow, between);
    put_real(file, (double)p[1], narrow, between);
    put_real(file, (double)p[2], narrow, after);
}

void put_axes(FILE *file, const points *in, int axes)
{
    int k;

    for (k = 0; k < axes; k++) {
        if (k > 0) putc(',', file);
        put_name(file, in->axis[k][0] ? in->axis[k] : &"x\0y\0z"[2 * k]);
    }
}

/* ---- the mesh, or its boundary ---- */

/* part - what a file has of a mesh: cells, of that many corners, and points, of
 * which these; or 0: all. */
typedef struct part {
    const points *in;
    tess_int points, cells, *point, *cell;
    int corners;
} part;

/* boundary - its triangles, seen counter-clockwise from outside; own: between
 * their own points, numbered anew. */
static part boundary(const mesh *m, int own)
{
    part a;
    double n = (double)m->in->n;
    tess_int *place = (tess_int *)space(n, sizeof *place), *v;

    a.in = m->in;
    a.corners = 3;
    tess_hull(m->ntet, m->tet, m->adj, 0, &a.cells, place);
    a.cell = (tess_int *)space(3.0 * (double)a.cells, sizeof *a.cell);
    tess_hull(m->ntet, m->tet, m->adj, a.cells, &a.cells, a.cell);
    a.point = (tess_int *)space(n, sizeof *a.point);
    for (a.points = 0; a.points < a.in->n;) place[a.points++] = TESS_NONE;
    a.points = 0;
    for (v = a.cell; own && v < a.cell + 3 * (size_t)a.cells; v++) {
        if (place[*v] < 0) {
            a.point[a.points] = *v;
            place[*v] = a.points++;
        }
        *v = place[*v];
    }
    free(place);
    return a;
}

/* part_of - what that file has. */
static part part_of(const mesh *m, const output *o)
{
    part a;

    if (o->all == face_forms) return boundary(m, 1);
    if (o->all == iso_forms) {
        a.in = level_surface(m, o, &a.cells, &a.cell);
        a.points = a.in->n;
        a.point = 0;
        a.corners = 3;
        return a;
    }
    a.in = m->in;
    a.points = a.in->n;
    a.cells = m->ntet;
    a.corners = 4;
    a.point = 0;
    a.cell = m->tet;
    return a;
}

/* end_part - the file is complete. */
static void end_part(FILE *file, output *o, part *a)
{
    if (a->corners == 3) free(a->cell);
    free(a->point);
    finish(file, o);
}

static tess_int point_of(const part *a, tess_int i)
{
    return a->point ? a->point[i] : i;
}

static double value_of(const part *a, tess_int i, int column)
{
    return a->in->value[(size_t)a->in->columns * (size_t)point_of(a, i) +
                        (size_t)column];
}

/* text_size - about so many bytes, in a text with columns of values. */
static double text_size(const part *a, int columns)
{
    return WIDTH *
           ((4.0 + columns) * (double)a->points + 2.0 * (double)a->cells);
}

/* put_before - what a line of a text begins with: that, or if 0 a number. */
static void put_before(FILE *file, const char *before, tess_int number)
{
    check_written(file);
    if (before)
        fprintf(file, "%s", before);
    else
        fprintf(file, "%ld ", (long)number);
}

/* put_points - as lines: each one's number, from base on, or what is before it;
 * coordinates; values of so many columns. */
static void put_points(FILE *file, const part *a, const char *before,
                       tess_int base, int columns)
{
    tess_int i;
    int k;

    for (i = 0; i < a->points; i++) {
        put_before(file, before, i + base);
        put_point(file, a->in, point_of(a, i), ' ', columns > 0 ? ' ' : '\n');
        for (k = 1; k <= columns; k++)
            put_real(file, value_of(a, i, k - 1), 0, k < columns ? ' ' : '\n');
    }
}

/* put_cells - the same of cells; corners' numbers, too, are from base on. */
static void put_cells(FILE *file, const part *a, const char *before,
                      tess_int base)
{
    const tess_int *v = a->cell;
    tess_int i;
    int k;

    for (i = 0; i < a->cells; i++) {
        put_before(file, before, i + base);
        for (k = 1; k <= a->corners; k++, v++)
            fprintf(file, k < a->corners ? "%ld " : "%ld\n",
                    *v < 0 ? -1L : (long)(*v + base));
    }
}

void write_node(const mesh *m, output *o)
{
    part a = part_of(m, o);
    int columns = a.in->columns;
    FILE *file = start(o, text_size(&a, columns));

    fprintf(file, "%ld 3 %d %d\n", (long)a.points, columns - a.in->marker,
            a.in->marker);
    put_points(file, &a, 0, a.in->base, columns);
    end_part(file, o, &a);
}

void write_ele(const mesh *m, output *o)
{
    part a = part_of(m, o);
    int neighbours = ends_in(o->as->ending, ".neigh");
    FILE *file = start(o, text_size(&a, 0));

    if (neighbours) a.cell = m->adj;
    fprintf(file, "%ld 4%s\n", (long)a.cells, neighbours ? "" : " 0");
    put_cells(file, &a, 0, a.in->base);
    end_part(file, o, &a);
}

void write_face(const mesh *m, output *o)
{
    part a = boundary(m, 0);
    FILE *file = start(o, text_size(&a, 0));

    fprintf(file, "%ld 0\n", (long)a.cells);
    put_cells(file, &a, 0, a.in->base);
    end_part(file, o, &a);
}

void write_obj(const mesh *m, output *o)
{
    part a = part_of(m, o);
    FILE *file = start(o, text_size(&a, 0));

    put_points(file, &a, "v ", 0, 0);
    put_cells(file, &a, "f ", 1);
    end_part(file, o, &a);
}

void write_off(const mesh *m, output *o)
{
    part a = part_of(m, o);
    FILE *file = start(o, text_size(&a, 0));

    fprintf(file, "OFF\n%ld %ld 0\n", (long)a.points, (long)a.cells);
    put_points(file, &a, "", 0, 0);
    put_cells(file, &a, "3 ", 0);
    end_part(file, o, &a);
}

void write_ply(const mesh *m, output *o)
{
    part a = part_of(m, o);
    FILE *file = start(o, text_size(&a, a.in->columns));
    int k;

    fprintf(file, "ply\nformat ascii 1.0\nelement vertex %ld\nproperty double x"
                  "\nproperty double y\nproperty double z\n", (long)a.points);
    for (k = 0; k < a.in->columns; k++)
        fprintf(file, "property double %s\n", vtk_name(a.in, k));
    fprintf(file, "element face %ld\nproperty list uchar int vertex_indices\n"
                  "end_header\n", (long)a.cells);
    put_points(file, &a, "", 0, a.in->columns);
    put_cells(file, &a, "3 ", 0);
    end_part(file, o, &a);
}

/* write_stl - as text: the binary form would round coordinates. */
void write_stl(const mesh *m, output *o)
{
    part a = o->all == iso_forms ? part_of(m, o) : boundary(m, 0);
    FILE *file = start(o, 14.0 * WIDTH * (double)a.cells);
    const tess_int *v;
    double f[HH_FACET_LEN];
    int k;

    fprintf(file, "solid tess\n");
    for (v = a.cell; v < a.cell + 3 * (size_t)a.cells;) {
        hh_facet(a.in->p + 3 * (size_t)v[0], a.in->p + 3 * (size_t)v[1],
                 a.in->p + 3 * (size_t)v[2], f);
        fprintf(file, "facet normal");
        for (k = 0; k < 3; k++) put_behind(file, ' ', f[k]);
        fprintf(file, "\nouter loop\n");
        for (k = 0; k < 3; k++) {
            fprintf(file, "vertex ");
            put_point(file, a.in, *v++, ' ', '\n');
        }
        fprintf(file, "endloop\nendfacet\n");
    }
    fprintf(file, "endsolid tess\n");
    end_part(file, o, &a);
}

/* name_again - of a column whose name an earlier one has, what follows it. */
static const char *name_again(const points *in, int column)
{
    static char text[20];
    int k;

    for (k = 0; k < column && strcmp(in->name[k], in->name[column]) != 0;) k++;
    text[0] = '\0';
    if (k < column) sprintf(text, "_%d", column + 1);
    return text;
}

/* utf8 - bytes of the character at s; 0 if it is none of UTF-8. */
static int utf8(const char *s)
{
    int c = (unsigned char)*s, k;
    int most = c < 128 ? 1 : c < 194 ? 0 : c < 224 ? 2 : c < 240 ? 3 : 4;

    for (k = 1; k < most; k++)
        if (((unsigned char)s[k] & 192) != 128) return 0;
    return c < 245 ? most : 0;
}

/* write_msh - Gmsh's 4.1, as text: one volume, or surface, numbered 1. */
void write_msh(const mesh *m, output *o)
{
    part a = part_of(m, o);
    long n = (long)a.points, cells = (long)a.cells, i;
    FILE *file = start(o, text_size(&a, 2 * a.in->columns));
    const char *s;
    int bytes, k;

    fprintf(file, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 %ld 1 %ld\n"
                  "3 1 0 %ld\n", n, n, n);
    for (i = 1; i <= n; i++) fprintf(file, "%ld\n", i);
    put_points(file, &a, "", 0, 0);
    fprintf(file, "$EndNodes\n$Elements\n1 %ld 1 %ld\n3 1 4 %ld\n", cells,
            cells, cells);
    put_cells(file, &a, 0, 1);
    fprintf(file, "$EndElements\n");
    for (k = 0; k < a.in->columns; k++) {
        fprintf(file, "$NodeData\n1\n\"");
        for (s = a.in->name[k]; *s; s += bytes ? bytes : 1) {
            bytes = utf8(s);
            fprintf(file, "%.*s", bytes, *s == '"' ? "'" : s);
            if (bytes == 0) putc('?', file);
        }
        fprintf(file, "%s\"\n1\n0\n3\n0\n1\n%ld\n", name_again(a.in, k),
                n);
        for (i = 0; i < n; i++) {
            put_before(file, 0, (tess_int)(i + 1));
            put_real(file, value_of(&a, (tess_int)i, k), 0, '\n');
        }
        fprintf(file, "$EndNodeData\n");
    }
    end_part(file, o, &a);
}

/* ---- VTK ---- */

FILE *start_vtk(output *o, const char *title, const char *kind_of, double most,
                double bytes)
{
    FILE *file;

    if (most > 2147483647.0)
        fail("%s: %.0f is beyond the integers of a .vtk file", o->name, most);
    announce(o, bytes, bytes);
    file = start(o, bytes);
    fprintf(file, "# vtk DataFile Version 3.0\n%s\nBINARY\nDATASET %s\n",
            title, kind_of);
    return file;
}

void put_double(FILE *file, double x)
{
    static const int one = 1;
    const char *byte = (const char *)&x;
    size_t last = *(const char *)&one ? sizeof x - 1 : 0, k;

    check_written(file);
    for (k = 0; k < sizeof x; k++) putc(byte[last ? last - k : k], file);
}

void put_int(FILE *file, double i)
{
    unsigned long bits = (unsigned long)i;
    int shift;

    check_written(file);
    for (shift = 24; shift >= 0; shift -= 8)
        putc((int)(bits >> shift & 255), file);
}

void put_scalars(FILE *file, const char *name)
{
    fprintf(file, "SCALARS %s double 1\nLOOKUP_TABLE default\n", name);
}

const char *vtk_name(const points *in, int column)
{
    static char text[3 * TITLE + 20];
    const char *s = in->name[column];
    char *c = text;

    for (; *s; s++)
        c += sprintf(c, *s > ' ' && *s <= '~' && !strchr("\"%", *s) ? "%c"
                                                                    : "%%%02X",
                     (unsigned char)*s);
    strcpy(c, name_again(in, column));
    return text;
}

/* put_coordinates, put_column, put_size - of all points; their values; of all
 * tetrahedra the circumradius, or the volume. */
static void put_coordinates(FILE *file, const part *a)
{
    const tess_real *p;
    tess_int i;
    int k;

    for (i = 0; i < a->points; i++) {
        p = a->in->p + 3 * (size_t)point_of(a, i);
        for (k = 0; k < 3; k++) put_double(file, (double)p[k]);
    }
}

static void put_column(FILE *file, const part *a, int column)
{
    tess_int i;

    for (i = 0; i < a->points; i++) put_double(file, value_of(a, i, column));
}

static void put_size(FILE *file, const mesh *m, int volume)
{
    double c[4];
    tess_int t;

    for (t = 0; t < m->ntet; t++) {
        if (!volume) tess_ball(m->p, m->tet + 4 * t, c);
        put_double(file, volume ? tetrahedron_volume(m, t) : c[3]);
    }
}

static const char *const size_name[] = {"circumradius", "volume"};

void write_vtk(const mesh *m, output *o)
{
    part a = part_of(m, o);
    double n = (double)a.points, cells = (double)a.cells;
    FILE *file = start_vtk(o, "Delaunay tetrahedralization",
                           "UNSTRUCTURED_GRID", n > cells ? n : cells,
                           n * 8.0 * (3.0 + a.in->columns) + 40.0 * cells);
    const tess_int *v = a.cell;
    tess_int i;
    int k;

    fprintf(file, "POINTS %.0f double\n", n);
    put_coordinates(file, &a);
    fprintf(file, "\nCELLS %.0f %.0f\n", cells, (1.0 + a.corners) * cells);
    for (i = 0; i < a.cells; i++) {
        put_int(file, (double)a.corners);
        for (k = 0; k < a.corners; k++) put_int(file, (double)*v++);
    }
    fprintf(file, "\nCELL_TYPES %.0f\n", cells);
    for (i = 0; i < a.cells; i++) put_int(file, a.corners == 4 ? 10.0 : 5.0);
    fprintf(file, "\n");
    if (a.in->columns > 0) fprintf(file, "POINT_DATA %.0f\n", n);
    for (k = 0; k < a.in->columns; k++) {
        put_scalars(file, vtk_name(a.in, k));
        put_column(file, &a, k);
        fprintf(file, "\n");
    }
    if (cells > 0.0 && a.corners == 4) fprintf(file, "CELL_DATA %.0f\n", cells);
    for (k = 0; k < 2 && cells > 0.0 && a.corners == 4; k++) {
        put_scalars(file, size_name[k]);
        put_size(file, m, k);
        fprintf(file, "\n");
    }
    end_part(file, o, &a);
}

void put_long(FILE *file, double i)
{
    put_int(file, floor(i / 4294967296.0));
    put_int(file, fmod(i, 4294967296.0));
}

/* put_array - the head of one of a .vtu file's arrays: its bytes, behind their
 * number, are from *at on. */
static void put_array(FILE *file, const char *type, const char *name,
                      const char *again, int components, double bytes,
                      double *at)
{
    fprintf(file, "<DataArray type=\"%s\" Name=\"%s%s\" NumberOfComponents=\""
                  "%d\" format=\"appended\" offset=\"%.0f\"/>\n",
            type, name, again, components, *at);
    *at += 8.0 + bytes;
}

FILE *start_vtu(output *o, double n, double cells, int corners,
                const points *in, int sizes)
{
    double at = 0.0, bytes = n * 8.0 * (3.0 + in->columns) +
                             cells * (8.0 * (1 + corners + sizes) + 1.0);
    FILE *file;
    int k;

    announce(o, bytes, bytes);
    file = start(o, bytes);
    fprintf(file, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
                  "version=\"1.0\" byte_order=\"BigEndian\" "
                  "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece "
                  "NumberOfPoints=\"%.0f\" NumberOfCells=\"%.0f\">\n<Points>\n",
            n, cells);
    put_array(file, "Float64", "Points", "", 3, 24.0 * n, &at);
    fprintf(file, "</Points>\n<Cells>\n");
    put_array(file, "Int64", "connectivity", "", 1, 8.0 * corners * cells, &at);
    put_array(file, "Int64", "offsets", "", 1, 8.0 * cells, &at);
    put_array(file, "UInt8", "types", "", 1, cells, &at);
    fprintf(file, "</Cells>\n<PointData>\n");
    for (k = 0; k < in->columns; k++)
        put_array(file, "Float64", xml_text(in->name[k]), name_again(in, k), 1,
                  8.0 * n, &at);
    fprintf(file, "</PointData>\n<CellData>\n");
    for (k = 0; k < sizes; k++)
        put_array(file, "Float64", size_name[k], "", 1, 8.0 * cells, &at);
    fprintf(file, "</CellData>\n</Piece>\n</UnstructuredGrid>\n"
                  "<AppendedData encoding=\"raw\">\n_");
    put_long(file, 24.0 * n);
    return file;
}

void put_types(FILE *file, double cells, int corners, int type)
{
    double i;

    put_long(file, 8.0 * cells);
    for (i = 1.0; i <= cells; i += 1.0) put_long(file, i * corners);
    put_long(file, cells);
    for (i = 1.0; i <= cells; i += 1.0) {
        if (fmod(i, 4096.0) == 0.0) check_written(file);
        putc(type, file);
    }
}

void end_vtu(FILE *file)
{
    fprintf(file, "\n</AppendedData>\n</VTKFile>\n");
}

void write_vtu(const mesh *m, output *o)
{
    part a = part_of(m, o);
    double n = (double)a.points, cells = (double)a.cells;
    int sizes = a.corners == 4 ? 2 : 0, k;
    FILE *file = start_vtu(o, n, cells, a.corners, a.in, sizes);
    size_t i;

    put_coordinates(file, &a);
    put_long(file, 8.0 * a.corners * cells);
    for (i = 0; i < (size_t)a.corners * (size_t)a.cells; i++)
        put_long(file, (double)a.cell[i]);
    put_types(file, cells, a.corners, a.corners == 4 ? 10 : 5);
    for (k = 0; k < a.in->columns; k++) {
        put_long(file, 8.0 * n);
        put_column(file, &a, k);
    }
    for (k = 0; k < sizes; k++) {
        put_long(file, 8.0 * cells);
        put_size(file, m, k);
    }
    end_vtu(file);
    end_part(file, o, &a);
}

/* ---- pictures ---- */

const char *xml_text(const char *text)
{
    static char safe[6 * TEXT];
    char *c = safe;
    int k;

    for (; *text && c < safe + sizeof safe - 6; text++)
        if ((k = utf8(text)) > 1) {
            *c++ = *text;
            for (; k > 1; k--) *c++ = *++text;
        } else if (k == 0 || strchr("<>&\"", *text))
            c += sprintf(c, "&#%d;", (unsigned char)*text);
        else
            *c++ = *text < ' ' ? ' ' : *text;
    *c = '\0';
    return safe;
}

/* piece - number k of the texts in a list with commas; length: of it, or 0. */
static const char *piece(const char *list, int k, int *length)
{
    for (*length = 0; list; list += *length + 1, k--) {
        *length = (int)strcspn(list, ",");
        if (k == 0) return list;
        if (!list[*length]) break;
    }
    *length = 0;
    return "";
}

void begin_look(const points *in, draw_look *look)
{
    static char text[4][2 * TITLE + 10];
    const char *unit, *name;
    int k, length;

    draw_default(look);
    for (k = 0; k < 4; k++) {
        unit = piece(chosen.unit, k, &length);
        /* (one for all axes) */
        if (k > 1 && length == 0) unit = piece(chosen.unit, 1, &length);
        if (length > TITLE) length = TITLE;
        name = k > 0 ? in->axis[k - 1] : in->columns > 0 ? in->name[0] : "";
        if (k > 0 && !name[0]) name = look->name[k - 1];
        /* (what has no name, but a unit) */
        if (k == 0 && length > 0 && strcmp(name, "value") == 0) name = "";
        sprintf(text[k], "%s%s%.*s", name, name[0] && length > 0 ? ", " : "",
                length, unit);
        if (k > 0) look->name[k - 1] = text[k];
        if (k > 0 && chosen.scaled) look->scale[k - 1] = chosen.scale[k - 1];
    }
    look->label = text[0];
    look->title = chosen.title;
    look->bare = chosen.bare;
    memcpy(look->range, chosen.range, sizeof look->range);
    if (chosen.pixels[0] > 0.0) {
        look->width = (int)chosen.pixels[0];
        look->height = (int)chosen.pixels[1];
    }
}

void write_svg(const mesh *m, output *o)
{
    static const char *const what[] = {"points", "whole", "cut",
                                       "field", "apart"};
    static char note[400];
    FILE *file = start(o, 0.0);
    const points *in = m->in;
    const tess_int own = chosen.periodic ? repetition()->of.in->n : in->n;
    double *first = 0; /* value of each point; behind the own ones, of copies */
    double side[3], low, high, x;
    tess_int i;
    draw_look look;
    long lost = 0;
    int k;

    begin_look(in, &look);
    if (chosen.view[0] >= -360.0) {
        look.azimuth = chosen.view[0];
        look.elevation = chosen.view[1];
    }
    look.what = m->kept > FEW ? DRAW_CUT : DRAW_APART;
    for (k = 0; k < 5 && chosen.draw; k++)
        if (strcmp(chosen.draw, what[k]) == 0) look.what = k;
    sprintf(note, "%ld points", (long)own);
    if (look.what != DRAW_POINTS)
        sprintf(note + strlen(note), ", %ld tetrahedra", (long)m->kept);
    if (in->columns > 0) first = (double *)space((double)in->n, sizeof *first);
    for (i = 0; i < in->n && first; i++) {
        first[i] = in->value[(size_t)in->columns * (size_t)i];
        if (fabs(first[i]) <= 1e300) continue;
        first[i] = no_number();
        lost += i < own;
    }
    if (lost > 0 && o == next_output(svg_forms, 0))
        warn("%s: %ld value%s of %s %s: not in the picture's scale, and grey",
             in->input, lost, lost > 1 ? "s" : "", in->name[0],
             lost > 1 ? "are no numbers" : "is no number");
    if (lost == (long)own) {
        free(first);
        first = 0;
    }
    if (!first && look.what == DRAW_APART)
        strcat(note, "; coloured by distance from the middle");
    for (k = 0; k < 3; k++) {
        low = high = (double)in->p[k];
        for (i = 1; i < in->n; i++) {
            x = (double)in->p[3 * i + k];
            if (x < low) low = x;
            if (x > high) high = x;
        }
        side[k] = high / 2.0 - low / 2.0;
    }
    draw_even(&look, side, chosen.scaled ? LONGEST : LONGER, note);
    look.note = note;
    /* (copies are for tetrahedra alone) */
    if (draw_svg(file, &look, look.what == DRAW_POINTS ? own : in->n, in->p,
                 first, m->ntet, m->tet, m->adj, m->keep) != 0)
        fail("not enough memory for a picture");
    free(first);
    finish(file, o);
}

