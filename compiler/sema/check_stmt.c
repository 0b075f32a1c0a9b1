// SPDX-License-Identifier: Apache-2.0
// Checks statements (language.md 5): which variables they assign, where transitions appear and lead, what can never run.  Recursion
// depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.  Functions that return a Stmt return NULL after an error, which is
// reported.
#include "compiler/sema/sema.h"

static Stmt *stmt_new(Sema *s, StmtKind kind, const AstStmt *in)
{
    Stmt *out = ARENA_NEW(s->arena, Stmt);

    out->kind = kind;
    out->number = ++s->stmts;
    out->span = sema_span(s, in->span);
    return out;
}

// Checks the assigned value, and records in `out` which operators it contains and whether it varies.
static void check_value(Sema *s, const AstStmt *in, Stmt *out)
{
    s->operators = 0;
    s->varies = false;
    out->value = check_expr(s, in->value);
    out->operators = s->operators;
    out->varies = s->varies;
}

// ---- assignments ----

// Returns whether a statement can assign v, and reports the assignment if not.  G, S and T can never be assigned.  Other variables marked
// @read_only can only be assigned by a script, unless they are its own.
static bool check_writable(Sema *s, const Var *v, Str name, Span span)
{
    bool never_assigned = v == s->p->g || v->state_of || v->kind == VAR_TIME || v->of_script;
    Diag *d;

    if (scope_is_doubtful(s, name))
        return false;
    if (v->parameter) {
        report_parameter_assigned(s, v, name, span);
        return false;
    }
    if (!v->read_only || (s->in_script && !never_assigned))
        return true;
    if (v->kind == VAR_TIME) {
        d = diag_report(s->diags, DIAG_write_time, span);
        diag_label(s->diags, d, DIAG_label_other_time);
    } else if (v == s->p->g) {
        d = diag_report(s->diags, DIAG_write_global_time, span, name->text);
    } else if (v->state_of) {
        d = diag_report(s->diags, DIAG_write_state_element, span, name->text);
        diag_label(s->diags, d, s->in_script ? DIAG_label_first_state : DIAG_label_change_state);
    } else if (v->kind == VAR_LOCAL) {
        d = diag_report(s->diags, DIAG_write_constant, span, name->text);
        diag_label(s->diags, d, DIAG_label_written_constant);
    } else {
        d = diag_report(s->diags, DIAG_write_read_only, span, name->text);
        diag_label(s->diags, d, DIAG_label_written_input);
    }
    scope_note_declared(s, d, name);
    return false;
}

// Returns the state that the value of `S = Vent` or `S = 2` refers to; NULL if no state is meant.
static const State *state_named_by(const Sema *s, const AstExpr *e)
{
    if (e->kind == AST_NUMBER && sm_le(sm_from_i32(1), e->number) && sm_le(e->number, sm_from_u32((uint32_t)s->p->state.n)))
        return s->p->state.at[sm_truncate_u32(e->number) - 1];
    return e->kind == AST_NAME ? map_find(&s->p->state_by_name, e->name) : NULL;
}

// Reports an assignment such as `S = Vent`, or `state = Vent` if no variable is named `state`: the user wants a transition to Vent.
// Returns false if the statement is no such assignment.
static bool report_state_assignment(Sema *s, const Var *v, const AstStmt *in)
{
    const bool may_mean = v ? v == s->p->s && !s->in_script : in->value->kind == AST_NAME && !scope_find_variable(s, in->value->name);
    const State *to = may_mean ? state_named_by(s, in->value) : NULL;
    Diag *d;

    if (!to)
        return false;
    if (v)
        d = diag_report(s->diags, DIAG_write_state_element, in->name_span, in->name->text);
    else
        d = diag_report(s->diags, DIAG_unknown_element, in->name_span, in->name->text);
    if (s->in_script)
        diag_label(s->diags, d, DIAG_label_first_state);
    else
        diag_label(s->diags, d, DIAG_label_go_to, to->name->text, to->name->text);
    return true;
}

// Warns of a script that writes a read-only local, because the local never changes in flight.  Warns once for each name.
static void warn_of_read_only_local(Sema *s, const Var *v, Str name, Span span)
{
    Diag *d;

    if (!s->in_script || v->kind != VAR_LOCAL || !v->read_only || map_find(&s->remarked, name))
        return;
    map_put(&s->remarked, name, (void *)name);
    d = diag_report(s->diags, DIAG_script_writes_constant, span, name->text);
    scope_note_declared(s, d, name);
    diag_note_declaration(s->diags, d, DIAG_CONSTANT, v->span);
}

// Returns the variable that a statement assigns; NULL after a report.
Var *check_target(Sema *s, Str name, Span span)
{
    Var *v = scope_find_variable(s, name);

    s->knows_a_name |= v != NULL;
    if (!v && map_find(&s->defines, name))
        scope_note_declared(s, diag_report(s->diags, DIAG_write_definition, span, name->text), name);
    else if (!v)
        scope_report_unknown(s, name, span);
    if (!v || !check_writable(s, v, name, span))
        return NULL;
    warn_of_read_only_local(s, v, name, span);
    return v;
}

// Whether other languages store the state in a variable with this name, as in `state = HOLD`.
static bool is_name_for_states(const char *name)
{
    return strcmp(name, "state") == 0 || strcmp(name, "State") == 0 || strcmp(name, "STATE") == 0;
}

bool check_assignment(Sema *s, const AstStmt *in, Stmt *out)
{
    Var *v = scope_find_variable(s, in->name);
    size_t before;
    bool good;

    if (report_state_assignment(s, v, in))
        return false;
    good = check_target(s, in->name, in->name_span) != NULL;
    if (v && !s->in_script)
        v->written = true;
    out->var = v;
    if (!good && v == s->p->s && state_named_by(s, in->value))         // `S = Vent` is reported; the value would be reported as well
        return false;
    before = s->diags->list.n;
    check_value(s, in, out);
    for (size_t i = before; i < s->diags->list.n && !v && is_name_for_states(in->name->text); i++)
        s->diags->list.at[i]->follows = true;                          // state = HOLD
    // A script that assigns 0/0 is meant to simulate a broken sensor but stores 0 (language.md 2.14).  In machines an analysis reports it.
    if (good && s->in_script && out->value && expr_is_constant(out->value) && sm_is_nan(expr_constant_value(out->value)))
        diag_label(s->diags, diag_report(s->diags, DIAG_stores_nan, out->value->span, v->name->text), DIAG_label_write_zero);
    return good && out->value;
}

static Stmt *check_machine_assignment(Sema *s, const AstStmt *in)
{
    Stmt *out = stmt_new(s, ST_ASSIGN, in);

    return check_assignment(s, in, out) ? out : NULL;
}

// ---- transitions ----

static Stmt *check_transition(Sema *s, const AstStmt *in)
{
    Stmt *out = stmt_new(s, ST_TRANSITION, in);

    out->target = scope_find_state(s, s->p, in->name, in->name_span);
    if (s->block == BLOCK_EXIT) {
        diag_report(s->diags, DIAG_transition_in_exit, in->span);
        return NULL;
    }
    if (!out->target)
        return NULL;
    check_target_is_excepted(s, in, out->target);
    return out;
}

// ---- conditionals ----

// Reports a call such as `transition(Vent)` alone on its line: the user wants a transition to Vent.  Returns false if it is no such call.
static bool report_call_with_state(Sema *s, const AstExpr *e)
{
    const AstExpr *argument = e->kind == AST_CALL && e->args->n == 1 ? e->args->at[0] : NULL;
    Diag *d;

    if (!e->alone || !argument || scope_find_function(s, e->name) || scope_find_variable(s, e->name) || argument->kind != AST_NAME ||
        scope_find_variable(s, argument->name) || !map_find(&s->p->state_by_name, argument->name))
        return false;
    d = diag_report(s->diags, DIAG_unknown_function, ast_op_span(e), e->name->text);
    diag_label(s->diags, d, DIAG_label_go_to, argument->name->text, argument->name->text);
    return true;
}

static Stmt *check_if(Sema *s, const AstStmt *in)
{
    Stmt *out = stmt_new(s, ST_IF, in);
    size_t before = s->diags->errors_seen;

    if (report_call_with_state(s, in->value))
        return NULL;
    if (in->arms->braces && in->arms->then.n == 0)
        diag_report(s->diags, DIAG_empty_braces, in->arms->body_span);
    if (in->arms->has_else && in->arms->else_braces && in->arms->otherwise.n == 0)
        diag_report(s->diags, DIAG_empty_braces, in->arms->else_body_span);
    warn_of_time_as_guard(s, in->value);
    check_value(s, in, out);
    if (in->value->alone && s->diags->errors_seen == before)
        diag_label(s->diags, diag_report(s->diags, DIAG_no_effect, in->value->span), DIAG_label_statements);
    check_stmts(s, &in->arms->then, &out->then);
    check_stmts(s, &in->arms->otherwise, &out->otherwise);
    return out->value ? out : NULL;
}

// ---- lists ----

// Warns of `next`, a statement directly after a transition, which can never run.  Does not warn if a brace is missing, because then the
// checker does not know which statements belong together.
static void warn_of_unreachable_statement(Sema *s, const AstStmt *transition, const AstStmt *next)
{
    Diag *d;

    for (size_t i = 0; i < s->diags->list.n; i++) {
        const DiagCode code = s->diags->list.at[i]->code;
        if (code == DIAG_brace_unclosed || code == DIAG_stray_brace)
            return;
    }
    d = diag_report(s->diags, DIAG_after_transition, next->span);
    diag_note(s->diags, d, transition->span, DIAG_note_transition_here);
}

void check_stmts(Sema *s, const AstStmts *in, Stmts *out)
{
    const bool is_repeated = s->all_states && s->all_states->copies > 0;           // the statements have been checked for another state
    const AstStmt *before = NULL;
    bool is_warned = false;

    for (size_t i = 0; i < in->n; i++) {
        Stmt *stmt = NULL;
        switch (in->at[i]->kind) {
        case AST_ALLOWED:    continue;
        case AST_ASSIGN:     stmt = check_machine_assignment(s, in->at[i]); break;
        case AST_TRANSITION: stmt = check_transition(s, in->at[i]); break;
        case AST_IF:         stmt = check_if(s, in->at[i]); break;
        case AST_ASSERT: case AST_FAIL: case AST_EXPECT: case AST_PRINT: case AST_STOP: case AST_STMT_ERROR: break;       // the parser has reported them
        }
        if (stmt)
            vec_push(s->arena, out, stmt);
        for (size_t k = i; s->building && !is_repeated && k-- > 0 && in->at[k]->kind == AST_ALLOWED; )       // the @allow lines just before it
            add_stmt_allow(s, in->at[k]->allow, in->at[i]);
        if (in->at[i]->marks && s->building && !is_repeated)
            add_stmt_marks(s, in->at[i], stmt);
        if (before && before->kind == AST_TRANSITION && !before->flawed && !is_warned) {
            warn_of_unreachable_statement(s, before, in->at[i]);
            is_warned = true;
        }
        before = in->at[i];
    }
}
