// SPDX-License-Identifier: Apache-2.0
// Statements that no run executes: after conditionals that always leave, in branches that are never taken, in a .step or .exit
// that never runs.  Reported once, at the outermost.  AST_DEPTH_MAX bounds the recursion, which follows nested conditionals.
#include <string.h>

#include "compiler/analysis/reach.h"

// Whether every path through these statements ends in a transition.
bool always_leaves(const Stmts *stmts)
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

// ---- dead statements ----

static void mark_from(Structure *k, const Stmts *list, size_t first, uint32_t dead)
{
    for (size_t i = first; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_TRANSITION)
            k->why[s->number] = dead;
        mark_from(k, &s->then, 0, dead);
        mark_from(k, &s->otherwise, 0, dead);
    }
}

static void tell(Structure *k, const Stmts *list, size_t first, Diag *d)
{
    mark_from(k, list, first, dead_of(k, CAUSE_TOLD, list->at[first], NULL, d));
}

// list->at[first] follows a conditional that leaves in every case.
static void tell_rest(Structure *k, const Stmts *list, size_t first, bool explained)
{
    const Stmt *before = list->at[first - 1];
    const bool both = before->kind == ST_IF && always_leaves(&before->then) && always_leaves(&before->otherwise);
    Diag *d = NULL;

    if (before->kind != ST_TRANSITION && (both || !explained)) {
        d = diag_report(k->a->diags, both ? DIAG_dead_code : DIAG_dead_rest, list->at[first]->span);
        diag_note(k->a->diags, d, before->span, both ? DIAG_note_leaves_here : DIAG_note_last_case);
    }
    tell(k, list, first, d);
}

static void tell_else(Structure *k, const Stmt *s)
{
    const Stmt *first = s->otherwise.at[0];
    Diag *d = diag_report(k->a->diags, DIAG_dead_else, first->span);

    diag_note(k->a->diags, d, s->span, DIAG_note_last_case);
    tell(k, &s->otherwise, 0, d);
}

// ---- the walk ----

static void note_write(Structure *k, const Stmt *s)
{
    const Wrote was = {s->var->index, k->written[s->var->index]};

    vec_push(k->a->arena, &k->log, was);
    k->written[s->var->index] = k->order[s->number];
}

static void undo_writes(Structure *k, size_t to)
{
    while (k->log.n > to) {
        k->log.n--;
        k->written[k->log.at[k->log.n].var] = k->log.at[k->log.n].was;
    }
}

static bool walk(Structure *k, const Stmts *list, const Way *way);

// Assignments in a branch that leaves are not visible after the conditional.
static bool walk_arm(Structure *k, const Stmts *list, const Stmt *s, bool holds, const Way *outer)
{
    const uint32_t log = k->log.n, left = k->left.n;
    bool leaves;
    Way *way;

    if (list->n == 0)
        return false;
    way = ARENA_NEW(k->a->arena, Way);
    *way = (Way){s, holds, outer, outer ? outer->depth + 1 : 1};
    leaves = walk(k, list, way);
    if (leaves) {
        undo_writes(k, log);
        k->left.n = left;
        vec_push(k->a->arena, &k->left, way);
    }
    return leaves;
}

// Whether no path continues after the conditional.
static bool walk_if(Structure *k, const Stmt *s, const Way *way)
{
    const Verdict v = judge(k, s, way);
    bool then = true, otherwise = true;

    if (v.then)
        then = walk_arm(k, &s->then, s, true, way);
    else
        mark_from(k, &s->then, 0, v.dead);
    if (v.otherwise)
        otherwise = walk_arm(k, &s->otherwise, s, false, way);
    else if (v.dead)
        mark_from(k, &s->otherwise, 0, v.dead);
    else if (s->otherwise.n > 0)
        tell_else(k, s);
    k->explained += v.dead != 0;
    return then && otherwise;
}

// Returns false if some path may continue after the list.
static bool walk(Structure *k, const Stmts *list, const Way *way)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const size_t explained = k->explained;
        k->order[s->number] = ++k->passed;
        if (s->kind == ST_ASSIGN) {
            note_write(k, s);
            continue;
        }
        if (s->kind == ST_IF && !walk_if(k, s, way))
            continue;
        if (i + 1 < list->n)
            tell_rest(k, list, i + 1, k->explained != explained);
        return true;
    }
    return false;
}

// ---- blocks ----

static bool walk_block(Structure *k, BlockKind block)
{
    k->block = block;
    return walk(k, &k->state->block[block], NULL);
}

static void forget(Structure *k)
{
    undo_writes(k, 0);
    k->left.n = 0;
}

static void look_at_step(Structure *k, bool entry_leaves, bool explained)
{
    const Stmts *step = &k->state->block[BLOCK_STEP];
    Diag *d = NULL;

    if (step->n == 0)
        return;
    if (!entry_leaves) {
        if (!always_leaves(step))             // otherwise it runs directly after .entry only
            forget(k);
        walk_block(k, BLOCK_STEP);
        return;
    }
    if (!explained)
        d = diag_report(k->a->diags, DIAG_dead_step, k->state->block_span[BLOCK_STEP], k->state->name->text);
    tell(k, step, 0, d);
}

static bool has_transition(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || has_transition(&list->at[i]->then) || has_transition(&list->at[i]->otherwise))
            return true;
    return false;
}

static void look_at_exit(Structure *k)
{
    const Stmts *block = k->state->block;

    forget(k);
    if (block[BLOCK_EXIT].n == 0)
        return;
    if (facts_may_reach(k->a->facts, k->state->number - 1, BLOCK_EXIT))
        walk_block(k, BLOCK_EXIT);
    else if (!has_transition(&block[BLOCK_ENTRY]) && !has_transition(&block[BLOCK_STEP]))
        diag_report(k->a->diags, DIAG_dead_exit, k->state->block_span[BLOCK_EXIT], k->state->name->text);
}

static void look_at_state(Structure *k, const State *state)
{
    const size_t explained = k->explained;
    bool leaves;

    k->state = state;
    leaves = walk_block(k, BLOCK_ENTRY);
    look_at_step(k, leaves, k->explained != explained);
    look_at_exit(k);
}

void find_dead(Structure *k)
{
    const Program *p = k->a->p;

    for (size_t s = 0; s < p->state.n; s++)
        if (facts_may_reach(k->a->facts, s, BLOCK_ENTRY))
            look_at_state(k, p->state.at[s]);
}
