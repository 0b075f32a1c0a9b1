// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the hints for the lexer: hint_text.c (search; lines such as `include`, ranges such as 0..5), hint_comment.c
// (comments), hint_malformed.c (numbers, names and headers), hint_operator.c (operators), hint_chars.c (characters).
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

uint32_t hint_skip_spaces(const Lexer *l, uint32_t p);         // skips spaces, tabs and \r
bool hint_ends_line(const Lexer *l, uint32_t p);            // a line end, a comment or the end of the source is at p
uint32_t hint_skip_name(const Lexer *l, uint32_t p);        // the end of the identifier at p that is not a word of the language; or p

// ---- what is known about a word or a token ----

bool hint_knows_word(const Lexer *l, uint32_t from, uint32_t end);      // the word appeared earlier in the sources, so it may be declared
bool hint_is_declared(const Lexer *l, uint32_t from, uint32_t end);     // as an element or a variable, before this position; true also for T
// Whether prose begins at p: two words in a row, unless the first is declared and the second is an operator word (size AND, size then).
bool hint_is_prose(const Lexer *l, uint32_t p);
// Whether the last token ends a value, and is on the same line as the next one (`first` is false). Then a binary operator or the closing
// bar of |x| can follow; otherwise an operand is missing.
bool hint_follows_value(const Lexer *l, bool first);

// ---- what the files share ----

// Reports the operator t, which this language does not have. `native` is its equivalent here; if that is NULL, `label` explains what to
// write instead.
void hint_report_operator(Lexer *l, Token *t, const char *spelling, const char *native, const char *label);
uint32_t hint_report_non_ascii(Lexer *l, uint32_t at);      // reports the character at `at`, which is not ASCII; returns its length
// Reports the letters of other alphabets in a name, as in größe, which begin at `end`; returns the end of the name.
uint32_t hint_skip_foreign_letters(Lexer *l, uint32_t end);

void hint_skip_choice(Lexer *l);                            // skips the rest of c ? a : b or IF(c, a, b), up to the end of the line
extern const char *const hint_no_choice;                    // what to write instead

#endif
