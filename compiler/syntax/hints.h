// SPDX-License-Identifier: Apache-2.0
// Hints: what the user meant by text that the grammar does not allow. Users know other languages (`&&`, `5 s`, `if x then`), write prose,
// or type fast. Lexer and parser contain the grammar alone. Where it does not allow the text, they call one of these functions, which
// searches hints.def for the likeliest cause, reports it instead of a general message, and proposes an edit if that is unambiguous.
#ifndef SMC_HINTS_H
#define SMC_HINTS_H

#include "compiler/syntax/lex.h"

// ---- for the lexer ----

typedef enum HintLexed {
    HINT_NONE,                // the text is not of another language
    HINT_TOKEN,               // it was reported and read as token t
    HINT_SKIPPED              // it was reported and skipped
} HintLexed;

// At the start of each token: text of another language (`&&`, `// ...`, `state Hold:`), which the grammar could misread.
HintLexed hint_foreign_text(Lexer *l, Token *t);
// A token of this kind is well formed only up to `end`: 5psi, größe, [two words]. Reports this; returns the end of the malformed token.
uint32_t hint_rest_of_token(Lexer *l, const Token *t, TokenKind kind, uint32_t end);
// No token begins here. Never returns HINT_NONE.
HintLexed hint_stray_text(Lexer *l, Token *t);

#endif
