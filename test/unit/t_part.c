/* t_part.c - tests of tess_index, tess_part, tess_query and tess_ball, and of
 * test/examples/join.c.
 *
 *     t_part          all tests
 *     t_part -quick   fewer and smaller ones, for slow builds
 *
 * Covered:
 *   parts    of every family, as it is and turned: in ranges of the sorted
 *            order, slabs and random parts, 2 to 1,024 of them, each part is
 *            those tetrahedra of tess's mesh, all and each once, that have a
 *            vertex asked for, its adj is right, in arrays of exact length
 *            between guards; put together by join.c's keep and append, all of
 *            them or some, tess_resume makes them the mesh, and so does join
 *   subsets  a star computed from random points among which are all its true
 *            neighbours, in the order of the whole, is the star of the mesh,
 *            ties too: what processes that share nothing rely on
 *   resume   a part stopped at every tetrahedron, or for want of pool
 *   supports an index that knows planes and spheres: parts and queries from
 *            it, from a copy, from arrays that held another one before, after a
 *            part that found more; refused where the arrays are too short for
 *            what it has
 *   queries  tess_query and tess_locate answer alike: on points, midpoints,
 *            edges, facets, anywhere, from near and from nowhere; outside
 *   balls    no point outside of tess_ball's is inside the exact one
 *   codes    bad input, flat input; an index with a coordinate that is taken for
 *            zero by now
 */
#include "../../tess.h"
#include "../examples/join.c"
#include "../proof/exact.h"
#include "../points.h"
#include "guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SHOWN 5

static int quick;
static long faults;
static const char *now = "";

static void require(int holds, const char *what)
{
    if (!holds && faults++ < SHOWN) printf("%s (%s)\n", what, now);
}

/* Free the arrays made since there were so many of them. */
static void drop(int many)
{
    require(overrun() == 0, "an array is overrun");
    release(many);
}

static tess_int *copy(const tess_int *a, tess_int n)
{
    tess_int *b = ints(n);

    memcpy(b, a, (size_t)n * sizeof *b);
    return b;
}

/* ---- a set of points, its mesh and its index ---- */

typedef struct whole {
    tess_int n, ntet, liw, lrw, hull;
    tess_real *p;
    tess_int *tet, *adj, *rep; /* as tess gave them */
    tess_int *set;             /* the tetrahedra as a sorted set */
    tess_int *first, *at;      /* at point i: at[first[i] ...], of set */
    tess_int *iw;              /* the index */
    double *rw;
    int code;
} whole;

static int by_four(const void *a, const void *b)
{
    const tess_int *v = (const tess_int *)a, *w = (const tess_int *)b;
    int k = 0;

    while (k < 3 && v[k] == w[k]) k++;
    return v[k] < w[k] ? -1 : v[k] > w[k];
}

/* s = the vertices of v in ascending order but for the last two, which tell
 * the orientation. */
static void standard(const tess_int *v, tess_int *s)
{
    tess_int x;
    int j, k, odd = 0;

    for (j = 0; j < 4; j++) {
        s[j] = v[j];
        for (k = j; k > 0 && s[k - 1] > s[k]; k--) {
            x = s[k];
            s[k] = s[k - 1];
            s[k - 1] = x;
            odd = !odd;
        }
    }
    if (odd) {
        x = s[2];
        s[2] = s[3];
        s[3] = x;
    }
}

static tess_int *as_set(tess_int ntet, const tess_int *tet)
{
    tess_int *s = ints(4 * ntet), t;

    for (t = 0; t < ntet; t++) standard(tet + 4 * t, s + 4 * t);
    qsort(s, (size_t)ntet, 4 * sizeof *s, by_four);
    return s;
}

/* The number in the set of the tetrahedron v, or -1. */
static tess_int number(const whole *m, const tess_int *v)
{
    tess_int s[4];
    const tess_int *f;

    standard(v, s);
    f = (const tess_int *)bsearch(s, m->set, (size_t)m->ntet, 4 * sizeof *s,
                                  by_four);
    return f == NULL ? -1 : (tess_int)((f - m->set) / 4);
}

/* adj is mutual across facets of the same vertices; returns the number of
 * facets on the hull. */
static tess_int linked(tess_int ntet, const tess_int *tet, const tess_int *adj)
{
    tess_int t, u, hull = 0;
    int i, j, k, common;

    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            hull += u == TESS_NONE;
            if (u < 0) continue;
            require(u < ntet, "a neighbour out of range");
            if (u >= ntet) continue;
            for (j = 0; j < 4 && adj[4 * u + j] != t; j++)
                ;
            common = 0;
            for (i = 0; i < 16; i++)
                common += i / 4 != k && i % 4 != j &&
                          tet[4 * t + i / 4] == tet[4 * u + i % 4];
            require(j < 4 && common == 3, "neighbours do not match");
        }
    return hull;
}

static void make(whole *m)
{
    tess_int *iw, *tet, *adj, maxtet = 8 * m->n + 20, i, t;
    double *rw;
    int mark = narrays, k;

    m->code = TESS_MORE;
    while (m->code == TESS_MORE) {
        drop(mark);
        tess_size(m->n, maxtet, &m->liw, &m->lrw);
        m->liw += 16 * maxtet; /* parts of few neighbours need much pool */
        tet = ints(4 * maxtet);
        adj = ints(4 * maxtet);
        iw = ints(m->liw);
        rw = (double *)array((size_t)m->lrw * sizeof(double));
        m->code = tess(m->n, m->p, maxtet, &m->ntet, tet, adj, m->liw, iw,
                       m->lrw, rw);
        m->tet = tet;
        m->adj = adj;
        m->rep = iw;
        m->rw = rw;
        maxtet *= 4;
    }
    m->hull = linked(m->ntet, m->tet, m->adj);
    m->set = as_set(m->ntet, m->tet);
    m->first = ints(m->n + 1);
    m->at = ints(4 * m->ntet);
    for (i = 0; i <= m->n; i++) m->first[i] = 0;
    for (i = 0; i < 4 * m->ntet; i++) m->first[m->set[i]]++;
    for (i = 1; i <= m->n; i++) m->first[i] += m->first[i - 1];
    for (t = 0; t < m->ntet; t++)
        for (k = 0; k < 4; k++) m->at[--m->first[m->set[4 * t + k]]] = t;
    m->iw = ints(m->liw);
    k = tess_index(m->n, m->p, m->liw, m->iw, m->lrw, m->rw);
    require(k == m->code, "the code of tess_index");
    if (m->code != 0) return; /* what the build's arithmetic does not hold */
    for (i = 0; i < m->n; i++) {
        require(m->iw[i] >= 0 && m->iw[i] < m->n, "a place out of range");
        require(m->iw[i] == m->iw[m->rep[i]], "the place of a duplicate");
    }
}

/* The points of a family, or, if turned is 1, the same turned and moved, or, if
 * it is 2, half of them, each twice; 0 for none. */
static int family(whole *m, const char *name, long n, unsigned long seed,
                  int turned)
{
    double *p = (double *)malloc((size_t)(3 * n + 3) * sizeof(double));
    double size = 0.0, x, y, z;
    long i;

    if (p == NULL) exit(2);
    m->n = (tess_int)points_make(name, n, seed, p);
    for (i = 0; i < 3 * m->n; i++) size = fabs(p[i]) > size ? fabs(p[i]) : size;
    for (i = 0; turned == 2 && i < 3 * (m->n / 2); i++)
        p[3 * (m->n - m->n / 2) + i] = p[i];
    if (turned == 1 && size > 1e-50 && size < 1e50)
        for (i = 0; i < m->n; i++) {
            x = 0.8 * p[3 * i] - 0.6 * p[3 * i + 1] + 3.1 * size;
            y = 0.6 * p[3 * i] + 0.8 * p[3 * i + 1];
            z = p[3 * i + 2];
            p[3 * i] = x;
            p[3 * i + 1] = cos(0.4) * y - sin(0.4) * z + 1.7 * size;
            p[3 * i + 2] = sin(0.4) * y + cos(0.4) * z - 0.3 * size;
        }
    m->p = (tess_real *)array((size_t)(3 * m->n) * sizeof(tess_real));
    for (i = 0; i < 3 * m->n; i++) m->p[i] = (tess_real)p[i];
    free(p);
    if (m->n == 0) return 0;
    make(m);
    if (m->code != 0) drop(0);
    return m->code == 0;
}

/* ---- parts ---- */

static const whole *sorting;

static int by_x(const void *a, const void *b)
{
    tess_int i = *(const tess_int *)a, j = *(const tess_int *)b;
    double x = sorting->p[3 * i], y = sorting->p[3 * j];

    return x != y ? (x < y ? -1 : 1) : i < j ? -1 : 1;
}

/* part[i] = the one of many parts that point i is in. */
static void divide(const whole *m, int kind, tess_int many, tess_int *part)
{
    tess_int *order = ints(m->n), i;

    for (i = 0; i < m->n; i++) order[i] = i;
    sorting = m;
    if (kind == 1) qsort(order, (size_t)m->n, sizeof *order, by_x);
    for (i = 0; i < m->n; i++)
        if (kind == 0)
            part[i] = (tess_int)((long)m->iw[i] * many / m->n);
        else if (kind == 1)
            part[order[i]] = (tess_int)((long)i * many / m->n);
        else
            part[i] = (tess_int)rnd_below((int)many);
}

/* One part, its arrays of the length that is needed, but for an iw of length
 * liw, or 0 for m's; all must be right. */
static tess_int one_part(const whole *m, const tess_int *mine, tess_int liw,
                         tess_int *iw, tess_int **tet, tess_int **adj)
{
    tess_int *asked = ints(m->n), *met = ints(m->ntet), ntet, need = 0, i, t, j;
    tess_int usual = 6 * m->n + 600;
    int k, code, own, hull = 0;

    for (i = 0; i < m->n; i++) asked[i] = 0;
    for (t = 0; t < m->ntet; t++) met[t] = 0;
    for (i = 0; i < m->n; i++)
        if (mine[i]) asked[m->rep[i]] = 1;
    for (i = 0; i < m->n; i++)
        for (j = m->first[i]; asked[i] && j < m->first[i + 1]; j++)
            if (met[m->at[j]]++ == 0) need++;
    *tet = ints(4 * need);
    *adj = ints(4 * need);
    ntet = 0;
    for (i = 0, k = 0; i < m->n; i++) k += mine[i] != 0;
    /* as join.c says; a vertex may have very many neighbours */
    usual += (tess_int)TESS_LIW(k);
    if (usual > m->liw) usual = m->liw;
    code = tess_part(m->n, m->p, mine, need, &ntet, *tet, *adj,
                     liw > 0 ? liw : usual, iw, m->lrw, m->rw);
    if (code == TESS_POOL && liw == 0)
        code = tess_part(m->n, m->p, mine, need, &ntet, *tet, *adj, m->liw,
                         iw, m->lrw, m->rw);
    require(code == m->code, "the code of a part");
    require(ntet == need, "the number of tetrahedra of a part");
    if (ntet != need) {
        printf("    code %d, %ld of %ld\n", code, (long)ntet, (long)need);
        exit(1);
    }
    hull = (int)linked(ntet, *tet, *adj);
    for (t = 0; t < ntet; t++) {
        j = number(m, *tet + 4 * t);
        require(j >= 0, "a tetrahedron that is none of the mesh");
        if (j < 0) continue;
        require(met[j] > 0, "a tetrahedron twice, or not asked for");
        met[j] = 0;
        for (k = 0; k < 4; k++) {
            own = 0;
            for (i = 0; i < 4; i++)
                own += i != k && asked[(*tet)[4 * t + i]];
            require((own == 0) == ((*adj)[4 * t + k] == TESS_OPEN),
                    "open, or not");
        }
    }
    return hull;
}

/* What join makes of the tetrahedra of all parts, of which some facets, or all,
 * are open; and what it refuses. */
static void joined(const whole *m, const tess_int *tet, const tess_int *some)
{
    tess_int total = m->ntet, open = 0, i, bad, *all, *adj, *h;
    int every;

    for (i = 0; i < 4 * total; i++) open += some[i] == TESS_OPEN;
    for (every = 0; every < 2; every++) {
        adj = copy(some, 4 * total);
        for (i = 0; every && i < 4 * total; i++) adj[i] = TESS_OPEN;
        if (every) open = 4 * total;
        h = ints(open + 1);
        require(join(total, tet, adj, open, h) == -4, "join: a short table");
        require(join(total, tet, adj, open + 1, h) == 0, "join");
        require(tess_check(m->n, m->p, total, tet, adj, 2 * m->n,
                           ints(2 * m->n), &bad) == 0,
                "tess_check of parts joined");
    }
    all = copy(tet, 4 * total);
    for (i = 0; i < 4 && total > 1; i++) all[i] = all[4 + i];
    for (i = 0; i < 4 * total; i++) adj[i] = TESS_OPEN;
    if (total == 1) return;
    require(join(2, all, adj, 9, h) == 1, "join: a tetrahedron, twice");
    require(join(total, all, adj, open + 1, h) == 1,
            "join: a tetrahedron twice");
}

/* Close by join what is open on both sides, and nothing else.  Returns 1 if
 * there is such a facet. */
static int closed(tess_int ntet, const tess_int *tet, tess_int *adj)
{
    int mark = narrays, any = 0;
    tess_int *was = copy(adj, 4 * ntet), *h = ints(8 * ntet + 1), i;

    require(join(ntet, tet, adj, 8 * ntet + 1, h) == 0, "join of parts");
    for (i = 0; i < 4 * ntet; i++)
        if (was[i] == TESS_OPEN) {
            /* hull, if no part were missing */
            if (adj[i] == TESS_NONE)
                adj[i] = TESS_OPEN;
            else
                any = 1;
        }
    drop(mark);
    return any;
}

/* tess_resume from parts of the mesh, in arrays that have room for all of it:
 * -6 while a facet is open on both sides. */
static void resumed(const whole *m, tess_int ntet, tess_int *tet, tess_int *adj)
{
    int mark = narrays, code;
    tess_int total = m->ntet, liw = m->liw + 24 * total, *iw = ints(liw), i;
    tess_int *was = copy(adj, 4 * total), got = ntet;
    double *rw = (double *)array((size_t)m->lrw * sizeof *rw);

    if (closed(ntet, tet, was))
        require(tess_resume(m->n, m->p, total, &got, tet, adj, liw, iw, m->lrw,
                            rw) == -6 && got == ntet,
                "tess_resume of facets that are open twice");
    memcpy(adj, was, (size_t)(4 * ntet) * sizeof *adj);
    code = tess_resume(m->n, m->p, total, &got, tet, adj, liw, iw, m->lrw, rw);
    require(code == TESS_OK && got == total, "the code of parts joined");
    if (got == total) {
        require(memcmp(as_set(total, tet), m->set,
                       (size_t)(4 * total) * sizeof *tet) == 0,
                "the parts joined");
        require(linked(total, tet, adj) == m->hull, "the joined hull");
        for (i = 0; i < 4 * total; i++)
            require(adj[i] != TESS_OPEN, "open though joined");
    }
    drop(mark);
}

/* All parts of one kind; joined, too, the first of them or all. */
static void parts(const whole *m, int kind, tess_int many)
{
    tess_int *part = ints(m->n), *mine = ints(m->n), *becomes = ints(m->ntet);
    tess_int *utet = ints(4 * m->ntet), *uadj = ints(4 * m->ntet);
    tess_int *iw = copy(m->iw, m->liw), *set, *tet, *adj;
    tess_int total = 0, i, k, u, ntet, some;
    int mark = narrays;

    divide(m, kind, many, part);
    for (k = 0; k < many; k++) {
        int inner = narrays;

        u = 0;
        for (i = 0; i < m->n; i++) u += mine[i] = part[i] == k;
        if (u == 0 && k > 8) continue;
        one_part(m, mine, 0, iw, &tet, &adj);
        ntet = (tess_int)(length_of(narrays - 2) / sizeof(tess_int) / 4);
        u = total + keep(ntet, tet, mine, becomes);
        if (u <= m->ntet) append(ntet, tet, adj, becomes, total, utet, uadj);
        total = u;
        drop(inner);
    }
    require(total == m->ntet, "the parts' tetrahedra together");
    if (total != m->ntet || m->ntet == 0) {
        drop(mark);
        return;
    }
    set = as_set(total, utet);
    require(memcmp(set, m->set, (size_t)(4 * total) * sizeof *set) == 0,
            "the union of the parts");
    require(memcmp(iw, m->iw, (size_t)(2 * m->n) * sizeof *iw) == 0,
            "the index after the parts");
    joined(m, utet, uadj);
    for (some = 0; some < 2; some++) {
        ntet = some ? (total + 1) / 2 : total;
        tet = copy(utet, 4 * total);
        adj = copy(uadj, 4 * total);
        for (i = 0; i < 4 * ntet; i++)
            if (adj[i] >= ntet) adj[i] = TESS_OPEN;
        resumed(m, ntet, tet, adj);
    }
    drop(mark);
}

/* The stars of one point in sparse, from a set that has their neighbours and of
 * the others as many. */
static void subset(const whole *m, int sparse)
{
    tess_int *in = ints(m->n), *asked = ints(m->n), *name, *mine, *tet, *adj;
    tess_int *met = ints(m->ntet), i, j, n = 0, t, ntet = 0, need = 0, liw, lrw;
    tess_int *iw;
    tess_real *p;
    double *rw;
    int code, k;

    for (i = 0; i < m->n; i++)
        asked[i] = m->rep[i] == i && rnd_below(sparse) == 0;
    for (i = 0; i < m->n; i++)
        in[i] = asked[i] || (m->rep[i] == i && rnd_below(sparse) == 0);
    for (t = 0; t < m->ntet; t++) {
        met[t] = 0;
        for (k = 0; k < 4; k++) met[t] |= asked[m->set[4 * t + k]] != 0;
        for (k = 0; k < 4 && met[t]; k++) in[m->set[4 * t + k]] = 1;
        need += met[t];
    }
    if (need == 0) return;
    name = ints(m->n);
    mine = ints(m->n);
    p = (tess_real *)array((size_t)(3 * m->n) * sizeof *p);
    for (i = 0; i < m->n; i++) {
        if (!in[i]) continue;
        for (k = 0; k < 3; k++) p[3 * n + k] = m->p[3 * i + k];
        mine[n] = asked[i];
        name[n++] = i;
    }
    tess_size(n, need, &liw, &lrw);
    liw += 16 * need;
    iw = ints(liw);
    rw = (double *)array((size_t)lrw * sizeof *rw);
    tet = ints(4 * need);
    adj = ints(4 * need);
    code = tess_index(n, p, liw, iw, lrw, rw);
    if (code == 0)
        code = tess_part(n, p, mine, need, &ntet, tet, adj, liw, iw, lrw, rw);
    require(code == 0 && ntet == need, "the number of tetrahedra of a subset");
    for (i = 0; i < 4 * ntet; i++) tet[i] = name[tet[i]];
    for (t = 0; t < ntet; t++) {
        j = number(m, tet + 4 * t);
        require(j >= 0 && met[j], "a subset's tetrahedron, not the mesh's");
        if (j >= 0) met[j] = 0;
    }
}

/* Fewer points where the result is quadratic in n, where exact numbers are
 * long, and where very many points are near one sphere or plane. */
static long affordable(const char *name, long n)
{
    static const struct {
        const char *family;
        long most;
    } few[] = {
        { "wide", 8 }, { "moment", 80 }, { "helix", 80 }, { "twolines", 80 },
        { "prism", 80 }, { "spherenorm", 120 }, { "spiral", 120 },
        { "spherei", 200 }, { "planeone", 200 }, { "planespread", 200 },
        { "cylinder", 200 }
    };
    size_t i;

    for (i = 0; i < sizeof few / sizeof few[0]; i++)
        if (strcmp(name, few[i].family) == 0 && n > few[i].most)
            return few[i].most;
    return n;
}

static void test_parts(void)
{
    static const tess_int many[] = { 2, 5, 33, 1024 };
    char name[80];
    whole m;
    int f, kind, turned;
    size_t i;

    for (f = 0; points_name(f) != NULL; f++)
        for (turned = 0; turned < 2; turned++) {
            long n = affordable(points_name(f), quick ? 40 : 150);

            faults = 0;
            sprintf(name, "parts: %s%s", points_name(f),
                    turned ? ", turned" : "");
            now = name;
            if (!family(&m, points_name(f), n, 3, turned)) continue;
            for (kind = 0; kind < 3; kind++)
                for (i = 0; i < 4; i++) {
                    int mark = narrays;

                    parts(&m, kind, many[i]);
                    drop(mark);
                    subset(&m, (int)many[i % 3]);
                    drop(mark);
                }
            drop(0);
            test_result(name, faults);
        }
    /* several leaves a part, and several parts a leaf */
    faults = 0;
    now = "parts: many points";
    family(&m, "uniform", quick ? 500 : 6000, 1, 0);
    for (kind = 0; kind < 3; kind++) parts(&m, kind, quick ? 3 : 40);
    drop(0);
    test_result(now, faults);
}

/* ---- parts that stop ---- */

static void test_resume(void)
{
    static const char *const name[] = {
        "uniform", "lattice", "duplicates", "cubesurf", "planeone"
    };
    tess_int *mine, *was, *iw, *tet, *adj, *t2, *a2, i, ntet, got, step, liw;
    whole m;
    size_t f, length;
    int code, kind, pools = 0;

    for (f = 0; f < 5; f++) {
        faults = 0;
        now = name[f];
        family(&m, name[f], quick ? 40 : 120, 2, 0);
        mine = ints(m.n);
        for (kind = 0; kind < 3; kind++) {
            int outer = narrays;

            divide(&m, kind, 3, mine);
            for (i = 0; i < m.n; i++) mine[i] = mine[i] == 1;
            iw = copy(m.iw, m.liw);
            one_part(&m, mine, 0, iw, &tet, &adj);
            ntet = (tess_int)(length_of(narrays - 1) / sizeof *tet / 4);
            length = (size_t)(4 * ntet) * sizeof *tet;
            for (step = 1; step < ntet; step = 2 * step + 1) {
                int mark = narrays;

                t2 = ints(4 * ntet);
                a2 = ints(4 * ntet);
                got = 0;
                for (i = 0; i < ntet; i += step) {
                    code = tess_part(m.n, m.p, mine, i, &got, t2, a2, m.liw,
                                     iw, m.lrw, m.rw);
                    require(code == TESS_MORE && got == i, "stopped");
                    require(memcmp(t2, tet, (size_t)(4 * i) * sizeof *t2) == 0,
                            "the beginning of a part");
                }
                code = tess_part(m.n, m.p, mine, ntet, &got, t2, a2, m.liw,
                                 iw, m.lrw, m.rw);
                require(code == TESS_OK && got == ntet &&
                        memcmp(t2, tet, length) == 0 &&
                        memcmp(a2, adj, length) == 0,
                        "a part taken up again");
                drop(mark);
            }
            t2 = ints(4 * m.ntet);
            a2 = ints(4 * m.ntet);
            /* stopped in a star, which another mask does not ask for */
            got = 0;
            was = copy(mine, m.n);
            tess_part(m.n, m.p, mine, ntet / 2, &got, t2, a2, m.liw, iw,
                      m.lrw, m.rw);
            for (i = 0; i < m.n; i++) mine[i] = m.iw[i] % 7 == 3;
            for (i = 0; i < 4 * got; i++) mine[t2[i]] = 0;
            for (i = 0; i < m.n; i++) mine[i] = mine[m.rep[i]];
            code = tess_part(m.n, m.p, mine, m.ntet, &got, t2, a2, m.liw, iw,
                             m.lrw, m.rw);
            require(code == TESS_OK, "another mask");
            for (i = ntet / 2; i < got; i++)
                require(mine[t2[4 * i]] || mine[t2[4 * i + 1]] ||
                        mine[t2[4 * i + 2]] || mine[t2[4 * i + 3]],
                        "a star of the former mask goes on");
            linked(got, t2, a2);
            memcpy(t2, tet, length);
            memcpy(a2, adj, length);
            for (i = 0; i < m.n; i++) mine[i] = !was[i];
            got = ntet;
            if (closed(ntet, t2, a2)) {
                was = copy(adj, 4 * ntet);
                require(tess_part(m.n, m.p, mine, m.ntet, &got, t2, was, m.liw,
                                  iw, m.lrw, m.rw) == -7 && got == ntet,
                        "tess_part of facets that are open twice");
            }
            code = tess_part(m.n, m.p, mine, m.ntet, &got, t2, a2, m.liw, iw,
                             m.lrw, m.rw);
            require(code == TESS_OK && got == m.ntet, "a part and the rest");
            require(memcmp(as_set(got, t2), m.set,
                           (size_t)(4 * got) * sizeof *t2) == 0,
                    "a part and the rest, as a set");
            linked(got, t2, a2);
            memcpy(t2, tet, length);
            memcpy(a2, adj, length);
            resumed(&m, ntet, t2, a2);
            drop(outer);
        }
        drop(0);
        test_result(now, faults);
    }
    /* want of pool: the least length of iw, then more by and by */
    faults = 0;
    now = "a part with little pool";
    family(&m, "uniform", quick ? 300 : 1000, 2, 0);
    mine = ints(m.n);
    for (i = 0; i < m.n; i++) mine[i] = i % 3 == 0;
    iw = copy(m.iw, m.liw);
    one_part(&m, mine, 0, iw, &tet, &adj);
    ntet = (tess_int)(length_of(narrays - 1) / sizeof *tet / 4);
    t2 = ints(4 * ntet);
    a2 = ints(4 * ntet);
    got = 0;
    for (liw = 1; tess_part(m.n, m.p, mine, 0, &got, t2, a2, liw, m.iw, m.lrw,
                            m.rw) == -8; liw++)
        ;
    code = TESS_POOL;
    while (code == TESS_POOL) {
        t2 = copy(t2, 4 * ntet);
        a2 = copy(a2, 4 * ntet);
        iw = copy(m.iw, liw);
        code = tess_part(m.n, m.p, mine, ntet, &got, t2, a2, liw, iw, m.lrw,
                         m.rw);
        require(memcmp(t2, tet, (size_t)(4 * got) * sizeof *t2) == 0,
                "the beginning of a part");
        pools += code == TESS_POOL;
        liw += 40;
    }
    require(code == TESS_OK && got == ntet &&
            memcmp(a2, adj, (size_t)(4 * got) * sizeof *a2) == 0 && pools > 0,
            "a part with little pool");
    drop(0);
    test_result(now, faults);
}

/* ---- queries ---- */

static long ranges;

static int slot_of(const tess_int *v, tess_int i)
{
    int k = 0;

    while (k < 3 && v[k] != i) k++;
    return k;
}

/* tess_query of q from v, against tess_locate; 1 when q is inside. */
static int query(const whole *m, const double *at, tess_int *v)
{
    /* not const: shim.c counts them from 1, and back */
    static tess_int none[4] = { -1, -1, -1, -1 };
    static tess_int alone[4] = { 0, 1, 2, 3 };
    static const int out[4][3] = { {1,2,3}, {0,3,2}, {0,1,3}, {0,2,1} };
    tess_int t = TESS_NONE, j;
    tess_real q[3], p[12];
    double w[4], x[4], y, size;
    int code, want, i, k, beyond = 0;

    for (k = 0; k < 3; k++) q[k] = (tess_real)at[k];
    code = tess_query(m->n, m->p, m->iw, m->rw, q, v, w);
    want = tess_locate(m->p, m->ntet, m->tet, m->adj, q, &t, x);
    /* few limbs may do for one way and not for another */
    if (HH_LIMBS < 88 && (code == TESS_RANGE || want == TESS_RANGE)) {
        require(code == want || code == 1 || want == 1, "TESS_RANGE inside");
        v[0] = TESS_NONE;
        ranges++;
        return 0;
    }
    require(code == want, "the code of a query");
    j = number(m, v);
    require(j >= 0, "a query's tetrahedron is none of the mesh");
    if (j < 0) return 0;
    if (code == 0) require(number(m, m->tet + 4 * t) == j, "another one");
    if (code == 0) {
        /* its weights are those of the tetrahedron alone */
        for (k = 0; k < 12; k++) p[k] = m->p[3 * v[k / 3] + k % 3];
        t = 0;
        tess_locate(p, 1, alone, none, q, &t, x);
        require(memcmp(w, x, sizeof x) == 0, "the weights of a query");
    }
    if (code == 1) {
        /* those of the same vertices, in any tetrahedron that has them */
        for (i = 0, size = 0.0; i < 4; i++) {
            for (k = 0; k < 4 && m->tet[4 * t + k] != v[i];) k++;
            y = k < 4 ? x[k] : 0.0;
            size += y;
            require((w[i] > 0.0) == (y > 0.0) && w[i] >= 0.0,
                    "the vertices of a query outside");
            require(fabs(w[i] - y) <= 4.0 * DBL_EPSILON * y,
                    "the weights of a query outside");
        }
        require(fabs(size - 1.0) <= 4.0 * DBL_EPSILON,
                "not all vertices of a query outside");
        for (t = 0; number(m, m->tet + 4 * t) != j; t++)
            ;
        for (k = 0; k < 4; k++) {
            const tess_int *u = m->tet + 4 * t;

            beyond += m->adj[4 * t + k] == TESS_NONE &&
                      w[slot_of(v, u[k])] == 0.0 &&
                      hh_orient(m->p + 3 * u[out[k][0]],
                                m->p + 3 * u[out[k][1]],
                                m->p + 3 * u[out[k][2]], q) > 0;
        }
        require(beyond > 0, "outside, but not of a hull facet");
    }
    return code == 0;
}

static void test_queries(void)
{
    char name[80];
    double lo[3], hi[3], q[3], x[3];
    tess_int v[4], i, t;
    whole m;
    int f, k, turned, kind, inside;

    for (f = 0; points_name(f) != NULL; f++)
        for (turned = 0; turned < 2; turned++) {
            faults = 0;
            sprintf(name, "queries: %s%s", points_name(f),
                    turned ? ", turned" : "");
            now = name;
            if (!family(&m, points_name(f),
                        affordable(points_name(f), quick ? 60 : 400), 5,
                        turned))
                continue;
            inside = 0;
            ranges = 0;
            for (k = 0; k < 3; k++) {
                lo[k] = hi[k] = m.p[k];
                for (i = 0; i < m.n; i++) {
                    lo[k] = m.p[3 * i + k] < lo[k] ? m.p[3 * i + k] : lo[k];
                    hi[k] = m.p[3 * i + k] > hi[k] ? m.p[3 * i + k] : hi[k];
                }
            }
            for (i = 0; i < (quick ? 10 : 40); i++)
                for (kind = 1; kind <= 9; kind++) {
                    /* a point, or the mean of 2 ... 4 of a tetrahedron, or
                     * anywhere, half of it outside, or beyond a vertex, near
                     * or far */
                    t = (tess_int)rnd_below((int)m.ntet);
                    for (k = 0; k < 3; k++) {
                        const tess_int *u = m.tet + 4 * t;

                        q[k] = m.p[3 * u[0] + k];
                        if (kind == 2) q[k] = 0.5 * q[k] +
                                              0.5 * m.p[3 * u[1] + k];
                        if (kind == 3) q[k] = 0.25 * q[k] +
                                              0.75 * m.p[3 * u[3] + k];
                        if (kind == 4) q[k] = 0.25 * q[k] +
                                              0.5 * m.p[3 * u[1] + k] +
                                              0.25 * m.p[3 * u[2] + k];
                        if (kind == 5) q[k] = 0.25 * q[k] +
                                              0.25 * m.p[3 * u[1] + k] +
                                              0.25 * m.p[3 * u[2] + k] +
                                              0.25 * m.p[3 * u[3] + k];
                        if (kind > 5)
                            x[k] = lo[k] - 0.1 * (hi[k] - lo[k]) +
                                   1.2 * rnd_unit() * (hi[k] - lo[k]);
                        if (kind == 6 || kind == 7) q[k] = x[k];
                        if (kind > 7)
                            q[k] += (kind == 8 ? 0.1 : 1e6) *
                                    (x[k] - 0.5 * (lo[k] + hi[k]));
                    }
                    /* from nowhere, and from the last one */
                    if (i % 2 == 0 || i < 2) v[0] = TESS_NONE;
                    inside += query(&m, q, v);
                }
            require(inside + (HH_LIMBS < 88 ? ranges : 0) > i,
                    "the queries are all outside");
            drop(0);
            test_result(name, faults);
        }
    /* a long way, and back */
    faults = 0;
    now = "queries: from far";
    family(&m, "uniform", quick ? 500 : 20000, 5, 0);
    v[0] = TESS_NONE;
    for (i = 0; i < (quick ? 50 : 1000); i++) {
        for (k = 0; k < 3; k++) q[k] = rnd_unit() * 0.999 + 5e-4;
        query(&m, q, v);
        if (i % 10 > 5) v[0] = TESS_NONE;
    }
    drop(0);
    test_result(now, faults);
}

/* A former answer that is none. */
static void test_astray(void)
{
    tess_int v[4], i;
    double w[4];
    tess_real q[3];
    whole m;
    int k, code, good = 0;

    faults = 0;
    now = "queries: from no tetrahedron of the mesh";
    family(&m, "lattice", 343, 5, 0);
    for (i = 0; i < 2000; i++) {
        for (k = 0; k < 4; k++) v[k] = (tess_int)rnd_below((int)m.n);
        for (k = 0; k < 3; k++) q[k] = (tess_real)(rnd_unit() * 6.0);
        code = tess_query(m.n, m.p, m.iw, m.rw, q, v, w);
        require(code == -6 || code == 0 || code == 1, "its code");
        good += code >= 0 && number(&m, v) >= 0;
    }
    require(good > 100, "it is found all the same, as a rule");
    drop(0);
    test_result(now, faults);
}

/* ---- supports: planes and spheres that an index knows ---- */

#if defined(TESS_LIST) && TESS_LIST < 128
#define SOUGHT 0
#else
#define SOUGHT (sizeof(tess_real) == sizeof(double))
#endif

/* Where an index says how many there are: ahead of the tree's nodes in tess.c,
 * which counts points from 0, behind them in tess.f, which counts from 1. */
static tess_int counted(const whole *m, const tess_int *iw)
{
    tess_int tree = 2 * m->n + 5, leaves = 1, i = 0;

    while (leaves < (m->n + 47) / 48) leaves *= 2;
    while (i < iw[tree - 1] && iw[m->n + i] > 0) i++;
    return i < iw[tree - 1] ? tree : tree + 2 * leaves - 1;
}

static tess_int supports(const whole *m, const tess_int *iw)
{
    return iw[counted(m, iw)];
}

/* Queries by an index iw. */
static void ask(whole *m, tess_int *iw)
{
    tess_int *was = m->iw, v[4], a, b, i;
    double q[3];
    int k;

    m->iw = iw;
    v[0] = TESS_NONE;
    for (i = 0; i < 8; i++) {
        a = (tess_int)rnd_below((int)m->n);
        b = (tess_int)rnd_below((int)m->n);
        for (k = 0; k < 3; k++)
            q[k] = 0.5 * m->p[3 * a + k] + 0.5 * m->p[3 * b + k];
        query(m, q, v);
        if (i % 2) v[0] = TESS_NONE;
    }
    m->iw = was;
}

/* Two of many parts by an index iw, the second one stopped and taken up again,
 * and queries behind each; iw is of length liw. */
static void serve(whole *m, tess_int many, tess_int liw, tess_int *iw)
{
    tess_int *part = ints(m->n), *mine = ints(m->n), *tet, *adj, *t2, *a2;
    tess_int i, k, ntet, got;
    size_t length = 0;
    int mark = narrays, code;

    divide(m, 0, many, part);
    for (k = 0; k <= many / 3; k += many / 3 + (many < 3)) {
        for (i = 0; i < m->n; i++) mine[i] = part[i] == k;
        one_part(m, mine, liw, iw, &tet, &adj);
        length = length_of(narrays - 1);
        ask(m, iw);
        require(memcmp(iw, m->iw, (size_t)(2 * m->n) * sizeof *iw) == 0,
                "the index after a part");
    }
    ntet = (tess_int)(length / sizeof *tet / 4);
    t2 = ints(4 * ntet);
    a2 = ints(4 * ntet);
    got = 0;
    code = tess_part(m->n, m->p, mine, ntet / 2, &got, t2, a2, liw, iw, m->lrw,
                     m->rw);
    require(code == TESS_MORE && got == ntet / 2, "stopped");
    code = tess_part(m->n, m->p, mine, ntet, &got, t2, a2, liw, iw, m->lrw,
                     m->rw);
    require(code == TESS_OK && got == ntet && memcmp(t2, tet, length) == 0 &&
            memcmp(a2, adj, length) == 0, "a part taken up again");
    ask(m, iw);
    drop(mark);
}

/* An index of length liw of the same points, with an rw of its own, in k. */
static void reindex(const whole *m, tess_int liw, whole *k)
{
    *k = *m;
    k->liw = liw;
    k->iw = ints(liw);
    k->rw = (double *)array((size_t)m->lrw * sizeof(double));
    require(tess_index(m->n, m->p, liw, k->iw, m->lrw, k->rw) == 0,
            "an index of another length");
    require(memcmp(k->iw, m->iw, (size_t)(2 * m->n) * sizeof *k->iw) == 0,
            "its places");
}

/* A new array of that length that begins as an index does. */
static tess_int *begun(const tess_int *a, tess_int used, tess_int length)
{
    tess_int *b = ints(length);

    memcpy(b, a, (size_t)used * sizeof *b);
    return b;
}

static void test_supports(void)
{
    static const struct {
        const char *name;
        int turned;
    } sets[] = {
        { "globe", 0 }, { "rotcube", 0 }, { "rotcubein", 0 }, { "gridrot", 0 },
        { "extruded", 0 }, { "near8", 0 }, { "globe", 2 }, { "cubesurf", 1 }
    };
    char name[80];
    tess_int n = 729, all = 7 * n + 600, old = 2 * n + n / 12 + 7, lo, hi, i;
    tess_int few = 4 * n + n / 12 + 514 + 240; /* the stars of a few points */
    tess_int many = 5, most = (tess_int)(6 * n + 600 + TESS_LIW(n));
    tess_int liw = (tess_int)(6 * n + 600 + TESS_LIW(2 * n / many + 2)), *iw;
    whole other, m, k;
    size_t s;
    int mark, inner, more = 0;

    for (s = 0; s < sizeof sets / sizeof sets[0]; s++) {
        size_t next = (s + 1) % (sizeof sets / sizeof sets[0]);

        faults = 0;
        sprintf(name, "supports: %s%s", sets[s].name,
                sets[s].turned == 2 ? ", twice" : "");
        now = name;
        if (!family(&other, sets[next].name, n, 4, sets[next].turned) ||
            !family(&m, sets[s].name, n, 3, sets[s].turned))
            continue;
        require(m.n == n && other.n == n, "other points");
        require(!SOUGHT || supports(&m, m.iw) > 0, "none in the index");
        mark = narrays;
        /* all of the index */
        ask(&m, begun(m.iw, all, all));
        iw = begun(m.iw, all, liw);
        serve(&m, many, liw, iw);
        drop(mark);
        /* arrays that held another index before */
        reindex(&m, liw, &k);
        require(tess_index(n, other.p, liw, k.iw, m.lrw, k.rw) == 0 &&
                tess_index(n, m.p, liw, k.iw, m.lrw, k.rw) == 0, "again");
        serve(&k, many, liw, k.iw);
        drop(mark);
        /* a number that cannot be */
        for (i = 0; i < 4; i++) {
            tess_int v[4], ntet = 0, *mine = begun(m.iw, n, n);
            double w[4];

            iw = begun(m.iw, all, liw);
            iw[counted(&m, iw)] = i ? 9 << (3 * i - 3) : -1;
            v[0] = TESS_NONE;
            require(tess_query(n, m.p, iw, m.rw, m.p, v, w) == -3 &&
                    tess_part(n, m.p, mine, 0, &ntet, mine, mine, liw, iw,
                              m.lrw, m.rw) == -9, "too many supports");
            drop(mark);
        }
        /* no room for them, or for cylinders */
        if (supports(&m, m.iw) > 0) {
            tess_int ntet = 0, *mine = begun(m.iw, n, n);

            iw = begun(m.iw, few, few);
            require(tess_part(n, m.p, mine, 0, &ntet, mine, mine, few, iw,
                              m.lrw, m.rw) == -8, "a short iw");
            drop(mark);
        }
        /* a part of all points may find more, which stay in its index */
        iw = begun(m.iw, all, most);
        serve(&m, 1, most, iw);
        more += supports(&m, iw) > supports(&m, m.iw);
        require(supports(&m, iw) >= supports(&m, m.iw), "a part loses some");
        serve(&m, many, liw, iw);
        ask(&m, iw);
        drop(mark);
        /* an index without them, and the least length for one with some */
        reindex(&m, old, &k);
        require(supports(&m, k.iw) == 0, "supports in the least index");
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, old, liw));
        drop(mark);
        lo = old;
        hi = 7 * n + 600;
        reindex(&m, hi, &k);
        require(supports(&m, k.iw) == supports(&m, m.iw), "7 n + 600");
        while (SOUGHT && supports(&m, m.iw) > 0 && hi - lo > 1) {
            inner = narrays;
            reindex(&m, (tess_int)(lo + (hi - lo) / 2), &k);
            if (supports(&m, k.iw) > 0) hi = k.liw;
            else lo = k.liw;
            drop(inner);
        }
        drop(mark);
        reindex(&m, lo, &k);
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, lo < all ? lo : all, liw));
        reindex(&m, hi, &k);
        ask(&k, k.iw);
        serve(&k, many, liw, begun(k.iw, hi, liw));
        drop(0);
        test_result(name, faults);
    }
    faults = 0;
    now = "supports: more than the index has";
#ifndef TESS_LIST
    require(!SOUGHT || HH_LIMBS < 88 || more > 0, "no part found any");
#endif
    test_result(now, faults);
}

/* ---- balls ---- */

/* |a - c|^2 against r^2, exactly. */
static int beyond(const double *a, const double *c, double r)
{
    static ex_num x, y, z, sum;
    int low = ex_low(r, EX_NO_LOW), k;

    for (k = 0; k < 3; k++) low = ex_low(c[k], ex_low(a[k], low));
    ex_int(&sum, 0);
    for (k = 0; k < 3; k++) {
        ex_real(&x, a[k], low);
        ex_real(&y, c[k], low);
        ex_sub(&x, &x, &y);
        ex_copy(&y, &x);
        ex_mul(&z, &x, &y);
        ex_add(&sum, &sum, &z);
    }
    ex_real(&x, r, low);
    ex_copy(&y, &x);
    ex_mul(&z, &x, &y);
    return ex_cmp(&sum, &z);
}

static void test_balls(void)
{
    static const tess_int v[4] = { 0, 1, 2, 3 };
    tess_real p[12];
    double a[12], c[4], z[3], u[3], off, thin, size;
    long i, finite = 0, tight = 0, tried = 0;
    int j, k, code, unit;

    faults = 0;
    now = "tess_ball";
    for (i = 0; i < (quick ? 300 : 2000); i++) {
        /* slivers, far off, in any unit */
        off = i % 3 == 0 ? 0.0 : ldexp(1.0, (int)(i % 31));
        thin = ldexp(1.0, -(int)(i % 47));
        unit = (int)(i % 5 - 2) * (sizeof(tess_real) < 8 ? 40 : 450);
        for (k = 0; k < 12; k++) {
            a[k] = k % 3 == 2 && k > 2 && i % 2 ? a[2] : rnd_unit();
            if (k == 11) a[k] = a[2] + thin * rnd_unit();
        }
        if (i % 7 == 0) /* about the origin */
            for (k = 3; k < 12; k++)
                a[k] = k % 3 == k / 3 - 1 ? a[k % 3] : -a[k % 3];
        for (k = 0; k < 12; k++) {
            p[k] = (tess_real)ldexp(a[k] + (i % 7 == 0 ? 0.0 : off), unit);
            a[k] = p[k];
        }
        code = tess_ball(p, v, c);
        require(code == TESS_OK, "its code");
        if (ex_orient(a, a + 3, a + 6, a + 9) == 0) {
            require(c[3] == DBL_MAX, "flat, with a ball");
            continue;
        }
        tried++;
        if (c[3] == DBL_MAX) continue;
        finite++;
        for (j = 0; j < 4; j++)
            require(beyond(a + 3 * j, c, c[3]) <= 0, "a vertex is outside");
        for (j = 0; j < 8; j++) {
            for (k = 0; k < 3; k++) u[k] = rnd_unit() - 0.5;
            size = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
            for (k = 0; k < 3; k++)
                z[k] = c[k] + u[k] / size * c[3] * (1.0 + (j - 2) * 3e-16);
            if (beyond(z, c, c[3]) > 0)
                require(ex_insphere(a, a + 3, a + 6, a + 9, z) < 0,
                        "inside of the ball, but outside of tess_ball's");
            for (k = 0; k < 3; k++)
                z[k] = c[k] + u[k] / size * (c[3] - 1e-13 * (c[3] +
                       fabs(c[0]) + fabs(c[1]) + fabs(c[2])));
            if (beyond(z, c, c[3]) < 0)
                tight += ex_insphere(a, a + 3, a + 6, a + 9, z) > 0;
        }
    }
    if (HH_LIMBS > 10)
        require(finite == tried && tight == 8 * tried, "it is wide");
    test_result(now, faults);
}

/* ---- codes ---- */

static void test_codes(void)
{
    static const double flat[12] = { 0, 0, 1, 1, 0, 1, 0, 1, 1, 5, 5, 1 };
    tess_int v[4], ntet, liw, lrw, *tet, *adj, *mine, *iw, i, big;
    tess_real q[3], *p, bad[3];
    double w[4], *rw, c[4], zero = 0.0;
    whole m;
    int k, code, want;

    faults = 0;
    now = "codes";
    bad[0] = bad[1] = bad[2] = 0;
    bad[1] = (tess_real)(1.0 / zero);
    for (k = 0; k < 3; k++) q[k] = (tess_real)0.25;
    family(&m, "uniform", 30, 1, 0);
    iw = copy(m.iw, m.liw);
    rw = m.rw;
    p = m.p;
    big = m.ntet;
    tet = ints(4 * big);
    adj = ints(4 * big);
    mine = ints(m.n);
    for (i = 0; i < m.n; i++) mine[i] = i < 5;
    require(tess_index(-1, p, m.liw, iw, m.lrw, rw) == -1, "index -1");
    require(tess_index(1, bad, m.liw, iw, m.lrw, rw) == -2, "index -2");
    liw = 2 * m.n + m.n / 12 + 6;
    lrw = 3 * m.n + m.n / 2 + 12;
    require(tess_index(m.n, p, -TESS_INT_MOST - 1, iw, 0, rw) == -3, "index -3");
    for (i = 0; (code = tess_index(m.n, p, i, iw, -1, rw)) == -3; i++)
        ;
    require(code == -5 && i <= liw && i > 2 * m.n, "index -3");
    liw = i;
    for (i = 0; (code = tess_index(m.n, p, liw, iw, i, rw)) == -5; i++)
        ;
    require(code == 0 && i <= lrw && i > 3 * m.n, "index -5");
    lrw = i;
    iw = ints(liw);
    rw = (double *)array((size_t)lrw * sizeof(double));
    require(tess_index(m.n, p, liw, iw, lrw, rw) == 0, "least lengths");
    v[0] = TESS_NONE;
    code = tess_query(m.n, p, iw, rw, q, v, w);
    require(code >= 0 && number(&m, v) >= 0, "a query of the least index");
    iw = m.iw;
    rw = m.rw;
    v[0] = TESS_NONE;
    require(tess_query(-1, p, iw, rw, q, v, w) == -1, "query -1");
    require(tess_query(m.n, p, ints(m.liw), rw, q, v, w) == -3, "query -3");
    require(tess_part(m.n, p, NULL, big, &ntet, tet, adj, m.liw, iw, m.lrw,
                      rw) == -3, "a part of what is not said");
    /* nor are zeros an index, nor what tess leaves where one was: of the same
     * points, or of fewer; nor are integers below 0, or others, beside zeros */
    for (k = 0; k < 6; k++) {
        tess_int *other = begun(iw, m.liw, m.liw), few = k == 2 ? 6 : m.n;
        double *rest = (double *)array((size_t)m.lrw * sizeof *rest);

        memcpy(rest, rw, (size_t)m.lrw * sizeof *rest);
        if (k == 0 || k > 2) {
            for (i = 0; i < m.liw && k != 5; i++)
                other[i] = (tess_int)(k == 4 ? -1 - i % 99 : 0);
            for (i = 0; i < m.lrw && k != 5; i++) rest[i] = 0.0;
            if (k == 3) other[2 * m.n + 4] = (tess_int)(rest[3 * m.n] = 5);
            if (k == 4) other[2 * m.n + 4] = 0;
            if (k == 5) other[other[2 * m.n]] = other[other[2 * m.n + 1]];
        } else
            require(tess(few, p, big, &ntet, tet, adj, m.liw, other, m.lrw,
                         rest) == 0, "tess in an index");
        require(tess_query(m.n, p, other, rest, q, v, w) == -3, "no index");
        ntet = 0;
        require(tess_part(m.n, p, mine, big, &ntet, tet, adj, m.liw, other,
                          m.lrw, rest) == -9 && ntet == 0, "a part of none");
    }
    require(tess_query(m.n, p, iw, rw, bad, v, w) == -5, "query -5");
    for (k = 0; k < 6; k++) {
        for (i = 0; i < 4; i++) v[i] = m.tet[i];
        if (k == 0) v[0] = -2;
        if (k == 1) v[2] = m.n;
        if (k == 2) v[3] = v[1];
        if (k == 3) v[3] = -1;
        if (k == 4) {
            v[3] = v[1];
            v[1] = m.tet[3];
        }
        code = tess_query(m.n, p, iw, rw, q, v, w);
        require(k < 5 ? code == -6 : code >= 0, "query -6");
    }
    ntet = 0;
    want = 0;
    for (k = 0; k < 12; k++) {
        tess_int length = m.liw, lr = m.lrw, n = m.n, most = big;
        tess_int *index = iw;

        ntet = 0;
        if (k == 1) n = want = -1;
        if (k == 2) {
            most = -1;
            want = -4;
        }
        if (k == 3) {
            ntet = big + 1;
            want = -5;
        }
        if (k == 4) {
            ntet = -1;
            want = -5;
        }
        if (k > 4) {
            memcpy(tet, m.tet, (size_t)(4 * big) * sizeof *tet);
            memcpy(adj, m.adj, (size_t)(4 * big) * sizeof *adj);
            ntet = big;
        }
        if (k == 5) {
            tet[7] = m.n;
            want = -6;
        }
        if (k == 6) {
            tet[0] = m.tet[1];
            tet[1] = m.tet[0];
            want = -6;
        }
        if (k == 7) {
            adj[0] = big;
            want = -7;
        }
        if (k == 8) {
            adj[0] = adj[0] == TESS_NONE ? big - 1 : TESS_NONE;
            want = -7;
        }
        if (k == 9) {
            length = 4 * n;
            want = -8;
        }
        if (k == 10) {
            lr = 3 * n;
            want = -10;
        }
        if (k == 11) {
            index = ints(m.liw);
            want = -9;
        }
        i = ntet;
        code = tess_part(n, p, mine, most, &ntet, tet, adj, length, index, lr,
                         rw);
        require(code == want && (ntet == i || k == 0), "part's code");
    }
    /* two tetrahedra on one side of an open facet: in the link of the last
     * one's first vertex, and in the pool */
    for (k = 2; k <= 3; k++) {
        ntet = k;
        for (i = 0; i < 12; i++) adj[i] = TESS_OPEN;
        memcpy(tet, m.tet, 4 * sizeof *tet);
        memcpy(tet + 4, m.tet, 4 * sizeof *tet);
        for (i = 0; i < big; i++)
            if (m.tet[4 * i] != tet[0] && m.tet[4 * i] != tet[1] &&
                m.tet[4 * i] != tet[2] &&
                m.tet[4 * i] != tet[3])
                memcpy(tet + 8, m.tet + 4 * i, 4 * sizeof *tet);
        code = tess_resume(m.n, p, big, &ntet, tet, adj, m.liw, ints(m.liw),
                           m.lrw,
                           (double *)array((size_t)m.lrw * sizeof *rw));
        require(code == -6 && ntet == k, "resume -6");
        for (i = 0; i < 4 * k; i++)
            require(adj[i] == TESS_OPEN && (i > 7 || tet[i] == m.tet[i % 4]),
                    "it writes");
    }
    /* none asked for */
    for (i = 0; i < m.n; i++) mine[i] = 0;
    ntet = 0;
    code = tess_part(m.n, p, mine, 0, &ntet, tet, adj, m.liw, iw, m.lrw, rw);
    require(code == 0 && ntet == 0, "nothing asked for");
    v[0] = -1;
    require(tess_ball(p, v, c) == -2, "ball -2");
    v[0] = v[1] = v[2] = v[3] = 0;
    require(tess_ball(bad, v, c) == -1, "ball -1");
    require(tess_ball(p, v, c) == 0 && c[3] == DBL_MAX, "a point's ball");
    require(tess_edition() == TESS_VERSION, "the version");
    drop(0);
    /* without supports marks need no room, however many points there are */
    family(&m, "uniform", 600, 1, 0);
    mine = ints(m.n);
    tet = ints(4 * m.ntet);
    adj = ints(4 * m.ntet);
    for (i = 0; i < m.n; i++) mine[i] = i < 1;
    for (liw = 4 * m.n;; liw++) {
        ntet = 0;
        code = tess_part(m.n, m.p, mine, m.ntet, &ntet, tet, adj, liw, m.iw,
                         m.lrw, m.rw);
        if (code != -8) break;
    }
    require(code == 0 && ntet > 0 && liw <= 5 * m.n + 512, "the least length");
    drop(0);
    /* what tess_size gives has cylinders, which a part reads */
    family(&m, "ellipsoid", 1000, 1, 0);
    mine = begun(m.iw, m.n, m.n);
    ntet = 0;
    code = tess_part(m.n, m.p, mine, 0, &ntet, mine, mine, m.liw, m.iw,
                     m.lrw - 1, m.rw);
    require(code == -10 && ntet == 0, "a short rw");
    drop(0);
    /* no mesh */
    for (k = 0; k < 5; k++) {
        tess_real f[12];
        tess_int n = k < 2 ? k : k < 4 ? 2 : 4;
        int expected = k < 3 ? TESS_POINT : k == 3 ? TESS_LINE : TESS_PLANE;

        for (i = 0; i < 12; i++) f[i] = (tess_real)flat[k == 2 ? i % 3 : i];
        tess_size(n, 1, &liw, &lrw);
        iw = ints(liw);
        rw = (double *)array((size_t)lrw * sizeof *rw);
        mine = ints(4);
        tet = ints(4);
        adj = ints(4);
        for (i = 0; i < 4; i++) mine[i] = tet[i] = adj[i] = 0;
        ntet = n == 4;
        v[0] = TESS_NONE;
        require(tess_index(n, f, liw, iw, lrw, rw) == expected, "flat");
        require(tess_query(n, f, iw, rw, q, v, w) == expected, "flat query");
        require(tess_part(n, f, mine, 1, &ntet, tet, adj, liw, iw, lrw,
                          rw) == expected && ntet == 0, "flat part");
    }
    drop(0);
    /* the same where supports are sought */
    for (k = 0; k < 3; k++) {
        tess_int n = 600, side = k == 2 ? 25 : n;

        p = (tess_real *)array((size_t)(3 * n) * sizeof *p);
        for (i = 0; i < n; i++) {
            p[3 * i] = (tess_real)(k == 0 ? 7 : i % side);
            p[3 * i + 1] = (tess_real)(k == 0 ? 7 : i / side);
            p[3 * i + 2] = p[3 * i] + p[3 * i + 1];
        }
        tess_size(n, 1, &liw, &lrw);
        iw = ints(liw);
        rw = (double *)array((size_t)lrw * sizeof *rw);
        mine = ints(n);
        for (i = 0; i < n; i++) mine[i] = 1;
        ntet = 0;
        v[0] = TESS_NONE;
        code = k == 0 ? TESS_POINT : k == 1 ? TESS_LINE : TESS_PLANE;
        require(tess_index(n, p, liw, iw, lrw, rw) == code, "many flat");
        require(tess_query(n, p, iw, rw, q, v, w) == code, "many flat query");
        require(tess_part(n, p, mine, 0, &ntet, tet, adj, liw, iw, lrw,
                          rw) == code && ntet == 0, "many flat part");
    }
    drop(0);
    test_result(now, faults);
}

/* An index of points, any of their coordinates subnormal, where that is kept:
 * it is of no use where that is taken for zero; without one it is. */
static void test_flushed(void)
{
    volatile double x = DBL_MIN;
    tess_real tiny = (tess_real)(3.0 * DBL_MIN / 8.0), was, q[3];
    tess_int v[4], ntet, *mine, i;
    double w[4], least;
    whole m;
    int flushes, answer, part, k;

    faults = 0;
    now = "an index where numbers are flushed";
#ifdef TESS_FLOAT
    tiny = (tess_real)(3.0 * FLT_MIN / 8.0);
#endif
    x *= 0.5;
    flushes = x == 0.0;
    for (k = 0; k < 3; k++) q[k] = (tess_real)0.25;
    family(&m, "ellipsoid", 600, 1, 0);
    mine = begun(m.iw, m.n, m.n);
    /* (few limbs do not hold it at all) */
    if (hh_range((double)tiny, 4.0) != 0) flushes = 1;
    for (i = -1; i < 3 * m.n && !flushes && test_state(0, 0, 2); i += 59) {
        test_state(1, 0, 0);
        was = m.p[i < 0 ? 0 : i];
        if (i >= 0) m.p[i] = tiny;
        require(tess_index(m.n, m.p, m.liw, m.iw, m.lrw, m.rw) == 0, "kept");
        /* without it every query would look at all points.  The header is ahead
         * of the boxes of 2 * 16 nodes in tess.c, behind them in tess.f */
        for (least = DBL_MAX, k = 0; k < 3 * m.n; k++)
            if (m.p[k] != 0 && fabs((double)m.p[k]) < least)
                least = fabs((double)m.p[k]);
        require(m.rw[3 * m.n + 4] == least || m.rw[3 * m.n + 190] == least,
                "the header's least number");
        ntet = 0;
        v[0] = TESS_NONE;
        test_state(0, 0x40, 3);
        x = DBL_MIN / 2.0;
        x *= 2.0;
        k = i >= 0 && x != DBL_MIN;
        answer = tess_query(m.n, m.p, m.iw, m.rw, q, v, w);
        part = tess_part(m.n, m.p, mine, 0, &ntet, mine, mine, m.liw, m.iw,
                         m.lrw, m.rw);
        test_state(1, 0, 0);
        require(k ? answer == TESS_RANGE : answer < 2, "a query, flushed");
        require(part == (k ? TESS_RANGE : TESS_MORE), "a part, flushed");
        m.p[i < 0 ? 0 : i] = was;
    }
    drop(0);
    test_result(now, faults);
}

int main(int argc, char **argv)
{
    quick = argc == 2 && strcmp(argv[1], "-quick") == 0;
    if (argc > 1 + quick) test_usage(argv[0], "[-quick]");
    rnd_seed(1);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    test_codes();
    test_flushed();
    test_balls();
    test_resume();
    test_parts();
    test_queries();
    test_supports();
    test_astray();
    return test_end("t_part");
}
