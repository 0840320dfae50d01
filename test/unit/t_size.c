/* t_size.c - TESS_LIW and TESS_LRW against tess_size.
 *
 *   t_size          for all n to 100,000 and, further apart, to the largest
 *                   that tess takes, and beyond; as arrays' lengths, too
 *   t_size -bytes   the README's bytes a point
 */
#include <stdio.h>
#include <string.h>

#include "../../tess.h"
#include "../lib/exact.h"
#include "lib/guard.h"

/* what cannot be a constant expression does not compile */
#define TEN 10
static tess_int iw10[TESS_LIW(TEN)];
static double rw10[TESS_LRW(TEN)];

/* The macros do not know how long the lists are for which tess.c is compiled;
 * short ones leave out what these parts are for. */
#if defined(TESS_LIST) && TESS_LIST < 128
#define UNUSED(length) (length)
#else
#define UNUSED(length) 0
#endif

/* What is claimed of all n: a test each. */
enum { TAKEN, LIW_LONG, LRW_LONG, LIW_SHORT, LRW_SHORT, REFUSED, TETS, ENOUGH,
       LEAST, LESS_LIW, LESS_LRW, CLAIMS };
static const char *const claim[CLAIMS] = {
    "tess_size takes n", "TESS_LIW is long enough", "TESS_LRW is long enough",
    "TESS_LIW is no longer than it need be",
    "TESS_LRW is no longer than it need be",
    "tess_size refuses n, and its lengths are 0", "tess by TESS_LIW, TESS_LRW",
    "the lengths for any n are no shorter than the least",
    "the least lengths suffice", "a shorter iw is refused",
    "a shorter rw is refused"
};
static long faults[CLAIMS];

static void test(int ok, int which, long n)
{
    if (!ok && faults[which]++ < 5)
        printf("# not for n = %ld: %s\n", n, claim[which]);
}

static void sizes(tess_int n)
{
    tess_int liw, lrw;

    test(tess_size(n, 0, &liw, &lrw) == 0, TAKEN, (long)n);
    test(TESS_LIW(n) >= liw, LIW_LONG, (long)n);
    test(TESS_LRW(n) >= lrw, LRW_LONG, (long)n);
    test(TESS_LIW(n) - UNUSED(TESS_LS((long)n)) - liw <= 1210 + liw / 10 ||
             TESS_LIW(n) == TESS_INT_MOST,
         LIW_SHORT, (long)n);
    test(TESS_LRW(n) - UNUSED(TESS_LC((long)n)) - lrw <= 40 + lrw / 7,
         LRW_SHORT, (long)n);
}

/* bytes - the README's bytes a point: of the workspace, and with tetrahedra. */
static void bytes(void)
{
    static const long at[] = {100, 10000, 1000000};
    double point[3];
    int i;

    for (i = 0; i < 3; i++)
        point[i] = (4.0 * (double)TESS_LIW(at[i]) +
                    8.0 * (double)TESS_LRW(at[i])) / (double)at[i];
    printf("%.0f bytes a point for %ld points, %.0f for %ld, %.0f for %ld; with "
           "tetrahedra, 6.8 n of 32 bytes, %.0f, %.0f, %.0f.\n",
           point[0], at[0], point[1], at[1], point[2], at[2],
           point[0] + 32.0 * 6.8, point[1] + 32.0 * 6.8,
           point[2] + 32.0 * 6.8);
}

/* least - the least lengths are accepted, and any less are refused; what tess.h
 * says of all n suffices.  (All points in one place: -7, -9 come first.) */
static void least(void)
{
    static tess_int iw[9000], mine[2000];
    static double rw[8000];
    static tess_real p[3 * 2000];
    tess_int n, liw, lrw, index, ntet = 0;

    for (n = 1; n < 2000; n = (tess_int)(n + 1 + n / 50)) {
        liw = (tess_int)(4 * n + 2 * leaves(n) + 512);
        lrw = (tess_int)(3 * n + 12 * leaves(n));
        index = (tess_int)(2 * n + 2 * leaves(n) + 5);
        test(liw <= 4 * n + n / 12 + 514 && lrw <= 3 * n + n / 2 + 12, ENOUGH,
             (long)n);
        test(tess(n, p, 0, &ntet, NULL, NULL, liw, iw, lrw, rw) == TESS_POINT,
             LEAST, (long)n);
        test(tess(n, p, 0, &ntet, NULL, NULL, liw - 1, iw, lrw, rw) == -7,
             LESS_LIW, (long)n);
        test(tess(n, p, 0, &ntet, NULL, NULL, liw, iw, lrw - 1, rw) == -9,
             LESS_LRW, (long)n);
        test(tess_index(n, p, index, iw, lrw, rw) == TESS_POINT, LEAST,
             (long)n);
        test(tess_index(n, p, index - 1, iw, lrw, rw) == -3, LESS_LIW, (long)n);
        test(tess_index(n, p, index, iw, lrw - 1, rw) == -5, LESS_LRW, (long)n);
        test(tess_part(n, p, mine, 0, &ntet, NULL, NULL, liw, iw, lrw, rw) ==
                 TESS_POINT,
             LEAST, (long)n);
        test(tess_part(n, p, mine, 0, &ntet, NULL, NULL, liw - 1, iw, lrw,
                       rw) == -8,
             LESS_LIW, (long)n);
        test(tess_part(n, p, mine, 0, &ntet, NULL, NULL, liw, iw, lrw - 1,
                       rw) == -10,
             LESS_LRW, (long)n);
    }
}

int main(int argc, char **argv)
{
    static const double p[30] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0,
                                 0, 1, 1, 1, 1, 2, 1, 0, 1, 2,
                                 0, 0, 1, 2, 2, 0, 1, 3, 3, 1};
    tess_real q[30];
    tess_int tet[4 * 80], adj[4 * 80], ntet, liw, lrw, n, step;
    int i;

    if (argc == 2 && strcmp(argv[1], "-bytes") == 0) {
        bytes();
        return 0;
    }
    if (argc > 1) test_usage(argv[0], "[-bytes]");
    for (n = 0; (double)n < 1e5 && n < TESS_INT_MOST / 5 - 200; n++) sizes(n);
    if ((double)n >= 1e5)
        for (; n < TESS_INT_MOST / 5 - 200; n += step) {
            sizes(n);
            step = (tess_int)(n / ((double)n < 1e12 ? 1000 : 20) + n % 2);
        }
    /* all are taken up to one, and none beyond */
    if ((double)n > 1e12) n = (TESS_INT_MOST - 64) / 5;
    while (tess_size(n, 0, &liw, &lrw) == 0) sizes(n++);
    for (; n < TESS_INT_MOST - n / 9; n += n / 9)
        test(tess_size(n, 0, &liw, &lrw) == -1 && liw == 0 && lrw == 0,
             REFUSED, (long)n);
    for (i = 0; i < 30; i++) q[i] = (tess_real)p[i];
    test(tess(10, q, 80, &ntet, tet, adj, (tess_int)TESS_LIW(TEN), iw10,
              (tess_int)TESS_LRW(TEN), rw10) == 0,
         TETS, 10);
    least();
    for (i = 0; i < CLAIMS; i++) test_result(claim[i], faults[i]);
    return test_end();
}
