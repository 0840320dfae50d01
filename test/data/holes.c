/* holes.c - samples of drill holes, as a table with names on standard output:
 * the made-up survey of test/data/holes.csv.
 *
 * 70 vertical holes through two lenses of ore, a sample of ten metres a line,
 * as laboratories send them: grades below the limit of detection are <0.05,
 * and -99 stands for samples that were lost.  No routine of the C library
 * computes anything, and few operations do, so that the text is the same on
 * every machine.
 */
#include <stdio.h>

#define ROWS 7
#define COLUMNS 10
#define SAMPLES 30
#define STEP 60.0    /* between holes, m */
#define LENGTH 10.0  /* of a sample, m */

static unsigned long state = 7;

/* uniform - from 0 to 1, exactly. */
static double uniform(void)
{
    state = (1664525UL * state + 1013904223UL) & 0xffffffffUL;
    return (double)(state >> 16) / 65536.0;
}

/* lens - grams a tonne: best in the middle, g / 8 at a distance of its axes. */
static double lens(double g, double x, double y, double z)
{
    double r = 1.0 + x * x + y * y + z * z;

    return g / (r * r * r);
}

/* rock - weathered near the surface, altered where the grade is high. */
static const char *rock(double z, double top, double g)
{
    if (z > top - 28.0) return "SAPROLITE";
    if (g > 1.5) return "SKARN";
    return z > 0.5 * top ? "LIMESTONE" : "GRANITE";
}

int main(void)
{
    int i, j, k;
    long milli;
    double x, y, z, top, g;

    printf("HOLEID,FROM,TO,EAST,NORTH,RL,LITH,AU\n");
    for (j = 0; j < ROWS; j++)
        for (i = 0; i < COLUMNS; i++) {
            x = STEP * i + 40.0 * (uniform() - 0.5);
            y = STEP * j + 40.0 * (uniform() - 0.5);
            top = 310.0 + 8.0 * uniform();
            for (k = 0; k < SAMPLES; k++) {
                z = top - LENGTH * (k + 0.5);
                g = lens(6.0, (x - 200.0) / 190.0, (y - 180.0) / 160.0,
                         (z - 180.0 + 0.25 * (x - 270.0)) / 80.0) +
                    lens(5.0, (x - 420.0) / 120.0, (y - 230.0) / 130.0,
                         (z - 120.0 - 0.2 * (y - 180.0)) / 90.0);
                milli = (long)(1000.0 * g + 0.5);
                printf("DH%03d,%d,%d,%.1f,%.1f,%.1f,%s,", COLUMNS * j + i + 1,
                       10 * k, 10 * k + 10, 452000.0 + x, 6781000.0 + y, z,
                       rock(z, top, g));
                if (uniform() < 0.006) printf("-99\n");
                else if (milli < 50) printf("<0.05\n");
                else printf("%ld.%03ld\n", milli / 1000, milli % 1000);
            }
        }
    return 0;
}
