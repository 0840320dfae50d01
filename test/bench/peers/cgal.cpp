/* cgal.cpp - cgal FAMILY N [REPEATS] [SEED]: Delaunay_triangulation_3 of
 * CGAL.  Time is that of inserting the range of points. */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <vector>
#include "peer.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel> Delaunay;

int main(int argc, char **argv)
{
    std::vector<Kernel::Point_3> points;
    peer job;

    peer_open(&job, argc, argv);
    points.reserve((size_t)job.n);
    for (const double *p = job.p; p < job.p + 3 * job.n; p += 3)
        points.push_back(Kernel::Point_3(p[0], p[1], p[2]));
    while (job.run < job.repeats) {
        peer_start(&job);
        Delaunay delaunay(points.begin(), points.end());
        peer_stop(&job, (long)delaunay.number_of_finite_cells(), 0);
    }
    return peer_print(&job, "cgal");
}
