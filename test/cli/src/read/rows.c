/* rows.c - what a file's columns are; its rows, which become points, or are
 * dropped.
 */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define HEADS 12     /* rows that may sum up those behind them */
#define SPILL 131072 /* places that are kept at once, if there are more */

/* ------------------------------------------------------------ the points */

/* passed_rows - those so far, kept or dropped. */
static double passed_rows(const reader *r)
{
    return (double)r->to->n + r->many[DROPPED];
}

/* tally - one more of these. */
static void tally(reader *r, int what)
{
    if (r->many[what]++ == 0.0) r->first[what] = r->s.number;
}

/* rooms - for so many points, and their values. */
static void rooms(points *to, double most)
{
    to->room = most;
    to->values = to->bare ? 0.0 : most * (double)to->columns;
    to->p = (tess_real *)more_space(to->p, 3.0 * most, sizeof *to->p);
    to->line = (long *)more_space(to->line, most, sizeof *to->line);
    to->value = (double *)more_space(to->value, to->values, sizeof *to->value);
}

/* spill - places, of which there are many, into a file of their own. */
static void spill(reader *r)
{
    points *to = r->to;
    size_t here = (size_t)(to->n - r->spilled);

    if (!to->scratch)
        to->scratch = open_scratch(to->input,
                                   3.0 * SPILL * (double)sizeof *to->p);
    if (fwrite(to->p, 3 * sizeof *to->p, here, to->scratch) != here)
        no_scratch(to->input);
    r->spilled = to->n;
}

void next_places(points *a, int first)
{
    if (!a->scratch) return;
    if (first) rewind(a->scratch);
    a->n = (tess_int)fread(a->p, 3 * sizeof *a->p, SPILL, a->scratch);
    if (a->n == 0) fail("%s: a temporary file cannot be read", a->input);
}

/* add_point - one more: r->x has its coordinates, and values. */
static void add_point(reader *r)
{
    points *to = r->to;
    tess_int at;
    double *v;
    int k;

    if (to->n >= TESS_INT_MOST / 5)
        too_small("%s:%ld: more points than a tess_int of %d bytes can "
                  "number; rebuild with a larger -DTESS_INT=...",
                  to->input, r->s.number, (int)sizeof(tess_int));
    if (to->bare && to->n - r->spilled >= SPILL) spill(r);
    at = to->n - r->spilled;
    if ((double)at >= to->room) rooms(to, 2.0 * (double)at + 2.0);
    for (k = 0; k < 3; k++) {
        to->p[3 * at + k] = k < r->axes ? (tess_real)r->x[k] : (tess_real)0;
        if (!(fabs((double)to->p[3 * at + k]) <= DBL_MAX))
            scan_fail(&r->s, "a coordinate is not finite");
    }
    to->line[at] = r->s.number;
    v = to->value + (size_t)to->columns * (size_t)at;
    for (k = 0; k < to->columns; k++) v[k] = r->x[r->axes + k];
    to->n++;
    if (to->n % 4096 == 0)
        progress("reading", scan_passed(&r->s) - r->left * r->share,
                 r->s.size > 0.0 ? r->s.size : 0.0);
}

/* add_group - the label of the last point's group, or its name. */
static void add_group(reader *r, const char *text, size_t length)
{
    points *to = r->to;
    tess_int i = to->n - 1;

    /* (where i is a power of two, or 0) */
    if ((i & (i - 1)) == 0)
        to->label = (size_t *)more_space(to->label, 2.0 * (double)i + 1.0,
                                         sizeof *to->label);
    if (i > 0 && strlen(to->labels + to->label[i - 1]) == length &&
        memcmp(to->labels + to->label[i - 1], text, length) == 0) {
        to->label[i] = to->label[i - 1];
        return;
    }
    if (r->labelled + length >= r->labels_room) {
        r->labels_room = 2 * (r->labels_room + length) + 1;
        to->labels = (char *)more_space(to->labels, (double)r->labels_room, 1);
    }
    to->label[i] = r->labelled;
    memcpy(to->labels + r->labelled, text, length);
    r->labelled += length;
    to->labels[r->labelled++] = '\0';
}

static int earlier(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* number_groups - in the order of their labels, from 0 on. */
static void number_groups(points *to, const char *title)
{
    const char **list = (const char **)space((double)to->n, sizeof *list);
    const char *label;
    size_t groups = 0;
    tess_int i;

    to->group = (tess_int *)space((double)to->n, sizeof *to->group);
    for (i = 0; i < to->n; i++) list[i] = to->labels + to->label[i];
    qsort(list, (size_t)to->n, sizeof *list, earlier);
    for (i = 0; i < to->n; i++)
        if (i == 0 || strcmp(list[i], list[groups - 1]) != 0)
            list[groups++] = list[i];
    for (i = 0; i < to->n; i++) {
        label = to->labels + to->label[i];
        to->group[i] = (tess_int)((const char **)bsearch(
            &label, list, groups, sizeof *list, earlier) - list);
    }
    tell_alike(to, title, list, groups);
    free((void *)list);
    free(to->labels);
    free(to->label);
    to->labels = 0;
    to->label = 0;
}

void lattice(points *to, const double v[9], const double *origin)
{
    double side;
    int across, k, l;

    to->lattice = RIGHT;
    for (k = 0; k < 12; k++) to->cell[k] = k < 9 ? v[k] : origin[k - 9];
    for (k = 0; k < 3; k++) {
        to->ways[k] = 1;
        side = 0.0;
        for (across = l = 0; l < 3; l++) {
            across += v[3 * k + l] != 0.0;
            side += v[3 * l + k];
        }
        to->box[2 * k] = origin[k] + (side < 0.0 ? side : 0.0);
        to->box[2 * k + 1] = origin[k] + (side > 0.0 ? side : 0.0);
        if (across != 1 || !(to->box[2 * k] < to->box[2 * k + 1]))
            to->lattice = SKEW;
    }
}

/* ----------------------------------------------------------- the columns */

const char *axes_option(const reader *r)
{
    return r->to->bare ? "-qcols" : "-cols";
}

column *add_column(reader *r, const char *title)
{
    column *c = r->column + r->columns;

    if (r->columns == COLUMNS)
        scan_fail(&r->s, "more than %d columns", COLUMNS);
    memset(c, 0, sizeof *c);
    c->role = VALUE;
    sprintf(c->title, "%.*s", TITLE - 1, title);
    r->columns++;
    return c;
}

column *add_packed(reader *r, const char *title, char type, int bytes)
{
    column *c = add_column(r, title);

    c->type = type;
    c->bytes = bytes;
    c->at = r->stride;
    r->stride += bytes;
    return c;
}

void add_axes(reader *r, char type, int bytes)
{
    add_packed(r, "x", type, bytes);
    add_packed(r, "y", type, bytes);
    add_packed(r, "z", type, bytes);
}

void title_of(const cell *c, char *title)
{
    sprintf(title, "%.*s", PART(c, TITLE - 1));
    if (c->quoted == 1) *unquote(title, title + strlen(title)) = '\0';
}

int is_titled(const char *title, const char *name, size_t length, int fold)
{
    for (; length > 0; length--, title++, name++)
        if (*title != *name && (!fold || tolower((unsigned char)*title) !=
                                             tolower((unsigned char)*name)))
            return 0;
    if (*title == ' ' && is_unit(title + 1, title + strlen(title))) return 1;
    title += strspn(title, " \t");
    return !*title || *title == '(' || *title == '[';
}

#define LISTED 40 /* titles, of columns that there are */

/* no_column - leave: none is called so; which ones there are. */
static void no_column(const reader *r, const char *s, size_t length,
                      const char *of)
{
    char *text = (char *)space((double)LISTED * (TITLE + 8) + 80.0, 1);
    int k, titles = 0;

    text[0] = '\0';
    for (k = 0; k < r->columns; k++) titles |= r->column[k].title[0];
    if (!titles) strcpy(text, ", and no line of names before them");
    if (titles && r->titled > 0)
        sprintf(text, ", which line %ld names", r->titled);
    for (k = 0; titles && k < r->columns && k < LISTED; k++)
        sprintf(text + strlen(text), "%s %s", k ? "," : ":",
                r->column[k].title[0] ? r->column[k].title : "(no name)");
    if (titles && k < r->columns)
        sprintf(text + strlen(text), ", and %d more", r->columns - k);
    scan_fail(&r->s, "%s: no column \"%.*s\" among %d%s", of,
              (int)(length < 40 ? length : 40), s, r->columns, text);
}

/* find - the column that is named, by number or by name, else the first one
 * that differs in small and capital letters alone; for that option. */
static int find(reader *r, const char *s, size_t length, const char *of)
{
    double n;
    int k, fold;

    if (whole(s, s + length, &n) && n <= (double)r->columns && *s != '0')
        return (int)n - 1;
    for (fold = 0; fold < 2; fold++)
        for (k = 0; k < r->columns && length > 0; k++)
            if (is_titled(r->column[k].title, s, length, fold)) return k;
    no_column(r, s, length, of);
    return 0;
}

/* choose - the columns that -cols names: x, y, z, then values.  Returns how
 * many. */
static int choose(reader *r, int *at)
{
    const char *s = r->to->cols;
    size_t length;
    int found = 0, k, j, word;

    for (;;) {
        length = strcspn(s, ",");
        k = find(r, s, length, axes_option(r));
        word = r->column[k].role == LABEL && !(r->to->classed && found > 1);
        if (word && !r->waits)
            scan_fail(&r->s, "%s: column %.40s has no numbers", axes_option(r),
                      r->column[k].title);
        if (word) bad_cell(r, k);
        for (j = 0; j < found && at[j] != k;) j++;
        if (j < found)
            fail("%s: column %.*s twice", axes_option(r), (int)length, s);
        at[found++] = k;
        s += length;
        if (!*s++) return found;
    }
}

/* least - the numbers of a row that may be a point's. */
static int least(const reader *r)
{
    const points *to = r->to;

    return to->axes == 2 || (to->bare && r->columns == 2) ? 2 : 3;
}

/* begun - is the cell a word that begins as a number? */
static int begun(const cell *c)
{
    const char *s = c->text + (*c->text == '-' || *c->text == '+');

    return c->kind == WORD && isdigit((unsigned char)*s);
}

/* too_few - numbers for a point. */
static void too_few(reader *r)
{
    int k, found = 0;

    for (k = 0; k < r->columns; k++) {
        found += r->column[k].role == VALUE;
        if (r->form == LINES && r->cell[k].kind != NUMBER &&
            (r->cell[k].kind != WORD || begun(r->cell + k)))
            bad_cell(r, k);
    }
    scan_fail(&r->s, "fewer than %s numbers%s%s",
              least(r) == 2 ? "two" : "three",
              r->by >= 0 && r->column[r->by].role == VALUE
                  ? " beside -by's column" : "",
              least(r) == 2 || r->to->bare || found != 2
                  ? ""
                  : "; for points in a plane, x, y and values, see -plane");
}

/* put_text - a cell of CSV, as it is if it was quoted. */
static void put_text(FILE *file, const char *text, const char *end, int quoted)
{
    const char *c;
    int need = quoted;

    for (c = text; c < end; c++) need |= *c == ',' || *c == '"';
    if (need) putc('"', file);
    for (c = text; c < end; c++) {
        if (*c == '"' && !quoted) putc('"', file);
        putc(*c, file);
    }
    if (need) putc('"', file);
}

/* put_others - a line of texts: of each column that is neither a coordinate nor
 * a value, its title, or the row's cell. */
static void put_others(reader *r, int titles)
{
    FILE *file = r->to->texts;
    char text[TITLE + 20];
    const char *from, *end;
    const cell *c = r->cell;
    int k, many = 0;

    for (k = 0; k < r->columns; k++, c++) {
        if (r->column[k].role < LABEL) continue;
        if (many++) putc(',', file);
        if (titles && !r->column[k].title[0]) sprintf(text, "column%d", k + 1);
        else if (titles) strcpy(text, r->column[k].title);
        else if (r->form == PACKED) real_text(text, c->x, 0);
        from = titles || r->form == PACKED ? text : c->text;
        end = from == text ? text + strlen(text) : c->end;
        put_text(file, from, end, from != text && c->quoted);
    }
    putc('\n', file);
    if (ferror(file)) fail("%s: no room for a temporary file", r->to->input);
}

/* name_others - the titles of these columns are points.others. */
static void name_others(reader *r)
{
    points *to = r->to;
    const char *titles;
    int k = 0;

    to->others = 0;
    while (k < r->columns && r->column[k].role < LABEL) k++;
    if (!to->copied || k == r->columns) return;
    to->texts = tmpfile();
    if (!to->texts) fail("%s: no room for a temporary file", to->input);
    put_others(r, 1);
    rewind(to->texts);
    titles = next_text(to);
    to->others = (char *)space((double)strlen(titles) + 1.0, 1);
    strcpy(to->others, titles);
    rewind(to->texts);
}

void take_columns(reader *r)
{
    points *to = r->to;
    column *c = r->column;
    int at[COLUMNS], k, found = 0, others = 0;

    at[0] = at[1] = at[2] = -1;
    r->axes = least(r);
    r->by = to->by ? find(r, to->by, strlen(to->by), "-by") : -1;
    if (to->cols) found = choose(r, at);
    for (k = 0; k < r->columns; k++)
        others += c[k].role == VALUE && k != r->by;
    if (to->axes == 0 && !to->bare && found == 3 &&
        (others == 3 || c[at[2]].role == LABEL))
        r->axes = 2; /* the third one is all that can be a value */
    for (k = 0; k < r->axes && k < found; k++)
        if (c[at[k]].role == LABEL) bad_cell(r, at[k]);
    if (r->shifted && c[0].role == VALUE) c[0].role = UNUSED;
    if (r->number >= 0 &&
        (to->cols || r->shifted || r->number == r->by ||
         c[r->number].title[0] ||
         others <= r->axes + (r->axes == 2 && !to->bare)))
        r->number = -1;
    if (r->number >= 0) c[r->number].role = UNUSED;
    if (!to->cols) place_axes(r, at);
    r->counting = !to->cols && r->family < 0 && r->number < 0;
    for (k = 0; k < r->axes; k++)
        if (at[k] < 0) too_few(r);
    for (k = 0; k < r->columns && found > r->axes; k++)
        if (c[k].role == VALUE || c[k].role == HOLLOW) c[k].role = UNUSED;
    for (k = 0; k < r->columns && to->classed; k++)
        if (c[k].role == LABEL && k != r->by && found <= r->axes) {
            c[k].role = VALUE;
            c[k].classed = 1;
        }
    for (k = r->axes; k < found; k++) {
        c[at[k]].classed = c[at[k]].role == LABEL;
        c[at[k]].role = VALUE;
    }
    for (k = 0; k < r->axes; k++) {
        c[at[k]].role = k;
        r->use[k] = at[k];
        if (c[at[k]].title[0]) strcpy(to->axis[k], c[at[k]].title);
    }
    r->uses = r->axes;
    r->words = 0;
    for (k = 0; k < r->columns; k++) {
        if (c[k].role != VALUE) continue;
        /* (what tells groups apart is a value only if it is named as one) */
        if (to->bare || (k == r->by && found <= r->axes)) {
            c[k].role = UNUSED;
            continue;
        }
        r->use[r->uses++] = k;
        strcpy(to->name[to->columns], c[k].title[0] ? c[k].title : "value");
        if (!c[k].title[0] && to->columns > 0)
            sprintf(to->name[to->columns] + 5, "%d", to->columns + 1);
        to->words[to->columns] = c[k].classed ? new_classes() : 0;
        to->columns++;
    }
    to->labelled[0] = '\0';
    for (k = r->columns - 1; k >= 0 && to->named; k--)
        if (c[k].role == LABEL &&
            (r->by < 0 || strcmp(c[r->by].title, "species") != 0))
            r->by = k;
    if (to->named && r->by >= 0)
        strcpy(to->labelled, c[r->by].title[0] ? c[r->by].title : "name");
    for (k = 0; k < r->columns && !to->cols; k++)
        if ((c[k].role == LABEL || c[k].role == HOLLOW) && k != r->by)
            r->word[r->words++] = k;
    for (r->labels = k = 0; k < r->columns && r->form == LINES; k++)
        if (c[k].role == LABEL || c[k].classed) r->label[r->labels++] = k;
    name_others(r);
}

/* --------------------------------------------------------------- the rows */

/* width - are there as many cells as columns?  (One more may be empty.) */
static int width(const reader *r)
{
    return r->cells == r->columns ||
           (r->cells == r->columns + 1 && r->more);
}

/* bound - a number beyond double is none. */
static void bound(cell *c)
{
    if (c->kind == NUMBER && !(fabs(c->x) <= DBL_MAX)) c->kind = INFINITE;
}

/* dropped_kind - does -skip drop a row for such a cell? */
static int dropped_kind(const cell *c)
{
    return c->kind == EMPTY || c->kind == ABSENT || c->kind == STARS;
}

/* same_fault - is the cell, of column k, as bad as that one? */
static int same_fault(const reader *r, int k, const cell *bad)
{
    cell c = r->cell[k];

    bound(&c);
    /* (NaN is a value) */
    return width(r) && (!r->begins || cell_is(r->cell, r->begins)) &&
           c.kind == bad->kind && (c.quoted == 2) == (bad->quoted == 2) &&
           (r->column[k].role < VALUE || (c.x == c.x) == (bad->x == bad->x));
}

void bad_cell(reader *r, int k)
{
    const cell bad = r->cell[k], *c = &bad;
    const char *name = r->column[k].title, *why = remedy(c, r->d.decimal);
    const char *what = c->kind == EMPTY      ? "empty"
                       : c->kind == ABSENT && r->column[k].lacks
                           ? "what stands for no number in this file"
                       : c->kind == INFINITE ? "not finite"
                       : c->kind == NUMBER   ? "a number among words"
                                             : "not a number";
    char text[48], also[80] = "";
    long line = r->s.number, last = 0, like = 0, all = 0;
    double rows = passed_rows(r);

    if (r->to->skip && dropped_kind(c)) why = "";
    if (c->kind == BELOW && r->column[k].role < VALUE) why = " (a limit)";
    sprintf(text, "\"%.*s\": ", SHOWN(c));
    if (c->kind == EMPTY) text[0] = '\0';
    if (r->form == PACKED) strcpy(text, c->kind == ABSENT ? "NaN: " : "");
    while (r->form == LINES && (r->want < 0.0 || ++rows < r->want) &&
           next_cells(r) > 0) {
        all++;
        if (!same_fault(r, k, c)) continue;
        like++;
        last = r->s.number;
    }
    /* (cells that were merged are in the first one of several rows alone) */
    rows = passed_rows(r);
    if (c->kind == EMPTY && (k == r->by || r->column[k].role < VALUE) &&
        rows > 0.0 && (double)(like + 1) > (rows + 1.0 + (double)all) *
                                               (k == r->by ? 0.4 : 0.7))
        why = " (merged cells?  Each line needs its own)";
    if (like > 0)
        sprintf(also, "; so %s %ld more, to line %ld", like > 1 ? "are" : "is",
                like, last);
    r->s.number = line;
    scan_fail(&r->s, "column %d%s%s: %s%s%s%s%s", k + 1, name[0] ? ", " : "",
              name, text, what, also, why,
              r->column[k].role == VALUE && r->uses > r->axes + 1
                  ? "; -cols X,Y,Z,VALUE reads no other values"
              : r->column[k].role == LABEL && !r->to->bare && c->kind == WORD &&
                      (chosen.values || chosen.validate)
                  ? "; -method nearest takes words as values" : "");
}

/* drop - the row, for a cell of that kind, if that is not NUMBER: 1 if so. */
static int drop(reader *r, int kind)
{
    if (kind == NUMBER) return 0;
    tally(r, kind);
    tally(r, DROPPED);
    r->s.dropped += r->share;
    return 1;
}

/* dropping - the kind of the first cell that drops the row; NUMBER: it is
 * kept. */
static int dropping(const reader *r)
{
    const points *to = r->to;
    const cell *c;
    int i, v;

    for (i = 0; i < r->uses && (to->skip || to->voids > 0); i++) {
        c = r->cell + r->use[i];
        if (to->skip && dropped_kind(c)) return c->kind;
        for (v = 0; v < to->voids && c->kind == NUMBER; v++)
            if (c->x == to->nodata[v] && r->use[i] != r->keeps &&
                !r->column[r->use[i]].classed)
                return VOID;
    }
    if (!to->by || !to->skip) return NUMBER;
    c = r->cell + r->by;
    return c->kind == EMPTY || c->kind == ABSENT ? c->kind : NUMBER;
}

/* tiny - has the cell, which is read as 0, another digit before its
 * exponent? */
static int tiny(const cell *c)
{
    const char *s = c->text;

    s += strspn(s, "<>+- \t");
    s += strspn(s, "0.,");
    return s < c->end && isdigit((unsigned char)*s);
}

/* take_cell - the number, of column k, the i-th one in use. */
static void take_cell(reader *r, int k, int i)
{
    cell *c = r->cell + k;
    int l = 0;

    if (r->column[k].classed) {
        if (c->kind == EMPTY) bad_cell(r, k);
        if (c->quoted) c->end = unquote(c->text, c->end);
        r->x[i] = class_number(r->to->words[i - r->axes], c->text,
                               (size_t)(c->end - c->text));
        return;
    }
    bound(c);
    if (c->x == 0.0 && tiny(c)) tally(r, TINY);
    if (c->kind != NUMBER && i < r->axes) bad_cell(r, k);
    if (c->x != c->x) {
        tally(r, NANS);
        c->x = no_number();
    } else if (c->kind == INFINITE) {
        tally(r, INFINITES);
    } else if (c->kind == BELOW && chosen.limits) {
        /* (more than that is not half of it) */
        tally(r, *c->text == '<' ? LIMITS : ABOVE);
        if (*c->text == '<') c->x *= chosen.below;
        while (l < r->limits && r->limit[l] != c->x) l++;
        if (l == r->limits && l < LIMITS_KEPT) r->limit[r->limits++] = c->x;
    } else if (c->kind != NUMBER)
        bad_cell(r, k);
    r->x[i] = c->x;
}

/* take_words - the cells that must be no numbers. */
static void take_words(reader *r)
{
    const cell *c;
    column *of;
    int i;

    for (i = 0; i < r->words; i++) {
        c = r->cell + r->word[i];
        of = r->column + r->word[i];
        if (!of->shown[0]) /* (when that is told) */
            sprintf(of->shown, "%.*s", PART(c, 20));
        if (c->kind == NUMBER ||
            (of->role == HOLLOW && c->kind != EMPTY && c->kind != ABSENT))
            bad_cell(r, r->word[i]);
    }
}

void take_row(reader *r)
{
    points *to = r->to;
    cell *c;
    double y[3];
    int i, k;

    if (r->words > 0) take_words(r);
    if (r->number >= 0) check_numbers(r);
    if (drop(r, dropping(r))) return;
    for (i = 0; i < r->uses; i++) take_cell(r, r->use[i], i);
    c = r->by < 0 ? 0 : r->cell + r->by;
    if (to->by && c->kind == EMPTY) bad_cell(r, r->by);
    if (r->number < 0) count_x(r, r->x[0]);
    /* (the first rows, and those at the end, if that is known) */
    if (to->n < HEADS ||
        (r->labels > 0 && r->s.size - r->s.passed < 8.0 * SAMPLE))
        doubt_row(r);
    for (k = 0; k < 3 && r->scaled; k++) {
        y[k] = to->cell[9 + k];
        for (i = 0; i < 3; i++) y[k] += r->x[i] * to->cell[3 * i + k];
        if (k == 2) memcpy(r->x, y, sizeof y);
    }
    add_point(r);
    r->s.rows += r->share;
    if (to->others) put_others(r, 0);
    if (!c) return;
    if (c->quoted) c->end = unquote(c->text, c->end);
    add_group(r, c->text, (size_t)(c->end - c->text));
}

/* packed_row - the next one's cells; 0 at the end.  text: where numbers that
 * tell groups apart become words. */
static int packed_row(reader *r, char *text)
{
    const column *c = r->column;
    cell *to = r->cell;
    int k;

    if (r->left == 0.0) {
        r->row = scan_take(&r->s, (size_t)r->record);
        if (!r->row) return 0;
        r->left = r->per;
    } else
        r->row += (size_t)r->stride;
    r->left--;
    r->s.number++;
    text[0] = '\0';
    for (k = 0; k < r->columns; k++, c++, to++) {
        if (c->role > VALUE && k != r->by && !r->to->others) continue;
        to->text = to->end = text;
        to->quoted = 0;
        to->x = stored(r->row + (size_t)c->at, c->type, c->bytes, r->big);
        if (c->type != 'f' && fabs(to->x) > WHOLE) tally(r, ROUNDED);
        to->kind = to->x == to->x ? NUMBER : ABSENT;
        if (c->times != 0.0) to->x = c->times * to->x + c->plus;
        if (k != r->by) continue;
        real_text(text, to->x, 0);
        to->end = text + strlen(text);
    }
    return 1;
}

/* check_number - leave if column 1 does not number the row. */
static void check_number(reader *r)
{
    double x;

    if (passed_rows(r) == 0.0 && cell_is(r->cell, "1")) r->to->base = 1;
    if (!cell_whole(r->cell, &x) ||
        x != passed_rows(r) + (double)r->to->base)
        scan_fail(&r->s, "column 1, number: \"%.*s\": points are not numbered "
                  "one after the other from 0 or 1", SHOWN(r->cell));
}

/* both_commas - leave if commas have a blank behind here, and none there, in a
 * line without a point. */
static void both_commas(reader *r)
{
    const cell *c = r->cell;
    int k, glued = 0, spaced = 0;

    for (k = 0; k + 1 < r->cells; k++, c++) {
        if (c->kind != NUMBER || c[1].kind != NUMBER || c->quoted ||
            c[1].quoted)
            continue;
        glued |= c->end + 1 == c[1].text;
        spaced |= c[1].text[-1] == ' ';
    }
    if (glued && spaced &&
        !memchr(r->s.line, '.', (size_t)(c->end - r->s.line)))
        scan_fail(&r->s, "\"%.40s\": commas with and without a blank behind "
                  "(a decimal comma?  -decimal , reads it; else no blanks)",
                  r->s.line);
}

void take_lacking(reader *r, int k)
{
    cell *c = r->cell + k;

    if (!r->column[k].lacks || c->kind != NUMBER ||
        c->x != r->column[k].lacking)
        return;
    c->kind = ABSENT;
    c->x = no_number();
}

/* fill - an empty cell of what says where a station is is as it was in the row
 * before. */
static void fill(reader *r)
{
    const points *to = r->to;
    column *of = r->column;
    cell *c = r->cell;
    int k;

    for (k = 0; k < r->columns; k++, c++, of++) {
        if (c->kind == NUMBER) of->last = c->x;
        if (c->kind != EMPTY || to->n == 0) continue;
        if (of->role < 2 || strncmp(of->title, "Bot. Depth", 10) == 0) {
            c->kind = NUMBER;
            c->x = of->last;
        } else if (k == r->by) {
            c->text = to->labels + to->label[to->n - 1];
            c->end = c->text + strlen(c->text);
            c->kind = WORD;
        }
    }
}

/* lines_row - the next one's cells; 0 at the end. */
static int lines_row(reader *r)
{
    int k;

    if (!r->waits && next_cells(r) == 0) return 0;
    r->waits = 0;
    if (r->torn > 0 && r->torn <= r->columns) bad_cell(r, r->torn - 1);
    if (!width(r))
        scan_fail(&r->s, "%d column%s, but others have %d%s", r->cells,
                  r->cells > 1 ? "s" : "", r->columns,
                  r->cells == 1 ? " (one separator in a file)"
                  : r->d.separator == '\t' ? " (empty cells?  see -skip)" : "");
    if (r->d.separator == ',' && r->d.decimal == '.' && strchr(r->s.line, ' '))
        both_commas(r);
    if (r->numbered) check_number(r);
    for (k = 0; k < r->columns; k++) take_lacking(r, k);
    if (r->fills) fill(r);
    return 1;
}

/* take_rows - want of them, or all. */
static void take_rows(reader *r)
{
    char text[40];

    while ((r->want < 0.0 || passed_rows(r) < r->want) &&
           (r->form == PACKED ? packed_row(r, text) : lines_row(r)))
        take_row(r);
    if (passed_rows(r) < r->want)
        fail("%s: ends after %.0f of %.0f points", r->s.name, passed_rows(r),
             r->want);
}

void take_all(reader *r, const char *behind)
{
    scan *s = &r->s;

    if (r->form == PACKED) {
        scan_take(s, 0);
        s->head = scan_passed(s);
        s->blank = 0.0;
        s->number = 0;
        if (r->record == 0.0) {
            r->record = r->share = r->stride;
            r->per = 1.0;
        }
    }
    scan_room(s, r->want, r->form == PACKED ? r->share : 2.0 * r->columns);
    take_columns(r);
    take_rows(r);
    if (behind) scan_rest(s, behind);
}

/* ------------------------------------------------------------- the sample */

/* NUMERIC - of kinds, a bit each: those that stand where numbers do. */
#define BIT(kind) (1 << (kind))
#define NUMERIC (BIT(NUMBER) | BIT(NEAR) | BIT(BELOW) | BIT(INFINITE))

static int numeric(const cell *c)
{
    return (NUMERIC & BIT(c->kind)) != 0;
}

void sample_again(reader *r, double lines)
{
    scan_again(&r->s);
    for (r->looked = 0.0; r->looked < lines && in_sample(&r->s) &&
                          next_line(&r->s);)
        r->looked++;
}

int sampled(reader *r)
{
    if (r->looked >= r->most || !in_sample(&r->s) || !next_line(&r->s) ||
        ends_rows(r))
        return 0;
    r->looked++;
    return cut(r);
}

/* touching - are these numbers, more than one of them, by any separators? */
static int touching(const cell *c, char decimal)
{
    char *s = c->text, *end;
    int many = 0;

    for (; s < c->end; many++) {
        end = number(s, decimal, 0);
        if (end == s || (end < c->end && !strchr(";|, \t", *end))) return 0;
        s = end + strspn(end, ";|, \t");
    }
    return many > 1;
}

/* try_dialect - how many cells of the sample's lines, behind so many, are no
 * words; 0 if they are few, or a separator leaves more than one number in a
 * cell of most lines. */
static double try_dialect(reader *r, double first)
{
    const cell *c;
    double score = 0.0, worse = 0.0, rows = 0.0;
    int bad, found;

    sample_again(r, first);
    while (sampled(r) > 0) {
        bad = found = 0;
        for (c = r->cell; c < r->cell + r->cells; c++) {
            found += c->kind != WORD && c->kind != EMPTY;
            bad |= c->kind == WORD && !c->quoted &&
                   touching(c, r->d.decimal);
        }
        worse += bad;
        score += found;
        rows += bad || found > 0;
    }
    return score < 1.5 * rows || 2.0 * worse >= rows ? 0.0 : score;
}

/* named_by - does the first line, of words alone, three at least, have as many
 * cells as all lines behind so many?  Then that separates, whatever is in the
 * cells: several numbers, as in -volumes' neighbours. */
static int named_by(reader *r, double first)
{
    int n, k, rows = 0;

    sample_again(r, 0.0);
    n = sampled(r);
    for (k = 0; k < n && r->cell[k].kind == WORD;) k++;
    if (n < 3 || k < n || r->torn > 0 || first < 1.0) return 0;
    for (sample_again(r, first); (k = sampled(r)) > 0; rows++) {
        if (k != n || r->torn > 0) return 0;
        while (k > 0 && r->cell[k - 1].kind != NUMBER) k--;
        if (k == 0) return 0;
    }
    return rows > 0;
}

/* choose_dialect - the separator by which most cells of the sample's lines,
 * behind so many, are numbers; blanks only where no other one does. */
static void choose_dialect(reader *r, double first)
{
    static const char marks[] = ";|,,\t"; /* (the second comma: loose) */
    dialect best, *d = &r->d;
    const char *c, *line;
    int seen[5] = {0}, spaced = 0, quoted = 0, gaps = 0, k;
    double most = 0.0, score;

    d->decimal = (char)(r->to->decimal ? r->to->decimal : '.');
    d->separator = ' ';
    best = *d;
    for (sample_again(r, 0.0); sampled(r) > 0;) {
        line = r->s.line;
        gaps |= strchr(line, ' ') != 0;
        for (c = line; (c = strpbrk(c, ";|,\t")) != 0; c++) {
            seen[strchr(marks, *c) - marks] = 1;
            if (*c != ',') continue;
            spaced |= c[1] == ' ';
            quoted |= c[1] == '"' || (c > line && c[-1] == '"');
        }
    }
    /* of commas that are decimal: the one with quotes, or with blanks */
    seen[3] = d->decimal == ',' && spaced;
    seen[2] = seen[2] && (d->decimal == '.' || quoted);
    for (k = 0; k < 5; k++) {
        if (!seen[k]) continue;
        d->separator = marks[k];
        d->apart = k == 2 && d->decimal == ',';
        if (!gaps && seen[0] + seen[1] + seen[2] + seen[3] + seen[4] == 1)
            return;
        if (named_by(r, first)) return;
        score = try_dialect(r, first);
        if (score <= most) continue;
        most = score;
        best = *d;
    }
    *d = best;
}

/* head_line - is the line, cut, one of the head? has: what columns have. */
static int head_line(reader *r, const int *has)
{
    const cell *c = r->cell;
    int k, words = 0, found = 0, all = 1, any = 0;

    for (k = 0; k < r->cells; k++, c++) {
        all &= numeric(c);
        if (k >= r->columns || !(has[k] & NUMERIC)) continue;
        any = 1; /* (else no column has numbers) */
        found += numeric(c) || c->kind == STARS;
        words += c->kind == WORD;
    }
    /* (nor is a row by another separator) */
    if (!width(r))
        return r->cells > 1 ? !all : !touching(r->cell, r->d.decimal);
    /* (names may be numbers, as 2019, beside those of all axes) */
    return words > 0 ? found == 0 || (words > 1 && names_axes(r))
                     : found == 0 && !any;
}

/* no_rows - leave: all is head. */
static void no_rows(reader *r)
{
    int k;

    scan_again(&r->s);
    while (next_cells(r) > 0)
        for (k = 0; k < r->cells && k < r->columns; k++)
            if (begun(r->cell + k)) bad_cell(r, k);
    fail("%s: ends before the first point", r->s.name);
}

/* has_kinds - which kinds the columns' cells have, from so many lines of the
 * sample on. */
static void has_kinds(reader *r, double from, int *has)
{
    int k;

    memset(has, 0, COLUMNS * sizeof *has);
    for (sample_again(r, from); sampled(r) > 0;)
        for (k = 0; k < r->columns && width(r); k++)
            has[k] |= BIT(r->cell[k].kind);
}

/* count_columns - as many as most lines of the sample, behind so many, have
 * cells: lines with two numbers, or if there is none any. */
static void count_columns(reader *r, double first)
{
    long often[COLUMNS + 3] = {0}, open[COLUMNS + 3] = {0};
    int n, m, pass, found;

    for (pass = 0; pass < 2 && r->columns == 0; pass++)
        for (sample_again(r, first); (n = sampled(r)) > 0;) {
            for (found = m = 0; m < n; m++) found += numeric(r->cell + m);
            if (found < 2 && !pass) continue;
            often[n]++;
            open[n] += r->more;
            if (r->columns == 0 || often[n] > often[r->columns]) r->columns = n;
        }
    n = r->columns;
    if (n > COLUMNS)
        fail("%s: more than %d columns", r->s.name, COLUMNS);
    if (n > 1 && open[n] == often[n]) {
        /* a separator ends each line, unless there are as many names */
        sample_again(r, 0.0);
        r->columns -= sampled(r) != n || r->more;
    }
}

/* set_roles - columns of numbers, or words, or neither, by the sample behind so
 * many lines; and what numbers them. */
static void set_roles(reader *r, double head)
{
    int has[COLUMNS], k;

    r->skims = 1;
    has_kinds(r, head, has);
    for (k = 0; k < r->columns; k++)
        r->column[k].role =
            has[k] & NUMERIC                      ? VALUE
            : has[k] & (BIT(WORD) | BIT(STARS)) ? LABEL : HOLLOW;
    r->skims = 0;
    find_numbers(r, head);
}

/* look - what the sample tells: dialect, columns, what kind they are.  Returns
 * how many lines are the head's. */
static double look(reader *r)
{
    scan *s = &r->s;
    int has[COLUMNS];
    double lines, first, head;

    r->skims = 1;
    scan_pin(s);
    sample_again(r, r->most);
    lines = r->looked;
    if (lines == 0.0)
        fail(r->want >= 0.0 ? "%s: ends before the first point" : "%s: empty",
             s->name);
    first = floor((lines - 1.0) / 2.0);
    choose_dialect(r, first);
    count_columns(r, first);
    memset(r->column, 0, (size_t)r->columns * sizeof *r->column);
    has_kinds(r, first, has);
    sample_again(r, 0.0);
    do
        head = r->looked;
    while (sampled(r) > 0 && head_line(r, has));
    if (head >= lines) no_rows(r);
    set_roles(r, head);
    scan_go(s);
    return head;
}

void take_lines(reader *r)
{
    scan *s = &r->s;
    int k, whole_numbers;
    double head, x;

    r->most = r->want >= 0.0 ? r->want + 1.0 : WHOLE;
    r->table = r->want < 0.0; /* (a count is before atoms, as a rule) */
    head = look(r);
    if (r->remark[0]) comment_names(r, r->remark, r->remarked);
    while (!r->waits && scan_line(s)) {
        if (comment(s)) {
            comment_names(r, s->line, s->number);
            s->blank++;
            continue;
        }
        cut(r);
        if (head-- > 0.0) head_names(r, head < 1.0);
        else r->waits = 1;
    }
    if (!width(r)) take_rows(r); /* (that is said there) */
    whole_numbers = r->columns >= 6 && r->columns % 2 == 0 &&
                    r->d.separator == ',' && r->d.decimal == '.' &&
                    r->taken < LINE_OF_NAMES;
    for (k = 0; k < r->cells; k++)
        whole_numbers &= cell_whole(r->cell + k, &x);
    take_columns(r);
    take_rows(r);
    tell_columns(r);
    if (whole_numbers)
        warn("%s: whole numbers in %d columns; if commas are decimal signs, "
             "put something else between columns, and see -decimal",
             r->to->input, r->columns);
}

void take_table(reader *r)
{
    r->most = r->want >= 0.0 ? r->want : WHOLE;
    r->table = 1;
    scan_room(&r->s, r->want, 2.0 * r->columns);
    scan_pin(&r->s);
    set_roles(r, 0.0);
    scan_go(&r->s);
    r->waits = next_cells(r) > 0;
    if (!r->waits) fail("%s: ends before the first point", r->s.name);
    if (!width(r)) take_rows(r); /* (that is said there) */
    take_columns(r);
    take_rows(r);
    tell_columns(r);
}

/* tell_words - the column is left out: it has words, or numbers with units. */
static void tell_words(const reader *r, int k)
{
    const column *c = r->column + k;
    const char *unit;
    int values = (chosen.values || chosen.validate) && !r->to->bare &&
                 c->role == LABEL;

    unit = number((char *)c->shown, r->d.decimal, 0);
    unit += strspn(unit, " ");
    warn("%s: column %d%s%s (%s) is not a number: skipped%s%s", r->to->input,
         k + 1, c->title[0] ? ", " : "", c->title,
         c->role == HOLLOW ? "empty" : c->shown,
         c->role == LABEL && unit > c->shown &&
                 is_unit(unit, unit + strlen(unit))
             ? " (a unit?  It must go)" : "",
         values ? "; -method nearest takes words as values" : "");
}

/* tell_dropped - how many rows are, and why. */
static void tell_dropped(const reader *r)
{
    const points *to = r->to;
    char text[160] = "";
    int k;

    for (k = 0; k < DROPPED; k++)
        if (r->many[k] > 0.0)
            sprintf(text + strlen(text), "%s%.0f %s", *text ? ", " : "",
                    r->many[k], k == EMPTY    ? "empty"
                                : k == ABSENT ? "NA or NaN"
                                : k == STARS  ? "of asterisks"
                                              : "by -nodata");
    if (*text)
        warn("%s: %.0f row%s dropped (%s), the first in %s %ld%s",
             to->input, r->many[DROPPED], r->many[DROPPED] > 1.0 ? "s" : "",
             text, r->form == PACKED ? "row" : "line", r->first[DROPPED],
             to->columns > 1
                 ? "; fewer if -cols X,Y,Z,VALUE asks for one column's values"
                 : "");
    if (to->voids > 0 && r->many[VOID] == 0.0)
        warn("%s: -nodata: nothing is such a number", to->input);
}

/* tell_values - those that are counted as such ones. */
static void tell_values(const reader *r, int what, const char *which,
                        const char *then)
{
    double many = r->many[what];
    char all[60] = "a value is";
    int packed = r->form == PACKED;

    if (many == 0.0) return;
    if (many > 1.0) sprintf(all, "%.0f values are", many);
    warn("%s%s%ld: %s %s%s%s%s", r->to->input, packed ? ", row " : ":",
         r->first[what], all, which, many > 1.0 ? ", the first in this " : "",
         many == 1.0 ? "" : packed ? "row" : "line", then);
}

void end_rows(reader *r)
{
    points *to = r->to;
    const double *many = r->many;
    int k;

    if (to->n == 0 && many[DROPPED] > 0.0)
        fail(to->cols ? "%s: no points: %s drops all %.0f rows"
                      : "%s: no points: %s drops all %.0f rows; name the "
                        "columns that are wanted: %s X,Y,Z%s",
             to->input, to->skip ? "-skip" : "-nodata", many[DROPPED],
             axes_option(r), to->bare ? "" : ",VALUE");
    if (to->n == 0) fail("%s: no points", to->input);
    to->axes = r->axes;
    to->all = (double)to->n;
    if (!to->surfaced || many[DROPPED] > 0.0) to->faces = 0.0;
    if (to->scratch) spill(r);
    else rooms(to, to->all);
    if (to->by) number_groups(to, r->column[r->by].title);
    tell_numbers(r);
    /* (what comes back beside -query's answers is not skipped) */
    for (k = 0; k < r->words && r->form == LINES && !(to->bare && to->others);
         k++)
        tell_words(r, r->word[k]);
    tell_dropped(r);
    tell_rows(r);
    tell_values(r, NANS, "NaN", " (-skip drops such rows)");
    tell_values(r, INFINITES, "infinite", "");
    if (many[LIMITS] > 0.0)
        warn("%s: -below: %.0f value%s below a limit %s read as %g times the "
             "limit", to->input, many[LIMITS], many[LIMITS] > 1.0 ? "s" : "",
             many[LIMITS] > 1.0 ? "are" : "is", chosen.below);
    if (many[ABOVE] > 0.0)
        warn("%s: -below: %.0f value%s above a limit %s read as the limit",
             to->input, many[ABOVE], many[ABOVE] > 1.0 ? "s" : "",
             many[ABOVE] > 1.0 ? "are" : "is");
    if (many[TINY] > 0.0)
        warn("%s: %.0f number%s other than 0 %s too small for a double, and "
             "read as 0", to->input, many[TINY], many[TINY] > 1.0 ? "s" : "",
             many[TINY] > 1.0 ? "are" : "is");
    if (many[ROUNDED] > 0.0)
        warn("%s: %.0f integer%s beyond 2^53 %s rounded", to->input,
             many[ROUNDED], many[ROUNDED] > 1.0 ? "s" : "",
             many[ROUNDED] > 1.0 ? "are" : "is");
    doubt_points(r);
}
