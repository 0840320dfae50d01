/* t_stack.c - the stack that a call takes.
 *
 *     t_stack
 *
 * Writes a line for each routine, and one for all, `most': the bytes that a call
 * takes on usual points, and on any.  Each call is made by a thread whose stack
 * was painted; what is no longer painted it has used.  The sets are such that
 * the longest paths are taken: surfaces, whose searches have lists of their own,
 * and exponents far apart, where all the limbs there are decide signs.
 *
 * Needs POSIX threads: -DTEST_STACK says that they are there.
 */
#ifdef TEST_STACK
#define _XOPEN_SOURCE 600
#include <pthread.h>
#endif
#include "../../tess.h"
#include "../lib/exact.h"
#include "../lib/points.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef TEST_STACK

#define MOST 600
#define MAXTET (16 * MOST)
#define LIW (40 * MOST + 4000)
#define LRW (8 * MOST + 1000)
#define ASKED 30
#define PAINTED 400000
#define COLOUR 0x5a

static tess_int n;
static double x[3 * MOST];
static tess_real p[3 * MOST], q[3 * ASKED];
static tess_int ntet, tet[4 * MAXTET], adj[4 * MAXTET], iw[LIW], copy[LIW];
static tess_int fac[3 * 4 * MAXTET], mine[MOST], t[ASKED];
static double rw[LRW], value[MOST], out[ASKED], w[4];
static int code;

/* ---- the calls, one routine's all in one ---- */

static void c_mesh(void)
{
    code = tess(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
}

static void c_resume(void)
{
    if (tess(n, p, MAXTET / 32, &ntet, tet, adj, LIW, iw, LRW, rw) >= 0)
        code = tess_resume(n, p, MAXTET, &ntet, tet, adj, LIW, iw, LRW, rw);
}

static void c_locate(void)
{
    tess_int i, at;

    for (i = 0; i < ASKED; i++) {
        at = TESS_NONE;
        tess_locate(p, ntet, tet, adj, q + 3 * i, &at, w);
    }
}

static void c_values(void)
{
    tess_int i;

    for (i = 0; i < ASKED; i++) t[i] = TESS_NONE;
    tess_values(p, ntet, tet, adj, 1, value, ASKED, q, t, out);
}

static void c_hull(void)
{
    tess_int nfac;

    tess_hull(ntet, tet, adj, 4 * MAXTET, &nfac, fac);
}

static void c_check(void)
{
    tess_int bad;

    tess_check(n, p, ntet, tet, adj, 2 * n, copy, &bad);
}

static void c_ball(void)
{
    tess_int i;
    double c[4];

    for (i = 0; i < ntet; i++) tess_ball(p, tet + 4 * i, c);
}

static void c_index(void)
{
    code = tess_index(n, p, LIW, iw, LRW, rw);
}

static void c_query(void)
{
    tess_int i, v[4];

    for (i = 0; i < ASKED; i++) {
        v[0] = TESS_NONE;
        tess_query(n, p, iw, rw, q + 3 * i, v, w);
    }
}

static void c_part(void)
{
    tess_int i, many = 0;

    memcpy(copy, iw, sizeof copy);
    for (i = 0; i < n; i++) mine[i] = i % 3 == 0;
    tess_part(n, p, mine, MAXTET, &many, tet, adj, LIW, copy, LRW, rw);
}

static void c_predicates(void)
{
    double f[HH_FACET_LEN], l;
    tess_int i;

    for (i = 0; i + 4 < n; i++) {
        hh_facet(p + 3 * i, p + 3 * i + 3, p + 3 * i + 6, f);
        l = hh_side(f, p + 3 * i + 9) + hh_lcoord(f, p + 3 * i + 9);
        hh_opp(f, p + 3 * i + 9, p + 3 * i + 12);
        hh_wrap(p + 3 * i, p + 3 * i + 3, p + 3 * i + 6, p + 3 * i + 9, &l);
        hh_orient(p + 3 * i, p + 3 * i + 3, p + 3 * i + 6, p + 3 * i + 9);
        hh_insphere(p + 3 * i, p + 3 * i + 3, p + 3 * i + 6, p + 3 * i + 9,
                    p + 3 * i + 12);
    }
}

static void nothing(void)
{
}

/* in this order: what a call leaves the next ones take */
static const struct {
    const char *name;
    void (*call)(void);
    int of_mesh;
} calls[] = {
    { "tess", c_mesh, 0 },         { "tess_resume", c_resume, 0 },
    { "tess_locate", c_locate, 1 }, { "tess_values", c_values, 1 },
    { "tess_hull", c_hull, 1 },    { "tess_check", c_check, 0 },
    { "tess_ball", c_ball, 1 },    { "tess_index", c_index, 0 },
    { "tess_query", c_query, 0 },  { "tess_part", c_part, 0 },
    { "hh_", c_predicates, 0 }
};
#define CALLS ((int)(sizeof calls / sizeof calls[0]))

static long used[CALLS][2]; /* on usual points, on any */
static char *area;
static char *volatile top;

/* ---- a thread on a painted stack ---- */

static void *threaded(void *which)
{
    char here;

    top = &here;
    (*(void (**)(void))which)();
    return NULL;
}

/* bytes that a call takes, below the thread's own */
static long taken(void (*call)(void))
{
    pthread_attr_t how;
    pthread_t thread;
    long i;

    memset(area, COLOUR, (size_t)PAINTED);
    if (pthread_attr_init(&how) != 0 ||
        pthread_attr_setstack(&how, area, (size_t)PAINTED) != 0 ||
        pthread_create(&thread, &how, threaded, &call) != 0 ||
        pthread_join(thread, NULL) != 0) {
        fprintf(stderr, "no thread with a stack of its own\n");
        exit(1);
    }
    pthread_attr_destroy(&how);
    for (i = 0; i < PAINTED && area[i] == COLOUR; i++)
        ;
    return (long)(top - (area + i));
}

static void all(int usual)
{
    long bytes, empty = taken(nothing);
    tess_int i;
    int k, j;

    for (i = 0; i < ASKED; i++)
        for (k = 0; k < 3; k++) {
            j = rnd_below((int)n);
            q[3 * i + k] = (tess_real)(i % 3 == 0 ? p[3 * j + k]
                : i % 3 == 1 ? 0.5 * p[3 * j + k] + 0.5 * p[3 * (i % n) + k]
                : ldexp(rnd_unit() - 0.5, rnd_below(3) - 1) * p[3 * j + k]);
        }
    for (k = 0; k < CALLS; k++) {
        if (calls[k].of_mesh && code != TESS_OK) continue;
        bytes = taken(calls[k].call) - empty;
        if (bytes > used[k][1]) used[k][1] = bytes;
        if (usual && bytes > used[k][0]) used[k][0] = bytes;
    }
}

/* ---- the sets ---- */

/* exponents as far apart as this build's limbs allow, and a little farther */
static void apart(int spread)
{
    tess_int i;

    for (i = 0; i < 3 * n; i++)
        p[i] = (tess_real)ldexp(rnd_unit() * 2.0 - 1.0,
                                -rnd_below(spread + 1));
}

static void usual(void)
{
    static const char *const families[] = {
        "uniform", "rotcube", "globe", "sheets", "pipes", "gridrot"
    };
    size_t k;
    tess_int i;

    for (k = 0; k < sizeof families / sizeof families[0]; k++) {
        n = (tess_int)points_make(families[k], MOST, 1, x);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)x[i];
        all(1);
    }
}

static void hard(void)
{
    static const char *const families[] = { "wide", "uvsphere" };
    int seed, k, most = (HH_LIMBS - 3) * HH_BITS;
    tess_int i;

    for (k = 0; k < 2; k++) {
        n = (tess_int)points_make(families[k], k == 0 ? 24 : MOST, 1, x);
        for (i = 0; i < 3 * n; i++) p[i] = (tess_real)x[i];
        all(0);
    }
    for (seed = 0; seed < 24; seed++) {
        rnd_seed((unsigned long)seed);
        n = 12 + seed;
        apart(seed % 4 == 0 ? 40 : seed % 4 == 1 ? most / 4
              : seed % 4 == 2 ? most / 2 : most);
        if (seed % 3 == 0) /* nearly flat */
            for (i = 2; i < 3 * n; i += 3)
                p[i] = (tess_real)ldexp(p[i], -most / 2);
        all(0);
    }
}

int main(int argc, char **argv)
{
    long most[2];
    int k, j;

    if (argc > 1) test_usage(argv[0], "");
    area = (char *)malloc(PAINTED + 4096);
    if (!area) return 1;
    area += 4096 - (area - (char *)0) % 4096;
    usual();
    hard();
    most[0] = most[1] = 0;
    for (k = 0; k < CALLS; k++) {
        printf("%-12s %7ld %7ld\n", calls[k].name, used[k][0], used[k][1]);
        for (j = 0; j < 2; j++)
            if (used[k][j] > most[j]) most[j] = used[k][j];
    }
    printf("%-12s %7ld %7ld\n", "most", most[0], most[1]);
    return 0;
}

#else

int main(int argc, char **argv)
{
    if (argc > 1) test_usage(argv[0], "");
    test_skip("no POSIX threads");
    return test_end();
}

#endif
