// SPDX-License-Identifier: Apache-2.0
// Finds statements that no run executes: after conditionals that always leave the state, in branches that are never taken, in a .step or
// .exit that never runs.  One finding, at the first such statement, covers all statements inside and after it.  The recursion depth equals
// the nesting of conditionals, which AST_DEPTH_MAX bounds.
#include <string.h>

#include "compiler/analysis/reach.h"

// Whether every path through these statements ends in a transition, whatever the guards evaluate to (dead_code.c).
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

// Whether some path through these statements ends in a transition.
bool has_transition(const Stmts *stmts)
{
    for (size_t i = 0; i < stmts->n; i++) {
        const Stmt *stmt = stmts->at[i];
        if (stmt->kind == ST_TRANSITION || has_transition(&stmt->then) || has_transition(&stmt->otherwise))
            return true;
    }
    return false;
}

// ---- dead statements ----

// Marks the transitions from list->at[first] on as never taken, because of k->dead.at[dead - 1].
static void mark_transitions_dead(ReachWalk *k, const Stmts *list, size_t first, uint32_t dead)
{
    for (size_t i = first; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_TRANSITION)
            k->dead_by[s->number] = dead;
        mark_transitions_dead(k, &s->then, 0, dead);
        mark_transitions_dead(k, &s->otherwise, 0, dead);
    }
}

// Marks the transitions from list->at[first] on as never taken.  `finding`, at list->at[first], explains why; NULL: another finding does.
static void mark_reported_from(ReachWalk *k, const Stmts *list, size_t first, Diag *finding)
{
    mark_transitions_dead(k, list, first, add_dead_code(k, CAUSE_REPORTED, list->at[first], NULL, finding));
}

// Returns the section [all_states] that contains the position; NULL if no section contains it.
static const AllStates *find_section(const Program *p, uint32_t at)
{
    for (size_t i = 0; i < p->all_states.n; i++)
        if (at - p->all_states.at[i]->span.at < p->all_states.at[i]->span.len)
            return p->all_states.at[i];
    return NULL;
}

// Reports a statement after a transition if only the transition is in its section [all_states]. The checker has reported any other.
static Diag *report_after_transition(const ReachWalk *k, const Stmt *transition, const Stmt *next)
{
    const AllStates *section = find_section(k->a->p, transition->span.at);
    Diag *d;

    if (!section || section == find_section(k->a->p, next->span.at))
        return NULL;
    d = diag_report(k->a->diags, DIAG_after_transition, next->span);
    diag_note(k->a->diags, d, transition->span, DIAG_note_transition_here);
    return d;
}

// Reports list->at[i], which is never executed because `before` always leaves the state.  Returns NULL if another finding explains it: one of
// the guards of `before` has a finding or is a switch (`explained`), or the checker has reported the statement.
static Diag *report_dead_stmt(const ReachWalk *k, const Stmt *before, const Stmt *stmt, bool explained)
{
    const bool both = before->kind == ST_IF && always_leaves(&before->then) && always_leaves(&before->otherwise);
    Diag *d;

    if (before->kind == ST_TRANSITION)
        return report_after_transition(k, before, stmt);
    if (!both && explained)
        return NULL;
    d = diag_report(k->a->diags, both ? DIAG_dead_code : DIAG_dead_rest, stmt->span);
    diag_note(k->a->diags, d, before->span, both ? DIAG_note_leaves_here : DIAG_note_last_case);
    return d;
}

// Reports the statements from list->at[first] on, after one that always leaves the state: the first of each section [all_states] and of the
// state, because the findings on a section are removed if its statements run in another state.
static void report_dead_rest(ReachWalk *k, const Stmts *list, size_t first, bool explained)
{
    Diag *d = report_dead_stmt(k, list->at[first - 1], list->at[first], explained);

    for (size_t i = first + 1; i < list->n; i++)
        if (find_section(k->a->p, list->at[i]->span.at) != find_section(k->a->p, list->at[i - 1]->span.at))
            report_dead_stmt(k, list->at[first - 1], list->at[i], explained);
    mark_reported_from(k, list, first, d);
}

// ---- the walk ----

// Restores k->written to its content when k->undo had `to` entries.
static void undo_writes_after(ReachWalk *k, size_t to)
{
    while (k->undo.n > to) {
        k->undo.n--;
        k->written[k->undo.at[k->undo.n].var] = k->undo.at[k->undo.n].was;
    }
}

static bool walk_stmts(ReachWalk *k, const Stmts *list, const Branch *branch);

// Walks a branch of the conditional s.  Returns whether the branch always leaves the state.  If so, removes its assignments from
// k->written, because the code after the conditional does not see them.
static bool walk_branch(ReachWalk *k, const Stmts *list, const Stmt *s, bool holds, const Branch *outer)
{
    const uint32_t writes = k->undo.n, leaving = k->leaving.n;
    Branch *branch;

    if (list->n == 0)
        return false;
    branch = ARENA_NEW(k->a->arena, Branch);
    *branch = (Branch){s, holds, outer, outer ? outer->depth + 1 : 1};
    if (!walk_stmts(k, list, branch))
        return false;
    undo_writes_after(k, writes);
    k->leaving.n = leaving;
    vec_push(k->a->arena, &k->leaving, branch);
    return true;
}

// Walks the conditional s.  Returns whether every path through it leaves the state.
static bool walk_if(ReachWalk *k, const Stmt *s, const Branch *branch)
{
    const GuardVerdict v = judge_guard(k, s, branch);
    bool then = true, otherwise = true;
    Diag *d;

    if (v.then)
        then = walk_branch(k, &s->then, s, true, branch);
    else
        mark_transitions_dead(k, &s->then, 0, v.dead);
    if (v.otherwise)
        otherwise = walk_branch(k, &s->otherwise, s, false, branch);
    else if (v.dead)
        mark_transitions_dead(k, &s->otherwise, 0, v.dead);
    else if (s->otherwise.n > 0) {
        d = diag_report(k->a->diags, DIAG_dead_else, s->otherwise.at[0]->span);
        diag_note(k->a->diags, d, s->span, DIAG_note_last_case);
        mark_reported_from(k, &s->otherwise, 0, d);
    }
    k->explained += v.dead != 0;
    return then && otherwise;
}

// Walks a list of statements.  Returns whether every path through it leaves the state.
static bool walk_stmts(ReachWalk *k, const Stmts *list, const Branch *branch)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        const size_t explained = k->explained;
        k->order[s->number] = ++k->passed;
        if (s->kind == ST_ASSIGN) {
            const WriteUndo was = {s->var->index, k->written[s->var->index]};
            vec_push(k->a->arena, &k->undo, was);
            k->written[s->var->index] = k->order[s->number];
            continue;
        }
        if (s->kind == ST_IF && !walk_if(k, s, branch))
            continue;
        if (i + 1 < list->n)
            report_dead_rest(k, list, i + 1, k->explained != explained);
        return true;
    }
    return false;
}

// ---- blocks ----

// Walks a block of the current state.  Returns whether every path through it leaves the state.
static bool walk_block(ReachWalk *k, BlockKind block)
{
    k->block = block;
    return walk_stmts(k, &k->state->block[block], NULL);
}

// Forgets the recorded assignments and leaving branches, because the code that is walked next runs in a later step or after a transition.
static void forget_earlier_guards(ReachWalk *k)
{
    undo_writes_after(k, 0);
    k->leaving.n = 0;
}

// Walks the .step block of the current state. entry_leaves: .entry always makes a transition, so .step never runs. explained: a finding in
// .entry already explains that.
static void walk_step(ReachWalk *k, bool entry_leaves, bool explained)
{
    const Stmts *step = &k->state->block[BLOCK_STEP];
    Diag *d = NULL;

    if (step->n == 0)
        return;
    if (!entry_leaves) {
        if (!always_leaves(step))             // a .step that always leaves runs only once, directly after .entry, whose guards still apply
            forget_earlier_guards(k);
        walk_block(k, BLOCK_STEP);
        return;
    }
    if (!explained && !find_section(k->a->p, k->state->block_span[BLOCK_STEP].at))      // W0518 reports a section
        d = diag_report(k->a->diags, DIAG_dead_step, k->state->block_span[BLOCK_STEP], k->state->name->text);
    mark_reported_from(k, step, 0, d);
}

// Walks the .exit block of the current state.
static void walk_exit(ReachWalk *k)
{
    const Stmts *block = k->state->block;

    forget_earlier_guards(k);
    if (block[BLOCK_EXIT].n == 0)
        return;
    if (facts_may_reach(k->a->facts, k->state->number - 1, BLOCK_EXIT))
        walk_block(k, BLOCK_EXIT);
    else if (!has_transition(&block[BLOCK_ENTRY]) && !has_transition(&block[BLOCK_STEP]))
        diag_report(k->a->diags, DIAG_dead_exit, k->state->block_span[BLOCK_EXIT], k->state->name->text);
}

void walk_statements(ReachWalk *k)
{
    const Program *p = k->a->p;

    for (size_t s = 0; s < p->state.n; s++)
        if (facts_may_reach(k->a->facts, s, BLOCK_ENTRY)) {
            const size_t explained = k->explained;
            bool leaves;
            k->state = p->state.at[s];
            leaves = walk_block(k, BLOCK_ENTRY);
            walk_step(k, leaves, k->explained != explained);
            walk_exit(k);
        }
}
