/* arrays.c - tables of numbers that mostly are not text: .npy, PCD, LAS. */
#include <string.h>

#include "read.h"

/* ---- NumPy's .npy ---- */

/* expect - go behind this text, if it is there. */
static int expect(char **s, const char *text)
{
    size_t n = strlen(text);

    if (strncmp(*s, text, n) != 0) return 0;
    *s += n;
    return 1;
}

/* length - a number there, and go behind it. */
static int length(char **s, double *n)
{
    char *from = *s;

    *s += strspn(from, "0123456789");
    return whole(from, *s, n);
}

void read_npy(reader *r)
{
    scan *s = &r->s;
    const char *byte = scan_take(s, 8);
    char *text, *to, *p, kind, order;
    double n = 0.0, columns = 0.0, bytes, size = 0.0;
    int k, version = byte ? byte[6] : 0, turned, good;

    if (version < 1 || version > 3 || byte[7] != 0)
        fail("%s: a .npy file of a version that is not known", s->name);
    k = version == 1 ? 2 : 4;
    byte = scan_take(s, (size_t)k);
    if (byte) size = stored(byte, 'u', k, 0);
    text = byte && size < 1e7 ? scan_take(s, (size_t)size) : 0;
    if (!text) fail("%s: the file ends in its head", s->name);
    for (p = to = text; p < s->at; p++)
        if (*p != ' ') *to++ = *p;
    good = to > text && to[-1] == '\n';
    if (good) to[-1] = '\0';
    p = text;
    if (good && expect(&p, "{'descr':["))
        fail("%s: has rows of fields, which are not read: numpy.save('G.npy', "
             "numpy.lib.recfunctions.structured_to_unstructured(a))", s->name);
    good = good && expect(&p, "{'descr':'") && p[0] && p[1];
    order = *p;
    kind = (char)(good ? p[1] : 0);
    p += 2 * good;
    if (good && (!length(&p, &bytes) || !strchr("<>=|", order) ||
                 !strchr("fiu", kind) ||
                 (kind == 'f' ? bytes != 4.0 && bytes != 8.0
                              : bytes < 1.0 || bytes > 8.0)))
        fail("%s: numbers of the kind %c%.0f are not read: numpy.save('G.npy', "
             "numpy.load('F').astype(float))", s->name, kind, bytes);
    turned = good && strncmp(p, "','fortran_order':True,", 23) == 0;
    good = good && expect(&p, turned ? "','fortran_order':True,'shape':("
                                     : "','fortran_order':False,'shape':(");
    if (good && (!length(&p, &n) || !expect(&p, ",") ||
                 !length(&p, &columns) || !expect(&p, ")")))
        fail("%s: is no array of two dimensions, a row for each point: "
             "numpy.save('G.npy', numpy.load('F').reshape(-1, 3))", s->name);
    if (good) expect(&p, ",");
    if (!good || strcmp(p, "}") != 0)
        fail("%s: its head is not as NumPy writes it", s->name);
    if (columns < 1.0 || columns > COLUMNS)
        fail("%s: has %.0f columns, of which at most %d are read", s->name,
             columns, COLUMNS);
    r->big = order == '>';
    r->want = n;
    r->form = PACKED;
    for (k = 0; k < (int)columns; k++) {
        column *c = add_packed(r, "", 0, kind, (int)bytes);
        if (turned) c->at = n * bytes * k;
    }
    if (turned) {
        r->whole = n * r->stride;
        r->stride = bytes;
    }
    take_all(r, "bytes behind the array");
}

/* ---- PCD ---- */

/* The lines of a head, in this order; so many words in each: 1, as many as
 * fields, or 7.  COUNT and VIEWPOINT may be missing. */
enum { VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS,
       DATA, KEYS };

static const char *const keys[] = {"VERSION", "FIELDS", "SIZE", "TYPE", "COUNT",
                                   "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS",
                                   "DATA", "points"};

void read_pcd(reader *r)
{
    scan *s = &r->s;
    double size[COLUMNS], many[COLUMNS], number[KEYS], view[7];
    char type[COLUMNS], title[COLUMNS][TITLE];
    int key = -1, n, k, j, fields = 0, colours = 0, used;
    cell *c = r->cell;

    for (k = 0; k < COLUMNS; k++) many[k] = 1.0;
    while (key < DATA) {
        n = need_cells(r) - 1;
        s->head++;
        for (k = key + 1; k < KEYS && !cell_is(c, keys[k]);) k++;
        if (k == KEYS || (k > key + 1 && k != WIDTH && k != POINTS))
            scan_fail(s, "\"%.40s\": where PCD has %s", s->line, keys[key + 1]);
        key = k;
        if (key == FIELDS) fields = n;
        if (key >= FIELDS && key <= COUNT && (n != fields || n == 0))
            scan_fail(s, "%s of %d fields, where there are %d", keys[key], n,
                      fields);
        if ((key < FIELDS || key > COUNT) && key != VIEWPOINT && n != 1)
            scan_fail(s, "%s needs one word", keys[key]);
        if (key == VIEWPOINT && !numbers(c->end, s->stop, 7, view))
            scan_fail(s, "VIEWPOINT needs 7 numbers");
        for (j = 0; j < n && key != VIEWPOINT; j++) {
            c = r->cell + j + 1;
            if (key == FIELDS)
                sprintf(title[j], "%.*s", SHOWN(c));
            else if (key == TYPE) {
                type[j] = *c->text;
                if (c->end != c->text + 1 || !strchr("IUF", type[j]))
                    scan_fail(s, "TYPE is I, U or F");
            } else if (key != VERSION && key != DATA &&
                       !cell_whole(c, key == SIZE    ? size + j
                                      : key == COUNT ? many + j
                                                     : number + key))
                scan_fail(s, "%s: \"%.*s\": not a number", keys[key], SHOWN(c));
        }
        c = r->cell;
    }
    c++;
    if (cell_is(c, "binary_compressed"))
        fail("%s: is compressed PCD, which is not read: "
             "pcl_convert_pcd_ascii_binary F G 0", s->name);
    if (cell_is(c, "binary")) r->form = PACKED;
    else if (!cell_is(c, "ascii")) scan_fail(s, "DATA is ascii or binary");
    if (number[POINTS] != number[WIDTH] * number[HEIGHT])
        fail("%s: announces %.0f points, WIDTH times HEIGHT are %.0f", s->name,
             number[POINTS], number[WIDTH] * number[HEIGHT]);
    for (k = 0; k < fields; k++) {
        if ((size[k] != 1.0 && size[k] != 2.0 && size[k] != 4.0 &&
             size[k] != 8.0) || (type[k] == 'F' && size[k] < 4.0) ||
            many[k] < 1.0)
            fail("%s: field %s: a SIZE, TYPE or COUNT that PCD has not",
                 s->name, title[k]);
        used = strncmp(title[k], "rgb", 3) != 0;
        colours |= !used;
        used = used && strcmp(title[k], "_") != 0;
        for (j = 0; (double)j < many[k]; j++)
            add_packed(r, title[k], strlen(title[k]), (char)(type[k] | 32),
                       (int)size[k])->role = used ? VALUE : UNUSED;
    }
    r->want = number[POINTS];
    r->named = 1;
    if (colours) scan_note(s, "colours", r->want, 0);
    take_all(r, r->form == PACKED ? "bytes behind the points"
                                  : "lines behind the points announced");
}

/* ---- LAS ---- */

void read_las(reader *r)
{
    /* bytes of a record, by format */
    static const int least[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    scan *s = &r->s;
    points *to = r->to;
    const char *head = scan_take(s, 227);
    double offset, stride, low[3], high[3], slack, x, outside = 0.0;
    int k, format, minor;
    tess_int i;
    column *c;

    if (!head) fail("%s: the file ends in its head", s->name);
    minor = head[25];
    format = head[104] & 63;
    if (head[24] != 1 || minor < 0 || minor > 4 || format > 10)
        fail("%s: LAS %d.%d, format %d, is not known", s->name, head[24], minor,
             format);
    offset = stored(head + 96, 'u', 4, 0);
    stride = stored(head + 105, 'u', 2, 0);
    r->want = stored(head + 107, 'u', 4, 0);
    add_axes(r, 'i', 4);
    for (k = 0; k < 3; k++) {
        c = r->column + k;
        c->times = stored(head + 131 + 8 * k, 'f', 8, 0);
        c->plus = stored(head + 155 + 8 * k, 'f', 8, 0);
        high[k] = stored(head + 179 + 16 * k, 'f', 8, 0);
        low[k] = stored(head + 187 + 16 * k, 'f', 8, 0);
        if (!(c->times > 0.0) || !(c->times < 1e300) || c->plus != c->plus)
            fail("%s: a scale or an offset that LAS has not", s->name);
    }
    add_packed(r, "intensity", 9, 'u', 2);
    if (stride < (double)least[format])
        fail("%s: records of %.0f bytes, where format %d has %d", s->name,
             stride, format, least[format]);
    r->stride = stride;
    if (minor == 4) {
        head = scan_take(s, 148);
        if (!head) fail("%s: the file ends in its head", s->name);
        x = stored(head + 247 - 227, 'u', 8, 0);
        if (r->want != 0.0 && r->want != x)
            fail("%s: announces %.0f points, and %.0f", s->name, r->want, x);
        r->want = x;
    }
    x = s->passed + (double)(s->at - s->block);
    if (offset < x) fail("%s: its points begin in its head", s->name);
    for (; x < offset; x++)
        if (!scan_take(s, 1)) fail("%s: the file ends in its head", s->name);
    r->form = PACKED;
    take_all(r, "extended records");
    for (i = 0; i < to->n && !to->scratch && !to->cols; i++)
        for (k = 0; k < r->axes; k++) {
            x = (double)to->p[3 * i + k];
            slack = r->column[k].times;
            outside += x < low[k] - slack || x > high[k] + slack;
        }
    if (outside > 0.0)
        warn("%s: coordinates outside the box that its head announces: %.0f",
             s->name, outside);
}
