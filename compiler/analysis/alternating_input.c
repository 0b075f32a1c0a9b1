// SPDX-License-Identifier: Apache-2.0
// Reports inputs of scripts that alternate between two values: `after 15 s: x = prev(x)`.  The windows of a script take their samples before
// its inputs (language.md 8.15), so prev(x) is the value of x two steps ago.
#include "compiler/analysis/analysis.h"

// Whether e is prev(v), and nothing else.
static bool is_prev_of(const Script *script, const Expr *e, const Var *v)
{
    const Window *w = e->kind == EX_ROLL ? &script->window.at[e->window] : NULL;

    return w && w->size == 2 && e->stat == SM_STAT_OLDEST && w->sample->kind == EX_VAR && w->sample->var == v;
}

static bool is_time(const Script *script, const Expr *e)
{
    return e->kind == EX_VAR && (e->var == script->program->g || e->var->kind == VAR_TIME);
}

// Whether a guard is true in one step after another: always, from a time on, or from one time to another.  Other guards can be true for one step,
// and then the value of two steps ago is a sensor that repeats an old value.
static bool stays_true(const Script *script, const Expr *guard)
{
    if (expr_is_constant(guard))
        return sm_to_bool(expr_constant_value(guard));
    if (guard->kind == EX_BINARY && (guard->op == SM_OP_GE || guard->op == SM_OP_GT))
        return is_time(script, guard->arg[0]) && expr_is_constant(guard->arg[1]);
    return guard->kind == EX_CHAIN && guard->n == 3 && is_time(script, guard->arg[1]) && expr_is_constant(guard->arg[0]) &&
           expr_is_constant(guard->arg[2]);
}

static void check_item(Diags *diags, const Script *script, const ScriptItem *item)
{
    for (const ScriptItem *outer = item; outer; outer = outer->parent)
        if (outer->otherwise || !stays_true(script, outer->guard))
            return;
    for (size_t i = 0; i < item->inputs.n; i++) {
        const ScriptInput *in = &item->inputs.at[i];
        if (in->value && is_prev_of(script, in->value, in->var))
            diag_label(diags, diag_report(diags, DIAG_input_alternates, in->value->span, in->var->name->text), DIAG_label_two_steps_ago,
                       format_in(diags->arena, "prev(%s)", in->var->name->text));
    }
}

void analyse_inputs_of_script(Diags *diags, const Script *script)
{
    for (size_t s = 0; s < script->section.n; s++)
        for (size_t i = 0; i < script->section.at[s].item.n; i++)
            check_item(diags, script, script->section.at[s].item.at[i]);
}
