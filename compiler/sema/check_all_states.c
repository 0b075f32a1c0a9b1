// SPDX-License-Identifier: Apache-2.0
// [all_states] of a machine (language.md 5.68 to 5.75). The statements of such a section are checked once for each state in which they run,
// and become the first statements of .step of that state. Each copy has positions in a copy of the source that records the state
// (Source.state).
#include "compiler/sema/sema.h"

// ---- the states in which a section runs ----

// Sets excepted[n] for the number n of each state that an `except` annotation lists.
static void read_excepted(Sema *s, const AstAnnotation *except, bool *excepted)
{
    for (size_t i = 0; i < except->names->at.n; i++) {
        const State *state = scope_find_state(s, s->p, except->names->at.at[i], except->names->span.at[i]);
        if (!state)
            continue;
        if (excepted[state->number])
            diag_report(s->diags, DIAG_excepted_twice, except->names->span.at[i], state->name->text);
        excepted[state->number] = true;
    }
}

// Lists the sections of the machine, with the states in which each runs.
void find_all_states(Sema *s, Program *p, const AstFile *sm)
{
    for (size_t i = 0; i < sm->sections.n; i++) {
        const AstSection *section = sm->sections.at[i];
        const uint32_t end = i + 1 < sm->sections.n ? sm->sections.at[i + 1]->header.at : sm->src->len;
        AllStates *all;
        bool runs = false;

        if (section->kind != AST_ALL_STATES)
            continue;
        all = ARENA_NEW(s->arena, AllStates);
        all->section = section;
        all->span = (Span){sm->src, section->header.at, end - section->header.at};
        all->excepted = ARENA_ARRAY(s->arena, bool, p->state.n + 1);
        all->proposed = ARENA_ARRAY(s->arena, bool, p->state.n + 1);
        for (size_t k = 0; k < section->annotations.n; k++)
            if (section->annotations.at[k].kind == AST_EXCEPT)
                read_excepted(s, &section->annotations.at[k], all->excepted);
        for (size_t n = 1; n <= p->state.n; n++)
            runs = runs || !all->excepted[n];
        if (!section->block[AST_STEP].present)
            diag_report(s->diags, DIAG_all_states_empty, section->header);
        if (!runs && p->state.n)
            diag_report(s->diags, DIAG_all_states_excepted, section->header);
        add_state_allows(s, section, end);
        vec_push(s->arena, &p->all_states, all);
    }
}

// ---- transitions ----

// Returns the names after @except with `state` added, and stores where the edit inserts what in *at and *text.
static const char *extended_except(Sema *s, const AstSection *section, const State *state, Span *at, const char **text)
{
    const char *list = "";

    *at = (Span){section->header.src, section->header.at + section->header.len, 0};
    *text = format_in(s->arena, " @except %s", state->name->text);
    for (size_t i = 0; i < section->annotations.n; i++) {
        const AstAnnotation *a = &section->annotations.at[i];
        if (a->kind != AST_EXCEPT)
            continue;
        for (size_t k = 0; k < a->names->at.n; k++)
            list = format_in(s->arena, "%s%s ", list, a->names->at.at[k]->text);
        *at = (Span){a->span.src, a->span.at + a->span.len, 0};
        *text = format_in(s->arena, " %s", state->name->text);
    }
    return format_in(s->arena, "%s%s", list, state->name->text);
}

// Whether the section runs in another state than `state`, when the edits proposed so far have been made.
static bool runs_elsewhere(const Sema *s, const State *state)
{
    const AllStates *all = s->all_states;
    bool runs = false;

    for (uint32_t n = 1; n <= s->p->state.n; n++)
        runs = runs || (n != state->number && !all->excepted[n] && !all->proposed[n]);
    return runs;
}

// Reports a transition of [all_states] to a state in which the section runs: it would restart that state at each step.
void check_target_is_excepted(Sema *s, const AstStmt *in, const State *to)
{
    const char *list, *text;
    Span at;
    Diag *d;

    if (!s->all_states || s->all_states->excepted[to->number])
        return;
    d = diag_report(s->diags, DIAG_transition_to_unexcepted, in->span, to->name->text);
    if (!s->all_states->proposed[to->number] && !runs_elsewhere(s, to)) {
        diag_label(s->diags, d, DIAG_label_not_in_all_states);
        return;
    }
    list = extended_except(s, s->all_states->section, to, &at, &text);
    diag_label(s->diags, d, DIAG_label_except, list);
    if (!s->all_states->proposed[to->number])
        diag_edit(s->diags, d, at, text);
    s->all_states->proposed[to->number] = true;
}

// ---- .entry that leaves its state ----

// Whether the statements, or statements nested in them, contain a transition.
static bool has_transition(const Stmts *list)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->at[i]->kind == ST_TRANSITION || has_transition(&list->at[i]->then) || has_transition(&list->at[i]->otherwise))
            return true;
    return false;
}

// Warns of sections that do not run in the step in which .entry of a state makes a transition.
void warn_of_skipped_all_states(Sema *s, const Program *p)
{
    for (size_t i = 0; i < p->all_states.n; i++) {
        const AllStates *all = p->all_states.at[i];
        const char *names = NULL;
        for (size_t k = p->state.n; k-- > 0; )
            if (!all->excepted[k + 1] && has_transition(&p->state.at[k]->block[BLOCK_ENTRY]))
                names = names ? format_in(s->arena, "'%s' or %s", p->state.at[k]->name->text, names)
                              : format_in(s->arena, "'%s'", p->state.at[k]->name->text);
        if (names && all->section->block[AST_STEP].stmts.n)
            diag_report(s->diags, DIAG_all_states_skipped, all->section->block[AST_STEP].label, names);
    }
}

// ---- statements ----

enum { COPIES_MAX = 100000 };         // the most copies of statements that all sections together can have

// Adds the statements of all sections that run in the state to its .step, which is still empty.
void add_all_states(Sema *s, Program *p, State *state)
{
    for (size_t i = 0; i < p->all_states.n; i++) {
        AllStates *all = p->all_states.at[i];
        const AstBlock *step = &all->section->block[AST_STEP];
        if (all->excepted[state->number])
            continue;
        if (s->copied > COPIES_MAX) {
            diag_report(s->diags, DIAG_all_states_too_large, all->section->header);
            return;
        }
        s->copied -= s->stmts;
        s->all_states = all;
        s->state = NULL;
        s->copy = source_copy_for_state(s->arena, p->src, state->name->text);
        s->block = BLOCK_STEP;
        state->block_span[BLOCK_STEP] = sema_span(s, step->label);
        check_stmts(s, &step->stmts, &state->block[BLOCK_STEP]);
        if (all->copies++ == 0) {
            warn_of_unguarded_abort(s, state, all->section, AST_STEP);
            add_section_marks(s, all->section, NULL);
        }
        s->copy = NULL;
        s->all_states = NULL;
        s->copied += s->stmts;
    }
}
