// SPDX-License-Identifier: Apache-2.0
// Hints about operators written as words (`is not`, `is greater than`), and about the operands that follow an operator. An edit replaces
// only the operator; these functions check whether the operands are then still what the user means. `text` is the whole source, which
// ends with a NUL; each function reads only the line of its position.
#ifndef SMC_HINT_WORDS_H
#define SMC_HINT_WORDS_H

#include "compiler/syntax/lex.h"

typedef struct HintPhrase {
    const char *words;        // lower case, separated by single spaces
    const char *native;       // the operator of this language that means the same, as written: "=="
    TokenKind kind;
} HintPhrase;

// Returns the longest operator in words that begins at `at`, and its end in *end; NULL if no operator begins there.
const HintPhrase *hint_find_phrase(const char *text, uint32_t at, uint32_t *end);

// Returns the end of the operand at `at`; `at` if no operand begins there. Spaces and a + or - can precede the operand.
uint32_t hint_skip_operand(const char *text, uint32_t at);

// Whether the word at `at` continues or ends a condition: and, or, then, do, is, gt and others; case does not matter.
bool hint_is_operator_word(const char *text, uint32_t at);

// Whether the text after a comparison operator, which begins at `at`, has more than one meaning: not 5, 5 or 6, between 3 and 5.
bool hint_is_doubtful_comparison(const char *text, uint32_t at);

// Whether the '=' at `at`, inside parentheses, can mean an assignment or a named argument: (x = p) > 3, roll_avg(p, n = 5).
bool hint_stores_in_parens(const char *text, uint32_t at);

// Whether a `not` before `at` negates only the operand at `at` in every language: no comparison or calculation follows the operand.
bool hint_is_negated_alone(const char *text, uint32_t at);

#endif
