/* alpha.c - alpha shapes: the tetrahedra whose circumradius is not larger than
 * a given one, exactly; the least such radius that leaves one piece with all
 * points; whether the surface is a manifold.  And whether a surface that is
 * read is closed.
 *
 * Lengths are those of the stretched points, by -scale.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "../../lib/exact.h"
#include "driver.h"

/* A radius is in doubt by so much, in units of rounding of all coordinates that
 * are in it: twice what tess_ball adds, and more. */
#define DOUBT (300.0 * DBL_EPSILON)

/* Bits of coordinates, or between their unit and a radius', that the exact
 * numbers have room for: products of 8 of the former and 2 of the latter. */
#define WIDEST 1000

static const mesh *of;
static double *low, *high; /* each tetrahedron's radius is between these */
static double *key;

/* ---- radii ---- */

static double coordinate(tess_int t, int i, int k)
{
    return (double)of->p[3 * (size_t)of->tet[4 * (size_t)t + (size_t)i] +
                         (size_t)k];
}

/* bounds - of all radii. */
static void bounds(void)
{
    double c[4], size;
    tess_int t;
    int k;

    low = (double *)space((double)of->ntet, sizeof *low);
    high = (double *)space((double)of->ntet, sizeof *high);
    for (t = 0; t < of->ntet; t++) {
        if (tess_ball(of->p, of->tet + 4 * (size_t)t, c) != 0)
            too_small("-alpha: the tetrahedra's balls cannot be computed");
        low[t] = high[t] = c[3];
        for (size = 2.0 * c[3], k = 0; k < 3; k++) size += fabs(c[k]);
        if (c[3] < DBL_MAX) low[t] -= DOUBT * size + 40.0 * DBL_MIN;
    }
}

/* square - of t's radius: top / bottom in units of 2^(2 bit).  0 where the
 * numbers are too long: of exponents hundreds apart. */
static int square(tess_int t, ex_num *top, ex_num *bottom, int *bit)
{
    static ex_num e[3][3], f[3][3], norm[3], sum, x, y;
    int i, k, most = 0;

    *bit = EX_NO_LOW;
    for (i = 0; i < 12; i++) *bit = ex_low(coordinate(t, i / 3, i % 3), *bit);
    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) {
            ex_real(&x, coordinate(t, i + 1, k), *bit);
            ex_real(&y, coordinate(t, 0, k), *bit);
            if (ex_bits(&x) > most) most = ex_bits(&x);
            if (ex_bits(&y) > most) most = ex_bits(&y);
            ex_sub(&e[i][k], &x, &y);
        }
    if (most > WIDEST) return 0;
    for (i = 0; i < 3; i++) {
        ex_dot(&norm[i], e[i], e[i]);
        ex_cross(f[i], e[(i + 1) % 3], e[(i + 2) % 3]);
    }
    ex_dot(&x, e[0], f[0]);
    ex_mul(bottom, &x, &x);
    ex_shift(bottom, 2);
    ex_int(top, 0L);
    for (k = 0; k < 3; k++) {
        ex_int(&sum, 0L);
        for (i = 0; i < 3; i++) {
            ex_mul(&x, &norm[i], &f[i][k]);
            ex_add(&sum, &sum, &x);
        }
        ex_mul(&x, &sum, &sum);
        ex_add(top, top, &x);
    }
    return 1;
}

/* alike - has x > 0 a unit that is not too far from that? */
static int alike(double x, int bit)
{
    int own = ex_low(x, EX_NO_LOW);

    return own < bit + WIDEST && bit < own + WIDEST;
}

/* exceeds - is that square larger than that of x? */
static int exceeds(const ex_num *top, const ex_num *bottom, int bit, double x)
{
    static ex_num a, b, c;
    int own = ex_low(x, EX_NO_LOW);

    ex_real(&a, x, own);
    ex_mul(&b, &a, &a);
    ex_mul(&a, &b, bottom);
    ex_copy(&c, top);
    if (own < bit)
        ex_shift(&c, 2 * (bit - own));
    else
        ex_shift(&a, 2 * (own - bit));
    return ex_cmp(&c, &a) > 0;
}

/* larger - is the radius of t larger than that?  (Where numbers are too long
 * its upper bound is.) */
static int larger(tess_int t, double radius)
{
    static ex_num top, bottom;
    int bit;

    if (high[t] <= radius) return 0;
    if (low[t] > radius || !(high[t] < DBL_MAX)) return 1;
    return !square(t, &top, &bottom, &bit) || !alike(radius, bit) ||
           exceeds(&top, &bottom, bit, radius);
}

/* least - number that the radius of t is not larger than. */
static double least(tess_int t)
{
    static ex_num top, bottom;
    double x;
    int bit, e, f;

    if (!(high[t] < DBL_MAX) || !square(t, &top, &bottom, &bit)) return high[t];
    x = (double)(ex_value(&top, &e) / ex_value(&bottom, &f));
    e -= f;
    if (e % 2) {
        x *= 2.0;
        e--;
    }
    x = ldexp(sqrt(x), e / 2 + bit);
    if (!(x > 0.0 && x <= DBL_MAX) || !alike(x, bit)) return high[t];
    /* (steps of one unit in the last place) */
    while (!exceeds(&top, &bottom, bit, x)) x -= 0.6 * DBL_EPSILON * x;
    while (exceeds(&top, &bottom, bit, x)) x += 0.6 * DBL_EPSILON * x;
    return x;
}

static int by_key(const void *a, const void *b)
{
    double x = key[*(const tess_int *)a], y = key[*(const tess_int *)b];

    return x < y ? -1 : x > y;
}

/* ---- one piece ---- */

/* root - of the piece that t is in. */
static tess_int root(tess_int *parent, tess_int t)
{
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
}

/* growth - the tetrahedra that are there already. */
typedef struct growth {
    const tess_int *tet, *adj;
    tess_int *parent; /* TESS_NONE: not yet there */
    tess_int pieces, lacking; /* of these so many points */
    char *lacks;
} growth;

/* put - one more; it may have been put. */
static void put(growth *g, tess_int t)
{
    tess_int u;
    int k;

    if (g->parent[t] != TESS_NONE) return;
    g->parent[t] = t;
    g->pieces++;
    for (k = 0; k < 4; k++) {
        u = g->tet[4 * t + k];
        g->lacking -= g->lacks[u];
        g->lacks[u] = 0;
        u = g->adj[4 * t + k];
        if (u < 0 || g->parent[u] == TESS_NONE) continue;
        u = root(g->parent, u);
        g->pieces -= u != root(g->parent, t);
        g->parent[u] = root(g->parent, t);
    }
}

/* lacking_without - so many points, if all of these were put. */
static tess_int lacking_without(growth *g, const tess_int *list, tess_int many)
{
    tess_int i, left = g->lacking, v;
    int k, pass;

    for (pass = 0; pass < 2; pass++)
        for (i = 0; i < many; i++)
            for (k = 0; k < 4; k++) {
                v = g->tet[4 * list[i] + k];
                if (!pass) left -= g->lacks[v] == 1;
                if (g->lacks[v]) g->lacks[v] = (char)(pass ? 1 : 2);
            }
    return left;
}

/* (They are put one after the other, as their radii are; those of which that is
 * in doubt, which overlap, by the least number that is not less than each: it
 * is all that matters, as the result is a number.) */
double least_alpha(const mesh *m)
{
    const repeated *again = chosen.periodic ? repetition() : 0;
    tess_int *order = (tess_int *)space((double)m->ntet, sizeof *order);
    tess_int i, j, t;
    double radius = DBL_MAX, end;
    growth g;

    of = m;
    bounds();
    g.tet = again ? again->tet : m->tet;
    g.adj = again ? again->adj : m->adj;
    g.parent = (tess_int *)space((double)m->ntet, sizeof *g.parent);
    g.lacks = (char *)space((double)m->in->n, 1);
    g.pieces = g.lacking = 0;
    for (i = 0; i < m->in->n; i++) g.lacks[i] = 0;
    for (i = 0; i < 4 * m->ntet; i++) {
        g.lacking += !g.lacks[g.tet[i]];
        g.lacks[g.tet[i]] = 1;
        order[i / 4] = i / 4;
        g.parent[i / 4] = TESS_NONE;
    }
    key = low;
    qsort(order, (size_t)m->ntet, sizeof *order, by_key);
    key = (double *)space((double)m->ntet, sizeof *key);
    for (i = 0; i < m->ntet && radius == DBL_MAX; i = j) {
        end = high[order[i]];
        for (j = i + 1; j < m->ntet && low[order[j]] <= end; j++)
            if (high[order[j]] > end) end = high[order[j]];
        if (lacking_without(&g, order + i, j - i) > 0) {
            for (t = i; t < j; t++) put(&g, order[t]);
            continue;
        }
        for (t = i; t < j && j - i > 1; t++) key[order[t]] = least(order[t]);
        if (j - i > 1)
            qsort(order + i, (size_t)(j - i), sizeof *order, by_key);
        for (t = i; t < j; t++) {
            put(&g, order[t]);
            if (g.lacking > 0 || g.pieces > 1 ||
                (t + 1 < j && by_key(order + t, order + t + 1) == 0))
                continue;
            radius = least(order[t]);
            break;
        }
    }
    free(order);
    free(g.parent);
    free(g.lacks);
    free(low);
    free(high);
    free(key);
    return radius;
}

/* ---- the surface ---- */

/* side - of a triangle of the surface: its ends, the lower number first, and
 * where these are among the triangles' corners. */
typedef struct side {
    tess_int end[2], corner[2];
} side;

static int by_ends(const void *a, const void *b)
{
    const side *x = (const side *)a, *y = (const side *)b;

    if (x->end[0] != y->end[0]) return x->end[0] < y->end[0] ? -1 : 1;
    if (x->end[1] != y->end[1]) return x->end[1] < y->end[1] ? -1 : 1;
    return 0;
}

/* next_corner - of the same triangle. */
static tess_int next_corner(tess_int f)
{
    return f % 3 == 2 ? f - 2 : f + 1;
}

/* take_sides - of many triangles. */
static void take_sides(side *s, tess_int many, const tess_int *fac)
{
    tess_int f, next;
    int first;

    for (f = 0; f < 3 * many; f++) {
        next = next_corner(f);
        first = fac[f] < fac[next];
        s[f].end[!first] = fac[f];
        s[f].end[first] = fac[next];
        s[f].corner[!first] = f;
        s[f].corner[first] = next;
    }
    qsort(s, 3 * (size_t)many, sizeof *s, by_ends);
}

/* check_manifold - of triangles between n points. */
static void check_manifold(tess_int n, tess_int many, const tess_int *fac)
{
    double corners = 3.0 * (double)many;
    side *s = (side *)space(corners, sizeof *s);
    tess_int *parent = (tess_int *)space(corners, sizeof *parent);
    tess_int *fans = (tess_int *)space((double)n, sizeof *fans);
    tess_int i, j, f, edges = 0, touch = 0;
    int k;

    take_sides(s, many, fac);
    for (f = 0; f < 3 * many; f++) parent[f] = f;
    for (i = 0; i < n; i++) fans[i] = 0;
    for (i = 0; i < 3 * many; i = j) {
        for (j = i; j < 3 * many && by_ends(s + i, s + j) == 0; j++)
            for (k = 0; k < 2; k++)
                parent[root(parent, s[j].corner[k])] =
                    root(parent, s[i].corner[k]);
        edges += j - i > 2;
    }
    for (f = 0; f < 3 * many; f++)
        if (root(parent, f) == f) touch += fans[fac[f]]++ == 1;
    free(s);
    free(parent);
    free(fans);
    if (edges > 0 || touch > 0)
        warn("-alpha: the surface is no manifold: more than two triangles meet "
             "at %ld edge%s, parts of it touch at %ld point%s; another radius "
             "may do",
             (long)edges, edges == 1 ? "" : "s", (long)touch,
             touch == 1 ? "" : "s");
}

static const points *read_in;

static int by_place(const void *a, const void *b)
{
    const tess_real *x = read_in->p + 3 * (size_t)*(const tess_int *)a;
    const tess_real *y = read_in->p + 3 * (size_t)*(const tess_int *)b;
    int k;

    for (k = 0; k < 3; k++)
        if (x[k] < y[k] || x[k] > y[k]) return x[k] < y[k] ? -1 : 1;
    return 0;
}

/* one_number - for points at the same place, of those that fac has. */
static void one_number(const points *in, tess_int many, tess_int *fac)
{
    tess_int *order = (tess_int *)space((double)in->n, sizeof *order);
    tess_int *same = (tess_int *)space((double)in->n, sizeof *same), i;

    read_in = in;
    for (i = 0; i < in->n; i++) order[i] = i;
    qsort(order, (size_t)in->n, sizeof *order, by_place);
    for (i = 0; i < in->n; i++)
        same[order[i]] = i > 0 && by_place(order + i - 1, order + i) == 0
                             ? same[order[i - 1]]
                             : order[i];
    for (i = 0; i < 3 * many; i++) fac[i] = same[fac[i]];
    free(order);
    free(same);
}

/* within - the volume between the triangles and a point, and the sum of its
 * parts' sizes. */
static double within(const points *in, tess_int many, const tess_int *fac,
                     double *size)
{
    const tess_real *o = in->p + 3 * (size_t)fac[0], *x;
    double e[3][3], c[3], part, sum = 0.0;
    tess_int f;
    int i, k;

    for (*size = 0.0, f = 0; f < many; f++) {
        for (i = 0; i < 3; i++) {
            x = in->p + 3 * (size_t)fac[3 * f + i];
            for (k = 0; k < 3; k++) e[i][k] = (double)x[k] - (double)o[k];
        }
        normal_to(e[1], e[2], c);
        part = (e[0][0] * c[0] + e[0][1] * c[1] + e[0][2] * c[2]) / 6.0;
        sum += part;
        *size += fabs(part);
    }
    return sum;
}

void tell_surface(const points *in)
{
    tess_int many = (tess_int)in->faces, open = 0, against = 0, flat = 0, i, j;
    tess_int *fac;
    double volume, size;
    long way;
    side *s;

    if (many == 0) return;
    fac = (tess_int *)space(3.0 * in->faces, sizeof *fac);
    for (i = 0; i < 3 * many; i++) fac[i] = in->face ? in->face[i] : i;
    one_number(in, many, fac);
    /* (without those that are an edge, or a point) */
    for (i = j = 0; i < 3 * many; i += 3) {
        if (fac[i] == fac[i + 1] || fac[i + 1] == fac[i + 2] ||
            fac[i + 2] == fac[i]) {
            flat++;
            continue;
        }
        fac[j++] = fac[i];
        fac[j++] = fac[i + 1];
        fac[j++] = fac[i + 2];
    }
    many -= flat;
    s = (side *)space(3.0 * (double)many + 1.0, sizeof *s);
    take_sides(s, many, fac);
    for (i = 0; i < 3 * many; i = j) {
        for (way = 0, j = i; j < 3 * many && by_ends(s + i, s + j) == 0; j++)
            /* (from the first end to the second, or back) */
            way += s[j].corner[1] == next_corner(s[j].corner[0]) ? 1 : -1;
        open += (j - i) % 2;
        against += (j - i) % 2 == 0 && way != 0;
    }
    tell("surface       %ld triangles", (long)many);
    if (flat > 0) tell(", without %ld that are no more than a line",
                       (long)flat);
    if (open > 0)
        tell("; not closed: %ld edge%s no neighbour there\n", (long)open,
             open == 1 ? " has" : "s have");
    else if (against > 0)
        tell("; closed, but at %ld edge%s they face different ways: no "
             "volume\n", (long)against, against == 1 ? "" : "s");
    else if (many > 0) {
        volume = within(in, many, fac, &size);
        tell("; closed; its volume is %.15g%s\n",
             fabs(volume) > 1e-14 * size ? fabs(volume) : 0.0,
             volume < 0.0 ? ", and its triangles face inwards" : "");
    } else
        tell("\n");
    free(fac);
    free(s);
}

/* ---- what is kept ---- */

char *alpha_shape(const mesh *m, double radius)
{
    char *keep = (char *)space((double)m->ntet, sizeof *keep);
    tess_int t;

    of = m;
    bounds();
    for (t = 0; t < m->ntet; t++) keep[t] = (char)!larger(t, radius);
    free(low);
    free(high);
    return keep;
}

/* warn_surface - where that of the shape is no manifold. */
static void warn_surface(const mesh *m)
{
    static const int facet[4][3] = {
        {1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    tess_int many = 0, t, u, *fac = 0;
    int pass, i, k;

    for (pass = 0; pass < 2; pass++) {
        if (pass) fac = (tess_int *)space(3.0 * (double)many, sizeof *fac);
        for (many = t = 0; t < m->ntet; t++)
            for (k = 0; k < 4 && m->keep[t]; k++) {
                u = m->adj[4 * t + k];
                if (u >= 0 && m->keep[u]) continue;
                for (i = 0; i < 3 && pass; i++)
                    fac[3 * many + i] = m->tet[4 * t + facet[k][i]];
                many++;
            }
    }
    check_manifold(m->in->n, many, fac);
    free(fac);
}

void mark_alpha(mesh *m, double radius)
{
    tess_int t;

    m->keep = alpha_shape(m, radius);
    for (m->kept = t = 0; t < m->ntet; t++) m->kept += m->keep[t];
    if (m->kept == 0 && m->ntet > 0)
        warn("-alpha: every tetrahedron has a larger circumradius than %g: "
             "nothing is left; take a larger one", radius);
    /* (of what repeats itself it ends where copies go on) */
    if (m->kept > 0 && !chosen.periodic) warn_surface(m);
}

void drop_others(mesh *m)
{
    tess_int *number = (tess_int *)space((double)m->ntet, sizeof *number);
    tess_int many = 0, t, u;
    int k;

    for (t = 0; t < m->ntet; t++) number[t] = m->keep[t] ? many++ : TESS_NONE;
    for (t = 0; t < m->ntet; t++) {
        if (!m->keep[t]) continue;
        for (k = 0; k < 4; k++) {
            u = m->adj[4 * t + k];
            m->tet[4 * number[t] + k] = m->tet[4 * t + k];
            m->adj[4 * number[t] + k] = u < 0 ? u : number[u];
        }
    }
    free(number);
    free(m->keep);
    m->ntet = many;
    m->keep = 0;
}
