/* names.c - columns' names: lines of them, however they are parted; which three
 * of them are a point's axes; and what is asked if none are.
 */
#include <ctype.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "read.h"

#define SEAM 270.0 /* degrees without a point, from which on that is doubted */
#define LISTED 40  /* columns, of which it is asked what they are */

/* ------------------------------------------------------------- the names */

/* family - axes that belong together: what x, y, z are called there; words with
 * blanks about them. */
typedef struct family {
    const char *word[3];
    int marked; /* only beside a word that says what it is, as in Points:0; */
    int told;   /* which they are is told, in whatever order */
} family;

/* What is above, or below; and what may be so if there is nothing else. */
#define HEIGHTS \
    " z rl mrl elevation elev height altitude alt depth up tvd tvdss cota" \
    " elevacion hoehe h\303\266he "
#define PERHAPS \
    " level dept depsm depsf depfm depff pressure pres press ctdprs prdm" \
    " prsm "

static const family families[] = {
    {{" x ", " y ", " z "}, 0, 0},
    {{" 0 ", " 1 ", " 2 "}, 1, 0},
    {{" x1 ", " x2 ", " x3 "}, 1, 1},
    {{" x ", " y ", HEIGHTS}, 0, 1},
    {{" easting eastings east ", " northing northings north ", HEIGHTS}, 0, 1},
    {{" lon long longitude lng ", " lat latitude ", HEIGHTS}, 0, 1},
    {{" e ", " n ", HEIGHTS "h "}, 0, 1},
    {{" me ", " mn ", HEIGHTS}, 0, 1},
    {{" este ", " norte ", HEIGHTS}, 0, 1},
    {{" rechtswert ", " hochwert ", HEIGHTS}, 0, 1}};

#define LOCAL 3 /* x, y and any height */
#define GLOBE 5 /* lon, lat */
#define FAMILIES (int)(sizeof families / sizeof families[0])

/* Words beside an axis's that say that it is one, the longer ones first; and
 * units, which may stand without brackets. */
static const char *const marks[] = {
    "coordinates", "coordinate", "centroids", "centroid", "positions",
    "position", "location", "geometry", "gda2020", "mga2020", "decimal",
    "collar", "coords", "points", "centers", "centres", "center", "centre",
    "global", "wgs84", "gda94", "gda20", "nad83", "nad27", "point", "coord",
    "local", "world", "mga94", "mga20", "axis", "cell", "grid", "node", "mid",
    "utm", "mga", "ahd", "pos", "map", "loc", "c", 0};
static const char units[] =
    " in m km cm mm ft feet meter meters metre metres deg degree degrees masl "
    "mamsl asl amsl ";

/* Units of values, in letters of any case; % may be before or behind. */
static const char measures[] =
    " pct % %v %vol %wt wt% vol% percent permil ppm ppb ppt g/t gpt oz/t "
    "g/kg mg/kg ug/kg ug/g mg/l ug/l ng/l mmol/l ug/m3 mg/m3 kg/m3 g/m3 g/cm3 "
    "g/cc t/m3 m/s cm/s km/h m/d degc degf deg \302\260c \302\260f \302\260 "
    "\260c \260 kelvin pa hpa kpa mpa gpa bar mbar dbar psi psu mgal hz khz "
    "mv ms/m s/m ohm.m ohmm m km cm mm ft feet metres meters ";

int is_unit(const char *s, const char *end)
{
    char word[TITLE];
    int k, length = (int)(end - s);

    if (length == 0 || length >= TITLE) return 0;
    for (k = 0; k < length; k++) word[k] = (char)tolower((unsigned char)s[k]);
    return listed(measures, word, word + length, ' ') != 0;
}

/* add_word - to what is there so far; a unit is left out. */
static void add_word(char *name, const char *word, size_t length)
{
    if (length > 0 && !listed(units, word, word + length, ' '))
        strncat(name, word, length);
}

/* plain - the title's words in small letters, without blanks and signs between
 * them, and without what is in brackets, unless that says which axis it is. */
static void plain(const char *title, char *name)
{
    char word[TITLE];
    size_t length = 0, inside;
    const char *c, *end;

    name[0] = '\0';
    for (c = title; *c; c++) {
        if (*c == '(' || *c == '[') {
            end = c + 1 + strcspn(c + 1, ")]");
            inside = strspn(c + 1, " ") + 1;
            if (!*end || end != c + inside + 1 ||
                !strchr("xyzXYZ012", c[inside])) {
                c = *end ? end : end - 1;
                continue;
            }
        }
        if (isalnum((unsigned char)*c) || (unsigned char)*c > 127) {
            word[length++] = (char)tolower((unsigned char)*c);
            continue;
        }
        add_word(name, word, length);
        length = 0;
    }
    add_word(name, word, length);
}

/* strip - a mark at the name's beginning, or end, leaves it: 1 if there was
 * one. */
static int strip(char *name)
{
    const char *const *m;
    size_t length, all = strlen(name);

    for (m = marks; *m; m++) {
        length = strlen(*m);
        if (length >= all) continue;
        /* (cx may be a cosine) */
        if (length > 1 && strncmp(name, *m, length) == 0) {
            memmove(name, name + length, all - length + 1);
            return 1;
        }
        if (strcmp(name + all - length, *m) == 0) {
            name[all - length] = '\0';
            return 1;
        }
    }
    return 0;
}

/* rank_of - is the title that of the family's axis k?  0: just so; 1: with a
 * mark; 2 and 3: so, but it may be something else; -1: it is not. */
static int rank_of(const char *title, const family *f, int k)
{
    char name[TITLE];
    int marked = 0;
    const char *end;

    plain(title, name);
    for (;;) {
        end = name + strlen(name);
        if (end > name && marked >= f->marked) {
            if (listed(f->word[k], name, end, ' ')) return marked;
            if (k == 2 && f->told && !f->marked &&
                listed(PERHAPS, name, end, ' '))
                return 2 + marked;
        }
        if (!strip(name)) return -1;
        marked = 1;
    }
}

int is_axis(const char *title, int k)
{
    return rank_of(title, families, k) == 0 ||
           rank_of(title, families + 1, k) == 1;
}

/* alike - are the titles the same, in letters of any case? */
static int alike(const char *a, const char *b)
{
    while (*a && tolower((unsigned char)*a) == tolower((unsigned char)*b)) {
        a++;
        b++;
    }
    return *a == *b;
}

/* pick - the column that is the family's axis k by that rank; -1: none is.
 * *others: is there one more, of another title?  Words are taken for numbers,
 * and then refused, where there are no numbers. */
static int pick(reader *r, const family *f, int k, int rank, int *others)
{
    int i, words, found = -1;

    for (words = 0; words < 2 && found < 0; words++)
        for (i = 0; i < r->columns; i++) {
            if (words ? r->column[i].role != LABEL || !r->waits
                      : r->column[i].role != VALUE &&
                            r->column[i].role != HOLLOW)
                continue;
            if (r->column[i].apart || rank_of(r->column[i].title, f, k) != rank)
                continue;
            if (found < 0)
                found = i;
            else if (alike(r->column[found].title, r->column[i].title))
                r->twin = i;
            else
                *others = 1;
        }
    return found;
}

/* best - the same by the least rank that there is. */
static int best(reader *r, const family *f, int k, int *others)
{
    int rank, found = -1;

    for (rank = 0; rank < 4 && found < 0; rank++)
        found = pick(r, f, k, rank, others);
    return found;
}

/* fits - the columns that are the family's axes: 1, or 0 if it has not all of
 * them, which are -1 then; -1: there are others, too.  Of x and y, both have
 * marks, or none. */
static int fits(reader *r, const family *f, int *at)
{
    int k, rank, others = 0, unseen = 0, all = 1;

    for (rank = 0; rank < 2; rank++) {
        others = 0;
        for (k = 0; k < 2; k++) at[k] = pick(r, f, k, rank, &others);
        if (at[0] >= 0 && at[1] >= 0) break;
    }
    if (rank == 0 && pick(r, f, 0, 1, &unseen) >= 0 &&
        pick(r, f, 1, 1, &unseen) >= 0) {
        if (f == families) r->rivals = 1;
        else others = 1;
    }
    for (k = rank < 2 ? 2 : 0; k < r->axes; k++) at[k] = best(r, f, k, &others);
    for (k = 0; k < r->axes; k++) all &= at[k] >= 0;
    return !all ? 0 : others ? -1 : 1;
}

int choose_axes(reader *r, int *at)
{
    int f, k, how, said = NONE, other[3], twin = -1, found, most = 0;

    r->family = -1;
    at[0] = at[1] = at[2] = other[2] = -1;
    for (f = 0; f < FAMILIES; f++) {
        r->twin = -1;
        how = fits(r, families + f, other);
        for (found = k = 0; k < r->axes; k++) found += other[k] >= 0;
        /* (one of an incomplete family is a chance, but of x, y, z) */
        if (how == 0 && (said != NONE || found <= most || (f > 0 && found < 2)))
            continue;
        if (said == NONE) {
            memcpy(at, other, sizeof other);
            most = found;
        }
        if (how == 0) continue;
        if (said == NONE) {
            r->family = f;
            twin = r->twin;
            said = how < 0 ? SEVERAL : FIT;
            continue;
        }
        for (k = 0; k < r->axes && at[k] == other[k];) k++;
        if (how > 0 && k == r->axes) continue;
        /* (x, y, z, so called, go before all others) */
        if (r->family == 0)
            r->rivals |= at[0] != other[0] || at[1] != other[1];
        else
            said = SEVERAL;
    }
    r->twin = twin;
    return said;
}

/* --------------------------------------------------------- lines of names */

/* axes_among - how many axes of one family the cells name. */
static int axes_among(const reader *r)
{
    char title[TITLE];
    int f, k, i, found, most = 0;

    for (f = 0; f < FAMILIES; f++) {
        for (found = k = 0; k < 3; k++)
            for (i = 0; i < r->cells; i++) {
                title_of(r->cell + i, title);
                if (rank_of(title, families + f, k) < 0) continue;
                found++;
                break;
            }
        if (found > most) most = found;
    }
    return most;
}

/* How names may be parted: by one of these signs; as rows are; by more than one
 * blank; by blanks; by those behind which no unit in brackets is; nor one
 * without them, as in Au ppm. */
static const char ways[] = ",;|\t";
enum { ROWS = 4, GAPS, BLANKS, UNITS, BARE_UNITS, WAYS };

/* gap - does a cell of names end at p? */
static int gap(const char *p, int way)
{
    size_t blanks = strspn(p, " \t");

    if (!p[blanks]) return 1;
    if (blanks == 0) return 0;
    if (way >= UNITS && (p[blanks] == '(' || p[blanks] == '[')) return 0;
    if (way == BARE_UNITS) {
        p += blanks;
        return !is_unit(p, p + strcspn(p, " \t,;|"));
    }
    return way != GAPS || blanks > 1 || *p == '\t';
}

/* part_names - the text's cells, by that way; returns their number. */
static int part_names(reader *r, char *text, int way)
{
    cell *c = r->cell;
    char *p = text, mark;

    r->cells = r->more = r->torn = 0;
    while (*(p += strspn(p, " \t")) && r->cells < COLUMNS) {
        c->text = p;
        c->quoted = *p == '"';
        if (c->quoted) {
            c->text = ++p;
            while (*p && *p != '"') p++;
            c->end = p;
            if (!*p || !gap(++p, BLANKS)) c->quoted = 2;
        } else {
            for (mark = 0; *p && (mark || !gap(p, way)); p++)
                if (way >= UNITS) {
                    if (*p == '(' || *p == '[') mark = *p == '(' ? ')' : ']';
                    else if (*p == mark) mark = 0;
                }
            c->end = p;
            while (c->end > c->text && strchr(",;|", c->end[-1])) c->end--;
        }
        c->kind = number(c->text, '.', 0) == c->end ? NUMBER : WORD;
        c++;
        r->cells++;
    }
    return r->cells;
}

/* part_by - the same, by any way. */
static int part_by(reader *r, char *text, int way)
{
    const dialect d = r->d;
    char *line = r->s.line;
    int n;

    if (way >= GAPS) return part_names(r, text, way);
    r->s.line = text;
    if (way < ROWS) {
        r->d.separator = ways[way];
        r->d.apart = 0;
        r->d.decimal = '.';
    }
    n = cut(r);
    r->d = d;
    r->s.line = line;
    return n;
}

/* by_blanks - does that way part names by single blanks, as they may have? */
static int by_blanks(const reader *r, int way)
{
    return way >= BLANKS || (way == ROWS && r->d.separator == ' ');
}

/* is_name - may the cell be one?  (Between blanks what a bracket begins is a
 * unit.)  numbers: such as 2019, too. */
static int is_name(const cell *c, int blanks, int numbers)
{
    return (c->kind != NUMBER || numbers) && c->quoted < 2 &&
           (!blanks || c->quoted || !strchr("([)]", *c->text));
}

int names_axes(reader *r)
{
    int cells = r->cells, found;

    for (r->cells = 0; r->cells < cells && r->cell[r->cells].kind != NUMBER;)
        r->cells++;
    found = axes_among(r);
    r->cells = cells;
    return found >= (r->to->axes == 2 ? 2 : 3);
}

int name_cells(reader *r, char *text, int want, int *way)
{
    int w, k, n, found, blanks, numbers, most = 0;

    *way = ROWS;
    for (w = 0; w < WAYS; w++) {
        if (w < ROWS && !strchr(text, ways[w])) continue;
        n = part_by(r, text, w);
        if (n != want && !(n == want + 1 && r->more)) continue;
        blanks = by_blanks(r, w) && !strchr("([", *r->cell[0].text);
        numbers = names_axes(r);
        for (k = 0; k < want && is_name(r->cell + k, blanks, numbers);) k++;
        if (k < want) continue;
        found = 1 + axes_among(r);
        if (found <= most) continue;
        most = found;
        *way = w;
    }
    if (most > 0) part_by(r, text, *way);
    return most;
}

/* bare_unit - is a cell of names between blanks a unit, which belongs to the
 * name before it? */
static int bare_unit(const reader *r, int way)
{
    const cell *c;

    for (c = r->cell + 1; c < r->cell + r->cells && by_blanks(r, way); c++)
        if (!c->quoted && is_unit(c->text, c->end) &&
            (c->end > c->text + 1 || *c->text == '%'))
            return 1;
    return 0; /* (one letter may be a name) */
}

/* asked_for - does an option name what is among the cells? */
static int asked_for(const reader *r)
{
    const char *list[2], *c;
    char title[TITLE];
    int i, k;

    list[0] = r->to->cols;
    list[1] = r->to->by;
    for (k = 0; k < r->cells; k++) {
        title_of(r->cell + k, title);
        for (i = 0; i < 2; i++)
            for (c = list[i]; c; c = strchr(c, ',')) {
                c += *c == ',';
                if (is_titled(title, c, strcspn(c, ","), 1)) return 1;
            }
    }
    return 0;
}

/* set_titles - of the columns from that one on, by the cells. */
static void set_titles(reader *r, int from)
{
    char *title;
    size_t end;
    int k;

    for (k = 0; k < from; k++) r->column[k].title[0] = '\0';
    for (k = from; k < r->columns; k++) {
        title = r->column[k].title;
        title_of(r->cell + k - from, title);
        /* (a name in brackets is in nothing else) */
        end = strlen(title);
        if (*title == '[' && end > 2 && strchr(title, ']') == title + end - 1) {
            memmove(title, title + 1, end - 2);
            title[end - 2] = '\0';
        }
    }
    r->shifted = from;
    r->astray = 0;
}

/* announces - does a comment's first word say that names follow?  Then where
 * they begin; else 0. */
static char *announces(char *text)
{
    static const char words[] = " fields columns names variables ";
    char word[TITLE], *end = text + strcspn(text, " \t:=");
    size_t length = (size_t)(end - text), k;

    if (length == 0 || length >= sizeof word || !*end) return 0;
    for (k = 0; k < length; k++)
        word[k] = (char)tolower((unsigned char)text[k]);
    if (*end != ':' && !listed(words, word, word + length, ' ')) return 0;
    return end + strspn(end, " \t:=");
}

/* sentence - has a cell more than two words, but for a unit? */
static int sentence(const reader *r)
{
    const cell *c = r->cell;
    const char *s;
    int blanks;

    for (; c < r->cell + r->cells; c++) {
        for (blanks = 0, s = c->text; s < c->end && *s != '(' && *s != '['; s++)
            blanks += *s == ' ' && s[1] != '(' && s[1] != '[';
        if (blanks > 1) return 1;
    }
    return 0;
}

void comment_names(reader *r, char *text, long line)
{
    int way, other, score, better, sure;
    char *behind;

    if (r->taken >= LINE_OF_NAMES) return;
    /* (what may be names is so in the last line before the rows alone) */
    if (r->taken == PERHAPS_NAMES) {
        set_titles(r, r->columns);
        r->taken = r->shifted = 0;
        r->maybe = r->noted;
        r->noted = 0;
    }
    text += strspn(text, "#%!/ \t");
    score = name_cells(r, text, r->columns, &way);
    behind = score < 3 ? announces(text) : 0;
    better = behind ? name_cells(r, behind, r->columns, &other) : 0;
    if (better > score) {
        score = better;
        way = other;
    } else if (behind)
        score = name_cells(r, text, r->columns, &way);
    if (score == 0 || score + COMMENT <= r->taken) return;
    sure = score > 2 || asked_for(r);
    if (!sure && (by_blanks(r, way) || sentence(r))) {
        r->maybe = line;
        return;
    }
    set_titles(r, 0);
    r->taken = sure ? score + COMMENT : PERHAPS_NAMES;
    r->noted = r->titled = line;
}

/* names_rows - may column 1 be the rows' names?  So it is where it has words,
 * or whole numbers, each but once. */
static int names_rows(const reader *r)
{
    return r->column[0].role == LABEL || r->unique;
}

/* Units of axes, and how many metres they are; 0: an angle. */
static const struct {
    const char *words, *name;
    double metres;
} lengths[] = {
    {" m meter meters metre metres masl mamsl ", "m", 1.0},
    {" km kilometers kilometres ", "km", 1000.0},
    {" cm ", "cm", 0.01},
    {" mm ", "mm", 0.001},
    {" ft feet foot ", "ft", 0.3048},
    {" deg degree degrees degrees_east degrees_north dd \302\260 \260 ",
     "degrees", 0.0}};

#define LENGTHS (int)(sizeof lengths / sizeof lengths[0])

/* unit_word - which of these is s ... end, perhaps in brackets; -1: none. */
static int unit_word(const char *s, const char *end)
{
    char word[TITLE];
    size_t length, k;
    int i;

    while (s < end && strchr("([ ", *s)) s++;
    for (length = 0; s + length < end && !strchr(" )]", s[length]);) length++;
    if (length == 0 || length >= TITLE) return -1;
    for (k = 0; k < length; k++) word[k] = (char)tolower((unsigned char)s[k]);
    for (i = 0; i < LENGTHS; i++)
        if (listed(lengths[i].words, word, word + length, ' ')) return i;
    return -1;
}

/* unit_of - which of these is in the title, in brackets or its last word; -1:
 * none. */
static int unit_of(const char *title)
{
    const char *s = strpbrk(title, "([");
    int i;

    for (i = 0; !s && title[i]; i++)
        if (strpbrk(title + i, " _-.,") == title + i &&
            !strpbrk(title + i + 1, " _-.,"))
            s = title + i + 1;
    return s ? unit_word(s, s + strlen(s)) : -1;
}

/* take_units - the line below the names, cut into cells, if it has units: of
 * some columns, and of others none. */
static void take_units(reader *r)
{
    const cell *c = r->cell;
    int k, many = r->cells < r->columns ? r->cells : r->columns;

    for (k = 0; k < many; k++, c++)
        if (c->kind != EMPTY && c->kind != ABSENT && !strchr("([", *c->text) &&
            unit_word(c->text, c->end) < 0 && !is_unit(c->text, c->end))
            return;
    for (k = 0; k < many; k++)
        r->column[k].unit = 1 + unit_word(r->cell[k].text, r->cell[k].end);
}

void head_names(reader *r, int last)
{
    scan *s = &r->s;
    int way, other, score, fewer = 0, cells = r->cells, torn = r->torn, k;
    int words = 1, quoted = 1, bare, less; /* are these names, one less? */

    for (k = 0; k < cells; k++)
        words &= r->cell[k].kind == WORD || r->cell[k].kind == EMPTY;
    if (last && r->columns > 2 && r->want < 0.0)
        fewer = name_cells(r, s->line, r->columns - 1, &other);
    for (k = 0; k < r->columns - 1 && fewer > 0; k++)
        quoted &= r->cell[k].quoted;
    score = name_cells(r, s->line, r->columns, &way);
    bare = score > 0 && bare_unit(r, way);
    less = fewer > 2 && fewer >= score &&
           (fewer > score || (by_blanks(r, way) && !by_blanks(r, other)) ||
            (bare && other == BARE_UNITS && names_rows(r)));
    /* (behind a count a comment is common, of any words) */
    if (score > 0 && !less &&
        (r->want < 0.0 || score > 2 || asked_for(r))) {
        s->head++;
        if (score + LINE_OF_NAMES <= r->taken) {
            take_units(r);
            return;
        }
        set_titles(r, 0);
        r->taken = score + LINE_OF_NAMES;
        r->noted = 0;
        r->titled = s->number;
        if (bare)
            warn("%s:%ld: a unit is the name of a column of its own: are there "
                 "fewer names than columns?", s->name, s->number);
        return;
    }
    if (r->want >= 0.0) {
        s->blank++;
        return;
    }
    if (fewer > 0 && r->taken < LINE_OF_NAMES &&
        (fewer > 2 || quoted || r->d.separator != ' ')) {
        if (names_rows(r)) {
            part_by(r, s->line, other);
            s->head++;
            set_titles(r, 1);
            r->taken = LINE_OF_NAMES;
            r->noted = 0;
            r->fewer = r->titled = s->number;
            return;
        }
        r->astray = 1;
    }
    if (torn > 0 && r->d.separator != ' ')
        scan_fail(s, "column %d: a quote that does not end with the cell, or "
                  "not in the line", torn);
    cut(r);
    if (cells > 1 && r->d.separator != ' ') {
        if (last && cells > 2 && words && r->taken < LINE_OF_NAMES)
            r->astray = 1;
        if (r->taken >= LINE_OF_NAMES) take_units(r);
        scan_leave(s, "names that do not match the columns in number");
        return;
    }
    if (last && r->taken < LINE_OF_NAMES && axes_among(r) > 1) r->astray = 1;
    scan_leave(s, "titles");
}

/* ----------------------------------------------------- what is said of them */

/* numbers_there - the columns of numbers that may be coordinates. */
static int numbers_there(const reader *r)
{
    int k, found = 0;

    for (k = 0; k < r->columns; k++)
        found += r->column[k].role == VALUE && k != r->by;
    return found;
}

/* called - is the column called so, a word of that list, but for marks and
 * units? */
static int called(const reader *r, int k, const char *list)
{
    char name[TITLE];

    plain(r->column[k].title, name);
    return name[0] && listed(list, name, name + strlen(name), ' ');
}

/* Where an interval of a hole begins, and ends; times. */
static const char begin_words[] =
    " from depthfrom fromdepth sampfrom geolfrom desde von ";
static const char end_words[] = " to depthto todepth sampto geolto hasta bis ";
static const char time_words[] =
    " year month day hour minute second date time datetime timestamp yyyy mm "
    "dd yr mon doy jday julianday ";

/* intervals - has the table some of holes?  Where they are in space is in other
 * files. */
static int intervals(const reader *r)
{
    int k, begins = 0, ends = 0;

    for (k = 0; k < r->columns; k++) {
        begins |= called(r, k, begin_words);
        ends |= called(r, k, end_words);
    }
    return begins && ends;
}

/* no_axis - does its name say that the column is no axis? */
static int no_axis(const reader *r, int k)
{
    return called(r, k, time_words) ||
           (intervals(r) &&
            (called(r, k, begin_words) || called(r, k, end_words)));
}

/* fill_axes - those that are not known: columns of numbers from k on, in their
 * order; sure: but for those that their names say are none. */
static void fill_axes(const reader *r, int k, int *at, int sure)
{
    int a;

    for (a = 0; a < r->axes; a++)
        for (; at[a] < 0 && k < r->columns; k++)
            if (r->column[k].role == VALUE && k != r->by && k != at[0] &&
                k != at[1] && k != at[2] && !(sure && no_axis(r, k)))
                at[a] = k;
}

/* say_so - leave: which columns are the axes is asked. */
static void say_so(const reader *r, const char *why, int *at)
{
    const cell *c = r->cell;
    const column *of = r->column;
    int k, many, none = 0, some = at[0] >= 0 || at[1] >= 0;

    warn("%s: which columns are x, y%s?  %s; there are:", r->s.name,
         r->axes == 2 ? "" : ", z", why);
    for (k = 0; k < r->columns && k < LISTED; k++) {
        many = r->waits ? (int)(c[k].end - c[k].text) : 0;
        warn("column %d%s%s: %.*s", k + 1, of[k].title[0] ? ", " : "",
             of[k].title, many < 24 ? many : 24, many > 0 ? c[k].text : "");
    }
    if (k < r->columns) warn("and %d columns more", r->columns - k);
    if (!some && intervals(r))
        fail("%s: intervals along holes have no coordinates: desurvey them "
             "first, with the holes' collars and surveys; else %s X,Y,Z says "
             "which columns to take", r->s.name, axes_option(r));
    /* (what may number the rows is no proposal) */
    k = r->unique && numbers_there(r) > r->axes;
    fill_axes(r, k, at, 1);
    if (some) fill_axes(r, k, at, 0);
    for (k = 0; k < r->axes; k++) none |= at[k] < 0;
    if (none)
        fail("%s: %s says so, as %s %s", r->s.name, axes_option(r),
             axes_option(r), r->axes == 2 ? "X,Y" : "X,Y,Z");
    fail(r->axes == 2 ? "%s: %s says so, as %s %d,%d"
                      : "%s: %s says so, as %s %d,%d,%d",
         r->s.name, axes_option(r), axes_option(r), at[0] + 1, at[1] + 1,
         at[2] + 1);
}

void place_axes(reader *r, int *at)
{
    int k, a, how, titled = 0, others = 0;

    for (k = 0; k < r->columns; k++) titled |= r->column[k].title[0] != '\0';
    r->family = -1;
    if (r->named) {
        for (k = r->columns - 1; k >= 0; k--)
            for (a = 0; a < r->axes && r->column[k].role != LABEL; a++)
                if (is_axis(r->column[k].title, a)) at[a] = k;
        for (a = 0; a < r->axes; a++)
            if (at[a] < 0)
                scan_fail(&r->s, "no column is named %c; %s chooses others",
                          "xyz"[a], axes_option(r));
        r->family = 0;
        return;
    }
    how = titled ? choose_axes(r, at) : NONE;
    for (a = 0; a < r->axes && how == FIT; a++)
        if (r->column[at[a]].role == LABEL) bad_cell(r, at[a]);
    if (how == FIT) return;
    if (how == NONE && r->nowhere)
        fail("%s: is %s", r->s.name, r->nowhere);
    for (k = a = 0; a < r->axes; a++) {
        k |= at[a] >= 0 && at[a] == r->by; /* (it is named as one of them) */
        if (at[a] >= 0 && r->column[at[a]].role != VALUE) at[a] = -1;
    }
    if (numbers_there(r) + k < r->axes) return;
    if (how == SEVERAL)
        say_so(r, "Its names say so more than once", at);
    for (a = 0; a < r->columns && titled; a++)
        others |= r->column[a].role == VALUE && no_axis(r, a);
    others = others && at[0] < 0 && at[1] < 0;
    if ((titled || r->astray) && (others || numbers_there(r) + k != r->axes))
        say_so(r, r->astray ? "Its names and its columns differ in number"
                            : "Its names do not say so", at);
    fill_axes(r, 0, at, 0);
}

/* tell_units - those of the axes, if their names say that they differ. */
static void tell_units(reader *r)
{
    int unit[3], k, angles = 0, known = 0, differ = 0;
    char text[160] = "", scale[100] = "";

    if (chosen.scaled || r->to->bare || r->to->n == 0) return;
    for (k = 0; k < r->axes; k++) {
        unit[k] = unit_of(r->column[r->use[k]].title);
        if (unit[k] < 0) unit[k] = r->column[r->use[k]].unit - 1;
        /* (lon, lat) */
        if (unit[k] < 0 && k < 2 && r->family == GLOBE) unit[k] = LENGTHS - 1;
        if (unit[k] >= 0) {
            known++;
            angles += lengths[unit[k]].metres == 0.0;
        }
        differ |= unit[k] != unit[0];
        sprintf(text + strlen(text), k ? ", %s" : "%s",
                unit[k] < 0 ? "other units" : lengths[unit[k]].name);
    }
    if (!differ || known == 0 || (known < r->axes && angles == 0)) return;
    r->to->doubted = 1;
    if (angles > 0) {
        warn("%s: x, y%s are in %s, and the mesh takes them as the same: "
             "stretch them, as -scale 1,1,0.01 makes 100 of z as much as a "
             "degree", r->to->input, r->axes == 3 ? ", z" : "", text);
        return;
    }
    for (k = 0; k < r->axes; k++)
        sprintf(scale + strlen(scale), k ? ",%.6g" : "%.6g",
                lengths[unit[k]].metres / lengths[unit[0]].metres);
    warn("%s: x, y%s are in %s, and the mesh takes them as the same: -scale "
         "%s makes them so", r->to->input, r->axes == 3 ? ", z" : "", text,
         scale);
}

int is_globe(const reader *r)
{
    return r->family == GLOBE;
}

/* tell_globe - places that are on no globe: their names, or units, are not what
 * they seem. */
static void tell_globe(const reader *r)
{
    static const double most[] = {360.0, 90.0};
    const points *to = r->to;
    double x, far;
    tess_int i;
    int k;

    for (k = 0; k < 2 && r->family == GLOBE; k++) {
        for (far = 0.0, i = 0; i < to->n; i++) {
            x = number_of(to, k, i);
            if (fabs(x) <= DBL_MAX && fabs(x) > fabs(far)) far = x;
        }
        if (fabs(far) > most[k])
            warn("%s: %s goes to %.9g, and %s ends at %.0f degrees: are columns "
                 "exchanged, or are they degrees and minutes?", to->input,
                 r->column[r->use[k]].title, far, k ? "latitude" : "longitude",
                 most[k]);
    }
}

/* tell_seam - longitudes on both sides of where they begin anew, and none on
 * the other side of the globe: points that are near are far apart. */
static void tell_seam(const reader *r)
{
    const points *to = r->to;
    double x, low = DBL_MAX, high = -DBL_MAX, middle, west, east;
    tess_int i;
    long many = 0;

    if (!is_globe(r)) return;
    for (i = 0; i < to->n; i++) {
        x = number_of(to, 0, i);
        if (x < low) low = x;
        if (x > high && x <= DBL_MAX) high = x;
    }
    middle = low / 2.0 + high / 2.0;
    west = low;
    east = high;
    for (i = 0; i < to->n; i++) {
        x = number_of(to, 0, i);
        if (x < middle && x > west) west = x;
        if (x >= middle && x < east) east = x;
        many += x >= middle;
    }
    if (high - low <= 360.0 && east - west > SEAM)
        warn("%s: %s is in %.9g to %.9g and %.9g to %.9g, and nowhere between, "
             "so that neighbours on the globe are far apart in the mesh: take "
             "360 from the larger ones (%ld)", to->input,
             r->column[r->use[0]].title, low, west, east, high, many);
}

/* tell_heights - another column that its name says is the third axis. */
static void tell_heights(const reader *r)
{
    const column *c = r->column;
    int k, z = r->use[2];

    if (r->axes < 3 || r->family < 0 || families[r->family].marked) return;
    for (k = 0; k < r->columns; k++)
        if (c[k].role == VALUE && k != z && !c[k].apart &&
            (rank_of(c[k].title, families + LOCAL, 2) == 0 ||
             rank_of(c[k].title, families + LOCAL, 2) == 1)) {
            warn("%s: z is column %d, %s, though column %d, %s, might be, "
                 "too; %s chooses", r->to->input, z + 1, c[z].title, k + 1,
                 c[k].title, axes_option(r));
            return;
        }
}

void tell_columns(reader *r)
{
    points *to = r->to;
    const column *c = r->column;
    const int *at = r->use;
    char numbers[48], titles[3 * TITLE + 8], more[2 * TITLE + 60] = "";
    int k, titled = 0, usual = r->family >= 0, last = r->axes - 1;

    if (r->noted > 0 && to->n > 0)
        warn("%s:%ld: names of columns, from a comment", r->s.name, r->noted);
    if (r->shifted && to->n > 0)
        warn("%s:%ld: one name less than columns: the first column is the "
             "rows' names, as R writes them", r->s.name, r->fewer);
    tell_units(r);
    if (!to->scratch) {
        tell_globe(r);
        tell_seam(r);
    }
    if (to->cols || to->n == 0) return;
    tell_heights(r);
    numbers[0] = titles[0] = '\0';
    for (k = 0; k <= last; k++) {
        titled |= c[at[k]].title[0] != '\0';
        usual = usual && at[k] == at[0] + k;
        sprintf(numbers + strlen(numbers), k ? ", %d" : "%d", at[k] + 1);
        sprintf(titles + strlen(titles), k ? ", %s" : "%s", c[at[k]].title);
    }
    usual = usual && !families[r->family].told && !r->rivals && r->twin < 0;
    if (r->twin >= 0)
        sprintf(more, "; column %d is called %s, too", r->twin + 1,
                c[r->twin].title);
    if (r->rivals) strcpy(more, "; by their names others might be, too");
    if ((titled && !usual) || (at[last] != at[0] + last && r->number < 0))
        warn("%s: x, y%s are the columns %s%s%s%s; %s chooses others%s%s",
             to->input, last == 1 ? "" : ", z", numbers, titled ? " (" : "",
             titled ? titles : "", titled ? ")" : "", axes_option(r), more,
             r->family >= 0 || last == 1 || to->columns > 0 ||
                     !is_axis(c[at[0]].title, 0) || !is_axis(c[at[1]].title, 1)
                 ? ""
             : to->bare ? "; if they are in a plane: -qcols X,Y"
                        : "; if they are in a plane: -plane");
    if (!titled && r->maybe > 0 && (to->columns > 0 || to->bare))
        warn("%s:%ld: if the comment names the columns, it does not say which "
             "are x, y%s: %s are taken; %s chooses others",
             to->input, r->maybe, last == 1 ? "" : ", z", numbers,
             axes_option(r));
    if (!titled && to->by && r->by < at[last])
        warn("%s: x, y%s are the columns %s: column %d is -by's; %s chooses "
             "others", to->input, last == 1 ? "" : ", z", numbers, r->by + 1,
             axes_option(r));
}
