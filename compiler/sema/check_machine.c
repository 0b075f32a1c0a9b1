// SPDX-License-Identifier: Apache-2.0
// Checks a machine file and builds a Program: numbers its states, declares its variables, checks its blocks.
#include "compiler/sema/sema.h"

// ---- states ----

static void report_state_twice(Sema *s, const State *first, const AstSection *section)
{
    Diag *d = diag_report(s->diags, DIAG_state_twice, section->name_span, section->name->text);

    diag_note(s->diags, d, first->span, DIAG_note_declared_here, first->name->text);
}

static void add_state(Sema *s, Program *p, const AstSection *section)
{
    State *state = ARENA_NEW(s->arena, State);
    const State *first = map_find(&p->state_by_name, section->name);

    state->name = section->name;
    state->span = section->name_span;
    state->is_abort = has_annotation(&section->annotations, AST_ABORT);
    state->is_safe = has_annotation(&section->annotations, AST_SAFE);
    state->number = (uint32_t)p->state.n + 1;
    vec_push(s->arena, &p->state, state);
    if (state->name->len == 0)
        return;                   // the parser could not read its header
    if (first)
        report_state_twice(s, first, section);
    else
        map_put(&p->state_by_name, state->name, state);
}

static void add_states(Sema *s, Program *p, const AstFile *sm)
{
    for (size_t i = 0; i < sm->sections.n; i++)
        if (sm->sections.at[i]->kind == AST_STATE)
            add_state(s, p, sm->sections.at[i]);
    if (p->state.n == 0 && !s->lost->sections)
        diag_report(s->diags, DIAG_no_state, (Span){p->src, 0, 0});
}

// ---- blocks ----

static void check_state(Sema *s, State *state, const AstSection *section)
{
    static const BlockKind block_of[AST_LABEL_COUNT] = {[AST_ENTRY] = BLOCK_ENTRY, [AST_STEP] = BLOCK_STEP, [AST_EXIT] = BLOCK_EXIT};

    for (int i = 0; i < AST_LABEL_COUNT; i++) {
        s->block = block_of[i];
        state->block_span[s->block] = section->block[i].label;
        check_stmts(s, &section->block[i].stmts, &state->block[s->block]);
        warn_of_unguarded_abort(s, state, section, (AstLabel)i);
    }
}

static uint32_t end_of_section(const AstFile *sm, size_t i)
{
    return i + 1 < sm->sections.n ? sm->sections.at[i + 1]->header.at : sm->src->len;
}

static void check_states(Sema *s, Program *p, const AstFile *sm)
{
    size_t state = 0;

    for (size_t i = 0; i < sm->sections.n; i++)
        if (sm->sections.at[i]->kind == AST_STATE) {
            check_state(s, p->state.at[state++], sm->sections.at[i]);
            add_state_allows(s, sm->sections.at[i], end_of_section(sm, i));
        }
}

// ---- entry points ----

// Creates the state vector of a machine without a .sv: its [state_vector] section.
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

static Program *new_program(CheckContext *c, const AstFile *sm)
{
    Program *p = ARENA_NEW(c->arena, Program);

    p->name = sema_stem(c->strings, sm->src);
    p->src = sm->src;
    p->by_name.arena = p->state_by_name.arena = c->arena;
    return p;
}

Program *check_machine(CheckContext *c, const AstFile *sm, StateVec *sv, const Map *written_outside)
{
    size_t errors = c->diags->met;
    Program *p = new_program(c, sm);
    Sema s;

    sema_init(&s, c, find_hidden_names(c, sm), p, &p->window);
    s.sv = sv;
    s.building = p;
    p->sv = sv ? sv : new_own_state_vector(c, p);
    add_states(&s, p, sm);
    check_declarations(&s, p, sm, p->sv, written_outside);
    check_states(&s, p, sm);
    check_size_uses(&s);
    p->stmts = s.stmts;
    if (c->diags->met > errors)
        return NULL;
    if (!sv)
        layout_state_vector(p->sv);
    return p;
}
