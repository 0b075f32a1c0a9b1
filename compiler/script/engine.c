// SPDX-License-Identifier: Apache-2.0
// Allocates and compares the results of engines that run the same script in lock step.
#include "compiler/script/engine.h"

#include <inttypes.h>

#include "compiler/base/buf.h"
#include "compiler/script/script.h"

// Allocates the result of an engine that runs p.
void engine_step_init(EngineStep *s, Arena *arena, const Program *p)
{
    s->status = ENGINE_OK;
    s->next_state = 0;
    s->next_is_first = true;
    s->machine = p->joint ? ARENA_ARRAY(arena, EngineNext, engine_machines(p)) : NULL;
    s->cell = ARENA_ARRAY(arena, uint64_t, p->var.n);
    s->stored = arena_alloc(arena, p->var.n);
}

// Returns the status as the predicate of a sentence about a step.
static const char *status_text(EngineStatus s)
{
    switch (s) {
    case ENGINE_OK: return "ran it";
    case ENGINE_REFUSED: return "refused it";
    case ENGINE_BROKEN: return "failed";
    }
    return "?";
}

static const char *state_text(const Program *p, uint32_t number)
{
    return number >= 1 && number <= p->state.n ? p->state.at[number - 1]->name->text : "(no state)";
}

// Appends `ENGINE has VALUE (bits …)`.
static void append_value(Buf *b, const Engine *e, SmType type, uint64_t cell)
{
    buf_printf(b, "%s has ", e->name);
    format_cell_shortest(b, type, cell);
    buf_printf(b, " (bits 0x%0*" PRIx64 ")", sm_type_info[type].bytes * 2, cell);
}

// Returns NULL if two engines gave bit-identical results; otherwise a sentence in `arena` that names the first difference.
const char *engine_compare(Arena *arena, const Engine *a, const EngineStep *of_a, const Engine *b, const EngineStep *of_b)
{
    const Program *p = a->program;

    if (of_a->status != of_b->status)
        return format_in(arena, "%s %s, %s %s", a->name, status_text(of_a->status), b->name, status_text(of_b->status));
    for (size_t i = 0; i < p->var.n; i++)
        if (of_a->cell[i] != of_b->cell[i]) {
            const Var *v = p->var.at[i];
            Buf text;
            buf_init(&text, arena);
            buf_printf(&text, "%s: ", v->report_name->text);
            append_value(&text, a, v->type, of_a->cell[i]);
            buf_str(&text, ", ");
            append_value(&text, b, v->type, of_b->cell[i]);
            return buf_text(&text);
        }
    for (size_t i = 0; i < engine_machines(p); i++) {
        const EngineNext x = engine_next(of_a, i), y = engine_next(of_b, i);
        if (x.state != y.state)
            return format_in(arena, "next state: %s goes to %s, %s to %s", a->name, state_text(p, x.state), b->name, state_text(p, y.state));
        if (x.is_first != y.is_first)
            return format_in(arena, "%s makes a transition in this step, %s does not", x.is_first ? a->name : b->name,
                             x.is_first ? b->name : a->name);
    }
    for (size_t i = 0; i < p->var.n; i++)
        if (p->var.at[i]->kind == VAR_ELEMENT && !of_a->stored[i] != !of_b->stored[i])
            return format_in(arena, "%s: %s stored it in this step, %s did not", p->var.at[i]->report_name->text,
                             of_a->stored[i] ? a->name : b->name, of_a->stored[i] ? b->name : a->name);
    return NULL;
}
