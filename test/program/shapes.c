/* shapes.c - alpha shapes, and Voronoi cells in a box, which may repeat itself.
 *
 * Lengths are those of the stretched points, by -scale, until they are written.
 */
#include "../examples/recipes.h"
#include "driver.h"

#include <math.h>
#include <stdlib.h>

static tess_int *integers(double many)
{
    return (tess_int *)space(many, sizeof(tess_int));
}

static double *doubles(double many)
{
    return (double *)space(many, sizeof(double));
}

/* ---- alpha shapes ---- */

void mark_alpha(mesh *m, double radius)
{
    char *keep = (char *)space((double)m->ntet, sizeof *keep);
    tess_int *stack = integers((double)m->ntet), nfac, none[3], t;

    if (alpha(m->p, m->ntet, m->tet, m->adj, radius, 1, keep, 0, &nfac, none,
              stack) < 0)
        too_small("-alpha: the tetrahedra's balls cannot be computed");
    free(stack);
    m->keep = keep;
    for (m->kept = t = 0; t < m->ntet; t++) m->kept += keep[t];
    if (m->kept == 0 && m->ntet > 0)
        warn("-alpha: every tetrahedron has a larger circumradius than %g: "
             "nothing is left; take a larger one", radius);
}

void drop_others(mesh *m)
{
    tess_int *number = integers((double)m->ntet), many = 0, t, u;
    int k;

    for (t = 0; t < m->ntet; t++) number[t] = m->keep[t] ? many++ : TESS_NONE;
    for (t = 0; t < m->ntet; t++) {
        if (!m->keep[t]) continue;
        for (k = 0; k < 4; k++) {
            u = m->adj[4 * t + k];
            m->tet[4 * number[t] + k] = m->tet[4 * t + k];
            m->adj[4 * number[t] + k] = u < 0 ? u : number[u];
        }
    }
    free(number);
    free(m->keep);
    m->ntet = many;
    m->keep = 0;
}

/* ---- cells ---- */

/* cells - of all points: what cell is given, and gives of one. */
typedef struct cells {
    const mesh *m;
    double box[6];          /* what the cells fill, or a period: x0, x1, ... */
    tess_int *first, *list; /* of each point tetrahedra; or, where the box
                             * repeats itself, vertices of them: */
    tess_int *tet, *move;   /* the periodic mesh; or 0 */
    tess_int periods;       /* its tetrahedra */
    tess_real *at;          /* the points, all in the box */
    /* a point's star in it: vertices, as seen from the point, and whose copies
     * they are; tetrahedra, neighbours (that there are some), 0, 1, 2, ... */
    tess_real *around;
    tess_int *who, *copy, *star, *beside, *count;
    /* a cell, and workspace */
    tess_int most, nface, nvert, *whose, *begin, *corner, *iwork;
    double volume, *area, *vert, *work;
    tess_int *integer; /* where these are */
    double *real;
} cells;

/* totals - of all cells. */
typedef struct totals {
    double cells, vertices, numbers, volume; /* numbers: VTK's, for CELLS */
} totals;

/* points_box - the box about the points. */
static void points_box(cells *c)
{
    const tess_real *p = c->m->p;
    tess_int i;
    int k;

    for (k = 0; k < 6; k++) c->box[k] = (double)p[k / 2];
    for (i = 0; i < 3 * c->m->in->n; i++) {
        k = (int)(i % 3) * 2;
        if ((double)p[i] < c->box[k]) c->box[k] = (double)p[i];
        if ((double)p[i] > c->box[k + 1]) c->box[k + 1] = (double)p[i];
    }
}

/* choose_box - that of -box, or of the file, or about the points. */
static void choose_box(cells *c)
{
    const points *in = c->m->in;
    const double *box = chosen.boxed ? chosen.box : in->box;
    int k;

    if (chosen.boxed || in->lattice == RIGHT) {
        for (k = 0; k < 6; k++) c->box[k] = box[k] * c->m->scale[k / 2];
        return;
    }
    points_box(c);
}

void check_box(const points *in)
{
    if (!chosen.cells || chosen.boxed) return;
    if (chosen.periodic && in->aperiodic)
        fail("%s: -periodic: its pbc says that the box does not repeat itself "
             "along all axes", in->input);
    if (in->lattice == RIGHT) return;
    if (chosen.periodic && in->lattice == SKEW)
        fail("%s: -periodic: its Lattice, or CRYST1, is not a box along x, y, "
             "z; only such boxes can be repeated", in->input);
    if (chosen.periodic)
        fail("-periodic needs -box X0,X1,Y0,Y1,Z0,Z1, or an extended XYZ file "
             "with a Lattice, or a PDB file with CRYST1");
    if (in->lattice == SKEW)
        warn("%s: its Lattice is not a box along x, y, z: the cells fill the "
             "points' box", in->input);
}

/* wrap - the points, each moved into the box by whole lengths of it. */
static void wrap(cells *c)
{
    const mesh *m = c->m;
    tess_int i, moved = 0;
    int k, out;
    double x, low, high;

    c->at = (tess_real *)space(3.0 * (double)m->in->n, sizeof *c->at);
    for (i = 0; i < m->in->n; i++) {
        for (out = k = 0; k < 3; k++) {
            x = (double)m->p[3 * i + k];
            low = c->box[2 * k];
            high = c->box[2 * k + 1];
            if (x < low || x > high) {
                out = 1;
                x -= (high - low) * floor((x - low) / (high - low));
                if (!(x >= low)) x = low;
                if (!(x <= high)) x = high;
            }
            c->at[3 * i + k] = (tess_real)x;
        }
        moved += out;
    }
    if (moved > 0)
        warn("%ld point%s outside the box: taken where the box's copies bring "
             "them into it", (long)moved, moved > 1 ? "s are" : " is");
}

/* try_periodic - make the mesh of the box that repeats itself, with room for so
 * many copies of points and so many tetrahedra, and so many times the usual pool
 * of facets.  Returns periodic's code. */
static int try_periodic(cells *c, double maxcop, double maxtet, double pool,
                        tess_int *ncop)
{
    tess_int *cw, *adj, *shift, *iw, liw, lrw;
    double *rw;
    tess_real *x;
    int code;

    if (maxtet > (double)TESS_INT_MOST / 4.0 - 1.0 ||
        tess_size((tess_int)maxcop, (tess_int)maxtet, &liw, &lrw) != 0 ||
        pool * (double)liw > (double)TESS_INT_MOST)
        too_small("-periodic: more tetrahedra than a tess_int can number");
    liw = (tess_int)(pool * (double)liw);
    x = (tess_real *)space(3.0 * maxcop, sizeof *x);
    cw = integers(3.0 * maxcop);
    c->tet = integers(4.0 * maxtet);
    c->move = integers(4.0 * maxtet);
    adj = integers(4.0 * maxtet);
    shift = integers(4.0 * maxtet);
    iw = integers((double)liw);
    rw = doubles((double)lrw);
    code = periodic(c->m->in->n, c->at, c->box, (tess_int)maxcop, ncop, x, cw,
                    (tess_int)maxtet, &c->periods, c->tet, c->move, adj, shift,
                    liw, iw, lrw, rw);
    free(x);
    free(cw);
    free(adj);
    free(shift);
    free(iw);
    free(rw);
    return code;
}

/* make_periodic - that mesh, with as much room as it needs. */
static void make_periodic(cells *c)
{
    double maxcop = 3.0 * (double)c->m->in->n + 1000.0, pool = 1.0;
    double maxtet = 10.0 * (double)c->m->in->n + 1000.0;
    tess_int ncop = 0;
    int code;

    wrap(c);
    while ((code = try_periodic(c, maxcop, maxtet, pool, &ncop)) != 0) {
        free(c->tet);
        free(c->move);
        if (code == PERIODIC_FEW)
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
}

/* list_corners - for each point where in the periodic mesh it is a vertex. */
static void list_corners(cells *c)
{
    tess_int i, *first = c->first;

    for (i = 0; i <= c->m->in->n; i++) first[i] = 0;
    for (i = 0; i < 4 * c->periods; i++) first[c->tet[i]]++;
    for (i = 1; i <= c->m->in->n; i++) first[i] += first[i - 1];
    for (i = 4 * c->periods - 1; i >= 0; i--) c->list[--first[c->tet[i]]] = i;
}

/* gather - the star of point i in the periodic mesh, as a mesh of its own in
 * which i is point 0, at the origin: a difference of points and its opposite
 * have the same rounding, so that neighbours agree on the face between them. */
static void gather(cells *c, tess_int i)
{
    tess_int f, t, j, v, move, many = 1;
    int away[3], k, m;

    c->who[0] = i;
    c->copy[0] = 0;
    for (k = 0; k < 3; k++) c->around[k] = (tess_real)0.0;
    for (f = c->first[i]; f < c->first[i + 1]; f++) {
        t = c->list[f] / 4 * 4;
        for (k = 0; k < 4; k++) {
            v = c->tet[t + k];
            move = c->move[t + k] - c->move[c->list[f]];
            for (j = 0; j < many && (c->who[j] != v || c->copy[j] != move);)
                j++;
            c->star[4 * (f - c->first[i]) + k] = j;
            if (j < many) continue;
            many++;
            c->who[j] = v;
            c->copy[j] = move;
            unpack(move, away);
            for (m = 0; m < 3; m++)
                c->around[3 * j + m] = (tess_real)(
                    ((double)c->at[3 * v + m] - (double)c->at[3 * i + m]) +
                    away[m] * (c->box[2 * m + 1] - c->box[2 * m]));
        }
    }
}

/* compute - the cell of point i: in *c, its vertices where they are written. */
static void compute(cells *c, tess_int i)
{
    const mesh *m = c->m;
    tess_int range[2], v;
    int code, k;

    progress("cells", (double)i + 1.0, (double)m->in->n);
    if (c->tet) gather(c, i);
    range[0] = 0;
    range[1] = c->first[i + 1] - c->first[i];
    code = cell(c->tet ? c->around : m->p, c->tet ? c->star : m->tet,
                c->tet ? c->beside : m->adj, c->tet ? range : c->first,
                c->tet ? c->count : c->list, c->tet ? 0 : i,
                c->tet ? NULL : c->box, c->most, &c->nface, c->whose,
                c->area, &c->volume, c->begin, c->corner, &c->nvert, c->vert,
                c->iwork, c->work);
    if (code != 0)
        fail("the cell of point %ld cannot be computed: it may be smaller than "
             "1e-102 or larger than 1e102; use other units, as by -scale",
             (long)(i + m->in->base));
    for (v = 0; v < c->nvert; v++)
        for (k = 0; k < 3; k++) {
            if (c->tet) c->vert[3 * v + k] += (double)m->p[3 * i + k];
            c->vert[3 * v + k] /= m->scale[k];
        }
    for (k = 0; k < 3; k++) c->volume /= m->scale[k];
}

/* slice - so many of the integers at *from, and step behind them. */
static tess_int *slice(tess_int **from, tess_int many)
{
    *from += many;
    return *from - many;
}

/* take_room - for one cell, of at most so many faces. */
static void take_room(cells *c, tess_int most)
{
    tess_int *from = c->integer = integers(50.0 * (double)most + 1.0), k;

    c->most = most;
    c->who = slice(&from, 4 * most);
    c->copy = slice(&from, 4 * most);
    c->star = slice(&from, 4 * most);
    c->beside = slice(&from, 4 * most);
    c->count = slice(&from, most);
    c->whose = slice(&from, most);
    c->corner = slice(&from, 6 * most);
    c->iwork = slice(&from, 25 * most);
    c->begin = slice(&from, most + 1);
    for (k = 0; k < 4 * most; k++) c->beside[k] = 0;
    for (k = 0; k < most; k++) c->count[k] = k;
    c->real = doubles(17.0 * (double)most);
    c->area = c->real;
    c->vert = c->real + most;
    c->work = c->real + 10 * most;
    c->around =
        (tess_real *)space(12.0 * (double)most, sizeof *c->around);
}

/* prepare - all that compute needs. */
static void prepare(cells *c, const mesh *m)
{
    tess_int n = m->in->n, i, most = 0;

    c->m = m;
    c->tet = c->move = 0;
    c->at = 0;
    choose_box(c);
    if (chosen.periodic) make_periodic(c);
    c->first = integers((double)n + 1.0);
    c->list = integers(4.0 * (double)(c->tet ? c->periods : m->ntet));
    if (c->tet)
        list_corners(c);
    else
        stars(n, m->ntet, m->tet, c->first, c->list);
    for (i = 0; i < n; i++)
        if (c->first[i + 1] - c->first[i] > most)
            most = c->first[i + 1] - c->first[i];
    take_room(c, most + 8);
}

/* clear - what prepare took. */
static void clear(cells *c)
{
    free(c->tet);
    free(c->move);
    free(c->at);
    free(c->first);
    free(c->list);
    free(c->around);
    free(c->integer);
    free(c->real);
}

/* measure_cells - each cell's volume and number of faces, and what they are in
 * all. */
static void measure_cells(cells *c, double *volume, tess_int *faces, totals *all)
{
    double lost = 0.0, sum, v;
    tess_int i;

    all->cells = all->vertices = all->numbers = all->volume = 0.0;
    for (i = 0; i < c->m->in->n; i++) {
        compute(c, i);
        v = volume[i] = c->volume;
        faces[i] = c->nface;
        if (c->nface == 0) continue;
        all->cells += 1.0;
        all->vertices += (double)c->nvert;
        all->numbers += 2.0 + (double)c->nface + (double)c->begin[c->nface];
        /* what a sum of many loses is added at the end */
        sum = all->volume + v;
        lost += v - (sum - all->volume);
        all->volume = sum;
    }
    all->volume += lost;
}

/* put_faces - a cell in VTK's CELLS; its vertices are numbered from that number
 * on. */
static void put_faces(FILE *file, const cells *c, double from)
{
    tess_int j, k;

    put_int(file, (double)(1 + c->nface + c->begin[c->nface]));
    put_int(file, (double)c->nface);
    for (j = 0; j < c->nface; j++) {
        put_int(file, (double)(c->begin[j + 1] - c->begin[j]));
        for (k = c->begin[j]; k < c->begin[j + 1]; k++)
            put_int(file, from + (double)c->corner[k]);
    }
}

/* write_cells - as polyhedra of a VTK unstructured grid. */
static void write_cells(cells *c, output *o, const double *volume,
                        const tess_int *faces, const totals *all)
{
    FILE *file = start_vtk(o, "Voronoi cells in a box, by tess",
                           "UNSTRUCTURED_GRID", all->vertices,
                           24.0 * all->vertices + 4.0 * all->numbers);
    tess_int n = c->m->in->n, i, v;
    double vertices = 0.0;

    fprintf(file, "POINTS %.0f double\n", all->vertices);
    for (i = 0; i < n; i++) {
        compute(c, i);
        for (v = 0; v < 3 * c->nvert; v++) put_double(file, c->vert[v]);
    }
    fprintf(file, "\nCELLS %.0f %.0f\n", all->cells, all->numbers);
    for (i = 0; i < n; i++) {
        compute(c, i);
        if (c->nface > 0) put_faces(file, c, vertices);
        vertices += (double)c->nvert;
    }
    fprintf(file, "\nCELL_TYPES %.0f\n", all->cells);
    for (i = 0; i < n; i++)
        if (faces[i] > 0) put_int(file, 42.0);
    fprintf(file,
            "\nCELL_DATA %.0f\nSCALARS point int 1\nLOOKUP_TABLE default\n",
            all->cells);
    for (i = 0; i < n; i++)
        if (faces[i] > 0) put_int(file, (double)(i + c->m->in->base));
    fprintf(file, "\n");
    put_scalars(file, "volume");
    for (i = 0; i < n; i++)
        if (faces[i] > 0) put_double(file, volume[i]);
    fprintf(file, "\n");
    finish(file, o);
}

/* surface - of the cell, in the coordinates given: of each face the length of
 * the vectors' sum that are normal to its triangles. */
static double surface(const cells *c)
{
    const double *o, *a, *b;
    double sum = 0.0, n[3];
    tess_int f, v;
    int k;

    for (f = 0; f < c->nface; f++) {
        o = c->vert + 3 * c->corner[c->begin[f]];
        n[0] = n[1] = n[2] = 0.0;
        for (v = c->begin[f] + 2; v < c->begin[f + 1]; v++) {
            a = c->vert + 3 * c->corner[v - 1];
            b = c->vert + 3 * c->corner[v];
            for (k = 0; k < 3; k++)
                n[k] += (a[(k + 1) % 3] - o[(k + 1) % 3]) *
                            (b[(k + 2) % 3] - o[(k + 2) % 3]) -
                        (a[(k + 2) % 3] - o[(k + 2) % 3]) *
                            (b[(k + 1) % 3] - o[(k + 1) % 3]);
        }
        sum += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2.0;
    }
    return sum;
}

static void write_volumes(cells *c, output *o, const double *volume,
                          const tess_int *faces)
{
    const points *in = c->m->in;
    FILE *file = start(o, (150.0 + 20.0 * (double)in->columns) *
                              (double)in->n);
    tess_int i, j, v;
    int k;

    fprintf(file, "x,y,z,volume,faces,point,area,neighbours");
    for (k = 0; k < in->columns; k++) put_title(file, in->name[k]);
    putc('\n', file);
    for (i = 0; i < in->n; i++) {
        compute(c, i);
        put_point(file, in, i, ',', ',');
        fprintf(file, "%.17g,%ld,%ld,%.17g,", volume[i], (long)faces[i],
                (long)(i + in->base), surface(c));
        for (j = 0; j < c->nface; j++) {
            v = c->whose[j];
            if (c->tet) v = c->who[v];
            fprintf(file, "%s%ld", j > 0 ? " " : "",
                    (long)(v < 0 ? v : v + in->base));
        }
        for (k = 0; k < in->columns; k++)
            fprintf(file, ",%.17g",
                    in->value[(size_t)in->columns * (size_t)i + (size_t)k]);
        putc('\n', file);
    }
    finish(file, o);
}

void make_cells(const mesh *m)
{
    cells c;
    totals all;
    output *o;
    double *volume, whole = 1.0, slack, side[3], longest = 0.0;
    tess_int *faces;
    int k;

    if (m->ntet == 0 && !chosen.periodic)
        fail("no cells: the points do not span space");
    prepare(&c, m);
    volume = doubles((double)m->in->n);
    faces = integers((double)m->in->n);
    say("computing %ld cells ...", (long)m->in->n);
    measure_cells(&c, volume, faces, &all);
    for (k = 0; k < 3; k++) {
        side[k] = (c.box[2 * k + 1] - c.box[2 * k]) / m->scale[k];
        if (side[k] > longest) longest = side[k];
        whole *= side[k];
    }
    /* volumes are right but for roundings of lengths times surfaces */
    slack = 1e-15 * longest * (side[0] * side[1] + side[1] * side[2] +
                               side[2] * side[0]);
    if (!(whole > 0.0 && fabs(all.volume - whole) <= 1e-9 * whole + slack))
        fail("the cells' volumes sum to %.15g, but the box's is %.15g: use "
             "other units, as by -scale, or a smaller box", all.volume, whole);
    if (c.tet) tell("periodic      %ld tetrahedra\n", (long)c.periods);
    tell("cells         %.0f, their volumes sum to %.15g; the box's is %.15g\n",
         all.cells, all.volume, whole);
    for (o = 0; (o = next_output(cells_forms, o)) != 0;)
        write_cells(&c, o, volume, faces, &all);
    for (o = 0; (o = next_output(volumes_forms, o)) != 0;)
        write_volumes(&c, o, volume, faces);
    free(volume);
    free(faces);
    clear(&c);
}
