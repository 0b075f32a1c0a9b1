// SPDX-License-Identifier: Apache-2.0
// Reports conflicts over elements that several machines, or a machine and pins, share.  An element may have only one writer; the elements
// for the time (G) and the state (S) of a machine must not be written by others.  An input pin counts as a writer.
#include "compiler/analysis/analysis.h"

typedef struct SharedUse { const Program *p; Span span; } SharedUse;      // a use of an element by machine p; p NULL: no machine uses it so

typedef struct Owners {           // which machines use an element, and how
    SharedUse writer, state, time;    // the machine that assigns the element; the one whose S it is; the one whose G it is
} Owners;

typedef struct SharedVector {
    Arena *arena;
    Diags *diags;
    Map by_name;                  // from an element's name to its Owners
} SharedVector;

static void record_first_assignment(const Stmt *stmt, void *context)
{
    Span *first = context;

    if (stmt->kind == ST_ASSIGN && !first[stmt->var->index].src)
        first[stmt->var->index] = stmt->span;
}

// Returns for each variable (Var.index) its first assignment in the file; src is NULL if no statement assigns it.
static const Span *first_assignments(Arena *arena, const Program *p)
{
    Span *first = ARENA_ARRAY(arena, Span, p->var.n);

    each_stmt(p, record_first_assignment, first);
    return first;
}

// ---- several machines ----

static Owners *owners_of(SharedVector *t, Str element)
{
    Owners *o = map_find(&t->by_name, element);

    if (!o) {
        o = ARENA_NEW(t->arena, Owners);
        map_put(&t->by_name, element, o);
    }
    return o;
}

// Reports that a use of an element conflicts with the use `owner` by another machine.  An @allow at either position suppresses the finding.
static void report_conflict(SharedVector *t, DiagCode code, SharedUse use, Str element, SharedUse owner, DiagCode note)
{
    Diag *d = diag_report(t->diags, code, use.span, use.p->name->text, element->text, owner.p->name->text);

    diag_note(t->diags, d, owner.span, note, owner.p->name->text);
    diag_note_declaration(t->diags, d, DIAG_OTHER_WRITER, owner.span);
}

static bool is_used_by_other(SharedUse use, const Program *p) { return use.p && use.p != p; }

static void check_element(SharedVector *t, const Program *p, const Var *v, Span first_assignment)
{
    const Str element = v->element->name;
    Owners *o = owners_of(t, element);
    SharedUse use = {p, v->span}, *owner = NULL;

    if (v == p->s) {
        owner = &o->state;
        if (is_used_by_other(o->state, p))
            report_conflict(t, DIAG_two_states, use, element, o->state, DIAG_note_listed_there);
        else if (is_used_by_other(o->writer, p))
            report_conflict(t, DIAG_writes_state, o->writer, element, use, DIAG_note_listed_there);
    } else if (v == p->g) {
        owner = &o->time;
        if (is_used_by_other(o->writer, p))
            report_conflict(t, DIAG_writes_time, o->writer, element, use, DIAG_note_listed_there);
    } else if (first_assignment.src) {
        owner = &o->writer;
        use.span = first_assignment;
        if (is_used_by_other(o->state, p))
            report_conflict(t, DIAG_writes_state, use, element, o->state, DIAG_note_listed_there);
        if (is_used_by_other(o->time, p))
            report_conflict(t, DIAG_writes_time, use, element, o->time, DIAG_note_listed_there);
        if (is_used_by_other(o->writer, p))
            report_conflict(t, DIAG_two_writers, use, element, o->writer, DIAG_note_written_there);
    }
    if (owner && !owner->p)
        *owner = use;
}

void analyse_shared_vector(Arena *arena, Diags *diags, const Program *const *p, size_t n)
{
    SharedVector t = {.arena = arena, .diags = diags, .by_name = {.arena = arena}};

    for (size_t i = 0; i < n; i++) {
        const Span *first = first_assignments(arena, p[i]);
        for (size_t v = 0; v < p[i]->var.n; v++)
            if (p[i]->var.at[v]->kind == VAR_ELEMENT)
                check_element(&t, p[i], p[i]->var.at[v], first[v]);
    }
}

// ---- a machine and pins ----

// Returns the variable of p that is this element of the state vector; NULL: p does not list it. Each machine can have its own StateVec.
static const Var *find_variable(const Program *p, const Element *e)
{
    for (size_t v = 0; v < p->var.n; v++)
        if (p->var.at[v]->kind == VAR_ELEMENT && p->var.at[v]->element->name == e->name)
            return p->var.at[v];
    return NULL;
}

void analyse_shared_pins(Arena *arena, Diags *diags, const IoMap *io, const Program *p)
{
    const Span *first = first_assignments(arena, p);

    for (size_t i = 0; i < io->pin.n; i++) {
        const Pin *pin = &io->pin.at[i];
        const char *element = pin->element->name->text, *machine = p->name->text;
        const Var *v = pin_is_output(pin) ? NULL : find_variable(p, pin->element);
        Diag *d;
        if (!v)
            continue;
        if (v == p->g || v == p->s) {
            d = diag_report(diags, v == p->g ? DIAG_input_of_time : DIAG_input_of_state, pin->span, element, machine);
            diag_note(diags, d, v->span, DIAG_note_listed_there, machine);
        } else if (first[v->index].src) {
            d = diag_report(diags, DIAG_input_of_written, pin->span, machine, element);
            diag_note(diags, d, first[v->index], DIAG_note_written_there, machine);
        }
    }
}
