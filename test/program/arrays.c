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
    size_t digits = strspn(*s, "0123456789");
    int good = whole(*s, *s + digits, n);

    *s += digits;
    return good;
}

void read_npy(reader *r)
{
    scan *s = &r->s;
    const unsigned char *byte = (const unsigned char *)scan_take(s, 8);
    char *text, *to, *p, kind, order;
    double n = 0.0, columns = 0.0, bytes, size;
    int k, version = byte ? byte[6] : 0, turned;

    if (version < 1 || version > 3 || byte[7] != 0)
        fail("%s: a .npy file of a version that is not known", s->name);
    k = version == 1 ? 2 : 4;
    byte = (const unsigned char *)scan_take(s, (size_t)k);
    for (size = 0.0; byte && k > 0; k--) size = 256.0 * size + byte[k - 1];
    text = byte && size < 1e7 ? scan_take(s, (size_t)size) : 0;
    if (!text) fail("%s: the file ends in its head", s->name);
    for (p = to = text; p < s->at; p++)
        if (*p != ' ') *to++ = *p;
    if (to == text || to[-1] != '\n')
        fail("%s: its head is not as NumPy writes it", s->name);
    to[-1] = '\0';
    p = text;
    if (expect(&p, "{'descr':["))
        fail("%s: has rows of fields, which are not read: numpy.save('G.npy', "
             "numpy.lib.recfunctions.structured_to_unstructured(a))", s->name);
    if (!expect(&p, "{'descr':'") || !p[0] || !p[1])
        fail("%s: its head is not as NumPy writes it", s->name);
    order = *p++;
    kind = *p++;
    if (!length(&p, &bytes) || !strchr("<>=|", order) || !strchr("fiu", kind) ||
        (kind == 'f' ? bytes != 4.0 && bytes != 8.0
                     : bytes < 1.0 || bytes > 8.0))
        fail("%s: numbers of the kind %c%.0f are not read: numpy.save('G.npy', "
             "numpy.load('F').astype(float))", s->name, kind, bytes);
    turned = strncmp(p, "','fortran_order':True,", 23) == 0;
    if (!expect(&p, turned ? "','fortran_order':True,'shape':("
                           : "','fortran_order':False,'shape':("))
        fail("%s: its head is not as NumPy writes it", s->name);
    if (!length(&p, &n) || !expect(&p, ",") || !length(&p, &columns) ||
        !expect(&p, ")"))
        fail("%s: is no array of two dimensions, a row for each point: "
             "numpy.save('G.npy', numpy.load('F').reshape(-1, 3))", s->name);
    expect(&p, ",");
    if (strcmp(p, "}") != 0)
        fail("%s: its head is not as NumPy writes it", s->name);
    if (columns < 1.0 || columns > COLUMNS)
        fail("%s: has %.0f columns, of which at most %d are read", s->name,
             columns, COLUMNS);
    r->big = order == '>';
    r->want = n;
    r->stride = turned ? bytes : bytes * columns;
    r->whole = turned ? n * columns * bytes : 0.0;
    for (k = 0; k < (int)columns; k++) {
        column *c = add_column(r, "", 0);
        c->type = kind;
        c->bytes = (int)bytes;
        c->at = turned ? n * bytes * k : bytes * k;
    }
    scan_room(s, n, bytes * columns);
    take_packed(r);
    if (turned) {
        s->at += (size_t)(r->whole - n * bytes);
        s->rows *= columns;
        s->dropped *= columns;
    }
    scan_rest(s, "bytes behind the array");
}

/* ---- PCD ---- */

int is_pcd(reader *r)
{
    int n = first_cells(r);

    return begins(r, "# .PCD") || (n == 2 && cell_is(r->cell, "VERSION"));
}

void read_pcd(reader *r)
{
    static const char *const keys[] = {"VERSION", "FIELDS", "SIZE", "TYPE",
                                       "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT",
                                       "POINTS", "DATA"};
    scan *s = &r->s;
    double size[COLUMNS], many[COLUMNS], number[10], view[7];
    char type[COLUMNS], title[COLUMNS][TITLE];
    int key = -1, n, k, j, fields = 0, packed, colours = 0;
    cell *c = r->cell;
    column *p;

    for (k = 0; k < COLUMNS; k++) many[k] = 1.0;
    memset(number, 0, sizeof number);
    while (key < 9) {
        n = need_cells(r);
        s->head++;
        for (k = key + 1; k < 10 && !cell_is(c, keys[k]);) k++;
        /* (COUNT and VIEWPOINT may be missing) */
        if (k == 10 || (k > key + 1 && k != 5 && k != 8))
            scan_fail(s, "\"%.40s\": where PCD has %s", s->line,
                      key + 1 < 10 ? keys[key + 1] : "points");
        key = k;
        if (key == 1) fields = n - 1;
        if (key > 0 && key < 5 && (n - 1 != fields || fields == 0))
            scan_fail(s, "%s of %d fields, where there are %d", keys[key],
                      n - 1, fields);
        if ((key == 0 || (key > 4 && key != 7)) && n != 2)
            scan_fail(s, "%s needs one word", keys[key]);
        for (j = 1; j < n && key > 0 && key < 9 && key != 7; j++) {
            if (key == 1)
                sprintf(title[j - 1], "%.*s", TITLE - 1 < (int)(c[j].end -
                        c[j].text) ? TITLE - 1 : (int)(c[j].end - c[j].text),
                        c[j].text);
            else if (key == 3) {
                type[j - 1] = *c[j].text;
                if (c[j].end != c[j].text + 1 || !strchr("IUF", *c[j].text))
                    scan_fail(s, "TYPE is I, U or F");
            } else if (!whole(c[j].text, c[j].end,
                              key == 2   ? size + j - 1
                              : key == 4 ? many + j - 1
                                         : number + key))
                scan_fail(s, "%s: \"%.*s\": not a number", keys[key],
                          SHOWN(c + j));
        }
        if (key == 7 && !numbers(c[0].end, s->stop, 7, view))
            scan_fail(s, "VIEWPOINT needs 7 numbers");
    }
    if (cell_is(c + 1, "binary_compressed"))
        fail("%s: is compressed PCD, which is not read: "
             "pcl_convert_pcd_ascii_binary F G 0", s->name);
    packed = cell_is(c + 1, "binary");
    if (!packed && !cell_is(c + 1, "ascii"))
        scan_fail(s, "DATA is ascii or binary");
    if (number[8] != number[5] * number[6])
        fail("%s: announces %.0f points, WIDTH times HEIGHT are %.0f", s->name,
             number[8], number[5] * number[6]);
    for (k = 0; k < fields; k++) {
        if ((size[k] != 1.0 && size[k] != 2.0 && size[k] != 4.0 &&
             size[k] != 8.0) || (type[k] == 'F' && size[k] < 4.0) ||
            many[k] < 1.0)
            fail("%s: field %s: a SIZE, TYPE or COUNT that PCD has not",
                 s->name, title[k]);
        for (j = 0; (double)j < many[k]; j++) {
            p = add_column(r, title[k], strlen(title[k]));
            if (strcmp(title[k], "_") == 0) p->role = UNUSED;
            if (strncmp(title[k], "rgb", 3) == 0) {
                p->role = UNUSED;
                colours = 1;
            }
            p->type = (char)(type[k] == 'F' ? 'f' : type[k] == 'I' ? 'i' : 'u');
            p->bytes = (int)size[k];
            p->at = r->stride;
            r->stride += size[k];
        }
    }
    r->want = number[8];
    r->named = 1;
    if (colours) scan_note(s, "colours", r->want, 0);
    if (packed) {
        take_packed(r);
        scan_rest(s, "bytes behind the points");
        return;
    }
    scan_room(s, r->want, 2.0 * r->columns);
    take_columns(r);
    take_rows(r);
    scan_rest(s, "lines behind the points announced");
}

/* ---- LAS ---- */

/* las_number - the number of so many bytes there, the least one first. */
static double las_number(const char *head, int at, int bytes)
{
    double x = 0.0;

    for (at += bytes; bytes > 0; bytes--)
        x = 256.0 * x + (unsigned char)head[--at];
    return x;
}

/* las_real - the double there. */
static double las_real(const char *head, int at)
{
    static const int one = 1;
    char byte[8];
    double x;
    int k;

    for (k = 0; k < 8; k++)
        byte[*(const char *)&one ? k : 7 - k] = head[at + k];
    memcpy(&x, byte, sizeof x);
    return x;
}

void read_las(reader *r)
{
    static const int least[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    scan *s = &r->s;
    points *to = r->to;
    char *head = scan_take(s, 227);
    double offset, low[3], high[3], slack, x, outside = 0.0;
    int k, format, minor;
    tess_int i;
    column *c;

    if (!head) fail("%s: the file ends in its head", s->name);
    minor = head[25];
    format = head[104] & 63;
    if (head[24] != 1 || minor < 0 || minor > 4 || format > 10)
        fail("%s: LAS %d.%d, format %d, is not known", s->name, head[24], minor,
             format);
    r->stride = las_number(head, 105, 2);
    r->want = las_number(head, 107, 4);
    offset = las_number(head, 96, 4);
    add_axes(r, 'i', 4);
    for (k = 0; k < 3; k++) {
        c = r->column + k;
        c->times = las_real(head, 131 + 8 * k);
        c->plus = las_real(head, 155 + 8 * k);
        high[k] = las_real(head, 179 + 16 * k);
        low[k] = las_real(head, 187 + 16 * k);
        if (!(c->times > 0.0) || !(c->times < 1e300) || c->plus != c->plus)
            fail("%s: a scale or an offset that LAS has not", s->name);
    }
    if (r->stride < (double)least[format])
        fail("%s: records of %.0f bytes, where format %d has %d", s->name,
             r->stride, format, least[format]);
    if (minor == 4) {
        head = scan_take(s, 148);
        if (!head) fail("%s: the file ends in its head", s->name);
        x = las_number(head, 247 - 227, 8);
        if (r->want != 0.0 && r->want != x)
            fail("%s: announces %.0f points, and %.0f", s->name, r->want, x);
        r->want = x;
    }
    x = s->passed + (double)(s->at - s->block);
    if (offset < x) fail("%s: its points begin in its head", s->name);
    for (; x < offset; x++)
        if (!scan_take(s, 1)) fail("%s: the file ends in its head", s->name);
    c = add_column(r, "intensity", 9);
    c->type = 'u';
    c->bytes = 2;
    c->at = 12.0;
    take_packed(r);
    scan_rest(s, "extended records");
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
