/* parts.c - parts FAMILY N [REPEATS [PARTS]]: what a mesh in parts costs, joined
 * by test/recipes/join.c.
 *
 *   cc -O3 -I. -DTHREADS -o parts test/bench/parts.c test/lib/points.c tess.c
 *       hhpred.c -lm -lpthread
 *
 * Prints a line for each number of parts, ranges of the order of tess_index (1,
 * 2, 8, 32, 128, and as many as there are processors; or 2 and PARTS):
 *   parts FAMILY n parts tetrahedra time clock how index join
 * tetrahedra: those of all parts over those of the mesh; time: all that is done
 * one after another, over tess; clock: with a thread for each part over tess,
 * by the clock, "measured" where the machine has so many processors, else
 * "computed": index, the slowest part, the slowest append and join; index and
 * join: what these two are of tess, which no number of threads makes less.
 * Times are the least of REPEATS (1).
 *
 * Without -DTHREADS all are computed.  With -DTESS_COUNT it prints instead what
 * searches look at (see watch.h): in the index and eight parts together, over
 * the tetrahedra of the mesh; and in queries from anywhere, over their number:
 *   parts FAMILY n candidates ... listed ...
 *   queries FAMILY n candidates ... listed ...
 */
#ifdef THREADS
#define _POSIX_C_SOURCE 200112L
#include <pthread.h>
#include <unistd.h>
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../lib/points.h"
#include "../lib/take.h"
#include "../recipes/join.c"
#ifdef TESS_COUNT
#include "../lib/watch.h"
#include "queries.h"
#endif

typedef struct part {
    tess_int number, parts, base, kept, ntet, liw, most;
    tess_int *mine, *iw, *tet, *adj, *becomes;
    int code;
} part;

static double *p, *rw;
static tess_int n, maxtet, liw, lrw, *iw, *tet, *adj;

static void need(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "parts: %s\n", what);
    exit(1);
}

static tess_int *ints(double count)
{
    return (tess_int *)take(count, sizeof(tess_int));
}

static double now(void)
{
#ifdef THREADS
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
#else
    return (double)clock() / CLOCKS_PER_SEC;
#endif
}

static long processors(void)
{
#ifdef THREADS
    return sysconf(_SC_NPROCESSORS_ONLN);
#else
    return 1;
#endif
}

/* A part with workspace as join.c says, and room for the whole mesh; all of it
 * has been written to, as tess's has. */
static void make(part *r, long number, long parts, tess_int mesh)
{
    tess_int m = n / (tess_int)parts + 1;

    r->number = (tess_int)number;
    r->parts = (tess_int)parts;
    r->liw = 7 * n + 600 + (tess_int)TESS_LIW(m);
    r->most = mesh;
    r->mine = ints(n);
    r->iw = ints(r->liw);
    r->tet = ints(4.0 * r->most);
    r->adj = ints(4.0 * r->most);
    r->becomes = ints(r->most);
    memset(r->iw, 0, (size_t)r->liw * sizeof *r->iw);
    memset(r->tet, 0, 4 * (size_t)r->most * sizeof *r->tet);
    memset(r->adj, 0, 4 * (size_t)r->most * sizeof *r->adj);
    memset(r->becomes, 0, (size_t)r->most * sizeof *r->becomes);
}

static void drop(part *r)
{
    free(r->mine);
    free(r->iw);
    free(r->tet);
    free(r->adj);
    free(r->becomes);
}

static void *compute(void *arg)
{
    part *r = (part *)arg;
    tess_int i;

    for (i = 0; i < n; i++)
        r->mine[i] = (tess_int)((double)iw[i] * (double)r->parts /
                                (double)n) == r->number;
    memcpy(r->iw, iw, (size_t)(7 * n + 600) * sizeof *iw);
    r->ntet = 0;
    r->code = tess_part(n, p, r->mine, r->most, &r->ntet, r->tet, r->adj,
                        r->liw, r->iw, lrw, rw);
    r->kept = tr_keep(r->ntet, r->tet, r->mine, r->becomes);
    return NULL;
}

static void *copy(void *arg)
{
    const part *r = (const part *)arg;

    tr_append(r->ntet, r->tet, r->adj, r->becomes, r->base, tet, adj);
    return NULL;
}

/* The pieces' times, one after another: index, slowest part, slowest append,
 * join, all; and the tetrahedra computed. */
typedef struct pieces {
    double index, part, append, join, all, tetrahedra;
} pieces;

static double later(double *start)
{
    double t = now(), spent = t - *start;

    *start = t;
    return spent;
}

static pieces serial(long parts, tess_int mesh)
{
    pieces s = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    part r;
    double t, x;
    tess_int ntet = 0;
    long i;

    make(&r, 0, parts, mesh);
    t = now();
    need(tess_index(n, p, liw, iw, lrw, rw) == 0, "tess_index fails");
    s.all = s.index = later(&t);
    for (i = 0; i < parts; i++) {
        r.number = (tess_int)i;
        r.base = ntet;
        compute(&r);
        need(r.code == 0 && ntet + r.kept <= mesh, "tess_part fails");
        s.all += x = later(&t);
        if (x > s.part) s.part = x;
        copy(&r);
        s.all += x = later(&t);
        if (x > s.append) s.append = x;
        ntet += r.kept;
        s.tetrahedra += (double)r.ntet;
    }
    need(ntet == mesh && tr_join(ntet, tet, adj, liw, iw) == 0, "join fails");
    s.all += s.join = later(&t);
    drop(&r);
    return s;
}

#ifdef THREADS
/* By the clock, with a thread for each part. */
static double parallel(long parts, tess_int mesh)
{
    part *r = (part *)take((double)parts, sizeof *r);
    pthread_t *thread = (pthread_t *)take((double)parts, sizeof *thread);
    void *(*work[2])(void *);
    tess_int ntet = 0;
    double start;
    long i;
    int k;

    work[0] = compute;
    work[1] = copy;
    for (i = 0; i < parts; i++) make(r + i, i, parts, mesh);
    start = now();
    need(tess_index(n, p, liw, iw, lrw, rw) == 0, "tess_index fails");
    for (k = 0; k < 2; k++) {
        for (i = 0; i < parts; i++)
            need(pthread_create(thread + i, 0, work[k], r + i) == 0,
                 "no thread");
        for (i = 0; i < parts; i++) pthread_join(thread[i], 0);
        for (i = 0; i < parts && k == 0; i++) {
            need(r[i].code == 0, "tess_part fails");
            r[i].base = ntet;
            ntet += r[i].kept;
        }
        need(ntet == mesh, "the parts are not the mesh");
    }
    need(tr_join(ntet, tet, adj, liw, iw) == 0, "join fails");
    start = now() - start;
    for (i = 0; i < parts; i++) drop(r + i);
    free(r);
    free(thread);
    return start;
}
#endif

#ifdef TESS_COUNT
double tess_count[N_ALL];

/* What has been counted, over per. */
static void counted(const char *what, const char *family, double per)
{
    static const struct {
        const char *name;
        int which;
    } event[] = {
        {"candidates", N_POINT}, {"exact", N_EXACT}, {"sides", N_SIDE},
        {"trials", N_TRIAL}, {"nodes", N_NODE}, {"leaves", N_LEAF},
        {"listed", N_LIST}
    };
    int i;

    printf("%s %s %ld", what, family, (long)n);
    for (i = 0; i < 7; i++)
        printf(" %s %.4f", event[i].name, tess_count[event[i].which] / per);
    printf("\n");
}

static void count(const char *family)
{
    double *q = (double *)take(3.0 * (double)QUERIES, sizeof *q), w[4];
    tess_int mesh, v[4];
    int i, some = 200, code;

    need(tess(n, p, maxtet, &mesh, tet, adj, liw, iw, lrw, rw) == 0,
         "tess fails");
    memset(tess_count, 0, sizeof tess_count);
    serial(8, mesh);
    counted("parts", family, (double)mesh);
    need(tess_index(n, p, liw, iw, lrw, rw) == 0, "tess_index fails");
    queries_make(n, p, 0, q);
    memset(tess_count, 0, sizeof tess_count);
    for (i = 0; i < some; i++) {
        v[0] = TESS_NONE;
        code = tess_query(n, p, iw, rw, q + 3 * i, v, w);
        need(code == 0 || code == 1, "tess_query fails");
    }
    counted("queries", family, (double)some);
    free(q);
}
#endif

static void least(double *best, double x)
{
    if (*best == 0.0 || x < *best) *best = x;
}

int main(int argc, char **argv)
{
    static long parts[6] = {1, 2, 8, 32, 128, 0};
    double whole = 0.0, wall[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, t;
    pieces s, best[6];
    tess_int mesh = 0;
    long asked = argc > 2 ? atol(argv[2]) : 0;
    long repeats = argc > 3 ? atol(argv[3]) : 1, round;
    int i, code;

    if (asked < 4) {
        fprintf(stderr, "usage: parts FAMILY N [REPEATS [PARTS]]\n");
        return 2;
    }
    p = (double *)take(3 * (double)asked, sizeof *p);
    n = (tess_int)points_make(argv[1], asked, 1, p);
    maxtet = 32 * n + 64;
    if (n == 0 || tess_size(n, maxtet, &liw, &lrw) != 0) return 2;
    rw = (double *)take((double)lrw, sizeof *rw);
    iw = ints(liw);
    tet = ints(4.0 * maxtet);
    adj = ints(4.0 * maxtet);
#ifdef TESS_COUNT
    count(argv[1]);
    return 0;
#endif
    memset(best, 0, sizeof best);
    /* that many, too, if it is none of those */
    parts[5] = processors();
    for (i = 0; i < 5; i++) if (parts[i] == processors()) parts[5] = 0;
    if (argc > 4) {
        parts[0] = 2;
        parts[1] = atol(argv[4]);
        parts[2] = 0;
    }
    for (round = 0; round < repeats; round++) {
        t = now();
        code = tess(n, p, maxtet, &mesh, tet, adj, liw, iw, lrw, rw);
        need(code == 0, "tess fails");
        if (round > 0 || repeats == 1) least(&whole, now() - t);
        for (i = 0; i < 6 && parts[i] > 0; i++) {
            s = serial(parts[i], mesh);
            best[i].tetrahedra = s.tetrahedra;
            least(&best[i].index, s.index);
            least(&best[i].part, s.part);
            least(&best[i].append, s.append);
            least(&best[i].join, s.join);
            least(&best[i].all, s.all);
#ifdef THREADS
            if (parts[i] <= processors())
                least(wall + i, parallel(parts[i], mesh));
#endif
        }
    }
    need(whole > 0.0, "too few points for the clock");
    for (i = 0; i < 6 && parts[i] > 0; i++) {
        t = best[i].index + best[i].part + best[i].append + best[i].join;
        printf("parts %s %ld %ld %.3f %.2f %.2f %s %.3f %.3f\n", argv[1],
               (long)n, parts[i], best[i].tetrahedra / (double)mesh,
               best[i].all / whole, (wall[i] > 0.0 ? wall[i] : t) / whole,
               wall[i] > 0.0 ? "measured" : "computed",
               best[i].index / whole, best[i].join / whole);
    }
    free(p);
    free(rw);
    free(iw);
    free(tet);
    free(adj);
    return 0;
}
