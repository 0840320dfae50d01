/* voids.c - numbers of points that may stand for none, as -9999; and how often
 * numbers are there.
 *
 * Such a mark is a number that is exactly the same in some rows and
 *
 *   far      from all others by more than their range: of nines, as -99, 999,
 *            -9999; or so large; or of values any that is there twice
 *   alone    below 0, of nines even once, any other if it is often, too, or in
 *            three rows a value that is whole where others are not, or beyond a
 *            gap, or where hardly any number is there again
 *   often    of nines, or in a table z if that is 0 or -1: in three rows, and
 *            in more than twice as many as any other number
 *
 * z = 0 or -1 is one only if it stands apart: there is a gap between it and all
 * others, and it is in less than half of the rows, or it is in a fifth at most
 * (and one of 10,000 at least); it is not in the middle of the others; and the
 * points nearest to these rows, by x and y, are not nearly as high, as a rule.
 * So the sea, the foot of a plate, the collars of holes, a plane of symmetry
 * are none; nor is a layer of a grid, for other numbers are there as often.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define ENOUGH 4         /* rows, that anything can be said of them         */
#define MANY 10          /* and of marks that are not of nines              */
#define OFTEN_ENOUGH 50 /* that some numbers were there again by chance */
#define FAR 3.0          /* ranges between a value and those it is far from */
#define HUGE_NUMBER 1e10 /* what may stand for none, if others are far      */
#define MIDDLE 0.05      /* of the range about 0: it is in the middle       */
#define MARKS 24         /* of a column; nines of either sign, as a rule    */
#define BELOWS 4         /* other numbers below 0, if those are marks       */
#define LOOKS 32         /* rows of which the nearest ones are looked for   */
#define DOUBTS 64        /* that are told of a file                         */

double number_of(const points *to, int k, tess_int i)
{
    if (k < 3) return (double)to->p[3 * (size_t)i + (size_t)k];
    return to->value[(size_t)to->columns * (size_t)i + (size_t)(k - 3)];
}

/* ----------------------------------------------------- how often numbers are */

/* place_of - of a number in a table of mask + 1 places. */
static size_t place_of(double x, size_t mask)
{
    unsigned char bytes[sizeof x];
    unsigned long sum = 2166136261UL;
    size_t i;

    memcpy(bytes, &x, sizeof x);
    for (i = 0; i < sizeof x; i++)
        sum = ((sum ^ bytes[i]) * 16777619UL) & 0xffffffffUL;
    return (size_t)(sum ^ sum >> 15) & mask;
}

void count_numbers(const points *of, int k, const double *but, int many,
                   frequency *found)
{
    size_t room = 16, mask, at;
    double *number, x;
    long *times;
    tess_int i;
    int j;

    while (room < 2 * (size_t)of->n) room *= 2;
    mask = room - 1;
    number = (double *)space((double)room, sizeof *number);
    times = (long *)space((double)room, sizeof *times);
    memset(times, 0, room * sizeof *times);
    memset(found, 0, sizeof *found);
    for (i = 0; i < of->n; i++) {
        x = number_of(of, k, i) + 0.0; /* (-0 is 0) */
        if (!(fabs(x) <= DBL_MAX)) continue;
        for (j = 0; j < many && x != but[j];) j++;
        if (j < many) continue;
        if (found->all == 0 || x < found->low) found->low = x;
        if (found->all == 0 || x > found->high) found->high = x;
        found->all++;
        for (at = place_of(x, mask); times[at] > 0 && number[at] != x;)
            at = (at + 1) & mask;
        number[at] = x;
        if (++times[at] == 1) found->different++;
        if (x == found->most && found->times > 0)
            found->times = times[at];
        else if (times[at] > found->times) {
            found->next = found->times;
            found->most = x;
            found->times = times[at];
        } else if (times[at] > found->next)
            found->next = times[at];
    }
    free(number);
    free(times);
}

/* ----------------------------------------------- numbers that stand for none */

/* mark - a number that may, and in how many rows it is. */
typedef struct mark {
    double x;
    long times;
} mark;

/* series - an axis, from 0 on, or a value, from 3 on: its numbers of nines; the
 * others' range, and which of them are below 0, BELOWS + 1 of them if they are
 * more. */
typedef struct series {
    const points *of;
    const reader *from;
    int k, marks, belows;
    mark mark[MARKS], below[BELOWS];
    double low, high;
    long others, zeros, ones; /* (ones: of -1) */
} series;

/* doubt - what is found: how, and what it is told with. */
typedef struct doubt {
    double x, low, high;
    long times, often;
    int k, how;
} doubt;

enum { FAR_OFF, ALONE, OFTEN };

typedef struct list {
    doubt doubt[DOUBTS];
    int many;
} list;

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

/* may_be_nines - the same, or perhaps: nearly all numbers are not. */
static int may_be_nines(double x)
{
    double size = fabs(x);
    long n;

    if (size < 99.0) return 0;
    if (!(size < 1e9)) return 1;
    n = (long)size;
    return (n + 1) % 1000 == 0 || n == 99 || n == 32768;
}

/* one_more - x among so many marks, most at most; how many there are then, or
 * most + 1. */
static int one_more(mark *of, int many, int most, double x)
{
    int k;

    for (k = 0; k < many && k < most && of[k].x != x;) k++;
    if (k < many && k < most) of[k].times++;
    if (k < many || many > most) return many;
    if (k == most) return most + 1;
    of[k].x = x;
    of[k].times = 1;
    return many + 1;
}

static void look_at(series *s)
{
    const points *of = s->of;
    double x, low = DBL_MAX, high = -DBL_MAX;
    size_t i, n = (size_t)of->n, columns = (size_t)of->columns;
    const tess_real *p = of->p + (s->k < 3 ? s->k : 0);
    const double *v = s->k < 3 ? 0 : of->value + (s->k - 3);
    int k;

    for (i = 0; i < n; i++) {
        x = v ? v[columns * i] : (double)p[3 * i];
        if (may_be_nines(x)) {
            if (!(fabs(x) <= DBL_MAX)) continue;
            if (nines(x) && s->marks <= MARKS) {
                s->marks = one_more(s->mark, s->marks, MARKS, x);
                if (s->marks <= MARKS) continue;
            }
        }
        s->others++;
        if (x < low) low = x;
        if (x > high) high = x;
        if (x > 0.0) continue;
        s->zeros += x == 0.0;
        s->ones += x == -1.0;
        if (x < 0.0 && s->belows <= BELOWS)
            s->belows = one_more(s->below, s->belows, BELOWS, x);
    }
    if (s->marks > MARKS) {
        /* (so many are no marks) */
        for (k = 0; k < MARKS; k++) {
            if (s->mark[k].x < low) low = s->mark[k].x;
            if (s->mark[k].x > high) high = s->mark[k].x;
        }
        s->marks = 0;
    }
    s->low = low;
    s->high = high;
}

/* found - a doubt more. */
static void found(list *all, const series *s, mark m, int how, long most)
{
    doubt *d = all->doubt + all->many;
    int k;

    if (all->many == DOUBTS) return;
    /* (a limit is no mark; and what is one is said once) */
    for (k = 0; k < s->from->limits && s->k > 2; k++)
        if (s->from->limit[k] == m.x) return;
    for (k = 0; k < all->many; k++)
        if (all->doubt[k].x == m.x && all->doubt[k].k == s->k) return;
    d->x = m.x;
    d->times = m.times;
    d->k = s->k;
    d->how = how;
    d->low = s->low;
    d->high = s->high;
    d->often = most;
    all->many++;
}

/* most_often - how often is the number that is there most often, but for the
 * marks and, if it is none of them, m? */
static long most_often(const series *s, mark m)
{
    double but[MARKS + BELOWS + 1];
    frequency of;
    int k, many = 0;

    for (k = 0; k < s->marks; k++) but[many++] = s->mark[k].x;
    for (k = 0; k < s->belows && s->belows <= BELOWS; k++)
        if (s->below[k].times > 1) but[many++] = s->below[k].x;
    but[many++] = m.x;
    count_numbers(s->of, s->k, but, many, &of);
    return of.times;
}

/* find_nines - those of the column that are marks. */
static void find_nines(const series *s, list *all)
{
    double range = s->high - s->low, gap;
    long most = 0;
    int k;

    for (k = 0; k < s->marks && s->others > 0; k++) {
        const mark m = s->mark[k];

        gap = m.x < s->low ? s->low - m.x : m.x - s->high;
        if (gap > range && (s->k < 3 ? s->others >= 3 &&
                                           (range > 0.0 || m.x < 0.0)
                                     : range > 0.0)) {
            found(all, s, m, FAR_OFF, 0);
            continue;
        }
        if (s->others >= 3 && m.x < 0.0 && s->low >= 0.0 && s->high > 0.0) {
            found(all, s, m, ALONE, 0);
            continue;
        }
        if (m.times < 3 || s->others < 3) continue;
        if (most == 0) most = most_often(s, m);
        if (m.times > 2 * most) found(all, s, m, OFTEN, most);
    }
}

/* find_ends - the least number, or the largest, by sign, far from all others,
 * that is not of nines. */
static void find_ends(const series *s, list *all, double sign)
{
    double least = sign > 0.0 ? s->low : -s->high, middle, x;
    double next = DBL_MAX, most = -DBL_MAX, largest;
    long others = 0;
    mark m;
    series rest = *s;
    tess_int i;
    int may;

    m.times = 0;
    m.x = sign * least;
    /* (the others are on one side of the middle) */
    middle = s->low / 2.0 + s->high / 2.0;
    for (i = 0; i < s->of->n; i++) {
        x = number_of(s->of, s->k, i);
        if (!(fabs(x) <= DBL_MAX) ||
            (s->marks > 0 && may_be_nines(x) && nines(x)))
            continue;
        if (x == m.x) {
            m.times++;
            continue;
        }
        if (sign > 0.0 ? x < middle : x > middle) return;
        x *= sign;
        if (x < next) next = x;
        if (x > most) most = x;
        others++;
    }
    largest = fabs(next) > fabs(most) ? fabs(next) : fabs(most);
    if (s->k < 3)
        may = others >= 3 && next - least > most - next &&
              (m.times > 1 ? fabs(m.x) >= 1e9 : fabs(m.x) >= 1e20) &&
              fabs(m.x) / 1e6 > largest;
    else
        may = others > 0 && next < most &&
              (fabs(m.x) >= HUGE_NUMBER
                   ? next - least > most - next
                   : m.times > 1 && next - least > FAR * (most - next));
    if (!may) return;
    rest.low = sign > 0.0 ? next : -most;
    rest.high = sign > 0.0 ? most : -next;
    found(all, &rest, m, FAR_OFF, 0);
}

/* gap_of - what is a gap among so many numbers, as a part of their range. */
static double gap_of(double n)
{
    return 10.0 / n < 1.0 / sqrt(n) ? 10.0 / n : 1.0 / sqrt(n);
}

/* set_off - are the marks below 0 no part of what the column measures: whole
 * numbers, as others are by chance alone; or beyond a gap; or there again where
 * others are not, as a rule, most times at most?  low: the least one of the
 * others; times: how often the marks are there. */
static int set_off(const series *s, double low, long times, long most)
{
    double x, least = 0.0, n = (double)(s->others - times);
    long broken = 0;
    tess_int i;
    int k, whole_numbers = 1;

    for (k = 0; k < s->belows; k++) {
        x = s->below[k].x;
        whole_numbers = whole_numbers && x == floor(x);
        if (x < least) least = x;
    }
    for (i = 0; i < s->of->n; i++) {
        x = number_of(s->of, s->k, i);
        broken += x >= 0.0 && x != floor(x);
    }
    return (whole_numbers && 4.0 * (double)broken > 3.0 * n) ||
           (low > -least && low > gap_of(n) * (s->high - low)) ||
           (most < 3 && n >= OFTEN_ENOUGH);
}

/* find_belows - numbers below 0 that are marks, as no other number is below
 * it. */
static void find_belows(const series *s, list *all)
{
    double low = s->high;
    series rest = *s;
    long most, times = 0;
    tess_int i;
    int k, off, before = all->many;

    if (s->belows == 0 || s->belows > BELOWS || s->of->n < MANY ||
        !(s->high > 0.0))
        return;
    for (k = 0; k < s->belows; k++)
        if (s->below[k].times < (s->below[k].x == -1.0 ? 2 : 3)) return;
    most = most_often(s, s->below[0]);
    for (i = 0; i < s->of->n; i++)
        if (number_of(s->of, s->k, i) >= 0.0 &&
            number_of(s->of, s->k, i) < low)
            low = number_of(s->of, s->k, i);
    rest.low = low;
    for (k = 0; k < s->belows; k++) times += s->below[k].times;
    off = s->k > 2 && set_off(s, low, times, most);
    for (k = 0; k < s->belows; k++) {
        if (!(off && s->below[k].times > 2) &&
            s->below[k].times <=
                (s->below[k].x == -1.0 && most == 1 ? 1 : 2 * most)) {
            all->many = before;
            return;
        }
        found(all, &rest, s->below[k], ALONE, most);
    }
}

/* distance - of two points by the coordinates but axis k, each measured by its
 * range. */
static double distance(const points *of, int k, const double *range, tess_int i,
                       tess_int j)
{
    double sum = 0.0, x;
    int a;

    for (a = 0; a < 3; a++) {
        if (a == k || !(range[a] > 0.0)) continue;
        x = (number_of(of, a, i) - number_of(of, a, j)) / range[a];
        sum += x * x;
    }
    return sum;
}

/* scattered - are points that are near to those of number v along axis k, by
 * their other coordinates, not near to it along that, as a rule?  (Nor there
 * at the same place.) */
static int scattered(const points *of, int k, mark m)
{
    double range[3], low, high, x, mean = 0.0, least, d;
    long seen = 0, tried = 0, near_by = 0, step = m.times / LOOKS + 1;
    tess_int i, j, next;
    int a;

    for (a = 0; a < 3; a++) {
        low = high = number_of(of, a, 0);
        for (i = 1; i < of->n; i++) {
            x = number_of(of, a, i);
            if (x < low) low = x;
            if (x > high) high = x;
        }
        range[a] = high - low;
    }
    for (i = 0; i < of->n; i++)
        mean += fabs(number_of(of, k, i) - m.x) /
                (double)(of->n - (tess_int)m.times);
    for (i = 0; i < of->n; i++) {
        if (number_of(of, k, i) != m.x || seen++ % step != 0) continue;
        next = -1;
        least = DBL_MAX;
        for (j = 0; j < of->n; j++) {
            if (j == i) continue;
            d = distance(of, k, range, i, j);
            if (d >= least) continue;
            least = d;
            next = j;
        }
        tried++;
        near_by += next < 0 || least == 0.0 ||
                   fabs(number_of(of, k, next) - m.x) < mean / 4.0;
    }
    return 2 * near_by < tried;
}

/* find_often - is the coordinate 0, or -1, a mark?  (x and y may be 0 for many
 * reasons.) */
static void find_often(const series *s, list *all, double x)
{
    double low = DBL_MAX, high = -DBL_MAX, y, gap, least, n;
    series rest = *s;
    long most;
    mark m;
    tess_int i;
    int k;

    m.x = x;
    m.times = x == 0.0 ? s->zeros : s->ones;
    /* (so seldom it is by chance) */
    if (s->of->n < MANY || m.times < 3 || 2 * m.times >= (long)s->of->n ||
        1e4 * (double)m.times < (double)s->of->n)
        return;
    for (k = 0; k < all->many; k++)
        if (all->doubt[k].x == x && all->doubt[k].k == s->k) return;
    most = most_often(s, m);
    if (m.times <= 2 * most) return;
    for (i = 0; i < s->of->n; i++) {
        y = number_of(s->of, s->k, i);
        for (k = 0; k < s->marks && y != s->mark[k].x;) k++;
        if (k < s->marks || y == x) continue;
        if (y < low) low = y;
        if (y > high) high = y;
    }
    n = (double)(s->others - m.times);
    if (n < 3.0 || !(low < high)) return;
    gap = low > x ? low - x : x - high;
    least = gap_of(n);
    rest.low = low;
    rest.high = high;
    if (gap > high - low && 3 * m.times <= (long)s->of->n)
        found(all, &rest, m, FAR_OFF, 0);
    else if (s->k == 2 &&
             (gap > 0.0 || fabs(low + high) > MIDDLE * (high - low)) &&
             (gap > least * (high - low) || 5 * m.times <= (long)s->of->n) &&
             scattered(s->of, s->k, m))
        found(all, &rest, m, OFTEN, most);
}

/* ----------------------------------------------------------- what is said */

static const char apart[] = "far from all others";

/* having - the rows that have that number as a coordinate, the first one and
 * the last one; any: or as any number that -nodata looks at. */
static long having(const points *to, double x, int any, tess_int *first,
                   tess_int *last)
{
    tess_int i;
    long many = 0;
    int k, found_it;

    for (i = 0; i < to->n; i++) {
        for (found_it = k = 0; k < (any ? 3 + to->columns : 3); k++)
            found_it |= number_of(to, k, i) == x &&
                        !(k > 2 && to->words[k - 3]);
        if (!found_it) continue;
        if (many++ == 0) *first = i;
        *last = i;
    }
    return many;
}

/* mark_text - the number, as -nodata takes it. */
static void mark_text(char *text, double x, int axis)
{
    real_text(text, x, axis && sizeof(tess_real) < sizeof(double));
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

    mark_text(text, x, 1);
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

/* is_zero - are the first so many coordinates 0? */
static int is_zero(const points *to, int axes, tess_int i)
{
    int k;

    for (k = 0; k < axes && number_of(to, k, i) == 0.0;) k++;
    return k == axes;
}

/* zeros_far - are the rows of so many zeros far from all others along one of
 * these axes; by so many of their ranges? */
static int zeros_far(const points *to, int axes, double ranges)
{
    double low[3], high[3], x;
    tess_int i, others = 0;
    int k, far = 0;

    for (i = 0; i < to->n; i++) {
        if (is_zero(to, axes, i)) continue;
        others++;
        for (k = 0; k < axes; k++) {
            x = number_of(to, k, i);
            if (others == 1 || x < low[k]) low[k] = x;
            if (others == 1 || x > high[k]) high[k] = x;
        }
    }
    for (k = 0; k < axes && others > 0; k++)
        far |= low[k] > ranges * (high[k] - low[k]) ||
               -high[k] > ranges * (high[k] - low[k]);
    /* (what is in one place, or on one line, has no range) */
    return far && (axes == 3 || (low[0] < high[0] && low[1] < high[1]));
}

/* doubt_zeros - of how many coordinates are there rows of zeros that were not
 * filled?  0: there are none.  So it is where they are
 * far from all others, or several at the end; and where x and y alone are, in a
 * row or two, or in any of longitudes and latitudes. */
static int doubt_zeros(reader *r)
{
    const points *to = r->to;
    tess_int i, first = 0, last = 0, zeros, end;
    int axes, globe = is_globe(r), far;

    for (i = 0; i < to->n && !is_zero(to, 2, i);) i++;
    for (axes = i < to->n ? 3 : 0; axes > 1; axes--) {
        for (zeros = end = i = 0; i < to->n; i++) {
            end++;
            if (!is_zero(to, axes, i)) {
                end = 0;
                continue;
            }
            if (zeros++ == 0) first = i;
            last = i;
        }
        if (zeros == 0 || to->n - zeros < 3) continue;
        far = zeros_far(to, axes, axes == 2 && globe ? 0.5 : 1.0);
        if (axes == 2 && (!far || !r->table || (zeros > 2 && !globe))) continue;
        if (!far) {
            if (end < 2) continue;
            zeros = end;
            first = to->n - end;
        }
        tell_void(r, 0.0, axes == 2 || r->axes == 2 ? "x, y" : "x, y, z",
                  (long)zeros, first, last, far ? apart : "the last ones");
        return axes;
    }
    return 0;
}

/* why_so - the reason, into text. */
static void why_so(const doubt *d, char *text)
{
    if (d->how == ALONE)
        sprintf(text, "below 0 as no other one is, %.6g to %.6g", d->low,
                d->high);
    else if (d->how == OFTEN)
        sprintf(text, "where no other number is in more than %ld", d->often);
    else
        strcpy(text, apart);
}

/* tell_axes - the doubt, and all of the same number along other axes, whose
 * times are 0 then. */
static void tell_axes(reader *r, list *all, int at)
{
    const points *to = r->to;
    doubt *d = all->doubt + at;
    char axes[12] = "", why[120];
    tess_int first = 0, last = 0;
    long many;
    int j;

    for (j = at; j < all->many; j++) {
        if (d[j - at].x != d->x || d[j - at].k > 2 || d[j - at].times == 0)
            continue;
        sprintf(axes + strlen(axes), axes[0] ? ", %c" : "%c",
                "xyz"[d[j - at].k]);
        if (j > at) d[j - at].times = 0;
    }
    many = having(to, d->x, 0, &first, &last);
    why_so(d, why);
    if (d->x == 999.0 && many == 1 && last == to->n - 1 && strlen(axes) > 4)
        strcpy(why, "far from all others, as IRAP ends a file");
    tell_void(r, d->x, axes, many, first, last, why);
}

static void tell_value(const points *to, const doubt *d)
{
    char text[REAL], why[120];

    mark_text(text, d->x, 0);
    why_so(d, why);
    if (d->how == FAR_OFF)
        sprintf(why + strlen(why), ", %.6g to %.6g", d->low, d->high);
    if (d->how == OFTEN) strcat(why, " rows");
    warn("%s: %ld value%s of %s %s %s, %s; if that stands for a missing "
         "value: -nodata %s", to->input, d->times, d->times > 1 ? "s" : "",
         to->name[d->k - 3], d->times > 1 ? "are" : "is", text, why, text);
}

/* tell_all - one -nodata for all numbers that are doubted, if they are not one;
 * zeros: is 0 one that is not in the list? */
static void tell_all(const reader *r, const list *all, int zeros)
{
    const points *to = r->to;
    double x[VOIDS];
    char text[VOIDS * (REAL + 1)] = "";
    tess_int i, drops = 0;
    int k, j, many = 0, has;

    if (zeros) x[many++] = 0.0;
    for (k = 0; k < all->many; k++) {
        for (j = 0; j < many && x[j] != all->doubt[k].x;) j++;
        if (j == many && many < VOIDS) x[many++] = all->doubt[k].x;
    }
    if (many < 2) return;
    for (i = 0; i < to->n; i++) {
        for (has = k = 0; k < 3 + to->columns && !has; k++)
            for (j = 0; j < many && !has; j++)
                has = number_of(to, k, i) == x[j] &&
                      (k < 3 ? k < r->axes : !to->words[k - 3]);
        drops = (tess_int)(drops + has);
    }
    if (drops == to->n) return;
    for (j = 0; j < many; j++) {
        if (j > 0) strcat(text, ",");
        for (has = k = 0; k < all->many; k++)
            has |= all->doubt[k].x == x[j] && all->doubt[k].k < 3;
        mark_text(text + strlen(text), x[j], has);
    }
    warn("%s: if all of these stand for missing numbers: -nodata %s (it drops "
         "%ld of %ld rows)", to->input, text, (long)drops, (long)to->n);
}

void doubt_points(reader *r)
{
    points *to = r->to;
    static const series none;
    list all;
    series s;
    int k, zeros;

    if (to->scratch || to->n < ENOUGH) return;
    all.many = 0;
    zeros = doubt_zeros(r);
    to->doubted |= zeros > 0;
    for (k = 0; k < 3 + to->columns; k++) {
        if ((k == r->axes && k < 3) || (k > 2 && to->words[k - 3])) continue;
        s = none;
        s.of = to;
        s.from = r;
        s.k = k;
        look_at(&s);
        if (s.others == 0) continue;
        find_nines(&s, &all);
        find_ends(&s, &all, 1.0);
        find_ends(&s, &all, -1.0);
        if (k > 2 || r->table) find_belows(&s, &all);
        if (k > 2 || !r->table) continue;
        if (k >= zeros) find_often(&s, &all, 0.0);
        find_often(&s, &all, -1.0);
    }
    for (k = 0; k < all.many; k++)
        if (all.doubt[k].k < 3 && all.doubt[k].times > 0) {
            tell_axes(r, &all, k);
            to->doubted = 1;
        }
    for (k = 0; k < all.many; k++)
        if (all.doubt[k].k > 2) tell_value(to, all.doubt + k);
    tell_all(r, &all, zeros);
}
