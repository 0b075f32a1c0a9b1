// SPDX-License-Identifier: Apache-2.0
// A transition to an @abort state directly below a one-line conditional may have been meant to depend on it:
//
//     p > 50: code = 1
//     -> Abort
//
// It is the layout that raises the question, so this works on the tree as written.  No question is asked where the layout or the
// statements say that the transition is meant for every case:
//   - the state is an @abort state itself, or consists of an .entry alone: it passes the machine on;
//   - another line, empty or a comment, comes between them;
//   - the conditional goes elsewhere itself, or has an else: what is left over aborts, or every case has been dealt with;
//   - what it assigns has been assigned before in the block: the lines classify, and then the machine aborts.
// A transition that is indented more than the conditional is asked about in any case.
#include "compiler/sema/sema.h"

static uint32_t line_of(Span span) { return source_position(span.src, span.at).line; }

static uint32_t column_of(Span span) { return source_position(span.src, span.at).col; }

// The statement that a conditional ends with if that is on its line; NULL: it ends with braces.
static const AstStmt *last_on_line(const AstStmt *s)
{
    while (s && s->kind == AST_IF) {
        const AstStmts *body = s->arms->has_else ? &s->arms->otherwise : &s->arms->then;
        if ((s->arms->has_else ? s->arms->else_braces : s->arms->braces) || body->n != 1)
            return NULL;
        s = body->at[0];
    }
    return s;
}

static bool ends_with_else(const AstStmt *s)
{
    while (s->kind == AST_IF && s->arms->has_else) {
        if (s->arms->otherwise.n != 1 || s->arms->otherwise.at[0]->kind != AST_IF)
            return true;
        s = s->arms->otherwise.at[0];
    }
    return false;
}

static bool assigns(const AstStmts *list, Str name, const AstStmt *but);

static bool stmt_assigns(const AstStmt *s, Str name, const AstStmt *but)
{
    if (s->kind == AST_ASSIGN)
        return s != but && s->name == name;
    return s->kind == AST_IF && (assigns(&s->arms->then, name, but) || assigns(&s->arms->otherwise, name, but));
}

// As deep as conditionals nest: AST_DEPTH_MAX bounds it.
static bool assigns(const AstStmts *list, Str name, const AstStmt *but)
{
    for (size_t i = 0; i < list->n; i++)
        if (stmt_assigns(list->at[i], name, but))
            return true;
    return false;
}

static bool is_meant(const AstStmts *in, const AstStmt *above, const AstStmt *last, const AstStmt *transition)
{
    if (column_of(transition->span) > column_of(above->span))
        return false;
    if (ends_with_else(above))
        return true;
    for (size_t k = 0; in->at[k] != transition; k++)
        if (stmt_assigns(in->at[k], last->name, last))
            return true;
    return false;
}

// What comes before statement i; NULL: nothing does.
static const AstStmt *statement_above(const AstStmts *in, size_t i)
{
    while (i > 0 && in->at[i - 1]->kind == AST_ALLOWED)
        i--;
    return i > 0 ? in->at[i - 1] : NULL;
}

static void ask(Sema *s, const AstStmt *above, const AstStmt *transition)
{
    const char *guard = sema_quote(s, above->value->span), *state = transition->name->text;
    Diag *d = diag_report(s->diags, DIAG_unguarded_abort, transition->span, state);

    diag_note(s->diags, d, above->span, DIAG_note_not_guarded, state, guard);
    diag_note(s->diags, d, (Span){0}, DIAG_note_perhaps_guarded, ends_with_else(above) ? "else" : guard);
    diag_note(s->diags, d, (Span){0}, DIAG_note_in_every_case, state);
}

static bool passes_on(const State *state, const AstSection *section)
{
    return state->is_abort || !section->block[AST_STEP].present;
}

void warn_of_unguarded_abort(Sema *s, const State *state, const AstSection *section, AstLabel label)
{
    const AstStmts *in = &section->block[label].stmts;

    if (label == AST_EXIT || passes_on(state, section))
        return;
    for (size_t i = 0; i < in->n; i++) {
        const AstStmt *above = statement_above(in, i), *transition = in->at[i], *last = last_on_line(above);
        const State *to = transition->kind == AST_TRANSITION ? map_find(&s->p->state_by_name, transition->name) : NULL;
        if (to && to->is_abort && last && last != above && last->kind == AST_ASSIGN && !above->flawed && !transition->flawed &&
            line_of(transition->span) == line_of(last->span) + 1 && !is_meant(in, above, last, transition))
            ask(s, above, transition);
    }
}
