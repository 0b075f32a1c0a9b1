// SPDX-License-Identifier: Apache-2.0
// Calls of min, max, median and average, which have 2 to SM_LIST_MAX arguments (language.md 3.42 to 3.46).
#include "compiler/sema/sema.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

// Whether roll_median(x, n) would be valid with this argument of median as its second.
static bool is_window_size(const Sema *s, const AstExpr *n, const Expr *value)
{
    SmF64 x;

    if (n->kind == AST_STEPS)
        return true;
    if (value->kind == EX_NUMBER && value->unit != TIME_NONE)
        return s->step > 0;
    x = expr_constant_value(value);
    return sm_eq(sm_trunc(x), x) && sm_le(sm_from_i32(1), x) && sm_le(x, sm_from_u32(SM_WINDOW_MAX));
}

// Reports a constant among the arguments of median or average: such a call is probably meant as one of roll_median or roll_avg. `value`: the
// argument, or NULL for a number of steps.
static void report_constant(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn, uint32_t index, const Expr *value)
{
    AstExpr *const *args = call->args->at;
    const char *roll = fn == &sm_builtin_info[SM_FN_median] ? "roll_median" : "roll_avg";
    Diag *d = diag_report(s->diags, DIAG_constant_in_list, args[index]->span, fn->name, sema_quote_source(s, args[index]->span));
    const bool is_size = index > 0 && is_window_size(s, args[index], value);

    diag_label(s->diags, d, DIAG_label_rolls, roll, sema_quote_source(s, args[0]->span),
               is_size ? sema_quote_source(s, args[index]->span) : "n");
    if (is_size && call->args->n == 2)
        diag_edit(s->diags, d, ast_op_span(call), roll);
}

static void find_element(Expr *e, void *context)
{
    bool *found = context;

    *found |= e->kind == EX_VAR && e->var->kind != VAR_LOCAL;
}

static void mark_listed(Expr *e, void *context)
{
    (void)context;
    if (e->kind == EX_VAR)
        e->var->listed = true;
}

// Marks the locals of a value of median or average that would be a constant if they were marked @read_only.
static void mark_locals_of_value(Expr *value)
{
    bool varies = false;

    expr_walk(value, find_element, &varies);
    if (!varies)
        expr_walk(value, mark_listed, NULL);
}

// Checks the arguments, all of them even after an error. Returns whether they are valid.
static bool check_values(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn, Expr *out)
{
    const bool allows_constants = fn == &sm_builtin_info[SM_FN_min] || fn == &sm_builtin_info[SM_FN_max];
    bool good = true, reported = false;

    for (uint32_t i = 0; i < out->n; i++) {
        const AstExpr *value = call->args->at[i];
        const bool in_steps = !allows_constants && value->kind == AST_STEPS;
        out->arg[i] = in_steps ? NULL : check_expr(s, value);
        if (!reported && (in_steps || (!allows_constants && out->arg[i] && expr_is_constant(out->arg[i])))) {
            report_constant(s, call, fn, i, out->arg[i]);
            reported = true;
        }
        if (!allows_constants && out->arg[i])
            mark_locals_of_value(out->arg[i]);
        good = good && out->arg[i];
    }
    return good && !reported;
}

Expr *check_list_call(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn)
{
    Expr *out = expr_new(s, EX_CALL, call->span, (uint32_t)call->args->n);

    out->fn = (SmBuiltin)(fn - sm_builtin_info);
    return check_values(s, call, fn, out) ? out : NULL;
}
