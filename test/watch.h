/* watch.h - what tess.c includes, behind its types, in builds of the tests:
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

static tess_int leafstart(const mesh *m, tess_int leaf);
static void facet(const mesh *m, tess_int code, tess_int *v);
static tess_int owner(const mesh *m, const tess_int *v);
static tess_int hashkey(const tess_int *v);
static tess_int find(const mesh *m, const tess_int *v, tess_int sig);

/* better - returns 1 if z is better than the best point. */
static int better(const mesh *m, const quest *f, tess_int z)
{
    return z != f->v[0] && z != f->v[1] && z != f->v[2] && z != f->best &&
           hh_pside(&m->set, f->v[0], f->v[1], f->v[2], z) > 0 &&
           (f->best == NONE || hh_pball(&m->set, f->v, f->best, z, 2) < 0);
}

/* barren - returns 1 if no point of a node is better than the best point. */
static int barren(const mesh *m, const quest *f, tess_int node)
{
    tess_int i, last = node;

    if (f->into != NULL) return 1;
    for (; node < m->leaves; node *= 2) last = 2 * last + 1;
    i = leafstart(m, node - m->leaves);
    last = leafstart(m, last - m->leaves + 1);
    for (; i < last; i++)
        if (m->link[i] != DONE && better(m, f, i)) return 0;
    return 1;
}

/* listed - returns 1 if a list holds all points better than the best one. */
static int listed(const mesh *m, const quest *f, const list *l)
{
    tess_int z;
    int i;

    for (z = 0; z < m->np; z++) {
        if (m->link[z] == DONE || !better(m, f, z)) continue;
        for (i = 0; i < l->n && l->id[i] != z; i++)
            ;
        if (i == l->n) return 0;
    }
    return 1;
}

/* complete4 - returns 1 if a list has the facet's vertices and the best point. */
static int complete4(const quest *f, const list *l)
{
    int i, n = 0;

    for (i = 0; i < l->n; i++)
        n += l->id[i] == f->v[0] || l->id[i] == f->v[1] ||
             l->id[i] == f->v[2] || l->id[i] == f->best;
    return n == 4;
}

/* within - returns 1 if no place farther than r from the ball's centre along an
 * axis, in the one direction that is tried, is better than the best point. */
static int within(const mesh *m, const quest *f, double r)
{
    const tess_real *p[4];
    tess_real q[3];
    double x;
    int k, way = (int)((f->v[0] + f->v[1] + f->v[2]) % 6);

    for (k = 0; k < 3; k++) {
        x = f->hh[6 + k] + f->plain.c[k];
        if (k == way % 3) {
            r += DBL_EPSILON * (fabs(x) + fabs(f->hh[6 + k]) + r);
            x += way < 3 ? -r : r;
        }
        q[k] = (tess_real)ldexp(x, m->set.e);
        if (ldexp((double)q[k], -m->set.e) != x) return 1;
    }
    for (k = 0; k < 4; k++)
        p[k] = m->set.p + 3 * m->order[k < 3 ? f->v[k] : f->best];
    return hh_orient(p[0], p[1], p[2], q) != 1 ||
           hh_insphere(p[0], p[1], p[2], p[3], q) != 1;
}

/* proven - returns 1 if c, or none, is the apex of the facet v, against all
 * points. */
static int proven(const mesh *m, const tess_int *v, tess_int c)
{
    quest f;
    tess_int z;
    int k;

    for (k = 0; k < 3; k++) f.v[k] = v[k];
    f.best = c;
    for (z = 0; z < m->np; z++)
        if (better(m, &f, z)) return 0;
    return 1;
}

/* empty - returns 1 if no point is in the ball of the tetrahedron v. */
static int empty(const mesh *m, const tess_int *v)
{
    tess_int z;

    for (z = 0; z < m->np; z++)
        if (z != v[0] && z != v[1] && z != v[2] && z != v[3] &&
            hh_pball(&m->set, v, v[3], z, 1) < 0)
            return 0;
    return 1;
}

/* filed - returns 1 if, between two stars, the table holds each open facet
 * whose star is asked for, and no other. */
static int filed(const mesh *m)
{
    tess_int i, v[3], open = 0;

    if (m->np > 500) return 1; /* it takes as long as all else */
    for (i = 0; i < 4 * m->ntet; i++) {
        if (m->adj[i] != TESS_OPEN) continue;
        facet(m, i, v);
        if (owner(m, v) == NONE) continue;
        if (m->pool[ENTRY * find(m, v, hashkey(v))] != i) return 0;
        open++;
    }
    return open == m->nopen;
}
#else
#define HOLDS(fact)
#endif
