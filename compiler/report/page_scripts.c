// SPDX-License-Identifier: Apache-2.0
// The results of the scripts, what they visited, and a plot of each.
#include "compiler/report/comment.h"
#include "compiler/base/path.h"
#include "compiler/report/diagram_model.h"
#include "compiler/report/describe.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"

static const DocColumn run_columns[] = {{"script", "Script"},
                                        {"result", "Result"},
                                        {"steps", "Steps"},
                                        {"asserts", "Asserts passed"},
                                        {"states", "States visited"}};
static const DocColumn visit_columns[] = {{"step", "Step"}, {"g", "G"}, {"state", "State entered"}, {"duration", "Duration"}};
static const DocColumn state_columns[] = {
    {"state", "State"}, {"entered", "Times entered"}, {"steps", "Steps"}, {"scripts", "Scripts"}};

static const char *failure_text(const ScriptResult *r)
{
    if (r->failed)
        return "failed: an assert was false";
    return r->is_violated ? "failed: a requirement was violated" : "failed: recorded values differ";
}

static const char *outcome_text(const ReportRun *run)
{
    if (!run->script)
        return "does not compile";
    switch (run->result.outcome) {
    case SCRIPT_PASSED: return "passed";
    case SCRIPT_FAILED: return failure_text(&run->result);
    case SCRIPT_NO_DATA: return run->result.data_ended ? "failed: the recorded data ended" : "failed: the recorded data cannot be used";
    case SCRIPT_ENDLESS: return "failed: did not stop";
    case SCRIPT_TIME_OVERFLOW: return "failed: G would overflow";
    case SCRIPT_CANCELLED: return "cancelled";
    case SCRIPT_BROKEN: case SCRIPT_DIFFERENT: return "failed: error in the engine";
    }
    return "";
}

static bool has_passed(const ReportRun *run) { return run->script && run->result.outcome == SCRIPT_PASSED; }

// ---- tables ----

static void add_runs(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "runs", run_columns);

    for (size_t i = 0; i < r->runs; i++) {
        const ReportRun *run = &r->run[i];
        size_t visited = 0;
        for (size_t s = 0; run->script && !r->members && s < r->analysis.p->state.n; s++)
            visited += run->trace.entered[s] > 0;
        doc_add_plain_cell(t, run->name);
        doc_add_plain_cell(t, outcome_text(run));
        doc_add_number_cell(t, run->result.steps);
        doc_add_number_cell(t, run->result.asserts_passed);
        doc_add_plain_cell(t, r->members ? "" : format_in(r->arena, "%lu of %lu", (unsigned long)visited, (unsigned long)r->analysis.p->state.n));
    }
}

static const DocColumn transition_columns[] = {{"from", "From"}, {"to", "To"}, {"times", "Times"}, {"note", "Remark"}};

static void add_states_covered(const Report *r, Doc *d)
{
    const Program *p = r->analysis.p;
    DocTable *t;

    doc_add_heading(d, "states-covered", "States visited by the scripts");
    t = DOC_ADD_TABLE(d, "states", state_columns);
    for (size_t s = 0; s < p->state.n; s++) {
        uint64_t entered = 0, spent = 0, scripts = 0;
        for (size_t i = 0; i < r->runs; i++)
            if (r->run[i].script) {
                entered += r->run[i].trace.entered[s];
                spent += r->run[i].trace.spent[s];
                scripts += r->run[i].trace.entered[s] > 0;
            }
        doc_add_state_cell(t, p->state.at[s]->name->text);
        doc_add_number_cell(t, entered);
        doc_add_number_cell(t, spent);
        if (scripts)
            doc_add_number_cell(t, scripts);
        else
            doc_add_plain_cell(t, "none");
    }
}

// Returns the diagram, with the counts of all scripts added up; its edges are listed.
static const Diagram *build_counted_diagram(const Report *r)
{
    DiagramCounts *counts = ARENA_NEW(r->arena, DiagramCounts);
    DiagramOptions *o = ARENA_NEW(r->arena, DiagramOptions);

    *counts = report_sum_counts(r);
    o->counts = counts;
    return diagram_build(&r->analysis, o);
}

static void add_origin_cell(const Report *r, DocTable *t, const DiagramNode *from)
{
    if (from->state)
        doc_add_state_cell(t, from->title);
    else
        doc_add_plain_cell(t, written_section_name(r->arena, r->analysis.p, from->all, ""));
}

// Returns the states from which the scripts took an edge of a section [all_states]: "in Run and Hold".
static const char *states_taken_text(const Report *r, const Diagram *d, const DiagramEdge *e)
{
    VEC(const char *) name = {NULL, 0, 0};
    Buf out;

    buf_init(&out, r->arena);
    for (size_t s = 0; s < d->states; s++)
        if (diagram_times_taken_in(d, e, d->node[s].state) > 0)
            vec_push(r->arena, &name, d->node[s].title);
    for (size_t i = 0; i < name.n; i++)
        buf_printf(&out, "%s%s", i ? describe_separator(i, name.n) : "in ", name.at[i]);
    return buf_text(&out);
}

// Returns the remark on an edge: never taken, counted together, from which states.
static const char *edge_remark(const Report *r, const Diagram *d, const DiagramEdge *e)
{
    Buf out;

    if (diagram_times_taken(e) == 0)
        return "never taken";
    buf_init(&out, r->arena);
    if (!d->node[e->from].state)
        buf_str(&out, states_taken_text(r, d, e));
    if (e->guard.n > 1)
        buf_printf(&out, "%s%lu transitions%s", out.n ? "; " : "", (unsigned long)e->guard.n,
                   r->cover ? diagram_unused_lines(d, e) : ", counted together");
    if (e->shared)
        buf_printf(&out, "%sat least %llu, the others may belong to another row", out.n ? "; " : "", (unsigned long long)e->taken);
    return buf_text(&out);
}

// Adds a table: by edge, how often the scripts took it.
static void add_transitions_covered(const Report *r, Doc *d)
{
    const Diagram *diagram = build_counted_diagram(r);
    DocTable *table;

    if (diagram->edge.n == 0)
        return;
    doc_add_heading(d, "transitions-covered", "Transitions taken by the scripts");
    table = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (size_t i = 0; i < diagram->edge.n; i++) {
        const DiagramEdge *e = &diagram->edge.at[i];
        add_origin_cell(r, table, &diagram->node[e->from]);
        doc_add_state_cell(table, diagram->node[e->to].title);
        doc_add_number_cell(table, diagram_times_taken(e));
        doc_add_plain_cell(table, edge_remark(r, diagram, e));
    }
}

// Returns counts by transition.  If they were not measured, a run shows a move from a state to another, so the count of several transitions is
// stored at the first.
DiagramCounts report_sum_counts(const Report *r)
{
    const size_t states = r->analysis.p->state.n, transitions = r->analysis.transition.n;
    uint64_t *state = ARENA_ARRAY(r->arena, uint64_t, states), *transition = ARENA_ARRAY(r->arena, uint64_t, transitions);

    for (size_t i = 0; i < r->runs; i++) {
        for (size_t s = 0; s < states; s++)
            state[s] += r->run[i].trace.entered[s];
        for (size_t t = 0; t < transitions; t++)
            transition[t] += r->run[i].trace.taken[t];
    }
    for (size_t t = 0; r->cover && t < transitions; t++)
        transition[t] = r->cover->hits[r->cover->probes.transition[r->analysis.transition.at[t].stmt->number]];
    return (DiagramCounts){state, transition, !r->cover};
}

Coverage report_measure_coverage(const Report *r)
{
    const Diagram *d = build_counted_diagram(r);
    Coverage c = {0, d->states, 0, false, 0, 0, 0};

    for (size_t n = 0; n < d->states; n++)
        c.states_covered += diagram_times_entered(d, &d->node[n]) > 0;
    for (size_t i = 0; i < d->edge.n; i++) {
        const DiagramEdge *e = &d->edge.at[i];
        const bool taken = diagram_times_taken(e) > 0;
        c.edges_unused += !taken;
        c.shared = c.shared || (!r->cover && taken && (e->guard.n > 1 || e->shared > 0));
        for (size_t g = 0; r->cover && g < e->guard.n; g++)
            c.transitions_least += e->guard.at[g].taken > 0;
        c.transitions_least += !r->cover && e->taken > 0;
        c.transitions_most += !r->cover && taken ? e->guard.n : 0;
        c.transitions += e->guard.n;
    }
    if (r->cover)
        c.transitions_most = c.transitions_least;
    return c;
}

static const char *origin_in_markup(const Report *r, const DiagramNode *from)
{
    return from->state ? format_in(r->arena, "^%s^", from->title) : written_section_name(r->arena, r->analysis.p, from->all, "^");
}

// Appends the line numbers of the transitions that the count of an edge includes: its own, and if it leaves a state also those of [all_states] to
// the same target.
static void write_lines_of_edge(Buf *out, const Diagram *d, const DiagramEdge *e)
{
    const Transitions *t = &d->a->transition;
    const DiagramNode *from = &d->node[e->from];
    const State *to = d->node[e->to].state;
    size_t n = 0;

    for (size_t g = 0; from->all && g < e->guard.n; g++)
        buf_printf(out, "%s %lu", n++ ? "," : "", (unsigned long)report_line_of(e->guard.at[g].transition->copy.at[0]->stmt->span));
    for (size_t k = 0; from->state && k < t->n; k++)
        if (t->at[k].from == from->state && t->at[k].to == to)
            buf_printf(out, "%s %lu", n++ ? "," : "", (unsigned long)report_line_of(t->at[k].stmt->span));
}

// Lists transitions that share a count, because runs do not record which of several transitions between two states they took.  Not if the count is
// 0: then all of them are unused.
static void add_shared_transitions(const Report *r, Doc *d)
{
    const Diagram *diagram = build_counted_diagram(r);
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < diagram->edge.n; i++) {
        const DiagramEdge *e = &diagram->edge.at[i];
        const DiagramNode *from = &diagram->node[e->from];
        if (r->cover || diagram_times_taken(e) == 0 || (e->guard.n == 1 && (e->shared == 0 || from->all)))
            continue;
        buf_printf(&out, "%s from %s to ^%s^ (lines", out.n ? "," : "", origin_in_markup(r, from), diagram->node[e->to].title);
        write_lines_of_edge(&out, diagram, e);
        buf_char(&out, ')');
    }
    if (out.n)
        doc_add_paragraph(d, format_in(r->arena, TEXT_SHARED, buf_text(&out)));
}

// Names the states that no script has visited, and the edges that no script has taken.
static void add_uncovered(const Report *r, Doc *d, const Diagram *diagram)
{
    VEC(const char *) state = {NULL, 0, 0}, edge = {NULL, 0, 0};
    Buf b;

    for (size_t n = 0; n < diagram->states; n++)
        if (diagram_times_entered(diagram, &diagram->node[n]) == 0)
            vec_push(r->arena, &state, diagram->node[n].title);
    for (size_t i = 0; i < diagram->edge.n; i++) {
        const DiagramEdge *e = &diagram->edge.at[i];
        if (diagram_times_taken(e) == 0)
            vec_push(r->arena, &edge, format_in(r->arena, "from %s to ^%s^", origin_in_markup(r, &diagram->node[e->from]),
                                                diagram->node[e->to].title));
    }
    buf_init(&b, r->arena);
    for (size_t i = 0; i < state.n; i++)
        buf_printf(&b, "%s%s^%s^%s", i ? "" : "No script visits ", describe_separator(i, state.n), state.at[i], i + 1 < state.n ? "" : ". ");
    for (size_t i = 0; i < edge.n; i++)
        buf_printf(&b, "%s%s%s%s", i ? "" : "No script takes a transition ", describe_separator(i, edge.n), edge.at[i], i + 1 < edge.n ? "" : ".");
    doc_add_paragraph(d, buf_text(&b));
}

// States and transitions that no script reached, as a list and a diagram.
static void add_not_covered(Report *r, Doc *d)
{
    const Coverage c = report_measure_coverage(r);
    const DiagramCounts counts = report_sum_counts(r);

    doc_add_heading(d, "not-covered", "Not covered by the scripts");
    if (c.states_covered == c.states && c.edges_unused == 0)
        doc_add_paragraph(d, c.shared ? TEXT_COVERED_ALL_EDGES : TEXT_COVERED_ALL);
    else {
        add_uncovered(r, d, build_counted_diagram(r));
        report_add_diagram(r, d, NULL, &counts, NULL);          // the diagram explains dotted lines
    }
    add_shared_transitions(r, d);
}

// ---- places ----

static const DocColumn cover_columns[] = {{"kind", "Places"}, {"covered", "Covered"}, {"possible", "Of"}, {"impossible", "Impossible"}};
static const DocColumn gap_columns[] = {{"line", "Line"}, {"text", "Not covered"}};

// For each kind of coverage point: how many were covered, can be covered, and cannot.
static void add_cover_totals(const Report *r, Doc *d)
{
    DocTable *t = DOC_ADD_TABLE(d, "places", cover_columns);

    t->narrow = true;
    for (int k = 0; k < COVER_KIND_COUNT; k++) {
        const CoverTotal total = cover_total(r->cover, (CoverKind)k);
        if (total.possible + total.impossible == 0)
            continue;
        doc_add_plain_cell(t, cover_kind_name[k]);
        doc_add_number_cell(t, total.covered);
        doc_add_number_cell(t, total.possible);
        doc_add_number_cell(t, total.impossible);
    }
}

// Adds what the scripts test, as smc test --coverage prints it.
static void add_cover(const Report *r, Doc *d)
{
    const CoverGaps gaps = cover_list_gaps(r->cover, (1u << COVER_KIND_COUNT) - 1);
    DocTable *t;

    doc_add_heading(d, "coverage", "Coverage");
    doc_add_legend(d, TEXT_COVERAGE);
    add_cover_totals(r, d);
    if (gaps.n == 0)
        return;
    t = DOC_ADD_TABLE(d, "gaps", gap_columns);
    t->narrow = true;
    for (size_t i = 0; i < gaps.n; i++) {
        doc_add_number_cell(t, report_line_of(gaps.at[i].span));
        doc_add_text_cell(t, gaps.at[i].is_impossible ? format_in(r->arena, "impossible: %s", gaps.at[i].text) : gaps.at[i].text);
    }
}

// ---- one script ----

static const DocColumn assert_columns[] = {{"line", "Line"}, {"text", "Text"}, {"requirement", "Requirement"}, {"result", "Result"}};

// What became of the assert in this run. `number`: its index in the script.
static const char *assert_result(const ReportRun *run, const ScriptAssert *a, uint32_t number)
{
    if (run->result.failed == a)
        return "failed";
    if (a->kind == SCRIPT_FAIL)
        return "not reached";
    if (run->result.undecided[number])
        return "undecided";
    return run->result.evaluated[number] ? "met" : "never evaluated";
}

// Adds a table of the asserts that have a text or a requirement.
static void add_named_asserts(const Report *r, Doc *d, const ReportRun *run)
{
    DocTable *t = NULL;

    for (size_t i = 0; i < run->script->section.n; i++)
        for (size_t k = 0; k < run->script->section.at[i].item.n; k++) {
            const ScriptItem *item = run->script->section.at[i].item.at[k];
            for (uint32_t n = 0; n < item->asserts.n; n++) {
                const ScriptAssert *a = &item->asserts.at[n];
                const ScriptRemark *m = a->remark;
                if (!m || a->kind == SCRIPT_PRINT || (!m->text && !m->requirement))
                    continue;
                if (!t)
                    t = DOC_ADD_TABLE(d, format_in(r->arena, "asserts.%s", run->name), assert_columns);
                doc_add_plain_cell(t, format_in(r->arena, "%s:%lu", source_short_name(m->span.src),
                                                (unsigned long)source_position(m->span.src, m->span.at).line));
                doc_add_plain_cell(t, m->text ? m->text->text : "");
                doc_add_plain_cell(t, m->requirement ? m->requirement->text : "");
                doc_add_plain_cell(t, assert_result(run, a, item->first_assert + n));
            }
        }
}

static const DocColumn compare_columns[] = {{"line", "Line"}, {"element", "Element"}, {"column", "Column"}, {"steps", "Steps"},
                                            {"differs", "Differs in"},
                                            {"first", "First at G"}, {"largest", "Largest difference"}, {"times", "Times"}};

// Adds a table of what @compare has found.
static void add_compares(const Report *r, Doc *d, const ReportRun *run)
{
    const ScriptData *data = run->script->data;
    DocTable *t;

    if (!data || !run->result.compare || data->compare.n == 0)
        return;
    t = DOC_ADD_TABLE(d, format_in(r->arena, "compares.%s", run->name), compare_columns);
    for (size_t i = 0; i < data->compare.n; i++) {
        const ScriptColumn *column = &data->compare.at[i].column;
        const CompareResult *c = &run->result.compare[i];
        Buf times, largest;
        buf_init(&times, r->arena);
        buf_init(&largest, r->arena);
        compare_write_spans(c, &times);
        if (c->failed) {
            format_number_shortest(&largest, c->worst.difference);
            buf_printf(&largest, " at G = %llu", (unsigned long long)c->worst.g);
        }
        doc_add_plain_cell(t, format_in(r->arena, "%s:%lu", source_short_name(column->span.src),
                                        (unsigned long)source_position(column->span.src, column->span.at).line));
        doc_add_plain_cell(t, column->var->name->text);
        doc_add_plain_cell(t, column->name->text);
        doc_add_number_cell(t, c->steps);
        doc_add_number_cell(t, c->failed);
        doc_add_plain_cell(t, c->failed
                           ? format_in(r->arena, "%llu, line %llu of the data", (unsigned long long)c->first.g, (unsigned long long)c->first.line)
                           : "");
        doc_add_plain_cell(t, buf_text(&largest));
        doc_add_plain_cell(t, buf_text(&times));
    }
}

// Adds a sentence about the rows of the recorded data.
static void add_rows(const Report *r, Doc *d, const ReportRun *run)
{
    Buf rows;

    if (!run->result.data_file)
        return;
    buf_init(&rows, r->arena);
    script_write_rows(&run->result, &rows);
    doc_add_paragraph(d, format_in(r->arena, "Recorded data: %s.", buf_text(&rows)));
}

// The first states that the run entered: step, time and how long each lasted.
static void add_visits(const Report *r, Doc *d, const ReportRun *run)
{
    enum { SHOWN = 20 };
    const Trace *t = &run->trace;
    DocTable *table = DOC_ADD_TABLE(d, format_in(r->arena, "visits.%s", run->name), visit_columns);

    for (size_t i = 0; i < t->visit.n && i < SHOWN; i++) {
        doc_add_number_cell(table, t->visit.at[i].step + 1);
        doc_add_number_cell(table, t->visit.at[i].g);
        doc_add_state_cell(table, t->visit.at[i].state->name->text);
        if (i + 1 < t->visit.n)
            doc_add_number_cell(table, t->visit.at[i + 1].g - t->visit.at[i].g);
        else
            doc_add_plain_cell(table, "until the end");
    }
    table->narrow = true;
    if (t->visits > SHOWN)
        doc_add_paragraph(d, format_in(r->arena, "And %llu more.", (unsigned long long)(t->visits - SHOWN)));
}

// Adds the plot of a run. Its caption lists the variables that do not change, which the plot omits.
static void add_plot(const Report *r, Doc *d, const ReportRun *run)
{
    const Trace *t = &run->trace;
    Buf same;

    buf_init(&same, r->arena);
    for (size_t i = 0; i < t->series.n; i++)
        if (!t->series.at[i]->changes && t->steps > 0)
            buf_printf(&same, "%s`%s` = %s", same.n ? ", " : " Unchanged: ", t->series.at[i]->v->name->text,
                       report_format_cell(r->arena, t->series.at[i]->v->type, run->result.cell[t->series.at[i]->v->index]));
    doc_add_figure(d, plot_draw_run(r->arena, t),
                   format_in(r->arena, "Values after each step. A circle marks the start of a state.%s%s", buf_text(&same), same.n ? "." : ""));
}

// Adds what led to a failure, as smc test shows it: the last steps with the values that the assert reads, and the last transitions.
static void add_history(const Report *r, Doc *d, const Diag *failure)
{
    Buf lines;

    buf_init(&lines, r->arena);
    for (size_t i = 0; i < failure->notes.n; i++) {
        const DiagNote *note = &failure->notes.at[i];
        if (note->span.src)
            buf_printf(&lines, "%s:%lu: ", source_short_name(note->span.src),
                       (unsigned long)source_position(note->span.src, note->span.at).line);
        buf_printf(&lines, "%s\n", note->text);
    }
    doc_add_lines(d, buf_text(&lines));
}

static DocPart *add_run_heading(const Report *r, Doc *d, const ReportRun *run, size_t number)
{
    DocPart *heading = doc_add_heading(d, format_in(r->arena, "script-%lu", (unsigned long)number), run->name);

    heading->plain = true;
    return heading;
}

// Adds what is the same for all machines of an application: the result, what failed, and what the script asserts and prints.
static void add_result_of_run(const Report *r, Doc *d, const ReportRun *run, size_t number)
{
    DocPart *heading = add_run_heading(r, d, run, number);

    heading->badge = has_passed(run) ? "passed" : "failed";
    heading->tone = has_passed(run) ? "good" : "bad";
    if (run->script)
        doc_add_quote(d, comment_of_file(r->arena, run->script->src));
    for (size_t i = 0; i < run->diags.list.n; i++) {
        const Diag *diag = run->diags.list.at[i];
        doc_add_plain(d, format_in(r->arena, "%s [%s]", diag->text, diag_code_and_name(diag, r->arena)));
        doc_add_excerpt(d, diag->span, diag->label);
        add_history(r, d, diag);
    }
    if (!run->script || run->result.steps == 0)
        return;
    if (run->result.is_random)
        doc_add_paragraph(d, format_in(r->arena, TEXT_SEED, (unsigned long long)run->result.seed));
    add_named_asserts(r, d, run);
    add_rows(r, d, run);
    add_compares(r, d, run);
    if (*run->result.printed)
        doc_add_lines(d, run->result.printed);
}

// Adds what the machine did in a run.
static void add_trace_of_run(const Report *r, Doc *d, const ReportRun *run)
{
    if (!run->script || run->trace.steps == 0)
        return;
    add_plot(r, d, run);
    add_visits(r, d, run);
}

// Adds what the scripts have covered of the machine.
static void add_covered(Report *r, Doc *d)
{
    add_states_covered(r, d);
    add_transitions_covered(r, d);
    add_not_covered(r, d);
    if (r->cover)
        add_cover(r, d);
}

void report_add_scripts(Report *r, Doc *d)
{
    doc_add_section(d, "scripts", r->of ? "In scripts" : "Scripts");
    if (r->runs == 0) {
        doc_add_paragraph(d, TEXT_SCRIPTS_NONE);
        return;
    }
    if (!r->of)
        add_runs(r, d);
    if (!r->members)
        add_covered(r, d);
    if (!r->of)
        doc_add_figure(d, plot_patterns(r->arena), NULL);
    for (size_t i = 0; i < r->runs; i++) {
        if (r->of)
            add_run_heading(r, d, &r->run[i], i + 1);
        else
            add_result_of_run(r, d, &r->run[i], i + 1);
        if (!r->members)
            add_trace_of_run(r, d, &r->run[i]);
    }
}
