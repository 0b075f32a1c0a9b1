// SPDX-License-Identifier: Apache-2.0
// Hints about line ends: several statements share a line, or the statements of a condition follow on lines of their own. The functions
// read only the characters of the lines, so they also help where a line has other errors. They propose an edit only if it removes no
// statement from its condition: all statements that depend on a condition go into braces.
#ifndef SMC_HINT_LINES_H
#define SMC_HINT_LINES_H

#include "compiler/diag/diag.h"

typedef enum HintSeparator {
    HINT_SEMICOLON,
    HINT_OTHER                // a comma, a word, or nothing
} HintSeparator;

// Called where another statement follows, on the same line, the statement that ends before `at`. Labels d with what to do, and proposes
// the edit if that is unambiguous. Returns the offset up to which d covers the source: separators before it need no diagnostic of their
// own. Returns 0, and adds nothing, if the text that ends before `at` is not a statement.
uint32_t hint_label_shared_line(Diags *diags, Diag *d, const Source *src, uint32_t at, HintSeparator separator);

// Returns whether more statements follow the one at `at`: after a ';' on its line, or on a line below with more indentation. It is then
// unclear which of them depend on a condition before the first one: in C those after the ';' do not.
bool hint_is_first_of_several(const Source *src, uint32_t at);

// A line ends after a condition's colon. If the lines below are indented more, they are the condition's statements, and the function
// proposes braces. Returns the end of these statements; 0 if there are none.
uint32_t hint_brace_indented_lines(Diags *diags, Diag *d, const Source *src, uint32_t colon);

#endif
