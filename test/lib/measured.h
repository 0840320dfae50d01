/* measured.h - families of points.c that are like what people have: grids,
 * solids and surfaces that are measured, surveyed or meshed.  A part of
 * points.c, which includes it, as it needs what that file has above. */

/* ---- what people have: grids at any angle, globes, shells, flat and round
 * boundaries ---- */

/* A box mesh whose steps grow tenfold along every axis. */
static long gradedrot(long n, unsigned long *state, double *p)
{
    double t;
    long i, k;

    n = lattice(n, state, p);
    k = root(n, 3);
    for (i = 0; i < 3 * n; i++) {
        t = p[i] / (double)k;
        p[i] = product(t, 0.2 + t);
    }
    return n;
}

/* A place at a distance r from the origin, theta from the pole, at longitude
 * phi. */
static void polar(double r, double theta, double phi, double *q)
{
    put(q, product(r, sin(theta) * cos(phi)), product(r, sin(theta) * sin(phi)),
        product(r, cos(theta)));
}

/* r, theta, phi: k shells of k latitudes and k longitudes. */
static long gridsph(long n, unsigned long *state, double *p)
{
    double r, theta, phi;
    long i, k;

    n = lattice(n, state, p);
    k = root(n, 3);
    for (i = 0; i < n; i++) {
        r = 1 + p[3 * i] / (double)k;
        theta = PI * (p[3 * i + 1] + 0.5) / (double)k;
        phi = 2 * PI * p[3 * i + 2] / (double)k;
        polar(r, theta, phi, p + 3 * i);
    }
    return n;
}

/* r, theta, z */
static long gridcyl(long n, unsigned long *state, double *p)
{
    double r, theta;
    long i, k;

    n = lattice(n, state, p);
    k = root(n, 3);
    for (i = 0; i < n; i++) {
        r = 1 + p[3 * i] / (double)k;
        theta = 2 * PI * p[3 * i + 1] / (double)k;
        put(p + 3 * i, r * cos(theta), r * sin(theta),
            3 * p[3 * i + 2] / (double)k);
    }
    return n;
}

/* k layers of the same random points of a square. */
static long extruded(long n, unsigned long *state, double *p)
{
    long i, k, m;

    k = root(n, 3);
    m = k > 0 ? n / k : 0;
    uniform(m, state, p);
    for (i = k * m - 1; i >= 0; i--)
        put(p + 3 * i, p[3 * (i % m)], p[3 * (i % m) + 1],
            (double)(i / m) / (double)k);
    return k * m;
}

static long globe(long n, unsigned long *state, double *p)
{
    spherenorm(n, state, p);
    shift(n, p, 10.0, 20.0, 30.0);
    return n;
}

/* k latitudes by 2k longitudes on a sphere of radius r, as they come: without
 * the poles, or, if ends is 1, with a ring of 2k points at each, at or about
 * the pole as sine and cosine are rounded. */
static long meridians(long n, double r, int ends, double *p)
{
    double theta, phi;
    long i, k = root(n / 2, 2), rows = k + ends;

    if (2 * k * rows > n) rows = --k + ends;
    for (i = 0; i < 2 * k * rows; i++) {
        theta = PI * ((double)(i / (2 * k)) + (ends ? 0.0 : 0.5)) / (double)k;
        phi = PI * (double)(i % (2 * k)) / (double)k;
        polar(r, theta, phi, p + 3 * i);
    }
    return 2 * k * rows;
}

static long latitudes(long n, unsigned long *state, double r, double *p)
{
    (void)state;
    return meridians(n, r, 0, p);
}

static long uvsphere(long n, unsigned long *state, double r, double *p)
{
    (void)state;
    return meridians(n, r, 1, p);
}

/* A cap of 20 degrees, by rejection. */
static long cap(long n, unsigned long *state, double *p)
{
    long i;

    for (i = 0; i < n; i++)
        do
            direction(state, 3, p + 3 * i);
        while (p[3 * i + 2] < 0.93969262);
    return n;
}

/* Latitudes and longitudes, on five levels. */
static long stations(long n, unsigned long *state, double *p)
{
    double r, theta, phi;
    long i, k;

    (void)state;
    k = root(n / 10, 2);
    for (i = 0; i < 10 * k * k; i++) {
        r = 6371 + 50 * (double)(i % 5);
        phi = PI * (double)(i / 5 % (2 * k)) / (double)k;
        theta = PI * ((double)(i / 10 / k) + 0.5) / (double)k;
        polar(r, theta, phi, p + 3 * i);
    }
    return 10 * k * k;
}

static long spherefull(long n, unsigned long *state, double *p)
{
    spherenorm(n / 2, state, p);
    ball(n - n / 2, state, p + 3 * (n / 2));
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

static long shells(long n, unsigned long *state, double *p)
{
    double r;
    long i;

    spherenorm(n, state, p);
    for (i = 0; i < n; i++) {
        r = 1 + 0.125 * (double)(i % 4);
        scale(1L, p + 3 * i, r, r, r);
    }
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

/* A cube, and in it a void with a third of the points on its sphere. */
static long cavity(long n, unsigned long *state, double *p)
{
    double *q;
    long i;
    int k;

    spherenorm(n / 3, state, p);
    scale(n / 3, p, 0.6, 0.6, 0.6);
    for (i = n / 3; i < n; i++) {
        q = p + 3 * i;
        do
            for (k = 0; k < 3; k++)
                q[k] = 2 * unit(state) - 1;
        while (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] < 0.36);
    }
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

/* Half on the faces of a rotated cube, half inside. */
static long rotcubein(long n, unsigned long *state, double *p)
{
    cubesurf(n / 2, state, p);
    uniform(n - n / 2, state, p + 3 * (n / 2));
    return n;
}

/* A convex combination of the four vertices of a regular tetrahedron, the
 * first weight 0 on faces; rotated. */
static long tetrahedral(long n, unsigned long *state, double inside, double *p)
{
    double w[4], sum;
    long i, face;
    int k;

    for (i = 0; i < n; i++) {
        face = below(state, 4);
        do {
            sum = 0;
            for (k = 0; k < 4; k++) {
                w[k] = k == face ? 0.0 : unit(state);
                if (k != (face + 1) % 4) sum += w[k];
            }
        } while (sum > 1);
        w[(face + 1) % 4] = 1 - sum;
        if (inside > 0) {
            /* from the face towards its opposite vertex */
            sum = unit(state);
            for (k = 0; k < 4; k++)
                w[k] = product(w[k], sum);
            w[face] = 1 - sum;
        }
        put(p + 3 * i, w[0] + w[1] - w[2] - w[3], w[0] - w[1] + w[2] - w[3],
            w[0] - w[1] - w[2] + w[3]);
    }
    return n;
}

static long rottetin(long n, unsigned long *state, double *p)
{
    tetrahedral(n / 2, state, 0.0, p);
    tetrahedral(n - n / 2, state, 1.0, p + 3 * (n / 2));
    return n;
}

/* The grid on the surface of a cube of integer edge. */
static long cubegrid(long n, unsigned long *state, double *p)
{
    long k = 1, i = 0, x, y, z;

    (void)state;
    while (6 * (k + 1) * (k + 1) + 2 <= n)
        k++;
    for (x = 0; x <= k; x++)
        for (y = 0; y <= k; y++)
            for (z = 0; z <= k; z++)
                if ((x % k == 0 || y % k == 0 || z % k == 0) && i < n)
                    put(p + 3 * i++, (double)x, (double)y, (double)z);
    return i;
}

/* Near a tilted plane, but for less than rough. */
static long tilted(long n, unsigned long *state, double rough, double *p)
{
    long i;

    uniform(n, state, p);
    for (i = 0; i < n; i++)
        p[3 * i + 2] = product(0.3, p[3 * i]) + product(0.7, p[3 * i + 1])
            + product(rough, p[3 * i + 2]);
    shift(n, p, 1.0, 2.0, 3.0);
    return n;
}

/* Three random squares above each other, gap apart, turned. */
static long layered(long n, unsigned long *state, double gap, double *p)
{
    long i;

    uniform(n, state, p);
    for (i = 0; i < n; i++)
        p[3 * i + 2] = product(gap, (double)(i % 3));
    return n;
}

/* Near a slanted line, but for up to three last places in each coordinate. */
static long slanted(long n, unsigned long *state, double *p)
{
    const double ulp = 1.0 / 4503599627370496.0;
    double t;
    long i;
    int k;

    for (i = 0; i < n; i++) {
        t = unit(state);
        put(p + 3 * i, 1 + product(0.7, t), 1 + product(0.5, t),
            1 + product(0.3, t));
        for (k = 0; k < 3; k++)
            p[3 * i + k] += ulp * (double)(below(state, 7) - 3);
    }
    return n;
}

/* Radii 1 and 0.3. */
static long torus(long n, unsigned long *state, double *p)
{
    double a[3], b[3], r;
    long i;

    for (i = 0; i < n; i++) {
        direction(state, 2, a);
        direction(state, 2, b);
        r = 1 + product(0.3, b[0]);
        put(p + 3 * i, product(r, a[0]), product(r, a[1]),
            product(0.3, b[1]));
    }
    return n;
}

/* A pillow one hundredth as thick as it is wide, bent and in folds: two sheets
 * near each other. */
static long sheets(long n, unsigned long *state, double *p)
{
    double x, y;
    long i;

    for (i = 0; i < n; i++) {
        direction(state, 3, p + 3 * i);
        x = p[3 * i];
        y = 0.8 * p[3 * i + 1];
        put(p + 3 * i, x, y, product(0.01, p[3 * i + 2])
            + product(0.3, x * x) + product(0.1, sin(5 * y)));
    }
    return n;
}

/* A sphere of radius 1 in waves, with a tip that reaches to 1.5; every other
 * point farther out by thickness. */
static long wavy(long n, unsigned long *state, double thickness, double *p)
{
    double tip, r, *q;
    long i;

    for (i = 0; i < n; i++) {
        q = p + 3 * i;
        direction(state, 3, q);
        tip = q[2] > 0 ? product(q[2], q[2]) : 0.0;
        tip = product(tip, tip);
        tip = product(tip, tip);
        r = 1 + product(0.5, product(tip, tip))
            + product(0.05, sin(6 * q[0]) * sin(7 * q[1]));
        r += product(thickness, (double)(i % 2));
        scale(1L, q, r, r, r);
    }
    return n;
}

/* ---- surfaces and lines that are surveyed, or meshed ---- */

/* Hills: the height of the ground at x, y, in a unit square. */
static double ground(double x, double y)
{
    return product(0.05, sin(9 * x + 2 * y)) +
           product(0.03, cos(13 * y - 5 * x)) +
           product(0.008, sin(31 * x) * cos(37 * y));
}

static long terrain(long n, unsigned long *state, double *p)
{
    double x, y;
    long i;

    for (i = 0; i < n; i++) {
        x = unit(state);
        y = unit(state);
        put(p + 3 * i, x, y, ground(x, y));
    }
    return n;
}

/* Lines flown over the hills, 20 times as far apart as their samples. */
static long survey(long n, unsigned long *state, double *p)
{
    double x, y;
    long lines = root(n / 20, 2), many, i;

    if (lines < 2) lines = 2;
    many = n / lines;
    for (i = 0; i < lines * many; i++) {
        y = ((double)(i / many) + product(0.01, unit(state))) / (double)lines;
        x = ((double)(i % many) + product(0.1, unit(state))) / (double)many;
        put(p + 3 * i, x, y, ground(x, y));
    }
    return lines * many;
}

/* Straight holes of 400 samples, a few degrees off the vertical. */
static long boreholes(long n, unsigned long *state, double *p)
{
    double x = 0, y = 0, a = 0, b = 0, t;
    long i;

    for (i = 0; i < n; i++) {
        if (i % 400 == 0) {
            x = unit(state);
            y = unit(state);
            a = product(0.2, unit(state)) - 0.1;
            b = product(0.2, unit(state)) - 0.1;
        }
        t = (double)(i % 400) / 800;
        put(p + 3 * i, x + product(a, t), y + product(b, t), ground(x, y) - t);
    }
    return n;
}

/* Smooth random curves of 2,000 samples. */
static long tracks(long n, unsigned long *state, double *p)
{
    double phase[9], t;
    long i;
    int k;

    for (i = 0; i < n; i++) {
        for (k = 0; i % 2000 == 0 && k < 9; k++)
            phase[k] = 2 * PI * unit(state);
        t = (double)(i % 2000) / 2000;
        for (k = 0; k < 3; k++)
            p[3 * i + k] = sin(2 * t + phase[k]) +
                           product(0.5, sin(5 * t + phase[3 + k])) +
                           product(0.2, sin(11 * t + phase[6 + k]));
    }
    return n;
}

/* Random points on 8 pipes of radius 0.03, each in a direction of its own. */
static long pipes(long n, unsigned long *state, double *p)
{
    double axis[8][3], from[8][3], u[3], a, t, length;
    long i;
    int j, k;

    for (j = 0; j < 8; j++) {
        direction(state, 3, axis[j]);
        for (k = 0; k < 3; k++)
            from[j][k] = unit(state);
    }
    for (i = 0; i < n; i++) {
        j = (int)(i % 8);
        /* a direction, less what is along the axis */
        do {
            direction(state, 3, u);
            a = product(u[0], axis[j][0]) + product(u[1], axis[j][1]) +
                product(u[2], axis[j][2]);
            length = sqrt(1 - a * a);
        } while (length < 0.1);
        t = 2 * unit(state) - 1;
        for (k = 0; k < 3; k++)
            p[3 * i + k] = from[j][k] + product(t, axis[j][k]) +
                quotient(0.03 * (u[k] - product(a, axis[j][k])), length);
    }
    return n;
}

/* Six surfaces one above the other, folded alike and less and less so. */
static long horizons(long n, unsigned long *state, double *p)
{
    double x, y;
    long i;

    for (i = 0; i < n; i++) {
        x = unit(state);
        y = unit(state);
        put(p + 3 * i, x, y, product(0.06, (double)(i % 6)) +
            product(ground(x, y), 1 - product(0.12, (double)(i % 6))));
    }
    return n;
}

/* Layers about an ellipse, a fifth thicker each than the one within: stretched
 * cells 24 deep, as many stations along a straight wing. */
static long layers(long n, unsigned long *state, double *p)
{
    double a, d = 0;
    long many = root(n / 8, 2), around, i, j, m = 0;
    int k;

    (void)state;
    if (many < 2) return 0;
    if (many > 24) many = 24;
    around = n / (many * many);
    for (k = 0; k < many; k++) {
        for (i = 0; i < around; i++)
            for (j = 0; j < many; j++) {
                a = 2 * PI * (double)i / (double)around;
                put(p + 3 * m++, product(1 + d, cos(a)),
                    product(0.12 + d, sin(a)), 3 * (double)j / (double)many);
            }
        d = product(1.2, d) + 1e-4;
    }
    return m;
}

/* k circles of k points one above the other, of different radii. */
static long rings(long n, unsigned long *state, double *p)
{
    double a, r;
    long i, k = root(n, 2);

    (void)state;
    for (i = 0; i < k * k; i++) {
        a = 2 * PI * (double)(i % k) / (double)k;
        r = 1 + product(0.3, sin((double)(i / k)));
        put(p + 3 * i, product(r, cos(a)), product(r, sin(a)),
            6 * (double)(i / k) / (double)k);
    }
    return k * k;
}

/* A circle and one point above its centre. */
static long hub(long n, unsigned long *state, double *p)
{
    double a;
    long i;

    (void)state;
    for (i = 0; i < n - 1; i++) {
        a = 2 * PI * (double)i / (double)(n - 1);
        put(p + 3 * i, cos(a), sin(a), 0.0);
    }
    put(p + 3 * i, 0.0, 0.0, 1.0);
    return n;
}

/* Two random squares, two last places of the coordinates apart. */
static long sheets16(long n, unsigned long *state, double *p)
{
    long i;

    uniform(n, state, p);
    for (i = 0; i < n; i++)
        p[3 * i + 2] = i % 2 == 0 ? 0.0 : 5e-16;
    return n;
}

/* ---- parts, sampled and rounded as meshers and scanners write them ---- */

/* Round coordinates to so many decimals; beyond 15 they stay as they are. */
static void decimals(long n, double digits, double *p)
{
    double power = 1;
    long i;

    if (digits > 15) return;
    for (; digits > 0; digits--)
        power *= 10;
    for (i = 0; i < 3 * n; i++)
        p[i] = quotient(floor(product(p[i], power) + 0.5), power);
}

/* What is so high above an outline, at most so wide and deep: a polygon with
 * round holes, or, if it has no corners, a disc. */
struct part {
    double wide, deep, high;
    int corners, holes;
    double corner[6][2], hole[5][3]; /* and radius */
};

/* Is x, y in the outline, and in no hole? */
static int solid(const struct part *a, double x, double y)
{
    int in = 0, i;

    for (i = 0; i < a->corners; i++) {
        const double *b = a->corner[i], *c = a->corner[(i + 1) % a->corners];

        if ((b[1] > y) != (c[1] > y) &&
            x < b[0] + product(y - b[1], quotient(c[0] - b[0], c[1] - b[1])))
            in = !in;
    }
    for (i = 0; i < a->holes; i++) {
        double u = x - a->hole[i][0], v = y - a->hole[i][1];

        if (product(u, u) + product(v, v) <
            product(a->hole[i][2], a->hole[i][2]))
            in = !in;
    }
    return in;
}

/* Random points of the surface of a part, each place as likely as any other,
 * turned and rounded. */
static long sample(long n, unsigned long *state, const struct part *a,
                   double digits, double *p)
{
    double length[11], u[2], all = 0, t;
    const double *b, *c;
    long i;
    int k, walls = a->corners + a->holes;

    for (k = 0; k < walls; k++) {
        b = a->corner[k];
        c = a->corner[(k + 1) % (a->corners + (a->corners == 0))];
        length[k] = k < a->corners
            ? sqrt(product(b[0] - c[0], b[0] - c[0]) +
                   product(b[1] - c[1], b[1] - c[1]))
            : product(2 * PI, a->hole[k - a->corners][2]);
        all += length[k];
    }
    for (i = 0; i < n; i++) {
        t = unit(state) *
            (product(all, a->high) + product(2 * a->wide, a->deep));
        put(p + 3 * i, a->wide * unit(state), a->deep * unit(state),
            a->high * (double)below(state, 2));
        if (t >= product(all, a->high)) {
            if (!solid(a, p[3 * i], p[3 * i + 1])) i--;
            continue;
        }
        t /= a->high;
        for (k = 0; k < walls - 1 && t >= length[k]; k++)
            t -= length[k];
        p[3 * i + 2] = a->high * unit(state);
        if (k < a->corners) {
            b = a->corner[k];
            c = a->corner[(k + 1) % a->corners];
            t = unit(state);
            p[3 * i] = b[0] + product(t, c[0] - b[0]);
            p[3 * i + 1] = b[1] + product(t, c[1] - b[1]);
        } else {
            b = a->hole[k - a->corners];
            direction(state, 2, u);
            p[3 * i] = b[0] + product(b[2], u[0]);
            p[3 * i + 1] = b[1] + product(b[2], u[1]);
        }
    }
    turn(n, p);
    decimals(n, digits, p);
    return n;
}

static long box(long n, unsigned long *state, double digits, double *p)
{
    static const struct part a = {
        100.0, 60.0, 30.0, 4, 0,
        { { 0.0, 0.0 }, { 100.0, 0.0 }, { 100.0, 60.0 }, { 0.0, 60.0 } },
        { { 0.0, 0.0, 0.0 } }
    };

    return sample(n, state, &a, digits, p);
}

/* Four bolts' holes and a bore. */
static long plate(long n, unsigned long *state, double digits, double *p)
{
    static const struct part a = {
        120.0, 80.0, 10.0, 4, 5,
        { { 0.0, 0.0 }, { 120.0, 0.0 }, { 120.0, 80.0 }, { 0.0, 80.0 } },
        { { 12.0, 12.0, 4.0 }, { 108.0, 12.0, 4.0 }, { 108.0, 68.0, 4.0 },
          { 12.0, 68.0, 4.0 }, { 60.0, 40.0, 18.0 } }
    };

    return sample(n, state, &a, digits, p);
}

/* L-shaped. */
static long bracket(long n, unsigned long *state, double digits, double *p)
{
    static const struct part a = {
        60.0, 40.0, 30.0, 6, 0,
        { { 0.0, 0.0 }, { 60.0, 0.0 }, { 60.0, 8.0 }, { 8.0, 8.0 },
          { 8.0, 40.0 }, { 0.0, 40.0 } },
        { { 0.0, 0.0, 0.0 } }
    };

    return sample(n, state, &a, digits, p);
}

static long bar(long n, unsigned long *state, double digits, double *p)
{
    static const struct part a = {
        20.0, 20.0, 50.0, 0, 1, { { 0.0, 0.0 } }, { { 10.0, 10.0, 10.0 } }
    };

    return sample(n, state, &a, digits, p);
}

static long bearing(long n, unsigned long *state, double digits, double *p)
{
    spherenorm(n, state, p);
    scale(n, p, 10.0, 10.0, 10.0);
    turn(n, p);
    decimals(n, digits, p);
    return n;
}

/* ---- hulls of few planes: the faces of a part, masts, stations in time ----
 *
 * In integers, so that the planes are exact, turned as they may be. */

/* On the faces of a prism of so many sides, much higher than it is wide, of
 * which no corner rounds: a place along a side is a multiple of 1/1024 of it. */
static long pillar(long n, unsigned long *state, double faces, double *p)
{
    double corner[4], a, t;
    long i;
    int k;

    for (i = 0; i < n; i++) {
        t = (double)below(state, (long)faces);
        for (k = 0; k < 2; k++) {
            a = 2 * PI * (t + k) / faces;
            corner[2 * k] = floor(1024 * cos(a) + 0.5);
            corner[2 * k + 1] = floor(1024 * sin(a) + 0.5);
        }
        t = (double)below(state, 1024L);
        put(p + 3 * i, corner[0] * (1024 - t) + corner[2] * t,
            corner[1] * (1024 - t) + corner[3] * t,
            (double)(bits(state) >> 4));
    }
    return n;
}

static long pillarturn(long n, unsigned long *state, double faces, double *p)
{
    n = pillar(n, state, faces, p);
    thirds(n, p);
    return n;
}

/* So many vertical masts, each with its share of samples. */
static long masts(long n, unsigned long *state, double many, double *p)
{
    double *q;
    long i;

    for (i = 0; i < n; i++) {
        q = i < many ? p + 3 * i : p + 3 * (i % (long)many);
        if (i < many)
            put(q, (double)below(state, 1048576L),
                (double)below(state, 1048576L), 0.0);
        put(p + 3 * i, q[0], q[1], (double)(bits(state) >> 2));
    }
    return n;
}

static long maststurn(long n, unsigned long *state, double many, double *p)
{
    n = masts(n, state, many, p);
    thirds(n, p);
    return n;
}

/* Along the four legs of twelve towers of different heights. */
static long towers(long n, unsigned long *state, double *p)
{
    double corner[36];
    const double *q;
    long i;

    for (i = 0; i < 12; i++)
        put(corner + 3 * i, (double)below(state, 1048576L),
            (double)below(state, 1048576L), (double)(bits(state) >> 4));
    for (i = 0; i < n; i++) {
        q = corner + 3 * (i % 12);
        put(p + 3 * i, q[0] + 65536.0 * (double)(i / 12 % 2),
            q[1] + 65536.0 * (double)(i / 24 % 2),
            floor(product(unit(state), q[2] + 268435456.0)));
    }
    return n;
}

static long towersturn(long n, unsigned long *state, double *p)
{
    n = towers(n, state, p);
    thirds(n, p);
    return n;
}

/* Twenty stations, in metres, at times in seconds since 1970: each once an
 * hour, in some minute of it. */
static long sites(long n, unsigned long *state, double *p)
{
    double *q;
    long i;

    for (i = 0; i < n; i++) {
        q = p + 3 * (i % 20);
        if (i < 20)
            put(q, (double)below(state, 1000L), (double)below(state, 1000L),
                0.0);
        put(p + 3 * i, q[0], q[1], 1.7e9 + 3600.0 * (double)(i / 20) +
            (double)below(state, 3600L));
    }
    return n;
}

static long sitesturn(long n, unsigned long *state, double *p)
{
    n = sites(n, state, p);
    thirds(n, p);
    return n;
}

/* ---- fill values: what stands for a coordinate that nobody measured ---- */

/* Fill in z for 30 % of the points. */
static void fill(long n, unsigned long *state, double value, double *p)
{
    long i;

    for (i = 0; i < n; i++)
        if (below(state, 10) < 3) p[3 * i + 2] = value;
}

static long fillglobe(long n, unsigned long *state, double value, double *p)
{
    spherenorm(n, state, p);
    fill(n, state, value, p);
    return n;
}

/* A curve (x, x^2, about 0). */
static long fillcurve(long n, unsigned long *state, double value, double *p)
{
    double x;
    long i;

    for (i = 0; i < n; i++) {
        x = unit(state);
        put(p + 3 * i, x, product(x, x), ldexp(unit(state), -10));
    }
    fill(n, state, value, p);
    return n;
}

/* A cloud, and one point farther out than all fill values. */
static long filloutlier(long n, unsigned long *state, double value, double *p)
{
    uniform(n, state, p);
    fill(n, state, value, p);
    put(p, 1e243, 1e243, 1e243);
    return n;
}
