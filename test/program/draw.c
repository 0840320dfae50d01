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
#include "driver.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE 0.017453292519943295
#define CORNERS 16 /* a triangle, clipped by two planes and two values: 7 */
#define TINT 5     /* shades of each colour */
#define GREY "#767c85" /* of equal contrast to white and to a dark page */
#define EXPLODED 0.72  /* size of a tetrahedron that is moved apart */

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
    tess_int n, ntet;
    const char *keep;
    int plain;            /* no values */
    double turn[3][3];    /* from coordinates to X, Y, Z: rows; */
    int height;           /* of the picture */
    double most, middle[3], side[3], /* what is done to them before; */
        factor[3], hand;  /* -1: that makes left hands of right ones */
    double left, top;     /* of what is drawn, in the units of q */
    double unit;          /* tenths of a pixel a unit of q */
    double shift[2];      /* tenths of a pixel */
    double low, step;     /* band k: low + k * step ... */
    int bands, lost; /* is there a value that is no number?  Band bands */
    int letter, band;     /* style of the path that is being written; of its */
    int corners;          /* outline so many, the last one here, and the line */
    long at[2], line[2];  /* that leads there, not yet written */
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
 * differences look equal, in grey and to the colour-blind too.  Below 0: a
 * greyish blue; above 1: a grey, of what is no number. */
static void colour(double x, double shade, int *rgb)
{
    double l = 0.46 + 0.46 * x, hue = (282.0 + 180.0 * x) * DEGREE;
    double chroma = 0.145 + 0.06 * sin(180.0 * x * DEGREE);
    double a, b, r, g, s;

    if (x < 0.0 || x > 1.0) {
        l = x < 0.0 ? 0.82 : 0.72;
        chroma = x < 0.0 ? 0.04 : 0.0;
        hue = 258.0 * DEGREE;
    }
    a = chroma * cos(hue);
    b = chroma * sin(hue);
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

/* put_line - the line that waits, if any. */
static void put_line(drawing *d)
{
    const long *to = d->line;

    check_written(d->file);
    if (to[0] == 0 && to[1] == 0) return;
    fprintf(d->file, d->corners > 2 && to[0] >= 0 ? " %ld%s%ld" : "%ld%s%ld",
            to[0], to[1] >= 0 ? " " : "", to[1]);
}

/* corner - of an outline, in tenths of pixels, of which whole ones are written:
 * as SVG path data, the first corner absolute, the others relative to the one
 * before.  Corners that fall together, or into a line, are left out. */
static void corner(drawing *d, double x, double y)
{
    long to[2], step[2];
    int k;

    to[0] = (long)floor(x + 0.5);
    to[1] = (long)floor(y + 0.5);
    for (k = 0; k < 2; k++) step[k] = d->corners ? to[k] - d->at[k] : 0;
    if (d->corners == 0) {
        fprintf(d->file, "M%ld %ldl", to[0], to[1]);
        d->line[0] = d->line[1] = 0;
    } else if (step[0] == 0 && step[1] == 0) {
        return;
    } else if (d->line[0] * step[1] == d->line[1] * step[0] &&
               d->line[0] * step[0] + d->line[1] * step[1] > 0) {
        for (k = 0; k < 2; k++) step[k] += d->line[k];
        d->corners--;
    } else {
        put_line(d);
    }
    d->corners++;
    for (k = 0; k < 2; k++) {
        d->at[k] = to[k];
        d->line[k] = step[k];
    }
}

/* close_outline - and begin another one. */
static void close_outline(drawing *d)
{
    if (d->corners == 0) return;
    put_line(d);
    fprintf(d->file, d->corners > 1 ? "z" : "0 0z");
    d->corners = 0;
}

/* across, down - where in the picture: tenths of pixels. */
static double across(const drawing *d, double x)
{
    return d->shift[0] + d->unit * (x - d->left);
}

static double down(const drawing *d, double y)
{
    return d->shift[1] + d->unit * (d->top - y);
}

static void outline(drawing *d, const polygon *a)
{
    int i;

    for (i = 0; i < a->n; i++)
        corner(d, across(d, a->at[i][X]), down(d, a->at[i][Y]));
    close_outline(d);
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

static int kept(const drawing *d, tess_int t)
{
    return t >= 0 && (!d->keep || d->keep[t]);
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
    int cut = d->look->what == DRAW_CUT || d->look->what == DRAW_FIELD;
    int piece, i, j, k, tint;

    corners(d, t, v);
    for (piece = 0; piece <= cut; piece++) {
        for (k = 0; k < 4; k++) {
            if (d->look->what != DRAW_APART && kept(d, d->adj[4 * t + k]))
                continue;
            a.n = 3;
            for (i = 0; i < 3; i++)
                for (j = 0; j < DIM; j++) a.at[i][j] = v[facet[k][i]][j];
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

/* choose_bands - of values from low to high, with round borders. */
static void choose_bands(drawing *d, double low, double high)
{
    const double *range = d->look->range;
    double size;

    if (range[0] < range[1] && !d->plain) {
        low = range[0];
        high = range[1];
    }
    size = fabs(low) > fabs(high) ? fabs(low) : fabs(high);
    if (!(high - low > 1e-13 * size)) {
        /* all the same, but for rounding: amid a band, with others about it */
        d->step = size > 0.0 ? nice(size / 25.0) / 5.0 : 0.1;
        d->bands = d->plain ? 1 : 25;
        d->low = low - d->bands / 2.0 * d->step;
        return;
    }
    d->step = nice((high - low) / 5.0) / 5.0;
    d->low = d->step * floor(low / d->step + 1e-9);
    d->bands = (int)ceil((high - d->low) / d->step - 1e-9);
}

/* ---------------------------------------------------------- around it */

#define LEFT 90.0 /* pixels beside a picture, for axes and texts */
#define RIGHT 60.0
#define TOP 25.0
#define BOTTOM 60.0
#define BAR 110.0
#define ABOVE 40.0
#define BELOW 25.0
#define ALONE 8.0 /* where there are none */
#define HIGHEST 640.0
#define LOWEST 300
#define SPARED 0.7 /* of a picture for that at most */
#define WIDE 0.56 /* of a character, about, in parts of its size */
#define DIGITS 6  /* characters of a tick's number, if an offset can help */

/* choose_place - the unit and place of a drawing of that width and height. */
static void choose_place(drawing *d, double width, double height)
{
    const draw_look *look = d->look;
    double margin[4], share[4] = {1.0, 1.0, 1.0, 1.0}, room[2], sum, size;
    int k;

    margin[0] = look->bare ? ALONE : LEFT;
    margin[1] = look->bare ? ALONE : RIGHT + (d->plain ? 0.0 : BAR);
    margin[2] = look->bare ? ALONE : TOP + (look->title ? ABOVE : 0.0);
    margin[3] = look->bare ? ALONE : BOTTOM + BELOW;
    /* (of a small picture a part is left) */
    for (k = 0; k < 4; k++) {
        size = k < 2 ? look->width : look->height;
        sum = k < 2 ? margin[0] + margin[1] : margin[2] + margin[3];
        if (size > 0.0 && sum > SPARED * size) share[k] = SPARED * size / sum;
    }
    for (k = 0; k < 4; k++) margin[k] *= share[k];
    room[0] = 10.0 * (look->width - margin[0] - margin[1]);
    room[1] = 10.0 * (HIGHEST - margin[2] - margin[3]);
    if (height * room[0] < width * room[1]) room[1] = height * room[0] / width;
    d->height = (int)(room[1] / 10.0 + margin[2] + margin[3] + 0.5);
    if (d->height < LOWEST) d->height = LOWEST;
    if (look->height > 0) d->height = look->height;
    room[1] = 10.0 * (d->height - margin[2] - margin[3]);
    d->unit = 1e30;
    if (d->unit * width > room[0]) d->unit = room[0] / width;
    if (d->unit * height > room[1]) d->unit = room[1] / height;
    d->shift[0] = 10.0 * margin[0] + (room[0] - d->unit * width) / 2.0;
    d->shift[1] = 10.0 * margin[2] + (room[1] - d->unit * height) / 2.0;
}

/* characters - of a text, of which some have several bytes. */
static double characters(const char *text)
{
    double many = 0.0;

    for (; *text; text++) many += ((unsigned char)*text & 192) != 128;
    return many;
}

/* fitted - the size of a text, or one with which it is not longer than that. */
static double fitted(const char *text, double size, double most)
{
    double wide = WIDE * size * characters(text);

    return wide > most ? size * most / wide : size;
}

/* write_at - a text, of that size, in tenths of pixels; anchor: start, middle,
 * end. */
static void write_at(const drawing *d, double x, double y, double size,
                     const char *anchor, const char *text)
{
    fprintf(d->file, "<text x=\"%.0f\" y=\"%.0f\" font-size=\"%.0f\"", x, y,
            size);
    if (strcmp(anchor, "start") != 0)
        fprintf(d->file, " text-anchor=\"%s\"", anchor);
    fprintf(d->file, ">%s</text>\n", xml_text(text));
}

/* write_within - the same, moved and made smaller so that it is within the
 * picture, above the note, and so far from the right. */
static void write_within(const drawing *d, double x, double y, double size,
                         const char *anchor, const char *text, double right)
{
    double most = 10.0 * d->look->width - right - 50.0, wide, before;

    size = fitted(text, size, most);
    wide = WIDE * size * characters(text);
    before = *anchor == 's' ? 0.0 : *anchor == 'e' ? wide : wide / 2.0;
    if (x - before < 50.0) x = 50.0 + before;
    if (x - before + wide > most + 50.0) x = most + 50.0 + before - wide;
    if (y < size) y = size;
    if (y > 10.0 * d->height - 370.0) y = 10.0 * d->height - 370.0;
    write_at(d, x, y, size, anchor, text);
}

/* put_number - a multiple of step, with the digits that tells it. */
static void put_number(char *text, double x, double step)
{
    double digits = -floor(log10(step) + 1e-9);

    if (fabs(x) < step / 2.0) x = 0.0;
    if (digits >= -5.0 && digits <= 5.0 && fabs(x) < 1e9)
        sprintf(text, "%.*f", digits > 0.0 ? (int)digits : 0, x);
    else
        sprintf(text, "%.6g", x);
}

/* ticks - of a scale: so many multiples of step, from first on.  What is
 * written is less by base, which the scale's title says. */
typedef struct ticks {
    double step, first, base;
    int many;
} ticks;

static double tick(const ticks *t, int i)
{
    return (t->first + i) * t->step;
}

static void tick_text(const ticks *t, int i, char *text)
{
    put_number(text, (t->first - floor(t->base / t->step + 0.5) + i) * t->step,
               t->step);
}

/* choose_ticks - two at least, of numbers that differ, and are short if they
 * can be. */
static void choose_ticks(ticks *t, double low, double high, double step)
{
    char text[40], last[40];
    double unit = pow(10.0, ceil(log10(high - low) - 1e-9));
    int i;

    for (;; step = nice(step / 2.5)) {
        t->step = step;
        t->first = ceil(low / step - 1e-6);
        t->many = (int)(floor(high / step + 1e-6) - t->first) + 1;
        if (t->many > 1) break;
    }
    t->base = 0.0;
    last[0] = '\0';
    for (i = 0; i < t->many; i++) {
        tick_text(t, i, text);
        if (strlen(text) > (strchr(text, 'e') ? DIGITS + 2 : DIGITS) ||
            strcmp(last, text) == 0)
            t->base = unit * floor(low / unit + 1e-3);
        if (t->base != 0.0) return;
        strcpy(last, text);
    }
}

/* scale_title - its name, and the base before a comma with its unit. */
static const char *scale_title(const ticks *t, const char *name)
{
    static char text[TEXT];
    int k = (int)strcspn(name, ",");

    if (t->base == 0.0) return name;
    sprintf(text, "%.*s %c %.15g%.200s", k < 200 ? k : 200, name,
            t->base > 0.0 ? '-' : '+', fabs(t->base), name + k);
    return text;
}

/* draw_axis - from a point of the picture to another one, for numbers from low
 * to high, with ticks and texts in the direction out. */
static void draw_axis(const drawing *d, const double *from, const double *to,
                      double low, double high, const double *out,
                      const char *name)
{
    double length = sqrt((to[0] - from[0]) * (to[0] - from[0]) +
                         (to[1] - from[1]) * (to[1] - from[1]));
    double x, y, s, size, wide = 0.0;
    const char *anchor = out[0] < -0.3 ? "end" : out[0] > 0.3 ? "start"
                                                              : "middle";
    const char *title;
    char text[40];
    ticks t;
    int i;

    if (length < 200.0 ||
        !(high - low > 1e-14 * (fabs(low) > fabs(high) ? fabs(low)
                                                       : fabs(high))))
        return;
    choose_ticks(&t, low, high,
                 nice((high - low) * (350.0 + 250.0 * fabs(out[1])) / length));
    fprintf(d->file, "<path d=\"M%.0f %.0fL%.0f %.0f", from[0], from[1], to[0],
            to[1]);
    for (i = 0; i < t.many; i++) {
        s = (tick(&t, i) - low) / (high - low);
        fprintf(d->file, "M%.0f %.0fl%.0f %.0f",
                from[0] + s * (to[0] - from[0]),
                from[1] + s * (to[1] - from[1]), 60.0 * out[0], 60.0 * out[1]);
    }
    fprintf(d->file, "\"/>\n");
    for (i = 0; i < t.many; i++) {
        tick_text(&t, i, text);
        if (78.0 * (double)strlen(text) > wide)
            wide = 78.0 * (double)strlen(text);
        s = (tick(&t, i) - low) / (high - low);
        x = from[0] + s * (to[0] - from[0]) + 110.0 * out[0];
        y = from[1] + s * (to[1] - from[1]) + 110.0 * out[1];
        write_at(d, x, y + 50.0 + 50.0 * out[1], 140.0, anchor, text);
    }
    title = scale_title(&t, name);
    x = (from[0] + to[0]) / 2.0;
    y = (from[1] + to[1]) / 2.0;
    s = 220.0 + wide * fabs(out[0]) + 130.0 * fabs(out[1]);
    if (out[0] > -0.95) {
        /* (beside the bar) */
        y += s * out[1] + 50.0 + 50.0 * out[1];
        s = x + s * out[0];
        x = d->plain ? 50.0 : 1080.0;
        wide = WIDE * 150.0 * characters(title);
        if (*anchor == 's' ? s + wide > 10.0 * d->look->width - x
                           : *anchor == 'e' && s - wide < 50.0) {
            /* too long to be beside the ticks: below */
            y = (from[1] > to[1] ? from[1] : to[1]) + 500.0;
            s = *anchor == 's' ? 10.0 * d->look->width : 0.0;
        }
        write_within(d, s, y, 150.0, anchor, title, x);
        return;
    }
    x = x + s * out[0] + 40.0;
    if (x < 150.0) x = 150.0;
    size = fitted(title, 150.0, 10.0 * d->height - 450.0);
    wide = WIDE * size * characters(title) / 2.0;
    if (y < wide + 50.0) y = wide + 50.0;
    if (y > 10.0 * d->height - 370.0 - wide)
        y = 10.0 * d->height - 370.0 - wide;
    fprintf(d->file, "<g transform=\"translate(%.0f %.0f) rotate(-90)\">\n", x,
            y);
    write_at(d, 0.0, 0.0, size, "middle", title);
    fprintf(d->file, "</g>\n");
}

/* begin_axes - their group. */
static void begin_axes(const drawing *d)
{
    fprintf(d->file, "<g class=\"axes\" stroke=\"none\">\n");
    fprintf(d->file,
            "<style>.axes path{stroke:" GREY ";stroke-width:10;fill:none}"
            "</style>\n");
}

static void hex(FILE *file, double x, double shade)
{
    int rgb[3];

    colour(x, shade, rgb);
    fprintf(file, "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
}

/* share - band k among all, 0 ... 1; less where there are no values, more for
 * no number. */
static double share(const drawing *d, int k)
{
    if (k == d->bands) return 2.0;
    if (d->plain && d->look->what != DRAW_APART) return -1.0;
    return d->bands > 1 ? k / (d->bands - 1.0) : 0.5;
}

/* head - the start of the file: title and note. */
static void head(const drawing *d)
{
    const draw_look *look = d->look;

    fprintf(d->file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
            "height=\"%d\" viewBox=\"0 0 %d0 %d0\" "
            "font-family=\"Helvetica,Arial,sans-serif\" fill=\"" GREY "\">\n",
            look->width, d->height, look->width, d->height);
    if (look->bare) return;
    if (look->title) {
        fprintf(d->file, "<g font-weight=\"bold\">\n");
        /* (bold is wider) */
        write_at(d, 250.0, 430.0,
                 fitted(look->title, 210.0, 9.0 * look->width - 450.0),
                 "start", look->title);
        fprintf(d->file, "</g>\n");
    }
    if (look->note)
        write_at(d, 250.0, 10.0 * d->height - 180.0,
                 fitted(look->note, 140.0, 10.0 * look->width - 500.0),
                 "start", look->note);
}

/* bar - the colour bar: its bands are those of the picture. */
static void bar(const drawing *d)
{
    double tall, x, y;
    const char *label = d->look->label ? d->look->label : "";
    char text[40];
    ticks t;
    int k;

    if (d->plain || d->look->bare) return;
    tall = 6.4 * d->height;
    x = 10.0 * d->look->width - 1000.0;
    y = (10.0 * d->height - tall) / 2.0 + 120.0;
    fprintf(d->file, "<g class=\"bar\">\n");
    for (k = 0; k < d->bands; k++) {
        fprintf(d->file,
                "<rect x=\"%.0f\" y=\"%.0f\" width=\"220\" height=\"%.0f\" "
                "fill=\"",
                x, y + tall * (d->bands - 1 - k) / d->bands,
                tall / d->bands + (k > 0 ? 5.0 : 0.0));
        hex(d->file, share(d, k), 1.0);
        fprintf(d->file, "\"/>\n");
    }
    choose_ticks(&t, d->low, d->low + d->bands * d->step, 5.0 * d->step);
    for (k = 0; k < t.many; k++) {
        tick_text(&t, k, text);
        write_at(d, x + 270.0,
                 y + tall * (d->bands - (tick(&t, k) - d->low) / d->step) /
                         d->bands + 52.0,
                 140.0, "start", text);
    }
    label = scale_title(&t, label);
    if (characters(label) > 10.0)
        write_within(d, 10.0 * d->look->width - 50.0,
                     characters(label) > 20.0 ? 170.0 : y - 110.0, 150.0, "end",
                     label, 50.0);
    else if (*label)
        write_at(d, x, y - 110.0, 150.0, "start", label);
    fprintf(d->file, "</g>\n");
}

void draw_default(draw_look *look)
{
    int k;

    memset(look, 0, sizeof *look);
    look->width = 900;
    look->what = DRAW_WHOLE;
    look->azimuth = -68.0;
    look->elevation = 28.0;
    look->title = look->note = look->label = 0;
    for (k = 0; k < 3; k++) {
        look->scale[k] = 1.0;
        look->name[k] = &"x\0y\0z"[2 * k];
    }
}

void draw_even(draw_look *look, const double *length, double most, char *note)
{
    double longest = 0.0, side;
    int k;

    for (k = 0; k < 3; k++) {
        side = length[k] * fabs(look->scale[k]);
        if (side > longest) longest = side;
    }
    for (k = 0; k < 3; k++) {
        side = length[k] * fabs(look->scale[k]);
        if (!(side > 0.0) || side * most >= longest) continue;
        look->scale[k] *= longest / most / side;
        sprintf(note + strlen(note), "; %.*s is drawn %.3g times as large",
                (int)strcspn(look->name[k], ","), look->name[k],
                longest / most / side);
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
            if (!kept(d, t)) continue;
            corners(d, t, v);
            for (i = 0; i < 4; i++) larger(v[i], lo, hi, DIM);
        }
    if (lo[V] > hi[V]) lo[V] = hi[V] = 0.0;
    choose_bands(d, lo[V], hi[V]);
    for (k = 0; k < 3 && !d->look->bare; k++) {
        ends(d, k, v);
        for (i = 0; i < 2; i++) larger(v[i], lo, hi, 2);
    }
    choose_place(d, hi[X] - lo[X], hi[Y] - lo[Y]);
    d->left = lo[X];
    d->top = hi[Y];
}

/* axes - along three edges of the box. */
static void axes(const drawing *d)
{
    double end[2][DIM], at[2][2], out[2], length, low, high;
    int k, m;

    if (d->look->bare) return;
    begin_axes(d);
    for (k = 0; k < 3; k++) {
        ends(d, k, end);
        for (m = 0; m < 2; m++) {
            at[m][0] = across(d, end[m][X]);
            at[m][1] = down(d, end[m][Y]);
        }
        /* away from the middle of the box, which is at 0, 0 */
        out[0] = at[1][1] - at[0][1];
        out[1] = at[0][0] - at[1][0];
        length = sqrt(out[0] * out[0] + out[1] * out[1]);
        if (length < 1.0) continue;
        if (out[0] * (at[0][0] - across(d, 0.0)) +
                out[1] * (at[0][1] - down(d, 0.0)) < 0.0)
            length = -length;
        for (m = 0; m < 2; m++) out[m] /= length;
        low = d->most * (d->middle[k] - d->side[k] / 2.0);
        high = d->most * (d->middle[k] + d->side[k] / 2.0);
        draw_axis(d, at[0], at[1], low, high, out, d->look->name[k]);
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
            x = share(d, k);
            shade = dark + (1.0 - dark) * tint / (TINT - 1.0);
            fprintf(d->file, ".%c%d,.%c%d{fill:", 'A' + tint, k, 'a' + tint,
                    k);
            hex(d->file, x, shade);
            fprintf(d->file, ";stroke:");
            hex(d->file, x, shade);
            fprintf(d->file, "}.%c%d{stroke:", 'A' + tint, k);
            hex(d->file, x, shade * (apart ? 0.2 : 0.3));
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
        corner(d, across(d, sorted[i][X]), down(d, sorted[i][Y]));
        close_outline(d);
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

    d.q = (double *)malloc(((size_t)n + 1) * DIM * sizeof *d.q);
    bad = !order || !behind || !d.q || !sorted;
    if (!bad) {
        d.file = file;
        d.look = look;
        d.tet = tet;
        d.adj = adj;
        d.n = n;
        d.ntet = ntet;
        d.keep = keep;
        d.plain = !value;
        d.letter = d.band = d.corners = 0;
        project(&d, p, value);
        scale(&d);
        head(&d);
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
            if (kept(&d, order[i])) tetrahedron(&d, order[i]);
        if (look->what == DRAW_POINTS) dots(&d, sorted);
        style(&d, 0, 0);
        fprintf(file, "</g>\n");
        bar(&d);
        fprintf(file, "</svg>\n");
    }
    free(order);
    free(behind);
    free((void *)sorted);
    free(d.q);
    return bad;
}

/* -------------------------------------------------------------- a plane */

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
    return k == 0 ? across(d, s) : down(d, s);
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
    corner(d, spot(d, g, 0, i + a[0] + s * (b[0] - a[0])),
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
                close_outline(d);
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
            if (!kept(d, t) || kept(d, d->adj[4 * t + k])) continue;
            for (i = 0; i < 3; i++) {
                v[i] = d->tet[4 * t + facet[k][i]];
                x[i] = (double)p[3 * v[i] + g->axis[2]] -
                       g->box[2 * g->axis[2]];
            }
            if ((x[0] < 0.0) == (x[1] < 0.0) && (x[1] < 0.0) == (x[2] < 0.0))
                continue;
            for (i = 0; i < 3; i++)
                if ((x[i] < 0.0) != (x[(i + 1) % 3] < 0.0))
                    cross(d, g, p, v[i], v[(i + 1) % 3], at[x[i] < 0.0]);
            if (floor(at[0][0] + 0.5) == floor(at[1][0] + 0.5)) continue;
            corner(d, at[0][0], edge);
            corner(d, at[0][0], at[0][1]);
            corner(d, at[1][0], at[1][1]);
            corner(d, at[1][0], edge);
            close_outline(d);
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
    d.file = file;
    d.look = look;
    d.tet = tet;
    d.adj = adj;
    d.ntet = ntet;
    d.keep = keep;
    d.plain = !any;
    d.corners = 0;
    d.left = 0.0;
    g.axis = axis;
    g.many = many;
    g.box = box;
    g.value = value;
    for (k = 0; k < 2; k++)
        g.side[k] = (box[2 * axis[k] + 1] - box[2 * axis[k]]) *
                    look->scale[axis[k]];
    d.top = fabs(g.side[1]);
    choose_bands(&d, any ? range[0] : 0.0, any ? range[1] : 0.0);
    choose_place(&d, fabs(g.side[0]), d.top);
    head(&d);
    if (ntet > 0) clip_to(&d, &g, p);
    fprintf(file, ntet > 0 ? "<g mask=\"url(#inside)\">\n" : "<g>\n");
    /* a path for each band: where it or a higher one is, lest gaps show */
    for (band = 0; band < d.bands && any; band++) {
        fprintf(file, "<path fill=\"");
        hex(file, share(&d, band), 1.0);
        fprintf(file, "\" d=\"");
        contours(&d, &g, band > 0 ? d.low + band * d.step : -1e300, seen);
        fprintf(file, "\"/>\n");
    }
    fprintf(file, "</g>\n");
    if (!look->bare) {
        begin_axes(&d);
        for (k = 0; k < 2; k++) {
            for (m = 0; m < 2; m++) {
                end[m][0] = spot(&d, &g, 0, k == 0 ? m * (many[0] - 1.0)
                                 : g.side[0] < 0.0 ? many[0] - 1.0 : 0.0);
                end[m][1] = spot(&d, &g, 1, k == 1 ? m * (many[1] - 1.0)
                                 : g.side[1] < 0.0 ? many[1] - 1.0 : 0.0);
            }
            draw_axis(&d, end[0], end[1], box[2 * axis[k]],
                      box[2 * axis[k] + 1], out[k], look->name[axis[k]]);
        }
        fprintf(file, "</g>\n");
    }
    bar(&d);
    fprintf(file, "</svg>\n");
    free(seen);
    return 0;
}
