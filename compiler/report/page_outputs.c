// SPDX-License-Identifier: Apache-2.0
// What each output is while the machine stays in a state: a constant, the value that an earlier state has left, or an expression.
//
// A data flow over the states: the values with which a state begins are joined over the transitions into it.  Guards whose result the facts
// decide are followed in that direction only; others in both.  If a guard implies the one of a conditional just before it, only the values of
// that branch enter.  So a cell can contain a value that no run has, and lacks none.
#include <string.h>

#include "compiler/analysis/guards_imply.h"
#include "compiler/report/page.h"
#include "compiler/report/page_text.h"
#include "compiler/report/state_rest.h"
#include "stdlib/convert.h"

enum {
    CONSTANTS_MAX = 3,                // the most constants that are distinguished
    COLUMNS_MAX = 7,                  // the most outputs in one table, so that it fits on paper
    REST_MAX = 60                     // the most characters of an expression in a cell; a longer one is "computed"
};

// The values that an output can have at one point.
typedef struct OutputValues {
    uint64_t cell[CONSTANTS_MAX];     // constants that were stored, ascending
    uint8_t n;
    bool assigned;                    // the current state has assigned the output
    bool computed;                    // further values are possible: computed ones, or more than CONSTANTS_MAX constants
    const char *rest;                 // with `computed`: the only expression that this step has computed them from; NULL: none, or several
    bool initial;                     // the value that the output has when the machine starts is possible, too
} OutputValues;

// A conditional without an else in the current list.  Since then no statement has been executed after which control can be here, except in its
// branch.
typedef struct OutputSplit {
    const Expr *guard;                // its guard; NULL: there is no such conditional
    OutputValues *taken;              // the values if the guard was true
} OutputSplit;

typedef struct OutputFlow {
    const Report *r;
    const Program *p;
    const Var **output;
    uint32_t outputs;
    uint32_t *column;                 // by Var.index: its index in `output`; or UINT32_MAX
    bool *reached;                    // by State.number: a transition leads to it, or it is the first state
    OutputValues **begin;             // by State.number, then by index in `output`: the values when the state is entered
    OutputValues **end;               // the same, after a step that stays in the state
    StmtFact *stmt;                   // by Stmt.number: the facts, where S is the state
    const State *state;               // the state whose statements are being followed
    bool in_step;                     // they are those of .step
    bool grew;                        // this pass over the states has added a value to some set
} OutputFlow;

// ---- values ----

// Adds the value to the sorted set. A full set counts as computed instead. Returns whether the set grew.
static bool add_constant(OutputValues *to, uint64_t cell)
{
    uint8_t at;

    for (uint8_t i = 0; i < to->n; i++)
        if (to->cell[i] == cell)
            return false;
    if (to->n == CONSTANTS_MAX) {
        const bool grew = !to->computed || to->rest;
        to->computed = true;
        to->rest = NULL;
        return grew;
    }
    for (at = to->n++; at > 0 && to->cell[at - 1] > cell; at--)
        to->cell[at] = to->cell[at - 1];
    to->cell[at] = cell;
    return true;
}

// Adds the values of *from to *to.  Returns whether there are new ones.
static bool join_values(OutputValues *to, const OutputValues *from)
{
    const bool differs = from->computed && to->computed && to->rest && (!from->rest || strcmp(from->rest, to->rest) != 0);
    bool grew = (from->computed && !to->computed) || (from->initial && !to->initial) || differs;

    if (from->computed && (!to->computed || differs))
        to->rest = differs ? NULL : from->rest;
    to->computed |= from->computed;
    to->initial |= from->initial;
    to->assigned |= from->assigned;
    for (uint8_t i = 0; i < from->n; i++)
        grew |= add_constant(to, from->cell[i]);
    return grew;
}

// Joins the values of each output at another point of the program into `to`; returns whether any set grew.
static bool join_outputs(const OutputFlow *f, OutputValues *to, const OutputValues *from)
{
    bool grew = false;

    for (uint32_t i = 0; i < f->outputs; i++)
        grew |= join_values(&to[i], &from[i]);
    return grew;
}

static OutputValues *copy_outputs(const OutputFlow *f, const OutputValues *from)
{
    return memcpy(ARENA_ARRAY(f->r->arena, OutputValues, f->outputs + 1u), from, f->outputs * sizeof *from);
}

// ---- the flow ----

static bool run_statements(OutputFlow *f, const Stmts *stmts, OutputValues *now);

// The output now has the constant that the assignment stores, or a computed value. Assignments to other variables are ignored.
static void apply_assignment(OutputFlow *f, const Stmt *s, OutputValues *now)
{
    const uint32_t column = f->column[s->var->index];
    const Fact value = f->stmt[s->number].value;

    if (column == UINT32_MAX)
        return;
    now[column] = (OutputValues){.assigned = true, .computed = true};
    if (f->in_step) {
        const char *rest = state_rest(f->r->arena, f->p, f->state, s->value);
        now[column].rest = strlen(rest) <= REST_MAX ? rest : NULL;
    }
    if (value.lo == value.hi && !value.nan) {
        now[column].computed = false;
        now[column].rest = NULL;
        add_constant(&now[column], sm_cell_from_f64(s->var->type, value.lo));
    }
}

// Leaves the state: executes its .exit, and adds the values to those with which the target begins.
static void leave(OutputFlow *f, const Stmt *s, const OutputValues *now)
{
    const bool was_in_step = f->in_step;
    OutputValues *left = copy_outputs(f, now);

    f->in_step = false;
    run_statements(f, &f->state->block[BLOCK_EXIT], left);
    f->in_step = was_in_step;
    for (uint32_t i = 0; i < f->outputs; i++) {
        left[i].assigned = false;
        left[i].rest = NULL;
    }
    f->grew |= !f->reached[s->target->number];
    f->reached[s->target->number] = true;
    f->grew |= join_outputs(f, f->begin[s->target->number], left);
}

// Executes both branches that the facts allow.  Returns whether control can reach the end of the conditional.
// If the guard is true and implies that of *split, the latter was true too: had it been false, no assignment would lie between the two guards.
static bool run_branches(OutputFlow *f, const Stmt *s, OutputValues *now, OutputSplit *split)
{
    const StmtFact *fact = &f->stmt[s->number];
    OutputValues *other = copy_outputs(f, now);
    bool then, otherwise;

    if (split->guard && guard_implies(&f->r->analysis, s->value, split->guard))
        memcpy(now, split->taken, f->outputs * sizeof *now);
    then = fact->then && run_statements(f, &s->then, now);
    otherwise = fact->otherwise && run_statements(f, &s->otherwise, other);
    if (s->otherwise.n > 0)
        split->guard = NULL;
    else if (then)
        *split = (OutputSplit){s->value, copy_outputs(f, now)};
    if (then && otherwise)
        join_outputs(f, now, other);
    else if (otherwise)
        memcpy(now, other, f->outputs * sizeof *now);
    return then || otherwise;
}

// Executes statements on the values *now.  Returns whether control can reach their end.  Recursion is bounded by the nesting of conditionals,
// AST_DEPTH_MAX.
static bool run_statements(OutputFlow *f, const Stmts *stmts, OutputValues *now)
{
    OutputSplit split = {NULL, NULL};

    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (!f->stmt[s->number].reached)
            return false;
        if (s->kind == ST_ASSIGN) {
            apply_assignment(f, s, now);
            split.guard = NULL;
        } else if (s->kind == ST_TRANSITION)
            return leave(f, s, now), false;
        else if (!run_branches(f, s, now, &split))
            return false;
    }
    return true;
}

// Runs the first step in a state, and then steps until no new values occur.
static void run_state(OutputFlow *f, const State *s)
{
    OutputValues *now = copy_outputs(f, f->begin[s->number]), *end = f->end[s->number];

    f->state = s;
    f->in_step = false;
    if (!run_statements(f, &s->block[BLOCK_ENTRY], now))
        return;
    f->in_step = true;
    do {
        for (uint32_t i = 0; i < f->outputs; i++)
            now[i].rest = NULL;                       // of an earlier step
        if (!run_statements(f, &s->block[BLOCK_STEP], now))
            return;
    } while (join_outputs(f, end, now));
}

// Numbers the outputs: elements that the machine writes, except time and state. column[v]: number of variable v, UINT32_MAX for others.
static void find_outputs(OutputFlow *f)
{
    f->output = ARENA_ARRAY(f->r->arena, const Var *, f->p->var.n + 1u);
    f->column = ARENA_ARRAY(f->r->arena, uint32_t, f->p->var.n + 1u);
    for (size_t v = 0; v < f->p->var.n; v++) {
        const Var *var = f->p->var.at[v];
        f->column[v] = UINT32_MAX;
        if (var->kind != VAR_ELEMENT || !var->written || var == f->p->g || var == f->p->s)
            continue;
        f->column[v] = f->outputs;
        f->output[f->outputs++] = var;
    }
}

// Repeats all reached states until no set of values grows. The sets are bounded, so this ends.
static void compute_flow(OutputFlow *f)
{
    const size_t states = f->p->state.n + 1u;
    const State *first = f->p->state.at[0];

    f->reached = ARENA_ARRAY(f->r->arena, bool, states);
    f->begin = ARENA_ARRAY(f->r->arena, OutputValues *, states);
    f->end = ARENA_ARRAY(f->r->arena, OutputValues *, states);
    for (size_t s = 0; s < states; s++) {
        f->begin[s] = ARENA_ARRAY(f->r->arena, OutputValues, f->outputs + 1u);
        f->end[s] = ARENA_ARRAY(f->r->arena, OutputValues, f->outputs + 1u);
    }
    f->reached[first->number] = true;
    for (uint32_t i = 0; i < f->outputs; i++)
        f->begin[first->number][i].initial = true;
    do {
        f->grew = false;
        for (size_t s = 0; s < f->p->state.n; s++)
            if (f->reached[f->p->state.at[s]->number])
                run_state(f, f->p->state.at[s]);
    } while (f->grew);
}

// ---- the table ----

// Returns the values as words: "`true`, `false` or the initial value".
static const char *values_text(const OutputFlow *f, const Var *v, const OutputValues *values)
{
    const size_t n = values->n + (values->initial ? 1u : 0u) + (values->computed ? 1u : 0u);
    Buf out;

    if (values->computed && !values->rest)
        return "computed";
    buf_init(&out, f->r->arena);
    for (size_t i = 0; i < n; i++) {
        buf_str(&out, i == 0 ? "" : i + 1 < n ? ", " : " or ");
        if (i < values->n)
            buf_printf(&out, "`%s`", report_format_cell(f->r->arena, v->type, values->cell[i]));
        else if (i == values->n && values->computed)
            buf_printf(&out, "`%s`", values->rest);
        else
            buf_str(&out, "initial");
    }
    return buf_text(&out);
}

// The values of the output at the end of a step in state s, as text of the table.
static const char *cell_text(const OutputFlow *f, const State *s, uint32_t output)
{
    const OutputValues *values = &f->end[s->number][output];
    const char *text = values_text(f, f->output[output], values);

    if (!f->reached[s->number])
        return "never reached";
    if (*text == '\0')
        return "leaves at once";
    return values->assigned ? text : format_in(f->r->arena, "unchanged: %s", text);
}

static const char *mark_of(const State *s)
{
    return s->is_abort ? s->is_safe ? "abort, safe" : "abort" : s->is_safe ? "safe" : "";
}

// Adds a table of the outputs `from` to `to` - 1.
static void add_table(const OutputFlow *f, Doc *d, uint32_t from, uint32_t to)
{
    DocColumn *column = ARENA_ARRAY(f->r->arena, DocColumn, to - from + 2u);
    DocTable *t;

    column[0] = (DocColumn){"state", "State"};
    column[1] = (DocColumn){"mark", "Mark"};
    for (uint32_t i = from; i < to; i++)
        column[i - from + 2] = (DocColumn){f->output[i]->name->text, f->output[i]->name->text};
    t = doc_add_table(d, from == 0 ? "outputs" : format_in(f->r->arena, "outputs-%u", (unsigned)from), column, to - from + 2u);
    t->dense = true;
    for (size_t s = 0; s < f->p->state.n; s++) {
        const State *state = f->p->state.at[s];
        doc_add_state_cell(t, state->name->text);
        doc_add_plain_cell(t, mark_of(state));
        for (uint32_t i = from; i < to; i++)
            doc_add_text_cell(t, cell_text(f, state, i));
    }
}

void report_add_outputs(Report *r, Doc *d)
{
    OutputFlow f = {.r = r, .p = r->analysis.p};

    f.stmt = analysis_facts_in_states(&r->analysis);
    find_outputs(&f);
    if (f.outputs == 0)
        return;
    compute_flow(&f);
    doc_add_section(d, "outputs", "Outputs in each state");
    doc_add_legend(d, TEXT_OUTPUTS);
    for (uint32_t i = 0; i < f.outputs; i += COLUMNS_MAX)
        add_table(&f, d, i, i + COLUMNS_MAX < f.outputs ? i + COLUMNS_MAX : f.outputs);
}
