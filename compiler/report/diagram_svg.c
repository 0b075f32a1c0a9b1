// SPDX-License-Identifier: Apache-2.0
// A diagram as SVG.  All coordinates are whole numbers, so that the output is the same on every computer.
#include <stdio.h>

#include "compiler/report/diagram_layout.h"
#include "compiler/report/diagram_notes.h"
#include "compiler/report/xml.h"

// ---- style ----

// The style of each class of elements, for light and for dark screens.  Shapes convey the same information as colours.
//   STYLE(selector, light, dark)
typedef struct DiagramColour { const char *selector, *light, *dark; } DiagramColour;

static const DiagramColour colours[] = {
    {".g-back", "fill:#fff", "fill:#15191f"},
    {"text", "fill:#1c2430", "fill:#e3e8ef"},
    {".g-guard", "fill:#3a4656", "fill:#c3ccd8"},
    {".g-line", "stroke:#6a7787", "stroke:#94a1b3"},
    {".g-head,.g-start", "fill:#6a7787", "fill:#94a1b3"},
    {".g-state", "fill:#eef3f9;stroke:#46566b", "fill:#222c3a;stroke:#9fb0c6"},
    {".g-abort", "fill:#fdeae4;stroke:#b5320f", "fill:#3d1d14;stroke:#ff9a78"},
    {".g-safe", "fill:#e3f3f1;stroke:#0c7268", "fill:#11322f;stroke:#5cc9bb"},
    {".g-rule", "stroke:#c9d0d9", "stroke:#465060"},
    {".g-unrun .g-line,.g-unrun .g-box", "stroke:#8a3ffc", "stroke:#c4a1ff"},
    {".g-mark", "fill:#ffcf33;stroke:#5c4700", "fill:#ffcf33;stroke:#5c4700"},
    {".g-mark.g-error", "fill:#d92d20;stroke:#7a130b", "fill:#ff6b5e;stroke:#7a130b"},
    {".g-bang", "fill:#3d2f00", "fill:#3d2f00"},
};

// Colours that only a diagram of changes uses, for light and dark screens.
static const DiagramColour change_colours[] = {
    {".g-added .g-line,.g-added .g-box", "stroke:#1a7f37", "stroke:#56d364"},
    {".g-removed .g-line,.g-removed .g-box", "stroke:#cf222e", "stroke:#ff7b72"},
    {".g-changed .g-line,.g-changed .g-box", "stroke:#9a6700", "stroke:#e3b341"},
};

static const char change_style[] =
    ".smc-graph .g-added .g-line,.smc-graph .g-added .g-box{stroke-width:3}\n"
    ".smc-graph .g-removed .g-line,.smc-graph .g-removed .g-box{stroke-dasharray:6 4}\n"
    ".smc-graph .g-removed text{text-decoration:line-through}\n"
    ".smc-graph .g-changed .g-line,.smc-graph .g-changed .g-box{stroke-width:2.4;stroke-dasharray:12 3 2 3}\n";

// The styles that are the same for light and dark screens.
static const char common_style[] =
    ".smc-graph text{font-family:Helvetica,Arial,sans-serif;font-size:11px}\n"
    ".smc-graph .g-name{font-size:13px;font-weight:bold;text-anchor:middle}\n"
    ".smc-graph .g-all .g-name{font-style:italic}\n"
    ".smc-graph .g-to{font-weight:bold;text-anchor:middle}\n"
    ".smc-graph .g-mid{text-anchor:middle}\n"
    ".smc-graph .g-end{text-anchor:end}\n"
    ".smc-graph .g-block{font-style:italic}\n"
    ".smc-graph .g-line{fill:none}\n"
    ".smc-graph .g-box{stroke-width:1.4}\n"
    ".smc-graph .g-abort,.smc-graph .g-safe{stroke-width:2.2}\n"
    ".smc-graph .g-in{fill:none;stroke-width:1}\n.smc-graph .g-rule{stroke-width:1}\n"
    ".smc-graph .g-never .g-line,.smc-graph .g-never .g-box{stroke-dasharray:5 4}\n"
    ".smc-graph .g-never text{font-style:italic}\n"
    ".smc-graph .g-unrun .g-line,.smc-graph .g-unrun .g-box{stroke-dasharray:1 4;stroke-linecap:round}\n"
    ".smc-graph .g-unrun text{font-weight:normal}\n"
    ".smc-graph .g-edge:hover .g-line{stroke-width:3}\n"
    ".smc-graph .g-bang{font-weight:bold;font-size:9px;text-anchor:middle}\n";

// Writes the selectors of a comma-separated list, each with a prefix that limits the style to elements of the diagram.
static void write_selector(Buf *out, const char *selector)
{
    buf_str(out, ".smc-graph ");
    for (; *selector; selector++) {
        buf_char(out, *selector);
        if (*selector == ',')
            buf_str(out, ".smc-graph ");
    }
}

static void write_colours(Buf *out, const DiagramColour *colour, size_t n, bool dark)
{
    for (size_t i = 0; i < n; i++) {
        write_selector(out, colour[i].selector);
        buf_printf(out, "{%s}\n", dark ? colour[i].dark : colour[i].light);
    }
}

static void write_style(Buf *out, bool has_changes)
{
    buf_printf(out, "<style>\n%s%s", common_style, has_changes ? change_style : "");
    for (int dark = 0; dark < 2; dark++) {
        buf_str(out, dark ? "@media screen and (prefers-color-scheme:dark){\n" : "");
        write_colours(out, colours, sizeof colours / sizeof *colours, dark);
        if (has_changes)
            write_colours(out, change_colours, sizeof change_colours / sizeof *change_colours, dark);
    }
    buf_str(out, "}\n</style>\n");
}

// ---- pieces ----

static void write_text(Buf *out, const char *class, int32_t x, int32_t y, const char *text)
{
    buf_printf(out, "<text class=\"%s\" x=\"%ld\" y=\"%ld\">", class, (long)x, (long)y);
    xml_write_str(out, text);
    buf_str(out, "</text>");
}

typedef enum ArrowDirection { DOWN, UP, RIGHT, LEFT } ArrowDirection;

static void write_arrowhead(Buf *out, Point tip, ArrowDirection to)
{
    static const char *const shape[] = {"l-4 -9h8z", "l-4 9h8z", "l-9 -4v8z", "l9 -4v8z"};

    buf_printf(out, "<path class=\"g-head\" d=\"M%ld %ld%s\"/>", (long)tip.x, (long)tip.y, shape[to]);
}

// Writes the mark of a state or guard with findings: the number of its note, coloured by severity.  The findings are its tooltip.
static void write_mark(Buf *out, const DiagramFindings *f, uint32_t number, int32_t x, int32_t y)
{
    char text[12];

    bool error = false;

    if (f->n == 0)
        return;
    for (size_t i = 0; i < f->n; i++)
        error = error || f->at[i]->severity == DIAG_ERROR;
    buf_printf(out, "<g><title>");
    for (size_t i = 0; i < f->n; i++) {
        buf_printf(out, "%s%s: ", i ? "\n" : "", diag_info[f->at[i]->code].id);
        xml_write_str(out, f->at[i]->text);
    }
    buf_printf(out, "</title><path class=\"g-mark%s\" d=\"M%ld %ldl8 14h-16z\"/>", error ? " g-error" : "", (long)x, (long)y - 8);
    snprintf(text, sizeof text, "%lu", (unsigned long)number);
    write_text(out, "g-bang", x, y + 5, text);
    buf_str(out, "</g>");
}

// Returns the CSS class " g-unrun" if no run has executed the state or edge, otherwise "".
static const char *css_class_of_count(const Diagram *d, uint64_t count) { return d->o->counts && count == 0 ? " g-unrun" : ""; }

// Returns the CSS class of what happened from one machine to the next; "" if nothing did.
static const char *css_class_of_change(DiagramChange c)
{
    static const char *const name[] = {"", " g-added", " g-removed", " g-changed"};

    return name[c];
}

// ---- states ----

static const char *box_class(const DiagramNode *n)
{
    return !n->state ? "g-box g-state" : n->state->is_abort ? "g-box g-abort" : n->state->is_safe ? "g-box g-safe" : "g-box g-state";
}

static void write_rectangle(Buf *out, const char *class, Box b, long corner)
{
    buf_printf(out, "<rect class=\"%s\" x=\"%ld\" y=\"%ld\" width=\"%ld\" height=\"%ld\" rx=\"%ld\"/>", class, (long)b.x, (long)b.y,
               (long)b.w, (long)b.h, corner);
}

// Draws the outline of a section [all_states]: a stack of sharp-cornered boxes, because it represents several states.
static void write_stack(Buf *out, Box b)
{
    for (int32_t behind = 2; behind >= 0; behind--)
        write_rectangle(out, "g-box g-state", (Box){b.x + behind * STACK, b.y - behind * STACK, b.w, b.h}, 0);
}

// Draws the outline of a state: cut corners for @abort, round ends for @safe, rounded corners for others.  `in`: inset from the box.
static void write_outline(Buf *out, const char *class, const DiagramNode *n, Box b, int32_t in)
{
    const long x = b.x + in, y = b.y + in, w = b.w - 2 * in, h = b.h - 2 * in;
    const long name_h = b.h < NAME_H ? h : NAME_H - 2 * in, cut = name_h / 3;       // computed from the name's part of the box, so that actions do not enlarge the corners

    if (n->state->is_abort)
        buf_printf(out, "<path class=\"%s\" d=\"M%ld %ldh%ldl%ld %ldv%ldl-%ld %ldh-%ldl-%ld -%ldv-%ldz\"/>", class, x + cut, y,
                   w - 2 * cut, cut, cut, h - 2 * cut, cut, cut, w - 2 * cut, cut, cut, h - 2 * cut);
    else
        write_rectangle(out, class, (Box){b.x + in, b.y + in, b.w - 2 * in, b.h - 2 * in}, n->state->is_safe ? name_h / 2 : name_h / 5);
}

// The tooltip of an [all_states] box.
static void write_section_title(Buf *out, const DiagramNode *n)
{
    buf_str(out, "<title>[all_states]: ");
    xml_write_str(out, n->title);
    buf_printf(out, "%s</title>", n->reached ? "" : ", unreachable");
}

// The tooltip of a state: name, properties, number of visits when scripts were counted, and states from which a stub leads to it.
static void write_state_title(Buf *out, const Diagram *d, const DiagramNode *n)
{
    buf_str(out, "<title>");
    xml_write_str(out, n->title);
    buf_printf(out, "%s%s%s%s%s", n->state->number == 1 ? ", initial state" : "", n->state->is_abort ? ", @abort" : "",
               n->state->is_safe ? ", @safe" : "", n->state->allows_swap ? ", @swap" : "", n->reached ? "" : ", unreachable");
    if (d->o->counts)
        buf_printf(out, "\n%s", diagram_count_text(d, "entered", diagram_times_entered(d, n)));
    for (size_t i = 0; i < n->stub_in.n; i++) {
        buf_str(out, i ? ", " : "\nreached from ");
        xml_write_str(out, d->node[d->edge.at[n->stub_in.at[i]].from].title);
    }
    buf_str(out, "</title>");
}

static void write_actions(Buf *out, const DiagramNode *n)
{
    const int32_t left = n->box.x + ACTION_SIDE;
    int32_t y = n->box.y + NAME_H;

    if (n->action.n)
        buf_printf(out, "<path class=\"g-rule\" d=\"M%ld %ldh%ld\"/>", (long)left, (long)y - 4, (long)n->box.w - 2 * ACTION_SIDE);
    for (size_t i = 0; i < n->action.n; i++, y += GUARD_LINE) {
        if (n->action.at[i].first)
            write_text(out, "g-block", left, y + 11, n->action.at[i].block_name);
        write_text(out, "g-guard", left + ACTION_LABEL_W, y + 11, n->action.at[i].text);
    }
}

static void write_state(Buf *out, const Diagram *d, const DiagramNode *n)
{
    const Box b = n->box;
    const int32_t middle = b.y + b.h / 2;

    buf_printf(out, "<g class=\"g-node%s%s%s\">", n->reached ? "" : " g-never", css_class_of_count(d, diagram_times_entered(d, n)), css_class_of_change(n->change));
    write_state_title(out, d, n);
    write_outline(out, box_class(n), n, b, 0);
    if (n->state->is_safe)
        write_outline(out, n->state->is_abort ? "g-in g-abort" : "g-in g-safe", n, b, 4);
    write_text(out, "g-name", b.x + b.w / 2, b.y + NAME_H / 2 + 5, n->name);
    write_actions(out, n);
    if (n->from) {
        const Point tip = {b.x, middle};
        write_text(out, "g-guard g-end", b.x - 26, middle + 4, n->from);
        buf_printf(out, "<path class=\"g-line\" d=\"M%ld %ldh14\"/>", (long)b.x - 22, (long)middle);
        write_arrowhead(out, tip, RIGHT);
    }
    write_mark(out, &n->finding, n->mark, b.x + b.w - 2, b.y);
    buf_str(out, "</g>\n");
}

// The box of an [all_states] section, drawn as a stack of boxes because it stands for several states.
static void write_section(Buf *out, const Diagram *d, const DiagramNode *n)
{
    const Box b = n->box;

    buf_printf(out, "<g class=\"g-node g-all%s%s\">", n->reached ? "" : " g-never", css_class_of_count(d, diagram_times_entered(d, n)));
    write_section_title(out, n);
    write_stack(out, b);
    write_text(out, "g-name", b.x + b.w / 2, b.y + NAME_H / 2 + 5, n->name);
    write_actions(out, n);
    write_mark(out, &n->finding, n->mark, b.x + b.w - 2, b.y);
    buf_str(out, "</g>\n");
}

static void write_start_arrow(Buf *out, const DiagramNode *n)
{
    const Point tip = {n->box.x + n->box.w / 2, n->box.y};

    buf_printf(out, "<g><title>initial state</title><circle class=\"g-start\" cx=\"%ld\" cy=\"%ld\" r=\"5\"/>", (long)tip.x,
               (long)tip.y - 24);
    buf_printf(out, "<path class=\"g-line\" d=\"M%ld %ldv-16\"/>", (long)tip.x, (long)tip.y - 6);
    write_arrowhead(out, tip, DOWN);
    buf_str(out, "</g>\n");
}

// ---- transitions ----

// The tooltip of an edge: both states, and the condition of each transition that the edge draws.
static void write_edge_title(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    buf_str(out, "<title>");
    xml_write_str(out, d->node[e->from].title);
    buf_str(out, " to ");
    xml_write_str(out, d->node[e->to].title);
    for (size_t g = 0; g < e->guard.n; g++) {
        buf_str(out, g ? "\nor: " : ": ");
        xml_write_str(out, e->guard.at[g].text);
        buf_str(out, e->guard.at[g].possible ? "" : " (never)");
    }
    if (d->o->counts)
        buf_printf(out, "\n%s", diagram_times_taken_text(d, e));
    buf_str(out, "</title>");
}

// Writes the guards, each line centred in the label or aligned to its left.
static void write_guards(Buf *out, const DiagramEdge *e, bool centred)
{
    const int32_t x = centred ? e->label.x + e->label.w / 2 : e->label.x;
    int32_t y = e->label.y;

    for (size_t g = 0; g < e->guard.n; g++) {
        const DiagramGuard *guard = &e->guard.at[g];
        write_mark(out, &guard->finding, guard->mark, e->label.x + e->label.w + MARK_W / 2 + 2, y + 7);
        for (size_t i = 0; i < guard->line.n; i++, y += GUARD_LINE)
            write_text(out, centred ? "g-guard g-mid" : "g-guard", x, y + 11, guard->line.at[i].text);
        if (g + 1 < e->guard.n)
            buf_printf(out, "<path class=\"g-rule\" d=\"M%ld %ldh%ld\"/>", (long)e->label.x, (long)y + GUARD_GAP / 2,
                       (long)e->label.w);
        y += GUARD_GAP;
    }
}

// Point i of the path as drawn.  The path ends slightly before the tip of the arrowhead, so that the tip stays sharp.
static Point path_point(const DiagramEdge *e, size_t i)
{
    const int32_t tip = e->path.at[e->path.n - 1].y, end = tip + (e->up ? 6 : -6);
    Point p = e->path.at[i];

    if (i + 2 >= e->path.n && (e->up ? p.y < end : p.y > end))
        p.y = end;
    return p;
}

static void write_vertical_segment(Buf *out, int32_t from, int32_t to)
{
    if (from != to)
        buf_printf(out, "V%ld", (long)to);
}

// Writes a vertical line, interrupted for the label if it is on the line.
static void write_straight(Buf *out, const DiagramEdge *e, Point from, Point to)
{
    const int32_t above = e->label.y - 2, below = e->label.y + e->label.h + 2;

    if (from.x == e->label.x + e->label.w / 2 && from.y <= above && to.y >= below) {
        write_vertical_segment(out, from.y, above);
        buf_printf(out, "M%ld %ld", (long)to.x, (long)below);
        write_vertical_segment(out, below, to.y);
    } else if (from.x == e->label.x + e->label.w / 2 && from.y >= below && to.y <= above) {
        write_vertical_segment(out, from.y, below);
        buf_printf(out, "M%ld %ld", (long)to.x, (long)above);
        write_vertical_segment(out, above, to.y);
    } else {
        write_vertical_segment(out, from.y, to.y);
    }
}

// Continues the current path with an S-shaped curve that is vertical at both ends.
static void write_curve(Buf *out, Point from, Point to)
{
    const long middle = (from.y + to.y) / 2;

    if (from.x == to.x)
        write_vertical_segment(out, from.y, to.y);
    else
        buf_printf(out, "C%ld %ld %ld %ld %ld %ld", (long)from.x, middle, (long)to.x, middle, (long)to.x, (long)to.y);
}

static void write_path(Buf *out, const DiagramEdge *e)
{
    const Point start = path_point(e, 0);

    buf_printf(out, "<path class=\"g-line\" d=\"M%ld %ld", (long)start.x, (long)start.y);
    for (size_t i = 0; i < e->path.n; i += 2) {
        write_straight(out, e, path_point(e, i), path_point(e, i + 1));
        if (i + 2 < e->path.n)
            write_curve(out, path_point(e, i + 1), path_point(e, i + 2));
    }
    buf_str(out, "\"/>");
    write_arrowhead(out, e->path.at[e->path.n - 1], e->up ? UP : DOWN);
}

// Draws a stub, an edge shown as a short arrow: from its state to the name of the other state.
static void write_stub(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    const DiagramNode *from = &d->node[e->from], *to = &d->node[e->to];
    const int32_t right = from->box.x + from->box.w, middle = from->box.y + from->box.h / 2, y = e->name.y + e->name.h / 2;
    const Point tip = {e->name.x, y};

    buf_printf(out, "<path class=\"g-line\" d=\"M%ld %ldh8V%ldH%ld\"/>", (long)right, (long)middle, (long)y, (long)tip.x - 6);
    write_arrowhead(out, tip, RIGHT);
    write_outline(out, box_class(to), to, e->name, 0);
    write_text(out, "g-to", e->name.x + e->name.w / 2, y + 4, to->name);
}

// Draws the loop of a state without stubs.
static void write_loop(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    const DiagramNode *n = &d->node[e->from];
    const Point tip = {n->box.x + n->box.w, n->box.y + n->box.h / 2 + 8};

    buf_printf(out, "<path class=\"g-line\" d=\"M%ld %ldc28 -10 32 16 6 16\"/>", (long)tip.x, (long)tip.y - 16);
    write_arrowhead(out, tip, LEFT);
}

// Writes the width of an edge: half a pixel more for each doubling of the count, up to 6.4.
static void write_line_width(Buf *out, uint64_t count)
{
    unsigned tenths = 14;

    for (; count > 0 && tenths < 60; count /= 2)
        tenths += 5;
    if (tenths > 14)
        buf_printf(out, " stroke-width=\"%u.%u\"", tenths / 10, tenths % 10);
}

static void write_edge(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    buf_printf(out, "<g class=\"g-edge%s%s%s\"", e->possible ? "" : " g-never", css_class_of_count(d, diagram_times_taken(e)), css_class_of_change(e->change));
    write_line_width(out, diagram_times_taken(e));
    buf_str(out, ">");
    write_edge_title(out, d, e);
    if (e->form == EDGE_LINE)
        write_path(out, e);
    else if (e->form == EDGE_LOOP)
        write_loop(out, d, e);
    else
        write_stub(out, d, e);
    write_guards(out, e, e->form == EDGE_LINE);
    buf_str(out, "</g>\n");
}

// ---- the whole diagram ----

// The title and description of the picture for screen readers.
static void write_description(Buf *out, const Diagram *d)
{
    unsigned long transitions = 0;

    for (size_t e = 0; e < d->edge.n; e++)
        transitions += d->edge.at[e].guard.n;
    buf_str(out, "<title>State diagram of ");
    xml_write_str(out, d->a->p->name->text);
    buf_printf(out, "</title>\n<desc>%lu %s, %lu %s. The initial state is ", (unsigned long)d->states,
               d->states == 1 ? "state" : "states", transitions, transitions == 1 ? "transition" : "transitions");
    xml_write_str(out, d->node[0].title);
    buf_str(out, ".</desc>\n");
}

// A drawn diagram: the SVG elements of the picture, and its size including the notes.
typedef struct DrawnDiagram { Diagram *d; DiagramNotes notes; Buf elements; DiagramSize size; } DrawnDiagram;

// Lays the diagram out and writes all its elements once; the callers wrap them in one picture, or in several that each show a part.
static void draw_diagram(const Analysis *a, const DiagramOptions *o, DrawnDiagram *out)
{
    Diagram *d = out->d = diagram_build(a, o);
    DiagramNotes *notes = &out->notes;

    layout_diagram(d);
    diagram_number_notes(d, notes);
    out->size = (DiagramSize){notes->w > d->w ? notes->w : d->w, d->h + notes->h};
    for (size_t i = 0; i < notes->line.n; i++)
        vec_push(a->arena, &d->cut, notes->line.at[i].y);
    buf_init(&out->elements, a->arena);
    write_description(&out->elements, d);
    write_style(&out->elements, o->changes != NULL);
    buf_printf(&out->elements, "<rect class=\"g-back\" width=\"%ld\" height=\"%ld\" rx=\"8\"/>\n", (long)out->size.w, (long)out->size.h);
    write_start_arrow(&out->elements, &d->node[0]);
    for (size_t e = 0; e < d->edge.n; e++)
        write_edge(&out->elements, d, &d->edge.at[e]);
    for (size_t n = 0; n < d->nodes; n++)
        (d->node[n].state ? write_state : write_section)(&out->elements, d, &d->node[n]);
    diagram_write_notes(notes, &out->elements);
}

// Writes the part of the picture whose upper left corner is at (left, top).
static void write_picture(const DrawnDiagram *drawn, int32_t left, int32_t top, DiagramSize part, Buf *out)
{
    const long w = part.w, h = part.h;

    buf_str(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"smc-graph\" role=\"img\" stroke-width=\"1.4\"");
    buf_printf(out, " width=\"%ld\" height=\"%ld\" viewBox=\"%ld %ld %ld %ld\">\n", w, h, (long)left, (long)top, w, h);
    buf_put(out, drawn->elements.at, drawn->elements.n);
    buf_str(out, "</svg>\n");
}

void diagram_write_svg(const Analysis *a, const DiagramOptions *o, Buf *out)
{
    DrawnDiagram drawn;

    draw_diagram(a, o, &drawn);
    if (o->size)
        *o->size = drawn.size;
    write_picture(&drawn, 0, 0, drawn.size, out);
}

// In pixels: how much slices side by side overlap, so that a text that one of them cuts is usually whole in the other.
enum { SLICE_OVERLAP = 200 };

// Returns how many slices of at most `most` pixels are side by side.
static int32_t count_columns(int32_t w, int32_t most)
{
    return w <= most ? 1 : (w - SLICE_OVERLAP + most - SLICE_OVERLAP - 1) / (most - SLICE_OVERLAP);
}

// Returns the width of the slices of a picture of width w: the same for all, and at most `most`, which must be more than SLICE_OVERLAP.
int32_t diagram_slice_width(int32_t w, int32_t most)
{
    const int32_t n = count_columns(w, most);

    return (w + (n - 1) * SLICE_OVERLAP + n - 1) / n;
}

static bool boxes_meet(Box a, Box b) { return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h; }

static Box box_between(Point a, Point b)
{
    const int32_t x = a.x < b.x ? a.x : b.x, y = a.y < b.y ? a.y : b.y;

    return (Box){x, y, (a.x < b.x ? b.x : a.x) - x + 1, (a.y < b.y ? b.y : a.y) - y + 1};
}

// Whether the label or a segment of the edge is visible in this part of the picture. A segment counts as its bounding box.
static bool edge_meets(const DiagramEdge *e, Box part)
{
    enum { SLIVER = 40 };                                // pixels: a line that is visible only this near to the top or bottom does not count
    const Box inner = {part.x, part.y + SLIVER, part.w, part.h - 2 * SLIVER};
    bool meets = boxes_meet(e->label, part) || (e->form == EDGE_STUB && boxes_meet(e->name, part));

    for (size_t i = 0; i + 1 < e->path.n; i++)
        meets = meets || boxes_meet(box_between(path_point(e, i), path_point(e, i + 1)), inner);
    return meets;
}

// Whether a part of the picture shows neither a state nor a text nor more than the end of a line.  Boxes around them are compared, so a blank
// part may be called not blank.
static bool is_blank(const DrawnDiagram *drawn, Box part)
{
    const Diagram *d = drawn->d;
    bool blank = true;

    for (size_t i = 0; i < drawn->notes.line.n; i++)
        blank = blank && !boxes_meet(diagram_note_box(&drawn->notes.line.at[i]), part);
    for (size_t n = 0; n < d->nodes; n++)
        blank = blank && !boxes_meet(d->node[n].box, part);
    for (size_t e = 0; e < d->edge.n; e++)
        blank = blank && !edge_meets(&d->edge.at[e], part);
    return blank;
}

// Appends the slices between two heights, from left to right, without those in which only the part that the one to their left shows is not
// blank.  The last one ends at the right edge of the picture.
static void write_row_of_slices(const DrawnDiagram *drawn, int32_t top, DiagramSize slice, Buf *out)
{
    const int32_t w = drawn->size.w, n = count_columns(w, slice.w);
    int32_t shown = 0;

    for (int32_t i = 0; i < n; i++) {
        const int32_t left = i + 1 == n ? w - slice.w : i * (slice.w - SLICE_OVERLAP);
        if (is_blank(drawn, (Box){shown, top, left + slice.w - shown, slice.h}))
            continue;
        write_picture(drawn, left, top, slice, out);
        shown = left + slice.w;
    }
}

// Appends the picture in slices, row by row from top to bottom, each a separate picture of at most the given size.
void diagram_write_slices(const Analysis *a, const DiagramOptions *o, DiagramSize most, Buf *out)
{
    DrawnDiagram drawn;
    int32_t w;
    size_t next = 0;

    draw_diagram(a, o, &drawn);
    w = diagram_slice_width(drawn.size.w, most.w);
    for (int32_t top = 0, bottom; top < drawn.size.h; top = bottom) {
        bottom = top + most.h;
        for (; next < drawn.d->cut.n && drawn.d->cut.at[next] <= top + most.h; next++)
            if (drawn.d->cut.at[next] > top)
                bottom = drawn.d->cut.at[next];
        if (drawn.size.h <= top + most.h)
            bottom = drawn.size.h;
        write_row_of_slices(&drawn, top, (DiagramSize){w, bottom - top}, out);
    }
}
