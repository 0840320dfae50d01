/* tess.c - Delaunay tetrahedralization of points in space; see tess.h.
 *
 * SPDX-License-Identifier: 0BSD
 * Copyright (c) 2026 the tess authors
 *
 * Permission to use, copy, modify, and/or distribute this software for any
 * purpose with or without fee is hereby granted.
 *
 * THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL WARRANTIES WITH
 * REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED WARRANTIES OF MERCHANTABILITY
 * AND FITNESS.  IN NO EVENT SHALL THE AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT,
 * INDIRECT, OR CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
 * LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT, NEGLIGENCE OR
 * OTHER TORTIOUS ACTION, ARISING OUT OF OR IN CONNECTION WITH THE USE OR
 * PERFORMANCE OF THIS SOFTWARE.
 *
 * HOW THIS FILE IS LAID OUT.  It has four parts, and within a part a routine
 * stands before those that call it.
 *   I    A mesh: tess and all that it needs.  Without part II (-DTESS_CORE) it
 *        is slow on some data, but complete.  It needs no later page.
 *   II   Faster searches: a chapter for each mechanism.  Each has a macro that
 *        leaves it out, and no result changes.
 *   III  Without a whole mesh: one star on its own, parts, queries.
 *   IV   Using a mesh: location, values, the hull, the check, a ball.
 * Part I calls parts II and III by hooks alone.  They are declared behind the
 * types: nothing else is declared ahead.  f77/tess.f is this file in FORTRAN,
 * routine by routine.
 *
 * THE ALGORITHM, after C. Hazlewood, "Facet-Based Tetrahedralization Software"
 * (1995), Section 2.  The mesh grows from one facet of the convex hull,
 * tetrahedron by tetrahedron; none is ever deleted.
 *
 *   1  Sort the points into a k-d tree, without duplicates: prepare_points.
 *      (J. L. Bentley, Comm. ACM 18, 1975, 509-517; J. H. Friedman, J. L.
 *      Bentley and R. A. Finkel, ACM Trans. Math. Software 3, 1977, 209-226.)
 *   2  Find a facet of the hull by gift wrapping: first_facet.  It is open: the
 *      tetrahedron on its inner side is unknown.
 *   3  Take an open facet: complete_star.
 *   4  Find its apex: of the points strictly on its open side the one whose
 *      ball, through the facet and that point, has none of the others inside:
 *      apex.  If there is no such point, the facet is one of the hull.
 *   5  Store the tetrahedron of facet and apex: add_tetrahedron.  Each of its
 *      other three facets is either the other side of an open facet, and both
 *      are closed, or it is open from now on: match_or_push, match_or_enter.
 *   6  Repeat from 3 until no facet is open.
 *
 * The search for an apex compares points by their L-coordinates, of which the
 * apex has the least (Theorem 1).  It keeps the best point so far.  The ball
 * of facet and best point contains every better one (Lemma 3), so search_tree,
 * which goes from the facet's own leaf up to the root, skips the nodes whose
 * boxes are outside of that ball.
 *
 * ORDER OF THE WORK.  Facets are taken star by star: all open facets at one
 * vertex, then those at the next.  A vertex whose star is complete can never
 * again be an apex, so it leaves the tree, and the pool of open facets stays
 * small.  The order is a function of the points, tet and adj alone, so an
 * unfinished result needs no other state:
 *   star   s = the first vertex of the last tetrahedron, if it has an open
 *          facet; else the vertex of least position that has one
 *   facet  the open facet at s of the earliest tetrahedron, and of those of
 *          that tetrahedron the one of greatest k
 *
 * DECISIONS.  Every decision that affects tet or adj is exact: a comparison of
 * the caller's coordinates, or a predicate of hhpred.  Floating point only
 * chooses where to look, with margins that cover its rounding.
 *
 * The tie rule of hhpred decides where more than four points are on one empty
 * ball.  On it rest the emptying of the pool, as each facet of a tetrahedron
 * leads to the same one; first_facet, on a hull face of more than three points;
 * check_unfinished; cospherical sets; hh_pinsphere, where it takes both
 * candidates to be on the positive side; walk and incident_tet, which take
 * heights to be lowered.
 *
 * GLOSSARY of part I; each chapter of part II has its own.
 *   number         a point's index in the caller's p
 *   position       its place in the sorted order; all internal arrays use it
 *   leaf, node     a run of at most LEAF_POINTS successive positions; a node of
 *                  the k-d tree: a leaf or what is above leaves
 *   box            the bounding volume of a node's points, along the axes
 *   alive          of a leaf, how many of its points are uncompleted, that is,
 *                  have a star that is not complete; of another node, how many
 *                  of its children are not empty
 *   facet          three vertices, turned so that the open side is positive
 *   open side      where the unknown tetrahedron is
 *   code 4t+k      facet k of tetrahedron t, opposite to its vertex k
 *   open facet     one whose other side is not known yet: adj is TESS_OPEN
 *   owner          of an open facet: of its wanted vertices the one of least
 *                  position
 *   seed edge      an open facet that belongs to no tetrahedron yet
 *   star of s      all tetrahedra that have the vertex s
 *   hub            a vertex with a very large star
 *   link of s      here the open facets at s, as directed edges a -> b, so that
 *                  (s, a, b) is positive towards the unknown side
 *   wanted         a vertex whose star is asked for: any, except in a part
 *   guess          a point that a search compares first: from the link, it is
 *                  the apex two times out of three; without guesses the worst
 *                  of the tests' 24 families of points takes 4.7 times the
 *                  instructions
 *   candidate      an uncompleted point strictly on the open side
 *   base           the vertex from which side and power are computed
 *   w              a point minus the base
 *   side           of a point: v.w, v being the facet's unit normal
 *   L-coordinate   of a point: the signed height over the facet of the centre
 *                  of the ball through the facet and the point
 *   apex           the candidate of least L, ties by the rule of hhpred
 *   best point     the apex among the points compared so far
 *   better         said of a candidate that would replace the best point
 *   ball           that of the facet and the best point, or of an upper bound
 *                  of its L: every better point is in it
 *   power          of w: |w|^2 - 2 c.w, negative inside the ball of centre c
 *                  through the base
 *   filter         an inequality that every better point satisfies: points,
 *                  boxes and what part II keeps are tested against it
 *   surface        of part II: a plane or a sphere that many points are near;
 *                  the mark of such a point tells its height over it.  Without
 *                  part II there is none
 *   offered        said of a point that has gone through offer_point
 *   limb           a digit of an exact number, kept in a double: see hhpred.c
 *   undecided      said of a comparison that the bounds of doubles leave open
 *   stage          what may end a search before the tree does
 *   E, dc, rho     the error of the unit normal; that of the circumcentre; the
 *                  circumradius: see hh_facet
 *
 * THE ARRAYS (n points, np of them distinct; L leaves: leaf_count(n) in the
 * arrays' lengths, leaf_count(np) in the tree).  tet holds positions during a
 * call, numbers of points again when it returns; adj is as the caller sees it.
 *
 *   array           length       during a call              when it returns
 *   iw:
 *   representative  n            number -> the least        the same; in an
 *                                number of the points that  index number ->
 *                                coincide with it           position
 *   order           n            position -> number         the same
 *   first_tet       INDEX_EXTRA  in an index as it was,     see write_header
 *                                else places 0 and 4 are 0
 *   alive           2 L          node -> how much of it is  all of it; place
 *                                alive                      0: the number of
 *                                                           surfaces
 *   mark            0 or marks   what reference surfaces    the same
 *                                keep, if liw is what
 *                                tess_size gives
 *   owned           n            position -> first entry    scratch
 *                                that it owns, NONE, or
 *                                UNWANTED; in
 *                                check_unfinished, number
 *                                -> position
 *   edge_from       n            position -> first edge     scratch
 *                                from it, NONE, NEW or
 *                                COMPLETE
 *   pool            pool_len     see below                  scratch
 *   rw:
 *   x               3 n          position -> scaled         the same
 *                                coordinates
 *   box             12 L         of each node               the same; places 0
 *                                                           to 5, a header: see
 *                                                           write_header
 *   cylinders       0 or more    theirs, if lrw is what     the same
 *                                tess_size gives
 *
 *   pool  0        ENTRY_LEN slots      newest_edge  oldest_edge       pool_len
 *         | entries of the table | free |<-- edges of the link | dead edges |
 *
 *   owned[v] -----> entry <--> entry <--> entry    facets that v owns
 *   edge_from[a] -> edge   --> edge   --> edge     edges from a, by EDGE_CHAIN
 *
 *   tree  node          1            node i: children 2i and 2i+1,
 *                   2       3        alive[i], box[6i] ... box[6i+5]
 *         leaf    0   1   2   3      leaf j: node L + j (here L = 4)
 *         x     |...|...|...|...|    its points have successive positions
 */
#include "tess.h"
#if TESS_VERSION != 50000L
#error tess.c and tess.h are of different versions
#endif
#include <math.h>
#include <stddef.h>

/* =====================================================================
 * PART I: A MESH
 * ===================================================================== */

/* ---- codes, formats and types ----
 *
 * A constant on which no result depends trades time and memory, and says for
 * what; if correctness rests on one, its comment says so. */

#define NONE (-1)     /* no position, entry, edge, surface or code of a facet */
#define UNSURE 2      /* a sign that bounds, or too few limbs, leave open */
/* Answers of compare_exactly, and of hh_pinsphere but for REJECTED. */
#define BEATS (-1)      /* the point is better than the best point */
#define LOSES 1         /* it is not */
#define REJECTED 0      /* it is not, and its L-coordinate tells nothing */
/* States of a vertex: see "star by star". */
#define COMPLETE (-2)   /* in edge_from: the vertex's star is complete */
#define NEW (-3)        /* in edge_from: the vertex is in no tetrahedron yet */
#define UNWANTED (-2)   /* in owned: the vertex's star is not asked for */
/* Maximum number of points in a leaf; the leaf of s is the block of its lists.
 * Trades nodes against points scanned.  It is an array's length. */
#define LEAF_POINTS 48
/* Size of the groups that a leaf's points are sorted into: a search looks at
 * the least power of a group first.  It also suits the width of vectors. */
#define LEAF_GROUP 8
#if LEAF_POINTS % LEAF_GROUP != 0
#error LEAF_POINTS is not a multiple of LEAF_GROUP: see offer_leaf
#endif
/* An entry of the pool's table: its length in integers, and the places of the
 * facet's code, of the owner's next and previous entries, and of the hash. */
#define ENTRY_LEN 4
#define ENTRY_CODE 0
#define ENTRY_NEXT 1
#define ENTRY_PREV 2
#define ENTRY_SIG 3
/* An edge a -> b of the link: its length in integers, and the places of the
 * facet's code, of a and b, of an edge that ends at a and of one that begins at
 * b, which give guesses, and of the next edge from a; each edge may be NONE. */
#define EDGE_LEN 6
#define EDGE_CODE 0
#define EDGE_FROM 1
#define EDGE_TO 2
#define EDGE_PREV 3
#define EDGE_NEXT 4
#define EDGE_CHAIN 5
/* In EDGE_CODE. */
#define SEED_EDGE (-2) /* the facet belongs to no tetrahedron yet */
#define DEAD_EDGE (-3) /* the edge is not in the link any more */
/* Bound on the relative error of one operation in every rounding mode, in
 * double and in single precision.  A sum of three numbers, in any order, errs
 * by twice that.  Each bound made of them has a row in test/bounds, which
 * says how it is derived and checked. */
#define EPS DBL_EPSILON
#define FEPS FLT_EPSILON
/* Relative room for the few roundings of a bound. */
#define ROUNDING (64.0 * EPS)

/* A filter.  Every better point w satisfies
 *     |w|^2 - 2 c.w + weight (height(w) - base_height)
 *         <= allowance + size (2 dc + 8 EPS (size + 2 c1)),
 * w being seen from the base, size >= |w|_1, height(w) its height over the
 * facet's reference surface.  The right-hand side is filter_bound. */
typedef struct ball_filter {
    double c[3];        /* the centre of the ball, seen from the base */
    double dc;          /* a bound on the error of c, with 0.5 % to spare */
    double c1;          /* |c|_1 */
    double weight;      /* the factor of heights; only of a surface filter */
    double base_height; /* the base's height; only of a surface filter */
    double allowance;   /* the part of the bound that does not depend on w */
} ball_filter;

/* Lengths of the workspace for n points. */
typedef struct ws_lengths {
    tess_int iw, rw;    /* the minima of liw and lrw */
    tess_int pool;      /* what is recommended for the pool beyond iw */
    tess_int marks;     /* what marks for surfaces take beyond that, or 0 */
    tess_int cylinders; /* what cylinders take beyond rw, or 0 */
} ws_lengths;

/* ---- what part II keeps ----
 *
 * Each chapter has a member of its own in mesher, named after it, and in search
 * if it keeps something of one search.  Part I does not look into them: go on
 * with "a search, and a mesh". */

/* Capacity of a candidate list (see tess.h).  Trades searches that end in lists
 * against the stack.  It is an array's length. */
#ifndef TESS_LIST
#define TESS_LIST 448
#endif
#if TESS_LIST < LEAF_POINTS || TESS_LIST > 4096 || TESS_LIST % 4 != 0
#error TESS_LIST is not a multiple of 4 from 48 (LEAF_POINTS) to 4096
#endif
/* The chapters of part II only make searches faster: -DTESS_CORE leaves out all
 * of them, each of these macros one, and the results are the same.  Near lists
 * and cospherical sets are made from lists.  Short lists are for small
 * machines, which have no room for all chapters. */
#ifdef TESS_CORE
#define TESS_NO_LISTS 1
#define TESS_NO_HULL_PLANES 1
#define TESS_NO_CYLINDERS 1
#define TESS_NO_CAPS 1
#define TESS_NO_LIMBS 1
#define TESS_NO_SURFACES 1
#endif
#if TESS_LIST < 128
#define TESS_NO_NEAR_LISTS 1
#define TESS_NO_CYLINDERS 1
#define TESS_NO_CAPS 1
#define TESS_NO_SURFACES 1
#endif
#ifdef TESS_NO_LISTS
#define TESS_NO_NEAR_LISTS 1
#define TESS_NO_SETS 1
#endif

#ifndef TESS_NO_LISTS
/* A candidate list: uncompleted points in single precision.  A block list has
 * those in a box, a star list those near its vertex, a near list those in a
 * ball.  A star list's coordinates are offsets from its vertex in units of
 * reach; the others' are offsets from the centre of their box, or of their
 * ball's box, in units of its half width. */
typedef struct candidate_list {
    tess_int leaf_first; /* of a block list: the first position of its leaf */
    tess_int leaf_end;   /* of a block list: the position after its leaf's */
    int n;               /* the number of points; 0: there is no list */
    double reach;        /* the list has all uncompleted points within this of
                          * the leaf's box, of the vertex or of centre */
    double origin[3];    /* the point that coordinates are offsets from */
    double scale;        /* the factor that gives coordinates their units */
    double centre[3];    /* of a near list: the centre of its ball */
    double lo[3], hi[3]; /* the box, as far as it is in the root's */
    double max_abs[3];   /* bounds on the coordinates, but for rounding */
    float x[TESS_LIST];  /* the first coordinates */
    float y[TESS_LIST];  /* the second coordinates */
    float z[TESS_LIST];  /* the third coordinates */
    float norm2[TESS_LIST + LEAF_POINTS]; /* sums of their squares; powers
                                           * while a near list is made */
    tess_int position[TESS_LIST + LEAF_POINTS]; /* the points' positions */
} candidate_list;
#endif

#ifndef TESS_NO_NEAR_LISTS
/* Number of near lists: an array's length. */
#define NEAR_LISTS 5
#endif

#ifndef TESS_NO_HULL_PLANES
/* Maximum number of hull planes that are kept: trades exact sides computed in
 * vain against searches of hull facets.  It is an array's length. */
#define HULL_PLANES (TESS_LIST < 128 ? 4 : 64)
#endif

#ifndef TESS_NO_SETS
/* Maximum number of points of a cospherical set, and of sets kept: arrays'
 * lengths.  They trade the stack against ties found again. */
#define SET_POINTS 12
#define SETS 4

/* A cospherical set: the uncompleted points exactly on the sphere of one empty
 * ball; see "ties". */
typedef struct cospherical_set {
    int n;                         /* the number of points */
    tess_int position[SET_POINTS]; /* the points; the least number first */
} cospherical_set;
#endif

#ifndef TESS_NO_CAPS
/* Number of supporting planes that are kept: an array's length. */
#define CAPS 32
#endif

#ifndef TESS_NO_SURFACES
/* Maximum number of reference surfaces.  The layout of an index rests on it. */
#define SURFACES 8
/* Places of a sample: stack against the quality of a fit.  It is an array's
 * length. */
#define SAMPLE_SIZE 32

/* The format of a surface's record in an index: its length in integers, and the
 * places of the position of its first point, of 1 for a plane, of the exponent
 * of the quantum, of that of the unit of the normal or centre, and of its three
 * coordinates in these units; digits of a coordinate; their base; what is added
 * to exponents. */
#define RECORD (RECORD_DIGITS + 3 * DIGITS)
#define RECORD_POINT 0
#define RECORD_PLANE 1
#define RECORD_QUANTUM 2
#define RECORD_UNIT 3
#define RECORD_DIGITS 4
#define DIGITS 4
#define DIGIT 8192.0
#define EXPONENT 2000

/* A reference surface: a plane or a sphere that many points are near.  A point
 * with mark k, 0 ... MARKS - 1, has a height between lowest + (k - 1/2) quantum
 * and lowest + (k + 3/2) quantum. */
typedef struct ref_surface {
    tess_int *record;     /* what an index stores of it: see surface_record */
    tess_int *mark_range; /* node -> the range of its points' marks */
    hh_sphere limbs;      /* the surface by limbs; a plane or a sphere */
    const double *origin; /* the coordinates of its first point */
    double c[3];          /* the unit normal, or the centre seen from origin */
    double lowest;        /* the least height that has a mark; it is negative */
    double quantum;       /* the unit of marks */
} ref_surface;
#endif

/* ---- a search, and a mesh ---- */

/* A search for the apex of one facet. */
typedef struct search {
    /* the facet */
    tess_int facet[3];        /* its vertices; the open side is positive */
    double hh[HH_FACET_LEN];  /* its set-up (see hh_facet); if its surface is a
                               * sphere, L counts from another centre */
    int base;                 /* facet[base] is the base */
    /* the best point */
    tess_int best;            /* the best point so far, exactly, or NONE */
    double lo, hi;            /* limits of its L-coordinate */
    long ties;                /* how many points met are exactly on its ball */
    /* its ball */
    int has_ball;             /* 1: filter is a ball's; 0: a half-space's */
    int by_limbs;             /* 1: refine_ball found the ball: set_upper_bound
                               * leaves it as it is */
    ball_filter filter;       /* the filter without heights */
    /* for stages */
    int in_lists;             /* 1: candidate lists may hold its ball */
    tess_int nodes;           /* how many nodes the search has visited */
    /* what part II keeps */
#ifndef TESS_NO_NEAR_LISTS
    struct {
        candidate_list *collect;  /* gets the points that pass filter, on either
                               * side of the facet; or NULL: those on the open
                               * side are offered */
        double skin_factor;   /* the thickness of the skin as it adapts */
        double skin;          /* the thickness of the skin of this ball */
        int pays;             /* 1: a near list may end the search */
    } nears;
#endif
#ifndef TESS_NO_CAPS
    struct {
        int found;            /* 1: its ball has a cap */
        ball_filter filter;   /* the filter of the ball that holds the cap */
    } caps;
#endif
#ifndef TESS_NO_LIMBS
    struct {
        hh_ball ball;         /* the ball by limbs, if by_limbs is 1 */
        tess_int outside_ball; /* a point not in the ball by limbs, or NONE */
        tess_int behind_facet; /* a point not on the open side, or NONE */
        hh_sphere near_sphere; /* a sphere near the points that are compared */
        long hard_count;      /* hard comparisons: see LIMB_BALL_AFTER */
    } limbs;
#endif
#ifndef TESS_NO_SURFACES
    struct {
        int number;           /* that of the facet's surface, or NONE */
        ball_filter filter;   /* the filter with heights */
        double height_err;    /* a bound on the error of the base's height */
        double tilt[3];       /* height(w) - base_height - tilt.w is 0 at the
                               * facet's vertices */
        double tilt_err;      /* a bound on the error of tilt */
        double normal_height; /* of a plane: the height of the facet's normal */
        int undecided;        /* 1: the sample has undecided points; 0: only
                               * first points of visited leaves */
        tess_int offered;     /* how many points were offered to the sample */
        tess_int sample[SAMPLE_SIZE]; /* the points that it keeps */
    } surface;
#endif
} search;

/* All that the routines share: the points, the mesh under construction, and
 * what only speeds up searches. */
typedef struct mesher {
    hh_set points;            /* the points, as predicates take them */
    double least_abs;         /* the least absolute value above 0 of a caller's
                               * coordinate */
    ws_lengths lengths;       /* for the points that were given */
    /* the arrays: see the head */
    tess_int *tet, *adj;
    tess_int *representative, *order, *first_tet, *alive;
    tess_int *owned, *edge_from, *pool;
    tess_int *mark;           /* position -> 0 or 1 + surface + SURFACES mark */
    double *x, *box;
    /* the mesh */
    tess_int np;              /* the number of distinct points */
    tess_int leaves;          /* the number of leaves, a power of two */
    tess_int maxtet;          /* how many tetrahedra there is room for */
    tess_int ntet;            /* the number of tetrahedra */
    tess_int pool_len;        /* the length of pool */
    tess_int slots;           /* the number of slots of the pool's table */
    tess_int nfacets;         /* the number of facets in the table */
    tess_int unfiled;         /* from this tetrahedron on, facets 0 are not in
                               * the table yet */
    tess_int oldest_edge;     /* the first edge of the link, the highest */
    tess_int newest_edge;     /* the last edge of the link, the lowest */
    tess_int lowest_owner;    /* no vertex of a smaller position owns facets */
    tess_int next_new;        /* of a part: no wanted vertex of a smaller
                               * position is NEW; of a whole mesh np, as it
                               * meets all */
    /* what part II keeps */
#ifndef TESS_NO_LISTS
    struct {
        candidate_list block; /* the block list of the current leaf */
        candidate_list star;  /* the star list */
        int block_misses;     /* how many searches in a row have ended in the
                               * tree, of this block */
        int block_ties;       /* how many searches that ended in a block list
                               * met ties, with none in between that ended in a
                               * star list */
        int star_tied;        /* 1: the last search of a star list that offered
                               * points met some exactly on its last ball */
    } lists;
#endif
#ifndef TESS_NO_NEAR_LISTS
    struct {
        candidate_list list[NEAR_LISTS]; /* the near lists */
        int recency[NEAR_LISTS]; /* their places, the last one used first */
        double next_skin;     /* the skin_factor of the next near list */
        double budget;        /* the budget of near lists, in nodes */
        double tree_cost;     /* the mean number of nodes of a tree search */
        int paused;           /* 1: the budget is used up, and being refilled */
    } nears;
#endif
#ifndef TESS_NO_HULL_PLANES
    struct {
        tess_int plane[HULL_PLANES][3]; /* a facet in each plane that is kept */
        int kept;             /* the number of planes that are kept */
        int served;           /* how many of them have served: the first */
        int vain_looks;       /* how many facets in a row were in none; at most
                               * VAIN_LOOKS_MAX */
    } hull;
#endif
#ifndef TESS_NO_SETS
    struct {
        cospherical_set set[SETS]; /* the last cospherical sets of this star */
        int recorded;         /* how many were recorded in this star */
    } sets;
#endif
#ifndef TESS_NO_CYLINDERS
    struct {
        int made;             /* 1: there are cylinders */
    } cylinders;
#endif
#ifndef TESS_NO_CAPS
    struct {
        double plane[CAPS][4]; /* the last supporting planes: the unit normal,
                               * and its greatest product with a point */
        int planes;           /* how many planes were made */
        double big_ball;      /* a ball with a greater |c|_1 may have a cap */
        double long_nodes;    /* the nodes of long searches since the last plane
                               * was made, over leaves */
        double enough;        /* when they are so many, a plane is made */
    } caps;
#endif
#ifndef TESS_NO_LIMBS
    struct {
        int last_tied;        /* 1: the last exact comparison was a tie */
        double clump_width;   /* a narrower box is a clump; 0: there are none */
    } limbs;
#endif
#ifndef TESS_NO_SURFACES
    struct {
        ref_surface surface[SURFACES]; /* the reference surfaces */
        int known;            /* how many surfaces there are */
        double load;          /* how many points long searches have offered to
                               * samples, over np */
        double limit;         /* a load above this seeks a surface; 0: no more
                               * surfaces are sought */
    } surfaces;
#endif
} mesher;

/* ---- hooks: where part I asks part II ----
 *
 * No other routine is declared before it is defined.  A hook may always do
 * nothing, and where its chapter is left out its macro does just that: searches
 * take longer then, and find the same.  (A macro without a declaration stands
 * for a routine that part III alone calls; one that adds 0, or casts to void,
 * spares its callers a warning.)  A hook changes what its chapter keeps, and of
 * a search only what is said here.  What it excludes must hold no better point;
 * what it offers goes through offer_point.  A stage offers points, or sets best
 * to the apex; it returns 1 only if all that pass the filter have been offered,
 * if there is no candidate, or if best is the apex; 0: the search goes on. */

/* start_stages: what the chapters begin with.  drop_stages: forgets what would
 * be wrong once completed points are uncompleted again */
#ifndef TESS_CORE
static void start_stages(mesher *m);
static void drop_stages(mesher *m);
#else
#define start_stages(m) ((void)0)
#define drop_stages(m) ((void)0)
#endif

#ifndef TESS_NO_LISTS
/* before the star of s: makes its lists, and drops the sets of the last star */
static void make_lists(mesher *m, tess_int s);
/* the star of s is complete: s leaves the lists */
static void leave_lists(mesher *m, tess_int s);
/* two stages */
static int search_star_list(mesher *m, search *s);
static int search_block_list(mesher *m, search *s);
#else
#define make_lists(m, s) ((void)0)
#define leave_lists(m, s) ((void)0)
#define search_star_list(m, s) 0
#define search_block_list(m, s) 0
#endif

/* COLLECTS: the search makes a list, of points on either side of the facet, and
 * offers none */
#ifndef TESS_NO_NEAR_LISTS
#define COLLECTS(s) ((s)->nears.collect != NULL)
#define BEGIN_NEAR(s) ((s)->nears.collect = NULL)
/* adds to that list the uncompleted ones of n points of a leaf, from position
 * first on, whose power is at most most, the filter's bound */
static void collect_leaf(const mesher *m, search *s, tess_int first, int n,
                         const double *power, double most);
/* a stage */
static int search_near_lists(mesher *m, search *s);
/* after a search of the tree */
static void refill_budget(mesher *m, const search *s);
#else
#define COLLECTS(s) 0
#define BEGIN_NEAR(s) ((void)0)
#define collect_leaf(m, s, first, n, power, most) ((void)0)
#define search_near_lists(m, s) 0
#define refill_budget(m, s) ((void)0)
#define ball_is_empty(m, u) UNSURE
#endif

#ifndef TESS_NO_HULL_PLANES
/* a stage */
static int on_hull_plane(mesher *m, const search *s);
/* after a search that no list has ended */
static void note_hull_plane(mesher *m, const search *s);
#else
#define on_hull_plane(m, s) 0
#define note_hull_plane(m, s) ((void)0)
#endif

#ifndef TESS_NO_SETS
#define HAS_SETS(m) ((m)->sets.recorded > 0)
/* the apex of the facet v, or NONE: it is not known */
static tess_int apex_from_set(const mesher *m, const tess_int *v);
/* of a list that holds the ball, for lists: 1 if its ties are recorded */
static int record_set(mesher *m, search *s);
#else
#define HAS_SETS(m) 0
#define apex_from_set(m, v) NONE
#define record_set(m, s) 0
#endif

#ifndef TESS_NO_CYLINDERS
#define HAS_CYLINDERS(m) ((m)->cylinders.made)
#define SET_CYLINDERS(m, on) ((m)->cylinders.made = (on))
#define CYLINDER_LEN 32 /* the length of those of four nodes, in doubles */
/* once the tree is built */
static void make_cylinders(mesher *m);
/* pushes those of a node's four grandchildren, other than from, that it does
 * not exclude; returns the stack's new depth */
static int push_fours(const mesher *m, const search *s, tess_int node,
                      tess_int from, tess_int *stack, int depth);
#else
#define HAS_CYLINDERS(m) 0
#define SET_CYLINDERS(m, on) ((void)0)
#define CYLINDER_LEN 0
#define make_cylinders(m) ((void)0)
#define push_fours(m, s, node, from, stack, depth) ((depth) + 0)
#endif

/* HAS_CAP: the ball of a search has a cap; MAY_HAVE_CAP: it is large enough,
 * and there are supporting planes; OUTSIDE_CAP: the box b is excluded by
 * the cap, whatever the ball says */
#ifndef TESS_NO_CAPS
#define HAS_CAP(s) ((s)->caps.found)
#define MAY_HAVE_CAP(m, s) ((s)->filter.c1 > (m)->caps.big_ball)
#define OUTSIDE_CAP(s, b) \
    (HAS_CAP(s) && excludes_box(s, &(s)->caps.filter, b, (b) + 3, 0.0))
#define BEGIN_CAP(s) ((s)->caps.found = 0)
/* once the ball has changed: the cap, if any */
static void choose_cap(const mesher *m, search *s);
/* after a search that no list has ended; may choose another cap */
static void seek_plane(mesher *m, search *s);
#else
#define HAS_CAP(s) 0
#define MAY_HAVE_CAP(m, s) 0
#define OUTSIDE_CAP(s, b) 0
#define BEGIN_CAP(s) ((void)0)
#define choose_cap(m, s) ((void)0)
#define seek_plane(m, s) ((void)0)
#endif

#ifndef TESS_NO_LIMBS
#define HAS_CLUMPS(m) ((m)->limbs.clump_width > 0.0)
#define BEGIN_LIMBS(s)                                              \
    ((s)->limbs.near_sphere.ready = 0, (s)->limbs.hard_count = 0,   \
     (s)->limbs.outside_ball = (s)->limbs.behind_facet = NONE)
/* once the tree is built: finds whether there are clumps */
static void measure_clumps(mesher *m);
/* 1 if the box b is excluded */
static int excludes_clump(const mesher *m, const search *s, const double *b);
/* whether points so far apart are in different clumps */
#define CLUMPS_APART(m, width) \
    (HAS_CLUMPS(m) && (width) > (m)->limbs.clump_width)
/* decides what it can of what is UNSURE, *side or *verdict, hi being the upper
 * limit of z; 1: z is not better */
static int decide_by_limbs(const mesher *m, search *s, tess_int z, double hi,
                           int *side, int *verdict);
/* tells how a comparison ended: hard is 1 if limbs decided the verdict, 2 if it
 * took the exact signs */
static void note_comparison(mesher *m, search *s, tess_int z, int side,
                            int verdict, int hard);
/* may find a better ball: filter, by_limbs, lo and hi; side: that of a new best
 * point, else UNSURE */
static void refine_ball(mesher *m, search *s, int side);
#else
#define HAS_CLUMPS(m) 0
#define BEGIN_LIMBS(s) ((void)0)
#define measure_clumps(m) ((void)0)
#define excludes_clump(m, s, b) 0
#define CLUMPS_APART(m, width) 0
#define decide_by_limbs(m, s, z, hi, side, verdict) ((void)(hi), 0)
#define note_comparison(m, s, z, side, verdict, hard) ((void)(hard))
#define refine_ball(m, s, side) ((void)0)
#endif

/* HAS_SURFACE: the facet of a search has one; HAS_SPHERE: that is a sphere;
 * ANY_SURFACE: there are any; KNOWN_SURFACES: how many; SEEKS_SURFACES: more
 * are sought; MARKS_LENGTH, RECORDS_LENGTH: what their marks take of iw, and
 * what of that the records */
#ifndef TESS_NO_SURFACES
#define HAS_SURFACE(s) ((s)->surface.number != NONE)
#define HAS_SPHERE(m, s) \
    (HAS_SURFACE(s) && !(m)->surfaces.surface[(s)->surface.number].limbs.plane)
#define ANY_SURFACE(m) ((m)->surfaces.known > 0)
#define KNOWN_SURFACES(m) ((m)->surfaces.known)
#define SEEKS_SURFACES(m) ((m)->surfaces.limit > 0.0)
#define BEGIN_SURFACE(s) ((s)->surface.number = NONE, (s)->surface.offered = 0)
#define RECORDS_LENGTH (SURFACES * (RECORD - 1))
#define MARKS_LENGTH(n) ((n) + 2 * SURFACES * leaf_count(n) + RECORDS_LENGTH)
/* once a search has its set-up: the facet's surface, if any; a sphere gives
 * HH_CENTRE, HH_DC and HH_RHO of hh another centre */
static void choose_surface(const mesher *m, search *s);
/* narrows lo, hi, the limits of z, by its height; returns its side */
static int sharpen_by_height(const mesher *m, const search *s, tess_int z,
                             int side, double *lo, double *hi);
/* once the ball has changed */
static void set_surface_filter(const mesher *m, search *s);
/* the filter for z, and in *raise what its height adds to the power */
static const ball_filter *filter_of_mark(const mesher *m, const search *s,
                                         tess_int z, double *raise);
/* 1 if a node is excluded, 0 if it is not, UNSURE: ask its box */
static int excludes_by_marks(const mesher *m, const search *s, tess_int node);
/* 1 if the ball is the facet's sphere up to rounding */
static int ball_on_surface(const mesher *m, const search *s);
/* tells of an undecided point z, if open is 1, or of the first of a leaf */
static void add_to_sample(search *s, tess_int z, int open);
/* after a search that no list has ended */
static void seek_surface(mesher *m, search *s);
/* the length of the marks before owned, in iw of length liw */
static tess_int room_for_marks(mesher *m, tess_int liw);
#else
#define HAS_SURFACE(s) 0
#define HAS_SPHERE(m, s) 0
#define ANY_SURFACE(m) 0
#define KNOWN_SURFACES(m) 0
#define SEEKS_SURFACES(m) 0
#define BEGIN_SURFACE(s) ((void)0)
#define SURFACES 0
#define RECORDS_LENGTH 0
#define MARKS_LENGTH(n) 0
#define choose_surface(m, s) ((void)0)
#define sharpen_by_height(m, s, z, side, lo, hi) ((side) + 0)
#define set_surface_filter(m, s) ((void)(m))
#define filter_of_mark(m, s, z, raise) (&(s)->filter)
#define excludes_by_marks(m, s, node) UNSURE
#define ball_on_surface(m, s) 0
#define add_to_sample(s, z, open) ((void)0)
#define seek_surface(m, s) ((void)0)
#define room_for_marks(m, liw) 0
#define survey_regions(m, n, iw, liw) ((void)0)
#define surfaces_of_index(m) ((void)0)
#endif

/* of part III: begins the star of s, which is NEW, of a part */
static void seed_star(mesher *m, tess_int s);

/* Builds that count events or prove decisions, for the tests. */
#if defined(TESS_COUNT) || defined(TESS_PROVE)
#include "test/lib/watch.h"
#else
#define COUNT(which, n)
#define PEAK(which, n)
#define HOLDS(fact)
#endif

/* ---- the tree, and its sort ----
 *
 * The points are sorted so that those of a node have successive positions; the
 * tree is the numbers np and leaves, a box for each node, and how much of it is
 * alive. */

/* larger - returns the larger one of two numbers. */
static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* lesser - returns the lesser one of two numbers. */
static double lesser(double a, double b)
{
    return a < b ? a : b;
}

/* leaf_start - returns the first position of leaf j, which ends before
 * leaf_start(j + 1). */
static tess_int leaf_start(const mesher *m, tess_int j)
{
    tess_int more = m->np % m->leaves;

    return (tess_int)(j * (m->np / m->leaves) + (j < more ? j : more));
}

/* leaf_of - returns the leaf that holds position i. */
static tess_int leaf_of(const mesher *m, tess_int i)
{
    tess_int size = m->np / m->leaves, more = m->np % m->leaves;

    if (i < more * (size + 1)) return (tess_int)(i / (size + 1));
    return (tess_int)(more + (i - more * (size + 1)) / size);
}

/* node_range - finds the positions first ... last-1 below a node of the tree.
 */
static void node_range(const mesher *m, tess_int node, tess_int *first,
                       tess_int *last)
{
    tess_int left = node, right = node;

    while (left < m->leaves) {
        left = 2 * left;
        right = (tess_int)(2 * right + 1);
    }
    *first = leaf_start(m, left - m->leaves);
    *last = leaf_start(m, (tess_int)(right - m->leaves + 1));
}

/* next_node - returns the node that comes behind all below a node when the tree
 * is walked from left to right, each node before its children; 0 behind the
 * last. */
static tess_int next_node(tess_int node)
{
    while (node % 2 == 1) node /= 2;
    return node > 0 ? (tess_int)(node + 1) : 0;
}

/* A node is cut across the widest extent of about so many of its points; with
 * all of them a million points take 3 % longer. */
#define EXTENT_SAMPLE 64

/* axis_before - returns 1 if point i precedes, along an axis, the point with
 * coordinates q and the given number.  Ties are broken by the next axes, then
 * by number. */
static int axis_before(const mesher *m, tess_int i, int axis, const double *q,
                       tess_int number)
{
    const double *p = m->x + 3 * i;
    int k;

    for (k = 0; k < 3; k++, axis = axis == 2 ? 0 : axis + 1)
        if (p[axis] != q[axis]) return p[axis] < q[axis];
    return m->order[i] < number;
}

/* swap - swaps the points at the positions i and j. */
static void swap(mesher *m, tess_int i, tess_int j)
{
    double *p = m->x + 3 * i, *q = m->x + 3 * j, t;
    tess_int o = m->order[i];

    m->order[i] = m->order[j];
    m->order[j] = o;
    t = p[0], p[0] = q[0], q[0] = t;
    t = p[1], p[1] = q[1], q[1] = t;
    t = p[2], p[2] = q[2], q[2] = t;
}

/* pivot - returns the position of a point whose rank along an axis is near mid,
 * among lo ... hi-1: the point of that rank in a random sample.  The random
 * numbers are the same everywhere. */
static tess_int pivot(const mesher *m, tess_int lo, tess_int hi, tess_int mid,
                      int axis, long *chance)
{
    tess_int a[33], step = (tess_int)((hi - lo) / 1024), t;
    int n = hi - lo > 4000 ? 33 : hi - lo > 200 ? 9 : 3, i, j;

    a[0] = lo;
    for (i = 0; i < n; i++) {
        *chance = *chance * 137 % 30269 + 1;
        t = (tess_int)(step > 0 ? lo + step * (*chance % 1024) + *chance % step
                                : lo + *chance % (hi - lo));
        for (j = i; j > 0 && axis_before(m, t, axis, m->x + 3 * a[j - 1],
                                         m->order[a[j - 1]]);
             j--)
            a[j] = a[j - 1];
        a[j] = t;
    }
    return a[(mid - lo) / ((hi - lo) / n + 1)];
}

/* select_rank - reorders the points lo ... hi-1 so that those before mid
 * precede the one at mid along an axis, and the others do not: quickselect,
 * with one pass a pivot. */
static void select_rank(mesher *m, tess_int lo, tess_int hi, tess_int mid,
                        int axis)
{
    tess_int i, j, number;
    double q[3];
    long chance = 1;
    int less;

    while (lo <= mid && hi - lo > 1) {
        i = pivot(m, lo, hi, mid, axis, &chance);
        for (j = 0; j < 3; j++) q[j] = m->x[3 * i + j];
        number = m->order[i];
        /* no branch on the points except for ties: half of them would be
         * mispredicted, which takes longer than a swap */
        for (i = j = lo; j < hi; j++) {
            less = m->x[3 * j + axis] < q[axis];
            if (m->x[3 * j + axis] == q[axis])
                less = axis_before(m, j, axis, q, number);
            swap(m, i, j);
            i = (tess_int)(i + less);
        }
        /* lo ... i-1 precede the pivot, i ... hi-1 do not */
        if (mid < i)
            hi = i;
        else if (i > lo)
            lo = i;
        else {
            /* the pivot precedes all others: move it to the front */
            for (j = lo; m->order[j] != number; j++)
                ;
            swap(m, lo, j);
            lo++;
        }
    }
}

/* link_duplicate - records in representative that the points at i and j
 * coincide, if they do. */
static void link_duplicate(mesher *m, tess_int i, tess_int j)
{
    const double *p = m->x + 3 * i, *q = m->x + 3 * j;
    tess_int a, b;

    if (p[0] != q[0] || p[1] != q[1] || p[2] != q[2]) return;
    a = m->order[i];
    b = m->order[j];
    m->representative[a > b ? a : b] = a > b ? b : a;
}

/* bounding_box - sets b to the box of every step-th of n points, the first at
 * x. */
static void bounding_box(const double *x, tess_int n, tess_int step, double *b)
{
    tess_int i;
    int k;

    for (k = 0; k < 3; k++) b[k] = b[3 + k] = x[k];
    for (i = step, x += 3 * step; i < n; i += step, x += 3 * step)
        for (k = 0; k < 3; k++) {
            if (x[k] < b[k]) b[k] = x[k];
            if (x[k] > b[3 + k]) b[3 + k] = x[k];
        }
}

/* bisect - cuts the points lo ... hi-1 at mid, across the widest extent of a
 * sample of them.  Duplicates that the cut separates all coincide with the
 * point at mid; in the end every duplicate but the least of its set is linked
 * to a smaller number. */
static void bisect(mesher *m, tess_int lo, tess_int hi, tess_int mid)
{
    double b[6] = {0.0}; /* for gcc -fanalyzer */
    tess_int i;
    int k, axis = 0;

    bounding_box(m->x + 3 * lo, hi - lo,
                 (tess_int)((hi - lo) / EXTENT_SAMPLE + 1), b);
    for (k = 1; k < 3; k++)
        if (hh_wider(b[3 + k], b[k], b[3 + axis], b[axis]) > 0) axis = k;
    select_rank(m, lo, hi, mid, axis);
    for (i = lo; i < mid; i++) link_duplicate(m, i, mid);
}

/* leaf_sort - sorts the points of a leaf into groups of LEAF_GROUP. */
static void leaf_sort(mesher *m, tess_int first, tess_int last)
{
    tess_int half, lo, hi, i, j;

    half =
        (tess_int)(first + ((last - first + LEAF_GROUP - 1) / LEAF_GROUP + 1) /
                               2 * LEAF_GROUP);
    if (half < last) bisect(m, first, last, half);
    for (lo = first; lo < last; lo += LEAF_GROUP) {
        hi = lo < half && half < last ? half : last;
        if (lo + LEAF_GROUP < hi) bisect(m, lo, hi, lo + LEAF_GROUP);
        if (lo + LEAF_GROUP < hi) hi = (tess_int)(lo + LEAF_GROUP);
        for (i = lo + 1; i < hi; i++)
            for (j = i; j > lo && axis_before(m, j, 0, m->x + 3 * (j - 1),
                                              m->order[j - 1]);
                 j--)
                swap(m, j - 1, j);
        for (i = lo + 1; i < hi; i++) link_duplicate(m, i - 1, i);
    }
}

/* kd_sort - sorts the points into a k-d tree: cuts every node in two across its
 * widest extent, down to the leaves.  (Bentley; Friedman, Bentley and Finkel:
 * see the head.) */
static void kd_sort(mesher *m)
{
    tess_int node = 1, first, mid, last;

    while (node > 0) {
        node_range(m, node, &first, &last);
        if (node < m->leaves) {
            node_range(m, 2 * node, &first, &mid);
            bisect(m, first, last, mid);
            node = 2 * node;
        } else {
            leaf_sort(m, first, last);
            node = next_node(node);
        }
    }
}

/* make_boxes - computes the box of every node, from the leaves up. */
static void make_boxes(mesher *m)
{
    tess_int node, first, last;
    double *b;

    for (node = (tess_int)(2 * m->leaves - 1); node > 0; node--) {
        b = m->box + 6 * node;
        node_range(m, node, &first, &last);
        if (node < m->leaves)
            bounding_box(b + 6 * node, 4, 1, b); /* the children's corners */
        else
            bounding_box(m->x + 3 * first, last - first, 1, b);
    }
}

/* leaf_count - returns the number of leaves for n points: a power of two. */
static tess_int leaf_count(tess_int n)
{
    tess_int leaves = 1;

    while (leaves < n / LEAF_POINTS + (n % LEAF_POINTS > 0)) leaves *= 2;
    return leaves;
}

/* distinct_points - copies the points that represent themselves, in their
 * order. */
static void distinct_points(mesher *m, tess_int n, const tess_real *p)
{
    tess_int i;
    int k;

    m->np = 0;
    for (i = 0; i < n; i++)
        if (m->representative[i] == i) {
            for (k = 0; k < 3; k++) m->x[3 * m->np + k] = (double)p[3 * i + k];
            m->order[m->np++] = i;
        }
    m->leaves = leaf_count(m->np);
}

/* revive_all - puts all points back into the tree. */
static void revive_all(mesher *m)
{
    tess_int i;

    for (i = 1; i < m->leaves; i++) m->alive[i] = 2;
    for (i = 0; i < m->leaves; i++)
        m->alive[m->leaves + i] =
            (tess_int)(leaf_start(m, (tess_int)(i + 1)) - leaf_start(m, i));
}

/* ---- scaling ----
 *
 * Searches compute with coordinates of absolute value at most 1; exact signs
 * are those of the caller's. */

/* common_unit - returns the least power of two u for which all scaled
 * coordinates are multiples of 1/u, or 0 if it exceeds 2^29. */
static double common_unit(const mesher *m)
{
    tess_int i, n = 3 * m->np;
    double u = 1.0;

    for (i = 0; i < n; i++)
        while (m->x[i] * u != (double)(long)(m->x[i] * u)) {
            if (u > 5e8) return 0.0;
            u *= 2.0;
        }
    return u;
}

/* limbs_hold_all - returns 1 if HH_LIMBS limbs hold all coordinates of n points
 * p; only those below few are in doubt. */
static int limbs_hold_all(tess_int n, const tess_real *p)
{
    double most = 0.0, few = DBL_MIN, x;
    tess_int i;
    int e, down = (3 - HH_LIMBS) * HH_BITS + DBL_MANT_DIG;

    if (down > 0) down = 0; /* else all but the largest are in doubt */
    for (i = 0; i < 3 * n; i++) most = larger(most, fabs((double)p[i]));
    /* if that would underflow, only subnormals are in doubt */
    frexp(most, &e);
    if (e + down > DBL_MIN_EXP) few = ldexp(most, down);
    for (i = 0; i < 3 * n; i++) {
        x = fabs((double)p[i]);
        if (x > 0.0 && x < few && !hh_fits(x, most)) return 0;
    }
    return 1;
}

/* scale_points - scales the sorted coordinates to an absolute value of at most
 * 1 by a power of two, in two steps because one might overflow, and finds
 * whether they are small multiples of one unit.  They are not if one
 * underflows: its multiple is lost. */
static void scale_points(mesher *m)
{
    double most = 0.0, least = DBL_MAX, x, u = 0.0;
    tess_int i, n = 3 * m->np;
    int e;

    m->points.exact3 = m->points.exact5 = -1.0;
    for (i = 0; i < n; i++) {
        x = fabs(m->x[i]);
        most = larger(most, x);
        if (x > 0.0) least = lesser(least, x);
    }
    m->least_abs = least;
    frexp(most, &e);
    m->points.exponent = e;
    hh_multiply(n, m->x, ldexp(1.0, -(e / 2)));
    hh_multiply(n, m->x, ldexp(1.0, -(e - e / 2)));
    if (ldexp(least, -e) < HH_LENGTH_MIN) m->points.exact3 = -2.0;
    if (ldexp(least, -e) >= DBL_MIN) u = common_unit(m);
    /* nor if a product of five underflows: with 24 bits it may */
    if (u > 0.0 && 1.0 / u / u / u / u / u >= DBL_MIN) {
        /* up to 2^(DBL_MANT_DIG - 1) units of the determinant's degree */
        m->points.exact3 = ldexp(1.0, DBL_MANT_DIG - 1) / u / u / u;
        m->points.exact5 = m->points.exact3 / u / u;
    }
}

/* ---- the first facet (Section 2): of the hull, by gift wrapping ---- */

/* point - returns the caller's coordinates of position i. */
static const tess_real *point(const mesher *m, tess_int i)
{
    return m->points.p + 3 * m->order[i];
}

/* lex_before - returns 1 if point a comes strictly before point b: by x, then
 * by y, then by z. */
static int lex_before(const tess_real *a, const tess_real *b)
{
    int k = 0;

    while (k < 2 && a[k] == b[k]) k++;
    return a[k] < b[k];
}

/* hull_edge_before - returns 1 if point i comes before point j when a plane
 * parallel to the z axis is wrapped about a, the lexicographically least point,
 * and then a line in that plane.  The first point of all ends a hull edge that
 * contains no other point. */
static int hull_edge_before(const mesher *m, tess_int a, tess_int i, tess_int j)
{
    const tess_real *o = point(m, a), *p = point(m, i), *q = point(m, j);
    int side = hh_area(2, o, q, p);

    if (side == 0)
        side = p[0] > o[0] || q[0] > o[0] ? -hh_area(1, o, q, p)
                                          : hh_area(0, o, q, p);
    return side != 0 ? side < 0 : lex_before(p, q);
}

/* first_facet - finds the first facet v: on the hull, with all points on its
 * positive side, and v[0] of least position.  On a hull face of more than three
 * points it is the triangle on the edge v[0] v[1] of the face that the tie rule
 * selects: of two points a, b of the face, b is better iff it is inside the
 * ball of v0, v1, a and w, by that rule, for any w off the face.  Returns 0, or
 * the code of points without a tetrahedron. */
static int first_facet(const mesher *m, tess_int *v)
{
    const tess_real *p, *q;
    tess_int i, w = NONE;
    int side;

    if (m->np < 2) return TESS_POINT;
    v[0] = 0;
    for (i = 1; i < m->np; i++)
        if (lex_before(point(m, i), point(m, v[0]))) v[0] = i;
    v[1] = v[0] == 0 ? 1 : 0;
    for (i = 0; i < m->np; i++)
        if (i != v[0] && i != v[1] && hull_edge_before(m, v[0], i, v[1]))
            v[1] = i;
    p = point(m, v[0]);
    q = point(m, v[1]);
    for (v[2] = 0; v[2] < m->np && hh_collinear(p, q, point(m, v[2])); v[2]++)
        ;
    if (v[2] == m->np) return TESS_LINE;
    for (i = 0; i < m->np; i++) {
        side = hh_porient(&m->points, v[0], v[1], v[2], i);
        if (side != 0) w = i;
        if (side < 0) {
            w = v[2];
            v[2] = i;
        }
    }
    if (w == NONE) return TESS_PLANE;
    for (i = 0; i < m->np; i++)
        if (i != v[2] && hh_porient(&m->points, v[0], v[1], v[2], i) == 0 &&
            !hh_collinear(p, q, point(m, i)) &&
            hh_pinsphere(&m->points, v, w, i, 1) < 0)
            v[2] = i;
    while (v[0] > v[1] || v[0] > v[2]) {
        w = v[0];
        v[0] = v[1];
        v[1] = v[2];
        v[2] = w;
    }
    return 0;
}

/* ---- the pool of open facets: a hash table with open addressing ----
 *
 * An entry has ENTRY_LEN integers:
 *   ENTRY_CODE  the facet's code 4t+k, or NONE: the entry is unused
 *   ENTRY_NEXT  the next entry of the same owner, newest first, or NONE
 *   ENTRY_PREV  the previous one; -1 - owner in the first
 *   ENTRY_SIG   the hash of the three vertices
 * owned[owner] is the first entry of an owner.  A facet without an owner is in
 * no entry: it is left open.  Probing is linear, from the hash modulo slots;
 * when an entry is removed, later ones are moved back.
 *
 * LIFE OF AN OPEN FACET.  It is born in add_tetrahedron.
 *   - If it contains s, match_or_push makes it an edge of the link, or closes
 *     it with the opposite edge.
 *   - If it is opposite to s (k = 0), it is nowhere until flush_facets enters
 *     it into the pool's table under its owner, or closes it with the entry
 *     that is there.  When its owner's star begins, edges_from_pool makes it
 *     an edge.
 *   - Else an edge ends with the search for its apex: add_tetrahedron closes
 *     it, or it is TESS_NONE, a facet of the hull.
 *   - Without an owner it stays TESS_OPEN in the result.  So do all that are
 *     left when arrays or pool are full.
 * So it is in one place at a time.  erase_entry and rebuild_table move entries,
 * and update owned and the owners' lists only; move_edges moves edges, and
 * updates edge_from and the edges only: after make_room, callers must reload
 * oldest_edge.
 *
 *   the table is  by               with so many slots, at most its quota
 *   set up        build            what mark_wanted says, for uniform points
 *   doubled       make_room        2 slots + 1, when three quarters are in use
 *   cut           make_room        its quota, when it meets the edges
 *   cut           edges_from_pool  its quota without facets that become edges
 *   set up again  rebuild_state    as by build, or twice its facets
 *
 * room_for alone decides what room there is: at most 7/8 of the slots are used,
 * one at least is not, and the edges do not meet the table.  push_edge does not
 * resize the table; make_room ensures room for two edges.  If room still falls
 * short, the code is TESS_POOL. */

/* tet_facet - sets f to the vertices of facet k of the tetrahedron v, the one
 * opposite to v[k]: counter-clockwise from outside if v is positively oriented.
 */
static void tet_facet(const tess_int *v, int k, tess_int *f)
{
    static const int out[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

    f[0] = v[out[k][0]];
    f[1] = v[out[k][1]];
    f[2] = v[out[k][2]];
}

/* facet_of_code - sets v to the vertices of the facet of a code, positive
 * towards its outside. */
static void facet_of_code(const mesher *m, tess_int code, tess_int *v)
{
    tet_facet(m->tet + (code - code % 4), (int)(code % 4), v);
}

/* owner - returns the owner of the facet v: of its wanted vertices the one of
 * least position, or NONE. */
static tess_int owner(const mesher *m, const tess_int *v)
{
    tess_int least = m->np;
    int k;

    for (k = 0; k < 3; k++)
        if (v[k] < least && m->owned[v[k]] != UNWANTED) least = v[k];
    return least < m->np ? least : NONE;
}

/* facet_hash - returns the hash of a facet, below 2^31; the order of its
 * vertices does not matter. */
static tess_int facet_hash(const tess_int *v)
{
    long a = v[0] % 8192L, b = v[1] % 8192L, c = v[2] % 8192L;
    long h = (a + b + c) * 57571L + (a * b + b * c + c * a);

    return (tess_int)(sizeof(tess_int) < 4 ? h % 32749L : h);
}

/* same_facet - returns 1 if v and w, of equal hash, are the same facet. */
static int same_facet(const tess_int *v, const tess_int *w)
{
    int k, n = 0;

    for (k = 0; k < 3; k++)
        n += (v[k] == w[0]) + (v[k] == w[1]) + (v[k] == w[2]);
    return n == 3;
}

/* find_entry - returns the entry of the facet v, of hash sig, or the unused
 * entry where it belongs. */
static tess_int find_entry(const mesher *m, const tess_int *v, tess_int sig)
{
    tess_int e = sig % m->slots, w[3];
    const tess_int *p;

    for (;;) {
        COUNT(N_PROBE, 1);
        p = m->pool + ENTRY_LEN * e;
        if (p[ENTRY_CODE] == NONE) return e;
        if (p[ENTRY_SIG] == sig) {
            facet_of_code(m, p[ENTRY_CODE], w);
            if (same_facet(v, w)) return e;
        }
        if (++e == m->slots) e = 0;
    }
}

/* relink_entry - makes next follow what precedes p in the list of its owner,
 * and prev precede what follows p. */
static void relink_entry(mesher *m, const tess_int *p, tess_int next,
                         tess_int prev)
{
    if (p[ENTRY_NEXT] != NONE)
        m->pool[ENTRY_LEN * p[ENTRY_NEXT] + ENTRY_PREV] = prev;
    if (p[ENTRY_PREV] >= 0)
        m->pool[ENTRY_LEN * p[ENTRY_PREV] + ENTRY_NEXT] = next;
    else
        m->owned[-1 - p[ENTRY_PREV]] = next;
}

/* erase_entry - removes entry e, and moves back the entries behind it that may
 * fill the hole. */
static void erase_entry(mesher *m, tess_int e)
{
    tess_int *p = m->pool + ENTRY_LEN * e, *q;
    tess_int hole = e, home;
    int k;

    relink_entry(m, p, p[ENTRY_NEXT], p[ENTRY_PREV]);
    m->nfacets--;
    for (;;) {
        if (++e == m->slots) e = 0;
        q = m->pool + ENTRY_LEN * e;
        if (q[ENTRY_CODE] == NONE) break;
        home = q[ENTRY_SIG] % m->slots;
        /* e may fill the hole if its home is not behind the hole */
        if (hole <= e ? home <= hole || home > e : home <= hole && home > e) {
            p = m->pool + ENTRY_LEN * hole;
            for (k = 0; k < ENTRY_LEN; k++) p[k] = q[k];
            relink_entry(m, p, hole, hole);
            hole = e;
        }
    }
    m->pool[ENTRY_LEN * hole + ENTRY_CODE] = NONE;
}

/* match_or_enter - enters the open facet of a code into the table and returns
 * NONE; or, if its other side is there, removes that and returns its code. */
static tess_int match_or_enter(mesher *m, tess_int code)
{
    tess_int v[3], e, sig, least, other, *p;

    facet_of_code(m, code, v);
    least = owner(m, v);
    if (least == NONE) return NONE;
    sig = facet_hash(v);
    e = find_entry(m, v, sig);
    p = m->pool + ENTRY_LEN * e;
    other = p[ENTRY_CODE];
    if (other != NONE) {
        erase_entry(m, e);
        return other;
    }
    p[ENTRY_CODE] = code;
    p[ENTRY_NEXT] = m->owned[least];
    p[ENTRY_PREV] = (tess_int)(-1 - least);
    p[ENTRY_SIG] = sig;
    relink_entry(m, p, e, e);
    m->nfacets++;
    PEAK(N_POOL, m->nfacets);
    if (least < m->lowest_owner) m->lowest_owner = least;
    return NONE;
}

/* room_for - returns 1 if the pool has room for so many more facets, the table
 * keeping an eighth of its slots unused and one at least, and for so many more
 * edges.  At all times it has room for the facets that flush_facets will enter:
 * so find_entry and erase_entry, which end at an unused entry, meet one. */
static int room_for(const mesher *m, tess_int facets, tess_int edges)
{
    return m->nfacets + facets < m->slots - m->slots / 8 &&
           ENTRY_LEN * m->slots + EDGE_LEN * edges <= m->newest_edge;
}

/* cube_root - returns the least c with c^3 >= n. */
static tess_int cube_root(tess_int n)
{
    tess_int c = 1;

    while ((double)c * (double)c * (double)c < (double)n) c++;
    return c;
}

/* table_quota - returns how many slots the table may have with room for so many
 * more edges: what its facets need with an eighth unused, and half of the
 * remaining free space. */
static tess_int table_quota(const mesher *m, tess_int edges)
{
    tess_int most = (tess_int)((m->newest_edge - EDGE_LEN * edges) / ENTRY_LEN);
    tess_int need = (tess_int)(m->nfacets + m->nfacets / 7 + 4);

    return most < need ? most : (tess_int)(need + (most - need) / 2);
}

/* rebuild_table - gives the table the wanted number of slots, or its quota if
 * that is less, and enters its facets again in their order.  Returns 0 if there
 * is no room.  The new table is laid over the old one, so the facets come from
 * tet and adj: the open ones without the vertex s.  (Those with it are edges of
 * the link.) */
static int rebuild_table(mesher *m, tess_int s, tess_int wanted)
{
    tess_int i, v[3], most = table_quota(m, 2);

    m->slots = wanted < most ? wanted : most;
    m->nfacets = 0;
    for (i = 0; i < m->slots; i++) m->pool[ENTRY_LEN * i + ENTRY_CODE] = NONE;
    for (i = 0; i < m->np; i++)
        if (m->owned[i] != UNWANTED) m->owned[i] = NONE;
    for (i = 0; i < 4 * m->unfiled; i++) {
        if (m->adj[i] != TESS_OPEN || !room_for(m, 0, 0)) continue;
        facet_of_code(m, i, v);
        if (v[0] == s || v[1] == s || v[2] == s) continue;
        (void)match_or_enter(m, i);
    }
    return room_for(m, 0, 0);
}

/* set_adjacent - makes the tetrahedra of two codes neighbours across these
 * facets. */
static void set_adjacent(mesher *m, tess_int code, tess_int other)
{
    m->adj[code] = other / 4;
    m->adj[other] = code / 4;
}

/* flush_facets - enters the facets opposite to s of the tetrahedra from unfiled
 * on into the table, or closes those whose other side is there.  They come in
 * batches so that the processor can overlap their memory accesses. */
static void flush_facets(mesher *m)
{
    tess_int code, other;

    for (; m->unfiled < m->ntet; m->unfiled++) {
        code = 4 * m->unfiled;
        other = match_or_enter(m, code);
        if (other != NONE) set_adjacent(m, code, other);
    }
}

/* ---- the link of a star ----
 *
 * The open facets at s are the edges a -> b of its link: (s, a, b) is positive
 * towards the unknown side.  They are a queue, which keeps the link's boundary
 * short, and grow down from the end of the pool: edge e is pool[e] and the
 * EDGE_LEN - 1 integers behind it. */

/* clear_link - empties the link. */
static void clear_link(mesher *m)
{
    m->newest_edge = m->pool_len;
    m->oldest_edge = m->pool_len - EDGE_LEN;
}

/* move_edges - moves the edges up to the end of the pool.  Pointers of edges in
 * the link lead to others in it, as connect_edges sets them in pairs and
 * whoever removes an edge connects its neighbours anew.  Those of dead edges
 * are never followed again and stay as they are: shifted with the edge they
 * could exceed the largest tess_int. */
static void move_edges(mesher *m)
{
    tess_int shift = (tess_int)(m->pool_len - EDGE_LEN - m->oldest_edge), e, *p,
             *q;
    int k, dead;

    for (e = m->oldest_edge; e >= m->newest_edge; e -= EDGE_LEN) {
        p = m->pool + e;
        q = p + shift;
        dead = p[EDGE_CODE] == DEAD_EDGE;
        if (!dead && m->edge_from[p[EDGE_FROM]] == e)
            m->edge_from[p[EDGE_FROM]] += shift;
        for (k = 0; k < EDGE_LEN; k++)
            q[k] =
                k >= EDGE_PREV && p[k] != NONE && !dead ? p[k] + shift : p[k];
    }
    m->newest_edge += shift;
    m->oldest_edge += shift;
}

/* push_edge - adds an edge a -> b, for which there is room, and connects it to
 * no other.  Returns the edge. */
static tess_int push_edge(mesher *m, tess_int code, tess_int a, tess_int b)
{
    tess_int e = m->newest_edge - EDGE_LEN, *p = m->pool + e;

    HOLDS(room_for(m, 0, 1));
    p[EDGE_CODE] = code;
    p[EDGE_FROM] = a;
    p[EDGE_TO] = b;
    p[EDGE_PREV] = p[EDGE_NEXT] = NONE;
    p[EDGE_CHAIN] = m->edge_from[a] >= 0 ? m->edge_from[a] : NONE;
    m->edge_from[a] = m->newest_edge = e;
    return e;
}

/* connect_edges - makes edge b the next of edge a; either may be NONE. */
static void connect_edges(mesher *m, tess_int a, tess_int b)
{
    if (a != NONE) m->pool[a + EDGE_NEXT] = b;
    if (b != NONE) m->pool[b + EDGE_PREV] = a;
}

/* remove_edge - removes edge e from the link. */
static void remove_edge(mesher *m, tess_int e)
{
    tess_int *p = m->pool + e, *at = m->edge_from + p[EDGE_FROM];

    while (*at != e) at = m->pool + *at + EDGE_CHAIN;
    *at = p[EDGE_CHAIN];
    p[EDGE_CODE] = DEAD_EDGE;
}

/* edge_between - returns the edge a -> b of the link, or NONE. */
static tess_int edge_between(const mesher *m, tess_int a, tess_int b)
{
    tess_int e = m->edge_from[a];

    while (e >= 0 && m->pool[e + EDGE_TO] != b) e = m->pool[e + EDGE_CHAIN];
    return e >= 0 ? e : NONE;
}

/* match_or_push - pushes the edge a -> b of the facet of a code into the link,
 * between the edges prev and after, either of which may be NONE; or, if the
 * edge of the other side is there, closes both and removes that.  Returns the
 * edge that now ends at b, or NONE. */
static tess_int match_or_push(mesher *m, tess_int code, tess_int a, tess_int b,
                              tess_int prev, tess_int after)
{
    tess_int f = edge_between(m, b, a), last;

    if (f == NONE) {
        m->adj[code] = TESS_OPEN;
        f = push_edge(m, code, a, b);
        connect_edges(m, prev, f);
        connect_edges(m, f, after);
        return f;
    }
    set_adjacent(m, code, m->pool[f + EDGE_CODE]);
    last = m->pool[f + EDGE_PREV];
    if (f != prev) connect_edges(m, prev, m->pool[f + EDGE_NEXT]);
    if (f != after) connect_edges(m, last, after);
    remove_edge(m, f);
    return last;
}

/* add_tetrahedron - stores the tetrahedron of s, the edge e = a -> b and the
 * apex c.  The edges a -> c and c -> b replace e in the link. */
static void add_tetrahedron(mesher *m, tess_int s, tess_int e, tess_int c)
{
    tess_int *p = m->pool + e, a = p[EDGE_FROM], b = p[EDGE_TO],
             prev = p[EDGE_PREV];
    tess_int after = p[EDGE_NEXT], code = p[EDGE_CODE], t = m->ntet++, *v, f;

    v = m->tet + 4 * t;
    v[0] = s;
    v[1] = a;
    v[2] = b;
    v[3] = c;
    if (code == SEED_EDGE) {
        f = edge_between(m, b, a);
        m->adj[4 * t + 3] = f == NONE ? TESS_NONE : TESS_OPEN;
        if (f != NONE) m->pool[f + EDGE_CODE] = (tess_int)(4 * t + 3);
    } else
        set_adjacent(m, code, (tess_int)(4 * t + 3));
    if (m->edge_from[c] == NEW) m->edge_from[c] = NONE;
    remove_edge(m, e);
    m->adj[4 * t] = TESS_OPEN; /* until flush_facets */
    prev = match_or_push(m, (tess_int)(4 * t + 2), a, c, prev, NONE);
    (void)match_or_push(m, (tess_int)(4 * t + 1), c, b, prev, after);
    HOLDS(linked(m));
}

/* facet_to_edge - makes the open facet of a code an edge of the link, if it has
 * the vertex s.  Returns 0 if there is no room. */
static int facet_to_edge(mesher *m, tess_int s, tess_int code)
{
    tess_int v[3];
    int k;

    facet_of_code(m, code, v);
    for (k = 0; v[k] != s; k++)
        if (k == 2) return 1;
    if (!room_for(m, 0, 1)) return 0;
    (void)push_edge(m, code, v[(k + 1) % 3], v[(k + 2) % 3]);
    return 1;
}

/* pair_edges - gives every edge of the link a next one: an edge that begins
 * where it ends and is no other edge's next, if there is one. */
static void pair_edges(mesher *m)
{
    tess_int e, f;

    for (e = m->oldest_edge; e >= m->newest_edge; e -= EDGE_LEN) {
        f = m->edge_from[m->pool[e + EDGE_TO]];
        if (f < 0 || m->pool[e + EDGE_CODE] == DEAD_EDGE) continue;
        while (f != NONE && m->pool[f + EDGE_PREV] != NONE)
            f = m->pool[f + EDGE_CHAIN];
        connect_edges(m, e, f);
    }
}

/* edges_from_adj - makes all open facets at s edges of the link, in the order
 * of their tetrahedra.  Returns 0 if there is no room. */
static int edges_from_adj(mesher *m, tess_int s)
{
    tess_int t;
    int k;

    for (t = 0; t < m->ntet; t++)
        for (k = 3; k >= 0; k--)
            if (m->adj[4 * t + k] == TESS_OPEN &&
                !facet_to_edge(m, s, (tess_int)(4 * t + k)))
                return 0;
    pair_edges(m);
    return 1;
}

/* edges_from_pool - moves the facets that s owns, one at least, from the table
 * to the link, oldest first.  Returns 0 if there is no room.  If they do not
 * fit beside the table, it rebuilds the table without them first. */
static int edges_from_pool(mesher *m, tess_int s)
{
    tess_int e = m->owned[s], edges = 1;

    for (; m->pool[ENTRY_LEN * e + ENTRY_NEXT] != NONE; edges++)
        e = m->pool[ENTRY_LEN * e + ENTRY_NEXT];
    if (!room_for(m, 0, edges)) {
        m->nfacets -= edges;
        return rebuild_table(m, s, table_quota(m, edges)) &&
               edges_from_adj(m, s);
    }
    for (; e >= 0; e = m->pool[ENTRY_LEN * e + ENTRY_PREV])
        (void)facet_to_edge(m, s, m->pool[ENTRY_LEN * e + ENTRY_CODE]);
    while (m->owned[s] != NONE) erase_entry(m, m->owned[s]);
    pair_edges(m);
    return 1;
}

/* make_room - makes room for another tetrahedron's facets in the table and in
 * the link of s.  Returns 0 if there is none.  Callers must reload oldest_edge.
 *
 *                   0      ENTRY_LEN slots  newest_edge   oldest_edge  pool_len
 *   before          | table       | free | edges       | dead edges |
 *   move_edges      | table       | free            | edges         |
 *   rebuild_table   | longer or shorter table | free | edges        |
 *
 * That is done when the table is three quarters full or meets the edges: these
 * move up if an eighth of their room is dead, and the table is resized if that
 * is not enough and changes it by a sixteenth, so both are rare. */
static int make_room(mesher *m, tess_int s)
{
    tess_int most, spare = m->slots / 8 + 1, change = m->slots / 16;

    if (room_for(m, (tess_int)(m->ntet - m->unfiled + spare), 2)) return 1;
    flush_facets(m);
    if (m->pool_len - m->oldest_edge > (m->pool_len - m->newest_edge) / 8)
        move_edges(m);
    most = table_quota(m, 2);
    if (most > 2 * m->slots + 1) most = (tess_int)(2 * m->slots + 1);
    if (!room_for(m, spare, 2) &&
        (most > m->slots + change || most < m->slots - change))
        (void)rebuild_table(m, s, most);
    return room_for(m, 1, 2);
}

/* ---- the search for the apex of a facet ----
 *
 * search_begin sets the facet up and compares the guesses; search_tree offers
 * what is left and may be in the ball.  A point, a box, a node: each is tested
 * against the filter, whose bound has room for all rounding, and what passes is
 * compared with the best point, by the bounds of hh_limits first
 * (compare_point), then exactly (compare_exactly).  A better point narrows the
 * ball (set_upper_bound). */

/* A facet whose E is at least this has its base opposite its longest edge.  E
 * is EPS (170 (1 + |cot|) + 90): the angle at v[0] is below 1.3 degrees. */
#define SMALL_ANGLE_E (8000.0 * EPS)
/* A facet with a greater E has its normal computed by limbs: trades limbs
 * against undecided sides. */
#define LIMB_NORMAL_E 1e-6
/* Length of a stack of nodes.  Correctness rests on it: it exceeds three halves
 * of the tree's depth, as a node's number fits in tess_int, and with cylinders
 * a search keeps three nodes for every second level. */
#define STACK_DEPTH (3 * CHAR_BIT * (int)sizeof(tess_int) / 2)
/* L_MAX: set_upper_bound gives no ball for an L-coordinate beyond it, and
 * nothing may overflow there.  UNDERFLOW_ERR: the effect of underflow on a
 * point's power, |w|^2 - 2 c.w, or on its side.  A coordinate that underflowed
 * when it was scaled is wrong by DBL_MIN, and so may be each product; |w| < 4,
 * and |c| is at most 2 L_MAX, as a circumradius is below 0.02/EPS by hh_setup,
 * and hh_thin's and hh_centre's are below L_MAX.  The surface filter is divided
 * by q (see set_surface_filter); where UNDERFLOW_ERR/q itself underflows, the
 * term 8 EPS size (size + 2 c1) is larger. */
#if DBL_MANT_DIG >= 53
#define L_MAX 1e100
#define UNDERFLOW_ERR 1e-200
#else
#define L_MAX 1e15
#define UNDERFLOW_ERR 1e-20
#endif

/* dot - returns the product of two vectors. */
static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* norm1 - returns |a|_1. */
static double norm1(const double *a)
{
    return fabs(a[0]) + fabs(a[1]) + fabs(a[2]);
}

/* minus - sets u to a - b. */
static void minus(const double *a, const double *b, double *u)
{
    int k;

    for (k = 0; k < 3; k++) u[k] = a[k] - b[k];
}

/* filter_bound - returns the right-hand side of a filter for |w|_1 <= size.  c
 * errs by at most dc.  Each term w[k] (w[k] - 2 c[k]) suffers at most 7
 * roundings, counting that of w[k] twice and those of a sum of four, each of at
 * most EPS |w[k]| (|w[k]| + 2 |c[k]|).  size and this bound may come out too
 * small by a few EPS. */
static double filter_bound(const ball_filter *b, double size)
{
    return size * (2.0 * b->dc + 8.0 * EPS * (size + 2.0 * b->c1)) +
           b->allowance;
}

/* set_half_space - makes the open side a filter: the ball of L = L_MAX / 2
 * along the normal.  Its dc has room for |w|^2, and is so large that all points
 * pass where the normal is not known; it is at most 6.1 long, even where the
 * squares that it is made of are flushed to 0 (half_space.g of the bounds). */
static void set_half_space(search *s)
{
    ball_filter *b = &s->filter;
    int k;

    for (k = 0; k < 3; k++) b->c[k] = 0.5 * L_MAX * s->hh[k];
    b->c1 = norm1(b->c);
    /* (nothing may overflow, even if a compiler computes it in vain) */
    b->dc = s->hh[HH_E] <= HH_E_MAX ? s->hh[HH_E] : 8.0;
    b->dc = L_MAX * (0.5 * b->dc + 4.0 * EPS);
}

/* excludes_box - returns 1 if the box lo, hi provably holds no better point: no
 * point in it passes the filter b, to whose left-hand side heights add at least
 * raise, or, unless the search collects, all are on the negative side.  It
 * compares the least power and the greatest side in the box with the bounds on
 * their errors: filter_bound, and E |w|, which covers the rounding of the side,
 * too.  Both are taken at a point whose coordinates are the box's own doubles,
 * or c's, so the bounds for points hold. */
static int excludes_box(const search *s, const ball_filter *b, const double *lo,
                        const double *hi, double raise)
{
    double power = raise, side = 0.0, size = 0.0, l, h, u;
    int k;

    for (k = 0; k < 3; k++) {
        l = lo[k] - s->hh[HH_BASE + k];
        h = hi[k] - s->hh[HH_BASE + k];
        u = lesser(larger(b->c[k], l), h);
        power += u * (u - 2.0 * b->c[k]);
        side += larger(l * s->hh[k], h * s->hh[k]);
        size += larger(fabs(l), fabs(h));
    }
    return power > filter_bound(b, size) ||
           (!COLLECTS(s) && s->hh[HH_E] <= HH_E_MAX &&
            side < -s->hh[HH_E] * size - UNDERFLOW_ERR);
}

/* excludes_node - returns 1 if a node provably holds no better point: by its
 * box, unless a hook has told more. */
static int excludes_node(const mesher *m, const search *s, tess_int node)
{
    const double *b = m->box + 6 * node;
    int told = HAS_SURFACE(s) ? excludes_by_marks(m, s, node) : UNSURE;

    if (told != UNSURE) return told;
    return excludes_box(s, &s->filter, b, b + 3, 0.0) ||
           (HAS_CLUMPS(m) && excludes_clump(m, s, b));
}

/* set_upper_bound - records that the best point's L-coordinate is at most l,
 * and sets the ball of L = l, the filter and the surface filter with it. */
static void set_upper_bound(const mesher *m, search *s, double l)
{
    ball_filter *b = &s->filter;
    int k;

    s->hi = l;
    if (!s->by_limbs && fabs(l) <= L_MAX) {
        s->has_ball = 1;
        for (k = 0; k < 3; k++)
            b->c[k] = s->hh[HH_CENTRE + k] + l * s->hh[k];
        b->c1 = norm1(b->c);
        /* a better point, on the open side, is in the ball of any L that is not
         * below the best point's: so only the error of c for this l counts, not
         * that of l, which is large where balls are flat: counting it makes
         * points near a plane take 10 times as long */
        b->dc = s->hh[HH_DC] + fabs(l) * s->hh[HH_E] + 4.0 * EPS * b->c1;
    }
    if (HAS_SURFACE(s)) set_surface_filter(m, s);
}

/* compare_exactly - compares z with the best point where the bounds leave
 * verdict, side or both UNSURE: by limbs first, then by the exact signs.
 * Returns BEATS, LOSES, HH_TIE times one of these for a tie, or REJECTED. */
static int compare_exactly(mesher *m, search *s, tess_int z, int side,
                           int verdict, double hi)
{
    int hard = verdict == UNSURE;

    if (decide_by_limbs(m, s, z, hi, &side, &verdict)) return REJECTED;
    if (side == UNSURE && verdict != LOSES) {
        COUNT(N_SIDE, 1);
        side = hh_porient(&m->points, s->facet[0], s->facet[1], s->facet[2], z);
    }
    if (side == 1 && verdict == UNSURE) {
        COUNT(N_EXACT, 1);
        verdict = hh_pinsphere(&m->points, s->facet, s->best, z, 2);
        hard = 2;
    }
    note_comparison(m, s, z, side, verdict, hard);
    return side == 1 ? verdict : REJECTED;
}

/* compare_point - makes z the best point if it is better: if it is on the open
 * side and its L-coordinate is smaller (Theorem 1), ties by the rule of
 * hh_pinsphere.  The bounds of hh_limits decide where they can, else
 * compare_exactly; then the better point's hi is lowered to the other's. */
static void compare_point(mesher *m, search *s, tess_int z)
{
    double lo, hi;
    int side = hh_limits(s->hh, m->x + 3 * z, &lo, &hi), verdict;

    if (HAS_SURFACE(s) && side >= 0)
        side = sharpen_by_height(m, s, z, side, &lo, &hi);
    verdict = s->best == NONE || hi < s->lo ? BEATS
              : lo > s->hi                  ? LOSES
                                            : UNSURE;
    if (side < 0 || verdict == LOSES) {
        HOLDS(!better(m, s, z));
        return;
    }
    if (side == 0 || verdict == UNSURE) {
        if (SEEKS_SURFACES(m)) add_to_sample(s, z, 1);
        verdict = compare_exactly(m, s, z, side == 1 ? 1 : UNSURE, verdict, hi);
        HOLDS((verdict < 0) == better(m, s, z));
        if (verdict == REJECTED) return;
    }
    if (verdict > 0) {
        s->ties += verdict == HH_TIE;
        if (hi < s->hi) set_upper_bound(m, s, hi);
        refine_ball(m, s, UNSURE);
        return;
    }
    HOLDS(better(m, s, z));
    if (hi > s->hi) hi = s->hi;
    s->best = z;
    s->ties = verdict == -HH_TIE ? s->ties + 1 : 0;
    s->lo = lo;
    s->by_limbs = 0;
    set_upper_bound(m, s, hi);
    refine_ball(m, s, side);
}

/* search_begin - begins the search for the apex of the facet v: its set-up, its
 * filter, and the two positions guess, unless that is NULL; either may be NONE.
 * The base is v[0], or, if the angle there is small, the vertex opposite the
 * longest edge. */
static void search_begin(mesher *m, search *s, const tess_int *v,
                         const tess_int *guess)
{
    const double *p[3];
    double u[3], edge, longest = 0.0;
    int k;

    for (k = 0; k < 3; k++) {
        p[k] = m->x + 3 * v[k];
        s->facet[k] = v[k];
        s->filter.c[k] = 0.0; /* for excludes_by_view of a guess */
    }
    s->best = NONE;
    s->has_ball = s->by_limbs = s->base = 0;
    s->ties = 0;
    s->nodes = 0;
    BEGIN_NEAR(s);
    BEGIN_CAP(s);
    BEGIN_LIMBS(s);
    BEGIN_SURFACE(s);
    s->filter.allowance = UNDERFLOW_ERR;
    s->lo = -DBL_MAX;
    s->hi = DBL_MAX;
    hh_setup(p[0], p[1], p[2], s->hh);
    if (s->hh[HH_E] >= SMALL_ANGLE_E) {
        for (k = 0; k < 3; k++) {
            minus(p[(k + 1) % 3], p[(k + 2) % 3], u);
            edge = dot(u, u);
            if (edge <= longest) continue;
            longest = edge;
            s->base = k;
        }
        if (s->base != 0)
            hh_setup(p[s->base], p[(s->base + 1) % 3], p[(s->base + 2) % 3],
                     s->hh);
        if (s->hh[HH_E] > LIMB_NORMAL_E)
            (void)hh_thin(&m->points, v, s->base, s->hh);
    }
    if (ANY_SURFACE(m)) choose_surface(m, s);
    for (k = 0; k < 2 && guess != NULL; k++)
        if (guess[k] != NONE && guess[k] != v[1] && guess[k] != v[2] &&
            guess[k] != s->best)
            compare_point(m, s, guess[k]);
    if (!s->has_ball) set_half_space(s);
    if (!s->has_ball && HAS_SURFACE(s)) set_surface_filter(m, s);
    s->in_lists = !HAS_SURFACE(s) || !ball_on_surface(m, s);
}

/* offer_point - compares z with the best point, unless it is a vertex of the
 * facet or does not pass the filter: the surface filter if its height over the
 * facet's surface is known. */
static void offer_point(mesher *m, search *s, tess_int z)
{
    const double *q = m->x + 3 * z;
    double w0 = q[0] - s->hh[HH_BASE], w1 = q[1] - s->hh[HH_BASE + 1],
           w2 = q[2] - s->hh[HH_BASE + 2];
    double raise = 0.0;
    const ball_filter *b = &s->filter;

    COUNT(N_POINT, 1);
    if (z == s->best || z == s->facet[0] || z == s->facet[1] ||
        z == s->facet[2])
        return;
    if (HAS_SURFACE(s)) b = filter_of_mark(m, s, z, &raise);
    if (HH_POWER(w0, w1, w2, b->c) <=
        filter_bound(b, fabs(w0) + fabs(w1) + fabs(w2)) - raise)
        compare_point(m, s, z);
    else {
        HOLDS(!better(m, s, z));
    }
}

/* offer_leaf - offers the uncompleted points of a leaf, of which there must be
 * one, that pass the filter; or collects them, if a near list is made.  The
 * powers come first, as vectors, then the least of each group, as most groups
 * have no point that passes.  Stars are completed in the order of positions, by
 * and large, so the points before the first uncompleted one are most of the
 * completed ones. */
static void offer_leaf(mesher *m, search *s, tess_int node)
{
    const double *b = m->box + 6 * node, *x;
    const ball_filter *filter = &s->filter;
    double power[LEAF_POINTS], size = 0.0, most, least, w0, w1, w2;
    double b0 = s->hh[HH_BASE], b1 = s->hh[HH_BASE + 1],
           b2 = s->hh[HH_BASE + 2], d0, d1, d2;
    tess_int first, last;
    int n, i, k;

    node_range(m, node, &first, &last);
    while (m->edge_from[first] == COMPLETE) first++;
    x = m->x + 3 * first;
    n = (int)(last - first);
    COUNT(N_LEAF, 1);
    COUNT(N_LIST, n);
    for (k = 0; k < 3; k++)
        size += fabs(b[k] - s->hh[HH_BASE + k]) +
                fabs(b[3 + k] - s->hh[HH_BASE + k]);
    most = filter_bound(filter, size);
    d0 = 2.0 * filter->c[0], d1 = 2.0 * filter->c[1], d2 = 2.0 * filter->c[2];
    for (k = 0; k < n; k++) {
        w0 = x[3 * k] - b0;
        w1 = x[3 * k + 1] - b1;
        w2 = x[3 * k + 2] - b2;
        power[k] = w0 * (w0 - d0) + w1 * (w1 - d1) + w2 * (w2 - d2);
    }
    if (COLLECTS(s)) {
        collect_leaf(m, s, first, n, power, most);
        return;
    }
    for (; n % LEAF_GROUP != 0; n++) power[n] = DBL_MAX;
    for (i = 0; i < n; i += LEAF_GROUP) {
        least = DBL_MAX;
        for (k = i; k < i + LEAF_GROUP; k++)
            /* cppcheck-suppress uninitvar ; all n are set */
            least = least < power[k] ? least : power[k];
        if (least > most) continue;
        for (k = i; k < i + LEAF_GROUP; k++)
            if (power[k] <= most && m->edge_from[first + k] != COMPLETE)
                offer_point(m, s, (tess_int)(first + k));
    }
    if (SEEKS_SURFACES(m)) add_to_sample(s, first, 0);
}

/* search_tree - finishes a search in the tree: the leaf of the base first, then
 * its parent's other child, and so on up to the root; with cylinders, its
 * grandparent's other three grandchildren, tested at once.
 *
 *                 .            node: what is searched next.  The stack holds
 *             /       \        what is left of the subtree that was entered
 *           top        node    last; when it is empty, top's sibling is next,
 *         /    \      /    \   or top's grandparent: everything below top has
 *       from    .    .      .  been searched, from is where that ended. */
static void search_tree(mesher *m, search *s)
{
    tess_int stack[STACK_DEPTH],
        node = m->leaves + leaf_of(m, s->facet[s->base]);
    tess_int top = node, from;
    const double *x = m->x, *b;
    double c1 = s->filter.c1;
    int depth = 1, fours, flat = COLLECTS(s) ? 3 : 0;

    /* a plane across an axis has no candidates for a facet in it */
    while (flat < 3 &&
           (x[3 * s->facet[0] + flat] != x[3 * s->facet[1] + flat] ||
            x[3 * s->facet[0] + flat] != x[3 * s->facet[2] + flat] ||
            m->points.exact3 <
                -1.0)) /* what underflowed may be equal only here */
        flat++;
    fours = HAS_CYLINDERS(m) && !HAS_SURFACE(s);
    stack[0] = node;
    while (depth > 0 || top > 1) {
        from = top;
        s->nodes++;
        if (depth > 0)
            node = stack[--depth];
        else if (fours && top > 3) {
            node = top /= 4;
            /* from is the only grandchild with points */
            if (m->alive[from] > 0 &&
                m->alive[from / 2] + m->alive[node] == 2) {
                HOLDS(barren(m, s, node));
                continue;
            }
        } else {
            node = top % 2 == 0 ? top + 1 : top - 1;
            top /= 2;
        }
        b = m->box + 6 * node;
        if (m->alive[node] == 0) continue;
        if ((flat < 3 && b[flat] == b[3 + flat] &&
             b[flat] == s->hh[HH_BASE + flat]) ||
            OUTSIDE_CAP(s, b)) {
            HOLDS(barren(m, s, node));
            continue;
        }
        if (fours && node < m->leaves) {
            depth = push_fours(m, s, node, from, stack, depth);
            continue;
        }
        COUNT(N_NODE, 1);
        if (excludes_node(m, s, node)) {
            HOLDS(barren(m, s, node));
        } else if (node >= m->leaves) {
            offer_leaf(m, s, node);
            if (s->filter.c1 != c1 && MAY_HAVE_CAP(m, s)) choose_cap(m, s);
            c1 = s->filter.c1;
        } else {
            stack[depth++] = 2 * node;
            stack[depth++] = (tess_int)(2 * node + 1);
        }
    }
}

/* apex - returns the apex of a facet on its positive side, or NONE.  guess: see
 * search_begin.
 *
 * The search is complete without its stages: see the hooks.  So they may be
 * left out, or come in another order, and the apex is the same.  That hull
 * planes come before the block list saves lattices a tenth of the time. */
static tess_int apex(mesher *m, const tess_int *facet, const tess_int *guess)
{
    search s;

    COUNT(N_FACET, 1);
    if (HAS_SETS(m) && (s.best = apex_from_set(m, facet)) != NONE)
        return s.best;
    search_begin(m, &s, facet, guess);
    if (!(search_star_list(m, &s) || on_hull_plane(m, &s) ||
          search_block_list(m, &s))) {
        if (MAY_HAVE_CAP(m, &s)) choose_cap(m, &s);
        if (!search_near_lists(m, &s)) {
            COUNT(N_TREE, 1);
            search_tree(m, &s);
            refill_budget(m, &s);
        }
        seek_surface(m, &s);
        note_hull_plane(m, &s);
        seek_plane(m, &s);
    }
    HOLDS(s.best != NONE || proven(m, facet, NONE));
    return s.best;
}

/* ---- star by star ----
 *
 * STATES OF A VERTEX v: edge_from[v].  Whether v is wanted is another matter:
 * owned[v].
 *   NEW       in no tetrahedron: all points at first, by build
 *   met       NONE, or its first edge.  From NEW: in add_tetrahedron as an
 *             apex, in begin_mesh as a vertex of the first facet, in push_edge
 *             as the beginning of a seed edge
 *   COMPLETE  its star is known.  From met: in complete_star, for s itself
 *             (which may be NEW, if seed_star began its star); in
 *             complete_stars, if v owns no facet and no vertex before it does
 * rebuild_state sets a resumed result's vertices to met if they have an open
 * facet, else to COMPLETE.  COMPLETE is final.  A vertex that is not wanted
 * becomes COMPLETE in rebuild_state alone, where all its facets are closed. */

/* complete_vertex - marks the star of s complete: s leaves the tree and the
 * lists. */
static void complete_vertex(mesher *m, tess_int s)
{
    tess_int node = m->leaves + leaf_of(m, s);

    if (m->edge_from[s] == COMPLETE) return;
    m->edge_from[s] = COMPLETE;
    while (node > 0 && --m->alive[node] == 0) node /= 2;
    leave_lists(m, s);
}

/* begin_mesh - puts the first facet into the link of s, its vertex of least
 * position, as a seed edge, for which there is always room.  Returns 0, or the
 * code of points without a tetrahedron. */
static int begin_mesh(mesher *m, tess_int *s)
{
    tess_int v[3];
    int code = first_facet(m, v), i;

    if (code != 0) return code;
    *s = v[0];
    for (i = 0; i < 3; i++) m->edge_from[v[i]] = NONE;
    (void)push_edge(m, SEED_EDGE, v[1], v[2]);
    return 0;
}

/* complete_star - completes the star of s, whose open facets are the edges of
 * the link.  Returns 0, TESS_MORE or TESS_POOL. */
static int complete_star(mesher *m, tess_int s)
{
    tess_int *p, v[3], guess[2], c;

    make_lists(m, s);
    while (m->oldest_edge >= m->newest_edge) {
        p = m->pool + m->oldest_edge;
        if (p[EDGE_CODE] == DEAD_EDGE) {
            m->oldest_edge -= EDGE_LEN;
            continue;
        }
        v[0] = s;
        v[1] = p[EDGE_FROM];
        v[2] = p[EDGE_TO];
        guess[0] =
            p[EDGE_PREV] == NONE ? NONE : m->pool[p[EDGE_PREV] + EDGE_FROM];
        guess[1] =
            p[EDGE_NEXT] == NONE ? NONE : m->pool[p[EDGE_NEXT] + EDGE_TO];
        c = apex(m, v, guess);
        HOLDS(proven(m, v, c));
        if (c == NONE) {
            if (p[EDGE_CODE] != SEED_EDGE) m->adj[p[EDGE_CODE]] = TESS_NONE;
            connect_edges(m, p[EDGE_PREV], NONE);
            connect_edges(m, NONE, p[EDGE_NEXT]);
            remove_edge(m, m->oldest_edge);
            continue;
        }
        if (m->ntet == m->maxtet) {
            flush_facets(m);
            return TESS_MORE;
        }
        if (!make_room(m, s)) return TESS_POOL;
        add_tetrahedron(m, s, m->oldest_edge, c);
        HOLDS(room_for(m, m->ntet - m->unfiled, 0));
    }
    clear_link(m);
    flush_facets(m);
    complete_vertex(m, s);
    return 0;
}

/* complete_stars - completes the stars of all wanted vertices, beginning with s
 * if the link has edges: first those connected through open facets, then one of
 * the rest, and so on.  Returns 0, TESS_MORE or TESS_POOL. */
static int complete_stars(mesher *m, tess_int s)
{
    int code;

    for (;;) {
        if (m->oldest_edge >= m->newest_edge) {
            code = complete_star(m, s);
            if (code != 0) return code;
            HOLDS(filed(m));
        }
        s = m->lowest_owner;
        while (s < m->np && m->owned[s] < 0) {
            /* no vertex of a smaller position owns a facet, so one that was met
             * and owns none has no open facet: its star is complete */
            if (m->edge_from[s] == NONE && m->owned[s] == NONE)
                complete_vertex(m, s);
            s++;
        }
        m->lowest_owner = s;
        if (s < m->np) {
            if (!edges_from_pool(m, s)) return TESS_POOL;
            continue;
        }
        s = m->next_new;
        while (s < m->np && (m->edge_from[s] != NEW || m->owned[s] == UNWANTED))
            s++;
        m->next_new = s;
        if (s == m->np) return 0;
        if (!make_room(m, s)) return TESS_POOL;
        seed_star(m, s);
    }
}

/* ---- the workspace; a mesh from the points, or from a beginning ---- */

/* Maximum number of tetrahedra: 4t+k and 4 maxtet + 3 fit in tess_int. */
#define MAXTET_MOST ((TESS_INT_MOST - 3) / 4)
/* What an index keeps in iw beside representative, order, alive and mark. */
#define INDEX_EXTRA 5
/* INDEX_EXTRA and the minimum length of the pool: part of tess.h's minimum of
 * iw. */
#define POOL_MIN 512
/* With fewer points there are no reference surfaces and no cylinders. */
#define SURFACE_POINTS_MIN TESS_SURFACES_FROM

/* place_in_four - returns the first k with v[k] = x, or 4. */
static int place_in_four(const tess_int *v, tess_int x)
{
    int k = 0;

    while (k < 4 && v[k] != x) k++;
    return k;
}

/* map_four - sets w to what map has for the four v. */
static void map_four(const tess_int *map, const tess_int *v, tess_int *w)
{
    int k;

    for (k = 0; k < 4; k++) w[k] = map[v[k]];
}

/* matching_facet - returns the facet of tetrahedron u, of four different
 * vertices, that has the vertices of facet k of t in opposite order, so that,
 * both tetrahedra being positively oriented, their apexes are on opposite
 * sides; 4 if there is none. */
static int matching_facet(const tess_int *tet, tess_int t, int k, tess_int u)
{
    const tess_int *v = tet + 4 * u;
    tess_int f[3], g[3];
    int i, j = 0;

    tet_facet(tet + 4 * t, k, f);
    while (j < 3 && (v[j] == f[0] || v[j] == f[1] || v[j] == f[2])) j++;
    tet_facet(v, j, g);
    for (i = 0; i < 3; i++)
        if (g[i] == f[0] && g[(i + 1) % 3] == f[2] && g[(i + 2) % 3] == f[1])
            return j;
    return 4;
}

/* workspace_lengths - finds the lengths of iw and rw for n points.  Uniform
 * points need 5 n^(2/3) facets in the pool; a star of all points needs 2 n,
 * which take 12 n integers: granted up to TESS_HUB.  Marks and cylinders
 * get room for as many points as can need them.  Returns 0 for a bad n:
 * negative, or so large that a minimum exceeds the largest tess_int. */
static int workspace_lengths(tess_int n, ws_lengths *w)
{
    double c = (double)cube_root(n), hub = lesser(8.0 * (double)n, TESS_HUB);
    double room = 4.0 * (double)n + larger(60.0 * c * c, hub);
    tess_int left;

    /* 2 leaf_count(n) < n/12 + 2 */
    if (n < 0 || n > (TESS_INT_MOST - POOL_MIN) / 5) return 0;
    w->iw = (tess_int)(4 * n + 2 * leaf_count(n) + POOL_MIN);
    w->rw = (tess_int)(3 * n + 12 * leaf_count(n));
    left = TESS_INT_MOST - w->iw;
    w->pool = room < (double)left ? (tess_int)room : left;
    w->marks = w->cylinders = 0;
    if (n < SURFACE_POINTS_MIN) return 1;
    left -= w->pool;
    w->pool -= RECORDS_LENGTH;
    if (2 * SURFACES * leaf_count(n) < left - n)
        w->marks = (tess_int)MARKS_LENGTH(n);
    if (CYLINDER_LEN * (leaf_count(n) / 3) < TESS_INT_MOST - w->rw)
        w->cylinders = CYLINDER_LEN * (leaf_count(n) / 3);
    return 1;
}

/* lay_out - lays out the part of the workspace of n points that an index keeps,
 * and sets what a mesher begins with. */
static void lay_out(mesher *m, tess_int n, const tess_real *p, tess_int *iw,
                    double *rw)
{
    (void)workspace_lengths(n, &m->lengths);
    m->points.x = m->x = rw;
    m->points.p = p;
    m->box = rw + 3 * n;
    m->representative = iw;
    m->points.order = m->order = iw + n;
    m->first_tet = iw + 2 * n;
    m->alive = m->first_tet + INDEX_EXTRA;
    m->mark = m->alive + 2 * leaf_count(n);
    m->edge_from = m->order; /* stands in: none of its entries is COMPLETE */
    m->np = 0;
    start_stages(m);
}

/* prepare_points - prepares n points: sorts them, drops duplicates, builds the
 * tree, and makes cylinders if lrw has room for them.  Returns 0, TESS_POINT or
 * TESS_RANGE. */
static int prepare_points(mesher *m, tess_int n, const tess_real *p,
                          tess_int *iw, tess_int lrw, double *rw)
{
    tess_int i;
    int twins = 0;

    lay_out(m, n, p, iw, rw);
    if (n == 0) return TESS_POINT;
    if (!hh_holds(n, p) || !limbs_hold_all(n, p)) return TESS_RANGE;
    for (i = 0; i < n; i++) m->representative[i] = i;
    distinct_points(m, n, p);
    kd_sort(m);
    for (i = 0; i < n; i++) {
        m->representative[i] = m->representative[m->representative[i]];
        if (m->representative[i] != i) twins = 1;
    }
    if (twins) {
        /* the cuts may have separated duplicates: sort again without them */
        distinct_points(m, n, p);
        kd_sort(m);
    }
    scale_points(m);
    make_boxes(m);
    measure_clumps(m);
    revive_all(m);
    if (m->lengths.cylinders > 0 && lrw - m->lengths.rw >= m->lengths.cylinders)
        make_cylinders(m);
    return 0;
}

/* check_unfinished - checks in one pass that the caller's arrays can be an
 * unfinished result: the vertices of each tetrahedron are no duplicates, and it
 * is positively oriented; each facet is on the hull, open, or matched with its
 * neighbour's, and the neighbour's apex is not inside the ball.  Returns 0, -5
 * or -6; owned then holds the positions of the points. */
static int check_unfinished(mesher *m, tess_int n)
{
    tess_int i, t, u, *position = m->owned, v[4];
    int k, j;

    for (i = 0; i < n; i++) position[i] = NONE;
    for (i = 0; i < m->np; i++) position[m->order[i]] = i;
    for (i = 0; i < 4 * m->ntet; i++)
        if (position[m->tet[i]] == NONE) return -5;
    for (t = 0; t < m->ntet; t++) {
        map_four(position, m->tet + 4 * t, v);
        if (hh_porient(&m->points, v[0], v[1], v[2], v[3]) <= 0) return -5;
        for (k = 0; k < 4; k++) {
            u = m->adj[4 * t + k];
            if (u <= TESS_NONE) continue;
            j = matching_facet(m->tet, t, k, u);
            if (j == 4 || m->adj[4 * u + j] != t) return -6;
            if (u > t && hh_pinsphere(&m->points, v, v[3],
                                      position[m->tet[4 * u + j]], 1) < 0)
                return -5;
        }
    }
    return 0;
}

/* mark_wanted - marks in owned which vertices are wanted: the points i with
 * mine[i] != 0, or all if mine is NULL.  Returns how many slots the table
 * starts with for so many: a little more than what uniform points need, as a
 * small table stays in the cache. */
static tess_int mark_wanted(mesher *m, tess_int n, const tess_int *mine)
{
    tess_int i, c, own = mine == NULL ? m->np : 0;

    for (i = 0; i < m->np; i++) m->owned[i] = mine == NULL ? NONE : UNWANTED;
    for (i = 0; i < n && mine != NULL; i++)
        if (mine[i] != 0) m->owned[m->representative[i]] = NONE, own++;
    c = cube_root(own);
    return (tess_int)(9 * c * c + 16);
}

/* rebuild_state - resumes an unfinished result that check_unfinished has
 * passed: converts tet to positions; completes the vertices that have no open
 * facet; the open facets at s, the first vertex of the last tetrahedron, become
 * edges of its link in the order of their tetrahedra, and the others enter the
 * table.  Returns 0, TESS_POOL, or -6 for a facet that is open twice. */
static int rebuild_state(mesher *m, tess_int *s, tess_int n,
                         const tess_int *mine)
{
    tess_int i, v[3], size, open = 0;
    int k;

    for (i = 0; i < 4 * m->ntet; i++) {
        m->tet[i] = m->owned[m->tet[i]];
        m->edge_from[m->tet[i]] = COMPLETE;
    }
    size = mark_wanted(m, n, mine);
    for (i = 0; i < 4 * m->ntet; i++)
        if (m->adj[i] == TESS_OPEN) {
            facet_of_code(m, i, v);
            if (owner(m, v) != NONE) open++;
            for (k = 0; k < 3; k++) m->edge_from[v[k]] = NONE;
        }
    for (i = 0; i < m->np; i++)
        if (m->edge_from[i] == COMPLETE) {
            m->edge_from[i] = NONE;
            complete_vertex(m, i);
        }
    if (open > m->pool_len / ENTRY_LEN) return TESS_POOL;
    m->nfacets = open;
    if (!rebuild_table(m, NONE, (tess_int)(2 * open + 1))) return TESS_POOL;
    if (m->nfacets < open) return -6; /* its two sides removed each other */
    *s = m->tet[4 * (m->ntet - 1)];
    if (m->owned[*s] == UNWANTED) *s = NONE;
    m->slots = 1;
    m->nfacets = 0;
    if (!edges_from_adj(m, *s)) return TESS_POOL;
    m->nfacets = open; /* at most so many are left for the table */
    if (2 * open > size) size = (tess_int)(2 * open);
    return rebuild_table(m, *s, (tess_int)(size + 1)) ? 0 : TESS_POOL;
}

/* lay_out_pool - lays out what is left of iw, of length liw: marks, if there
 * are reference surfaces or may be, then owned, edge_from and the pool. */
static void lay_out_pool(mesher *m, tess_int n, tess_int liw)
{
    tess_int marks = room_for_marks(m, liw);

    m->owned = m->mark + marks;
    m->edge_from = m->owned + n;
    m->pool = m->edge_from + n;
    m->pool_len =
        (tess_int)(liw - 4 * n - 2 * leaf_count(n) - INDEX_EXTRA - marks);
}

/* build - completes the stars of all points, or of the points i with mine[i] !=
 * 0 if mine is given, for arguments that bad_argument has passed.  Returns a
 * code of tess_resume. */
static int build(mesher *m, tess_int n, const tess_int *mine, tess_int maxtet,
                 tess_int *ntet, tess_int *tet, tess_int *adj)
{
    tess_int i, s = NONE;
    int code = 0;

    m->maxtet = maxtet;
    m->unfiled = m->ntet = *ntet;
    m->tet = tet;
    m->adj = adj;
    m->slots = 1;
    m->nfacets = m->lowest_owner = 0;
    m->next_new = mine == NULL ? m->np : 0;
    clear_link(m);
    /* drops what earlier calls have left: lists that lack points that are
     * uncompleted again, and planes that bounded only what was uncompleted then
     */
    drop_stages(m);
    for (i = 0; i < m->np; i++) m->edge_from[i] = NEW;
    if (m->ntet > 0) {
        code = check_unfinished(m, n);
        if (code != 0) return code;
        code = rebuild_state(m, &s, n, mine);
    } else {
        i = mark_wanted(m, n, mine);
        if (mine == NULL) code = begin_mesh(m, &s);
        if (code == 0 && !rebuild_table(m, s, i)) code = TESS_POOL;
    }
    if (code == 0) code = complete_stars(m, s);
    if (mine != NULL) revive_all(m);
    for (i = 0; i < 4 * m->ntet; i++) tet[i] = m->order[tet[i]];
    *ntet = m->ntet;
    return code;
}

/* bad_argument - returns the code of a bad argument of tess_resume, or 0. p is
 * NULL if the points are known to be finite. */
static int bad_argument(tess_int n, const tess_real *p, tess_int maxtet,
                        tess_int ntet, const tess_int *tet, const tess_int *adj,
                        tess_int liw, tess_int lrw)
{
    ws_lengths w;
    tess_int i;

    if (!workspace_lengths(n, &w)) return -1;
    if (p != NULL && hh_finite(n, p) < n) return -2;
    if (maxtet < 0 || maxtet > MAXTET_MOST) return -3;
    if (ntet < 0 || ntet > maxtet) return -4;
    for (i = 0; i < 4 * ntet; i++)
        if (tet[i] < 0 || tet[i] >= n) return -5;
    for (i = 0; i < 4 * ntet; i++)
        if (adj[i] < TESS_OPEN || adj[i] >= ntet) return -6;
    if (liw < w.iw) return -7;
    return lrw < w.rw ? -9 : 0;
}

int tess_size(tess_int n, tess_int maxtet, tess_int *liw, tess_int *lrw)
{
    ws_lengths w;

    *liw = *lrw = 0;
    if (!workspace_lengths(n, &w)) return -1;
    if (maxtet < 0 || maxtet > MAXTET_MOST) return -2;
    *liw = (tess_int)(w.iw + w.pool + w.marks);
    *lrw = w.rw + w.cylinders;
    return 0;
}

int tess(tess_int n, const tess_real *p, tess_int maxtet, tess_int *ntet,
         tess_int *tet, tess_int *adj, tess_int liw, tess_int *iw, tess_int lrw,
         double *rw)
{
    int code;

    *ntet = 0;
    code = tess_resume(n, p, maxtet, ntet, tet, adj, liw, iw, lrw, rw);
    if (code == -2) *ntet = hh_finite(n, p);
    return code;
}

int tess_resume(tess_int n, const tess_real *p, tess_int maxtet, tess_int *ntet,
                tess_int *tet, tess_int *adj, tess_int liw, tess_int *iw,
                tess_int lrw, double *rw)
{
    mesher m;
    int code = bad_argument(n, p, maxtet, *ntet, tet, adj, liw, lrw);

    if (code == 0) code = prepare_points(&m, n, p, iw, lrw, rw);
    if (code > 0) *ntet = 0;
    if (code != 0) return code;
    m.first_tet[0] = m.first_tet[4] = 0; /* what is left in iw is no index */
    lay_out_pool(&m, n, liw);
    return build(&m, n, NULL, maxtet, ntet, tet, adj);
}

/* =====================================================================
 * PART II: FASTER SEARCHES
 *
 * No result depends on what follows, down to part III.  Each chapter opens with
 * the data that it is for, and what they cost without it; its idea, its words,
 * its hooks, its state and what always holds of it.  Its constants and routines
 * follow.  What a hook may do stands where the hooks are declared.
 * ===================================================================== */

#ifndef TESS_CORE

/* ---- candidate lists: where to look first ----
 *
 * FOR all data: without star lists lattices take 2.05 times the instructions,
 * clouds 1.4; without block lists clouds 1.15, as star lists are made from
 * them.
 *
 * IDEA.  The points near s are few, and most balls of its star lie among them.
 * They are copied into a list of their own, in single precision, which a loop
 * without a branch tests by fours.  Where the list is known to hold all points
 * of the ball, one pass over it ends the search.
 *
 *   candidate list    uncompleted points in single precision, tested by fours
 *   block list        those about a leaf, which is then called a block
 *   star list         those of the block list that are near s
 *
 *         +-----------------------+  block list: the points of the leaf of s,
 *         |     +-------+         |  then all others in its box, which is wider
 *         |     | leaf  |(star)   |  than the leaf's by reach;
 *         |     |     ( s )       |  star list: those of the block list in a
 *         |     +-------+         |  ball about s
 *         +-----------------------+
 *
 * HOOKS: make_lists, leave_lists; the stages search_star_list and
 * search_block_list.
 * STATE: lists, in mesher.
 * INVARIANTS.  A block list with n > 0 has all uncompleted points of its box; a
 * star list those within reach of its vertex; points that have left are at
 * LEFT_LIST.  Coordinates err by FEPS of the list's units, and what is tested
 * in them has room for that. */

#ifndef TESS_NO_LISTS

/* How far a block list extends beyond the leaf's box, in mean spacings of the
 * leaf's points, and a star list from its vertex, in those reaches.  They trade
 * the lists' lengths against the searches that end in them.  For uniform points
 * the lists hold about 240 and 20 points; 80 to 88 % of the searches end in the
 * star list, most others in the block list.  Without star lists searches take a
 * quarter longer. */
#define BLOCK_REACH 2.6
#define STAR_REACH 0.85
/* A block makes no more star lists once so many searches in a row have ended in
 * the tree: near surfaces they would cost 3 to 10 %. */
#define MAX_BLOCK_MISSES 8
/* Lists are wider by TIED_WIDENING once more than TIED_SEARCHES in a row have
 * met ties in the block list.  The star lists then hold the balls of a lattice
 * with 27 points a leaf: 24^3 points take 0.4 times as long. */
#define TIED_SEARCHES 8
#define TIED_WIDENING 1.2
/* What to_single adds and takes away again: this rounds to a multiple of 2^-51,
 * in 80 bits of 2^-62. */
#if DBL_MANT_DIG >= 53
#define LIST_SHIFT 5.0
#else
#define LIST_SHIFT 0.0
#endif
/* A box narrower than this has no list.  So a list's coordinates are right to
 * far less than FEPS, and a star list's reach is above HH_LENGTH_MIN: no
 * product in ball_in_star_list underflows. */
#define LIST_BOX_MIN (HH_LENGTH_MIN * 1e5)
/* A star whose reach is less, in units of its block list, has no list: the
 * block list cannot tell such points apart. */
#define STAR_REACH_MIN 1e-4
/* Bound on the error of a distance in units of the block list: 2 FEPS for each
 * of two coordinates of at most 2, times sqrt(3), below 7 (twice that, where a
 * double is no longer than a float); and 5 roundings of a distance below 3.5,
 * of the difference, the square, the sum and the bound: below 25 FEPS, or 32.
 * What is computed to be within reach + LIST_DIST_ERR is within 1.1 reach:
 * LIST_DIST_ERR is 0.04 STAR_REACH_MIN. */
#define LIST_DIST_ERR (32.0f * FEPS)
/* Where a list puts points that have left it.  None of them passes a filter:
 * norm2 is at least LEFT_LIST^2 = 1e20, and list_filter's limits leave |d.x| <
 * 2e19, d[3] < 1e18. */
#define LEFT_LIST 1e10f

/* boxes_disjoint - returns 1 if two boxes have no point in common. */
static int boxes_disjoint(const double *alo, const double *ahi,
                          const double *blo, const double *bhi)
{
    return (ahi[0] < blo[0]) | (ahi[1] < blo[1]) | (ahi[2] < blo[2]) |
           (bhi[0] < alo[0]) | (bhi[1] < alo[1]) | (bhi[2] < alo[2]);
}

/* to_single - returns x in single precision, rounded to a multiple of 2^-51
 * (in 80 bits of 2^-62) before, so that neither squares and products of two in
 * single precision nor their differences underflow. */
static float to_single(double x)
{
    return (float)((x + LIST_SHIFT) - LIST_SHIFT);
}

/* fill_list - sets the coordinates of a list from its positions.  Points whose
 * stars are complete are put at LEFT_LIST, and so is what pads the list to a
 * multiple of four: loops over lists go by fours, which every compiler can
 * vectorize. */
static void fill_list(const mesher *m, candidate_list *l)
{
    const double *q;
    float x, y, z;
    int i;

    for (i = 0; i < (l->n + 3) / 4 * 4; i++) {
        x = y = z = LEFT_LIST;
        if (i < l->n && m->edge_from[l->position[i]] != COMPLETE) {
            q = m->x + 3 * l->position[i];
            x = to_single((q[0] - l->origin[0]) * l->scale);
            y = to_single((q[1] - l->origin[1]) * l->scale);
            z = to_single((q[2] - l->origin[2]) * l->scale);
        }
        l->x[i] = x;
        l->y[i] = y;
        l->z[i] = z;
        l->norm2[i] = x * x + y * y + z * z;
    }
}

/* collect_in_box - appends to a list the uncompleted points in its box that are
 * not in leaf own.  Returns 0 if they do not fit. */
static int collect_in_box(const mesher *m, candidate_list *l, tess_int own)
{
    tess_int node = 1, i, first, last;
    const double *b;

    while (node > 0) {
        b = m->box + 6 * node;
        if (m->alive[node] > 0 && !boxes_disjoint(l->lo, l->hi, b, b + 3) &&
            node != m->leaves + own) {
            if (node < m->leaves) {
                node = 2 * node;
                continue;
            }
            node_range(m, node, &first, &last);
            for (i = first; i < last; i++) {
                l->position[l->n] = i;
                l->n +=
                    (m->edge_from[i] != COMPLETE) &
                    !boxes_disjoint(l->lo, l->hi, m->x + 3 * i, m->x + 3 * i);
            }
            if (l->n > TESS_LIST) return 0;
        }
        node = next_node(node);
    }
    return 1;
}

/* set_list_box - sets the box of a list, lo, hi and its reach about it, as far
 * as it is in the root's, and its units.  Returns the box's half width. */
static double set_list_box(const mesher *m, candidate_list *l, const double *lo,
                           const double *hi)
{
    const double *root = m->box + 6;
    double half = 0.0;
    int k;

    for (k = 0; k < 3; k++) {
        l->lo[k] = larger(lo[k] - l->reach, root[k]);
        l->hi[k] = lesser(hi[k] + l->reach, root[3 + k]);
        l->origin[k] = 0.5 * (l->lo[k] + l->hi[k]);
        l->max_abs[k] = 0.5 * (l->hi[k] - l->lo[k]);
        half = larger(half, l->max_abs[k]);
    }
    l->scale = half > LIST_BOX_MIN ? 1.0 / half : 0.0;
    for (k = 0; k < 3; k++) l->max_abs[k] *= l->scale;
    return half;
}

/* make_block_list - makes the block list of the leaf of s: its points, in
 * order, then the uncompleted ones around it.  The reach shrinks until they
 * fit. */
static void make_block_list(mesher *m, tess_int s)
{
    tess_int leaf = leaf_of(m, s), i;
    const double *b = m->box + 6 * (m->leaves + leaf);
    double x = b[3] - b[0], y = b[4] - b[1], z = b[5] - b[2], half;
    /* the mean spacing of the leaf's points in diagonals of its box, one over
     * the cube root of their number (24 to 48 in large sets), by a step of
     * Newton's method */
    double margin = BLOCK_REACH / sqrt(3.0) * 3.0 /
                    (2.0 * 3.2 +
                     (double)m->np / (double)m->leaves / (3.2 * 3.2)) *
                    sqrt(x * x + y * y + z * z) *
                    (m->lists.block_ties > TIED_SEARCHES ? TIED_WIDENING : 1.0);
    candidate_list *l = &m->lists.block;
    int over = 1;

    l->leaf_first = leaf_start(m, leaf);
    l->leaf_end = leaf_start(m, leaf + 1);
    m->lists.block_misses = 0;
    while (over) {
        l->reach = margin;
        half = set_list_box(m, l, b, b + 3);
        l->n = 0;
        for (i = l->leaf_first; i < l->leaf_end; i++) l->position[l->n++] = i;
        over = !collect_in_box(m, l, leaf);
        if (l->scale == 0.0 || (over && margin == 0.0)) {
            l->n = 0; /* there is no list */
            return;
        }
        margin = margin > 1e-3 * half ? 0.7 * margin : 0.0;
    }
    fill_list(m, l);
}

/* pick_indices - stores in picked the indices i < n with in[i] = 1 (the others
 * are 0), and returns their number; without a branch, which no processor could
 * predict. */
static int pick_indices(const int *in, int n, int *picked)
{
    int i, *next = picked;

    for (i = 0; i < n; i += 4) {
        *next = i;
        next += in[i];
        *next = i + 1;
        next += in[i + 1];
        *next = i + 2;
        next += in[i + 2];
        *next = i + 3;
        next += in[i + 3];
    }
    return (int)(next - picked);
}

/* make_lists - makes the lists for the star of s: the block list of its leaf
 * and, from it, the star list: the points nearer to s than its reach, which is
 * at most the distance from s to where the block list may lack points.  The
 * sets of the star before are gone. */
static void make_lists(mesher *m, tess_int s)
{
    candidate_list *l = &m->lists.block, *g = &m->lists.star;
    const double *q = m->x + 3 * s, *root = m->box + 6;
    double margin;
    float x, y, z, most;
    int i, k, in[TESS_LIST], which[TESS_LIST + 1];

#ifndef TESS_NO_SETS
    m->sets.recorded = 0;
#endif
    if (s < l->leaf_first || s >= l->leaf_end) make_block_list(m, s);
    g->n = 0;
    margin = STAR_REACH * l->reach;
    for (k = 0; k < 3; k++) {
        if (l->lo[k] > root[k]) margin = lesser(margin, q[k] - l->lo[k]);
        if (l->hi[k] < root[3 + k]) margin = lesser(margin, l->hi[k] - q[k]);
        g->origin[k] = q[k];
        g->max_abs[k] = 1.1;
    }
    if (l->n == 0 || m->lists.block_misses >= MAX_BLOCK_MISSES ||
        margin * l->scale < STAR_REACH_MIN)
        return;
    g->reach = margin;
    g->scale = 1.0 / margin;
    i = (int)(s - l->leaf_first);
    x = l->x[i];
    y = l->y[i];
    z = l->z[i];
    /* no point nearer than the reach is missed */
    most = (float)(margin * l->scale) + LIST_DIST_ERR;
    most *= most;
    for (i = 0; i < (l->n + 3) / 4 * 4; i++)
        in[i] = (l->x[i] - x) * (l->x[i] - x) + (l->y[i] - y) * (l->y[i] - y) +
                    (l->z[i] - z) * (l->z[i] - z) <=
                most;
    g->n = pick_indices(in, l->n, which);
    for (i = 0; i < g->n; i++) g->position[i] = l->position[which[i]];
    fill_list(m, g);
}

/* leave_lists - takes s, whose star is complete, out of the block list.
 * (offer_list skips it in the other lists.) */
static void leave_lists(mesher *m, tess_int s)
{
    candidate_list *l = &m->lists.block;
    int i = (int)(s - l->leaf_first);

    if (s < l->leaf_first || s >= l->leaf_end || l->n == 0) return;
    l->x[i] = l->y[i] = l->z[i] = LEFT_LIST;
    l->norm2[i] = LEFT_LIST * LEFT_LIST;
}

/* ball_in_block - returns 1 if the part of the ball that may hold points, the
 * part in the root's box, lies inside the box of a list.  The centre of the
 * true ball is within dc of c, and both balls pass through the base.  So the
 * radius is at most |c| + dc, and along an axis the ball ends within |c| + 2 dc
 * of c. */
static int ball_in_block(const mesher *m, const search *s,
                         const candidate_list *l)
{
    const double *root = m->box + 6, *c = s->filter.c;
    double r = sqrt(dot(c, c)), part[6];
    int i, k, side;

    r = r * (1.0 + ROUNDING) + 2.0 * s->filter.dc;
    HOLDS(within(m, s, r));
    for (i = 0; i < 6; i++) part[i] = root[i];
    for (i = 0; i < 6; i++) {
        k = i % 3;
        if (i < 3 ? c[k] - r >= l->lo[k] - s->hh[HH_BASE + k]
                  : c[k] + r <= l->hi[k] - s->hh[HH_BASE + k])
            continue;
        /* the part of the root's box beyond this side of the list's */
        side = i < 3 ? 3 + k : k;
        part[side] = i < 3 ? l->lo[k] : l->hi[k];
        if (part[k] < part[3 + k] &&
            !excludes_box(s, &s->filter, part, part + 3, 0.0))
            return 0;
        part[side] = root[side];
    }
    return 1;
}

/* ball_in_star_list - returns 1 if that part lies within the reach of the star
 * list about the base.  For a point u of the true ball, seen from the base,
 *     |u|^2 <= 2 (c.u + dc |u|) <= 2 (a + dc) |u| + 2 b,
 * where a is the length of c without its coordinate k, and b >= 0 is the
 * greatest value of c[k] u[k] in the root's box.  So |u| is less than reach if
 * reach (reach - 2 a - 2 dc) >= 2 b.  The test puts reach - 2 dc for the first
 * factor, too.  ROUNDING times reach exceeds the roundings of a, b and the
 * products. */
static int ball_in_star_list(const mesher *m, const search *s)
{
    const double *root = m->box + 6, *c = s->filter.c;
    double margin =
        m->lists.star.reach * (1.0 - ROUNDING) - 2.0 * s->filter.dc;
    double xx = c[0] * c[0], yy = c[1] * c[1], zz = c[2] * c[2], a, b;
    int k;

    if (margin <= 0.0) return 0;
    if (4.0 * (xx + yy + zz) <= margin * margin) return 1;
    for (k = 0; k < 3; k++) {
        b = larger((root[k] - s->hh[HH_BASE + k]) * c[k],
                   (root[3 + k] - s->hh[HH_BASE + k]) * c[k]);
        a = sqrt(k == 0 ? yy + zz : k == 1 ? xx + zz : xx + yy);
        if (margin * (margin - 2.0 * a) >= 2.0 * b) return 1;
    }
    return 0;
}

/* list_filter - computes the filter of a search for a list's points, in the
 * list's units: a point of the list can be in the ball only if
 *     norm2 - (d[0] x + d[1] y + d[2] z) < d[3].
 * With g = base - origin, the power of u is
 *     |u-g|^2 - 2c.(u-g) = |u|^2 - 2(c+g).u + (g+2c).g.
 * d[3] has room for dc, and for all rounding:
 *   single precision, where |u[i]| <= max_abs[i] (1.1 for a star list, whose g
 *     is 0, else at most 1; but twice as much for boxes a few last places wide,
 *     whose origin is rounded by as much): |u|^2 <= 12 by at most 8 roundings,
 *     two of them of u itself and the last that of the difference; d.u by at
 *     most 6 of each term; d[3] itself;
 *   double precision, with a the sum of |g| + |2c|: 8 roundings of the products
 *     with g, of |g| a; in d 2 of |2c| and 3 of |2g|; LIST_SHIFT, of u at most
 *     2^-50 = 4 EPS, times |d|; of d far below FEPS: less than 16 (1 + |g|) a
 *     (list_filter.g of the bounds).
 * Returns 0 when the ball is too large for single precision: the limits keep
 * sums from overflow, and points at LEFT_LIST outside. */
static int list_filter(const candidate_list *l, const search *s, float *d)
{
    double g, cu[3], k = 0.0, sum = 0.0, off = 0.0, a = 0.0;
    int i;

    for (i = 0; i < 3; i++) {
        g = (s->hh[HH_BASE + i] - l->origin[i]) * l->scale;
        cu[i] = 2.0 * s->filter.c[i] * l->scale;
        k += g * (g + cu[i]);
        off += fabs(g);
        a += fabs(g) + fabs(cu[i]);
        cu[i] += 2.0 * g;
        sum += fabs(cu[i]) * l->max_abs[i];
    }
    if (sum > 1e6 || a + 2.0 * s->filter.dc * l->scale > 5e8) return 0;
    for (i = 0; i < 3; i++) d[i] = to_single(cu[i]);
    d[3] = (float)((double)FEPS * (128.0 + 16.0 * sum + 4.0 * fabs(k)) +
                   16.0 * EPS * (1.0 + off) * a +
                   2.0 * s->filter.dc * l->scale * (4.0 + off) - k);
    return 1;
}

/* list_hits - finds the places of the points of a list that pass list_filter's
 * test.  Returns their number; 0 if there are at most four, the vertices of the
 * facet and the best point, which are on the ball; -1 if the ball is too large
 * for the list.
 *
 * All four pass a test of a list that holds the ball: the ball passes through
 * them, the facet is open and the best point is uncompleted, so none is
 * complete.  Of a list that does not hold the ball some may be missing, and 0
 * may be wrong, but the search goes on.  In incident_tet vertices may be
 * complete: it drops all lists. */
static int list_hits(const candidate_list *l, const search *s, int *place)
{
    float d[4];
    int in[TESS_LIST], i, n = 0, length = (l->n + 3) / 4 * 4;

    if (!list_filter(l, s, d)) return -1;
    COUNT(N_LIST, l->n);
    for (i = 0; i < length; i++) {
        in[i] =
            l->norm2[i] - (d[0] * l->x[i] + d[1] * l->y[i] + d[2] * l->z[i]) <
            d[3];
        n += in[i];
    }
    return n > 4 ? pick_indices(in, l->n, place) : 0;
}

/* offer_list - offers the points of a list that may be in the ball.  Returns
 * what list_hits does. */
static int offer_list(mesher *m, search *s, const candidate_list *l)
{
    int place[TESS_LIST + 1], n = list_hits(l, s, place), i;
    tess_int z;

    for (i = 0; i < n; i++) {
        z = l->position[place[i]];
        if (m->edge_from[z] != COMPLETE) offer_point(m, s, z);
    }
    return n;
}

/* search_star_list - seeks the apex in the star list.  On the open side, and no
 * other counts, the ball of a better point is part of the ball before it (Lemma
 * 3); so one pass over the list is enough if the last ball lies within its
 * reach.  Returns 1 if it does.  Without a ball every point would pass; on the
 * faces of a cube each would need an exact side, which would take twice as
 * long. */
static int search_star_list(mesher *m, search *s)
{
    int n;

    if (!s->in_lists || s->base != 0 || m->lists.star.n == 0 || !s->has_ball)
        return 0;
    if (m->lists.star_tied && record_set(m, s))
        s->best = apex_from_set(m, s->facet);
    else {
        n = offer_list(m, s, &m->lists.star);
        if (n < 0) return 0;
        if (n > 0) {
            if (s->ties > 0 && !m->lists.star_tied) (void)record_set(m, s);
            m->lists.star_tied = s->ties > 0;
        }
        if (!ball_in_star_list(m, s)) return 0;
        HOLDS(complete4(s, &m->lists.star));
    }
    COUNT(N_STAR, 1);
    m->lists.block_misses = 0;
    if (m->lists.block_ties <= TIED_SEARCHES) m->lists.block_ties = 0;
    return 1;
}

/* search_block_list - seeks the apex in the block list.  If the ball leaves the
 * block's box, the tree is searched in any case and the list would only add
 * cost: on surfaces, two fifths of the points tested. */
static int search_block_list(mesher *m, search *s)
{
    if (!s->in_lists || m->lists.block.n == 0 || !s->has_ball ||
        !ball_in_block(m, s, &m->lists.block) ||
        offer_list(m, s, &m->lists.block) < 0) {
        if (m->lists.block_misses < MAX_BLOCK_MISSES) m->lists.block_misses++;
        return 0;
    }
    HOLDS(complete4(s, &m->lists.block));
    COUNT(N_BLOCK, 1);
    m->lists.block_misses = 0;
    if (s->ties > 0 && m->lists.block_ties <= TIED_SEARCHES)
        m->lists.block_ties++;
    return 1;
}
#endif /* lists */

/* ---- near lists ----
 *
 * FOR surfaces and curves, on which most searches begin with the final ball,
 * and the next ball is nearly the same: without them terrain takes 1.31 times
 * the instructions.
 *
 * IDEA.  What costs is to prove a ball empty.  So the points in the ball of a
 * search, and in a skin about it, are kept; a search whose ball lies inside
 * offers these alone.  Lists that are not used again would cost up to 1.4 times
 * the instructions, so a budget pays for them.
 *
 *   near list         the uncompleted points in the ball of an earlier search,
 *                     or in its skin
 *   skin              a layer about a ball, so that the next ball fits, too
 *   budget            what near lists have saved, in nodes of the tree
 *
 * HOOKS: COLLECTS and collect_leaf, while search_tree makes a list; the stage
 * search_near_lists; refill_budget.  tet_in_mesh calls ball_is_empty.
 * STATE: nears, in mesher and in search.
 * INVARIANTS.  A near list with n > 0 has all points that are uncompleted and
 * within reach of its centre; recency is a permutation of the lists. */

#ifndef TESS_NO_NEAR_LISTS

/* The skin of a near list adapts.  It becomes SKIN_SHRINK times as thick while
 * the list exceeds TESS_LIST, down to SKIN_MIN.  If the list holds fewer than
 * SKIN_GROW_BELOW points, that of the next list is SKIN_GROW times as thick, up
 * to SKIN_MAX, a bound for lists of few points.  They trade lists made against
 * points in each. */
#define SKIN_SHRINK 0.4
#define SKIN_GROW 1.3
#define SKIN_MIN 0.05
#define SKIN_MAX 8.0
#define SKIN_GROW_BELOW (TESS_LIST * 2 / 5)
/* A ball whose centre is farther than this gets no near list: single precision
 * hardly tells it from a half-space.  Powers, which a list keeps while it is
 * made, cannot overflow: correctness rests on that. */
#define NEAR_BALL_MAX 1e4
/* The budget of near lists, counted in nodes of the tree: lists are made only
 * while they have saved more than they cost.  To look for a list costs 1; to
 * make one costs 30, and 1.75 for each node visited.  A search that ends in a
 * list earns what searches in the tree take on average, less 4, and less 1/2
 * for each point offered.  When the budget is used up, no near list is looked
 * for or made until refills bring it to BUDGET_START: one part in BUDGET_REFILL
 * of the nodes of later tree searches. */
#define BUDGET_REFILL 64.0
#define BUDGET_START 500.0

/* ball_in_near_list - returns 1 if the points that may be better than the best
 * one, those of its ball that are on the open side, lie inside a near list's
 * ball.
 *
 * All balls about centres c0 + h v, v the facet's normal, pass through its
 * vertices; on the open side each contains those of lower h.  So any h >= L
 * will do, and for L <= 0 the best is that of the foot of the list's centre on
 * the axis.  Let u lead from the list's centre to c = c0 + h v, and p from c to
 * such a point: |p|^2 <= r^2 = |c|^2, relative to the base.  For the ball of L
 * itself, |p.u| <= r |u|.  For h > L, u is across the axis; if L <= 0 no point
 * of the ball's part on the open side is farther from the axis than rho, so
 * |p.u| <= rho |u|.  The distance from the list's centre is at most reach if
 *     |u|^2 + r^2 + 2 r |u| <= reach^2, or with rho for the last r.
 *
 * Let err bound the error of c, as in set_upper_bound.  r and rho are wrong by
 * it, u by twice as much, but for EPS (1 + reach): centre and its distance to
 * the base have two roundings.  Where u is across, u.v is wrong by E (r + |u|)
 * more, and E r <= err, as dc > E rho.  As r, rho and |u| are at most reach,
 * all that is less than 24 err reach.  ROUNDING exceeds the other roundings,
 * and those of make_near_list. */
static int ball_in_near_list(const search *s, const candidate_list *l)
{
    double g[3], c, h, err, rr = 0.0, uu = 0.0, size = 0.0, gap;
    int k;

    if (l->n == 0) return 0;
    minus(l->centre, s->hh + HH_BASE, g);
    h = dot(g, s->hh);
    if (s->hi > 0.0 || h < s->hi) h = s->hi;
    for (k = 0; k < 3; k++) {
        c = s->hh[HH_CENTRE + k] + h * s->hh[k];
        size += fabs(c);
        rr += c * c;
        uu += (c - g[k]) * (c - g[k]);
    }
    err = s->hh[HH_DC] + fabs(h) * s->hh[HH_E] + 4.0 * EPS * size;
    gap = l->reach * (l->reach - 32.0 * err - ROUNDING * (1.0 + l->reach)) -
          rr - uu;
    if (h > s->hi) rr = s->hh[HH_RHO] * s->hh[HH_RHO];
    return gap > 0.0 && gap * gap >= 4.0 * rr * uu;
}

/* set_skin - sets the thickness of the skin about a search's ball, in reaches
 * of a block list; about larger balls it is thinner, as there are more points
 * in it.  The points in the skin pass the filter then. */
static void set_skin(const mesher *m, search *s)
{
    double r = sqrt(dot(s->filter.c, s->filter.c)),
           margin = m->lists.block.reach;

    s->nears.skin =
        s->nears.skin_factor *
        (r > margin ? margin * sqrt(margin / r) : margin);
    s->filter.allowance =
        s->nears.skin_factor < SKIN_MIN
            ? -L_MAX
            : s->nears.skin * (2.0 * r + s->nears.skin) + UNDERFLOW_ERR;
}

/* collect_leaf - puts points of a leaf into the list that a search makes: of n,
 * the first at position first, the uncompleted ones whose power is at most
 * most.  While they are too many, the skin shrinks: then those stay that still
 * pass the filter.  They are in the ball before, so |w|_1 is at most 4 times
 * its radius, and single precision changes a power by less than FEPS of it (or
 * to 0, where it would underflow: that passes in any case). */
static void collect_leaf(const mesher *m, search *s, tess_int first, int n,
                         const double *power, double most)
{
    candidate_list *l = s->nears.collect;
    int i;

    for (i = 0; i < n; i++) {
        l->position[l->n] = (tess_int)(first + i);
        l->norm2[l->n] =
            fabs(power[i]) < (double)FLT_MIN ? 0.0f : (float)power[i];
        l->n += (power[i] <= most) & (m->edge_from[first + i] != COMPLETE);
    }
    while (l->n > TESS_LIST) {
        s->nears.skin_factor *= SKIN_SHRINK;
        most = 8.0 * (sqrt(dot(s->filter.c, s->filter.c)) + s->nears.skin);
        set_skin(m, s);
        most = filter_bound(&s->filter, most) * (1.0 + 4.0 * (double)FEPS);
        n = l->n;
        for (i = l->n = 0; i < n; i++) {
            l->position[l->n] = l->position[i];
            l->norm2[l->n] = l->norm2[i];
            l->n += (double)l->norm2[i] <= most;
        }
    }
}

/* make_near_list - makes a near list of the ball of a search and a skin about
 * it, of points on either side of the facet.  Returns 0 if they are too many.
 *
 * What is nearer than reach, but for ball_in_near_list's ROUNDING, passes the
 * filter, so collect_leaf took it, and is in the box, so list_filter's bound
 * holds for it.  What is not may be in the list as well: no search that
 * ball_in_near_list admits needs it.  But filter_bound lets points pass that
 * are as far from a narrow ball as their leaf is wide.  As coordinates are at
 * most 1, their squares in the units of a box add up to 12e30 at most, unless
 * the box is narrower than 1e-15: single precision may not hold them then, so
 * these points are dropped. */
static int make_near_list(mesher *m, const search *s, candidate_list *l)
{
    search copy = *s;
    tess_int z;
    int i, k, n;

    COUNT(N_MADE, 1);
    l->n = 0;
    copy.nears.collect = l;
    copy.nears.skin_factor = m->nears.next_skin;
    set_skin(m, &copy);
    search_tree(m, &copy);
    m->nears.budget -= 30.0 + 1.75 * (double)copy.nodes;
    if (l->n == 0) return 0;
    m->nears.next_skin =
        l->n < SKIN_GROW_BELOW && copy.nears.skin_factor < SKIN_MAX
            ? SKIN_GROW * copy.nears.skin_factor
            : copy.nears.skin_factor;
    l->reach = sqrt(dot(copy.filter.c, copy.filter.c)) + copy.nears.skin;
    for (k = 0; k < 3; k++)
        l->centre[k] = copy.hh[HH_BASE + k] + copy.filter.c[k];
    if (set_list_box(m, l, l->centre, l->centre) < 1e-15)
        for (n = l->n, l->n = i = 0; i < n; i++) {
            z = l->position[l->n] = l->position[i];
            l->n += !boxes_disjoint(l->lo, l->hi, m->x + 3 * z, m->x + 3 * z);
        }
    fill_list(m, l);
    return 1;
}

/* search_near_lists - seeks the apex in a near list, which is made if there is
 * none that holds the ball.  No list is made for L <= 0, as half of the ball is
 * on the other side or more, nor for a ball that single precision cannot tell
 * from a half-space. */
static int search_near_lists(mesher *m, search *s)
{
    int n, k = -1, found;
    candidate_list *l;

    s->nears.pays = s->has_ball && s->hi <= L_MAX &&
              !HAS_SURFACE(s) && m->lists.block.reach > 0.0;
    if (m->nears.budget <= 0.0 || m->nears.budget > BUDGET_START)
        m->nears.paused = m->nears.budget <= 0.0;
    if (!s->nears.pays || m->nears.paused) return 0;
    m->nears.budget -= 1.0;
    do {
        l = m->nears.list + m->nears.recency[++k];
        found = ball_in_near_list(s, l);
    } while (!found && k < NEAR_LISTS - 1);
    if (!found &&
        (s->hi <= 0.0 || s->filter.c1 > NEAR_BALL_MAX || HAS_CAP(s) ||
         !make_near_list(m, s, l) || !ball_in_near_list(s, l)))
        return 0;
    for (; k > 0; k--) {
        m->nears.recency[k] = m->nears.recency[k - 1];
        m->nears.recency[k - 1] = (int)(l - m->nears.list);
    }
    HOLDS(listed(m, s, l));
    HOLDS(complete4(s, l));
    n = offer_list(m, s, l);
    if (found && n >= 0) {
        COUNT(N_NEAR, 1);
        m->nears.budget += m->nears.tree_cost - 4.0 - 0.5 * n;
    }
    return n >= 0;
}

/* refill_budget - adds to the budget of near lists for a search of the tree, if
 * a near list might have taken its place. */
static void refill_budget(mesher *m, const search *s)
{
    if (!s->nears.pays || HAS_CAP(s)) return;
    m->nears.budget += (double)s->nodes / BUDGET_REFILL;
    m->nears.tree_cost += ((double)s->nodes - m->nears.tree_cost) / 16.0;
}

/* ball_is_empty - returns 1 if no point is in the ball of the tetrahedron u,
 * positively oriented, 0 if one is; UNSURE if there are too many to look at, or
 * the ball has no good bound.  They are collected as for a near list without a
 * skin, on either side of the facet, but as positions alone: the star list
 * serves as scratch and is none afterwards. */
static int ball_is_empty(mesher *m, const tess_int *u)
{
    candidate_list *l = &m->lists.star;
    tess_int guess[2];
    search s;
    int k, n;

    guess[0] = u[3];
    guess[1] = NONE;
    search_begin(m, &s, u, guess);
    if (!s.has_ball || s.filter.c1 > NEAR_BALL_MAX || s.lo <= -NEAR_BALL_MAX)
        return UNSURE;
    /* behind the facet the ball of s.hi is within that of u */
    s.filter.dc += (s.hi - s.lo) * (1.0 + ROUNDING);
    s.by_limbs = 0;
    BEGIN_SURFACE(&s);
    s.nears.collect = l;
    s.nears.skin_factor = 1.0;
    m->lists.block.reach = 0.0;
    l->n = 0;
    set_skin(m, &s);
    search_tree(m, &s);
    n = l->n;
    l->n = 0;
    for (k = 0; k < n; k++)
        if (l->position[k] != u[0] && l->position[k] != u[1] &&
            l->position[k] != u[2] && l->position[k] != u[3] &&
            hh_pinsphere(&m->points, u, u[3], l->position[k], 1) < 0)
            return 0;
    return n > 0 ? 1 : UNSURE;
}
#endif /* near lists */

/* ---- hull planes ----
 *
 * FOR hulls with large flat faces: without them 5,000 points on the surface of
 * a cube take 10 times the instructions, on a prism of six faces 39 times, in a
 * lattice 2.9 times.
 *
 * IDEA.  No search takes longer than one for a hull facet: it has no ball, and
 * the side of every point in the facet's plane is decided exactly.  Where many
 * points lie exactly in a few planes (faces of a part, masts, stations at many
 * times) there are very many such facets, and time is quadratic.  But one
 * search without an apex settles all facets in its plane: three exact sides
 * tell that a facet is one of them.
 *
 * Stars come in the order of the tree, which on a long part runs round it, so
 * that the next plane needed is the one that was used longest ago: the planes
 * must all be kept, or none serves.  20,000 points on a prism of 6 or 12 faces
 * take 6 times as long with 4 planes as with 64, those of 20 stations 60 times.
 *
 * hull.plane begins with the planes that have served, the latest first; the
 * others follow, again the latest first.  When it is full, the last of those
 * that never served goes, or if all have served the last of these.  On an
 * ellipsoid no plane ever serves, and 64 of them would take half as much time
 * again; so after VAIN_LOOKS_MAX looks in vain in a row each plane that is met
 * replaces all others, until one serves again.
 *
 *   hull plane        the plane of a facet without an apex
 *
 * HOOKS: the stage on_hull_plane; note_hull_plane.
 * STATE: hull, in mesher, emptied by drop_stages, on which incident_tet of part
 * III rests.
 * INVARIANT.  All points that are uncompleted are in each plane or on its inner
 * side, as long as none becomes uncompleted again: see drop_stages. */

#ifndef TESS_NO_HULL_PLANES

/* Number of facets in a row, in none of the hull planes, after which the planes
 * are dropped.  With 64, 3,000 points in layers take 4 % longer, as each side
 * needs limbs; with 8 nothing changes. */
#define VAIN_LOOKS_MAX 16

/* put_hull_plane - moves the hull planes at places to ... from-1 one place up,
 * and puts that of the facet v at place to. */
static void put_hull_plane(mesher *m, const tess_int *v, int from, int to)
{
    int k;

    for (; from >= to; from--)
        for (k = 0; k < 3; k++)
            m->hull.plane[from][k] =
                from > to ? m->hull.plane[from - 1][k] : v[k];
}

/* on_hull_plane - returns 1 if the facet has no best point and lies in a plane
 * known to bound the hull, and so has no apex, as its open side is outwards:
 * that of a facet of a known tetrahedron is.  A seed edge may be open inwards,
 * but is searched before any plane is met: at first, or after incident_tet has
 * dropped them.  (A facet on a sphere is not sought among planes.) */
static int on_hull_plane(mesher *m, const search *s)
{
    const tess_int *h = m->hull.plane[0];
    int i, k;

    if (!s->in_lists || s->best != NONE) return 0;
    for (i = 0; i < m->hull.kept; i++, h += 3) {
        for (k = 0; k < 3; k++)
            if (s->facet[k] != h[0] && s->facet[k] != h[1] &&
                s->facet[k] != h[2] &&
                hh_porient(&m->points, h[0], h[1], h[2], s->facet[k]) != 0)
                break;
        if (k < 3) continue;
        put_hull_plane(m, s->facet, i, 0);
        m->hull.served += i >= m->hull.served;
        m->hull.vain_looks = 0;
        return 1;
    }
    m->hull.vain_looks += m->hull.vain_looks < VAIN_LOOKS_MAX;
    return 0;
}

/* note_hull_plane - keeps the plane of the facet if it has no apex, unless it
 * is on a sphere. */
static void note_hull_plane(mesher *m, const search *s)
{
    if (!s->in_lists || s->best != NONE) return;
    COUNT(N_HULL, 1);
    if (m->hull.vain_looks == VAIN_LOOKS_MAX) m->hull.kept = m->hull.served = 0;
    if (m->hull.served == HULL_PLANES) m->hull.served--;
    if (m->hull.kept < HULL_PLANES) m->hull.kept++;
    put_hull_plane(m, s->facet, m->hull.kept - 1, m->hull.served);
}
#endif /* hull planes */

/* ---- ties: cospherical sets ----
 *
 * FOR lattices and other points with many exactly on one empty sphere: without
 * them a lattice takes 1.5 times the instructions.  What has no ties never
 * makes a set.
 *
 * IDEA.  Among points of one empty sphere the tie rule alone decides, and its
 * outcome is known: all are joined to the one of least number.  So the points
 * of the sphere are found once in a star, and the apex of a facet with two of
 * them follows by a few exact sides.
 *
 *   cospherical set   the uncompleted points exactly on one empty ball's sphere
 *
 * Let T be the points on the sphere of an empty ball, such as that of any
 * tetrahedron of the mesh.  The tie rule (see hhpred.c) lowers heights, that of
 * first, the point of T of least number, by far the most.  So
 *   - among points of T the mesh consists of the facets of T's hull without
 *     first, each joined to first;
 *   - a tetrahedron with its vertices in T has first for one of them: first is
 *     the least vertex of any such tetrahedron that is known;
 *   - a facet of three points of T without first, which is in T's hull, has no
 *     point of T on its open side unless first is on it: the apex is first, or
 *     none of T;
 *   - a facet (first, a, b) with points of T on its open side has one of them
 *     as its apex, as the ball is empty.  Of two, c and z, z is better if it is
 *     beyond the plane (a, b, c) seen from first, and worse if it is on first's
 *     side; in that plane the lesser e_i of the rule decide.
 * A point of T whose star is complete is in no open facet and is no apex.  If
 * first's star is complete, all tetrahedra of T are known; so for a new
 * tetrahedron's T it is not.
 *
 * A cospherical set has all uncompleted points of T, the least number first, of
 * a ball inside the star list.  Only these are tested for a facet of the star.
 *
 * HOOKS: apex_from_set; record_set, which search_star_list calls.
 * STATE: sets, in mesher.
 * INVARIANT.  A set is complete: it has all uncompleted points of its sphere,
 * and the ball is empty. */

#ifndef TESS_NO_SETS

/* record_set - records a cospherical set, the points exactly on the best
 * point's ball, if all are in the star list and none is inside.  Returns 0 if
 * not, or if there are no ties.  filter.dc does not count hi - lo, as better
 * points are on the positive side; here points on both sides count, so it is
 * added. */
static int record_set(mesher *m, search *s)
{
    const candidate_list *l = &m->lists.star;
    const tess_int *v = s->facet;
    int place[TESS_LIST + 1], n, i, side;
    double wide, dc = s->filter.dc;
    tess_int z;
    cospherical_set c;

    if (fabs(s->hi) > L_MAX) return 0;
    /* (lo may be -DBL_MAX) */
    wide = s->by_limbs ? 0.0 : s->hi - larger(s->lo, -L_MAX);
    if (wide > l->reach) return 0;
    s->filter.dc = dc + wide;
    n = ball_in_star_list(m, s) ? list_hits(l, s, place) : 0;
    s->filter.dc = dc;
    if (n <= 0 || n > SET_POINTS) return 0;
    for (i = c.n = 0; i < n; i++) {
        z = l->position[place[i]];
        side = 0;
        if (z != v[0] && z != v[1] && z != v[2] && z != s->best)
            side = hh_pinsphere(&m->points, v, s->best, z, 0);
        if (side < 0) return 0;
        if (side > 0) continue;
        c.position[c.n++] = z;
        if (m->order[z] > m->order[c.position[0]]) continue;
        c.position[c.n - 1] = c.position[0];
        c.position[0] = z;
    }
    if (c.n == 4) return 0;
    m->sets.set[m->sets.recorded++ % SETS] = c;
    return 1;
}

/* apex_from_set - returns the apex of the facet v if it is in a cospherical
 * set, or NONE: see "ties". */
static tess_int apex_from_set(const mesher *m, const tess_int *v)
{
    const cospherical_set *c = m->sets.set;
    tess_int best = NONE, z;
    int i, k, in;

    for (k = 0; k < m->sets.recorded && k < SETS && best == NONE; k++, c++) {
        for (i = in = 0; i < c->n; i++)
            in += (c->position[i] == v[1]) + (c->position[i] == v[2]);
        for (i = 0; i < c->n && in == 2; i++) {
            z = c->position[i];
            if (z == v[0] || z == v[1] || z == v[2]) continue;
            if (hh_porient(&m->points, v[0], v[1], v[2], z) > 0 &&
                (best == NONE || hh_pinsphere(&m->points, v, best, z, 3) < 0))
                best = z;
            if (i == 0) break;
        }
    }
    return best;
}
#endif /* cospherical sets */

/* ---- cylinders ----
 *
 * FOR smooth surfaces and curves: without them points near a plane take 5.3
 * times the instructions.  They cost 11 doubles a leaf, and clouds 1 % more
 * instructions, for nothing.
 *
 * IDEA.  On a smooth surface a box sticks out of the surface by as much as it
 * is wide, so a ball that touches the surface meets many boxes.  Along a curve
 * a box is as wide as it is long.  A cylinder that holds a node's points (a
 * disc on a surface, a rod on a curve) is thinner, by the ratio of the node's
 * width to the radius of curvature, and the ball meets only a few of them,
 * however many there are.  Cylinders are made for the nodes of every second
 * level from the leaves up.  The four grandchildren of a node lie side by side
 * and are tested at once.
 *
 *   cylinder          a second bounding volume, of nodes of every second level
 *
 * HOOKS: make_cylinders; push_fours, where search_tree goes by two levels.
 * STATE: cylinders, in mesher; in rw the cylinders themselves, see
 * cylinders_of.
 * INVARIANT.  If made is 1, each node of those levels has one, and all its
 * points are in it. */

#ifndef TESS_NO_CYLINDERS

/* A cylinder is slender if its volume is below so much of its box's.  None are
 * used if fewer than one leaf of 64 has a slender one: clouds would pay 1 %. */
#define SLENDER_VOLUME 0.7

/* cylinders_of - returns the cylinders of the four grandchildren of a node:
 * centre, unit axis, half length, radius.  The four values of each number are
 * adjacent. */
static double *cylinders_of(const mesher *m, tess_int node)
{
    tess_int level = m->leaves / 4, at = 0;

    for (; node < level; level /= 4) at += level;
    return m->box + 12 * m->leaves + 32 * (at + node - level);
}

/* make_cylinder - makes the cylinder of a node, its numbers four places apart.
 * The axis is the column of the greatest diagonal element in the matrix of
 * second moments about the mean (a rod) or in its adjugate (a disc), whichever
 * gives less volume.  (Moments about another point than the mean would not tell
 * the normal of a plane.)  Returns 1 if that volume is below SLENDER_VOLUME of
 * the box's.  In units of the sum of |x[k]|, the differences from the mean err
 * by EPS, their products with the axis and what is left across it by less than
 * 40 EPS, the centre by 10 EPS: together less than 64 EPS. */
static int make_cylinder(const mesher *m, tess_int node, double *c)
{
    const double *b = m->box + 6 * node, *x;
    double a[3][3] = {{0.0}}, q[3][3], mid[3] = {0.0}, y[3], u[3];
    double lo, hi, s, rr, pad = 0.0, volume = DBL_MAX;
    tess_int first, last, i;
    int disc, j, k;

    node_range(m, node, &first, &last);
    for (k = 0; k < 3; k++)
        pad += 64.0 * EPS * (fabs(b[k]) + fabs(b[3 + k])) + HH_LENGTH_MIN;
    for (i = first; i < last; i++)
        for (k = 0; k < 3; k++)
            mid[k] += m->x[3 * i + k] / (double)(last - first);
    for (i = first, x = m->x + 3 * i; i < last; i++, x += 3) {
        minus(x, mid, y);
        for (k = 0; k < 3; k++)
            for (j = 0; j < 3; j++) a[k][j] += y[k] * y[j];
    }
    for (disc = 0; disc < 2; disc++) {
        for (k = 0; k < 3; k++)
            for (j = 0; j < 3; j++)
                q[k][j] =
                    disc ? a[(k + 1) % 3][(j + 1) % 3] *
                                   a[(k + 2) % 3][(j + 2) % 3] -
                               a[(k + 1) % 3][(j + 2) % 3] *
                                   a[(k + 2) % 3][(j + 1) % 3]
                         : a[k][j];
        j = q[1][1] > q[0][0];
        if (q[2][2] > q[j][j]) j = 2;
        s = dot(q[j], q[j]);
        for (k = 0; k < 3; k++) /* any direction, if too small to have one */
            u[k] = s > UNDERFLOW_ERR ? q[j][k] / sqrt(s) : k == 0;
        lo = DBL_MAX;
        hi = -DBL_MAX;
        rr = 0.0;
        for (i = first, x = m->x + 3 * i; i < last; i++, x += 3) {
            minus(x, mid, y);
            s = dot(y, u);
            lo = lesser(lo, s);
            hi = larger(hi, s);
            for (k = 0; k < 3; k++) y[k] -= s * u[k];
            rr = larger(rr, dot(y, y));
        }
        if ((hi - lo) * rr >= volume) continue;
        volume = (hi - lo) * rr;
        for (k = 0; k < 3; k++) {
            c[4 * k] = mid[k] + 0.5 * (lo + hi) * u[k];
            c[12 + 4 * k] = u[k];
        }
        c[24] = 0.5 * (hi - lo) + pad;
        c[28] = sqrt(rr) + pad;
    }
    return 3.2 * volume <
           SLENDER_VOLUME * (b[3] - b[0]) * (b[4] - b[1]) * (b[5] - b[2]);
}

/* make_cylinders - makes all cylinders, or none if few of them are slender. */
static void make_cylinders(mesher *m)
{
    tess_int level, node, slender = 0;
    int i;

    for (level = m->leaves / 4; level > 0; level /= 4) {
        for (node = level; node < 2 * level; node++)
            for (i = 0; i < 4; i++)
                if (make_cylinder(m, (tess_int)(4 * node + i),
                                  cylinders_of(m, node) + i))
                    slender++;
        if (64 * slender < m->leaves) return;
    }
    m->cylinders.made = 1;
}

/* exclude_cylinders - tests the cylinders of a node's four grandchildren:
 * past[i] > 0 if cylinder i provably holds no better point.
 *
 * A point is w + s u + p from the base, where w is the cylinder's centre, u its
 * axis, |s| <= h, and p is across u, |p| <= r.  With g = w - c, a = |g.u|, and
 * rho the length of g across u, its power in the ball about c is
 *     |w|^2 - 2 c.w + (s^2 + 2 s g.u) + (|p|^2 + 2 g.p).
 * The brackets are at least t (t - 2 a), where t is the lesser of a and h, and
 * R^2 - 2 R rho, where R is the lesser of rho and r.  So there is no better
 * point if the sum without 2 R rho is positive and its square is above 4 R^2
 * rho^2.
 *
 * The sum errs by less than 64 EPS size (size + 2 |c|), size >= |w|_1 + h + r.
 * In EPS: w errs by |w|, which counts twice in the power, and with that of g in
 * rho makes 4; the power by 8 (filter_bound); a by 6 |g|_1, which counts 2 t
 * times; |u|^2 is 1 but for 8, which tilts p: 9; and some for the sum.  rho^2
 * errs by less than 64 EPS |g|^2, with room for the last two products: these
 * are rounded alike, or if one is contracted, the other one loses 1 EPS, or by
 * underflow less than past can be.  Where squares underflow, r >= HH_LENGTH_MIN
 * makes the sum's error greater. */
static void exclude_cylinders(const mesher *m, const search *s, tess_int node,
                              double *past)
{
    const double *c = cylinders_of(m, node);
    const ball_filter *b = &s->filter;
    double b0 = s->hh[HH_BASE], b1 = s->hh[HH_BASE + 1],
           b2 = s->hh[HH_BASE + 2];
    double err = 2.0 * b->dc + 128.0 * EPS * b->c1, slack = b->allowance;
    double w0, w1, w2, g0, g1, g2, a, h, r, t, gg, rr, rho, size, sum;
    int i;

    for (i = 0; i < 4; i++) { /* as vectors */
        w0 = c[i] - b0;
        w1 = c[4 + i] - b1;
        w2 = c[8 + i] - b2;
        h = c[24 + i];
        r = c[28 + i];
        size = fabs(w0) + fabs(w1) + fabs(w2) + 2.0 * (h + r);
        g0 = w0 - b->c[0];
        g1 = w1 - b->c[1];
        g2 = w2 - b->c[2];
        a = fabs(g0 * c[12 + i] + g1 * c[16 + i] + g2 * c[20 + i]);
        t = lesser(a, h);
        gg = g0 * g0 + g1 * g1 + g2 * g2;
        rho = gg - a * a + 64.0 * EPS * gg;
        rr = lesser(rho, r * r);
        sum = w0 * (g0 - b->c[0]) + w1 * (g1 - b->c[1]) + w2 * (g2 - b->c[2]) +
              t * (t - 2.0 * a) + rr - size * (err + 64.0 * EPS * size) - slack;
        past[i] = sum * fabs(sum) - 4.0 * rr * rho;
    }
}

/* push_fours - pushes those of a node's four grandchildren, other than from,
 * that their cylinders do not exclude.  Returns the stack's new depth. */
static int push_fours(const mesher *m, const search *s, tess_int node,
                      tess_int from, tess_int *stack, int depth)
{
    double past[4];
    int i;

    COUNT(N_NODE, 4);
    exclude_cylinders(m, s, node, past);
    for (i = 3; i >= 0; i--)
        if (past[i] > 0.0) {
            HOLDS(barren(m, s, 4 * node + i));
        } else if (4 * node + i != from)
            stack[depth++] = (tess_int)(4 * node + i);
    return depth;
}
#endif /* cylinders */

/* ---- caps ----
 *
 * FOR points sampled on flat faces, which rounding has left a little off their
 * planes: without caps 50,000 on the faces of a box take 3.3 times the
 * instructions.  Other sets pay less than 1 %.
 *
 * IDEA.  Outside of a flat face the balls are nearly half-spaces.  Such a ball
 * meets all the boxes along the face's edges, as these stick out, though only
 * points near the facet can be in it.
 *
 *   supporting plane  one that has all points on one side of it, or in it
 *   cap               the part of a ball on the points' side of such a plane
 *
 * Let n.z <= h hold for all points z; with w = z - base, n.w <= t = h - n.base.
 * A better point satisfies |w|^2 - 2 c.w <= 0, so for any u >= 0
 *     |w|^2 - 2 (c - u n).w <= 2 u n.w <= 2 u t,
 * too.  With u = n.c that is a ball about the foot of c in the plane through
 * the base.  It holds the cap.  Where t is small it is much smaller than the
 * first ball, and only boxes near the facet meet it.  Nodes are tested against
 * both balls, as within the plane the second is the wider one; against that of
 * the cap first, so what it excludes the other might exclude, too.  A cap is
 * right for the smaller balls of the same search: their better points are in
 * that ball.
 *
 * Planes are sought perpendicular to c of a search that was long.  One plane a
 * face is not enough: rounding tilts small facets, and where c is far off the
 * foot in a plane of another tilt is far off, too.  Where the points do not lie
 * on flat faces about the hull, most planes are in vain: then there are soon
 * none to be tested.
 *
 * HOOKS: choose_cap when a search has gone past the lists, and when its ball
 * changes in the tree; OUTSIDE_CAP, where search_tree tests a node; seek_plane.
 * A search with a cap makes no near list, and adds nothing to their budget.
 * STATE: caps, in mesher, set by start_stages, and in search, by BEGIN_CAP.
 * INVARIANT.  Each plane has all points of the mesh on one side of it, or in
 * it, up to the rounding that choose_cap adds. */
#if !defined(TESS_NO_CAPS) || !defined(TESS_NO_LIMBS)

/* node_width - returns the sum of a box's extents. */
static double node_width(const double *b)
{
    return (b[3] - b[0]) + (b[4] - b[1]) + (b[5] - b[2]);
}
#endif

#ifndef TESS_NO_CAPS

/* Caps are for balls whose |c|_1 exceeds BIG_BALL times the width of the root's
 * box, and are of less radius than CAP_RADIUS times that.  A search of such a
 * ball is long if it visits CAP_NODES nodes or more.  A supporting plane is
 * sought once the nodes of long searches add up to CAP_LIMIT times the leaves;
 * each plane makes that limit CAP_GROWTH times as high, each failure doubles
 * it.  They trade passes over the points and tests against long searches: with
 * a CAP_LIMIT of 1 clouds take 1 % more instructions, with one of 16 50,000
 * points on the faces of a box a fifth more. */
#define BIG_BALL 0.5
#define CAP_RADIUS 0.25
#define CAP_NODES 64
#define CAP_LIMIT 4.0
#define CAP_GROWTH 1.05

/* choose_cap - gives the search the smallest cap of its ball, if that is not
 * too large.  The inequalities hold for n and u as they are, rounded; only what
 * is computed from them errs.  c - u n errs by EPS (2 u |n| + |c|), less than 4
 * EPS c1, and the sum with dc is rounded.  As no |x[k]| exceeds 1 nor |n|_1
 * 1.74, h, in units of EPS |n|_1, is too small by 3 for a product and 1 for the
 * store, n.base too large by 3, their difference too small by 2, what is added
 * to it costs 2, and 10 times 2 are lost by all further roundings, those of
 * filter_bound too: less than 64 EPS (cap.g of the bounds). */
static void choose_cap(const mesher *m, search *s)
{
    const ball_filter *b = &s->filter;
    double c[3], r, rr, u, slack;
    const double *n;
    int i, k;

    s->caps.found = 0;
    if (!s->has_ball || HAS_SURFACE(s)) return;
    r = CAP_RADIUS * node_width(m->box + 6);
    rr = r * r;
    for (i = 0; i < CAPS && i < m->caps.planes; i++) {
        n = m->caps.plane[i];
        u = dot(n, b->c);
        slack = 2.0 * u * (n[3] - dot(n, s->hh + HH_BASE) + 64.0 * EPS);
        for (k = 0; k < 3; k++) c[k] = b->c[k] - u * n[k];
        r = dot(c, c) + slack;
        if (u <= 0.0 || r >= rr) continue;
        rr = r;
        s->caps.found = 1;
        for (k = 0; k < 3; k++) s->caps.filter.c[k] = c[k];
        s->caps.filter.c1 = norm1(c);
        s->caps.filter.dc = b->dc + 8.0 * EPS * (b->c1 + b->dc);
        s->caps.filter.allowance = b->allowance + slack;
    }
}

/* seek_plane - counts the nodes of a long search, one of a ball large enough
 * for a cap.  When they are enough, it makes the supporting plane perpendicular
 * to c, and keeps it if the search has a cap now. */
static void seek_plane(mesher *m, search *s)
{
    double big, r, *n;
    const double *c = s->filter.c;
    tess_int i;
    int k;

    if (s->nodes < CAP_NODES || !s->has_ball || HAS_SURFACE(s)) return;
    big = BIG_BALL * node_width(m->box + 6);
    if (s->filter.c1 <= big) return;
    m->caps.long_nodes += (double)s->nodes / (double)m->leaves;
    if (m->caps.long_nodes < m->caps.enough) return;
    m->caps.long_nodes = 0.0;
    n = m->caps.plane[m->caps.planes++ % CAPS];
    r = sqrt(dot(c, c));
    for (k = 0; k < 3; k++) n[k] = c[k] / r;
    n[3] = dot(n, m->x);
    for (i = 1; i < m->np; i++) n[3] = larger(n[3], dot(n, m->x + 3 * i));
    choose_cap(m, s);
    m->caps.enough *= HAS_CAP(s) ? CAP_GROWTH : 2.0;
    if (HAS_CAP(s))
        m->caps.big_ball = big;
    else
        m->caps.planes--;
}
#endif /* caps */

/* ---- limbs, and views of clumps ----
 *
 * FOR points that doubles do not tell apart: without balls by limbs a turned
 * grid takes 2.9 times the instructions.
 *
 * IDEA.  Where the bounds of doubles leave a comparison undecided, a few
 * leading limbs decide it nearly always, in a tenth of the time of the exact
 * signs.  If many comparisons are hard, the ball itself is found by limbs, so
 * that fewer points pass the filter.  And where points are very unevenly far
 * from the base, as when some have a number for a missing coordinate (-3.4e38),
 * what is lost in the roundings of that distance is seen from a vertex that is
 * near.
 *
 *   hard              said of an undecided comparison that is no exact tie
 *   clump             a box that is very narrow beside the root's
 *   view              a test of a point or a box as seen from another point
 *                     than the base
 *
 * HOOKS: measure_clumps, excludes_clump; decide_by_limbs and note_comparison,
 * in compare_exactly; refine_ball.
 * STATE: limbs, in mesher and in search.
 * INVARIANTS.  While by_limbs is 1, filter is the ball of best by limbs, and
 * limbs.ball its limbs; outside_ball is not inside of it. */

#ifndef TESS_NO_LIMBS

/* The best point's ball is found by limbs if the error of its L-coordinate
 * exceeds BALL_ERR_MAX times L plus the circumradius (with 1e-4 a plane across
 * an axis, with noise of 1e-12, takes 5 times as long), or after
 * LIMB_BALL_AFTER comparisons by hh_relative.  An exact comparison that was no
 * tie counts as EXACT_COUNTS of these; most ties take no time, as their points
 * are the corners of a box.  They trade balls by limbs against exact signs. */
#define BALL_ERR_MAX 1.0
#define LIMB_BALL_AFTER 96
#define EXACT_COUNTS 16
/* A node is a clump if its box is narrower than CLUMP_WIDTH times the root's.
 * Among points 10 apart, coordinates of -1e10 are no reason for
 * excludes_by_view; with it those of -1e14 take 0.6 of the time, those of -1e18
 * a fiftieth.  With 1e-8, points of a sphere that crowd about a spot would be
 * clumps, get no reference sphere, and take twice as long. */
#define CLUMP_WIDTH 1e-12

/* measure_clumps - sets the width below which a box is a clump: CLUMP_WIDTH
 * times the root's, if 4 of 16 leaves are so narrow.  That is so where a
 * coordinate of many points is a number that stands for none, like -3.4e38;
 * else there are no clumps, and excludes_by_view costs nothing. */
static void measure_clumps(mesher *m)
{
    tess_int leaf;
    int k, n = 0;

    m->limbs.clump_width = CLUMP_WIDTH * node_width(m->box + 6);
    for (k = 0; k < 16; k++) {
        leaf = (tess_int)(m->leaves / 16 * k + m->leaves % 16 * k / 16);
        n += node_width(m->box + 6 * (m->leaves + leaf)) < m->limbs.clump_width;
    }
    if (n < 4) m->limbs.clump_width = 0.0;
}

/* ball_by_limbs - finds the ball of the best point by limbs.  The centre c errs
 * by at most 8 eps |c|.  So its height over the facet's plane, c.v, is L up to
 * the error of v, E |c|, the error of c, and the roundings of three products
 * and two sums, 5 eps |c|_1.  Near a sphere L is counted from hh[HH_CENTRE
 * ...]: u, the difference, takes the place of c, with the error of that centre
 * and one more rounding. */
static void ball_by_limbs(const mesher *m, search *s)
{
    ball_filter *b = &s->filter;
    double c[3], l = 0.0, u, size = 0.0, err;
    int k, sphere = HAS_SPHERE(m, s);

    COUNT(N_BALL, 1);
    if (s->hh[HH_E] == DBL_MAX ||
        !hh_centre(&m->points, s->facet, s->base, s->best, c, &s->limbs.ball))
        return;
    s->by_limbs = s->has_ball = 1;
    s->limbs.outside_ball = NONE;
    for (k = 0; k < 3; k++) {
        b->c[k] = c[k];
        u = c[k] - (sphere ? s->hh[HH_CENTRE + k] : 0.0);
        size += fabs(u);
        l += s->hh[k] * u;
    }
    b->c1 = norm1(c);
    b->dc = 8.0 * EPS * b->c1;
    err =
        s->hh[HH_E] * size + 16.0 * EPS * b->c1 + (sphere ? s->hh[HH_DC] : 0.0);
    if (s->hh[HH_E] <= HH_E_MAX && l - err > s->lo) s->lo = l - err;
    if (s->hh[HH_E] <= HH_E_MAX && l + err < s->hi) s->hi = l + err;
    if (HAS_SURFACE(s)) set_surface_filter(m, s);
}

/* excludes_by_view - tests the box lo, hi as seen from other points than the
 * base.  Returns -1 if it provably holds no better point, 1 if it is a point
 * that is certainly on the open side (of a wider box that tells nothing), else
 * 0.
 *
 * What is near another vertex has a side and a power that are lost in the
 * roundings of its distance from the base, where that is so much greater.  Seen
 * from that vertex, or from the best point, both are sums of small terms.  Let
 * p be a point whose power in the ball of centre c is known to be 0, or not
 * negative.  With u = z - p and d = c - p, both from the base, the power of z
 * is at least |u|^2 - 2 d.u.  So z is not better if that is positive: as in
 * excludes_box, the least sum in the box less its error.  Likewise for the side
 * of z if that of p is 0 or negative, with the product of the normal and u.
 *
 * Each coordinate of hh_centre's c is right to 8 eps of itself, and p to 1 eps:
 * d errs by 9 eps |c| + 2 eps |p|, which counts twice; u by eps |u|, which
 * counts for 2 eps (|u| + |d|); four roundings for 4 eps (|u| + 2 |d|).  All
 * that times |u| is less than 8 eps |u| (|u| + 4 (|c| + |p|)), coordinate by
 * coordinate: where points differ from p only in coordinates in which the ball
 * is small, they are told apart, however large it is in the others.  (4 |x|, x
 * being the coordinate itself, is for sums in another order.) */
static int excludes_by_view(const mesher *m, const search *s, const double *lo,
                            const double *hi)
{
    const double *c = s->filter.c, *v = s->hh, *x;
    double power, side, err, size, p, d, l, h, u;
    tess_int from[5];
    int i, k, sure = 0;

    from[0] = s->facet[(s->base + 1) % 3];
    from[1] = s->facet[(s->base + 2) % 3];
    from[2] = s->limbs.behind_facet;
    from[3] = s->by_limbs ? s->limbs.outside_ball : NONE;
    from[4] = s->by_limbs ? s->best : NONE;
    for (k = 0; k < 5; k++) {
        if (from[k] == NONE) continue;
        x = m->x + 3 * from[k];
        power = side = size = 0.0;
        err = UNDERFLOW_ERR;
        for (i = 0; i < 3; i++) {
            p = x[i] - v[HH_BASE + i];
            d = c[i] - p;
            l = lo[i] - x[i];
            h = hi[i] - x[i];
            u = lesser(larger(d, l), h);
            power += u * (u - 2.0 * d);
            side += larger(l * v[i], h * v[i]);
            u = larger(fabs(l), fabs(h));
            size += u;
            err +=
                8.0 * EPS * u * (u + 4.0 * (fabs(c[i]) + fabs(p) + fabs(x[i])));
        }
        if (k != 2 && s->by_limbs && power > err) return -1;
        if (k > 2 || s->hh[HH_E] > HH_E_MAX) continue;
        if (side < -s->hh[HH_E] * size - UNDERFLOW_ERR) return -1;
        if (k < 2 && side > s->hh[HH_E] * size + UNDERFLOW_ERR) sure = 1;
    }
    return sure;
}

/* excludes_clump - returns 1 if a box is a clump that holds no better point, as
 * seen from other points than the base. */
static int excludes_clump(const mesher *m, const search *s, const double *b)
{
    return !COLLECTS(s) && node_width(b) < m->limbs.clump_width &&
           excludes_by_view(m, s, b, b + 3) < 0;
}

/* refine_ball - finds the ball of the best point by limbs if that of doubles is
 * poor, or if many comparisons were hard.  side: that of a new best point; of
 * one that stays, UNSURE. */
static void refine_ball(mesher *m, search *s, int side)
{
    if (!s->by_limbs &&
        (side == 0 || s->limbs.hard_count >= LIMB_BALL_AFTER ||
         (side == 1 && s->hi - s->lo >
                           BALL_ERR_MAX * (s->hh[HH_RHO] + fabs(s->hi)))))
        ball_by_limbs(m, s);
}

/* decide_by_limbs - decides what it can of what is UNSURE, side or verdict,
 * before the exact signs do.  Among clumps z is seen from other points first.
 * Then comes hh_relative, unless determinants are exact in doubles or the last
 * exact comparison was a tie.  Without it rotated grids, whose boxes have their
 * corners on a sphere but for rounding, take 1.2 to 1.6 times the instructions.
 * Its sphere is that of z or of the best point, but not of a ball by limbs,
 * whose four points are nearly in a plane.  Last come the limbs of the ball, if
 * it was found by limbs.  Returns 1 if z is not better. */
static int decide_by_limbs(const mesher *m, search *s, tess_int z, double hi,
                           int *side, int *verdict)
{
    const double *x = m->x + 3 * z;
    int seen;

    if (HAS_CLUMPS(m) && (*side == UNSURE || s->by_limbs)) {
        seen = excludes_by_view(m, s, x, x);
        HOLDS(seen < 0
                  ? !better(m, s, z)
                  : seen == 0 || hh_porient(&m->points, s->facet[0],
                                            s->facet[1], s->facet[2], z) == 1);
        if (seen < 0) return 1;
        if (seen > 0) *side = 1;
    }
    if (*verdict == UNSURE && m->points.exact5 < 0.0 && !m->limbs.last_tied) {
        *verdict = hh_relative(&m->points, s->facet, s->base, s->hh,
                               *side == 1    ? hi
                               : s->by_limbs ? DBL_MAX
                                             : s->hi,
                               s->best, z, &s->limbs.near_sphere);
        COUNT(N_TRIAL, s->limbs.near_sphere.ready == 1);
        HOLDS(*verdict == UNSURE ||
              *verdict == hh_pinsphere(&m->points, s->facet, s->best, z, 0));
    }
    if (s->by_limbs) {
        COUNT(N_TRIAL, *verdict == UNSURE);
        hh_trial(&m->points, &s->limbs.ball, z, side, verdict);
        HOLDS(*verdict == LOSES
                  ? !better(m, s, z)
                  : *side == UNSURE ||
                        *side == hh_porient(&m->points, s->facet[0],
                                            s->facet[1], s->facet[2], z));
    }
    if (*verdict == LOSES) s->limbs.outside_ball = z;
    return 0;
}

/* note_comparison - keeps what a comparison with z has shown.  hard is 0 if
 * doubles decided the verdict, 1 if limbs did, 2 if the exact signs did. */
static void note_comparison(mesher *m, search *s, tess_int z, int side,
                            int verdict, int hard)
{
    if (side < 1) s->limbs.behind_facet = z;
    if (side != 1) return;
    if (hard == 2) {
        m->limbs.last_tied = verdict == HH_TIE || verdict == -HH_TIE;
        if (verdict > 0) s->limbs.outside_ball = z;
        hard = m->limbs.last_tied ? 0 : EXACT_COUNTS;
    }
    s->limbs.hard_count += hard;
}
#endif /* limbs */

/* ---- reference surfaces ----
 *
 * FOR points that are near one of a few planes or spheres, but for rounding:
 * globes, turned boxes, points near a plane.  Without them points near a tilted
 * plane take 17 times the instructions.  They cost a mark a point, two integers
 * a leaf for each, and a height by limbs for each point near them, once;
 * nothing until searches turn out to be long.
 *
 * IDEA.  Where many points are near one plane or sphere, the side or the power
 * of each is noise for a facet of three of them, and no box of points is clear
 * of the ball.  A reference surface is such a plane or sphere, through points.
 * Limbs give the heights of other points over it (over a sphere, their powers)
 * to some eps of themselves.  Heights are that noise, but known to 1e-7 of it:
 * so they decide, point by point and node by node.
 *
 * Let base_height be the height of the base of a facet near the surface, and
 * tilt the vector in the facet's plane whose products with the facet's edges
 * are the differences of heights.  Then
 *     G(w) = height(w) - base_height - tilt.w
 * is 0 at the facet's vertices.  On a plane, G(w) is therefore normal_height
 * times the side of w, normal_height being the height of the facet's normal v.
 * On a sphere whose centre is at height l over the facet's plane, G(w) is the
 * power of w in the ball of L = l, and L(w) = l + e, e = G(w) / (2 side).
 *
 *   reference surface    a plane or a sphere that many points are near
 *   height            over it: the signed distance, or the power, by limbs
 *   band              the heights that have a mark: those of points near it
 *   mark              a point's height in units of the surface's quantum
 *   tilt              the vector in the facet's plane that takes up the
 *                     different heights of its vertices
 *   surface filter    a filter with a term in the height
 *   sample            undecided points, from which a surface is fitted
 *
 * HOOKS: choose_surface, ball_on_surface, set_surface_filter when a search
 * begins or its ball changes; filter_of_mark and excludes_by_marks where points
 * and nodes are tested, sharpen_by_height where they are compared;
 * add_to_sample and seek_surface; room_for_marks.  Part III calls
 * survey_regions and surfaces_of_index.
 * STATE: surfaces and mark, in mesher; surface, in search, with weight and
 * base_height of its filter; in iw the marks.
 * INVARIANTS.  A search with a surface uses no near list, cylinder or cap, and
 * has two filters, each true by itself: the plain one, and the surface filter,
 * which serves what has a mark of that surface.  A mark is right to 3/2 quanta,
 * the range of a node's marks is that of all its points; all that a surface is
 * made of is in its record. */

#ifndef TESS_NO_SURFACES

/* Number of marks, the heights that a surface tells apart.  A double holds them
 * and their roundings, and tess_int 1 + SURFACES (MARKS + 1): correctness rests
 * on that. */
#define MARKS                                                         \
    ((tess_int)(DBL_MANT_DIG >= 53 && sizeof(tess_int) > 2 ? 134217728L \
                                                           : 2048L))
/* The ranges of marks.  mark_range[node] is RANGE_CODE(k, l): k and l are the
 * least and the greatest mark of the node's points, over MARKS_PER_STEP; k is
 * -1 if a point may be below lowest, l is RANGE_STEPS if one may be above
 * -lowest; RANGE_STEPS and -1 for k and l if all are.  (RANGE_STEPS + 2)^2 fits
 * tess_int: correctness rests on that. */
#define MARKS_PER_STEP ((tess_int)(MARKS > 2048 ? 4096L : 16L))
#define RANGE_STEPS (MARKS / MARKS_PER_STEP)
#define RANGE_CODE(k, l) ((tess_int)(((k) + 1) * (RANGE_STEPS + 2) + (l) + 1))
#define RANGE_LEAST(code) ((tess_int)((code) / (RANGE_STEPS + 2) - 1))
#define RANGE_MOST(code) ((tess_int)((code) % (RANGE_STEPS + 2) - 1))
/* A search counts as long if it offers more than SAMPLE_MIN points to its
 * sample.  A surface is sought once these offers add up to SAMPLE_LIMIT times
 * all points; each failure doubles that limit. */
#define SAMPLE_MIN (SAMPLE_SIZE * 3 / 4)
#define SAMPLE_LIMIT 1.0
/* A surface whose quantum is so many times smaller takes over the points that
 * another has marked: without that two sheets 1e-12 apart take 3.5 times as
 * long. */
#define FINER_BY 100.0
/* Half of the band about a surface, at most: of its extent for a plane, of the
 * extent's square for a sphere.  Beyond PLANE_BAND doubles decide the sides,
 * and cylinders do better: points near a plane that is rough by 1e-8 take two
 * thirds of the time without a surface, by 1e-9 as long, by 1e-10 twice as
 * long.  A sphere's band is wider, as cylinders do not tell its balls apart. */
#define PLANE_BAND 2e-8
#define SPHERE_BAND 1e-3
/* A sample narrower than this, beside its width, is on a line; thinner than
 * this it is in a plane, and no sphere is fitted. */
#define LINE_WIDTH 1e-6
#define PLANE_WIDTH 1e-7
/* A facet with a greater E, a sliver, has no surface: see choose_surface. */
#define SLIVER_E 1e-3
/* No surface is sought if exact5 of hh_set is at least this: coordinates are
 * then small multiples of one unit, and doubles compute determinants exactly,
 * so that heights would add nothing. */
#define EXACT_UNITS 16.0
/* tess_index seeks surfaces in the stars of up to REGIONS points, eight at a
 * time, with room for STARS tetrahedra (an array's length), and from a lower
 * limit, KEEN, as it does so for all parts.  They trade its time against the
 * surfaces that it finds. */
#define REGIONS 32
#define STARS 256
#define KEEN (SAMPLE_LIMIT / 256.0)
/* Whether surfaces can help: see EXACT_UNITS. */
#define SURFACES_PAY(m) ((m)->points.exact5 < EXACT_UNITS)

/* rounded_height - returns the height of the position z over a surface, in
 * double precision.  *err bounds its error: 6 roundings of a square and 5 of
 * twice a product with the centre, which is exact, as the surface is made of
 * it. */
static double rounded_height(const mesher *m, const ref_surface *r, tess_int z,
                           double *err)
{
    double h = 0.0, size = 0.0, spread = r->limbs.plane ? 1.0 : 0.0, u;
    int k;

    for (k = 0; k < 3; k++) {
        u = m->x[3 * z + k] - r->origin[k];
        h += u * (r->limbs.plane ? r->c[k] : u - 2.0 * r->c[k]);
        size += fabs(u);
        spread += r->limbs.plane ? 0.0 : fabs(u) + fabs(r->c[k]);
    }
    *err = 32.0 * EPS * size * spread + UNDERFLOW_ERR;
    return h;
}

/* marked_height - returns 1 if the position z has a mark of surface j; *h is
 * then its height, to a quantum.  The roundings of mark_leaf and the error of
 * the height shift a mark by less than 10 EPS MARKS quanta. */
static int marked_height(const mesher *m, int j, tess_int z, double *h)
{
    const ref_surface *r = m->surfaces.surface + j;
    tess_int k = (tess_int)(m->mark[z] - 1 - j);

    if (k < 0 || k % SURFACES != 0) return 0;
    k /= SURFACES;
    *h = r->lowest + r->quantum * ((double)k + 0.5);
    return 1;
}

/* height_over - returns 1 if the position z is near surface j; *h is then its
 * height, from its mark or else by limbs, and *err bounds the error. */
static int height_over(const mesher *m, int j, tess_int z, double *h,
                       double *err)
{
    const ref_surface *r = m->surfaces.surface + j;

    *err = r->quantum;
    if (marked_height(m, j, z, h)) return 1;
    *h = rounded_height(m, r, z, err);
    if (fabs(*h) > *err - r->lowest) return 0;
    *h = hh_height(&m->points, &r->limbs, z, err);
    return *err <= r->quantum && fabs(*h) <= -r->lowest;
}

/* facet_on_surface - returns 1 if the facet's vertices are near surface j; h
 * are their heights, the base's first, err the bounds on their errors. */
static int facet_on_surface(const mesher *m, const search *s, int j, double *h,
                            double *err)
{
    int k;

    for (k = 0; k < 3; k++)
        if (!height_over(m, j, s->facet[(s->base + k) % 3], h + k, err + k))
            return 0;
    return 1;
}

/* add_to_sample - adds z to the sample: undecided points or, until there are
 * any, first points of leaves that the search visited.  The sample keeps
 * SAMPLE_SIZE of them.  Once it is full, a point replaces another at random
 * (reservoir sampling: J. S. Vitter, ACM Trans. Math. Software 11, 1985,
 * 37-57), by numbers that are the same on every machine.  Points with a mark
 * count, too: they may be near a finer surface. */
static void add_to_sample(search *s, tess_int z, int open)
{
    tess_int place;

    if (s->surface.offered == 0 || open > s->surface.undecided) {
        s->surface.undecided = open;
        s->surface.offered = 0;
    }
    if (open < s->surface.undecided) return;
    place = s->surface.offered++;
    if (place >= SAMPLE_SIZE)
        place = (tess_int)(z % 30269L * 137 % 30269) % s->surface.offered;
    if (place < SAMPLE_SIZE) s->surface.sample[place] = z;
}

/* surface_record - returns surface j, with the place of its record.  Behind the
 * marks of the points each has RECORD integers, then the nodes' ranges of
 * marks, from node 1 on.  All that a surface is made of is in the record, so it
 * comes out alike in all rounding modes and builds: marks of one sphere say
 * nothing of another. */
static ref_surface *surface_record(mesher *m, int j)
{
    ref_surface *r = m->surfaces.surface + j;

    r->record = m->mark + m->np + j * (2 * m->leaves + RECORD - 1);
    r->mark_range = r->record + RECORD - 1;
    return r;
}

/* surface_from_record - sets up a surface from its record.  Returns 0 if limbs
 * do not hold it. */
static int surface_from_record(const mesher *m, ref_surface *surface)
{
    const tess_int *r = surface->record;
    int i, k;

    surface->quantum = ldexp(1.0, (int)r[RECORD_QUANTUM] - EXPONENT);
    surface->lowest = -0.5 * surface->quantum * (double)MARKS;
    surface->origin = m->x + 3 * r[RECORD_POINT];
    for (k = 0; k < 3; k++) {
        surface->c[k] = 0.0;
        for (i = DIGITS - 1; i >= 0; i--)
            surface->c[k] =
                (surface->c[k] + (double)r[RECORD_DIGITS + DIGITS * k + i]) /
                DIGIT;
        surface->c[k] = ldexp(surface->c[k], (int)r[RECORD_UNIT] - EXPONENT);
    }
    return hh_surface(&m->points, r[RECORD_POINT], r[RECORD_POINT],
                      (int)r[RECORD_PLANE], surface->c, &surface->limbs);
}

/* surface_through - sets up a surface, a plane or a sphere through the points
 * v, for a search's sample, of extent wide.  Any plane or sphere near the
 * points will do, so its normal or centre is the 52 leading bits of what
 * doubles hold; of hh_thin's facet the normal alone counts, so v[0] may be its
 * base.  Its band is 8 to 16 times the upper quartile of the sample's heights,
 * or the lower one if that is FINER_BY times less, but not 0: the points on one
 * of several near sheets.  (If a quarter of the heights are 0, the quantum
 * comes from the others: it only has to tell the sheets apart.)  Returns 0 if
 * the band is wider than PLANE_BAND or SPHERE_BAND allows. */
static int surface_through(const mesher *m, const search *s, const tess_int *v,
                           double wide, int plane, ref_surface *surface)
{
    int n, i, k;
    double c[HH_FACET_LEN], h[SAMPLE_SIZE], x = 0.0, err;
    tess_int *r = surface->record;
    hh_ball t;

    if (plane ? !hh_thin(&m->points, v, 0, c)
              : !hh_centre(&m->points, v, 0, v[3], c, &t))
        return 0;
    for (k = 0; k < 3; k++) x = larger(x, fabs(c[k]));
    frexp(x, &i);
    r[RECORD_POINT] = v[0];
    r[RECORD_PLANE] = (tess_int)plane;
    r[RECORD_QUANTUM] = EXPONENT;
    r[RECORD_UNIT] = (tess_int)(EXPONENT + i);
    for (k = 0; k < 3; k++) {
        x = ldexp(c[k], -i);
        for (n = 0; n < DIGITS; n++) {
            x *= DIGIT;
            r[RECORD_DIGITS + DIGITS * k + n] = (tess_int)x;
            x -= (double)r[RECORD_DIGITS + DIGITS * k + n];
        }
    }
    if (!surface_from_record(m, surface)) return 0;
    n = s->surface.offered < SAMPLE_SIZE ? (int)s->surface.offered
                                         : SAMPLE_SIZE;
    for (i = 0; i < n; i++) {
        x = fabs(
            hh_height(&m->points, &surface->limbs, s->surface.sample[i], &err));
        if (err > 1.0) return 0;
        for (k = i; k > 0 && h[k - 1] > x; k--) h[k] = h[k - 1];
        h[k] = x;
    }
    x = h[3 * n / 4];
    if (h[n / 4] > 0.0 && h[n / 4] < x / FINER_BY) x = h[n / 4];
    frexp(x * (16.0 / (double)MARKS) + UNDERFLOW_ERR, &k);
    r[RECORD_QUANTUM] = (tess_int)(EXPONENT + k);
    return surface_from_record(m, surface) &&
           -surface->lowest <= (plane ? PLANE_BAND : SPHERE_BAND * wide) * wide;
}

/* fit_surface - sets up a surface through points of a search's sample that are
 * far apart: a sphere, or a plane where the points are on none (sheets near
 * each other are one).  A sample of several clumps is refused: from far enough
 * all points are near spheres that no search needs.  Returns 1 if it is set
 * up. */
static int fit_surface(const mesher *m, const search *s, ref_surface *r)
{
    tess_int v[4];
    double u[3 * SAMPLE_SIZE], e[3], wide[3], x;
    int n = s->surface.offered < SAMPLE_SIZE ? (int)s->surface.offered
                                            : SAMPLE_SIZE,
        widest, i, j, k;

    v[0] = s->facet[0];
    for (i = 0; i < n; i++)
        minus(m->x + 3 * s->surface.sample[i], m->x + 3 * v[0], u + 3 * i);
    for (j = 0; j < 3; j++) { /* the farthest, then what is left across it */
        for (i = widest = 0; i < n; i++)
            if (dot(u + 3 * i, u + 3 * i) > dot(u + 3 * widest, u + 3 * widest))
                widest = i;
        v[j + 1] = s->surface.sample[widest];
        wide[j] = sqrt(dot(u + 3 * widest, u + 3 * widest));
        if (j == 2) break;
        if (wide[j] <= LINE_WIDTH * wide[0] + HH_LENGTH_MIN ||
            CLUMPS_APART(m, wide[0]))
            return 0;
        for (k = 0; k < 3; k++) e[k] = u[3 * widest + k] / wide[j];
        for (i = 0; i < n; i++)
            for (x = dot(u + 3 * i, e), k = 0; k < 3; k++)
                u[3 * i + k] -= x * e[k];
    }
    return (wide[2] >= PLANE_WIDTH * wide[0] &&
            surface_through(m, s, v, wide[0], 0, r)) ||
           surface_through(m, s, v, wide[0], 1, r);
}

/* mark_leaf - marks the points of a leaf that are certainly near surface j and
 * have no mark yet, or one of a surface FINER_BY times coarser, and stores the
 * leaf's range of marks.  Returns how many it marked. */
static tess_int mark_leaf(mesher *m, int j, tess_int leaf)
{
    ref_surface *r = m->surfaces.surface + j;
    tess_int i, last, mark, old, least = RANGE_STEPS, most = -1, k, members = 0;
    double h, err, c;

    for (node_range(m, leaf, &i, &last); i < last; i++) {
        h = rounded_height(m, r, i, &err);
        if (fabs(h) <= err - r->lowest)
            h = hh_height(&m->points, &r->limbs, i, &err);
        c = (h - err - r->lowest) / r->quantum;
        /* (converted when it is in range, even if that were in vain) */
        c = c < 0.0 ? -1.0 : c < (double)MARKS ? c : (double)MARKS;
        mark = (tess_int)c;
        k = mark < 0 ? -1 : (tess_int)(mark / MARKS_PER_STEP);
        if (k < least) least = k;
        if (h + err > -r->lowest) k = RANGE_STEPS;
        if (k > most) most = k;
        old = m->mark[i] - 1;
        if (k >= 0 && k < RANGE_STEPS &&
            (old < 0 || m->surfaces.surface[old % SURFACES].quantum >
                            FINER_BY * r->quantum)) {
            m->mark[i] = (tess_int)(1 + j + SURFACES * mark);
            members++;
        }
    }
    r->mark_range[leaf] = RANGE_CODE(least, most);
    return members;
}

/* find_surface - seeks a surface for the sample of a search: one through its
 * points, then one through all that are near that, as the first may be from a
 * corner.  It is kept if it marks enough points; if not, marks that it has
 * taken over from a coarser surface are lost, which only takes time.  Returns 1
 * if it is kept. */
static int find_surface(mesher *m, search *s)
{
    ref_surface *r = surface_record(m, m->surfaces.known);
    tess_int node, i, j, old, most, members = 0;
    double err;
    int held = 0;

    if (m->surfaces.known == 0)
        for (i = 0; i < m->np; i++) m->mark[i] = 0;
    if (!fit_surface(m, s, r)) return 0;
    s->surface.offered = 0;
    for (i = 0; i < m->np; i = (tess_int)(i + m->np / 1024 + 1))
        if (m->edge_from[i] != COMPLETE &&
            fabs(rounded_height(m, r, i, &err)) <= err - 2.0 * r->lowest) {
            add_to_sample(s, i, 1);
            old = m->mark[i] - 1;
            held += old >= 0 && m->surfaces.surface[old % SURFACES].quantum <=
                                    FINER_BY * r->quantum;
        }
    /* if all marks would stay, computing the heights of all points in vain
     * would take most of the time of a globe's index */
    if (s->surface.offered > SAMPLE_MIN &&
        (held == s->surface.offered || !fit_surface(m, s, r)))
        return 0;
    for (node = (tess_int)(2 * m->leaves - 1); node >= m->leaves; node--)
        members += mark_leaf(m, m->surfaces.known, node);
    for (; node > 0; node--) {
        i = r->mark_range[2 * node];
        j = r->mark_range[2 * node + 1];
        most = RANGE_MOST(RANGE_MOST(i) > RANGE_MOST(j) ? i : j);
        r->mark_range[node] = RANGE_CODE(RANGE_LEAST(i < j ? i : j), most);
    }
    if (members < 2 * cube_root(m->np)) {
        for (i = 0; i < m->np; i++)
            if (m->mark[i] > 0 &&
                (m->mark[i] - 1) % SURFACES == m->surfaces.known)
                m->mark[i] = 0;
        return 0;
    }
    if (++m->surfaces.known == SURFACES) m->surfaces.limit = 0.0;
    return 1;
}

/* surfaces_of_index - sets up the surfaces that an index has, as they were. */
static void surfaces_of_index(mesher *m)
{
    while (m->surfaces.known < m->alive[0])
        (void)surface_from_record(m, surface_record(m, m->surfaces.known++));
}

/* surface_near_facet - returns the surface that the facet's vertices are near,
 * or NONE; h are their heights, the base's first, err the bounds on their
 * errors.  Surfaces that have marked its vertices come first: between sheets
 * 1e-10 apart searches take 30 times as long otherwise. */
static int surface_near_facet(const mesher *m, const search *s, double *h,
                              double *err)
{
    tess_int mark;
    int i;

    for (i = 0; i < 3; i++) {
        mark = m->mark[s->facet[i]] - 1;
        if (mark >= 0 && facet_on_surface(m, s, (int)(mark % SURFACES), h, err))
            return (int)(mark % SURFACES);
    }
    for (i = 0; i < m->surfaces.known; i++)
        if (facet_on_surface(m, s, i, h, err)) return i;
    return NONE;
}

/* recentre_on_sphere - counts L from the centre of the facet's surface, a
 * sphere, in place of the circumcentre.  G is |w|^2 - 2 c.w, c = tilt / 2 - o,
 * o = base - centre: the power in the ball of centre c, which is on the facet's
 * axis.  c errs by half of tilt_err; by the roundings of three differences in
 * any order, each of at most eps (|o| + 2 |origin|), together less than 8 eps
 * size; and by eps |tilt|/2, less than a tenth of tilt_err. */
static void recentre_on_sphere(const ref_surface *surface, search *s)
{
    double size = 0.0, r;
    int k;

    for (k = 0; k < 3; k++) {
        r = s->hh[HH_BASE + k] - surface->origin[k];
        size += fabs(r) + 2.0 * fabs(surface->c[k]) + fabs(surface->origin[k]);
        s->hh[HH_CENTRE + k] = 0.5 * s->surface.tilt[k] - (r - surface->c[k]);
    }
    s->hh[HH_DC] = 0.6 * s->surface.tilt_err + 8.0 * EPS * size;
    s->hh[HH_RHO] = sqrt(dot(s->hh + HH_CENTRE, s->hh + HH_CENTRE));
}

/* choose_surface - finds the surface of the facet, if any, and its tilt.  There
 * is none for a sliver (see SLIVER_E), nor for a facet at more than 60 degrees
 * to its plane; nor for a facet so small that a sphere bends away from it by
 * less than its points scatter, a sixteenth of the band or so.  Its balls are
 * then far from the sphere, and L, counted from the centre of the sphere and
 * right to 8 eps of its distance, would tell nothing of them: 20,000 points of
 * a sphere that crowd about a spot take 8 times as long.
 *
 * tilt_err: roundings of the edges take the tilt out of the plane.  In it, the
 * tilt's products with the edges miss the differences of heights by r0, r1, and
 * a vector whose products with two unit vectors are r0, r1 is no longer than
 * (|r0| + |r1|) / sine of the angle between them.  det errs by less than 1/100,
 * as no sliver is let through.  Where two vertices are so near that the marks
 * leave nothing of the tilt, as at the poles of a globe of meridians, the
 * differences of heights come by limbs, over the base: right to some eps of
 * themselves. */
static void choose_surface(const mesher *m, search *s)
{
    const double *b = m->x + 3 * s->facet[s->base];
    const ref_surface *surface;
    double a[2][3], h[3] = {0.0, 0.0, 0.0}, err[3], n[2], t[2];
    double ab, det, size, r;
    hh_sphere own;
    int i, k, which, again;

    which = s->hh[HH_E] > SLIVER_E ? NONE : surface_near_facet(m, s, h, err);
    if (which == NONE) return;
    surface = m->surfaces.surface + which;
    s->surface.normal_height = dot(surface->c, s->hh);
    if (surface->limbs.plane && fabs(s->surface.normal_height) < 0.5) return;
    for (i = 0; i < 2; i++) {
        minus(m->x + 3 * s->facet[(s->base + 1 + i) % 3], b, a[i]);
        n[i] = dot(a[i], a[i]);
        err[i + 1] += err[0] + 16.0 * EPS * (fabs(h[i + 1]) + fabs(h[0]));
        h[i + 1] -= h[0];
    }
    if (!surface->limbs.plane && 16.0 * n[0] < -surface->lowest &&
        16.0 * n[1] < -surface->lowest)
        return;
    ab = dot(a[0], a[1]);
    det = n[0] * n[1] - ab * ab;
    if (det < 1e4 * EPS * n[0] * n[1] || det < UNDERFLOW_ERR) return;
    s->surface.number = which;
    s->surface.filter.base_height = h[0];
    s->surface.height_err = err[0];
    for (again = 0;; again = 1) {
        size = 0.0;
        t[0] = (h[1] * n[1] - h[2] * ab) / det;
        t[1] = (h[2] * n[0] - h[1] * ab) / det;
        for (k = 0; k < 3; k++) {
            s->surface.tilt[k] = t[0] * a[0][k] + t[1] * a[1][k];
            size += fabs(t[0] * a[0][k]) + fabs(t[1] * a[1][k]);
        }
        s->surface.tilt_err = 8.0 * EPS * size;
        for (i = 0; i < 2; i++) {
            r = h[i + 1] - dot(s->surface.tilt, a[i]);
            r = fabs(r) + err[i + 1] + 16.0 * EPS * size * sqrt(n[i]);
            s->surface.tilt_err += r * sqrt(1.02 * n[1 - i] / det);
        }
        if (again || s->surface.tilt_err < size - surface->lowest ||
            !hh_surface(&m->points, s->facet[s->base],
                        surface->record[RECORD_POINT], surface->limbs.plane,
                        surface->c, &own))
            break;
        for (i = 1; i < 3; i++)
            h[i] = hh_height(&m->points, &own, s->facet[(s->base + i) % 3],
                             err + i);
    }
    if (!surface->limbs.plane) recentre_on_sphere(surface, s);
}

/* sharpen_by_height - sharpens the side of the position z, which hh_limits did
 * not find negative, and the limits of L, by the height of z over the facet's
 * surface: the height gives the side for a plane, the power for a sphere.  A
 * plane's normal_height errs by E and some roundings.  The quotients are of
 * numbers right to 4 eps of themselves, as is what is left of a side of more
 * than twice its error: ROUNDING is more.  Returns the side. */
static int sharpen_by_height(const mesher *m, const search *s, tess_int z,
                             int side, double *lo, double *hi)
{
    const ref_surface *r = m->surfaces.surface + s->surface.number;
    const double *x = m->x + 3 * z;
    double h, err, low, high, least, most, g = 0.0, size = 0.0, u;
    int k;

    if (!height_over(m, s->surface.number, z, &h, &err)) return side;
    err += s->surface.height_err +
           16.0 * EPS * (fabs(h) + fabs(s->surface.filter.base_height)) +
           UNDERFLOW_ERR;
    h -= s->surface.filter.base_height;
    for (k = 0; k < 3; k++) {
        u = x[k] - s->hh[HH_BASE + k];
        h -= s->surface.tilt[k] * u;
        g += s->hh[k] * u;
        size += fabs(u);
        err += 16.0 * EPS * fabs(s->surface.tilt[k] * u);
    }
    err += s->surface.tilt_err * size;
    if (r->limbs.plane) {
        if (s->surface.normal_height < 0.0) h = -h;
        if (h + err < 0.0) return -1;
        u = s->hh[HH_E] + 32.0 * EPS;
        least =
            (h - err) / (fabs(s->surface.normal_height) + u) * (1.0 - ROUNDING);
        most =
            (h + err) / (fabs(s->surface.normal_height) - u) * (1.0 + ROUNDING);
        if (least < HH_LENGTH_MIN) return side;
        low = -DBL_MAX;
        high = DBL_MAX;
        hh_ratio(s->hh, x, least, most, &low, &high);
        side = 1;
    } else {
        least = 2.0 * (g - s->hh[HH_E] * size);
        most = 2.0 * (g + s->hh[HH_E] * size);
        if (side <= 0 || least < HH_LENGTH_MIN) return side;
        low = (h - err) / (h > err ? most : least);
        high = (h + err) / (h > -err ? least : most);
        low -= ROUNDING * fabs(low);
        high += ROUNDING * fabs(high);
    }
    if (low > *lo) *lo = low;
    if (high < *hi) *hi = high;
    return side;
}

/* set_surface_filter - sets up the surface filter for the best point so far,
 * whose L-coordinate is at most l.  A better point has side > 0 and N - 2 l
 * side <= 0, where N is its power in the ball of L = 0, of centre c.  Without a
 * ball l is L_MAX / 2, with room for N.  So with v, the facet's normal, no
 * better point satisfies
 *     q |w|^2 - d.w + a (height - base_height) > 0.
 * Near a plane side = G / g, g being normal_height:
 *     q = 1,  d = 2 c + a tilt,  a = -2 l / g.
 * Near a sphere N = G; a share q of it comes from powers, 1 - q from heights:
 *     q > 0,  d = 2 q c + a tilt + 2 l v,  a = 1 - q.
 *
 * Near a plane any upper bound l is valid, so a is only ever rounded up.  Near
 * a sphere q makes |d| least, if it can; any q > 0 is valid, so errors in q do
 * not count.  dd has room for the errors of c, tilt and v, and for 8 roundings
 * of each term; allowance for those of base_height, of a height of at most
 * -lowest, and of a, which is exact but for one rounding.  The surface filter
 * is all that, divided by q. */
static void set_surface_filter(const mesher *m, search *s)
{
    const ref_surface *r = m->surfaces.surface + s->surface.number;
    ball_filter *filter = &s->surface.filter;
    int ball = s->has_ball && fabs(s->hi) <= L_MAX, k;
    double l = ball ? s->hi : 0.5 * L_MAX, a = 1.0, q = 1.0, b = 0.0;
    double dd = ball ? 0.0 : 4.0 + 4.0 * s->hh[HH_RHO], sum = 0.0, u, v, w;

    if (r->limbs.plane) {
        a = -2.0 * l / s->surface.normal_height;
        u = 4.0 * (s->hh[HH_E] + 32.0 * EPS) * a;
        a += l > 0.0 ? u : -u;
    } else {
        b = 2.0 * l;
        for (k = 0; k < 3; k++)
            sum -= s->hh[HH_CENTRE + k] * (b * s->hh[k] + s->surface.tilt[k]);
        q = larger(sum > 0.0 ? 0.5 * sum / (s->hh[HH_RHO] * s->hh[HH_RHO])
                             : 0.0,
                   1.0 / L_MAX);
        a -= q;
    }
    dd += fabs(a) * s->surface.tilt_err + 2.0 * q * s->hh[HH_DC] +
          fabs(b) * s->hh[HH_E];
    for (k = 0; k < 3; k++) {
        u = a * s->surface.tilt[k];
        v = 2.0 * q * s->hh[HH_CENTRE + k];
        w = b * s->hh[k];
        dd += 8.0 * EPS * (fabs(u) + fabs(v) + fabs(w));
        filter->c[k] = 0.5 * (u + v + w) / q;
    }
    filter->c1 = norm1(filter->c);
    filter->dc = 0.5 * dd / q;
    filter->weight = a / q;
    filter->allowance =
        (fabs(a) * s->surface.height_err +
         16.0 * EPS * (fabs(a) + q) * (fabs(filter->base_height) - r->lowest) +
         UNDERFLOW_ERR) /
        q;
}

/* filter_of_mark - returns the filter for the position z of a search near a
 * surface: the surface filter if z has a mark of it, with what the height adds
 * to the power in *raise; else the plain filter. */
static const ball_filter *filter_of_mark(const mesher *m, const search *s,
                                         tess_int z, double *raise)
{
    const ball_filter *b = &s->surface.filter;
    double h;

    if (!marked_height(m, s->surface.number, z, &h)) return &s->filter;
    *raise = b->weight * (h - b->base_height) -
             fabs(b->weight) * m->surfaces.surface[s->surface.number].quantum;
    return b;
}

/* excludes_by_marks - returns 1 if a node provably holds no better point, by
 * the marks of its points; 0 if it may; UNSURE where the marks tell nothing. */
static int excludes_by_marks(const mesher *m, const search *s, tess_int node)
{
    const double *b = m->box + 6 * node;
    const ref_surface *r = m->surfaces.surface + s->surface.number;
    const ball_filter *filter = &s->surface.filter;
    tess_int k = filter->weight < 0.0 ? RANGE_MOST(r->mark_range[node])
                                      : RANGE_LEAST(r->mark_range[node]);
    double h;

    if (k < 0 || k >= RANGE_STEPS) return UNSURE;
    h = (double)MARKS_PER_STEP * (double)k;
    h += filter->weight < 0.0 ? (double)MARKS_PER_STEP + 0.5 : -0.5;
    h = r->lowest + r->quantum * h;
    return excludes_box(s, filter, b, b + 3,
                        filter->weight * (h - filter->base_height));
}

/* ball_on_surface - returns 1 if the facet is near a sphere and so is the best
 * point, if there is one: the ball is that sphere up to rounding, and no list
 * holds it. */
static int ball_on_surface(const mesher *m, const search *s)
{
    double h;

    return HAS_SPHERE(m, s) &&
           (s->best == NONE ||
            marked_height(m, s->surface.number, s->best, &h));
}

/* seek_surface - seeks a reference surface in the sample of a search, when
 * large samples add up to surfaces.limit times all points; a failure doubles
 * that limit. */
static void seek_surface(mesher *m, search *s)
{
    if (s->surface.offered <= SAMPLE_MIN || !SEEKS_SURFACES(m)) return;
    m->surfaces.load += (double)s->surface.offered / (double)m->np;
    if (m->surfaces.load <= m->surfaces.limit) return;
    m->surfaces.load = 0.0;
    if (!find_surface(m, s)) m->surfaces.limit *= 2.0;
}

/* room_for_marks - decides whether reference surfaces are sought.  Returns the
 * length of the marks in iw, of length liw: 0 if there are no surfaces and none
 * are sought. */
static tess_int room_for_marks(mesher *m, tess_int liw)
{
    const ws_lengths *w = &m->lengths;

    if (m->surfaces.limit == 0.0 && m->surfaces.known < SURFACES &&
        SURFACES_PAY(m) && w->marks > 0 &&
        (m->surfaces.known > 0 || liw - w->iw - w->pool >= w->marks))
        m->surfaces.limit = SAMPLE_LIMIT;
    return m->surfaces.known == 0 && m->surfaces.limit == 0.0 ? 0 : w->marks;
}

/* survey_regions - seeks reference surfaces for an index, in what is left of
 * iw, of length liw: those that the stars of a corner of the hull and of points
 * of all regions find (the multiples of the golden ratio are spread evenly);
 * nothing else is kept of these stars. */
static void survey_regions(mesher *m, tess_int n, tess_int *iw, tess_int liw)
{
    tess_int left = (tess_int)(liw - n), *mine = iw + left, i;
    tess_int tet[4 * STARS], adj[4 * STARS];
    double part;
    int k;

    if (!SURFACES_PAY(m) || m->lengths.marks == 0 ||
        left - m->lengths.iw < m->lengths.marks)
        return;
    for (k = 1; k <= REGIONS; k++) {
        if (k % 8 == 1)
            for (i = 0; i < n; i++) mine[i] = 0;
        part = 0.618 * k;
        part -= (double)(int)part;
        mine[m->order[(tess_int)(part * (double)m->np)]] = 1;
        mine[m->first_tet[0]] = 1;
        if (k % 8 != 0) continue;
        i = 0;
        m->surfaces.limit = m->surfaces.known < SURFACES ? KEEN : 0.0;
        lay_out_pool(m, n, left);
        (void)build(m, n, mine, STARS, &i, tet, adj);
        /* no sample filled up, so further stars will find no surface */
        if (m->surfaces.load == 0.0 && m->surfaces.known == 0) return;
    }
}
#endif /* surfaces */

/* ---- what the chapters begin with, and what they forget ---- */

/* drop_stages - drops all candidate lists, cospherical sets and hull planes. */
static void drop_stages(mesher *m)
{
#ifndef TESS_NO_NEAR_LISTS
    int i;

    for (i = 0; i < NEAR_LISTS; i++) {
        m->nears.list[i].n = 0;
        m->nears.recency[i] = i;
    }
#endif
#ifndef TESS_NO_LISTS
    m->lists.block.leaf_first = m->lists.block.leaf_end = NONE;
    m->lists.block.n = m->lists.star.n = 0;
    m->lists.block.reach = 0.0;
#endif
#ifndef TESS_NO_HULL_PLANES
    m->hull.kept = m->hull.served = m->hull.vain_looks = 0;
#endif
#ifndef TESS_NO_SETS
    m->sets.recorded = 0;
#endif
}

/* start_stages - sets what the chapters begin with. */
static void start_stages(mesher *m)
{
#ifndef TESS_NO_LISTS
    m->lists.star_tied = m->lists.block_misses = m->lists.block_ties = 0;
#endif
#ifndef TESS_NO_NEAR_LISTS
    m->nears.paused = 0;
    m->nears.tree_cost = 0.0;
    m->nears.next_skin = 1.0;
    m->nears.budget = BUDGET_START;
#endif
    SET_CYLINDERS(m, 0);
#ifndef TESS_NO_CAPS
    m->caps.planes = 0;
    m->caps.long_nodes = 0.0;
    m->caps.enough = CAP_LIMIT;
    m->caps.big_ball = DBL_MAX;
#endif
#ifndef TESS_NO_LIMBS
    m->limbs.last_tied = 0;
    m->limbs.clump_width = 0.0;
#endif
#ifndef TESS_NO_SURFACES
    m->surfaces.known = 0;
    m->surfaces.load = m->surfaces.limit = 0.0;
#endif
    drop_stages(m);
}

#endif /* part II */

/* =====================================================================
 * PART III: WITHOUT A WHOLE MESH
 * ===================================================================== */

/* ---- a star on its own ----
 *
 * Any star can be completed without the rest of the mesh, from one tetrahedron
 * at its vertex. */

/* replace_vertex - replaces v[k] by z, unless the result is flat.  Returns 1 if
 * it does. */
static int replace_vertex(const mesher *m, tess_int *v, int k, tess_int z)
{
    tess_int old = v[k];

    v[k] = z;
    if (hh_porient(&m->points, v[0], v[1], v[2], v[3]) != 0) return 1;
    v[k] = old;
    return 0;
}

/* encloses - returns 1 if v is positively oriented and contains s*, which is s
 * = v[0] = r[0] moved by an infinitesimal step into the tetrahedron r (as q* of
 * the queries is), so it is on no plane through three points. */
static int encloses(const mesher *m, const tess_int *r, const tess_int *v)
{
    int i, j, side = hh_porient(&m->points, v[0], v[1], v[2], v[3]);

    for (j = 1; j < 4 && side > 0; j++)
        for (i = 1, side = 0; i < 4 && side == 0; i++)
            side = hh_porient(&m->points, v[0], v[j % 3 + 1],
                              v[(j + 1) % 3 + 1], r[i]);
    return side > 0;
}

/* any_tet_at - finds v, a tetrahedron at v[0] = s, of points of the leaf of s
 * as far as these are not in one plane, else of vertices of first_tet. */
static void any_tet_at(const mesher *m, tess_int s, tess_int *v)
{
    tess_int first = leaf_start(m, leaf_of(m, s)), i, z;
    tess_int size = leaf_start(m, leaf_of(m, s) + 1) - first;
    int k;

    map_four(m->representative, m->first_tet, v);
    for (k = 0; k < 3 && !replace_vertex(m, v, k, s); k++)
        ;
    v[k] = v[0];
    v[0] = s;
    for (k = 1; k < 4; k++)
        for (i = 1; i < size; i++)
            if (replace_vertex(m, v, k,
                               (tess_int)(first + (s - first + i) % size)))
                break;
    if (hh_porient(&m->points, v[0], v[1], v[2], v[3]) < 0) {
        z = v[1];
        v[1] = v[2];
        v[2] = z;
    }
}

/* incident_tet - finds v, a tetrahedron of the mesh at v[0] = s, of which
 * none is known yet.
 *
 *      b---z         b---z    In the plane: z is in the ball of (s, a, b).
 *      |\  .         |  /|    Of the four points' two triangulations the
 *      | \ .   -->   | / |    lower one has the edge s z in place of a b, so
 *      |  \.         |/  |    s* is in (s, a, z) or in (s, z, b): z replaces
 *      s---a         s---a    b, or a.
 *
 * Start with any tetrahedron r at s, and with s* in it.  While v contains s*
 * and its ball is not empty, each point in the ball is on the inner side of one
 * of the three facets at s, since whatever is outside all three is beyond the
 * ball's tangent plane at s.  So the apex z of that facet on that side is not
 * v's vertex there.  The five points have two triangulations, and v is not part
 * of the one whose lifted facets are the lower ones; so the tetrahedron of that
 * one that contains s* is v with z in place of a vertex.  Each such step lowers
 * the height over s*, so none of the finitely many tetrahedra at s comes twice;
 * three searches in a row without a step end it.  (z beats v[k], the guess, by
 * the exact rule, and s* is on no plane through three points: so the height is
 * strictly less, and exactly one of the three places takes z.)  This is done
 * with the points of the leaf alone, and then with all: without the former, a
 * query from anywhere takes three times as long.
 *
 * Neither lists nor tree have completed points.  That does no harm because s is
 * in no tetrahedron yet, so no point whose star is complete is its neighbour:
 * the star of s is the same in any set of points that has all its neighbours.
 * A vertex of v whose star is complete takes part as the guess alone.
 *
 * The lists are dropped because list_hits takes for granted that a list holds
 * the facet's vertices and the best point, which is not so here.  The hull
 * planes are dropped because a seed edge follows, whose facet is open on both
 * sides: if it lies in a hull plane, on_hull_plane would find no apex on its
 * inner side, either.  The searches here record no plane, as their guess is a
 * candidate. */
static void incident_tet(mesher *m, tess_int s, tess_int *v)
{
    tess_int r[4], f[3], guess[2], node = m->leaves + leaf_of(m, s), old, z;
    search leaf_search;
    int j, k, all, still;

    drop_stages(m);
    any_tet_at(m, s, v);
    for (k = 0; k < 4; k++) r[k] = v[k];
    guess[1] = NONE;
    k = 1;
    for (all = 0; all < 2; all++)
        for (still = 0; still < 3; k = k % 3 + 1) {
            f[0] = s;
            f[1] = v[k % 3 + 1];
            f[2] = v[(k + 1) % 3 + 1];
            guess[0] = v[k];
            if (all)
                z = apex(m, f, guess);
            else {
                search_begin(m, &leaf_search, f, guess);
                offer_leaf(m, &leaf_search, node);
                z = leaf_search.best;
            }
            still++;
            if (z == v[k]) continue;
            for (j = 1; j < 4; j++) {
                old = v[j];
                v[j] = z;
                if (encloses(m, r, v)) break;
                v[j] = old;
            }
            HOLDS(j < 4);
            /* if v[k] was replaced, this was a search of its own facet */
            still = j == k;
        }
    HOLDS(empty(m, v));
}

/* seed_star - begins the star of s, which is NEW, with a facet of a tetrahedron
 * at s: its two sides become seed edges, the one towards the tetrahedron first.
 */
static void seed_star(mesher *m, tess_int s)
{
    tess_int v[4];

    incident_tet(m, s, v);
    (void)push_edge(m, SEED_EDGE, v[1], v[2]);
    (void)push_edge(m, SEED_EDGE, v[2], v[1]);
}

/* ---- an index, and parts ----
 *
 * An index is what prepare_points leaves in iw and rw, but for scratch: sorted
 * points without a mesh. */

/* The places of an index's header: see write_header. */
#define HEADER_NP 0
#define HEADER_EXACT3 1
#define HEADER_EXACT5 2
#define HEADER_EXPONENT 3
#define HEADER_LEAST 4
#define HEADER_LIMBS 5

/* write_header - turns the sorted points into an index, which has a mesh if
 * code is 0.  It stores what open_index needs besides points and tree.
 *
 *   first_tet  places 0 to 3: a tetrahedron of the mesh, numbers of points; or
 *              place 0: minus the code of points without a mesh
 *              place 4: np
 *   header     np again, so that an index can be recognized: arrays of zeros,
 *              or an index that tess has overwritten, are none; what points
 *              have beside coordinates; least_abs, negative if there are
 *              clumps; HH_LIMBS, negative if there are no cylinders
 *   alive      place 0: the number of reference surfaces */
static void write_header(mesher *m, int code)
{
    double *header = m->box;

    if (code != 0) m->first_tet[0] = (tess_int)-code;
    m->first_tet[4] = m->np;
    header[HEADER_NP] = (double)m->np;
    if (code != 0) return;
    header[HEADER_EXACT3] = m->points.exact3;
    header[HEADER_EXACT5] = m->points.exact5;
    header[HEADER_EXPONENT] = m->points.exponent;
    header[HEADER_LEAST] = HAS_CLUMPS(m) ? -m->least_abs : m->least_abs;
    header[HEADER_LIMBS] = HAS_CYLINDERS(m) ? HH_LIMBS : -HH_LIMBS;
    m->alive[0] = (tess_int)KNOWN_SURFACES(m);
}

/* open_index - opens an index for reading only.  Returns 0, the code of points
 * without a mesh, -1 for a bad n, or -8 where there is no index. */
static int open_index(mesher *m, tess_int n, const tess_real *p,
                      const tess_int *iw, const double *rw)
{
    const double *header;
    tess_int i, z;
    int k;

    if (n == 0) return TESS_POINT;
    if (!workspace_lengths(n, &m->lengths)) return -1;
    lay_out(m, n, p, (tess_int *)iw, (double *)rw);
    header = m->box;
    m->np = m->first_tet[4];
    if (m->np < 0 || m->np > n || header[HEADER_NP] != (double)m->np)
        return -8;
    for (k = TESS_PLANE; k <= TESS_RANGE; k++)
        if (m->first_tet[0] == -k) return k;
    for (k = 0; k < 4; k++) {
        i = m->first_tet[k];
        if (i < 0 || i >= n || place_in_four(m->first_tet, i) < k) return -8;
        z = m->representative[i];
        if (z < 0 || z >= m->np || m->order[z] != i) return -8;
    }
    if (m->alive[0] < 0 || (SURFACES > 0 && m->alive[0] > SURFACES))
        return -8;
    m->leaves = leaf_count(m->np);
    m->points.exact3 = header[HEADER_EXACT3];
    m->points.exact5 = header[HEADER_EXACT5];
    m->points.exponent = (int)header[HEADER_EXPONENT];
    SET_CYLINDERS(m, header[HEADER_LIMBS] > 0.0);
    if (header[HEADER_LEAST] < 0.0) measure_clumps(m);
    if (fabs(header[HEADER_LIMBS]) > HH_LIMBS && !limbs_hold_all(n, p))
        return TESS_RANGE;
    i = fabs(header[HEADER_LEAST]) < (double)HH_REAL_MIN ? n : 1;
    if (hh_finite(i, p) < i) return -8;
    return hh_holds(i, p) ? 0 : TESS_RANGE;
}

int tess_index(tess_int n, const tess_real *p, tess_int liw, tess_int *iw,
               tess_int lrw, double *rw)
{
    mesher m;
    tess_int i, v[4];
    int code = bad_argument(n, p, 0, 0, NULL, NULL, TESS_INT_MOST, lrw);

    if (code != 0 && code != -9) return code;
    if (liw < 2 * n + 2 * leaf_count(n) + INDEX_EXTRA) return -3;
    if (code != 0) return -5;
    code = prepare_points(&m, n, p, iw, lrw, rw);
    if (code == 0) code = first_facet(&m, v);
    if (code == 0) {
        v[3] = apex(&m, v, NULL);
        map_four(m.order, v, m.first_tet);
    }
    if (code != TESS_RANGE) {
        /* representative becomes number -> position: first of the points that
         * stand for themselves.  These are the i with order[representative[i]]
         * = i, as order holds no duplicate; a duplicate then takes the position
         * of the point that represents it */
        for (i = 0; i < m.np; i++) m.representative[m.order[i]] = i;
        for (i = 0; i < n; i++)
            if (m.representative[i] >= m.np ||
                m.order[m.representative[i]] != i)
                m.representative[i] = m.representative[m.representative[i]];
    }
    if (code == 0) survey_regions(&m, n, iw, liw);
    write_header(&m, code);
    return code;
}

int tess_part(tess_int n, const tess_real *p, const tess_int *mine,
              tess_int maxtet, tess_int *ntet, tess_int *tet, tess_int *adj,
              tess_int liw, tess_int *iw, tess_int lrw, const double *rw)
{
    mesher m;
    int code = bad_argument(n, NULL, maxtet, *ntet, tet, adj, liw, lrw);

    if (code == 0 && mine == NULL) return -3;
    if (code == 0) code = open_index(&m, n, p, iw, rw);
    if (code > 0) *ntet = 0;
    if (code == 0) {
        if (m.alive[0] > 0 && liw - m.lengths.iw < m.lengths.marks) return -8;
        if (HAS_CYLINDERS(&m) && lrw - m.lengths.rw < m.lengths.cylinders)
            return -10;
        surfaces_of_index(&m);
        lay_out_pool(&m, n, liw);
        code = build(&m, n, mine, maxtet, ntet, tet, adj);
        m.alive[0] = (tess_int)KNOWN_SURFACES(&m);
    }
    return code < -1 ? code - 1 : code;
}

/* ---- queries ----
 *
 * What comes first serves tess_query and tess_locate.
 *
 * One device does much of the work: a point q is replaced by q*, which is q
 * moved by an infinitesimal step into the interior of tetrahedron 0, of
 * vertices v0 ...  v3:
 *     q* = q + e (v0 - q) + e^2 (v1 - q) + e^3 (v2 - q) + e^4 (v3 - q)
 * for all small enough e > 0.  The orientation of a facet with a point is an
 * affine function of the point, so the sign for q* is the first nonzero one of
 * the signs for q, v0, v1, v2, v3.  One of them is not 0, since v0 ... v3 are
 * not in one plane: q* is on no facet, and is in the interior of exactly one
 * tetrahedron if it is in the hull of a triangulation. */

/* side_of_qstar - returns 1 if q* is outside the facet f, -1 if it is inside,
 * UNSURE if the limbs do not suffice; 0 only if v, tetrahedron 0, is flat.  It
 * takes one orientation unless q is exactly in the plane. */
static int side_of_qstar(const tess_real *p, const tess_int *f,
                         const tess_real *q, const tess_int *v)
{
    const tess_real *a = p + 3 * f[0], *b = p + 3 * f[1];
    const tess_real *c = p + 3 * f[2];
    int s = hh_horient(a, b, c, q), k;

    for (k = 0; k < 4 && s == 0; k++)
        s = hh_held(p + 3 * v[k]) ? hh_horient(a, b, c, p + 3 * v[k]) : UNSURE;
    return s;
}

/* exit_facet - returns the first facet of the tetrahedron v, other than from,
 * that q* is beyond; 4 if there is none, -1 if the limbs do not suffice.  w is
 * tetrahedron 0. */
static int exit_facet(const tess_real *p, const tess_int *v, int from,
                      const tess_real *q, const tess_int *w)
{
    tess_int f[3];
    int k, s;

    for (k = 0; k < 4; k++) {
        if (k == from) continue;
        tet_facet(v, k, f);
        s = side_of_qstar(p, f, q, w);
        if (s == UNSURE) return -1;
        if (s > 0) return k;
    }
    return 4;
}

/* nearer_max_norm - returns 1 if a is nearer to q, in the maximum norm, than
 * the distance least, and sets least to the distance of a: least[0] - least[1],
 * left unevaluated so that nothing is rounded.  least[0] < least[1] means that
 * there is no point yet. */
static int nearer_max_norm(const tess_real *a, const tess_real *q,
                           double *least)
{
    double hi = 0.0, lo = 0.0, h, l;
    int k;

    for (k = 0; k < 3; k++) {
        h = (double)(a[k] > q[k] ? a[k] : q[k]);
        l = (double)(a[k] > q[k] ? q[k] : a[k]);
        if (hh_wider(h, l, hi, lo) > 0) {
            hi = h;
            lo = l;
        }
    }
    if (least[0] >= least[1] && hh_wider(least[0], least[1], hi, lo) <= 0)
        return 0;
    least[0] = hi;
    least[1] = lo;
    return 1;
}

/* A walk over the hull, towards its point nearest to q. */
typedef struct hull_walk {
    tess_int facet[3];   /* the vertices of the facet nearest to q so far */
    tess_int face[3];    /* the vertices of its face that has its nearest point
                          * in the interior: of an edge two, a vertex twice */
    tess_int turn_from;  /* the vertex of the last facet to turn away from */
    tess_int pivot;      /* when turning about a vertex, the other that stays */
    tess_int turns_left; /* how many more facets may be met about the vertex */
    tess_int max_turns;  /* how many may be met about a vertex at all */
} hull_walk;

/* hull_step - takes one step towards the hull's point nearest to q, from a
 * facet that q is outside of.  g is the facet met; h->facet[0] is TESS_NONE at
 * first.  Returns 1 if g is nearer than all before, else 0; plus 2 at the end:
 * h->facet is then the nearest facet, and w its weights.  Until then, the next
 * facet to meet is the one on the other side of g's edge opposite to
 * h->turn_from.  Returns TESS_RANGE when the limbs do not suffice.
 *
 * A facet's nearest point x is in the interior of one of its faces: an edge, a
 * vertex or all of it.  The facets around that face are met.  If x is the
 * nearest point of each of them that q is outside of, it is the nearest point
 * of the hull: if a point of the hull is nearer, there are such points y
 * arbitrarily near to x.  Where the segment from q to y enters the hull, at a
 * point nearer still, q is outside of a facet; and this facet contains x if y
 * is near enough, as the segment from q to x meets the hull in x alone.  All
 * this is exact, and each facet is nearer than the one before, so the walk
 * ends. */
static int hull_step(const tess_real *p, const tess_real *q, const tess_int *g,
                     hull_walk *h, double *w)
{
    const tess_real *a = p + 3 * g[0], *b = p + 3 * g[1];
    const tess_real *c = p + 3 * g[2];
    int set = hh_foot(a, b, c, q, NULL), nearer = 1, end, side, i, k;
    int alike = 1, shared = 0, carries;

    if (set == 0) return TESS_RANGE;
    if (h->facet[0] != TESS_NONE) {
        side = hh_horient(a, b, c, q);
        if (side == UNSURE) return TESS_RANGE;
        for (i = 0; i < 3; i++) {
            carries = g[i] == h->face[0] || g[i] == h->face[1];
            if ((set >> i & 1) != carries) alike = 0;
            for (k = 0; k < 3; k++) shared += g[i] == h->facet[k];
        }
        nearer = side > 0 && !alike;
    }
    if (nearer) {
        h->turns_left = h->max_turns;
        for (i = k = 0; i < 3; i++) {
            h->facet[i] = g[i];
            if (set >> i & 1)
                h->face[k++] = g[i];
            else {
                h->pivot = h->turn_from;
                h->turn_from = g[i];
            }
        }
        if (k == 1) h->face[1] = h->face[0];
        end = k == 3;
    } else {
        /* an edge has one more facet, a vertex a circle of them */
        end = h->face[0] != h->face[1] || shared == 3 || h->turns_left-- < 1;
        h->turn_from = h->pivot;
        for (i = 0; i < 3; i++)
            if (g[i] != h->face[0] && g[i] != h->turn_from) h->pivot = g[i];
    }
    if (!end) return nearer;
    set = hh_foot(p + 3 * h->facet[0], p + 3 * h->facet[1],
                  p + 3 * h->facet[2], q, w);
    return set == 0 ? TESS_RANGE : nearer + 2;
}

/* position_near - returns a position near q: goes down the tree by the cuts to
 * a leaf, and takes its point nearest to q in the maximum norm.  All
 * comparisons are exact, unless q is far outside, so it is the same everywhere.
 */
static tess_int position_near(const mesher *m, const tess_real *q)
{
    tess_int node = 1, best, i, last;
    double least[2] = {0.0, 1.0};
    const double *b;
    int k;

    while (node < m->leaves) {
        node = 2 * node;
        b = m->box + 6 * node;
        for (k = 0; k < 2 && b[3 + k] > b[6 + k]; k++)
            ;
        if ((double)q[k] >= ldexp(b[6 + k], m->points.exponent)) node++;
    }
    node_range(m, node, &best, &last);
    for (i = best; i < last; i++)
        if (nearer_max_norm(point(m, i), q, least)) best = i;
    return best;
}

/* cross_facet - replaces u by the tetrahedron across its facet k, whose apex
 * becomes u[3].  Returns 0 and leaves u if that facet is on the hull. */
static int cross_facet(mesher *m, tess_int *u, int k)
{
    tess_int f[3], a;

    tet_facet(u, k, f);
    a = apex(m, f, NULL);
    if (a == NONE) return 0;
    for (k = 0; k < 3; k++) u[k] = f[k];
    u[3] = a;
    return 1;
}

/* tet_in_mesh - returns 1 if the tetrahedron u, positively oriented, is one of
 * the mesh, that is, if its ball is empty.  Where ball_is_empty cannot tell: as
 * in incident_tet, a point in the ball would be on the inner side of one of the
 * three facets at u[0], and so no worse there than that facet's apex, which
 * must be u's own vertex. */
static int tet_in_mesh(mesher *m, const tess_int *u)
{
    tess_int f[3], guess[2];
    int k, told = ball_is_empty(m, u);

    if (told != UNSURE) return told;
    guess[1] = NONE;
    f[0] = u[0];
    for (k = 1; k < 4; k++) {
        f[1] = u[k % 3 + 1];
        f[2] = u[(k + 1) % 3 + 1];
        guess[0] = u[k];
        if (apex(m, f, guess) != u[k]) return 0;
    }
    return 1;
}

/* tess_query - the walk of tess_locate, with q* moved into the tetrahedron of
 * the index, and for a q outside its walk over the hull, so that the answer is
 * that of tess_locate; neighbours are computed as they are needed.  If the v
 * given is a tetrahedron of the mesh, so are all that the walk meets.  If not,
 * the walk might cycle, or end at another that is none: after np steps, or
 * there, it starts again from one that is. */
int tess_query(tess_int n, const tess_real *p, const tess_int *iw,
               const double *rw, const tess_real *q, tess_int *v, double *w)
{
    mesher m;
    tess_int u[4], f[3], g[4], z, steps = 0;
    double x[3];
    hull_walk h;
    int code, i, k, s, from = 4;

    code = open_index(&m, n, p, iw, rw);
    if (code != 0) return code < -1 ? -3 : code;
    if (hh_finite(1, q) < 1) return -5;
    surfaces_of_index(&m);
    for (k = 0; k < 4 && v[0] != TESS_NONE; k++) {
        if (v[k] < 0 || v[k] >= n) return -6;
        u[k] = m.representative[v[k]];
        if (m.order[u[k]] != v[k]) return -6;
        steps = m.np;
    }
    if (steps > 0 && hh_porient(&m.points, u[0], u[1], u[2], u[3]) <= 0)
        return -6;
    for (k = 0; k < 4; k++) w[k] = 0.0;
    if (!hh_holds(1, q)) return TESS_RANGE;
    for (;;) {
        if (steps >= 0 && steps-- == 0) {
            incident_tet(&m, position_near(&m, q), u);
            from = 4;
        }
        map_four(m.order, u, v);
        k = exit_facet(p, v, from, q, m.first_tet);
        if (k < 0) return TESS_RANGE;
        from = 3;
        if (k < 4 && cross_facet(&m, u, k)) continue;
        if (steps < 0 || tet_in_mesh(&m, u)) break;
        steps = 0;
    }
    if (k == 4) return hh_weigh(p, v, q, w) == 0 ? 0 : TESS_RANGE;
    h.facet[0] = h.turn_from = TESS_NONE;
    h.max_turns = m.np;
    for (;;) {
        map_four(m.order, u, g);
        tet_facet(g, k, f);
        s = hull_step(p, q, f, &h, x);
        if (s == TESS_RANGE) return s;
        if (s % 2 == 1) map_four(m.order, u, v);
        if (s >= 2) break;
        /* as next_hull_facet does */
        z = m.representative[h.turn_from];
        do {
            i = place_in_four(u, z);
            z = u[k];
            k = 3;
        } while (cross_facet(&m, u, i));
        k = i;
    }
    for (i = 0; i < 3; i++) w[place_in_four(v, h.facet[i])] = x[i];
    return 1;
}

/* =====================================================================
 * PART IV: USING A MESH
 *
 * What follows takes a mesh as it is, or four points.
 * ===================================================================== */

/* ---- location ---- */

/* Steps from a given start after which a location looks for a better one.  With
 * 8, ordered queries among 100,000 points take a quarter longer than with 16;
 * with 32, unordered ones take 1.4 times as long as with 8. */
#define START_STEPS 12
#define OUT_OF_STEPS 99 /* an answer of walk: its steps are used up */

/* choose_start - chooses where the walk to q starts: among t, if given, and
 * about ntet^(1/4) equally spaced tetrahedra, the first whose first vertex is
 * nearest to q in the maximum norm.  The comparisons are exact, so the choice
 * is the same everywhere.  Returns TESS_NONE if the arithmetic cannot hold a
 * point. */
static tess_int choose_start(const tess_real *p, tess_int ntet,
                             const tess_int *tet, const tess_real *q,
                             tess_int t)
{
    tess_int many = 1, best = TESS_NONE, i;
    double least[2] = {0.0, 1.0};
    const tess_real *a;

    while (many * many < ntet / (many * many)) many++;
    for (i = t == TESS_NONE ? 0 : -1; i < many; i++) {
        if (i >= 0) t = (tess_int)(i * (ntet / many));
        a = p + 3 * tet[4 * t];
        if (!hh_held(a)) return TESS_NONE;
        if (nearer_max_norm(a, q, least)) best = t;
    }
    return best;
}

/* walk - walks from *t across facets *k that q* is beyond.  Returns 0 when
 * there is none: *t contains q*; 1 at a facet of the hull that q is outside of;
 * OUT_OF_STEPS after most steps; TESS_RANGE when the limbs do not suffice, or
 * hh_held does not pass a vertex; -4 for a facet that is open, or a neighbour
 * that is out of range or does not match.
 *
 * In a result of tess the walk meets no tetrahedron twice.  Lift each point x
 * to the height |x|^2, lowered as the tie rule says: the tetrahedra are the
 * lower facets of a convex polytope, and where q* is beyond the facet from t to
 * u, the plane of u is above that of t over q*.  So the height of the current
 * plane over q* grows with every step.  (Among cospherical tetrahedra of
 * another triangulation the height may stay, and the walk may cycle.) */
static int walk(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, const tess_real *q, tess_int most,
                tess_int *t, int *k)
{
    tess_int steps, u;
    int from = 4, i;

    for (i = 0; i < 4; i++)
        if (!hh_held(p + 3 * tet[4 * *t + i])) return TESS_RANGE;
    for (steps = 0; steps < most; steps++) {
        *k = exit_facet(p, tet + 4 * *t, from, q, tet);
        if (*k < 0) return TESS_RANGE;
        if (*k == 4) return 0;
        u = adj[4 * *t + *k];
        if (u == TESS_NONE) return 1;
        if (u < 0 || u >= ntet) return -4;
        from = place_in_four(adj + 4 * u, *t);
        if (from == 4) return -4;
        if (!hh_held(p + 3 * tet[4 * u + from])) return TESS_RANGE;
        *t = u;
    }
    return OUT_OF_STEPS;
}

/* next_hull_facet - turns from the hull facet *k of tetrahedron *t about its
 * edge opposite to the vertex *z to the hull facet on the other side of that
 * edge, whose vertex opposite to it becomes *z.  Returns 1, or 0 if neighbours
 * are out of range or do not match. */
static int next_hull_facet(tess_int ntet, const tess_int *tet,
                           const tess_int *adj, tess_int *t, int *k,
                           tess_int *z)
{
    tess_int steps, u;
    int i;

    for (steps = 0; steps < ntet; steps++) {
        i = place_in_four(tet + 4 * *t, *z);
        if (i == 4) return 0;
        u = adj[4 * *t + i];
        *z = tet[4 * *t + *k];
        if (u == TESS_NONE) {
            *k = i;
            return 1;
        }
        if (u < 0 || u >= ntet) return 0;
        *k = matching_facet(tet, *t, i, u);
        if (*k == 4) return 0;
        *t = u;
    }
    return 0;
}

/* nearest_on_hull - walks from tetrahedron *t, whose facet k is a hull facet
 * that q is outside of, to the one with the hull's point nearest to q, and
 * stores that point's weights in w, which is 0 on entry.  Returns 1, TESS_RANGE
 * or -4. */
static int nearest_on_hull(const tess_real *p, tess_int ntet,
                           const tess_int *tet, const tess_int *adj,
                           const tess_real *q, tess_int *t, int k, double *w)
{
    double x[3];
    tess_int g[3], u = *t;
    hull_walk h;
    int step;

    h.facet[0] = h.turn_from = TESS_NONE;
    h.max_turns = 4 * ntet;
    for (;;) {
        tet_facet(tet + 4 * u, k, g);
        step = hull_step(p, q, g, &h, x);
        if (step == TESS_RANGE) return step;
        if (step % 2 == 1) *t = u;
        if (step >= 2) break;
        if (!next_hull_facet(ntet, tet, adj, &u, &k, &h.turn_from)) return -4;
        if (!hh_held(p + 3 * h.turn_from)) return TESS_RANGE;
    }
    for (k = 0; k < 3; k++) w[place_in_four(tet + 4 * *t, h.facet[k])] = x[k];
    return 1;
}

/* tess_locate - a walk (see walk); then, for a q outside, a walk over the hull
 * (see hull_step).
 *
 * It is q*, not q, that is located.  The hull is convex and q* is nearer to its
 * inside, so q* is inside of it when q is inside or on its boundary, and then
 * the answer depends on the points, tet and q alone.  For a q outside, the
 * start decides which of the facets that have the hull's nearest point is
 * found.
 *
 * Cost: proportional to the tetrahedra crossed, about ntet^(1/3) / 2 of them
 * from the start that choose_start finds, few from a start near q: beyond
 * START_STEPS of these, choose_start is used, too. */
int tess_locate(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, const tess_real *q, tess_int *t, double *w)
{
    int code = OUT_OF_STEPS, k;

    if (ntet < 1) return -2;
    if (hh_finite(1, q) < 1) return -5;
    if (*t < TESS_NONE || *t >= ntet) return -6;
    for (k = 0; k < 4; k++) w[k] = 0.0;
    if (!hh_holds(1, q)) return TESS_RANGE;
    if (*t != TESS_NONE) code = walk(p, ntet, tet, adj, q, START_STEPS, t, &k);
    if (code == OUT_OF_STEPS) {
        *t = choose_start(p, ntet, tet, q, *t);
        if (*t == TESS_NONE) return TESS_RANGE;
        code = walk(p, ntet, tet, adj, q, ntet, t, &k);
    }
    if (code == OUT_OF_STEPS) code = -4;
    if (code == 0 && hh_weigh(p, tet + 4 * *t, q, w) != 0) code = TESS_RANGE;
    if (code == 1) code = nearest_on_hull(p, ntet, tet, adj, q, t, k, w);
    return code;
}

/* weighted_mean - returns the mean of four numbers v with weights w that sum to
 * a quarter, so that no sum overflows.  A NaN makes it a NaN, an infinity that
 * infinity, and -infinity comes before the other: neither gets as far as an
 * operation that would set a flag. */
static double weighted_mean(const double *w, const double *v)
{
    double sum = 0.0, low = v[0], high = v[0];
    int k;

    for (k = 0; k < 4; k++)
        if (v[k] != v[k]) return v[k];
    for (k = 1; k < 4; k++) {
        low = lesser(low, v[k]);
        high = larger(high, v[k]);
    }
    if (low < -DBL_MAX) return low;
    if (high > DBL_MAX) return high;
    for (k = 0; k < 4; k++) sum += w[k] * v[k];
    /* No rounding takes it beyond the numbers: here, so that 4 times the sum
     * does not overflow, and below, as 0.25 * low may be rounded. */
    sum = 4.0 * larger(0.25 * low, lesser(sum, 0.25 * high));
    return larger(low, lesser(sum, high));
}

/* tess_values - where there is no start, a walk starts from the last answer: it
 * is the nearest if the queries are in order, and if not, tess_locate
 * notices. */
int tess_values(const tess_real *p, tess_int ntet, const tess_int *tet,
                const tess_int *adj, tess_int nv, const double *value,
                tess_int nq, const tess_real *q, tess_int *t, double *out)
{
    double w[4], v[4];
    const double *row[4];
    tess_int i, j, last = TESS_NONE;
    int code, k, m, outside = 0;

    if (ntet < 1) return -2;
    if (nv < 0) return -5;
    if (nq < 0 || nq > TESS_INT_MOST / 3) return -7;
    if (hh_finite(nq, q) < nq) return -8;
    for (i = 0; i < nq; i++)
        if (t[i] < -1 - ntet || t[i] >= ntet) return -9;
    for (i = 0; i < nq; i++, out += nv) {
        if (t[i] != TESS_NONE) last = t[i] < 0 ? -2 - t[i] : t[i];
        code = tess_locate(p, ntet, tet, adj, q + 3 * i, &last, w);
        if (code != 0 && code != 1) return code;
        t[i] = code == 1 ? -2 - last : last;
        if (code == 1) outside = 1;
        for (k = m = 0; k < 4; k++)
            if (w[k] > w[m]) m = k;
        /* in place of a vertex of weight 0 one that counts */
        for (k = 0; k < 4; k++)
            row[k] = value + (size_t)nv *
                                 (size_t)tet[4 * last + (w[k] > 0.0 ? k : m)];
        for (k = 0; k < 4; k++) w[k] *= 0.25;
        for (j = 0; j < nv; j++) {
            for (k = 0; k < 4; k++) v[k] = row[k][j];
            out[j] = weighted_mean(w, v);
        }
    }
    return outside;
}

/* ---- the hull ---- */

/* tess_hull - one pass over all facets. */
int tess_hull(tess_int ntet, const tess_int *tet, const tess_int *adj,
              tess_int maxfac, tess_int *nfac, tess_int *fac)
{
    tess_int t;
    int k;

    *nfac = 0;
    if (ntet < 0) return -1;
    if (maxfac < 0) return -4;
    for (t = 0; t < ntet; t++)
        for (k = 0; k < 4; k++)
            if (adj[4 * t + k] <= TESS_NONE) {
                if (*nfac < maxfac) tet_facet(tet + 4 * t, k, fac + 3 * *nfac);
                ++*nfac;
            }
    return *nfac > maxfac ? TESS_MORE : TESS_OK;
}

/* ---- the check ---- */

/* Uses of points. */
#define REPEATED (-1) /* a duplicate of a point of lower number */
#define UNUSED 0       /* no duplicate, and in no tetrahedron */
#define USED 1         /* no duplicate, and in a tetrahedron */

/* in_tet_box - returns 1 if q is in the closed box of the tetrahedron v: exact,
 * and much cheaper than orientations. */
static int in_tet_box(const tess_real *p, const tess_int *v, const tess_real *q)
{
    int i, k, low, high;

    for (k = 0; k < 3; k++) {
        low = high = 0;
        for (i = 0; i < 4; i++) {
            if (p[3 * v[i] + k] <= q[k]) low = 1;
            if (p[3 * v[i] + k] >= q[k]) high = 1;
        }
        if (low == 0 || high == 0) return 0;
    }
    return 1;
}

/* mark_duplicates - sorts the points by their coordinates, equal ones by
 * number, and finds the use of each, REPEATED or UNUSED.  Runs of 1, 2, 4, ...
 * are merged back and forth between the halves of iw, lo ... mid-1 and mid ...
 * hi-1; of equal points those of the first run come first.  Returns where in iw
 * the uses begin, 0 or n. */
static tess_int mark_duplicates(tess_int n, const tess_real *p, tess_int *iw)
{
    tess_int at = 0, run = 1, lo, mid, hi, i, j, k, *from, *to;

    for (i = 0; i < n; i++) iw[i] = i;
    while (run < n) {
        from = iw + at;
        at = n - at;
        to = iw + at;
        for (lo = k = 0; lo < n; lo = hi) {
            mid = run < n - lo ? lo + run : n;
            hi = run < n - mid ? mid + run : n;
            for (i = lo, j = mid; k < hi; k++)
                if (j == hi ||
                    (i < mid && !lex_before(p + 3 * from[j], p + 3 * from[i])))
                    to[k] = from[i++];
                else
                    to[k] = from[j++];
        }
        run = run < n - run ? 2 * run : n;
    }
    from = iw + at;
    to = iw + (n - at);
    for (i = 0; i < n; i++)
        to[from[i]] = i == 0 || lex_before(p + 3 * from[i - 1], p + 3 * from[i])
                          ? UNUSED
                          : REPEATED;
    return n - at;
}

/* check_planar - checks that all points are in one plane: that of point 0, of
 * b, a point that differs from it, and of c, the first point off their line.
 * Points before c are in it, so one pass is enough. */
static int check_planar(tess_int n, const tess_real *p, tess_int *bad)
{
    const tess_real *q, *b = p, *c = NULL;
    tess_int i;
    int s;

    for (i = 1; i < n; i++) {
        q = p + 3 * i;
        s = c != NULL ? hh_horient(p, b, c, q) : 0;
        if (s != 0) {
            *bad = i;
            return s == UNSURE ? TESS_RANGE : TESS_BAD_POINT;
        }
        if (c == NULL && !hh_collinear(p, b, q)) c = q;
        if (lex_before(p, b) == lex_before(b, p)) b = q;
    }
    return TESS_OK;
}

/* check_vertices - checks that the vertices of the tetrahedron v are four
 * points, none a duplicate of one of lower number, and notes that they are
 * used. */
static int check_vertices(tess_int n, const tess_int *v, tess_int *use)
{
    int i;

    for (i = 0; i < 4; i++)
        if (v[i] < 0 || v[i] >= n || place_in_four(v, v[i]) < i)
            return TESS_BAD_INDEX;
    for (i = 0; i < 4; i++) {
        if (use[v[i]] == REPEATED) return TESS_BAD_TWIN;
        use[v[i]] = USED;
    }
    return TESS_OK;
}

/* check_neighbours - checks that each facet of tetrahedron t is on the boundary
 * or matched, and that the neighbour's apex is not inside the ball of t: this
 * is symmetric, as being matched is, so one of the two tests it. */
static int check_neighbours(const tess_real *p, tess_int ntet,
                            const tess_int *tet, const tess_int *adj,
                            tess_int t)
{
    const tess_int *v = tet + 4 * t;
    tess_int u;
    int k, j, s;

    for (k = 0; k < 4; k++) {
        u = adj[4 * t + k];
        if (u == TESS_NONE) continue;
        if (u < 0 || u >= ntet) return TESS_BAD_ADJ;
        j = matching_facet(tet, t, k, u);
        if (j == 4 || adj[4 * u + j] != t) return TESS_BAD_ADJ;
        if (u < t) continue;
        s = hh_hinsphere(p + 3 * v[0], p + 3 * v[1], p + 3 * v[2], p + 3 * v[3],
                         p + 3 * tet[4 * u + j]);
        if (s > 0) return s == UNSURE ? TESS_RANGE : TESS_BAD_BALL;
    }
    return TESS_OK;
}

/* check_orientation - checks that tetrahedron t is positively oriented and has
 * no open facet. */
static int check_orientation(const tess_real *p, const tess_int *tet,
                             const tess_int *adj, tess_int t)
{
    const tess_int *v = tet + 4 * t;
    int s;

    s = hh_horient(p + 3 * v[0], p + 3 * v[1], p + 3 * v[2], p + 3 * v[3]);
    if (s != 1) return s == UNSURE ? TESS_RANGE : TESS_BAD_SIGN;
    return place_in_four(adj + 4 * t, TESS_OPEN) < 4 ? TESS_BAD_OPEN : TESS_OK;
}

/* check_convex - checks the boundary facets of tetrahedron t: O is inside of
 * each, and the apex of the next boundary facet at each of its edges is not
 * outside of it.  The two facets at an edge run along it in opposite
 * directions, so that one of them tests it.
 *
 * Facets are known to be matched in pairs, so a step of next_hull_facet maps
 * (tetrahedron, facet in, facet out) one-to-one to the next such triple; no
 * step leads to the first triple, so none comes twice and the turn ends.  For
 * the same reason all turns together take at most 6 ntet steps: each edge of
 * each tetrahedron is passed once. */
static int check_convex(const tess_real *p, tess_int ntet, const tess_int *tet,
                        const tess_int *adj, tess_int t)
{
    tess_int f[3], u, z;
    int k, i, j, s;

    for (k = 0; k < 4; k++) {
        if (adj[4 * t + k] != TESS_NONE) continue;
        tet_facet(tet + 4 * t, k, f);
        s = side_of_qstar(p, f, p + 3 * tet[0], tet);
        for (i = 0; i < 3 && s <= 0; i++) {
            if (f[i] > f[(i + 1) % 3]) continue;
            u = t;
            j = k;
            z = f[(i + 2) % 3];
            (void)next_hull_facet(ntet, tet, adj, &u, &j, &z);
            s = hh_horient(p + 3 * f[0], p + 3 * f[1], p + 3 * f[2], p + 3 * z);
        }
        if (s > 0) return s == UNSURE ? TESS_RANGE : TESS_BAD_HULL;
    }
    return TESS_OK;
}

/* check_cover - checks that tetrahedron t, if not 0, does not contain O. */
static int check_cover(const tess_real *p, const tess_int *tet, tess_int t)
{
    const tess_real *q = p + 3 * tet[0];
    int k;

    if (t == 0 || !in_tet_box(p, tet + 4 * t, q)) return TESS_OK;
    k = exit_facet(p, tet + 4 * t, 4, q, tet);
    if (k < 0) return TESS_RANGE;
    return k < 4 ? TESS_OK : TESS_BAD_COVER;
}

/* tess_check - a proof by finitely many exact tests.
 *
 * Let O be q* for q = the first vertex of tetrahedron 0 (see "queries"): a
 * point in the interior of tetrahedron 0 and on no facet's plane.  Tested are:
 *   1  each tetrahedron has four points as vertices, none a duplicate of a
 *      point of lower index, and is positively oriented;
 *   2  each facet is on the boundary, or matched with a facet of another
 *      tetrahedron that has the same vertices and lies on the other side;
 *   3  across a matched facet, the neighbour's apex is not inside the ball;
 *   4  O is inside of each boundary facet;
 *   5  at each edge of a boundary facet, the next boundary facet, found by
 *      turning about the edge through the tetrahedra, has its apex not
 *      outside of the first;
 *   6  no tetrahedron but 0 holds O;
 *   7  each point that is no duplicate is a vertex.
 *
 * a.  For a point x on no facet let m(x) be the number of tetrahedra that hold
 *    it.  By 1 and 2 it is the number of times that the boundary, oriented
 *    outwards, winds about x: the sum of that number over the surfaces of
 *    all tetrahedra, in which matched facets cancel.  The turns of 5 pair the
 *    edges of boundary facets, which thus form a closed surface S; two that are
 *    adjacent run along their edge in opposite directions.
 * b.  By 4, projection from O takes the facets of S to triangles on the sphere
 *    of directions, all of one orientation, adjacent ones on opposite sides
 *    of their edge.  So S covers the sphere, branching at most at vertices, and
 *    the number of sheets is the winding number about O: m(O), which is 1 by 6.
 *    One sheet cannot branch: each ray from O meets S once.  S bounds a body K,
 *    star-shaped about O; m is 1 in K, 0 outside.
 * c.  A plane through O that misses the vertices of S cuts K in a polygon
 *    which is star-shaped about O and has by 5 no angle above pi: convex.
 *    Such planes are dense, so K is convex.
 * d.  So the tetrahedra fill K once, facet matched to facet: any two meet in a
 *    common face or not at all.  A triangulation of a convex body that
 *    satisfies 3 is Delaunay (Delaunay's lemma).  By 7 it is one of all points,
 *    and K is their hull.
 *
 * Conversely a Delaunay tetrahedralization passes: O is inside its hull.
 *
 * No test is redundant.  For 4: two tetrahedra apart; or the tetrahedra on an
 * axis and the edges of a star of five points about it, O in a tip of the star.
 * For 6: join the 20 triangles of the great icosahedron to its centre.  These
 * tetrahedra pass all other tests, and V - E + F - T = 1, though they cover the
 * centre 7 times.  Euler's relation follows from the seven tests.
 *
 * Nothing is relied on before it is tested: indices before points are read,
 * the matching of all facets before a turn.  TESS_RANGE when the limbs do
 * not suffice for a test.
 *
 * Cost: O(n log n) for sorting; one orientation and two inspheres for each
 * tetrahedron, and about three orientations for each boundary facet. */
int tess_check(tess_int n, const tess_real *p, tess_int ntet,
               const tess_int *tet, const tess_int *adj, tess_int liw,
               tess_int *iw, tess_int *bad)
{
    tess_int t, i, *use;
    int pass, code = TESS_OK;

    *bad = TESS_NONE;
    if (n < 0 || n > TESS_INT_MOST / 3) return -1;
    if (hh_finite(n, p) < n) return -2;
    if (ntet < 0 || ntet > MAXTET_MOST) return -3;
    if (liw < n || liw - n < n) return -6;
    if (!hh_holds(n, p)) return TESS_RANGE;
    if (ntet == 0) return check_planar(n, p, bad);
    use = iw + mark_duplicates(n, p, iw);
    for (pass = 0; pass < 5; pass++)
        for (t = 0; t < ntet; t++) {
            if (pass == 0) code = check_vertices(n, tet + 4 * t, use);
            if (pass == 1) code = check_orientation(p, tet, adj, t);
            if (pass == 2) code = check_neighbours(p, ntet, tet, adj, t);
            if (pass == 3) code = check_convex(p, ntet, tet, adj, t);
            if (pass == 4) code = check_cover(p, tet, t);
            if (code != TESS_OK) {
                *bad = t;
                return code;
            }
        }
    for (i = 0; i < n; i++)
        if (use[i] == UNUSED) {
            *bad = i;
            return TESS_BAD_POINT;
        }
    return TESS_OK;
}

/* ---- a ball ---- */

/* tess_ball - computed by limbs, for a set of the four points alone, scaled to
 * at most 1.  size is the sum of what is rounded.  The centre errs by 8 eps of
 * its length (see hh_centre); the radius must cover that, its own error of 12
 * eps, and the roundings of the sum, 1 eps of it: less than 32 eps size. */
int tess_ball(const tess_real *p, const tess_int *v, double *c)
{
    static const tess_int facet[3] = {0, 1, 2};
    const tess_real *q;
    hh_set set;
    hh_ball t;
    double most = 0.0, size = 0.0, r = 0.0, x[3];
    int i, k;

    c[3] = DBL_MAX;
    for (i = 3; i >= 0; i--) {
        if (v[i] < 0) return -2;
        q = p + 3 * v[i];
        if (hh_finite(1, q) < 1) return -1;
        if (!hh_holds(1, q)) return TESS_RANGE;
        for (k = 0; k < 3; k++) {
            c[k] = (double)q[k];
            most = larger(most, fabs(c[k]));
        }
    }
    frexp(most, &set.exponent);
    set.p = p;
    set.order = v;
    if (most == 0.0 || !hh_centre(&set, facet, 0, 3, x, &t)) return TESS_OK;
    for (k = 0; k < 3; k++) {
        size += fabs(x[k]);
        r += x[k] * x[k];
        x[k] += ldexp(c[k], -set.exponent);
        size += fabs(x[k]);
    }
    r = sqrt(r) + ROUNDING * size + 4.0 * DBL_MIN;
    frexp(r + size, &k);
    if (k + set.exponent >= DBL_MAX_EXP) return TESS_OK;
    for (k = 0; k < 3; k++) c[k] = ldexp(x[k], set.exponent);
    c[3] = ldexp(r, set.exponent) + 4.0 * DBL_MIN;
    return TESS_OK;
}

long tess_edition(void)
{
    return TESS_VERSION;
}
