/* threads.c - the FORTRAN half called from several threads at once, on different
 * points: each result must be what one thread alone gets.
 *
 * Compiled without OpenMP it compares one thread with itself, and says so.
 * Points: ordinary ones, ties, and exponents far apart, for which
 * the predicates need their largest scratch.
 */
#include <stdio.h>
#include <stdlib.h>
#include "../lib/points.h"
#include "f77.h"
#ifdef _OPENMP
#include <omp.h>
#endif

#define JOBS 16
#define MOST 800
#define MAXTET 8000
#define LIW 40000
#define LRW 4000
#define ROUNDS 6

typedef struct job {
    tess_int n;
    double p[3 * MOST], rw[LRW];
    tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[LIW];
} job;

static job jobs[JOBS];

static unsigned long add(unsigned long sum, long x)
{
    return (sum * 31UL + (unsigned long)(x + 7)) & 0xffffffffUL;
}

/* All of a job, and a checksum of all that came out: half of the result, the
 * rest of it, the check, and the location of the points' means. */
static unsigned long work(job *j)
{
    tess_int maxtet = MAXTET / 20, liw = LIW, lrw = LRW, ntet = 0, info, t, i;
    tess_int bad;
    unsigned long sum = 1;
    double q[3], w[4];
    int k;

    tess_(&j->n, j->p, &maxtet, &ntet, j->tet, j->adj, &liw, j->iw, &lrw,
          j->rw, &info);
    sum = add(add(sum, info), ntet);
    maxtet = MAXTET;
    tessre_(&j->n, j->p, &maxtet, &ntet, j->tet, j->adj, &liw, j->iw, &lrw,
            j->rw, &info);
    sum = add(add(sum, info), ntet);
    for (i = 0; i < 4 * ntet; i++) sum = add(add(sum, j->tet[i]), j->adj[i]);
    tessch_(&j->n, j->p, &ntet, j->tet, j->adj, &liw, j->iw, &bad, &info);
    sum = add(add(sum, info), bad);
    for (i = 0; i < j->n; i += 10) {
        for (k = 0; k < 3; k++)
            q[k] = 0.5 * j->p[3 * i + k] + 0.5 * j->p[3 * (j->n - 1 - i) + k];
        t = 0;
        tesslo_(j->p, &ntet, j->tet, j->adj, q, &t, w, &info);
        sum = add(add(sum, info), t);
    }
    return sum;
}

int main(void)
{
    static const char *const family[] = {
        "uniform", "lattice01", "wide", "lastplaces", "duplicates",
        "cubesurf", "clusters", "latticeshuf"
    };
    unsigned long alone[JOBS], sum[JOBS];
    int i, round, threads = 1, failed = 0;

    for (i = 0; i < JOBS; i++) {
        const char *name = family[i % 8];

        jobs[i].n = (tess_int)points_make(name, name[0] == 'w' ? 30 : 500 + i,
                                          (unsigned long)i + 1, jobs[i].p);
        alone[i] = work(jobs + i);
    }
#ifdef _OPENMP
    threads = omp_get_max_threads();
#endif
    for (round = 0; round < ROUNDS; round++) {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1)
#endif
        for (i = 0; i < JOBS; i++)
            sum[i] = work(jobs + (i + round) % JOBS);
        for (i = 0; i < JOBS; i++)
            if (sum[i] != alone[(i + round) % JOBS]) {
                failed++;
                printf("# round %d, job %d: not what one thread gets\n", round,
                       i);
            }
    }
    printf("# %d threads\n", threads);
    printf("%sok 1 - threads: each gets what one thread gets\n1..1\n",
           failed ? "not " : "");
    return failed != 0;
}
