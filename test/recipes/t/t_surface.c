/* t_surface.c - surface.c's hull of points, written as OBJ and as STL.
 *
 *   cc -O2 -I. -o t_surface test/recipes/t/t_surface.c \
 *       test/recipes/surface.c tess.c hhpred.c -lm
 *   t_surface [hull.obj [hull.stl [points.xyz]]]
 *
 * Linked with twin/recipes.c it tests surface.f.
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

#include "../recipes.h"

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
static tess_int fac[3 * MAXFAC], sides[6 * MAXFAC], number[MAXPTS];
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

/* written - is the surface, once more in another form? */
static int written(const char *name, int stl)
{
    FILE *file = fopen(name, "w");
    int bad;

    if (!file) return 0;
    bad = stl ? tr_stl(file, p, nfac, fac, 9)
              : tr_obj(file, n, p, nfac, fac, 9, number);
    return fclose(file) == 0 && !bad;
}

/* ---------------------------------------------------------------- volume */

/* cross - c = the cross product of two edges of the triangle q. */
static void cross(double q[3][3], double *c)
{
    int k, i, j;

    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = (k + 2) % 3;
        c[k] = (q[1][i] - q[0][i]) * (q[2][j] - q[0][j]) -
               (q[1][j] - q[0][j]) * (q[2][i] - q[0][i]);
    }
}

/* cone - the volume between the triangle q and the point o. */
static double cone(double q[3][3], const double *o)
{
    double c[3];

    cross(q, c);
    return ((q[0][0] - o[0]) * c[0] + (q[0][1] - o[1]) * c[1] +
            (q[0][2] - o[2]) * c[2]) /
           6.0;
}

static void first_point(double *o)
{
    int k;

    for (k = 0; k < 3; k++) o[k] = (double)p[3 * fac[0] + k];
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

/* obj_volume - the same of an OBJ file, which has many points. */
static double obj_volume(const char *name, long many)
{
    static double v[3 * MAXPTS];
    FILE *file = fopen(name, "r");
    char line[200];
    double q[3][3], sum = 0.0;
    long at = 0, f[3];
    int i;

    if (!file) return 0.0;
    while (fgets(line, (int)sizeof line, file))
        if (sscanf(line, "v %lf %lf %lf", v + 3 * at, v + 3 * at + 1,
                   v + 3 * at + 2) == 3) {
            if (++at == MAXPTS) break;
        } else if (sscanf(line, "f %ld %ld %ld", f, f + 1, f + 2) == 3) {
            for (i = 0; i < 9; i++) q[i / 3][i % 3] = v[3 * f[i / 3] - 3 + i % 3];
            sum += cone(q, v);
        }
    fclose(file);
    return at == many ? sum : 0.0;
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
        sides[2 * i] = fac[i];
        sides[2 * i + 1] = fac[k == 2 ? i - 2 : i + 1];
    }
    qsort(sides, many, 2 * sizeof *sides, by_ends);
    for (i = 0; i < many; i++) {
        if (i > 0 && by_ends(sides + 2 * i - 2, sides + 2 * i) == 0) return 0;
        back[0] = sides[2 * i + 1];
        back[1] = sides[2 * i];
        if (!bsearch(back, sides, many, sizeof back, by_ends)) return 0;
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
        for (i = 0; i < 9; i++)
            q[i / 3][i % 3] = (double)p[3 * fac[3 * f + i / 3] + i % 3];
        for (i = 0; i < 3; i++) {
            for (k = 0; k < 3; k++) q[i][k] /= axis[k];
            d = sqrt(q[i][0] * q[i][0] + q[i][1] * q[i][1] +
                     q[i][2] * q[i][2]);
            if (d > *most) *most = d;
        }
        cross(q, c);
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
    volume = tr_enclosed(p, nfac, fac);
    printf("points             %ld\n", (long)n);
    printf("tetrahedra         %ld\n", (long)ntet);
    printf("surface            %ld vertices, %ld edges, %ld triangles\n",
           (long)v, (long)e, (long)nfac);
    printf("volume             %.4f\n", volume);
    if (!closed()) bad |= 1;
    if (v - e + nfac != 2) bad |= 2;
    if (fabs(volume - filled()) > 1e-12 * volume) bad |= 4;
    if (argc <= 3) {
        range(&least, &most);
        ball = 16.0 / 3.0 * atan(1.0) * axis[0] * axis[1] * axis[2];
        low = ball * least * least * least;
        high = ball * most * most * most;
        printf("ellipsoids         %.4f inside, %.4f outside\n", low, high);
        if (volume < low || volume > high || high > ball * (1.0 + 1e-5))
            bad |= 8;
        if (wrong != 0) bad |= 16;
    }
    if ((argc > 1 && !written(argv[1], 0)) ||
        (argc > 2 && !written(argv[2], 1))) {
        printf("cannot write\n");
        return 1;
    }
    if (argc > 1 && fabs(obj_volume(argv[1], (long)v) - volume) > 1e-6 * volume)
        bad |= 32;
    if (argc > 2 && fabs(stl_volume(argv[2]) - volume) > 1e-6 * volume)
        bad |= 32;
    printf("the surface is closed:                        %s\n"
           "Euler's relation holds:                       %s\n"
           "it encloses the volume of the tetrahedra:     %s\n",
           bad & 1 ? "NO" : "yes", bad & 2 ? "NO" : "yes",
           bad & 4 ? "NO" : "yes");
    if (argc > 1)
        printf("so do the files, read again:                  %s\n",
               bad & 32 ? "NO" : "yes");
    if (argc <= 3)
        printf("it is between those of the two ellipsoids:    %s\n"
               "its vertices are the points on the ellipsoid: %s\n",
               bad & 8 ? "NO" : "yes", bad & 16 ? "NO" : "yes");
    return bad != 0;
}
