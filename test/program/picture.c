/* picture.c - the pictures of the front page.
 *
 *   picture mirror.xyz mirror.svg section.svg cube.svg
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../examples/recipes.h"
#include "draw.h"

#define MAXPTS 5000
#define MAXTET (8 * (MAXPTS))
#define MAXIW TESS_LIW(MAXPTS)
#define MAXRW TESS_LRW(MAXPTS)

/* The blank of mirror.c: radii of hole, rim and front; thickness, m. */
#define INNER 0.60
#define OUTER 4.10
#define CURVE 28.80
#define THICK 0.175

static tess_real p[3 * (MAXPTS)];
static double value[MAXPTS];
static tess_int tet[4 * (MAXTET)], adj[4 * (MAXTET)], iw[MAXIW];
static double rw[MAXRW];
static char kept[MAXTET];
static tess_int n, ntet;

static void fail(const char *what, const char *name)
{
    fprintf(stderr, "picture: %s%s\n", what, name);
    exit(1);
}

static void tetrahedralize(void)
{
    if (tess(n, p, MAXTET, &ntet, tet, adj, MAXIW, iw, MAXRW, rw) != TESS_OK)
        fail("tess failed", "");
}

/* save - draw and write, and say so. */
static void save(const draw_look *look, const double *values,
                 const char *name)
{
    FILE *file = fopen(name, "w");
    long size;

    if (!file) fail("cannot write ", name);
    if (draw_svg(file, look, n, p, values, ntet, tet, adj) != 0)
        fail("not enough memory", "");
    size = ftell(file);
    if (ferror(file) || fclose(file)) fail("cannot write ", name);
    printf("written       %s, %ld bytes\n", name, size);
}

/* ---------------------------------------------------------------- mirror */

static void read_mirror(const char *name)
{
    FILE *file = fopen(name, "r");
    char line[200], *end;
    int k;
    double x;

    if (!file) fail("cannot read ", name);
    while (n < MAXPTS && fgets(line, (int)sizeof line, file)) {
        if (line[0] == '#') continue;
        end = line;
        for (k = 0; k < 4; k++) {
            x = strtod(end, &end);
            if (k < 3) p[3 * n + k] = (tess_real)x;
        }
        value[n++] = x;
    }
    fclose(file);
}

/* glass - is the centroid of tetrahedron t in the blank?  The hull of the
 * sensors covers the hole and the hollow of the front, too; no tetrahedron is
 * partly there and partly in the glass, but for what chords cut off. */
static int glass(tess_int t)
{
    double c[3], r, sphere;
    int i, k;

    for (k = 0; k < 3; k++) {
        c[k] = 0.0;
        for (i = 0; i < 4; i++)
            c[k] += (double)p[3 * tet[4 * t + i] + k] / 4.0;
    }
    r = sqrt(c[0] * c[0] + c[1] * c[1]);
    sphere = sqrt(r * r + (CURVE - c[2]) * (CURVE - c[2]));
    return r > INNER && r < OUTER && sphere > CURVE &&
           sphere < CURVE + THICK;
}

static double volume(tess_int t)
{
    double e[3][3];
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            e[i][k] = (double)p[3 * tet[4 * t + i + 1] + k] -
                      (double)p[3 * tet[4 * t] + k];
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6.0;
}

/* below - the integral of 2 pi r sqrt(s^2 - r^2) over the blank's radii r. */
static double below(double s)
{
    return 8.0 / 3.0 * atan(1.0) *
           (pow(s * s - INNER * INNER, 1.5) - pow(s * s - OUTER * OUTER, 1.5));
}

static void mirror(const char *from, const char *to)
{
    static char note[200];
    double solid = below(CURVE + THICK) - below(CURVE), sum = 0.0;
    draw_look look;
    tess_int t;
    long many = 0;

    read_mirror(from);
    tetrahedralize();
    for (t = 0; t < ntet; t++) {
        kept[t] = (char)glass(t);
        if (!kept[t]) continue;
        many++;
        sum += volume(t);
    }
    printf("mirror        %ld points, %ld tetrahedra, %ld in the glass: "
           "%.4f of %.4f m^3\n",
           (long)n, (long)ntet, many, sum, solid);
    /* polygons of 48 sides in place of circles: 0.29 % less */
    if (fabs(sum / solid - 0.9971) > 0.0005)
        fail("this is not the volume of the mirror", "");
    draw_default(&look);
    look.keep = kept;
    look.cut = 1;
    look.stretch = 4.0;
    look.height = 590;
    look.azimuth = -71.25; /* cuts midway between the sensors */
    look.label = "&#176;C";
    look.title = "Temperature of a telescope mirror";
    sprintf(note,
            "%ld sensors, %ld tetrahedra; heights are drawn four times as "
            "large",
            (long)n, many);
    look.note = note;
    save(&look, value, to);
}

/* --------------------------------------------------------------- section */

#define ACROSS 350 /* places from hole to rim */
#define DEEP 60    /* and from front to back  */
#define BANDS 22   /* of 0.1 degrees, from 9.5 on; the errors', of 0.001 */

/* true_value - of mirror.c. */
static double true_value(const double *q, double depth)
{
    double up = 1.0 - depth;

    return 11.0 - 1.5 * up * up + 0.2 * q[0] / OUTER +
           0.4 * (q[0] * q[0] + q[1] * q[1]) / (OUTER * OUTER);
}

/* strip - band[] of DEEP rows as paths, one a band, runs as rectangles. */
static void strip(FILE *file, int band[DEEP][ACROSS], int top,
                  const char *title)
{
    int b, i, j, from;

    fprintf(file, "<text x='20' y='%d'>%s</text>\n<g transform='translate(20 "
                  "%d) scale(2)'>\n", top - 6, title, top);
    for (b = 0; b < BANDS; b++) {
        fprintf(file, "<path fill='hsl(%d,70%%,%d%%)' d='",
                240 - 240 * b / (BANDS - 1), 45 + 10 * (b % 2));
        for (j = 0; j < DEEP; j++)
            for (i = 0; i < ACROSS; i++) {
                if (band[j][i] != b) continue;
                for (from = i; i < ACROSS && band[j][i] == b; i++) continue;
                fprintf(file, "M%d %dh%dv1h-%dz", from, j, i - from, i - from);
            }
        fprintf(file, "'/>\n");
    }
    fprintf(file, "</g>\n");
}

/* section - half a section of the mirror, midway between two rows of sensors,
 * with temperatures from linear interpolation and from slopes and bent, and
 * the errors of both. */
static void section(const char *to)
{
    static double g[3 * (MAXPTS)], work[9 * (MAXPTS)];
    static const double none[3 * (MAXPTS)] = {0.0};
    static int band[4][DEEP][ACROSS];
    static const char *const name[2] = {"linear", "bent"};
    char title[100];
    double turn = atan(1.0) / 12.0, depth, r, sphere, q[3], f[2], want, e;
    double sum[2], worst[2];
    tess_real at[3];
    tess_int t = TESS_NONE;
    FILE *file;
    int i, j, k;

    if (slopes(n, p, ntet, tet, adj, value, 15, g, work) != 0)
        fail("slopes failed", "");
    sum[0] = sum[1] = worst[0] = worst[1] = 0.0;
    for (j = 0; j < DEEP; j++)
        for (i = 0; i < ACROSS; i++) {
            depth = (j + 0.5) / DEEP;
            r = INNER + (OUTER - INNER) * (0.01 + 0.98 * (i + 0.5) / ACROSS);
            sphere = CURVE + THICK * depth;
            q[0] = r * cos(turn);
            q[1] = r * sin(turn);
            q[2] = CURVE - sqrt(sphere * sphere - r * r);
            for (k = 0; k < 3; k++) at[k] = (tess_real)q[k];
            want = true_value(q, depth);
            for (k = 0; k < 2; k++) {
                if (bent(p, ntet, tet, adj, value, k ? g : none, 0.0, at, &t,
                         f + k) < 0)
                    fail("bent failed", "");
                e = fabs(f[k] - want);
                sum[k] += e * e;
                if (e > worst[k]) worst[k] = e;
                band[k][j][i] = (int)floor((f[k] - 9.5) * 10.0);
                band[2 + k][j][i] = (int)(e / 0.001);
            }
        }
    for (k = 0; k < 4; k++)
        for (j = 0; j < DEEP; j++)
            for (i = 0; i < ACROSS; i++) {
                if (band[k][j][i] < 0) band[k][j][i] = 0;
                if (band[k][j][i] >= BANDS) band[k][j][i] = BANDS - 1;
            }
    file = fopen(to, "w");
    if (!file) fail("cannot write ", to);
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='740' "
                  "height='640' font-family='sans-serif' font-size='14'>\n"
                  "<rect width='740' height='640' fill='white'/>\n");
    for (k = 0; k < 4; k++) {
        sum[k % 2] = k < 2 ? sqrt(sum[k] / (ACROSS * DEEP)) : sum[k % 2];
        if (k < 2)
            sprintf(title, "%s: bands of 0.1 &#176;C", name[k]);
        else
            sprintf(title, "%s: error, bands of 0.001 &#176;C; rms %.4f, at "
                           "most %.4f", name[k % 2], sum[k % 2], worst[k % 2]);
        strip(file, band[k], 30 + 155 * k, title);
    }
    fprintf(file, "</svg>\n");
    if (ferror(file) || fclose(file)) fail("cannot write ", to);
    printf("section       errors, degrees: linear rms %.5f, at most %.5f; "
           "bent rms %.5f, at most %.5f\n",
           sum[0], worst[0], sum[1], worst[1]);
    if (!(sum[1] < 0.5 * sum[0])) fail("this is no better than linear", "");
}

/* ------------------------------------------------------------------ cube */

/* cube - 27 points: a grid, of which corners stay, and the others move at
 * random along their edge, in their face or inside. */
static void cube(const char *to)
{
    static char note[120];
    unsigned long seed = 5;
    double sum = 0.0;
    draw_look look;
    tess_int t;
    int k, place;

    for (n = 0; n < 27; n++) {
        place = (int)n;
        for (k = 0; k < 3; k++) {
            seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
            p[3 * n + k] = (tess_real)(place % 3 / 2.0);
            if (place % 3 == 1)
                p[3 * n + k] =
                    (tess_real)(0.35 + 0.3 * (double)seed / 4294967296.0);
            place /= 3;
        }
    }
    tetrahedralize();
    for (t = 0; t < ntet; t++) sum += volume(t);
    printf("cube          %ld points, %ld tetrahedra, volume %.6f\n",
           (long)n, (long)ntet, sum);
    if (fabs(sum - 1.0) > 1e-12)
        fail("this is not the volume of the cube", "");
    draw_default(&look);
    look.width = 640;
    look.height = 640;
    look.azimuth = -62.0;
    look.elevation = 24.0;
    look.shrink = 0.72;
    sprintf(note,
            "%ld points of a cube, %ld tetrahedra, moved apart; coloured by "
            "distance from the middle",
            (long)n, (long)ntet);
    look.note = note;
    save(&look, (const double *)0, to);
}

int main(int argc, char **argv)
{
    if (argc != 5)
        fail("usage: picture mirror.xyz mirror.svg section.svg cube.svg", "");
    mirror(argv[1], argv[2]);
    section(argv[3]);
    cube(argv[4]);
    return 0;
}
