/* number.h - digits written one by one, for programs of machines that have no
 * printf.  put is cortex.c's or run.js's, or the includer's.
 */
#if (defined(__arm__) && !defined(__linux__)) || defined(__wasm__)
void put(char c);
#elif !defined(__AVR__)
#include <stdio.h>

static void put(char c)
{
    putchar(c);
}
#endif

static void number(long n)
{
    char digits[12];
    int k = 0;

    if (n < 0) {
        put('-');
        n = -n;
    }
    do {
        digits[k++] = (char)('0' + n % 10);
        n /= 10;
    } while (n > 0);
    while (k > 0) put(digits[--k]);
    put(' ');
}
