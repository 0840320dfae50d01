/* driver.c - the command line program build/tess: reads points, has them
 * tetrahedralized, and writes TetGen and VTK files and pictures.  `tess -h'
 * lists options.
 *
 * All arrays are static: what is never touched costs nothing but address
 * space.  The Makefile's MAXPTS says for how many points, and adds what the
 * compiler needs for static data beyond 2 GB.
 */
#include <errno.h>
#include <float.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "draw.h"
#include "driver.h"

#ifndef MAXPTS
#define MAXPTS 1000000L
#endif
#ifndef MAXTET
#define MAXTET (7L * (MAXPTS) + 100000L)
#endif
#ifndef MAXIW
#define MAXIW (24L * (MAXPTS) + 100000L) /* TESS_POOL: more */
#endif
#ifndef MAXRW
#define MAXRW (8L * (MAXPTS) + 100000L)
#endif
#ifndef MAXVAL
#define MAXVAL (4L * (MAXPTS) + 100000L)
#endif

#define FEW 200      /* tetrahedra that are drawn apart                    */
#define LONG_RUN 1e5 /* from this many points on, tell stderr what goes on */

/* Exit codes. */
#define FAULT 1
#define BADUSE 2

static tess_real p[3 * (MAXPTS)];
static double value[MAXVAL];
static long line_of[MAXPTS];
static tess_int tet[4 * (MAXTET)], adj[4 * (MAXTET)], iw[MAXIW];
static double rw[MAXRW];
static char keep[MAXTET]; /* what is drawn */

static points in;
static tess_int ntet;
static int check, quiet, binary;
/* names: .node .ele .neigh .vtk .svg .face, cells */
static const char *output[7];
static double alpha;          /* largest circumradius drawn; 0: any */
static double view[2] = {-400.0, 0.0}; /* azimuth and elevation, if given */
static time_t began;

static const char *const usage[] = {
    "usage: tess [options] [points]",
    "",
    "Delaunay tetrahedralization of points in space.",
    "",
    "points: a file of points, or - or nothing for standard input.  It may be",
    "  lines     x y z and any values; blanks, tabs, commas or semicolons",
    "            between them; a first line of names, of which x, y, z say which",
    "            columns those are; a column of words is skipped.  # begins a",
    "            comment; so do % ! and two slashes.  1.34D-01 is 1.34E-01; a",
    "            decimal comma is an error",
    "  a count   before such lines, or Qhull's dimension and number",
    "  .xyz      of atoms: number, comment, lines `element x y z'",
    "  .node     TetGen's; .off, .ply (ASCII), .obj: the points; PDB: the atoms",
    "  .stl      ASCII STL: the triangles' corners",
    "All further columns, attributes and markers are values, which go to the",
    "output; the picture shows the first.",
    "",
    "  -cols X,Y,Z       the columns that are x, y, z, by number, from 1, or by",
    "                    name: -cols 2,3,4, -cols lon,lat,depth",
    "  -cols X,Y,Z,V...  and those that are values; without V all others are",
    "  -skip     drop rows from which a number is missing: an empty cell, NA,",
    "            N/A, NaN, null, none, - or --; how many is said",
    "",
    "  -check    prove the result, by exact arithmetic",
    "  -node F   write points, TetGen format",
    "  -ele F    write tetrahedra, TetGen format",
    "  -neigh F  write neighbours, TetGen format",
    "  -face F   write the hull's triangles, seen counter-clockwise from outside:",
    "            as OBJ if F ends in .obj, else in TetGen's .face format",
    "  -vtk F    write all as a VTK unstructured grid (legacy, ASCII)",
    "  -binary   let that be binary: faster, half as long, exact",
    "  -cells F  write the Voronoi cells in the points' box as VTK polyhedra",
    "  -svg F    write a picture: cut open; or moved apart if they are few",
    "  -alpha R  draw no tetrahedron whose circumradius exceeds R: the alpha",
    "            shape, with holes and hollows that the hull fills",
    "  -view A E draw as seen from azimuth A, from x to y, and elevation E above",
    "            that plane, both in degrees; if not given, -68 28",
    "  -o BASE   write BASE.node BASE.ele BASE.neigh BASE.vtk",
    "  -q        quiet: print nothing but errors",
    "  -h        this text",
    "",
    "exit code: 0  done; also for points that all lie in one plane, which have",
    "              no tetrahedron: a message says so",
    "           1  this build's arrays do not suffice, or -check found a fault",
    "           2  wrong usage, unreadable input, unwritable output"};

/* ---------------------------------------------------------------- errors */

/* complain - print a message on stderr. */
static void complain(const char *format, va_list list)
{
    fflush(stdout);
    fprintf(stderr, "tess: ");
    vfprintf(stderr, format, list);
    fprintf(stderr, "\n");
}

void fail(const char *format, ...)
{
    va_list list;

    va_start(list, format);
    complain(format, list);
    va_end(list);
    exit(BADUSE);
}

void too_small(const char *format, ...)
{
    va_list list;

    va_start(list, format);
    complain(format, list);
    va_end(list);
    exit(FAULT);
}

void warn(const char *format, ...)
{
    va_list list;

    if (quiet) return;
    va_start(list, format);
    complain(format, list);
    va_end(list);
}

void say(const char *format, ...)
{
    va_list list;

    if (quiet ||
        ((double)in.n < LONG_RUN && difftime(time((time_t *)0), began) < 2.0))
        return;
    va_start(list, format);
    complain(format, list);
    va_end(list);
}

/* fit - x, or what a narrow tess_int can hold of it. */
static tess_int fit(long x)
{
    while ((long)(tess_int)x != x) x /= 2;
    return (tess_int)x;
}

/* --------------------------------------------------------------- writing */

static FILE *start(const char *name, const char *mode)
{
    FILE *file = fopen(name, mode);

    if (!file) fail("%s: %s", name, strerror(errno));
    say("writing %s ...", name);
    return file;
}

static void finish(FILE *file, const char *name)
{
    int bad = ferror(file);

    if (fclose(file) || bad) fail("%s: write error", name);
    if (!quiet) printf("written       %s\n", name);
}

/* put_real - x, which was a float if narrow, with as few digits as give it
 * back. */
static void put_real(FILE *file, double x, int narrow, char after)
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

static void put_coordinates(FILE *file, tess_int i, char after)
{
    int narrow = sizeof(tess_real) < sizeof(double);

    put_real(file, (double)p[3 * i], narrow, ' ');
    put_real(file, (double)p[3 * i + 1], narrow, ' ');
    put_real(file, (double)p[3 * i + 2], narrow, after);
}

static void write_node(const char *name)
{
    FILE *file = start(name, "w");
    const double *v = value;
    tess_int i;
    int k;

    fprintf(file, "%ld 3 %d %d\n", (long)in.n, in.columns - in.marker,
            in.marker);
    for (i = 0; i < in.n; i++) {
        fprintf(file, "%ld ", (long)(i + in.base));
        put_coordinates(file, i, in.columns > 0 ? ' ' : '\n');
        for (k = 1; k <= in.columns; k++)
            put_real(file, *v++, 0, k < in.columns ? ' ' : '\n');
    }
    finish(file, name);
}

/* write_four - .ele or .neigh: four numbers a tetrahedron. */
static void write_four(const char *name, const char *head, const tess_int *four)
{
    FILE *file = start(name, "w");
    tess_int t;
    int k;

    fprintf(file, "%ld %s\n", (long)ntet, head);
    for (t = 0; t < ntet; t++) {
        fprintf(file, "%ld", (long)(t + in.base));
        for (k = 0; k < 4; k++)
            fprintf(file, " %ld", four[4 * t + k] < 0
                                      ? -1L
                                      : (long)(four[4 * t + k] + in.base));
        fprintf(file, "\n");
    }
    finish(file, name);
}

/* write_face - the hull's triangles: TetGen's .face, whose points are those of
 * .node; or OBJ, with the hull's points alone.  A hull of n points has 2 n - 4
 * triangles at most, so that they and a number for each point fit into iw. */
static void write_face(const char *name)
{
    static const char suffix[] = ".obj";
    size_t length = strlen(name);
    int obj = length >= 4 && strcmp(name + length - 4, suffix) == 0;
    FILE *file = start(name, "w");
    tess_int *place = iw, *fac = iw + in.n, nfac = 0, many = 0, i;

    tess_hull(ntet, tet, adj, (fit(MAXIW) - in.n) / 3, &nfac, fac);
    if (!obj) fprintf(file, "%ld 0\n", (long)nfac);
    for (i = 0; i < in.n; i++) place[i] = obj ? 0 : i + in.base;
    for (i = 0; obj && i < 3 * nfac; i++)
        if (place[fac[i]] == 0) {
            place[fac[i]] = ++many;
            fprintf(file, "v ");
            put_coordinates(file, fac[i], '\n');
        }
    for (i = 0; i < nfac; i++) {
        if (obj)
            fprintf(file, "f");
        else
            fprintf(file, "%ld", (long)(i + in.base));
        fprintf(file, " %ld %ld %ld\n", (long)place[fac[3 * i]],
                (long)place[fac[3 * i + 1]], (long)place[fac[3 * i + 2]]);
    }
    finish(file, name);
}

/* put_bytes - the bytes of a number, the most significant first, as VTK's
 * binary files have them. */
static void put_bytes(FILE *file, const void *number, int size)
{
    static const int one = 1;
    const char *byte = (const char *)number;
    int little = *(const char *)&one, k;

    for (k = 0; k < size; k++) putc(byte[little ? size - 1 - k : k], file);
}

static void put_double(FILE *file, double x, char after)
{
    if (binary)
        put_bytes(file, &x, (int)sizeof x);
    else
        put_real(file, x, 0, after);
}

/* put_int - VTK's int has 4 bytes. */
static void put_int(FILE *file, tess_int i, char after)
{
    unsigned long bits = (unsigned long)i;
    int shift;

    if (!binary)
        fprintf(file, "%ld%c", (long)i, after);
    else
        for (shift = 24; shift >= 0; shift -= 8)
            putc((int)(bits >> shift & 255), file);
}

static void write_vtk(const char *name)
{
    FILE *file = start(name, binary ? "wb" : "w");
    const char *end = binary ? "\n" : ""; /* of a block */
    tess_int i;
    const char *c;
    int k;

    fprintf(file,
            "# vtk DataFile Version 3.0\n"
            "Delaunay tetrahedralization\n"
            "%s\n"
            "DATASET UNSTRUCTURED_GRID\n"
            "POINTS %ld double\n",
            binary ? "BINARY" : "ASCII", (long)in.n);
    for (i = 0; i < in.n; i++)
        if (binary)
            for (k = 0; k < 3; k++) put_double(file, (double)p[3 * i + k], 0);
        else
            put_coordinates(file, i, '\n');
    fprintf(file, "%sCELLS %ld %.0f\n", end, (long)ntet,
            5.0 * (double)ntet);
    for (i = 0; i < ntet; i++) {
        put_int(file, 4, ' ');
        for (k = 0; k < 4; k++)
            put_int(file, tet[4 * i + k], k < 3 ? ' ' : '\n');
    }
    fprintf(file, "%sCELL_TYPES %ld\n", end, (long)ntet);
    for (i = 0; i < ntet; i++) put_int(file, 10, '\n');
    fprintf(file, "%s", end);
    if (in.columns > 0) fprintf(file, "POINT_DATA %ld\n", (long)in.n);
    for (k = 0; k < in.columns; k++) {
        fprintf(file, "SCALARS ");
        for (c = in.name[k]; *c; c++)
            putc(*c > ' ' && *c <= '~' && *c != '"' ? *c : '_', file);
        fprintf(file, " double 1\nLOOKUP_TABLE default\n");
        for (i = 0; i < in.n; i++)
            put_double(file, value[(long)in.columns * i + k], '\n');
        fprintf(file, "%s", end);
    }
    finish(file, name);
}

static void write_cells(const char *name)
{
    FILE *file = start(name, "w");

    if (draw_cells(file, in.n, p, ntet, tet, adj, in.base) != 0)
        too_small("%s: not enough memory for the cells", name);
    finish(file, name);
}

static void write_svg(const char *name)
{
    static char note[120];
    FILE *file = start(name, "w");
    tess_int drawn = ntet, i;
    draw_look look;

    draw_default(&look);
    if (view[0] >= -360.0) {
        look.azimuth = view[0];
        look.elevation = view[1];
    }
    if (alpha > 0.0) {
        drawn = draw_alpha(p, ntet, tet, adj, alpha, keep, iw);
        look.keep = keep;
    }
    look.shrink = drawn > FEW ? 1.0 : 0.72;
    look.cut = drawn > FEW;
    look.label = in.name[0];
    sprintf(note, "%ld points, %ld tetrahedra%s", (long)in.n, (long)drawn,
            in.columns > 0 ? "" : "; coloured by distance from the middle");
    look.note = note;
    /* the first value of each point, where the workspace was */
    if (in.columns > 0)
        for (i = 0; i < in.n; i++) rw[i] = value[(long)in.columns * i];
    if (draw_svg(file, &look, in.n, p, in.columns > 0 ? rw : (double *)0,
                 ntet, tet, adj) != 0)
        too_small("%s: not enough memory for a picture", name);
    finish(file, name);
}

/* ------------------------------------------------------------- reporting */

static double volume(void)
{
    const tess_real *a, *q;
    double e[3][3], sum = 0.0;
    tess_int t;
    int i, k;

    for (t = 0; t < ntet; t++) {
        a = p + 3 * tet[4 * t];
        for (i = 0; i < 3; i++) {
            q = p + 3 * tet[4 * t + i + 1];
            for (k = 0; k < 3; k++) e[i][k] = (double)q[k] - (double)a[k];
        }
        sum += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
               e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
               e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    }
    return sum / 6.0;
}

static void report(int code, tess_int duplicates, double seconds,
                   double bytes)
{
    tess_int hull = 0, i;
    double v = volume();
    const char *what = "";

    printf("points        %ld", (long)in.n);
    if (in.columns > 0)
        printf(", each with %d value%s", in.columns,
               in.columns > 1 ? "s" : "");
    printf("\n");
    printf("duplicates    %ld\n", (long)duplicates);
    for (i = 0; i < 4 * ntet; i++)
        if (adj[i] == TESS_NONE) hull++;
    printf("tetrahedra    %ld\n", (long)ntet);
    printf("hull facets   %ld\n", (long)hull);
    if (v <= DBL_MAX)
        printf("volume        %.9g\n", v);
    else
        printf("volume        beyond the range of double\n");
    printf("seconds       %.3f", seconds);
    if (ntet > 0 && seconds > 0.05)
        printf(", %.0f ns a tetrahedron", seconds / (double)ntet * 1e9);
    printf("\nworkspace     %.0f bytes, %.1f a point\n", bytes,
           bytes / (double)in.n);
    if (code == TESS_PLANE) what = "all points lie in one plane";
    if (code == TESS_LINE) what = "all points lie on one line";
    if (code == TESS_POINT) what = "at most one distinct point";
    if (code != TESS_OK) printf("no tetrahedron: %s\n", what);
}

/* explain - leave with a sentence for a code that is no result. */
static void explain(int code, tess_int maxtet, tess_int liw)
{
    switch (code) {
    case TESS_MORE:
        too_small("more than %ld tetrahedra; build for more: make MAXPTS=%ld",
                  (long)maxtet, 4 * (long)fit(MAXPTS));
        break;
    case TESS_POOL:
        too_small("more open facets than %ld integers of workspace hold; "
                  "build for more: make MAXPTS=%ld",
                  (long)liw, 4 * (long)fit(MAXPTS));
        break;
    case TESS_RANGE:
        too_small("the coordinates differ too much in magnitude for numbers "
                  "of %d limbs; rebuild with a larger -DHH_LIMBS=...",
                  HH_LIMBS);
        break;
    case -7:
    case -9:
        too_small("the workspace does not suffice for %ld points; build for "
                  "more: make MAXPTS=%ld",
                  (long)in.n, 4 * (long)fit(MAXPTS));
        break;
    case -2:
        fail("%s, line %ld: point %ld has a coordinate that is not finite "
             "(-skip drops a NaN)",
             in.input, line_of[ntet], (long)(ntet + in.base));
        break;
    default:
        too_small("unexpected code %d", code);
    }
}

/* prove - run tess_check and say what it found; returns the exit code. */
static int prove(void)
{
    tess_int bad = TESS_NONE;
    int code;
    const char *what;

    say("checking ...");
    code = tess_check(in.n, p, ntet, tet, adj, fit(MAXIW), iw, &bad);
    switch (code) {
    case 0:
        if (!quiet)
            printf("check         proven: %s\n",
                   ntet > 0 ? "a Delaunay tetrahedralization of the points"
                            : "no four points span a tetrahedron");
        return 0;
    case TESS_BAD_INDEX:
        what = "a vertex is out of range, or there twice";
        break;
    case TESS_BAD_TWIN:
        what = "a vertex is a duplicate of another point";
        break;
    case TESS_BAD_SIGN:
        what = "flat, or negatively oriented";
        break;
    case TESS_BAD_OPEN:
        what = "a facet is still open";
        break;
    case TESS_BAD_ADJ:
        what = "a neighbour is wrong";
        break;
    case TESS_BAD_BALL:
        what = "a neighbour's vertex is inside the ball";
        break;
    case TESS_BAD_HULL:
        what = "the boundary is not closed, or not convex";
        break;
    case TESS_BAD_COVER:
        what = "the hull is covered more than once";
        break;
    case TESS_BAD_POINT:
        what = "the point is in no tetrahedron";
        break;
    default:
        what = "unexpected code";
    }
    fflush(stdout);
    fprintf(stderr, "tess: check: %s (code %d", what, code);
    if (bad >= 0)
        fprintf(stderr, ", %s %ld",
                code == TESS_BAD_POINT ? "point" : "tetrahedron",
                (long)(bad + in.base));
    fprintf(stderr, ")\n");
    return FAULT;
}

/* ------------------------------------------------------------------ main */

/* options - read the command line; returns the name of the input or 0. */
static const char *options(int argc, char **argv)
{
    static const char *const option[7] = {"-node", "-ele", "-neigh",
                                          "-vtk",  "-svg", "-face", "-cells"};
    static char made[4][NAME];
    const char *name = 0, *word;
    char *end;
    int a, k, commas = 0;

    for (a = 1; a < argc; a++) {
        word = argv[a];
        for (k = 0; k < 7 && strcmp(word, option[k]) != 0; k++) continue;
        if (strcmp(word, "-alpha") == 0) {
            if (++a < argc) alpha = strtod(argv[a], &end);
            if (a == argc || *end || !(alpha > 0.0))
                fail("-alpha needs a length (tess -h helps)");
        } else if (strcmp(word, "-view") == 0) {
            for (k = 0; k < 2; k++) {
                end = (char *)word;
                if (++a < argc) view[k] = strtod(argv[a], &end);
                if (a >= argc || *end || !(view[k] >= -360.0) ||
                    !(view[k] <= 360.0))
                    fail("-view needs two angles (tess -h helps)");
            }
        } else if (strcmp(word, "-cols") == 0) {
            for (k = 0; a + 1 < argc && argv[a + 1][k]; k++)
                commas += argv[a + 1][k] == ',';
            if (++a == argc || commas < 2)
                fail("-cols needs three columns, as 2,3,4 (tess -h helps)");
            in.cols = argv[a];
        } else if (k < 7 || strcmp(word, "-o") == 0) {
            if (++a == argc) fail("%s needs a name (tess -h helps)", word);
            if (k < 7) {
                output[k] = argv[a];
                continue;
            }
            if (strlen(argv[a]) + 7 > NAME) fail("the name is too long");
            for (k = 0; k < 4; k++) {
                sprintf(made[k], "%s.%s", argv[a], option[k] + 1);
                output[k] = made[k];
            }
        } else if (strcmp(word, "-check") == 0) {
            check = 1;
        } else if (strcmp(word, "-binary") == 0) {
            binary = 1;
        } else if (strcmp(word, "-skip") == 0) {
            in.skip = 1;
        } else if (strcmp(word, "-q") == 0) {
            quiet = 1;
        } else if (strcmp(word, "-h") == 0) {
            for (k = 0; k < (int)(sizeof usage / sizeof usage[0]); k++)
                printf("%s\n", usage[k]);
            printf("\nBuilt for up to %ld points and %ld tetrahedra.\n",
                   (long)fit(MAXPTS), (long)fit(MAXTET));
            exit(0);
        } else if (word[0] == '-' && word[1]) {
            fail("unknown option %s (tess -h helps)", word);
        } else if (name) {
            fail("more than one input: %s, %s", name, word);
        } else {
            name = word;
        }
    }
    for (k = 0; k < 7; k++)
        if (name && output[k] && strcmp(name, output[k]) == 0)
            fail("%s: would overwrite the input", name);
    for (k = 1; k < 7; k++)
        for (a = 0; a < k; a++)
            if (output[a] && output[k] && strcmp(output[a], output[k]) == 0)
                fail("%s: the name of two outputs", output[k]);
    return name;
}

/* tetrahedralize - call tess, and resume it, such that there is something to
 * tell every second or so.  But to resume takes about as long as n tetrahedra
 * of a cloud, and a third of what is there already: slices shall take four
 * times that, lest the telling be the work. */
static int tetrahedralize(tess_int maxtet, tess_int *liw, tess_int lrw)
{
    clock_t begin = clock(), last = begin;
    tess_int room = in.n / 4 + 1000, before = 0;
    double rate, slice, resume;
    int code;

    ntet = 0;
    for (;;) {
        if (room > maxtet || quiet) room = maxtet;
        code = (ntet > 0 ? tess_resume : tess)(in.n, p, room, &ntet, tet, adj,
                                               *liw, iw, lrw, rw);
        if (code == TESS_POOL && *liw < fit(MAXIW)) {
            say("more room for open facets ...");
            *liw = *liw < fit(MAXIW) / 2 ? 2 * *liw : fit(MAXIW);
            continue;
        }
        if (code != TESS_MORE || room == maxtet) return code;
        slice = (double)(clock() - last) / CLOCKS_PER_SEC;
        last = clock();
        rate = (slice + 1e-9) / (double)(ntet - before);
        resume = (rate < 1e-6 ? rate : 1e-6) *
                 ((double)in.n + (double)ntet / 3.0);
        slice = 4.0 * resume > 1.0 ? 4.0 * resume : 1.0;
        if (difftime(time((time_t *)0), began) >= 1.0)
            warn("%ld tetrahedra after %.1f s, of about %.0f if the points "
                 "fill a volume",
                 (long)ntet, (double)(last - begin) / CLOCKS_PER_SEC,
                 6.8 * (double)in.n);
        before = ntet;
        slice = slice / rate < 2e9 ? slice / rate : 2e9;
        if (slice > (double)(maxtet - room))
            room = maxtet;
        else
            room += (tess_int)slice + 1;
    }
}

int main(int argc, char **argv)
{
    tess_int maxtet = fit(MAXTET), liw, lrw, duplicates = 0, i;
    int code, status = 0;
    clock_t begin;
    double seconds;
    const char *name = options(argc, argv);

    began = time((time_t *)0);
    in.room = (long)fit(MAXPTS);
    in.values = MAXVAL;
    in.p = p;
    in.value = value;
    in.line = line_of;
    read_points(name, &in);

    while ((code = tess_size(in.n, maxtet, &liw, &lrw)) == -2 && maxtet > 0)
        maxtet /= 2;
    if (code < 0)
        too_small("%ld points are too many for a tess_int of %d bytes; "
                  "rebuild with a larger -DTESS_INT=...",
                  (long)in.n, (int)sizeof(tess_int));
    if (liw > fit(MAXIW)) liw = fit(MAXIW);
    if (lrw > fit(MAXRW)) lrw = fit(MAXRW);
    say("tetrahedralizing %ld points, about %.1f s if they fill a volume ...",
        (long)in.n, 2.1e-6 * (double)in.n);
    begin = clock();
    code = tetrahedralize(maxtet, &liw, lrw);
    seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (code != TESS_OK && code != TESS_PLANE && code != TESS_LINE &&
        code != TESS_POINT)
        explain(code, maxtet, liw);

    for (i = 0; i < in.n; i++)
        if (iw[i] != i) duplicates++;
    if (!quiet)
        report(code, duplicates, seconds,
               (double)liw * (double)sizeof(tess_int) +
                   (double)lrw * (double)sizeof(double));
    if (check) status = prove();
    if (output[0]) write_node(output[0]);
    if (output[1]) write_four(output[1], "4 0", tet);
    if (output[2]) write_four(output[2], "4", adj);
    if (output[3]) write_vtk(output[3]);
    if (output[4]) write_svg(output[4]);
    if (output[5]) write_face(output[5]);
    if (output[6]) write_cells(output[6]);
    if (fflush(stdout) || ferror(stdout)) fail("standard output: write error");
    return status;
}
