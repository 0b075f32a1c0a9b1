// SPDX-License-Identifier: Apache-2.0
// Both state diagrams in one: the new machine, and what only the old one has, each marked with what happened to it.
#include <string.h>

#include "compiler/diff/diff_part.h"
#include "compiler/report/diagram.h"

// A machine with the states and transitions of both machines, as the diagram shows it.
typedef struct Union {
    const ProgramDiff *d;
    Program *p;                   // states of the new machine, then those that only the old one has
    VEC(DiagramChange) state;     // by State.number - 1
    VEC(const Stmt *) removed;    // the transitions that only the old machine has: their copies in `p`
} Union;

// Returns the state of the diagram (the union of both machines) that stands for a state of the old machine. Removed states follow those of the
// new one.
static State *state_in_union(const Union *u, const State *old)
{
    const Program *q = u->d->new.p;
    uint32_t extra = 0;

    if (u->d->state_of[old->number])
        return u->p->state.at[u->d->state_of[old->number] - 1];
    for (uint32_t s = 1; s < old->number; s++)
        extra += u->d->state_of[s] == 0;
    return u->p->state.at[q->state.n + extra];
}

// Returns the source as it is written: a copy of a statement of [all_states] becomes one of its state.
static Span written_span(Span s)
{
    s.src = s.src && s.src->copy_of ? s.src->copy_of : s.src;
    return s;
}

// Copies a transition of the old machine, with the conditions around it.
static Stmt *copy_transition(Union *u, const Transition *t)
{
    Stmt *s = ARENA_NEW(u->d->arena, Stmt);

    *s = *t->stmt;
    s->span = written_span(s->span);
    s->target = state_in_union(u, t->to);
    vec_push(u->d->arena, &u->removed, s);
    for (const Condition *c = t->when; c; c = c->outer) {
        Stmt *around = ARENA_NEW(u->d->arena, Stmt);
        Stmts inside = {NULL, 0, 0};
        *around = *c->stmt;
        around->span = written_span(around->span);
        vec_push(u->d->arena, &inside, s);
        around->then = c->holds ? inside : (Stmts){NULL, 0, 0};
        around->otherwise = c->holds ? (Stmts){NULL, 0, 0} : inside;
        s = around;
    }
    return s;
}

// Whether the diagram shows a transition of the old machine as removed: it has no equivalent in the new one, or leads elsewhere.
static bool is_removed(const ProgramDiff *d, const Transition *t)
{
    if (!d->state_of[t->from->number])
        return true;
    for (size_t i = 0; i < d->change.n; i++)
        if (d->change.at[i].part == DIFF_TRANSITION && d->change.at[i].old_stmt == t->stmt)
            return d->change.at[i].how == DIFF_REMOVED || !d->change.at[i].new_stmt ||
                   d->state_of[t->to->number] != d->change.at[i].new_stmt->target->number;
    return false;
}

// Returns how the diagram shows a state of the new machine: added, changed apart from its transitions, or the same.
static DiagramChange change_of_state(const ProgramDiff *d, const State *s)
{
    if (!d->old_state_of[s->number])
        return DIAGRAM_ADDED;
    for (size_t i = 0; i < d->change.n; i++)
        if (d->change.at[i].weight == DIFF_BEHAVIOUR && d->change.at[i].part != DIFF_TRANSITION && strcmp(d->change.at[i].where, s->name->text) == 0)
            return DIAGRAM_CHANGED;
    return DIAGRAM_SAME;
}

// Fills the union with copies of the states of the new machine, and after them of the removed states of the old one.
static void copy_states(Union *u)
{
    const Program *a = u->d->old.p, *b = u->d->new.p;

    u->p->state.at = NULL;
    u->p->state.n = u->p->state.cap = 0;
    for (size_t i = 0; i < b->state.n; i++) {
        State *s = ARENA_NEW(u->d->arena, State);
        *s = *b->state.at[i];
        for (int k = 0; k < BLOCK_COUNT; k++)
            s->block[k].cap = s->block[k].n;              // a push copies the list
        vec_push(u->d->arena, &u->p->state, s);
        vec_push(u->d->arena, &u->state, change_of_state(u->d, s));
    }
    for (size_t i = 0; i < a->state.n; i++) {
        State *s;
        if (u->d->state_of[i + 1])
            continue;
        s = ARENA_NEW(u->d->arena, State);
        *s = *a->state.at[i];
        s->number = u->p->state.n + 1;
        for (int k = 0; k < BLOCK_COUNT; k++)
            s->block[k] = (Stmts){NULL, 0, 0};
        vec_push(u->d->arena, &u->p->state, s);
        vec_push(u->d->arena, &u->state, DIAGRAM_REMOVED);
    }
}

// Copies the [all_states] sections.  A section lists the numbers of its excepted states, to which the removed states of the old machine are added.
static void extend_sections(Union *u)
{
    const Program *b = u->d->new.p;

    u->p->all_states.at = NULL;
    u->p->all_states.n = u->p->all_states.cap = 0;
    for (size_t i = 0; i < b->all_states.n; i++) {
        AllStates *all = ARENA_NEW(u->d->arena, AllStates);
        *all = *b->all_states.at[i];
        all->excepted = ARENA_ARRAY(u->d->arena, bool, u->p->state.n + 2u);
        for (uint32_t s = 1; s <= u->p->state.n; s++)
            all->excepted[s] = s > b->state.n || b->all_states.at[i]->excepted[s];
        vec_push(u->d->arena, &u->p->all_states, all);
    }
}

// Replaces the targets of transitions, which point to states of the new machine, by their copies in the union.
static void replace_targets(const Union *u, Transitions *all)
{
    for (size_t i = 0; i < all->n; i++)
        all->at[i].to = u->p->state.at[all->at[i].to->number - 1];
}

// Returns how the diagram shows a transition: added, removed, changed or the same.
static DiagramChange change_of_transition(const Union *u, const Transition *t)
{
    for (size_t i = 0; i < u->removed.n; i++)
        if (u->removed.at[i] == t->stmt)
            return DIAGRAM_REMOVED;
    if (u->state.at[t->from->number - 1] == DIAGRAM_ADDED)
        return DIAGRAM_ADDED;
    for (size_t i = 0; i < u->d->change.n; i++) {
        const DiffChange *c = &u->d->change.at[i];
        if (c->part == DIFF_TRANSITION && c->new_stmt == t->stmt)
            return c->how == DIFF_ADDED || (c->old_stmt && u->d->state_of[c->old_stmt->target->number] != c->new_stmt->target->number)
                   ? DIAGRAM_ADDED : DIAGRAM_CHANGED;
    }
    return DIAGRAM_SAME;
}

// Returns the condition that a changed transition of the new machine had in the old one; NULL: it did not change.
static const char *earlier_condition(const ProgramDiff *d, const Stmt *s)
{
    for (size_t i = 0; i < d->change.n; i++)
        if (d->change.at[i].part == DIFF_TRANSITION && d->change.at[i].new_stmt == s)
            return d->change.at[i].old;
    return NULL;
}

void diff_write_svg(const ProgramDiff *d, Buf *out)
{
    Transitions old = transitions_of(d->arena, d->old.p);
    Union u = {d, ARENA_NEW(d->arena, Program), {NULL, 0, 0}, {NULL, 0, 0}};
    Analysis a = {.arena = d->arena, .p = u.p};
    DiagramOptions o = {0};
    DiagramChange *transition;
    const char **was;

    *u.p = *d->new.p;
    copy_states(&u);
    extend_sections(&u);
    for (size_t i = 0; i < old.n; i++)
        if (is_removed(d, &old.at[i]))
            vec_push(d->arena, &state_in_union(&u, old.at[i].from)->block[old.at[i].block], copy_transition(&u, &old.at[i]));
    a.transition = transitions_of(d->arena, u.p);
    replace_targets(&u, &a.transition);
    transition = ARENA_ARRAY(d->arena, DiagramChange, a.transition.n + 1u);
    was = ARENA_ARRAY(d->arena, const char *, a.transition.n + 1u);
    for (size_t i = 0; i < a.transition.n; i++) {
        transition[i] = change_of_transition(&u, &a.transition.at[i]);
        if (transition[i] == DIAGRAM_CHANGED)
            was[i] = earlier_condition(d, a.transition.at[i].stmt);
    }
    o.changes = &(DiagramChanges){u.state.at, transition, was};
    diagram_write_svg(&a, &o, out);
}
