// SPDX-License-Identifier: Apache-2.0
// Declarations shared by the files of the lexer. lex.c scans correct input, hint_chars.c handles wrong characters, hint_text.c handles
// the syntax of other languages.
#ifndef SMC_LEXER_H
#define SMC_LEXER_H

#include "compiler/syntax/lex.h"

static inline bool lexer_is_word(char c) { return is_letter(c) || is_digit(c); }

// The byte at p; '\0' after the end, where every rule stops.
static inline char lexer_byte(const Lexer *l, uint32_t p) { return p < l->src->len ? l->src->text[p] : '\0'; }
static inline Span lexer_span(const Lexer *l, uint32_t at, uint32_t len) { return (Span){l->src, at, len}; }

uint32_t lexer_skip_word(const Lexer *l, uint32_t p);       // letters, digits and _
const char *lexer_text(const Lexer *l, uint32_t at, uint32_t end);      // of the source, cut to a readable length
void lexer_skip_comment(Lexer *l);                          // to the end of the line
void lexer_check_comment(Lexer *l, uint32_t at, uint32_t end);  // reports characters that a comment must not contain
void lexer_end_line(Lexer *l);                              // consumes the line end
void lexer_finish(Lexer *l, Token *t, TokenKind kind, uint32_t end);
void lexer_word(Lexer *l, Token *t);                        // a name, or a reserved word
bool lexer_is_hex_prefix(const Lexer *l, uint32_t p);       // 0x

// ---- hint_chars.c ----

bool lexer_knows_word(const Lexer *l, uint32_t from, uint32_t end);      // the word appeared earlier in the sources, so it may be declared
bool lexer_is_declared(const Lexer *l, uint32_t from, uint32_t end);     // as an element or a variable, before this position; or T

void lex_hint_control(Lexer *l, uint32_t at);                   // reports a control character
uint32_t lex_hint_comment_byte(Lexer *l, uint32_t at);      // handles non-ASCII text in a comment; returns its length
// Reports the text at `at`, which is not ASCII or, in a comment, not UTF-8. Returns its length.
uint32_t lex_hint_byte(Lexer *l, uint32_t at);
// Returns the length of a letter of another alphabet at p; 0 if there is none.
size_t lex_hint_letter(const Lexer *l, uint32_t p);
// Handles text that begins no token. Returns true if it produced a token anyway.
bool lex_hint_stray(Lexer *l, Token *t);
// Names the format of a source that is not text ("UTF-16", "binary data"); NULL for text.
const char *lex_hint_no_text(const Source *s);

// ---- hint_text.c ----

bool lex_hint_is_remark(const Lexer *l);                        // whether the -- or % here begins a comment
bool lex_hint_comment(Lexer *l, Token *t);  // skips `// ...`, `/* ... */`, `-- ...` and `% ...`; true: `//` was a division
bool lex_hint_state(Lexer *l, Token *t);                        // `state Hold:` for [Hold]; true if it found one
bool lex_hint_include(Lexer *l, const Token *t);                // include "common.sm"; true if it found one and skipped its line
bool lex_hint_range(Lexer *l, Token *t);                        // @range [0, 5] after an annotation; true if it produced a token
bool lex_hint_bars(Lexer *l, Token *t);                         // |x|; true if it produced a token
// More characters follow the number at..end: 5psi, 1__0, 0x, 1e, 1.2.3. Reports this; returns the end of those characters.
uint32_t lex_hint_number(Lexer *l, uint32_t at, uint32_t end);
void lex_hint_header(Lexer *l, uint32_t from, uint32_t end, Str name);       // [name] with characters that names cannot contain
void lex_hint_sign(Lexer *l, Token *t, const char *spelling, const char *native, const char *label);   // FOREIGN, ABSENT
bool lex_hint_semicolon(Lexer *l, Token *t);                    // true if it produced a token
void lex_hint_choice(Lexer *l);                                 // skips c ? a : b, starting at the ?

#endif
