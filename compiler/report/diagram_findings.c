// SPDX-License-Identifier: Apache-2.0
// Findings on a diagram.  A finding that points at a transition or its guard belongs to that transition.  Otherwise it belongs to the state
// whose section it points into.  A finding elsewhere is not shown.
#include <stdlib.h>

#include "compiler/report/diagram_model.h"

// A range of the source, and the list for findings in it.
typedef struct Place { uint32_t at, end, order; Findings *finding; } Place;
typedef VEC(Place) Places;

static void add_place(Arena *arena, Places *out, Span span, Findings *finding)
{
    Place p = {span.at, span.at + span.len, (uint32_t)out->n, finding};

    if (span.src)
        vec_push(arena, out, p);
}

static int in_order(const void *a, const void *b)
{
    const Place *x = a, *y = b;

    return x->at != y->at ? (x->at < y->at ? -1 : 1) : (x->order > y->order) - (x->order < y->order);
}

static void sort_places(Places *p)
{
    if (p->n > 0)
        qsort(p->at, p->n, sizeof *p->at, in_order);
}

// The last range that begins at or before `at`, if it extends that far.
static const Place *place_at(const Places *p, uint32_t at)
{
    size_t low = 0, high = p->n;

    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (p->at[middle].at <= at)
            low = middle + 1;
        else
            high = middle;
    }
    return low > 0 && at < p->at[low - 1].end ? &p->at[low - 1] : NULL;
}

// ---- source ranges of states and transitions ----

// A transition, and its innermost guard.  If a conditional contains several transitions, the first one has the guard.
static Places transition_places(Diagram *d)
{
    Places out = {NULL, 0, 0};
    const Stmt *last = NULL;

    for (size_t e = 0; e < d->edge.n; e++)
        for (size_t g = 0; g < d->edge.at[e].guard.n; g++) {
            Guard *guard = &d->edge.at[e].guard.at[g];
            const Condition *when = guard->transition->when;
            add_place(d->a->arena, &out, guard->transition->stmt->span, &guard->finding);
            if (when && when->stmt != last)
                add_place(d->a->arena, &out, when->stmt->span, &guard->finding);
            last = when ? when->stmt : NULL;
        }
    sort_places(&out);
    return out;
}

static uint32_t end_of(const Stmts *stmts, uint32_t end)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *s = stmts->at[i];
        if (s->span.at + s->span.len > end)
            end = s->span.at + s->span.len;
        end = end_of(&s->otherwise, end_of(&s->then, end));
    }
    return end;
}

static Places state_places(Diagram *d)
{
    Places out = {NULL, 0, 0};

    for (size_t s = 0; s < d->nodes; s++) {
        const State *state = d->node[s].state;
        Span span = state->span;
        uint32_t end = span.at + span.len;
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const Span label = state->block_span[b];
            if (label.src && label.at + label.len > end)
                end = label.at + label.len;
            end = end_of(&state->block[b], end);
        }
        span.len = end - span.at;
        add_place(d->a->arena, &out, span, &d->node[s].finding);
    }
    sort_places(&out);
    return out;
}

void diagram_mark(Diagram *d, const Diags *findings)
{
    const Places transitions = transition_places(d), states = state_places(d);

    for (size_t i = 0; i < findings->list.n; i++) {
        const Diag *diag = findings->list.at[i];
        const Place *at;
        if (diag->span.src != d->a->p->src)
            continue;
        at = place_at(&transitions, diag->span.at);
        if (!at)
            at = place_at(&states, diag->span.at);
        if (at)
            vec_push(d->a->arena, at->finding, diag);
    }
}
