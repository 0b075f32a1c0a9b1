// SPDX-License-Identifier: Apache-2.0
// Pairs of transitions that follow each other at once: there and back (ping-pong), and straight on (cascade).  Both are asked of
// ways (way.h), on which inputs stay as they are.
//
// Ping-pong is meant to be found where a machine can flip for as long as its inputs stay: so each state is left in its first
// step, T being 0, and then once more, for what the states assign may break it.  A counter among the conditions ends it some day.
// A state that is left without a condition is one step long on purpose.
#include "compiler/analysis/way.h"

enum {
    PAIRS_MOST = 4096,            // of one state, ways in times ways out: beyond that some are not looked at
    FAR = 300                     // statements of a block before a transition: one that stands further down is not looked at
};

typedef struct Pairs {
    Analysis *a;
    size_t *first;                // by state: its first transition in the list; one more at the end
} Pairs;

static Pairs find_pairs(Analysis *a)
{
    Pairs p = {a, ARENA_ARRAY(a->arena, size_t, a->p->state.n + 1)};
    size_t t = 0;

    for (size_t s = 0; s <= a->p->state.n; s++) {
        while (t < a->transition.n && a->transition.at[t].from->number <= s)
            t++;
        p.first[s] = t;
    }
    return p;
}

static bool is_far_down(const Transition *t)
{
    return t->stmt->number - t->from->block[t->block].at[0]->number > FAR;
}

static bool is_conditional(const Analysis *a, const Transition *t)
{
    return t->when && a->stmt[t->stmt->number].reached && t->to != t->from && !is_far_down(t);
}

// ---- there and back ----

typedef struct Counters { const Way *w; bool any; } Counters;

static void look_for_counter(Expr *e, void *context)
{
    Counters *c = context;

    c->any |= e->kind == EX_VAR && way_counts(c->w, e->var);
}

static bool counts(const Way *w, const Transition *t)
{
    Counters c = {w, false};

    for (const Condition *when = t->when; when; when = when->outer)
        expr_walk(when->stmt->value, look_for_counter, &c);
    return c.any;
}

static bool flips(const Analysis *a, const Transition *there, const Transition *back)
{
    Way w = way_begin(a);

    way_step(&w, there, true);
    way_step(&w, back, true);
    if (counts(&w, there) || counts(&w, back))
        return false;
    way_step(&w, there, true);
    return way_possible(&w);
}

static void report_ping_pong(const Analysis *a, const Transition *there, const Transition *back)
{
    Diag *d = diag_report(a->diags, DIAG_ping_pong, there->stmt->span, there->from->name->text, there->to->name->text);

    diag_note(a->diags, d, back->stmt->span, DIAG_note_way_back, condition_text(a->arena, back->when));
}

void analyse_ping_pong(Analysis *a)
{
    const Pairs p = find_pairs(a);

    for (size_t t = 0; t < a->transition.n; t++) {
        const Transition *there = &a->transition.at[t];
        const size_t to = there->to->number - 1;
        if (there->to->number <= there->from->number || !is_conditional(a, there))
            continue;
        for (size_t u = p.first[to]; u < p.first[to + 1]; u++)
            if (a->transition.at[u].to == there->from && is_conditional(a, &a->transition.at[u]) &&
                flips(a, there, &a->transition.at[u])) {
                report_ping_pong(a, there, &a->transition.at[u]);
                break;
            }
    }
}

// ---- straight on ----

static bool drives_on(const Analysis *a, const Transition *in, const Transition *out)
{
    Way w = way_begin(a), alone = way_begin(a);

    way_step_alone(&w, in);
    return way_possible(&w) && way_forces(&w, out) && !way_forces(&alone, out);
}

static void report_cascade(const Analysis *a, const Transition *in, const Transition *out)
{
    Diag *d = diag_report(a->diags, DIAG_cascade, out->stmt->span, out->from->name->text, condition_text(a->arena, in->when));

    diag_note(a->diags, d, in->stmt->span, DIAG_note_led_here, in->from->name->text);
}

void analyse_cascades(Analysis *a)
{
    const Pairs p = find_pairs(a);
    size_t *left = ARENA_ARRAY(a->arena, size_t, a->p->state.n);
    bool *told = ARENA_ARRAY(a->arena, bool, a->transition.n + 1);

    for (size_t s = 0; s < a->p->state.n; s++)
        left[s] = PAIRS_MOST;
    for (size_t t = 0; t < a->transition.n; t++) {
        const Transition *in = &a->transition.at[t];
        const size_t to = in->to->number - 1;
        if (!is_conditional(a, in))
            continue;
        for (size_t u = p.first[to]; u < p.first[to + 1] && left[to] > 0; u++, left[to]--) {
            const Transition *out = &a->transition.at[u];
            if (told[u] || out->to == in->from || !is_conditional(a, out) || !drives_on(a, in, out))
                continue;
            told[u] = true;
            report_cascade(a, in, out);
        }
    }
}
