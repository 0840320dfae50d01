/* t_margin.c - the floating-point margins of tess.c's search, by exact.c.
 *
 *     t_margin [rounds [seed]]     rounds of each class, default 40
 *
 * Floating point in tess.c only chooses where to look; its margins must cover
 * its rounding.  A margin that is too small shows in a result only if a point
 * that it wrongly leaves out is the one that counts, which is rare.  So the
 * routines are called by themselves here (tess.c is included), on points that
 * are near to one sphere or plane, of the most different sizes, far from the
 * base, or lost in underflow, and nothing that they say may be false:
 *   leaflist  has all uncompleted points of its box; bounds of its coordinates
 *   starlist  has all uncompleted points nearer to the star than its margin
 *   prunebox  no candidate is in the box of a node that is left out
 *   starcoef, ballcoef, inball   each candidate of a list passes, and the
 *             vertices of the facet and the best point, which are counted on
 *   ballinstar, ballinbox        no candidate is elsewhere, if they say so
 *   treesearch, apex             no candidate beats what they find
 * Candidates are the uncompleted points on the facet's positive side that are
 * in the ball of the best one or on it, by exact.c.  With -DTESS_PROVE tess.c's
 * own certificates are heard, too (see certify.c).  In all rounding modes
 * with -DTEST_ROUNDING and a C99 compiler.
 */
#include "../../tess.c"
#include "../proof/exact.h"
#include "../hunts/hard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef TESS_COUNT
double tess_count[16];
#endif

#define MOST 160
#define POOL 20000

static tess_real point_of[3 * MOST];
static double P[MOST][3]; /* the same, by position */
static tess_int n, iw[POOL];
static double rw[POOL];
static mesh M;

enum {
    UNIFORM, BALL, PATCH, SCALES, LATTICE, FLAT, PLANE, ANYWHERE, STRETCHED,
    APART, LASTPLACES, MIXED_ONES, SURFACES, CLASSES
};
static const char *const names[CLASSES] = {
    "uniform", "near one sphere", "near one large sphere",
    "clusters of all sizes", "lattice moved by last places",
    "near a plane", "in a plane but for a few", "all exponents",
    "stretched along the axes", "a narrow cluster far away",
    "a lattice of last places",
    "several kinds in one set",
    "near planes and spheres"
};

static long faults;
static int class;
static unsigned long seed;

static void fail(const char *what)
{
    if (faults++ < 5)
        printf("    %s: %s, %ld points, seed %lu\n", names[class], what,
               (long)n, seed);
}

static void require(int holds_good, const char *what)
{
    if (!holds_good) fail(what);
}

#ifdef TESS_PROVE
void tess_prove(int fact)
{
    require(fact, "a certificate");
}
#endif

/* ---- points ---- */

static double sym(void) { return 2.0 * rnd_unit() - 1.0; }

static double power(int e) { return ldexp(1.0, e); }

static void any_direction(double *u)
{
    double length;

    do {
        u[0] = sym();
        u[1] = sym();
        u[2] = sym();
        length = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
    } while (length > 1.0 || length < 0.01);
    length = sqrt(length);
    u[0] /= length;
    u[1] /= length;
    u[2] /= length;
}

/* Points first ... last-1 of a class, at most about 1. */
static void make(int kind, double (*p)[3], int first_one, int last_one)
{
    double c[3], u[3], r = power(-rnd_below(20)), noise;
    double base[4][3], size[4];
    int i, j, k, axis = rnd_below(3), bits = 20 + rnd_below(36);

    for (k = 0; k < 3; k++) c[k] = rnd_below(3) ? sym() * (1.0 - r) : 0.0;
    for (j = 0; j < 4; j++) {
        size[j] = power(-rnd_below(rnd_below(2) ? 40 : 400));
        for (k = 0; k < 3; k++) base[j][k] = j == 0 ? 0.0 : sym();
    }
    noise = power(-bits);
    for (i = first_one; i < last_one; i++)
        switch (kind) {
        case UNIFORM:
            for (k = 0; k < 3; k++) p[i][k] = sym();
            break;
        case BALL:
            any_direction(u);
            for (k = 0; k < 3; k++)
                p[i][k] = c[k] + r * u[k] * (1.0 + noise * sym());
            break;
        case PATCH:
            /* a paraboloid, which is near to a ball at its top */
            for (k = 0; k < 3; k++) u[k] = sym();
            u[axis] = (u[(axis + 1) % 3] * u[(axis + 1) % 3] +
                       u[(axis + 2) % 3] * u[(axis + 2) % 3]) * r +
                      noise * sym();
            for (k = 0; k < 3; k++) p[i][k] = c[k] + 0.125 * u[k];
            break;
        case SCALES:
            j = rnd_below(4);
            for (k = 0; k < 3; k++) p[i][k] = base[j][k] + size[j] * sym();
            break;
        case LATTICE:
            for (k = 0; k < 3; k++)
                p[i][k] = 0.125 * (rnd_below(7) - 3) +
                          0.25 * DBL_EPSILON * (rnd_below(3) - 1);
            break;
        case FLAT:
            for (k = 0; k < 3; k++) p[i][k] = sym();
            p[i][axis] = noise * sym() + (bits % 2 ? p[i][(axis + 1) % 3] : 0);
            break;
        case PLANE:
            for (k = 0; k < 3; k++) p[i][k] = 0.0625 * (rnd_below(33) - 16);
            if (i % 16) p[i][axis] = 0.5;
            break;
        case ANYWHERE:
            for (k = 0; k < 3; k++)
                p[i][k] = sym() * power(-rnd_below(bits % 2 ? 60 : 1000));
            break;
        case STRETCHED:
            for (k = 0; k < 3; k++)
                p[i][k] = sym() * power(-((bits * (k + 1)) % 64));
            break;
        case LASTPLACES:
            for (k = 0; k < 3; k++)
                p[i][k] = i % 16 ? 1.0 - DBL_EPSILON * rnd_below(7)
                                 : 0.5 * rnd_below(2);
            break;
        default:
            for (k = 0; k < 3; k++)
                p[i][k] = i % 16 ? 1.0 - 0.5 * r + 0.25 * r * sym()
                                 : sym();
            break;
        }
}

/* A set of points of a class; its positions and its tree.  Scaled by a power
 * of two, it may lose in M.x what P has. */
static int set_up(void)
{
    static double p[MOST][3];
    /* volatile: rounded to a tess_real, whatever a register holds */
    volatile tess_real rounded;
    int shift = rnd_below(4) ? 0 : rnd_below(2) ? 600 : -600;
    int i, k, parts = class == MIXED_ONES ? 4 : 1;

    n = (tess_int)(12 + rnd_below(MOST - 12));
    if (rnd_below(2)) n = n / 3 + 6;
    if (class == APART) n = n / 4 + 6;
    if (class == SURFACES)
        n = (tess_int)hard_near(p, MOST);
    else for (i = 0; i < parts; i++)
        make(class == MIXED_ONES ? rnd_below(MIXED_ONES) : class, p,
             (int)n * i / parts, (int)n * (i + 1) / parts);
    if (sizeof(tess_real) < sizeof(double)) shift /= 8;
    for (i = 0; i < (int)n; i++)
        for (k = 0; k < 3; k++) {
            rounded = (tess_real)ldexp(p[i][k], shift);
            point_of[3 * i + k] = rounded;
        }
    if (sorted(&M, n, point_of, iw, rw) != 0) return 0;
    M.link = M.alive + 2 * leafcount(n);
    M.reach = BLOCKREACH / 5.4;
    for (i = 0; i < (int)M.np; i++) {
        M.link[i] = NEW;
        for (k = 0; k < 3; k++)
            P[i][k] = (double)point_of[3 * M.order[i] + k];
    }
    return M.np > 5;
}

/* ---- what is true ---- */

static char ahead[MOST];     /* uncompleted, on the positive side */
static char candidate[MOST]; /* and in the ball of the best one, or on it */
static char beats[MOST];     /* and better than it */

static int living(tess_int i) { return M.link[i] != DONE; }

static void truth(const tess_int *v, tess_int best)
{
    const double *q[5];
    int index[5], k, s;
    tess_int i;

    for (i = 0; i < M.np; i++) {
        ahead[i] = candidate[i] = beats[i] = 0;
        if (!living(i) || i == v[0] || i == v[1] || i == v[2]) continue;
        ahead[i] = ex_orient(P[v[0]], P[v[1]], P[v[2]], P[i]) > 0;
        candidate[i] = ahead[i];
        if (!ahead[i] || best == NONE) continue;
        if (i == best) continue;
        for (k = 0; k < 5; k++) {
            tess_int at = k < 3 ? v[k] : k == 3 ? best : i;

            q[k] = P[at];
            index[k] = (int)M.order[at];
        }
        s = ex_insphere(q[0], q[1], q[2], q[3], q[4]);
        candidate[i] = s >= 0;
        /* for a positive tetrahedron a negative sign is inside */
        if (s == 0) s = -ex_perturbed(q, index);
        beats[i] = s > 0;
    }
}

/* ---- the lists ---- */

/* The sign of the distance from a to b, less than limit or not: exactly. */
static int nearer(const double *a, const double *b, double limit)
{
    static ex_num d[3], x, y, sum, square;
    int k, low = ex_low(limit, EX_NO_LOW);

    for (k = 0; k < 3; k++) low = ex_low(a[k], ex_low(b[k], low));
    for (k = 0; k < 3; k++) {
        ex_real(&x, a[k], low);
        ex_real(&y, b[k], low);
        ex_sub(&d[k], &x, &y);
    }
    ex_dot(&sum, d, d);
    ex_real(&x, limit, low);
    ex_copy(&y, &x);
    ex_mul(&square, &x, &y);
    return ex_cmp(&sum, &square) < 0;
}

static char listed[MOST];

static void note(const list *l)
{
    int i;

    memset(listed, 0, sizeof listed);
    for (i = 0; i < l->n; i++) listed[l->id[i]] = 1;
}

/* What a coordinate of a list may be: its bound, but for single precision. */
static double bound(const list *l, int k)
{
    return l->most[k] * (1.0 + 4.0 * FEPS) + FLT_MIN;
}

static void check_lists(tess_int s)
{
    const list *l = &M.block, *g = &M.around;
    const double *x;
    tess_int i;
    int k, inside;

    require(l->first <= s && s < l->last, "the block is another leaf's");
    if (l->n > 0) {
        note(l);
        for (i = 0; i < M.np; i++) {
            x = M.x + 3 * i;
            for (inside = 1, k = 0; k < 3; k++)
                if (x[k] < l->lo[k] || x[k] > l->hi[k]) inside = 0;
            if (inside && living(i))
                require(listed[i], "a point of the box is not in the block");
        }
        for (i = 0; i < l->n; i++)
            if (living(l->id[i]) &&
                (fabs((double)l->x[i]) > bound(l, 0) ||
                 fabs((double)l->y[i]) > bound(l, 1) ||
                 fabs((double)l->z[i]) > bound(l, 2)))
                fail("a coordinate of the block is above its bound");
        for (k = 0; k < 3; k++)
            /* 1 but for the rounding of the box's centre */
            require(l->most[k] <= 1.0 + 2.0 * EPS * (1.0 + l->unit),
                    "a bound above 1");
    }
    if (g->n == 0) return;
    note(g);
    for (i = 0; i < M.np; i++)
        if (living(i) && !listed[i])
            require(!nearer(M.x + 3 * i, M.x + 3 * s, g->margin),
                    "a point near the star is not in its list");
    for (i = 0; i < g->n; i++)
        if (living(g->id[i]))
            require(nearer(M.x + 3 * g->id[i], M.x + 3 * s,
                           1.1 * g->margin), "a star's point is too far");
}

/* ---- the searches ---- */

/* No candidate of the list, and none of the four that are counted on, is
 * left out. */
static void check_filter(const quest *f, const list *l, const float *d,
                         const char *what)
{
    int in[TESS_LIST], i, sum = 0, count = inball(l, d, in);

    /* what has left the list, and what fills up its last four, never pass */
    for (i = 0; i < (l->n + 3) / 4 * 4; i++)
        if (l->r[i] >= FAR) require(!in[i], "a point that is no more there");
    for (i = 0; i < l->n; i++) {
        tess_int z = l->id[i];

        sum += in[i] != 0;
        if (living(z) && (candidate[z] || z == f->best || z == f->v[0] ||
                          z == f->v[1] || z == f->v[2]))
            require(in[i], what);
    }
    require(sum == count, "filter counts wrong");
}

/* Is a candidate not in the list? */
static int missed(const list *l)
{
    tess_int i;

    note(l);
    for (i = 0; i < M.np; i++)
        if (candidate[i] && !listed[i]) return 1;
    return 0;
}

static long balls, inside_star, inside_block, boxes_out, boxes_back;

/* A ball so large that single precision has no more room: either there is no
 * test, or none of those that have left the list pass it. */
static void check_large(const quest *of)
{
    quest f = *of;
    float d[4];
    int in[TESS_LIST], i, k, e = rnd_below(80);
    const list *l = &M.block, *g = &M.around;

    f.size = 0.0;
    for (k = 0; k < 3; k++) {
        f.c[k] = ldexp(sym(), e);
        f.size += fabs(f.c[k]);
    }
    f.dc = ldexp(f.size, -50);
    if (l->n > 0 && ballcoef(l, &f, f.c, d)) {
        inball(l, d, in);
        for (i = 0; i < (l->n + 3) / 4 * 4; i++)
            require(l->r[i] < FAR || !in[i], "aim: a large ball");
    }
    if (g->n > 0 && starcoef(g, &f, d)) {
        inball(g, d, in);
        for (i = 0; i < (g->n + 3) / 4 * 4; i++)
            require(g->r[i] < FAR || !in[i], "starcoef: a large ball");
    }
}

/* No point of a box is farther than lowest says, but for rounding. */
static void check_spread(const quest *f)
{
    tess_int node, i, from, to;
    double size, most;
    int k;

    for (node = 1; node < 2 * M.leaves; node++) {
        const double *b = M.box + 6 * node;

        (void)lowest(f, b, b + 3, 0.0, f->f, &most);
        span(&M, node, &from, &to);
        for (i = from; i < to; i++) {
            for (k = 0, size = 0.0; k < 3; k++)
                size += fabs(M.x[3 * i + k] - f->f[6 + k]);
            require(size <= most * (1.0 + 8.0 * EPS),
                    "lowest: a point is farther");
        }
    }
}

/* What prunebox says of the tree's boxes. */
static void check_boxes(const quest *f)
{
    tess_int node, i, from, to;

    for (node = 1; node < 2 * M.leaves; node++) {
        const double *b = M.box + 6 * node;

        if (!prunebox(f, b, b + 3)) continue;
        if (f->ball) boxes_out++;
        else boxes_back++;
        span(&M, node, &from, &to);
        for (i = from; i < to; i++)
            require(!candidate[i], "prunebox: a candidate is in the box");
    }
    /* boxes of single points and of pairs are the hardest */
    for (i = 0; i + 1 < M.np; i++) {
        double lo[3], hi[3];
        const double *x = M.x + 3 * i;
        int k;

        if (candidate[i])
            require(!prunebox(f, x, x), "prunebox: a candidate is the box");
        for (k = 0; k < 3; k++) {
            lo[k] = x[k] < x[3 + k] ? x[k] : x[3 + k];
            hi[k] = x[k] < x[3 + k] ? x[3 + k] : x[k];
        }
        if (candidate[i] || candidate[i + 1])
            require(!prunebox(f, lo, hi), "prunebox: a candidate is in the pair");
    }
}

static void check_ball(quest *f)
{
    float d[4];

    balls++;
    truth(f->v, f->best);
    check_boxes(f);
    if (M.around.n > 0 && f->base == 0) {
        if (starcoef(&M.around, f, d))
            check_filter(f, &M.around, d, "starcoef: a candidate is left out");
        if (ballinstar(&M, f)) {
            inside_star++;
            require(!missed(&M.around), "within: a candidate is elsewhere");
        }
    }
    if (M.block.n > 0) {
        if (ballcoef(&M.block, f, f->c, d))
            check_filter(f, &M.block, d, "aim: a candidate is left out");
        if (ballinbox(&M, f, &M.block)) {
            inside_block++;
            require(!missed(&M.block), "ballinbox: a candidate is elsewhere");
        }
    }
}

/* That z, found for f, is not beaten. */
static void check_best(const tess_int *v, tess_int z, const char *what)
{
    tess_int i;

    truth(v, z);
    if (z != NONE && (z < 0 || z >= M.np || !ahead[z])) {
        fail(what);
        return;
    }
    for (i = 0; i < M.np; i++)
        require(z == NONE ? !ahead[i] : !beats[i], what);
}

static tess_int some(void)
{
    tess_int i, tries = 0;

    do
        i = (tess_int)rnd_below((int)M.np);
    while (!living(i) && tries++ < 1000);
    return i;
}

/* One facet at s: vertices near it, or anywhere. */
static void check_facet(tess_int s)
{
    tess_int v[3], guess[2], z, tries;
    quest f;

    v[0] = s;
    v[1] = some();
    v[2] = some();
    if (rnd_below(2) && M.around.n > 2) {
        v[1] = M.around.id[rnd_below(M.around.n)];
        v[2] = M.around.id[rnd_below(M.around.n)];
    }
    if (v[1] == s || v[2] == s || v[1] == v[2] || !living(v[1]) ||
        !living(v[2]) || ex_collinear(P[v[0]], P[v[1]], P[v[2]]))
        return;
    prepare(&M, &f, v);
    truth(v, NONE);
    check_boxes(&f);
    check_spread(&f);
    check_large(&f);
    for (tries = 0; tries < 4; tries++) {
        z = some();
        if (!ahead[z] || z == f.best) continue;
        challenge(&M, &f, z);
        if (f.best != NONE && f.ball) check_ball(&f);
        truth(v, NONE);
    }
    /* the same by routines that go to the end: from any start */
    treesearch(&M, &f);
    check_best(v, f.best, "search: a better point");
    if (f.best != NONE && f.ball) check_ball(&f);
    prepare(&M, &f, v);
    treesearch(&M, &f);
    check_best(v, f.best, "search without a ball: a better point");
    guess[0] = rnd_below(2) ? NONE : some();
    guess[1] = rnd_below(2) ? NONE : some();
    M.nplane = M.nextplane = 0;
    check_best(v, apex(&M, v, guess), "apex: a better point");
}

static void round_of(void)
{
    tess_int s, i;
    int stars_of, k, dead;

    if (!set_up()) return;
    for (stars_of = 0; stars_of < 4; stars_of++) {
        s = some();
        if (!living(s)) return;
        starlist(&M, s);
        check_lists(s);
        for (k = 0; k < 4 && faults < 20; k++) check_facet(s);
        complete(&M, s);
        /* a leaf may be all complete, too */
        dead = rnd_below(3) ? rnd_below(6) : (int)M.np / 4;
        for (k = 0; k < dead; k++) {
            i = rnd_below(2) ? some() : (s + k) % M.np;
            if (!living(i)) continue;
            complete(&M, i);
            /* a block keeps what others complete: it is no candidate any
             * more there, but may be one here */
            if (i < M.block.first || i >= M.block.last)
                M.block.first = M.block.last = NONE;
        }
        for (i = 0, k = 0; i < M.np; i++) k += living(i);
        if (k < 5) return;
    }
}

static long rounds = 40;
static unsigned long first_seed = 1;

static void all(void)
{
    long i;

    for (class = 0; class < CLASSES; class++) {
        faults = 0;
        balls = inside_star = inside_block = boxes_out = boxes_back = 0;
        for (i = 0; i < rounds && faults < 20; i++) {
            seed = first_seed + (unsigned long)(i * CLASSES + class);
            rnd_seed(seed);
            round_of();
        }
        printf("        %ld balls, %ld within the star's list, %ld in the "
               "block's, %ld boxes outside, %ld behind\n", balls, inside_star,
               inside_block, boxes_out, boxes_back);
        test_result(names[class], faults);
    }
}

int main(int argc, char **argv)
{
    if (argc > 1) rounds = atol(argv[1]);
    if (argc > 2) first_seed = (unsigned long)atol(argv[2]);
    test_modes(all);
    return test_end("t_margin");
}
