/* figure4.c - figure4 [-check]: the paper's rule for cospherical points (Figure
 * 4), taken word for word, on the corners of a cube.
 *
 * Of a facet f, let A be the points of least L-coordinate, here all on its open
 * side, and a the point of least number of A and f's vertices.  If a is in A it
 * is the apex; if it is a vertex of f, the apex is the point of least number
 * that gift-wraps the edge of f opposite to a.
 *
 * All 5,040 numberings that are not one another's by a turn or a reflection
 * that moves number 0: number 0 is at the origin.  And 200 of all, by chance.
 * The first facet is one that the rule allows: a triangle of a face, with number
 * 0 and the corner opposite to it in the face.  Open facets are taken in the
 * order in which they came, or the last one first.  A cover is wrong if its
 * tetrahedra, all positively oriented, do not add up to the cube's volume, or
 * there is no end of them.  All is computed in small integers.  Beside it: the
 * library's tetrahedra of the same points.
 */
#include <stdio.h>
#include <string.h>
#include "../../tess.h"

#define CORNERS 8
#define MANY 100  /* tetrahedra, of which a cube has 5 or 6 */
#define CHANCE 200

typedef struct facet { int v[3]; } facet;

static int p[CORNERS][3];
static facet open[4 * MANY];
static int nopen;

/* volume - six times that of the tetrahedron f, z: positive on f's open side. */
static int volume(const facet *f, int z)
{
    const int *a = p[f->v[0]];
    int e[3][3], i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            e[i][k] = (i < 2 ? p[f->v[i + 1]][k] : p[z][k]) - a[k];
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
           e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/* cross, dot - products of vectors */
static void cross(const int *a, const int *b, int *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static int dot(const int *a, const int *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* wrapped - the point of least number that gift-wraps the edge of f opposite to
 * its vertex k: of those on the open side that of least c (see hh_wrap), here
 * up to a positive factor. */
static int wrapped(const facet *f, int k)
{
    const int *p1 = p[f->v[(k + 1) % 3]], *p2 = p[f->v[(k + 2) % 3]];
    int e[3], h[3], w[3], v[3], g[3], best = -1, over = 0, under = 1, z, i, c, d;

    for (i = 0; i < 3; i++) {
        e[i] = p2[i] - p1[i];
        h[i] = p[f->v[k]][i] - p1[i];
    }
    cross(e, h, v);
    cross(v, e, g);
    for (z = 0; z < CORNERS; z++) {
        if (volume(f, z) <= 0) continue;
        for (i = 0; i < 3; i++) w[i] = p[z][i] - p1[i];
        c = -dot(w, g);
        d = dot(w, v);
        if (best >= 0 && c * under >= over * d) continue;
        best = z;
        over = c;
        under = d;
    }
    return best;
}

/* apex - Figure 4's, or -1. */
static int apex(const facet *f)
{
    int least = -1, z, k;

    for (z = CORNERS - 1; z >= 0; z--)
        if (volume(f, z) > 0) least = z;
    if (least < 0) return -1;
    for (k = 0; k < 3; k++)
        if (f->v[k] < least && f->v[k] <= f->v[(k + 1) % 3] &&
            f->v[k] <= f->v[(k + 2) % 3])
            return wrapped(f, k);
    return least;
}

/* has - 1 if z is a vertex of f. */
static int has(const facet *f, int z)
{
    return f->v[0] == z || f->v[1] == z || f->v[2] == z;
}

/* put - the facet a b c of a tetrahedron whose fourth vertex is d: open, or no
 * longer so. */
static void put(int a, int b, int c, int d)
{
    facet f;
    int i;

    f.v[0] = a;
    f.v[1] = b;
    f.v[2] = c;
    if (volume(&f, d) > 0) {
        f.v[1] = c;
        f.v[2] = b;
    }
    for (i = 0; i < nopen; i++) {
        if (!has(&open[i], a) || !has(&open[i], b) || !has(&open[i], c)) continue;
        nopen--;
        memmove(open + i, open + i + 1, (size_t)(nopen - i) * sizeof *open);
        return;
    }
    open[nopen++] = f;
}

/* literal - 1 if the cover by Figure 4 is right. */
static int literal(int last)
{
    facet f;
    int a, b, c, z, i, k, diagonal, sum = 0, n = 0;

    /* a face's triangle, its other corners on the open side */
    nopen = 0;
    for (i = 0; i < CORNERS * CORNERS * CORNERS && nopen == 0; i++) {
        f.v[0] = i / CORNERS / CORNERS;
        f.v[1] = i / CORNERS % CORNERS;
        f.v[2] = i % CORNERS;
        if (f.v[0] != 0 || f.v[1] == 0 || f.v[2] == 0 || f.v[1] == f.v[2])
            continue;
        for (z = k = 0; z < CORNERS; z++) k += volume(&f, z) > 0;
        for (z = 0; z < CORNERS; z++)
            if (volume(&f, z) < 0) k = 0;
        for (diagonal = 0, z = 1; z < 3; z++) {
            for (a = b = 0; a < 3; a++) b += p[f.v[z]][a] != p[0][a];
            diagonal |= b == 2;
        }
        if (k == 4 && diagonal) open[nopen++] = f;
    }
    while (nopen > 0) {
        f = open[last ? nopen - 1 : 0];
        nopen--;
        if (!last) memmove(open, open + 1, (size_t)nopen * sizeof *open);
        z = apex(&f);
        if (z < 0) continue;
        if (++n > MANY) return 0;
        sum += volume(&f, z);
        a = f.v[0];
        b = f.v[1];
        c = f.v[2];
        put(a, b, z, c);
        put(b, c, z, a);
        put(c, a, z, b);
    }
    return sum == 6;
}

/* ours - 1 if the library's cover is right. */
static int ours(void)
{
    static tess_int tet[4 * MANY], adj[4 * MANY], iw[TESS_LIW(CORNERS)];
    static double rw[TESS_LRW(CORNERS)];
    tess_real q[3 * CORNERS];
    tess_int t, ntet;
    facet f;
    int i, k, sum = 0;

    for (i = 0; i < CORNERS; i++)
        for (k = 0; k < 3; k++) q[3 * i + k] = (tess_real)p[i][k];
    if (tess(CORNERS, q, MANY, &ntet, tet, adj, TESS_LIW(CORNERS), iw,
             TESS_LRW(CORNERS), rw) != 0)
        return 0;
    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 3; k++) f.v[k] = (int)tet[4 * t + k];
        k = volume(&f, (int)tet[4 * t + 3]);
        if (k <= 0) return 0;
        sum += k;
    }
    return sum == 6 && tess_check(CORNERS, q, ntet, tet, adj,
                                  TESS_LIW(CORNERS), iw, &t) == 0;
}

/* wrong[0], wrong[1]: by the rule, open facets in turn, the last one first;
 * wrong[2]: by the library */
static void count(const int *corner, int *wrong)
{
    int i, k;

    for (i = 0; i < CORNERS; i++)
        for (k = 0; k < 3; k++) p[i][k] = corner[i] >> k & 1;
    wrong[0] += !literal(0);
    wrong[1] += !literal(1);
    wrong[2] += !ours();
}

/* all - every order of corner[from ...] */
static int all(int *corner, int from, int *wrong)
{
    int i, c, n = 0;

    if (from == CORNERS) {
        count(corner, wrong);
        return 1;
    }
    for (i = from; i < CORNERS; i++) {
        c = corner[from];
        corner[from] = corner[i];
        corner[i] = c;
        n += all(corner, from + 1, wrong);
        corner[i] = corner[from];
        corner[from] = c;
    }
    return n;
}

static int test(const char *what, int ok)
{
    static int tests;

    printf("%s %d - %s\n", ok ? "ok" : "not ok", ++tests, what);
    return !ok;
}

int main(int argc, char **argv)
{
    int corner[CORNERS], wrong[3] = {0, 0, 0}, some[3] = {0, 0, 0};
    int c, n, i, j, k;
    unsigned long seed = 1;

    for (i = 0; i < CORNERS; i++) corner[i] = i;
    n = all(corner, 1, wrong);
    if (n != 5040) return 2;
    for (k = 0; k < CHANCE; k++) {
        for (i = CORNERS - 1; i > 0; i--) {
            seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
            j = (int)((seed >> 16) % (unsigned long)(i + 1));
            c = corner[i];
            corner[i] = corner[j];
            corner[j] = c;
        }
        count(corner, some);
    }
    if (argc > 1 && strcmp(argv[1], "-check") == 0) {
        k = test("the rule word for word: not all covers are right",
                 wrong[0] > 0 && wrong[1] > 0 && wrong[0] < n && wrong[1] < n);
        k += test("the library: all covers are right",
                  wrong[2] == 0 && some[2] == 0);
        printf("1..2\n");
        return k != 0;
    }
    printf("                                    of all %d   of %d by chance\n",
           n, CHANCE);
    printf("  Figure 4, open facets in turn         %6d            %6d\n",
           wrong[0], some[0]);
    printf("  Figure 4, the last one first          %6d            %6d\n",
           wrong[1], some[1]);
    printf("  the library                           %6d            %6d\n",
           wrong[2], some[2]);
    return 0;
}
