// SPDX-License-Identifier: Apache-2.0
// The machines of one application together: an element has one writer, and the time and the state of each machine have one
// owner.
#include "compiler/analysis/analysis.h"

typedef struct Place { const Program *p; Span span; } Place;      // p is NULL: no machine

typedef struct Owners {           // of an element
    Place writer, state, time;    // the machine that assigns it; the machine whose S it is; whose G
} Owners;

typedef struct Together {
    Arena *arena;
    Diags *diags;
    Map by_name;                  // element to Owners
    const Program *p;             // the current machine
    Span *first;                  // by Var.index: its first assignment in p
} Together;

static void note_first(const Stmt *stmt, void *context)
{
    Together *t = context;
    Span *first = stmt->kind == ST_ASSIGN ? &t->first[stmt->var->index] : NULL;

    if (first && !first->src)
        *first = stmt->span;
}

static Owners *owners_of(Together *t, Str element)
{
    Owners *o = map_find(&t->by_name, element);

    if (!o) {
        o = ARENA_NEW(t->arena, Owners);
        map_put(&t->by_name, element, o);
    }
    return o;
}

// `at` does something to the element that belongs to `owner`.  An @allow at the owner's position covers it, too.
static void report(Together *t, DiagCode code, Place at, Str element, Place owner, DiagCode note)
{
    Diag *d = diag_report(t->diags, code, at.span, at.p->name->text, element->text, owner.p->name->text);

    diag_note(t->diags, d, owner.span, note, owner.p->name->text);
    diag_about(t->diags, d, DIAG_OTHER_WRITER, owner.span);
}

static bool is_other(Place place, const Program *p) { return place.p && place.p != p; }

static void take_state(Together *t, Owners *o, Place here, Str element)
{
    if (is_other(o->state, here.p))
        report(t, DIAG_two_states, here, element, o->state, DIAG_note_listed_there);
    else if (is_other(o->writer, here.p))
        report(t, DIAG_writes_state, o->writer, element, here, DIAG_note_listed_there);
    if (!o->state.p)
        o->state = here;
}

static void take_time(Together *t, Owners *o, Place here, Str element)
{
    if (is_other(o->writer, here.p))
        report(t, DIAG_writes_time, o->writer, element, here, DIAG_note_listed_there);
    if (!o->time.p)
        o->time = here;
}

static void take_write(Together *t, Owners *o, Place here, Str element)
{
    if (is_other(o->state, here.p))
        report(t, DIAG_writes_state, here, element, o->state, DIAG_note_listed_there);
    if (is_other(o->time, here.p))
        report(t, DIAG_writes_time, here, element, o->time, DIAG_note_listed_there);
    if (is_other(o->writer, here.p))
        report(t, DIAG_two_writers, here, element, o->writer, DIAG_note_written_there);
    if (!o->writer.p)
        o->writer = here;
}

static void look_at_var(Together *t, const Var *v)
{
    Owners *o = owners_of(t, v->element->name);
    const Place listed = {t->p, v->span}, written = {t->p, t->first[v->index]};

    if (v == t->p->s)
        take_state(t, o, listed, v->element->name);
    else if (v == t->p->g)
        take_time(t, o, listed, v->element->name);
    else if (written.span.src)
        take_write(t, o, written, v->element->name);
}

void analyse_together(Arena *arena, Diags *diags, const Program *const *p, size_t n)
{
    Together t = {.arena = arena, .diags = diags, .by_name = {.arena = arena}};

    for (size_t i = 0; i < n; i++) {
        t.p = p[i];
        t.first = ARENA_ARRAY(arena, Span, p[i]->var.n);
        each_stmt(p[i], note_first, &t);
        for (size_t v = 0; v < p[i]->var.n; v++)
            if (p[i]->var.at[v]->kind == VAR_ELEMENT)
                look_at_var(&t, p[i]->var.at[v]);
    }
}
