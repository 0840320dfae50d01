/* math.h - what tess takes of it, for a machine without a C library: see
 * ../reach.sh. */
double fabs(double x);
double sqrt(double x);
double frexp(double x, int *exponent);
double ldexp(double x, int exponent);
