/* t_many.c - many.c's values beside those of each place alone, by the recipe
 * for it; the nearest point beside that of all; bad arguments; means.
 *
 *   cc -O2 -I. -o t_many test/recipes/t/t_many.c test/recipes/many.c \
 *       test/recipes/slopes.c test/recipes/natural.c \
 *       test/recipes/derived.c tess.c hhpred.c -lm
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../recipes.h"

#define N 600
#define NQ 900
#define MOST 60
#define ROUNDING 1e-12 /* of values of about 1 */

static tess_real p[3 * N], q[3 * NQ];
static tess_int tet[32 * N], adj[32 * N], ntet, t[NQ];
static tess_int iw[TESS_LIW(NQ) + 14 * MOST + 17], first[N + 1], list[32 * N];
static double rw[TESS_LRW(NQ) + 15 * MOST + 21];
static double value[2 * N], g[6 * N], work[9 * N], w[4 * NQ], out[2 * NQ];

/* fill - n random coordinates from low on. */
static void fill(tess_real *x, int n, double low, double size)
{
    static unsigned long seed = 1;
    int i;

    for (i = 0; i < n; i++) {
        seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
        x[i] = (tess_real)(low + size * (double)(seed >> 8) / 16777216.0);
    }
}

static int call(int method, tess_int nv, tess_int nq, tess_int most)
{
    return tr_many(N, p, ntet, tet, adj, method, nv, value, g, first, list, nq,
                   q, t, w, out, most, iw, rw);
}

static double square(const tess_real *a, const tess_real *b)
{
    double x = (double)a[0] - (double)b[0], y = (double)a[1] - (double)b[1];
    double z = (double)a[2] - (double)b[2];

    return x * x + y * y + z * z;
}

/* alone - value j at the place x by itself, and its weights. */
static double alone(int method, int j, const tess_real *x, double *weight,
                    int *outside)
{
    static tess_int nbr[MOST + 3], room[13 * MOST + 14];
    static double sibson[MOST + 3], laplace[MOST + 3], more[13 * MOST + 15];
    const double *v = value + N * j;
    tess_int nn = 0, s = TESS_NONE, k, near = 0;
    double f = 0.0;

    *outside = tess_locate(p, ntet, tet, adj, x, &s, weight);
    switch (method) {
    case TR_LINEAR:
        for (k = 0; k < 4; k++) f += weight[k] * v[tet[4 * s + k]];
        return f;
    case TR_SMOOTH:
        (void)tr_bent(p, ntet, tet, adj, v, g + 3 * N * j, 0.0, x, &s, &f);
        return f;
    case TR_NATURAL:
        (void)tr_natural(p, ntet, tet, adj, x, &s, MOST, &nn, nbr, sibson,
                         laplace, room, more);
        for (k = 0; k < nn; k++) f += sibson[k] * v[nbr[k]];
        return f;
    default:
        for (k = 1; k < N; k++)
            if (square(x, p + 3 * k) < square(x, p + 3 * near)) near = k;
        return v[near];
    }
}

/* right - are all places' values, weights and marks by this method right?  How
 * many places are outside goes to *beyond. */
static int right(int method, int *beyond)
{
    double x[4];
    int code, i, j, k, yes = 1, outside;

    code = call(method, 2, NQ, MOST);
    for (*beyond = i = 0; i < NQ; i++)
        for (j = 0; j < 2; j++) {
            if (fabs(alone(method, j, q + 3 * i, x, &outside) -
                     out[NQ * j + i]) > ROUNDING) yes = 0;
            if ((t[i] < 0) != outside) yes = 0;
            for (k = 0; k < 4 && method == TR_LINEAR && !outside; k++)
                if (fabs(w[4 * i + k] - x[k]) > ROUNDING) yes = 0;
            *beyond += j * outside;
        }
    return yes && code == 1;
}

/* averaged - are the means of three, two and one values right, and those of
 * equal ones what they are? */
static int averaged(void)
{
    static const tess_int same[6] = {0, 1, 0, 1, 0, 5};
    static const double want[12] = {4.0, 5.0, 4.0, 5.0, 4.0, 9.0,
                                    0.1, 0.3, 0.1, 0.3, 0.1, -1.0};
    double v[12] = {1.0, 2.0, 4.0, 8.0, 7.0, 9.0,
                    0.1, 0.3, 0.1, 0.3, 0.1, -1.0};
    double times[6];

    tr_average(6, same, 2, v, times);
    return memcmp(v, want, sizeof v) == 0;
}

int main(void)
{
    static const char *const name[4] = {"linear", "smooth", "natural",
                                        "nearest"};
    int i, k, yes, all = 1, outside, bad;

    fill(p, 3 * N, 0.0, 1.0);
    fill(q, 3 * NQ, -0.1, 1.2);
    /* equal places, and two zeros that are equal */
    for (i = 0; i < NQ; i++)
        for (k = 0; k < 3 && i % 5 == 0 && i > 99; k++)
            q[3 * i + k] = i % 2 ? (tess_real)0.0 : q[3 * (i - 99) + k];
    q[3 * 105] = -q[3 * 105];
    if (tess(N, p, 8 * N, &ntet, tet, adj, TESS_LIW(NQ), iw, TESS_LRW(NQ), rw))
        return 1;
    for (i = 0; i < N; i++) {
        value[i] = sin(5.0 * (double)p[3 * i]) * (double)p[3 * i + 1];
        value[N + i] = 1.0 - (double)p[3 * i + 2] * (double)p[3 * i + 2];
    }
    for (i = 0; i < 2; i++)
        if (tr_slopes(N, p, ntet, tet, adj, value + N * i, 3, g + 3 * N * i,
                      work))
            return 1;
    tr_stars(N, ntet, tet, first, list);

    printf("%d places, method  outside  as each alone\n", NQ);
    for (i = 0; i < 4; i++) {
        yes = right(i, &outside);
        printf("            %-7s %8d  %s\n", name[i], outside,
               yes ? "yes" : "no");
        all = all && yes;
    }
    bad = call(TR_SMOOTH, 0, NQ, MOST) == -7 && call(0, -1, NQ, MOST) == -7 &&
          call(0, 1, -1, MOST) == -12 && call(0, 1, NQ, 0) == -17 &&
          call(0, 1, 0, 1) == 0 && call(TR_NATURAL, 1, NQ, 5) == TESS_POOL;
    q[3] = (tess_real)HUGE_VAL;
    bad = bad && call(0, 1, NQ, MOST) == -13;
    ntet = 0;
    bad = bad && call(0, 1, NQ, MOST) == -3;
    printf("bad arguments are found: %s\n", bad ? "yes" : "no");
    yes = averaged();
    printf("means of points that coincide: %s\n", yes ? "yes" : "no");
    return !(all && bad && yes);
}
