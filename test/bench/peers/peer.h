/* peer.h - what the bench programs of the peers share, C and C++: arguments,
 * points, clock, memory, and the line printed, which is that of ../bench.c
 * with "-" for the workspace, as they have none of their own.  Short calls are
 * repeated as there, what stands between them not counted.  Memory is the
 * growth of the peak resident set during the first run, the output included,
 * the caller's points not. */
#ifndef PEER_H
#define PEER_H

#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <sys/resource.h>
#include "../../lib/points.h"

struct peer {
    const char *family;
    double *p;
    long n, ntet, repeats, run, calls;
    double least, memory, seconds;
    clock_t begin;
    int code;
};

static double peer_memory(void)
{
    struct rusage usage;

    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * (double)usage.ru_maxrss;
}

static void peer_open(struct peer *job, int argc, char **argv)
{
    long asked;

    if (argc < 3) {
        fprintf(stderr, "usage: %s FAMILY N [REPEATS] [SEED]\n", argv[0]);
        exit(2);
    }
    asked = atol(argv[2]);
    job->family = argv[1];
    job->repeats = argc > 3 ? atol(argv[3]) : 3;
    if (job->repeats < 1)
        job->repeats = 1;
    job->ntet = job->run = job->calls = 0;
    job->least = job->memory = job->seconds = 0;
    job->code = 0;
    job->p = asked > 0 ? (double *)malloc((size_t)asked * 3 * sizeof(double))
                       : 0;
    job->n = job->p ? points_make(argv[1], asked,
                                  argc > 4 ? strtoul(argv[4], 0, 10) : 1,
                                  job->p) : 0;
    if (job->n == 0) {
        fprintf(stderr, "%s: no points %s %s\n", argv[0], argv[1], argv[2]);
        exit(2);
    }
}

static void peer_start(struct peer *job)
{
    if (job->run == 0 && job->calls == 0)
        job->memory = peer_memory();
    job->begin = clock();
}

static void peer_stop(struct peer *job, long ntet, int code)
{
    job->seconds += (double)(clock() - job->begin) / CLOCKS_PER_SEC;
    if (job->run == 0 && job->calls == 0)
        job->memory = peer_memory() - job->memory;
    job->ntet = ntet;
    job->code = code;
    job->calls++;
    if (job->seconds < 0.2 && code == 0)
        return;
    job->seconds /= (double)job->calls;
    if (job->run == 0 || job->seconds < job->least)
        job->least = job->seconds;
    job->seconds = 0;
    job->calls = 0;
    job->run++;
}

static int peer_print(const struct peer *job, const char *name)
{
    printf("%s %s %ld %ld %.4f %.1f - %.1f %d\n", name, job->family, job->n,
           job->ntet, job->least,
           job->ntet > 0 ? 1e9 * job->least / (double)job->ntet : 0.0,
           job->memory / (double)job->n, job->code);
    return job->code != 0;
}

#endif
