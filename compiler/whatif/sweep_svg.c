// SPDX-License-Identifier: Apache-2.0
// The plot of a sweep as SVG.  Colours differ in lightness too, so that the plot can be read in grey.
#include "compiler/report/xml.h"
#include "compiler/whatif/sweep.h"

// Sizes in pixels: left margin, top margin, width of the plot, height of a row of the plot, bottom margin.
static const double LEFT = 150, TOP = 30, WIDTH = 500, ROW = 18, BOTTOM = 46;

static const char *const good = "#cfe8cf", *const bad = "#b03030", *const ink = "#222";

static void write_start(double height, Buf *out)
{
    buf_printf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"smc-sweep\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\" "
               "font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
               LEFT + WIDTH + 30, height, LEFT + WIDTH + 30, height);
}

static void write_rect(double x, double y, double w, double h, const char *fill, Buf *out)
{
    buf_printf(out, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"%s\"/>\n", x, y, w, h, fill);
}

static void write_label(double x, double y, const char *anchor, const char *text, Buf *out)
{
    buf_printf(out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" fill=\"%s\">", x, y, anchor, ink);
    xml_write_str(out, text);
    buf_str(out, "</text>\n");
}

static const char *number_text(Arena *arena, const SweepAxis *a, double x)
{
    Buf b;

    buf_init(&b, arena);
    sweep_write_value(a, x, &b);
    return buf_text(&b);
}

static double x_of_value(const SweepAxis *a, double x) { return LEFT + WIDTH * (x - a->lo) / (a->hi - a->lo); }

static void write_axis(Arena *arena, const SweepAxis *a, double y, Buf *out)
{
    write_label(LEFT, y + 14, "start", number_text(arena, a, a->lo), out);
    write_label(LEFT + WIDTH, y + 14, "end", number_text(arena, a, a->hi), out);
    write_label(LEFT + WIDTH / 2, y + 30, "middle", a->parameter->name->text, out);
}

// Draws a vertical line at the current value of the parameter, from height `from` to `to`.
static void write_current(const SweepAxis *a, double from, double to, Buf *out)
{
    const double x = x_of_value(a, a->current);

    if (a->current < a->lo || a->current > a->hi)
        return;
    buf_printf(out, "<line x1=\"%.2f\" x2=\"%.2f\" y1=\"%.2f\" y2=\"%.2f\" stroke=\"%s\" stroke-dasharray=\"4 3\"/>\n", x, x, from, to, ink);
    write_label(x, from - 4, "middle", "now", out);
}

// Returns the value between the points a and b at which a check begins or ceases to fail: its boundary if known, else the middle.
static double change_between(const Sweep *s, uint32_t check, double a, double b)
{
    for (uint32_t i = 0; i < s->boundary.n; i++) {
        const SweepBoundary *k = &s->boundary.at[i];
        if (k->axis == 0 && k->check == check && k->fails >= a && k->fails <= b && k->passes >= a && k->passes <= b)
            return (k->passes + k->fails) / 2;
    }
    return (a + b) / 2;
}

static bool ever_fails(const SweepLine *l, uint32_t check)
{
    for (uint32_t i = 0; i < l->at.n; i++)
        if (l->at.at[i].fails[check])
            return true;
    return false;
}

// Draws a check as a row: where it passes, and where it fails.
static void write_row(Arena *arena, const Sweep *s, uint32_t check, double y, Buf *out)
{
    const SweepAxis *a = &s->axis[0];
    const SweepLine *l = &s->line[0];
    double from = a->lo;
    Buf name;

    buf_init(&name, arena);
    sweep_write_check(s, check, &name);
    write_label(LEFT - 8, y + 12, "end", buf_text(&name), out);
    for (uint32_t i = 0; i < l->at.n; i++) {
        const bool is_last = i + 1 == l->at.n, fails = l->at.at[i].fails[check] != 0;
        double to = a->hi;
        if (!is_last && (l->at.at[i + 1].fails[check] != 0) == fails)
            continue;
        if (!is_last)
            to = change_between(s, check, l->at.at[i].value[0], l->at.at[i + 1].value[0]);
        write_rect(x_of_value(a, from), y + 2, x_of_value(a, to) - x_of_value(a, from), ROW - 4, fails ? bad : good, out);
        from = to;
    }
}

static void write_rows(Arena *arena, const Sweep *s, Buf *out)
{
    uint32_t rows = 0;

    for (uint32_t c = 0; c < s->check.n; c++)
        rows += ever_fails(&s->line[0], c);
    write_start(TOP + (rows ? rows : 1) * ROW + BOTTOM, out);
    if (rows == 0 && s->line[0].at.n)
        write_rect(LEFT, TOP + 2, WIDTH, ROW - 4, good, out);
    rows = 0;
    for (uint32_t c = 0; c < s->check.n; c++)
        if (ever_fails(&s->line[0], c))
            write_row(arena, s, c, TOP + rows++ * ROW, out);
    write_current(&s->axis[0], TOP, TOP + (rows ? rows : 1) * ROW, out);
    write_axis(arena, &s->axis[0], TOP + (rows ? rows : 1) * ROW, out);
}

// Draws each pair of values as a rectangle with the number of checks that fail.
static void write_map(Arena *arena, const Sweep *s, Buf *out)
{
    const SweepAxis *a = &s->axis[0], *b = &s->axis[1];
    const double w = WIDTH / a->n, h = b->n > 20 ? 360.0 / b->n : ROW;

    write_start(TOP + h * b->n + BOTTOM, out);
    for (uint32_t i = 0; i < s->point.n; i++) {
        const SweepPoint *p = &s->point.at[i];
        const double x = LEFT + w * (i / b->n), y = TOP + h * (b->n - 1 - i % b->n);
        write_rect(x, y, w, h, p->failing ? bad : good, out);
        if (p->failing && w > 16 && h > 11)
            buf_printf(out, "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"middle\" fill=\"#fff\">%lu</text>\n", x + w / 2, y + h / 2 + 4,
                       (unsigned long)p->failing);
    }
    write_label(LEFT - 8, TOP + 10, "end", number_text(arena, b, b->value[b->n - 1]), out);
    write_label(LEFT - 8, TOP + h * b->n, "end", number_text(arena, b, b->value[0]), out);
    write_label(LEFT - 8, TOP + h * b->n / 2 + 4, "end", b->parameter->name->text, out);
    write_axis(arena, a, TOP + h * b->n, out);
}

void sweep_write_svg(Arena *arena, const Sweep *s, Buf *out)
{
    if (s->options.axes == 2)
        write_map(arena, s, out);
    else
        write_rows(arena, s, out);
    buf_str(out, "</svg>\n");
}
