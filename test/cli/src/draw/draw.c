/* draw.c - see draw.h.
 *
 * Painter's order.  Of two tetrahedra that share a facet, the one on the
 * viewer's side of it is painted later.  A line of sight passes through the
 * hull from one tetrahedron to a neighbour, so this orders any two of which
 * one hides a part of the other; and in a Delaunay tetrahedralization it has
 * no cycle, whatever the direction (Edelsbrunner, An acyclicity theorem for
 * cell complexes in d dimensions, 1990).  Parts of tetrahedra, shrunk or cut,
 * keep the order.
 */
#include "../driver.h"
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define CORNERS 16    /* a triangle, clipped by two planes and two values: 7 */
#define TINT 5        /* shades of each colour */
#define EXPLODED 0.72 /* size of a tetrahedron that is moved apart */

typedef struct polygon {
    int n;
    double at[CORNERS][DIM];
} polygon;

/* -------------------------------------------------------------- polygons */

/* clip - leave of a the part where the function f, linear on a and given at
 * its corners, is not negative. */
static void clip(polygon *a, const double *f)
{
    polygon old = *a;
    int i, j, k;
    double s;

    a->n = 0;
    for (i = 0; i < old.n; i++) {
        j = (i + 1) % old.n;
        if (f[i] >= 0.0) {
            for (k = 0; k < DIM; k++) a->at[a->n][k] = old.at[i][k];
            a->n++;
        }
        if ((f[i] < 0.0) == (f[j] < 0.0)) continue;
        s = f[i] / (f[i] - f[j]);
        for (k = 0; k < DIM; k++)
            a->at[a->n][k] =
                old.at[i][k] + s * (old.at[j][k] - old.at[i][k]);
        a->n++;
    }
}

static double dot(const double *a, const double *b)
{
    return a[X] * b[X] + a[Y] * b[Y] + a[Z] * b[Z];
}

/* clip_plane - leave the part where sign * plane >= 0. */
static void clip_plane(polygon *a, const double *plane, double sign)
{
    double f[CORNERS];
    int i;

    for (i = 0; i < a->n; i++) f[i] = sign * dot(plane, a->at[i]);
    clip(a, f);
}

/* clip_value - leave the part where the value is at least that. */
static void clip_value(polygon *a, double least)
{
    double f[CORNERS];
    int i;

    for (i = 0; i < a->n; i++) f[i] = a->at[i][V] - least;
    clip(a, f);
}

/* section - the polygon in which the plane meets the tetrahedron v. */
static void section(const double v[4][DIM], const double *plane, polygon *a)
{
    double f[4], s;
    int order[4], low = 0, high = 3, i, j, k, m;

    for (i = 0; i < 4; i++) {
        f[i] = dot(plane, v[i]);
        order[f[i] < 0.0 ? low++ : high--] = i;
    }
    /* low corners are below; go round the edges that lead from below to
     * above */
    a->n = 0;
    for (m = 0; m < low * (4 - low); m++) {
        i = order[low == 2 ? m / 2 : low == 1 ? 0 : m];
        j = order[low == 2 ? 2 + (m == 1 || m == 2) : low == 1 ? m + 1 : 3];
        s = f[i] / (f[i] - f[j]);
        for (k = 0; k < DIM; k++)
            a->at[a->n][k] = v[i][k] + s * (v[j][k] - v[i][k]);
        a->n++;
    }
}

/* -------------------------------------------------------------- painting */

/* mark - a corner of an outline. */
static void mark(drawing *d, const double *at)
{
    page_corner(d, page_across(d, at[X]), page_down(d, at[Y]));
}

static void outline(drawing *d, const polygon *a)
{
    int i;

    for (i = 0; i < a->n; i++) mark(d, a->at[i]);
    page_close(d);
}

/* style - begin a path of a style, unless the last one has it too: letter A
 * for a facet of shade 0, a for a part of one without its edges, and so on; z
 * for edges alone; 0 to end the last path. */
static void style(drawing *d, int letter, int band)
{
    if (letter == d->letter && band == d->band) return;
    if (d->letter != 0) fprintf(d->file, "\"/>\n");
    if (letter != 0)
        fprintf(d->file, "<path class=\"%c%d\" d=\"", letter, band);
    d->letter = letter;
    d->band = band;
}

/* facing - twice the area of the triangle as the viewer sees it: positive when
 * its corners go round counter-clockwise. */
static double facing(const double *a, const double *b, const double *c)
{
    return (b[X] - a[X]) * (c[Y] - a[Y]) - (c[X] - a[X]) * (b[Y] - a[Y]);
}

/* area - of the polygon as the viewer sees it, in the units of q. */
static double area(const polygon *a)
{
    double sum = 0.0;
    int i;

    for (i = 2; i < a->n; i++)
        sum += facing(a->at[0], a->at[i - 1], a->at[i]) / 2.0;
    return fabs(sum);
}

/* band_of - the number of the value's band. */
static int band_of(const drawing *d, double value)
{
    double k;

    if (value != value) return d->bands;
    k = (value - d->low) / d->step;
    return k < 0.0 ? 0 : k < d->bands ? (int)k : d->bands - 1;
}

/* paint - the polygon and its edges.  Each band is painted with all above it,
 * which then cover it: no gaps show, and what is too small to be seen can be
 * left out. */
static void paint(drawing *d, const polygon *a, int tint)
{
    double least, most, sum, speck = 80.0 / (d->unit * d->unit);
    polygon part;
    int edges = d->look->what != DRAW_FIELD, i, k, from, to;

    if (a->n < 3) return;
    least = most = sum = a->at[0][V];
    for (i = 1; i < a->n; i++) {
        sum += a->at[i][V];
        if (a->at[i][V] < least) least = a->at[i][V];
        if (a->at[i][V] > most) most = a->at[i][V];
    }
    from = band_of(d, sum == sum ? least : sum);
    to = band_of(d, sum == sum ? most : sum);
    for (k = from; k <= to; k++) {
        part = *a;
        if (k > from) clip_value(&part, d->low + k * d->step);
        if (k > from && area(&part) < speck) break;
        style(d, (from == to && edges ? "ABCDE" : "abcde")[tint], k);
        outline(d, &part);
    }
    if (from == to || !edges || area(a) < speck) return;
    style(d, 'z', 0);
    outline(d, a);
}

/* lit - the shade of a triangle, 0 ... TINT - 1. */
static int lit(const drawing *d, const polygon *a)
{
    static const double light[3] = {-0.36, 0.66, 0.66};
    double u[3], v[3], normal[3], size, cosine;
    int k;

    for (k = 0; k < 3; k++) {
        u[k] = a->at[1][k] - a->at[0][k];
        v[k] = a->at[2][k] - a->at[0][k];
    }
    normal_to(u, v, normal);
    size = sqrt(dot(normal, normal));
    cosine = size > 0.0 ? d->hand * dot(normal, light) / size : 0.0;
    return cosine <= 0.0 ? 0 : (int)(cosine * (TINT - 1) + 0.5);
}

/* corners - the vertices of t, shrunk towards its centroid. */
static void corners(const drawing *d, tess_int t, double v[4][DIM])
{
    double middle[DIM];
    int i, k;

    for (k = 0; k < DIM; k++) {
        middle[k] = 0.0;
        for (i = 0; i < 4; i++) {
            v[i][k] = d->q[DIM * d->tet[4 * t + i] + k];
            middle[k] += v[i][k] / 4.0;
        }
    }
    for (i = 0; i < 4 && d->look->what == DRAW_APART; i++)
        for (k = 0; k < DIM; k++)
            v[i][k] = middle[k] + EXPLODED * (v[i][k] - middle[k]);
    if (d->plain && d->look->what == DRAW_APART)
        for (i = 0; i < 4; i++) v[i][V] = sqrt(dot(middle, middle));
}

int draw_kept(const drawing *d, tess_int t)
{
    return t >= 0 && (!d->keep || d->keep[t]);
}

/* The facet opposite to vertex k, counter-clockwise from outside. */
const int draw_facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/* tetrahedron - paint what can be seen of t.  The cut leaves two pieces of a
 * tetrahedron: the one behind the first plane; then, as it is nearer, the one
 * between it and the second plane. */
static void tetrahedron(drawing *d, tess_int t)
{
    double v[4][DIM];
    polygon a;
    int cut = d->look->what == DRAW_CUT || d->look->what == DRAW_FIELD;
    int piece, i, j, k, tint;

    corners(d, t, v);
    for (piece = 0; piece <= cut; piece++) {
        for (k = 0; k < 4; k++) {
            if (d->look->what != DRAW_APART && draw_kept(d, d->adj[4 * t + k]))
                continue;
            a.n = 3;
            for (i = 0; i < 3; i++)
                for (j = 0; j < DIM; j++) a.at[i][j] = v[draw_facet[k][i]][j];
            if (d->hand * facing(a.at[0], a.at[1], a.at[2]) <= 0.0) continue;
            tint = lit(d, &a);
            if (cut)
                clip_plane(&a, d->plane[0], piece == 0 ? -1.0 : 1.0);
            if (piece == 1) clip_plane(&a, d->plane[1], -1.0);
            paint(d, &a, tint);
        }
        if (cut) {
            section((const double(*)[DIM])v, d->plane[piece], &a);
            clip_plane(&a, d->plane[1 - piece], 1.0);
            paint(d, &a, TINT - 1);
        }
    }
}

/* nearer - is the neighbour across facet k of t on the viewer's side of it?
 * 1 yes, -1 no, 0 when the facet is seen edge-on.  Both sides of a facet give
 * opposite answers: it is computed from the same corners in the same order. */
static int nearer(const drawing *d, tess_int t, int k)
{
    tess_int v[3], swap;
    double seen, sign = d->hand;
    int i, j;

    for (i = 0; i < 3; i++) v[i] = d->tet[4 * t + draw_facet[k][i]];
    for (i = 0; i < 2; i++)
        for (j = 0; j < 2 - i; j++)
            if (v[j] > v[j + 1]) {
                swap = v[j];
                v[j] = v[j + 1];
                v[j + 1] = swap;
                sign = -sign;
            }
    seen = sign * facing(d->q + DIM * v[0], d->q + DIM * v[1],
                         d->q + DIM * v[2]);
    return seen > 1e-14 ? 1 : seen < -1e-14 ? -1 : 0;
}

/* back_to_front - fill order.  behind[t] counts the neighbours that are to be
 * painted before t and are not yet in it. */
static void back_to_front(const drawing *d, char *behind, tess_int *order)
{
    tess_int filled = 0, taken = 0, next = 0, t, u;
    int k;

    for (t = 0; t < d->ntet; t++) {
        behind[t] = 0;
        for (k = 0; k < 4; k++)
            if (d->adj[4 * t + k] >= 0 && nearer(d, t, k) < 0) behind[t]++;
        if (behind[t] == 0) order[filled++] = t;
    }
    while (taken < d->ntet) {
        /* rounding might make a cycle of facets seen nearly edge-on */
        if (taken == filled) {
            while (behind[next] <= 0) next++;
            behind[next] = 0;
            order[filled++] = next;
        }
        t = order[taken++];
        for (k = 0; k < 4; k++) {
            u = d->adj[4 * t + k];
            if (u >= 0 && nearer(d, t, k) > 0 && behind[u] > 0)
                if (--behind[u] == 0) order[filled++] = u;
        }
    }
}

/* ----------------------------------------------------------- the picture */

/* see - where a point of these coordinates, divided by d->most, is in q. */
static void see(const drawing *d, const double *x, double *at)
{
    double y[3];
    int j, k;

    for (k = 0; k < 3; k++) y[k] = (x[k] - d->middle[k]) * d->factor[k];
    for (j = 0; j < 3; j++)
        at[j] = d->turn[j][0] * y[0] + d->turn[j][1] * y[1] +
                d->turn[j][2] * y[2];
}

/* project - fill q: the bounding box's centre becomes the origin, its longest
 * side 1. */
static void project(drawing *d, const tess_real *p, const double *value)
{
    double a = d->look->azimuth * DEGREE, e = d->look->elevation * DEGREE;
    double lo, hi, x[3], size = 0.0;
    const double *scale = d->look->scale;
    tess_int i;
    int j, k;

    d->turn[X][0] = -sin(a);
    d->turn[X][1] = cos(a);
    d->turn[X][2] = 0.0;
    d->turn[Y][0] = -sin(e) * cos(a);
    d->turn[Y][1] = -sin(e) * sin(a);
    d->turn[Y][2] = cos(e);
    d->turn[Z][0] = cos(e) * cos(a);
    d->turn[Z][1] = cos(e) * sin(a);
    d->turn[Z][2] = sin(e);
    d->most = 0.0;
    d->lost = 0;
    for (i = 0; i < 3 * d->n; i++)
        if (fabs((double)p[i]) > d->most) d->most = fabs((double)p[i]);
    if (d->most == 0.0) d->most = 1.0;
    for (k = 0; k < 3; k++) {
        lo = 1.0;
        hi = -1.0;
        for (i = 0; i < d->n; i++) {
            x[k] = (double)p[3 * i + k] / d->most;
            if (x[k] < lo) lo = x[k];
            if (x[k] > hi) hi = x[k];
        }
        d->middle[k] = lo / 2.0 + hi / 2.0;
        d->side[k] = hi - lo;
        if (d->side[k] * fabs(scale[k]) > size)
            size = d->side[k] * fabs(scale[k]);
    }
    d->hand = 1.0;
    for (k = 0; k < 3; k++) {
        d->factor[k] = size > 0.0 ? scale[k] / size : scale[k];
        if (scale[k] < 0.0) d->hand = -d->hand;
    }
    for (i = 0; i < d->n; i++) {
        for (k = 0; k < 3; k++) x[k] = (double)p[3 * i + k] / d->most;
        see(d, x, d->q + DIM * i);
        d->q[DIM * i + V] = value ? value[i] : 0.0;
        d->lost |= value && value[i] != value[i];
    }
    for (j = 0; j < 2; j++) {
        d->plane[j][X] = (j == 0 ? 1.0 : -1.0) * sin(45.0 * DEGREE);
        d->plane[j][Y] = -sin(e) * cos(45.0 * DEGREE);
        d->plane[j][Z] = cos(e) * cos(45.0 * DEGREE);
    }
}

/* --------------------------------------------------------- tetrahedra */

/* larger - make the range hold a corner. */
static void larger(const double *v, double *lo, double *hi, int dimensions)
{
    int k;

    for (k = 0; k < dimensions; k++) {
        if (v[k] < lo[k]) lo[k] = v[k];
        if (v[k] > hi[k]) hi[k] = v[k];
    }
}

/* ends - of the box's edge along axis k that has an axis, in q: of those below
 * the drawing the one nearer to the viewer; for z the one on the left. */
static void ends(const drawing *d, int k, double end[2][DIM])
{
    double x[3], at[2][DIM], best = 0.0, much;
    int corner, j, m, found = 0;

    for (corner = 0; corner < 8; corner++) {
        if (corner >> k & 1) continue;
        for (m = 0; m < 2; m++) {
            for (j = 0; j < 3; j++)
                x[j] = d->middle[j] +
                       d->side[j] * ((corner >> j & 1) - 0.5 + (j == k) * m);
            see(d, x, at[m]);
        }
        much = k == 2 ? -at[0][X] - at[1][X] : -at[0][Y] - at[1][Y];
        if (found++ && much <= best + 1e-9) continue;
        best = much;
        memcpy(end[0], at[0], sizeof at);
    }
}

/* scale - choose the bands, and the unit and place of what is drawn. */
static void scale(drawing *d)
{
    double lo[DIM], hi[DIM], v[4][DIM];
    tess_int t;
    int i, k;

    for (k = 0; k < DIM; k++) {
        lo[k] = 1e300;
        hi[k] = -1e300;
    }
    if (d->look->what == DRAW_POINTS)
        for (t = 0; t < d->n; t++) larger(d->q + DIM * t, lo, hi, DIM);
    else
        for (t = 0; t < d->ntet; t++) {
            if (!draw_kept(d, t)) continue;
            corners(d, t, v);
            for (i = 0; i < 4; i++) larger(v[i], lo, hi, DIM);
        }
    if (lo[V] > hi[V]) lo[V] = hi[V] = 0.0;
    page_bands(d, lo[V], hi[V]);
    for (k = 0; k < 3 && !d->look->bare; k++) {
        ends(d, k, v);
        for (i = 0; i < 2; i++) larger(v[i], lo, hi, 2);
    }
    page_place(d, hi[X] - lo[X], hi[Y] - lo[Y]);
    d->left = lo[X];
    d->top = hi[Y];
}

/* axes - along three edges of the box. */
static void axes(const drawing *d)
{
    double end[2][DIM], at[2][2], out[2], length, low, high;
    int k, m;

    if (d->look->bare) return;
    page_axes(d);
    for (k = 0; k < 3; k++) {
        ends(d, k, end);
        for (m = 0; m < 2; m++) {
            at[m][0] = page_across(d, end[m][X]);
            at[m][1] = page_down(d, end[m][Y]);
        }
        /* away from the middle of the box, which is at 0, 0 */
        out[0] = at[1][1] - at[0][1];
        out[1] = at[0][0] - at[1][0];
        length = sqrt(out[0] * out[0] + out[1] * out[1]);
        if (length < 1.0) continue;
        if (out[0] * (at[0][0] - page_across(d, 0.0)) +
                out[1] * (at[0][1] - page_down(d, 0.0)) < 0.0)
            length = -length;
        for (m = 0; m < 2; m++) out[m] /= length;
        low = d->most * (d->middle[k] - d->side[k] / 2.0);
        high = d->most * (d->middle[k] + d->side[k] / 2.0);
        page_axis(d, at[0], at[1], low, high, out, d->look->name[k]);
    }
    fprintf(d->file, "</g>\n");
}

/* styles - a class for each colour and shade, and a second one with edges: to
 * be seen they are lighter than what is dark. */
static void styles(const drawing *d)
{
    double dark = d->plain ? 0.42 : 0.76, x, shade;
    int apart = d->look->what == DRAW_APART, k, tint;

    fprintf(d->file,
            "<style>.z0{fill:none;stroke:#000;stroke-opacity:.35}\n");
    for (k = 0; k < d->bands + d->lost; k++)
        for (tint = 0; tint < TINT; tint++) {
            x = page_share(d, k);
            shade = dark + (1.0 - dark) * tint / (TINT - 1.0);
            fprintf(d->file, ".%c%d,.%c%d{fill:", 'A' + tint, k, 'a' + tint,
                    k);
            page_hex(d->file, x, shade);
            fprintf(d->file, ";stroke:");
            page_hex(d->file, x, shade);
            fprintf(d->file, "}.%c%d{stroke:", 'A' + tint, k);
            page_hex(d->file, x, shade * (apart ? 0.2 : 0.3));
            fprintf(d->file, "}%s", tint == TINT - 1 ? "\n" : "");
        }
    fprintf(d->file, "</style>\n");
}

/* by_depth - for qsort: what is farther from the viewer comes first. */
static int by_depth(const void *a, const void *b)
{
    const double *p = *(const double *const *)a, *q = *(const double *const *)b;

    return p[Z] < q[Z] ? -1 : p[Z] > q[Z];
}

/* dots - the points, those that are farther away darker; sorted is room for n
 * pointers. */
static void dots(drawing *d, const double **sorted)
{
    double range;
    tess_int i;

    for (i = 0; i < d->n; i++) sorted[i] = d->q + DIM * i;
    qsort(sorted, (size_t)d->n, sizeof *sorted, by_depth);
    range = sorted[d->n - 1][Z] - sorted[0][Z];
    for (i = 0; i < d->n; i++) {
        style(d, 'a' + (int)((TINT - 0.01) * (range > 0.0
                  ? (sorted[i][Z] - sorted[0][Z]) / range : 1.0)),
              band_of(d, sorted[i][V]));
        mark(d, sorted[i]);
        page_close(d);
    }
}

int draw_svg(FILE *file, const draw_look *look, tess_int n,
             const tess_real *p, const double *value, tess_int ntet,
             const tess_int *tet, const tess_int *adj, const char *keep)
{
    drawing d;
    tess_int *order = (tess_int *)malloc(((size_t)ntet + 1) * sizeof *order);
    char *behind = (char *)malloc((size_t)ntet + 1);
    const double **sorted =
        (const double **)malloc(((size_t)n + 1) * sizeof *sorted);
    double thick = look->what == DRAW_APART ? 8.0 : 6.0;
    tess_int i;
    int bad;

    page_begin(&d, file, look, ntet, tet, adj, keep);
    d.q = (double *)malloc(((size_t)n + 1) * DIM * sizeof *d.q);
    d.n = n;
    d.plain = !value;
    bad = !order || !behind || !d.q || !sorted;
    if (!bad) {
        project(&d, p, value);
        scale(&d);
        page_head(&d);
        styles(&d);
        axes(&d);
        if (look->what == DRAW_POINTS) {
            thick = 4.0 * sqrt((double)look->width * d.height /
                                (double)n);
            thick = thick < 20.0 ? 20.0 : thick > 90.0 ? 90.0 : thick;
        }
        fprintf(file, "<g stroke-width=\"%.0f\" stroke-linejoin=\"round\" "
                "stroke-linecap=\"round\">\n", thick);
        back_to_front(&d, behind, order);
        for (i = 0; i < ntet && look->what != DRAW_POINTS; i++)
            if (draw_kept(&d, order[i])) tetrahedron(&d, order[i]);
        if (look->what == DRAW_POINTS) dots(&d, sorted);
        style(&d, 0, 0);
        fprintf(file, "</g>\n");
        page_end(&d);
    }
    free(order);
    free(behind);
    free((void *)sorted);
    free(d.q);
    return bad;
}
