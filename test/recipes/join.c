/* join.c - a mesh in parts, joined: recipes to copy.
 *
 *   tr_keep, tr_append   what the parts keep, put together
 *   tr_join              neighbours across the facets that are still open
 *                        (onside)
 *
 * For meshes by several threads; parts.c is a program that does it, and join.f
 * the same in FORTRAN 77.
 *
 *   1. tess_index sorts the points, in an iw of 7 n + 600 or what tess_size
 *      says.  rw is shared by all, the first 7 n + 600 numbers of iw are copied
 *      for each.
 *   2. Each thread asks tess_part for the points of a range of positions
 *      (iw[i]), of about the same length, so for points near each other.
 *   3. tr_keep tells which of its tetrahedra the part keeps, those whose vertex
 *      of least index is asked for there: each tetrahedron of the mesh is kept
 *      by one part.  tr_append puts these behind those of the parts before; the
 *      threads may do it at the same time.
 *   4. tr_join closes the facets that are open.  No geometry: both sides of a
 *      facet have the same vertices.
 *
 * The result is the set of tetrahedra that tess gives, in another order, and
 * passes tess_check.  If a part is missing, tess_resume computes it: let what
 * was TESS_OPEN before tr_join and is TESS_NONE behind it be TESS_OPEN again.
 *
 * Workspace.  The copy of the index has room for all that tess_part needs but
 * open facets, for which TESS_LIW(m) is room enough in a part with m points
 * asked for, but for points that have very many neighbours: TESS_POOL.  So
 *     liw = 7 n + 600 + TESS_LIW(m)
 */
#include "recipes.h"

/* tr_keep - which tetrahedra of a part are kept?
 *
 *   ntet, tet  (in)   what tess_part gave
 *   mine       (in)   as given to tess_part, of points none of which is a
 *                     duplicate or those with their duplicates in one part
 *   becomes    (out)  ntet: the number among those kept, or TESS_OPEN
 *
 * returns how many. */
tess_int tr_keep(tess_int ntet, const tess_int *tet, const tess_int *mine,
                 tess_int *becomes)
{
    tess_int t, least, kept = 0;
    const tess_int *v;
    int k;

    for (t = 0; t < ntet; t++) {
        v = tet + 4 * t;
        for (least = v[0], k = 1; k < 4; k++) if (v[k] < least) least = v[k];
        becomes[t] = mine[least] != 0 ? kept++ : TESS_OPEN;
    }
    return kept;
}

/* tr_append - put what a part keeps into the result.
 *
 *   ntet, tet, adj  (in)      what tess_part gave
 *   becomes         (in)      what tr_keep gave
 *   base            (in)      how many the parts before keep
 *   all, alladj     (in,out)  the result: tet and adj of those kept, from base
 *                             on; neighbours that others keep are TESS_OPEN */
void tr_append(tess_int ntet, const tess_int *tet, const tess_int *adj,
               const tess_int *becomes, tess_int base, tess_int *all,
               tess_int *alladj)
{
    tess_int t, u;
    int k;

    for (t = 0; t < ntet; t++) {
        if (becomes[t] < 0) continue;
        for (k = 0; k < 4; k++) {
            u = adj[4 * t + k];
            if (u >= 0) u = becomes[u] < 0 ? TESS_OPEN : base + becomes[u];
            all[4 * (base + becomes[t]) + k] = tet[4 * t + k];
            alladj[4 * (base + becomes[t]) + k] = u;
        }
    }
}

/* onside - the vertices of facet i % 4 of tetrahedron i / 4, in order.  Returns
 * which side of it the tetrahedron is on, 0 or 1. */
static int onside(const tess_int *tet, tess_int i, tess_int *v)
{
    tess_int swap;
    int k, n = 0, side = (int)(i % 4 % 2);

    for (k = 0; k < 4; k++)
        if (k != (int)(i % 4)) v[n++] = tet[i - i % 4 + k];
    for (k = 0; k < 3; k++)
        if (v[k % 2] > v[k % 2 + 1]) {
            swap = v[k % 2];
            v[k % 2] = v[k % 2 + 1];
            v[k % 2 + 1] = swap;
            side = !side;
        }
    return side;
}

/* tr_join - close the facets that are open on both sides.  What is open on one
 * side alone is then on the hull.
 *
 *   ntet, tet  (in)      all tetrahedra of the mesh, each once
 *   adj        (in,out)  neighbours; TESS_OPEN where they are sought
 *   lh         (in)      length of h, more than there are open facets: tess's
 *                        workspace will do
 *   h          (out)     a hash table of facets
 *
 * returns 0; 1 where more than one tetrahedron is on a side of a facet; -4 for
 * an lh that is too small.
 * Cost: two passes over adj, and a visit to the table for each open facet. */
int tr_join(tess_int ntet, const tess_int *tet, tess_int *adj, tess_int lh,
            tess_int *h)
{
    tess_int i, at, size, open = 0, v[3], w[3];
    int side, other;

    for (i = 0; i < 4 * ntet; i++) if (adj[i] == TESS_OPEN) open++;
    if (lh <= open) return -4;
    size = open < lh / 2 ? (tess_int)(2 * open + 1) : lh;
    for (i = 0; i < size; i++) h[i] = TESS_NONE;
    for (i = 0; i < 4 * ntet; i++) {
        if (adj[i] != TESS_OPEN) continue;
        side = onside(tet, i, v);
        at = (tess_int)(((unsigned long)v[0] * 40503UL +
                         (unsigned long)v[1] * 30011UL +
                         (unsigned long)v[2] * 20011UL) % (unsigned long)size);
        for (; h[at] != TESS_NONE; at = at == 0 ? size - 1 : at - 1) {
            other = onside(tet, h[at], w);
            if (v[0] != w[0] || v[1] != w[1] || v[2] != w[2]) continue;
            if (side == other || adj[h[at]] != TESS_OPEN) return 1;
            adj[h[at]] = i / 4;
            adj[i] = h[at] / 4;
            break;
        }
        if (h[at] == TESS_NONE) h[at] = i;
    }
    for (i = 0; i < 4 * ntet; i++)
        if (adj[i] == TESS_OPEN) adj[i] = TESS_NONE;
    return 0;
}
