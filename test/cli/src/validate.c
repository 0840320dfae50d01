/* validate.c - what errors the methods have, by cross-validation: see values.h.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "driver.h"
#include "values.h"

/* A value counts as beyond the data's range if it is by more than rounding. */
#define ROUNDING 1e-12

/* What is known of a method's errors in a column.  They are in units of
 * 2^power[column], lest squares overflow or vanish. */
typedef struct tally {
    double sum, absolute, square, worst;
    tess_int where;
    double beyond, least, most; /* values beyond the data's range; all values */
} tally;

static tally sums[METHODS][COLUMNS];
static double counted[METHODS], missed[METHODS]; /* points; those outside */
static int power[COLUMNS];
static double low[COLUMNS], high[COLUMNS]; /* the data's range */

/* Of words, measured and predicted, how often each pair is, if the words are so
 * few; and how many are right. */
#define TABLE 30
static double *pairs[COLUMNS], right[COLUMNS];

static long folds;
static tess_int *fold; /* of each point; TESS_NONE: it does not count */
static tess_int *size, *rank; /* of groups */
static double *errors;  /* for the file: by point, asked method, column */

/* ---------------------------------------------------------------- folds */

/* chance - a number from 0 to below - 1.  Park and Miller's generator, in
 * Schrage's form, whose products fit in 32 bits: the same on every machine. */
static tess_int chance(tess_int below)
{
    static long seed = 1;

    seed = 16807L * (seed % 127773L) - 2836L * (seed / 127773L);
    if (seed <= 0) seed += 2147483647L;
    return (tess_int)(seed % (long)below);
}

static void shuffle(tess_int *list, tess_int many)
{
    tess_int i, j, k;

    for (i = many - 1; i > 0; i--) {
        j = chance(i + 1);
        k = list[i];
        list[i] = list[j];
        list[j] = k;
    }
}

/* fewer - there are not so many folds as asked for. */
static void fewer(tess_int many, const char *what)
{
    if ((long)many >= folds) return;
    warn("-validate: %ld folds, each of one %s: there are no more", (long)many,
         what);
    folds = (long)many;
}

/* deal_points - folds by chance, which differ by one point at most. */
static void deal_points(const points *in, tess_int *list)
{
    tess_int i, many = 0;

    for (i = 0; i < in->n; i++)
        if (fold[i] != TESS_NONE) list[many++] = i;
    fewer(many, "place");
    shuffle(list, many);
    for (i = 0; i < many; i++) fold[list[i]] = (tess_int)((long)i % folds);
}

/* larger - for qsort: the larger group first, else that of lower rank. */
static int larger(const void *x, const void *y)
{
    tess_int a = *(const tess_int *)x, b = *(const tess_int *)y;

    if (size[a] != size[b]) return size[a] > size[b] ? -1 : 1;
    return rank[a] < rank[b] ? -1 : 1;
}

/* deal_groups - the largest group first, each to the fold that has the fewest
 * points; groups of one size in an order by chance. */
static void deal_groups(const points *in, tess_int *list)
{
    tess_int i, many = 0, *filled, *of;
    long k, least;

    size = (tess_int *)space((double)in->n, sizeof *size);
    rank = (tess_int *)space((double)in->n, sizeof *rank);
    of = (tess_int *)space((double)in->n, sizeof *of);
    for (i = 0; i < in->n; i++) size[i] = 0;
    for (i = 0; i < in->n; i++)
        if (fold[i] != TESS_NONE && size[in->group[i]]++ == 0)
            list[many++] = in->group[i];
    if (many < 2) fail("-by %s: all points are in one group", chosen.by);
    fewer(many, "group");
    shuffle(list, many);
    for (i = 0; i < many; i++) rank[list[i]] = i;
    qsort(list, (size_t)many, sizeof *list, larger);
    filled = (tess_int *)space((double)folds, sizeof *filled);
    for (k = 0; k < folds; k++) filled[k] = 0;
    for (i = 0; i < many; i++) {
        least = (long)i;
        if (least >= folds)
            for (least = 0, k = 1; k < folds; k++)
                if (filled[k] < filled[least]) least = k;
        filled[least] += size[list[i]];
        of[list[i]] = (tess_int)least;
    }
    for (i = 0; i < in->n; i++)
        if (fold[i] != TESS_NONE) fold[i] = of[in->group[i]];
    free(size);
    free(rank);
    free(of);
    free(filled);
}

/* deal - each place to a fold.  Where points lie at one place, which is left
 * out once, the first one's group counts. */
static void deal(const points *in, const tess_int *same)
{
    tess_int *list = (tess_int *)space((double)in->n, sizeof *list), i;
    long both = 0;

    fold = (tess_int *)space((double)in->n, sizeof *fold);
    for (i = 0; i < in->n; i++) {
        fold[i] = same[i] == i ? 0 : TESS_NONE;
        both += in->group && in->group[i] != in->group[same[i]];
    }
    if (both > 0)
        warn("-by %s: %ld point%s at a place of another group: left out with "
             "that, not with %s own",
             chosen.by, both, both > 1 ? "s are" : " is",
             both > 1 ? "their" : "its");
    if (in->group)
        deal_groups(in, list);
    else
        deal_points(in, list);
    free(list);
}

/* --------------------------------------------------------------- errors */

/* ranges - of the data, and the unit of errors. */
static void ranges(const points *in, const double *value)
{
    double x, most;
    tess_int i;
    int j;

    for (j = 0; j < in->columns; j++) {
        low[j] = DBL_MAX;
        high[j] = -DBL_MAX;
        for (i = 0; i < in->n; i++) {
            x = value[(size_t)in->columns * (size_t)i + (size_t)j];
            if (fold[i] == TESS_NONE || !(fabs(x) <= DBL_MAX)) continue;
            if (x < low[j]) low[j] = x;
            if (x > high[j]) high[j] = x;
        }
        most = fabs(low[j]) > fabs(high[j]) ? fabs(low[j]) : fabs(high[j]);
        frexp(most, power + j);
    }
}

/* count - that x was predicted for point i, whose value is given. */
static void count(tally *a, int j, double x, double given, tess_int i)
{
    double error = ldexp(x, -power[j]) - ldexp(given, -power[j]);
    double slack = ROUNDING * (high[j] > -low[j] ? high[j] : -low[j]);

    a->beyond += x < low[j] - slack || x > high[j] + slack;
    if (x < a->least) a->least = x;
    if (x > a->most) a->most = x;
    a->sum += error;
    a->absolute += fabs(error);
    a->square += error * error;
    /* (a NaN is the worst) */
    if (a->where != TESS_NONE &&
        (a->worst != a->worst || fabs(error) <= fabs(a->worst)))
        return;
    a->worst = error;
    a->where = i;
}

static double rms(int method, int j)
{
    return ldexp(sqrt(sums[method][j].square / counted[method]), power[j]);
}

/* count_word - that one was predicted where that one was measured. */
static void count_word(const points *in, int j, double x, double given)
{
    size_t n = (size_t)class_count(in->words[j]), k;

    if (!pairs[j] && n <= TABLE) {
        pairs[j] = (double *)space((double)(n * n), sizeof **pairs);
        for (k = 0; k < n * n; k++) pairs[j][k] = 0.0;
    }
    if (pairs[j]) pairs[j][n * (size_t)given + (size_t)x] += 1.0;
    right[j] += x == given;
}

/* remesh - the mesh of the field's points p, where m's was; in a plane of two
 * more, with values v. */
static void remesh(mesh *m, field *f, tess_real *p, double *v, long without)
{
    const tess_real *all = m->p;
    size_t columns = (size_t)f->columns;
    int code = m->flat ? lay_flat(m, f->n, p, 0)
                       : tetrahedralize(m, f->n, p, 0);

    m->p = all;
    if (m->flat) {
        memcpy(v + columns * (size_t)f->n, v, columns * sizeof *v);
        memcpy(v + columns * (size_t)f->n + columns, v, columns * sizeof *v);
        f->n += 2;
    }
    f->ntet = m->ntet;
    f->tet = m->tet;
    f->adj = m->adj;
    if (code == TESS_PLANE || code == TESS_LINE || code == TESS_POINT)
        fail("-validate: without fold %ld of %ld no tetrahedron is left; "
             "choose %s",
             without + 1, folds, chosen.by ? "smaller groups" : "more folds");
    if (code != TESS_OK)
        too_small("-validate: code %d of tess for the points without fold %ld",
                  code, without + 1);
}

/* -------------------------------------------------------------- results */

static void print_table(const points *in, const int *asked)
{
    const tally *a;
    const tess_real *x;
    int k, j, width = 6, numbers = 0;

    for (j = 0; j < in->columns; j++) numbers += !in->words[j];
    if (numbers == 0) return;
    for (j = 0; j < in->columns; j++)
        if ((int)strlen(in->name[j]) > width) width = (int)strlen(in->name[j]);
    printf("%-8s %-*s %13s %13s %13s %13s %9s  %s\n", "method", width,
           "column", "bias", "mean |error|", "rms error", "worst", "outside",
           "worst at");
    for (k = 0; k < METHODS; k++)
        for (j = 0; j < in->columns && asked[k]; j++) {
            if (in->words[j]) continue;
            a = sums[k] + j;
            printf("%-8s %-*s", method_name[k], width, in->name[j]);
            if (a->where == TESS_NONE) {
                printf(" %13s %13s %13s %13s %9.0f  -\n", "-", "-", "-", "-",
                       missed[k]);
                continue;
            }
            x = in->p + 3 * (size_t)a->where;
            printf(" %13.6g %13.6g %13.6g %13.6g %9.0f  %.9g,%.9g",
                   ldexp(a->sum / counted[k], power[j]),
                   ldexp(a->absolute / counted[k], power[j]), rms(k, j),
                   ldexp(a->worst, power[j]), missed[k], (double)x[0],
                   (double)x[1]);
            if (in->axes == 3) printf(",%.9g", (double)x[2]);
            printf("\n");
        }
}

/* print_words - the table of a column of words: measured ones from top to
 * bottom, predicted ones from left to right. */
static void print_words(const points *in, int j)
{
    const classes *c = in->words[j];
    long n = class_count(c), a, b;
    double all = counted[NEAREST];
    int width = 9, length, total;

    for (a = 0; a < n; a++) {
        length = (int)strlen(class_name(c, (double)a));
        if (length > width) width = length;
    }
    for (a = 0; a < n && pairs[j]; a++) {
        if (a == 0) {
            printf("%s, measured; predicted:\n%-*s", in->name[j], width, "");
            for (b = 0; b < n; b++)
                printf(" %*s", width, class_name(c, (double)b));
            printf("\n");
        }
        printf("%-*s", width, class_name(c, (double)a));
        for (b = 0; b < n; b++) printf(" %*.0f", width, pairs[j][n * a + b]);
        printf("\n");
    }
    total = (int)strlen(in->name[j]);
    printf("%.*s: %.0f of %.0f right", total, in->name[j], right[j], all);
    if (all > 0.0) printf(" (%.1f %%)", 100.0 * right[j] / all);
    printf(", %.0f outside%s\n", missed[NEAREST],
           pairs[j] || all == 0.0 ? "" : "; too many words for a table");
    free(pairs[j]);
    pairs[j] = 0;
}

/* print_best - the method of least error for each column. */
static void print_best(const points *in, const int *asked)
{
    int k, j, best;

    printf("best by rms error:");
    for (j = 0; j < in->columns; j++) {
        for (best = -1, k = 0; k < METHODS; k++)
            if (asked[k] && counted[k] > 0.0 && rms(k, j) <= DBL_MAX &&
                (best < 0 || rms(k, j) < rms(best, j)))
                best = k;
        printf("%s %s for %s", j > 0 ? "," : "",
               best < 0 ? "none" : method_name[best], in->name[j]);
    }
    printf("\n");
}

/* print_beyond - how many values are beyond the data's range. */
static void print_beyond(const points *in, const int *asked)
{
    const tally *a;
    int k, j, some = 0, numbers = in->columns;

    for (k = 0; k < METHODS; k++)
        for (j = 0; j < in->columns && asked[k]; j++) {
            a = sums[k] + j;
            if (in->words[j]) numbers--;
            if (a->beyond == 0.0) continue;
            printf("beyond the data's range: %s for %s: %.0f of %.0f values, "
                   "%.6g to %.6g; the data %.6g to %.6g (see -clip)\n",
                   method_name[k], in->name[j], a->beyond, counted[k],
                   a->least, a->most, low[j], high[j]);
            some = 1;
        }
    if (!some && numbers > 0) printf("beyond the data's range: none\n");
}

/* put_error - a value, or an error; or a word. */
static void put_error(FILE *file, const classes *words, double x)
{
    if (words) put_title(file, class_name(words, x));
    else put_behind(file, ',', x);
}

/* write_errors - of each place, with its values. */
static void write_errors(const points *in, const double *value,
                         const int *asked, output *o)
{
    double numbers = 4.0 + 2.0 * (double)in->columns;
    FILE *file = start(o, 20.0 * numbers * (double)in->n);
    char title[TITLE + 60];
    const double *e = errors;
    const char *text;
    tess_int i;
    int k, j;

    put_axes(file, in, 3);
    fprintf(file, ",fold");
    if (in->others) fprintf(file, ",%s", in->others);
    if (in->others) rewind(in->texts);
    for (j = 0; j < in->columns; j++) put_title(file, in->name[j]);
    for (k = 0; k < METHODS; k++)
        for (j = 0; j < in->columns && asked[k]; j++) {
            sprintf(title, "%s-%s (%s)", method_name[k], in->name[j],
                    in->words[j] ? "predicted" : "predicted minus measured");
            put_title(file, title);
        }
    fprintf(file, "\n");
    for (i = 0; i < in->n; i++, value += in->columns) {
        text = in->others ? next_text(in) : 0;
        if (fold[i] != TESS_NONE) {
            put_point(file, in, i, ',', ',');
            fprintf(file, "%ld", (long)fold[i] + 1);
            if (text) fprintf(file, ",%s", text);
            for (j = 0; j < in->columns; j++)
                put_error(file, in->words[j], value[j]);
        }
        for (k = 0; k < METHODS; k++)
            for (j = 0; j < in->columns && asked[k]; j++, e++)
                if (fold[i] != TESS_NONE) put_error(file, in->words[j], *e);
        if (fold[i] != TESS_NONE) putc('\n', file);
    }
    finish(file, o);
}

void cross_validate(mesh *m, const tess_int *same, const double *value,
                    long asked_folds, const int *asked, int beyond)
{
    const points *in = m->in;
    const double *given;
    size_t columns = (size_t)in->columns;
    double n = (double)in->n + 2.0; /* (two for a plane) */
    double *v = (double *)space((double)columns * n, sizeof *v);
    tess_real *p = (tess_real *)space(3.0 * n, sizeof *p);
    double out[COLUMNS];
    size_t each = 0, at;
    tess_int i, t;
    field f;
    output *o;
    long k;
    int j, method;

    folds = asked_folds;
    deal(in, same);
    ranges(in, value);
    for (method = 0; method < METHODS; method++) {
        each += asked[method] ? columns : 0;
        for (j = 0; j < in->columns; j++) {
            sums[method][j].where = TESS_NONE;
            sums[method][j].least = DBL_MAX;
            sums[method][j].most = -DBL_MAX;
        }
    }
    if (next_output(errors_forms, 0)) {
        errors = (double *)space((double)each * (double)in->n, sizeof *errors);
        for (at = 0; at < each * (size_t)in->n; at++)
            errors[at] = no_number();
    }
    f.p = p;
    f.keep = 0;
    f.value = v;
    f.columns = in->columns;
    f.flat = m->flat;
    f.within = 0.0;
    for (k = 0; k < folds; k++) {
        for (f.n = i = 0; i < in->n; i++) {
            if (fold[i] == TESS_NONE || (long)fold[i] == k) continue;
            memcpy(p + 3 * (size_t)f.n, m->p + 3 * (size_t)i, 3 * sizeof *p);
            memcpy(v + columns * (size_t)f.n, value + columns * (size_t)i,
                   columns * sizeof *v);
            f.n++;
        }
        remesh(m, &f, p, v, k);
        for (at = 0, method = 0; method < METHODS; method++) {
            if (!asked[method]) continue;
            values_begin(&f, method, beyond, 0.0);
            t = TESS_NONE;
            for (i = 0; i < in->n; i++) {
                if (fold[i] == TESS_NONE || (long)fold[i] != k) continue;
                values_at(1, m->p + 3 * (size_t)i, &t, out);
                missed[method] += t < 0;
                if (t < 0 && beyond != OUT_NEAREST) continue;
                counted[method] += 1.0;
                given = value + columns * (size_t)i;
                for (j = 0; j < in->columns; j++)
                    if (in->words[j]) count_word(in, j, out[j], given[j]);
                    else count(sums[method] + j, j, out[j], given[j], i);
                /* (of words, what is predicted) */
                for (j = 0; j < in->columns && errors; j++)
                    errors[each * (size_t)i + at + (size_t)j] =
                        out[j] - (in->words[j] ? 0.0 : given[j]);
            }
            at += columns;
            values_end();
        }
        progress("-validate", (double)(k + 1), (double)folds);
    }
    print_table(in, asked);
    if (each > columns) print_best(in, asked);
    print_beyond(in, asked);
    for (j = 0; j < in->columns; j++)
        if (in->words[j]) print_words(in, j);
    for (o = 0; (o = next_output(errors_forms, o)) != 0;)
        write_errors(in, value, asked, o);
    free(errors);
    free(fold);
    free(v);
    free(p);
}
