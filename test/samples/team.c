/* team.c - a mesh, and values in it, by a team of threads of OpenMP.
 *
 *   cc -O2 -fopenmp -I. -o team test/samples/team.c test/recipes/join.c \
 *       tess.c hhpred.c -lm
 *
 * As parts.c, whose text says more, with POSIX threads: each thread has
 * tess_part compute the tetrahedra at its points, rw being shared, iw its own
 * copy; join.c makes one mesh of them.  Then each interpolates at its places:
 * tess_values has no state.  What it prints does not depend on the threads, and
 * without OpenMP it is the same.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../recipes/recipes.h"

#define N 20000
#define PARTS 4
#define PLACES 1000 /* of each part */
#define MAXTET (8 * N)
#define MOST (5 * N)
#define FIXED (7 * N + 600)
#define LIW (FIXED + 30 * (N / PARTS + 1))
#define LRW (4 * N)

static tess_real p[3 * N], q[PARTS][3 * PLACES];
static double rw[LRW], value[N], out[PARTS][PLACES];
static tess_int iw[MAXTET], tet[4 * MAXTET], adj[4 * MAXTET];
static tess_int mine[PARTS][N], iws[PARTS][LIW], tets[PARTS][4 * MOST];
static tess_int adjs[PARTS][4 * MOST], becomes[PARTS][MOST];
static tess_int nt[PARTS], kept[PARTS], base[PARTS], t[PARTS][PLACES];

/* random01 - a random number, 0 < x < 1. */
static double random01(void)
{
    static long seed = 1;

    seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
    if (seed <= 0) seed += 2147483647L;
    return (double)seed / 2147483648.0;
}

/* linear - a field that interpolation gives back, but for rounding. */
static double linear(const tess_real *x)
{
    return 1.0 + 2.0 * (double)x[0] - 3.0 * (double)x[1] + 4.0 * (double)x[2];
}

int main(void)
{
    tess_int i, ntet = 0, bad;
    int code[PARTS], k, wrong = 0;
    long outside = 0;

    for (i = 0; i < 3 * N; i++) p[i] = (tess_real)random01();
    for (i = 0; i < N; i++) value[i] = linear(p + 3 * i);
    code[0] = tess_index(N, p, MAXTET, iw, LRW, rw);
    printf("%d points, tess_index: %d\n", N, code[0]);
#ifdef _OPENMP
#pragma omp parallel for private(i)
#endif
    for (k = 0; k < PARTS; k++) {
        for (i = 0; i < N; i++)
            mine[k][i] = (tess_int)((double)iw[i] * PARTS / N) == k;
        memcpy(iws[k], iw, FIXED * sizeof *iw);
        code[k] = tess_part(N, p, mine[k], MOST, nt + k, tets[k], adjs[k],
                            LIW, iws[k], LRW, rw);
        kept[k] = tr_keep(nt[k], tets[k], mine[k], becomes[k]);
    }
    for (k = 0; k < PARTS; k++) {
        wrong |= code[k];
        base[k] = ntet;
        ntet += kept[k];
    }
    if (wrong != 0 || ntet > MAXTET) return 1;
#ifdef _OPENMP
#pragma omp parallel for
#endif
    for (k = 0; k < PARTS; k++)
        tr_append(nt[k], tets[k], adjs[k], becomes[k], base[k], tet, adj);
    wrong = tr_join(ntet, tet, adj, MAXTET, iw);
    if (wrong == 0) wrong = tess_check(N, p, ntet, tet, adj, MAXTET, iw, &bad);
    printf("%ld tetrahedra, tess_check: %d\n", (long)ntet, wrong);
    if (wrong != 0) return 1;
    for (i = 0; i < 3 * PLACES * PARTS; i++)
        q[i / (3 * PLACES)][i % (3 * PLACES)] = (tess_real)random01();
#ifdef _OPENMP
#pragma omp parallel for private(i)
#endif
    for (k = 0; k < PARTS; k++) {
        for (i = 0; i < PLACES; i++) t[k][i] = TESS_NONE;
        code[k] = tess_values(p, ntet, tet, adj, 1, value, PLACES, q[k], t[k],
                              out[k]);
    }
    for (k = 0; k < PARTS; k++)
        for (i = 0; i < PLACES; i++)
            if (t[k][i] < TESS_NONE)
                outside++;
            else if (!(fabs(out[k][i] - linear(q[k] + 3 * i)) < 1e-12))
                wrong = 1;
    printf("%d places, %ld outside, the field as it is: %s\n", PLACES * PARTS,
           outside, wrong ? "NO" : "yes");
    return wrong;
}
