// SPDX-License-Identifier: Apache-2.0
// Draws a run: the states as a band, and below it every element that changes, over one time axis.  Numbers are drawn as the machine reads
// them, in steps.  A bucket with several values is drawn from its smallest to its largest.  Bools are strips.
#include "compiler/report/plot.h"

#include <stdio.h>
#include <string.h>

#include "compiler/report/comment.h"
#include "compiler/report/xml.h"

// ---- helpers ----

// Writes 123 as 12.3.
void plot_write_tenths(Buf *out, long x)
{
    buf_printf(out, "%s%ld", x < 0 ? "-" : "", (x < 0 ? -x : x) / 10);
    if (x % 10)
        buf_printf(out, ".%ld", (x < 0 ? -x : x) % 10);
}

// Returns the x where a step, or a fraction of one, begins.
long plot_x_of_step(const Trace *t, double step)
{
    return PLOT_LEFT + (long)((double)(PLOT_RIGHT - PLOT_LEFT) * (step / (double)t->steps));
}

static void write_length(Buf *out, const char *name, long x)
{
    buf_printf(out, " %s=\"", name);
    plot_write_tenths(out, x);
    buf_char(out, '"');
}

void plot_draw_line(Plot *p, const char *class_name, long x1, long y1, long x2, long y2)
{
    buf_printf(p->out, "<line class=\"%s\"", class_name);
    write_length(p->out, "x1", x1);
    write_length(p->out, "y1", y1);
    write_length(p->out, "x2", x2);
    write_length(p->out, "y2", y2);
    buf_str(p->out, "/>\n");
}

void plot_draw_rect(Plot *p, const char *class_name, long x, long y, long wide, long high)
{
    buf_printf(p->out, "<rect class=\"%s\"", class_name);
    write_length(p->out, "x", x);
    write_length(p->out, "y", y);
    write_length(p->out, "width", wide);
    write_length(p->out, "height", high);
    buf_str(p->out, "/>\n");
}

// Writes text of a class; `anchor` aligns its start, middle or end at x.
void plot_draw_text(Plot *p, const char *class_name, const char *anchor, long x, long y, const char *text)
{
    buf_printf(p->out, "<text class=\"%s\" text-anchor=\"%s\"", class_name, anchor);
    write_length(p->out, "x", x);
    write_length(p->out, "y", y);
    buf_char(p->out, '>');
    xml_write_str(p->out, text);
    buf_str(p->out, "</text>\n");
}

// Returns a round step size of which about `about` multiples are between lo and hi; 0 if no such size exists.
double plot_round_step(double lo, double hi, int about)
{
    const double wanted = (hi - lo) / about;
    double step = 1;

    if (!(wanted > 1e-300) || wanted > 1e300)
        return 0;
    while (step < wanted)
        step *= 10;
    while (step / 10 >= wanted)
        step /= 10;
    return step / 5 >= wanted ? step / 5 : step / 2 >= wanted ? step / 2 : step;
}

// Returns x as text with at most five digits, unless it is a whole number below 10^7.
const char *plot_label(Arena *arena, double x)
{
    char digits[40];
    Buf b;

    buf_init(&b, arena);
    snprintf(digits, sizeof digits, x > -1e7 && x < 1e7 && x == (double)(long)x ? "%.0f" : "%.5g", x == 0 ? 0.0 : x);
    for (const char *c = digits; *c; c++)             // the decimal point depends on the locale
        buf_char(&b, strchr("0123456789+-einfa", *c) ? *c : '.');
    return buf_text(&b);
}

// ---- a row of numbers ----

typedef struct PlotRow {
    const TraceSeries *s;
    double lo, hi;                // range of the row
    long top;                     // y of the upper edge of its frame
} PlotRow;

static bool is_finite(double x) { return x - x == 0; }

// Widens the range of values that the row shows to include x; NaN and infinities are ignored.
static void extend_row(PlotRow *r, double x)
{
    if (!is_finite(x))
        return;
    r->lo = x < r->lo ? x : r->lo;
    r->hi = x > r->hi ? x : r->hi;
}

static void extend_row_by_series(PlotRow *r, const Trace *t, const TraceSeries *s)
{
    for (size_t i = 0; i < trace_buckets(t); i++) {
        extend_row(r, s->at[i].lo);
        extend_row(r, s->at[i].hi);
    }
}

// Computes the range of values of a row, with a margin of 1/16 on each side.
static PlotRow measure_row(const Trace *t, const TraceSeries *s, long top)
{
    PlotRow r = {s, 1e308 * 10, -1e308 * 10, top};
    double margin;

    extend_row_by_series(&r, t, s);
    for (size_t i = 0; i < t->recorded.n; i++)
        if (t->recorded.at[i]->v == s->v)
            extend_row_by_series(&r, t, t->recorded.at[i]);
    if (r.lo > r.hi)
        r.lo = r.hi = 0;                              // no value is finite: any range does
    margin = r.hi / 16 - r.lo / 16;
    r.lo -= margin > 0 ? margin : 1;
    r.hi += margin > 0 ? margin : 1;
    return r;
}

// Returns the y at which a value is drawn in its row.
static long y_of_value(const PlotRow *r, double x)
{
    const double share = (x / 2 - r->lo / 2) / (r->hi / 2 - r->lo / 2);       // halved, because the difference could overflow

    return r->top + PLOT_ROW - (long)((double)PLOT_ROW * (!(share > 0) ? 0 : share > 1 ? 1 : share));
}

// Whether a script compares v with recorded values, which are drawn with it.
static bool has_recorded(const Trace *t, const Var *v)
{
    for (size_t i = 0; i < t->recorded.n; i++)
        if (t->recorded.at[i]->v == v)
            return true;
    return false;
}

static void draw_title(Plot *p, const Var *v, long top)
{
    const char *comment = comment_of_variable(p->out->arena, v);

    buf_str(p->out, "<text class=\"t\"");
    write_length(p->out, "x", PLOT_LEFT + 40);
    write_length(p->out, "y", top + PLOT_TITLE - 50);
    buf_printf(p->out, "><tspan font-weight=\"600\">%s</tspan>", v->name->text);
    if (v->unit)
        buf_printf(p->out, " (%s)", v->unit->text);
    if (comment) {
        buf_str(p->out, " <tspan class=\"dim\">");
        xml_write_str(p->out, comment);
        buf_str(p->out, "</tspan>");
    }
    if (has_recorded(p->t, v))
        buf_printf(p->out, " <tspan class=\"recorded-name\">%s: recorded</tspan>", v->type == SM_BOOL ? "lower half" : "dashed");
    buf_str(p->out, "</text>\n");
}

// Horizontal grid lines at round values, with labels at the left; none where doubles are too coarse for such a step.
static void draw_grid(Plot *p, const PlotRow *r)
{
    const double step = plot_round_step(r->lo, r->hi, 4);
    double first;

    if (step <= 0 || r->lo / step < -1e15 || r->hi / step > 1e15)
        return;
    first = (double)(int64_t)(r->lo / step);
    for (int i = -1; i < 12; i++) {
        const double x = (first + i) * step;
        if (x < r->lo || x > r->hi)
            continue;
        plot_draw_line(p, "grid", PLOT_LEFT, y_of_value(r, x), PLOT_RIGHT, y_of_value(r, x));
        plot_draw_text(p, "dim", "end", PLOT_LEFT - 60, y_of_value(r, x) + 40, plot_label(p->out->arena, x));
    }
}

typedef struct Pen { Buf *out; long x, y; bool down; } Pen;

// Begins a new segment of the path at (x, y) unless one is open.
static void pen_lower(Pen *pen, long x, long y)
{
    if (pen->down)
        return;
    *pen = (Pen){pen->out, x, y, true};
    buf_char(pen->out, 'M');
    plot_write_tenths(pen->out, x);
    buf_char(pen->out, ' ');
    plot_write_tenths(pen->out, y);
}

// Draws up to x, then lifts the pen.
static void pen_lift(Pen *pen, long x)
{
    if (!pen->down)
        return;
    buf_char(pen->out, 'H');
    plot_write_tenths(pen->out, x);
    pen->down = false;
}

// Draws a horizontal line to x, then a vertical one to y.  Draws nothing if y has not changed: a later call draws the horizontal line.
static void pen_line_to(Pen *pen, long x, long y)
{
    if (y == pen->y)
        return;
    if (x != pen->x) {
        buf_char(pen->out, 'H');
        plot_write_tenths(pen->out, x);
    }
    buf_char(pen->out, 'V');
    plot_write_tenths(pen->out, y);
    pen->x = x;
    pen->y = y;
}

// One path through all buckets; each shows its first, lowest, highest and last value. A bucket of NaN interrupts the path.
static void draw_curve(Plot *p, const char *class_name, const PlotRow *r, const TraceSeries *s)
{
    const TraceBucket *b = s->at;
    Pen pen = {p->out, PLOT_LEFT, 0, false};

    buf_printf(p->out, "<path class=\"%s\" d=\"", class_name);
    for (size_t i = 0; i < trace_buckets(p->t); i++) {
        const long x = plot_x_of_step(p->t, (double)(i * p->t->per));
        if (b[i].first != b[i].first) {
            pen_lift(&pen, x);
            continue;
        }
        pen_lower(&pen, x, y_of_value(r, b[i].first));
        pen_line_to(&pen, x, y_of_value(r, b[i].first));
        pen_line_to(&pen, x, y_of_value(r, b[i].lo));
        pen_line_to(&pen, x, y_of_value(r, b[i].hi));
        pen_line_to(&pen, x, y_of_value(r, b[i].last));
    }
    pen_lift(&pen, PLOT_RIGHT);
    buf_str(p->out, "\"/>\n");
}

// Marks the beginnings of visits of states on the curve; none in a plot with very many visits.
static void draw_circles(Plot *p, const PlotRow *r)
{
    enum { MOST = 100 };

    for (size_t i = 0; i < p->t->visit.n && p->t->visits <= MOST; i++) {
        const TraceVisit *v = &p->t->visit.at[i];
        if (r->s->at[v->step / p->t->per].last != r->s->at[v->step / p->t->per].last)
            continue;
        buf_str(p->out, "<circle class=\"begin\"");
        write_length(p->out, "cx", plot_x_of_step(p->t, v->plot_step));
        write_length(p->out, "cy", y_of_value(r, r->s->at[v->step / p->t->per].last));
        buf_str(p->out, " r=\"3.4\"/>\n");
    }
}

// The plot of one number over time: title, grid, curve, and recorded values where a script has these.
static void draw_row(Plot *p, const TraceSeries *s, long top)
{
    const PlotRow r = measure_row(p->t, s, top + PLOT_TITLE);

    draw_title(p, s->v, top);
    draw_grid(p, &r);
    plot_draw_rect(p, "frame", PLOT_LEFT, r.top, PLOT_RIGHT - PLOT_LEFT, PLOT_ROW);
    draw_curve(p, "trace", &r, s);
    for (size_t i = 0; i < p->t->recorded.n; i++)
        if (p->t->recorded.at[i]->v == s->v)
            draw_curve(p, "recorded", &r, p->t->recorded.at[i]);
    draw_circles(p, &r);
    if (s->infinite)
        plot_draw_text(p, "dim", "end", PLOT_RIGHT, top + PLOT_TITLE - 50, "infinite at times");
    else if (s->nan)
        plot_draw_text(p, "dim", "end", PLOT_RIGHT, top + PLOT_TITLE - 50, "not a number (nan) in the gaps");
}

// ---- a strip of a bool ----

// A rectangle over the buckets `from` to before `to`: a span in which a boolean is true.
static void draw_strip_part(Plot *p, const char *class_name, size_t from, size_t to, long top, long high)
{
    const uint64_t end = to * p->t->per < p->t->steps ? to * p->t->per : p->t->steps;
    const long x = plot_x_of_step(p->t, (double)(from * p->t->per));

    plot_draw_rect(p, class_name, x, top, plot_x_of_step(p->t, (double)end) - x, high);
}

// Returns 2 if the bool was true in all steps of a bucket, 1 if in some, 0 if in none.
static int strip_level(const TraceBucket *b) { return b->lo > 0 ? 2 : b->hi > 0 ? 1 : 0; }

// Draws where a bool is true.
static void draw_strip_parts(Plot *p, const TraceSeries *s, const char *on, long top, long high)
{
    const size_t n = trace_buckets(p->t);
    size_t from = 0;

    for (size_t i = 1; i <= n; i++) {
        const int now = strip_level(&s->at[from]);
        if (i < n && strip_level(&s->at[i]) == now)
            continue;
        if (now)
            draw_strip_part(p, now == 2 ? on : "both", from, i, top, high);
        from = i;
    }
}

// The plot of one boolean over time: a bar where it is true. Recorded values share the strip, in its lower half.
static void draw_strip(Plot *p, const TraceSeries *s, long top)
{
    const long high = has_recorded(p->t, s->v) ? PLOT_STRIP / 2 : PLOT_STRIP;

    draw_title(p, s->v, top);
    top += PLOT_TITLE;
    draw_strip_parts(p, s, "on", top, high);
    for (size_t i = 0; i < p->t->recorded.n; i++)
        if (p->t->recorded.at[i]->v == s->v)
            draw_strip_parts(p, p->t->recorded.at[i], "recorded-on", top + high, PLOT_STRIP - high);
    plot_draw_rect(p, "frame", PLOT_LEFT, top, PLOT_RIGHT - PLOT_LEFT, PLOT_STRIP);
}

// ---- the whole plot ----

// Draws the rows of bools (strips) or of numbers from y on, or only measures them if !draw.  Returns the y of their end.
static long draw_rows(Plot *p, bool strips, bool draw, long y)
{
    for (size_t i = 0; i < p->t->series.n; i++) {
        const TraceSeries *s = p->t->series.at[i];
        if ((!s->changes && !has_recorded(p->t, s->v)) || (s->v->type == SM_BOOL) != strips)
            continue;
        if (draw && strips)
            draw_strip(p, s, y);
        else if (draw)
            draw_row(p, s, y);
        y += PLOT_TITLE + (strips ? PLOT_STRIP : PLOT_ROW) + PLOT_GAP;
    }
    return y;
}

// The label of the time axis: the given one, or the unit and comment of G.
static const char *describe_axis(const Plot *p)
{
    const Var *g = p->t->p->g;
    const char *comment;

    if (p->t->axis)
        return p->t->axis;
    comment = comment_of_variable(p->out->arena, g);
    return format_in(p->out->arena, "Time, G%s%s%s%s%s", g->unit ? " (" : "", g->unit ? g->unit->text : "", g->unit ? ")" : "", comment ? ": " : "",
                     comment ? comment : "");
}

static void draw_time_axis(Plot *p)
{
    const Trace *t = p->t;
    const double unit = t->unit > 0 ? t->unit : 1, span = (double)(t->last_g - t->first_g) * unit, from = (double)t->first_g * unit;
    const double step = plot_round_step(0, span, 8);

    for (int i = 0; step > 0 && i < 20 && i * step <= span; i++) {
        const long x =
            PLOT_LEFT + (long)((double)(PLOT_RIGHT - PLOT_LEFT) * (i * step / span) * ((double)(t->steps - 1) / (double)t->steps));
        plot_draw_line(p, "grid", x, p->bottom, x, p->bottom + 50);
        plot_draw_text(p, "dim", x > PLOT_RIGHT - 150 ? "end" : "middle", x, p->bottom + 170,
                       plot_label(p->out->arena, from + i * step));
    }
    plot_draw_text(p, "dim", "start", PLOT_LEFT, p->bottom + 310, describe_axis(p));
}

// Draws everything inside the <svg> tag; returns the height of the drawing.
long plot_draw_body(Arena *arena, const Trace *t, Buf *out)
{
    Plot p = {out, t, PLOT_BAND + PLOT_GAP, 0};
    long y;

    buf_init(out, arena);
    p.bottom = draw_rows(&p, true, false, draw_rows(&p, false, false, p.top));
    plot_draw_bands(&p);
    y = draw_rows(&p, false, true, p.top);
    draw_rows(&p, true, true, y);
    draw_time_axis(&p);
    return plot_draw_legend(&p, p.bottom + 420);
}

// Plots the states of a run over time, and below them each series that changes.
const char *plot_draw_run(Arena *arena, const Trace *t)
{
    Buf body, out;
    const long y = plot_draw_body(arena, t, &body);

    buf_init(&out, arena);
    buf_printf(&out,
               "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" role=\"img\" aria-label=\"States and values over time\" "
               "viewBox=\"0 0 %d ",
               PLOT_WIDE / 10);
    plot_write_tenths(&out, y);
    buf_str(&out, "\">\n");
    buf_put(&out, body.at, body.n);
    buf_str(&out, "</svg>\n");
    return buf_text(&out);
}
