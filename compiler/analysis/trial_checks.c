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

// The most IR instructions that the checks of a machine may execute in trials: about two seconds.  Each check may execute half of what the checks
// before it have left, so that one of them cannot use everything.  Some checks have smaller limits.
static const uint64_t effort = 640000000;

static bool has_setting(const Analysis *a, TrialSetting setting)
{
    for (size_t v = 0; v < a->p->var.n; v++) {
        const Var *var = a->p->var.at[v];
        if (var->parameter && trial_value_of_parameter(setting, var) != trial_value_of_parameter(TRIAL_DEFAULTS, var))
            return true;
    }
    return setting == TRIAL_DEFAULTS;
}

static void run_checks(Trials *t)
{
    uint64_t left = effort / t->share, begin;

#define TRIAL_CHECK(name, flag, sentence) \
    begin = t->run->work; \
    t->pattern = NULL, t->random = TRIAL_SEED, t->until = begin + left / 2 + 1, check_##name(t); \
    left -= t->run->work - begin < left ? t->run->work - begin : left; \
    if (!trial_may_continue(t) && t->run->work > begin) \
        trial_add_gap(t->gaps, (TrialGap){GAP_CHECK, NULL, NULL, flag});
#include "compiler/analysis/trial_checks.def"
#undef TRIAL_CHECK
}

// Returns the values of the parameters in a setting, as "limit = 700, count = 1".
static const char *setting_text(const Analysis *a, TrialSetting setting)
{
    Buf out;

    buf_init(&out, a->arena);
    for (size_t v = 0; v < a->p->var.n; v++) {
        const Var *var = a->p->var.at[v];
        if (!var->parameter)
            continue;
        buf_str(&out, out.n > 0 ? ", " : "");
        buf_printf(&out, "%s = %s", var->name->text, const_text(a->arena, trial_value_of_parameter(setting, var)));
    }
    return buf_text(&out);
}

// Runs the checks with the defaults of parameters, then at both ends of their ranges.  A finding is reported for the first setting that shows it
// (diag_report drops repetitions).
void analyse_trials(Analysis *a)
{
    TrialGaps gaps = {.arena = a->arena};
    const uint32_t share = 1u + has_setting(a, TRIAL_LOWEST) + has_setting(a, TRIAL_HIGHEST);

    for (int k = 0; k < TRIAL_SETTINGS; k++) {
        const TrialSetting setting = (TrialSetting)k;
        const size_t before = a->diags->list.n;
        if (!has_setting(a, setting))
            continue;
        run_checks(trials_at(a, setting, share, &gaps));
        for (size_t i = before; i < a->diags->list.n && setting != TRIAL_DEFAULTS; i++)
            diag_note(a->diags, a->diags->list.at[i], (Span){0}, DIAG_note_setting, setting_text(a, setting));
    }
    if (gaps.list.n == 0 && a->diags->known >> DIAG_JUDGED_STEP & 1u)
        a->diags->known |= 1u << DIAG_JUDGED_TRIALS;
    trial_report_gaps(a, &gaps);
}
