/* page.c - see page.h; draw_default, draw_even: draw.h. */
#include "../driver.h"
#include "page.h"

#include <math.h>
#include <string.h>

#define GREY "#767c85" /* of equal contrast to white and to a dark page */

/* ---------------------------------------------------------------- colour */

/* channel - a linear part of a colour as 0 ... 255. */
static int channel(double x)
{
    double y = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;

    return y <= 0.0 ? 0 : y >= 1.0 ? 255 : (int)(255.0 * y + 0.5);
}

/* colour - number x, 0 ... 1, of a scale from cold violet to warm yellow:
 * even steps of lightness and hue in the perceptual space Oklab, so that equal
 * differences look equal, in grey and to the colour-blind too.  Below 0: a
 * greyish blue; above 1: a grey, of what is no number. */
static void colour(double x, double shade, int *rgb)
{
    double l = 0.46 + 0.46 * x, hue = (282.0 + 180.0 * x) * DEGREE;
    double chroma = 0.145 + 0.06 * sin(180.0 * x * DEGREE);
    double a, b, r, g, s;

    if (x < 0.0 || x > 1.0) {
        l = x < 0.0 ? 0.82 : 0.72;
        chroma = x < 0.0 ? 0.04 : 0.0;
        hue = 258.0 * DEGREE;
    }
    a = chroma * cos(hue);
    b = chroma * sin(hue);
    r = l + 0.3963377774 * a + 0.2158037573 * b;
    g = l - 0.1055613458 * a - 0.0638541728 * b;
    s = l - 0.0894841775 * a - 1.2914855480 * b;
    r = shade * r * r * r;
    g = shade * g * g * g;
    s = shade * s * s * s;
    rgb[0] = channel(4.0767416621 * r - 3.3077115913 * g + 0.2309699292 * s);
    rgb[1] = channel(-1.2684380046 * r + 2.6097574011 * g - 0.3413193965 * s);
    rgb[2] = channel(-0.0041960863 * r - 0.7034186147 * g + 1.7076147010 * s);
}

/* nice - 1, 2 or 5 times a power of ten, not less than x > 0. */
static double nice(double x)
{
    double ten = pow(10.0, floor(log10(x) + 1e-9)), y = x / ten - 1e-6;

    return y <= 1.0 ? ten : y <= 2.0 ? 2.0 * ten : y <= 5.0 ? 5.0 * ten
                                                            : 10.0 * ten;
}

/* ----------------------------------------------------------------- paths */

/* put_line - the line that waits, if any. */
static void put_line(drawing *d)
{
    const long *to = d->line;

    check_written(d->file);
    if (to[0] == 0 && to[1] == 0) return;
    fprintf(d->file, d->corners > 2 && to[0] >= 0 ? " %ld%s%ld" : "%ld%s%ld",
            to[0], to[1] >= 0 ? " " : "", to[1]);
}

void page_corner(drawing *d, double x, double y)
{
    long to[2], step[2];
    int k;

    to[0] = (long)floor(x + 0.5);
    to[1] = (long)floor(y + 0.5);
    for (k = 0; k < 2; k++) step[k] = d->corners ? to[k] - d->at[k] : 0;
    if (d->corners == 0) {
        fprintf(d->file, "M%ld %ldl", to[0], to[1]);
        d->line[0] = d->line[1] = 0;
    } else if (step[0] == 0 && step[1] == 0) {
        return;
    } else if (d->line[0] * step[1] == d->line[1] * step[0] &&
               d->line[0] * step[0] + d->line[1] * step[1] > 0) {
        for (k = 0; k < 2; k++) step[k] += d->line[k];
        d->corners--;
    } else {
        put_line(d);
    }
    d->corners++;
    for (k = 0; k < 2; k++) {
        d->at[k] = to[k];
        d->line[k] = step[k];
    }
}

void page_close(drawing *d)
{
    if (d->corners == 0) return;
    put_line(d);
    fprintf(d->file, d->corners > 1 ? "z" : "0 0z");
    d->corners = 0;
}

/* across, down - where in the picture: tenths of pixels. */
double page_across(const drawing *d, double x)
{
    return d->shift[0] + d->unit * (x - d->left);
}

double page_down(const drawing *d, double y)
{
    return d->shift[1] + d->unit * (d->top - y);
}

/* ------------------------------------------------------------- around it */

void page_bands(drawing *d, double low, double high)
{
    const double *range = d->look->range;
    double size;

    if (range[0] < range[1] && !d->plain) {
        low = range[0];
        high = range[1];
    }
    size = fabs(low) > fabs(high) ? fabs(low) : fabs(high);
    if (!(high - low > 1e-13 * size)) {
        /* all the same, but for rounding: amid a band, with others about it */
        d->step = size > 0.0 ? nice(size / 25.0) / 5.0 : 0.1;
        d->bands = d->plain ? 1 : 25;
        d->low = low - d->bands / 2.0 * d->step;
        return;
    }
    d->step = nice((high - low) / 5.0) / 5.0;
    d->low = d->step * floor(low / d->step + 1e-9);
    d->bands = (int)ceil((high - d->low) / d->step - 1e-9);
}

#define LEFT 90.0 /* pixels beside a picture, for axes and texts */
#define RIGHT 60.0
#define TOP 25.0
#define BOTTOM 60.0
#define BAR 110.0
#define ABOVE 40.0
#define BELOW 25.0
#define ALONE 8.0 /* where there are none */
#define HIGHEST 640.0
#define LOWEST 300
#define SPARED 0.7 /* of a picture for that at most */
#define WIDE 0.56 /* of a character, about, in parts of its size */
#define DIGITS 6  /* characters of a tick's number, if an offset can help */

void page_place(drawing *d, double width, double height)
{
    const draw_look *look = d->look;
    double margin[4], share[4] = {1.0, 1.0, 1.0, 1.0}, room[2], sum, size;
    int k;

    margin[0] = look->bare ? ALONE : LEFT;
    margin[1] = look->bare ? ALONE : RIGHT + (d->plain ? 0.0 : BAR);
    margin[2] = look->bare ? ALONE : TOP + (look->title ? ABOVE : 0.0);
    margin[3] = look->bare ? ALONE : BOTTOM + BELOW;
    /* (of a small picture a part is left) */
    for (k = 0; k < 4; k++) {
        size = k < 2 ? look->width : look->height;
        sum = k < 2 ? margin[0] + margin[1] : margin[2] + margin[3];
        if (size > 0.0 && sum > SPARED * size) share[k] = SPARED * size / sum;
    }
    for (k = 0; k < 4; k++) margin[k] *= share[k];
    room[0] = 10.0 * (look->width - margin[0] - margin[1]);
    room[1] = 10.0 * (HIGHEST - margin[2] - margin[3]);
    if (height * room[0] < width * room[1]) room[1] = height * room[0] / width;
    d->height = (int)(room[1] / 10.0 + margin[2] + margin[3] + 0.5);
    if (d->height < LOWEST) d->height = LOWEST;
    if (look->height > 0) d->height = look->height;
    room[1] = 10.0 * (d->height - margin[2] - margin[3]);
    d->unit = 1e30;
    if (d->unit * width > room[0]) d->unit = room[0] / width;
    if (d->unit * height > room[1]) d->unit = room[1] / height;
    d->shift[0] = 10.0 * margin[0] + (room[0] - d->unit * width) / 2.0;
    d->shift[1] = 10.0 * margin[2] + (room[1] - d->unit * height) / 2.0;
}

/* characters - of a text, of which some have several bytes. */
static double characters(const char *text)
{
    double many = 0.0;

    for (; *text; text++) many += ((unsigned char)*text & 192) != 128;
    return many;
}

/* fitted - the size of a text, or one with which it is not longer than that. */
static double fitted(const char *text, double size, double most)
{
    double wide = WIDE * size * characters(text);

    return wide > most ? size * most / wide : size;
}

/* write_at - a text, of that size, in tenths of pixels; anchor: start, middle,
 * end. */
static void write_at(const drawing *d, double x, double y, double size,
                     const char *anchor, const char *text)
{
    fprintf(d->file, "<text x=\"%.0f\" y=\"%.0f\" font-size=\"%.0f\"", x, y,
            size);
    if (strcmp(anchor, "start") != 0)
        fprintf(d->file, " text-anchor=\"%s\"", anchor);
    fprintf(d->file, ">%s</text>\n", xml_text(text));
}

/* write_within - the same, moved and made smaller so that it is within the
 * picture, above the note, and so far from the right. */
static void write_within(const drawing *d, double x, double y, double size,
                         const char *anchor, const char *text, double right)
{
    double most = 10.0 * d->look->width - right - 50.0, wide, before;

    size = fitted(text, size, most);
    wide = WIDE * size * characters(text);
    before = *anchor == 's' ? 0.0 : *anchor == 'e' ? wide : wide / 2.0;
    if (x - before < 50.0) x = 50.0 + before;
    if (x - before + wide > most + 50.0) x = most + 50.0 + before - wide;
    if (y < size) y = size;
    if (y > 10.0 * d->height - 370.0) y = 10.0 * d->height - 370.0;
    write_at(d, x, y, size, anchor, text);
}

/* put_number - a multiple of step, with the digits that tells it. */
static void put_number(char *text, double x, double step)
{
    double digits = -floor(log10(step) + 1e-9);

    if (fabs(x) < step / 2.0) x = 0.0;
    if (digits >= -5.0 && digits <= 5.0 && fabs(x) < 1e9)
        sprintf(text, "%.*f", digits > 0.0 ? (int)digits : 0, x);
    else
        sprintf(text, "%.6g", x);
}

/* ticks - of a scale: so many multiples of step, from first on.  What is
 * written is less by base, which the scale's title says. */
typedef struct ticks {
    double step, first, base;
    int many;
} ticks;

static double tick(const ticks *t, int i)
{
    return (t->first + i) * t->step;
}

static void tick_text(const ticks *t, int i, char *text)
{
    put_number(text, (t->first - floor(t->base / t->step + 0.5) + i) * t->step,
               t->step);
}

/* choose_ticks - two at least, of numbers that differ, and are short if they
 * can be. */
static void choose_ticks(ticks *t, double low, double high, double step)
{
    char text[40], last[40];
    double unit = pow(10.0, ceil(log10(high - low) - 1e-9));
    int i;

    for (;; step = nice(step / 2.5)) {
        t->step = step;
        t->first = ceil(low / step - 1e-6);
        t->many = (int)(floor(high / step + 1e-6) - t->first) + 1;
        if (t->many > 1) break;
    }
    t->base = 0.0;
    last[0] = '\0';
    for (i = 0; i < t->many; i++) {
        tick_text(t, i, text);
        if (strlen(text) > (strchr(text, 'e') ? DIGITS + 2 : DIGITS) ||
            strcmp(last, text) == 0)
            t->base = unit * floor(low / unit + 1e-3);
        if (t->base != 0.0) return;
        strcpy(last, text);
    }
}

/* scale_title - its name, and the base before a comma with its unit. */
static const char *scale_title(const ticks *t, const char *name)
{
    static char text[TEXT];
    int k = (int)strcspn(name, ",");

    if (t->base == 0.0) return name;
    sprintf(text, "%.*s %c %.15g%.200s", k < 200 ? k : 200, name,
            t->base > 0.0 ? '-' : '+', fabs(t->base), name + k);
    return text;
}

void page_axis(const drawing *d, const double *from, const double *to,
                      double low, double high, const double *out,
                      const char *name)
{
    double length = sqrt((to[0] - from[0]) * (to[0] - from[0]) +
                         (to[1] - from[1]) * (to[1] - from[1]));
    double x, y, s, size, wide = 0.0;
    const char *anchor = out[0] < -0.3 ? "end" : out[0] > 0.3 ? "start"
                                                              : "middle";
    const char *title;
    char text[40];
    ticks t;
    int i;

    if (length < 200.0 ||
        !(high - low > 1e-14 * (fabs(low) > fabs(high) ? fabs(low)
                                                       : fabs(high))))
        return;
    choose_ticks(&t, low, high,
                 nice((high - low) * (350.0 + 250.0 * fabs(out[1])) / length));
    fprintf(d->file, "<path d=\"M%.0f %.0fL%.0f %.0f", from[0], from[1], to[0],
            to[1]);
    for (i = 0; i < t.many; i++) {
        s = (tick(&t, i) - low) / (high - low);
        fprintf(d->file, "M%.0f %.0fl%.0f %.0f",
                from[0] + s * (to[0] - from[0]),
                from[1] + s * (to[1] - from[1]), 60.0 * out[0], 60.0 * out[1]);
    }
    fprintf(d->file, "\"/>\n");
    for (i = 0; i < t.many; i++) {
        tick_text(&t, i, text);
        if (78.0 * (double)strlen(text) > wide)
            wide = 78.0 * (double)strlen(text);
        s = (tick(&t, i) - low) / (high - low);
        x = from[0] + s * (to[0] - from[0]) + 110.0 * out[0];
        y = from[1] + s * (to[1] - from[1]) + 110.0 * out[1];
        write_at(d, x, y + 50.0 + 50.0 * out[1], 140.0, anchor, text);
    }
    title = scale_title(&t, name);
    x = (from[0] + to[0]) / 2.0;
    y = (from[1] + to[1]) / 2.0;
    s = 220.0 + wide * fabs(out[0]) + 130.0 * fabs(out[1]);
    if (out[0] > -0.95) {
        /* (beside the bar) */
        y += s * out[1] + 50.0 + 50.0 * out[1];
        s = x + s * out[0];
        x = d->plain ? 50.0 : 1080.0;
        wide = WIDE * 150.0 * characters(title);
        if (*anchor == 's' ? s + wide > 10.0 * d->look->width - x
                           : *anchor == 'e' && s - wide < 50.0) {
            /* too long to be beside the ticks: below */
            y = (from[1] > to[1] ? from[1] : to[1]) + 500.0;
            s = *anchor == 's' ? 10.0 * d->look->width : 0.0;
        }
        write_within(d, s, y, 150.0, anchor, title, x);
        return;
    }
    x = x + s * out[0] + 40.0;
    if (x < 150.0) x = 150.0;
    size = fitted(title, 150.0, 10.0 * d->height - 450.0);
    wide = WIDE * size * characters(title) / 2.0;
    if (y < wide + 50.0) y = wide + 50.0;
    if (y > 10.0 * d->height - 370.0 - wide)
        y = 10.0 * d->height - 370.0 - wide;
    fprintf(d->file, "<g transform=\"translate(%.0f %.0f) rotate(-90)\">\n", x,
            y);
    write_at(d, 0.0, 0.0, size, "middle", title);
    fprintf(d->file, "</g>\n");
}

void page_axes(const drawing *d)
{
    fprintf(d->file, "<g class=\"axes\" stroke=\"none\">\n");
    fprintf(d->file,
            "<style>.axes path{stroke:" GREY ";stroke-width:10;fill:none}"
            "</style>\n");
}

void page_hex(FILE *file, double x, double shade)
{
    int rgb[3];

    colour(x, shade, rgb);
    fprintf(file, "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
}

double page_share(const drawing *d, int k)
{
    if (k == d->bands) return 2.0;
    if (d->plain && d->look->what != DRAW_APART) return -1.0;
    return d->bands > 1 ? k / (d->bands - 1.0) : 0.5;
}

void page_head(const drawing *d)
{
    const draw_look *look = d->look;

    fprintf(d->file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
            "height=\"%d\" viewBox=\"0 0 %d0 %d0\" "
            "font-family=\"Helvetica,Arial,sans-serif\" fill=\"" GREY "\">\n",
            look->width, d->height, look->width, d->height);
    if (look->bare) return;
    if (look->title) {
        fprintf(d->file, "<g font-weight=\"bold\">\n");
        /* (bold is wider) */
        write_at(d, 250.0, 430.0,
                 fitted(look->title, 210.0, 9.0 * look->width - 450.0),
                 "start", look->title);
        fprintf(d->file, "</g>\n");
    }
    if (look->note)
        write_at(d, 250.0, 10.0 * d->height - 180.0,
                 fitted(look->note, 140.0, 10.0 * look->width - 500.0),
                 "start", look->note);
}

/* bar - the colour bar. */
static void bar(const drawing *d)
{
    double tall, x, y;
    const char *label = d->look->label ? d->look->label : "";
    char text[40];
    ticks t;
    int k;

    if (d->plain || d->look->bare) return;
    tall = 6.4 * d->height;
    x = 10.0 * d->look->width - 1000.0;
    y = (10.0 * d->height - tall) / 2.0 + 120.0;
    fprintf(d->file, "<g class=\"bar\">\n");
    for (k = 0; k < d->bands; k++) {
        fprintf(d->file,
                "<rect x=\"%.0f\" y=\"%.0f\" width=\"220\" height=\"%.0f\" "
                "fill=\"",
                x, y + tall * (d->bands - 1 - k) / d->bands,
                tall / d->bands + (k > 0 ? 5.0 : 0.0));
        page_hex(d->file, page_share(d, k), 1.0);
        fprintf(d->file, "\"/>\n");
    }
    choose_ticks(&t, d->low, d->low + d->bands * d->step, 5.0 * d->step);
    for (k = 0; k < t.many; k++) {
        tick_text(&t, k, text);
        write_at(d, x + 270.0,
                 y + tall * (d->bands - (tick(&t, k) - d->low) / d->step) /
                         d->bands + 52.0,
                 140.0, "start", text);
    }
    label = scale_title(&t, label);
    if (characters(label) > 10.0)
        write_within(d, 10.0 * d->look->width - 50.0,
                     characters(label) > 20.0 ? 170.0 : y - 110.0, 150.0, "end",
                     label, 50.0);
    else if (*label)
        write_at(d, x, y - 110.0, 150.0, "start", label);
    fprintf(d->file, "</g>\n");
}

void page_begin(drawing *d, FILE *file, const draw_look *look, tess_int ntet,
                const tess_int *tet, const tess_int *adj, const char *keep)
{
    memset(d, 0, sizeof *d);
    d->file = file;
    d->look = look;
    d->ntet = ntet;
    d->tet = tet;
    d->adj = adj;
    d->keep = keep;
}

void page_end(const drawing *d)
{
    bar(d);
    fprintf(d->file, "</svg>\n");
}

void draw_default(draw_look *look)
{
    int k;

    memset(look, 0, sizeof *look);
    look->width = 900;
    look->what = DRAW_WHOLE;
    look->azimuth = -68.0;
    look->elevation = 28.0;
    look->title = look->note = look->label = 0;
    for (k = 0; k < 3; k++) {
        look->scale[k] = 1.0;
        look->name[k] = &"x\0y\0z"[2 * k];
    }
}

void draw_even(draw_look *look, const double *length, double most, char *note)
{
    double longest = 0.0, side;
    int k;

    for (k = 0; k < 3; k++) {
        side = length[k] * fabs(look->scale[k]);
        if (side > longest) longest = side;
    }
    for (k = 0; k < 3; k++) {
        side = length[k] * fabs(look->scale[k]);
        if (!(side > 0.0) || side * most >= longest) continue;
        look->scale[k] *= longest / most / side;
        sprintf(note + strlen(note), "; %.*s is drawn %.3g times as large",
                (int)strcspn(look->name[k], ","), look->name[k],
                longest / most / side);
    }
}
