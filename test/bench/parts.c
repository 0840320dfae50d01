/* parts.c - parts FAMILY N [REPEATS]: what a mesh in parts costs.
 *
 * Prints for 2, 16 and 128 parts, ranges of the order of tess_index:
 *   parts FAMILY n parts tetrahedra time threads joined bytes
 * tetrahedra: those of all parts over those of the mesh; time: CPU time of the
 * index and all parts, one after another, over that of tess; threads: for 2
 * parts the wall-clock time of tess over that of the index and two POSIX
 * threads; joined: the same with tess_resume of what they keep; bytes of the
 * index a point.  Times are the least of REPEATS (1).
 *
 * The threads need -DTHREADS and -lpthread; without, or for other numbers of
 * parts, there is a - in their places.
 */
#ifdef THREADS
#define _POSIX_C_SOURCE 200112L
#include <pthread.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "../points.h"
#include "../../tess.h"

/* one part: what is its own, its index, its tetrahedra */
typedef struct part {
    long number, parts;
    tess_int *mine, *iw, *tet, *adj, ntet;
    int code;
} part;

static double *p, *rw, *rw2;
static tess_int n, maxtet, liw, lrw, shortiw, shortrw;
static part one, two;

static void *take(double count, size_t size)
{
    void *space = malloc((size_t)(count * (double)size) + 1);

    if (!space) {
        fprintf(stderr, "parts: out of memory\n");
        exit(1);
    }
    return space;
}

static void need(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "parts: %s\n", what);
    exit(1);
}

static void make(part *r)
{
    r->mine = (tess_int *)take((double)n, sizeof *r->mine);
    r->iw = (tess_int *)take((double)liw, sizeof *r->iw);
    r->tet = (tess_int *)take(4 * (double)maxtet, sizeof *r->tet);
    r->adj = (tess_int *)take(4 * (double)maxtet, sizeof *r->adj);
}

static void drop(part *r)
{
    free(r->mine);
    free(r->iw);
    free(r->tet);
    free(r->adj);
}

static void whole(void)
{
    one.code = tess(n, p, maxtet, &one.ntet, one.tet, one.adj, liw, one.iw,
                    lrw, rw);
    need(one.code == 0, "tess fails");
}

/* The index, in no more room than it needs. */
static void sort(void)
{
    need(tess_index(n, p, shortiw, one.iw, shortrw, rw) == 0,
         "tess_index fails");
}

/* A part, by a thread or not. */
static void *compute(void *arg)
{
    part *r = (part *)arg;
    tess_int i;

    for (i = 0; i < n; i++)
        r->mine[i] = (long)((double)r->iw[i] * (double)r->parts /
                            (double)n) == r->number;
    r->ntet = 0;
    r->code = tess_part(n, p, r->mine, maxtet, &r->ntet, r->tet, r->adj, liw,
                        r->iw, lrw, rw);
    return 0;
}

/* Does the part keep tetrahedron t: is the vertex of least index its own? */
static int keeps(const part *r, tess_int t)
{
    const tess_int *v = r->tet + 4 * t;
    tess_int least = v[0];
    int k;

    for (k = 1; k < 4; k++) if (v[k] < least) least = v[k];
    return r->mine[least] != 0;
}

/* CPU seconds of the index and of all parts; all tetrahedra computed. */
static double serial(long parts, tess_int mesh, double *computed)
{
    tess_int t, kept = 0;
    clock_t start, spent;

    start = clock();
    sort();
    spent = clock() - start;
    *computed = 0.0;
    one.parts = parts;
    for (one.number = 0; one.number < parts; one.number++) {
        start = clock();
        compute(&one);
        spent += clock() - start;
        need(one.code == 0, "tess_part fails");
        *computed += (double)one.ntet;
        for (t = 0; t < one.ntet; t++) kept += keeps(&one, t);
    }
    need(kept == mesh, "the parts are not the mesh");
    return (double)spent / CLOCKS_PER_SEC;
}

#ifdef THREADS
static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Put what a part keeps behind the ntet tetrahedra of tet, adj; becomes has
 * room for the part's. */
static tess_int append(const part *r, tess_int *becomes, tess_int ntet,
                       tess_int *tet, tess_int *adj)
{
    tess_int t, u, at = ntet;
    int k;

    for (t = 0; t < r->ntet; t++) becomes[t] = keeps(r, t) ? at++ : TESS_OPEN;
    for (t = 0; t < r->ntet; t++)
        for (k = 0; k < 4 && becomes[t] >= 0; k++) {
            u = r->adj[4 * t + k];
            tet[4 * becomes[t] + k] = r->tet[4 * t + k];
            adj[4 * becomes[t] + k] = u < 0 ? u : becomes[u];
        }
    return at;
}

/* Wall-clock seconds of the index and two parts at once, of that and joining.
 */
static void parallel(tess_int mesh, double *apart, double *joined)
{
    tess_int *tet = (tess_int *)take(4 * (double)maxtet, sizeof *tet);
    tess_int *adj = (tess_int *)take(4 * (double)maxtet, sizeof *adj);
    tess_int *becomes = (tess_int *)take((double)maxtet, sizeof *becomes);
    tess_int ntet;
    pthread_t thread;
    double start = now();

    one.parts = two.parts = 2;
    one.number = 0;
    two.number = 1;
    sort();
    memcpy(two.iw, one.iw, (size_t)shortiw * sizeof *one.iw);
    need(pthread_create(&thread, 0, compute, &two) == 0, "no thread");
    compute(&one);
    pthread_join(thread, 0);
    *apart = now() - start;
    need(one.code == 0 && two.code == 0, "tess_part fails");
    ntet = append(&one, becomes, 0, tet, adj);
    ntet = append(&two, becomes, ntet, tet, adj);
    need(tess_resume(n, p, maxtet, &ntet, tet, adj, liw, one.iw, lrw, rw2) ==
             0 && ntet == mesh, "the parts do not join");
    *joined = now() - start;
    free(tet);
    free(adj);
    free(becomes);
}
#endif

static void least(double *best, double x)
{
    if (*best == 0.0 || x < *best) *best = x;
}

int main(int argc, char **argv)
{
    static const long parts[3] = {2, 16, 128};
    double cpu = 0.0, all[3] = {0.0, 0.0, 0.0}, computed[3], bytes;
#ifdef THREADS
    double wall = 0.0, apart = 0.0, joined = 0.0, a, b;
#endif
    tess_int mesh = 0;
    long asked = argc > 2 ? atol(argv[2]) : 0;
    long repeats = argc > 3 ? atol(argv[3]) : 1;
    clock_t start;
    int i;

    if (asked < 4) {
        fprintf(stderr, "usage: parts FAMILY N [REPEATS]\n");
        return 2;
    }
    p = (double *)take(3 * (double)asked, sizeof *p);
    n = (tess_int)points_make(argv[1], asked, 1, p);
    maxtet = 8 * n + 64;
    if (n == 0 || tess_size(n, maxtet, &liw, &lrw) != 0) return 2;
    shortiw = 2 * n + n / 12 + 7;
    shortrw = 3 * n + n / 2 + 12;
    rw = (double *)take((double)lrw, sizeof *rw);
    rw2 = (double *)take((double)lrw, sizeof *rw2);
    make(&one);
    make(&two);
    while (repeats-- > 0) {
#ifdef THREADS
        a = now();
#endif
        start = clock();
        whole();
        least(&cpu, (double)(clock() - start) / CLOCKS_PER_SEC);
#ifdef THREADS
        least(&wall, now() - a);
#endif
        mesh = one.ntet;
        for (i = 0; i < 3; i++)
            least(all + i, serial(parts[i], mesh, computed + i));
#ifdef THREADS
        parallel(mesh, &a, &b);
        least(&apart, a);
        least(&joined, b);
#endif
    }
    need(cpu > 0.0, "too few points for the clock");
    bytes = ((double)shortiw * (double)sizeof *one.iw +
             (double)shortrw * (double)sizeof *rw) / (double)n;
    for (i = 0; i < 3; i++) {
        printf("parts %s %ld %ld %.3f %.2f ", argv[1], (long)n, parts[i],
               computed[i] / (double)mesh, all[i] / cpu);
#ifdef THREADS
        if (parts[i] == 2) printf("%.2f %.2f ", wall / apart, wall / joined);
        else
#endif
            printf("- - ");
        printf("%.1f\n", bytes);
    }
    drop(&one);
    drop(&two);
    free(p);
    free(rw);
    free(rw2);
    return 0;
}
