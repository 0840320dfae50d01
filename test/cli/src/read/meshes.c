/* meshes.c - points of surfaces and meshes: OFF, PLY, OBJ, STL, TetGen's .node.
 */
#include <ctype.h>
#include <string.h>

#include "read.h"

#define ELEMENTS 9        /* of PLY, and their properties */
#define PROPERTIES 64
#define LONGEST_LIST 1e8  /* bytes */

void take_corner(reader *r, double i, int k)
{
    points *to = r->to;
    tess_int *face;

    if (!to->surfaced) return;
    if (!(i >= 0.0 && i < (double)to->n)) {
        warn("%s:%ld: a face has a point that is not there: no surface",
             r->s.name, r->s.number);
        to->surfaced = 0;
        return;
    }
    if (k > 1) {
        if (3.0 * to->faces + 3.0 > r->face_room) {
            r->face_room = 2.0 * r->face_room + 3000.0;
            to->face = (tess_int *)more_space(to->face, r->face_room,
                                              sizeof *to->face);
        }
        face = to->face + (size_t)(3.0 * to->faces);
        face[0] = r->fan[0];
        face[1] = r->fan[1];
        face[2] = (tess_int)i;
        to->faces += 1.0;
        k = 1;
    }
    r->fan[k] = (tess_int)i;
}

/* rest - the lines behind the points: so many of them are faces, or what it is,
 * each with as many corners as it says; what is more is told as that; so it is
 * if some lack.  Of a surface are so many, behind some; their corners, and the
 * number of these, are behind some cells. */
static void rest(reader *r, double faces, const char *what, double before,
                 double of, int first)
{
    scan *s = &r->s;
    const cell *c = r->cell + first;
    double found, corners, i;
    int k;

    for (found = 0.0; next_cells(r) > 0; found++) {
        if (found >= before && found < before + of && r->to->surfaced) {
            if (r->cells <= first || !cell_whole(c, &corners) ||
                corners >= (double)(r->cells - first))
                corners = -1.0;
            if (corners < 0.0) take_corner(r, -1.0, 0);
            for (k = 1; k <= (int)corners; k++)
                take_corner(r, cell_whole(c + k, &i) ? i : -1.0, k - 1);
        }
        if (found >= faces)
            scan_leave(s, "lines behind all that is announced");
        else if (strcmp(what, "faces") == 0 &&
                 (!cell_whole(r->cell, &corners) ||
                  corners >= (double)r->cells))
            scan_leave(s, "faces of fewer corners than they say");
        else
            scan_leave(s, what);
    }
    if (found < faces)
        warn("%s: announces %.0f %s, has %.0f: is the file cut?", s->name,
             faces, what, found);
}

/* ---- OFF ---- */

/* off_word - how many characters of the text are the word of such a file; 0: it
 * is none. */
static size_t off_word(const char *s)
{
    size_t n = strncmp(s, "ST", 2) == 0 ? 2 : 0;
    const char *c;

    for (c = "CN4n"; *c; c++) n += s[n] == *c;
    return strncmp(s + n, "OFF", 3) == 0 ? n + 3 : 0;
}

int is_off(reader *r)
{
    int n = first_cells(r);
    const cell *c = r->cell;
    size_t word = n > 0 ? off_word(c->text) : 0;
    double x;

    if (word == 0) return 0;
    if (c->text + word < c->end)
        return isdigit((unsigned char)c->text[word]) != 0;
    return n == 1 || cell_is(c + 1, "BINARY") || cell_whole(c + 1, &x);
}

void read_off(reader *r)
{
    scan *s = &r->s;
    cell *c = r->cell;
    double number[3];
    int n = need_cells(r), k, found = 0, plain;
    size_t word = off_word(c->text);
    char head[8];
    const char *title;

    sprintf(head, "%.*s", (int)word, c->text);
    if (strpbrk(head, "4n") || (n > 1 && cell_is(c + 1, "BINARY")))
        scan_fail(s, "%.20s: not an OFF file of points in space, in ASCII",
                  s->line);
    c->text += word;
    for (k = c->text == c->end;; k = 0) {
        for (; k < n; k++, found++)
            if (found == 3 || !cell_whole(c + k, number + found))
                scan_fail(s, "\"%.*s\": not a number of points, faces, edges",
                          SHOWN(c + k));
        if (found == 3) break;
        n = need_cells(r);
    }
    r->want = number[0];
    scan_room(s, r->want, 6.0);
    scan_pin(s);
    n = next_cells(r);
    scan_go(s);
    add_axes(r, 0, 0);
    plain = head[0] == 'O';
    while (r->columns < n) {
        title = plain                                  ? ""
                : strchr(head, 'N') && r->columns < 6 ? "normal"
                                                       : "colour";
        add_column(r, title)->role = plain ? VALUE : UNUSED;
    }
    if (!plain) scan_note(s, "normals, colours or the like", number[0], 0);
    take_all(r, 0);
    rest(r, number[1], "faces", 0.0, number[1], 0);
}

/* ---- PLY ---- */

/* property - of which element; its type and bytes, and those of a list's count
 * (0 bytes: it is no list). */
typedef struct property {
    int element, corners; /* is it the list of a face's corners? */
    int bytes, count_bytes;
    char type, count_type;
} property;

/* ply_type - the type of that name; its bytes, 0 if there is none. */
static int ply_type(const cell *name, char *type)
{
    static const char types[] =
        " char=i1 int8=i1 uchar=u1 uint8=u1 short=i2 int16=i2 ushort=u2 "
        "uint16=u2 int=i4 int32=i4 uint=u4 uint32=u4 float=f4 float32=f4 "
        "double=f8 float64=f8";
    const char *at = listed(types, name->text, name->end, '=');

    if (!at) return 0;
    *type = at[0];
    return at[1] - '0';
}

/* ply_property - what the line says of one, whose element faces may be. */
static void ply_property(reader *r, property *p, int of_face)
{
    const cell *c = r->cell + 1;
    int n = r->cells, list = n > 1 && cell_is(c, "list"), k = list ? 2 : 0;

    p->count_bytes = list && n > 2 ? ply_type(c + 1, &p->count_type) : 0;
    p->bytes = n == 3 + k ? ply_type(c + k, &p->type) : 0;
    p->corners = of_face && list && n == 5 &&
                 (cell_is(c + 3, "vertex_indices") ||
                  cell_is(c + 3, "vertex_index"));
    /* (what numbers points, or counts, is whole) */
    if (!p->bytes || (p->corners && p->type == 'f') ||
        (list && (!p->count_bytes || p->count_type == 'f')))
        scan_fail(&r->s, "not a property of a PLY file");
}

/* pass - so many bytes of what it is; NULL if the file ends before. */
static const char *pass(reader *r, double bytes, const char *what)
{
    const char *at = scan_take(&r->s, (size_t)bytes);

    if (at) scan_note(&r->s, what, bytes, 1);
    return at;
}

/* walk - the elements behind the points of a binary file, so many of each: what
 * they are; the faces are kept.  Returns 0 if the file ends before. */
static int walk(reader *r, const double *each, const property *list,
                const property *end, const char *what)
{
    double i, n;
    const property *p, *next;
    const char *byte;
    int k;

    for (; list < end; list = next) {
        for (next = list; next < end && next->element == list->element;) next++;
        for (i = 0.0; i < each[list->element]; i++)
            for (p = list; p < next; p++) {
                n = 1.0;
                if (p->count_bytes) {
                    byte = pass(r, p->count_bytes, what);
                    n = byte ? stored(byte, p->count_type, p->count_bytes,
                                      r->big) : -1.0;
                }
                if (n < 0.0 || n * p->bytes > LONGEST_LIST) return 0;
                byte = pass(r, n * p->bytes, what);
                if (!byte) return 0;
                for (k = 0; p->corners && k < (int)n; k++)
                    take_corner(r, stored(byte + k * p->bytes, p->type,
                                          p->bytes, r->big), k < 2 ? k : 2);
            }
    }
    return 1;
}

void read_ply(reader *r)
{
    scan *s = &r->s;
    double others = 0.0, each[ELEMENTS], n;
    double before = 0.0, faces = 0.0; /* elements before the faces; faces */
    property list[PROPERTIES], *p = list;
    /* in lines: of a face what is ahead of the corners (-1: who knows) */
    int ahead = 0, first = -1;
    int elements = 0, in_face = 0, found = 0, many, packed = -1, whole;
    const char *what = "faces";
    char title[TITLE];
    cell *c = r->cell;

    need_line(r);
    for (s->head = 2.0;; s->head++) {
        need_line(r);
        many = cut(r);
        if (many == 0 || cell_is(c, "comment") || cell_is(c, "obj_info")) {
            s->head--;
            s->blank++;
        } else if (cell_is(c, "end_header") && many == 1)
            break;
        else if (cell_is(c, "format")) {
            r->big = many > 1 && cell_is(c + 1, "binary_big_endian");
            packed = r->big ||
                     (many > 1 && cell_is(c + 1, "binary_little_endian"));
            if (many != 3 || !cell_is(c + 2, "1.0") ||
                (!packed && !cell_is(c + 1, "ascii")))
                scan_fail(s, "not a format of PLY files");
        } else if (cell_is(c, "element") && many == 3 &&
                   cell_whole(c + 2, &n)) {
            if (elements == 0 && !cell_is(c + 1, "vertex"))
                scan_fail(s, "points must be the first element of a PLY file");
            if (elements == ELEMENTS)
                scan_fail(s, "more than %d elements", ELEMENTS);
            in_face = elements > 0 && cell_is(c + 1, "face");
            if (in_face) {
                before = others;
                faces = n;
            } else if (elements > 0)
                what = "other elements";
            if (elements > 0) others += n;
            each[elements++] = n;
        } else if (!cell_is(c, "property") || elements == 0)
            scan_fail(s, "\"%.40s\": not a line of a PLY file's head", s->line);
        else {
            if (elements == 1 && many > 1 && cell_is(c + 1, "list"))
                scan_fail(s, "a list is not a property that points may have");
            if (p == list + PROPERTIES)
                scan_fail(s, "more than %d properties", PROPERTIES);
            ply_property(r, p, in_face);
            if (elements == 1) {
                title_of(c + 2, title);
                add_packed(r, title, p->type, p->bytes);
                continue;
            }
            p->element = elements - 1;
            found += p->corners;
            if (p->corners) first = ahead;
            else if (in_face) ahead = p->count_bytes || ahead < 0 ? -1
                                                                  : ahead + 1;
            p++;
        }
    }
    if (found != 1 || (!packed && first < 0)) r->to->surfaced = 0;
    if (packed < 0) fail("%s: no format in the PLY file's head", s->name);
    if (elements == 0)
        fail("%s: no element vertex in the PLY file's head", s->name);
    r->named = 1;
    r->want = each[0];
    r->form = packed ? PACKED : LINES;
    take_all(r, 0);
    if (!packed) {
        rest(r, others, what, before, faces, first);
        return;
    }
    whole = walk(r, each, list, p, what);
    if (!whole) {
        warn("%s: announces %.0f %s, but ends before: is the file cut?",
             s->name, others, what);
        r->to->surfaced = 0;
    }
    scan_rest(s, whole ? "bytes behind all that is announced" : what);
}

/* ---- OBJ ---- */

/* obj_word - what a line that begins so is: 'v' a point, 'f' a face, 'o'
 * another one; 0: it is not known. */
static char obj_word(const cell *c)
{
    static const char words[] =
        " vt vn vp deg bmat step cstype p l curv curv2 surf parm trim hole "
        "scrv sp end con g s mg o bevel c_interp d_interp lod usemtl mtllib "
        "usemap maplib shadow_obj trace_obj ctech stech call csh ";

    if (c->end == c->text + 1 && (*c->text == 'v' || *c->text == 'f'))
        return *c->text;
    return (char)(listed(words, c->text, c->end, ' ') ? 'o' : 0);
}

int is_obj(reader *r)
{
    scan *s = &r->s;
    int n = first_cells(r);
    char word = (char)(n > 0 ? obj_word(r->cell) : 0);

    if (!word || n < (word == 'o' ? 2 : 4)) return 0;
    scan_again(s);
    while (in_sample(s) && scan_line(s)) {
        if (s->line[0] != 'v' || (s->line[1] != ' ' && s->line[1] != '\t'))
            continue;
        if (cut(r) > 3 &&
            (r->cell[1].kind == NUMBER || r->cell[2].kind == NUMBER))
            return 1;
    }
    return word == 'o' && n == 2 && ends_in(s->name, ".obj");
}

/* obj_face - its corners: numbers from 1 on, or back from the last point; what
 * is behind a slash is of textures and normals. */
static void obj_face(reader *r)
{
    int n = cut(r), k;
    const char *s, *end;
    double x;

    for (k = 1; k < n; k++) {
        s = r->cell[k].text;
        for (end = s; end < r->cell[k].end && *end != '/';) end++;
        if (!whole(s + (*s == '-'), end, &x)) x = 0.0;
        take_corner(r, *s == '-' ? (double)r->to->n - x : x - 1.0, k - 1);
    }
}

/* points_in_lines - the columns of lines that begin with a word. */
static void points_in_lines(reader *r, const char *word)
{
    r->to->copied = 0;
    r->begins = word;
    add_column(r, word)->role = UNUSED;
    add_axes(r, 0, 0);
    take_columns(r);
}

void read_obj(reader *r)
{
    scan *s = &r->s;
    cell *c = r->cell;
    int n, k;
    char word;

    s->joins = 1;
    points_in_lines(r, "v");
    while (scan_line(s)) {
        c->text = s->line + strspn(s->line, " \t");
        c->end = c->text + strcspn(c->text, " \t");
        word = obj_word(c);
        if (!*c->text || *c->text == '#') {
            s->blank++;
        } else if (word == 'v') {
            n = cut(r);
            if (n != 4 && n != 5 && n != 7 && n != 8)
                scan_fail(s, "v has 3 numbers, a weight, a colour: not %d",
                          n - 1);
            for (k = 4; k < n; k++)
                if (c[k].kind != NUMBER) {
                    r->columns = n;
                    bad_cell(r, k);
                }
            if (n > 4) scan_note(s, "weights and colours", 1.0, 0);
            take_row(r);
        } else {
            if (word == 'f' && r->to->surfaced) obj_face(r);
            scan_leave(s, word == 'f'   ? "faces"
                          : word == 'o' ? "normals, groups or the like"
                                        : "lines of unknown words");
        }
    }
}

/* ---- STL ---- */

void read_stl(reader *r)
{
    /* the lines in turn: their words, and so many cells; 0: any */
    static const struct {
        const char *word, *second;
        int cells;
    } lines[] = {{"solid", "", 0}, {"facet", "normal", 5}, {"outer", "loop", 2},
                 {"vertex", "", 4}, {"vertex", "", 4}, {"vertex", "", 4},
                 {"endloop", "", 1}, {"endfacet", "", 1}, {"endsolid", "", 0}};
    scan *s = &r->s;
    int at = 8, cells;

    points_in_lines(r, "vertex");
    for (;;) {
        /* behind a facet another one or the end, behind that another solid */
        at = at == 8 ? 0 : at + 1;
        r->skims = lines[at].cells != 4; /* (a normal's numbers are not used) */
        if (next_cells(r) == 0) break;
        if (at == 1 && cell_is(r->cell, "endsolid")) at = 8;
        if (at == 8 && cell_is(r->cell, "facet")) at = 1;
        cells = lines[at].cells;
        if (!cell_is(r->cell, lines[at].word) || (cells && r->cells != cells) ||
            (*lines[at].second && !cell_is(r->cell + 1, lines[at].second)))
            scan_fail(s, "\"%.40s\": where STL has %s%s%s%s%s", s->line,
                      at == 8 ? "facet or " : "", lines[at].word,
                      *lines[at].second ? " " : "", lines[at].second,
                      cells > 2 ? " and three numbers" : "");
        if (cells == 4) take_row(r);
        else scan_leave(s, "faces");
    }
    if (at > 0) scan_fail(s, "the solid has no end: is the file cut?");
    r->to->faces = (double)(r->to->n / 3);
}

/* facets - of binary STL, in either order of bytes; -1 if the file's size is
 * that of none. */
static double facets(reader *r, int *big)
{
    double number = 0.0, size = r->s.size, room = (double)(r->s.end - r->s.at);

    if (room < 84.0) return -1.0;
    if (size < 0.0 && r->s.ended) size = room;
    for (*big = 1; *big >= 0; --*big) {
        number = stored(r->s.at + 80, 'u', 4, *big);
        if (size == 84.0 + 50.0 * number) return number;
    }
    *big = 0;
    return size < 0.0 && number > 0.0 ? number : -1.0;
}

int is_packed_stl(reader *r)
{
    int big;

    if (!is_unknown(r)) return 0;
    if (facets(r, &big) >= 0.0) return 1;
    if (ends_in(r->s.name, ".stl"))
        fail("%s: no binary STL: its size is not 84 and 50 times the number of "
             "facets: is the file cut?", r->s.name);
    return 0;
}

void read_packed_stl(reader *r)
{
    double n = facets(r, &r->big);

    scan_take(&r->s, 84);
    /* a record is a facet: 12 bytes of its normal, three points, two bytes */
    r->stride = 12.0;
    add_axes(r, 'f', 4);
    r->stride = r->share = 12.0;
    r->record = 50.0;
    r->per = 3.0;
    r->form = PACKED;
    r->want = 3.0 * n;
    take_all(r, 0);
    scan_note(&r->s, "faces", 14.0 * n, 1);
    r->to->faces = (double)(r->to->n / 3);
    scan_rest(&r->s, "bytes behind the facets");
}

/* ---- TetGen ---- */

/* node_head - what the first line, cut, says: points, 3, values, markers. */
static int node_head(const reader *r, int n, double *head)
{
    int k;

    head[2] = head[3] = 0.0;
    for (k = 0; k < n; k++)
        if (k > 3 || !cell_whole(r->cell + k, head + k)) return 0;
    return n > 1 && head[3] <= 1.0 && head[2] <= COLUMNS - 5.0;
}

int is_node(reader *r)
{
    double head[4], k, last = -1.0, seen = 0.0, like = 0.0;
    int named = ends_in(r->s.name, ".node");

    if (!node_head(r, next_cells(r), head)) return 0;
    if (named && head[1] != 3.0)
        scan_fail(&r->s, "the points are not in three dimensions");
    if (named || head[1] != 3.0) return named;
    /* most of the next lines are numbered, upwards: read_node refuses gaps */
    for (; seen < 10.0 && seen < head[0] && next_cells(r) > 0; seen++) {
        if ((double)r->cells != 4.0 + head[2] + head[3] ||
            !cell_whole(r->cell, &k))
            continue;
        like += k > last;
        last = k;
    }
    return seen > 0.0 && 2.0 * like >= seen;
}

void read_node(reader *r)
{
    points *to = r->to;
    double head[4];
    int k;
    char title[TITLE];

    node_head(r, need_cells(r), head);
    r->want = head[0];
    r->numbered = 1;
    add_column(r, "number")->role = UNUSED;
    add_axes(r, 0, 0);
    for (k = 0; k < (int)head[2]; k++) {
        sprintf(title, k > 0 ? "value%d" : "value", k + 1);
        add_column(r, title);
    }
    if (head[3] > 0.0) {
        r->keeps = r->columns;
        add_column(r, "marker");
    }
    take_all(r, "lines behind the points announced");
    to->marker = head[3] > 0.0 && to->columns > 0 &&
                 strcmp(to->name[to->columns - 1], "marker") == 0;
}
