/* cell.c - what a number is, what else a cell may be, and how a line is cut
 * into cells.
 */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define LONGEST_ODD 400 /* characters of a number that is copied */

#define DIGIT(c) ((unsigned)((c) - '0') < 10u)
#define LETTER(c) ((unsigned)(((c) | 32) - 'a') < 26u)

#define BLANK(c) \
    ((c) <= ' ' && ((c) == ' ' || (c) == '\t' || (c) == '\f' || (c) == '\v'))

/* behind - the blanks from p on; tab: where one that is none, a separator. */
static char *behind(char *p, char tab)
{
    while (BLANK(*p) && *p != tab) p++;
    return p;
}

/* ---------------------------------------------------------------- numbers */

/* figures - the end of the number at s; s if there is none.  *odd: is it not as
 * C writes it? */
static char *figures(char *s, char decimal, int *odd)
{
    char *p = s, *from, *e;
    int digits, point = 0;

    *odd = 0;
    if (*p == '-' || *p == '+') p++;
    for (from = p; DIGIT(*p);) p++;
    digits = p > from;
    if (*p == decimal && (decimal == '.' || DIGIT(p[1]))) {
        point = 1;
        *odd = decimal != '.';
        for (from = ++p; DIGIT(*p);) p++;
        digits |= p > from;
    }
    if (!digits) return s;
    if (LETTER(*p)) {
        if (!strchr("eEdDqQ", *p)) return s;
        *odd |= (*p | 32) != 'e';
        p++;
        if (*p == '-' || *p == '+') p++;
        if (!DIGIT(*p)) return s;
        while (DIGIT(*p)) p++;
        return LETTER(*p) ? s : p;
    }
    /* FORTRAN's 1.34-101: three digits leave no room for the letter */
    if ((*p == '-' || *p == '+') && point) {
        for (e = p + 1; DIGIT(*e);) e++;
        if (e == p + 4) {
            *odd = 1;
            return e;
        }
    }
    return p;
}

/* as_c - of a number that is not as C writes it. */
static double as_c(const char *s, const char *end)
{
    char text[LONGEST_ODD + 2], *to = text; /* one letter more */
    int letter = 0;

    for (; s < end; s++) {
        if (LETTER(*s)) letter = 1;
        if ((*s == '-' || *s == '+') && to > text && !letter) *to++ = 'e';
        *to++ = (char)(*s == ',' ? '.' : LETTER(*s) ? 'e' : *s);
    }
    *to = '\0';
    return strtod(text, &to);
}

char *number(char *s, char decimal, double *x)
{
    char *stop;
    int odd;
    char *end = figures(s, decimal, &odd);

    if (!x || end == s) return end;
    if (odd && end - s > LONGEST_ODD) return s;
    *x = odd ? as_c(s, end) : strtod(s, &stop);
    return end;
}

/* plain_number - the same at once, of most numbers; s of others. */
static char *plain_number(char *s, double *x)
{
    char *end;

    if (!DIGIT(*s) && !((*s == '-' || *s == '.') && DIGIT(s[1]))) return s;
    if ((s[1] | 32) == 'x' || (s[1] == '0' && (s[2] | 32) == 'x')) return s;
    *x = strtod(s, &end);
    /* (figures would take more, or nothing) */
    return LETTER(*end) || *end == '-' || *end == '+' ? s : end;
}

int whole(const char *s, const char *end, double *n)
{
    *n = 0.0;
    if (s == end) return 0;
    for (; s < end && DIGIT(*s); s++)
        *n = 10.0 * *n + (*s - '0');
    return s == end && *n < WHOLE;
}

int cell_whole(const cell *c, double *n)
{
    return whole(c->text, c->end, n);
}

double stored(const char *at, char type, int bytes, int big)
{
    static const int one = 1;
    char byte[8]; /* as this machine has them */
    float narrow;
    double x;
    int k, most = big ? 0 : bytes - 1, step = big ? 1 : -1;

    if (type == 'f') {
        for (k = 0; k < bytes; k++)
            byte[big == *(const char *)&one ? bytes - 1 - k : k] = at[k];
        memcpy(&x, byte, sizeof x);
        if (bytes == 8) return x;
        memcpy(&narrow, byte, sizeof narrow);
        return (double)narrow;
    }
    at += most;
    x = (unsigned char)*at;
    if (type == 'i' && x > 127.0) x -= 256.0;
    for (k = 1; k < bytes; k++) x = 256.0 * x + (unsigned char)*(at += step);
    return x;
}

int numbers(char *s, const char *end, int want, double *x)
{
    char *stop = s;
    int k;

    for (k = 0;; k++) {
        while (s < end && (BLANK(*s) || strchr(",[]", *s))) s++;
        if (s >= end) return k == want;
        if (k == want || (k > 0 && s == stop)) return 0;
        stop = number(s, '.', x + k);
        if (stop == s || !(fabs(x[k]) <= DBL_MAX)) return 0;
        s = stop;
    }
}

/* ------------------------------------------------------------------ kinds */

/* same - the text s ... end, in letters of any case. */
static int same(const char *s, const char *end, const char *text)
{
    while (s < end && *text &&
           tolower((unsigned char)*s) == tolower((unsigned char)*text)) {
        s++;
        text++;
    }
    return s == end && !*text;
}

int cell_is(const cell *c, const char *text)
{
    return same(c->text, c->end, text);
}

const char *listed(const char *list, const char *s, const char *end, char by)
{
    char word[24];

    if (end - s > 20) return 0;
    sprintf(word, " %.*s%c", (int)(end - s), s, by);
    list = strstr(list, word);
    return list ? list + strlen(word) : 0;
}

/* in_list - is it one of those? */
static int in_list(const char *s, const char *end, const char *const *list)
{
    if (end - s > 15) return 0;
    while (*list && !same(s, end, *list)) list++;
    return *list != 0;
}

/* pandas' list, and spreadsheets' */
static const char *const absent[] = {
    "NA", "N/A", "#N/A", "#N/A N/A", "#NA", "<NA>", "null", "none", "-", "--",
    ".", "?", "#VALUE!", "#REF!", "#DIV/0!", "#NUM!", "#NAME?", "#NULL!", 0};
static const char *const nan_texts[] = {
    "nan", "-nan", "+nan", "nan(ind)", "-nan(ind)", "nan(snan)", "1.#QNAN",
    "-1.#QNAN", "1.#IND", "-1.#IND", "1.#SNAN", 0};
static const char *const inf_texts[] = {
    "inf", "+inf", "-inf", "infinity", "+infinity", "-infinity", "1.#INF",
    "-1.#INF", 0};

/* What rows are called that sum up others: at most 32, by length; from where on
 * they are so long. */
static const char *const sums[] = {
    "sum", "min", "max", "std", "avg", "25%", "50%", "75%", "mean", "sums",
    "total", "count", "stdev", "summe", "somme", "totals", "median", "stddev",
    "average", "minimum", "maximum", "moyenne", "subtotal", "promedio",
    "sub-total", "mittelwert", "grand total"};
static const int so_long[] = {0, 0, 0, 0, 8, 10, 15, 18, 22, 24, 25, 26, 27};

int sum_word(const cell *c)
{
    const char *end = c->end, *s = c->text;
    int k, last;

    if (c->kind != WORD) return -1;
    if (end[-1] == ':') end--;
    if (end - s >= (int)(sizeof so_long / sizeof so_long[0]) - 1) return -1;
    last = so_long[end - s + 1];
    for (k = so_long[end - s]; k < last; k++)
        if ((*s | 32) == (*sums[k] | 32) && same(s, end, sums[k])) return k;
    return -1;
}

/* thousands - how many groups of three digits follow one to three, not 0 first,
 * with that sign before each; 0 unless that is all there is of them. */
static int thousands(const char *s, char sign)
{
    const char *p = s;
    int n;

    if (*s == '0') return 0;
    while (DIGIT(*p)) p++;
    if (p == s || p > s + 3) return 0;
    for (n = 0; *p == sign; n++) {
        for (s = ++p; DIGIT(*p);) p++;
        if (p != s + 3) return 0;
    }
    return n;
}

/* hint - what to do about a text that is a number but for its commas; or its
 * points, if commas are decimal.  0 for any other. */
static const char *hint(const cell *c, char decimal)
{
    char *s = c->text + (*c->text == '+' || *c->text == '-'), *p;
    char sign = decimal == ',' ? '.' : ',';
    int signs = 0, decimals = 0, behind = 0, groups;

    for (p = s; p < c->end && (DIGIT(*p) || *p == '.' || *p == ','); p++) {
        signs += *p == sign;
        decimals += *p == decimal;
        behind += *p == decimal && signs > 0;
    }
    /* (the last digit, and an exponent) */
    if (p == s || number(p - 1, decimal, 0) != c->end) return 0;
    groups = thousands(s, sign);
    if (decimal == ',')
        return signs == 1 || groups > 1
                   ? " (with -decimal , numbers have no points)"
               : signs == 0 ? " (with -decimal , commas between digits are "
                              "decimal)" : 0;
    if (groups == signs && behind < 2 && groups + behind > 1)
        return " (commas between thousands must go)";
    if (signs != 1 || behind > 0) return 0;
    return decimals > 0 ? " (points between thousands must go; see also "
                          "-decimal)"
           : groups && c->quoted
               ? " (a comma between thousands must go; see also -decimal)"
               : " (a decimal comma?  -decimal , reads it)";
}

/* near_number - what is wrong with a text that is a number but for something;
 * else 0. */
static const char *near_number(const cell *c, char decimal)
{
    static const char *const blanks[] = {"\302\240", "\342\200\257",
                                         "\342\200\211", 0};
    const char *why = hint(c, decimal), *const *b;
    char *s, *stop;

    if (why) return why;
    if (c->end - c->text > 3 && memcmp(c->text, "\342\210\222", 3) == 0 &&
        DIGIT(c->text[3]))
        return " (the sign is U+2212: it must be -)";
    stop = number(c->text, decimal, 0);
    for (s = c->text + (*c->text == '-' || *c->text == '+'); DIGIT(*s);) s++;
    for (b = blanks; *b && s > c->text; b++)
        if (DIGIT(s[-1]) && strncmp(s, *b, strlen(*b)) == 0 &&
            DIGIT(s[strlen(*b)]))
            return " (the blanks between digits must go)";
    if (stop == c->text) return 0;
    if (stop + 1 == c->end && (*stop == ',' || *stop == ';'))
        return " (one separator in a file)";
    s = number(stop, decimal, 0);
    if ((*stop == '-' || *stop == '+') && s == c->end &&
        memchr(stop, decimal, (size_t)(s - stop)))
        return " (two numbers that touch)";
    return 0;
}

void cell_kind(cell *c, char decimal)
{
    char *s = c->text, *end = c->end;

    c->kind = s == end ? EMPTY : WORD;
    c->x = 0.0;
    if (s == end || (LETTER(*s) && !strchr("nNiI", *s))) return;
    if (in_list(s, end, nan_texts)) {
        c->kind = ABSENT;
        c->x = no_number();
    } else if (in_list(s, end, absent))
        c->kind = ABSENT;
    else if (in_list(s, end, inf_texts)) {
        c->kind = INFINITE;
        c->x = *s == '-' ? -HUGE_VAL : HUGE_VAL;
    } else if (*s == '<' || *s == '>') {
        s = behind(s + 1, '\0');
        if (number(s, decimal, &c->x) == end && end > s &&
            fabs(c->x) <= DBL_MAX)
            c->kind = BELOW;
    } else {
        while (*s == '*') s++; /* (none is behind the end) */
        if (s == end) c->kind = STARS;
        else if (near_number(c, decimal)) c->kind = NEAR;
    }
}

const char *remedy(const cell *c, char decimal)
{
    const char *why;
    char *stop;

    if (c->kind == EMPTY || c->kind == ABSENT)
        return " (-skip drops such lines)";
    if (c->kind == STARS)
        return " (a number that did not fit FORTRAN's field; -skip drops such "
               "lines)";
    if (c->kind == INFINITE || c->kind == NUMBER) return "";
    if (c->kind == BELOW)
        return *c->text == '<' ? " (a limit; -below 0.5 reads half of it)"
                               : " (a limit; -below 0.5 reads it as it is)";
    if (c->quoted == 2)
        return " (a quote that does not end with the cell, or not in the line)";
    if (sum_word(c) >= 0)
        return " (a row of sums or means?  It must go)";
    why = near_number(c, decimal);
    if (why) return why;
    stop = number(c->text, decimal, 0);
    if (stop > c->text && *stop == '#')
        return " (a comment begins behind a blank)";
    if (stop == c->text || !BLANK(*stop)) return "";
    stop = behind(stop, '\0');
    if (*stop && strchr("NSEWnsew", *stop) && !LETTER(stop[1]))
        return " (a hemisphere?  S and W are numbers below 0)";
    return LETTER(*stop) ? " (a unit?  It must go)"
           : number(stop, decimal, 0) > stop
               ? " (two numbers in one cell: one separator in a file)" : "";
}

int list_numbers(const char *by, const char *text, int most, double *x)
{
    cell c;
    int many = 0;
    char *stop;

    c.quoted = 0;
    for (c.text = (char *)text;; c.text = c.end + 1) {
        if (many == most) return -1;
        c.text += strspn(c.text, " ");
        /* (there is no separator in one number) */
        c.end = c.text + strcspn(c.text, most > 1 ? "," : "");
        stop = number(c.text, '.', 0);
        if (stop + strspn(stop, " ") != c.end || stop == c.text) {
            cell_kind(&c, '.');
            fail("%s: \"%.*s\": not a number%s", by, SHOWN(&c),
                 c.kind == ABSENT && strcmp(by, "-nodata") == 0
                     ? remedy(&c, '.')
                 : most == 1 && strchr(text, ',') ? " (a point, no comma)"
                                                  : " (tess -h helps)");
        }
        if (!numbers(c.text, stop, 1, x + many++))
            fail("%s: \"%.*s\": not finite", by, (int)(stop - c.text), c.text);
        if (!*c.end) return many;
    }
}

/* ------------------------------------------------------------------- cells */

/* mark - does a comment begin at s? */
static int mark(const char *s)
{
    const char *e = s;

    if (*s != '#')
        return *s == '%' || *s == '!' || (*s == '/' && s[1] == '/');
    while (!BLANK(*e) && !strchr(",;|", *e)) e++; /* (or '\0') */
    return !in_list(s, e, absent);
}

int comment(const scan *s)
{
    const char *p = s->line;

    while (BLANK(*p)) p++;
    return !*p || mark(p) || *s->line == '/';
}

/* cell_end - where the cell ends that has p in it. */
static char *cell_end(char *p, char separator)
{
    while (*p && *p != separator && (separator != ' ' || !BLANK(*p))) p++;
    return p;
}

/* ends_line - does a comment end the line at p? */
static int ends_line(const char *p)
{
    return *p < '0' && mark(p);
}

/* cut_quoted - the cell whose quote is at p; what is behind it, and blanks. */
static char *cut_quoted(const dialect *d, cell *c, char *p, char tab)
{
    char *e;
    int closed;

    c->text = ++p;
    while (*p && (*p != '"' || p[1] == '"')) p += 1 + (*p == '"');
    c->end = p;
    closed = *p == '"';
    c->quoted = closed ? 1 : 2;
    p = behind(p + closed, tab);
    while (BLANK(*c->text) && c->text < c->end) c->text++;
    e = number(c->text, d->decimal, &c->x);
    if (e > c->text)
        while (BLANK(c->end[-1])) c->end--;
    if (e == c->text || e != c->end) cell_kind(c, d->decimal);
    if (*p && !(BLANK(p[-1]) && ends_line(p)) && *p != d->separator &&
        (d->separator != ' ' || !BLANK(p[-1]))) {
        c->end = p = cell_end(p, d->separator);
        c->quoted = 2;
    }
    if (c->quoted == 2) c->kind = WORD;
    return p;
}

/* cut_line - the cells between separators. */
static int cut_line(reader *r)
{
    const dialect *d = &r->d;
    char *p = r->s.line, separator = d->separator;
    char bare = (char)(d->apart ? '\001' : d->decimal);
    char tab = (char)(separator == '\t' ? '\t' : '\001'); /* no blank */
    int loose = separator == ',' && d->decimal == ',' && !d->apart;
    int n = 0, more = 0, plain = d->decimal == '.' && !r->skims;
    cell *c;

    r->torn = 0;
    for (c = r->cell;; c++) {
        p = behind(p, tab);
        c->text = p;
        c->quoted = 0;
        if (!*p) {
            c->end = p;
            c->kind = EMPTY;
            c->x = 0.0;
            n += more;
            break;
        }
        if (n > COLUMNS) break;
        n++;
        more = 0;
        c->kind = NUMBER;
        c->end = plain ? plain_number(p, &c->x) : p;
        if (c->end == p) c->end = number(p, bare, r->skims ? 0 : &c->x);
        if (c->end > p) {
            p = behind(c->end, tab);
            if (p > c->end && ends_line(p)) break;
        }
        if (c->end == c->text ||
            !(!*p || (*p == separator && !(loose && DIGIT(p[1]))) ||
              (separator == ' ' && p > c->end))) {
            p = c->text;
            if (*p == '"') {
                p = cut_quoted(d, c, p, tab);
                if (c->quoted == 2 && r->torn == 0) r->torn = n;
                if (ends_line(p)) break;
            } else {
                p = cell_end(p, separator);
                /* (a comma before a digit is decimal) */
                while (loose && *p == ',' && DIGIT(p[1]))
                    p = cell_end(p + 1, separator);
                for (c->end = p; c->end > c->text && BLANK(c->end[-1]);)
                    c->end--;
                cell_kind(c, d->decimal);
            }
        }
        if (separator == ' ') continue;
        if (*p++ != separator) break;
        more = 1;
    }
    r->more = more;
    return r->cells = n;
}

int cut(reader *r)
{
    int n = cut_line(r), k = 0;

    if (r->wide == 0 || n == r->columns) return n;
    /* (the last one may be shorter) */
    for (n = 0; k < (int)(r->s.stop - r->s.line) && n < COLUMNS; n++) {
        cut_fixed(&r->s, k + 1, k + r->wide, r->cell + n);
        k += r->wide;
    }
    if (n > 0 && r->cell[n - 1].kind == EMPTY) n--;
    r->more = r->torn = 0;
    return r->cells = n;
}

char *unquote(char *s, const char *end)
{
    char *to = s;

    for (; s < end; s++) {
        *to++ = *s;
        s += *s == '"';
    }
    return to;
}

void cut_fixed(const scan *s, int from, int last, cell *c)
{
    char held;

    c->quoted = 0;
    c->text = s->line + from - 1;
    c->end = s->line + last;
    if (c->end > s->stop) c->end = s->stop;
    if (c->text > c->end) c->text = c->end;
    while (c->text < c->end && BLANK(*c->text)) c->text++;
    while (c->end > c->text && BLANK(c->end[-1])) c->end--;
    /* (what touches it is the next column) */
    held = *c->end;
    *c->end = '\0';
    c->kind = NUMBER;
    if (c->text == c->end || number(c->text, '.', &c->x) < c->end)
        cell_kind(c, '.');
    *c->end = held;
}

int next_line(scan *s)
{
    while (scan_line(s)) {
        if (!comment(s)) return 1;
        s->blank += !s->pinned;
    }
    return 0;
}

int ends_rows(const reader *r)
{
    const char *s = r->s.line + strspn(r->s.line, " \t");

    return r->ends && strncmp(s, r->ends, strlen(r->ends)) == 0;
}

int next_cells(reader *r)
{
    if (r->over || !next_line(&r->s)) return 0;
    if (!ends_rows(r)) return cut(r);
    r->over = 1;
    r->s.head++;
    return 0;
}
