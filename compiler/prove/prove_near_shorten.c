// SPDX-License-Identifier: Apache-2.0
// Removes changes that a violation does not need from a run, many at once, then fewer.  A script's plant changes inputs in each step: those
// changes remain that lead from state to state.
#include <string.h>

#include "compiler/prove/prove_near_parts.h"

// Runs a scenario.  Returns the first step that violates the requirement; 0: none.
static uint64_t find_violation(NearSearch *k, const Scenario *s)
{
    size_t next = 0;

    near_begin(k, s);
    for (uint64_t step = 1; step <= s->steps && k->steps < k->limit; step++) {
        next = near_set_inputs(k, s, next, step);
        if (near_run_step(k, step) == MONITOR_VIOLATED)
            return step;
    }
    return 0;
}

// Removes `n` changes from number `from` on if the rest violates the requirement, too.
static bool try_without_changes(NearSearch *k, Scenario *s, ScenarioChange *change, ScenarioChange *less, size_t from, size_t n)
{
    Scenario attempt = *s;
    uint64_t step;

    // With ranges, inputs that are not set have other values than in this run.
    if (k->g->assume_ranges && s->change[from].step == 1)
        return false;
    memcpy(less, s->change, from * sizeof *less);
    memcpy(less + from, s->change + from + n, (s->changes - from - n) * sizeof *less);
    attempt.change = less;
    attempt.changes -= n;
    step = find_violation(k, &attempt);
    if (step == 0)
        return false;
    memcpy(change, less, attempt.changes * sizeof *change);
    s->changes = attempt.changes;
    s->steps = step;
    return true;
}

const Scenario *near_shorten(Arena *arena, Arena *work, const IrMachine *m, const GoalSearch *g, const Scenario *long_one, uint64_t *steps)
{
    NearSearch k;
    Scenario s = *long_one;
    ScenarioChange *change, *less;
    const Scenario *out;

    near_open(&k, work, m, g);
    change = arena_copy(work, s.change, s.changes * sizeof *change);
    less = arena_array(work, s.changes + 1, sizeof *less);
    s.change = change;
    for (size_t n = s.changes / 2; n > 0; n /= 2)
        for (size_t end = s.changes; end >= n && k.steps < k.limit; end = end < s.changes ? end : s.changes) {
            try_without_changes(&k, &s, change, less, end - n, n);
            end -= n;
        }
    *steps = k.steps;
    out = goal_end_scenario(work, g, &s);
    if (!out)
        return long_one;
    change = arena_copy(arena, out->change, out->changes * sizeof *change);
    s = *out;
    s.change = change;
    return arena_copy(arena, &s, sizeof s);
}
