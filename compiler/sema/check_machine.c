// SPDX-License-Identifier: Apache-2.0
// Checks a machine file and builds a Program: numbers its states, declares its variables, checks its blocks.
#include "compiler/sema/sema.h"

// ---- states ----

static void add_states(Sema *s, Program *p, const AstFile *sm)
{
    for (size_t i = 0; i < sm->sections.n; i++) {
        const AstSection *section = sm->sections.at[i];
        const State *first = map_find(&p->state_by_name, section->name);
        State *state;

        if (section->kind != AST_STATE)
            continue;
        state = ARENA_NEW(s->arena, State);
        state->name = section->name;
        state->span = section->name_span;
        state->is_abort = has_annotation(&section->annotations, AST_ABORT);
        state->is_safe = has_annotation(&section->annotations, AST_SAFE);
        state->allows_swap = has_annotation(&section->annotations, AST_SWAP);
        state->number = (uint32_t)p->state.n + 1;
        vec_push(s->arena, &p->state, state);
        if (state->name->len == 0)
            continue;             // the parser could not read its header
        if (first) {
            Diag *d = diag_report(s->diags, DIAG_state_twice, section->name_span, section->name->text);
            diag_label(s->diags, d, DIAG_label_state_twice);
            diag_note(s->diags, d, first->span, DIAG_note_declared_here, first->name->text);
        } else {
            map_put(&p->state_by_name, state->name, state);
        }
    }
    if (p->state.n == 0 && !s->lost->sections)
        diag_report(s->diags, DIAG_no_state, (Span){p->src, 0, 0});
}

// ---- blocks ----

static void check_states(Sema *s, Program *p, const AstFile *sm)
{
    static const BlockKind block_of[AST_LABEL_COUNT] = {[AST_ENTRY] = BLOCK_ENTRY, [AST_STEP] = BLOCK_STEP, [AST_EXIT] = BLOCK_EXIT};
    size_t n = 0;

    for (size_t i = 0; i < sm->sections.n; i++) {
        const AstSection *section = sm->sections.at[i];
        State *state;

        if (section->kind != AST_STATE)
            continue;
        state = p->state.at[n++];
        add_all_states(s, p, state);
        add_section_marks(s, section, state);
        s->state = state;
        for (int label = 0; label < AST_LABEL_COUNT; label++) {
            s->block = block_of[label];
            if (section->block[label].present)
                state->block_span[s->block] = section->block[label].label;
            check_stmts(s, &section->block[label].stmts, &state->block[s->block]);
            warn_of_unguarded_abort(s, state, section, (AstLabel)label);
        }
        add_state_allows(s, section, i + 1 < sm->sections.n ? sm->sections.at[i + 1]->header.at : sm->src->len);
    }
}

// ---- entry points ----

// Creates the state vector of a machine without a .sv: one region, whose elements its [state_vector] section declares.
static StateVec *new_own_state_vector(CheckContext *c, Program *p)
{
    StateVec *sv = ARENA_NEW(c->arena, StateVec);
    Region *r = ARENA_NEW(c->arena, Region);

    r->name = sv->name = p->name;
    r->span = (Span){p->src, 0, 0};
    sv->from_machine = true;
    sv->by_name.arena = c->arena;
    vec_push(c->arena, &sv->region, r);
    return sv;
}

// Builds the typed program of a machine; NULL if there were errors.  `sv` may be NULL: the machine's own [state_vector] section is then the
// whole vector.
Program *check_machine(CheckContext *c, const AstFile *sm, StateVec *sv, const Map *written_outside, const MachineInstance *instance)
{
    size_t errors = c->diags->errors_seen;
    Program *p = ARENA_NEW(c->arena, Program);
    Sema s;

    p->stem = sema_file_stem(c->strings, sm->src);
    p->name = instance && instance->name ? instance->name : p->stem;
    p->src = sm->src;
    p->by_name.arena = p->state_by_name.arena = c->arena;

    sema_init(&s, c, find_hidden_names(c, sm), p, &p->window);
    s.sv = sv;
    s.building = p;
    p->sv = sv ? sv : new_own_state_vector(c, p);
    check_time_options(&s, p, sm);
    add_states(&s, p, sm);
    check_declarations(&s, p, sm, p->sv, written_outside, instance);
    find_all_states(&s, p, sm);
    check_states(&s, p, sm);
    warn_of_skipped_all_states(&s, p);
    check_unused_definitions(&s, &p->define);
    if (!c->has_requirements)
        report_unused_definitions(c->diags, &p->define);
    p->has_units = s.has_units;
    check_size_uses(&s);
    propose_definitions(&s, sm);
    p->stmts = s.stmts;
    if (c->diags->errors_seen > errors)
        return NULL;
    if (!sv)
        layout_state_vector(p->sv);
    return p;
}
