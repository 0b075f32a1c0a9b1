// SPDX-License-Identifier: Apache-2.0
// Parts without any effect on what the machine shows or decides: elements that are listed but never used, locals that only they
// themselves need, rolling statistics that feed only such parts.  Also locals that never change, which are constants.
//
// A transition and an assignment to an element have an effect, and so does every guard around them.  The search goes backwards
// from there.  If a local is needed, so is every assignment to it, with its guards.  If a statistic is needed, so is its
// sample.
#include "compiler/analysis/analysis.h"

// ---- needed variables ----

typedef struct Place Place;
struct Place {                    // of an assignment
    const Stmt *stmt;
    const Condition *when;
    const Place *next;            // of the same variable
};

typedef struct Needs {
    Analysis *a;
    bool everywhere;              // statements that are never executed count too
    bool *var, *window;           // by Var.index; by index of the window: it is needed
    bool *guard;                  // by Stmt.number: the guard is needed
    const Place **place;          // by Var.index: its assignments
    VEC(const Var *) waiting;     // needed, but their assignments are not yet visited
} Needs;

static void need_expr(Needs *n, const Expr *e)
{
    const Var *v = e->var;

    if (e->kind == EX_VAR && !n->var[v->index]) {
        n->var[v->index] = true;
        vec_push(n->a->arena, &n->waiting, v);
    }
    if (e->kind == EX_ROLL)
        n->window[e->window] = true;
    for (uint32_t i = 0; i < e->n; i++)
        need_expr(n, e->arg[i]);
}

static void need_guards(Needs *n, const Condition *when)
{
    for (; when && !n->guard[when->stmt->number]; when = when->outer) {
        n->guard[when->stmt->number] = true;
        need_expr(n, when->stmt->value);
    }
}

// A transition, or an assignment that is visible outside. (A conditional without statements has its own warning.)
static bool has_effect(const Stmt *stmt)
{
    switch (stmt->kind) {
    case ST_TRANSITION: return true;
    case ST_ASSIGN: return stmt->var->kind != VAR_LOCAL;
    case ST_IF: return stmt->then.n == 0 && stmt->otherwise.n == 0;
    }
    return true;
}

static void need_stmt(Needs *n, const Stmt *stmt, const Condition *when)
{
    need_guards(n, when);
    if (stmt->value)
        need_expr(n, stmt->value);
}

static void look_at_stmts(Needs *n, const Stmts *stmts, const Condition *when);

static void look_under(Needs *n, const Stmts *stmts, const Stmt *stmt, bool holds, const Condition *outer)
{
    Condition *c;

    if (stmts->n == 0)
        return;
    c = ARENA_NEW(n->a->arena, Condition);
    *c = (Condition){stmt, holds, outer};
    look_at_stmts(n, stmts, c);
}

static void note_place(Needs *n, const Stmt *stmt, const Condition *when)
{
    Place *p = ARENA_NEW(n->a->arena, Place);

    *p = (Place){stmt, when, n->place[stmt->var->index]};
    n->place[stmt->var->index] = p;
}

// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.  If only executed statements count, every
// guard counts: an always decided guard has its own finding.
static void look_at_stmts(Needs *n, const Stmts *stmts, const Condition *when)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (!n->everywhere && !n->a->stmt[stmt->number].reached)
            continue;
        if (has_effect(stmt) || (stmt->kind == ST_IF && !n->everywhere))
            need_stmt(n, stmt, when);
        else if (stmt->kind == ST_ASSIGN)
            note_place(n, stmt, when);
        look_under(n, &stmt->then, stmt, true, when);
        look_under(n, &stmt->otherwise, stmt, false, when);
    }
}

static void need_feeders(Needs *n)
{
    while (n->waiting.n > 0) {
        const Var *v = n->waiting.at[--n->waiting.n];
        for (const Place *p = n->place[v->index]; p; p = p->next)
            need_stmt(n, p->stmt, p->when);
    }
}

static Needs needs_of(Analysis *a, bool everywhere)
{
    const Program *p = a->p;
    Needs n = {.a = a, .everywhere = everywhere};

    n.var = ARENA_ARRAY(a->arena, bool, p->var.n);
    n.window = ARENA_ARRAY(a->arena, bool, p->window.n);
    n.guard = ARENA_ARRAY(a->arena, bool, p->stmts + 1u);
    n.place = ARENA_ARRAY(a->arena, const Place *, p->var.n);
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            look_at_stmts(&n, &p->state.at[s]->block[b], NULL);
    need_feeders(&n);
    return n;
}

// ---- variables ----

// G and S are used even if the machine does not name them.
static void look_at_element(Analysis *a, const Var *v)
{
    if (!v->read && !v->written && v != a->p->g && v != a->p->s)
        diag_report(a->diags, DIAG_unused_element, v->span, v->name->text);
}

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Inserts @read_only after the declaration of a local.  It must follow the last ')' of the initial value, because the span of
// an expression does not include the parentheses around it.
static void mark_read_only(Diags *diags, Diag *d, const Var *local)
{
    const Source *src = local->span.src;
    Span span = {src, local->init_value->span.at + local->init_value->span.len, 0};
    uint32_t at = span.at;

    while (at < src->len && (is_blank(src->text[at]) || src->text[at] == '\n' || src->text[at] == '#' || src->text[at] == ')')) {
        if (src->text[at] == '#')
            while (at < src->len && src->text[at] != '\n')
                at++;
        else if (src->text[at++] == ')')
            span.at = at;
    }
    diag_edit(diags, d, span, " @read_only");
}

static void report_never_written(Analysis *a, const Var *v)
{
    Diag *d = diag_report(a->diags, DIAG_never_written, v->span, v->name->text);

    mark_read_only(a->diags, d, v);
}

// Read and written, but perhaps only by its own assignments.
static bool may_feed_itself(const Var *v)
{
    return v->kind == VAR_LOCAL && !v->read_only && v->read && v->written;
}

static void look_at_local(Analysis *a, const Var *v, bool needed)
{
    if (!v->read)
        diag_report(a->diags, v->written ? DIAG_unread_local : DIAG_unused_local, v->span, v->name->text);
    else if (!v->read_only && !v->written)
        report_never_written(a, v);
    else if (may_feed_itself(v) && !needed)
        diag_report(a->diags, DIAG_feeds_itself, v->span, v->name->text);
}

static void need_var(Expr *e, void *context)
{
    bool *needed = context;

    if (e->kind == EX_VAR)
        needed[e->var->index] = true;
}

// Initial values and window sizes need the variables that they read.
static void need_constants(const Program *p, bool *needed)
{
    for (size_t i = 0; i < p->var.n; i++) {
        needed[i] |= p->var.at[i]->sizes;
        if (p->var.at[i]->init_value)
            expr_walk(p->var.at[i]->init_value, need_var, needed);
    }
}

static void look_at_window(Analysis *a, const Window *w, bool needed, bool executed)
{
    if (!needed)
        diag_report(a->diags, DIAG_unused_window, w->span, "nothing depends on what it feeds");
    else if (!executed)
        diag_report(a->diags, DIAG_unused_window, w->span, "what uses it is never executed");
}

static void look_at_windows(Analysis *a, const Needs *all)
{
    const Needs executed = needs_of(a, false);

    for (size_t i = 0; i < a->p->window.n; i++)
        look_at_window(a, &a->p->window.at[i], all->window[i], executed.window[i]);
}

void analyse_unused(Analysis *a)
{
    const Program *p = a->p;
    bool asked = p->window.n > 0;                      // whether the needed set is used at all: computing it visits the whole program
    Needs all = {.var = NULL};

    for (size_t i = 0; i < p->var.n; i++)
        asked |= may_feed_itself(p->var.at[i]);
    if (asked) {
        all = needs_of(a, true);
        need_constants(p, all.var);
    }
    if (p->window.n > 0)
        look_at_windows(a, &all);
    for (size_t i = 0; i < p->var.n; i++)
        switch (p->var.at[i]->kind) {
        case VAR_ELEMENT: look_at_element(a, p->var.at[i]); break;
        case VAR_LOCAL:   look_at_local(a, p->var.at[i], !asked || all.var[i]); break;
        case VAR_TIME:    break;
        }
}
