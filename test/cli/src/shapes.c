/* shapes.c - Voronoi cells in a box, which may repeat itself.
 *
 * Lengths are those of the stretched points, by -scale, until they are written.
 */
#include "../../recipes/recipes.h"
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

/* ---- cells ---- */

/* cells - of all points: what tr_cell is given, and gives of one. */
typedef struct cells {
    const mesh *m;
    const repeated *again;  /* the mesh that repeats itself; or 0, and: */
    double box[6];          /* what the cells fill: x0, x1, ... */
    tess_int *first, *list; /* of each point tetrahedra; or vertices of those
                             * that repeat themselves */
    /* a point's star in it: vertices, as seen from the point, and whose copies
     * they are; tetrahedra, neighbours (that there are some), 0, 1, 2, ... */
    tess_real *around;
    tess_int *who, *copy, *star, *beside, *count;
    /* a cell, and workspace */
    tess_int most, nface, nvert, *whose, *begin, *corner, *iwork;
    double volume, *area, *vert, *work;
    double surface, centre[3], *middle; /* by sizes; in work */
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

/* list_corners - for each point where in the periodic mesh it is a vertex. */
static void list_corners(cells *c)
{
    tess_int i, *first = c->first;

    for (i = 0; i <= c->m->in->n; i++) first[i] = 0;
    for (i = 0; i < 4 * c->again->ntet; i++) first[c->again->tet[i]]++;
    for (i = 1; i <= c->m->in->n; i++) first[i] += first[i - 1];
    for (i = 4 * c->again->ntet - 1; i >= 0; i--)
        c->list[--first[c->again->tet[i]]] = i;
}

/* mirror - point i, where nothing repeats itself along vector k, in the cell's
 * sides there, as points j and j + 1: so its own cell ends there.  The star
 * gets a tetrahedron of them, number t.  (On a side it is a hair's breadth
 * within.) */
static void mirror(cells *c, tess_int i, int k, tess_int t, tess_int j)
{
    const repeated *r = c->again;
    const double *g = r->inverse + 3 * k;
    double size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]), s = 0.0, by;
    int l, side;

    for (l = 0; l < 3; l++)
        s += ((double)r->at[3 * i + l] - r->cell[9 + l]) * g[l];
    for (side = 0; side < 2; side++) {
        by = side ? 1.0 - s : s;
        if (!(by > 1e-30)) by = 1e-30;
        for (l = 0; l < 3; l++)
            c->around[3 * (j + side) + l] =
                (tess_real)(2.0 * (side ? by : -by) * (g[l] / size) / size);
        c->who[j + side] = (tess_int)(-1 - 2 * k - side);
        c->star[4 * t + side] = j + side;
        c->star[4 * t + 2 + side] = 0;
    }
}

/* gather - the star of point i in the periodic mesh, as a mesh of its own in
 * which i is point 0, at the origin: a difference of points and its opposite
 * have the same rounding, so that neighbours agree on the face between them.
 * Returns how many tetrahedra it has. */
static tess_int gather(cells *c, tess_int i)
{
    const repeated *r = c->again;
    tess_int f, t, j, v, move, many = 1;
    int away[3], k, m;

    c->who[0] = i;
    c->copy[0] = 0;
    for (k = 0; k < 3; k++) c->around[k] = (tess_real)0.0;
    for (f = c->first[i]; f < c->first[i + 1]; f++) {
        t = c->list[f] / 4 * 4;
        for (k = 0; k < 4; k++) {
            v = r->tet[t + k];
            move = r->move[t + k] - r->move[c->list[f]];
            for (j = 0; j < many && (c->who[j] != v || c->copy[j] != move);)
                j++;
            c->star[4 * (f - c->first[i]) + k] = j;
            if (j < many) continue;
            many++;
            c->who[j] = v;
            c->copy[j] = move;
            tr_unpack(move, away);
            for (m = 0; m < 3; m++)
                c->around[3 * j + m] = (tess_real)(
                    ((double)r->at[3 * v + m] - (double)r->at[3 * i + m]) +
                    (away[0] * r->cell[m] + away[1] * r->cell[3 + m] +
                     away[2] * r->cell[6 + m]));
        }
    }
    f -= c->first[i];
    for (k = 0; k < 3 && f > 0; k++) {
        if (r->ways[k]) continue;
        mirror(c, i, k, f++, many);
        many += 2;
    }
    return f;
}

/* compute - the cell of point i: in *c, its vertices where they are written. */
static void compute(cells *c, tess_int i)
{
    const mesh *m = c->m;
    tess_int range[2], v;
    int again = c->again != 0, code, k;

    progress("cells", (double)i + 1.0, (double)m->in->n);
    range[0] = 0;
    range[1] = again ? gather(c, i) : 0;
    code = tr_cell(again ? c->around : m->p, again ? c->star : m->tet,
                   again ? c->beside : m->adj, again ? range : c->first,
                   again ? c->count : c->list, again ? 0 : i,
                   again ? NULL : c->box, c->most, &c->nface, c->whose,
                   c->area, &c->volume, c->begin, c->corner, &c->nvert, c->vert,
                   c->iwork, c->work);
    if (code != 0)
        fail("the cell of point %ld cannot be computed: it may be smaller than "
             "1e-102 or larger than 1e102; use other units, as by -scale",
             (long)(i + m->in->base));
    for (v = 0; v < c->nvert; v++)
        for (k = 0; k < 3; k++) {
            if (again) c->vert[3 * v + k] += (double)m->p[3 * i + k];
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
    c->work = c->middle = c->real + 10 * most;
    c->around =
        (tess_real *)space(12.0 * (double)most, sizeof *c->around);
}

/* prepare - all that compute needs. */
static void prepare(cells *c, const mesh *m)
{
    tess_int n = m->in->n, i, most = 0;

    c->m = m;
    c->again = chosen.periodic ? repetition() : 0;
    if (!c->again) choose_box(c);
    if (c->again && !(c->again->sides && c->again->volume > 0.0))
        fail("no cells: the box has no sides where nothing repeats itself: "
             "give Lattice three vectors that span one");
    if (c->again && c->again->beyond > 0)
        fail("no cells: %ld times a point is outside the box where nothing "
             "repeats itself: give a Lattice, and Origin, that hold all points",
             c->again->beyond);
    c->first = integers((double)n + 1.0);
    c->list = integers(4.0 * (double)(c->again ? c->again->ntet : m->ntet));
    if (c->again)
        list_corners(c);
    else
        tr_stars(n, m->ntet, m->tet, c->first, c->list);
    for (i = 0; i < n; i++)
        if (c->first[i + 1] - c->first[i] > most)
            most = c->first[i + 1] - c->first[i];
    take_room(c, most + 14); /* (of an open star, and four of mirror) */
}

/* clear - what prepare took. */
static void clear(cells *c)
{
    free(c->first);
    free(c->list);
    free(c->around);
    free(c->integer);
    free(c->real);
}

/* put_polyhedron - a cell in VTK's CELLS; its vertices are numbered from that
 * number on. */
static void put_polyhedron(FILE *file, const cells *c, double from)
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
        if (c->nface > 0) put_polyhedron(file, c, vertices);
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

/* sizes - of the cell, in the coordinates given: c->area, c->middle, the faces'
 * areas and centroids; its own.  Lengths are in a unit, so that their products
 * are not beyond doubles. */
static void sizes(cells *c)
{
    double far = 0.0, unit, inside = 0.0, area, w, s, n[3], x[3][3];
    tess_int f, v, at[3];
    int k, m;

    for (v = 0; v < 3 * c->nvert; v++)
        if (fabs(c->vert[v] - c->vert[v % 3]) > far)
            far = fabs(c->vert[v] - c->vert[v % 3]);
    frexp(far, &k);
    unit = ldexp(1.0, k);
    c->centre[0] = c->centre[1] = c->centre[2] = c->surface = 0.0;
    for (f = 0; f < c->nface; f++) {
        double *middle = c->middle + 3 * f;

        middle[0] = middle[1] = middle[2] = area = 0.0;
        at[0] = c->corner[c->begin[f]];
        for (v = c->begin[f] + 2; v < c->begin[f + 1]; v++) {
            at[1] = c->corner[v - 1];
            at[2] = c->corner[v];
            for (m = 0; m < 3; m++)
                for (k = 0; k < 3; k++)
                    x[m][k] = (c->vert[3 * at[m] + k] - c->vert[k]) / unit;
            for (k = 0; k < 3; k++)
                n[k] = (x[1][(k + 1) % 3] - x[0][(k + 1) % 3]) *
                           (x[2][(k + 2) % 3] - x[0][(k + 2) % 3]) -
                       (x[1][(k + 2) % 3] - x[0][(k + 2) % 3]) *
                           (x[2][(k + 1) % 3] - x[0][(k + 1) % 3]);
            w = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            s = n[0] * x[0][0] + n[1] * x[0][1] + n[2] * x[0][2];
            area += w;
            inside += s;
            for (k = 0; k < 3; k++) {
                middle[k] += w * (x[0][k] + x[1][k] + x[2][k]) / 3.0;
                c->centre[k] += s * (x[0][k] + x[1][k] + x[2][k]) / 4.0;
            }
        }
        for (k = 0; k < 3; k++)
            middle[k] = c->vert[k] +
                        unit * (area > 0.0 ? middle[k] / area : x[0][k]);
        c->area[f] = area / 2.0 * unit * unit;
        c->surface += c->area[f];
    }
    for (k = 0; k < 3 && c->nface > 0; k++)
        c->centre[k] = c->vert[k] +
                       unit * (inside > 0.0 ? c->centre[k] / inside : 0.0);
}

static FILE *start_rows(const points *in, output *o)
{
    int faces = o->all == faces_forms, k;
    FILE *file = start(o, (faces ? 1600.0 : 210.0 + 20.0 * in->columns) *
                              (double)in->n);

    fprintf(file, faces ? "point,neighbour,area,x,y,z,nx,ny,nz,sx,sy,sz"
                        : "x,y,z,volume,faces,point,area,neighbours");
    for (k = 0; k < in->columns && !faces; k++) put_title(file, in->name[k]);
    if (!faces) fprintf(file, ",cx,cy,cz");
    if (!faces && in->labelled[0]) put_title(file, in->labelled);
    putc('\n', file);
    return file;
}

static void put_three(FILE *file, const double *x)
{
    int k;

    for (k = 0; k < 3; k++) put_behind(file, ',', x[k] + 0.0); /* (no -0) */
}

/* beyond - who is beyond face f: a point's number, or -1, ... for a side. */
static tess_int beyond(const cells *c, tess_int f)
{
    return c->again ? c->who[c->whose[f]] : c->whose[f];
}

/* put_volume - the row of point i, whose cell *c holds. */
static void put_volume(FILE *file, const cells *c, tess_int i)
{
    const points *in = c->m->in;
    tess_int j, v;
    int k;

    put_point(file, in, i, ',', ',');
    put_behind(file, 0, c->volume);
    fprintf(file, ",%ld,%ld", (long)c->nface, (long)(i + in->base));
    put_behind(file, ',', c->surface);
    putc(',', file);
    for (j = 0; j < c->nface; j++) {
        v = beyond(c, j);
        fprintf(file, "%s%ld", j > 0 ? " " : "",
                (long)(v < 0 ? v : v + in->base));
    }
    for (k = 0; k < in->columns; k++)
        put_behind(file, ',',
                   in->value[(size_t)in->columns * (size_t)i + (size_t)k]);
    if (c->nface > 0)
        put_three(file, c->centre);
    else
        fprintf(file, ",nan,nan,nan");
    if (in->labelled[0]) put_title(file, in->labels + in->label[i]);
    putc('\n', file);
}

/* normal - n, from point i to the cell beyond, which is whose's v: where
 * stretched, it is at right angles to what leads there. */
static void normal(const cells *c, tess_int i, tess_int v, double *n)
{
    const mesh *m = c->m;
    double most = 0.0, length;
    int side = (int)(-1 - v), k;

    for (k = 0; k < 3; k++) {
        if (c->again)
            n[k] = (double)c->around[3 * v + k];
        else if (v >= 0)
            n[k] = (double)m->p[3 * v + k] - (double)m->p[3 * i + k];
        else
            n[k] = k != side / 2 ? 0.0 : side % 2 ? 1.0 : -1.0;
        n[k] *= m->scale[k];
        if (fabs(n[k]) > most) most = fabs(n[k]);
    }
    for (k = 0; k < 3; k++) n[k] /= most;
    length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (k = 0; k < 3; k++) n[k] /= length;
}

/* put_faces - the rows of those faces of point i's cell that are not another's
 * already: of a side, a point of a higher number, or an image of its own in
 * one half of space. */
static void put_faces(FILE *file, const cells *c, tess_int i)
{
    const repeated *r = c->again;
    double x[3];
    tess_int f, v, w, base = c->m->in->base;
    int away[3], k, l;

    for (f = 0; f < c->nface; f++) {
        v = c->whose[f];
        w = beyond(c, f);
        if (w >= 0 && (w < i || (w == i && c->copy[v] < 0))) continue;
        fprintf(file, "%ld,%ld", (long)(i + base),
                (long)(w < 0 ? w : w + base));
        put_behind(file, ',', c->area[f]);
        put_three(file, c->middle + 3 * f);
        normal(c, i, v, x);
        put_three(file, x);
        x[0] = x[1] = x[2] = 0.0;
        if (r && w >= 0) {
            tr_unpack(c->copy[v], away);
            for (k = 0; k < 3; k++)
                away[k] += r->away[3 * w + k] - r->away[3 * i + k];
            for (k = 0; k < 3; k++)
                for (l = 0; l < 3; l++)
                    x[l] += away[k] * r->cell[3 * k + l] / c->m->scale[l];
        }
        put_three(file, x);
        putc('\n', file);
    }
}

/* measure_cells - each cell's volume and number of faces, and what they are in
 * all; rows of cells into some files, of faces into the others. */
static void measure_cells(cells *c, double *volume, tess_int *faces,
                          totals *all, FILE **file, int volumes, int files)
{
    double lost = 0.0, sum, v;
    tess_int i;
    int k;

    all->cells = all->vertices = all->numbers = all->volume = 0.0;
    for (i = 0; i < c->m->in->n; i++) {
        compute(c, i);
        v = volume[i] = c->volume;
        faces[i] = c->nface;
        if (files > 0) sizes(c);
        for (k = 0; k < files; k++) {
            (k < volumes ? put_volume : put_faces)(file[k], c, i);
            check_written(file[k]);
        }
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

/* tell_repeats - that the file's box repeats itself, if that is not used; and how
 * many points are not in the box. */
static void tell_repeats(const cells *c, const tess_int *faces)
{
    const points *in = c->m->in;
    tess_int i;
    double lost = 0.0;

    if (c->again) return;
    /* (a duplicate is in no tetrahedron) */
    for (i = 0; i < in->n; i++)
        lost += faces[i] == 0 && c->first[i] < c->first[i + 1];
    if (!chosen.boxed && in->lattice != NO_LATTICE &&
        (in->ways[0] || in->ways[1] || in->ways[2]))
        warn("%s: its box repeats itself, but the cells end at its sides: "
             "-periodic takes it so", in->input);
    if (lost > 0.0)
        warn("%s: %.0f point%s outside the box, without %s", in->input, lost,
             lost > 1.0 ? "s are" : " is", lost > 1.0 ? "cells" : "a cell");
}

void make_cells(const mesh *m)
{
    cells c;
    totals all;
    output *o;
    FILE **file = 0;
    double *volume, whole = 1.0, slack, side[3], longest = 0.0;
    tess_int *faces;
    const form *const rows[2] = {volumes_forms, faces_forms};
    int files = 0, volumes = 0, k;

    if (m->ntet == 0 && !chosen.periodic)
        fail("no cells: the points do not span space");
    prepare(&c, m);
    volume = doubles((double)m->in->n);
    faces = integers((double)m->in->n);
    say("computing %ld cells ...", (long)m->in->n);
    for (k = 0; k < 2; k++)
        for (o = 0; (o = next_output(rows[k], o)) != 0;) {
            file = (FILE **)more_space(file, files + 1.0, sizeof *file);
            file[files++] = start_rows(m->in, o);
            volumes += k == 0;
        }
    measure_cells(&c, volume, faces, &all, file, volumes, files);
    for (k = 0; k < 3; k++) {
        side[k] = c.box[2 * k + 1] - c.box[2 * k];
        if (c.again)
            side[k] = fabs(c.again->cell[k]) + fabs(c.again->cell[3 + k]) +
                      fabs(c.again->cell[6 + k]);
        side[k] /= m->scale[k];
        if (side[k] > longest) longest = side[k];
        whole *= side[k];
    }
    if (c.again) whole = c.again->volume;
    /* volumes are right but for roundings of lengths times surfaces */
    slack = 1e-15 * longest * (side[0] * side[1] + side[1] * side[2] +
                               side[2] * side[0]);
    if (!(whole > 0.0 && fabs(all.volume - whole) <= 1e-9 * whole + slack))
        fail("the cells' volumes sum to %.15g, but the box's is %.15g: use "
             "other units, as by -scale, or a smaller box", all.volume, whole);
    tell_repeats(&c, faces);
    tell("cells         %.0f, their volumes sum to %.15g; the box's is %.15g\n",
         all.cells, all.volume, whole);
    if (volumes > 0) tell_surface(m->in);
    for (o = 0; (o = next_output(cells_forms, o)) != 0;)
        write_cells(&c, o, volume, faces, &all);
    for (k = files = 0; k < 2; k++)
        for (o = 0; (o = next_output(rows[k], o)) != 0;)
            finish(file[files++], o);
    free(file);
    free(volume);
    free(faces);
    clear(&c);
}
