/* surface.c - the convex hull of points as a surface: recipes to copy.
 *
 *   tr_enclosed  the volume within                          (normal)
 *   tr_obj       write it as Wavefront OBJ
 *   tr_stl       write it as STL (ASCII)                    (normal)
 *
 * Programs for drawing and for printing in three dimensions read both.
 * The triangles are those of tess_hull, or of any other closed surface, as the
 * recipe tr_alpha gives: counter-clockwise as seen from outside.
 *
 * t_surface.c tests them; surface.f is the same in FORTRAN 77.
 */
#include <math.h>
#include <stdio.h>

#include "recipes.h"

/* normal - c = the cross product of two edges of triangle v: outwards, of twice
 * its area. */
static void normal(const tess_real *p, const tess_int *v, double *c)
{
    const tess_real *o = p + 3 * v[0];
    double a[3], b[3];
    int k;

    for (k = 0; k < 3; k++) {
        a[k] = (double)p[3 * v[1] + k] - (double)o[k];
        b[k] = (double)p[3 * v[2] + k] - (double)o[k];
    }
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* tr_enclosed - the volume within a closed surface.
 *
 *   p     (in)  the points
 *   nfac  (in)  number of triangles
 *   fac   (in)  fac[3*f] ... fac[3*f+2] are the points of triangle f
 *
 * returns the volume: the sum of those between each triangle and a point. */
double tr_enclosed(const tess_real *p, tess_int nfac, const tess_int *fac)
{
    double c[3], sum = 0.0;
    tess_int f;
    int k;

    for (f = 0; f < nfac; f++) {
        normal(p, fac + 3 * f, c);
        for (k = 0; k < 3; k++)
            sum += c[k] *
                   ((double)p[3 * fac[3 * f] + k] - (double)p[3 * fac[0] + k]);
    }
    return sum / 6.0;
}

/* tr_obj - write the triangles, and the points that they have, as OBJ.
 *
 *   file          (in)   where to, open
 *   n, p          (in)   points
 *   nfac, fac     (in)   as for tr_enclosed
 *   digits        (in)   of coordinates: 17 keep a double as it is
 *   number        (out)  n: the point's number in the file, from 1 on; 0 for one
 *                        that no triangle has
 *
 * returns 0; 1 when the file could not be written. */
int tr_obj(FILE *file, tess_int n, const tess_real *p, tess_int nfac,
           const tess_int *fac, int digits, tess_int *number)
{
    tess_int i, many = 0;

    for (i = 0; i < n; i++) number[i] = 0;
    for (i = 0; i < 3 * nfac; i++) number[fac[i]] = 1;
    for (i = 0; i < n; i++) {
        if (number[i] == 0) continue;
        number[i] = ++many;
        fprintf(file, "v %.*g %.*g %.*g\n", digits, (double)p[3 * i], digits,
                (double)p[3 * i + 1], digits, (double)p[3 * i + 2]);
    }
    for (i = 0; i < nfac; i++)
        fprintf(file, "f %ld %ld %ld\n", (long)number[fac[3 * i]],
                (long)number[fac[3 * i + 1]], (long)number[fac[3 * i + 2]]);
    return ferror(file) != 0;
}

/* tr_stl - write the triangles as STL.
 *
 *   file, p, nfac, fac, digits  (in)  as for tr_obj
 *
 * returns 0; 1 when the file could not be written. */
int tr_stl(FILE *file, const tess_real *p, tess_int nfac, const tess_int *fac,
           int digits)
{
    const tess_real *v;
    double c[3], size;
    tess_int f;
    int i;

    fprintf(file, "solid hull\n");
    for (f = 0; f < nfac; f++) {
        normal(p, fac + 3 * f, c);
        size = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        if (!(size > 0.0)) size = 1.0;
        fprintf(file, "facet normal %.6g %.6g %.6g\n outer loop\n",
                c[0] / size, c[1] / size, c[2] / size);
        for (i = 0; i < 3; i++) {
            v = p + 3 * fac[3 * f + i];
            fprintf(file, "  vertex %.*g %.*g %.*g\n", digits, (double)v[0],
                    digits, (double)v[1], digits, (double)v[2]);
        }
        fprintf(file, " endloop\nendfacet\n");
    }
    fprintf(file, "endsolid hull\n");
    return ferror(file) != 0;
}
