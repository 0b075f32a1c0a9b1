// SPDX-License-Identifier: Apache-2.0
// Reports parts that affect neither an element nor a transition: elements that are listed but never used, locals that only their own
// assignments read, rolling statistics that only such parts use.  Also reports locals that never change, which are constants.
//
// Transitions, assignments to elements, and the guards around both are needed.  The search goes backwards from these.  If a local is
// needed, every assignment to it is needed, with the guards around it.  If a statistic is needed, its sample is needed.
#include "compiler/analysis/analysis.h"

// ---- needed variables ----

typedef struct StoreSite StoreSite;
struct StoreSite {                // an assignment and the conditions around it
    const Stmt *stmt;
    const Condition *when;
    const StoreSite *next;        // the next assignment to the same variable
};

typedef struct NeededParts {
    Analysis *a;
    bool everywhere;              // the search also visits statements that are never executed
    bool *var, *window;           // by Var.index: the variable is needed; by index of a window: the window is needed
    bool *guard;                  // by Stmt.number: the guard is needed
    const StoreSite **site;       // by Var.index: list of the assignments to the variable
    VEC(const Var *) waiting;     // needed variables whose assignments are not yet visited
} NeededParts;

static void mark_expr_needed(NeededParts *n, const Expr *e)
{
    const Var *v = e->var;

    if (e->kind == EX_VAR && !n->var[v->index]) {
        n->var[v->index] = true;
        vec_push(n->a->arena, &n->waiting, v);
    }
    if (e->kind == EX_ROLL)
        n->window[e->window] = true;
    for (uint32_t i = 0; i < e->n; i++)
        mark_expr_needed(n, e->arg[i]);
}

// Whether stmt is a transition or an assignment to an element.  Also true for a conditional without statements, which another warning
// reports.
static bool has_effect(const Stmt *stmt)
{
    switch (stmt->kind) {
    case ST_TRANSITION: return true;
    case ST_ASSIGN: return stmt->var->kind != VAR_LOCAL;
    case ST_IF: return stmt->then.n == 0 && stmt->otherwise.n == 0;
    }
    return true;
}

// Marks as needed what a statement and the guards around it read.
static void mark_stmt_needed(NeededParts *n, const Stmt *stmt, const Condition *when)
{
    for (; when && !n->guard[when->stmt->number]; when = when->outer) {
        n->guard[when->stmt->number] = true;
        mark_expr_needed(n, when->stmt->value);
    }
    if (stmt->value)
        mark_expr_needed(n, stmt->value);
}

// Marks what statements with an effect need, and lists the other assignments in n->site.  Without `everywhere`, every executed guard
// counts as needed, because another finding reports guards that decide nothing.
// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void mark_needed_in_stmts(NeededParts *n, const Stmts *stmts, const Condition *when)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (!n->everywhere && !n->a->stmt[stmt->number].reached)
            continue;
        if (has_effect(stmt) || (stmt->kind == ST_IF && !n->everywhere)) {
            mark_stmt_needed(n, stmt, when);
        } else if (stmt->kind == ST_ASSIGN) {
            StoreSite *site = ARENA_NEW(n->a->arena, StoreSite);
            *site = (StoreSite){stmt, when, n->site[stmt->var->index]};
            n->site[stmt->var->index] = site;
        }
        for (int holds = 1; holds >= 0; holds--) {
            const Stmts *branch = holds ? &stmt->then : &stmt->otherwise;
            Condition *c;
            if (branch->n == 0)
                continue;
            c = ARENA_NEW(n->a->arena, Condition);
            *c = (Condition){stmt, holds, when};
            mark_needed_in_stmts(n, branch, c);
        }
    }
}

// Finds the variables, windows and guards on which an output of the machine depends.
static NeededParts find_needed_parts(Analysis *a, bool everywhere)
{
    const Program *p = a->p;
    NeededParts n = {.a = a, .everywhere = everywhere};

    n.var = ARENA_ARRAY(a->arena, bool, p->var.n);
    n.window = ARENA_ARRAY(a->arena, bool, p->window.n);
    n.guard = ARENA_ARRAY(a->arena, bool, p->stmts + 1u);
    n.site = ARENA_ARRAY(a->arena, const StoreSite *, p->var.n);
    for (size_t s = 0; s < p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++)
            mark_needed_in_stmts(&n, &p->state.at[s]->block[b], NULL);
    while (n.waiting.n > 0) {
        const Var *v = n.waiting.at[--n.waiting.n];
        for (const StoreSite *site = n.site[v->index]; site; site = site->next)
            mark_stmt_needed(&n, site->stmt, site->when);
    }
    return n;
}

// ---- variables ----

// Proposes to insert @read_only after the declaration of a local.  It must follow the last ')' of the initial value, because the span
// of an expression does not include the parentheses around the expression.
static void insert_read_only(Diags *diags, Diag *d, const Var *local)
{
    const Source *src = local->span.src;
    Span span = {src, local->init_value->span.at + local->init_value->span.len, 0};
    bool comment = false;

    for (uint32_t at = span.at; at < src->len; at++) {
        const char c = src->text[at];
        if (comment)
            comment = c != '\n';
        else if (c == '#')
            comment = true;
        else if (c == ')')
            span.at = at + 1;
        else if (c != ' ' && c != '\t' && c != '\r' && c != '\n')
            break;
    }
    diag_edit(diags, d, span, " @read_only");
}

static void report_never_written(Diags *diags, const Var *v)
{
    Diag *d = diag_report(diags, DIAG_never_written, v->span, v->name->text);

    if (v->listed)                                     // @read_only would make the call an error
        diag_label(diags, d, DIAG_label_listed_constant);
    else
        insert_read_only(diags, d, v);
}

// Whether v is a local that is both read and written, so that it is possible that only its own assignments read it.
static bool may_feed_itself(const Var *v)
{
    return v->kind == VAR_LOCAL && !v->read_only && v->read && v->written;
}

static void check_local(Analysis *a, const Var *v, bool needed)
{
    if (!v->read)
        diag_report(a->diags, v->written ? DIAG_unread_local : DIAG_unused_local, v->span, v->name->text);
    else if (!v->read_only && !v->written)
        report_never_written(a->diags, v);
    else if (may_feed_itself(v) && !needed)
        diag_report(a->diags, DIAG_feeds_itself, v->span, v->name->text);
}

static void mark_if_var(Expr *e, void *context)
{
    bool *needed = context;

    if (e->kind == EX_VAR)
        needed[e->var->index] = true;
}

// Marks the variables that initial values and window sizes read.
static void mark_vars_of_constants(const Program *p, bool *needed)
{
    for (size_t i = 0; i < p->var.n; i++) {
        needed[i] |= p->var.at[i]->sizes;
        if (p->var.at[i]->init_value)
            expr_walk(p->var.at[i]->init_value, mark_if_var, needed);
    }
}

// Reports windows without an effect.  A call in [all_states] or in a definition has a window for each state and each use: the call is
// reported if none of these windows has an effect.
static void check_windows(Analysis *a, const NeededParts *all)
{
    const NeededParts executed = find_needed_parts(a, false);
    bool *is_live = ARENA_ARRAY(a->arena, bool, a->p->src->len + 1u), *is_needed = ARENA_ARRAY(a->arena, bool, a->p->src->len + 1u);   // by position

    for (size_t i = 0; i < a->p->window.n; i++) {
        const uint32_t at = a->p->window.at[i].span.at;
        is_needed[at] = is_needed[at] || all->window[i];
        is_live[at] = is_live[at] || (all->window[i] && executed.window[i]);
    }

    for (size_t i = 0; i < a->p->window.n; i++) {
        const Span span = a->p->window.at[i].span;
        if (a->p->window.at[i].stat == SM_STAT_ELAPSED)            // ELAPSED is a part of `held` or `rate`, whose own window is reported
            continue;
        if (!is_needed[span.at])
            diag_report(a->diags, DIAG_unused_window, span, "nothing depends on what it feeds");
        else if (!is_live[span.at])
            diag_report(a->diags, DIAG_unused_window, span, "what uses it is never executed");
    }
}

void analyse_unused(Analysis *a)
{
    const Program *p = a->p;
    bool wanted = p->window.n > 0;                     // whether the needed parts must be computed, which visits the whole program
    NeededParts all = {.var = NULL};

    for (size_t i = 0; i < p->var.n; i++)
        wanted |= may_feed_itself(p->var.at[i]);
    if (wanted) {
        all = find_needed_parts(a, true);
        mark_vars_of_constants(p, all.var);
    }
    if (p->window.n > 0)
        check_windows(a, &all);
    for (size_t i = 0; i < p->var.n; i++) {
        const Var *v = p->var.at[i];
        if (v->kind == VAR_LOCAL)
            check_local(a, v, !wanted || all.var[i]);
        else if (v->kind == VAR_ELEMENT && !v->read && !v->written && v != p->g && v != p->s)      // G and S are used in any machine
            diag_report(a->diags, DIAG_unused_element, v->span, v->name->text);
    }
}
