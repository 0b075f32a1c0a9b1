// SPDX-License-Identifier: Apache-2.0
// Shorter times and rounder values for a scenario that keeps its changes.
#include "compiler/search/search_choose.h"
#include "compiler/search/search_wish.h"

#define UNUSUAL_SIZE 1e15     // no sensor has values of this magnitude

enum {
    // skip_wait tries to replace a wait of more than LONG_WAIT steps before a change by a wait of 1 to SHORTEST_WAITS steps.  What follows the change
    // can then be delayed by up to MOST_DELAY steps.
    LONG_WAIT = 16,
    SHORTEST_WAITS = 2,
    MOST_DELAY = 3
};

// ---- shorter times ----

// Moves the changes and loops from change i on, and the end, by `less` steps towards the start, but what follows change i by `more` steps less.
static Attempt move_changes(Chooser *c, const Scenario *s, size_t i, uint64_t less, uint64_t more)
{
    Attempt t = chooser_begin_attempt(c, s, 0);

    for (size_t j = i; j < t.s.changes; j++)
        t.change[j].step -= t.change[j].step == s->change[i].step ? less : less - more;
    for (size_t j = 0; j < t.s.loops; j++)
        if (t.loop[j].from >= s->change[i].step) {
            t.loop[j].from -= less;
            t.loop[j].to -= less;
        }
    t.s.steps -= less - more;
    return t;
}

static bool has_clash(const Attempt *t)
{
    for (size_t j = 0; j < t->s.changes; j++)
        for (size_t n = 0; n < j; n++)
            if (t->change[j].var == t->change[n].var && t->change[j].step == t->change[n].step)
                return true;
    return false;
}

// Tries change i `less` steps sooner, and what follows `less - more` steps sooner.
static bool try_change_sooner(Chooser *c, Scenario *s, const GoalSet *want, size_t i, uint64_t less, uint64_t more)
{
    Attempt t = move_changes(c, s, i, less, more);

    return (more == 0 || s->loops == 0) && !has_clash(&t) && chooser_accept(c, s, &t, want, NULL);
}

// A long wait can be for a timer where a change of an input leads to the next state, too, but some steps later.  Halving does not find that: a
// wait of half the time does not reach the goal.  Tries the shortest waits, with more time after the change.
static bool skip_wait(Chooser *c, Scenario *s, const GoalSet *want, size_t i, uint64_t gap)
{
    for (uint64_t short_gap = 1; gap >= LONG_WAIT && short_gap <= SHORTEST_WAITS; short_gap++)
        for (uint64_t more = 0; more <= MOST_DELAY && chooser_has_effort(c); more++)
            if (try_change_sooner(c, s, want, i, gap - short_gap, more))
                return true;
    return false;
}

// The first step in which change i could be made: that of the change before it, or the end of a loop.
static uint64_t earliest_step(const Scenario *s, size_t i)
{
    const ScenarioLoop *l = i ? scenario_loop_at(s, s->change[i - 1].step) : NULL;

    return l ? l->to : i ? s->change[i - 1].step : 1;
}

// Shortens the time before each change outside loops: halves it as often as the goal is still reached.
void chooser_shorten_waits(Chooser *c, Scenario *s, const GoalSet *want)
{
    for (size_t i = 0; i < s->changes && chooser_has_effort(c); i++) {
        const ScenarioLoop *l = scenario_loop_at(s, s->change[i].step);
        const uint64_t before = earliest_step(s, i);
        uint64_t gap = s->change[i].step - before, least = 0;
        if (l && (s->change[i].step > l->from || (i && scenario_loop_at(s, s->change[i - 1].step) == l)))
            continue;
        if (skip_wait(c, s, want, i, gap))
            gap = i < s->changes ? s->change[i].step - before : 0;
        while (least < gap && chooser_has_effort(c) && i < s->changes) {
            const uint64_t middle = least + (gap - least) / 2;
            if (try_change_sooner(c, s, want, i, s->change[i].step - before - middle, 0))
                gap = middle;
            else
                least = middle + 1;
        }
    }
}

// ---- simpler values ----

static bool try_change(Chooser *c, Scenario *s, size_t i, ScenarioChange x, const GoalSet *want)
{
    Attempt t = chooser_begin_attempt(c, s, 0);

    t.change[i] = x;
    return chooser_accept(c, s, &t, want, NULL);
}

void chooser_prefer_holds(Chooser *c, Scenario *s, const GoalSet *want)
{
    for (size_t i = 0; i < s->changes && chooser_has_effort(c); i++)
        if (s->change[i].kind != SCENARIO_HOLD) {
            const ScenarioChange was = s->change[i];
            ScenarioChange x = was;
            x.kind = SCENARIO_HOLD;
            x.a = was.kind == SCENARIO_COPY ? 1 : was.a;
            if (!try_change(c, s, i, x, want)) {
                x.a = was.kind == SCENARIO_COPY ? 0 : was.b;
                try_change(c, s, i, x, want);
            }
        }
}

static double nearest_whole(double x) { return x < -9e15 || x > 9e15 ? x : (double)(int64_t)(x + (x < 0 ? -0.5 : 0.5)); }

// Replaces an infinity, or another value far beyond what the machine compares with, by one of a usual size, if that is enough.
static bool try_usual_size(Chooser *c, Scenario *s, size_t i, const SearchInput *in, const GoalSet *want)
{
    ScenarioChange x = s->change[i];
    const double sign = x.a < 0 ? -1 : 1;

    if (x.a * sign < UNUSUAL_SIZE)
        return false;
    for (uint32_t n = 0; n < in->constant.n && chooser_has_effort(c); n++)
        for (int units = 1; units >= 0; units--) {
            x.a = in->constant.at[n] + sign * units * search_unit_of(in, in->constant.at[n]);
            if (x.a * sign < UNUSUAL_SIZE && try_change(c, s, i, x, want))
                return true;
        }
    return false;
}

// Rounds the values of holds to few digits, and prefers values within the range.
void chooser_round_values(Chooser *c, Scenario *s, const GoalSet *want)
{
    static const double unit[] = {1e6, 1e5, 1e4, 1e3, 500, 100, 50, 10, 5, 1};
    static const double per[] = {2, 10, 20, 100, 1000, 10000};

    for (size_t i = 0; i < s->changes && chooser_has_effort(c); i++) {
        const SearchInput *in = &c->k->input[c->input_of[s->change[i].var]];
        ScenarioChange x = s->change[i];
        const double a = x.a, size = a < 0 ? -a : a;
        bool done = x.kind != SCENARIO_HOLD || in->type == SM_BOOL;
        if (!done && in->range && (a < in->range->lo || a > in->range->hi)) {
            x.a = a < in->range->lo ? in->range->lo : in->range->hi;
            done = try_change(c, s, i, x, want);
        }
        done = done || try_usual_size(c, s, i, in, want);
        for (size_t u = 0; !done && i < s->changes && u < sizeof unit / sizeof *unit + sizeof per / sizeof *per; u++) {
            const bool is_part = u >= sizeof unit / sizeof *unit;
            const double f = is_part ? per[u - sizeof unit / sizeof *unit] : unit[u];
            if ((!is_part && f > 2 * size) || (is_part && !ir_is_float(in->type)))
                continue;
            x.a = is_part ? nearest_whole(a * f) / f : nearest_whole(a / f) * f;
            done = x.a == a;
            if (!done && (!in->range || (x.a >= in->range->lo && x.a <= in->range->hi)))
                done = try_change(c, s, i, x, want);
        }
    }
}
