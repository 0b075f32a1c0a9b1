// SPDX-License-Identifier: Apache-2.0
// Statements (language.md 5): what may be written, where transitions may appear and lead, what can never run.  Recursion depth
// equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
#include "compiler/sema/sema.h"

static Stmt *stmt_new(Sema *s, StmtKind kind, const AstStmt *in)
{
    Stmt *out = ARENA_NEW(s->arena, Stmt);

    out->kind = kind;
    out->number = ++s->stmts;
    out->span = in->span;
    return out;
}

static void check_value(Sema *s, const AstStmt *in, Stmt *out)
{
    s->operators = 0;
    s->varies = false;
    out->value = check_expr(s, in->value);
    out->operators = s->operators;
    out->varies = s->varies;
}

// ---- assignments ----

static Diag *report_read_only(Sema *s, const Var *v, Span span, Str name)
{
    if (v == s->p->t)
        return diag_report(s->diags, DIAG_write_time, span);
    if (v == s->p->g)
        return diag_report(s->diags, DIAG_write_global_time, span, name->text);
    if (v == s->p->s) {
        Diag *d = diag_report(s->diags, DIAG_write_state_element, span, name->text);
        if (!s->in_script)
            diag_label(s->diags, d, DIAG_label_change_state);
        return d;
    }
    if (v->kind == VAR_LOCAL)
        return diag_report(s->diags, DIAG_write_constant, span, name->text);
    return diag_report(s->diags, DIAG_write_read_only, span, name->text);
}

// Checks that a statement can assign v; reports it if not.  G, S and T can never be assigned.  A script can write variables that are
// marked @read_only.
static bool check_writable(Sema *s, const Var *v, Str name, Span span)
{
    bool own = v == s->p->g || v == s->p->s || v == s->p->t;

    if (scope_is_doubtful(s, name))
        return false;
    if (!v->read_only || (s->in_script && !own))
        return true;
    scope_note_declared(s, report_read_only(s, v, span, name), name);
    return false;
}

// Returns the state that the value of `S = Vent` or `S = 2` refers to; NULL if there is none.
static const State *state_named_by(const Sema *s, const AstExpr *e)
{
    if (e->kind == AST_NUMBER && sm_le(sm_from_i32(1), e->number) && sm_le(e->number, sm_from_u32((uint32_t)s->p->state.n)))
        return s->p->state.at[sm_truncate_u32(e->number) - 1];
    return e->kind == AST_NAME ? map_find(&s->p->state_by_name, e->name) : NULL;
}

// Reports S = Vent, and state = Vent if no variable is named `state`.  Returns whether it reported one.
static bool report_state_assignment(Sema *s, const Var *v, const AstStmt *in)
{
    const bool may_mean = !s->in_script && (v ? v == s->p->s : in->value->kind == AST_NAME && !scope_find_variable(s, in->value->name));
    const State *to = may_mean ? state_named_by(s, in->value) : NULL;
    Diag *d;

    if (!to)
        return false;
    if (v)
        d = diag_report(s->diags, DIAG_write_state_element, in->name_span, in->name->text);
    else
        d = diag_report(s->diags, DIAG_unknown_element, in->name_span, in->name->text);
    diag_label(s->diags, d, DIAG_label_go_to, to->name->text, to->name->text);
    return true;
}

// Warns of x = 0/0 in a script: it is meant to simulate a broken sensor but stores 0 (language.md 2.14).  In machines an analysis reports
// it.
static void warn_of_nan(Sema *s, const Var *v, const Expr *value)
{
    if (expr_is_constant(value) && sm_is_nan(expr_constant_value(value)))
        diag_report(s->diags, DIAG_stores_nan, value->span, v->name->text);
}

static void warn_of_read_only_local(Sema *s, const Var *v, const AstStmt *in)
{
    Diag *d;

    if (!s->in_script || v->kind != VAR_LOCAL || !v->read_only || map_find(&s->remarked, in->name))
        return;
    map_put(&s->remarked, in->name, (void *)in->name);
    d = diag_report(s->diags, DIAG_script_writes_constant, in->name_span, in->name->text);
    scope_note_declared(s, d, in->name);
    diag_about(s->diags, d, DIAG_CONSTANT, v->span);
}

Stmt *check_assignment(Sema *s, const AstStmt *in)
{
    Var *v = scope_find_variable(s, in->name);
    Stmt *out = stmt_new(s, ST_ASSIGN, in);
    bool good = false;

    if (report_state_assignment(s, v, in))
        return NULL;
    if (!v)
        scope_report_unknown(s, in->name, in->name_span);
    else
        good = check_writable(s, v, in->name, in->name_span);
    if (good)
        warn_of_read_only_local(s, v, in);
    if (v && !s->in_script)
        v->written = true;
    s->knows_a_name |= v != NULL;
    out->var = v;
    check_value(s, in, out);
    if (good && s->in_script && out->value)
        warn_of_nan(s, v, out->value);
    return good && out->value ? out : NULL;
}

// ---- transitions ----

static Stmt *check_transition(Sema *s, const AstStmt *in)
{
    Stmt *out = stmt_new(s, ST_TRANSITION, in);

    out->target = scope_find_state(s, in->name, in->name_span);
    if (s->block == BLOCK_EXIT) {
        diag_report(s->diags, DIAG_transition_in_exit, in->span);
        return NULL;
    }
    return out->target ? out : NULL;
}

// ---- conditionals ----

static void warn_of_empty_braces(Sema *s, const AstStmt *in)
{
    if (in->arms->braces && in->arms->then.n == 0)
        diag_report(s->diags, DIAG_empty_braces, in->arms->body_span);
    if (in->arms->has_else && in->arms->else_braces && in->arms->otherwise.n == 0)
        diag_report(s->diags, DIAG_empty_braces, in->arms->else_body_span);
}

static Stmt *check_if(Sema *s, const AstStmt *in)
{
    Stmt *out = stmt_new(s, ST_IF, in);
    size_t met = s->diags->met;

    warn_of_empty_braces(s, in);
    check_value(s, in, out);
    if (in->value->alone && s->diags->met == met)
        diag_label(s->diags, diag_report(s->diags, DIAG_no_effect, in->value->span), DIAG_label_statements);
    check_stmts(s, &in->arms->then, &out->then);
    check_stmts(s, &in->arms->otherwise, &out->otherwise);
    return out->value ? out : NULL;
}

static Stmt *check_stmt(Sema *s, const AstStmt *in)
{
    switch (in->kind) {
    case AST_ASSIGN:     return check_assignment(s, in);
    case AST_TRANSITION: return check_transition(s, in);
    case AST_IF:         return check_if(s, in);
    case AST_ASSERT: case AST_STOP: case AST_STMT_ERROR: case AST_ALLOWED: break;     // the parser has reported them
    }
    return NULL;
}

// ---- lists ----

// Whether a brace is missing, so that the checker does not know which statements belong together.
static bool are_braces_unbalanced(const Diags *diags)
{
    for (size_t i = 0; i < diags->list.n; i++)
        if (diags->list.at[i]->code == DIAG_brace_unclosed || diags->list.at[i]->code == DIAG_stray_brace)
            return true;
    return false;
}

static void warn_of_unreachable_statement(Sema *s, const AstStmt *transition, const AstStmt *next)
{
    Diag *d;

    if (are_braces_unbalanced(s->diags))
        return;
    d = diag_report(s->diags, DIAG_after_transition, next->span);
    diag_note(s->diags, d, transition->span, DIAG_note_transition_here);
}

// Applies the @allow annotations directly before statement i.
static void apply_allows(Sema *s, const AstStmts *in, size_t i)
{
    for (size_t k = i; s->building && k-- > 0 && in->at[k]->kind == AST_ALLOWED; )
        add_stmt_allow(s, in->at[k]->allow, in->at[i]);
}

void check_stmts(Sema *s, const AstStmts *in, Stmts *out)
{
    const AstStmt *before = NULL;
    bool is_warned = false;

    for (size_t i = 0; i < in->n; i++) {
        Stmt *stmt;
        if (in->at[i]->kind == AST_ALLOWED)
            continue;
        if ((stmt = check_stmt(s, in->at[i])) != NULL)
            vec_push(s->arena, out, stmt);
        apply_allows(s, in, i);
        if (before && before->kind == AST_TRANSITION && !before->flawed && !is_warned) {
            warn_of_unreachable_statement(s, before, in->at[i]);
            is_warned = true;
        }
        before = in->at[i];
    }
}
