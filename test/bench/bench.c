/* bench.c - bench FAMILY N [REPEATS] [SEED]: the time and memory of tess.
 *           bench -list: the names of the families.
 *
 * Prints one line:
 *   tess FAMILY n ntet seconds ns/tet workspace-bytes/point
 *   total-bytes/point code
 * seconds is the least CPU time of REPEATS (3) calls, or where those are short
 * for the clock the mean of several, REPEATS times; workspace is iw and rw,
 * total adds tet and adj as allocated, not the points.  The arrays start at
 * what a cloud of points needs and are doubled, outside of the time measured,
 * as often as tess asks for more.
 *
 * Compiled with BENCH_F77 it calls the FORTRAN 77 half, and its line begins
 * with f77.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../lib/points.h"
#include "../lib/take.h"
#include "../lib/watch.h"
#include "../twin/f77.h"

#ifdef TESS_COUNT
double tess_count[N_ALL];
#endif

#ifdef BENCH_F77
#define NAME "f77"

static int run_tess(tess_int n, const double *p, tess_int maxtet,
                    tess_int *ntet, tess_int *tet, tess_int *adj,
                    tess_int liw, tess_int *iw, tess_int lrw, double *rw)
{
    tess_int info;

    tess_(&n, p, &maxtet, ntet, tet, adj, &liw, iw, &lrw, rw, &info);
    return (int)info;
}
#else
#define NAME "tess"
#define run_tess tess
#endif

/* Seconds of the processor, which some clocks count by hundredths; what is
 * counted is the same each time. */
#ifdef TESS_COUNT
#define SHORT 0.0
#else
#define SHORT 0.2
#endif
/* Bounds 28 n by the largest tess_int of 32 bits. */
#define MOST 70000000L

int main(int argc, char **argv)
{
    double *p, *rw, seconds, least, work, total;
    tess_int *tet, *adj, *iw, n, maxtet, ntet, liw, lrw, pool;
    unsigned long seed;
    long asked, repeats, run, calls;
    clock_t start;
    int code;
#ifdef TESS_COUNT
    static const char *name[] = {"facets", "star", "block", "tree",
        "nodes", "candidates", "exact", "listed", "pool", "hull", "probes",
        "sides", "balls", "trials", "leaves", "near", "made"};
    int i;
#endif

    if (argc == 2 && strcmp(argv[1], "-list") == 0) {
        for (asked = 0; points_name((int)asked); asked++)
            printf("%s\n", points_name((int)asked));
        return 0;
    }
    asked = argc > 2 ? atol(argv[2]) : 0;
    if (asked < 1 || asked > MOST) {
        fprintf(stderr, "usage: bench FAMILY N [REPEATS] [SEED]\n");
        return 2;
    }
    repeats = argc > 3 ? atol(argv[3]) : 3;
    seed = argc > 4 ? strtoul(argv[4], 0, 10) : 1;
    p = (double *)take((double)asked * 3, sizeof *p);
    n = (tess_int)points_make(argv[1], asked, seed, p);
    if (n == 0) {
        fprintf(stderr, "bench: no points %s %s\n", argv[1], argv[2]);
        free(p);
        return 2;
    }

    maxtet = 7 * n + 64;
    pool = 0;
    run = 0;
    least = 0;
    do {
        if (tess_size(n, maxtet, &liw, &lrw) != 0) {
            fprintf(stderr, "bench: too many tetrahedra\n");
            return 1;
        }
        liw += pool;
        tet = (tess_int *)take(4 * (double)maxtet, sizeof *tet);
        adj = (tess_int *)take(4 * (double)maxtet, sizeof *adj);
        iw = (tess_int *)take((double)liw, sizeof *iw);
        rw = (double *)take((double)lrw, sizeof *rw);
        do {
            start = clock();
            calls = 0;
            do {
#ifdef TESS_COUNT
                for (i = 0; i < N_ALL; i++)
                    tess_count[i] = 0;
#endif
                code = run_tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw,
                                rw);
                seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
                calls++;
            } while (code == TESS_OK && seconds < SHORT);
            if (code == TESS_MORE || code == TESS_POOL)
                break;
            seconds /= (double)calls;
            if (run == 0 || seconds < least)
                least = seconds;
        } while (++run < repeats);
        work = (double)liw * (double)sizeof *iw
            + (double)lrw * (double)sizeof *rw;
        total = work + 8 * (double)maxtet * (double)sizeof *tet;
        if (code == TESS_MORE)
            maxtet *= 2;
        if (code == TESS_POOL)
            pool += liw;
        free(tet);
        free(adj);
        free(iw);
        free(rw);
    } while (code == TESS_MORE || code == TESS_POOL);

    printf(NAME " %s %ld %ld %.4f %.1f %.1f %.1f %d\n", argv[1], (long)n,
           (long)ntet, least, ntet > 0 ? 1e9 * least / (double)ntet : 0.0,
           work / (double)n, total / (double)n, code);
#ifdef TESS_COUNT
    printf("count %s %ld", argv[1], (long)n);
    for (i = 0; i < N_ALL; i++)
        printf(" %s %.4f", name[i],
            i == N_POOL ? tess_count[i] : tess_count[i] / (double)ntet);
    printf("\n");
#endif
    free(p);
    return code != TESS_OK;
}
