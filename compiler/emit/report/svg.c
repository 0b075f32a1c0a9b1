// SPDX-License-Identifier: Apache-2.0
// A diagram as SVG.
#include "compiler/emit/report/graph.h"

static void put_state(Buf *out, const State *s, unsigned row)
{
    buf_printf(out, "<g><title>%s</title><rect x=\"20\" y=\"%u\" width=\"200\" height=\"32\" rx=\"8\" fill=\"none\" stroke=\"gray\"/>",
               s->name->text, 20 + 60 * row);
    buf_printf(out, "<text x=\"120\" y=\"%u\" text-anchor=\"middle\">%s</text></g>\n", 41 + 60 * row, s->name->text);
}

static void put_transition(Buf *out, const Transition *t)
{
    const unsigned from = 60 * t->from->number - 24, to = 60 * t->to->number - 24;

    buf_printf(out, "<path d=\"M220 %uC260 %u 260 %u 220 %u\" fill=\"none\" stroke=\"gray\"/>\n", from, from, to, to);
}

void graph_svg(const Analysis *a, const GraphOptions *o, Buf *out)
{
    const unsigned height = 60 * (unsigned)a->p->state.n + 20;

    (void)o;
    buf_printf(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"smc-graph\" role=\"img\" viewBox=\"0 0 300 %u\" width=\"300\" "
                    "height=\"%u\">\n", height, height);
    buf_printf(out, "<title>State diagram of %s</title>\n", a->p->name->text);
    for (size_t i = 0; i < a->p->state.n; i++)
        put_state(out, a->p->state.at[i], (unsigned)i);
    for (size_t i = 0; i < a->transition.n; i++)
        put_transition(out, &a->transition.at[i]);
    buf_str(out, "</svg>\n");
}
