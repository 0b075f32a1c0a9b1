// SPDX-License-Identifier: Apache-2.0
// Definitions, the lines of [define] (language.md 5.61 to 5.66). A use of a definition is checked as its expression would be at that place, so
// a definition that is valid in a step can be an error in an initial value.
#include "compiler/sema/member.h"

enum { EXPANDED_MAX = 100000 };       // the most nodes that the uses of definitions in a file can have together

// ---- declarations ----

// Copies the expression, because a script can use a definition after the tree of its machine is freed.
static AstExpr *copy_tree(Arena *arena, const AstExpr *e)
{
    AstExpr *out = arena_copy(arena, e, sizeof *e);

    out->a = e->a ? copy_tree(arena, e->a) : NULL;
    out->b = e->b ? copy_tree(arena, e->b) : NULL;
    if (!e->args)
        return out;
    out->args = ARENA_NEW(arena, AstArgs);
    for (size_t i = 0; i < e->args->n; i++)
        vec_push(arena, out->args, copy_tree(arena, e->args->at[i]));
    return out;
}

// Returns the number of operations and values of the expression after all definitions in it are expanded, but at most EXPANDED_MAX + 1.
static uint32_t expanded_size(const Sema *s, const AstExpr *e)
{
    const Define *d = e->kind == AST_NAME ? map_find(&s->defines, e->name) : NULL;
    uint32_t n = d ? d->size : 1;

    if (e->a)
        n += expanded_size(s, e->a);
    if (e->b)
        n += expanded_size(s, e->b);
    for (size_t i = 0; e->args && i < e->args->n && n <= EXPANDED_MAX; i++)
        n += expanded_size(s, e->args->at[i]);
    return n <= EXPANDED_MAX ? n : EXPANDED_MAX + 1;
}

// Reports a name that already has a meaning. Returns whether the definition can have the name.
static bool check_name_is_free(Sema *s, const AstDefinition *in)
{
    const Define *first = map_find(&s->defines, in->name);
    const Var *v = scope_find_variable(s, in->name);
    Diag *d;

    if (s->in_script && report_dotted_declaration(s, in->name, in->name_span))
        return false;
    if (!first && !v)
        return true;
    if (v && v->kind == VAR_TIME)
        diag_report(s->diags, DIAG_time_declared, in->name_span);
    else if (first)
        diag_note(s->diags, diag_report(s->diags, DIAG_name_taken, in->name_span, in->name->text, "a definition"), first->span,
                  DIAG_note_declared_here, in->name->text);
    else {
        d = diag_report(s->diags, DIAG_name_taken, in->name_span, in->name->text, v->kind == VAR_LOCAL ? "a local" : "an element");
        scope_note_declared(s, d, in->name);
    }
    return false;
}

// Adds the definitions of one section to those that the following text can use.
void declare_definitions(Sema *s, const AstSection *section, Defines *into)
{
    const CheckContext c = {.arena = s->arena, .strings = s->strings, .diags = s->diags};

    for (size_t i = 0; i < section->definitions.n; i++) {
        const AstDefinition *in = &section->definitions.at[i];
        Define *d;

        add_definition_allows(s, in);
        if (!check_name_is_free(s, in))
            continue;
        d = ARENA_NEW(s->arena, Define);
        d->name = in->name;
        d->span = in->name_span;
        d->value = copy_tree(s->arena, in->value);
        d->value_span = in->value->span;
        d->number = (uint32_t)s->defines.n;
        d->size = expanded_size(s, d->value);
        d->unit = check_unit(&c, &in->annotations, d->name, false);
        s->has_units |= d->unit != NULL;
        map_put(&s->defines, d->name, d);
        vec_push(s->arena, into, d);
    }
}

// Makes the definitions of the machine usable in a script.
void add_definitions_of_machine(Sema *s)
{
    for (size_t i = 0; i < s->p->define.n; i++)
        map_put(&s->defines, s->p->define.at[i]->name, s->p->define.at[i]);
}

// ---- uses ----

// Returns whether the definition can be used here, and reports the use if not: only later definitions can use a definition, and the whole
// expression has to stay within the limits.
static bool check_use(Sema *s, const Define *d, const AstExpr *use)
{
    if (s->inside && d->number >= s->inside->number) {
        if (d == s->inside)
            diag_report(s->diags, DIAG_definition_of_itself, use->span, d->name->text);
        else
            diag_note(s->diags, diag_report(s->diags, DIAG_definition_later, use->span, s->inside->name->text, d->name->text), d->span,
                      DIAG_note_declared_here, d->name->text);
        return false;
    }
    if (!s->inside && s->expanded > EXPANDED_MAX)                         // has been reported
        return false;
    if (!s->inside && (s->expanded += d->size) > EXPANDED_MAX) {
        diag_report(s->diags, DIAG_definitions_too_large, d->span, d->name->text);
        return false;
    }
    if (s->depth + d->value->depth <= AST_DEPTH_MAX)
        return true;
    diag_report(s->diags, DIAG_expression_too_deep, use->span, format_in(s->arena, "%d", AST_DEPTH_MAX));
    return false;
}

// Adds a use to d->use, for reports.  The use is listed once, even if the definition that contains it is expanded many times.
static void add_use(Sema *s, Define *d, const AstExpr *use)
{
    const DefineUse here = {sema_span(s, use->span), s->inside};

    if (!s->inside || !s->inside->expanded)
        vec_push(s->arena, &d->use, here);
    d->used = d->used || !s->inside || s->inside->used;
}

// Builds the expression of a definition that `use` names. The root has the span of the use, because messages quote what the user wrote there.
Expr *expand_definition(Sema *s, Define *d, const AstExpr *use)
{
    const bool own = !s->in_script || d->number >= s->p->define.n;    // false: a script uses a definition of its machine, and does not change it
    Define *outer = s->inside;
    Expr *out;

    if (own)
        add_use(s, d, use);
    d->used = d->used || s->in_requirements;
    s->knows_a_name = true;
    if (!check_use(s, d, use))
        return NULL;
    s->inside = d;
    out = check_expr(s, d->value);
    s->inside = outer;
    d->expanded = d->expanded || own;
    if (out)
        out->span = sema_span(s, use->span);
    if (out && d->unit) {
        d->names = out->define;
        out->define = d->number + 1;
    }
    return out;
}

void report_unused_definitions(Diags *diags, const Defines *all)
{
    for (size_t i = 0; i < all->n; i++)
        if (!all->at[i]->used && all->at[i]->value->kind != AST_ERROR)
            diag_report(diags, DIAG_unused_definition, all->at[i]->span, all->at[i]->name->text);
}

// Reports the errors of the definitions that nothing uses. Their windows belong to no machine.
void check_unused_definitions(Sema *s, const Defines *all)
{
    Windows none = {0}, *used = s->windows;

    s->windows = &none;
    for (size_t i = 0; i < all->n; i++) {
        Define *d = all->at[i];
        if (d->used)
            continue;
        s->inside = d;
        if (d->size <= EXPANDED_MAX)
            check_expr(s, d->value);
        s->inside = NULL;
    }
    s->windows = used;
}
