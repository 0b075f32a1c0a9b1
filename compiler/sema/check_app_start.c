// SPDX-License-Identifier: Apache-2.0
// [start] of an application: the values of elements before anything runs (docs/config.md 10.8).  Values are checked like those
// of a machine without variables.
#include "compiler/sema/app_check.h"

#include <string.h>

#include "stdlib/convert.h"

// Whether the expression contains only numbers; reports the parts that are not.
static bool is_of_numbers(AppCheck *k, const Sema *s, const AstExpr *e)
{
    const SmBuiltinInfo *fn = e->kind == AST_CALL ? scope_find_function(s, e->name) : NULL;
    bool good = true;

    if (e->kind == AST_NAME || (fn && fn->is_roll)) {
        diag_report(k->c->diags, DIAG_start_no_number, e->span);
        return false;
    }
    if (e->a)
        good = is_of_numbers(k, s, e->a);
    if (e->b)
        good = is_of_numbers(k, s, e->b) && good;
    for (size_t i = 0; e->args && i < e->args->n; i++)
        good = is_of_numbers(k, s, e->args->at[i]) && good;
    return good && e->kind != AST_ERROR;
}

// Reports a value that the type of its element cannot represent.
static void check_fit(AppCheck *k, const AstStmt *in, const Element *e, SmF64 value, uint64_t cell)
{
    SmF64 kept = sm_cell_to_f64(e->type, cell);

    if (e->type == SM_F32 || e->type == SM_F64 || sm_eq(kept, value))
        return;
    diag_report(k->c->diags, DIAG_start_range, in->value->span, const_text(k->c->arena, value), e->name->text,
                sm_type_info[e->type].spelling, const_text(k->c->arena, kept));
}

static bool is_first(AppCheck *k, const AstStmt *in)
{
    const Span *first = map_find(&k->start, in->name);

    if (first) {
        diag_note(k->c->diags, diag_report(k->c->diags, DIAG_start_twice, in->name_span, in->name->text), *first,
                  DIAG_note_first_here);
        return false;
    }
    map_put(&k->start, in->name, &((AstStmt *)(size_t)in)->name_span);
    return true;
}

static void check_value(AppCheck *k, Sema *s, const AstStmt *in)
{
    const AstWord name = {in->name, in->name_span};
    const Element *e = app_find_element(k, &name);
    Expr *value = is_first(k, in) && is_of_numbers(k, s, in->value) ? check_expr(s, in->value) : NULL;
    AppStart out;

    if (!e || !value)
        return;
    out.element = e;
    out.cell = sm_cell_from_f64(e->type, const_eval(value));
    check_fit(k, in, e, const_eval(value), out.cell);
    vec_push(k->c->arena, &k->app->start, out);
}

void check_app_start(AppCheck *k)
{
    Program *nothing = ARENA_NEW(k->c->arena, Program);
    Lost *lost = ARENA_NEW(k->c->arena, Lost);
    Sema s;

    nothing->by_name.arena = nothing->state_by_name.arena = lost->word.arena = k->c->arena;
    sema_init(&s, k->c, lost, nothing, &nothing->window);
    for (size_t i = 0; i < k->ast->start.n; i++)
        check_value(k, &s, k->ast->start.at[i]);
}
