/* t_cells.c - the recipe tr_cell, where Voronoi vertices nearly coincide,
 * points do, or there are any: all cells are polyhedra, inside their planes,
 * and fill a box to 1e-12.  -quick: of a third of the families; -brief: but for
 * that which takes longest.
 *
 * With -DFORTRAN linked with twin/recipes.c and cells.f: TRCELL is tested
 * instead. */
#include <stdio.h>
#include <string.h>

#ifdef FORTRAN
#include <math.h>

#include "../recipes/recipes.h"
#else
#include "../recipes/cells.c"
#endif
#include "../lib/exact.h"
#include "../lib/points.h"

#define N 200
#define MAXTET (40 * N)
#define MOST (2 * N + 8)

static tess_real p[3 * N];
static tess_int n, ntet, tet[4 * MAXTET], adj[4 * MAXTET], iw[TESS_LIW(N)];
static tess_int first[N + 1], list[4 * MAXTET];
static tess_int nface, nvert, whose[MOST], start[MOST + 1], corner[6 * MOST];
static tess_int iwork[25 * MOST];
static double rw[TESS_LRW(N)], area[MOST], vert[9 * MOST], work[7 * MOST];
static double box[6];

static int one(tess_int i, const double *clip, double *volume)
{
    return tr_cell(p, tet, adj, first, list, i, clip, MOST, &nface, whose, area,
                   volume, start, corner, &nvert, vert, iwork, work);
}

/* mesh - of the points, and the tetrahedra at each. */
static int mesh(void)
{
    tess_int i;
    int code = tess(n, p, MAXTET, &ntet, tet, adj, TESS_LIW(N), iw,
                    TESS_LRW(N), rw);

    if (code != 0) return code;
    for (i = 0; i <= n; i++) first[i] = 0;
    for (i = 0; i < 4 * ntet; i++) first[tet[i]]++;
    for (i = 1; i <= n; i++) first[i] += first[i - 1];
    for (i = 4 * ntet - 1; i >= 0; i--) list[--first[tet[i]]] = i / 4;
    return 0;
}

/* sealed - by Euler's formula, each edge being there once in both directions,
 * and no vertex twice in a face. */
static int sealed(void)
{
    static char seen[6 * N][6 * N];
    tess_int a, b, f, j;
    int good = 2 * (nvert + nface) == 4 + start[nface] && nvert <= 6 * N;

    for (a = 0; a < nvert && good; a++)
        for (b = 0; b < nvert; b++) seen[a][b] = 0;
    for (f = 0; f < nface && good; f++)
        for (j = start[f]; j < start[f + 1]; j++) {
            a = corner[j];
            b = corner[j + 1 < start[f + 1] ? j + 1 : start[f]];
            if (a < 0 || a >= nvert || a == b || seen[a][b]++) return 0;
        }
    for (a = 0; a < nvert && good; a++)
        for (b = 0; b < a; b++)
            if (seen[a][b] != seen[b][a]) return 0;
    return good;
}

/* within - no vertex is outside the box, or beyond a neighbour's plane, but for
 * roundings of the box's size and place. */
static int within(tess_int i)
{
    double size = 0.0, h, r, e;
    tess_int f, j, v;
    int k;

    for (k = 0; k < 3; k++) {
        if (box[2 * k + 1] - box[2 * k] > size)
            size = box[2 * k + 1] - box[2 * k];
        if (fabs(box[2 * k]) > 1e3 * size) size = 1e-3 * fabs(box[2 * k]);
    }
    for (v = 0; v < nvert; v++) {
        for (k = 0; k < 3; k++)
            if (!(vert[3 * v + k] >= box[2 * k] - 1e-12 * size &&
                  vert[3 * v + k] <= box[2 * k + 1] + 1e-12 * size))
                return 0;
        for (f = 4 * first[i]; f < 4 * first[i + 1]; f++) {
            j = tet[4 * list[f / 4] + f % 4];
            if (j == i) continue;
            for (r = h = 0.0, k = 0; k < 3; k++) {
                e = (double)p[3 * j + k] - (double)p[3 * i + k];
                r += e * e;
                h += e * (vert[3 * v + k] - (double)p[3 * i + k] - e / 2.0);
            }
            if (!(h <= 1e-12 * size * sqrt(r))) return 0;
        }
    }
    return 1;
}

/* outer - has point i a facet on the hull? */
static int outer(tess_int i)
{
    tess_int f, g;

    for (f = 4 * first[i]; f < 4 * first[i + 1]; f++) {
        g = 4 * list[f / 4] + f % 4;
        if (tet[g] != i && adj[g] < 0) return 1;
    }
    return 0;
}

/* distant - has point i's cell a vertex 1e8 times as far as its neighbours, by
 * tess_ball? */
static int distant(tess_int i)
{
    double far = 0.0, most = 0.0, c[4], e;
    tess_int f;
    int k;

    for (f = first[i]; f < first[i + 1]; f++) {
        if (tess_ball(p, tet + 4 * list[f], c) == 0 && c[3] > most) most = c[3];
        for (k = 0; k < 12; k++) {
            e = fabs((double)p[3 * tet[4 * list[f] + k / 3] + k % 3] -
                     (double)p[3 * i + k % 3]);
            if (e > far) far = e;
        }
    }
    return most > 1e8 * far;
}

/* filled - all cells in the box; returns a sum of 1 for a code, 2 for what is
 * no polyhedron, 4 for a vertex too far off, 8 for volumes that do not fill
 * it. */
static int filled(void)
{
    double sum = 0.0, all = 1.0, volume, whole;
    tess_int i, f;
    int bad = 0, code, k;

    for (k = 0; k < 3; k++) all *= box[2 * k + 1] - box[2 * k];
    for (i = 0; i < n; i++) {
        if (one(i, box, &volume) != 0) return 1;
        if (iw[i] != i) {
            if (nface != 0 || volume != 0.0) bad |= 2;
            continue;
        }
        if (!sealed() || !(volume >= 0.0)) bad |= 2;
        for (f = 0; f < nface; f++)
            if (!(area[f] >= 0.0)) bad |= 2;
        if (!within(i)) bad |= 4;
        sum += volume;
        /* without the box the cell has no end, or what the box holds of it is
         * less */
        code = one(i, NULL, &whole);
        if (code != (outer(i) ? 2 : 0) && (code != 2 || !distant(i))) bad |= 1;
        if (code == 0 && !sealed()) bad |= 2;
        if (code == 0 && !(whole >= volume - 1e-12 * all)) bad |= 8;
    }
    return fabs(sum - all) <= 1e-12 * all ? bad : bad | 8;
}

static void told(const char *set, int bad)
{
    test_that(!(bad & 1), set, "codes");
    test_that(!(bad & 2), set, "polyhedra");
    test_that(!(bad & 4), set, "inside their planes and the box");
    test_that(!(bad & 8), set, "volumes fill the box to 1e-12");
}

/* turn - the points about no axis in particular. */
static void turn(void)
{
    tess_int i;
    double x, y, z;

    for (i = 0; i < n; i++) {
        x = (double)p[3 * i];
        y = (double)p[3 * i + 1];
        z = (double)p[3 * i + 2];
        p[3 * i] = (tess_real)(cos(0.7) * x - sin(0.7) * y);
        y = sin(0.7) * x + cos(0.7) * y;
        p[3 * i + 1] = (tess_real)(cos(0.4) * y - sin(0.4) * z);
        p[3 * i + 2] = (tess_real)(sin(0.4) * y + cos(0.4) * z);
    }
}

/* make - many points of a kind, about the origin. */
static void make(int kind, tess_int many)
{
    static const double finest[] = {3.0, 6.0, 12.0};
    double a, b, r;
    tess_real *x;
    int k;

    for (n = 0; n < many; n++) {
        x = p + 3 * n;
        b = 8.0 * atan(1.0) * rnd_unit();
        switch (kind) {
        case 0: /* on a sphere, the finer the nearer to its pole */
        case 1:
        case 2:
            a = pow(10.0, -finest[kind] * rnd_unit());
            x[0] = (tess_real)(sin(a) * cos(b));
            x[1] = (tess_real)(sin(a) * sin(b));
            x[2] = (tess_real)cos(a);
            break;
        case 3: /* anywhere on it */
            a = 2.0 * rnd_unit() - 1.0;
            x[0] = (tess_real)(sqrt(1.0 - a * a) * cos(b));
            x[1] = (tess_real)(sqrt(1.0 - a * a) * sin(b));
            x[2] = (tess_real)a;
            break;
        case 4: /* a grid, turned at the end, every third point by roundings */
            for (k = 0, a = (double)n; k < 3; k++, a = floor(a / 4.0))
                x[k] = (tess_real)((a - 4.0 * floor(a / 4.0) - 1.5) / 3.0 +
                                   (n % 3 == 0 ? 1e-15 * rnd_unit() : 0.0));
            break;
        case 5: /* pairs, of all distances down to duplicates */
            for (k = 0; k < 3; k++)
                x[k] = n % 2 ? x[k - 3] : (tess_real)(rnd_unit() - 0.5);
            if (n % 2)
                x[n / 2 % 3] = (tess_real)((double)x[n / 2 % 3] +
                                           pow(10.0, -18.0 * rnd_unit()));
            break;
        case 6: /* a circle and its axis */
            r = n % 2 ? 1.0 : 0.0;
            a = 8.0 * atan(1.0) * (double)n / (double)many;
            x[0] = (tess_real)(r * cos(a));
            x[1] = (tess_real)(r * sin(a));
            x[2] = (tess_real)(n % 2 ? 0.0 : (double)n / (double)many);
            break;
        default: /* about a plane, or a line, of all thicknesses */
            a = pow(10.0, -16.0 * rnd_unit());
            for (k = 0; k < 3; k++)
                x[k] = (tess_real)((rnd_unit() - 0.5) *
                                   (k < kind - 6 ? a : 1.0));
        }
    }
    if (kind > 3) turn();
}

/* A box so small that all its vertices are one but for 1e-13 of their distance:
 * the cells that reach into it are polyhedra all the same. */
static void speck(void)
{
    double volume;
    tess_int i;
    int k, some = 0, good;

    n = (tess_int)points_make("uniform", N, 1, p);
    good = mesh() == 0;
    for (k = 0; k < 6; k++) box[k] = 0.5 + (k % 2 ? ldexp(1.0, -48) : 0.0);
    for (i = 0; i < n && good; i++) {
        good = one(i, box, &volume) == 0 && (nface == 0 || sealed());
        some += nface > 0;
    }
    test_that(good && some > 0, "a speck", "polyhedra");
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int kind, sets;
        tess_int many;
    } set[] = {{"10 about a pole, to 1e-3", 0, 900, 10},
               {"12 about a pole, to 1e-3", 0, 300, 12},
               {"100 about a pole, to 1e-3", 0, 10, 100},
               {"12 about a pole, to 1e-6", 1, 100, 12},
               {"12 about a pole, to 1e-12", 2, 100, 12},
               {"100 about a pole, to 1e-12", 2, 10, 100},
               {"a sphere", 3, 10, 100},
               {"a turned grid", 4, 5, 64},
               {"pairs", 5, 100, 12},
               {"100 in pairs", 5, 20, 100},
               {"a circle and its axis", 6, 1, 60},
               {"about a plane", 7, 20, 50},
               {"about a line", 8, 20, 50}};
    const char *name;
    double low, high;
    tess_int i;
    int j, k, s, bad, quick = test_quick(argc, argv);

    /* among these are sets of which cells by the nearest planes first would be
     * no polyhedra */
    rnd_seed(1);
    for (j = 0; j < (int)(sizeof set / sizeof *set); j++) {
        for (k = 0; k < 6; k++) box[k] = k % 2 ? 2.0 : -2.0;
        for (bad = 0, s = 0; s < set[j].sets; s++) {
            make(set[j].kind, set[j].many);
            bad |= mesh() == 0 ? filled() : 1;
        }
        told(set[j].name, bad);
    }
    for (j = 0; (name = points_name(j)) != 0; j += quick ? 3 : 1) {
        if (quick > 1 && strcmp(name, "wide") == 0) continue;
        n = (tess_int)points_make(name, N, 1, p);
        if (n < 4 || mesh() != 0) continue;
        /* (the volumes of cells 1e30 long and of the others have no common sum
         * in doubles) */
        if (strncmp(name, "fill", 4) == 0 && strcmp(name, "fillcurve9") != 0)
            continue;
        for (k = 0; k < 3; k++) {
            low = high = (double)p[k];
            for (i = 1; i < n; i++) {
                if ((double)p[3 * i + k] < low) low = (double)p[3 * i + k];
                if ((double)p[3 * i + k] > high) high = (double)p[3 * i + k];
            }
            box[2 * k] = low - 0.125 * (high - low);
            box[2 * k + 1] = high + 0.25 * (high - low);
        }
        bad = filled();
        /* its coordinates go beyond doubles' volumes */
        if (strcmp(name, "wide") == 0) bad ^= 1;
        told(name, bad);
    }
    speck();
    return test_end();
}
