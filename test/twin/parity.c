/* parity.c - one set of inputs for the library, its answers as text.
 *
 * It makes points by integer arithmetic and writes what the calls give, counting
 * from 1: small results in full, large ones as checksums.  Linked with shim.c
 * and the FORTRAN half it must write the same.  Each section begins with a line
 * "= ..."; parity.txt has their sums (sums.sh).  See check.sh for what is
 * compared with what; the programs of test/unit for bad arguments and results.
 *
 *     parity [N]   all of it, or only the sets of at most N points, for machines
 *                  that are simulated
 *
 * Compiled with PROVE it proves every answer by exact.c besides, and ends
 * with code 1 when one is wrong; see prove.h.
 *
 * Kinds of points:
 *    1  general     pseudo-random multiples of 2^-31
 *    2  lattice     integers, in order
 *    3  shuffled    the same in another order
 *    4  sphere      integers with x^2 + y^2 + z^2 = 2, or 941
 *    5  moment      (t, t^2, t^3)
 *    6  duplicates  many in one place; zeros of both signs
 *    7  clusters    integers in four planes
 *    8  plane + 1   a grid in a plane and one point off it
 *    9  jitter      the lattice moved by up to 2^-40
 *   10  wide        exponents from -300 to 300
 *   11  plane       12  line        13  point
 *   14  cube        its corners, its centre, centres of faces
 *   15  last places integers times 2^-50 beside (1,1,1)
 */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include "../../tess.h"
#include "../lib/prove.h"

#define MOST 1000
#define MAXTET 12000
#define LENGTH 60000

/* line - write a label and k numbers, at most 8. */
static void line(const char *label, int k, const tess_int *a)
{
    int i;

    printf("%-16s", label);
    for (i = 0; i < k; i++) printf("%9ld", (long)a[i]);
    printf("\n");
}

/* two - write a label and two numbers. */
static void two(const char *label, tess_int i, tess_int j)
{
    tess_int a[2];

    a[0] = i;
    a[1] = j;
    line(label, 2, a);
}

/* chksum - a checksum of k indices, counted from 1. */
static tess_int chksum(tess_int k, const tess_int *a)
{
    long s = 1;
    tess_int i;

    for (i = 0; i < k; i++) s = (s * 1021 + a[i] + 3) % 2097143;
    return (tess_int)s;
}

/* many - write a label and k indices of an array, counted from 1: all of up to
 * 200, eight a line; else their checksum. */
static void many(const char *label, tess_int k, const tess_int *a)
{
    tess_int b[8], i;
    int j = 0;

    if (k > 200) {
        two(label, k, chksum(k, a));
        return;
    }
    for (i = 0; i < k; i++) {
        b[j++] = a[i] + 1;
        if (j == 8 || i == k - 1) {
            line(label, j, b);
            j = 0;
        }
    }
}

/* differ - how many entries of the k numbers a and b differ. */
static tess_int differ(tess_int k, const tess_int *a, const tess_int *b)
{
    tess_int i, n = 0;

    for (i = 0; i < k; i++) n += a[i] != b[i];
    return n;
}

/* near - the whole number nearest to 65536 x; 9999999 or minus that for a
 * large x. */
static tess_int near(double x)
{
    if (fabs(x) >= 100.0) return x < 0.0 ? -9999999 : 9999999;
    x *= 65536.0;
    return x < 0.0 ? -(tess_int)(0.5 - x) : (tess_int)(x + 0.5);
}

/* random - the next seed, 1 ... 2^31 - 2 (Park and Miller's minimal standard,
 * by Schrage's method). */
static void random(long *seed)
{
    *seed = 16807 * (*seed % 127773) - 2836 * (*seed / 127773);
    if (*seed <= 0) *seed += 2147483647;
}

/* incube - (x, y, z) is number i = 0, 1, ... of a cube of m^3. */
static void incube(long i, long m, double *x)
{
    x[0] = (double)(i % m);
    x[1] = (double)(i / m % m);
    x[2] = (double)(i / (m * m));
}

/* sphere - the points of kind 4. */
static void sphere(tess_int n, double *p)
{
    tess_int i = 0;
    int square = n > 12 ? 941 : 2, x, y, z;

    for (x = -30; x <= 30; x++)
        for (y = -30; y <= 30; y++)
            for (z = -30; z <= 30; z++)
                if (x * x + y * y + z * z == square && i < n) {
                    p[3 * i] = x;
                    p[3 * i + 1] = y;
                    p[3 * i + 2] = z;
                    i++;
                }
}

/* mkpnts - n points of a kind. */
static void mkpnts(int kind, tess_int n, double *p)
{
    double *q, power, tiny = 1.0;
    long seed = 1000 * kind + n + 1, i, j, m = 1, u, v;
    int k;

    while (m * m * m < n) m++;
    for (j = 0; j < 40; j++) tiny *= 0.5;
    if (kind == 4) sphere(n, p);
    for (i = 1; i <= n; i++) {
        q = p + 3 * (i - 1);
        if (kind == 2 || kind == 9) incube(i - 1, m, q);
        if (kind == 3) incube(7 * i % (m * m * m), m, q);
        random(&seed);
        u = seed / 1000 % 16;
        random(&seed);
        v = seed / 1000 % 16;
        for (k = 0; k < 3; k++) {
            random(&seed);
            if (kind == 1) q[k] = (double)seed / 2147483648.0;
            if (kind == 5)
                q[k] = (double)(k == 0 ? i : k == 1 ? i * i : i * i * i);
            if (kind == 6) q[k] = -(double)(seed / 1000 % (m - 1));
            if (kind == 6 && v > 7) q[k] = fabs(q[k]);
            if (kind == 9) q[k] += (double)(seed / 1000 % 3 - 1) * tiny;
            if (kind == 10) {
                power = seed / 1000 % 2 == 1 ? 0.5 : 2.0;
                q[k] = (double)seed;
                for (j = 0; j < seed % 300; j++) q[k] *= power;
            }
            if (kind == 12) q[k] = (double)(i * (k + 1));
            if (kind == 13) q[k] = k + 1;
            if (kind == 15)
                q[k] = 1.0 + (double)(seed / 1000 % 16) * tiny / 1024.0;
        }
        if (kind == 7) {
            q[0] = (double)u;
            q[1] = (double)v;
            j = i % 4;
            if (j <= 1) q[2] = (double)(16 * j);
            if (j == 2) q[2] = (double)(u + v);
            if (j == 3) q[2] = (double)(2 * u - v);
        } else if (kind == 8) {
            q[0] = (double)(i % 20);
            q[1] = (double)(i / 20);
            q[2] = i == n ? 1.0 : 0.0;
        } else if (kind == 11) {
            q[0] = (double)u;
            q[1] = (double)v;
            q[2] = (double)(3 * u - 2 * v + 1);
        } else if (kind == 14) {
            if (i <= 8) incube(i - 1, 2, q);
            if (i > 8) q[0] = q[1] = q[2] = 0.5;
            if (i > 9) q[i % 3] = (double)(i % 2);
        }
    }
}

/* pieces - the same result in steps: arrays too short, the least workspace,
 * and once more when all is done. */
static void pieces(tess_int n, const double *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj, tess_int liw,
                   tess_int *iw, tess_int lrw, double *rw)
{
    static tess_int tet2[4 * MAXTET], adj2[4 * MAXTET];
    tess_int a[5], nt, step = ntet / 3, l, k;
    int code;

    code = tess(n, p, step, &nt, tet2, adj2, liw, iw, lrw, rw);
    for (;;) {
        two("in part", code, nt);
        two("sums", chksum(4 * nt, tet2), chksum(4 * nt, adj2));
        if (code != TESS_MORE) break;
        step = step + ntet / 3 + 1 < ntet ? step + ntet / 3 + 1 : ntet;
        code = tess_resume(n, p, step, &nt, tet2, adj2, liw, iw, lrw, rw);
    }
    two("different", differ(4 * ntet, tet, tet2), differ(4 * ntet, adj, adj2));
    /* the least lengths */
    l = 4 * n;
    while ((code = tess(n, p, 0, &nt, tet2, adj2, l, iw, lrw, rw)) == -7) l++;
    two("least LIW", code, l);
    k = 3 * n;
    while ((code = tess(n, p, 0, &nt, tet2, adj2, l, iw, k, rw)) == -9) k++;
    two("least LRW", code, k);
    code = tess(n, p, ntet, &nt, tet2, adj2, l, iw, k, rw);
    a[0] = code;
    a[1] = nt;
    a[2] = 0;
    while (code == TESS_POOL) {
        l += l / 4;
        code = tess_resume(n, p, ntet, &nt, tet2, adj2, l, iw, k, rw);
        a[2]++;
    }
    a[3] = code;
    a[4] = nt;
    line("short of LIW", 5, a);
    code = tess_resume(n, p, ntet, &nt, tet2, adj2, l, iw, k, rw);
    two("once more", code, nt);
    two("different", differ(4 * ntet, tet, tet2), differ(4 * ntet, adj, adj2));
}

/* query - a point for a query: of the set, halfway or in the middle between
 * some, or outside. */
static void query(tess_int i, tess_int n, const double *p, double *q)
{
    double a, b, c, d;
    int k;

    for (k = 0; k < 3; k++) {
        a = p[3 * (5 * i % n) + k];
        b = p[3 * (7 * i % n) + k];
        c = p[3 * (11 * i % n) + k];
        d = p[3 * (13 * i % n) + k];
        q[k] = a;
        if (i % 4 == 1) q[k] = 0.5 * a + 0.5 * b;
        if (i % 4 == 2) q[k] = (0.25 * a + 0.25 * b) + (0.25 * c + 0.25 * d);
        if (i % 8 == 7) q[k] = 2.0 * a - b;
    }
}

/* places - location of points of the set, of points halfway and in the middle
 * between them, and outside. */
static void places(int kind, tess_int n, const double *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj)
{
    tess_int where[6], t, i;
    double q[3], w[4];
    int k, code;

    for (i = 1; i <= 16; i++) {
        query(i, n, p, q);
        /* sums that are rounded, and weights in slivers, may differ */
        if (kind == 10 && i % 4 != 0) continue;
        t = TESS_NONE;
        if (i > 8) t = 17 * i % ntet;
        code = tess_locate(p, ntet, tet, adj, q, &t, w);
        prove_place(n, p, tet, adj, q, t, w, code);
        where[0] = code;
        where[1] = t + 1;
        for (k = 0; k < 4; k++) where[2 + k] = near(w[k]);
        line("TESSLO", kind == 9 ? 2 : 6, where);
    }
}

/* tell - write a code beside the one that the interface promises. */
static void tell(const char *label, tess_int code, tess_int wanted,
                 tess_int also)
{
    two(label, code, also);
    if (code != wanted) two("WRONG", code, wanted);
}

/* alone - stars and queries without the mesh. */
static void alone(int kind, tess_int n, const double *p, tess_int want,
                  tess_int ntet, const tess_int *tet, tess_int liw,
                  tess_int *iw, tess_int lrw, double *rw)
{
    static tess_int tet2[4 * MAXTET], adj2[4 * MAXTET], mine[MOST];
    tess_int a[8], v[4], i, nt = 0, asked = 0;
    double c[4], q[3], w[4];
    int code, k;

    code = tess_index(n, p, liw, iw, lrw, rw);
    tell("TESSIX", code, want, n);
    many("places", n, iw);
    for (i = 0; i < n; i++) mine[i] = (iw[i] + 1) % 3 == 0;
    for (i = 0; i < ntet; i++)
        asked += mine[tet[4 * i]] || mine[tet[4 * i + 1]] ||
                 mine[tet[4 * i + 2]] || mine[tet[4 * i + 3]];
    code = tess_part(n, p, mine, asked / 2, &nt, tet2, adj2, liw, iw, lrw, rw);
    two("TESSPA, half", code, nt);
    code = tess_part(n, p, mine, MAXTET, &nt, tet2, adj2, liw, iw, lrw, rw);
    tell("TESSPA", nt, asked, code);
    many("TET", 4 * nt, tet2);
    many("ADJ", 4 * nt, adj2);
    code = tess_resume(n, p, MAXTET, &nt, tet2, adj2, liw, iw, lrw, rw);
    /* a facet without a vertex asked for may be open twice */
    tell("TESSRE of it", nt, code == -6 ? asked : ntet, code);
    many("TET", 4 * nt, tet2);
    tess_index(n, p, liw, iw, lrw, rw);
    v[0] = TESS_NONE;
    for (i = 1; i <= 16 && n > 0; i++) {
        if (kind == 10 && i % 4 != 0) continue;
        query(i, n, p, q);
        if (i < 9) v[0] = TESS_NONE;
        code = tess_query(n, p, iw, rw, q, v, w);
        if (want != 0) {
            tell("TESSQU", code, want, i);
            continue;
        }
        prove_place(n, p, v, NULL, q, 0, w, code);
        many("TESSQU", 4, v);
        a[0] = code;
        for (k = 0; k < 4; k++) a[1 + k] = near(w[k]);
        line("TESSQU", kind == 9 ? 1 : 5, a);
    }
    for (i = 0; i < ntet && i < 8 && kind != 10; i++) {
        a[0] = tess_ball(p, tet + 4 * i, c);
        for (k = 0; k < 4; k++) a[1 + k] = near(c[k]);
        line("TESSBA", 5, a);
    }
}

/* beyond - queries outside, with the mesh and without: near, far, far away
 * and above a point. */
static void beyond(int kind, tess_int n, const double *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj, tess_int liw,
                   tess_int *iw, tess_int lrw, double *rw)
{
    tess_int a[8], v[4], i, t;
    double c, d, q[3], w[4];
    int k, code, code2;

    tess_index(n, p, liw, iw, lrw, rw);
    v[0] = TESS_NONE;
    for (i = 1; i <= 12; i++) {
        for (k = 0; k < 3; k++) {
            c = p[3 * (5 * i % n) + k];
            d = p[3 * (7 * i % n) + k];
            if (i % 4 == 0) q[k] = 2.0 * c - d;
            if (i % 4 == 1) q[k] = 1024.0 * (c - d);
            if (i % 4 == 2) q[k] = 1099511627776.0 * (c - d);
            /* differences of numbers that are wide apart are rounded */
            if (kind == 10) q[k] = 2.0 * c;
            if (i % 4 == 3) q[k] = k == i % 3 ? 1000.0 : c;
        }
        t = TESS_NONE;
        if (i > 6) t = 17 * i % ntet;
        code = tess_locate(p, ntet, tet, adj, q, &t, w);
        prove_place(n, p, tet, adj, q, t, w, code);
        a[0] = code;
        a[1] = t + 1;
        for (k = 0; k < 4; k++) a[2 + k] = near(w[k]);
        line("TESSLO", kind == 9 && code == 0 ? 2 : 6, a);
        if (i < 7) v[0] = TESS_NONE;
        code2 = tess_query(n, p, iw, rw, q, v, w);
        prove_place(n, p, v, NULL, q, 0, w, code2);
        for (k = 0; k < 4; k++) {
            a[k] = v[k] + 1;
            a[4 + k] = near(w[k]);
        }
        line("TESSQU", kind == 9 && code == 0 ? 4 : 8, a);
        if (code2 != code) two("WRONG", code2, code);
    }
}

/* values - two values at places on a line that begins and ends outside: in
 * order, from what was found, in another order; one at a time. */
static void values(tess_int n, const double *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj)
{
    enum { NQ = 24 };
    static double value[2 * MOST];
    tess_int t[NQ], t2[NQ], a[2 * NQ], b[2 * NQ], i, j, m, rows;
    tess_int last;
    double c, d, out[2 * NQ], q[3 * NQ], pair[2], w[4];
    int k, code, code2;

    for (i = 0; i < n; i++) {
        value[2 * i] = (double)(i % 17);
        value[2 * i + 1] = p[3 * i];
    }
    for (i = 0; i < NQ; i++) t[i] = TESS_NONE;
    for (m = 0; m < 3; m++) {
        for (i = 0; i < NQ; i++) {
            j = m == 2 ? 7 * i % NQ : i;
            t2[i] = m == 2 ? TESS_NONE : t[i];
            for (k = 0; k < 3; k++) {
                c = p[3 * (n / 3) + k];
                d = p[3 * (n - 1) + k];
                q[3 * i + k] = c + (double)(j - 4) * (d - c) / 16.0;
            }
        }
        code = tess_values(p, ntet, tet, adj, 2, value, NQ, q, t2, out);
        for (i = 0; i < NQ; i++) {
            j = m == 2 ? 7 * i % NQ : i;
            b[2 * j] = near(out[2 * i]) - 1;
            b[2 * j + 1] = near(out[2 * i + 1]) - 1;
        }
        if (m == 0) {
            /* less 1, as many counts from 1 */
            many("TESSVA", 2 * NQ, b);
            for (i = 0; i < 2 * NQ; i++) a[i] = b[i];
            for (i = 0; i < NQ; i++) t[i] = t2[i];
            /* one at a time: each with its code, and as before */
            last = TESS_NONE;
            for (i = 0; i < NQ; i++) {
                code2 = tess_values(p, ntet, tet, adj, 2, value, 1, q + 3 * i,
                                    &last, pair);
                j = last < 0 ? -2 - last : last;
                if (last != t[i] || (last < 0) != code2 ||
                    pair[0] != out[2 * i] || pair[1] != out[2 * i + 1] ||
                    tess_locate(p, ntet, tet, adj, q + 3 * i, &j, w) !=
                        code2 || j != (last < 0 ? -2 - last : last))
                    two("WRONG", i + 1, code2);
            }
        }
        two("TESSVA", code, chksum(NQ, t2));
        rows = differ(2 * NQ, a, b);
        if (rows > 0) two("WRONG", rows, 0);
    }
}

/* solve - n points of a kind, tetrahedralized. */
static void solve(int kind, tess_int n)
{
    static const char *const name[] = {
        "= general", "= lattice", "= shuffled", "= sphere", "= moment",
        "= duplicates", "= clusters", "= plane + 1", "= jitter", "= wide",
        "= plane", "= line", "= point", "= cube", "= last places"
    };
    static double p[3 * MOST], rw[8 * MOST];
    static tess_int tet[4 * MAXTET], adj[4 * MAXTET], fac[3 * MAXTET];
    static tess_int iw[LENGTH];
    tess_int bad, codes[8], liw, lrw, nfac, ntet, t;
    int code, k;

    mkpnts(kind, n, p);
    two(name[kind - 1], kind, n);
    tess_size(n, MAXTET, &liw, &lrw);
    two("TESSWK", liw, lrw);
    code = tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, rw);
    two("TESS", code, ntet);
    many("stand for", n, iw);
    prove_result(n, p, code, ntet, tet, adj, iw);
    alone(kind, n, p, code, ntet, tet, LENGTH, iw, lrw, rw);
    if (code != 0) return;
    if (ntet <= 50) {
        for (t = 0; t < ntet; t++) {
            for (k = 0; k < 4; k++) {
                codes[k] = tet[4 * t + k] + 1;
                codes[4 + k] = adj[4 * t + k] + 1;
            }
            line("tetrahedron", 8, codes);
        }
    } else {
        many("TET", 4 * ntet, tet);
        many("ADJ", 4 * ntet, adj);
    }
    code = tess_hull(ntet, tet, adj, MAXTET, &nfac, fac);
    two("TESSHU", code, nfac);
    many("FAC", 3 * nfac, fac);
    prove_hull(ntet, tet, adj, nfac, fac);
    code = tess_check(n, p, ntet, tet, adj, 2 * n, iw, &bad);
    two("TESSCH", code, bad + 1);
    pieces(n, p, ntet, tet, adj, liw, iw, lrw, rw);
    places(kind, n, p, ntet, tet, adj);
    beyond(kind, n, p, ntet, tet, adj, LENGTH, iw, lrw, rw);
    /* sums that are rounded, and values in slivers, may differ */
    if (kind != 9 && kind != 10) values(n, p, ntet, tet, adj);
}

/* choose - five points near number i. */
static void choose(long i, long n, const double *p, const double **v)
{
    long k;

    for (k = 1; k <= 5; k++) v[k - 1] = p + 3 * (((k * k + 1) * i + k) % n);
}

/* signs - of points near each other: the exact predicates. */
static void signs(int kind, tess_int n)
{
    static double p[3 * 60];
    const double *v[5];
    tess_int s[60], u[60], i;

    mkpnts(kind, n, p);
    for (i = 1; i <= n; i++) {
        choose(i, n, p, v);
        /* less 1, as many and chksum count from 1 */
        s[i - 1] = hh_orient(v[0], v[1], v[2], v[3]) - 1;
        u[i - 1] = hh_insphere(v[0], v[1], v[2], v[3], v[4]) - 1;
        prove_signs(v, s[i - 1] + 1, u[i - 1] + 1);
    }
    two("signs", chksum(n, s), chksum(n, u));
    many("HHORIE", n, s);
    many("HHINSP", n, u);
}

/* houses - the Householder predicates, rounded to multiples of 2^-16, which
 * no rounding in the last places alters. */
static void houses(const double *p1, const double *p2, const double *p3,
                   const double *z1, const double *z2)
{
    double c, f[HH_FACET_LEN], side, l;
    tess_int a[8], b[5];
    int k;

    a[0] = hh_facet(p1, p2, p3, f);
    for (k = 0; k < 6; k++) a[1 + k] = near(f[k]);
    a[7] = near(f[11]);
    line("HHFACE", 8, a);
    side = hh_side(f, z1);
    l = hh_lcoord(f, z1);
    b[0] = near(side);
    b[1] = near(l);
    b[2] = hh_opp(f, z1, z2);
    b[3] = hh_wrap(p1, p2, p3, z1, &c);
    b[4] = near(c);
    line("HHSIDE ...", 5, b);
    prove_facet(p1, p2, p3, (int)a[0], f);
    prove_house(p1, p2, p3, z1, z2, side, l, (int)b[2], (int)b[3], c);
}

/* facets - facets of points of a kind, with two points that are not in their
 * planes: those would be there to rounding only. */
static void facets(int kind, tess_int n)
{
    static double p[3 * 60];
    const double *v[5];
    tess_int i;

    mkpnts(kind, n, p);
    for (i = 1; i <= n; i++) {
        choose(i, n, p, v);
        if (hh_orient(v[0], v[1], v[2], v[3]) *
                hh_orient(v[0], v[1], v[2], v[4]) != 0)
            houses(v[0], v[1], v[2], v[3], v[4]);
    }
}

/* inplan - points in a plane where nothing is rounded, and points on a
 * line. */
static void inplan(void)
{
    static const double p[6][3] = {
        {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.25, 0.25, 0.0},
        {2.0, 2.0, 0.0}, {3.0, 0.0, 0.0}
    };

    houses(p[0], p[1], p[2], p[3], p[4]);
    houses(p[0], p[1], p[2], p[4], p[3]);
    houses(p[0], p[1], p[5], p[3], p[4]);
    houses(p[0], p[0], p[2], p[3], p[4]);
}

int main(int argc, char **argv)
{
    static const int kind[] = {
        1, 1, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 9, 9, 10, 10,
        11, 11, 12, 12, 13, 13, 14, 14, 15, 15, 1
    };
    static const tess_int n[] = {
        4, 5, 11, 900, 12, 1000, 8, 729, 12, 552, 9, 60, 14, 300, 14, 400, 10,
        401, 12, 512, 8, 60, 9, 100, 5, 50, 3, 1, 9, 14, 10, 500, 0
    };
    int i, most = MOST;

    if (argc > 1) sscanf(argv[1], "%d", &most);
    for (i = 0; i < (int)(sizeof kind / sizeof *kind); i++)
        if (n[i] <= most) solve(kind[i], n[i]);
    two("= signs, facets", 0, 0);
    two("TESSED", (tess_int)(tess_edition() - TESS_VERSION), 0);
    signs(1, 60);
    signs(2, 27);
    signs(4, 12);
    signs(10, 40);
    facets(1, 20);
    facets(2, 27);
    inplan();
    return prove_end();
}
