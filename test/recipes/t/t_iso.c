/* t_iso.c - iso.c's surfaces of fields whose areas and volumes are known.
 *
 *   cc -O2 -I. -o t_iso test/recipes/t/t_iso.c \
 *       test/recipes/iso.c tess.c hhpred.c -lm
 *
 * Linked with twin/recipes.c it tests iso.f.
 *
 * The points fill the unit cube and have its corners.  Of each surface, open
 * and closed: every point is on an edge of the mesh, where the field is level,
 * and no two are on the same one; no triangle has a point twice, no two
 * triangles have the same points; an edge has as many triangles one way as the
 * other, unless it is on the hull; the closed one encloses what of each
 * tetrahedron is above the level, by a formula for that.  Too little room is
 * found, and nothing is written beyond it.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../recipes.h"

#define N 700
#define MAXTET (8 * N)
#define MAXPT (6 * N)
#define MAXTRI (12 * N)
#define GUARD 77

static tess_real p[3 * N], x[3 * MAXPT + 3];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static tess_int ends[2 * MAXPT + 2], tri[3 * MAXTRI + 3];
static tess_int work[2 * MAXPT + 2], side[6 * MAXTRI], rows[3 * MAXTRI];
static double rw[TESS_LRW(N)], value[N];
static char outer[N]; /* is the point on the hull? */
static tess_int ntet, npt, ntri;
static int bad;

/* check - a sentence, once. */
static void check(int good, const char *what, const char *field)
{
    if (good) return;
    printf("%s: NOT %s\n", field, what);
    bad = 1;
}

static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 12) / 1048576.0;
}

static int known(tess_int t)
{
    int k;

    if (t < 0) return 0;
    for (k = 0; k < 4; k++)
        if (!(fabs(value[tet[4 * t + k]]) <= DBL_MAX)) return 0;
    return 1;
}

/* ---- tetrahedra ---- */

static double volume_of(tess_int t)
{
    double e[3][3];
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            e[i][k] = (double)p[3 * tet[4 * t + i + 1] + k] -
                      (double)p[3 * tet[4 * t] + k];
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6.0;
}

/* part_of - (f - level) / (f - g), of numbers as large as doubles are. */
static double part_of(double f, double level, double g)
{
    return (f / 4.0 - level / 4.0) / (f / 4.0 - g / 4.0);
}

/* corner - the part of a tetrahedron that the level cuts off with the vertex of
 * value f from those of values g. */
static double corner(double f, const double *g, double level)
{
    double part = 1.0;
    int k;

    for (k = 0; k < 3; k++) part *= part_of(f, level, g[k]);
    return part;
}

/* above - the part of tetrahedron t that is above the level.  Two vertices
 * above, two below: an edge between them is cut at the level, which makes two
 * tetrahedra that have corners. */
static double above(tess_int t, double level)
{
    double up[4], down[4], f, g[3], s;
    int ups = 0, downs = 0, k;

    for (k = 0; k < 4; k++) {
        f = value[tet[4 * t + k]];
        if (f >= level)
            up[ups++] = f;
        else
            down[downs++] = f;
    }
    if (ups == 0 || downs == 0) return downs == 0;
    if (ups == 1) return corner(up[0], down, level);
    if (downs == 1) return 1.0 - corner(down[0], up, level);
    s = part_of(up[0], level, down[0]);
    g[0] = up[0];
    g[1] = up[1];
    g[2] = level;
    f = s * (1.0 - corner(down[1], g, level));
    g[0] = level;
    g[1] = down[0];
    g[2] = down[1];
    return f + (up[1] > level ? (1.0 - s) * corner(up[1], g, level) : 0.0);
}

/* ---- a surface ---- */

/* sizes - its area, and the volume that it encloses. */
static void sizes(double *area, double *volume, double *sum)
{
    double a[3], b[3], c[3];
    const tess_real *o;
    tess_int f;
    int i, j, k;

    *area = *volume = sum[0] = sum[1] = sum[2] = 0.0;
    for (f = 0; f < ntri; f++) {
        o = x + 3 * tri[3 * f];
        for (k = 0; k < 3; k++) {
            a[k] = (double)x[3 * tri[3 * f + 1] + k] - (double)o[k];
            b[k] = (double)x[3 * tri[3 * f + 2] + k] - (double)o[k];
        }
        for (k = 0; k < 3; k++) {
            i = (k + 1) % 3;
            j = (k + 2) % 3;
            c[k] = a[i] * b[j] - a[j] * b[i];
            *volume += (double)o[k] * c[k] / 6.0;
            sum[k] += c[k] / 2.0;
        }
        *area += sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]) / 2.0;
    }
}

static int by_numbers(const void *u, const void *v, int many)
{
    const tess_int *a = (const tess_int *)u, *b = (const tess_int *)v;

    for (; many > 0; many--, a++, b++)
        if (*a != *b) return *a < *b ? -1 : 1;
    return 0;
}

static int by_two(const void *u, const void *v)
{
    return by_numbers(u, v, 2);
}

static int by_three(const void *u, const void *v)
{
    return by_numbers(u, v, 3);
}

static int by_one(const void *u, const void *v)
{
    return by_numbers(u, v, 1);
}

/* edge_of_mesh - is a b one? */
static int edge_of_mesh(tess_int a, tess_int b)
{
    tess_int t;
    int k, has;

    for (t = 0; t < ntet; t++) {
        for (has = 0, k = 0; k < 4; k++)
            has |= tet[4 * t + k] == a ? 1 : tet[4 * t + k] == b ? 2 : 0;
        if (has == 3) return 1;
    }
    return 0;
}

/* check_points - where they are; all of them are of triangles. */
static void check_points(const char *field, double level, int closed)
{
    double w, f, g, far, q;
    tess_int i, a, b;
    int k;

    memset(work, 0, sizeof work);
    for (i = 0; i < 3 * ntri; i++) {
        check(tri[i] >= 0 && tri[i] < npt, "points of triangles", field);
        work[tri[i]] = 1;
    }
    for (i = 0; i < npt; i++) {
        a = ends[2 * i];
        b = ends[2 * i + 1];
        f = value[a];
        g = value[b];
        check(work[i] == 1, "all points used", field);
        if (a == b) {
            check(f >= level && f <= (closed && outer[a] ? DBL_MAX : level),
                  "points at the level", field);
        } else {
            check(a < b && ((f < level && g > level) ||
                            (f > level && g < level)),
                  "edges that cross the level", field);
            check(edge_of_mesh(a, b), "edges of the mesh", field);
        }
        w = a == b ? 0.0 : part_of(f, level, g);
        for (k = 0; k < 3; k++) {
            far = (double)p[3 * b + k] - (double)p[3 * a + k];
            q = (double)p[3 * a + k] + w * far;
            check(fabs((double)x[3 * i + k] - q) <= 4.0 * DBL_EPSILON,
                  "where the field is level", field);
            check(fabs((double)x[3 * i + k] - (double)p[3 * a + k]) <=
                          fabs(far) &&
                      fabs((double)x[3 * i + k] - (double)p[3 * b + k]) <=
                          fabs(far), "between the ends", field);
        }
    }
    memcpy(side, ends, 2 * (size_t)npt * sizeof *ends);
    qsort(side, (size_t)npt, 2 * sizeof *side, by_two);
    for (i = 1; i < npt; i++)
        check(by_two(side + 2 * i - 2, side + 2 * i) != 0, "points once",
              field);
}

/* on_hull - can the edge from point a to point b of the surface be? */
static int on_hull(tess_int a, tess_int b)
{
    return outer[ends[2 * a]] && outer[ends[2 * a + 1]] &&
           outer[ends[2 * b]] && outer[ends[2 * b + 1]];
}

/* check_triangles - their points, and edges: once = 1: one each way. */
static void check_triangles(const char *field, int closed, int once)
{
    tess_int i, j, k, back[2], *found, one, other;

    for (i = 0; i < 3 * ntri; i++) rows[i] = tri[i];
    for (i = 0; i < ntri; i++) {
        qsort(rows + 3 * i, 3, sizeof *rows, by_one);
        check(rows[3 * i] < rows[3 * i + 1] &&
                  rows[3 * i + 1] < rows[3 * i + 2],
              "three points a triangle", field);
    }
    qsort(rows, (size_t)ntri, 3 * sizeof *rows, by_three);
    for (i = 1; i < ntri; i++)
        check(by_three(rows + 3 * i - 3, rows + 3 * i) != 0, "triangles once",
              field);
    for (i = 0; i < 3 * ntri; i++) {
        side[2 * i] = tri[i];
        side[2 * i + 1] = tri[i % 3 == 2 ? i - 2 : i + 1];
    }
    qsort(side, 3 * (size_t)ntri, 2 * sizeof *side, by_two);
    for (i = 0; i < 3 * ntri; i = j) {
        for (j = i; j < 3 * ntri && by_two(side + 2 * i, side + 2 * j) == 0;)
            j++;
        one = j - i;
        back[0] = side[2 * i + 1];
        back[1] = side[2 * i];
        found = (tess_int *)bsearch(back, side, 3 * (size_t)ntri,
                                    2 * sizeof *side, by_two);
        other = 0;
        if (found) {
            k = (tess_int)(found - side) / 2;
            while (k > 0 && by_two(side + 2 * k - 2, back) == 0) k--;
            while (k + other < 3 * ntri &&
                   by_two(side + 2 * (k + other), back) == 0)
                other++;
        }
        check(one == other || (!closed && on_hull(back[0], back[1])),
              "as many triangles one way as the other", field);
        check(one == 1 || !once, "each edge once a way", field);
    }
}

/* make - the surface, with so much room. */
static int make(double level, int closed, tess_int maxpt, tess_int maxtri)
{
    return tr_iso(p, ntet, tet, adj, value, level, closed, maxpt, &npt, x, ends,
                  maxtri, &ntri, tri, work);
}

/* check_room - one too few of each; exactly enough. */
static void check_room(const char *field, double level, int closed)
{
    tess_int points = npt, triangles = ntri;

    if (triangles == 0) return;
    tri[3 * triangles - 3] = GUARD + MAXPT;
    check(make(level, closed, MAXPT, triangles - 1) == 1 && ntri == triangles &&
              tri[3 * triangles - 3] == GUARD + MAXPT,
          "too few triangles told", field);
    check(make(level, closed, points - 1, triangles) == 2 && ntri == triangles,
          "too few points told", field);
    check(make(level, closed, 0, 0) == 1 && ntri == triangles, "counted",
          field);
    ends[2 * points] = tri[3 * triangles] = work[2 * points + 1] = GUARD;
    x[3 * points] = (tess_real)GUARD;
    check(make(level, closed, points, triangles) == 0 && npt == points &&
              ntri == triangles, "exact room enough", field);
    check(ends[2 * points] == GUARD && tri[3 * triangles] == GUARD &&
              work[2 * points + 1] == GUARD &&
              x[3 * points] - (tess_real)GUARD == (tess_real)0.0,
          "within the arrays", field);
}

/* both - surfaces of a level; returns the open one's area and the closed one's
 * volume. */
static void both(const char *field, double level, int once, double *size,
                 double *sum)
{
    double volume = 0.0, area, other[3];
    tess_int t;
    int closed;

    for (t = 0; t < ntet; t++)
        if (known(t)) volume += volume_of(t) * above(t, level);
    printf("%-24s", field);
    for (closed = 0; closed < 2; closed++) {
        check(make(level, closed, MAXPT, MAXTRI) == 0, "made", field);
        printf(" %5ld points %5ld triangles", (long)npt, (long)ntri);
        check_points(field, level, closed);
        check_triangles(field, closed, once);
        sizes(closed ? &area : size, size + 1, closed ? other : sum);
        check_room(field, level, closed);
    }
    printf("\n");
    check(fabs(size[1] - volume) <= 1e-13, "the volume above the level", field);
}

/* check_long - an edge from 1e16 to 0.3, cut so near to its end there that
 * from the other one all digits would be lost.  One tetrahedron; end: which of
 * the edge's points that is. */
static void check_long(int end)
{
    double w = DBL_EPSILON / 2.0;
    tess_int i, found = 0;

    ntet = 1;
    for (i = 0; i < 4; i++) {
        tet[i] = i;
        adj[i] = TESS_NONE;
        value[i] = 0.0;
    }
    memset(p, 0, 12 * sizeof *p);
    p[3 * end] = (tess_real)0.3;
    p[3 - 3 * end] = (tess_real)1e16;
    p[7] = p[11] = (tess_real)1.0;
    value[end] = 1.0;
    check(make(1.0 - w, 0, MAXPT, MAXTRI) == 0 && npt == 3 && ntri == 1,
          "a triangle", "a long edge");
    for (i = 0; i < npt; i++)
        if (ends[2 * i] == 0 && ends[2 * i + 1] == 1) {
            found++;
            check(fabs((double)x[3 * i] - (0.3 + w * 1e16)) <= 1e-15,
                  "where the field is level", "a long edge");
        }
    check(found == 1, "cut", "a long edge");
}

/* mesh - the points: the cube's corners, some on its sides, others within. */
static int mesh(void)
{
    tess_int nfac, i;
    int code, k;

    for (i = 0; i < N; i++)
        for (k = 0; k < 3; k++)
            p[3 * i + k] = (tess_real)(i < 8        ? (double)(i >> k & 1)
                                       : i % 30 == k ? (double)(i % 2)
                                                     : random01());
    code = tess(N, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw);
    if (code == TESS_OK) code = tess_hull(ntet, tet, adj, MAXTRI, &nfac, tri);
    for (i = 0; i < 3 * nfac && code == TESS_OK; i++) outer[tri[i]] = 1;
    return code;
}

int main(void)
{
    double size[2], sum[3], a, b, c, whole = 1.0;
    tess_int i, t;

    if (mesh() != TESS_OK) return 1;
    /* a plane, normals to where x is less; and one askew */
    for (i = 0; i < N; i++) value[i] = (double)p[3 * i];
    both("x = 0.4", 0.4, 1, size, sum);
    check(fabs(size[0] - 1.0) <= 1e-13 && fabs(sum[0] + 1.0) <= 1e-13 &&
              fabs(sum[1]) <= 1e-13 && fabs(sum[2]) <= 1e-13 &&
              fabs(size[1] - 0.6) <= 1e-13, "its area, normal, volume", "x");
    for (i = 0; i < N; i++)
        value[i] = (double)p[3 * i] + (double)p[3 * i + 1] +
                   (double)p[3 * i + 2];
    both("x + y + z = 0.75", 0.75, 1, size, sum);
    a = 0.75 * 0.75 / 2.0;
    check(fabs(size[0] - a * sqrt(3.0)) <= 1e-13 && fabs(sum[0] + a) <= 1e-13 &&
              fabs(size[1] - 1.0 + 0.75 * a / 3.0) <= 1e-13,
          "its area, normal, volume", "x + y + z");
    /* a ball, in parts of 2^-16: closed without the hull */
    for (i = 0; i < N; i++) {
        a = (double)p[3 * i] - 0.5;
        b = (double)p[3 * i + 1] - 0.5;
        c = (double)p[3 * i + 2] - 0.5;
        value[i] = floor((a * a + b * b + c * c) * -65536.0) / 65536.0;
    }
    both("a ball", -0.1000001, 1, size, sum);
    check(fabs(sum[0]) + fabs(sum[1]) + fabs(sum[2]) <= 1e-13 && size[0] > 1.0,
          "closed", "a ball");
    /* few whole numbers: many values are the level, and plateaus */
    for (i = 0; i < N; i++) value[i] = floor(random01() * 4.0);
    both("0 1 2 3 at 1.5", 1.5, 1, size, sum);
    both("0 1 2 3 at 1", 1.0, 0, size, sum);
    both("0 1 2 3 at 2", 2.0, 0, size, sum);
    both("0 1 2 3 at 0", 0.0, 0, size, sum);
    check(fabs(size[1] - 1.0) <= 1e-13 && size[0] <= 0.0, "the cube",
          "0 1 2 3 at 0");
    both("0 1 2 3 at 3", 3.0, 0, size, sum);
    both("0 1 2 3 at 4", 4.0, 1, size, sum);
    check(ntri == 0, "nothing", "0 1 2 3 at 4");
    /* half of the cube is at the level: facets between that and what is
     * below are of the surface, whichever side has them */
    for (i = 0; i < N; i++) value[i] = (double)p[3 * i] < 0.5 ? 0.0 : 1.0;
    both("a plateau at 1", 1.0, 0, size, sum);
    for (i = 0; i < N; i++) value[i] = -value[i];
    both("a plateau at 0", 0.0, 0, size, sum);
    /* one value is NaN, one is infinite: so many tetrahedra are not there */
    for (i = 0; i < N; i++) value[i] = (double)p[3 * i + 1];
    value[100] = HUGE_VAL;
    value[200] = HUGE_VAL - HUGE_VAL;
    for (t = 0; t < ntet; t++)
        if (!known(t)) {
            whole -= volume_of(t);
            for (i = 0; i < 4; i++) outer[tet[4 * t + i]] = 1;
        }
    check(whole < 1.0, "some left out", "NaN");
    both("NaN, infinity", 0.5, 0, size, sum);
    /* numbers whose differences are beyond doubles */
    for (i = 0; i < N; i++)
        value[i] = (double)(i % 3 - 1) * (DBL_MAX / (1.0 + random01()));
    both("large numbers", 1e292, 1, size, sum);
    check(make(HUGE_VAL, 1, MAXPT, MAXTRI) == 0 && ntri == 0 &&
              make(HUGE_VAL - HUGE_VAL, 1, MAXPT, MAXTRI) == 0 && ntri == 0,
          "nothing", "infinite level, NaN");
    check_long(0);
    check_long(1);
    printf(bad ? "WRONG\n" : "all as it should be\n");
    return bad;
}
