// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files with hints for the parser: hint_search.c searches hints.def; hint_expr.c (expressions), hint_stmt.c
// (statements), hint_end.c (text after a statement, declarations), hint_lists.c (lists and arrays), hint_when.c (times), hint_prose.c (verbs,
// durations), hint_type.c (types of other languages), hint_sign.c (signs such as ++), hint_definition.c and hint_requirement.c contain the rules;
// hint_block.c skips blocks of other languages.
#ifndef SMC_HINT_RULES_H
#define SMC_HINT_RULES_H

#include "compiler/syntax/hints.h"
#include "compiler/syntax/parser.h"

// One call of hint_explain.
typedef struct HintCase {
    Parser *p;
    HintContext context;
    AstExpr *e;               // the argument of hint_explain: the name, left operand or condition that precedes the error; or NULL
    Diag *general;            // the general diagnostic of the context; NULL until it is reported
} HintCase;

// Reports the general diagnostic of the context, such as "expected a value", unless that was done for this case already. Returns the
// diagnostic, so that the caller can add labels, notes and edits; NULL if the context has none.
Diag *hint_report_general(HintCase *c);

// The rules that rows of hints.def name. A rule returns HINT_NONE, and reports nothing, if it does not apply to the text.
#define HINT(context, before, here, word, after, rule) HintResult hint_##rule(HintCase *c);
#include "compiler/syntax/hints.def"

// ---- tokens ----

bool hint_is_word(const Token *t, const char *lower);   // whether t is a name that equals `lower`; case does not matter
bool hint_is_label(const char *word);                   // whether the word is entry, step or exit
bool hint_are_adjacent(const Token *a, const Token *b); // whether no space is between the tokens
bool hint_begins_value(const Token *t);
// Whether the current line is a guard: it contains a : or a { after the current token, or the next line begins with a {. A line end
// inside parentheses does not end the line.
bool hint_line_is_guard(const Parser *p);

bool hint_is_and_then(const Parser *p);                 // whether the current `and` joins two statements, as in x = 1 and then -> Idle

// ---- blocks of other languages ----

uint32_t hint_end_of_block(const Parser *p);            // the end of the block that the current word begins, in braces or indented; 0: unknown
void hint_skip_to(Parser *p, uint32_t end);             // skips the tokens before `end`, without reading those that are not read yet
void hint_skip_block(Parser *p);                        // skips that block, or the current word if its end is unknown
// Whether the text at `at` follows the statements of a condition whose missing braces are reported, as `elif` does in Python.
bool hint_follows_indented(const Parser *p, uint32_t at);

// ---- the rest of the line ----

// Returns the word or number after spaces at *at, and moves *at to its end; returns "" if neither follows.
const char *hint_read_word(const Parser *p, uint32_t *at);
const char *hint_read_value(const Parser *p, uint32_t *at);        // likewise, with the unit after a number if it is a time
const char *hint_read_equated(const Parser *p, uint32_t at);
// Returns the advice for `x > 5 for 3 s` and `x > 5 for 3 samples`. The current token is `for`; e is the condition.
const char *hint_format_held(const Parser *p, const AstExpr *e);

// ---- diagnostics that several rules share ----

// Labels d, which reports two names in a row, with what the prose means: close valve, k mod 2, c for 2 s. The first is e, the second the current
// token. Returns false if the meaning is unknown.
bool hint_label_prose(Parser *p, Diag *d, const AstExpr *e);

Diag *hint_replace_word(Parser *p, const char *native, TokenKind kind);   // reports a foreign word and turns it into a token of that kind
// Reports the = or =! at `sign` in a condition, and suggests == or !=. `left`: its left operand, or NULL.
void hint_report_assign_in_guard(Parser *p, const AstExpr *left, Span sign);
// Labels d with what to do about two statements on one line, of which the first ends before `at`. Returns false if no statement ends there.
bool hint_label_line_sharing(Parser *p, Diag *d, uint32_t at);

#endif
