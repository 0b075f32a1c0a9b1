// SPDX-License-Identifier: Apache-2.0
// What an edit must preserve.  Neither check uses the parser's or the hints' idea of what belongs together.
#ifndef SMC_TEST_FIXES_MEANING_H
#define SMC_TEST_FIXES_MEANING_H

#include "compiler/sema/program.h"

// Each assignment and transition of `was`, in order, is in `is` too, under at least as many conditions.  Conditions are counted in the
// text: braces, colons before it on its line, a colon that ends a less indented line above.  Returns what is wrong, or NULL; adds the
// number of statements that were compared to *n.
const char *statements_lost(Arena *arena, const Source *was, const Source *is, size_t *n);

// Both machines do the same on random inputs: several runs from each state with the reference interpreter.  Returns what is wrong, or
// NULL; adds the number of steps to *n.
const char *behaviour_changed(Arena *arena, const Program *was, const Program *is, size_t *n);

#endif
