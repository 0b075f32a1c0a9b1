// SPDX-License-Identifier: Apache-2.0
// The questions that trial runs answer, each a row of questions.def, and the helpers that they share.
#ifndef SMC_TRIAL_CHECKS_H
#define SMC_TRIAL_CHECKS_H

#include "compiler/analysis/trial.h"

#define QUESTION(name, sentence) void question_##name(Trials *t);
#include "compiler/analysis/trial_checks.def"
#undef QUESTION

// "a', 'b' and 'c": for a position in a message that is already inside quotes.
const char *question_names(Arena *arena, const Var *const *v, uint32_t n);
// Rounded to a few digits, for messages.
double question_rounded(double x);

#endif
