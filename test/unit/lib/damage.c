/* damage.c - see damage.h. */
#include "damage.h"
#include "guard.h"
#include "../../lib/verify.h"

#include <string.h>

/* A new array of that length that begins as a does. */
static tess_int *copied(const tess_int *a, tess_int used, tess_int length)
{
    tess_int *b = ints(length);

    if (used > 0) memcpy(b, a, sizeof *b * (size_t)used);
    return b;
}

/* One of lo ... hi-1 as a rule, else anything. */
static tess_int number(tess_int lo, tess_int hi, int (*draw)(int))
{
    int kind = draw(20), bits = (int)sizeof(tess_int) < 4 ? 15 : 31;

    if (kind == 0) return (tess_int)(hi + draw(4));
    if (kind == 1) return (tess_int)(lo - 1 - draw(4));
    if (kind == 2) return (tess_int)((1L << draw(bits)) - 1);
    if (kind == 3) return (tess_int)(-(1L << draw(bits)));
    return hi > lo ? (tess_int)(lo + draw((int)(hi - lo))) : lo;
}

const char *damage_resume(tess_int n, const tess_real *p, tess_int ntet,
                          const tess_int *tet, const tess_int *adj,
                          int (*draw)(int))
{
    tess_int maxtet = (tess_int)(ntet + draw(24)), was = ntet, m, *t, *a;
    tess_int liw = (tess_int)(4 * n + n / 12 + 514);
    tess_int lrw = (tess_int)(3 * n + n / 2 + 12);
    size_t used = 4 * sizeof *tet * (size_t)ntet;
    int code, keep = narrays, same, within;

    if (draw(2)) liw = (tess_int)(liw + draw(500));
    t = copied(tet, 4 * ntet, 4 * maxtet);
    a = copied(adj, 4 * ntet, 4 * maxtet);
    if (draw(20) == 0) was = number(0, (tess_int)(maxtet + 1), draw);
    m = was;
    code = tess_resume(n, p, maxtet, &m, t, a, liw, ints(liw), lrw,
                       (double *)array((size_t)lrw * sizeof(double)));
    same = m == was && memcmp(t, tet, used) == 0 && memcmp(a, adj, used) == 0;
    within = overrun() == 0;
    release(keep);
    if (!within) return "tess_resume: an array is overrun";
    if (code == -4 || code == -5 || code == -6)
        return same ? NULL : "tess_resume: a negative code, and written";
    if (code < 0 || code > TESS_RANGE) return "tess_resume's code";
    return m < 0 || m > maxtet ? "tess_resume's ntet" : NULL;
}

/* Right, if any are, are so many tetrahedra. */
static const char *check(tess_int n, const tess_real *p, tess_int ntet,
                         const tess_int *tet, const tess_int *adj,
                         const tess_int *iw, tess_int right)
{
    tess_int bad;
    int code = tess_check(n, p, ntet, tet, adj, 2 * n, ints(2 * n), &bad);

    if (code < 0) return "tess_check's code";
    if (code == 0 && (right > 0) != (ntet > 0))
        return "tess_check proves a wrong number of tetrahedra";
    if (code == 0 && ntet > 0 && n <= 60 &&
        verify(n, p, TESS_OK, ntet, tet, adj, iw) != NULL)
        return "tess_check proves what is wrong";
    return NULL;
}

static const char *hull(tess_int ntet, const tess_int *tet,
                        const tess_int *adj, int (*draw)(int))
{
    tess_int maxfac = 0, nfac = -1, many = 0, i;
    int code;

    for (i = 0; i < 4 * ntet; i++) if (adj[i] <= TESS_NONE) many++;
    maxfac = draw(2) ? many : (tess_int)draw(16);
    code = tess_hull(ntet, tet, adj, maxfac, &nfac, ints(3 * maxfac));
    if (nfac < 0 || nfac > 4 * ntet || code != (nfac > maxfac ? TESS_MORE : 0))
        return "tess_hull";
    return NULL;
}

static const char *locate(tess_int n, const tess_real *p, tess_int ntet,
                          tess_int *tet, const tess_int *adj,
                          int (*draw)(int))
{
    tess_real q[3];
    tess_int t = number(TESS_NONE, ntet, draw), i;
    double w[4];
    int k, code;

    for (i = 0; i < 4 * ntet; i++)
        if (tet[i] < 0 || tet[i] >= n) tet[i] = 0;
    for (k = 0; k < 3; k++) {
        q[k] = p[3 * draw((int)n) + k];
        if (draw(3) == 0) q[k] = (tess_real)(draw(12) - 6);
    }
    code = tess_locate(p, ntet, tet, adj, q, &t, w);
    if (code == 1 && !(w[0] >= 0.0 && w[1] >= 0.0 && w[2] >= 0.0 &&
                       w[3] >= 0.0))
        return "tess_locate's weights";
    if ((code == 0 || code == 1) && (t < 0 || t >= ntet))
        return "tess_locate's t";
    if (code != 0 && code != 1 && code != -4 && code != -6 &&
        code != TESS_RANGE && !(code == -2 && ntet < 1))
        return "tess_locate's code";
    return NULL;
}

const char *damage(tess_int n, const tess_real *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj,
                   const tess_int *iw, int (*draw)(int))
{
    tess_int liw = (tess_int)(4 * n + n / 12 + 514), m = ntet, i, room, *t, *a;
    tess_int lrw = (tess_int)(3 * n + n / 2 + 12);
    const char *what;
    int keep = narrays, kind = draw(8), changes;

    if (n < 1) return NULL;
    if (kind < 2) {
        /* nothing that a call has made */
        m = (tess_int)draw(6);
        t = ints(4 * m);
        a = ints(4 * m);
        for (i = 0; i < 4 * m; i++) {
            t[i] = kind ? (tess_int)((t[i - i % 4] + i % 4) % n) : -1;
            if (i % 4 == 0 || !kind) t[i] = (tess_int)draw((int)n);
            a[i] = draw(4) ? number(TESS_OPEN, m, draw) : TESS_OPEN;
        }
    } else {
        room = kind < 5 ? (tess_int)draw((int)ntet + 1) : ntet;
        t = copied(tet, 4 * room, 4 * room);
        a = copied(adj, 4 * room, 4 * room);
        if (kind < 5 &&
            tess(n, p, room, &m, t, a, liw, ints(liw), lrw,
                 (double *)array((size_t)lrw * sizeof(double))) == TESS_RANGE)
            m = 0;
        for (changes = draw(6); changes > 0 && m > 0; changes--) {
            i = (tess_int)draw((int)(4 * m));
            if (draw(3) == 0) t[i] = number(0, n, draw);
            else a[i] = number(TESS_OPEN, m, draw);
        }
    }
    /* (of their very lengths: an unfinished result may be shorter) */
    t = copied(t, 4 * m, 4 * m);
    a = copied(a, 4 * m, 4 * m);
    what = damage_resume(n, p, m, t, a, draw);
    if (!what) what = check(n, p, m, t, a, iw, ntet);
    if (!what) what = hull(m, t, a, draw);
    if (!what) what = locate(n, p, m, t, a, draw);
    if (!what && overrun() > 0) what = "damage: an array is overrun";
    release(keep);
    return what;
}
