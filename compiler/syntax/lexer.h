// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the lexer and the hints about what it rejects (hint_text.h). lex.c scans tokens, lex_chars.c checks
// characters.
#ifndef SMC_LEXER_H
#define SMC_LEXER_H

#include "compiler/syntax/lex.h"

static inline bool lexer_is_word(char c) { return lex_is_letter(c) || lex_is_digit(c); }

// The byte at p; '\0' after the end, where every rule stops.
static inline char lexer_byte(const Lexer *l, uint32_t p) { return p < l->src->len ? l->src->text[p] : '\0'; }
static inline Span lexer_span(const Lexer *l, uint32_t at, uint32_t len) { return (Span){l->src, at, len}; }

uint32_t lexer_skip_word(const Lexer *l, uint32_t p);       // letters, digits and _
const char *lexer_text(const Lexer *l, uint32_t at, uint32_t end);      // of the source, cut to a readable length
void lexer_skip_comment(Lexer *l);                          // to the end of the line
void lexer_end_line(Lexer *l);                              // consumes the line end
void lexer_finish_token(Lexer *l, Token *t, TokenKind kind, uint32_t end);
void lexer_read_word(Lexer *l, Token *t);                        // a name, or a reserved word
bool lexer_is_hex_prefix(const Lexer *l, uint32_t p);       // 0x

// ---- lex_chars.c ----

// Returns true once per line: one report is enough, because later wrong characters on a line are mostly of the same kind.
bool lexer_mark_line_reported(Lexer *l);
void lexer_report_control(Lexer *l, uint32_t at);           // a control character
uint32_t lexer_report_not_utf8(Lexer *l, uint32_t at);      // returns 1, its length
void lexer_check_comment(Lexer *l, uint32_t at, uint32_t end);  // reports characters that a comment must not contain
bool lexer_check_is_text(Lexer *l);                         // false: reported that the source is not text; it is then not read

#endif
