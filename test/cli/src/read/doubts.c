/* doubts.c - what a reader doubts of columns and rows: whether they number
 * rows, or columns; dates, thousands, sums.
 */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define ENOUGH 4 /* rows, that anything can be said of them */
#define SEEN 200 /* rows that show whether a column has such numbers */

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* once - are the numbers all different?  They are sorted then. */
static int once(double *x, size_t many)
{
    size_t i;

    qsort(x, many, sizeof *x, by_size);
    for (i = 1; i < many; i++)
        if (x[i] == x[i - 1]) return 0;
    return many > 0;
}

/* count_step - from x before to this one: 0 if it is none of what numbers. */
static int count_step(reader *r, double x)
{
    if (r->numbered_rows > 0.0) {
        if (!(x > r->last_number)) return 0;
        r->ones += x == r->last_number + 1.0;
    }
    r->numbered_rows++;
    r->last_number = x;
    return 1;
}

/* numbering - do rows so far look numbered? */
static int numbering(const reader *r, double least)
{
    return r->numbered_rows >= least &&
           2.0 * r->ones > r->numbered_rows - 1.0;
}

void find_numbers(reader *r, double head)
{
    double *x = (double *)space((double)SAMPLE, sizeof *x), n;
    size_t many = 0;
    int k = 0, whole_numbers = 1, rising = 1;

    while (k < r->columns && r->column[k].role == LABEL) k++;
    r->numbered_rows = r->ones = 0.0;
    r->unique = r->column[0].role == VALUE;
    for (sample_again(r, head); sampled(r) > 0;) {
        if (r->cells < r->columns) continue;
        r->unique = r->unique && cell_whole(r->cell, &n);
        if (r->unique && many < SAMPLE) x[many++] = n;
        whole_numbers = whole_numbers && k < r->columns &&
                        cell_whole(r->cell + k, &n);
        rising = rising && whole_numbers && count_step(r, n);
    }
    r->unique = r->unique && once(x, many);
    r->number = rising && whole_numbers && numbering(r, ENOUGH) ? k : -1;
    r->numbered_rows = r->ones = 0.0;
    free(x);
}

/* axes_list - of -cols, columns from that one on, then those of the axes. */
static char *axes_list(const reader *r, int first, char *list)
{
    int k, many = r->axes - (first >= 0);

    list[0] = '\0';
    if (first >= 0) sprintf(list, "%d,", first + 1);
    for (k = 0; k < many; k++)
        sprintf(list + strlen(list), k ? ",%d" : "%d", r->use[k] + 1);
    return list;
}

void check_numbers(reader *r)
{
    const cell *c = r->cell + r->number;
    char if_not[64], if_so[64];
    double n;

    if (cell_whole(c, &n) && count_step(r, n)) {
        if (r->numbered_rows <= 3.0) r->numbers[(int)r->numbered_rows - 1] = n;
        return;
    }
    scan_fail(&r->s, "column %d numbered the rows, but here it is \"%.*s\": "
              "%s %s if it is x, %s %s if it is not", r->number + 1, SHOWN(c),
              axes_option(r), axes_list(r, r->number, if_not), axes_option(r),
              axes_list(r, -1, if_so));
}

void count_x(reader *r, double x)
{
    if (r->to->n < 3) r->numbers[r->to->n] = x;
    if (r->counting && (x != floor(x) || !(fabs(x) < WHOLE) ||
                        !count_step(r, x)))
        r->counting = 0;
}

/* whole_beside - are all numbers of x whole, and some of each other axis and of
 * the first value not?  Then what is unlike the others may number the rows. */
static int whole_beside(const reader *r)
{
    const points *to = r->to;
    int k, broken[4] = {0}, all = 1, many = to->columns > 0 ? 4 : 3;
    tess_int i;

    for (i = 0; i < to->n; i++)
        for (k = 0; k < many; k++)
            broken[k] |= number_of(to, k, i) != floor(number_of(to, k, i));
    for (k = 1; k < many; k++) all &= broken[k] || k == r->axes;
    return all && !broken[0];
}

/* whole_x - are all numbers of x whole? */
static int whole_x(const points *to)
{
    tess_int i;
    double x;

    for (i = 0; i < to->n; i++) {
        x = number_of(to, 0, i);
        if (x != floor(x) || !(fabs(x) < WHOLE)) return 0;
    }
    return 1;
}

/* dense - does x number the points, in any order: is each number there once,
 * and at least every other one of its range?  And y does not? */
static int dense(const points *to)
{
    frequency x, y;

    count_numbers(to, 0, 0, 0, &x);
    if (x.times > 1 || x.high - x.low >= 2.0 * (double)to->n) return 0;
    count_numbers(to, 1, 0, 0, &y);
    return y.times > 1 || y.high - y.low >= 2.0 * (double)to->n;
}

/* follows - are points of one x of one y, too, as those of a hole are?  (The
 * first few are looked at.) */
static int follows(const points *to)
{
    tess_int i, j;

    for (i = 0; i < to->n && i < 8; i++)
        for (j = 0; j < to->n; j++)
            if (number_of(to, 0, i) == number_of(to, 0, j) &&
                number_of(to, 1, i) != number_of(to, 1, j))
                return 0;
    return 1;
}

/* in_runs - is x the same in several rows, one after the other, or in any
 * order, as the number of a hole or of a line is?  It is not in a grid, where
 * what is beside it comes again; nor in sections, at steps that are all the
 * same. */
static int in_runs(const reader *r)
{
    const points *to = r->to;
    frequency x, y, z;
    double last = 0.0, at, step, steps = 0.0;
    long runs = 0, again = 0;
    tess_int i;
    int k, same, even = 1, rises = 1;

    for (i = 0; i < to->n; i++) {
        at = number_of(to, 0, i);
        if (i > 0 && at == last) continue;
        for (same = k = 1; k < r->axes; k++)
            same &= number_of(to, k, i) == number_of(to, k, 0);
        again += runs > 0 && same;
        step = at - last;
        if (runs == 1) steps = step;
        if (runs > 0) even = even && step == steps;
        if (runs > 0) rises = rises && step > 0.0;
        last = at;
        runs++;
    }
    if (runs < 2) return 0;
    count_numbers(to, 0, 0, 0, &x);
    if (x.low < 0.0 || 2 * x.different > (long)to->n) return 0;
    if (x.different == runs && (!even || steps == 1.0) &&
        2 * again < runs - 1 && (even || !rises || whole_beside(r)))
        return 1;
    if (x.different == runs || !whole_beside(r)) return 0;
    count_numbers(to, 1, 0, 0, &y);
    count_numbers(to, r->axes - 1, 0, 0, &z);
    return 4 * y.different > (long)to->n || 4 * z.different > (long)to->n ||
           (y.different > 1 && follows(to));
}

/* may_number - was a column taken for x that may number the rows, as it rises
 * by whole numbers, or has each but once; or holes, RUNS? */
enum { ROWS = 1, RUNS };

static int may_number(const reader *r)
{
    const points *to = r->to;

    if (r->counting)
        if (numbering(r, 2.0) || r->numbered_rows >= ENOUGH) return ROWS;
    if (to->cols || r->number >= 0 || r->family >= 0 || r->use[0] != 0 ||
        r->columns <= r->axes || to->scratch || to->n < ENOUGH || !whole_x(to))
        return 0;
    if (r->unique && (whole_beside(r) || (to->n >= 6 && dense(to))))
        return ROWS;
    return to->n >= 6 && in_runs(r) ? RUNS : 0;
}

/* in_range - are all numbers of the axis, or value, whole and in that? */
static int in_range(const points *to, int k, double low, double high)
{
    tess_int i;
    double x;

    for (i = 0; i < to->n; i++) {
        x = number_of(to, k, i);
        if (!(x >= low && x <= high) || x != floor(x)) return 0;
    }
    return 1;
}

/* one_date - may all numbers of x be dates, as 20190301? */
static int one_date(const points *to)
{
    tess_int i;
    double x, day, month;

    if (!in_range(to, 0, 18000101.0, 21991231.0)) return 0;
    for (i = 0; i < to->n; i++) {
        x = number_of(to, 0, i);
        day = fmod(x, 100.0);
        month = fmod(floor(x / 100.0), 100.0);
        if (day < 1.0 || day > 31.0 || month < 1.0 || month > 12.0) return 0;
    }
    return 1;
}

/* three_of_date - may x, y, z be years, months and days, or in the order of
 * some other country?  A whole grid is no calendar. */
static int three_of_date(const points *to)
{
    static const int orders[3][3] = {{0, 1, 2}, {2, 1, 0}, {2, 0, 1}};
    frequency f;
    double grid = 1.0;
    int k, flat = 0;

    for (k = 0; k < 3; k++)
        if (in_range(to, orders[k][0], 1800.0, 2199.0) &&
            in_range(to, orders[k][1], 1.0, 12.0) &&
            in_range(to, orders[k][2], 1.0, 31.0))
            break;
    if (k == 3) return 0;
    for (k = 0; k < 3; k++) {
        count_numbers(to, k, 0, 0, &f);
        grid *= (double)f.different;
        flat |= f.different == 1;
    }
    return flat || grid != (double)to->n;
}

/* clock_values - how many of the first values may be hours, minutes, seconds?
 */
static int clock_values(const points *to)
{
    if (!in_range(to, 3, 0.0, 23.0) || !in_range(to, 4, 0.0, 59.0)) return 0;
    return in_range(to, 5, 0.0, 60.0) ? 3 : 2;
}

/* tell_date - that columns without names were taken for axes, but may be dates:
 * 1 if so. */
static int tell_date(const reader *r)
{
    const points *to = r->to;
    char list[80] = "", first[60];
    int three = 0, next, many = 0, k;

    if (to->cols || r->family >= 0 || to->scratch || to->n < ENOUGH ||
        r->columns <= r->axes)
        return 0;
    for (k = 0; k < r->axes; k++)
        if (r->column[r->use[k]].title[0]) return 0;
    three = r->axes == 3 && three_of_date(to);
    if (!three && !one_date(to)) return 0;
    sprintf(first, "%.0f", number_of(to, 0, 0));
    for (k = 1; k < 3 && three; k++)
        sprintf(first + strlen(first), ", %.0f", number_of(to, k, 0));
    next = r->use[three ? 2 : 0] + 1;
    /* (times are before coordinates, if there are as many columns) */
    k = three && to->columns >= 5 ? clock_values(to) : 0;
    for (k = to->columns < k + 3 ? 0 : k; k > 0; next++)
        k -= r->column[next].role == VALUE;
    for (; next < r->columns && many < r->axes; next++)
        if (r->column[next].role <= VALUE ||
            (to->bare && r->cell[next].kind == NUMBER)) {
            sprintf(list + strlen(list), many++ ? ",%d" : " %d", next + 1);
        }
    if (many < r->axes) strcpy(list, " X,Y,Z says which are x, y, z");
    warn("%s: the first point is %s, which may be a date; if so: %s%s",
         to->input, first, axes_option(r), list);
    return 1;
}

/* tell_value_numbers - that the first column has a name, as nodenumber, and so is
 * a value, but numbers the rows. */
static void tell_value_numbers(const reader *r)
{
    const points *to = r->to;
    tess_int i;
    double x;

    if (to->scratch || to->n < ENOUGH || to->columns == 0 || to->words[0] ||
        r->column[0].role != VALUE)
        return;
    for (i = 0; i < to->n; i++) {
        x = number_of(to, 3, i);
        if (x != floor(x) || (i > 0 && x != number_of(to, 3, i - 1) + 1.0))
            return;
    }
    warn("%s: column 1, %s, numbers the rows, and is a value like others: "
         "-cols X,Y,Z,V names those that are", to->input, to->name[0]);
}

void tell_numbers(reader *r)
{
    const points *to = r->to;
    char list[64], axes[64], first[80];
    int k = r->use[0], next = r->use[r->axes - 1] + 1;
    int may = r->column[k].title[0] ? 0 : may_number(r);

    if (r->table && !to->cols && !to->bare) tell_value_numbers(r);
    if (r->table && tell_date(r)) return;
    /* (what does not number them may be too long) */
    if (to->cols || to->n == 0 || (r->number < 0 && !may)) return;
    sprintf(first, "%.0f, %.0f", r->numbers[0], r->numbers[1]);
    if (to->n > 2) sprintf(first + strlen(first), ", %.0f, ...", r->numbers[2]);
    if (r->number >= 0 && r->family >= 0)
        warn("%s: column %d (%s) numbers the rows: it is no value", to->input,
             r->number + 1, first);
    else if (r->number >= 0)
        warn("%s: column %d (%s) numbers the rows, the columns %s are x, y%s; "
             "if that one is x: %s %s", to->input, r->number + 1, first,
             axes_list(r, -1, axes), r->axes == 2 ? "" : ", z", axes_option(r),
             axes_list(r, r->number, list));
    if (!may) return;
    while (next < r->columns && r->column[next].role >= LABEL &&
           (!to->bare || r->cell[next].kind != NUMBER))
        next++;
    if (next == r->columns) return;
    list[0] = '\0';
    if (r->axes == 3) sprintf(list, ",%d", r->use[2] + 1);
    warn("%s: column %d is %s and was taken for x; if it numbers %s: %s "
         "%d%s,%d", to->input, k + 1, first,
         may == RUNS ? "holes or lines" : "the points", axes_option(r),
         r->use[1] + 1, list, next + 1);
}

/* ------------------------------------------------- rows that are no points */

void doubt_row(reader *r)
{
    const points *to = r->to;
    double first = r->cell[0].x;
    const cell *c = 0;
    int k, word = -1;

    if (to->n < 2 && r->form == LINES) {
        /* (rows that go on so do not number columns) */
        if (to->n == 0) {
            r->counts = r->table && (first == 0.0 || first == 1.0);
            r->counts_from = first;
        }
        for (k = 0; k < r->columns && r->counts; k++)
            if (r->cell[k].kind != NUMBER || r->cell[k].x != first + k) break;
        r->counts = r->counts && (k == r->columns) == (to->n == 0);
    }
    for (k = 0; k < r->labels && word < 0; k++) {
        c = r->cell + r->label[k];
        word = sum_word(c);
    }
    if (word < 0) {
        r->last_sums = 0.0;
        return;
    }
    if (r->sums++ == 0.0) sprintf(r->sums_shown, "%.*s", PART(c, 20));
    r->last_sums++;
    if (r->sums == (double)to->n + 1.0) r->first_sums = r->sums;
    r->sums_twice |= (r->sums_had >> word & 1) != 0;
    r->sums_had |= 1UL << word;
}

/* tell_sums - rows, the first ones or the last ones, of which each is called by
 * a word of its own, as Total or Mean. */
static void tell_sums(const reader *r)
{
    const points *to = r->to;
    long line;

    if (r->sums == 0.0 || r->sums_twice || 2.0 * r->sums > (double)to->n ||
        r->first_sums + r->last_sums != r->sums)
        return;
    line = to->line[r->first_sums > 0.0 ? 0 : to->n - (tess_int)r->sums];
    if (r->sums == 1.0)
        warn("%s:%ld: a row called \"%s\" was taken as a point; if it "
             "summarizes others: delete it", to->input, line, r->sums_shown);
    else
        warn("%s:%ld: %.0f rows, the first one called \"%s\", were taken as "
             "points; if they summarize others: delete them", to->input, line,
             r->sums, r->sums_shown);
}

/* odd - is the first point's number of axis, or value, k unlike all others:
 * far from them, or whole, as none of them is? */
static int odd(const points *to, int k)
{
    double first = number_of(to, k, 0), x, low = DBL_MAX, high = -DBL_MAX;
    tess_int i;
    int whole_numbers = 0;

    for (i = 1; i < to->n; i++) {
        x = number_of(to, k, i);
        if (!(fabs(x) <= DBL_MAX)) continue;
        if (x < low) low = x;
        if (x > high) high = x;
        whole_numbers |= x == floor(x);
    }
    return low <= high && (!whole_numbers || low - first > high - low ||
                           first - high > high - low);
}

/* tell_counts - a first row 1, 2, 3 ..., or from 0 on, that may number the
 * columns.  (Five such numbers are no chance.) */
static void tell_counts(const reader *r)
{
    const points *to = r->to;
    int k, is = r->columns > 4 && r->number < 0;

    if (!r->counts) return;
    for (k = 0; k < 3 + to->columns && !is; k++)
        is = (k < r->axes || k > 2) && odd(to, k);
    if (is)
        warn("%s:%ld: %.0f, %.0f, %.0f%s were taken as a point; if they number "
             "the columns: delete the line", to->input, to->line[0],
             r->counts_from, r->counts_from + 1.0, r->counts_from + 2.0,
             r->columns > 3 ? ", ..." : "");
}

/* parted - are there points between thousands: has each number of axis, or
 * value, k that has a point three digits behind it, as 1.024, and are others
 * whole, up to 999?  with, without: one of each. */
static int parted(const points *to, int k, double *with, double *without)
{
    double x, size, behind;
    tess_int i;
    long broken = 0, ends = 0, hundreds = 0;

    for (i = 0; i < to->n; i++) {
        x = number_of(to, k, i);
        size = fabs(x);
        if (!(size <= DBL_MAX)) continue;
        if (i == SEEN && hundreds == 0) return 0;
        if (x == floor(x)) {
            if (size >= 1000.0) return 0;
            if (size < 100.0) continue;
            hundreds++;
            *without = x;
            continue;
        }
        behind = 1000.0 * size - floor(1000.0 * size + 0.5);
        if (!(size > 1.0 && size < 100.0) || fabs(behind) > 1e-9 * size * 1e3)
            return 0;
        broken++;
        /* (as a rule the last digit is not 0) */
        behind = 100.0 * size - floor(100.0 * size + 0.5);
        ends += fabs(behind) > 1e-3;
        *with = x;
    }
    return broken > 1 && hundreds > 2 && 4 * ends >= 3 * broken;
}

static void tell_parted(const reader *r)
{
    const points *to = r->to;
    double with, without;
    char axis[2];
    int k;

    for (k = 0; k < 3 + to->columns; k++) {
        if ((k < 3 && k >= r->axes) || (k > 2 && to->words[k - 3]) ||
            !parted(to, k, &with, &without))
            continue;
        sprintf(axis, "%c", "xyz"[k < 3 ? k : 0]);
        warn("%s: %s has numbers with three digits behind the point, as %.3f, "
             "and whole ones, as %.0f; if points separate thousands, they must "
             "go", to->input, k < 3 ? axis : to->name[k - 3], with, without);
    }
}

/* ------------------------------------------------------------------- words */

/* next_sign - the next one that is no blank, a small letter if it is one; how
 * many before are passed. */
static int next_sign(const char **s)
{
    *s += strspn(*s, " \t");
    return tolower((unsigned char)*(*s)++);
}

/* unlike - which of the words is before the other one, but for capitals and
 * blanks?  0: neither is. */
static int unlike(const void *a, const void *b)
{
    const char *s = *(const char *const *)a, *t = *(const char *const *)b;
    int x, y;

    do {
        x = next_sign(&s);
        y = next_sign(&t);
    } while (x && x == y);
    return x - y;
}

void tell_alike(const points *to, const char *title, const char **word,
                size_t many)
{
    size_t k, first = 0;
    long pairs = 0;
    char more[40] = "";

    qsort((void *)word, many, sizeof *word, unlike);
    for (k = 1; k < many; k++)
        /* (Co and CO may be two) */
        if (strlen(word[k]) > 2 && unlike(word + k - 1, word + k) == 0)
            if (pairs++ == 0) first = k;
    if (pairs == 0) return;
    if (pairs > 1) sprintf(more, "; so are %ld pairs more", pairs - 1);
    if (pairs == 2) strcpy(more, "; so is one pair more");
    k = strcmp(word[first - 1], word[first]) > 0;
    warn("%s: %s%s\"%.30s\" and \"%.30s\" are taken as two words, though "
         "only capitals or blanks differ%s", to->input, title,
         title[0] ? ": " : "", word[first - !k], word[first - k], more);
}

/* tell_words - such ones of values that are words. */
static void tell_words(const points *to)
{
    const char **word;
    long many, i;
    int k;

    for (k = 0; k < to->columns; k++) {
        if (!to->words[k]) continue;
        many = class_count(to->words[k]);
        word = (const char **)space((double)many, sizeof *word);
        for (i = 0; i < many; i++)
            word[i] = class_name(to->words[k], (double)i);
        tell_alike(to, to->name[k], word, (size_t)many);
        free((void *)word);
    }
}

void tell_rows(const reader *r)
{
    tell_words(r->to);
    if (r->to->scratch || r->to->n < ENOUGH || !r->table || r->form != LINES)
        return;
    tell_counts(r);
    tell_sums(r);
    tell_parted(r);
}
