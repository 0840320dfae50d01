/* driver.c - the command line program build/tess: reads points, has them
 * tetrahedralized, and writes TetGen and VTK files and pictures.  `tess -h'
 * lists options.
 *
 * All arrays are static: what is never touched costs nothing but address
 * space.  Much more than 4 million points need a compiler option for static
 * data beyond 2 GB, such as -mcmodel=large.
 */
#include <errno.h>
#include <float.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "draw.h"
#include "tess.h"

#ifndef MAXPTS
#define MAXPTS 1000000L
#endif
#ifndef MAXTET
#define MAXTET (7L * (MAXPTS) + 100000L)
#endif
#ifndef MAXIW
#define MAXIW (24L * (MAXPTS) + 100000L)
#endif
#ifndef MAXRW
#define MAXRW (8L * (MAXPTS) + 100000L)
#endif

#define LINE 8192    /* characters of a line that are looked at            */
#define NAME 1024    /* longest file name made from -o                     */
#define FEW 200      /* tetrahedra that are drawn apart                    */
#define LONG_RUN 1e5 /* from this many points on, tell stderr what goes on */

/* Exit codes. */
#define FAULT 1
#define BADUSE 2

static tess_real p[3 * (MAXPTS)];
static double value[MAXPTS];
static long line_of[MAXPTS];
static tess_int tet[4 * (MAXTET)], adj[4 * (MAXTET)], iw[MAXIW];
static double rw[MAXRW];
static char keep[MAXTET]; /* what is drawn */

static tess_int n, ntet;
static int has_values;
static tess_int base; /* number of the first point and tetrahedron in files */
static int check, quiet;
static const char *output[5]; /* names: .node .ele .neigh .vtk .svg */
static double alpha;          /* largest circumradius drawn; 0: any */
static char line[LINE];
static long line_number;
static const char *input = "standard input";

static const char *const usage[] = {
    "usage: tess [options] [points]",
    "",
    "Delaunay tetrahedralization of points in space.",
    "",
    "points: lines `x y z' or `x y z value'; or, if the name ends in .node, a",
    "TetGen file.  Separators are blanks, tabs, commas, semicolons; # starts a",
    "comment; columns after the value are ignored.  No name, or -: standard",
    "input.",
    "",
    "  -check    prove the result, by exact arithmetic",
    "  -node F   write points, TetGen format",
    "  -ele F    write tetrahedra, TetGen format",
    "  -neigh F  write neighbours, TetGen format",
    "  -vtk F    write all as a VTK unstructured grid (legacy, ASCII)",
    "  -svg F    write a picture: cut open; or moved apart if they are few",
    "  -alpha R  draw no tetrahedron whose circumradius exceeds R: the alpha",
    "            shape, with holes and hollows that the hull fills",
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

/* fail - the same, and leave: the usage, the input or an output is bad. */
static void fail(const char *format, ...)
{
    va_list list;

    va_start(list, format);
    complain(format, list);
    va_end(list);
    exit(BADUSE);
}

/* too_small - the same: this build's arrays do not suffice. */
static void too_small(const char *format, ...)
{
    va_list list;

    va_start(list, format);
    complain(format, list);
    va_end(list);
    exit(FAULT);
}

/* fail_line - the same, about the current line of the input. */
static void fail_line(const char *what)
{
    fail("%s, line %ld: %s", input, line_number, what);
}

/* say - tell on stderr what a long run is doing. */
static void say(const char *format, ...)
{
    va_list list;

    if (quiet || (double)n < LONG_RUN) return;
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

/* --------------------------------------------------------------- reading */

static int blank(int c)
{
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

static int comma(int c)
{
    return c == ',' || c == ';';
}

/* next_line - read the next line that holds something into line, without its
 * comment, without blanks that only repeat one, and without a number that the
 * end of the buffer would cut.  Ends of line: LF, CR LF, CR.  Returns 0 at
 * the end of the file. */
static int next_line(FILE *file)
{
    int c, len, comment;

    do {
        len = comment = 0;
        line_number++;
        while ((c = getc(file)) != EOF && c != '\n' && c != '\r') {
            if (c == '#') comment = 1;
            if (comment || len == LINE) continue;
            if (blank(c) && (len == 0 || blank(line[len - 1]))) continue;
            /* strtod would take a NUL for the end of the line */
            line[len++] = c ? (char)c : '?';
            /* a byte order mark */
            if (line_number == 1 && len == 3 &&
                strncmp(line, "\357\273\277", 3) == 0)
                len = 0;
        }
        if (c == '\r' && (c = getc(file)) != '\n' && c != EOF) {
            ungetc(c, file);
            c = '\n';
        }
        if (len == LINE) {
            do len--;
            while (len > 1 && !blank(line[len]) && !comma(line[len]));
        }
        line[len] = '\0';
        if (len > 0) return 1;
    } while (c != EOF);
    if (ferror(file)) fail("%s: %s", input, strerror(errno));
    return 0;
}

/* numbers - read up to most numbers from line; returns how many there are. */
static int numbers(int most, double *x)
{
    const char *s = line;
    char *end;
    int k;

    for (k = 0; k < most; k++) {
        while (blank(*s)) s++;
        if (!*s) break;
        x[k] = strtod(s, &end);
        if (end == s || (*end && !blank(*end) && !comma(*end)))
            fail("%s, line %ld: column %d is not a number: %.30s", input,
                 line_number, k + 1, s);
        s = end;
        while (blank(*s)) s++;
        if (comma(*s)) s++;
    }
    return k;
}

static void put_point(const double *x, double v)
{
    int k;

    if (n == fit(MAXPTS))
        too_small("%s, line %ld: more than %ld points; rebuild with "
                  "-DMAXPTS=... (make clean; make CPPFLAGS=-DMAXPTS=%ld)",
                  input, line_number, (long)n, 4 * (long)n);
    for (k = 0; k < 3; k++) p[3 * n + k] = (tess_real)x[k];
    value[n] = v;
    line_of[n] = line_number;
    n++;
    if ((double)n == LONG_RUN) say("reading %s ...", input);
}

static void read_xyz(FILE *file)
{
    double x[4];
    int columns;

    while (next_line(file)) {
        columns = numbers(4, x);
        if (columns < 3) fail_line("fewer than three numbers");
        if (n == 0) has_values = columns == 4;
        if (has_values != (columns == 4))
            fail_line(has_values ? "no value, but the lines before have one"
                                 : "a value, but the lines before have none");
        put_point(x, has_values ? x[3] : 0.0);
    }
}

static void read_node(FILE *file)
{
    double head[4], x[5];
    int columns;

    head[2] = 0.0;
    if (!next_line(file)) fail("%s: empty", input);
    columns = numbers(4, head);
    if (columns < 2 || !(head[0] >= 0.0 && head[0] <= 2147483647.0) ||
        !(head[2] >= 0.0))
        fail_line("not the first line of a .node file");
    if (head[1] != 3.0) fail_line("the points are not in three dimensions");
    has_values = head[2] >= 1.0;
    while ((double)n < head[0]) {
        if (!next_line(file))
            fail("%s: ends after %ld of %.0f points", input, (long)n, head[0]);
        columns = numbers(has_values ? 5 : 4, x);
        if (columns < (has_values ? 5 : 4))
            fail_line(has_values ? "fewer than five numbers"
                                 : "fewer than four numbers");
        if (n == 0 && x[0] == 1.0) base = 1;
        if (x[0] != (double)(n + base))
            fail_line("points are not numbered one after the other from 0 "
                      "or 1");
        put_point(x + 1, has_values ? x[4] : 0.0);
    }
}

static int ends_in(const char *name, const char *suffix)
{
    size_t a = strlen(name), b = strlen(suffix);

    return a >= b && strcmp(name + a - b, suffix) == 0;
}

static void read_points(const char *name)
{
    FILE *file = stdin;

    if (name && strcmp(name, "-") != 0) {
        input = name;
        file = fopen(name, "r");
        if (!file) fail("%s: %s", name, strerror(errno));
    } else if (!name && !quiet)
        fprintf(stderr, "tess: reading points from standard input\n");
    if (ends_in(input, ".node"))
        read_node(file);
    else
        read_xyz(file);
    if (file != stdin) fclose(file);
}

/* --------------------------------------------------------------- writing */

static FILE *start(const char *name)
{
    FILE *file = fopen(name, "w");

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
    FILE *file = start(name);
    tess_int i;

    fprintf(file, "%ld 3 %d 0\n", (long)n, has_values);
    for (i = 0; i < n; i++) {
        fprintf(file, "%ld ", (long)(i + base));
        put_coordinates(file, i, has_values ? ' ' : '\n');
        if (has_values) put_real(file, value[i], 0, '\n');
    }
    finish(file, name);
}

/* write_four - .ele or .neigh: four numbers a tetrahedron. */
static void write_four(const char *name, const char *head, const tess_int *four)
{
    FILE *file = start(name);
    tess_int t;
    int k;

    fprintf(file, "%ld %s\n", (long)ntet, head);
    for (t = 0; t < ntet; t++) {
        fprintf(file, "%ld", (long)(t + base));
        for (k = 0; k < 4; k++)
            fprintf(file, " %ld", four[4 * t + k] < 0
                                      ? -1L
                                      : (long)(four[4 * t + k] + base));
        fprintf(file, "\n");
    }
    finish(file, name);
}

static void write_vtk(const char *name)
{
    FILE *file = start(name);
    tess_int i;

    fprintf(file,
            "# vtk DataFile Version 3.0\n"
            "Delaunay tetrahedralization\n"
            "ASCII\n"
            "DATASET UNSTRUCTURED_GRID\n"
            "POINTS %ld double\n",
            (long)n);
    for (i = 0; i < n; i++) put_coordinates(file, i, '\n');
    fprintf(file, "CELLS %ld %.0f\n", (long)ntet, 5.0 * (double)ntet);
    for (i = 0; i < ntet; i++)
        fprintf(file, "4 %ld %ld %ld %ld\n", (long)tet[4 * i],
                (long)tet[4 * i + 1], (long)tet[4 * i + 2],
                (long)tet[4 * i + 3]);
    fprintf(file, "CELL_TYPES %ld\n", (long)ntet);
    for (i = 0; i < ntet; i++) fprintf(file, "10\n");
    if (has_values) {
        fprintf(file,
                "POINT_DATA %ld\n"
                "SCALARS value double 1\n"
                "LOOKUP_TABLE default\n",
                (long)n);
        for (i = 0; i < n; i++) put_real(file, value[i], 0, '\n');
    }
    finish(file, name);
}

static void write_svg(const char *name)
{
    static char note[120];
    FILE *file = start(name);
    tess_int drawn = ntet;
    draw_look look;

    draw_default(&look);
    if (alpha > 0.0) {
        drawn = draw_alpha(p, ntet, tet, alpha, keep);
        look.keep = keep;
    }
    look.shrink = drawn > FEW ? 1.0 : 0.72;
    look.cut = drawn > FEW;
    look.label = "value";
    sprintf(note, "%ld points, %ld tetrahedra", (long)n, (long)drawn);
    look.note = note;
    if (draw_svg(file, &look, n, p, has_values ? value : (double *)0, ntet,
                 tet, adj) != 0)
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

    printf("points        %ld%s\n", (long)n,
           has_values ? ", each with a value" : "");
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
    printf("\nworkspace     %.0f bytes", bytes);
    if (n > 0) printf(", %.1f a point", bytes / (double)n);
    printf("\n");
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
        too_small("more than %ld tetrahedra; rebuild with -DMAXTET=... "
                  "(make clean; make CPPFLAGS=-DMAXTET=%ld)",
                  (long)maxtet, 4 * (long)maxtet);
        break;
    case TESS_POOL:
        too_small("more open facets than %ld integers of workspace hold; "
                  "rebuild with -DMAXIW=... (make clean; make "
                  "CPPFLAGS=-DMAXIW=%ld)",
                  (long)liw, 4 * (long)liw);
        break;
    case TESS_RANGE:
        too_small("the coordinates differ too much in magnitude for numbers "
                  "of %d limbs; rebuild with a larger -DHH_LIMBS=...",
                  HH_LIMBS);
        break;
    case -7:
    case -9:
        too_small("the workspace does not suffice for %ld points; rebuild "
                  "with larger -DMAXIW=... -DMAXRW=...",
                  (long)n);
        break;
    case -2:
        fail("%s, line %ld: point %ld has a coordinate that is not finite",
             input, line_of[ntet], (long)(ntet + base));
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
    code = tess_check(n, p, ntet, tet, adj, fit(MAXIW), iw, &bad);
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
                (long)(bad + base));
    fprintf(stderr, ")\n");
    return FAULT;
}

/* ------------------------------------------------------------------ main */

/* options - read the command line; returns the name of the input or 0. */
static const char *options(int argc, char **argv)
{
    static const char *const option[5] = {"-node", "-ele", "-neigh", "-vtk",
                                          "-svg"};
    static char made[4][NAME];
    const char *name = 0, *word;
    char *end;
    int a, k;

    for (a = 1; a < argc; a++) {
        word = argv[a];
        for (k = 0; k < 5 && strcmp(word, option[k]) != 0; k++) continue;
        if (strcmp(word, "-alpha") == 0) {
            if (++a < argc) alpha = strtod(argv[a], &end);
            if (a == argc || *end || !(alpha > 0.0))
                fail("-alpha needs a length (tess -h helps)");
        } else if (k < 5 || strcmp(word, "-o") == 0) {
            if (++a == argc) fail("%s needs a name (tess -h helps)", word);
            if (k < 5) {
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
    for (k = 0; k < 5; k++)
        if (name && output[k] && strcmp(name, output[k]) == 0)
            fail("%s: would overwrite the input", name);
    return name;
}

int main(int argc, char **argv)
{
    tess_int maxtet = fit(MAXTET), liw, lrw, duplicates = 0, i;
    int code, status = 0;
    clock_t begin;
    double seconds;

    read_points(options(argc, argv));

    while ((code = tess_size(n, maxtet, &liw, &lrw)) == -2 && maxtet > 0)
        maxtet /= 2;
    if (code < 0)
        too_small("%ld points are too many for a tess_int of %d bytes; "
                  "rebuild with a larger -DTESS_INT=...",
                  (long)n, (int)sizeof(tess_int));
    if (liw > fit(MAXIW)) liw = fit(MAXIW);
    if (lrw > fit(MAXRW)) lrw = fit(MAXRW);
    say("tetrahedralizing %ld points, about %.1f s if they fill a volume ...",
        (long)n, 2.1e-6 * (double)n);
    begin = clock();
    code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
    while (code == TESS_POOL && liw < fit(MAXIW)) {
        say("more room for open facets ...");
        liw = liw < fit(MAXIW) / 2 ? 2 * liw : fit(MAXIW);
        code = tess_resume(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
    }
    seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (code != TESS_OK && code != TESS_PLANE && code != TESS_LINE &&
        code != TESS_POINT)
        explain(code, maxtet, liw);

    for (i = 0; i < n; i++)
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
    if (fflush(stdout) || ferror(stdout)) fail("standard output: write error");
    return status;
}
