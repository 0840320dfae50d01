/* count.c - count [-check]: the paper's claims of cost, counted.
 *
 * Section 2: O(n^2) space and O(n^3) time at worst; Dwyer's expected linear
 * time for points uniform in a ball.  Compiled with -DTESS_COUNT together
 * with tess.c.  Counts do not depend on the machine.
 *
 *   evaluations  points put to the test of a search's ball, one by one or in
 *                a list, and nodes of the tree
 *   probes       entries of the hash table looked at
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../lib/exact.h"
#include "../lib/points.h"
#include "../lib/take.h"
#include "../../tess.h"
#include "../lib/watch.h"

double tess_count[N_ALL];

/* as in tess.c */
enum { SEARCHES = 0, NODES = 4, CANDIDATES = 5, EXACT = 6, LISTED = 7,
       POOL = 8, PROBES = 10 };

typedef struct result {
    double n, ntet, hull, work, count[N_ALL];
    int code, proven;
} result;

static result run(const char *family, long asked)
{
    double *p = (double *)take(3.0 * (double)asked, sizeof *p), *rw;
    tess_int *tet, *adj, *iw, n, maxtet, ntet, nfac, liw, lrw, bad;
    result r;

    n = (tess_int)points_make(family, asked, 1UL, p);
    maxtet = strcmp(family, "moment") == 0 ? n * (n / 2) + 64 : 7 * n + 64;
    tess_size(n, maxtet, &liw, &lrw);
    liw += 30 * n;
    tet = (tess_int *)take(4.0 * maxtet, sizeof *tet);
    adj = (tess_int *)take(4.0 * maxtet, sizeof *adj);
    iw = (tess_int *)take(liw, sizeof *iw);
    rw = (double *)take(lrw, sizeof *rw);
    memset(tess_count, 0, sizeof tess_count);
    r.code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
    memcpy(r.count, tess_count, sizeof tess_count);
    r.proven = tess_check(n, p, ntet, tet, adj, liw, iw, &bad);
    tess_hull(ntet, tet, adj, (tess_int)0, &nfac, iw);
    r.n = n;
    r.ntet = ntet;
    r.hull = nfac;
    r.work = r.count[LISTED] + r.count[CANDIDATES] + r.count[NODES];
    free(p);
    free(tet);
    free(adj);
    free(iw);
    free(rw);
    return r;
}

/* growth - the exponent of n that a quantity grows with */
static double growth(const result *a, double x, const result *b, double y)
{
    return log(y / x) / log(b->n / a->n);
}

static void table(const char *family, const long *sizes, int rows)
{
    result r, last;
    int i;

    printf("              tetrahedra          per tetrahedron"
           "                              open facets, most\n");
    printf("        n    number  growth  searches  evaluations   L's  probes"
           "    number  per tetr.  growth of work\n");
    for (i = 0; i < rows; i++) {
        r = run(family, sizes[i]);
        if (r.code != TESS_OK) {
            printf("  %s %ld: code %d\n", family, sizes[i], r.code);
            continue;
        }
        printf("  %7.0f %9.0f", r.n, r.ntet);
        if (i == 0) printf("       -");
        else printf(" %7.2f", growth(&last, last.ntet, &r, r.ntet));
        printf(" %9.3f %12.1f %5.1f %7.2f %9.0f %10.4f",
               r.count[SEARCHES] / r.ntet, r.work / r.ntet,
               r.count[CANDIDATES] / r.ntet, r.count[PROBES] / r.ntet,
               r.count[POOL], r.count[POOL] / r.ntet);
        if (i == 0) printf("       -\n");
        else printf(" %7.2f\n", growth(&last, last.work, &r, r.work));
        last = r;
    }
}

static int check(void)
{
    result ball[2], moment[2];
    long faults[5];
    double grown;
    int i;

    memset(faults, 0, sizeof faults);
    for (i = 0; i < 2; i++) {
        ball[i] = run("ball", i == 0 ? 1000 : 16000);
        moment[i] = run("moment", i == 0 ? 100 : 200);
        faults[0] += ball[i].code != 0 || ball[i].proven != 0;
        faults[0] += moment[i].code != 0 || moment[i].proven != 0;
        /* the first facet is searched on one side, found by wrapping on the
         * other */
        faults[1] += ball[i].count[SEARCHES] !=
                     ball[i].ntet + ball[i].hull - 1.0;
        faults[1] += moment[i].count[SEARCHES] !=
                     moment[i].ntet + moment[i].hull - 1.0;
        faults[2] += moment[i].ntet !=
                     (moment[i].n - 2.0) * (moment[i].n - 3.0) / 2.0;
    }
    test_result("the tetrahedralizations are proven", faults[0]);
    test_result("one search a tetrahedron and a hull facet", faults[1]);
    test_result("moment curve: (n-2)(n-3)/2 tetrahedra", faults[2]);
    /* n log n would be 1.12 */
    grown = growth(&ball[0], ball[0].work + ball[0].count[PROBES], &ball[1],
                   ball[1].work + ball[1].count[PROBES]);
    test_result("ball: work grows linearly", grown > 1.1);
    grown = growth(&moment[0], moment[0].work + moment[0].count[PROBES],
                   &moment[1], moment[1].work + moment[1].count[PROBES]);
    test_result("moment curve: work grows at most like n^3", grown > 3.0);
    return test_end();
}

int main(int argc, char **argv)
{
    static const long balls[] = {1000, 3000, 10000, 30000, 100000, 300000};
    static const long moments[] = {125, 250, 500, 1000};

    if (argc > 1 && strcmp(argv[1], "-check") == 0) return check();
    printf("Uniform points in a ball\n\n");
    table("ball", balls, 6);
    printf("\nThe moment curve (t, t^2, t^3): (n-2)(n-3)/2 tetrahedra\n\n");
    table("moment", moments, 4);
    return 0;
}
