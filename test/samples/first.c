/* first.c - the tetrahedra of a file's points.
 *
 *   cc -O3 -I. -o first test/samples/first.c tess.c hhpred.c -lm
 *   ./first < test/data/mirror.xyz
 *
 * A line is a point if it begins with three numbers; others are counted.  In
 * FORTRAN 77 it is f77/first.f, in Python first.py.
 */
#include <stdio.h>

#include "tess.h"

#define N 4000
#define MAXTET (8 * N)

static double p[3 * N + 3], rw[TESS_LRW(N)];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];

int main(void)
{
    char line[1000];
    tess_int n = 0, ntet;
    int code, other = 0;

    while (fgets(line, sizeof line, stdin))
        if (sscanf(line, "%lf %lf %lf", p + 3 * n, p + 3 * n + 1,
                   p + 3 * n + 2) != 3)
            other++;
        else if (n++ == N) {
            printf("more than %d points\n", N);
            return 1;
        }
    code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw);
    printf("%ld points, %d other lines: code %d, %ld tetrahedra\n", (long)n,
           other, code, (long)ntet);
    return code;
}
