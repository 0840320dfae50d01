/* write.c - the files that build/tess writes.
 *
 * Each is written under another name, which it changes for its own when it is
 * complete.
 */
#if defined(__unix__) || defined(__APPLE__)
#define _POSIX_C_SOURCE 200112L
#include <sys/stat.h>
#define POSIX
#endif

#include "draw.h"
#include "driver.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#define FEW 200    /* tetrahedra that are drawn apart      */
#define MUCH 1e9   /* bytes: from there on it is said      */
#define WIDTH 18.0 /* bytes of a number in a text, about   */

/* ---- files ---- */

int ends_in(const char *name, const char *suffix)
{
    size_t a = strlen(name), b = strlen(suffix);

    if (a < b) return 0;
    for (name += a - b; *suffix && tolower((unsigned char)*name) == *suffix;)
        name++, suffix++;
    return !*suffix;
}

/* What a name may be of: nothing, a file, a symbolic link, something else. */
enum { NOTHING, REGULAR, LINK, OTHER };

static int kind(const char *name)
{
#ifdef POSIX
    struct stat s;

    if (lstat(name, &s) != 0) return NOTHING;
    if (S_ISLNK(s.st_mode)) return LINK;
    return S_ISREG(s.st_mode) || S_ISDIR(s.st_mode) ? REGULAR : OTHER;
#else
    FILE *file = fopen(name, "rb");

    if (file) fclose(file);
    return file ? REGULAR : NOTHING;
#endif
}

int same_file(const char *a, const char *b)
{
#ifdef POSIX
    struct stat s, t;

    if (stat(a, &s) == 0 && stat(b, &t) == 0)
        return s.st_dev == t.st_dev && s.st_ino == t.st_ino &&
               S_ISREG(s.st_mode);
#endif
    while (strncmp(a, "./", 2) == 0) a += 2;
    while (strncmp(b, "./", 2) == 0) b += 2;
    return strcmp(a, b) == 0;
}

/* discard - what leaving the program does to files that are not complete. */
static void discard(void)
{
    output *o = 0;

    while ((o = next_output(0, o)) != 0)
        if (o->begun) remove(o->partial);
}

/* open_output - to write. */
static FILE *open_output(output *o)
{
    FILE *file = fopen(o->partial ? o->partial : o->name, "wb");

    if (!file) fail("%s: %s", o->name, strerror(errno));
    o->begun = o->partial != 0;
    return file;
}

void try_output(output *o)
{
    FILE *file;

    /* standard output, /dev/null, pipes: written as they are */
    if (strcmp(o->name, "-") == 0 || strncmp(o->name, "/dev/", 5) == 0 ||
        kind(o->name) == OTHER)
        return;
    o->partial = (char *)space((double)strlen(o->name) + 6.0, 1);
    strcat(strcpy(o->partial, o->name), ".part");
    if (kind(o->name) == LINK || kind(o->partial) == LINK)
        fail("%s: is a symbolic link, which stays as it is: name the file that "
             "it points to",
             kind(o->name) == LINK ? o->name : o->partial);
    if (kind(o->name) == REGULAR) {
        /* (a directory, or protected) */
        file = fopen(o->name, "r+b");
        if (!file) fail("%s: cannot be written over", o->name);
        fclose(file);
    }
    fclose(open_output(o));
    remove(o->partial);
    o->begun = 0;
}

FILE *start(output *o, double bytes)
{
    static int begun;

    if (!begun++) atexit(discard);
    if (bytes > MUCH)
        warn("%s: about %.1f GB will be written", o->name, bytes / 1e9);
    say("writing %s ...", o->name);
    return strcmp(o->name, "-") == 0 ? stdout : open_output(o);
}

void check_written(FILE *file, const output *o)
{
    if (ferror(file)) fail("%s: write error", o->name);
}

void finish(FILE *file, output *o)
{
    fflush(file);
    check_written(file, o);
    if (file != stdout && fclose(file)) fail("%s: write error", o->name);
    /* (where rename replaces no file, it has to go before) */
    if (o->begun && rename(o->partial, o->name) != 0 &&
        (remove(o->name) != 0 || rename(o->partial, o->name) != 0))
        fail("%s: %s", o->name, strerror(errno));
    o->begun = 0;
    tell("written       %s\n", o->name);
}

void put_real(FILE *file, double x, int narrow, char after)
{
    char text[64];
    double back;
    int digits = narrow ? FLT_DIG : DBL_DIG, most = digits + 3;

    do {
        sprintf(text, "%.*g", digits, x);
        back = strtod(text, (char **)0);
        if (narrow) back = (double)(float)back;
    } while (back != x && digits++ < most);
    fprintf(file, "%s%c", text, after);
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

void write_node(const mesh *m, output *o)
{
    const points *in = m->in;
    const double *v = in->value;
    FILE *file =
        start(o, (double)in->n * (4.0 + (double)in->columns) * WIDTH);
    tess_int i;
    int k;

    fprintf(file, "%ld 3 %d %d\n", (long)in->n, in->columns - in->marker,
            in->marker);
    for (i = 0; i < in->n; i++) {
        fprintf(file, "%ld ", (long)(i + in->base));
        put_point(file, in, i, ' ', in->columns > 0 ? ' ' : '\n');
        for (k = 1; k <= in->columns; k++)
            put_real(file, *v++, 0, k < in->columns ? ' ' : '\n');
    }
    finish(file, o);
}

/* write_four - four numbers a tetrahedron. */
static void write_four(const mesh *m, output *o, const char *head,
                       const tess_int *four)
{
    FILE *file = start(o, (double)m->ntet * 2.0 * WIDTH);
    tess_int t;
    int k;

    fprintf(file, "%ld %s\n", (long)m->ntet, head);
    for (t = 0; t < m->ntet; t++) {
        fprintf(file, "%ld", (long)(t + m->in->base));
        for (k = 0; k < 4; k++)
            fprintf(file, " %ld", four[4 * t + k] < 0
                                      ? -1L
                                      : (long)(four[4 * t + k] + m->in->base));
        fprintf(file, "\n");
    }
    finish(file, o);
}

void write_ele(const mesh *m, output *o)
{
    write_four(m, o, "4 0", m->tet);
}

void write_neigh(const mesh *m, output *o)
{
    write_four(m, o, "4", m->adj);
}

/* Vertices of the facet opposite to each, counter-clockwise from outside. */
static const int facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/* write_face - the boundary's triangles: TetGen's .face, whose points are those
 * of .node; or OBJ, with the boundary's points alone. */
void write_face(const mesh *m, output *o)
{
    int obj = ends_in(o->as->ending, ".obj"), k;
    FILE *file = start(o, (double)m->in->n * 5.0 * WIDTH);
    const points *in = m->in;
    tess_int *place = (tess_int *)space((double)in->n, sizeof *place);
    tess_int many = 0, i, f, v;

    for (i = 0; i < in->n; i++) place[i] = obj ? TESS_NONE : i + in->base;
    for (f = 0; f < 4 * m->ntet; f++) {
        if (m->adj[f] >= 0) continue;
        if (!obj) many++;
        for (k = 0; k < 3 && obj; k++) {
            v = m->tet[f / 4 * 4 + facet[f % 4][k]];
            if (place[v] >= 0) continue;
            place[v] = ++many;
            fprintf(file, "v ");
            put_point(file, in, v, ' ', '\n');
        }
    }
    if (!obj) fprintf(file, "%ld 0\n", (long)many);
    for (i = in->base, f = 0; f < 4 * m->ntet; f++) {
        if (m->adj[f] >= 0) continue;
        if (obj)
            fprintf(file, "f");
        else
            fprintf(file, "%ld", (long)i++);
        for (k = 0; k < 3; k++)
            fprintf(file, " %ld",
                    (long)place[m->tet[f / 4 * 4 + facet[f % 4][k]]]);
        fprintf(file, "\n");
    }
    free(place);
    finish(file, o);
}

/* ---- VTK ---- */

FILE *start_vtk(output *o, const char *title, const char *kind_of, double most,
                double bytes)
{
    FILE *file;

    if (most > 2147483647.0)
        fail("%s: %.0f is beyond the integers of a .vtk file", o->name, most);
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

    for (k = 0; k < sizeof x; k++) putc(byte[last ? last - k : k], file);
}

void put_int(FILE *file, double i)
{
    unsigned long bits = (unsigned long)i;
    int shift;

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
    int k;

    for (; *s; s++)
        c += sprintf(c, *s > ' ' && *s <= '~' && !strchr("\"%", *s) ? "%c"
                                                                    : "%%%02X",
                     (unsigned char)*s);
    for (k = 0; k < column && strcmp(in->name[k], in->name[column]) != 0;) k++;
    if (k < column) sprintf(c, "_%d", column + 1);
    return text;
}

void write_vtk(const mesh *m, output *o)
{
    const points *in = m->in;
    double n = (double)in->n, ntet = (double)m->ntet, c[4];
    FILE *file = start_vtk(o, "Delaunay tetrahedralization",
                           "UNSTRUCTURED_GRID", n > ntet ? n : ntet,
                           n * 8.0 * (double)(3 + in->columns) + 40.0 * ntet);
    tess_int i;
    int k;

    fprintf(file, "POINTS %.0f double\n", n);
    for (i = 0; i < in->n; i++)
        for (k = 0; k < 3; k++) put_double(file, (double)in->p[3 * i + k]);
    fprintf(file, "\nCELLS %.0f %.0f\n", ntet, 5.0 * ntet);
    for (i = 0; i < m->ntet; i++) {
        put_int(file, 4.0);
        for (k = 0; k < 4; k++) put_int(file, (double)m->tet[4 * i + k]);
    }
    fprintf(file, "\nCELL_TYPES %.0f\n", ntet);
    for (i = 0; i < m->ntet; i++) put_int(file, 10.0);
    fprintf(file, "\n");
    if (in->columns > 0) fprintf(file, "POINT_DATA %.0f\n", n);
    for (k = 0; k < in->columns; k++) {
        put_scalars(file, vtk_name(in, k));
        for (i = 0; i < in->n; i++)
            put_double(file,
                       in->value[(size_t)in->columns * (size_t)i + (size_t)k]);
        fprintf(file, "\n");
    }
    if (m->ntet > 0) {
        fprintf(file, "CELL_DATA %.0f\n", ntet);
        put_scalars(file, "circumradius");
        for (i = 0; i < m->ntet; i++) {
            tess_ball(m->p, m->tet + 4 * i, c);
            put_double(file, c[3]);
        }
        fprintf(file, "\n");
        put_scalars(file, "volume");
        for (i = 0; i < m->ntet; i++)
            put_double(file, tetrahedron_volume(m, i));
        fprintf(file, "\n");
    }
    finish(file, o);
}

/* ---- pictures ---- */

/* part - number k of the texts in a list with commas; length: of it, or 0. */
static const char *part(const char *list, int k, int *length)
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
        unit = part(chosen.unit, k, &length);
        /* (one for all axes) */
        if (k > 1 && length == 0) unit = part(chosen.unit, 1, &length);
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
    double *first = 0; /* value of each point */
    double side[3], low, high, x;
    tess_int i;
    draw_look look;
    int k;

    begin_look(in, &look);
    if (chosen.view[0] >= -360.0) {
        look.azimuth = chosen.view[0];
        look.elevation = chosen.view[1];
    }
    look.what = m->kept > FEW ? DRAW_CUT : DRAW_APART;
    for (k = 0; k < 5 && chosen.draw; k++)
        if (strcmp(chosen.draw, what[k]) == 0) look.what = k;
    sprintf(note, "%ld points", (long)in->n);
    if (look.what != DRAW_POINTS)
        sprintf(note + strlen(note), ", %ld tetrahedra", (long)m->kept);
    if (in->columns == 0 && look.what == DRAW_APART)
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
    if (in->columns > 0) first = (double *)space((double)in->n, sizeof *first);
    for (i = 0; i < in->n && first; i++)
        first[i] = in->value[(size_t)in->columns * (size_t)i];
    if (draw_svg(file, &look, in->n, in->p, first, m->ntet, m->tet, m->adj,
                 m->keep) != 0)
        fail("not enough memory for a picture");
    free(first);
    finish(file, o);
}

