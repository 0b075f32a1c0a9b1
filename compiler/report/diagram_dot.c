// SPDX-License-Identifier: Apache-2.0
// A diagram for Graphviz, which lays it out: `smc graph tank.sm --format=dot | dot -Tpdf`.
#include "compiler/report/diagram_model.h"

// Writes text for use in quotes.  Graphviz also interprets entities there, so & is escaped too.
static void write_quoted(Buf *out, const char *text)
{
    for (; *text; text++)
        if (*text == '"' || *text == '\\')
            buf_printf(out, "\\%c", *text);
        else if (*text == '&')
            buf_str(out, "&amp;");
        else if ((unsigned char)*text < ' ')
            buf_char(out, ' ');
        else
            buf_char(out, *text);
}

static void write_findings(Buf *out, const DiagramFindings *f)
{
    if (f->n == 0)
        return;
    buf_str(out, ", tooltip=\"");
    for (size_t i = 0; i < f->n; i++) {
        buf_printf(out, "%s%s: ", i ? "\\n" : "", diag_info[f->at[i]->code].id);
        write_quoted(out, f->at[i]->text);
    }
    buf_char(out, '"');
}

// Impossible transitions and unreachable states are dashed, those that no run has executed are dotted.
static const char *line_style(const Diagram *d, bool possible, uint64_t count, const char *before)
{
    const char *style = !possible ? "dashed" : d->o->counts && count == 0 ? "dotted" : NULL;

    return style ? format_in(d->a->arena, "%s%s", before, style) : "";
}

// ---- states and sections [all_states] ----

// Returns the name of a node in the output: that of its state; "/all1" for a section, because no state can have such a name.
static const char *node_id(const Diagram *d, const DiagramNode *n)
{
    return n->state ? n->title : format_in(d->a->arena, "/all%lu", (unsigned long)((size_t)(n - d->node) - d->states + 1));
}

static const char *shape_attributes(const DiagramNode *n)
{
    return !n->state          ? "shape=box3d" :
           n->state->is_abort ? "shape=octagon, color=\"#b5320f\", fillcolor=\"#fdeae4\"" :
           n->state->is_safe  ? "color=\"#0c7268\", fillcolor=\"#e3f3f1\"" : "";
}

static void write_node(Buf *out, const Diagram *d, const DiagramNode *n)
{
    const char *style = !n->state || n->state->is_abort ? "filled" : "filled,rounded";

    buf_printf(out, "    \"%s\" [label=\"%s", node_id(d, n), n->title);
    for (size_t i = 0; i < n->finding.n; i++)
        buf_printf(out, "\\n(%s)", diag_info[n->finding.at[i]->code].id);
    if (d->o->counts && n->state)
        buf_printf(out, "\\n%s", diagram_count_text(d, "entered", diagram_times_entered(d, n)));
    for (size_t i = 0; i < n->action.n; i++) {
        buf_printf(out, "%s%s ", i ? "\\l" : "\\n", n->action.at[i].block_name);
        write_quoted(out, n->action.at[i].text);
    }
    buf_str(out, n->action.n ? "\\l" : "");
    buf_printf(out, "\", style=\"%s%s\"%s%s%s", style, line_style(d, n->reached, diagram_times_entered(d, n), ","),
               *shape_attributes(n) ? ", " : "", shape_attributes(n), n->state && n->state->is_safe ? ", peripheries=2" : "");
    write_findings(out, &n->finding);
    buf_str(out, "];\n");
}

// ---- transitions ----

static void write_guard(Buf *out, const DiagramGuard *g)
{
    for (size_t i = 0; i < g->line.n; i++) {
        buf_str(out, i ? "\\n" : "");
        write_quoted(out, g->line.at[i].text);
    }
    for (size_t i = 0; i < g->finding.n; i++)
        buf_printf(out, " (%s)", diag_info[g->finding.at[i]->code].id);
}

static void write_edge(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    buf_printf(out, "    \"%s\" -> \"%s\" [label=\"", node_id(d, &d->node[e->from]), node_id(d, &d->node[e->to]));
    for (size_t g = 0; g < e->guard.n; g++) {
        buf_str(out, g ? "\\nor\\n" : "");
        write_guard(out, &e->guard.at[g]);
    }
    buf_printf(out, "\"%s", line_style(d, e->possible, diagram_times_taken(e), ", style="));
    for (size_t g = 0; g < e->guard.n; g++)
        if (e->guard.at[g].finding.n > 0) {
            write_findings(out, &e->guard.at[g].finding);
            break;
        }
    buf_str(out, "];\n");
}

void diagram_write_dot(const Analysis *a, const DiagramOptions *o, Buf *out)
{
    const Diagram *d = diagram_build(a, o);

    buf_str(out, "digraph \"");
    write_quoted(out, a->p->name->text);
    buf_str(out, "\" { // drawn by smc\n    graph [fontname=\"Helvetica\"];\n");
    buf_str(out, "    node [shape=box, fontname=\"Helvetica\", color=\"#46566b\", fillcolor=\"#eef3f9\"];\n");
    buf_str(out, "    edge [fontname=\"Helvetica\", fontsize=10, color=\"#6a7787\"];\n");
    buf_printf(out, "    \"/start\" [shape=point, width=0.15];\n    \"/start\" -> \"%s\";\n", d->node[0].title);
    for (size_t n = 0; n < d->nodes; n++)
        write_node(out, d, &d->node[n]);
    for (size_t e = 0; e < d->edge.n; e++)
        write_edge(out, d, &d->edge.at[e]);
    buf_str(out, "}\n");
}
