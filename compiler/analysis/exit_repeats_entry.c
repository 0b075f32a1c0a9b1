// SPDX-License-Identifier: Apache-2.0
// Reports an .exit that switches on what .entry of the same state has switched on: it was meant to switch it off.
//
// Reported only if nothing else in the state assigns the variable, so that the assignment has no effect.  Values of 0 are not judged: to switch off
// again what is off is a precaution.
#include "compiler/analysis/analysis.h"
#include "stdlib/math.h"

typedef struct EntryStores { const Stmt *first; uint32_t all; } EntryStores;

// Counts the assignments to v in a list, and stores the first one that is not in a conditional.
static void count_stores(const Stmts *list, const Var *v, bool guarded, EntryStores *found)
{
    for (size_t i = 0; i < list->n; i++) {
        const Stmt *s = list->at[i];
        if (s->kind == ST_ASSIGN && s->var == v) {
            found->all++;
            found->first = found->first || guarded ? found->first : s;
        }
        if (s->kind == ST_IF) {
            count_stores(&s->then, v, true, found);
            count_stores(&s->otherwise, v, true, found);
        }
    }
}

static void check_exit_store(const Analysis *a, const State *state, const Stmt *s)
{
    EntryStores entry = {NULL, 0}, rest = {NULL, 0};
    Diag *d;

    if (s->kind != ST_ASSIGN || !expr_is_constant(s->value) || !sm_to_bool(expr_constant_value(s->value)) || s->var->type != SM_BOOL ||
        s->var->kind != VAR_ELEMENT || !a->stmt[s->number].reached)
        return;
    count_stores(&state->block[BLOCK_ENTRY], s->var, false, &entry);
    count_stores(&state->block[BLOCK_STEP], s->var, false, &rest);
    count_stores(&state->block[BLOCK_EXIT], s->var, false, &rest);
    if (!entry.first || entry.all != 1 || rest.all != 1 || !expr_is_constant(entry.first->value) ||
        !sm_to_bool(expr_constant_value(entry.first->value)))
        return;
    d = diag_report(a->diags, DIAG_exit_repeats_entry, s->span, s->var->name->text, state->name->text);
    diag_note(a->diags, d, entry.first->span, DIAG_note_switched_on, s->var->name->text);
}

void analyse_exit_repeats_entry(Analysis *a)
{
    for (size_t s = 0; s < a->p->state.n; s++) {
        const State *state = a->p->state.at[s];
        for (size_t i = 0; i < state->block[BLOCK_EXIT].n; i++)
            check_exit_store(a, state, state->block[BLOCK_EXIT].at[i]);
    }
}
