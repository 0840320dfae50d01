/* atoms.c - atoms: extended .xyz files, PDB, LAMMPS dumps; and the box that
 * repeats itself.
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
    char *s;

    for (s = r->s.line; (s = strstr(s, key)) != 0; s++) {
        if ((s > r->s.line && s[-1] != ' ' && s[-1] != '\t') ||
            s[length] != '=')
            continue;
        s += length + 1;
        mark = *s ? strchr(open, *s) : 0;
        if (!mark) {
            *end = s + strcspn(s, " \t");
            return s;
        }
        *end = *mark == '[' ? strrchr(s, ']') : strchr(s + 1,
                                                       closes[mark - open]);
        /* (brackets in brackets; no further one behind a key) */
        if (*end && *mark == '[' && strchr(s, '='))
            for (*end = strchr(s, '='); *end > s && **end != ']';) --*end;
        if (!*end || *end == s || ((*end)[1] && (*end)[1] != ' ' &&
                                   (*end)[1] != '\t'))
            scan_fail(&r->s, "%s does not end with %c and a blank", key,
                      closes[mark - open]);
        return s + 1;
    }
    return 0;
}

/* properties - the columns that the file says it has, such as
 * species:S:1:pos:R:3. */
static void properties(reader *r, char *s, const char *end)
{
    size_t length;
    char title[TITLE], *next;
    double n;
    int k, type;
    column *c;

    r->named = 1;
    for (;; s = next + 1) {
        length = strcspn(s, ":");
        next = s + length + (s[length] ? 3 : 0);
        type = s + length + 3 < end ? s[length + 1] : 0;
        if (next < end) next += strcspn(next, ": \t\"'}");
        if (next > end) next = (char *)end;
        if (length == 0 || !type || !strchr("SRIL", type) ||
            s[length + 2] != ':' || !whole(s + length + 3, next, &n) ||
            n < 1.0 || n > COLUMNS)
            scan_fail(&r->s, "Properties are not as species:S:1:pos:R:3");
        if (length > TITLE - 5) length = TITLE - 5;
        for (k = 0; k < (int)n; k++) {
            if (length == 3 && n == 3.0 && strncmp(s, "pos", 3) == 0)
                sprintf(title, "%c", 'x' + k);
            else
                sprintf(title, n > 1.0 ? "%.*s%d" : "%.*s", (int)length, s,
                        k + 1);
            c = add_column(r, title, strlen(title));
            if (strchr("SL", type)) c->role = LABEL;
        }
        if (next == end) return;
    }
}

int extended(reader *r)
{
    static const char *const yes[] = {"T", "1", "True"},
                      *const no[] = {"F", "0", "False"};
    char *vectors_end, *from_end, *columns_end, *end, *s;
    char *vectors = after(r, "Lattice", &vectors_end);
    char *from = after(r, "Origin", &from_end);
    char *columns = after(r, "Properties", &columns_end);
    double v[9], origin[3];
    int k, j;
    cell c;

    origin[0] = origin[1] = origin[2] = 0.0;
    if (from && vectors && !numbers(from, from_end, 3, origin))
        scan_fail(&r->s, "Origin needs 3 numbers");
    if (vectors) {
        if (!numbers(vectors, vectors_end, 9, v))
            scan_fail(&r->s, "Lattice needs 9 numbers");
        lattice(r->to, v, origin);
        /* "T T F", or T,T,0; or one for all */
        s = after(r, "pbc", &end);
        for (k = 0; k < 3 && s; k++) {
            s += strspn(s, " \t,");
            c.text = s;
            s += strcspn(s, " \t,\"'}]");
            c.end = s > end ? end : s;
            for (j = 0; j < 3 && !cell_is(&c, yes[j]) && !cell_is(&c, no[j]);)
                j++;
            if (j == 3) scan_fail(&r->s, "pbc needs three of T and F");
            r->to->ways[k] = cell_is(&c, yes[j]);
            if (s < end) continue;
            if (k == 0) r->to->ways[1] = r->to->ways[2] = r->to->ways[0];
            if (k == 1) scan_fail(&r->s, "pbc needs three of T and F");
            s = 0;
        }
        if (s && s < end) scan_fail(&r->s, "pbc needs three of T and F");
    }
    if (columns) properties(r, columns, columns_end);
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
        "HEADER OBSLTE TITLE  SPLIT  CAVEAT COMPND SOURCE KEYWDS EXPDTA NUMMDL "
        "MDLTYP AUTHOR REVDAT SPRSDE JRNL   REMARK DBREF  DBREF1 DBREF2 SEQADV "
        "SEQRES MODRES HET    HETNAM HETSYN FORMUL HELIX  SHEET  TURN   SSBOND "
        "LINK   HYDBND SLTBRG CISPEP SITE   CRYST1 ORIGX1 ORIGX2 ORIGX3 SCALE1 "
        "SCALE2 SCALE3 MTRIX1 MTRIX2 MTRIX3 TVECT  MODEL  SIGATM ANISOU SIGUIJ "
        "TER    ENDMDL CONECT MASTER END    FTNOTE ";
    char name[8];
    const char *at;

    sprintf(name, "%-6.6s ", line);
    at = strstr(names, name);
    return at && (at - names) % 7 == 0;
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
    return cell_value(&c);
}

/* crystal - CRYST1: sides and angles of the box that repeats itself.  (A cube
 * of side 1 is what files have for want of one.) */
static void crystal(reader *r)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const char *line = r->s.line;
    const char *group = strlen(line) > 55 ? line + 55 : "P 1";
    double v[9] = {0.0}, angle, c[3], side[3];
    int k;

    for (k = 0; k < 3; k++) {
        v[4 * k] = side[k] = fixed(r, 7 + 9 * k, 15 + 9 * k, 0.0);
        angle = fixed(r, 34 + 7 * k, 40 + 7 * k, 90.0);
        c[k] = angle == 90.0 ? 0.0 : cos(angle * atan(1.0) / 45.0);
    }
    if (!chosen.periodic || (v[0] == 1.0 && v[4] == 1.0 && v[8] == 1.0)) return;
    /* the first vector is along x, the second in the plane of x, y */
    angle = sqrt(1.0 - c[2] * c[2]);
    v[3] = side[1] * c[2];
    v[4] = side[1] * angle;
    v[6] = side[2] * c[1];
    v[7] = c[0] - c[1] * c[2] == 0.0 ? 0.0
                                     : side[2] * (c[0] - c[1] * c[2]) / angle;
    v[8] = sqrt(side[2] * side[2] - v[6] * v[6] - v[7] * v[7]);
    if (v[6] == 0.0 && v[7] == 0.0) v[8] = side[2];
    if (!(v[8] > 0.0)) scan_fail(&r->s, "the angles are none of a cell");
    lattice(r->to, v, origin);
    if (strncmp(group, "P 1        ", strlen(group) < 11 ? strlen(group) : 11))
        warn("%s:%ld: the atoms are repeated as they are, without what "
             "the space group %.11s adds in the cell",
             r->s.name, r->s.number, group);
}

/* fixed_column - one more. */
static void fixed_column(reader *r, const char *title, int from, int last)
{
    column *c = add_column(r, title, strlen(title));

    c->from = from;
    c->last = last;
}

void read_pdb(reader *r)
{
    scan *s = &r->s;
    char residue[8] = "", place = ' ';
    int k;

    r->form = FIXED;
    fixed_column(r, "name", 13, 16);
    fixed_column(r, "x", 31, 38);
    fixed_column(r, "y", 39, 46);
    fixed_column(r, "z", 47, 54);
    fixed_column(r, "B", 61, 66);
    fixed_column(r, "occupancy", 55, 60);
    r->column[0].role = LABEL;
    r->column[5].role = UNUSED;
    take_columns(r);
    r->words = 0; /* (an atom's name may be a number) */
    while (scan_line(s)) {
        if (record(s->line, "ENDMDL")) {
            scan_leave(s, "other records");
            while (scan_line(s))
                if (comment(s)) s->blank++;
                else scan_leave(s, strncmp(s->line, "END", 3) == 0 ||
                                           record(s->line, "CONECT") ||
                                           record(s->line, "MASTER")
                                       ? "other records"
                                       : "other models");
            break;
        }
        if (!s->line[strspn(s->line, " \t")]) {
            s->blank++;
            continue;
        }
        if (record(s->line, "CRYST1")) {
            crystal(r);
            s->head++;
            continue;
        }
        if (!atom(s->line)) {
            scan_leave(s, known_record(s->line) ? "other records"
                                                : "lines of unknown records");
            continue;
        }
        if (s->stop - s->line < 54) scan_fail(s, "not an atom of a PDB file");
        if (strncmp(residue, s->line + 21, 6) != 0) place = ' ';
        sprintf(residue, "%.6s", s->line + 21);
        if (s->line[16] != ' ' && place == ' ') place = s->line[16];
        if (s->line[16] != ' ' && s->line[16] != place) {
            scan_leave(s, "alternative places");
            continue;
        }
        for (k = 0; k < r->columns; k++)
            cut_fixed(s, r->column[k].from, r->column[k].last, r->cell + k);
        for (k = 4; k < 6; k++)
            if (r->cell[k].kind == EMPTY) {
                r->cell[k].kind = NUMBER;
                r->cell[k].odd = 2;
                r->cell[k].x = 0.0;
            }
        take_row(r);
    }
}

/* ---- LAMMPS dumps ---- */

/* item - the next line must be this one, or begin so; what is behind it. */
static char *item(reader *r, const char *text)
{
    scan *s = &r->s;
    size_t n = strlen(text);
    char *end;

    if (!scan_line(s)) fail("%s: ends before the first point", s->name);
    for (end = s->stop; end > s->line && (end[-1] == ' ' || end[-1] == '\t');)
        *--end = '\0';
    if (strncmp(s->line, text, n) != 0)
        scan_fail(s, "\"%.40s\": where a dump has %s", s->line, text);
    s->head++;
    return s->line + n;
}

/* dump_box - its bounds, of the box about a tilted one.  (A scaled coordinate
 * is a part of a vector.) */
static void dump_box(reader *r, const char *flags)
{
    scan *s = &r->s;
    char way[3][4];
    double low[3], high[3], tilt[3], v[9], x[3], a, b;
    int k, tilted = strncmp(flags, " xy xz yz", 9) == 0;

    if (strncmp(flags, " abc", 4) == 0)
        scan_fail(s, "a box of any vectors is not read: in LAMMPS dump_modify "
                     "triclinic/general no");
    if (tilted) flags += 9;
    for (k = 0; k < 3; k++) {
        flags += strspn(flags, " \t");
        sprintf(way[k], "%.2s", flags);
        if (strlen(way[k]) != 2 || !strchr("pfsm", way[k][0]) ||
            !strchr("pfsm", way[k][1]))
            scan_fail(s, "not three of pp, ff, ss, mm and the like");
        flags += 2;
    }
    if (*flags) scan_fail(s, "\"%.20s\": something behind the box's ways",
                          flags);
    for (k = 0; k < 3; k++) {
        tilt[k] = x[2] = 0.0;
        item(r, "");
        if (!numbers(s->line, s->stop, 2 + tilted, x) || !(x[0] < x[1]))
            scan_fail(s, "not %d bounds of the box", 2 + tilted);
        low[k] = x[0];
        high[k] = x[1];
        tilt[k] = x[2];
    }
    for (a = b = 0.0, k = 0; k < 4; k++) {
        x[0] = (k & 1 ? tilt[0] : 0.0) + (k & 2 ? tilt[1] : 0.0);
        a = x[0] < a ? x[0] : a;
        b = x[0] > b ? x[0] : b;
    }
    low[0] -= a;
    high[0] -= b;
    low[1] -= tilt[2] < 0.0 ? tilt[2] : 0.0;
    high[1] -= tilt[2] > 0.0 ? tilt[2] : 0.0;
    for (k = 0; k < 9; k++) v[k] = k % 4 ? 0.0 : high[k / 4] - low[k / 4];
    v[3] = tilt[0];
    v[6] = tilt[1];
    v[7] = tilt[2];
    lattice(r->to, v, low);
    for (k = 0; k < 3; k++) r->to->ways[k] = strcmp(way[k], "pp") == 0;
}

void read_dump(reader *r)
{
    static const char *const kinds[] = {"", "u", "s", "su"};
    scan *s = &r->s;
    int k, j, n, more, found;
    char title[4];
    cell *c = r->cell;

    item(r, "ITEM: TIMESTEP");
    item(r, "");
    c->text = s->line;
    c->end = s->stop;
    if (numbers(c->text, c->end, 1, r->x) == 0)
        scan_fail(s, "not the number of a timestep");
    for (;;) {
        char *rest = item(r, "ITEM: ");
        if (strcmp(rest, "NUMBER OF ATOMS") == 0) {
            item(r, "");
            if (!whole(s->line, s->line + strlen(s->line), &r->want))
                scan_fail(s, "not a number of atoms");
        } else if (strncmp(rest, "BOX BOUNDS", 10) == 0) {
            dump_box(r, rest + 10);
        } else if (strncmp(rest, "ATOMS ", 6) == 0) {
            s->line = rest + 6;
            break;
        } else if (strncmp(rest, "UNITS", 5) == 0 ||
                   strncmp(rest, "TIME", 4) == 0) {
            item(r, "");
        } else
            scan_fail(s, "\"%.40s\": not an item of a dump", rest);
    }
    if (r->want < 0.0) scan_fail(s, "no NUMBER OF ATOMS before");
    n = cut(s, &r->d, r->cell, &more);
    for (k = 0; k < n; k++)
        add_column(r, c[k].text, (size_t)(c[k].end - c[k].text));
    /* x, xu, xs or xsu: the first kind of which all three are there */
    for (j = found = 0; j < 4 && found < 3; j++) {
        for (found = k = 0; k < 3 * n; k++) {
            sprintf(title, "%c%s", 'x' + k / n, kinds[j]);
            found += strcmp(r->column[k % n].title, title) == 0;
        }
        for (k = 0; k < 3 * n && found == 3; k++) {
            sprintf(title, "%c%s", 'x' + k / n, kinds[j]);
            if (strcmp(r->column[k % n].title, title) == 0)
                r->column[k % n].title[1] = '\0';
        }
        r->scaled = found == 3 && j > 1;
    }
    if (r->scaled && r->to->lattice == NO_LATTICE)
        scan_fail(s, "no BOX BOUNDS before, for scaled coordinates");
    r->named = 1;
    scan_room(s, r->want, 2.0 * r->columns);
    /* words, as elements, are in columns without a number in the sample */
    for (k = 0; k < n; k++) r->column[k].role = LABEL;
    scan_pin(s);
    for (j = 0; j < r->want && (size_t)(s->at - s->block) < s->mark + SAMPLE &&
                next_cells(s, &r->d, c, &more) >= n; j++)
        for (k = 0; k < n; k++)
            if (c[k].kind != WORD || r->column[k].title[1] == '\0')
                r->column[k].role = VALUE;
    scan_go(s);
    take_columns(r);
    take_rows(r);
    scan_rest(s, "further frames");
}
