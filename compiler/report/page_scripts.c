// SPDX-License-Identifier: Apache-2.0
// The results of the scripts, what they visited, and a plot of each.
#include "compiler/report/comment.h"
#include "compiler/base/path.h"
#include "compiler/report/diagram.h"
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

static const char *outcome_text(const ReportRun *run)
{
    if (!run->script)
        return "does not compile";
    switch (run->result.outcome) {
    case SCRIPT_PASSED: return "passed";
    case SCRIPT_FAILED: return "failed: an assert was false";
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
        for (size_t s = 0; run->script && s < r->analysis.p->state.n; s++)
            visited += run->trace.entered[s] > 0;
        doc_add_plain_cell(t, run->name);
        doc_add_plain_cell(t, outcome_text(run));
        doc_add_number_cell(t, run->result.steps);
        doc_add_number_cell(t, run->result.asserts_passed);
        doc_add_plain_cell(t, format_in(r->arena, "%lu of %lu", (unsigned long)visited, (unsigned long)r->analysis.p->state.n));
    }
}

static const DocColumn transition_columns[] = {{"from", "From"}, {"to", "To"}, {"times", "Times"}, {"note", "Remark"}};

// Returns whether transition i is the first from its state to its target, and stores the number of such transitions in *same.
static bool match_first_of_pair(const Transitions *t, size_t i, size_t *same)
{
    size_t first = i, last = i;

    while (first > 0 && t->at[first - 1].from == t->at[i].from)
        first--;
    while (last < t->n && t->at[last].from == t->at[i].from)
        last++;
    for (; first < i; first++)
        if (t->at[first].to == t->at[i].to)
            return false;
    for (; i < last; i++)
        *same += t->at[i].to == t->at[first].to;
    return true;
}

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

// Adds a table: by pair of states, how often the scripts went from one to the other.  A run does not record which of several transitions it
// took.
static void add_transitions_covered(const Report *r, Doc *d)
{
    const Transitions *t = &r->analysis.transition;
    DocTable *table;

    if (t->n == 0)
        return;
    doc_add_heading(d, "transitions-covered", "Transitions taken by the scripts");
    table = DOC_ADD_TABLE(d, "transitions", transition_columns);
    for (size_t i = 0; i < t->n; i++) {
        uint64_t taken = 0;
        size_t same = 0;
        if (!match_first_of_pair(t, i, &same))
            continue;
        for (size_t k = 0; k < r->runs; k++)
            taken += r->run[k].trace.taken[i];
        doc_add_state_cell(table, t->at[i].from->name->text);
        doc_add_state_cell(table, t->at[i].to->name->text);
        doc_add_number_cell(table, taken);
        doc_add_plain_cell(table, taken == 0 ? "never taken"
                          : same > 1 ? format_in(r->arena, "%lu transitions, counted together", (unsigned long)same)
                                     : "");
    }
}

// Returns counts by transition.  The diagram draws one arrow from a state to another, so the count of several transitions is stored at the
// first.
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
    return (DiagramCounts){state, transition};
}

Coverage report_measure_coverage(const Report *r)
{
    const DiagramCounts counts = report_sum_counts(r);
    const Transitions *t = &r->analysis.transition;
    Coverage c = {0, r->analysis.p->state.n, 0, 0, 0, 0, t->n};

    for (size_t s = 0; s < c.states; s++)
        c.states_covered += counts.state[s] > 0;
    for (size_t i = 0; i < t->n; i++) {
        size_t same = 0;
        if (!match_first_of_pair(t, i, &same))
            continue;
        c.pairs++;
        c.pairs_covered += counts.transition[i] > 0;
        c.transitions_most += counts.transition[i] > 0 ? same : 0;
        c.pairs_shared += counts.transition[i] > 0 && same > 1;
    }
    return c;
}

// Names transitions whose count is shared: a run does not record which of them it took.  If none was taken, all are known to be unused.
static void add_shared_transitions(const Report *r, Doc *d)
{
    const DiagramCounts counts = report_sum_counts(r);
    const Transitions *t = &r->analysis.transition;
    Buf out;

    buf_init(&out, r->arena);
    for (size_t i = 0; i < t->n; i++) {
        size_t same = 0;
        if (counts.transition[i] == 0 || !match_first_of_pair(t, i, &same) || same < 2)
            continue;
        buf_printf(&out, "%s from ^%s^ to ^%s^ (lines", out.n ? "," : "", t->at[i].from->name->text, t->at[i].to->name->text);
        for (size_t k = i; k < t->n && t->at[k].from == t->at[i].from; k++)
            if (t->at[k].to == t->at[i].to)
                buf_printf(&out, "%s %lu", k == i ? "" : ",", (unsigned long)source_position(t->at[k].stmt->span.src, t->at[k].stmt->span.at).line);
        buf_char(&out, ')');
    }
    if (out.n)
        doc_add_paragraph(d, format_in(r->arena, TEXT_SHARED, buf_text(&out)));
}

// Names the states that no script has visited, and the pairs of states between which no transition was taken, each pair once.
static void add_uncovered(const Report *r, Doc *d, const DiagramCounts *counts)
{
    const Program *p = r->analysis.p;
    const Transitions *t = &r->analysis.transition;
    VEC(const char *) state = {NULL, 0, 0}, pair = {NULL, 0, 0};
    Buf b;

    for (size_t i = 0; i < p->state.n; i++)
        if (counts->state[i] == 0)
            vec_push(r->arena, &state, p->state.at[i]->name->text);
    for (size_t i = 0; i < t->n; i++) {
        bool covered = false;
        for (size_t k = 0; k < t->n && !covered; k++)
            covered = t->at[k].from == t->at[i].from && t->at[k].to == t->at[i].to && (counts->transition[k] > 0 || k < i);
        if (!covered)
            vec_push(r->arena, &pair, format_in(r->arena, "from ^%s^ to ^%s^", t->at[i].from->name->text, t->at[i].to->name->text));
    }
    buf_init(&b, r->arena);
    for (size_t i = 0; i < state.n; i++)
        buf_printf(&b, "%s%s^%s^%s", i ? "" : "No script visits ", describe_separator(i, state.n), state.at[i], i + 1 < state.n ? "" : ". ");
    for (size_t i = 0; i < pair.n; i++)
        buf_printf(&b, "%s%s%s%s", i ? "" : "No script takes a transition ", describe_separator(i, pair.n), pair.at[i], i + 1 < pair.n ? "" : ".");
    doc_add_paragraph(d, buf_text(&b));
}

static void add_not_covered(Report *r, Doc *d)
{
    const Coverage c = report_measure_coverage(r);
    const DiagramCounts counts = report_sum_counts(r);

    doc_add_heading(d, "not-covered", "Not covered by the scripts");
    if (c.states_covered == c.states && c.pairs_covered == c.pairs)
        doc_add_paragraph(d, c.pairs_shared ? TEXT_COVERED_ALL_EDGES : TEXT_COVERED_ALL);
    else {
        add_uncovered(r, d, &counts);
        report_add_diagram(r, d, NULL, &counts, "Dotted: states that no script has visited, and transitions that none has taken.");
    }
    add_shared_transitions(r, d);
}

// ---- one script ----

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
            buf_printf(&lines, "%s:%lu: ", path_portable_name(note->span.src->name),
                       (unsigned long)source_position(note->span.src, note->span.at).line);
        buf_printf(&lines, "%s\n", note->text);
    }
    doc_add_lines(d, buf_text(&lines));
}

static void add_run(const Report *r, Doc *d, const ReportRun *run, size_t number)
{
    DocPart *heading = doc_add_heading(d, format_in(r->arena, "script-%lu", (unsigned long)number), run->name);

    heading->plain = true;
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
    if (!run->script || run->trace.steps == 0)
        return;
    add_plot(r, d, run);
    add_visits(r, d, run);
}

void report_add_scripts(Report *r, Doc *d)
{
    doc_add_section(d, "scripts", "Scripts");
    if (r->runs == 0) {
        doc_add_paragraph(d, TEXT_SCRIPTS_NONE);
        return;
    }
    add_runs(r, d);
    add_states_covered(r, d);
    add_transitions_covered(r, d);
    add_not_covered(r, d);
    doc_add_figure(d, plot_patterns(r->arena), NULL);
    for (size_t i = 0; i < r->runs; i++)
        add_run(r, d, &r->run[i], i + 1);
}
