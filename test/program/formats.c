/* formats.c - which format a file is of: by what it begins with; what is known,
 * but not read; lines of numbers, and counts before them.
 */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

/* format - first match wins. */
typedef struct format {
    const char *name, *magic; /* the first bytes, or first text; 0: is tells */
    int bytes;                /* of magic: so many, from the file's first on;
                               * else it is a text, in letters of any case: */
    const char *endings;      /* of names that let expect it, or 0 */
    int (*is)(reader *r);     /* 0: magic tells */
    void (*read)(reader *r);  /* 0: it is not read; then */
    const char *instead;      /* what to do */
} format;

static const dialect blanks = {' ', '.', 0, 0};

int begins(const reader *r, const char *text)
{
    const char *s = r->s.at;

    while (isspace((unsigned char)*s)) s++;
    while (*text && tolower((unsigned char)*s) == tolower((unsigned char)*text))
    {
        s++;
        text++;
    }
    return !*text;
}

const cell *first_word(reader *r)
{
    r->cell[0].text = r->s.line + strspn(r->s.line, " \t");
    r->cell[0].end = r->cell[0].text + strcspn(r->cell[0].text, " \t");
    return r->cell;
}

int first_cells(reader *r)
{
    int n = 0, more;

    scan_again(&r->s);
    while (scan_line(&r->s)) {
        r->s.line += strspn(r->s.line, " \t");
        if (!*r->s.line || *r->s.line == '#') continue;
        n = cut(&r->s, &blanks, r->cell, &more);
        break;
    }
    return n;
}

void need_line(reader *r)
{
    if (!scan_line(&r->s)) fail("%s: ends before the first point", r->s.name);
}

int need_cells(reader *r)
{
    int more;

    for (need_line(r); comment(&r->s); need_line(r)) r->s.blank++;
    return cut(&r->s, &blanks, r->cell, &more);
}

/* ---- those that are not read ---- */

/* alone - is the first line nothing but this text? */
static int alone(reader *r, const char *text)
{
    return first_cells(r) == 1 && cell_is(r->cell, text);
}

static int is_cif(reader *r)
{
    return first_cells(r) == 1 &&
           r->cell[0].end - r->cell[0].text >= 5 && !r->cell[0].quoted &&
           !strpbrk(r->cell[0].text, ",;|") &&
           strncmp(r->cell[0].text, "data_", 5) == 0;
}

/* within - does a line of the sample begin with this text? */
static int within(reader *r, const char *text)
{
    scan *s = &r->s;

    scan_again(s);
    while (in_sample(s) && scan_line(s))
        if (strncmp(s->line + strspn(s->line, " \t"), text, strlen(text)) == 0)
            return 1;
    return 0;
}

static int is_mmcif(reader *r)
{
    return is_cif(r) && within(r, "_atom_site.");
}

static int is_esri(reader *r)
{
    double n;

    return first_cells(r) == 2 && cell_is(r->cell, "ncols") &&
           whole(r->cell[1].text, r->cell[1].end, &n);
}

static int is_dxf(reader *r)
{
    return alone(r, "0") && within(r, "SECTION");
}

static int is_tecplot(reader *r)
{
    int n = first_cells(r);

    return n > 1 && (cell_is(r->cell, "variables") || cell_is(r->cell, "title"))
           && *r->cell[1].text == '=' ? 1
           : (n > 0 && strncmp(r->cell[0].text, "VARIABLES=", 10) == 0);
}

/* small_cells - the sample's line so many lines from its first one: its cells;
 * numbers: how many of them are such. */
static int small_cells(reader *r, int line, int *many)
{
    int n = 0, more, k;

    scan_again(&r->s);
    for (k = 0; k < line; k++)
        if (!scan_line(&r->s)) return 0;
    for (*many = 0; *r->s.line == ' ' || *r->s.line == '\t';) r->s.line++;
    if (*r->s.line) n = cut(&r->s, &blanks, r->cell, &more);
    for (k = 0; k < n; k++) *many += r->cell[k].kind == NUMBER;
    return n;
}

static int is_ptx(reader *r)
{
    int n, k, line;

    for (line = 1; line <= 6; line++) {
        k = small_cells(r, line, &n);
        if (k != n || n != (line < 3 ? 1 : 3)) return 0;
    }
    return small_cells(r, 7, &n) == 4 && n == 4;
}

static int is_poscar(reader *r)
{
    int n, line;

    for (line = 2; line <= 5; line++)
        if (small_cells(r, line, &n) < (line == 2 ? 1 : 3) ||
            n != (line == 2 ? 1 : 3))
            return 0;
    for (line = 6; line <= 8; line++)
        if (small_cells(r, line, &n) > 0 && n == 0 &&
            strchr("DdCcKkSs", *r->cell[0].text) && line > 6)
            return 1;
    return 0;
}

static int is_gro(reader *r)
{
    const char *s;
    double n;
    int k;

    if (small_cells(r, 2, &k) != 1 || !whole(r->cell[0].text, r->cell[0].end,
                                             &n))
        return 0;
    scan_again(&r->s);
    for (k = 0; k < 3; k++)
        if (!scan_line(&r->s)) return 0;
    s = r->s.line;
    return strlen(s) >= 44 && isdigit((unsigned char)s[19]) && s[24] == '.' &&
           s[32] == '.' && s[40] == '.';
}

static int is_lammps(reader *r)
{
    int line, n;

    for (line = 2; line <= 4; line++)
        if (small_cells(r, line, &n) == 2 && n == 1 &&
            cell_is(r->cell + 1, "atoms"))
            return 1;
    return 0;
}

static int is_sdf(reader *r)
{
    int n;

    small_cells(r, 4, &n);
    return r->s.stop &&
           (strstr(r->s.line, "V2000") || strstr(r->s.line, "V3000"));
}

static int is_iges(reader *r)
{
    scan_again(&r->s);
    return scan_line(&r->s) && r->s.stop - r->s.line == 80 &&
           r->s.line[72] == 'S';
}

static int is_pickle(reader *r)
{
    return *r->s.at == '\200' && r->s.at[1] >= 2 && r->s.at[1] <= 5;
}

/* entry - is there this text in the name of a zip archive's first entry? */
static int entry(reader *r, const char *text)
{
    const char *s = r->s.at;
    char name[64];
    int k;

    if (memcmp(s, "PK\003\004", 4) != 0 || r->s.end - s < 100) return 0;
    for (k = 0; k < 63; k++) name[k] = (char)(s[30 + k] ? s[30 + k] : ' ');
    name[k] = '\0';
    return strstr(name, text) != 0;
}

static int is_sheet(reader *r)
{
    return entry(r, "[Content_Types]") || entry(r, "xl/") ||
           entry(r, "opendocument");
}

static int is_laz(reader *r)
{
    return memcmp(r->s.at, "LASF", 4) == 0 && r->s.end - r->s.at > 104 &&
           (r->s.at[104] & '\300') != 0;
}

int is_unknown(reader *r)
{
    const scan *s = &r->s;
    size_t n = (size_t)(s->end - s->at);

    return memchr(s->at, 0, n < 512 ? n : 512) != 0;
}

/* ---- lines of numbers, counts before them ---- */

static int is_lines(reader *r)
{
    (void)r;
    return 1;
}

static void read_lines(reader *r)
{
    take_lines(r, 0);
}

/* count - the number that cell k is, perhaps with separators behind; -1 if it
 * is none. */
static double count(const reader *r, int k)
{
    const char *s = r->cell[k].text, *end = r->cell[k].end;
    double n;

    while (end > s && strchr(",;|", end[-1])) end--;
    return whole(s, end, &n) ? n : -1.0;
}

/* is_counted - is the first line a count, or a dimension and a number? */
static int is_counted(reader *r)
{
    int n, more;

    scan_again(&r->s);
    n = next_cells(&r->s, &blanks, r->cell, &more);
    if (n == 0 || count(r, 0) < 0.0) return 0;
    if (n == 2 && count(r, 1) >= 0.0)
        return r->to->axes != 2 &&
               (count(r, 0) == 3.0 || count(r, 1) == 3.0);
    return n == 1 || cell_is(r->cell + 1, "rbox") ||
           !strpbrk(r->cell[1].text, "0123456789,;|\t");
}

/* form_of - of the next line's cells: one character each, in kinds.  Returns
 * how many are numbers; kinds is "" at the end. */
static int form_of(reader *r, char *kinds, double *number)
{
    int n, k, more, found = 0;

    kinds[0] = '\0';
    *number = -1.0;
    if (!scan_line(&r->s) || comment(&r->s)) return 0;
    n = cut(&r->s, &r->d, r->cell, &more);
    for (k = 0; k < n; k++) {
        kinds[k] = r->cell[k].kind == WORD ? 'w' : 'n';
        found += kinds[k] == 'n';
    }
    kinds[n] = '\0';
    if (n == 1) *number = count(r, 0);
    return found;
}

/* read_counted - a count, then so many rows, perhaps a comment before them; or
 * Qhull's dimension, then a number. */
static void read_counted(reader *r)
{
    scan *s = &r->s;
    char second[COLUMNS + 3], third[COLUMNS + 3];
    double dimension = r->to->axes == 2 ? 2.0 : 3.0, other, none;
    int n, more, k, like, found, found3, row = 0;
    int named = ends_in(s->name, ".xyz");
    const char *mark;

    for (;; s->blank++) {
        scan_line(s);
        if (!comment(s)) break;
        if (*s->line) sprintf(r->remark, "%.399s", s->line);
    }
    n = cut(s, &blanks, r->cell, &more);
    s->head++;
    r->want = count(r, 0);
    if (n == 2 && count(r, 1) >= 0.0)
        r->want = r->want == dimension ? count(r, 1) : r->want;
    else {
        scan_pin(s);
        if (!scan_line(s)) fail("%s: ends before the first point", s->name);
        if (extended(r)) {
            s->pinned = 0;
            s->head++;
            goto rows;
        }
        /* blanks, or what the two lines have, separate */
        mark = strpbrk(s->line, ";|,\t");
        r->d.separator = ' ';
        r->d.decimal = (char)(r->to->decimal ? r->to->decimal : '.');
        for (k = 0; k < 2; k++) {
            scan_again(s);
            found = form_of(r, second, &other);
            found3 = form_of(r, third, &none);
            if (k > 0 || found + found3 > 3 || !mark) break;
            r->d.separator = *mark;
        }
        like = found >= 2 && (!*third || strcmp(second, third) == 0);
        if (r->want == 1.0) like = found >= 2;
        scan_go(s);
        if (other >= 0.0 && third[0]) {
            scan_line(s);
            if (r->want == dimension && third[0] == 'n' && third[1] &&
                !strchr(third, 'w') && found3 >= 2) {
                r->want = other;
                s->head++;
            } else if (other == dimension)
                s->head++;
            else
                s->blank++;
        } else if (like && named) {
            scan_line(s);
            s->blank++;
            warn("%s:%ld: is a comment, as the name's .xyz says, though like a "
                 "point", s->name, s->number);
        } else if (!like && second[0] && strchr(second, 'n')) {
            scan_line(s);
            s->blank++;
        } else
            row = like;
    }
rows:
    scan_room(s, r->want, 4.0);
    if (r->columns > 0) take_all(r, 0);
    else take_lines(r, 1);
    scan_pin(s);
    n = next_cells(s, &r->d, r->cell, &more);
    other = n == 1 ? count(r, 0) : -1.0;
    if (row && n == r->columns && r->cell[r->use[0]].kind == NUMBER &&
        r->cell[r->use[1]].kind == NUMBER)
        scan_fail(s, "one more line of numbers than the %.0f points announced "
                  "(if the first one is a comment: name the file .xyz)",
                  r->want);
    scan_go(s);
    if (n > 0)
        scan_rest(s, other >= 0.0 ? "further frames"
                                  : "lines behind the points announced");
    while (scan_line(s)) s->blank++;
}

/* ---- the formats ---- */

/* a text with which the file begins; that is alone in its first line; with
 * which a line of the sample begins; in a zip archive's first entry's name */
enum { BEGINS, ALONE = -1, WITHIN = -2, ENTRY = -3 };

#define PACKAGE(name, bytes, n, command) {name, bytes, n, 0, 0, 0, command}
#define TEXT_OF(name, how, text, command) {name, text, how, 0, 0, 0, command}
#define TOLD(name, is, command) {name, 0, 0, 0, is, 0, command}

static const char vtk_points[] =
    "numpy.savetxt('G.txt', meshio.read('F').points), or in ParaView Save "
    "Data as CSV";
static const char grid[] = "gdal_translate -of XYZ F G.xyz";
static const char frames[] =
    "in Python pandas.read_...('F').to_csv('G.csv', index=False)";
static const char surfaces[] = "assimp export F G.ply";
static const char failed[] = "a download that failed: fetch it again";

static const format formats[] = {
    PACKAGE("compressed by gzip", "\037\213", 2, "gunzip -c F | tess ..."),
    PACKAGE("compressed by bzip2", "BZh", 3, "bunzip2 -c F | tess ..."),
    PACKAGE("compressed by xz", "\3757zXZ", 5, "xz -dc F | tess ..."),
    PACKAGE("compressed by zstd", "(\265/\375", 4, "zstd -dc F | tess ..."),
    PACKAGE("compressed by lz4", "\004\"M\030", 4, "lz4 -dc F | tess ..."),
    PACKAGE("compressed by compress", "\037\235", 2, "zcat F | tess ..."),
    TOLD("a spreadsheet", is_sheet, "save the sheet as CSV"),
    TEXT_OF("NumPy's .npz", ENTRY, ".npy",
         "numpy.save('G.npy', numpy.load('F')['points'])"),
    PACKAGE("a zip archive", "PK\003\004", 4, "unzip -p F | tess ..."),
    PACKAGE("a spreadsheet", "\320\317\021\340", 4, "save the sheet as CSV"),
    TOLD("LAZ", is_laz, "laszip -i F -o G.las"),
    PACKAGE("E57", "ASTM-E57", 8,
            "CloudCompare -SILENT -O F -C_EXPORT_FMT PLY -SAVE_CLOUDS"),
    PACKAGE("HDF5, MATLAB 7.3 or netCDF 4", "\211HDF", 4,
            "numpy.save('G.npy', h5py.File('F')['points'])"),
    PACKAGE("MATLAB's", "MATLAB 5.0", 10,
            "in MATLAB writematrix(p, 'p.csv')"),
    PACKAGE("netCDF", "CDF", 3, "xarray.open_dataset('F').to_dataframe()"
                                ".to_csv('G.csv')"),
    PACKAGE("TIFF", "II*", 3, grid), PACKAGE("TIFF", "II+", 3, grid),
    PACKAGE("TIFF", "MM\0*", 4, grid),
    TOLD("an ESRI grid", is_esri, grid),
    TEXT_OF("Surfer's grid", ALONE, "DSAA", grid),
    PACKAGE("Surfer's grid", "DSBB", 4, grid),
    PACKAGE("Surfer's grid", "DSRB", 4, grid),
    PACKAGE("a shapefile", "\0\0\047\012", 4,
            "ogr2ogr -f CSV G.csv F -lco GEOMETRY=AS_XYZ"),
    PACKAGE("a GeoPackage or SQLite's", "SQLite format 3", 15,
            "ogr2ogr -f CSV G.csv F -lco GEOMETRY=AS_XYZ"),
    PACKAGE("parquet", "PAR1", 4, frames),
    PACKAGE("Arrow's", "ARROW1", 6, frames),
    TOLD("Python's pickle", is_pickle,
         "numpy.save('G.npy', numpy.load('F', allow_pickle=True))"),
    PACKAGE("glTF", "glTF", 4, surfaces),
    PACKAGE("FBX", "Kaydara", 7, surfaces),
    TEXT_OF("VTK's", BEGINS, "# vtk", vtk_points),
    TEXT_OF("VTK's", BEGINS, "<VTKFile", vtk_points),
    TEXT_OF("XML, perhaps VTK's", BEGINS, "<?xml", vtk_points),
    TEXT_OF("Gmsh's", BEGINS, "$MeshFormat", vtk_points),
    TEXT_OF("Gmsh's", BEGINS, "$NOD", vtk_points),
    TEXT_OF("Abaqus's", BEGINS, "*NODE", vtk_points),
    TEXT_OF("Abaqus's", BEGINS, "*HEADING", vtk_points),
    TEXT_OF("STEP", BEGINS, "ISO-10303-21", "gmsh -2 F -o G.stl"),
    TEXT_OF("a web page", BEGINS, "<!DOCTYPE", failed),
    TEXT_OF("a web page", BEGINS, "<html", failed),
    TEXT_OF("a pointer of Git LFS", BEGINS, "version https://git-lfs",
            "git lfs pull"),
    TEXT_OF("PDF", BEGINS, "%PDF", "copy its table into a text file"),
    TEXT_OF("PostScript", BEGINS, "%!PS", "copy its table into a text file"),
    TEXT_OF("MOL2", BEGINS, "@<TRIPOS>", "obabel F -O G.xyz"),
    {"NumPy's .npy", "\223NUMPY", 6, ".npy", 0, read_npy, 0},
    {"LAS", "LASF", 4, ".las", 0, read_las, 0},
    {"PCD", 0, 0, ".pcd", is_pcd, read_pcd, 0},
    {"PLY", 0, 0, ".ply", is_ply, read_ply, 0},
    {"binary STL", 0, 0, ".stl", is_packed_stl, read_packed_stl, 0},
    TOLD("no text, nor a binary format that is known", is_unknown,
         "lines of numbers, CSV, .xyz, .node, .off, .ply, .obj, .stl, .npy, "
         ".pcd, .las, PDB and LAMMPS dumps are"),
    {"a LAMMPS dump", "ITEM: TIMESTEP", 0, 0, 0, read_dump, 0},
    {"STL", 0, 0, ".stl", is_stl, read_stl, 0},
    TEXT_OF("JSON or the like", BEGINS, "{", "jq or Python writes CSV"),
    TEXT_OF("JSON or the like", BEGINS, "[", "jq or Python writes CSV"),
    TOLD("mmCIF", is_mmcif, "gemmi convert F G.pdb"),
    TOLD("CIF", is_cif, "ase convert F G.xyz"),
    TOLD("DXF", is_dxf, surfaces),
    TOLD("IGES", is_iges, "gmsh -2 F -o G.stl"),
    TEXT_OF("Nastran's", WITHIN, "BEGIN BULK", vtk_points),
    TOLD("Tecplot's", is_tecplot, "leave the zone's lines alone"),
    TEXT_OF("OpenFOAM's", WITHIN, "FoamFile",
            "foamToVTK, then ParaView: Save Data as CSV"),
    TOLD("SDF", is_sdf, "obabel F -O G.xyz"),
    {"PDB", 0, 0, ".pdb.ent", is_pdb, read_pdb, 0},
    TOLD("LAMMPS's data", is_lammps,
         "in LAMMPS write_dump all custom G.dump id type x y z"),
    TOLD("GRO", is_gro, "gmx editconf -f F -o G.pdb"),
    TOLD("POSCAR", is_poscar, "ase convert -i vasp F G.xyz"),
    TOLD("PTX", is_ptx,
         "CloudCompare -SILENT -O F -C_EXPORT_FMT PLY -SAVE_CLOUDS"),
    {"OFF", 0, 0, ".off", is_off, read_off, 0},
    {"OBJ", 0, 0, ".obj", is_obj, read_obj, 0},
    {"TetGen's .node", 0, 0, ".node", is_node, read_node, 0},
    {"a count and lines", 0, 0, 0, is_counted, read_counted, 0},
    {"lines of numbers", 0, 0, 0, is_lines, read_lines, 0}};

#define FORMATS (sizeof formats / sizeof formats[0])

/* matches - is the file of that format? */
static int matches(reader *r, const format *f)
{
    scan *s = &r->s;

    scan_again(s);
    if (f->bytes > 0)
        return s->end - s->at >= f->bytes &&
               memcmp(s->at, f->magic, (size_t)f->bytes) == 0;
    return !f->magic            ? f->is(r)
           : f->bytes == BEGINS ? begins(r, f->magic)
           : f->bytes == ALONE  ? alone(r, f->magic)
           : f->bytes == WITHIN ? within(r, f->magic)
                                : entry(r, f->magic);
}

/* named - does the file's name end as that format's do? */
static int named(const char *name, const format *f)
{
    char ending[8];
    const char *s = f->endings;
    size_t length;

    for (; s && *s; s += length) {
        length = 1 + strcspn(s + 1, ".");
        memcpy(ending, s, length);
        ending[length] = '\0';
        if (ends_in(name, ending)) return 1;
    }
    return 0;
}

void read_points(const char *name, points *a)
{
    reader *r = (reader *)space(1.0, sizeof *r);
    const format *f = formats, *g;

    memset(r, 0, sizeof *r);
    r->to = a;
    r->want = -1.0;
    r->by = r->keeps = -1;
    r->d.separator = ' ';
    r->d.decimal = '.';
    scan_open(&r->s, name);
    a->input = r->s.name;
    scan_pin(&r->s);
    while (!matches(r, f)) f++;
    scan_go(&r->s);
    if (!f->read) fail("%s: is %s, which is not read: %s", a->input, f->name,
                       f->instead);
    for (g = formats; g < formats + FORMATS; g++)
        if (named(a->input, g) && g->read != f->read &&
            !(f->endings && named(a->input, f)))
            fail("%s: is named as %s, but begins as %s: give it another name, "
                 "or mend it", a->input, g->name, f->name);
    f->read(r);
    end_rows(r);
    scan_end(&r->s);
    free(r);
    progress("reading", 1.0, 1.0);
}
