/* output.c - numbers, neighbours in other processes, files; see mesh.c. */
#define _XOPEN_SOURCE 500
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "mesh.h"

/* An open facet, as it is sent to who can match it. */
typedef struct side {
    uint64_t hash;
    num number; /* of its tetrahedron */
} side;

/* kept - does this process write tetrahedron t?  The owner of the vertex of
 * least index does. */
static int kept(const mesh *m, tess_int t)
{
    const tess_int *v = m->tet + 4 * t;
    int k, least = 0;

    if (v[0] == TESS_NONE) return 0;
    if (INNER(m, v)) return 1;
    for (k = 1; k < 4; k++)
        if (m->index[v[k]] < m->index[v[least]]) least = k;
    return m->owner[v[least]] == me;
}

/* least_of - the vertex of least index of a facet, and its hash. */
static tess_int least_of(const mesh *m, tess_int t, int k, uint64_t *h)
{
    const tess_int *v = m->tet + 4 * t;
    tess_int least = TESS_NONE;
    num index[3];
    int i, n = 0;

    for (i = 0; i < 4; i++)
        if (i != k) {
            index[n++] = m->index[v[i]];
            if (least == TESS_NONE || m->index[v[i]] < m->index[least])
                least = v[i];
        }
    *h = hash(index, 3);
    return least;
}

static FILE *open_file(const char *prefix, int r, const char *end)
{
    char *name = (char *)grow(NULL, (num)strlen(prefix) + 40, 1);
    FILE *file;

    if (r < 0)
        sprintf(name, "%s%s", prefix, end);
    else
        sprintf(name, "%s.%d%s", prefix, r, end);
    file = fopen(name, "wb");
    if (!file) fail("cannot open a file to write");
    free(name);
    return file;
}

static void put_items(FILE *file, const void *at, size_t size, num n)
{
    if (n > 0 && fwrite(at, size, (size_t)n, file) != (size_t)n)
        fail("cannot write a file");
}

static void close_file(FILE *file)
{
    if (fclose(file) != 0) fail("cannot write a file");
}

/* match - answer each side by the number of the tetrahedron on its other side,
 * or NONE where nobody else has sent one. */
static void match(const mail *sides, mail *answers)
{
    table waiting = {0, 0, NULL, NULL};
    const side *s;
    num *number, *other, i, n = 0;
    int *at, r;

    for (r = 0; r < ranks; r++) n += sides->n[r];
    number = (num *)grow(NULL, n, sizeof *number);
    other = (num *)grow(NULL, n, sizeof *other);
    for (r = 0, n = 0; r < ranks; r++)
        for (i = 0; i < sides->n[r]; i++, n++) {
            s = (const side *)sides->at[r] + i;
            number[n] = s->number;
            other[n] = TESS_NONE;
            at = find(&waiting, s->hash);
            if (*at == ABSENT) {
                *at = (int)n;
                continue;
            }
            if (other[*at] != TESS_NONE) fail("three tetrahedra at a facet");
            other[n] = number[*at];
            other[*at] = number[n];
        }
    for (r = 0, n = 0; r < ranks; r++)
        for (i = 0; i < sides->n[r]; i++) put(answers, r, other + n++);
    free(number);
    free(other);
    forget(&waiting);
}

num output(mesh *m, const char *prefix)
{
    mail sides, answers;
    FILE *file = NULL;
    MPI_Request request;
    side s;
    tess_int t, u, *becomes, n = 0;
    num v[4], mine, base = 0, all, hull = 0, *from;
    int k, r;

    becomes = (tess_int *)grow(NULL, m->ntet, sizeof *becomes);
    for (t = 0; t < m->ntet; t++)
        becomes[t] = kept(m, t) ? n++ : TESS_NONE;
    mine = n;
    MPI_Iexscan(&mine, &base, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD,
                &request);
    wait_for(&request);
    if (me == 0) base = 0;
    all = total(mine);
    mail_open(&sides, sizeof s);
    mail_open(&answers, sizeof(num));
    for (t = 0; t < m->ntet; t++)
        for (k = 0; k < 4 && m->tet[4 * t] != TESS_NONE; k++) {
            u = m->adj[4 * t + k];
            if (u >= 0 && (becomes[t] < 0 || becomes[u] >= 0)) continue;
            r = m->owner[least_of(m, t, k, &s.hash)];
            /* a facet of the hull is counted here, where it is known to be one,
             * and counted off where it is found to be one */
            if (u == TESS_NONE) hull += (r == me) - (becomes[t] >= 0);
            if (u == TESS_NONE || becomes[t] < 0) continue;
            s.number = base + becomes[t];
            put(&sides, r, &s);
        }
    exchange(&sides, SIDES);
    match(&sides, &answers);
    mail_close(&sides);
    exchange(&answers, SIDES);
    for (r = 0; r < ranks; r++)
        for (from = (num *)answers.at[r]; from < (num *)answers.at[r] +
                                              answers.n[r]; from++)
            if (*from == TESS_NONE) hull--;
    if (total(hull) != 0) fail("the stars do not fit together");
    m->finished = clock();
    if (prefix) file = open_file(prefix, me, ".tet");
    for (t = 0; t < m->ntet && file; t++) {
        for (k = 0; k < 4 && becomes[t] >= 0; k++)
            v[k] = m->index[m->tet[4 * t + k]];
        if (becomes[t] >= 0) put_items(file, v, sizeof *v, 4);
    }
    if (file) {
        close_file(file);
        file = open_file(prefix, me, ".adj");
        from = (num *)grow(NULL, ranks, sizeof *from);
        for (r = 0; r < ranks; r++) from[r] = 0;
        for (t = 0; t < m->ntet; t++) {
            for (k = 0; k < 4 && becomes[t] >= 0; k++) {
                u = m->adj[4 * t + k];
                v[k] = u;
                if (u >= 0) v[k] = base + becomes[u];
                if (u == TESS_NONE || (u >= 0 && becomes[u] >= 0)) continue;
                r = m->owner[least_of(m, t, k, &s.hash)];
                v[k] = ((num *)answers.at[r])[from[r]++];
            }
            if (becomes[t] >= 0) put_items(file, v, sizeof *v, 4);
        }
        close_file(file);
        free(from);
    }
    mail_close(&answers);
    free(becomes);
    return all;
}

/* ---- VTK ---- */

static FILE *values;
static int columns; /* doubles a point in it */

void open_values(const char *name, num all)
{
    num size = all * (num)sizeof(double);
    off_t bytes = 0;

    values = fopen(name, "rb");
    if (!values || fseeko(values, 0, SEEK_END) != 0 ||
        (bytes = ftello(values)) < 0)
        fail("cannot read the file of values");
    columns = size > 0 ? (int)(bytes / size) : 0;
    if (columns * size != (num)bytes)
        fail("the file of values does not hold as many doubles for each point");
}

/* put_value - value k of a point. */
static void put_value(FILE *file, num index, int k)
{
    double value;

    if (fseeko(values, (off_t)((index * columns + k) * (num)sizeof value),
               SEEK_SET) != 0 || fread(&value, sizeof value, 1, values) != 1)
        fail("cannot read the file of values");
    put_items(file, &value, sizeof value, 1);
}

/* The arrays of a piece, and those of values, named as build/tess does. */
static const char *const array[] = {
    "DataArray type=\"Float64\" Name=\"points\" NumberOfComponents=\"3\"",
    "DataArray type=\"Int64\" Name=\"index\"",
    "DataArray type=\"Int64\" Name=\"connectivity\"",
    "DataArray type=\"Int64\" Name=\"offsets\"",
    "DataArray type=\"UInt8\" Name=\"types\""};

static const char *order_of_bytes(void)
{
    int one = 1;

    return *(char *)&one == 1 ? "LittleEndian" : "BigEndian";
}

static const char *value_array(int k)
{
    static char text[80];
    char number[20] = "";

    if (k > 0) sprintf(number, "%d", k + 1);
    sprintf(text, "DataArray type=\"Float64\" Name=\"value%s\"", number);
    return text;
}

/* appended - where an array begins in what is appended. */
static void appended(FILE *file, const char *what, num *offset, num n,
                     size_t size)
{
    fprintf(file, "<%s format=\"appended\" offset=\"%.0f\"/>\n", what,
            (double)*offset);
    *offset += 8 + n * (num)size;
}

static void begin_block(FILE *file, num n, size_t size)
{
    uint64_t bytes = (uint64_t)n * size;

    put_items(file, &bytes, sizeof bytes, 1);
}

void write_vtu(const mesh *m, const char *prefix)
{
    FILE *file = open_file(prefix, me, ".vtu");
    tess_int i, t, *place;
    const char *name;
    num n = 0, points = 0, offset = 0, v;
    int k, r;
    unsigned char type = 10;

    place = (tess_int *)grow(NULL, m->n, sizeof *place);
    for (i = 0; i < m->n; i++) place[i] = TESS_NONE;
    for (t = 0; t < m->ntet; t++)
        if (kept(m, t))
            for (k = 0, n++; k < 4; k++) place[m->tet[4 * t + k]] = 0;
    for (i = 0; i < m->n; i++) if (place[i] == 0) place[i] = (tess_int)points++;
    fprintf(file, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" "
            "version=\"1.0\" byte_order=\"%s\" header_type=\"UInt64\">\n"
            "<UnstructuredGrid>\n<Piece NumberOfPoints=\"%.0f\" "
            "NumberOfCells=\"%.0f\">\n<Points>\n", order_of_bytes(),
            (double)points, (double)n);
    appended(file, array[0], &offset, 3 * points, sizeof(double));
    fprintf(file, "</Points>\n<PointData>\n");
    appended(file, array[1], &offset, points, sizeof(num));
    for (k = 0; k < columns; k++)
        appended(file, value_array(k), &offset, points, sizeof(double));
    fprintf(file, "</PointData>\n<Cells>\n");
    appended(file, array[2], &offset, 4 * n, sizeof(num));
    appended(file, array[3], &offset, n, sizeof(num));
    appended(file, array[4], &offset, n, 1);
    fprintf(file, "</Cells>\n</Piece>\n</UnstructuredGrid>\n"
            "<AppendedData encoding=\"raw\">\n_");
    begin_block(file, 3 * points, sizeof(double));
    for (i = 0; i < m->n; i++)
        if (place[i] >= 0) put_items(file, m->x + 3 * i, sizeof(double), 3);
    begin_block(file, points, sizeof(num));
    for (i = 0; i < m->n; i++)
        if (place[i] >= 0) put_items(file, m->index + i, sizeof(num), 1);
    for (k = 0; k < columns; k++) {
        begin_block(file, points, sizeof(double));
        for (i = 0; i < m->n; i++)
            if (place[i] >= 0) put_value(file, m->index[i], k);
    }
    begin_block(file, 4 * n, sizeof(num));
    for (t = 0; t < m->ntet; t++)
        for (k = 0; k < 4 && kept(m, t); k++) {
            v = place[m->tet[4 * t + k]];
            put_items(file, &v, sizeof v, 1);
        }
    begin_block(file, n, sizeof(num));
    for (v = 4; v <= 4 * n; v += 4) put_items(file, &v, sizeof v, 1);
    begin_block(file, n, 1);
    for (v = 0; v < n; v++) put_items(file, &type, 1, 1);
    fprintf(file, "\n</AppendedData>\n</VTKFile>\n");
    close_file(file);
    free(place);
    if (me != 0) return;
    file = open_file(prefix, -1, ".pvtu");
    fprintf(file, "<?xml version=\"1.0\"?>\n<VTKFile type="
            "\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"%s\" "
            "header_type=\"UInt64\">\n<PUnstructuredGrid GhostLevel=\"0\">\n"
            "<PPoints>\n<P%s/>\n</PPoints>\n<PPointData>\n<P%s/>\n",
            order_of_bytes(), array[0], array[1]);
    for (k = 0; k < columns; k++) fprintf(file, "<P%s/>\n", value_array(k));
    fprintf(file, "</PPointData>\n");
    /* the pieces are beside it */
    name = strrchr(prefix, '/');
    for (r = 0; r < ranks; r++)
        fprintf(file, "<Piece Source=\"%s.%d.vtu\"/>\n",
                name ? name + 1 : prefix, r);
    fprintf(file, "</PUnstructuredGrid>\n</VTKFile>\n");
    close_file(file);
}
