/* queries.h - the queries of the location benchmark: M points in the box of
 * given points, in the order of a walk back and forth through the cells of a
 * grid (order 1), or in no order (0).  C and C++. */
#ifndef QUERIES_H
#define QUERIES_H

#define QUERIES 100000L

static void queries_make(long n, const double *p, int order, double *q)
{
    double lo[3], hi[3], at;
    unsigned long state = 12345UL;
    long side = 46, cell, i, c[3], t, there;
    int k;

    for (k = 0; k < 3; k++) {
        lo[k] = hi[k] = p[k];
        for (i = 1; i < n; i++) {
            if (p[3 * i + k] < lo[k]) lo[k] = p[3 * i + k];
            if (p[3 * i + k] > hi[k]) hi[k] = p[3 * i + k];
        }
    }
    for (i = 0; i < QUERIES; i++) {
        cell = (long)((double)i / (double)QUERIES * (double)(side * side * side));
        t = cell;
        c[2] = t / (side * side);
        t %= side * side;
        c[1] = c[2] % 2 ? side - 1 - t / side : t / side;
        there = (c[1] + c[2]) % 2;
        c[0] = there ? side - 1 - t % side : t % side;
        for (k = 0; k < 3; k++) {
            state = (state * 1664525UL + 1013904223UL) & 0xffffffffUL;
            at = (double)(state >> 8) / 16777216.0;
            if (order) at = ((double)c[k] + at) / (double)side;
            q[3 * i + k] = lo[k] + at * (hi[k] - lo[k]);
        }
    }
}

#endif
