// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the hints for the lexer: hint_text.c (search, comments, numbers, headers, lines of other languages), hint_sign.c
// (operators), hint_chars.c (characters).
#ifndef SMC_HINT_TEXT_H
#define SMC_HINT_TEXT_H

#include "compiler/syntax/hints.h"
#include "compiler/syntax/lexer.h"

enum { HINT_FAR = 200 };      // bytes; no hint reads further, so that hostile text cannot cost time quadratic in its length

// The functions of rows of hints.def. The row's spelling is at t->at and t->len characters long. Each returns HINT_NONE, and reports
// nothing, if the text is something else.
#define HINT_TEXT(spelling, read) HintResult hint_##read(Lexer *l, Token *t);
#define HINT_AFTER(kind, read) HINT_TEXT("", read)
#include "compiler/syntax/hints.def"

// ---- positions ----

uint32_t hint_skip_gap(const Lexer *l, uint32_t p);         // blanks
bool hint_ends_line(const Lexer *l, uint32_t p);            // a line end, a comment or the end of the source is at p

// ---- what is known about a word or a token ----

bool hint_knows_word(const Lexer *l, uint32_t from, uint32_t end);      // the word appeared earlier in the sources, so it may be declared
bool hint_is_declared(const Lexer *l, uint32_t from, uint32_t end);     // as an element or a variable, before this position; or T
// Whether the last token ends a value. Then a binary operator or a closing bar can follow; otherwise an operand is missing.
bool hint_follows_value(const Lexer *l, bool first);

// ---- what the files share ----

// Reports the sign t, which is not a sign of the language: it is spelt `native` here or, if that is NULL, does not exist, and `label` says
// what to do.
void hint_report_sign(Lexer *l, Token *t, const char *spelling, const char *native, const char *label);
uint32_t hint_report_byte(Lexer *l, uint32_t at);           // reports a character that is not ASCII; returns its length
uint32_t hint_rest_of_name(Lexer *l, uint32_t end);         // größe: hint_rest_of_token for names

void hint_skip_choice(Lexer *l);                            // skips the rest of c ? a : b or IF(c, a, b), up to the end of the line
extern const char *const hint_no_choice;                    // what to write instead

#endif
