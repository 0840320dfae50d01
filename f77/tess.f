C     tess.f - Delaunay tetrahedralization of points in space.
C
C     SPDX-License-Identifier: 0BSD
C     Copyright (c) 2026 the tess authors
C
C     Permission to use, copy, modify, and/or distribute this software
C     for any purpose with or without fee is hereby granted.
C
C     THE SOFTWARE IS PROVIDED "AS IS" AND THE AUTHOR DISCLAIMS ALL
C     WARRANTIES WITH REGARD TO THIS SOFTWARE INCLUDING ALL IMPLIED
C     WARRANTIES OF MERCHANTABILITY AND FITNESS. IN NO EVENT SHALL THE
C     AUTHOR BE LIABLE FOR ANY SPECIAL, DIRECT, INDIRECT, OR
C     CONSEQUENTIAL DAMAGES OR ANY DAMAGES WHATSOEVER RESULTING FROM
C     LOSS OF USE, DATA OR PROFITS, WHETHER IN AN ACTION OF CONTRACT,
C     NEGLIGENCE OR OTHER TORTIOUS ACTION, ARISING OUT OF OR IN
C     CONNECTION WITH THE USE OR PERFORMANCE OF THIS SOFTWARE.
C
C     The twin of tess.c, routine by routine; its predicates are those
C     of hhpred.f.  No routine allocates, reads, writes, keeps state
C     between calls or stops the program.  With local arrays on the
C     stack (gfortran -frecursive, f2c -a) all may be called from any
C     number of threads; without, from one at a time.
C
C     Arrays, the same in all routines:
C       P      point I has the coordinates P(1..3,I): any finite values,
C              in any units.  Never altered.
C       TET    tetrahedron T has the vertices TET(1..4,T), numbers of
C              points, positively oriented: det [B-A C-A D-A] > 0.
C       ADJ    ADJ(K,T) is the tetrahedron across the facet opposite to
C              TET(K,T); 0 on the hull; -1 for a facet still open, which
C              only an unfinished result has.
C
C     TET and ADJ are a function of the points and their order alone:
C     the same on every machine, with every compiler, in C and in
C     FORTRAN.
C
C     HOW THIS FILE IS LAID OUT.  It has four parts, and within a part a
C     routine stands before those that call it.
C       I    A mesh: TESS and all that it needs: slow on some data, but
C            complete.  It needs no later page but for hooks, by which
C            it asks part II.
C       II   Faster searches: a chapter for each mechanism.  A PARAMETER
C            leaves it out, and no result changes.
C       III  Without a whole mesh: one star on its own, parts, queries.
C       IV   Using a mesh: location, values, the hull, the check, a
C            ball.
C     Each routine says its name in tess.c, in brackets; those of the
C     manual have the same names, cut to six letters.
C
C     THE ALGORITHM, after C. Hazlewood, "Facet-Based Tetrahedralization
C     Software" (1995), Section 2.  The mesh grows from one facet of the
C     convex hull, tetrahedron by tetrahedron; none is ever deleted.
C
C       1  Sort the points into a k-d tree, without duplicates: TSSORT.
C          (J. L. Bentley, Comm. ACM 18, 1975, 509-517; J. H. Friedman,
C          J. L. Bentley and R. A. Finkel, ACM Trans. Math. Software 3,
C          1977, 209-226.)
C       2  Find a facet of the hull by gift wrapping: TSFIRS.  It is
C          open: the tetrahedron on its inner side is unknown.
C       3  Take an open facet: TSSTAR.
C       4  Find its apex: of the points strictly on its open side the
C          one whose ball, through the facet and that point, has none of
C          the others inside: TSAPEX.  If there is no such point, the
C          facet is one of the hull.
C       5  Store the tetrahedron of facet and apex: TSADDT.  Each of its
C          other three facets is either the other side of an open facet,
C          and both are closed, or it is open from now on: TSMOPU,
C          TSMOEN.
C       6  Repeat from 3 until no facet is open.
C
C     The search for an apex compares points by their L-coordinates, of
C     which the apex has the least (Theorem 1).  It keeps the best point
C     so far.  The ball of facet and best point contains every better
C     one (Lemma 3), so TSTREE, which goes from the facet's own leaf up
C     to the root, skips the nodes whose boxes are outside of that ball.
C
C     ORDER OF THE WORK.  Facets are taken star by star: all open facets
C     at one vertex, then those at the next.  A vertex whose star is
C     complete can never again be an apex, so it leaves the tree, and
C     the pool of open facets stays small.  The order is a function of
C     the points, TET and ADJ alone, so an unfinished result needs no
C     other state:
C       star   S = the first vertex of the last tetrahedron, if it has
C              an open facet; else the vertex of least position that has
C              one
C       facet  the open facet at S of the earliest tetrahedron, and of
C              those of that tetrahedron the one of greatest K
C
C     DECISIONS.  Every decision that affects TET or ADJ is exact: a
C     comparison of the caller's coordinates, or a predicate of hhpred.
C     Floating point only chooses where to look, with margins that cover
C     its rounding.
C
C     The tie rule of hhpred decides where more than four points are on
C     one empty ball.  On it rest the emptying of the pool, as each
C     facet of a tetrahedron leads to the same one; TSFIRS, on a hull
C     face of more than three points; TSCHKU; cospherical sets; HHPINS,
C     where it takes both candidates to be on the positive side; TSWALK
C     and TSINCT, which take heights to be lowered.
C
C     GLOSSARY of part I; each chapter of part II has its own.
C       number         a point's index in the caller's P
C       position       its place in the sorted order; all internal
C                      arrays use it
C       leaf, node     a run of at most LEAFPT successive positions; a
C                      node of the k-d tree: a leaf or what is above
C                      leaves
C       box            the bounding volume of a node's points, along the
C                      axes
C       alive          of a leaf, how many of its points are
C                      uncompleted, that is, have a star that is not
C                      complete; of another node, how many of its
C                      children are not empty
C       facet          three vertices, turned so that the open side is
C                      positive
C       open side      where the unknown tetrahedron is
C       code           of facet K of tetrahedron T, opposite to its
C                      vertex K: 4(T-1)+K, its place in ADJ
C       open facet     one whose other side is not known yet: ADJ is
C                      OPEN
C       owner          of an open facet: of its wanted vertices the one
C                      of least position
C       seed edge      an open facet that belongs to no tetrahedron yet
C       star of S      all tetrahedra that have the vertex S
C       hub            a vertex with a very large star
C       link of S      here the open facets at S, as directed edges
C                      A -> B, so that (S, A, B) is positive towards the
C                      unknown side
C       wanted         a vertex whose star is asked for: any, except in
C                      a part
C       guess          a point that a search compares first: from the
C                      link, it is the apex two times out of three;
C                      without guesses the worst of the tests' 24
C                      families of points takes 4.7 times the
C                      instructions
C
C       candidate      an uncompleted point strictly on the open side
C       base           the vertex from which side and power are computed
C       W              a point minus the base
C       side           of a point: V.W, V being the facet's unit normal
C       L-coordinate   of a point: the signed height over the facet of
C                      the centre of the ball through the facet and the
C                      point
C       apex           the candidate of least L, ties by the rule of
C                      hhpred
C       best point     the apex among the points compared so far
C       better         said of a candidate that would replace the best
C                      point
C       ball           that of the facet and the best point, or of an
C                      upper bound of its L: every better point is in it
C       power          of W: |W|**2 - 2 C.W, negative inside the ball of
C                      centre C through the base
C       filter         an inequality that every better point satisfies:
C                      points, boxes and what part II keeps are tested
C                      against it
C       surface        of part II: a plane or a sphere that many points
C                      are near; the mark of such a point tells its
C                      height over it.  Without part II there is none
C       offered        said of a point that has gone through TSOFFP
C       limb           a digit of an exact number, kept in a double:
C                      see hhpred.f
C       undecided      said of a comparison that the bounds of doubles
C                      leave open
C       stage          what may end a search before the tree does
C       E, dc, rho     the error of the unit normal; that of the
C                      circumcentre; the circumradius: see HHFACE
C
C     A function that returns 1 if something holds returns 0 if not.
C
C     THE ARRAYS (N points, NP of them distinct; L leaves: TSLCOU(N) in
C     the arrays' lengths, TSLCOU(NP) in the tree).  TET holds positions
C     during a call, numbers of points again when it returns; ADJ is as
C     the caller sees it.
C
C       IW behind        length   during a call           on return
C       0         REP    N        number -> the least     the same; in
C                                 number of the points    an index
C                                 that coincide with it   number ->
C                                                         position
C       N         ORD    N        position -> number      the same
C       2 N       KNOWN  5        in an index as it was,  see TSWHDR
C                                 else KNOWN(1) and the
C                                 last one are 0
C       + 5       ALIVE  2 L - 1  node -> how much of it  all of it
C                                 is alive
C       + 2 L - 1 COUNTS 1        in an index as it was   the number of
C                                                         surfaces
C       + 1       MARK   0 or     what surfaces keep, if  the same
C                        marks    LIW is what TESSWK
C                                 gives
C       + marks   HEAD   N        position -> first       scratch
C                                 entry that it owns, 0,
C                                 or UNWANT; in TSCHKU,
C                                 number -> position
C       + N       LINK   N        position -> first edge  scratch
C                                 from it, 0, NEW or
C                                 COMPLE
C       + N       POOL   POOLLN   see below               scratch
C       RW behind
C       0         X      3 N      position -> scaled      the same
C                                 coordinates
C       3 N       BOX    12 L     of each node            the same; the
C                                                         last one is a
C                                                         header: see
C                                                         TSWHDR
C       + 12 L    CYL    0 or     theirs, if LRW is what  the same
C                        more     TESSWK gives
C
C       POOL 1            ENTLEN*SLOTS    NEWEST       OLDEST    POOLLN
C            | entries of the table |free|<- edges of the link | dead|
C
C       HEAD(V) --> entry <--> entry <--> entry   facets that V owns
C       LINK(A) --> edge   --> edge   --> edge    edges from A: ECHAIN
C
C       tree  node          1            node I: children 2I and 2I+1,
C                       2       3        ALIVE(I), BOX(1..6,I)
C             leaf    1   2   3   4      leaf J: node L + J - 1 (L = 4)
C             X     |...|...|...|...|    its points have successive
C                                        positions

C     ==================================================================
C     PART I: A MESH
C     ==================================================================

C     ------------------------------------------------------------------
C     Codes, arrays and constants
C
C     Only in C: norm1, minus, larger, lesser, point, map_four, and
C     filter_of_mark, which is written out here.  Only here: TSPDIS
C     (boxes_disjoint for a point), TSLINE (hh_collinear of points of
C     P), TSONSP and TSPAYS (the macros HAS_SPHERE and SURFACES_PAY),
C     TSWORK, TSMESH, TSINDE, TSQUER (parts of tess_resume and
C     tess_part, tess_index, tess_query), TSORIQ, TSORIP, TSFOOT
C     (hh_orient and hh_foot of points of P).
C
C     Everything counts from 1; none is 0.  What tess.c keeps in its
C     structures are arrays here.  All routines have their arguments in
C     one order: what the mesh is, what only speeds up, the search, and
C     what is not named here.  (N is that of P; ROOM and FOUND are the
C     caller's MAXTET and NTET.)
C       points     N X P ORD MASKED MINE
C       mesh       MAXTET ROOM NTET FOUND TET ADJ
C       tree       BOX CYL ALIVE
C       vertices   REP HEAD LINK POOL MARK
C       state      CTL RCTL
C       hints      HNT SUP LSX LSID LSD
C       search     IQ FQ
C       workspace  LIW IW LRW RW
C       index      HEADER KNOWN COUNT COUNTS
C     A place in one of these arrays is a constant, the same in every
C     routine that has it.  In each row below, and in those of the
C     chapters: its name, = its number, the field in C, or the macro (-
C     if there is none), and what it is.  "Behind" means that the first
C     element is one place on.  A constant on which no result depends
C     trades time and memory, and says for what; if correctness rests on
C     one, its row says so.  Arrays:
C       P      array p  the points that were given
C       X      array x  position -> scaled coordinates, X(1..3,position)
C       ORD    array order  position -> number
C       BOX    array box  the box of a node of the tree: least, then
C               greatest coordinates.  Node I has the children 2I, 2I+1;
C               leaf J is node CTL(LEAVES)+J-1
C       ALIVE  array alive  of a leaf, its uncompleted points; of
C               another node, its non-empty children
C       REP    array representative  number -> the least number of the
C               points that coincide with it
C       TET    array tet
C       ADJ    array adj
C       KNOWN  array first_tet  a tetrahedron; in an index KNOWN(1) may
C               be minus a code
C       HEAD   array owned  the first entry that a vertex owns, 0, or
C               UNWANT
C       LINK   array edge_from  the first edge from a vertex, 0, NEW or
C               COMPLE
C       POOL   array pool  entries of the table, and edges
C     CTL, integers: what the mesh is.
C       LCTL   = 17  -  its length
C       NP     = 1   np  the number of distinct points
C       NTET   = 2   ntet  the number of tetrahedra
C       MAXTET = 3   maxtet  how many tetrahedra there is room for
C       LEAVES = 4   leaves  the number of leaves, a power of two
C       POOLLN = 5   pool_len  the length of POOL
C       SLOTS  = 6   slots  the number of slots of the pool's table
C       NFACET = 7   nfacets  the number of facets in the table
C       UNFILE = 8   unfiled  from this tetrahedron on, facets 1 are not
C               in the table yet
C       OLDEST = 9   oldest_edge  the first edge of the link, the
C               highest
C       NEWEST = 10  newest_edge  the last edge of the link, the lowest
C       LOWEST = 11  lowest_owner  no vertex of a smaller position owns
C               facets
C       NEXTNE = 12  next_new  of a part: no wanted vertex of a smaller
C               position is NEW; a whole mesh meets all
C       SCALE  = 13  exponent  X = P 2**(-SCALE)
C       FIRSTT = 13  first_tet  behind it, of an index, the positions of
C               KNOWN, 4 long
C     RCTL, its doubles, and what part II keeps for longer than one
C     search:
C       LRCTL  = 140 -  its length
C       EXACT3 = 1   exact3  see HHFIL3
C       EXACT5 = 2   exact5  see HHFIL5
C       RLEAST = 3   least_abs  the least absolute value above 0 of a
C               caller's coordinate
C     HNT, integers: what part II keeps for longer than one search.  The
C     chapters list its places.  A new one comes last, and makes LHNT
C     longer here and in each PARAMETER that has it.
C       LHNT   = 261 -  its length
C     A filter S.  Every better point W satisfies
C         |W|**2 - 2 C.W + weight (height(W) - base height)
C             <= allowance + SIZE (2 dc + 8 EPS (SIZE + 2 c1)),
C     W being seen from the base, SIZE >= |W|_1, height(W) its height
C     over the facet's reference surface.  The right-hand side is
C     TSFBND.
C       LFILT  = 8   -  its length
C       VC     = 0   c  behind it C, the centre of the ball, seen from
C               the base
C       VDC    = 4   dc  dc, a bound on the error of C, with 0.5 % to
C               spare
C       VC1    = 5   c1  c1 = |C|_1
C       VWEIGH = 6   weight  the factor of heights; only of a surface
C               filter
C       VBASEH = 7   base_height  the base's height; only of a surface
C               filter
C       VALLOW = 8   allowance  the part of the bound that does not
C               depend on W
C     A ball and a sphere by limbs, see hhpred.f:
C       LBALL  = 85  -  of a ball
C       LSPHER = 52  -  of a sphere
C       SREADY = 1   ready  see hhpred.f
C     F, a facet's set-up, see HHFACE:
C       LF     = 12  HH_FACET_LEN  its length
C       FNORM  = 0   HH_NORMAL  behind it the normal
C       FCEN   = 3   HH_CENTRE  behind it the centre of the
C               circumcircle, from the base
C       FBASE  = 6   HH_BASE  behind it the base
C       FE     = 10  HH_E
C       FDC    = 11  HH_DC
C       FRHO   = 12  HH_RHO
C     A search for the apex of one facet.  IQ, its integers:
C       LIQ    = 51  -  its length
C       QFACET = 0   facet  behind it the facet's vertices, 3 long; the
C               open side is positive
C       QBEST  = 4   best  the best point so far, exactly, or 0
C       QBASE  = 5   base  the base is IQ(QFACET+IQ(QBASE))
C       QTIES  = 6   ties  how many points met are exactly on the best
C               point's ball
C       QHASBA = 7   has_ball  1: the filter is a ball's; 0: a
C               half-space's
C       QBYLIM = 8   by_limbs  1: the ball was found by limbs
C       QINLIS = 9   in_lists  1: candidate lists may hold its ball
C       QNODES = 10  nodes  how many nodes the search has visited
C     FQ, its doubles:
C       LFQ    = 183 -  its length
C       QHH    = 0   hh  behind it F, LF long; if its surface is a
C               sphere, L counts from another centre
C       QLO    = 13  lo  the best point's L-coordinate is at least this
C       QHI    = 14  hi  and at most this
C       QFILT  = 14  filter  behind it the filter without heights, LFILT
C               long
C     An entry of the pool's table, behind POOL(ENTLEN*(E-1)):
C       ENTLEN = 4   ENTRY_LEN  its length
C       PCODE  = 1   ENTRY_CODE  the facet's code, or 0
C       PNEXT  = 2   ENTRY_NEXT  the owner's next entry
C       PPREV  = 3   ENTRY_PREV  the owner's previous entry
C       PSIG   = 4   ENTRY_SIG  the hash
C     An edge of the link, at POOL(E):
C       EDGLEN = 6   EDGE_LEN  its length
C       ECODE  = 0   EDGE_CODE  the facet's code, or one of the two
C               below
C       ESEED  = -1  SEED_EDGE  in ECODE: the facet belongs to no
C               tetrahedron yet
C       EDEAD  = -2  DEAD_EDGE  in ECODE: the edge is not in the link
C               any more
C       EFROM  = 1   EDGE_FROM  A of the edge A -> B,
C       ETO    = 2   EDGE_TO  B
C       EPREV  = 3   EDGE_PREV  an edge that ends at A, or 0
C       ENEXT  = 4   EDGE_NEXT  an edge that begins at B, or 0
C       ECHAIN = 5   EDGE_CHAIN  the next edge from A, or 0
C     Codes:
C       NONE   = 0   NONE  no position, entry, edge, surface or code of
C               a facet
C       UNSURE = 2   UNSURE  a sign that bounds, or too few limbs, leave
C               open
C       BEATS  = -1  BEATS  an answer of TSCMPE, and of HHPINS but for
C               REJECT: the point is better than the best point;
C       LOSES  = 1   LOSES  it is not;
C       REJECT = 0   REJECTED  it is not, and its L-coordinate tells
C               nothing
C       TIE    = 3   HH_TIE  see HHPINS
C       COMPLE = -1  COMPLETE  in LINK: the vertex's star is complete
C       NEW    = -2  NEW  in LINK: the vertex is in no tetrahedron yet
C       UNWANT = -1  UNWANTED  in HEAD: the vertex's star is not asked
C               for
C       OPEN   = -1  TESS_OPEN  in ADJ: a facet still open
C       MORE   = 1   TESS_MORE
C       FULL   = 2   TESS_POOL
C       PLANAR = 3   TESS_PLANE
C       LINEAR = 4   TESS_LINE
C       SINGLE = 5   TESS_POINT
C       RANGE  = 6   TESS_RANGE
C     The arithmetic:
C       INTMAX = 2147483647 -  the largest integer
C       HHLIM  = 88  HH_LIMBS  see hhpred.f
C       BITS   = 24  HH_BITS  bits of a limb
C       DBLDIG = 53  DBL_MANT_DIG  bits of a double
C       DBLEXP = 1024 DBL_MAX_EXP
C       HUGE   = (2.0D0-2.0D0**(-52))*2.0D0**1023 DBL_MAX
C       NORMAL = 2.0D0**(-1022) DBL_MIN
C       FLTMIN = 2.0D0**(-126) FLT_MIN
C     Constants that correctness rests on.  EPS and FEPS bound the
C     relative error of one operation in every rounding mode, in double
C     and in single precision.  A sum of three numbers, in any order,
C     errs by twice that.  Each bound made of them has a row in
C     test/bounds, which says how it is derived and checked.
C       EPS    = 2.0D0**(-52) EPS
C       FEPS   = 2.0D0**(-23) FEPS
C       HHEMAX = 0.5D0 HH_E_MAX  see hhpred.f
C       LENMIN = 2.0D0**(-450) HH_LENGTH_MIN  see hhpred.f
C       ROUNDG = 64.0D0*2.0D0**(-52) ROUNDING  relative room for the few
C               roundings of a bound
C     Constants of all parts:
C       LEAFPT = 48  LEAF_POINTS  maximum number of points in a leaf;
C               the leaf of S is the block of its lists.  Trades nodes
C               against points scanned
C       LEAFGR = 8   LEAF_GROUP  size of the groups that a leaf's points
C               are sorted into: a search looks at the least power of a
C               group first.  It also suits the width of vectors
C     The chapters of part II only make searches faster: with 0 in every
C     PARAMETER of this name one is left out, and the results are the
C     same.  Near lists and cospherical sets are made from lists.  A
C     chapter's places are there all the same.
C       CHLIST = 1   TESS_NO_LISTS  1: there are candidate lists
C       CHNEAR = 1   TESS_NO_NEAR_LISTS  near lists
C       CHHULL = 1   TESS_NO_HULL_PLANES  hull planes
C       CHSETS = 1   TESS_NO_SETS  cospherical sets
C       CHCYLI = 1   TESS_NO_CYLINDERS  cylinders
C       CHCAPS = 1   TESS_NO_CAPS  caps
C       CHLIMB = 1   TESS_NO_LIMBS  limbs, and views of clumps
C       CHSURF = 1   TESS_NO_SURFACES  reference surfaces
C     ------------------------------------------------------------------

C     ------------------------------------------------------------------
C     The tree, and its sort
C
C     The points are sorted so that those of a node have successive
C     positions; the tree is the numbers NP and LEAVES, a box for each
C     node, and how much of it is alive.
C
C     Constants:
C       EXTSAM = 64  EXTENT_SAMPLE  a node is cut across the widest
C               extent of about so many of its points; with all of them
C               a million points take 3 % longer
C     ------------------------------------------------------------------

C     TSLFST (leaf_start) - returns the first position of leaf J, which
C     ends before TSLFST(CTL, J+1).
      INTEGER FUNCTION TSLFST(CTL, J)
      INTEGER CTL(*), J
      INTEGER NP, LEAVES
      PARAMETER (NP = 1, LEAVES = 4)
      TSLFST = (J - 1)*(CTL(NP)/CTL(LEAVES)) + MIN(J - 1, MOD(CTL(NP),
     $    CTL(LEAVES))) + 1
      END

C     TSLEAF (leaf_of) - returns the leaf that holds position I.
      INTEGER FUNCTION TSLEAF(CTL, I)
      INTEGER CTL(*), I
      INTEGER NP, LEAVES
      PARAMETER (NP = 1, LEAVES = 4)
      INTEGER EXTRA, LENGTH
      LENGTH = CTL(NP)/CTL(LEAVES)
      EXTRA = MOD(CTL(NP), CTL(LEAVES))
      IF (I .LE. EXTRA*(LENGTH + 1)) THEN
        TSLEAF = (I - 1)/(LENGTH + 1) + 1
      ELSE
        TSLEAF = EXTRA + (I - 1 - EXTRA*(LENGTH + 1))/LENGTH + 1
      END IF
      END

C     TSNRNG (node_range) - finds the positions FIRST ... LAST below a
C     node of the tree.
      SUBROUTINE TSNRNG(CTL, NODE, FIRST, LAST)
      INTEGER CTL(*), NODE, FIRST, LAST
      INTEGER LEAVES
      PARAMETER (LEAVES = 4)
      INTEGER TSLFST, LEFT, RIGHT
      LEFT = NODE
      RIGHT = NODE
   10 IF (LEFT .LT. CTL(LEAVES)) THEN
        LEFT = 2*LEFT
        RIGHT = 2*RIGHT + 1
        GO TO 10
      END IF
      FIRST = TSLFST(CTL, LEFT - CTL(LEAVES) + 1)
      LAST = TSLFST(CTL, RIGHT - CTL(LEAVES) + 2) - 1
      END

C     TSNEXT (next_node) - returns the node that comes behind all below
C     a node when the tree is walked from left to right, each node
C     before its children; 0 behind the last.
      INTEGER FUNCTION TSNEXT(NODE)
      INTEGER NODE
      TSNEXT = NODE
   10 IF (MOD(TSNEXT, 2) .EQ. 1) THEN
        TSNEXT = TSNEXT/2
        GO TO 10
      END IF
      IF (TSNEXT .GT. 0) TSNEXT = TSNEXT + 1
      END

C     TSAXBE (axis_before) - returns 1 if point I precedes, along an
C     axis, the point with coordinates Q and the number NUMBER, or 0.
C     Ties are broken by the next axes, then by number.
      INTEGER FUNCTION TSAXBE(X, ORD, I, AXIS, Q, NUMBER)
      DOUBLE PRECISION X(3,*), Q(3)
      INTEGER ORD(*), I, AXIS, NUMBER
      INTEGER K, PASS
      TSAXBE = 1
      K = AXIS
      DO 10 PASS = 1, 3
        IF (X(K,I) .LT. Q(K)) RETURN
        IF (X(K,I) .GT. Q(K)) GO TO 20
        K = MOD(K, 3) + 1
   10 CONTINUE
      IF (ORD(I) .LT. NUMBER) RETURN
   20 TSAXBE = 0
      END

C     TSSWAP (swap) - swaps the points at the positions I and J.
      SUBROUTINE TSSWAP(X, ORD, I, J)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), I, J
      DOUBLE PRECISION A, B, C
      INTEGER O
      O = ORD(I)
      ORD(I) = ORD(J)
      ORD(J) = O
      A = X(1,I)
      B = X(2,I)
      C = X(3,I)
      X(1,I) = X(1,J)
      X(2,I) = X(2,J)
      X(3,I) = X(3,J)
      X(1,J) = A
      X(2,J) = B
      X(3,J) = C
      END

C     TSPIVO (pivot) - I is the position of a point whose rank along an
C     axis is near MID, among LO ... HI: the point of that rank in a
C     random sample.  The random numbers are the same everywhere.
      SUBROUTINE TSPIVO(X, ORD, LO, HI, MID, AXIS, CHANCE, I)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), LO, HI, MID, AXIS, CHANCE, I
      INTEGER TSAXBE, A(33), COUNT, J, N, S, STEP, T
      COUNT = HI - LO + 1
      STEP = COUNT/1024
      N = 3
      IF (COUNT .GT. 200) N = 9
      IF (COUNT .GT. 4000) N = 33
      A(1) = LO
      DO 30 S = 1, N
        CHANCE = MOD(CHANCE*137, 30269) + 1
        IF (STEP .GT. 0) THEN
          T = LO + STEP*MOD(CHANCE, 1024) + MOD(CHANCE, STEP)
        ELSE
          T = LO + MOD(CHANCE, COUNT)
        END IF
        J = S
   10   IF (J .GT. 1) THEN
          IF (TSAXBE(X, ORD, T, AXIS, X(1,A(J-1)), ORD(A(J-1))) .EQ.
     $        1) THEN
            A(J) = A(J-1)
            J = J - 1
            GO TO 10
          END IF
        END IF
        A(J) = T
   30 CONTINUE
      I = A((MID - LO)/(COUNT/N + 1) + 1)
      END

C     TSSELE (select_rank) - reorders the points FIRST ... LAST so that
C     those before MID precede the one at MID along an axis, and the
C     others do not:  quickselect, with one pass a pivot.
      SUBROUTINE TSSELE(X, ORD, FIRST, LAST, MID, AXIS)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), FIRST, LAST, MID, AXIS
      DOUBLE PRECISION Q(3)
      INTEGER TSAXBE, AT, CHANCE, HI, I, J, LESS, LO, NUMBER
      CHANCE = 1
      LO = FIRST
      HI = LAST
   10 IF (LO .GT. MID .OR. HI .LE. LO) RETURN
      CALL TSPIVO(X, ORD, LO, HI, MID, AXIS, CHANCE, I)
      DO 20 J = 1, 3
        Q(J) = X(J,I)
   20 CONTINUE
      NUMBER = ORD(I)
C     no branch on the points except for ties: half of them would be
C     mispredicted, which takes longer than a swap
      I = LO
      DO 30 J = LO, HI
        LESS = 0
        IF (X(AXIS,J) .LT. Q(AXIS)) LESS = 1
C       halves, whose differences do not overflow
        IF (ABS(0.5D0*X(AXIS,J) - 0.5D0*Q(AXIS)) .LE. 0.0D0) THEN
          AT = J
          LESS = TSAXBE(X, ORD, AT, AXIS, Q, NUMBER)
        END IF
        CALL TSSWAP(X, ORD, I, J)
        I = I + LESS
   30 CONTINUE
C     LO ... I-1 precede the pivot, I ... HI do not
      IF (MID .LT. I) THEN
        HI = I - 1
      ELSE IF (I .GT. LO) THEN
        LO = I
      ELSE
C       the pivot precedes all others: move it to the front
        J = LO
   40   IF (ORD(J) .NE. NUMBER) THEN
          J = J + 1
          GO TO 40
        END IF
        CALL TSSWAP(X, ORD, LO, J)
        LO = LO + 1
      END IF
      GO TO 10
      END

C     TSDUPL (link_duplicate) - records in REP that the points at I and
C     J coincide, if they do.
      SUBROUTINE TSDUPL(X, ORD, REP, I, J)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), REP(*), I, J
      INTEGER K
      DO 10 K = 1, 3
        IF (X(K,I) .LT. X(K,J) .OR. X(K,I) .GT. X(K,J)) RETURN
   10 CONTINUE
      REP(MAX(ORD(I), ORD(J))) = MIN(ORD(I), ORD(J))
      END

C     TSBBOX (bounding_box) - sets B to the box of every STEP-th of N
C     points, the first at X.
      SUBROUTINE TSBBOX(X, N, STEP, B)
      DOUBLE PRECISION X(3,*), B(6)
      INTEGER N, STEP
      INTEGER I, K
      DO 10 K = 1, 3
        B(K) = X(K,1)
        B(3+K) = X(K,1)
   10 CONTINUE
      DO 30 I = 1 + STEP, N, STEP
        DO 20 K = 1, 3
          IF (X(K,I) .LT. B(K)) B(K) = X(K,I)
          IF (X(K,I) .GT. B(3+K)) B(3+K) = X(K,I)
   20   CONTINUE
   30 CONTINUE
      END

C     TSBISE (bisect) - cuts the points LO ... HI at MID, across the
C     widest extent of a sample of them.  Duplicates that the cut
C     separates all coincide with the point at MID; in the end every
C     duplicate but the least of its set is linked to a smaller number.
      SUBROUTINE TSBISE(X, ORD, REP, LO, HI, MID)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), REP(*), LO, HI, MID
      INTEGER EXTSAM
      PARAMETER (EXTSAM = 64)
      DOUBLE PRECISION B(6)
      INTEGER HHWIDE, AXIS, I, K
      CALL TSBBOX(X(1,LO), HI - LO + 1, (HI - LO + 1)/EXTSAM + 1, B)
      AXIS = 1
      DO 10 K = 2, 3
        IF (HHWIDE(B(3+K), B(K), B(3+AXIS), B(AXIS)) .GT. 0) AXIS = K
   10 CONTINUE
      CALL TSSELE(X, ORD, LO, HI, MID, AXIS)
      DO 20 I = LO, MID - 1
        CALL TSDUPL(X, ORD, REP, I, MID)
   20 CONTINUE
      END

C     TSLSOR (leaf_sort) - sorts the points of a leaf into groups of
C     LEAFGR.
      SUBROUTINE TSLSOR(X, ORD, REP, FIRST, LAST)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), REP(*), FIRST, LAST
      INTEGER LEAFGR
      PARAMETER (LEAFGR = 8)
      INTEGER TSAXBE, HALF, HI, I, J, LO
      HALF = FIRST + ((LAST - FIRST + LEAFGR)/LEAFGR + 1)/2*LEAFGR
      IF (HALF .LE. LAST) CALL TSBISE(X, ORD, REP, FIRST, LAST, HALF)
      LO = FIRST
   10 IF (LO .LE. LAST) THEN
        HI = LAST
        IF (LO .LT. HALF .AND. HALF .LE. LAST) HI = HALF - 1
        IF (LO + LEAFGR .LE. HI) CALL TSBISE(X, ORD, REP, LO, HI, LO +
     $      LEAFGR)
        HI = MIN(LO + LEAFGR - 1, HI)
        DO 40 I = LO + 1, HI
          DO 30 J = I, LO + 1, -1
            IF (TSAXBE(X, ORD, J, 1, X(1,J-1), ORD(J-1)) .EQ. 0) GO TO
     $          40
            CALL TSSWAP(X, ORD, J - 1, J)
   30     CONTINUE
   40   CONTINUE
        DO 50 I = LO + 1, HI
          CALL TSDUPL(X, ORD, REP, I - 1, I)
   50   CONTINUE
        LO = LO + LEAFGR
        GO TO 10
      END IF
      END

C     TSKDSO (kd_sort) - sorts the points into a k-d tree: cuts every
C     node in two across its widest extent, down to the leaves.
C     (Bentley; Friedman, Bentley and Finkel: see the head.)
      SUBROUTINE TSKDSO(X, ORD, REP, CTL)
      DOUBLE PRECISION X(3,*)
      INTEGER ORD(*), REP(*), CTL(*)
      INTEGER LEAVES
      PARAMETER (LEAVES = 4)
      INTEGER TSNEXT, FIRST, LAST, MID, NODE
      NODE = 1
   10 IF (NODE .LT. CTL(LEAVES)) THEN
        CALL TSNRNG(CTL, NODE, FIRST, LAST)
        CALL TSNRNG(CTL, 2*NODE + 1, MID, LAST)
        CALL TSBISE(X, ORD, REP, FIRST, LAST, MID)
        NODE = 2*NODE
      ELSE
        CALL TSNRNG(CTL, NODE, FIRST, LAST)
        CALL TSLSOR(X, ORD, REP, FIRST, LAST)
        NODE = TSNEXT(NODE)
      END IF
      IF (NODE .GT. 0) GO TO 10
      END

C     TSBOXE (make_boxes) - computes the box of every node, from the
C     leaves up.
      SUBROUTINE TSBOXE(X, BOX, CTL)
      DOUBLE PRECISION X(3,*), BOX(6,*)
      INTEGER CTL(*)
      INTEGER LEAVES
      PARAMETER (LEAVES = 4)
      INTEGER FIRST, LAST, NODE
      DO 10 NODE = 2*CTL(LEAVES) - 1, 1, -1
        CALL TSNRNG(CTL, NODE, FIRST, LAST)
        IF (NODE .LT. CTL(LEAVES)) THEN
C         the children's corners
          CALL TSBBOX(BOX(1,2*NODE), 4, 1, BOX(1,NODE))
        ELSE
          CALL TSBBOX(X(1,FIRST), LAST - FIRST + 1, 1, BOX(1,NODE))
        END IF
   10 CONTINUE
      END

C     TSLCOU (leaf_count) - returns the number of leaves for N points: a
C     power of two.
      INTEGER FUNCTION TSLCOU(N)
      INTEGER N
      INTEGER LEAFPT
      PARAMETER (LEAFPT = 48)
      INTEGER LVS
      LVS = 1
   10 IF (LVS .LT. N/LEAFPT + MIN(MOD(N, LEAFPT), 1)) THEN
        LVS = 2*LVS
        GO TO 10
      END IF
      TSLCOU = LVS
      END

C     TSDIST (distinct_points) - copies the points that represent
C     themselves, in their order.
      SUBROUTINE TSDIST(N, X, P, ORD, REP, CTL)
      DOUBLE PRECISION X(3,*), P(3,*)
      INTEGER N, ORD(*), REP(*), CTL(*)
      INTEGER NP, LEAVES
      PARAMETER (NP = 1, LEAVES = 4)
      INTEGER TSLCOU, I, J, K
      J = 0
      DO 20 I = 1, N
        IF (REP(I) .EQ. I) THEN
          J = J + 1
          DO 10 K = 1, 3
            X(K,J) = P(K,I)
   10     CONTINUE
          ORD(J) = I
        END IF
   20 CONTINUE
      CTL(NP) = J
      CTL(LEAVES) = TSLCOU(J)
      END

C     TSREVI (revive_all) - puts all points back into the tree.
      SUBROUTINE TSREVI(ALIVE, CTL)
      INTEGER ALIVE(*), CTL(*)
      INTEGER LEAVES
      PARAMETER (LEAVES = 4)
      INTEGER TSLFST, I
      DO 10 I = 1, CTL(LEAVES) - 1
        ALIVE(I) = 2
   10 CONTINUE
      DO 20 I = 1, CTL(LEAVES)
        ALIVE(CTL(LEAVES)+I-1) = TSLFST(CTL, I + 1) - TSLFST(CTL, I)
   20 CONTINUE
      END

C     ------------------------------------------------------------------
C     Scaling
C
C     Searches compute with coordinates of absolute value at most 1;
C     exact signs are those of the caller's.
C     ------------------------------------------------------------------

C     TSUNIT (common_unit) - returns the least power of two U for which
C     all scaled coordinates are multiples of 1/U, or 0 if it exceeds
C     2**29.
      DOUBLE PRECISION FUNCTION TSUNIT(X, CTL)
      DOUBLE PRECISION X(3,*)
      INTEGER CTL(*)
      INTEGER NP
      PARAMETER (NP = 1)
      DOUBLE PRECISION U
      INTEGER I, K
      TSUNIT = 0.0D0
      U = 1.0D0
      DO 30 I = 1, CTL(NP)
        DO 20 K = 1, 3
   10     IF (ABS(X(K,I)*U - DBLE(INT(X(K,I)*U))) .GT. 0.0D0) THEN
            IF (U .GT. 5.0D8) RETURN
            U = 2.0D0*U
            GO TO 10
          END IF
   20   CONTINUE
   30 CONTINUE
      TSUNIT = U
      END

C     TSINLI (limbs_hold_all) - returns 1 if HHLIM limbs hold all
C     coordinates of N points P, else 0; only those below FEW are in
C     doubt.
      INTEGER FUNCTION TSINLI(N, P)
      INTEGER N
      DOUBLE PRECISION P(3,*)
      INTEGER HHLIM, BITS, DBLDIG
      DOUBLE PRECISION NORMAL
      PARAMETER (HHLIM = 88, BITS = 24, DBLDIG = 53,
     $    NORMAL = 2.0D0**(-1022))
      DOUBLE PRECISION HHLDEX, FEW, TOP
      INTEGER HHFITS, HHFREX, DOWN, I, K
C     else all but the largest are in doubt
      DOWN = MIN((3 - HHLIM)*BITS + DBLDIG, 0)
      TOP = 0.0D0
      DO 20 I = 1, N
        DO 10 K = 1, 3
          TOP = MAX(TOP, ABS(P(K,I)))
   10   CONTINUE
   20 CONTINUE
C     if that would underflow, only subnormals are in doubt
      I = HHFREX(TOP)
      FEW = NORMAL
      IF (I + DOWN .GT. -1021) FEW = HHLDEX(TOP, DOWN)
      TSINLI = 0
      DO 40 I = 1, N
        DO 30 K = 1, 3
          IF (ABS(P(K,I)) .LT. FEW .AND. ABS(P(K,I)) .GT. 0.0D0) THEN
            IF (HHFITS(P(K,I), TOP) .EQ. 0) RETURN
          END IF
   30   CONTINUE
   40 CONTINUE
      TSINLI = 1
      END

C     TSSCAL (scale_points) - scales the sorted coordinates to an
C     absolute value of at most 1 by a power of two, in two steps
C     because one might overflow, and finds whether they are small
C     multiples of one unit.  They are not if one underflows: its
C     multiple is lost.
      SUBROUTINE TSSCAL(X, CTL, RCTL)
      DOUBLE PRECISION X(3,*), RCTL(*)
      INTEGER CTL(*)
      INTEGER NP, SCALE, EXACT3, EXACT5, RLEAST, DBLDIG
      DOUBLE PRECISION HUGE, NORMAL, LENMIN
      PARAMETER (NP = 1, SCALE = 13, EXACT3 = 1, EXACT5 = 2, RLEAST = 3,
     $    DBLDIG = 53, HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023,
     $    NORMAL = 2.0D0**(-1022), LENMIN = 2.0D0**(-450))
      DOUBLE PRECISION HHLDEX, TSUNIT, BOTTOM, TOP, U
      INTEGER HHFREX, E, I, K
      RCTL(EXACT3) = -1.0D0
      RCTL(EXACT5) = -1.0D0
      TOP = 0.0D0
      BOTTOM = HUGE
      DO 20 I = 1, CTL(NP)
        DO 10 K = 1, 3
          U = ABS(X(K,I))
          TOP = MAX(TOP, U)
          IF (U .GT. 0.0D0) BOTTOM = MIN(BOTTOM, U)
   10   CONTINUE
   20 CONTINUE
      RCTL(RLEAST) = BOTTOM
      E = HHFREX(TOP)
      CTL(SCALE) = E
      CALL HHMULT(3*CTL(NP), X, HHLDEX(1.0D0, -(E/2)))
      CALL HHMULT(3*CTL(NP), X, HHLDEX(1.0D0, -(E - E/2)))
      IF (HHLDEX(BOTTOM, -E) .LT. LENMIN) RCTL(EXACT3) = -2.0D0
      U = 0.0D0
      IF (HHLDEX(BOTTOM, -E) .GE. NORMAL) U = TSUNIT(X, CTL)
      IF (U .GT. 0.0D0) THEN
C       up to 2**52 units of the determinant's degree
        RCTL(EXACT3) = 2.0D0**(DBLDIG-1)/U/U/U
        RCTL(EXACT5) = RCTL(EXACT3)/U/U
      END IF
      END

C     ------------------------------------------------------------------
C     The first facet (Section 2): of the hull, by gift wrapping
C     ------------------------------------------------------------------

C     TSLEXB (lex_before) - returns 1 if point A comes strictly before
C     point B: by x, then by y, then by z.
      INTEGER FUNCTION TSLEXB(P, A, B)
      INTEGER A, B
      DOUBLE PRECISION P(3,*)
      INTEGER K
      TSLEXB = 0
      DO 10 K = 1, 3
        IF (P(K,A) .GT. P(K,B)) RETURN
        IF (P(K,A) .LT. P(K,B)) THEN
          TSLEXB = 1
          RETURN
        END IF
   10 CONTINUE
      END

C     TSHEBE (hull_edge_before) - returns 1 if point I comes before
C     point J when a plane parallel to the z axis is wrapped about A,
C     the lexicographically least point, and then a line in that plane.
C     The first point of all ends a hull edge that contains no other
C     point.
      INTEGER FUNCTION TSHEBE(P, ORD, A, I, J)
      DOUBLE PRECISION P(3,*)
      INTEGER ORD(*), A, I, J
      DOUBLE PRECISION O(3), Q(3), Z(3)
      INTEGER HHAREA, TSLEXB, K, SIDE
      DO 10 K = 1, 3
        O(K) = P(K,ORD(A))
        Z(K) = P(K,ORD(I))
        Q(K) = P(K,ORD(J))
   10 CONTINUE
      SIDE = HHAREA(3, O, Q, Z)
      IF (SIDE .EQ. 0) THEN
        IF (Z(1) .GT. O(1) .OR. Q(1) .GT. O(1)) THEN
          SIDE = -HHAREA(2, O, Q, Z)
        ELSE
          SIDE = HHAREA(1, O, Q, Z)
        END IF
      END IF
      TSHEBE = 0
      IF (SIDE .LT. 0) TSHEBE = 1
      IF (SIDE .EQ. 0) TSHEBE = TSLEXB(P, ORD(I), ORD(J))
      END

C     TSLINE - returns 1 if three points are on a line: HHCOLL of points
C     of P.
      INTEGER FUNCTION TSLINE(P, I, J, K)
      DOUBLE PRECISION P(3,*)
      INTEGER I, J, K
      INTEGER HHCOLL
      TSLINE = HHCOLL(P(1,I), P(1,J), P(1,K))
      END

C     TSFIRS (first_facet) - finds the first facet V: on the hull, with
C     all points on its positive side, and V(1) of least position.  On a
C     hull face of more than three points it is the triangle on the edge
C     V(1) V(2) of the face that the tie rule selects: of two points A,
C     B of the face, B is better iff it is inside the ball of V1, V2, A
C     and W, by that rule, for any W off the face.  INFO is 0, or the
C     code of points without a tetrahedron.
      SUBROUTINE TSFIRS(X, P, ORD, CTL, RCTL, V, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), CTL(*), V(3), INFO
      INTEGER NP, EXACT3, EXACT5, PLANAR, LINEAR, SINGLE
      PARAMETER (NP = 1, EXACT3 = 1, EXACT5 = 2, PLANAR = 3, LINEAR = 4,
     $    SINGLE = 5)
      INTEGER HHPINS, HHPORI, TSHEBE, TSLINE, TSLEXB, I, SIDE, W
      INFO = SINGLE
      IF (CTL(NP) .LT. 2) RETURN
      V(1) = 1
      DO 10 I = 2, CTL(NP)
        IF (TSLEXB(P, ORD(I), ORD(V(1))) .EQ. 1) V(1) = I
   10 CONTINUE
      V(2) = 1
      IF (V(1) .EQ. 1) V(2) = 2
      DO 20 I = 1, CTL(NP)
        IF (I .NE. V(1) .AND. I .NE. V(2)) THEN
          IF (TSHEBE(P, ORD, V(1), I, V(2)) .EQ. 1) V(2) = I
        END IF
   20 CONTINUE
      INFO = LINEAR
      DO 30 I = 1, CTL(NP)
        IF (TSLINE(P, ORD(V(1)), ORD(V(2)), ORD(I)) .EQ. 0) GO TO 40
   30 CONTINUE
      RETURN
   40 V(3) = I
      W = 0
      DO 50 I = 1, CTL(NP)
        SIDE = HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3), I)
        IF (SIDE .NE. 0) W = I
        IF (SIDE .LT. 0) THEN
          W = V(3)
          V(3) = I
        END IF
   50 CONTINUE
      INFO = PLANAR
      IF (W .EQ. 0) RETURN
      DO 60 I = 1, CTL(NP)
        IF (I .NE. V(3)) THEN
          IF (HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3),
     $        I) .EQ. 0) THEN
            IF (TSLINE(P, ORD(V(1)), ORD(V(2)), ORD(I)) .EQ. 0) THEN
              IF (HHPINS(X, P, ORD, RCTL(EXACT3), RCTL(EXACT5), V, W, I,
     $            1) .LT. 0) V(3) = I
            END IF
          END IF
        END IF
   60 CONTINUE
   70 IF (V(1) .GT. MIN(V(2), V(3))) THEN
        W = V(1)
        V(1) = V(2)
        V(2) = V(3)
        V(3) = W
        GO TO 70
      END IF
      INFO = 0
      END

C     ------------------------------------------------------------------
C     The pool of open facets: a hash table with open addressing
C
C     Entry E = 1, 2, ... has ENTLEN integers, from POOL(ENTLEN*(E-1)+1)
C     on:
C       PCODE   the facet's code 4(T-1)+K, or 0: the entry is unused
C       PNEXT   the next entry of the same owner, newest first, or 0
C       PPREV   the previous one; minus the owner in the first
C       PSIG    the hash of the three vertices
C     HEAD(owner) is the first entry of an owner.  A facet without an
C     owner is in no entry: it is left open.  Probing is linear, from
C     the hash modulo SLOTS; when an entry is removed, later ones are
C     moved back.
C
C     LIFE OF AN OPEN FACET.  It is born in TSADDT.
C       - If it contains S, TSMOPU makes it an edge of the link, or
C         closes it with the opposite edge.
C       - If it is opposite to S (K = 1), it is nowhere until TSFLUS
C         enters it into the pool's table under its owner, or closes it
C         with the entry that is there.  When its owner's star begins,
C         TSEPOO makes it an edge.
C       - Else an edge ends with the search for its apex: TSADDT closes
C         it, or ADJ is 0, a facet of the hull.
C       - Without an owner it stays OPEN in the result.  So do all that
C         are left when arrays or pool are full.
C     So it is in one place at a time.  TSERAS and TSREHA move entries,
C     and update HEAD and the owners' lists only; TSMOVE moves edges,
C     and updates LINK and the edges only: after TSMKRO, callers must
C     reload OLDEST.
C
C       the table is  by      with so many slots, at most its quota
C       set up        TSBLD   what TSWANT says, for uniform points
C       doubled       TSMKRO  2 slots + 1, when 3/4 are in use
C       cut           TSMKRO  its quota, when it meets the edges
C       cut           TSEPOO  its quota without facets that become edges
C       set up again  TSREST  as by TSBLD, or twice its facets
C
C     TSROOM alone decides what room there is: at most 7/8 of the slots
C     are used, one at least is not, and the edges do not meet the
C     table.  TSPUSH does not resize the table; TSMKRO ensures room for
C     two edges.  If room still falls short, the code is FULL.
C     ------------------------------------------------------------------

C     TSTETF (tet_facet) - sets F to the vertices of facet K of
C     tetrahedron T, the one opposite to TET(K,T): counter-clockwise
C     from outside if T is positively oriented.
      SUBROUTINE TSTETF(TET, T, K, F)
      INTEGER TET(4,*), T, K, F(3)
      INTEGER OUT(3,4)
      DATA OUT /2, 3, 4, 1, 4, 3, 1, 2, 4, 1, 3, 2/
      F(1) = TET(OUT(1,K),T)
      F(2) = TET(OUT(2,K),T)
      F(3) = TET(OUT(3,K),T)
      END

C     TSFCOD (facet_of_code) - sets V to the vertices of the facet of a
C     code, positive towards its outside.
      SUBROUTINE TSFCOD(TET, CODE, V)
      INTEGER TET(4,*), CODE, V(3)
      INTEGER T
      T = (CODE - 1)/4 + 1
      CALL TSTETF(TET, T, CODE - 4*(T - 1), V)
      END

C     TSOWNE (owner) - returns the owner of the facet V: of its wanted
C     vertices the one of least position, or 0.
      INTEGER FUNCTION TSOWNE(HEAD, V)
      INTEGER HEAD(*), V(3)
      INTEGER UNWANT
      PARAMETER (UNWANT = -1)
      INTEGER K, LEAST
      LEAST = 0
      DO 10 K = 1, 3
        IF (HEAD(V(K)) .NE. UNWANT .AND. (LEAST .EQ. 0 .OR.
     $      V(K) .LT. LEAST)) LEAST = V(K)
   10 CONTINUE
      TSOWNE = LEAST
      END

C     TSHASH (facet_hash) - returns the hash of a facet, below 2**31;
C     the order of its vertices does not matter.
      INTEGER FUNCTION TSHASH(V)
      INTEGER V(3)
      INTEGER A, B, C
      A = MOD(V(1) - 1, 8192)
      B = MOD(V(2) - 1, 8192)
      C = MOD(V(3) - 1, 8192)
      TSHASH = (A + B + C)*57571 + (A*B + B*C + C*A)
      END

C     TSSAME (same_facet) - returns 1 if V and W, of equal hash, are the
C     same facet.
      INTEGER FUNCTION TSSAME(V, W)
      INTEGER V(3), W(3)
      INTEGER K, N
      N = 0
      DO 10 K = 1, 3
        IF (V(K) .EQ. W(1) .OR. V(K) .EQ. W(2) .OR.
     $      V(K) .EQ. W(3)) N = N + 1
   10 CONTINUE
      TSSAME = N/3
      END

C     TSFIND (find_entry) - E is the entry of the facet V, of hash SIG,
C     or the unused entry where it belongs.
      SUBROUTINE TSFIND(TET, POOL, CTL, V, SIG, E)
      INTEGER TET(4,*), POOL(*), CTL(*), V(3), SIG, E
      INTEGER SLOTS, ENTLEN, PCODE, PSIG
      PARAMETER (SLOTS = 6, ENTLEN = 4, PCODE = 1, PSIG = 4)
      INTEGER TSSAME, AT, CODE, W(3)
      E = MOD(SIG, CTL(SLOTS)) + 1
   10 AT = ENTLEN*(E - 1)
      CODE = POOL(AT+PCODE)
      IF (CODE .EQ. 0) RETURN
      IF (POOL(AT+PSIG) .EQ. SIG) THEN
        CALL TSFCOD(TET, CODE, W)
        IF (TSSAME(V, W) .EQ. 1) RETURN
      END IF
      E = E + 1
      IF (E .GT. CTL(SLOTS)) E = 1
      GO TO 10
      END

C     TSRELK (relink_entry) - makes NEXT follow what precedes the entry
C     behind POOL(AT) in the list of its owner, and PREV precede what
C     follows it.
      SUBROUTINE TSRELK(HEAD, POOL, AT, NEXT, PREV)
      INTEGER HEAD(*), POOL(*), AT, NEXT, PREV
      INTEGER ENTLEN, PNEXT, PPREV
      PARAMETER (ENTLEN = 4, PNEXT = 2, PPREV = 3)
      INTEGER AFTER, BEFORE
      AFTER = POOL(AT+PNEXT)
      BEFORE = POOL(AT+PPREV)
      IF (AFTER .NE. 0) POOL(ENTLEN*(AFTER-1)+PPREV) = PREV
      IF (BEFORE .GT. 0) THEN
        POOL(ENTLEN*(BEFORE-1)+PNEXT) = NEXT
      ELSE
        HEAD(-BEFORE) = NEXT
      END IF
      END

C     TSERAS (erase_entry) - removes entry ENT, and moves back the
C     entries behind it that may fill the hole.
      SUBROUTINE TSERAS(HEAD, POOL, CTL, ENT)
      INTEGER HEAD(*), POOL(*), CTL(*), ENT
      INTEGER SLOTS, NFACET, ENTLEN, PCODE, PNEXT, PPREV, PSIG
      PARAMETER (SLOTS = 6, NFACET = 7, ENTLEN = 4, PCODE = 1,
     $    PNEXT = 2, PPREV = 3, PSIG = 4)
      INTEGER AFTER, AT, BEFORE, E, FILL, HOLE, HOME, K, TO
      AT = ENTLEN*(ENT - 1)
      AFTER = POOL(AT+PNEXT)
      BEFORE = POOL(AT+PPREV)
      CALL TSRELK(HEAD, POOL, AT, AFTER, BEFORE)
      CTL(NFACET) = CTL(NFACET) - 1
      HOLE = ENT
      E = ENT
   10 E = E + 1
      IF (E .GT. CTL(SLOTS)) E = 1
      AT = ENTLEN*(E - 1)
      IF (POOL(AT+PCODE) .NE. 0) THEN
        HOME = MOD(POOL(AT+PSIG), CTL(SLOTS)) + 1
C       E may fill the hole if its home is not behind the hole
        FILL = 0
        IF (HOME .LE. HOLE) FILL = 1
        IF (HOME .GT. E) FILL = FILL + 1
        IF (HOLE .GT. E) FILL = FILL - 1
        IF (FILL .GT. 0) THEN
          TO = ENTLEN*(HOLE - 1)
          DO 20 K = 1, ENTLEN
            POOL(TO+K) = POOL(AT+K)
   20     CONTINUE
          CALL TSRELK(HEAD, POOL, TO, HOLE, HOLE)
          HOLE = E
        END IF
        GO TO 10
      END IF
      POOL(ENTLEN*(HOLE-1)+PCODE) = 0
      END

C     TSMOEN (match_or_enter) - enters the open facet of a code into the
C     table and sets OTHER to 0; or, if its other side is there, removes
C     that and sets OTHER to its code.
      SUBROUTINE TSMOEN(TET, HEAD, POOL, CTL, CODE, OTHER)
      INTEGER TET(4,*), HEAD(*), POOL(*), CTL(*), CODE, OTHER
      INTEGER NFACET, LOWEST, ENTLEN, PCODE, PNEXT, PPREV, PSIG
      PARAMETER (NFACET = 7, LOWEST = 11, ENTLEN = 4, PCODE = 1,
     $    PNEXT = 2, PPREV = 3, PSIG = 4)
      INTEGER TSHASH, TSOWNE, AT, E, LEAST, SIG, V(3)
      OTHER = 0
      CALL TSFCOD(TET, CODE, V)
      LEAST = TSOWNE(HEAD, V)
      IF (LEAST .EQ. 0) RETURN
      SIG = TSHASH(V)
      CALL TSFIND(TET, POOL, CTL, V, SIG, E)
      AT = ENTLEN*(E - 1)
      OTHER = POOL(AT+PCODE)
      IF (OTHER .NE. 0) THEN
        CALL TSERAS(HEAD, POOL, CTL, E)
        RETURN
      END IF
      POOL(AT+PCODE) = CODE
      POOL(AT+PNEXT) = HEAD(LEAST)
      POOL(AT+PPREV) = -LEAST
      POOL(AT+PSIG) = SIG
      CALL TSRELK(HEAD, POOL, AT, E, E)
      CTL(NFACET) = CTL(NFACET) + 1
      CTL(LOWEST) = MIN(LEAST, CTL(LOWEST))
      END

C     TSROOM (room_for) - returns 1 if the pool has room for so many
C     more facets, the table keeping an eighth of its slots unused and
C     one at least, and for so many more edges.  At all times it has
C     room for the facets that TSFLUS will enter: so TSFIND and TSERAS,
C     which end at an unused entry, meet one.
      INTEGER FUNCTION TSROOM(CTL, FACETS, EDGES)
      INTEGER CTL(*), FACETS, EDGES
      INTEGER SLOTS, NFACET, NEWEST, ENTLEN, EDGLEN
      PARAMETER (SLOTS = 6, NFACET = 7, NEWEST = 10, ENTLEN = 4,
     $    EDGLEN = 6)
      TSROOM = 0
      IF (CTL(NFACET) + FACETS .LT. CTL(SLOTS) - CTL(SLOTS)/8 .AND.
     $    ENTLEN*CTL(SLOTS) + EDGLEN*EDGES .LE. CTL(NEWEST) - 1)
     $    TSROOM = 1
      END

C     TSCUBE (cube_root) - returns the least C with C**3 >= N.
      INTEGER FUNCTION TSCUBE(N)
      INTEGER N
      INTEGER C
      C = 1
   10 IF (DBLE(C)*DBLE(C)*DBLE(C) .LT. DBLE(N)) THEN
        C = C + 1
        GO TO 10
      END IF
      TSCUBE = C
      END

C     TSQUOT (table_quota) - returns how many slots the table may have
C     with room for so many more edges: what its facets need with an
C     eighth unused, and half of the remaining free space.
      INTEGER FUNCTION TSQUOT(CTL, EDGES)
      INTEGER CTL(*), EDGES
      INTEGER NFACET, NEWEST, ENTLEN, EDGLEN
      PARAMETER (NFACET = 7, NEWEST = 10, ENTLEN = 4, EDGLEN = 6)
      INTEGER MOST, NEED
      MOST = (CTL(NEWEST) - 1 - EDGLEN*EDGES)/ENTLEN
      NEED = CTL(NFACET) + CTL(NFACET)/7 + 4
      TSQUOT = MOST
      IF (MOST .GE. NEED) TSQUOT = NEED + (MOST - NEED)/2
      END

C     TSREHA (rebuild_table) - gives the table the wanted number of
C     slots, or its quota if that is less, and enters its facets again
C     in their order.  OK is 1, or 0 if there is no room.  The new table
C     is laid over the old one, so the facets come from TET and ADJ: the
C     open ones without the vertex S.  (Those with it are edges of the
C     link.)
      SUBROUTINE TSREHA(TET, ADJ, HEAD, POOL, CTL, S, WANTED, OK)
      INTEGER TET(4,*), ADJ(*), HEAD(*), POOL(*), CTL(*), S, WANTED, OK
      INTEGER NP, SLOTS, NFACET, UNFILE, ENTLEN, PCODE, UNWANT, OPEN
      PARAMETER (NP = 1, SLOTS = 6, NFACET = 7, UNFILE = 8, ENTLEN = 4,
     $    PCODE = 1, UNWANT = -1, OPEN = -1)
      INTEGER TSQUOT, TSROOM, CODE, I, OTHER, V(3)
      CTL(SLOTS) = MIN(WANTED, TSQUOT(CTL, 2))
      CTL(NFACET) = 0
      DO 10 I = 1, CTL(SLOTS)
        POOL(ENTLEN*(I-1)+PCODE) = 0
   10 CONTINUE
      DO 20 I = 1, CTL(NP)
        IF (HEAD(I) .NE. UNWANT) HEAD(I) = 0
   20 CONTINUE
      DO 30 I = 1, 4*(CTL(UNFILE) - 1)
        IF (ADJ(I) .NE. OPEN) GO TO 30
        IF (TSROOM(CTL, 0, 0) .EQ. 0) GO TO 30
        CODE = I
        CALL TSFCOD(TET, CODE, V)
        IF (V(1) .EQ. S .OR. V(2) .EQ. S .OR. V(3) .EQ. S) GO TO 30
        CALL TSMOEN(TET, HEAD, POOL, CTL, CODE, OTHER)
   30 CONTINUE
      OK = TSROOM(CTL, 0, 0)
      END

C     TSADJA (set_adjacent) - makes the tetrahedra of two codes
C     neighbours across these facets.
      SUBROUTINE TSADJA(ADJ, CODE, OTHER)
      INTEGER ADJ(*), CODE, OTHER
      ADJ(CODE) = (OTHER - 1)/4 + 1
      ADJ(OTHER) = (CODE - 1)/4 + 1
      END

C     TSFLUS (flush_facets) - enters the facets opposite to S of the
C     tetrahedra from UNFILE on into the table, or closes those whose
C     other side is there.  They come in batches so that the processor
C     can overlap their memory accesses.
      SUBROUTINE TSFLUS(TET, ADJ, HEAD, POOL, CTL)
      INTEGER TET(4,*), ADJ(*), HEAD(*), POOL(*), CTL(*)
      INTEGER NTET, UNFILE
      PARAMETER (NTET = 2, UNFILE = 8)
      INTEGER CODE, OTHER, T
      DO 10 T = CTL(UNFILE), CTL(NTET)
        CODE = 4*(T - 1) + 1
        CALL TSMOEN(TET, HEAD, POOL, CTL, CODE, OTHER)
        IF (OTHER .NE. 0) CALL TSADJA(ADJ, CODE, OTHER)
   10 CONTINUE
      CTL(UNFILE) = CTL(NTET) + 1
      END

C     ------------------------------------------------------------------
C     The link of a star
C
C     The open facets at S are the edges A -> B of its link: (S, A, B)
C     is positive towards the unknown side.  They are a queue, which
C     keeps the link's boundary short, and grow down from the end of the
C     pool: edge E is POOL(E) and the EDGLEN - 1 integers behind it.
C     ------------------------------------------------------------------

C     TSCLRL (clear_link) - empties the link.
      SUBROUTINE TSCLRL(CTL)
      INTEGER CTL(*)
      INTEGER POOLLN, OLDEST, NEWEST, EDGLEN
      PARAMETER (POOLLN = 5, OLDEST = 9, NEWEST = 10, EDGLEN = 6)
      CTL(NEWEST) = CTL(POOLLN) + 1
      CTL(OLDEST) = CTL(POOLLN) + 1 - EDGLEN
      END

C     TSMOVE (move_edges) - moves the edges up to the end of the pool.
C     Pointers of edges in the link lead to others in it, as TSCONN sets
C     them in pairs and whoever removes an edge connects its neighbours
C     anew.  Those of dead edges are never followed again and stay as
C     they are:  shifted with the edge they could exceed the largest
C     INTEGER.
      SUBROUTINE TSMOVE(LINK, POOL, CTL)
      INTEGER LINK(*), POOL(*), CTL(*)
      INTEGER POOLLN, OLDEST, NEWEST, EDGLEN, ECODE, EDEAD, EFROM, EPREV
      PARAMETER (POOLLN = 5, OLDEST = 9, NEWEST = 10, EDGLEN = 6,
     $    ECODE = 0, EDEAD = -2, EFROM = 1, EPREV = 3)
      INTEGER DEAD, E, K, SHIFT, TO
      SHIFT = CTL(POOLLN) + 1 - EDGLEN - CTL(OLDEST)
      DO 30 E = CTL(OLDEST), CTL(NEWEST), -EDGLEN
        TO = E + SHIFT
        DEAD = 0
        IF (POOL(E+ECODE) .EQ. EDEAD) DEAD = 1
        IF (DEAD .EQ. 0) THEN
          IF (LINK(POOL(E+EFROM)) .EQ. E) LINK(POOL(E+EFROM)) = TO
        END IF
        DO 10 K = 0, EDGLEN - 1
          POOL(TO+K) = POOL(E+K)
   10   CONTINUE
        DO 20 K = EPREV, EDGLEN - 1
          IF (POOL(TO+K) .NE. 0 .AND. DEAD .EQ. 0)
     $        POOL(TO+K) = POOL(TO+K) + SHIFT
   20   CONTINUE
   30 CONTINUE
      CTL(NEWEST) = CTL(NEWEST) + SHIFT
      CTL(OLDEST) = CTL(OLDEST) + SHIFT
      END

C     TSPUSH (push_edge) - adds an edge A -> B, for which there is room,
C     and connects it to no other.  E is the edge.
      SUBROUTINE TSPUSH(LINK, POOL, CTL, CODE, A, B, E)
      INTEGER LINK(*), POOL(*), CTL(*), CODE, A, B, E
      INTEGER NEWEST, EDGLEN, ECODE, EFROM, ETO, EPREV, ENEXT, ECHAIN
      PARAMETER (NEWEST = 10, EDGLEN = 6, ECODE = 0, EFROM = 1, ETO = 2,
     $    EPREV = 3, ENEXT = 4, ECHAIN = 5)
      E = CTL(NEWEST) - EDGLEN
      POOL(E+ECODE) = CODE
      POOL(E+EFROM) = A
      POOL(E+ETO) = B
      POOL(E+EPREV) = 0
      POOL(E+ENEXT) = 0
      POOL(E+ECHAIN) = MAX(LINK(A), 0)
      LINK(A) = E
      CTL(NEWEST) = E
      END

C     TSCONN (connect_edges) - makes edge B the next of edge A; either
C     may be 0.
      SUBROUTINE TSCONN(POOL, A, B)
      INTEGER POOL(*), A, B
      INTEGER EPREV, ENEXT
      PARAMETER (EPREV = 3, ENEXT = 4)
      IF (A .NE. 0) POOL(A+ENEXT) = B
      IF (B .NE. 0) POOL(B+EPREV) = A
      END

C     TSRMED (remove_edge) - removes edge E from the link.
      SUBROUTINE TSRMED(LINK, POOL, E)
      INTEGER LINK(*), POOL(*), E
      INTEGER ECODE, EDEAD, EFROM, ECHAIN
      PARAMETER (ECODE = 0, EDEAD = -2, EFROM = 1, ECHAIN = 5)
      INTEGER I
      I = LINK(POOL(E+EFROM))
      IF (I .EQ. E) THEN
        LINK(POOL(E+EFROM)) = POOL(E+ECHAIN)
      ELSE
   10   IF (POOL(I+ECHAIN) .NE. E) THEN
          I = POOL(I+ECHAIN)
          GO TO 10
        END IF
        POOL(I+ECHAIN) = POOL(E+ECHAIN)
      END IF
      POOL(E+ECODE) = EDEAD
      END

C     TSBETW (edge_between) - returns the edge A -> B of the link, or 0.
      INTEGER FUNCTION TSBETW(LINK, POOL, A, B)
      INTEGER LINK(*), POOL(*), A, B
      INTEGER ETO, ECHAIN
      PARAMETER (ETO = 2, ECHAIN = 5)
      INTEGER E
      E = MAX(LINK(A), 0)
   10 IF (E .NE. 0) THEN
        IF (POOL(E+ETO) .NE. B) THEN
          E = POOL(E+ECHAIN)
          GO TO 10
        END IF
      END IF
      TSBETW = E
      END

C     TSMOPU (match_or_push) - pushes the edge A -> B of the facet of a
C     code into the link, between the edges PREV and AFTER, either of
C     which may be 0; or, if the edge of the other side is there, closes
C     both and removes that.  LAST is the edge that now ends at B, or 0.
      SUBROUTINE TSMOPU(ADJ, LINK, POOL, CTL, CODE, A, B, PREV, AFTER,
     $                  LAST)
      INTEGER ADJ(*), LINK(*), POOL(*), CTL(*), CODE, A, B, PREV, AFTER,
     $    LAST
      INTEGER ECODE, EPREV, ENEXT, OPEN
      PARAMETER (ECODE = 0, EPREV = 3, ENEXT = 4, OPEN = -1)
      INTEGER TSBETW, F, G
      F = TSBETW(LINK, POOL, B, A)
      IF (F .EQ. 0) THEN
        ADJ(CODE) = OPEN
        CALL TSPUSH(LINK, POOL, CTL, CODE, A, B, LAST)
        CALL TSCONN(POOL, PREV, LAST)
        CALL TSCONN(POOL, LAST, AFTER)
        RETURN
      END IF
      CALL TSADJA(ADJ, CODE, POOL(F+ECODE))
      LAST = POOL(F+EPREV)
      G = POOL(F+ENEXT)
      IF (F .NE. PREV) CALL TSCONN(POOL, PREV, G)
      IF (F .NE. AFTER) CALL TSCONN(POOL, LAST, AFTER)
      CALL TSRMED(LINK, POOL, F)
      END

C     TSADDT (add_tetrahedron) - stores the tetrahedron of S, the edge E
C     = A -> B and the apex C.  The edges A -> C and C -> B replace E in
C     the link.
      SUBROUTINE TSADDT(TET, ADJ, LINK, POOL, CTL, S, E, C)
      INTEGER TET(4,*), ADJ(*), LINK(*), POOL(*), CTL(*), S, E, C
      INTEGER NTET, ECODE, ESEED, EFROM, ETO, EPREV, ENEXT, NEW, OPEN
      PARAMETER (NTET = 2, ECODE = 0, ESEED = -1, EFROM = 1, ETO = 2,
     $    EPREV = 3, ENEXT = 4, NEW = -2, OPEN = -1)
      INTEGER TSBETW, A, AFTER, B, CODE, F, G, PREV, T
      CODE = POOL(E+ECODE)
      A = POOL(E+EFROM)
      B = POOL(E+ETO)
      PREV = POOL(E+EPREV)
      AFTER = POOL(E+ENEXT)
      T = CTL(NTET) + 1
      CTL(NTET) = T
      TET(1,T) = S
      TET(2,T) = A
      TET(3,T) = B
      TET(4,T) = C
      IF (CODE .EQ. ESEED) THEN
        F = TSBETW(LINK, POOL, B, A)
        ADJ(4*T) = 0
        IF (F .NE. 0) THEN
          ADJ(4*T) = OPEN
          POOL(F+ECODE) = 4*T
        END IF
      ELSE
        CALL TSADJA(ADJ, CODE, 4*T)
      END IF
      IF (LINK(C) .EQ. NEW) LINK(C) = 0
      CALL TSRMED(LINK, POOL, E)
C     until TSFLUS
      ADJ(4*T-3) = OPEN
      CALL TSMOPU(ADJ, LINK, POOL, CTL, 4*T - 1, A, C, PREV, 0, F)
      CALL TSMOPU(ADJ, LINK, POOL, CTL, 4*T - 2, C, B, F, AFTER, G)
      END

C     TSFTOE (facet_to_edge) - makes the open facet of a code an edge of
C     the link, if it has the vertex S.  OK is 1, or 0 if there is no
C     room.
      SUBROUTINE TSFTOE(TET, LINK, POOL, CTL, S, CODE, OK)
      INTEGER TET(4,*), LINK(*), POOL(*), CTL(*), S, CODE, OK
      INTEGER TSROOM, E, K, V(3)
      CALL TSFCOD(TET, CODE, V)
      OK = 1
      DO 10 K = 1, 3
        IF (V(K) .EQ. S) GO TO 20
   10 CONTINUE
      RETURN
   20 OK = TSROOM(CTL, 0, 1)
      IF (OK .EQ. 1) CALL TSPUSH(LINK, POOL, CTL, CODE, V(MOD(K,3)+1),
     $    V(MOD(K+1,3)+1), E)
      END

C     TSPAIR (pair_edges) - gives every edge of the link a next one: an
C     edge that begins where it ends and is no other edge's next, if
C     there is one.
      SUBROUTINE TSPAIR(LINK, POOL, CTL)
      INTEGER LINK(*), POOL(*), CTL(*)
      INTEGER OLDEST, NEWEST, EDGLEN, ECODE, EDEAD, ETO, EPREV, ECHAIN
      PARAMETER (OLDEST = 9, NEWEST = 10, EDGLEN = 6, ECODE = 0,
     $    EDEAD = -2, ETO = 2, EPREV = 3, ECHAIN = 5)
      INTEGER AT, E, F
      DO 20 E = CTL(OLDEST), CTL(NEWEST), -EDGLEN
        F = LINK(POOL(E+ETO))
        IF (F .LT. 0 .OR. POOL(E+ECODE) .EQ. EDEAD) GO TO 20
   10   IF (F .NE. 0) THEN
          IF (POOL(F+EPREV) .NE. 0) THEN
            F = POOL(F+ECHAIN)
            GO TO 10
          END IF
        END IF
        AT = E
        CALL TSCONN(POOL, AT, F)
   20 CONTINUE
      END

C     TSEADJ (edges_from_adj) - makes all open facets at S edges of the
C     link, in the order of their tetrahedra.  OK is 1, or 0 if there is
C     no room.
      SUBROUTINE TSEADJ(TET, ADJ, LINK, POOL, CTL, S, OK)
      INTEGER TET(4,*), ADJ(*), LINK(*), POOL(*), CTL(*), S, OK
      INTEGER NTET, OPEN
      PARAMETER (NTET = 2, OPEN = -1)
      INTEGER CODE, K, T
      DO 20 T = 1, CTL(NTET)
        DO 10 K = 4, 1, -1
          CODE = 4*(T - 1) + K
          OK = 1
          IF (ADJ(CODE) .EQ. OPEN) CALL TSFTOE(TET, LINK, POOL, CTL, S,
     $        CODE, OK)
          IF (OK .EQ. 0) RETURN
   10   CONTINUE
   20 CONTINUE
      CALL TSPAIR(LINK, POOL, CTL)
      END

C     TSEPOO (edges_from_pool) - moves the facets that S owns, one at
C     least, from the table to the link, oldest first.  OK is 1, or 0 if
C     there is no room.  If they do not fit beside the table, it
C     rebuilds the table without them first.
      SUBROUTINE TSEPOO(TET, ADJ, HEAD, LINK, POOL, CTL, S, OK)
      INTEGER TET(4,*), ADJ(*), HEAD(*), LINK(*), POOL(*), CTL(*), S, OK
      INTEGER NFACET, ENTLEN, PCODE, PNEXT, PPREV
      PARAMETER (NFACET = 7, ENTLEN = 4, PCODE = 1, PNEXT = 2,
     $    PPREV = 3)
      INTEGER TSQUOT, TSROOM, CODE, E, EDGES
      OK = 1
      E = HEAD(S)
      EDGES = 1
   10 IF (POOL(ENTLEN*(E-1)+PNEXT) .NE. 0) THEN
        E = POOL(ENTLEN*(E-1)+PNEXT)
        EDGES = EDGES + 1
        GO TO 10
      END IF
      IF (TSROOM(CTL, 0, EDGES) .EQ. 0) THEN
        CTL(NFACET) = CTL(NFACET) - EDGES
        CALL TSREHA(TET, ADJ, HEAD, POOL, CTL, S, TSQUOT(CTL, EDGES),
     $              OK)
        IF (OK .EQ. 1) CALL TSEADJ(TET, ADJ, LINK, POOL, CTL, S, OK)
        RETURN
      END IF
   20 IF (E .GT. 0) THEN
        CODE = POOL(ENTLEN*(E-1)+PCODE)
        CALL TSFTOE(TET, LINK, POOL, CTL, S, CODE, OK)
        E = POOL(ENTLEN*(E-1)+PPREV)
        GO TO 20
      END IF
   30 E = HEAD(S)
      IF (E .NE. 0) THEN
        CALL TSERAS(HEAD, POOL, CTL, E)
        GO TO 30
      END IF
      CALL TSPAIR(LINK, POOL, CTL)
      END

C     TSMKRO (make_room) - makes room for another tetrahedron's facets
C     in the table and in the link of S.  OK is 1, or 0 if there is
C     none.  Callers must reload OLDEST.
C
C               1  ENTLEN*SLOTS     NEWEST        OLDEST       POOLLN
C       before  | table       | free | edges       | dead edges |
C       TSMOVE  | table       | free            | edges         |
C       TSREHA  | longer or shorter table | free | edges        |
C
C     That is done when the table is three quarters full or meets the
C     edges: these move up if an eighth of their room is dead, and the
C     table is resized if that is not enough and changes it by a
C     sixteenth, so both are rare.
      SUBROUTINE TSMKRO(TET, ADJ, HEAD, LINK, POOL, CTL, S, OK)
      INTEGER TET(4,*), ADJ(*), HEAD(*), LINK(*), POOL(*), CTL(*), S, OK
      INTEGER NTET, POOLLN, SLOTS, UNFILE, OLDEST, NEWEST
      PARAMETER (NTET = 2, POOLLN = 5, SLOTS = 6, UNFILE = 8,
     $    OLDEST = 9, NEWEST = 10)
      INTEGER TSQUOT, TSROOM, CHANGE, MOST, SPARE
      SPARE = CTL(SLOTS)/8 + 1
      CHANGE = CTL(SLOTS)/16
      OK = TSROOM(CTL, CTL(NTET) - CTL(UNFILE) + 1 + SPARE, 2)
      IF (OK .EQ. 1) RETURN
      CALL TSFLUS(TET, ADJ, HEAD, POOL, CTL)
      IF (CTL(POOLLN) + 1 - CTL(OLDEST) .GT. (CTL(POOLLN) + 1 -
     $    CTL(NEWEST))/8) CALL TSMOVE(LINK, POOL, CTL)
      MOST = MIN(TSQUOT(CTL, 2), 2*CTL(SLOTS) + 1)
      IF (TSROOM(CTL, SPARE, 2) .EQ. 0 .AND. (MOST .GT. CTL(SLOTS) +
     $    CHANGE .OR. MOST .LT. CTL(SLOTS) - CHANGE))
     $    CALL TSREHA(TET, ADJ, HEAD, POOL, CTL, S, MOST, OK)
      OK = TSROOM(CTL, 1, 2)
      END

C     ------------------------------------------------------------------
C     The search for the apex of a facet
C
C     TSBEGS sets the facet up and compares the guesses; TSTREE offers
C     what is left and may be in the ball.  A point, a box, a node: each
C     is tested against the filter, whose bound has room for all
C     rounding, and what passes is compared with the best point, by the
C     bounds of HHLIMI first (TSCMPP), then exactly (TSCMPE).  A better
C     point narrows the ball (TSUPBD).
C
C     Constants:
C       ANGLEE = 8000.0D0*2.0D0**(-52) SMALL_ANGLE_E  a facet whose E is
C               at least this has its base opposite its longest edge.  E
C               is EPS (170 (1 + |cot|) + 90): the angle at V(1) is
C               below 1.3 degrees
C       LIMBE  = 1.0D-6 LIMB_NORMAL_E  a facet with a greater E has its
C               normal computed by limbs: trades limbs against undecided
C               sides
C       STKDEP = 96  STACK_DEPTH  length of a stack of nodes.
C               Correctness rests on it: it is not below three halves of
C               the tree's depth, as a node's number fits in an integer
C               of 64 bits, and with cylinders a search keeps three
C               nodes for every second level
C       LMAX   = 1.0D100 L_MAX  TSUPBD gives no ball for an L-coordinate
C               beyond it, and nothing may overflow there
C       UNDERR = 1.0D-200 UNDERFLOW_ERR  the effect of underflow on a
C               point's power, |W|**2 - 2 C.W, or on its side.  A
C               coordinate that underflowed when it was scaled is wrong
C               by NORMAL, and so may be each product; |W| < 4, and |C|
C               is at most 2 LMAX, as a circumradius is below 0.02/EPS
C               by HHSETU, and HHTHIN's and HHCENT's are below LMAX.
C               The surface filter is divided by q (see TSSFFI); where
C               UNDERR/q itself underflows, the term 8 EPS SIZE (SIZE +
C               2 c1) is larger
C     ------------------------------------------------------------------

C     TSDOT (dot) - returns the product of two vectors.
      DOUBLE PRECISION FUNCTION TSDOT(A, B)
      DOUBLE PRECISION A(*), B(*)
      TSDOT = A(1)*B(1) + A(2)*B(2) + A(3)*B(3)
      END

C     TSFBND (filter_bound) - returns the right-hand side of the filter
C     S for |W|_1 <= LENGTH.  C errs by at most dc.  Each term W(K)
C     (W(K) - 2 C(K)) suffers at most 7 roundings, counting that of W(K)
C     twice and those of a sum of four, each of at most EPS |W(K)|
C     (|W(K)| + 2 |C(K)|).  LENGTH and this bound may come out too small
C     by a few EPS.
      DOUBLE PRECISION FUNCTION TSFBND(S, LENGTH)
      INTEGER LFILT
      PARAMETER (LFILT = 8)
      DOUBLE PRECISION S(LFILT), LENGTH
      INTEGER VDC, VC1, VALLOW
      DOUBLE PRECISION EPS
      PARAMETER (VDC = 4, VC1 = 5, VALLOW = 8, EPS = 2.0D0**(-52))
      TSFBND = LENGTH*(2.0D0*S(VDC) + 8.0D0*EPS*(LENGTH +
     $    2.0D0*S(VC1))) + S(VALLOW)
      END

C     TSHALF (set_half_space) - makes the open side a filter: the ball
C     of L = LMAX / 2 along the normal.  Its dc has room for |W|**2, and
C     is so large that all points pass where the normal is not known; it
C     is at most 6.1 long, even where the squares that it is made of are
C     flushed to 0 (half_space.g of the bounds).
      SUBROUTINE TSHALF(FQ)
      INTEGER LFQ
      PARAMETER (LFQ = 183)
      DOUBLE PRECISION FQ(LFQ)
      INTEGER VC, VDC, VC1, FNORM, FE, QHH, QFILT
      DOUBLE PRECISION EPS, HHEMAX, LMAX
      PARAMETER (VC = 0, VDC = 4, VC1 = 5, FNORM = 0, FE = 10, QHH = 0,
     $    QFILT = 14, EPS = 2.0D0**(-52), HHEMAX = 0.5D0,
     $    LMAX = 1.0D100)
      INTEGER K
      FQ(QFILT+VC1) = 0.0D0
      DO 10 K = 1, 3
        FQ(QFILT+VC+K) = 0.5D0*LMAX*FQ(QHH+FNORM+K)
        FQ(QFILT+VC1) = FQ(QFILT+VC1) + ABS(FQ(QFILT+VC+K))
   10 CONTINUE
C     (nothing may overflow, even if a compiler computes it in vain)
      FQ(QFILT+VDC) = 8.0D0
      IF (FQ(QHH+FE) .LE. HHEMAX) FQ(QFILT+VDC) = FQ(QHH+FE)
      FQ(QFILT+VDC) = LMAX*(0.5D0*FQ(QFILT+VDC) + 4.0D0*EPS)
      END

C     TSXBOX (excludes_box) - returns 1 if a node's box provably holds
C     no better point:  no point in it passes the filter behind FQ(AT),
C     to whose left-hand side heights add at least RAISE, or, unless the
C     search collects, all are on the negative side.  It compares the
C     least power and the greatest side in the box with the bounds on
C     their errors:  TSFBND, and E |W|, which covers the rounding of the
C     side, too.  Both are taken at a point whose coordinates are the
C     box's own doubles, or C's, so the bounds for points hold.  AT is
C     QFILT, QTILT or QCAP.
      INTEGER FUNCTION TSXBOX(BOX, IQ, FQ, AT, NODE, RAISE)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION BOX(6,*), FQ(LFQ), RAISE
      INTEGER IQ(LIQ), AT, NODE
      INTEGER VC, FNORM, FBASE, FE, QCOLL, QHH
      DOUBLE PRECISION HHEMAX, UNDERR
      PARAMETER (VC = 0, FNORM = 0, FBASE = 6, FE = 10, QCOLL = 11,
     $    QHH = 0, HHEMAX = 0.5D0, UNDERR = 1.0D-200)
      DOUBLE PRECISION TSFBND, H, L, LENGTH, POWER, SIDE, U
      INTEGER K
      POWER = RAISE
      SIDE = 0.0D0
      LENGTH = 0.0D0
      DO 10 K = 1, 3
        L = BOX(K,NODE) - FQ(QHH+FBASE+K)
        H = BOX(3+K,NODE) - FQ(QHH+FBASE+K)
        U = MIN(MAX(FQ(AT+VC+K), L), H)
        POWER = POWER + U*(U - 2.0D0*FQ(AT+VC+K))
        SIDE = SIDE + MAX(L*FQ(QHH+FNORM+K), H*FQ(QHH+FNORM+K))
        LENGTH = LENGTH + MAX(ABS(L), ABS(H))
   10 CONTINUE
      TSXBOX = 0
      IF (POWER .GT. TSFBND(FQ(AT+1), LENGTH)) TSXBOX = 1
      IF (IQ(QCOLL) .EQ. 0 .AND. FQ(QHH+FE) .LE. HHEMAX) THEN
        IF (SIDE .LT. -FQ(QHH+FE)*LENGTH - UNDERR) TSXBOX = 1
      END IF
      END

C     TSXNOD (excludes_node) - returns 1 if a node provably holds no
C     better point: by its box, unless a hook has told more.
      INTEGER FUNCTION TSXNOD(X, BOX, MARK, CTL, RCTL, SUP, IQ, FQ,
     $                        NODE)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), BOX(6,*), RCTL(*), SUP(*), FQ(*)
      INTEGER MARK(*), CTL(*), IQ(LIQ), NODE
      INTEGER RCLUMP, QSURF, QFILT, UNSURE
      PARAMETER (RCLUMP = 138, QSURF = 17, QFILT = 14, UNSURE = 2)
      INTEGER TSXBOX, TSXCLU, TSXMRK
      TSXNOD = UNSURE
      IF (IQ(QSURF) .NE. 0) TSXNOD = TSXMRK(BOX, MARK, CTL, SUP, IQ, FQ,
     $    NODE)
      IF (TSXNOD .NE. UNSURE) RETURN
      TSXNOD = TSXBOX(BOX, IQ, FQ, QFILT, NODE, 0.0D0)
      IF (TSXNOD .EQ. 0 .AND. RCTL(RCLUMP) .GT. 0.0D0)
     $    TSXNOD = TSXCLU(X, RCTL, IQ, FQ, BOX(1,NODE))
      END

C     TSUPBD (set_upper_bound) - records that the best point's
C     L-coordinate is at most L, and sets the ball of that L, the filter
C     and the surface filter with it.
      SUBROUTINE TSUPBD(SUP, IQ, FQ, L)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION SUP(*), FQ(LFQ), L
      INTEGER IQ(LIQ)
      INTEGER VC, VDC, VC1, FNORM, FCEN, FE, FDC, QBYLIM, QHASBA, QSURF,
     $    QHH, QFILT, QHI
      DOUBLE PRECISION EPS, LMAX
      PARAMETER (VC = 0, VDC = 4, VC1 = 5, FNORM = 0, FCEN = 3, FE = 10,
     $    FDC = 11, QBYLIM = 8, QHASBA = 7, QSURF = 17, QHH = 0,
     $    QFILT = 14, QHI = 14, EPS = 2.0D0**(-52), LMAX = 1.0D100)
      INTEGER K
      FQ(QHI) = L
      IF (IQ(QBYLIM) .EQ. 0 .AND. ABS(L) .LE. LMAX) THEN
        IQ(QHASBA) = 1
        FQ(QFILT+VC1) = 0.0D0
        DO 10 K = 1, 3
          FQ(QFILT+VC+K) = FQ(QHH+FCEN+K) + L*FQ(QHH+FNORM+K)
          FQ(QFILT+VC1) = FQ(QFILT+VC1) + ABS(FQ(QFILT+VC+K))
   10   CONTINUE
C       a better point, on the open side, is in the ball of any L that
C       is not below the best point's: so only the error of C for this L
C       counts, not that of L, which is large where balls are flat:
C       counting it makes points near a plane take 10 times as long
        FQ(QFILT+VDC) = FQ(QHH+FDC) + ABS(L)*FQ(QHH+FE) +
     $      4.0D0*EPS*FQ(QFILT+VC1)
      END IF
      IF (IQ(QSURF) .NE. 0) CALL TSSFFI(SUP, IQ, FQ)
      END

C     TSCMPE (compare_exactly) - compares Z with the best point where
C     the bounds leave VERDIC, SIDE or both UNSURE: by limbs first, then
C     by the exact signs.  VERDIC becomes BEATS, LOSES, TIE times one of
C     these for a tie, or REJECT.
      SUBROUTINE TSCMPE(X, P, ORD, RCTL, HNT, IQ, FQ, Z, SIDE, HI,
     $                  VERDIC)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), FQ(*), HI
      INTEGER ORD(*), HNT(*), IQ(LIQ), Z, SIDE, VERDIC
      INTEGER CHLIMB, EXACT3, EXACT5, QFACET, QBEST, UNSURE, LOSES,
     $    REJECT
      PARAMETER (CHLIMB = 1, EXACT3 = 1, EXACT5 = 2, QFACET = 0,
     $    QBEST = 4, UNSURE = 2, LOSES = 1, REJECT = 0)
      INTEGER HHPINS, HHPORI, BEST, HARD, OUT
      BEST = IQ(QBEST)
      HARD = 0
      IF (VERDIC .EQ. UNSURE) HARD = 1
      OUT = 0
      IF (CHLIMB .EQ. 1) CALL TSDLIM(X, P, ORD, RCTL, HNT, IQ, FQ, Z,
     $    HI, SIDE, VERDIC, OUT)
      IF (OUT .EQ. 1) THEN
        VERDIC = REJECT
        RETURN
      END IF
      IF (SIDE .EQ. UNSURE .AND. VERDIC .NE. LOSES) SIDE = HHPORI(X, P,
     $    ORD, RCTL(EXACT3), IQ(QFACET+1), IQ(QFACET+2), IQ(QFACET+3),
     $    Z)
      IF (SIDE .EQ. 1 .AND. VERDIC .EQ. UNSURE) THEN
        VERDIC = HHPINS(X, P, ORD, RCTL(EXACT3), RCTL(EXACT5),
     $      IQ(QFACET+1), BEST, Z, 2)
        HARD = 2
      END IF
      IF (CHLIMB .EQ. 1) CALL TSNOTC(HNT, IQ, Z, SIDE, VERDIC, HARD)
      IF (SIDE .NE. 1) VERDIC = REJECT
      END

C     TSCMPP (compare_point) - makes Z the best point if it is better:
C     if it is on the open side and its L-coordinate is smaller (Theorem
C     1), ties by the rule of HHPINS.  The bounds of HHLIMI decide where
C     they can, else TSCMPE; then the better point's hi is lowered to
C     the other's.
      SUBROUTINE TSCMPP(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, Z)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(*), FQ(LFQ)
      INTEGER ORD(*), MARK(*), CTL(*), HNT(*), IQ(LIQ), Z
      INTEGER CHLIMB, RSLIMI, QBEST, QBYLIM, QSURF, QTIES, QHH, QLO,
     $    QHI, UNSURE, BEATS, LOSES, REJECT, TIE
      PARAMETER (CHLIMB = 1, RSLIMI = 140, QBEST = 4, QBYLIM = 8,
     $    QSURF = 17, QTIES = 6, QHH = 0, QLO = 13, QHI = 14,
     $    UNSURE = 2, BEATS = -1, LOSES = 1, REJECT = 0, TIE = 3)
      DOUBLE PRECISION HI, LO
      INTEGER VERDIC, SGN, SIDE
      CALL HHLIMI(FQ(QHH+1), X(1,Z), LO, HI, SIDE)
      IF (IQ(QSURF) .NE. 0 .AND. SIDE .GE. 0) CALL TSSHAR(X, MARK, SUP,
     $    IQ, FQ, Z, SIDE, LO, HI)
      VERDIC = UNSURE
      IF (IQ(QBEST) .EQ. 0) THEN
        VERDIC = BEATS
      ELSE IF (HI .LT. FQ(QLO)) THEN
        VERDIC = BEATS
      ELSE IF (LO .GT. FQ(QHI)) THEN
        VERDIC = LOSES
      END IF
      IF (SIDE .LT. 0 .OR. VERDIC .EQ. LOSES) RETURN
      IF (SIDE .EQ. 0 .OR. VERDIC .EQ. UNSURE) THEN
        IF (RCTL(RSLIMI) .GT. 0.0D0) CALL TSADDS(IQ, Z, 1)
        SGN = UNSURE
        IF (SIDE .EQ. 1) SGN = 1
        CALL TSCMPE(X, P, ORD, RCTL, HNT, IQ, FQ, Z, SGN, HI, VERDIC)
        IF (VERDIC .EQ. REJECT) RETURN
      END IF
      IF (ABS(VERDIC) .EQ. TIE) IQ(QTIES) = IQ(QTIES) + 1
      IF (VERDIC .GT. 0) THEN
        IF (HI .LT. FQ(QHI)) CALL TSUPBD(SUP, IQ, FQ, HI)
        IF (CHLIMB .EQ. 1) CALL TSREFB(P, ORD, CTL, SUP, IQ, FQ, UNSURE)
        RETURN
      END IF
      HI = MIN(HI, FQ(QHI))
      IQ(QBEST) = Z
      IF (VERDIC .NE. -TIE) IQ(QTIES) = 0
      FQ(QLO) = LO
      IQ(QBYLIM) = 0
      CALL TSUPBD(SUP, IQ, FQ, HI)
      IF (CHLIMB .EQ. 1) CALL TSREFB(P, ORD, CTL, SUP, IQ, FQ, SIDE)
      END

C     TSBEGS (search_begin) - begins the search for the apex of the
C     facet V: its set-up, its filter, and the two positions GUESS,
C     either of which may be 0.  The base is V(1), or, if the angle
C     there is small, the vertex opposite the longest edge.
      SUBROUTINE TSBEGS(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, V,
     $                  GUESS)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(*), FQ(LFQ)
      INTEGER ORD(*), MARK(*), CTL(*), HNT(*), IQ(LIQ), V(3), GUESS(2)
      INTEGER SCALE, NSURF, VC, VALLOW, SREADY, FE, QFACET, QBEST,
     $    QBYLIM, QHASBA, QBASE, QHARD, QSURF, QTIES, QOFFER, QNODES,
     $    QCOLL, QOUTSI, QBEHIN, QINLIS, QHASCA, QHH, QFILT, QNSPH, QLO,
     $    QHI
      DOUBLE PRECISION ANGLEE, LIMBE, HUGE, UNDERR
      PARAMETER (SCALE = 13, NSURF = 261, VC = 0, VALLOW = 8,
     $    SREADY = 1, FE = 10, QFACET = 0, QBEST = 4, QBYLIM = 8,
     $    QHASBA = 7, QBASE = 5, QHARD = 16, QSURF = 17, QTIES = 6,
     $    QOFFER = 19, QNODES = 10, QCOLL = 11, QOUTSI = 14,
     $    QBEHIN = 15, QINLIS = 9, QHASCA = 13, QHH = 0, QFILT = 14,
     $    QNSPH = 117, QLO = 13, QHI = 14,
     $    ANGLEE = 8000.0D0*2.0D0**(-52), LIMBE = 1.0D-6,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023, UNDERR = 1.0D-200)
      DOUBLE PRECISION EDGE, LONGST
      INTEGER BASE, I, J, K, OK
      DO 10 K = 1, 3
C       for TSXVIE of a guess
        FQ(QFILT+VC+K) = 0.0D0
        IQ(QFACET+K) = V(K)
   10 CONTINUE
      BASE = 1
      IQ(QBEST) = 0
      IQ(QBYLIM) = 0
      IQ(QHASBA) = 0
      IQ(QHASCA) = 0
      IQ(QHARD) = 0
      IQ(QSURF) = 0
      IQ(QOFFER) = 0
      IQ(QTIES) = 0
      IQ(QNODES) = 0
      IQ(QCOLL) = 0
      IQ(QOUTSI) = 0
      IQ(QBEHIN) = 0
      FQ(QFILT+VALLOW) = UNDERR
      FQ(QNSPH+SREADY) = 0.0D0
      FQ(QLO) = -HUGE
      FQ(QHI) = HUGE
   20 CALL HHSETU(X(1,V(BASE)), X(1,V(MOD(BASE,3)+1)),
     $            X(1,V(MOD(BASE+1,3)+1)), FQ(QHH+1))
      IQ(QBASE) = BASE
      IF (FQ(QHH+FE) .GE. ANGLEE) THEN
        LONGST = 0.0D0
        DO 40 K = 1, 3
          I = V(MOD(K,3)+1)
          J = V(MOD(K+1,3)+1)
          EDGE = (X(1,I) - X(1,J))**2 + (X(2,I) - X(2,J))**2 +
     $        (X(3,I) - X(3,J))**2
          IF (EDGE .GT. LONGST) THEN
            LONGST = EDGE
            BASE = K
          END IF
   40   CONTINUE
        IF (BASE .NE. IQ(QBASE)) GO TO 20
        IF (FQ(QHH+FE) .GT. LIMBE) CALL HHTHIN(X, P, ORD, CTL(SCALE), V,
     $      BASE, FQ(QHH+1), OK)
      END IF
      IF (HNT(NSURF) .GT. 0) CALL TSCHOS(X, MARK, CTL, HNT, SUP, IQ, FQ)
      DO 50 K = 1, 2
        I = GUESS(K)
        IF (I .NE. 0 .AND. I .NE. V(2) .AND. I .NE. V(3) .AND.
     $      I .NE. IQ(QBEST)) CALL TSCMPP(X, P, ORD, MARK, CTL, RCTL,
     $      HNT, SUP, IQ, FQ, I)
   50 CONTINUE
      IF (IQ(QHASBA) .EQ. 0) THEN
        CALL TSHALF(FQ)
        IF (IQ(QSURF) .NE. 0) CALL TSSFFI(SUP, IQ, FQ)
      END IF
      OK = 0
      IF (IQ(QSURF) .NE. 0) CALL TSBONS(MARK, SUP, IQ, OK)
      IQ(QINLIS) = 1 - OK
      END

C     TSOFFP (offer_point) - compares Z with the best point, unless it
C     is a vertex of the facet or does not pass the filter: the surface
C     filter if its height over the facet's surface is known.
      SUBROUTINE TSOFFP(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, Z)
      INTEGER LSUP, LIQ, LFQ
      PARAMETER (LSUP = 60, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(LSUP,*), FQ(LFQ)
      INTEGER ORD(*), MARK(*), CTL(*), HNT(*), IQ(LIQ), Z
      INTEGER SLOWES, SQUANT, VC, VWEIGH, VBASEH, FBASE, QFACET, QBEST,
     $    QSURF, QHH, QFILT, QTILT, SURFS
      PARAMETER (SLOWES = 59, SQUANT = 60, VC = 0, VWEIGH = 6,
     $    VBASEH = 7, FBASE = 6, QFACET = 0, QBEST = 4, QSURF = 17,
     $    QHH = 0, QFILT = 14, QTILT = 169, SURFS = 8)
      DOUBLE PRECISION TSFBND, A, H, POWER, RAISE, W1, W2, W3
      INTEGER J, K, AT
      IF (Z .EQ. IQ(QBEST) .OR. Z .EQ. IQ(QFACET+1) .OR.
     $    Z .EQ. IQ(QFACET+2) .OR. Z .EQ. IQ(QFACET+3)) RETURN
      W1 = X(1,Z) - FQ(QHH+FBASE+1)
      W2 = X(2,Z) - FQ(QHH+FBASE+2)
      W3 = X(3,Z) - FQ(QHH+FBASE+3)
      RAISE = 0.0D0
      AT = QFILT
C     TSMRKH's test and height, without a call for each point
      J = IQ(QSURF)
      K = -1
      IF (J .NE. 0) K = MARK(Z) - J
      IF (K .GE. 0 .AND. MOD(K, SURFS) .EQ. 0) THEN
        AT = QTILT
        H = SUP(SLOWES,J) + SUP(SQUANT,J)*(DBLE(K/SURFS) + 0.5D0)
        A = FQ(QTILT+VWEIGH)
        RAISE = A*(H - FQ(QTILT+VBASEH)) - ABS(A)*SUP(SQUANT,J)
      END IF
      POWER = W1*(W1 - 2.0D0*FQ(AT+VC+1)) + W2*(W2 -
     $    2.0D0*FQ(AT+VC+2)) + W3*(W3 - 2.0D0*FQ(AT+VC+3))
      IF (POWER .LE. TSFBND(FQ(AT+1), ABS(W1) + ABS(W2) + ABS(W3)) -
     $    RAISE) CALL TSCMPP(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ,
     $    FQ, Z)
      END

C     TSOFLF (offer_leaf) - offers the uncompleted points of a leaf, of
C     which there must be one, that pass the filter; or collects them,
C     if a near list is made.  The powers come first, as vectors, then
C     the least of each group, as most groups have no point that passes.
C     Stars are completed in the order of positions, by and large, so
C     the points before the first uncompleted one are most of the
C     completed ones.
      SUBROUTINE TSOFLF(X, P, ORD, BOX, LINK, MARK, CTL, RCTL, HNT, SUP,
     $                  LSX, LSID, LSD, IQ, FQ, NODE)
      INTEGER LIQ, LFQ, LEAFPT
      PARAMETER (LIQ = 51, LFQ = 183, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*), FQ(LFQ)
      REAL LSX(*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*), LSID(*),
     $    IQ(LIQ), NODE
      INTEGER RSLIMI, VC, FBASE, QCOLL, QHH, QFILT, LEAFGR, COMPLE
      DOUBLE PRECISION HUGE
      PARAMETER (RSLIMI = 140, VC = 0, FBASE = 6, QCOLL = 11, QHH = 0,
     $    QFILT = 14, LEAFGR = 8, COMPLE = -1,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      DOUBLE PRECISION TSFBND, B1, B2, B3, D1, D2, D3, MOST,
     $    POWER(LEAFPT), SIZE, W1, W2, W3
      INTEGER FIRST, I, J, K, LAST, N, Z
      CALL TSNRNG(CTL, NODE, FIRST, LAST)
    5 IF (LINK(FIRST) .EQ. COMPLE) THEN
        FIRST = FIRST + 1
        GO TO 5
      END IF
      N = LAST - FIRST + 1
      SIZE = 0.0D0
      DO 10 K = 1, 3
        SIZE = SIZE + ABS(BOX(K,NODE) - FQ(QHH+FBASE+K)) +
     $      ABS(BOX(3+K,NODE) - FQ(QHH+FBASE+K))
   10 CONTINUE
      MOST = TSFBND(FQ(QFILT+1), SIZE)
      D1 = 2.0D0*FQ(QFILT+VC+1)
      D2 = 2.0D0*FQ(QFILT+VC+2)
      D3 = 2.0D0*FQ(QFILT+VC+3)
      B1 = FQ(QHH+FBASE+1)
      B2 = FQ(QHH+FBASE+2)
      B3 = FQ(QHH+FBASE+3)
      I = FIRST - 1
      DO 20 K = 1, N
        W1 = X(1,I+K) - B1
        W2 = X(2,I+K) - B2
        W3 = X(3,I+K) - B3
        POWER(K) = W1*(W1 - D1) + W2*(W2 - D2) + W3*(W3 - D3)
   20 CONTINUE
      IF (IQ(QCOLL) .NE. 0) THEN
        CALL TSCOLF(LINK, LSX, LSID, LSD, IQ, FQ, FIRST, N, POWER, MOST)
        RETURN
      END IF
   30 IF (MOD(N, LEAFGR) .NE. 0) THEN
        N = N + 1
        POWER(N) = HUGE
        GO TO 30
      END IF
      DO 50 J = 1, N, LEAFGR
        IF (MIN(POWER(J), POWER(J+1), POWER(J+2), POWER(J+3),
     $          POWER(J+4), POWER(J+5), POWER(J+6), POWER(J+7)) .GT.
     $      MOST) GO TO 50
        DO 40 K = J, J + LEAFGR - 1
          IF (POWER(K) .GT. MOST) GO TO 40
          Z = I + K
          IF (LINK(Z) .NE. COMPLE) CALL TSOFFP(X, P, ORD, MARK, CTL,
     $        RCTL, HNT, SUP, IQ, FQ, Z)
   40   CONTINUE
   50 CONTINUE
      IF (RCTL(RSLIMI) .GT. 0.0D0) CALL TSADDS(IQ, FIRST, 0)
      END

C     TSTREE (search_tree) - finishes a search in the tree: the leaf of
C     the base first, then its parent's other child, and so on up to the
C     root; with cylinders, its grandparent's other three grandchildren,
C     tested at once.
C
C                 .            NODE: what is searched next.  STACK
C             /       \        holds what is left of the subtree that
C           TOP        NODE    was entered last; when it is empty,
C         /    \      /    \   TOP's sibling is next, or TOP's
C       FROM    .    .      .  grandparent: everything below TOP has
C                              been searched, FROM is where that ended.
      SUBROUTINE TSTREE(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL,
     $                  HNT, SUP, LSX, LSID, LSD, IQ, FQ)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*), FQ(LFQ)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(*), IQ(LIQ)
      INTEGER CHCAPS, LEAVES, HASCYL, EXACT3, RBIGBA, VC1, FBASE,
     $    QFACET, QBASE, QSURF, QNODES, QCOLL, QHASCA, QHH, QFILT, QCAP,
     $    STKDEP
      PARAMETER (CHCAPS = 1, LEAVES = 4, HASCYL = 258, EXACT3 = 1,
     $    RBIGBA = 7, VC1 = 5, FBASE = 6, QFACET = 0, QBASE = 5,
     $    QSURF = 17, QNODES = 10, QCOLL = 11, QHASCA = 13, QHH = 0,
     $    QFILT = 14, QCAP = 24, STKDEP = 96)
      DOUBLE PRECISION C1
      INTEGER TSLEAF, TSXBOX, TSXNOD, FLAT, FOURS, FROM, HEIGHT, K, N,
     $    NODE, STACK(STKDEP), TOP
C     a plane across an axis has no candidates for a facet in it; what
C     underflowed may be equal only here
      FLAT = 0
      DO 5 K = 3, 1, -1
        IF (ABS(X(K,IQ(QFACET+1)) - X(K,IQ(QFACET+2))) +
     $      ABS(X(K,IQ(QFACET+1)) - X(K,IQ(QFACET+3))) .LE. 0.0D0 .AND.
     $      RCTL(EXACT3) .GE. -1.0D0) FLAT = K
    5 CONTINUE
      IF (IQ(QCOLL) .NE. 0) FLAT = 0
      FOURS = HNT(HASCYL)
      IF (IQ(QSURF) .NE. 0) FOURS = 0
      C1 = FQ(QFILT+VC1)
      TOP = CTL(LEAVES) + TSLEAF(CTL, IQ(QFACET+IQ(QBASE))) - 1
      HEIGHT = 1
      STACK(1) = TOP
   10 IF (HEIGHT .EQ. 0 .AND. TOP .EQ. 1) RETURN
      FROM = TOP
      IQ(QNODES) = IQ(QNODES) + 1
      IF (HEIGHT .GT. 0) THEN
        NODE = STACK(HEIGHT)
        HEIGHT = HEIGHT - 1
      ELSE IF (FOURS .EQ. 1 .AND. TOP .GT. 3) THEN
        TOP = TOP/4
        NODE = TOP
C       FROM is the only grandchild with points
        IF (ALIVE(FROM) .GT. 0 .AND. ALIVE(FROM/2) + ALIVE(NODE) .EQ. 2)
     $      GO TO 10
      ELSE
        NODE = TOP + 1 - 2*MOD(TOP, 2)
        TOP = TOP/2
      END IF
      IF (ALIVE(NODE) .EQ. 0) GO TO 10
      IF (FLAT .GT. 0) THEN
        IF (ABS(BOX(FLAT,NODE) - FQ(QHH+FBASE+FLAT)) +
     $      ABS(BOX(3+FLAT,NODE) - FQ(QHH+FBASE+FLAT)) .LE. 0.0D0)
     $      GO TO 10
      END IF
      IF (CHCAPS .EQ. 1 .AND. IQ(QHASCA) .EQ. 1) THEN
        IF (TSXBOX(BOX, IQ, FQ, QCAP, NODE, 0.0D0) .EQ. 1) GO TO 10
      END IF
      IF (FOURS .EQ. 1 .AND. NODE .LT. CTL(LEAVES)) THEN
        N = 2*CTL(LEAVES) + 1
        CALL TSPFOU(BOX(1,N), CTL, FQ, NODE, FROM, STACK, HEIGHT)
        GO TO 10
      END IF
      IF (TSXNOD(X, BOX, MARK, CTL, RCTL, SUP, IQ, FQ, NODE) .EQ. 1)
     $    GO TO 10
      IF (NODE .GE. CTL(LEAVES)) THEN
        CALL TSOFLF(X, P, ORD, BOX, LINK, MARK, CTL, RCTL, HNT, SUP,
     $              LSX, LSID, LSD, IQ, FQ, NODE)
        IF (CHCAPS .EQ. 1 .AND. ABS(FQ(QFILT+VC1) - C1) .GT. 0.0D0
     $      .AND. FQ(QFILT+VC1) .GT. RCTL(RBIGBA))
     $    CALL TSCHCA(BOX, RCTL, HNT, IQ, FQ)
        C1 = FQ(QFILT+VC1)
        GO TO 10
      END IF
      STACK(HEIGHT+1) = 2*NODE
      STACK(HEIGHT+2) = 2*NODE + 1
      HEIGHT = HEIGHT + 2
      GO TO 10
      END

C     TSAPEX (apex) - Z is the apex of the facet V on its positive side,
C     or 0.  GUESS: see TSBEGS.
C
C     The search is complete without its stages: see the hooks.  So they
C     may be left out, or come in another order, and the apex is the
C     same.  That hull planes come before the block list saves lattices
C     a tenth of the time.
      SUBROUTINE TSAPEX(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL,
     $                  HNT, SUP, LSX, LSID, LSD, V, GUESS, Z)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*), LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(*), V(3), GUESS(2), Z
      INTEGER CHLIST, CHNEAR, CHHULL, CHCAPS, CHSURF, NSETS, RBIGBA,
     $    VC1, QBEST, QFILT
      PARAMETER (CHLIST = 1, CHNEAR = 1, CHHULL = 1, CHCAPS = 1,
     $    CHSURF = 1, NSETS = 205, RBIGBA = 7, VC1 = 5, QBEST = 4,
     $    QFILT = 14)
      DOUBLE PRECISION FQ(LFQ)
      INTEGER IQ(LIQ), OK
      IF (HNT(NSETS) .GT. 0) THEN
        CALL TSAPFS(X, P, ORD, RCTL, HNT, V, Z)
        IF (Z .NE. 0) RETURN
      END IF
      CALL TSBEGS(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, V,
     $            GUESS)
      OK = 0
      IF (CHLIST .EQ. 1) CALL TSSRSL(X, P, ORD, BOX, LINK, MARK, CTL,
     $    RCTL, HNT, SUP, LSX, LSID, LSD, IQ, FQ, OK)
      IF (OK .EQ. 0 .AND. CHHULL .EQ. 1) CALL TSONHP(X, P, ORD, RCTL,
     $    HNT, IQ, OK)
      IF (OK .EQ. 0 .AND. CHLIST .EQ. 1) CALL TSSRBL(X, P, ORD, BOX,
     $    LINK, MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD, IQ, FQ, OK)
      IF (OK .EQ. 0) THEN
        IF (CHCAPS .EQ. 1 .AND. FQ(QFILT+VC1) .GT. RCTL(RBIGBA))
     $    CALL TSCHCA(BOX, RCTL, HNT, IQ, FQ)
        IF (CHNEAR .EQ. 1) CALL TSSRNL(X, P, ORD, BOX, ALIVE, LINK,
     $      MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD, IQ, FQ, OK)
        IF (OK .EQ. 0) THEN
          CALL TSTREE(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $                SUP, LSX, LSID, LSD, IQ, FQ)
          IF (CHNEAR .EQ. 1) CALL TSREFI(RCTL, IQ)
        END IF
        IF (CHSURF .EQ. 1) CALL TSSEEK(X, P, ORD, LINK, MARK, CTL, RCTL,
     $      HNT, SUP, IQ)
        IF (CHHULL .EQ. 1) CALL TSNOTE(HNT, IQ)
        IF (CHCAPS .EQ. 1) CALL TSSKPL(X, BOX, CTL, RCTL, HNT, IQ, FQ)
      END IF
      Z = IQ(QBEST)
      END

C     ------------------------------------------------------------------
C     Star by star
C
C     STATES OF A VERTEX V: LINK(V).  Whether V is wanted is another
C     matter: HEAD(V).
C       NEW       in no tetrahedron: all points at first, by TSBLD
C       met       0, or its first edge.  From NEW: in TSADDT as an apex,
C                 in TSBEGI as a vertex of the first facet, in TSPUSH as
C                 the beginning of a seed edge
C       COMPLE    its star is known.  From met: in TSSTAR, for S itself
C                 (which may be NEW, if TSSEED began its star); in
C                 TSSTRS, if V owns no facet and no vertex before it
C                 does
C     TSREST sets a resumed result's vertices to met if they have an
C     open facet, else to COMPLE.  COMPLE is final.  A vertex that is
C     not wanted becomes COMPLE in TSREST alone, where all its facets
C     are closed.
C     ------------------------------------------------------------------

C     TSCMPL (complete_vertex) - marks the star of S complete: S leaves
C     the tree and the lists.
      SUBROUTINE TSCMPL(ALIVE, LINK, CTL, LSX, LSID, S)
      REAL LSX(*)
      INTEGER ALIVE(*), LINK(*), CTL(*), LSID(*), S
      INTEGER CHLIST, LEAVES, COMPLE
      PARAMETER (CHLIST = 1, LEAVES = 4, COMPLE = -1)
      INTEGER TSLEAF, I, NODE
      IF (LINK(S) .EQ. COMPLE) RETURN
      LINK(S) = COMPLE
      NODE = CTL(LEAVES) + TSLEAF(CTL, S) - 1
   10 IF (NODE .GT. 0) THEN
        ALIVE(NODE) = ALIVE(NODE) - 1
        IF (ALIVE(NODE) .EQ. 0) THEN
          NODE = NODE/2
          GO TO 10
        END IF
      END IF
      I = S
      IF (CHLIST .EQ. 1) CALL TSLEAV(LSX, LSID, I)
      END

C     TSBEGI (begin_mesh) - puts the first facet into the link of S, its
C     vertex of least position, as a seed edge, for which there is
C     always room.  INFO is 0, or the code of points without a
C     tetrahedron.
      SUBROUTINE TSBEGI(X, P, ORD, LINK, POOL, CTL, RCTL, S, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), LINK(*), POOL(*), CTL(*), S, INFO
      INTEGER ESEED
      PARAMETER (ESEED = -1)
      INTEGER E, I, V(3)
      CALL TSFIRS(X, P, ORD, CTL, RCTL, V, INFO)
      IF (INFO .NE. 0) RETURN
      S = V(1)
      DO 10 I = 1, 3
        LINK(V(I)) = 0
   10 CONTINUE
      CALL TSPUSH(LINK, POOL, CTL, ESEED, V(2), V(3), E)
      END

C     TSSTAR (complete_star) - completes the star of S, whose open
C     facets are the edges of the link.  INFO is 0, MORE or FULL.
      SUBROUTINE TSSTAR(X, P, ORD, TET, ADJ, BOX, ALIVE, HEAD, LINK,
     $                  POOL, MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD,
     $                  S, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), TET(4,*), ADJ(*), ALIVE(*), HEAD(*), LINK(*),
     $    POOL(*), MARK(*), CTL(*), HNT(*), LSID(*), S, INFO
      INTEGER CHLIST, NTET, MAXTET, OLDEST, NEWEST, EDGLEN, ECODE,
     $    ESEED, EDEAD, EFROM, ETO, EPREV, ENEXT, MORE, FULL
      PARAMETER (CHLIST = 1, NTET = 2, MAXTET = 3, OLDEST = 9,
     $    NEWEST = 10, EDGLEN = 6, ECODE = 0, ESEED = -1, EDEAD = -2,
     $    EFROM = 1, ETO = 2, EPREV = 3, ENEXT = 4, MORE = 1, FULL = 2)
      INTEGER AFTER, C, E, GUESS(2), OK, PREV, V(3)
      IF (CHLIST .EQ. 1) CALL TSMKLS(X, BOX, ALIVE, LINK, CTL, HNT, LSX,
     $    LSID, LSD, S)
   10 E = CTL(OLDEST)
      IF (E .GE. CTL(NEWEST)) THEN
        IF (POOL(E+ECODE) .EQ. EDEAD) THEN
          CTL(OLDEST) = E - EDGLEN
          GO TO 10
        END IF
        V(1) = S
        V(2) = POOL(E+EFROM)
        V(3) = POOL(E+ETO)
        PREV = POOL(E+EPREV)
        AFTER = POOL(E+ENEXT)
        GUESS(1) = 0
        GUESS(2) = 0
        IF (PREV .NE. 0) GUESS(1) = POOL(PREV+EFROM)
        IF (AFTER .NE. 0) GUESS(2) = POOL(AFTER+ETO)
        CALL TSAPEX(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $              SUP, LSX, LSID, LSD, V, GUESS, C)
        IF (C .EQ. 0) THEN
          IF (POOL(E+ECODE) .NE. ESEED) ADJ(POOL(E+ECODE)) = 0
          CALL TSCONN(POOL, PREV, 0)
          CALL TSCONN(POOL, 0, AFTER)
          CALL TSRMED(LINK, POOL, E)
          GO TO 10
        END IF
        IF (CTL(NTET) .EQ. CTL(MAXTET)) THEN
          CALL TSFLUS(TET, ADJ, HEAD, POOL, CTL)
          INFO = MORE
          RETURN
        END IF
        CALL TSMKRO(TET, ADJ, HEAD, LINK, POOL, CTL, S, OK)
        IF (OK .EQ. 0) THEN
          INFO = FULL
          RETURN
        END IF
        E = CTL(OLDEST)
        CALL TSADDT(TET, ADJ, LINK, POOL, CTL, S, E, C)
        GO TO 10
      END IF
      CALL TSCLRL(CTL)
      CALL TSFLUS(TET, ADJ, HEAD, POOL, CTL)
      CALL TSCMPL(ALIVE, LINK, CTL, LSX, LSID, S)
      INFO = 0
      END

C     TSSTRS (complete_stars) - completes the stars of all wanted
C     vertices, beginning with S if the link has edges: first those
C     connected through open facets, then one of the rest, and so on.
C     INFO is 0, MORE or FULL.
      SUBROUTINE TSSTRS(X, P, ORD, TET, ADJ, BOX, ALIVE, HEAD, LINK,
     $                  POOL, MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD,
     $                  S, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), TET(4,*), ADJ(*), ALIVE(*), HEAD(*), LINK(*),
     $    POOL(*), MARK(*), CTL(*), HNT(*), LSID(*), S, INFO
      INTEGER NP, OLDEST, NEWEST, LOWEST, NEXTNE, NEW, UNWANT, FULL
      PARAMETER (NP = 1, OLDEST = 9, NEWEST = 10, LOWEST = 11,
     $    NEXTNE = 12, NEW = -2, UNWANT = -1, FULL = 2)
      INTEGER OK
   10 IF (CTL(OLDEST) .GE. CTL(NEWEST)) THEN
        CALL TSSTAR(X, P, ORD, TET, ADJ, BOX, ALIVE, HEAD, LINK, POOL,
     $              MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD, S, INFO)
        IF (INFO .NE. 0) RETURN
      END IF
      DO 20 S = CTL(LOWEST), CTL(NP)
        IF (HEAD(S) .GT. 0) GO TO 30
C       no vertex of a smaller position owns a facet, so one that was
C       met and owns none has no open facet: its star is complete
        IF (LINK(S) .EQ. 0 .AND. HEAD(S) .EQ. 0) CALL TSCMPL(ALIVE,
     $      LINK, CTL, LSX, LSID, S)
   20 CONTINUE
   30 CTL(LOWEST) = S
      IF (S .LE. CTL(NP)) THEN
        CALL TSEPOO(TET, ADJ, HEAD, LINK, POOL, CTL, S, OK)
      ELSE
        DO 40 S = CTL(NEXTNE), CTL(NP)
          IF (LINK(S) .EQ. NEW .AND. HEAD(S) .NE. UNWANT) GO TO 50
   40   CONTINUE
   50   CTL(NEXTNE) = S
        INFO = 0
        IF (S .GT. CTL(NP)) RETURN
        CALL TSMKRO(TET, ADJ, HEAD, LINK, POOL, CTL, S, OK)
        IF (OK .EQ. 1) CALL TSSEED(X, P, ORD, BOX, ALIVE, LINK, POOL,
     $      MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD, S)
      END IF
      INFO = FULL
      IF (OK .EQ. 1) GO TO 10
      END

C     ------------------------------------------------------------------
C     The workspace; a mesh from the points, or from a beginning
C
C     Constants:
C       INDXTR = 5   INDEX_EXTRA  what an index keeps in IW beside REP,
C               ORD, ALIVE and MARK
C       POOLMN = 512 POOL_MIN  INDXTR and the minimum length of the pool
C       HUBPOO = 225000 TESS_HUB  the pool that is recommended
C               beyond 4 N in any case, up to 8 N: memory against FULL,
C               where one vertex has a very large star
C       SURFPT = 500 TESS_SURFACES_FROM  with fewer points there are no
C               reference surfaces and no cylinders
C     ------------------------------------------------------------------

C     TSPLC4 (place_in_four) - returns the first K with V(K,T) = X, or
C     5.
      INTEGER FUNCTION TSPLC4(V, T, X)
      INTEGER V(4,*), T, X
      INTEGER K
      DO 10 K = 1, 4
        IF (V(K,T) .EQ. X) GO TO 20
   10 CONTINUE
   20 TSPLC4 = K
      END

C     TSMATE (matching_facet) - J is the facet of tetrahedron U, of four
C     different vertices, that has the vertices of the facet F of
C     another one in opposite order, so that, both tetrahedra being
C     positively oriented, their apexes are on opposite sides; 5 if
C     there is none.
      SUBROUTINE TSMATE(TET, F, U, J)
      INTEGER TET(4,*), F(3), U, J
      INTEGER G(3), I
      J = 1
   10 IF (J .LT. 4 .AND. (TET(J,U) .EQ. F(1) .OR. TET(J,U) .EQ. F(2)
     $    .OR. TET(J,U) .EQ. F(3))) THEN
        J = J + 1
        GO TO 10
      END IF
      CALL TSTETF(TET, U, J, G)
      DO 20 I = 1, 3
        IF (G(I) .EQ. F(1) .AND. G(MOD(I, 3) + 1) .EQ. F(3) .AND.
     $      G(MOD(I + 1, 3) + 1) .EQ. F(2)) RETURN
   20 CONTINUE
      J = 5
      END

C     TSLENG (workspace_lengths) - finds the lengths of IW and RW for N
C     points: the minima LIW and LRW, and what is recommended beyond
C     them: in IW POOL, and MARKS for surfaces; in RW CYLS for
C     cylinders.  Uniform points need 5 N**(2/3) facets in the pool; a
C     star of all points needs 2 N, which take 12 N integers: granted up
C     to HUBPOO.  Marks and cylinders get room for as many points as can
C     need them.  OK is 1, or 0 for a bad N: negative, or so large that
C     a minimum exceeds the largest integer.
      SUBROUTINE TSLENG(N, LIW, LRW, POOL, MARKS, CYLS, OK)
      INTEGER N, LIW, LRW, POOL, MARKS, CYLS, OK
      INTEGER SURFS, SURFPT, POOLMN, HUBPOO, INTMAX
      PARAMETER (SURFS = 8, SURFPT = 500, POOLMN = 512, HUBPOO = 225000,
     $    INTMAX = 2147483647)
      DOUBLE PRECISION HUB, ROOM
      INTEGER TSCUBE, TSLCOU, LEFT, LVS
      OK = 0
C     2 TSLCOU(N) < N/12 + 2
      IF (N .LT. 0 .OR. N .GT. (INTMAX - POOLMN)/5) RETURN
      LVS = TSLCOU(N)
      LIW = 4*N + 2*LVS + POOLMN
      LRW = 3*N + 12*LVS
      LEFT = INTMAX - LIW
      HUB = MIN(8.0D0*DBLE(N), DBLE(HUBPOO))
      ROOM = 4.0D0*DBLE(N) + MAX(HUB, 60.0D0*DBLE(TSCUBE(N))**2)
      POOL = LEFT
      IF (ROOM .LT. DBLE(LEFT)) POOL = INT(ROOM)
      MARKS = 0
      CYLS = 0
      OK = 1
      IF (N .LT. SURFPT) RETURN
      LEFT = LEFT - POOL
      POOL = POOL - 15*SURFS
      IF (2*SURFS*LVS .LT. LEFT - N) MARKS = N + SURFS*(2*LVS + 15)
      IF (32*(LVS/3) .LT. INTMAX - LRW) CYLS = 32*(LVS/3)
      END

C     TSLAYO (lay_out) - sets what a mesher begins with.  (Its workspace
C     is cut up by TSWORK, TESSIX and TESSQU.)
      SUBROUTINE TSLAYO(CTL, RCTL, HNT, LSID, LSD)
      INTEGER CTL(*), HNT(*), LSID(*)
      DOUBLE PRECISION RCTL(*), LSD(*)
      INTEGER NP
      PARAMETER (NP = 1)
      CTL(NP) = 0
      CALL TSSTAG(RCTL, HNT, LSID, LSD)
      END

C     TSSORT (prepare_points) - prepares N > 0 points: sorts them, drops
C     duplicates, builds the tree, and makes cylinders if ROOMY is 1.
C     INFO is 0, or RANGE.
      SUBROUTINE TSSORT(N, X, P, ORD, BOX, ALIVE, REP, CTL, RCTL, HNT,
     $                  LSID, LSD, ROOMY, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), LSD(*)
      INTEGER N, ORD(*), ALIVE(*), REP(*), CTL(*), HNT(*), LSID(*),
     $    ROOMY, INFO
      INTEGER CHCYLI, CHLIMB, LEAVES, RANGE
      PARAMETER (CHCYLI = 1, CHLIMB = 1, LEAVES = 4, RANGE = 6)
      INTEGER HHHOLD, TSINLI, I, TWINS
      CALL HHV500
      CALL HHL088
      CALL TSLAYO(CTL, RCTL, HNT, LSID, LSD)
      INFO = RANGE
      IF (HHHOLD(N, P) .EQ. 0) RETURN
      IF (TSINLI(N, P) .EQ. 0) RETURN
      INFO = 0
      DO 10 I = 1, N
        REP(I) = I
   10 CONTINUE
      CALL TSDIST(N, X, P, ORD, REP, CTL)
      CALL TSKDSO(X, ORD, REP, CTL)
      TWINS = 0
      DO 20 I = 1, N
        REP(I) = REP(REP(I))
        IF (REP(I) .NE. I) TWINS = 1
   20 CONTINUE
      IF (TWINS .EQ. 1) THEN
C       the cuts may have separated duplicates: sort again without them
        CALL TSDIST(N, X, P, ORD, REP, CTL)
        CALL TSKDSO(X, ORD, REP, CTL)
      END IF
      CALL TSSCAL(X, CTL, RCTL)
      CALL TSBOXE(X, BOX, CTL)
      IF (CHLIMB .EQ. 1) CALL TSCLUM(BOX, CTL, RCTL)
      CALL TSREVI(ALIVE, CTL)
      I = 2*CTL(LEAVES) + 1
      IF (CHCYLI .EQ. 1 .AND. ROOMY .EQ. 1) CALL TSMCYS(X, BOX,
     $    BOX(1,I), CTL, HNT)
      END

C     TSCHKU (check_unfinished) - checks in one pass that the caller's
C     arrays can be an unfinished result: the vertices of each
C     tetrahedron are no duplicates, and it is positively oriented; each
C     facet is on the hull, open, or matched with its neighbour's, and
C     the neighbour's apex is not inside the ball.  INFO is 0, -5 or -6;
C     HEAD then holds the positions of the points.
      SUBROUTINE TSCHKU(N, X, P, ORD, TET, ADJ, HEAD, CTL, RCTL, INFO)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER N, ORD(*), TET(4,*), ADJ(*), HEAD(*), CTL(*), INFO
      INTEGER NP, NTET, EXACT3, EXACT5
      PARAMETER (NP = 1, NTET = 2, EXACT3 = 1, EXACT5 = 2)
      INTEGER HHPINS, HHPORI, F(3), I, J, K, T, U, V(4)
      INFO = -5
      DO 10 I = 1, N
        HEAD(I) = 0
   10 CONTINUE
      DO 20 I = 1, CTL(NP)
        HEAD(ORD(I)) = I
   20 CONTINUE
      DO 40 T = 1, CTL(NTET)
        DO 30 K = 1, 4
          IF (HEAD(TET(K,T)) .EQ. 0) RETURN
   30   CONTINUE
   40 CONTINUE
      DO 70 I = 1, CTL(NTET)
        T = I
        DO 50 K = 1, 4
          V(K) = HEAD(TET(K,T))
   50   CONTINUE
        IF (HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3),
     $      V(4)) .LE. 0) RETURN
        DO 60 K = 1, 4
          U = ADJ(4*(T-1)+K)
          IF (U .GT. 0) THEN
            J = K
            CALL TSTETF(TET, T, J, F)
            CALL TSMATE(TET, F, U, J)
            INFO = -6
            IF (J .EQ. 5) RETURN
            IF (ADJ(4*(U-1)+J) .NE. T) RETURN
            INFO = -5
            IF (U .GT. T) THEN
              IF (HHPINS(X, P, ORD, RCTL(EXACT3), RCTL(EXACT5), V, V(4),
     $            HEAD(TET(J,U)), 1) .LT. 0) RETURN
            END IF
          END IF
   60   CONTINUE
   70 CONTINUE
      INFO = 0
      END

C     TSWANT (mark_wanted) - marks in HEAD which vertices are wanted:
C     with MASKED = 1 the points I with MINE(I) not 0, else all.  START
C     is how many slots the table starts with for so many: a little more
C     than what uniform points need, as a small table stays in the
C     cache.
      SUBROUTINE TSWANT(N, MASKED, MINE, REP, HEAD, CTL, START)
      INTEGER N, MASKED, MINE(*), REP(*), HEAD(*), CTL(*), START
      INTEGER NP, UNWANT
      PARAMETER (NP = 1, UNWANT = -1)
      INTEGER TSCUBE, I, OWN
      DO 10 I = 1, CTL(NP)
        HEAD(I) = MASKED*UNWANT
   10 CONTINUE
      OWN = CTL(NP)*(1 - MASKED)
      DO 20 I = 1, N*MASKED
        IF (MINE(I) .NE. 0) THEN
          HEAD(REP(I)) = 0
          OWN = OWN + 1
        END IF
   20 CONTINUE
      START = 9*TSCUBE(OWN)**2 + 16
      END

C     TSREST (rebuild_state) - resumes an unfinished result that TSCHKU
C     has passed:  converts TET to positions; completes the vertices
C     that have no open facet; the open facets at S, the first vertex of
C     the last tetrahedron, become edges of its link in the order of
C     their tetrahedra, and the others enter the table.  INFO is 0,
C     FULL, or -6 for a facet that is open twice.
C
C     HEAD has the positions of the points at first.
      SUBROUTINE TSREST(N, MASKED, MINE, TET, ADJ, ALIVE, REP, HEAD,
     $                  LINK, POOL, CTL, LSX, LSID, S, INFO)
      REAL LSX(*)
      INTEGER N, MASKED, MINE(*), TET(4,*), ADJ(*), ALIVE(*), REP(*),
     $    HEAD(*), LINK(*), POOL(*), CTL(*), LSID(*), S, INFO
      INTEGER NP, NTET, POOLLN, SLOTS, NFACET, ENTLEN, COMPLE, UNWANT,
     $    OPEN, FULL
      PARAMETER (NP = 1, NTET = 2, POOLLN = 5, SLOTS = 6, NFACET = 7,
     $    ENTLEN = 4, COMPLE = -1, UNWANT = -1, OPEN = -1, FULL = 2)
      INTEGER TSOWNE, CODE, E, I, K, MANY, OK, START, T, V(3)
      DO 20 T = 1, CTL(NTET)
        DO 10 K = 1, 4
          TET(K,T) = HEAD(TET(K,T))
          LINK(TET(K,T)) = COMPLE
   10   CONTINUE
   20 CONTINUE
      CALL TSWANT(N, MASKED, MINE, REP, HEAD, CTL, START)
      MANY = 0
      DO 40 I = 1, 4*CTL(NTET)
        IF (ADJ(I) .EQ. OPEN) THEN
          CODE = I
          CALL TSFCOD(TET, CODE, V)
          IF (TSOWNE(HEAD, V) .NE. 0) MANY = MANY + 1
          DO 30 K = 1, 3
            LINK(V(K)) = 0
   30     CONTINUE
        END IF
   40 CONTINUE
      DO 50 I = 1, CTL(NP)
        IF (LINK(I) .EQ. COMPLE) THEN
          LINK(I) = 0
          E = I
          CALL TSCMPL(ALIVE, LINK, CTL, LSX, LSID, E)
        END IF
   50 CONTINUE
      INFO = FULL
      IF (MANY .GT. CTL(POOLLN)/ENTLEN) RETURN
      CTL(NFACET) = MANY
      CALL TSREHA(TET, ADJ, HEAD, POOL, CTL, 0, 2*MANY + 1, OK)
      IF (OK .EQ. 0) RETURN
C     its two sides removed each other
      INFO = -6
      IF (CTL(NFACET) .LT. MANY) RETURN
      INFO = 0
      S = TET(1,CTL(NTET))
      IF (HEAD(S) .EQ. UNWANT) S = 0
      I = MAX(2*MANY, START) + 1
      CTL(SLOTS) = 1
      CTL(NFACET) = 0
      CALL TSEADJ(TET, ADJ, LINK, POOL, CTL, S, OK)
C     at most so many are left for the table
      CTL(NFACET) = MANY
      IF (OK .EQ. 1) CALL TSREHA(TET, ADJ, HEAD, POOL, CTL, S, I, OK)
      IF (OK .EQ. 0) INFO = FULL
      END

C     TSALLO (lay_out_pool) - lays out what is left of IW, of length
C     LIW: SPACE marks, if there are reference surfaces or may be, then
C     HEAD, LINK and the pool, of LENGTH.
      SUBROUTINE TSALLO(N, RCTL, HNT, LIW, SPACE, LENGTH)
      INTEGER N, HNT(*), LIW, SPACE, LENGTH
      DOUBLE PRECISION RCTL(*)
      INTEGER CHSURF, INDXTR
      PARAMETER (CHSURF = 1, INDXTR = 5)
      INTEGER TSLCOU, CYLS, LIWMIN, LRWMIN, OK, POOL
      CALL TSLENG(N, LIWMIN, LRWMIN, POOL, SPACE, CYLS, OK)
      IF (CHSURF .EQ. 1) THEN
        CALL TSRMRK(RCTL, HNT, LIW, LIWMIN, POOL, SPACE)
      ELSE
        SPACE = 0
      END IF
      LENGTH = LIW - 4*N - 2*TSLCOU(N) - INDXTR - SPACE
      END

C     TSBLD (build) - completes the stars of all points, or, if MASKED =
C     1, of the points I with MINE(I) not 0, for arguments that TSBADA
C     has passed.  INFO is a code of TESSRE.
C
C     HEAD, LINK, POOL and MARK are declared with their lengths, so no
C     two of them share an element of IW, and the standard lets them be
C     altered.
      SUBROUTINE TSBLD(N, X, P, ORD, MASKED, MINE, ROOM, FOUND, TET,
     $                 ADJ, BOX, ALIVE, REP, HEAD, LINK, POOL, MARK,
     $                 CTL, RCTL, HNT, SUP, LSX, LSID, LSD, LENGTH,
     $                 SPACE, INFO)
      INTEGER N, LENGTH, SPACE, ORD(*), MASKED, MINE(*), ROOM, FOUND,
     $    TET(4,*), ADJ(*), ALIVE(*), REP(*), HEAD(N), LINK(N),
     $    POOL(LENGTH), MARK(SPACE), CTL(*), HNT(*), LSID(*), INFO
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER NP, NTET, MAXTET, POOLLN, SLOTS, NFACET, UNFILE, LOWEST,
     $    NEXTNE, NEW, FULL
      PARAMETER (NP = 1, NTET = 2, MAXTET = 3, POOLLN = 5, SLOTS = 6,
     $    NFACET = 7, UNFILE = 8, LOWEST = 11, NEXTNE = 12, NEW = -2,
     $    FULL = 2)
      INTEGER I, K, OK, S, START, T
      CTL(POOLLN) = LENGTH
      CTL(MAXTET) = ROOM
      CTL(NTET) = FOUND
      CTL(UNFILE) = FOUND + 1
      CTL(SLOTS) = 1
      CTL(NFACET) = 0
      CTL(LOWEST) = 1
      CTL(NEXTNE) = 1
      IF (MASKED .EQ. 0) CTL(NEXTNE) = CTL(NP) + 1
      CALL TSCLRL(CTL)
C     drops what earlier calls have left: lists that lack points that
C     are uncompleted again, and planes that bounded only what was
C     uncompleted then
      CALL TSDROP(HNT, LSID, LSD)
      DO 10 I = 1, CTL(NP)
        LINK(I) = NEW
   10 CONTINUE
      S = 0
      INFO = 0
      IF (CTL(NTET) .GT. 0) THEN
        CALL TSCHKU(N, X, P, ORD, TET, ADJ, HEAD, CTL, RCTL, INFO)
        IF (INFO .NE. 0) RETURN
        CALL TSREST(N, MASKED, MINE, TET, ADJ, ALIVE, REP, HEAD, LINK,
     $              POOL, CTL, LSX, LSID, S, INFO)
      ELSE
        CALL TSWANT(N, MASKED, MINE, REP, HEAD, CTL, START)
        IF (MASKED .EQ. 0) CALL TSBEGI(X, P, ORD, LINK, POOL, CTL, RCTL,
     $      S, INFO)
        OK = 1
        IF (INFO .EQ. 0) CALL TSREHA(TET, ADJ, HEAD, POOL, CTL, S,
     $      START, OK)
        IF (OK .EQ. 0) INFO = FULL
      END IF
      IF (INFO .EQ. 0) CALL TSSTRS(X, P, ORD, TET, ADJ, BOX, ALIVE,
     $    HEAD, LINK, POOL, MARK, CTL, RCTL, HNT, SUP, LSX, LSID, LSD,
     $    S, INFO)
      IF (MASKED .EQ. 1) CALL TSREVI(ALIVE, CTL)
      DO 30 T = 1, CTL(NTET)
        DO 20 K = 1, 4
          TET(K,T) = ORD(TET(K,T))
   20   CONTINUE
   30 CONTINUE
      FOUND = CTL(NTET)
      END

C     TSBADA (bad_argument) - INFO is the code of a bad argument of
C     TESSRE, or 0.  With MASKED = 1 the points are known to be finite.
      SUBROUTINE TSBADA(N, P, MASKED, MAXTET, NTET, TET, ADJ, LIW, LRW,
     $                  INFO)
      DOUBLE PRECISION P(3,*)
      INTEGER N, MASKED, MAXTET, NTET, TET(4,*), ADJ(4,*), LIW, LRW,
     $    INFO
      INTEGER OPEN, INTMAX
      PARAMETER (OPEN = -1, INTMAX = 2147483647)
      INTEGER HHFINI, CYLS, K, LIWMIN, LRWMIN, MARKS, OK, POOL, T
      INFO = -1
      CALL TSLENG(N, LIWMIN, LRWMIN, POOL, MARKS, CYLS, OK)
      IF (OK .EQ. 0) RETURN
      INFO = -2
      IF (MASKED .EQ. 0) THEN
        IF (HHFINI(N, P) .LT. N) RETURN
      END IF
      INFO = -3
      IF (MAXTET .LT. 0 .OR. MAXTET .GT. (INTMAX - 3)/4) RETURN
      INFO = -4
      IF (NTET .LT. 0 .OR. NTET .GT. MAXTET) RETURN
      INFO = -5
      DO 20 T = 1, NTET
        DO 10 K = 1, 4
          IF (TET(K,T) .LT. 1 .OR. TET(K,T) .GT. N) RETURN
   10   CONTINUE
   20 CONTINUE
      INFO = -6
      DO 40 T = 1, NTET
        DO 30 K = 1, 4
          IF (ADJ(K,T) .LT. OPEN .OR. ADJ(K,T) .GT. NTET) RETURN
   30   CONTINUE
   40 CONTINUE
      INFO = 0
      IF (LRW .LT. LRWMIN) INFO = -9
      IF (LIW .LT. LIWMIN) INFO = -7
      END

C     TESSWK - recommended lengths of the workspace of TESS.
C
C       N       (in)   number of points
C       MAXTET  (in)   tetrahedra that TET and ADJ have room for:
C                      checked, but the lengths do not depend on it; 0
C                      will do
C       LIW     (out)  length of IW, integers
C       LRW     (out)  length of RW, doubles
C       INFO    (out)  0; -1 for a bad N, -2 for a bad MAXTET: negative,
C                      or so large that a length, or 4*MAXTET + 3, would
C                      exceed the largest integer.  The lengths are then
C                      0
C
C     The pool of open facets that LIW includes suffices for all inputs
C     except those whose number of tetrahedra is quadratic in N and,
C     beyond 28,000 points, some where one vertex is in almost all
C     tetrahedra (a plane grid and one point).
C
C     How large should MAXTET be?  8*N is enough where the points fill a
C     volume (they have 6*N to 6.8*N tetrahedra), for lattices (4.8*N to
C     6*N), and near planes, spheres and most smooth surfaces (2*N to
C     7.2*N).  Random points on a tube or a torus need more (9*N to 20*N
C     for 1,000 to 60,000 points), a helix or two lines up to N**2/2.  A
C     low guess costs little: after INFO = 1 TESSRE takes as long as N
C     tetrahedra of random points, plus a third of the time that the
C     existing ones took.
      SUBROUTINE TESSWK(N, MAXTET, LIW, LRW, INFO)
      INTEGER N, MAXTET, LIW, LRW, INFO
      INTEGER INTMAX
      PARAMETER (INTMAX = 2147483647)
      INTEGER CYLS, MARKS, OK, POOL
      LIW = 0
      LRW = 0
      INFO = -2
      CALL TSLENG(N, LIW, LRW, POOL, MARKS, CYLS, OK)
      IF (OK .EQ. 0) INFO = -1
      IF (OK .EQ. 0) RETURN
      IF (MAXTET .LT. 0 .OR. MAXTET .GT. (INTMAX - 3)/4) THEN
        LIW = 0
        LRW = 0
        RETURN
      END IF
      LIW = LIW + POOL + MARKS
      LRW = LRW + CYLS
      INFO = 0
      END

C     TESS - the Delaunay tetrahedralization of N points.
C
C       N       (in)   number of points, >= 0
C       P       (in)   3*N coordinates
C       MAXTET  (in)   tetrahedra that TET and ADJ have room for, >= 0
C       NTET    (out)  number of tetrahedra; for a NaN or infinity in P
C                      (INFO = -2) the first point that has one
C       TET     (out)  4*MAXTET; the first 4*NTET are set
C       ADJ     (out)  4*MAXTET; the first 4*NTET are set
C       LIW     (in)   length of IW, at least 4*N + 2*L + 512, where L
C                      is the least power of two with 48*L >= N: 4*N +
C                      N/12 + 514 always suffices.  Give what TESSWK
C                      says: a shorter one may fill up (INFO = 2), and
C                      has no room to note planes and spheres: see Cost
C       IW      (out)  workspace.  On return, for each INFO >= 0 but 6,
C                      IW(I) is the least number of any point that has
C                      the coordinates of point I (-0.0 equals 0.0): I,
C                      unless point I is a duplicate.  A duplicate is
C                      never a vertex
C       LRW     (in)   length of RW, at least 3*N + 12*L: 3*N + N/2 +
C                      12 always suffices
C       RW      (out)  workspace
C       INFO    (out)  0 done; 1 (TET and ADJ are full) or 2 (the pool
C                      is full): what TET and ADJ hold is right, go on
C                      with TESSRE; 3 all points are coplanar, 4 all are
C                      collinear, 5 at most one distinct point, 6
C                      coordinates that the arithmetic cannot hold (NTET
C                      = 0); or
C                      -k: -1 for N < 0, -2 for a NaN or infinity in P,
C                      -3 for a MAXTET that is negative or too large for
C                      the integers, -7 and -9 for LIW and LRW that are
C                      too small.  After -k nothing is written but NTET,
C                      INFO.
C
C     INFO is 6 when the coordinates need more limbs than HHLIM
C     (impossible with the default); when one is subnormal, and the
C     processor flushes subnormal numbers to zero (as in programs linked
C     with -Ofast); or when the processor rounds to fewer bits than a
C     double has (an x87 unit set to 24).
C
C     Cospherical points: of several valid meshes the order of the
C     points selects one (the pulling triangulation).  The vertices of a
C     tetrahedron are never coplanar; they may be almost so (slivers).
C     Cost: about linear in N for points that fill a volume or, but for
C     rounding, lie near up to eight planes and spheres.  More, for a
C     linear number of tetrahedra:
C       - on smooth surfaces and between parallel sheets somewhat more;
C         on tubes, tori and the two sides of a thin curved sheet about
C         N**1.5;
C       - near planes that cross at a tiny angle, on a slanted line,
C         between sheets 1E-6 or 1E-8 apart beyond 20,000 points, almost
C         N**2;
C       - thousands of points exactly on one sphere, as integers can be,
C         O(N**2): 8,000 take seconds;
C       - exponents hundreds apart, O(N**2): 300 points with random ones
C         take seconds, 1,000 a minute; so do 2,000 of which many have a
C         coordinate near 1D308 (-3.4D38 and the like, which mark
C         missing numbers, cost little);
C       - points near planes and spheres (faces of a turned box, globes,
C         noisy terrain) with an IW shorter than TESSWK says.
C     The method is that of Hazlewood (1995), Section 2.
      SUBROUTINE TESS(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW,
     $                INFO)
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER N, MAXTET, NTET, TET(4,*), ADJ(4,*), LIW, IW(*), LRW, INFO
      INTEGER HHFINI
      NTET = 0
      CALL TESSRE(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .EQ. -2) NTET = HHFINI(N, P) + 1
      END

C     TESSRE - go on from an unfinished mesh.
C
C     The arguments are those of TESS, but NTET, TET, ADJ are (in, out):
C     the first NTET tetrahedra that TESS or TESSRE left of the same
C     points, copied into longer arrays if need be.  What IW and RW hold
C     does not matter.  The mesh is exactly that of one call with enough
C     room.  With NTET = 0 it is TESS; on a finished mesh INFO is 0 and
C     nothing changes but IW, RW.
C
C     The tetrahedra may be any of the mesh's, in any order, as the
C     recipe TRJOIN puts them together from parts: ADJ must name both
C     neighbours of a facet between two of them, and -1 where one is
C     missing.  Each open facet that waits for its other side takes 4
C     integers of IW.
C
C     INFO is what TESS gives; -4 for a bad NTET; -5 and -6 for a fault
C     in TET and ADJ: an index out of range; a tetrahedron that has a
C     duplicate for a vertex, is not positively oriented, or has a
C     neighbour's apex inside its circumsphere; neighbours that do not
C     share a facet; a facet that is open twice.  After -k NTET, TET and
C     ADJ are unchanged.  Damage that one pass cannot find gives a wrong
C     mesh, but in bounded time and within the arrays.
      SUBROUTINE TESSRE(N, P, MAXTET, NTET, TET, ADJ, LIW, IW, LRW, RW,
     $                  INFO)
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER N, MAXTET, NTET, TET(4,*), ADJ(4,*), LIW, IW(*), LRW, INFO
      INTEGER ALL(1)
      CALL TSBADA(N, P, 0, MAXTET, NTET, TET, ADJ, LIW, LRW, INFO)
      IF (INFO .NE. 0) RETURN
      ALL(1) = 1
      CALL TSWORK(N, P, 0, ALL, MAXTET, NTET, TET, ADJ, LIW, IW, LRW,
     $            RW, INFO)
      END

C     TSWORK - TESS, TESSRE and, if MASKED = 1, TESSPA, for arguments
C     that TSBADA has passed.
      SUBROUTINE TSWORK(N, P, MASKED, MINE, MAXTET, NTET, TET, ADJ, LIW,
     $                  IW, LRW, RW, INFO)
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER N, MASKED, MINE(*), MAXTET, NTET, TET(4,*), ADJ(4,*), LIW,
     $    IW(*), LRW, INFO
      INTEGER LHEAD, INDXTR, SINGLE
      PARAMETER (LHEAD = 6, INDXTR = 5, SINGLE = 5)
      INTEGER TSLCOU, CYLS, K, LIWMIN, LRWMIN, LVS, MARKS, OK, POOL,
     $    ROOMY, WHOLE
      IF (N .EQ. 0) THEN
        NTET = 0
        INFO = SINGLE
        RETURN
      END IF
      LVS = TSLCOU(N)
      CALL TSLENG(N, LIWMIN, LRWMIN, POOL, MARKS, CYLS, OK)
      ROOMY = 0
      IF (CYLS .GT. 0 .AND. LRW - LRWMIN .GE. CYLS) ROOMY = 1
      WHOLE = 0
      IF (LIW - LIWMIN .GE. MARKS) WHOLE = 1
      K = 2*N + 2*LVS + INDXTR
      CALL TSMESH(N, RW, P, IW(N+1), MASKED, MINE, MAXTET, NTET, TET,
     $            ADJ, RW(3*N+1), IW(2*N+INDXTR+1), IW, LIW,
     $            RW(3*N+12*LVS-LHEAD+1), IW(2*N+1), IW(2*N+INDXTR),
     $            IW(K), LVS, LIW - K + 1, ROOMY, WHOLE, INFO)
      END

C     TSMESH - TSWORK with its workspace cut up into the arrays that a
C     mesher has in C.
C
C     They are declared with their lengths, so no two of them share an
C     element of RW or IW, and the standard lets them be altered.
      SUBROUTINE TSMESH(N, X, P, ORD, MASKED, MINE, MAXTET, NTET, TET,
     $                  ADJ, BOX, ALIVE, REP, LIW, HEADER, KNOWN, COUNT,
     $                  COUNTS, LVS, LEFT, ROOMY, WHOLE, INFO)
      INTEGER LCTL, LHNT, LRCTL, LSUP, NLISTS, LLSX, LFIRST, LLSD,
     $    TSLIST, LEAFPT, SURFS
      PARAMETER (LCTL = 17, LHNT = 261, LRCTL = 140, LSUP = 60,
     $    NLISTS = 7, LLSX = 4, LFIRST = -2, LLSD = 17, TSLIST = 448,
     $    LEAFPT = 48, SURFS = 8)
      INTEGER N, LVS, LEFT, ORD(N), MASKED, MINE(*), MAXTET, NTET,
     $    TET(4,*), ADJ(*), ALIVE(2*LVS-1), REP(N), LIW, KNOWN(4),
     $    COUNT, COUNTS(LEFT), ROOMY, WHOLE, INFO
      DOUBLE PRECISION X(3,N), P(3,*), BOX(6,*), HEADER(*)
      INTEGER CHSURF, HASCYL, NSURF
      PARAMETER (CHSURF = 1, HASCYL = 258, NSURF = 261)
      DOUBLE PRECISION LSD(LLSD,NLISTS), RCTL(LRCTL), SUP(LSUP,SURFS)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER CTL(LCTL), HNT(LHNT), K, LENGTH,
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), SPACE
      IF (MASKED .EQ. 1) THEN
        CALL TSOPEN(N, P, ORD, BOX, REP, CTL, RCTL, HNT, LSID, LSD,
     $              HEADER, KNOWN, COUNT, COUNTS, INFO)
      ELSE
        CALL TSSORT(N, X, P, ORD, BOX, ALIVE, REP, CTL, RCTL, HNT, LSID,
     $              LSD, ROOMY, INFO)
C       what is left in IW is no index
        IF (INFO .EQ. 0) THEN
          COUNT = 0
          KNOWN(1) = 0
        END IF
      END IF
      IF (INFO .GT. 0) NTET = 0
      IF (INFO .NE. 0) RETURN
      IF (MASKED .EQ. 1) THEN
        IF (HNT(HASCYL) .EQ. 1 .AND. ROOMY .EQ. 0) INFO = -9
        IF (COUNTS(1) .GT. 0 .AND. WHOLE .EQ. 0) INFO = -7
        IF (INFO .NE. 0) RETURN
        IF (CHSURF .EQ. 1) CALL TSSOFI(X, CTL, HNT, SUP, COUNTS)
      END IF
      CALL TSALLO(N, RCTL, HNT, LIW, SPACE, LENGTH)
C     without marks MARK is COUNTS, which is left alone
      K = SPACE + 2
      CALL TSBLD(N, X, P, ORD, MASKED, MINE, MAXTET, NTET, TET, ADJ,
     $           BOX, ALIVE, REP, COUNTS(K), COUNTS(K+N), COUNTS(K+2*N),
     $           COUNTS(MIN(K,3)-1), CTL, RCTL, HNT, SUP, LSX, LSID,
     $           LSD, LENGTH, MAX(SPACE, 1), INFO)
      IF (MASKED .EQ. 1) COUNTS(1) = HNT(NSURF)
      END

C     ==================================================================
C     PART II: FASTER SEARCHES
C
C     No result depends on what follows, down to part III.  Each chapter
C     opens with the data that it is for, and what they cost without it;
C     its idea, its words, its hooks, its state and what always holds of
C     it; then its places and constants.
C
C     A hook may always do nothing, and does where its chapter is left
C     out: searches take longer then, and find the same.  It changes
C     what its chapter keeps, and of a search only what is said here.
C     What it excludes must hold no better point; what it offers goes
C     through TSOFFP.  A stage offers points, or sets the best point to
C     the apex; its OK is 1 only if all that pass the filter have been
C     offered, if there is no candidate, or if the best point is the
C     apex; 0: the search goes on.
C       TSMKLS  before the star of S: makes its lists, and drops the
C               sets of the last star
C       TSLEAV  the star of S is complete: S leaves the lists
C       TSSRSL, TSSRBL, TSSRNL, TSONHP  stages
C       TSCOLF  adds the points of a leaf that pass the filter to the
C               list that a search makes
C       TSREFI  after a search of the tree
C       TSNOTE, TSSEEK  after a search that no list has ended
C       TSAPFS  Z is the apex of the facet V, or 0: it is not known
C       TSRECS  of a list that holds the ball, for lists: OK is 1 if its
C               ties are recorded
C       TSMCYS, TSCLUM  once the tree is built
C       TSPFOU  pushes those of a node's four grandchildren that it does
C               not exclude
C       TSCHCA  once the ball has changed: the cap, if any
C       TSSKPL  after a search that no list has ended; may choose
C               another cap
C       TSXCLU  1 if the box is excluded
C       TSDLIM  decides what it can of what is UNSURE, SIDE or VERDIC;
C               OUT is 1: Z is not better
C       TSNOTC  tells how a comparison ended
C       TSREFB  may find a better ball: the filter, QBYLIM, QLO and QHI
C       TSCHOS  once a search has its set-up: the facet's surface; a
C               sphere gives FCEN, FDC and FRHO another centre
C       TSSHAR  narrows LO, HI, the limits of Z, by its height
C       TSSFFI  once the ball has changed
C       TSXMRK  1 if a node is excluded, 0 if it is not, UNSURE: ask its
C               box
C       TSBONS  1 if the ball is the facet's sphere up to rounding
C       TSADDS  tells of an undecided point Z, or of the first of a leaf
C       TSRMRK  the length of the marks
C       TSSTAG, TSDROP  what the chapters begin with, and what would be
C               wrong once completed points are uncompleted again
C     ==================================================================

C     ------------------------------------------------------------------
C     Candidate lists: where to look first
C
C     FOR all data: without star lists lattices take 2.05 times the
C     instructions, clouds 1.4; without block lists clouds 1.15, as star
C     lists are made from them.
C
C     IDEA.  The points near S are few, and most balls of its star lie
C     among them.  They are copied into a list of their own, in single
C     precision, which a loop without a branch tests by fours.  Where
C     the list is known to hold all points of the ball, one pass over it
C     ends the search.
C
C       candidate list    uncompleted points in single precision, tested
C                         by fours
C       block list        those about a leaf, which is then called a
C                         block
C       star list         those of the block list that are near S
C
C             +---------------------+ block list BLK: the points of the
C             |     +-------+       | leaf of S, then all others in its
C             |     | leaf  |(star) | box, which is wider than the
C             |     |     ( S )     | leaf's by LREACH; star list STR:
C             |     +-------+       | those of BLK in a ball about S;
C             +---------------------+ near lists have balls of their
C                                     own, anywhere
C
C     HOOKS: TSMKLS, TSLEAV; the stages TSSRSL and TSSRBL.
C     STATE: in HNT, LSX, LSID, LSD.
C     INVARIANTS.  A block list with LSID(LN,BLK) > 0 has all
C     uncompleted points of its box; a star list those within reach of
C     its vertex; points that have left are at LEFTLI.  Coordinates err
C     by FEPS of the list's units, and what is tested in them has room
C     for that.
C
C     In HNT:
C       BLMISS = 1   lists.block_misses  how many searches in a row have
C               ended in the tree, of this block
C       BLTIES = 2   lists.block_ties  how many searches that ended in a
C               block list met ties, with none in between that ended in
C               a star list
C       STTIED = 3   lists.star_tied  1: the last search of a star list
C               that offered points met some exactly on its last ball
C     Candidate lists: uncompleted points in single precision.  A block
C     list has those in a box, a star list those near its vertex, a near
C     list those in a ball.  A star list's coordinates are offsets from
C     its vertex in units of LREACH; the others' are offsets from the
C     centre of their box, or of their ball's box, in units of its half
C     width.
C       NLISTS = 7   -  how many lists there are, NEARLS + 2
C       BLK    = 1   lists.block  the block list of the current leaf
C       STR    = 2   lists.star  the star list;
C       STR    array nears.list  behind it the near lists
C     LSX(TSLIST,LLSX,NLISTS), of each point; powers while a near list
C     is made:
C       LLSX   = 4   -
C       LX     = 1   x  the first coordinate
C       LY     = 2   y  the second
C       LZ     = 3   z  the third
C       LNORM2 = 4   norm2  the sum of their squares
C     LSID(LFIRST:TSLIST+LEAFPT,NLISTS), integers of each list:
C       LFIRST = -2  leaf_first  of a block list: the first position of
C               its leaf
C       LLAST  = -1  leaf_end  of a block list: the last one (in C one
C               more)
C       LN     = 0   n  the number of points; 0: there is no list
C       LSID   array position  behind LSID(LN,.): the points' positions
C     LSD(LLSD,NLISTS), its doubles:
C       LLSD   = 17  -
C       LLO    = 0   lo  behind it the least corner of the box, as far
C               as it is in the root's
C       LHI    = 3   hi  behind it the greatest
C       LORIGI = 6   origin  behind it the point that coordinates are
C               offsets from
C       LMAXAB = 9   max_abs  behind it bounds on the coordinates, but
C               for rounding
C       LREACH = 13  reach  so far from the leaf's box, from the vertex
C               or from LCENTR the list has all uncompleted points
C       LSCALE = 14  scale  the factor that gives coordinates their
C               units
C       LCENTR = 14  centre  behind it, of a near list, the centre of
C               its ball
C     Constants:
C       TSLIST = 448 TESS_LIST  capacity of a candidate list, a multiple
C               of 4, at least LEAFPT; beyond it is room for one leaf
C               more.  Trades searches that end in lists against the
C               stack
C       BLKREA = 2.6D0 BLOCK_REACH  how far a block list extends beyond
C               the leaf's box, in mean spacings of the leaf's points,
C       STRREA = 0.85D0 STAR_REACH  and a star list from its vertex, in
C               those reaches.  They trade the lists' lengths against
C               the searches that end in them.  For uniform points the
C               lists hold about 240 and 20 points; 80 to 88 % of the
C               searches end in the star list, most others in the block
C               list.  Without star lists searches take a quarter
C               longer
C       MAXMIS = 8   MAX_BLOCK_MISSES  a block makes no more star lists
C               once so many searches in a row have ended in the tree:
C               near surfaces they would cost 3 to 10 %
C       TIESEA = 8   TIED_SEARCHES  once more than so many searches in a
C               row have met ties in the block list,
C       TIEWID = 1.2D0 TIED_WIDENING  lists are wider by this.  The star
C               lists then hold the balls of a lattice with 27 points a
C               leaf: 24**3 points take 0.4 times as long
C     Constants that correctness rests on:
C       BOXMIN = 1.0D5*2.0D0**(-450) LIST_BOX_MIN  a box narrower than
C               this has no list.  So a list's coordinates are right to
C               far less than FEPS, and a star list's reach is above
C               LENMIN: no product in TSBINS underflows
C       STRMIN = 1.0D-4 STAR_REACH_MIN  a star whose reach is less, in
C               units of its block list, has no list: the block list
C               cannot tell such points apart
C       DSTERR = 32.0*2.0**(-23) LIST_DIST_ERR  bound on the error of a
C               distance in units of the block list: 2 FEPS for each of
C               two coordinates of at most 2, times sqrt(3), below 7;
C               and 5 roundings of a distance below 3.5, of the
C               difference, the square, the sum and the bound: below 25
C               FEPS.  What is computed to be within reach + DSTERR is
C               within 1.1 reach: DSTERR is 0.04 STRMIN
C       LEFTLI = 1.0E10 LEFT_LIST  where a list puts points that have
C               left it.  None of them passes a filter: norm2 is at
C               least LEFTLI**2 = 1E20, and TSLFIL's limits leave |D.x|
C               < 2E19, D(4) < 1E18
C       SHIFT  = 5.0D0  LIST_SHIFT  added to a coordinate of a list and
C               taken away again, it leaves a multiple of 2**(-51), of
C               2**(-62) in 80 bits, so that neither squares and
C               products in single precision nor their differences
C               underflow
C     ------------------------------------------------------------------

C     TSDISJ (boxes_disjoint) - returns 1 if the boxes of a list and of
C     a node have no point in common.
      INTEGER FUNCTION TSDISJ(BOX, LSD, LIST, NODE)
      INTEGER NLISTS, LLSD
      PARAMETER (NLISTS = 7, LLSD = 17)
      DOUBLE PRECISION BOX(6,*), LSD(LLSD,NLISTS)
      INTEGER LIST, NODE
      INTEGER LLO, LHI
      PARAMETER (LLO = 0, LHI = 3)
      INTEGER K
      TSDISJ = 1
      DO 10 K = 1, 3
        IF (LSD(LHI+K,LIST) .LT. BOX(K,NODE) .OR.
     $      BOX(3+K,NODE) .LT. LSD(LLO+K,LIST)) RETURN
   10 CONTINUE
      TSDISJ = 0
      END

C     TSPDIS - returns 1 if position I is outside the box of a list.
      INTEGER FUNCTION TSPDIS(X, LSD, LIST, I)
      INTEGER NLISTS, LLSD
      PARAMETER (NLISTS = 7, LLSD = 17)
      DOUBLE PRECISION X(3,*), LSD(LLSD,NLISTS)
      INTEGER LIST, I
C     six conditions, not one, spare a branch for each
      INTEGER LLO, LHI
      PARAMETER (LLO = 0, LHI = 3)
      TSPDIS = 0
      IF (LSD(LHI+1,LIST) .LT. X(1,I)) TSPDIS = 1
      IF (LSD(LHI+2,LIST) .LT. X(2,I)) TSPDIS = 1
      IF (LSD(LHI+3,LIST) .LT. X(3,I)) TSPDIS = 1
      IF (X(1,I) .LT. LSD(LLO+1,LIST)) TSPDIS = 1
      IF (X(2,I) .LT. LSD(LLO+2,LIST)) TSPDIS = 1
      IF (X(3,I) .LT. LSD(LLO+3,LIST)) TSPDIS = 1
      END

C     TSSNGL (to_single) - returns X in single precision, rounded to a
C     multiple of 2**(-51) before: see SHIFT.
      REAL FUNCTION TSSNGL(X)
      DOUBLE PRECISION X
      DOUBLE PRECISION SHIFT
      PARAMETER (SHIFT = 5.0D0)
      TSSNGL = REAL((X + SHIFT) - SHIFT)
      END

C     TSFILL (fill_list) - sets the coordinates of a list from its
C     positions.  Points whose stars are complete are put at LEFTLI, and
C     so is what pads the list to a multiple of four: loops over lists
C     go by fours, which every compiler can vectorize.
      SUBROUTINE TSFILL(X, LINK, LSX, LSID, LSD, LIST)
      INTEGER NLISTS, LLSX, LFIRST, LLSD, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LLSX = 4, LFIRST = -2, LLSD = 17,
     $    TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), LSD(LLSD,NLISTS)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER LINK(*), LSID(LFIRST:TSLIST+LEAFPT,NLISTS), LIST
      INTEGER LX, LY, LZ, LNORM2, LN, LORIGI, LSCALE, COMPLE
      REAL LEFTLI
      PARAMETER (LX = 1, LY = 2, LZ = 3, LNORM2 = 4, LN = 0, LORIGI = 6,
     $    LSCALE = 14, COMPLE = -1, LEFTLI = 1.0E10)
      REAL TSSNGL
      INTEGER I, K, Z
      DO 20 I = 1, (LSID(LN,LIST) + 3)/4*4
        LSX(I,LX,LIST) = LEFTLI
        LSX(I,LY,LIST) = LEFTLI
        LSX(I,LZ,LIST) = LEFTLI
        LSX(I,LNORM2,LIST) = LEFTLI*LEFTLI
        IF (I .GT. LSID(LN,LIST)) GO TO 20
        Z = LSID(I,LIST)
        IF (LINK(Z) .EQ. COMPLE) GO TO 20
        DO 10 K = 1, 3
          LSX(I,LX-1+K,LIST) = TSSNGL((X(K,Z) - LSD(LORIGI+K,LIST))*
     $        LSD(LSCALE,LIST))
   10   CONTINUE
        LSX(I,LNORM2,LIST) = LSX(I,LX,LIST)**2 + LSX(I,LY,LIST)**2 +
     $      LSX(I,LZ,LIST)**2
   20 CONTINUE
      END

C     TSCINB (collect_in_box) - appends to a list the uncompleted points
C     in its box that are not in leaf OWN.  FIT is 1, or 0 if they do
C     not fit.
      SUBROUTINE TSCINB(X, BOX, ALIVE, LINK, CTL, LSID, LSD, LIST, OWN,
     $                  FIT)
      INTEGER NLISTS, LFIRST, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), BOX(6,*), LSD(*)
      INTEGER ALIVE(*), LINK(*), CTL(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), LIST, OWN, FIT
      INTEGER LEAVES, LN, COMPLE
      PARAMETER (LEAVES = 4, LN = 0, COMPLE = -1)
      INTEGER TSDISJ, TSNEXT, TSPDIS, FIRST, I, LAST, N, NODE, OUT
      FIT = 1
      NODE = 1
   10 IF (NODE .EQ. 0) RETURN
      OUT = 1
      IF (ALIVE(NODE) .GT. 0 .AND. NODE .NE. CTL(LEAVES) + OWN - 1)
     $    OUT = TSDISJ(BOX, LSD, LIST, NODE)
      IF (OUT .EQ. 0) THEN
        IF (NODE .LT. CTL(LEAVES)) THEN
          NODE = 2*NODE
          GO TO 10
        END IF
        CALL TSNRNG(CTL, NODE, FIRST, LAST)
        N = LSID(LN,LIST)
        DO 20 I = FIRST, LAST
          LSID(N+1,LIST) = I
          OUT = TSPDIS(X, LSD, LIST, I)
          IF (LINK(I) .EQ. COMPLE) OUT = 1
          N = N + 1 - OUT
   20   CONTINUE
        LSID(LN,LIST) = N
        IF (N .GT. TSLIST) FIT = 0
        IF (FIT .EQ. 0) RETURN
      END IF
      NODE = TSNEXT(NODE)
      GO TO 10
      END

C     TSLBOX (set_list_box) - sets the box of a list, LO, HI and its
C     reach about it, as far as it is in the root's, and its units.
C     HALF is the box's half width.
      SUBROUTINE TSLBOX(BOX, LSD, LIST, LO, HI, HALF)
      INTEGER NLISTS, LLSD
      PARAMETER (NLISTS = 7, LLSD = 17)
      DOUBLE PRECISION BOX(6,*), LSD(LLSD,NLISTS), LO(3), HI(3), HALF
      INTEGER LIST
      INTEGER LLO, LHI, LORIGI, LMAXAB, LREACH, LSCALE
      DOUBLE PRECISION BOXMIN
      PARAMETER (LLO = 0, LHI = 3, LORIGI = 6, LMAXAB = 9, LREACH = 13,
     $    LSCALE = 14, BOXMIN = 1.0D5*2.0D0**(-450))
      INTEGER K
      HALF = 0.0D0
      DO 10 K = 1, 3
        LSD(LLO+K,LIST) = MAX(LO(K) - LSD(LREACH,LIST), BOX(K,1))
        LSD(LHI+K,LIST) = MIN(HI(K) + LSD(LREACH,LIST), BOX(3+K,1))
        LSD(LORIGI+K,LIST) = 0.5D0*(LSD(LLO+K,LIST) + LSD(LHI+K,LIST))
        LSD(LMAXAB+K,LIST) = 0.5D0*(LSD(LHI+K,LIST) - LSD(LLO+K,LIST))
        HALF = MAX(HALF, LSD(LMAXAB+K,LIST))
   10 CONTINUE
      LSD(LSCALE,LIST) = 0.0D0
      IF (HALF .GT. BOXMIN) LSD(LSCALE,LIST) = 1.0D0/HALF
      DO 20 K = 1, 3
        LSD(LMAXAB+K,LIST) = LSD(LMAXAB+K,LIST)*LSD(LSCALE,LIST)
   20 CONTINUE
      END

C     TSMKBL (make_block_list) - makes the block list of the leaf of S:
C     its points, in order, then the uncompleted ones around it.  The
C     reach shrinks until they fit.
      SUBROUTINE TSMKBL(X, BOX, ALIVE, LINK, CTL, HNT, LSX, LSID, LSD,
     $                  S)
      INTEGER NLISTS, LFIRST, LLSD, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, TSLIST = 448,
     $    LEAFPT = 48)
      DOUBLE PRECISION X(3,*), BOX(6,*), LSD(LLSD,NLISTS)
      REAL LSX(*)
      INTEGER ALIVE(*), LINK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), S
      INTEGER NP, LEAVES, BLMISS, BLTIES, BLK, LLAST, LN, LREACH,
     $    LSCALE, TIESEA
      DOUBLE PRECISION BLKREA, TIEWID
      PARAMETER (NP = 1, LEAVES = 4, BLMISS = 1, BLTIES = 2, BLK = 1,
     $    LLAST = -1, LN = 0, LREACH = 13, LSCALE = 14, BLKREA = 2.6D0,
     $    TIESEA = 8, TIEWID = 1.2D0)
      DOUBLE PRECISION HALF, MARGIN, SUM
      INTEGER TSLEAF, TSLFST, FIT, I, K, LEAFS, NODE
      LEAFS = TSLEAF(CTL, S)
      NODE = CTL(LEAVES) + LEAFS - 1
      SUM = 0.0D0
      DO 10 K = 1, 3
        SUM = SUM + (BOX(3+K,NODE) - BOX(K,NODE))**2
   10 CONTINUE
C     the mean spacing of the leaf's points in diagonals of its box, one
C     over the cube root of their number (24 to 48 in large sets), by a
C     step of Newton's method
      MARGIN = BLKREA/SQRT(3.0D0)*3.0D0/(2.0D0*3.2D0 + DBLE(CTL(NP))/
     $    DBLE(CTL(LEAVES))/(3.2D0*3.2D0))*SQRT(SUM)
      IF (HNT(BLTIES) .GT. TIESEA) MARGIN = TIEWID*MARGIN
      LSID(LFIRST,BLK) = TSLFST(CTL, LEAFS)
      LSID(LLAST,BLK) = TSLFST(CTL, LEAFS + 1) - 1
      HNT(BLMISS) = 0
   20 LSD(LREACH,BLK) = MARGIN
      CALL TSLBOX(BOX, LSD, BLK, BOX(1,NODE), BOX(4,NODE), HALF)
      LSID(LN,BLK) = 0
      DO 30 I = LSID(LFIRST,BLK), LSID(LLAST,BLK)
        LSID(LN,BLK) = LSID(LN,BLK) + 1
        LSID(LSID(LN,BLK),BLK) = I
   30 CONTINUE
      CALL TSCINB(X, BOX, ALIVE, LINK, CTL, LSID, LSD, BLK, LEAFS, FIT)
      IF (LSD(LSCALE,BLK) .LE. 0.0D0 .OR. (FIT .EQ. 0 .AND.
     $    MARGIN .LE. 0.0D0)) THEN
C       there is no list
        LSID(LN,BLK) = 0
        RETURN
      END IF
      IF (FIT .EQ. 0) THEN
        IF (MARGIN .GT. 1.0D-3*HALF) THEN
          MARGIN = 0.7D0*MARGIN
        ELSE
          MARGIN = 0.0D0
        END IF
        GO TO 20
      END IF
      CALL TSFILL(X, LINK, LSX, LSID, LSD, BLK)
      END

C     TSPICK (pick_indices) - stores in PICKED the indices I <= N with
C     IN(I) = 1 (the others are 0), and their number in MANY; without a
C     branch, which no processor could predict.
      SUBROUTINE TSPICK(IN, N, PICKED, MANY)
      INTEGER IN(*), N, PICKED(*), MANY
      INTEGER I
      MANY = 0
      DO 10 I = 1, N, 4
        PICKED(MANY+1) = I
        MANY = MANY + IN(I)
        PICKED(MANY+1) = I + 1
        MANY = MANY + IN(I+1)
        PICKED(MANY+1) = I + 2
        MANY = MANY + IN(I+2)
        PICKED(MANY+1) = I + 3
        MANY = MANY + IN(I+3)
   10 CONTINUE
      END

C     TSMKLS (make_lists) - makes the lists for the star of S: the block
C     list of its leaf and, from it, the star list: the points nearer to
C     S than its reach, which is at most the distance from S to where
C     the block list may lack points.  The sets of the star before are
C     gone.
      SUBROUTINE TSMKLS(X, BOX, ALIVE, LINK, CTL, HNT, LSX, LSID, LSD,
     $                  S)
      INTEGER NLISTS, LLSX, LFIRST, LLSD, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LLSX = 4, LFIRST = -2, LLSD = 17,
     $    TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), BOX(6,*), LSD(LLSD,NLISTS)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER ALIVE(*), LINK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), S
      INTEGER NSETS, BLMISS, BLK, STR, LX, LY, LZ, LLAST, LN, LLO, LHI,
     $    LORIGI, LMAXAB, LREACH, LSCALE, MAXMIS
      DOUBLE PRECISION STRREA, STRMIN
      REAL DSTERR
      PARAMETER (NSETS = 205, BLMISS = 1, BLK = 1, STR = 2, LX = 1,
     $    LY = 2, LZ = 3, LLAST = -1, LN = 0, LLO = 0, LHI = 3,
     $    LORIGI = 6, LMAXAB = 9, LREACH = 13, LSCALE = 14,
     $    STRREA = 0.85D0, MAXMIS = 8, STRMIN = 1.0D-4,
     $    DSTERR = 32.0*2.0**(-23))
      DOUBLE PRECISION MARGIN
      REAL A, B, C, MOST
      INTEGER I, IN(TSLIST), K, PLACE(TSLIST+1)
      HNT(NSETS) = 0
      IF (S .LT. LSID(LFIRST,BLK) .OR. S .GT. LSID(LLAST,BLK))
     $    CALL TSMKBL(X, BOX, ALIVE, LINK, CTL, HNT, LSX, LSID, LSD, S)
      LSID(LN,STR) = 0
      MARGIN = STRREA*LSD(LREACH,BLK)
      DO 10 K = 1, 3
        IF (LSD(LLO+K,BLK) .GT. BOX(K,1)) MARGIN = MIN(MARGIN, X(K,S) -
     $      LSD(LLO+K,BLK))
        IF (LSD(LHI+K,BLK) .LT. BOX(3+K,1)) MARGIN = MIN(MARGIN,
     $      LSD(LHI+K,BLK) - X(K,S))
        LSD(LORIGI+K,STR) = X(K,S)
        LSD(LMAXAB+K,STR) = 1.1D0
   10 CONTINUE
      IF (LSID(LN,BLK) .EQ. 0 .OR. HNT(BLMISS) .GE. MAXMIS) RETURN
      IF (MARGIN*LSD(LSCALE,BLK) .LT. STRMIN) RETURN
      LSD(LREACH,STR) = MARGIN
      LSD(LSCALE,STR) = 1.0D0/MARGIN
      I = S - LSID(LFIRST,BLK) + 1
      A = LSX(I,LX,BLK)
      B = LSX(I,LY,BLK)
      C = LSX(I,LZ,BLK)
C     no point nearer than the reach is missed
      MOST = REAL(MARGIN*LSD(LSCALE,BLK)) + DSTERR
      MOST = MOST*MOST
      DO 20 I = 1, (LSID(LN,BLK) + 3)/4*4
        IN(I) = 0
        IF ((LSX(I,LX,BLK) - A)*(LSX(I,LX,BLK) - A) +
     $      (LSX(I,LY,BLK) - B)*(LSX(I,LY,BLK) - B) +
     $      (LSX(I,LZ,BLK) - C)*(LSX(I,LZ,BLK) - C) .LE. MOST) IN(I) = 1
   20 CONTINUE
      CALL TSPICK(IN, LSID(LN,BLK), PLACE, LSID(LN,STR))
      DO 30 I = 1, LSID(LN,STR)
        LSID(I,STR) = LSID(PLACE(I),BLK)
   30 CONTINUE
      CALL TSFILL(X, LINK, LSX, LSID, LSD, STR)
      END

C     TSLEAV (leave_lists) - takes S, whose star is complete, out of the
C     block list.  (TSOFFL skips it in the other lists.)
      SUBROUTINE TSLEAV(LSX, LSID, S)
      INTEGER NLISTS, LLSX, LFIRST, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LLSX = 4, LFIRST = -2, TSLIST = 448,
     $    LEAFPT = 48)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER LSID(LFIRST:TSLIST+LEAFPT,NLISTS), S
      INTEGER BLK, LX, LY, LZ, LNORM2, LLAST, LN
      REAL LEFTLI
      PARAMETER (BLK = 1, LX = 1, LY = 2, LZ = 3, LNORM2 = 4,
     $    LLAST = -1, LN = 0, LEFTLI = 1.0E10)
      INTEGER I
      IF (S .LT. LSID(LFIRST,BLK) .OR. S .GT. LSID(LLAST,BLK) .OR.
     $    LSID(LN,BLK) .EQ. 0) RETURN
      I = S - LSID(LFIRST,BLK) + 1
      LSX(I,LX,BLK) = LEFTLI
      LSX(I,LY,BLK) = LEFTLI
      LSX(I,LZ,BLK) = LEFTLI
      LSX(I,LNORM2,BLK) = LEFTLI*LEFTLI
      END

C     TSBINB (ball_in_block) - returns 1 if the part of the ball that
C     may hold points, the part in the root's box, lies inside the box
C     of a list.  The centre of the true ball is within dc of C, and
C     both balls pass through the base.  So the radius is at most |C| +
C     dc, and along an axis the ball ends within |C| + 2 dc of C.
      INTEGER FUNCTION TSBINB(BOX, LSD, IQ, FQ, LIST)
      INTEGER NLISTS, LLSD, LFQ
      PARAMETER (NLISTS = 7, LLSD = 17, LFQ = 183)
      DOUBLE PRECISION BOX(6,*), LSD(LLSD,NLISTS), FQ(LFQ)
      INTEGER IQ(*), LIST
      INTEGER LLO, LHI, VC, VDC, FBASE, QHH, QFILT
      DOUBLE PRECISION ROUNDG
      PARAMETER (LLO = 0, LHI = 3, VC = 0, VDC = 4, FBASE = 6, QHH = 0,
     $    QFILT = 14, ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION PART(6,1), R
      INTEGER TSXBOX, I, K, OUT
      TSBINB = 0
      R = SQRT(FQ(QFILT+VC+1)*FQ(QFILT+VC+1) +
     $    FQ(QFILT+VC+2)*FQ(QFILT+VC+2) + FQ(QFILT+VC+3)*FQ(QFILT+VC+3))
      R = R*(1.0D0 + ROUNDG) + 2.0D0*FQ(QFILT+VDC)
      DO 10 I = 1, 6
        PART(I,1) = BOX(I,1)
   10 CONTINUE
      DO 20 I = 1, 6
        K = MOD(I - 1, 3) + 1
        OUT = 0
        IF (I .LE. 3) THEN
          IF (FQ(QFILT+VC+K) - R .LT. LSD(LLO+K,LIST) - FQ(QHH+FBASE+K))
     $        OUT = 3 + K
        ELSE
          IF (FQ(QFILT+VC+K) + R .GT. LSD(LHI+K,LIST) - FQ(QHH+FBASE+K))
     $        OUT = K
        END IF
        IF (OUT .EQ. 0) GO TO 20
C       the part of the root's box beyond this side of the list's
        PART(OUT,1) = LSD(LLO+I,LIST)
        IF (PART(K,1) .LT. PART(3+K,1)) THEN
          IF (TSXBOX(PART, IQ, FQ, QFILT, 1, 0.0D0) .EQ. 0) RETURN
        END IF
        PART(OUT,1) = BOX(OUT,1)
   20 CONTINUE
      TSBINB = 1
      END

C     TSBINS (ball_in_star_list) - returns 1 if that part lies within
C     the reach of the star list about the base.  For a point u of the
C     true ball, seen from the base,
C         |u|**2 <= 2 (C.u + dc |u|) <= 2 (a + dc) |u| + 2 b,
C     where a is the length of C without its coordinate K, and b >= 0 is
C     the greatest value of C(K) u(K) in the root's box.  So |u| is less
C     than reach if reach (reach - 2 a - 2 dc) >= 2 b.  The test puts
C     reach - 2 dc for the first factor, too.  ROUNDG times reach
C     exceeds the roundings of a, b and the products.
      INTEGER FUNCTION TSBINS(BOX, LSD, FQ)
      INTEGER NLISTS, LLSD, LFQ
      PARAMETER (NLISTS = 7, LLSD = 17, LFQ = 183)
      DOUBLE PRECISION BOX(6,*), LSD(LLSD,NLISTS), FQ(LFQ)
      INTEGER STR, LREACH, VC, VDC, FBASE, QHH, QFILT
      DOUBLE PRECISION ROUNDG
      PARAMETER (STR = 2, LREACH = 13, VC = 0, VDC = 4, FBASE = 6,
     $    QHH = 0, QFILT = 14, ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION A, B, MARGIN, SQUARE(3)
      INTEGER K
      TSBINS = 0
      MARGIN = LSD(LREACH,STR)*(1.0D0 - ROUNDG) - 2.0D0*FQ(QFILT+VDC)
      DO 10 K = 1, 3
        SQUARE(K) = FQ(QFILT+VC+K)*FQ(QFILT+VC+K)
   10 CONTINUE
      IF (MARGIN .LE. 0.0D0) RETURN
      TSBINS = 1
      IF (4.0D0*(SQUARE(1) + SQUARE(2) + SQUARE(3)) .LE. MARGIN*MARGIN)
     $    RETURN
      DO 20 K = 1, 3
        B = MAX((BOX(3+K,1) - FQ(QHH+FBASE+K))*FQ(QFILT+VC+K), (BOX(K,1)
     $      - FQ(QHH+FBASE+K))*FQ(QFILT+VC+K))
        A = SQRT(SQUARE(MOD(K, 3)+1) + SQUARE(MOD(K+1, 3)+1))
        IF (MARGIN*(MARGIN - 2.0D0*A) .GE. 2.0D0*B) RETURN
   20 CONTINUE
      TSBINS = 0
      END

C     TSLFIL (list_filter) - computes the filter of a search for a
C     list's points, in the list's units: a point of the list can be in
C     the ball only if
C         norm2 - (D(1) x + D(2) y + D(3) z) < D(4).
C     With g = base - origin, the power of u is
C         |u-g|**2 - 2 c.(u-g) = |u|**2 - 2 (c+g).u + (g+2c).g.
C     D(4) has room for dc, and for all rounding:
C       single precision, where |u(K)| <= LSD(LMAXAB+K) (1.1 for a star
C         list, whose g is 0, else at most 1; but twice as much for
C         boxes a few last places wide, whose origin is rounded by as
C         much): |u|**2 <= 12 by at most 8 roundings, two of them of u
C         itself and the last that of the difference; D.u by at most 6
C         of each term; D(4) itself;
C       double precision, with a the sum of |g| + |2c|: 8 roundings of
C         the products with g, of |g| a; in D 2 of |2c| and 3 of |2g|;
C         SHIFT, of u at most 2**(-50) = 4 EPS, times |D|; of D far
C         below FEPS: less than 16 (1 + |g|) a (list_filter.g of the
C         bounds).
C     OK is 1, or 0 when the ball is too large for single precision: the
C     limits keep sums from overflow, and points at LEFTLI outside.
      SUBROUTINE TSLFIL(LSD, FQ, LIST, D, OK)
      INTEGER NLISTS, LLSD, LFQ
      PARAMETER (NLISTS = 7, LLSD = 17, LFQ = 183)
      DOUBLE PRECISION LSD(LLSD,NLISTS), FQ(LFQ)
      REAL D(4)
      INTEGER LIST, OK
      INTEGER LORIGI, LMAXAB, LSCALE, VC, VDC, FBASE, QHH, QFILT
      DOUBLE PRECISION EPS, FEPS
      PARAMETER (LORIGI = 6, LMAXAB = 9, LSCALE = 14, VC = 0, VDC = 4,
     $    FBASE = 6, QHH = 0, QFILT = 14, EPS = 2.0D0**(-52),
     $    FEPS = 2.0D0**(-23))
      DOUBLE PRECISION A, CU(3), DIST, G, REST, SUM
      REAL TSSNGL
      INTEGER K
      A = 0.0D0
      REST = 0.0D0
      SUM = 0.0D0
      DIST = 0.0D0
      DO 10 K = 1, 3
        G = (FQ(QHH+FBASE+K) - LSD(LORIGI+K,LIST))*LSD(LSCALE,LIST)
        CU(K) = 2.0D0*FQ(QFILT+VC+K)*LSD(LSCALE,LIST)
        REST = REST + G*(G + CU(K))
        DIST = DIST + ABS(G)
        A = A + ABS(G) + ABS(CU(K))
        CU(K) = CU(K) + 2.0D0*G
        SUM = SUM + ABS(CU(K))*LSD(LMAXAB+K,LIST)
   10 CONTINUE
      OK = 0
      IF (SUM .GT. 1.0D6 .OR. A +
     $    2.0D0*FQ(QFILT+VDC)*LSD(LSCALE,LIST) .GT. 5.0D8) RETURN
      D(1) = TSSNGL(CU(1))
      D(2) = TSSNGL(CU(2))
      D(3) = TSSNGL(CU(3))
      D(4) = REAL(FEPS*(128.0D0 + 16.0D0*SUM + 4.0D0*ABS(REST)) +
     $    16.0D0*EPS*(1.0D0 + DIST)*A +
     $    2.0D0*FQ(QFILT+VDC)*LSD(LSCALE,LIST)*(4.0D0 + DIST) - REST)
      OK = 1
      END

C     TSLHIT (list_hits) - finds the places of the points of a list that
C     pass TSLFIL's test.  MANY is their number; 0 if there are at most
C     four, the vertices of the facet and the best point, which are on
C     the ball; -1 if the ball is too large for the list.
C
C     All four pass a test of a list that holds the ball: the ball
C     passes through them, the facet is open and the best point is
C     uncompleted, so none is complete.  Of a list that does not hold
C     the ball some may be missing, and 0 may be wrong, but the search
C     goes on.  In TSINCT vertices may be complete: it drops all lists.
      SUBROUTINE TSLHIT(LSX, LSID, LSD, FQ, LIST, PLACE, MANY)
      INTEGER NLISTS, LLSX, LFIRST, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LLSX = 4, LFIRST = -2, TSLIST = 448,
     $    LEAFPT = 48)
      DOUBLE PRECISION LSD(*), FQ(*)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER LSID(LFIRST:TSLIST+LEAFPT,NLISTS), LIST, PLACE(*), MANY
      INTEGER LX, LY, LZ, LNORM2, LN
      PARAMETER (LX = 1, LY = 2, LZ = 3, LNORM2 = 4, LN = 0)
      REAL D(4)
      INTEGER I, IN(TSLIST), OK
      MANY = -1
      CALL TSLFIL(LSD, FQ, LIST, D, OK)
      IF (OK .EQ. 0) RETURN
      MANY = 0
      DO 10 I = 1, (LSID(LN,LIST) + 3)/4*4
        IN(I) = 0
        IF (LSX(I,LNORM2,LIST) - (D(1)*LSX(I,LX,LIST) + D(2)*
     $      LSX(I,LY,LIST) + D(3)*LSX(I,LZ,LIST)) .LT. D(4)) IN(I) = 1
        MANY = MANY + IN(I)
   10 CONTINUE
      IF (MANY .LE. 4) THEN
        MANY = 0
      ELSE
        CALL TSPICK(IN, LSID(LN,LIST), PLACE, MANY)
      END IF
      END

C     TSOFFL (offer_list) - offers the points of a list that may be in
C     the ball.  MANY is what TSLHIT gives.
      SUBROUTINE TSOFFL(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, LSX,
     $                  LSID, LSD, IQ, FQ, LIST, MANY)
      INTEGER NLISTS, LFIRST, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(*), LSD(*), FQ(*)
      REAL LSX(*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), IQ(*), LIST, MANY
      INTEGER COMPLE
      PARAMETER (COMPLE = -1)
      INTEGER I, PLACE(TSLIST+1), Z
      CALL TSLHIT(LSX, LSID, LSD, FQ, LIST, PLACE, MANY)
      DO 10 I = 1, MANY
        Z = LSID(PLACE(I),LIST)
        IF (LINK(Z) .NE. COMPLE) CALL TSOFFP(X, P, ORD, MARK, CTL, RCTL,
     $      HNT, SUP, IQ, FQ, Z)
   10 CONTINUE
      END

C     TSSRSL (search_star_list) - seeks the apex in the star list.  On
C     the open side, and no other counts, the ball of a better point is
C     part of the ball before it (Lemma 3); so one pass over the list is
C     enough if the last ball lies within its reach.  OK is 1 if it
C     does, or 0.  Without a ball every point would pass; on the faces
C     of a cube each would need an exact side, which would take twice as
C     long.
      SUBROUTINE TSSRSL(X, P, ORD, BOX, LINK, MARK, CTL, RCTL, HNT, SUP,
     $                  LSX, LSID, LSD, IQ, FQ, OK)
      INTEGER NLISTS, LFIRST, LIQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LIQ = 51, TSLIST = 448,
     $    LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*), FQ(*)
      REAL LSX(*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), IQ(LIQ), OK
      INTEGER CHSETS, STTIED, BLMISS, BLTIES, STR, LN, QFACET, QBEST,
     $    QHASBA, QBASE, QTIES, QINLIS, TIESEA
      PARAMETER (CHSETS = 1, STTIED = 3, BLMISS = 1, BLTIES = 2,
     $    STR = 2, LN = 0, QFACET = 0, QBEST = 4, QHASBA = 7, QBASE = 5,
     $    QTIES = 6, QINLIS = 9, TIESEA = 8)
      INTEGER TSBINS, N, Z
      OK = 0
      IF (IQ(QINLIS) .EQ. 0 .OR. IQ(QBASE) .NE. 1) RETURN
      IF (LSID(LN,STR) .EQ. 0 .OR. IQ(QHASBA) .EQ. 0) RETURN
      IF (CHSETS .EQ. 1 .AND. HNT(STTIED) .EQ. 1) THEN
        CALL TSRECS(X, P, ORD, BOX, RCTL, HNT, LSX, LSID, LSD, IQ, FQ,
     $              OK)
        IF (OK .EQ. 1) THEN
          CALL TSAPFS(X, P, ORD, RCTL, HNT, IQ(QFACET+1), Z)
          IQ(QBEST) = Z
          GO TO 10
        END IF
      END IF
      CALL TSOFFL(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, LSX, LSID,
     $            LSD, IQ, FQ, STR, N)
      IF (N .LT. 0) RETURN
      IF (N .GT. 0) THEN
        IF (CHSETS .EQ. 1 .AND. IQ(QTIES) .GT. 0 .AND.
     $      HNT(STTIED) .EQ. 0) CALL TSRECS(X, P, ORD, BOX, RCTL, HNT,
     $      LSX, LSID, LSD, IQ, FQ, OK)
        HNT(STTIED) = MIN(IQ(QTIES), 1)
      END IF
      OK = TSBINS(BOX, LSD, FQ)
      IF (OK .EQ. 0) RETURN
   10 HNT(BLMISS) = 0
      IF (HNT(BLTIES) .LE. TIESEA) HNT(BLTIES) = 0
      END

C     TSSRBL (search_block_list) - seeks the apex in the block list.  If
C     the ball leaves the block's box, the tree is searched in any case
C     and the list would only add cost: on surfaces, two fifths of the
C     points tested.  OK is 1 if the list held the ball, or 0.
      SUBROUTINE TSSRBL(X, P, ORD, BOX, LINK, MARK, CTL, RCTL, HNT, SUP,
     $                  LSX, LSID, LSD, IQ, FQ, OK)
      INTEGER NLISTS, LFIRST, LIQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LIQ = 51, TSLIST = 448,
     $    LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*), FQ(*)
      REAL LSX(*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), IQ(LIQ), OK
      INTEGER BLMISS, BLTIES, BLK, LN, QHASBA, QTIES, QINLIS, MAXMIS,
     $    TIESEA
      PARAMETER (BLMISS = 1, BLTIES = 2, BLK = 1, LN = 0, QHASBA = 7,
     $    QTIES = 6, QINLIS = 9, MAXMIS = 8, TIESEA = 8)
      INTEGER TSBINB, N
      OK = 0
      IF (IQ(QINLIS) .EQ. 0 .OR. LSID(LN,BLK) .EQ. 0) GO TO 10
      IF (IQ(QHASBA) .EQ. 0) GO TO 10
      IF (TSBINB(BOX, LSD, IQ, FQ, BLK) .EQ. 0) GO TO 10
      CALL TSOFFL(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, LSX, LSID,
     $            LSD, IQ, FQ, BLK, N)
      IF (N .LT. 0) GO TO 10
      OK = 1
      HNT(BLMISS) = 0
      IF (IQ(QTIES) .GT. 0) HNT(BLTIES) = MIN(HNT(BLTIES) + 1, TIESEA +
     $    1)
      RETURN
   10 HNT(BLMISS) = MIN(HNT(BLMISS) + 1, MAXMIS)
      END

C     ------------------------------------------------------------------
C     Near lists
C
C     FOR surfaces and curves, on which most searches begin with the
C     final ball, and the next ball is nearly the same: without them
C     terrain takes 1.31 times the instructions.
C
C     IDEA.  What costs is to prove a ball empty.  So the points in the
C     ball of a search, and in a skin about it, are kept; a search whose
C     ball lies inside offers these alone.  Lists that are not used
C     again would cost up to 1.4 times the instructions, so a budget
C     pays for them.
C
C       near list         the uncompleted points in the ball of an
C                         earlier search, or in its skin
C       skin              a layer about a ball, so that the next ball
C                         fits, too
C       budget            what near lists have saved, in nodes of the
C                         tree
C
C     HOOKS: IQ(QCOLL) and TSCOLF, while TSTREE makes a list; the stage
C     TSSRNL; TSREFI.  TSTINM calls TSBEMP.
C     STATE: in HNT, RCTL, IQ, FQ; lists behind STR.
C     INVARIANTS.  A near list with points has all that are uncompleted
C     and within reach of its centre; what is behind HNT(RECENC) is a
C     permutation of the lists.
C
C     In HNT:
C       PAUSED = 4   nears.paused  1: the budget is used up, and being
C               refilled
C       RECENC = 4   nears.recency  behind it the near lists, the one
C               that was used last first, 5 long
C     In RCTL:
C       RSKIN  = 4   nears.next_skin  the QSKFAC of the next near list
C       RBUDGE = 5   nears.budget  the budget of near lists, in nodes
C       RTREEC = 6   nears.tree_cost  the mean number of nodes of a tree
C               search
C     In IQ:
C       QCOLL  = 11  nears.collect  the list that gets the points that
C               pass the filter, on either side of the facet; or 0:
C               those on the open side are offered
C       QPAYS  = 12  nears.pays  1: a near list may end it
C     In FQ:
C       QSKFAC = 23  nears.skin_factor  the thickness of the skin as it
C               adapts
C       QSKIN  = 24  nears.skin  the thickness of the skin of this ball
C     Constants:
C       NEARLS = 5   NEAR_LISTS  number of near lists
C       SKNSHR = 0.4D0 SKIN_SHRINK  the skin of a near list is SKNSHR
C               times as thick while the list exceeds TSLIST,
C       SKNMIN = 0.05D0 SKIN_MIN  down to SKNMIN,
C       SKNBEL = (2*TSLIST-1)/5 SKIN_GROW_BELOW  and if the list holds
C               fewer than SKNBEL, which leaves no remainder,
C       SKNGRO = 1.3D0 SKIN_GROW  SKNGRO times for the next list,
C       SKNMAX = 8.0D0 SKIN_MAX  up to SKNMAX, a bound for lists of few
C               points.  They trade lists made against points in each
C       NEARMX = 1.0D4 NEAR_BALL_MAX  a ball whose centre is farther
C               than this gets no near list: single precision hardly
C               tells it from a half-space.  Powers, which a list keeps
C               while it is made, cannot overflow: correctness rests on
C               that
C       BUDREF = 64.0D0 BUDGET_REFILL  the budget of near lists, counted
C               in nodes of the tree: lists are made only while they
C               have saved more than they cost.  To look for a list
C               costs 1; to make one costs 30, and 1.75 for each node
C               visited.  A search that ends in a list earns what
C               searches in the tree take on average, less 4, and less
C               1/2 for each point offered.  When the budget is used up,
C               no near list is looked for or made until refills, one
C               part in BUDREF of the nodes of later tree searches,
C               bring it to BUDSTA
C       BUDSTA = 500.0D0 BUDGET_START  see BUDREF
C     ------------------------------------------------------------------

C     TSBINN (ball_in_near_list) - returns 1 if the points that may be
C     better than the best one, those of its ball that are on the open
C     side, lie inside a near list's ball.
C
C     All balls about centres c0 + h v, v the facet's normal, pass
C     through its vertices; on the open side each contains those of
C     lower h.  So any h >= L will do, and for L <= 0 the best is that
C     of the foot of the list's centre on the axis.  Let u lead from the
C     list's centre to c = c0 + h v, and p from c to such a point:
C     |p|**2 <= r**2 = |c|**2, relative to the base.  For the ball of L
C     itself, |p.u| <= r |u|.  For h > L, u is across the axis; if L <=
C     0 no point of the ball's part on the open side is farther from the
C     axis than rho, so |p.u| <= rho |u|.  The distance from the list's
C     centre is at most reach if
C         |u|**2 + r**2 + 2 r |u| <= reach**2,
C     or with rho for the last r.
C
C     Let err bound the error of c, as in TSUPBD.  r and rho are wrong
C     by it, u by twice as much, but for EPS (1 + reach): centre and its
C     distance to the base have two roundings.  Where u is across, u.v
C     is wrong by E (r + |u|) more, and E r <= err, as dc > E rho.  As
C     r, rho and |u| are at most reach, all that is less than 24 err
C     reach.  ROUNDG exceeds the other roundings, and those of TSMKNL.
      INTEGER FUNCTION TSBINN(LSID, LSD, FQ, LIST)
      INTEGER NLISTS, LFIRST, LLSD, LFQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, LFQ = 183,
     $    TSLIST = 448, LEAFPT = 48)
      INTEGER LSID(LFIRST:TSLIST+LEAFPT,NLISTS), LIST
      DOUBLE PRECISION LSD(LLSD,NLISTS), FQ(LFQ)
      INTEGER LN, LREACH, LCENTR, FNORM, FCEN, FBASE, FE, FDC, FRHO,
     $    QHH, QHI
      DOUBLE PRECISION EPS, ROUNDG
      PARAMETER (LN = 0, LREACH = 13, LCENTR = 14, FNORM = 0, FCEN = 3,
     $    FBASE = 6, FE = 10, FDC = 11, FRHO = 12, QHH = 0, QHI = 14,
     $    EPS = 2.0D0**(-52), ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION TSDOT, C, ERR, G(3), H, MARGIN, GAP, RR, SIZE,
     $    UU
      INTEGER K
      TSBINN = 0
      IF (LSID(LN,LIST) .EQ. 0) RETURN
      RR = 0.0D0
      UU = 0.0D0
      SIZE = 0.0D0
      DO 10 K = 1, 3
        G(K) = LSD(LCENTR+K,LIST) - FQ(QHH+FBASE+K)
   10 CONTINUE
      H = MAX(TSDOT(G, FQ(QHH+1)), FQ(QHI))
      IF (FQ(QHI) .GT. 0.0D0) H = FQ(QHI)
      DO 20 K = 1, 3
        C = FQ(QHH+FCEN+K) + H*FQ(QHH+FNORM+K)
        SIZE = SIZE + ABS(C)
        RR = RR + C*C
        UU = UU + (C - G(K))*(C - G(K))
   20 CONTINUE
      ERR = FQ(QHH+FDC) + ABS(H)*FQ(QHH+FE) + 4.0D0*EPS*SIZE
      MARGIN = LSD(LREACH,LIST)
      GAP = MARGIN*(MARGIN - 32.0D0*ERR - ROUNDG*(1.0D0 + MARGIN)) -
     $    RR - UU
      IF (H .GT. FQ(QHI)) RR = FQ(QHH+FRHO)*FQ(QHH+FRHO)
      IF (GAP .GT. 0.0D0 .AND. GAP*GAP .GE. 4.0D0*RR*UU) TSBINN = 1
      END

C     TSSKIN (set_skin) - sets the thickness of the skin about a
C     search's ball, in reaches of a block list; about larger balls it
C     is thinner, as there are more points in it.  The points in the
C     skin pass the filter then.
      SUBROUTINE TSSKIN(LSD, FQ)
      INTEGER NLISTS, LLSD, LFQ
      PARAMETER (NLISTS = 7, LLSD = 17, LFQ = 183)
      DOUBLE PRECISION LSD(LLSD,NLISTS), FQ(LFQ)
      INTEGER BLK, LREACH, VC, VALLOW, QFILT, QSKFAC, QSKIN
      DOUBLE PRECISION SKNMIN, LMAX, UNDERR
      PARAMETER (BLK = 1, LREACH = 13, VC = 0, VALLOW = 8, QFILT = 14,
     $    QSKFAC = 23, QSKIN = 24, SKNMIN = 0.05D0, LMAX = 1.0D100,
     $    UNDERR = 1.0D-200)
      DOUBLE PRECISION TSDOT, MARGIN, R
      MARGIN = LSD(LREACH,BLK)
      R = SQRT(TSDOT(FQ(QFILT+VC+1), FQ(QFILT+VC+1)))
      FQ(QSKIN) = FQ(QSKFAC)*MARGIN
      IF (R .GT. MARGIN) FQ(QSKIN) = FQ(QSKIN)*SQRT(MARGIN/R)
      FQ(QFILT+VALLOW) = FQ(QSKIN)*(2.0D0*R + FQ(QSKIN)) + UNDERR
      IF (FQ(QSKFAC) .LT. SKNMIN) FQ(QFILT+VALLOW) = -LMAX
      END

C     TSCOLF (collect_leaf) - puts points of a leaf into the list that a
C     search makes:  of N, the first at position FIRST, the uncompleted
C     ones whose power is at most MOST.  While they are too many, the
C     skin shrinks:  then those stay that still pass the filter.  They
C     are in the ball before, so |W|_1 is at most 4 times its radius,
C     and single precision changes a power by less than FEPS of it (or
C     to 0, where it would underflow: that passes in any case).  Powers
C     are where the list's coordinates will be.
      SUBROUTINE TSCOLF(LINK, LSX, LSID, LSD, IQ, FQ, FIRST, N, POWER,
     $                  MOST)
      INTEGER NLISTS, LLSX, LFIRST, LIQ, LFQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LLSX = 4, LFIRST = -2, LIQ = 51, LFQ = 183,
     $    TSLIST = 448, LEAFPT = 48)
      REAL LSX(LLSX*TSLIST,NLISTS)
      INTEGER LINK(*), LSID(LFIRST:TSLIST+LEAFPT,NLISTS), IQ(LIQ),
     $    FIRST, N
      DOUBLE PRECISION LSD(*), FQ(LFQ), POWER(*), MOST
      INTEGER LN, VC, QCOLL, QFILT, QSKFAC, QSKIN, COMPLE
      DOUBLE PRECISION SKNSHR, FLTMIN, FEPS
      PARAMETER (LN = 0, VC = 0, QCOLL = 11, QFILT = 14, QSKFAC = 23,
     $    QSKIN = 24, SKNSHR = 0.4D0, COMPLE = -1,
     $    FLTMIN = 2.0D0**(-126), FEPS = 2.0D0**(-23))
      DOUBLE PRECISION TSDOT, TSFBND, LIMIT
      INTEGER LIST, I, K, M
      LIST = IQ(QCOLL)
      M = LSID(LN,LIST)
      DO 10 I = 1, N
        LSID(M+1,LIST) = FIRST + I - 1
        LSX(M+1,LIST) = 0.0E0
        IF (ABS(POWER(I)) .GE. FLTMIN) LSX(M+1,LIST) = REAL(POWER(I))
        IF (POWER(I) .LE. MOST .AND. LINK(FIRST+I-1) .NE. COMPLE)
     $      M = M + 1
   10 CONTINUE
   20 IF (M .GT. TSLIST) THEN
        FQ(QSKFAC) = SKNSHR*FQ(QSKFAC)
        LIMIT = 8.0D0*(SQRT(TSDOT(FQ(QFILT+VC+1), FQ(QFILT+VC+1))) +
     $      FQ(QSKIN))
        CALL TSSKIN(LSD, FQ)
        LIMIT = TSFBND(FQ(QFILT+1), LIMIT)*(1.0D0 + 4.0D0*FEPS)
        K = M
        M = 0
        DO 30 I = 1, K
          LSID(M+1,LIST) = LSID(I,LIST)
          LSX(M+1,LIST) = LSX(I,LIST)
          IF (DBLE(LSX(I,LIST)) .LE. LIMIT) M = M + 1
   30   CONTINUE
        GO TO 20
      END IF
      LSID(LN,LIST) = M
      END

C     TSMKNL (make_near_list) - makes a near list of the ball of a
C     search and a skin about it, of points on either side of the facet.
C     OK is 1, or 0 if they are too many.
C
C     What is nearer than reach, but for TSBINN's ROUNDG, passes the
C     filter, so TSCOLF took it, and is in the box, so TSLFIL's bound
C     holds for it.  What is not may be in the list as well: no search
C     that TSBINN admits needs it.  But TSFBND lets points pass that are
C     as far from a narrow ball as their leaf is wide.  As coordinates
C     are at most 1, their squares in the units of a box add up to 12E30
C     at most, unless the box is narrower than 1E-15; single precision
C     may not hold them then, so these points are dropped.
      SUBROUTINE TSMKNL(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL,
     $                  HNT, SUP, LSX, LSID, LSD, IQ, FQ, LIST, OK)
      INTEGER NLISTS, LFIRST, LLSD, LIQ, LFQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, LIQ = 51,
     $    LFQ = 183, TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(LLSD,NLISTS), FQ(LFQ)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), IQ(LIQ), LIST, OK
      INTEGER RSKIN, RBUDGE, LN, LREACH, LCENTR, LFILT, VC, FBASE,
     $    QNODES, QCOLL, QHH, QFILT, QSKFAC, QSKIN, SKNBEL
      DOUBLE PRECISION SKNGRO, SKNMAX
      PARAMETER (RSKIN = 4, RBUDGE = 5, LN = 0, LREACH = 13,
     $    LCENTR = 14, LFILT = 8, VC = 0, FBASE = 6, QNODES = 10,
     $    QCOLL = 11, QHH = 0, QFILT = 14, QSKFAC = 23, QSKIN = 24,
     $    SKNBEL = (2*TSLIST - 1)/5, SKNGRO = 1.3D0, SKNMAX = 8.0D0)
      DOUBLE PRECISION TSDOT, AT(3), GQ(LFQ), HALF
      INTEGER TSPDIS, I, JQ(LIQ), K, M, N, Z
      DO 10 K = 1, LIQ
        JQ(K) = IQ(K)
   10 CONTINUE
      DO 30 K = 1, QFILT + LFILT
        GQ(K) = FQ(K)
   30 CONTINUE
      LSID(LN,LIST) = 0
      JQ(QCOLL) = LIST
      GQ(QSKFAC) = RCTL(RSKIN)
      CALL TSSKIN(LSD, GQ)
      CALL TSTREE(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $            SUP, LSX, LSID, LSD, JQ, GQ)
      RCTL(RBUDGE) = RCTL(RBUDGE) - (30.0D0 + 1.75D0*DBLE(JQ(QNODES)))
      OK = 0
      IF (LSID(LN,LIST) .EQ. 0) RETURN
      OK = 1
      RCTL(RSKIN) = GQ(QSKFAC)
      IF (LSID(LN,LIST) .LT. SKNBEL .AND. GQ(QSKFAC) .LT. SKNMAX)
     $    RCTL(RSKIN) = SKNGRO*GQ(QSKFAC)
      LSD(LREACH,LIST) = SQRT(TSDOT(FQ(QFILT+VC+1), FQ(QFILT+VC+1))) +
     $    GQ(QSKIN)
      DO 40 K = 1, 3
        AT(K) = FQ(QHH+FBASE+K) + FQ(QFILT+VC+K)
        LSD(LCENTR+K,LIST) = AT(K)
   40 CONTINUE
      CALL TSLBOX(BOX, LSD, LIST, AT, AT, HALF)
      IF (HALF .LT. 1.0D-15) THEN
        N = LSID(LN,LIST)
        M = 0
        DO 50 I = 1, N
          Z = LSID(I,LIST)
          LSID(M+1,LIST) = Z
          M = M + 1 - TSPDIS(X, LSD, LIST, Z)
   50   CONTINUE
        LSID(LN,LIST) = M
      END IF
      CALL TSFILL(X, LINK, LSX, LSID, LSD, LIST)
      END

C     TSSRNL (search_near_lists) - seeks the apex in a near list, which
C     is made if there is none that holds the ball.  No list is made for
C     L <= 0, as half of the ball is on the other side or more, nor for
C     a ball that single precision cannot tell from a half-space.  OK is
C     1 if the apex is known, or 0.
      SUBROUTINE TSSRNL(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL,
     $                  HNT, SUP, LSX, LSID, LSD, IQ, FQ, OK)
      INTEGER NLISTS, LLSD, LIQ, LFQ
      PARAMETER (NLISTS = 7, LLSD = 17, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(LLSD,NLISTS), FQ(LFQ)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(*), IQ(LIQ), OK
      INTEGER PAUSED, RECENC, RBUDGE, RTREEC, BLK, LREACH, VC1, QHASBA,
     $    QSURF, QPAYS, QHASCA, QFILT, QHI, NEARLS
      DOUBLE PRECISION NEARMX, BUDSTA, LMAX
      PARAMETER (PAUSED = 4, RECENC = 4, RBUDGE = 5, RTREEC = 6,
     $    BLK = 1, LREACH = 13, VC1 = 5, QHASBA = 7, QSURF = 17,
     $    QPAYS = 12, QHASCA = 13, QFILT = 14, QHI = 14, NEARLS = 5,
     $    NEARMX = 1.0D4, BUDSTA = 500.0D0, LMAX = 1.0D100)
      INTEGER TSBINN, FOUND, K, LIST, N
      IQ(QPAYS) = 0
      IF (IQ(QHASBA) .EQ. 1 .AND. FQ(QHI) .LE. LMAX .AND.
     $    IQ(QSURF) .EQ. 0 .AND. LSD(LREACH,BLK) .GT. 0.0D0)
     $    IQ(QPAYS) = 1
      IF (RCTL(RBUDGE) .LE. 0.0D0) HNT(PAUSED) = 1
      IF (RCTL(RBUDGE) .GT. BUDSTA) HNT(PAUSED) = 0
      OK = 0
      IF (IQ(QPAYS) .EQ. 0 .OR. HNT(PAUSED) .EQ. 1) RETURN
      RCTL(RBUDGE) = RCTL(RBUDGE) - 1.0D0
      K = 0
   10 K = K + 1
      LIST = HNT(RECENC+K)
      FOUND = TSBINN(LSID, LSD, FQ, LIST)
      IF (FOUND .EQ. 0 .AND. K .LT. NEARLS) GO TO 10
      IF (FOUND .EQ. 0) THEN
        IF (FQ(QHI) .LE. 0.0D0 .OR. FQ(QFILT+VC1) .GT. NEARMX .OR.
     $      IQ(QHASCA) .EQ. 1) RETURN
        CALL TSMKNL(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $              SUP, LSX, LSID, LSD, IQ, FQ, LIST, OK)
        IF (OK .EQ. 1) OK = TSBINN(LSID, LSD, FQ, LIST)
        IF (OK .EQ. 0) RETURN
        OK = 0
      END IF
   20 IF (K .GT. 1) THEN
        HNT(RECENC+K) = HNT(RECENC+K-1)
        HNT(RECENC+K-1) = LIST
        K = K - 1
        GO TO 20
      END IF
      CALL TSOFFL(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, LSX, LSID,
     $            LSD, IQ, FQ, LIST, N)
      IF (N .LT. 0) RETURN
      OK = 1
      IF (FOUND .EQ. 1) RCTL(RBUDGE) = RCTL(RBUDGE) +
     $    (RCTL(RTREEC) - 4.0D0 - 0.5D0*DBLE(N))
      END

C     TSREFI (refill_budget) - adds to the budget of near lists for a
C     search of the tree, if a near list might have taken its place.
      SUBROUTINE TSREFI(RCTL, IQ)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION RCTL(*)
      INTEGER IQ(LIQ)
      INTEGER RBUDGE, RTREEC, QNODES, QPAYS, QHASCA
      DOUBLE PRECISION BUDREF
      PARAMETER (RBUDGE = 5, RTREEC = 6, QNODES = 10, QPAYS = 12,
     $    QHASCA = 13, BUDREF = 64.0D0)
      IF (IQ(QPAYS) .EQ. 0 .OR. IQ(QHASCA) .EQ. 1) RETURN
      RCTL(RBUDGE) = RCTL(RBUDGE) + DBLE(IQ(QNODES))/BUDREF
      RCTL(RTREEC) = RCTL(RTREEC) + (DBLE(IQ(QNODES)) -
     $    RCTL(RTREEC))/16.0D0
      END

C     TSBEMP (ball_is_empty) - OK is 1 if no point is in the ball of the
C     tetrahedron U, positively oriented, 0 if one is; UNSURE if there
C     are too many to look at, or the ball has no good bound.  They are
C     collected as for a near list without a skin, on either side of the
C     facet, but as positions alone: the star list serves as scratch and
C     is none afterwards.  ORD takes the place of LINK: see TSCROS.
      SUBROUTINE TSBEMP(X, P, ORD, BOX, ALIVE, MARK, CTL, RCTL, HNT,
     $                  SUP, LSX, LSID, LSD, U, OK)
      INTEGER NLISTS, LFIRST, LLSD, LIQ, LFQ, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, LIQ = 51,
     $    LFQ = 183, TSLIST = 448, LEAFPT = 48)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(LLSD,NLISTS)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), MARK(*), CTL(*), HNT(*),
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), U(4), OK
      INTEGER EXACT3, EXACT5, BLK, STR, LN, LREACH, VDC, VC1, QBYLIM,
     $    QHASBA, QSURF, QCOLL, QFILT, QLO, QHI, QSKFAC, UNSURE
      DOUBLE PRECISION NEARMX, ROUNDG
      PARAMETER (EXACT3 = 1, EXACT5 = 2, BLK = 1, STR = 2, LN = 0,
     $    LREACH = 13, VDC = 4, VC1 = 5, QBYLIM = 8, QHASBA = 7,
     $    QSURF = 17, QCOLL = 11, QFILT = 14, QLO = 13, QHI = 14,
     $    QSKFAC = 23, NEARMX = 1.0D4, UNSURE = 2,
     $    ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION FQ(LFQ)
      INTEGER HHPINS, F(3), GUESS(2), IQ(LIQ), K, N, Z
      OK = UNSURE
      GUESS(1) = U(4)
      GUESS(2) = 0
      DO 10 K = 1, 3
        F(K) = U(K)
   10 CONTINUE
      CALL TSBEGS(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, F,
     $            GUESS)
      IF (IQ(QHASBA) .EQ. 0 .OR. FQ(QFILT+VC1) .GT. NEARMX) RETURN
      IF (FQ(QLO) .LE. -NEARMX) RETURN
C     behind the facet the ball of FQ(QHI) is within that of U
      FQ(QFILT+VDC) = FQ(QFILT+VDC) + (FQ(QHI) - FQ(QLO))*
     $  (1.0D0 + ROUNDG)
      IQ(QBYLIM) = 0
      IQ(QSURF) = 0
      IQ(QCOLL) = STR
      FQ(QSKFAC) = 1.0D0
      LSD(LREACH,BLK) = 0.0D0
      LSID(LN,STR) = 0
      CALL TSSKIN(LSD, FQ)
      CALL TSTREE(X, P, ORD, BOX, ALIVE, ORD, MARK, CTL, RCTL, HNT, SUP,
     $            LSX, LSID, LSD, IQ, FQ)
      N = LSID(LN,STR)
      LSID(LN,STR) = 0
      DO 20 K = 1, N
        Z = LSID(LN+K,STR)
        IF (Z .NE. U(1) .AND. Z .NE. U(2) .AND. Z .NE. U(3) .AND.
     $      Z .NE. U(4)) THEN
          OK = 0
          IF (HHPINS(X, P, ORD, RCTL(EXACT3), RCTL(EXACT5), U, U(4), Z,
     $        1) .LT. 0) RETURN
        END IF
   20 CONTINUE
      OK = UNSURE
      IF (N .GT. 0) OK = 1
      END

C     ------------------------------------------------------------------
C     Hull planes
C
C     FOR hulls with large flat faces: without them 5,000 points on the
C     surface of a cube take 10 times the instructions, on a prism of
C     six faces 39 times, in a lattice 2.9 times.
C
C     IDEA.  No search takes longer than one for a hull facet: it has no
C     ball, and the side of every point in the facet's plane is decided
C     exactly.  Where many points lie exactly in a few planes (faces of
C     a part, masts, stations at many times) there are very many such
C     facets, and time is quadratic.  But one search without an apex
C     settles all facets in its plane: three exact sides tell that a
C     facet is one of them.
C
C     Stars come in the order of the tree, which on a long part runs
C     round it, so that the next plane needed is the one that was used
C     longest ago: the planes must all be kept, or none serves.  20,000
C     points on a prism of 6 or 12 faces take 6 times as long with 4
C     planes as with 64, those of 20 stations 60 times.
C
C     HNT(HULLP) begins with the planes that have served, the latest
C     first; the others follow, again the latest first.  When it is
C     full, the last of those that never served goes, or if all have
C     served the last of these.  On an ellipsoid no plane ever serves,
C     and 64 of them would take half as much time again; so after VAINMX
C     looks in vain in a row each plane that is met replaces all others,
C     until one serves again.
C
C       hull plane        the plane of a facet without an apex
C
C     HOOKS: the stage TSONHP; TSNOTE.
C     STATE: in HNT, emptied by TSDROP, on which TSINCT of part III
C     rests.
C     INVARIANT.  All points that are uncompleted are in each plane or
C     on its inner side, as long as none becomes uncompleted again: see
C     TSDROP.
C
C     In HNT:
C       NHULLP = 10  hull.kept  the number of hull planes that are
C               kept
C       NSERVD = 11  hull.served  how many hull planes have served: the
C               first
C       VAINLO = 12  hull.vain_looks  how many facets in a row were in
C               no hull plane; at most VAINMX
C       HULLP  = 12  hull.plane  behind it a facet in each plane that is
C               kept, 3 vertices of each, 192 long
C     Constants:
C       HULLPS = 64  HULL_PLANES  maximum number of hull planes that are
C               kept: trades exact sides computed in vain against
C               searches of hull facets.  It is an array's length
C       VAINMX = 16  VAIN_LOOKS_MAX  number of facets in a row, in none
C               of the hull planes, after which the planes are dropped.
C               With 64, 3,000 points in layers take 4 % longer, as each
C               side needs limbs; with 8 nothing changes
C     ------------------------------------------------------------------

C     TSPUTH (put_hull_plane) - moves the hull planes at places TO ...
C     FROM-1 one place up, and puts that of the facet V at place TO.
      SUBROUTINE TSPUTH(HNT, V, FROM, TO)
      INTEGER HNT(*), V(3), FROM, TO
      INTEGER HULLP
      PARAMETER (HULLP = 12)
      INTEGER I, K, AT
      DO 20 I = FROM, TO, -1
        AT = HULLP + 3*(I - 1)
        DO 10 K = 1, 3
          IF (I .GT. TO) THEN
            HNT(AT+K) = HNT(AT+K-3)
          ELSE
            HNT(AT+K) = V(K)
          END IF
   10   CONTINUE
   20 CONTINUE
      END

C     TSONHP (on_hull_plane) - is the facet without a best point, and in
C     a plane known to bound the hull, so that it has no apex?  ON is 1
C     then, or 0.  Its open side is outwards then: that of a facet of a
C     known tetrahedron is.  A seed edge may be open inwards, but is
C     searched before any plane is met: at first, or after TSINCT has
C     dropped them.  (A facet on a sphere is not sought among planes.)
      SUBROUTINE TSONHP(X, P, ORD, RCTL, HNT, IQ, ON)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), HNT(*), IQ(LIQ), ON
      INTEGER NHULLP, NSERVD, VAINLO, HULLP, EXACT3, QFACET, QBEST,
     $    QINLIS, VAINMX
      PARAMETER (NHULLP = 10, NSERVD = 11, VAINLO = 12, HULLP = 12,
     $    EXACT3 = 1, QFACET = 0, QBEST = 4, QINLIS = 9, VAINMX = 16)
      INTEGER HHPORI, I, K, AT
      ON = 0
      IF (IQ(QINLIS) .EQ. 0 .OR. IQ(QBEST) .NE. 0) RETURN
      DO 20 I = 1, HNT(NHULLP)
        AT = HULLP + 3*(I - 1)
        DO 10 K = 1, 3
          IF (IQ(QFACET+K) .NE. HNT(AT+1) .AND.
     $        IQ(QFACET+K) .NE. HNT(AT+2) .AND.
     $        IQ(QFACET+K) .NE. HNT(AT+3)) THEN
            IF (HHPORI(X, P, ORD, RCTL(EXACT3), HNT(AT+1), HNT(AT+2),
     $          HNT(AT+3), IQ(QFACET+K)) .NE. 0) GO TO 20
          END IF
   10   CONTINUE
        CALL TSPUTH(HNT, IQ(QFACET+1), I, 1)
        IF (I .GT. HNT(NSERVD)) HNT(NSERVD) = HNT(NSERVD) + 1
        HNT(VAINLO) = 0
        ON = 1
        RETURN
   20 CONTINUE
      IF (HNT(VAINLO) .LT. VAINMX) HNT(VAINLO) = HNT(VAINLO) + 1
      END

C     TSNOTE (note_hull_plane) - keeps the plane of the facet if it has
C     no apex, unless it is on a sphere.
      SUBROUTINE TSNOTE(HNT, IQ)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      INTEGER HNT(*), IQ(LIQ)
      INTEGER NHULLP, NSERVD, VAINLO, QFACET, QBEST, QINLIS, HULLPS,
     $    VAINMX
      PARAMETER (NHULLP = 10, NSERVD = 11, VAINLO = 12, QFACET = 0,
     $    QBEST = 4, QINLIS = 9, HULLPS = 64, VAINMX = 16)
      INTEGER LAST
      IF (IQ(QINLIS) .EQ. 0 .OR. IQ(QBEST) .NE. 0) RETURN
      IF (HNT(VAINLO) .EQ. VAINMX) THEN
        HNT(NHULLP) = 0
        HNT(NSERVD) = 0
      END IF
      IF (HNT(NSERVD) .EQ. HULLPS) HNT(NSERVD) = HNT(NSERVD) - 1
      IF (HNT(NHULLP) .LT. HULLPS) HNT(NHULLP) = HNT(NHULLP) + 1
      LAST = HNT(NHULLP)
      CALL TSPUTH(HNT, IQ(QFACET+1), LAST, HNT(NSERVD) + 1)
      END

C     ------------------------------------------------------------------
C     Ties: cospherical sets
C
C     FOR lattices and other points with many exactly on one empty
C     sphere: without them a lattice takes 1.5 times the instructions.
C     What has no ties never makes a set.
C
C     IDEA.  Among points of one empty sphere the tie rule alone
C     decides, and its outcome is known: all are joined to the one of
C     least number.  So the points of the sphere are found once in a
C     star, and the apex of a facet with two of them follows by a few
C     exact sides.
C
C       cospherical set   the uncompleted points exactly on one empty
C                         ball's sphere
C
C     Let T be the points on the sphere of an empty ball, such as that
C     of any tetrahedron of the mesh.  The tie rule (see hhpred.f)
C     lowers heights, that of first, the point of T of least number, by
C     far the most.  So
C       - among points of T the mesh consists of the facets of T's hull
C         without first, each joined to first;
C       - a tetrahedron with its vertices in T has first for one of
C         them: first is the least vertex of any such tetrahedron that
C         is known;
C       - a facet of three points of T without first, which is in T's
C         hull, has no point of T on its open side unless first is on
C         it: the apex is first, or none of T;
C       - a facet (first, a, b) with points of T on its open side has
C         one of them as its apex, as the ball is empty.  Of two, c and
C         z, z is better if it is beyond the plane (a, b, c) seen from
C         first, and worse if it is on first's side; in that plane the
C         lesser e_i of the rule decide.
C     A point of T whose star is complete is in no open facet and is no
C     apex.  If first's star is complete, all tetrahedra of T are known;
C     so for a new tetrahedron's T it is not.
C
C     A cospherical set has all uncompleted points of T, the least
C     number first, of a ball inside the star list.  Only these are
C     tested for a facet of the star.
C
C     HOOKS: TSAPFS; TSRECS, which TSSRSL calls.
C     STATE: in HNT.
C     INVARIANT.  A set is complete: it has all uncompleted points of
C     its sphere, and the ball is empty.
C
C     In HNT:
C       NSETS  = 205 sets.recorded  how many cospherical sets were
C               recorded in this star
C       SET1   = 206 sets.set  from here on the last SETS cospherical
C               sets of this star, of each SETPTS + 1 integers, 52 long:
C       SET1   array n  the number of points,
C       SET1   array position  behind it the points; the least number
C               first
C     Constants:
C       SETPTS = 12  SET_POINTS  maximum number of points of a
C               cospherical set,
C       SETS   = 4   SETS  and of sets kept.  They trade the stack
C               against ties found again
C     ------------------------------------------------------------------

C     TSRECS (record_set) - records a cospherical set, the points
C     exactly on the best point's ball, if all are in the star list and
C     none is inside.  OK is 1, or 0 if not, or if there are no ties.
C     The filter's dc does not count QHI - QLO, as better points are on
C     the positive side; here points on both sides count, so it is
C     added.
      SUBROUTINE TSRECS(X, P, ORD, BOX, RCTL, HNT, LSX, LSID, LSD, IQ,
     $                  FQ, OK)
      INTEGER NLISTS, LFIRST, LLSD, LIQ, LFQ, TSLIST, LEAFPT, SETPTS
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, LIQ = 51,
     $    LFQ = 183, TSLIST = 448, LEAFPT = 48, SETPTS = 12)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*),
     $    LSD(LLSD,NLISTS), FQ(LFQ)
      REAL LSX(*)
      INTEGER ORD(*), HNT(*), LSID(LFIRST:TSLIST+LEAFPT,NLISTS),
     $    IQ(LIQ), OK
      INTEGER NSETS, SET1, EXACT3, EXACT5, STR, LREACH, VDC, QFACET,
     $    QBEST, QBYLIM, QFILT, QLO, QHI, SETS
      DOUBLE PRECISION LMAX
      PARAMETER (NSETS = 205, SET1 = 206, EXACT3 = 1, EXACT5 = 2,
     $    STR = 2, LREACH = 13, VDC = 4, QFACET = 0, QBEST = 4,
     $    QBYLIM = 8, QFILT = 14, QLO = 13, QHI = 14, SETS = 4,
     $    LMAX = 1.0D100)
      DOUBLE PRECISION DC, WIDE
      INTEGER HHPINS, TSBINS, C(SETPTS), I, M, N, PLACE(TSLIST+1), SIDE,
     $    Z, AT
      OK = 0
      IF (ABS(FQ(QHI)) .GT. LMAX) RETURN
      WIDE = 0.0D0
C     (FQ(QLO) may be -HUGE)
      IF (IQ(QBYLIM) .EQ. 0) WIDE = FQ(QHI) - MAX(FQ(QLO), -LMAX)
      IF (WIDE .GT. LSD(LREACH,STR)) RETURN
      DC = FQ(QFILT+VDC)
      FQ(QFILT+VDC) = DC + WIDE
      N = 0
      IF (TSBINS(BOX, LSD, FQ) .EQ. 1) CALL TSLHIT(LSX, LSID, LSD, FQ,
     $    STR, PLACE, N)
      FQ(QFILT+VDC) = DC
      IF (N .LE. 0 .OR. N .GT. SETPTS) RETURN
      M = 0
      DO 30 I = 1, N
        Z = LSID(PLACE(I),STR)
        SIDE = 0
        IF (Z .NE. IQ(QFACET+1) .AND. Z .NE. IQ(QFACET+2) .AND.
     $      Z .NE. IQ(QFACET+3) .AND. Z .NE. IQ(QBEST)) SIDE = HHPINS(X,
     $      P, ORD, RCTL(EXACT3), RCTL(EXACT5), IQ(QFACET+1), IQ(QBEST),
     $      Z, 0)
        IF (SIDE .LT. 0) RETURN
        IF (SIDE .EQ. 0) THEN
          M = M + 1
          C(M) = Z
          IF (ORD(Z) .LT. ORD(C(1))) THEN
            C(M) = C(1)
            C(1) = Z
          END IF
        END IF
   30 CONTINUE
      IF (M .EQ. 4) RETURN
      AT = SET1 + (SETPTS + 1)*MOD(HNT(NSETS), SETS)
      HNT(NSETS) = HNT(NSETS) + 1
      HNT(AT) = M
      DO 40 I = 1, M
        HNT(AT+I) = C(I)
   40 CONTINUE
      OK = 1
      END

C     TSAPFS (apex_from_set) - Z is the apex of the facet V if it is in
C     a cospherical set, or 0: see "Ties".
      SUBROUTINE TSAPFS(X, P, ORD, RCTL, HNT, V, Z)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), HNT(*), V(3), Z
      INTEGER NSETS, SET1, EXACT3, EXACT5, SETPTS, SETS
      PARAMETER (NSETS = 205, SET1 = 206, EXACT3 = 1, EXACT5 = 2,
     $    SETPTS = 12, SETS = 4)
      INTEGER HHPINS, HHPORI, I, IN, J, K, AT
      Z = 0
      DO 40 K = 1, MIN(HNT(NSETS), SETS)
        AT = SET1 + (SETPTS + 1)*(K - 1)
        IN = 0
        DO 10 I = 1, HNT(AT)
          J = HNT(AT+I)
          IF (J .EQ. V(2) .OR. J .EQ. V(3)) IN = IN + 1
   10   CONTINUE
        IF (IN .EQ. 2) THEN
          DO 20 I = 1, HNT(AT)
            J = HNT(AT+I)
            IF (J .NE. V(1) .AND. J .NE. V(2) .AND. J .NE. V(3)) THEN
              IF (HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3),
     $            J) .GT. 0) THEN
                IN = -1
                IF (Z .NE. 0) IN = HHPINS(X, P, ORD, RCTL(EXACT3),
     $              RCTL(EXACT5), V, Z, J, 3)
                IF (IN .LT. 0) Z = J
              END IF
              IF (I .EQ. 1) GO TO 30
            END IF
   20     CONTINUE
   30     IF (Z .NE. 0) RETURN
        END IF
   40 CONTINUE
      END

C     ------------------------------------------------------------------
C     Cylinders
C
C     FOR smooth surfaces and curves: without them points near a plane
C     take 5.3 times the instructions.  They cost 11 doubles a leaf, and
C     clouds 1 % more instructions, for nothing.
C
C     IDEA.  On a smooth surface a box sticks out of the surface by as
C     much as it is wide, so a ball that touches the surface meets many
C     boxes.  Along a curve a box is as wide as it is long.  A cylinder
C     that holds a node's points (a disc on a surface, a rod on a curve)
C     is thinner, by the ratio of the node's width to the radius of
C     curvature, and the ball meets only a few of them, however many
C     there are.  Cylinders are made for the nodes of every second level
C     from the leaves up.  The four grandchildren of a node lie side by
C     side and are tested at once.
C
C       cylinder          a second bounding volume, of nodes of every
C                         second level
C
C     HOOKS: TSMCYS; TSPFOU, where TSTREE goes by two levels.
C     STATE: in HNT; CYL, behind BOX.
C     INVARIANT.  If HNT(HASCYL) is 1, each node of those levels has
C     one, and all its points are in it.
C
C     In HNT:
C       HASCYL = 258 cylinders.made  1: there are cylinders, behind
C               BOX(6,2*CTL(LEAVES))
C     CYL(4,LCYL,.), see TSCYLI:
C       LCYL   = 8   -
C       CCEN   = 0   -  behind it the centre
C       CAXIS  = 3   -  behind it the unit axis
C       CHALF  = 7   -  the half length
C       CRAD   = 8   -  the radius
C     Constants:
C       SLENVO = 0.7D0 SLENDER_VOLUME  a cylinder is slender if its
C               volume is below so much of its box's.  None are used if
C               fewer than one leaf of 64 has a slender one: clouds
C               would pay 1 %
C     ------------------------------------------------------------------

C     TSCYLI (cylinders_of) - returns the number of the cylinders of the
C     four grandchildren of a node: CYL(.,.,TSCYLI) has their centres,
C     unit axes, half lengths, radii.  The four values of each number
C     are adjacent.
      INTEGER FUNCTION TSCYLI(CTL, NODE)
      INTEGER CTL(*), NODE
      INTEGER LEAVES
      PARAMETER (LEAVES = 4)
      INTEGER LEVEL
      LEVEL = CTL(LEAVES)/4
      TSCYLI = 1
   10 IF (NODE .LT. LEVEL) THEN
        TSCYLI = TSCYLI + LEVEL
        LEVEL = LEVEL/4
        GO TO 10
      END IF
      TSCYLI = TSCYLI + NODE - LEVEL
      END

C     TSMCYL (make_cylinder) - makes the cylinder of a node,
C     CYL(J,.,AT).  The axis is the column of the greatest diagonal
C     element in the matrix of second moments about the mean (a rod) or
C     in its adjugate (a disc), whichever gives less volume.  (Moments
C     about another point than the mean would not tell the normal of a
C     plane.)  SLENDR is 1 if that volume is below SLENVO of the box's,
C     or 0.  In units of the sum of |X(K)|, the differences from the
C     mean err by EPS, their products with the axis and what is left
C     across it by less than 40 EPS, the centre by 10 EPS: together less
C     than 64 EPS.
      SUBROUTINE TSMCYL(X, BOX, CYL, CTL, NODE, AT, J, SLENDR)
      INTEGER LCYL
      PARAMETER (LCYL = 8)
      DOUBLE PRECISION X(3,*), BOX(6,*), CYL(4,LCYL,*)
      INTEGER CTL(*), NODE, AT, J, SLENDR
      INTEGER CCEN, CAXIS, CHALF, CRAD
      DOUBLE PRECISION SLENVO, HUGE, EPS, LENMIN, UNDERR
      PARAMETER (CCEN = 0, CAXIS = 3, CHALF = 7, CRAD = 8,
     $    SLENVO = 0.7D0, HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023,
     $    EPS = 2.0D0**(-52), LENMIN = 2.0D0**(-450), UNDERR = 1.0D-200)
      DOUBLE PRECISION TSDOT, A(3,3), HI, LO, MID(3), PAD, Q(3,3), RR,
     $    S, U(3), VOLUME, Y(3)
      INTEGER DISC, FIRST, I, J1, J2, K, K1, K2, L, LAST
      CALL TSNRNG(CTL, NODE, FIRST, LAST)
      VOLUME = HUGE
      PAD = 0.0D0
      DO 10 K = 1, 3
        MID(K) = 0.0D0
        PAD = PAD + 64.0D0*EPS*(ABS(BOX(K,NODE)) + ABS(BOX(3+K,NODE)))
     $      + LENMIN
        DO 5 L = 1, 3
          A(L,K) = 0.0D0
    5   CONTINUE
   10 CONTINUE
      DO 30 I = FIRST, LAST
        DO 20 K = 1, 3
          MID(K) = MID(K) + X(K,I)/DBLE(LAST - FIRST + 1)
   20   CONTINUE
   30 CONTINUE
      DO 60 I = FIRST, LAST
        DO 40 K = 1, 3
          Y(K) = X(K,I) - MID(K)
   40   CONTINUE
        DO 50 K = 1, 3
          DO 45 L = 1, 3
            A(L,K) = A(L,K) + Y(K)*Y(L)
   45     CONTINUE
   50   CONTINUE
   60 CONTINUE
      DO 130 DISC = 0, 1
        DO 70 K = 1, 3
          K1 = MOD(K, 3) + 1
          K2 = MOD(K + 1, 3) + 1
          DO 65 L = 1, 3
            J1 = MOD(L, 3) + 1
            J2 = MOD(L + 1, 3) + 1
            Q(L,K) = A(L,K)
            IF (DISC .EQ. 1) Q(L,K) = A(J1,K1)*A(J2,K2) - A(J2,K1)*
     $          A(J1,K2)
   65     CONTINUE
   70   CONTINUE
        L = 1
        IF (Q(2,2) .GT. Q(1,1)) L = 2
        IF (Q(3,3) .GT. Q(L,L)) L = 3
        S = TSDOT(Q(1,L), Q(1,L))
        DO 80 K = 1, 3
C         any direction, if too small to have one
          U(K) = 0.0D0
          IF (K .EQ. 1) U(K) = 1.0D0
          IF (S .GT. UNDERR) U(K) = Q(K,L)/SQRT(S)
   80   CONTINUE
        LO = HUGE
        HI = -HUGE
        RR = 0.0D0
        DO 110 I = FIRST, LAST
          DO 90 K = 1, 3
            Y(K) = X(K,I) - MID(K)
   90     CONTINUE
          S = TSDOT(Y, U)
          LO = MIN(LO, S)
          HI = MAX(HI, S)
          DO 100 K = 1, 3
            Y(K) = Y(K) - S*U(K)
  100     CONTINUE
          RR = MAX(RR, TSDOT(Y, Y))
  110   CONTINUE
        IF ((HI - LO)*RR .GE. VOLUME) GO TO 130
        VOLUME = (HI - LO)*RR
        DO 120 K = 1, 3
          CYL(J,CCEN+K,AT) = MID(K) + 0.5D0*(LO + HI)*U(K)
          CYL(J,CAXIS+K,AT) = U(K)
  120   CONTINUE
        CYL(J,CHALF,AT) = 0.5D0*(HI - LO) + PAD
        CYL(J,CRAD,AT) = SQRT(RR) + PAD
  130 CONTINUE
      SLENDR = 0
      IF (3.2D0*VOLUME .LT. SLENVO*(BOX(4,NODE) - BOX(1,NODE))*
     $    (BOX(5,NODE) - BOX(2,NODE))*(BOX(6,NODE) - BOX(3,NODE)))
     $    SLENDR = 1
      END

C     TSMCYS (make_cylinders) - makes all cylinders, or none if few of
C     them are slender.
      SUBROUTINE TSMCYS(X, BOX, CYL, CTL, HNT)
      DOUBLE PRECISION X(3,*), BOX(6,*), CYL(*)
      INTEGER CTL(*), HNT(*)
      INTEGER LEAVES, HASCYL
      PARAMETER (LEAVES = 4, HASCYL = 258)
      INTEGER TSCYLI, I, LEVEL, NODE, SLENDR, SUM
      SUM = 0
      LEVEL = CTL(LEAVES)/4
   10 IF (LEVEL .GT. 0) THEN
        DO 30 NODE = LEVEL, 2*LEVEL - 1
          DO 20 I = 1, 4
            CALL TSMCYL(X, BOX, CYL, CTL, 4*NODE + I - 1,
     $                  TSCYLI(CTL, NODE), I, SLENDR)
            SUM = SUM + SLENDR
   20     CONTINUE
   30   CONTINUE
        IF (64*SUM .LT. CTL(LEAVES)) RETURN
        LEVEL = LEVEL/4
        GO TO 10
      END IF
      HNT(HASCYL) = 1
      END

C     TSXCYL (exclude_cylinders) - tests the cylinders of a node's four
C     grandchildren:  PAST(I) > 0 if cylinder I provably holds no better
C     point.
C
C     A point is W + S U + P from the base, where W is the cylinder's
C     centre, U its axis, |S| <= H, and P is across U, |P| <= R.  With G
C     = W - C, A = |G.U|, and RHO the length of G across U, its power in
C     the ball about C is
C         |W|**2 - 2 C.W + (S**2 + 2 S G.U) + (|P|**2 + 2 G.P).
C     The brackets are at least T (T - 2 A), where T is the lesser of A
C     and H, and Q**2 - 2 Q RHO, where Q is the lesser of RHO and R.  So
C     there is no better point if the sum without 2 Q RHO is positive
C     and its square is above 4 Q**2 RHO**2.
C
C     The sum errs by less than 64 EPS SIZE (SIZE + 2 |C|), SIZE >=
C     |W|_1 + H + R.  In EPS: W errs by |W|, which counts twice in the
C     power, and with that of G in RHO makes 4; the power by 8 (TSFBND);
C     A by 6 |G|_1, which counts 2 T times; |U|**2 is 1 but for 8, which
C     tilts P: 9; and some for the sum.  RHO**2 errs by less than 64 EPS
C     |G|**2, with room for the last two products: these are rounded
C     alike, or if one is contracted, the other one loses 1 EPS, or by
C     underflow less than PAST can be.  Where squares underflow, R >=
C     LENMIN makes the sum's error greater.
      SUBROUTINE TSXCYL(CYL, FQ, AT, PAST)
      INTEGER LFQ, LCYL
      PARAMETER (LFQ = 183, LCYL = 8)
      DOUBLE PRECISION CYL(4,LCYL,*), FQ(LFQ), PAST(4)
      INTEGER AT
      INTEGER VC, VDC, VC1, VALLOW, FBASE, QHH, QFILT, CCEN, CAXIS,
     $    CHALF, CRAD
      DOUBLE PRECISION EPS
      PARAMETER (VC = 0, VDC = 4, VC1 = 5, VALLOW = 8, FBASE = 6,
     $    QHH = 0, QFILT = 14, CCEN = 0, CAXIS = 3, CHALF = 7, CRAD = 8,
     $    EPS = 2.0D0**(-52))
      DOUBLE PRECISION A, ERR, G1, G2, G3, GG, H, R, RHO, RR, SIZE, SUM,
     $    T, W1, W2, W3
      INTEGER I
      ERR = 2.0D0*FQ(QFILT+VDC) + 128.0D0*EPS*FQ(QFILT+VC1)
      DO 20 I = 1, 4
        W1 = CYL(I,CCEN+1,AT) - FQ(QHH+FBASE+1)
        W2 = CYL(I,CCEN+2,AT) - FQ(QHH+FBASE+2)
        W3 = CYL(I,CCEN+3,AT) - FQ(QHH+FBASE+3)
        H = CYL(I,CHALF,AT)
        R = CYL(I,CRAD,AT)
        SIZE = ABS(W1) + ABS(W2) + ABS(W3) + 2.0D0*(H + R)
        G1 = W1 - FQ(QFILT+VC+1)
        G2 = W2 - FQ(QFILT+VC+2)
        G3 = W3 - FQ(QFILT+VC+3)
        A = ABS(G1*CYL(I,CAXIS+1,AT) + G2*CYL(I,CAXIS+2,AT) + G3*
     $      CYL(I,CAXIS+3,AT))
        T = MIN(A, H)
        GG = G1*G1 + G2*G2 + G3*G3
        RHO = GG - A*A + 64.0D0*EPS*GG
        RR = MIN(RHO, R*R)
        SUM = W1*(G1 - FQ(QFILT+VC+1)) + W2*(G2 - FQ(QFILT+VC+2)) +
     $      W3*(G3 - FQ(QFILT+VC+3)) + T*(T - 2.0D0*A) + RR - SIZE*(ERR
     $      + 64.0D0*EPS*SIZE) - FQ(QFILT+VALLOW)
        PAST(I) = SUM*ABS(SUM) - 4.0D0*RR*RHO
   20 CONTINUE
      END

C     TSPFOU (push_fours) - pushes those of a node's four grandchildren,
C     other than FROM, that their cylinders do not exclude.  DEPTH is
C     that of the stack.
      SUBROUTINE TSPFOU(CYL, CTL, FQ, NODE, FROM, STACK, DEPTH)
      DOUBLE PRECISION CYL(*), FQ(*)
      INTEGER CTL(*), NODE, FROM, STACK(*), DEPTH
      DOUBLE PRECISION PAST(4)
      INTEGER TSCYLI, I
      CALL TSXCYL(CYL, FQ, TSCYLI(CTL, NODE), PAST)
      DO 10 I = 4, 1, -1
        IF (PAST(I) .LE. 0.0D0 .AND. 4*NODE + I - 1 .NE. FROM) THEN
          DEPTH = DEPTH + 1
          STACK(DEPTH) = 4*NODE + I - 1
        END IF
   10 CONTINUE
      END

C     ------------------------------------------------------------------
C     Caps
C
C     FOR points sampled on flat faces, which rounding has left a little
C     off their planes: without caps 50,000 on the faces of a box take
C     3.3 times the instructions.  Other sets pay less than 1 %.
C
C     IDEA.  Outside of a flat face the balls are nearly half-spaces.
C     Such a ball meets all the boxes along the face's edges, as these
C     stick out, though only points near the facet can be in it.
C
C       supporting plane  one that has all points on one side of it, or
C                         in it
C       cap               the part of a ball on the points' side of such
C                         a plane
C
C     Let N.Z <= H hold for all points Z; with W = Z - base,
C     N.W <= T = H - N.base.  A better point satisfies
C     |W|**2 - 2 C.W <= 0, so for any U >= 0
C         |W|**2 - 2 (C - U N).W <= 2 U N.W <= 2 U T,
C     too.  With U = N.C that is a ball about the foot of C in the plane
C     through the base.  It holds the cap.  Where T is small it is much
C     smaller than the first ball, and only boxes near the facet meet
C     it.  Nodes are tested against both balls, as within the plane the
C     second is the wider one; against that of the cap first, so what it
C     excludes the other might exclude, too.  A cap is right for the
C     smaller balls of the same search: their better points are in that
C     ball.
C
C     Planes are sought perpendicular to C of a search that was long.
C     One plane a face is not enough: rounding tilts small facets, and
C     where C is far off the foot in a plane of another tilt is far off,
C     too.  Where the points do not lie on flat faces about the hull,
C     most planes are in vain: then there are soon none to be tested.
C
C     HOOKS: TSCHCA when a search has gone past the lists, and when its
C     ball changes in the tree; TSXBOX of QCAP if IQ(QHASCA) is 1, where
C     TSTREE tests a node (OUTSIDE_CAP in C); TSSKPL.  A search with a
C     cap makes no near list, and adds nothing to their budget.
C     STATE: in HNT and RCTL, set by TSSTAG; in IQ, set by TSBEGS, and
C     FQ.
C     INVARIANT.  Each plane has all points of the mesh on one side of
C     it, or in it, up to the rounding that TSCHCA adds.
C
C     In HNT:
C       NPLANE = 259 caps.planes  how many supporting planes were made
C     In RCTL:
C       RBIGBA = 7   caps.big_ball  a ball with a greater |C|_1 may have
C               a cap
C       RCAPLO = 8   caps.long_nodes  the nodes of long searches since
C               the last plane was made, over CTL(LEAVES)
C       RCAPLI = 9   caps.enough  when they are so many, a plane is made
C       RPLANE = 9   caps.plane  behind it the last CAPS supporting
C               planes: of each the unit normal, and its greatest
C               product with a point, 128 long
C     In IQ:
C       QHASCA = 13  caps.found  1: its ball has a cap
C     In FQ:
C       QCAP   = 24  caps.filter  behind it the filter of the ball that
C               holds the cap, LFILT long, if QHASCA is 1
C     Constants:
C       BIGBAL = 0.5D0 BIG_BALL  caps are for balls whose |C|_1 exceeds
C               BIGBAL times the width of the root's box,
C       CAPRAD = 0.25D0 CAP_RADIUS  and are of less radius than CAPRAD
C               times that.
C       CAPNOD = 64  CAP_NODES  A search of such a ball is long if it
C               visits CAPNOD nodes or more.  A supporting plane is
C               sought once the nodes of long searches add up to
C       CAPLIM = 4.0D0 CAP_LIMIT  CAPLIM times the leaves;
C       CAPGRO = 1.05D0 CAP_GROWTH  each plane makes that limit CAPGRO
C               times as high, each failure doubles it.  They trade
C               passes over the points and tests against long searches:
C               with a CAPLIM of 1 clouds take 1 % more instructions,
C               with one of 16 50,000 points on the faces of a box a
C               fifth more
C       CAPS   = 32  CAPS  number of planes that are kept
C     ------------------------------------------------------------------

C     TSWIDT (node_width) - returns the sum of a box's extents.
      DOUBLE PRECISION FUNCTION TSWIDT(B)
      DOUBLE PRECISION B(6)
      TSWIDT = (B(4) - B(1)) + (B(5) - B(2)) + (B(6) - B(3))
      END

C     TSCHCA (choose_cap) - gives the search the smallest cap of its
C     ball, if that is not too large.  The inequalities hold for N and U
C     as they are, rounded; only what is computed from them errs.
C     C - U N errs by EPS (2 U |N| + |C|), less than 4 EPS c1, and the
C     sum with dc is rounded.  As no |X(K,I)| exceeds 1 nor |N|_1 1.74,
C     H, in units of EPS |N|_1, is too small by 3 for a product and 1
C     for the store, N.base too large by 3, their difference too small
C     by 2, what is added to it costs 2, and 10 times 2 are lost by all
C     further roundings, those of TSFBND too: less than 64 EPS (cap.g of
C     the bounds).
      SUBROUTINE TSCHCA(BOX, RCTL, HNT, IQ, FQ)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION BOX(6,*), RCTL(*), FQ(LFQ)
      INTEGER HNT(*), IQ(LIQ)
      INTEGER NPLANE, RPLANE, VC, VDC, VC1, VALLOW, FBASE, QHASBA,
     $    QSURF, QHASCA, QHH, QFILT, QCAP, CAPS
      DOUBLE PRECISION CAPRAD, EPS
      PARAMETER (NPLANE = 259, RPLANE = 9, VC = 0, VDC = 4, VC1 = 5,
     $    VALLOW = 8, FBASE = 6, QHASBA = 7, QSURF = 17, QHASCA = 13,
     $    QHH = 0, QFILT = 14, QCAP = 24, CAPS = 32, CAPRAD = 0.25D0,
     $    EPS = 2.0D0**(-52))
      DOUBLE PRECISION TSDOT, TSWIDT, C(3), R, RR, SLACK, U
      INTEGER AT, I, K
      IQ(QHASCA) = 0
      IF (IQ(QHASBA) .EQ. 0 .OR. IQ(QSURF) .NE. 0) RETURN
      RR = (CAPRAD*TSWIDT(BOX(1,1)))**2
      DO 30 I = 1, MIN(HNT(NPLANE), CAPS)
        AT = RPLANE + 4*(I - 1)
        U = TSDOT(RCTL(AT+1), FQ(QFILT+VC+1))
        SLACK = 2.0D0*U*(RCTL(AT+4) - TSDOT(RCTL(AT+1),
     $      FQ(QHH+FBASE+1)) + 64.0D0*EPS)
        DO 10 K = 1, 3
          C(K) = FQ(QFILT+VC+K) - U*RCTL(AT+K)
   10   CONTINUE
        R = TSDOT(C, C) + SLACK
        IF (U .LE. 0.0D0 .OR. R .GE. RR) GO TO 30
        RR = R
        IQ(QHASCA) = 1
        DO 20 K = 1, 3
          FQ(QCAP+VC+K) = C(K)
   20   CONTINUE
        FQ(QCAP+VC1) = ABS(C(1)) + ABS(C(2)) + ABS(C(3))
        FQ(QCAP+VDC) = FQ(QFILT+VDC) + 8.0D0*EPS*(FQ(QFILT+VC1) +
     $      FQ(QFILT+VDC))
        FQ(QCAP+VALLOW) = FQ(QFILT+VALLOW) + SLACK
   30 CONTINUE
      END

C     TSSKPL (seek_plane) - counts the nodes of a long search, one of a
C     ball large enough for a cap.  When they are enough, it makes the
C     supporting plane perpendicular to C, and keeps it if the search
C     has a cap now.
      SUBROUTINE TSSKPL(X, BOX, CTL, RCTL, HNT, IQ, FQ)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), BOX(6,*), RCTL(*), FQ(LFQ)
      INTEGER CTL(*), HNT(*), IQ(LIQ)
      INTEGER NP, LEAVES, NPLANE, RBIGBA, RCAPLO, RCAPLI, RPLANE, VC,
     $    VC1, QHASBA, QSURF, QNODES, QHASCA, QFILT, CAPNOD, CAPS
      DOUBLE PRECISION BIGBAL, CAPGRO
      PARAMETER (NP = 1, LEAVES = 4, NPLANE = 259, RBIGBA = 7,
     $    RCAPLO = 8, RCAPLI = 9, RPLANE = 9, VC = 0, VC1 = 5,
     $    QHASBA = 7, QSURF = 17, QNODES = 10, QHASCA = 13, QFILT = 14,
     $    CAPNOD = 64, CAPS = 32, BIGBAL = 0.5D0, CAPGRO = 1.05D0)
      DOUBLE PRECISION TSDOT, TSWIDT, BIG, R
      INTEGER AT, I, K
      IF (IQ(QNODES) .LT. CAPNOD .OR. IQ(QHASBA) .EQ. 0 .OR.
     $    IQ(QSURF) .NE. 0) RETURN
      BIG = BIGBAL*TSWIDT(BOX(1,1))
      IF (FQ(QFILT+VC1) .LE. BIG) RETURN
      RCTL(RCAPLO) = RCTL(RCAPLO) + DBLE(IQ(QNODES))/DBLE(CTL(LEAVES))
      IF (RCTL(RCAPLO) .LT. RCTL(RCAPLI)) RETURN
      RCTL(RCAPLO) = 0.0D0
      AT = RPLANE + 4*MOD(HNT(NPLANE), CAPS)
      HNT(NPLANE) = HNT(NPLANE) + 1
      R = SQRT(TSDOT(FQ(QFILT+VC+1), FQ(QFILT+VC+1)))
      DO 10 K = 1, 3
        RCTL(AT+K) = FQ(QFILT+VC+K)/R
   10 CONTINUE
      RCTL(AT+4) = TSDOT(RCTL(AT+1), X(1,1))
      DO 20 I = 2, CTL(NP)
        RCTL(AT+4) = MAX(RCTL(AT+4), TSDOT(RCTL(AT+1), X(1,I)))
   20 CONTINUE
      CALL TSCHCA(BOX, RCTL, HNT, IQ, FQ)
      IF (IQ(QHASCA) .EQ. 1) THEN
        RCTL(RCAPLI) = CAPGRO*RCTL(RCAPLI)
        RCTL(RBIGBA) = BIG
      ELSE
        RCTL(RCAPLI) = 2.0D0*RCTL(RCAPLI)
        HNT(NPLANE) = HNT(NPLANE) - 1
      END IF
      END

C     ------------------------------------------------------------------
C     Limbs, and views of clumps
C
C     FOR points that doubles do not tell apart: without balls by limbs
C     a turned grid takes 2.9 times the instructions.
C
C     IDEA.  Where the bounds of doubles leave a comparison undecided, a
C     few leading limbs decide it nearly always, in a tenth of the time
C     of the exact signs.  If many comparisons are hard, the ball itself
C     is found by limbs, so that fewer points pass the filter.  And
C     where points are very unevenly far from the base, as when some
C     have a number for a missing coordinate (-3.4E38), what is lost in
C     the roundings of that distance is seen from a vertex that is near.
C
C       hard              said of an undecided comparison that is no
C                         exact tie
C       clump             a box that is very narrow beside the root's
C       view              a test of a point or a box as seen from
C                         another point than the base
C
C     HOOKS: TSCLUM, TSXCLU; TSDLIM and TSNOTC, in TSCMPE; TSREFB.
C     STATE: in HNT, RCTL, IQ, FQ.
C     INVARIANTS.  While IQ(QBYLIM) is 1, the filter is the ball of the
C     best point by limbs, and behind FQ(QLBALL) are its limbs;
C     IQ(QOUTSI) is not inside of it.
C
C     In HNT:
C       LASTTI = 260 limbs.last_tied  1: the last exact comparison was a
C               tie
C     In RCTL:
C       RCLUMP = 138 limbs.clump_width  a narrower box is a clump; 0:
C               there are none
C     In IQ:
C       QOUTSI = 14  limbs.outside_ball  a point not in the ball by
C               limbs, or 0
C       QBEHIN = 15  limbs.behind_facet  a point not on the open side,
C               or 0
C       QHARD  = 16  limbs.hard_count  hard comparisons: see LIMBAF
C     In FQ:
C       QLBALL = 32  limbs.ball  behind it the ball by limbs, LBALL
C               long, if QBYLIM is 1
C       QNSPH  = 117 limbs.near_sphere  behind it a sphere, LSPHER long,
C               near the points that are compared: see HHRELA
C     Constants:
C       BERMAX = 1.0D0 BALL_ERR_MAX  the best point's ball is found by
C               limbs if the error of its L-coordinate exceeds BERMAX
C               times L plus the circumradius (with 1E-4 a plane across
C               an axis, with noise of 1E-12, takes 5 times as long),
C       LIMBAF = 96  LIMB_BALL_AFTER  or after LIMBAF comparisons by
C               HHRELA.  An exact comparison that was no tie counts as
C       EXCNTS = 16  EXACT_COUNTS  EXCNTS of these; most ties take no
C               time, as their points are the corners of a box.  They
C               trade balls by limbs against exact signs
C       CLMPWI = 1.0D-12 CLUMP_WIDTH  a node is a clump if its box is
C               narrower than CLMPWI times the root's.  Among points 10
C               apart, coordinates of -1E10 are no reason for TSXVIE;
C               with it those of -1E14 take 0.6 of the time, those of
C               -1E18 a fiftieth.  With 1E-8, points of a sphere that
C               crowd about a spot would be clumps, get no reference
C               sphere, and take twice as long
C     ------------------------------------------------------------------

C     TSCLUM (measure_clumps) - sets the width below which a box is a
C     clump: CLMPWI times the root's, if 4 of 16 leaves are so narrow.
C     That is so where a coordinate of many points is a number that
C     stands for none, like -3.4E38; else there are no clumps, and
C     TSXVIE costs nothing.
      SUBROUTINE TSCLUM(BOX, CTL, RCTL)
      DOUBLE PRECISION BOX(6,*), RCTL(*)
      INTEGER CTL(*)
      INTEGER LEAVES, RCLUMP
      DOUBLE PRECISION CLMPWI
      PARAMETER (LEAVES = 4, RCLUMP = 138, CLMPWI = 1.0D-12)
      DOUBLE PRECISION TSWIDT
      INTEGER K, LEAF, N
      RCTL(RCLUMP) = CLMPWI*TSWIDT(BOX(1,1))
      N = 0
      DO 10 K = 0, 15
        LEAF = CTL(LEAVES)/16*K + MOD(CTL(LEAVES), 16)*K/16
        IF (TSWIDT(BOX(1,CTL(LEAVES)+LEAF)) .LT. RCTL(RCLUMP)) N = N + 1
   10 CONTINUE
      IF (N .LT. 4) RCTL(RCLUMP) = 0.0D0
      END

C     TSBALL (ball_by_limbs) - finds the ball of the best point by
C     limbs.  The centre C errs by at most 8 EPS |C|.  So its height
C     over the facet's plane, C.V, is L up to the error of V, E |C|, the
C     error of C, and the roundings of three products and two sums, 5
C     EPS |C|_1.  Near a sphere L is counted from the centre behind
C     F(FCEN): U, the difference, takes the place of C, with the error
C     of that centre and one more rounding.
      SUBROUTINE TSBALL(P, ORD, CTL, SUP, IQ, FQ)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION P(3,*), SUP(*), FQ(LFQ)
      INTEGER ORD(*), CTL(*), IQ(LIQ)
      INTEGER SCALE, VC, VDC, VC1, FNORM, FCEN, FE, FDC, QFACET, QBEST,
     $    QBYLIM, QHASBA, QBASE, QSURF, QOUTSI, QHH, QFILT, QLBALL, QLO,
     $    QHI
      DOUBLE PRECISION HUGE, EPS, HHEMAX
      PARAMETER (SCALE = 13, VC = 0, VDC = 4, VC1 = 5, FNORM = 0,
     $    FCEN = 3, FE = 10, FDC = 11, QFACET = 0, QBEST = 4,
     $    QBYLIM = 8, QHASBA = 7, QBASE = 5, QSURF = 17, QOUTSI = 14,
     $    QHH = 0, QFILT = 14, QLBALL = 32, QLO = 13, QHI = 14,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023, EPS = 2.0D0**(-52),
     $    HHEMAX = 0.5D0)
      DOUBLE PRECISION C(3), ERR, L, SIZE, U
      INTEGER TSONSP, K, OK, SPHERE
      IF (FQ(QHH+FE) .GE. HUGE) RETURN
      CALL HHCENT(P, ORD, CTL(SCALE), IQ(QFACET+1), IQ(QBASE),
     $            IQ(QBEST), C, FQ(QLBALL+1), OK)
      IF (OK .EQ. 0) RETURN
      SPHERE = TSONSP(SUP, IQ(QSURF))
      IQ(QBYLIM) = 1
      IQ(QHASBA) = 1
      IQ(QOUTSI) = 0
      FQ(QFILT+VC1) = 0.0D0
      SIZE = 0.0D0
      L = 0.0D0
      DO 10 K = 1, 3
        FQ(QFILT+VC+K) = C(K)
        FQ(QFILT+VC1) = FQ(QFILT+VC1) + ABS(C(K))
        U = C(K)
        IF (SPHERE .EQ. 1) U = U - FQ(QHH+FCEN+K)
        SIZE = SIZE + ABS(U)
        L = L + FQ(QHH+FNORM+K)*U
   10 CONTINUE
      FQ(QFILT+VDC) = 8.0D0*EPS*FQ(QFILT+VC1)
      ERR = FQ(QHH+FE)*SIZE + 16.0D0*EPS*FQ(QFILT+VC1)
      IF (SPHERE .EQ. 1) ERR = ERR + FQ(QHH+FDC)
      IF (FQ(QHH+FE) .LE. HHEMAX) THEN
        FQ(QLO) = MAX(FQ(QLO), L - ERR)
        FQ(QHI) = MIN(FQ(QHI), L + ERR)
      END IF
      L = FQ(QHI)
      IF (IQ(QSURF) .NE. 0) CALL TSSFFI(SUP, IQ, FQ)
      END

C     TSXVIE (excludes_by_view) - tests the box LOW, HIGH as seen from
C     other points than the base.  Returns -1 if it provably holds no
C     better point, 1 if it is a point that is certainly on the open
C     side (of a wider box that tells nothing), else 0.
C
C     What is near another vertex has a side and a power that are lost
C     in the roundings of its distance from the base, where that is so
C     much greater.  Seen from that vertex, or from the best point, both
C     are sums of small terms.  Let P be a point whose power in the ball
C     of centre C is known to be 0, or not negative.  With U = Z - P and
C     D = C - P, both from the base, the power of Z is at least |U|**2 -
C     2 D.U.  So Z is not better if that is positive: as in TSXBOX, the
C     least sum in the box less its error.  Likewise for the side of Z
C     if that of P is 0 or negative, with the product of the normal and
C     U.
C
C     Each coordinate of HHCENT's C is right to 8 EPS of itself, and P
C     to 1 EPS: D errs by 9 EPS |C| + 2 EPS |P|, which counts twice; U
C     by EPS |U|, which counts for 2 EPS (|U| + |D|); four roundings for
C     4 EPS (|U| + 2 |D|).  All that times |U| is less than 8 EPS |U|
C     (|U| + 4 (|C| + |P|)), coordinate by coordinate: where points
C     differ from P only in coordinates in which the ball is small, they
C     are told apart, however large it is in the others.  (4 |X|, X
C     being the coordinate itself, is for sums in another order.)
      INTEGER FUNCTION TSXVIE(X, IQ, FQ, LOW, HIGH)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), FQ(LFQ), LOW(3), HIGH(3)
      INTEGER IQ(LIQ)
      INTEGER VC, FNORM, FBASE, FE, QFACET, QBEST, QBYLIM, QBASE,
     $    QOUTSI, QBEHIN, QHH, QFILT
      DOUBLE PRECISION EPS, HHEMAX, UNDERR
      PARAMETER (VC = 0, FNORM = 0, FBASE = 6, FE = 10, QFACET = 0,
     $    QBEST = 4, QBYLIM = 8, QBASE = 5, QOUTSI = 14, QBEHIN = 15,
     $    QHH = 0, QFILT = 14, EPS = 2.0D0**(-52), HHEMAX = 0.5D0,
     $    UNDERR = 1.0D-200)
      DOUBLE PRECISION D, ERR, H, L, P, POWER, SIDE, SIZE, U
      INTEGER FROM(5), I, K
      FROM(1) = IQ(QFACET+MOD(IQ(QBASE),3)+1)
      FROM(2) = IQ(QFACET+MOD(IQ(QBASE)+1,3)+1)
      FROM(3) = IQ(QBEHIN)
      FROM(4) = IQ(QBYLIM)*IQ(QOUTSI)
      FROM(5) = IQ(QBYLIM)*IQ(QBEST)
      TSXVIE = 0
      DO 20 K = 1, 5
        IF (FROM(K) .EQ. 0) GO TO 20
        POWER = 0.0D0
        SIDE = 0.0D0
        SIZE = 0.0D0
        ERR = UNDERR
        DO 10 I = 1, 3
          P = X(I,FROM(K)) - FQ(QHH+FBASE+I)
          D = FQ(QFILT+VC+I) - P
          L = LOW(I) - X(I,FROM(K))
          H = HIGH(I) - X(I,FROM(K))
          U = MIN(MAX(D, L), H)
          POWER = POWER + U*(U - 2.0D0*D)
          SIDE = SIDE + MAX(L*FQ(QHH+FNORM+I), H*FQ(QHH+FNORM+I))
          U = MAX(ABS(L), ABS(H))
          SIZE = SIZE + U
          ERR = ERR + 8.0D0*EPS*U*(U + 4.0D0*(ABS(FQ(QFILT+VC+I)) +
     $        ABS(P) + ABS(X(I,FROM(K)))))
   10   CONTINUE
        IF (K .NE. 3 .AND. IQ(QBYLIM) .EQ. 1 .AND. POWER .GT. ERR)
     $      GO TO 30
        IF (K .GT. 3 .OR. FQ(QHH+FE) .GT. HHEMAX) GO TO 20
        IF (SIDE .LT. -FQ(QHH+FE)*SIZE - UNDERR) GO TO 30
        IF (K .LT. 3 .AND. SIDE .GT. FQ(QHH+FE)*SIZE + UNDERR)
     $      TSXVIE = 1
   20 CONTINUE
      RETURN
   30 TSXVIE = -1
      END

C     TSXCLU (excludes_clump) - returns 1 if the box B is a clump that
C     holds no better point, as seen from other points than the base, or
C     0.
      INTEGER FUNCTION TSXCLU(X, RCTL, IQ, FQ, B)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), RCTL(*), FQ(*), B(6)
      INTEGER IQ(LIQ)
      INTEGER RCLUMP, QCOLL
      PARAMETER (RCLUMP = 138, QCOLL = 11)
      DOUBLE PRECISION TSWIDT
      INTEGER TSXVIE
      TSXCLU = 0
      IF (IQ(QCOLL) .NE. 0) RETURN
      IF (TSWIDT(B) .GE. RCTL(RCLUMP)) RETURN
      IF (TSXVIE(X, IQ, FQ, B(1), B(4)) .LT. 0) TSXCLU = 1
      END

C     TSREFB (refine_ball) - finds the ball of the best point by limbs
C     if that of doubles is poor, or if many comparisons were hard.
C     SIDE: that of a new best point; of one that stays, UNSURE.
      SUBROUTINE TSREFB(P, ORD, CTL, SUP, IQ, FQ, SIDE)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION P(3,*), SUP(*), FQ(LFQ)
      INTEGER ORD(*), CTL(*), IQ(LIQ), SIDE
      INTEGER FRHO, QBYLIM, QHARD, QHH, QLO, QHI, LIMBAF
      DOUBLE PRECISION BERMAX
      PARAMETER (FRHO = 12, QBYLIM = 8, QHARD = 16, QHH = 0, QLO = 13,
     $    QHI = 14, BERMAX = 1.0D0, LIMBAF = 96)
      IF (IQ(QBYLIM) .EQ. 1) RETURN
      IF (SIDE .EQ. 0 .OR. IQ(QHARD) .GE. LIMBAF) THEN
        CALL TSBALL(P, ORD, CTL, SUP, IQ, FQ)
      ELSE IF (SIDE .EQ. 1) THEN
        IF (FQ(QHI) - FQ(QLO) .GT. BERMAX*(FQ(QHH+FRHO) + ABS(FQ(QHI))))
     $      CALL TSBALL(P, ORD, CTL, SUP, IQ, FQ)
      END IF
      END

C     TSDLIM (decide_by_limbs) - decides what it can of what is UNSURE,
C     SIDE or VERDIC, before the exact signs do.  Among clumps Z is seen
C     from other points first.  Then comes HHRELA, unless determinants
C     are exact in doubles or the last exact comparison was a tie.
C     Without it rotated grids, whose boxes have their corners on a
C     sphere but for rounding, take 1.2 to 1.6 times the instructions.
C     Its sphere is that of Z or of the best point, but not of a ball by
C     limbs, whose four points are nearly in a plane.  Last come the
C     limbs of the ball, if it was found by limbs.  OUT is 1 if Z is not
C     better, or 0.
      SUBROUTINE TSDLIM(X, P, ORD, RCTL, HNT, IQ, FQ, Z, HI, SIDE,
     $                  VERDIC, OUT)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), FQ(LFQ), HI
      INTEGER ORD(*), HNT(*), IQ(LIQ), Z, SIDE, VERDIC, OUT
      INTEGER LASTTI, EXACT3, EXACT5, RCLUMP, QFACET, QBEST, QBYLIM,
     $    QBASE, QOUTSI, QHH, QLBALL, QNSPH, QHI, UNSURE, LOSES
      DOUBLE PRECISION HUGE
      PARAMETER (LASTTI = 260, EXACT3 = 1, EXACT5 = 2, RCLUMP = 138,
     $    QFACET = 0, QBEST = 4, QBYLIM = 8, QBASE = 5, QOUTSI = 14,
     $    QHH = 0, QLBALL = 32, QNSPH = 117, QHI = 14, UNSURE = 2,
     $    LOSES = 1, HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      DOUBLE PRECISION L
      INTEGER TSXVIE, BEST, SEEN
      BEST = IQ(QBEST)
      OUT = 0
      IF (RCTL(RCLUMP) .GT. 0.0D0 .AND. (SIDE .EQ. UNSURE .OR.
     $    IQ(QBYLIM) .EQ. 1)) THEN
        SEEN = TSXVIE(X, IQ, FQ, X(1,Z), X(1,Z))
        IF (SEEN .LT. 0) THEN
          OUT = 1
          RETURN
        END IF
        IF (SEEN .GT. 0) SIDE = 1
      END IF
      IF (VERDIC .EQ. UNSURE .AND. RCTL(EXACT5) .LT. 0.0D0 .AND.
     $    HNT(LASTTI) .EQ. 0) THEN
        L = FQ(QHI)
        IF (IQ(QBYLIM) .EQ. 1) L = HUGE
        IF (SIDE .EQ. 1) L = HI
        CALL HHRELA(X, RCTL(EXACT3), IQ(QFACET+1), IQ(QBASE), FQ(QHH+1),
     $              L, BEST, Z, FQ(QNSPH+1), VERDIC)
      END IF
      IF (IQ(QBYLIM) .EQ. 1) CALL HHTRIA(P, ORD, FQ(QLBALL+1), Z, SIDE,
     $    VERDIC)
      IF (VERDIC .EQ. LOSES) IQ(QOUTSI) = Z
      END

C     TSNOTC (note_comparison) - keeps what a comparison with Z has
C     shown.  HARD is 0 if doubles decided VERDIC, 1 if limbs did, 2 if
C     the exact signs did.
      SUBROUTINE TSNOTC(HNT, IQ, Z, SIDE, VERDIC, HARD)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      INTEGER HNT(*), IQ(LIQ), Z, SIDE, VERDIC, HARD
      INTEGER LASTTI, QHARD, QOUTSI, QBEHIN, EXCNTS, TIE
      PARAMETER (LASTTI = 260, QHARD = 16, QOUTSI = 14, QBEHIN = 15,
     $    EXCNTS = 16, TIE = 3)
      IF (SIDE .LT. 1) IQ(QBEHIN) = Z
      IF (SIDE .NE. 1) RETURN
      IF (HARD .EQ. 2) THEN
        HNT(LASTTI) = ABS(VERDIC)/TIE
        IF (VERDIC .GT. 0) IQ(QOUTSI) = Z
        IQ(QHARD) = IQ(QHARD) + EXCNTS*(1 - HNT(LASTTI))
      ELSE
        IQ(QHARD) = IQ(QHARD) + HARD
      END IF
      END

C     ------------------------------------------------------------------
C     Reference surfaces
C
C     FOR points that are near one of a few planes or spheres, but for
C     rounding: globes, turned boxes, points near a plane.  Without them
C     points near a tilted plane take 17 times the instructions.  They
C     cost a mark a point, two integers a leaf for each, and a height by
C     limbs for each point near them, once; nothing until searches turn
C     out to be long.
C
C     IDEA.  Where many points are near one plane or sphere, the side or
C     the power of each is noise for a facet of three of them, and no
C     box of points is clear of the ball.  A reference surface is such a
C     plane or sphere, through points.  Limbs give the heights of other
C     points over it (over a sphere, their powers) to some EPS of
C     themselves.  Heights are that noise, but known to 1E-7 of it: so
C     they decide, point by point and node by node.
C
C     Let h be the height of the base of a facet near the surface,
C     T(VBASEH), and tilt the vector in the facet's plane whose products
C     with the facet's edges are the differences of heights.  Then
C         G(W) = height(W) - h - tilt.W
C     is 0 at the facet's vertices.  On a plane, G(W) is therefore g
C     times the side of W, g being the height of the facet's normal V,
C     T(TNORMH).  On a sphere whose centre is at height l over the
C     facet's plane, G(W) is the power of W in the ball of L = l, and
C     L(W) = l + e, e = G(W) / (2 side).
C
C       reference surface    a plane or a sphere that many points are
C                         near
C       height            over it: the signed distance, or the power, by
C                         limbs
C       band              the heights that have a mark: those of points
C                         near it
C       mark              a point's height in units of the surface's
C                         quantum
C       tilt              the vector in the facet's plane that takes up
C                         the different heights of its vertices
C       surface filter    a filter with a term in the height
C       sample            undecided points, from which a surface is
C                         fitted
C
C     HOOKS: TSCHOS, TSBONS, TSSFFI when a search begins or its ball
C     changes; TSXMRK where nodes are tested (points in TSOFFP itself),
C     TSSHAR where points are compared; TSADDS and TSSEEK; TSRMRK.  Part
C     III calls TSSURV and TSSOFI.
C     STATE: in HNT, RCTL, SUP, IQ, FQ, and MARK.
C     INVARIANTS.  A search with a surface uses no near list, cylinder
C     or cap, and has two filters, each true by itself: the plain one,
C     and the surface filter, which serves what has a mark of that
C     surface.  A mark is right to 3/2 quanta, the range of a node's
C     marks is that of all its points; all that a surface is made of is
C     in its record.
C
C     Of MARK and SUP:
C       MARK   array mark  position -> 0 or surface + SURFS mark
C       MARK   array record  behind MARK(TSRCRD(CTL,J)) the record of
C               surface J,
C       MARK   array mark_range  behind that, of each node (K + 1)
C               (RSTEPS + 2) + L + 1: K and L are the least and the
C               greatest mark of its points, over MARKST; K is -1 if a
C               point may be below SLOWES, L is RSTEPS if one may be
C               above -SLOWES; RSTEPS and -1 for K and L if all are
C       SUP    array surfaces.surface  the reference surfaces, SUP(.,J)
C     In HNT:
C       NSURF  = 261 surfaces.known  how many reference surfaces there
C               are
C     In RCTL:
C       RSLOAD = 139 surfaces.load  how many points searches have
C               offered to samples, if more than SAMMIN, over NP
C       RSLIMI = 140 surfaces.limit  a load above this seeks a surface;
C               0: no more surfaces are sought
C     SUP(.,J), reference surface J: a plane or a sphere that many
C     points are near.  A point with mark K, 0 ... MARKS - 1, has a
C     height between SLOWES + (K - 1/2) SQUANT and SLOWES + (K + 3/2)
C     SQUANT.
C       LSUP   = 60  -  its length
C       SUP    array limbs  it begins with the surface by limbs, LSPHER
C               long: see HHSURF
C       SPLANE = 8   plane  of it, 1: a plane; 0: a sphere
C       SORIGI = 52  origin  behind it the coordinates of its first
C               point
C       SC     = 55  c  behind it the unit normal, or the centre seen
C               from SORIGI
C       SLOWES = 59  lowest  the least height that has a mark; it is
C               negative
C       SQUANT = 60  quantum  the unit of marks
C     In IQ:
C       QSURF  = 17  surface.number  the number of the reference
C               surface, or 0
C       QUNDEC = 18  surface.undecided  1: the sample has undecided
C               points; 0: only first points of visited leaves
C       QOFFER = 19  surface.offered  how many points were offered to
C               the sample
C       QSAMPL = 19  surface.sample  behind it the points that the
C               sample keeps
C     In FQ:
C       QTILT  = 169 surface.filter  behind it T, LTILT long: the filter
C               with heights first
C     T, of the facet's reference surface: it begins with the surface
C     filter, see TSSFFI.
C       LTILT  = 14  -  its length
C       THEIGE = 9   surface.height_err  a bound on the error of the
C               base's height
C       TTILT  = 9   surface.tilt  behind it the tilt: height(W) - base
C               height - tilt.W is 0 at the facet's vertices
C       TTILTE = 13  surface.tilt_err  a bound on the error of the tilt
C       TNORMH = 14  surface.normal_height  of a plane: the height of
C               the facet's normal
C     The record of a surface, see TSRCRD:
C       LRECRD = 16  RECORD  its length
C       RECPT  = 1   RECORD_POINT  the position of its first point
C       RECPLN = 2   RECORD_PLANE  1 for a plane
C       RECQUA = 3   RECORD_QUANTUM  the exponent of the quantum, plus
C               EXPON
C       RECEXP = 4   RECORD_UNIT  that of the unit of the normal or
C               centre, plus EXPON; behind it the three coordinates in
C               these units, DIGITS digits each
C     The format of its numbers:
C       DIGITS = 4   DIGITS  digits of a number
C       DIGIT  = 8192.0D0 DIGIT  their base
C       EXPON  = 2000 EXPONENT  what is added to exponents
C     Constants:
C       SURFS  = 8   SURFACES  maximum number of reference surfaces.
C               The layout of an index rests on it
C       MARKS  = 134217728 MARKS  number of marks, the heights that a
C               surface tells apart.  A double holds them and their
C               roundings, and an integer SURFS (MARKS + 1): correctness
C               rests on that
C       RSTEPS = 32768 RANGE_STEPS  of a node's range of marks so many
C               steps are told apart,
C       MARKST = 4096 MARKS_PER_STEP  each of so many marks.  (RSTEPS +
C               2)**2 fits an integer: correctness rests on that
C       SAMMIN = 24  SAMPLE_MIN  a search counts as long if it offers
C               more than SAMMIN = 3/4 SAMSIZ points to its sample
C       SAMLIM = 1.0D0 SAMPLE_LIMIT  a surface is sought once these
C               offers add up to SAMLIM times all points; each failure
C               doubles that limit
C       FINBY  = 100.0D0 FINER_BY  a surface whose quantum is so many
C               times smaller takes over the points that another has
C               marked: without that two sheets 1E-12 apart take 3.5
C               times as long
C       PLBAND = 2.0D-8 PLANE_BAND  half of the band about a plane, at
C               most, in units of its extent.  Beyond it doubles decide
C               the sides, and cylinders do better: points near a plane
C               that is rough by 1E-8 take two thirds of the time
C               without a surface, by 1E-9 as long, by 1E-10 twice as
C               long
C       SPBAND = 1.0D-3 SPHERE_BAND  that of a sphere, in units of the
C               extent's square.  It is wider, as cylinders do not tell
C               its balls apart
C       SAMSIZ = 32  SAMPLE_SIZE  places of a sample: stack against the
C               quality of a fit
C       LINEWI = 1.0D-6 LINE_WIDTH  a sample narrower than this, beside
C               its width, is on a line;
C       PLANWI = 1.0D-7 PLANE_WIDTH  thinner than this it is in a plane,
C               and no sphere is fitted
C       SLIVRE = 1.0D-3 SLIVER_E  a facet with a greater E, a sliver,
C               has no surface: see TSCHOS
C       EXACTU = 16.0D0 EXACT_UNITS  no surface is sought if EXACT5 is
C               at least this: coordinates are then small multiples of
C               one unit, and doubles compute determinants exactly, so
C               that heights would add nothing
C       REGIO  = 32  REGIONS  TESSIX seeks surfaces in the stars of up
C               to REGIO points, eight at a time,
C       STARS  = 256 STARS  with room for STARS tetrahedra,
C       KEEN   = SAMLIM/256.0D0 KEEN  and from a lower limit, as it does
C               so for all parts.  They trade its time against the
C               surfaces that it finds
C     ------------------------------------------------------------------

C     TSROUN (rounded_height) - H is the height of the position Z over
C     the surface S, in double precision.  ERR bounds its error: 6
C     roundings of a square and 5 of twice a product with the centre,
C     which is exact, as the surface is made of it.
      SUBROUTINE TSROUN(X, S, Z, H, ERR)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      DOUBLE PRECISION X(3,*), S(LSUP), H, ERR
      INTEGER Z
      INTEGER SPLANE, SORIGI, SC
      DOUBLE PRECISION EPS, UNDERR
      PARAMETER (SPLANE = 8, SORIGI = 52, SC = 55, EPS = 2.0D0**(-52),
     $    UNDERR = 1.0D-200)
      DOUBLE PRECISION SPREAD, SIZE, U
      INTEGER K
      H = 0.0D0
      SIZE = 0.0D0
      SPREAD = S(SPLANE)
      DO 10 K = 1, 3
        U = X(K,Z) - S(SORIGI+K)
        SIZE = SIZE + ABS(U)
        IF (S(SPLANE) .GT. 0.0D0) THEN
          H = H + U*S(SC+K)
        ELSE
          H = H + U*(U - 2.0D0*S(SC+K))
          SPREAD = SPREAD + (ABS(U) + ABS(S(SC+K)))
        END IF
   10 CONTINUE
      ERR = 32.0D0*EPS*SIZE*SPREAD + UNDERR
      END

C     TSMRKH (marked_height) - OK is 1 if the position Z has a mark of
C     surface J, or 0; H is then its height, to a quantum.  The
C     roundings of TSMLEA and the error of the height shift a mark by
C     less than 10 EPS MARKS quanta.
      SUBROUTINE TSMRKH(MARK, SUP, J, Z, H, OK)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      DOUBLE PRECISION SUP(LSUP,*), H
      INTEGER MARK(*), J, Z, OK
      INTEGER SLOWES, SQUANT, SURFS
      PARAMETER (SLOWES = 59, SQUANT = 60, SURFS = 8)
      INTEGER K
      K = MARK(Z) - J
      OK = 0
      IF (K .LT. 0 .OR. MOD(K, SURFS) .NE. 0) RETURN
      H = SUP(SLOWES,J) + SUP(SQUANT,J)*(DBLE(K/SURFS) + 0.5D0)
      OK = 1
      END

C     TSHEOV (height_over) - OK is 1 if the position Z is near surface
C     J, or 0; H is then its height, from its mark or else by limbs, and
C     ERR bounds the error.
      SUBROUTINE TSHEOV(X, MARK, SUP, J, Z, H, ERR, OK)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      DOUBLE PRECISION X(3,*), SUP(LSUP,*), H, ERR
      INTEGER MARK(*), J, Z, OK
      INTEGER SLOWES, SQUANT
      PARAMETER (SLOWES = 59, SQUANT = 60)
      ERR = SUP(SQUANT,J)
      CALL TSMRKH(MARK, SUP, J, Z, H, OK)
      IF (OK .EQ. 1) RETURN
      CALL TSROUN(X, SUP(1,J), Z, H, ERR)
      IF (ABS(H) .GT. ERR - SUP(SLOWES,J)) RETURN
      CALL HHHEIG(X, SUP(1,J), Z, H, ERR)
      IF (ERR .LE. SUP(SQUANT,J) .AND. ABS(H) .LE. -SUP(SLOWES,J)) OK =
     $    1
      END

C     TSFONS (facet_on_surface) - OK is 1 if the facet's vertices are
C     near surface J, or 0; H are their heights, the base's first, ERR
C     the bounds on their errors.
      SUBROUTINE TSFONS(X, MARK, SUP, IQ, J, H, ERR, OK)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), SUP(*), H(3), ERR(3)
      INTEGER MARK(*), IQ(LIQ), J, OK
      INTEGER QFACET, QBASE
      PARAMETER (QFACET = 0, QBASE = 5)
      INTEGER K, Z
      DO 10 K = 1, 3
        Z = IQ(QFACET+MOD(IQ(QBASE)+K-2,3)+1)
        CALL TSHEOV(X, MARK, SUP, J, Z, H(K), ERR(K), OK)
        IF (OK .EQ. 0) RETURN
   10 CONTINUE
      END

C     TSONSP - returns 1 if surface J is a sphere, or 0, also if J is 0.
      INTEGER FUNCTION TSONSP(SUP, J)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      INTEGER J
      DOUBLE PRECISION SUP(LSUP,*)
      INTEGER SPLANE
      PARAMETER (SPLANE = 8)
      TSONSP = 0
      IF (J .EQ. 0) RETURN
      IF (SUP(SPLANE,J) .LE. 0.0D0) TSONSP = 1
      END

C     TSADDS (add_to_sample) - adds Z to the sample: undecided points
C     or, until there are any, first points of leaves that the search
C     visited.  The sample keeps SAMSIZ of them.  Once it is full, a
C     point replaces another at random (reservoir sampling: J. S.
C     Vitter, ACM Trans.  Math. Software 11, 1985, 37-57), by numbers
C     that are the same on every machine.  Points with a mark count,
C     too: they may be near a finer surface.
      SUBROUTINE TSADDS(IQ, Z, OPEN)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      INTEGER IQ(LIQ), Z, OPEN
      INTEGER QUNDEC, QOFFER, QSAMPL, SAMSIZ
      PARAMETER (QUNDEC = 18, QOFFER = 19, QSAMPL = 19, SAMSIZ = 32)
      INTEGER PLACE
      IF (IQ(QOFFER) .EQ. 0 .OR. OPEN .GT. IQ(QUNDEC)) THEN
        IQ(QUNDEC) = OPEN
        IQ(QOFFER) = 0
      END IF
      IF (OPEN .LT. IQ(QUNDEC)) RETURN
      IQ(QOFFER) = IQ(QOFFER) + 1
      PLACE = IQ(QOFFER)
      IF (PLACE .GT. SAMSIZ)
     $    PLACE = MOD(MOD(MOD(Z - 1, 30269)*137, 30269), IQ(QOFFER)) + 1
      IF (PLACE .LE. SAMSIZ) IQ(QSAMPL+PLACE) = Z
      END

C     TSRCRD (surface_record) - returns the place in MARK before the
C     record of surface J.  Behind the marks of the points each has
C     LRECRD integers, then the nodes' ranges of marks, from node 1 on:
C       RECPT   the position of its first point
C       RECPLN  1 for a plane
C       RECQUA  the exponent of the quantum, plus EXPON
C       RECEXP  that of the unit of the normal or centre, plus EXPON;
C               behind it its three coordinates in these units, DIGITS
C               digits each
C     So all that a surface is made of is read, and comes out alike in
C     all rounding modes and builds: marks of one sphere say nothing of
C     another.
      INTEGER FUNCTION TSRCRD(CTL, J)
      INTEGER CTL(*), J
      INTEGER NP, LEAVES, LRECRD
      PARAMETER (NP = 1, LEAVES = 4, LRECRD = 16)
      TSRCRD = CTL(NP) + (J - 1)*(2*CTL(LEAVES) + (LRECRD - 1))
      END

C     TSSFRC (surface_from_record) - sets up the surface S from its
C     record.  OK is 1, or 0 if limbs do not hold it.
      SUBROUTINE TSSFRC(X, RECORD, S, OK)
      INTEGER LSUP, LRECRD
      PARAMETER (LSUP = 60, LRECRD = 16)
      DOUBLE PRECISION X(3,*), S(LSUP)
      INTEGER RECORD(LRECRD), OK
      INTEGER SORIGI, SC, SLOWES, SQUANT, RECPT, RECPLN, RECQUA, RECEXP,
     $    DIGITS, EXPON, MARKS
      DOUBLE PRECISION DIGIT
      PARAMETER (SORIGI = 52, SC = 55, SLOWES = 59, SQUANT = 60,
     $    RECPT = 1, RECPLN = 2, RECQUA = 3, RECEXP = 4, DIGITS = 4,
     $    DIGIT = 8192.0D0, EXPON = 2000, MARKS = 134217728)
      DOUBLE PRECISION HHLDEX, C(3)
      INTEGER I, K
      S(SQUANT) = HHLDEX(1.0D0, RECORD(RECQUA) - EXPON)
      S(SLOWES) = -0.5D0*S(SQUANT)*DBLE(MARKS)
      DO 20 K = 1, 3
        S(SORIGI+K) = X(K,RECORD(RECPT))
        C(K) = 0.0D0
        DO 10 I = RECEXP + DIGITS*K, RECEXP + 1 + DIGITS*(K - 1), -1
          C(K) = (C(K) + DBLE(RECORD(I)))/DIGIT
   10   CONTINUE
        C(K) = HHLDEX(C(K), RECORD(RECEXP) - EXPON)
        S(SC+K) = C(K)
   20 CONTINUE
      CALL HHSURF(X, RECORD(RECPT), RECORD(RECPT), RECORD(RECPLN), C, S,
     $            OK)
      END

C     TSTHRO (surface_through) - sets up the surface S, a plane or a
C     sphere through the positions Z, for a search's sample, of extent
C     WIDE.  Any plane or sphere near the points will do, so its normal
C     or centre is the 52 leading bits of what doubles hold; of HHTHIN's
C     facet the normal alone counts, so Z(1) may be its base.  Its band
C     is 8 to 16 times the upper quartile of the sample's heights, or
C     the lower one if that is FINBY times less, but not 0: the points
C     on one of several near sheets.  (If a quarter of the heights are
C     0, the quantum comes from the others: it only has to tell the
C     sheets apart.)  OK is 1, or 0 if the band is wider than PLBAND or
C     SPBAND allows.
      SUBROUTINE TSTHRO(X, P, ORD, CTL, IQ, Z, WIDE, PLANE, RECORD, S,
     $                  OK)
      INTEGER LSUP, LBALL, LF, LIQ, LRECRD, SAMSIZ
      PARAMETER (LSUP = 60, LBALL = 85, LF = 12, LIQ = 51, LRECRD = 16,
     $    SAMSIZ = 32)
      DOUBLE PRECISION X(3,*), P(3,*), WIDE, S(LSUP)
      INTEGER ORD(*), CTL(*), IQ(LIQ), Z(4), PLANE, RECORD(LRECRD), OK
      INTEGER SCALE, SLOWES, QOFFER, QSAMPL, RECPT, RECPLN, RECQUA,
     $    RECEXP, DIGITS, EXPON, MARKS
      DOUBLE PRECISION DIGIT, FINBY, PLBAND, SPBAND, UNDERR
      PARAMETER (SCALE = 13, SLOWES = 59, QOFFER = 19, QSAMPL = 19,
     $    RECPT = 1, RECPLN = 2, RECQUA = 3, RECEXP = 4, DIGITS = 4,
     $    DIGIT = 8192.0D0, EXPON = 2000, FINBY = 100.0D0,
     $    PLBAND = 2.0D-8, SPBAND = 1.0D-3, MARKS = 134217728,
     $    UNDERR = 1.0D-200)
      DOUBLE PRECISION HHLDEX, C(LF), D, ERR, H(SAMSIZ), T(LBALL)
      INTEGER HHFREX, I, K, N
      IF (PLANE .EQ. 1) THEN
        CALL HHTHIN(X, P, ORD, CTL(SCALE), Z(1), 1, C, OK)
      ELSE
        CALL HHCENT(P, ORD, CTL(SCALE), Z(1), 1, Z(4), C, T, OK)
      END IF
      IF (OK .EQ. 0) RETURN
      I = HHFREX(MAX(ABS(C(1)), ABS(C(2)), ABS(C(3))))
      RECORD(RECPT) = Z(1)
      RECORD(RECPLN) = PLANE
      RECORD(RECQUA) = EXPON
      RECORD(RECEXP) = EXPON + I
      DO 8 K = 1, 3
        D = HHLDEX(C(K), -I)
        DO 4 N = RECEXP + 1 + DIGITS*(K - 1), RECEXP + DIGITS*K
          D = D*DIGIT
          RECORD(N) = INT(D)
          D = D - DBLE(RECORD(N))
    4   CONTINUE
    8 CONTINUE
      CALL TSSFRC(X, RECORD, S, OK)
      IF (OK .EQ. 0) RETURN
      OK = 0
      N = MIN(IQ(QOFFER), SAMSIZ)
      DO 20 I = 1, N
        CALL HHHEIG(X, S, IQ(QSAMPL+I), D, ERR)
        D = ABS(D)
        IF (ERR .GT. 1.0D0) RETURN
        H(I) = D
        DO 10 K = I, 2, -1
          IF (H(K-1) .LE. D) GO TO 20
          H(K) = H(K-1)
          H(K-1) = D
   10   CONTINUE
   20 CONTINUE
      D = H(3*N/4+1)
      IF (H(N/4+1) .GT. 0.0D0 .AND. H(N/4+1) .LT. D/FINBY) D = H(N/4+1)
      RECORD(RECQUA) = EXPON + HHFREX(D*(16.0D0/DBLE(MARKS)) + UNDERR)
      CALL TSSFRC(X, RECORD, S, OK)
      D = PLBAND*WIDE
      IF (PLANE .EQ. 0) D = SPBAND*WIDE*WIDE
      IF (-S(SLOWES) .GT. D) OK = 0
      END

C     TSFIT (fit_surface) - sets up the surface S through points of a
C     search's sample that are far apart: a sphere, or a plane where the
C     points are on none (sheets near each other are one).  A sample of
C     several clumps is refused: from far enough all points are near
C     spheres that no search needs.  OK is 1 if it is set up, or 0.
      SUBROUTINE TSFIT(X, P, ORD, CTL, RCTL, IQ, RECORD, S, OK)
      INTEGER LIQ, SAMSIZ
      PARAMETER (LIQ = 51, SAMSIZ = 32)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), S(*)
      INTEGER ORD(*), CTL(*), IQ(LIQ), RECORD(*), OK
      INTEGER QFACET, QOFFER, QSAMPL, RCLUMP
      DOUBLE PRECISION LINEWI, PLANWI, LENMIN
      PARAMETER (QFACET = 0, QOFFER = 19, QSAMPL = 19, RCLUMP = 138,
     $    LINEWI = 1.0D-6, PLANWI = 1.0D-7, LENMIN = 2.0D0**(-450))
      DOUBLE PRECISION TSDOT, D, E(3), U(3,SAMSIZ), WIDE(3)
      INTEGER WIDEST, I, J, K, N, Z(4)
      OK = 0
      N = MIN(IQ(QOFFER), SAMSIZ)
      Z(1) = IQ(QFACET+1)
      DO 20 I = 1, N
        DO 10 K = 1, 3
          U(K,I) = X(K,IQ(QSAMPL+I)) - X(K,IQ(QFACET+1))
   10   CONTINUE
   20 CONTINUE
C     the farthest, then what is left across it
      DO 70 J = 1, 3
        WIDEST = 1
        DO 30 I = 1, N
          IF (TSDOT(U(1,I), U(1,I)) .GT.
     $        TSDOT(U(1,WIDEST), U(1,WIDEST))) WIDEST = I
   30   CONTINUE
        Z(J+1) = IQ(QSAMPL+WIDEST)
        WIDE(J) = SQRT(TSDOT(U(1,WIDEST), U(1,WIDEST)))
        IF (J .EQ. 3) GO TO 70
        IF (WIDE(J) .LE. LINEWI*WIDE(1) + LENMIN) RETURN
        IF (RCTL(RCLUMP) .GT. 0.0D0 .AND. WIDE(1) .GT. RCTL(RCLUMP))
     $    RETURN
        DO 40 K = 1, 3
          E(K) = U(K,WIDEST)/WIDE(J)
   40   CONTINUE
        DO 60 I = 1, N
          D = TSDOT(U(1,I), E)
          DO 50 K = 1, 3
            U(K,I) = U(K,I) - D*E(K)
   50     CONTINUE
   60   CONTINUE
   70 CONTINUE
      IF (WIDE(3) .GE. PLANWI*WIDE(1)) CALL TSTHRO(X, P, ORD, CTL, IQ,
     $    Z, WIDE(1), 0, RECORD, S, OK)
      IF (OK .EQ. 0) CALL TSTHRO(X, P, ORD, CTL, IQ, Z, WIDE(1), 1,
     $    RECORD, S, OK)
      END

C     TSMLEA (mark_leaf) - marks the points of a leaf that are certainly
C     near surface J and have no mark yet, or one of a surface FINBY
C     times coarser, and stores the leaf's range of marks.  NEAR
C     increases by how many it marked.
      SUBROUTINE TSMLEA(X, MARK, CTL, SUP, J, LEAF, NEAR)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      DOUBLE PRECISION X(3,*), SUP(LSUP,*)
      INTEGER MARK(*), CTL(*), J, LEAF, NEAR
      INTEGER SLOWES, SQUANT, LRECRD, SURFS, MARKS, RSTEPS, MARKST
      DOUBLE PRECISION FINBY
      PARAMETER (SLOWES = 59, SQUANT = 60, LRECRD = 16, SURFS = 8,
     $    FINBY = 100.0D0, MARKS = 134217728, RSTEPS = 32768,
     $    MARKST = 4096)
      DOUBLE PRECISION C, ERR, GRAIN, H, LOW
      INTEGER TSRCRD, FIRST, I, K, L, LAST, LEAST, MOST, OLD, Z
      LOW = SUP(SLOWES,J)
      GRAIN = SUP(SQUANT,J)
      LEAST = RSTEPS
      MOST = -1
      CALL TSNRNG(CTL, LEAF, FIRST, LAST)
      DO 20 I = FIRST, LAST
        Z = I
        CALL TSROUN(X, SUP(1,J), Z, H, ERR)
        IF (ABS(H) .LE. ERR - LOW) CALL HHHEIG(X, SUP(1,J), Z, H, ERR)
        C = (H - ERR - LOW)/GRAIN
C       (converted when it is in range, even if that were in vain)
        IF (C .LT. 0.0D0) C = -1.0D0
        C = MIN(C, DBLE(MARKS))
        K = INT(C)
        L = -1
        IF (K .GE. 0) L = K/MARKST
        LEAST = MIN(LEAST, L)
        IF (H + ERR .GT. -LOW) L = RSTEPS
        MOST = MAX(MOST, L)
        IF (L .LT. 0 .OR. L .GE. RSTEPS) GO TO 20
        IF (MARK(I) .GT. 0) THEN
          OLD = MOD(MARK(I) - 1, SURFS) + 1
          IF (SUP(SQUANT,OLD) .LE. FINBY*GRAIN) GO TO 20
        END IF
        MARK(I) = J + SURFS*K
        NEAR = NEAR + 1
   20 CONTINUE
      MARK(TSRCRD(CTL, J)+LRECRD+LEAF) = (LEAST + 1)*(RSTEPS + 2) +
     $    MOST + 1
      END

C     TSFSUR (find_surface) - seeks a surface for the sample of a
C     search: one through its points, then one through all that are near
C     that, as the first may be from a corner.  It is kept if it marks
C     enough points; if not, marks that it has taken over from a coarser
C     surface are lost, which only takes time.  KEPT is 1 if it is kept,
C     or 0.
      SUBROUTINE TSFSUR(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, IQ,
     $                  KEPT)
      INTEGER LSUP, LIQ
      PARAMETER (LSUP = 60, LIQ = 51)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(LSUP,*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*), IQ(LIQ), KEPT
      INTEGER NP, LEAVES, NSURF, RSLIMI, SLOWES, SQUANT, QOFFER, LRECRD,
     $    SURFS, SAMMIN, RSTEPS, COMPLE
      DOUBLE PRECISION FINBY
      PARAMETER (NP = 1, LEAVES = 4, NSURF = 261, RSLIMI = 140,
     $    SLOWES = 59, SQUANT = 60, QOFFER = 19, LRECRD = 16, SURFS = 8,
     $    SAMMIN = 24, FINBY = 100.0D0, RSTEPS = 32768, COMPLE = -1)
      DOUBLE PRECISION ERR, H
      INTEGER TSCUBE, TSRCRD, AT, FIRST, HELD, I, J, LAST, LEAST, MOST,
     $    NEAR, NODE, OK, OLD, RANGES, Z
      KEPT = 0
      J = HNT(NSURF) + 1
      IF (J .EQ. 1) THEN
        DO 10 I = 1, CTL(NP)
          MARK(I) = 0
   10   CONTINUE
      END IF
      AT = TSRCRD(CTL, J)
      CALL TSFIT(X, P, ORD, CTL, RCTL, IQ, MARK(AT+1), SUP(1,J), OK)
      IF (OK .EQ. 0) RETURN
      IQ(QOFFER) = 0
      HELD = 0
      DO 15 I = 1, CTL(NP), CTL(NP)/1024 + 1
        Z = I
        CALL TSROUN(X, SUP(1,J), Z, H, ERR)
        IF (LINK(I) .EQ. COMPLE .OR. ABS(H) .GT. ERR -
     $      2.0D0*SUP(SLOWES,J)) GO TO 15
        CALL TSADDS(IQ, Z, 1)
        IF (MARK(I) .EQ. 0) GO TO 15
        OLD = MOD(MARK(I) - 1, SURFS) + 1
        IF (SUP(SQUANT,OLD) .LE. FINBY*SUP(SQUANT,J))
     $      HELD = HELD + 1
   15 CONTINUE
      IF (IQ(QOFFER) .GT. SAMMIN) THEN
C       if all marks would stay, computing the heights of all points in
C       vain would take most of the time of a globe's index
        IF (HELD .EQ. IQ(QOFFER)) RETURN
        CALL TSFIT(X, P, ORD, CTL, RCTL, IQ, MARK(AT+1), SUP(1,J),
     $    OK)
        IF (OK .EQ. 0) RETURN
      END IF
      NEAR = 0
      DO 20 NODE = 2*CTL(LEAVES) - 1, CTL(LEAVES), -1
        I = NODE
        CALL TSMLEA(X, MARK, CTL, SUP, J, I, NEAR)
   20 CONTINUE
      RANGES = AT + LRECRD
      DO 30 NODE = CTL(LEAVES) - 1, 1, -1
        FIRST = MARK(RANGES+2*NODE)
        LAST = MARK(RANGES+2*NODE+1)
        LEAST = MIN(FIRST, LAST)/(RSTEPS + 2)
        MOST = MAX(MOD(FIRST, RSTEPS + 2), MOD(LAST, RSTEPS + 2))
        MARK(RANGES+NODE) = LEAST*(RSTEPS + 2) + MOST
   30 CONTINUE
      IF (NEAR .LT. 2*TSCUBE(CTL(NP))) THEN
        DO 40 I = 1, CTL(NP)
          IF (MARK(I) .GT. 0 .AND. MOD(MARK(I) - J, SURFS) .EQ. 0)
     $        MARK(I) = 0
   40   CONTINUE
        RETURN
      END IF
      KEPT = 1
      HNT(NSURF) = J
      IF (J .EQ. SURFS) RCTL(RSLIMI) = 0.0D0
      END

C     TSSOFI (surfaces_of_index) - sets up the surfaces that an index
C     has, as they were.
      SUBROUTINE TSSOFI(X, CTL, HNT, SUP, COUNTS)
      INTEGER LSUP
      PARAMETER (LSUP = 60)
      DOUBLE PRECISION X(3,*), SUP(LSUP,*)
      INTEGER CTL(*), HNT(*), COUNTS(*)
      INTEGER NSURF
      PARAMETER (NSURF = 261)
      INTEGER TSRCRD, AT, J, OK
      HNT(NSURF) = COUNTS(1)
      DO 10 J = 1, HNT(NSURF)
        AT = TSRCRD(CTL, J)
        CALL TSSFRC(X, COUNTS(AT+2), SUP(1,J), OK)
   10 CONTINUE
      END

C     TSSNRF (surface_near_facet) - J is the surface that the facet's
C     vertices are near, or 0; H are their heights, the base's first,
C     ERR the bounds on their errors.  Surfaces that have marked its
C     vertices come first:  between sheets 1E-10 apart searches take 30
C     times as long otherwise.
      SUBROUTINE TSSNRF(X, MARK, HNT, SUP, IQ, J, H, ERR)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), SUP(*), H(3), ERR(3)
      INTEGER MARK(*), HNT(*), IQ(LIQ), J
      INTEGER NSURF, QFACET, SURFS
      PARAMETER (NSURF = 261, QFACET = 0, SURFS = 8)
      INTEGER I, OK
      DO 10 I = 1, 3
        IF (MARK(IQ(QFACET+I)) .EQ. 0) GO TO 10
        J = MOD(MARK(IQ(QFACET+I)) - 1, SURFS) + 1
        CALL TSFONS(X, MARK, SUP, IQ, J, H, ERR, OK)
        IF (OK .EQ. 1) RETURN
   10 CONTINUE
      DO 20 I = 1, HNT(NSURF)
        J = I
        CALL TSFONS(X, MARK, SUP, IQ, J, H, ERR, OK)
        IF (OK .EQ. 1) RETURN
   20 CONTINUE
      J = 0
      END

C     TSRCEN (recentre_on_sphere) - counts L from the centre of the
C     facet's surface, a sphere, in place of the circumcentre.  G is
C     |W|**2 - 2 c.W, c = tilt / 2 - o, o = base - centre: the power in
C     the ball of centre c, which is on the facet's axis.  c errs by
C     half of T(TTILTE); by the roundings of three differences in any
C     order, each of at most EPS (|o| + 2 |origin|), together less than
C     8 EPS SIZE; and by EPS |tilt|/2, less than a tenth of T(TTILTE).
      SUBROUTINE TSRCEN(SUP, IQ, FQ)
      INTEGER LSUP, LIQ, LFQ
      PARAMETER (LSUP = 60, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION SUP(LSUP,*), FQ(LFQ)
      INTEGER IQ(LIQ)
      INTEGER SORIGI, SC, FCEN, FBASE, FDC, FRHO, TTILT, TTILTE, QSURF,
     $    QHH, QTILT
      DOUBLE PRECISION EPS
      PARAMETER (SORIGI = 52, SC = 55, FCEN = 3, FBASE = 6, FDC = 11,
     $    FRHO = 12, TTILT = 9, TTILTE = 13, QSURF = 17, QHH = 0,
     $    QTILT = 169, EPS = 2.0D0**(-52))
      DOUBLE PRECISION TSDOT, R, SIZE
      INTEGER K, J
      J = IQ(QSURF)
      SIZE = 0.0D0
      DO 10 K = 1, 3
        R = FQ(QHH+FBASE+K) - SUP(SORIGI+K,J)
        SIZE = SIZE + (ABS(R) + 2.0D0*ABS(SUP(SC+K,J)) +
     $      ABS(SUP(SORIGI+K,J)))
        FQ(QHH+FCEN+K) = 0.5D0*FQ(QTILT+TTILT+K) - (R - SUP(SC+K,J))
   10 CONTINUE
      FQ(QHH+FDC) = 0.6D0*FQ(QTILT+TTILTE) + 8.0D0*EPS*SIZE
      FQ(QHH+FRHO) = SQRT(TSDOT(FQ(QHH+FCEN+1), FQ(QHH+FCEN+1)))
      END

C     TSCHOS (choose_surface) - finds the surface of the facet, if any,
C     and its tilt.  There is none for a sliver (see SLIVRE), nor for a
C     facet at more than 60 degrees to its plane; nor for a facet so
C     small that a sphere bends away from it by less than its points
C     scatter, a sixteenth of the band or so.  Its balls are then far
C     from the sphere, and L, counted from the centre of the sphere and
C     right to 8 EPS of its distance, would tell nothing of them: 20,000
C     points of a sphere that crowd about a spot take 8 times as long.
C
C     T(TTILTE): roundings of the edges take the tilt out of the plane.
C     In it, the tilt's products with the edges miss the differences of
C     heights by r0, r1, and a vector whose products with two unit
C     vectors are r0, r1 is no longer than (|r0| + |r1|) / sine of the
C     angle between them.  DET errs by less than 1/100, as no sliver is
C     let through.  Where two vertices are so near that the marks leave
C     nothing of the tilt, as at the poles of a globe of meridians, the
C     differences of heights come by limbs, over the base: right to some
C     EPS of themselves.
      SUBROUTINE TSCHOS(X, MARK, CTL, HNT, SUP, IQ, FQ)
      INTEGER LSUP, LSPHER, LIQ, LFQ
      PARAMETER (LSUP = 60, LSPHER = 52, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), SUP(LSUP,*), FQ(LFQ)
      INTEGER MARK(*), CTL(*), HNT(*), IQ(LIQ)
      INTEGER SC, SLOWES, VBASEH, FE, THEIGE, TTILT, TTILTE, TNORMH,
     $    QFACET, QBASE, QSURF, QHH, QTILT, RECPT
      DOUBLE PRECISION EPS, SLIVRE, UNDERR
      PARAMETER (SC = 55, SLOWES = 59, VBASEH = 7, FE = 10, THEIGE = 9,
     $    TTILT = 9, TTILTE = 13, TNORMH = 14, QFACET = 0, QBASE = 5,
     $    QSURF = 17, QHH = 0, QTILT = 169, RECPT = 1,
     $    EPS = 2.0D0**(-52), SLIVRE = 1.0D-3, UNDERR = 1.0D-200)
      DOUBLE PRECISION TSDOT, A(3,2), AB, DET, ERR(3), H(3), N(2),
     $    OWN(LSPHER), R, SIZE, T1, T2
      INTEGER TSONSP, TSRCRD, AGAIN, AT, B, I, J, K, OK, PLANE, Z
      IF (FQ(QHH+FE) .GT. SLIVRE) RETURN
      CALL TSSNRF(X, MARK, HNT, SUP, IQ, J, H, ERR)
      IF (J .EQ. 0) RETURN
      FQ(QTILT+TNORMH) = TSDOT(SUP(SC+1,J), FQ(QHH+1))
      PLANE = 1 - TSONSP(SUP, J)
      IF (PLANE .EQ. 1 .AND. ABS(FQ(QTILT+TNORMH)) .LT. 0.5D0) RETURN
      B = IQ(QFACET+IQ(QBASE))
      DO 60 I = 1, 2
        Z = IQ(QFACET+MOD(IQ(QBASE) + I - 1, 3)+1)
        DO 50 K = 1, 3
          A(K,I) = X(K,Z) - X(K,B)
   50   CONTINUE
        N(I) = TSDOT(A(1,I), A(1,I))
        ERR(I+1) = ERR(I+1) + (ERR(1) + 16.0D0*EPS*(ABS(H(I+1)) +
     $             ABS(H(1))))
        H(I+1) = H(I+1) - H(1)
   60 CONTINUE
      IF (PLANE .EQ. 0 .AND. 16.0D0*N(1) .LT. -SUP(SLOWES,J) .AND.
     $    16.0D0*N(2) .LT. -SUP(SLOWES,J)) RETURN
      AB = TSDOT(A(1,1), A(1,2))
      DET = N(1)*N(2) - AB*AB
      IF (DET .LT. 1.0D4*EPS*N(1)*N(2) .OR. DET .LT. UNDERR) RETURN
      IQ(QSURF) = J
      FQ(QTILT+VBASEH) = H(1)
      FQ(QTILT+THEIGE) = ERR(1)
      AGAIN = 0
   70 SIZE = 0.0D0
      T1 = (H(2)*N(2) - H(3)*AB)/DET
      T2 = (H(3)*N(1) - H(2)*AB)/DET
      DO 80 K = 1, 3
        FQ(QTILT+TTILT+K) = T1*A(K,1) + T2*A(K,2)
        SIZE = SIZE + (ABS(T1*A(K,1)) + ABS(T2*A(K,2)))
   80 CONTINUE
      FQ(QTILT+TTILTE) = 8.0D0*EPS*SIZE
      DO 90 I = 1, 2
        R = H(I+1) - TSDOT(FQ(QTILT+TTILT+1), A(1,I))
        R = ABS(R) + (ERR(I+1) + 16.0D0*EPS*SIZE*SQRT(N(I)))
        FQ(QTILT+TTILTE) = FQ(QTILT+TTILTE) + R*SQRT(1.02D0*N(3-I)/DET)
   90 CONTINUE
      IF (AGAIN .EQ. 0 .AND. FQ(QTILT+TTILTE) .GE. SIZE - SUP(SLOWES,J))
     $    THEN
        AGAIN = 1
        AT = MARK(TSRCRD(CTL, J)+RECPT)
        CALL HHSURF(X, B, AT, PLANE, SUP(SC+1,J), OWN, OK)
        IF (OK .EQ. 1) THEN
          DO 100 I = 2, 3
            Z = IQ(QFACET+MOD(IQ(QBASE) + I - 2, 3)+1)
            CALL HHHEIG(X, OWN, Z, H(I), ERR(I))
  100     CONTINUE
          GO TO 70
        END IF
      END IF
      IF (PLANE .EQ. 0) CALL TSRCEN(SUP, IQ, FQ)
      END

C     TSSHAR (sharpen_by_height) - sharpens SIDE of the position Z,
C     which HHLIMI did not find negative, and the limits of L, by the
C     height of Z over the facet's surface: the height gives the side
C     for a plane, the power for a sphere.  A plane's T(TNORMH) errs by
C     E and some roundings.  The quotients are of numbers right to 4 EPS
C     of themselves, as is what is left of a side of more than twice its
C     error: ROUNDG is more.
      SUBROUTINE TSSHAR(X, MARK, SUP, IQ, FQ, Z, SIDE, LO, HI)
      INTEGER LSUP, LIQ, LFQ
      PARAMETER (LSUP = 60, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), SUP(LSUP,*), FQ(LFQ), LO, HI
      INTEGER MARK(*), IQ(LIQ), Z, SIDE
      INTEGER SPLANE, VBASEH, FNORM, FBASE, FE, THEIGE, TTILT, TTILTE,
     $    TNORMH, QSURF, QHH, QTILT
      DOUBLE PRECISION HUGE, EPS, LENMIN, UNDERR, ROUNDG
      PARAMETER (SPLANE = 8, VBASEH = 7, FNORM = 0, FBASE = 6, FE = 10,
     $    THEIGE = 9, TTILT = 9, TTILTE = 13, TNORMH = 14, QSURF = 17,
     $    QHH = 0, QTILT = 169,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023, EPS = 2.0D0**(-52),
     $    LENMIN = 2.0D0**(-450), UNDERR = 1.0D-200,
     $    ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION ERR, G, H, HIGH, LEAST, LOW, MOST, SIZE, U
      INTEGER K, OK
      CALL TSHEOV(X, MARK, SUP, IQ(QSURF), Z, H, ERR, OK)
      IF (OK .EQ. 0) RETURN
      ERR = ERR + (FQ(QTILT+THEIGE) + 16.0D0*EPS*(ABS(H) +
     $    ABS(FQ(QTILT+VBASEH))) + UNDERR)
      H = H - FQ(QTILT+VBASEH)
      G = 0.0D0
      SIZE = 0.0D0
      DO 10 K = 1, 3
        U = X(K,Z) - FQ(QHH+FBASE+K)
        H = H - FQ(QTILT+TTILT+K)*U
        G = G + FQ(QHH+FNORM+K)*U
        SIZE = SIZE + ABS(U)
        ERR = ERR + 16.0D0*EPS*ABS(FQ(QTILT+TTILT+K)*U)
   10 CONTINUE
      ERR = ERR + FQ(QTILT+TTILTE)*SIZE
      IF (SUP(SPLANE,IQ(QSURF)) .GT. 0.0D0) THEN
        IF (FQ(QTILT+TNORMH) .LT. 0.0D0) H = -H
        IF (H + ERR .LT. 0.0D0) THEN
          SIDE = -1
          RETURN
        END IF
        U = FQ(QHH+FE) + 32.0D0*EPS
        LEAST = (H - ERR)/(ABS(FQ(QTILT+TNORMH)) + U)*(1.0D0 - ROUNDG)
        MOST = (H + ERR)/(ABS(FQ(QTILT+TNORMH)) - U)*(1.0D0 + ROUNDG)
        IF (LEAST .LT. LENMIN) RETURN
        LOW = -HUGE
        HIGH = HUGE
        CALL HHRATI(FQ(QHH+1), X(1,Z), LEAST, MOST, LOW, HIGH)
        SIDE = 1
      ELSE
        LEAST = 2.0D0*(G - FQ(QHH+FE)*SIZE)
        MOST = 2.0D0*(G + FQ(QHH+FE)*SIZE)
        IF (SIDE .LE. 0 .OR. LEAST .LT. LENMIN) RETURN
        LOW = (H - ERR)/LEAST
        IF (H .GT. ERR) LOW = (H - ERR)/MOST
        HIGH = (H + ERR)/MOST
        IF (H .GT. -ERR) HIGH = (H + ERR)/LEAST
        LOW = LOW - ROUNDG*ABS(LOW)
        HIGH = HIGH + ROUNDG*ABS(HIGH)
      END IF
      LO = MAX(LO, LOW)
      HI = MIN(HI, HIGH)
      END

C     TSSFFI (set_surface_filter) - sets up the surface filter for the
C     best point so far, whose L-coordinate is at most l.  A better
C     point has side > 0 and N - 2 l side <= 0, where N is its power in
C     the ball of L = 0, of centre c.  Without a ball l is LMAX / 2,
C     with room for N.  So with V, the facet's normal, no better point
C     satisfies
C         q |W|**2 - d.W + a (height - h) > 0.
C     Near a plane side = G / g, g being T(TNORMH):
C         q = 1,  d = 2 c + a tilt,  a = -2 l / g.
C     Near a sphere N = G; a share q of it comes from powers, 1 - q from
C     heights:
C         q > 0,  d = 2 q c + a tilt + 2 l V,  a = 1 - q.
C
C     Near a plane any upper bound l is valid, so a is only ever rounded
C     up.  Near a sphere q makes |d| least, if it can; any q > 0 is
C     valid, so errors in q do not count.  DD has room for the errors of
C     c, tilt and V, and for 8 roundings of each term; T(VALLOW) for
C     those of h, of a height of at most -SLOWES, and of a, which is
C     exact but for one rounding.  The surface filter is all that,
C     divided by q.
      SUBROUTINE TSSFFI(SUP, IQ, FQ)
      INTEGER LSUP, LIQ, LFQ
      PARAMETER (LSUP = 60, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION SUP(LSUP,*), FQ(LFQ)
      INTEGER IQ(LIQ)
      INTEGER SPLANE, SLOWES, VC, VDC, VC1, VWEIGH, VBASEH, VALLOW,
     $    FNORM, FCEN, FE, FDC, FRHO, THEIGE, TTILT, TTILTE, TNORMH,
     $    QHASBA, QSURF, QHH, QTILT, QHI
      DOUBLE PRECISION EPS, LMAX, UNDERR
      PARAMETER (SPLANE = 8, SLOWES = 59, VC = 0, VDC = 4, VC1 = 5,
     $    VWEIGH = 6, VBASEH = 7, VALLOW = 8, FNORM = 0, FCEN = 3,
     $    FE = 10, FDC = 11, FRHO = 12, THEIGE = 9, TTILT = 9,
     $    TTILTE = 13, TNORMH = 14, QHASBA = 7, QSURF = 17, QHH = 0,
     $    QTILT = 169, QHI = 14, EPS = 2.0D0**(-52), LMAX = 1.0D100,
     $    UNDERR = 1.0D-200)
      DOUBLE PRECISION A, B, DD, L, Q, SUM, U, V, W
      INTEGER K, J
      J = IQ(QSURF)
      L = 0.5D0*LMAX
      DD = 4.0D0 + 4.0D0*FQ(QHH+FRHO)
      IF (IQ(QHASBA) .EQ. 1 .AND. ABS(FQ(QHI)) .LE. LMAX) THEN
        L = FQ(QHI)
        DD = 0.0D0
      END IF
      A = 1.0D0
      Q = 1.0D0
      B = 0.0D0
      IF (SUP(SPLANE,J) .GT. 0.0D0) THEN
        A = -2.0D0*L/FQ(QTILT+TNORMH)
        U = 4.0D0*(FQ(QHH+FE) + 32.0D0*EPS)*A
        IF (L .LE. 0.0D0) U = -U
        A = A + U
      ELSE
        B = 2.0D0*L
        SUM = 0.0D0
        DO 10 K = 1, 3
          SUM = SUM - FQ(QHH+FCEN+K)*(B*FQ(QHH+FNORM+K) +
     $        FQ(QTILT+TTILT+K))
   10   CONTINUE
        Q = 0.0D0
        IF (SUM .GT. 0.0D0) Q = 0.5D0*SUM/(FQ(QHH+FRHO)*FQ(QHH+FRHO))
        Q = MAX(Q, 1.0D0/LMAX)
        A = A - Q
      END IF
      DD = DD + (ABS(A)*FQ(QTILT+TTILTE) + 2.0D0*Q*FQ(QHH+FDC) +
     $    ABS(B)*FQ(QHH+FE))
      FQ(QTILT+VC1) = 0.0D0
      DO 20 K = 1, 3
        U = A*FQ(QTILT+TTILT+K)
        V = 2.0D0*Q*FQ(QHH+FCEN+K)
        W = B*FQ(QHH+FNORM+K)
        DD = DD + 8.0D0*EPS*(ABS(U) + ABS(V) + ABS(W))
        FQ(QTILT+VC+K) = 0.5D0*(U + V + W)/Q
        FQ(QTILT+VC1) = FQ(QTILT+VC1) + ABS(FQ(QTILT+VC+K))
   20 CONTINUE
      FQ(QTILT+VDC) = 0.5D0*DD/Q
      FQ(QTILT+VWEIGH) = A/Q
      FQ(QTILT+VALLOW) = (ABS(A)*FQ(QTILT+THEIGE) + 16.0D0*EPS*(ABS(A) +
     $    Q)*(ABS(FQ(QTILT+VBASEH)) - SUP(SLOWES,J)) + UNDERR)/Q
      END

C     TSXMRK (excludes_by_marks) - returns 1 if a node provably holds no
C     better point, by the marks of its points; 0 if it may; UNSURE
C     where the marks tell nothing.
      INTEGER FUNCTION TSXMRK(BOX, MARK, CTL, SUP, IQ, FQ, NODE)
      INTEGER LSUP, LIQ, LFQ
      PARAMETER (LSUP = 60, LIQ = 51, LFQ = 183)
      DOUBLE PRECISION BOX(6,*), SUP(LSUP,*), FQ(LFQ)
      INTEGER MARK(*), CTL(*), IQ(LIQ), NODE
      INTEGER SLOWES, SQUANT, VWEIGH, VBASEH, QSURF, QTILT, LRECRD,
     $    RSTEPS, MARKST, UNSURE
      PARAMETER (SLOWES = 59, SQUANT = 60, VWEIGH = 6, VBASEH = 7,
     $    QSURF = 17, QTILT = 169, LRECRD = 16, RSTEPS = 32768,
     $    MARKST = 4096, UNSURE = 2)
      DOUBLE PRECISION H
      INTEGER TSRCRD, TSXBOX, K, ON
      ON = IQ(QSURF)
      K = MARK(TSRCRD(CTL, ON)+LRECRD+NODE)
      IF (FQ(QTILT+VWEIGH) .LT. 0.0D0) THEN
        K = MOD(K, RSTEPS + 2) - 1
        H = DBLE(MARKST)*DBLE(K) + (DBLE(MARKST) + 0.5D0)
      ELSE
        K = K/(RSTEPS + 2) - 1
        H = DBLE(MARKST)*DBLE(K) - 0.5D0
      END IF
      TSXMRK = UNSURE
      IF (K .LT. 0 .OR. K .GE. RSTEPS) RETURN
      H = SUP(SLOWES,ON) + SUP(SQUANT,ON)*H
      TSXMRK = TSXBOX(BOX, IQ, FQ, QTILT, NODE, FQ(QTILT+VWEIGH)*(H -
     $    FQ(QTILT+VBASEH)))
      END

C     TSBONS (ball_on_surface) - OK is 1 if the facet is near a sphere
C     and so is the best point, if there is one: the ball is that sphere
C     up to rounding, and no list holds it; or 0.
      SUBROUTINE TSBONS(MARK, SUP, IQ, OK)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION SUP(*)
      INTEGER MARK(*), IQ(LIQ), OK
      INTEGER QBEST, QSURF
      PARAMETER (QBEST = 4, QSURF = 17)
      DOUBLE PRECISION H
      INTEGER TSONSP
      OK = TSONSP(SUP, IQ(QSURF))
      IF (OK .EQ. 1 .AND. IQ(QBEST) .NE. 0) CALL TSMRKH(MARK, SUP,
     $    IQ(QSURF), IQ(QBEST), H, OK)
      END

C     TSSEEK (seek_surface) - seeks a reference surface in the sample of
C     a search, when large samples add up to RCTL(RSLIMI) times all
C     points; a failure doubles that limit.
      SUBROUTINE TSSEEK(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, IQ)
      INTEGER LIQ
      PARAMETER (LIQ = 51)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*), SUP(*)
      INTEGER ORD(*), LINK(*), MARK(*), CTL(*), HNT(*), IQ(LIQ)
      INTEGER NP, RSLOAD, RSLIMI, QOFFER, SAMMIN
      PARAMETER (NP = 1, RSLOAD = 139, RSLIMI = 140, QOFFER = 19,
     $    SAMMIN = 24)
      INTEGER KEPT
      IF (IQ(QOFFER) .LE. SAMMIN .OR. RCTL(RSLIMI) .LE. 0.0D0) RETURN
      RCTL(RSLOAD) = RCTL(RSLOAD) + DBLE(IQ(QOFFER))/DBLE(CTL(NP))
      IF (RCTL(RSLOAD) .LE. RCTL(RSLIMI)) RETURN
      RCTL(RSLOAD) = 0.0D0
      CALL TSFSUR(X, P, ORD, LINK, MARK, CTL, RCTL, HNT, SUP, IQ, KEPT)
      IF (KEPT .EQ. 0) RCTL(RSLIMI) = 2.0D0*RCTL(RSLIMI)
      END

C     TSPAYS - returns 1 if reference surfaces can help (see EXACTU), or
C     0.
      INTEGER FUNCTION TSPAYS(RCTL)
      DOUBLE PRECISION RCTL(*)
      INTEGER EXACT5
      DOUBLE PRECISION EXACTU
      PARAMETER (EXACT5 = 2, EXACTU = 16.0D0)
      TSPAYS = 0
      IF (RCTL(EXACT5) .LT. EXACTU) TSPAYS = 1
      END

C     TSRMRK (room_for_marks) - decides whether reference surfaces are
C     sought.  SPACE, the length of the marks that TSLENG gives, stays,
C     or becomes 0 where there are no surfaces and none are sought.  LIW
C     is the length of IW, LIWMIN and POOL what TSLENG gives.
      SUBROUTINE TSRMRK(RCTL, HNT, LIW, LIWMIN, POOL, SPACE)
      INTEGER HNT(*), LIW, LIWMIN, POOL, SPACE
      DOUBLE PRECISION RCTL(*)
      INTEGER NSURF, RSLIMI, SURFS
      DOUBLE PRECISION SAMLIM
      PARAMETER (NSURF = 261, RSLIMI = 140, SURFS = 8, SAMLIM = 1.0D0)
      INTEGER TSPAYS, PAYS
      PAYS = TSPAYS(RCTL)
      IF (RCTL(RSLIMI) .LE. 0.0D0 .AND. HNT(NSURF) .LT. SURFS .AND.
     $    PAYS .EQ. 1 .AND. SPACE .GT. 0 .AND. (HNT(NSURF) .GT. 0 .OR.
     $    LIW - LIWMIN - POOL .GE. SPACE)) RCTL(RSLIMI) = SAMLIM
      IF (HNT(NSURF) .EQ. 0 .AND. RCTL(RSLIMI) .LE. 0.0D0) SPACE = 0
      END

C     TSSURV (survey_regions) - seeks reference surfaces for an index,
C     in COUNTS, the end of IW, of which LIW is without the last N:
C     those that the stars of a corner of the hull and of points of all
C     regions find (the multiples of the golden ratio are spread
C     evenly); nothing else is kept of these stars.  TSINDE has cut the
C     workspace up.
      SUBROUTINE TSSURV(N, X, P, ORD, BOX, ALIVE, REP, CTL, RCTL, HNT,
     $                  SUP, LSX, LSID, LSD, LIW, KNOWN, COUNTS, LEFT,
     $                  WHOLE)
      INTEGER STARS
      PARAMETER (STARS = 256)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER N, ORD(*), ALIVE(*), REP(*), CTL(*), HNT(*), LSID(*), LIW,
     $    KNOWN(4), LEFT, COUNTS(LEFT), WHOLE
      INTEGER NP, NSURF, RSLOAD, RSLIMI, SURFS, REGIO
      DOUBLE PRECISION SAMLIM, KEEN
      PARAMETER (NP = 1, NSURF = 261, RSLOAD = 139, RSLIMI = 140,
     $    SURFS = 8, SAMLIM = 1.0D0, REGIO = 32, KEEN = SAMLIM/256.0D0)
      DOUBLE PRECISION PART
      INTEGER TSPAYS, ADJ(4*STARS), CODE, I, K, LENGTH, MANY, MINE,
     $    SPACE, TET(4,STARS)
      IF (WHOLE .EQ. 0) RETURN
      IF (TSPAYS(RCTL) .EQ. 0) RETURN
      MINE = LEFT - N
      DO 50 K = 1, REGIO
        IF (MOD(K, 8) .EQ. 1) THEN
          DO 40 I = 1, N
            COUNTS(MINE+I) = 0
   40     CONTINUE
        END IF
        PART = 0.618D0*DBLE(K)
        PART = PART - DBLE(INT(PART))
        COUNTS(MINE+ORD(INT(PART*DBLE(CTL(NP)))+1)) = 1
        COUNTS(MINE+KNOWN(1)) = 1
        IF (MOD(K, 8) .NE. 0) GO TO 50
        MANY = 0
        RCTL(RSLIMI) = 0.0D0
        IF (HNT(NSURF) .LT. SURFS) RCTL(RSLIMI) = KEEN
        CALL TSALLO(N, RCTL, HNT, LIW, SPACE, LENGTH)
        I = SPACE + 2
        CALL TSBLD(N, X, P, ORD, 1, COUNTS(MINE+1), STARS, MANY, TET,
     $             ADJ, BOX, ALIVE, REP, COUNTS(I), COUNTS(I+N),
     $             COUNTS(I+2*N), COUNTS(2), CTL, RCTL, HNT, SUP, LSX,
     $             LSID, LSD, LENGTH, SPACE, CODE)
C       no sample filled up, so further stars will find no surface
        IF (HNT(NSURF) .EQ. 0 .AND. RCTL(RSLOAD) .LE. 0.0D0) RETURN
   50 CONTINUE
      END

C     ------------------------------------------------------------------
C     What the chapters begin with, and what they forget
C     ------------------------------------------------------------------

C     TSDROP (drop_stages) - drops all candidate lists, cospherical sets
C     and hull planes.
      SUBROUTINE TSDROP(HNT, LSID, LSD)
      INTEGER NLISTS, LFIRST, LLSD, TSLIST, LEAFPT
      PARAMETER (NLISTS = 7, LFIRST = -2, LLSD = 17, TSLIST = 448,
     $    LEAFPT = 48)
      INTEGER HNT(*), LSID(LFIRST:TSLIST+LEAFPT,NLISTS)
      DOUBLE PRECISION LSD(LLSD,NLISTS)
      INTEGER NHULLP, NSERVD, VAINLO, NSETS, RECENC, BLK, STR, LLAST,
     $    LN, LREACH, NEARLS
      PARAMETER (NHULLP = 10, NSERVD = 11, VAINLO = 12, NSETS = 205,
     $    RECENC = 4, BLK = 1, STR = 2,
     $    LLAST = -1, LN = 0, LREACH = 13, NEARLS = 5)
      INTEGER I
      LSID(LFIRST,BLK) = 1
      LSID(LLAST,BLK) = 0
      LSID(LN,BLK) = 0
      LSID(LN,STR) = 0
      LSD(LREACH,BLK) = 0.0D0
      DO 10 I = 1, NEARLS
        LSID(LN,STR+I) = 0
        HNT(RECENC+I) = STR + I
   10 CONTINUE
      HNT(NHULLP) = 0
      HNT(NSERVD) = 0
      HNT(VAINLO) = 0
      HNT(NSETS) = 0
      END

C     TSSTAG (start_stages) - sets what the chapters begin with.
      SUBROUTINE TSSTAG(RCTL, HNT, LSID, LSD)
      INTEGER HNT(*), LSID(*)
      DOUBLE PRECISION RCTL(*), LSD(*)
      INTEGER HASCYL, NPLANE, NSURF, STTIED, BLMISS, BLTIES, LASTTI,
     $    PAUSED, RSLOAD, RSLIMI, RSKIN, RBUDGE, RTREEC, RBIGBA, RCAPLO,
     $    RCAPLI, RCLUMP
      DOUBLE PRECISION BUDSTA, CAPLIM, HUGE
      PARAMETER (HASCYL = 258, NSURF = 261, STTIED = 3, BLMISS = 1,
     $    BLTIES = 2, LASTTI = 260, PAUSED = 4, RSLOAD = 139,
     $    RSLIMI = 140, RSKIN = 4, RBUDGE = 5, RTREEC = 6, NPLANE = 259,
     $    RBIGBA = 7, RCAPLO = 8, RCAPLI = 9, RCLUMP = 138,
     $    BUDSTA = 500.0D0, CAPLIM = 4.0D0,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      HNT(STTIED) = 0
      HNT(BLMISS) = 0
      HNT(BLTIES) = 0
      HNT(PAUSED) = 0
      RCTL(RTREEC) = 0.0D0
      RCTL(RSKIN) = 1.0D0
      RCTL(RBUDGE) = BUDSTA
      HNT(HASCYL) = 0
      HNT(NPLANE) = 0
      RCTL(RCAPLO) = 0.0D0
      RCTL(RCAPLI) = CAPLIM
      RCTL(RBIGBA) = HUGE
      HNT(LASTTI) = 0
      RCTL(RCLUMP) = 0.0D0
      HNT(NSURF) = 0
      RCTL(RSLOAD) = 0.0D0
      RCTL(RSLIMI) = 0.0D0
      CALL TSDROP(HNT, LSID, LSD)
      END

C     ==================================================================
C     PART III: WITHOUT A WHOLE MESH
C     ==================================================================

C     ------------------------------------------------------------------
C     A star on its own
C
C     Any star can be completed without the rest of the mesh, from one
C     tetrahedron at its vertex.
C     ------------------------------------------------------------------

C     TSREPV (replace_vertex) - replaces V(K) by Z, unless the result is
C     flat.  OK is 1 if it does, or 0.
      SUBROUTINE TSREPV(X, P, ORD, RCTL, V, K, Z, OK)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), V(4), K, Z, OK
      INTEGER EXACT3
      PARAMETER (EXACT3 = 1)
      INTEGER HHPORI, OLD
      OLD = V(K)
      V(K) = Z
      OK = ABS(HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3), V(4)))
      IF (OK .EQ. 0) V(K) = OLD
      END

C     TSENCL (encloses) - returns 1 if V is positively oriented and
C     contains S*, which is S = V(1) = R(1) moved by an infinitesimal
C     step into the tetrahedron R (as Q* of the queries is), so it is on
C     no plane through three points; or 0.
      INTEGER FUNCTION TSENCL(X, P, ORD, RCTL, R, V)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), R(4), V(4)
      INTEGER EXACT3
      PARAMETER (EXACT3 = 1)
      INTEGER HHPORI, A, B, I, J, SIDE
      SIDE = HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3), V(4))
      DO 20 J = 1, 3
        IF (SIDE .GT. 0) THEN
          A = V(MOD(J,3)+2)
          B = V(MOD(J+1,3)+2)
          SIDE = 0
          DO 10 I = 2, 4
            IF (SIDE .EQ. 0) SIDE = HHPORI(X, P, ORD, RCTL(EXACT3),
     $          V(1), A, B, R(I))
   10     CONTINUE
        END IF
   20 CONTINUE
      TSENCL = MAX(SIDE, 0)
      END

C     TSANYT (any_tet_at) - finds V, a tetrahedron at V(1) = S, of
C     points of the leaf of S as far as these are not in one plane, else
C     of vertices of KNOWN, whose positions are behind CTL(FIRSTT).
      SUBROUTINE TSANYT(X, P, ORD, CTL, RCTL, S, V)
      DOUBLE PRECISION X(3,*), P(3,*), RCTL(*)
      INTEGER ORD(*), CTL(*), S, V(4)
      INTEGER FIRSTT, EXACT3
      PARAMETER (FIRSTT = 13, EXACT3 = 1)
      INTEGER HHPORI, TSLEAF, TSLFST, FIRST, I, J, K, LENGTH, OK, Z
      FIRST = TSLFST(CTL, TSLEAF(CTL, S))
      LENGTH = TSLFST(CTL, TSLEAF(CTL, S) + 1) - FIRST
      DO 10 K = 1, 4
        V(K) = CTL(FIRSTT+K)
   10 CONTINUE
      K = 0
   20 K = K + 1
      J = K
      OK = 1
      IF (K .LT. 4) CALL TSREPV(X, P, ORD, RCTL, V, J, S, OK)
      IF (OK .EQ. 0) GO TO 20
      V(K) = V(1)
      V(1) = S
      DO 40 K = 2, 4
        J = K
        DO 30 I = 1, LENGTH - 1
          Z = FIRST + MOD(S - FIRST + I, LENGTH)
          CALL TSREPV(X, P, ORD, RCTL, V, J, Z, OK)
          IF (OK .EQ. 1) GO TO 40
   30   CONTINUE
   40 CONTINUE
      IF (HHPORI(X, P, ORD, RCTL(EXACT3), V(1), V(2), V(3), V(4)) .LT.
     $    0) THEN
        Z = V(2)
        V(2) = V(3)
        V(3) = Z
      END IF
      END

C     TSINCT (incident_tet) - finds V, a tetrahedron of the mesh at V(1)
C     = S, of which none is known yet.
C
C          B---Z         B---Z   In the plane: Z is in the ball of
C          |\  .         |  /|   (S, A, B).  Of the four points' two
C          | \ .   -->   | / |   triangulations the lower one has the
C          |  \.         |/  |   edge S Z in place of A B, so S* is in
C          S---A         S---A   (S, A, Z) or in (S, Z, B): Z replaces
C                                B, or A.
C
C     Start with any tetrahedron R at S, and with S* in it.  While V
C     contains S* and its ball is not empty, each point in the ball is
C     on the inner side of one of the three facets at S, since whatever
C     is outside all three is beyond the ball's tangent plane at S.  So
C     the apex Z of that facet on that side is not V's vertex there.
C     The five points have two triangulations, and V is not part of the
C     one whose lifted facets are the lower ones; so the tetrahedron of
C     that one that contains S* is V with Z in place of a vertex.  Each
C     such step lowers the height over S*, so none of the finitely many
C     tetrahedra at S comes twice; three searches in a row without a
C     step end it.  (Z beats V(K+1), the guess, by the exact rule, and
C     S* is on no plane through three points: so the height is strictly
C     less, and exactly one of the three places takes Z.)  This is done
C     with the points of the leaf alone, and then with all: without the
C     former, a query from anywhere takes three times as long.
C
C     Neither lists nor tree have completed points.  That does no harm
C     because S is in no tetrahedron yet, so no point whose star is
C     complete is its neighbour: the star of S is the same in any set of
C     points that has all its neighbours.  A vertex of V whose star is
C     complete takes part as the guess alone.
C
C     The lists are dropped because TSLHIT takes for granted that a list
C     holds the facet's vertices and the best point, which is not so
C     here.  The hull planes are dropped because a seed edge follows,
C     whose facet is open on both sides: if it lies in a hull plane,
C     TSONHP would find no apex on its inner side, either.  The searches
C     here record no plane, as their guess is a candidate.
      SUBROUTINE TSINCT(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL,
     $                  HNT, SUP, LSX, LSID, LSD, S, V)
      INTEGER LIQ, LFQ
      PARAMETER (LIQ = 51, LFQ = 183)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), MARK(*), CTL(*), HNT(*),
     $    LSID(*), S, V(4)
      INTEGER LEAVES, QBEST
      PARAMETER (LEAVES = 4, QBEST = 4)
      DOUBLE PRECISION FQ(LFQ)
      INTEGER TSENCL, TSLEAF, ALL, G(3), GUESS(2), IQ(LIQ), J, K, NODE,
     $    OLD, R(4), STILL, Z
      CALL TSDROP(HNT, LSID, LSD)
      CALL TSANYT(X, P, ORD, CTL, RCTL, S, V)
      DO 10 K = 1, 4
        R(K) = V(K)
   10 CONTINUE
      NODE = CTL(LEAVES) + TSLEAF(CTL, S) - 1
      GUESS(2) = 0
      K = 1
      DO 50 ALL = 0, 1
        STILL = 0
   20   G(1) = S
        G(2) = V(MOD(K,3)+2)
        G(3) = V(MOD(K+1,3)+2)
        GUESS(1) = V(K+1)
        IF (ALL .EQ. 1) THEN
          CALL TSAPEX(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $                SUP, LSX, LSID, LSD, G, GUESS, Z)
        ELSE
          CALL TSBEGS(X, P, ORD, MARK, CTL, RCTL, HNT, SUP, IQ, FQ, G,
     $                GUESS)
          CALL TSOFLF(X, P, ORD, BOX, LINK, MARK, CTL, RCTL, HNT, SUP,
     $                LSX, LSID, LSD, IQ, FQ, NODE)
          Z = IQ(QBEST)
        END IF
        STILL = STILL + 1
        IF (Z .NE. V(K+1)) THEN
          DO 30 J = 2, 4
            OLD = V(J)
            V(J) = Z
            IF (TSENCL(X, P, ORD, RCTL, R, V) .EQ. 1) GO TO 40
            V(J) = OLD
   30     CONTINUE
   40     STILL = 0
C         if V(K+1) was replaced, this was a search of its own facet
          IF (J .EQ. K + 1) STILL = 1
        END IF
        K = MOD(K,3) + 1
        IF (STILL .LT. 3) GO TO 20
   50 CONTINUE
      END

C     TSSEED (seed_star) - begins the star of S, which is NEW, with a
C     facet of a tetrahedron at S: its two sides become seed edges, the
C     one towards the tetrahedron first.
      SUBROUTINE TSSEED(X, P, ORD, BOX, ALIVE, LINK, POOL, MARK, CTL,
     $                  RCTL, HNT, SUP, LSX, LSID, LSD, S)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), LINK(*), POOL(*), MARK(*), CTL(*),
     $    HNT(*), LSID(*), S
      INTEGER ESEED
      PARAMETER (ESEED = -1)
      INTEGER E, V(4)
      CALL TSINCT(X, P, ORD, BOX, ALIVE, LINK, MARK, CTL, RCTL, HNT,
     $            SUP, LSX, LSID, LSD, S, V)
      CALL TSPUSH(LINK, POOL, CTL, ESEED, V(2), V(3), E)
      CALL TSPUSH(LINK, POOL, CTL, ESEED, V(3), V(2), E)
      END

C     ------------------------------------------------------------------
C     An index, and parts
C
C     An index is what TSSORT leaves in IW and RW, but for scratch:
C     sorted points without a mesh.
C
C     The header of an index, see TSWHDR:
C       LHEAD  = 6   -  its length
C       HDNP   = 1   HEADER_NP  NP
C       HDEX3  = 2   HEADER_EXACT3  EXACT3 of the points
C       HDEX5  = 3   HEADER_EXACT5  EXACT5
C       HDSCAL = 4   HEADER_EXPONENT  SCALE
C       HDLEAS = 5   HEADER_LEAST  RLEAST; negative if there are clumps
C       HDLIMB = 6   HEADER_LIMBS  HHLIM; negative if there are no
C               cylinders
C     ------------------------------------------------------------------

C     TSWHDR (write_header) - turns the sorted points into an index,
C     which has a mesh if CODE is 0.  It stores what TSOPEN needs
C     besides points and tree.
C
C       KNOWN   1 to 4: a tetrahedron of the mesh, numbers of points; or
C               1: minus the code of points without a mesh
C       COUNT   behind KNOWN: NP
C       HEADER  HDNP: NP again, so that an index can be recognized:
C               arrays of zeros, or an index that TESS has overwritten,
C               are none
C               HDEX3, HDEX5, HDSCAL: EXACT3, EXACT5 and SCALE of the
C               points
C               HDLEAS: RLEAST; negative if there are clumps
C               HDLIMB: HHLIM; negative if there are no cylinders
C       COUNTS  1: the number of reference surfaces
      SUBROUTINE TSWHDR(CTL, RCTL, HNT, HEADER, KNOWN, COUNT, COUNTS,
     $                  CODE)
      INTEGER LHEAD
      PARAMETER (LHEAD = 6)
      INTEGER CTL(*), HNT(*), KNOWN(4), COUNT, COUNTS(*), CODE
      DOUBLE PRECISION RCTL(*), HEADER(LHEAD)
      INTEGER NP, SCALE, HASCYL, NSURF, EXACT3, EXACT5, RLEAST, RCLUMP,
     $    HDNP, HDEX3, HDEX5, HDSCAL, HDLEAS, HDLIMB, HHLIM
      PARAMETER (NP = 1, SCALE = 13, HASCYL = 258, NSURF = 261,
     $    EXACT3 = 1, EXACT5 = 2, RLEAST = 3, RCLUMP = 138, HDNP = 1,
     $    HDEX3 = 2, HDEX5 = 3, HDSCAL = 4, HDLEAS = 5, HDLIMB = 6,
     $    HHLIM = 88)
      IF (CODE .NE. 0) KNOWN(1) = -CODE
      COUNT = CTL(NP)
      HEADER(HDNP) = DBLE(CTL(NP))
      IF (CODE .NE. 0) RETURN
      HEADER(HDEX3) = RCTL(EXACT3)
      HEADER(HDEX5) = RCTL(EXACT5)
      HEADER(HDSCAL) = DBLE(CTL(SCALE))
      HEADER(HDLEAS) = RCTL(RLEAST)
      IF (RCTL(RCLUMP) .GT. 0.0D0) HEADER(HDLEAS) = -RCTL(RLEAST)
      HEADER(HDLIMB) = DBLE((2*HNT(HASCYL) - 1)*HHLIM)
      COUNTS(1) = HNT(NSURF)
      END

C     TSOPEN (open_index) - opens an index for reading only.  INFO is 0,
C     the code of points without a mesh, or -8 where there is no index.
      SUBROUTINE TSOPEN(N, P, ORD, BOX, REP, CTL, RCTL, HNT, LSID, LSD,
     $                  HEADER, KNOWN, COUNT, COUNTS, INFO)
      INTEGER LHEAD
      PARAMETER (LHEAD = 6)
      INTEGER N, ORD(*), REP(*), CTL(*), HNT(*), LSID(*), KNOWN(4),
     $    COUNT, COUNTS(*), INFO
      DOUBLE PRECISION P(3,*), BOX(6,*), RCTL(*), LSD(*), HEADER(LHEAD)
      INTEGER CHCYLI, CHLIMB, NP, LEAVES, SCALE, FIRSTT, HASCYL, EXACT3,
     $    EXACT5, RLEAST, HDNP, HDEX3, HDEX5, HDSCAL, HDLEAS, HDLIMB,
     $    SURFS, PLANAR, RANGE, HHLIM
      DOUBLE PRECISION NORMAL
      PARAMETER (CHCYLI = 1, CHLIMB = 1, NP = 1, LEAVES = 4, SCALE = 13,
     $    FIRSTT = 13, HASCYL = 258, EXACT3 = 1, EXACT5 = 2, RLEAST = 3,
     $    HDNP = 1, HDEX3 = 2, HDEX5 = 3, HDSCAL = 4, HDLEAS = 5,
     $    HDLIMB = 6, SURFS = 8, PLANAR = 3, RANGE = 6, HHLIM = 88,
     $    NORMAL = 2.0D0**(-1022))
      INTEGER HHFINI, HHHOLD, HHKIND, TSINLI, TSLCOU, TSPLC4, ALL, I, K,
     $    Z
      CALL TSLAYO(CTL, RCTL, HNT, LSID, LSD)
      CTL(NP) = COUNT
      INFO = -8
      IF (COUNT .LT. 0 .OR. COUNT .GT. N) RETURN
C     a NaN is no number of points, either
      IF (HHKIND(HEADER(HDNP)) .EQ. 3) RETURN
      IF (ABS(HEADER(HDNP) - DBLE(COUNT)) .GT. 0.0D0) RETURN
      IF (KNOWN(1) .LE. -PLANAR .AND. KNOWN(1) .GE. -RANGE) THEN
        INFO = -KNOWN(1)
        RETURN
      END IF
      DO 10 K = 1, 4
        I = KNOWN(K)
        IF (I .LT. 1 .OR. I .GT. N) RETURN
        IF (TSPLC4(KNOWN, 1, I) .LT. K) RETURN
        Z = REP(I)
        IF (Z .LT. 1 .OR. Z .GT. COUNT) RETURN
        IF (ORD(Z) .NE. I) RETURN
        CTL(FIRSTT+K) = Z
   10 CONTINUE
      IF (COUNTS(1) .LT. 0 .OR. COUNTS(1) .GT. SURFS) RETURN
      CTL(LEAVES) = TSLCOU(COUNT)
      RCTL(EXACT3) = HEADER(HDEX3)
      RCTL(EXACT5) = HEADER(HDEX5)
      CTL(SCALE) = INT(HEADER(HDSCAL))
      RCTL(RLEAST) = ABS(HEADER(HDLEAS))
      IF (CHLIMB .EQ. 1 .AND. HEADER(HDLEAS) .LT. 0.0D0) CALL TSCLUM(
     $    BOX, CTL, RCTL)
      IF (CHCYLI .EQ. 1 .AND. HEADER(HDLIMB) .GT. 0.0D0) HNT(HASCYL) = 1
      INFO = RANGE
      IF (ABS(HEADER(HDLIMB)) .GT. DBLE(HHLIM)) THEN
        IF (TSINLI(N, P) .EQ. 0) RETURN
      END IF
      ALL = 1
      IF (RCTL(RLEAST) .LT. NORMAL) ALL = N
      INFO = -8
      IF (HHFINI(ALL, P) .LT. ALL) RETURN
      INFO = RANGE
      IF (HHHOLD(ALL, P) .EQ. 1) INFO = 0
      END

C     TESSIX - make a search index, for TESSQU and TESSPA.
C
C       N       (in)   number of points, >= 0
C       P       (in)   3*N coordinates; TESSQU and TESSPA need them
C                      unchanged
C       LIW     (in)   length of IW, as TESSWK gives; 7*N + 600
C                      suffices, too.  With less, down to 2*N + 2*L + 5
C                      (see TESS; 2*N + N/12 + 7 always suffices), the
C                      search index has no room for the planes and
C                      spheres that many points are near, and there
C                      TESSPA and TESSQU take longer
C       IW      (out)  the search index.  For each INFO >= 0 but 6,
C                      IW(I) is the position, from 1 on, of point I in
C                      the sorted order (a duplicate has its first's).
C                      Points at close positions are close in space
C       LRW     (in)   length of RW, as TESSWK gives; or less, down to
C                      what TESS needs: then parts of surfaces and
C                      curves take longer
C       RW      (out)  the search index, too
C       INFO    (out)  0; 3 to 6 as TESS gives: there is no mesh, and
C                      TESSQU and TESSPA give the same; -1 for a bad N,
C                      -2 for a NaN or infinity in P, -3 and -5 for LIW
C                      and LRW that are too small
C
C     To copy a search index, copy the first 7*N + 600 elements of IW
C     (all of them, if there are fewer) and all of RW.  It serves in any
C     rounding mode and in any build with the same types.  TESS and
C     TESSRE in the same arrays destroy it.
C     TESSQU and TESSPA reject arrays that never held a search index.
C     They do not notice one that is damaged, or points that have
C     changed since it was made: then they may not end.
C
C     Cost: O(N log N), about a tenth of that of the mesh, a quarter
C     near planes and spheres.  With integers of 4 bytes IW and RW take
C     36 bytes a point at the least, 56 with room for planes and
C     spheres.
      SUBROUTINE TESSIX(N, P, LIW, IW, LRW, RW, INFO)
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER N, LIW, IW(*), LRW, INFO
      INTEGER LHEAD, INDXTR, SINGLE, INTMAX
      PARAMETER (LHEAD = 6, INDXTR = 5, SINGLE = 5, INTMAX = 2147483647)
      INTEGER TSLCOU, CYLS, K, LEFT, LIWMIN, LRWMIN, LVS, MARKS,
     $    NONE(4,1), OK, POOL, ROOMY, WHOLE
      NONE(1,1) = 0
      CALL TSBADA(N, P, 0, 0, 0, NONE, NONE, INTMAX, LRW, INFO)
      IF (INFO .NE. 0 .AND. INFO .NE. -9) RETURN
      LVS = TSLCOU(N)
      IF (INFO .EQ. -9) INFO = -5
      IF (LIW .LT. 2*N + 2*LVS + INDXTR) INFO = -3
      IF (INFO .NE. 0) RETURN
      INFO = SINGLE
      IF (N .EQ. 0) RETURN
      CALL TSLENG(N, LIWMIN, LRWMIN, POOL, MARKS, CYLS, OK)
      ROOMY = 0
      IF (CYLS .GT. 0 .AND. LRW - LRWMIN .GE. CYLS) ROOMY = 1
      LEFT = LIW - N
      WHOLE = 0
      IF (MARKS .GT. 0 .AND. LEFT - LIWMIN .GE. MARKS) WHOLE = 1
      K = 2*N + 2*LVS + INDXTR
      CALL TSINDE(N, RW, P, IW(N+1), RW(3*N+1), IW(2*N+INDXTR+1), IW,
     $            LEFT, RW(3*N+12*LVS-LHEAD+1), IW(2*N+1),
     $            IW(2*N+INDXTR), IW(K), LVS, LIW - K + 1, ROOMY, WHOLE,
     $            INFO)
      END

C     TSINDE - TESSIX with its workspace cut up as TSWORK's.
      SUBROUTINE TSINDE(N, X, P, ORD, BOX, ALIVE, REP, LIW, HEADER,
     $                  KNOWN, COUNT, COUNTS, LVS, LEFT, ROOMY, WHOLE,
     $                  INFO)
      INTEGER LCTL, LHNT, LRCTL, LSUP, NLISTS, LLSX, LFIRST, LLSD,
     $    TSLIST, LEAFPT, SURFS
      PARAMETER (LCTL = 17, LHNT = 261, LRCTL = 140, LSUP = 60,
     $    NLISTS = 7, LLSX = 4, LFIRST = -2, LLSD = 17, TSLIST = 448,
     $    LEAFPT = 48, SURFS = 8)
      INTEGER N, LVS, LEFT, ORD(N), ALIVE(2*LVS-1), REP(N), LIW,
     $    KNOWN(4), COUNT, COUNTS(LEFT), ROOMY, WHOLE, INFO
      DOUBLE PRECISION X(3,N), P(3,*), BOX(6,*), HEADER(*)
      INTEGER CHSURF, NP, FIRSTT, RANGE
      PARAMETER (CHSURF = 1, NP = 1, FIRSTT = 13, RANGE = 6)
      DOUBLE PRECISION LSD(LLSD,NLISTS), RCTL(LRCTL), SUP(LSUP,SURFS)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER CTL(LCTL), HNT(LHNT), GUESS(2), I, K,
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), V(3), Z
      CALL TSSORT(N, X, P, ORD, BOX, ALIVE, REP, CTL, RCTL, HNT, LSID,
     $            LSD, ROOMY, INFO)
      IF (INFO .EQ. 0) CALL TSFIRS(X, P, ORD, CTL, RCTL, V, INFO)
      IF (INFO .EQ. 0) THEN
        GUESS(1) = 0
        GUESS(2) = 0
C       ORD in the place of LINK: no star is complete, no entry is
C       COMPLE
        CALL TSAPEX(X, P, ORD, BOX, ALIVE, ORD, ORD, CTL, RCTL, HNT,
     $              SUP, LSX, LSID, LSD, V, GUESS, Z)
        DO 10 K = 1, 3
          KNOWN(K) = ORD(V(K))
          CTL(FIRSTT+K) = V(K)
   10   CONTINUE
        KNOWN(4) = ORD(Z)
        CTL(FIRSTT+4) = Z
      END IF
      IF (INFO .NE. RANGE) THEN
C       REP becomes number -> position: first of the points that stand
C       for themselves.  These are the I with ORD(REP(I)) = I, as ORD
C       holds no duplicate; a duplicate then takes the position of the
C       point that represents it
        DO 20 I = 1, CTL(NP)
          REP(ORD(I)) = I
   20   CONTINUE
        DO 30 I = 1, N
          K = REP(I)
          IF (K .GT. CTL(NP)) THEN
            REP(I) = REP(K)
          ELSE IF (ORD(K) .NE. I) THEN
            REP(I) = REP(K)
          END IF
   30   CONTINUE
      END IF
      IF (CHSURF .EQ. 1 .AND. INFO .EQ. 0) CALL TSSURV(N, X, P, ORD,
     $    BOX, ALIVE, REP, CTL, RCTL, HNT, SUP, LSX, LSID, LSD, LIW,
     $    KNOWN, COUNTS, LEFT, WHOLE)
      CALL TSWHDR(CTL, RCTL, HNT, HEADER, KNOWN, COUNT, COUNTS, INFO)
      END

C     TESSPA - all tetrahedra of the mesh that have one of certain
C     vertices.
C
C       N, P    (in)      the points of the search index
C       MINE    (in)      N marks: the tetrahedra wanted are those at
C                         each point I with MINE(I) not 0; a mark on a
C                         duplicate is one on the first point with its
C                         coordinates
C       MAXTET, NTET, TET, ADJ   as in TESSRE: NTET = 0, or the
C                         beginning of the part
C       LIW     (in)      length of IW, at least what TESS needs; if the
C                         search index knows planes or spheres, at least
C                         5*N + 18*L + 632: 6*N + 600 always suffices.
C                         The rest becomes pool:
C                         7*N + 600 + 19*M + 1800 is enough for M points
C                         marked, unless one has very many neighbours
C       IW      (in,out)  the search index as TESSIX left it, or a copy;
C                         what is behind it is workspace.  On return a
C                         search index again, which also knows the
C                         planes and spheres that the part found
C       LRW     (in)      length of RW, as for TESSIX
C       RW      (in)      the rest of the search index.  Threads may
C                         share it, each with an IW of its own
C       INFO    (out)     what TESSRE gives, but -4 for MAXTET, -5, -6,
C                         -7 for NTET, TET, ADJ, -8 and -10 for LIW and
C                         LRW, -9 where IW and RW hold no search
C                         index
C
C     Each tetrahedron appears once.  A facet without a marked vertex
C     stays open.  Parts are computed independently, yet agree on
C     everything, also where points are cospherical.  If each point is
C     marked in exactly one part, and from each part those tetrahedra
C     are taken whose vertex of least number is marked there, together
C     they are the mesh.  The recipe TRJOIN makes them one mesh.
      SUBROUTINE TESSPA(N, P, MINE, MAXTET, NTET, TET, ADJ, LIW, IW,
     $                  LRW, RW, INFO)
      DOUBLE PRECISION P(3,*), RW(*)
      INTEGER N, MINE(*), MAXTET, NTET, TET(4,*), ADJ(4,*), LIW, IW(*),
     $    LRW, INFO
      CALL TSBADA(N, P, 1, MAXTET, NTET, TET, ADJ, LIW, LRW, INFO)
      IF (INFO .EQ. 0) CALL TSWORK(N, P, 1, MINE, MAXTET, NTET, TET,
     $    ADJ, LIW, IW, LRW, RW, INFO)
      IF (INFO .LT. -1) INFO = INFO - 1
      END

C     ------------------------------------------------------------------
C     Queries
C
C     What comes first serves TESSQU and TESSLO.
C
C     One device does much of the work: a point Q is replaced by Q*,
C     which is Q moved by an infinitesimal step into the interior of
C     tetrahedron 1, of vertices V1 ... V4:
C       Q* = Q + e (V1 - Q) + e**2 (V2 - Q) + e**3 (V3 - Q) +
C            e**4 (V4 - Q)
C     for all small enough e > 0.  The orientation of a facet with a
C     point is an affine function of the point, so the sign for Q* is
C     the first nonzero one of the signs for Q, V1, V2, V3, V4.  One of
C     them is not 0, since V1 ... V4 are not in one plane: Q* is on no
C     facet, and is in the interior of exactly one tetrahedron if it is
C     in the hull of a triangulation.
C
C     A walk over the hull, H:
C       LHULL  = 10  -  its length
C       HFACET = 0   facet  behind it the vertices of the facet nearest
C               to Q so far
C       HFACE  = 3   face  behind it the vertices of its face that has
C               its nearest point in the interior: of an edge two, a
C               vertex twice
C       HTURNF = 7   turn_from  the vertex of the last facet to turn
C               away from
C       HPIVOT = 8   pivot  when turning about a vertex, the other that
C               stays
C       HTURNS = 9   turns_left  how many more facets may be met about
C               the vertex
C       HMAXTU = 10  max_turns  how many may be met about a vertex at
C               all
C     ------------------------------------------------------------------

C     TSORIQ - returns HHHORI of the facet F and the point Q.
      INTEGER FUNCTION TSORIQ(P, F, Q)
      INTEGER F(3)
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER HHHORI
      TSORIQ = HHHORI(P(1,F(1)), P(1,F(2)), P(1,F(3)), Q)
      END

C     TSORIP - returns HHHORI of the facet F and point I.
      INTEGER FUNCTION TSORIP(P, F, I)
      INTEGER F(3), I
      DOUBLE PRECISION P(3,*)
      INTEGER TSORIQ
      TSORIP = TSORIQ(P, F, P(1,I))
      END

C     TSFOOT - HHFOOT of the facet F and the point Q.
      SUBROUTINE TSFOOT(P, F, Q, WANT, W, SET)
      INTEGER F(*), WANT, SET
      DOUBLE PRECISION P(3,*), Q(3), W(3)
      CALL HHFOOT(P(1,F(1)), P(1,F(2)), P(1,F(3)), Q, WANT, W, SET)
      END

C     TSQSID (side_of_qstar) - returns 1 if Q* is outside the facet F,
C     -1 if it is inside, UNSURE if the limbs do not suffice; 0 only if
C     tetrahedron 1 is flat.  It takes one orientation unless Q is
C     exactly in the plane.
      INTEGER FUNCTION TSQSID(P, F, Q, V)
      INTEGER F(3), V(4,*)
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER HHHELD, TSORIP, TSORIQ, K, S
      S = TSORIQ(P, F, Q)
      DO 10 K = 1, 4
        IF (S .EQ. 0) THEN
          S = UNSURE
          IF (HHHELD(P(1,V(K,1))) .EQ. 1) S = TSORIP(P, F, V(K,1))
        END IF
   10 CONTINUE
      TSQSID = S
      END

C     TSEXIT (exit_facet) - OUT is the first facet of tetrahedron T of
C     TET, other than FROM, that Q* is beyond; 5 if there is none, 0 if
C     the limbs do not suffice.  V is tetrahedron 1.
      SUBROUTINE TSEXIT(P, TET, T, FROM, Q, V, OUT)
      INTEGER TET(4,*), T, FROM, V(4,*), OUT
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER UNSURE
      PARAMETER (UNSURE = 2)
      INTEGER TSQSID, F(3), K, S
      OUT = 0
      DO 10 K = 1, 4
        IF (K .EQ. FROM) GO TO 10
        CALL TSTETF(TET, T, K, F)
        S = TSQSID(P, F, Q, V)
        IF (S .EQ. UNSURE) RETURN
        IF (S .GT. 0) GO TO 20
   10 CONTINUE
   20 OUT = K
      END

C     TSNEAR (nearer_max_norm) - OK is 1 if point I is nearer to Q, in
C     the maximum norm, than the distance HI - LO, which becomes the
C     distance of I, left unevaluated so that nothing is rounded; or 0.
C     HI < LO means that there is no point yet.
      SUBROUTINE TSNEAR(P, I, Q, HI, LO, OK)
      INTEGER I, OK
      DOUBLE PRECISION P(3,*), Q(3), HI, LO
      DOUBLE PRECISION A, B, H, L
      INTEGER HHWIDE, K
      A = 0.0D0
      B = 0.0D0
      DO 10 K = 1, 3
        H = MAX(P(K,I), Q(K))
        L = MIN(P(K,I), Q(K))
        IF (HHWIDE(H, L, A, B) .GT. 0) THEN
          A = H
          B = L
        END IF
   10 CONTINUE
      OK = 1
      IF (HI .GE. LO) OK = HHWIDE(HI, LO, A, B)
      IF (OK .LT. 1) OK = 0
      IF (OK .EQ. 0) RETURN
      HI = A
      LO = B
      END

C     TSHULL (hull_step) - takes one step towards the hull's point
C     nearest to Q, from a facet that Q is outside of.  G is the facet
C     met; H(HFACET+1) is 0 at first.  STEP is 1 if G is nearer than all
C     before, else 0; plus 2 at the end: the facet behind H(HFACET) is
C     then the nearest, and W its weights.  Until then, the next facet
C     to meet is the one on the other side of G's edge opposite to
C     H(HTURNF).  STEP is RANGE when the limbs do not suffice.
C
C     A facet's nearest point X is in the interior of one of its faces:
C     an edge, a vertex or all of it.  The facets around that face are
C     met.  If X is the nearest point of each of them that Q is outside
C     of, it is the nearest point of the hull: if a point of the hull is
C     nearer, there are such points Y arbitrarily near to X.  Where the
C     segment from Q to Y enters the hull, at a point nearer still, Q is
C     outside of a facet; and this facet contains X if Y is near enough,
C     as the segment from Q to X meets the hull in X alone.  All this is
C     exact, and each facet is nearer than the one before, so the walk
C     ends.
      SUBROUTINE TSHULL(P, Q, G, H, W, STEP)
      INTEGER LHULL
      PARAMETER (LHULL = 10)
      INTEGER G(3), H(LHULL), STEP
      DOUBLE PRECISION P(3,*), Q(3), W(3)
      INTEGER HFACET, HFACE, HTURNF, HPIVOT, HTURNS, HMAXTU, NONE,
     $    UNSURE, RANGE
      PARAMETER (HFACET = 0, HFACE = 3, HTURNF = 7, HPIVOT = 8,
     $    HTURNS = 9, HMAXTU = 10, NONE = 0, UNSURE = 2, RANGE = 6)
      INTEGER TSORIQ, ALIKE, CARRY, I, K, NEARER, SET, SHARED, SIDE
      NEARER = 1
      ALIKE = 1
      SHARED = 0
      STEP = RANGE
      CALL TSFOOT(P, G, Q, 0, W, SET)
      IF (SET .EQ. 0) RETURN
      IF (H(HFACET+1) .NE. NONE) THEN
        SIDE = TSORIQ(P, G, Q)
        IF (SIDE .EQ. UNSURE) RETURN
        DO 20 I = 1, 3
          CARRY = 0
          IF (G(I) .EQ. H(HFACE+1) .OR. G(I) .EQ. H(HFACE+2)) CARRY = 1
          IF (MOD(SET/2**(I-1), 2) .NE. CARRY) ALIKE = 0
          DO 10 K = 1, 3
            IF (G(I) .EQ. H(HFACET+K)) SHARED = SHARED + 1
   10     CONTINUE
   20   CONTINUE
        IF (SIDE .LE. 0 .OR. ALIKE .EQ. 1) NEARER = 0
      END IF
      STEP = NEARER
      IF (NEARER .EQ. 1) THEN
        H(HTURNS) = H(HMAXTU)
        K = 0
        DO 30 I = 1, 3
          H(HFACET+I) = G(I)
          IF (MOD(SET/2**(I-1), 2) .EQ. 1) THEN
            K = K + 1
            H(HFACE+K) = G(I)
          ELSE
            H(HPIVOT) = H(HTURNF)
            H(HTURNF) = G(I)
          END IF
   30   CONTINUE
        IF (K .EQ. 1) H(HFACE+2) = H(HFACE+1)
        IF (K .EQ. 3) STEP = 3
      ELSE
C       an edge has one more facet, a vertex a circle of them
        IF (H(HFACE+1) .NE. H(HFACE+2) .OR. SHARED .EQ. 3 .OR.
     $      H(HTURNS) .LT. 1) STEP = 2
        H(HTURNS) = H(HTURNS) - 1
        H(HTURNF) = H(HPIVOT)
        DO 40 I = 1, 3
          IF (G(I) .NE. H(HFACE+1) .AND. G(I) .NE. H(HTURNF))
     $      H(HPIVOT) = G(I)
   40   CONTINUE
      END IF
      IF (STEP .LT. 2) RETURN
      CALL TSFOOT(P, H, Q, 1, W, SET)
      IF (SET .EQ. 0) STEP = RANGE
      END

C     TSPOSN (position_near) - BEST is a position near Q: goes down the
C     tree by the cuts to a leaf, and takes its point nearest to Q in
C     the maximum norm.  All comparisons are exact, unless Q is far
C     outside, so it is the same everywhere.
      SUBROUTINE TSPOSN(P, ORD, BOX, CTL, Q, BEST)
      DOUBLE PRECISION P(3,*), BOX(6,*), Q(3)
      INTEGER ORD(*), CTL(*), BEST
      INTEGER LEAVES, SCALE
      PARAMETER (LEAVES = 4, SCALE = 13)
      DOUBLE PRECISION HHLDEX, HI, LO
      INTEGER FIRST, I, K, LAST, NODE, OK, SE
      SE = CTL(SCALE)
      NODE = 1
   10 IF (NODE .LT. CTL(LEAVES)) THEN
        NODE = 2*NODE
        K = 3
        IF (BOX(5,NODE) .LE. BOX(2,NODE+1)) K = 2
        IF (BOX(4,NODE) .LE. BOX(1,NODE+1)) K = 1
        IF (Q(K) .GE. HHLDEX(BOX(K,NODE+1), SE)) NODE = NODE + 1
        GO TO 10
      END IF
      CALL TSNRNG(CTL, NODE, FIRST, LAST)
      HI = 0.0D0
      LO = 1.0D0
      DO 20 I = FIRST, LAST
        CALL TSNEAR(P, ORD(I), Q, HI, LO, OK)
        IF (OK .EQ. 1) BEST = I
   20 CONTINUE
      END

C     TSCROS (cross_facet) - replaces U by the tetrahedron across its
C     facet K, whose apex becomes U(4).  OK is 1; or 0, and U as it was,
C     if that facet is on the hull.  ORD takes the place of LINK: no
C     star is complete, no entry is COMPLE.
      SUBROUTINE TSCROS(X, P, ORD, BOX, ALIVE, MARK, CTL, RCTL, HNT,
     $                  SUP, LSX, LSID, LSD, U, K, OK)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), MARK(*), CTL(*), HNT(*), LSID(*),
     $    U(4,1), K, OK
      INTEGER F(3), GUESS(2), I, Z
      GUESS(1) = 0
      GUESS(2) = 0
      CALL TSTETF(U, 1, K, F)
      CALL TSAPEX(X, P, ORD, BOX, ALIVE, ORD, MARK, CTL, RCTL, HNT, SUP,
     $            LSX, LSID, LSD, F, GUESS, Z)
      OK = 0
      IF (Z .EQ. 0) RETURN
      DO 10 I = 1, 3
        U(I,1) = F(I)
   10 CONTINUE
      U(4,1) = Z
      OK = 1
      END

C     TSTINM (tet_in_mesh) - OK is 1 if the tetrahedron U, positively
C     oriented, is one of the mesh, that is, if its ball is empty; or 0.
C     Where TSBEMP cannot tell: as in TSINCT, a point in the ball would
C     be on the inner side of one of the three facets at U(1), and so no
C     worse there than that facet's apex, which must be U's own vertex.
      SUBROUTINE TSTINM(X, P, ORD, BOX, ALIVE, MARK, CTL, RCTL, HNT,
     $                  SUP, LSX, LSID, LSD, U, OK)
      DOUBLE PRECISION X(3,*), P(3,*), BOX(6,*), RCTL(*), SUP(*),
     $    LSD(*)
      REAL LSX(*)
      INTEGER ORD(*), ALIVE(*), MARK(*), CTL(*), HNT(*), LSID(*), U(4),
     $    OK
      INTEGER CHNEAR, UNSURE
      PARAMETER (CHNEAR = 1, UNSURE = 2)
      INTEGER F(3), GUESS(2), K, Z
      OK = UNSURE
      IF (CHNEAR .EQ. 1) CALL TSBEMP(X, P, ORD, BOX, ALIVE, MARK, CTL,
     $    RCTL, HNT, SUP, LSX, LSID, LSD, U, OK)
      IF (OK .NE. UNSURE) RETURN
      OK = 0
      GUESS(2) = 0
      F(1) = U(1)
      DO 20 K = 1, 3
        F(2) = U(MOD(K,3)+2)
        F(3) = U(MOD(K+1,3)+2)
        GUESS(1) = U(K+1)
        CALL TSAPEX(X, P, ORD, BOX, ALIVE, ORD, MARK, CTL, RCTL, HNT,
     $              SUP, LSX, LSID, LSD, F, GUESS, Z)
        IF (Z .NE. U(K+1)) RETURN
   20 CONTINUE
      OK = 1
      END

C     TESSQU - the tetrahedron that holds a place, without a mesh.
C
C       N, P, IW, RW  (in)  points and their search index.  Threads may
C                      share them
C       Q    (in)      the place: 3 coordinates
C       V    (in,out)  4 points.  On entry an earlier answer, where the
C                      walk starts, or V(1) = 0 for anywhere.  On return
C                      the vertices of the tetrahedron, positively
C                      oriented
C       W    (out)     4 barycentric weights of Q: the sum of W(K) *
C                      VALUE(V(K)) interpolates linearly
C       INFO (out)     0 or 1 as TESSLO gives; what TESSIX gave, if that
C                      was not 0; -1 for a bad N, -3 where IW and RW
C                      hold no search index, -5 for a NaN or infinity in
C                      Q, -6 for a V that is no tetrahedron.  A V that
C                      is one, but not of the mesh, such as an answer
C                      from another search index, does no harm
C
C     The answer is that of TESSLO in the mesh that TESS gives.  Only
C     the order of the vertices may differ and, for Q outside, which of
C     the hull triangles that have the nearest point is found.
C
C     Cost: a search for an apex for each tetrahedron that the walk
C     crosses, and for Q outside for each that is passed while turning
C     about an edge of the hull.  One more search proves the answer if a
C     start is given; without one about 20 find a start.  A mesh is
C     faster from some N/6 places on if they are scattered, N/3 if each
C     is close to the one before.  A globe of 20,000 points takes 150
C     times as long from a search index that has no room for its sphere.
C
C     How: the walk of TSWALK, with Q* moved into the same tetrahedron,
C     and for a Q outside that of TSNEAH, so that the answer is that of
C     TESSLO; neighbours are computed as they are needed.  If the V
C     given is a tetrahedron of the mesh, so are all that the walk
C     meets.  If not, the walk might cycle, or end at another that is
C     none: after NP steps, or there, it starts again from one that is.
      SUBROUTINE TESSQU(N, P, IW, RW, Q, V, W, INFO)
      DOUBLE PRECISION P(3,*), RW(*), Q(3), W(4)
      INTEGER N, IW(*), V(4), INFO
      INTEGER LHEAD, INDXTR, SINGLE
      PARAMETER (LHEAD = 6, INDXTR = 5, SINGLE = 5)
      INTEGER TSLCOU, CYLS, LIW, LRW, LVS, MARKS, OK, POOL
      INFO = -1
      CALL TSLENG(N, LIW, LRW, POOL, MARKS, CYLS, OK)
      IF (OK .EQ. 0) RETURN
      INFO = SINGLE
      IF (N .EQ. 0) RETURN
      LVS = TSLCOU(N)
      CALL TSQUER(N, RW, P, IW(N+1), RW(3*N+1), IW(2*N+INDXTR+1), IW,
     $            RW(3*N+12*LVS-LHEAD+1), IW(2*N+1), IW(2*N+INDXTR),
     $            IW(2*N+2*LVS+INDXTR), LVS, Q, V, W, INFO)
      END

C     TSQUER - TESSQU with the index cut up as TSWORK's workspace.
      SUBROUTINE TSQUER(N, X, P, ORD, BOX, ALIVE, REP, HEADER, KNOWN,
     $                  COUNT, COUNTS, LVS, Q, V, W, INFO)
      INTEGER LCTL, LHNT, LRCTL, LSUP, NLISTS, LLSX, LFIRST, LLSD,
     $    LHULL, TSLIST, LEAFPT, SURFS
      PARAMETER (LCTL = 17, LHNT = 261, LRCTL = 140, LSUP = 60,
     $    NLISTS = 7, LLSX = 4, LFIRST = -2, LLSD = 17, LHULL = 10,
     $    TSLIST = 448, LEAFPT = 48, SURFS = 8)
      INTEGER N, LVS, ORD(N), ALIVE(2*LVS-1), REP(N), KNOWN(4,1), COUNT,
     $    COUNTS(*), V(4,1), INFO
      DOUBLE PRECISION X(3,N), P(3,*), BOX(6,2*LVS-1), HEADER(*), Q(3),
     $    W(4)
      INTEGER CHSURF, NP, NSURF, EXACT3, HFACET, HTURNF, HMAXTU, NONE,
     $    RANGE
      PARAMETER (CHSURF = 1, NP = 1, NSURF = 261, EXACT3 = 1,
     $    HFACET = 0, HTURNF = 7, HMAXTU = 10, NONE = 0, RANGE = 6)
      DOUBLE PRECISION LSD(LLSD,NLISTS), RCTL(LRCTL), SUP(LSUP,SURFS),
     $    XF(3)
      REAL LSX(TSLIST,LLSX,NLISTS)
      INTEGER HHFINI, HHHOLD, HHPORI, TSPLC4, AT, CTL(LCTL), HNT(LHNT),
     $    FROM, F(3), G(4,1), H(LHULL), I, K,
     $    LSID(LFIRST:TSLIST+LEAFPT,NLISTS), OK, S, STEPS, U(4,1), Z
      CALL TSOPEN(N, P, ORD, BOX, REP, CTL, RCTL, HNT, LSID, LSD,
     $            HEADER, KNOWN, COUNT, COUNTS, INFO)
      IF (INFO .LT. 0) INFO = -3
      IF (INFO .NE. 0) RETURN
      INFO = -5
      IF (HHFINI(1, Q) .EQ. 0) RETURN
      IF (CHSURF .EQ. 1) CALL TSSOFI(X, CTL, HNT, SUP, COUNTS)
C     where the marks are, if there are any
      AT = 1
      IF (HNT(NSURF) .GT. 0) AT = 2
      INFO = -6
      STEPS = 0
      IF (V(1,1) .NE. 0) THEN
        DO 20 K = 1, 4
          IF (V(K,1) .LT. 1 .OR. V(K,1) .GT. N) RETURN
          U(K,1) = REP(V(K,1))
          IF (ORD(U(K,1)) .NE. V(K,1)) RETURN
   20   CONTINUE
        IF (HHPORI(X, P, ORD, RCTL(EXACT3), U(1,1), U(2,1), U(3,1),
     $      U(4,1)) .LE. 0) RETURN
        STEPS = CTL(NP)
      END IF
      DO 30 K = 1, 4
        W(K) = 0.0D0
   30 CONTINUE
      INFO = RANGE
      IF (HHHOLD(1, Q) .EQ. 0) RETURN
      FROM = 5
   40 IF (STEPS .EQ. 0) THEN
        CALL TSPOSN(P, ORD, BOX, CTL, Q, S)
C       ORD in the place of LINK: see TSCROS
        CALL TSINCT(X, P, ORD, BOX, ALIVE, ORD, COUNTS(AT), CTL, RCTL,
     $              HNT, SUP, LSX, LSID, LSD, S, U)
        FROM = 5
      END IF
      IF (STEPS .GE. 0) STEPS = STEPS - 1
      DO 50 K = 1, 4
        V(K,1) = ORD(U(K,1))
   50 CONTINUE
      CALL TSEXIT(P, V, 1, FROM, Q, KNOWN, K)
      IF (K .EQ. 0) RETURN
      FROM = 4
      OK = 0
      IF (K .LT. 5) CALL TSCROS(X, P, ORD, BOX, ALIVE, COUNTS(AT), CTL,
     $    RCTL, HNT, SUP, LSX, LSID, LSD, U, K, OK)
      IF (OK .EQ. 1) GO TO 40
      IF (STEPS .GE. 0) THEN
        CALL TSTINM(X, P, ORD, BOX, ALIVE, COUNTS(AT), CTL, RCTL, HNT,
     $              SUP, LSX, LSID, LSD, U, OK)
        IF (OK .EQ. 0) THEN
          STEPS = 0
          GO TO 40
        END IF
      END IF
      IF (K .EQ. 5) THEN
        CALL HHWEIG(P, V, 1, Q, W, INFO)
        IF (INFO .NE. 0) INFO = RANGE
        RETURN
      END IF
      H(HFACET+1) = NONE
      H(HTURNF) = NONE
      H(HMAXTU) = CTL(NP)
   60 DO 70 I = 1, 4
        G(I,1) = ORD(U(I,1))
   70 CONTINUE
      CALL TSTETF(G, 1, K, F)
      CALL TSHULL(P, Q, F, H, XF, S)
      IF (S .EQ. RANGE) RETURN
      IF (MOD(S, 2) .EQ. 1) THEN
        DO 80 I = 1, 4
          V(I,1) = G(I,1)
   80   CONTINUE
      END IF
      IF (S .GE. 2) GO TO 100
C     as TSTURN does
      Z = REP(H(HTURNF))
   90 I = TSPLC4(U, 1, Z)
      Z = U(K,1)
      K = 4
      CALL TSCROS(X, P, ORD, BOX, ALIVE, COUNTS(AT), CTL, RCTL, HNT,
     $            SUP, LSX, LSID, LSD, U, I, OK)
      IF (OK .EQ. 1) GO TO 90
      K = I
      GO TO 60
  100 DO 110 I = 1, 3
        W(TSPLC4(V, 1, H(HFACET+I))) = XF(I)
  110 CONTINUE
      INFO = 1
      END

C     ==================================================================
C     PART IV: USING A MESH
C
C     What follows takes a mesh as it is, or four points.
C     ==================================================================

C     ------------------------------------------------------------------
C     Location
C
C     Constants:
C       STSTEP = 12  START_STEPS  steps from a given start after which a
C               location looks for a better one.  With 8, ordered
C               queries among 100,000 points take a quarter longer than
C               with 16; with 32, unordered ones take 1.4 times as long
C               as with 8
C       OUTSTP = 99  OUT_OF_STEPS  an answer of TSWALK: its steps are
C               used up
C     ------------------------------------------------------------------

C     TSSTRT (choose_start) - chooses where the walk to Q starts: among
C     START, if not 0, and about NTET**(1/4) equally spaced tetrahedra,
C     BEST is the first whose first vertex is nearest to Q in the
C     maximum norm.  The comparisons are exact, so the choice is the
C     same everywhere.  BEST is 0 if the arithmetic cannot hold a point.
      SUBROUTINE TSSTRT(P, NTET, TET, Q, START, BEST)
      INTEGER NTET, TET(4,*), START, BEST
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER NONE
      PARAMETER (NONE = 0)
      DOUBLE PRECISION HI, LO
      INTEGER HHHELD, FIRST, I, MANY, OK, T
      MANY = 1
   10 IF (MANY*MANY .LT. NTET/(MANY*MANY)) THEN
        MANY = MANY + 1
        GO TO 10
      END IF
      HI = 0.0D0
      LO = 1.0D0
      FIRST = 1
      IF (START .NE. NONE) FIRST = 0
      DO 30 I = FIRST, MANY
        T = START
        IF (I .GT. 0) T = (I - 1)*(NTET/MANY) + 1
        IF (HHHELD(P(1,TET(1,T))) .EQ. 0) THEN
          BEST = NONE
          RETURN
        END IF
        CALL TSNEAR(P, TET(1,T), Q, HI, LO, OK)
        IF (OK .EQ. 1) BEST = T
   30 CONTINUE
      END

C     TSWALK (walk) - walks from T across facets K that Q* is beyond.
C     INFO is 0 when there is none: T contains Q*; 1 at a facet of the
C     hull that Q* is outside of; OUTSTP after MOST steps; RANGE when
C     the limbs do not suffice, or HHHELD does not pass a vertex; -4 for
C     a facet that is open, or a neighbour that is out of range or does
C     not match.
C
C     In a result of TESS the walk meets no tetrahedron twice.  Lift
C     each point X to the height |X|**2, lowered as the tie rule says:
C     the tetrahedra are the lower facets of a convex polytope, and
C     where Q* is beyond the facet from T to U, the plane of U is above
C     that of T over Q*.  So the height of the current plane over Q*
C     grows with every step.  (Among cospherical tetrahedra of another
C     triangulation the height may stay, and the walk may cycle.)
      SUBROUTINE TSWALK(P, NTET, TET, ADJ, Q, MOST, T, K, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), MOST, T, K, INFO
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER OUTSTP, NONE, RANGE
      PARAMETER (OUTSTP = 99, NONE = 0, RANGE = 6)
      INTEGER HHHELD, TSPLC4, FROM, I, STEPS, U
      FROM = 5
      INFO = RANGE
      DO 10 I = 1, 4
        IF (HHHELD(P(1,TET(I,T))) .EQ. 0) RETURN
   10 CONTINUE
      DO 20 STEPS = 1, MOST
        CALL TSEXIT(P, TET, T, FROM, Q, TET, K)
        INFO = RANGE
        IF (K .EQ. 0) RETURN
        INFO = 0
        IF (K .EQ. 5) RETURN
        U = ADJ(K,T)
        INFO = 1
        IF (U .EQ. NONE) RETURN
        INFO = -4
        IF (U .LT. 1 .OR. U .GT. NTET) RETURN
        FROM = TSPLC4(ADJ, U, T)
        IF (FROM .EQ. 5) RETURN
        INFO = RANGE
        IF (HHHELD(P(1,TET(FROM,U))) .EQ. 0) RETURN
        T = U
   20 CONTINUE
      INFO = OUTSTP
      END

C     TSTURN (next_hull_facet) - turns from the hull facet K of
C     tetrahedron T about its edge opposite to the vertex Z to the hull
C     facet on the other side of that edge, whose vertex opposite to it
C     becomes Z.  OK is 1, or 0 if neighbours are out of range or do not
C     match.
      SUBROUTINE TSTURN(NTET, TET, ADJ, T, K, Z, OK)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, K, Z, OK
      INTEGER NONE
      PARAMETER (NONE = 0)
      INTEGER TSPLC4, F(3), I, STEPS, U
      OK = 0
      DO 10 STEPS = 1, NTET
        I = TSPLC4(TET, T, Z)
        IF (I .EQ. 5) RETURN
        U = ADJ(I,T)
        Z = TET(K,T)
        IF (U .EQ. NONE) THEN
          K = I
          OK = 1
          RETURN
        END IF
        IF (U .LT. 1 .OR. U .GT. NTET) RETURN
        CALL TSTETF(TET, T, I, F)
        CALL TSMATE(TET, F, U, K)
        IF (K .EQ. 5) RETURN
        T = U
   10 CONTINUE
      END

C     TSNEAH (nearest_on_hull) - walks from tetrahedron T, whose facet
C     START is a hull facet that Q is outside of, to the one with the
C     hull's point nearest to Q, and stores that point's weights in W,
C     which is 0 on entry.  INFO is 1, RANGE or -4.
      SUBROUTINE TSNEAH(P, NTET, TET, ADJ, Q, T, START, W, INFO)
      INTEGER LHULL
      PARAMETER (LHULL = 10)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, START, INFO
      DOUBLE PRECISION P(3,*), Q(3), W(4)
      INTEGER HFACET, HTURNF, HMAXTU, NONE, RANGE
      PARAMETER (HFACET = 0, HTURNF = 7, HMAXTU = 10, NONE = 0,
     $    RANGE = 6)
      DOUBLE PRECISION X(3)
      INTEGER HHHELD, TSPLC4, G(3), H(LHULL), K, OK, STEP, U
      U = T
      K = START
      H(HFACET+1) = NONE
      H(HTURNF) = NONE
      H(HMAXTU) = 4*NTET
   10 CALL TSTETF(TET, U, K, G)
      CALL TSHULL(P, Q, G, H, X, STEP)
      INFO = STEP
      IF (STEP .EQ. RANGE) RETURN
      IF (MOD(STEP, 2) .EQ. 1) T = U
      IF (STEP .LT. 2) THEN
        CALL TSTURN(NTET, TET, ADJ, U, K, H(HTURNF), OK)
        INFO = -4
        IF (OK .EQ. 0) RETURN
        INFO = RANGE
        IF (HHHELD(P(1,H(HTURNF))) .EQ. 0) RETURN
        GO TO 10
      END IF
      DO 20 K = 1, 3
        W(TSPLC4(TET, T, H(HFACET+K))) = X(K)
   20 CONTINUE
      INFO = 1
      END

C     TESSLO - the tetrahedron that holds a place.
C
C       P, NTET, TET, ADJ  (in)  a mesh of TESS with NTET >= 1
C       Q    (in)      the place: 3 coordinates
C       T    (in,out)  Set it to 0 at first, then leave it: on return it
C                      is the tetrahedron that holds Q, and a start for
C                      the next walk, which is short if the next Q is
C                      near.  For a Q inside the hull the answer does
C                      not depend on the start
C       W    (out)     4 barycentric weights of Q in it; they sum to
C                      one: the sum of W(K) * VALUE(TET(K,T))
C                      interpolates linearly
C       INFO (out)     0 when Q is inside the hull or on it; 1 when it
C                      is outside: W then holds the weights of the point
C                      of the hull nearest to Q, none negative, and T is
C                      the tetrahedron of a hull triangle that has this
C                      point, so that the interpolant is continuous in
C                      Q; -2 for NTET < 1; -4 where the walk shows that
C                      TET and ADJ are no finished mesh: it meets an
C                      open facet or a neighbour that is out of range
C                      or does not match, or takes NTET steps; -5 for a
C                      NaN or infinity in Q, -6 for a T that is out of
C                      range; 6, W = 0, when the arithmetic cannot hold
C                      the coordinates (see TESS), or the walk meets a
C                      vertex that has a NaN or an infinity
C
C     Inside, no weight is negative; a weight is 0 where Q is in the
C     plane of the facet opposite to its vertex, and otherwise only in a
C     sliver so thin that its vertices are coplanar but for rounding.
C     The weights sum to 1, and the sum of W(K) times vertex K is Q, to
C     rounding, in slivers too.  Outside, the one to three vertices that
C     carry the nearest point are decided exactly, and each weight is
C     right to rounding.  Do not extrapolate by the gradient of T:
C     tetrahedra at the hull are often slivers, whose gradients are far
C     steeper than the field's.
C
C     Cost: a walk of about NTET**(1/3)/2 steps without a start, of a
C     few from a near one; a bad start costs no more than none.  For Q
C     outside, another walk over the hull triangles.
C
C     How: a walk (see TSWALK); then, for a Q outside, a walk over the
C     hull (see TSHULL).
C
C     It is Q*, not Q, that is located.  The hull is convex and Q* is
C     nearer to its inside, so Q* is inside of it when Q is inside or on
C     its boundary, and then the answer depends on the points, TET and Q
C     alone.  For a Q outside, the start decides which of the facets
C     that have the hull's nearest point is found.
C
C     Beyond STSTEP tetrahedra from a start, the sampled start is used,
C     too.
      SUBROUTINE TESSLO(P, NTET, TET, ADJ, Q, T, W, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, INFO
      DOUBLE PRECISION P(3,*), Q(3), W(4)
      INTEGER STSTEP, OUTSTP, NONE, RANGE
      PARAMETER (STSTEP = 12, OUTSTP = 99, NONE = 0, RANGE = 6)
      INTEGER HHFINI, HHHOLD, CODE, K, START
      INFO = -2
      IF (NTET .LT. 1) RETURN
      INFO = -5
      IF (HHFINI(1, Q) .EQ. 0) RETURN
      INFO = -6
      IF (T .LT. NONE .OR. T .GT. NTET) RETURN
      DO 20 K = 1, 4
        W(K) = 0.0D0
   20 CONTINUE
      INFO = RANGE
      IF (HHHOLD(1, Q) .EQ. 0) RETURN
      CODE = OUTSTP
      IF (T .NE. NONE) CALL TSWALK(P, NTET, TET, ADJ, Q, STSTEP, T,
     $    K, CODE)
      IF (CODE .EQ. OUTSTP) THEN
        START = T
        CALL TSSTRT(P, NTET, TET, Q, START, T)
        IF (T .EQ. NONE) RETURN
        CALL TSWALK(P, NTET, TET, ADJ, Q, NTET, T, K, CODE)
      END IF
      IF (CODE .EQ. OUTSTP) CODE = -4
      INFO = CODE
      IF (CODE .EQ. 0) THEN
        CALL HHWEIG(P, TET, T, Q, W, INFO)
        IF (INFO .NE. 0) INFO = RANGE
      END IF
      IF (CODE .EQ. 1) CALL TSNEAH(P, NTET, TET, ADJ, Q, T, K, W,
     $    INFO)
      END

C     TSMEAN (weighted_mean) - returns the mean of four numbers V with
C     weights W that sum to a quarter, so that no sum overflows.  A NaN
C     makes it a NaN, an infinity that infinity, and -infinity comes
C     before the other: neither gets as far as an operation that would
C     set a flag.
      DOUBLE PRECISION FUNCTION TSMEAN(W, V)
      DOUBLE PRECISION W(4), V(4)
      DOUBLE PRECISION HUGE
      PARAMETER (HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023)
      DOUBLE PRECISION EDGE, HIGH, LOW, SUM
      INTEGER HHKIND, K
      DO 10 K = 1, 4
        TSMEAN = V(K)
        IF (HHKIND(V(K)) .EQ. 3) RETURN
   10 CONTINUE
      LOW = V(1)
      HIGH = V(1)
      DO 20 K = 2, 4
        IF (V(K) .LE. LOW) LOW = V(K)
        IF (V(K) .GE. HIGH) HIGH = V(K)
   20 CONTINUE
      TSMEAN = LOW
      IF (LOW .LT. -HUGE) RETURN
      TSMEAN = HIGH
      IF (HIGH .GT. HUGE) RETURN
      SUM = 0.0D0
      DO 30 K = 1, 4
        SUM = SUM + W(K)*V(K)
   30 CONTINUE
C     No rounding takes it beyond the numbers: here, so that 4 times the
C     sum does not overflow, and below, as 0.25 LOW may be rounded.
      EDGE = 0.25D0*HIGH
      IF (SUM .GE. EDGE) SUM = EDGE
      EDGE = 0.25D0*LOW
      IF (SUM .LT. EDGE) SUM = EDGE
      SUM = 4.0D0*SUM
      IF (SUM .GE. HIGH) SUM = HIGH
      IF (SUM .LT. LOW) SUM = LOW
      TSMEAN = SUM
      END

C     TESSVA - linear interpolation at many places.
C
C       P, NTET, TET, ADJ  (in)  a mesh of TESS with NTET >= 1
C       NV    (in)      values per point, >= 0
C       VALUE (in)      VALUE(NV,*): VALUE(J,I) is value J of point I;
C                       of duplicates the first one's counts
C       NQ    (in)      number of places, >= 0
C       Q     (in)      Q(3,NQ): their coordinates
C       T     (in,out)  T(NQ): Set all to 0 at first: each walk then
C                       starts from the previous answer, if that is
C                       near.  On return the tetrahedra found: T(I)
C                       itself for a place inside the hull or on it; for
C                       one outside -K, where K is a tetrahedron at the
C                       nearest hull triangle.  To interpolate other
C                       values at the same places pass T back as it is:
C                       then nothing is searched.  After a new mesh set
C                       it to 0 again
C       OUT   (out)     OUT(NV,NQ): OUT(J,I) is value J at place I; for
C                       a place outside the hull, value J at the nearest
C                       point of the hull (see TESSLO)
C       INFO  (out)     0; 1 when a place is outside the hull; -2 for
C                       NTET < 1, -5 for NV < 0, -7 for a bad NQ, -8 for
C                       a NaN or infinity in Q, -9 for a T that is out
C                       of range: then nothing is written; -4 or 6 as
C                       from TESSLO: then the places before that one
C                       are done
C
C     The interpolant is continuous and, but for rounding, within the
C     range of the data.  If a vertex whose weight is not 0 has the
C     value NaN, the result is NaN; otherwise, if one is infinite, it is
C     that infinity, or the negative one if there are both.  For another
C     value outside:
C
C           DO 10 I = 1, NQ
C              T(I) = 0
C        10 CONTINUE
C           CALL TESSVA(P, NTET, TET, ADJ, 1, VALUE, NQ, Q, T, OUT,
C          $            INFO)
C           DO 20 I = 1, NQ
C              IF (T(I) .LT. 0) OUT(I) = OUTSID
C        20 CONTINUE
C
C     Smoother and more accurate: the recipes TRSLOP and TRBENT.
C     (VALUE and OUT are declared as vectors, since NV may be 0.)
C     Cost: that of TESSLO: a few steps a place if successive places
C     are close to each other.  In random order each takes ten times as
C     long: sort them first, by the positions that TESSIX gives.
C
C     How: where there is no start, a walk starts from the last answer:
C     it is the nearest if the queries are in order, and if not, TESSLO
C     notices.
      SUBROUTINE TESSVA(P, NTET, TET, ADJ, NV, VALUE, NQ, Q, T, OUT,
     $                  INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), NV, NQ, T(*), INFO
      DOUBLE PRECISION P(3,*), VALUE(*), Q(3,*), OUT(*)
      INTEGER NONE, INTMAX
      PARAMETER (NONE = 0, INTMAX = 2147483647)
      DOUBLE PRECISION TSMEAN, V(4), W(4)
      INTEGER HHFINI, CODE, I, J, K, LAST, M, ROW(4)
      INFO = -2
      IF (NTET .LT. 1) RETURN
      INFO = -5
      IF (NV .LT. 0) RETURN
      INFO = -7
      IF (NQ .LT. 0 .OR. NQ .GT. (INTMAX - 1)/3) RETURN
      INFO = -8
      IF (HHFINI(NQ, Q) .LT. NQ) RETURN
      INFO = -9
      DO 10 I = 1, NQ
        IF (T(I) .LT. -NTET .OR. T(I) .GT. NTET) RETURN
   10 CONTINUE
      INFO = 0
      LAST = NONE
      DO 70 I = 1, NQ
        IF (T(I) .NE. NONE) LAST = ABS(T(I))
        CALL TESSLO(P, NTET, TET, ADJ, Q(1,I), LAST, W, CODE)
        IF (CODE .NE. 0 .AND. CODE .NE. 1) THEN
          INFO = CODE
          RETURN
        END IF
        T(I) = LAST
        IF (CODE .EQ. 1) T(I) = -LAST
        IF (CODE .EQ. 1) INFO = 1
        M = 1
        DO 20 K = 2, 4
          IF (W(K) .GT. W(M)) M = K
   20   CONTINUE
C       in place of a vertex of weight 0 one that counts
        DO 30 K = 1, 4
          ROW(K) = NV*(TET(M,LAST) - 1)
          IF (W(K) .GT. 0.0D0) ROW(K) = NV*(TET(K,LAST) - 1)
   30   CONTINUE
        DO 40 K = 1, 4
          W(K) = 0.25D0*W(K)
   40   CONTINUE
        DO 60 J = 1, NV
          DO 50 K = 1, 4
            V(K) = VALUE(ROW(K)+J)
   50     CONTINUE
          OUT(NV*(I-1)+J) = TSMEAN(W, V)
   60   CONTINUE
   70 CONTINUE
      END

C     ------------------------------------------------------------------
C     The hull.
C     ------------------------------------------------------------------

C     TESSHU - the hull triangles.
C
C       NTET, TET, ADJ  (in)  a mesh of TESS
C       MAXFAC  (in)   triangles that FAC has room for
C       NFAC    (out)  number of triangles
C       FAC     (out)  FAC(3,MAXFAC): triangle I has the vertices
C                      FAC(1,I), FAC(2,I), FAC(3,I), seen
C                      counter-clockwise from outside, in the order of
C                      the tetrahedra and their facets
C       INFO    (out)  0; 1 when FAC is too small: NFAC is then the
C                      number needed and the first MAXFAC triangles are
C                      set; -1 for NTET < 0, -4 for MAXFAC < 0
C
C     Cost: one pass over all facets.
      SUBROUTINE TESSHU(NTET, TET, ADJ, MAXFAC, NFAC, FAC, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), MAXFAC, NFAC, FAC(3,*), INFO
      INTEGER MORE
      PARAMETER (MORE = 1)
      INTEGER F(3), I, K, T
      NFAC = 0
      INFO = -1
      IF (NTET .LT. 0) RETURN
      INFO = -4
      IF (MAXFAC .LT. 0) RETURN
      DO 30 T = 1, NTET
        DO 20 K = 1, 4
          IF (ADJ(K,T) .GT. 0) GO TO 20
          NFAC = NFAC + 1
          IF (NFAC .GT. MAXFAC) GO TO 20
          CALL TSTETF(TET, T, K, F)
          DO 10 I = 1, 3
            FAC(I,NFAC) = F(I)
   10     CONTINUE
   20   CONTINUE
   30 CONTINUE
      INFO = 0
      IF (NFAC .GT. MAXFAC) INFO = MORE
      END

C     ------------------------------------------------------------------
C     The check
C
C     Uses of a point, and answers:
C       REPEAT = -1  REPEATED  uses of a point in TESSCH: a duplicate of
C               one of lower number,
C       UNUSED = 0   UNUSED  no duplicate, and in no tetrahedron,
C       USED   = 1   USED  no duplicate, and in a tetrahedron
C       BADIDX = 10  TESS_BAD_INDEX
C       BADTWI = 11  TESS_BAD_TWIN
C       BADSGN = 12  TESS_BAD_SIGN
C       BADOPN = 13  TESS_BAD_OPEN
C       BADADJ = 14  TESS_BAD_ADJ
C       BADBAL = 15  TESS_BAD_BALL
C       BADHUL = 16  TESS_BAD_HULL
C       BADCOV = 17  TESS_BAD_COVER
C       BADPOI = 18  TESS_BAD_POINT
C     ------------------------------------------------------------------

C     TSINTB (in_tet_box) - returns 1 if Q is in the closed box of
C     tetrahedron T, or 0: exact, and much cheaper than orientations.
      INTEGER FUNCTION TSINTB(P, TET, T, Q)
      INTEGER TET(4,*), T
      DOUBLE PRECISION P(3,*), Q(3)
      INTEGER HIGH, I, K, LOW
      TSINTB = 0
      DO 20 K = 1, 3
        LOW = 0
        HIGH = 0
        DO 10 I = 1, 4
          IF (P(K,TET(I,T)) .LE. Q(K)) LOW = 1
          IF (P(K,TET(I,T)) .GE. Q(K)) HIGH = 1
   10   CONTINUE
        IF (LOW .EQ. 0 .OR. HIGH .EQ. 0) RETURN
   20 CONTINUE
      TSINTB = 1
      END

C     TSMDUP (mark_duplicates) - sorts the points by their coordinates,
C     equal ones by number, and finds the use of each, REPEAT or UNUSED.
C     Runs of 1, 2, 4, ... are merged back and forth between the halves
C     of IW, places LO+1 ... MID and MID+1 ... HI; of equal points those
C     of the first run come first.  The uses begin behind IW(HALF); HALF
C     is 0 or N.
      SUBROUTINE TSMDUP(N, P, IW, HALF)
      INTEGER N, IW(*), HALF
      DOUBLE PRECISION P(3,*)
      INTEGER REPEAT, UNUSED
      PARAMETER (REPEAT = -1, UNUSED = 0)
      INTEGER TSLEXB, AT, FROM, HI, I, J, K, LO, MID, RUN, SECOND
      AT = 0
      DO 10 I = 1, N
        IW(I) = I
   10 CONTINUE
      RUN = 1
   20 IF (RUN .LT. N) THEN
        FROM = AT
        AT = N - AT
        LO = 0
   30   IF (LO .LT. N) THEN
          MID = N
          IF (RUN .LT. N - LO) MID = LO + RUN
          HI = N
          IF (RUN .LT. N - MID) HI = MID + RUN
          I = LO + 1
          J = MID + 1
          DO 40 K = LO + 1, HI
            IF (J .GT. HI) THEN
              SECOND = 0
            ELSE IF (I .GT. MID) THEN
              SECOND = 1
            ELSE
              SECOND = TSLEXB(P, IW(FROM+J), IW(FROM+I))
            END IF
            IF (SECOND .EQ. 0) THEN
              IW(AT+K) = IW(FROM+I)
              I = I + 1
            ELSE
              IW(AT+K) = IW(FROM+J)
              J = J + 1
            END IF
   40     CONTINUE
          LO = HI
          GO TO 30
        END IF
        IF (RUN .LT. N - RUN) THEN
          RUN = 2*RUN
        ELSE
          RUN = N
        END IF
        GO TO 20
      END IF
      HALF = N - AT
      DO 50 I = 1, N
        IW(HALF+IW(AT+I)) = UNUSED
        IF (I .GT. 1) THEN
          IF (TSLEXB(P, IW(AT+I-1), IW(AT+I)) .EQ. 0)
     $        IW(HALF+IW(AT+I)) = REPEAT
        END IF
   50 CONTINUE
      END

C     TSCHKP (check_planar) - checks that all points are in one plane:
C     that of point 1, F(1), of F(2), a point that differs from it, and
C     of F(3), the first point off their line.  Points before F(3) are
C     in it, so one pass is enough.
      SUBROUTINE TSCHKP(N, P, BAD, INFO)
      INTEGER N, BAD, INFO
      DOUBLE PRECISION P(3,*)
      INTEGER UNSURE, RANGE, BADPOI
      PARAMETER (UNSURE = 2, RANGE = 6, BADPOI = 18)
      INTEGER TSLINE, TSORIP, TSLEXB, F(3), I, S
      F(1) = 1
      F(2) = 1
      F(3) = 0
      DO 10 I = 2, N
        S = 0
        IF (F(3) .NE. 0) S = TSORIP(P, F, I)
        IF (S .NE. 0) THEN
          BAD = I
          INFO = BADPOI
          IF (S .EQ. UNSURE) INFO = RANGE
          RETURN
        END IF
        IF (F(3) .EQ. 0) F(3) = I*(1 - TSLINE(P, 1, F(2), I))
        IF (TSLEXB(P, 1, F(2)) .EQ. TSLEXB(P, F(2), 1)) F(2) = I
   10 CONTINUE
      INFO = 0
      END

C     TSCHKI (check_vertices) - checks that the vertices of tetrahedron
C     T are four points, none a duplicate of one of lower number, and
C     notes that they are used.
      SUBROUTINE TSCHKI(N, TET, IW, T, HALF, INFO)
      INTEGER N, TET(4,*), IW(*), T, HALF, INFO
      INTEGER REPEAT, USED, BADIDX, BADTWI
      PARAMETER (REPEAT = -1, USED = 1, BADIDX = 10, BADTWI = 11)
      INTEGER TSPLC4, I, V
      INFO = BADIDX
      DO 10 I = 1, 4
        V = TET(I,T)
        IF (V .LT. 1 .OR. V .GT. N) RETURN
        IF (TSPLC4(TET, T, V) .LT. I) RETURN
   10 CONTINUE
      INFO = BADTWI
      DO 20 I = 1, 4
        V = TET(I,T)
        IF (IW(HALF+V) .EQ. REPEAT) RETURN
        IW(HALF+V) = USED
   20 CONTINUE
      INFO = 0
      END

C     TSCHKF (check_neighbours) - checks that each facet of tetrahedron
C     T is on the boundary or matched, and that the neighbour's apex is
C     not inside the ball of T: this is symmetric, as being matched is,
C     so one of the two tests it.
      SUBROUTINE TSCHKF(P, NTET, TET, ADJ, T, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, INFO
      DOUBLE PRECISION P(3,*)
      INTEGER NONE, UNSURE, RANGE, BADADJ, BADBAL
      PARAMETER (NONE = 0, UNSURE = 2, RANGE = 6, BADADJ = 14,
     $    BADBAL = 15)
      INTEGER HHHINS, F(3), J, K, S, U
      DO 30 K = 1, 4
        U = ADJ(K,T)
        IF (U .EQ. NONE) GO TO 30
        INFO = BADADJ
        IF (U .LT. 1 .OR. U .GT. NTET) RETURN
        CALL TSTETF(TET, T, K, F)
        CALL TSMATE(TET, F, U, J)
        IF (J .EQ. 5) RETURN
        IF (ADJ(J,U) .NE. T) RETURN
        IF (U .LT. T) GO TO 30
        S = HHHINS(P(1,TET(1,T)), P(1,TET(2,T)), P(1,TET(3,T)),
     $      P(1,TET(4,T)), P(1,TET(J,U)))
        INFO = RANGE
        IF (S .EQ. UNSURE) RETURN
        INFO = BADBAL
        IF (S .GT. 0) RETURN
   30 CONTINUE
      INFO = 0
      END

C     TSCHKT (check_orientation) - checks that tetrahedron T is
C     positively oriented and has no open facet: returns 0 or the fault.
      INTEGER FUNCTION TSCHKT(P, TET, ADJ, T)
      INTEGER TET(4,*), ADJ(4,*), T
      DOUBLE PRECISION P(3,*)
      INTEGER UNSURE, OPEN, RANGE, BADSGN, BADOPN
      PARAMETER (UNSURE = 2, OPEN = -1, RANGE = 6, BADSGN = 12,
     $    BADOPN = 13)
      INTEGER TSORIP, TSPLC4, F(3), K, S
      DO 10 K = 1, 3
        F(K) = TET(K,T)
   10 CONTINUE
      S = TSORIP(P, F, TET(4,T))
      TSCHKT = 0
      IF (TSPLC4(ADJ, T, OPEN) .LE. 4) TSCHKT = BADOPN
      IF (S .NE. 1) TSCHKT = BADSGN
      IF (S .EQ. UNSURE) TSCHKT = RANGE
      END

C     TSCHKH (check_convex) - checks the boundary facets of tetrahedron
C     T: O is inside of each, and the apex of the next boundary facet at
C     each of its edges is not outside of it.  The two facets at an edge
C     run along it in opposite directions, so that one of them tests it.
C
C     Facets are known to be matched in pairs, so a step of TSTURN maps
C     (tetrahedron, facet in, facet out) one-to-one to the next such
C     triple; no step leads to the first triple, so none comes twice and
C     the turn ends.  For the same reason all turns together take at
C     most 6 NTET steps: each edge of each tetrahedron is passed once.
      SUBROUTINE TSCHKH(P, NTET, TET, ADJ, T, INFO)
      INTEGER NTET, TET(4,*), ADJ(4,*), T, INFO
      DOUBLE PRECISION P(3,*)
      INTEGER NONE, UNSURE, RANGE, BADHUL
      PARAMETER (NONE = 0, UNSURE = 2, RANGE = 6, BADHUL = 16)
      INTEGER TSORIP, TSQSID, F(3), I, J, K, OK, S, U, Z
      INFO = 0
      DO 20 K = 1, 4
        IF (ADJ(K,T) .NE. NONE) GO TO 20
        CALL TSTETF(TET, T, K, F)
        S = TSQSID(P, F, P(1,TET(1,1)), TET)
        DO 10 I = 1, 3
          IF (S .GT. 0 .OR. F(I) .GT. F(MOD(I, 3) + 1)) GO TO 10
          U = T
          J = K
          Z = F(MOD(I + 1, 3) + 1)
          CALL TSTURN(NTET, TET, ADJ, U, J, Z, OK)
          S = TSORIP(P, F, Z)
   10   CONTINUE
        IF (S .GT. 0) INFO = BADHUL
        IF (S .EQ. UNSURE) INFO = RANGE
        IF (INFO .NE. 0) RETURN
   20 CONTINUE
      END

C     TSCHKC (check_cover) - checks that tetrahedron T, if not 1, does
C     not contain O.
      SUBROUTINE TSCHKC(P, TET, T, INFO)
      INTEGER TET(4,*), T, INFO
      DOUBLE PRECISION P(3,*)
      INTEGER RANGE, BADCOV
      PARAMETER (RANGE = 6, BADCOV = 17)
      INTEGER TSINTB, K
      INFO = 0
      IF (T .EQ. 1) RETURN
      IF (TSINTB(P, TET, T, P(1,TET(1,1))) .EQ. 0) RETURN
      CALL TSEXIT(P, TET, T, 5, P(1,TET(1,1)), TET, K)
      IF (K .EQ. 0) INFO = RANGE
      IF (K .EQ. 5) INFO = BADCOV
      END

C     TESSCH - an exact proof that TET and ADJ are a Delaunay
C     tetrahedralization of P.
C
C       N, P, NTET, TET, ADJ  (in)  points and mesh
C       LIW   (in)   length of IW, at least 2 N
C       IW    (out)  workspace
C       BAD   (out)  the tetrahedron at fault, or the point (INFO 18),
C                    or 0
C       INFO  (out)  0 when proven, or the first fault found:
C           10  a vertex out of range, or twice in one
C           11  a vertex that is a duplicate of another one
C           12  coplanar vertices, or negatively oriented
C           13  an open facet: the mesh is unfinished
C           14  neighbour out of range, or not mutual
C           15  neighbour's apex inside the circumsphere
C           16  the hull is not closed, or not convex
C           17  the hull is covered more than once
C           18  a point is in no tetrahedron
C                    6 when the arithmetic cannot hold the points (see
C                    TESS).  Where points are cospherical every valid
C                    mesh passes.  NTET = 0 passes when all points are
C                    coplanar, else INFO is 18.  -1 for a bad N, -2 for
C                    a NaN or infinity in P, -3 for a bad NTET, -6 for
C                    LIW < 2 N
C
C     Cost: O(N log N) for sorting; one orientation and two inspheres
C     for each tetrahedron, and about three orientations for each
C     hull triangle.
C
C     How: by finitely many exact tests.  Let O be Q* for Q = the first
C     vertex of tetrahedron 1 (see "Queries"): a point in
C     the interior of tetrahedron 1 and on no facet's plane.  Tested
C     are:
C       1  each tetrahedron has four points as vertices, none a
C          duplicate of a point of lower index, and is positively
C          oriented;
C       2  each facet is on the boundary, or matched with a facet of
C          another tetrahedron that has the same vertices and lies on
C          the other side;
C       3  across a matched facet, the neighbour's apex is not inside
C          the ball;
C       4  O is inside of each boundary facet;
C       5  at each edge of a boundary facet, the next boundary facet,
C          found by turning about the edge through the tetrahedra, has
C          its apex not outside of the first;
C       6  no tetrahedron but 1 holds O;
C       7  each point that is no duplicate is a vertex.
C
C     a. For a point X on no facet let m(X) be the number of tetrahedra
C        that hold it.  By 1 and 2 it is the number of times that the
C        boundary, oriented outwards, winds about X: the sum of that
C        number over the surfaces of all tetrahedra, in which matched
C        facets cancel.  The turns of 5 pair the edges of boundary
C        facets, which thus form a closed surface S; two that are
C        adjacent run along their edge in opposite directions.
C     b. By 4, projection from O takes the facets of S to triangles on
C        the sphere of directions, all of one orientation, adjacent ones
C        on opposite sides of their edge.  So S covers the sphere,
C        branching at most at vertices, and the number of sheets is the
C        winding number about O: m(O), which is 1 by 6.  One sheet
C        cannot branch: each ray from O meets S once.  S bounds a body
C        K, star-shaped about O; m is 1 in K, 0 outside.
C     c. A plane through O that misses the vertices of S cuts K in a
C        polygon which is star-shaped about O and has by 5 no angle
C        above pi: convex.  Such planes are dense, so K is convex.
C     d. So the tetrahedra fill K once, facet matched to facet: any two
C        meet in a common face or not at all.  A triangulation of a
C        convex body that satisfies 3 is Delaunay (Delaunay's lemma).
C        By 7 it is one of all points, and K is their hull.
C
C     Conversely a Delaunay tetrahedralization passes: O is inside its
C     hull.
C
C     No test is redundant.  For 4: two tetrahedra apart; or the
C     tetrahedra on an axis and the edges of a star of five points about
C     it, O in a tip of the star.  For 6: join the 20 triangles of the
C     great icosahedron to its centre.  These tetrahedra pass all other
C     tests, and V - E + F - T = 1, though they cover the centre 7
C     times.  Euler's relation follows from the seven tests.
C
C     Nothing is relied on before it is tested: indices before points
C     are read, the matching of all facets before a turn.  INFO is 6
C     when the limbs do not suffice for a test.
      SUBROUTINE TESSCH(N, P, NTET, TET, ADJ, LIW, IW, BAD, INFO)
      INTEGER N, NTET, TET(4,*), ADJ(4,*), LIW, IW(*), BAD, INFO
      DOUBLE PRECISION P(3,*)
      INTEGER NONE, UNUSED, RANGE, BADPOI, INTMAX
      PARAMETER (NONE = 0, UNUSED = 0, RANGE = 6, BADPOI = 18,
     $    INTMAX = 2147483647)
      INTEGER HHFINI, HHHOLD, TSCHKT, I, HALF, PASS, T
      BAD = NONE
      INFO = -1
      IF (N .LT. 0 .OR. N .GT. (INTMAX - 1)/3) RETURN
      INFO = -2
      IF (HHFINI(N, P) .LT. N) RETURN
      INFO = -3
      IF (NTET .LT. 0 .OR. NTET .GT. (INTMAX - 3)/4) RETURN
      INFO = -6
      IF (LIW .LT. N .OR. LIW - N .LT. N) RETURN
      INFO = RANGE
      IF (HHHOLD(N, P) .EQ. 0) RETURN
      IF (NTET .EQ. 0) THEN
        CALL TSCHKP(N, P, BAD, INFO)
        RETURN
      END IF
      CALL TSMDUP(N, P, IW, HALF)
      DO 30 PASS = 1, 5
        DO 20 I = 1, NTET
          T = I
          IF (PASS .EQ. 1) CALL TSCHKI(N, TET, IW, T, HALF, INFO)
          IF (PASS .EQ. 2) INFO = TSCHKT(P, TET, ADJ, T)
          IF (PASS .EQ. 3) CALL TSCHKF(P, NTET, TET, ADJ, T, INFO)
          IF (PASS .EQ. 4) CALL TSCHKH(P, NTET, TET, ADJ, T, INFO)
          IF (PASS .EQ. 5) CALL TSCHKC(P, TET, T, INFO)
          IF (INFO .NE. 0) THEN
            BAD = T
            RETURN
          END IF
   20   CONTINUE
   30 CONTINUE
      DO 40 I = 1, N
        IF (IW(HALF+I) .EQ. UNUSED) THEN
          BAD = I
          INFO = BADPOI
          RETURN
        END IF
   40 CONTINUE
      END

C     ------------------------------------------------------------------
C     A ball.
C     ------------------------------------------------------------------

C     TESSBA - the circumsphere of a tetrahedron, rounded outwards.
C
C       P    (in)   the points
C       V    (in)   4 of them
C       C    (out)  the centre C(1) ... C(3), rounded, and the radius
C                   C(4), rounded up, so that the true circumsphere is
C                   inside: a point outside cannot alter a tetrahedron
C                   of these vertices.  The radius is the greatest
C                   double, all of space, where the vertices are
C                   coplanar or the circumsphere cannot be computed
C       INFO (out)  0; -1 for a NaN or infinity in the points, -2 for an
C                   index below 1; 6, with the radius the greatest
C                   double (see TESS)
C
C     How: by limbs, for a set of the four points alone, scaled to at
C     most 1.  LENGTH is the sum of what is rounded.  The centre errs
C     by 8 eps of its length (see HHCENT); the radius must cover that,
C     its own error of 12 eps, and the roundings of the sum, 1 eps of
C     it: less than 32 eps LENGTH.
      SUBROUTINE TESSBA(P, V, C, INFO)
      INTEGER LBALL
      PARAMETER (LBALL = 85)
      DOUBLE PRECISION P(3,*), C(4)
      INTEGER V(4), INFO
      INTEGER RANGE, DBLEXP
      DOUBLE PRECISION HUGE, NORMAL, ROUNDG
      PARAMETER (RANGE = 6, DBLEXP = 1024,
     $    HUGE = (2.0D0 - 2.0D0**(-52))*2.0D0**1023,
     $    NORMAL = 2.0D0**(-1022), ROUNDG = 64.0D0*2.0D0**(-52))
      DOUBLE PRECISION HHLDEX, LENGTH, MOST, R, T(LBALL), X(3)
      INTEGER HHFINI, HHFREX, HHHOLD, E, F(3), I, K, OK
      C(4) = HUGE
      MOST = 0.0D0
      DO 20 I = 4, 1, -1
        INFO = -2
        IF (V(I) .LT. 1) RETURN
        INFO = -1
        IF (HHFINI(1, P(1,V(I))) .EQ. 0) RETURN
        INFO = RANGE
        IF (HHHOLD(1, P(1,V(I))) .EQ. 0) RETURN
        DO 15 K = 1, 3
          C(K) = P(K,V(I))
          MOST = MAX(MOST, ABS(C(K)))
   15   CONTINUE
   20 CONTINUE
      INFO = 0
      IF (MOST .LE. 0.0D0) RETURN
      E = HHFREX(MOST)
      DO 30 K = 1, 3
        F(K) = K
   30 CONTINUE
      CALL HHCENT(P, V, E, F, 1, 4, X, T, OK)
      IF (OK .EQ. 0) RETURN
      LENGTH = 0.0D0
      R = 0.0D0
      DO 40 K = 1, 3
        LENGTH = LENGTH + ABS(X(K))
        R = R + X(K)*X(K)
        X(K) = X(K) + HHLDEX(C(K), -E)
        LENGTH = LENGTH + ABS(X(K))
   40 CONTINUE
      R = SQRT(R) + ROUNDG*LENGTH + 4.0D0*NORMAL
      IF (HHFREX(R + LENGTH) + E .GE. DBLEXP) RETURN
      DO 50 K = 1, 3
        C(K) = HHLDEX(X(K), E)
   50 CONTINUE
      C(4) = HHLDEX(R, E) + 4.0D0*NORMAL
      END

C     TESSED - the version of the compiled library: 10000 times the
C     major one plus 100 times the minor one plus the patch.
C     A tess.f and a hhpred.f of different versions do not link.
      INTEGER FUNCTION TESSED()
      TESSED = 50000
      END
