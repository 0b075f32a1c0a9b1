// SPDX-License-Identifier: Apache-2.0
// The checks by trial runs, each a row of trial_checks.def, and the helpers that they share.
#ifndef SMC_TRIAL_CHECKS_H
#define SMC_TRIAL_CHECKS_H

#include "compiler/analysis/trial.h"

#define TRIAL_CHECK(name, flag, sentence) void check_##name(Trials *t);
#include "compiler/analysis/trial_checks.def"
#undef TRIAL_CHECK

// A sensor that has failed: it always reads `reading`, plus noise.
typedef struct SensorFailure {
    uint32_t input;
    double reading, noise;
} SensorFailure;

// Returns a list of names such as "a', 'b' and 'c", for a diagnostic that puts its argument in quotes.
const char *trial_check_join_names(Arena *arena, const Var *const *v, uint32_t n);
// Returns x rounded to four significant digits, for diagnostics.
double trial_check_round(double x);

#endif
