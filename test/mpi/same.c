/* same.c - is what the processes of mesh have written the mesh that tess gives?
 *
 *   same -write FILE FAMILY N       points of lib/points.h as mesh -raw and
 *                                   -each read them; part R of RANKS of them
 *                                   with R RANKS behind
 *   same PREFIX RANKS FILE          compares, where FILE are the points
 *
 * Compares the sets of tetrahedra, their orientation, and that each neighbour
 * has the facet's vertices.  Prints the tetrahedra, and the CPU time and memory
 * that tess took.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../../tess.h"
#include "../lib/points.h"
#include "../lib/take.h"

static void need(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "same: %s\n", what);
    exit(1);
}

/* The items of a file, behind what there is. */
static size_t read_behind(const char *name, void **at, size_t n, size_t size)
{
    FILE *file = fopen(name, "rb");
    size_t more;
    long bytes;

    need(file != NULL && fseek(file, 0, SEEK_END) == 0, "no such file");
    bytes = ftell(file);
    rewind(file);
    need(bytes >= 0 && (size_t)bytes % size == 0, "a file's length is wrong");
    more = (size_t)bytes / size;
    *at = realloc(*at, (n + more) * size + 1);
    need(*at != NULL && fread((char *)*at + n * size, size, more, file) == more,
         "cannot read a file");
    fclose(file);
    return n + more;
}

static int by_index(const void *a, const void *b)
{
    return memcmp(a, b, 4 * sizeof(int64_t));
}

/* Order the vertices of each tetrahedron but for the last two, which tell the
 * orientation; then the tetrahedra. */
static void order(int64_t *v, size_t count)
{
    int64_t swap, *a;
    size_t t;
    int i, k, odd;

    for (t = 0; t < count; t++) {
        a = v + 4 * t;
        for (i = odd = 0; i < 3; i++)
            for (k = 0; k < 3; k++)
                if (a[k] > a[k + 1]) {
                    swap = a[k];
                    a[k] = a[k + 1];
                    a[k + 1] = swap;
                    odd = !odd;
                }
        if (odd) {
            swap = a[2];
            a[2] = a[3];
            a[3] = swap;
        }
    }
    qsort(v, count, 4 * sizeof *v, by_index);
}

static int has(const int64_t *v, int64_t x)
{
    return v[0] == x || v[1] == x || v[2] == x || v[3] == x;
}

/* How many facets of the n tetrahedra are on the hull; all others have a
 * neighbour with their vertices. */
static size_t hull(const int64_t *tet, const int64_t *adj, size_t n)
{
    size_t t, count = 0;
    const int64_t *v, *u;
    int k, i;

    for (t = 0; t < n; t++)
        for (k = 0; k < 4; k++) {
            if (adj[4 * t + (size_t)k] == TESS_NONE) {
                count++;
                continue;
            }
            need(adj[4 * t + (size_t)k] >= 0 &&
                     adj[4 * t + (size_t)k] < (int64_t)n,
                 "a neighbour out of range");
            v = tet + 4 * t;
            u = tet + 4 * adj[4 * t + (size_t)k];
            for (i = 0; i < 4; i++)
                need(has(u, v[i]) == (i != k), "a wrong neighbour");
        }
    return count;
}

static void write_points(int argc, char **argv)
{
    double n = atof(argv[4]), *p = (double *)take(3 * n, sizeof *p);
    long begin = 0, end = points_make(argv[3], (long)n, 1, p), r, ranks;
    FILE *file = fopen(argv[2], "wb");

    need(end > 0 && file != NULL, "no points, or no file");
    if (argc > 6) {
        r = atol(argv[5]);
        ranks = atol(argv[6]);
        begin = end * r / ranks;
        end = end * (r + 1) / ranks;
    }
    fwrite(p + 3 * begin, 3 * sizeof *p, (size_t)(end - begin), file);
    need(fclose(file) == 0, "cannot write a file");
    free(p);
}

int main(int argc, char **argv)
{
    void *points = NULL, *tets = NULL, *adjs = NULL;
    int64_t *wanted;
    tess_int n, maxtet, ntet, *tet, *adj, liw, lrw, *iw, open = 0;
    double *rw;
    size_t many = 0, i;
    char name[400];
    clock_t start;
    int code, r;

    if (argc > 4 && strcmp(argv[1], "-write") == 0) {
        write_points(argc, argv);
        return 0;
    }
    need(argc == 4 && strlen(argv[1]) < 300, "same PREFIX RANKS FILE");
    n = (tess_int)read_behind(argv[3], &points, 0, 3 * sizeof(double));
    for (r = 0; r < atoi(argv[2]); r++) {
        sprintf(name, "%s.%d.tet", argv[1], r);
        many = read_behind(name, &tets, many, 4 * sizeof(int64_t));
    }
    for (r = 0, i = 0; r < atoi(argv[2]); r++) {
        sprintf(name, "%s.%d.adj", argv[1], r);
        i = read_behind(name, &adjs, i, 4 * sizeof(int64_t));
    }
    need(i == many, "as many neighbours as tetrahedra");
    maxtet = 8 * n + 64;
    for (code = TESS_MORE; code == TESS_MORE || code == TESS_POOL; maxtet *= 2) {
        need(tess_size(n, maxtet, &liw, &lrw) == 0, "too many points");
        liw += maxtet; /* for a pool of very many facets */
        tet = (tess_int *)take(4.0 * (double)maxtet, sizeof *tet);
        adj = (tess_int *)take(4.0 * (double)maxtet, sizeof *adj);
        iw = (tess_int *)take((double)liw, sizeof *iw);
        rw = (double *)take((double)lrw, sizeof *rw);
        start = clock();
        code = tess(n, (double *)points, maxtet, &ntet, tet, adj, liw, iw, lrw,
                    rw);
        start = clock() - start;
        if (code == TESS_MORE || code == TESS_POOL)
            free(tet), free(adj), free(iw), free(rw);
    }
    need(code == 0 || ntet == 0, "tess fails");
    need((size_t)ntet == many, "another number of tetrahedra");
    for (i = 0; i < 4 * many; i++) open += adj[i] == TESS_NONE;
    need(hull((int64_t *)tets, (int64_t *)adjs, many) == (size_t)open,
         "another number of facets on the hull");
    wanted = (int64_t *)take(4.0 * (double)many, sizeof *wanted);
    for (i = 0; i < 4 * many; i++) wanted[i] = tet[i];
    order(wanted, many);
    order((int64_t *)tets, many);
    need(memcmp(wanted, tets, 4 * many * sizeof *wanted) == 0,
         "other tetrahedra");
    printf("same: code %d tetrahedra %.0f cpu %.3fs memory %.1fMB\n", code,
           (double)many, (double)start / CLOCKS_PER_SEC,
           ((double)n * 3 * sizeof(double) + 32.0 * (double)ntet +
            (double)liw * sizeof *iw + (double)lrw * sizeof *rw) / 1048576);
    return 0;
}
