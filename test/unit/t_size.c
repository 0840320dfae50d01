/* t_size.c - TESS_LIW and TESS_LRW against tess_size.
 *
 *   t_size          for all n to 100,000 and, further apart, to the largest
 *                   that tess takes, and beyond; as arrays' lengths, too
 *   t_size -table   the README's table of sizes
 */
#include <stdio.h>
#include <string.h>

#include "../../tess.h"

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

static long passed, failed;

static void test(int ok, const char *what, long n)
{
    if (ok) {
        passed++;
        return;
    }
    failed++;
    if (failed < 20) printf("FAILED  %s, n = %ld\n", what, n);
}

static void sizes(tess_int n)
{
    tess_int liw, lrw;

    test(tess_size(n, 0, &liw, &lrw) == 0, "tess_size", (long)n);
    test(TESS_LIW(n) >= liw, "TESS_LIW is too small", (long)n);
    test(TESS_LRW(n) >= lrw, "TESS_LRW is too small", (long)n);
    test(TESS_LIW(n) - UNUSED(TESS_LS((long)n)) - liw <= 1210 + liw / 10 ||
             TESS_LIW(n) == TESS_INT_MOST,
         "TESS_LIW is too large", (long)n);
    test(TESS_LRW(n) - UNUSED(TESS_LC((long)n)) - lrw <= 40 + lrw / 7,
         "TESS_LRW is too large", (long)n);
}

static void table(void)
{
    static const long at[] = {100, 1000, 10000, 100000, 1000000};
    size_t i;

    for (i = 0; i < sizeof at / sizeof at[0]; i++)
        printf("| %ld | %ld | %ld | %.0f | %.0f |\n", at[i], TESS_LIW(at[i]),
               TESS_LRW(at[i]),
               (4.0 * (double)TESS_LIW(at[i]) + 8.0 * (double)TESS_LRW(at[i])) /
                   (double)at[i],
               (4.0 * (double)TESS_LIW(at[i]) + 8.0 * (double)TESS_LRW(at[i])) /
                       (double)at[i] +
                   32.0 * 6.8);
}

int main(int argc, char **argv)
{
    static const double p[30] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0,
                                 0, 1, 1, 1, 1, 2, 1, 0, 1, 2,
                                 0, 0, 1, 2, 2, 0, 1, 3, 3, 1};
    tess_real q[30];
    tess_int tet[4 * 80], adj[4 * 80], ntet, liw, lrw, n, step;
    int i;

    if (argc > 1 && strcmp(argv[1], "-table") == 0) {
        table();
        return 0;
    }
    for (n = 0; n < 100000 && n < TESS_INT_MOST / 5 - 200; n++) sizes(n);
    if (n == 100000)
        for (; n < TESS_INT_MOST / 5 - 200; n += step) {
            sizes(n);
            step = n / ((double)n < 1e12 ? 1000 : 20) + n % 2;
        }
    /* all are taken up to one, and none beyond */
    if ((double)n > 1e12) n = (TESS_INT_MOST - 64) / 5;
    while (tess_size(n, 0, &liw, &lrw) == 0) sizes(n++);
    for (; n < TESS_INT_MOST - n / 9; n += n / 9)
        test(tess_size(n, 0, &liw, &lrw) == -1 && liw == 0 && lrw == 0,
             "tess_size", (long)n);
    for (i = 0; i < 30; i++) q[i] = (tess_real)p[i];
    test(tess(10, q, 80, &ntet, tet, adj, (tess_int)TESS_LIW(TEN), iw10,
              (tess_int)TESS_LRW(TEN), rw10) == 0,
         "tess", 10);
    printf("t_size: %ld passed, %ld failed\n", passed, failed);
    return failed > 0;
}
