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
bool hint_are_adjacent(const Token *a, const Token *b);      // no space is between them
bool hint_begins_value(const Token *t);
// Whether the text from the current token to the line end contains a : or a {, or the next line begins with a {: it is then a guard. A
// line end inside parentheses does not count.
bool hint_line_is_guard(const Parser *p);

bool hint_is_and_then(const Parser *p);                 // at the `and` of x = 1 and then -> Idle, which joins two statements

// ---- diagnostics that several rules share ----

void hint_replace_word(Parser *p, const char *native, TokenKind kind);  // reports a foreign word and turns it into a token of that kind
// Reports the = or =! at `sign` in a condition, and suggests == or !=. `left`: its left operand, or NULL.
void hint_report_assign_in_guard(Parser *p, const AstExpr *left, Span sign);
// Labels d: the statement that ended before `at` shares its line with another. Returns false if no statement ended there.
bool hint_label_line_sharing(Parser *p, Diag *d, uint32_t at);

#endif
