// SPDX-License-Identifier: Apache-2.0
// Reports conditions of asserts in scripts that are true whatever the machine does: by themselves, as `open or not open`, or by the types
// of the variables that they compare, as `count >= 0` of an unsigned one.  Uses no facts about the machine: its inputs are the script's.
#include "compiler/analysis/analysis.h"
#include "compiler/analysis/assume.h"
#include "compiler/analysis/guards_imply.h"

// Sets *f to the values that a number or a variable can have.  Returns false for other expressions.
static bool find_operand_fact(const Expr *e, Fact *f)
{
    if (expr_is_constant(e))
        *f = fact_of_number(expr_constant_value(e));
    else if (e->kind == EX_VAR)
        *f = fact_of_type(e->var->type);
    else
        return false;
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

// Whether the types make e always true (`holds`) or never true.  Recursion depth equals the nesting of expressions, which AST_DEPTH_MAX
// bounds.
static bool is_decided(const Analysis *a, const Expr *e, bool holds)
{
    if (holds ? guard_is_always_true(a, e) : guard_is_never_true(a, e))
        return true;
    if (e->kind == EX_UNARY && e->op == SM_OP_NOT)
        return is_decided(a, e->arg[0], !holds);
    if (e->kind != EX_BINARY || (e->op != SM_OP_AND && e->op != SM_OP_OR))
        return is_comparison_decided(e, holds);
    if ((e->op == SM_OP_AND) == holds)
        return is_decided(a, e->arg[0], holds) && is_decided(a, e->arg[1], holds);
    return is_decided(a, e->arg[0], holds) || is_decided(a, e->arg[1], holds);
}

static void check_asserts(const Analysis *a, const ScriptItem *item)
{
    for (size_t i = 0; i < item->asserts.n; i++) {
        const ScriptAssert *s = &item->asserts.at[i];
        if (s->condition && s->kind != SCRIPT_PRINT && is_decided(a, s->condition, true))
            diag_label(a->diags, diag_report(a->diags, DIAG_assert_decided, s->condition->span), DIAG_label_true_for_all);
    }
}

void analyse_asserts_of_script(Diags *diags, const Script *script)
{
    const IrMachine no_machine = {.window_of = NULL};          // guards_imply.h: windows with different numbers differ
    const Analysis a = {.diags = diags, .p = script->program, .m = &no_machine};

    for (size_t s = 0; s < script->section.n; s++)
        for (size_t i = 0; i < script->section.at[s].item.n; i++)
            check_asserts(&a, script->section.at[s].item.at[i]);
}
