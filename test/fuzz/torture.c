/* torture.c - tess on hard sets of points in hard circumstances.
 *
 *     torture [options] [sets [seed]]
 *         -time S     not that many sets but S seconds
 *         -one SEED   one set, in full
 *         -many       sets of 13 to 400 points; else up to 12
 *         -sums       write a sum of each result alone, to compare builds
 *         -plain      in normal circumstances alone
 *         -x87        the library does its arithmetic in an x87 unit, whose
 *                     precision is also set to 24 bits
 *
 * Each set's result is verified (tess_check, verify.h), those of many points are
 * compared with other builds', too.  Points and proofs are made in normal
 * circumstances; the library is called in a rounding mode (with -DTEST_ROUNDING, C99's fenv.h),
 * with subnormals flushed to zero or taken for zero (SSE) or with short
 * registers (x87).  Promised is the same result in all of them, or TESS_RANGE
 *     when this build has few limbs,
 *     when subnormals are flushed and there are some,
 *     in 24 bits.
 * Words beyond each array must stay what they are.  Whatever stops, hangs or
 * differs is said with the seed that shows it again.
 */
#ifdef __unix__
#define _XOPEN_SOURCE 500
#endif
#include "../lib/exact.h"
#include "../lib/hard.h"
#include "../lib/verify.h"
#include "../unit/lib/damage.h"
#include "../unit/lib/guard.h"

#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef __unix__
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>
#endif
#ifdef TEST_ROUNDING
#include <fenv.h>
#endif
#ifdef __SSE2__
#include <xmmintrin.h>
#endif
#if defined(__GNUC__) && (defined(__x86_64__) || defined(__i386__))
#define CONTROL_WORD
#endif

#define MOST 400
#define MAXTET 20000
#define LENGTH 80000
#define GUARD 16    /* words beyond each end of an array */
#define FEW 12      /* points */
#define LIMIT 100   /* seconds of the processor that a call may take */
#define HUNG 77
#ifdef TESS_FLOAT
#define NORMAL FLT_MIN
#else
#define NORMAL DBL_MIN
#endif
/* the limbs that hold all doubles: TESS_RANGE is impossible with so many */
#define ENOUGH 88

static int n;
static double p[MOST][3];
static tess_real point[3 * MOST], before[3 * MOST];
static unsigned long seed;
static const char *which = "-one"; /* how to name the set of that seed */
static int full;              /* -one: say all */
static int x87, plain;
static long sets, faults, codes[100];
static int sound;             /* no fault in this set so far */

/* ---- circumstances ---- */

typedef struct mode {
    int round;  /* to nearest, down, up, toward zero */
    int flush;  /* 1 results, 2 operands that are subnormal are zero */
    int short_; /* registers of 64, 53, 24 bits */
} mode;

static const mode normal;
static mode now;

static void enter(void)
{
#ifdef TEST_ROUNDING
    static const int round[4] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                  FE_TOWARDZERO };

    fesetround(round[now.round]);
#endif
#ifdef __SSE2__
    _mm_setcsr((_mm_getcsr() & ~0x8040u) | (now.flush & 1 ? 0x8000u : 0u) |
               (now.flush & 2 ? 0x40u : 0u));
#endif
#ifdef CONTROL_WORD
    if (x87) {
        unsigned short word;

        __asm__ __volatile__("fnstcw %0" : "=m"(word));
        word = (unsigned short)((word & ~0x300) |
               (now.short_ == 0 ? 0x300 : now.short_ == 1 ? 0x200 : 0));
        __asm__ __volatile__("fldcw %0" : : "m"(word));
    }
#endif
}

static void leave(void)
{
    mode was = now;

    now = normal;
    enter();
    now = was;
}

static void anymode(void)
{
    now = normal;
    if (plain) return;
    now.round = rnd_below(4);
    now.flush = rnd_below(4);
    now.short_ = x87 ? rnd_below(3) : 0;
}

static int subnormal(const double *x, int m)
{
    int i;

    for (i = 0; i < m; i++)
        if (x[i] != 0.0 && fabs(x[i]) < NORMAL) return 1;
    return 0;
}

/* May the answer be TESS_RANGE?  q: a query, or NULL. */
static int mayrange(const double *q)
{
    return HH_LIMBS < ENOUGH || now.short_ == 2 ||
           (now.flush && (subnormal(p[0], 3 * n) || (q && subnormal(q, 3))));
}

/* ---- what is wrong ---- */

static void list(void)
{
    int i;

    for (i = 0; i < n; i++)
        printf("# %.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
}

static void fault(const char *what)
{
    /* of each set the first fault: others follow from it */
    if (!sound) return;
    printf("# fault: %s: %s %lu (%d points, rounding %d, flush %d, "
           "precision %d)\n", what, which, seed, n, now.round, now.flush,
           now.short_);
    if (n <= 8 && !full) list();
    fflush(stdout);
    faults++;
    sound = 0;
}

static void need(int holds, const char *what)
{
    if (!holds) fault(what);
}

#ifdef __unix__
static sigjmp_buf back;
static volatile int calling;

static void stop(int sign)
{
    if (calling) siglongjmp(back, sign);
    printf("# fault: signal %d outside of the library: %s %lu\n", sign, which,
           seed);
    fflush(stdout);
    _exit(1);
}

/* Let a call that takes longer than that be stopped; 0: no longer. */
static void limit(long seconds)
{
    struct itimerval time;

    memset(&time, 0, sizeof time);
    time.it_value.tv_sec = seconds;
    setitimer(ITIMER_VIRTUAL, &time, NULL);
}

static void watch(void)
{
    static const int caught[] = {
        SIGVTALRM, SIGFPE,
#ifndef __SANITIZE_ADDRESS__
        SIGSEGV, SIGBUS
#endif
    };
    struct sigaction action;
    size_t i;

    memset(&action, 0, sizeof action);
    action.sa_handler = stop;
    for (i = 0; i < sizeof caught / sizeof *caught; i++)
        sigaction(caught[i], &action, NULL);
}

/* Make a call of the library in the present circumstances. */
#define CALL(code, call) \
    do { \
        code = sigsetjmp(back, 1); \
        if (code == 0) { \
            calling = 1; \
            limit(LIMIT); \
            enter(); \
            code = call; \
            leave(); \
            limit(0); \
            calling = 0; \
        } else { \
            calling = 0; \
            limit(0); \
            leave(); \
            fault(code == SIGVTALRM ? "a call that does not end" \
                                  : "a call that crashes"); \
            code = HUNG; \
        } \
    } while (0)
#else
#define watch() ((void)0)
#define CALL(code, call) \
    do { \
        enter(); \
        code = call; \
        leave(); \
    } while (0)
#endif

/* ---- arrays between words that no call may alter ---- */

#define INTS(name, length) \
    static tess_int name##room[GUARD + (length) + GUARD]; \
    static tess_int *const name = name##room + GUARD
#define REALS(name, length) \
    static double name##room[GUARD + (length) + GUARD]; \
    static double *const name = name##room + GUARD

INTS(tet, 4 * MAXTET);
INTS(adj, 4 * MAXTET);
INTS(fac, 3 * 4 * MAXTET);
INTS(iw, LENGTH);
INTS(one, 1);
REALS(rw, LENGTH);
REALS(w, 4);
REALS(values, 8);
/* the verified result */
static tess_int goodtet[4 * MAXTET], goodadj[4 * MAXTET], goodntet;
static int goodcode;
static tess_int goodiw[MOST]; /* of which the first n count */

static void fence(tess_int *a, long length)
{
    int i;

    for (i = 0; i < GUARD; i++) a[i - GUARD] = a[length + i] = 12321 + i;
}

static int intact(const tess_int *a, long length)
{
    int i;

    for (i = 0; i < GUARD; i++)
        if (a[i - GUARD] != 12321 + i || a[length + i] != 12321 + i) return 0;
    return 1;
}

static void fencer(double *a, long length)
{
    int i;

    for (i = 0; i < GUARD; i++) a[i - GUARD] = a[length + i] = 1232.0 + i;
}

static int intactr(const double *a, long length)
{
    int i;

    for (i = 0; i < GUARD; i++)
        if (a[i - GUARD] != 1232.0 + i || a[length + i] != 1232.0 + i) return 0;
    return 1;
}

/* tess or tess_resume on tet and adj, workspace of exactly these lengths. */
static int solve(int resume, tess_int maxtet, tess_int *ntet, tess_int liw,
                 tess_int lrw)
{
    static int code;
    long all = 4 * (long)maxtet;

    if (liw > LENGTH || lrw > LENGTH) {
        fault("lengths");
        return HUNG;
    }
    fence(tet, all);
    fence(adj, all);
    fence(iw, liw);
    fencer(rw, lrw);
    memcpy(before, point, sizeof point);
    if (resume)
        CALL(code, tess_resume(n, point, maxtet, ntet, tet, adj, liw, iw, lrw,
                               rw));
    else
        CALL(code, tess(n, point, maxtet, ntet, tet, adj, liw, iw, lrw, rw));
    need(memcmp(before, point, sizeof point) == 0, "points altered");
    need(intact(tet, all), "words beyond tet altered");
    need(intact(adj, all), "words beyond adj altered");
    need(intact(iw, liw), "words beyond iw altered");
    need(intactr(rw, lrw), "words beyond rw altered");
    if (code >= -10 && code < 80) codes[code + 10]++;
    return code;
}

/* tess_check of any arrays of length 4*ntet, with a workspace of least
 * length. */
static int check(tess_int ntet, const tess_int *t, const tess_int *a)
{
    static int code;

    fence(iw, 2 * n);
    fence(one, 1);
    memcpy(before, point, sizeof point);
    CALL(code, tess_check(n, point, ntet, t, a, 2 * n, iw, one));
    need(intact(iw, 2 * n), "words beyond tess_check's iw altered");
    need(intact(one, 1), "words beyond bad altered");
    need(memcmp(before, point, sizeof point) == 0, "points altered");
    return code;
}

/* Are the first ntet tetrahedra those of the good result? */
static int same(tess_int ntet, const tess_int *a, const tess_int *good)
{
    return memcmp(a, good, 4 * sizeof *a * (size_t)ntet) == 0;
}

static int twins(void)
{
    int i;

    for (i = 0; i < n; i++)
        if (iw[i] != goodiw[i]) return 0;
    return 1;
}

/* ---- the least lengths that tess accepts ---- */

static tess_int leastiw[MOST + 1], leastrw[MOST + 1];

static void least(void)
{
    static const tess_real zero[3 * MOST];
    tess_int lo, hi, mid, ntet;
    int code, k;

    if (leastiw[n] > 0) return;
    for (k = 0; k < 2; k++) {
        lo = 0;
        hi = LENGTH;
        while (hi - lo > 1) {
            mid = lo + (hi - lo) / 2;
            code = tess(n, zero, 0, &ntet, tet, adj, k ? leastiw[n] : mid, iw,
                        k ? mid : (tess_int)LENGTH, rw);
            if (code == (k ? -9 : -7)) lo = mid;
            else hi = mid;
        }
        if (k) leastrw[n] = hi;
        else leastiw[n] = hi;
    }
}

/* ---- the properties of a result ---- */

/* The same again, step tetrahedra at a time, in the least workspace: growing
 * only when the pool is full. */
static void steps(tess_int step)
{
    tess_int ntet = 0, maxtet, liw, lrw, was;
    int code, resume = rnd_below(2);
    long tries = 0;

    least();
    liw = leastiw[n];
    lrw = leastrw[n];
    memset(tet, 85, 4 * sizeof *tet);
    for (maxtet = 0;;) {
        was = ntet;
        code = solve(resume, maxtet, &ntet, liw, lrw);
        if (!sound) return;
        if (code == TESS_RANGE && mayrange(NULL)) return;
        if (ntet < was || ntet > maxtet || !same(ntet, tet, goodtet)) {
            fault("an unfinished result");
            return;
        }
        if (code == TESS_MORE) {
            need(ntet == maxtet, "TESS_MORE before tet is full");
            maxtet = ntet + step;
            if (maxtet > MAXTET) return;
        } else if (code == TESS_POOL) {
            liw += n <= FEW ? 3 : liw / 8;
            if (liw > LENGTH) return;
        } else
            break;
        if (++tries > 100000) {
            fault("no end of resuming");
            return;
        }
        /* neither may matter what iw, rw hold */
        memset(iw, 85, sizeof *iw * (size_t)liw);
        memset(rw, rnd_below(2) ? 85 : 255, sizeof *rw * (size_t)lrw);
        resume = 1;
    }
    need(code == goodcode && ntet == goodntet && same(ntet, adj, goodadj),
         "a result in steps");
    need(twins(), "iw of a result in steps");
    if (code != TESS_OK) return;
    code = solve(1, ntet, &ntet, liw, lrw);
    if (code == TESS_RANGE && mayrange(NULL)) return;
    need(code == TESS_OK && ntet == goodntet && same(ntet, tet, goodtet) &&
         same(ntet, adj, goodadj), "a finished result resumed");
}

static void hull(void)
{
    static int code;
    static tess_int nfac, room;
    tess_int i;
    const char *what;

    nfac = 0;
    for (i = 0; i < 4 * goodntet; i++) nfac += goodadj[i] == TESS_NONE;
    room = rnd_below(3) ? nfac : rnd_below((int)nfac + 1);
    fence(fac, 3 * room);
    fence(one, 1);
    CALL(code, tess_hull(goodntet, goodtet, goodadj, room, one, fac));
    need(intact(fac, 3 * room) && intact(one, 1), "words beyond fac altered");
    need(code == (room < nfac ? TESS_MORE : TESS_OK) && *one == nfac,
         "tess_hull's code");
    if (room < nfac || !sound) return;
    what = verify_hull(goodntet, goodtet, goodadj, nfac, fac);
    if (what) fault(what);
}

/* The signs of the weights of q in tetrahedron v; are none negative? */
static int signs(const tess_int *v, const double *q, int *s)
{
    const double *c[4];
    int i, k, in = 1;

    for (k = 0; k < 4; k++) {
        for (i = 0; i < 4; i++) c[i] = p[v[i]];
        c[k] = q;
        s[k] = ex_orient(c[0], c[1], c[2], c[3]);
        if (s[k] < 0) in = 0;
    }
    return in;
}

/* Do the weights fit their exact signs, sum to one and interpolate q? */
static int weights(const tess_int *v, const double *q, const int *s)
{
    double sum = 0.0, size = 0.0, miss;
    int i, k;

    for (k = 0; k < 4; k++) {
        if (!(w[k] >= 0.0 && w[k] <= 1.0 + 1e-12)) return 0;
        if (s[k] == 0 && w[k] != 0.0) return 0;
        sum += w[k];
        for (i = 0; i < 3; i++)
            if (fabs(p[v[k]][i]) > size) size = fabs(p[v[k]][i]);
    }
    if (fabs(sum - 1.0) > 1e-12) return 0;
    for (i = 0; i < 3; i++) {
        miss = -0.125 * q[i];
        for (k = 0; k < 4; k++) miss += w[k] * (0.125 * p[v[k]][i]);
        if (fabs(miss) > 1e-12 * size + 16.0 * ldexp(1.0, -1074)) return 0;
    }
    return 1;
}

static void query(double *q)
{
    int i = rnd_below(n), j = rnd_below(n), k, kind = rnd_below(6);
    double f = rnd_unit();
    volatile tess_real rounded;

    for (k = 0; k < 3; k++) {
        q[k] = p[i][k];
        if (kind == 1) q[k] = 0.5 * p[i][k] + 0.5 * p[j][k];
        if (kind == 2) q[k] = f * p[i][k] + (1.0 - f) * p[j][k];
        if (kind == 3) q[k] = hard_value();
        if (kind == 4) q[k] = hard_nudge(p[i][k], rnd_below(3) - 1);
        if (kind == 5) q[k] = p[rnd_below(n)][k];
        rounded = (tess_real)q[k];
        q[k] = (double)rounded;
        if (!(fabs(q[k]) <= DBL_MAX)) q[k] = p[i][k];
    }
}

/* Locate q from start; t, and 99 when the answer may be and is TESS_RANGE. */
static int locate(const double *q, tess_int start, tess_int *t)
{
    static int code;
    tess_real x[3];
    int k;

    for (k = 0; k < 3; k++) x[k] = (tess_real)q[k];
    fence(one, 1);
    fencer(w, 4);
    *one = start;
    CALL(code, tess_locate(point, goodntet, goodtet, goodadj, x, one, w));
    need(intact(one, 1) && intactr(w, 4), "words beyond t, w altered");
    *t = *one;
    if (code == TESS_RANGE && mayrange(q)) return 99;
    need(code == 0 || code == 1, "tess_locate's code");
    need(*t >= 0 && *t < goodntet, "tess_locate's t");
    return code;
}

/* Outside: are the weights w those of the hull's nearest point?  Where they
 * underflow they may be anything less. */
static int nearest(tess_int t, const double *q)
{
    const tess_int *v = goodtet + 4 * t;
    const double *c[4];
    double x[4], sum = 0.0;
    int k, set, visible = 0;

    for (k = 0; k < 4; k++) c[k] = p[v[k]];
    set = ex_nearest(4, c, q, (long)n, p[0], x);
    if (set == 0) return 0;
    for (k = 0; k < 4; k++) {
        if (!(w[k] >= 0.0) || ((set >> k & 1) == 0 && w[k] != 0.0)) return 0;
        if (!(fabs(w[k] - x[k]) <= 32.0 * DBL_EPSILON * x[k] + 4.0 * DBL_MIN))
            return 0;
        sum += w[k];
        c[k] = q;
        visible += goodadj[4 * t + k] == TESS_NONE && (set >> k & 1) == 0 &&
                   ex_orient(c[0], c[1], c[2], c[3]) < 0;
        c[k] = p[v[k]];
    }
    return visible > 0 && fabs(sum - 1.0) <= 4.0 * DBL_EPSILON;
}

/* tess_values of a few queries, against tess_locate one by one. */
static void interpolation(void)
{
    static double value[2 * MOST];
    double q[4][3], s[4];
    tess_real x[12];
    tess_int u, t[4], many = 1 + rnd_below(4), i;
    int code, each, k, j, outer = 0;

    for (i = 0; i < 2 * n; i++) value[i] = 2.0 * rnd_unit() - 1.0;
    for (i = 0; i < many; i++) {
        query(q[i]);
        for (k = 0; k < 3; k++) x[3 * i + k] = (tess_real)q[i][k];
    }
    fence(fac, many);
    for (i = 0; i < many; i++)
        fac[i] = t[i] = rnd_below(2) ? TESS_NONE
                                     : (tess_int)rnd_below((int)goodntet);
    fencer(values, 2 * many);
    anymode();
    CALL(code, tess_values(point, goodntet, goodtet, goodadj, 2, value, many, x,
                           fac, values));
    need(intact(fac, many) && intactr(values, 2 * many),
         "words beyond tess_values' arrays altered");
    if (code == TESS_RANGE) {
        for (i = 0; i < many && !mayrange(q[i]);) i++;
        need(i < many, "tess_values' code");
        return;
    }
    if (now.short_ == 2) return;
    for (i = 0; i < many && sound; i++) {
        each = locate(q[i], TESS_NONE, &u);
        if (each == 99) return;
        if (each == 1) outer = 1;
        need(each == 1 ? fac[i] <= -2 && fac[i] >= -1 - goodntet : fac[i] == u,
             "tess_values' t");
        for (j = 0; j < 2; j++) {
            s[0] = s[1] = 0.0;
            for (k = 0; k < 4; k++) {
                s[2] = w[k] * value[2 * goodtet[4 * u + k] + j];
                s[0] += s[2];
                s[1] += fabs(s[2]);
            }
            need(fabs(values[2 * i + j] - s[0]) <=
                 64.0 * DBL_EPSILON * s[1] + 16.0 * DBL_MIN,
                 "tess_values' value");
        }
    }
    need(code == outer, "tess_values' code");
}

static void location(void)
{
    double q[3];
    tess_int t, u, start;
    int code, in = 0, s[4];

    query(q);
    start = rnd_below(2) ? TESS_NONE : (tess_int)rnd_below((int)goodntet);
    for (u = 0; u < goodntet && !in; u++) in = signs(goodtet + 4 * u, q, s);
    if (full) printf("# query %.17g %.17g %.17g\n", q[0], q[1], q[2]);
    now = normal;
    code = locate(q, start, &t);
    if (code == 99 || !sound) return;
    need(code == !in, "tess_locate: inside or outside");
    if (in) {
        need(signs(goodtet + 4 * t, q, s), "tess_locate: another tetrahedron");
        need(weights(goodtet + 4 * t, q, s), "tess_locate's weights");
    } else
        need(nearest(t, q), "tess_locate's weights outside");
    if (!sound) return;
    anymode();
    u = t;
    code = locate(q, start, &t);
    if (code == 99 || !sound) return;
    need(code == !in, "tess_locate: inside or outside");
    need(!in || t == u, "tess_locate: another t than in normal circumstances");
    /* in 24 bits the weights are what they are */
    if (now.short_ == 2) return;
    if (in) need(weights(goodtet + 4 * t, q, s), "tess_locate's weights");
    else need(nearest(t, q), "tess_locate's weights outside");
}

/* The result damaged: what the routines do that read it. */
static void damaged(void)
{
    static const char *what;
    static int code;

    now = normal;
    what = NULL;
    CALL(code, (what = damage(n, point, goodntet, goodtet, goodadj, goodiw,
                              rnd_below)) != NULL);
    if (what) fault(what);
    release(0);
}

/* The set in circumstances: the same, or TESS_RANGE where that may be. */
static void again(void)
{
    tess_int liw, lrw, ntet;
    int code;

    tess_size(n, MAXTET, &liw, &lrw);
    code = solve(0, MAXTET, &ntet, liw, lrw);
    if (code == TESS_RANGE && mayrange(NULL))
        need(ntet == 0, "ntet with TESS_RANGE");
    else {
        need(code == goodcode, "the code");
        need(ntet == goodntet && same(ntet, tet, goodtet) &&
             same(ntet, adj, goodadj), "the arrays");
        need(twins(), "iw");
        if (sound && rnd_below(3) == 0) steps(1 + rnd_below(3));
    }
    code = check(goodntet, goodtet, goodadj);
    if (full && code != TESS_OK) printf("tess_check %d\n", code);
    need(code == TESS_OK || (code == TESS_RANGE && mayrange(NULL)),
         "tess_check");
}

/* Take what solve has given for the good result. */
static void keep(int code, tess_int ntet)
{
    goodcode = code;
    goodntet = ntet;
    memcpy(goodtet, tet, 4 * sizeof *tet * (size_t)ntet);
    memcpy(goodadj, adj, 4 * sizeof *tet * (size_t)ntet);
    memcpy(goodiw, iw, sizeof *iw * (size_t)n);
}

static void copy(void)
{
    int i;

    for (i = 0; i < 3 * n; i++) point[i] = (tess_real)p[i / 3][i % 3];
}

/* The exact signs of five points of p. */
static void signs5(const int *v)
{
    static int orient, ball, foot;
    double t[9], x[3];
    const double *c[5];
    const tess_real *r[5];
    int k, may;

    for (k = 0; k < 5; k++) {
        c[k] = p[v[k]];
        r[k] = point + 3 * v[k];
    }
    CALL(orient, hh_orient(r[0], r[1], r[2], r[3]));
    CALL(ball, hh_insphere(r[0], r[1], r[2], r[3], r[4]));
    /* (those who call it ask first) */
    CALL(foot, hh_holds(1, r[0]) && hh_held(r[1]) && hh_held(r[2]) &&
                       hh_held(r[3])
                   ? hh_foot(r[0], r[1], r[2], r[3], NULL)
                   : 0);
    may = mayrange(NULL);
    if (!ex_collinear(c[0], c[1], c[2])) {
        for (k = 0; k < 9; k++) t[k] = c[k / 3][k % 3];
        need(foot == ex_nearest(3, c, c[3], 3, t, x) || (foot == 0 && may),
             "hh_foot");
    }
    need(orient == ex_orient(c[0], c[1], c[2], c[3]) || (orient == 2 && may),
         "hh_orient");
    need(ball == ex_insphere(c[0], c[1], c[2], c[3], c[4]) ||
         (ball == 2 && may), "hh_insphere");
}

static void predicates(void)
{
    int v[5], k, i;

    if (n == 0) return;
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 5; k++) v[k] = rnd_below(n);
        anymode();
        signs5(v);
    }
    now = normal;
}

/* All about a set of few points. */
static void few(int every)
{
    const char *what;
    tess_int liw, lrw, ntet, t, k;
    int code, i;

    copy();
    sound = 1;
    sets++;
    predicates();
    now = normal;
    if (tess_size(n, MAXTET, &liw, &lrw) != 0) {
        fault("tess_size");
        return;
    }
    code = solve(0, MAXTET, &ntet, liw, lrw);
    if (full) {
        printf("code %d; %ld tetrahedra\n", code, (long)ntet);
        for (t = 0; t < ntet && code == 0; t++) {
            for (k = 0; k < 4; k++) printf(" %ld", (long)tet[4 * t + k]);
            printf("   ");
            for (k = 0; k < 4; k++) printf(" %ld", (long)adj[4 * t + k]);
            printf("\n");
        }
    }
    if (code == TESS_RANGE && mayrange(NULL)) return;
    what = verify(n, point, code, ntet, tet, adj, iw);
    if (what) {
        fault(what);
        return;
    }
    keep(code, ntet);
    code = check(goodntet, goodtet, goodadj);
    need(code == TESS_OK || (code == TESS_RANGE && mayrange(NULL)),
         "tess_check");
    if (sound) steps(1);
    for (i = 0; i < (every ? 48 : 3) && sound; i++) {
        anymode();
        if (every && !plain) {
            now.round = i % 4;
            now.flush = i / 4 % 4;
            now.short_ = x87 ? i / 16 : 0;
        }
        again();
    }
    if (goodntet == 0) {
        now = normal;
        if (goodcode == TESS_OK) fault("no tetrahedra");
        return;
    }
    if (sound) hull();
    for (i = 0; i < 2 && sound; i++) location();
    if (sound) interpolation();
    for (i = 0; i < 6 && sound; i++) damaged();
}

/* A sum of the numbers of a result. */
static unsigned long sum(void)
{
    unsigned long s = 1;
    tess_int i;

    for (i = 0; i < 4 * goodntet; i++)
        s = (s * 69069UL + (unsigned long)(goodtet[i] + 7) * 31UL +
             (unsigned long)(goodadj[i] + 7)) & 0xffffffffUL;
    return s;
}

/* Are exact proofs quick?  They are of few points, or of exponents that do not
 * differ much. */
static int quick(void)
{
    int i, e, least = 9999, most = -9999;

    for (i = 0; i < 3 * n; i++) {
        if (p[i / 3][i % 3] == 0.0) continue;
        frexp(p[i / 3][i % 3], &e);
        if (e < least) least = e;
        if (e > most) most = e;
    }
    return n <= 100 || most - least < 200;
}

/* All about a set of many. */
static void many(int sums)
{
    tess_int liw, lrw, ntet, i;
    const char *what = NULL;
    int code, k;

    copy();
    sound = 1;
    sets++;
    now = normal;
    if (tess_size(n, MAXTET, &liw, &lrw) != 0) {
        fault("tess_size");
        return;
    }
    code = solve(0, MAXTET, &ntet, liw, lrw);
    if (full) printf("code %d, %ld tetrahedra\n", code, (long)ntet);
    if (code == TESS_MORE || code == TESS_POOL) {
        need(HUNG == 0 || ntet > 0, "an unfinished result");
        return; /* a number of tetrahedra that is quadratic in n */
    }
    if (code == TESS_RANGE && mayrange(NULL)) return;
    keep(code, ntet);
    if (sums) {
        if (sound) printf("%lu %d %d %ld %lu\n", seed, n, code, (long)ntet,
                          sum());
        return;
    }
    /* what is flat is proven flat, too */
    if (quick() || ntet == 0)
        what = verify(n, point, code, ntet, goodtet, goodadj, goodiw);
    if (what) fault(what);
    code = check(goodntet, goodtet, goodadj);
    need(code == TESS_OK || (code == TESS_RANGE && mayrange(NULL)),
         "tess_check");
    for (k = 0; k < 2 && sound; k++) {
        anymode();
        again();
    }
    now = normal;
    if (sound) steps(1 + goodntet / 40 + rnd_below((int)goodntet / 2 + 1));
    if (goodntet == 0) return;
    if (quick()) {
        if (sound) hull();
        for (i = 0; i < 2 && sound; i++) location();
        if (sound) interpolation();
    }
    for (i = 0; i < 6 && sound; i++) damaged();
}

/* ---- sets that have failed before ---- */

#define D 4.9406564584124654e-324  /* 2^-1074 */
#define L 1.0715086071862673e301   /* 2^1000 */
#define S 9.3326361850321888e-302  /* 2^-1000 */

static const struct fixed {
    int n;
    double p[8][3];
} fixed[] = {
    /* coordinates that vanish when the largest is scaled to one */
    { 5, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { D, 0, 0 } } },
    { 4, { { 0, 0, 0 }, { L, 0, 0 }, { 0, L, 0 }, { 0, 0, S } } },
    { 5, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { .25, .25, D },
           { 0, 0, 1 } } },
    { 5, { { 0, 0, 0 }, { L, 0, 0 }, { 0, L, 0 }, { 0, 0, L }, { S, S, S } } },
    { 6, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 },
           { 1, D, 1 } } },
    { 4, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, D } } },
    { 4, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, D, 0 }, { 0, 0, 1 } } },
    { 5, { { L, L, L }, { -L, L, L }, { L, -L, L }, { L, L, -L },
           { D, D, D } } },
    /* subnormal, all or one: distinct only where they are not flushed */
    { 4, { { 0, 0, 0 }, { D, 0, 0 }, { 0, D, 0 }, { 0, 0, D } } },
    { 4, { { 1e-310, 0, 0 }, { 2e-310, 0, 0 }, { 0, 3e-310, 0 },
           { 0, 0, 4e-310 } } },
    { 4, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, D } } },
    { 4, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1e-310 } } },
    { 5, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
           { 1e-310, 1e-310, 1e-310 } } },
    { 5, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
           { -1e-310, 0, 0 } } },
    { 2, { { 0, 0, 0 }, { D, 0, 0 } } },
    { 3, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, D, 0 } } },
    { 5, { { 1e-308, 0, 0 }, { 3e-308, 0, 0 }, { 0, 3e-308, 0 },
           { 0, 0, 3e-308 }, { 2e-308, 2e-308, 2e-308 } } },
    { 4, { { 2.3e-308, 0, 0 }, { 2.4e-308, 0, 0 }, { 2.3e-308, 1e-307, 0 },
           { 2.35e-308, 0, 2.3e-308 } } },
    /* differences that are subnormal though no coordinate is */
    { 5, { { 2.3e-308, 2.3e-308, 2.3e-308 }, { 2.4e-308, 2.3e-308, 2.3e-308 },
           { 2.3e-308, 2.4e-308, 2.3e-308 }, { 2.3e-308, 2.3e-308, 2.4e-308 },
           { 2.4e-308, 2.4e-308, 2.4e-308 } } },
    /* a lattice, far, small and large */
    { 8, { { 0, 0, 0 }, { S, 0, 0 }, { 0, S, 0 }, { S, S, 0 }, { 0, 0, S },
           { S, 0, S }, { 0, S, S }, { S, S, S } } },
    { 8, { { 0, 0, 0 }, { L, 0, 0 }, { 0, 1, 0 }, { L, 1, 0 }, { 0, 0, S },
           { L, 0, S }, { 0, 1, S }, { L, 1, S } } },
    /* scaled or not by one, subnormals beside ulps of one, or large numbers */
    { 6, { { 1.1102230246251565e-16, 3.3306690738754696e-16, D },
           { 0, 3.3306690738754696e-16, -2 * D },
           { 0, 3.3306690738754696e-16, -4 * D },
           { 3.3306690738754696e-16, 2.2204460492503131e-16, 0 },
           { 0, 2.2204460492503131e-16, 1.1102230246251565e-16 },
           { 1.1102230246251565e-16, 2.2204460492503131e-16,
             1.1102230246251565e-16 } } },
    { 7, { { -4 * D, 0, 0 }, { 4 * D, 0, 0 },
           { 2 * D, -4 * D, -2.7967679607885704e+247 },
           { 2 * D, -2 * D, -2.7967679607885704e+247 }, { -4 * D, 0, 0 },
           { 0, -2 * D, -1.3983839803942852e+247 },
           { 0, -4 * D, 8.383002647631353e+246 } } },
    { 6, { { -1.5e-308, 0, 0 }, { 1.5e-308, 0, 0 },
           { 1.3e-308, -2e-308, -2.79e247 }, { 1.3e-308, -1.2e-308, -2.79e247 },
           { 0, -1.3e-308, -1.398e247 }, { 0, -2e-308, 8.38e246 } } },
    /* a last place or some below 2^-47, which is half a limb here */
    { 5, { { 7.1054273576010019e-15, 0, 0 },
           { 0, 7.1054273576010003e-15, 2.9802322387695312e-08 },
           { 7.1054273576009995e-15, 7.1054273576009963e-15, 0 },
           { 4.4703483581542969e-08, 7.1054273576009995e-15,
             7.1054273576010034e-15 },
           { 7.1054273576009987e-15, 7.1054273576010003e-15, 0 } } }
};

static void fixedsets(void)
{
    int i, j, k;
    volatile tess_real rounded;

    which = "fixed set";
    for (i = 0; i < (int)(sizeof fixed / sizeof *fixed); i++) {
        seed = (unsigned long)i;
        n = fixed[i].n;
        for (j = 0; j < n; j++)
            for (k = 0; k < 3; k++) {
                rounded = (tess_real)fixed[i].p[j][k];
                p[j][k] = (double)rounded;
                if (!(fabs(p[j][k]) <= DBL_MAX)) p[j][k] = 1073741824.0;
            }
        rnd_seed(seed);
        few(1);
    }
    test_result("fixed sets in all circumstances", faults);
}

/* Signs of points whose coordinates are a few last places from a limb's half
 * or from its end, the largest at the same place of its limb. */
static void limbs(void)
{
    static const int v[5] = { 0, 1, 2, 3, 4 };
    double half = ldexp(1.0, -HH_BITS * 2 + 1), x;
    volatile tess_real rounded;
    long old = faults, tries;
    int i, k, e;

    which = "limbs";
    for (tries = 0; tries < 20000 && faults - old < 3; tries++) {
        seed = (unsigned long)tries;
        rnd_seed(seed);
        sound = 1;
        n = 5;
        e = rnd_below(4) ? HH_BITS - 1 : rnd_below(3 * HH_BITS);
        for (i = 0; i < 5; i++)
            for (k = 0; k < 3; k++) {
                x = rnd_below(2) ? hard_nudge(half, 1 - rnd_below(9)) : 0.0;
                if (rnd_below(5) == 0) x = 0.25 * (2 + rnd_below(2)) * half *
                                           ldexp(1.0, e);
                rounded = (tess_real)x;
                p[i][k] = (double)rounded;
            }
        copy();
        anymode();
        signs5(v);
    }
    now = normal;
    test_result("signs about the ends of limbs", faults - old);
}

/* ---- */

static void set(int large, int sums)
{
    rnd_seed(seed);
    if (!large) n = rnd_below(12) ? hard_few(p) : hard_near(p, FEW);
    else if (rnd_below(2)) n = hard_many(p, rnd_below(3) ? 100 : MOST);
    else do n = hard_near(p, rnd_below(3) ? 100 : MOST); while (n <= FEW);
    if (full) list();
    if (large) many(sums);
    else few(0);
}

int main(int argc, char **argv)
{
    long most = 200, i;
    unsigned long begin = 1;
    double seconds = 0.0;
    int large = 0, sums = 0, a;
    time_t start;

    for (a = 1; a < argc && argv[a][0] == '-'; a++) {
        if (strcmp(argv[a], "-many") == 0) large = 1;
        else if (strcmp(argv[a], "-sums") == 0) large = sums = 1;
        else if (strcmp(argv[a], "-x87") == 0) x87 = 1;
        else if (strcmp(argv[a], "-plain") == 0) plain = 1;
        else if (strcmp(argv[a], "-time") == 0 && a + 1 < argc)
            seconds = atof(argv[++a]);
        else if (strcmp(argv[a], "-one") == 0 && a + 1 < argc) {
            full = 1;
            seed = strtoul(argv[++a], NULL, 10);
        } else {
            fprintf(stderr, "torture: what is %s?\n", argv[a]);
            return 2;
        }
    }
    if (a < argc) most = atol(argv[a++]);
    if (a < argc) begin = strtoul(argv[a], NULL, 10);
    watch();
    if (full) {
        set(large, sums);
        return faults != 0;
    }
    if (!large) {
        fixedsets();
        limbs();
    }
    which = "-one";
    faults = sets = 0;
    start = time(NULL);
    for (i = 0; (seconds > 0.0 ? difftime(time(NULL), start) < seconds
                               : i < most) && faults < 20; i++) {
        seed = begin + (unsigned long)i;
        set(large, sums);
    }
    if (sums) return faults != 0;
    printf("# %ld sets, %ld faults; codes", sets, faults);
    for (a = 0; a < 100; a++)
        if (codes[a] > 0) printf(" %d: %ld", a - 10, codes[a]);
    printf("\n");
    test_result(large ? "sets of many points" : "sets of few points", faults);
    return test_end();
}
