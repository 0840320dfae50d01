/* driver.c - the command line program build/tess: reads points, has them
 * tetrahedralized, and writes TetGen and VTK files and pictures.  `tess -h'
 * lists options.
 */
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "driver.h"

#define UNEVEN 50.0  /* sides so uneven have different units, perhaps       */
#define LISTED 20    /* columns of values in the summary, at most;         */
#define FEW_WORDS 8  /* and words of one                                   */
#define LONG_RUN 1e5 /* from this many points on, tell stderr what goes on */
#define CLOUD 7.0    /* tetrahedra a point that there is room for at first */
#define GROWTH 4.0   /* times more: to resume takes a third of that so far */
#define MOST ((TESS_INT_MOST - 3) / 4) /* tetrahedra that a tess_int numbers */

/* Exit codes. */
#define FAULT 1
#define BADUSE 2

static points in, places;
static mesh made;
static const mesh *valued; /* by keep_values */
static const char *none;   /* why there is no tetrahedron; 0: there are */
static time_t began;

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

    va_start(list, format);
    complain(format, list);
    va_end(list);
}

void tell(const char *format, ...)
{
    va_list list;

    if (chosen.quiet) return;
    va_start(list, format);
    vfprintf(chosen.to_stdout ? stderr : stdout, format, list);
    va_end(list);
}

void say(const char *format, ...)
{
    va_list list;

    if (chosen.quiet ||
        ((double)in.n < LONG_RUN && difftime(time((time_t *)0), began) < 2.0))
        return;
    va_start(list, format);
    complain(format, list);
    va_end(list);
}

void progress(const char *what, double done, double total)
{
    static const char *last;
    static time_t since;
    static double wait;
    time_t now = time((time_t *)0);
    double past;

    if (what != last) {
        since = now;
        wait = 2.0;
    }
    last = done == total ? (const char *)0 : what;
    past = difftime(now, since);
    if (past < wait || done == total || chosen.quiet) return;
    wait = 1.3 * past;
    if (total > 0.0)
        warn("%s: %.0f %%, about %.0f s more", what, 100.0 * done / total,
             past * (total / done - 1.0));
    else
        warn("%s: %.0f MB", what, done / 1e6);
}

void *more_space(void *a, double many, size_t size)
{
    a = many < (double)((size_t)-1 / 2 / size)
            ? realloc(a, (size_t)(many + 1.0) * size)
            : (void *)0;
    if (!a)
        fail("not enough memory: no room for another %.3g MB",
             many * (double)size / 1e6);
    return a;
}

void *space(double many, size_t size)
{
    return more_space((void *)0, many, size);
}

/* ------------------------------------------------------------- reporting */

double tetrahedron_volume(const mesh *m, tess_int t)
{
    const tess_real *a = m->in->p + 3 * m->tet[4 * t], *q;
    double e[3][3];
    int i, k;

    for (i = 0; i < 3; i++) {
        q = m->in->p + 3 * m->tet[4 * t + i + 1];
        for (k = 0; k < 3; k++) e[i][k] = (double)q[k] - (double)a[k];
    }
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6.0;
}

/* kept - is tetrahedron t written? */
static int kept(tess_int t)
{
    return t >= 0 && (!made.keep || made.keep[t]);
}

/* report_column - its title, range, and the number that is there suspiciously
 * often: more than twice as often as any other one. */
static void report_column(const char *what, const char *title, int k,
                          frequency *f)
{
    int narrow = k < 3 && sizeof(tess_real) < sizeof(double);
    char low[REAL], high[REAL], most[REAL];

    count_numbers(&in, k, 0, 0, f);
    real_text(low, f->low, narrow);
    real_text(high, f->high, narrow);
    real_text(most, f->most, narrow);
    if (strcmp(title, what) == 0) title = "";
    tell("%-13s %s%s", what, title, title[0] ? ": " : "");
    if (f->all == 0) tell("no finite number");
    else if (f->different == 1) tell("%s in all rows", low);
    else tell("%s to %s", low, high);
    if (f->different > 2 && f->times > 2 && f->times > 2 * f->next)
        tell("; %s in %ld rows, no other number in more than %ld", most,
             f->times, f->next);
    if (f->all > 0 && f->all < (long)in.n)
        tell("; not finite in %ld", (long)in.n - f->all);
    tell("\n");
}

/* report_words - how many there are, the ones that are most often, and in how
 * many rows. */
static void report_words(int column)
{
    const classes *c = in.words[column];
    long n = class_count(c), k, best, *times, shown = 0;
    tess_int i;

    times = (long *)space((double)n, sizeof *times);
    for (k = 0; k < n; k++) times[k] = 0;
    for (i = 0; i < in.n; i++)
        times[(long)in.value[(size_t)in.columns * (size_t)i +
                             (size_t)column]]++;
    tell("value         %s: %ld word%s: ", in.name[column], n,
         n > 1 ? "s" : "");
    for (; shown < n && shown < FEW_WORDS; shown++) {
        for (best = k = 0; k < n; k++)
            if (times[k] > times[best]) best = k;
        tell("%s%s in %ld row%s", shown > 0 ? ", " : "",
             class_name(c, (double)best), times[best],
             times[best] > 1 ? "s" : "");
        times[best] = 0;
    }
    tell(shown < n ? ", ...\n" : "\n");
    free(times);
}

/* tell_words - which numbers stand for them, where files have numbers. */
static void tell_words(void)
{
    output *o;
    int column, others = 0;
    long k, n;

    for (o = 0; (o = next_output(0, o)) != 0;)
        others |= o->as != values_forms && o->as != errors_forms;
    for (column = 0; column < in.columns && others; column++) {
        if (!in.words[column]) continue;
        n = class_count(in.words[column]);
        for (k = 0; k < n && k < LISTED; k++)
            warn("%s: %ld is %s, where numbers are written", in.name[column], k,
                 class_name(in.words[column], (double)k));
        if (k < n)
            warn("%s: and so on to %ld, as they come in %s", in.name[column],
                 n - 1, in.input);
    }
}

/* report_points - and their columns: so a file that is misread shows. */
static void report_points(void)
{
    static const char *const axis[] = {"x", "y", "z"};
    frequency f;
    double side[3];
    int k;

    if (chosen.quiet) return;
    tell("points        %ld", (long)in.n);
    if (in.columns > 0)
        tell(", each with %d value%s", in.columns, in.columns > 1 ? "s" : "");
    tell("\n");
    for (k = 0; k < in.axes; k++) {
        report_column(axis[k], in.axis[k], k, &f);
        side[k] = f.high - f.low;
    }
    tell("extent        %.6g x %.6g", side[0], side[1]);
    if (in.axes == 3) tell(" x %.6g", side[2]);
    tell("\n");
    for (k = 0; k < in.columns && k < LISTED; k++)
        if (in.words[k]) report_words(k);
        else report_column("value", in.name[k], 3 + k, &f);
    if (k < in.columns) tell("values        %d more\n", in.columns - k);
}

/* with_others - how many duplicates have other values than the points that
 * stand for them? */
static long with_others(void)
{
    const double *a, *b;
    tess_int i;
    long many = 0;
    int k;

    for (i = 0; i < in.n && in.columns > 0 && !chosen.periodic; i++) {
        a = in.value + (size_t)in.columns * (size_t)i;
        b = in.value + (size_t)in.columns * (size_t)made.iw[i];
        for (k = 0; k < in.columns && (a[k] == b[k] || a[k] != a[k]);) k++;
        many += k < in.columns;
    }
    return many;
}

static void report(tess_int duplicates, double seconds, double bytes)
{
    tess_int t;
    long facets = 0;
    double volume = 0.0;
    int k;

    for (t = 0; t < made.ntet; t++) {
        if (!kept(t)) continue;
        volume += tetrahedron_volume(&made, t);
        for (k = 0; k < 4; k++) facets += !kept(made.adj[4 * t + k]);
    }

    tell("duplicates    %ld", (long)duplicates);
    if (duplicates > 0 && with_others() > 0)
        tell(", %ld with other values", with_others());
    tell("\n");
    /* (each of these has one tetrahedron on either side) */
    if (valued->flat) tell("triangles     %ld\n", (long)valued->ntet / 2);
    if (in.axes == 3) {
        tell("tetrahedra    %ld", (long)made.kept);
        tell(made.keep ? " in the alpha shape, of %ld\n" : "\n",
             (long)made.ntet);
        tell(made.keep ? "boundary      %ld triangles\n"
                       : "hull          %ld triangles\n",
             facets);
        tell(volume <= DBL_MAX ? "volume        %.9g\n"
                               : "volume        beyond the range of double\n",
             volume);
    }
    tell("seconds       %.3f", seconds);
    if (made.ntet > 0 && seconds > 0.05)
        tell(", %.0f ns a tetrahedron", seconds / (double)made.ntet * 1e9);
    tell("\n");
    if (bytes > 0.0)
        tell("workspace     %.0f bytes, %.1f a point: the library's, beside "
             "points and mesh\n", bytes, bytes / (double)in.n);
    if (none && in.axes == 3) tell("no tetrahedron: %s\n", none);
}

/* explain - leave with a sentence for a code that is no result. */
static void explain(int code)
{
    switch (code) {
    case TESS_MORE:
    case TESS_POOL:
        too_small("more tetrahedra than a tess_int of %d bytes can number; "
                  "rebuild with a larger -DTESS_INT=...",
                  (int)sizeof(tess_int));
        break;
    case TESS_RANGE:
        too_small("the coordinates differ too much in magnitude for numbers "
                  "of %d limbs; rebuild with a larger -DHH_LIMBS=...",
                  HH_LIMBS);
        break;
    case -2:
        /* (in a file they are finite) */
        fail("%s: point %ld is beyond the range of numbers",
             chosen.scaled ? "-scale" : in.input,
             (long)(made.ntet + in.base));
        break;
    default:
        too_small("unexpected code %d", code);
    }
}

/* prove - run tess_check and say what it found; returns the exit status. */
static int prove(void)
{
    tess_int bad = TESS_NONE;
    int code;
    const char *what;

    if (chosen.periodic) {
        /* (triclinic has found so) */
        tell("check         proven: a Delaunay tetrahedralization of the "
             "points, rounded to\n              1e-15 of the box, and all "
             "copies\n");
        return 0;
    }
    say("checking ...");
    code = tess_check(in.n, made.p, made.ntet, made.tet, made.adj, made.liw,
                      made.iw, &bad);
    switch (code) {
    case 0:
        tell("check         proven: %s\n",
             made.ntet > 0 ? "a Delaunay tetrahedralization of the points"
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

/* room_for - see that the mesh has room for so many tetrahedra, and so long a
 * workspace, whose contents go. */
static void room_for(mesh *m, double tetrahedra, double integers, double reals)
{
    if (tetrahedra > (double)MOST) tetrahedra = (double)MOST;
    if (tetrahedra > (double)m->maxtet) {
        m->tet = (tess_int *)more_space(m->tet, 4.0 * tetrahedra,
                                        sizeof *m->tet);
        m->adj = (tess_int *)more_space(m->adj, 4.0 * tetrahedra,
                                        sizeof *m->adj);
        m->maxtet = (tess_int)tetrahedra;
    }
    if (integers > (double)TESS_INT_MOST) integers = (double)TESS_INT_MOST;
    if (integers > (double)m->liw) {
        free(m->iw);
        m->iw = (tess_int *)space(integers, sizeof *m->iw);
        m->liw = (tess_int)integers;
    }
    if (reals > (double)m->lrw) {
        free(m->rw);
        m->rw = (double *)space(reals, sizeof *m->rw);
        m->lrw = (tess_int)reals;
    }
}

/* (To resume takes about as long as n tetrahedra of a cloud, and a third of
 * what is there already: slices shall take four times that, lest the telling be
 * the work.) */
int tetrahedralize(mesh *m, tess_int n, const tess_real *p, int telling)
{
    clock_t begin = clock(), last = begin;
    tess_int room = n / 4 + 1000, before = 0, liw, lrw;
    double rate, slice, resume;
    int code;

    if (tess_size(n, 0, &liw, &lrw) != 0)
        too_small("%ld points are too many for a tess_int of %d bytes; "
                  "rebuild with a larger -DTESS_INT=...",
                  (long)n, (int)sizeof(tess_int));
    room_for(m, CLOUD * (double)n + 1e5, (double)liw, (double)lrw);
    m->ntet = 0;
    for (;;) {
        if (room > m->maxtet || !telling) room = m->maxtet;
        code = (m->ntet > 0 ? tess_resume : tess)(n, p, room, &m->ntet, m->tet,
                                                  m->adj, m->liw, m->iw,
                                                  m->lrw, m->rw);
        if (code == TESS_POOL && m->liw < TESS_INT_MOST) {
            say("more room for open facets ...");
            room_for(m, 0.0, 2.0 * (double)m->liw, 0.0);
            continue;
        }
        if (code != TESS_MORE || room == MOST) return code;
        if (room == m->maxtet) room_for(m, GROWTH * (double)room, 0.0, 0.0);
        if (!telling) continue;
        slice = (double)(clock() - last) / CLOCKS_PER_SEC;
        last = clock();
        rate = (slice + 1e-9) / (double)(m->ntet - before);
        resume = (rate < 1e-6 ? rate : 1e-6) *
                 ((double)n + (double)m->ntet / 3.0);
        slice = 4.0 * resume > 1.0 ? 4.0 * resume : 1.0;
        /* whole seconds: a difference of two is one at least */
        if (difftime(time((time_t *)0), began) >= 2.0)
            warn("%ld tetrahedra after %.1f s, of about %.0f if the points "
                 "fill a volume",
                 (long)m->ntet, (double)(last - begin) / CLOCKS_PER_SEC,
                 6.8 * (double)n);
        before = m->ntet;
        slice = slice / rate < 2e9 ? slice / rate : 2e9;
        if (slice > (double)(m->maxtet - room))
            room = m->maxtet;
        else
            room += (tess_int)slice + 1;
    }
}

/* even - a factor for axis k that makes its side as long as the middle one of
 * the three, unless it nearly is. */
static double even(const double *side, int k)
{
    double a = side[0], b = side[1], c = side[2], low, high, middle;

    low = a < b ? a : b;
    high = a < b ? b : a;
    middle = c < low ? low : c > high ? high : c;
    return middle / side[k] > UNEVEN || side[k] / middle > UNEVEN
               ? middle / side[k]
               : 1.0;
}

/* stretch - the points, by -scale; or say that they might want it. */
static void stretch(void)
{
    double low[3], high[3], side[3], x;
    tess_real *stretched = 0;
    tess_int i;
    int k, longest = 0, shortest = 0;

    if (chosen.scaled)
        stretched = (tess_real *)space(3.0 * (double)in.n, sizeof *stretched);
    for (k = 0; k < 3; k++) {
        made.scale[k] = chosen.scaled ? fabs(chosen.scale[k]) : 1.0;
        low[k] = high[k] = (double)in.p[k];
        for (i = 0; i < in.n; i++) {
            x = (double)in.p[3 * i + k];
            if (chosen.scaled)
                stretched[3 * i + k] = (tess_real)(x * made.scale[k]);
            if (x < low[k]) low[k] = x;
            if (x > high[k]) high[k] = x;
        }
        side[k] = high[k] - low[k];
        if (side[k] > side[longest]) longest = k;
        if (side[k] < side[shortest]) shortest = k;
    }
    made.p = chosen.scaled ? stretched : in.p;
    /* (where no side is so much shorter, or longer, than the middle one that
     * would alter nothing) */
    if (!chosen.scaled && !in.doubted && side[shortest] > 0.0 &&
        side[longest] <= DBL_MAX && side[longest] / UNEVEN > side[shortest] &&
        (even(side, longest) != 1.0 || even(side, shortest) != 1.0))
        warn("x, y, z extend over %.3g, %.3g, %.3g: if their units differ, "
             "the mesh is of needles; stretch: -scale %.1g,%.1g,%.1g (-scale "
             "1,1,1 leaves all as they are)",
             side[0], side[1], side[2], even(side, 0), even(side, 1),
             even(side, 2));
}

/* alpha - the shape; also of what values are between, if it is another mesh. */
static void alpha(void)
{
    static mesh shape;
    char text[REAL];

    if (chosen.automatic && made.ntet > 0) {
        chosen.alpha = least_alpha(&made);
        real_text(text, chosen.alpha, 0);
        tell("alpha         %s, the least that leaves one piece with all "
             "points\n", text);
    }
    mark_alpha(&made, chosen.alpha);
    if (valued == &made) return;
    shape = *valued;
    shape.keep = alpha_shape(&shape, chosen.alpha);
    valued = &shape;
}

/* write_all - what is asked for: first what the whole mesh gives. */
static void write_all(void)
{
    int dots = chosen.draw && strcmp(chosen.draw, "points") == 0;
    output *o;

    if (chosen.values) write_values(valued);
    if (chosen.cells) make_cells(chosen.periodic ? &repetition()->of : &made);
    for (o = 0; (o = next_output(svg_forms, o)) != 0;)
        if (made.kept > 0 || dots)
            write_svg(&made, o);
        else /* (even by -q: it is not written) */
            fprintf(stderr, "tess: %s: no picture of a mesh: %s; -draw points "
                            "draws the points\n",
                    o->name, none ? none : "-alpha leaves no tetrahedron");
    if (made.keep) drop_others(&made);
    for (o = 0; (o = next_output(0, o)) != 0;)
        if (o->all == iso_forms && made.ntet < 1)
            warn("%s: no surface: %s", o->name,
                 none ? none : "-alpha leaves no tetrahedron");
        else if (o->as->write)
            o->as->write(&made, o);
}

int main(int argc, char **argv)
{
    tess_int duplicates = 0, i;
    char others[60] = "";
    int code, status = 0;
    clock_t begin;
    double seconds;

    open_standard();
    choose_options(argc, argv);
    began = time((time_t *)0);
    in.cols = chosen.cols;
    in.skip = chosen.skip;
    in.decimal = places.decimal = chosen.decimal;
    in.nodata = chosen.nodata;
    in.voids = chosen.voids;
    in.by = chosen.by;
    in.named = !chosen.by && next_output(volumes_forms, 0);
    in.surfaced = next_output(volumes_forms, 0) != 0;
    places.cols = chosen.qcols;
    places.skip = chosen.skip;
    places.bare = places.copied = 1;
    in.copied = next_output(errors_forms, 0) != 0;
    in.classed = (chosen.values || chosen.validate) && chosen.method &&
                 strcmp(chosen.method, "nearest") == 0;
    read_places(&places);
    if (chosen.scaled == 2 && !chosen.plane)
        fail("-scale needs three numbers above 0; two are of points in a "
             "plane");
    /* (what -by tells apart need not be a value, so three names are three
     * coordinates) */
    in.axes = chosen.plane                                        ? 2
              : chosen.validate && !chosen.values && !chosen.by &&
                      !next_output(iso_forms, 0)
                  ? 0
                                                                : 3;
    read_points(chosen.input, &in);
    check_box(&in);
    check_points(&in);
    check_levels(&in);
    announce_all(&in);
    report_points();
    tell_words();
    made.in = &in;
    stretch();
    say("tetrahedralizing %ld points, about %.1f s if they fill a volume ...",
        (long)in.n, 2.1e-6 * (double)in.n);
    begin = clock();
    code = chosen.periodic
               ? repeat(&made, &duplicates)
               : tetrahedralize(&made, in.n, made.p, !chosen.quiet);
    seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    if (code != TESS_OK && code != TESS_PLANE && code != TESS_LINE &&
        code != TESS_POINT)
        explain(code);
    if (code == TESS_PLANE) none = "all points lie in one plane";
    if (code == TESS_LINE) none = "all points lie on one line";
    if (code == TESS_POINT) none = "at most one distinct point";

    for (i = 0; i < in.n && !chosen.periodic; i++)
        if (made.iw[i] != i) duplicates++;
    made.kept = made.ntet;
    keep_levels(&made);
    valued = &made;
    if (chosen.periodic && chosen.values)
        valued = repeat_around(chosen.method &&
                               strcmp(chosen.method, "smooth") == 0);
    valued = keep_values(valued);
    if (chosen.alpha > 0.0) alpha();
    if (!chosen.quiet)
        report(duplicates, seconds,
               (double)made.liw * (double)sizeof(tess_int) +
                   (double)made.lrw * (double)sizeof(double));
    else if (duplicates > 0) {
        if (with_others() > 0)
            sprintf(others, ", %ld with other values", with_others());
        warn(duplicates > 1
                 ? "%s: %ld duplicates: points where another one lies%s"
                 : "%s: %ld duplicate: a point where another one lies%s",
             in.input, (long)duplicates, others);
    }
    if (chosen.check) status = prove();
    free(made.iw);
    free(made.rw);
    made.iw = 0;
    made.rw = 0;
    made.liw = made.lrw = 0;
    write_all();
    if (chosen.validate) validate_values(&made);
    if (fflush(stdout) || ferror(stdout)) fail("standard output: write error");
    return status;
}
