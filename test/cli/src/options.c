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
    "for example: tess -grid 50,50,9 -values out.csv mine.csv",
    "",
    "Computes the Delaunay tetrahedralization of points in space, and interpolates",
    "values between them.",
    "",
    "The points are read from a file, or from standard input if its name is - or",
    "missing.  The content, not the name, says which of these it is:",
    "  lines     x y z and any values, separated by blanks, tabs, commas,",
    "            semicolons or |, by one of these throughout the file.  A line",
    "            of names, or a comment with names, says which columns are the",
    "            coordinates: x, y, z; east, north, rl; lon, lat, depth and the",
    "            like; if none are, -cols is asked for.  Columns of words are",
    "            skipped, and so is a first column without a name that numbers",
    "            the rows.  Comments begin with #, %, ! or two slashes.  1.34D-01",
    "            is read as 1.34E-01; for decimal commas see -decimal",
    "  a count   before such lines, or Qhull's dimension and count",
    "  .xyz      atoms: a count, a comment, lines `element x y z'; PDB, PQR,",
    "            Amber restarts and LAMMPS dumps, too",
    "  .node     TetGen's points; of .off, .ply, .obj, .pcd and LAS the points",
    "  .stl      the corners of the triangles",
    "  .npy      NumPy's array, one row for each point",
    "  tables    with a head of their own: R's, GeoEAS's, Petrel's, CFD-Post's,",
    "            Sea-Bird's, ODV's, CCHDO's and well logs; GOCAD's vertices;",
    "            Nastran's grid points",
    "Whatever is neither a point nor something that the format leaves out is",
    "reported with its line, or is an error.  All other columns, attributes and",
    "markers are values, which are written with the points; pictures show the",
    "first one."};

static const char *const after[] = {
    "exit status: 0  done; also if all points lie in one plane or on one line, in",
    "                which case a message says so and there are no tetrahedra",
    "             1  this build's integers do not suffice, or -check found a fault",
    "             2  wrong usage, unreadable input, unwritable output, not enough",
    "                memory, or no room on the disk",
    "Nothing half written is left behind, not even after Ctrl-C."};

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
     "Name the columns that hold x, y and z, by number, counted from\n"
     "1, or by name: -cols 2,3,4 or -cols lon,lat,depth. All other\n"
     "columns are values, unless some are named as well:\n"
     "-cols X,Y,Z,V..."},
    {"-plane", 0, take_switch, &chosen.plane,
     "The points lie in a plane: the first two columns (of -cols, if\n"
     "it is given), or those named x and y, are coordinates, and the\n"
     "others are values. This is implied by -cols X,Y, by\n"
     "-qcols X,Y, by -grid NX,NY, by a file of places with two\n"
     "numbers a line, and by -validate when three columns would\n"
     "leave no value. (Points in space that happen to lie in one\n"
     "plane are interpolated there, at the foot of each place.)"},
    {"-skip", 0, take_switch, &chosen.skip,
     "Drop rows in which a number is missing: an empty cell, NA,\n"
     "N/A, NaN, null, none, -, --, ., ?, #N/A and what else\n"
     "spreadsheets write, or FORTRAN's asterisks. The number of rows\n"
     "dropped is reported."},
    {"-nodata", "V[,V...]", take_nodata, chosen.nodata,
     "Drop rows in which a coordinate or a value is one of these\n"
     "numbers, such as -9999,-99. With -cols X,Y,Z,V... only the\n"
     "columns named there are looked at."},
    {"-below", "F", take_below, &chosen.below,
     "Read `<0.05', a value below the limit of detection, as F times\n"
     "the limit, for example 0.5, 1 or 0, and `>100', one above it,\n"
     "as the limit. The number of such values is reported."},
    {"-account", 0, take_switch, &chosen.account, 0},
    {"-decimal", ",", take_decimal, &chosen.decimal,
     "Numbers in the input have a decimal comma and no point. The\n"
     "separator must then be a semicolon, a tab or blanks, or a\n"
     "comma if the numbers are in quotes."},
    {"-scale", "SX,SY[,SZ]", take_scale, chosen.scale,
     "Stretch the coordinates for the mesh: -scale 1,1,0.01 where x\n"
     "and y are in degrees and z is in metres; SX,SY in a plane.\n"
     "Everything written has the original coordinates, but lengths\n"
     "such as those of -alpha and -within are measured in stretched\n"
     "ones. With 1,1,-0.01 pictures have z downwards and nothing\n"
     "else changes."},
    {"-check", 0, take_switch, &chosen.check,
     "Prove the mesh correct in exact arithmetic."},
    {0, 0, 0, 0, ""},
    {0, 0, 0, 0, "Files to write.  The ending of F says what it is.  - is standard"},
    {0, 0, 0, 0, "output; the summary then goes to standard error."},
    {"-mesh", "F", take_output, mesh_forms,
     "Write the tetrahedra and the values at their points. F.vtk and\n"
     "F.vtu are for ParaView and include circumradii and volumes;\n"
     "F.msh is Gmsh's format 4.1; F.node (points), F.ele\n"
     "(tetrahedra) and F.neigh (their neighbours) are TetGen's.\n"
     "-vtk F, -node F, -ele F and -neigh F do the same."},
    {"-face", "F", take_output, face_forms,
     "Write the triangles of the hull, or with -alpha those of the\n"
     "shape's boundary, counter-clockwise as seen from outside:\n"
     "F.obj, F.off, F.ply (with values), F.stl (as text), F.vtk,\n"
     "F.vtu, or TetGen's F.face, which goes with F.node."},
    {"-iso", "LEVEL[,LEVEL...] F", take_levels, iso_forms,
     "Write the surface on which the first value, interpolated\n"
     "linearly in each tetrahedron, is LEVEL: F.stl, F.ply (with the\n"
     "level), F.obj or F.vtk. Triangles are counter-clockwise as\n"
     "seen from the side of lower values. The area is reported, and\n"
     "the volume if the surface is closed. -cols X,Y,Z,V chooses the\n"
     "value if there are several."},
    {"-iso-closed", 0, take_switch, &chosen.closed,
     "Close that surface along the hull, so that it encloses\n"
     "everything above the level, as a grade shell does."},
    {"-vtk", "F", take_output, vtk_forms, 0},
    {"-node", "F", take_output, node_forms, 0},
    {"-ele", "F", take_output, ele_forms, 0},
    {"-neigh", "F", take_output, neigh_forms, 0},
    {"-binary", 0, take_switch, &chosen.binary, 0},
    {"-cells", "F", take_output, cells_forms,
     "Write the Voronoi cells, cut off at a box, as VTK polyhedra."},
    {"-volumes", "F.csv", take_output, volumes_forms,
     "Write a line for each point: x,y,z, the volume of its cell,\n"
     "the number of faces, the number of the point, the cell's area,\n"
     "its neighbours (the sides x0 to z1 of the box are -1 to -6; a\n"
     "periodic box has none), the values, the cell's centroid, and,\n"
     "if the file has a column of words, such as the species of an\n"
     "atom, the word. The sum of the volumes is reported; of a\n"
     "surface (STL, OFF, PLY, OBJ), whether it is closed, and its\n"
     "volume."},
    {"-faces", "F.csv", take_output, faces_forms,
     "Write each face between two cells once: the point, its\n"
     "neighbour (or side, as above), the area, the centroid, the\n"
     "unit normal away from the point, and what is added to the\n"
     "neighbour's position in a periodic box, in box lengths."},
    {"-box", "X0,X1,Y0,Y1,Z0,Z1", take_box, chosen.box,
     "The box that cuts the cells off. If it is not given, it is\n"
     "that of an extended XYZ file's Lattice or of a LAMMPS dump, or\n"
     "else the points' own."},
    {"-periodic", 0, take_switch, &chosen.periodic,
     "The box is periodic; so are the mesh, values and cells. A cell\n"
     "of any shape is taken from a file's Lattice or CRYST1, along\n"
     "those of its vectors that pbc names."},
    {"-svg", "F", take_output, svg_forms,
     "Write a picture of the mesh: cut open, or with its tetrahedra\n"
     "moved apart if they are few."},
    {"-draw", "points|whole|cut|field|apart", take_draw, &chosen.draw,
     "What the picture shows: the points; all tetrahedra; the mesh\n"
     "cut open; the same without its edges; or tetrahedra moved\n"
     "apart."},
    {"-alpha", "R|auto", take_alpha, &chosen.alpha,
     "Write and draw the alpha shape only: the tetrahedra whose\n"
     "circumradius does not exceed R, decided exactly. It has the\n"
     "holes and hollows that the hull fills. auto chooses, and\n"
     "reports, the least R for which the tetrahedra form one piece,\n"
     "joined by facets, that has all points."},
    {"-view", "A E", take_view, chosen.view,
     "Draw as seen from azimuth A, turned from x to y, and elevation\n"
     "E above that plane, both in degrees. The default is -68 28."},
    {"-title", "TEXT", take_title, &chosen.title,
     "Write this above pictures, those of -values included."},
    {"-unit", "V[,X[,Y,Z]]", take_title, &chosen.unit,
     "The units of the first value and of x, y and z, for pictures:\n"
     "-unit C,m."},
    {"-size", "W,H", take_pixels, chosen.pixels,
     "The size of pictures in pixels."},
    {"-range", "LOW,HIGH", take_range, chosen.range,
     "The values at which the colours of pictures begin and end, so\n"
     "that several pictures share them. What lies beyond has the\n"
     "colour of the end."},
    {"-bare", 0, take_switch, &chosen.bare,
     "Draw pictures without axes, colour bar and text."},
    {"-o", "BASE", take_base, 0,
     "Write BASE.node, BASE.ele, BASE.neigh and BASE.vtk."},
    {0, 0, 0, 0, ""},
    {0, 0, 0, 0, "Values at other places:"},
    {"-grid", "X,Y[,Z]", take_word, &chosen.grid,
     "Interpolate on a grid. Each axis is one of: N, so many places\n"
     "across the points' bounding box, whose corners often lie\n"
     "outside the hull (see -outside); FROM:TO:N, so many from FROM\n"
     "to TO, or with N = 1 the middle (a slice is Z:Z:1);\n"
     "FROM:TO/SIDE, a block model: the centres of blocks of that\n"
     "side, the first of which begins at FROM, as many as TO - FROM\n"
     "divided by SIDE, rounded. Two axes are for points in a plane.\n"
     "The older NX,NY[,NZ],X0,X1,Y0,Y1[,Z0,Z1] means X0:X1:NX and so\n"
     "on."},
    {"-step", "SX,SY[,SZ]", take_step, chosen.step,
     "The older form of a block model, with\n"
     "-grid X0,X1,Y0,Y1[,Z0,Z1]: X0:X1/SX and so on."},
    {"-within", "D", take_length, &chosen.within,
     "A place farther than D from every point gets no value, but\n"
     "NaN. D is measured in coordinates stretched by -scale."},
    {"-drop", 0, take_switch, &chosen.drop,
     "Leave places without a value out of F.csv."},
    {"-query", "F", take_word, &chosen.query,
     "Interpolate at the places in a file, which is read as the\n"
     "points are. Its other columns are copied unchanged into F.csv,\n"
     "before the values."},
    {"-qcols", "X,Y,Z", take_columns, &chosen.qcols,
     "The columns of that file that hold x, y and z."},
    {"-values", "F", take_output, values_forms,
     "Write the interpolated values: F.csv has a line for each\n"
     "place, in a grid with x running fastest; F.npy is for\n"
     "numpy.load, of shape (NZ,NY,NX,columns) for a grid,\n"
     "(NY,NX,columns) in a plane, (places,columns) for a file;\n"
     "F.vtu, or for a grid F.vtk, is for ParaView; F.svg is a\n"
     "picture of a slice, of its first column."},
    {"-method", "M", take_word, &chosen.method,
     "linear in each tetrahedron, the default; smooth, by gradients\n"
     "estimated at the points: the most accurate for smooth fields,\n"
     "but may leave the range of the data; natural, by Sibson's\n"
     "natural neighbours; nearest, the value of the nearest point,\n"
     "which may be a word, such as the name of a rock. Duplicates\n"
     "count as one point with the mean of their values, or with the\n"
     "word of the first."},
    {"-outside", "nearest|VALUE", take_word, &chosen.outside,
     "What places get that lie outside the hull by more than their\n"
     "rounding: this value, or with `nearest' the value at the\n"
     "nearest point of the hull. The default is NaN, with\n"
     "-method nearest, too."},
    {"-clip", 0, take_switch, &chosen.clip,
     "Keep each column's values within the range of the data."},
    {"-digits", "N", take_digits, &chosen.digits,
     "Digits of the values in F.csv. The default is the fewest that\n"
     "read back as the same number."},
    {"-validate", "[K]", take_folds, &chosen.validate,
     "Cross-validate in K folds (default 10), drawn at random but\n"
     "the same everywhere. Reports how well each -method M,M,...\n"
     "predicts the values of each fold from the others, which one is\n"
     "best, and how many predictions lie beyond the range of the\n"
     "data; of words, with -method nearest, how often each one is\n"
     "taken for which."},
    {"-by", "COLUMN", take_word, &chosen.by,
     "Keep in one fold all rows that have the same number or word in\n"
     "this column: boreholes, lines, flights. Otherwise neighbours\n"
     "within one predict each other, and the errors look smaller\n"
     "than they are."},
    {"-errors", "F.csv", take_output, errors_forms,
     "Write the place, the fold, the file's other columns, the values,\n"
     "and the errors of -validate."},
    {0, 0, 0, 0, ""},
    {"-q", 0, take_switch, &chosen.quiet,
     "Print no summary and no progress. Errors are still reported,\n"
     "and so is whatever in the data was doubted, dropped or left\n"
     "out."},
    {"-version", 0, take_version, 0,
     "Print the version of the library."},
    {"-h", 0, take_help, 0,
     "Print this text, as -help and --help do."}};

#define OPTIONS (sizeof table / sizeof table[0])

/* show - an option's lines of -h. */
static void show(const option *o)
{
    const char *c;
    int at = 0;

    if (o->name)
        at = printf("  %s", o->name);
    if (o->name && o->argument) at += printf(" %s", o->argument);
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
