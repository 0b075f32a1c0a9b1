// SPDX-License-Identifier: Apache-2.0
// Inputs that follow an output, as the feedback of a valve follows its command, or that alternate: one change in place of several.
//
// An acknowledgement that is set and reset in each round of a handshake takes two changes a round, and a loop repeats only rounds of equal length.
// As a copy of the request it is one change.
#include <string.h>

#include "compiler/search/search_choose.h"

enum {
    FOLLOW_CHANGES = 2,       // only scenarios with more changes are tried
    ALTERNATE_CHANGES = 2,    // an input with more changes can alternate
    MOST_STARTS = 3           // the first changes of the input that are tried as the first one that is replaced
};

// What replaces the changes of an input.
typedef struct Pattern {
    ScenarioChange change;    // `step` is set by the attempt
    size_t first;             // changes of the input before the one with this index, counted among its own, remain
    bool from_start;          // the pattern begins in step 1, not in the step of the first change that it replaces
} Pattern;

static size_t count_changes(const Scenario *s, uint32_t var)
{
    size_t n = 0;

    for (size_t i = 0; i < s->changes; i++)
        n += s->change[i].var == var;
    return n;
}

// Removes the changes that the pattern replaces.  Sets its step and *anchor to those of the first of them; in a loop, to the step before the loop.
// Returns false if it replaces nothing.
static bool remove_replaced(Attempt *t, const Pattern *p, ScenarioChange *x, SearchAnchor *anchor)
{
    size_t seen = 0, n = 0;
    bool any = false;

    for (size_t i = 0; i < t->s.changes; i++) {
        if (t->change[i].var != x->var || seen++ < p->first) {
            t->change[n] = t->change[i];
            t->anchor[n++] = t->anchor[i];
        } else if (!any) {
            const ScenarioLoop *l = scenario_loop_at(&t->s, t->change[i].step);
            any = true;
            x->step = l ? l->from - 1 : t->change[i].step;
            *anchor = t->anchor[i];
        }
    }
    t->s.changes = n;
    return any && x->step > 0;
}

// Puts the pattern in place of the changes of its variable.
static bool put_pattern(Attempt *t, const Pattern *p)
{
    ScenarioChange x = p->change;
    SearchAnchor anchor = {0, 1};
    size_t at = 0;

    if (!remove_replaced(t, p, &x, &anchor))
        return false;
    if (p->from_start) {
        x.step = 1;
        anchor = (SearchAnchor){0, 1};
    }
    while (at < t->s.changes && t->change[at].step <= x.step)
        at++;
    memmove(t->change + at + 1, t->change + at, (t->s.changes - at) * sizeof *t->change);
    memmove(t->anchor + at + 1, t->anchor + at, (t->s.changes - at) * sizeof *t->anchor);
    t->change[at] = x;
    t->anchor[at] = anchor;
    t->s.changes++;
    return !scenario_loop_at(&t->s, x.step);
}

static bool try_pattern(Reducer *r, const Pattern *p)
{
    for (int is_anchored = r->s->loops == 0; is_anchored >= 0 && chooser_has_effort(r->c); is_anchored--) {
        Attempt t = chooser_begin_attempt(r->c, r->s, 1);
        chooser_add_anchors(r->c, &t, r->enter, r->enters);
        if (!put_pattern(&t, p))
            return false;
        t.s.steps += is_anchored ? t.s.steps / 2 + 16 : 0;
        if (chooser_accept(r->c, r->s, &t, r->want, is_anchored ? t.anchor : NULL)) {
            chooser_store_enters(r);
            return true;
        }
    }
    return false;
}

// Tries a pattern from the start, and from the first changes of the input on, as long as it saves a change.
static bool try_starts(Reducer *r, ScenarioChange x)
{
    const size_t n = count_changes(r->s, x.var);

    for (size_t first = 0; first + 1 < n && first < MOST_STARTS; first++) {
        const Pattern here = {x, first, false}, start = {x, 0, true};
        if ((first == 0 && try_pattern(r, &start)) || try_pattern(r, &here))
            return true;
    }
    return false;
}

// Whether the input can follow the output: both are bool, or both are whole numbers, and the output is a variable of the machine's own.
static bool can_follow(const SearchRun *k, const SearchInput *in, uint32_t output)
{
    const Var *v = k->p->var.at[output];
    const uint32_t at = k->m->var_of[output];

    if (v == k->p->s || v == k->p->g || v == k->p->t || at == IR_NONE || k->var[at].input != SEARCH_NONE)
        return false;
    return (v->type == SM_BOOL) == (in->type == SM_BOOL) && !ir_is_float(v->type) && !ir_is_float(in->type);
}

static bool follow_outputs(Reducer *r, const SearchInput *in)
{
    SearchRun *k = r->c->k;

    for (uint32_t i = 0; i < k->output.n && chooser_has_effort(r->c); i++) {
        const ScenarioChange x = {.var = in->var, .kind = SCENARIO_COPY, .source = k->output.at[i]};
        if (can_follow(k, in, x.source) && try_starts(r, x))
            return true;
    }
    return false;
}

// Lets an input of type bool alternate between two values that it has one after the other.  No sensor of a number alternates by as much.
static bool alternate(Reducer *r, const SearchInput *in)
{
    const ScenarioChange *before = NULL;
    const Scenario *s = r->s;
    ScenarioChange x = {.var = in->var, .kind = SCENARIO_ALTERNATE};

    for (size_t i = 0; i < s->changes; i++) {
        if (s->change[i].var != in->var || s->change[i].kind != SCENARIO_HOLD)
            continue;
        if (before && before->a != s->change[i].a) {
            x.a = before->a;
            x.b = s->change[i].a;
            return try_starts(r, x);
        }
        before = &s->change[i];
    }
    return false;
}

bool chooser_follow_outputs(Reducer *r)
{
    SearchRun *k = r->c->k;
    bool shorter = false;

    for (uint32_t v = 0; v < k->inputs && r->s->changes > FOLLOW_CHANGES && chooser_has_effort(r->c); v++) {
        const SearchInput *in = &k->input[v];
        const size_t n = count_changes(r->s, in->var);
        if (n < 2 || k->p->var.at[in->var]->parameter)
            continue;
        shorter |= follow_outputs(r, in) || (in->type == SM_BOOL && n > ALTERNATE_CHANGES && alternate(r, in));
    }
    return shorter;
}
