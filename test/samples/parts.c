/* parts.c - a mesh by POSIX threads.
 *
 *   cc -O2 -I. -o parts test/samples/parts.c test/recipes/join.c tess.c \
 *       hhpred.c -lm -lpthread
 *
 * The points are sorted once, by tess_index.  Each thread takes a range of
 * positions in the sorted order, and has tess_part compute all tetrahedra at
 * these points: rw is shared, iw its own copy.  The parts are joined by join.c,
 * which says how, without geometry.  tess_check proves the result.
 *
 * parts.f is the same in FORTRAN 77 with OpenMP, and writes the same.
 */
#define _POSIX_C_SOURCE 199506L
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "../recipes/recipes.h"

#define N 20000
#define PARTS 4
/* tetrahedra of all, and of a part with those that others keep */
#define MAXTET (8 * N)
#define MOST (5 * N)
/* of the index, of a part; of tess_check and join, of all */
#define FIXED (7 * N + 600)
#define LIW (FIXED + 30 * (N / PARTS + 1))
#define LRW (4 * N)

static tess_real p[3 * N];
static double rw[LRW];
static tess_int iw[MAXTET], tet[4 * MAXTET], adj[4 * MAXTET];

static struct part {
    tess_int number, base, kept, ntet;
    int code;
    tess_int mine[N], iw[LIW], tet[4 * MOST], adj[4 * MOST], becomes[MOST];
} parts[PARTS];

/* One thread's work; then what it keeps goes to its place. */
static void *compute(void *arg)
{
    struct part *r = (struct part *)arg;
    tess_int i;

    for (i = 0; i < N; i++)
        r->mine[i] = (tess_int)((double)iw[i] * PARTS / N) == r->number;
    memcpy(r->iw, iw, FIXED * sizeof *iw);
    r->ntet = 0;
    r->code = tess_part(N, p, r->mine, MOST, &r->ntet, r->tet, r->adj, LIW,
                        r->iw, LRW, rw);
    r->kept = tr_keep(r->ntet, r->tet, r->mine, r->becomes);
    return NULL;
}

static void *copy(void *arg)
{
    const struct part *r = (const struct part *)arg;

    tr_append(r->ntet, r->tet, r->adj, r->becomes, r->base, tet, adj);
    return NULL;
}

/* Do something with all parts at once. */
static int all(void *(*work)(void *))
{
    pthread_t thread[PARTS];
    int i;

    for (i = 0; i < PARTS; i++)
        if (pthread_create(thread + i, NULL, work, parts + i) != 0) return 0;
    for (i = 0; i < PARTS; i++) pthread_join(thread[i], NULL);
    return 1;
}

int main(void)
{
    tess_int i, ntet = 0, bad, open = 0;
    long seed = 1;
    int code;

    for (i = 0; i < 3 * N; i++) {
        seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
        if (seed <= 0) seed += 2147483647L;
        p[i] = (tess_real)((double)seed / 2147483648.0);
    }
    code = tess_index(N, p, MAXTET, iw, LRW, rw);
    printf("%d points, tess_index: %d\n", N, code);
    for (i = 0; i < PARTS; i++) parts[i].number = i;
    if (!all(compute)) return 1;
    for (i = 0; i < PARTS; i++) {
        printf("part %ld: tess_part %d, %ld tetrahedra, %ld kept\n",
               (long)i + 1, parts[i].code, (long)parts[i].ntet,
               (long)parts[i].kept);
        parts[i].base = ntet;
        ntet += parts[i].kept;
    }
    if (ntet > MAXTET || !all(copy)) return 1;
    for (i = 0; i < 4 * ntet; i++) open += adj[i] == TESS_OPEN;
    printf("together: %ld tetrahedra, %ld facets open\n", (long)ntet,
           (long)open);
    code = tr_join(ntet, tet, adj, MAXTET, iw);
    printf("join: %d\n", code);
    code = tess_check(N, p, ntet, tet, adj, MAXTET, iw, &bad);
    printf("tess_check: %d\n", code);
    return code;
}
