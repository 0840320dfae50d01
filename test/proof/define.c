/* define.c - the Delaunay tetrahedralization by its definition; see define.h. */
#include "define.h"
#include "exact.h"

#include <stddef.h>
#include <string.h>

#define MOST DEF_MOST
#define FOURS (MOST * (MOST - 1) * (MOST - 2) * (MOST - 3) / 24)

/* The volumes of all quadruples and the squares of the points' distances from
 * the first, each made once. */
static ex_num volume[FOURS], height[MOST];
static int place[MOST][MOST][MOST][MOST];

/* The code for the distinct points d[0..m-1]. */
static int flatness(double (*p)[3], const int *d, int m)
{
    int i, j;

    if (m < 2) return TESS_POINT;
    for (i = 2; i < m; i++)
        if (!ex_collinear(p[d[0]], p[d[1]], p[d[i]])) break;
    if (i >= m) return TESS_LINE;
    for (j = 2; j < m; j++)
        if (ex_orient(p[d[0]], p[d[1]], p[d[i]], p[d[j]]) != 0) return TESS_OK;
    return TESS_PLANE;
}

/* The volumes and heights of the points d[0..m-1]. */
static void measure(double (*p)[3], const int *d, int m)
{
    static ex_num x[3], o;
    int low = EX_NO_LOW, many = 0, i, j, k, l;

    for (i = 0; i < m; i++)
        for (k = 0; k < 3; k++) low = ex_low(p[d[i]][k], low);
    for (i = 0; i < m; i++) {
        for (k = 0; k < 3; k++) {
            ex_real(&x[k], p[d[i]][k], low);
            ex_real(&o, p[d[0]][k], low);
            ex_sub(&x[k], &x[k], &o);
        }
        ex_dot(&height[i], x, x);
    }
    for (i = 0; i < m; i++)
        for (j = i + 1; j < m; j++)
            for (k = j + 1; k < m; k++)
                for (l = k + 1; l < m; l++) {
                    ex_volume(&volume[many], low, p[d[i]], p[d[j]], p[d[k]],
                              p[d[l]]);
                    place[i][j][k][l] = many++;
                }
}

/* The five points d[v[0]] ... d[v[4]]: the sign of the determinant of the
 * rows (x, y, z, height, 1), of lowered heights; vol[k] is the volume of
 * all but v[k]. */
static int five(double (*p)[3], const int *d, const int *v,
                const ex_num *const *vol)
{
    static ex_num s, t;
    const double *q[5];
    int index[5], k;

    ex_int(&s, 0L);
    for (k = 0; k < 5; k++) {
        ex_mul(&t, &height[v[k]], vol[k]);
        if (k % 2 == 0) ex_add(&s, &s, &t);
        else ex_sub(&s, &s, &t);
    }
    if (s.sign != 0) return s.sign;
    for (k = 0; k < 5; k++) {
        index[k] = d[v[k]];
        q[k] = p[index[k]];
    }
    return ex_perturbed(q, index);
}

void define(truth *r, int n, double (*p)[3])
{
    const ex_num *vol[5];
    int d[MOST], v[5], w[4], m = 0, i, j, k, l, s;
    char *is[5];

    memset(r, 0, sizeof *r);
    r->n = n;
    for (i = 0; i < n; i++) {
        for (j = 0; j < i; j++)
            if (p[i][0] == p[j][0] && p[i][1] == p[j][1] && p[i][2] == p[j][2])
                break;
        r->twin[i] = j;
        if (j == i) d[m++] = i;
    }
    r->code = flatness(p, d, m);
    if (r->code != TESS_OK) return;
    measure(p, d, m);
    for (i = 0; i < m; i++)
        for (j = i + 1; j < m; j++)
            for (k = j + 1; k < m; k++)
                for (l = k + 1; l < m; l++)
                    r->is_tet[d[i]][d[j]][d[k]][d[l]] =
                        volume[place[i][j][k][l]].sign != 0;
    /* every five points: which of them is inside the ball of the others */
    for (v[0] = 0; v[0] < m; v[0]++)
    for (v[1] = v[0] + 1; v[1] < m; v[1]++)
    for (v[2] = v[1] + 1; v[2] < m; v[2]++)
    for (v[3] = v[2] + 1; v[3] < m; v[3]++)
    for (v[4] = v[3] + 1; v[4] < m; v[4]++) {
        s = 0;
        for (i = 0; i < 5; i++) {
            for (j = k = 0; j < 5; j++)
                if (j != i) w[k++] = v[j];
            vol[i] = &volume[place[w[0]][w[1]][w[2]][w[3]]];
            is[i] = &r->is_tet[d[w[0]]][d[w[1]]][d[w[2]]][d[w[3]]];
            s += *is[i];
        }
        if (s == 0) continue;
        s = five(p, d, v, vol);
        /* to the last place by 4 - i exchanges; the determinant and that
         * of the rows a-d, b-d, c-d (minus the volume) agree when inside */
        for (i = 0; i < 5; i++)
            if ((i % 2 == 0 ? -s : s) * vol[i]->sign > 0) *is[i] = 0;
    }
    for (i = 0; i < m; i++)
        for (j = i + 1; j < m; j++)
            for (k = j + 1; k < m; k++)
                for (l = k + 1; l < m; l++)
                    r->count += r->is_tet[d[i]][d[j]][d[k]][d[l]];
}

static int has(const tess_int *v, tess_int x)
{
    return v[0] == x || v[1] == x || v[2] == x || v[3] == x;
}

const char *differs(const truth *d, double (*p)[3], int code, tess_int ntet,
                    const tess_int *tet, const tess_int *adj,
                    const tess_int *iw)
{
    static char seen[MOST][MOST][MOST][MOST];
    tess_int t, u, v[4], x, across;
    int i, k;

    if (code != d->code) return "the code";
    for (i = 0; i < d->n; i++)
        if (iw[i] != d->twin[i]) return "iw";
    if (ntet != d->count) return "the number of tetrahedra";
    memset(seen, 0, sizeof seen);
    for (t = 0; t < ntet; t++) {
        for (k = 0; k < 4; k++) {
            v[k] = tet[4 * t + k];
            if (v[k] < 0 || v[k] >= d->n) return "a vertex out of range";
        }
        if (ex_orient(p[v[0]], p[v[1]], p[v[2]], p[v[3]]) != 1)
            return "an orientation";
        for (i = 1; i < 4; i++)
            for (k = i; k > 0 && v[k - 1] > v[k]; k--) {
                x = v[k];
                v[k] = v[k - 1];
                v[k - 1] = x;
            }
        if (!d->is_tet[v[0]][v[1]][v[2]][v[3]]) return "the tetrahedra";
        if (seen[v[0]][v[1]][v[2]][v[3]]) return "a tetrahedron twice";
        seen[v[0]][v[1]][v[2]][v[3]] = 1;
        for (k = 0; k < 4; k++) {
            across = TESS_NONE;
            for (u = 0; u < ntet; u++)
                if (u != t && has(tet + 4 * u, tet[4 * t + (k + 1) % 4]) &&
                    has(tet + 4 * u, tet[4 * t + (k + 2) % 4]) &&
                    has(tet + 4 * u, tet[4 * t + (k + 3) % 4]))
                    across = u;
            if (adj[4 * t + k] != across) return "adj";
        }
    }
    return NULL;
}
