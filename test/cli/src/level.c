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
    tell("level         %s: %ld triangles, area %.9g", text, (long)many, area);
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

    code = iso(from->p, m->ntet, m->tet, m->adj, field, level, chosen.closed,
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
        code = iso(from->p, m->ntet, m->tet, m->adj, field, level,
                   chosen.closed, maxpt, &npt, x, ends, ntri, &ntri, mine,
                   work);
        free(work);
        free(ends);
        if (code != 0) free(x);
        room *= 2.0;
    } while (code != 0);
    tell_level(level, x, ntri, mine);
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
    strcpy(s.name[0], from->name[0]);
    *many = 0;
    *tri = (tess_int *)space(1.0, sizeof **tri);
    for (k = 0; k < levels; k++) one_level(m, level[k], &s, many, tri);
    return &s;
}
