/* meshes.c - points of surfaces and meshes: OFF, PLY, OBJ, STL, TetGen's .node.
 */
#include <ctype.h>
#include <string.h>

#include "read.h"

#define ELEMENTS 8        /* of PLY, and their properties */
#define PROPERTIES 64
#define LONGEST_LIST 1e8  /* bytes */

/* take_corner - the next one, number k, of a face: point i.  Faces are made
 * triangles. */
static void take_corner(reader *r, double i, int k)
{
    points *to = r->to;

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
        to->face[(size_t)(3.0 * to->faces)] = r->fan[0];
        to->face[(size_t)(3.0 * to->faces) + 1] = r->fan[1];
        to->face[(size_t)(3.0 * to->faces) + 2] = (tess_int)i;
        to->faces += 1.0;
        k = 1;
    }
    r->fan[k] = (tess_int)i;
}

/* line_face - the cells are those of a face: its number of corners, then these,
 * behind so many others. */
static void line_face(reader *r, int n, int first)
{
    const cell *c = r->cell + first;
    double corners = -1.0, i;
    int k;

    if (n <= first || !whole(c->text, c->end, &corners)) corners = -1.0;
    if (corners < 0.0 || corners >= (double)(n - first))
        take_corner(r, -1.0, 0);
    else
        for (k = 1; k <= (int)corners; k++)
            take_corner(r, whole(c[k].text, c[k].end, &i) ? i : -1.0, k - 1);
}

/* rest - the lines behind the points: so many of them are faces, or what it is,
 * each with as many corners as it says; what is more is told as that; so it is
 * if some lack.  Behind some before them are those of a surface. */
static void rest(reader *r, double faces, const char *what, double before,
                 double of, int first)
{
    scan *s = &r->s;
    double found = 0.0, corners;
    int n, more;

    while ((n = next_cells(s, &r->d, r->cell, &more)) > 0) {
        if (r->to->surfaced && found >= before && found < before + of)
            line_face(r, n, first);
        if (found++ >= faces)
            scan_leave(s, "lines behind all that is announced");
        else if (strcmp(what, "faces") == 0 &&
                 (!whole(r->cell[0].text, r->cell[0].end, &corners) ||
                  corners >= (double)n))
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

    n += s[n] == 'C';
    n += s[n] == 'N';
    n += s[n] == '4';
    n += s[n] == 'n';
    return strncmp(s + n, "OFF", 3) == 0 ? n + 3 : 0;
}

int is_off(reader *r)
{
    int n = first_cells(r);
    size_t word;
    double x;
    const cell *c = r->cell;

    if (n == 0 || (word = off_word(c->text)) == 0) return 0;
    if (c->text + word < c->end)
        return isdigit((unsigned char)c->text[word]) != 0;
    return n == 1 || cell_is(c + 1, "BINARY") ||
           whole(c[1].text, c[1].end, &x);
}

void read_off(reader *r)
{
    scan *s = &r->s;
    double number[3];
    int n = need_cells(r), k = 0, found = 0, more, wide;
    size_t word = off_word(r->cell[0].text);
    char head[8];

    sprintf(head, "%.*s", (int)word, r->cell[0].text);
    if (strpbrk(head, "4n") || (n > 1 && cell_is(r->cell + 1, "BINARY")))
        scan_fail(s, "%.20s: not an OFF file of points in space, in ASCII",
                  r->s.line);
    r->cell[0].text += word;
    k = r->cell[0].text == r->cell[0].end;
    for (s->head++; found < 3; k = 0) {
        for (; k < n; k++, found++)
            if (found == 3 ||
                !whole(r->cell[k].text, r->cell[k].end, number + found))
                scan_fail(s, "\"%.*s\": not a number of points, faces, edges",
                          SHOWN(r->cell + k));
        if (found == 3) break;
        n = need_cells(r);
        s->head++;
    }
    r->want = number[0];
    scan_room(s, r->want, 6.0);
    scan_pin(s);
    wide = next_cells(s, &r->d, r->cell, &more);
    scan_go(s);
    add_axes(r, 0, 0);
    for (k = 0; k < 3 && strchr(head, 'N'); k++)
        add_column(r, "normal", 6)->role = UNUSED;
    while (r->columns < wide)
        add_column(r, head[0] == 'O' ? "" : "colour", head[0] == 'O' ? 0 : 6)
            ->role = head[0] == 'O' ? VALUE : UNUSED;
    take_columns(r);
    take_rows(r);
    if (head[0] != 'O')
        scan_note(s, "normals, colours or the like", number[0], 0);
    rest(r, number[1], "faces", 0.0, number[1], 0);
}

/* ---- PLY ---- */

int is_ply(reader *r)
{
    return strncmp(r->s.at, "ply", 3) == 0 && first_cells(r) == 1 &&
           cell_is(r->cell, "ply");
}

/* ply_type - the column's, from its name. */
static int ply_type(column *c, const cell *type)
{
    static const char types[] =
        " char=i1 int8=i1 uchar=u1 uint8=u1 short=i2 int16=i2 ushort=u2 "
        "uint16=u2 int=i4 int32=i4 uint=u4 uint32=u4 float=f4 float32=f4 "
        "double=f8 float64=f8";
    char name[20];
    const char *at;

    sprintf(name, " %.*s=", (int)(type->end - type->text < 9
                                      ? type->end - type->text : 9),
            type->text);
    at = strstr(types, name);
    if (!at) return 0;
    c->type = at[strlen(name)];
    c->bytes = at[strlen(name) + 1] - '0';
    return 1;
}

/* Words behind which PLY has what it likes. */
static int remark(const cell *c)
{
    return cell_is(c, "comment") || cell_is(c, "obj_info");
}

/* other - a property of the elements behind the points: of which element; its
 * type, and that of a list's count. */
typedef struct other {
    int element, corners; /* is it the list of a face's corners? */
    column of, count;     /* (count.bytes 0: it is no list) */
} other;

/* integer - at byte; -1 if it is none. */
static double integer(const char *at, const column *c, int big)
{
    const unsigned char *byte = (const unsigned char *)at;
    double x = byte[big ? 0 : c->bytes - 1];
    int k;

    if (c->type == 'f') return -1.0;
    if (c->type == 'i' && x > 127.0) x -= 256.0;
    for (k = 1; k < c->bytes; k++)
        x = 256.0 * x + byte[big ? k : c->bytes - 1 - k];
    return x;
}

/* pass - so many bytes of what it is; NULL if the file ends before. */
static const char *pass(reader *r, double bytes, const char *what)
{
    const char *at = scan_take(&r->s, (size_t)bytes);

    if (at) scan_note(&r->s, what, bytes, 1);
    return at;
}

/* walk - those elements of a binary file, so many of each, by what they are;
 * the faces are kept; 0 if the file ends before. */
static int walk(reader *r, const double *many, int elements, const other *list,
                int properties, const char *what)
{
    double i, n, j;
    const other *o;
    int e, k;
    const char *byte;

    for (e = 0; e < elements; e++)
        for (i = 0.0; i < many[e]; i++)
            for (o = list, k = 0; k < properties; k++, o++) {
                if (o->element != e) continue;
                n = 1.0;
                if (o->count.bytes) {
                    byte = pass(r, o->count.bytes, what);
                    n = byte ? integer(byte, &o->count, r->big) : -1.0;
                }
                if (n < 0.0 || n * o->of.bytes > LONGEST_LIST) return 0;
                if (!o->corners && !pass(r, n * o->of.bytes, what)) return 0;
                for (j = 0.0; o->corners && j < n; j++) {
                    byte = pass(r, o->of.bytes, what);
                    if (!byte) return 0;
                    take_corner(r, integer(byte, &o->of, r->big),
                                j < 2.0 ? (int)j : 2);
                }
            }
    return 1;
}

void read_ply(reader *r)
{
    scan *s = &r->s;
    double want = -1.0, others = 0.0, n, each[ELEMENTS];
    double before = 0.0, faces = 0.0; /* elements before the faces; faces */
    other list[PROPERTIES];
    int elements = 0, properties = 0;
    /* in lines: of a face what is ahead of the corners (-1: who knows) */
    int in_face = 0, found = 0, ahead = 0, first = -1;
    const char *what = "faces";
    int many, packed = -1, more, k;
    cell *c = r->cell;
    column *p;

    for (;;) {
        if (!scan_line(s)) fail("%s: ends before the first point", s->name);
        many = cut(s, &r->d, c, &more);
        s->head++;
        if (s->number == 1) continue;
        if (many == 0 || remark(c)) {
            s->head--;
            s->blank++;
        } else if (cell_is(c, "end_header") && many == 1)
            break;
        else if (cell_is(c, "format") && many == 3 && cell_is(c + 2, "1.0")) {
            r->big = cell_is(c + 1, "binary_big_endian");
            packed = r->big || cell_is(c + 1, "binary_little_endian");
            if (!packed && !cell_is(c + 1, "ascii"))
                scan_fail(s, "not a format of PLY files");
        } else if (cell_is(c, "format"))
            scan_fail(s, "not a format of PLY files");
        else if (cell_is(c, "element") && many == 3 &&
                 whole(c[2].text, c[2].end, &n)) {
            if (want < 0.0 && !cell_is(c + 1, "vertex"))
                scan_fail(s, "points must be the first element of a PLY file");
            r->waits = want >= 0.0;
            if (r->waits && !cell_is(c + 1, "face")) what = "other elements";
            if (r->waits && elements == ELEMENTS)
                scan_fail(s, "more than %d elements", ELEMENTS);
            in_face = r->waits && cell_is(c + 1, "face");
            if (in_face) {
                before = others;
                faces = n;
            }
            if (r->waits) others += each[elements++] = n;
            else want = n;
        } else if (cell_is(c, "property") && want >= 0.0 && !r->waits) {
            if (many > 1 && cell_is(c + 1, "list"))
                scan_fail(s, "a list is not a property that points may have");
            p = add_column(r, c[2].text, (size_t)(c[2].end - c[2].text));
            if (many != 3 || !ply_type(p, c + 1))
                scan_fail(s, "not a property that points of a PLY file may "
                             "have");
            p->at = r->stride;
            r->stride += p->bytes;
        } else if (!cell_is(c, "property") || want < 0.0)
            scan_fail(s, "\"%.40s\": not a line of a PLY file's head", s->line);
        else {
            other *o = list + properties++;

            if (properties > PROPERTIES)
                scan_fail(s, "more than %d properties", PROPERTIES);
            k = many > 1 && cell_is(c + 1, "list") ? 2 : 0;
            o->element = elements - 1;
            o->count.bytes = 0;
            if (many != 3 + k || !ply_type(&o->of, c + 1 + k) ||
                (k && !ply_type(&o->count, c + 2)))
                scan_fail(s, "not a property of a PLY file");
            o->corners = in_face && k && (cell_is(c + 4, "vertex_indices") ||
                                          cell_is(c + 4, "vertex_index"));
            found += o->corners;
            if (o->corners)
                first = ahead;
            else if (in_face)
                ahead = k || ahead < 0 ? -1 : ahead + 1;
        }
    }
    r->waits = 0;
    if (found != 1 || (!packed && first < 0)) r->to->surfaced = 0;
    if (packed < 0) fail("%s: no format in the PLY file's head", s->name);
    if (want < 0.0) fail("%s: no element vertex in the PLY file's head",
                         s->name);
    r->named = 1;
    r->want = want;
    if (!packed) {
        scan_room(s, want, 2.0 * r->columns);
        take_columns(r);
        take_rows(r);
        rest(r, others, what, before, faces, first);
        return;
    }
    take_packed(r);
    if (!walk(r, each, elements, list, properties, what)) {
        warn("%s: announces %.0f %s, but ends before: is the file cut?",
             s->name, others, what);
        r->to->surfaced = 0;
    }
    scan_rest(s, "bytes behind all that is announced");
}

/* ---- OBJ ---- */

/* obj_word - what a line that begins so is: 'v' a point, 'f' a face, 'o'
 * another one; 0: it is not known. */
static char obj_word(const cell *c)
{
    static const char *const words[] = {
        "vt", "vn", "vp", "deg", "bmat", "step", "cstype", "p", "l", "curv",
        "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con",
        "g", "s", "mg", "o", "bevel", "c_interp", "d_interp", "lod", "usemtl",
        "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj", "ctech",
        "stech", "call", "csh"};
    size_t k, n = (size_t)(c->end - c->text);

    if (n == 1 && (*c->text == 'v' || *c->text == 'f')) return *c->text;
    for (k = 0; k < sizeof words / sizeof words[0]; k++)
        if (strlen(words[k]) == n && memcmp(words[k], c->text, n) == 0)
            return 'o';
    return 0;
}

int is_obj(reader *r)
{
    scan *s = &r->s;
    int n = first_cells(r), more;
    char word = (char)(n > 0 ? obj_word(r->cell) : 0);

    if (!word || n < (word == 'o' ? 2 : 4)) return 0;
    scan_again(s);
    while (sample_line(s)) {
        if (s->line[0] != 'v' || (s->line[1] != ' ' && s->line[1] != '\t'))
            continue;
        if (cut(s, &r->d, r->cell, &more) > 3 &&
            (r->cell[1].kind == NUMBER || r->cell[2].kind == NUMBER))
            return 1;
    }
    return word == 'o' && n == 2 && ends_in(s->name, ".obj");
}

/* obj_face - its corners: numbers from 1 on, or back from the last point; what
 * is behind a slash is of textures and normals. */
static void obj_face(reader *r)
{
    int more, n = cut(&r->s, &r->d, r->cell, &more), k;
    char *s, *end;
    double x;

    for (k = 1; k < n; k++) {
        s = r->cell[k].text;
        for (end = s; end < r->cell[k].end && *end != '/';) end++;
        if (!whole(s + (*s == '-'), end, &x)) x = 0.0;
        take_corner(r, *s == '-' ? (double)r->to->n - x : x - 1.0, k - 1);
    }
}

void read_obj(reader *r)
{
    scan *s = &r->s;
    int n, more, taken = 0;
    char word;

    s->joins = 1;
    r->to->copied = 0;
    add_column(r, "v", 1)->role = UNUSED;
    add_axes(r, 0, 0);
    take_columns(r);
    while (scan_line(s)) {
        word = obj_word(first_word(r));
        if (!*r->cell->text || *r->cell->text == '#') {
            s->blank++;
        } else if (word == 'v') {
            n = cut(s, &r->d, r->cell, &more);
            if (n != 4 && n != 5 && n != 7 && n != 8)
                scan_fail(s, "v has 3 numbers, a weight, a colour: not %d",
                          n - 1);
            for (taken = 4; taken < n; taken++)
                if (r->cell[taken].kind != NUMBER) {
                    r->columns = n;
                    bad_cell(r, taken);
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

int is_stl(reader *r)
{
    scan *s = &r->s;

    if (first_cells(r) == 0 || !cell_is(r->cell, "solid")) return 0;
    while (sample_line(s)) {
        if (cell_is(first_word(r), "facet")) return 1;
        if (*r->cell->text && !cell_is(r->cell, "solid")) return 0;
    }
    return 0;
}

void read_stl(reader *r)
{
    /* the lines' words, and which ones may follow: next[k], or other[k] */
    static const char *const first[] = {"solid", "facet", "outer", "vertex",
                                        "vertex", "vertex", "endloop",
                                        "endfacet", "endsolid"};
    static const int cells[] = {0, 5, 2, 4, 4, 4, 1, 1, 0};
    scan *s = &r->s;
    int at = 8, n, more;

    r->to->copied = 0;
    add_column(r, "vertex", 6)->role = UNUSED;
    add_axes(r, 0, 0);
    take_columns(r);
    while ((n = next_cells(s, &r->d, r->cell, &more)) > 0) {
        /* behind a facet another one or the end, behind that another solid */
        at = at == 8 ? 0 : at + 1;
        if (at == 1 && cell_is(r->cell, first[8])) at = 8;
        if (at == 8 && cell_is(r->cell, first[1])) at = 1;
        if (!cell_is(r->cell, first[at]) || (cells[at] && n != cells[at]) ||
            (at == 1 && !cell_is(r->cell + 1, "normal")) ||
            (at == 2 && !cell_is(r->cell + 1, "loop")))
            scan_fail(s, "\"%.40s\": where STL has %s%s", s->line, first[at],
                      at == 1   ? " normal and three numbers"
                      : at == 2 ? " loop"
                      : cells[at] == 4 ? " and three numbers"
                                       : "");
        if (cells[at] == 4) take_row(r);
        else scan_leave(s, "faces");
    }
    if (at != 8)
        scan_fail(s, "the solid has no end: is the file cut?");
    r->to->faces = (double)(r->to->n / 3);
}

/* facets - of binary STL, in either order of bytes; -1 if the file's size is
 * that of none. */
static double facets(reader *r, int *big)
{
    const unsigned char *byte = (const unsigned char *)r->s.at + 80;
    double number[2], size = r->s.size, room = (double)(r->s.end - r->s.at);
    int k;

    *big = 0;
    if (room < 84.0) return -1.0;
    for (number[0] = number[1] = 0.0, k = 0; k < 4; k++) {
        number[0] = 256.0 * number[0] + byte[3 - k];
        number[1] = 256.0 * number[1] + byte[k];
    }
    if (size < 0.0 && r->s.ended) size = room;
    for (k = 0; k < 2; k++)
        if (size == 84.0 + 50.0 * number[k]) {
            *big = k;
            return number[k];
        }
    return size < 0.0 && number[0] > 0.0 ? number[0] : -1.0;
}

int is_packed_stl(reader *r)
{
    const scan *s = &r->s;
    size_t n = (size_t)(s->end - s->at);
    int big;

    if (!memchr(s->at, 0, n < 512 ? n : 512)) return 0;
    if (facets(r, &big) >= 0.0) return 1;
    if (ends_in(s->name, ".stl"))
        fail("%s: no binary STL: its size is not 84 and 50 times the number of "
             "facets: is the file cut?", s->name);
    return 0;
}

void read_packed_stl(reader *r)
{
    scan *s = &r->s;

    r->want = 3.0 * facets(r, &r->big);
    scan_take(s, 84);
    add_axes(r, 'f', 4);
    r->stride = 12.0;
    r->facets = 1;
    take_packed(r);
    r->to->faces = (double)(r->to->n / 3);
    if (scan_take(s, 2)) scan_note(s, "faces", 2.0, 1);
    scan_rest(s, "bytes behind the facets");
}

/* ---- TetGen ---- */

/* node_head - what the first line, cut, says: points, values, markers. */
static int node_head(const reader *r, int n, double *head)
{
    int k;

    head[2] = head[3] = 0.0;
    for (k = 0; k < n; k++)
        if (k > 3 || !whole(r->cell[k].text, r->cell[k].end, head + k))
            return 0;
    return n > 1 && head[3] <= 1.0 && head[2] <= COLUMNS - 5.0;
}

int is_node(reader *r)
{
    scan *s = &r->s;
    double head[4], k, last = -1.0, seen = 0.0, like = 0.0;
    int n, more, named = ends_in(s->name, ".node");

    scan_again(s);
    n = next_cells(s, &r->d, r->cell, &more);
    if (!node_head(r, n, head)) return 0;
    if (head[1] != 3.0) {
        if (named) fail("%s:%ld: the points are not in three dimensions",
                        s->name, s->number);
        return 0;
    }
    if (named) return 1;
    /* most of the next lines are numbered, upwards: read_node refuses gaps */
    for (; seen < 10.0 && seen < head[0]; seen++) {
        n = next_cells(s, &r->d, r->cell, &more);
        if (n == 0) break;
        if ((double)n != 4.0 + head[2] + head[3] ||
            !whole(r->cell[0].text, r->cell[0].end, &k))
            continue;
        like += k > last;
        last = k;
    }
    return seen > 0.0 && 2.0 * like >= seen;
}

void read_node(reader *r)
{
    scan *s = &r->s;
    points *to = r->to;
    double head[4], at;
    int n, k, more;
    char title[TITLE];

    node_head(r, need_cells(r), head);
    s->head++;
    r->want = head[0];
    scan_room(s, r->want, 8.0 + 2.0 * (head[2] + head[3]));
    add_column(r, "number", 6)->role = UNUSED;
    add_axes(r, 0, 0);
    for (k = 0; k < (int)head[2]; k++) {
        sprintf(title, k > 0 ? "value%d" : "value", k + 1);
        add_column(r, title, strlen(title));
    }
    if (head[3] > 0.0) add_column(r, "marker", 6);
    if (head[3] > 0.0) r->keeps = r->columns - 1;
    take_columns(r);
    to->marker = head[3] > 0.0 && to->columns > 0 &&
                 strcmp(to->name[to->columns - 1], "marker") == 0;
    for (at = 0.0; at < r->want; at++) {
        n = next_cells(s, &r->d, r->cell, &more);
        if (n == 0)
            fail("%s: ends after %.0f of %.0f points", s->name, at, r->want);
        if (n != r->columns)
            scan_fail(s, "%d columns, but line 1 announces %d", n, r->columns);
        if (at == 0.0 && cell_is(r->cell, "1")) to->base = 1;
        if (!whole(r->cell[0].text, r->cell[0].end, head + 1) ||
            head[1] != at + (double)to->base)
            scan_fail(s, "column 1, number: \"%.*s\": points are not numbered "
                      "one after the other from 0 or 1", SHOWN(r->cell));
        take_row(r);
    }
    scan_rest(s, "lines behind the points announced");
}
