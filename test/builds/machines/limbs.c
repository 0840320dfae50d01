/* limbs.c - which coordinates this build's HH_LIMBS hold: a line for each kind,
 * with the code of tess.  See reach.sh. */
#include <math.h>
#include <stdio.h>

#include "../../../tess.h"

#define N 60
#define SETS 20

static tess_real p[3 * N];
static tess_int tet[4 * 12 * N], adj[4 * 12 * N], iw[TESS_LIW(N)];
static double rw[TESS_LRW(N)];

static const char *const name[] = {
    "whole numbers below 32768",
    "floats, 0 to 1",
    "floats, 0.000001 to 100",
    "floats of every magnitude",
    "doubles, thousandths to 1000",
    "doubles, 0 to 1",
    "doubles, 0.000001 to 100",
    "doubles, 1e-12 to 1e6",
    "doubles, 6,000,000 and a fraction",
    "doubles of every magnitude"};

/* random01 - of 53 bits. */
static double random01(void)
{
    static unsigned long seed = 1;
    double x = 0.0;
    int i;

    for (i = 0; i < 4; i++) {
        seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
        x = (x + (double)(seed >> 18)) / 16384.0;
    }
    return x;
}

/* between - every magnitude alike. */
static double between(double least, double most)
{
    double x = random01();

    return pow(least, 1.0 - x) * pow(most, x);
}

static double coordinate(int kind)
{
    switch (kind) {
    case 0: return floor(32768.0 * random01());
    case 1: return (double)(float)random01();
    case 2: return (double)(float)between(1e-6, 100.0);
    case 3: return (double)(float)between(1e-38, 1e38);
    case 4: return floor(1e6 * random01()) / 1000.0;
    case 5: return random01();
    case 6: return between(1e-6, 100.0);
    case 7: return between(1e-12, 1e6);
    case 8: return 6e6 + random01();
    default: return between(1e-300, 1e300);
    }
}

int main(void)
{
    tess_int ntet;
    int kind, set, i, code, worst;

    for (kind = 0; kind < (int)(sizeof name / sizeof name[0]); kind++) {
        for (worst = set = 0; set < SETS; set++) {
            for (i = 0; i < 3 * N; i++) p[i] = (tess_real)coordinate(kind);
            code = tess(N, p, 12 * N, &ntet, tet, adj, (tess_int)TESS_LIW(N),
                        iw, (tess_int)TESS_LRW(N), rw);
            if (code > worst) worst = code;
        }
        printf("%d %s\n", worst, name[kind]);
    }
    return 0;
}
