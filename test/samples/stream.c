/* stream.c - a mesh larger than memory: part after part, none kept.
 *
 *   cc -O2 -I. -o stream test/samples/stream.c tess.c hhpred.c -lm
 *
 * Points in a cube, its corners among them, are sorted once.  tess_part
 * computes the tetrahedra at a range of positions; those whose vertex of least
 * index is in the range are used, here to sum up volumes, and forgotten.
 * Each tetrahedron of the mesh is used once, so the sum is the cube's volume.
 * A part that fails can be done again, alone.  The stars of a part reach into
 * others: for a million points in 64 parts 1.14 times the mesh's tetrahedra are
 * computed.
 *
 * Arrays: per point 24 bytes of coordinates, 28 in rw, 24 and pool in iw, 4
 * marks; per tetrahedron of the largest part 32, instead of 220 a point.
 */
#include <math.h>
#include <stdio.h>

#include "tess.h"

#ifndef N
#define N 1000000L
#endif
#define PARTS 64
#define MAXTET (N / PARTS * 10)
#define LIW (6 * N + 4000000L)
#define LRW (4 * N)

static tess_real p[3 * N];
static double rw[LRW];
static tess_int iw[LIW], mine[N], tet[4 * MAXTET], adj[4 * MAXTET];

/* Six times the volume of the tetrahedron v. */
static double six(const tess_int *v)
{
    double e[9];
    int i, k;

    for (i = 0; i < 3; i++)
        for (k = 0; k < 3; k++)
            e[3 * i + k] = (double)p[3 * v[i + 1] + k] -
                           (double)p[3 * v[0] + k];
    return e[0] * (e[4] * e[8] - e[5] * e[7]) +
           e[1] * (e[5] * e[6] - e[3] * e[8]) +
           e[2] * (e[3] * e[7] - e[4] * e[6]);
}

int main(void)
{
    tess_int i, t, ntet, most = 0;
    double total = 0.0, computed = 0.0, used = 0.0;
    long seed = 1, part;
    int code, k, own;

    for (i = 0; i < 3 * N; i++) {
        seed = 16807 * (seed % 127773) - 2836 * (seed / 127773);
        if (seed <= 0) seed += 2147483647L;
        p[i] = (tess_real)((double)seed / 2147483648.0);
        if (i < 24) p[i] = (tess_real)(i / 3 >> i % 3 & 1);
    }
    code = tess_index(N, p, LIW, iw, LRW, rw);
    if (code != 0) return code;
    for (part = 0; part < PARTS; part++) {
        for (i = 0; i < N; i++)
            mine[i] = (long)((double)iw[i] * PARTS / N) == part;
        ntet = 0;
        code = tess_part(N, p, mine, MAXTET, &ntet, tet, adj, LIW, iw, LRW,
                         rw);
        if (code != 0) return code;
        for (t = 0; t < ntet; t++) {
            i = tet[4 * t];
            for (k = 1; k < 4; k++) if (tet[4 * t + k] < i) i = tet[4 * t + k];
            own = mine[i] != 0;
            used += own;
            if (own) total += six(tet + 4 * t);
        }
        computed += (double)ntet;
        most = ntet > most ? ntet : most;
    }
    printf("%ld points in %d parts\n", N, PARTS);
    printf("%.0f tetrahedra, at most %ld at a time, %.2f times computed\n",
           used, (long)most, computed / used);
    printf("volume %.9f\n", total / 6.0);
    return fabs(total / 6.0 - 1.0) > 1e-9;
}
