// SPDX-License-Identifier: Apache-2.0
#include "compiler/cover/mutant.h"

#include <stdlib.h>
#include <string.h>

#include "compiler/passes/pass.h"

const char *const mutant_danger_name[] = {"other", "transition", "output", "hazard", "abort"};
const char *const mutant_verdict_name[] = {"waiting", "noticed", "unnoticed", "equivalent", "generated"};

// ---- changing the program ----

// What an edit has replaced, to restore it.  Comments begin with the kinds of MutantEdit that use the field.
typedef struct Undo {
    SmF64 number;             // NUMBER, INITIAL: the old number
    SmOperator op;            // OPERATOR, LINK, DROP_NOT: the old operator
    Stmt stmt;                // GUARD, TARGET, DELETE: the old statement
} Undo;

// Computes the initial values of all locals again, in their order.
static void compute_initial_values(Mutation *u)
{
    for (size_t i = 0; i < u->p->var.n; i++) {
        Var *v = u->p->var.at[i];
        if (v->kind == VAR_LOCAL && v->init_value)
            v->init = sm_cell_from_f64(v->type, expr_constant_value(v->init_value));
    }
}

static void restore_initial_values(Mutation *u)
{
    for (size_t i = 0; i < u->p->var.n; i++)
        u->p->var.at[i]->init = u->initial[i];
}

static Expr *new_number(Mutation *u, double x)
{
    Expr *e = ARENA_NEW(&u->work, Expr);

    e->kind = EX_NUMBER;
    e->number = x;
    return e;
}

Expr *mutant_initial_number(const Var *v)
{
    Expr *e = v->init_value;

    if (e && e->kind == EX_UNARY && e->op == SM_OP_NEG)
        e = e->arg[0];
    return e && e->kind == EX_NUMBER ? e : NULL;
}

static void apply_edit(Mutation *u, const MutantEdit *d, Undo *undo)
{
    if (d->e) {
        undo->number = d->e->number;
        undo->op = d->e->op;
    }
    if (d->stmt)
        undo->stmt = *d->stmt;
    switch (d->kind) {
    case EDIT_NUMBER: d->e->number = d->number; break;
    case EDIT_OPERATOR: d->e->op = d->op; break;
    case EDIT_LINK:
        undo->op = expr_ops(d->e)[d->link];
        expr_ops(d->e)[d->link] = d->op;
        break;
    case EDIT_DROP_UNARY: d->e->op = SM_OP_PLUS; break;
    case EDIT_GUARD: d->stmt->value = new_number(u, d->number); break;
    case EDIT_TARGET: d->stmt->target = d->target; break;
    case EDIT_DELETE:
        d->stmt->kind = ST_IF;
        d->stmt->value = new_number(u, 0);
        memset(&d->stmt->then, 0, sizeof d->stmt->then);
        memset(&d->stmt->otherwise, 0, sizeof d->stmt->otherwise);
        break;
    case EDIT_INITIAL:
        undo->number = mutant_initial_number(d->var)->number;
        mutant_initial_number(d->var)->number = d->number;
        compute_initial_values(u);
        break;
    }
}

static void undo_edit(Mutation *u, const MutantEdit *d, const Undo *undo)
{
    if (d->kind == EDIT_LINK) {
        expr_ops(d->e)[d->link] = undo->op;
    } else if (d->e) {
        d->e->number = undo->number;
        d->e->op = undo->op;
    }
    if (d->stmt)
        *d->stmt = undo->stmt;
    if (d->kind == EDIT_INITIAL) {
        mutant_initial_number(d->var)->number = undo->number;
        restore_initial_values(u);
    }
}

// Undoes the edits of a list, the last one first, because two of them can change one expression.
static void undo_edits(Mutation *u, const MutantEdit *list, const Undo *undo)
{
    if (!list)
        return;
    undo_edits(u, list->next, undo + 1);
    undo_edit(u, list, undo);
}

static uint32_t count_edits(const Mutant *m)
{
    uint32_t n = 0;

    for (const MutantEdit *d = m->edit; d; d = d->next)
        n++;
    return n;
}

// ---- running ----

static const char *optimised_text(Mutation *u, Arena *arena)
{
    const PassOptions o = {2, NULL, false, false, NULL, NULL};
    IrMachine *m = ir_build(&u->work, u->p);
    Buf out;

    passes_run(&u->work, m, &o);
    buf_init(&out, arena);
    ir_print(m, &out);
    return buf_text(&out);
}

// Returns the first script that fails on the current program, or the number of scripts.
static uint32_t find_noticing(Mutation *u, Mutant *m)
{
    uint32_t n = 0, *stmt = ARENA_ARRAY(&u->work, uint32_t, count_edits(m));

    for (const MutantEdit *d = m->edit; d; d = d->next)
        stmt[n++] = d->stmt ? d->stmt->number : d->kind == EDIT_INITIAL ? MUTANT_START : MUTANT_EACH_STEP;
    return mutant_runs_find_noticing(u->runs, &u->work, flat_new(&u->work, ir_build(&u->work, u->p), NULL), stmt, n, &m->violated);
}

// Changes the program to that of the mutant.  Returns the replaced values, for undo_edits.
static Undo *apply_edits(Mutation *u, const Mutant *m)
{
    Undo *undo = arena_array(&u->work, count_edits(m), sizeof *undo);
    uint32_t n = 0;

    for (const MutantEdit *d = m->edit; d; d = d->next)
        apply_edit(u, d, &undo[n++]);
    return undo;
}

bool mutation_run_next(Mutation *u)
{
    Mutant *m;
    Undo *undo;
    uint32_t noticing;

    if (u->next == u->mutant.n)
        return false;
    arena_reset(&u->work);
    m = &u->mutant.at[u->next++];
    undo = apply_edits(u, m);
    noticing = find_noticing(u, m);
    m->verdict = noticing < u->scripts ? MUTANT_NOTICED : strcmp(optimised_text(u, &u->work), u->original) == 0
        ? MUTANT_EQUIVALENT : MUTANT_UNNOTICED;
    m->script = noticing;
    undo_edits(u, m->edit, undo);
    if (m->verdict == MUTANT_UNNOTICED && mutant_is_equivalent(&u->work, u->p, m->edit, u->step))
        m->verdict = MUTANT_EQUIVALENT;
    return true;
}

// ---- searching ----

enum {
    SEARCH_STEP = 10,         // by how much G advances in each step of a scenario, if mutant_step returns 0
    GIVEN_STEPS_MOST = 20000  // a script's run with more steps is not given to the search as a scenario
};

// The numbers that a change concerns: values near them are likely to show it.
typedef struct Around { double at[32]; uint32_t n; } Around;

static void add_number(Around *list, double x)
{
    if (list->n < sizeof list->at / sizeof *list->at)
        list->at[list->n++] = x;
}

// Adds a constant in an expression.
static void add_constant_number(Expr *e, void *context)
{
    if (e->kind == EX_NUMBER || (e->kind == EX_VAR && e->var->is_constant))
        add_number(context, expr_constant_value(e));
}

static bool contains_statement(const Stmts *list, const Stmt *s)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i] == s || contains_statement(&list->at[i]->then, s) || contains_statement(&list->at[i]->otherwise, s))
            return true;
    return false;
}

// Adds the numbers of the guards around a statement.
static void add_guards(Around *around, const Stmts *list, const Stmt *inside)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind != ST_IF || (!contains_statement(&s->then, inside) && !contains_statement(&s->otherwise, inside)))
            continue;
        expr_walk(s->value, add_constant_number, around);
        add_guards(around, &s->then, inside);
        add_guards(around, &s->otherwise, inside);
    }
}

static void add_all_guards(const Program *p, Around *around, const Stmt *inside)
{
    for (size_t i = 0; i < p->state.n; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            add_guards(around, &p->state.at[i]->block[b], inside);
}

// Returns the numbers that a mutant changes, and the constants in the changed expressions and in the guards around them.
static Around list_numbers_around(const Program *p, const Mutant *m)
{
    Around list = {.n = 0};

    for (const MutantEdit *d = m->edit; d; d = d->next) {
        if (d->kind == EDIT_NUMBER || d->kind == EDIT_INITIAL)
            add_number(&list, d->number);
        if (d->kind == EDIT_INITIAL)
            add_number(&list, mutant_initial_number(d->var)->number);
        if (d->stmt && d->stmt->value)
            expr_walk(d->stmt->value, add_constant_number, &list);
        else if (d->e)
            expr_walk(d->e, add_constant_number, &list);
        if (d->stmt)
            add_all_guards(p, &list, d->stmt);
    }
    return list;
}

static bool reads_var(const Expr *e, const Var *v)
{
    bool found = e->kind == EX_VAR && e->var == v;

    for (uint32_t i = 0; i < e->n && !found; i++)
        found = reads_var(e->arg[i], v);
    return found;
}

// Whether some statement of the list reads a variable.
static bool any_statement_reads(const Stmts *list, const Var *v)
{
    for (size_t i = 0; i < list->n; i++)
        if ((list->at[i]->value && reads_var(list->at[i]->value, v)) || any_statement_reads(&list->at[i]->then, v)
            || any_statement_reads(&list->at[i]->otherwise, v))
            return true;
    return false;
}

// Returns the state in which a change has its effect: for an initial value the last one that reads it; NULL: several.
static const State *find_state(const Program *p, const Mutant *m)
{
    const State *found = m->state;

    for (size_t i = 0; i < p->state.n && m->edit->kind == EDIT_INITIAL; i++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            if (any_statement_reads(&p->state.at[i]->block[b], m->edit->var))
                found = p->state.at[i];
    return found;
}

static void add_start(Mutation *u, const State *start)
{
    for (uint32_t i = 0; i < u->starts; i++)
        if (u->start[i] == start)
            return;
    u->start[u->starts++] = start;
}

uint64_t mutation_delta_t(const Mutation *u) { return u->step ? u->step : SEARCH_STEP; }

static MutantSearch *new_search(Mutation *u)
{
    Scenario *given = arena_array(u->arena, u->scripts + (size_t)1, sizeof *given);

    for (uint32_t i = 0; i < u->scripts; i++) {
        const Scenario *s = mutant_runs_scenario(u->runs, u->arena, i);
        if (s && s->delta_t == mutation_delta_t(u) && s->steps <= GIVEN_STEPS_MOST)
            given[u->givens++] = *s;
    }
    u->given = given;
    return mutant_search_new(u->arena, u->p, mutant_runs_original(u->runs), mutation_delta_t(u), u->start, u->starts, u->given, u->givens);
}

FlatMachine *mutation_build(Mutation *u, Arena *arena, const Mutant *m)
{
    Undo *undo = apply_edits(u, m);
    FlatMachine *f = flat_new(arena, ir_build(arena, u->p), NULL);

    undo_edits(u, m->edit, undo);
    return f;
}

void mutation_search_from(Mutation *u, Mutant *m, const Scenario *from, uint64_t steps)
{
    FlatMachine *mutant = mutation_build(u, &u->work, m);
    const Around around = list_numbers_around(u->p, m);
    const MutantTarget target = {mutant, find_state(u->p, m), around.at, around.n, from};

    if (!u->search)
        u->search = new_search(u);
    m->scenario = mutant_search_run(u->search, u->arena, &u->work, &target, steps, &m->differs);
    if (m->scenario)
        m->verdict = MUTANT_GENERATED;
}

bool mutation_search_next(Mutation *u, uint64_t steps)
{
    while (u->next_search < u->mutant.n && u->mutant.at[u->next_search].verdict != MUTANT_UNNOTICED)
        u->next_search++;
    if (u->next_search == u->mutant.n)
        return false;
    arena_reset(&u->work);
    mutation_search_from(u, &u->mutant.at[u->next_search++], NULL, steps);
    return true;
}

// Returns by how much G grows between two steps of a machine of an application; 0: not by a whole number.
static uint64_t step_of_member(const Joint *j, const Member *m)
{
    const uint64_t period = m->every * j->tick;

    return period % j->unit == 0 ? period / j->unit : 0;
}

Mutation *mutation_new(Arena *arena, const Program *p, size_t member, const Script *const *script, uint32_t scripts, const Requirements *rq,
                       uint64_t max_steps)
{
    const Member *m = p->joint ? &p->joint->member.at[member] : NULL;
    Mutation *u = ARENA_NEW(arena, Mutation);

    u->arena = arena;
    arena_init(&u->work, arena->alloc, arena->context, arena->oom);
    u->p = m ? m->program : p;
    u->scripts = scripts;
    u->step = m ? step_of_member(p->joint, m) : mutant_step(p, script, scripts);
    u->start = arena_array(arena, scripts + (size_t)1, sizeof *u->start);
    add_start(u, m ? m->initial : p->state.at[0]);
    for (uint32_t i = 0; i < scripts && !m; i++)
        add_start(u, script[i]->init_state);
    u->runs = mutant_runs_new(arena, p, member, script, scripts, rq, max_steps);
    u->initial = ARENA_ARRAY(arena, uint64_t, u->p->var.n);
    for (size_t i = 0; i < u->p->var.n; i++)
        u->initial[i] = u->p->var.at[i]->init;
    arena_reset(&u->work);
    u->original = optimised_text(u, arena);
    mutation_list_all(u);
    return u;
}

const Baseline *mutation_baseline(const Mutation *u) { return mutant_runs_baseline(u->runs); }

const Mutant *mutation_list(const Mutation *u, uint32_t *n)
{
    *n = (uint32_t)u->mutant.n;
    return u->mutant.at;
}

void mutation_end(Mutation *u) { arena_free(&u->work); }
