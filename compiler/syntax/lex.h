// SPDX-License-Identifier: Apache-2.0
// Converts text to tokens. Line ends are not tokens: each token records whether it is the first on its line. The lexer reports wrong
// characters, malformed numbers and operators of other languages, and returns the token that the user probably meant.
#ifndef SMC_LEX_H
#define SMC_LEX_H

#include "compiler/base/str.h"
#include "compiler/diag/diag.h"
#include "stdlib/types.h"

typedef enum TokenKind {
#define TOKEN(kind, name) TOK_##kind,
#define WORD(kind, spelling) TOK_##kind,
#define PUNCTUATOR(kind, spelling) TOK_##kind,
#include "compiler/syntax/tokens.def"
    TOK_COUNT
} TokenKind;

typedef struct Token {
    TokenKind kind;
    bool first;               // the first token on its line
    uint32_t at, len;         // offset and length in the source
    Str text;                 // NAME, TYPE, words: as written; ADDRESS: with its port; HEADER, LABEL, ANNOTATION: the name without its punctuation;
                              // TEXT: without quotes
    SmType type;              // TYPE: which type it names
    SmF64 number;             // NUMBER: its value
} Token;

// Quoted text is a token only inside an @allow( ), where Lexer.texts is set, and everywhere where Lexer.config is.
typedef enum LexAllow {
    LEX_NO_ALLOW,
    LEX_ALLOW,                // after the name @allow, up to its parenthesis or the end of the line
    LEX_IN_ALLOW              // inside the parentheses of the @allow
} LexAllow;

enum {
    LEX_PUNCTUATORS = 0
#define PUNCTUATOR(kind, spelling) + 1
#include "compiler/syntax/tokens.def"
};

enum {
    LEX_HINTS = 0             // number of rows of hints.def that the lexer searches
#define HINT_TEXT(...) + 1
#define HINT_AFTER(...) + 1
#define HINT_OPERATOR(...) + 1
#define HINT_ABSENT_OPERATOR(...) + 1
#include "compiler/syntax/hints.def"
};

typedef struct Lexer {
    const Source *src;
    StrPool *strings;
    Diags *diags;
    uint8_t first_punctuator[128];        // by character: 1 + the first row of the punctuators that begin with it; 0: none
    uint8_t next_punctuator[LEX_PUNCTUATORS];     // by row: 1 + the next row that begins with the same character
    uint32_t at;              // the next byte to read
    uint32_t line_start;      // offset of the current line's first byte
    uint32_t reported_line;   // 1 + line_start of the last line in which a wrong character was reported
    uint32_t reported_before; // the same of the line before that one in which there was one: the lexer can be a line ahead of the parser
    bool first;               // the next token is the first on its line
    bool keep_comments;       // lex_next returns comments as tokens
    bool config;              // a .io, .app or .net: file names are quoted, and units follow numbers
    bool addresses;           // a .net: four numbers with dots are an address
    bool script;              // a .ss: quoted text can follow `include`, @assert, @fail, @expect and @print; deploy.T is one name, as in a .rq
    bool requirements;        // a .rq: one quoted text can follow the name that begins a line
    bool data;                // in a section [data] of a script: texts in quotes can follow anywhere
    bool texts;               // in a script or a .rq: quoted text can follow in this statement
    TokenKind last;           // kind of the last token returned
    bool unit;                // the last token returned was @unit
    LexAllow allow;           // the current position relative to an @allow( )

    // Only the hints read these.
    uint8_t first_hint[256];  // by character: 1 + the first row of hints.def whose spelling begins with it; 0: none
    uint8_t next_hint[LEX_HINTS];     // by row: 1 + the next row that begins with the same character
    bool stores, annotated;   // whether an = precedes the current position on its line; whether an annotation precedes it there
    bool no_comment_end;      // the rest of the source contains no */
    uint32_t bar;             // position of the | that closes |x|
    uint32_t parens;          // number of parentheses opened on this line and still open
    uint32_t open_parens;     // number of parentheses opened in this statement, on any line, and still open
    uint32_t hinted;          // end of the lines about whose several statements a hint has reported
} Lexer;

void lex_init(Lexer *l, StrPool *strings, Diags *diags, const Source *src);
void lex_next(Lexer *l, Token *t);          // reads the next token; at the end of the source always TOK_END

void lex_skip_to(Lexer *l, uint32_t at);    // continues at `at`, the start of a line

// Returns how a diagnostic names tokens of this kind: "+", "if", "name".
const char *lex_token_name(TokenKind kind);

bool lex_find_reserved(Str word, TokenKind *kind);

bool lex_is_header_name(const char *s, size_t n);
bool lex_is_member(const char *s, size_t n);    // whether it is a machine's name, a dot and a name, as in deploy.T

bool lex_is_letter(char c);                     // whether c is A-Z, a-z or _
bool lex_is_digit(char c);
bool lex_is_identifier(const char *s, size_t n);

#endif
