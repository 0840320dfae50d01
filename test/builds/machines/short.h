/* short.h - for -include: doubles are floats, of 24 bits; see short.c. */
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <xmmintrin.h>

#undef DBL_MANT_DIG
#undef DBL_EPSILON
#undef DBL_MIN
#undef DBL_MAX
#undef DBL_MIN_EXP
#undef DBL_MAX_EXP
#define DBL_MANT_DIG FLT_MANT_DIG
#define DBL_EPSILON FLT_EPSILON
#define DBL_MIN FLT_MIN
#define DBL_MAX FLT_MAX
#define DBL_MIN_EXP FLT_MIN_EXP
#define DBL_MAX_EXP FLT_MAX_EXP
#define double float
