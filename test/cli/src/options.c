/* options.c - the command line of build/tess: one table, of what the options
 * are, where they go, and what `tess -h' says of them.
 */
#include "driver.h"

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define LEFT 14    /* characters of an option in -h before its text */
#define OUTPUTS 64 /* most files to write */

choices chosen;

static output outputs[OUTPUTS];
static int writing; /* of them */

typedef struct option {
    const char *name;
    const char *argument; /* a word for each part between blanks; 0: none */
    void (*take)(const struct option *o, char **word);
    const void *to;   /* of chosen; or a file's forms */
    const char *help; /* lines; where there is no name: a heading */
} option;

static const char *const before[] = {
    "usage: tess [options] [points]",
    "as in: tess -grid 50,50,9 -values out.csv mine.csv",
    "",
    "Delaunay tetrahedralization of points in space.",
    "",
    "points: a file of points, or - or nothing for standard input.  It may be",
    "  lines     x y z and any values; blanks, tabs, commas, semicolons or |",
    "            between them, one of these in a file; a line of names, or a",
    "            comment with names, of which x, y, z; east, north, rl; lon,",
    "            lat, depth or the like say which columns those are (if none",
    "            do it is asked: see -cols); a column of words is skipped, and",
    "            so is a first one that numbers the rows.  # begins a comment;",
    "            so do % ! and two slashes.  1.34D-01 is 1.34E-01; for decimal",
    "            commas see -decimal",
    "  a count   before such lines, or Qhull's dimension and number",
    "  .xyz      of atoms: number, comment, lines `element x y z'",
    "  .node     TetGen's; .off, .ply, .obj, .pcd, LAS: the points; PDB,",
    "            LAMMPS dumps: the atoms",
    "  .stl      the triangles' corners; .npy: NumPy's array, a row a point",
    "  tables    with heads: R's, GeoEAS's, Petrel's, CFD-Post's, Sea-Bird's,",
    "            ODV's, CCHDO's, well logs; GOCAD's vertices, Nastran's grid",
    "            points, PQR, Amber's restarts",
    "The content says which, whatever the name.  What is neither a point nor",
    "left out by its format is said, with its line, or an error.",
    "All further columns, attributes and markers are values, which go to the",
    "output; the picture shows the first."};

static const char *const after[] = {
    "exit status: 0  done; also for points that all lie in one plane, or on",
    "                one line, which have no tetrahedron: a message says so",
    "             1  this build's integers do not suffice, or -check found a",
    "                fault",
    "             2  wrong usage, unreadable input, unwritable output, not",
    "                enough memory, no room on the disk",
    "A signal, as of Ctrl-C, leaves nothing half written behind."};

/* ---- files to write ---- */

const form values_forms[] = {{".csv", 0}, {".npy", 0}, {".vtu", 0},
                             {".vtk", 0}, {".svg", 0}, {0, 0}};
const form errors_forms[] = {{".csv", 0}, {0, 0}};
const form cells_forms[] = {{".vtk", 0}, {0, 0}};
const form volumes_forms[] = {{".csv", 0}, {0, 0}};
const form faces_forms[] = {{".csv", 0}, {0, 0}};
static const form node_forms[] = {{".node", write_node}, {0, 0}};
static const form ele_forms[] = {{".ele", write_ele}, {0, 0}};
static const form neigh_forms[] = {{".neigh", write_ele}, {0, 0}};
static const form vtk_forms[] = {{".vtk", write_vtk}, {0, 0}};
static const form mesh_forms[] = {
    {".vtk", write_vtk},   {".vtu", write_vtu}, {".msh", write_msh},
    {".node", write_node}, {".ele", write_ele}, {".neigh", write_ele}, {0, 0}};
const form face_forms[] = {
    {".face", write_face}, {".obj", write_obj}, {".off", write_off},
    {".ply", write_ply},   {".stl", write_stl}, {".vtk", write_vtk},
    {".vtu", write_vtu},   {0, 0}};
const form iso_forms[] = {
    {".stl", write_stl}, {".obj", write_obj}, {".ply", write_ply},
    {".vtk", write_vtk}, {0, 0}};
const form svg_forms[] = {{".svg", 0}, {0, 0}};

/* add_output - one more file, in one of those forms. */
static void add_output(const char *name, const char *by, const form *all)
{
    output *o = outputs + writing++;
    const char *dot = strrchr(name, '.');
    char list[80] = "";

    if (writing > OUTPUTS) fail("more than %d files to write", OUTPUTS);
    if (strcmp(name, "/dev/stdout") == 0) name = "-";
    o->name = name;
    o->all = o->as = all;
    if (!dot || strchr(dot, '/')) return;
    while (o->as->ending && !ends_in(name, o->as->ending)) o->as++;
    if (o->as->ending) return;
    for (; all->ending; all++)
        strcat(strcat(list, !*list             ? ""
                            : all[1].ending ? ", "
                                            : " or "),
               all->ending);
    fail("%s %s: the name must end in %s", by, name, list);
}

output *next_output(const form *all, output *o)
{
    for (o = o ? o + 1 : outputs; o < outputs + writing; o++)
        if (!all || o->all == all) return o;
    return 0;
}

/* ---- what is done with an option's words ---- */

static void take_switch(const option *o, char **word)
{
    (void)word;
    *(int *)o->to = 1;
}

static void take_word(const option *o, char **word)
{
    *(const char **)o->to = word[0];
}

static void take_output(const option *o, char **word)
{
    add_output(word[0], o->name, (const form *)o->to);
}

static void take_levels(const option *o, char **word)
{
    double level[LEVELS];
    int many = list_numbers(o->name, word[0], LEVELS, level), k;

    if (many < 0) fail("%s: more than %d levels", o->name, LEVELS);
    for (k = 0; k < many; k++)
        if (!(level[k] >= -DBL_MAX) || !(level[k] <= DBL_MAX))
            fail("%s %s: a level is not finite", o->name, word[0]);
    add_output(word[1], o->name, (const form *)o->to);
    outputs[writing - 1].levels = word[0];
}

static void take_length(const option *o, char **word)
{
    double *x = (double *)o->to;

    if (list_numbers(o->name, word[0], 1, x) != 1 || !(*x > 0.0))
        fail("%s needs a length (tess -h helps)", o->name);
}

static void take_alpha(const option *o, char **word)
{
    double *x = (double *)o->to;

    chosen.automatic = strcmp(word[0], "auto") == 0;
    if (chosen.automatic)
        *x = DBL_MAX;
    else if (list_numbers(o->name, word[0], 1, x) != 1 || !(*x > 0.0))
        fail("%s needs a length, or the word auto (tess -h helps)", o->name);
}

static void take_view(const option *o, char **word)
{
    double *x = (double *)o->to;
    int k;

    for (k = 0; k < 2; k++)
        if (list_numbers(o->name, word[k], 1, x + k) != 1 ||
            !(x[k] >= -360.0) || !(x[k] <= 360.0))
            fail("%s needs two angles (tess -h helps)", o->name);
}

static void take_scale(const option *o, char **word)
{
    double *x = (double *)o->to;

    int many, k, good;

    x[2] = 1.0;
    many = list_numbers(o->name, word[0], 3, x);
    good = many >= 2;
    for (k = 0; k < 3; k++)
        good = good && x[k] != 0.0;
    if (!good)
        fail("%s needs three numbers, none of them 0, as 1,1,0.01, or two of "
             "points in a plane (tess -h helps)", o->name);
    chosen.scaled = many;
}

static void take_step(const option *o, char **word)
{
    double *x = (double *)o->to;
    int k, good;

    chosen.steps = list_numbers(o->name, word[0], 3, x);
    good = chosen.steps >= 2;
    for (k = 0; k < chosen.steps; k++)
        good = good && x[k] > 0.0;
    if (!good)
        fail("%s needs the sides of a block, as 10,10,5, or two of them in a "
             "plane (tess -h helps)", o->name);
}

static void take_pixels(const option *o, char **word)
{
    double *x = (double *)o->to;
    int k, good = list_numbers(o->name, word[0], 2, x) == 2;

    for (k = 0; k < 2; k++) good = good && x[k] >= 100.0 && x[k] <= 10000.0;
    if (!good)
        fail("%s needs a width and a height in pixels, as 900,640", o->name);
}

static void take_range(const option *o, char **word)
{
    double *x = (double *)o->to;

    if (list_numbers(o->name, word[0], 2, x) != 2 || !(x[0] < x[1]) ||
        !(x[1] - x[0] <= DBL_MAX))
        fail("%s needs two numbers, the first one below the second, as 0,5",
             o->name);
}

static void take_draw(const option *o, char **word)
{
    if (strcmp(word[0], "points") != 0 && strcmp(word[0], "whole") != 0 &&
        strcmp(word[0], "cut") != 0 && strcmp(word[0], "field") != 0 &&
        strcmp(word[0], "apart") != 0)
        fail("%s %s: choose points, whole, cut, field or apart", o->name,
             word[0]);
    take_word(o, word);
}

static void take_title(const option *o, char **word)
{
    if (strlen(word[0]) >= TEXT)
        fail("%s: at most %d characters", o->name, TEXT - 1);
    take_word(o, word);
}

static void take_box(const option *o, char **word)
{
    double *x = (double *)o->to;
    int k, good = list_numbers(o->name, word[0], 6, x) == 6;

    for (k = 0; k < 6; k += 2)
        good = good && x[k] < x[k + 1];
    if (!good)
        fail("%s needs X0,X1,Y0,Y1,Z0,Z1, each first one below the second "
             "(tess -h helps)", o->name);
    chosen.boxed = 1;
}

static void take_columns(const option *o, char **word)
{
    const char *c;
    int commas = 0;

    for (c = word[0]; *c; c++) commas += *c == ',';
    if (commas < 1 || (commas > 2 && o->to == &chosen.qcols))
        fail("%s needs three columns, as 2,3,4, or two of points in a plane "
             "(tess -h helps)", o->name);
    if (commas == 1) chosen.plane = 1;
    take_word(o, word);
}

/* take_digits - a number, from 1 to 17. */
static void take_digits(const option *o, char **word)
{
    double x;

    if (list_numbers(o->name, word[0], 1, &x) != 1 || !(x >= 1.0) ||
        !(x <= 17.0) || x != (double)(int)x)
        fail("%s needs a number from 1 to 17 (tess -h helps)", o->name);
    *(int *)o->to = (int)x;
}

/* take_folds - 10, if no number is given. */
static void take_folds(const option *o, char **word)
{
    double x = 10.0;

    if (word && (list_numbers(o->name, word[0], 1, &x) != 1 || !(x >= 2.0) ||
                 !(x <= (double)INT_MAX) || x != (double)(int)x))
        fail("%s needs a number of folds, from 2 on, as 10", o->name);
    *(long *)o->to = (long)x;
}

/* take_decimal - the sign itself. */
static void take_decimal(const option *o, char **word)
{
    if (strcmp(word[0], ",") != 0 && strcmp(word[0], ".") != 0)
        fail("%s needs the sign, a comma or a point: -decimal ,", o->name);
    *(int *)o->to = word[0][0];
}

/* take_nodata - numbers more. */
static void take_nodata(const option *o, char **word)
{
    double x[VOIDS], *to = (double *)o->to;
    int many = list_numbers(o->name, word[0], VOIDS, x), k;

    if (many < 0 || chosen.voids + many > VOIDS)
        fail("%s: more than %d numbers", o->name, VOIDS);
    for (k = 0; k < many; k++) to[chosen.voids++] = x[k];
}

/* take_below - a number from 0 to 1. */
static void take_below(const option *o, char **word)
{
    double *x = (double *)o->to;

    if (list_numbers(o->name, word[0], 1, x) != 1 || !(*x >= 0.0) ||
        !(*x <= 1.0))
        fail("%s needs a number from 0 to 1, as 0.5 (tess -h helps)", o->name);
    chosen.limits = 1;
}

static void take_base(const option *o, char **word)
{
    static const form *const all[] = {node_forms, ele_forms, neigh_forms,
                                      vtk_forms};
    char *name;
    int k;

    for (k = 0; k < 4; k++) {
        name = (char *)space((double)strlen(word[0]) + 7.0, 1);
        strcat(strcpy(name, word[0]), all[k]->ending);
        add_output(name, o->name, all[k]);
    }
}

static void take_help(const option *o, char **word);

static void take_version(const option *o, char **word)
{
    (void)o;
    (void)word;
    printf("tess %ld.%ld\n", TESS_VERSION / 10000, TESS_VERSION / 100 % 100);
    exit(0);
}

/* ---- the options ---- */

static const option table[] = {
    {"-cols", "X,Y,Z", take_columns, &chosen.cols,
     "the columns that are x, y, z, by number, from 1, or by\n"
     "name: -cols 2,3,4, -cols lon,lat,depth.  -cols X,Y,Z,V...\n"
     "names those, too, that are values; else all others are"},
    {"-plane", 0, take_switch, &chosen.plane,
     "points in a plane: the first two columns of -cols, or of\n"
     "all, or those named x, y, are coordinates, the others\n"
     "values.  So it is, too, by -cols X,Y; -qcols X,Y;\n"
     "-grid NX,NY; places of two numbers a line, in -query F;\n"
     "or if -validate had no values else.  (Points in space that\n"
     "lie in one plane have values there: of a place's foot)"},
    {"-skip", 0, take_switch, &chosen.skip,
     "drop rows from which a number is missing: an empty cell,\n"
     "NA, N/A, NaN, null, none, -, --, ., ?, #N/A or the like of\n"
     "spreadsheets, or FORTRAN's asterisks; how many is said"},
    {"-nodata", "V[,V...]", take_nodata, chosen.nodata,
     "drop rows of which a coordinate or a value is this number,\n"
     "as -9999, -99: any value, or with -cols X,Y,Z,V... any that\n"
     "is named there"},
    {"-below", "F", take_below, &chosen.below,
     "a value `<0.05', below a limit, is F times that: 0.5, 1, 0;\n"
     "one above, `>100', is the limit; how many is said"},
    {"-account", 0, take_switch, &chosen.account, 0},
    {"-decimal", ",", take_decimal, &chosen.decimal,
     "numbers that are read have decimal commas, no points; what\n"
     "separates them is a semicolon, a tab, or blanks; or a comma\n"
     "where numbers are in quotes"},
    {"-scale", "SX,SY[,SZ]", take_scale, chosen.scale,
     "stretch coordinates for the mesh: -scale 1,1,0.01 for\n"
     "degrees and metres, SX,SY in a plane.  All that is written\n"
     "has the given ones; -alpha measures in the stretched.  By\n"
     "1,1,-0.01 pictures show z downwards; else it is the same"},
    {"-check", 0, take_switch, &chosen.check,
     "prove the mesh, by exact arithmetic"},
    {0, 0, 0, 0, ""},
    {0, 0, 0, 0, "Files: F's ending says what it is; - is standard output,"},
    {0, 0, 0, 0, "and what else is said goes to standard error:"},
    {"-mesh", "F", take_output, mesh_forms,
     "write the tetrahedra and their points' values: F.vtk and\n"
     "F.vtu, for ParaView, with circumradii and volumes; F.msh,\n"
     "Gmsh's 4.1; F.node, the points, F.ele, the tetrahedra, or\n"
     "F.neigh, their neighbours, as TetGen (so do -vtk F, -node F,\n"
     "-ele F, -neigh F)"},
    {"-face", "F", take_output, face_forms,
     "write the hull triangles, with -alpha those of the boundary,\n"
     "seen counter-clockwise from outside: F.obj, F.off, F.ply,\n"
     "with values, F.stl, in words, F.vtk, F.vtu; or F.face,\n"
     "TetGen's, of .node's points"},
    {"-iso", "LEVEL[,LEVEL...] F", take_levels, iso_forms,
     "write the surface where the first value is LEVEL, linear in\n"
     "each tetrahedron: F.stl, F.ply, with the level, F.obj, F.vtk;\n"
     "seen counter-clockwise from where values are lower.  Its\n"
     "area is said, and its volume if it is closed"},
    {"-iso-closed", 0, take_switch, &chosen.closed,
     "close it along the hull, by what of that is above the level:\n"
     "so it encloses all that is above, as a grade shell does"},
    {"-vtk", "F", take_output, vtk_forms, 0},
    {"-node", "F", take_output, node_forms, 0},
    {"-ele", "F", take_output, ele_forms, 0},
    {"-neigh", "F", take_output, neigh_forms, 0},
    {"-binary", 0, take_switch, &chosen.binary, 0},
    {"-cells", "F", take_output, cells_forms,
     "write the Voronoi cells in a box as VTK polyhedra"},
    {"-volumes", "F.csv", take_output, volumes_forms,
     "write each point's x,y,z, its cell's volume, and number\n"
     "of faces, the point's number, the cell's area, neighbours\n"
     "(the box's sides x0 to z1 are -1 to -6, where it repeats\n"
     "itself none), values, the cell's centroid, and the name, a\n"
     "column of words as an atom's species, if the file has one;\n"
     "the volumes' sum is said; of a surface, STL, OFF, PLY, OBJ,\n"
     "whether it is closed, and its volume"},
    {"-faces", "F.csv", take_output, faces_forms,
     "write each face between cells once: point, neighbour (or\n"
     "side, as above), area, centroid, unit normal to it from the\n"
     "point, and what is added to the neighbour's position where\n"
     "the box repeats itself, in lengths"},
    {"-box", "X0,X1,Y0,Y1,Z0,Z1", take_box, chosen.box,
     "that box; if not given, that of an extended XYZ file's\n"
     "Lattice or a LAMMPS dump, or the points' own"},
    {"-periodic", 0, take_switch, &chosen.periodic,
     "the box repeats itself, or what a file's Lattice, CRYST1\n"
     "spans, of any shape, along the vectors that its pbc says:\n"
     "so do mesh, values and cells"},
    {"-svg", "F", take_output, svg_forms,
     "write a picture: cut open, or moved apart if they are few"},
    {"-draw", "points|whole|cut|field|apart", take_draw, &chosen.draw,
     "draw points; or tetrahedra: all, cut open, that without\n"
     "their edges, or moved apart"},
    {"-alpha", "R|auto", take_alpha, &chosen.alpha,
     "the alpha shape: write and draw no tetrahedron whose\n"
     "circumradius exceeds R, exactly; so there are the holes and\n"
     "hollows that the hull fills.  auto: the least R that leaves\n"
     "one piece, joined by facets, with all points; it is said"},
    {"-view", "A E", take_view, chosen.view,
     "draw as seen from azimuth A, from x to y, and elevation E\n"
     "above that plane, both in degrees; if not given, -68 28"},
    {"-title", "TEXT", take_title, &chosen.title,
     "above pictures, those of -values, too"},
    {"-unit", "V[,X[,Y,Z]]", take_title, &chosen.unit,
     "units of the first value and of x, y, z: -unit C,m"},
    {"-size", "W,H", take_pixels, chosen.pixels, "of pictures, in pixels"},
    {"-range", "LOW,HIGH", take_range, chosen.range,
     "of pictures' colours: so that several have the same; what is\n"
     "beyond has the last one"},
    {"-bare", 0, take_switch, &chosen.bare,
     "pictures without axes, colour bar, and texts"},
    {"-o", "BASE", take_base, 0,
     "write BASE.node BASE.ele BASE.neigh BASE.vtk"},
    {0, 0, 0, 0, ""},
    {0, 0, 0, 0, "The columns' values at other places:"},
    {"-grid", "X,Y[,Z]", take_word, &chosen.grid,
     "at places along x, y, z; two axes are for points in a plane.\n"
     "Each is N, so many over the points' bounding box, whose\n"
     "corners often lie outside the hull: see -outside; or\n"
     "FROM:TO:N, where one place is in the middle (a slice is\n"
     "Z:Z:1); or FROM:TO/SIDE, a block model: the centres of\n"
     "blocks of that side, the first one's from FROM on; so many\n"
     "as TO - FROM by SIDE, rounded.  NX,NY[,NZ],X0,X1,Y0,Y1[,Z0,Z1]\n"
     "is X0:X1:NX and so on"},
    {"-step", "SX,SY[,SZ]", take_step, chosen.step,
     "with -grid X0,X1,Y0,Y1[,Z0,Z1]: X0:X1/SX and so on"},
    {"-within", "D", take_length, &chosen.within,
     "a place farther than D from all points has no value, but\n"
     "NaN; measured in what is stretched by -scale"},
    {"-drop", 0, take_switch, &chosen.drop,
     "leave places without a value out of F.csv"},
    {"-query", "F", take_word, &chosen.query,
     "at the places of a file, which is read like the points; its\n"
     "other columns come back, as they are, in F.csv before the\n"
     "values"},
    {"-qcols", "X,Y,Z", take_columns, &chosen.qcols,
     "which columns of it are x, y, z"},
    {"-values", "F", take_output, values_forms,
     "write them: F.csv, places and values, in a grid x fastest;\n"
     "F.npy for numpy.load, shape (NZ,NY,NX,columns) of a grid,\n"
     "(NY,NX,columns) in a plane, (places,columns) of a file; for\n"
     "ParaView F.vtu, or of a grid F.vtk; F.svg, the picture of a\n"
     "slice: its first column"},
    {"-method", "M", take_word, &chosen.method,
     "linear in each tetrahedron, if not given; smooth, with\n"
     "gradients estimated at the points: most accurate for smooth\n"
     "fields, may leave the data's range; natural, by Sibson's\n"
     "natural neighbours; nearest, the nearest point's value,\n"
     "which may be a word, as a rock's name.  Duplicates count as\n"
     "one point, with their values' mean, or the first one's word"},
    {"-outside", "nearest|VALUE", take_word, &chosen.outside,
     "what places outside the hull, by more than their rounding,\n"
     "get: this value, or that at the hull's nearest point; if not\n"
     "given NaN"},
    {"-clip", 0, take_switch, &chosen.clip,
     "hold each column's values within the range of the points'"},
    {"-digits", "N", take_digits, &chosen.digits,
     "of values in F.csv; if not given as few as give each back"},
    {"-validate", "[K]", take_folds, &chosen.validate,
     "K-fold cross-validation (K = 10), folds drawn by chance, the\n"
     "same everywhere: print how well the other folds predict each\n"
     "one's values by each -method M,M,..., which is best, and how\n"
     "many values are beyond the data's range; of words, by\n"
     "-method nearest, how often each one is taken for which"},
    {"-by", "COLUMN", take_word, &chosen.by,
     "keep in one fold what this column, of numbers or words, says\n"
     "is one: boreholes, lines, flights.  Else neighbours in one\n"
     "tell of each other, and errors look too small"},
    {"-errors", "F.csv", take_output, errors_forms,
     "write -validate's x,y,z, fold, the points' other columns,\n"
     "values, and errors"},
    {0, 0, 0, 0, ""},
    {"-q", 0, take_switch, &chosen.quiet,
     "quiet: no summary, no progress; errors, and what is doubted,\n"
     "dropped or left out of the data, are said"},
    {"-version", 0, take_version, 0, "the version of the library"},
    {"-h", 0, take_help, 0, "this text; so do -help and --help"}};

#define OPTIONS (sizeof table / sizeof table[0])

/* show - an option's lines of -h. */
static void show(const option *o)
{
    const char *c;
    int at = 0;

    if (o->name)
        at = printf("  %s %s", o->name, o->argument ? o->argument : "");
    if (o->name && at >= LEFT) at = printf("\n") - 1;
    if (o->name) printf("%*s", LEFT - at, "");
    for (c = o->help; *c; c++) {
        putchar(*c);
        if (*c == '\n') printf("%*s", LEFT, "");
    }
    printf("\n");
}

static void take_help(const option *o, char **word)
{
    size_t k;

    (void)o;
    (void)word;
    for (k = 0; k < sizeof before / sizeof before[0]; k++)
        printf("%s\n", before[k]);
    printf("\n");
    for (k = 0; k < OPTIONS; k++)
        if (table[k].help) show(table + k);
    printf("\n");
    for (k = 0; k < sizeof after / sizeof after[0]; k++)
        printf("%s\n", after[k]);
    exit(0);
}

/* named - the option of that name. */
static const option *named(const char *name)
{
    size_t k;

    if (strncmp(name, "--", 2) == 0) name++;
    if (strcmp(name, "-help") == 0) name = "-h";
    for (k = 0; k < OPTIONS; k++)
        if (table[k].name && strcmp(table[k].name, name) == 0)
            return table + k;
    fail("unknown option %s (tess -h helps)", name);
    return 0;
}

/* words - of an option's argument; next is what follows, or 0.  An argument in
 * brackets is a number, and may be missing. */
static int words(const option *o, const char *next)
{
    const char *c;
    int many = o->argument != 0;

    if (many && o->argument[0] == '[')
        return next && *next && strspn(next, "0123456789") == strlen(next);
    for (c = o->argument; c && *c; c++) many += *c == ' ';
    return many;
}

void choose_options(int argc, char **argv)
{
    const option *o;
    int a, many;

    chosen.view[0] = -400.0;
    for (a = 1; a < argc; a++) {
        if (argv[a][0] == '-' && argv[a][1]) {
            o = named(argv[a]);
            many = words(o, argv[a + 1]);
            if (argc - 1 - a < many)
                fail("%s needs %s (tess -h helps)", o->name, o->argument);
            o->take(o, many > 0 ? argv + a + 1 : 0);
            a += many;
        } else if (chosen.input) {
            fail("more than one input: %s, %s", chosen.input, argv[a]);
        } else {
            chosen.input = argv[a];
        }
    }
    chosen.values = next_output(values_forms, 0) != 0;
    chosen.cells = next_output(cells_forms, 0) ||
                   next_output(volumes_forms, 0) || next_output(faces_forms, 0);
    check_values();
    if (chosen.closed && !next_output(iso_forms, 0))
        fail("-iso-closed is for -iso LEVEL F");
    if (chosen.periodic && next_output(iso_forms, 0))
        fail("-iso is not for -periodic: the surface would end at the box's "
             "tetrahedra, not at its sides");
    if (chosen.boxed && !chosen.cells && !chosen.periodic)
        warn("-box is for -cells, -volumes, -faces and -periodic alone");
    try_outputs();
}
