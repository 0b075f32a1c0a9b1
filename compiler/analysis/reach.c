// SPDX-License-Identifier: Apache-2.0
// States that no way of transitions from the first state leads to, and code behind conditionals that always leave.  Guards
// are not looked at: a transition that stands in a state, and not behind another in its block, counts as a way.
#include "compiler/analysis/analysis.h"

// Whether every way through these statements ends in a transition.
static bool always_leaves(const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_TRANSITION)
            return true;
        if (stmt->kind == ST_IF && always_leaves(&stmt->then) && always_leaves(&stmt->otherwise))
            return true;
    }
    return false;
}

// ---- states ----

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

// ---- code ----

// Warns of what follows a conditional that leaves in both its branches; true if these statements always leave.
// (What follows a transition directly has been reported when it was checked.)
static bool look_for_dead(Diags *diags, const Stmts *stmts)
{
    bool leaves = false, told = false;

    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        bool then = look_for_dead(diags, &stmt->then), otherwise = look_for_dead(diags, &stmt->otherwise);
        if (leaves && !told && stmts->at[i - 1]->kind == ST_IF) {
            Diag *d = diag_report(diags, DIAG_dead_code, stmt->span);
            diag_note(diags, d, stmts->at[i - 1]->span, DIAG_note_leaves_here);
        }
        told = told || leaves;
        leaves = leaves || stmt->kind == ST_TRANSITION || (stmt->kind == ST_IF && then && otherwise);
    }
    return leaves;
}

// .step runs unless .entry left; so a state whose .entry always leaves has a .step for nothing.
static void look_at_blocks(Diags *diags, const State *state)
{
    for (int i = 0; i < BLOCK_COUNT; i++)
        look_for_dead(diags, &state->block[i]);
    if (state->block[BLOCK_STEP].n > 0 && always_leaves(&state->block[BLOCK_ENTRY]))
        diag_report(diags, DIAG_dead_step, state->block_span[BLOCK_STEP], state->name->text);
}

void analyse_reach(Analysis *a)
{
    const Program *p = a->p;
    Diags *diags = a->diags;
    Reach r = {a->arena, ARENA_ARRAY(a->arena, bool, p->state.n + 1), {NULL, 0, 0}};

    reach_state(&r, p->state.at[0]);
    while (r.waiting.n > 0) {
        const State *state = r.waiting.at[--r.waiting.n];
        follow(&r, &state->block[BLOCK_ENTRY]);
        if (!always_leaves(&state->block[BLOCK_ENTRY]))
            follow(&r, &state->block[BLOCK_STEP]);
    }
    for (size_t i = 0; i < p->state.n; i++)
        if (!r.reached[p->state.at[i]->number])
            diag_report(diags, DIAG_unreachable_state, p->state.at[i]->span, p->state.at[i]->name->text);
    for (size_t i = 0; i < p->state.n; i++)
        look_at_blocks(diags, p->state.at[i]);
}
