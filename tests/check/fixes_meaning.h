// SPDX-License-Identifier: Apache-2.0
// Checks what an edit must preserve.  Neither check uses how the parser or the hints group statements.
#ifndef SMC_TEST_FIXES_MEANING_H
#define SMC_TEST_FIXES_MEANING_H

#include "compiler/sema/program.h"

// Checks that `is` contains each assignment and transition of `was`, in the same order and under at least as many conditions.  Conditions are
// counted in the source: braces, colons before the statement on its line, and a colon that ends an earlier line with less indentation.  Returns
// what is wrong, or NULL; adds the number of compared statements to *n.
const char *statements_lost(Arena *arena, const Source *was, const Source *is, size_t *n);

// Checks that both machines behave equally on random inputs, in several runs from each state with the reference interpreter.  Returns what is
// wrong, or NULL; adds the number of steps to *n.
const char *behaviour_changed(Arena *arena, const Program *was, const Program *is, size_t *n);

#endif
