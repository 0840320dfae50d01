/* tables.c - tables of lines behind a head by which they are known: GeoEAS,
 * Petrel's points, CFD-Post's exports, Sea-Bird's casts, ODV's and CCHDO's
 * stations, well logs.
 */
#include <ctype.h>
#include <string.h>

#include "read.h"

/* begins - does the line begin so, in letters of any case? */
static int begins(const scan *s, const char *text)
{
    const char *c = s->line;

    while (*text && tolower((unsigned char)*c) == *text) {
        c++;
        text++;
    }
    return !*text;
}

/* trimmed - a column more, called what is in s ... end, without the blanks
 * about it. */
static column *trimmed(reader *r, const char *s, const char *end)
{
    char title[TITLE];
    cell c;

    while (s < end && isspace((unsigned char)*s)) s++;
    while (end > s && isspace((unsigned char)end[-1])) end--;
    c.text = (char *)s;
    c.end = (char *)end;
    c.quoted = 0;
    title_of(&c, title);
    return add_column(r, title);
}

/* head_line - the next one, of the head, which must be there. */
static void head_line(reader *r)
{
    need_line(r);
    r->s.head++;
}

/* ---- GeoEAS, GSLIB: a title, how many names, a name a line ---- */

/* all_numbers - how many cells has the line, all numbers?  Else 0. */
static int all_numbers(reader *r)
{
    int k, n = cut(r);

    for (k = 0; k < n; k++)
        if (r->cell[k].kind != NUMBER) return 0;
    return n;
}

/* So it is if a row of so many numbers follows the names, or the line behind;
 * or else names, for then they are not as many as the head says. */
int is_geoeas(reader *r)
{
    scan *s = &r->s;
    double n, found;
    int k, words = 1, before = 0;

    if (!scan_line(s) || all_numbers(r) || !scan_line(s) || !all_numbers(r) ||
        !cell_whole(r->cell, &n) || n < 1.0 || n > COLUMNS)
        return 0;
    for (k = 1; k < r->cells; k++)
        if (!cell_whole(r->cell + k, &found)) return 0;
    for (found = 0.0; in_sample(s) && scan_line(s); found++) {
        k = all_numbers(r);
        if (k > 0 && (found == n || (found == n + 1.0 && before == (int)n)))
            return k == (int)n;
        if (k > 0) return found > 1.0 && words;
        before = r->cells;
        for (k = 0; k < before; k++) words &= r->cell[k].kind == WORD;
    }
    return 0;
}

void read_geoeas(reader *r)
{
    scan *s = &r->s;
    double n;
    int k;

    head_line(r);
    head_line(r);
    cut(r);
    cell_whole(r->cell, &n);
    for (k = 0; k < (int)n; k++) {
        need_line(r);
        if (all_numbers(r) > 1)
            scan_fail(s, "numbers, where line 2 announces a name: %.0f of them",
                      n);
        s->head++;
        trimmed(r, s->line, s->stop);
    }
    scan_pin(s);
    need_line(r);
    for (cut(r), k = 0; k < r->cells && r->cell[k].kind == WORD;) k++;
    if (r->cells > 0 && k == r->cells)
        scan_fail(s, "no numbers, where line 2 announces %.0f names before "
                  "them", n);
    scan_go(s);
    take_table(r);
}

/* ---- Petrel's points with attributes ---- */

int is_petrel(reader *r)
{
    scan *s = &r->s;

    if (is_unknown(r) || !next_line(s)) return 0;
    return begins(s, "begin header") ||
           (begins(s, "version ") && next_line(s) && begins(s, "begin header"));
}

void read_petrel(reader *r)
{
    scan *s = &r->s;
    const char *comma;

    do {
        need_line(r);
        if (comment(s)) s->blank++;
        else s->head++;
    } while (!begins(s, "begin header"));
    for (;;) {
        need_line(r);
        if (comment(s)) {
            s->blank++;
            continue;
        }
        s->head++;
        if (begins(s, "end header")) break;
        comma = strchr(s->line, ',');
        trimmed(r, comma ? comma + 1 : s->line, s->stop);
    }
    take_table(r);
}

/* ---- CFD-Post's exports, CFX's profiles: [Name] ... [Data] ---- */

void read_post(reader *r)
{
    scan *s = &r->s;
    int k;

    do {
        need_line(r);
        if (s->line[strspn(s->line, " \t")]) s->head++;
        else s->blank++;
        if (*s->line == '[' && !begins(s, "[name]") &&
            !begins(s, "[parameters]") && !begins(s, "[spatial fields]") &&
            !begins(s, "[data]"))
            scan_fail(s, "\"%.40s\": not a part of such a file", s->line);
    } while (!begins(s, "[data]"));
    r->d.separator = ',';
    need_cells(r);
    for (k = 0; k < r->cells; k++)
        trimmed(r, r->cell[k].text, r->cell[k].end);
    r->ends = "[";
    take_table(r);
    scan_rest(s, "faces, lines or further places");
}

/* ---- Sea-Bird's .cnv ---- */

/* after_sign - what is behind = in the line. */
static char *after_sign(const scan *s)
{
    char *c = strchr(s->line, '=');

    return c ? c + 1 + strspn(c + 1, " \t") : s->stop;
}

void read_cnv(reader *r)
{
    static const char *const keys[] = {"# nquan ", "# nvalues ",
                                       "# bad_flag ", "# file_type "};
    scan *s = &r->s;
    double n, x[4];
    char *at, *end;
    int k, told[4] = {0};

    do {
        head_line(r);
        at = after_sign(s);
        end = s->stop;
        while (end > at && isspace((unsigned char)end[-1])) end--;
        if (begins(s, "# name ")) {
            if (!whole(s->line + 7, s->line + 7 + strspn(s->line + 7,
                                                         "0123456789"), &n) ||
                n != (double)r->columns || at == s->stop)
                scan_fail(s, "not name %d", r->columns);
            trimmed(r, at, at + strcspn(at, ":"));
        }
        for (k = 0; k < 4 && !begins(s, keys[k]);) k++;
        if (k == 4) continue;
        told[k] = 1;
        if (k < 2 ? !whole(at, end, x + k)
                  : k == 2 && !numbers(at, end, 1, x + k))
            scan_fail(s, "\"%.*s\": not a number", (int)(end - at), at);
        if (k == 3 && (end - at != 5 || strncmp(at, "ascii", 5)))
            fail("%s: is binary, which is not read: convert it as ASCII",
                 s->name);
    } while (!begins(s, "*end*"));
    for (k = 0; k < 4; k++)
        if (!told[k])
            fail("%s: no line \"%s= ...\" in its head", s->name, keys[k]);
    if (x[0] != (double)r->columns)
        fail("%s: announces %.0f columns, names %d", s->name, x[0],
             r->columns);
    for (k = 0; k < r->columns; k++) {
        r->column[k].lacks = 1;
        r->column[k].lacking = x[2];
    }
    r->want = x[1];
    r->wide = 11;
    r->nowhere = "a cast without columns longitude, latitude, which is not "
                 "read: write x, y, depth and values as CSV";
    take_table(r);
    scan_rest(s, "lines behind the values announced");
}

/* ---- ODV's spreadsheets ---- */

int is_odv(reader *r)
{
    static const char *const first[] = {"cruise", "station", "type"};
    scan *s = &r->s;
    char *line;
    int k;

    if (!next_line(s)) return 0;
    line = s->line;
    for (k = 0; k < 3; k++) {
        if (!begins(s, first[k])) break;
        s->line += strlen(first[k]);
        if (!*s->line || !strchr("\t;,", *s->line)) break;
        s->line++;
    }
    s->line = line;
    return k == 3;
}

/* (What says where a station is need not be said again in its next lines.) */
void read_odv(reader *r)
{
    r->fills = 1;
    take_lines(r);
}

/* ---- CCHDO's bottles (WOCE's exchange format) ---- */

void read_bottles(reader *r)
{
    scan *s = &r->s;
    column *c;
    int k;

    r->d.separator = ',';
    need_cells(r);
    need_cells(r);
    for (k = 0; k < r->cells; k++) {
        c = trimmed(r, r->cell[k].text, r->cell[k].end);
        c->lacks = 1;
        c->lacking = -999.0;
        c->apart = strcmp(c->title, "DEPTH") == 0; /* (the bottom's) */
    }
    if (need_cells(r) != r->columns)
        scan_fail(s, "%d units of %d columns", r->cells, r->columns);
    r->ends = "END_DATA";
    take_table(r);
    if (!r->over)
        warn("%s: no END_DATA at its end: is the file cut?", s->name);
    scan_rest(s, "lines behind END_DATA");
}

/* ---- well logs, by the Canadian Well Logging Society's LAS ---- */

/* key - is the line of that word, as in `NULL.  -999.25 : what it is'?  Then
 * what is between the unit and the last colon; else 0. */
static char *key(const scan *s, const char *word, char **end)
{
    char *c = s->line + strspn(s->line, " \t"), *line = s->line;
    size_t n = strlen(word), k;

    for (k = 0; k < n && toupper((unsigned char)c[k]) == word[k];) k++;
    c += n + strspn(c + n, " \t");
    if (k < n || *c != '.') return 0;
    c += strcspn(c, " \t");
    c += strspn(c, " \t");
    *end = strrchr(line, ':');
    if (!*end || *end < c) *end = s->stop;
    while (*end > c && isspace((unsigned char)(*end)[-1])) (*end)--;
    return c;
}

void read_well(reader *r)
{
    scan *s = &r->s;
    char *at, *end, part = 'V', wraps = 0;
    double lacking = 0.0, version = 0.0;
    int k, lacks = 0;

    do {
        need_line(r);
        if (comment(s)) {
            s->blank++;
            continue;
        }
        s->head++;
        if (*s->line == '~') {
            part = (char)toupper((unsigned char)s->line[1]);
            continue;
        }
        at = s->line + strspn(s->line, " \t");
        if (part == 'C') trimmed(r, at, at + strcspn(at, ". \t"));
        at = key(s, "WRAP", &end);
        if (at) wraps = *at;
        at = key(s, "VERS", &end);
        if (at && !numbers(at, end, 1, &version))
            scan_fail(s, "VERS: not a number");
        at = key(s, "DLM", &end);
        if (at)
            r->d.separator = (char)(*at == 'C' ? ',' : *at == 'T' ? '\t' : ' ');
        at = key(s, "NULL", &end);
        if (!at) continue;
        lacks = 1;
        if (!numbers(at, end, 1, &lacking)) scan_fail(s, "NULL: not a number");
    } while (part != 'A');
    if (!(version >= 1.0) || !(version < 4.0) || !wraps)
        fail("%s: a well log's head has VERS, from 1 to 3, and WRAP", s->name);
    if (wraps != 'N' && wraps != 'n')
        fail("%s: is a wrapped well log, which is not read: write it with WRAP "
             "NO", s->name);
    if (!lacks)
        warn("%s: no NULL in its head: no number stands for none", s->name);
    for (k = 0; k < r->columns; k++) {
        r->column[k].lacks = lacks;
        r->column[k].lacking = lacking;
    }
    r->nowhere = "a well log without curves x, y, which is not read: write x, "
                 "y, z and values as CSV";
    take_table(r);
}
