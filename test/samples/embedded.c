/* embedded.c - tess on a small machine: all memory is static, of a size fixed
 * at compile time, and every code that tess can return has an answer.
 *
 *   cc -O2 -I. -o embedded test/samples/embedded.c tess.c hhpred.c -lm
 *
 * Sensors in a room: what would one read at any other place?  Inside of the
 * sensors' hull the answer is interpolated; where that is impossible it is the
 * reading of the nearest sensor.  Only main, which plays the sensors and
 * checks the answers, prints anything.
 *
 * To save memory, compile all files with -DTESS_FLOAT (coordinates) and
 * -DTESS_INT=short (indices, for up to 1,100 points); to save stack, see
 * TESS_LIST in tess.h and HH_LIMBS in hhpred.h: -DTESS_LIST=64 -DHH_LIMBS=6.
 * Six limbs hold coordinates from 1e-12 to 1e6; for others there is TESS_RANGE.
 * To save flash: -Os -ffunction-sections, and -Wl,--gc-sections to link, which
 * leaves out what is not called.  test/results/reach.txt has tables.
 */
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "tess.h"

#define SENSORS 64
/* Spread over a volume, n points have up to 7 n tetrahedra. */
#define TETS (7 * SENSORS)
#define LIW TESS_LIW(SENSORS)
#define LRW TESS_LRW(SENSORS)

/* How an answer was found. */
#define INSIDE 0  /* interpolated between four sensors */
#define NEAREST 1 /* the nearest sensor's reading      */
#define NOTHING 2 /* there is no answer                */

static tess_real place[3 * SENSORS];
static double reading[SENSORS];
static tess_int sensors;
static tess_int tet[4 * TETS], adj[4 * TETS], tets;
/* Free for any other use between calls of connect. */
static tess_int iw[LIW];
static double rw[LRW];

/* ------------------------------------------------- the part without stdio */

/* connect - tetrahedralize the sensors, after any change of their places.
 * Sensors with a coordinate that is infinite or no number are removed.
 * Returns the code of tess:
 *   TESS_OK                all is well
 *   TESS_MORE, TESS_POOL   arrays full: to locate a place takes a finished
 *                          mesh, so the nearest sensor will do; to go on, give
 *                          tess_resume longer arrays
 *   TESS_PLANE, _LINE, _POINT, _RANGE   no tetrahedra: the nearest sensor
 *                          will do; RANGE cannot come with the default limbs
 *   below 0                SENSORS, TETS, LIW or LRW are wrong */
static int connect(void)
{
    tess_int found = 0, i;
    int code, k;

    tets = 0;
    while ((code = tess(sensors, place, TETS, &found, tet, adj, LIW, iw, LRW,
                        rw)) == -2) {
        sensors = (tess_int)(sensors - 1);
        for (i = found; i < sensors; i++) {
            for (k = 0; k < 3; k++) place[3 * i + k] = place[3 * i + 3 + k];
            reading[i] = reading[i + 1];
        }
    }
    if (code == TESS_OK) tets = found;
    return code;
}

/* nearest - the sensor nearest to q; -1 when there is none. */
static tess_int nearest(const tess_real *q)
{
    double least = 0.0, sum, d;
    tess_int best = -1, i;
    int k;

    for (i = 0; i < sensors; i++) {
        sum = 0.0;
        for (k = 0; k < 3; k++) {
            d = (double)place[3 * i + k] - (double)q[k];
            sum += d * d;
        }
        if (best < 0 || sum < least) {
            best = i;
            least = sum;
        }
    }
    return best;
}

/* ask - the value at q.  Returns INSIDE, NEAREST or NOTHING. */
static int ask(const tess_real *q, double *value)
{
    static tess_int last = TESS_NONE; /* the next q may well be near */
    double w[4];
    tess_int i;
    int k;

    *value = 0.0;
    if (last >= tets) last = TESS_NONE;
    switch (tess_locate(place, tets, tet, adj, q, &last, w)) {
    case 0:
        for (k = 0; k < 4; k++) *value += w[k] * reading[tet[4 * last + k]];
        return INSIDE;
    case -5: /* q itself is not finite */
        return NOTHING;
    default: /* 1: outside; -2: no tetrahedra; TESS_RANGE */
        i = nearest(q);
        if (i < 0) return NOTHING;
        *value = reading[i];
        return NEAREST;
    }
}

/* ---------------------------------------------- the part that tries it out */

static double random01(void)
{
    static unsigned long seed = 1;

    seed = (seed * 1664525UL + 1013904223UL) & 0xffffffffUL;
    return (double)(seed >> 16) / 65536.0;
}

/* truth - what all sensors read: linear, so that interpolation is exact. */
static double truth(const tess_real *q)
{
    return 20.0 + 0.5 * (double)q[0] - 0.25 * (double)q[1] + (double)q[2];
}

/* put - a sensor at x, y, z. */
static void put(double x, double y, double z)
{
    tess_real *q = place + 3 * sensors;

    q[0] = (tess_real)x;
    q[1] = (tess_real)y;
    q[2] = (tess_real)z;
    reading[sensors] = truth(q);
    sensors = (tess_int)(sensors + 1);
}

/* somewhere - a random place in a box that begins at x = y = z = from. */
static void somewhere(double from, double x, double y, double z, tess_real *q)
{
    q[0] = (tess_real)(from + x * random01());
    q[1] = (tess_real)(from + y * random01());
    q[2] = (tess_real)(from + z * random01());
}

/* room - all sensors, in a room of 8 by 6 metres, in the topmost height metres
 * below its ceiling at 3 metres. */
static void room(double height)
{
    tess_real q[3];
    int i;

    sensors = 0;
    for (i = 0; i < SENSORS; i++) {
        somewhere(0.0, 8.0, 6.0, height, q);
        put((double)q[0], (double)q[1], 3.0 - (double)q[2]);
    }
}

/* held - 1 when a tetrahedron holds q, by exact signs. */
static int held(const tess_real *q)
{
    const tess_real *v[4];
    tess_int t;
    int i, k;

    for (t = 0; t < tets; t++) {
        for (k = 0; k < 4; k++) {
            for (i = 0; i < 4; i++)
                v[i] = i == k ? q : place + 3 * tet[4 * t + i];
            if (hh_orient(v[0], v[1], v[2], v[3]) < 0) break;
        }
        if (k == 4) return 1;
    }
    return 0;
}

/* attempt - connect the sensors, ask for values at places in and about the
 * room, and print what became of it.  Every answer is checked: it must be the
 * truth where a tetrahedron holds the place, elsewhere the reading of a sensor
 * than which no other is nearer.  expected is the code.  Returns 1 when
 * anything is wrong. */
static int attempt(const char *what, int expected)
{
    tess_real q[3];
    double value, d[3], to, least;
    tess_int i;
    int code = connect(), count[3], wrong = code != expected, asked, how, k;

    count[0] = count[1] = count[2] = 0;
    for (asked = 0; asked < 1000; asked++) {
        somewhere(-1.0, 10.0, 8.0, 5.0, q);
        how = ask(q, &value);
        count[how]++;
        if ((how == INSIDE) != held(q)) wrong = 1;
        if (how == INSIDE && fabs(value - truth(q)) > 1e-12) wrong = 1;
        if (how == NEAREST) {
            least = to = DBL_MAX;
            for (i = 0; i < sensors; i++) {
                for (k = 0; k < 3; k++)
                    d[k] = (double)place[3 * i + k] - (double)q[k];
                d[0] = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                if (d[0] < least) least = d[0];
                if (reading[i] == value && d[0] < to) to = d[0];
            }
            if (to > least) wrong = 1;
        }
    }
    if (sensors > 0 && count[NOTHING] > 0) wrong = 1;
    printf("%-24s %7ld %5d %10ld  %12d  %7d  %7d%s\n", what, (long)sensors,
           code, (long)tets, count[INSIDE], count[NEAREST], count[NOTHING],
           wrong ? "  WRONG" : "");
    return wrong;
}

int main(void)
{
    volatile double infinite = DBL_MAX;
    tess_int liw, lrw;
    int bad = 0, i;

    if (tess_size(SENSORS, TETS, &liw, &lrw) != 0 || LIW < liw || LRW < lrw) {
        printf("the workspace is too short: %ld and %ld are recommended\n",
               (long)liw, (long)lrw);
        return 1;
    }
    printf("static memory, bytes: sensors %lu, tetrahedra %lu, "
           "workspace %lu\n",
           (unsigned long)(sizeof place + sizeof reading),
           (unsigned long)(sizeof tet + sizeof adj),
           (unsigned long)(sizeof iw + sizeof rw));
    printf("\n%-24s sensors  code tetrahedra  interpolated  nearest  "
           "nothing\n",
           "");
    room(3.0);
    bad |= attempt("a room", TESS_OK);

    infinite *= 16.0;
    room(3.0);
    place[3 * 7] = (tess_real)infinite;
    place[3 * 8 + 2] = (tess_real)infinite;
    bad |= attempt("two places are lost", TESS_OK);

    sensors = 0;
    for (i = 0; i < SENSORS; i++) put(2.0 * (i % 4), i / 4 % 4 * 2.0, i / 16);
    bad |= attempt("a regular grid", TESS_OK);

    sensors = 0;
    for (i = 0; i < SENSORS; i++)
        put(i % 2 * 8.0, i / 2 % 2 * 6.0, i / 4 % 2 * 3.0);
    bad |= attempt("corners, many times", TESS_OK);

    /* Points on this curve are all joined to each other: 64 points have
     * more than 1000 tetrahedra. */
    sensors = 0;
    for (i = 0; i < SENSORS; i++)
        put(i / 8.0, i * i / 512.0, i * i / 512.0 * i / 64.0);
    bad |= attempt("a curve with many", TESS_MORE);

    room(0.0);
    bad |= attempt("all on the ceiling", TESS_PLANE);

    sensors = 0;
    for (i = 0; i < SENSORS; i++) put(i / 8.0, i / 16.0, 3.0 - i / 32.0);
    bad |= attempt("all along a cable", TESS_LINE);

    sensors = 0;
    put(4.0, 3.0, 1.5);
    put(4.0, 3.0, 1.5);
    bad |= attempt("all in one place", TESS_POINT);

    sensors = 0;
    bad |= attempt("none", TESS_POINT);

    printf("%s\n", bad ? "WRONG" : "all answers right");
    return bad;
}
