/* count.c - how many instructions 64 sensors take on a Cortex-M: their mesh, a
 * place located in it, and the same by tess_index and tess_query, without it.
 *
 * For qemu-system-arm -icount shift=10, which lets 1024 nanoseconds pass with
 * each instruction, and its boards mps2, which have a timer of 25 MHz: so an
 * instruction is 25.6 of its ticks.  Written is first the count of a loop of
 * 2000 instructions, which shows that this is so; then those of tess, of
 * tess_locate (without a start, the mean of 100 places), tess_index and
 * tess_query (likewise); then the sum of the codes, the number of tetrahedra and
 * a sum of what was found, which are the same on other machines.  There all
 * counts are 0.  See reach.sh.
 */
#include "../../../tess.h"
#include "number.h"

#if defined(__arm__) && !defined(__linux__)
#define TIMER ((volatile unsigned *)0x40000000) /* counts down */

/* since - instructions since the last call, which set the timer to its start. */
static long since(void)
{
    unsigned passed = 0xffffffffU - TIMER[1];

    TIMER[2] = 0xffffffffU; /* its value, too */
    TIMER[0] = 1;           /* it runs */
    return (long)(passed / 128 * 5 + passed % 128 * 5 / 128);
}

static void loop(void)
{
    unsigned n = 1000;

    __asm__ volatile(".syntax unified\n1:\tsubs %0, #1\n\tbne 1b"
                     : "+l"(n)
                     :
                     : "cc");
}
#else
static long since(void)
{
    return 0;
}

static void loop(void)
{
}
#endif

#define N 64
#define PLACES 100
#define TETS (7 * N)

static tess_real p[3 * N], q[3 * PLACES];
static tess_int tet[4 * TETS], adj[4 * TETS], iw[TESS_LIW(N)], ntet;
static double rw[TESS_LRW(N)];

/* places - in a block of 100 x 100 x 30, as in sensor.c. */
static void places(int n, tess_real *x, unsigned long *state)
{
    int i;

    for (i = 0; i < 3 * n; i++) {
        *state = (*state * 1103515245UL + 12345UL) & 0x7fffffffUL;
        x[i] = (tess_real)((double)((*state >> 16) % (i % 3 == 2 ? 301 : 1001)) *
                           0.1);
    }
}

int main(void)
{
    unsigned long state = 1;
    tess_int t, v[4];
    double w[4];
    long sum = 0, counts[5];
    int i, k, codes = 0;

    places(N, p, &state);
    places(PLACES, q, &state);
    since();
    loop();
    counts[0] = since();
    codes += tess(N, p, TETS, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N), rw);
    counts[1] = since();
    counts[2] = counts[4] = 0;
    for (i = 0; i < PLACES; i++) {
        t = TESS_NONE;
        since();
        codes += tess_locate(p, ntet, tet, adj, q + 3 * i, &t, w);
        counts[2] += since();
        sum = (sum * 31 + t) % 1000003L;
    }
    since();
    codes += tess_index(N, p, TESS_LIW(N), iw, TESS_LRW(N), rw);
    counts[3] = since();
    for (i = 0; i < PLACES; i++) {
        v[0] = TESS_NONE;
        since();
        codes += tess_query(N, p, iw, rw, q + 3 * i, v, w);
        counts[4] += since();
        for (k = 0; k < 4; k++) sum = (sum * 31 + v[k]) % 1000003L;
    }
    counts[2] /= PLACES;
    counts[4] /= PLACES;
    for (i = 0; i < 5; i++) number(counts[i]);
    number(codes);
    number(ntet);
    number(sum);
    put('\n');
    return 0;
}
