/* locate.c - locate FAMILY N: the times of tess_locate and tess_query, in ns a
 * query.
 *
 * Prints two lines: tess_locate FAMILY n inside hinted unhinted - the share of
 * the queries that are in the hull, the time in spatial order with the last
 * answer as the start, and in no order with no start given; and the same of
 * tess_query. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "../lib/points.h"
#include "../lib/take.h"
#include "queries.h"
#include "../../tess.h"

int main(int argc, char **argv)
{
    double *p, *q, *rw, w[4], ns[2];
    tess_int *tet, *adj, *iw, n, ntet, maxtet, liw, lrw, t, v[4];
    long i, inside, asked = argc > 2 ? atol(argv[2]) : 0;
    clock_t start;
    int hinted, code, mesh;

    if (asked < 4) {
        fprintf(stderr, "usage: locate FAMILY N\n");
        return 2;
    }
    p = (double *)take(3.0 * (double)asked, sizeof *p);
    q = (double *)take(3.0 * (double)QUERIES, sizeof *q);
    n = (tess_int)points_make(argv[1], asked, 1, p);
    maxtet = 8 * n + 64;
    if (n == 0 || tess_size(n, maxtet, &liw, &lrw) != 0) return 2;
    tet = (tess_int *)take(4.0 * (double)maxtet, sizeof *tet);
    adj = (tess_int *)take(4.0 * (double)maxtet, sizeof *adj);
    iw = (tess_int *)take((double)liw, sizeof *iw);
    rw = (double *)take((double)lrw, sizeof *rw);
    code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
    if (code != TESS_OK) {
        fprintf(stderr, "locate: tess returns %d\n", code);
        return 1;
    }
    for (mesh = 1; mesh >= 0; mesh--) {
        inside = 0;
        if (!mesh && tess_index(n, p, liw, iw, lrw, rw) != 0) return 1;
        for (hinted = 1; hinted >= 0; hinted--) {
            queries_make(n, p, hinted, q);
            t = v[0] = TESS_NONE;
            start = clock();
            for (i = 0; i < QUERIES; i++) {
                if (!hinted) t = v[0] = TESS_NONE;
                code = mesh ? tess_locate(p, ntet, tet, adj, q + 3 * i, &t, w)
                            : tess_query(n, p, iw, rw, q + 3 * i, v, w);
                if (code < 0 || code > 1) {
                    fprintf(stderr, "locate: code %d\n", code);
                    return 1;
                }
                if (hinted && code == 0) inside++;
            }
            ns[hinted] = (double)(clock() - start) / CLOCKS_PER_SEC /
                         (double)QUERIES * 1e9;
        }
        printf("%s %s %ld %.3f %.0f %.0f\n",
               mesh ? "tess_locate" : "tess_query", argv[1], (long)n,
               (double)inside / (double)QUERIES, ns[1], ns[0]);
    }
    free(p);
    free(q);
    free(tet);
    free(adj);
    free(iw);
    free(rw);
    return 0;
}
