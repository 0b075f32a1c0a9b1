// SPDX-License-Identifier: Apache-2.0
// A machine and the pins of its elements: an element has one writer, and an input pin is a writer.
#include "compiler/analysis/analysis.h"

typedef struct Beside {
    Diags *diags;
    const Program *p;
    Span *first;                  // by Var.index: its first assignment in p
} Beside;

static void note_first(const Stmt *stmt, void *context)
{
    Beside *b = context;
    Span *first = stmt->kind == ST_ASSIGN ? &b->first[stmt->var->index] : NULL;

    if (first && !first->src)
        *first = stmt->span;
}

static const Var *var_of(const Program *p, Str element)
{
    const Var *v = map_find(&p->by_name, element);            // or the variable with this alias

    return v && v->kind == VAR_ELEMENT && v->element->name == element ? v : NULL;
}

static void look_at_input(const Beside *b, const Pin *pin)
{
    const Var *v = var_of(b->p, pin->element->name);
    const char *element = pin->element->name->text, *machine = b->p->name->text;
    Diag *d;

    if (!v)
        return;
    if (v == b->p->g || v == b->p->s) {
        d = diag_report(b->diags, v == b->p->g ? DIAG_input_of_time : DIAG_input_of_state, pin->span, element, machine);
        diag_note(b->diags, d, v->span, DIAG_note_listed_there, machine);
    } else if (b->first[v->index].src) {
        d = diag_report(b->diags, DIAG_input_of_written, pin->span, machine, element);
        diag_note(b->diags, d, b->first[v->index], DIAG_note_written_there, machine);
    }
}

void analyse_pins(Arena *arena, Diags *diags, const IoMap *io, const Program *p)
{
    Beside b = {diags, p, ARENA_ARRAY(arena, Span, p->var.n)};

    each_stmt(p, note_first, &b);
    for (size_t i = 0; i < io->pin.n; i++)
        if (!pin_is_output(&io->pin.at[i]))
            look_at_input(&b, &io->pin.at[i]);
}
