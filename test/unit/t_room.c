/* t_room.c - tests that every call ends, whatever room it is given: make check
 * ONLY=room.
 *
 *     t_room          sets of 4 to 400 points, and others drawn by chance: some
 *                     eight minutes
 *     t_room N        the same, but of the lengths behind the least every N-th
 *     t_room -quick   fewer and smaller ones
 *     t_room -brief   of these a half of the lengths, for make check
 *     t_room -prove   parts of one set, by a library that proves its decisions
 *
 * With every liw from the least to the least + LENGTHS, and with every maxtet
 * from 0 to ROOMS, tess, tess_resume, tess_part and tess_index are called in
 * arrays between guards.  Each call ends within MANY times the steps that it
 * takes with room enough, and gives the same arrays; or it returns TESS_MORE or
 * TESS_POOL and leaves a beginning of them, from which a call with room enough
 * goes on to the same arrays.
 *
 * Steps are counted, not timed: the library, in C or in FORTRAN, is compiled
 * with -fsanitize-coverage=trace-pc, so that each of its basic blocks calls
 * __sanitizer_cov_trace_pc, which leaves a call that takes too many.
 *
 * The least pool holds 84 edges: only a star of hundreds of tetrahedra leaves
 * its table a slot or a few.  What enters the table last belongs to vertices of
 * the star's last tetrahedra.  So parts are asked for that begin with the
 * largest star and go on with such vertices.
 *
 * The last line but one sums up all codes and numbers of tetrahedra: C and
 * FORTRAN agree.
 */
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <limits.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LENGTHS 200
#define ROOMS 40
/* Steps allowed: MANY times as many, and SOME for very small sets. */
#define MANY 4
#define SOME 20000L
/* Parts of a set; unfinished meshes of it. */
#define PARTS 10
#define STOPS 7

/* ---- a call ---- */

enum routine { MESH, RESUME, PART, INDEX };

#define NO_END 99 /* the code of a call that has been left */

static jmp_buf end;
static long left = LONG_MAX;
static double calls, pools;
static unsigned long sum;
static tess_int *mine; /* what tess_part is asked for */
static int every = 1;  /* of the lengths one of so many */

void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void)
{
    if (--left == 0) longjmp(end, 1);
}

void tess_prove(int fact);
void tess_prove(int fact)
{
    require(fact, "a decision, or the room that there must always be");
}

/* One call, of so many steps at most.  How many does it take? */
static long call(result *r, enum routine which, long within)
{
    left = within;
    if (setjmp(end) != 0)
        r->code = NO_END;
    else if (which == MESH)
        run(r);
    else if (which == RESUME)
        resume(r);
    else if (which == PART)
        r->code = tess_part(r->n, r->p, mine, r->maxtet, &r->ntet, r->tet,
                            r->adj, r->liw, r->iw, r->lrw, r->rw);
    else
        r->code = tess_index(r->n, r->p, r->liw, r->iw, r->lrw, r->rw);
    within -= left;
    left = LONG_MAX;
    calls += 1.0;
    sum = (33 * sum + (unsigned long)r->code) & 0xffffffffUL;
    sum = (33 * sum + (unsigned long)r->ntet) & 0xffffffffUL;
    return within;
}

/* New arrays of these lengths, with the tetrahedra that r has, and with what iw
 * and rw must hold. */
static void give(result *r, enum routine which, tess_int maxtet, tess_int liw,
                 tess_int lrw)
{
    size_t length = (size_t)(4 * r->ntet) * sizeof(tess_int);
    const tess_int *tet = r->tet, *adj = r->adj;

    r->maxtet = maxtet;
    r->liw = liw;
    r->lrw = lrw;
    r->tet = ints(4 * maxtet);
    r->adj = ints(4 * maxtet);
    r->iw = ints(liw);
    r->rw = (double *)array((size_t)lrw * sizeof(double));
    if (length > 0) {
        memcpy(r->tet, tet, length);
        memcpy(r->adj, adj, length);
    }
    if (which == PART) (void)call(r, INDEX, LONG_MAX);
}

/* ---- a routine, with more and less room ---- */

typedef struct subject {
    enum routine which;
    result whole;         /* what it gives with room enough */
    long within;          /* the steps allowed */
    unsigned long *begun; /* for each number of tetrahedra the unfinished result
                           * that a call has gone on from */
} subject;

/* The subject of a set that is solved. */
static void set_up(subject *s, enum routine which, const result *solved)
{
    long took;
    tess_int i;

    s->which = which;
    s->whole = *solved;
    s->whole.ntet = 0;
    give(&s->whole, which, solved->ntet,
         (tess_int)(solved->liw + 24 * solved->ntet), solved->lrw);
    took = call(&s->whole, which, LONG_MAX);
    require(took > 0, "no steps are counted");
    require(s->whole.code == solved->code, "a code, with room enough");
    s->within = MANY * took + SOME;
    s->begun = (unsigned long *)array((size_t)(solved->ntet + 1) *
                                      sizeof(unsigned long));
    for (i = 0; i <= solved->ntet; i++) s->begun[i] = 0;
}

/* An unfinished result; once from each a call with room enough goes on. */
static void go_on(subject *s, result *r)
{
    unsigned long hash = 1;
    tess_int i;

    require(r->code == TESS_POOL || r->ntet == r->maxtet, "TESS_MORE, not full");
    require(beginning(r, &s->whole), "no beginning");
    if (faults > 0) return;
    for (i = 0; i < 4 * r->ntet; i++)
        hash = (33 * hash + (unsigned long)r->adj[i]) & 0xffffffffUL;
    if (s->begun[r->ntet] == hash) return;
    s->begun[r->ntet] = hash;
    give(r, s->which, s->whole.ntet, s->whole.liw, s->whole.lrw);
    (void)call(r, s->which == MESH ? RESUME : s->which, s->within);
    require(r->code == TESS_OK && same(r, &s->whole),
            "another result of a call that goes on");
}

/* So much room, for the unfinished result or for none. */
static void trial(subject *s, const result *from, tess_int maxtet, tess_int liw,
                  tess_int lrw)
{
    result r = s->whole;
    int keep = narrays;

    r.ntet = 0;
    if (from != NULL) r = *from;
    give(&r, s->which, maxtet, liw, lrw);
    (void)call(&r, s->which, s->within);
    pools += r.code == TESS_POOL;
    if (r.code == s->whole.code)
        require(same(&r, &s->whole), "another result");
    else if (s->whole.code == TESS_OK &&
             (r.code == TESS_POOL || r.code == TESS_MORE))
        go_on(s, &r);
    else {
        fail(r.code == NO_END ? "a call that does not end" : "a code");
        printf("#     code %d, maxtet %ld, liw %ld, lrw %ld\n", r.code,
               (long)maxtet, (long)liw, (long)lrw);
    }
    require(overrun() == 0, "an array is overrun");
    release(keep);
}

/* Of the least lengths one. */
static tess_int shortest(const result *r, enum routine which)
{
    return (tess_int)(which == INDEX ? 2 * r->n + 2 * leaves(r->n) + 5
                                     : 4 * r->n + 2 * leaves(r->n) + 512);
}

static tess_int narrowest(const result *r)
{
    return (tess_int)(3 * r->n + 12 * leaves(r->n));
}

/* Every step-th length, and all numbers of tetrahedra, or of larger sets every
 * eighth; from STOPS unfinished results in turn, or from none. */
static void trials(subject *s, const result *from, int step)
{
    tess_int least = shortest(&s->whole, s->which);
    const result *f = NULL;
    int rooms = (quick || every > 1) && s->whole.n > 50 ? 8 : 1, i;

    for (i = 0; i <= LENGTHS && faults < SHOWN; i++) {
        if (from != NULL) f = from + i % STOPS;
        if (i == 0 || (i + s->whole.n) % step == 0)
            trial(s, f, s->whole.ntet, least + i,
                  i % 2 ? narrowest(&s->whole) : s->whole.lrw);
        if (i <= ROOMS && i % rooms == 0 && (f == NULL || f->ntet <= i))
            trial(s, f, i, least + LENGTHS / ROOMS * i, s->whole.lrw);
    }
}

/* ---- the routines ---- */

static void test_meshes(const result *solved, int step)
{
    result from[STOPS];
    subject s;
    int i, keep = narrays;

    set_up(&s, MESH, solved);
    trials(&s, NULL, step);
    s.which = RESUME;
    for (i = 0; i < STOPS; i++) {
        from[i] = *solved;
        from[i].ntet = 0;
        give(from + i, MESH, (tess_int)(solved->ntet * i / STOPS), solved->liw,
             solved->lrw);
        (void)call(from + i, MESH, LONG_MAX);
    }
    trials(&s, from, step);
    release(keep);
}

/* Ask for the points of part k: those of the largest star's hub and of one other
 * vertex of its last tetrahedron, or of several of the last two; or any k. */
static void ask(const result *solved, int k)
{
    tess_int *star = ints(solved->n), hub = 0, i, end_of;
    subject s;
    int j;

    for (i = 0; i < solved->n; i++) mine[i] = star[i] = 0;
    for (i = 0; i < 4 * solved->ntet; i++) star[solved->tet[i]]++;
    for (i = 1; i < solved->n; i++)
        if (star[i] > star[hub]) hub = i;
    if (k % 2 == 0 && k > 2) {
        for (j = 0; j < k; j++) mine[rnd_below((int)solved->n)] = 1;
        return;
    }
    mine[hub] = 1;
    set_up(&s, PART, solved);
    end_of = 4 * s.whole.ntet - 1;
    if (end_of > 0 && k < 3) mine[s.whole.tet[end_of - k]] = 1;
    for (j = 2; j < k && end_of > 4; j++)
        mine[s.whole.tet[end_of - rnd_below(8)]] = 1;
}

/* Every by-th part before the last. */
static void test_parts(const result *solved, int last, int by, int step)
{
    subject s;
    int k, keep = narrays;

    for (k = 0; k < last && faults < SHOWN; k += by) {
        mine = ints(solved->n);
        ask(solved, k);
        set_up(&s, PART, solved);
        trials(&s, NULL, step);
        release(keep);
    }
}

static void test_index(const result *solved, int step)
{
    result r = *solved, other;
    tess_int v[4], u[4];
    tess_real q[3];
    double w[4];
    int i, k, code, keep = narrays, inner;

    for (k = 0; k < 3; k++)
        q[k] = (tess_real)(0.5 * (double)r.p[k] + 0.5 * (double)r.p[3 + k]);
    r.ntet = 0;
    give(&r, PART, 0, solved->liw, solved->lrw);
    v[0] = TESS_NONE;
    code = tess_query(r.n, r.p, r.iw, r.rw, q, v, w);
    for (i = 0; i <= LENGTHS; i += step) {
        inner = narrays;
        other = r;
        give(&other, PART, 0, shortest(&r, INDEX) + i,
             i % 2 ? narrowest(&r) : r.lrw);
        require(other.code == solved->code &&
                    memcmp(other.iw, r.iw, (size_t)r.n * sizeof *v) == 0,
                "another index");
        u[0] = TESS_NONE;
        require(tess_query(r.n, r.p, other.iw, other.rw, q, u, w) == code &&
                    (code > 1 || memcmp(u, v, sizeof u) == 0),
                "another answer by an index");
        require(overrun() == 0, "an array is overrun");
        release(inner);
    }
    release(keep);
}

/* ---- sets ---- */

static const char *const kinds[] = {
    "uniform", "lattice", "duplicates", "spherei", "planeone", "twolines",
    "moment", "clusters", "cubesurf", "farpoint", "planespread", "hub"
};
#define KINDS ((int)(sizeof kinds / sizeof *kinds))

static int set(result *r, const char *kind, long n, unsigned long seed)
{
    current = NULL;
    release(0);
    if (strcmp(kind, "spherei") == 0 && n > 150) n = 150; /* it takes long */
    if (!points(r, kind, affordable(kind, n), seed)) return 0;
    solve(r);
    current = r;
    return 1;
}

static void test_kind(const char *kind)
{
    static const long size[] = {4, 5, 6, 8, 12, 20, 33, 49, 64, 100, 150, 234,
                                250, 270, 400, 0};
    static const long few[] = {5, 33, 100, 0}, hubs[] = {5, 234, 250, 0};
    const long *n = quick ? few : size;
    int hub = strcmp(kind, "hub") == 0;
    result r;

    if (quick && hub) n = quick > 1 ? hubs + 2 : hubs;
    faults = 0;
    for (; *n > 0 && faults == 0; n++) {
        if (!set(&r, kind, *n, (unsigned long)*n)) continue;
        test_meshes(&r, quick ? 10 * quick : every);
        if (quick && hub)
            test_parts(&r, 3, 1, quick);
        else
            test_parts(&r, PARTS, quick || *n > 100 ? 3 : 1,
                       quick ? 5 * quick : every);
        test_index(&r, quick ? 10 * quick : every);
    }
    current = NULL;
    release(0);
    done("any room", kind);
}

/* Sets, parts and lengths drawn by chance, some of them large. */
static void test_chance(void)
{
    result r;
    subject s;
    tess_int least;
    int i, k;

    faults = 0;
    for (i = 0; i < (quick ? 20 : 400 / every) && faults < SHOWN; i++) {
        const char *kind = kinds[rnd_below(KINDS)];
        long n = 4 + rnd_below(quick || i % 8 ? 400 : 3000);

        if (!set(&r, kind, n, (unsigned long)i) || r.code != TESS_OK) continue;
        mine = ints(r.n);
        ask(&r, rnd_below(PARTS));
        set_up(&s, rnd_below(2) ? MESH : PART, &r);
        least = shortest(&r, s.which);
        for (k = 0; k < 8; k++)
            trial(&s, NULL,
                  (tess_int)rnd_below((int)(s.whole.ntet * (1 + k % 2)) + 1),
                  least + rnd_below((int)(r.liw - least)),
                  narrowest(&r) + rnd_below((int)(r.lrw - narrowest(&r)) + 1));
    }
    current = NULL;
    release(0);
    test_result("any room: by chance", faults);
}

static void prove(void)
{
    result r;

    (void)set(&r, "hub", 250, 1);
    test_parts(&r, 3, 1, 20);
    current = NULL;
    release(0);
    test_result("any room: a part, proven", faults);
}

int main(int argc, char **argv)
{
    int i, proven = argc == 2 && strcmp(argv[1], "-prove") == 0;

    if (argc == 2 && atoi(argv[1]) > 0) every = atoi(argv[1]);
    if (!proven && every == 1) quick = test_quick(argc, argv);
    rnd_seed(1);
    if (proven) prove();
    for (i = 0; i < KINDS && !proven; i++) test_kind(kinds[i]);
    if (!proven) test_chance();
    test_that(pools > 0.0, "any room", "less than enough");
    printf("# %.0f calls, %.0f with a full pool; their sum is %lu\n",
           calls, pools, sum);
    return test_end();
}
