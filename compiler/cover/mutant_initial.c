// SPDX-License-Identifier: Apache-2.0
// Finds initial values that no run reads, because the local is assigned before it is read, on every path from the start.
#include "compiler/cover/mutant.h"

typedef struct InitialSearch { const Program *p; const Var *v; bool is_read; } InitialSearch;         // is_read: v is read before it is assigned

// Sets k->is_read if an expression reads the variable.
static void note_read(Expr *e, void *context)
{
    InitialSearch *k = context;

    k->is_read = k->is_read || (e->kind == EX_VAR && e->var == k->v);
}

// Visits statements that begin while variable k->v is not assigned yet.  Returns whether it is assigned on every path through them.  Code that
// follows a transition is visited as if the transition did not end the block, which can only find more reads.
static bool follow_statements(InitialSearch *k, const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        bool then, otherwise;
        if (s->value)
            expr_walk(s->value, note_read, k);
        if (s->kind == ST_ASSIGN && s->var == k->v)
            return true;
        if (s->kind != ST_IF)
            continue;
        then = follow_statements(k, &s->then);
        otherwise = follow_statements(k, &s->otherwise);
        if (then && otherwise)
            return true;
    }
    return false;
}

// Whether code outside of statements reads variable k->v: the samples of windows, or the initial values of other locals.
static bool is_read_elsewhere(InitialSearch *k)
{
    for (size_t i = 0; i < k->p->window.n; i++)
        expr_walk(k->p->window.at[i].sample, note_read, k);
    for (size_t i = 0; i < k->p->var.n; i++)
        if (k->p->var.at[i]->kind == VAR_LOCAL && k->p->var.at[i]->init_value)
            expr_walk(k->p->var.at[i]->init_value, note_read, k);
    return k->is_read;
}

bool mutant_initial_is_own(const Program *p, const Var *v)
{
    InitialSearch k = {p, v, false};

    return v->kind == VAR_LOCAL && !v->outside && !v->parameter && !v->sizes && !v->is_constant && !is_read_elsewhere(&k);
}

// When .exit runs, a transition may have skipped a part of .step.  So assignments in .step do not count as made before .exit.
bool mutant_initial_is_unread(const Program *p, const Var *v)
{
    InitialSearch k = {p, v, false};

    if (!mutant_initial_is_own(p, v))
        return false;
    for (size_t s = 0; s < p->state.n && !k.is_read; s++)
        if (!follow_statements(&k, &p->state.at[s]->block[BLOCK_ENTRY])) {
            follow_statements(&k, &p->state.at[s]->block[BLOCK_STEP]);
            follow_statements(&k, &p->state.at[s]->block[BLOCK_EXIT]);
        }
    return !k.is_read;
}

// Marks the targets of the transitions in the list.
static bool mark_targets(const Stmts *list, bool *marked)
{
    bool any = false;

    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_TRANSITION)
            any = marked[s->target->number - 1] = true;
        any |= mark_targets(&s->then, marked);
        any |= mark_targets(&s->otherwise, marked);
    }
    return any;
}

// Follows a state that begins with v not assigned, and marks those to which it can lead before it assigns v.
static void follow_state(InitialSearch *k, const State *s, bool *marked)
{
    const bool assigns = follow_statements(k, &s->block[BLOCK_ENTRY]);

    if (mark_targets(&s->block[BLOCK_ENTRY], marked) || !assigns)
        follow_statements(k, &s->block[BLOCK_EXIT]);
    if (assigns)
        return;
    follow_statements(k, &s->block[BLOCK_STEP]);
    mark_targets(&s->block[BLOCK_STEP], marked);
}

bool mutant_initial_is_unread_from(Arena *work, const Program *p, const Var *v, const State *const *start, uint32_t starts)
{
    InitialSearch k = {p, v, false};
    bool *marked = arena_alloc(work, p->state.n), *followed = arena_alloc(work, p->state.n);

    if (!mutant_initial_is_own(p, v))
        return false;
    for (uint32_t i = 0; i < starts; i++)
        marked[start[i]->number - 1] = true;
    for (size_t s = 0; s < p->state.n && !k.is_read; s++)
        if (marked[s] && !followed[s]) {
            followed[s] = true;
            follow_state(&k, p->state.at[s], marked);
            s = SIZE_MAX;                             // begin again: an earlier state may be marked now
        }
    return !k.is_read;
}
