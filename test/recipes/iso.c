/* iso.c - the surface where a field has a given value: a recipe to copy.
 *
 *   tr_iso  the triangles of one level  (known, below, key, point, triangle,
 *                                        between, cross, cap)
 *
 * The field is linear in each tetrahedron, and so a tetrahedron has of the
 * surface nothing, a triangle, or a flat quadrilateral, which two triangles
 * are: marching tetrahedra.  A point of the surface lies on an edge of the
 * mesh, or is a point of the mesh whose value is the level; by that it is
 * known, so that all triangles about it share one point.
 *
 * A value that equals the level counts as above it.  What then has no area is
 * left out: a triangle with a point twice; a facet all of whose values are the
 * level, unless it has a tetrahedron above it on one side and one below it on
 * the other.  So the surface is just the boundary between what is above and
 * what is below.  Triangles are counter-clockwise as seen from below: normals
 * point from high values to low ones, outwards of what is above.
 *
 * Every edge that is not on the hull has as many triangles in one direction as
 * in the other: one each, where no value equals the level.  (Where values do,
 * parts of the surface may touch along an edge.)  Along the hull the surface is
 * open; or it is closed by what of the hull is above the level, and then
 * encloses just that.
 *
 * A tetrahedron with a value that is NaN or infinite counts as one beyond the
 * hull.  Where the level is within roundings of a value, points of several
 * edges may have the same coordinates; they are different points all the same,
 * and triangles of no area have their place between them.
 *
 * t_iso.c tests it; iso.f is the same in FORTRAN 77.
 */
#include "recipes.h"

/* shell - what is given to tr_iso, and what it has so far. */
typedef struct shell {
    const tess_real *p;
    const tess_int *tet, *adj;
    const double *value;
    double level;
    tess_int maxpt, npt, maxtri, ntri;
    tess_int *ends, *tri, *table;
    tess_real *x;
    int full; /* was there no room for a point? */
} shell;

/* known - are all values of tetrahedron t finite, and is it one? */
static int known(const shell *s, tess_int t)
{
    double f;
    int k;

    if (t < 0) return 0;
    for (k = 0; k < 4; k++) {
        f = s->value[s->tet[4 * t + k]];
        if (!(f - f == 0.0)) return 0;
    }
    return 1;
}

static int below(const shell *s, tess_int v)
{
    return s->value[v] < s->level;
}

/* key - where the edge from u, above, to w, below, meets the surface: its ends,
 * the lesser one first; u twice, where that is a point of the surface.  (Of the
 * hull it is also a corner, u = w.) */
static void key(const shell *s, tess_int u, tess_int w, tess_int *k)
{
    if (s->value[u] == s->level) w = u;
    k[0] = u < w ? u : w;
    k[1] = u < w ? w : u;
}

/* point - the number of the point with that key, a new one's, too; -1 when
 * there is no room for that.
 *
 * The table is searched from a place on that the key says: the fraction of a
 * sum of multiples of 2^-21, which is exact below 2^31, so that it is the same
 * wherever it is computed.
 *
 * From the end whose value is nearer, in halves: so that x is between the ends,
 * whatever the rounding, and no difference is beyond doubles. */
static tess_int point(shell *s, const tess_int *k)
{
    tess_int size = (tess_int)(2 * s->maxpt + 1), at, i, a = k[0], b = k[1];
    double w, f, g, h;
    int j;

    w = ((double)a * 1583093.0 + (double)b * 1195041.0) / 2097152.0;
    at = (tess_int)((w - (double)(tess_int)w) * (double)size);
    for (; s->table[at] > 0; at = at + 1 < size ? at + 1 : 0) {
        i = s->table[at] - 1;
        if (s->ends[2 * i] == a && s->ends[2 * i + 1] == b) return i;
    }
    i = s->npt;
    if (i >= s->maxpt) {
        s->full = 1;
        return -1;
    }
    s->table[at] = ++s->npt;
    s->ends[2 * i] = a;
    s->ends[2 * i + 1] = b;
    w = 0.0;
    if (a != b) {
        f = s->value[a];
        g = s->value[b];
        h = s->level;
        if (f > 1e300 || f < -1e300 || g > 1e300 || g < -1e300) {
            f *= 0.5;
            g *= 0.5;
            h *= 0.5;
        }
        w = (h - f) / (g - f);
        if (w > 0.5) {
            w = (h - g) / (f - g);
            a = k[1];
            b = k[0];
        }
    }
    for (j = 0; j < 3; j++) {
        f = 0.5 * (double)s->p[3 * a + j];
        g = 0.5 * (double)s->p[3 * b + j];
        s->x[3 * i + j] =
            (tess_real)((double)s->p[3 * a + j] + 2.0 * w * (g - f));
    }
    return i;
}

/* triangle - one with these keys, if they are three. */
static void triangle(shell *s, const tess_int *a, const tess_int *b,
                     const tess_int *c)
{
    tess_int *v;

    if (a[0] == b[0] && a[1] == b[1]) return;
    if (b[0] == c[0] && b[1] == c[1]) return;
    if (c[0] == a[0] && c[1] == a[1]) return;
    if (s->ntri < s->maxtri && !s->full) {
        v = s->tri + 3 * s->ntri;
        v[0] = point(s, a);
        v[1] = point(s, b);
        v[2] = point(s, c);
    }
    s->ntri++;
}

/* between - is what is beyond facet k of tetrahedron t, one whose values are
 * the level, above it? */
static int between(const shell *s, tess_int t, int k)
{
    tess_int u = s->adj[4 * t + k];
    int j;

    if (!known(s, u)) return 0;
    for (j = 0; j < 3 && s->adj[4 * u + j] != t;) j++;
    return !below(s, s->tet[4 * u + j]);
}

/* cross - what tetrahedron t, known, has of the surface.
 *
 * Its vertices i, i^1, i^2, i^3 are an even order of them, whatever i, and so
 * is that with the last three turned around: seen from vertex i these three are
 * clockwise. */
static void cross(shell *s, tess_int t)
{
    const tess_int *v = s->tet + 4 * t;
    tess_int a, b[3], q[4][2];
    int many = 0, equal = 0, i, k, turn = 0;

    for (k = 0; k < 4; k++) {
        many += !below(s, v[k]);
        equal += s->value[v[k]] == s->level;
    }
    if (many == 0 || many == 4) return;
    /* the one that is alone on its side, or the first one of two above */
    for (i = 0; below(s, v[i]) != many / 3;) i++;
    a = v[i];
    while (many == 2 && below(s, v[i ^ (turn + 1)])) turn++;
    for (k = 0; k < 3; k++) b[k] = v[i ^ ((k + turn) % 3 + 1)];
    if (many == 1) {
        for (k = 0; k < 3; k++) key(s, a, b[k], q[k]);
        triangle(s, q[0], q[1], q[2]);
    } else if (many == 3) {
        if (equal == 3 && !between(s, t, i)) return;
        for (k = 0; k < 3; k++) key(s, b[k], a, q[k]);
        triangle(s, q[0], q[2], q[1]);
    } else {
        key(s, a, b[1], q[0]);
        key(s, a, b[2], q[1]);
        key(s, b[0], b[2], q[2]);
        key(s, b[0], b[1], q[3]);
        triangle(s, q[0], q[1], q[2]);
        triangle(s, q[0], q[2], q[3]);
    }
}

/* cap - what of facet k of tetrahedron t is above the level. */
static void cap(shell *s, tess_int t, int k)
{
    const tess_int *v = s->tet + 4 * t;
    tess_int b[3], q[4][2];
    int many = 0, equal = 0, i, turn = 0;

    for (i = 0; i < 3; i++) {
        b[i] = v[k ^ (i + 1)];
        many += !below(s, b[i]);
        equal += s->value[b[i]] == s->level;
    }
    if (many == 0 || (equal == 3 && below(s, v[k]))) return;
    /* the one that is alone on its side comes first */
    while (many < 3 && below(s, b[turn]) != many / 2) turn++;
    for (i = 0; i < 3; i++) b[i] = v[k ^ ((i + turn) % 3 + 1)];
    if (many == 1) {
        key(s, b[0], b[0], q[0]);
        key(s, b[0], b[1], q[1]);
        key(s, b[0], b[2], q[2]);
        triangle(s, q[0], q[1], q[2]);
    } else if (many == 3) {
        for (i = 0; i < 3; i++) key(s, b[i], b[i], q[i]);
        triangle(s, q[0], q[1], q[2]);
    } else {
        key(s, b[1], b[1], q[0]);
        key(s, b[2], b[2], q[1]);
        key(s, b[2], b[0], q[2]);
        key(s, b[1], b[0], q[3]);
        triangle(s, q[0], q[1], q[2]);
        triangle(s, q[0], q[2], q[3]);
    }
}

/* tr_iso - the surface where the field, linear in each tetrahedron, is level.
 *
 *   p, ntet, tet, adj  (in)   a mesh of tess, or a part of one
 *   value              (in)   a value for each point
 *   level              (in)   that of the surface; NaN has none
 *   closed             (in)   1: with that part of the hull that is above the
 *                             level; 0: without
 *   maxpt              (in)   points that there is room for: 3 a triangle are
 *                             always enough; where the surface is closed, 1
 *   npt, x             (out)  number of points; 3*maxpt: their coordinates
 *   ends               (out)  2*maxpt: point i is between the points
 *                             ends[2*i] < ends[2*i+1] of the mesh; or it is
 *                             that one, where they are the same
 *   maxtri             (in)   triangles that there is room for
 *   ntri               (out)  number of triangles, even when there is no room
 *   tri                (out)  3*maxtri: triangle f has the points tri[3*f] ...
 *                             tri[3*f+2], counter-clockwise as seen from below
 *   iwork                     2*maxpt + 1
 *
 * The order of points and triangles is that of the tetrahedra.
 *
 * returns 0; 1 when there is no room for triangles, 2 for points: then ntri
 * alone holds. */
int tr_iso(const tess_real *p, tess_int ntet, const tess_int *tet,
           const tess_int *adj, const double *value, double level, int closed,
           tess_int maxpt, tess_int *npt, tess_real *x, tess_int *ends,
           tess_int maxtri, tess_int *ntri, tess_int *tri, tess_int *iwork)
{
    shell s;
    tess_int t;
    int k;

    s.p = p;
    s.tet = tet;
    s.adj = adj;
    s.value = value;
    s.level = level;
    s.maxpt = maxpt;
    s.maxtri = maxtri;
    s.npt = s.ntri = 0;
    s.x = x;
    s.ends = ends;
    s.tri = tri;
    s.table = iwork;
    s.full = 0;
    for (t = 0; t < 2 * maxpt + 1; t++) iwork[t] = 0;
    for (t = 0; t < ntet && level - level == 0.0; t++) {
        if (!known(&s, t)) continue;
        cross(&s, t);
        for (k = 0; k < 4 && closed; k++)
            if (!known(&s, adj[4 * t + k])) cap(&s, t, k);
    }
    *npt = s.npt;
    *ntri = s.ntri;
    if (s.ntri > maxtri) return 1;
    return s.full ? 2 : 0;
}
