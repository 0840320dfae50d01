/* t_periodic.c - periodic.c's tetrahedra of several sets of points, in boxes
 * and other cells: facets are paired, Euler's formula holds, volumes fill the
 * cell.
 *
 *   cc -O2 -I. -o t_periodic test/recipes/t/t_periodic.c \
 *       test/recipes/periodic.c tess.c hhpred.c -lm
 *
 * Linked with twin/recipes.c it tests periodic.f.
 */
#include <math.h>
#include <stdio.h>

#include "../recipes.h"

#define N 512
#define SETS 15
#define MAXCOP 16000
#define MAXTET (24 * N)

static tess_real p[3 * N], x[3 * MAXCOP];
static tess_int cw[3 * MAXCOP], tet[4 * MAXTET], move[4 * MAXTET];
static tess_int adj[4 * MAXTET], shift[4 * MAXTET], iw[TESS_LIW(MAXCOP)];
static double rw[TESS_LRW(MAXCOP)];
static const double low[3] = {-1.0, 0.0, 2.0};

/* random20 - a random number, 0 <= x < 1, of 20 bits. */
static double random20(void)
{
    static long seed = 1;
    long high;

    seed = (seed * 3877 + 29573) % 139968;
    high = seed % 1024;
    seed = (seed * 3877 + 29573) % 139968;
    return ((double)high + (double)(seed % 1024) / 1024.0) / 1024.0;
}

/* make - points of a set, in a cell with these ways; its name. */
static const char *make(int set, tess_int *n, double *cell, tess_int *ways)
{
    static const char *const name[SETS] = {
        "random", "lattice", "clusters", "one", "three", "twice", "huge",
        "tiny", "skew", "sheared", "fcc", "two", "slab", "sheet", "rod"};
    static const tess_int number[SETS] = {500, 512, 300, 1, 3, 400, 300, 300,
                                          300, 300, 1, 2, 300, 2, 300};
    /* in eighths: vectors of the skew cells, short ones */
    static const int skewed[9] = {8, 0, 0, 3, 7, 0, -2, 3, 9};
    static const int centred[9] = {0, 4, 4, 4, 0, 4, 4, 4, 0};
    double r[3];
    tess_int i, j;
    int k;

    *n = number[set];
    for (k = 0; k < 9; k++) cell[k] = k % 4 == 0 ? 1.0 : 0.0;
    if (set == 0) cell[0] = 2.0;
    if (set == 0) cell[4] = 1.5;
    for (k = 0; k < 9 && set > 7; k++)
        cell[k] = (set == 10 ? centred[k] : skewed[k]) / 8.0;
    for (k = 0; k < 3; k++) {
        cell[9 + k] = low[k];
        /* the slab, and a sheet of two layers, have upright sides */
        if (set == 12 || set == 13) cell[6 + k] = k < 2 ? 0.0 : 1.0;
        ways[k] = set < 12 || (k < 2) != (set == 14);
    }
    for (i = 0; i < *n; i++) {
        for (k = 0; k < 3; k++) {
            r[k] = random20();
            if (set == 2) r[k] = 0.25 * r[k] + 0.5 * (double)(i % 2);
            /* a shuffled lattice of 8 a side: 257 and 512 have no factor in
             * common */
            j = (tess_int)((long)i * 257 % 512);
            if (set == 1)
                r[k] = (double)(k == 0 ? j % 8 : k == 1 ? j / 8 % 8 : j / 64) /
                       8;
        }
        if ((set == 12 || set == 13) && i < 2) r[2] = (double)i;
        for (k = 0; k < 3; k++) {
            p[3 * i + k] = (tess_real)(low[k] + r[0] * cell[k] +
                                       r[1] * cell[3 + k] + r[2] * cell[6 + k]);
            /* duplicates: in the box, and across its boundary */
            if (set == 5 && i >= 200) p[3 * i + k] = p[3 * (i - 200) + k];
            if (set == 5 && i % 200 < 20 && k == 2)
                p[3 * i + k] = (tess_real)(low[k] + (i < 200 ? 1.0 : 0.0));
        }
    }
    /* the lattice stays the same, but has long vectors */
    for (k = 0; k < 3 && set == 9; k++) cell[3 + k] += 9.0 * cell[k];
    for (k = 0; k < 3 && set == 9; k++) cell[6 + k] -= 5.0 * cell[3 + k];
    return name[set];
}

/* place - of a point's copy, moved; exact, as are the points and vectors. */
static void place(tess_int i, tess_int number, const double *cell,
                  tess_real *at)
{
    int a[3], k;

    tr_unpack(number, a);
    for (k = 0; k < 3; k++)
        at[k] = (tess_real)((double)p[3 * i + k] + a[0] * cell[k] +
                            a[1] * cell[3 + k] + a[2] * cell[6 + k]);
}

/* count_edges - each edge once: in lists by one point, linked in cw.  That of
 * points a, b and the copy of b when a is in the box. */
static tess_int count_edges(tess_int n, tess_int ntet)
{
    static tess_int list[3][12 * MAXTET];
    tess_int i, j, a, b, d, count = 0;
    int k, m;

    for (i = 0; i < n; i++) cw[i] = -1;
    for (i = 0; i < 4 * ntet; i += 4)
        for (k = 0; k < 3; k++)
            for (m = k + 1; m < 4; m++) {
                a = tet[i + k];
                b = tet[i + m];
                d = move[i + m] - move[i + k];
                if (a > b || (a == b && d < 0)) {
                    a = tet[i + m];
                    b = tet[i + k];
                    d = -d;
                }
                for (j = cw[a]; j >= 0 && (list[0][j] != b || list[1][j] != d);)
                    j = list[2][j];
                if (j >= 0) continue;
                list[0][count] = b;
                list[1][count] = d;
                list[2][count] = cw[a];
                cw[a] = count++;
            }
    return count;
}

/* determinant - of three vectors. */
static double determinant(double (*e)[3])
{
    return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
           e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
           e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/* outer - 1 if no point, nor any copy, is beyond facet k of the tetrahedron v:
 * the vectors are in its plane. */
static int outer(tess_int n, tess_real (*v)[3], int k, const double *cell,
                 const tess_int *ways)
{
    static const tess_int number[3] = {1024, 32, 1};
    tess_real at[3], *w[4];
    tess_int i;
    int j, good = 1;

    for (j = 0; j < 4; j++) w[j] = j == k ? at : v[j];
    for (j = 0; j < 3; j++) {
        place(0, number[j], cell, at);
        for (i = 0; i < 3; i++)
            at[i] = (tess_real)((double)at[i] - (double)p[i] +
                                (double)v[(k + 1) % 4][i]);
        if (ways[j] && hh_orient(w[0], w[1], w[2], w[3]) != 0) good = 0;
    }
    for (i = 0; i < n; i++) {
        w[k] = p + 3 * i;
        if (hh_orient(w[0], w[1], w[2], w[3]) < 0) good = 0;
    }
    return good;
}

/* proven - 1 if the facets are paired, or the hull's, of which there are *nfac,
 * all tetrahedra positively oriented and as large as the cell together, and no
 * neighbour's apex is in a ball. */
static int proven(tess_int n, tess_int ntet, double *cell,
                  const tess_int *ways, tess_int *nfac)
{
    tess_real v[5][3];
    double e[3][3], volume = 0.0, whole, unit;
    tess_int t, u, s;
    int h, k, j, good = ntet > 0;

    unit = fabs(cell[6]) + fabs(cell[7]) + fabs(cell[8]);
    for (k = 0; k < 9; k++) e[k / 3][k % 3] = cell[k] / unit;
    whole = determinant(e);
    *nfac = 0;
    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 4; k++)
            place(tet[4 * t + k], move[4 * t + k], cell, v[k]);
        if (hh_orient(v[0], v[1], v[2], v[3]) != 1) good = 0;
        for (k = 0; k < 3; k++)
            for (j = 0; j < 3; j++)
                e[k][j] = ((double)v[k + 1][j] - (double)v[0][j]) / unit;
        volume += determinant(e) / 6.0;
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u == TESS_NONE && !(ways[0] && ways[1] && ways[2])) {
                ++*nfac;
                good &= outer(n, v, k, cell, ways);
                continue;
            }
            if (u < 0 || u >= ntet) return 0;
            /* the vertex of u that is not t's, and three that are */
            h = -1;
            for (j = 0; j < 4; j++) {
                for (s = 0; s < 4; s++)
                    if (s != k && tet[4 * t + s] == tet[4 * u + j] &&
                        move[4 * t + s] ==
                            move[4 * u + j] + shift[4 * t + k]) break;
                if (s < 4) continue;
                if (h >= 0) good = 0;
                h = j;
            }
            if (h < 0) return 0;
            if (adj[4 * u + h] != t ||
                shift[4 * u + h] != -shift[4 * t + k]) good = 0;
            place(tet[4 * u + h], move[4 * u + h] + shift[4 * t + k], cell,
                  v[4]);
            if (hh_insphere(v[0], v[1], v[2], v[3], v[4]) == 1) good = 0;
        }
    }
    /* (what a rod fills is not known) */
    return good && (ways[0] == 0 || fabs(volume - whole) < 1e-12 * whole);
}

/* few - 1 if a long box, points outside and short arrays get their codes. */
static int few(tess_int liw, tess_int lrw)
{
    static const int wanted[9] = {TR_FEW, -2, TESS_MORE, -1, -3, -3, -3,
                                  TESS_RANGE, TESS_RANGE};
    double box[6];
    tess_int ncop, ntet;
    int i, k, good = 1;

    for (k = 0; k < 3; k++) {
        p[k] = (tess_real)low[k];
        box[2 * k] = low[k];
        box[2 * k + 1] = low[k] + (k == 0 ? 64.0 : 1.0);
    }
    for (k = 0; k < 9; k++) {
        if (k == 1) p[0] = (tess_real)(low[0] - 1.0);
        if (k == 2) p[0] = (tess_real)low[0];
        if (k == 2) box[1] = low[0] + 1.0;
        if (k > 3 && k < 7) box[2 * k - 7] = box[2 * k - 8];
        /* boxes of 1e-300 or 1e308, of floats 1e-36 or 1e38, about the point */
        for (i = 0; k > 6 && i < 6; i++) {
            p[i / 2] = 0;
            box[i] = (double)(i % 2) *
                     (sizeof *p > 4 ? k == 7 ? 1e-300 : 1e308
                                    : k == 7 ? 1e-36 : 1e38);
        }
        good &= tr_periodic(k == 3 ? 0 : 1, p, box, k == 2 ? 9 : MAXCOP, &ncop,
                            x, cw, MAXTET, &ntet, tet, move, adj, shift, liw,
                            iw, lrw, rw) == wanted[k];
        if (k > 3 && k < 7) box[2 * k - 7] += 1.0;
    }
    return good;
}

int main(void)
{
    const char *name;
    double cell[12], box[6], scale;
    tess_int ways[3], i, n, ncop, ntet, nedge, nfac, used;
    int set, code, good, k, bad = 0;

    printf("set       points  tetrahedra  edges  Euler  proven\n");
    for (set = 0; set < SETS; set++) {
        name = make(set, &n, cell, ways);
        /* a power of two alters nothing else */
        k = sizeof *p > 4 ? 400 : 100;
        scale = set == 6 ? ldexp(1.0, k) : set == 7 ? ldexp(1.0, -k) : 1.0;
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)((double)p[i] * scale);
        for (k = 0; k < 12; k++) cell[k] *= scale;
        for (k = 0; k < 6; k++)
            box[k] = cell[9 + k / 2] + (k % 2 ? cell[4 * (k / 2)] : 0.0);
        if (set > 7) tr_reduce(cell, ways);
        code = set > 7
                   ? tr_triclinic(n, p, cell, ways, MAXCOP, &ncop, x, cw,
                                  MAXTET, &ntet, tet, move, adj, shift,
                                  TESS_LIW(MAXCOP), iw, TESS_LRW(MAXCOP), rw)
                   : tr_periodic(n, p, box, MAXCOP, &ncop, x, cw, MAXTET, &ntet,
                                 tet, move, adj, shift, TESS_LIW(MAXCOP), iw,
                                 TESS_LRW(MAXCOP), rw);
        if (code != 0) {
            printf("%s: code %d\n", name, code);
            return 1;
        }
        nedge = count_edges(n, ntet);
        /* duplicates have no edges */
        for (used = n, i = 200; i < n && set == 5; i++) used -= cw[i] < 0;
        good = proven(n, ntet, cell, ways, &nfac);
        used += nfac / 2 - nedge + ntet;
        bad |= !good || used != 0;
        printf("%-8s  %6ld  %10ld  %5ld  %5ld  %s\n", name, (long)n,
               (long)ntet, (long)nedge, (long)used, good ? "yes" : "NO");
    }
    printf("codes: %s\n",
           few(TESS_LIW(MAXCOP), TESS_LRW(MAXCOP)) ? "yes" : "NO");
    return bad;
}
