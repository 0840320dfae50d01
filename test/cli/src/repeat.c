/* repeat.c - points in a cell that repeats itself, by -periodic: the mesh of
 * them and all their copies; of it one tetrahedron of each class, to be
 * written; and so much about the cell as a value there depends on.
 *
 * Lengths are those of the stretched points, by -scale, if not said.
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../recipes/recipes.h"
#include "driver.h"
#include "values.h"

#define FARTHEST 1e9  /* cells that a point may be away          */
#define ROUNDING 1e-12 /* of a cell, by which a point is in it   */
#define FEW 8         /* planes of the hull that are looked at   */

static repeated rep;
static double given[12];  /* the cell as it is given: vectors, corner */

const repeated *repetition(void)
{
    return &rep;
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- the cell ---- */

void check_box(const points *in)
{
    int k, ways = 0;

    if (!chosen.periodic) {
        if (chosen.cells && !chosen.boxed && in->lattice == SKEW)
            warn("%s: its Lattice is not a box along x, y, z: the cells fill "
                 "the points' box", in->input);
        return;
    }
    if (!chosen.boxed && in->lattice == NO_LATTICE)
        fail("-periodic needs -box X0,X1,Y0,Y1,Z0,Z1, or an extended XYZ file "
             "with a Lattice, a LAMMPS dump, or a PDB file with CRYST1");
    for (k = 0; k < 3; k++) {
        rep.ways[k] = in->lattice == NO_LATTICE || in->ways[k];
        ways += (int)rep.ways[k];
    }
    if (ways == 0)
        fail("%s: -periodic: its pbc says that nothing repeats itself",
             in->input);
    if (ways < 3 && chosen.boxed)
        fail("%s: -periodic: its pbc says that nothing repeats itself along "
             "all axes, as a -box does: leave one of them out", in->input);
    if (chosen.validate)
        fail("-validate is of the points alone: leave out -periodic");
    if (chosen.plane)
        fail("-periodic is for points in space, not for those in a plane");
    for (k = 0; k < 12; k++) given[k] = in->cell[k];
    for (k = 0; k < 12 && chosen.boxed; k++)
        given[k] = k > 8        ? chosen.box[2 * k - 18]
                   : k % 4 == 0 ? chosen.box[k / 2 + 1] - chosen.box[k / 2]
                                : 0.0;
    for (k = 0; k < 12; k++)
        if (!(fabs(given[k]) <= DBL_MAX))
            fail("-periodic: the box is not finite");
}

void cell_box(double *box)
{
    double low, high;
    int j, k;

    for (k = 0; k < 3; k++) {
        low = high = given[9 + k];
        for (j = 0; j < 3; j++)
            *(given[3 * j + k] < 0.0 ? &low : &high) += given[3 * j + k];
        if (!(low < high)) continue;
        box[2 * k] = low;
        box[2 * k + 1] = high;
    }
}

/* inverted - g as rep.inverse is, of a cell; its vectors' determinant. */
static double inverted(const double *cell, double *g)
{
    double u[9], most = 0.0, det;
    int k;

    for (k = 0; k < 9; k++)
        if (fabs(cell[k]) > most) most = fabs(cell[k]);
    for (k = 0; k < 9; k++) u[k] = cell[k] / most;
    for (k = 0; k < 3; k++)
        normal_to(u + 3 * ((k + 1) % 3), u + 3 * ((k + 2) % 3), g + 3 * k);
    det = dot(u, g);
    for (k = 0; k < 9; k++) g[k] = g[k] / det / most;
    return det * most * most * most;
}

/* upright - make the vectors along which nothing repeats itself such as are at
 * right angles to the others: their planes stay.  Where they are none, choose
 * some: then the cell has no sides there. */
static void upright(double *v, const tess_int *ways)
{
    double n[3], s;
    int a, b, j, k, open = 0;

    for (k = 0; k < 3; k++) open += !ways[k];
    rep.sides = 1;
    for (k = 0; k < 3; k++) {
        if (ways[k]) continue;
        a = (k + 1) % 3;
        b = (k + 2) % 3;
        if (open == 1) {
            normal_to(v + 3 * a, v + 3 * b, n);
            s = dot(n, n);
            s = s > 0.0 ? dot(n, v + 3 * k) / s : 0.0;
            if (!(s * s * dot(n, n) > 1e-12 * dot(v + 3 * k, v + 3 * k)))
                rep.sides = 0;
            for (j = 0; j < 3; j++)
                v[3 * k + j] = n[j] * (rep.sides ? s : 1.0);
        } else {
            if (!ways[a]) a = b;
            s = dot(v + 3 * a, v + 3 * k) / dot(v + 3 * a, v + 3 * a);
            for (j = 0; j < 3; j++) v[3 * k + j] -= s * v[3 * a + j];
        }
    }
    if (open < 2) return;
    for (a = 0; !ways[a];) a++;
    b = (a + 1) % 3;
    k = (a + 2) % 3;
    normal_to(v + 3 * b, v + 3 * k, n);
    if (dot(n, n) > 1e-12 * dot(v + 3 * b, v + 3 * b) *
                        dot(v + 3 * k, v + 3 * k)) return;
    rep.sides = 0;
    for (s = 0.0, j = 0; j < 3; j++) n[j] = 0.0;
    for (j = 0; j < 3; j++)
        if (fabs(v[3 * a + j]) < fabs(v[3 * a + (int)s])) s = j;
    n[(int)s] = 1.0;
    normal_to(v + 3 * a, n, v + 3 * b);
    normal_to(v + 3 * a, v + 3 * b, v + 3 * k);
}

static void no_vectors(void)
{
    fail("-periodic: the box's vectors are in a plane, or 0, or too large or "
         "small: use other units, as by -scale");
}

/* begin_cell - rep's, and the points near it. */
static void begin_cell(const mesh *m)
{
    double g[9], x[3], s;
    tess_int i, moved = 0;
    int j, k, out;

    for (k = 0; k < 12; k++) rep.cell[k] = given[k] * m->scale[k % 3];
    rep.volume = fabs(inverted(given, g));
    inverted(rep.cell, g);
    tr_reduce(rep.cell, rep.ways);
    upright(rep.cell, rep.ways);
    s = inverted(rep.cell, rep.inverse);
    if (!(fabs(s) > 0.0)) no_vectors();
    rep.at = (tess_real *)space(3.0 * (double)m->in->n, sizeof *rep.at);
    rep.away = (int *)space(3.0 * (double)m->in->n, sizeof *rep.away);
    for (i = 0; i < m->in->n; i++) {
        for (k = 0; k < 3; k++)
            x[k] = (double)m->p[3 * i + k] - rep.cell[9 + k];
        for (out = k = 0; k < 3; k++) {
            s = dot(g + 3 * k, x);
            if (s < -ROUNDING || s > 1.0 + ROUNDING) {
                if (rep.ways[k]) out = 1;
                else rep.beyond++;
            }
            s = dot(rep.inverse + 3 * k, x);
            if (!(fabs(s) < FARTHEST) && rep.ways[k])
                fail("-periodic: point %ld is more than %g boxes away",
                     (long)(i + m->in->base), FARTHEST);
            rep.away[3 * i + k] =
                rep.ways[k] && (s < -ROUNDING || s > 1.0 + ROUNDING)
                    ? -(int)floor(s) : 0;
        }
        moved += out;
        for (k = 0; k < 3; k++) {
            x[k] += rep.cell[9 + k];
            for (j = 0; j < 3; j++)
                x[k] += rep.away[3 * i + j] * rep.cell[3 * j + k];
            rep.at[3 * i + k] = (tess_real)x[k];
        }
    }
    if (moved > 0)
        warn("%ld point%s outside the box: taken where the box's copies bring "
             "them into it", (long)moved, moved > 1 ? "s are" : " is");
}

/* ---- the mesh ---- */

static tess_int *integers(double many)
{
    return (tess_int *)space(many, sizeof(tess_int));
}

/* attempt - make the mesh, with room for so many copies of points and so many
 * tetrahedra, and so many times the usual pool of facets.  Returns
 * tr_triclinic's code. */
static int attempt(tess_int n, double maxcop, double maxtet, double pool,
                   tess_int *ncop)
{
    tess_int *cw, *iw, liw = 0, lrw = 0;
    double *rw;
    tess_real *x;
    int code;

    if (maxtet > (double)TESS_INT_MOST / 4.0 - 1.0 ||
        maxcop > (double)TESS_INT_MOST / 4.0 - 1.0 ||
        tess_size((tess_int)maxcop, (tess_int)maxtet, &liw, &lrw) != 0 ||
        pool * (double)liw > (double)TESS_INT_MOST)
        too_small("-periodic: more tetrahedra than a tess_int can number");
    liw = (tess_int)(pool * (double)liw);
    x = (tess_real *)space(3.0 * maxcop, sizeof *x);
    cw = integers(3.0 * maxcop);
    rep.tet = integers(4.0 * maxtet);
    rep.move = integers(4.0 * maxtet);
    rep.adj = integers(4.0 * maxtet);
    rep.shift = integers(4.0 * maxtet);
    iw = integers((double)liw);
    rw = (double *)space((double)lrw, sizeof *rw);
    code = tr_triclinic(n, rep.at, rep.cell, rep.ways, (tess_int)maxcop, ncop,
                        x, cw, (tess_int)maxtet, &rep.ntet, rep.tet, rep.move,
                        rep.adj, rep.shift, liw, iw, lrw, rw);
    free(x);
    free(cw);
    free(iw);
    free(rw);
    return code;
}

/* make_repeated - the mesh, with as much room as it needs; or the code for
 * points in a plane, or on a line. */
static int make_repeated(const points *in)
{
    double maxcop = 3.0 * (double)in->n + 1000.0, pool = 1.0;
    double maxtet = 10.0 * (double)in->n + 1000.0;
    tess_int ncop = 0;
    int code;

    while ((code = attempt(in->n, maxcop, maxtet, pool, &ncop)) != 0) {
        if (code == TESS_PLANE || code == TESS_LINE) return code;
        free(rep.tet);
        free(rep.move);
        free(rep.adj);
        free(rep.shift);
        if (code == -3) no_vectors();
        if (code == TR_FEW)
            fail("-periodic: so few points in so long a box that tetrahedra "
                 "reach across many copies of it; repeat the points along its "
                 "short sides");
        if (code == TESS_RANGE)
            fail("-periodic: the box is so large or small that its copies "
                 "cannot be numbers: use other units, as by -scale");
        if (code != TESS_MORE && code != TESS_POOL)
            too_small("-periodic: unexpected code %d", code);
        if (code == TESS_POOL)
            pool *= 2.0;
        else if ((double)ncop >= maxcop)
            maxcop *= 2.0;
        else
            maxtet *= 2.0;
    }
    return 0;
}

/* corner_away - how many of the vectors corner f % 4 of tetrahedron f / 4 is
 * away from the point as it is given, if the first corner is there. */
static void corner_away(tess_int f, int *a)
{
    tess_int first = f / 4 * 4;
    int b[3], k;

    tr_unpack(rep.move[f], a);
    tr_unpack(rep.move[first], b);
    for (k = 0; k < 3; k++)
        a[k] += rep.away[3 * rep.tet[f] + k] - b[k] -
                rep.away[3 * rep.tet[first] + k];
}

/* joined - does the tetrahedron across facet f share it where both are
 * written? */
static int joined(tess_int f)
{
    tess_int t = f / 4 * 4, u = 4 * rep.adj[f];
    int s[3], a[3], b[3], k, same = 1;

    if (u < 0) return 0;
    tr_unpack(rep.shift[f], s);
    tr_unpack(rep.move[t], a);
    tr_unpack(rep.move[u], b);
    for (k = 0; k < 3; k++)
        same &= s[k] == a[k] + rep.away[3 * rep.tet[t] + k] - b[k] -
                            rep.away[3 * rep.tet[u] + k];
    return same;
}

/* write_once - make *m the tetrahedra that are written, one of each class, with
 * the copies of points that they need behind the points. */
static void write_once(mesh *m)
{
    static points more;
    const points *in = m->in;
    size_t columns = (size_t)in->columns;
    double x, room = (double)in->n + 1000.0;
    tess_int *head = integers((double)in->n), *next = integers(room);
    tess_int *who = integers(room), f, i;
    int *copy = (int *)space(3.0 * room, sizeof *copy), a[3], j, k;
    tess_real *p = 0;

    more = *in;
    for (i = 0; i < in->n; i++) head[i] = TESS_NONE;
    m->ntet = m->maxtet = rep.ntet;
    m->tet = integers(4.0 * (double)rep.ntet);
    m->adj = integers(4.0 * (double)rep.ntet);
    for (f = 0; f < 4 * rep.ntet; f++) {
        m->adj[f] = joined(f) ? rep.adj[f] : TESS_NONE;
        m->tet[f] = i = rep.tet[f];
        corner_away(f, a);
        if (a[0] == 0 && a[1] == 0 && a[2] == 0) continue;
        for (i = head[i]; i != TESS_NONE &&
                          memcmp(copy + 3 * i, a, sizeof a) != 0;)
            i = next[i];
        if (i == TESS_NONE) {
            i = more.n - in->n;
            if ((double)i >= room) {
                room *= 2.0;
                next = (tess_int *)more_space(next, room, sizeof *next);
                who = (tess_int *)more_space(who, room, sizeof *who);
                copy = (int *)more_space(copy, 3.0 * room, sizeof *copy);
            }
            memcpy(copy + 3 * i, a, sizeof a);
            who[i] = rep.tet[f];
            next[i] = head[who[i]];
            head[who[i]] = i;
            more.n++;
        }
        m->tet[f] = i + in->n;
    }
    more.p = (tess_real *)space(3.0 * (double)more.n, sizeof *more.p);
    more.value = (double *)space((double)columns * (double)more.n,
                                 sizeof *more.value);
    if (chosen.scaled) p = (tess_real *)space(3.0 * (double)more.n, sizeof *p);
    for (i = 0; i < more.n; i++) {
        f = i < in->n ? i : who[i - in->n];
        for (k = 0; k < 3; k++) {
            x = (double)in->p[3 * f + k];
            for (j = 0; j < 3 && i >= in->n; j++)
                x += copy[3 * (i - in->n) + j] * rep.cell[3 * j + k] /
                     m->scale[k];
            more.p[3 * i + k] = (tess_real)x;
            if (p) p[3 * i + k] = (tess_real)(x * m->scale[k]);
        }
        if (columns > 0)
            memcpy(more.value + columns * (size_t)i,
                   in->value + columns * (size_t)f,
                   columns * sizeof *more.value);
    }
    m->in = &more;
    m->p = p ? p : more.p;
    free(head);
    free(next);
    free(who);
    free(copy);
}

int repeat(mesh *m, tess_int *duplicates)
{
    char *seen = (char *)space((double)m->in->n, 1);
    tess_int i;
    int code;

    rep.of = *m;
    begin_cell(m);
    code = make_repeated(m->in);
    if (code != 0 && (chosen.values || chosen.cells))
        fail("%s: the points and all their copies lie in one plane: no %s",
             m->in->input, chosen.values ? "values between them" : "cells");
    memset(seen, 0, (size_t)m->in->n);
    for (i = 0; i < 4 * rep.ntet; i++) seen[rep.tet[i]] = 1;
    for (*duplicates = i = 0; i < m->in->n && code == 0; i++)
        *duplicates += !seen[i];
    free(seen);
    write_once(m);
    return code;
}

/* ---- values ---- */

void into_cell(tess_real *q)
{
    double x[3], s[3];
    int j, k;

    for (k = 0; k < 3; k++) x[k] = (double)q[k] - rep.cell[9 + k];
    for (k = 0; k < 3; k++)
        s[k] = rep.ways[k] ? floor(dot(rep.inverse + 3 * k, x)) : 0.0;
    for (k = 0; k < 3; k++) {
        for (j = 0; j < 3; j++)
            if (s[j] != 0.0) x[k] -= s[j] * rep.cell[3 * j + k];
        if (s[0] != 0.0 || s[1] != 0.0 || s[2] != 0.0)
            q[k] = (tess_real)(x[k] + rep.cell[9 + k]);
    }
}

/* corners - of tetrahedron t. */
static void corners(tess_int t, tess_real *v)
{
    int a[3], j, k, l;

    for (k = 0; k < 4; k++) {
        tr_unpack(rep.move[4 * t + k], a);
        for (l = 0; l < 3; l++) {
            v[3 * k + l] = rep.at[3 * rep.tet[4 * t + k] + l];
            for (j = 0; j < 3; j++)
                v[3 * k + l] = (tess_real)((double)v[3 * k + l] +
                                           a[j] * rep.cell[3 * j + l]);
        }
    }
}

/* hull_planes - some of the planes where the mesh ends: unit normals outwards
 * and offsets, at most FEW.  Returns how many. */
static int hull_planes(double (*plane)[4])
{
    tess_real v[12];
    double a[3], b[3], n[3], s;
    tess_int f;
    int j, k, many = 0;

    for (f = 0; f < 4 * rep.ntet && many < FEW; f++) {
        if (rep.adj[f] != TESS_NONE) continue;
        corners(f / 4, v);
        j = (int)(f % 4 + 1) % 4;
        for (k = 0; k < 3; k++) {
            a[k] = (double)v[3 * ((j + 1) % 4) + k] - (double)v[3 * j + k];
            b[k] = (double)v[3 * ((j + 2) % 4) + k] - (double)v[3 * j + k];
        }
        normal_to(a, b, n);
        s = sqrt(dot(n, n));
        for (k = 0; k < 3; k++) {
            a[k] = (double)v[3 * (f % 4) + k] - (double)v[3 * j + k];
            b[k] = (double)v[3 * j + k];
        }
        if (dot(a, n) > 0.0) s = -s;
        if (!(fabs(s) > 0.0)) continue;
        for (k = 0; k < 3; k++) n[k] /= s;
        for (j = 0; j < many && dot(plane[j], n) < 1.0 - 1e-9;) j++;
        if (j < many) continue;
        memcpy(plane[many], n, sizeof n);
        plane[many++][3] = dot(n, b);
    }
    return many;
}

/* reach - how far from a place in the cell that is which its value depends on,
 * by the method.  All points in the ball of a tetrahedron that holds it, and of
 * any whose ball holds it, are not farther than twice the largest radius; where
 * the mesh ends a ball's part within counts, which is as wide as the disc where
 * a plane cuts it.  Gradients depend on the tetrahedra about points that are
 * some edges away. */
static double reach(int smooth)
{
    double plane[FEW][4], c[4], radius = 0.0, edge = 0.0, d[3], out, s, r;
    tess_real v[12];
    tess_int t, number[4];
    int planes = hull_planes(plane), i, j, k;

    for (k = 0; k < 4; k++) number[k] = k;
    for (t = 0; t < rep.ntet; t++) {
        corners(t, v);
        if (tess_ball(v, number, c) != 0)
            too_small("-periodic: a tetrahedron's ball cannot be computed");
        r = c[3];
        for (k = 0; k < 3; k++) d[k] = (double)v[k] - c[k];
        for (i = 0; i < planes; i++) {
            out = dot(plane[i], c) - plane[i][3];
            if (!(out > 0.0)) continue;
            /* the square of the disc's radius, without differences of such */
            for (s = out + dot(plane[i], d), k = 0; k < 3; k++)
                c[k] = d[k] - dot(plane[i], d) * plane[i][k];
            if (s > 0.0) s = 0.0;
            s = sqrt(dot(c, c) - s * (out - dot(plane[i], d)));
            if (s < r) r = s;
            for (k = 0; k < 3; k++) c[k] = (double)v[k] - d[k];
        }
        if (r > radius) radius = r;
        for (i = 1; i < 4 && smooth; i++)
            for (j = 0; j < i; j++) {
                for (k = 0; k < 3; k++)
                    d[k] = (double)v[3 * i + k] - (double)v[3 * j + k];
                if (dot(d, d) > edge) edge = dot(d, d);
            }
    }
    return 1.001 * (2.0 * radius + (ROUNDS + 1) * sqrt(edge));
}

const mesh *repeat_around(int smooth)
{
    static mesh wide;
    static points around;
    const points *in = rep.of.in;
    size_t columns = (size_t)in->columns;
    double margin = reach(smooth), room = 0.0, x[3], s, t;
    tess_int i;
    int first[3], last[3], a[3], k, code;

    around = *in;
    wide = rep.of;
    wide.in = &around;
    around.p = 0;
    around.value = 0;
    around.n = 0;
    for (i = 0; i < in->n; i++) {
        for (k = 0; k < 3; k++)
            x[k] = (double)rep.at[3 * i + k] - rep.cell[9 + k];
        for (k = 0; k < 3; k++) {
            s = dot(rep.inverse + 3 * k, x);
            t = margin * sqrt(dot(rep.inverse + 3 * k, rep.inverse + 3 * k));
            if (rep.ways[k] && !(t < 1e4))
                fail("-periodic: values depend on points more than 10000 boxes "
                     "away; repeat the points along the box's short sides");
            first[k] = rep.ways[k] ? (int)ceil(-t - s) : 0;
            last[k] = rep.ways[k] ? (int)floor(1.0 + t - s) : 0;
        }
        for (a[0] = first[0]; a[0] <= last[0]; a[0]++)
            for (a[1] = first[1]; a[1] <= last[1]; a[1]++)
                for (a[2] = first[2]; a[2] <= last[2]; a[2]++) {
                    if ((double)around.n >= (double)TESS_INT_MOST / 20.0)
                        too_small("-periodic: values depend on more copies of "
                                  "points than a tess_int can number");
                    if ((double)around.n >= room) {
                        room = 2.0 * room + 1000.0;
                        around.p = (tess_real *)more_space(
                            around.p, 3.0 * room, sizeof *around.p);
                        around.value = (double *)more_space(
                            around.value, room * (double)columns,
                            sizeof *around.value);
                    }
                    for (k = 0; k < 3; k++)
                        around.p[3 * around.n + k] = (tess_real)(
                            (double)rep.at[3 * i + k] + a[0] * rep.cell[k] +
                            a[1] * rep.cell[3 + k] + a[2] * rep.cell[6 + k]);
                    memcpy(around.value + columns * (size_t)around.n,
                           in->value + columns * (size_t)i,
                           columns * sizeof *around.value);
                    around.n++;
                }
    }
    wide.p = around.p;
    wide.tet = wide.adj = wide.iw = 0;
    wide.rw = 0;
    wide.maxtet = wide.liw = wide.lrw = 0;
    code = tetrahedralize(&wide, around.n, around.p, !chosen.quiet);
    if (code != 0) too_small("-periodic: unexpected code %d", code);
    wide.kept = wide.ntet;
    return &wide;
}
