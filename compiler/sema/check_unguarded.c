// SPDX-License-Identifier: Apache-2.0
// Warns of an unconditional transition to an @abort state directly below a one-line conditional, if it may be meant as part of that
// conditional:
//
//     p > 50: code = 1
//     -> Abort
//
// Only the layout suggests this, so the check reads positions in the syntax tree.  It does not warn where the layout or the statements
// show that the transition is meant to be unconditional:
//   - the state is itself an @abort state, or has no .step block: the machine only passes through it;
//   - another line, empty or a comment, separates conditional and transition;
//   - the conditional itself contains a transition: the transition below handles the remaining cases;
//   - the conditional has an else, so it already handles every case;
//   - an earlier statement of the block assigns the same variable: the lines select a value, then the machine aborts.
// A transition that is indented more than the conditional is reported even after an else or an earlier assignment.
#include "compiler/sema/sema.h"

static uint32_t line_of(Span span) { return source_position(span.src, span.at).line; }

static uint32_t column_of(Span span) { return source_position(span.src, span.at).col; }

// Returns the last statement of a conditional; NULL if the conditional ends with a brace.
static const AstStmt *last_unbraced(const AstStmt *s)
{
    while (s && s->kind == AST_IF) {
        const AstStmts *body = s->arms->has_else ? &s->arms->otherwise : &s->arms->then;
        if ((s->arms->has_else ? s->arms->else_braces : s->arms->braces) || body->n != 1)
            return NULL;
        s = body->at[0];
    }
    return s;
}

// Whether the last branch of a conditional is an else without condition.
static bool ends_with_else(const AstStmt *s)
{
    while (s->kind == AST_IF && s->arms->has_else) {
        if (s->arms->otherwise.n != 1 || s->arms->otherwise.at[0]->kind != AST_IF)
            return true;
        s = s->arms->otherwise.at[0];
    }
    return false;
}

static bool list_assigns(const AstStmts *list, Str name, const AstStmt *but);

// Whether statement s, or a statement inside it, assigns `name`.  The assignment `but` does not count.
static bool stmt_assigns(const AstStmt *s, Str name, const AstStmt *but)
{
    if (s->kind == AST_ASSIGN)
        return s != but && s->name == name;
    return s->kind == AST_IF && (list_assigns(&s->arms->then, name, but) || list_assigns(&s->arms->otherwise, name, but));
}

// Whether a statement of the list, or one inside it, assigns `name`; like stmt_assigns.  Recursion depth equals the nesting of conditionals,
// which AST_DEPTH_MAX bounds.
static bool list_assigns(const AstStmts *list, Str name, const AstStmt *but)
{
    for (size_t i = 0; i < list->n; i++)
        if (stmt_assigns(list->at[i], name, but))
            return true;
    return false;
}

// Whether the layout or earlier statements show that the transition is unconditional (see above).
static bool is_intended(const AstStmts *in, const AstStmt *above, const AstStmt *last, const AstStmt *transition)
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

// Warns of an unconditional transition to an @abort state that the layout makes look conditional (check_unguarded.c).
void warn_of_unguarded_abort(Sema *s, const State *state, const AstSection *section, AstLabel label)
{
    const AstStmts *in = &section->block[label].stmts;
    const AstStmt *above = NULL;              // the statement before in->at[i], without annotations

    if (label == AST_EXIT)
        return;
    if (state->is_abort || !section->block[AST_STEP].present)         // the machine only passes through the state
        return;
    for (size_t i = 0; i < in->n; i++) {
        const AstStmt *transition = in->at[i], *last = last_unbraced(above);
        const State *to = transition->kind == AST_TRANSITION ? map_find(&s->p->state_by_name, transition->name) : NULL;
        if (to && to->is_abort && last && last != above && last->kind == AST_ASSIGN && !above->flawed && !transition->flawed &&
            line_of(transition->span) == line_of(last->span) + 1 && !is_intended(in, above, last, transition)) {
            const char *guard = sema_quote_source(s, above->value->span), *name = to->name->text;
            Diag *d = diag_report(s->diags, DIAG_unguarded_abort, transition->span, name);
            diag_note(s->diags, d, above->span, DIAG_note_not_guarded, name, guard);
            diag_note(s->diags, d, (Span){0}, DIAG_note_perhaps_guarded, ends_with_else(above) ? "else" : guard);
            diag_note(s->diags, d, (Span){0}, DIAG_note_in_every_case, name);
        }
        if (transition->kind != AST_ALLOWED)
            above = transition;
    }
}
