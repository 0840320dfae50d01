/* t_join.c - tests of test/examples/join.c: parts of each family, joined, are
 * the tetrahedra of tess, and tess_check proves the result; what is no mesh is
 * found.
 *
 *   cc -I. -o t_join test/unit/t_join.c test/points.c tess.c hhpred.c -lm
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../examples/join.c"
#include "../points.h"

#define N 700

static long passed, failed;

static void test(const char *name, const char *what, long parts, int good)
{
    if (good) {
        passed++;
        return;
    }
    failed++;
    printf("%s, %ld parts: %s\n", name, parts, what);
}

static void *take(tess_int n, size_t size)
{
    void *space = malloc((size_t)n * size + 1);

    if (!space) exit(2);
    return space;
}

static tess_int *ints(tess_int n)
{
    return (tess_int *)take(n, sizeof(tess_int));
}

static int by_four(const void *a, const void *b)
{
    const tess_int *v = (const tess_int *)a, *w = (const tess_int *)b;
    int k = 0;

    while (k < 3 && v[k] == w[k]) k++;
    return v[k] < w[k] ? -1 : v[k] > w[k];
}

/* The tetrahedra as a set: their vertices in order, then they. */
static tess_int *set_of(tess_int ntet, const tess_int *tet)
{
    tess_int *s = ints(4 * ntet), x, t;
    int k, j;

    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            x = tet[4 * t + k];
            for (j = k; j > 0 && s[4 * t + j - 1] > x; j--)
                s[4 * t + j] = s[4 * t + j - 1];
            s[4 * t + j] = x;
        }
    qsort(s, (size_t)ntet, 4 * sizeof *s, by_four);
    return s;
}

/* One number of parts, each with no more workspace than join.c says. */
static void parts(const char *name, tess_int n, const double *p, tess_int many,
                  tess_int mesh, const tess_int *wanted)
{
    tess_int *index, *iw, *mine, *tet, *adj, *becomes, *all, *alladj, *s, bad;
    tess_int liw, lrw, m, i, k, ntet, kept, total = 0, fixed;
    double *rw;
    int code;

    tess_size(n, mesh, &liw, &lrw);
    rw = (double *)take(lrw, sizeof *rw);
    index = ints(liw);
    code = tess_index(n, p, liw, index, lrw, rw);
    fixed = 2 * n + n / 12 + 7;
    mine = ints(n);
    tet = ints(4 * mesh);
    adj = ints(4 * mesh);
    becomes = ints(mesh);
    all = ints(4 * mesh);
    alladj = ints(4 * mesh);
    for (k = 0; k < many && code == 0; k++) {
        for (i = m = 0; i < n; i++)
            m += mine[i] = (tess_int)((double)index[i] * (double)many /
                                      (double)n) == k;
        liw = 4 * n + n / 6 + 514 + (tess_int)TESS_LIW(m);
        iw = ints(liw);
        memcpy(iw, index, (size_t)fixed * sizeof *iw);
        ntet = 0;
        code = tess_part(n, p, mine, mesh, &ntet, tet, adj, liw, iw, lrw, rw);
        if (code == TESS_POOL) {
            /* a vertex of very many neighbours */
            liw += 40 * mesh;
            iw = (tess_int *)realloc(iw, (size_t)liw * sizeof *iw);
            if (!iw) exit(2);
            code = tess_part(n, p, mine, mesh, &ntet, tet, adj, liw, iw, lrw,
                             rw);
        }
        free(iw);
        kept = keep(ntet, tet, mine, becomes);
        if (total + kept <= mesh)
            append(ntet, tet, adj, becomes, total, all, alladj);
        total += kept;
    }
    test(name, "the parts have other tetrahedra", (long)many,
         code == 0 && total == mesh);
    if (code == 0 && total == mesh) {
        s = set_of(total, all);
        test(name, "not the set of tess", (long)many,
             memcmp(s, wanted, 4 * (size_t)mesh * sizeof *s) == 0);
        free(s);
        iw = ints(4 * mesh + 2 * n + 1);
        for (i = k = 0; i < 4 * mesh; i++) k += alladj[i] == TESS_OPEN;
        test(name, "a table that is too small", (long)many,
             join(total, all, alladj, k, iw) == -4);
        test(name, "join", (long)many,
             join(total, all, alladj, k + 1, iw) == 0);
        test(name, "tess_check", (long)many,
             tess_check(n, p, total, all, alladj, 2 * n, iw, &bad) == 0);
        /* one twice, all facets open */
        for (i = 0; i < 4 * total; i++) alladj[i] = TESS_OPEN;
        test(name, "join of nothing but open facets", (long)many,
             join(total, all, alladj, 4 * total + 1, iw) == 0 &&
                 tess_check(n, p, total, all, alladj, 2 * n, iw, &bad) == 0);
        for (i = 0; i < 4 * total; i++) alladj[i] = TESS_OPEN;
        for (i = 0; i < 4 && total > 1; i++) all[i] = all[4 + i];
        test(name, "a tetrahedron twice", (long)many,
             total == 1 || join(total, all, alladj, 4 * total + 1, iw) == 1);
        free(iw);
    }
    free(index);
    free(rw);
    free(mine);
    free(tet);
    free(adj);
    free(becomes);
    free(all);
    free(alladj);
}

int main(void)
{
    static const tess_int many[4] = {1, 2, 5, 32};
    tess_int n, ntet, maxtet, liw, lrw, *tet, *adj, *iw, *wanted;
    double *p, *rw;
    long asked;
    int f, k, code;

    p = (double *)take(3 * N, sizeof *p);
    for (f = 0; points_name(f); f++) {
        asked = strcmp(points_name(f), "wide") == 0 ? 20
                : strcmp(points_name(f), "helix") == 0 ||
                  strcmp(points_name(f), "moment") == 0 ||
                  strcmp(points_name(f), "twolines") == 0 ||
                  strcmp(points_name(f), "prism") == 0 ? 100 : N;
        n = (tess_int)points_make(points_name(f), asked, 1, p);
        if (n == 0) continue;
        maxtet = n * n / 2 + 8 * n;
        if (tess_size(n, maxtet, &liw, &lrw) != 0) return 2;
        tet = ints(4 * maxtet);
        adj = ints(4 * maxtet);
        iw = ints(liw);
        rw = (double *)take(lrw, sizeof *rw);
        code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
        if (code == TESS_POOL) {
            liw += 40 * maxtet;
            free(iw);
            iw = ints(liw);
            code = tess_resume(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
        }
        test(points_name(f), "tess", 0L, code == 0);
        wanted = set_of(ntet, tet);
        free(tet);
        free(adj);
        free(iw);
        free(rw);
        for (k = 0; k < 4 && code == 0; k++)
            parts(points_name(f), n, p, many[k], ntet, wanted);
        free(wanted);
    }
    free(p);
    printf("t_join: %ld passed, %ld failed\n", passed, failed);
    return failed > 0;
}
