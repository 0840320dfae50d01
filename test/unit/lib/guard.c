/* guard.c - see guard.h. */
#include "guard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* With a sanitizer, which sees what is read outside of them, too, arrays have
 * their very lengths. */
#if defined(__SANITIZE_ADDRESS__) || defined(EXACT)
#define GUARD 0
#else
#define GUARD 64
#endif
#define FILL 0x5a
#define MOST 4096

int narrays;
static unsigned char *arrays[MOST];
static size_t lengths[MOST];

void *array(size_t length)
{
    unsigned char *b = (unsigned char *)malloc(length + 2 * GUARD +
                                               (length == 0 && GUARD == 0));
    size_t i;

    if (b == NULL || narrays == MOST) {
        fprintf(stderr, "guard.c: no memory\n");
        exit(2);
    }
    for (i = 0; i < GUARD; i++)
        b[i] = b[GUARD + length + i] = (unsigned char)(i * 37 + 11);
    memset(b + GUARD, FILL, length);
    arrays[narrays] = b;
    lengths[narrays++] = length;
    return b + GUARD;
}

tess_int *ints(tess_int n)
{
    return (tess_int *)array((size_t)n * sizeof(tess_int));
}

size_t length_of(int k)
{
    return lengths[k];
}

void release(int keep)
{
    while (narrays > keep) free(arrays[--narrays]);
}

int overrun(void)
{
    int a, bad = 0;
    size_t i;

    for (a = 0; a < narrays; a++) {
        unsigned char *b = arrays[a], *e = b + GUARD + lengths[a];

        for (i = 0; i < GUARD; i++)
            if (b[i] != (unsigned char)(i * 37 + 11) || e[i] != b[i]) {
                bad++;
                break;
            }
    }
    return bad;
}

tess_int leaves(tess_int n)
{
    tess_int l = 1;

    while (l < n / 48 + (n % 48 > 0)) l *= 2;
    return l;
}

int untouched(const void *a, size_t length)
{
    const unsigned char *b = (const unsigned char *)a;

    while (length > 0)
        if (b[--length] != FILL) return 0;
    return 1;
}
