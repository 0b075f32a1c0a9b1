// SPDX-License-Identifier: Apache-2.0
// The states of a run as bands.  A state has a colour (page_style.c) and a pattern; their combination is unique for the first 32 states.
#include <string.h>

#include "compiler/report/plot.h"

// TINTS_MOST: with more visits, the rows are not tinted by state.  LETTER: approximate width of a character, in tenths of a unit.
enum { COLOURS = 8, PATTERNS = 4, TINTS_MOST = 200, LETTER = 68 };

const char plot_defs[] =
    "<defs>\n"
    "<pattern id=\"hatch1\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\"><path class=\"hatch\" d=\"M0 6L6 0\"/></pattern>\n"
    "<pattern id=\"hatch2\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><path class=\"hatch\" d=\"M0 2.5H5\"/></pattern>\n"
    "<pattern id=\"hatch3\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\"><path class=\"hatch\" d=\"M0 0L6 6\"/></pattern>\n"
    "</defs>";

// Returns an invisible drawing that plots refer to; a page includes it once.
const char *plot_patterns(Arena *arena)
{
    return format_in(arena, "<svg class=\"plot\" aria-hidden=\"true\" style=\"position:absolute;width:0;height:0\">%s</svg>\n", plot_defs);
}

// A rectangle in the colour of the state. States beyond the number of colours have a hatch on top.
static void draw_swatch(Plot *p, const State *s, long x, long y, long wide, long high)
{
    const unsigned n = s->number - 1u, pattern = (n + n / COLOURS) % PATTERNS;

    plot_draw_rect(p, format_in(p->out->arena, "s%u", n % COLOURS), x, y, wide, high);
    if (pattern == 0)
        return;
    buf_str(p->out, "<rect x=\"");
    plot_write_tenths(p->out, x);
    buf_str(p->out, "\" y=\"");
    plot_write_tenths(p->out, y);
    buf_str(p->out, "\" width=\"");
    plot_write_tenths(p->out, wide);
    buf_str(p->out, "\" height=\"");
    plot_write_tenths(p->out, high);
    buf_printf(p->out, "\" fill=\"url(#hatch%u)\"/>\n", pattern);
}

static long name_width(const char *text) { return (long)strlen(text) * LETTER; }

// Writes the name if it fits, otherwise the number.
static void draw_name(Plot *p, const State *s, long x, long wide)
{
    const char *number = format_in(p->out->arena, "%u", (unsigned)s->number);
    const char *text = name_width(s->name->text) + 60 < wide ? s->name->text : name_width(number) + 20 < wide ? number : NULL;

    if (text)
        plot_draw_text(p, "name", "middle", x + wide / 2, PLOT_BAND - 65, text);
}

// Visit i as a part of the band at the top, and as a tint over the plots unless these would be too many.
static void draw_band(Plot *p, size_t i)
{
    const Trace *t = p->t;
    const TraceVisit *v = &t->visit.at[i];
    const double end = i + 1 < t->visit.n ? v[1].plot_step : (double)t->steps;
    const long from = plot_x_of_step(t, v->plot_step), wide = plot_x_of_step(t, end) - from;

    if (wide <= 0)
        return;
    draw_swatch(p, v->state, from, 0, wide, PLOT_BAND);
    if (t->visits <= TINTS_MOST) {
        plot_draw_rect(p, format_in(p->out->arena, "tint s%u", (unsigned)(v->state->number - 1u) % COLOURS), from, p->top, wide,
                       p->bottom - p->top);
        if (i > 0)
            plot_draw_line(p, "cut", from, PLOT_BAND, from, p->bottom);
    }
    draw_name(p, v->state, from, wide);
}

// Draws the states as bands at the top, and as tints behind the rows.
void plot_draw_bands(Plot *p)
{
    for (size_t i = 0; i < p->t->visit.n; i++)
        draw_band(p, i);
    if (p->t->visits > TRACE_VISITS_MAX)
        plot_draw_text(p, "dim", "end", PLOT_RIGHT, PLOT_BAND - 65, "the state changes too often to be drawn");
}

// Returns the y of the legend's end.
long plot_draw_legend(Plot *p, long y)
{
    long x = PLOT_LEFT;

    for (size_t s = 0; s < p->t->p->state.n; s++) {
        const State *state = p->t->p->state.at[s];
        const char *text = format_in(p->out->arena, "%u %s", (unsigned)state->number, state->name->text);
        if (p->t->entered[s] == 0)
            continue;
        if (x + 300 + name_width(text) > PLOT_RIGHT && x > PLOT_LEFT) {
            x = PLOT_LEFT;
            y += 200;
        }
        draw_swatch(p, state, x, y, 220, 130);
        plot_draw_text(p, "t", "start", x + 270, y + 110, text);
        x += 430 + name_width(text);
    }
    return y + 180;
}
