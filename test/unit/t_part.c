/* t_part.c - tests of tess_index and tess_part, and of test/recipes/join.c.
 *
 *     t_part          all tests
 *     t_part -quick   fewer and smaller ones, for slow builds
 *     t_part -brief   half of the sets, for make check
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
 *   codes    bad input, flat input, of these and of tess_query and tess_ball; an
 *            index with a coordinate that is taken for zero by now
 */
#include "lib/whole.h"
#include "../recipes/join.c"
#include "../lib/exact.h"
#include "../lib/points.h"
#include "lib/guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        require(tr_join(total, tet, adj, open, h) == -4, "join: a short table");
        require(tr_join(total, tet, adj, open + 1, h) == 0, "join");
        require(tess_check(m->n, m->p, total, tet, adj, 2 * m->n,
                           ints(2 * m->n), &bad) == 0,
                "tess_check of parts joined");
    }
    all = copy(tet, 4 * total);
    for (i = 0; i < 4 && total > 1; i++) all[i] = all[4 + i];
    for (i = 0; i < 4 * total; i++) adj[i] = TESS_OPEN;
    if (total == 1) return;
    require(tr_join(2, all, adj, 9, h) == 1, "join: a tetrahedron, twice");
    require(tr_join(total, all, adj, open + 1, h) == 1,
            "join: a tetrahedron twice");
}

/* Close by join what is open on both sides, and nothing else.  Returns 1 if
 * there is such a facet. */
static int closed(tess_int ntet, const tess_int *tet, tess_int *adj)
{
    int mark = narrays, any = 0;
    tess_int *was = copy(adj, 4 * ntet), *h = ints(8 * ntet + 1), i;

    require(tr_join(ntet, tet, adj, 8 * ntet + 1, h) == 0, "join of parts");
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
        u = total + tr_keep(ntet, tet, mine, becomes);
        if (u <= m->ntet) tr_append(ntet, tet, adj, becomes, total, utet, uadj);
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
static void test_parts(void)
{
    static const tess_int many[] = { 2, 5, 33, 1024 };
    char name[80];
    whole m;
    int f, kind, turned;
    size_t i;

    for (f = 0; points_name(f) != NULL; f++)
        for (turned = 0; turned < 2; turned++) {
            long n = fewer(points_name(f), quick ? 40 : 70);

            if (quick > 1 && turned != f % 2) continue;
            faults = 0;
            sprintf(name, "parts: %s%s", points_name(f),
                    turned ? ", turned" : "");
            now = name;
            if (!family(&m, points_name(f), n, 3, turned)) continue;
            for (kind = 0; kind < 3; kind++)
                for (i = 0; i < 4; i++) {
                    int mark = narrays;

                    /* the others of other families */
                    if (quick && (i + (size_t)(kind + f + 2 * turned)) % 4 > 0)
                        continue;
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
/* ---- codes ---- */

static void test_codes(void)
{
    static const double flat[12] = { 0, 0, 1, 1, 0, 1, 0, 1, 1, 5, 5, 1 };
    tess_int v[4], ntet, liw, lrw, *tet, *adj, *mine, *iw, i, big;
    tess_real q[3], *p, bad[3], kept;
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
    /* points that have become none since */
    kept = p[0];
    p[0] = bad[1];
    require(tess_query(m.n, p, iw, rw, q, v, w) == -3, "query, no point");
    ntet = 0;
    require(tess_part(m.n, p, mine, big, &ntet, tet, adj, m.liw, iw, m.lrw,
                      rw) == -9, "part, no point");
    p[0] = kept;
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
    /* without surfaces marks need no room, however many points there are */
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
    /* the same where surfaces are sought */
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
    int flushes = test_flushes(), answer, part, k;

    faults = 0;
    now = "an index where numbers are flushed";
#ifdef TESS_FLOAT
    tiny = (tess_real)(3.0 * FLT_MIN / 8.0);
#endif
    for (k = 0; k < 3; k++) q[k] = (tess_real)0.25;
    family(&m, "ellipsoid", 600, 1, 0);
    mine = begun(m.iw, m.n, m.n);
    /* (few limbs do not hold it at all) */
    if (!hh_fits((double)tiny, 4.0)) flushes = 1;
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
    quick = test_quick(argc, argv);
    rnd_seed(1);
    test_codes();
    test_flushed();
    test_resume();
    test_parts();
    return test_end();
}
