/* scan.c - one file: its bytes and its lines, what of it is left out, messages
 * that say where.
 */
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define LONGEST_LINE 67108864.0

/* more - read on, behind what is not yet taken; 0 if nothing is left. */
static int more(scan *s)
{
    size_t keep = s->pinned ? 0 : (size_t)(s->at - s->block);
    size_t at = (size_t)(s->at - s->block) - keep, n;
    size_t filled = (size_t)(s->end - s->block) - keep;

    if (s->ended) return 0;
    memmove(s->block, s->block + keep, filled);
    s->passed += (double)keep;
    if (2 * filled > s->room) {
        if (!s->binary && (double)s->room > LONGEST_LINE)
            fail("%s:%ld: a line of more than 64 MB", s->name, s->number + 1);
        s->room *= 2;
        s->block = (char *)more_space(s->block, (double)s->room + 1.0, 1);
    }
    n = fread(s->block + filled, 1, s->room - filled, s->file);
    s->ended = n < s->room - filled;
    if (ferror(s->file)) fail("%s: %s", s->name, strerror(errno));
    s->at = s->block + at;
    s->end = s->block + filled + n;
    *s->end = '\0';
    n = (size_t)(s->end - s->at);
    s->rough = memchr(s->at, '\r', n) || memchr(s->at, '\0', n) ||
               memchr(s->at, '\032', n);
    return s->end > s->block + filled;
}

void scan_open(scan *s, const char *name)
{
    long size = -1;
    char *c;

    s->name = "standard input";
    s->file = stdin;
    if (name && strcmp(name, "-") != 0) {
        s->name = name;
        s->file = fopen(name, "rb");
        if (!s->file) fail("%s: %s", name, strerror(errno));
        if (fseek(s->file, 0L, SEEK_END) == 0) size = ftell(s->file);
        rewind(s->file);
    } else if (!name && !chosen.quiet)
        warn("reading points from standard input");
    s->size = size > 0 ? (double)size : -1.0;
    s->room = 4 * SAMPLE;
    s->block = (char *)space((double)s->room + 1.0, 1);
    s->at = s->end = s->block;
    more(s);
    c = s->at;
    if (strncmp(c, "\377\376", 2) == 0 || strncmp(c, "\376\377", 2) == 0 ||
        (s->end - c > 3 && ((c[0] >= ' ' && !c[1] && c[2] >= ' ' && !c[3]) ||
                            (!c[0] && c[1] >= ' ' && !c[2] && c[3] >= ' '))))
        fail("%s: is UTF-16; save it as UTF-8 or ASCII", s->name);
    if (strncmp(c, "\357\273\277", 3) == 0) s->at += 3;
}

/* back - the character in whose place '\0' stands. */
static void back(scan *s)
{
    if (s->stop) *s->stop = s->held;
    s->stop = 0;
}

/* at_end - is nothing left? */
static int at_end(scan *s)
{
    int c = getc(s->file);

    ungetc(c, s->file); /* (EOF is not put back) */
    return s->at == s->end && c == EOF;
}

int scan_line(scan *s)
{
    size_t seen = 0;
    char *e, *nul, *from;
    int wide = 1;

    back(s);
    for (;;) {
        from = s->at + seen;
        e = (char *)memchr(from, '\n', (size_t)(s->end - from));
        nul = !s->rough ? 0
                        : (char *)memchr(from, '\r',
                                         (size_t)((e ? e : s->end) - from));
        if (nul) {
            e = nul;
            /* (LF behind CR is to be there, too) */
            if (e + 1 == s->end && more(s)) continue;
        }
        if (!e) {
            seen = (size_t)(s->end - s->at);
            if (more(s)) continue;
            if (s->at == s->end) return 0;
            e = s->end;
            s->open = 1;
        }
        wide = e < s->end ? 1 + (*e == '\r' && e[1] == '\n') : 0;
        s->number++;
        if (!s->joins || e == s->at + seen || e[-1] != '\\' || e == s->end)
            break;
        memset(e - 1, ' ', (size_t)wide + 1);
        seen = (size_t)(e + wide - s->at);
        s->blank += !s->pinned;
    }
    s->line = s->at;
    s->stop = e;
    s->held = *e;
    *e = '\0';
    s->at = e + wide;
    if (!s->rough) return 1;
    nul = (char *)memchr(s->line, '\0', (size_t)(e - s->line));
    if (nul && !s->pinned)
        scan_fail(s, "column %ld is a NUL: not text",
                  (long)(nul - s->line) + 1);
    /* Ctrl-Z, with which some systems end a file */
    if (e > s->line && e[-1] == '\032' && at_end(s)) {
        back(s);
        s->stop = --e;
        s->held = *e;
        *e = '\0';
        if (e > s->line) return 1;
        s->number--;
        s->open = 0;
        return 0;
    }
    return 1;
}

double scan_passed(const scan *s)
{
    return s->passed + (double)(s->at - s->block);
}

int in_sample(const scan *s)
{
    return (size_t)(s->at - s->block) < s->mark + SAMPLE;
}

char *scan_take(scan *s, size_t n)
{
    back(s);
    s->binary = 1;
    while ((size_t)(s->end - s->at) < n)
        if (!more(s)) return 0;
    s->at += n;
    return s->at - n;
}

void scan_room(const scan *s, double rows, double bytes)
{
    double left = s->size - scan_passed(s);
    /* (the last line may have no end; of no bytes there is no end) */
    double most = floor((left + !s->binary) / bytes);

    if (rows == 0.0) fail("%s: no points", s->name);
    if (s->size >= 0.0 && rows > most)
        fail("%s: announces %.0f points, has room for %.0f at most", s->name,
             rows, most > 0.0 ? most : 0.0);
}

void scan_pin(scan *s)
{
    back(s);
    s->mark = (size_t)(s->at - s->block);
    s->marked = s->number;
    s->pinned = 1;
}

void scan_again(scan *s)
{
    back(s);
    s->at = s->block + s->mark;
    s->number = s->marked;
    if (s->at < s->end) s->open = 0;
}

void scan_go(scan *s)
{
    scan_again(s);
    s->pinned = 0;
}

void scan_note(scan *s, const char *what, double many, int lines)
{
    int k;

    for (k = 0; k < KINDS - 1 && s->left[k].what &&
                strcmp(s->left[k].what, what) != 0;)
        k++;
    if (!s->left[k].what) {
        s->left[k].what = what;
        s->left[k].first = s->number;
        s->left[k].lines = lines;
    }
    s->left[k].many += many;
}

void scan_leave(scan *s, const char *what)
{
    scan_note(s, what, 1.0, 1);
}

void scan_rest(scan *s, const char *what)
{
    if (!s->binary)
        while (next_line(s)) scan_leave(s, what);
    else
        do {
            if (s->end > s->at) scan_note(s, what, (double)(s->end - s->at), 1);
            s->at = s->end;
        } while (more(s));
}

void scan_end(scan *s)
{
    double left = 0.0, all, many;
    const char *what;
    char where[24] = "";
    int k;

    back(s);
    for (k = 0; s->left[k].what; k++) {
        what = s->left[k].what;
        many = s->left[k].many;
        if (s->left[k].lines) left += many;
        if (!s->binary) sprintf(where, ":%ld", s->left[k].first);
        warn("%s%s: its %s are left out: %.0f %s%s%s", s->name, where, what,
             many, !s->left[k].lines ? "point" : s->binary ? "byte" : "line",
             many > 1.0 ? "s" : "",
             strcmp(what, "faces") == 0
                 ? "; the mesh is of the points alone, and fills their hull"
                 : "");
    }
    if (s->open)
        warn("%s:%ld: the last line has no end: is the file cut?", s->name,
             s->number);
    all = s->binary ? scan_passed(s) : (double)s->number;
    if (chosen.account)
        tell("account       %.0f %s: %.0f of rows, %.0f of the head, %.0f "
             "blank or comments, %.0f dropped, %.0f left out: %s\n",
             all, s->binary ? "bytes" : "lines", s->rows, s->head, s->blank,
             s->dropped, left,
             s->rows + s->head + s->blank + s->dropped + left == all
                 ? "all" : "NOT ALL");
    if (s->file != stdin) fclose(s->file);
    free(s->block);
}

void scan_fail(const scan *s, const char *format, ...)
{
    char text[1000];
    va_list list;

    va_start(list, format);
    vsprintf(text, format, list);
    va_end(list);
    if (s->binary && s->number == 0) fail("%s: %s", s->name, text);
    fail(s->binary ? "%s, row %ld: %s" : "%s:%ld: %s", s->name, s->number,
         text);
}
