// SPDX-License-Identifier: Apache-2.0
// What the files of the lexer share: lex.c scans what is right, lex_slip.c knows what may be wrong with characters, lex_foreign.c what
// other languages write.
#ifndef SMC_LEXER_H
#define SMC_LEXER_H

#include "compiler/syntax/lex.h"

static inline bool lexer_is_word(char c) { return is_letter(c) || is_digit(c); }

// The byte at p; '\0' behind the end, where no rule goes on.
static inline char lexer_byte(const Lexer *l, uint32_t p) { return p < l->src->len ? l->src->text[p] : '\0'; }
static inline Span lexer_span(const Lexer *l, uint32_t at, uint32_t len) { return (Span){l->src, at, len}; }

uint32_t lexer_skip_word(const Lexer *l, uint32_t p);       // letters, digits and _
const char *lexer_text(const Lexer *l, uint32_t at, uint32_t end);      // of the source, cut to a readable length
void lexer_skip_comment(Lexer *l);                          // to the end of the line
void lexer_check_comment(Lexer *l, uint32_t at, uint32_t end);  // reports what may not stand in a comment
void lexer_end_line(Lexer *l);                              // takes the line end
void lexer_finish(Lexer *l, Token *t, TokenKind kind, uint32_t end);
void lexer_word(Lexer *l, Token *t);                        // a name, or a reserved word
bool lexer_is_hex_prefix(const Lexer *l, uint32_t p);       // 0x

// ---- lex_slip.c ----

bool lexer_knows_word(const Lexer *l, uint32_t from, uint32_t end);      // the sources use it before here: it may be declared
bool lexer_is_declared(const Lexer *l, uint32_t from, uint32_t end);     // as an element or a variable, before here; or T

void lex_slip_control(Lexer *l, uint32_t at);                   // reports a control character
uint32_t lex_slip_comment_byte(Lexer *l, uint32_t at);      // what is not ASCII in a comment; returns its length
// Reports what stands at `at` and is neither ASCII nor, in a comment, UTF-8.  Returns its length.
uint32_t lex_slip_byte(Lexer *l, uint32_t at);
// The letter of another alphabet at p, if there is one: its length.
size_t lex_slip_letter(const Lexer *l, uint32_t p);
// Something that begins no token.  True if it gave one all the same.
bool lex_slip_stray(Lexer *l, Token *t);
// What the source is, if it is no text at all: "UTF-16", "binary data"; or NULL.
const char *lex_slip_no_text(const Source *s);

// ---- lex_foreign.c ----

bool lex_slip_is_remark(const Lexer *l);                        // the -- or % here begins one
bool lex_slip_comment(Lexer *l, Token *t);                      // skips `// ...`, `/* ... */`, `-- ...` and `% ...`; true: `//` divided
bool lex_slip_state(Lexer *l, Token *t);                        // `state Hold:` for [Hold]; true if it was
bool lex_slip_include(Lexer *l, const Token *t);                // include "common.sm"; true if it was, and its line has been skipped
bool lex_slip_range(Lexer *l, Token *t);                        // @range [0, 5] behind an annotation; true if it gave a token
bool lex_slip_bars(Lexer *l, Token *t);                         // |x|; true if it gave a token
// The number at..end runs on: 5psi, 1__0, 0x, 1e, 1.2.3.  Reports it; returns where it stops.
uint32_t lex_slip_number(Lexer *l, uint32_t at, uint32_t end);
void lex_slip_header(Lexer *l, uint32_t from, uint32_t end, Str name);       // [name] with characters no name has
void lex_slip_sign(Lexer *l, Token *t, const char *spelling, const char *native, const char *label);   // FOREIGN, ABSENT
bool lex_slip_semicolon(Lexer *l, Token *t);                    // true if it gave a token
void lex_slip_choice(Lexer *l);                                 // skips c ? a : b from the ?

#endif
