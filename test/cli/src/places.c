/* places.c - the values at the places of a grid or of a file, into files: CSV,
 * NumPy's own, VTK, or a picture.  They are written as they are computed, some
 * thousand at a time.
 */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "draw/draw.h"
#include "driver.h"
#include "values.h"

#define FEW 4096    /* places at a time, at most */
#define ROOM 32768L /* and values                */
#define MOST 2147483647.0 /* places of a grid    */
#define PIXELS 2000.0 /* of a picture's side     */

/* What is asked for. */
static double size[3], corner[6]; /* of the grid: NX, NY, NZ, X0 to Z1; */
static double step[3], edge[3]; /* by -step: of blocks, or 0; their begin */
static int given[3], asked[METHODS], method, outside; /* axes, by -grid */
static int side[2]; /* of a picture, to the right and up: which axes */
static double number;

static const points *in;
static points *places;
static mesh flat;      /* of points in a plane */
static double *mean;   /* the points' values, where there are duplicates */
static tess_int *same; /* the points that stand for them */
static tess_int t[FEW];
static double done, bare; /* places; those without a value */
static char *texts; /* other columns of some places, one behind the other */

/* sink - a file that values go to. */
typedef struct sink {
    output *to;
    int form; /* which of values_forms: */
    FILE *file;
    FILE *scratch;   /* what VTK must have column by column */
    double *picture; /* the first column; least, most of what is inside */
    double range[2];
} sink;

static sink *sinks;
static int files; /* of them */
static int uncut; /* places outside have values until they are drawn: a picture
                   * ends where the tetrahedra do, not at a place */

#define CSV 0
#define NPY 1
#define VTU 2
#define VTK 3
#define SVG 4

/* --------------------------------------------------------------- options */

/* choose_methods - linear, if nothing is asked for. */
static void choose_methods(void)
{
    const char *s = chosen.method ? chosen.method : method_name[0];
    size_t length;
    int k, many = 0;

    for (;; s += length + 1) {
        length = strcspn(s, ",");
        for (k = 0; k < METHODS; k++)
            if (strncmp(s, method_name[k], length) == 0 &&
                strlen(method_name[k]) == length)
                break;
        if (k == METHODS)
            fail("-method %.*s: choose linear, smooth, natural or nearest",
                 (int)length, s);
        many += !asked[k];
        asked[k] = 1;
        method = k;
        if (!s[length]) break;
    }
    if (many > 1 && chosen.values)
        fail("-values: choose one -method; a list of them is for -validate");
}

double no_number(void)
{
    char *end;
    double x = strtod("nan", &end); /* if it knows that */

    return *end ? 0.0 * strtod("1e999", &end) : x;
}

static void choose_outside(void)
{
    number = no_number();
    if (!chosen.outside) return;
    if (strcmp(chosen.outside, "nearest") == 0) {
        outside = OUT_NEAREST;
        if (chosen.alpha > 0.0)
            fail("-outside nearest knows the hull, not the shape of -alpha: "
                 "choose a number");
        return;
    }
    list_numbers("-outside", chosen.outside, 1, &number);
}

/* block_axis - the grid's places are the centres of blocks of that side. */
static void block_axis(int k, double from, double to, double side_of_block)
{
    double many = (to - from) / side_of_block;

    if (!(many > 0.0) || !(many + 0.5 <= (double)INT_MAX))
        fail("-grid: from %c0 = %g to %c1 = %g are no blocks of %g",
             "XYZ"[k], from, "XYZ"[k], to, side_of_block);
    size[k] = floor(many + 0.5);
    if (size[k] < 1.0)
        fail("-grid: from %c0 = %g to %c1 = %g is less than half a block "
             "of %g",
             "XYZ"[k], from, "XYZ"[k], to, side_of_block);
    step[k] = side_of_block;
    edge[k] = from;
    corner[2 * k] = from + step[k] / 2.0;
    corner[2 * k + 1] = from + (size[k] - 0.5) * step[k];
    given[k] = 1;
    if (fabs(many - size[k]) > 1e-6 * size[k])
        warn("-grid: from %c0 = %.15g to %c1 = %.15g are %.6g blocks of "
             "%.15g: %.0f are made, to %.15g",
             "XYZ"[k], from, "XYZ"[k], to, many, step[k], size[k],
             from + size[k] * step[k]);
}

/* place_axis - so many places from side to side. */
static void place_axis(int k, double many)
{
    if (!(many >= 1.0 && many <= (double)INT_MAX) || many != (double)(int)many)
        fail("-grid: NX, NY, NZ are whole numbers from 1 on");
    size[k] = many;
}

static void end_axis(int k, double from, double to)
{
    corner[2 * k] = from;
    corner[2 * k + 1] = to;
    given[k] = 1;
    if (!(from < to) && !(size[k] == 1.0 && from == to))
        fail("-grid: %c0 must be less than %c1%s", "XYZ"[k], "XYZ"[k],
             from == to ? ", or the same where there is one place" : "");
}

static const char for_space[] =
    "-grid NX,NY,NZ is for points in space: -grid NX,NY if two columns are "
    "their coordinates";

/* choose_axes - each is N, or FROM:TO:N, or FROM:TO/SIDE, of blocks. */
static void choose_axes(void)
{
    const char *s = chosen.grid;
    char text[80], *mark, *second;
    double x[3];
    size_t length;
    int k, many = 0, blocks;

    if (chosen.steps)
        fail("-step: -grid has the blocks' sides where it has FROM:TO, as "
             "FROM:TO/SIDE");
    size[2] = 1.0;
    for (k = 0; many == 0 || s[-1] == ','; k++) {
        length = strcspn(s, ",");
        text[0] = '\0';
        strncat(text, s, length < sizeof text ? length : 0);
        mark = strchr(text, ':');
        second = mark ? strpbrk(mark + 1, ":/") : 0;
        blocks = second && *second == '/';
        if (mark) *mark = ',';
        if (second) *second = ',';
        many = k < 3 && text[0] ? list_numbers("-grid", text, 3, x) : 0;
        if (many != (mark ? 3 : 1))
            fail("-grid %s: two axes or three, each N, FROM:TO:N or "
                 "FROM:TO/SIDE", chosen.grid);
        if (blocks) block_axis(k, x[0], x[1], x[2]);
        else place_axis(k, x[many - 1]);
        if (many == 3 && !blocks) end_axis(k, x[0], x[1]);
        s += length + (s[length] == ',');
    }
    if (k == 1)
        fail("-grid %s: two axes or three, each N, FROM:TO:N or FROM:TO/SIDE",
             chosen.grid);
    if (k == 2) chosen.plane = given[2] = 1;
    else if (chosen.plane) fail("%s", for_space);
}

/* choose_blocks - the same for each axis, the sides by -step. */
static void choose_blocks(void)
{
    double x[7];
    int ends = list_numbers("-grid", chosen.grid, 7, x), k;

    if (ends != 2 * chosen.steps)
        fail("-step %s: -grid %s says where the blocks begin and end",
             chosen.steps == 3 ? "SX,SY,SZ" : "SX,SY",
             chosen.steps == 3 ? "X0,X1,Y0,Y1,Z0,Z1" : "X0,X1,Y0,Y1");
    if (chosen.steps == 2) chosen.plane = given[2] = 1;
    if (chosen.steps == 3 && chosen.plane)
        fail("-step SX,SY,SZ is for points in space: -step SX,SY if two "
             "columns are their coordinates");
    size[2] = 1.0;
    for (k = 0; k < chosen.steps; k++)
        block_axis(k, x[2 * k], x[2 * k + 1], chosen.step[k]);
}

/* choose_places - so many from side to side. */
static void choose_places(void)
{
    double x[9];
    int many = list_numbers("-grid", chosen.grid, 9, x), k;

    if (many != 3 && many != 9 && many != 2 && many != 6)
        fail("-grid needs NX,NY,NZ, or X0:X1:NX,Y0:Y1:NY,Z0:Z1:NZ; for points "
             "in a plane NX,NY, or X0:X1:NX,Y0:Y1:NY");
    if (many == 2 || many == 6) {
        chosen.plane = 1;
        for (k = 6; k > 2; k--) x[k] = x[k - 1];
        x[2] = 1.0;
        x[7] = x[8] = 0.0;
        many = many == 2 ? 3 : 9;
    } else if (chosen.plane) {
        fail("%s", for_space);
    }
    for (k = 0; k < 3; k++) place_axis(k, x[k]);
    for (k = 0; k < 3 && many == 9; k++)
        end_axis(k, x[3 + 2 * k], x[4 + 2 * k]);
}

static void choose_grid(void)
{
    if (strchr(chosen.grid, ':'))
        choose_axes();
    else if (chosen.steps)
        choose_blocks();
    else
        choose_places();
    if (size[0] * size[1] * size[2] > MOST)
        fail("-grid: %.0f places are more than %.0f: %.0f bytes (%.1f GB) a "
             "column; take slices, as of %s",
             size[0] * size[1] * size[2], MOST,
             8.0 * size[0] * size[1] * size[2],
             8e-9 * size[0] * size[1] * size[2],
             step[2] > 0.0 ? "Z1 = Z0 + SZ" : "NZ = 1, Z0 = Z1");
}

/* choose_slice - which axes a picture has. */
static void choose_slice(void)
{
    int k, found = 0;

    for (k = 0; k < 3; k++) {
        if (size[k] == 1.0) continue;
        if (found < 2) side[found] = k;
        found++;
    }
    if (found != 2)
        fail("-values F.svg: a picture is of a slice: one of NX, NY, NZ is 1, "
             "the others are not");
    for (k = 0; k < 2; k++)
        if (size[side[k]] > PIXELS)
            fail("-values F.svg: a picture has at most %.0f places a side",
                 PIXELS);
}

void check_values(void)
{
    output *o;
    int csv = 0;

    if (chosen.grid && chosen.query)
        fail("-grid or -query: choose one of them");
    if ((chosen.grid || chosen.query) && !chosen.values)
        fail("%s needs -values F, a file to write",
             chosen.grid ? "-grid" : "-query");
    if (chosen.values && !chosen.grid && !chosen.query)
        fail("-values needs places: -grid NX,NY,NZ or -query F");
    if (chosen.qcols && !chosen.query) fail("-qcols is for -query F");
    if (chosen.steps && !chosen.grid)
        fail("-step needs -grid X0,X1,Y0,Y1,Z0,Z1, where the blocks begin and "
             "end");
    if ((chosen.within > 0.0 || chosen.drop) && !chosen.values)
        fail("%s is for -values", chosen.drop ? "-drop" : "-within");
    if (!chosen.validate && (chosen.by || next_output(errors_forms, 0)))
        fail("%s is for -validate", chosen.by ? "-by" : "-errors");
    if (!chosen.values && !chosen.validate) {
        if (chosen.plane)
            fail("%s: points in a plane have no tetrahedra, but values: add "
                 "-grid NX,NY -values F, -query P -values F or -validate%s",
                 chosen.cols ? "-cols" : "-plane",
                 chosen.cols ? "; for points in space three columns" : "");
        if (chosen.method || chosen.outside || chosen.clip)
            fail("%s is for -values or -validate",
                 chosen.method    ? "-method"
                 : chosen.outside ? "-outside"
                                  : "-clip");
        if (chosen.digits) fail("-digits is for -values F.csv");
        return;
    }
    if (chosen.validate && chosen.alpha > 0.0)
        warn("-validate is of the whole hull, -alpha of what is written");
    choose_methods();
    choose_outside();
    if (chosen.grid) choose_grid();
    if (chosen.plane && chosen.alpha > 0.0)
        fail("-alpha is for points in space, not for those in a plane");
    for (o = 0; (o = next_output(values_forms, o)) != 0;) {
        if (o->as - values_forms >= VTK && !chosen.grid)
            fail("-values %s: %s is for a -grid; choose .csv, .npy or .vtu",
                 o->name, o->as->ending);
        if (o->as - values_forms == SVG) choose_slice();
        csv |= o->as - values_forms == CSV;
    }
    if (chosen.digits && !csv) fail("-digits is for -values F.csv");
    if (chosen.drop && !csv) fail("-drop is for -values F.csv");
    if (chosen.query && strcmp(chosen.query, "-") == 0 &&
        (!chosen.input || strcmp(chosen.input, "-") == 0))
        fail("points and places cannot both be standard input");
}

/* ---------------------------------------------------------------- places */

/* place - coordinate k of the grid's place i. */
static double place(int k, long i)
{
    double low = corner[2 * k], high = corner[2 * k + 1];

    /* (from the side, lest half a step be rounded) */
    if (step[k] > 0.0) return edge[k] + ((double)i + 0.5) * step[k];
    if (size[k] == 1.0) return low + (high - low) / 2.0;
    return (double)i == size[k] - 1.0
               ? high
               : low + (high - low) * ((double)i / (size[k] - 1.0));
}

/* box - for axes of a grid that have none: that of the points, or of the cell
 * that repeats itself. */
static void box(void)
{
    double of[6] = {0.0}, x;
    tess_int i;
    int k;

    for (k = 0; k < 3; k++)
        for (i = 0; i < in->n; i++) {
            x = (double)in->p[3 * (size_t)i + (size_t)k];
            if (i == 0 || x < of[2 * k]) of[2 * k] = x;
            if (i == 0 || x > of[2 * k + 1]) of[2 * k + 1] = x;
        }
    if (chosen.periodic) cell_box(of);
    for (k = 0; k < 6; k++)
        if (!given[k / 2]) corner[k] = of[k];
}

static double places_asked(void)
{
    return chosen.grid ? size[0] * size[1] * size[2] : places->all;
}

/* in_range - is the coordinate, stretched, no infinity? */
static int in_range(double x, int k)
{
    tess_real y = (tess_real)(chosen.scaled ? x * chosen.scale[k] : x);

    return y - y == (tess_real)0;
}

/* check_files - leave if the files of values, or what they need beside, are too
 * large for the disk. */
static void check_files(void)
{
    double columns = (double)in->columns, n = places_asked(), numbers;
    output *o;
    int kind, k, methods = 0;

    for (o = 0; (o = next_output(values_forms, o)) != 0;) {
        kind = (int)(o->as - values_forms);
        if (kind == SVG) continue;
        numbers = columns;
        if (kind == VTU) numbers += 3.0;
        if (kind == CSV) numbers += (double)in->axes;
        announce(o, (kind == CSV ? 20.0 : 8.0) * numbers * n,
               (kind == CSV ? 2.0 : 8.0) * numbers * n);
        if ((kind == VTK || kind == VTU) && in->columns > 1)
            fclose(open_scratch(o->name, 8.0 * columns * n));
    }
    for (k = 0; k < METHODS; k++) methods += asked[k];
    for (o = 0; (o = next_output(errors_forms, o)) != 0;) {
        numbers = (4.0 + columns * (1.0 + methods)) * (double)in->n;
        announce(o, 20.0 * numbers, 2.0 * numbers);
    }
}

void read_places(points *query)
{
    places = query;
    if (!chosen.query) return;
    query->axes = chosen.plane ? 2 : chosen.qcols ? 3 : 0;
    read_points(chosen.query, query);
    if (query->axes == 2 && !chosen.plane)
        warn("%s: places in a plane: so are the points, whose first two "
             "numbers are coordinates, all others values",
             query->input);
    if (query->axes == 2) chosen.plane = 1;
}

void check_points(const points *points_read)
{
    size_t j;
    long bad = 0;
    int k;

    in = points_read;
    if (!chosen.values && !chosen.validate) return;
    if (in->columns == 0)
        fail("%s: the points have no values to interpolate (-cols X,Y,Z,V "
             "names columns; in a plane -cols X,Y)",
             in->input);
    if (chosen.validate > (long)in->n && !chosen.by)
        fail("-validate %ld: there are only %ld points", chosen.validate,
             (long)in->n);
    for (j = 0; j < (size_t)in->columns * (size_t)in->n; j++) {
        bad += !(fabs(in->value[j]) <= DBL_MAX);
        if (in->value[j] != in->value[j])
            fail("%s, line %ld: %s is NaN: -skip drops such rows; -cols "
                 "X,Y,Z,VALUE asks for one column's values",
                 in->input, in->line[j / (size_t)in->columns],
                 in->name[j % (size_t)in->columns]);
    }
    if (bad > 0)
        warn("%s: %ld value%s not finite, and so is what is computed from "
             "them%s",
             in->input, bad, bad > 1 ? "s are" : " is",
             asked[SMOOTH] ? ", by -method smooth all of the column" : "");
    if (chosen.grid) box();
    for (k = 0; k < 3 && chosen.grid; k++)
        if (!(corner[2 * k + 1] - corner[2 * k] <= DBL_MAX))
            fail("-grid: from %c0 = %g to %c1 = %g is farther than numbers "
                 "reach: choose less",
                 "XYZ"[k], corner[2 * k], "XYZ"[k], corner[2 * k + 1]);
    for (k = 0; k < 6 && chosen.grid; k++)
        if (!in_range(corner[k], k / 2))
            fail("-scale: the grid's %c%d = %g is beyond the range of numbers",
                 "XYZ"[k / 2], k % 2, corner[k]);
    check_files();
}

/* ----------------------------------------------------------------- files */

void put_name(FILE *file, const char *s)
{
    int quoted = strpbrk(s, ",;|\" \t\r\n") != 0 || (*s && strchr("#%!/", *s));

    if (quoted) putc('"', file);
    for (; *s; s++) {
        if (*s == '"') putc('"', file);
        putc(*s, file);
    }
    if (quoted) putc('"', file);
}

void put_title(FILE *file, const char *name)
{
    putc(',', file);
    put_name(file, name);
}

/* npy_head - version 1.0: a text as Python writes a dictionary, such that the
 * numbers begin at a multiple of 64. */
static void npy_head(FILE *file)
{
    static const double one = 1.0;
    int big = ((const char *)&one)[0] != 0, k, length;
    char text[200];

    length = sprintf(text, "{'descr': '%cf%d', 'fortran_order': False, "
                           "'shape': (",
                     big ? '>' : '<', (int)sizeof(double));
    if (chosen.grid)
        for (k = in->axes - 1; k >= 0; k--)
            length += sprintf(text + length, "%.0f, ", size[k]);
    else
        length += sprintf(text + length, "%.0f, ", places->all);
    length += sprintf(text + length, "%d), }", in->columns);
    while ((10 + length + 1) % 64 != 0) text[length++] = ' ';
    text[length++] = '\n';
    fwrite("\223NUMPY\001", 1, 7, file);
    putc(0, file);
    putc(length % 256, file);
    putc(length / 256, file);
    fwrite(text, 1, (size_t)length, file);
}

static void vtk_head(FILE *file)
{
    double way;
    int k;

    fprintf(file, "DIMENSIONS %.0f %.0f %.0f\nORIGIN", size[0], size[1],
            size[2]);
    for (k = 0; k < 3; k++) put_behind(file, ' ', place(k, 0));
    fprintf(file, "\nSPACING");
    for (k = 0; k < 3; k++) {
        way = corner[2 * k + 1] - corner[2 * k];
        if (size[k] > 1.0) way /= size[k] - 1.0;
        if (step[k] > 0.0) way = step[k];
        put_behind(file, ' ', way > 0.0 ? way : 1.0);
    }
    fprintf(file, "\nPOINT_DATA %.0f\n", places_asked());
}

/* put_corners - of a cell of the grid, which has stride[k] places from each one
 * to the next along axis k: as VTK orders those of hexahedra, once around and
 * once above, since pixels and voxels, which ascend, others do not read. */
static void put_corners(FILE *file, const double *cell, const double *stride,
                        int corners)
{
    double at;
    int c, k, bit;

    for (c = 0; c < corners; c++) {
        for (at = 0.0, bit = c ^ (c >> 1 & 1), k = 0; k < 3; k++) {
            at += stride[k] * (cell[k] + (size[k] > 1.0 && bit & 1));
            if (size[k] > 1.0) bit >>= 1;
        }
        put_long(file, at);
    }
}

/* vtu_head - the places; and as cells those of the grid, hexahedra,
 * quadrangles or lines, or the places themselves. */
static FILE *vtu_head(output *o)
{
    static const int type[] = {1, 3, 9, 12};
    double cells = 1.0, x[3], stride[3], most[3], i;
    int sides = 0, k;
    size_t j;
    FILE *file;

    for (k = 0; k < 3 && chosen.grid; k++) {
        sides += size[k] > 1.0;
        most[k] = size[k] > 1.0 ? size[k] - 1.0 : 1.0;
        cells *= most[k];
        stride[k] = k > 0 ? stride[k - 1] * size[k - 1] : 1.0;
    }
    if (!chosen.grid) cells = places->all;
    file = start_vtu(o, places_asked(), cells, 1 << sides, in, 0);
    for (i = 0.0; i < cells && !chosen.grid; i += (double)places->n) {
        next_places(places, i == 0.0);
        for (j = 0; j < 3 * (size_t)places->n; j++)
            put_double(file, (double)places->p[j]);
    }
    for (x[2] = 0.0; x[2] < size[2]; x[2] += 1.0)
        for (x[1] = 0.0; x[1] < size[1]; x[1] += 1.0)
            for (x[0] = 0.0; x[0] < size[0]; x[0] += 1.0)
                for (k = 0; k < 3; k++)
                    put_double(file, (double)(tess_real)place(k, (long)x[k]));
    put_long(file, 8.0 * (1 << sides) * cells);
    for (i = 0.0; i < cells && !chosen.grid; i += 1.0) put_long(file, i);
    for (x[2] = 0.0; chosen.grid && x[2] < most[2]; x[2] += 1.0)
        for (x[1] = 0.0; x[1] < most[1]; x[1] += 1.0)
            for (x[0] = 0.0; x[0] < most[0]; x[0] += 1.0)
                put_corners(file, x, stride, 1 << sides);
    put_types(file, cells, 1 << sides, type[sides]);
    return file;
}

/* column_head - what is before a column of values. */
static void column_head(const sink *s, int column)
{
    if (s->form == VTK)
        put_scalars(s->file, vtk_name(in, column));
    else
        put_long(s->file, 8.0 * places_asked());
}

/* head - open a file, and write what is before the values. */
static void head(sink *s)
{
    double columns = (double)in->columns;
    char title[60];
    int k;

    if (s->form == VTK) {
        sprintf(title, "Interpolated values, %s%s", method_name[method],
                step[0] + step[1] + step[2] > 0.0 ? ", at blocks' centres"
                                                  : "");
        s->file = start_vtk(s->to, title, "STRUCTURED_POINTS", 0.0,
                            8.0 * columns * places_asked());
        vtk_head(s->file);
    } else if (s->form == VTU) {
        s->file = vtu_head(s->to);
    }
    if (s->file) {
        if (in->columns == 1) {
            column_head(s, 0);
            return;
        }
        /* VTK has column by column what is computed place by place */
        s->scratch = open_scratch(s->to->name, 8.0 * columns * places_asked());
        return;
    }
    s->file = start(s->to, 0.0);
    if (s->form == CSV) {
        put_axes(s->file, in, in->axes);
        if (chosen.query && places->others)
            fprintf(s->file, ",%s", places->others);
        for (k = 0; k < in->columns; k++) put_title(s->file, in->name[k]);
        putc('\n', s->file);
    } else if (s->form == NPY) {
        npy_head(s->file);
    } else {
        s->picture = (double *)space(places_asked(), sizeof *s->picture);
        s->range[0] = DBL_MAX;
        s->range[1] = -DBL_MAX;
    }
}

const char *next_text(const points *a)
{
    static char *text;
    static size_t room;
    size_t length = 0;
    int c;

    while ((c = getc(a->texts)) != '\n') {
        if (c == EOF) fail("%s: a temporary file cannot be read", a->input);
        if (length + 2 > room)
            text = (char *)more_space(text, (double)(room = 2 * room + 80), 1);
        text[length++] = (char)c;
    }
    text[length] = '\0';
    return text;
}

/* read_texts - of the next places in a file, into texts. */
static void read_texts(tess_int many)
{
    static size_t room;
    size_t length, filled = 0;
    const char *text;

    for (; many > 0; many--, filled += length) {
        text = next_text(places);
        length = strlen(text) + 1;
        if (filled + length > room)
            texts = (char *)more_space(
                texts, (double)(room = 2 * (filled + length)), 1);
        memcpy(texts + filled, text, length);
    }
}

/* valued - has the place a value? */
static int valued(const double *out)
{
    int k;

    for (k = 0; k < in->columns && out[k] != out[k];) k++;
    return k < in->columns;
}

/* put - the values at some places. */
static void put(sink *s, tess_int many, const tess_real *at,
                const double *out)
{
    size_t numbers = (size_t)many * (size_t)in->columns, i;
    static char text[3][REAL]; /* of coordinates: in a grid most come again */
    static tess_real written[3];
    const char *text_at = texts, *others;
    int k;

    if (s->form == NPY || s->scratch) {
        fwrite(out, sizeof *out, numbers, s->scratch ? s->scratch : s->file);
    } else if (s->form == VTK || s->form == VTU) {
        for (i = 0; i < numbers; i++) put_double(s->file, out[i]);
    } else if (s->form == SVG) {
        for (i = 0; i < (size_t)many; i++, out += in->columns) {
            s->picture[(size_t)done + i] = *out;
            if ((uncut && t[i] < 0) || !(fabs(*out) <= 1e300)) continue;
            if (*out < s->range[0]) s->range[0] = *out;
            if (*out > s->range[1]) s->range[1] = *out;
        }
    } else {
        for (; many > 0; many--, at += 3) {
            check_written(s->file);
            /* (they may be empty) */
            others = places->others && chosen.query ? text_at : 0;
            if (others) text_at += strlen(text_at) + 1;
            if (chosen.drop && !valued(out)) {
                out += in->columns;
                continue;
            }
            for (k = 0; k < in->axes; k++) {
                if (!*text[k] || at[k] != written[k])
                    real_text(text[k], (double)at[k],
                              sizeof *at < sizeof(double));
                written[k] = at[k];
                fprintf(s->file, "%s,", text[k]);
            }
            if (others) fprintf(s->file, "%s,", others);
            for (k = 1; k <= in->columns; k++, out++) {
                if (in->words[k - 1])
                    put_name(s->file, class_name(in->words[k - 1], *out));
                else if (chosen.digits)
                    fprintf(s->file, "%.*g", chosen.digits, *out);
                else
                    put_behind(s->file, 0, *out);
                putc(k < in->columns ? ',' : '\n', s->file);
            }
        }
    }
    check_written(s->file);
    if (s->scratch && ferror(s->scratch)) no_scratch(s->to->name);
}

/* draw - the picture of a slice: the first column. */
static void draw(const sink *s, const mesh *m)
{
    char note[400];
    draw_look look;
    const char *name;
    double length[3], plane[6];
    tess_real *p = 0;
    size_t i;
    int k, axis[3], many[2];

    begin_look(in, &look);
    axis[2] = 3 - side[0] - side[1];
    length[axis[2]] = 0.0;
    for (k = 0; k < 2; k++) {
        axis[k] = side[k];
        many[k] = (int)size[side[k]];
        length[side[k]] = corner[2 * side[k] + 1] - corner[2 * side[k]];
    }
    for (k = 0; k < 6; k++)
        plane[k] = k / 2 == axis[2] ? place(axis[2], 0) : corner[k];
    name = look.name[axis[2]];
    k = (int)strcspn(name, ",");
    note[0] = '\0';
    if (in->axes == 3)
        sprintf(note, "%.*s = %.15g%.50s; ", k, name, place(axis[2], 0),
                name + k + (name[k] != 0));
    strcat(note, method_name[method]);
    draw_even(&look, length, chosen.scaled ? LONGEST : LONGER, note);
    look.note = note;
    if (m->flat) {
        /* the two points off the plane, too */
        p = (tess_real *)space(3.0 * ((double)in->n + 2.0), sizeof *p);
        for (i = 0; i < 3 * ((size_t)in->n + 2); i++)
            p[i] = (tess_real)((double)m->p[i] / m->scale[i % 3]);
    }
    if (draw_slice(s->file, &look, axis, many, plane, s->picture, s->range,
                   p ? p : in->p, uncut ? m->ntet : 0, m->tet, m->adj,
                   m->keep) != 0)
        fail("not enough memory for a picture");
    free(p);
}

/* tail - VTK's columns, one after the other; or the picture. */
static void tail(sink *s, const mesh *m)
{
    static double row[COLUMNS];
    size_t columns = (size_t)in->columns;
    double i;
    int k;

    for (k = 0; s->scratch && k < in->columns; k++) {
        if (k > 0 && s->form == VTK) putc('\n', s->file);
        column_head(s, k);
        rewind(s->scratch);
        for (i = 0.0; i < places_asked(); i += 1.0) {
            if (fread(row, sizeof *row, columns, s->scratch) != columns)
                no_scratch(s->to->name);
            put_double(s->file, row[k]);
        }
    }
    if (s->form == SVG) draw(s, m);
    if (s->form == VTK) putc('\n', s->file);
    if (s->form == VTU) end_vtu(s->file);
    if (s->scratch) fclose(s->scratch);
    free(s->picture);
    finish(s->file, s->to);
}

/* ---------------------------------------------------------------- values */

/* mesh_in_plane - that of the points, which lie in one. */
static const mesh *mesh_in_plane(const mesh *m)
{
    tess_real *p = (tess_real *)space(3.0 * (double)in->n + 6.0, sizeof *p);
    tess_int i;

    if (chosen.alpha > 0.0)
        fail("%s: the points lie in one plane, where -alpha is nothing",
             in->input);
    if (chosen.within > 0.0 && in->axes == 3)
        fail("%s: the points lie in one plane, as -within is not for: name "
             "their coordinates in it, as -cols X,Y",
             in->input);
    if (in->axes == 3)
        warn("%s: the points lie in one plane: values are those of the place "
             "there that is nearest",
             in->input);
    for (i = 0; i < in->n; i++) to_plane(m->p + 3 * i, p + 3 * i);
    flat.in = m->in;
    memcpy(flat.scale, m->scale, sizeof flat.scale);
    lay_flat(&flat, in->n, p, !chosen.quiet);
    return &flat;
}

const mesh *keep_values(const mesh *m)
{
    double *times, mixed = 0.0;
    size_t columns = (size_t)in->columns, i, r, k;
    tess_int twins = 0, lost = 0, j;
    int other;

    if (!chosen.values && !chosen.validate) return m;
    in = m->in; /* (of a cell that repeats itself: with copies) */
    if (find_plane(m)) m = mesh_in_plane(m);
    if (m->ntet < 1)
        fail("%s: the points lie on one line, where there is nothing to "
             "interpolate in",
             in->input);
    for (j = 0; j < in->n; j++) twins += m->iw[j] != j;
    if (chosen.validate) {
        same = (tess_int *)space((double)in->n, sizeof *same);
        memcpy(same, m->iw, (size_t)in->n * sizeof *same);
    }
    if (twins == 0 && !m->flat) return m;
    mean = (double *)space((double)columns * ((double)in->n + 2.0),
                           sizeof *mean);
    times = m->rw; /* (longer than n) */
    for (i = 0; i < (size_t)in->n; i++) {
        r = (size_t)m->iw[i];
        times[i] = 1.0;
        for (k = 0; k < columns; k++)
            mean[columns * i + k] = in->value[columns * i + k];
        if (r == i) continue;
        /* a running mean, which equal values leave as they are */
        times[r] += 1.0;
        for (other = 0, k = 0; k < columns; k++) {
            if (in->words[k]) {
                mixed += in->value[columns * i + k] !=
                         in->value[columns * r + k];
                continue;
            }
            other |= in->value[columns * i + k] != in->value[columns * r + k];
            mean[columns * r + k] += (in->value[columns * i + k] -
                                      mean[columns * r + k]) / times[r];
        }
        lost = (tess_int)(lost + other);
    }
    for (k = 0; k < 2 * columns; k++)
        mean[columns * (size_t)in->n + k] = mean[k % columns];
    if (mixed > 0.0)
        warn("%.0f word%s of points where another one lies %s another word: "
             "the first point's is taken", mixed, mixed > 1.0 ? "s" : "",
             mixed > 1.0 ? "are" : "is");
    if (lost > 0)
        warn("%ld of the points lie where another one does, with other values: "
             "the mean of their values is interpolated",
             (long)lost);
    return m;
}

/* stretch - some places as they are in the mesh. */
static void stretch(tess_int many, const tess_real *from, const double *scale,
                    tess_real *q)
{
    tess_int i;

    for (i = 0; i < 3 * many; i++) {
        if (!in_range((double)from[i], (int)(i % 3)))
            fail("-scale: place %.0f is beyond the range of numbers",
                 done + (double)(i / 3) + 1.0);
        q[i] = (tess_real)((double)from[i] * scale[i % 3]);
    }
    for (i = 0; i < many && flat.flat; i++) to_plane(q + 3 * i, q + 3 * i);
    for (i = 0; i < many && chosen.periodic; i++) into_cell(q + 3 * i);
}

/* some - write the values at some places; t has a start for each. */
static void some(tess_int many, const tess_real *at, const double *scale)
{
    static tess_real q[3 * FEW];
    static double out[ROOM];
    tess_int i;
    int k;

    stretch(many, at, scale, q);
    values_at(many, q, t, out);
    for (k = 0; k < files; k++)
        if (sinks[k].form == SVG) put(sinks + k, many, at, out);
    for (i = 0; i < many && uncut; i++)
        for (k = 0; k < in->columns && t[i] < 0; k++)
            out[(long)in->columns * i + k] = number;
    /* (a number that is given is no word) */
    for (i = 0; i < many && outside == OUT_VALUE; i++)
        for (k = 0; k < in->columns && t[i] < 0; k++)
            if (in->words[k]) out[(long)in->columns * i + k] = no_number();
    for (i = 0; i < many; i++) bare += !valued(out + (long)in->columns * i);
    if (chosen.query && places->others) read_texts(many);
    for (k = 0; k < files; k++)
        if (sinks[k].form != SVG) put(sinks + k, many, at, out);
    done += (double)many;
    progress("values", done, places_asked());
}

/* grid_values - row by row, each from where the row before it began. */
static void grid_values(long most, const double *scale)
{
    static tess_real at[3 * FEW];
    tess_int plane = TESS_NONE, row, last;
    long x, y, z, many, i;

    for (z = 0; z < (long)size[2]; z++) {
        row = plane;
        for (y = 0; y < (long)size[1]; y++) {
            last = row;
            for (x = 0; x < (long)size[0]; x += many) {
                many = (long)size[0] - x < most ? (long)size[0] - x : most;
                for (i = 0; i < many; i++) {
                    at[3 * i] = (tess_real)place(0, x + i);
                    at[3 * i + 1] = (tess_real)place(1, y);
                    at[3 * i + 2] = (tess_real)place(2, z);
                    t[i] = i == 0 ? last : TESS_NONE;
                }
                some((tess_int)many, at, scale);
                last = t[many - 1];
                if (x == 0) row = t[0];
                if (x == 0 && y == 0) plane = t[0];
            }
        }
    }
}

/* in_order - is each place of a file near the one before it, as a rule? */
static int in_order(const tess_real *q)
{
    double low[3], high[3], x, way = 0.0, box = 0.0;
    tess_int i;
    int k;

    for (k = 0; k < 3; k++) {
        low[k] = high[k] = (double)q[k];
        for (i = 1; i < places->n; i++) {
            x = (double)q[3 * i + k];
            way += fabs(x - (double)q[3 * i + k - 3]);
            if (x < low[k]) low[k] = x;
            if (x > high[k]) high[k] = x;
        }
        box += high[k] - low[k];
    }
    /* (where they are at random, a third of the box) */
    return way <= box * pow((double)places->n, 2.0 / 3.0);
}

/* find_places - the tetrahedra of a file's places, into start: one after the
 * other as they are sorted, for walks from place to place are then short, and
 * what they look at is at hand. */
static void find_places(const double *scale, tess_int *start)
{
    tess_int n = places->n, last = TESS_NONE, liw, lrw, *iw, *order, i;
    tess_real *q = (tess_real *)space(3.0 * (double)n, sizeof *q);
    double *rw;
    int code;

    stretch(n, places->p, scale, q);
    for (i = 0; i < n; i++) start[i] = TESS_NONE;
    if (!in_order(q) && tess_size(n, 0, &liw, &lrw) == 0) {
        iw = (tess_int *)space((double)liw, sizeof *iw);
        rw = (double *)space((double)lrw, sizeof *rw);
        order = (tess_int *)space((double)n, sizeof *order);
        code = tess_index(n, q, liw, iw, lrw, rw);
        free(rw);
        for (i = 0; i < n; i++) order[i] = TESS_NONE;
        for (i = 0; i < n && code >= 0 && code != TESS_RANGE; i++)
            order[iw[i]] = i;
        for (i = 0; i < n; i++) {
            if (order[i] == TESS_NONE) continue;
            order[i] = last = values_start(q + 3 * order[i], last);
        }
        /* (of places that are the same one has been found) */
        for (i = 0; i < n && code >= 0 && code != TESS_RANGE; i++)
            start[i] = order[iw[i]];
        free(iw);
        free(order);
    }
    free(q);
}

static void query_values(long most, const double *scale)
{
    tess_int last = TESS_NONE, *start;
    long i, many;

    while (done < places->all) {
        next_places(places, done == 0.0);
        start = (tess_int *)space((double)places->n, sizeof *start);
        find_places(scale, start);
        for (i = 0; i < (long)places->n; i += many) {
            many = (long)places->n - i < most ? (long)places->n - i : most;
            memcpy(t, start + i, (size_t)many * sizeof *t);
            if (t[0] == TESS_NONE) t[0] = last;
            some((tess_int)many, places->p + 3 * i, scale);
            last = t[many - 1];
        }
        free(start);
    }
}

void write_values(const mesh *m)
{
    const double *scale = m->scale;
    field f;
    output *o;
    int k;
    long most = ROOM / in->columns < FEW ? ROOM / in->columns : FEW;

    f.p = m->p;
    f.n = in->n + 2 * m->flat;
    f.ntet = m->ntet;
    f.tet = m->tet;
    f.adj = m->adj;
    f.keep = m->keep;
    f.value = mean ? mean : in->value;
    f.columns = in->columns;
    f.flat = m->flat;
    f.within = chosen.within;
    if (chosen.query && places->others) rewind(places->texts);
    for (o = 0; (o = next_output(values_forms, o)) != 0;) {
        sinks = (sink *)more_space(sinks, files + 1.0, sizeof *sinks);
        memset(sinks + files, 0, sizeof *sinks);
        sinks[files].to = o;
        sinks[files].form = (int)(o->as - values_forms);
        if (sinks[files++].form == SVG)
            uncut = outside == OUT_VALUE && number != number &&
                    (!m->flat || in->axes == 2) && !chosen.periodic;
    }
    values_begin(&f, method, uncut ? OUT_NEAREST : outside, number);
    for (k = 0; k < files; k++) head(sinks + k);
    if (chosen.grid)
        grid_values(most, scale);
    else
        query_values(most, scale);
    if (bare > 0.0 && chosen.quiet)
        warn("of %.0f place%s %.0f %s no value", done, done == 1.0 ? "" : "s",
             bare, bare == 1.0 ? "has" : "have");
    else
        tell("places        %.0f, without a value %.0f\n", done, bare);
    for (k = 0; k < files; k++) tail(sinks + k, m);
    values_end();
}

void validate_values(mesh *m)
{
    cross_validate(flat.flat ? &flat : m, same, mean ? mean : in->value,
                   chosen.validate, asked, outside);
}
