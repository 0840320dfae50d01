/* qhull.c - qhull FAMILY N [REPEATS] [SEED]: Qhull's Delaunay
 * triangulation.  Qz helps it with cospherical points; Q12 permits what it
 * would else stop at on near-ties. */
#include <libqhull_r/qhull_ra.h>
#include "peer.h"

int main(int argc, char **argv)
{
    static char options[] = "qhull d Qbb Qz Qt Q12";
    struct peer job;
    qhT qh_state, *qh = &qh_state;
    facetT *facet;
    int code, curlong, totlong;
    long ntet;

    peer_open(&job, argc, argv);
    while (job.run < job.repeats) {
        qh_zero(qh, stderr);
        peer_start(&job);
        code = qh_new_qhull(qh, 3, (int)job.n, job.p, False, options, NULL,
                            stderr);
        ntet = 0;
        if (code == 0)
            FORALLfacets {
                if (!facet->upperdelaunay)
                    ntet++;
            }
        peer_stop(&job, ntet, code);
        qh_freeqhull(qh, !qh_ALL);
        qh_memfreeshort(qh, &curlong, &totlong);
    }
    return peer_print(&job, "qhull");
}
