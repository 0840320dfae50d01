/* watch.h - what tess.c includes, behind its hooks, in builds of the tests:
 * -DTESS_COUNT counts events in tess_count, which the program defines;
 * -DTESS_PROVE tells tess_prove, which the program defines, whether each
 * decision that bounds made holds by the exact predicates. */
#ifdef TESS_COUNT
extern double tess_count[];
#define COUNT(which, n) (tess_count[which] += (double)(n))
#define PEAK(which, n) \
    if ((double)(n) > tess_count[which]) tess_count[which] = (double)(n)
#else
#define COUNT(which, n)
#define PEAK(which, n)
#endif
#define N_FACET 0  /* searches for an apex                  */
#define N_STAR 1   /* ended in a star's list,               */
#define N_BLOCK 2  /* in a block's                          */
#define N_TREE 3   /* in the tree                           */
#define N_NODE 4   /* nodes of the tree looked at           */
#define N_POINT 5  /* candidates looked at one by one       */
#define N_EXACT 6  /* comparisons left to the exact predicates */
#define N_LIST 7   /* points of lists and leaves tested     */
#define N_POOL 8   /* largest number of facets in the pool  */
#define N_HULL 9   /* searches that found nothing           */
#define N_PROBE 10 /* entries probed to find or insert      */
#define N_SIDE 11  /* sides left to the exact predicates    */
#define N_BALL 12  /* balls found by limbs                  */
#define N_TRIAL 13 /* comparisons tried by a few limbs      */
#define N_LEAF 14  /* leaves whose points were tested       */
#define N_NEAR 15  /* ended in a near list                  */
#define N_MADE 16  /* near lists made                       */
#define N_ALL 17

#ifdef TESS_PROVE
extern void tess_prove(int fact);
#define HOLDS(fact) tess_prove(fact)

static tess_int leaf_start(const mesher *m, tess_int leaf);
static void facet_of_code(const mesher *m, tess_int code, tess_int *v);
static tess_int owner(const mesher *m, const tess_int *v);
static tess_int facet_hash(const tess_int *v);
static tess_int find_entry(const mesher *m, const tess_int *v, tess_int sig);

/* better - returns 1 if z is better than the best point. */
static int better(const mesher *m, const search *s, tess_int z)
{
    return z != s->facet[0] && z != s->facet[1] && z != s->facet[2] &&
           z != s->best &&
           hh_porient(&m->points, s->facet[0], s->facet[1], s->facet[2], z) >
               0 &&
           (s->best == NONE ||
            hh_pinsphere(&m->points, s->facet, s->best, z, 2) < 0);
}

/* barren - returns 1 if no point of a node is better than the best point. */
static int barren(const mesher *m, const search *s, tess_int node)
{
    tess_int i, last = node;

    if (COLLECTS(s)) return 1;
    for (; node < m->leaves; node *= 2) last = 2 * last + 1;
    i = leaf_start(m, node - m->leaves);
    last = leaf_start(m, last - m->leaves + 1);
    for (; i < last; i++)
        if (m->edge_from[i] != COMPLETE && better(m, s, i)) return 0;
    return 1;
}

#ifndef TESS_NO_LISTS
/* listed - returns 1 if a list holds all points better than the best one. */
static int listed(const mesher *m, const search *s, const candidate_list *l)
{
    tess_int z;
    int i;

    for (z = 0; z < m->np; z++) {
        if (m->edge_from[z] == COMPLETE || !better(m, s, z)) continue;
        for (i = 0; i < l->n && l->position[i] != z; i++)
            ;
        if (i == l->n) return 0;
    }
    return 1;
}

/* complete4 - returns 1 if a list has the facet's vertices and the best point.
 */
static int complete4(const search *s, const candidate_list *l)
{
    int i, n = 0;

    for (i = 0; i < l->n; i++)
        n += l->position[i] == s->facet[0] || l->position[i] == s->facet[1] ||
             l->position[i] == s->facet[2] || l->position[i] == s->best;
    return n == 4;
}

/* within - returns 1 if no place farther than r from the ball's centre along an
 * axis, in the one direction that is tried, is better than the best point. */
static int within(const mesher *m, const search *s, double r)
{
    const tess_real *p[4];
    tess_real q[3];
    double x;
    int k, way = (int)((s->facet[0] + s->facet[1] + s->facet[2]) % 6);

    for (k = 0; k < 3; k++) {
        x = s->hh[6 + k] + s->filter.c[k];
        if (k == way % 3) {
            r += DBL_EPSILON * (fabs(x) + fabs(s->hh[6 + k]) + r);
            x += way < 3 ? -r : r;
        }
        q[k] = (tess_real)ldexp(x, m->points.exponent);
        if (ldexp((double)q[k], -m->points.exponent) != x) return 1;
    }
    for (k = 0; k < 4; k++)
        p[k] = m->points.p + 3 * m->order[k < 3 ? s->facet[k] : s->best];
    return hh_orient(p[0], p[1], p[2], q) != 1 ||
           hh_insphere(p[0], p[1], p[2], p[3], q) != 1;
}

#endif

/* proven - returns 1 if c, or none, is the apex of the facet v, against all
 * points. */
static int proven(const mesher *m, const tess_int *v, tess_int c)
{
    search s;
    tess_int z;
    int k;

    for (k = 0; k < 3; k++) s.facet[k] = v[k];
    s.best = c;
    for (z = 0; z < m->np; z++)
        if (better(m, &s, z)) return 0;
    return 1;
}

/* empty - returns 1 if no point is in the ball of the tetrahedron v. */
static int empty(const mesher *m, const tess_int *v)
{
    tess_int z;

    for (z = 0; z < m->np; z++)
        if (z != v[0] && z != v[1] && z != v[2] && z != v[3] &&
            hh_pinsphere(&m->points, v, v[3], z, 1) < 0)
            return 0;
    return 1;
}

/* linked - returns 1 if the links of each edge of the link lead to others in
 * it, in pairs: what an edge of before is the next of follows it. */
static int linked(const mesher *m)
{
    tess_int e, f;
    int k;

    for (e = m->oldest_edge; e >= m->newest_edge; e -= EDGE_LEN) {
        if (m->pool[e + EDGE_CODE] == DEAD_EDGE) continue;
        for (k = EDGE_PREV; k <= EDGE_CHAIN; k++) {
            f = m->pool[e + k];
            if (f == NONE) continue;
            if (f < m->newest_edge || f > m->oldest_edge ||
                m->pool[f + EDGE_CODE] == DEAD_EDGE)
                return 0;
            if (k == EDGE_PREV ? m->pool[f + EDGE_NEXT] != e
                               : k == EDGE_NEXT && m->pool[f + EDGE_PREV] != e)
                return 0;
        }
    }
    return 1;
}

/* filed - returns 1 if, between two stars, the table holds each open facet
 * whose star is asked for, and no other. */
static int filed(const mesher *m)
{
    tess_int i, v[3], open = 0;

    if (m->np > 500) return 1; /* it takes as long as all else */
    for (i = 0; i < 4 * m->ntet; i++) {
        if (m->adj[i] != TESS_OPEN) continue;
        facet_of_code(m, i, v);
        if (owner(m, v) == NONE) continue;
        if (m->pool[ENTRY_LEN * find_entry(m, v, facet_hash(v))] != i) return 0;
        open++;
    }
    return open == m->nfacets;
}
#else
#define HOLDS(fact)
#endif
