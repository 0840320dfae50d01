/* fuzzarr.c - bytes as damage to a result: what the routines do that read
 * arrays which no call has made; for libFuzzer, or alone, as fuzz.c.
 *
 * Whatever tet, adj and ntet hold, tess_resume must end with a code, touch
 * nothing outside of the arrays, and after a negative code leave them as they
 * were; tess_check and tess_hull must end and touch nothing else, and
 * tess_check must not prove what is wrong; tess_locate, which has no n, may rely
 * on tet alone.  Each array is allocated in its very length.
 */
#define NAME "fuzzarr"
#include "fuzz.h"

#include <string.h>

static tess_int *copied(const tess_int *a, tess_int length, tess_int all)
{
    tess_int *b = room(all, sizeof *b);

    memset(b, 85, sizeof *b * (size_t)all);
    memcpy(b, a, sizeof *b * (size_t)(length < all ? length : all));
    return b;
}

/* An index in lo ... hi-1 as a rule, else anything. */
static tess_int number(tess_int lo, tess_int hi)
{
    int b = byte();

    if (b < 220 && hi > lo) return (tess_int)(lo + byte() % (hi - lo));
    b = byte();
    if (b < 60) return (tess_int)(hi + b % 4);
    if (b < 120) return (tess_int)(lo - 1 - b % 4);
    if (b < 150) return (tess_int)((1L << (b % 31)) - 1);
    if (b < 180) return (tess_int)(-(1L << (b % 31)));
    return (tess_int)(256 * byte() + b);
}

/* 6 times the volume: the coordinates are small integers. */
static double volume(const tess_int *v)
{
    double a[3], b[3], c[3];
    int k;

    for (k = 0; k < 3; k++) {
        a[k] = p[v[1]][k] - p[v[0]][k];
        b[k] = p[v[2]][k] - p[v[0]][k];
        c[k] = p[v[3]][k] - p[v[0]][k];
    }
    return a[0] * (b[1] * c[2] - b[2] * c[1]) +
           a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* The facet of u with the three vertices of facet k of v, or 4. */
static int common(const tess_int *v, int k, const tess_int *u)
{
    int i, j, found, apex = 4, shared = 0;

    for (i = 0; i < 4; i++) {
        found = 0;
        for (j = 0; j < 4; j++) found |= j != k && v[j] == u[i];
        if (found) shared++;
        else apex = i;
    }
    return shared == 3 ? apex : 4;
}

/* Is this a Delaunay tetrahedralization, all of volume whole? */
static int right(tess_int ntet, const tess_int *tet, const tess_int *adj,
                 double whole)
{
    double sum = 0.0;
    const tess_int *v;
    tess_int t, u, across;
    int i, k;

    for (t = 0; t < ntet; t++) {
        v = tet + 4 * t;
        for (k = 0; k < 4; k++)
            if (v[k] < 0 || v[k] >= n) return 0;
        if (volume(v) <= 0.0) return 0;
        sum += volume(v);
        for (i = 0; i < n; i++)
            if (ex_insphere(p[v[0]], p[v[1]], p[v[2]], p[v[3]], p[i]) > 0)
                return 0;
    }
    if (sum != whole) return 0;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++) {
            across = TESS_NONE;
            for (u = 0; u < ntet; u++)
                if (u != t && common(tet + 4 * t, k, tet + 4 * u) < 4)
                    across = u;
            if (adj[4 * t + k] != across) return 0;
        }
    return 1;
}

static void resume(tess_int ntet, const tess_int *tet, const tess_int *adj,
                   tess_int liw, tess_int lrw)
{
    tess_int maxtet = ntet + byte() % 8, m = ntet, *t, *a, *iw, used;
    double *rw = room(lrw, sizeof *rw);
    int code, b = byte();

    if (b < 8) m = (tess_int)(m + b - 4);
    if (b == 8) m = -1;
    if (b == 9) m = (tess_int)((1L << 30) - 1);
    liw = (tess_int)(liw + byte() % 4 * byte());
    t = copied(tet, 4 * ntet, 4 * maxtet);
    a = copied(adj, 4 * ntet, 4 * maxtet);
    iw = room(liw, sizeof *iw);
    used = ntet;
    ntet = m;
    code = tess_resume((tess_int)n, point, maxtet, &m, t, a, liw, iw, lrw, rw);
    if (!(code == -4 || code == -5 || code == -6 ||
          (code >= 0 && code <= TESS_RANGE)))
        stop("tess_resume's code");
    if (code < 0 && (m != ntet ||
                     memcmp(t, tet, 4 * sizeof *t * (size_t)used) != 0 ||
                     memcmp(a, adj, 4 * sizeof *t * (size_t)used) != 0))
        stop("arrays after tess_resume's negative code");
    if (code >= 0 && (m < 0 || m > maxtet)) stop("tess_resume's ntet");
    free(t);
    free(a);
    free(iw);
    free(rw);
}

static void check(tess_int ntet, const tess_int *tet, const tess_int *adj,
                  double whole)
{
    tess_int *iw = room(2 * (tess_int)n, sizeof *iw), bad;
    int code = tess_check((tess_int)n, point, ntet, tet, adj,
                          (tess_int)(2 * n), iw, &bad);

    if (code == 0 && !right(ntet, tet, adj, whole)) stop("a false proof");
    if (code < 0) stop("tess_check's code");
    free(iw);
}

static void hull(tess_int ntet, const tess_int *tet, const tess_int *adj)
{
    tess_int maxfac = byte() % 16, *fac, nfac, i, many = 0;
    int code;

    for (i = 0; i < 4 * ntet; i++) many += adj[i] <= TESS_NONE;
    if (maxfac > 8) maxfac = many;
    fac = room(3 * maxfac, sizeof *fac);
    code = tess_hull(ntet, tet, adj, maxfac, &nfac, fac);
    if (nfac < 0 || nfac > 4 * ntet || code != (nfac > maxfac ? TESS_MORE : 0))
        stop("tess_hull");
    free(fac);
}

/* Is the neighbour of t across facet k there, with that facet of its own? */
static int matched(const tess_int *tet, const tess_int *adj, tess_int ntet,
                   tess_int t, int k)
{
    static const int out[4][3] = { {1,2,3}, {0,3,2}, {0,1,3}, {0,2,1} };
    tess_int u = adj[4 * t + k];
    int i, j;

    if (u < 0 || u >= ntet) return u == TESS_NONE || u == TESS_OPEN;
    for (j = 0; j < 4; j++)
        for (i = 0; i < 3 && adj[4 * u + j] == t; i++)
            if (tet[4 * t + out[k][0]] == tet[4 * u + out[j][i]] &&
                tet[4 * t + out[k][1]] == tet[4 * u + out[j][(i + 2) % 3]] &&
                tet[4 * t + out[k][2]] == tet[4 * u + out[j][(i + 1) % 3]])
                return 1;
    return 0;
}

static void locate(tess_int ntet, tess_int *tet, const tess_int *adj)
{
    tess_real q[3];
    tess_int t = number(TESS_NONE, ntet), i;
    double w[4];
    int k, code, bad = 0;

    for (i = 0; i < 4 * ntet; i++) {
        if (tet[i] < 0 || tet[i] >= n) tet[i] = 0;
        if (i % 4 == 3 && ex_orient(p[tet[i - 3]], p[tet[i - 2]],
                                    p[tet[i - 1]], p[tet[i]]) <= 0)
            bad = 1; /* flat, or its vertices not four */
    }
    for (i = 0; i < 4 * ntet; i++)
        if (!matched(tet, adj, ntet, i / 4, (int)(i % 4))) bad = 1;
    for (k = 0; k < 3; k++) q[k] = (tess_real)(0.5 * (byte() % 12) - 0.5);
    code = tess_locate(point, ntet, tet, adj, q, &t, w);
    if (code == 1 && !(w[0] >= 0.0 && w[1] >= 0.0 && w[2] >= 0.0 &&
                       w[3] >= 0.0)) stop("tess_locate's weights");
    if (code >= 0 && (t < 0 || t >= ntet)) stop("tess_locate's t");
    if (code != 0 && code != 1 && code != -6 && !(code == -2 && ntet == 0) &&
        !(code == -4 && bad))
        stop("tess_locate's code");
}

int LLVMFuzzerTestOneInput(const unsigned char *bytes, size_t size)
{
    tess_int liw, lrw, least = 1, ntet, was, *tet, *adj, *iw, *t, *a, i;
    double *rw, whole = 0.0;
    int k, damage;

    data = bytes;
    end = bytes + size;
    n = 1 + byte() % MOST;
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            p[i][k] = byte() % 5;
            point[3 * i + k] = (tess_real)p[i][k];
        }
    tess_size((tess_int)n, 20, &liw, &lrw);
    tet = room(80, sizeof *tet);
    adj = room(80, sizeof *adj);
    iw = room(liw, sizeof *iw);
    rw = room(lrw, sizeof *rw);
    tess((tess_int)n, point, 20, &was, tet, adj, liw, iw, lrw, rw);
    for (i = 0; i < was; i++) whole += volume(tet + 4 * i);
    ntet = was;
    if (byte() % 2) {
        while (tess((tess_int)n, point, 0, &i, tet, adj, least, iw, lrw, rw) ==
               -7)
            least++;
        tess((tess_int)n, point, (tess_int)(byte() % (was + 1)), &ntet, tet, adj,
             least, iw, lrw, rw);
    } else
        least = liw;
    free(iw);
    free(rw);
    damage = byte();
    if (damage < 60) {
        /* nothing that a call has made */
        ntet = (tess_int)(damage % 8);
        for (i = 0; i < 4 * ntet; i++) {
            tet[i] = (tess_int)(byte() % n);
            adj[i] = number(TESS_OPEN, ntet);
        }
    } else
        for (damage %= 7; damage > 0 && ntet > 0; damage--) {
            i = (tess_int)(byte() % (4 * ntet));
            if (byte() % 3 == 0) tet[i] = number(0, (tess_int)n);
            else adj[i] = number(TESS_OPEN, ntet);
        }
    t = copied(tet, 4 * ntet, 4 * ntet);
    a = copied(adj, 4 * ntet, 4 * ntet);
    resume(ntet, t, a, least, lrw);
    check(ntet, t, a, whole);
    hull(ntet, t, a);
    locate(ntet, t, a);
    free(t);
    free(a);
    free(tet);
    free(adj);
    return 0;
}

#ifdef STANDALONE
static void choose(unsigned char *bytes)
{
    (void)bytes;
}
#endif
