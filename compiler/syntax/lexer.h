// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the lexer (lex.c scans tokens, lex_chars.c checks characters) and by its hints (hint_text.h).
#ifndef SMC_LEXER_H
#define SMC_LEXER_H

#include "compiler/syntax/lex.h"

static inline bool lexer_is_word(char c) { return lex_is_letter(c) || lex_is_digit(c); }

// Returns the byte at p; '\0' at or after the end, which every scanning loop treats as the end.
static inline char lexer_byte(const Lexer *l, uint32_t p) { return p < l->src->len ? l->src->text[p] : '\0'; }
static inline Span lexer_span(const Lexer *l, uint32_t at, uint32_t len) { return (Span){l->src, at, len}; }

uint32_t lexer_skip_word(const Lexer *l, uint32_t p);       // returns the end of the letters, digits and _ at p
const char *lexer_text(const Lexer *l, uint32_t at, uint32_t end);      // returns a part of the source, cut to a readable length
void lexer_skip_comment(Lexer *l);                          // skips to the end of the line
void lexer_end_line(Lexer *l);                              // consumes the line end
// Whether quoted text at the current position can be the text of an item, as in `@fail "text"`: outside parentheses, after a complete value, a comma,
// another text, or the word that begins the item.
bool lexer_may_be_remark(const Lexer *l);
void lexer_finish_token(Lexer *l, Token *t, TokenKind kind, uint32_t end);
void lexer_read_word(Lexer *l, Token *t);                        // reads the name or reserved word at the current position
bool lexer_is_hex_prefix(const Lexer *l, uint32_t p);       // whether 0x is at p

// ---- lex_chars.c ----

// Returns true when first called for the current line, so that only the first wrong character of a line is reported.
bool lexer_mark_line_reported(Lexer *l);
// Whether the line of the byte at `at` is one of the last two in which a wrong character was reported.
bool lexer_is_line_reported(const Lexer *l, uint32_t at);
void lexer_report_control(Lexer *l, uint32_t at);           // reports the control character at `at`
uint32_t lexer_report_not_utf8(Lexer *l, uint32_t at);      // reports a byte that is not UTF-8; returns 1
void lexer_check_comment(Lexer *l, uint32_t at, uint32_t end);  // reports characters that a comment must not contain
bool lexer_check_is_text(Lexer *l);                         // returns false after reporting that the source is not text

#endif
