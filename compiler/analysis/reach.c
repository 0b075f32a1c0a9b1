// SPDX-License-Identifier: Apache-2.0
// States that no way of transitions from the first state leads to.  Guards are not looked at: a transition that stands in
// a state, and not behind another transition in its block, counts as a way.
#include "compiler/analysis/analysis.h"

typedef struct Reach {
    Arena *arena;
    bool *reached;                // by state number
    VEC(const State *) waiting;   // reached, their transitions not yet looked at
} Reach;

static void reach_state(Reach *r, const State *state)
{
    if (r->reached[state->number])
        return;
    r->reached[state->number] = true;
    vec_push(r->arena, &r->waiting, state);
}

static void follow(Reach *r, const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_TRANSITION) {
            reach_state(r, stmt->target);
            return;               // what follows is never executed
        }
        if (stmt->kind == ST_IF) {
            follow(r, &stmt->then);
            follow(r, &stmt->otherwise);
        }
    }
}

void analyse_reach(Arena *arena, Diags *diags, const Program *p)
{
    Reach r = {arena, ARENA_ARRAY(arena, bool, p->state.n + 1), {NULL, 0, 0}};

    reach_state(&r, p->state.at[0]);
    while (r.waiting.n > 0) {
        const State *state = r.waiting.at[--r.waiting.n];
        follow(&r, &state->block[BLOCK_ENTRY]);
        follow(&r, &state->block[BLOCK_STEP]);
    }
    for (size_t i = 0; i < p->state.n; i++)
        if (!r.reached[p->state.at[i]->number])
            diag_report(diags, DIAG_unreachable_state, p->state.at[i]->span, p->state.at[i]->name->text);
}
