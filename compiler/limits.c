// SPDX-License-Identifier: Apache-2.0
#include "compiler/limits.h"

#include "compiler/budget/cost.h"
#include "compiler/base/str.h"

enum { LINES_SHOWN = 3 };             // how many of the most expensive lines of the longest step a diagnostic shows

typedef struct LimitCheck {
    Arena *arena;
    Diags *diags;
    const Program *p;
} LimitCheck;

static const char *count_text(const LimitCheck *x, uint32_t n) { return format_in(x->arena, "%lu", (unsigned long)n); }

// ---- RAM ----

// Returns the window that takes the most bytes; NULL if the machine has no windows.
static const CostWindow *largest_window(const Cost *cost)
{
    const CostWindow *most = NULL;

    for (uint32_t w = 0; w < cost->window_count; w++)
        if (!most || cost->window[w].bytes > most->bytes)
            most = &cost->window[w];
    return most;
}

// Returns the position of a roll call whose window has the size of w; the start of the file if w is NULL.
static Span span_of_window(const Program *p, const CostWindow *w)
{
    for (size_t i = 0; w && i < p->window.n; i++)
        if (p->window.at[i].size == w->size)
            return p->window.at[i].span;
    return (Span){p->src, 0, 0};
}

static void check_ram(const LimitCheck *x, const Cost *cost, uint32_t most)
{
    const CostWindow *w = largest_window(cost);
    Diag *diag;

    if (most == 0 || cost->ram <= most)
        return;
    diag = diag_report(x->diags, DIAG_limit_ram, span_of_window(x->p, w), x->p->name->text, count_text(x, cost->ram), count_text(x, most));
    if (w)
        diag_label(x->diags, diag, DIAG_label_largest_window, count_text(x, w->size), count_text(x, w->bytes));
    diag_note(x->diags, diag, (Span){NULL, 0, 0}, DIAG_note_ram_parts, count_text(x, cost->windows), count_text(x, cost->locals),
              count_text(x, cost->own));
}

// ---- the longest step ----

// Returns the position of the first character of a line that is not whitespace.
static Span span_of_line(const Source *src, uint32_t line)
{
    uint32_t len, at = src->line[line - 1], skip = 0;
    const char *text = source_line(src, line, &len);

    while (skip < len && is_space_or_tab(text[skip]))
        skip++;
    return (Span){src, at + skip, 0};
}

static void check_step(const LimitCheck *x, const Cost *cost, DiagCode code, uint32_t most)
{
    const State *state = x->p->state.at[cost->worst_state - 1];
    const CostLine *l = NULL;
    Diag *diag;

    if (most == 0 || cost->worst <= most)
        return;
    diag = diag_report(x->diags, code, state->span, x->p->name->text, state->name->text, count_text(x, cost->worst), count_text(x, most));
    for (int i = 0; i < LINES_SHOWN && (l = cost_next_most_expensive(&cost->state[cost->worst_state - 1], l)) != NULL; i++)
        diag_note(x->diags, diag, span_of_line(x->p->src, l->line), l->part == COST_SAMPLE ? DIAG_note_line_samples : DIAG_note_line_takes,
                  count_text(x, l->units));
}

// ---- a board ----

// Reports a call of a function that the board lacks.
static void check_call(const LimitCheck *x, const IrIns *i, const Board *b)
{
    const char *name = ir_op_info[i->op].name, *others;
    Diag *d;

    if (!ir_is_elementary(i->op) || board_has_function(b, name))
        return;
    d = diag_report(x->diags, DIAG_limit_function, i->span, name, x->p->name->text, b->mcu, b->name);
    others = board_list_with_function(x->arena, name);
    if (others)
        diag_label(x->diags, d, DIAG_label_board_has_function, others);
}

// Checks whether the board's firmware has every builtin function that f calls; NULL: f has no code.
static void check_builtin_calls(const LimitCheck *x, const IrFn *f, const Board *b)
{
    for (size_t k = 0; f && k < f->blk.n; k++)
        for (size_t i = 0; i < f->blk.at[k].ins.n; i++)
            check_call(x, &f->ins.at[f->blk.at[k].ins.at[i]], b);
}

static void check_board_bytes(const LimitCheck *x, const char *what, uint32_t needed, uint32_t room, const Board *b)
{
    if (needed > room)
        diag_report(x->diags, DIAG_limit_board, (Span){x->p->src, 0, 0}, x->p->name->text, count_text(x, needed), what, b->mcu, b->name,
                    count_text(x, room));
}

static uint32_t ram_of_pins(const IoMap *pins, const Board *b)
{
    uint32_t n = 0;

    for (size_t i = 0; pins && i < pins->pin.n; i++)
        n += pin_is_digital(&pins->pin.at[i]) ? b->digital : b->analog;
    return n;
}

static void check_board(const LimitCheck *x, const LimitSubject *m, const Cost *cost, const Board *b)
{
    check_builtin_calls(x, m->ir->sample, b);
    for (size_t i = 0; i < m->ir->state.n; i++)
        for (int k = 0; k < BLOCK_COUNT; k++)
            check_builtin_calls(x, m->ir->state.at[i].block[k], b);
    check_board_bytes(x, "for its image", m->length, b->image, b);
    check_board_bytes(x, "of RAM", m->p->sv->size + cost->locals + cost->windows_small + ram_of_pins(m->pins, b), b->ram, b);
}

// ---- all ----

void limits_check(Arena *arena, Diags *d, const LimitSubject *m, const CompileLimits *l)
{
    const LimitCheck x = {arena, d, m->p};
    Cost cost;

    cost_of_machine(arena, m->image, 0, COST_INSTRUCTIONS, &cost);
    check_ram(&x, &cost, l->ram);
    check_step(&x, &cost, DIAG_limit_step, l->step);
    if (l->board)
        check_board(&x, m, &cost, l->board);
    if (l->cycles == 0)
        return;
    cost_of_machine(arena, m->image, 0, COST_CYCLES_EEPROM, &cost);
    check_step(&x, &cost, DIAG_limit_cycles, l->cycles);
}

// Reports that the limits cannot be judged for a machine, because an application compiles it to C.
void limits_report_c(Diags *d, const Program *p)
{
    diag_report(d, DIAG_limit_of_c, span_of_window(p, NULL), p->name->text);
}
