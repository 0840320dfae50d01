/* slice.c - draw_slice: see draw.h. */
#include "../driver.h"
#include "page.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* plane - a plane grid. */
typedef struct plane {
    const int *axis, *many;
    const double *box, *value;
    double side[2]; /* as they are drawn; below 0: backwards */
} plane;

/* spot - where in the picture place i along axis k of the grid is. */
static double spot(const drawing *d, const plane *g, int k, double i)
{
    double s = i / (g->many[k] - 1.0);

    if (g->side[k] < 0.0) s = 1.0 - s;
    s *= fabs(g->side[k]);
    return k == 0 ? page_across(d, s) : page_down(d, s);
}

/* high - is place i, j there, and its value at least that? */
static int high(const plane *g, int i, int j, double least)
{
    return i >= 0 && j >= 0 && i < g->many[0] && j < g->many[1] &&
           g->value[(long)j * g->many[0] + i] >= least &&
           g->value[(long)j * g->many[0] + i] <= 1e300;
}

/* The corners of a square of places, and its sides: from corner k to k + 1. */
static const int step[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/* crossing - where side k of the square at i, j meets the contour: as far from
 * its high end as the values say; there, if the other end has none. */
static void crossing(drawing *d, const plane *g, int i, int j, int k,
                     double least)
{
    const int *a = step[k], *b = step[(k + 1) % 4];
    double s = 0.0, x = 0.0, y;

    if (!high(g, i + a[0], j + a[1], least)) {
        a = b;
        b = step[k];
    }
    if (high(g, i + b[0], j + b[1], -1e300)) {
        x = g->value[(long)(j + a[1]) * g->many[0] + i + a[0]];
        y = g->value[(long)(j + b[1]) * g->many[0] + i + b[0]];
        s = (x - least) / (x - y);
    }
    page_corner(d, spot(d, g, 0, i + a[0] + s * (b[0] - a[0])),
           spot(d, g, 1, j + a[1] + s * (b[1] - a[1])));
}

/* turn - the side by which a contour leaves the square at i, j, with what is
 * high to its left, that enters it by side k.  Where two corners across are
 * high, the mean of all tells whether they are joined. */
static int turn(const plane *g, int i, int j, int k, double least)
{
    int at[4], m;
    double sum = 0.0;

    for (m = 0; m < 4; m++) {
        at[m] = high(g, i + step[m][0], j + step[m][1], least);
        if (high(g, i + step[m][0], j + step[m][1], -1e300))
            sum += g->value[(long)(j + step[m][1]) * g->many[0] + i +
                            step[m][0]] - least;
        else
            sum = -1e300;
    }
    if (at[k] && !at[(k + 1) % 4] && at[(k + 2) % 4] && !at[(k + 3) % 4])
        return (k + (sum >= 0.0 ? 1 : 3)) % 4;
    for (m = k + 1; at[m % 4] || !at[(m + 1) % 4]; m++) continue;
    return m % 4;
}

/* contours - round what has at least that value, as one path.  seen has a byte
 * for each square, also of those that are half outside the grid. */
static void contours(drawing *d, const plane *g, double least, char *seen)
{
    long wide = g->many[0] + 1L;
    char *at;
    int i, j, k, m, x, y;

    memset(seen, 0, (size_t)(wide * (g->many[1] + 1L)));
    for (j = -1; j < g->many[1]; j++)
        for (i = -1; i < g->many[0]; i++)
            for (k = 0; k < 4; k++) {
                x = i;
                y = j;
                m = k;
                while (!(seen[(y + 1) * wide + x + 1] >> m & 1) &&
                       high(g, x + step[m][0], y + step[m][1], least) &&
                       !high(g, x + step[(m + 1) % 4][0],
                             y + step[(m + 1) % 4][1], least)) {
                    at = seen + (y + 1) * wide + x + 1;
                    *at = (char)(*at | 1 << m);
                    crossing(d, g, x, y, m, least);
                    m = turn(g, x, y, m, least);
                    x += (m == 1) - (m == 3);
                    y += (m == 2) - (m == 0);
                    m = (m + 2) % 4;
                }
                page_close(d);
            }
}

/* cross - where the plane meets the edge from u to v, in the picture: the same
 * for both tetrahedra at each side of it. */
static void cross(const drawing *d, const plane *g, const tess_real *p,
                  tess_int u, tess_int v, double *at)
{
    const tess_real *a = p + 3 * (u < v ? u : v), *b = p + 3 * (u < v ? v : u);
    double s, t, x, low;
    int k, m = g->axis[2];

    s = (double)a[m] - g->box[2 * m];
    t = (double)b[m] - g->box[2 * m];
    s /= s - t;
    for (k = 0; k < 2; k++) {
        m = g->axis[k];
        low = g->box[2 * m];
        x = (double)a[m] + s * ((double)b[m] - (double)a[m]);
        at[k] = spot(d, g, k, (g->many[k] - 1) * (x - low) /
                                  (g->box[2 * m + 1] - low));
    }
}

/* clip_to - draw only inside of the tetrahedra.  What is left of their boundary
 * in the plane are lines.  Between each and the lower edge of the picture is an
 * area, gone round one way or the other; and these areas cancel but where there
 * are tetrahedra. */
static void clip_to(drawing *d, const plane *g, const tess_real *p)
{
    double at[2][2], edge = 10.0 * d->height, x[3];
    tess_int t, v[3];
    int i, k;

    fprintf(d->file, "<mask id=\"inside\"><path fill=\"#fff\" d=\"");
    for (t = 0; t < d->ntet; t++)
        for (k = 0; k < 4; k++) {
            if (!draw_kept(d, t) || draw_kept(d, d->adj[4 * t + k])) continue;
            for (i = 0; i < 3; i++) {
                v[i] = d->tet[4 * t + draw_facet[k][i]];
                x[i] = (double)p[3 * v[i] + g->axis[2]] -
                       g->box[2 * g->axis[2]];
            }
            if ((x[0] < 0.0) == (x[1] < 0.0) && (x[1] < 0.0) == (x[2] < 0.0))
                continue;
            for (i = 0; i < 3; i++)
                if ((x[i] < 0.0) != (x[(i + 1) % 3] < 0.0))
                    cross(d, g, p, v[i], v[(i + 1) % 3], at[x[i] < 0.0]);
            if (floor(at[0][0] + 0.5) == floor(at[1][0] + 0.5)) continue;
            page_corner(d, at[0][0], edge);
            page_corner(d, at[0][0], at[0][1]);
            page_corner(d, at[1][0], at[1][1]);
            page_corner(d, at[1][0], edge);
            page_close(d);
        }
    fprintf(d->file, "\"/></mask>\n");
}

int draw_slice(FILE *file, const draw_look *look, const int *axis,
               const int *many, const double *box, const double *value,
               const double *range, const tess_real *p, tess_int ntet,
               const tess_int *tet, const tess_int *adj, const char *keep)
{
    static const double out[2][2] = {{0.0, 1.0}, {-1.0, 0.0}};
    char *seen = (char *)malloc(((size_t)many[0] + 1) * ((size_t)many[1] + 1));
    int any = range[0] <= range[1], band, k, m;
    double end[2][2];
    drawing d;
    plane g;

    if (!seen) return 1;
    page_begin(&d, file, look, ntet, tet, adj, keep);
    d.plain = !any;
    g.axis = axis;
    g.many = many;
    g.box = box;
    g.value = value;
    for (k = 0; k < 2; k++)
        g.side[k] = (box[2 * axis[k] + 1] - box[2 * axis[k]]) *
                    look->scale[axis[k]];
    d.top = fabs(g.side[1]);
    page_bands(&d, any ? range[0] : 0.0, any ? range[1] : 0.0);
    page_place(&d, fabs(g.side[0]), d.top);
    page_head(&d);
    if (ntet > 0) clip_to(&d, &g, p);
    fprintf(file, ntet > 0 ? "<g mask=\"url(#inside)\">\n" : "<g>\n");
    /* a path for each band: where it or a higher one is, lest gaps show */
    for (band = 0; band < d.bands && any; band++) {
        fprintf(file, "<path fill=\"");
        page_hex(file, page_share(&d, band), 1.0);
        fprintf(file, "\" d=\"");
        contours(&d, &g, band > 0 ? d.low + band * d.step : -1e300, seen);
        fprintf(file, "\"/>\n");
    }
    fprintf(file, "</g>\n");
    if (!look->bare) {
        page_axes(&d);
        for (k = 0; k < 2; k++) {
            for (m = 0; m < 2; m++) {
                end[m][0] = spot(&d, &g, 0, k == 0 ? m * (many[0] - 1.0)
                                 : g.side[0] < 0.0 ? many[0] - 1.0 : 0.0);
                end[m][1] = spot(&d, &g, 1, k == 1 ? m * (many[1] - 1.0)
                                 : g.side[1] < 0.0 ? many[1] - 1.0 : 0.0);
            }
            page_axis(&d, end[0], end[1], box[2 * axis[k]],
                      box[2 * axis[k] + 1], out[k], look->name[axis[k]]);
        }
        fprintf(file, "</g>\n");
    }
    page_end(&d);
    free(seen);
    return 0;
}
