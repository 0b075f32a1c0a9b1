// SPDX-License-Identifier: Apache-2.0
// A table of the states: whether the machine can abort from each, by which guards, after how many steps, and on which inputs this depends
// (analysis/abort.h).
#include <string.h>

#include "compiler/analysis/abort.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"
#include "compiler/report/written.h"

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

// What the condition of a transition waits for before it can be true.  This time is not part of the number of steps that the matrix shows.
typedef enum Waiting { WAITS_FOR_NOTHING, WAITS_FOR_WINDOW, WAITS_FOR_HELD } Waiting;

// What the expression waits for: a duration (`held`), a full window of samples, or nothing; the largest of its parts.
static Waiting waiting_of_expression(const Expr *e)
{
    Waiting most = e->kind != EX_ROLL ? WAITS_FOR_NOTHING : 1u << e->stat & SM_STATS_OF_TIMES ? WAITS_FOR_HELD : WAITS_FOR_WINDOW;

    for (uint32_t i = 0; i < e->n; i++) {
        const Waiting of = waiting_of_expression(e->arg[i]);
        most = of > most ? of : most;
    }
    return most;
}

// What the conditions of the path's first transition wait for: the longest wait of any of them, enclosing ones included.
static Waiting waiting_of(const AbortPath *path)
{
    Waiting most = WAITS_FOR_NOTHING;

    for (const Condition *when = path->first->when; when; when = when->outer) {
        const Waiting of = waiting_of_expression(when->stmt->value);
        most = of > most ? of : most;
    }
    return most;
}

// Returns what the paths with the most steps of a row wait for.
static Waiting waiting_of_row(const AbortRow *row)
{
    Waiting most = WAITS_FOR_NOTHING;

    for (size_t i = 0; i < row->path.n; i++)
        if (row->path.at[i].possible && row->path.at[i].steps == row->steps && waiting_of(&row->path.at[i]) > most)
            most = waiting_of(&row->path.at[i]);
    return most;
}

// Adds the steps until an abort state, with the time they take where the step has a fixed length; empty for 0.
static void add_steps_cell(const Report *r, DocTable *t, uint32_t steps, Waiting waiting)
{
    static const char *const after[] = {"", ", after its window", ", after `held`"};
    const Program *p = r->analysis.p;
    const char *text = steps == 0 ? "" : steps == ABORT_NOT_BOUNDED ? "unbounded" : format_in(r->arena, "%lu", (unsigned long)steps);

    if (p->step > 0 && p->step <= UINT32_MAX && steps > 0 && steps != ABORT_NOT_BOUNDED)
        text = format_in(r->arena, "%s (%s)", text, describe_time(r->arena, p, p->step * steps));
    doc_add_text_cell(t, steps == 0 || steps == ABORT_NOT_BOUNDED ? text : format_in(r->arena, "%s%s", text, after[waiting]));
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

// ---- what each state aborts on ----

// Whether some state aborts on the variable.
static bool is_cause(const AbortMatrix *x, const Var *v)
{
    bool any = false;

    for (size_t i = 0; i < x->n && !any; i++)
        any = abort_path_that_reads(&x->row[i], v) != NULL;
    return any;
}

enum { TITLES_ACROSS = 10 };    // columns: with more of them, long names fit on paper only if they are written downwards

// Adds a row for each state that can need an abort, and a column for each variable that a guard of an abort reads.
static void add_causes(const Report *r, Doc *d, const AbortMatrix *x)
{
    const Program *p = r->analysis.p;
    VEC(const Var *) cause = {NULL, 0, 0};
    DocColumn *column = ARENA_ARRAY(r->arena, DocColumn, p->var.n + 1u);
    DocTable *t;

    column[0] = (DocColumn){"state", "State"};
    for (size_t v = 0; v < p->var.n; v++)
        if (p->var.at[v] != p->s && is_cause(x, p->var.at[v])) {
            const bool is_time = p->var.at[v] == p->t || p->var.at[v] == p->g;
            const char *name = is_time ? format_in(r->arena, "time (%s)", p->var.at[v] == p->t ? "T" : "G") : p->var.at[v]->name->text;
            vec_push(r->arena, &cause, p->var.at[v]);
            column[cause.n] = (DocColumn){name, name};
        }
    if (cause.n == 0)
        return;
    doc_add_heading(d, "abort-causes", "What each state aborts on");
    doc_add_legend(d, TEXT_ABORT_CAUSES);
    t = doc_add_table(d, "causes", column, (uint32_t)cause.n + 1);
    t->narrow = t->dense = true;
    t->upright = t->columns > TITLES_ACROSS;
    for (size_t i = 0; i < x->n; i++) {
        const AbortRow *row = &x->row[i];
        if (row->verdict == ABORT_ITSELF || row->verdict == ABORT_UNREACHED)
            continue;
        doc_add_state_cell(t, row->state->name->text);
        for (size_t v = 0; v < cause.n; v++)
            doc_add_plain_cell(t, abort_path_that_reads(row, cause.at[v]) ? "yes" : "-");
    }
}

// ---- the table of transitions ----

// A row: a transition with the same values in one state, or in several where [all_states] runs.
typedef struct PathRow { const AbortPath *path; const char *reads; VEC(const char *) state; } PathRow;
typedef VEC(PathRow) PathRows;

// Returns whether the row is about the same transition of [all_states] as the path, with the same values.
static bool is_same_row(const PathRow *row, const AbortPath *path, const char *reads)
{
    const Span a = row->path->first->stmt->span, b = path->first->stmt->span;

    return a.src->copy_of && b.src->copy_of && a.at == b.at && row->path->possible == path->possible && row->path->steps == path->steps &&
           strcmp(row->reads, reads) == 0;
}

// One row per transition that leads to an abort state. Copies of an [all_states] transition that read the same inputs share a row.
static PathRows path_rows(const Report *r, const AbortMatrix *x)
{
    PathRows rows = {NULL, 0, 0};

    for (size_t i = 0; i < x->n; i++)
        for (size_t w = 0; w < x->row[i].path.n; w++) {
            const AbortPath *path = &x->row[i].path.at[w];
            PathRow row = {path, path->possible ? reads_text(r, path) : "can never be taken", {NULL, 0, 0}};
            size_t k = path->first->stmt->span.src->copy_of ? 0 : rows.n;         // only rows about [all_states] have several states
            while (k < rows.n && !is_same_row(&rows.at[k], path, row.reads))
                k++;
            if (k == rows.n)
                vec_push(r->arena, &rows, row);
            vec_push(r->arena, &rows.at[k].state, x->row[i].state->name->text);
        }
    return rows;
}

// Adds the states of a row: the name of the section if the row is about all states where it runs.
static void add_states_cell(const Report *r, DocTable *t, const PathRow *row)
{
    const Program *p = r->analysis.p;
    const AllStates *all = written_section(p, row->path->first->stmt->span);
    size_t runs = 0;
    Buf names;

    for (size_t s = 1; all && s <= p->state.n; s++)
        runs += !all->excepted[s];
    buf_init(&names, r->arena);
    for (size_t i = 0; i < row->state.n; i++)
        buf_printf(&names, "%s%s", i ? ", " : "", row->state.at[i]);
    if (row->state.n == 1)
        doc_add_state_cell(t, row->state.at[0]);
    else
        doc_add_plain_cell(t, row->state.n == runs ? written_section_name(r->arena, p, all, "") : buf_text(&names));
}

static void add_transitions(const Report *r, Doc *d, const AbortMatrix *x)
{
    const PathRows rows = path_rows(r, x);
    DocTable *t;

    doc_add_heading(d, "abort-transitions", "Transitions that lead to an abort state");
    if (has_unbounded(x))
        doc_add_paragraph(d, TEXT_ABORT_UNBOUNDED);
    t = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (size_t i = 0; i < rows.n; i++) {
        const AbortPath *path = rows.at[i].path;
        add_states_cell(r, t, &rows.at[i]);
        doc_add_state_cell(t, path->first->to->name->text);
        if (*path->guard)
            doc_add_code_cell(t, path->guard);
        else
            doc_add_plain_cell(t, "always");
        doc_add_text_cell(t, rows.at[i].reads);
        add_steps_cell(r, t, path->steps, waiting_of(path));
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
    doc_add_legend(d, TEXT_ABORT);
    t = DOC_ADD_TABLE(d, "abort", abort_columns);
    for (size_t i = 0; i < x.n; i++) {
        const AbortRow *row = &x.row[i];
        doc_add_state_cell(t, row->state->name->text);
        doc_add_plain_cell(t, verdict_text(row, true));
        doc_add_plain_cell(t, verdict_text(row, false));
        add_steps_cell(r, t, row->steps, waiting_of_row(row));
        doc_add_text_cell(t, dependence_text(r, row));
    }
    add_causes(r, d, &x);
    add_transitions(r, d, &x);
}
