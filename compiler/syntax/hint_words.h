// SPDX-License-Identifier: Apache-2.0
// Hints about operators written as words (`is not`, `is greater than`), and about the operands that follow an operator. An edit replaces
// the operator only; these functions check whether the operands then have the same meaning as before. All of them take the source,
// which ends with a NUL, and read one line of it.
#ifndef SMC_HINT_WORDS_H
#define SMC_HINT_WORDS_H

#include "compiler/syntax/lex.h"

typedef struct HintPhrase {
    const char *words;        // lower case, separated by single spaces
    const char *native;
    TokenKind kind;
} HintPhrase;

// Returns the longest operator in words that begins at `at`, and its end in *end; NULL if there is none.
const HintPhrase *hint_find_phrase(const char *text, uint32_t at, uint32_t *end);

// Returns the end of the operand at `at`, which may have a + or - before it; `at` if there is none. Spaces before the operand are skipped.
uint32_t hint_skip_operand(const char *text, uint32_t at);

// Whether the word at `at` continues or ends a condition: and, or, then, do, is, gt, in any case of the letters.
bool hint_is_operator_word(const char *text, uint32_t at);

// Whether what follows a comparison operator that ends before `at` has more than one reading: not 5, 5 or 6, between 3 and 5.
bool hint_is_doubtful_comparison(const char *text, uint32_t at);

// Whether an '=' at `at`, which is inside parentheses, can be meant to store or to name an argument: (x = p) > 3, roll_avg(p, n = 5).
bool hint_stores_in_parens(const char *text, uint32_t at);

// Whether only the one operand at `at` is negated by a `not` before it, in every language: no comparison or calculation follows.
bool hint_is_negated_alone(const char *text, uint32_t at);

#endif
