/* doubts.c - what a reader doubts of columns: whether one numbers the rows.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define ENOUGH 4 /* rows, that anything can be said of them */

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
