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
    MOST_ROUNDS = 3,          // how often all edits are tried, as long as they leave more than one change
    MOST_CONSTANTS = 4,       // values of an input that are tried for its whole time
    MANY_CHANGES = 12,        // a scenario with more changes is first simplified by the edits that take few replays
    MOST_DETOURS = 32,        // the most detours (ways back to a state) that are tried to be left out
    MOST_DETOUR_ENDS = 256,   // the most pairs of entries of one state that are compared for them
    MOST_JOINS = 64           // how many of a run's last transitions are tried as the end of a beginning that is replaced by a shorter one
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

static Attempt begin_attempt(Chooser *c, const Scenario *s) { return chooser_begin_attempt(c, s, c->k->inputs); }

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

// Adds to an attempt when its changes are due after the entries of `enter`, which a replay of the same changes has recorded.
static void add_anchors(Chooser *c, Attempt *t, const SearchEnter *enter, uint32_t enters)
{
    uint32_t e = 0;

    t->anchor = arena_array(&c->tries, t->s.changes + 1, sizeof *t->anchor);
    for (size_t i = 0; i < t->s.changes; i++) {
        while (e + 1 < enters && enter[e + 1].step < t->change[i].step)
            e++;
        t->anchor[i] = (SearchAnchor){e, t->change[i].step - enter[e].step};
    }
}

typedef struct Reducer {
    Chooser *c;
    Scenario *s;
    const GoalSet *want;
    SearchEnter *enter;       // the transitions of a replay of *s
    uint32_t enters;
} Reducer;

// Stores the transitions of the last replay, which was one of *s.
static void store_enters(Reducer *r)
{
    r->enter = arena_copy(&r->c->k->work, r->c->enters.at, r->c->enters.n * sizeof *r->enter);
    r->enters = r->c->enters.n;
}

static bool record_enters(Reducer *r)
{
    Scenario s = *r->s;

    if (chooser_replay(r->c, r->c->wanted, &s, r->want, NULL) == 0)
        return false;
    store_enters(r);
    return true;
}

// Edits an attempt so that it has fewer changes.  Returns false if the edit does not apply to this scenario.
typedef bool Edit(Attempt *t, size_t i, size_t n);

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

// Tries an edit with anchored changes, and with changes at their times if that is another run.  A loop has its own times, so with one no change
// is anchored.
static bool try_edit(Reducer *r, Edit *edit, size_t i, size_t n)
{
    for (int is_anchored = r->s->loops == 0; is_anchored >= 0 && chooser_has_effort(r->c); is_anchored--) {
        Attempt t = begin_attempt(r->c, r->s);
        add_anchors(r->c, &t, r->enter, r->enters);
        if (!edit(&t, i, n))
            return false;
        t.s.steps += is_anchored ? t.s.steps / 2 + 16 : 0;
        if (chooser_accept(r->c, r->s, &t, r->want, is_anchored ? t.anchor : NULL)) {
            store_enters(r);
            return true;
        }
        if (is_anchored && is_on_time(&t, r->enter))
            return false;
    }
    return false;
}

static bool drop_changes(Reducer *r)
{
    bool shorter = false;

    for (size_t n = r->s->changes / 2; n > 0; n /= 2)
        for (size_t i = r->s->changes; i-- > 0 && chooser_has_effort(r->c); )
            if (i + n <= r->s->changes && try_edit(r, drop_from_attempt, i, n))
                shorter = true;
    return shorter;
}

static bool merge_changes(Reducer *r)
{
    bool shorter = false;

    for (size_t i = 0; i < r->s->changes && chooser_has_effort(r->c); i++)
        while (try_edit(r, edit_merge, i, 1))
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
            if (try_edit(r, edit_constant, i, 0)) {
                shorter = true;
                break;
            }
        }
    }
    return shorter;
}

// ---- shorter beginnings ----

// Returns the entry of a state with the fewest changes; SEARCH_NONE: none is left.
static uint32_t find_simplest(const SearchRun *k, uint32_t state)
{
    uint32_t best = SEARCH_NONE;

    for (uint32_t i = 0; i < k->entries[state - 1]; i++) {
        const uint32_t n = k->entry[(state - 1) * SEARCH_ENTRIES + i].node;
        if (best == SEARCH_NONE || k->node.at[n].depth < k->node.at[best].depth || (k->node.at[n].depth == k->node.at[best].depth && k->node.at[n].at < k->node.at[best].at))
            best = n;
    }
    return best;
}

// Finds the simplest known way to a state: that of a chosen scenario, or that of an entry.  Returns false if it has `most` changes or more.
static bool find_scenario_to(Chooser *c, uint32_t state, size_t most, Scenario *way)
{
    const uint32_t node = find_simplest(c->k, state);
    const Scenario *chosen = &c->way[state - 1];

    if (chosen->init_state && chosen->changes < most) {
        *way = *chosen;
        return true;
    }
    if (node == SEARCH_NONE || c->k->node.at[node].depth >= most)
        return false;
    *way = chooser_scenario_of(c->k, &c->k->work, node);
    return true;
}

// Returns the first `step` steps of a scenario, which make its first `changes` changes.
static Scenario cut_scenario(Chooser *c, const Scenario *s, uint64_t step, size_t changes)
{
    Scenario out = {.init_state = s->init_state, .delta_t = s->delta_t, .steps = step, .change = s->change, .changes = changes};
    ScenarioLoop *loop = arena_array(&c->k->work, s->loops + 1, sizeof *loop);

    for (size_t i = 0; i < s->loops; i++)
        if (s->loop[i].from + s->loop[i].period <= step) {
            loop[out.loops] = s->loop[i];
            loop[out.loops].to = s->loop[i].to > step ? step + 1 : s->loop[i].to;
            out.loops++;
        }
    out.loop = loop;
    return out;
}

void chooser_keep_ways(Chooser *c, const Scenario *s)
{
    size_t before = 0;

    for (uint32_t i = 1; i < c->enters.n; i++) {
        const SearchEnter *e = &c->enters.at[i];
        Scenario *way = &c->way[e->state - 1];
        while (before < s->changes && s->change[before].step <= e->step)
            before++;
        if (!way->init_state || before < way->changes)
            *way = cut_scenario(c, s, e->step, before);
    }
}

// Returns the last change of a variable at or before a step; NULL: none.
static const ScenarioChange *change_at(const Scenario *s, uint32_t var, uint64_t step)
{
    const ScenarioChange *out = NULL;

    for (size_t i = 0; i < s->changes && s->change[i].step <= step; i++)
        out = s->change[i].var == var ? &s->change[i] : out;
    return out;
}

// Joins a way and what `s` does after step `after`, where it enters the same state.
static Attempt join_at(Chooser *c, const Scenario *way, const Scenario *s, uint64_t after)
{
    SearchRun *k = c->k;
    const uint64_t begin = way->steps + 1;
    size_t n = way->changes;
    Attempt t = {.anchor = NULL};
    Scenario unrolled;

    arena_reset(&c->tries);
    unrolled = scenario_unroll(&c->tries, way);
    t.change = arena_array(&c->tries, n + s->changes + k->inputs + 1, sizeof *t.change);
    if (n)
        memcpy(t.change, way->change, n * sizeof *t.change);
    for (uint32_t i = 0; i < k->inputs; i++) {
        const ScenarioChange *now = change_at(s, k->input[i].var, after + 1), *was = change_at(&unrolled, k->input[i].var, begin);
        ScenarioChange x = now ? *now : (ScenarioChange){.var = k->input[i].var};
        if ((!now && !was) || (now && was && now->kind == SCENARIO_HOLD && was->kind == SCENARIO_HOLD && now->a == was->a))
            continue;
        x.step = begin;
        t.change[n++] = x;
    }
    for (size_t i = 0; i < s->changes; i++)
        if (s->change[i].step > after + 1) {
            t.change[n] = s->change[i];
            t.change[n++].step += begin - (after + 1);
        }
    t.loop = arena_array(&c->tries, way->loops + 1, sizeof *t.loop);
    if (way->loops)
        memcpy(t.loop, way->loop, way->loops * sizeof *t.loop);
    t.s = (Scenario){s->init_state, s->delta_t, begin + s->steps - (after + 1), t.change, n, t.loop, way->loops};
    return t;
}

// Replaces the beginning of a scenario, up to where it enters a state, by the simplest known way to that state.
static bool simplify_beginning(Reducer *r)
{
    Chooser *c = r->c;
    const Scenario from = *r->s;
    uint32_t tries = 0;

    if (from.loops)
        return false;
    for (uint32_t i = r->enters; i-- > 1 && tries < MOST_JOINS && chooser_has_effort(c); ) {
        size_t before = 0;
        Scenario way;
        Attempt t;
        while (before < from.changes && from.change[before].step <= r->enter[i].step)
            before++;
        if (r->enter[i].step + 1 > from.steps || !find_scenario_to(c, r->enter[i].state, before, &way))
            continue;
        tries++;
        t = join_at(c, &way, &from, r->enter[i].step);
        if (chooser_accept(c, r->s, &t, r->want, NULL)) {
            store_enters(r);
            return true;
        }
    }
    return false;
}

// ---- detours ----

// Two entries of the same state, and how many changes are made between them.
typedef struct Detour { uint32_t first, next; size_t changes; } Detour;

static int compare_detours(const void *a, const void *b)
{
    const Detour *x = a, *y = b;

    if (x->changes != y->changes)
        return x->changes > y->changes ? -1 : 1;
    if (x->first != y->first)
        return x->first < y->first ? -1 : 1;
    return x->next < y->next ? -1 : x->next > y->next;
}

// Lists the detours of the scenario, those with most changes first.
static Detour *list_detours(const Reducer *r, uint32_t *n)
{
    Arena *arena = &r->c->k->work;
    size_t *before = arena_array(arena, r->enters + 1, sizeof *before);
    VEC(Detour) out = {NULL, 0, 0};

    for (uint32_t i = 0; i < r->enters && i < MOST_DETOUR_ENDS; i++) {
        before[i] = i ? before[i - 1] : 0;
        while (before[i] < r->s->changes && r->s->change[before[i]].step <= r->enter[i].step)
            before[i]++;
        for (uint32_t a = 0; a < i; a++)
            if (r->enter[a].state == r->enter[i].state && before[i] > before[a]) {
                const Detour d = {a, i, before[i] - before[a]};
                vec_push(arena, &out, d);
            }
    }
    if (out.n)
        qsort(out.at, out.n, sizeof *out.at, compare_detours);
    *n = out.n;
    return out.at;
}

// Leaves a detour out: what follows its end begins at its first entry, with the same inputs.
static Attempt leave_out(Reducer *r, const Detour *d)
{
    const Scenario *s = r->s;
    const uint64_t first = r->enter[d->first].step, next = r->enter[d->next].step;
    Attempt t = begin_attempt(r->c, s);
    size_t n = 0;

    add_anchors(r->c, &t, r->enter, r->enters);
    for (size_t i = 0; i < s->changes; i++) {
        bool is_last = true;                              // no later change of the detour is one of the same input
        for (size_t j = i + 1; j < s->changes && s->change[j].step <= next; j++)
            is_last &= s->change[j].var != s->change[i].var;
        if (s->change[i].step > first && s->change[i].step <= next && !is_last)
            continue;
        t.change[n] = s->change[i];
        t.anchor[n] = t.anchor[i];
        if (s->change[i].step > next) {
            t.change[n].step -= next - first;
            t.anchor[n].enter -= d->next - d->first;
        } else if (s->change[i].step > first) {
            t.change[n].step = first + 1;
            t.anchor[n] = (SearchAnchor){d->first, 1};
        }
        n++;
    }
    t.s.changes = n;
    t.s.steps += 16 - (next - first);
    return t;
}

// Leaves out what the scenario does between two entries of the same state, if that still reaches the goals.
static bool leave_out_detours(Reducer *r)
{
    bool shorter = false, again = r->s->loops == 0;

    while (again) {
        uint32_t n = 0;
        const Detour *d = list_detours(r, &n);
        again = false;
        for (uint32_t i = 0; i < n && i < MOST_DETOURS && !again && chooser_has_effort(r->c); i++) {
            const size_t was = r->s->changes;
            Attempt t = leave_out(r, &d[i]);
            if (t.s.changes < was && chooser_accept(r->c, r->s, &t, r->want, t.anchor)) {
                store_enters(r);
                again = shorter = true;
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
    simplify_beginning(r);
    if (chooser_add_loops(r->c, r->s, r->want))
        record_enters(r);
}

bool chooser_simplify(Chooser *c, Scenario *s, const GoalSet *want)
{
    Reducer r = {c, s, want, NULL, 0};
    const uint64_t end = chooser_replay(c, c->wanted, s, want, NULL);
    Attempt start;

    if (end == 0)
        return false;
    end_at(c, s, end);
    start = begin_attempt(c, s);
    remove_idle(c, &start.s, start.change);
    chooser_store_attempt(c, s, &start);
    chooser_keep_marks(c, s);
    store_enters(&r);
    if (s->changes > MANY_CHANGES)
        shorten_long(&r);
    for (int round = 0; round < MOST_ROUNDS && s->changes > 1; round++) {
        bool shorter = s->changes > 2 && simplify_beginning(&r);
        shorter |= s->changes > 2 && leave_out_detours(&r);
        shorter |= drop_changes(&r);
        shorter |= prefer_constants(&r);
        shorter |= merge_changes(&r);
        if (!shorter)
            break;
    }
    if (chooser_add_loops(c, s, want) && record_enters(&r)) {
        prefer_constants(&r);
        merge_changes(&r);
    }
    if (chooser_extend_loops(c, s, want))
        record_enters(&r);
    drop_changes(&r);
    chooser_shorten_waits(c, s, want);
    chooser_round_periods(c, s, want);
    chooser_prefer_holds(c, s, want);
    chooser_round_values(c, s, want);
    if (record_enters(&r))
        drop_changes(&r);
    return true;
}
