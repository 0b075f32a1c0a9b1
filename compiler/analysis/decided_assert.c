// SPDX-License-Identifier: Apache-2.0
// Reports conditions of asserts in scripts that are true whatever the machine does:
//
//   - by themselves, as `open or not open`, or by the types of the variables that they compare, as `count >= 0` of an unsigned one,
//     and by the numbers of the states, as `S != 9` of a machine with 8;
//   - because of a guard around the assert, as `G > 0` where T > 1 s;
//   - because of an input that the same body sets to a constant.
//
// Guards and inputs are evaluated before the step, and the assert after it.  So the last two use only variables that the machine does not
// write and that no later item of the script writes in the same step.  G, S and T do not change in a step.  Uses no facts about the machine: its
// inputs are the script's.  Requirements have the first kind, and premises that imply what they require.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/assume.h"
#include "compiler/analysis/guards_imply.h"
#include "stdlib/convert.h"

#include <string.h>

enum { ITEMS_SEARCHED_MAX = 1000000 };

typedef struct AssertCheck {
    Analysis a;
    const Script *script;         // NULL: conditions of requirements
    const ScriptItem *item;       // the body that contains the assert
    uint32_t budget;              // how many items of the script may still be searched for assignments
} AssertCheck;

// ---- what does not change in a step ----

static bool is_clock(const AssertCheck *k, const Var *v) { return v->kind == VAR_TIME || v == k->a.p->g || v == k->a.p->s; }

// Returns the next conditional around the item whose guard is true when the item runs: not one of which the item is in the `else`.
static const ScriptItem *next_true_guard(const ScriptItem *item)
{
    bool otherwise = item->otherwise;

    for (item = item->parent; item && otherwise; item = item->parent)
        otherwise = item->otherwise;
    return item;
}

// Whether two items never run in one step, because their guards compare G with different times.
static bool exclude_by_time(const AssertCheck *k, const ScriptItem *x, const ScriptItem *y)
{
    for (const ScriptItem *outer = x; outer; outer = next_true_guard(outer))
        for (const ScriptItem *other = y; other; other = next_true_guard(other))
            if (outer->guard->kind == EX_AT && other->guard->kind == EX_AT && !expr_equal(outer->guard, other->guard, k->a.m->window_of))
                return true;
    return false;
}

static bool assigns(const ScriptItem *item, const Var *v)
{
    bool any = false;

    for (size_t i = 0; i < item->inputs.n && !any; i++)
        any = item->inputs.at[i].var == v;
    return any;
}

// Whether an item with at least the number `first` may assign the variable in a step with the assert; true if the search gives up.  Items
// are executed in the order of their numbers.
static bool may_be_assigned(AssertCheck *k, const Var *v, uint32_t first)
{
    const Script *script = k->script;

    for (size_t i = 0; script->data && i < script->data->column.n; i++)
        if (script->data->column.at[i].var == v)
            return true;
    for (size_t s = 0; s < script->section.n; s++)
        for (size_t i = 0; i < script->section.at[s].item.n; i++) {
            const ScriptItem *item = script->section.at[s].item.at[i];
            if (k->budget == 0)
                return true;
            k->budget--;
            if (item->number >= first && assigns(item, v) && !exclude_by_time(k, item, k->item))
                return true;
        }
    return false;
}

// Whether every variable of e has one value from before the item with the number `first` to the end of the step.
static bool is_stable(AssertCheck *k, const Expr *e, uint32_t first)
{
    bool stable = e->kind != EX_ROLL && e->kind != EX_RANDOM;

    if (e->kind == EX_VAR && !e->var->is_constant && !is_clock(k, e->var))
        stable = !e->var->written && !may_be_assigned(k, e->var, first);
    for (uint32_t i = 0; i < e->n && stable; i++)
        stable = is_stable(k, e->arg[i], first);
    return stable;
}

// ---- what the script itself makes true ----

// Returns `at 5 s`, one node, as the comparison G == 5 s; any other expression as it is.
static const Expr *as_comparison(const AssertCheck *k, const Expr *e)
{
    Expr *out, *g, *time;

    if (e->kind != EX_AT)
        return e;
    out = arena_alloc(k->a.arena, sizeof *e + 2 * sizeof(Expr *));
    g = arena_copy(k->a.arena, e, sizeof *e);
    time = arena_copy(k->a.arena, e, sizeof *e);
    memcpy(out, e, sizeof *e);
    out->kind = EX_BINARY;
    out->op = SM_OP_EQ;
    out->n = 2;
    g->kind = EX_VAR;
    time->kind = EX_NUMBER;
    out->arg[0] = g;
    out->arg[1] = time;
    return out;
}

// If e is a lower bound of G, as `G > 0` or `100 <= G`, returns the same for T, which is never above G; else NULL.
static const Expr *bound_of_state_time(const AssertCheck *k, const Expr *e)
{
    const int g = e->op == SM_OP_GT || e->op == SM_OP_GE ? 0 : 1;
    Expr *out, *t;

    if (e->kind != EX_BINARY || (e->op != SM_OP_GT && e->op != SM_OP_GE && e->op != SM_OP_LT && e->op != SM_OP_LE) ||
        e->arg[g]->kind != EX_VAR || e->arg[g]->var != k->a.p->g || !expr_is_constant(e->arg[1 - g]))
        return NULL;
    out = arena_copy(k->a.arena, e, sizeof *e + 2 * sizeof(Expr *));
    t = arena_copy(k->a.arena, e->arg[g], sizeof *t);
    t->var = k->a.p->t;
    out->arg[g] = t;
    return out;
}

// Whether a guard around the assert implies e.
static bool is_implied_by_guard(AssertCheck *k, const Expr *condition)
{
    const Expr *e = as_comparison(k, condition), *of_t = bound_of_state_time(k, e);

    for (const ScriptItem *item = k->item; item; item = next_true_guard(item)) {
        const Expr *guard = as_comparison(k, item->guard);
        const bool implied = guard_implies(&k->a, guard, e) || (of_t && guard_implies(&k->a, guard, of_t));
        if (implied && is_stable(k, e, item->number))
            return true;
    }
    return false;
}

// Sets *x to the constant that the body assigns to the variable last, if the variable has it at the end of the step.
static bool find_set_value(AssertCheck *k, const Var *v, SmF64 *x)
{
    const ScriptInput *set = NULL;

    for (size_t i = 0; i < k->item->inputs.n; i++)
        set = k->item->inputs.at[i].var == v ? &k->item->inputs.at[i] : set;
    if (!set || !expr_is_constant(set->value) || v->written || may_be_assigned(k, v, k->item->number + 1))
        return false;
    *x = sm_cell_to_f64(v->type, sm_cell_from_f64(v->type, expr_constant_value(set->value)));
    return true;
}

// Returns e with the numbers that the body assigns, if that makes it constant; else NULL.
static Expr *with_set_values(AssertCheck *k, const Expr *e)
{
    const size_t ops = e->kind == EX_CHAIN ? (e->n - 1) * sizeof(SmOperator) : 0;
    Expr *out = arena_copy(k->a.arena, e, sizeof *e + e->n * sizeof(Expr *) + ops);
    SmF64 x;

    if (e->kind == EX_VAR && !e->var->is_constant) {
        if (!find_set_value(k, e->var, &x))
            return NULL;
        out->kind = EX_NUMBER;
        out->number = x;
    }
    for (uint32_t i = 0; i < e->n; i++)
        if (!(out->arg[i] = with_set_values(k, e->arg[i])))
            return NULL;
    return expr_is_constant(out) ? out : NULL;
}

// Whether e is true because of what the body of the assert, or a guard around it, does.
static bool is_made_true(AssertCheck *k, const Expr *e)
{
    const Expr *constant;

    if (!k->script || k->a.p->joint || expr_is_constant(e))
        return false;
    constant = k->item->inputs.n > 0 ? with_set_values(k, e) : NULL;
    return (constant && sm_to_bool(expr_constant_value(constant))) || is_implied_by_guard(k, e);
}

// ---- decided by types ----

// Narrows the values of an S to the numbers of the machine's states.  The only state of a machine is no reason for a message: more will follow.
static void bound_by_states(Fact *f, const Program *machine)
{
    if (machine->state.n < 2)
        return;
    f->lo = 1;
    f->hi = (double)machine->state.n;
}

// Sets *f to the values that a number or a variable can have.  Returns false for other expressions.
static bool find_operand_fact(const Expr *e, Fact *f)
{
    if (expr_is_constant(e)) {
        *f = fact_of_number(expr_constant_value(e));
        return true;
    }
    if (e->kind != EX_VAR)
        return false;
    *f = fact_of_type(e->var->type);
    if (e->var->state_of)
        bound_by_states(f, e->var->state_of);
    return true;
}

// Whether the types decide that e is true (`holds`: all its comparisons are) or false (one of its comparisons is).
static bool is_comparison_decided(const Expr *e, bool holds)
{
    const uint32_t n = comparison_count(e);
    uint32_t decided = 0;

    for (uint32_t i = 0; i < n && !expr_is_constant(e); i++) {
        const Comparison c = comparison_at(e, i);
        Fact a, b, result;
        if (!find_operand_fact(c.a, &a) || !find_operand_fact(c.b, &b))
            continue;
        result = fact_of_comparison(c.op, a, b);
        decided += holds ? result.lo == 1 : result.hi == 0;
    }
    return n > 0 && (holds ? decided == n : decided > 0);
}

// Whether it is proved that e is always true where the assert is (`holds`), or never true.  Recursion depth equals the nesting of
// expressions, which AST_DEPTH_MAX bounds.
static bool is_decided(AssertCheck *k, const Expr *e, bool holds)
{
    if (holds ? guard_is_always_true(&k->a, e) || is_made_true(k, e) : guard_is_never_true(&k->a, e))
        return true;
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return is_decided(k, e->arg[0], !holds);
    if (e->kind != EX_BINARY || (e->op != SM_OP_AND && e->op != SM_OP_OR))
        return is_comparison_decided(e, holds);
    if ((e->op == SM_OP_AND) == holds)
        return is_decided(k, e->arg[0], holds) && is_decided(k, e->arg[1], holds);
    return is_decided(k, e->arg[0], holds) || is_decided(k, e->arg[1], holds);
}

// ---- scripts ----

static void check_asserts(AssertCheck *k)
{
    for (size_t i = 0; i < k->item->asserts.n; i++) {
        const ScriptAssert *s = &k->item->asserts.at[i];
        if (s->condition && s->kind != SCRIPT_PRINT)
            analyse_absorbed_condition(k->a.arena, k->a.diags, s->condition);
        if (s->condition && s->kind != SCRIPT_PRINT && is_decided(k, s->condition, true))
            diag_label(k->a.diags, diag_report(k->a.diags, DIAG_assert_decided, s->condition->span), DIAG_label_true_for_all);
    }
}

static const IrMachine no_machine = {.window_of = NULL};          // guards_imply.h: windows with different numbers differ

void analyse_asserts_of_script(Arena *arena, Diags *diags, const Script *script)
{
    AssertCheck k = {{.arena = arena, .diags = diags, .p = script->program, .m = &no_machine}, script, NULL, ITEMS_SEARCHED_MAX};

    for (size_t s = 0; s < script->section.n; s++)
        for (size_t i = 0; i < script->section.at[s].item.n; i++) {
            k.item = script->section.at[s].item.at[i];
            check_asserts(&k);
        }
}

// ---- requirements ----

// Returns what the conditions decide, as a predicate of the requirement; NULL: nothing.
static const char *find_verdict(AssertCheck *k, const Requirement *r)
{
    static const char never[] = "never violated";
    const bool vacuous = r->a && is_decided(k, r->a, false);

    switch (r->kind) {
    case REQUIREMENT_NEVER: return vacuous ? never : is_decided(k, r->a, true) ? "violated in every step" : NULL;
    case REQUIREMENT_ALWAYS:
    case REQUIREMENT_LEADS_TO: return vacuous || is_decided(k, r->b, true) || (r->a && guard_implies(&k->a, r->a, r->b)) ? never : NULL;
    case REQUIREMENT_BEFORE: return vacuous ? never : NULL;
    case REQUIREMENT_AFTER: return vacuous || is_decided(k, r->b, false) ? never : NULL;
    }
    return NULL;
}

void analyse_requirements(Diags *diags, const Requirements *all)
{
    AssertCheck k = {{.diags = diags, .p = all->program, .m = &no_machine}, NULL, NULL, 0};

    for (size_t i = 0; i < all->at.n; i++) {
        const Requirement *r = &all->at.at[i];
        const char *verdict = find_verdict(&k, r);
        if (verdict)
            diag_report(diags, DIAG_requirement_decided, r->span, r->id->text, verdict);
    }
}
