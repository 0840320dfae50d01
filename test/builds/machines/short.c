/* short.c - doubles of 24 bits and a processor that flushes what underflows, as
 * some small machines have both: here floats of an x86 processor.
 *
 * Sets of small multiples of 2^-29 in a box of size 1 are meshed with gradual
 * underflow and without.  A product of five such multiples underflows, though
 * no coordinate does.  Prints how many sets there were; the code is 1 if a
 * result differs, or tess_check finds a fault.  All files take -include
 * test/builds/machines/short.h.
 */
#include <stdio.h>
#include <string.h>
#include <xmmintrin.h>
#include "../../../tess.h"

#define N 48
#define MAXTET 2000

int main(void)
{
    static double p[3 * N], rw[TESS_LRW(N)];
    static tess_int tet[2][4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
    tess_int ntet[2], bad;
    long chance = 1;
    int set, i, k, flush, code, faults = 0;

    for (set = 0; set < 60; set++) {
        for (i = 0; i < 3 * N; i++) {
            chance = (chance * 137 + 1) % 30269;
            p[i] = (double)(chance % (6 + set % 5 * 2)) / 536870912.0f;
        }
        for (i = 0; i < 8; i++) {
            p[3 * i] = i & 1 ? 0.9375f : -0.75f;
            p[3 * i + 1] = i & 2 ? 0.8125f : -0.875f;
            p[3 * i + 2] = i & 4 ? 0.75f : -0.6875f;
        }
        for (flush = 0; flush < 2; flush++) {
            _MM_SET_FLUSH_ZERO_MODE(flush ? _MM_FLUSH_ZERO_ON
                                          : _MM_FLUSH_ZERO_OFF);
            code = tess(N, p, MAXTET, ntet + flush, tet[flush], adj,
                        TESS_LIW(N), iw, TESS_LRW(N), rw);
            _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_OFF);
            faults += code != TESS_OK ||
                      tess_check(N, p, ntet[flush], tet[flush], adj,
                                 TESS_LIW(N), iw, &bad) != TESS_OK;
        }
        k = ntet[0] == ntet[1];
        faults += !k || memcmp(tet[0], tet[1], 16 * (size_t)ntet[0]) != 0;
    }
    printf("%d sets, %d faults\n", set, faults);
    return faults > 0;
}
