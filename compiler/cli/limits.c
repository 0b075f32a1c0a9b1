// SPDX-License-Identifier: Apache-2.0
// --step, and --max-ram, --max-step and --max-cycles: a machine that needs more than a board has is an error, reported when it is built.
#include "compiler/budget/cost.h"
#include "compiler/cli/cli.h"

#include <string.h>

enum { LINES_SHOWN = 3 };             // of the longest step: the most expensive ones

// Returns a whole number from 1; 0 if the text is not one.
static uint32_t number_in(const char *text)
{
    uint32_t n = 0;

    for (; *text >= '0' && *text <= '9'; text++) {
        if (n > (UINT32_MAX - 9) / 10)
            return 0;
        n = n * 10 + (uint32_t)(*text - '0');
    }
    return *text ? 0 : n;
}

static bool limit_is_number(Cli *c, OptionId id, const char *spelling)
{
    if (!c->given[id] || number_in(c->value[id]) != 0)
        return true;
    cli_usage(c, "%s wants a whole number from 1, not '%s'", spelling, c->value[id]);
    return false;
}

bool step_known(Cli *c)
{
    if (c->given[OPT_STEP])
        c->session.step = number_in(c->value[OPT_STEP]);
    return limit_is_number(c, OPT_STEP, "--step");
}

bool limits_known(Cli *c)
{
    return step_known(c) && limit_is_number(c, OPT_MAX_RAM, "--max-ram") && limit_is_number(c, OPT_MAX_STEP, "--max-step")
        && limit_is_number(c, OPT_MAX_CYCLES, "--max-cycles");
}

bool limits_given(const Cli *c) { return c->given[OPT_MAX_RAM] || c->given[OPT_MAX_STEP] || c->given[OPT_MAX_CYCLES]; }

static const char *number_text(Cli *c, uint32_t n) { return format_in(&c->session.arena, "%lu", (unsigned long)n); }

// ---- RAM ----

static const CostWindow *largest_window(const Cost *cost)
{
    const CostWindow *most = NULL;

    for (uint32_t w = 0; w < cost->window_count; w++)
        if (!most || cost->window[w].bytes > most->bytes)
            most = &cost->window[w];
    return most;
}

// Returns where a window of that size is used; without one, the start of the machine.
static Span place_of_window(const Program *p, const CostWindow *w)
{
    for (size_t i = 0; w && i < p->window.n; i++)
        if (p->window.at[i].size == w->size)
            return p->window.at[i].span;
    return (Span){p->src, 0, 0};
}

static void check_ram(Cli *c, const Program *p, const Cost *cost, uint32_t most)
{
    const CostWindow *w = largest_window(cost);
    Diags *d = &c->session.diags;
    Diag *diag;

    if (cost->ram <= most)
        return;
    diag = diag_report(d, DIAG_limit_ram, place_of_window(p, w), p->name->text, number_text(c, cost->ram), number_text(c, most));
    if (w)
        diag_label(d, diag, DIAG_label_largest_window, number_text(c, w->size), number_text(c, w->bytes));
    diag_note(d, diag, (Span){NULL, 0, 0}, DIAG_note_ram_parts, number_text(c, cost->windows),
              number_text(c, cost->locals), number_text(c, cost->own));
}

// ---- the longest step ----

static Span span_of_line(const Source *src, uint32_t line)
{
    uint32_t len, at = src->line[line - 1], skip = 0;
    const char *text = source_line(src, line, &len);

    while (skip < len && (text[skip] == ' ' || text[skip] == '\t'))
        skip++;
    return (Span){src, at + skip, 0};
}

static void note_lines(Cli *c, const Program *p, const StateCost *s, Diag *diag)
{
    const CostLine *l = NULL;

    for (int i = 0; i < LINES_SHOWN && (l = cost_next_dearest(s, l)) != NULL; i++)
        diag_note(&c->session.diags, diag, span_of_line(p->src, l->line),
                  l->part == COST_SAMPLE ? DIAG_note_line_samples : DIAG_note_line_takes, number_text(c, l->units));
}

static void check_step(Cli *c, const Program *p, const Cost *cost, DiagCode code, uint32_t most)
{
    const State *state = p->state.at[cost->worst_state - 1];
    Diag *diag;

    if (cost->worst <= most)
        return;
    diag = diag_report(&c->session.diags, code, state->span, p->name->text, state->name->text, number_text(c, cost->worst),
                       number_text(c, most));
    note_lines(c, p, &cost->state[cost->worst_state - 1], diag);
}

// ---- all ----

void limits_check(Cli *c, const Program *p, IrMachine *m)
{
    const ImageOptions with_lines = {true, NULL};
    Cost cost;
    Buf image;

    buf_init(&image, &c->session.arena);
    if (!session_image(&c->session, &m, 1, &with_lines, &image))
        return;
    cost_of_machine(&c->session.arena, (const uint8_t *)image.at, 0, COST_INSTRUCTIONS, &cost);
    if (c->given[OPT_MAX_RAM])
        check_ram(c, p, &cost, number_in(c->value[OPT_MAX_RAM]));
    if (c->given[OPT_MAX_STEP])
        check_step(c, p, &cost, DIAG_limit_step, number_in(c->value[OPT_MAX_STEP]));
    if (!c->given[OPT_MAX_CYCLES])
        return;
    cost_of_machine(&c->session.arena, (const uint8_t *)image.at, 0, COST_CYCLES_EEPROM, &cost);
    check_step(c, p, &cost, DIAG_limit_cycles, number_in(c->value[OPT_MAX_CYCLES]));
}
