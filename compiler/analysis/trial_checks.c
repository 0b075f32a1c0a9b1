// SPDX-License-Identifier: Apache-2.0
#include "compiler/analysis/trial_checks.h"

#include <stdio.h>
#include <stdlib.h>

const char *trial_check_join_names(Arena *arena, const Var *const *v, uint32_t n)
{
    const char *text = v[0]->name->text;

    for (uint32_t i = 1; i < n; i++)
        text = format_in(arena, i + 1 < n ? "%s', '%s" : "%s' and '%s", text, v[i]->name->text);
    return text;
}

double trial_check_round(double x)
{
    char text[32];

    snprintf(text, sizeof text, "%.4g", x);
    return strtod(text, NULL);
}

// The most IR instructions that a check may execute in trials: about two seconds.  Some checks have smaller limits.
static const uint64_t effort = 400000000;

void analyse_trials(Analysis *a)
{
    Trials *t = trials_of(a);

#define TRIAL_CHECK(name, sentence) t->random = TRIAL_SEED, t->until = t->run->work + effort, check_##name(t);
#include "compiler/analysis/trial_checks.def"
#undef TRIAL_CHECK
}
