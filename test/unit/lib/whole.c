/* whole.c - see whole.h. */
#include "whole.h"
#include "../../lib/exact.h"
#include "../../lib/points.h"
#include "guard.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void drop(int many)
{
    require(overrun() == 0, "an array is overrun");
    release(many);
}

tess_int *copy(const tess_int *a, tess_int n)
{
    tess_int *b = ints(n);

    memcpy(b, a, (size_t)n * sizeof *b);
    return b;
}

tess_int *begun(const tess_int *a, tess_int used, tess_int length)
{
    tess_int *b = ints(length);

    memcpy(b, a, (size_t)used * sizeof *b);
    return b;
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

tess_int *as_set(tess_int ntet, const tess_int *tet)
{
    tess_int *s = ints(4 * ntet), t;

    for (t = 0; t < ntet; t++) standard(tet + 4 * t, s + 4 * t);
    qsort(s, (size_t)ntet, 4 * sizeof *s, by_four);
    return s;
}

tess_int number(const whole *m, const tess_int *v)
{
    tess_int s[4];
    const tess_int *f;

    standard(v, s);
    f = (const tess_int *)bsearch(s, m->set, (size_t)m->ntet, 4 * sizeof *s,
                                  by_four);
    return f == NULL ? -1 : (tess_int)((f - m->set) / 4);
}

tess_int linked(tess_int ntet, const tess_int *tet, const tess_int *adj)
{
    tess_int t, u, hull = 0;
    int i, j, k, common;

    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u == TESS_NONE) hull++;
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

void complete(whole *m)
{
    tess_int *iw, *tet, *adj, maxtet = (tess_int)(8 * m->n + 20), i, t;
    double *rw;
    int mark = narrays, k;

    m->code = TESS_MORE;
    while (m->code == TESS_MORE) {
        drop(mark);
        tess_size(m->n, maxtet, &m->liw, &m->lrw);
        /* parts of few neighbours need much pool */
        m->liw = (tess_int)(m->liw + 16 * maxtet);
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

int family(whole *m, const char *name, long n, unsigned long seed,
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
    complete(m);
    if (m->code != 0) drop(0);
    return m->code == 0;
}

long fewer(const char *name, long n)
{
    static const struct {
        const char *family;
        long most;
    } few[] = {
        { "wide", 8 }, { "moment", 80 }, { "helix", 80 }, { "twolines", 80 },
        { "prism", 80 }, { "spherenorm", 120 }, { "spiral", 120 },
        { "spherei", 200 }, { "planeone", 200 }, { "planespread", 200 },
        { "cylinder", 200 }, { "filloutlier", 120 }
    };
    size_t i;

    for (i = 0; i < sizeof few / sizeof few[0]; i++)
        if (strcmp(name, few[i].family) == 0 && n > few[i].most)
            return few[i].most;
    return n;
}

static const whole *sorting;

static int by_x(const void *a, const void *b)
{
    tess_int i = *(const tess_int *)a, j = *(const tess_int *)b;
    double x = sorting->p[3 * i], y = sorting->p[3 * j];

    return x != y ? (x < y ? -1 : 1) : i < j ? -1 : 1;
}

void divide(const whole *m, int kind, tess_int many, tess_int *part)
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

tess_int one_part(const whole *m, const tess_int *mine, tess_int liw,
                  tess_int *iw, tess_int **tet, tess_int **adj)
{
    tess_int *asked = ints(m->n), *met = ints(m->ntet), ntet, need = 0, hull, i, t, j;
    long usual = 6L * m->n + 600;
    int k, code, own;

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
    usual += (long)TESS_LIW(k);
    if (usual > m->liw) usual = m->liw;
    code = tess_part(m->n, m->p, mine, need, &ntet, *tet, *adj,
                     liw > 0 ? liw : (tess_int)usual, iw, m->lrw, m->rw);
    if (code == TESS_POOL && liw == 0)
        code = tess_part(m->n, m->p, mine, need, &ntet, *tet, *adj, m->liw,
                         iw, m->lrw, m->rw);
    require(code == m->code, "the code of a part");
    require(ntet == need, "the number of tetrahedra of a part");
    if (ntet != need) {
        printf("#     code %d, %ld of %ld\n", code, (long)ntet, (long)need);
        exit(1);
    }
    hull = linked(ntet, *tet, *adj);
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
