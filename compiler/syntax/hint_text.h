// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files with hints for the lexer: hint_text.c (searches hints.def; lines such as `include`, ranges such as
// 0..5), hint_comment.c (comments), hint_malformed.c (numbers, names and headers), hint_operator.c (operators), hint_chars.c (characters).
#ifndef SMC_HINT_TEXT_H
#define SMC_HINT_TEXT_H

#include "compiler/syntax/hints.h"
#include "compiler/syntax/lexer.h"

enum { HINT_FAR = 200 };      // bytes; no hint reads further, so that hostile text cannot cost time quadratic in its length

// The functions that rows of hints.def name. The row's spelling is at t->at and is t->len characters long. A function returns HINT_NONE,
// and reports nothing, if it does not apply to the text.
#define HINT_TEXT(spelling, read) HintResult hint_##read(Lexer *l, Token *t);
#define HINT_AFTER(kind, read) HINT_TEXT("", read)
#include "compiler/syntax/hints.def"

// ---- positions ----

uint32_t hint_skip_spaces(const Lexer *l, uint32_t p);         // skips spaces, tabs and \r
bool hint_ends_line(const Lexer *l, uint32_t p);            // whether a line end, a comment or the end of the source is at p
uint32_t hint_skip_name(const Lexer *l, uint32_t p);        // end of the identifier at p; p if no identifier begins there or it is a reserved word

// ---- what is known about a word or a token ----

// Whether the word appeared earlier in the sources, so that it may be declared.
bool hint_knows_word(const Lexer *l, uint32_t from, uint32_t end);
// Whether the word is an element or a variable that is declared before this position; true for T.
bool hint_is_declared(const Lexer *l, uint32_t from, uint32_t end);
// Whether the word `state` ends at `at`, before blanks, and no variable is declared with this name.
bool hint_follows_state(const Lexer *l, uint32_t at);
// Whether prose begins at p: two words in a row. `size AND` and `size then` are no prose if `size` is declared.
bool hint_is_prose(const Lexer *l, uint32_t p);
// Whether the last token ends a value. `first`: whether the next token is the first on its line; then the result is false. After a value a
// binary operator or the closing bar of |x| can follow; elsewhere an operand is expected.
bool hint_follows_value(const Lexer *l, bool first);

// ---- what the files share ----

// Reports the operator t, which this language does not have. `native` is the equivalent of this language; if it is NULL, `label` explains
// what to write instead.
void hint_report_operator(Lexer *l, Token *t, const char *spelling, const char *native, const char *label);
uint32_t hint_report_non_ascii(Lexer *l, uint32_t at);      // reports the character at `at`, which is not ASCII; returns its length
// Reports the letters of other alphabets in a name, as in größe, which begin at `end`; returns the end of the name.
uint32_t hint_skip_foreign_letters(Lexer *l, uint32_t end);

void hint_skip_choice(Lexer *l);                            // skips the rest of c ? a : b or IF(c, a, b), up to the end of the line
extern const char *const hint_no_choice;                    // text for diagnostics: what to write instead of `c ? a : b`

#endif
