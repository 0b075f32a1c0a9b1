// SPDX-License-Identifier: Apache-2.0
// A table of the states: whether the machine can abort from each, by which guards, after how many steps, and on which inputs this depends
// (analysis/abort.h).
#include "compiler/analysis/abort.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn abort_columns[] = {
    {"state", "State"}, {"verdict", "Can it abort?"}, {"alone", "Without a command?"}, {"steps", "Worst-case steps"},
    {"depends_on", "Depends on"}};
static const DocColumn transition_columns[] = {
    {"state", "State"}, {"to", "To"}, {"guard", "Condition"}, {"reads", "Reads"}, {"steps", "Worst-case steps"}, {"line", "Line"}};

// Whether some transition that leads to an abort state depends on a command or switch.
static bool has_command(const AbortRow *row)
{
    for (size_t w = 0; w < row->path.n; w++)
        if (row->path.at[w].by_input && row->path.at[w].possible)
            return true;
    return false;
}

// Returns the text of a cell: whether the machine can abort if the operator gives commands (`commands`), or without any.
static const char *verdict_text(const AbortRow *row, bool commands)
{
    switch (row->verdict) {
    case ABORT_ITSELF: return commands ? "is an abort state" : "";
    case ABORT_UNREACHED: return commands ? "unreachable" : "";
    case ABORT_NO_PATH: return "no";
    case ABORT_LATER: return commands ? "only through states that can wait" : "";
    case ABORT_BY_COMMAND: return commands ? "yes" : "no";
    case ABORT_ONE_SENSOR: return commands && has_command(row) ? "yes" : "not if one sensor fails";
    case ABORT_OK: return "yes";
    }
    return "";
}

// Returns which input values prevent every abort.
static const char *dependence_text(const Report *r, const AbortRow *row)
{
    Buf b;

    buf_init(&b, r->arena);
    if (row->blind)
        buf_printf(&b, "no transition fires if `%s` reads %s", row->blind->name->text, row->blind_at);
    if (row->single)
        buf_printf(&b, "%severy transition depends on `%s`: none fires if it is stuck at %s", b.n ? "; " : "", row->single->name->text,
                   report_format_number(r->arena, trace_cell_value(SM_F64, sm_bits(row->stuck))));
    return buf_text(&b);
}

static void add_steps_cell(const Report *r, DocTable *t, uint32_t steps)
{
    doc_add_plain_cell(t, steps == 0 ? "" : steps == ABORT_NOT_BOUNDED ? "unbounded" : format_in(r->arena, "%lu", (unsigned long)steps));
}

// Returns the inputs that the path depends on, as text.
static const char *reads_text(const Report *r, const AbortPath *w)
{
    Buf b;

    buf_init(&b, r->arena);
    for (size_t i = 0; i < w->sensors; i++)
        buf_printf(&b, "%s`%s`", b.n ? ", " : "", w->sensor[i]->name->text);
    if (w->by_time)
        buf_str(&b, b.n ? ", time" : "time");
    if (w->by_input)
        buf_str(&b, b.n ? ", a switch or command" : "a switch or command");
    return buf_text(&b);
}

// Whether, for some transition of the matrix, the number of steps until it fires has no bound.
static bool has_unbounded(const AbortMatrix *x)
{
    for (size_t i = 0; i < x->n; i++)
        for (size_t w = 0; w < x->row[i].path.n; w++)
            if (x->row[i].path.at[w].steps == ABORT_NOT_BOUNDED)
                return true;
    return false;
}

static void add_transitions(const Report *r, Doc *d, const AbortMatrix *x)
{
    DocTable *t;

    doc_add_heading(d, "abort-transitions", "Transitions that lead to an abort state");
    if (has_unbounded(x))
        doc_add_paragraph(d, TEXT_ABORT_UNBOUNDED);
    t = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (size_t i = 0; i < x->n; i++)
        for (size_t w = 0; w < x->row[i].path.n; w++) {
            const AbortPath *path = &x->row[i].path.at[w];
            doc_add_state_cell(t, x->row[i].state->name->text);
            doc_add_state_cell(t, path->first->to->name->text);
            if (*path->guard)
                doc_add_code_cell(t, path->guard);
            else
                doc_add_plain_cell(t, "always");
            doc_add_text_cell(t, path->possible ? reads_text(r, path) : "can never be taken");
            add_steps_cell(r, t, path->steps);
            doc_add_line_cell(t, report_line_of(path->first->stmt->span));
        }
}

void report_add_abort_matrix(Report *r, Doc *d)
{
    const AbortMatrix x = abort_build_matrix(trials_of(&r->analysis));
    DocTable *t;

    doc_add_section(d, "abort", "Abort matrix");
    if (!x.declared) {
        doc_add_paragraph(d, TEXT_ABORT_UNDECLARED);
        return;
    }
    doc_add_paragraph(d, TEXT_ABORT);
    t = DOC_ADD_TABLE(d, "abort", abort_columns);
    for (size_t i = 0; i < x.n; i++) {
        const AbortRow *row = &x.row[i];
        doc_add_state_cell(t, row->state->name->text);
        doc_add_plain_cell(t, verdict_text(row, true));
        doc_add_plain_cell(t, verdict_text(row, false));
        add_steps_cell(r, t, row->steps);
        doc_add_text_cell(t, dependence_text(r, row));
    }
    add_transitions(r, d, &x);
}
