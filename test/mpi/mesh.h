/* mesh.h - what the files of the MPI program share; see mesh.c. */
#ifndef MESH_H
#define MESH_H

#include <mpi.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#include "../../tess.h"

/* Indices of points and numbers of tetrahedra in the whole. */
typedef int64_t num;

/* A point, as it is sent: its index in the whole and where it is. */
typedef struct point {
    num index;
    double x[3];
} point;

extern int me, ranks;

/* ---- mail.c: messages, memory, tables ---- */

/* fail - end all processes with a message. */
void fail(const char *what);

/* grow - realloc, which does not fail: count items of a size. */
void *grow(void *old, num count, size_t size);

/* A list of items for each process, or from each. */
typedef struct mail {
    size_t size;
    num *n, *room;
    char **at;
} mail;

/* What is sent, for the statistics. */
enum { MOVE, HALO, HASHES, POINTS, SIDES, KINDS };
extern double sent_bytes[KINDS];

void mail_open(mail *m, size_t size);
void mail_close(mail *m);

/* reserve - make room for n items for process r. */
void reserve(mail *m, int r, num n);

/* put - put an item into the list for process r. */
void put(mail *m, int r, const void *item);

/* exchange - send every process its list, and put what came in their place:
 * m->at[r], m->n[r] is then what process r has sent. */
void exchange(mail *m, int kind);

/* wait_for - MPI_Wait, asleep.  reduce - MPI_Allreduce, in place. */
void wait_for(MPI_Request *request);
void reduce(void *values, int count, MPI_Datatype type, MPI_Op op);
num total(num value);

/* A hash table of keys with values >= 0. */
typedef struct table {
    num n, size; /* size: a power of two, or 0 */
    uint64_t *key;
    int *value;
} table;

#define ABSENT (-1)

/* find - the place of a key's value, which is ABSENT if it was not there; good
 * until the next find. */
int *find(table *t, uint64_t key);
void forget(table *t);

/* expect - make room for n more. */
void expect(table *t, num n);

uint64_t mix(uint64_t h);

/* hash - of k indices, k <= 4, whatever their order. */
uint64_t hash(const num *index, int k);

/* ---- split.c: who owns what ---- */

/* The points of a process, in the order of their indices. */
typedef struct cloud {
    num all;  /* points of all processes */
    num n;
    point *at;
} cloud;

/* split - cut space, and move the points to their owners; of duplicates the one
 * of least index stays. */
void split(cloud *c);
int owner_of(const double *x);

/* known_to_all - points that every process shall know; the extreme ones, and
 * four that are in no plane.  Returns how many, at most SHARED, and the code:
 * 0 or TESS_PLANE, TESS_LINE, TESS_POINT. */
#define SHARED 30
int known_to_all(const cloud *c, point *shared, int *code);

/* ---- halo.c: the first guess ---- */

/* first_guess - points of others that are near: a list of *n without repetition
 * in the order of their indices, those known to all among them.  What was sent
 * to whom is put into sent (see given).  blind: those known to all alone. */
point *first_guess(const cloud *c, const point *shared, int nshared, int blind,
                   num *n, table *sent);

/* given - has this point been sent to process r?  It has, from now on. */
int given(table *sent, num index, int r);

/* ---- stars.c: stars, and their agreement ---- */

/* What a process knows of the mesh.  Tetrahedra have numbers of points known;
 * tet[4*t] is TESS_NONE for one that is none. */
typedef struct mesh {
    tess_int n, own;
    num *index;
    double *x;
    int *owner;
    tess_int ntet;
    tess_int *tet, *adj;
    int rounds;
    double known;        /* points known beyond the own ones, at first */
    clock_t finished;    /* when all but files was done */
} mesh;

/* INNER - are the vertices of a tetrahedron all own ones? */
#define INNER(m, v)                                               \
    ((m)->owner[(v)[0]] == me && (m)->owner[(v)[1]] == me &&      \
     (m)->owner[(v)[2]] == me && (m)->owner[(v)[3]] == me)

/* stars - all tetrahedra of the mesh of all points that have an own one for a
 * vertex.  Frees c's points and what foreign points are given. */
void stars(mesh *m, cloud *c, point *foreign, num n, table *sent);

/* ---- output.c ---- */

/* output - number the tetrahedra, find the neighbours in other processes, and
 * write PREFIX.<rank>.tet and .adj if prefix is not NULL.  Returns how many
 * tetrahedra the mesh has. */
num output(mesh *m, const char *prefix);

/* open_values - a file of values for write_vtu: as many native doubles for each
 * of all points, in the order of their indices.
 * write_vtu - PREFIX.pvtu, and its pieces PREFIX.<rank>.vtu. */
void open_values(const char *name, num all);
void write_vtu(const mesh *m, const char *prefix);

#endif
