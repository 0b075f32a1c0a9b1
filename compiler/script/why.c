// SPDX-License-Identifier: Apache-2.0
// The answers of smc why.  A first run of the script, in which the machine is watched, provides the guards and their values.  A second run finds the
// step in which a variable was stored before, and another one the state of the machine before the step, from which changes are tried.
#include "compiler/script/why.h"

#include <inttypes.h>

#include "compiler/script/why_paths.h"
#include "compiler/script/why_run.h"

enum { ORIGINS_MOST = 8 };

// ---- the lines of an answer ----

typedef struct Answer {
    WhyAnswer out;
    WhyRun r;
    const Watch *w;           // the watch of the machine that the question is about
    const Program *p;
    WhyWords words;
    const WatchStmt **guard;  // the statements whose guards or conditions are in the answer: other inputs are tried for these
    size_t guards;
    const Var *origin[ORIGINS_MOST];  // the variables whose values explain the answer
    size_t origins;
} Answer;

static WhyLine *add_line(Answer *a, WhyKind kind, unsigned depth, Span at, const char *text)
{
    const WhyLine line = {.kind = kind, .depth = depth, .at = at, .text = text};

    vec_push(a->r.arena, &a->out.line, line);
    return &a->out.line.at[a->out.line.n - 1];
}

static void add_remark(Answer *a, unsigned depth, const char *text) { add_line(a, WHY_REMARK, depth, (Span){0}, text); }
static void add_heading(Answer *a, const char *text) { add_line(a, WHY_HEADING, 0, (Span){0}, text); }

// Lists a variable in a->origin, unless the source of its value is obvious, so that the answer explains where the value comes from.
static void list_origin(Answer *a, const Var *v)
{
    if (v == a->p->g || v->kind == VAR_TIME || v->state_of || v->is_constant || a->origins == ORIGINS_MOST)
        return;
    for (size_t i = 0; i < a->origins; i++)
        if (a->origin[i] == v)
            return;
    a->origin[a->origins++] = v;
}

// Lists the variables of an expression in a->origin.
static void list_origins(Answer *a, const Expr *e)
{
    if (e->kind == EX_VAR)
        list_origin(a, e->var);
    for (uint32_t i = 0; i < e->n; i++)
        list_origins(a, e->arg[i]);
}

// Adds a line for the guard or stored condition of a statement that the step has evaluated, and one for each condition in it, unless the answer
// contains them already.
static void add_condition(Answer *a, unsigned depth, const WatchStmt *s)
{
    for (size_t i = 0; i < a->guards; i++)
        if (a->guard[i] == s)
            return;                                   // the guard is in the answer already, because it also contains another transition
    for (uint32_t i = 0; i < s->nodes; i++) {
        WhyLine *line;
        if (s->node[i].kind == WATCH_OPERAND)
            continue;
        line = add_line(a, i ? WHY_CONDITION : WHY_GUARD, depth + s->node[i].depth, i ? (Span){0} : s->stmt->span,
                        why_condition(&a->words, s, i, true));
        line->e = s->node[i].e;
        line->truth = watch_truth(s, s->value, i);
        line->has_gap = !line->truth && s->node[i].kind == WATCH_LEAF && why_gap(s, i, &line->gap);
        line->step = s->since[i];
        line->g = s->since_g[i];
    }
    list_origins(a, s->stmt->value);
    a->guard[a->guards++] = s;
}

// ---- what the step did ----

// Adds a line about the assignment that stored the value.
static void add_store(Answer *a, unsigned depth, const WatchStmt *s)
{
    WhyLine *line = add_line(a, WHY_STORE, depth, s->stmt->span, why_store(&a->words, s));

    line->step = s->step;
    line->g = s->g;
}

// Adds lines about what the statements of the list did in this step.
static void add_statements(Answer *a, unsigned depth, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const WatchStmt *s = &a->w->stmt[list->at[i]->number];
        if (s->step != a->w->step)
            return;                                   // the step did not execute the statement, because an earlier transition ended the block
        switch (s->stmt->kind) {
        case ST_ASSIGN:
            add_store(a, depth, s);
            break;
        case ST_IF:
            add_condition(a, depth, s);
            add_statements(a, depth + 1, watch_truth(s, s->value, 0) ? &s->stmt->then : &s->stmt->otherwise);
            break;
        case ST_TRANSITION:
            add_line(a, WHY_TRANSITION, depth, s->stmt->span, format_in(a->r.arena, "-> %s was taken", s->stmt->target->name->text));
            break;
        }
    }
}

static const Stmt *transition_taken(const Answer *a) { return engine_ref_transition(a->r.machine[a->r.q.machine]); }

// Adds the statements that the step has executed, in their order.
static void explain_step(Answer *a)
{
    const State *state = a->w->state;
    const size_t before = a->out.line.n;

    if (a->w->is_first)
        add_statements(a, 1, &state->block[BLOCK_ENTRY]);
    add_statements(a, 1, &state->block[BLOCK_STEP]);
    if (transition_taken(a))
        add_statements(a, 1, &state->block[BLOCK_EXIT]);
    if (a->out.line.n == before)
        add_remark(a, 1, format_in(a->r.arena, "%s has no statement that this step could execute", state->name->text));
}

// ---- where the machine did, or did not, go ----

// Adds the guards around s that the step has evaluated, the outermost first.
static void add_guards_around(Answer *a, unsigned depth, const WatchStmt *s)
{
    if (!s->parent)
        return;
    add_guards_around(a, depth, s->parent);
    if (s->parent->step == a->w->step)
        add_condition(a, depth, s->parent);
}

// Explains why the step did, or did not, take the transition s of its state.
static void explain_transition(Answer *a, unsigned depth, const WatchStmt *s)
{
    const WatchStmt *obstacle = why_obstacle(a->w, s);
    const char *target = s->stmt->target->name->text;

    if (s->block == BLOCK_ENTRY && !a->w->is_first) {
        add_line(a, WHY_REMARK, depth, s->stmt->span, format_in(a->r.arena, "-> %s can only be taken in the first step of %s, which was %s", target,
                 s->state->name->text, why_step(a->r.arena, a->w->entered, a->w->entered_g)));
        return;
    }
    add_guards_around(a, depth, s);
    if (!obstacle)
        add_line(a, WHY_TRANSITION, depth, s->stmt->span, format_in(a->r.arena, "-> %s was taken", target));
    else if (obstacle == s && s->parent && !s->parent->parent && !s->in_else && !watch_truth(s->parent, s->parent->value, 0))
        return;                                       // the line of the transition's only guard already shows that it is false
    else if (why_is_blocked(obstacle))
        add_line(a, WHY_REMARK, depth, s->stmt->span, format_in(a->r.arena, "-> %s was not taken, because %s was %s", target,
                 why_quote(a->r.arena, obstacle->parent->node[0].e->span), obstacle->in_else ? "true" : "false"));
    else if (transition_taken(a))
        add_line(a, WHY_REMARK, depth, s->stmt->span, format_in(a->r.arena, "-> %s was not reached: the transition to %s at %s came first", target,
                 transition_taken(a)->target->name->text, why_place(a->r.arena, transition_taken(a)->span)));
}

// Explains each transition to state `to` of the current state.
static void explain_transitions(Answer *a, unsigned depth, const State *to)
{
    for (uint32_t i = 1; i <= a->p->stmts; i++)
        if (a->w->stmt[i].stmt && a->w->stmt[i].stmt->kind == ST_TRANSITION && a->w->stmt[i].state == a->w->state && a->w->stmt[i].stmt->target == to)
            explain_transition(a, depth, &a->w->stmt[i]);
}

// Adds a line for each state from which a transition leads to q.to, and when the machine was last in it.
static void add_sources(Answer *a)
{
    const State *to = a->r.q.to;

    for (size_t i = 0; i < a->p->state.n; i++) {
        const State *from = a->p->state.at[i];
        const WatchStmt *t = why_find_transition(a->w, from, to);
        const uint64_t last = a->w->last_run[i];
        if (t && from != to)
            add_line(a, WHY_REMARK, 1, t->stmt->span, format_in(a->r.arena, "%s leads to %s; the machine was %s%s", from->name->text, to->name->text,
                     last ? "last in it in " : "never in it", last ? why_step(a->r.arena, last, a->w->last_run_g[i]) : ""));
    }
}

// Explains why the machine is in no state from which a transition leads to q.to.
static void explain_path(Answer *a)
{
    const State *from = a->w->state, *to = a->r.q.to;
    const WhyPath path = why_shortest_path(a->r.arena, a->w, from, to);

    add_remark(a, 1, format_in(a->r.arena, "%s has no transition to %s", from->name->text, to->name->text));
    add_sources(a);
    if (path.n == 0) {
        add_remark(a, 1, format_in(a->r.arena, "no sequence of transitions leads from %s to %s", from->name->text, to->name->text));
        return;
    }
    add_heading(a, format_in(a->r.arena, "the shortest path is %s; its first transition:", why_path_text(a->r.arena, &path)));
    explain_transitions(a, 1, path.at[1]);
    a->r.q.to = path.at[1];                           // so that the changes that are tried are about this transition
}

// ---- where values come from ----

// Returns the variable of the run that holds variable v of the machine in question: in an application, all machines run as one joined program.
static const Var *run_variable(const Answer *a, const Var *v)
{
    const Joint *j = a->r.s->program->joint;

    return j ? j->member.at[a->r.q.machine].var[v->index] : v;
}

// Returns the position of the script's assignment that wrote a variable last, and sets *step to its step; a span without source: none.
static Span find_writer(const ScriptRun *run, const Var *v, uint64_t *step)
{
    Span found = {0};

    *step = 0;
    for (size_t i = 0; i < run->s->section.n; i++)
        for (size_t k = 0; k < run->s->section.at[i].item.n; k++) {
            const ScriptItem *item = run->s->section.at[i].item.at[k];
            for (size_t n = 0; n < item->inputs.n; n++)
                if (item->inputs.at[n].var == v && run->true_in[item->number] && run->true_in[item->number] >= *step) {
                    found = script_input_span(item, &item->inputs.at[n]);
                    *step = run->true_in[item->number];
                }
        }
    return found;
}

// Returns the statement of a machine that stored a variable of the run last; NULL: none.
static const WatchStmt *find_store(const Answer *a, const Var *v)
{
    const WatchStmt *found = NULL;

    for (size_t m = 0; m < a->r.run.machines; m++) {
        const Watch *w = a->r.watch[m];
        const Joint *j = a->r.s->program->joint;
        for (size_t i = 0; i < w->p->var.n; i++)
            if ((j ? j->member.at[m].var[i] : w->p->var.at[i]) == v && w->stored_by[i] && (!found || w->stored_by[i]->step >= found->step))
                found = w->stored_by[i];
    }
    return found;
}

static const ScriptColumn *find_column(const Script *s, const Var *v)
{
    for (size_t i = 0; s->data && i < s->data->column.n; i++)
        if (s->data->column.at[i].var == v)
            return &s->data->column.at[i];
    return NULL;
}

// Adds a line about where the value of a variable of the machine comes from.
static void add_origin(Answer *a, const Var *local)
{
    const Var *v = run_variable(a, local);
    Arena *arena = a->r.arena;
    const char *name = local->name->text;
    const WatchStmt *stored = find_store(a, v);
    const ScriptColumn *column = find_column(a->r.s, v);
    uint64_t written;
    const Span writer = find_writer(&a->r.run, v, &written);
    WhyLine *line;

    if (stored && (!writer.src || stored->step >= written)) {
        line = add_line(a, WHY_ORIGIN, 1, stored->stmt->span,
                        format_in(arena, "%s was last stored in %s, by %s", name, why_step(arena, stored->step, stored->g),
                        why_quote(arena, stored->stmt->span)));
        line->step = stored->step;
        line->g = stored->g;
    } else if (writer.src) {
        line = add_line(a, WHY_ORIGIN, 1, writer,
                        format_in(arena, "the script wrote %s in step %" PRIu64 ", by %s", name, written, why_quote(arena, writer)));
        line->step = written;
    } else if (column) {
        add_line(a, WHY_ORIGIN, 1, column->span, format_in(arena, "%s is column '%s' of '%s'", name, column->name->text, a->r.s->data->file->text));
    } else if (local->parameter) {
        add_line(a, WHY_ORIGIN, 1, local->span, format_in(arena, "%s is a parameter", name));
    } else {
        add_line(a, WHY_ORIGIN, 1, local->span, format_in(arena, "nothing has written %s, so it has its first value", name));
    }
}

// Adds a line about where the value of each listed variable comes from.
static void add_origins(Answer *a)
{
    if (a->origins)
        add_heading(a, "where the values come from:");
    for (size_t i = 0; i < a->origins; i++)
        add_origin(a, a->origin[i]);
}

// ---- how the machine got there ----

// Adds lines about the transitions that led to this state, the last one first.
static void add_passages(Answer *a)
{
    uint32_t shown = 0, i = 0;
    const WatchPassage *t;
    const State *first = NULL;

    if (a->r.q.depth == 0)
        return;
    if (a->w->passages > (transition_taken(a) != NULL))
        add_heading(a, "how the machine got there:");
    for (; (t = watch_passage(a->w, i)) != NULL && shown < a->r.q.depth; i++) {
        const char *because = why_guards(&a->words, t->by, t->value);
        WhyLine *line;
        if (t->step == a->w->step)
            continue;
        line = add_line(a, WHY_PASSAGE, 1, t->by->stmt->span, format_in(a->r.arena, "%s: %s -> %s%s%s", why_step(a->r.arena, t->step, t->g),
                        t->by->state->name->text, t->by->stmt->target->name->text, *because ? ", because " : "", because));
        line->step = t->step;
        line->g = t->g;
        first = t->by->state;
        shown++;
    }
    if (a->w->passages > i && shown)
        add_remark(a, 1, format_in(a->r.arena, "before that, %" PRIu64 " more: --depth=N shows more", a->w->passages - i));
    else if (first)
        add_remark(a, 1, format_in(a->r.arena, "the run began in %s", first->name->text));
}

// ---- what would have been different ----

static const char *outcome_text(const Answer *a, const WhyChange *c)
{
    Buf out;

    buf_init(&out, a->r.arena);
    if (a->r.q.of) {
        buf_printf(&out, "%s would have become ", a->r.q.of->name->text);
        why_append_cell(a->r.q.of, c->stored, &out);
    } else if (c->next) {
        buf_printf(&out, "the step would have taken the transition to %s", c->next->name->text);
    } else {
        buf_printf(&out, "the machine would have stayed in %s", a->w->state->name->text);
    }
    return buf_text(&out);
}

// Adds lines about the smallest changes of inputs that would have changed what the step did.
static void add_changes(Answer *a, unsigned depth)
{
    WhyChanges changes = {0};
    const bool is_complete = a->guards == 0 || why_find_changes(&a->r, a->guard, a->guards, &changes);

    if (changes.n)
        add_line(a, WHY_HEADING, depth, (Span){0}, "what would have made a difference in this step:");
    for (uint32_t i = 0; i < changes.n; i++)
        add_line(a, WHY_CHANGE, depth + 1, (Span){0},
                 format_in(a->r.arena, "with %s, %s", why_change_text(&a->r, &changes.at[i]), outcome_text(a, &changes.at[i])))->change =
            changes.at[i];
    if (!is_complete)
        add_remark(a, depth, "not all values of parameters were tried, because each needs a run of the whole script");
}

// ---- the step that was nearest ----

// Returns the transition to a state that was nearest to being taken; NULL: no step could take one.  *last: the transition that was taken last, or
// NULL.
static const WatchStmt *find_nearest(const Answer *a, const State *to, const WatchStmt **last)
{
    const WatchStmt *found = NULL;
    const WhyNear *near = a->r.near;

    *last = NULL;
    for (uint32_t i = 1; i <= a->p->stmts; i++) {
        const WatchStmt *t = &a->w->stmt[i];
        if (near[i].step == 0 || t->stmt->target != to)
            continue;
        if (!found || why_is_nearer(&near[i].distance, &near[found->stmt->number].distance))
            found = t;
        if (near[i].taken && (!*last || near[i].taken > near[(*last)->stmt->number].taken))
            *last = t;
    }
    return found;
}

// Explains transition t in the step that was nearest to it, in a run that ends there.
static void explain_nearest(Answer *a, const WatchStmt *t)
{
    Answer *b = ARENA_NEW(a->r.arena, Answer);
    WhyQuestion q = a->r.q;

    q.at_step = a->r.near[t->stmt->number].step;
    q.to = t->stmt->target;
    why_run(&b->r, a->r.arena, a->r.s, a->r.given, &q, NULL, NULL);
    b->p = a->p;
    b->w = b->r.watch[q.machine];
    b->words = (WhyWords){b->r.arena, b->w, engine_ref_view(b->r.machine[q.machine]).windows};
    b->guard = ARENA_ARRAY(b->r.arena, const WatchStmt *, b->p->stmts + 1);
    b->out = a->out;
    explain_transition(b, 1, &b->w->stmt[t->stmt->number]);
    add_changes(b, 1);
    a->out = b->out;
}

// Adds the step that was nearest to taking a transition to `to`, which the run never took.  Returns false if no step could take one.
static bool add_nearest_step_to(Answer *a, const State *to)
{
    const WatchStmt *last, *t = find_nearest(a, to, &last);
    const char *path;
    WhyLine *line;
    WhyDistance now;

    if (last)
        add_line(a, WHY_REMARK, 0, last->stmt->span, format_in(a->r.arena, "%s -> %s was last taken in %s", last->state->name->text, to->name->text,
                 why_step(a->r.arena, a->r.near[last->stmt->number].taken, a->r.near[last->stmt->number].taken_g)));
    if (last || !t)
        return last != NULL;
    path = format_in(a->r.arena, "%s -> %s", t->state->name->text, to->name->text);
    if (a->w->step == a->r.run.result.steps && why_could_take(a->w, t)) {
        now = why_distance(a->w, t);
        if (!why_is_nearer(&a->r.near[t->stmt->number].distance, &now)) {
            line = add_line(a, WHY_NEAREST, 0, t->stmt->span,
                            format_in(a->r.arena, "%s was never taken, and no step was nearer to taking it than this one", path));
            line->step = a->w->step;
            return true;
        }
    }
    line = add_line(a, WHY_NEAREST, 0, t->stmt->span, format_in(a->r.arena, "%s was never taken; %s was nearest to taking it:", path,
                    why_step(a->r.arena, a->r.near[t->stmt->number].step, a->r.near[t->stmt->number].g)));
    line->step = a->r.near[t->stmt->number].step;
    explain_nearest(a, t);
    return true;
}

// Adds the step that was nearest to taking a transition to `to`; if no step could take one, says so, and tries q.to instead.
static void add_nearest_step(Answer *a, const State *to)
{
    if (!a->r.near || (a->w->state == to && !transition_taken(a)) || (transition_taken(a) && transition_taken(a)->target == to))
        return;
    if (add_nearest_step_to(a, to))
        return;
    add_remark(a, 0, format_in(a->r.arena, "the machine was never in a state from which a transition leads to %s", to->name->text));
    if (a->r.q.to != to)
        add_nearest_step_to(a, a->r.q.to);
}

// ---- the answers ----

// Returns which requirement the run violated first, and in which step if it went on.
static const char *violation_text(const Answer *a)
{
    const ScriptRun *run = &a->r.run;
    const RequirementRun *of = &run->requirement[run->violated - run->o->requirements->at.at];
    const char *const id = run->violated->id->text;

    if (of->first_step == run->result.steps)
        return format_in(a->r.arena, "the script failed after this step: requirement %s was violated", id);
    return format_in(a->r.arena, "the script stopped after this step; %s violated requirement %s",
                     why_step(a->r.arena, of->first_step, of->first_g), id);
}

// Returns why the run failed although no assert and no requirement did: the first @compare that was not met.
static const char *difference_text(const Answer *a)
{
    const ScriptData *d = a->r.s->data;

    for (size_t i = 0; d && i < d->compare.n; i++) {
        const CompareResult *c = &a->r.run.result.compare[i];
        const ScriptColumn *column = &d->compare.at[i].column;
        if (c->failed)
            return format_in(a->r.arena,
                             "the script failed: '%s' differed from column '%s' in %" PRIu64 " of %" PRIu64 " steps, first at G = %" PRIu64 ", at %s",
                             column->var->name->text, column->name->text, c->failed, c->steps, c->first.g, why_place(a->r.arena, column->span));
    }
    return NULL;
}

// Returns how the run ended, if it ended in the step in question; else NULL.
static const char *ending_text(const Answer *a)
{
    const ScriptRun *run = &a->r.run;

    switch (run->result.outcome) {
    case SCRIPT_PASSED: return "the script stopped after this step";
    case SCRIPT_FAILED:
        if (run->violated)
            return violation_text(a);
        return run->failed ? format_in(a->r.arena, "the script failed after this step, at %s", why_place(a->r.arena, run->failed->span))
                           : difference_text(a);
    case SCRIPT_NO_DATA:
        return run->result.data_ended ? "the recorded data ended before the script stopped" : "the recorded data cannot be read further";
    case SCRIPT_TIME_OVERFLOW: return "the script did not stop before the end of G";
    case SCRIPT_ENDLESS: return "the script did not stop";
    default: return NULL;
    }
}

// Adds the first line: the step, its state, the step since which the machine is in this state, and how the step ended.
static void add_head(Answer *a)
{
    const Stmt *t = transition_taken(a);
    const Joint *j = a->r.s->program->joint;
    const char *ending = ending_text(a);
    WhyLine *line = add_line(a, WHY_STEP, 0, (Span){0}, format_in(a->r.arena, "%s: %s%s%s, entered in %s; %s%s",
                             why_step(a->r.arena, a->w->step, a->w->g), j ? j->member.at[a->r.q.machine].name->text : "", j ? " ran " : "",
                             a->w->state->name->text,
                             why_step(a->r.arena, a->w->entered, a->w->entered_g), t ? "took the transition to " : "took no transition",
                             t ? t->target->name->text : ""));

    line->step = a->w->step;
    line->g = a->w->g;
    if (a->w->step < a->r.run.result.steps)
        add_remark(a, 0, format_in(a->r.arena, "this is its last step before step %" PRIu64 ", in which it did not run", a->r.run.result.steps));
    else if (ending)
        add_remark(a, 0, ending);
}

// Explains why the machine did or did not go to the state that was asked for.
static void answer_to(Answer *a)
{
    const State *to = a->r.q.to;
    const WatchPassage *last = watch_passage(a->w, 0);

    if (a->w->state == to && !transition_taken(a)) {
        add_remark(a, 1, format_in(a->r.arena, "the machine was in %s already", to->name->text));
        if (!last)
            add_remark(a, 1, "the run began in it");
    } else if (why_find_transition(a->w, a->w->state, to)) {
        explain_transitions(a, 1, to);
    } else {
        explain_path(a);
    }
}

// Explains where the value of the variable that was asked for comes from.
static void answer_of(Answer *a)
{
    const WatchStmt *s = a->w->stored_by[a->r.q.of->index];

    add_guards_around(a, 1, s);
    if (watch_is_decision(s))
        add_condition(a, 1, s);
    add_store(a, 1, s);
    list_origins(a, s->stmt->value);
}

static void explain_question(Answer *a)
{
    const State *to = a->r.q.to;

    a->guard = ARENA_ARRAY(a->r.arena, const WatchStmt *, a->p->stmts + 1);
    add_head(a);
    if (a->r.q.of)
        answer_of(a);
    else if (a->r.q.to)
        answer_to(a);
    else
        explain_step(a);
    add_changes(a, 0);
    add_nearest_step(a, to);
    add_origins(a);
    add_passages(a);
}

// Answers a question about a variable that the machine has not stored, or that was written after it was stored.
static void answer_of_input(Answer *a, const Var *v)
{
    const char *name = v->name->text;
    Buf value;

    buf_init(&value, a->r.arena);
    why_append_cell(v, a->r.run.cell[run_variable(a, v)->index], &value);
    add_line(a, WHY_STEP, 0, (Span){0},
             format_in(a->r.arena, "%s: %s = %s", why_step(a->r.arena, a->r.run.result.steps, a->r.last_g), name, buf_text(&value)));
    add_origin(a, v);
}

// Explains where the value of the variable of the question comes from; if an earlier step stored it, by a second run up to that step.
static void ask_about_store(Answer *a, Arena *arena, const Script *s, const ScriptOptions *o, WhyQuestion q)
{
    const Var *joined = run_variable(a, q.of);
    const WatchStmt *stored = a->w->stored_by[q.of->index];
    const uint64_t step = a->r.run.result.steps, g = a->r.last_g;
    uint64_t written;
    Buf value;

    if (!stored || find_store(a, joined) != stored || (find_writer(&a->r.run, joined, &written).src && written > stored->step)) {
        answer_of_input(a, q.of);
        return;
    }
    buf_init(&value, arena);
    why_append_cell(q.of, a->r.run.cell[joined->index], &value);
    add_line(a, WHY_STEP, 0, (Span){0},
             format_in(arena, "%s: %s = %s, last stored in %s", why_step(arena, step, g), q.of->name->text, buf_text(&value),
             stored->step == step ? "this step" : why_step(arena, stored->step, stored->g)));
    if (stored->step < a->w->step) {
        q.at_step = stored->step;
        q.has_g = false;
        why_run(&a->r, arena, s, o, &q, NULL, NULL);
        a->w = a->r.watch[q.machine];
        a->words = (WhyWords){arena, a->w, engine_ref_view(a->r.machine[q.machine]).windows};
    }
    explain_question(a);
}

// Returns whether the run has reached the step of the question.
static WhyStatus find_status(const Answer *a)
{
    const WhyQuestion *q = &a->r.q;
    const ScriptRun *run = &a->r.run;

    if (run->result.steps == 0)
        return WHY_NOT_RUN;
    if ((q->at_step && run->result.steps < q->at_step) || (!q->at_step && q->has_g && a->r.last_g < q->at_g))
        return WHY_ENDED_BEFORE;
    if (!q->at_step && q->has_g && a->r.last_g > q->at_g)
        return WHY_BETWEEN_STEPS;
    return a->w->step ? WHY_ANSWERED : WHY_NO_STEP;
}

WhyAnswer why_ask(Arena *arena, const Script *s, const ScriptOptions *o, const WhyQuestion *q)
{
    Answer *a = ARENA_NEW(arena, Answer);

    a->p = why_program(s->program, q->machine);
    why_run(&a->r, arena, s, o, q, NULL, NULL);
    a->w = a->r.watch[q->machine];
    a->words = (WhyWords){arena, a->w, engine_ref_view(a->r.machine[q->machine]).windows};
    a->out.status = find_status(a);
    a->out.steps = a->r.run.result.steps;
    a->out.before = a->out.status == WHY_BETWEEN_STEPS ? a->r.g_before : a->r.last_g;
    a->out.after = a->r.last_g;
    if (a->out.status != WHY_ANSWERED)
        return a->out;
    a->out.step = a->out.steps;
    a->out.g = a->r.last_g;
    if (q->of)
        ask_about_store(a, arena, s, o, *q);
    else
        explain_question(a);
    return a->out;
}
