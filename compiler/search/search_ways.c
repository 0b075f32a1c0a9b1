// SPDX-License-Identifier: Apache-2.0
// Shorter ways through the states: another beginning for a scenario, and no detours from a state back to it.
#include <stdlib.h>
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    MOST_DETOURS = 32,        // the most detours (ways back to a state) that are tried to be left out
    MOST_DETOUR_ENDS = 256,   // the most pairs of entries of one state that are compared for them
    MOST_WAYS = 4,            // paths to one state that are tried
    MOST_JOINS = 64           // how many of a run's last transitions are tried as the end of a beginning that is replaced by a shorter one
};

// ---- shorter beginnings ----

// Whether an entry is simpler than another one: after fewer changes, or as many and fewer steps.
static bool is_simpler(const SearchRun *k, uint32_t a, uint32_t b)
{
    const SearchNode *x = &k->node.at[a], *y = &k->node.at[b];

    return x->depth != y->depth ? x->depth < y->depth : x->at != y->at ? x->at < y->at : a < b;
}

// Returns the simplest entry of a state that is less simple than `after`; SEARCH_NONE as `after`: the simplest one.  Returns SEARCH_NONE if no
// entry is left.
static uint32_t find_entry_after(const SearchRun *k, uint32_t state, uint32_t after)
{
    uint32_t best = SEARCH_NONE;

    for (uint32_t i = 0; i < k->entries[state - 1]; i++) {
        const uint32_t n = k->entry[(state - 1) * SEARCH_ENTRIES + i].node;
        if ((after == SEARCH_NONE || is_simpler(k, after, n)) && (best == SEARCH_NONE || is_simpler(k, n, best)))
            best = n;
    }
    return best;
}

// The known paths to a state, the simplest ones first.
typedef struct WayList { Scenario at[MOST_WAYS]; uint32_t n; } WayList;

// Lists paths to a state with less than `most` changes: that of a chosen scenario, and those of entries.
static WayList list_ways(Chooser *c, uint32_t state, size_t most)
{
    const Scenario *chosen = &c->way[state - 1];
    uint32_t n = SEARCH_NONE;
    WayList out = {.n = 0};

    if (chosen->init_state && chosen->changes < most)
        out.at[out.n++] = *chosen;
    while (out.n < MOST_WAYS && (n = find_entry_after(c->k, state, n)) != SEARCH_NONE && c->k->node.at[n].depth < most)
        out.at[out.n++] = chooser_scenario_of(c->k, &c->k->work, n);
    return out;
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

// Replaces the beginning of the scenario up to transition i by a known way to the state that it enters.
static bool replace_beginning(Reducer *r, uint32_t i)
{
    Chooser *c = r->c;
    const Scenario from = *r->s;
    size_t before = 0;
    WayList ways;

    while (before < from.changes && from.change[before].step <= r->enter[i].step)
        before++;
    if (before == 0 || r->enter[i].step + 1 > from.steps)
        return false;
    ways = list_ways(c, r->enter[i].state, before);
    for (uint32_t w = 0; w < ways.n && chooser_has_effort(c); w++) {
        Attempt t = join_at(c, &ways.at[w], &from, r->enter[i].step);
        if (chooser_accept(c, r->s, &t, r->want, NULL)) {
            chooser_store_enters(r);
            r->known = ways.at[w].changes;
            return true;
        }
    }
    return false;
}

static bool is_first_visit(const Reducer *r, uint32_t i)
{
    for (uint32_t before = 0; before < i; before++)
        if (r->enter[before].state == r->enter[i].state)
            return false;
    return true;
}

// What a machine has counted is the same where it enters a state for the first time as after a short path to it, so these transitions are tried
// first.
bool chooser_simplify_beginning(Reducer *r)
{
    uint32_t tries = 0;

    if (r->s->loops)
        return false;
    for (int is_first = 1; is_first >= 0; is_first--)
        for (uint32_t i = r->enters; i-- > 1 && tries < MOST_JOINS && chooser_has_effort(r->c); ) {
            if (is_first_visit(r, i) != (is_first == 1))
                continue;
            tries++;
            if (replace_beginning(r, i))
                return true;
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
    Attempt t = chooser_begin_attempt(r->c, s, r->c->k->inputs);
    size_t n = 0;

    chooser_add_anchors(r->c, &t, r->enter, r->enters);
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

bool chooser_leave_out_detours(Reducer *r)
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
                chooser_store_enters(r);
                again = shorter = true;
            }
        }
    }
    return shorter;
}
