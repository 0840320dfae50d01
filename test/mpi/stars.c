/* stars.c - the stars of the own points, and how processes agree on them; see
 * mesh.c.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mesh.h"

/* A tetrahedron that is not the same on both sides: its hash and the other
 * process. */
typedef struct doubt {
    uint64_t hash;
    int peer;
} doubt;

/* In a table: the number of a tetrahedron times 4, plus whether it is there and
 * whether it is in the other process. */
#define OURS 1
#define THEIRS 2

/* Marks of points: the star is computed again; the point is in the small set
 * for that.  And of tetrahedra: star has met it; it is in an old star. */
#define MARKED 1
#define NEAR 2
#define SEEN 1
#define OLD 2

static mesh *m;
static tess_int room;            /* of known points */
static tess_int maxtet;          /* of tetrahedra */
static tess_int *first;          /* a tetrahedron of an own point */
static char *mark;               /* of points */
static char *taken;              /* of tetrahedra */
static tess_int sorted;          /* points known at first, by index */
static table place;              /* of others: index -> known point */
static table both;               /* hash and process -> OURS, THEIRS */
static table *has_been_sent;
static mail hashes;
static doubt *doubts;
static num ndoubt, doubtroom;

/* A list of integers. */
typedef struct list {
    tess_int n, room, *at;
} list;

static list marked, learned, old, unused;

static void push(list *l, tess_int i)
{
    if (l->n == l->room) {
        l->room = 2 * l->room + 64;
        l->at = (tess_int *)grow(l->at, l->room, sizeof *l->at);
    }
    l->at[l->n++] = i;
}

static void drop(list *l)
{
    free(l->at);
    memset(l, 0, sizeof *l);
}

/* ---- points ---- */

static void set_point(tess_int i, const point *p, int owner)
{
    int k;

    m->index[i] = p->index;
    for (k = 0; k < 3; k++) m->x[3 * i + k] = p->x[k];
    m->owner[i] = owner;
}

static void points_room(tess_int n)
{
    if (n <= room) return;
    room = n;
    m->index = (num *)grow(m->index, room, sizeof *m->index);
    m->x = (double *)grow(m->x, 3 * (num)room, sizeof *m->x);
    m->owner = (int *)grow(m->owner, room, sizeof *m->owner);
}

/* learn - the number of a point that came, which may be new. */
static tess_int learn(const point *p)
{
    tess_int lo = 0, hi = sorted, mid;
    int *at;

    while (lo < hi) {
        mid = lo + (hi - lo) / 2;
        if (m->index[mid] < p->index)
            lo = mid + 1;
        else
            hi = mid;
    }
    if (lo < sorted && m->index[lo] == p->index) return lo;
    at = find(&place, (uint64_t)p->index);
    if (*at != ABSENT) return *at;
    *at = m->n;
    if (m->n == room) {
        points_room(room + room / 8 + 64);
        mark = (char *)grow(mark, room, 1);
    }
    mark[m->n] = 0;
    set_point(m->n, p, owner_of(p->x));
    push(&learned, m->n);
    return m->n++;
}

static point the_point(tess_int i)
{
    point p;

    p.index = m->index[i];
    memcpy(p.x, m->x + 3 * i, sizeof p.x);
    return p;
}

/* merge - all points known at first, in the order of their indices. */
static void merge(cloud *c, point *foreign, num n)
{
    num i = 0, j = 0;

    points_room((tess_int)(c->n + n));
    for (m->n = 0; m->n < c->n + n; m->n++)
        if (j == n || (i < c->n && c->at[i].index < foreign[j].index))
            set_point(m->n, c->at + i++, me);
        else {
            set_point(m->n, foreign + j, owner_of(foreign[j].x));
            j++;
        }
    m->own = (tess_int)c->n;
    m->known = (double)n;
    free(c->at);
    free(foreign);
}

/* ---- the library ---- */

/* compute - the tetrahedra at points with mine[i] != 0, of n points. */
static void compute(tess_int n, const double *x, const tess_int *mine,
                    tess_int wanted, tess_int *ntet, tess_int *most,
                    tess_int **tet, tess_int **adj)
{
    tess_int liw, lrw, *iw;
    double *rw;
    int code;

    *most = wanted;
    *ntet = 0;
    *tet = (tess_int *)grow(NULL, 4 * (num)*most, sizeof **tet);
    *adj = (tess_int *)grow(NULL, 4 * (num)*most, sizeof **adj);
    if (tess_size(n, *most, &liw, &lrw) != 0) fail("too many points");
    iw = (tess_int *)grow(NULL, liw, sizeof *iw);
    rw = (double *)grow(NULL, lrw, sizeof *rw);
    code = tess_index(n, x, liw, iw, lrw, rw);
    while (code == 0) {
        code = tess_part(n, x, mine, *most, ntet, *tet, *adj, liw, iw, lrw, rw);
        if (code == TESS_POOL) {
            if (liw > TESS_INT_MOST / 2) break;
            liw *= 2;
            iw = (tess_int *)grow(iw, liw, sizeof *iw);
        } else if (code == TESS_MORE) {
            if (*most > TESS_INT_MOST / 8) break;
            *most += *most / 4 + 1000;
            *tet = (tess_int *)grow(*tet, 4 * (num)*most, sizeof **tet);
            *adj = (tess_int *)grow(*adj, 4 * (num)*most, sizeof **adj);
        } else
            break;
        code = 0;
    }
    if (code == TESS_RANGE) fail("the arithmetic cannot hold the coordinates");
    if (code != 0) fail("too many tetrahedra: use more processes");
    free(iw);
    free(rw);
}

/* ---- tetrahedra ---- */

static int is_own(tess_int i)
{
    return m->owner[i] == me;
}

static uint64_t tet_hash(const tess_int *v)
{
    num index[4];
    int k;

    for (k = 0; k < 4; k++) index[k] = m->index[v[k]];
    return hash(index, 4);
}

/* star - the tetrahedra at v: put them into a list. */
static void star(tess_int v, list *l)
{
    tess_int t, u, i;
    int k;

    l->n = 0;
    if (first[v] == TESS_NONE) return;
    push(l, first[v]);
    taken[first[v]] |= SEEN;
    for (i = 0; i < l->n; i++) {
        t = l->at[i];
        for (k = 0; k < 4; k++) {
            u = m->adj[4 * t + k];
            if (u < 0 || m->tet[4 * t + k] == v || taken[u] & SEEN) continue;
            taken[u] |= SEEN;
            push(l, u);
        }
    }
    for (i = 0; i < l->n; i++) taken[l->at[i]] &= ~SEEN;
}

/* ---- agreement ---- */

static uint64_t doubt_key(uint64_t hash, int peer)
{
    return hash ^ mix((uint64_t)peer + 1);
}

static void doubted(uint64_t hash, int peer)
{
    if (ndoubt == doubtroom) {
        doubtroom = 2 * doubtroom + 64;
        doubts = (doubt *)grow(doubts, doubtroom, sizeof *doubts);
    }
    doubts[ndoubt].hash = hash;
    doubts[ndoubt++].peer = peer;
}

/* toggle - tetrahedron t has come, or is to go: note it, and tell the others
 * that have vertices of it.  All tell the one of least rank, and that one all:
 * who agrees with it agrees with the others. */
static void toggle(tess_int t)
{
    const tess_int *v = m->tet + 4 * t;
    uint64_t h;
    int j, k, least = me, r, *at;

    for (k = 0; k < 4; k++)
        if (m->owner[v[k]] < least) least = m->owner[v[k]];
    h = 0;
    for (k = 0; k < 4; k++) {
        r = m->owner[v[k]];
        if (r == me || (me != least && r != least)) continue;
        for (j = 0; j < k && m->owner[v[j]] != r; j++) continue;
        if (j < k) continue;
        if (h == 0) h = tet_hash(v);
        at = find(&both, doubt_key(h, r));
        if (*at == ABSENT) *at = 0;
        *at = (int)((4 * t) | ((*at & 3) ^ OURS));
        put(&hashes, r, &h);
        doubted(h, r);
    }
}

static void mark_point(tess_int i)
{
    if (!is_own(i) || mark[i] & MARKED) return;
    mark[i] |= MARKED;
    push(&marked, i);
}

/* differ - exchange the hashes of what has changed; then mark the vertices of
 * tetrahedra that the others lack, and put those into the letters.  Returns how
 * many are not on both sides. */
static num differ(mail *letters)
{
    uint64_t *h;
    point p[4];
    num i, n = 0;
    int *at, k, r;

    exchange(&hashes, HASHES);
    for (r = 0; r < ranks; r++) {
        if (r == me) continue;
        h = (uint64_t *)hashes.at[r];
        for (i = 0; i < hashes.n[r]; i++) {
            at = find(&both, doubt_key(h[i], r));
            if (*at == ABSENT) *at = 0;
            *at ^= THEIRS;
            doubted(h[i], r);
        }
    }
    mail_close(&hashes);
    mail_open(&hashes, sizeof *h);
    for (i = 0; i < ndoubt; i++) {
        at = find(&both, doubt_key(doubts[i].hash, doubts[i].peer));
        if ((*at & 3) != OURS && (*at & 3) != THEIRS) continue;
        doubts[n++] = doubts[i];
        if ((*at & 3) == THEIRS) continue;
        for (k = 0; k < 4; k++) {
            p[k] = the_point(m->tet[(*at & ~3) + k]);
            mark_point(m->tet[(*at & ~3) + k]);
        }
        put(letters, doubts[i].peer, p);
    }
    ndoubt = n;
    return n;
}

/* disagree - print a tetrahedron that the others lack. */
static void disagree(void)
{
    const tess_int *v;
    num i;
    int at;

    for (i = 0; i < ndoubt; i++) {
        at = *find(&both, doubt_key(doubts[i].hash, doubts[i].peer));
        if ((at & 3) != OURS) continue;
        v = m->tet + (at & ~3);
        fprintf(stderr, "mesh: process %d has %.0f %.0f %.0f %.0f, %d not\n",
                me, (double)m->index[v[0]], (double)m->index[v[1]],
                (double)m->index[v[2]], (double)m->index[v[3]],
                doubts[i].peer);
        return;
    }
}

/* reply - learn the tetrahedra that only others have, mark their own vertices,
 * and put the links of these into the replies. */
static void reply(const mail *letters, mail *replies)
{
    list around = {0, 0, NULL};
    table told = {0, 0, NULL, NULL};
    tess_int v, w, j;
    point p;
    num i;
    int k, r;

    for (r = 0; r < ranks; r++)
        for (i = 0; i < 4 * letters->n[r] && r != me; i++) {
            v = learn((point *)letters->at[r] + i);
            if (!is_own(v)) continue;
            mark_point(v);
            if (given(&told, m->index[v], r)) continue;
            star(v, &around);
            for (j = 0; j < around.n; j++)
                for (k = 0; k < 4; k++) {
                    w = m->tet[4 * around.at[j] + k];
                    if (m->owner[w] == r ||
                        given(has_been_sent, m->index[w], r))
                        continue;
                    p = the_point(w);
                    put(replies, r, &p);
                }
        }
    drop(&around);
    forget(&told);
}

/* ---- stars computed again ---- */

static int by_index(const void *a, const void *b)
{
    num i = m->index[*(const tess_int *)a], j = m->index[*(const tess_int *)b];

    return i < j ? -1 : i > j;
}

/* The stars of the marked points in the mesh of a few: tetrahedra, with numbers
 * in near; and for each the number it has or gets. */
static list near;
static tess_int newtets, *newtet, *newadj, *becomes;

static void bring(tess_int i)
{
    if (mark[i] & NEAR) return;
    mark[i] |= NEAR;
    push(&near, i);
}

/* again - compute the stars of the marked points, from themselves, their links
 * and what has been learned.  What then differs from the stars of other own
 * points marks these.  Returns 1 if there are any. */
static int again(void)
{
    table known = {0, 0, NULL, NULL};
    list around = {0, 0, NULL};
    tess_int i, j, t, most, *mine, *v;
    double *x;
    char *stays;
    int k, *at, spread = 0;
    static tess_int seen;

    /* of those marked since the last time */
    if (near.n == 0) {
        seen = 0;
        for (i = 0; i < learned.n; i++) bring(learned.at[i]);
    }
    for (; seen < marked.n; seen++) {
        bring(marked.at[seen]);
        star(marked.at[seen], &around);
        for (j = 0; j < around.n; j++) {
            t = around.at[j];
            for (k = 0; k < 4; k++) bring(m->tet[4 * t + k]);
            if (taken[t] & OLD) continue;
            taken[t] |= OLD;
            push(&old, t);
        }
    }
    drop(&around);
    qsort(near.at, (size_t)near.n, sizeof *near.at, by_index);
    x = (double *)grow(NULL, 3 * (num)near.n, sizeof *x);
    mine = (tess_int *)grow(NULL, near.n, sizeof *mine);
    for (i = 0; i < near.n; i++) {
        memcpy(x + 3 * i, m->x + 3 * near.at[i], 3 * sizeof *x);
        mine[i] = (mark[near.at[i]] & MARKED) != 0;
    }
    free(newtet);
    free(newadj);
    compute(near.n, x, mine, 40 * marked.n + 100, &newtets, &most, &newtet,
            &newadj);
    free(x);
    free(mine);
    becomes = (tess_int *)grow(becomes, newtets, sizeof *becomes);
    stays = (char *)grow(NULL, old.n, 1);
    memset(stays, 0, (size_t)old.n);
    for (i = 0; i < old.n; i++)
        *find(&known, tet_hash(m->tet + 4 * old.at[i])) = (int)i;
    for (i = 0; i < newtets; i++) {
        v = newtet + 4 * i;
        for (k = 0; k < 4; k++) v[k] = near.at[v[k]];
        at = find(&known, tet_hash(v));
        becomes[i] = *at == ABSENT ? TESS_NONE : old.at[*at];
        if (*at != ABSENT) stays[*at] = 1;
        for (k = 0; k < 4 && *at == ABSENT; k++) mark_point(v[k]);
    }
    for (i = 0; i < old.n; i++)
        for (k = 0; k < 4 && !stays[i]; k++)
            mark_point(m->tet[4 * old.at[i] + k]);
    spread = seen < marked.n;
    /* for replace: what goes is no longer in old */
    for (i = j = 0; i < old.n && !spread; i++)
        if (!stays[i]) old.at[j++] = old.at[i];
    if (!spread) old.n = j;
    free(stays);
    forget(&known);
    return spread;
}

static uint64_t facet_hash(const tess_int *v, int k)
{
    num index[3];
    int i, n = 0;

    for (i = 0; i < 4; i++) if (i != k) index[n++] = m->index[v[i]];
    return hash(index, 3);
}

/* In replace, for a facet of the hull. */
#define HULL (-2)

/* replace - put the new stars in the place of the old ones.  Returns how many
 * tetrahedra go or come. */
static num replace(void)
{
    table open = {0, 0, NULL, NULL};
    tess_int i, t, u;
    num changes = old.n;
    int j, k, *at;

    /* What has neighbours beyond old and new stars finds them by its facets. */
    for (i = 0; i < old.n + newtets; i++) {
        t = i < old.n ? old.at[i] : becomes[i - old.n];
        for (k = 0; k < 4 && t != TESS_NONE; k++) {
            u = m->adj[4 * t + k];
            if (u == TESS_NONE)
                *find(&open, facet_hash(m->tet + 4 * t, k)) = HULL;
            if (u < 0 || taken[u] & OLD) continue;
            for (j = 0; m->adj[4 * u + j] != t; j++) continue;
            *find(&open, facet_hash(m->tet + 4 * t, k)) = (int)(4 * u + j);
            m->adj[4 * u + j] = TESS_OPEN;
        }
    }
    for (i = 0; i < old.n; i++) {
        t = old.at[i];
        toggle(t);
        taken[t] = 0;
        m->tet[4 * t] = TESS_NONE;
        push(&unused, t);
    }
    for (i = 0; i < newtets; i++) {
        t = becomes[i];
        if (t == TESS_NONE && unused.n > 0)
            t = unused.at[--unused.n];
        else if (t == TESS_NONE) {
            if (m->ntet == maxtet) {
                maxtet += maxtet / 8 + 1000;
                if (maxtet > TESS_INT_MOST / 4) fail("too many tetrahedra");
                m->tet = (tess_int *)grow(m->tet, 4 * (num)maxtet,
                                          sizeof *m->tet);
                m->adj = (tess_int *)grow(m->adj, 4 * (num)maxtet,
                                          sizeof *m->adj);
                taken = (char *)grow(taken, maxtet, 1);
            }
            t = m->ntet++;
        }
        taken[t] = 0;
        for (k = 0; k < 4; k++) m->tet[4 * t + k] = newtet[4 * i + k];
        if (becomes[i] == TESS_NONE) {
            toggle(t);
            changes++;
        }
        becomes[i] = t;
    }
    for (i = 0; i < newtets; i++) {
        t = becomes[i];
        for (k = 0; k < 4; k++) {
            if (is_own(m->tet[4 * t + k])) first[m->tet[4 * t + k]] = t;
            u = newadj[4 * i + k];
            m->adj[4 * t + k] = u < 0 ? u : becomes[u];
            if (u != TESS_OPEN) continue;
            /* open on both sides, too, where none of its vertices is marked:
             * the second one finds the first */
            at = find(&open, facet_hash(m->tet + 4 * t, k));
            if (*at == HULL) m->adj[4 * t + k] = TESS_NONE;
            if (*at < 0)
                *at = (int)(4 * t + k);
            else {
                m->adj[4 * t + k] = (tess_int)(*at / 4);
                m->adj[*at] = t;
            }
        }
    }
    forget(&open);
    return changes;
}

/* repair - compute the stars of the marked points again, until the own ones
 * agree.  Returns how many tetrahedra go or come. */
static num repair(void)
{
    tess_int i;
    num changes;

    if (marked.n == 0) return 0;
    while (again()) continue;
    changes = replace();
    for (i = 0; i < near.n; i++) mark[near.at[i]] = 0;
    near.n = old.n = marked.n = 0;
    return changes;
}

void stars(mesh *result, cloud *c, point *foreign, num n, table *sent)
{
    mail letters, replies;
    tess_int i, *mine;
    num unequal;
    int k, r;

    m = result;
    has_been_sent = sent;
    merge(c, foreign, n);
    maxtet = 0;
    if (m->own > 0) {
        mine = (tess_int *)grow(NULL, m->n, sizeof *mine);
        for (i = 0; i < m->n; i++) mine[i] = is_own(i);
        compute(m->n, m->x, mine, 8 * m->own + 1000, &m->ntet, &maxtet, &m->tet,
                &m->adj);
        free(mine);
        maxtet = m->ntet + m->ntet / 16 + 1000;
        m->tet = (tess_int *)grow(m->tet, 4 * (num)maxtet, sizeof *m->tet);
        m->adj = (tess_int *)grow(m->adj, 4 * (num)maxtet, sizeof *m->adj);
    }
    mark = (char *)grow(NULL, room, 1);
    memset(mark, 0, (size_t)room);
    taken = (char *)grow(NULL, maxtet, 1);
    memset(taken, 0, (size_t)maxtet);
    first = (tess_int *)grow(NULL, room, sizeof *first);
    for (i = 0; i < m->n; i++) first[i] = TESS_NONE;
    sorted = m->n;
    mail_open(&hashes, sizeof(uint64_t));
    for (i = 0; i < m->ntet; i++) {
        for (k = 0; k < 4; k++)
            if (is_own(m->tet[4 * i + k])) first[m->tet[4 * i + k]] = i;
        if (!INNER(m, m->tet + 4 * i)) toggle(i);
    }
    for (m->rounds = 1;; m->rounds++) {
        mail_open(&letters, 4 * sizeof(point));
        unequal = total(differ(&letters));
        if (me == 0)
            fprintf(stderr, "round %d: %.0f differ\n", m->rounds,
                    (double)unequal);
        if (unequal == 0) break;
        exchange(&letters, POINTS);
        mail_open(&replies, sizeof(point));
        reply(&letters, &replies);
        mail_close(&letters);
        exchange(&replies, POINTS);
        for (r = 0; r < ranks; r++)
            for (n = 0; n < replies.n[r]; n++)
                (void)learn((point *)replies.at[r] + n);
        mail_close(&replies);
        /* by 2 of mesh.c some star changes, which bounds the rounds */
        if (total(repair()) == 0) {
            if (ndoubt > 0) disagree();
            MPI_Barrier(MPI_COMM_WORLD);
            fail("the stars do not agree, and none changes");
        }
    }
    mail_close(&letters);
    mail_close(&hashes);
    free(doubts);
    free(mark);
    free(taken);
    free(first);
    forget(&place);
    forget(&both);
    drop(&marked);
    drop(&learned);
    drop(&old);
    drop(&unused);
    drop(&near);
    free(newtet);
    free(newadj);
    free(becomes);
}
