/* fuzz.h - what fuzz.c and fuzzarr.c share: the set of points, its bytes, and
 * with -DSTANDALONE a main, NAME [runs [seed]], that draws the bytes by chance. */
#include "../../tess.h"
#include "../proof/exact.h"

#include <stdio.h>
#include <stdlib.h>

/* The definition is verified of so few; 8 points have at most 20 tetrahedra. */
#define MOST 8
#define MAXTET 20

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size);

static const unsigned char *data, *end;
static int n;
static double p[MOST][3];
static tess_real point[3 * MOST];

static int byte(void)
{
    return data < end ? *data++ : 0;
}

static void stop(const char *what)
{
    int i;

    printf("FAILED  %s, %d points:\n", what, n);
    for (i = 0; i < n; i++)
        printf("%.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
    fflush(stdout);
    abort();
}

static void *room(tess_int length, size_t size)
{
    void *a = malloc((size_t)length * size);

    if (a == NULL && length > 0) exit(2);
    return a;
}

#ifdef STANDALONE
static void choose(unsigned char *bytes);

int main(int argc, char **argv)
{
    long runs = argc > 1 ? atol(argv[1]) : 2000, i;
    unsigned char bytes[200];
    int k;

    rnd_seed(argc > 2 ? strtoul(argv[2], NULL, 10) : 1);
    for (i = 0; i < runs; i++) {
        for (k = 0; k < 200; k++) bytes[k] = (unsigned char)rnd_below(256);
        choose(bytes);
        LLVMFuzzerTestOneInput(bytes, sizeof bytes);
    }
    printf("        %ld sets, 0 faults\n", runs);
    test_result(NAME, 0L);
    return test_end(NAME);
}
#endif
