/* fuzz.c - bytes as points: tess, verified, for libFuzzer.
 *
 *     clang -fsanitize=fuzzer,address,undefined ... test/fuzz/fuzz.c
 *
 * With -DSTANDALONE it has a main of its own, fuzz [runs [seed]], that draws the
 * bytes by chance.  All arrays have the least lengths and are allocated one by
 * one, so that a sanitizer sees an access outside of them.  Then the result is
 * damaged (unit/lib/damage.h).  Stops at the first fault.
 */
#include "../lib/hard.h"
#include "../lib/exact.h"
#include "../lib/verify.h"
#include "../unit/lib/damage.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

    printf("# fault: %s, %d points:\n", what, n);
    for (i = 0; i < n; i++)
        printf("# %.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
    fflush(stdout);
    abort();
}

static void *room(tess_int length, size_t size)
{
    void *a = malloc((size_t)length * size);

    if (a == NULL && length > 0) exit(2);
    return a;
}

/* One of 0 ... below-1. */
static int draw(int below)
{
    int b = byte();

    if (below > 256) b = 256 * b + byte();
    return b % below;
}

/* Ties come of few values in a set: 0, 1 and three that it chooses. */
#define CHOSEN 5
static double chosen[CHOSEN];

static const double few[] = {
    0.0, -0.0, 1.0, -1.0, 2.0, 0.5, 3.0, 0.1, 0.2, 0.30000000000000004,
    4.9406564584124654e-324, -4.9406564584124654e-324, 1e-310, DBL_MIN, -DBL_MIN,
    DBL_MAX, -DBL_MAX, 8.9e307, DBL_EPSILON, 1.0 + DBL_EPSILON,
    1.0 - DBL_EPSILON / 2, 1e-13, 1e150, 1e-150, 1e100, 1e-100, 1e-60,
    3.4395525670743494e-136, 9.3326361850321888e-302
};

static double value(void)
{
    return few[byte() % (int)(sizeof few / sizeof *few)];
}

static double coordinate(int known)
{
    int b = byte(), i;
    unsigned char raw[sizeof(double)];
    double x;

    if (b < 90) return b < 80 ? chosen[b % CHOSEN] : value();
    if (b < 120) {
        for (i = 0; i < (int)sizeof raw; i++) raw[i] = (unsigned char)byte();
        memcpy(&x, raw, sizeof x);
        /* false for a NaN, too */
        return x >= -DBL_MAX && x <= DBL_MAX ? x : 0.0;
    }
    if (b < 170 && known > 0) {
        i = byte() % known;
        return hard_nudge(p[i / 3][i % 3], byte() % 5 - 2);
    }
    if (b < 210) {
        x = byte() % 16 + 1;
        i = 256 * byte();
        i += byte();
        return ldexp(b % 2 ? x : -x, i % 2090 - 1074);
    }
    return b % 5 - 1;
}

/* The whole result again in steps, in arrays of no more than the least
 * lengths: they are copied into longer ones when full. */
static void steps(int code, tess_int ntet, const tess_int *tet,
                  const tess_int *adj, tess_int liw, tess_int lrw)
{
    tess_int m = 0, room4 = 0, *t = room(0, 1), *a = room(0, 1);
    tess_int *iw = room(liw, sizeof *iw), *more;
    double *rw = room(lrw, sizeof *rw);
    int now;

    for (;;) {
        now = tess_resume((tess_int)n, point, room4, &m, t, a, liw, iw, lrw, rw);
        if (now == TESS_POOL) {
            liw += 5;
            free(iw);
            iw = room(liw, sizeof *iw);
            continue;
        }
        if (now != TESS_MORE) break;
        if (m != room4 || m > ntet) stop("an unfinished result");
        room4++;
        more = room(4 * room4, sizeof *t);
        memcpy(more, t, 4 * sizeof *t * (size_t)m);
        free(t);
        t = more;
        more = room(4 * room4, sizeof *a);
        memcpy(more, a, 4 * sizeof *a * (size_t)m);
        free(a);
        a = more;
    }
    if (now != code || m != ntet ||
        memcmp(t, tet, 4 * sizeof *t * (size_t)m) != 0 ||
        memcmp(a, adj, 4 * sizeof *a * (size_t)m) != 0)
        stop("a result in steps");
    free(t);
    free(a);
    free(iw);
    free(rw);
}

/* Is q in tetrahedron v? */
static int holds(const tess_int *v, const double *q)
{
    const double *c[4];
    int i, k;

    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) c[i] = p[v[i]];
        c[k] = q;
        if (ex_orient(c[0], c[1], c[2], c[3]) < 0) return 0;
    }
    return 1;
}

static void location(tess_int ntet, const tess_int *tet, const tess_int *adj)
{
    double q[3], w[4], sum;
    tess_real x[3];
    tess_int t = TESS_NONE, i;
    int k, code, in = 0;

    for (k = 0; k < 3; k++) {
        x[k] = (tess_real)coordinate(3 * n);
        q[k] = (double)x[k];
        if (!(fabs(q[k]) <= DBL_MAX)) return;
    }
    code = tess_locate(point, ntet, tet, adj, x, &t, w);
    for (i = 0; i < ntet && !in; i++) in = holds(tet + 4 * i, q);
    sum = w[0] + w[1] + w[2] + w[3];
    if (code != !in || t < 0 || t >= ntet || (in && !holds(tet + 4 * t, q)) ||
        (!in && !(w[0] >= 0.0 && w[1] >= 0.0 && w[2] >= 0.0 && w[3] >= 0.0)) ||
        !(fabs(sum - 1.0) <= 1e-12)) {
        printf("query %.17g %.17g %.17g\n", q[0], q[1], q[2]);
        stop("location");
    }
}

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size)
{
    tess_int liw, lrw, ntet, *tet, *adj, *iw, *twin, bad, least = 1;
    double *rw;
    const char *what;
    volatile tess_real rounded;
    int i, k, code;

    data = bytes;
    end = bytes + size;
    n = byte() % (MOST + 1);
    chosen[1] = 1.0;
    for (i = 2; i < CHOSEN; i++) chosen[i] = value();
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            rounded = (tess_real)coordinate(3 * i + k);
            p[i][k] = (double)rounded;
            if (!(fabs(p[i][k]) <= DBL_MAX)) p[i][k] = 0.0;
            point[3 * i + k] = (tess_real)p[i][k];
        }
    if (tess_size((tess_int)n, MAXTET, &liw, &lrw) != 0) stop("tess_size");
    tet = room(4 * MAXTET, sizeof *tet);
    adj = room(4 * MAXTET, sizeof *adj);
    iw = room(liw, sizeof *iw);
    rw = room(lrw, sizeof *rw);
    code = tess((tess_int)n, point, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
    what = verify((tess_int)n, point, code, ntet, tet, adj, iw);
    if (what) stop(what);
    twin = iw;
    iw = room(2 * (tess_int)n, sizeof *iw);
    if (tess_check((tess_int)n, point, ntet, tet, adj, (tess_int)(2 * n), iw,
                   &bad) != 0)
        stop("tess_check");
    if (ntet > 0) location(ntet, tet, adj);
    free(iw);
    /* the least liw: what is refused is refused before anything is done */
    iw = room(liw, sizeof *iw);
    while (tess((tess_int)n, point, 0, &bad, tet, adj, least, iw, lrw, rw) == -7)
        least++;
    free(iw);
    free(rw);
    steps(code, ntet, tet, adj, least, lrw);
    for (i = 0; i < 4; i++) {
        what = damage((tess_int)n, point, ntet, tet, adj, twin, draw);
        if (what) stop(what);
    }
    free(twin);
    free(tet);
    free(adj);
    return 0;
}

#ifdef STANDALONE
/* Of most sets all coordinates are of one kind. */
static void choose(unsigned char *bytes)
{
    int k;

    bytes[0] = (unsigned char)(rnd_below(5) + 4);
    if (rnd_below(3))
        for (k = 4; k < 28; k++)
            bytes[k] = (unsigned char)(bytes[0] % 2 ? bytes[k] % 82
                                                    : 210 + bytes[k] % 46);
}

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
    printf("# %ld sets, 0 faults\n", runs);
    test_result("fuzz", 0L);
    return test_end();
}
#endif
