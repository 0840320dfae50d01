/* formats.c - which format a file is of: by what it begins with; what is known,
 * but not read; lines of numbers, and counts before them.
 */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

/* format - first match wins. */
typedef struct format {
    const char *name, *pattern; /* 0: is tells */
    int from;             /* where that is looked for: the first bytes, if it is
                           * so many of them, without signs; or by these: */
    const char *ending;   /* of names that let expect it, or 0 */
    int (*is)(reader *r);
    void (*read)(reader *r); /* 0: it is not read; then */
    const char *instead;     /* what to do */
} format;

/* WORDS: at the first text; LINE: at the first line that is neither blank nor
 * begins with #; FILE: at the beginning. */
enum { WORDS, LINE = -1, START = -2 };

int first_cells(reader *r)
{
    scan *s = &r->s;

    while (scan_line(s)) {
        s->line += strspn(s->line, " \t");
        if (*s->line && *s->line != '#') return cut(r);
    }
    return 0;
}

void need_line(reader *r)
{
    if (!scan_line(&r->s)) fail("%s: ends before the first point", r->s.name);
}

int need_cells(reader *r)
{
    for (need_line(r); comment(&r->s); need_line(r)) r->s.blank++;
    r->s.head++;
    return cut(r);
}

/* like - is the text as the pattern says?  Letters are of any case; ' ' is
 * blanks, or none; '\n' ends a line; '#' is a number, '@' what has no blanks or
 * separators, '~' any character of the line, '*' any more of it, '%' any of the
 * sample; [abc] is one of these, '\\' makes the next character plain. */
static int like(const char *s, const char *end, const char *pattern)
{
    const char *p, *from;
    int ends;

    for (p = pattern; *p; p++) {
        from = s;
        switch (*p) {
        case '*':
        case '%':
            for (; s < end; s++) {
                ends = *s == '\n' || *s == '\r';
                if (ends && *p == '*') break;
                if ((ends || p[1] != '\n') && like(s, end, p + 1)) return 1;
            }
            break;
        case ' ':
        case '\n':
            while (s < end && (*s == ' ' || *s == '\t')) s++;
            if (*p == ' ') break;
            if (s < end && *s != '\n' && *s != '\r') return 0;
            s += s + 1 < end && *s == '\r' && s[1] == '\n' ? 2 : s < end;
            break;
        case '#':
            s = number((char *)s, '.', 0);
            if (s == from) return 0;
            break;
        case '@':
            while (s < end && !isspace((unsigned char)*s) &&
                   !strchr(",;|\"", *s))
                s++;
            break;
        case '[':
            pattern = ++p;
            while (*p != ']') p++;
            if (s == end || !memchr(pattern, tolower((unsigned char)*s),
                                    (size_t)(p - pattern)))
                return 0;
            s++;
            break;
        case '~':
            if (s == end || *s == '\n' || *s == '\r') return 0;
            s++;
            break;
        default:
            p += *p == '\\';
            if (s == end ||
                tolower((unsigned char)*s) != tolower((unsigned char)*p))
                return 0;
            s++;
        }
    }
    return 1;
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
    int n = next_cells(r);

    if (n == 0 || count(r, 0) < 0.0) return 0;
    if (n == 2 && count(r, 1) >= 0.0)
        return r->to->axes != 2 &&
               (count(r, 0) == 3.0 || count(r, 1) == 3.0);
    return n == 1 || cell_is(r->cell + 1, "rbox") ||
           !strpbrk(r->cell[1].text, "0123456789,;|\t");
}

/* form_of - of the next line's cells: one character each, in kinds.  Returns
 * how many are numbers; kinds is "" at the end. */
static int form_of(reader *r, char *kinds)
{
    int k, found = 0;

    kinds[0] = '\0';
    if (!scan_line(&r->s) || comment(&r->s)) return 0;
    cut(r);
    for (k = 0; k < r->cells; k++) {
        kinds[k] = r->cell[k].kind == WORD ? 'w' : 'n';
        found += kinds[k] == 'n';
    }
    kinds[k] = '\0';
    return found;
}

/* second_line - behind a count: what it is, by its kind and the next line's.  A
 * row: 1; else a comment, which the name's ending may say, or Qhull's number of
 * points, behind their dimension. */
static int second_line(reader *r, double dimension)
{
    scan *s = &r->s;
    char second[COLUMNS + 3], third[COLUMNS + 3];
    const char *mark = strpbrk(s->line, ";|,\t");
    int k, like, found, row;
    double other;

    /* blanks, or what the two lines have, separate */
    r->d.decimal = (char)(r->to->decimal ? r->to->decimal : '.');
    for (k = 0; k < 2; k++) {
        scan_again(s);
        found = form_of(r, second);
        other = strlen(second) == 1 ? count(r, 0) : -1.0;
        if (form_of(r, third) + found > 3 || !mark) break;
        r->d.separator = *mark;
    }
    scan_go(s);
    like = found >= 2 && (r->want == 1.0 || !*third ||
                          strcmp(second, third) == 0);
    row = like && !ends_in(s->name, ".xyz");
    if (other >= 0.0 && *third) {
        scan_line(s);
        s->head++;
        if (r->want == dimension && third[1] && !strchr(third, 'w'))
            r->want = other;
    } else if (!row && (like || strchr(second, 'n'))) {
        scan_line(s);
        s->blank++;
        if (like)
            warn("%s:%ld: is a comment, as the name's .xyz says, though "
                 "like a point", s->name, s->number);
    }
    return row;
}

/* remark - keep the line: it may name columns. */
static void remark(reader *r)
{
    sprintf(r->remark, "%.399s", r->s.line);
    r->remarked = r->s.number;
}

/* read_counted - a count, then so many rows, perhaps a comment before them; or
 * Qhull's dimension, then a number. */
static void read_counted(reader *r)
{
    scan *s = &r->s;
    double dimension = r->to->axes == 2 ? 2.0 : 3.0;
    int n, row = 0;
    const char *behind = "lines behind the points announced";

    for (; scan_line(s) && comment(s); s->blank++)
        if (*s->line) remark(r);
    n = cut(r);
    s->head++;
    r->want = count(r, 0);
    if (n == 2 && count(r, 1) >= 0.0) {
        if (r->want == dimension) r->want = count(r, 1);
    } else {
        scan_pin(s);
        need_line(r);
        if (extended(r)) {
            s->pinned = 0;
            s->head++;
        } else
            row = second_line(r, dimension);
    }
    scan_room(s, r->want, 4.0);
    if (r->columns > 0) take_all(r, 0);
    else take_lines(r);
    scan_pin(s);
    n = next_cells(r);
    if (n == 1 && count(r, 0) >= 0.0) behind = "further frames";
    if (row && n == r->columns && r->cell[r->use[0]].kind == NUMBER &&
        r->cell[r->use[1]].kind == NUMBER)
        scan_fail(s, "one more line of numbers than the %.0f points announced "
                  "(if the first one is a comment: name the file .xyz)",
                  r->want);
    scan_go(s);
    scan_rest(s, behind);
}

/* is_titled_count - a title, then a count in a line of its own, as if the two
 * were turned round, and lines of two numbers at least, perhaps behind one of
 * words. */
static int is_titled_count(reader *r)
{
    int k, line, found = 0;

    if (next_cells(r) == 0) return 0;
    for (k = 0; k < r->cells; k++) found += r->cell[k].kind != WORD;
    if (found == r->cells || next_cells(r) == 0 || count(r, 0) < 0.0) return 0;
    if (r->cells > 1 && strpbrk(r->cell[1].text, "0123456789,;|\t")) return 0;
    for (line = found = 0; line < 2 && found == 0 && next_cells(r) > 0; line++)
        for (k = 0; k < r->cells; k++) found += r->cell[k].kind == NUMBER;
    return found > 1;
}

static void read_titled(reader *r)
{
    scan *s = &r->s;

    need_cells(r);
    remark(r);
    need_cells(r);
    r->want = count(r, 0);
    scan_room(s, r->want, 4.0);
    take_lines(r);
    scan_rest(s, "lines behind the points announced");
}

/* ---- the formats ---- */

#define EIGHT "~~~~~~~~"
#define CRYSTAL "*\n #\n # # #\n # # #\n # # #\n"
#define NOT_READ(name, from, pattern, command) \
    {name, pattern, from, 0, 0, 0, command}
#define TOLD(name, is, command) {name, 0, 0, 0, is, 0, command}

static const char vtk_points[] =
    "numpy.savetxt('G.txt', meshio.read('F').points), or in ParaView Save "
    "Data as CSV";
static const char grid[] = "gdal_translate -of XYZ F G.xyz";
static const char layer[] = "ogr2ogr -f CSV G.csv F -lco GEOMETRY=AS_XYZ";
static const char frames[] =
    "in Python pandas.read_...('F').to_csv('G.csv', index=False)";
static const char sheet[] = "save the sheet as CSV";
static const char cloud[] =
    "CloudCompare -SILENT -O F -C_EXPORT_FMT PLY -SAVE_CLOUDS";
static const char surfaces[] = "assimp export F G.ply";
static const char solids[] = "gmsh -2 F -o G.stl";
static const char failed[] = "a download that failed: fetch it again";
static const char writes[] = "jq or Python writes CSV";
static const char copy[] = "copy its table into a text file";

static const format formats[] = {
    NOT_READ("compressed by gzip", 2, "\037\213", "gunzip -c F | tess ..."),
    NOT_READ("compressed by bzip2", START, "BZh[123456789]1AY&",
             "bunzip2 -c F | tess ..."),
    NOT_READ("compressed by xz", 5, "\3757zXZ", "xz -dc F | tess ..."),
    NOT_READ("compressed by zstd", 4, "(\265/\375", "zstd -dc F | tess ..."),
    NOT_READ("compressed by lz4", 4, "\004\"M\030", "lz4 -dc F | tess ..."),
    NOT_READ("compressed by compress", 2, "\037\235", "zcat F | tess ..."),
    NOT_READ("a spreadsheet", START, "PK\003\004%Content_Types]", sheet),
    NOT_READ("a spreadsheet", START, "PK\003\004%xl/", sheet),
    NOT_READ("a spreadsheet", START, "PK\003\004%opendocument", sheet),
    NOT_READ("NumPy's .npz", START, "PK\003\004%.npy",
             "numpy.save('G.npy', numpy.load('F')['points'])"),
    NOT_READ("a zip archive", 4, "PK\003\004", "unzip -p F | tess ..."),
    NOT_READ("a spreadsheet", 4, "\320\317\021\340", sheet),
    TOLD("LAZ", is_laz, "laszip -i F -o G.las"),
    NOT_READ("E57", 8, "ASTM-E57", cloud),
    NOT_READ("HDF5, MATLAB 7.3 or netCDF 4", 4, "\211HDF",
             "numpy.save('G.npy', h5py.File('F')['points'])"),
    NOT_READ("MATLAB's", 10, "MATLAB 5.0", "in MATLAB writematrix(p, 'p.csv')"),
    NOT_READ("netCDF", START, "CDF[\001\002\005]",
             "xarray.open_dataset('F').to_dataframe().to_csv('G.csv')"),
    NOT_READ("TIFF", 3, "II*", grid),
    NOT_READ("TIFF", 3, "II+", grid),
    NOT_READ("TIFF", 4, "MM\0*", grid),
    NOT_READ("an ESRI grid", LINE, "ncols #\n", grid),
    NOT_READ("Surfer's grid", LINE, "DSAA\n", grid),
    NOT_READ("Surfer's grid", 4, "DSBB", grid),
    NOT_READ("Surfer's grid", 4, "DSRB", grid),
    NOT_READ("a shapefile", 4, "\0\0\047\012", layer),
    NOT_READ("a GeoPackage or SQLite's", 15, "SQLite format 3", layer),
    NOT_READ("parquet", 4, "PAR1", frames),
    NOT_READ("Arrow's", 6, "ARROW1", frames),
    NOT_READ("Python's pickle", START, "\200[\002\003\004\005]",
             "numpy.save('G.npy', numpy.load('F', allow_pickle=True))"),
    NOT_READ("glTF", 4, "glTF", surfaces),
    NOT_READ("FBX", 7, "Kaydara", surfaces),
    NOT_READ("VTK's", WORDS, "\\# vtk DataFile", vtk_points),
    NOT_READ("VTK's", WORDS, "<VTKFile", vtk_points),
    NOT_READ("XML, perhaps VTK's", WORDS, "<?xml", vtk_points),
    NOT_READ("Gmsh's", WORDS, "$MeshFormat", vtk_points),
    NOT_READ("Gmsh's", WORDS, "$NOD", vtk_points),
    NOT_READ("Abaqus's", WORDS, "\\*NODE", vtk_points),
    NOT_READ("Abaqus's", WORDS, "\\*HEADING", vtk_points),
    NOT_READ("STEP", WORDS, "ISO-10303-21", solids),
    NOT_READ("a web page", WORDS, "<!DOCTYPE", failed),
    NOT_READ("a web page", WORDS, "<html", failed),
    NOT_READ("a pointer of Git LFS", WORDS, "version https://git-lfs",
             "git lfs pull"),
    NOT_READ("PDF", WORDS, "\\%PDF-", copy),
    NOT_READ("PostScript", WORDS, "\\%!PS", copy),
    NOT_READ("MOL2", WORDS, "\\@<TRIPOS>", "obabel F -O G.xyz"),
    {"NumPy's .npy", "\223NUMPY", 6, ".npy", 0, read_npy, 0},
    {"LAS", "LASF", 4, ".las", 0, read_las, 0},
    {"Petrel's points", 0, 0, 0, is_petrel, read_petrel, 0},
    {"PCD", "\\# .PCD", WORDS, ".pcd", 0, read_pcd, 0},
    {"PCD", "VERSION @%\n FIELDS ", LINE, ".pcd", 0, read_pcd, 0},
    {"PLY", "ply\n", START, ".ply", 0, read_ply, 0},
    {"STL", 0, 0, ".stl", is_packed_stl, read_packed_stl, 0},
    TOLD("no text, nor a binary format that is known", is_unknown,
         "tess -h says which are"),
    {"a LAMMPS dump", "ITEM: TIMESTEP", WORDS, 0, 0, read_dump, 0},
    {"STL", "solid%\n facet ", LINE, ".stl", 0, read_stl, 0},
    {"CFD-Post's", "\\[Name\\]\n", LINE, 0, 0, read_post, 0},
    {"Sea-Bird's .cnv", "\\* Sea-Bird", START, ".cnv", 0, read_cnv, 0},
    {"a well log", "\\~V", LINE, ".las", 0, read_well, 0},
    {"CCHDO's bottles", "BOTTLE,@\n", LINE, 0, 0, read_bottles, 0},
    {"GOCAD's", "GOCAD [vtp][sl][ueio]@ #", LINE, 0, 0, read_gocad, 0},
    NOT_READ("GOCAD's, of a grid or a well", LINE, "GOCAD @ #", "in SKUA or "
             "GOCAD export it as points, a VSet"),
    NOT_READ("one CTD cast of CCHDO's", START, "CTD,@\n", "write its "
             "LONGITUDE, LATITUDE and CTDPRS as columns of a CSV"),
    NOT_READ("IRAP's grid", START, "\\-996 # # #\n # # # #\n # # # #\n"
             " 0 0 0 0 0 0 0\n",
             "export it as points, x y z a line"),
    NOT_READ("Fluent's profile or plot", WORDS, "((",
             "File, Export, Solution Data as ASCII"),
    NOT_READ("Fluent's mesh", WORDS, "(0 \"",
             "File, Export, Solution Data as ASCII"),
    NOT_READ("JSON or the like", WORDS, "{", writes),
    NOT_READ("JSON or the like", WORDS, "\\[ [[{(\"'0123456789+-.]", writes),
    NOT_READ("JSON or the like", WORDS, "\\[\n", writes),
    NOT_READ("mmCIF", LINE, "data_@%\n _atom_site.", "gemmi convert F G.pdb"),
    NOT_READ("CIF", LINE, "data_@%\n _", "ase convert F G.xyz"),
    NOT_READ("DXF", LINE, "0\n%SECTION\n", surfaces),
    NOT_READ("IGES", START, EIGHT EIGHT EIGHT EIGHT EIGHT EIGHT EIGHT EIGHT
             EIGHT "S[ 0][ 0][ 0][ 0][ 0][ 0]1\n", solids),
    NOT_READ("Tecplot's", LINE, "variables =", "leave the zone's lines alone"),
    NOT_READ("Tecplot's", LINE, "title = \"", "leave the zone's lines alone"),
    NOT_READ("OpenFOAM's", START, "%\n FoamFile",
             "foamToVTK, then ParaView: Save Data as CSV"),
    NOT_READ("SDF", START, "*\n*\n*\n" EIGHT EIGHT EIGHT EIGHT "~[ ]"
             "V[23]000\n", "obabel F -O G.xyz"),
    {"PQR", 0, 0, ".pqr", is_pqr, read_pqr, 0},
    {"PDB", 0, 0, ".pdb", is_pdb, read_pdb, 0},
    {"PDB", 0, 0, ".ent", is_pdb, read_pdb, 0},
    NOT_READ("LAMMPS's data", START, "%\n # atoms\n%# atom types\n",
             "in LAMMPS write_dump all custom G.dump id type x y z"),
    NOT_READ("GRO", START, "*\n #\n" "~~~~[0123456789]" EIGHT "~~~~~~"
             "[0123456789]~~~~.~~~~~~~.~~~~~~~.~~~",
             "gmx editconf -f F -o G.pdb"),
    NOT_READ("POSCAR", START, CRYSTAL "*\n [dcks]",
             "ase convert -i vasp F G.xyz"),
    NOT_READ("POSCAR", START, CRYSTAL "*\n*\n [dcks]",
             "ase convert -i vasp F G.xyz"),
    NOT_READ("PTX", START, " #\n #\n # # #\n # # #\n # # #\n # # #\n"
             " # # # #\n", cloud),
    {"Amber's coordinates", 0, 0, 0, is_amber, read_amber, 0},
    {"GeoEAS", 0, 0, 0, is_geoeas, read_geoeas, 0},
    {"ODV's spreadsheet", 0, 0, 0, is_odv, read_odv, 0},
    {"Nastran's", 0, 0, 0, is_nastran, read_nastran, 0},
    {"OFF", 0, 0, ".off", is_off, read_off, 0},
    {"OBJ", 0, 0, ".obj", is_obj, read_obj, 0},
    {"TetGen's .node", 0, 0, ".node", is_node, read_node, 0},
    {"a count and lines", 0, 0, 0, is_counted, read_counted, 0},
    {"a title, a count and lines", 0, 0, 0, is_titled_count, read_titled, 0},
    {"lines of numbers", "", START, 0, 0, take_lines, 0}};

#define FORMATS (sizeof formats / sizeof formats[0])

/* is_text - are the first bytes so many of plain text, and a line, without
 * signs that text has not?  (Letters by which a binary format is known may
 * begin a text, too.) */
static int is_text(const scan *s, int bytes)
{
    const char *c = s->at;
    int lines = 0;

    for (; c < s->end && c < s->at + 512; c++) {
        lines |= *c == '\n';
        if (((unsigned char)*c < ' ' && !isspace((unsigned char)*c)) ||
            (c < s->at + bytes && (unsigned char)*c > '~'))
            return 0;
    }
    return lines;
}

/* matches - is the file of that format? */
static int matches(reader *r, const format *f)
{
    const scan *s = &r->s;
    const char *from, *end = s->end;

    scan_again(&r->s);
    if (!f->pattern) return f->is(r);
    from = s->at;
    if (f->from > 0)
        return end - from >= f->from &&
               memcmp(from, f->pattern, (size_t)f->from) == 0 &&
               !is_text(s, f->from);
    if (end - from > SAMPLE) end = from + SAMPLE;
    if (f->from != START) from += strspn(from, " \t\f\v\r\n");
    while (f->from == LINE && *from == '#') {
        from += strcspn(from, "\r\n");
        from += strspn(from, " \t\f\v\r\n");
    }
    return like(from, end, f->pattern);
}

void read_points(const char *name, points *a)
{
    reader *r = (reader *)space(1.0, sizeof *r);
    const format *f = formats, *g;

    memset(r, 0, sizeof *r);
    r->to = a;
    r->want = -1.0;
    r->by = r->keeps = r->number = r->family = r->twin = -1;
    r->share = 1.0;
    r->d.separator = ' ';
    r->d.decimal = '.';
    scan_open(&r->s, name);
    a->input = r->s.name;
    scan_pin(&r->s);
    r->skims = 1;
    while (!matches(r, f)) f++;
    r->skims = 0;
    scan_go(&r->s);
    if (!f->read) fail("%s: is %s, which is not read: %s", a->input, f->name,
                       f->instead);
    for (g = formats; g < formats + FORMATS; g++)
        if (g->ending && ends_in(a->input, g->ending) && g->read != f->read &&
            !(f->ending && ends_in(a->input, f->ending)))
            fail("%s: is named as %s, but begins as %s: give it another name, "
                 "or mend it", a->input, g->name, f->name);
    f->read(r);
    end_rows(r);
    scan_end(&r->s);
    free(r);
    progress("reading", 1.0, 1.0);
}
