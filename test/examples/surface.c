/* surface.c - the convex hull of points as a surface of triangles, written as
 * Wavefront OBJ and as STL (ASCII), which programs for drawing and for
 * printing in three dimensions read.
 *
 *   cc -O2 -I. -o surface test/examples/surface.c tess.c hhpred.c -lm
 *   surface [hull.obj [hull.stl [points.xyz]]]
 *
 * Without a file of points (three numbers a line): points on an ellipsoid and
 * some inside of it.
 *
 * Checked: the triangles form a closed surface, each edge running once in
 * either direction; Euler's relation V - E + F = 2; the volume that the
 * surface encloses is that of the tetrahedra, and that of the STL file when
 * it is read again.  For the ellipsoid: the hull's vertices are just the
 * points on it, and the volume lies between those of two ellipsoids, one
 * through the point farthest out, one that the surface's planes do not cut.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tess.h"

#define MAXPTS 100000
#define MAXTET (7 * MAXPTS)
#define MAXIW TESS_LIW(MAXPTS)
#define MAXRW TESS_LRW(MAXPTS)
#define MAXFAC (2 * MAXPTS) /* Euler: a hull of V points has 2 V - 4 */

#define OUTSIDE 1000 /* points on the ellipsoid */
#define WITHIN 1000

static const double axis[3] = {3.0, 2.0, 1.0};

static tess_real p[3 * MAXPTS];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[MAXIW];
static tess_int fac[3 * MAXFAC], edges[6 * MAXFAC], number[MAXPTS];
static double rw[MAXRW];
static tess_int n, ntet, nfac;

static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 8) / 16777216.0;
}

/* put - a point: q, of the unit sphere, stretched by the axes; in multiples of
 * 2^-22, for the same on every machine. */
static void put(const double *q)
{
    int k;

    for (k = 0; k < 3; k++)
        p[3 * n + k] =
            (tess_real)(floor(axis[k] * q[k] * 4194304.0 + 0.5) / 4194304.0);
    n++;
}

/* ellipsoid - a spiral on the unit sphere, and random points inside. */
static void ellipsoid(void)
{
    double q[3], r, angle;
    int i, k;

    for (i = 0; i < OUTSIDE; i++) {
        q[2] = 1.0 - (2.0 * i + 1.0) / OUTSIDE;
        r = sqrt(1.0 - q[2] * q[2]);
        angle = 4.0 * atan(1.0) * (3.0 - sqrt(5.0)) * i;
        q[0] = r * cos(angle);
        q[1] = r * sin(angle);
        put(q);
    }
    while (n < OUTSIDE + WITHIN) {
        for (k = 0; k < 3; k++) q[k] = 2.0 * random01() - 1.0;
        if (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] < 0.9) put(q);
    }
}

static int read_points(const char *name)
{
    FILE *file = fopen(name, "r");
    double x, y, z;

    if (!file) return 0;
    while (n < MAXPTS && fscanf(file, "%lf %lf %lf", &x, &y, &z) == 3) {
        p[3 * n] = (tess_real)x;
        p[3 * n + 1] = (tess_real)y;
        p[3 * n + 2] = (tess_real)z;
        n++;
    }
    return fclose(file) == 0;
}

/* ----------------------------------------------------------------- files */

/* close_file - also tells whether all could be written. */
static int close_file(FILE *file, const char *name)
{
    int bad = ferror(file);

    if (fclose(file) || bad) return 0;
    printf("written            %s\n", name);
    return 1;
}

/* write_obj - the hull's vertices, numbered from 1, and the triangles. */
static int write_obj(const char *name)
{
    FILE *file = fopen(name, "w");
    tess_int i, many = 0;

    if (!file) return 0;
    for (i = 0; i < n; i++) number[i] = 0;
    for (i = 0; i < 3 * nfac; i++) number[fac[i]] = 1;
    for (i = 0; i < n; i++) {
        if (!number[i]) continue;
        number[i] = ++many;
        fprintf(file, "v %.9g %.9g %.9g\n", (double)p[3 * i],
                (double)p[3 * i + 1], (double)p[3 * i + 2]);
    }
    for (i = 0; i < nfac; i++)
        fprintf(file, "f %ld %ld %ld\n", (long)number[fac[3 * i]],
                (long)number[fac[3 * i + 1]], (long)number[fac[3 * i + 2]]);
    return close_file(file, name);
}

/* normal - c = the cross product of two edges of the triangle q: outwards, of
 * twice its area. */
static void normal(double q[3][3], double *c)
{
    int k, i, j;

    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = (k + 2) % 3;
        c[k] = (q[1][i] - q[0][i]) * (q[2][j] - q[0][j]) -
               (q[1][j] - q[0][j]) * (q[2][i] - q[0][i]);
    }
}

static void triangle(tess_int f, double q[3][3])
{
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++) q[i][k] = (double)p[3 * fac[3 * f + i] + k];
}

static int write_stl(const char *name)
{
    FILE *file = fopen(name, "w");
    double q[3][3], c[3], size;
    tess_int f;
    int i;

    if (!file) return 0;
    fprintf(file, "solid hull\n");
    for (f = 0; f < nfac; f++) {
        triangle(f, q);
        normal(q, c);
        size = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        if (size == 0.0) size = 1.0;
        fprintf(file, "facet normal %.6g %.6g %.6g\n outer loop\n",
                c[0] / size, c[1] / size, c[2] / size);
        for (i = 0; i < 3; i++)
            fprintf(file, "  vertex %.9g %.9g %.9g\n", q[i][0], q[i][1],
                    q[i][2]);
        fprintf(file, " endloop\nendfacet\n");
    }
    fprintf(file, "endsolid hull\n");
    return close_file(file, name);
}

/* ---------------------------------------------------------------- volume */

/* cone - the volume between the triangle q and the point o. */
static double cone(double q[3][3], const double *o)
{
    double c[3];

    normal(q, c);
    return ((q[0][0] - o[0]) * c[0] + (q[0][1] - o[1]) * c[1] +
            (q[0][2] - o[2]) * c[2]) /
           6.0;
}

static void first_point(double *o)
{
    int k;

    for (k = 0; k < 3; k++) o[k] = (double)p[3 * fac[0] + k];
}

static double enclosed(void)
{
    double q[3][3], o[3], sum = 0.0;
    tess_int f;

    first_point(o);
    for (f = 0; f < nfac; f++) {
        triangle(f, q);
        sum += cone(q, o);
    }
    return sum;
}

/* filled - the volume of all tetrahedra: the facet opposite to vertex 3,
 * counter-clockwise from outside, is 0, 1, 2 backwards. */
static double filled(void)
{
    double q[3][3], o[3], sum = 0.0;
    tess_int t;
    int i, k;

    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 3; k++) {
            for (i = 0; i < 3; i++)
                q[i][k] = (double)p[3 * tet[4 * t + 2 - i] + k];
            o[k] = (double)p[3 * tet[4 * t + 3] + k];
        }
        sum += cone(q, o);
    }
    return sum;
}

/* stl_volume - what the triangles of an STL file enclose. */
static double stl_volume(const char *name)
{
    FILE *file = fopen(name, "r");
    char line[200];
    double q[3][3], o[3], sum = 0.0;
    int i = 0;

    if (!file) return 0.0;
    first_point(o);
    while (fgets(line, (int)sizeof line, file))
        if (sscanf(line, " vertex %lf %lf %lf", &q[i][0], &q[i][1],
                   &q[i][2]) == 3 &&
            ++i == 3) {
            sum += cone(q, o);
            i = 0;
        }
    fclose(file);
    return sum;
}

/* ---------------------------------------------------------------- checks */

static int by_ends(const void *x, const void *y)
{
    const tess_int *a = (const tess_int *)x, *b = (const tess_int *)y;

    if (a[0] != b[0]) return a[0] < b[0] ? -1 : 1;
    return a[1] < b[1] ? -1 : a[1] > b[1];
}

/* closed - is every edge there once in either direction? */
static int closed(void)
{
    size_t many = 3 * (size_t)nfac, i;
    tess_int back[2];
    int k;

    for (i = 0; i < many; i++) {
        k = (int)(i % 3);
        edges[2 * i] = fac[i];
        edges[2 * i + 1] = fac[k == 2 ? i - 2 : i + 1];
    }
    qsort(edges, many, 2 * sizeof *edges, by_ends);
    for (i = 0; i < many; i++) {
        if (i > 0 && by_ends(edges + 2 * i - 2, edges + 2 * i) == 0) return 0;
        back[0] = edges[2 * i + 1];
        back[1] = edges[2 * i];
        if (!bsearch(back, edges, many, sizeof back, by_ends)) return 0;
    }
    return 1;
}

/* range - the least distance of a triangle's plane from the middle, and the
 * largest of a point, where the ellipsoid is the unit sphere. */
static void range(double *least, double *most)
{
    double q[3][3], c[3], d;
    tess_int f;
    int i, k;

    *least = 1e30;
    *most = 0.0;
    for (f = 0; f < nfac; f++) {
        triangle(f, q);
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 3; k++) q[i][k] /= axis[k];
            d = sqrt(q[i][0] * q[i][0] + q[i][1] * q[i][1] +
                     q[i][2] * q[i][2]);
            if (d > *most) *most = d;
        }
        normal(q, c);
        d = (q[0][0] * c[0] + q[0][1] * c[1] + q[0][2] * c[2]) /
            sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        if (d < *least) *least = d;
    }
}

int main(int argc, char **argv)
{
    tess_int liw, lrw, v = 0, e, i, wrong = 0;
    double volume, low, high, least, most, ball;
    int code, bad = 0;

    if (argc > 3) {
        if (!read_points(argv[3])) {
            printf("cannot read %s\n", argv[3]);
            return 1;
        }
    } else
        ellipsoid();
    code = tess_size(n, MAXTET, &liw, &lrw);
    if (code != 0 || liw > MAXIW || lrw > MAXRW) {
        printf("the arrays are too short\n");
        return 1;
    }
    code = tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
    if (code == TESS_OK)
        code = tess_hull(ntet, tet, adj, MAXFAC, &nfac, fac);
    if (code != TESS_OK) {
        printf("tess: code %d\n", code);
        return 1;
    }

    for (i = 0; i < n; i++) number[i] = 0;
    for (i = 0; i < 3 * nfac; i++) number[fac[i]] = 1;
    for (i = 0; i < n; i++) {
        v += number[i];
        if (number[i] != (i < OUTSIDE)) wrong++;
    }
    e = 3 * nfac / 2;
    volume = enclosed();
    printf("points             %ld\n", (long)n);
    printf("tetrahedra         %ld\n", (long)ntet);
    printf("surface            %ld vertices, %ld edges, %ld triangles\n",
           (long)v, (long)e, (long)nfac);
    printf("volume             %.6g\n", volume);
    if (!closed()) bad |= 1;
    if (v - e + nfac != 2) bad |= 2;
    if (fabs(volume - filled()) > 1e-12 * volume) bad |= 4;
    if (argc <= 3) {
        range(&least, &most);
        ball = 16.0 / 3.0 * atan(1.0) * axis[0] * axis[1] * axis[2];
        low = ball * least * least * least;
        high = ball * most * most * most;
        printf("ellipsoids         %.6g inside, %.6g outside\n", low, high);
        if (volume < low || volume > high || high > ball * (1.0 + 1e-5))
            bad |= 8;
        if (wrong != 0) bad |= 16;
    }
    if ((argc > 1 && !write_obj(argv[1])) ||
        (argc > 2 && !write_stl(argv[2]))) {
        printf("cannot write\n");
        return 1;
    }
    if (argc > 2 && fabs(stl_volume(argv[2]) - volume) > 1e-6 * volume)
        bad |= 32;
    printf("the surface is closed:                        %s\n"
           "Euler's relation holds:                       %s\n"
           "it encloses the volume of the tetrahedra:     %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes");
    if (argc > 2)
        printf("so does the STL file, read again:             %s\n",
               bad & 32 ? "NO" : "yes");
    if (argc <= 3)
        printf("it is between those of the two ellipsoids:    %s\n"
               "its vertices are the points on the ellipsoid: %s\n",
               bad & 8 ? "NO" : "yes", bad & 16 ? "NO" : "yes");
    return bad != 0;
}
