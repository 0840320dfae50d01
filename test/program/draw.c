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
#include "draw.h"

#include <math.h>
#include <stdlib.h>

#define DEGREE 0.017453292519943295
#define CORNERS 16 /* a triangle, clipped by two planes and two values: 7 */
#define TINT 5     /* shades of each colour */

/* A corner of a polygon: x to the right, y up, z to the viewer, value. */
enum { X, Y, Z, V, DIM };

typedef struct polygon {
    int n;
    double at[CORNERS][DIM];
} polygon;

typedef struct drawing {
    FILE *file;
    const draw_look *look;
    double *q;            /* DIM a point: what a corner has */
    const tess_int *tet, *adj;
    tess_int ntet;
    int plain;            /* no values */
    double left, top;     /* of what is drawn, in the units of q */
    double unit;          /* tenths of a pixel a unit of q */
    double shift[2];      /* tenths of a pixel */
    double low, step;     /* band k: low + k * step ... */
    int bands;
    int letter, band;     /* style of the path that is being written */
    double plane[2][DIM]; /* the cut leaves out where both are positive */
} drawing;

/* ---------------------------------------------------------------- colour */

/* channel - a linear part of a colour as 0 ... 255. */
static int channel(double x)
{
    double y = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;

    return y <= 0.0 ? 0 : y >= 1.0 ? 255 : (int)(255.0 * y + 0.5);
}

/* colour - number x, 0 ... 1, of a scale from cold violet to warm yellow:
 * even steps of lightness and hue in the perceptual space Oklab, so that equal
 * differences look equal, in grey and to the colour-blind too. */
static void colour(double x, double shade, int *rgb)
{
    double l = 0.36 + 0.56 * x, hue = (282.0 + 180.0 * x) * DEGREE;
    double chroma = 0.145 + 0.06 * sin(180.0 * x * DEGREE);
    double a = chroma * cos(hue), b = chroma * sin(hue), r, g, s;

    r = l + 0.3963377774 * a + 0.2158037573 * b;
    g = l - 0.1055613458 * a - 0.0638541728 * b;
    s = l - 0.0894841775 * a - 1.2914855480 * b;
    r = shade * r * r * r;
    g = shade * g * g * g;
    s = shade * s * s * s;
    rgb[0] = channel(4.0767416621 * r - 3.3077115913 * g + 0.2309699292 * s);
    rgb[1] = channel(-1.2684380046 * r + 2.6097574011 * g - 0.3413193965 * s);
    rgb[2] = channel(-0.0041960863 * r - 0.7034186147 * g + 1.7076147010 * s);
}

/* nice - 1, 2 or 5 times a power of ten, not less than x > 0. */
static double nice(double x)
{
    double ten = pow(10.0, floor(log10(x) + 1e-9)), y = x / ten - 1e-6;

    return y <= 1.0 ? ten : y <= 2.0 ? 2.0 * ten : y <= 5.0 ? 5.0 * ten
                                                            : 10.0 * ten;
}

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

/* outline - the polygon as SVG path data: whole tenths of pixels, the first
 * corner absolute, the others relative to the one before.  Corners that fall
 * together are left out. */
static void outline(const drawing *d, const polygon *a)
{
    long x, y, lastx = 0, lasty = 0;
    int i, n = 0;

    for (i = 0; i < a->n; i++) {
        x = (long)floor(d->shift[0] + d->unit * (a->at[i][X] - d->left) + 0.5);
        y = (long)floor(d->shift[1] + d->unit * (d->top - a->at[i][Y]) + 0.5);
        if (n > 0 && x == lastx && y == lasty) continue;
        if (n == 0)
            fprintf(d->file, "M%ld %ldl", x, y);
        else
            fprintf(d->file, n > 1 && x >= lastx ? " %ld%s%ld" : "%ld%s%ld",
                    x - lastx, y >= lasty ? " " : "", y - lasty);
        lastx = x;
        lasty = y;
        n++;
    }
    fprintf(d->file, n > 1 ? "z" : "0 0z");
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

/* paint - the polygon and its edges.  Each band is painted with all above it,
 * which then cover it: no gaps show, and what is too small to be seen can be
 * left out. */
static void paint(drawing *d, const polygon *a, int tint)
{
    double least, most, speck = 80.0 / (d->unit * d->unit);
    polygon part;
    int i, k, from, to;

    if (a->n < 3) return;
    least = most = a->at[0][V];
    for (i = 1; i < a->n; i++) {
        if (a->at[i][V] < least) least = a->at[i][V];
        if (a->at[i][V] > most) most = a->at[i][V];
    }
    from = (int)((least - d->low) / d->step);
    to = (int)((most - d->low) / d->step);
    if (from < 0) from = 0;
    if (to > d->bands - 1) to = d->bands - 1;
    if (from > to) from = to;
    for (k = from; k <= to; k++) {
        part = *a;
        if (k > from) clip_value(&part, d->low + k * d->step);
        if (k > from && area(&part) < speck) break;
        style(d, (from == to ? "ABCDE" : "abcde")[tint], k);
        outline(d, &part);
    }
    if (from == to || area(a) < speck) return;
    style(d, 'z', 0);
    outline(d, a);
}

/* lit - the shade of a triangle, 0 ... TINT - 1. */
static int lit(const polygon *a)
{
    static const double light[3] = {-0.36, 0.66, 0.66};
    double u[3], v[3], normal[3], size, cosine;
    int k;

    for (k = 0; k < 3; k++) {
        u[k] = a->at[1][k] - a->at[0][k];
        v[k] = a->at[2][k] - a->at[0][k];
    }
    for (k = 0; k < 3; k++)
        normal[k] = u[(k + 1) % 3] * v[(k + 2) % 3] -
                    u[(k + 2) % 3] * v[(k + 1) % 3];
    size = sqrt(dot(normal, normal));
    cosine = size > 0.0 ? dot(normal, light) / size : 0.0;
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
    for (i = 0; i < 4; i++)
        for (k = 0; k < DIM; k++)
            v[i][k] = middle[k] + d->look->shrink * (v[i][k] - middle[k]);
    if (d->plain)
        for (i = 0; i < 4; i++) v[i][V] = sqrt(dot(middle, middle));
}

static int kept(const drawing *d, tess_int t)
{
    return t >= 0 && (!d->look->keep || d->look->keep[t]);
}

/* The facet opposite to vertex k, counter-clockwise from outside. */
static const int facet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/* tetrahedron - paint what can be seen of t.  The cut leaves two pieces of a
 * tetrahedron: the one behind the first plane; then, as it is nearer, the one
 * between it and the second plane. */
static void tetrahedron(drawing *d, tess_int t)
{
    double v[4][DIM];
    polygon a;
    int piece, i, j, k, tint;

    corners(d, t, v);
    for (piece = 0; piece <= d->look->cut; piece++) {
        for (k = 0; k < 4; k++) {
            if (d->look->shrink >= 1.0 && kept(d, d->adj[4 * t + k]))
                continue;
            a.n = 3;
            for (i = 0; i < 3; i++)
                for (j = 0; j < DIM; j++) a.at[i][j] = v[facet[k][i]][j];
            if (facing(a.at[0], a.at[1], a.at[2]) <= 0.0) continue;
            tint = lit(&a);
            if (d->look->cut)
                clip_plane(&a, d->plane[0], piece == 0 ? -1.0 : 1.0);
            if (piece == 1) clip_plane(&a, d->plane[1], -1.0);
            paint(d, &a, tint);
        }
        if (d->look->cut) {
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
    double seen, sign = 1.0;
    int i, j;

    for (i = 0; i < 3; i++) v[i] = d->tet[4 * t + facet[k][i]];
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

/* project - fill q: the bounding box's centre becomes the origin. */
static void project(drawing *d, tess_int n, const tess_real *p,
                    const double *value)
{
    double a = d->look->azimuth * DEGREE, e = d->look->elevation * DEGREE;
    double axis[3][3], lo[3], hi[3], x[3], most = 0.0, size = 0.0;
    tess_int i;
    int j, k;

    axis[X][0] = -sin(a);
    axis[X][1] = cos(a);
    axis[X][2] = 0.0;
    axis[Y][0] = -sin(e) * cos(a);
    axis[Y][1] = -sin(e) * sin(a);
    axis[Y][2] = cos(e);
    axis[Z][0] = cos(e) * cos(a);
    axis[Z][1] = cos(e) * sin(a);
    axis[Z][2] = sin(e);
    for (i = 0; i < 3 * n; i++)
        if (fabs((double)p[i]) > most) most = fabs((double)p[i]);
    if (most == 0.0) most = 1.0;
    for (k = 0; k < 3; k++) {
        lo[k] = 1.0;
        hi[k] = -1.0;
        for (i = 0; i < n; i++) {
            x[k] = (double)p[3 * i + k] / most;
            if (x[k] < lo[k]) lo[k] = x[k];
            if (x[k] > hi[k]) hi[k] = x[k];
        }
        if (hi[k] - lo[k] > size) size = hi[k] - lo[k];
    }
    if (!(size > 0.0)) size = 1.0;
    for (i = 0; i < n; i++) {
        for (k = 0; k < 3; k++)
            x[k] = ((double)p[3 * i + k] / most - lo[k] / 2.0 - hi[k] / 2.0) /
                   size;
        for (j = 0; j < 3; j++)
            d->q[DIM * i + j] =
                axis[j][0] * x[0] + axis[j][1] * x[1] + axis[j][2] * x[2];
        x[0] = value ? value[i] : 0.0;
        d->q[DIM * i + V] = x[0] > -1e300 && x[0] < 1e300 ? x[0] : 0.0;
    }
    for (j = 0; j < 2; j++) {
        d->plane[j][X] = (j == 0 ? 1.0 : -1.0) * sin(45.0 * DEGREE);
        d->plane[j][Y] = -sin(e) * cos(45.0 * DEGREE);
        d->plane[j][Z] = cos(e) * cos(45.0 * DEGREE);
    }
}

/* choose_bands - of values from low to high, with round borders. */
static void choose_bands(drawing *d, double low, double high)
{
    if (!(high > low)) high = low + 1.0;
    d->step = nice((high - low) / 5.0) / 5.0;
    d->low = d->step * floor(low / d->step + 1e-9);
    d->bands = (int)ceil((high - d->low) / d->step - 1e-9);
}

/* choose_place - the unit and place of a drawing of that width and height. */
static void choose_place(drawing *d, double width, double height)
{
    double room[2];

    room[0] = d->look->width - 50.0 - (d->plain ? 0.0 : 105.0);
    room[1] = d->look->height - 75.0;
    d->unit = 1e30;
    if (d->unit * width > 10.0 * room[0]) d->unit = 10.0 * room[0] / width;
    if (d->unit * height > 10.0 * room[1]) d->unit = 10.0 * room[1] / height;
    d->shift[0] = 250.0 + (10.0 * room[0] - d->unit * width) / 2.0;
    d->shift[1] = 250.0 + (10.0 * room[1] - d->unit * height) / 2.0;
}

/* scale - choose the bands, and the unit and place of the tetrahedra. */
static void scale(drawing *d)
{
    double lo[DIM], hi[DIM], v[4][DIM];
    tess_int t;
    int i, k, any = 0;

    for (k = 0; k < DIM; k++) lo[k] = hi[k] = 0.0;
    for (t = 0; t < d->ntet; t++) {
        if (!kept(d, t)) continue;
        corners(d, t, v);
        for (i = 0; i < 4; i++)
            for (k = 0; k < DIM; k++) {
                if (!any || v[i][k] < lo[k]) lo[k] = v[i][k];
                if (!any || v[i][k] > hi[k]) hi[k] = v[i][k];
                if (k == V) any = 1;
            }
    }
    choose_bands(d, lo[V], hi[V]);
    choose_place(d, hi[X] - lo[X], hi[Y] - lo[Y]);
    d->left = lo[X];
    d->top = hi[Y];
}

static void hex(FILE *file, double x, double shade)
{
    int rgb[3];

    colour(x, shade, rgb);
    fprintf(file, "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
}

/* styles - a class for each colour and shade. */
static void styles(const drawing *d)
{
    double dark = d->plain ? 0.42 : 0.76, x, shade;
    int apart = d->look->shrink < 1.0, k, tint;

    fprintf(d->file,
            "<style>path{stroke-width:%d;stroke-linejoin:round}"
            ".z0{fill:none;stroke:#000;stroke-opacity:.2}\n",
            apart ? 8 : 6);
    for (k = 0; k < d->bands; k++)
        for (tint = 0; tint < TINT; tint++) {
            x = d->bands > 1 ? k / (d->bands - 1.0) : 0.5;
            shade = dark + (1.0 - dark) * tint / (TINT - 1.0);
            fprintf(d->file, ".%c%d,.%c%d{fill:", 'A' + tint, k, 'a' + tint,
                    k);
            hex(d->file, x, shade);
            fprintf(d->file, ";stroke:");
            hex(d->file, x, shade);
            fprintf(d->file, "}.%c%d{stroke:", 'A' + tint, k);
            hex(d->file, x, shade * (apart ? 0.2 : d->plain ? 0.45 : 0.62));
            fprintf(d->file, "}%s", tint == TINT - 1 ? "\n" : "");
        }
    fprintf(d->file, "</style>\n");
}

/* head - the start of the file. */
static void head(const drawing *d)
{
    fprintf(d->file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
            "height=\"%d\" viewBox=\"0 0 %d0 %d0\" "
            "font-family=\"Helvetica,Arial,sans-serif\" fill=\"#222\">\n",
            d->look->width, d->look->height, d->look->width, d->look->height);
    if (d->tet) styles(d);
    fprintf(d->file,
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
            "<text x=\"250\" y=\"%d0\" font-size=\"140\" "
            "fill=\"#555\">%s</text>\n",
            d->look->height - 22, d->look->note);
}

/* bar - the colour bar: its bands are those of the picture. */
static void bar(const drawing *d)
{
    double tick = 5.0 * d->step, tall, x, y, level;
    double digits = -floor(log10(tick) + 1e-9);
    int k;

    tall = 6.4 * d->look->height;
    x = 10.0 * d->look->width - 1000.0;
    y = (10.0 * d->look->height - tall) / 2.0 + 120.0;
    for (k = 0; k < d->bands; k++) {
        fprintf(d->file,
                "<rect x=\"%.0f\" y=\"%.0f\" width=\"220\" height=\"%.0f\" "
                "fill=\"",
                x, y + tall * (d->bands - 1 - k) / d->bands,
                tall / d->bands + (k > 0 ? 5.0 : 0.0));
        hex(d->file, d->bands > 1 ? k / (d->bands - 1.0) : 0.5, 1.0);
        fprintf(d->file, "\"/>\n");
    }
    fprintf(d->file,
            "<rect x=\"%.0f\" y=\"%.0f\" width=\"220\" height=\"%.0f\" "
            "fill=\"none\" stroke=\"#555\" stroke-width=\"8\"/>\n",
            x, y, tall);
    for (k = 0; k <= d->bands; k++) {
        level = d->low + k * d->step;
        if (fabs(level / tick - floor(level / tick + 0.5)) > 1e-6) continue;
        level = tick * floor(level / tick + 0.5);
        fprintf(d->file,
                "<path d=\"M%.0f %.0fh60\" stroke=\"#555\" "
                "stroke-width=\"8\"/><text x=\"%.0f\" y=\"%.0f\" "
                "font-size=\"150\">",
                x + 220.0, y + tall * (d->bands - k) / d->bands, x + 320.0,
                y + tall * (d->bands - k) / d->bands + 52.0);
        if (digits >= -5.0 && digits <= 5.0)
            fprintf(d->file, "%.*f</text>\n",
                    digits > 0.0 ? (int)digits : 0, level);
        else
            fprintf(d->file, "%.3g</text>\n", level);
    }
    fprintf(d->file,
            "<text x=\"%.0f\" y=\"%.0f\" font-size=\"160\">%s</text>\n", x,
            y - 110.0, d->look->label);
}

void draw_default(draw_look *look)
{
    look->width = 900;
    look->height = 640;
    look->azimuth = -68.0;
    look->elevation = 28.0;
    look->shrink = 1.0;
    look->cut = 0;
    look->keep = 0;
    look->note = look->label = "";
}

int draw_svg(FILE *file, const draw_look *look, tess_int n,
             const tess_real *p, const double *value, tess_int ntet,
             const tess_int *tet, const tess_int *adj)
{
    drawing d;
    tess_int *order = (tess_int *)malloc(((size_t)ntet + 1) * sizeof *order);
    char *behind = (char *)malloc((size_t)ntet + 1);
    tess_int i;
    int bad;

    d.q = (double *)malloc(((size_t)n + 1) * DIM * sizeof *d.q);
    bad = !order || !behind || !d.q;
    if (!bad) {
        d.file = file;
        d.look = look;
        d.tet = tet;
        d.adj = adj;
        d.ntet = ntet;
        d.plain = !value;
        d.letter = d.band = 0;
        project(&d, n, p, value);
        scale(&d);
        head(&d);
        back_to_front(&d, behind, order);
        for (i = 0; i < ntet; i++)
            if (kept(&d, order[i])) tetrahedron(&d, order[i]);
        style(&d, 0, 0);
        if (value) bar(&d);
        fprintf(file, "</svg>\n");
    }
    free(order);
    free(behind);
    free(d.q);
    return bad;
}

/* band_of - the band that a value is in; -1 for none. */
static int band_of(const drawing *d, double x)
{
    double k = floor((x - d->low) / d->step);

    if (!(x >= -1e300 && x <= 1e300)) return -1;
    return k < 0.0 ? 0 : k >= d->bands ? d->bands - 1 : (int)k;
}

void draw_slice(FILE *file, const draw_look *look, int across, int up,
                double wide, const double *value)
{
    double low = 0.0, high = 0.0, x, y;
    drawing d;
    long many = (long)across * up, i;
    int any = 0, band, column, line, from;

    for (i = 0; i < many; i++) {
        if (!(value[i] >= -1e300 && value[i] <= 1e300)) continue;
        if (!any || value[i] < low) low = value[i];
        if (!any || value[i] > high) high = value[i];
        any = 1;
    }
    d.file = file;
    d.look = look;
    d.tet = 0;
    d.plain = !any;
    choose_bands(&d, low, high);
    choose_place(&d, wide, 1.0);
    head(&d);
    x = d.unit * wide / across;
    y = d.unit / up;
    fprintf(file, "<g transform=\"translate(%.1f %.1f) scale(%.4f %.4f)\">\n",
            d.shift[0], d.shift[1], x, y);
    /* a path for each band: where it is or a higher one, so that no gaps show */
    for (band = 0; band < d.bands; band++) {
        fprintf(file, "<path fill=\"");
        hex(file, d.bands > 1 ? band / (d.bands - 1.0) : 0.5, 1.0);
        fprintf(file, "\" d=\"");
        for (line = 0; line < up; line++) {
            const double *row = value + (long)across * (up - 1 - line);

            for (column = 0; column < across; column++) {
                if (band_of(&d, row[column]) < band) continue;
                for (from = column;
                     column < across && band_of(&d, row[column]) >= band;)
                    column++;
                fprintf(file, "M%d %dh%dv1h-%dz", from, line, column - from,
                        column - from);
            }
        }
        fprintf(file, "\"/>\n");
    }
    fprintf(file, "</g>\n");
    if (any) bar(&d);
    fprintf(file, "</svg>\n");
}
