/* sensor.c - interpolation between sensors on a machine of 16 kilobytes.
 *
 *   cc -O2 -I. -o sensor test/samples/sensor.c tess.c hhpred.c -lm
 *   avr-gcc -std=gnu89 -mmcu=atmega1284p -O2 -DTESS_LIST=64 \
 *       -ffunction-sections -Wl,--gc-sections -I. -o sensor.elf \
 *       test/samples/sensor.c tess.c hhpred.c -lm
 *
 * 100 sensors in a block of 100 x 100 x 30 mm.  There is no room for the mesh
 * of some 500 tetrahedra; tess_query finds the one that is asked for.  A probe
 * walks through the block, and each answer is where the next walk starts.
 * The values measured are here a linear function, which interpolation must
 * reproduce.  Written are: code of tess_index; positions inside; a checksum of
 * all vertices, the same on every machine; values that are wrong.
 */
#include "tess.h"
#ifdef __AVR__
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#else
#include <stdio.h>
#endif

#define N 100
#define LIW (2 * N + N / 12 + 7)
#define LRW (3 * N + N / 2 + 12)

static tess_real p[3 * N];
static tess_int iw[LIW];
static double rw[LRW];
static double value[N];

static void put(char c)
{
#ifdef __AVR__
    while (!(UCSR0A & (1 << UDRE0)))
        ;
    UDR0 = (unsigned char)c;
#else
    putchar(c);
#endif
}

static void number(long n)
{
    char digit[12];
    int k = 0;

    do {
        digit[k++] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    while (k > 0) put(digit[--k]);
    put(' ');
}

static double field(const tess_real *q)
{
    return 20.0 + 0.25 * (double)q[0] - 0.125 * (double)q[1] +
           0.5 * (double)q[2];
}

int main(void)
{
    unsigned long state = 1;
    tess_int v[4];
    tess_real q[3];
    double w[4], x;
    long inside = 0, wrong = 0, sum = 0;
    int i, k, code;

#ifdef __AVR__
    UBRR0L = 0;
    UCSR0B = 1 << TXEN0;
#endif
    for (i = 0; i < 3 * N; i++) {
        state = (state * 1103515245UL + 12345UL) & 0x7fffffffUL;
        p[i] = (tess_real)((state >> 16) % (i % 3 == 2 ? 31 : 101));
    }
    for (i = 0; i < N; i++) value[i] = field(p + 3 * i);
    code = tess_index(N, p, LIW, iw, LRW, rw);
    number(code);
    v[0] = TESS_NONE;
    for (i = 0; i < 200; i++) {
        q[0] = (tess_real)(2 + i * 0.5);
        q[1] = (tess_real)(i % 64 < 32 ? 20 + i % 64 : 84 - i % 64);
        q[2] = (tess_real)(12 + i % 8 * 0.5);
        code = tess_query(N, p, iw, rw, q, v, w);
        for (k = 0; k < 4; k++) sum = (sum * 31 + v[k] + 1) % 1000003L;
        if (code != 0) continue;
        inside++;
        x = 0.0;
        for (k = 0; k < 4; k++) x += w[k] * value[v[k]];
        x -= field(q);
        wrong += x > 1e-3 || x < -1e-3;
    }
    number(inside);
    number(sum);
    number(wrong);
    put('\n');
#ifdef __AVR__
    cli();
    sleep_enable();
    sleep_cpu();
#endif
    return code > 1 || wrong > 0;
}
