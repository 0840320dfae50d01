/* recipes.c - the recipes' calls that tests make, by way of FORTRAN, as shim.c:
 * tests in C linked with that, this and test/recipes/NAME.f in the place of
 * test/recipes/NAME.c.
 *
 * recipes77.h has the prototypes, which gfortran makes of the sources; see
 * check.sh. */
#include <stdlib.h>
#include <string.h>

#include "../lib/take.h"
#include "../recipes/recipes.h"
#include "count.h"
#include "recipes77.h"

/* How many points and tetrahedra there are, for the calls that are not told. */
static tess_int points, tets;

/* ---- derived.f ---- */

int tr_edges(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxedg, tess_int *nedge, tess_int *edge, tess_int *at)
{
    tess_int info;

    tets = ntet;
    both(tet, adj, ntet, 1);
    tredge_(&ntet, tet, adj, &maxedg, nedge, edge, at, &info);
    both(tet, adj, ntet, -1);
    if (info == 0) count(edge, 2 * *nedge, -1);
    if (info == 0) count(at, *nedge, -1);
    return (int)info;
}

int tr_faces(tess_int ntet, const tess_int *tet, const tess_int *adj,
             tess_int maxfac, tess_int *nface, tess_int *face, tess_int *beside)
{
    tess_int info;

    both(tet, adj, ntet, 1);
    trface_(&ntet, tet, adj, &maxfac, nface, face, beside, &info);
    both(tet, adj, ntet, -1);
    if (info == 0) count(face, 3 * *nface, -1);
    if (info == 0) count(beside, 2 * *nface, -1);
    return (int)info;
}

void tr_stars(tess_int n, tess_int ntet, const tess_int *tet, tess_int *first,
              tess_int *list)
{
    points = n;
    tets = ntet;
    count(tet, 4 * ntet, 1);
    trstar_(&n, &ntet, tet, first, list);
    count(tet, 4 * ntet, -1);
    count(first, n + 1, -1);
    count(list, 4 * ntet, -1);
}

tess_int tr_nearest(const tess_real *p, const tess_int *tet,
                    const tess_int *first, const tess_int *list,
                    const tess_real *q, tess_int v)
{
    tess_int by;

    for (by = 1; by >= -1; by -= 2) {
        count(tet, 4 * tets, by);
        count(first, points + 1, by);
        count(list, 4 * tets, by);
        count(&v, 1, by);
        if (by == 1) trnear_(p, tet, first, list, q, &v);
    }
    return v;
}

void tr_measure(const tess_real *p, const tess_int *v, double *volume,
                double *middle, double *radius)
{
    count(v, 4, 1);
    trmeas_(p, v, volume, middle, radius);
    count(v, 4, -1);
}

void tr_dual(tess_int n, const tess_real *p, const tess_int *tet,
             const tess_int *adj, tess_int nedge, const tess_int *edge,
             const tess_int *at, double *area, double *cell, tess_int *outer)
{
    tess_int by;

    for (by = 1; by >= -1; by -= 2) {
        both(tet, adj, tets, by);
        count(edge, 2 * nedge, by);
        count(at, nedge, by);
        if (by == 1)
            trdual_(&n, p, tet, adj, &nedge, edge, at, area, cell, outer);
    }
}

void tr_gradient(const tess_real *p, const tess_int *v, const double *value,
                 double *g)
{
    count(v, 4, 1);
    trgrad_(p, v, value, g);
    count(v, 4, -1);
}

/* ---- slopes.f ---- */

/* What slopes was given, counted from 1: bent, which is called at so many
 * places, is given it again. */
static const tess_int *given;
static tess_int *tet1, *adj1;

int tr_slopes(tess_int n, const tess_real *p, tess_int ntet,
              const tess_int *tet, const tess_int *adj, const double *value,
              int rounds, double *g, double *work)
{
    tess_int info, times = rounds;
    size_t many = 4 * sizeof *tet * (size_t)ntet;

    given = tet;
    free(tet1);
    free(adj1);
    tet1 = (tess_int *)memcpy(take(1.0, many), tet, many);
    adj1 = (tess_int *)memcpy(take(1.0, many), adj, many);
    both(tet1, adj1, ntet, 1);
    trslop_(&n, p, &ntet, tet1, adj1, value, &times, g, work, &info);
    return (int)info;
}

int tr_bent(const tess_real *p, tess_int ntet, const tess_int *tet,
            const tess_int *adj, const double *value, const double *g,
            double beyond, const tess_real *q, tess_int *t, double *f)
{
    tess_int info;

    if (tet != given ||
        (ntet > 0 && (tet[0] != tet1[0] - 1 || adj[0] != adj1[0] - 1)))
        abort();
    count(t, 1, 1);
    trbent_(p, &ntet, tet1, adj1, value, g, &beyond, q, t, f, &info);
    count(t, 1, -1);
    return (int)info;
}

/* ---- cells.f ---- */

/* star - what tr_cell reads of point i. */
static void star(const tess_int *tet, const tess_int *adj,
                 const tess_int *first, const tess_int *list, tess_int i,
                 tess_int by)
{
    tess_int from = by < 0; /* what is counted now from 1 */
    tess_int begin = first[i] - from, end = first[i + 1] - from, k, t;

    for (k = begin; k < end; k++) {
        t = 4 * (list[k] - from);
        both(tet + t, adj + t, 1, by);
    }
    count(list + begin, end - begin, by);
    count(first + i, 2, by);
}

int tr_cell(const tess_real *p, const tess_int *tet, const tess_int *adj,
            const tess_int *first, const tess_int *list, tess_int i,
            const double *box, tess_int most, tess_int *nface, tess_int *whose,
            double *area, double *volume, tess_int *start, tess_int *corner,
            tess_int *nvert, double *vert, tess_int *iwork, double *work)
{
    tess_int info, boxed = box != NULL, number = i + 1, f;

    star(tet, adj, first, list, i, 1);
    trcell_(p, tet, adj, first, list, &number, box, &boxed, &most, nface, whose,
          area, volume, start, corner, nvert, vert, iwork, work, &info);
    star(tet, adj, first, list, i, -1);
    if (info != 0) return (int)info;
    count(start, *nface + 1, -1);
    count(corner, start[*nface], -1);
    for (f = 0; f < *nface; f++) whose[f] -= whose[f] > 0;
    return 0;
}

int tr_clipped(tess_int n, const tess_real *p, const tess_int *tet,
               const tess_int *adj, const tess_int *first, const tess_int *list,
               const double *box, tess_int maxrow, tess_int *nrow,
               tess_int *row, tess_int *other, double *area, double *volume,
               tess_int most, tess_int *iwork, double *work)
{
    tess_int info = 0, by, f, ntet = first[n] / 4;

    for (by = 1; by >= -1; by -= 2) {
        both(tet, adj, ntet, by);
        count(first, n + 1, by);
        count(list, 4 * ntet, by);
        if (by == 1)
            trclip_(&n, p, tet, adj, first, list, box, &maxrow, nrow, row,
                    other, area, volume, &most, iwork, work, &info);
    }
    if (info != 0) return (int)info;
    count(row, n + 1, -1);
    for (f = 0; f < *nrow; f++) other[f] -= other[f] > 0;
    return 0;
}

int tr_alpha(const tess_real *p, tess_int ntet, const tess_int *tet,
             const tess_int *adj, double radius, int voids, char *keep,
             tess_int maxfac, tess_int *nfac, tess_int *fac, tess_int *stack)
{
    tess_int info, eaten = voids, t;
    tess_int *kept = (tess_int *)take((double)ntet, sizeof *kept);

    both(tet, adj, ntet, 1);
    tralph_(p, &ntet, tet, adj, &radius, &eaten, kept, &maxfac, nfac, fac,
           stack, &info);
    both(tet, adj, ntet, -1);
    if (info == 0) count(fac, 3 * *nfac, -1);
    for (t = 0; t < ntet && info < 2; t++) keep[t] = (char)kept[t];
    free(kept);
    return (int)info;
}

/* ---- interp.f ---- */

int tr_ongrid(const tess_real *p, tess_int ntet, const tess_int *tet,
              const tess_int *adj, tess_int nv, const double *value,
              const tess_int *size, const double *box, double outside,
              tess_int *t, tess_real *q, double *out)
{
    tess_int info;

    both(tet, adj, ntet, 1);
    trongr_(p, &ntet, tet, adj, &nv, value, size, box, &outside, t, q, out,
            &info);
    both(tet, adj, ntet, -1);
    return (int)info;
}

/* ---- iso.f ---- */

int tr_iso(const tess_real *p, tess_int ntet, const tess_int *tet,
           const tess_int *adj, const double *value, double level, int closed,
           tess_int maxpt, tess_int *npt, tess_real *x, tess_int *ends,
           tess_int maxtri, tess_int *ntri, tess_int *tri, tess_int *iwork)
{
    tess_int info, shut = closed;

    both(tet, adj, ntet, 1);
    triso_(p, &ntet, tet, adj, value, &level, &shut, &maxpt, npt, x, ends,
         &maxtri, ntri, tri, iwork, &info);
    both(tet, adj, ntet, -1);
    if (info == 0) count(ends, 2 * *npt, -1);
    if (info == 0) count(tri, 3 * *ntri, -1);
    return (int)info;
}

/* ---- periodic.f ---- */

void tr_unpack(tess_int number, int *copy)
{
    tess_int three[3];
    int k;

    trunpa_(&number, three);
    for (k = 0; k < 3; k++) copy[k] = (int)three[k];
}

int tr_triclinic(tess_int n, const tess_real *p, const double *cell,
                 const tess_int *ways, tess_int maxcop, tess_int *ncop,
                 tess_real *x, tess_int *cw, tess_int maxtet, tess_int *ntet,
                 tess_int *tet, tess_int *move, tess_int *adj, tess_int *shift,
                 tess_int liw, tess_int *iw, tess_int lrw, double *rw)
{
    tess_int info;

    trtric_(&n, p, cell, ways, &maxcop, ncop, x, cw, &maxtet, ntet, tet, move,
            adj, shift, &liw, iw, &lrw, rw, &info);
    if (info == 0) both(tet, adj, *ntet, -1);
    return (int)info;
}

int tr_periodic(tess_int n, const tess_real *p, const double *box,
                tess_int maxcop, tess_int *ncop, tess_real *x, tess_int *cw,
                tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *move,
                tess_int *adj, tess_int *shift, tess_int liw, tess_int *iw,
                tess_int lrw, double *rw)
{
    tess_int info;

    trperi_(&n, p, box, &maxcop, ncop, x, cw, &maxtet, ntet, tet, move, adj,
            shift, &liw, iw, &lrw, rw, &info);
    if (info == 0) both(tet, adj, *ntet, -1);
    return (int)info;
}

void tr_reduce(double *cell, const tess_int *ways)
{
    trredu_(cell, ways);
}

/* ---- planar.f ---- */

int tr_planar(tess_int n, tess_real *p, tess_int maxtri, tess_int *ntri,
              tess_int *triangle, tess_int *beside, tess_int liw, tess_int *iw,
              tess_int lrw, double *rw)
{
    tess_int info;

    trplan_(&n, p, &maxtri, ntri, triangle, beside, &liw, iw, &lrw, rw, &info);
    if (info == -2) --*ntri;
    if (n > 0 && info >= 0 && info != TESS_RANGE) count(iw, n, -1);
    if (info == 0) count(triangle, 3 * *ntri, -1);
    if (info == 0) count(beside, 3 * *ntri, -1);
    return (int)info;
}

/* ---- surface.f ---- */

double tr_enclosed(const tess_real *p, tess_int nfac, const tess_int *fac)
{
    double sum;

    count(fac, 3 * nfac, 1);
    trencl_(p, &nfac, fac, &sum);
    count(fac, 3 * nfac, -1);
    return sum;
}

/* copied - what FORTRAN has written to a unit, which gfortran names so where it
 * is not opened, and writes at once as check.sh asks for. */
static int copied(FILE *file, const char *name)
{
    FILE *from = fopen(name, "r");
    int c;

    while (from && (c = getc(from)) != EOF) putc(c, file);
    return from && fclose(from) == 0 && remove(name) == 0 && !ferror(file);
}

int tr_obj(FILE *file, tess_int n, const tess_real *p, tess_int nfac,
           const tess_int *fac, int digits, tess_int *number)
{
    tess_int info, unit = 10, precision = digits;

    count(fac, 3 * nfac, 1);
    trobj_(&unit, &n, p, &nfac, fac, &precision, number, &info);
    count(fac, 3 * nfac, -1);
    return copied(file, "fort.10") ? (int)info : 1;
}

int tr_stl(FILE *file, const tess_real *p, tess_int nfac, const tess_int *fac,
           int digits)
{
    tess_int info, unit = 11, precision = digits;

    count(fac, 3 * nfac, 1);
    trstl_(&unit, p, &nfac, fac, &precision, &info);
    count(fac, 3 * nfac, -1);
    return copied(file, "fort.11") ? (int)info : 1;
}
