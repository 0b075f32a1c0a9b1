// SPDX-License-Identifier: Apache-2.0
// A diagram for Mermaid (stateDiagram-v2), which GitHub, GitLab and many wikis draw.  Nodes are named by number there, because a machine
// can have a state called `end` or `state`.
#include <string.h>

#include "compiler/base/utf8.h"
#include "compiler/report/diagram_model.h"

static bool is_plain_character(uint32_t c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || (c < 128 && strchr(" _.,()+-*/=", (int)c));
}

// Writes text with the characters that have a meaning in Mermaid as #NUMBER;.
static void write_escaped(Buf *out, const char *text)
{
    const size_t n = strlen(text);
    size_t bytes;

    for (size_t i = 0; i < n; i += bytes) {
        uint32_t code;
        bytes = utf8_decode(text + i, n - i, &code);
        if (bytes == 0)
            code = 0xFFFD, bytes = 1;
        if (code < ' ')
            buf_char(out, ' ');
        else if (is_plain_character(code))
            buf_char(out, (char)code);
        else
            buf_printf(out, "#%lu;", (unsigned long)code);
    }
}

static void write_findings(Buf *out, const DiagramFindings *f, unsigned long node)
{
    for (size_t i = 0; i < f->n; i++) {
        buf_printf(out, "    note right of s%lu : %s ", node, diag_info[f->at[i]->code].id);
        write_escaped(out, f->at[i]->text);
        buf_char(out, '\n');
    }
}

static unsigned long node_number(const Diagram *d, const DiagramNode *n) { return (unsigned long)(n - d->node + 1); }

static void write_node_class(Buf *out, const Diagram *d, const DiagramNode *n)
{
    const unsigned long s = node_number(d, n);

    if (!n->state)
        buf_printf(out, "    class s%lu all\n", s);
    else if (n->state->is_abort)
        buf_printf(out, "    class s%lu abort\n", s);
    else if (n->state->is_safe)
        buf_printf(out, "    class s%lu safe\n", s);
    if (!n->reached)
        buf_printf(out, "    class s%lu never\n", s);
    if (d->o->counts && diagram_times_entered(d, n) == 0)
        buf_printf(out, "    class s%lu unrun\n", s);
    write_findings(out, &n->finding, s);
}

static void write_actions(Buf *out, const Diagram *d, const DiagramNode *n)
{
    for (size_t i = 0; i < n->action.n; i++) {
        buf_printf(out, "    s%lu : %s ", node_number(d, n), n->action.at[i].block_name);
        write_escaped(out, n->action.at[i].text);
        buf_char(out, '\n');
    }
}

static void write_transition(Buf *out, const Diagram *d, const DiagramEdge *e, const DiagramGuard *g)
{
    buf_printf(out, "    s%lu --> s%lu : ", (unsigned long)e->from + 1, (unsigned long)e->to + 1);
    write_escaped(out, g->text);
    if (!e->possible)
        buf_str(out, " (never)");
    if (d->o->counts && g == &e->guard.at[e->guard.n - 1])        // the last guard: the count of all transitions of the edge follows
        buf_printf(out, " (%s)", diagram_times_taken_text(d, e));
    buf_char(out, '\n');
    write_findings(out, &g->finding, e->from + 1);
}

void diagram_write_mermaid(const Analysis *a, const DiagramOptions *o, Buf *out)
{
    const Diagram *d = diagram_build(a, o);

    buf_str(out, "stateDiagram-v2\n    %% drawn by smc\n"
                 "    classDef abort fill:#fdeae4,stroke:#b5320f,stroke-width:3px,color:#1c2430\n"
                 "    classDef safe fill:#e3f3f1,stroke:#0c7268,stroke-width:3px,color:#1c2430\n"
                 "    classDef all fill:#fff,stroke:#46566b,stroke-width:4px,color:#1c2430,font-style:italic\n"
                 "    classDef never stroke-dasharray:5\n"
                 "    classDef unrun stroke-dasharray:1\n");
    for (size_t n = 0; n < d->nodes; n++)
        buf_printf(out, "    state \"%s\" as s%lu\n", d->node[n].title, (unsigned long)n + 1);
    for (size_t n = 0; n < d->nodes; n++)
        write_actions(out, d, &d->node[n]);
    buf_str(out, "    [*] --> s1\n");
    for (size_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++)
            write_transition(out, d, &d->edge.at[e], &d->edge.at[e].guard.at[g]);
    for (size_t n = 0; n < d->nodes; n++)
        write_node_class(out, d, &d->node[n]);
}
