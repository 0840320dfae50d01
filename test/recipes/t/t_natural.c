/* t_natural.c - natural.c's weights between two points of an integer lattice,
 * which have a closed form, and blend by the gradient of |x|^2.
 *
 *   cc -O2 -I. -o t_natural test/recipes/t/t_natural.c \
 *       test/recipes/natural.c tess.c hhpred.c -lm
 */
#include <stdio.h>

#include "../recipes.h"

/* Between two points of an integer lattice, and the gradient of |x|^2. */
int main(void)
{
    tess_int tet[800], adj[800], iw[TESS_LIW(36)], nbr[53], work[664], t = 0;
    tess_int nn, ntet, i;
    tess_real p[108], q[3] = {0.25, 0.0, 0.0};
    double rw[TESS_LRW(36) + 665], sibson[53], laplace[53], value[36], g[108];

    for (i = 0; i < 108; i++) {
        p[i] = (tess_real)(i % 3 == 0 ? i / 3 % 4 - 1
                                      : i / (i % 3 == 1 ? 12 : 36) % 3 - 1);
        g[i] = 2.0 * (double)p[i];
        if (i % 3 == 2) value[i / 3] = (g[i] * g[i] + g[i - 1] * g[i - 1] +
                                        g[i - 2] * g[i - 2]) / 4.0;
    }
    if (tess(36, p, 200, &ntet, tet, adj, TESS_LIW(36), iw, TESS_LRW(36), rw) ||
        tr_natural(p, ntet, tet, adj, q, &t, 50, &nn, nbr, sibson, laplace,
                   work, rw))
        return 1;
    printf("   point  Sibson    Laplace\n");
    for (i = 0; i < nn; i++)
        printf("%2.0f %2.0f %2.0f  %9.7f %9.7f\n", (double)p[3 * nbr[i]],
               (double)p[3 * nbr[i] + 1], (double)p[3 * nbr[i] + 2],
               sibson[i], laplace[i]);
    printf("|x|^2 blended: %9.7f\n", tr_blend(p, nn, nbr, sibson, value, g));
    return 0;
}
