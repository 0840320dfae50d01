/* volumes.cpp - the cells of build/tess -periodic -volumes beside CGAL's.
 *
 *   volumes SIDE < FILE.csv     of the box 0,SIDE,0,SIDE,0,SIDE
 *
 * Prints how many cells have the volume and the neighbours that CGAL gives them;
 * returns 1 if one has not. */
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel> Traits;
typedef CGAL::Periodic_3_Delaunay_triangulation_3<Traits> Periodic;
typedef Periodic::Vertex_handle Vertex;

int main(int argc, char **argv)
{
    double side = argc > 1 ? std::atof(argv[1]) : 1.0, x, y, z, volume;
    Periodic theirs(Periodic::Iso_cuboid(0, 0, 0, side, side, side));
    std::vector<Vertex> vertex;
    std::vector<double> volumes;
    std::vector<long> faces;
    long n, face, good = 0;

    /* further columns follow */
    if (std::scanf("x,y,z,volume,faces%*[^\n]") != 0) return 2;
    while (std::scanf("%lf,%lf,%lf,%lf,%ld%*[^\n]", &x, &y, &z, &volume,
                      &face) == 5) {
        vertex.push_back(theirs.insert(Kernel::Point_3(x, y, z)));
        volumes.push_back(volume);
        faces.push_back(face);
    }
    n = (long)vertex.size();
    for (long i = 0; i < n; i++)
        good += std::fabs(volumes[i] - theirs.dual_volume(vertex[i])) <=
                    1e-10 * volumes[i] &&
                faces[i] == (long)theirs.degree(vertex[i]);
    bool right = good == n && n > 0;
    std::printf("%s 1 - volumes and faces of %ld of %ld cells\n1..1\n",
                right ? "ok" : "not ok", good, n);
    return !right;
}
