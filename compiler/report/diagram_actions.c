// SPDX-License-Identifier: Apache-2.0
// What a state or a section [all_states] does, as lines in its box: the assignments to elements of the state vector.  Two kinds of assignments are
// not shown: those to locals, and those in the same branch as a transition, which happen when the state is left.
#include "compiler/report/diagram_model.h"

typedef struct ActionSearch { Diagram *d; uint32_t *hidden; } ActionSearch;     // hidden: by node, how many of its assignments have no line

// Whether a transition follows in the same branch, so that the assignment belongs to the transition.
static bool belongs_to_transition(const Condition *when)
{
    const Stmts *branch = !when ? NULL : when->holds ? &when->stmt->then : &when->stmt->otherwise;

    return branch && branch->n > 0 && branch->at[branch->n - 1]->kind == ST_TRANSITION;
}

// Adds one assignment to the lines in the box of n. Consecutive actions of one block show its name (.entry, .step, .exit) once.
static void add_action(Diagram *d, DiagramNode *n, const char *block, const char *text)
{
    const bool repeats = n->action.n > 0 && n->action.at[n->action.n - 1].block_name == block;
    DiagramAction action = {block, !repeats, diagram_text_truncate(d->a->arena, text, GUARD_SIZE, false, ACTION_W), 0};

    action.w = ACTION_LABEL_W + diagram_text_width(action.text, GUARD_SIZE, false);
    if (action.w > n->action_w)
        n->action_w = action.w;
    vec_push(d->a->arena, &n->action, action);
}

// Returns the node where a statement is shown.  NULL: the statement is a copy of one that is shown at a section [all_states].
static DiagramNode *node_of_stmt(Diagram *d, const StmtLocation *at)
{
    const AllStates *all = written_section(d->a->p, at->stmt->span);
    size_t n = d->states;

    if (!all)
        return &d->node[at->state->number - 1];
    if (at->state != written_first_state(d->a->p, all))
        return NULL;
    while (d->node[n].all != all)
        n++;
    return &d->node[n];
}

// Adds an assignment to the actions of its node, unless it belongs to a transition or does not set an element.
static void add_assignment(const StmtLocation *at, void *context)
{
    static const char *const block_name[BLOCK_COUNT] = {"entry", "step", "exit"};
    ActionSearch *search = context;
    Diagram *d = search->d;
    DiagramNode *n;
    const Stmt *s = at->stmt;
    const char *text;

    if (s->kind != ST_ASSIGN || s->var->kind != VAR_ELEMENT || belongs_to_transition(at->when))
        return;
    n = node_of_stmt(d, at);
    if (!n)
        return;
    if (n->action.n == ACTIONS) {
        search->hidden[n - d->node]++;
        return;
    }
    text = format_in(d->a->arena, "%s = %s", s->var->name->text, source_text(d->a->arena, s->value->span));
    if (at->when)
        text = format_in(d->a->arena, "%s if %s", text, condition_text(d->a->arena, at->when));
    add_action(d, n, block_name[at->block], text);
}

void diagram_add_actions(Diagram *d)
{
    ActionSearch search = {d, ARENA_ARRAY(d->a->arena, uint32_t, d->nodes)};

    each_stmt_location(d->a->arena, d->a->p, add_assignment, &search);
    for (size_t n = 0; n < d->nodes; n++)
        if (search.hidden[n] > 0)
            add_action(d, &d->node[n], "", format_in(d->a->arena, "\xe2\x80\xa6 and %lu more", (unsigned long)search.hidden[n]));
}
