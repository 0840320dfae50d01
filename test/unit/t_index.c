/* t_index.c - an index that another build, or another rounding mode, has made.
 *
 *     t_index write FILE    indices of some sets, one in each rounding mode
 *     t_index FILE...       parts and queries by these, in each rounding mode,
 *                           must be of the mesh
 *
 * The marks of an index hold for the very plane or sphere that they were
 * measured from.  So whatever serves an index must find that one, to the last
 * bit.  check.sh has each of its builds read what all of them wrote.
 */
#include "../../tess.h"
#include "../lib/exact.h"
#include "../lib/points.h"
#include "../lib/take.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef TEST_ROUNDING
#include <fenv.h>
#define MODES 4
static const int mode[MODES] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                 FE_TOWARDZERO };
static void turn_to(int i) { fesetround(mode[i]); }
#else
#define MODES 1
static void turn_to(int i) { (void)i; }
#endif

#define MOST 3000
#define MAXTET (12 * MOST)
#define LENGTH (7 * MOST + 600)

static const char *const sets[] = { "turned", "globe", "rotcube", "near8",
                                    "ellipsoid" };
#define SETS (int)(sizeof sets / sizeof sets[0])

/* A lattice of 14^3 integers, turned by a matrix of sevenths, or a family. */
static tess_int points(const char *name, double *p)
{
    static const double a[9] = { 2, 3, 6, 6, 2, -3, -3, 6, -2 };
    tess_int n = 0;
    int i, j;

    if (strcmp(name, "turned") != 0)
        return (tess_int)points_make(name, MOST, 1, p);
    for (i = 0; i < 14 * 14 * 14; i++, n++)
        for (j = 0; j < 3; j++)
            p[3 * n + j] = (a[3 * j] * (i % 14) + a[3 * j + 1] * (i / 14 % 14) +
                            a[3 * j + 2] * (i / 196)) / 7.0;
    return n;
}

static int by_five(const void *a, const void *b)
{
    return memcmp(a, b, 4 * sizeof(tess_int));
}

/* The vertices in ascending order. */
static void ordered(const tess_int *v, tess_int *s)
{
    int i, k;

    for (i = 0; i < 4; i++) {
        for (k = i; k > 0 && s[k - 1] > v[i]; k--) s[k] = s[k - 1];
        s[k] = v[i];
    }
}

/* A set of points, its mesh, the mesh's tetrahedra as a sorted set. */
static tess_int n, ntet, liw, lrw;
static double *p, *rw, *room;
static tess_int *tet, *adj, *set, *iw, *left, *mine, *part, *other;
static long faults;

static int known(const tess_int *v)
{
    tess_int s[4];

    ordered(v, s);
    return bsearch(s, set, (size_t)ntet, 4 * sizeof *s, by_five) != NULL;
}

/* One part of eight and some queries by the index left, rw. */
static void serve(void)
{
    tess_int many = 0, expected = 0, t, v[4], where;
    double q[3], w[4], weights[4];
    int k, i, code, wrong = 0;

    for (t = 0; t < n; t++) mine[t] = left[t] < n / 8;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++)
            if (mine[tet[4 * t + k]]) {
                expected++;
                break;
            }
    for (i = 0; i < 12; i++) {
        for (k = 0; k < 3; k++)
            q[k] = 0.5 * p[3 * (i * 71 % n) + k] + 0.5 * p[3 * (i * 97 % n) + k];
        v[0] = where = TESS_NONE;
        code = tess_locate(p, ntet, tet, adj, q, &where, w);
        if (tess_query(n, p, left, rw, q, v, weights) != code ||
            (code == 0 && !known(v)))
            wrong++;
    }
    code = tess_part(n, p, mine, MAXTET, &many, part, other, liw, left, lrw,
                     rw);
    if (code != 0 || many != expected) wrong++;
    for (t = 0; code == 0 && t < many; t++)
        if (!known(part + 4 * t)) wrong++;
    faults += wrong > 0;
}

int main(int argc, char **argv)
{
    char name[200];
    FILE *file;
    int s, m, k, f, writes = argc > 2 && strcmp(argv[1], "write") == 0;
    tess_int t, length;

    if (argc < 2) test_usage(argv[0], "[write] file...");
    p = (double *)take(3.0 * MOST, sizeof *p);
    liw = (tess_int)TESS_LIW(MOST) + LENGTH;
    lrw = (tess_int)TESS_LRW(MOST);
    rw = (double *)take(lrw, sizeof *rw);
    room = (double *)take(lrw, sizeof *rw);
    iw = (tess_int *)take(liw, sizeof *iw);
    left = (tess_int *)take(liw, sizeof *iw);
    mine = (tess_int *)take(MOST, sizeof *iw);
    tet = (tess_int *)take(4.0 * MAXTET, sizeof *tet);
    adj = (tess_int *)take(4.0 * MAXTET, sizeof *tet);
    set = (tess_int *)take(4.0 * MAXTET, sizeof *tet);
    part = (tess_int *)take(4.0 * MAXTET, sizeof *tet);
    other = (tess_int *)take(4.0 * MAXTET, sizeof *tet);
    for (f = writes ? 2 : 1; f < argc; f++) {
        file = fopen(argv[f], writes ? "wb" : "rb");
        if (file == NULL) test_usage(argv[0], "[write] file...");
        for (s = 0; s < SETS; s++) {
            n = points(sets[s], p);
            length = (tess_int)(7 * n + 600);
            faults = 0;
            if (!writes &&
                tess(n, p, MAXTET, &ntet, tet, adj, liw, iw, lrw, room) != 0)
                return 2;
            for (t = 0; !writes && t < ntet; t++)
                ordered(tet + 4 * t, set + 4 * t);
            if (!writes)
                qsort(set, (size_t)ntet, 4 * sizeof *set, by_five);
            for (m = 0; m < MODES; m++) {
                if (writes) {
                    turn_to(m);
                    k = tess_index(n, p, length, iw, lrw, rw);
                    turn_to(0);
                    if (k != 0 ||
                        fwrite(iw, sizeof *iw, (size_t)length, file) !=
                            (size_t)length ||
                        fwrite(rw, sizeof *rw, (size_t)lrw, file) !=
                            (size_t)lrw)
                        return 1;
                    continue;
                }
                if (fread(iw, sizeof *iw, (size_t)length, file) !=
                        (size_t)length ||
                    fread(rw, sizeof *rw, (size_t)lrw, file) != (size_t)lrw)
                    return 2;
                for (k = 0; k < MODES; k++) {
                    memcpy(left, iw, (size_t)length * sizeof *iw);
                    turn_to(k);
                    serve();
                    turn_to(0);
                }
            }
            if (writes) continue;
            sprintf(name, "%.20s, index of %.60s", sets[s], argv[f]);
            test_result(name, faults);
        }
        fclose(file);
    }
    return writes ? 0 : test_end();
}
