/* recipes.cpp - natural and periodic of test/recipes beside CGAL: the same
 * weights and as many cells, on clouds.  (On lattices CGAL's weights are wrong
 * or it stops.) */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/natural_neighbor_coordinates_3.h>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <map>
#include <vector>
#include "../../lib/points.h"
#include "../../recipes/recipes.h"

#define main example
namespace one {
#include "../../recipes/natural.c"
}
namespace two {
#include "../../recipes/periodic.c"
}
#undef main

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Delaunay_triangulation_3<Kernel> Delaunay;
typedef CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel> Traits;
typedef CGAL::Periodic_3_Delaunay_triangulation_3<Traits> Periodic;
typedef std::vector<std::pair<Delaunay::Vertex_handle, double> > Weights;

static long tests, failed;

static void check(bool good, const char *family, long n, const char *what)
{
    tests++;
    if (!good) failed++;
    printf("%s %ld - %s %ld: %s\n", good ? "ok" : "not ok", tests, family, n,
           what);
}

static void natural(const char *family, long most)
{
    std::vector<double> p(3 * most);
    long n = points_make(family, most, 1, p.data());
    std::vector<tess_int> tet(48 * n), adj(48 * n), iw(TESS_LIW(n));
    std::vector<double> rw(TESS_LRW(n));
    tess_int ntet;
    bool same[2] = {true, true};

    check(tess((tess_int)n, p.data(), (tess_int)(12 * n), &ntet, tet.data(),
               adj.data(), (tess_int)iw.size(), iw.data(), (tess_int)rw.size(),
               rw.data()) == 0, family, n, "mesh");
    Delaunay delaunay;
    for (long i = 0; i < n; i++)
        delaunay.insert(Point(p[3 * i], p[3 * i + 1], p[3 * i + 2]));
    for (long i = 0; i < 500; i++) {
        double q[3], w[2][203], all;
        tess_int t = (tess_int)(i * 37 % ntet), nn, nbr[203], iwork[2614];
        std::vector<double> work(2615);

        for (int k = 0; k < 3; k++)
            q[k] = 0.1 * p[3 * tet[4 * t] + k] + 0.2 * p[3 * tet[4 * t + 1] + k]
                 + 0.3 * p[3 * tet[4 * t + 2] + k]
                 + 0.4 * p[3 * tet[4 * t + 3] + k];
        if (one::tr_natural(p.data(), ntet, tet.data(), adj.data(), q, &t, 200,
                            &nn, nbr, w[0], w[1], iwork, work.data()) != 0)
            same[0] = false;
        for (int m = 0; m < 2; m++) {
            Weights theirs;
            std::map<Point, double> ours;
            Point at(q[0], q[1], q[2]);
            if (m == 0) CGAL::sibson_natural_neighbor_coordinates_3(
                delaunay, at, std::back_inserter(theirs), all);
            else CGAL::laplace_natural_neighbor_coordinates_3(
                delaunay, at, std::back_inserter(theirs), all);
            for (tess_int j = 0; j < nn; j++)
                ours[Point(p[3 * nbr[j]], p[3 * nbr[j] + 1],
                           p[3 * nbr[j] + 2])] = w[m][j];
            for (Weights::iterator v = theirs.begin(); v != theirs.end(); v++) {
                double &mine = ours[v->first->point()];
                if (!(std::fabs(v->second / all - mine) <= 1e-13))
                    same[m] = false;
                mine = 0.0;
            }
            for (std::map<Point, double>::iterator v = ours.begin();
                 v != ours.end(); v++)
                if (!(v->second <= 1e-13)) same[m] = false;
        }
    }
    check(same[0], family, n, "Sibson's weights");
    check(same[1], family, n, "Laplace's weights");
}

static void periodic(const char *family, long most)
{
    std::vector<double> p(3 * most);
    long n = points_make(family, most, 1, p.data()), copies = 30 * n;
    const double box[6] = {0, 1, 0, 1, 0, 1};
    std::vector<tess_int> tet(80 * n), move(80 * n), adj(80 * n), shift(80 * n);
    std::vector<tess_int> cw(3 * copies), iw(TESS_LIW(copies));
    std::vector<double> x(3 * copies), rw(TESS_LRW(copies));
    std::vector<Point> points;
    tess_int ncop, ntet = 0;

    check(two::tr_periodic((tess_int)n, p.data(), box, (tess_int)copies, &ncop,
                           x.data(), cw.data(), (tess_int)(20 * n), &ntet,
                           tet.data(), move.data(), adj.data(), shift.data(),
                           (tess_int)iw.size(), iw.data(), (tess_int)rw.size(),
                           rw.data()) == 0, family, n, "periodic");
    for (long i = 0; i < n; i++)
        points.push_back(Point(p[3 * i], p[3 * i + 1], p[3 * i + 2]));
    Periodic theirs(points.begin(), points.end(),
                    Periodic::Iso_cuboid(0, 0, 0, 1, 1, 1));
    long cells = (long)theirs.number_of_cells();
    check(cells == (long)ntet, family, n, "cells of a periodic box");
}

int main()
{
    natural("uniform", 1000);
    natural("uniform", 3000);
    periodic("uniform", 300);
    periodic("uniform", 1000);
    periodic("duplicates", 900);
    printf("1..%ld\n", tests);
    return failed > 0;
}
