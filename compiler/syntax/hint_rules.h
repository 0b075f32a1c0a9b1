// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the hints for the parser: hint_search.c (search), hint_expr.c (expressions), hint_stmt.c (statements),
// hint_end.c (text after a statement, declarations).
#ifndef SMC_HINT_RULES_H
#define SMC_HINT_RULES_H

#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

// One call of hint_explain.
typedef struct HintCase {
    Parser *p;
    HintContext context;
    AstExpr *e;               // what precedes the error: a name, a left operand, a condition; or NULL
    Diag *general;            // the general diagnostic of the context; NULL until it is reported
} HintCase;

// Reports the general diagnostic of the context when it is first called, and returns it; NULL if the context has none. The caller can add
// labels, notes and edits.
Diag *hint_report_general(HintCase *c);

// The rules that rows of hints.def name. Each returns HINT_NONE, and reports nothing, if the text is something else.
#define HINT(context, before, here, word, after, rule) HintResult hint_##rule(HintCase *c);
#include "compiler/syntax/hints.def"

// ---- tokens ----

bool hint_is_word(const Token *t, const char *lower);   // a name that is this word, in upper or lower case
bool hint_is_label(const char *word);                   // entry, step, exit
bool hint_are_adjacent(const Token *a, const Token *b);      // the two are adjacent
bool hint_begins_value(const Token *t);
// Whether this is a guard: its line, which continues inside parentheses, contains a : or a {; or the next line has a {.
bool hint_line_is_guard(const Parser *p);

bool hint_is_and_then(const Parser *p);                 // x = 1 and then -> Idle, at `and`: no expression continues like this

// ---- diagnostics that several rules share ----

void hint_replace_word(Parser *p, const char *native, TokenKind kind);  // reports a foreign word and turns it into a token of that kind
// Reports the = of a condition, whose left operand may be NULL. `=!` was meant as `!=`, or as `=` and a negation.
void hint_report_assign_in_guard(Parser *p, const AstExpr *left, Span sign);
// Labels d: the statement that ended before `at` shares its line with another. Returns false if no statement ended there.
bool hint_report_line_sharing(Parser *p, Diag *d, uint32_t at);

#endif
