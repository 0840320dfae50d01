/* exact.c - exact integer arithmetic for the tests; see exact.h. */
#include "exact.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef TEST_ROUNDING
#include <fenv.h>
#endif

#define DIGIT EX_DIGIT
#define MASK ((1UL << DIGIT) - 1)

static void overflow(void)
{
    fprintf(stderr, "exact.c: a number is longer than EX_DIGITS\n");
    exit(2);
}

void ex_copy(ex_num *r, const ex_num *a)
{
    int i;

    r->sign = a->sign;
    r->len = a->len;
    for (i = 0; i < a->len; i++) r->d[i] = a->d[i];
}

void ex_int(ex_num *r, long v)
{
    unsigned long m = v < 0 ? 0UL - (unsigned long)v : (unsigned long)v;

    r->sign = v < 0 ? -1 : v > 0;
    for (r->len = 0; m; m >>= DIGIT) r->d[r->len++] = m & MASK;
}

static void trim(ex_num *r)
{
    while (r->len > 0 && r->d[r->len - 1] == 0) r->len--;
    if (r->len == 0) r->sign = 0;
}

/* compare magnitudes */
static int order(const ex_num *a, const ex_num *b)
{
    int i;

    if (a->len != b->len) return a->len < b->len ? -1 : 1;
    for (i = a->len - 1; i >= 0; i--)
        if (a->d[i] != b->d[i]) return a->d[i] < b->d[i] ? -1 : 1;
    return 0;
}

/* |r| = |a| + |b| */
static void plus(ex_num *r, const ex_num *a, const ex_num *b)
{
    const ex_num *t;
    unsigned long c = 0;
    int i, n;

    if (a->len < b->len) { t = a; a = b; b = t; }
    n = a->len;
    for (i = 0; i < n; i++) {
        c += a->d[i] + (i < b->len ? b->d[i] : 0);
        r->d[i] = c & MASK;
        c >>= DIGIT;
    }
    if (c) {
        if (n == EX_DIGITS) overflow();
        r->d[n++] = c;
    }
    r->len = n;
}

/* |r| = |a| - |b|, |a| >= |b| */
static void minus(ex_num *r, const ex_num *a, const ex_num *b)
{
    unsigned long c = 0, t;
    int i, n = a->len;

    for (i = 0; i < n; i++) {
        t = (i < b->len ? b->d[i] : 0) + c;
        c = a->d[i] < t;
        r->d[i] = (a->d[i] + (c << DIGIT)) - t;
    }
    r->len = n;
    trim(r);
}

/* r = a + s |b| with the sign s of the second summand given */
static void sum(ex_num *r, const ex_num *a, const ex_num *b, int s)
{
    int t = a->sign, o;

    if (s == 0) {
        if (r != a) ex_copy(r, a);
    } else if (t == 0) {
        if (r != b) ex_copy(r, b);
        r->sign = s;
    } else if (s == t) {
        plus(r, a, b);
        r->sign = s;
    } else {
        o = order(a, b);
        r->sign = o < 0 ? s : t;
        if (o < 0) minus(r, b, a);
        else minus(r, a, b);
    }
}

void ex_add(ex_num *r, const ex_num *a, const ex_num *b)
{
    sum(r, a, b, b->sign);
}

void ex_sub(ex_num *r, const ex_num *a, const ex_num *b)
{
    sum(r, a, b, -b->sign);
}

void ex_mul(ex_num *r, const ex_num *a, const ex_num *b)
{
    unsigned long c, x;
    int i, j, m = a->len, n = b->len;

    if (m + n > EX_DIGITS) overflow();
    r->sign = a->sign * b->sign;
    r->len = r->sign ? m + n : 0;
    for (i = 0; i < r->len; i++) r->d[i] = 0;
    if (r->sign == 0) return;
    for (i = 0; i < m; i++) {
        x = a->d[i];
        if (x == 0) continue;
        c = 0;
        for (j = 0; j < n; j++) {
            c += r->d[i + j] + x * b->d[j];
            r->d[i + j] = c & MASK;
            c >>= DIGIT;
        }
        r->d[i + n] = c;
    }
    trim(r);
}

void ex_shift(ex_num *r, int bits)
{
    unsigned long c = 0, x;
    int i, whole = bits / DIGIT, part = bits % DIGIT;

    if (r->sign == 0) return;
    if (r->len + whole + 1 > EX_DIGITS) overflow();
    for (i = r->len - 1; i >= 0; i--) r->d[i + whole] = r->d[i];
    for (i = 0; i < whole; i++) r->d[i] = 0;
    r->len += whole;
    if (part == 0) return;
    for (i = whole; i < r->len; i++) {
        x = r->d[i] << part;
        r->d[i] = (x & MASK) | c;
        c = x >> DIGIT;
    }
    if (c) r->d[r->len++] = c;
}

int ex_bits(const ex_num *a)
{
    unsigned long x;
    int n;

    if (a->len == 0) return 0;
    n = (a->len - 1) * DIGIT;
    for (x = a->d[a->len - 1]; x; x >>= 1) n++;
    return n;
}

int ex_cmp(const ex_num *a, const ex_num *b)
{
    if (a->sign != b->sign) return a->sign < b->sign ? -1 : 1;
    return a->sign * order(a, b);
}

/* The digits of |x| as an integer times 2^*e: frexp, the products by 2^DIGIT
 * and the differences are exact in any rounding mode. */
static void digits(ex_num *r, double x, int *e)
{
    double m = frexp(fabs(x), e);
    unsigned long part[8];
    int i, n = 0;

    while (m > 0.0) {
        m *= (double)MASK + 1.0;
        part[n] = (unsigned long)m;
        m -= (double)part[n++];
        *e -= DIGIT;
    }
    for (i = 0; i < n; i++) r->d[i] = part[n - 1 - i];
    r->len = n;
    r->sign = x < 0.0 ? -1 : x > 0.0;
}

int ex_low(double x, int low)
{
    ex_num m;
    unsigned long d;
    int e;

    if (x == 0.0) return low;
    digits(&m, x, &e);
    for (d = m.d[0]; (d & 1) == 0; d >>= 1) e++;
    return e < low ? e : low;
}

void ex_real(ex_num *r, double x, int low)
{
    unsigned long c = 0;
    int e, i, down;

    digits(r, x, &e);
    if (r->sign == 0) return;
    if (e >= low) {
        ex_shift(r, e - low);
        return;
    }
    /* the lowest digit ends in that many zeros */
    down = low - e;
    if (down >= DIGIT || (r->d[0] & ((1UL << down) - 1)) != 0) {
        fprintf(stderr, "exact.c: not a multiple of the unit\n");
        exit(2);
    }
    for (i = r->len - 1; i >= 0; i--) {
        c = (c << DIGIT) | r->d[i];
        r->d[i] = c >> down;
        c &= (1UL << down) - 1;
    }
    trim(r);
}

long double ex_value(const ex_num *a, int *e)
{
    long double m = 0.0L;
    int i, n = a->len - 9;

    if (n < 0) n = 0;
    /* nine digits hold more bits than any long double in use but one; the
     * rest is below its last place */
    for (i = n; i < a->len; i++) m = m / ((long double)MASK + 1.0L) + (long double)a->d[i];
    *e = (a->len - 1) * DIGIT;
    if (m == 0.0L) return m;
    while (m >= 1.0L) { m *= 0.5L; ++*e; }
    return a->sign < 0 ? -m : m;
}

void ex_dot(ex_num *r, const ex_num *a, const ex_num *b)
{
    static ex_num t;
    int k;

    ex_mul(r, &a[0], &b[0]);
    for (k = 1; k < 3; k++) {
        ex_mul(&t, &a[k], &b[k]);
        ex_add(r, r, &t);
    }
}

void ex_cross(ex_num *r, const ex_num *a, const ex_num *b)
{
    static ex_num t;
    int k, i, j;

    for (k = 0; k < 3; k++) {
        i = (k + 1) % 3;
        j = (k + 2) % 3;
        ex_mul(&r[k], &a[i], &b[j]);
        ex_mul(&t, &a[j], &b[i]);
        ex_sub(&r[k], &r[k], &t);
    }
}

/* d = a - b, three components, in units of 2^low */
static void difference(ex_num *d, int low, const double *a, const double *b)
{
    static ex_num t;
    int k;

    for (k = 0; k < 3; k++) {
        ex_real(&d[k], a[k], low);
        ex_real(&t, b[k], low);
        ex_sub(&d[k], &d[k], &t);
    }
}

static int lowest(int low, const double *a)
{
    return ex_low(a[0], ex_low(a[1], ex_low(a[2], low)));
}

void ex_volume(ex_num *r, int low, const double *a, const double *b,
               const double *c, const double *d)
{
    static ex_num u[3], v[3], w[3], n[3];

    difference(u, low, b, a);
    difference(v, low, c, a);
    difference(w, low, d, a);
    ex_cross(n, u, v);
    ex_dot(r, n, w);
}

int ex_orient(const double *a, const double *b, const double *c,
              const double *d)
{
    static ex_num r;
    int low = lowest(EX_NO_LOW, a);

    low = lowest(lowest(lowest(low, b), c), d);
    if (low == EX_NO_LOW) return 0;
    ex_volume(&r, low, a, b, c, d);
    return r.sign;
}

/* With e as the origin, and q the lifted heights |.|^2 of the other four, the
 * determinant of the rows (x, y, z, q) expanded by its last column.  It is
 * positive for e inside when det [b-a c-a d-a] is negative: take the origin
 * inside (1,0,0), (0,1,0), (0,0,1), (-1,-1,-1). */
int ex_insphere(const double *a, const double *b, const double *c,
                const double *d, const double *e)
{
    static ex_num v[4][3], n[3], q, m, t, s;
    const double *p[4];
    int low = lowest(EX_NO_LOW, e), k, o;

    p[0] = a;
    p[1] = b;
    p[2] = c;
    p[3] = d;
    o = ex_orient(a, b, c, d);
    if (o == 0) return 0;
    for (k = 0; k < 4; k++) low = lowest(low, p[k]);
    for (k = 0; k < 4; k++) difference(v[k], low, p[k], e);
    ex_int(&s, 0L);
    for (k = 0; k < 4; k++) {
        /* the other three rows, in order */
        int i = k == 0 ? 1 : 0, j = k <= 1 ? 2 : 1, l = k == 3 ? 2 : 3;
        ex_cross(n, v[i], v[j]);
        ex_dot(&m, n, v[l]);
        ex_dot(&q, v[k], v[k]);
        ex_mul(&t, &q, &m);
        if (k % 2 == 0) ex_sub(&s, &s, &t);
        else ex_add(&s, &s, &t);
    }
    return -o * s.sign;
}

int ex_perturbed(const double *const *p, const int *index)
{
    static ex_num vol[5], v[3], h[5], e, t, s;
    const double *q[4];
    int low = EX_NO_LOW, apart = 0, most = 0, rank[5], first = 0, i, j, k;

    for (k = 0; k < 5; k++) low = lowest(low, p[k]);
    if (low == EX_NO_LOW) return 0;
    /* det of the rows (x, y, z, h, 1) by the column h: the cofactor of h_k is
     * (-1)^k times the volume of the others */
    ex_int(&s, 0L);
    for (k = 0; k < 5; k++) {
        for (i = j = 0; i < 5; i++)
            if (i != k) q[j++] = p[i];
        ex_volume(&vol[k], low, q[0], q[1], q[2], q[3]);
        if (ex_bits(&vol[k]) > apart) apart = ex_bits(&vol[k]);
        for (i = rank[k] = 0; i < 5; i++) rank[k] += index[i] < index[k];
        difference(v, low, p[k], p[4]);
        ex_dot(&h[k], v, v);
        if (ex_bits(&h[k]) > most) most = ex_bits(&h[k]);
        ex_mul(&t, &h[k], &vol[k]);
        if (k % 2 == 0) ex_add(&s, &s, &t);
        else ex_sub(&s, &s, &t);
    }
    if (s.sign != 0) return s.sign;
    apart += 3;
    if (most + 7 * apart > DIGIT * (EX_DIGITS - 2)) {
        for (k = 0; k < 5; k++)
            if (vol[k].sign != 0 &&
                (vol[first].sign == 0 || rank[k] < rank[first]))
                first = k;
        return first % 2 == 0 ? -vol[first].sign : vol[first].sign;
    }
    for (k = 0; k < 5; k++) {
        ex_shift(&h[k], 5 * apart);
        ex_int(&e, 1L);
        ex_shift(&e, (4 - rank[k]) * apart);
        ex_sub(&h[k], &h[k], &e);
        ex_mul(&t, &h[k], &vol[k]);
        if (k % 2 == 0) ex_add(&s, &s, &t);
        else ex_sub(&s, &s, &t);
    }
    return s.sign;
}

/* The foot x of the perpendicular from q on the affine hull of m points v, 1 to
 * 3: 1 if its weights w are all positive; and way, q - x times some positive
 * number. */
static int foot(int m, const double *const *v, const double *q, double *w,
                ex_num *way)
{
    static ex_num a[3], b[3], d[3], n[3], u[3], weight[3], whole, t, *r;
    int low = lowest(EX_NO_LOW, q), e, f, k;

    for (k = 0; k < m; k++) low = lowest(low, v[k]);
    difference(d, low, q, v[0]);
    if (m == 1) {
        for (k = 0; k < 3; k++) ex_copy(&way[k], &d[k]);
        w[0] = 1.0;
        return 1;
    }
    difference(a, low, v[1], v[0]);
    if (m == 2) {
        ex_dot(&whole, a, a);
        ex_dot(&weight[1], a, d);
        ex_sub(&weight[0], &whole, &weight[1]);
        for (k = 0; k < 3; k++) {
            ex_mul(&way[k], &whole, &d[k]);
            ex_mul(&t, &weight[1], &a[k]);
            ex_sub(&way[k], &way[k], &t);
        }
    } else {
        difference(b, low, v[2], v[0]);
        ex_cross(n, a, b);
        ex_dot(&whole, n, n);
        ex_cross(u, d, b);
        ex_dot(&weight[1], u, n);
        ex_cross(u, a, d);
        ex_dot(&weight[2], u, n);
        ex_sub(&weight[0], &whole, &weight[1]);
        ex_sub(&weight[0], &weight[0], &weight[2]);
        ex_dot(&t, n, d);
        for (k = 0; k < 3; k++) {
            ex_copy(&way[k], &n[k]);
            way[k].sign *= t.sign;
            if (way[k].sign == 0) way[k].len = 0;
        }
    }
    for (k = 0, r = weight; k < m; k++, r++) {
        if (r->sign <= 0) return 0;
        w[k] = (double)(ex_value(r, &e) / ex_value(&whole, &f));
        w[k] = ldexp(w[k], e - f);
    }
    return 1;
}

int ex_nearest(int m, const double *const *v, const double *q, long n,
               const double *p, double *w)
{
    static ex_num way[3], d[3], s;
    const double *u[3];
    double x[3];
    long i;
    int at[4], set, k, many;

    for (k = 0; k < m; k++) w[k] = 0.0;
    for (set = 1; set < 1 << m; set++) {
        for (k = many = 0; k < m; k++)
            if (set >> k & 1) at[many++] = k;
        if (many > 3) continue;
        for (k = 0; k < many; k++) u[k] = v[at[k]];
        if (!foot(many, u, q, x, way)) continue;
        for (i = 0; i < n; i++) {
            difference(d, lowest(lowest(EX_NO_LOW, p + 3 * i), u[0]),
                       p + 3 * i, u[0]);
            ex_dot(&s, way, d);
            if (s.sign > 0) break;
        }
        if (i < n) continue;
        for (k = 0; k < many; k++) w[at[k]] = x[k];
        return set;
    }
    return 0;
}

int ex_collinear(const double *a, const double *b, const double *c)
{
    static ex_num u[3], v[3], n[3];
    int low = lowest(lowest(lowest(EX_NO_LOW, a), b), c);

    if (low == EX_NO_LOW) return 1;
    difference(u, low, b, a);
    difference(v, low, c, a);
    ex_cross(n, u, v);
    return n[0].sign == 0 && n[1].sign == 0 && n[2].sign == 0;
}

/* Marsaglia's multiply-with-carry, two of 16 bits side by side. */
static unsigned long rnd_z = 362436069UL, rnd_w = 521288629UL;

void rnd_seed(unsigned long seed)
{
    int i;

    rnd_z = (362436069UL + 7UL * seed) & 0xffffffffUL;
    rnd_w = (521288629UL ^ (seed * 2654435761UL)) & 0xffffffffUL;
    if (rnd_z == 0) rnd_z = 1;
    if (rnd_w == 0) rnd_w = 1;
    for (i = 0; i < 16; i++) rnd_bits();
}

unsigned long rnd_bits(void)
{
    rnd_z = (36969UL * (rnd_z & 0xffffUL) + (rnd_z >> 16)) & 0xffffffffUL;
    rnd_w = (18000UL * (rnd_w & 0xffffUL) + (rnd_w >> 16)) & 0xffffffffUL;
    return ((rnd_z << 16) + (rnd_w & 0xffffUL)) & 0xffffffffUL;
}

double rnd_unit(void)
{
    double hi = (double)(rnd_bits() >> 5);

    return (hi * 67108864.0 + (double)(rnd_bits() >> 6)) /
           9007199254740992.0;
}

int rnd_below(int n)
{
    return (int)(rnd_bits() % (unsigned long)n);
}

void rnd_mix(double (*p)[3], int n)
{
    double x;
    int i, j, k;

    for (i = n - 1; i > 0; i--) {
        j = rnd_below(i + 1);
        for (k = 0; k < 3; k++) {
            x = p[i][k];
            p[i][k] = p[j][k];
            p[j][k] = x;
        }
    }
}

void test_modes(void (*all)(void))
{
#ifdef TEST_ROUNDING
    static const int mode[4] = { FE_TONEAREST, FE_DOWNWARD, FE_UPWARD,
                                 FE_TOWARDZERO };
    int i;

    for (i = 0; i < 4; i++) {
        fesetround(mode[i]);
        printf("# rounding mode %d\n", i);
        all();
    }
    fesetround(FE_TONEAREST);
#else
    all();
#endif
}

int test_state(int back, unsigned bits, unsigned precision)
{
#if defined(__GNUC__) && defined(__SSE2__)
    static unsigned sse, with;
    static unsigned short x87, narrow;

    if (!back) {
        __asm__ __volatile__("stmxcsr %0" : "=m"(sse));
        __asm__ __volatile__("fnstcw %0" : "=m"(x87));
    }
    with = back ? sse : sse | bits;
    narrow = back ? x87 : (unsigned short)((x87 & ~0x300u) | precision << 8);
    __asm__ __volatile__("ldmxcsr %0" : : "m"(with));
    __asm__ __volatile__("fldcw %0" : : "m"(narrow));
    return 1;
#else
    (void)bits;
    (void)precision;
    return back;
#endif
}

int test_flushes(void)
{
    volatile double x = DBL_MIN;

    x *= 0.5;
    return x == 0.0;
}

static long tests, failed;

void test_result(const char *name, long faults)
{
    tests++;
    if (faults == 0)
        printf("ok %ld - %s\n", tests, name);
    else {
        failed++;
        printf("not ok %ld - %s: %ld faults\n", tests, name, faults);
    }
    fflush(stdout);
}

void test_skip(const char *why)
{
    printf("ok %ld # SKIP %s\n", ++tests, why);
}

void test_that(int good, const char *of, const char *what)
{
    char name[120];

    sprintf(name, "%.60s: %.50s", of, what);
    test_result(name, good ? 0L : 1L);
}

void test_usage(const char *program, const char *arguments)
{
    printf("usage: %s %s\n", program, arguments);
    exit(2);
}

int test_quick(int argc, char **argv)
{
    int quick = argc == 2 ? strcmp(argv[1], "-quick") == 0 ? 1
                            : strcmp(argv[1], "-brief") == 0 ? 2 : 0 : 0;

    if (argc > 1 && quick == 0) test_usage(argv[0], "[-quick | -brief]");
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    return quick;
}

long test_number(const char *text, long least, char **argv,
                 const char *arguments)
{
    char *end;
    long number = strtol(text, &end, 10);

    if (end == text || *end || number < least) test_usage(argv[0], arguments);
    return number;
}

int test_end(void)
{
    printf("1..%ld\n", tests);
    return failed > 0;
}
