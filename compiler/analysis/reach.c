// SPDX-License-Identifier: Apache-2.0
// Reports states that no transition can reach.  On a path of unreachable states only the first is reported; its notes name the others.
#include "compiler/analysis/reach.h"
#include "stdlib/convert.h"

enum { FOLLOWERS_NAMED = 3 };         // a finding on an unreachable state names at most so many of the states that follow it

typedef struct Reach {
    ReachWalk *k;
    const Transitions *t;             // all transitions of the machine; the transitions of one state are adjacent
    size_t *first;                    // by state (from 0): index in *t of the state's first transition; the last entry is the length of *t
    uint32_t *stack, n;               // the n states whose transitions are not yet followed
    bool *reached;                    // by state: a path of transitions that may be taken leads to the state
    bool *explained;                  // by state: the state is reachable, or a finding explains why it is not
} Reach;

// Adds s to the set and to the stack, unless the set contains it.
static void push_state_once(Reach *r, bool *set, uint32_t s)
{
    if (set[s])
        return;
    set[s] = true;
    r->stack[r->n++] = s;
}

// Adds to `set` all states that transitions reach from the states on the stack, and empties the stack.  With `dead_too`, also follows
// transitions that are never taken.
static void follow_transitions(Reach *r, bool *set, bool dead_too)
{
    while (r->n > 0) {
        const uint32_t s = r->stack[--r->n];
        for (size_t i = r->first[s]; i < r->first[s + 1]; i++)
            if (dead_too || r->k->dead_by[r->t->at[i].stmt->number] == 0)
                push_state_once(r, set, r->t->at[i].to->number - 1);
    }
}

// ---- explained by other findings ----

// Returns the cause why t is never taken although its state is reachable; NULL if t may be taken, or its state is not reachable.
static DeadCode *find_cause_at_transition(const Reach *r, const Transition *t)
{
    const uint32_t dead = r->k->dead_by[t->stmt->number];

    return dead != 0 && r->reached[t->from->number - 1] ? &r->k->dead.at[dead - 1] : NULL;
}

// Marks as explained the targets of transitions that are never taken because of another finding or of a switch, and all states that
// follow these targets.
static void mark_explained(Reach *r)
{
    for (size_t i = 0; i < r->t->n; i++) {
        const Transition *t = &r->t->at[i];
        const DeadCode *d = find_cause_at_transition(r, t);
        if (!d || d->cause == CAUSE_NEVER || r->explained[t->to->number - 1])
            continue;
        if (d->finding)
            diag_note(r->k->a->diags, d->finding, t->to->span, DIAG_note_so_unreachable, t->to->name->text);
        push_state_once(r, r->explained, t->to->number - 1);
    }
    follow_transitions(r, r->explained, true);
}

// ---- reported ----

// Reports a state, and marks the state and all states that it leads to as explained.
static Diag *report_state(Reach *r, uint32_t state, DiagCode code)
{
    Diags *diags = r->k->a->diags;
    const State *s = r->k->a->p->state.at[state];
    Diag *d = diag_report(diags, code, s->span, s->name->text);
    unsigned named = 0;

    for (size_t i = r->first[state]; i < r->first[state + 1] && named < FOLLOWERS_NAMED; i++) {
        const State *to = r->t->at[i].to;
        if (r->explained[to->number - 1] || to == s)
            continue;
        diag_note(diags, d, to->span, DIAG_note_so_unreachable, to->name->text);
        named++;
    }
    push_state_once(r, r->explained, state);
    follow_transitions(r, r->explained, true);
    return d;
}

// Reports states whose every incoming guard is always false.  Reporting the state suppresses the finding on the guard.
static void report_impossible_states(Reach *r)
{
    Diag **finding = ARENA_ARRAY(r->k->a->arena, Diag *, r->k->a->p->state.n);

    for (size_t i = 0; i < r->t->n; i++) {
        const Transition *t = &r->t->at[i];
        const uint32_t to = t->to->number - 1;
        DeadCode *d = find_cause_at_transition(r, t);
        if (!d || d->cause != CAUSE_NEVER)
            continue;
        if (!r->explained[to])
            finding[to] = report_state(r, to, DIAG_impossible_state);
        if (!finding[to])
            continue;
        note_never_true(r->k, finding[to], d);
        d->at_state = true;
    }
}

// Stores the states that are not explained in `order`, in postorder of the transitions, and returns their number.  No other unexplained
// state, except those of its own cycle, leads to the last state of the list.
static size_t list_in_postorder(const Reach *r, uint32_t *order)
{
    const size_t states = r->k->a->p->state.n;
    uint32_t *stack = ARENA_ARRAY(r->k->a->arena, uint32_t, states);
    size_t *next = ARENA_ARRAY(r->k->a->arena, size_t, states);
    size_t n = 0, depth = 0;

    for (uint32_t s = 0; s < states; s++) {
        if (r->explained[s] || next[s])
            continue;
        for (stack[depth++] = s, next[s] = r->first[s] + 1; depth > 0;) {
            const uint32_t top = stack[depth - 1];
            uint32_t to;
            if (next[top] > r->first[top + 1]) {
                order[n++] = top;
                depth--;
                continue;
            }
            to = r->t->at[next[top]++ - 1].to->number - 1;
            if (!r->explained[to] && !next[to]) {
                next[to] = r->first[to] + 1;
                stack[depth++] = to;
            }
        }
    }
    return n;
}

// Returns, by state, whether a transition leads to it from another one.
static bool *mark_targets(const Reach *r)
{
    const size_t states = r->k->a->p->state.n;
    bool *target = ARENA_ARRAY(r->k->a->arena, bool, states);

    for (size_t from = 0; from < states; from++)
        for (size_t i = r->first[from]; i < r->first[from + 1]; i++)
            if (r->t->at[i].to->number != from + 1)
                target[r->t->at[i].to->number - 1] = true;
    return target;
}

static void report_states(ReachWalk *k)
{
    const size_t states = k->a->p->state.n;
    Arena *arena = k->a->arena;
    uint32_t *order = ARENA_ARRAY(arena, uint32_t, states);
    const bool *target;
    Reach r = {.k = k, .t = &k->a->transition, .first = transitions_by_state(arena, k->a->p, &k->a->transition)};

    r.stack = ARENA_ARRAY(arena, uint32_t, states);
    r.reached = ARENA_ARRAY(arena, bool, states);
    r.explained = ARENA_ARRAY(arena, bool, states);
    push_state_once(&r, r.reached, 0);
    follow_transitions(&r, r.reached, false);
    for (size_t s = 0; s < states; s++)
        r.explained[s] = r.reached[s];
    mark_explained(&r);
    report_impossible_states(&r);
    target = mark_targets(&r);
    for (size_t n = list_in_postorder(&r, order); n > 0; n--)
        if (!r.explained[order[n - 1]]) {
            Diag *d = report_state(&r, order[n - 1], DIAG_unreachable_state);
            if (!target[order[n - 1]])
                diag_label(k->a->diags, d, DIAG_label_no_way_to_state, k->a->p->state.at[order[n - 1]]->name->text);
        }
}

// ---- entry points ----

// Records in ReachWalk.stored whether an assignment stores a local's initial value or another value.
static void record_stored_value(const Stmt *s, void *context)
{
    ReachWalk *k = context;
    const StmtFact *f = &k->a->stmt[s->number];
    const Var *v = s->var;
    double x;

    if (s->kind != ST_ASSIGN || v->kind != VAR_LOCAL || !f->reached)
        return;
    if (fact_is_number(fact_convert(f->value, v->type), &x) && x == sm_cell_to_f64(v->type, v->init))
        k->stored[v->index] |= STORED_INITIAL;
    else
        k->stored[v->index] |= STORED_OTHER;
}

// Reports unreachable states, conditions that are never true, and blocks without statements.
void analyse_reach(Analysis *a)
{
    static const char *const label[BLOCK_COUNT] = {".entry", ".step", ".exit"};
    ReachWalk k = {.a = a};

    k.dead_by = ARENA_ARRAY(a->arena, uint32_t, a->p->stmts + 1u);
    k.order = ARENA_ARRAY(a->arena, uint32_t, a->p->stmts + 1u);
    k.written = ARENA_ARRAY(a->arena, uint32_t, a->p->var.n);
    k.stored = ARENA_ARRAY(a->arena, uint8_t, a->p->var.n);
    k.marked = ARENA_ARRAY(a->arena, uint32_t, a->p->var.n);
    each_stmt(a->p, record_stored_value, &k);
    walk_statements(&k);
    report_states(&k);
    for (size_t i = 0; i < k.dead.n; i++)
        if (k.dead.at[i].cause == CAUSE_NEVER && !k.dead.at[i].at_state)
            report_never_true(&k, &k.dead.at[i]);
    for (size_t s = 0; s < a->p->state.n; s++)
        for (int b = 0; b < BLOCK_COUNT; b++) {
            const State *state = a->p->state.at[s];
            if (state->block_span[b].src && state->block[b].n == 0)
                diag_report(a->diags, DIAG_empty_block, state->block_span[b], label[b], state->name->text);
        }
}
