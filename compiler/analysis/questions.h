// SPDX-License-Identifier: Apache-2.0
// The questions that trial runs answer, each a row of questions.def, and what they share.
#ifndef SMC_QUESTIONS_H
#define SMC_QUESTIONS_H

#include "compiler/analysis/trial.h"

#define QUESTION(name, sentence) void question_##name(Trials *t);
#include "compiler/analysis/questions.def"
#undef QUESTION

// The statement of a number; NULL of 0.
const Stmt *question_stmt(const Trials *t, uint32_t number);
// Whether the statement is one of the state's.
bool question_state(const Stmt *stmt, const State *s);
// "a', 'b' and 'c": for a place in a message that is already in quotes.
const char *question_names(Arena *arena, const Var *const *v, uint32_t n);
// With a few digits, for a reader.
double question_rounded(double x);

#endif
