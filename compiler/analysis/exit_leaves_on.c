// SPDX-License-Identifier: Apache-2.0
// Reports transitions that leave an output on, from a state that switches it on and whose other transitions switch it off first.
//
// That is read from the statements, not tried: the state itself shows that the output belongs to it.  Says nothing about an output that
// .exit or the next state assigns, or that the state also switches off without leaving.  An output that output_left_on.c has reported is not
// reported again.
#include "compiler/analysis/trial_checks.h"

typedef struct ExitCheck {
    Trials *t;
    const State *state;
    const Var *v;                 // the output
    const Stmt *on;               // the last statement found in the state that switches the output on; NULL: none
    const Stmt *off;              // the last statement found that switches the output off before a transition out of the state; NULL: none
    const State *to;              // the target of the transition after `off`
    const Stmt *leaves;           // the first transition that leaves the output on; NULL: none
    bool is_unclear;              // the state may switch the output off and stay, or assign a value that may be on or off
} ExitCheck;

// Whether the block assigns v anywhere.
static bool assigns_variable(const Stmts *list, const Var *v)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if ((s->kind == ST_ASSIGN && s->var == v) || (s->kind == ST_IF && (assigns_variable(&s->then, v) || assigns_variable(&s->otherwise, v))))
            return true;
    }
    return false;
}

// Whether some block of `to`, the target of a transition, assigns the output.
static bool target_assigns(const State *to, const Var *v)
{
    for (int b = 0; b < BLOCK_COUNT; b++)
        if (assigns_variable(&to->block[b], v))
            return true;
    return false;
}

// Records assignment s to the output, a statement of `list`. Sets *off to s if s switches the output off, else to NULL.
static void add_assignment(ExitCheck *x, const Stmt *s, const Stmts *list, const Stmt **off)
{
    const StmtFact *f = &x->t->a->stmt[s->number];
    const bool is_off = f->value.lo == 0 && f->value.hi == 0;

    *off = is_off ? s : NULL;
    if (is_off)
        x->is_unclear |= !always_leaves(list);
    else if (f->value.lo > 0)
        x->on = s;
    else
        x->is_unclear = true;
}

// Records transition s out of the state. `off`: the statement before it that switched the output off; NULL: the transition leaves the output on.
static void add_transition(ExitCheck *x, const Stmt *s, const Stmt *off)
{
    if (!x->t->a->stmt[s->number].reached || s->target == x->state)
        return;
    if (off) {
        x->off = off;
        x->to = s->target;
    } else if (!x->leaves && !target_assigns(s->target, x->v)) {
        x->leaves = s;
    }
}

// Visits the statements in the order of their execution. `off`: the last assignment to the output before them, if it switches the output off.
// Recursion depth equals the nesting of conditionals, which AST_DEPTH_MAX bounds.
static void visit_in_order(ExitCheck *x, const Stmts *list, const Stmt *off)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_ASSIGN && s->var == x->v)
            add_assignment(x, s, list, &off);
        else if (s->kind == ST_TRANSITION)
            add_transition(x, s, off);
        if (s->kind != ST_IF)
            continue;
        visit_in_order(x, &s->then, off);
        visit_in_order(x, &s->otherwise, off);
    }
}

static void report_exit(const ExitCheck *x)
{
    Diags *diags = x->t->a->diags;
    Diag *d = diag_report(diags, DIAG_exit_leaves_on, x->leaves->span, x->v->name->text, x->leaves->target->name->text);

    diag_note_declaration(diags, d, DIAG_OUTPUTS, x->v->span);
    diag_note_step(diags, d, x->on->span, DIAG_note_switched_on, x->v->name->text);
    diag_note_step(diags, d, x->off->span, DIAG_note_off_before_leaving, x->v->name->text, x->to->name->text);
}

// Finds transitions that leave an output on which the other transitions of the state switch off.
void check_exit_leaves_on(Trials *t)
{
    for (uint32_t v = 0; v < t->run->m->var.n; v++)
        for (size_t i = 0; t->actuator[v] && !t->rests_on[v] && i < t->a->p->state.n; i++) {
            const State *s = t->a->p->state.at[i];
            ExitCheck x = {.t = t, .state = s, .v = t->var[v]};
            if (assigns_variable(&s->block[BLOCK_EXIT], x.v))
                continue;
            visit_in_order(&x, &s->block[BLOCK_ENTRY], NULL);
            visit_in_order(&x, &s->block[BLOCK_STEP], NULL);
            if (x.on && x.off && x.leaves && !x.is_unclear)
                report_exit(&x);
        }
}
