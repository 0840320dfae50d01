/* level.c - surfaces of equal value, by -iso: of the first column of values,
 * linear in each tetrahedron.
 */
#include "../../recipes/recipes.h"
#include "driver.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const points *from;
static double *field; /* of each point: a duplicate's is in the mean */

void check_levels(const points *in)
{
    tess_int i;
    long bad = 0;
    double f;

    if (!next_output(iso_forms, 0)) return;
    if (in->axes == 2)
        fail("-iso is for points in space: in a plane there are no "
             "tetrahedra");
    if (in->columns == 0)
        fail("%s: the points have no values, of which -iso is a surface (-cols "
             "X,Y,Z,V names columns)", in->input);
    if (in->words[0])
        fail("%s: %s has words, of which -iso is no surface: -cols X,Y,Z,V "
             "names a column of numbers first", in->input, in->name[0]);
    for (i = 0; i < in->n; i++) {
        f = in->value[(size_t)in->columns * (size_t)i];
        if (f != f)
            fail("%s, line %ld: %s is NaN: -skip drops such rows; -cols "
                 "X,Y,Z,VALUE asks for one column's values",
                 in->input, in->line[i], in->name[0]);
        bad += !(fabs(f) <= DBL_MAX);
    }
    if (bad > 0)
        warn("%s: %ld value%s not finite: the surface ends at the tetrahedra "
             "that have them", in->input, bad, bad > 1 ? "s are" : " is");
}

void keep_levels(const mesh *m)
{
    tess_int n = m->in->n, i, r;
    double *times, f;
    long lost = 0;

    if (!next_output(iso_forms, 0)) return;
    from = m->in;
    field = (double *)space((double)n, sizeof *field);
    times = (double *)space((double)n, sizeof *times);
    for (i = 0; i < n; i++) {
        r = m->iw[i];
        f = from->value[(size_t)from->columns * (size_t)i];
        field[i] = f;
        times[i] = 1.0;
        if (r == i) continue;
        /* a running mean, which equal values leave as they are */
        lost += f < field[r] || f > field[r];
        times[r] += 1.0;
        field[r] += (f - field[r]) / times[r];
    }
    free(times);
    if (lost > 0 && !chosen.values && !chosen.validate)
        warn("points lie where another one does, %ld with another value: -iso "
             "takes their mean", lost);
}

/* ---- points that rounding has made one ---- */

static const tess_real *places;

/* by_place - points by their coordinates, then by number. */
static int by_place(const void *u, const void *v)
{
    tess_int i = *(const tess_int *)u, j = *(const tess_int *)v;
    const tess_real *a = places + 3 * (size_t)i, *b = places + 3 * (size_t)j;
    int k;

    for (k = 0; k < 3; k++)
        if (a[k] < b[k] || a[k] > b[k]) return a[k] < b[k] ? -1 : 1;
    return i < j ? -1 : i > j;
}

/* first_there - for each point the first one at its place; returns how many
 * others there are. */
static tess_int first_there(tess_int npt, const tess_real *x, tess_int *first)
{
    tess_int *order = (tess_int *)space((double)npt, sizeof *order), i;
    tess_int others = 0;
    const tess_real *a, *b;

    places = x;
    for (i = 0; i < npt; i++) order[i] = i;
    qsort(order, (size_t)npt, sizeof *order, by_place);
    for (i = 0; i < npt; i++) {
        first[order[i]] = order[i];
        if (i == 0) continue;
        a = x + 3 * (size_t)order[i - 1];
        b = x + 3 * (size_t)order[i];
        if (a[0] < b[0] || a[1] < b[1] || a[2] < b[2] || a[1] > b[1] ||
            a[2] > b[2])
            continue;
        first[order[i]] = first[order[i - 1]];
        others++;
    }
    free(order);
    return others;
}

/* by_corners - rows of three corners, a number. */
static int by_corners(const void *u, const void *v)
{
    const tess_int *a = (const tess_int *)u, *b = (const tess_int *)v;
    int k;

    for (k = 0; k < 4; k++)
        if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
    return 0;
}

/* cancel - leave triangles out that face each other, on the same corners: their
 * first corner becomes TESS_NONE. */
static void cancel(tess_int many, tess_int *tri)
{
    tess_int *row = (tess_int *)space(5.0 * (double)many, sizeof *row), *r;
    tess_int i, j, k, l, sum, turn, *t;

    for (i = 0; i < many; i++) {
        r = row + 5 * (size_t)i;
        t = tri + 3 * (size_t)i;
        turn = t[0] < t[1] ? (t[0] < t[2] ? 0 : 2) : (t[1] < t[2] ? 1 : 2);
        r[0] = t[turn];
        r[1] = t[(turn + 1) % 3];
        r[2] = t[(turn + 2) % 3];
        r[4] = r[1] < r[2] ? 1 : -1;
        if (r[4] < 0) {
            k = r[1];
            r[1] = r[2];
            r[2] = k;
        }
        r[3] = i;
    }
    qsort(row, (size_t)many, 5 * sizeof *row, by_corners);
    for (i = 0; i < many; i = j) {
        r = row + 5 * (size_t)i;
        for (sum = 0, j = i; j < many; j++) {
            for (l = 0; l < 3 && row[5 * (size_t)j + (size_t)l] == r[l];) l++;
            if (l < 3) break;
            sum += row[5 * (size_t)j + 4];
        }
        for (k = i; k < j; k++) {
            r = row + 5 * (size_t)k;
            if (r[4] * sum > 0)
                sum -= r[4];
            else
                tri[3 * (size_t)r[3]] = TESS_NONE;
        }
    }
    free(row);
}

/* unite - points at one place become one, and what triangles then have no area
 * is left out: so the surface stays as closed as it is. */
static void unite(tess_int *npt, tess_real *x, tess_int *ntri, tess_int *tri)
{
    tess_int *first = (tess_int *)space((double)*npt, sizeof *first);
    tess_int i, many = 0;
    size_t from_here, to, c;

    if (first_there(*npt, x, first) > 0) {
        for (i = 0; i < *ntri; i++) {
            from_here = 3 * (size_t)i;
            to = 3 * (size_t)many;
            for (c = 0; c < 3; c++) tri[to + c] = first[tri[from_here + c]];
            if (tri[to] != tri[to + 1] && tri[to + 1] != tri[to + 2] &&
                tri[to + 2] != tri[to])
                many++;
        }
        cancel(many, tri);
        for (i = 0; i < *npt; i++) first[i] = TESS_NONE;
        *ntri = 0;
        for (i = 0; i < many; i++) {
            if (tri[3 * (size_t)i] < 0) continue;
            to = 3 * (size_t)(*ntri)++;
            for (c = 0; c < 3; c++) {
                tri[to + c] = tri[3 * (size_t)i + c];
                first[tri[to + c]] = 0;
            }
        }
        many = 0;
        for (i = 0; i < *npt; i++) {
            if (first[i] < 0) continue;
            first[i] = many;
            for (c = 0; c < 3; c++)
                x[3 * (size_t)many + c] = x[3 * (size_t)i + c];
            many++;
        }
        *npt = many;
        for (to = 0; to < 3 * (size_t)*ntri; to++) tri[to] = first[tri[to]];
    }
    free(first);
}

/* ---- what comes out ---- */

/* by_ends - sides of triangles: the lesser end, the greater one, 1 or -1 for
 * the way from one to the other. */
static int by_ends(const void *x, const void *y)
{
    const tess_int *a = (const tess_int *)x, *b = (const tess_int *)y;

    if (a[0] != b[0]) return a[0] < b[0] ? -1 : 1;
    return a[1] < b[1] ? -1 : a[1] > b[1];
}

/* open_edges - how many edges have not as many triangles on one side as on the
 * other. */
static double open_edges(tess_int many, const tess_int *tri)
{
    tess_int *side = (tess_int *)space(9.0 * (double)many, sizeof *side);
    tess_int *s = side, i, way, a, b;
    size_t j, k, all = 3 * (size_t)many;
    double open = 0.0;
    int c;

    for (i = 0; i < many; i++)
        for (c = 0; c < 3; c++) {
            a = tri[3 * i + c];
            b = tri[3 * i + (c + 1) % 3];
            *s++ = a < b ? a : b;
            *s++ = a < b ? b : a;
            *s++ = a < b ? 1 : -1;
        }
    qsort(side, all, 3 * sizeof *side, by_ends);
    for (j = 0; j < all; j = k) {
        for (way = 0, k = j;
             k < all && by_ends(side + 3 * j, side + 3 * k) == 0; k++)
            way += side[3 * k + 2];
        open += way < 0 ? -(double)way : (double)way;
    }
    free(side);
    return open;
}

/* sizes - the area, and the volume between the triangles and a point. */
static void sizes(const tess_real *x, tess_int many, const tess_int *tri,
                  double *area, double *volume)
{
    const tess_real *o = x + 3 * (size_t)tri[0], *a;
    double e[2][3], c[3], d[3];
    tess_int i;
    int j, k;

    *area = *volume = 0.0;
    for (i = 0; i < many; i++) {
        a = x + 3 * (size_t)tri[3 * i];
        for (k = 0; k < 3; k++) {
            for (j = 0; j < 2; j++)
                e[j][k] =
                    (double)x[3 * (size_t)tri[3 * i + j + 1] + (size_t)k] -
                    (double)a[k];
            d[k] = (double)a[k] - (double)o[k];
        }
        normal_to(e[0], e[1], c);
        *area += sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / 2.0;
        *volume += (d[0] * c[0] + d[1] * c[1] + d[2] * c[2]) / 6.0;
    }
}

/* tell_level - what is of one level.  Where it does not meet the hull all of
 * that is above it, or all below; but what -alpha leaves may have several
 * boundaries. */
static void tell_level(double level, const tess_real *x, tess_int many,
                       const tess_int *tri)
{
    char text[REAL];
    double area, volume, open = open_edges(many, tri);

    sizes(x, many, tri, &area, &volume);
    real_text(text, level, 0);
    tell("level         %s of %s: %ld triangles, area %.9g", text,
         from->name[0], (long)many, area);
    if (open > 0.0)
        tell("; open at the hull, by %.0f edge%s: see -iso-closed", open,
             open > 1.0 ? "s" : "");
    else if (chosen.closed || !(chosen.alpha > 0.0))
        tell("; closed, volume %.9g %s it", fabs(volume),
             volume < 0.0 ? "below" : "above");
    else
        tell("; closed");
    tell("\n");
}

/* tell_none - why a level has no surface, even by -q. */
static void tell_none(double level)
{
    char text[3][REAL];
    double low = DBL_MAX, high = -DBL_MAX;
    tess_int i;

    for (i = 0; i < from->n; i++) {
        if (!(fabs(field[i]) <= DBL_MAX)) continue;
        if (field[i] < low) low = field[i];
        if (field[i] > high) high = field[i];
    }
    real_text(text[0], level, 0);
    real_text(text[1], low, 0);
    real_text(text[2], high, 0);
    warn("-iso %s: there is no such surface; %s is from %s to %s", text[0],
         from->name[0], text[1], text[2]);
}

/* one_level - the surface of that level, behind those that *s and *tri have. */
static void one_level(const mesh *m, double level, points *s, tess_int *many,
                      tess_int **tri)
{
    tess_int npt = 0, ntri, maxpt = 0, i, *mine, *ends, *work, none[1];
    double room;
    int code;
    tess_real *x;

    code = tr_iso(from->p, m->ntet, m->tet, m->adj, field, level, chosen.closed,
                  0, &npt, 0, 0, 0, &ntri, 0, none);
    if (code == 0) {
        tell_none(level);
        return;
    }
    if ((double)s->n + 3.0 * (double)ntri > (double)(TESS_INT_MOST / 3) ||
        (double)*many + (double)ntri > (double)(TESS_INT_MOST / 3))
        too_small("-iso: surfaces of more points than a tess_int of %d bytes "
                  "can number; rebuild with a larger -DTESS_INT=...",
                  (int)sizeof(tess_int));
    room = 0.5 * (double)ntri + 1000.0;
    mine = (tess_int *)space(3.0 * (double)ntri, sizeof *mine);
    do {
        if (room > 3.0 * (double)ntri) room = 3.0 * (double)ntri;
        maxpt = (tess_int)room;
        x = (tess_real *)space(3.0 * room, sizeof *x);
        ends = (tess_int *)space(2.0 * room, sizeof *ends);
        work = (tess_int *)space(2.0 * room + 1.0, sizeof *work);
        code = tr_iso(from->p, m->ntet, m->tet, m->adj, field, level,
                      chosen.closed, maxpt, &npt, x, ends, ntri, &ntri, mine,
                      work);
        free(work);
        free(ends);
        if (code != 0) free(x);
        room *= 2.0;
    } while (code != 0);
    unite(&npt, x, &ntri, mine);
    if (ntri > 0) tell_level(level, x, ntri, mine);
    s->p = (tess_real *)more_space(s->p, 3.0 * ((double)s->n + (double)npt),
                                   sizeof *s->p);
    s->value = (double *)more_space(s->value, (double)s->n + (double)npt,
                                    sizeof *s->value);
    *tri = (tess_int *)more_space(*tri, 3.0 * ((double)*many + (double)ntri),
                                  sizeof **tri);
    memcpy(s->p + 3 * (size_t)s->n, x, 3 * (size_t)npt * sizeof *x);
    for (i = 0; i < npt; i++) s->value[s->n + i] = level;
    for (i = 0; i < 3 * ntri; i++) (*tri)[3 * *many + i] = mine[i] + s->n;
    s->n += npt;
    *many += ntri;
    free(x);
    free(mine);
}

const points *level_surface(const mesh *m, const output *o, tess_int *many,
                            tess_int **tri)
{
    static points s;
    double level[LEVELS];
    int levels = list_numbers("-iso", o->levels, LEVELS, level), k;

    free(s.p);
    free(s.value);
    memset(&s, 0, sizeof s);
    s.columns = 1;
    s.axes = 3;
    if (from->columns > 1 && o == next_output(iso_forms, 0))
        warn("-iso: %s is the first of %d columns of values; -cols X,Y,Z,V "
             "chooses another one", from->name[0], from->columns);
    strcpy(s.name[0], from->name[0]);
    *many = 0;
    *tri = (tess_int *)space(1.0, sizeof **tri);
    for (k = 0; k < levels; k++) one_level(m, level[k], &s, many, tri);
    return &s;
}
