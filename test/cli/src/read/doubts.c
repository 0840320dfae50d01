/* doubts.c - what a reader doubts of numbers: columns that number the rows, and
 * numbers that stand for none.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define ENOUGH 4         /* rows, that anything can be said of them         */
#define FAR 3.0          /* ranges between a value and those it is far from */
#define HUGE_NUMBER 1e10 /* what may stand for none, if others are far      */

/* ----------------------------------------------- columns that number rows */

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

/* number_of - an axis of the point, from 0 on, or a value, from 3 on. */
static double number_of(const points *to, int k, tess_int i)
{
    if (k < 3) return (double)to->p[3 * (size_t)i + (size_t)k];
    return to->value[(size_t)to->columns * (size_t)i + (size_t)(k - 3)];
}

/* whole_beside - are all numbers of x whole, and some of each other axis and of
 * the first value not?  Then what is unlike the others may number the rows. */
static int whole_beside(const reader *r)
{
    const points *to = r->to;
    int k, broken[4] = {0}, all = 1;
    tess_int i;

    for (i = 0; i < to->n; i++)
        for (k = 0; k < 4; k++)
            broken[k] |= number_of(to, k, i) != floor(number_of(to, k, i));
    for (k = 1; k < 4; k++) all &= broken[k] || k == r->axes;
    return all && !broken[0];
}

/* may_number - was a column taken for x that may number the rows, as it rises
 * by whole numbers, or has each but once? */
static int may_number(const reader *r)
{
    if (r->counting)
        return numbering(r, 2.0) || r->numbered_rows >= ENOUGH;
    return r->unique && !r->to->cols && r->number < 0 && r->family < 0 &&
           r->use[0] == 0 && r->to->columns > 0 && !r->to->scratch &&
           r->to->n >= ENOUGH && whole_beside(r);
}

void tell_numbers(reader *r)
{
    const points *to = r->to;
    char list[64], axes[64], first[80];
    int k = r->use[0], next = r->use[r->axes - 1] + 1;
    int may = !r->column[k].title[0] && may_number(r);

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
    warn("%s: column %d is %s and was taken for x; if it numbers the points: "
         "%s %d%s,%d", to->input, k + 1, first, axes_option(r), r->use[1] + 1,
         list, next + 1);
}

/* ------------------------------------------- numbers that stand for none */

/* series - an axis, from 0 on, or a value, from 3 on; how far its least number
 * is from all others, or with sign -1 its largest. */
typedef struct series {
    const points *of;
    int k;
    double sign, far, next, most; /* that one; those between which others are */
    long times, others;
} series;

static void look_at(series *s)
{
    double least = 0.0, next = 0.0, most = 0.0, x;
    const points *of = s->of;
    long times = 0, others = 0;
    tess_int i, n = of->n;
    int k = s->k, sign = s->sign < 0.0;

    for (i = 0; i < n; i++) {
        x = number_of(of, k, i);
        if (sign) x = -x;
        /* (as nearly all are) */
        if (others > 0 && x >= next && x <= most) {
            others++;
            continue;
        }
        if (!(fabs(x) <= DBL_MAX)) continue;
        if (times > 0 && x < least) {
            next = least;
            others += times;
            if (others == times) most = least;
            times = 0;
        }
        if (times == 0 || x == least) {
            least = x;
            times++;
            continue;
        }
        if (others == 0 || x < next) next = x;
        if (others == 0 || x > most) most = x;
        others++;
    }
    s->far = least;
    s->next = next;
    s->most = most;
    s->times = times;
    s->others = others;
}

/* nines - is it of nines alone, but for .25, .9, .99 behind them; or -99, or
 * -32768? */
static int nines(double x)
{
    static const double behind[] = {0.0, 0.25, 0.9, 0.99};
    double size = fabs(x), n;
    int k;

    if (x == -99.0 || x == -32768.0) return 1;
    for (n = 999.0; n + 1.0 < size;) n = 10.0 * n + 9.0;
    for (k = 0; k < 4; k++)
        if (size == n + behind[k]) return 1;
    return 0;
}

/* void_number - may that number of an axis stand for none? */
static int void_number(const series *s)
{
    double range = s->most - s->next, largest = fabs(s->next);

    if (s->others < 3 || !(s->next - s->far > range)) return 0;
    if (nines(s->sign * s->far)) return range > 0.0 || s->sign > 0.0;
    if (fabs(s->most) > largest) largest = fabs(s->most);
    return (s->times > 1 ? fabs(s->far) >= 1e9 : fabs(s->far) >= 1e20) &&
           fabs(s->far) / 1e6 > largest;
}

/* void_value - may that value? */
static int void_value(const series *s)
{
    int sure = nines(s->sign * s->far) || fabs(s->far) >= HUGE_NUMBER;

    return s->others > 0 && s->next < s->most && (s->times > 1 || sure) &&
           s->next - s->far > (sure ? 1.0 : FAR) * (s->most - s->next);
}

static const char apart[] = "far from all others";

/* having - the rows that have that number as a coordinate, the first one and
 * the last one; any: or as any number that -nodata looks at. */
static long having(const points *to, double x, int any, tess_int *first,
                   tess_int *last)
{
    tess_int i;
    long many = 0;
    int k, found;

    for (i = 0; i < to->n; i++) {
        for (found = k = 0; k < (any ? 3 + to->columns : 3); k++)
            found |= number_of(to, k, i) == x;
        if (!found) continue;
        if (many++ == 0) *first = i;
        *last = i;
    }
    return many;
}

/* tell_void - of so many rows from one line to another; axes: which coordinates
 * they are. */
static void tell_void(const reader *r, double x, const char *axes, long many,
                      tess_int first, tess_int last, const char *why)
{
    const points *to = r->to;
    char text[REAL], drops[80], rows[80] = "";
    tess_int from, end;
    long all = having(to, x, 1, &from, &end);

    real_text(text, x, 0);
    sprintf(drops, "-nodata %s", text);
    if (all == (long)to->n)
        strcpy(drops, "leave it out of the file");
    else if (all > many)
        sprintf(drops + strlen(drops), " (which drops %ld more row%s, with it "
                "elsewhere)", all - many, all - many > 1 ? "s" : "");
    if (many > 1)
        sprintf(rows, " in %ld rows, to %s %ld", many,
                r->form == PACKED ? "row" : "line", to->line[last]);
    warn(r->form == PACKED ? "%s, row %ld: %s %s %s%s, %s; if that stands for "
                             "a missing number: %s"
                           : "%s:%ld: %s %s %s%s, %s; if that stands for a "
                             "missing number: %s",
         to->input, to->line[first], axes, axes[1] ? "are" : "is", text, rows,
         why, drops);
}

/* doubt_zeros - are rows of zeros what was not filled?  So it is where they are
 * far from all others, or several at the end. */
static int doubt_zeros(reader *r)
{
    const points *to = r->to;
    double low[3] = {0.0}, high[3] = {0.0}, x;
    tess_int i, first = 0, last = 0, zeros = 0, others, end = 0;
    int k, far = 0;

    for (i = 0; i < to->n; i++) {
        for (k = 0; k < 3 && number_of(to, k, i) == 0.0;) k++;
        if (k == 3) {
            if (zeros++ == 0) first = i;
            last = i;
            end++;
        } else
            end = 0;
    }
    if (zeros == 0 || to->n - zeros < 3) return 0;
    for (others = i = 0; i < to->n; i++) {
        for (k = 0; k < 3 && number_of(to, k, i) == 0.0;) k++;
        if (k == 3) continue;
        others++;
        for (k = 0; k < 3; k++) {
            x = number_of(to, k, i);
            if (others == 1 || x < low[k]) low[k] = x;
            if (others == 1 || x > high[k]) high[k] = x;
        }
    }
    for (k = 0; k < 3; k++)
        far |= low[k] > high[k] - low[k] || -high[k] > high[k] - low[k];
    if (far == 0) {
        if (end < 2) return 0;
        zeros = end;
        first = to->n - end;
    }
    tell_void(r, 0.0, r->axes == 2 ? "x, y" : "x, y, z", (long)zeros, first,
              last, far ? apart : "the last ones");
    return 1;
}

void doubt_points(reader *r)
{
    points *to = r->to;
    series s[6], v;
    tess_int first = 0, last = 0;
    char axes[12], text[40];
    int k, j, doubts;
    long many;

    if (to->scratch || to->n < ENOUGH) return;
    doubts = doubt_zeros(r);
    for (k = 0; k < 2 * r->axes; k++) {
        s[k].of = to;
        s[k].k = k / 2;
        s[k].sign = k % 2 ? -1.0 : 1.0;
        look_at(s + k);
        s[k].times = void_number(s + k) ? s[k].times : 0;
    }
    for (k = 0; k < 2 * r->axes; k++) {
        if (s[k].times == 0) continue;
        axes[0] = '\0';
        for (j = k; j < 2 * r->axes; j++) {
            if (s[j].times == 0 || s[j].sign * s[j].far != s[k].sign * s[k].far)
                continue;
            sprintf(axes + strlen(axes), axes[0] ? ", %c" : "%c",
                    "xyz"[s[j].k]);
            if (j > k) s[j].times = 0;
        }
        many = having(to, s[k].sign * s[k].far, 0, &first, &last);
        tell_void(r, s[k].sign * s[k].far, axes, many, first, last,
                  s[k].sign * s[k].far == 999.0 && many == 1 &&
                          last == to->n - 1 && strlen(axes) > 4
                      ? "far from all others, as IRAP ends a file" : apart);
        doubts = 1;
    }
    to->doubted = doubts;
    for (k = 0; k < 2 * to->columns; k++) {
        v.of = to;
        v.k = 3 + k / 2;
        v.sign = k % 2 ? -1.0 : 1.0;
        look_at(&v);
        if (!void_value(&v)) continue;
        real_text(text, v.sign * v.far, 0);
        warn("%s: %ld value%s of %s %s %s, far from all others, %.6g to %.6g; "
             "if that stands for a missing value: -nodata %s",
             to->input, v.times, v.times > 1 ? "s" : "", to->name[k / 2],
             v.times > 1 ? "are" : "is", text,
             v.sign > 0.0 ? v.next : -v.most, v.sign > 0.0 ? v.most : -v.next,
             text);
    }
}
