/* t_f77.c - the FORTRAN 77 half beside the C half: the same calls must give
 * the same arrays and codes, entry for entry, but for the base: Fortran
 * counts from 1, writes "none" as 0 and "open" as -1.
 *
 * Compiled with the C library and linked with f77/tess.f and f77/hhpred.f,
 * whose names get an underscore from gfortran and f2c. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../points.h"
#include "../../tess.h"

extern void tesswk_(int *n, int *maxtet, int *liw, int *lrw, int *info);
extern void tess_(int *n, double *p, int *maxtet, int *ntet, int *tet,
                  int *adj, int *liw, int *iw, int *lrw, double *rw,
                  int *info);
extern void tessre_(int *n, double *p, int *maxtet, int *ntet, int *tet,
                    int *adj, int *liw, int *iw, int *lrw, double *rw,
                    int *info);
extern void tesslo_(double *p, int *ntet, int *tet, int *adj, double *q,
                    int *t, double *w, int *info);
extern void tessva_(double *p, int *ntet, int *tet, int *adj, int *nv,
                    double *value, int *nq, double *q, int *t, double *out,
                    int *info);
extern void tesshu_(int *ntet, int *tet, int *adj, int *maxfac, int *nfac,
                    int *fac, int *info);
extern void tessch_(int *n, double *p, int *ntet, int *tet, int *adj, int *liw,
                    int *iw, int *bad, int *info);
extern void tessix_(int *n, double *p, int *liw, int *iw, int *lrw, double *rw,
                    int *info);
extern void tessqu_(int *n, double *p, int *iw, double *rw, double *q, int *v,
                    double *w, int *info);
extern void tesspa_(int *n, double *p, int *mine, int *maxtet, int *ntet,
                    int *tet, int *adj, int *liw, int *iw, int *lrw,
                    double *rw, int *info);
extern void tessba_(double *p, int *v, double *c, int *info);
extern int hhorie_(double *a, double *b, double *c, double *d);
extern int hhinsp_(double *a, double *b, double *c, double *d, double *e);

#define MOST 4000
#define MAXTET 60000

static double p[3 * MOST], rw[8 * MOST + 1000];
static int tet[4 * MAXTET], adj[4 * MAXTET], iw[40 * MOST + 2000];
static int ftet[4 * MAXTET], fadj[4 * MAXTET], fiw[40 * MOST + 2000];
static int fac[3 * MAXTET], ffac[3 * MAXTET];
static double frw[8 * MOST + 1000];
static int passed, failed;
static long ranges, unsure; /* codes TESS_RANGE, signs 2 */

static void tell(int good, const char *what, const char *family, int n)
{
    if (good)
        passed++;
    else {
        failed++;
        printf("FAILED  %s: %s %d\n", what, family, n);
    }
}

/* Are ntet tetrahedra and their neighbours the same? */
static int same(int ntet, int fntet)
{
    int i;

    if (ntet != fntet) return 0;
    for (i = 0; i < 4 * ntet; i++)
        if (tet[i] + 1 != ftet[i] || adj[i] + 1 != fadj[i]) return 0;
    return 1;
}

/* A place for a query: between two points, or beyond one of them. */
static void place(int i, int n, double *q)
{
    double f = i % 5 == 4 ? 1.5 + 1e6 * (i % 2) : 0.37;
    int k;

    for (k = 0; k < 3; k++)
        q[k] = f * p[3 * (i * 7 % n) + k] + (1.0 - f) * p[3 * (i * 13 % n) + k];
}

/* Location and hull of the result, and the check of it and of a wrong one. */
static void queries(const char *family, int n, int ntet)
{
    static double value[2 * MOST], q[3 * 40], out[2 * 40], fout[2 * 40];
    double w[4], fw[4];
    int many[40], fmany[40], nv = 2, nq = 40;
    int i, k, t, ft, code, info, good = 1, nfac, fnfac, room, bad, fbad, save;
    int length = 2 * n;

    for (i = 0; i < 2 * n; i++) value[i] = (double)(i % 19);
    for (i = 0; i < nq; i++) {
        place(i, n, q + 3 * i);
        many[i] = i % 3 ? TESS_NONE : i * 11 % ntet;
        fmany[i] = many[i] + 1;
    }
    for (i = 0; i < nq && good; i++) {
        t = i % 2 ? TESS_NONE : i * 11 % ntet;
        ft = t + 1;
        code = tess_locate(p, ntet, tet, adj, q + 3 * i, &t, w);
        tesslo_(p, &ntet, ftet, fadj, q + 3 * i, &ft, fw, &info);
        good = code == info && t + 1 == ft;
        for (k = 0; k < 4; k++)
            if (w[k] - fw[k] > 1e-12 || fw[k] - w[k] > 1e-12) good = 0;
    }
    tell(good, "location", family, n);
    code = tess_values(p, ntet, tet, adj, nv, value, nq, q, many, out);
    tessva_(p, &ntet, ftet, fadj, &nv, value, &nq, q, fmany, fout, &info);
    good = code == info;
    for (i = 0; i < nq && good; i++)
        good = many[i] + 1 == fmany[i] &&
               fabs(out[2 * i] - fout[2 * i]) <= 1e-11 &&
               fabs(out[2 * i + 1] - fout[2 * i + 1]) <= 1e-11;
    tell(good, "values", family, n);
    for (room = MAXTET; room >= 0; room -= MAXTET) {
        code = tess_hull(ntet, tet, adj, room, &nfac, fac);
        tesshu_(&ntet, ftet, fadj, &room, &fnfac, ffac, &info);
        good = code == info && nfac == fnfac;
        for (i = 0; i < 3 * nfac && code == 0 && good; i++)
            good = fac[i] + 1 == ffac[i];
        tell(good, "hull", family, n);
    }
    code = tess_check(n, p, ntet, tet, adj, length, iw, &bad);
    tessch_(&n, p, &ntet, ftet, fadj, &length, fiw, &fbad, &info);
    tell(code == 0 && info == 0 && fbad == 0, "check", family, n);
    save = adj[5 % (4 * ntet)];
    adj[5 % (4 * ntet)] = TESS_OPEN;
    fadj[5 % (4 * ntet)] = TESS_OPEN + 1;
    code = tess_check(n, p, ntet, tet, adj, length, iw, &bad);
    tessch_(&n, p, &ntet, ftet, fadj, &length, fiw, &fbad, &info);
    tell(code != 0 && code == info && fbad == bad + 1, "check of a fault",
         family, n);
    adj[5 % (4 * ntet)] = save;
    fadj[5 % (4 * ntet)] = save + 1;
}

/* The same without the mesh: a part, queries, balls. */
static void alone(const char *family, int n, int liw, int lrw)
{
    static int mine[MOST];
    double q[3], w[4], fw[4];
    int ntet = 0, fntet = 0, maxtet = MAXTET, i, k, v[4], fv[4], good, code;
    int info;

    code = tess_index(n, p, liw, iw, lrw, rw);
    tessix_(&n, p, &liw, fiw, &lrw, frw, &info);
    good = code == info;
    for (i = 0; i < n; i++) {
        if (iw[i] + 1 != fiw[i]) good = 0;
        mine[i] = iw[i] >= n / 8 && iw[i] < n / 4;
    }
    tell(good, "index", family, n);
    if (code != 0) return;
    code = tess_part(n, p, mine, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
    tesspa_(&n, p, mine, &maxtet, &fntet, ftet, fadj, &liw, fiw, &lrw, frw,
            &info);
    tell(code == info && same(ntet, fntet) && ntet > 0, "part", family, n);
    v[0] = TESS_NONE;
    for (i = 0; i < 60 && good; i++) {
        place(i, n, q);
        if (i % 3 == 0) v[0] = TESS_NONE;
        for (k = 0; k < 4; k++) fv[k] = v[k] + 1;
        code = tess_query(n, p, iw, rw, q, v, w);
        tessqu_(&n, p, fiw, frw, q, fv, fw, &info);
        good = code == info;
        for (k = 0; k < 4 && good; k++)
            if (v[k] + 1 != fv[k] || w[k] - fw[k] > 1e-12 ||
                fw[k] - w[k] > 1e-12)
                good = 0;
        code = tess_ball(p, v, w);
        tessba_(p, fv, fw, &info);
        good = good && code == info;
        for (k = 0; k < 4 && good; k++)
            good = fabs(w[k] - fw[k]) <= 1e-14 * fabs(w[3]);
    }
    tell(good, "queries and balls", family, n);
}

static void one(const char *family, int asked)
{
    int n = (int)points_make(family, asked, 1, p), liw, lrw, fliw, flrw, info;
    int ntet, fntet, code, i, good, maxtet = MAXTET, part;

    if (n == 0) return;
    code = tess_size(n, maxtet, &liw, &lrw);
    tesswk_(&n, &maxtet, &fliw, &flrw, &info);
    tell(code == info && liw == fliw && lrw == flrw, "sizes", family, n);
    code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
    tess_(&n, p, &maxtet, &fntet, ftet, fadj, &liw, fiw, &lrw, frw, &info);
    good = code == info && same(ntet, fntet);
    for (i = 0; i < n && good && code >= 0; i++) good = iw[i] + 1 == fiw[i];
    tell(good, "result", family, n);
    ranges += code == TESS_RANGE;
    if (!good || code != 0) return;
    part = ntet / 2;
    memset(ftet, 0, sizeof ftet);
    tess_(&n, p, &part, &fntet, ftet, fadj, &liw, fiw, &lrw, frw, &info);
    good = info == TESS_MORE && fntet == part;
    memset(fiw, 77, sizeof fiw);
    memset(frw, 77, sizeof frw);
    tessre_(&n, p, &maxtet, &fntet, ftet, fadj, &liw, fiw, &lrw, frw, &info);
    tell(good && info == 0 && same(ntet, fntet), "resumed", family, n);
    queries(family, n, ntet);
    alone(family, n, liw, lrw);
}

/* The codes of points that span no space, and of bad arguments. */
static void codes(void)
{
    int n = 5, maxtet = 100, liw = 20000, lrw = 2000, ntet, fntet, info, code, i;
    int kind;
    double zero = 0.0;

    for (kind = 0; kind < 9; kind++) {
        n = 5;
        maxtet = 100;
        liw = 20000;
        lrw = 2000;
        for (i = 0; i < 15; i++) p[i] = (double)(i * i % 7);
        for (i = 0; i < 5; i++) {
            if (kind == 1) p[3 * i + 2] = 1.0;
            if (kind == 2) p[3 * i] = p[3 * i + 1] = p[3 * i + 2] = i;
            if (kind == 3) p[3 * i] = p[3 * i + 1] = p[3 * i + 2] = 4.0;
        }
        if (kind == 4) p[7] = zero / zero;
        if (kind == 5) n = -1;
        if (kind == 6) maxtet = -1;
        if (kind == 7) liw = 10;
        if (kind == 8) lrw = 3;
        code = tess(n, p, maxtet, &ntet, tet, adj, liw, iw, lrw, rw);
        tess_(&n, p, &maxtet, &fntet, ftet, fadj, &liw, fiw, &lrw, frw, &info);
        tell(code == info && (code == -2 ? ntet + 1 == fntet
                                         : same(ntet, fntet)),
             "codes", "kind", kind);
    }
}

/* Exact signs of neighbouring points. */
static void signs(const char *family)
{
    int n = (int)points_make(family, 600, 2, p), i, good = 1, sign;
    double *a;

    for (i = 0; i + 40 < n; i++) {
        a = p + 3 * i;
        sign = hh_insphere(a, a + 3, a + 9, a + 60, a + 120);
        unsure += sign == 2;
        if (hh_orient(a, a + 3, a + 9, a + 60) !=
                hhorie_(a, a + 3, a + 9, a + 60) ||
            sign != hhinsp_(a, a + 3, a + 9, a + 60, a + 120))
            good = 0;
    }
    tell(good, "signs", family, n);
}

int main(void)
{
    static const char *const family[] = {
        "uniform", "ball", "clusters", "decimal3", "twoscale", "aniso",
        "planenoise", "lattice", "lattice01", "latticeshuf", "bcc", "fcc",
        "spherei", "planeone", "planespread", "duplicates", "pairs",
        "farpoint", "offset", "tiny", "huge", "cubesurf", "jitlattice",
        "paraboloid", "lastplaces", "twolines", "moment",
        "wide"
    };
    int i, count = (int)(sizeof family / sizeof *family);

    for (i = 0; i < count; i++) {
        one(family[i], 40);
        one(family[i], i < count - 3 ? 600 : 120);
        signs(family[i]);
    }
    one("uniform", MOST);
    one("lattice", MOST);
    one("lastplaces", 1500);
    codes();
    /* few limbs do not suffice for all that, the default does */
    tell((ranges > 0) == (HH_LIMBS < 10), "TESS_RANGE", "times", (int)ranges);
    tell((unsure > 0) == (HH_LIMBS < 10), "signs 2", "times", (int)unsure);
    printf("fortran: %d passed, %d failed\n", passed, failed);
    return failed != 0;
}
