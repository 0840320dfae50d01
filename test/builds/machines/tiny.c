/* tiny.c - tess on a machine of 16 kilobytes: a few small sets, each with its
 * codes, the number of tetrahedra and a checksum of tet and adj.
 *
 * Writes the same with every compiler.  On an AVR, where int has 16 bits and
 * double 24, it writes to the first serial port and then sleeps with the
 * interrupts off, which ends simavr; see check.sh.  On a Cortex-M cortex.c
 * writes, in WebAssembly run.js.  With -DPAINT, but there, the last line is the
 * bytes of stack in use at most, what has been painted before and is no longer,
 * with a set besides that takes all the limbs there are.
 */
#include "../../../tess.h"

#ifdef PAINT
#ifdef __AVR__
#define LOW __heap_start
#else
#define LOW bss_end
#endif
extern char LOW[];
#define COLOUR 0x5a
#endif

#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>

static void put(char c)
{
    while (!(UCSR0A & (1 << UDRE0)))
        ;
    UDR0 = (unsigned char)c;
}
#endif
#include "number.h"

#define POINTS 24
#define TETS 90
#define LIW TESS_LIW(POINTS)
#define LRW TESS_LRW(POINTS)

static tess_real p[3 * POINTS];
static tess_int tet[4 * TETS], adj[4 * TETS], iw[LIW];
static double rw[LRW];

/* points - kind 0 general, 1 of a lattice with duplicates, 2 flat, 3 with
 * fractions, 4 of magnitudes far apart. */
static void points(int kind, unsigned long *state)
{
    long r;
    int i;

    for (i = 0; i < 3 * POINTS; i++) {
        *state = (*state * 1103515245UL + 12345UL) & 0x7fffffffUL;
        r = (long)(*state >> 16);
        if (kind == 1) r %= 3;
        if (kind == 3) r %= 200;
        p[i] = (tess_real)r;
        if (kind == 4) r = r % 64 + 1;
        if (kind == 2 && i % 3 == 2) p[i] *= (tess_real)(1.0 / 1048576.0);
        if (kind == 3) p[i] *= (tess_real)(1.0 / 8.0);
        if (kind == 4)
            for (r = i % 4 * (sizeof p[i] > 4 ? 300 : 25); r > 0; r--)
                p[i] *= (tess_real)0.5;
    }
}

int main(void)
{
    tess_int ntet = 0, liw, lrw, bad, i;
    unsigned long state = 1;
    long sum;
    int kind, code;
#ifdef PAINT
    volatile char here, *c;

    for (c = LOW; c < &here - 64; c++) *c = COLOUR;
#endif

#ifdef __AVR__
    UBRR0L = 0;
    UCSR0B = 1 << TXEN0;
#endif
    for (kind = 0; kind < 4; kind++) {
        points(kind, &state);
        code = tess_size(POINTS, TETS, &liw, &lrw);
        number(code);
        number(liw <= LIW && lrw <= LRW);
        code = tess(POINTS, p, TETS, &ntet, tet, adj, LIW, iw, LRW, rw);
        number(code);
        number(ntet);
        sum = 0;
        for (i = 0; i < 4 * ntet; i++)
            sum = (sum * 31 + tet[i] * 7 + adj[i] + 5) % 1000003L;
        number(sum);
        number(tess_check(POINTS, p, ntet, tet, adj, LIW, iw, &bad));
        put('\n');
    }
#ifdef PAINT
    points(4, &state);
    tess(POINTS, p, TETS, &ntet, tet, adj, LIW, iw, LRW, rw);
    for (c = LOW; *c == COLOUR; c++) continue;
    number((long)(&here - c));
    put('\n');
#endif
#ifdef __AVR__
    cli();
    sleep_enable();
    sleep_cpu();
#endif
    return 0;
}
