// SPDX-License-Identifier: Apache-2.0
#include "compiler/report/diagram_notes.h"

#include <string.h>

#include "compiler/report/xml.h"

// In pixels: margin, width of the number, height of a line, and LEAST_W, the minimum width of all notes together.  LINES: maximum number of
// lines of a finding.
enum { MARGIN = 16, NUMBER_W = 22, LINE = 15, LINES = 3, LEAST_W = 420 };

static int32_t note_text_width(const Diagram *d) { return (d->w > LEAST_W ? d->w : LEAST_W) - 2 * MARGIN - NUMBER_W; }

// Appends the note to the list below the picture, wrapped to its width; only the first line shows the number.
static void add_note(const Diagram *d, DiagramNotes *n, uint32_t number, const char *text)
{
    const DiagramLines lines = diagram_text_wrap(d->a->arena, text, GUARD_SIZE, note_text_width(d), LINES);

    for (size_t i = 0; i < lines.n; i++) {
        const DiagramNote note = {i ? 0 : number, lines.at[i].text, d->h + (int32_t)n->line.n * LINE};
        vec_push(d->a->arena, &n->line, note);
    }
}

// Adds a note with the findings of one state or guard.  Returns its number, *marks + 1; 0 if there are no findings.
static uint32_t add_findings(const Diagram *d, DiagramNotes *n, uint32_t *marks, const DiagramFindings *f)
{
    for (size_t i = 0; i < f->n; i++)
        add_note(d, n, i ? 0 : *marks + 1, format_in(d->a->arena, "%s [%s]", f->at[i]->text, diag_info[f->at[i]->code].id));
    return f->n ? ++*marks : 0;
}

// Explains dotted lines if the diagram has any.
static void add_dotted_legend(const Diagram *d, DiagramNotes *n)
{
    bool unrun = false;

    for (size_t s = 0; d->o->counts && s < d->nodes; s++)
        unrun = unrun || diagram_times_entered(d, &d->node[s]) == 0;
    for (size_t e = 0; d->o->counts && e < d->edge.n; e++)
        unrun = unrun || diagram_times_taken(&d->edge.at[e]) == 0;
    if (unrun)
        add_note(d, n, 0, "Dotted: not covered by any script.");
}

// Numbers the marks of a diagram that has been laid out, state by state.
void diagram_number_notes(Diagram *d, DiagramNotes *out)
{
    uint32_t marks = 0;

    memset(out, 0, sizeof *out);
    for (size_t s = 0; s < d->nodes; s++) {
        DiagramNode *node = &d->node[s];
        node->mark = add_findings(d, out, &marks, &node->finding);
        for (uint32_t e = node->first_edge; e < node->first_edge + node->edges; e++)
            for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
                DiagramGuard *guard = &d->edge.at[e].guard.at[g];
                guard->mark = add_findings(d, out, &marks, &guard->finding);
            }
    }
    add_dotted_legend(d, out);
    if (out->line.n) {
        out->w = note_text_width(d) + 2 * MARGIN + NUMBER_W;
        out->h = (int32_t)out->line.n * LINE + MARGIN;
    }
}

Box diagram_note_box(const DiagramNote *note)
{
    return (Box){0, note->y, MARGIN + NUMBER_W + diagram_text_width(note->text, GUARD_SIZE, false), LINE};
}

void diagram_write_notes(const DiagramNotes *n, Buf *out)
{
    for (size_t i = 0; i < n->line.n; i++) {
        const DiagramNote *note = &n->line.at[i];
        const long y = note->y + LINE - 4;
        if (note->number)
            buf_printf(out, "<text class=\"g-guard\" x=\"%d\" y=\"%ld\">%lu</text>", MARGIN, y, (unsigned long)note->number);
        buf_printf(out, "<text class=\"g-guard\" x=\"%d\" y=\"%ld\">", MARGIN + NUMBER_W, y);
        xml_write_str(out, note->text);
        buf_str(out, "</text>\n");
    }
}
