/* mesh.c - main */
#define _XOPEN_SOURCE 500
#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include "../points.h"
#include "mesh.h"

static const char usage[] =
    "usage: mesh INPUT [-o PREFIX] [-vtu PREFIX] [-blind]\n"
    "INPUT: -raw FILE      native doubles, three a point\n"
    "       -each PREFIX   the same, in a file for each process: PREFIX.<rank>\n"
    "       -family NAME N points of test/points.h, made by process 0\n"
    "-o     PREFIX.<rank>.tet: vertices, .adj: neighbours across the facets\n"
    "       opposite to them, -1 for none: native 64-bit integers\n"
    "-vtu   PREFIX.pvtu and its pieces, for ParaView\n"
    "-blind begin with a few extreme points of others (a test)\n";

/* number_points - the process has the next n points: give them their indices, in
 * the order of the processes. */
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

static void read_file(cloud *c, const char *name, int whole)
{
    MPI_Datatype type;
    MPI_File file;
    MPI_Offset bytes;
    MPI_Status status;
    double *x;
    num n, begin = 0;
    int count = 0;

    if (MPI_File_open(whole ? MPI_COMM_SELF : MPI_COMM_WORLD, name,
                      MPI_MODE_RDONLY, MPI_INFO_NULL, &file) != MPI_SUCCESS ||
        MPI_File_get_size(file, &bytes) != MPI_SUCCESS)
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
    MPI_Type_contiguous(3, MPI_DOUBLE, &type);
    MPI_Type_commit(&type);
    if (MPI_File_read_at(file, begin * (MPI_Offset)(3 * sizeof *x), x, (int)n,
                         type, &status) != MPI_SUCCESS ||
        MPI_Get_count(&status, type, &count) != MPI_SUCCESS || count != (int)n)
        fail("cannot read the file of points");
    MPI_Type_free(&type);
    MPI_File_close(&file);
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

/* -2 and ...: as tess */
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
    double figures[KINDS + 2], worst[3], base;
    const char *prefix = NULL, *vtu = NULL, *family = NULL, *raw = NULL;
    const char *each = NULL;
    long asked = 0;
    num n, ntet = 0;
    clock_t start;
    int blind = 0, i, code, nshared;

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
        else
            break;
    }
    if (i < argc || !raw + !each + !family != 2) {
        if (me == 0) fputs(usage, stderr);
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
    if (family) base = megabytes() - (double)c.n * sizeof(point) / 1048576;
    memset(&m, 0, sizeof m);
    start = clock();
    split(&c);
    nshared = known_to_all(&c, shared, &code);
    worst[2] = (double)c.n;
    figures[KINDS] = 0.0;
    if (code == 0) {
        foreign = first_guess(&c, shared, nshared, blind, &n, &sent);
        stars(&m, &c, foreign, n, &sent);
        forget(&sent);
    }
    figures[KINDS + 1] = 0.0;
    if (code == 0) {
        ntet = output(&m, prefix);
    } else
        ntet = output(&m, prefix);
    figures[KINDS] = (double)(clock() - start) / CLOCKS_PER_SEC;
    figures[KINDS + 1] = m.known;
    for (i = 0; i < KINDS; i++) figures[i] = sent_bytes[i] / 1e6;
    worst[0] = figures[KINDS];
    worst[1] = megabytes() - base;
    if (vtu) write_vtu(&m, vtu);
    reduce(figures, KINDS + 2, MPI_DOUBLE, MPI_SUM);
    reduce(worst, 3, MPI_DOUBLE, MPI_MAX);
    if (me == 0)
        printf("points %.0f processes %d tetrahedra %.0f code %d rounds %d "
               "known %.2f cpu %.2f worst %.2f memory %.1f most %.0f move %.1f "
               "halo %.1f hashes %.1f points %.1f sides %.1f\n", (double)c.all,
               ranks, (double)ntet, code, m.rounds, figures[KINDS + 1] / (double)c.all,
               figures[KINDS], worst[0], worst[1], worst[2], figures[MOVE],
               figures[HALO], figures[HASHES], figures[POINTS],
               figures[SIDES]);
    MPI_Finalize();
    return code;
}
