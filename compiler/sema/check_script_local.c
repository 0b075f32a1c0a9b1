// SPDX-License-Identifier: Apache-2.0
// [local] of a script: its variables (language.md 8.22 to 8.25).
#include "compiler/sema/sema.h"

#include "stdlib/convert.h"

// Returns what `name` already means: "a state of the machine"; NULL: nothing.
static const char *find_meaning(const Sema *s, Str name)
{
    const Var *v = scope_find_variable(s, name);

    if (!v)
        return map_find(&s->p->state_by_name, name) ? "a state of the machine" : NULL;
    if (v->of_script)
        return "a local of the script";
    return v->kind == VAR_LOCAL ? "a local of the machine" : v->name == name ? "an element of the machine" : "an alias of the machine";
}

// Adds a note that points at the first declaration of a name.
static void note_first(Sema *s, Diag *d, Str name)
{
    const State *state = map_find(&s->p->state_by_name, name);

    if (scope_find_variable(s, name))
        scope_note_declared(s, d, name);
    else if (state)
        diag_note(s->diags, d, state->span, DIAG_note_declared_here, name->text);
}

static void declare_local(Sema *s, Script *script, const AstDecl *decl)
{
    Var *v = sema_new_var(s, VAR_LOCAL, decl);
    const char *meaning = find_meaning(s, v->name);

    v->of_script = true;
    v->is_constant = v->read_only;
    v->index = (uint32_t)(s->p->var.n + script->local.n);
    vec_push(s->arena, &script->local, v);
    if (s->p->t->name == v->name)
        diag_report(s->diags, DIAG_time_declared, v->span);
    else if (meaning)
        note_first(s, diag_report(s->diags, DIAG_name_taken, v->span, v->name->text, meaning), v->name);
    else
        map_put(&s->script_local, v->name, v);
}

// Computes the initial values.  `local` is declared by `decl`.
static void compute_value(Sema *s, Var *local, const AstDecl *decl)
{
    Expr *e;

    s->local = local;
    e = decl->value ? check_expr(s, decl->value) : NULL;
    local->init_value = e;
    s->no_value[local->index] = !e;
    if (e)
        local->init = sm_cell_from_f64(local->type, expr_constant_value(e));
}

void check_script_locals(Sema *s, Script *script, const AstFile *ss)
{
    size_t n = 0;

    for (size_t i = 0; i < ss->sections.n; i++)
        for (size_t k = 0; k < ss->sections.at[i]->decls.n; k++)
            declare_local(s, script, &ss->sections.at[i]->decls.at[k]);
    s->no_value = ARENA_ARRAY(s->arena, bool, s->p->var.n + script->local.n);
    s->at = EXPR_IN_INITIAL;
    for (size_t i = 0; i < ss->sections.n; i++)
        for (size_t k = 0; k < ss->sections.at[i]->decls.n; k++)
            compute_value(s, script->local.at[n++], &ss->sections.at[i]->decls.at[k]);
    s->at = EXPR_IN_STEP;
}
