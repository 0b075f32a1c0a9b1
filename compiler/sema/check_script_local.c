// SPDX-License-Identifier: Apache-2.0
// [local] of a script: its variables (language.md 8.23 to 8.26).
#include "compiler/sema/member.h"

#include <string.h>

#include "stdlib/convert.h"

// Returns what `name` already means: "a state of the machine"; NULL: nothing.
static const char *find_meaning(const Sema *s, Str name)
{
    const Var *v = scope_find_variable(s, name);

    if (!v && map_find(&s->defines, name))
        return "a definition of the machine";
    if (!v)
        return map_find(&s->p->state_by_name, name) ? "a state of the machine" : NULL;
    if (v->of_script)
        return "a local of the script";
    return v->kind == VAR_LOCAL ? "a local of the machine" : v->name == name ? "an element of the machine" : "an alias of the machine";
}

// Adds a note that points at the first declaration of a name.
static void note_first_declaration(Sema *s, Diag *d, Str name)
{
    const State *state = map_find(&s->p->state_by_name, name);

    if (scope_find_variable(s, name) || map_find(&s->defines, name))
        scope_note_declared(s, d, name);
    else if (state)
        diag_note(s->diags, d, state->span, DIAG_note_declared_here, name->text);
}

// Declares the script's local number n. Its index follows those of the machine's variables.
static void declare_local(Sema *s, Script *script, size_t n, const AstDecl *decl)
{
    Var *v = sema_new_var(s, VAR_LOCAL, decl);
    const char *meaning = find_meaning(s, v->name);

    v->of_script = true;
    v->is_constant = v->read_only;
    v->index = (uint32_t)(s->p->var.n + n);
    vec_push(s->arena, &script->local, v);
    if (report_dotted_declaration(s, v->name, v->span))
        map_put(&s->script_local, v->name, v);
    else if (strcmp(v->name->text, "T") == 0)
        diag_report(s->diags, DIAG_time_declared, v->span);
    else if (meaning)
        note_first_declaration(s, diag_report(s->diags, DIAG_name_taken, v->span, v->name->text, meaning), v->name);
    else
        map_put(&s->script_local, v->name, v);
}

static void compute_value(Sema *s, Script *script, size_t n, const AstDecl *decl)
{
    Var *local = script->local.at[n];
    Expr *e;

    s->local = local;
    e = decl->value ? check_expr(s, decl->value) : NULL;
    local->init_value = e;
    s->no_value[local->index] = !e;
    if (e)
        local->init = sm_cell_from_f64(local->type, expr_constant_value(e));
}

// Calls f for each declaration in the [local] sections of the files; n counts them from 0.
static void each_local(const AstFile *const *file, size_t files, void (*f)(Sema *s, Script *script, size_t n, const AstDecl *decl), Sema *s,
                       Script *script)
{
    size_t n = 0;

    for (size_t i = 0; i < files; i++)
        for (size_t k = 0; k < file[i]->sections.n; k++)
            for (size_t d = 0; d < file[i]->sections.at[k]->decls.n; d++)
                f(s, script, n++, &file[i]->sections.at[k]->decls.at[d]);
}

void check_script_locals(Sema *s, Script *script, const AstFile *const *file, size_t files)
{
    each_local(file, files, declare_local, s, script);
    s->no_value = ARENA_ARRAY(s->arena, bool, s->p->var.n + script->local.n);
    s->at = EXPR_IN_INITIAL;
    each_local(file, files, compute_value, s, script);
    s->at = EXPR_IN_STEP;
}
