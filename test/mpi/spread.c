/* spread.c - a mesh of points that no process holds whole, with MPI.
 *
 *   mpicc -O2 -I. -o spread test/mpi/spread.c test/points.c tess.c hhpred.c -lm
 *   mpirun -np 4 spread uniform 2000 lattice 1000
 *
 * Each process owns a block of the points and computes the tetrahedra at them,
 * the stars, from the points that it knows:
 *
 *   1. It sends the vertices of its own points' hull to all.  Those of the
 *      whole hull are among them, so each star now fills what it must.
 *   2. It computes the stars of its own points.
 *   3. It asks the processes whose box a tetrahedron's ball meets.  They answer
 *      with one point inside or on the sphere, the one nearest to the
 *      tetrahedron's own vertex, unless they have sent it before.
 *   4. Back to 2, until nobody gets a point that is new to it.  Then all balls
 *      are empty, and all points on their spheres known: the stars are final.
 *
 * One point, not all: a tetrahedron at the edge of what is known may have a
 * ball that holds half of all points, and most of those do nothing to its
 * vertices' stars.  Whether a point is inside is decided exactly; tess_ball
 * only tells whom to ask, and spares most decisions.
 *
 * Ties go by index, so a process keeps the points it knows in the order of
 * their indices in the whole.  Each tetrahedron belongs to the process that
 * owns its vertex of least index.  Process 0 collects them, here alone, and
 * compares with the mesh computed at once.  Points must be distinct.
 *
 * All messages are lists of doubles: points (index, x, y, z), questions (four
 * points, the own one first, and the ball), tetrahedra (four indices).  A
 * larger program would remember which balls are final, and search its own
 * points by a tree.
 */
#include <float.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hhpred.h"
#include "tess.h"
#include "test/points.h"

#define N 6000
#define MAXTET (10 * N)
#define RANKS 8
#define POINT 4
#define ASK 16
#define ROOM (ASK * MAXTET)

/* what a process knows: points by index, which are its own, their stars */
static tess_int n, ntet, mine[N], tet[4 * MAXTET], adj[4 * MAXTET];
static tess_int iw[TESS_LIW(N)];
static long name[N];
static double p[3 * N], rw[TESS_LRW(N)];

/* the round in which process r was sent point i of the whole, or UNSENT */
#define UNSENT (-1)
static int sent[RANKS][N];

static double box[6 * RANKS];
static double out[RANKS * ROOM], in[RANKS * ROOM], bytes;
static int me, ranks, nout[RANKS], nin[RANKS], begin[RANKS];

/* for process 0 */
static double whole[3 * N];
static long found[4 * MAXTET], wanted[4 * MAXTET];

/* Put m doubles into the message to process r. */
static void put(int r, const double *x, int m)
{
    if (nout[r] + m > ROOM) MPI_Abort(MPI_COMM_WORLD, 1);
    memcpy(out + begin[r] + nout[r], x, (size_t)m * sizeof *x);
    nout[r] += m;
}

/* Put a point that is known, and note that r has it. */
static void give(int r, tess_int i, int round)
{
    double x[POINT];

    if (sent[r][name[i]] != UNSENT) return;
    sent[r][name[i]] = round;
    x[0] = (double)name[i];
    memcpy(x + 1, p + 3 * i, 3 * sizeof *x);
    put(r, x, POINT);
}

/* Send all messages, receive those of the others. */
static void exchange(void)
{
    int r;

    MPI_Alltoall(nout, 1, MPI_INT, nin, 1, MPI_INT, MPI_COMM_WORLD);
    MPI_Alltoallv(out, nout, begin, MPI_DOUBLE, in, nin, begin, MPI_DOUBLE,
                  MPI_COMM_WORLD);
    for (r = 0; r < ranks; r++) {
        if (r != me) bytes += nout[r] * (double)sizeof *out;
        nout[r] = 0;
    }
}

/* Take the points that came into those known, each at its index's place. */
static long learn(int own)
{
    const double *x;
    tess_int i;
    long fresh = 0;
    int r;

    for (r = 0; r < ranks; r++)
        for (x = in + begin[r]; x < in + begin[r] + nin[r]; x += POINT) {
            for (i = n; i > 0 && (double)name[i - 1] > x[0]; i--) continue;
            if (i > 0 && (double)name[i - 1] == x[0]) continue;
            memmove(name + i + 1, name + i, (size_t)(n - i) * sizeof *name);
            memmove(mine + i + 1, mine + i, (size_t)(n - i) * sizeof *mine);
            memmove(p + 3 * i + 3, p + 3 * i,
                    (size_t)(n - i) * 3 * sizeof *p);
            name[i] = (long)x[0];
            mine[i] = own;
            memcpy(p + 3 * i, x + 1, 3 * sizeof *p);
            n++;
            fresh++;
        }
    return fresh;
}

static double square(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

    return x * x + y * y + z * z;
}

/* Is x in the ball c, which may be larger for the roundings here? */
static int inball(const double *c, const double *x)
{
    return square(c, x) <= c[3] * c[3] * (1.0 + 1e-12);
}

/* Does the ball c meet the box of process r? */
static int meets(const double *c, int r)
{
    const double *lo = box + 6 * r, *hi = lo + 3;
    double x[3];
    int k;

    if (lo[0] > hi[0]) return 0;
    for (k = 0; k < 3; k++)
        x[k] = c[k] < lo[k] ? lo[k] : c[k] > hi[k] ? hi[k] : c[k];
    return inball(c, x);
}

/* Process 0 gives each process the points of a range of the sorted order. */
static void deal(const char *family, long count)
{
    double x[POINT];
    long i;
    int r;

    n = 0;
    memset(sent, UNSENT, sizeof sent);
    if (me == 0) {
        count = points_make(family, count, 1, whole);
        if (tess_index((tess_int)count, whole, TESS_LIW(N), iw, TESS_LRW(N),
                       rw) != 0)
            MPI_Abort(MPI_COMM_WORLD, 1);
        for (i = 0; i < count; i++) {
            x[0] = (double)i;
            memcpy(x + 1, whole + 3 * i, 3 * sizeof *x);
            r = (int)((double)iw[i] * ranks / (double)count);
            put(r, x, POINT);
        }
    }
    exchange();
    learn(1);
    bytes = 0.0;
}

/* Step 1: boxes, and the vertices of the own points' hull; all own points where
 * they are in a plane. */
static void hull(void)
{
    static char outer[N];
    double own[6];
    tess_int i;
    int code, k, r;

    for (k = 0; k < 3; k++) {
        own[k] = DBL_MAX;
        own[k + 3] = -DBL_MAX;
        for (i = 0; i < n; i++) {
            if (p[3 * i + k] < own[k]) own[k] = p[3 * i + k];
            if (p[3 * i + k] > own[k + 3]) own[k + 3] = p[3 * i + k];
        }
    }
    MPI_Allgather(own, 6, MPI_DOUBLE, box, 6, MPI_DOUBLE, MPI_COMM_WORLD);
    code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw, TESS_LRW(N),
                rw);
    memset(outer, code != 0, sizeof outer);
    for (i = 0; i < 4 * ntet; i++)
        for (k = 0; k < 4 && adj[i] < 0; k++)
            if (k != i % 4) outer[tet[i - i % 4 + k]] = 1;
    for (i = 0; i < n; i++)
        for (r = 0; r < ranks; r++)
            if (outer[i] && r != me) give(r, i, 0);
    exchange();
    learn(0);
}

/* Step 3: the questions. */
static void ask(void)
{
    double c[ASK];
    const tess_int *v;
    tess_int t;
    int k, own, r;

    for (t = 0; t < ntet; t++) {
        v = tet + 4 * t;
        for (own = 0; !mine[v[own]]; own++) continue;
        for (k = 0; k < 4; k++)
            memcpy(c + 3 * k, p + 3 * v[(own + k) % 4], 3 * sizeof *c);
        if (tess_ball(p, v, c + 12) != 0) MPI_Abort(MPI_COMM_WORLD, 1);
        for (r = 0; r < ranks; r++)
            if (r != me && meets(c + 12, r)) put(r, c, ASK);
    }
    exchange();
}

/* Step 3: the answers.  What was sent in this round answers others, too. */
static void answer(int round)
{
    const double *c;
    double best, d;
    tess_int i, near;
    int r;

    for (r = 0; r < ranks; r++)
        for (c = in + begin[r]; c < in + begin[r] + nin[r]; c += ASK) {
            best = DBL_MAX;
            near = TESS_NONE;
            for (i = 0; i < n; i++) {
                if (!mine[i]) continue;
                if (sent[r][name[i]] != UNSENT && sent[r][name[i]] < round)
                    continue;
                d = square(c, p + 3 * i);
                if (d < best && inball(c + 12, p + 3 * i) &&
                    hh_insphere(c, c + 3, c + 6, c + 9, p + 3 * i) >= 0) {
                    best = d;
                    near = i;
                }
            }
            if (near != TESS_NONE) give(r, near, round);
        }
    exchange();
}

/* Order the vertices of each tetrahedron but for the last two, which tell the
 * orientation; then the tetrahedra. */
static int before(const void *a, const void *b)
{
    const long *x = (const long *)a, *y = (const long *)b;
    int k;

    for (k = 0; k < 3 && x[k] == y[k]; k++) continue;
    return x[k] < y[k] ? -1 : x[k] > y[k];
}

static void order(long *v, long count)
{
    long t, swap, *a;
    int i, k, odd;

    for (t = 0; t < count; t++) {
        a = v + 4 * t;
        odd = 0;
        for (i = 0; i < 3; i++)
            for (k = 0; k < 3; k++)
                if (a[k] > a[k + 1]) {
                    swap = a[k];
                    a[k] = a[k + 1];
                    a[k + 1] = swap;
                    odd = !odd;
                }
        if (odd) {
            swap = a[2];
            a[2] = a[3];
            a[3] = swap;
        }
    }
    qsort(v, (size_t)count, 4 * sizeof *v, before);
}

/* Collect the tetrahedra at process 0, which compares: are they the mesh? */
static int compare(long count, long *many)
{
    double v[4];
    tess_int t, least;
    long i;
    int k, r;

    for (t = 0; t < ntet; t++) {
        for (k = 0, least = N; k < 4; k++) {
            if (tet[4 * t + k] < least) least = tet[4 * t + k];
            v[k] = (double)name[tet[4 * t + k]];
        }
        if (mine[least]) put(0, v, 4);
    }
    exchange();
    *many = 0;
    if (me != 0) return 1;
    for (r = 0; r < ranks; r++)
        for (i = 0; i < nin[r]; i++, ++*many) {
            if (*many == 4 * MAXTET) return 0;
            found[*many] = (long)in[begin[r] + i];
        }
    *many /= 4;
    if (tess((tess_int)count, whole, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw,
             TESS_LRW(N), rw) != 0 || ntet != *many)
        return 0;
    for (i = 0; i < 4 * ntet; i++) wanted[i] = tet[i];
    order(found, *many);
    order(wanted, *many);
    return memcmp(found, wanted, 4 * (size_t)*many * sizeof *found) == 0;
}

/* One set of points. */
static int spread(const char *family, long count)
{
    double mean[3], total[3];
    long fresh, all, many;
    tess_int own;
    int code, round = 0, same;

    deal(family, count);
    own = n;
    hull();
    do {
        round++;
        ntet = 0;
        code = tess_index(n, p, TESS_LIW(N), iw, TESS_LRW(N), rw);
        if (code == 0)
            code = tess_part(n, p, mine, MAXTET, &ntet, tet, adj, TESS_LIW(N),
                             iw, TESS_LRW(N), rw);
        if (code != 0) {
            fprintf(stderr, "%s: code %d\n", family, code);
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
        ask();
        answer(round);
        fresh = learn(0);
        MPI_Allreduce(&fresh, &all, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
    } while (all > 0);
    mean[0] = (double)own;
    mean[1] = (double)n;
    mean[2] = bytes;
    MPI_Reduce(mean, total, 3, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    same = compare((long)total[0], &many);
    if (me == 0)
        printf("%-10s %5.0f points, %d processes: %2d rounds, %.2f of the "
               "points known, %6.0f KB sent, %5ld tetrahedra, %s\n", family,
               total[0], ranks, round, total[1] / total[0] / ranks,
               total[2] / 1024.0, many, same ? "the mesh" : "NOT THE MESH");
    return same;
}

int main(int argc, char **argv)
{
    int i, good = 1;

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks > RANKS || argc < 3) MPI_Abort(MPI_COMM_WORLD, 2);
    for (i = 0; i < ranks; i++) begin[i] = i * ROOM;
    for (i = 1; i + 1 < argc; i += 2) {
        if (atol(argv[i + 1]) > N) MPI_Abort(MPI_COMM_WORLD, 2);
        good &= spread(argv[i], atol(argv[i + 1]));
    }
    MPI_Finalize();
    return !good;
}
