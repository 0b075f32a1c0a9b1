// SPDX-License-Identifier: Apache-2.0
// Replaces changes that a scenario makes again and again by a loop (ScenarioLoop): a count that has to reach a limit, retries, pulses.
//
// 1. Changes that are equal in several rounds, with equal times between them, become a loop that makes the same changes in the same steps.
// 2. A run that enters a state several times goes around.  What it does from one entry to a later one can be done again instead of what the
//    scenario does there, until the goal is reached or up to a last entry, from which it goes on as before.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    MOST_BODY = 12,           // the most changes that a loop repeats
    LEAST_SAVED = 2,          // a loop has to replace at least so many changes
    SOME = 3,                 // how many entries of a state are tried as RoundTry.first, as `next`, and as `last`
    MOST_MORE = 2,            // the most rounds that a loop makes in place of changes after it
    MOST_TRIES = 48,          // loops that are tried
    MOST_UNROLLED = 1 << 16   // changes of a loop, in all its rounds together
};

// Whether n changes can be the body of a loop: they only hold values, and no loop contains them yet.
static bool can_repeat(const Chooser *c, const Scenario *s, size_t from, size_t n)
{
    if (n < 2 || n > MOST_BODY)
        return false;
    for (size_t i = from; i < from + n; i++)
        if (s->change[i].kind != SCENARIO_HOLD || c->k->input[c->input_of[s->change[i].var]].forced || scenario_loop_at(s, s->change[i].step))
            return false;
    return true;
}

// Inserts a loop at its place.
static void insert_loop(Attempt *t, ScenarioLoop l)
{
    size_t at = t->s.loops++;

    for (; at > 0 && t->loop[at - 1].from > l.from; at--)
        t->loop[at] = t->loop[at - 1];
    t->loop[at] = l;
}

// ---- equal rounds ----

// Returns how many changes from index i on repeat the first n of them, at equal distances in steps; 0 if fewer than 2 n do.
static size_t count_equal(const Chooser *c, const Scenario *s, size_t i, size_t n)
{
    size_t m = n;

    if (i + 2 * n > s->changes || !can_repeat(c, s, i, n) || s->change[i + n].step == s->change[i].step)
        return 0;
    for (; i + m < s->changes; m++) {
        const ScenarioChange *x = &s->change[i + m], *y = &s->change[i + m - n];
        if (x->var != y->var || x->kind != y->kind || x->a != y->a || x->step - y->step != s->change[i + n].step - s->change[i].step)
            break;
    }
    while (m >= 2 * n && i + m < s->changes && s->change[i + m].step == s->change[i + m - 1].step)
        m--;
    return m >= 2 * n ? m : 0;
}

// Replaces the repeated changes whose loop saves most changes by that loop.  The run stays the same.  Returns false if no loop saves at least
// LEAST_SAVED changes.
static bool join_most_equal(Chooser *c, Scenario *s)
{
    size_t from = 0, length = 0, most = 0, saved = LEAST_SAVED - 1;
    ScenarioLoop l;
    Attempt t;

    for (size_t n = 2; n <= MOST_BODY; n++)
        for (size_t i = 0; i + 2 * n <= s->changes; i++) {
            const size_t m = count_equal(c, s, i, n);
            if (m > n + saved) {
                from = i, length = n, most = m;
                saved = m - n;
            }
        }
    if (most == 0)
        return false;
    l.from = s->change[from].step;
    l.period = s->change[from + length].step - l.from;
    l.to = s->change[from + most - length].step + l.period;               // the step in which the next round would begin
    if (from + most < s->changes && s->change[from + most].step < l.to)
        l.to = s->change[from + most].step;
    t = chooser_begin_attempt(c, s, 0);
    t.s.changes -= most - length;
    memmove(t.change + from + length, s->change + from + most, (s->changes - from - most) * sizeof *t.change);
    insert_loop(&t, l);
    chooser_store_attempt(c, s, &t);
    return true;
}

bool chooser_join_equal(Chooser *c, Scenario *s)
{
    bool joined = false;

    while (c->k->o->loops && join_most_equal(c, s))
        joined = true;
    return joined;
}

// ---- going around ----

// A loop that could be tried: it repeats the changes from transition `first` up to transition `next`, and replaces those up to transition `last`;
// last 0: all until the goal is reached.  These three are indices into RoundTries.enter.  times: number of rounds if `last` is not 0; left: number of
// changes of the scenario with the loop.
typedef struct RoundTry { uint32_t first, next, last, times; size_t left; } RoundTry;

typedef struct RoundTries {
    Chooser *c;
    const Scenario *s;
    SearchEnter *enter;       // the transitions of a replay
    uint32_t enters;
    size_t *before;           // by index in `enter`: number of changes that are made before the step that follows the transition
    VEC(RoundTry) round;
} RoundTries;

// Whether no loop of the scenario overlaps the steps from `from` to `to`.
static bool is_free(const Scenario *s, uint64_t from, uint64_t to)
{
    for (size_t i = 0; i < s->loops; i++)
        if (s->loop[i].from < to && s->loop[i].to > from)
            return false;
    return true;
}

// Adds a way to shorten the scenario: to repeat the changes between two steps as a loop, instead of those that follow.
static void add_round(RoundTries *r, const uint32_t *at, uint32_t first, uint32_t next, uint32_t last)
{
    const size_t begin = r->before[at[first]], end = r->before[at[next]], after = last ? r->before[at[last]] : r->s->changes;
    const RoundTry x = {at[first], at[next], last ? at[last] : 0, last ? (last - first) / (next - first) : 0, r->s->changes - (after - end)};

    if (after - end >= LEAST_SAVED && can_repeat(r->c, r->s, begin, end - begin) &&
        is_free(r->s, r->enter[at[first]].step + 1, last ? r->enter[at[last]].step + 1 : r->s->steps + 1))
        vec_push(&r->c->k->work, &r->round, x);
}

// Adds the rounds from one entry of a state to another.
static void add_rounds(RoundTries *r, uint32_t state)
{
    uint32_t *at = ARENA_ARRAY(&r->c->k->work, uint32_t, r->enters + 1), n = 0;

    for (uint32_t i = 0; i < r->enters; i++)
        if (r->enter[i].state == state)
            at[n++] = i;
    for (uint32_t first = 0; first < SOME && first < n; first++)
        for (uint32_t next = first + 1; next <= first + SOME && next < n; next++) {
            add_round(r, at, first, next, 0);
            for (uint32_t last = n; last-- > next + 1 && last + SOME >= n; )
                add_round(r, at, first, next, last);
        }
}

static int compare_rounds(const void *a, const void *b)
{
    const RoundTry *x = a, *y = b;

    if (x->left != y->left)
        return x->left < y->left ? -1 : 1;
    if (x->first != y->first)
        return x->first < y->first ? -1 : 1;
    if (x->next != y->next)
        return x->next < y->next ? -1 : 1;
    return x->last < y->last ? -1 : x->last > y->last;
}

// Returns the scenario with a loop in place of the rounds after the first one.
static Attempt repeat_round(RoundTries *r, const RoundTry *x)
{
    const Scenario *s = r->s;
    const uint64_t first = r->enter[x->first].step, period = r->enter[x->next].step - first;
    ScenarioLoop l = {first + 1, period, first + 1 + x->times * period};
    const size_t end = r->before[x->next], after = x->last ? r->before[x->last] : s->changes;
    Attempt t = chooser_begin_attempt(r->c, s, 0);

    memmove(t.change + end, s->change + after, (s->changes - after) * sizeof *t.change);
    t.s.changes -= after - end;
    if (x->last) {
        const uint64_t was = r->enter[x->last].step + 1;              // the scenario's step after the replaced changes: it moves to l.to
        for (size_t i = end; i < t.s.changes; i++)
            t.change[i].step = t.change[i].step - was + l.to;
        for (size_t i = 0; i < t.s.loops; i++)
            if (t.loop[i].from >= was) {
                t.loop[i].from = t.loop[i].from - was + l.to;
                t.loop[i].to = t.loop[i].to - was + l.to;
            }
        t.s.steps = t.s.steps - was + l.to;
    } else {
        t.s.steps += t.s.steps / 2 + 16 * period;
        l.to = t.s.steps + 1;
    }
    if ((l.to - l.from) / period * (end - r->before[x->first]) > MOST_UNROLLED)
        t.s.steps = 0;
    insert_loop(&t, l);
    return t;
}

static bool replace_by_loops(Chooser *c, Scenario *s, const GoalSet *want)
{
    RoundTries r = {.c = c, .s = s};
    Scenario copy = *s;

    if (s->changes < 2 + LEAST_SAVED || chooser_replay(c, c->wanted, &copy, want, NULL) == 0)
        return false;
    r.enter = arena_copy(&c->k->work, c->enters.at, c->enters.n * sizeof *r.enter);
    r.enters = c->enters.n;
    r.before = arena_array(&c->k->work, r.enters + 1, sizeof *r.before);
    for (uint32_t i = 0; i < r.enters; i++)
        while (r.before[i] < s->changes && s->change[r.before[i]].step <= r.enter[i].step)
            r.before[i]++;
    for (uint32_t state = 1; state <= c->k->p->state.n; state++)
        add_rounds(&r, state);
    if (r.round.n)
        qsort(r.round.at, r.round.n, sizeof *r.round.at, compare_rounds);
    for (uint32_t i = 0; i < r.round.n && i < MOST_TRIES && chooser_has_effort(c); i++) {
        Attempt t = repeat_round(&r, &r.round.at[i]);
        if (t.s.steps && chooser_accept(c, s, &t, want, NULL))
            return true;
    }
    return false;
}

// ---- loops that begin sooner ----

// Returns the scenario whose loop n begins at an entry of its state that is `less` steps earlier, in place of the changes until then, and makes
// `more` rounds more.
static Attempt begin_loop_sooner(Chooser *c, const Scenario *s, size_t n, uint64_t less, uint64_t more)
{
    const ScenarioLoop *l = &s->loop[n];
    const bool is_endless = l->to > s->steps;
    const uint64_t later = more * l->period;
    Attempt t = chooser_begin_attempt(c, s, 0);
    size_t changes = 0, loops = 0;

    for (size_t i = 0; i < s->changes; i++) {
        const uint64_t step = s->change[i].step;
        if (step >= l->from - less && step < l->from)
            continue;
        t.change[changes] = s->change[i];
        t.change[changes++].step = step < l->from ? step : step < l->to ? step - less : step - less + later;
    }
    for (size_t i = 0; i < s->loops; i++) {
        const bool is_after = i > n;
        if (i < n && s->loop[i].to > l->from - less)
            continue;
        t.loop[loops] = s->loop[i];
        if (i >= n) {
            t.loop[loops].from += (is_after ? later : 0) - less;
            t.loop[loops].to += later - less;
        }
        loops++;
    }
    t.s.changes = changes;
    t.s.loops = loops;
    t.s.steps += later - less;
    if (is_endless) {
        t.s.steps += t.s.steps / 2 + 16 * l->period;
        t.loop[loops - 1].to = t.s.steps + 1;
    }
    return t;
}

// Tries to begin a loop at an earlier entry of the state in which it begins: what leads to it can be a round that differs a little.
static bool extend_loop(Chooser *c, Scenario *s, size_t n, const GoalSet *want)
{
    Scenario copy = *s;
    const uint64_t from = s->loop[n].from;
    SearchEnter *enter;
    uint32_t last = 0;

    if (chooser_replay(c, c->wanted, &copy, want, NULL) == 0)
        return false;
    enter = arena_copy(&c->k->work, c->enters.at, c->enters.n * sizeof *enter);
    while (last + 1 < c->enters.n && enter[last + 1].step < from)
        last++;
    for (uint32_t i = 0, tries = 0; i < last && tries < SOME; i++) {
        if (enter[i].state != enter[last].state)
            continue;
        tries++;
        for (uint64_t more = 0; more <= SOME && chooser_has_effort(c); more++) {
            const uint64_t less = enter[last].step - enter[i].step;
            Attempt t = begin_loop_sooner(c, s, n, less, more);
            if (t.s.changes < s->changes && chooser_accept(c, s, &t, want, NULL))
                return true;
            if (s->loop[n].to > s->steps)
                break;
        }
    }
    return false;
}

// ---- loops that end later ----

// Returns the scenario whose loop n makes `more` rounds more in place of the `less` changes after it.
static Attempt end_loop_later(Chooser *c, const Scenario *s, size_t n, size_t after, size_t less, uint64_t more)
{
    const ScenarioLoop *l = &s->loop[n];
    const uint64_t whole = (l->to - l->from + l->period - 1) / l->period * l->period, to = l->from + whole + more * l->period;
    const uint64_t was = after + less < s->changes ? s->change[after + less].step : s->steps;
    Attempt t = chooser_begin_attempt(c, s, 0);

    memmove(t.change + after, t.change + after + less, (t.s.changes - after - less) * sizeof *t.change);
    t.s.changes -= less;
    for (size_t i = after; i < t.s.changes; i++)
        t.change[i].step = t.change[i].step - was + to;
    for (size_t i = n + 1; i < t.s.loops; i++) {
        t.loop[i].from = t.loop[i].from - was + to;
        t.loop[i].to = t.loop[i].to - was + to;
    }
    t.loop[n].to = to;
    t.s.steps = t.s.steps > was ? t.s.steps - was + to : to;
    return t;
}

// Tries to repeat a loop in place of changes after it, up to its next one: they can be a round that differs a little.
static bool prolong_loop(Chooser *c, Scenario *s, size_t n, const GoalSet *want)
{
    size_t after = 0, end;

    while (after < s->changes && s->change[after].step < s->loop[n].to)
        after++;
    for (end = after; end < s->changes && (n + 1 == s->loops || s->change[end].step < s->loop[n + 1].from); end++) { }
    for (size_t less = end - after; less > 0; less--)
        for (uint64_t more = 1; more <= MOST_MORE && chooser_has_effort(c); more++) {
            Attempt t = end_loop_later(c, s, n, after, less, more);
            if (chooser_accept(c, s, &t, want, NULL))
                return true;
        }
    return false;
}

bool chooser_extend_loops(Chooser *c, Scenario *s, const GoalSet *want)
{
    bool shorter = false;

    for (size_t n = 0; n < s->loops && chooser_has_effort(c); n++)
        while (n < s->loops && extend_loop(c, s, n, want))
            shorter = true;
    for (size_t n = 0; n < s->loops && chooser_has_effort(c); n++)
        while (n < s->loops && prolong_loop(c, s, n, want))
            shorter = true;
    return shorter;
}

bool chooser_add_loops(Chooser *c, Scenario *s, const GoalSet *want)
{
    bool added = false;

    while (c->k->o->loops && chooser_has_effort(c) && replace_by_loops(c, s, want))
        added = true;
    return chooser_join_equal(c, s) || added;
}

// ---- round periods ----

// Gives a loop another period, and as many rounds.  In a shorter one all changes come sooner.
static Attempt change_period(Chooser *c, const Scenario *s, size_t n, uint64_t period)
{
    const ScenarioLoop *l = &s->loop[n];
    const uint64_t rounds = (l->to - l->from + l->period - 1) / l->period, more = l->from + rounds * period - l->to;     // modulo 2^64
    Attempt t = chooser_begin_attempt(c, s, 0);

    for (size_t i = 0; i < t.s.changes; i++)
        if (t.change[i].step >= l->to)
            t.change[i].step += more;
        else if (t.change[i].step > l->from && period < l->period)
            t.change[i].step = l->from + (t.change[i].step - l->from) * period / l->period;
    for (size_t i = n + 1; i < t.s.loops; i++) {
        t.loop[i].from += more;
        t.loop[i].to += more;
    }
    t.loop[n].period = period;
    t.loop[n].to += more;
    t.s.steps = l->to > s->steps ? t.loop[n].to : s->steps + more;
    return t;
}

// Gives loop n of the scenario another period, in steps, if the scenario still reaches the goals in `want`.
static bool try_loop_period(Chooser *c, Scenario *s, size_t n, uint64_t period, const GoalSet *want)
{
    Attempt t = change_period(c, s, n, period);

    return chooser_accept(c, s, &t, want, NULL);
}

void chooser_round_periods(Chooser *c, Scenario *s, const GoalSet *want)
{
    static const uint64_t unit[] = {10000, 5000, 1000, 500, 100, 50, 20, 10, 5};

    for (size_t n = 0; n < s->loops && chooser_has_effort(c); n++) {
        while (n < s->loops && s->loop[n].period >= 4 && chooser_has_effort(c) && try_loop_period(c, s, n, s->loop[n].period / 2, want)) { }
        for (size_t i = 0; i < sizeof unit / sizeof *unit && chooser_has_effort(c) && n < s->loops; i++) {
            const uint64_t was = s->loop[n].period, period = (was + unit[i] - 1) / unit[i] * unit[i];
            if (period == was || (period <= was + was / 2 && try_loop_period(c, s, n, period, want)))
                break;
        }
    }
}
