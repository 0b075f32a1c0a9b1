// SPDX-License-Identifier: Apache-2.0
// Removes changes that a violation does not need from a run, many at once, then fewer.  A script's plant changes inputs in each step: those
// changes remain that lead from state to state.  Then waits between changes become shorter.
#include <string.h>

#include "compiler/prove/prove_near_parts.h"

// Sets the inputs before a step.  A ramp, say, changes its input in each step until the next change of that input.  k->cell has the values before.
static void set_inputs(NearSearch *k, uint64_t step)
{
    uint64_t *cell = flat_cells(k->f, k->block);

    for (uint32_t v = 0; v < k->p->var.n; v++)
        if (k->current[v] && k->m->var_of[v] != IR_NONE)
            cell[k->m->var_of[v]] = scenario_cell(k->p, k->current[v], step, k->cell);
}

// Runs a scenario.  Returns the first step that violates the requirement; 0: none.
static uint64_t find_violation(NearSearch *k, const Scenario *s)
{
    size_t next = 0;

    near_begin(k, s);
    near_read_cells(k);
    memset(k->current, 0, k->p->var.n * sizeof *k->current);
    for (uint64_t step = 1; step <= s->steps && k->steps < k->limit; step++) {
        for (; next < s->changes && s->change[next].step <= step; next++)
            k->current[s->change[next].var] = &s->change[next];
        set_inputs(k, step);
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

    // If ranges are assumed, an input that is not set in the first step gets a value from its range later, instead of the 0 of this run.
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

// Makes all changes from number `from` on earlier by `by` steps if the result violates the requirement, too.
static bool try_earlier(NearSearch *k, Scenario *s, ScenarioChange *change, ScenarioChange *earlier, size_t from, uint64_t by)
{
    Scenario attempt = *s;
    uint64_t step;

    memcpy(earlier, change, s->changes * sizeof *earlier);
    for (size_t i = from; i < s->changes; i++)
        earlier[i].step -= by;
    attempt.change = earlier;
    step = find_violation(k, &attempt);
    if (step == 0 || step >= s->steps)
        return false;
    memcpy(change, earlier, s->changes * sizeof *change);
    s->steps = step;
    return true;
}

// Leaves out as much of each wait as it can: half of it, a quarter and so on, each as often as the requirement is still violated, and earlier.
// Changes of different steps stay in different steps.
static void shorten_waits(NearSearch *k, Scenario *s, ScenarioChange *change, ScenarioChange *earlier)
{
    for (size_t i = 0; i < s->changes && k->steps < k->limit; i++) {
        const uint64_t since = i ? change[i - 1].step : 0;
        for (uint64_t by = (change[i].step - since) / 2; by > 0 && k->steps < k->limit; by /= 2)
            while (change[i].step > since + by && try_earlier(k, s, change, earlier, i, by))
                ;
    }
}

const Scenario *near_shorten(Arena *arena, Arena *work, const IrMachine *m, const GoalSearch *g, const Scenario *long_one, uint64_t *steps)
{
    NearSearch k;
    Scenario s = *long_one;
    ScenarioChange *change, *less;
    const Scenario *out;

    *steps = 0;
    if (s.loops)
        return long_one;
    near_open(&k, work, m, g);
    k.current = ARENA_ARRAY(work, const ScenarioChange *, k.p->var.n + 1);
    change = arena_copy(work, s.change, s.changes * sizeof *change);
    less = arena_array(work, s.changes + 1, sizeof *less);
    s.change = change;
    for (size_t n = s.changes / 2; n > 0; n /= 2)
        for (size_t end = s.changes; end >= n && k.steps < k.limit; end = end < s.changes ? end : s.changes) {
            try_without_changes(&k, &s, change, less, end - n, n);
            end -= n;
        }
    shorten_waits(&k, &s, change, less);
    *steps = k.steps;
    out = goal_end_scenario(work, g, &s);
    if (!out)
        return long_one;
    change = arena_copy(arena, out->change, out->changes * sizeof *change);
    s = *out;
    s.change = change;
    return arena_copy(arena, &s, sizeof s);
}
