/* split.c - who owns what: space is cut so that all processes have about as
 * many points; see mesh.c.
 *
 * The processes lo ... hi-1 have the points of a part of space, those before
 * cut[mid] go to lo ... mid-1, mid = (lo + hi) / 2.  Before: along the cut's
 * axis, and where that is the same along the next one and the one after it: so
 * that a cut parts any set of distinct points, and duplicates never.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh.h"

/* Samples a process, and of all. */
#define EACH 2048
#define MOST 32768
#define FEWEST 64

/* x[3] is the axis. */
typedef struct cut {
    double x[4];
} cut;

static cut *cuts;
static int axis;

/* before - -1, 0 or 1 as a is before, at or after b, from an axis on. */
static int before(const double *a, const double *b, int k)
{
    int i;

    for (i = 0; i < 3; i++, k = (k + 1) % 3)
        if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
    return 0;
}

static int by_axis(const void *a, const void *b)
{
    return before((const double *)a, (const double *)b, axis);
}

int owner_of(const double *x)
{
    int lo = 0, hi = ranks, mid;

    while (hi - lo > 1) {
        mid = (lo + hi) / 2;
        if (before(x, cuts[mid].x, (int)cuts[mid].x[3]) < 0)
            hi = mid;
        else
            lo = mid;
    }
    return lo;
}

/* divide - the cuts for processes lo ... hi-1, of n samples.  A cut goes
 * between two layers of a lattice, if there is such a place near the right one.
 */
static void divide(double *s, long n, int lo, int hi)
{
    double least[3], most[3], *c = cuts[(lo + hi) / 2].x;
    int mid = (lo + hi) / 2, k;
    long i, at, step;

    if (hi - lo < 2) return;
    for (k = 0; k < 3; k++) least[k] = DBL_MAX, most[k] = -DBL_MAX;
    for (i = 0; i < 3 * n; i++) {
        if (s[i] < least[i % 3]) least[i % 3] = s[i];
        if (s[i] > most[i % 3]) most[i % 3] = s[i];
    }
    for (k = 1, axis = 0; k < 3; k++)
        if (most[k] / 2 - least[k] / 2 > most[axis] / 2 - least[axis] / 2)
            axis = k;
    qsort(s, (size_t)n, 3 * sizeof *s, by_axis);
    at = (long)((double)n * (mid - lo) / (hi - lo));
    c[3] = axis;
    for (k = 0; k < 3; k++) c[k] = n > 0 ? s[3 * at + k] : 0.0;
    for (step = 0; step <= n / 40; step++) {
        for (i = at - step; i <= at + step; i += step > 0 ? 2 * step : 1)
            if (i > 0 && i < n && s[3 * i + axis] > s[3 * i - 3 + axis]) break;
        if (i > at + step) continue;
        at = i;
        for (k = 0; k < 3; k++) c[k] = -DBL_MAX;
        c[axis] = s[3 * at + axis];
        break;
    }
    divide(s, at, lo, mid);
    divide(s + 3 * at, n - at, mid, hi);
}

/* sample - the same cuts everywhere: process 0 finds them, of samples of all,
 * as many of each as it has points. */
static void sample(const cloud *c)
{
    double *s = NULL, *own;
    int *count = NULL, *begin = NULL, n, r, k;
    num wanted = ranks < MOST / EACH ? EACH * (num)ranks : MOST;
    uint64_t h = (uint64_t)me + 1;
    const point *p;
    MPI_Request request;

    if (wanted < FEWEST * (num)ranks) wanted = FEWEST * (num)ranks;
    n = c->n == 0 ? 0 : 3 + (int)((double)wanted / (double)c->all *
                                  (double)c->n);
    own = (double *)grow(NULL, 3 * (num)n, sizeof *own);
    for (r = 0; r < n; r++) {
        h += UINT64_C(0x9e3779b97f4a7c15);
        p = c->at + mix(h) % (uint64_t)c->n;
        for (k = 0; k < 3; k++) own[3 * r + k] = p->x[k];
    }
    n *= 3;
    if (me == 0) {
        count = (int *)grow(NULL, ranks, sizeof *count);
        begin = (int *)grow(NULL, ranks + 1, sizeof *begin);
    }
    MPI_Igather(&n, 1, MPI_INT, count, 1, MPI_INT, 0, MPI_COMM_WORLD, &request);
    wait_for(&request);
    if (me == 0) {
        for (r = begin[0] = 0; r < ranks; r++)
            begin[r + 1] = begin[r] + count[r];
        s = (double *)grow(NULL, begin[ranks], sizeof *s);
    }
    MPI_Igatherv(own, n, MPI_DOUBLE, s, count, begin, MPI_DOUBLE, 0,
                 MPI_COMM_WORLD, &request);
    wait_for(&request);
    cuts = (cut *)grow(cuts, ranks, sizeof *cuts);
    if (me == 0) divide(s, begin[ranks] / 3, 0, ranks);
    MPI_Ibcast(cuts, 4 * ranks, MPI_DOUBLE, 0, MPI_COMM_WORLD, &request);
    wait_for(&request);
    free(own);
    free(s);
    free(count);
    free(begin);
}

/* distinct - of points that coincide the first one stays: they are in the order
 * of their indices. */
static void distinct(cloud *c)
{
    table seen = {0, 0, NULL, NULL};
    uint64_t h, bits;
    double x;
    num i, n = 0;
    int *at, k;

    expect(&seen, (c->n + 1) / 2);
    for (i = 0; i < c->n; i++) {
        for (k = 0, h = 0; k < 3; k++) {
            x = c->at[i].x[k] == 0.0 ? 0.0 : c->at[i].x[k]; /* of either sign */
            memcpy(&bits, &x, sizeof bits);
            h = mix(h + bits);
        }
        while (*(at = find(&seen, h)) != ABSENT &&
               before(c->at[*at].x, c->at[i].x, 0) != 0)
            h = mix(h + 1);
        if (*at != ABSENT) continue;
        *at = (int)n;
        c->at[n++] = c->at[i];
    }
    forget(&seen);
    c->n = n;
}

void split(cloud *c)
{
    mail m;
    int *owner, r;
    num i, *count;

    sample(c);
    mail_open(&m, sizeof(point));
    owner = (int *)grow(NULL, c->n, sizeof *owner);
    count = (num *)grow(NULL, ranks, sizeof *count);
    for (r = 0; r < ranks; r++) count[r] = 0;
    for (i = 0; i < c->n; i++) count[owner[i] = owner_of(c->at[i].x)]++;
    for (r = 0; r < ranks; r++) reserve(&m, r, count[r]);
    for (i = 0; i < c->n; i++) put(&m, owner[i], c->at + i);
    free(owner);
    free(count);
    free(c->at);
    exchange(&m, MOVE);
    /* Processes had them in the order of their ranks. */
    for (r = 0, c->n = 0; r < ranks; r++) c->n += m.n[r];
    if (c->n > TESS_INT_MOST / 40) fail("too many points: use more processes");
    c->at = (point *)grow(NULL, c->n, sizeof *c->at);
    for (r = 0, i = 0; r < ranks; i += m.n[r++]) {
        if (m.n[r] > 0)
            memcpy(c->at + i, m.at[r], (size_t)m.n[r] * sizeof *c->at);
        free(m.at[r]);
        m.at[r] = NULL;
    }
    mail_close(&m);
    distinct(c);
}

/* ---- points known to all ---- */

/* A candidate: of two the one of greater value wins, else of less index. */
typedef struct candidate {
    double value;
    point p;
} candidate;

static void better(void *in, void *inout, int *n, MPI_Datatype *type)
{
    const candidate *a = (const candidate *)in;
    candidate *b = (candidate *)inout;
    int i;

    (void)type;
    for (i = 0; i < *n; i++)
        if (a[i].value > b[i].value ||
            (a[i].value == b[i].value && a[i].p.index < b[i].p.index))
            b[i] = a[i];
}

static void elect(candidate *c, int n)
{
    MPI_Datatype type;
    MPI_Op op;

    MPI_Type_contiguous((int)sizeof *c, MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Op_create(better, 1, &op);
    reduce(c, n, type, op);
    MPI_Op_free(&op);
    MPI_Type_free(&type);
}

/* independent - are k+1 points in general position: two different, three on no
 * line, four in no plane?  The first k are. */
static int independent(const point *v, int k, const double *x)
{
    double f[HH_FACET_LEN];

    return k == 0 || (k == 1 && before(v[0].x, x, 0) != 0) ||
           (k == 2 && hh_facet(v[0].x, v[1].x, x, f) == 0) ||
           (k == 3 && hh_orient(v[0].x, v[1].x, v[2].x, x) != 0);
}

int known_to_all(const cloud *c, point *shared, int *code)
{
    static const int codes[4] = {TESS_POINT, TESS_POINT, TESS_LINE, TESS_PLANE};
    candidate best[26];
    double side[13], most[3];
    int j, k, n;
    num i;

    /* as far as possible in the directions of a cube's corners, edges, faces,
     * when all points have been brought to a cube of edge 1 */
    for (k = 0; k < 3; k++) most[k] = 0.0;
    for (i = 0; i < c->n; i++)
        for (k = 0; k < 3; k++)
            if (fabs(c->at[i].x[k]) > most[k]) most[k] = fabs(c->at[i].x[k]);
    reduce(most, 3, MPI_DOUBLE, MPI_MAX);
    for (k = 0; k < 3; k++) if (most[k] == 0.0) most[k] = 1.0;
    memset(best, 0, sizeof best);
    for (j = 0; j < 26; j++) best[j].value = -DBL_MAX;
    for (i = 0; i < c->n; i++) {
        side[0] = c->at[i].x[0] / most[0];
        side[1] = c->at[i].x[1] / most[1];
        side[4] = c->at[i].x[2] / most[2];
        side[2] = side[0] + side[1];
        side[3] = side[0] - side[1];
        for (j = 0; j < 4; j++) {
            side[5 + j] = side[j] + side[4];
            side[9 + j] = side[j] - side[4];
        }
        for (j = 0; j < 13; j++)
            for (k = 0; k < 2; k++, side[j] = -side[j])
                if (side[j] > best[2 * j + k].value) {
                    best[2 * j + k].value = side[j];
                    best[2 * j + k].p = c->at[i];
                }
    }
    elect(best, 26);
    for (n = 0; n < 26; n++) shared[4 + n] = best[n].p;
    *code = 0;
    for (k = 0; k < 4; k++) {
        memset(best, 0, sizeof *best);
        best->value = -1.0;
        for (i = 0; i < c->n; i++)
            if (independent(shared, k, c->at[i].x)) {
                best->value = 1.0;
                best->p = c->at[i];
                break;
            }
        elect(best, 1);
        if (best->value < 0.0) {
            *code = codes[k];
            return 0;
        }
        shared[k] = best->p;
    }
    return SHARED;
}
