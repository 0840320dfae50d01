/* mail.c - messages, memory and tables of the MPI program; see mesh.h.
 *
 * Whoever waits sleeps: so processes may share a core, and their CPU time is
 * that of their work.
 */
#define _POSIX_C_SOURCE 199309L
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "mesh.h"

int me, ranks;
double sent_bytes[KINDS];

void fail(const char *what)
{
    fprintf(stderr, "mesh: process %d: %s\n", me, what);
    MPI_Abort(MPI_COMM_WORLD, 1);
    exit(1);
}

void *grow(void *old, num count, size_t size)
{
    void *space;

    if (count < 1) count = 1;
    if ((uint64_t)count > (size_t)-1 / size) fail("out of memory");
    space = realloc(old, (size_t)count * size);
    if (!space) fail("out of memory");
    return space;
}

/* ---- messages ---- */

/* nap - sleep, each time twice as long, 20 microseconds to 2.5 milliseconds. */
static void nap(int *times)
{
    struct timespec t;

    t.tv_sec = 0;
    t.tv_nsec = 20000L << *times;
    if (*times < 7) ++*times;
    nanosleep(&t, NULL);
}

void mail_open(mail *m, size_t size)
{
    int r;

    m->size = size;
    m->n = (num *)grow(NULL, ranks, sizeof *m->n);
    m->room = (num *)grow(NULL, ranks, sizeof *m->room);
    m->at = (char **)grow(NULL, ranks, sizeof *m->at);
    for (r = 0; r < ranks; r++) {
        m->n[r] = m->room[r] = 0;
        m->at[r] = NULL;
    }
}

void mail_close(mail *m)
{
    int r;

    for (r = 0; r < ranks; r++) free(m->at[r]);
    free(m->at);
    free(m->n);
    free(m->room);
}

void reserve(mail *m, int r, num n)
{
    if (n <= m->room[r]) return;
    m->room[r] = n;
    m->at[r] = (char *)grow(m->at[r], n, m->size);
}

void put(mail *m, int r, const void *item)
{
    if (m->n[r] == m->room[r]) reserve(m, r, 2 * m->room[r] + 8);
    memcpy(m->at[r] + (size_t)m->n[r]++ * m->size, item, m->size);
}

/* Nobody knows who will send to it: all have, when a barrier is passed that
 * each process enters when what it has sent has been taken.  (T. Hoefler et al.,
 * Scalable Communication Protocols for Dynamic Sparse Data Exchange, 2010.)
 * Messages of two exchanges have different tags, as a process that has passed
 * the barrier may be ahead of one that has not seen it.  Items are counted,
 * not bytes: there may be more than 2^31 of these. */
void exchange(mail *m, int kind)
{
    static int tag;
    MPI_Datatype type;
    MPI_Request *request, barrier;
    MPI_Message message;
    MPI_Status status;
    mail in;
    int r, count, flag, open = 0, entered = 0, done = 0, naps = 0;

    mail_open(&in, m->size);
    in.at[me] = m->at[me];
    in.n[me] = in.room[me] = m->n[me];
    m->at[me] = NULL;
    tag = !tag;
    MPI_Type_contiguous((int)m->size, MPI_BYTE, &type);
    MPI_Type_commit(&type);
    request = (MPI_Request *)grow(NULL, ranks, sizeof *request);
    for (r = 0; r < ranks; r++) {
        if (r == me || m->n[r] == 0) continue;
        if (m->n[r] > INT_MAX) fail("a message of too many items");
        MPI_Issend(m->at[r], (int)m->n[r], type, r, tag, MPI_COMM_WORLD,
                   request + open++);
        sent_bytes[kind] += (double)m->n[r] * (double)m->size;
    }
    while (!done) {
        MPI_Improbe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &flag, &message,
                    &status);
        if (flag) {
            r = status.MPI_SOURCE;
            MPI_Get_count(&status, type, &count);
            naps = 0;
            reserve(&in, r, count);
            in.n[r] = count;
            MPI_Mrecv(in.at[r], count, type, &message, &status);
            continue;
        }
        if (entered)
            MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
        else {
            MPI_Testall(open, request, &entered, MPI_STATUSES_IGNORE);
            if (entered) MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
        }
        if (!done) nap(&naps);
    }
    free(request);
    MPI_Type_free(&type);
    mail_close(m);
    *m = in;
}

void wait_for(MPI_Request *request)
{
    int done = 0, naps = 0;

    for (;;) {
        MPI_Test(request, &done, MPI_STATUS_IGNORE);
        if (done) return;
        nap(&naps);
    }
}

void reduce(void *values, int count, MPI_Datatype type, MPI_Op op)
{
    MPI_Request request;

    MPI_Iallreduce(MPI_IN_PLACE, values, count, type, op, MPI_COMM_WORLD,
                   &request);
    wait_for(&request);
}

num total(num value)
{
    reduce(&value, 1, MPI_INT64_T, MPI_SUM);
    return value;
}

/* ---- tables ---- */

/* The finalizer of SplitMix64: each bit of h changes each of the result with
 * probability about 1/2, and no two h have the same. */
uint64_t mix(uint64_t h)
{
    h = (h ^ (h >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    h = (h ^ (h >> 27)) * UINT64_C(0x94d049bb133111eb);
    return h ^ (h >> 31);
}

uint64_t hash(const num *index, int k)
{
    uint64_t h = (uint64_t)k, v[4], swap;
    int i, j;

    for (i = 0; i < k; i++) {
        v[i] = (uint64_t)index[i];
        for (j = i; j > 0 && v[j - 1] > v[j]; j--) {
            swap = v[j];
            v[j] = v[j - 1];
            v[j - 1] = swap;
        }
    }
    for (i = 0; i < k; i++) h = mix(h * UINT64_C(0x9e3779b97f4a7c15) + v[i]);
    return h;
}

static num probe(const table *t, uint64_t key)
{
    num i = (num)(mix(key) & (uint64_t)(t->size - 1));

    while (t->value[i] != ABSENT && t->key[i] != key)
        i = (i + 1) & (t->size - 1);
    return i;
}

void expect(table *t, num n)
{
    table old = *t;
    num i, j;

    /* A place that was asked for and left ABSENT is in use no more. */
    t->n = 0;
    for (i = 0; i < old.size; i++) t->n += old.value[i] != ABSENT;
    for (t->size = 16; t->size < 2 * (t->n + n) + 2; t->size *= 2)
        ;
    t->key = (uint64_t *)grow(NULL, t->size, sizeof *t->key);
    t->value = (int *)grow(NULL, t->size, sizeof *t->value);
    for (i = 0; i < t->size; i++) t->value[i] = ABSENT;
    for (i = 0; i < old.size; i++)
        if (old.value[i] != ABSENT) {
            j = probe(t, old.key[i]);
            t->key[j] = old.key[i];
            t->value[j] = old.value[i];
        }
    free(old.key);
    free(old.value);
}

int *find(table *t, uint64_t key)
{
    num i;

    if (4 * t->n >= 3 * t->size) expect(t, 0);
    i = probe(t, key);
    if (t->value[i] == ABSENT) {
        t->key[i] = key;
        t->n++;
    }
    return t->value + i;
}

void forget(table *t)
{
    free(t->key);
    free(t->value);
    memset(t, 0, sizeof *t);
}
