// SPDX-License-Identifier: Apache-2.0
// Calls of roll functions (language.md 7): the sampled expression, and a size that is known at compile time.
#include "compiler/sema/sema.h"

#include "stdlib/convert.h"
#include "stdlib/math.h"

static bool is_whole(SmF64 x)
{
    return sm_eq(sm_trunc(x), x);
}

// The size, or 0 after a report.
static uint32_t size_of_window(Sema *s, const AstExpr *n, const Expr *value, const SmBuiltinInfo *fn)
{
    SmF64 x = const_eval(value);

    if (!is_whole(x))
        diag_report(s->diags, DIAG_window_size_not_whole, n->span, fn->name, const_text(s->arena, x));
    else if (sm_lt(x, sm_from_i32(1)) || sm_lt(sm_from_u32(SM_WINDOW_MAX), x))
        diag_report(s->diags, DIAG_window_size_range, n->span, fn->name, const_text(s->arena, x));
    else
        return sm_to_u32(x);
    return 0;
}

static uint32_t check_size(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn)
{
    const AstExpr *n = call->args->at[1];
    Expr *value;

    s->at = PLACE_SIZE;
    s->size_of = call->name;
    value = check_expr(s, n);
    s->at = PLACE_STEP;
    return value ? size_of_window(s, n, value, fn) : 0;
}

static bool allowed_here(Sema *s, const AstExpr *call)
{
    if (s->at == PLACE_INITIAL)
        diag_report(s->diags, DIAG_initial_value_rolls, ast_op_span(call), s->local->name->text, call->name->text);
    else if (s->at == PLACE_SIZE)
        diag_report(s->diags, DIAG_window_size_rolls, ast_op_span(call), s->size_of->text, call->name->text);
    return s->at == PLACE_STEP;
}

Expr *check_roll(Sema *s, const AstExpr *call, const SmBuiltinInfo *fn)
{
    Window w = {0};
    Expr *out;

    s->varies = true;
    if (!allowed_here(s, call))
        return NULL;
    out = expr_new(s, EX_ROLL, call->span, 1);
    out->arg[0] = w.sample = check_expr(s, call->args->at[0]);     // inner windows get a lower index than this one
    w.size = check_size(s, call, fn);
    w.stat = out->stat = fn->stat;
    w.span = call->span;
    if (!w.sample || !w.size)
        return NULL;
    out->window = (uint32_t)s->windows->n;
    vec_push(s->arena, s->windows, w);
    return out;
}

void check_size_uses(Sema *s)
{
    for (size_t i = 0; i < s->size_use.n; i++) {
        const SizeUse *use = &s->size_use.at[i];
        if (use->local->written) {
            Diag *d = diag_report(s->diags, DIAG_window_size_of_variable, use->span, use->local->name->text);
            diag_note(s->diags, d, use->local->span, DIAG_note_declared_here, use->local->name->text);
        }
    }
}
