// SPDX-License-Identifier: Apache-2.0
// The slow reference of a swap (swapping.md 12.7 to 12.15).  It compares the programs, not their images, and copies between two reference
// interpreters.  It uses neither code of bytecode-vm/swap.c nor the names in the DEBUG section.
#include <string.h>

#include "tests/swap/machine.h"

static bool is_same_text(Str a, Str b) { return a->len == b->len && memcmp(a->text, b->text, a->len) == 0; }

static double constant_value(const Program *p, const Expr *e)
{
    uint64_t cell[4096];

    for (size_t i = 0; i < p->var.n && i < 4096; i++)
        cell[i] = p->var.at[i]->init;
    return ref_eval(e, cell, NULL);
}

// Whether two numbers are the same; any NaN equals any other.
static bool is_same_number(double a, double b)
{
    return (a != a && b != b) || (a == b && ref_negative(a) == ref_negative(b));
}

static bool samples_same(const Program *p, const Expr *a, const Program *q, const Expr *b);

static bool is_same_window(const Program *p, const Window *a, const Program *q, const Window *b)
{
    return a->size == b->size && samples_same(p, a->sample, q, b->sample);
}

static bool is_same_variable(const Var *a, const Var *b)
{
    return a->kind == b->kind && is_same_text(a->name, b->name) && (a->kind != VAR_LOCAL || a->type == b->type);
}

// Whether a local may receive the value of another (swapping.md 12.55, 12.56): both are parameters or neither is, and the value is in the range.
static bool may_keep(const Var *old, const Var *new, uint64_t cell)
{
    const double x = ref_read(new->type, cell);

    return (!old->parameter && !new->parameter) || (old->parameter && new->parameter && new->parameter->lo <= x && x <= new->parameter->hi);
}

static bool has_same_operators(const Expr *a, const Expr *b)
{
    const bool relations[2] = {a->kind == EX_CHAIN, b->kind == EX_CHAIN};

    for (uint32_t i = 0; i + 1 < a->n; i++)
        if ((relations[0] ? expr_ops(a)[i] : a->op) != (relations[1] ? expr_ops(b)[i] : b->op))
            return false;
    return a->n > 1 || a->op == b->op;
}

// Whether two windows sample the same expression: the same operators on the same elements, locals and constants.
static bool samples_same(const Program *p, const Expr *a, const Program *q, const Expr *b)
{
    if (expr_is_constant(a) || expr_is_constant(b))
        return expr_is_constant(a) && expr_is_constant(b) && is_same_number(constant_value(p, a), constant_value(q, b));
    if (a->kind != b->kind || a->n != b->n)
        return false;
    if (a->kind == EX_VAR)
        return is_same_variable(a->var, b->var);
    if (a->kind == EX_ROLL)
        return a->stat == b->stat && is_same_window(p, &p->window.at[a->window], q, &q->window.at[b->window]);
    if (a->kind == EX_CALL ? a->fn != b->fn : !has_same_operators(a, b))
        return false;
    for (uint32_t i = 0; i < a->n; i++)
        if (!samples_same(p, a->arg[i], q, b->arg[i]))
            return false;
    return true;
}

static void copy_elements(const RefEngine *from, RefEngine *to)
{
    for (size_t i = 0; i < to->p->var.n; i++)
        for (size_t k = 0; k < from->p->var.n; k++)
            if (to->p->var.at[i]->kind == VAR_ELEMENT && is_same_variable(from->p->var.at[k], to->p->var.at[i]))
                to->cell[i] = from->cell[k];
}

void reference_restart(const RefEngine *from, RefEngine *to, uint32_t state)
{
    EngineStep out;

    engine_step_init(&out, to->arena, to->p);
    to->engine.init(&to->engine, state, &out);
    copy_elements(from, to);
    to->cell[to->p->s->index] = state;
}

bool reference_continue(const RefEngine *from, RefEngine *to, const bool *from_has, const bool *to_has)
{
    const State *state = NULL;

    for (size_t i = 0; i < to->p->state.n; i++)
        if (is_same_text(to->p->state.at[i]->name, from->state->name))
            state = to->p->state.at[i];
    if (state == NULL)
        return false;
    reference_restart(from, to, state->number);
    to->is_first = from->is_first;
    to->has_run = from->has_run;
    to->last_g = from->last_g;
    to->start = from->start;
    to->cell[to->p->t->index] = from->cell[from->p->t->index];
    for (size_t i = 0; i < to->p->var.n; i++)
        for (size_t k = 0; k < from->p->var.n; k++) {
            const Var *v = to->p->var.at[i], *old = from->p->var.at[k];
            if (v->kind == VAR_LOCAL && is_same_variable(old, v) && !v->is_constant && !old->is_constant && may_keep(old, v, from->cell[k]))
                to->cell[i] = from->cell[k];
        }
    for (size_t i = 0; i < to->windows.n; i++)
        for (size_t k = from->windows.n; k-- > 0;) {
            RefWindow *w = &to->windows.at[i], *old = &from->windows.at[k];
            if (!from_has[k] || !to_has[i] || !is_same_window(from->p, old->what, to->p, w->what))
                continue;
            memcpy(w->slot, old->slot, w->what->size * sizeof *w->slot);
            w->next = old->next;
            w->filled = old->filled;
        }
    return true;
}

const bool *machine_windows(SwapMachine *s)
{
    const Program *p = s->program;
    bool *has = ARENA_ARRAY(&s->session.arena, bool, p->window.n);
    Buf name;

    for (size_t i = 0; i < p->window.n; i++) {
        buf_init(&name, &s->session.arena);
        expr_name_window(&s->session.arena, &p->window, &p->window.at[i], SMVM_SAMPLE_NAME_MAX, &name);
        for (size_t k = 0; k < s->ir->window.n; k++)
            has[i] = has[i] || (name.n <= SMVM_SAMPLE_NAME_MAX && is_same_window(p, &p->window.at[i], p, s->ir->window.at[k].first));
    }
    return has;
}
