/* atoms.c - atoms: extended .xyz files, PDB, PQR, Amber's restarts, LAMMPS
 * dumps; and the box that repeats itself.
 */
#include <ctype.h>
#include <math.h>
#include <string.h>

#include "read.h"

/* ---- extended .xyz ---- */

/* after - what is behind `key=' in the line; *end: where it ends, by its quotes
 * or brackets, or a blank.  0 if the line has no such key. */
static char *after(reader *r, const char *key, char **end)
{
    static const char open[] = "\"'{[", closes[] = "\"'}]";
    size_t length = strlen(key);
    const char *mark;
    char *s = r->s.line, *e;

    while ((s = strstr(s, key)) != 0 &&
           ((s > r->s.line && s[-1] != ' ' && s[-1] != '\t') ||
            s[length] != '='))
        s++;
    if (!s) return 0;
    s += length + 1;
    *end = s + strcspn(s, " \t");
    mark = *s ? strchr(open, *s) : 0;
    if (!mark) return s;
    e = strchr(s + 1, closes[mark - open]);
    /* (brackets in brackets; no further one behind a key) */
    if (*mark == '[')
        for (e = s + strcspn(s, "="); e > s && *e != ']';) e--;
    if (!e || e == s || (e[1] && e[1] != ' ' && e[1] != '\t'))
        scan_fail(&r->s, "%s does not end with %c and a blank", key,
                  closes[mark - open]);
    *end = e;
    return s + 1;
}

/* part - the cells of the line's part s ... end. */
static int part(reader *r, char *s, char *end, char separator)
{
    char *line = r->s.line, held = *end;
    int n;

    r->s.line = s;
    r->d.separator = separator;
    *end = '\0';
    n = cut(r);
    *end = held;
    r->d.separator = ' ';
    r->s.line = line;
    return n;
}

/* properties - the columns that the file says it has, such as
 * species:S:1:pos:R:3, up to end. */
static void properties(reader *r, char *s, char *end)
{
    const cell *c = r->cell;
    char title[TITLE];
    double many;
    int n = part(r, s, end, ':'), k;
    column *p;

    r->named = 1;
    if (n == 0 || n % 3 != 0) n = 1;
    for (; n > 0; n -= 3, c += 3) {
        if (n < 3 || c->text == c->end || c[1].end != c[1].text + 1 ||
            !strchr("SRIL", *c[1].text) || !cell_whole(c + 2, &many) ||
            many < 1.0 || many > COLUMNS)
            scan_fail(&r->s, "Properties are not as species:S:1:pos:R:3");
        for (k = 0; k < (int)many; k++) {
            sprintf(title, "%.*s", TITLED(c));
            if (many > 1.0) sprintf(title + strlen(title), "%d", k + 1);
            if (many == 3.0 && cell_is(c, "pos"))
                sprintf(title, "%c", 'x' + k);
            p = add_column(r, title);
            if (strchr("SL", *c[1].text)) p->role = LABEL;
        }
    }
}

/* periodic - along which vectors the box repeats itself: "T T F", or T,T,0; or
 * one for all. */
static void periodic(reader *r, char *s, char *end)
{
    int *ways = r->to->ways, n, k;
    const cell *c = r->cell;
    char *comma;

    for (comma = s; comma < end; comma++)
        if (*comma == ',') *comma = ' ';
    n = part(r, s, end, ' ');
    for (k = 0; k < n && n < 4; k++, c++) {
        ways[k] = cell_is(c, "T") || cell_is(c, "1") || cell_is(c, "True");
        if (!ways[k] && !cell_is(c, "F") && !cell_is(c, "0") &&
            !cell_is(c, "False"))
            n = 0;
    }
    if (n == 1) ways[1] = ways[2] = ways[0];
    else if (n != 3) scan_fail(&r->s, "pbc needs three of T and F");
}

int extended(reader *r)
{
    char *vectors_end, *from_end, *end;
    char *vectors = after(r, "Lattice", &vectors_end);
    char *from = after(r, "Origin", &from_end);
    char *columns;
    double v[9], origin[3];

    origin[0] = origin[1] = origin[2] = 0.0;
    if (from && vectors && !numbers(from, from_end, 3, origin))
        scan_fail(&r->s, "Origin needs 3 numbers");
    if (vectors) {
        if (!numbers(vectors, vectors_end, 9, v))
            scan_fail(&r->s, "Lattice needs 9 numbers");
        lattice(r->to, v, origin);
        from = after(r, "pbc", &end);
        if (from) periodic(r, from, end);
    }
    columns = after(r, "Properties", &end);
    if (columns) properties(r, columns, end);
    return vectors || columns;
}

/* ---- PDB ---- */

/* record - does the line begin with this name of six characters? */
static int record(const char *line, const char *name)
{
    return strncmp(line, name, 6) == 0;
}

/* known_record - of any kind. */
static int known_record(const char *line)
{
    static const char names[] =
        " HEADER OBSLTE TITLE SPLIT CAVEAT COMPND SOURCE KEYWDS EXPDTA NUMMDL "
        "MDLTYP AUTHOR REVDAT SPRSDE JRNL REMARK DBREF DBREF1 DBREF2 SEQADV "
        "SEQRES MODRES HET HETNAM HETSYN FORMUL HELIX SHEET TURN SSBOND LINK "
        "HYDBND SLTBRG CISPEP SITE CRYST1 ORIGX1 ORIGX2 ORIGX3 SCALE1 SCALE2 "
        "SCALE3 MTRIX1 MTRIX2 MTRIX3 TVECT MODEL SIGATM ANISOU SIGUIJ TER "
        "ENDMDL CONECT MASTER END FTNOTE ";
    size_t n = strcspn(line, " ");

    return listed(names, line, line + (n < 6 ? n : 6), ' ') != 0;
}

/* atom - is the line one?  (Serial numbers may begin early.) */
static int atom(const char *line)
{
    return record(line, "HETATM") ||
           (strncmp(line, "ATOM", 4) == 0 &&
            (line[4] == ' ' || isdigit((unsigned char)line[4])) &&
            (line[5] == ' ' || isdigit((unsigned char)line[5])));
}

int is_pdb(reader *r)
{
    scan *s = &r->s;

    scan_again(s);
    if (!scan_line(s) || (!known_record(s->line) && !atom(s->line))) return 0;
    if (strlen(s->line) > 6 &&
        strchr(",;\t", s->line[6 + strspn(s->line + 6, " ")]))
        return 0;
    if (atom(s->line)) return s->stop - s->line >= 54;
    return scan_line(s) && (known_record(s->line) || atom(s->line));
}

/* fixed - the number in those columns; fallback if they are blank. */
static double fixed(reader *r, int from, int last, double fallback)
{
    cell c;

    cut_fixed(&r->s, from, last, &c);
    if (c.kind == EMPTY) return fallback;
    if (c.kind != NUMBER)
        scan_fail(&r->s, "columns %d to %d: \"%.*s\": not a number", from, last,
                  (int)(c.end - c.text), c.text);
    return c.x;
}

/* crystal - the box of those sides and angles, which repeats itself; 0 if that
 * is not asked for.  (A cube of side 1 is what files have for want of one.) */
static int crystal(reader *r, const double *side, const double *angle)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    double v[9] = {0.0}, sine, c[3];
    int k;

    for (k = 0; k < 3; k++) {
        v[4 * k] = side[k];
        c[k] = angle[k] == 90.0 ? 0.0 : cos(angle[k] * atan(1.0) / 45.0);
    }
    if (!chosen.periodic || (v[0] == 1.0 && v[4] == 1.0 && v[8] == 1.0))
        return 0;
    /* the first vector is along x, the second in the plane of x, y */
    sine = sqrt(1.0 - c[2] * c[2]);
    v[3] = side[1] * c[2];
    v[4] = side[1] * sine;
    v[6] = side[2] * c[1];
    v[7] = c[0] - c[1] * c[2] == 0.0 ? 0.0
                                     : side[2] * (c[0] - c[1] * c[2]) / sine;
    v[8] = sqrt(side[2] * side[2] - v[6] * v[6] - v[7] * v[7]);
    if (v[6] == 0.0 && v[7] == 0.0) v[8] = side[2];
    if (!(v[8] > 0.0)) scan_fail(&r->s, "the angles are none of a cell");
    lattice(r->to, v, origin);
    return 1;
}

/* cryst1 - the line is that record. */
static void cryst1(reader *r)
{
    double side[3], angle[3];
    cell group;
    int k;

    for (k = 0; k < 3; k++) {
        side[k] = fixed(r, 7 + 9 * k, 15 + 9 * k, 0.0);
        angle[k] = fixed(r, 34 + 7 * k, 40 + 7 * k, 90.0);
    }
    r->s.head++;
    if (!crystal(r, side, angle)) return;
    cut_fixed(&r->s, 56, 66, &group);
    if (group.kind != EMPTY && !cell_is(&group, "P 1"))
        warn("%s:%ld: the atoms are repeated as they are, without what "
             "the space group %.*s adds in the cell",
             r->s.name, r->s.number, SHOWN(&group));
}

void read_pdb(reader *r)
{
    static const struct {
        const char *title;
        int from, last, role;
    } columns[] = {{"name", 13, 16, LABEL}, {"x", 31, 38, VALUE},
                   {"y", 39, 46, VALUE}, {"z", 47, 54, VALUE},
                   {"B", 61, 66, VALUE}, {"occupancy", 55, 60, UNUSED}};
    scan *s = &r->s;
    char residue[8] = "", place = ' ', *line;
    int k, models = 0;
    cell *c;

    r->form = FIXED;
    for (k = 0; k < 6; k++)
        add_column(r, columns[k].title)->role = columns[k].role;
    take_columns(r);
    r->words = 0; /* (an atom's name may be a number) */
    while (scan_line(s)) {
        line = s->line;
        models |= record(line, "ENDMDL");
        if (!line[strspn(line, " \t")]) {
            s->blank++;
        } else if (models) {
            scan_leave(s, strncmp(line, "END", 3) == 0 ||
                                  record(line, "CONECT") ||
                                  record(line, "MASTER")
                              ? "records other than atoms" : "other models");
        } else if (record(line, "CRYST1")) {
            cryst1(r);
        } else if (!atom(line)) {
            scan_leave(s, known_record(line) ? "records other than atoms"
                                             : "lines of unknown records");
        } else {
            if (s->stop - line < 54) scan_fail(s, "not an atom of a PDB file");
            if (strncmp(residue, line + 21, 6) != 0) place = ' ';
            sprintf(residue, "%.6s", line + 21);
            if (place == ' ') place = line[16];
            if (line[16] != ' ' && line[16] != place) {
                scan_leave(s, "alternative places");
                continue;
            }
            for (k = 0; k < r->columns; k++) {
                c = r->cell + k;
                cut_fixed(s, columns[k].from, columns[k].last, c);
                if (k > 3 && c->kind == EMPTY) c->kind = NUMBER; /* of 0 */
            }
            take_row(r);
        }
    }
}

/* ---- PQR ---- */

/* free_cells - has the line as many cells, by blanks, as an atom in words: ten,
 * or eleven with a chain?  What is before x is the residue's number, perhaps
 * behind the chain. */
static int free_cells(const reader *r)
{
    const cell *c = r->cell + r->cells - 6;

    if (r->cells != 10 && r->cells != 11) return 0;
    return !memchr(c->text, '.', (size_t)(c->end - c->text)) &&
           (r->cells == 11 || c->kind == NUMBER || c->end - c->text > 1);
}

/* five_numbers - are the cells 1 to 5? */
static int five_numbers(const cell *c)
{
    int k;

    for (k = 1; k < 6 && c[k].kind == NUMBER;) k++;
    return k == 6;
}

/* cut_atom - the line's cells, without an element behind, as Open Babel writes
 * it; returns how many. */
static int cut_atom(reader *r)
{
    int n = cut(r);

    if (n > 2 && r->cell[n - 1].kind == WORD &&
        isalpha((unsigned char)*r->cell[n - 1].text))
        r->cells = --n;
    return n;
}

/* pqr_atom - the cells 1 to 5 become x, y, z, charge and radius, the one before
 * the name: the line's last words, or, where words touch, x, y, z in PDB's
 * columns, and two words behind.  2 if they are numbers; 1 if not, but so many
 * are there; else 0. */
static int pqr_atom(reader *r)
{
    scan *s = &r->s;
    cell *c = r->cell, place[3], words[6];
    char *line = s->line;
    int n = cut_atom(r), k, has = free_cells(r);

    if (has) {
        c[0] = c[2];
        memmove(c + 1, c + n - 5, 5 * sizeof *c);
    }
    memcpy(words, c, sizeof words);
    if (has && five_numbers(c)) return 2;
    if (s->stop - line > 54) {
        s->line += 54;
        n = cut_atom(r);
        s->line = line;
        if (n == 2) {
            for (k = 0; k < 3; k++)
                cut_fixed(s, 31 + 8 * k, 38 + 8 * k, place + k);
            c[5] = c[1];
            c[4] = c[0];
            memcpy(c + 1, place, sizeof place);
            cut_fixed(s, 13, 16, c);
            if (five_numbers(c) || !has) return 1 + five_numbers(c);
        }
    }
    memcpy(c, words, sizeof words);
    return has;
}

/* pdb_tail - has the atom's line, behind its place, what PDB has there: the
 * occupancy, and B, of two decimals each? */
static int pdb_tail(const scan *s)
{
    const char *c = s->line;
    size_t n = (size_t)(s->stop - c);

    if (n <= 54) return 0;
    return n > 59 && c[57] == '.' && isdigit((unsigned char)c[58]) &&
           isdigit((unsigned char)c[59]) &&
           (n < 63 || (n > 65 && c[63] == '.' &&
                       isdigit((unsigned char)c[64]) &&
                       isdigit((unsigned char)c[65]) &&
                       !isdigit((unsigned char)c[66])));
}

/* Most atoms of the sample say so. */
int is_pqr(reader *r)
{
    scan *s = &r->s;
    double pqr = 0.0;

    while (in_sample(s) && scan_line(s))
        if (!strncmp(s->line, "ATOM", 4) || !strncmp(s->line, "HETATM", 6)) {
            if (pqr_atom(r) == 2 &&
                (!pdb_tail(s) || ends_in(s->name, ".pqr")))
                pqr++;
            else
                pqr--;
        } else if (!known_record(s->line) &&
                   s->line[strspn(s->line, " \t")])
            pqr--;
    return pqr > 0.0;
}

void read_pqr(reader *r)
{
    static const char *const titles[] = {"name", "x", "y", "z", "charge",
                                         "radius"};
    scan *s = &r->s;
    int k, told = 0;

    r->form = FIXED;
    for (k = 0; k < 6; k++)
        add_column(r, titles[k])->role = k == 0 ? LABEL : VALUE;
    take_columns(r);
    r->words = 0;
    while (scan_line(s)) {
        if (!s->line[strspn(s->line, " \t")]) {
            s->blank++;
        } else if (strncmp(s->line, "ATOM", 4) &&
                   strncmp(s->line, "HETATM", 6)) {
            scan_leave(s, known_record(s->line) ? "records other than atoms"
                                                : "lines of unknown records");
        } else {
            if (!pqr_atom(r))
                scan_fail(s, "not an atom of a PQR file: x, y, z, charge and "
                          "radius at its end");
            if (!told++ && pdb_tail(s))
                warn("%s:%ld: its last numbers are charge and radius, as the "
                     "name's .pqr says, though in the columns of PDB's "
                     "occupancy and B", s->name, s->number);
            take_row(r);
        }
    }
}

/* ---- Amber's coordinates and restarts ---- */

/* amber_line - does the line have numbers of 12 columns, 7 decimals, alone?  So
 * many, at most six, or 0. */
static int amber_line(const scan *s)
{
    const char *c = s->line;
    size_t n = (size_t)(s->stop - c);
    int k;

    while (n > 0 && c[n - 1] == ' ') n--;
    if (n == 0 || n % 12 != 0 || n > 72) return 0;
    for (k = 0; k < (int)n / 12; k++, c += 12)
        if (c[4] != '.' && c[4] != '*') return 0;
    return (int)n / 12;
}

/* amber_head - of a title, a number of atoms, and perhaps a time: that
 * number. */
static int amber_head(reader *r, double *atoms)
{
    int n;

    if (!scan_line(&r->s) || !scan_line(&r->s)) return 0;
    n = cut(r);
    return n > 0 && n < 4 && cell_whole(r->cell, atoms) &&
           (n < 2 || r->cell[1].kind == NUMBER);
}

/* Most lines behind have so many numbers. */
int is_amber(reader *r)
{
    double atoms, lines, seen = 0.0, good = 0.0;

    if (!amber_head(r, &atoms)) return 0;
    for (lines = ceil(atoms / 2.0); seen < lines && in_sample(&r->s) &&
                                    scan_line(&r->s); seen++)
        good += amber_line(&r->s) == (2.0 * seen + 1.0 < atoms ? 6 : 3);
    return good > 0.0 && 2.0 * good >= seen;
}

/* amber_rest - behind so many lines may be as many of velocities, and last the
 * box. */
static void amber_rest(reader *r, double lines)
{
    static const char what[] = "velocities or the like";
    scan *s = &r->s;
    double behind = 0.0, box[6];
    int k, n = 0;

    while (scan_line(s)) {
        if (!s->line[strspn(s->line, " \t")]) {
            s->blank++;
            continue;
        }
        if (behind++ > 0.0) {
            s->number--;
            scan_leave(s, what);
            s->number++;
        }
        n = amber_line(s);
        for (k = 0; k < 6 && (n == 3 || n == 6); k++)
            box[k] = k < n ? fixed(r, 12 * k + 1, 12 * k + 12, 0.0) : 90.0;
    }
    for (k = 0; k < 6 && (n == 3 || n == 6); k++)
        if (!(box[k] > 0.0) || (k > 2 && !(box[k] < 180.0))) n = 0;
    if ((n == 3 || n == 6) && lines > 1.0 &&
        (behind == 1.0 || behind == lines + 1.0)) {
        s->head++;
        warn("%s:%ld: its last line is taken for the box: sides %g, %g, %g, "
             "angles %g, %g, %g", s->name, s->number, box[0], box[1], box[2],
             box[3], box[4], box[5]);
        crystal(r, box, box + 3);
    } else if (behind > 0.0)
        scan_leave(s, what);
}

void read_amber(reader *r)
{
    scan *s = &r->s;
    const char *end;
    double i;
    int k, j, n;

    amber_head(r, &r->want);
    s->head = 2.0;
    r->form = FIXED;
    scan_room(s, r->want, 36.0);
    add_axes(r, 0, 0);
    take_columns(r);
    for (i = 0.0; i < r->want; i += 2.0) {
        n = i + 1.0 < r->want ? 6 : 3;
        if (!scan_line(s))
            fail("%s: ends after %.0f of %.0f points", s->name, i, r->want);
        for (end = s->stop; end > s->line && end[-1] == ' ';) end--;
        if (end - s->line != 12 * n)
            scan_fail(s, "not %d numbers of 12 columns", n);
        r->share = 3.0 / n;
        for (k = 0; k < n; k += 3) {
            for (j = 0; j < 3; j++)
                cut_fixed(s, 12 * (k + j) + 1, 12 * (k + j) + 12, r->cell + j);
            take_row(r);
        }
    }
    r->share = 1.0;
    amber_rest(r, ceil(r->want / 2.0));
}

/* ---- LAMMPS dumps ---- */

/* item - the next line must be this one, or begin so; what is behind it. */
static char *item(reader *r, const char *text)
{
    scan *s = &r->s;
    size_t n = strlen(text);
    char *end;

    need_line(r);
    for (end = s->stop; end > s->line && (end[-1] == ' ' || end[-1] == '\t');)
        *--end = '\0';
    if (strncmp(s->line, text, n) != 0)
        scan_fail(s, "\"%.40s\": where a dump has %s", s->line, text);
    s->head++;
    return s->line + n;
}

/* dump_box - its bounds, of the box about a tilted one.  (A scaled coordinate
 * is a part of a vector.) */
static void dump_box(reader *r, char *flags)
{
    scan *s = &r->s;
    cell *c = r->cell;
    double low[3], high[3], tilt[3], v[9], x[3];
    int k, n, tilted, ways[3];

    s->line = flags;
    n = cut(r);
    if (n > 0 && cell_is(c, "abc"))
        scan_fail(s, "a box of any vectors is not read: in LAMMPS dump_modify "
                     "triclinic/general no");
    tilted = n == 6 && cell_is(c, "xy") && cell_is(c + 1, "xz") &&
             cell_is(c + 2, "yz");
    for (k = 0, c += 3 * tilted; k < 3; k++, c++) {
        if (n != 3 + 3 * tilted || c->end != c->text + 2 ||
            !strchr("pfsm", c->text[0]) || !strchr("pfsm", c->text[1]))
            scan_fail(s, "not three of pp, ff, ss, mm and the like");
        ways[k] = strncmp(c->text, "pp", 2) == 0;
    }
    for (k = 0; k < 3; k++) {
        x[2] = 0.0;
        item(r, "");
        if (!numbers(s->line, s->stop, 2 + tilted, x) || !(x[0] < x[1]))
            scan_fail(s, "not %d bounds of the box", 2 + tilted);
        low[k] = x[0];
        high[k] = x[1];
        tilt[k] = x[2];
    }
    /* of x they are off by the sums of xy, xz below 0, and above; of y by yz */
    for (x[0] = x[1] = 0.0, k = 0; k < 2; k++) x[tilt[k] > 0.0] += tilt[k];
    low[0] -= x[0];
    high[0] -= x[1];
    *(tilt[2] < 0.0 ? low + 1 : high + 1) -= tilt[2];
    for (k = 0; k < 9; k++) v[k] = k % 4 ? 0.0 : high[k / 4] - low[k / 4];
    v[3] = tilt[0];
    v[6] = tilt[1];
    v[7] = tilt[2];
    lattice(r->to, v, low);
    memcpy(r->to->ways, ways, sizeof ways);
}

/* dump_axes - x, xu, xs or xsu: the first kind of which all three are there are
 * x, y, z. */
static void dump_axes(reader *r)
{
    static const char *const kinds[] = {"", "u", "s", "su"};
    char title[4];
    int at[3], j, k, i;

    for (j = 0; j < 4; j++) {
        for (k = 0; k < 3; k++) {
            sprintf(title, "%c%s", 'x' + k, kinds[j]);
            for (i = 0; i < r->columns &&
                        strcmp(r->column[i].title, title) != 0;)
                i++;
            if (i == r->columns) break;
            at[k] = i;
        }
        if (k < 3) continue;
        for (k = 0; k < 3; k++) r->column[at[k]].title[1] = '\0';
        r->scaled = j > 1;
        break;
    }
    if (r->scaled && r->to->lattice == NO_LATTICE)
        scan_fail(&r->s, "no BOX BOUNDS before, for scaled coordinates");
}

void read_dump(reader *r)
{
    scan *s = &r->s;
    int k;
    char *text, title[TITLE];

    item(r, "ITEM: TIMESTEP");
    item(r, "");
    if (!numbers(s->line, s->stop, 1, r->x))
        scan_fail(s, "not the number of a timestep");
    for (;;) {
        text = item(r, "ITEM: ");
        if (strcmp(text, "NUMBER OF ATOMS") == 0) {
            item(r, "");
            if (!whole(s->line, s->line + strlen(s->line), &r->want))
                scan_fail(s, "not a number of atoms");
        } else if (strncmp(text, "BOX BOUNDS", 10) == 0)
            dump_box(r, text + 10);
        else if (strncmp(text, "ATOMS ", 6) == 0)
            break;
        else if (strncmp(text, "UNITS", 5) == 0 ||
                 strncmp(text, "TIME", 4) == 0)
            item(r, "");
        else
            scan_fail(s, "\"%.40s\": not an item of a dump", text);
    }
    s->line = text + 6;
    if (r->want < 0.0) scan_fail(s, "no NUMBER OF ATOMS before");
    cut(r);
    for (k = 0; k < r->cells; k++) {
        title_of(r->cell + k, title);
        add_column(r, title);
    }
    dump_axes(r);
    r->named = 1;
    /* words, as elements, are in columns without a number in the sample */
    for (k = 0; k < r->columns; k++) r->column[k].role = LABEL;
    r->most = r->want;
    scan_pin(s);
    while (sampled(r) > 0) {
        if (r->cells < r->columns) continue;
        for (k = 0; k < r->columns; k++)
            if (r->cell[k].kind != WORD || !r->column[k].title[1])
                r->column[k].role = VALUE;
    }
    scan_go(s);
    take_all(r, "further frames");
}
