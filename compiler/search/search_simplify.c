// SPDX-License-Identifier: Apache-2.0
// Simplifies a scenario: fewer changes, then shorter times and rounder values (search_round.c).  Every step of it is an attempt that is replayed, and
// accepted if the scenario still reaches every wanted goal.
//
// A change that is removed lets the states that follow begin sooner or later.  So an attempt is made first with the changes anchored to the
// entries of their states (SearchAnchor), and then with the changes at their times.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_choose.h"
#include "stdlib/convert.h"

enum {
    BLEND_PARTS = 4,
    MOST_ROUNDS = 3,          // how often all edits are tried, as long as they leave more than one change
    MOST_CONSTANTS = 4,       // values of an input that are tried for its whole time
    MANY_CHANGES = 12         // a scenario with more changes is first simplified by the edits that take few replays
};

// ---- attempts ----

Attempt chooser_begin_attempt(Chooser *c, const Scenario *s, size_t more)
{
    Attempt t = {.s = *s};

    arena_reset(&c->tries);
    t.change = arena_array(&c->tries, s->changes + more + 1, sizeof *t.change);
    if (s->changes)
        memcpy(t.change, s->change, s->changes * sizeof *t.change);
    t.s.change = t.change;
    t.loop = arena_array(&c->tries, s->loops + 1, sizeof *t.loop);
    if (s->loops)
        memcpy(t.loop, s->loop, s->loops * sizeof *t.loop);
    t.s.loop = t.loop;
    return t;
}

static void remove_changes(Attempt *t, size_t i, size_t n)
{
    memmove(t->change + i, t->change + i + n, (t->s.changes - i - n) * sizeof *t->change);
    if (t->anchor)
        memmove(t->anchor + i, t->anchor + i + n, (t->s.changes - i - n) * sizeof *t->anchor);
    t->s.changes -= n;
}

// Removes all but the last of several changes of a variable in one step: only the last one has an effect.
static void remove_overwritten(Scenario *s, ScenarioChange *change)
{
    size_t n = 0;

    for (size_t i = 0; i < s->changes; i++) {
        bool is_overwritten = false;
        for (size_t j = i + 1; j < s->changes && change[j].step == change[i].step; j++)
            is_overwritten |= change[j].var == change[i].var;
        if (!is_overwritten)
            change[n++] = change[i];
    }
    s->changes = n;
}

static bool is_in_loop(const Scenario *s, uint32_t var)
{
    for (size_t i = 0; i < s->changes; i++)
        if (s->change[i].var == var && scenario_loop_at(s, s->change[i].step))
            return true;
    return false;
}

// Removes changes to the value that the input has already, which need no replay: every step has the same inputs as before.
static void remove_idle(const Chooser *c, Scenario *s, ScenarioChange *change)
{
    size_t n = 0;

    for (size_t i = 0; i < s->changes; i++) {
        const SearchInput *in = &c->k->input[c->input_of[change[i].var]];
        const IrVar *v = &c->k->m->var.at[in->at];
        bool is_idle = change[i].kind == SCENARIO_HOLD && change[i].a == sm_cell_to_f64(in->type, v->space == IR_LOCAL ? v->init : 0);
        for (size_t j = 0; j < n; j++)
            if (change[j].var == change[i].var)
                is_idle = change[i].kind == SCENARIO_HOLD && change[j].kind == SCENARIO_HOLD && change[j].a == change[i].a;
        if (!is_idle || in->forced || is_in_loop(s, change[i].var))
            change[n++] = change[i];
    }
    s->changes = n;
}

// Removes loops that repeat nothing, and lets the others begin with their first change.
static void tidy_loops(Scenario *s, ScenarioLoop *loop)
{
    size_t n = 0;

    for (size_t i = 0; i < s->loops; i++) {
        uint64_t first = 0;
        for (size_t j = s->changes; j-- > 0; )
            if (s->change[j].step >= loop[i].from && s->change[j].step < loop[i].from + loop[i].period)
                first = s->change[j].step;
        loop[n] = loop[i];
        loop[n].from = first;
        n += first > 0 && first + loop[i].period < loop[i].to && first + loop[i].period <= s->steps;
    }
    s->loops = n;
}

// Ends a scenario after a step, which the last replay has reached.
static void end_at(Chooser *c, Scenario *s, uint64_t step)
{
    s->steps = step;
    while (s->changes && s->change[s->changes - 1].step > step)
        s->changes--;
    c->end = chooser_end_state(c);
}

void chooser_store_attempt(Chooser *c, Scenario *s, const Attempt *t)
{
    *s = t->s;
    s->change = arena_copy(&c->k->work, t->change, (t->s.changes + 1) * sizeof *t->change);
    s->loop = arena_copy(&c->k->work, t->loop, (t->s.loops + 1) * sizeof *t->loop);
}

static uint64_t mix(uint64_t h, uint64_t x)
{
    h = (h ^ x) * UINT64_C(0x9e3779b97f4a7c15);
    return h ^ h >> 29;
}

// A hash of what an attempt does.
static uint64_t hash_attempt(const Scenario *s, const SearchAnchor *anchor)
{
    uint64_t h = mix(anchor != NULL, s->steps);

    for (size_t i = 0; i < s->changes; i++) {
        const ScenarioChange *x = &s->change[i];
        h = mix(mix(h, sm_cell_from_f64(SM_F64, x->a)), sm_cell_from_f64(SM_F64, x->b));
        h = mix(h, (uint64_t)x->var << 40 ^ (uint64_t)x->kind << 32 ^ x->source);
        h = anchor ? mix(mix(h, anchor[i].enter), anchor[i].wait) : mix(h, x->step);
    }
    for (size_t i = 0; i < s->loops; i++)
        h = mix(mix(mix(h, s->loop[i].from), s->loop[i].period), s->loop[i].to);
    return h;
}

bool chooser_accept(Chooser *c, Scenario *s, Attempt *t, const GoalSet *want, const SearchAnchor *anchor)
{
    const uint64_t hash = hash_attempt(&t->s, anchor);
    uint64_t *failed = &c->marks->failed[hash % FAILED_ATTEMPTS], end;

    if (*failed == hash)
        return false;
    end = chooser_replay(c, c->wanted, &t->s, want, anchor);
    if (end == 0) {
        *failed = hash;
        return false;
    }
    end_at(c, &t->s, end);
    remove_overwritten(&t->s, t->change);
    remove_idle(c, &t->s, t->change);
    tidy_loops(&t->s, t->loop);
    chooser_keep_marks(c, &t->s);
    chooser_store_attempt(c, s, t);
    return true;
}

// ---- fewer changes ----

void chooser_add_anchors(Chooser *c, Attempt *t, const SearchEnter *enter, uint32_t enters)
{
    uint32_t e = 0;

    t->anchor = arena_array(&c->tries, t->s.changes + 2, sizeof *t->anchor);
    for (size_t i = 0; i < t->s.changes; i++) {
        while (e + 1 < enters && enter[e + 1].step < t->change[i].step)
            e++;
        t->anchor[i] = (SearchAnchor){e, t->change[i].step - enter[e].step};
    }
}

void chooser_store_enters(Reducer *r)
{
    r->enter = arena_copy(&r->c->k->work, r->c->enters.at, r->c->enters.n * sizeof *r->enter);
    r->enters = r->c->enters.n;
}

bool chooser_begin_reducer(Reducer *r)
{
    Scenario s = *r->s;

    if (chooser_replay(r->c, r->c->wanted, &s, r->want, NULL) == 0)
        return false;
    chooser_store_enters(r);
    return true;
}

static bool drop_from_attempt(Attempt *t, size_t i, size_t n)
{
    if (i + n > t->s.changes)
        return false;
    remove_changes(t, i, n);
    return true;
}

// Gives change i the value of the next change of its variable, and removes that change.  n is 1.
static bool edit_merge(Attempt *t, size_t i, size_t n)
{
    size_t next = i + n;

    while (next < t->s.changes && t->change[next].var != t->change[i].var)
        next++;
    if (next >= t->s.changes)
        return false;
    t->change[i].kind = t->change[next].kind;
    t->change[i].a = t->change[next].a;
    t->change[i].b = t->change[next].b;
    t->change[i].source = t->change[next].source;
    remove_changes(t, next, 1);
    return true;
}

// Gives the variable of change i the value of this change from the first step on.  n is ignored.
static bool edit_constant(Attempt *t, size_t i, size_t n)
{
    const ScenarioChange x = t->change[i];
    size_t others = 0;

    (void)n;
    for (size_t j = t->s.changes; j-- > 0; )
        if (t->change[j].var == x.var) {
            remove_changes(t, j, 1);
            others++;
        }
    if (others < 2)
        return false;
    memmove(t->change + 1, t->change, t->s.changes * sizeof *t->change);
    memmove(t->anchor + 1, t->anchor, t->s.changes * sizeof *t->anchor);
    t->change[0] = x;
    t->change[0].step = 1;
    t->anchor[0] = (SearchAnchor){0, 1};
    t->s.changes++;
    return true;
}

// Whether the last replay of an attempt has made its changes at the times of the current scenario.
static bool is_on_time(const Attempt *t, const SearchEnter *enter)
{
    for (size_t i = 0; i < t->s.changes; i++)
        if (t->change[i].step != enter[t->anchor[i].enter].step + t->anchor[i].wait)
            return false;
    return true;
}

bool chooser_try_edit(Reducer *r, SearchEdit *edit, size_t i, size_t n)
{
    for (int is_anchored = r->s->loops == 0; is_anchored >= 0 && chooser_has_effort(r->c); is_anchored--) {
        Attempt t = chooser_begin_attempt(r->c, r->s, r->c->k->inputs);
        chooser_add_anchors(r->c, &t, r->enter, r->enters);
        if (!edit(&t, i, n))
            return false;
        t.s.steps += is_anchored ? t.s.steps / 2 + 16 : 0;
        if (chooser_accept(r->c, r->s, &t, r->want, is_anchored ? t.anchor : NULL)) {
            chooser_store_enters(r);
            return true;
        }
        if (is_anchored && is_on_time(&t, r->enter))
            return false;
    }
    return false;
}

// Drops changes from index `from` on: the first half of them or the last, then quarters, and so on.
static bool drop_changes(Reducer *r, size_t from)
{
    bool shorter = false;

    for (size_t n = from < r->s->changes ? (r->s->changes - from + 1) / 2 : 0; n > 0; n /= 2)
        for (size_t end = r->s->changes; end > from && chooser_has_effort(r->c); end -= n < end ? n : end) {
            const size_t first = end > from + n ? end - n : from;
            if (end <= r->s->changes && chooser_try_edit(r, drop_from_attempt, first, end - first))
                shorter = true;
        }
    return shorter;
}

// Gives change i a value between its own and that of the next change of its variable, and removes that change.  n: where it is between them, in parts
// of BLEND_PARTS.  Both of two conditions can be true there.
static bool edit_blend(Attempt *t, size_t i, size_t n)
{
    ScenarioChange *x = &t->change[i];
    size_t next = i + 1;

    while (next < t->s.changes && t->change[next].var != x->var)
        next++;
    if (next >= t->s.changes || x->kind != SCENARIO_HOLD || t->change[next].kind != SCENARIO_HOLD)
        return false;
    x->a += (t->change[next].a - x->a) * (double)n / (double)BLEND_PARTS;
    remove_changes(t, next, 1);
    return true;
}

static bool blend_changes(Reducer *r)
{
    bool shorter = false;

    for (size_t i = 0; i < r->s->changes; i++)
        for (size_t n = 1; n < BLEND_PARTS && i < r->s->changes && chooser_has_effort(r->c); n++) {
            const SearchInput *in = &r->c->k->input[r->c->input_of[r->s->change[i].var]];
            shorter |= in->type != SM_BOOL && chooser_try_edit(r, edit_blend, i, n);
        }
    return shorter;
}

static bool merge_changes(Reducer *r)
{
    bool shorter = false;

    for (size_t i = 0; i < r->s->changes && chooser_has_effort(r->c); i++)
        while (chooser_try_edit(r, edit_merge, i, 1))
            shorter = true;
    return shorter;
}

// Whether an earlier change of the list sets its variable to the same value.
static bool is_repeated(const Scenario *s, size_t i)
{
    for (size_t j = i + 1; j < s->changes; j++)
        if (s->change[j].var == s->change[i].var && s->change[j].kind == s->change[i].kind && s->change[j].a == s->change[i].a)
            return true;
    return false;
}

static bool prefer_constants(Reducer *r)
{
    bool shorter = false;

    for (uint32_t v = 0; v < r->c->k->inputs; v++) {
        uint32_t tried = 0;
        for (size_t i = r->s->changes; i-- > 0 && tried < MOST_CONSTANTS && chooser_has_effort(r->c); ) {
            if (i >= r->s->changes || r->s->change[i].var != r->c->k->input[v].var || is_repeated(r->s, i))
                continue;
            tried++;
            if (chooser_try_edit(r, edit_constant, i, 0)) {
                shorter = true;
                break;
            }
        }
    }
    return shorter;
}

// ---- all of it ----

// Simplifies a scenario of many changes as far as few attempts do: each attempt to remove one takes a replay.
static void shorten_long(Reducer *r)
{
    prefer_constants(r);
    chooser_simplify_beginning(r);
    if (chooser_add_loops(r->c, r->s, r->want))
        chooser_begin_reducer(r);
}

bool chooser_simplify(Chooser *c, Scenario *s, const GoalSet *want)
{
    Reducer r = {.c = c, .s = s, .want = want};
    const uint64_t end = chooser_replay(c, c->wanted, s, want, NULL);
    Attempt start;

    if (end == 0)
        return false;
    end_at(c, s, end);
    start = chooser_begin_attempt(c, s, c->k->inputs);
    remove_idle(c, &start.s, start.change);
    chooser_store_attempt(c, s, &start);
    chooser_keep_marks(c, s);
    chooser_store_enters(&r);
    if (chooser_simplify_beginning(&r))
        drop_changes(&r, r.known);
    if (s->changes > MANY_CHANGES)
        shorten_long(&r);
    for (int round = 0; round < MOST_ROUNDS && s->changes > 1; round++) {
        bool shorter = s->changes > 2 && chooser_simplify_beginning(&r);
        shorter |= s->changes > 2 && chooser_leave_out_detours(&r);
        shorter |= drop_changes(&r, 0);
        shorter |= prefer_constants(&r);
        shorter |= merge_changes(&r);
        shorter |= blend_changes(&r);
        shorter |= chooser_follow_outputs(&r);
        if (!shorter)
            break;
    }
    if (chooser_add_loops(c, s, want) && chooser_begin_reducer(&r)) {
        prefer_constants(&r);
        merge_changes(&r);
        chooser_follow_outputs(&r);
    }
    if (chooser_extend_loops(c, s, want))
        chooser_begin_reducer(&r);
    drop_changes(&r, 0);
    chooser_shorten_waits(c, s, want);
    chooser_round_periods(c, s, want);
    chooser_prefer_holds(c, s, want);
    chooser_round_values(c, s, want);
    if (chooser_begin_reducer(&r))
        drop_changes(&r, 0);
    return true;
}
