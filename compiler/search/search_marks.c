// SPDX-License-Identifier: Apache-2.0
// Snapshots along the scenario that is being simplified.  An attempt differs from it from some change on: its replay resumes at the last snapshot
// before that change, so the steps before are not run again.  Nearly all effort of simplifying is replays, and most attempts change the end.
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    LEAST_SPACING = 32,       // steps between snapshots
    MARK_PART = 16,           // 1 / MARK_PART of the memory of the search is for them
    // An attempt fails if it waits in a state for longer than PATIENCE times the longest wait there of the known scenario, and PATIENCE_MORE steps.
    PATIENCE = 2,
    PATIENCE_MORE = 64
};

static size_t block_size(const Chooser *c)
{
    const SearchWatch *w = c->k->o->watch;

    return (c->f->size + 7) / 8 * 8 + (w ? w->size : 0);
}

void chooser_begin_marks(Chooser *c)
{
    SearchRun *k = c->k;
    const size_t fits = k->memory / MARK_PART / (k->nominal + 1) / 2;

    c->marks = ARENA_NEW(&k->work, SearchMarks);
    c->marks->patience = ARENA_ARRAY(&k->work, uint64_t, k->p->state.n);
    c->marks->most = fits < MOST_MARKS ? (uint32_t)fits : MOST_MARKS;
    for (uint32_t i = 0; i < c->marks->most; i++) {
        c->marks->of[i] = (SearchMark){.block = arena_alloc(&k->work, k->block), .reached = arena_alloc(&k->work, k->goals + 1)};
        c->marks->fresh[i] = (SearchMark){.block = arena_alloc(&k->work, k->block), .reached = arena_alloc(&k->work, k->goals + 1)};
    }
}

void chooser_forget_marks(Chooser *c)
{
    c->marks->is_known = false;
    c->marks->n = 0;
    memset(c->marks->failed, 0, sizeof c->marks->failed);
}

static bool is_same_change(const ScenarioChange *x, const ScenarioChange *y)
{
    return x->step == y->step && x->var == y->var && x->kind == y->kind && x->a == y->a && x->b == y->b && x->source == y->source;
}

// Returns the last step before which a scenario makes the same changes as the known one.
static uint64_t find_difference(const SearchMarks *m, const Scenario *s)
{
    size_t i = 0;
    uint64_t step = s->steps;

    while (i < s->changes && i < m->change.n && is_same_change(&s->change[i], &m->change.at[i]))
        i++;
    if (i < s->changes && s->change[i].step < step)
        step = s->change[i].step;
    if (i < m->change.n && m->change.at[i].step < step)
        step = m->change.at[i].step;
    return step;
}

uint64_t chooser_resume(Chooser *c, const Scenario *s, const GoalSet *want, size_t *next)
{
    SearchMarks *m = c->marks;
    SearchMark *x;
    uint64_t step;

    m->freshes = m->shared = 0;
    m->spacing = LEAST_SPACING;
    if (!m->is_known)
        return 0;
    step = find_difference(m, s);
    while (m->shared < m->n && m->of[m->shared].step < step)
        m->shared++;
    if (m->shared == 0)
        return 0;
    x = &m->of[m->shared - 1];
    memcpy(c->block, x->block, block_size(c));
    flat_clear_counts(c->f);
    for (uint32_t i = 0; i < want->n; i++)
        if (x->reached[i])
            chooser_set_reached(c, want->at[i]);
    c->enters.n = 0;
    for (uint32_t i = 0; i < x->enters; i++)
        vec_push(&c->k->work, &c->enters, m->enter.at[i]);
    memset(c->current, 0, (c->k->inputs + 1) * sizeof *c->current);
    for (*next = 0; *next < s->changes && s->change[*next].step <= x->step; ++*next)
        c->current[c->input_of[s->change[*next].var]] = &s->change[*next];
    return x->step;
}

// Removes every second snapshot of a list, beginning with the first, and returns how many are left.  The removed ones follow them, for reuse.
static uint32_t thin_out(SearchMark *of, uint32_t n)
{
    for (uint32_t i = 1; i < n; i += 2) {
        const SearchMark x = of[i / 2];
        of[i / 2] = of[i];
        of[i] = x;
    }
    return n / 2;
}

void chooser_mark(Chooser *c, uint64_t step, const GoalSet *want)
{
    SearchMarks *m = c->marks;
    const uint64_t last = m->freshes ? m->fresh[m->freshes - 1].step : m->shared ? m->of[m->shared - 1].step : 0;
    SearchMark *x;

    if (m->most < 2 || step < last + m->spacing)
        return;
    if (m->freshes == m->most) {
        m->freshes = thin_out(m->fresh, m->freshes);
        m->spacing *= 2;
    }
    x = &m->fresh[m->freshes++];
    x->step = step;
    x->enters = c->enters.n;
    memcpy(x->block, c->block, block_size(c));
    for (uint32_t i = 0; i < want->n; i++)
        x->reached[i] = chooser_has_reached(c, want->at[i]);
}

// Finds how long the known scenario waits in each state for the next event: a change, a transition, or the end.
static void find_patience(Chooser *c, uint64_t end)
{
    SearchMarks *m = c->marks;
    uint64_t last = 0;
    uint32_t state = c->k->start->number;

    for (uint32_t i = 0; i < c->k->p->state.n; i++)
        m->patience[i] = PATIENCE_MORE;
    for (uint32_t i = 0, j = 1; last < end; ) {
        const bool is_change = i < m->change.n && (j >= m->enter.n || m->change.at[i].step <= m->enter.at[j].step);
        const uint64_t step = is_change ? m->change.at[i++].step : j < m->enter.n ? m->enter.at[j].step : end;
        if (PATIENCE * (step - last) + PATIENCE_MORE > m->patience[state - 1])
            m->patience[state - 1] = PATIENCE * (step - last) + PATIENCE_MORE;
        last = step;
        if (!is_change && j < m->enter.n)
            state = m->enter.at[j++].state;
    }
}

void chooser_keep_marks(Chooser *c, const Scenario *looped)
{
    SearchMarks *m = c->marks;
    Scenario s;

    arena_reset(&c->unrolled);
    s = scenario_unroll(&c->unrolled, looped);
    m->is_known = true;
    m->n = m->shared;
    for (uint32_t i = 0; i < m->freshes && m->most >= 2; i++) {
        SearchMark x;
        if (m->n == m->most)
            m->n = thin_out(m->of, m->n);
        x = m->of[m->n];
        m->of[m->n++] = m->fresh[i];
        m->fresh[i] = x;
    }
    m->freshes = 0;
    m->change.n = m->enter.n = 0;
    for (size_t i = 0; i < s.changes; i++)
        vec_push(&c->k->work, &m->change, s.change[i]);
    for (uint32_t i = 0; i < c->enters.n; i++)
        vec_push(&c->k->work, &m->enter, c->enters.at[i]);
    find_patience(c, s.steps);
}
