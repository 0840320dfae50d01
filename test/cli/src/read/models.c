/* models.c - points of models: GOCAD's objects, Nastran's grid points. */
#include <ctype.h>
#include <string.h>

#include "read.h"

/* ---- GOCAD ---- */

/* gocad_word - what a line that begins so is: 'v' a vertex, 'f' a face, 'h' the
 * head's, 'o' another one, 'e' the end; 0: it is not known. */
static char gocad_word(const cell *c)
{
    static const char words[] =
        " VRTX=v PVRTX=v TRGL=f TETRA=f SEG=o ATOM=o PATOM=o BSTONE=o "
        "BORDER=o CONTROL_POINT=o TFACE=h ILINE=h SUBVSET=h TVOLUME=h "
        "GOCAD=h HEADER=h HDR=h NAME=h AXIS_NAME=h AXIS_UNIT=h ZPOSITIVE=h "
        "PROPERTIES=h PROP_KINDS=h PROPERTY_KINDS=h PROPERTY_CLASSES=h "
        "UNITS=h ESIZES=h NO_DATA_VALUES=h PROJECTION=h DATUM=h "
        "PROP_LEGAL_RANGES=h PROPERTY_SUBCLASSES=h END=e ";
    const char *at = listed(words, c->text, c->end, '=');

    if (at) return *at;
    return (char)(cell_is(c, "GOCAD_ORIGINAL_COORDINATE_SYSTEM") ||
                  cell_is(c, "END_ORIGINAL_COORDINATE_SYSTEM") ||
                  cell_is(c, "PROPERTY_CLASS_HEADER") ? 'h' : 0);
}

/* properties - of points, each of so many numbers: what the head says of them,
 * line by line. */
typedef struct properties {
    int many, told[3]; /* names, and what is below: how many there are */
    char title[COLUMNS][TITLE];
    double size[COLUMNS], lacking[COLUMNS];
} properties;

/* property_line - the line may say what properties are called, how many numbers
 * each has, and which stand for none.  A further object must have the same. */
static void property_line(reader *r, properties *p)
{
    static const char *const keys[] = {"PROPERTIES", "ESIZES",
                                       "NO_DATA_VALUES"};
    const cell *c = r->cell + 1;
    char title[TITLE];
    int k, i, same = 1, many = r->cells - 1;

    for (k = 0; k < 3 && !cell_is(r->cell, keys[k]);) k++;
    if (k == 3) return;
    if (many > COLUMNS - 5)
        scan_fail(&r->s, "more than %d columns", COLUMNS);
    for (i = 0; i < many; i++, c++) {
        title_of(c, title);
        if (k > 0 && c->kind != NUMBER)
            scan_fail(&r->s, "%s: \"%.*s\": not a number", keys[k], SHOWN(c));
        same &= k == 0   ? strcmp(p->title[i], title) == 0
                : k == 1 ? p->size[i] == c->x
                         : p->lacking[i] == c->x;
        if (k == 0) strcpy(p->title[i], title);
        else if (k == 1) p->size[i] = c->x;
        else p->lacking[i] = c->x;
    }
    if (r->columns > 0 && (!same || p->told[k] != many))
        scan_fail(&r->s, "%s are not those of the object before", keys[k]);
    p->told[k] = many;
}

/* vertex_columns - as the first vertex, and the head, say. */
static void vertex_columns(reader *r, const properties *p)
{
    column *c;
    int k;
    double j;
    char title[TITLE + 8];

    for (k = 1; k < 3; k++)
        if (p->told[k] > 0 && p->told[k] != p->told[0])
            scan_fail(&r->s, "%d PROPERTIES, but %s of %d", p->told[0],
                      k == 1 ? "ESIZES" : "NO_DATA_VALUES", p->told[k]);
    r->to->copied = 0;
    add_column(r, "VRTX")->role = UNUSED;
    add_column(r, "number")->role = UNUSED;
    add_axes(r, 0, 0);
    for (k = 0; k < p->told[0] && cell_is(r->cell, "PVRTX"); k++)
        for (j = 0.0; j < (p->told[1] > 0 ? p->size[k] : 1.0); j++) {
            sprintf(title, p->told[1] > 0 && p->size[k] > 1.0 ? "%.30s%.0f"
                                                               : "%.39s",
                    p->title[k], j + 1.0);
            c = add_column(r, title);
            c->lacks = p->told[2] > 0;
            c->lacking = p->lacking[k];
        }
    take_columns(r);
}

/* vertex - a row.  Its number is one more than the one before, by which faces
 * know their vertices, or there is no surface. */
static void vertex(reader *r)
{
    points *to = r->to;
    double number;
    int k;

    for (k = 5; k < r->columns; k++) take_lacking(r, k);
    if (!cell_whole(r->cell + 1, &number))
        scan_fail(&r->s, "\"%.*s\": not the number of a vertex",
                  SHOWN(r->cell + 1));
    if (to->n == 0) r->last_number = number;
    else if (number != r->last_number + (double)to->n) to->surfaced = 0;
    take_row(r);
}

void read_gocad(reader *r)
{
    scan *s = &r->s;
    properties *p = (properties *)space(1.0, sizeof *p);
    double corner;
    int n, deep = 0, ended = 0, k;
    char word;

    memset(p, 0, sizeof *p);
    while ((n = next_cells(r)) > 0) {
        word = gocad_word(r->cell);
        if (deep > 0) word = 'h';
        deep += strchr(s->line, '{') != 0;
        if (word == 'h' && strchr(s->line, '}')) deep--;
        ended = word == 'e' || (ended && word == 0);
        if (word == 'h' || word == 'e') {
            s->head++;
            if (cell_is(r->cell, "GOCAD") && r->columns == 0)
                memset(p, 0, sizeof *p);
            if (deep == 0) property_line(r, p);
            if (n == 2 && cell_is(r->cell, "ZPOSITIVE") &&
                cell_is(r->cell + 1, "Depth"))
                warn("%s:%ld: z is depth, which grows downwards", s->name,
                     s->number);
        } else if (word == 'v') {
            if (r->columns == 0) vertex_columns(r, p);
            if (n != r->columns)
                scan_fail(s, "%d columns, but others have %d", n, r->columns);
            vertex(r);
        } else {
            for (k = 1; k < 4 && n == 4 && cell_is(r->cell, "TRGL"); k++)
                take_corner(r, cell_whole(r->cell + k, &corner)
                                   ? corner - r->last_number : -1.0, k - 1);
            scan_leave(s, word == 'f'   ? "faces"
                          : word == 'o' ? "other lines"
                                        : "lines of unknown words");
        }
    }
    if (!ended) warn("%s: no END at its end: is the file cut?", s->name);
}

/* ---- Nastran ---- */

/* nastran_number - the cell is a field: the number's exponent may have no
 * letter; what is blank is 0. */
static void nastran_number(cell *c)
{
    char text[64], held = *c->end, *sign;
    size_t length = (size_t)(c->end - c->text);

    c->quoted = 0;
    c->x = 0.0;
    c->kind = NUMBER;
    *c->end = '\0';
    if (length > 0 && number(c->text, '.', &c->x) < c->end) {
        cell_kind(c, '.');
        sign = length < 60 ? strpbrk(c->text + 1, "+-") : 0;
        if (sign && isdigit((unsigned char)sign[1]) &&
            (sign[-1] == '.' || isdigit((unsigned char)sign[-1]))) {
            sprintf(text, "%.*se%s", (int)(sign - c->text), c->text, sign);
            if (number(text, '.', &c->x) == text + length + 1) c->kind = NUMBER;
        }
    }
    *c->end = held;
}

/* is_wide - are the fields of the card's line of 16 columns? */
static int is_wide(const scan *s)
{
    return memchr(s->line, '*', s->stop - s->line > 8
                                    ? 8 : (size_t)(s->stop - s->line)) != 0;
}

/* fields - of a card's line, at most so many: commas are between them, or each
 * has 8 columns, or 16 but for the first one.  From first on they are numbers.
 * Returns how many. */
static int fields(reader *r, int first, int most)
{
    scan *s = &r->s;
    cell *c = r->cell;
    char *p = s->line;
    int n, k, wide = is_wide(s) ? 16 : 8;

    if (wide > 8 && most > 5) most = 5; /* (then it goes on in the next line) */

    p += strspn(p, " ");
    if (p[strcspn(p, " \t,")] == ',') {
        for (n = 0; n < most; n++, c++) {
            p += strspn(p, " \t");
            c->text = p;
            p += strcspn(p, ",");
            for (c->end = p; c->end > c->text && c->end[-1] == ' ';) c->end--;
            nastran_number(c);
            if (!*p++) return n + 1;
        }
        return n;
    }
    p = s->line;
    for (n = 0, k = 1; n < most && k <= (int)(s->stop - p); n++, c++) {
        cut_fixed(s, k, n == 0 ? 8 : k + wide - 1, c);
        if (n >= first) nastran_number(c);
        k += n == 0 ? 8 : wide;
    }
    return n;
}

/* card - is the line one of that name?  It has 8 columns, with * behind if the
 * fields are wide; or a comma ends it. */
static int card(const scan *s, const char *name)
{
    const char *c = s->line + strspn(s->line, " "), *end;
    size_t n = strlen(name), k;

    for (k = 0; k < n && toupper((unsigned char)c[k]) == name[k];) k++;
    if (k < n) return 0;
    end = c + n + strspn(c + n, " \t*");
    return !*end || *end == ',' || end >= s->line + 8;
}

/* no_card - is the line a comment, or blank? */
static int no_card(const scan *s)
{
    return *s->line == '$' || !s->line[strspn(s->line, " \t")];
}

/* grid_point - is the line one, as a card of it is? */
static int grid_point(reader *r)
{
    scan *s = &r->s;
    double x;
    int n, k;

    if (!card(s, "GRID")) return 0;
    n = fields(r, 1, 6);
    if (n < 4 || !cell_whole(r->cell + 1, &x)) return 0;
    if (r->cell[2].text < r->cell[2].end && !cell_whole(r->cell + 2, &x))
        return 0;
    for (k = 3; k < n; k++)
        if (r->cell[k].kind != NUMBER) return 0;
    return 1;
}

int is_nastran(reader *r)
{
    scan *s = &r->s;

    while (in_sample(s) && scan_line(s)) {
        if (no_card(s)) continue;
        if (grid_point(r)) return 1;
        if (card(s, "BEGIN BULK")) return 1;
        if (!isalpha((unsigned char)*s->line) && !strchr("+* ", *s->line))
            return 0;
    }
    return 0;
}

/* in_basic - leave if the card's field says that coordinates are in a system of
 * its own. */
static void in_basic(const reader *r, int field, int n)
{
    const cell *c = r->cell + field;

    if (field < n && c->text < c->end && !cell_is(c, "0"))
        scan_fail(&r->s, "coordinates in system %.*s, which are not read: "
                  "write them in the basic one", SHOWN(c));
}

/* hollow_fields - those from n on, that the line has not, are blank. */
static void hollow_fields(reader *r, int n, int most)
{
    for (; n < most; n++) {
        r->cell[n].text = r->cell[n].end = r->s.stop;
        nastran_number(r->cell + n);
    }
}

/* go_on - z of a grid point is in the next line; what else there is stays. */
static void go_on(reader *r)
{
    scan *s = &r->s;

    s->rows++;
    do {
        if (!scan_line(s))
            fail("%s: ends in the midst of a grid point", s->name);
        s->blank += no_card(s);
    } while (no_card(s));
    if (*s->line != '*')
        scan_fail(s, "\"%.40s\": where * goes on with a grid point", s->line);
    hollow_fields(r, fields(r, 1, 2), 2);
    r->cell[5] = r->cell[1];
}

void read_nastran(reader *r)
{
    scan *s = &r->s;
    double hollow = 0.0;
    long first = 0;
    int n, k, ended = 0;

    r->to->copied = 0;
    add_column(r, "GRID")->role = UNUSED;
    add_column(r, "number")->role = UNUSED;
    add_column(r, "CP")->role = UNUSED;
    add_axes(r, 0, 0);
    take_columns(r);
    r->form = FIXED;
    while (!ended && scan_line(s)) {
        if (no_card(s)) {
            s->blank++;
        } else if (card(s, "ENDDATA")) {
            s->head++;
            ended = 1;
        } else if (card(s, "GRDSET")) {
            in_basic(r, 2, fields(r, 1, 3));
            scan_leave(s, "other cards");
        } else if (!card(s, "GRID"))
            scan_leave(s, "other cards");
        else {
            n = fields(r, 1, 6);
            if (n < 2 || r->cell[1].kind != NUMBER)
                scan_fail(s, "\"%.40s\": not a grid point", s->line);
            in_basic(r, 2, n);
            hollow_fields(r, n, 6);
            for (k = 3; k < 6; k++)
                if (r->cell[k].kind != NUMBER) bad_cell(r, k);
            if (is_wide(s)) go_on(r);
            for (k = 3; k < 6 && r->cell[k].text < r->cell[k].end;) k++;
            if (k < 6 && hollow++ == 0.0) first = s->number;
            take_row(r);
        }
    }
    if (hollow > 0.0)
        warn("%s:%ld: grid points with a blank coordinate, which is 0: %.0f",
             s->name, first, hollow);
    scan_rest(s, "lines behind ENDDATA");
}
