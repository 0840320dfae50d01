/* mesh.c - the mesh of points that no process holds whole, with MPI.
 *
 *   make mpi
 *   mpirun -np 8 build/mesh -raw FILE -o PREFIX
 *
 * gives the tetrahedra that tess gives for the points of the file, each written
 * by one process.  No process has an array of the length of all points (but
 * process 0 with -family, which makes them), or of the processes times points.
 * With a million points on 8 processes the largest takes 1.02 times an eighth
 * of the memory that tess takes.
 *
 *   FILE               native doubles, three a point; or -each F: a file for
 *                      each process, F.<rank>
 *   PREFIX.<rank>.tet  written by process <rank>: four vertices a tetrahedron,
 *                      numbers of points in the file, or in all files in turn
 *   PREFIX.<rank>.adj  the neighbours across the facets opposite to them,
 *                      numbered through all ranks' tetrahedra; -1 on the hull.
 *                      All are native 64-bit integers
 *   -vtu PREFIX        PREFIX.pvtu and its pieces, for ParaView; -values F:
 *                      native doubles, those of a point after those of the one
 *                      before it, at the points
 *
 *   split.c   Space is cut so that each process owns about as many points; they
 *             are sent to their owners.  A few extreme points are known to all.
 *   halo.c    The first guess: each process asks the others for the points near
 *             its own, and is sent a coarse sample of all.
 *   stars.c   It computes the tetrahedra at its own points, their stars, from
 *             the points that it knows (tess_index, tess_part), which need not
 *             be all it should know.  Then rounds, until all stars agree: of a
 *             tetrahedron that has vertices of several processes they exchange
 *             the hash.  What only one has, it sends; the others answer with
 *             the links of their vertices in their stars.  All of them compute
 *             the stars of these vertices again, from their links and what they
 *             have learned, and go on to other own points as far as these
 *             differ.
 *   output.c  A tetrahedron belongs to the owner of its vertex of least index.
 *             Neighbours in other processes are found by the facets' vertices.
 *   mail.c    Messages and tables.
 *
 * Why it is right.  Ties are broken as if the lifted height of each point were
 * lowered by an infinitesimal that depends on its index alone (hhpred.c), and
 * each process keeps what it knows in the order of the indices in the whole; so
 * in what follows no five points are on a sphere, and all sets of points are
 * treated alike.
 *
 * 1. The star of v in the mesh of a set K is made by the lower facets at v of
 *    the hull of the lifted K.  A lower edge v w of a set's hull is one in
 *    every subset that has both ends.  So if K has all neighbours of v in the
 *    mesh of a larger set, the star of v in K's mesh is that in the larger
 *    set's: the cone over it is the hull of the rays to these neighbours.
 *    (t_part tests that.)  For the same reason the star of v in K and new points
 *    N is that in v, the link of v in K, and N: repair has small sets.
 *
 * 2. Some star changes in every round while stars differ.  Let t be in the star
 *    of v, computed from K, and not in that of w, another vertex of t, computed
 *    from L.  (Their processes may know more: of a point that one learns only
 *    the stars near those that differ are told.)  If L has the vertices of t,
 *    some vertex of the link of w in L is inside the ball of t: else the cone
 *    of w's star, which is the hull of the rays to the link, would be above the
 *    plane of the lifted t, which touches it at t, and t would be in it.  In
 *    the round v's process has the link of w, w's the vertices of t, and both
 *    stars are computed from all that is known.  If a vertex of the link is in
 *    the ball of t, t goes.  If none is, L lacks a vertex of t, and with it the
 *    link of w cannot stay.  A star that changes is one in a larger set, so
 *    there are at most as many rounds as pairs of points.
 *
 * 3. Stars that agree are the mesh.  Each tetrahedron is then in the stars of
 *    all its vertices; so is each facet of the hull.  Each star fills a
 *    neighbourhood of its vertex in the hull of some set: together the stars
 *    are a compact space, triangulated, that is locally that of a convex body.
 *    By Tietze's and Nakajima's theorem, for maps, each of its components is a
 *    convex body triangulated; across each facet it is locally Delaunay, so it
 *    is the Delaunay tetrahedralization of its vertices.  Each point is a
 *    vertex of one component.  Let x be a point that all processes know, C a
 *    component.  At each vertex v of the hull of C the star has all of K in its
 *    cone, x too; so x is in the hull of C.  If it were no vertex of C, it
 *    would be in a tetrahedron of C, so in its ball, but it was known where that
 *    tetrahedron was found.  So all components contain x: there is one.
 *
 * With the links of 2 the processes learn what they need from whatever they
 * know at first (-blind); a better guess spares rounds.  This is star splaying
 * (R. Shewchuk, 2005) between processes instead of between points.  Hashes have
 * 64 bits: for two of 10^9 tetrahedra to have the same has a probability of
 * 10^-2, for that to hide a difference it must be two that differ.  It would
 * not be silent: output finds that the facets do not fit.
 */
#define _XOPEN_SOURCE 500
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <time.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "../lib/points.h"
#include "mesh.h"

/* in two: C89 promises 509 characters a string */
static const char *const usage[] = {
    "usage: mesh INPUT [-o PREFIX] [-vtu PREFIX [-values FILE]] [-blind]\n"
    "INPUT: -raw FILE      native doubles, three a point\n"
    "       -each PREFIX   the same, a file for each process: PREFIX.<rank>\n"
    "       -family NAME N points of test/lib/points.h, made by process 0\n",
    "-o     PREFIX.<rank>.tet: vertices, .adj: neighbours across the facets\n"
    "       opposite to them, -1 for none: native 64-bit integers\n"
    "-vtu   PREFIX.pvtu and its pieces, for ParaView; the points' values in\n"
    "       them, value, value2 and so on: native doubles, those of a point\n"
    "       after those of the one before it\n"
    "-blind begin with a few extreme points of others (a test)\n"};

/* number_points - the process has the next n points, in the order of the
 * processes: give them their indices. */
static void number_points(cloud *c, num n, const double *x)
{
    num i, base = 0;

    MPI_Exscan(&n, &base, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
    if (me == 0) base = 0;
    c->n = n;
    c->all = total(n);
    c->at = (point *)grow(NULL, n, sizeof *c->at);
    for (i = 0; i < n; i++) {
        c->at[i].index = base + i;
        memcpy(c->at[i].x, x + 3 * i, sizeof c->at[i].x);
    }
}

/* read_file - the whole file, or this process's part of it. */
static void read_file(cloud *c, const char *name, int whole)
{
    FILE *file = fopen(name, "rb");
    double *x;
    off_t bytes = 0;
    num n, begin = 0;

    if (!file || fseeko(file, 0, SEEK_END) != 0 || (bytes = ftello(file)) < 0)
        fail("cannot read the file of points");
    n = (num)bytes / (num)(3 * sizeof *x);
    if (n * (num)(3 * sizeof *x) != (num)bytes)
        fail("the file does not hold three doubles a point");
    if (!whole) {
        begin = (num)((double)n / ranks * me);
        n = (me == ranks - 1 ? n : (num)((double)n / ranks * (me + 1))) - begin;
    }
    if (n > TESS_INT_MOST / 40) fail("too many points: use more processes");
    x = (double *)grow(NULL, 3 * n, sizeof *x);
    if (fseeko(file, (off_t)(begin * (num)(3 * sizeof *x)), SEEK_SET) != 0 ||
        fread(x, 3 * sizeof *x, (size_t)n, file) != (size_t)n)
        fail("cannot read the file of points");
    fclose(file);
    number_points(c, n, x);
    free(x);
}

static void make(cloud *c, const char *family, long n)
{
    mail m;
    double *x;
    long i;

    mail_open(&m, 3 * sizeof *x);
    if (me == 0) {
        x = (double *)grow(NULL, 3 * (num)n, sizeof *x);
        n = points_make(family, n, 1, x);
        if (n == 0) fail("no such family of points");
        for (i = 0; i < n; i++)
            put(&m, (int)((double)i * ranks / (double)n), x + 3 * i);
        free(x);
    }
    exchange(&m, MOVE);
    number_points(c, m.n[0], (double *)m.at[0]);
    mail_close(&m);
    sent_bytes[MOVE] = 0.0;
}

/* check_finite - a NaN or infinity ends all. */
static void check_finite(const cloud *c)
{
    char text[80];
    num i;
    int k;

    for (i = 0; i < c->n; i++)
        for (k = 0; k < 3; k++) {
            if (c->at[i].x[k] >= -DBL_MAX) if (c->at[i].x[k] <= DBL_MAX)
                continue;
            sprintf(text, "point %.0f has a NaN or infinity",
                    (double)c->at[i].index);
            fail(text);
        }
}

/* megabytes - the most memory that the process has had. */
static double megabytes(void)
{
    struct rusage u;

    getrusage(RUSAGE_SELF, &u);
    return (double)u.ru_maxrss / 1024.0;
}

int main(int argc, char **argv)
{
    cloud c = {0, 0, NULL};
    mesh m;
    table sent = {0, 0, NULL, NULL};
    point shared[SHARED], *foreign;
    double sum[KINDS + 2], most[3], base;
    const char *prefix = NULL, *vtu = NULL, *family = NULL, *raw = NULL;
    const char *each = NULL, *values = NULL;
    long asked = 0;
    num n, ntet = 0;
    clock_t start;
    int blind = 0, i, code, nshared;

#ifdef M_MMAP_THRESHOLD
    /* what a large array had goes back to the system, whatever came after it */
    mallopt(M_MMAP_THRESHOLD, 65536);
#endif
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    for (i = 1; i < argc; i++) {
        if (strcmp(argv[i], "-blind") == 0)
            blind = 1;
        else if (strcmp(argv[i], "-family") == 0 && i + 2 < argc) {
            family = argv[++i];
            asked = atol(argv[++i]);
        } else if (strcmp(argv[i], "-raw") == 0 && i + 1 < argc)
            raw = argv[++i];
        else if (strcmp(argv[i], "-each") == 0 && i + 1 < argc)
            each = argv[++i];
        else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc)
            prefix = argv[++i];
        else if (strcmp(argv[i], "-vtu") == 0 && i + 1 < argc)
            vtu = argv[++i];
        else if (strcmp(argv[i], "-values") == 0 && i + 1 < argc)
            values = argv[++i];
        else
            break;
    }
    if (i < argc || !raw + !each + !family != 2 || (values && !vtu)) {
        if (me == 0) fputs(usage[0], stderr), fputs(usage[1], stderr);
        MPI_Finalize();
        return 2;
    }
    base = megabytes();
    if (family) make(&c, family, asked);
    if (raw) read_file(&c, raw, 0);
    if (each) {
        char *name = (char *)grow(NULL, (num)strlen(each) + 40, 1);

        sprintf(name, "%s.%d", each, me);
        read_file(&c, name, 1);
        free(name);
    }
    check_finite(&c);
    if (values) open_values(values, c.all);
    memset(&m, 0, sizeof m);
    start = clock();
    split(&c);
    most[2] = (double)c.n;
    nshared = known_to_all(&c, shared, &code);
    if (code == 0) {
        foreign = first_guess(&c, shared, nshared, blind, &n, &sent);
        stars(&m, &c, foreign, n, &sent);
        forget(&sent);
    }
    ntet = output(&m, prefix);
    most[0] = sum[0] = (double)(m.finished - start) / CLOCKS_PER_SEC;
    most[1] = megabytes() - base;
    sum[1] = m.known;
    for (i = 0; i < KINDS; i++) sum[2 + i] = sent_bytes[i] / 1e6;
    if (vtu) write_vtu(&m, vtu);
    reduce(sum, KINDS + 2, MPI_DOUBLE, MPI_SUM);
    reduce(most, 3, MPI_DOUBLE, MPI_MAX);
    if (me == 0)
        printf("mesh: processes %d points %.0f code %d tetrahedra %.0f rounds "
               "%d known %.2f cpu %.3fs most %.3fs memory %.1fMB owned %.0f "
               "move %.2fMB halo %.2fMB hashes %.2fMB stars %.2fMB "
               "sides %.2fMB\n",
               ranks, (double)c.all, code, (double)ntet, m.rounds,
               c.all > 0 ? sum[1] / (double)c.all : 0.0, sum[0], most[0],
               most[1], most[2], sum[2 + MOVE], sum[2 + HALO],
               sum[2 + HASHES], sum[2 + POINTS], sum[2 + SIDES]);
    MPI_Finalize();
    return code;
}
