/* tetgen.cpp - tetgen FAMILY N [REPEATS] [SEED]: TetGen's Delaunay
 * tetrahedralization.  The output is the tetrahedra; points, faces and
 * messages are suppressed (NFBQ).  TetGen throws, or ends the program, when
 * it fails. */
#define TETLIBRARY
#include <tetgen.h>
#include <cstring>
#include "peer.h"

int main(int argc, char **argv)
{
    peer job;

    peer_open(&job, argc, argv);
    while (job.run < job.repeats) {
        tetgenio in, out;
        char switches[] = "NFBQ";
        int code = 0;

        in.numberofpoints = (int)job.n;
        in.pointlist = new REAL[3 * (size_t)job.n];
        std::memcpy(in.pointlist, job.p, 3 * sizeof(REAL) * (size_t)job.n);
        peer_start(&job);
        try {
            tetrahedralize(switches, &in, &out);
        } catch (...) {
            code = 1;
        }
        peer_stop(&job, out.numberoftetrahedra, code);
    }
    return peer_print(&job, "tetgen");
}
