/* read.c - reads points from the files that people have: see `tess -h'.
 *
 * A line is split into fields, numbers and words.  The first line that has
 * three numbers, or two of points in a plane, says what each column is: x, y,
 * z; a value; or, where it has a word, a label, which is skipped.  All further
 * lines must be like it: what is no point, or might be meant otherwise, is an
 * error that names the line.
 */
#include "driver.h"

#include <ctype.h>
#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE 8192   /* most characters of a line */
#define HEAD 512    /* characters by which a file that is no text is told */
#define BLOCK 65536 /* characters that are read at once */
#define SPILL 131072 /* places that are kept at once, if there are more */
#define READ ": lines of numbers, CSV, .xyz, .node, .off, .ply, .obj, .stl, " \
             ".npy and PDB are"
#define NUMPY "\223NUMPY" /* how a .npy file begins */

typedef struct field {
    char *text;
    int number; /* is it one?  With -skip a missing value counts as one */
    int missing, quoted;
    double x;
} field;

static points *to;
static FILE *file;
static char block[BLOCK + 1]; /* a part of the file, and '\0' */
static size_t filled, taken;  /* of it */
static double file_size;      /* in bytes; 0: not known */
static int unsure;            /* whether the first line is a point: rows */
static tess_int spilled;      /* places that are in the file of their own */
static double passed;         /* bytes before block */
static char line[LINE + 1];
static long line_number;
static field fields[COLUMNS];
static int many;                   /* fields */
static int decimals;               /* are commas between digits decimal? */
static int apart;                  /* not so: those are in quotes */
static char doubt[160];            /* why the line may have one, or "" */
static int open_end;               /* is its last character a separator? */
static char separator;             /* other than blanks; or 0 */
static char title[COLUMNS][TITLE]; /* of the columns, from a header */
static int titles;
static char suspect[160]; /* why, perhaps, no line is a point, or "" */
static long first_line; /* of the points; does it end with a separator? */
static int first_open;
static int axes;        /* coordinates of a point */
static int width;       /* columns of a line of points; and which they are: */
static int part[COLUMNS];
static long dropped, first_dropped; /* rows; the first one's line */
static long voided, misplaced;      /* by -nodata; of such a coordinate */
static int by;       /* the column of -by, or of names that are kept, or -1 */
static char *labels; /* those, one after the other */
static size_t labelled, labels_room;
static size_t *label; /* where that of each point begins */
static int counting; /* is the first column 0, 1, 2, ... or 1, 2, 3, ...? */
static double count_from;

/* packed - of a file that is no text: rows of so many numbers, or 0. */
static struct {
    int columns, big; /* is the most significant byte the first one? */
    int facets;       /* are they binary STL's corners? */
    char kind[COLUMNS]; /* as NumPy says it: f, i, u; of so many bytes: */
    int bytes[COLUMNS];
} packed;

/* What a column is: 0, 1, 2 a coordinate, LABEL, UNUSED, VALUE; or HOLLOW, a
 * label for want of something in the first line. */
#define LABEL 3
#define UNUSED 4
#define VALUE 5
#define HOLLOW 6

static void fail_line(const char *what)
{
    fail("%s, line %ld: %s", to->input, line_number, what);
}

/* fail_cell - the same for field k, which is no number. */
static void fail_cell(int k);

static void fail_empty(long at, int column)
{
    fail("%s, line %ld: column %d is empty, see -skip, which drops such lines",
         to->input, at, column);
}

/* ---------------------------------------------------------------- binary */

/* more - read on, behind what is not yet taken; 0 if nothing is left. */
static int more(void)
{
    filled -= taken;
    passed += (double)taken;
    memmove(block, block + taken, filled);
    taken = 0;
    filled += fread(block + filled, 1, BLOCK - filled, file);
    block[filled] = '\0';
    return filled > 0;
}

/* refuse_others - begin to read the file; leave if it is one of those that are
 * known not to be read, or not text. */
static void refuse_others(void)
{
    static const char *const other[][2] = {
        {"\037\213",
         "compressed by gzip; unpack it first: gunzip -c ... | tess"},
        {"BZh", "compressed by bzip2; unpack it first: bunzip2 -c ... | tess"},
        {"\3757zXZ", "compressed by xz; unpack it first: xz -dc ... | tess"},
        {"PK\003\004", "a zip archive; unpack it first: unzip -p ... | tess"},
        {"<?xml", "XML, as .vtu, which is not read" READ},
        {"<VTKFile", "VTK's, which is not read" READ},
        {"# vtk", "VTK's, which is not read" READ},
        {"$MeshFormat", "Gmsh's, which is not read" READ}};
    size_t k, head;

    more();
    head = filled < HEAD ? filled : HEAD;
    for (k = 0; k < sizeof other / sizeof other[0]; k++)
        if (head > strlen(other[k][0]) &&
            memcmp(block, other[k][0], strlen(other[k][0])) == 0)
            fail("%s: is %s", to->input, other[k][1]);
    /* next_line knows UTF-16, and some readers binary forms */
    if (!memchr(block, 0, head) || memcmp(block, "\377\376", 2) == 0 ||
        memcmp(block, "\376\377", 2) == 0 || memcmp(block, "ply", 3) == 0 ||
        memcmp(block, NUMPY, 6) == 0)
        return;
    packed.facets = ends_in(to->input, ".stl");
    if (!packed.facets)
        fail("%s: is not text (an archive, perhaps; binary STL is known by a "
             "name that ends in .stl)", to->input);
}

static int next_char(void)
{
    if (taken == filled && !more()) return EOF;
    return (unsigned char)block[taken++];
}

/* take_number - the next one of a packed file, *x; 0 at the end. */
static int take_number(char kind, int bytes, double *x)
{
    static const int one = 1;
    unsigned char byte[sizeof(double)]; /* as this machine has them */
    int little = *(const char *)&one, c, k;
    float narrow;

    for (k = 0; k < bytes; k++) {
        c = next_char();
        if (c == EOF) return 0;
        byte[packed.big == little ? bytes - 1 - k : k] = (unsigned char)c;
    }
    if (kind == 'f' && bytes == sizeof narrow) {
        memcpy(&narrow, byte, sizeof narrow);
        *x = (double)narrow;
    } else if (kind == 'f') {
        memcpy(x, byte, sizeof *x);
    } else {
        c = byte[little ? bytes - 1 : 0];
        *x = kind == 'i' && c > 127 ? c - 256 : c;
        for (k = 1; k < bytes; k++)
            *x = 256.0 * *x + byte[little ? bytes - 1 - k : k];
    }
    return 1;
}

/* packed_row - the next row of a packed file, as fields; its number is that of
 * the line.  Returns 0 at the end. */
static int packed_row(void)
{
    int k = line_number > 0 ? 14 : 12; /* behind a facet, and before the next */

    for (; packed.facets && line_number % 3 == 0 && k > 0; k--) next_char();
    line[0] = '\0';
    for (k = 0; k < packed.columns; k++) {
        if (!take_number(packed.kind[k], packed.bytes[k], &fields[k].x))
            return 0;
        fields[k].text = line;
        fields[k].number = 1;
        fields[k].quoted = 0;
        fields[k].missing = to->skip && fields[k].x != fields[k].x;
    }
    many = packed.columns;
    line_number++;
    return 1;
}

/* ---------------------------------------------------------------- fields */

static int blank(int c)
{
    return c == ' ' || c == '\t' || c == '\f' || c == '\v';
}

static int digit(int c)
{
    return isdigit((unsigned char)c);
}

/* comment - does a comment begin at s?  # anywhere; % ! and two slashes where
 * a line or, behind a number and a blank, a field does: in `T (%)' none. */
static int comment(const char *s)
{
    const char *before = s;

    if (*s == '#') return 1;
    if (*s != '%' && *s != '!' && !(*s == '/' && s[1] == '/')) return 0;
    while (before > line && blank(before[-1])) before--;
    return before == line ||
           (before < s && (digit(before[-1]) || before[-1] == '.'));
}

/* next_line - read the next line that holds something into line, without its
 * comment.  Ends of line: LF, CR LF, CR.  Returns 0 at the end. */
static int next_line(void)
{
    int c, len, quoted, i;

    do {
        len = 0;
        line_number++;
        while ((c = next_char()) != EOF && c != '\n' && c != '\r') {
            /* strtod would take a NUL for the end of the line */
            if (len < LINE) line[len++] = c ? (char)c : '?';
            /* a byte order mark */
            if (line_number == 1 && len == 3 &&
                strncmp(line, "\357\273\277", 3) == 0)
                len = 0;
            if (line_number == 1 && len == 2 &&
                (strncmp(line, "\377\376", 2) == 0 ||
                 strncmp(line, "\376\377", 2) == 0))
                fail("%s: is UTF-16; save it as UTF-8 or ASCII", to->input);
        }
        if (c == '\r' && (taken < filled || more()) && block[taken] == '\n')
            taken++;
        line[len] = '\0';
        for (i = quoted = 0; i < len && (quoted || !comment(line + i)); i++)
            if (line[i] == '"') quoted = !quoted;
        if (len == LINE && i == len)
            fail("%s, line %ld: longer than %d characters", to->input,
                 line_number, LINE - 1);
        for (len = i; i > 0 && blank(line[i - 1]); i--) continue;
        /* (tabs at the end: empty cells) */
        while (len > i && (line[len - 1] != '\t' || !to->skip)) len--;
        line[len] = '\0';
        if (i > 0) return 1;
    } while (c != EOF);
    if (ferror(file)) fail("%s: %s", to->input, strerror(errno));
    return 0;
}

/* point_number - the number at s, as C or Fortran writes it: 1.34D-01, and
 * 1.34-101 where three digits leave no room for the letter.  *end is s if there
 * is none. */
static double point_number(const char *s, char **end)
{
    double x = strtod(s, end);
    const char *e = *end;
    char text[80], *stop;
    size_t mantissa = (size_t)(e - s), exponent;

    if (mantissa == 0 || mantissa > 40 || !(digit(e[-1]) || e[-1] == '.'))
        return x;
    if (*e == 'd' || *e == 'D')
        e++;
    else if ((*e != '+' && *e != '-') || !memchr(s, '.', mantissa))
        return x;
    exponent = *e == '+' || *e == '-';
    if (!digit(e[exponent])) return x;
    while (digit(e[exponent]) && exponent < 20) exponent++;
    sprintf(text, "%.*se%.*s", (int)mantissa, s, (int)exponent, e);
    x = strtod(text, &stop);
    *end = *stop ? (char *)s : (char *)e + exponent;
    return x;
}

/* separates - is the comma at s, in no quotes, one between columns? */
static int separates(const char *s)
{
    if (!decimals || apart || !digit(s[1])) return 1;
    return s > line && !digit(s[-1]) && !blank(s[-1]) && !strchr("+-;", s[-1]);
}

/* number - the same, or with decimal commas a number that may have one, and has
 * no point. */
static double number(const char *s, char **end)
{
    char text[80], *stop;
    size_t length = 0;
    int quoted = s > line && s[-1] == '"';
    double x;

    if (!decimals) return point_number(s, end);
    *end = (char *)s;
    while (s[length] && !strchr(" \t;\"", s[length]) &&
           (s[length] != ',' || quoted || !separates(s + length)))
        length++;
    if (length >= sizeof text || memchr(s, '.', length)) return 0.0;
    sprintf(text, "%.*s", (int)length, s);
    stop = strchr(text, ',');
    if (stop) *stop = '.';
    x = point_number(text, &stop);
    *end += stop - text;
    return x;
}

/* begins_number - as far as its first digit, does s? */
static int begins_number(const char *s)
{
    s += *s == '+' || *s == '-';
    s += *s == '.';
    return digit(*s);
}

/* hint - what to do about a text that is a number but for its commas; or its
 * points, if commas are decimal.  0 for any other.  Points may be a date's. */
static const char *hint(const char *text, int quoted)
{
    static const char figures[] = "0123456789";
    const char *s = text + (*text == '+' || *text == '-'), *first = s;
    const char *end = s + strspn(s, "0123456789,.");
    int signs = 0, commas = 0, behind = 0, threes = *s != '0';
    char sign = decimals ? '.' : ',';

    if (!strpbrk(text, figures) ||
        (*end && (!strchr("eEdD", *end) || !begins_number(end + 1))))
        return 0;
    for (; s < end; s++) {
        if (digit(*s)) continue;
        commas += *s == ',';
        behind += signs > 0 && *s != sign;
        if (*s != sign) continue;
        threes = threes && strspn(s + 1, figures) == 3 &&
                 (signs > 0 || (s > first && s - first < 4));
        signs++;
    }
    if (decimals && (signs == 1 || (signs > 1 && threes)))
        return " (with -decimal , numbers have no points)";
    if (decimals)
        return signs == 0 && commas > 1
                   ? " (with -decimal , commas between digits are decimal)"
                   : 0;
    if (signs > 0 && threes && (signs > 1 || behind > 0))
        return " (commas between thousands must go)";
    if (signs == 1 && behind == 0)
        return threes && quoted
                   ? " (a comma between thousands must go; see also -decimal)"
                   : " (a decimal comma?  -decimal , reads it)";
    return 0;
}

/* decimal_comma - may the line, not yet split, have one where nothing is in
 * quotes, and commas separate if they are none?  One between digits, where
 * something else separates, too. */
static int decimal_comma(void)
{
    const char *s;
    int quoted = 0, glued = 0, spaced = 0, other = 0, point = 0;

    for (s = line; *s; s++) {
        if (*s == '"') quoted = !quoted;
        if (quoted) continue;
        if (*s == ';') return 0;
        if (*s == '.') point = 1;
        if (*s == '\t') other = 1;
        if (s == line) continue;
        if (*s == ',' && digit(s[-1])) {
            glued |= digit(s[1]);
            spaced |= blank(s[1]);
        }
        if (blank(*s) && (digit(s[-1]) || s[-1] == '.'))
            other |= begins_number(s + strspn(s, " \t"));
    }
    return glued && (other || (spaced && !point));
}

/* refuse - leave if the line may have a decimal comma. */
static void refuse(void)
{
    if (doubt[0]) fail_line(doubt);
}

/* missing - is the text what files have in place of a number that is not
 * there? */
static int missing(const char *text)
{
    static const char *const none[] = {"",    "-",    "--",   "na",
                                       "n/a", "null", "none", "nan"};
    size_t k, i;

    for (k = 0; k < sizeof none / sizeof none[0]; k++) {
        for (i = 0; text[i] && tolower((unsigned char)text[i]) == none[k][i];)
            i++;
        if (text[i] == none[k][i]) return 1;
    }
    return 0;
}

/* mark_of - what separates the line's fields: a semicolon; or else a comma, or
 * a tab, of which the tab comes first if commas are decimal; or 0, blanks. */
static char mark_of(void)
{
    char *s, *end, mark = 0;
    int quoted = 0;

    for (s = line; *s; s++) {
        if (*s == '"') quoted = !quoted;
        if (*s == '"' && quoted && decimals) {
            number(s + 1, &end);
            if (*end == '"' && memchr(s, ',', (size_t)(end - s)) &&
                (end[1] == ',' || (s > line && s[-1] == ',')))
                apart = 1;
        }
        if (quoted) continue;
        if (*s == ';' || (*s == '\t' && (!mark || (decimals && mark == ','))))
            mark = *s;
        if (*s == ',' && separates(s) && mark != ';' &&
            (mark != '\t' || !decimals))
            mark = ',';
    }
    return mark;
}

/* ends - does the separator stand at s? */
static int ends(const char *s, char mark)
{
    return *s && *s == mark && (mark != ',' || separates(s));
}

/* cut - the line's fields.  Blanks separate behind a number always, unless the
 * cell goes on with a unit; behind a word if there is no other separator.  With
 * -skip, which looks for empty cells, each tab separates. */
static void cut(void)
{
    char *s = line, *end, *after, mark = mark_of();
    int quoted;

    separator = mark;
    open_end = 0;
    for (many = 0;; many++) {
        while (blank(*s) && !(to->skip && *s == mark)) s++;
        if (!*s &&
            !(open_end && many + 1 == (width > 0 ? width : titles)))
            return;
        if (many == COLUMNS)
            fail("%s, line %ld: more than %d columns", to->input, line_number,
                 COLUMNS);
        quoted = *s == '"';
        s += quoted;
        fields[many].text = s;
        fields[many].quoted = quoted;
        end = s;
        fields[many].x = ends(s, mark) ? 0.0 : number(s, &end);
        if (quoted) {
            while (blank(*end)) end++;
            fields[many].number = end > s && *end == '"';
            while (*s && *s != '"') s++;
            end = s + (*s != '\0');
            *s = '\0';
            s = end;
            while (*s && !ends(s, mark) && !blank(*s)) s++;
            end = s;
        } else {
            for (after = end; blank(*after) && !ends(after, mark);) after++;
            fields[many].number =
                end > s && (!*after || ends(after, mark) ||
                            (after > end &&
                             (!mark || (many > 0 && !open_end) ||
                              *after == '"' || *after == '-' ||
                              begins_number(after))));
            if (!fields[many].number)
                for (end = s; *end && !ends(end, mark);) {
                    if (blank(*end) && !mark) break;
                    end++;
                }
            s = end;
        }
        while (blank(*s) && !(to->skip && *s == mark)) s++;
        open_end = ends(s, mark);
        s += open_end;
        if (!quoted) {
            while (end > fields[many].text && blank(end[-1])) end--;
            *end = '\0';
        }
        fields[many].missing = to->skip && missing(fields[many].text);
        if (fields[many].missing) fields[many].number = 1;
    }
}

/* split - the same; and doubt, if the line has numbers once commas are taken
 * for decimal ones. */
static void split(void)
{
    static char copy[LINE + 1];
    const char *why = 0;
    int k;

    doubt[0] = '\0';
    if (!decimals && decimal_comma()) {
        strcpy(copy, line);
        decimals = 1;
        cut();
        decimals = apart = 0;
        for (k = 0; k < many && !why; k++)
            if ((why = hint(fields[k].text, 0)) != 0)
                sprintf(doubt, "column %d is not a number: %.20s%s", k + 1,
                        fields[k].text, why);
        strcpy(line, copy);
    }
    cut();
}

/* numbers - how many of the fields are numbers. */
static int numbers(void)
{
    int k, sum = 0;

    for (k = 0; k < many; k++) sum += fields[k].number && !fields[k].missing;
    return sum;
}

/* plain_word - the end of a word of letters, digits and - + . _ : at s. */
static char *plain_word(char *s)
{
    while (isalnum((unsigned char)*s) || (*s && strchr("-+._:", *s))) s++;
    return s;
}

/* quick - take the next line, if it is plain: as many numbers, and words that
 * are skipped, as the first one has, with one comma or semicolon between two,
 * or blanks.  Returns 0 and takes nothing if it is not, or might not be.  Most
 * lines of most files are, and next_line and split take twice the time. */
static int quick(void)
{
    char *s, *end, *stop, mark = 0;
    int k, glued = 0, spaced = 0, tabs = 0, blanks = 0, words = 0;

    if (decimals || by >= 0) return 0;
    if (filled - taken < LINE) more();
    s = block + taken;
    stop = (char *)memchr(
        s, '\n', filled - taken < LINE ? filled - taken : LINE);
    if (!stop) return 0;
    for (k = 0; k < width; k++) {
        if (k > 0 && mark != ' ') {
            if (*s++ != mark) return 0;
            glued |= *s != ' ';
            spaced |= *s == ' ';
        }
        for (; *s == ' ' || (*s == '\t' && !to->skip); s++) {
            tabs |= *s == '\t';
            blanks |= *s == ' ';
        }
        end = s;
        fields[k].number = part[k] != LABEL && part[k] != UNUSED;
        fields[k].missing = 0;
        words |= !fields[k].number;
        if (!fields[k].number)
            end = plain_word(s);
        else if (digit(*s) || *s == '-' || *s == '.')
            fields[k].x = strtod(s, &end);
        if (end == s) return 0;
        s = end;
        if (k == 0) mark = *s == ',' || *s == ';' ? *s : ' ';
        if (mark == ' ' && !blank(*s) && *s != '\r' && *s != '\n') return 0;
    }
    while (*s == ' ' || (*s == '\t' && !to->skip)) s++;
    s += *s == '\r';
    /* (1,5, 2,5 and 1,5 tab 2,5 have decimal commas; a word, where there are
     * tabs, blanks in it) */
    if (s != stop || (glued && spaced) || (tabs && mark != ' ') ||
        (tabs && blanks && words))
        return 0;
    taken = (size_t)(stop + 1 - block);
    line_number++;
    many = width;
    open_end = 0;
    doubt[0] = '\0';
    return 1;
}

static void fail_cell(int k)
{
    const char *why = hint(fields[k].text, fields[k].quoted);
    int named = titles == many && title[k][0];

    if (!why)
        why = missing(fields[k].text) ? " (-skip drops such lines)" : "";
    fail("%s, line %ld: column %d%s%s%s is not a number: %.30s%s", to->input,
         line_number, k + 1, named ? ", " : "", named ? title[k] : "",
         named ? "," : "", fields[k].text, why);
}

/* void_value - is x what stands for a missing value, by -nodata? */
static int void_value(double x)
{
    int k;

    for (k = 0; k < to->voids && x != to->nodata[k]; k++) continue;
    return k < to->voids;
}

/* lacking - is a number missing in a column that is asked for? */
static int lacking(void)
{
    int k;

    for (k = 0; k < many; k++) {
        if (fields[k].missing && (width != many || part[k] < LABEL ||
                                  part[k] == VALUE || k == by))
            return 1;
        if (width != many || part[k] != VALUE || !fields[k].number ||
            !void_value(fields[k].x))
            continue;
        voided++;
        return 1;
    }
    return 0;
}

/* drop - leave the line out, by -skip or -nodata. */
static void drop(void)
{
    if (dropped++ == 0) first_dropped = line_number;
}

/* count - is field k a whole number that may be one of points? */
static int count(int k)
{
    return fields[k].number && fields[k].x >= 0.0 && fields[k].x <= 1e15 &&
           strspn(fields[k].text, "0123456789") == strlen(fields[k].text);
}

/* word - is field k this one? */
static int word(int k, const char *text)
{
    return k < many && strcmp(fields[k].text, text) == 0;
}

/* ---------------------------------------------------------------- points */

/* rooms - for so many points, and for so many values. */
static void rooms(double most, double values)
{
    to->p = (tess_real *)more_space(to->p, 3.0 * most, sizeof *to->p);
    to->line = (long *)more_space(to->line, most, sizeof *to->line);
    to->value = (double *)more_space(to->value, values, sizeof *to->value);
    to->room = most;
    to->values = values;
}

/* spill - places, of which there are many, into a file of their own. */
static void spill(void)
{
    size_t here = (size_t)(to->n - spilled);

    if (!to->scratch) to->scratch = tmpfile();
    if (!to->scratch || fwrite(to->p, 3 * sizeof *to->p, here, to->scratch) !=
                            here)
        fail("%s: no room for a temporary file", to->input);
    spilled = to->n;
}

void next_places(points *a, int first)
{
    if (!a->scratch) return;
    if (first) rewind(a->scratch);
    a->n = (tess_int)fread(a->p, 3 * sizeof *a->p, SPILL, a->scratch);
    if (a->n == 0) fail("%s: a temporary file cannot be read", a->input);
}

/* add_point - one more: its coordinates; its values are set by the caller. */
static void add_point(const double *x)
{
    double n, values;
    tess_int at;
    int k;

    if (to->n >= TESS_INT_MOST / 5)
        too_small("%s, line %ld: more points than a tess_int of %d bytes can "
                  "number; rebuild with a larger -DTESS_INT=...",
                  to->input, line_number, (int)sizeof(tess_int));
    if (to->bare && !unsure && to->n - spilled >= SPILL) spill();
    at = to->n - spilled;
    n = (double)at + 1.0;
    values = to->bare ? 0.0 : n * (double)to->columns;
    if (n > to->room || values > to->values)
        rooms(n > to->room ? 2.0 * n : to->room,
              values > to->values ? 2.0 * values : to->values);
    for (k = 0; k < 3; k++) {
        to->p[3 * at + k] = (tess_real)x[k];
        if (to->bare && !(fabs((double)to->p[3 * at + k]) <= DBL_MAX))
            fail_line("a coordinate is not finite");
    }
    to->line[at] = line_number;
    to->n++;
    if (to->n % 4096 == 0)
        progress("reading", passed + (double)taken, file_size);
}

/* add_group - the label of the last point's group, or its name. */
static void add_group(const char *text)
{
    tess_int i = to->n - 1;
    size_t length = strlen(text) + 1;

    /* (where i is a power of two, or 0) */
    if ((i & (i - 1)) == 0)
        label = (size_t *)more_space(label, 2.0 * (double)i + 1.0,
                                     sizeof *label);
    if (i > 0 && strcmp(labels + label[i - 1], text) == 0) {
        label[i] = label[i - 1];
        return;
    }
    if (labelled + length > labels_room) {
        labels_room = 2 * (labels_room + length);
        labels = (char *)more_space(labels, (double)labels_room, 1);
    }
    label[i] = labelled;
    strcpy(labels + labelled, text);
    labelled += length;
}

/* earlier - for qsort: by labels. */
static int earlier(const void *a, const void *b)
{
    return strcmp(labels + label[*(const tess_int *)a],
                  labels + label[*(const tess_int *)b]);
}

/* number_groups - in the order of their labels, from 0 on. */
static void number_groups(void)
{
    tess_int *list = (tess_int *)space((double)to->n, sizeof *list), i, g = 0;

    to->group = (tess_int *)space((double)to->n, sizeof *to->group);
    for (i = 0; i < to->n; i++) list[i] = i;
    qsort(list, (size_t)to->n, sizeof *list, earlier);
    for (i = 0; i < to->n; i++) {
        g += i > 0 && earlier(list + i - 1, list + i) != 0;
        to->group[list[i]] = g;
    }
    free(list);
    free(labels);
    free(label);
}

/* axis - 0, 1, 2 for a column named x, y, z, else -1. */
static int axis(const char *name)
{
    int c = tolower((unsigned char)name[0]);

    if (strncmp(name, "Points:", 7) == 0 && name[7] >= '0' && name[7] < '3' &&
        !name[8])
        return name[7] - '0';
    if (c < 'x' || c > 'z') return -1;
    for (name++; blank(*name); name++) continue;
    return *name && *name != '(' && *name != '[' ? -1 : c - 'x';
}

/* header - keep the line's fields as the names of columns, unless those kept
 * name x, y, z, or these are their units. */
static void header(void)
{
    int k, found = 0;

    for (k = 0; k < titles; k++)
        if (axis(title[k]) >= 0) found++;
    if (found >= 3 || titles == many) return;
    titles = many;
    for (k = 0; k < many; k++)
        sprintf(title[k], "%.*s", TITLE - 1, fields[k].text);
}

/* called - the column of that name, its unit left out; else the first one that
 * differs in small and capital letters alone; many if there is none. */
static int called(const char *name, size_t length)
{
    const char *c;
    size_t i;
    int k, fold;

    for (fold = 0; fold < 2; fold++)
        for (k = 0; k < titles; k++) {
            c = title[k];
            for (i = 0; i < length; i++)
                if (c[i] != name[i] &&
                    (!fold || tolower((unsigned char)c[i]) !=
                                  tolower((unsigned char)name[i])))
                    break;
            if (i < length) continue;
            while (blank(c[i])) i++;
            if (!c[i] || c[i] == '(' || c[i] == '[') return k;
        }
    return many;
}

/* option - that names columns. */
static const char *option(void)
{
    return to->bare ? "-qcols" : "-cols";
}

/* find - the column that is named, by number or by name; for that option. */
static int find(const char *s, size_t length, const char *of)
{
    int k = many;

    if (strspn(s, "0123456789") < length)
        k = called(s, length);
    else if (length > 0 && length < 5 && *s != '0')
        k = atoi(s) - 1;
    if (k >= many)
        fail("%s, line %ld: %s: no column %.*s among %d%s", to->input,
             line_number, of, (int)length, s, many,
             titles > 0 ? "" : ", and no line of names before them");
    return k;
}

/* choose - the columns that -cols names: x, y, z, then values.  Returns how
 * many. */
static int choose(int *at)
{
    const char *s = to->cols;
    size_t length;
    int found = 0, k;

    for (;;) {
        length = strcspn(s, ",");
        k = find(s, length, option());
        if (!fields[k].number && !fields[k].text[0])
            fail_empty(line_number, k + 1);
        if (!fields[k].number) fail_cell(k);
        if (part[k] != UNUSED || found == COLUMNS)
            fail("%s: column %.*s twice", option(), (int)length, s);
        part[k] = found < axes ? found : VALUE;
        at[found++] = k;
        s += length;
        if (!*s++) return found;
    }
}

/* least - the numbers of a line that may be a point's. */
static int least(void)
{
    return to->axes == 2 || (to->axes == 0 && to->bare && many == 2) ? 2 : 3;
}

/* too_few - numbers for a point. */
static void too_few(void)
{
    fail_line(least() == 2 ? "fewer than two numbers"
              : to->bare || numbers() != 2
                  ? "fewer than three numbers"
                  : "fewer than three numbers; for points in a plane, x, y and "
                    "values, see -plane");
}

/* columns - what the columns of this line are, and with it of all others. */
static void columns(void)
{
    int at[COLUMNS], k, found = 0, others = 0;

    axes = least();

    width = many;
    first_line = line_number;
    first_open = open_end;
    to->columns = 0;
    if (titles > 1 && titles != many)
        warn("%s, line %ld: %d columns, but %d names before them, which are "
             "not used",
             to->input, line_number, many, titles);
    if (titles != many) titles = 0;
    at[0] = at[1] = at[2] = -1;
    for (k = 0; k < many; k++) part[k] = UNUSED;
    by = to->by ? find(to->by, strlen(to->by), "-by") : -1;
    if (to->cols) found = choose(at);
    for (k = 0; k < many; k++)
        others += fields[k].number && part[k] == UNUSED && k != by;
    if (to->axes == 0 && !to->bare && found == 3 && others == 0) {
        /* the third one is all that can be a value */
        axes = 2;
        part[at[2]] = VALUE;
    }
    for (k = 0; k < titles && !to->cols; k++) {
        int a = axis(title[k]);

        if (a < 0 || a >= axes || at[a] >= 0) continue;
        if (!fields[k].text[0] && !fields[k].number)
            fail_empty(line_number, k + 1);
        if (!fields[k].number && begins_number(fields[k].text)) fail_cell(k);
        if (!fields[k].number) continue;
        at[a] = k;
        found++;
    }
    if (found < axes)
        for (k = found = 0; k < many && found < axes; k++)
            if (fields[k].number && k != by) at[found++] = k;
    if (found < axes) too_few();
    for (k = 0; k < axes; k++) {
        part[at[k]] = k;
        if (titles > 0 && title[at[k]][0]) strcpy(to->axis[k], title[at[k]]);
    }
    for (k = 0; k < many; k++) {
        if (!fields[k].number) part[k] = fields[k].text[0] ? LABEL : HOLLOW;
        if (k == by && part[k] >= LABEL && part[k] != VALUE) part[k] = UNUSED;
        else if (part[k] == UNUSED && found == axes && !to->bare)
            part[k] = VALUE;
        if (part[k] != VALUE) continue;
        if (titles > 0 && title[k][0])
            strcpy(to->name[to->columns], title[k]);
        else
            sprintf(to->name[to->columns],
                    to->columns > 0 ? "value%d" : "value", to->columns + 1);
        to->columns++;
    }
    if (!to->named) return;
    for (k = many - 1; k >= 0; k--)
        if (part[k] == LABEL && (by < 0 || titles == 0 ||
                                 strcmp(title[by], "species") != 0))
            by = k;
    to->labelled[0] = '\0';
    if (by >= 0)
        strcpy(to->labelled, titles > 0 && title[by][0] ? title[by] : "name");
}

/* like - has the line the form of the first one? */
static int like(void)
{
    int k;

    if (many != width) return 0;
    for (k = 0; k < many; k++)
        if (part[k] != UNUSED && !fields[k].missing &&
            (part[k] == LABEL || part[k] == HOLLOW) == fields[k].number)
            return 0;
    return 1;
}

/* row - the line, split, is a point. */
static void row(void)
{
    double x[3], *v;
    int k;

    refuse();
    if (many == width + 1 && first_open) fail_empty(first_line, many);
    if (many != width)
        fail("%s, line %ld: %d columns, but line %ld has %d%s", to->input,
             line_number, many, first_line, width,
             separator == '\t' ? " (empty cells? see -skip)" : "");
    if (part[0] != 0 ||
        fields[0].x != count_from + (double)to->n + (double)dropped)
        counting = 0;
    if (lacking()) {
        drop();
        return;
    }
    if (by >= 0 && packed.columns > 0)
        sprintf(fields[by].text, "%.17g", fields[by].x);
    if (to->by && !fields[by].text[0]) fail_empty(line_number, by + 1);
    for (k = 0; k < many; k++) {
        if (part[k] == HOLLOW && fields[k].number)
            fail_empty(first_line, k + 1);
        if (part[k] == LABEL || part[k] == HOLLOW || part[k] == UNUSED)
            continue;
        if (!fields[k].number && !fields[k].text[0])
            fail_empty(line_number, k + 1);
        if (!fields[k].number) fail_cell(k);
        if (part[k] >= LABEL) continue;
        x[part[k]] = fields[k].x;
        misplaced += void_value(fields[k].x);
    }
    if (axes == 2) x[2] = 0.0;
    add_point(x);
    if (by >= 0) add_group(fields[by].text);
    v = to->value + to->columns * (long)(to->n - 1);
    for (k = 0; k < many; k++)
        if (part[k] == VALUE) *v++ = fields[k].x;
}

/* shape - the first point's line: what it skips is said, from that column on;
 * what is empty there at the end, when it is known to be so in all lines. */
static void shape(int from)
{
    int k;

    refuse();
    columns();
    count_from = fields[0].x;
    counting = count(0) && count_from <= 1.0;
    for (k = from; k < many && !to->cols; k++)
        if (part[k] == LABEL && hint(fields[k].text, fields[k].quoted))
            fail_cell(k);
        else if (part[k] == LABEL && k != by)
            warn("%s: column %d (%.20s) is not a number: skipped", to->input,
                 k + 1, fields[k].text);
    /* 0,13,0,84,0,5: to tell is beyond a program */
    for (k = 0; k < many && count(k); k++) continue;
    if (many >= 6 && many % 2 == 0 && k == many && separator == ',')
        warn("%s: whole numbers in %d columns; if commas are decimal signs, "
             "put something else between columns, and see -decimal",
             to->input, many);
}

/* rows - read the points from the current line, split, to the end; or want of
 * them.  perhaps: the first line may be no point but a comment, and is if the
 * others are of another form, or there is one too many.  rest: what follows
 * is nothing that a word should be lost about. */
static void rows(double want, int perhaps, int rest)
{
    tess_int i;
    long k;

    if (want == 0.0) fail("%s: no points", to->input);
    unsure = perhaps;
    shape(0);
    for (;;) {
        if (unsure && to->n + dropped == 1 && !like()) {
            unsure = 0;
            to->n = 0;
            dropped = 0;
            shape(0);
        }
        row();
        if (want >= 0.0 && (double)to->n + (double)dropped == want &&
            !unsure)
            break;
        if (packed.columns > 0) {
            if (!packed_row()) break;
        } else if (unsure || !quick()) {
            if (!next_line()) break;
            split();
        }
        if (unsure && (double)to->n + (double)dropped == want) {
            /* not so, if all points are there already */
            unsure = 0;
            if (!like()) break;
            if (dropped > 0 && first_dropped == first_line) {
                dropped--;
                row();
                break;
            }
            for (i = 3; i < 3 * to->n; i++) to->p[i - 3] = to->p[i];
            for (k = 0; k < to->columns * (long)(to->n - 1); k++)
                to->value[k] = to->value[k + to->columns];
            for (i = 1; i < to->n; i++) to->line[i - 1] = to->line[i];
            for (i = 1; i < to->n && by >= 0; i++) label[i - 1] = label[i];
            to->n--;
            row();
            break;
        }
    }
    if (want >= 0.0 && (double)to->n + (double)dropped < want)
        fail("%s: ends after %ld of %.0f points", to->input,
             (long)to->n + dropped, want);
    for (k = 0; k < width && !to->cols; k++)
        if (part[k] == HOLLOW)
            warn("%s: column %ld (empty) is not a number: skipped", to->input,
                 k + 1);
    if (!rest && want >= 0.0 && next_line())
        warn("%s, line %ld: more than the %.0f points announced: the rest is "
             "not read",
             to->input, line_number, want);
}

static void need_line(void)
{
    if (!next_line())
        fail("%s: ends before the first point%s", to->input, suspect);
    split();
}

/* packed_rows - as rows, of a packed file, from where it is read. */
static void packed_rows(double want)
{
    line_number = 0;
    separator = '\0';
    open_end = 0;
    doubt[0] = '\0';
    if (want > 0.0 && !packed_row())
        fail("%s: ends before the first point", to->input);
    rows(want, 0, 1);
}

/* suspects - of a line that is none of a point: leave if it seems to be one but
 * for a cell; and keep in mind what else begins as a number. */
static void suspects(void)
{
    const char *why;
    int named = titles == many && separator && numbers() > 0;
    int k, bad = -1, found = numbers(), strange = 0, begun = 0;

    for (k = 0; k < many; k++) {
        if (fields[k].number || !fields[k].text[0]) continue;
        why = hint(fields[k].text, fields[k].quoted);
        /* (with -decimal , one cell, where commas should separate) */
        strange += why ? (many == 1 ? 3 : 1) : 0;
        begun += begins_number(fields[k].text);
        if (begins_number(fields[k].text) && !suspect[0])
            sprintf(suspect, "; line %ld: column %d is not a number: %.30s%s",
                    line_number, k + 1, fields[k].text, why ? why : "");
        if (bad < 0 && (why || begins_number(fields[k].text) ||
                        (named && axis(title[k]) >= 0)))
            bad = k;
    }
    if (bad >= 0 && (named || found + strange >= 3 ||
                     (found > 1 && found + begun >= 3)))
        fail_cell(bad);
    if (found > 1 && titles != many)
        warn("%s, line %ld: is taken for names, or a comment, not for a point",
             to->input, line_number);
}

/* after - what is behind `key=' in the line, and behind a quote or bracket
 * there; 0 if it has none. */
static const char *after(const char *key)
{
    size_t length = strlen(key);
    const char *s;

    for (s = line; (s = strstr(s, key)) != 0; s++)
        if ((s == line || blank(s[-1])) && s[length] == '=') {
            s += length + 1;
            return s + (*s && strchr("\"'{[", *s) != 0);
        }
    return 0;
}

/* take_numbers - that many, with blanks, commas or brackets between them. */
static void take_numbers(const char *s, int want, double *x, const char *name)
{
    char *end;
    int k;

    for (k = 0; k < want; k++, s = end) {
        while (*s && strchr(" \t,[]", *s)) s++;
        x[k] = strtod(s, &end);
        if (end == s)
            fail("%s, line %ld: %s needs %d numbers", to->input, line_number,
                 name, want);
    }
}

/* lattice - the box that these vectors span from the origin. */
static void lattice(double v[9], const double *origin)
{
    double side;
    int along, across, k, l;

    to->lattice = RIGHT;
    for (k = 0; k < 12; k++) to->cell[k] = k < 9 ? v[k] : origin[k - 9];
    for (k = 0; k < 3; k++) {
        to->ways[k] = 1;
        side = 0.0;
        for (along = across = l = 0; l < 3; l++) {
            along += v[3 * l + k] != 0.0;
            across += v[3 * k + l] != 0.0;
            side += v[3 * l + k];
        }
        if (along != 1 || across != 1) to->lattice = SKEW;
        to->box[2 * k] = origin[k] + (side < 0.0 ? side : 0.0);
        to->box[2 * k + 1] = origin[k] + (side > 0.0 ? side : 0.0);
        if (!(to->box[2 * k] < to->box[2 * k + 1])) to->lattice = SKEW;
    }
}

/* properties - the columns that an extended .xyz file says it has, such as
 * species:S:1:pos:R:3, are their titles. */
static void properties(const char *s)
{
    size_t length;
    int many_of, k;

    for (titles = 0;; s++) {
        length = strcspn(s, ":");
        many_of = s[length] && s[length + 1] && s[length + 2] == ':'
                      ? atoi(s + length + 3)
                      : 0;
        if (length == 0 || many_of < 1 || titles + many_of > COLUMNS)
            fail_line("Properties are not as species:S:1:pos:R:3");
        for (k = 0; k < many_of; k++, titles++)
            if (length == 3 && many_of == 3 && strncmp(s, "pos", 3) == 0)
                sprintf(title[titles], "%c", 'x' + k);
            else
                sprintf(title[titles], many_of > 1 ? "%.*s%d" : "%.*s",
                        (int)(length < TITLE - 4 ? length : TITLE - 4), s,
                        k + 1);
        s += length + 3;
        while (digit(*s)) s++;
        if (*s != ':') return;
    }
}

/* extended - is the line, not yet split, that of an extended .xyz file?  Then
 * its box and columns are taken. */
static int extended(void)
{
    const char *vectors = after("Lattice"), *from = after("Origin");
    const char *columns_of = after("Properties"), *pbc = after("pbc");
    const char *next, *end;
    double v[9], origin[3];
    int k;

    origin[0] = origin[1] = origin[2] = 0.0;
    if (from && vectors) take_numbers(from, 3, origin, "Origin");
    if (vectors) {
        take_numbers(vectors, 9, v, "Lattice");
        lattice(v, origin);
        /* "T T F", or T,T,0, or F; the last one is for all that follow */
        end = pbc ? pbc + strcspn(pbc, pbc[-1] == '=' ? " \t" : "\"'}]") : 0;
        for (k = 0; k < 3 && pbc; k++) {
            to->ways[k] = !*pbc || !strchr("Ff0", *pbc);
            next = pbc + strcspn(pbc, " \t,");
            next += strspn(next, " \t,");
            if (next < end) pbc = next;
        }
    }
    if (columns_of) properties(columns_of);
    return vectors || columns_of;
}

/* read_text - lines of numbers; a header or a count before them, or both. */
static void read_text(void)
{
    double want = -1.0, other;
    long first = line_number;
    int perhaps = 0, named, words, hollow, at[3], k;
    const char *plane = "";

    refuse();
    if (least() == 3 && many == 2 && count(0) && count(1) &&
        (fields[0].x == 3.0 || fields[1].x == 3.0)) {
        /* Qhull's dimension and number, in any order */
        want = fields[fields[0].x == 3.0].x;
        need_line();
    } else if (count(0) &&
               (many == 1 || (word(1, "") && numbers() < 2) ||
                (!fields[1].number && !separator &&
                 numbers() < (word(1, "rbox") ? many : least())))) {
        want = fields[0].x;
        if (!next_line()) fail("%s: ends before the first point", to->input);
        named = line_number == first + 1 && extended();
        if (named)
            need_line();
        else
            split();
        if (line_number == first + 1 && numbers() >= least())
            perhaps = 1;
        else if (line_number == first + 1) {
            other = many == 1 && count(0) ? fields[0].x : -1.0;
            need_line();
            /* Qhull, unless it is a file of 3 atoms */
            if (other >= 0.0 && fields[0].number)
                want = want == (double)least() ? other : want;
        }
    }
    while (numbers() < least()) {
        refuse();
        suspects();
        if (numbers() == many) too_few();
        for (k = words = 0; k < many; k++) words += !fields[k].number;
        for (k = hollow = 0; k < many; k++)
            hollow += !fields[k].number && !fields[k].text[0];
        if (words == hollow && many >= 3 && numbers() > 0)
            for (k = 0; k < many; k++)
                if (!fields[k].number) fail_empty(line_number, k + 1);
        /* no names, but a row from which numbers are missing */
        if (words == 0 || (titles == many && numbers() > 0 && lacking()))
            drop();
        else
            header();
        need_line();
    }
    rows(want, perhaps, 0);
    if (to->cols) return;
    /* a header says where x, y, z are; it might be misread */
    for (k = 0; k < width; k++)
        if (part[k] < LABEL) at[part[k]] = k;
    for (named = k = 0; k < axes && titles > 0; k++)
        named |= (axis(title[at[k]]) == k) << k;
    if (named == 3 && axes == 3 && to->columns == 0)
        plane = to->bare ? "; if they are in a plane: -qcols X,Y"
                         : "; if they are in a plane: -plane";
    words = titles > 0 &&
            (named != (1 << axes) - 1 || at[0] > at[1] ||
             at[1] > at[axes - 1] || at[axes - 1] - at[0] >= axes);
    if (axes == 2 && words)
        warn("%s: x, y are the columns %d, %d (%s, %s); %s chooses others",
             to->input, at[0] + 1, at[1] + 1, title[at[0]], title[at[1]],
             option());
    if (axes == 3 && words)
        warn("%s: x, y, z are the columns %d, %d, %d (%s, %s, %s); %s "
             "chooses others%s",
             to->input, at[0] + 1, at[1] + 1, at[2] + 1, title[at[0]],
             title[at[1]], title[at[2]], option(), plane);
    if (counting && !(named & 1) &&
        (to->columns > 0 || (to->bare && width > axes)) &&
        to->n >= 4)
        warn("%s: column 1 is %.0f, %.0f, %.0f, ... and was taken for x; if "
             "it numbers the points: %s 2,3%s",
             to->input, count_from, count_from + 1.0, count_from + 2.0,
             option(), axes == 2 ? "" : ",4");
}

/* no_faces - say that the faces of a surface are left out. */
static void no_faces(void)
{
    warn("%s: its faces are left out: the mesh is of the points alone, and "
         "fills their hull",
         to->input);
}

/* read_off - OFF, COFF, NOFF: points, and faces. */
static void read_off(void)
{
    double want;
    int at = many > 1;

    if (word(0, "4OFF") || word(0, "nOFF") || word(1, "BINARY"))
        fail_line("not an OFF file of points in space, in ASCII");
    if (!at) need_line();
    if (many <= at || !count(at)) fail_line("not the number of points");
    want = fields[at].x;
    if (many > at + 1 && fields[at + 1].x > 0.0) no_faces();
    need_line();
    rows(want, 0, 1);
}

/* packed_type - the next column of a binary PLY file: its type is field 1. */
static void packed_type(void)
{
    static const char types[] =
        " char=i1 int8=i1 uchar=u1 uint8=u1 short=i2 int16=i2 ushort=u2 "
        "uint16=u2 int=i4 int32=i4 uint=u4 uint32=u4 float=f4 float32=f4 "
        "double=f8 float64=f8";
    char name[20];
    const char *at;

    sprintf(name, " %.9s=", fields[1].text);
    at = strstr(types, name);
    if (!at || many != 3 || packed.columns == COLUMNS)
        fail_line("not a property that points of a PLY file may have");
    packed.kind[packed.columns] = at[strlen(name)];
    packed.bytes[packed.columns++] = at[strlen(name) + 1] - '0';
}

static void read_ply(void)
{
    double want = -1.0;
    int binary = 0;

    titles = 0;
    for (need_line(); !word(0, "end_header"); need_line()) {
        packed.big |= word(1, "binary_big_endian");
        if (word(0, "format")) binary = !word(1, "ascii");
        if (word(0, "format") && binary && !packed.big &&
            !word(1, "binary_little_endian"))
            fail_line("not a format of PLY files");
        if (word(0, "element") && want < 0.0) {
            if (!word(1, "vertex") || many != 3 || !count(2))
                fail_line("points must be the first element of a PLY file");
            want = fields[2].x;
        } else if (word(0, "element")) {
            if (word(1, "face") && many > 2 && fields[2].x > 0.0) no_faces();
            while (!word(0, "end_header")) need_line();
            break;
        }
        if (word(0, "property") && binary) packed_type();
        if (word(0, "property") && many == 3 && titles < COLUMNS)
            sprintf(title[titles++], "%.*s", TITLE - 1, fields[2].text);
    }
    if (binary) {
        packed_rows(want);
        return;
    }
    need_line();
    rows(want, 0, 1);
}

/* read_npy - NumPy's: a row for each point. */
static void read_npy(void)
{
    char order = 0, kind = 0, end = 0;
    double n = 0.0, columns = 0.0;
    const char *descr, *shape;
    int version, bytes = 0, size, k;

    for (k = 0; k < 6; k++) next_char();
    version = next_char();
    next_char();
    size = next_char();
    size += 256 * next_char();
    for (k = 0; version > 1 && k < 2; k++) next_char();
    for (k = 0; k < size && k < LINE; k++) line[k] = (char)next_char();
    line[k] = '\0';
    descr = strstr(line, "'descr'");
    shape = strstr(line, "'shape'");
    if (!descr || !shape || !strstr(line, "False") || k < size ||
        sscanf(descr, "'descr' : '%c%c%d'", &order, &kind, &bytes) != 3 ||
        sscanf(shape, "'shape' : ( %lf , %lf %c", &n, &columns, &end) != 3 ||
        end != ')' || columns < 1.0 || columns > (double)COLUMNS ||
        (kind == 'f' ? bytes != 4 && bytes != 8
                     : (kind != 'i' && kind != 'u') || bytes < 1 || bytes > 8))
        fail("%s: not a .npy file of rows of at most %d float32, float64 or "
             "integers: numpy.save(F, numpy.ascontiguousarray(rows, float)) "
             "writes one", to->input, COLUMNS);
    packed.big = order == '>';
    for (; packed.columns < (int)columns; packed.columns++) {
        packed.kind[packed.columns] = kind;
        packed.bytes[packed.columns] = bytes;
    }
    packed_rows(n);
}

/* read_stl - binary STL: 80 characters, and the number of facets; the file's
 * size says which order of its bytes is right. */
static void read_stl(void)
{
    const unsigned char *byte = (const unsigned char *)block + 80;
    double little = 0.0, big = 0.0;
    int k;

    for (k = 0; k < 4; k++) {
        little = 256.0 * little + byte[3 - k];
        big = 256.0 * big + byte[k];
    }
    packed.big = file_size != 84.0 + 50.0 * little &&
                 file_size == 84.0 + 50.0 * big;
    for (k = 0; k < 84; k++) next_char();
    while (packed.columns < 3) {
        packed.kind[packed.columns] = 'f';
        packed.bytes[packed.columns++] = 4;
    }
    if (filled > 84) no_faces();
    packed_rows(3.0 * (packed.big ? big : little));
}

/* read_lines - those that begin with this word: v of Wavefront's, vertex of
 * ASCII STL. */
static void read_lines(const char *first)
{
    int faces = 0;

    while (!word(0, first)) need_line();
    fields[0].number = 0;
    shape(1);
    do {
        if (word(0, first)) row();
        if ((word(0, "f") || word(0, "facet")) && !faces++) no_faces();
        if (!next_line()) return;
        split();
    } while (1);
}

/* column - the number in columns from ... to, counted from 1, of a line with
 * fixed columns; fallback if they are blank. */
static double column(int from, int last, double fallback)
{
    char text[20], *end;
    double x;

    if ((int)strlen(line) < from) return fallback;
    sprintf(text, "%.*s", last - from + 1, line + from - 1);
    x = strtod(text, &end);
    while (blank(*end)) end++;
    if (*end) fail_line("not an atom, or a cell, of a PDB file");
    return end[-1] && strspn(text, " ") < strlen(text) ? x : fallback;
}

/* crystal - CRYST1: sides and angles of the box that repeats itself.  (A cube
 * of side 1 is what files have for want of one.) */
static void crystal(void)
{
    static const double origin[3] = {0.0, 0.0, 0.0};
    const char *group = strlen(line) > 55 ? line + 55 : "P 1";
    double v[9] = {0.0}, angle, c[3], side[3];
    int k;

    for (k = 0; k < 3; k++) v[4 * k] = column(7 + 9 * k, 15 + 9 * k, 0.0);
    if (!chosen.periodic || (v[0] == 1.0 && v[4] == 1.0 && v[8] == 1.0)) return;
    for (k = 0; k < 3; k++) {
        side[k] = v[4 * k];
        angle = column(34 + 7 * k, 40 + 7 * k, 90.0);
        c[k] = angle == 90.0 ? 0.0 : cos(angle * atan(1.0) / 45.0);
    }
    /* the first vector is along x, the second in the plane of x, y */
    angle = sqrt(1.0 - c[2] * c[2]);
    v[3] = side[1] * c[2];
    v[4] = side[1] * angle;
    v[6] = side[2] * c[1];
    v[7] = c[0] - c[1] * c[2] == 0.0 ? 0.0
                                     : side[2] * (c[0] - c[1] * c[2]) / angle;
    v[8] = sqrt(side[2] * side[2] - v[6] * v[6] - v[7] * v[7]);
    if (v[6] == 0.0 && v[7] == 0.0) v[8] = side[2];
    if (!(v[8] > 0.0)) fail_line("the angles are none of a cell");
    lattice(v, origin);
    if (strncmp(group, "P 1        ", strlen(group) < 11 ? strlen(group) : 11))
        warn("%s, line %ld: the atoms are repeated as they are, without what "
             "the space group %.11s adds in the cell",
             to->input, line_number, group);
}

/* read_pdb - atoms, with their temperature factors; of the first model. */
static void read_pdb(void)
{
    double x[3], factor;
    char text[5], name[5];
    int k;

    if (to->named) strcpy(to->labelled, "name");
    to->columns = 1;
    strcpy(to->name[0], "B");
    do {
        if (strncmp(line, "ENDMDL", 6) == 0) {
            warn("%s, line %ld: the first model is read, no other",
                 to->input, line_number);
            return;
        }
        if (strncmp(line, "CRYST1", 6) == 0) crystal();
        if (strncmp(line, "ATOM  ", 6) != 0 && strncmp(line, "HETATM", 6) != 0)
            continue;
        if (strlen(line) < 54) fail_line("not an atom of a PDB file");
        for (k = 0; k < 3; k++)
            x[k] = column(31 + 8 * k, 38 + 8 * k, 0.0);
        factor = column(61, 66, 0.0);
        if (void_value(factor)) {
            voided++;
            drop();
            continue;
        }
        add_point(x);
        if (!to->bare) to->value[to->n - 1] = factor;
        sprintf(text, "%.4s", line + 12);
        if (sscanf(text, "%4s", name) != 1) name[0] = '\0';
        if (to->named) add_group(name);
    } while (next_line());
}

/* read_node - TetGen: attributes and markers are values. */
static void read_node(void)
{
    double want, x[3];
    int attributes, k;

    for (k = many; k < 4; k++) fields[k].x = 0.0;
    if (many < 2 || numbers() < many || many > 4 || !count(0) ||
        fields[2].x < 0.0 || fields[2].x > COLUMNS - 5.0)
        fail_line("not the first line of a .node file");
    if (fields[1].x != 3.0)
        fail_line("the points are not in three dimensions");
    want = fields[0].x;
    attributes = (int)fields[2].x;
    to->marker = fields[3].x != 0.0;
    to->columns = attributes + to->marker;
    for (k = 0; k < attributes; k++)
        sprintf(to->name[k], k > 0 ? "value%d" : "value", k + 1);
    if (to->marker) strcpy(to->name[attributes], "marker");
    while ((double)to->n + (double)dropped < want) {
        if (!next_line())
            fail("%s: ends after %ld of %.0f points", to->input,
                 (long)to->n + dropped, want);
        split();
        if (numbers() < 4 + to->columns || numbers() < many)
            fail("%s, line %ld: not %d numbers", to->input, line_number,
                 4 + to->columns);
        if (to->n + dropped == 0 && fields[0].x == 1.0) to->base = 1;
        if (fields[0].x != (double)to->n + (double)dropped + (double)to->base)
            fail_line("points are not numbered one after the other from 0 "
                      "or 1");
        for (k = 0; k < attributes && !void_value(fields[k + 4].x);) k++;
        if (k < attributes) {
            voided++;
            drop();
            continue;
        }
        for (k = 0; k < 3; k++) x[k] = fields[k + 1].x;
        add_point(x);
        for (k = 0; k < to->columns && !to->bare; k++)
            to->value[to->columns * (long)(to->n - 1) + k] = fields[k + 4].x;
    }
}

/* fixed - leave if -cols is given for a format that has no choice. */
static void fixed(const char *format)
{
    if (to->axes == 2)
        fail("%s: coordinates in a plane are read from lines of numbers, not "
             "from %s", to->input, format);
    if (to->cols || to->by)
        fail("%s: %s is for lines of numbers, not for %s", to->input,
             to->cols ? option() : "-by", format);
}

/* pdb, obj, off, stl - is the line, split but for pdb and stl, the first one of
 * such a file?  A column may have the name that this begins with. */
static int pdb(void)
{
    static const char *const record[] = {
        "HEADER", "OBSLTE", "TITLE ", "COMPND", "REMARK", "CRYST1",
        "MODEL ", "ATOM  ", "HETATM", "AUTHOR"};
    size_t k;

    for (k = 0; k < sizeof record / sizeof record[0]; k++)
        if (strncmp(line, record[k], 6) == 0)
            return !line[6] || !strchr(",;\t", line[6 + strspn(line + 6, " ")]);
    return 0;
}

static int obj(void)
{
    int k;

    if (separator == ',' || separator == ';') return 0;
    if (word(0, "mtllib")) return 1;
    if (word(0, "o")) return many == 2;
    for (k = 1; k < many && fields[k].number; k++) continue;
    return word(0, "v") && k == many && many > 3;
}

static int off(void)
{
    const char *name = fields[0].text + strspn(fields[0].text, "STCN4n");

    return strcmp(name, "OFF") == 0 && !separator &&
           (many == 1 || count(1) || word(1, "BINARY"));
}

static int stl(void)
{
    return strncmp(line, "solid", 5) == 0 && (!line[5] || blank(line[5])) &&
           strstr(block + taken, "facet");
}

void read_points(const char *name, points *a)
{
    to = a;
    filled = taken = 0;
    titles = width = counting = first_open = apart = 0;
    suspect[0] = '\0';
    by = -1;
    axes = 3;
    decimals = to->decimal == ',';
    line_number = first_line = dropped = voided = misplaced = 0;
    packed.columns = packed.big = packed.facets = 0;
    file_size = passed = 0.0;
    spilled = 0;
    unsure = 0;
    to->input = "standard input";
    file = stdin;
    if (name && strcmp(name, "-") != 0) {
        to->input = name;
        file = fopen(name, "rb");
        if (!file) fail("%s: %s", name, strerror(errno));
        if (fseek(file, 0L, SEEK_END) == 0) file_size = (double)ftell(file);
        rewind(file);
    } else if (!name)
        warn("reading points from standard input");
    refuse_others();
    if (memcmp(block, NUMPY, 6) == 0)
        read_npy();
    else if (packed.facets) {
        fixed("STL");
        read_stl();
    } else if (!next_line())
        fail("%s: empty", to->input);
    else if (ends_in(to->input, ".pdb") || ends_in(to->input, ".ent") ||
             pdb()) {
        fixed("PDB");
        read_pdb();
    } else if (stl()) {
        fixed("STL");
        split();
        read_lines("vertex");
    } else {
        split();
        if (ends_in(to->input, ".node")) {
            fixed(".node files");
            read_node();
        } else if (word(0, "ply") && many == 1)
            read_ply();
        else if (off())
            read_off();
        else if (ends_in(to->input, ".obj") || obj()) {
            fixed("OBJ");
            read_lines("v");
        } else if (strncmp(fields[0].text, "data_", 5) == 0 && many == 1)
            fail_line("mmCIF is not read; save it as PDB or xyz");
        else
            read_text();
    }
    if (to->n == 0 && dropped > 0)
        fail("%s: no points: %s drops all %ld rows; name the columns that are "
             "wanted: %s X,Y,Z%s",
             to->input, to->skip ? "-skip" : "-nodata", dropped, option(),
             to->bare ? "" : ",VALUE");
    if (to->n == 0) fail("%s: no points", to->input);
    to->axes = axes;
    to->all = (double)to->n;
    if (to->scratch)
        spill();
    else
        rooms(to->all, to->bare ? 0.0 : to->all * (double)to->columns);
    if (to->by) number_groups();
    else {
        to->labels = labels;
        to->label = label;
    }
    if (dropped > 0)
        warn("%s: %ld row%s dropped for a number that is missing, the first "
             "in line %ld%s",
             to->input, dropped, dropped > 1 ? "s" : "", first_dropped,
             to->columns > 1
                 ? "; fewer if -cols X,Y,Z,VALUE asks for one column's values"
                 : "");
    if (to->voids > 0 && voided == 0)
        warn("%s: -nodata: no value is such a number", to->input);
    if (misplaced > 0)
        warn("%s: %ld coordinate%s a number of -nodata, which is for values: "
             "not dropped",
             to->input, misplaced, misplaced > 1 ? "s are" : " is");
    if (file != stdin) fclose(file);
    progress("reading", 1.0, 1.0);
}
