/* time.c - time [-check]: the timings of the paper's Section 4.
 *
 * Prints a line for each loop and number of trials:
 *     TABLE TRIALS LOOP SECONDS
 * SECONDS is the CPU time of one evaluation, the set-up amortized over the
 * trials.  All loops are timed in turn, RUNS times, each time for at least a
 * few milliseconds; the least of the times counts.
 *
 * Compiled with -DCBLAS it has the BLAS of C, with -DFORTRAN the loops of
 * loops.f, blas.f and a BLAS of Fortran.
 *
 * With -check it tests instead that all loops compute the same: each
 * L-coordinate within the bound of its error, and each determinant of the
 * exact sign.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include "../../hhpred.h"
#include "../lib/exact.h"
#include "loops.h"

#define RUNS 9
#define POINTS 1000

/* A loop's kind is what it computes; its tables, 1 or 2 or both. */
enum { L, DETS, CALLS };
static const struct {
    const char *name;
    loop *run;
    int kind, tables;
} loops[] = {
    {"C", lp_house, L, 3},
    {"C-dets", lp_dets, DETS, 2},
#ifdef CBLAS
    {"C-blas", lp_blas, L, 1},
    {"C-calls", lp_calls, CALLS, 1},
#endif
#ifdef FORTRAN
    {"F", lphous_, L, 3},
    {"F-dets", lpdets_, DETS, 2},
    {"F-blas", lpblas_, L, 1},
    {"F-calls", lpcall_, CALLS, 1},
#endif
};
#define LOOPS ((int)(sizeof loops / sizeof *loops))

static double p[12], z[3 * POINTS];
static const int nz = POINTS;
static double v[POINTS];
static volatile double sink;

static double sym(void) { return 4.0 * rnd_unit() - 2.0; }

/* Coordinates below 2 in absolute value, all z on the positive side. */
static void make(void)
{
    double t;
    int i, k;

    for (i = 0; i < 12; i++) p[i] = sym();
    if (hh_orient(p, p + 3, p + 6, p + 9) < 0)
        for (k = 0; k < 3; k++) {
            t = p[k];
            p[k] = p[3 + k];
            p[3 + k] = t;
        }
    for (i = 0; i < POINTS; i++)
        do {
            for (k = 0; k < 3; k++) z[3 * i + k] = sym();
        } while (hh_orient(p, p + 3, p + 6, z + 3 * i) <= 0);
}

/* many - the CPU seconds of count runs of a loop with so many trials */
static double many(int i, int trials, long count)
{
    clock_t start = clock();

    while (count-- > 0) {
        loops[i].run(&trials, p, &nz, z, v);
        sink = v[count % POINTS];
    }
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

/* row - time all loops of a table with so many trials */
static void row(int table, int trials)
{
    double least[LOOPS], t;
    long count[LOOPS];
    int i, run;

    for (i = 0; i < LOOPS; i++) {
        least[i] = 0.0;
        count[i] = 1;
        if (!(table & loops[i].tables)) continue;
        while (many(i, trials, count[i]) < 0.005) count[i] *= 2;
    }
    for (run = 0; run < RUNS; run++)
        for (i = 0; i < LOOPS; i++) {
            if (!(table & loops[i].tables)) continue;
            t = many(i, trials, count[i]) / (double)count[i] / trials;
            if (run == 0 || t < least[i]) least[i] = t;
        }
    for (i = 0; i < LOOPS; i++)
        if (table & loops[i].tables)
            printf("%d %d %s %.4e\n", table, trials, loops[i].name, least[i]);
}

static int check(void)
{
    double f[HH_FACET_LEN], x, l, dl, w, gap, *q;
    long faults;
    int one = 1, i, j, k;
    char name[80];

    for (i = 0; i < LOOPS; i++) {
        if (loops[i].kind == CALLS) continue;
        faults = 0;
        rnd_seed(1);
        for (j = 0; j < POINTS; j++) {
            if (j % 100 == 0) make();
            q = z + 3 * j;
            loops[i].run(&one, p, &one, q, &x);
            if (loops[i].kind == DETS) {
                /* degree 5 in coordinates below 2: far above the roundings */
                faults += fabs(x) > 1e-11 &&
                          (x > 0.0 ? 1 : -1) !=
                              hh_insphere(p, p + 3, p + 6, p + 9, q);
                continue;
            }
            hh_facet(p, p + 3, p + 6, f);
            for (k = 0, w = 0.0; k < 3; k++)
                w += (q[k] - f[6 + k]) * (q[k] - f[6 + k]);
            w = sqrt(w);
            l = hh_lcoord(f, q);
            gap = fabs(hh_side(f, q)) - f[9] * w;
            dl = w * (DBL_EPSILON * (3.0 * w + 5.0 * f[11]) + f[10] +
                      fabs(l) * f[9]) / gap + 4.0 * DBL_EPSILON * fabs(l);
            faults += gap > 0.0 && !(fabs(x - l) <= 2.0 * dl);
        }
        sprintf(name, "%s: right at %d points", loops[i].name, POINTS);
        test_result(name, faults);
    }
    return test_end();
}

int main(int argc, char **argv)
{
    int i;

    if (argc > 1 && strcmp(argv[1], "-check") == 0) return check();
    rnd_seed(1);
    make();
    for (i = 1; i <= 10; i++) row(1, 10000 * i);
    for (i = 1; i <= 10; i++) row(2, 100 * i);
    for (i = 1; i <= 10; i++) row(2, 10000 * i);
    return 0;
}
