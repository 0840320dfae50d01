/* cgalloc.cpp - cgalloc FAMILY N: CGAL's locate on the queries of
 * ../locate.c, hinted by the last cell and unhinted; a line of the same form. */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <vector>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include "../../lib/points.h"
#include "../queries.h"

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Delaunay_triangulation_3<Kernel> Delaunay;

int main(int argc, char **argv)
{
    long n = argc > 2 ? atol(argv[2]) : 0, inside = 0;
    if (n < 4) return 2;
    std::vector<double> p(3 * n), q(3 * QUERIES);
    n = points_make(argv[1], n, 1, p.data());
    std::vector<Kernel::Point_3> points;
    for (long i = 0; i < n; i++)
        points.push_back(Kernel::Point_3(p[3 * i], p[3 * i + 1], p[3 * i + 2]));
    Delaunay delaunay(points.begin(), points.end());
    double ns[2];
    for (int hinted = 1; hinted >= 0; hinted--) {
        queries_make(n, p.data(), hinted, q.data());
        Delaunay::Cell_handle cell;
        clock_t start = clock();
        for (long i = 0; i < QUERIES; i++) {
            Kernel::Point_3 at(q[3 * i], q[3 * i + 1], q[3 * i + 2]);
            cell = hinted ? delaunay.locate(at, cell) : delaunay.locate(at);
            if (hinted && !delaunay.is_infinite(cell)) inside++;
        }
        ns[hinted] = (double)(clock() - start) / CLOCKS_PER_SEC / QUERIES * 1e9;
    }
    printf("cgal %s %ld %.3f %.0f %.0f\n", argv[1], n,
           (double)inside / QUERIES, ns[1], ns[0]);
    return 0;
}
