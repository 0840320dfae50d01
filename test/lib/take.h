/* take.h - space for an array, or the program ends. */
#ifndef TAKE_H
#define TAKE_H

#include <stdio.h>
#include <stdlib.h>

static void *take(double count, size_t size)
{
    void *space = malloc((size_t)(count * (double)size) + 1);

    if (!space) {
        fprintf(stderr, "out of memory\n");
        exit(1);
    }
    return space;
}

#endif
