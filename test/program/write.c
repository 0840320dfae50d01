/* write.c - the files that build/tess writes.
 *
 * Each is written under another name, which it changes for its own when it is
 * complete.
 */
#include "draw.h"
#include "driver.h"

#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>

#define FEW 200 /* tetrahedra that are drawn apart */

static char partial[NAME + 8]; /* name of what is being written, or "" */

/* ---- files ---- */

/* device - /dev/null, /dev/stdout and the like are written as they are. */
static int device(const char *name)
{
    return strncmp(name, "/dev/", 5) == 0;
}

static void name_partial(const char *name)
{
    if (strlen(name) > NAME) fail("%.40s...: the name is too long", name);
    strcat(strcpy(partial, name), ".part");
}

/* discard - what leaving the program does to a file that is not complete. */
static void discard(void)
{
    if (partial[0]) remove(partial);
}

void try_output(const char *name)
{
    FILE *file;

    if (device(name)) return;
    file = fopen(name, "rb");
    if (file) {
        fclose(file);
        /* a directory, or protected */
        file = fopen(name, "r+b");
        if (!file) fail("%s: cannot be written over", name);
        fclose(file);
    }
    name_partial(name);
    file = fopen(partial, "wb");
    if (!file) {
        partial[0] = '\0';
        fail("%s: %s", name, strerror(errno));
    }
    fclose(file);
    remove(partial);
    partial[0] = '\0';
}

FILE *start(const char *name, const char *mode)
{
    static int begun;
    FILE *file;

    if (!begun) atexit(discard);
    begun = 1;
    if (!device(name)) name_partial(name);
    file = fopen(partial[0] ? partial : name, mode);
    if (!file) {
        partial[0] = '\0';
        fail("%s: %s", name, strerror(errno));
    }
    say("writing %s ...", name);
    return file;
}

void finish(FILE *file, const char *name)
{
    int bad = ferror(file);

    if (fclose(file) || bad) fail("%s: write error", name);
    /* (where rename replaces no file, it has to go before) */
    if (partial[0] && rename(partial, name) != 0 &&
        (remove(name) != 0 || rename(partial, name) != 0))
        fail("%s: %s", name, strerror(errno));
    partial[0] = '\0';
    if (!chosen.quiet) printf("written       %s\n", name);
}

/* put_real - x, which was a float if narrow, with as few digits as give it
 * back. */
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

void write_node(const mesh *m, const char *name)
{
    FILE *file = start(name, "w");
    const points *in = m->in;
    const double *v = in->value;
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
    finish(file, name);
}

/* write_four - .ele or .neigh: four numbers a tetrahedron. */
void write_four(const mesh *m, const char *name, const char *head,
                const tess_int *four)
{
    FILE *file = start(name, "w");
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
    finish(file, name);
}

/* Vertices of the facet opposite to each, counter-clockwise from outside. */
static const int facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/* write_face - the boundary's triangles: TetGen's .face, whose points are those
 * of .node; or OBJ, with the boundary's points alone. */
void write_face(const mesh *m, const char *name)
{
    static const char suffix[] = ".obj";
    size_t length = strlen(name);
    int obj = length >= 4 && strcmp(name + length - 4, suffix) == 0, k;
    FILE *file = start(name, "w");
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
    finish(file, name);
}

/* put_bytes - the bytes of a number, the most significant first, as VTK's
 * binary files have them. */
void put_bytes(FILE *file, const void *number, int size)
{
    static const int one = 1;
    const char *byte = (const char *)number;
    int little = *(const char *)&one, k;

    for (k = 0; k < size; k++) putc(byte[little ? size - 1 - k : k], file);
}

void put_double(FILE *file, double x, char after)
{
    if (chosen.binary)
        put_bytes(file, &x, (int)sizeof x);
    else
        put_real(file, x, 0, after);
}

/* put_int - VTK's int has 4 bytes. */
static void put_int(FILE *file, tess_int i, char after)
{
    unsigned long bits = (unsigned long)i;
    int shift;

    if (!chosen.binary)
        fprintf(file, "%ld%c", (long)i, after);
    else
        for (shift = 24; shift >= 0; shift -= 8)
            putc((int)(bits >> shift & 255), file);
}

void put_name(FILE *file, const char *name)
{
    for (; *name; name++)
        putc(*name > ' ' && *name <= '~' && *name != '"' ? *name : '_', file);
}

/* write_sizes - VTK's data of each tetrahedron. */
static void write_sizes(FILE *file, const mesh *m, const char *end)
{
    tess_int t;
    double c[4];

    fprintf(file,
            "CELL_DATA %ld\nSCALARS circumradius double 1\n"
            "LOOKUP_TABLE default\n",
            (long)m->ntet);
    for (t = 0; t < m->ntet; t++) {
        tess_ball(m->p, m->tet + 4 * t, c);
        put_double(file, c[3], '\n');
    }
    fprintf(file, "%sSCALARS volume double 1\nLOOKUP_TABLE default\n", end);
    for (t = 0; t < m->ntet; t++)
        put_double(file, tetrahedron_volume(m, t), '\n');
    fprintf(file, "%s", end);
}

void write_vtk(const mesh *m, const char *name)
{
    FILE *file = start(name, chosen.binary ? "wb" : "w");
    const char *end = chosen.binary ? "\n" : ""; /* of a block */
    const points *in = m->in;
    tess_int i;
    int k;

    fprintf(file,
            "# vtk DataFile Version 3.0\n"
            "Delaunay tetrahedralization\n"
            "%s\n"
            "DATASET UNSTRUCTURED_GRID\n"
            "POINTS %ld double\n",
            chosen.binary ? "BINARY" : "ASCII", (long)in->n);
    for (i = 0; i < in->n; i++)
        if (chosen.binary)
            for (k = 0; k < 3; k++)
                put_double(file, (double)in->p[3 * i + k], 0);
        else
            put_point(file, in, i, ' ', '\n');
    fprintf(file, "%sCELLS %ld %.0f\n", end, (long)m->ntet,
            5.0 * (double)m->ntet);
    for (i = 0; i < m->ntet; i++) {
        put_int(file, 4, ' ');
        for (k = 0; k < 4; k++)
            put_int(file, m->tet[4 * i + k], k < 3 ? ' ' : '\n');
    }
    fprintf(file, "%sCELL_TYPES %ld\n", end, (long)m->ntet);
    for (i = 0; i < m->ntet; i++) put_int(file, 10, '\n');
    fprintf(file, "%s", end);
    if (in->columns > 0) fprintf(file, "POINT_DATA %ld\n", (long)in->n);
    for (k = 0; k < in->columns; k++) {
        fprintf(file, "SCALARS ");
        put_name(file, in->name[k]);
        fprintf(file, " double 1\nLOOKUP_TABLE default\n");
        for (i = 0; i < in->n; i++)
            put_double(file, in->value[(long)in->columns * i + k], '\n');
        fprintf(file, "%s", end);
    }
    if (m->ntet > 0) write_sizes(file, m, end);
    finish(file, name);
}

const char *xml_text(const char *text)
{
    static char safe[6 * TITLE];
    char *c = safe;

    for (; *text && c < safe + sizeof safe - 6; text++)
        if (strchr("<>&\"", *text) || (*text > 0 && *text < ' '))
            c += sprintf(c, "&#%d;", *text < ' ' ? ' ' : *text);
        else
            *c++ = *text;
    *c = '\0';
    return safe;
}

void write_svg(const mesh *m, const char *name)
{
    static char note[120];
    FILE *file = start(name, "w");
    const points *in = m->in;
    tess_int drawn = m->kept, i;
    double *first = 0; /* value of each point */
    draw_look look;

    draw_default(&look);
    if (chosen.view[0] >= -360.0) {
        look.azimuth = chosen.view[0];
        look.elevation = chosen.view[1];
    }
    look.keep = m->keep;
    look.shrink = drawn > FEW ? 1.0 : 0.72;
    look.cut = drawn > FEW;
    look.label = xml_text(in->name[0]);
    sprintf(note, "%ld points, %ld tetrahedra%s", (long)in->n, (long)drawn,
            in->columns > 0 ? "" : "; coloured by distance from the middle");
    look.note = note;
    if (in->columns > 0) first = (double *)space((double)in->n, sizeof *first);
    for (i = 0; i < in->n && first; i++)
        first[i] = in->value[(size_t)in->columns * (size_t)i];
    if (draw_svg(file, &look, in->n, m->p, first, m->ntet, m->tet, m->adj) != 0)
        fail("not enough memory for a picture");
    free(first);
    finish(file, name);
}

