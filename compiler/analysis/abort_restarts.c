// SPDX-License-Identifier: Apache-2.0
// Reports an @abort state from which the machine starts again without a command, although its first start needs one.
//
// "Starts again": it goes to a state that switches on an output which the @abort state switches off, and which the machine reaches from its first
// state only by a transition whose guard requires a command.  Transitions on the way from the @abort state must depend on no command, and on
// nothing else that could stand for a person.  Where the machine has no commands, or starts by itself, it is meant to go on by itself.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/input_deps.h"

typedef struct RestartCheck {
    Analysis *a;
    const InputDepsTable *deps;
    const size_t *first;          // transitions_by_state
    bool *free_start;             // by State.number - 1: the machine can come here from its first state without a command, and not through an abort
    const Transition **via;       // by State.number - 1: the transition into it on the way from the @abort state; NULL: none
} RestartCheck;

static bool is_reached(const RestartCheck *k, const Transition *way) { return k->a->stmt[way->stmt->number].reached; }

// ---- commands ----

// Whether e reads commands, and no other variable.
static bool is_command(const RestartCheck *k, const Expr *e, bool *other)
{
    const InputDeps d = input_deps_of_expr(k->deps, e);
    bool command = false;

    if (e->kind == EX_VAR && !e->var->is_constant) {
        *other |= !d.command || e->var->kind != VAR_ELEMENT || d.n > 0 || d.time || d.other;
        return d.command;
    }
    for (uint32_t i = 0; i < e->n; i++)
        command |= is_command(k, e->arg[i], other);
    return command;
}

// Whether the guard is true only with a command: some operand of its `and` is one.
static bool requires_command(const RestartCheck *k, const Expr *guard)
{
    bool other = false;

    if (guard->kind == EX_BINARY && guard->op == SM_OP_AND)
        return requires_command(k, guard->arg[0]) || requires_command(k, guard->arg[1]);
    return is_command(k, guard, &other) && !other;
}

static bool needs_command(const RestartCheck *k, const Transition *way)
{
    bool needs = false;

    for (const Condition *c = way->when; c && !needs; c = c->outer)
        needs = c->holds && requires_command(k, c->stmt->value);
    return needs;
}

static void mark_free_starts(RestartCheck *k)
{
    VEC(const State *) waiting = {NULL, 0, 0};

    k->free_start[0] = true;
    vec_push(k->a->arena, &waiting, k->a->p->state.at[0]);
    while (waiting.n > 0) {
        const State *s = waiting.at[--waiting.n];
        for (size_t i = k->first[s->number - 1]; !s->is_abort && i < k->first[s->number]; i++) {
            const Transition *way = &k->a->transition.at[i];
            if (k->free_start[way->to->number - 1] || !is_reached(k, way) || needs_command(k, way))
                continue;
            k->free_start[way->to->number - 1] = true;
            vec_push(k->a->arena, &waiting, way->to);
        }
    }
}

// ---- outputs ----

// Returns the assignment that switches the variable off (not `on`: value 0) or on in the state; NULL: the state has no such assignment.
static const Stmt *find_switch(const RestartCheck *k, const Stmts *list, const Var *v, bool on)
{
    const Stmt *found = NULL;

    for (size_t i = 0; i < list->n && !found; i++) {
        const Stmt *s = list->at[i];
        const StmtFact *f = &k->a->stmt[s->number];
        if (s->kind == ST_ASSIGN && (v ? s->var == v : s->var->type == SM_BOOL && s->var->kind == VAR_ELEMENT) && f->reached &&
            (on ? f->value.lo > 0 : f->value.hi == 0 && f->value.lo == 0))
            found = s;
        else if (s->kind == ST_IF && on && !(found = find_switch(k, &s->then, v, on)))
            found = find_switch(k, &s->otherwise, v, on);
    }
    return found;
}

// Returns the statement of the state that switches on what .entry of the @abort state switches off; NULL: the state has no such statement.
static const Stmt *find_started_output(const RestartCheck *k, const State *abort, const State *s)
{
    for (size_t i = 0; i < abort->block[BLOCK_ENTRY].n; i++) {
        const Stmts one = {&abort->block[BLOCK_ENTRY].at[i], 1, 1};
        const Stmt *off = find_switch(k, &one, NULL, false), *on = NULL;
        for (int b = 0; off && b < BLOCK_EXIT && !on; b++)
            on = find_switch(k, &s->block[b], off->var, true);
        if (on)
            return on;
    }
    return NULL;
}

// ---- paths ----

static bool depends_on_person(const RestartCheck *k, const Transition *way)
{
    const InputDeps d = input_deps_of_condition(k->deps, way->when);

    return d.command || d.other;
}

static void report_restart(const RestartCheck *k, const State *abort, const State *at, const Stmt *on)
{
    const Transition *first = k->via[at->number - 1];
    Diag *d;

    while (first->from != abort)
        first = k->via[first->from->number - 1];
    d = diag_report(k->a->diags, DIAG_abort_restarts, first->stmt->span, abort->name->text, on->var->name->text, at->name->text);
    diag_note_declaration(k->a->diags, d, DIAG_OUTPUTS, on->var->span);
    diag_note(k->a->diags, d, on->span, DIAG_note_switched_on, on->var->name->text);
}

// Follows the transitions out of an @abort state that depend on no person, the nearest states first.
static void check_abort_state(RestartCheck *k, const State *abort)
{
    VEC(const State *) queue = {NULL, 0, 0};

    for (size_t s = 0; s < k->a->p->state.n; s++)
        k->via[s] = NULL;
    vec_push(k->a->arena, &queue, abort);
    for (size_t next = 0; next < queue.n; next++)
        for (size_t i = k->first[queue.at[next]->number - 1]; i < k->first[queue.at[next]->number]; i++) {
            const Transition *way = &k->a->transition.at[i];
            const Stmt *on;
            if (way->to->is_abort || k->via[way->to->number - 1] || !is_reached(k, way) ||
                depends_on_person(k, way))
                continue;
            k->via[way->to->number - 1] = way;
            vec_push(k->a->arena, &queue, way->to);
            on = k->free_start[way->to->number - 1] ? NULL : find_started_output(k, abort, way->to);
            if (on) {
                report_restart(k, abort, way->to, on);
                return;
            }
        }
}

void analyse_abort_restarts(Analysis *a)
{
    RestartCheck k = {a, NULL, NULL, ARENA_ARRAY(a->arena, bool, a->p->state.n), ARENA_ARRAY(a->arena, const Transition *, a->p->state.n)};
    bool any = false;

    for (size_t s = 0; s < a->p->state.n; s++)
        any |= a->p->state.at[s]->is_abort;
    if (!any)
        return;
    k.deps = input_deps_of(a);
    k.first = transitions_by_state(a->arena, a->p, &a->transition);
    mark_free_starts(&k);
    for (size_t s = 0; s < a->p->state.n; s++)
        if (a->p->state.at[s]->is_abort)
            check_abort_state(&k, a->p->state.at[s]);
}
