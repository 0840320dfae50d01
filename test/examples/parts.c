/* parts.c - a mesh in parts, by POSIX threads, that are joined.
 *
 *   cc -O2 -I. -o parts test/examples/parts.c tess.c hhpred.c -lm -lpthread
 *
 * The points are sorted once, by tess_index.  Each thread takes a range of
 * places in the sorted order, so points that are near each other, and has
 * tess_part compute all tetrahedra at them: rw is shared, iw its own copy.
 * What it keeps are those whose vertex of least index is its own; so each
 * tetrahedron is kept by one thread.  One behind the other, with neighbours
 * renumbered, and open where another thread has them, they are an unfinished
 * result, of which tess_resume matches the facets.  tess_check proves it.
 *
 * Processes that share nothing would do the same, and send what they keep.
 * parts.f is the same in FORTRAN 77 with OpenMP, and writes the same.
 */
#define _POSIX_C_SOURCE 199506L
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "tess.h"

#define N 20000
#define PARTS 4
/* tetrahedra of all, and of a part with those that others keep */
#define MAXTET (8 * N)
#define MOST (5 * N)
#define LIW (40 * N)
#define LRW (4 * N)

static tess_real p[3 * N];
static double rw[LRW], rw2[LRW];
static tess_int iw[LIW], tet[4 * MAXTET], adj[4 * MAXTET];

static struct part {
    tess_int number, kept, ntet;
    int code;
    tess_int mine[N], iw[LIW], tet[4 * MOST], adj[4 * MOST], becomes[MOST];
} parts[PARTS];

/* One thread's work. */
static void *compute(void *arg)
{
    struct part *r = (struct part *)arg;
    tess_int i, t, *v;
    int k;

    for (i = 0; i < N; i++)
        r->mine[i] = (tess_int)((double)iw[i] * PARTS / N) == r->number;
    memcpy(r->iw, iw, sizeof iw);
    r->ntet = 0;
    r->code = tess_part(N, p, r->mine, MOST, &r->ntet, r->tet, r->adj, LIW,
                        r->iw, LRW, rw);
    r->kept = 0;
    for (t = 0; t < r->ntet; t++) {
        v = r->tet + 4 * t;
        for (k = 1, i = v[0]; k < 4; k++) i = v[k] < i ? v[k] : i;
        r->becomes[t] = r->mine[i] ? r->kept++ : TESS_OPEN;
    }
    return NULL;
}

/* Put behind the ntet tetrahedra there are what a part keeps. */
static tess_int append(const struct part *r, tess_int ntet)
{
    tess_int t, u;
    int k;

    for (t = 0; t < r->ntet; t++)
        for (k = 0; k < 4 && r->becomes[t] >= 0; k++) {
            u = r->adj[4 * t + k];
            if (u >= 0) u = r->becomes[u] < 0 ? TESS_OPEN
                                              : ntet + r->becomes[u];
            tet[4 * (ntet + r->becomes[t]) + k] = r->tet[4 * t + k];
            adj[4 * (ntet + r->becomes[t]) + k] = u;
        }
    return ntet + r->kept;
}

int main(void)
{
    pthread_t thread[PARTS];
    tess_int i, ntet = 0, bad, open = 0;
    long seed = 1;
    int code;

    for (i = 0; i < 3 * N; i++) {
        seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
        if (seed <= 0) seed += 2147483647L;
        p[i] = (tess_real)((double)seed / 2147483648.0);
    }
    code = tess_index(N, p, LIW, iw, LRW, rw);
    printf("%d points, tess_index: %d\n", N, code);
    for (i = 0; i < PARTS; i++) {
        parts[i].number = i;
        if (pthread_create(thread + i, NULL, compute, parts + i) != 0) return 1;
    }
    for (i = 0; i < PARTS; i++) {
        pthread_join(thread[i], NULL);
        printf("part %ld: tess_part %d, %ld tetrahedra, %ld kept\n",
               (long)i + 1, parts[i].code, (long)parts[i].ntet,
               (long)parts[i].kept);
        ntet = append(parts + i, ntet);
    }
    for (i = 0; i < 4 * ntet; i++) open += adj[i] == TESS_OPEN;
    printf("joined: %ld tetrahedra, %ld facets open\n", (long)ntet, (long)open);
    code = tess_resume(N, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw2);
    printf("tess_resume: %d, %ld tetrahedra\n", code, (long)ntet);
    code = tess_check(N, p, ntet, tet, adj, LIW, iw, &bad);
    printf("tess_check: %d\n", code);
    return code;
}
