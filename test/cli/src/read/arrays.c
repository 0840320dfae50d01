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

/* need_bytes - so many more of the head. */
static char *need_bytes(scan *s, double many)
{
    char *at = many < 1e7 ? scan_take(s, (size_t)many) : 0;

    if (!at) scan_fail(s, "the file ends in its head");
    return at;
}

void read_npy(reader *r)
{
    static const char other[] = "its head is not as NumPy writes it";
    scan *s = &r->s;
    const char *byte = scan_take(s, 8);
    char *text, *to, *p, kind, order;
    double columns = 0.0, bytes;
    int k, version = byte ? byte[6] : 0, turned;

    if (version < 1 || version > 3 || byte[7] != 0)
        scan_fail(s, "a .npy file of a version that is not known");
    k = version == 1 ? 2 : 4;
    text = need_bytes(s, stored(need_bytes(s, k), 'u', k, 0));
    for (p = to = text; p < s->at; p++)
        if (*p != ' ') *to++ = *p;
    if (to == text || to[-1] != '\n') scan_fail(s, other);
    to[-1] = '\0';
    p = text;
    if (expect(&p, "{'descr':["))
        scan_fail(s, "has rows of fields, which are not read: numpy.save("
                  "'G.npy', numpy.lib.recfunctions.structured_to_unstructured"
                  "(a))");
    if (!expect(&p, "{'descr':'") || !p[0] || !p[1]) scan_fail(s, other);
    order = *p++;
    kind = *p++;
    if (!length(&p, &bytes) || !strchr("<>=|", order) ||
        !strchr("fiu", kind) ||
        (kind == 'f' ? bytes != 4.0 && bytes != 8.0
                     : bytes < 1.0 || bytes > 8.0))
        scan_fail(s, "numbers of the kind %c%.0f are not read: numpy.save("
                  "'G.npy', numpy.load('F').astype(float))", kind, bytes);
    turned = expect(&p, "','fortran_order':True,'shape':(");
    if (!turned && !expect(&p, "','fortran_order':False,'shape':("))
        scan_fail(s, other);
    if (!length(&p, &r->want) || !expect(&p, ",") || !length(&p, &columns) ||
        !expect(&p, ")"))
        scan_fail(s, "is no array of two dimensions, a row for each point: "
                  "numpy.save('G.npy', numpy.load('F').reshape(-1, 3))");
    expect(&p, ",");
    if (strcmp(p, "}") != 0) scan_fail(s, other);
    if (columns < 1.0 || columns > COLUMNS)
        scan_fail(s, "has %.0f columns, where 1 to %d are read", columns,
                  COLUMNS);
    r->big = order == '>';
    r->form = PACKED;
    for (k = 0; k < (int)columns; k++)
        add_packed(r, "", kind, (int)bytes);
    if (turned) {
        /* all is one record, column by column */
        for (k = 0; k < (int)columns; k++) r->column[k].at *= r->want;
        r->share = r->stride;
        r->record = r->want * r->share;
        r->per = r->want;
        r->stride = bytes;
    }
    take_all(r, "bytes behind the array");
}

/* ---- PCD ---- */

/* has_key - is the head's next line that of this word? */
static int has_key(reader *r, const char *word)
{
    if (r->waits == 0) r->waits = need_cells(r);
    return cell_is(r->cell, word);
}

/* key - go behind that line, which must be there, and have so many words more,
 * if that is not 0; x: these are numbers, and if it is not 0 wanted.  Returns
 * how many. */
static int key(reader *r, const char *word, int want, double *x)
{
    scan *s = &r->s;
    const cell *c = r->cell;
    int n, k;

    if (!has_key(r, word))
        scan_fail(s, "\"%.40s\": where PCD has %s", s->line, word);
    n = r->waits - 1;
    if (want == 1 && n != 1) scan_fail(s, "%s needs one word", word);
    if (n == 0) scan_fail(s, "%s has no words", word);
    if (want > 0 && n != want)
        scan_fail(s, "%s of %d fields, where there are %d", word, n, want);
    for (k = 0; k < n && x; k++)
        if (!cell_whole(++c, x + k))
            scan_fail(s, "%s: \"%.*s\": not a number", word, SHOWN(c));
    r->waits = 0;
    return n;
}

void read_pcd(reader *r)
{
    scan *s = &r->s;
    double size[COLUMNS], many[COLUMNS], width, height, view[7];
    char type[COLUMNS], title[COLUMNS][TITLE];
    int fields, k, j, colours = 0, used;
    cell *c = r->cell + 1;

    key(r, "VERSION", 1, 0);
    fields = key(r, "FIELDS", 0, 0);
    for (k = 0; k < fields; k++) {
        many[k] = 1.0;
        title_of(c + k, title[k]);
    }
    key(r, "SIZE", fields, size);
    key(r, "TYPE", fields, 0);
    for (k = 0; k < fields; k++) {
        type[k] = *c[k].text;
        if (c[k].end != c[k].text + 1 || !strchr("IUF", type[k]))
            scan_fail(s, "TYPE is I, U or F");
    }
    if (has_key(r, "COUNT")) key(r, "COUNT", fields, many);
    key(r, "WIDTH", 1, &width);
    key(r, "HEIGHT", 1, &height);
    if (has_key(r, "VIEWPOINT")) {
        if (!numbers(r->cell[0].end, s->stop, 7, view))
            scan_fail(s, "VIEWPOINT needs 7 numbers");
        r->waits = 0;
    }
    key(r, "POINTS", 1, &r->want);
    key(r, "DATA", 1, 0);
    if (cell_is(c, "binary_compressed"))
        fail("%s: is compressed PCD, which is not read: "
             "pcl_convert_pcd_ascii_binary F G 0", s->name);
    if (cell_is(c, "binary")) r->form = PACKED;
    else if (!cell_is(c, "ascii")) scan_fail(s, "DATA is ascii or binary");
    if (r->want != width * height)
        fail("%s: announces %.0f points, WIDTH times HEIGHT are %.0f", s->name,
             r->want, width * height);
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
            add_packed(r, title[k], (char)(type[k] | 32),
                       (int)size[k])->role = used ? VALUE : UNUSED;
    }
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
    const char *head = need_bytes(s, 227.0);
    double offset, stride, low[3], high[3], slack, x, outside = 0.0;
    int k, format, minor;
    tess_int i;
    column *c;

    minor = head[25];
    format = head[104] & 63;
    if (head[24] != 1 || minor < 0 || minor > 4 || format > 10)
        scan_fail(s, "LAS %d.%d, format %d, is not known", head[24], minor,
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
            scan_fail(s, "a scale or an offset that LAS has not");
    }
    add_packed(r, "intensity", 'u', 2);
    if (stride < (double)least[format])
        scan_fail(s, "records of %.0f bytes, where format %d has %d", stride,
                  format, least[format]);
    r->stride = stride;
    if (minor == 4) {
        x = stored(need_bytes(s, 148.0) + 247 - 227, 'u', 8, 0);
        if (r->want != 0.0 && r->want != x)
            scan_fail(s, "announces %.0f points, and %.0f", r->want, x);
        r->want = x;
    }
    x = scan_passed(s);
    if (offset < x) scan_fail(s, "its points begin in its head");
    for (; x < offset; x++) need_bytes(s, 1.0);
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
