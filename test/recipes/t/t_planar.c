/* t_planar.c - planar.c's triangles: two sets, one of them full of cocircular
 * points, against brute force, in whole numbers; bad input.
 *
 *   cc -O2 -I. -o t_planar test/recipes/t/t_planar.c \
 *       test/recipes/planar.c tess.c hhpred.c -lm
 */
#include <stdio.h>

#include "../recipes.h"

#define N 400
#define MAXTRI (2 * N)

static tess_real p[3 * (N + 1)];
static tess_int triangle[4 * MAXTRI], beside[4 * MAXTRI], iw[TESS_LIW(N + 1)];
static double rw[TESS_LRW(N + 1)];

/* make - the triangles of the first n points, with so much room. */
static int make(tess_int n, tess_int maxtri, tess_int *ntri)
{
    return tr_planar(n, p, maxtri, ntri, triangle, beside, TESS_LIW(N + 1), iw,
                     TESS_LRW(N + 1), rw);
}

/* small - the same for n of the points 0 0, 1 0, 0 1. */
static int small(tess_int n, tess_int maxtri, tess_int *ntri)
{
    int i;

    for (i = 0; i < 9; i++) p[i] = i == 3 || i == 7;
    return make(n, maxtri, ntri);
}

/* ---- checks, on whole coordinates below 1000: all is exact ---- */

/* turn - twice the area of a b c: positive counter-clockwise. */
static double turn(tess_int a, tess_int b, tess_int c)
{
    const tess_real *u = p + 3 * a, *v = p + 3 * b, *w = p + 3 * c;

    return ((double)v[0] - (double)u[0]) * ((double)w[1] - (double)u[1]) -
           ((double)v[1] - (double)u[1]) * ((double)w[0] - (double)u[0]);
}

/* inside - positive when d is inside of the circle of a b c. */
static double inside(tess_int a, tess_int b, tess_int c, tess_int d)
{
    double x[3], y[3], sum = 0.0;
    tess_int v[3];
    int i, j, k;

    v[0] = a;
    v[1] = b;
    v[2] = c;
    for (i = 0; i < 3; i++) {
        x[i] = (double)p[3 * v[i]] - (double)p[3 * d];
        y[i] = (double)p[3 * v[i] + 1] - (double)p[3 * d + 1];
    }
    for (i = 0; i < 3; i++) {
        j = (i + 1) % 3;
        k = (i + 2) % 3;
        sum += (x[i] * x[i] + y[i] * y[i]) * (x[j] * y[k] - x[k] * y[j]);
    }
    return sum;
}

/* check - the triangles fill the hull, given twice its area, their circles
 * are empty, and neighbours are mutual.  Returns 1 for a fault. */
static int check(tess_int n, tess_int ntri, double area)
{
    const tess_int *v;
    tess_int i, t, u;
    int j, k, bad = 0;

    for (t = 0; t < ntri; t++) {
        v = triangle + 3 * t;
        if (!(turn(v[0], v[1], v[2]) > 0.0)) bad = 1;
        area -= turn(v[0], v[1], v[2]);
        for (i = 0; i < n; i++)
            if (inside(v[0], v[1], v[2], i) > 0.0) bad = 1;
        for (k = 0; k < 3; k++) {
            u = beside[3 * t + k];
            if (u == TESS_NONE) continue;
            for (j = 0; j < 3 && beside[3 * u + j] != t; j++) continue;
            /* the side, seen from the other triangle, runs backwards */
            if (j == 3 ||
                triangle[3 * u + (j + 1) % 3] != v[(k + 2) % 3] ||
                triangle[3 * u + (j + 2) % 3] != v[(k + 1) % 3])
                bad = 1;
        }
    }
    return bad || area > 0.0 || area < 0.0;
}

int main(void)
{
    unsigned long seed = 1;
    tess_int n = 0, ntri;
    int i, k, bad, codes[7];

    /* the corners of a square, and points in it */
    for (i = 0; i < N; i++) {
        for (k = 0; k < 2; k++) {
            seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
            p[3 * i + k] = (tess_real)((seed >> 16) % 1000);
            if (i < 4) p[3 * i + k] = (tess_real)(i >> k & 1 ? 999 : 0);
        }
        p[3 * i + 2] = 0;
    }
    n = N;
    bad = make(n, MAXTRI, &ntri) != 0 || check(n, ntri, 2.0 * 999.0 * 999.0);
    printf("random: %ld points, %ld triangles: %s\n", (long)n, (long)ntri,
           bad ? "WRONG" : "right");

    /* a grid: four points on each circle; 2 triangles a square */
    for (i = 0; i < N; i++) {
        p[3 * i] = (tess_real)(i % 20);
        p[3 * i + 1] = (tess_real)(i / 20);
        p[3 * i + 2] = 0;
    }
    bad |= make(n, MAXTRI, &ntri) != 0 || check(n, ntri, 2.0 * 19.0 * 19.0) ||
           ntri != 2 * 19 * 19;
    printf("grid:   %ld points, %ld triangles: %s\n", (long)n, (long)ntri,
           bad ? "WRONG" : "right");

    /* on a line */
    for (i = 0; i < N; i++) p[3 * i + 1] = 0;
    k = make(n, MAXTRI, &ntri);
    printf("line:   code %d, %ld triangles\n", k, (long)ntri);
    bad |= k != TESS_PLANE || ntri != 0;

    /* a triangle; with too little room; one point, none; bad arguments */
    codes[0] = small(3, MAXTRI, &ntri);
    bad |= ntri != 1 || beside[0] != TESS_NONE || beside[1] != TESS_NONE ||
           beside[2] != TESS_NONE;
    codes[1] = small(3, 0, &ntri);
    bad |= ntri != 0;
    codes[2] = small(1, MAXTRI, &ntri);
    codes[3] = small(0, MAXTRI, &ntri);
    codes[4] = small(-1, MAXTRI, &ntri);
    codes[5] = small(3, -1, &ntri);
    bad |= ntri != 0;
    p[5] = 2;
    codes[6] = make(3, MAXTRI, &ntri);
    bad |= ntri != 1;
    printf("codes: ");
    for (i = 0; i < 7; i++) printf(" %d", codes[i]);
    printf("\n");
    return bad;
}
