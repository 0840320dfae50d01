/* points.h - families of test points.
 *
 * The same points on every machine with 53-bit doubles: random bits come from
 * a counter that is hashed in 32-bit integer arithmetic, and what is done
 * with them is exact, or rounded once to the same result with or without
 * extended precision and fused multiply-add.  Families marked * are the
 * exceptions: they call sqrt, sin or cos or add rounded products, and their
 * last bits may differ from one machine or compiler to another.
 *
 *   uniform      unit cube
 *   ball         unit ball
 *   clusters     50 gaussian clusters, of deviation 2^-6, in the unit cube
 *   decimal3     multiples of 1/1000, 0.1 point per unit volume, like atoms
 *   twoscale     half in a cube of edge 1, half in one of edge 2^-10 inside it
 *   aniso        uniform, z * 2^-10
 *   planenoise   uniform, z * 2^-20
 *   lattice      integer cubic lattice
 *   lattice01    the same with 0.1 * i
 *   latticeshuf  lattice in random order
 *   jitlattice   lattice moved by up to 2^-33 (1.2e-10)
 *   lastplaces   in a lattice of 2^-50 beside (1,1,1), and the origin
 *   grid11eps    cubic grid in [0,1] (11^3 for n = 1331), one coordinate in
 *                ten moved by 2^-52
 *   bcc, fcc     body- and face-centred cubic lattice
 *   spherenorm*  random directions divided by their length
 *   spherejit*   the same with radii wrong by up to 1e-6, moved
 *   spherei      all integer points with x^2 + y^2 + z^2 = R^2, R integer, of
 *                the R that has most of them but not more than n; any order
 *   cavityi      all integer points from a sphere with 6 to 288 of them to a
 *                little beyond, in any order, turned exactly and moved
 *   fccturn      fcc in any order, turned exactly and moved
 *   ellipsoid*   spherenorm times 1, 0.7, 0.4, turned
 *   spiral*      golden-angle spiral on the unit sphere
 *   cylinder*    rings on a cylinder, about sqrt(n) of sqrt(n) points
 *   cylinderrnd* random points on a cylinder, turned
 *   prism*       two regular polygons, one above the other
 *   helix*       n points on 20 turns
 *   moment       (t, t^2, t^3), t = 1 ... n over a power of two
 *   twolines     half on each of two skew lines
 *   planeone     integer grid in a plane and one point off it
 *   planespread  random points in a plane and one point off it
 *   paraboloid   integer grid lifted to z = x^2 + y^2
 *   cubesurf     random points on the faces of a cube
 *   rotcube*     cubesurf rotated about no axis in particular, moved
 *   duplicates   uniform, every point about three times, shuffled
 *   pairs        uniform, in pairs 2^-43 (1.1e-13) apart in each
 *                coordinate
 *   farpoint     uniform, and one point at 1e9
 *   offset       uniform + 1e8
 *   tiny, huge   uniform times 2^-200, 2^200 (6e-61, 1.6e60)
 *   wide         coordinates with random signs and exponents -1000 ... 1000
 * "moved" is by (1, 2, 3); "turned" is by 0.7 about z, then by 0.4 about x, and
 * moved.  What people have:
 *   gridrot*     lattice01 turned
 *   gradedrot*   box mesh with steps that grow tenfold along each axis, turned
 *   gridsph*     k radii (1 to 2) by k latitudes by k longitudes, turned
 *   gridcyl*     k radii (1 to 2) by k angles by k heights, turned
 *   extruded*    k layers of the same k^2 random points of a square, turned
 *   globe*       spherenorm moved by (10, 20, 30)
 *   cap*         a cap of 20 degrees of the unit sphere, turned
 *   stations*    latitudes and longitudes on five levels, r = 6371 to 6571,
 *                turned
 *   spherefull*  half on the unit sphere, half inside, moved
 *   shells*      on four concentric spheres of radius 1 to 1.375, moved
 *   cavity*      in a cube of edge 2 with a spherical void of radius 0.6, a
 *                third on the void's boundary, moved
 *   spherejit4*  spherejit with radii wrong by up to 1e-4
 *   rotcubein*   half on the faces of a cube, half inside, turned
 *   rottet*      random points on the faces of a regular tetrahedron, turned
 *   rottetin*    half of them, half inside
 *   cubegrid     the surface of an integer lattice
 *   tilted9*     near the plane z = 0.3 x + 0.7 y, rough by 1e-9, moved
 *   tilted15*    the same, rough by 1e-15
 *   near6*       three random squares 1e-6 apart, turned
 *   near8*       the same, 1e-8 apart
 *   slanted      near a line, but for up to 3 last places in each coordinate
 *   cylinderrot* cylinder turned
 *   torus*       random points on a torus of radii 1 and 0.3, turned
 *   sheets*      a bent pillow, two sheets 0.02 apart or less, turned
 *   bumps*       a closed surface, round in places and with a tip, turned
 *   thinshell*   the same twice, the other 0.01 farther out
 *   terrain*     random points of hills, turned
 *   survey*      lines over them, 20 times as far apart as their samples,
 *                turned
 *   boreholes*   straight holes of 400 samples, about vertical, turned
 *   tracks*      smooth random curves of 2,000 samples, turned
 *   pipes*       random points on 8 pipes of radius 0.03, turned
 *   horizons*    on six folded surfaces one above the other, turned
 *   layers*      layers about an ellipse, the first 1e-4 thick, the others a
 *                fifth thicker each, along a wing, turned
 *   latlon*      k latitudes by 2k longitudes on the unit sphere, as they come:
 *                not turned, not moved
 *   latlonkm*, latlonm*   the same with radius 6371, 6378137
 *   uvsphere*    latlon with both poles, each 2k times but for rounding
 *   uvkm*, uvm*  the same with radius 6371, 6378137
 *   rings*       k circles of k points one above the other, of radii 0.7 to 1.3,
 *                turned
 *   hub*         a circle and one point above its centre, as they come
 *   hubrot*      the same, turned
 *   sheets16     two random squares 5e-16 apart, as they come
 *   sheet16rot*  the same, turned
 *   crowd*       on the unit sphere, most within 1e-6 of one spot, down to
 *                1e-12
 *   crowd3*      the same about three spots
 *   pillar6*     random points on the faces of a prism, which are exact planes,
 *                much higher than wide
 *   pillar12*, pillar64*   the same with 12, 64 sides
 *   masts        200 vertical masts, each with as many samples
 *   towers       on the four legs of twelve towers
 *   sites        20 stations, each once an hour, the time in seconds
 *   pillar6turn*, pillar12turn*, maststurn, towersturn, sitesturn   the same,
 *                turned exactly
 *   fillglobe*   spherenorm, 1e30 in z of 30 %
 *   fillcurve    a parabola and a little noise, 1e30 in z of 30 %
 *   fillcurve9   the same with -9999
 *   filloutlier  uniform, 1e30 in z of 30 %, and one point at 1e243
 *   box6*        random points of the faces of a box, 100 by 60 by 30, turned,
 *                rounded to 6 decimals
 *   plate3*, plate6*, plate17*   the same of a plate of 120 by 80 by 10 with
 *                five holes, rounded to 3, 6 decimals, not rounded
 *   bracket6*    the same of an L-shaped bracket, 60 by 40 by 30, 8 thick
 *   bar6*        the same of a cylinder with its ends, 20 by 50
 *   bearing6*    the same of a sphere of radius 10
 */
#ifndef POINTS_H
#define POINTS_H

#ifdef __cplusplus
extern "C" {
#endif

/* points_make - fill p, of 3*n doubles, with at most n points of a family, or,
 * if it has a slash, of the file of that name: x y z and what follows them, one
 * point a line; lines that do not begin so are left out.
 * Returns how many: a family of a fixed shape rounds n down (lattice to k^3,
 * for instance).  0 for an unknown family, or an n too small for it. */
long points_make(const char *family, long n, unsigned long seed, double *p);

/* points_name - the name of family i = 0, 1, ...; 0 past the last one. */
const char *points_name(int i);

#ifdef __cplusplus
}
#endif

#endif
