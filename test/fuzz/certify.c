/* certify.c - the certificates of the search, on points near planes, spheres,
 * lines and one another, and of the faces of bodies.
 *
 *     certify [-faces] [-time S] [sets [seed]]
 *                            that many sets, default 100, or S seconds
 *     certify [-faces] -one seed
 *                            one set, in full; stops at a fault
 *
 * With -faces all sets are of the faces of bodies, where caps decide.
 *
 * What tess decides without the exact predicates it decides by a bound: that a
 * point is no better, that a side or a comparison has this sign.  Compiled with
 * TESS_PROVE it tells tess_prove of each such certificate whether the exact
 * predicates say the same; of each apex, too, against all points.  A bound that
 * is too small shows here long before a result is wrong.  In a random rounding
 * mode for each set with -DTEST_ROUNDING and a C99 compiler.  Two sets in three
 * are finished by tess_resume, in steps; one in four has coordinates of many
 * sizes; of one in eight, on lines, only some are meshed, and then a few far
 * away that are in no tetrahedron yet.
 */
#include "../../tess.h"
#include "../lib/exact.h"
#include "../lib/hard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef TEST_ROUNDING
#include <fenv.h>
#endif

#define MOST 400
#define LINES 700
#define MAXTET 20000
#define LENGTH 80000

static double p[LINES][3], rw[LENGTH];
static tess_real point[3 * LINES];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[LENGTH], n;
static int full, faces;
static double facts;
static long wrong;

void tess_prove(int fact)
{
    facts += 1.0;
    if (fact) return;
    wrong++;
    if (full) {
        printf("the certificate %.0f is wrong\n", facts);
        fflush(stdout);
        abort();
    }
}

/* p, rounded to the type of the caller's coordinates */
static void copy(void)
{
    volatile tess_real rounded;
    tess_int i;
    int k;

    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            rounded = (tess_real)p[i][k];
            point[3 * i + k] = rounded;
        }
}

/* Does all hold of the stars of whole leaves about the index's tetrahedron,
 * and of a few points far off?  From these a search may begin at a
 * vertex of that, when all around it is complete. */
static int part(void)
{
    static tess_int mine[LINES];
    tess_int ntet = 0, liw, lrw, leaves = 1, leaf, other, i;
    int code, line, k;

    n = (tess_int)hard_lines(p, LINES, &line);
    copy();
    if (tess_size(n, 0, &liw, &lrw) != 0 || liw > LENGTH || lrw > LENGTH)
        return 0;
    code = tess_index(n, point, LENGTH, iw, lrw, rw);
    if (code != TESS_OK) return code == TESS_RANGE && HH_LIMBS < 32;
    k = rnd_below(2) ? 8 : 48; /* the points of a leaf, as tess.c has them */
    while (leaves < (n + k - 1) / k) leaves *= 2;
    for (i = 0; i < n; i++) mine[i] = 0;
    for (k = 0; k < 4; k++) {
        leaf = iw[iw[2 * n + k]] * leaves / n;
        for (i = 0; i < n; i++) {
            other = iw[i] * leaves / n;
            if (other == leaf || other / 2 == (leaf / 2 ^ 1)) mine[i] = 1;
        }
    }
    for (k = 0; k < 12; k++) mine[n - 1 - rnd_below(line)] = 1;
    code = tess_part(n, point, mine, MAXTET, &ntet, tet, adj, LENGTH, iw, lrw,
                     rw);
    if (full) printf("code %d, %ld tetrahedra\n", code, (long)ntet);
    return wrong == 0 && code == TESS_OK;
}

/* Does all of a set hold? */
static int set(unsigned long seed)
{
    static const int most[3] = { 12, 48, MOST };
#ifdef TEST_ROUNDING
    static const int mode[4] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                 FE_TOWARDZERO };
#endif
    tess_int ntet = 0, room, liw, lrw, bad, i;
    int code, steps;

    wrong = 0;
    rnd_seed(seed);
    if (!faces && rnd_below(8) == 0) return part();
    code = faces ? 1 : rnd_below(4);
    if (code > 1) n = (tess_int)hard_near(p, most[rnd_below(3)]);
    else if (code == 1) n = (tess_int)hard_faces(p, MOST);
    else n = (tess_int)hard_many(p, MOST / 2);
    copy();
    steps = rnd_below(3);
    room = steps > 0 ? (tess_int)(1 + rnd_below(7 * (int)n)) : MAXTET;
    if (full) {
        printf("# %ld points, first %ld tetrahedra\n", (long)n, (long)room);
        for (i = 0; i < n; i++)
            printf("%.17g %.17g %.17g\n", p[i][0], p[i][1], p[i][2]);
        fflush(stdout);
    }
    if (tess_size(n, MAXTET, &liw, &lrw) != 0 || liw > LENGTH || lrw > LENGTH)
        return 0;
#ifdef TEST_ROUNDING
    fesetround(mode[rnd_below(4)]);
#endif
    code = tess(n, point, room, &ntet, tet, adj, liw, iw, lrw, rw);
    while ((code == TESS_MORE && room < MAXTET) ||
           (code == TESS_POOL && liw < LENGTH)) {
        if (code == TESS_POOL) liw = LENGTH;
        else room = room < MAXTET / 2 ? 2 * room : MAXTET;
        code = tess_resume(n, point, room, &ntet, tet, adj, liw, iw, lrw, rw);
    }
#ifdef TEST_ROUNDING
    fesetround(FE_TONEAREST);
#endif
    if (full) printf("code %d, %ld tetrahedra\n", code, (long)ntet);
    if (wrong > 0) return 0;
    if (code != TESS_OK)
        return (code >= TESS_PLANE && code <= TESS_POINT && ntet == 0) ||
            (code == TESS_RANGE && HH_LIMBS < 32);
    code = tess_check(n, point, ntet, tet, adj, liw, iw, &bad);
    return code == TESS_OK || (code == TESS_RANGE && HH_LIMBS < 32);
}

int main(int argc, char **argv)
{
    double seconds = 0.0;
    long most, i, faults = 0;
    unsigned long seed;
    time_t start = time(NULL);

    if (argc > 1 && strcmp(argv[1], "-faces") == 0) {
        faces = 1;
        argc--;
        argv++;
    }
    if (argc > 2 && strcmp(argv[1], "-one") == 0) {
        full = 1;
        return !set(strtoul(argv[2], NULL, 10));
    }
    if (argc > 2 && strcmp(argv[1], "-time") == 0) {
        seconds = atof(argv[2]);
        argc -= 2;
        argv += 2;
    }
    most = argc > 1 ? atol(argv[1]) : 100;
    seed = argc > 2 ? strtoul(argv[2], NULL, 10) : 1;
    for (i = 0; (seconds > 0.0 ? difftime(time(NULL), start) < seconds
                               : i < most) && faults < 5; i++) {
        if (set(seed + (unsigned long)i)) continue;
        faults++;
        printf("# %ld certificates are wrong: -one %lu\n", wrong,
               seed + (unsigned long)i);
        fflush(stdout);
    }
    printf("# %ld sets, %.0f certificates\n", i, facts);
    test_result("certificates", faults + (facts == 0.0));
    return test_end();
}
