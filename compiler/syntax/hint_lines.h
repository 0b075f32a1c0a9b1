// SPDX-License-Identifier: Apache-2.0
// Hints about line ends: several statements share a line, or the statements of a condition follow on lines of their own. These functions
// read only characters, not tokens, so they also work on lines with other errors. They propose an edit only if every statement that may
// depend on a condition still depends on it afterwards: the edit puts all of them in braces.
#ifndef SMC_HINT_LINES_H
#define SMC_HINT_LINES_H

#include "compiler/diag/diag.h"

typedef enum HintSeparator {
    HINT_SEMICOLON,
    HINT_OTHER                // a comma, a word, or nothing
} HintSeparator;

// Called if another statement follows, on the same line, the statement that ends before `at`. Labels d with what to do, and proposes
// an edit if that is unambiguous. Returns the offset up to which d covers the source: errors about separators before that offset need no
// further diagnostic. Returns 0, and adds nothing, if the text that ends before `at` is not a statement.
uint32_t hint_label_shared_line(Diags *diags, Diag *d, const Source *src, uint32_t at, HintSeparator separator);

// Returns whether more statements follow the statement at `at`: after a ';' on its line, or on a line below with more indentation. Then it
// is unclear which of them depend on a condition before the first: in C those after the ';' do not.
bool hint_is_first_of_several(const Source *src, uint32_t at);

// Returns the end of the statement at `at` if only words that close a conditional follow on its line, as in y := 1; END_IF; and sets *end to the end
// of these words. 0: something else follows.
uint32_t hint_find_end_if(const Source *src, uint32_t at, uint32_t *end);

// Called if a line ends after a condition's colon, or after a word such as `then`, of `len` bytes at `colon`. If the lines below are indented
// more, they are probably the condition's statements, and the function proposes braces around them. Returns the end of these statements; 0 if
// no such statements follow.
uint32_t hint_brace_indented_lines(Diags *diags, Diag *d, const Source *src, uint32_t colon, uint32_t len);

#endif
