/* halo.c - the first guess at the points of others that a process needs; see
 * mesh.c.
 *
 * The own points are in a tree, which is made where it is asked for: a node of
 * more than LEAF points becomes two when it is met.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh.h"

/* Points in a leaf, at most; boxes that a process shows to all; how many
 * spacings of its points a leaf's box is widened; one in so many points, of
 * all, is known everywhere. */
#define LEAF 32
#define BOXES 64
#define WIDER 2.5
#define COARSE 32

/* Points order[first] ... order[last-1]; its children are nodes child and
 * child + 1, 0 if it has none yet. */
typedef struct node {
    int first, last, child;
    double lo[3], hi[3];
} node;

typedef struct box {
    double lo[3], hi[3];
} box;

/* A question: what is in a box?  Of points that are denser than the asker's,
 * whose spacing is fine, a few do. */
typedef struct question {
    box b;
    double fine;
} question;

static const cloud *own;
static node *tree;
static int nodes, room, *order;

static void fill(int at, int first, int last)
{
    node *t = tree + at;
    const double *x;
    int i, k;

    t->first = first;
    t->last = last;
    t->child = 0;
    for (k = 0; k < 3; k++) t->lo[k] = DBL_MAX, t->hi[k] = -DBL_MAX;
    for (i = first; i < last; i++) {
        x = own->at[order[i]].x;
        for (k = 0; k < 3; k++) {
            if (x[k] < t->lo[k]) t->lo[k] = x[k];
            if (x[k] > t->hi[k]) t->hi[k] = x[k];
        }
    }
}

static double extent(const node *t, int *axis)
{
    double most = -1.0;
    int k;

    for (k = 0; k < 3; k++)
        if (t->hi[k] / 2 - t->lo[k] / 2 > most) {
            most = t->hi[k] / 2 - t->lo[k] / 2;
            *axis = k;
        }
    return 2 * most;
}

static int precedes(const double *a, const double *b, int k)
{
    int i;

    for (i = 0; i < 3; i++, k = (k + 1) % 3)
        if (a[k] != b[k]) return a[k] < b[k];
    return 0;
}

/* open_node - the children of a node; 0 for a leaf.  It is cut at the middle of
 * 15 of its points, which are distinct, so that no child is empty. */
static int open_node(int at)
{
    int first = tree[at].first, last = tree[at].last, some[15];
    int i, j, k = 0, swap;
    const double *x;

    if (tree[at].child > 0) return tree[at].child;
    if (last - first <= LEAF) return 0;
    (void)extent(tree + at, &k);
    for (i = 0; i < 15; i++) {
        some[i] = order[first + (int)((double)(last - first) * (i + 0.5) / 15)];
        for (j = i; j > 0 && precedes(own->at[some[j]].x,
                                      own->at[some[j - 1]].x, k); j--) {
            swap = some[j];
            some[j] = some[j - 1];
            some[j - 1] = swap;
        }
    }
    x = own->at[some[7]].x;
    for (i = j = first; i < last; i++)
        if (precedes(own->at[order[i]].x, x, k)) {
            swap = order[i];
            order[i] = order[j];
            order[j++] = swap;
        }
    if (nodes + 2 > room) {
        room = 2 * room + 64;
        tree = (node *)grow(tree, room, sizeof *tree);
    }
    nodes += 2;
    tree[at].child = nodes - 2;
    fill(nodes - 2, first, j);
    fill(nodes - 1, j, last);
    return nodes - 2;
}

static int meet(const double *alo, const double *ahi, const double *blo,
                const double *bhi)
{
    return alo[0] <= bhi[0] && alo[1] <= bhi[1] && alo[2] <= bhi[2] &&
           blo[0] <= ahi[0] && blo[1] <= ahi[1] && blo[2] <= ahi[2];
}

/* widen - a node's box, wider by w on all sides. */
static box widen(const node *t, double w)
{
    box b;
    int k;

    for (k = 0; k < 3; k++) {
        b.lo[k] = t->lo[k] - w;
        b.hi[k] = t->hi[k] + w;
    }
    return b;
}

/* show - up to count boxes about the points of a node; returns their end. */
static box *show(box *b, int at, int count)
{
    int child = count > 1 ? open_node(at) : 0;

    if (child == 0) {
        *b = widen(tree + at, 0.0);
        return b + 1;
    }
    return show(show(b, child, count / 2), child + 1, count - count / 2);
}

/* boxes - those that all show, BOXES a process, and one about each process's.
 */
static void boxes(box *all, box *hull)
{
    MPI_Request request;
    box *mine = (box *)grow(NULL, BOXES, sizeof *mine), *b;
    int i, k, r;

    b = own->n > 0 ? show(mine, 0, BOXES) : mine;
    for (; b < mine + BOXES; b++)
        for (k = 0; k < 3; k++) b->lo[k] = DBL_MAX, b->hi[k] = -DBL_MAX;
    MPI_Iallgather(mine, 6 * BOXES, MPI_DOUBLE, all, 6 * BOXES, MPI_DOUBLE,
                   MPI_COMM_WORLD, &request);
    wait_for(&request);
    free(mine);
    for (r = 0; r < ranks; r++) {
        hull[r] = all[BOXES * r];
        for (i = 1; i < BOXES; i++)
            for (k = 0; k < 3; k++) {
                b = all + BOXES * r + i;
                if (b->lo[k] < hull[r].lo[k]) hull[r].lo[k] = b->lo[k];
                if (b->hi[k] > hull[r].hi[k]) hull[r].hi[k] = b->hi[k];
            }
    }
}

/* spacing - of the points in a node, be they in a volume, on a surface or on a
 * line; less than its extent over 2.5 where there are 16. */
static double spacing(const node *t)
{
    double n = t->last - t->first, a[3], least, line, area, volume;
    int k;

    for (k = 0; k < 3; k++) a[k] = t->hi[k] - t->lo[k];
    line = a[0] > a[1] ? a[0] : a[1];
    least = a[0] < a[1] ? a[0] : a[1];
    if (a[2] > line) line = a[2];
    if (a[2] < least) least = a[2];
    area = line * (a[0] + a[1] + a[2] - line - least);
    volume = pow(area * least / n, 1.0 / 3.0);
    area = sqrt(area / n);
    line /= n;
    if (area > line) line = area;
    return volume > line ? volume : line;
}

/* ask - the box of each leaf, widened, is asked of the processes whose boxes it
 * meets.  What meets none when it is as much wider as any leaf of it could be
 * has no leaf to be asked for. */
static void ask(mail *m, int at, const box *all, const box *hull)
{
    int axis, child, r, i;
    box b = widen(tree + at, WIDER / 2.5 * extent(tree + at, &axis));
    const box *of;
    question q;

    for (r = 0; r < ranks; r++)
        if (r != me && meet(b.lo, b.hi, hull[r].lo, hull[r].hi)) break;
    if (r == ranks) return;
    child = open_node(at);
    if (child > 0) {
        ask(m, child, all, hull);
        ask(m, child + 1, all, hull);
        return;
    }
    q.fine = spacing(tree + at);
    q.b = b = widen(tree + at, WIDER * q.fine);
    for (; r < ranks; r++) {
        for (i = 0; i < BOXES && r != me; i++) {
            of = all + BOXES * r + i;
            if (meet(b.lo, b.hi, of->lo, of->hi)) break;
        }
        if (i < BOXES && r != me) put(m, r, &q);
    }
}

/* give - send own point i to process r, if that has not been done. */
static void give(mail *m, int i, int r, table *sent)
{
    if (!given(sent, own->at[i].index, r)) put(m, r, own->at + i);
}

static void answer(mail *m, int at, const question *q, int r, table *sent)
{
    int child, i, axis;
    double *x;

    if (!meet(q->b.lo, q->b.hi, tree[at].lo, tree[at].hi)) return;
    if (extent(tree + at, &axis) < q->fine) {
        give(m, order[tree[at].first], r, sent);
        give(m, order[tree[at].last - 1], r, sent);
        return;
    }
    child = open_node(at);
    if (child > 0) {
        answer(m, child, q, r, sent);
        answer(m, child + 1, q, r, sent);
        return;
    }
    for (i = tree[at].first; i < tree[at].last; i++) {
        x = own->at[order[i]].x;
        if (meet(q->b.lo, q->b.hi, x, x)) give(m, order[i], r, sent);
    }
}

/* guess - the questions, the answers, and a coarse sample. */
static void guess(mail *m, table *sent)
{
    box *all = (box *)grow(NULL, BOXES * (num)ranks, sizeof *all);
    box *hull = (box *)grow(NULL, ranks, sizeof *hull);
    const question *q;
    mail questions;
    double i, step = (double)COARSE * ranks;
    int r;

    nodes = 1;
    room = 64;
    tree = (node *)grow(NULL, room, sizeof *tree);
    order = (int *)grow(NULL, own->n, sizeof *order);
    for (r = 0; r < own->n; r++) order[r] = r;
    fill(0, 0, (int)own->n);
    boxes(all, hull);
    mail_open(&questions, sizeof *q);
    if (own->n > 0) ask(&questions, 0, all, hull);
    free(all);
    free(hull);
    exchange(&questions, HALO);
    for (r = 0; r < ranks; r++) {
        q = (question *)questions.at[r];
        for (i = 0.0; i < (double)questions.n[r]; i++)
            answer(m, 0, q++, r, sent);
        for (i = 0.5; r != me && i < (double)own->n; i += step)
            give(m, order[(int)i], r, sent);
    }
    mail_close(&questions);
    free(tree);
    free(order);
}

int given(table *sent, num index, int r)
{
    int *at = find(sent, (uint64_t)index * (uint64_t)ranks + (uint64_t)r);
    int before = *at != ABSENT;

    *at = 0;
    return before;
}

static int by_index(const void *a, const void *b)
{
    num i = ((const point *)a)->index, j = ((const point *)b)->index;

    return i < j ? -1 : i > j;
}

point *first_guess(const cloud *c, const point *shared, int nshared, int blind,
                   num *n, table *sent)
{
    mail m;
    point *list;
    num i, most = nshared;
    int r;

    own = c;
    mail_open(&m, sizeof(point));
    if (!blind) guess(&m, sent);
    exchange(&m, HALO);
    for (r = 0; r < ranks; r++) most += m.n[r];
    list = (point *)grow(NULL, most, sizeof *list);
    memcpy(list, shared, (size_t)nshared * sizeof *list);
    for (r = 0, *n = nshared; r < ranks; *n += m.n[r++])
        if (m.n[r] > 0)
            memcpy(list + *n, m.at[r], (size_t)m.n[r] * sizeof *list);
    mail_close(&m);
    qsort(list, (size_t)*n, sizeof *list, by_index);
    for (i = most = 0; i < *n; i++)
        if ((i == 0 || list[i].index != list[i - 1].index) &&
            owner_of(list[i].x) != me)
            list[most++] = list[i];
    *n = most;
    return list;
}
