/* certify.c - the certificates of the search, on points near planes, spheres,
 * lines and one another.
 *
 *     certify [-time S] [sets [seed]]     that many sets, default 100, or S
 *                                         seconds
 *     certify -one seed                   one set, in full; stops at a fault
 *
 * What tess decides without the exact predicates it decides by a bound: that a
 * point is no better, that a side or a comparison has this sign.  Compiled with
 * TESS_PROVE it tells tess_prove of each such certificate whether the exact
 * predicates say the same; of each apex, too, against all points.  A bound that
 * is too small shows here long before a result is wrong.  In a random rounding
 * mode for each set with -DTEST_ROUNDING and a C99 compiler.  Two sets in three
 * are finished by tess_resume, in steps; one in four has coordinates of many
 * sizes.
 */
#include "../../tess.h"
#include "../proof/exact.h"
#include "hard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef TEST_ROUNDING
#include <fenv.h>
#endif

#define MOST 400
#define MAXTET 20000
#define LENGTH 80000

static double p[MOST][3], rw[LENGTH];
static tess_real point[3 * MOST];
static tess_int tet[4 * MAXTET], adj[4 * MAXTET], iw[LENGTH], n;
static int full;
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

/* Does all of a set hold? */
static int set(unsigned long seed)
{
    static const int most[3] = { 12, 48, MOST };
#ifdef TEST_ROUNDING
    static const int mode[4] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                 FE_TOWARDZERO };
#endif
    volatile tess_real rounded;
    tess_int ntet = 0, room, liw, lrw, bad, i;
    int code, k, steps;

    rnd_seed(seed);
    if (rnd_below(4)) n = (tess_int)hard_near(p, most[rnd_below(3)]);
    else n = (tess_int)hard_many(p, MOST / 2);
    for (i = 0; i < n; i++)
        for (k = 0; k < 3; k++) {
            rounded = (tess_real)p[i][k];
            point[3 * i + k] = rounded;
        }
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
    wrong = 0;
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
        printf("        %ld certificates are wrong: -one %lu\n", wrong,
               seed + (unsigned long)i);
        fflush(stdout);
    }
    printf("        %ld sets, %.0f certificates\n", i, facts);
    test_result("certificates", faults + (facts == 0.0));
    return test_end("certify");
}
