// SPDX-License-Identifier: Apache-2.0
// Hints about line ends: several statements share a line, or the statements of a condition follow on lines of their own.
// They work on the text of the lines alone, so that they also help where a line has other mistakes.  An edit is proposed only if no
// statement loses a condition by it: of what depends on a condition, everything goes into braces.
#ifndef SMC_HINT_LINES_H
#define SMC_HINT_LINES_H

#include "compiler/diag/diag.h"

typedef enum HintSeparator {
    HINT_SEMICOLON,
    HINT_OTHER                // a comma, a word, or nothing
} HintSeparator;

// Another statement follows the one that ends before `at`, on the same line.  Labels d with what to do, and proposes the edit if that is
// unambiguous.  Returns up to where in the source this is about: separators before that need no message of their own.  Returns 0, and
// adds nothing, if what ends before `at` is no statement.
uint32_t hint_shared_line(Diags *diags, Diag *d, const Source *src, uint32_t at, HintSeparator separator);

// Whether more statements follow the one at `at`: after a ';' on its line, where in C they depend on no condition before it, or on a line
// below that is indented more, where they seem to depend on it.
bool hint_is_first_of_several(const Source *src, uint32_t at);

// A line ends after a condition's colon.  If the lines below are indented more, they are the condition's statements: proposes braces.
// Returns where they end; 0 if there is no such statement.
uint32_t hint_indented_lines(Diags *diags, Diag *d, const Source *src, uint32_t colon);

#endif
