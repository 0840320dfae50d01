/* t_check.c - tests of tess_check: what is wrong it refuses, and says how; what is
 * right it accepts.  And of verify.c beside it.
 *
 *     t_check          all tests
 *     t_check -quick   smaller ones, for slow builds
 */
#include "../lib/exact.h"
#include "../lib/verify.h"
#include "../lib/points.h"
#include "lib/guard.h"
#include "lib/result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void expect(const result *r, int code, const char *what)
{
    int found = checked(r);

    if (found != code) {
        fail(what);
        if (faults <= SHOWN)
            printf("#     tess_check %d instead of %d\n", found, code);
    }
}

/* Twelve points of a circle about the z axis: in order, or every other one, so
 * that they wind twice. */
static void circle(int twice, double *p)
{
    static const double ring[12][2] = {
        { 5, 0 }, { 4, 3 }, { 3, 4 }, { 0, 5 }, { -3, 4 }, { -4, 3 },
        { -5, 0 }, { -4, -3 }, { -3, -4 }, { 0, -5 }, { 3, -4 }, { 4, -3 }
    };
    int i, j;

    for (i = 0; i < 12; i++) {
        j = twice ? (2 * i + i / 6) % 12 : i;
        p[3 * i] = ring[j][0];
        p[3 * i + 1] = ring[j][1];
        p[3 * i + 2] = 0.0;
    }
}

/* Every kind of fault by hand. */
static void test_faults(void)
{
    static const double five[15] = {
        0, 0, 0, 8, 0, 0, 0, 8, 0, 2, 2, 1, 2, 2, -1
    };
    static const tess_int two[8] = { 0, 1, 2, 3, 0, 2, 1, 4 };
    static const tess_int three[12] = { 3, 4, 0, 1, 3, 4, 1, 2, 3, 4, 2, 0 };
    static const double cube[27] = {
        0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1,
        1, 1, 1, 0.25, 0.5, 0.75
    };
    /* a regular tetrahedron and four corners, in two ways */
    static const tess_int cube1[20] = {
        0, 3, 6, 5, 1, 0, 5, 3, 2, 0, 3, 6, 4, 0, 6, 5, 7, 3, 5, 6
    };
    static const tess_int cube2[20] = {
        1, 2, 4, 7, 0, 1, 2, 4, 3, 2, 1, 7, 5, 1, 4, 7, 6, 4, 2, 7
    };
    static const double octa[18] = {
        1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1
    };
    double p[15 * 3];
    tess_int tet[48], i;
    result r;
    int turn;

    faults = 0;
    given(&r, "five points, two tetrahedra", five, 5, two, 2);
    current = &r;
    expect(&r, TESS_BAD_BALL, "not Delaunay");
    given(&r, "five points, three tetrahedra", five, 5, three, 3);
    expect(&r, 0, "the right flip");
    r.ntet = 2;
    link_up(&r);
    expect(&r, TESS_BAD_HULL, "one of three missing");
    r.ntet = 1;
    link_up(&r);
    expect(&r, TESS_BAD_POINT, "one of three alone");
    r.ntet = 0;
    require(checked(&r) > 0, "no tetrahedron, though the points have some");
    release(0);

    /* cospherical points: any triangulation of them is right */
    for (turn = 0; turn < 2; turn++) {
        given(&r, "cube in five", cube, 8, turn ? cube2 : cube1, 5);
        current = &r;
        expect(&r, 0, "a cube in five");
        /* a point inside it that no tetrahedron has */
        given(&r, "cube with a point inside", cube, 9, r.tet, 5);
        expect(&r, TESS_BAD_POINT, "a missing point");
        {
            tess_int bad = -7, *iw = ints(18);

            tess_check(9, r.p, r.ntet, r.tet, r.adj, 18, iw, &bad);
            require(bad == 8, "bad is not the missing point");
        }
        release(0);
    }
    for (turn = 0; turn < 3; turn++) {
        /* four tetrahedra around a diagonal; points 2i, 2i+1 are opposite */
        tess_int d = 2 * turn, e = (d + 2) % 6, g = (d + 4) % 6;
        tess_int around[5];

        around[0] = around[4] = e;
        around[1] = g;
        around[2] = e + 1;
        around[3] = g + 1;
        for (i = 0; i < 4; i++) {
            tet[4 * i] = d;
            tet[4 * i + 1] = d + 1;
            tet[4 * i + 2] = around[i];
            tet[4 * i + 3] = around[i + 1];
        }
        given(&r, "octahedron", octa, 6, tet, 4);
        current = &r;
        expect(&r, 0, "an octahedron about any of its diagonals");
        release(0);
    }
    /* twelve points of a circle, taken every other one, twice around the axis
     * between two poles: a closed surface, convex at every edge, all points
     * on one ball, Euler's relation holds; but it winds twice */
    circle(1, p);
    for (i = 0; i < 12; i++) {
        tet[4 * i] = 12;
        tet[4 * i + 1] = 13;
        tet[4 * i + 2] = i;
        tet[4 * i + 3] = (i + 1) % 12;
    }
    for (i = 36; i < 42; i++) p[i] = 0.0;
    p[38] = -5.0;
    p[41] = 5.0;
    given(&r, "wound twice", p, 14, tet, 12);
    current = &r;
    require(orient(&r, 12, 13, 0, 1) == 1, "the test's own complex");
    expect(&r, TESS_BAD_COVER, "a complex wound twice");
    /* the same with O at the other pole, the greatest in its coordinate */
    for (i = 0; i < 12; i++) {
        tet[4 * i] = 13;
        tet[4 * i + 1] = 12;
        tet[4 * i + 2] = (i + 1) % 12;
        tet[4 * i + 3] = i;
    }
    given(&r, "wound twice", p, 14, tet, 12);
    expect(&r, TESS_BAD_COVER, "a complex wound twice, from above");
    /* once around, in order, is right */
    circle(0, p);
    given(&r, "wound once", p, 14, tet, 12);
    expect(&r, 0, "a complex wound once");
    /* the same twice around with a point in the middle of the axis, which is
     * a vertex of all tetrahedra */
    {
        tess_int more[96];

        for (i = 0; i < 48; i++) {
            more[i] = tet[i] == 12 ? 14 : tet[i];
            more[48 + i] = tet[i] == 13 ? 14 : tet[i];
        }
        circle(1, p);
        for (i = 42; i < 45; i++) p[i] = 0.0;
        given(&r, "wound twice about a point", p, 15, more, 24);
        expect(&r, TESS_BAD_COVER, "wound twice about a point");
        circle(0, p);
        given(&r, "wound once about a point", p, 15, more, 24);
        expect(&r, 0, "wound once about a point");
    }
    /* the great icosahedron: twelve vertices of an icosahedron, joined in
     * threes that are not neighbours in it, and its centre */
    {
        static const double far = 1.6180339887498949;
        static double q[39];
        tess_int star[80], a, b, c, m = 0;

        for (i = 0; i < 12; i++) {
            q[3 * i + i / 4] = 0.0;
            q[3 * i + (i / 4 + 1) % 3] = i % 2 ? 1.0 : -1.0;
            q[3 * i + (i / 4 + 2) % 3] = i / 2 % 2 ? far : -far;
        }
        for (a = 0; a < 12; a++)
            for (b = a + 1; b < 12; b++)
                for (c = b + 1; c < 12; c++) {
                    const double *x = q + 3 * a, *y = q + 3 * b;
                    const double *z = q + 3 * c;
                    double xy = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
                    double yz = y[0] * z[0] + y[1] * z[1] + y[2] * z[2];
                    double zx = z[0] * x[0] + z[1] * x[1] + z[2] * x[2];

                    /* neighbours have far, opposite ones -3.6 */
                    if (xy < -3.0 || yz < -3.0 || zx < -3.0 || xy > 0.0 ||
                        yz > 0.0 || zx > 0.0 || m == 80)
                        continue;
                    /* positive as it is: the centre stays first */
                    star[m] = 12;
                    star[m + 1] = a;
                    if (ex_orient(q + 36, x, y, z) > 0) {
                        star[m + 2] = b;
                        star[m + 3] = c;
                    } else {
                        star[m + 2] = c;
                        star[m + 3] = b;
                    }
                    m += 4;
                }
        require(m == 80, "the test's own icosahedron");
        given(&r, "great icosahedron", q, 13, star, m / 4);
        expect(&r, TESS_BAD_COVER, "a great icosahedron");
    }
    /* the whole twice over, on the same points */
    {
        tess_int twice[96];

        for (i = 0; i < 96; i++) twice[i] = tet[i % 48];
        given(&r, "twice the same", p, 14, twice, 24);
        r.ntet = 12;
        link_up(&r);
        r.ntet = 24;
        for (i = 48; i < 96; i++) {
            r.tet[i] = r.tet[i - 48];
            r.adj[i] = r.adj[i - 48] < 0 ? TESS_NONE : r.adj[i - 48] + 12;
        }
        i = checked(&r);
        require(i == TESS_BAD_COVER || i == TESS_BAD_HULL,
                "all tetrahedra twice");
    }
    /* what condition 4 of tess_check alone refuses: two tetrahedra apart, each
     * a convex body; and five points of a circle, joined twice around the axis
     * in a star, with O in one of its tips, which is covered once */
    {
        static const double apart[24] = {
            0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1,
            5, 0, 0, 6, 0, 0, 5, 1, 0, 5, 0, 1
        };
        static const tess_int both[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
        static const int tip[5] = { 0, 5, 10, 2, 7 };
        double ring[36];

        given(&r, "two tetrahedra apart", apart, 8, both, 2);
        current = &r;
        expect(&r, TESS_BAD_HULL, "two tetrahedra apart");
        circle(0, ring);
        for (i = 0; i < 5; i++) {
            memcpy(p + 3 * i, ring + 3 * tip[i], 3 * sizeof *p);
            tet[4 * i] = i;
            tet[4 * i + 1] = (i + 1) % 5;
            tet[4 * i + 2] = 5;
            tet[4 * i + 3] = 6;
        }
        for (i = 15; i < 21; i++) p[i] = 0.0;
        p[17] = -5.0;
        p[20] = 5.0;
        given(&r, "a star", p, 7, tet, 5);
        require(orient(&r, 0, 1, 5, 6) == 1, "the test's own star");
        expect(&r, TESS_BAD_HULL, "a star, O in a tip");
        /* with O in the middle, at a pole, it is covered twice */
        for (i = 0; i < 5; i++) {
            tet[4 * i] = 5;
            tet[4 * i + 1] = 6;
            tet[4 * i + 2] = i;
            tet[4 * i + 3] = (i + 1) % 5;
        }
        given(&r, "a star", p, 7, tet, 5);
        expect(&r, TESS_BAD_COVER, "a star, O in the middle");
    }
    /* flat */
    given(&r, "flat", cube, 8, two, 1);
    require(orient(&r, 0, 1, 2, 3) == 0, "the test's own points");
    expect(&r, TESS_BAD_SIGN, "a flat tetrahedron");
    current = NULL;
    release(0);
    test_result("tess_check: complexes by hand", faults);
}

/* Does verify find what is wrong with r?  Asked of every seventh. */
static int wrong(const result *r, tess_int i)
{
    return i % 7 != 0 || verify(r->n, r->p, TESS_OK, r->ntet, r->tet, r->adj,
                                r->iw) != NULL;
}

/* Every entry of right results changed in turn: what is wrong must be seen,
 * and said by its code where it is the only fault. */
static void test_mutations(void)
{
    static const char *const family[] = {
        "uniform", "lattice", "duplicates", "cubesurf", "spherei", NULL
    };
    result r;
    tess_int i, j, k, held, other, bad, *iw;
    int f, code, b;

    for (f = 0; family[f] != NULL; f++) {
        faults = 0;
        current = NULL;
        points(&r, family[f], quick ? 14 : 30, 8);
        solve(&r);
        current = &r;
        require(r.code == TESS_OK && checked(&r) == 0, "a right result");
        iw = ints(2 * r.n);
        for (i = 0; i < 4 * r.ntet; i++) {
            /* vertices out of range, or twice */
            held = r.tet[i];
            for (k = 0; k < 4; k++) {
                r.tet[i] = k == 0 ? r.n : k == 1 ? -1
                         : r.tet[i - i % 4 + (i + k - 1) % 4];
                expect(&r, TESS_BAD_INDEX, "a bad vertex");
            }
            /* any other vertex */
            for (j = 0; j < r.n; j++) {
                if (j == held) continue;
                r.tet[i] = j;
                code = checked(&r);
                require(code > 0 && wrong(&r, i), "another vertex");
                if (r.iw[j] == held)
                    require(code == TESS_BAD_TWIN, "a duplicate");
            }
            r.tet[i] = held;
            /* any other neighbour */
            held = r.adj[i];
            for (j = -5; j < r.ntet + 3; j++) {
                if (j == held) continue;
                r.adj[i] = j;
                code = checked(&r);
                require(code > 0 && wrong(&r, i), "another neighbour");
                if (j == TESS_OPEN)
                    require(code == TESS_BAD_OPEN, "an open facet");
                if (j < TESS_OPEN || j >= r.ntet || j == i / 4)
                    require(code == TESS_BAD_ADJ, "adj out of range");
            }
            r.adj[i] = held;
            /* two vertices exchanged, with their neighbours */
            for (k = 0; k < 3; k++) {
                other = i - i % 4 + (i + 1 + k) % 4;
                for (b = 0; b < 2; b++) {
                    held = r.tet[i];
                    r.tet[i] = r.tet[other];
                    r.tet[other] = held;
                    held = r.adj[i];
                    r.adj[i] = r.adj[other];
                    r.adj[other] = held;
                    if (b == 0) {
                        bad = -7;
                        code = tess_check(r.n, r.p, r.ntet, r.tet, r.adj,
                                          2 * r.n, iw, &bad);
                        require(code == TESS_BAD_SIGN && bad == i / 4 &&
                                    wrong(&r, i),
                                "a tetrahedron turned inside out");
                    }
                }
                /* the neighbours alone */
                held = r.adj[i];
                if (held != r.adj[other]) {
                    r.adj[i] = r.adj[other];
                    r.adj[other] = held;
                    require(checked(&r) == TESS_BAD_ADJ && wrong(&r, i),
                            "adj exchanged");
                    r.adj[other] = r.adj[i];
                    r.adj[i] = held;
                }
            }
        }
        require(checked(&r) == 0, "the test's own result");
        /* one tetrahedron left out: the hull is not convex, or a point is
         * left out with it */
        for (i = 0; i < r.ntet; i++) {
            result s = r;
            int hull = 0, keep = narrays, b2;

            for (b2 = 0; b2 < 4; b2++) hull += r.adj[4 * i + b2] == TESS_NONE;
            s.tet = ints(4 * r.ntet);
            s.adj = ints(4 * r.ntet);
            for (j = k = 0; j < 4 * r.ntet; j++)
                if (j / 4 != i) s.tet[k++] = r.tet[j];
            s.ntet = r.ntet - 1;
            link_up(&s);
            code = checked(&s);
            require((hull >= 3 ? code > 0 : code == TESS_BAD_HULL) &&
                        wrong(&s, 0), "a tetrahedron left out");
            release(keep);
        }
        /* even permutations of vertices, another order of the tetrahedra */
        for (i = 0; i < r.ntet; i++) {
            held = r.tet[4 * i];
            r.tet[4 * i] = r.tet[4 * i + 1];
            r.tet[4 * i + 1] = r.tet[4 * i + 3];
            r.tet[4 * i + 3] = held;
            j = (tess_int)rnd_below((int)r.ntet);
            for (k = 0; k < 4; k++) {
                held = r.tet[4 * i + k];
                r.tet[4 * i + k] = r.tet[4 * j + k];
                r.tet[4 * j + k] = held;
            }
        }
        link_up(&r);
        expect(&r, 0, "tetrahedra in another order");
        current = NULL;
        release(0);
        done("changed results", family[f]);
    }
}

static void test_check_arguments(void)
{
    result r;
    tess_int iw[100], bad = -7;
    tess_real held;
    int i;

    faults = 0;
    current = NULL;
    points(&r, "uniform", 40, 2);
    solve(&r);
    current = &r;
    require(tess_check(-1, r.p, r.ntet, r.tet, r.adj, 100, iw, &bad) == -1,
            "tess_check with n < 0");
    require(tess_check(largest() / 3 + 1, r.p, r.ntet, r.tet, r.adj, 100, iw,
                       &bad) == -1, "tess_check with n too large");
    require(tess_check(r.n, r.p, (largest() - 3) / 4 + 1, r.tet, r.adj, 100,
                       iw, &bad) == -3, "tess_check with ntet too large");
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, r.n - 1, iw, &bad) ==
            -6, "tess_check with liw < n");
    require(tess_check(r.n, r.p, -1, r.tet, r.adj, 100, iw, &bad) == -3,
            "tess_check with ntet < 0");
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 79, iw, &bad) == -6,
            "tess_check with liw too small");
    for (i = 0; i < 120; i++) {
        held = r.p[i];
        r.p[i] = (tess_real)(i % 2 ? infinity() : infinity() - infinity());
        require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 80, iw, &bad) ==
                -2, "tess_check with NaN or infinity");
        r.p[i] = held;
    }
    require(tess_check(r.n, r.p, r.ntet, r.tet, r.adj, 80, iw, &bad) == 0 &&
            bad == TESS_NONE, "tess_check");
    current = NULL;
    release(0);
    test_result("bad arguments of tess_check", faults);
}

int main(int argc, char **argv)
{
    quick = test_quick(argc, argv);
    rnd_seed(1);
    test_check_arguments();
    test_faults();
    test_mutations();
    return test_end();
}
