// SPDX-License-Identifier: Apache-2.0
// Which outputs are hazards: those that no state marked @safe or @abort switches on, such as a charge, an igniter or a fill valve.  Not
// a vent that is open in an @abort state, a lamp of a safe state, or an integer that gets constants only: a code for people.
#include "compiler/cover/mutant.h"

typedef enum StateTruth { IS_FALSE, IS_TRUE, IS_OPEN } StateTruth;

static StateTruth negate(StateTruth t) { return t == IS_OPEN ? IS_OPEN : t == IS_TRUE ? IS_FALSE : IS_TRUE; }

// Returns what a condition is in a state, if S alone decides.
static StateTruth truth_in_state(const Program *p, const Expr *e, const State *s)
{
    StateTruth a, b;

    if (expr_is_constant(e))
        return sm_eq(expr_constant_value(e), sm_from_i32(0)) ? IS_FALSE : IS_TRUE;
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return negate(truth_in_state(p, e->arg[0], s));
    if (e->kind != EX_BINARY)
        return IS_OPEN;
    if (e->op == SM_OP_EQ || e->op == SM_OP_NE) {
        const int side = e->arg[0]->kind == EX_VAR && e->arg[0]->var == p->s ? 0 : 1;
        const Expr *x = e->arg[side], *number = e->arg[1 - side];
        if (x->kind != EX_VAR || x->var != p->s || !expr_is_constant(number))
            return IS_OPEN;
        return sm_eq(expr_constant_value(number), sm_from_u64(s->number)) == (e->op == SM_OP_EQ) ? IS_TRUE : IS_FALSE;
    }
    if (e->op != SM_OP_AND && e->op != SM_OP_OR)
        return IS_OPEN;
    a = truth_in_state(p, e->arg[0], s);
    b = truth_in_state(p, e->arg[1], s);
    if (e->op == SM_OP_AND)
        return a == IS_FALSE || b == IS_FALSE ? IS_FALSE : a == IS_TRUE && b == IS_TRUE ? IS_TRUE : IS_OPEN;
    return a == IS_TRUE || b == IS_TRUE ? IS_TRUE : a == IS_FALSE && b == IS_FALSE ? IS_FALSE : IS_OPEN;
}

// Whether a statement of the state can switch the variable on.
static bool switches_on(const Program *p, const Stmts *list, const State *s, const Var *v)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *x = list->at[i];
        if (x->kind == ST_ASSIGN && x->var == v && truth_in_state(p, x->value, s) != IS_FALSE)
            return true;
        if (switches_on(p, &x->then, s, v) || switches_on(p, &x->otherwise, s, v))
            return true;
    }
    return false;
}

static bool state_switches_on(const Program *p, const State *s, const Var *v)
{
    for (int b = 0; b < BLOCK_COUNT; b++)
        if (switches_on(p, &s->block[b], s, v))
            return true;
    return false;
}

// Whether all values that statements of the list assign to the variable are constants.
static bool gets_constants(const Stmts *list, const Var *v)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *x = list->at[i];
        if ((x->kind == ST_ASSIGN && x->var == v && !expr_is_constant(x->value)) || !gets_constants(&x->then, v) || !gets_constants(&x->otherwise, v))
            return false;
    }
    return true;
}

static bool is_code(const Program *p, const Var *v)
{
    bool is_constant = v->type != SM_BOOL && sm_type_info[v->type].kind != SM_KIND_FLOAT;

    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            is_constant &= gets_constants(&p->state.at[s]->block[b], v);
    return is_constant;
}

bool mutant_is_hazard(const Program *p, const Var *v)
{
    bool marked = false, on = false;

    for (size_t s = 0; s < p->state.n; s++) {
        const State *x = p->state.at[s];
        const bool is_marked = x->is_safe || x->is_abort, is_on = state_switches_on(p, x, v);
        marked |= is_marked;
        on |= is_on;
        if (is_marked && is_on)
            return false;
    }
    return v->kind == VAR_ELEMENT && v->written && marked && on && v != p->s && !is_code(p, v);
}

bool mutant_state_has_hazard(const Program *p, const State *s, const bool *hazard)
{
    for (size_t v = 0; v < p->var.n; v++)
        if (hazard[v] && state_switches_on(p, s, p->var.at[v]))
            return true;
    return false;
}
