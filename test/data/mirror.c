/* mirror.c - temperatures in a telescope mirror blank, as `x y z value' lines
 * on standard output: the made-up thermal survey of test/data/mirror.xyz.
 *
 * A concave meniscus with a central hole.  Sensors sit on rings about the
 * axis, on layers that are parts of concentric spheres, and all rings have
 * the same angles: full of sets of points on one sphere, one circle, one
 * plane, as any regular instrument is.
 *
 * Everything is rounded to 6 decimals by integer arithmetic, so that the text
 * is the same whatever the C library's printf and the last bit of its cosine.
 */
#include <math.h>
#include <stdio.h>

#define RINGS 7
#define LAYERS 5
#define ANGLES 28

#define INNER 0.60   /* radius of the innermost ring, m  */
#define OUTER 4.10   /* radius of the outermost ring, m  */
#define CURVE 28.80  /* radius of the front surface, m   */
#define THICK 0.175  /* thickness, m                     */

/* put - x with 6 decimals. */
static void put(double x, char after)
{
    double micro = floor(fabs(x) * 1e6 + 0.5);
    double whole = floor(micro / 1e6);

    printf("%s%ld.%06ld%c", x < 0.0 && micro > 0.0 ? "-" : "", (long)whole,
           (long)(micro - whole * 1e6), after);
}

/* temperature - degrees C; depth is 0 at the front surface, which faces the
 * cold sky, and 1 at the back.  The wind cools one side, and between three warm
 * supports the rim. */
static double temperature(double x, double y, double depth)
{
    double up = 1.0 - depth;

    x /= OUTER;
    y /= OUTER;
    return 11.2 - 0.8 * up * up + 0.45 * x + 0.3 * (x * x + y * y) +
           (0.18 + 0.42 * up) * x * (x * x - 3.0 * y * y);
}

int main(void)
{
    double turn = 8.0 * atan(1.0), depth, r, sphere, x, y, z;
    int ring, layer, angle;

    printf("# Temperatures in a telescope mirror blank (made up).\n"
           "# A meniscus of %.1f m diameter, %.0f mm thick, with a hole;\n"
           "# front and back are spheres about (0, 0, %.1f).\n"
           "# %d rings x %d layers x %d angles = %d sensors.\n"
           "# x, y, z in metres, temperature in degrees C\n",
           2.0 * OUTER, 1000.0 * THICK, CURVE, RINGS, LAYERS, ANGLES,
           RINGS * LAYERS * ANGLES);
    for (ring = 0; ring < RINGS; ring++)
        for (layer = 0; layer < LAYERS; layer++)
            for (angle = 0; angle < ANGLES; angle++) {
                r = INNER + (OUTER - INNER) * ring / (RINGS - 1);
                depth = (double)layer / (LAYERS - 1);
                sphere = CURVE + THICK * depth;
                x = r * cos(turn * angle / ANGLES);
                y = r * sin(turn * angle / ANGLES);
                z = CURVE - sqrt(sphere * sphere - r * r);
                put(x, ' ');
                put(y, ' ');
                put(z, ' ');
                put(temperature(x, y, depth), '\n');
            }
    return 0;
}
